/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The certificate of spherical nu-splines (see certify.h).
 *
 * Control points are brought to the unit sphere; knots, which are a matter of
 * the data, are compared with the record's and then used as they should be.
 * Between segments the velocities v by the knots and the covariant
 * accelerations A, on both sides of a node, are (derived in sphere_segment.c)
 *
 *   continuity   v+ = v-                                                  (1)
 *   exact        A+ - A- = nu v, whence the curvature is continuous       (2)
 *   nielson      with theta_k h- and theta_k h+ beyond the segments on both
 *                sides of it, the great circles of the inner legs meet in the
 *                global control point d_k [IOR15, sec. 3.2]:
 *                G[R-,L-](1 + gamma h+ / h-) = G[R+,L+](-gamma h- / h+),
 *                gamma = s / (nu h- h+ + s), s = 2 (h- + h+)               (3)
 *
 * An error may be as large as rounding of the control points can make it.
 */
#include "check/certify.h"

#include "base/sum.h"
#include "check/data.h"
#include "check/error.h"
#include "check/shape_sphere.h"
#include "check/spherical.h"
#include "kernel/degree.h"

#include <float.h>

/* Tolerances.  Points on the sphere and at the data, in units of the rounding
 * of a point; the same for the directions and legs at the ends. */
static const double ROUND_POINT = 8, ROUND_TENSION = 16;

/* Relative: the solver leaves the rounding of a few operations. */
static const double CONTINUITY = 1e-12, END = 1e-12;
static const double SUM = 1e-12, KNOT = 8 * DBL_EPSILON;

/* Of models whose equations are those of the data, relative to their angles;
 * (2) is solved to this, relative to its largest terms. */
static const double SOLVED = 1e-12;

/* What a curvature may jump by, beside what rounding makes of it. */
static const double JUMP = 1e-10;

/* A leg shorter than this many of its errors has no direction. */
static const double NO_DIRECTION = 4;

enum knots { GEODESIC, UNIFORM, NUMBERS };
enum ends { NATURAL, REST, CLAMPED };

struct context {
  const struct ph_arena *arena; /* knows how much time there is */
  const struct ph_problem *problem;
  const struct ph_curve *curve;
  const struct ph_value *points;
  bool lonlat, exact;
  struct ph_pow2 to_unit;
  ph_vec3 center; /* at unit scale, as is */
  double radius;
  double rounding; /* of a point of the unit sphere */
  double size;     /* of the data, at most 1 */
  double moved;    /* allowed of the data, relative */
  enum knots knots;
  enum ends ends;
  double mean;          /* angle */
  double farthest_knot; /* from 0, whose rounding is the largest */
  struct ph_check_nu_rule rule;
};

struct checks {
  struct ph_check_error sphere, point, joint, end, jump, length, tension;
  struct ph_sum lengths;
  struct ph_check_nu_tensions tensions;
  double curvature; /* the largest at a node */
  bool shape_ok;
  enum ph_check_nu_fault fault; /* the first that was not waived */
  size_t fault_at;
};

static bool is_false(const struct ph_value *value) {
  return value->kind == PH_BOOL && !value->flag;
}

/* ---- the unit sphere ------------------------------------------------- */

/* A vector relative to the center, by the radius. */
static ph_vec3 relative(const struct context *c, const double *v) {
  ph_vec3 d = ph_vec3_of(ph_pow2_apply(c->to_unit, v[0]) - c->center.x,
                         ph_pow2_apply(c->to_unit, v[1]) - c->center.y,
                         ph_pow2_apply(c->to_unit, v[2]) - c->center.z);
  return ph_vec3_of(d.x / c->radius, d.y / c->radius, d.z / c->radius);
}

/* The length of a curve on the unit sphere. */
static double on_unit(const struct context *c, double length) {
  return ph_pow2_apply(c->to_unit, length) / c->radius;
}

