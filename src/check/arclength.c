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

/* What was measured is missed by one standard deviation, root mean square, to
 * this. */
static const double FITTED = 1e-5;

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

/* Directions that were measured. */
struct measured {
  ph_vec3 *toward;   /* [n + 1] unit vectors; 0 where they are exact */
  double *stiffness; /* [n + 1] see check/stationary.h */
  double rms;        /* of 2 sin(angle / 2) sqrt(|r'| / speed) / sigma, and of
                      * lengths in standard deviations */
};

/* |r'| that belongs to the lengths at datum j, in their mean, and r' there. */
static double speed_at(const struct ph_check *v, const double *lengths,
                       size_t j) {
  const double *t = v->curve->knots;
  size_t n = v->data->n, refine = v->curve->n / n;
  double spacing = (t[v->curve->n] - t[0]) / (double)n, sum = 0;
  size_t first = j > 0 ? j - 1 : 0, last = j < n ? j : n - 1;
  for (size_t i = first; i <= last; i++) {
    double h = (t[(i + 1) * refine] - t[i * refine]) / spacing;
    sum += ph_check_scaled(v, lengths[i]) / (h * v->interval);
  }
  return sum / (double)(last - first + 1);
}

static double sigma_at(const struct ph_check *v, size_t j) {
  const struct ph_value *sigma = &v->problem->field[PH_F_TANGENT_SIGMA];
  return sigma->kind == PH_NUMBERS ? (j < sigma->n ? sigma->v[j] : 0)
                                   : sigma->number;
}

/* r' at datum j by the global parameter, both as in the mean interval. */
static ph_vec3 derivative_at(const struct ph_check *v, size_t j) {
  const double *t = v->curve->knots;
  size_t n = v->data->n, refine = v->curve->n / n;
  size_t k = j < n ? j * refine : v->curve->n - 1;
  double spacing = (t[v->curve->n] - t[0]) / (double)n;
  ph_quat a[3];
  ph_check_preimage(v, k, a);
  return ph_vec3_scale(spacing / ((t[k + 1] - t[k]) * v->interval),
                       j < n ? ph_quat_i(a[0], a[0]) : ph_quat_i(a[2], a[2]));
}

/* The sum of squares of what lengths are missed by, in standard deviations. */
static double length_misses(const struct ph_check *v, const double *lengths) {
  double sigma = v->problem->field[PH_F_LENGTH_SIGMA].number, sum = 0;
  size_t refine = v->curve->n / v->data->n;
  for (size_t i = 0; i < v->data->n; i++) {
    double length = 0, miss;
    for (size_t k = 0; k < refine; k++) {
      length += v->curve->lengths[i * refine + k];
    }
    miss = (length / lengths[i] - 1) / sigma;
    sum += miss * miss;
  }
  return sum;
}

/* Directions of the problem that were measured, and how they are missed.
 * ret  PH_OK | PH_E_NO_MEMORY */
static enum ph_status measure(const struct ph_check *v, const double *lengths,
                              double weight, struct measured *m) {
  const struct ph_value *given = v->data->vectors;
  size_t n = v->data->n, terms = 0;
  double sum = 0;
  *m = (struct measured){.rms = 0};
  if (v->problem->field[PH_F_TANGENT_SIGMA].kind == PH_ABSENT || !lengths ||
      !given || given->n != n + 1) {
    return PH_OK;
  }
  m->toward = ph_arena_array(v->scratch, n + 1, sizeof *m->toward);
  m->stiffness = ph_arena_array(v->scratch, n + 1, sizeof *m->stiffness);
  if (!m->toward || !m->stiffness) {
    return ph_fail_memory(v->diag);
  }
  for (size_t j = 0; j <= n; j++) {
    double sigma = sigma_at(v, j), speed = speed_at(v, lengths, j);
    ph_vec3 to =
        ph_check_direction(given->v + given->dimension * j, given->dimension);
    m->toward[j] = ph_vec3_of(0, 0, 0);
    m->stiffness[j] = 0;
    if (sigma > 0) {
      ph_vec3 there = derivative_at(v, j);
      double size = ph_vec3_abs(there);
      ph_vec3 apart = ph_vec3_sub(ph_vec3_scale(1 / size, there), to);
      m->toward[j] = to;
      m->stiffness[j] = 2 * weight / (speed * sigma * sigma);
      sum += size / speed * ph_vec3_dot(apart, apart) / (sigma * sigma);
      terms++;
    }
  }
  if (v->problem->field[PH_F_LENGTH_SIGMA].kind == PH_NUMBER) {
    sum += length_misses(v, lengths);
    terms += n;
  }
  m->rms = terms > 0 ? sqrt(sum / (double)terms) : 0;
  return PH_OK;
}

