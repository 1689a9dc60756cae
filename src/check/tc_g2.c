/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Curvature at joints of cubics (see tc_g2.h). */
#include "check/tc_g2.h"

#include "check/data.h"
#include "check/tc_check.h"
#include "check/tc_wanted.h"

#include <float.h>

static const double INTERPOLATION = 1e-13;

/* Jumps of the curvature beside the rounding of control points, relative to
 * the larger one; what is listed is the same to this. */
static const double JUMP = 1e-9;

/* ---- curvature ----------------------------------------------------------- */

/* A curvature, and by how much rounding of control points may change it. */
struct bent {
  double k, error;
};

/* At the start of a cubic (end = 0) or its end (1).  Both legs may be off by
 * the allowance d: the cross product by d times their lengths and d, and the
 * length of the near one may be less by d. */
static struct bent bent_at(const struct ph_tc_cubic *s, size_t end) {
  ph_cplx near = s->h[2 * end];
  double d = s->allowance, size = ph_cplx_abs(near), low = size - d;
  double cross =
      ph_cplx_cross(end == 0 ? near : s->h[1], end == 0 ? s->h[1] : near);
  double more = d * (size + ph_cplx_abs(s->h[1]) + d);
  struct bent b = {2 * cross / (size * size * size), HUGE_VAL};
  if (low > 0) {
    b.error = 2 * (fabs(cross) + more) / (low * low * low) - fabs(b.k);
  }
  return b;
}

/* The curvatures at a joint. */
struct joint {
  struct bent before, after;
  double larger; /* of both */
  double error;
  double jump; /* beyond the error; NaN where one is */
};

static struct joint joint_of(const struct ph_tc_cubic *a,
                             const struct ph_tc_cubic *b) {
  struct joint j = {.before = bent_at(a, 1), .after = bent_at(b, 0)};
  j.larger = ph_check_larger(fabs(j.before.k), fabs(j.after.k));
  j.error = j.before.error + j.after.error;
  j.jump = fabs(j.after.k - j.before.k) - j.error;
  j.jump = j.jump <= 0 ? 0 : j.jump;
  return j;
}

/* ---- lists --------------------------------------------------------------- */

/* Joints and added points of a record, gone through in the order of segments.
 */
struct lists {
  const struct ph_g2 *g2;
  size_t joint, auxiliary;
};

/* The joint before segment k that is listed, or NULL. */
static const struct ph_joint *listed(struct lists *l, size_t k) {
  const struct ph_g2 *g2 = l->g2;
  return l->joint < g2->joints_n && g2->joints[l->joint].segment == k
             ? &g2->joints[l->joint++]
             : NULL;
}

/* Whether segment k begins at a point that was added. */
static bool is_added(struct lists *l, size_t k) {
  const struct ph_g2 *g2 = l->g2;
  bool added =
      l->auxiliary < g2->auxiliary_n && g2->auxiliary[l->auxiliary] == k;
  l->auxiliary += added;
  return added;
}

/* Whether all of both lists have been met. */
static bool is_over(const struct lists *l) {
  return l->joint == l->g2->joints_n && l->auxiliary == l->g2->auxiliary_n;
}

/* Whether a side may be straight; where it has no curvature nothing is known of
 * it. */
static bool is_straight(const struct bent *side) {
  return fabs(side->k) <= side->error || isinf(side->error);
}

/* Whether a curvature that is told is that of a side: none, where it leaves the
 * range of numbers; any, where a leg is nothing but rounding. */
static bool is_curvature(const struct ph_tc_check *c, double told,
                         const struct bent *side) {
  double k = ph_pow2_apply(c->scale.from_unit, told);
  double most = 2 * fabs(side->k) + side->error;
  if (isinf(side->error)) {
    return true;
  }
  return isfinite(told)
             ? fabs(k - side->k) <=
                   JUMP * ph_check_larger(fabs(k), fabs(side->k)) + side->error
             : !isfinite(ph_pow2_apply(c->scale.to_unit, most));
}

/*
 * What is wrong with a joint that is listed, or NULL: it is where it is, has
 * these curvatures, and turns to the other side or has a straight one.
 */
static const char *fault_of(const struct ph_tc_check *c,
                            const struct ph_joint *told,
                            const struct joint *found,
                            const struct ph_tc_cubic *b) {
  const struct bent side[2] = {found->before, found->after};
  ph_cplx p = ph_tc_check_scaled(c, told->point);
  ph_cplx off = ph_cplx_sub(p, b->p[0]);
  if (!(ph_cplx_abs(off) <= INTERPOLATION * c->scale.size)) {
    return "is not where its segment begins";
  }
  for (size_t i = 0; i < 2; i++) {
    if (!is_curvature(c, told->curvature[i], &side[i])) {
      return "has a curvature that is not that of its segment";
    }
  }
  if (told->kind != PH_JOINT_TANGENT && told->kind != PH_JOINT_PAIR &&
      !(found->before.k * found->after.k <= 0 || is_straight(&found->before) ||
        is_straight(&found->after))) {
    return "is no inflection, and neither side is straight";
  }
  return NULL;
}