static ph_vec3 joint_at(const struct context *c, size_t k) {
  return ph_vec3_unit(relative(c, c->curve->control_points + 12 * k));
}

/* Datum i on the sphere, and by how much it is off. */
static ph_vec3 datum_at(const struct context *c, size_t i, double *off) {
  const double *v = c->points->v + c->points->dimension * i;
  ph_vec3 u;
  double size;
  *off = 0;
  if (c->lonlat) {
    return ph_degree_to_unit(v[0], v[1]);
  }
  u = relative(c, v);
  size = ph_vec3_abs(u);
  *off = fabs(size - 1);
  return ph_vec3_scale(1 / size, u);
}

/* The spacing of knots of a segment, from the data. */
static double spacing_of(const struct context *c,
                         const struct ph_check_nu_segment *s, size_t k) {
  const double *t = c->problem->field[PH_F_KNOTS].v;
  return c->knots == NUMBERS   ? t[k + 1] - t[k]
         : c->knots == UNIFORM ? c->mean
                               : s->angle;
}

/* ---- one segment ----------------------------------------------------- */

static void load_segment(const struct context *c, size_t k,
                         struct checks *checks, struct ph_check_nu_segment *s) {
  ph_vec3 p[4];
  for (size_t i = 0; i < 4; i++) {
    ph_vec3 u = relative(c, c->curve->control_points + 12 * k + 3 * i);
    double size = ph_vec3_abs(u);
    ph_check_add(&checks->sphere, k, fabs(size - 1), 1,
                 ROUND_POINT * c->rounding);
    p[i] = ph_vec3_scale(1 / size, u);
  }
  ph_check_nu_segment_of(p, c->rounding, s);
}

/* The data at both ends; a repeated last point of closed data may be read
 * again in place of the first. */
static enum ph_status check_points(const struct context *c,
                                   const struct ph_check_nu_segment *s,
                                   size_t k, struct ph_check_error *point,
                                   struct ph_diag *diag) {
  for (size_t end = 0; end < 2; end++) {
    size_t i = k + end < c->points->n ? k + end : 0;
    double off;
    ph_vec3 datum = datum_at(c, i, &off);
    if (!(off <= c->moved + ROUND_POINT * c->rounding)) {
      return ph_fail_at(diag, PH_E_NO_CONVERGENCE, "points", i,
                        "is not on the sphere: it was moved by %.3g of the "
                        "radius, at most %.3g is allowed",
                        off, c->moved);
    }
    ph_check_add(point, k, ph_vec3_abs(ph_vec3_sub(s->p[3 * end], datum)),
                 c->size, ROUND_POINT * c->rounding);
  }
  return PH_OK;
}

static enum ph_status check_knots(const struct context *c, double h, size_t k,
                                  struct ph_diag *diag) {
  const double *t = c->curve->knots;
  double allowed = KNOT * c->farthest_knot +
                   (c->knots == NUMBERS ? 0 : ROUND_POINT * c->rounding);
  if (!(fabs(t[k + 1] - t[k] - h) <= allowed)) {
    return ph_fail_at(diag, PH_E_NO_CONVERGENCE, "segments", k,
                      "is refused by its certificate: its knots are %.10g "
                      "apart, and should be %.10g",
                      t[k + 1] - t[k], h);
  }
  return PH_OK;
}

static void check_length(const struct context *c,
                         const struct ph_check_nu_segment *s, size_t k,
                         struct checks *checks) {
  double claimed = on_unit(c, c->curve->lengths[k]);
  double allowed = ph_check_nu_allowed(s, claimed);
  double length = ph_check_nu_length(s, claimed, allowed);
  ph_check_add(&checks->length, k, fabs(length - claimed),
               on_unit(c, c->curve->length), allowed);
  ph_sum_add(&checks->lengths, claimed);
}

/* ---- ends of open curves --------------------------------------------- */

