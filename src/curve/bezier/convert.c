/* SPDX-License-Identifier: GPL-3.0-or-later */
/* ATPH curves as polynomial Bezier curves (see curve/bezier/convert.h). */
#include "curve/bezier/convert.h"

#include "curve/bezier/hermite.h"
#include "curve/kind/kind.h"
#include "curve/segment/seg2.h"
#include "kernel/pow2.h"

#include <math.h>

/* The exact length of the part [u[0],u[1]] of a segment with preimage w.  It is
 * found at unit scale: a sum of squares may leave the range of a double where
 * the length does not. */
static double part_length(const struct ph_atph *space, const ph_cplx w[3],
                          const double *u) {
  struct ph_atph part;
  ph_cplx v[3];
  double largest = 0;
  int exponent;
  ph_atph_part(space, w, u[0], u[1], &part, v);
  for (size_t i = 0; i < 3; i++) {
    largest = fmax(largest, fmax(fabs(v[i].re), fabs(v[i].im)));
  }
  exponent = largest > 0 ? ph_pow2_exponent(largest) : 0;
  for (size_t i = 0; i < 3; i++) {
    v[i] = ph_cplx_of(ldexp(v[i].re, -exponent), ldexp(v[i].im, -exponent));
  }
  return ldexp((u[1] - u[0]) * ph_seg2_length(&part, v), 2 * exponent);
}

/* The exact length of the part of the curve that a piece stands for; in space
 * |A|^2 is the sum of two planar speeds. */
static double length_of(const struct ph_curve *curve,
                        const struct ph_pieces *pieces, size_t i) {
  const double *u = pieces->interval + 2 * i;
  if (curve->dimension == 2) {
    struct ph_seg2 seg = ph_seg2_of(curve, pieces->segment[i]);
    return part_length(&seg.space, seg.w, u);
  } else {
    struct ph_seg3 seg = ph_seg3_of(curve, pieces->segment[i]);
    ph_cplx pair[2][3];
    ph_seg3_pair(&seg, pair);
    return part_length(&seg.space, pair[0], u) +
           part_length(&seg.space, pair[1], u);
  }
}

enum ph_status ph_knots_increase(const double *knots, size_t n,
                                 const size_t *segment, struct ph_diag *diag) {
  for (size_t i = 0; i < n; i++) {
    if (!(knots[i] < knots[i + 1])) {
      return ph_fail_at(diag, PH_E_NO_CONVERGENCE, "segments", segment[i],
                        "has more Bezier pieces than there are numbers between "
                        "its knots: take knots nearer to 0, or a larger "
                        "tolerance");
    }
  }
  return PH_OK;
}

enum ph_status ph_bezier_quintics(const struct ph_curve *curve,
                                  double tolerance, struct ph_arena *arena,
                                  struct ph_curve *bezier, double *error,
                                  struct ph_diag *diag) {
  struct ph_pieces pieces;
  enum ph_status status =
      ph_hermite_pieces(curve, 0, PH_E2, tolerance, arena, &pieces, diag);
  if (status != PH_OK) {
    return status;
  }
  *error = pieces.error;
  *bezier = (struct ph_curve){
      .kind = PH_CURVE_BEZIER,
      .closed = curve->closed,
      .dimension = curve->dimension,
      .degree = pieces.degree,
      .n = pieces.n,
      .knots = ph_arena_array(arena, pieces.n + 1, sizeof(double)),
      .control_points = pieces.control_points,
      .lengths = ph_arena_array(arena, pieces.n, sizeof(double)),
      .length = curve->length};
  if (!bezier->knots || !bezier->lengths) {
    return ph_fail_memory(diag);
  }
  for (size_t i = 0; i < pieces.n; i++) {
    const double *knot = curve->knots + pieces.segment[i];
    double u = pieces.interval[2 * i];
    bezier->knots[i] = u > 0 ? knot[0] + u * (knot[1] - knot[0]) : knot[0];
    bezier->lengths[i] = length_of(curve, &pieces, i);
    if (!isfinite(bezier->lengths[i])) {
      return ph_fail_at(diag, PH_E_TOO_LARGE, "segments", pieces.segment[i],
                        "has a length beyond the range of a double");
    }
  }
  bezier->knots[pieces.n] = curve->knots[curve->n];
  return ph_knots_increase(bezier->knots, pieces.n, pieces.segment, diag);
}

enum ph_status ph_bezier_itself(const struct ph_curve *curve, double tolerance,
                                struct ph_arena *arena, struct ph_curve *bezier,
                                double *error, struct ph_diag *diag) {
  (void)tolerance;
  (void)arena;
  (void)diag;
  *bezier = *curve;
  *error = 0;
  return PH_OK;
}

enum ph_status ph_bezier_curve(const struct ph_curve *curve, double tolerance,
                               struct ph_arena *arena, struct ph_curve *bezier,
                               double *error, struct ph_diag *diag) {
  return ph_kind_of(curve)->bezier(curve, tolerance, arena, bezier, error,
                                   diag);
}
