/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the fields of several methods have in common: counting points, knots and
 * angles given as numbers, words. */
#ifndef PH_SOLVE_COMMON_FIELDS_H
#define PH_SOLVE_COMMON_FIELDS_H

#include "base/diag.h"
#include "curve/problem.h"
#include "curve/result.h"
#include "kernel/vec3.h"

/* PH_FIELD_MERGE: the row of a method whose data have points. */
#define PH_FIELD_MERGE                                \
  {                                                   \
    PH_F_MERGE, PH_NUMBER, 0, false, NULL, "nothing", \
        "join consecutive points nearer than this"    \
  }

/* PH_FIELD_AT: the row of a method that makes curves. */
#define PH_FIELD_AT                                               \
  {                                                               \
    PH_F_AT, PH_NUMBER | PH_NUMBERS, 0, false, NULL, "none",      \
        "add samples at these arc lengths, below 0: from the end" \
  }

/* ph_fields_largest: the largest |v[i]| of n numbers. */
double ph_fields_largest(const double *v, size_t n);

/* ph_fields_order: -1, 0 or 1, for qsort. */
static inline int ph_fields_order(double a, double b) {
  return (a > b) - (a < b);
}

/* ph_fields_given: whether a problem has a field. */
static inline bool ph_fields_given(const struct ph_problem *problem,
                                   enum ph_field_id id) {
  return problem->field[id].kind != PH_ABSENT;
}

/* ph_fields_exponent: of the power of two, an even one, that brings numbers up
 * to size below 1/2, so that neither sums nor squares reach 1; 0 if all are 0.
 */
int ph_fields_exponent(double size);

/* ph_fields_vector: vector i of a field, of two or three numbers. */
ph_vec3 ph_fields_vector(const struct ph_value *value, size_t i);

/* ph_fields_unit: v / |v|, at a scale of its own; v is finite and not 0. */
ph_vec3 ph_fields_unit(ph_vec3 v);

/*
 * ph_fields_vectors: checks a field that has one vector for each point, none of
 * them 0.  Closed data whose last point repeats the first may repeat the vector
 * as well, or of tangents its direction.
 *
 * in   points_n  points of the curve (ph_fields_segments)
 * ret  PH_OK | PH_E_BAD_SHAPE | PH_E_BAD_VALUE | PH_E_ZERO_TANGENT
 */
enum ph_status ph_fields_vectors(const struct ph_problem *problem,
                                 enum ph_field_id id, size_t points_n,
                                 struct ph_diag *diag);

/*
 * ph_fields_segments: how many segments interpolate the points of a problem,
 * of any dimension; a repeated last point of closed data counts as the first.
 *
 * out  n    segments; the curve has n points if closed, else n + 1
 * ret  PH_OK | PH_E_TOO_FEW_POINTS
 */
enum ph_status ph_fields_segments(const struct ph_problem *problem, size_t *n,
                                  struct ph_diag *diag);

/* ph_fields_coincide: the failure of points k and `to` of a field. */
enum ph_status ph_fields_coincide(struct ph_diag *diag, const char *name,
                                  size_t k, size_t to);

/*
 * ph_fields_knots: knots given as numbers, n + 1 of them, increasing.
 *
 * out  h[n]  spacings
 * ret  PH_OK | PH_E_BAD_SHAPE | PH_E_BAD_VALUE | PH_E_TOO_LARGE
 */
enum ph_status ph_fields_knots(const struct ph_value *knots, size_t n,
                               bool closed, double *h, struct ph_diag *diag);

/* ph_fields_sums: knots from 0 on whose spacings are h[n].  out knots[n + 1] */
void ph_fields_sums(const double *h, size_t n, double *knots);

/* ph_fields_sum: h[0] + ... + h[n - 1]. */
double ph_fields_sum(const double *h, size_t n);

/*
 * ph_fields_each: a field that is one number for all segments or one for each.
 *
 * in   what   the field's name
 * in   below  every number must be greater than 0 and less than this
 * in   range  what the message calls that: "between 0 and pi"
 * out  v[n]
 * ret  PH_OK | PH_E_BAD_SHAPE | PH_E_BAD_VALUE
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
