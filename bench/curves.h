/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Smooth curves in space, samples of them with exact lengths, and how far
 * another curve is from them.
 */
#ifndef PH_BENCH_CURVES_H
#define PH_BENCH_CURVES_H

#include "bench.h"

#include "kernel/quad.h"
#include "kernel/vec3.h"

struct bench_curve {
  const char *name;
  /* the point and the derivative at t; v: what the family needs */
  void (*at)(const double *v, double t, ph_vec3 *point, ph_vec3 *derivative);
  double to; /* t from 0 */
  double v[6];
};

static inline void bench_curve_helix(const double *v, double t, ph_vec3 *point,
                                     ph_vec3 *derivative) {
  (void)v;
  *point = ph_vec3_of(cos(2 * t), sin(2 * t), 0.3 * t);
  *derivative = ph_vec3_of(-2 * sin(2 * t), 2 * cos(2 * t), 0.3);
}

static inline void bench_curve_screw(const double *v, double t, ph_vec3 *point,
                                     ph_vec3 *derivative) {
  double r = 1 + 0.3 * cos(0.7 * t), slope = -0.21 * sin(0.7 * t);
  (void)v;
  *point = ph_vec3_of(r * cos(t), r * sin(t), 0.5 * t);
  *derivative =
      ph_vec3_of(slope * cos(t) - r * sin(t), slope * sin(t) + r * cos(t), 0.5);
}

static inline void bench_curve_sine(const double *v, double t, ph_vec3 *point,
                                    ph_vec3 *derivative) {
  (void)v;
  *point = ph_vec3_of(t, sin(t), 0);
  *derivative = ph_vec3_of(1, cos(t), 0);
}

/* An ellipse of v[0], v[1] from angle v[2], rising, with waves of twice its
 * frequency and amplitudes v[3] to v[5]. */
static inline void bench_curve_smooth(const double *v, double t, ph_vec3 *point,
                                      ph_vec3 *derivative) {
  *point = ph_vec3_of(v[0] * cos(t + v[2]) + v[3] * cos(2 * t),
                      v[1] * sin(t + v[2]) + v[4] * sin(2 * t + 1),
                      0.5 * t + v[5] * sin(2 * t));
  *derivative = ph_vec3_of(-v[0] * sin(t + v[2]) - 2 * v[3] * sin(2 * t),
                           v[1] * cos(t + v[2]) + 2 * v[4] * cos(2 * t + 1),
                           0.5 + 2 * v[5] * cos(2 * t));
}

static const struct bench_curve bench_curves[] = {
    {"helix", bench_curve_helix, 6, {0}},
    {"screw", bench_curve_screw, 6, {0}},
    {"smooth1",
     bench_curve_smooth,
     10,
     {0.5559108123501284, 0.7752318481629676, 5.957518528021891,
      0.06554051876408837, 0.009918737534611893, 0.05070262173496132}},
    {"smooth2",
     bench_curve_smooth,
     10,
     {0.4308060671246582, 0.44924557170706164, 0.5772321166084086,
      -0.062419785326679314, -0.04500612641879238, 0.0124531325560856}},
    {"smooth3",
     bench_curve_smooth,
     10,
     {0.34282458357181217, 0.41840525329804984, 3.6559775864842297,
      -0.0041897403718332005, 0.04691543028184292, -0.02175436190086759}},
    {"sine", bench_curve_sine, 3.141592653589793, {0}}};
enum { BENCH_CURVES = sizeof bench_curves / sizeof bench_curves[0] };

/* bench_curve_random: another curve of the smooth family. */
static inline struct bench_curve bench_curve_random(uint64_t *state) {
  static const double low[6] = {0.3, 0.3, 0, -0.1, -0.1, -0.1};
  static const double high[6] = {0.8, 0.8, 6.28, 0.1, 0.1, 0.1};
  struct bench_curve curve = {"random", bench_curve_smooth, 10, {0}};
  for (size_t i = 0; i < 6; i++) {
    double u = (double)(bench_random(state) >> 11) * 0x1p-53;
    curve.v[i] = low[i] + (high[i] - low[i]) * u;
  }
  return curve;
}

