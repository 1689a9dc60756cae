/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the fields of several methods have in common: counting points, knots and
 * angles given as numbers, words. */
#ifndef PH_SOLVE_COMMON_FIELDS_H
#define PH_SOLVE_COMMON_FIELDS_H

#include "base/diag.h"
#include "curve/problem.h"
#include "curve/result.h"

/* ph_field_is: whether a value is this word. */
bool ph_field_is(const struct ph_value *value, const char *word);

/* ph_fields_largest: the largest |v[i]| of n numbers. */
double ph_fields_largest(const double *v, size_t n);

/*
 * ph_fields_segments: how many segments interpolate the points of a problem,
 * of any dimension; a repeated last point of closed data counts as the first.
 *
 * out  n    segments; the curve has n points if closed, else n + 1
 * ret  PH_OK | PH_TOO_FEW_POINTS
 */
enum ph_status ph_fields_segments(const struct ph_problem *problem, size_t *n,
                                  struct ph_diag *diag);

/*
 * ph_fields_knots: knots given as numbers, n + 1 of them, increasing.
 *
 * out  h[n]  spacings
 * ret  PH_OK | PH_BAD_SHAPE | PH_BAD_VALUE | PH_TOO_LARGE
 */
enum ph_status ph_fields_knots(const struct ph_value *knots, size_t n,
                               bool closed, double *h, struct ph_diag *diag);

/*
 * ph_fields_each: a field that is one number for all segments or one for each.
 *
 * in   what   the field's name
 * in   below  every number must be greater than 0 and less than this
 * in   range  what the message calls that: "between 0 and pi"
 * out  v[n]
 * ret  PH_OK | PH_BAD_SHAPE | PH_BAD_VALUE
 */
enum ph_status ph_fields_each(const struct ph_value *value, const char *what,
                              size_t n, double below, const char *range,
                              double *v, struct ph_diag *diag);

/* ph_fields_angles: the field alpha by ph_fields_each, between 0 and pi. */
enum ph_status ph_fields_angles(const struct ph_value *value, size_t n,
                                double *angle, struct ph_diag *diag);

/* ph_warn_alpha: the warning about segments with an alpha above 2 pi/3, of
 * which [GON18, sec. 2.1] says nothing. */
void ph_warn_alpha(const struct ph_curve *curve, struct ph_result *result);

#endif
