/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The certificate of planar Tschirnhausen cubics (see certify.h): those that
 * interpolate points.  Approximations are in tc_approx.c.
 *
 * Each interval of the data has one or two cubics; which is seen from where
 * they end, in their order.
 */
#include "check/certify.h"

#include "base/team.h"
#include "check/note.h"
#include "check/tc_approx.h"
#include "check/tc_check.h"
#include "check/tc_g2.h"
#include "check/tc_wanted.h"

#include <math.h>

static const double INTERPOLATION = 1e-13;

/* The joint on the chord is a product of a direction and a length. */
static const double ON_CHORD = 1e-12;

/* Intervals of a part of a long chain, which take 1 ms. */
enum { PART = 1024 };

/* The cubics of one interval of the data. */
struct interval {
  size_t k;     /* of the data */
  size_t first; /* cubic */
  size_t n;     /* 1 or 2 */
  struct ph_tc_cubic cubic[2];
};

static double apart(ph_cplx a, ph_cplx b) {
  return ph_cplx_abs(ph_cplx_sub(a, b));
}

static ph_cplx end_of(const struct ph_tc_check *c, size_t k) {
  return ph_tc_check_scaled(c, ph_curve_points(c->curve, k) + 6);
}

/* How many cubics an interval has whose first one is number `first`: where the
 * mode leaves a choice, and those that are left over do, the one of two whose
 * end is nearer to the point. */
static size_t count(const struct ph_tc_wanted *w, const struct ph_tc_check *c,
                    size_t k, size_t first) {
  size_t left = c->curve->n - first, to_come = w->n - k - 1;
  ph_cplx end = ph_tc_wanted_point(w, c, k + 1);
  if (w->mode != PH_TC_WANTED_EITHER) {
    return w->mode == PH_TC_WANTED_ONE ? 1 : 2;
  }
  if (left == to_come + 1 || left == 2 * to_come + 2) {
    return left == to_come + 1 ? 1 : 2;
  }
  return apart(end_of(c, first), end) <= apart(end_of(c, first + 1), end) ? 1
                                                                          : 2;
}

static void check_points(struct ph_tc_check *c, const struct ph_tc_wanted *w,
                         const struct interval *in) {
  const struct ph_tc_cubic *last = &in->cubic[in->n - 1];
  double size = c->scale.size;
  ph_check_add(&c->point, in->first,
               apart(in->cubic[0].p[0], ph_tc_wanted_point(w, c, in->k)), size,
               INTERPOLATION * size);
  ph_check_add(&c->point, in->first + in->n - 1,
               apart(last->p[3], ph_tc_wanted_point(w, c, in->k + 1)), size,
               INTERPOLATION * size);
}

/* The joint of two cubics on the chord, the part of it before the joint, and
 * the direction there. */
static void check_on_chord(struct ph_tc_check *c, const struct ph_tc_wanted *w,
                           const struct interval *in) {
  ph_cplx from = ph_tc_wanted_point(w, c, in->k);
  ph_cplx along = ph_cplx_sub(ph_tc_wanted_point(w, c, in->k + 1), from);
  ph_cplx joint = ph_cplx_sub(in->cubic[0].p[3], from);
  double length = ph_cplx_abs(along), part = w->joint_position;
  if (isnan(part)) {
    part = ph_cplx_dot(joint, along) / (length * length);
    part = ph_check_larger(0, ph_check_smaller(part, 1));
  }
  ph_check_add(&c->point, in->first, apart(joint, ph_cplx_scale(part, along)),
               c->scale.size, ON_CHORD * length + in->cubic[0].allowance);
  if (!isnan(w->joint_angle)) {
    ph_cplx turned = ph_cplx_mul(ph_cplx_polar(w->joint_angle),
                                 ph_tc_check_direction(along));
    ph_tc_check_tangent(c, &in->cubic[0], in->first, 1, turned, 0);
  }
}

/* What is wanted at both ends of the interval; lengths of derivatives are of
 * pairs alone. */
