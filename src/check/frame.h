/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Frames of samples, as they are said to be:
 *
 *   frenet  the normal is that of r'' across r'
 *   erf     it is A j A* / |A|^2, A the claimed preimage
 *   rmf     the frame does not turn about the tangent T: from each sample to
 *           the next it turns about T, against a frame that the shortest
 *           rotation takes from a fixed direction d to T, by the integral of
 *
 *             d . (T x T') / (1 + d . T)                                  (1)
 *
 *           (the area between the ways of T and of d to T on the unit sphere);
 *           on a sphere it is S x T
 *
 * How a rotation-minimising frame begins is nobody's claim.
 */
#ifndef PH_CHECK_FRAME_H
#define PH_CHECK_FRAME_H

#include "check/local.h"

/* A frame on its way along a curve. */
struct ph_check_framing {
  enum ph_frame frame;
  bool begun; /* a rotation-minimising one is known at u of segment k */
  size_t k;
  double u;
  ph_vec3 tangent, normal;
  double error; /* of the normal */
};

/* ph_check_frame_leave: goes from the segment of the path, which is number
 * f->k, to the start of the next one. */
void ph_check_frame_leave(struct ph_check_framing *f,
                          const struct ph_check_path *path);

/*
 * ph_check_frame_at: the normal at u of the path's segment.
 *
 * in   local  of the curve there
 * out  error  of it; not finite: it is not known
 */
ph_vec3 ph_check_frame_at(const struct ph_check_framing *f,
                          const struct ph_check_path *path,
                          const struct ph_check_local *local, double u,
                          double *error);

#endif
