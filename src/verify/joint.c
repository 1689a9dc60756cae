/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * How segments join.  A result does not say what was promised; its command and
 * its kind of curve do:
 *
 *   planar, arclength   PH and ATPH segments: r' and r'' by the knots
 *   sphere              r' by the knots; r'' (the geodesic curvature) is a
 *                       matter of the model (tension.c)
 *   others, and Bezier curves in place of ATPH ones   the unit tangent
 *   tc, approximating   ends that meet: of a chain of given curves there may be
 *                       corners
 */
#include "verify/check.h"

enum { ROUND_POINT = 4 };

/* An end of a segment, with r' and r'' by u. */
struct end {
  ph_vec3 at, jet[2];
  double noise, next; /* of r' and r'' */
};

static struct end end_of(const struct ph_verify *v,
                         const struct ph_verify_segment *s, double u) {
  struct end e;
  e.at = ph_verify_point(v, s, u);
  ph_verify_jet(s, u, e.jet, 2);
  e.noise = ph_verify_uncertain(s, 1);
  e.next = ph_verify_uncertain(s, 2);
  return e;
}

/* Jumps of r', and r'', in the shorter interval's unit and relative to the
 * larger speed of the two. */
static void check_derivatives(struct ph_verify *v,
                              const struct ph_verify_segment *a,
                              const struct ph_verify_segment *b,
                              const struct end *before, const struct end *after,
                              bool second) {
  double h = ph_verify_smaller(a->spacing, b->spacing);
  double fa = h / a->spacing, fb = h / b->spacing, knot = v->knot / h;
  double speed = ph_verify_larger(fa * a->speed, fb * b->speed);
  ph_vec3 jump = ph_vec3_sub(ph_vec3_scale(fa, before->jet[0]),
                             ph_vec3_scale(fb, after->jet[0]));
  ph_verify_miss(v, PH_V_CONTINUITY, ph_verify_in(b->k, "control_points"),
                 ph_vec3_abs(jump), speed,
                 knot * speed + fa * before->noise + fb * after->noise,
                 "let the derivative jump");
  if (second) {
    jump = ph_vec3_sub(ph_vec3_scale(fa * fa, before->jet[1]),
                       ph_vec3_scale(fb * fb, after->jet[1]));
    ph_verify_miss(v, PH_V_CONTINUITY, ph_verify_in(b->k, "control_points"),
                   ph_vec3_abs(jump), speed,
                   PH_VERIFY_ROUND_NEXT * knot * speed +
                       fa * fa * before->next + fb * fb * after->next,
                   "let the second derivative jump");
  }
}

static void check_tangent(struct ph_verify *v, size_t k,
                          const struct end *before, const struct end *after) {
  double fast = ph_vec3_abs(before->jet[0]), slow = ph_vec3_abs(after->jet[0]);
  double error = before->noise / fast + after->noise / slow;
  if (error < PH_VERIFY_NO_DIRECTION) {
    ph_verify_miss(v, PH_V_CONTINUITY, ph_verify_in(k, "control_points"),
                   ph_verify_apart(ph_vec3_scale(1 / fast, before->jet[0]),
                                   ph_vec3_scale(1 / slow, after->jet[0])),
                   1, error, "let the direction jump");
  }
}

void ph_verify_joint(struct ph_verify *v, const struct ph_verify_segment *a,
                     const struct ph_verify_segment *b) {
  enum ph_curve_kind kind = v->curve->kind;
  struct end before = end_of(v, a, 1), after = end_of(v, b, 0);
  bool smooth = kind == PH_CURVE_PH || kind == PH_CURVE_ATPH;
  bool second = smooth && (ph_verify_is_command(v, "planar") ||
                           ph_verify_is_command(v, "arclength"));
  ph_verify_miss(v, PH_V_CONTINUITY, ph_verify_in(b->k, "control_points"),
                 ph_verify_apart(before.at, after.at), v->size,
                 ROUND_POINT * v->rounding, "are away from the end before");
  if (v->curve->knots && (second || kind == PH_CURVE_SPHERICAL_NU)) {
    check_derivatives(v, a, b, &before, &after, second);
  } else if (kind != PH_CURVE_TC || !ph_verify_known(v, PH_D_DISTANCE)) {
    check_tangent(v, b->k, &before, &after);
  }
}
