/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * How segments join: as promised (promise.h); approximations have ends that
 * meet, for of a chain of given curves there may be corners.
 */
#include "check/checks.h"

enum { ROUND_POINT = 4 };

/* An end of a segment, with r' and r'' by u. */
struct end {
  ph_vec3 at, jet[2];
  double noise, next; /* of r' and r'' */
};

static struct end end_of(const struct ph_check *v,
                         const struct ph_check_segment *s, double u) {
  struct end e;
  e.at = ph_check_point(v, s, u);
  ph_check_jet(s, u, e.jet, 2);
  e.noise = ph_check_uncertain(s, 1);
  e.next = ph_check_uncertain(s, 2);
  return e;
}

/* Jumps of r', and r'', in the shorter interval's unit and relative to the
 * larger speed of the two. */
static void check_derivatives(struct ph_check *v,
                              const struct ph_check_segment *a,
                              const struct ph_check_segment *b,
                              const struct end *before, const struct end *after,
                              bool second) {
  double h = ph_check_smaller(a->spacing, b->spacing);
  double fa = h / a->spacing, fb = h / b->spacing, knot = v->knot / h;
  double speed = ph_check_larger(fa * a->speed, fb * b->speed);
  ph_vec3 jump = ph_vec3_sub(ph_vec3_scale(fa, before->jet[0]),
                             ph_vec3_scale(fb, after->jet[0]));
  ph_check_miss(v, PH_CHECK_CONTINUITY, ph_check_in(b->k, "control_points"),
                ph_vec3_abs(jump), speed,
                knot * speed + fa * before->noise + fb * after->noise,
                "let the derivative jump");
  if (second) {
    jump = ph_vec3_sub(ph_vec3_scale(fa * fa, before->jet[1]),
                       ph_vec3_scale(fb * fb, after->jet[1]));
    ph_check_miss(v, PH_CHECK_CONTINUITY, ph_check_in(b->k, "control_points"),
                  ph_vec3_abs(jump), speed,
                  PH_CHECK_ROUND_NEXT * knot * speed + fa * fa * before->next +
                      fb * fb * after->next,
                  "let the second derivative jump");
  }
}

static void check_tangent(struct ph_check *v, size_t k,
                          const struct end *before, const struct end *after) {
  double fast = ph_vec3_abs(before->jet[0]), slow = ph_vec3_abs(after->jet[0]);
  double error = before->noise / fast + after->noise / slow;
  if (error < PH_CHECK_NO_DIRECTION) {
    ph_check_miss(v, PH_CHECK_CONTINUITY, ph_check_in(k, "control_points"),
                  ph_check_apart(ph_vec3_scale(1 / fast, before->jet[0]),
                                 ph_vec3_scale(1 / slow, after->jet[0])),
                  1, error, "let the direction jump");
  }
}

void ph_check_joint(struct ph_check *v, const struct ph_check_segment *a,
                    const struct ph_check_segment *b) {
  enum ph_join join = v->kind->converted ? PH_JOIN_TANGENT : v->promise->join;
  struct end before = end_of(v, a, 1), after = end_of(v, b, 0);
  ph_check_miss(v, PH_CHECK_CONTINUITY, ph_check_in(b->k, "control_points"),
                ph_check_apart(before.at, after.at), v->scale.size,
                ROUND_POINT * v->scale.rounding,
                "are away from the end before");
  if (join != PH_JOIN_TANGENT) {
    check_derivatives(v, a, b, &before, &after, join == PH_JOIN_SECOND);
  } else if (!ph_check_is_approximation(v)) {
    check_tangent(v, b->k, &before, &after);
  }
}