static void check_ends(struct ph_tc_check *c, const struct ph_tc_wanted *w,
                       const struct interval *in) {
  for (size_t end = 0; end < 2; end++) {
    struct ph_tc_wanted_end wanted = ph_tc_wanted_end_of(w, c, in->k + end);
    size_t i = end == 0 ? 0 : in->n - 1;
    if (wanted.has_direction) {
      ph_tc_check_tangent(c, &in->cubic[i], in->first + i, end,
                          wanted.direction, wanted.error);
    }
    if (wanted.has_length && in->n == 2 && !w->on_chord) {
      ph_tc_check_derivative(c, &in->cubic[i], in->first + i, end,
                             ph_cplx_scale(wanted.length, wanted.direction),
                             wanted.error);
    }
  }
}

static void check_interval(struct ph_tc_check *c, const struct ph_tc_wanted *w,
                           const struct interval *in) {
  for (size_t i = 0; i < in->n; i++) {
    ph_tc_check_cubic(c, &in->cubic[i], in->first + i);
  }
  check_points(c, w, in);
  check_ends(c, w, in);
  if (in->n == 2) {
    ph_tc_check_joint(c, &in->cubic[0], &in->cubic[1], in->first + 1);
  }
  if (in->n == 2 && !w->on_chord) {
    ph_tc_check_c1(c, &in->cubic[0], &in->cubic[1], in->first + 1, 1, 0);
  }
  if (in->n == 2 && w->on_chord) {
    check_on_chord(c, w, in);
  }
}

/* Two intervals: one direction, and one derivative where both have the one that
 * is wanted. */
static void check_between(struct ph_tc_check *c, const struct ph_tc_wanted *w,
                          const struct interval *a, const struct interval *b) {
  const struct ph_tc_cubic *end = &a->cubic[a->n - 1], *start = &b->cubic[0];
  ph_tc_check_joint(c, end, start, b->first);
  if (a->n == 2 && b->n == 2 && !w->on_chord &&
      (w->derivatives || !isnan(w->lambda))) {
    ph_tc_check_c1(c, end, start, b->first, 1, 0);
  }
}

/* Interval k of the data, whose first cubic this is. */
static struct interval load(const struct ph_tc_check *c,
                            const struct ph_tc_wanted *w, size_t k,
                            size_t first) {
  struct interval in = {.k = k, .first = first, .n = count(w, c, k, first)};
  for (size_t i = 0; i < in.n; i++) {
    in.cubic[i] = ph_tc_check_load(c, first + i);
  }
  return in;
}

/* A part of a long chain, and what is found there. */
struct part {
  struct ph_tc_check c;
  size_t first; /* its first cubic */
};

struct parts {
  const struct ph_tc_wanted *w;
  struct part *part;
};

/* Intervals first to end - 1, and where the last of them ends. */
static bool check_part(void *context, size_t thread, size_t first, size_t end) {
  const struct parts *parts = context;
  const struct ph_tc_wanted *w = parts->w;
  struct part *part = &parts->part[first / PART];
  struct ph_tc_check *c = &part->c;
  struct interval now = load(c, w, first, part->first);
  (void)thread;
  for (size_t k = first; k < end && !(k > first && ph_arena_late(c->arena));
       k++) {
    struct interval before = now;
    check_interval(c, w, &before);
    if (k + 1 < w->n) {
      now = load(c, w, k + 1, before.first + before.n);
    } else if (w->closed) {
      now = load(c, w, 0, 0);
    }
    if (k + 1 < w->n || w->closed) {
      check_between(c, w, &before, &now);
    }
  }
  return true;
}

/* In parts, by all threads that there are; where a part begins is found first.
 */
static enum ph_status check_intervals(struct ph_tc_check *c,
                                      const struct ph_tc_wanted *w,
                                      struct ph_arena *scratch,
                                      struct ph_diag *diag) {
  const size_t parts_n = (w->n + PART - 1) / PART;
  struct parts parts = {w,
                        ph_arena_array(scratch, parts_n, sizeof *parts.part)};
  size_t first = 0;
  if (!parts.part) {
    return ph_fail_memory(diag);
  }
  for (size_t k = 0; k < w->n; first += count(w, c, k, first), k++) {
    if (k % PART == 0) {
      parts.part[k / PART] = (struct part){*c, first};
    }
  }
  ph_team_share(scratch, w->n, 2 * PART, PART, check_part, &parts);
  for (size_t i = 0; i < parts_n; i++) {
    ph_tc_check_join(c, &parts.part[i].c);
  }
  return PH_OK;
}

/* Whether there are as many cubics as the mode wants, and their knots are 0, 1,
 * 2, ... */
