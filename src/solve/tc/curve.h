/* SPDX-License-Identifier: GPL-3.0-or-later */
/* From fits of intervals (tc_fit.h) to a curve of Tschirnhausen cubics. */
#ifndef PH_SOLVE_TC_CURVE_H
#define PH_SOLVE_TC_CURVE_H

#include "base/sum.h"
#include "solve/tc/data.h"

/* A curve that grows by intervals. */
struct ph_tc_builder {
  const struct ph_tc_data *data;
  struct ph_curve *curve;
  struct ph_interval *intervals; /* [data->n] */
  size_t done;                   /* intervals */
  struct ph_sum length;
  double residual; /* the largest misfit of an end / length of the interval */
};

/*
 * ph_tc_build_begin: the arrays of a curve, empty yet.
 *
 * ret  PH_OK | PH_NO_MEMORY
 */
enum ph_status ph_tc_build_begin(struct ph_tc_builder *builder,
                                 const struct ph_tc_data *data,
                                 struct ph_arena *arena, struct ph_curve *curve,
                                 struct ph_diag *diag);

/* ph_tc_build_add: the next interval. */
void ph_tc_build_add(struct ph_tc_builder *builder,
                     const struct ph_tc_fit *fit);

/* ph_tc_build_end: the length, and the diagnostics of the solver. */
void ph_tc_build_end(const struct ph_tc_builder *builder,
                     struct ph_diagnostics *diagnostics);

/* ph_tc_curve_put: cubic i of a curve.
 *
 * in   start, end  the user's
 * in   tc          at unit scale
 * in   exponent    unit scale = data times 2^exponent; even
 */
void ph_tc_curve_put(struct ph_curve *curve, size_t i, const struct ph_tc *tc,
                     ph_cplx start, ph_cplx end, int exponent);

#endif