/* ---- the certificate ----------------------------------------------------- */

/* The largest curvature at the joints. */
static double largest_curvature(const struct ph_tc_check *c) {
  double largest = 0;
  for (size_t k = 0; k < c->curve->n; k++) {
    struct ph_tc_cubic s = ph_tc_check_load(c, k);
    largest = ph_check_larger(largest, fabs(bent_at(&s, 0).k));
    largest = ph_check_larger(largest, fabs(bent_at(&s, 1).k));
  }
  return largest > 0 ? largest : 1;
}

/* What the certificate goes through. */
struct walk {
  struct ph_tc_check *c;
  const struct ph_tc_wanted *w;
  struct lists lists;
  struct ph_check_error jump;
  double unit;
  size_t datum; /* the next point of the data */
  const char *fault;
  size_t fault_at; /* of the joints */
};

static void check_datum(struct walk *walk, ph_cplx p, size_t k) {
  struct ph_tc_check *c = walk->c;
  ph_cplx wanted = walk->datum <= walk->w->n
                       ? ph_tc_wanted_point(walk->w, c, walk->datum)
                       : ph_cplx_of((double)NAN, (double)NAN);
  ph_check_add(&c->point, k, ph_cplx_abs(ph_cplx_sub(p, wanted)), c->scale.size,
               INTERPOLATION * c->scale.size);
  walk->datum++;
}

/* Whether a joint that is listed is within an interval of the data. */
static bool is_within(const struct ph_joint *told) {
  return told &&
         (told->kind == PH_JOINT_INFLECTION || told->kind == PH_JOINT_PAIR);
}

/* Between two segments, the second being k. */
static void check_between(struct walk *walk, const struct ph_tc_cubic *a,
                          const struct ph_tc_cubic *b, size_t k) {
  struct joint found = joint_of(a, b);
  const struct ph_joint *told = listed(&walk->lists, k);
  bool added = is_added(&walk->lists, k);
  ph_tc_check_joint(walk->c, a, b, k);
  if (!told) {
    ph_check_add(&walk->jump, k, found.jump, walk->unit,
                 JUMP * found.larger + found.error);
  } else if (!walk->fault) {
    walk->fault = fault_of(walk->c, told, &found, b);
    walk->fault_at = walk->lists.joint - 1;
  }
  if (!added && !is_within(told) && k > 0) {
    check_datum(walk, b->p[0], k);
  }
}

static void check_ends(struct walk *walk) {
  const struct ph_value *given = &walk->w->problem->field[PH_F_END_TANGENTS];
  size_t last = walk->c->curve->n - 1;
  for (size_t end = 0; given->kind != PH_ABSENT && end < 2; end++) {
    struct ph_tc_cubic s = ph_tc_check_load(walk->c, end * last);
    struct ph_tc_wanted_end wanted =
        ph_tc_wanted_end_of(walk->w, walk->c, end * walk->w->n);
    ph_tc_check_tangent(walk->c, &s, end * last, end, wanted.direction,
                        wanted.error);
  }
}

static void check_segments(struct walk *walk) {
  const struct ph_curve *curve = walk->c->curve;
  struct ph_tc_cubic before = ph_tc_check_load(walk->c, curve->n - 1), now;
  check_datum(walk, ph_tc_check_load(walk->c, 0).p[0], 0);
  for (size_t k = 0; k < curve->n; k++) {
    if (k > 0 && ph_arena_late(walk->c->arena)) {
      return;
    }
    now = ph_tc_check_load(walk->c, k);
    ph_tc_check_cubic(walk->c, &now, k);
    if (k > 0 || curve->closed) {
      check_between(walk, &before, &now, k);
    }
    before = now;
  }
  check_datum(walk, before.p[3], curve->n - 1);
  if (!curve->closed) {
    check_ends(walk);
  }
}

static enum ph_status check_knots(const struct ph_curve *curve,
                                  struct ph_diag *diag) {
  for (size_t k = 0; k <= curve->n; k++) {
    if (!(fabs(curve->knots[k] - (double)k) <= 0)) {
      return ph_fail_at(diag, PH_E_INTERNAL, "knots", k,
                        "is %.17g, and not its number", curve->knots[k]);
    }
  }
  return PH_OK;
}

