/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Random data for curves of Tschirnhausen cubics (see tc.h). */
#include "tc_data.h"
#include "unit.h"

#include "check/certify.h"
#include "curve/fair/describe.h"
#include "kernel/pi.h"
#include "solve/method.h"
#include "solve/tc/tc.h"

static const char *const names[] = {"one",    "auto",       "fair", "pair",
                                    "lambda", "chord",      "c1",   "spline",
                                    "g2",     "approximate"};
static const char *const modes[] = {"g1",      NULL,      "g1-fair", "g1-pair",
                                    "g1-pair", "g1-pair", NULL,      "spline",
                                    "g2",      NULL};
/* ---- data ---------------------------------------------------------------- */
static bool has_tangents(const struct tc_data *d) {
  return d->family < TC_C1;
}

size_t tc_intervals(const struct tc_data *d) {
  return d->family == TC_APPROXIMATE ? 1 : d->closed ? d->n : d->n - 1;
}

ph_cplx tc_chord(const struct tc_data *d, size_t i) {
  return ph_cplx_sub(d->point[i + 1 < d->n ? i + 1 : 0], d->point[i]);
}

static double rounded(double x) {
  return ldexp(nearbyint(ldexp(x, 20)), -20);
}

/* A walk with turns of less than 2.5, so that no chord turns back. */
static void walk(struct unit_random *r, struct tc_data *d) {
  double heading = unit_random_in(r, -PH_PI, PH_PI);
  ph_cplx at = ph_cplx_of(rounded(unit_random_in(r, -5, 5)), 0);
  for (size_t i = 0; i < d->n; i++) {
    ph_cplx step =
        ph_cplx_scale(unit_random_in(r, 0.5, 5), ph_cplx_polar(heading));
    d->point[i] = at;
    at = ph_cplx_add(at, ph_cplx_of(rounded(step.re), rounded(step.im)));
    heading += unit_random_in(r, -2.5, 2.5);
  }
}

/* Once around, at uneven distances. */
static void ring(struct unit_random *r, struct tc_data *d) {
  for (size_t i = 0; i < d->n; i++) {
    double angle = ((double)i + unit_random_in(r, 0, 0.5)) / (double)d->n;
    ph_cplx p = ph_cplx_scale(unit_random_in(r, 2, 4),
                              ph_cplx_polar(2 * PH_PI * angle));
    d->point[i] = ph_cplx_of(rounded(p.re), rounded(p.im));
  }
}

/* An angle of the joint that both single cubics allow: within the ranges. */
static void choose_joint(struct unit_random *r, struct tc_data *d) {
  double low = -PH_PI, high = PH_PI;
  for (size_t i = 0; i < d->n; i++) {
    ph_cplx chord = tc_chord(d, 0);
    double range[2];
    ph_tc_g1_range(atan2(ph_cplx_cross(chord, d->vector[i]),
                         ph_cplx_dot(chord, d->vector[i])),
                   range);
    low = fmax(low, range[0]);
    high = fmin(high, range[1]);
  }
  d->joint_angle =
      unit_random_in(r, 0.1, 0.9) * (unit_random_below(r, 2) ? low : high);
  d->joint_position = unit_random_in(r, 0.1, 0.9);
}

void tc_of(struct unit_random *r, enum tc_family family, struct tc_data *d) {
  bool alone = family == TC_ONE || family == TC_CHORD;
  *d = (struct tc_data){.family = family,
                        .n = alone ? 2 : 2 + unit_random_below(r, 7),
                        .lambda = (double)NAN,
                        .joint_angle = (double)NAN,
                        .joint_position = (double)NAN,
                        .tolerance = (double)NAN,
                        .pieces = (double)NAN};
  d->closed =
      d->n > 2 && family != TC_APPROXIMATE && unit_random_below(r, 3) == 0;
  if (d->closed) {
    ring(r, d);
  } else {
    walk(r, d);
  }
  for (size_t i = 0; i < d->n; i++) {
    double scale = family == TC_C1 ? unit_random_in(r, 0.1, 3) : 1;
    double turn = unit_random_in(r, -PH_PI, PH_PI);
    size_t k = i < tc_intervals(d) ? i : 0;
    d->vector[i] =
        ph_cplx_scale(scale, ph_cplx_mul(ph_cplx_polar(turn), tc_chord(d, k)));
  }
  if (family == TC_LAMBDA) {
    d->lambda = unit_random_in(r, 0.2, 1.4);
  } else if (family == TC_CHORD) {
    choose_joint(r, d);
  } else if (family == TC_APPROXIMATE) {
    d->tolerance = pow(10, unit_random_in(r, -5, -1));
  }
}

