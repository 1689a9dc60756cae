/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Frames of samples (see curve/sample/frame.h).
 *
 * A rotation-minimising frame is a reference frame e1, e2, e3 turned back about
 * the tangent by the integral of its turn e2' . e3.  The reference is
 *
 *   of PH and ATPH segments, the Euler-Rodrigues frame, with the turn 2x /
 * sigma of curve/segment/seg3.h; of Bezier segments, axes a, b, c that are
 * taken along by the shortest rotation from a to the tangent T, e2 = b - (T .
 * b) / (1 + a . T) (a + T),  e3 likewise,             (1) e2' . e3 = -a . (T x
 * T') / (1 + a . T) = -a . (r' x r'') / (|r'| (|r'| + a . r')), (2) with that
 * axis, of some, from whose opposite T stays farthest.
 *
 * A curve that stands still in space has no such frame: how it turns there is
 * not known to any digit.
 *
 * At a joint the frame is taken along by the shortest rotation between the
 * tangents, (1) again, which mostly are the same.  Integrals are to 1e-13.
 *
 * (2) derived here from (1); tested by t_sample_frame.c.
 */
#include "curve/sample/frame.h"

#include "curve/kind/kind.h"

/* Of the integrals: of turn + 1, so that it is relative to 1 at least. */
static const double TOLERANCE = 1e-13;

enum { LOOKS = 33, AXES = 9 };

/* v, normal to the unit vector a, by the shortest rotation from a to t. */
static ph_vec3 carried(ph_vec3 v, ph_vec3 a, ph_vec3 t) {
  const double factor = -ph_vec3_dot(v, t) / (1 + ph_vec3_dot(a, t));
  return ph_vec3_along(v, factor, ph_vec3_add(a, t));
}

/* ---- reference frames ---------------------------------------------------- */

/* out  e[3]  e[0] is the tangent */
static void reference_at(const struct ph_framing *f, double u, ph_vec3 e[3]) {
  if (f->curve->kind == PH_CURVE_BEZIER) {
    e[0] = ph_bezier_tangent(&f->bezier, u);
    e[1] = carried(f->axes[1], f->axes[0], e[0]);
    e[2] = carried(f->axes[2], f->axes[0], e[0]);
  } else {
    const struct ph_fast3_place at = ph_fast3_at(&f->fast, u);
    const ph_quat a = ph_fast3_direction(&f->fast, &at);
    const double per = 1 / ph_quat_dot(a, a);
    e[0] = ph_vec3_scale(per, ph_quat_i(a, a));
    e[1] = ph_vec3_scale(per, ph_quat_j(a, a));
    e[2] = ph_vec3_scale(per, ph_quat_k(a, a));
  }
}

/* The turn, and 1. */
static double turn_of_bezier(const void *context, double u) {
  const struct ph_framing *f = context;
  const ph_vec3 a = f->axes[0];
  ph_vec3 jet[PH_BEZIER_ORDERS];
  double speed;
  ph_bezier_jet(&f->bezier, u, jet);
  speed = ph_vec3_abs(jet[1]);
  return 1 - ph_vec3_triple(a, jet[1], jet[2]) /
                 (speed * (speed + ph_vec3_dot(a, jet[1])));
}

static double turn_of_ph(const void *context, double u) {
  const struct ph_framing *f = context;
  const struct ph_fast3_place at = ph_fast3_at(&f->fast, u);
  const ph_quat a = ph_fast3_preimage(&at);
  const ph_quat w = ph_quat_between(a, ph_fast3_slope(&at));
  return 1 + 2 * w.v / ph_quat_dot(a, a);
}

/* The axes of a Bezier segment. */
static void choose_axes(struct ph_framing *f) {
  ph_vec3 tangents[LOOKS], axes[AXES];
  double best = -1;
  for (size_t i = 0; i < LOOKS; i++) {
    tangents[i] = ph_bezier_tangent(&f->bezier, (double)i / (LOOKS - 1));
  }
  for (size_t i = 0; i < AXES; i++) {
    double sign = i % 2 ? -1 : 1, least = 2;
    axes[i] = i < 2   ? ph_vec3_of(sign, 0, 0)
              : i < 4 ? ph_vec3_of(0, sign, 0)
              : i < 6 ? ph_vec3_of(0, 0, sign)
                      : tangents[(i - 6) * (LOOKS / 2)];
    for (size_t j = 0; j < LOOKS; j++) {
      least = fmin(least, 1 + ph_vec3_dot(axes[i], tangents[j]));
    }
    if (least > best) {
      best = least;
      f->axes[0] = axes[i];
    }
  }
  f->axes[1] = ph_vec3_any_normal(f->axes[0]);
  f->axes[2] = ph_vec3_cross(f->axes[0], f->axes[1]);
}

/* ---- rotation-minimising frames ------------------------------------------ */

static void minimising_at(const struct ph_framing *f, double u,
                          ph_vec3 frame[3]) {
  const double turned = f->angle + (ph_primitive_at(&f->turn, u, NULL) - u);
  const double c = cos(turned), s = sin(turned);
  ph_vec3 e[3];
  reference_at(f, u, e);
  frame[0] = e[0];
  frame[1] = ph_vec3_along(ph_vec3_scale(c, e[1]), -s, e[2]);
  frame[2] = ph_vec3_along(ph_vec3_scale(s, e[1]), c, e[2]);
}

/* Goes on from a frame at the end of the segment before; NULL: begins as the
 * Euler-Rodrigues frame, or where there is none with a horizontal normal. */
static enum ph_status go_on(struct ph_framing *f, const ph_vec3 *before,
                            size_t k, struct ph_diag *diag) {
  ph_vec3 e[3], normal;
  const bool bezier = f->curve->kind == PH_CURVE_BEZIER;
  enum ph_status status =
      ph_primitive_make(&f->turn, bezier ? turn_of_bezier : turn_of_ph, f, NULL,
                        0, TOLERANCE, f->arena);
  if (status != PH_OK) {
    return status == PH_NO_MEMORY
               ? ph_fail_memory(diag)
               : ph_fail_at(diag, status, "segments", k,
                            "all but stands still somewhere: no "
                            "rotation-minimising frame was found");
  }
  reference_at(f, 0, e);
  normal = before   ? carried(before[1], before[0], e[0])
           : bezier ? ph_vec3_any_normal(e[0])
                    : e[1];
  f->angle = atan2(-ph_vec3_dot(normal, e[2]), ph_vec3_dot(normal, e[1]));
  return PH_OK;
}

/* ---- the interface ------------------------------------------------------- */

enum ph_status ph_framing_begin(struct ph_framing *framing,
                                const struct ph_curve *curve,
                                enum ph_frame frame, struct ph_arena *arena,
                                struct ph_diag *diag) {
  const bool sphere = curve->kind == PH_CURVE_SPHERICAL_NU;
  const struct ph_framing none = {
      .frame = frame, .curve = curve, .arena = arena};
  *framing = none;
  if (frame == PH_FRAME_NONE) {
    return PH_OK;
  }
  if (curve->dimension == 2) {
    return ph_fail(diag, PH_INFEASIBLE, NULL,
                   "a curve in the plane has no frames in space");
  }
  if (frame == PH_FRAME_ERF && (sphere || curve->kind == PH_CURVE_BEZIER)) {
    return ph_fail(diag, PH_INFEASIBLE, NULL,
                   sphere ? "a curve on a sphere has no Euler-Rodrigues frame"
                          : "Bezier curves have no preimage and no "
                            "Euler-Rodrigues frame: ask for the frame without "
                            "the conversion");
  }
  return PH_OK;
}

enum ph_status ph_framing_enter(struct ph_framing *f, size_t k,
                                struct ph_diag *diag) {
  const bool sphere = f->curve->kind == PH_CURVE_SPHERICAL_NU;
  const bool rmf = f->frame == PH_FRAME_RMF && !sphere;
  ph_vec3 before[3];
  if (f->frame == PH_FRAME_NONE) {
    return PH_OK;
  }
  if (rmf && k > 0) {
    minimising_at(f, 1, before);
  }
  if (sphere) {
    const struct ph_spherical segment = ph_spherical_of(f->curve, k);
    ph_spherical_fast_of(&segment, &f->sphere);
  } else if (f->curve->kind == PH_CURVE_BEZIER) {
    f->bezier = ph_bezier_of(f->curve, k);
    choose_axes(f);
  } else {
    ph_fast3_of(f->curve, k, &f->fast);
  }
  return rmf ? go_on(f, k > 0 ? before : NULL, k, diag) : PH_OK;
}

/* The principal normal: of a Bezier curve by r'', of a PH curve q e2 - p e3. */
static ph_vec3 principal_at(const struct ph_framing *f, double u,
                            ph_vec3 tangent) {
  ph_vec3 jet[PH_BEZIER_ORDERS], normal;
  if (f->curve->kind == PH_CURVE_BEZIER) {
    ph_bezier_jet(&f->bezier, u, jet);
    normal = ph_vec3_normal(jet[2], tangent);
  } else {
    const struct ph_fast3_place at = ph_fast3_at(&f->fast, u);
    const ph_quat a = ph_fast3_preimage(&at);
    const ph_quat w = ph_quat_between(a, ph_fast3_slope(&at));
    normal = ph_vec3_along(ph_vec3_scale(w.q, ph_quat_j(a, a)), -w.p,
                           ph_quat_k(a, a));
  }
  return ph_vec3_unit(ph_vec3_normal(ph_vec3_unit(normal), tangent));
}

/* On a sphere: kappa left - outward / radius; NaN where kappa is. */
static ph_vec3 principal_on_sphere(double kappa, double radius, ph_vec3 left,
                                   ph_vec3 outward) {
  return ph_vec3_unit(
      ph_vec3_sub(ph_vec3_scale(kappa * radius, left), outward));
}

void ph_framing_at(const struct ph_framing *f, double u,
                   const struct ph_sample *sample, ph_vec3 *normal,
                   ph_vec3 *binormal) {
  const ph_vec3 undefined = {(double)NAN, (double)NAN, (double)NAN};
  const bool sphere = f->curve->kind == PH_CURVE_SPHERICAL_NU;
  ph_vec3 frame[3] = {sample->tangent, undefined, undefined};
  if (sphere) {
    frame[2] = ph_motion_at(&f->sphere, u).s;
    frame[1] = ph_vec3_cross(frame[2], frame[0]);
    if (f->frame == PH_FRAME_FRENET) {
      frame[1] = principal_on_sphere(sample->curvature, f->curve->sphere.radius,
                                     frame[1], frame[2]);
      frame[2] = ph_vec3_cross(frame[0], frame[1]);
    }
  } else if (f->frame == PH_FRAME_RMF) {
    minimising_at(f, u, frame);
  } else if (f->frame == PH_FRAME_ERF) {
    reference_at(f, u, frame);
  } else if (isfinite(sample->torsion)) {
    frame[1] = principal_at(f, u, frame[0]);
    frame[2] = ph_vec3_cross(frame[0], frame[1]);
  }
  *normal = frame[1];
  *binormal = frame[2];
}