static enum ph_status conclude(struct walk *walk,
                               struct ph_diagnostics *diagnostics,
                               struct ph_diag *diag) {
  const struct ph_check_error *const list[] = {&walk->jump};
  enum ph_status status =
      ph_tc_check_conclude(walk->c, false, diagnostics, diag);
  if (status == PH_OK) {
    status = ph_check_conclude(list, 1, diagnostics, diag);
  }
  if (status == PH_OK && walk->fault) {
    return ph_fail_at(diag, PH_E_INTERNAL, "joints", walk->fault_at, "%s",
                      walk->fault);
  }
  if (status == PH_OK &&
      (!is_over(&walk->lists) || walk->datum != walk->w->n + 1)) {
    return ph_fail(diag, PH_E_INTERNAL, "segments",
                   "do not fit the points of the data");
  }
  return status;
}

enum ph_status ph_check_tc_g2(struct ph_check *v,
                              struct ph_diagnostics *diagnostics) {
  const struct ph_value *points = &v->problem->field[PH_F_POINTS];
  struct ph_tc_wanted wanted;
  struct ph_tc_check c;
  struct walk walk = {.c = &c,
                      .w = &wanted,
                      .lists = {.g2 = &v->curve->g2},
                      .jump = {.what = PH_D_G2_ERROR, .done = true}};
  enum ph_status status = ph_tc_check_begin(&c, v->curve, v->scratch, points->v,
                                            points->n, v->diag);
  if (status == PH_OK) {
    status = ph_tc_wanted_of(v->problem, &c, &wanted, v->diag);
  }
  if (status == PH_OK) {
    status = check_knots(v->curve, v->diag);
  }
  if (status != PH_OK) {
    return status;
  }
  walk.unit = largest_curvature(&c);
  check_segments(&walk);
  return conclude(&walk, diagnostics, v->diag);
}

/* ---- records ------------------------------------------------------------- */

/* Whether the record, or the problem that it solves, promises it. */
static bool is_promised(const struct ph_check *v) {
  return ph_check_known(v, PH_D_G2_ERROR) ||
         (v->problem && ph_tc_wanted_mode_of(v->problem) == PH_TC_WANTED_G2);
}

/* Between two segments of a record, the second being k.  ret the jump, where
 * none is listed */
static double verify_between(struct ph_check *v, const struct ph_tc_check *c,
                             struct lists *lists, const struct ph_tc_cubic *a,
                             const struct ph_tc_cubic *b, size_t k) {
  struct joint found = joint_of(a, b);
  const struct ph_joint *told = listed(lists, k);
  const char *fault;
  is_added(lists, k);
  if (!told) {
    ph_check_miss(v, PH_CHECK_CONTINUITY, ph_check_in(k, "control_points"),
                  found.jump, found.larger, 0, "let the curvature jump");
    return found.jump;
  }
  fault = fault_of(c, told, &found, b);
  if (fault) {
    ph_check_wrong(v, PH_CHECK_CONTINUITY,
                   ph_check_of("joints", lists->joint - 1, NULL), fault);
  }
  return 0;
}

void ph_check_curvature(struct ph_check *v) {
  const struct ph_curve *curve = v->curve;
  struct lists lists = {.g2 = &curve->g2};
  struct ph_tc_check c;
  struct ph_tc_cubic before, now;
  double largest = 0;
  if (!is_promised(v) ||
      ph_tc_check_begin(&c, curve, v->scratch, curve->control_points,
                        ph_curve_points_n(curve), v->diag) != PH_OK) {
    return;
  }
  before = ph_tc_check_load(&c, curve->n - 1);
  for (size_t k = 0; k < curve->n; k++) {
    now = ph_tc_check_load(&c, k);
    if (k > 0 || curve->closed) {
      largest = ph_check_larger(
          largest, verify_between(v, &c, &lists, &before, &now, k));
    }
    before = now;
  }
  if (!is_over(&lists)) {
    ph_check_wrong(
        v, PH_CHECK_CONTINUITY,
        ph_check_of(lists.joint < curve->g2.joints_n ? "joints" : "auxiliary",
                    PH_CHECK_ONE, NULL),
        "are not segments in their order");
  }
  if (ph_check_known(v, PH_D_G2_ERROR)) {
    double claimed = v->diagnostics->value[PH_D_G2_ERROR];
    ph_check_miss(v, PH_CHECK_DIAGNOSTIC,
                  ph_check_of("diagnostics", PH_CHECK_ONE,
                              ph_diagnostic_name(PH_D_G2_ERROR)),
                  ph_check_larger(largest / largest_curvature(&c) - claimed, 0),
                  1, JUMP, "is less than what the curvature jumps by");
  }
}
