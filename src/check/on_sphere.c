/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Curves on a sphere: their control points are on it.  With the problem, it is
 * that sphere, and the ends are as they should be.
 */
#include "check/checks.h"
#include "check/data.h"

enum { ROUND_POINT = 8 };

/* By how much points of the unit sphere are off because numbers are rounded. */
static double rounding_of(const struct ph_check *v,
                          const struct ph_check_segment *s) {
  return (v->scale.rounding + ph_check_reach(v, s->center)) / s->radius +
         DBL_EPSILON;
}

static void check_points(struct ph_check *v, const struct ph_check_segment *s) {
  const struct ph_curve *c = v->curve;
  for (size_t i = 0; i <= c->degree; i++) {
    ph_vec3 p = ph_check_vector(v, ph_curve_points(c, s->k) + 3 * i, 3);
    double from = ph_check_apart(p, s->center) / s->radius;
    ph_check_miss(v, PH_CHECK_SPHERE, ph_check_in(s->k, "control_points"),
                  fabs(from - 1), 1, ROUND_POINT * rounding_of(v, s),
                  "are off the sphere");
  }
}

/* ---- with the problem ------------------------------------------------------
 */

static void check_sphere(struct ph_check *v) {
  const struct ph_curve *c = v->curve;
  const struct ph_value *radius = ph_check_field(v, PH_F_RADIUS);
  const struct ph_value *center = ph_check_field(v, PH_F_CENTER);
  double wanted = radius ? radius->number : 1;
  ph_check_number(v, PH_CHECK_SPHERE, ph_check_of("radius", PH_CHECK_ONE, NULL),
                  c->sphere.radius, wanted, wanted, 0);
  for (size_t i = 0; i < 3; i++) {
    ph_check_number(v, PH_CHECK_SPHERE,
                    ph_check_of("center", PH_CHECK_ONE, NULL),
                    c->sphere.center[i],
                    center && i < center->n ? center->v[i] : 0, wanted, 0);
  }
}

/* An end of an open curve: it stands still, its second control point is
 * between its neighbours, which makes it straight, or it has the given
 * direction. */
static void check_end(struct ph_check *v, const struct ph_check_segment *s,
                      size_t end) {
  const struct ph_value *given = ph_check_field(v, PH_F_END_TANGENTS);
  ph_vec3 at = s->p[3 * end], next = s->p[end == 0 ? 1 : 2];
  ph_vec3 inner = s->p[end == 0 ? 2 : 1], sum = ph_vec3_add(at, inner);
  double leg = s->speed / (3 * s->radius);
  double rounding = ROUND_POINT * rounding_of(v, s);
  if (given && given->n == 2) {
    ph_vec3 wanted =
        ph_check_direction(given->v + given->dimension * end, given->dimension);
    wanted = ph_vec3_unit(ph_vec3_normal(wanted, at));
    wanted = ph_vec3_unit(ph_vec3_normal(wanted, at)); /* it may cancel */
    ph_check_heading(v, PH_CHECK_END, s, (double)end, wanted, 1);
  } else if (ph_check_is_word(v, PH_F_ENDS, "rest")) {
    ph_check_miss(v, PH_CHECK_END, ph_check_in(s->k, "control_points"),
                  ph_check_apart(at, next), leg, rounding,
                  "let the curve not come to rest");
  } else {
    ph_check_miss(v, PH_CHECK_END, ph_check_in(s->k, "control_points"),
                  ph_check_apart(next, ph_vec3_unit(sum)), leg,
                  rounding * (1 + 2 / ph_vec3_abs(sum)),
                  "let the curve bend at its end");
  }
}

void ph_check_on_sphere(struct ph_check *v) {
  const struct ph_curve *c = v->curve;
  for (size_t k = 0; k < c->n; k++) {
    struct ph_check_segment s;
    ph_check_load(v, k, &s);
    check_points(v, &s);
    if (v->problem && !c->closed && k == 0) {
      check_end(v, &s, 0);
    }
    if (v->problem && !c->closed && k + 1 == c->n) {
      check_end(v, &s, 1);
    }
  }
  if (v->problem) {
    check_sphere(v);
  }
}
