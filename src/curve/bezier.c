/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Planar ATPH curves as polynomial Bezier curves (see bezier.h). */
#include "curve/bezier.h"

#include "curve/hermite.h"
#include "curve/ph2.h"
#include "curve/seg2.h"

/* The exact length of the part of the curve that a piece stands for. */
static double length_of(const struct ph_curve *curve,
                        const struct ph_pieces *pieces, size_t i) {
  struct ph_seg2 seg = ph_seg2_of(curve, pieces->segment[i]);
  const double *u = pieces->interval + 2 * i;
  struct ph_atph space;
  ph_cplx w[3];
  ph_atph_part(&seg.space, seg.w, u[0], u[1], &space, w);
  return (u[1] - u[0]) * ph_ph2_length(&space, w);
}

enum ph_status ph_bezier_planar(const struct ph_curve *curve, double tolerance,
                                struct ph_arena *arena, struct ph_curve *bezier,
                                double *error, struct ph_diag *diag) {
  struct ph_pieces pieces;
  enum ph_status status;
  *bezier = *curve;
  *error = 0;
  if (!curve->alpha) {
    return PH_OK;
  }
  status = ph_hermite_pieces(curve, 0, tolerance, arena, &pieces, diag);
  if (status != PH_OK) {
    return status;
  }
  *error = pieces.error;
  bezier->kind = PH_CURVE_BEZIER;
  bezier->n = pieces.n;
  bezier->control_points = pieces.control_points;
  bezier->alpha = NULL;
  bezier->preimage = NULL;
  bezier->preimage_n = 0;
  bezier->knots = ph_arena_array(arena, pieces.n + 1, sizeof(double));
  bezier->lengths = ph_arena_array(arena, pieces.n, sizeof(double));
  if (!bezier->knots || !bezier->lengths) {
    return ph_fail_memory(diag);
  }
  for (size_t i = 0; i < pieces.n; i++) {
    const double *knot = curve->knots + pieces.segment[i];
    double u = pieces.interval[2 * i];
    bezier->knots[i] = u > 0 ? knot[0] + u * (knot[1] - knot[0]) : knot[0];
    bezier->lengths[i] = length_of(curve, &pieces, i);
  }
  bezier->knots[pieces.n] = curve->knots[curve->n];
  return PH_OK;
}
