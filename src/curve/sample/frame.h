/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Frames of samples (see sample.h): of one segment after the other, because a
 * rotation-minimising frame goes on through the joints.
 */
#ifndef PH_CURVE_SAMPLE_FRAME_H
#define PH_CURVE_SAMPLE_FRAME_H

#include "curve/sample/sample.h"
#include "kernel/primitive.h"

struct ph_framing {
  enum ph_frame frame;
  const struct ph_sampler *sampler;
  struct ph_primitive turn; /* of the reference frame, see frame.c */
  double angle;             /* the same, at the start of the segment */
  ph_vec3 before[3];        /* the frame at the end of the last segment */
};

/*
 * ph_framing_begin: prepares for a curve in space or on a sphere.
 *
 * in   sampler  of the curve itself, not of an offset
 * ret  PH_OK | PH_E_INFEASIBLE (it has no such frame)
 */
enum ph_status ph_framing_begin(struct ph_framing *framing,
                                const struct ph_sampler *sampler,
                                enum ph_frame frame, struct ph_diag *diag);

/* ph_framing_goes_on: whether the frames of a segment depend on those before.
 */
bool ph_framing_goes_on(const struct ph_framing *framing);

/* ph_framing_leave: before the sampler leaves its segment for the next one. */
void ph_framing_leave(struct ph_framing *framing);

/*
 * ph_framing_enter: after the sampler has entered a segment.
 *
 * ret  PH_OK | PH_E_NO_CONVERGENCE (the curve stands still there, and the
 *      rotation-minimising frame was not found) | PH_E_NO_MEMORY
 */
enum ph_status ph_framing_enter(struct ph_framing *framing,
                                struct ph_diag *diag);

/* ph_framing_at: the frame at u of a sample.  out  normal, binormal */
void ph_framing_at(const struct ph_framing *framing, double u,
                   const struct ph_sample *sample, ph_vec3 *normal,
                   ph_vec3 *binormal);

#endif
