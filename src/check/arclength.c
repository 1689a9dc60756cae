/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The certificate of C2 spatial PH quintic splines with prescribed arc lengths
 * (see certify.h): that they are stationary, and their speed.
 */
#include "check/certify.h"

#include "check/checks.h"
#include "check/data.h"
#include "check/stationary.h"
#include "kernel/form.h"

#include <string.h>

/* The smallest speed is found to this, relative to the mean one, by halving:
 * an error that falls by 4 each time, from at most 1. */
static const double SPEED = 1e-13;
enum { HALVINGS_MAX = 40 };

/* What may be left of the gradient, relative to its largest terms: rounding
 * leaves some 1e-8, a solver that stops where F can fall by 1e-9 of itself up
 * to 1e-4. */
static const double STATIONARY = 1e-3;

/* A length that is above its chord by no more is the chord. */
static const double CHORD = 1e-12;

/* F again, from the same preimage in another order of operations. */
static const double SAME_F = 1e-10;

/* The Bernstein coefficients of |A|^2.
 * out  speed[5] */
static void speed_of(const ph_quat a[3], double speed[5]) {
  speed[0] = ph_quat_dot(a[0], a[0]);
  speed[1] = ph_quat_dot(a[0], a[1]);
  speed[2] = (2 * ph_quat_dot(a[1], a[1]) + ph_quat_dot(a[0], a[2])) / 3;
  speed[3] = ph_quat_dot(a[1], a[2]);
  speed[4] = ph_quat_dot(a[2], a[2]);
}

/* The smallest speed so far and in segment k: |A|^2 has its Bernstein
 * coefficients for bounds, from which halves that cannot hold less are left
 * out. */
static double smallest_speed(const struct ph_check *v, size_t k,
                             double smallest) {
  const double *t = v->curve->knots;
  double stack[HALVINGS_MAX + 1][5], rest[5];
  size_t depth[HALVINGS_MAX + 1], n = 1;
  double spacing = (t[v->curve->n] - t[0]) / (double)v->data->n;
  double unit = spacing / ((t[k + 1] - t[k]) * v->interval);
  ph_quat a[3];
  ph_check_preimage(v, k, a);
  speed_of(a, stack[0]);
  depth[0] = 0;
  while (n > 0) {
    const double *b = stack[--n];
    double low = b[0];
    for (size_t i = 1; i < 5; i++) {
      low = ph_check_smaller(low, b[i]);
    }
    smallest = ph_check_smaller(smallest, unit * b[0]);
    smallest = ph_check_smaller(smallest, unit * b[4]);
    if (unit * low < smallest - SPEED && depth[n] < HALVINGS_MAX) {
      memcpy(rest, b, sizeof rest);
      ph_form_halve(rest, 4, stack[n], stack[n + 1]);
      depth[n]++;
      depth[n + 1] = depth[n];
      n += 2;
    }
  }
  return smallest;
}

/* The lengths of the intervals: one for all, one each, or none.
 *
 * out  lengths  NULL: none
 * ret  false when memory is exhausted */
static bool set_lengths(const struct ph_check *v, const double **lengths) {
  const struct ph_value *given = &v->problem->field[PH_F_LENGTHS];
  double *all;
  *lengths = given->kind == PH_NUMBERS ? given->v : NULL;
  if (given->kind != PH_NUMBER) {
    return true;
  }
  all = ph_arena_array(v->scratch, v->data->n, sizeof *all);
  for (size_t i = 0; all && i < v->data->n; i++) {
    all[i] = given->number;
  }
  *lengths = all;
  return all != NULL;
}

/* Whether every length is the chord: then no curve leaves the polygon, and
 * where F could fall the rows do not allow it to go, though to first order they
 * do. */
