/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The certificate of C2 spatial PH quintic splines with prescribed arc lengths
 * (see certify.h).
 *
 * Everything is measured by the mean length of a data interval, as the solver
 * does: a data interval consists of one to three segments, and what the
 * solution misses its data by is in the middle leg of one of them.
 */
#include "check/certify.h"

#include "base/sum.h"
#include "check/segment3.h"
#include "check/stationary.h"
#include "kernel/form.h"

#include <float.h>
#include <string.h>

/* The solver meets each equation to 1e-12 of the mean length.  A middle leg
 * that is off by that in each coordinate makes 1.875 sqrt(3) = 3.3 times as
 * much in r'. */
static const double MISS = 4e-12;

/* Rounding of a few operations of the solver, relative to the speed. */
static const double ROUNDING = 1e-13;
static const double CONTINUITY = 1e-12;

/* Allowances in units of the rounding of a coordinate, beside error.h's: a
 * second difference of control points times 20, with a margin of 3.  Of knots
 * the difference counts, once for r' and twice for r''. */
enum { ROUND_SECOND = 256, ROUND_KNOT = 4 };

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

struct context {
  const struct ph_arena *arena; /* knows how much time there is */
  struct ph_check3 at;
  struct ph_check3_data points, tangents, derivatives;
  const double *lengths; /* of the intervals, or NULL: free */
  bool soft;             /* they are not exact */
  bool mean;             /* magnitudes of tangents follow from them */
  ph_vec3 start;         /* without points */
  size_t n;              /* intervals */
  size_t refine;         /* segments in each */
  double length;         /* mean of an interval, at unit scale */
  double spacing;        /* the same in the global parameter */
  double farthest_knot;  /* from 0, whose rounding is the largest */
};

struct checks {
  struct ph_check_error point, tangent, square, joint, length;
  double speed; /* the smallest, relative to the mean */
};

/* The spacing of knots of segment k. */
static double spacing_of(const struct context *c, size_t k) {
  const double *t = c->at.curve->knots;
  return t[k + 1] - t[k];
}

/* Vector k of the data, at unit scale; the first one again after the last of
 * closed data. */
static ph_vec3 data_at(const struct context *c,
                       const struct ph_check3_data *data, size_t k) {
  size_t i = c->at.curve->closed && k == c->n ? 0 : k;
  return ph_check3_scaled(
      &c->at, ph_vec3_get(data->v + data->dimension * i, data->dimension));
}

/* What rounding of knots makes of a derivative by them, in a segment. */
static double knot_rounding(const struct context *c, double h) {
  return ROUND_KNOT * DBL_EPSILON * c->farthest_knot / h;
}

/* r' = A i A*, and the length of segment k. */
static double check_segment(const struct context *c,
                            const struct ph_check3_segment *s, size_t k,
                            struct checks *checks) {
  double miss, length = ph_check3_hodograph(&c->at, s, &miss);
  double claimed = ph_pow2_apply(c->at.scale.to_unit, c->at.curve->lengths[k]);
  double allowed = MISS * c->length + ROUNDING * s->speed + s->allowance;
  ph_check_add(&checks->square, k, miss, c->length, allowed);
  ph_check_add(&checks->length, k, fabs(length - claimed), c->length, allowed);
  return length;
}

/* The length of interval i against the prescribed one. */
static void check_interval(const struct context *c, double length, size_t i,
                           double allowance, struct ph_check_error *check) {
  if (c->lengths && !c->soft) {
    double wanted = ph_pow2_apply(c->at.scale.to_unit, c->lengths[i]);
    ph_check_add(check, (i + 1) * c->refine - 1, fabs(length - wanted),
                 c->length, MISS * c->length + ROUNDING * length + allowance);
  }
}

