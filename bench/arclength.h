/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The data of [HUA14] on which solvers of its problem are compared. */
#ifndef PH_BENCH_ARCLENGTH_H
#define PH_BENCH_ARCLENGTH_H

#include "bench.h"

#include <complex.h>
#include <string.h>

/* Points and lengths of n intervals. */
struct bench_arc {
  size_t n;
  double *points;  /* [n + 1][3] */
  double *lengths; /* [n] */
};

/* The kinds of data. */
static const char *const bench_arc_kinds[] = {"helix", "screw"};
static const size_t bench_arc_sizes[] = {5, 6, 20};
enum { BENCH_ARC_KINDS = 2, BENCH_ARC_SIZES = 3 };

/* Points on (cos 2t, sin 2t, 0.3 t), 0.5 apart by t, and exact lengths. */
static inline void bench_arc_helix(struct bench_arc *data) {
  for (size_t i = 0; i <= data->n; i++) {
    double *p = data->points + 3 * i;
    p[0] = cos((double)i);
    p[1] = sin((double)i);
    p[2] = 0.15 * (double)i;
  }
  for (size_t i = 0; i < data->n; i++) {
    data->lengths[i] = 0.5 * sqrt(4.09);
  }
}

/*
 * Of the spline with a_j = 0.8 e^(0.5 i j), b_j = 0.6 e^(-0.3 i j) on uniform
 * knots: they have a solution.  Its Gram matrix is that of [HUA14, (15)].
 */
static inline void bench_arc_screw(struct bench_arc *data) {
  static const double gram[3][3] = {{6, 13, 1}, {13, 54, 13}, {1, 13, 6}};
  memset(data->points, 0, 3 * sizeof *data->points);
  for (size_t i = 0; i < data->n; i++) {
    double aa = 0, bb = 0;
    const double *from = data->points + 3 * i;
    double complex ab = 0;
    for (size_t j = 0; j < 3; j++) {
      for (size_t k = 0; k < 3; k++) {
        double turn = 0.5 * ((double)j - (double)k), both;
        aa += gram[j][k] * 0.64 * cos(turn);
        bb += gram[j][k] * 0.36 * cos(0.6 * turn);
        both = 0.5 * (double)(i + j) + 0.3 * (double)(i + k);
        ab += gram[j][k] * 0.48 * (cos(both) + (double complex)I * sin(both));
      }
    }
    data->points[3 * i + 3] = from[0] + (aa - bb) / 120;
    data->points[3 * i + 4] = from[1] + creal(ab) / 60;
    data->points[3 * i + 5] = from[2] + cimag(ab) / 60;
    data->lengths[i] = (aa + bb) / 120;
  }
}

/* bench_arc_of: data of a kind; the caller frees them. */
static inline struct bench_arc bench_arc_of(size_t kind, size_t n) {
  struct bench_arc data = {n, bench_malloc(n + 1, 3 * sizeof(double)),
                           bench_malloc(n, sizeof(double))};
  if (kind == 0) {
    bench_arc_helix(&data);
  } else {
    bench_arc_screw(&data);
  }
  return data;
}

static inline void bench_arc_free(struct bench_arc *data) {
  free(data->points);
  free(data->lengths);
}

#endif