static bool is_polygon(const struct ph_check *v, const double *lengths) {
  const struct ph_check_data *data = v->data;
  for (size_t i = 0; data->points && i < data->n; i++) {
    double off;
    ph_vec3 to = ph_check_datum(v, data, i + 1, &off);
    double chord =
        ph_vec3_abs(ph_vec3_sub(to, ph_check_datum(v, data, i, &off)));
    if (!lengths || !(ph_check_scaled(v, lengths[i]) <=
                      chord * (1 + CHORD) + v->scale.rounding)) {
      return false;
    }
  }
  return data->points != NULL;
}

/* F, and whether the curve is stationary and the minimum that it claims to
 * be.
 *
 * in   exact, soft  lengths of the intervals, or NULL */
static enum ph_status check_stationary(struct ph_check *v, const double *exact,
                                       const double *soft,
                                       struct ph_diagnostics *diagnostics) {
  const struct ph_check_data *data = v->data;
  const struct ph_spinor_rows rows = {
      .n = data->n,
      .refine = v->curve->n / data->n,
      .lengths = exact || soft,
      .points = data->points != NULL,
      .knot_rows = data->derivatives || data->magnitudes ? 3
                   : data->vectors                       ? 2
                                                         : 0};
  const struct ph_stationary_soft yields = {
      soft, v->problem->field[PH_F_LENGTH_SIGMA].number,
      diagnostics->value[PH_D_F_RELAXED]};
  struct ph_stationary found;
  double claimed = diagnostics->value[PH_D_F];
  enum ph_status status =
      ph_stationary_of(v->curve, &rows, &yields, v->scratch, &found, v->diag);
  if (status != PH_OK) {
    return status;
  }
  ph_diagnostics_set(diagnostics, PH_D_KKT_ERROR, found.kkt_error);
  if (ph_check_known(v, PH_D_F) &&
      !(fabs(claimed - found.f) <= SAME_F * found.f + found.f_rounding)) {
    return ph_fail(v->diag, PH_NO_CONVERGENCE, NULL,
                   "the curve is refused by its certificate: F is %.10g, not "
                   "%.10g",
                   found.f, claimed);
  }
  if (!(found.kkt_error <= STATIONARY)) {
    return ph_fail(v->diag, PH_NO_CONVERGENCE, NULL,
                   "the curve is refused by its certificate: kkt_error is "
                   "%.3g, at most %.3g is allowed",
                   found.kkt_error, STATIONARY);
  }
  if (ph_check_known(v, PH_D_SECOND_ORDER) && !found.minimiser &&
      !is_polygon(v, exact) && !(found.f <= found.f_rounding) &&
      !(diagnostics->value[PH_D_SECOND_ORDER] > PH_OUTCOME_MINIMISER)) {
    return ph_fail(v->diag, PH_NO_CONVERGENCE, NULL,
                   "the curve is refused by its certificate: it is claimed to "
                   "be a minimiser, but F can fall");
  }
  ph_diagnostics_set_finite(diagnostics, PH_D_F, found.f);
  return PH_OK;
}

enum ph_status ph_check_arclength(struct ph_check *v,
                                  struct ph_diagnostics *diagnostics) {
  const struct ph_value *refine = &v->problem->field[PH_F_REFINE];
  bool soft = v->problem->field[PH_F_LENGTH_SIGMA].kind == PH_NUMBER;
  double smallest = HUGE_VAL, each = (double)(v->curve->n / v->data->n);
  const double *lengths;
  if (!(each <= PH_CHECK_REFINE_MAX) ||
      (refine->kind == PH_NUMBER &&
       (each < refine->number || each > refine->number))) {
    return ph_fail(v->diag, PH_INTERNAL, "segments",
                   "are not one to three for each interval of the data");
  }
  for (size_t k = 0; k < v->curve->n && !ph_arena_late(v->scratch); k++) {
    smallest = smallest_speed(v, k, smallest);
  }
  ph_diagnostics_set_finite(diagnostics, PH_D_MIN_SPEED, smallest);
  return set_lengths(v, &lengths)
             ? check_stationary(v, soft ? NULL : lengths, soft ? lengths : NULL,
                                diagnostics)
             : ph_fail_memory(v->diag);
}
