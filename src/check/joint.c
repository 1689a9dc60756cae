/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * How segments join: as promised (promise.h); approximations have ends that
 * meet, for of a chain of given curves there may be corners.
 */
#include "check/checks.h"

#include "check/data.h"

/* Jumps of r', and r'', in the shorter interval's unit and relative to the
 * larger speed of the two. */
static void check_derivatives(struct ph_check *v,
                              const struct ph_check_segment *a,
                              const struct ph_check_segment *b, bool second) {
  double h = ph_check_smaller(a->spacing, b->spacing);
  double fa = h / a->spacing, fb = h / b->spacing, knot = v->knot / h;
  double speed = ph_check_larger(fa * a->speed, fb * b->speed);
  double noise = ph_check_larger(fa * a->noise, fb * b->noise);
  ph_vec3 jump = ph_vec3_sub(ph_vec3_scale(fa, a->first[1]),
                             ph_vec3_scale(fb, b->first[0]));
  ph_check_miss(v, PH_CHECK_CONTINUITY, ph_check_in(b->k, "control_points"),
                ph_vec3_abs(jump), speed,
                (v->allow->joint + knot) * speed + noise,
                "let the derivative jump");
  if (second) {
    jump = ph_vec3_sub(ph_vec3_scale(fa * fa, a->second[1]),
                       ph_vec3_scale(fb * fb, b->second[0]));
    ph_check_miss(v, PH_CHECK_CONTINUITY, ph_check_in(b->k, "control_points"),
                  ph_vec3_abs(jump), speed,
                  (v->allow->joint + PH_CHECK_ROUND_NEXT * knot) * speed +
                      PH_CHECK_ROUND_NEXT * noise,
                  "let the second derivative jump");
  }
}

/* Whether derivatives by the local parameter are given and scaled alike. */
static bool has_derivative(const struct ph_check *v, size_t a, size_t b) {
  const double *tension = v->curve->choice.tension;
  return v->data && v->data->derivatives &&
         v->promise->given == PH_GIVEN_TENSION && !v->kind->converted &&
         (!tension || (tension[a] <= tension[b] && tension[a] >= tension[b]));
}

static void check_tangent(struct ph_check *v, const struct ph_check_segment *a,
                          const struct ph_check_segment *b) {
  double fast = ph_vec3_abs(a->first[1]), slow = ph_vec3_abs(b->first[0]);
  double error = a->noise / fast + b->noise / slow + v->allow->joint;
  if (!(error < PH_CHECK_NO_DIRECTION)) {
    return;
  }
  ph_check_miss(v, PH_CHECK_CONTINUITY, ph_check_in(b->k, "control_points"),
                ph_check_apart(ph_vec3_scale(1 / fast, a->first[1]),
                               ph_vec3_scale(1 / slow, b->first[0])),
                1, error, "let the direction jump");
  if (has_derivative(v, a->k, b->k)) {
    ph_vec3 right = ph_vec3_scale(1 / b->unit, b->first[0]);
    double size = ph_vec3_abs(right);
    ph_check_miss(
        v, PH_CHECK_CONTINUITY, ph_check_in(b->k, "control_points"),
        ph_check_apart(ph_vec3_scale(1 / a->unit, a->first[1]), right), size,
        error * size, "let the derivative jump");
  }
}

void ph_check_joint(struct ph_check *v, const struct ph_check_segment *a,
                    const struct ph_check_segment *b) {
  enum ph_join join = v->kind->converted ? PH_JOIN_TANGENT : v->promise->join;
  if (v->allow->gap > 0) {
    ph_check_miss(v, PH_CHECK_CONTINUITY, ph_check_in(b->k, "control_points"),
                  ph_check_apart(a->end[1], b->end[0]), v->scale.size,
                  v->allow->gap * v->scale.rounding,
                  "are away from the end before");
  }
  if (join != PH_JOIN_TANGENT) {
    check_derivatives(v, a, b, join == PH_JOIN_SECOND);
  } else if (!ph_check_is_approximation(v)) {
    check_tangent(v, a, b);
  }
}