/* Whether a curve is what it claims to be, and by how much what was measured is
 * missed. */
static enum ph_status judge(struct ph_check *v, const double *exact,
                            const struct ph_stationary *found, double rms,
                            struct ph_diagnostics *diagnostics) {
  double claimed = diagnostics->value[PH_D_F];
  ph_diagnostics_set(diagnostics, PH_D_KKT_ERROR, found->kkt_error);
  if (ph_check_known(v, PH_D_F) &&
      !(fabs(claimed - found->f) <= SAME_F * found->f + found->f_rounding)) {
    return ph_fail(v->diag, PH_E_NO_CONVERGENCE, NULL,
                   "the curve is refused by its certificate: F is %.10g, not "
                   "%.10g",
                   found->f, claimed);
  }
  if (!(rms <= 1 + FITTED)) {
    return ph_fail(v->diag, PH_E_NO_CONVERGENCE, NULL,
                   "the curve is refused by its certificate: it misses the "
                   "tangents by %.6g standard deviations, at most 1 is allowed",
                   rms);
  }
  if (!(found->kkt_error <= STATIONARY)) {
    return ph_fail(v->diag, PH_E_NO_CONVERGENCE, NULL,
                   "the curve is refused by its certificate: kkt_error is "
                   "%.3g, at most %.3g is allowed",
                   found->kkt_error, STATIONARY);
  }
  if (ph_check_known(v, PH_D_SECOND_ORDER) && !found->minimiser &&
      !is_polygon(v, exact) && !(found->f <= found->f_rounding) &&
      !(diagnostics->value[PH_D_SECOND_ORDER] > PH_OUTCOME_MINIMISER)) {
    return ph_fail(v->diag, PH_E_NO_CONVERGENCE, NULL,
                   "the curve is refused by its certificate: it is claimed to "
                   "be a minimiser, but F can fall");
  }
  ph_diagnostics_set_finite(diagnostics, PH_D_F, found->f);
  return PH_OK;
}

/* F, and whether the curve is stationary and the minimum that it claims to
 * be.
 *
 * in   exact, soft  lengths of the intervals, or NULL */
static enum ph_status check_stationary(struct ph_check *v, const double *exact,
                                       const double *soft,
                                       struct ph_diagnostics *diagnostics) {
  const struct ph_check_data *data = v->data;
  double weight = ph_check_known(v, PH_D_TANGENT_WEIGHT)
                      ? diagnostics->value[PH_D_TANGENT_WEIGHT]
                      : 0;
  struct measured m;
  struct ph_spinor_rows rows = {.n = data->n,
                                .refine = v->curve->n / data->n,
                                .lengths = exact || soft,
                                .points = data->points != NULL,
                                .knot_rows =
                                    data->derivatives || data->magnitudes ? 3
                                    : data->vectors                       ? 2
                                                                          : 0};
  struct ph_stationary_soft yields = {
      .length = soft,
      .sigma = v->problem->field[PH_F_LENGTH_SIGMA].number,
      .f_relaxed = diagnostics->value[PH_D_F_RELAXED]};
  struct ph_stationary found;
  enum ph_status status = measure(v, exact ? exact : soft, weight, &m);
  if (status == PH_OK && m.toward && weight > 0) {
    rows.toward = m.toward;
    yields.stiffness = m.stiffness;
    yields.f_relaxed = 9 * (double)data->n * weight;
  }
  status = status == PH_OK ? ph_stationary_of(v->curve, &rows, &yields,
                                              v->scratch, &found, v->diag)
                           : status;
  return status == PH_OK ? judge(v, exact, &found, m.rms, diagnostics) : status;
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
    return ph_fail(v->diag, PH_E_INTERNAL, "segments",
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