/* The direction of the curve at one of its ends, and its error. */
static ph_vec3 end_direction(const struct context *c, ph_vec3 p, size_t end,
                             double *error) {
  const double *v = c->problem->field[PH_F_END_TANGENTS].v + 3 * end;
  ph_vec3 given = ph_check_direction(v, 3);
  ph_vec3 along = ph_vec3_normal(given, p);
  double size = ph_vec3_abs(along);
  *error = ROUND_POINT * c->rounding / size;
  return ph_vec3_unit(ph_vec3_normal(ph_vec3_scale(1 / size, along), p));
}

static void check_end(const struct context *c,
                      const struct ph_check_nu_segment *s, size_t k, size_t end,
                      struct ph_check_error *check) {
  const struct ph_check_nu_end *e = &s->end[end];
  ph_vec3 inner = s->p[end == 0 ? 2 : 1], next = s->p[end == 0 ? 1 : 2];
  ph_vec3 miss = e->leg;
  double allowed = END * s->angle + ROUND_POINT * c->rounding;
  if (c->ends == CLAMPED) {
    double error, size = s->angle / 3;
    ph_vec3 direction = end_direction(c, e->at, end, &error);
    miss = ph_vec3_along(e->leg, end == 0 ? -size : size, direction);
    allowed += size * error;
  } else if (c->ends == NATURAL) {
    ph_vec3 sum = ph_vec3_add(e->at, inner);
    miss = ph_vec3_sub(next, ph_vec3_unit(sum));
    allowed += ROUND_POINT * c->rounding / ph_vec3_abs(sum);
  }
  ph_check_add(check, k, ph_vec3_abs(miss), s->angle, allowed);
}

/* ---- nodes ----------------------------------------------------------- */

/* A node between two segments, with the spacings on both sides. */
struct node {
  const struct ph_check_nu_segment *left, *right;
  double hl, hr;
  size_t i;
};

/* (1), in the unit of the shorter spacing. */
static void check_velocity(const struct context *c, const struct node *n,
                           struct ph_check_error *joint) {
  const struct ph_check_nu_end *a = &n->left->end[1], *b = &n->right->end[0];
  double h = ph_check_smaller(n->hl, n->hr), fa = h / n->hl, fb = h / n->hr;
  ph_vec3 jump = ph_vec3_along(ph_vec3_scale(fa, a->leg), fb, b->leg);
  double speed = ph_check_larger(fa * a->angle, fb * b->angle);
  double allowed = CONTINUITY * speed + fa * a->leg_error + fb * b->leg_error;
  if (!c->exact) {
    allowed += SOLVED * ph_check_smaller(n->left->angle, n->right->angle);
  }
  if (!(speed <= allowed)) {
    ph_check_add(joint, n->i, ph_vec3_abs(jump), speed, allowed);
  }
}

/* The curvature on both sides, where the curve does not stand still. */
static void check_curvature(const struct context *c, const struct node *n,
                            struct checks *checks) {
  const struct ph_check_nu_end *a = &n->left->end[1], *b = &n->right->end[0];
  double before = -a->curvature, after = b->curvature;
  double size = ph_check_larger(1, ph_check_larger(fabs(before), fabs(after)));
  double allowed = JUMP * size + a->curvature_error + b->curvature_error;
  if (!(a->angle <= NO_DIRECTION * a->leg_error) &&
      !(b->angle <= NO_DIRECTION * b->leg_error)) {
    ph_check_add(&checks->jump, n->i, fabs(after - before), size,
                 c->exact ? allowed : HUGE_VAL);
    checks->curvature = ph_check_larger(
        checks->curvature, ph_check_larger(fabs(before), fabs(after)));
  }
}

