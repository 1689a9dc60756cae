/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The data of interpolation by Tschirnhausen cubics: what the fields of a
 * problem say, checked, with what is absent filled in by its rule, at unit
 * scale (a power of two).
 */
#ifndef PH_SOLVE_TC_DATA_H
#define PH_SOLVE_TC_DATA_H

#include "base/diag.h"
#include "base/mem.h"
#include "curve/problem.h"
#include "kernel/pow2.h"
#include "solve/tc/fit.h"

enum ph_tc_mode {
  PH_TC_G1,
  PH_TC_G1_PAIR,
  PH_TC_G1_AUTO,
  PH_TC_G1_FAIR,
  PH_TC_C1,
  PH_TC_SPLINE,
  PH_TC_APPROXIMATE
};

enum ph_tc_choice { PH_TC_BEST, PH_TC_STANDARD, PH_TC_ALL };

struct ph_tc_data {
  enum ph_tc_mode mode;
  enum ph_tc_choice choice;
  size_t n;             /* intervals */
  size_t points_n;      /* n if closed, else n + 1 */
  const double *points; /* [points_n][2], the user's */
  bool closed;
  bool c1;               /* vectors are derivatives, else unit tangents */
  bool on_chord;         /* joints are */
  double joint_angle;    /* NaN: to be chosen */
  double joint_position; /* NaN: to be chosen */
  double lambda;         /* NaN: to be chosen, or derivatives are given */
  int exponent;          /* unit scale = data times 2^exponent; even */
  struct ph_pow2 to_unit;
  ph_cplx *vector; /* [points_n] */
  double *chord;   /* [n] lengths at unit scale */
};

/* PH_TC_LAMBDA: what the field lambda is where it is absent and needed. */
#define PH_TC_LAMBDA 0.5

/* ph_tc_mode_of: the mode that a problem says or implies; what fields it must
 * not have together.
 *
 * ret  PH_OK | PH_BAD_VALUE | PH_MISSING_FIELD */
enum ph_status ph_tc_mode_of(const struct ph_problem *problem,
                             enum ph_tc_mode *mode, struct ph_diag *diag);

/*
 * ph_tc_data_of: reads and checks a problem of a mode that interpolates.
 *
 * ret  PH_OK | PH_MISSING_FIELD | PH_TOO_FEW_POINTS | PH_COINCIDENT_POINTS |
 *      PH_BAD_SHAPE | PH_BAD_VALUE | PH_ZERO_TANGENT | PH_TOO_LARGE |
 *      PH_INFEASIBLE (points that turn back have no bisector) | PH_NO_MEMORY
 */
enum ph_status ph_tc_data_of(const struct ph_problem *problem,
                             enum ph_tc_mode mode, struct ph_arena *arena,
                             struct ph_tc_data *data, struct ph_diag *diag);

/* ph_tc_point: point k, 0 <= k <= n, of the user. */
static inline ph_cplx ph_tc_point(const struct ph_tc_data *d, size_t k) {
  size_t i = k < d->points_n ? k : 0;
  return ph_cplx_of(d->points[2 * i], d->points[2 * i + 1]);
}

/* ph_tc_chord: from point k to point k + 1, at unit scale. */
ph_cplx ph_tc_chord(const struct ph_tc_data *d, size_t k);

/* ph_tc_root: the principal square root of that chord. */
ph_cplx ph_tc_root(const struct ph_tc_data *d, size_t k);

/* ph_tc_hermite_of: the vectors of interval k over its chord, snapped. */
struct ph_tc_hermite ph_tc_hermite_of(const struct ph_tc_data *d, size_t k);

#endif
