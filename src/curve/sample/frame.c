/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Frames of samples (see frame.h).
 *
 * A rotation-minimising frame is the reference frame e1, e2, e3 of a kind of
 * curves (curve/kind/kind.h) turned back about the tangent by the integral of
 * its turn e2' . e3, to 1e-13.
 *
 * A curve that stands still in space has no such frame: how it turns there is
 * not known to any digit.
 *
 * At a joint the frame is taken along by the shortest rotation between the
 * tangents, which mostly are the same.
 */
#include "curve/sample/frame.h"

#include "curve/kind/kind.h"

/* Of the integrals: of turn + 1, so that it is relative to 1 at least. */
static const double TOLERANCE = 1e-13;

static const struct ph_kind *kind_of(const struct ph_framing *f) {
  return ph_kind_of(f->sampler->curve);
}

bool ph_framing_goes_on(const struct ph_framing *f) {
  return f->frame == PH_FRAME_RMF && kind_of(f)->turn;
}

/* ---- rotation-minimising frames ------------------------------------------ */

static void minimising_at(const struct ph_framing *f, double u,
                          ph_vec3 frame[3]) {
  const double turned = f->angle + (ph_primitive_at(&f->turn, u, NULL) - u);
  const double c = cos(turned), s = sin(turned);
  ph_vec3 e[3];
  kind_of(f)->reference(f->sampler, u, e);
  frame[0] = e[0];
  frame[1] = ph_vec3_along(ph_vec3_scale(c, e[1]), -s, e[2]);
  frame[2] = ph_vec3_along(ph_vec3_scale(s, e[1]), c, e[2]);
}

/* Goes on from the end of the segment before, or begins as the Euler-Rodrigues
 * frame, or where there is none with a horizontal normal. */
static enum ph_status go_on(struct ph_framing *f, struct ph_diag *diag) {
  const struct ph_kind *kind = kind_of(f);
  const size_t k = f->sampler->k;
  ph_vec3 e[3], normal;
  enum ph_status status = ph_primitive_make(
      &f->turn, kind->turn, f->sampler, NULL, 0, TOLERANCE, f->sampler->arena);
  if (status != PH_OK) {
    return status == PH_E_NO_MEMORY
               ? ph_fail_memory(diag)
               : ph_fail_at(diag, status, "segments", k,
                            "all but stands still somewhere: no "
                            "rotation-minimising frame was found");
  }
  kind->reference(f->sampler, 0, e);
  normal = k > 0       ? ph_vec3_carried(f->before[1], f->before[0], e[0])
           : kind->erf ? e[1]
                       : ph_vec3_any_normal(e[0]);
  f->angle = atan2(-ph_vec3_dot(normal, e[2]), ph_vec3_dot(normal, e[1]));
  return PH_OK;
}

/* ---- the interface ------------------------------------------------------- */

enum ph_status ph_framing_begin(struct ph_framing *framing,
                                const struct ph_sampler *sampler,
                                enum ph_frame frame, struct ph_diag *diag) {
  const struct ph_framing none = {.frame = frame, .sampler = sampler};
  const struct ph_kind *kind = ph_kind_of(sampler->curve);
  *framing = none;
  if (frame != PH_FRAME_NONE && sampler->curve->dimension == 2) {
    return ph_fail(diag, PH_E_INFEASIBLE, NULL,
                   "a curve in the plane has no frames in space");
  }
  if (frame == PH_FRAME_ERF && !kind->erf) {
    return ph_fail(diag, PH_E_INFEASIBLE, NULL, "%s", kind->no_erf);
  }
  return PH_OK;
}

void ph_framing_leave(struct ph_framing *f) {
  if (ph_framing_goes_on(f)) {
    minimising_at(f, 1, f->before);
  }
}

enum ph_status ph_framing_enter(struct ph_framing *f, struct ph_diag *diag) {
  return ph_framing_goes_on(f) ? go_on(f, diag) : PH_OK;
}

ph_vec3 ph_sample_principal(const struct ph_sample *sample, ph_vec3 normal) {
  const ph_vec3 none = {(double)NAN, (double)NAN, (double)NAN};
  return isfinite(sample->torsion) ? ph_vec3_unit(ph_vec3_normal(
                                         ph_vec3_unit(normal), sample->tangent))
                                   : none;
}

void ph_framing_at(const struct ph_framing *f, double u,
                   const struct ph_sample *sample, ph_vec3 *normal,
                   ph_vec3 *binormal) {
  const struct ph_kind *kind = kind_of(f);
  ph_vec3 frame[3] = {sample->tangent};
  if (f->frame == PH_FRAME_FRENET) {
    frame[1] = kind->principal(f->sampler, u, sample);
    frame[2] = ph_vec3_cross(frame[0], frame[1]);
  } else if (ph_framing_goes_on(f)) {
    minimising_at(f, u, frame);
  } else {
    kind->reference(f->sampler, u, frame);
  }
  *normal = frame[1];
  *binormal = frame[2];
}