/* ---- problems ------------------------------------------------------------ */

static void set_vectors(struct unit_solution *s, enum ph_field_id id,
                        const ph_cplx *z, size_t n) {
  double *v = unit_numbers(s, 2 * n);
  for (size_t i = 0; i < n; i++) {
    v[2 * i] = z[i].re;
    v[2 * i + 1] = z[i].im;
  }
  unit_set_array(&s->problem, id, v, n, 2);
}

static void set_problem(const struct tc_data *d, struct unit_solution *s) {
  struct ph_problem *p = &s->problem;
  bool given = d->ends && strcmp(d->ends, "given") == 0;
  set_vectors(s, d->family == TC_APPROXIMATE ? PH_F_CURVE : PH_F_POINTS,
              d->point, d->n);
  if (has_tangents(d) || d->family == TC_C1) {
    set_vectors(s, d->family == TC_C1 ? PH_F_DERIVATIVES : PH_F_TANGENTS,
                d->vector, d->n);
  }
  if (given) {
    set_vectors(s, PH_F_END_DERIVATIVES, d->end, 2);
  }
  unit_set_word(p, PH_F_ENDS, given ? NULL : d->ends);
  unit_set_word(p, PH_F_MODE, modes[d->family]);
  unit_set_word(p, PH_F_SOLUTIONS, d->solutions);
  unit_set_word(p, PH_F_JOINT, d->family == TC_CHORD ? "chord" : NULL);
  unit_set_number(p, PH_F_LAMBDA, d->lambda);
  unit_set_number(p, PH_F_JOINT_ANGLE, d->joint_angle);
  unit_set_number(p, PH_F_JOINT_POSITION, d->joint_position);
  unit_set_number(p, PH_F_TOLERANCE, d->tolerance);
  unit_set_number(p, PH_F_PIECES, d->pieces);
  unit_set_flag(p, PH_F_CLOSED, d->closed);
}

/* ---- curves -------------------------------------------------------------- */

ph_cplx tc_point(const struct ph_curve *c, size_t k, size_t i) {
  const double *p = c->control_points + 8 * k + 2 * i;
  return ph_cplx_of(p[0], p[1]);
}

ph_cplx tc_derivative(const struct ph_curve *c, size_t k, size_t i) {
  size_t from = i == 3 ? 2 : 0;
  ph_cplx leg = ph_cplx_sub(tc_point(c, k, from + 1), tc_point(c, k, from));
  return ph_cplx_scale(3, leg);
}

/* What rounding of coordinates can make of a difference of two. */
static double rounding(const struct ph_curve *c) {
  double most = 0;
  for (size_t i = 0; i < 8 * c->n; i++) {
    most = unit_larger(most, fabs(c->control_points[i]));
  }
  return 32 * DBL_EPSILON * most;
}

/* r' at one end of a cubic against what is given: its direction, or all. */
static void ck_end(const struct tc_data *d, const struct ph_curve *c, size_t k,
                   size_t i, ph_cplx vector) {
  ph_cplx found = tc_derivative(c, k, i);
  double size = ph_cplx_abs(found), noise = rounding(c), off;
  if (has_tangents(d)) {
    vector = ph_cplx_scale(size / ph_cplx_abs(vector), vector);
  }
  off = unit_distance(found, vector);
  ck_that(off <= noise + 1e-11 * size,
          "end %zu of cubic %zu is off by %.3g of %.3g", i, k, off, size);
}

/* A cubic begins where the one before ends, in the same direction. */
static void ck_joint(const struct ph_curve *c, size_t k, size_t next) {
  ph_cplx p = tc_point(c, k, 3), q = tc_point(c, next, 0);
  ph_cplx u = tc_derivative(c, k, 3), v = tc_derivative(c, next, 0);
  double size = ph_cplx_abs(u) + ph_cplx_abs(v), noise = rounding(c) * size;
  ck_that(unit_same(p.re, q.re) && unit_same(p.im, q.im),
          "a gap of %.3g before cubic %zu", unit_distance(p, q), next);
  ck_that(ph_cplx_dot(u, v) > -noise &&
              fabs(ph_cplx_cross(u, v)) <= noise + 1e-11 * size * size,
          "a corner of %.3g before cubic %zu",
          ph_cplx_cross(u, v) / size / size, next);
}