/* (2) */
static void check_exact(const struct node *n, double nu,
                        struct ph_check_error *tension) {
  const struct ph_check_nu_end *a = &n->left->end[1], *b = &n->right->end[0];
  double fa = 1 / (n->hl * n->hl), fb = 1 / (n->hr * n->hr);
  double speed =
      ph_check_larger(n->left->angle / n->hl, n->right->angle / n->hr);
  double unit = (4 / n->hl + 4 / n->hr + fabs(nu)) * speed;
  ph_vec3 miss =
      ph_vec3_along(ph_vec3_scale(fb, b->acceleration), -fa, a->acceleration);
  miss = ph_vec3_along(miss, -3 * nu / n->hr, b->leg);
  ph_check_add(tension, n->i, ph_vec3_abs(miss), unit,
               SOLVED * unit + fa * a->acceleration_error +
                   fb * b->acceleration_error +
                   3 * fabs(nu) / n->hr * b->leg_error);
}

/* (3) */
static void check_nielson(const struct context *c, const struct node *n,
                          double nu, struct ph_check_error *tension) {
  double s = 2 * (n->hl + n->hr), gamma = s / (nu * n->hl * n->hr + s);
  double factor = 0;
  ph_vec3 d = ph_check_great_beyond(n->left->p, n->left->x,
                                    1 + gamma * n->hr / n->hl, &factor);
  ph_vec3 miss =
      ph_vec3_sub(d, ph_check_great_beyond(n->right->p, n->right->x,
                                           -gamma * n->hl / n->hr, &factor));
  ph_check_add(tension, n->i, ph_vec3_abs(miss), 1,
               SOLVED * ph_check_smaller(n->left->angle, n->right->angle) +
                   ROUND_TENSION * c->rounding * factor);
}

/* With shape=false the tensions are those of the problem. */
static bool is_given_tension(const struct context *c, size_t i) {
  const struct ph_value *given = &c->problem->field[PH_F_TENSION];
  double nu = c->curve->sphere.tensions[i];
  double wanted = given->kind == PH_NUMBER    ? given->number
                  : given->kind == PH_NUMBERS ? given->v[i]
                                              : 0;
  return !is_false(&c->problem->field[PH_F_SHAPE]) ||
         fabs(nu - wanted) <= DBL_EPSILON * wanted;
}

static void add_fault(const struct context *c, struct checks *checks,
                      enum ph_check_nu_fault fault, size_t where) {
  if (fault == PH_CHECK_NU_NO_FAULT) {
    return;
  }
  checks->shape_ok = false;
  if (checks->fault == PH_CHECK_NU_NO_FAULT &&
      (c->problem->field[PH_F_SHAPE].kind == PH_BOOL ||
       !ph_check_nu_is_waived(&c->curve->sphere, where))) {
    checks->fault = fault;
    checks->fault_at = where;
  }
}

static enum ph_status check_node(const struct context *c, const struct node *n,
                                 struct checks *checks, struct ph_diag *diag) {
  double nu = c->curve->sphere.tensions[n->i];
  struct ph_check_nu_node data = {.left = n->left,
                                  .right = n->right,
                                  .spacing = n->hr,
                                  .indicator =
                                      c->curve->sphere.indicators[n->i]};
  check_velocity(c, n, &checks->joint);
  check_curvature(c, n, checks);
  if (c->exact) {
    check_exact(n, nu, &checks->tension);
  } else {
    check_nielson(c, n, nu, &checks->tension);
  }
  ph_check_nu_add_tension(&checks->tensions, c->curve, n->i);
  ph_check_nu_node_turn(&data, c->rule.epsilon);
  add_fault(c, checks, ph_check_nu_node_fault(&data, &c->rule), n->i);
  if (!ph_check_nu_node_indicates(&data)) {
    return ph_fail_at(diag, PH_E_NO_CONVERGENCE, "indicators", n->i,
                      "is refused by its certificate: it is %d where the data "
                      "turn by an angle of sine %.3g, and up to %.3g is none",
                      data.indicator, data.sine, data.limit);
  }
  if (!is_given_tension(c, n->i)) {
    return ph_fail_at(diag, PH_E_NO_CONVERGENCE, "tensions", n->i,
                      "is refused by its certificate: %.17g is not what was "
                      "given",
                      nu);
  }
  return PH_OK;
}