/* A data point, or the start of a curve without points. */
static void check_point(const struct context *c, ph_vec3 point, size_t datum,
                        size_t k, struct ph_check_error *check) {
  ph_vec3 wanted = c->points.n > 0 ? data_at(c, &c->points, datum)
                                   : ph_check3_scaled(&c->at, c->start);
  if (c->points.n > 0 || datum == 0) {
    ph_check_add(check, k, ph_vec3_abs(ph_vec3_sub(point, wanted)),
                 c->at.scale.size, c->at.scale.rounding);
  }
}

/* The length of a derivative at datum j, from the lengths and spacings of the
 * neighbouring intervals. [HUA14, sec. 5.3] */
static double mean_magnitude(const struct context *c, size_t j) {
  const double *t = c->at.curve->knots;
  double sum = 0;
  size_t first = j > 0 ? j - 1 : 0, last = j < c->n ? j : c->n - 1;
  for (size_t i = first; i <= last; i++) {
    double h = t[(i + 1) * c->refine] - t[i * c->refine];
    sum += ph_pow2_apply(c->at.scale.to_unit, c->lengths[i]) / h;
  }
  return sum / (double)(last - first + 1);
}

/* The direction given at datum j. */
static ph_vec3 direction_at(const struct context *c, size_t j) {
  const struct ph_check3_data *data = &c->tangents;
  return ph_check3_direction(
      ph_vec3_get(data->v + data->dimension * j, data->dimension));
}

/* The tangent or derivative given at datum j, for one end of segment k. */
static void check_tangent(const struct context *c,
                          const struct ph_check3_segment *s, size_t k,
                          size_t end, size_t j, struct ph_check_error *check) {
  double h = spacing_of(c, k), mean = c->length / c->spacing;
  if (c->derivatives.n > 0 || c->mean) {
    ph_vec3 given = c->derivatives.n > 0 ? data_at(c, &c->derivatives, j)
                                         : ph_vec3_scale(mean_magnitude(c, j),
                                                         direction_at(c, j));
    double size = h * ph_vec3_abs(given);
    ph_vec3 miss = ph_vec3_along(s->first[end], -h, given);
    ph_check_add(check, k, ph_vec3_abs(miss), size,
                 MISS * h * mean + (ROUNDING + knot_rounding(c, h)) * size +
                     s->allowance);
  } else {
    ph_vec3 miss = ph_vec3_sub(s->tangent[end], direction_at(c, j));
    double speed = ph_vec3_abs(s->first[end]) / h;
    ph_check_add(check, k, ph_vec3_abs(miss), 1,
                 ROUNDING + MISS * sqrt(mean / speed) + s->error[end]);
  }
}

/* r'' at both ends of a segment, by u. */
static void second_of(const struct ph_check3_segment *s, ph_vec3 second[2]) {
  second[0] = ph_vec3_scale(20, ph_vec3_sub(s->leg[1], s->leg[0]));
  second[1] = ph_vec3_scale(20, ph_vec3_sub(s->leg[4], s->leg[3]));
}

/* Jumps of r' and r'' between two segments, in the shorter interval's unit and
 * relative to the larger speed of the two. */