static enum ph_status check_number(const struct ph_tc_check *c,
                                   const struct ph_tc_wanted *w,
                                   struct ph_diag *diag) {
  size_t n = c->curve->n;
  size_t least = w->mode == PH_TC_WANTED_TWO ? 2 * w->n : w->n;
  size_t most = w->mode == PH_TC_WANTED_ONE ? w->n : 2 * w->n;
  if (n < least || n > most) {
    return ph_fail(diag, PH_E_INTERNAL, "segments",
                   "are %zu for %zu intervals of the data", n, w->n);
  }
  for (size_t k = 0; k <= n; k++) {
    if (!(fabs(c->curve->knots[k] - (double)k) <= 0)) {
      return ph_fail_at(diag, PH_E_INTERNAL, "knots", k,
                        "is %.17g, and not its number", c->curve->knots[k]);
    }
  }
  return PH_OK;
}

/* Whether numbers that are told of the only interval are those of its curve: D
 * of one cubic, whose square is the ratio of its outer legs, and lambda of a
 * pair, the length of its derivatives over the chord. */
static enum ph_status check_claims(const struct ph_tc_check *c,
                                   const struct ph_tc_wanted *w,
                                   const struct ph_diagnostics *diagnostics,
                                   struct ph_diag *diag) {
  const double slack = 1e-9;
  const double *value = diagnostics->value;
  size_t last = c->curve->n - 1;
  struct ph_tc_cubic a = ph_tc_check_load(c, 0);
  struct ph_tc_cubic b = ph_tc_check_load(c, last);
  double first = ph_cplx_abs(a.h[0]), end = ph_cplx_abs(b.h[2]);
  double rounding = a.allowance + b.allowance;
  double square = value[PH_D_RATIO] * value[PH_D_RATIO];
  double chord = apart(b.p[3], a.p[0]), lambda = value[PH_D_LAMBDA];
  if (w->n == 1 && ph_diagnostics_known(diagnostics, PH_D_RATIO) &&
      !(last == 0 &&
        fabs(end - square * first) <= slack * end + (1 + square) * rounding)) {
    return ph_fail(diag, PH_E_INTERNAL, "diagnostics",
                   "D is %.17g, which its legs do not have", value[PH_D_RATIO]);
  }
  if (w->n == 1 && ph_diagnostics_known(diagnostics, PH_D_LAMBDA) && last > 0 &&
      isnan(w->lambda) &&
      !(fabs(first - lambda * chord) <= slack * first + rounding)) {
    return ph_fail(diag, PH_E_INTERNAL, "diagnostics",
                   "lambda is %.17g, which its derivatives do not have",
                   lambda);
  }
  return PH_OK;
}

enum ph_status ph_check_tc(struct ph_check *v,
                           struct ph_diagnostics *diagnostics) {
  const struct ph_problem *problem = v->problem;
  const struct ph_curve *curve = v->curve;
  struct ph_diag *diag = v->diag;
  const struct ph_value *points = &problem->field[PH_F_POINTS];
  struct ph_tc_wanted wanted;
  struct ph_tc_check c;
  enum ph_status status;
  enum ph_tc_wanted_mode mode = ph_tc_wanted_mode_of(problem);
  if (mode == PH_TC_WANTED_APPROXIMATE) {
    return ph_check_tc_approximation(v, diagnostics);
  }
  if (points->kind != PH_VECTORS || points->dimension != 2 || points->n < 2) {
    return ph_fail(diag, PH_E_INTERNAL, "points", "are not in the plane");
  }
  if (mode == PH_TC_WANTED_G2) {
    return ph_check_tc_g2(v, diagnostics);
  }
  status = ph_tc_check_begin(&c, curve, v->scratch, points->v, points->n, diag);
  if (status == PH_OK) {
    status = ph_tc_wanted_of(problem, &c, &wanted, diag);
  }
  if (status == PH_OK) {
    status = check_number(&c, &wanted, diag);
  }
  if (status != PH_OK) {
    return status;
  }
  status = check_intervals(&c, &wanted, v->scratch, diag);
  if (status == PH_OK) {
    status = ph_tc_check_conclude(&c, wanted.all, diagnostics, diag);
  }
  return status == PH_OK ? check_claims(&c, &wanted, diagnostics, diag)
                         : status;
}