/* ---- the curve ------------------------------------------------------- */

static enum ph_status check_segment(const struct context *c,
                                    const struct ph_check_nu_segment *s,
                                    double h, size_t k, struct checks *checks,
                                    struct ph_diag *diag) {
  const struct ph_curve *curve = c->curve;
  size_t to = curve->closed && k + 1 == curve->n ? 0 : k + 1;
  enum ph_status status = check_points(c, s, k, &checks->point, diag);
  if (status == PH_OK) {
    status = check_knots(c, h, k, diag);
  }
  check_length(c, s, k, checks);
  add_fault(c, checks,
            ph_check_nu_segment_fault(s, curve->sphere.indicators[k],
                                      curve->sphere.indicators[to]),
            k);
  if (!curve->closed && k == 0) {
    check_end(c, s, k, 0, &checks->end);
  }
  if (!curve->closed && k + 1 == curve->n) {
    check_end(c, s, k, 1, &checks->end);
  }
  return status;
}

static enum ph_status check_curve(struct context *c, struct checks *checks,
                                  struct ph_diag *diag) {
  const struct ph_curve *curve = c->curve;
  struct ph_check_nu_segment first, s[2];
  struct node node = {.hl = 0};
  double h = 0, h0 = 0;
  enum ph_status status = PH_OK;
  for (size_t k = 0; k < curve->n && status == PH_OK; k++) {
    struct ph_check_nu_segment *now = &s[k & 1];
    load_segment(c, k, checks, now);
    node = (struct node){&s[~k & 1], now, h, spacing_of(c, now, k), k};
    h = node.hr;
    if (k == 0) {
      first = *now;
      h0 = h;
      c->rule.first = now->angle;
    } else {
      status = check_node(c, &node, checks, diag);
    }
    if (ph_arena_late(c->arena)) {
      status = ph_fail_memory(diag);
    }
    if (status == PH_OK) {
      status = check_segment(c, now, h, k, checks, diag);
    }
  }
  if (curve->closed && status == PH_OK) {
    node = (struct node){&s[~curve->n & 1], &first, h, h0, 0};
    status = check_node(c, &node, checks, diag);
  }
  return status;
}

static enum ph_status check_tension(const struct context *c,
                                    const struct ph_check_error *tension,
                                    struct ph_diag *diag) {
  if (tension->excess <= 1) {
    return PH_OK;
  }
  return ph_fail_at(diag, PH_E_NO_CONVERGENCE, "tensions", tension->where,
                    "is refused by its certificate: the curve is not that of "
                    "%.10g, it misses its equation by %.3g, at most %.3g is "
                    "allowed",
                    c->curve->sphere.tensions[tension->where], tension->value,
                    tension->allowed);
}

static enum ph_status check_shape(const struct context *c,
                                  const struct checks *checks,
                                  struct ph_diag *diag) {
  const struct ph_value *shape = &c->problem->field[PH_F_SHAPE];
  if (checks->fault == PH_CHECK_NU_NO_FAULT || is_false(shape)) {
    return PH_OK;
  }
  return ph_fail_at(
      diag, PH_E_NO_CONVERGENCE,
      checks->fault == PH_CHECK_NU_CONVEXITY ? "segments" : "points",
      checks->fault_at,
      "is refused by its certificate: %s is asked for, but %s does not hold",
      ph_field_name(PH_F_SHAPE), ph_check_nu_fault_name(checks->fault));
}

