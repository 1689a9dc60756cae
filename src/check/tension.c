/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Spherical nu-splines: that the curvature jumps by no more than is said, and
 * that tensions are those of the curve.  With velocities v and covariant
 * accelerations A by the knots, on both sides of a node [IOR15, sec. 3.2],
 *
 *   exact    A+ - A- = nu v                                             (1)
 *   nielson  the great circles of the inner legs on both sides meet where
 *            G[R-,L-](1 + gamma h+ / h-) = G[R+,L+](-gamma h- / h+),
 *            gamma = s / (nu h- h+ + s), s = 2 (h- + h+)                (2)
 *
 * Which of them, the problem says; without it, the one that fits better.
 */
#include "check/checks.h"

#include "base/sum.h"
#include "check/shape_sphere.h"
#include "check/spherical.h"

/* Roundings of a point in (2), whose angles add up. */
static const double ROUND_NIELSON = 64;

/* A control point fits to 1e-14 of the radius and no better, however near it is
 * to its node: S' of a segment to three times that. */
static const double SOLVED = 3e-14;

enum model { EXACT, NIELSON, MODELS };

/* The worst of a model. */
struct worst {
  double error; /* relative, and less what rounding explains */
  size_t node;
};

struct context {
  struct ph_check *v;
  struct worst worst[MODELS];
  double jump;       /* of the curvature, */
  double jump_error; /* its rounding, and */
  double curvature;  /* the largest at a node; 1/unit of the sphere */
  double curvature_error;
  struct ph_check_nu_tensions tensions;
  double relative_error; /* what rounding of knots makes of the relative ones */
  double rounding;       /* of a point of the unit sphere */
};

/* One side of a node. */
struct side {
  const struct ph_check_segment *s;
  double h;
  ph_vec3 velocity, acceleration; /* by the knots */
  double curvature;
  double velocity_error, acceleration_error, curvature_error;
};

static struct side side_of(const struct context *c,
                           const struct ph_check_segment *s, double u) {
  struct side side = {.s = s, .h = s->spacing};
  double h = s->spacing, speed, noise = s->noise / s->radius;
  double next = PH_CHECK_ROUND_NEXT * noise, second;
  ph_vec3 jet[3], across;
  ph_check_great(s->p, s->x, u, jet);
  speed = ph_vec3_abs(jet[1]);
  second = ph_vec3_abs(jet[2]);
  across = ph_vec3_along(jet[2], speed * speed, jet[0]);
  side.velocity = ph_vec3_scale(1 / h, jet[1]);
  side.acceleration = ph_vec3_scale(1 / (h * h), across);
  side.velocity_error = (noise + SOLVED) / h + c->v->knot * speed / (h * h);
  side.acceleration_error =
      next / (h * h) + 2 * c->v->knot * second / (h * h * h);
  side.curvature = ph_vec3_dot(jet[0], ph_vec3_cross(jet[1], jet[2])) /
                   (speed * speed * speed);
  side.curvature_error = (next + 4 * second * noise / speed) / (speed * speed);
  return side;
}

/* ---- (1) and (2) -------------------------------------------------------- */

static void add(struct worst *worst, size_t node, double miss, double unit,
                double allowance) {
  double error = ph_check_excess(miss, unit, allowance);
  if (!(error <= worst->error)) {
    worst->error = error;
    worst->node = node;
  }
}

static void check_exact(struct context *c, size_t node, double nu,
                        const struct side *a, const struct side *b) {
  double speed =
      ph_check_larger(ph_vec3_abs(a->velocity), ph_vec3_abs(b->velocity));
  double unit = (4 / a->h + 4 / b->h + fabs(nu)) * speed;
  ph_vec3 miss = ph_vec3_sub(b->acceleration, a->acceleration);
  miss = ph_vec3_along(miss, -nu, b->velocity);
  add(&c->worst[EXACT], node, ph_vec3_abs(miss), unit,
      a->acceleration_error + b->acceleration_error +
          fabs(nu) * b->velocity_error);
}

static void check_nielson(struct context *c, size_t node, double nu,
                          const struct side *a, const struct side *b) {
  double s = 2 * (a->h + b->h), gamma = s / (nu * a->h * b->h + s);
  double factor = 0;
  ph_vec3 left =
      ph_check_great_beyond(a->s->p, a->s->x, 1 + gamma * b->h / a->h, &factor);
  ph_vec3 right =
      ph_check_great_beyond(b->s->p, b->s->x, -gamma * a->h / b->h, &factor);
  add(&c->worst[NIELSON], node, ph_check_apart(left, right), 1,
      ROUND_NIELSON * c->rounding * factor + c->v->knot / a->h +
          c->v->knot / b->h);
}

/* ---- nodes -------------------------------------------------------------- */