static void ck_lengths(const struct ph_curve *c) {
  double sum = 0;
  for (size_t k = 0; k < c->n; k++) {
    double chord = unit_distance(tc_point(c, k, 0), tc_point(c, k, 3));
    double polygon = 0;
    for (size_t i = 0; i < 3; i++) {
      polygon += unit_distance(tc_point(c, k, i), tc_point(c, k, i + 1));
    }
    ck_that(c->lengths[k] >= chord - rounding(c) &&
                c->lengths[k] <= polygon + rounding(c),
            "cubic %zu has length %.17g, not %.17g to %.17g", k, c->lengths[k],
            chord, polygon);
    sum += c->lengths[k];
  }
  ck_that(unit_near_rel(sum, c->length, 1e-14),
          "length %.17g, the sum is %.17g", c->length, sum);
}

/* Each interval goes from its point to the next, with what is given there. */
static void ck_interval(const struct tc_data *d, const struct ph_curve *c,
                        const struct ph_interval *interval, size_t i) {
  size_t next = i + 1 < d->n ? i + 1 : 0;
  ph_cplx from = tc_point(c, interval->first, 0);
  ph_cplx to = tc_point(c, interval->last, 3);
  ck_that(unit_distance(from, d->point[i]) <= 0 &&
              unit_distance(to, d->point[next]) <= 0,
          "interval %zu misses its points", i);
  if (has_tangents(d) || d->family == TC_C1) {
    ck_end(d, c, interval->first, 0, d->vector[i]);
    ck_end(d, c, interval->last, 3, d->vector[next]);
  }
}

static void ck_curve(const struct tc_data *d, const struct unit_solution *s,
                     const struct ph_curve *c,
                     const struct ph_interval *intervals) {
  ck_that(s->result.intervals_n == tc_intervals(d), "%zu intervals",
          s->result.intervals_n);
  ck_lengths(c);
  for (size_t k = 0; k + 1 < c->n; k++) {
    ck_joint(c, k, k + 1);
  }
  if (d->closed) {
    ck_joint(c, c->n - 1, 0);
  }
  for (size_t i = 0; d->family != TC_APPROXIMATE && i < tc_intervals(d); i++) {
    ck_interval(d, c, &intervals[i], i);
  }
}

/* ---- solutions ----------------------------------------------------------- */

/* The curve, or one of its solutions; irregular ones are among these. */
static void certify(const struct tc_data *d, struct unit_solution *s,
                    const struct ph_curve *c,
                    struct ph_diagnostics *diagnostics,
                    const struct ph_interval *intervals) {
  enum ph_status status =
      ph_certify("tc", &s->problem, c, &s->scratch, diagnostics, &s->diag);
  if (status == PH_OK) {
    status = ph_describe_cubics(c, &s->scratch, diagnostics, &s->diag);
  }
  ck_that(status == PH_OK, "certificate: %s %s", s->diag.field,
          s->diag.message);
  if (unit_diagnostic(diagnostics, PH_D_REGULAR) > 0) {
    ck_curve(d, s, c, intervals);
  }
}

bool tc_solve(const struct tc_data *d, size_t which, struct unit_solution *s) {
  enum ph_status status;
  unit_case("PH_SEED=%lu, case %zu (%s, %zu points%s, lambda %.17g)",
            unit_seed(), which, names[d->family], d->n,
            d->closed ? ", closed" : "", d->lambda);
  unit_solution_free(s);
  set_problem(d, s);
  status = unit_solve(&ph_method_tc, s);
  if (status != PH_OK) {
    ck_that(status == PH_E_INFEASIBLE && d->family == TC_ONE, "%s %s",
            s->diag.field, s->diag.message);
    return false;
  }
  certify(d, s, &s->result.curve, &s->result.diagnostics, s->result.intervals);
  ck_that(s->result.diagnostics.value[PH_D_REGULAR] > 0, "a cusp of %zu cubics",
          s->result.curve.n);
  for (size_t i = 0; i < s->result.solutions_n; i++) {
    struct ph_solution *one = &s->result.solutions[i];
    certify(d, s, &one->curve, &one->diagnostics, one->intervals);
  }
  return true;
}

void tc_must(const struct tc_data *d, size_t which, struct unit_solution *s) {
  bool solved = tc_solve(d, which, s);
  ck_that(solved, "%s %s", s->diag.field, s->diag.message);
}