static enum ph_status conclude(const struct context *c, struct checks *checks,
                               struct ph_diagnostics *diagnostics,
                               struct ph_diag *diag) {
  const struct ph_check_error *const list[] = {
      &checks->sphere, &checks->point,
      &checks->joint,  c->curve->closed ? NULL : &checks->end,
      &checks->jump,   &checks->length};
  double total = on_unit(c, c->curve->length);
  enum ph_status status;
  ph_check_add(&checks->length, c->curve->n - 1,
               fabs(ph_sum_value(&checks->lengths) - total), total,
               SUM * total);
  status = ph_check_conclude(list, 6, diagnostics, diag);
  if (status != PH_OK) {
    return status;
  }
  status = check_tension(c, &checks->tension, diag);
  if (status == PH_OK) {
    status = check_shape(c, checks, diag);
  }
  ph_diagnostics_set(diagnostics, PH_D_SHAPE_OK,
                     checks->shape_ok && c->curve->sphere.waived_n == 0);
  ph_diagnostics_set_finite(diagnostics, PH_D_TENSION_SUM,
                            ph_sum_value(&checks->tensions.sum));
  ph_diagnostics_set_finite(diagnostics, PH_D_TENSION_RELATIVE_SUM,
                            ph_sum_value(&checks->tensions.relative));
  ph_diagnostics_set_finite(diagnostics, PH_D_MAX_TENSION_RELATIVE,
                            checks->tensions.largest);
  ph_diagnostics_set_finite(diagnostics, PH_D_MAX_CURVATURE,
                            checks->curvature / c->curve->sphere.radius);
  return status;
}

/* ---- the problem ----------------------------------------------------- */

static double number_or(const struct ph_value *value, double standard) {
  return value->kind == PH_NUMBER ? value->number : standard;
}

/* What the problem asks for; false when the curve cannot be an answer. */
static bool read_problem(struct context *c) {
  const struct ph_value *field = c->problem->field;
  const struct ph_value *knots = &field[PH_F_KNOTS], *ends = &field[PH_F_ENDS],
                        *tangents = &field[PH_F_END_TANGENTS],
                        *tension = &field[PH_F_TENSION];
  const struct ph_curve *curve = c->curve;
  size_t n = curve->closed ? curve->n : curve->n + 1;
  c->lonlat = field[PH_F_LONLAT].kind == PH_VECTORS;
  c->points = &field[c->lonlat ? PH_F_LONLAT : PH_F_POINTS];
  c->exact = !ph_value_is(&field[PH_F_MODEL], "nielson");
  c->moved = number_or(&field[PH_F_RADIUS_TOLERANCE], 1e-3);
  c->rule.epsilon = number_or(&field[PH_F_EPSILON], 0.01);
  c->rule.legacy = ph_value_is(&field[PH_F_CRITERION], "legacy");
  c->knots = knots->kind == PH_NUMBERS       ? NUMBERS
             : ph_value_is(knots, "uniform") ? UNIFORM
                                             : GEODESIC;
  c->ends = ph_value_is(ends, "rest") ? REST
            : ph_value_is(ends, "clamped") ||
                    (ends->kind == PH_ABSENT && tangents->kind == PH_VECTORS)
                ? CLAMPED
                : NATURAL;
  return curve->closed == field[PH_F_CLOSED].flag && curve->sphere.tensions &&
         curve->sphere.indicators && c->points->kind == PH_VECTORS &&
         c->points->dimension == (c->lonlat ? 2u : 3u) &&
         (c->points->n == n || (curve->closed && c->points->n == n + 1)) &&
         (c->knots != NUMBERS || knots->n == curve->n + 1) &&
         (tension->kind != PH_NUMBERS || tension->n >= n) &&
         (c->ends != CLAMPED || curve->closed ||
          (tangents->kind == PH_VECTORS && tangents->n == 2 &&
           tangents->dimension == 3));
}

/* The sphere of the curve is that of the problem. */
static bool is_sphere(const struct context *c) {
  const struct ph_value *center = &c->problem->field[PH_F_CENTER];
  double radius = number_or(&c->problem->field[PH_F_RADIUS], 1);
  bool same = c->curve->sphere.radius > 0 && isfinite(radius) &&
              c->curve->sphere.radius <= radius &&
              c->curve->sphere.radius >= radius;
  for (size_t i = 0; i < 3; i++) {
    double at = center->kind == PH_NUMBERS && center->n == 3 ? center->v[i] : 0;
    same = same && c->curve->sphere.center[i] <= at &&
           c->curve->sphere.center[i] >= at;
  }
  return same;
}