static void check_node(struct context *c, size_t node,
                       const struct ph_check_segment *left,
                       const struct ph_check_segment *right) {
  struct side a = side_of(c, left, 1), b = side_of(c, right, 0);
  double size = ph_check_larger(fabs(a.curvature), fabs(b.curvature));
  double error = a.curvature_error + b.curvature_error;
  double jump = fabs(a.curvature - b.curvature) / ph_check_larger(1, size);
  double nu = c->v->curve->sphere.tensions[node], relative;
  check_exact(c, node, nu, &a, &b);
  check_nielson(c, node, nu, &a, &b);
  relative = ph_check_nu_add_tension(&c->tensions, c->v->curve, node);
  c->relative_error += relative * c->v->knot * (1 / a.h + 1 / b.h);
  if (isfinite(error)) { /* it does not stand still */
    c->jump = ph_check_larger(c->jump, jump);
    c->jump_error = ph_check_larger(c->jump_error, error);
    c->curvature = ph_check_larger(c->curvature, size);
    c->curvature_error = ph_check_larger(c->curvature_error, error);
  }
}

/* ---- claims ------------------------------------------------------------- */

static void check_number(struct ph_check *v, enum ph_diagnostic which,
                         double found, double unit, double allowance) {
  if (ph_check_known(v, which)) {
    ph_check_number(
        v, PH_CHECK_DIAGNOSTIC,
        ph_check_of("diagnostics", PH_CHECK_ONE, ph_diagnostic_name(which)),
        v->diagnostics->value[which], found, unit, allowance);
  }
}

/* The model that the problem names, or that fits. */
static enum model model_of(const struct context *c) {
  const struct ph_problem *p = c->v->problem;
  const struct ph_value *model = p ? &p->field[PH_F_MODEL] : NULL;
  if (model) {
    return ph_value_is(model, "nielson") ? NIELSON : EXACT;
  }
  return c->worst[EXACT].error <= c->worst[NIELSON].error ? EXACT : NIELSON;
}

static void conclude(struct context *c) {
  struct ph_check *v = c->v;
  double radius = v->curve->sphere.radius;
  enum model model = model_of(c);
  ph_check_miss(v, PH_CHECK_TENSION,
                ph_check_of("tensions", c->worst[model].node, NULL),
                c->worst[model].error, 1, 0, "is not that of the curve");
  if (model == EXACT) {
    ph_check_miss(v, PH_CHECK_CONTINUITY,
                  ph_check_of("segments", PH_CHECK_ONE, NULL), c->jump, 1,
                  c->jump_error, "let the curvature jump");
  }
  check_number(v, PH_D_CURVATURE_JUMP, c->jump, 1, 2 * c->jump_error);
  check_number(v, PH_D_MAX_CURVATURE, c->curvature / radius,
               c->curvature / radius, 2 * c->curvature_error / radius);
  check_number(v, PH_D_TENSION_SUM, ph_sum_value(&c->tensions.sum),
               ph_sum_value(&c->tensions.sum), 0);
  check_number(v, PH_D_TENSION_RELATIVE_SUM,
               ph_sum_value(&c->tensions.relative),
               ph_sum_value(&c->tensions.relative), c->relative_error);
  check_number(v, PH_D_MAX_TENSION_RELATIVE, c->tensions.largest,
               c->tensions.largest, c->relative_error);
}

/* The points where criteria were waived: where there are any, the shape is not
 * kept. */
static void check_waived(struct ph_check *v) {
  const struct ph_sphere *sphere = &v->curve->sphere;
  if (!ph_check_nu_waived_fit(sphere, v->curve->n)) {
    ph_check_wrong(v, PH_CHECK_DIAGNOSTIC,
                   ph_check_of("waived", PH_CHECK_ONE, NULL),
                   "are not points in their order");
  }
  if (sphere->waived_n > 0 && ph_check_known(v, PH_D_SHAPE_OK) &&
      v->diagnostics->value[PH_D_SHAPE_OK] > 0) {
    ph_check_wrong(v, PH_CHECK_DIAGNOSTIC,
                   ph_check_of("diagnostics", PH_CHECK_ONE,
                               ph_diagnostic_name(PH_D_SHAPE_OK)),
                   "is true, where there are waived points");
  }
}

void ph_check_tensions(struct ph_check *v) {
  struct context c = {.v = v};
  struct ph_check_segment first, s[2];
  size_t n = v->curve->n;
  for (size_t k = 0; k < n && !(k > 0 && ph_arena_late(v->scratch)); k++) {
    struct ph_check_segment *now = &s[k & 1];
    ph_check_load(v, k, now);
    c.rounding = 3 * DBL_EPSILON + v->scale.rounding / now->radius;
    if (k > 0) {
      check_node(&c, k, &s[~k & 1], now);
    } else {
      first = *now;
    }
  }
  if (v->curve->closed) {
    check_node(&c, 0, &s[~n & 1], &first);
  }
  conclude(&c);
  check_waived(v);
}
