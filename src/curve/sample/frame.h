/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Frames of samples (see sample.h): of one segment after the other, because a
 * rotation-minimising frame goes on through the joints.
 */
#ifndef PH_CURVE_SAMPLE_FRAME_H
#define PH_CURVE_SAMPLE_FRAME_H

#include "curve/sample/sample.h"
#include "curve/kind/bezier.h"
#include "curve/segment/seg3_fast.h"
#include "curve/segment/spherical_fast.h"
#include "kernel/primitive.h"

struct ph_framing {
  enum ph_frame frame;
  const struct ph_curve *curve;
  struct ph_arena *arena;
  struct ph_fast3 fast; /* the segment, of the kind that it is */
  struct ph_bezier bezier;
  struct ph_spherical_fast sphere;
  ph_vec3 axes[3]; /* the reference frame of a Bezier curve */
  struct ph_primitive
      turn;     /* of the reference frame, see curve/sample/frame.c */
  double angle; /* the same, at the start of the segment */
};

/*
 * ph_framing_begin: prepares for a curve in space or on a sphere.
 *
 * ret  PH_OK | PH_INFEASIBLE (it has no such frame)
 */
enum ph_status ph_framing_begin(struct ph_framing *framing,
                                const struct ph_curve *curve,
                                enum ph_frame frame, struct ph_arena *arena,
                                struct ph_diag *diag);

/*
 * ph_framing_enter: goes to segment k, after k - 1.
 *
 * ret  PH_OK | PH_NO_CONVERGENCE (the curve stands still there, and the
 *      rotation-minimising frame was not found) | PH_NO_MEMORY
 */
enum ph_status ph_framing_enter(struct ph_framing *framing, size_t k,
                                struct ph_diag *diag);

/* ph_framing_at: the frame at u of a sample.  out  normal, binormal */
void ph_framing_at(const struct ph_framing *framing, double u,
                   const struct ph_sample *sample, ph_vec3 *normal,
                   ph_vec3 *binormal);

#endif