/* Data of n intervals, taken from a curve. */
struct bench_sample {
  struct bench_curve curve;
  size_t n;
  double *t;        /* [n + 1] */
  double *points;   /* [n + 1][3] */
  double *tangents; /* [n + 1][3], of length 1 */
  double *lengths;  /* [n], exact */
};

/* The length from a to b by Gauss's rule on so many parts of the interval. */
static inline double bench_curve_length(const struct bench_curve *curve,
                                        const struct ph_quad *rule, int parts,
                                        double a, double b) {
  double sum = 0, h = (b - a) / parts;
  for (int part = 0; part < parts; part++) {
    for (size_t i = 0; i < rule->n; i++) {
      ph_vec3 p, d;
      curve->at(curve->v, a + h * (part + rule->node[i]), &p, &d);
      sum += rule->weight[i] * ph_vec3_abs(d);
    }
  }
  return h * sum;
}

/* Moves the inner t so that all intervals have nearly the same length. */
static inline void bench_sample_even(struct bench_sample *s,
                                     const struct ph_quad *rule) {
  double *old = bench_malloc(2 * s->n + 2, sizeof *old);
  double *upto = old + s->n + 1;
  for (int round = 0; round < 20; round++) {
    size_t k = 0;
    memcpy(old, s->t, (s->n + 1) * sizeof *old);
    for (size_t i = 0; i < s->n; i++) {
      upto[i + 1] =
          upto[i] + bench_curve_length(&s->curve, rule, 1, old[i], old[i + 1]);
    }
    for (size_t i = 1; i < s->n; i++) {
      double want = upto[s->n] * (double)i / (double)s->n;
      while (upto[k + 1] < want) {
        k++;
      }
      s->t[i] = old[k] + (old[k + 1] - old[k]) * (want - upto[k]) /
                             (upto[k + 1] - upto[k]);
    }
  }
  free(old);
}

/* bench_sample_of: n intervals, even by length or by t. */
static inline struct bench_sample
bench_sample_of(const struct bench_curve *curve, size_t n, bool even) {
  struct bench_sample s = {*curve, n, NULL, NULL, NULL, NULL};
  struct ph_quad rough, fine;
  if (!ph_quad_gauss(&rough, 8) || !ph_quad_gauss(&fine, PH_QUAD_MAX)) {
    bench_die("out of memory");
  }
  s.t = bench_malloc(n + 1, sizeof *s.t);
  s.points = bench_malloc(n + 1, 3 * sizeof *s.points);
  s.tangents = bench_malloc(n + 1, 3 * sizeof *s.tangents);
  s.lengths = bench_malloc(n, sizeof *s.lengths);
  for (size_t i = 0; i <= n; i++) {
    s.t[i] = curve->to * (double)i / (double)n;
  }
  if (even) {
    bench_sample_even(&s, &rough);
  }
  for (size_t i = 0; i <= n; i++) {
    ph_vec3 p, d;
    curve->at(curve->v, s.t[i], &p, &d);
    ph_vec3_put(p, 3, s.points + 3 * i);
    ph_vec3_put(ph_vec3_unit(d), 3, s.tangents + 3 * i);
  }
  for (size_t i = 0; i < n; i++) {
    s.lengths[i] =
        bench_curve_length(curve, &fine, n < 100 ? 8 : 1, s.t[i], s.t[i + 1]);
  }
  return s;
}

static inline void bench_sample_free(struct bench_sample *s) {
  free(s->t);
  free(s->points);
  free(s->tangents);
  free(s->lengths);
}

/* bench_curve_distance: of a point from the curve, whose nearest parameter is
 * about t. */
static inline double bench_curve_distance(const struct bench_curve *curve,
                                          ph_vec3 q, double t) {
  ph_vec3 p, d, away = q;
  for (int round = 0; round < 8; round++) {
    curve->at(curve->v, t, &p, &d);
    away = ph_vec3_sub(q, p);
    t += ph_vec3_dot(away, d) / ph_vec3_dot(d, d);
  }
  curve->at(curve->v, t, &p, &d);
  return ph_vec3_abs(ph_vec3_sub(q, p));
}

#endif