static void check_joint(const struct context *c,
                        const struct ph_check3_segment *a, double ha,
                        const struct ph_check3_segment *b, double hb, size_t k,
                        struct ph_check_error *joint) {
  double h = ph_check_smaller(ha, hb), fa = h / ha, fb = h / hb;
  double knot = knot_rounding(c, h), rounding = c->at.scale.rounding;
  double speed = ph_check_larger(fa * a->speed, fb * b->speed);
  ph_vec3 first =
      ph_vec3_along(ph_vec3_scale(fa, a->first[1]), -fb, b->first[0]);
  ph_vec3 sa[2], sb[2], second;
  second_of(a, sa);
  second_of(b, sb);
  second = ph_vec3_along(ph_vec3_scale(fa * fa, sa[1]), -fb * fb, sb[0]);
  ph_check_add(joint, k, ph_vec3_abs(first), speed,
               (CONTINUITY + knot) * speed + PH_CHECK_ROUND_FIRST * rounding);
  ph_check_add(joint, k, ph_vec3_abs(second), speed,
               (CONTINUITY + 8 * knot) * speed + ROUND_SECOND * rounding);
}

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
static double smallest_speed(const struct context *c,
                             const struct ph_check3_segment *s, size_t k,
                             double smallest) {
  double stack[HALVINGS_MAX + 1][5], rest[5];
  size_t depth[HALVINGS_MAX + 1], n = 1;
  double unit = c->spacing / (spacing_of(c, k) * c->length);
  speed_of(s->a, stack[0]);
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

/* What is given at the ends of segment k. */
static void check_data(const struct context *c,
                       const struct ph_check3_segment *s, size_t k,
                       struct checks *checks) {
  size_t j = k / c->refine;
  bool vectors = c->derivatives.n > 0 || c->tangents.n > 0;
  if (k % c->refine == 0) {
    check_point(c, s->start, j, k, &checks->point);
    if (vectors) {
      check_tangent(c, s, k, 0, j, &checks->tangent);
    }
  }
  if ((k + 1) % c->refine == 0) {
    check_point(c, s->end, j + 1, k, &checks->point);
    if (vectors) {
      check_tangent(c, s, k, 1, j + 1, &checks->tangent);
    }
  }
}

static void check_segments(struct context *c, struct checks *checks) {
  const struct ph_curve *curve = c->at.curve;
  struct ph_check3_segment first = ph_check3_segment_of(&c->at, 0);
  struct ph_check3_segment before = first;
  struct ph_sum total = {0, 0};
  double length = 0, claimed, allowance = 0, sum = 0;
  for (size_t k = 0; k < curve->n && !ph_arena_late(c->arena); k++) {
    struct ph_check3_segment s = ph_check3_segment_of(&c->at, k);
    double part = check_segment(c, &s, k, checks);
    length = k % c->refine == 0 ? part : length + part;
    allowance = k % c->refine == 0 ? s.allowance : allowance + s.allowance;
    if ((k + 1) % c->refine == 0) {
      check_interval(c, length, k / c->refine, allowance, &checks->length);
    }
    check_data(c, &s, k, checks);
    checks->speed = smallest_speed(c, &s, k, checks->speed);
    if (k > 0) {
      /* segments join in space, too */
      ph_check_add(&checks->joint, k,
                   ph_vec3_abs(ph_vec3_sub(s.start, before.end)), c->length,
                   c->at.scale.rounding);
      check_joint(c, &before, spacing_of(c, k - 1), &s, spacing_of(c, k), k,
                  &checks->joint);
    }
    ph_sum_add(&total, part);
    sum += s.allowance;
    before = s;
  }
  claimed = ph_pow2_apply(c->at.scale.to_unit, curve->length);
  ph_check_add(&checks->length, curve->n - 1,
               fabs(ph_sum_value(&total) - claimed), c->length,
               (double)c->n * MISS * c->length + sum);
  if (curve->closed) {
    check_joint(c, &before, spacing_of(c, curve->n - 1), &first,
                spacing_of(c, 0), 0, &checks->joint);
  }
}

static enum ph_status conclude(const struct context *c,
                               const struct checks *checks,
                               struct ph_diagnostics *diagnostics,
                               struct ph_diag *diag) {
  const bool vectors = c->tangents.n > 0 || c->derivatives.n > 0;
  const struct ph_check_error *const list[] = {
      &checks->point, vectors ? &checks->tangent : NULL, &checks->square,
      &checks->joint, &checks->length};
  enum ph_status status = ph_check_conclude(list, 5, diagnostics, diag);
  if (status == PH_OK) {
    ph_diagnostics_set_finite(diagnostics, PH_D_MIN_SPEED, checks->speed);
  }
  return status;
}

/* How many data intervals a problem has.  A repeated last point of closed data
 * counts once: the curve has a whole number of segments in each interval, and
 * that of three points or more can be so in one way only. */
static size_t intervals_of(const struct context *c) {
  size_t given = c->points.n, n = c->at.curve->n;
  if (given > 0 && c->at.curve->closed) {
    return n % given == 0 && n / given <= 3 ? given : given - 1;
  }
  return (given > 0              ? given
          : c->derivatives.n > 0 ? c->derivatives.n
                                 : c->tangents.n) -
         1;
}

/* The lengths of the intervals: one for all, one each, or none. */
static bool set_lengths(struct context *c, const struct ph_value *lengths,
                        struct ph_arena *scratch) {
  double *all;
  if (lengths->kind != PH_NUMBER) {
    c->lengths = lengths->kind == PH_NUMBERS ? lengths->v : NULL;
    return true;
  }
  all = ph_arena_array(scratch, c->n, sizeof *all);
  for (size_t i = 0; all && i < c->n; i++) {
    all[i] = lengths->number;
  }
  c->lengths = all;
  return all != NULL;
}

/* The shape of the data and of the curve; false when they disagree. */
static bool set_shape(struct context *c, const struct ph_problem *problem) {
  const struct ph_value *refine = &problem->field[PH_F_REFINE];
  const struct ph_value *lengths = &problem->field[PH_F_LENGTHS];
  size_t n = c->at.curve->n;
  if (c->points.n + c->derivatives.n + c->tangents.n < 2) {
    return false;
  }
  c->n = intervals_of(c);
  c->refine = c->n > 0 ? n / c->n : 0;
  return c->refine >= 1 && c->refine <= 3 && n == c->refine * c->n &&
         (refine->kind != PH_NUMBER || !((double)c->refine < refine->number ||
                                         (double)c->refine > refine->number)) &&
         (lengths->kind == PH_NUMBERS ? lengths->n == c->n
                                      : lengths->kind == PH_NUMBER || !c->mean);
}

static void set_scales(struct context *c) {
  const struct ph_curve *curve = c->at.curve;
  double first = curve->knots[0], last = curve->knots[curve->n];
  double n = (double)c->n;
  c->length = ph_pow2_apply(c->at.scale.to_unit, curve->length) / n;
  c->spacing = (last - first) / n;
  c->farthest_knot = ph_check_larger(fabs(first), fabs(last));
}

/* Whether every length is the chord: then no curve leaves the polygon, and
 * where F could fall the rows do not allow it to go, though to first order they
 * do. */
static bool is_polygon(const struct context *c) {
  for (size_t i = 0; c->points.n > 0 && i < c->n; i++) {
    ph_vec3 step =
        ph_vec3_sub(data_at(c, &c->points, i + 1), data_at(c, &c->points, i));
    double chord = ph_vec3_abs(step);
    if (!c->lengths || c->soft ||
        !(ph_pow2_apply(c->at.scale.to_unit, c->lengths[i]) <=
          chord * (1 + CHORD) + c->at.scale.rounding)) {
      return false;
    }
  }
  return c->points.n > 0;
}

/* F, and whether the curve is stationary and the minimum that it claims to
 * be. */
static enum ph_status check_stationary(const struct context *c,
                                       const struct ph_problem *problem,
                                       struct ph_arena *scratch,
                                       struct ph_diagnostics *diagnostics,
                                       struct ph_diag *diag) {
  const struct ph_spinor_rows rows = {.n = c->n,
                                      .refine = c->refine,
                                      .lengths = c->lengths != NULL,
                                      .points = c->points.n > 0,
                                      .knot_rows =
                                          c->derivatives.n > 0 || c->mean ? 3
                                          : c->tangents.n > 0             ? 2
                                                                          : 0};
  const struct ph_stationary_soft soft = {
      c->soft ? c->lengths : NULL, problem->field[PH_F_LENGTH_SIGMA].number,
      diagnostics->value[PH_D_F_RELAXED]};
  struct ph_stationary found;
  double claimed = diagnostics->value[PH_D_F];
  enum ph_status status =
      ph_stationary_of(c->at.curve, &rows, &soft, scratch, &found, diag);
  if (status != PH_OK) {
    return status;
  }
  ph_diagnostics_set(diagnostics, PH_D_KKT_ERROR, found.kkt_error);
  if (ph_diagnostics_known(diagnostics, PH_D_F) &&
      !(fabs(claimed - found.f) <= SAME_F * found.f + found.f_rounding)) {
    return ph_fail(diag, PH_NO_CONVERGENCE, NULL,
                   "the curve is refused by its certificate: F is %.10g, not "
                   "%.10g",
                   found.f, claimed);
  }
  if (!(found.kkt_error <= STATIONARY)) {
    return ph_fail(diag, PH_NO_CONVERGENCE, NULL,
                   "the curve is refused by its certificate: kkt_error is "
                   "%.3g, at most %.3g is allowed",
                   found.kkt_error, STATIONARY);
  }
  if (ph_diagnostics_known(diagnostics, PH_D_SECOND_ORDER) &&
      !found.minimiser && !is_polygon(c) && !(found.f <= found.f_rounding) &&
      !(diagnostics->value[PH_D_SECOND_ORDER] > PH_OUTCOME_MINIMISER)) {
    return ph_fail(diag, PH_NO_CONVERGENCE, NULL,
                   "the curve is refused by its certificate: it is claimed to "
                   "be a minimiser, but F can fall");
  }
  ph_diagnostics_set(diagnostics, PH_D_F, found.f);
  return PH_OK;
}

enum ph_status ph_check_arclength(const struct ph_problem *problem,
                                  const struct ph_curve *curve,
                                  struct ph_arena *scratch,
                                  struct ph_diagnostics *diagnostics,
                                  struct ph_diag *diag) {
  struct checks checks = {
      {.what = PH_D_INTERPOLATION_ERROR}, {.what = PH_D_TANGENT_ERROR},
      {.what = PH_D_PYTHAGOREAN_ERROR},   {.what = PH_D_CONTINUITY_ERROR},
      {.what = PH_D_LENGTH_ERROR},        .speed = HUGE_VAL};
  const struct ph_value *field = problem->field;
  const struct ph_value *start = &field[PH_F_START];
  struct context c = {.arena = scratch,
                      .points = ph_check3_data_of(problem, PH_F_POINTS),
                      .tangents = ph_check3_data_of(problem, PH_F_TANGENTS),
                      .derivatives =
                          ph_check3_data_of(problem, PH_F_DERIVATIVES),
                      .soft = field[PH_F_LENGTH_SIGMA].kind == PH_NUMBER};
  enum ph_status status;
  c.at.curve = curve;
  c.mean = c.tangents.n > 0 && field[PH_F_MAGNITUDES].kind == PH_WORD &&
           strcmp(field[PH_F_MAGNITUDES].word, "mean") == 0;
  if (start->kind == PH_NUMBERS) {
    c.start = ph_vec3_get(start->v, start->n);
  }
  if (!set_shape(&c, problem)) {
    return ph_fail(diag, PH_INTERNAL, "segments",
                   "are not one to three for each interval of the data");
  }
  if (!set_lengths(&c, &field[PH_F_LENGTHS], scratch)) {
    return ph_fail_memory(diag);
  }
  status = ph_check3_begin(&c.at, curve, curve->control_points, 6 * curve->n, 3,
                           diag);
  if (status != PH_OK) {
    return status;
  }
  set_scales(&c);
  check_segments(&c, &checks);
  status = conclude(&c, &checks, diagnostics, diag);
  return status == PH_OK
             ? check_stationary(&c, problem, scratch, diagnostics, diag)
             : status;
}