/* The scale of everything, and what rounding can do. */
static bool set_scale(struct context *c) {
  const struct ph_curve *curve = c->curve;
  struct ph_check_scale scale;
  struct ph_sum sum = {0, 0};
  double farthest;
  if (!ph_check_scale_of(curve->control_points, 4 * curve->n, 3, &scale)) {
    return false;
  }
  c->to_unit = scale.to_unit;
  c->center = ph_vec3_of(ph_pow2_apply(c->to_unit, curve->sphere.center[0]),
                         ph_pow2_apply(c->to_unit, curve->sphere.center[1]),
                         ph_pow2_apply(c->to_unit, curve->sphere.center[2]));
  c->radius = ph_pow2_apply(c->to_unit, curve->sphere.radius);
  farthest = ph_check_larger(fabs(c->center.x), fabs(c->center.y));
  farthest = ph_check_larger(farthest, fabs(c->center.z)) / c->radius;
  c->rounding = DBL_EPSILON * (3 + farthest) + scale.spacing / c->radius;
  c->size = ph_check_smaller(1, scale.size / c->radius);
  c->farthest_knot =
      ph_check_larger(fabs(curve->knots[0]), fabs(curve->knots[curve->n]));
  for (size_t k = 0; c->knots == UNIFORM && k < curve->n; k++) {
    ph_vec3 end = ph_vec3_unit(relative(c, curve->control_points + 12 * k + 9));
    ph_sum_add(&sum, ph_s2_angle(joint_at(c, k), end));
  }
  c->mean = ph_sum_value(&sum) / (double)curve->n;
  return true;
}

enum ph_status ph_check_sphere(struct ph_check *v,
                               struct ph_diagnostics *diagnostics) {
  const struct ph_problem *problem = v->problem;
  const struct ph_curve *curve = v->curve;
  struct ph_diag *diag = v->diag;
  struct context c = {.arena = v->scratch, .problem = problem, .curve = curve};
  struct checks checks = {.sphere = {.what = PH_D_SPHERE_ERROR},
                          .point = {.what = PH_D_INTERPOLATION_ERROR},
                          .joint = {.what = PH_D_CONTINUITY_ERROR},
                          .end = {.what = PH_D_END_DERIVATIVE_ERROR},
                          .jump = {.what = PH_D_CURVATURE_JUMP},
                          .length = {.what = PH_D_LENGTH_ERROR},
                          .shape_ok = true};
  enum ph_status status;
  if (!read_problem(&c)) {
    return ph_fail(diag, PH_E_INTERNAL, "segments",
                   "are not one for each pair of neighbouring points");
  }
  if (!is_sphere(&c)) {
    return ph_fail(diag, PH_E_INTERNAL, "radius",
                   "or center is not that of the problem");
  }
  if (!ph_are_finite(curve->sphere.tensions, curve->n + !curve->closed)) {
    return ph_fail(diag, PH_E_TOO_LARGE, "tensions",
                   "exceed the range of a double");
  }
  if (!ph_check_nu_waived_fit(&curve->sphere, curve->n)) {
    return ph_fail(diag, PH_E_INTERNAL, "waived",
                   "are not points in their order");
  }
  if (!set_scale(&c)) {
    return ph_fail(diag, PH_E_INTERNAL, "points", "have no extent");
  }
  status = check_curve(&c, &checks, diag);
  status = status == PH_OK ? conclude(&c, &checks, diagnostics, diag) : status;
  if (status == PH_E_NO_CONVERGENCE && !c.exact) {
    ph_diag_add(diag, "--model=exact finds a spline as a rule");
  }
  return status;
}
