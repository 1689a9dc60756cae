/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Offset curves of PH splines: exact rational Bezier curves of degree 9 [FAR90;
 * GON18, sec. 2.2 with the left normal], of Tschirnhausen cubics of degree 5;
 * of ATPH splines, the exact displacement as a quotient, and Bezier pieces
 * within a tolerance.
 *
 *   o(u) = r(u) + d e(u),  e = A j A* / sigma or A k A* / sigma
 *        = (sigma(u) r(u) + d A(u) j A(u)*) / sigma(u)
 *
 * for the vectors e2 and e3 of the Euler-Rodrigues frame.  In the plane e2 is
 * the left normal i w^2 / sigma, and d is positive to the left of travel.  The
 * weights are the Bernstein coefficients of the parametric speed sigma, raised
 * to that degree.
 *
 * An ATPH segment holds t beside sin t and cos t, so that its offset is no
 * NURBS.  o - r is a quotient in <1, sin t, cos t, sin 2t, cos 2t>, given by
 * coefficients in the normalised B-basis of that space,
 *   (1, 4c, 4c^2 + 2, 4c, 1) S0^(4-j) S1^j,  j = 0..4,
 * with c, S0 and S1 of kernel/atph.h.
 */
#ifndef PH_CURVE_OFFSET_OFFSET_H
#define PH_CURVE_OFFSET_OFFSET_H

#include "base/diag.h"
#include "base/mem.h"
#include "curve/result.h"
#include "curve/sample/sample.h"

/* What offsets are of plane curves: of each segment; these, with joins; or of
 * these what keeps the distance from the whole curve (outline.h). */
#define PH_OFFSET_MODES(FIRST, X) \
  FIRST(RAW, "raw")               \
  X(JOINED, "joined")             \
  X(TRIMMED, "trimmed")

enum ph_offset_mode {
#define X(symbol, name) PH_OFFSET_##symbol,
  PH_OFFSET_MODES(X, X)
#undef X
      PH_OFFSET_MODE_N
};

/* How offsets are made. */
struct ph_offset_rules {
  enum ph_offset_mode mode;
  double miter;    /* of joins: tips within that times the distance; 0: arcs */
  bool round_ends; /* both sides of open curves, joined around their ends */
  bool both;       /* both sides of closed curves */
  bool crosses;    /* the curve meets itself */
  bool keep; /* parts that run on each other in opposite directions, once */

  size_t *effort; /* of loops: decisions on pairs of arcs that may be made, less
                     those that were; NULL: as many as there are */

  double tolerance; /* of Bezier pieces of ATPH offsets, in the curve's unit */
  struct ph_sample_rules samples; /* how they are sampled, or not at all; on a
                                     sphere always */
};

#define PH_MITER_LIMIT 4 /* of --offset-join=miter, where it says none */

/* A distance gives so many offsets of a curve in space. */
enum { PH_OFFSETS_SPATIAL = 4 };

typedef enum ph_status
ph_offset_fn(const struct ph_curve *curve, double distance,
             const struct ph_offset_rules *rules, struct ph_arena *arena,
             struct ph_offset *offsets, struct ph_diag *diag);

/*
 * ph_offset: the offsets of a curve at one distance, as many as
 * ph_kind_offsets (curve/kind/kind.h) says.
 *
 * Of PH curves and cubics, a segment whose weights are not all positive (it
 * turns by more than about a half turn) is cut until they are: halved, or, a
 * cubic, cut once at its vertex (rational.h).  On a sphere: see
 * curve/kind/spherical.c.
 *
 * out  offsets  arrays from the arena; in space four, along e2, -e2, e3, -e3:
 *               the distance of the second and the fourth is the negative
 *
 * ret  PH_OK | PH_E_INFEASIBLE (the curve stands still somewhere: no normal
 *      there; names the segment) | PH_E_TOO_LARGE | PH_E_NO_CONVERGENCE (no
 *      Bezier piece is near enough; on a sphere, of the length) |
 *      PH_E_BAD_VALUE (on a sphere, the distance is not less than half the
 *      circumference) | PH_E_NO_MEMORY
 */
ph_offset_fn ph_offset;

/* The same of PH curves and cubics, and of ATPH curves. */
ph_offset_fn ph_offset_rational;
ph_offset_fn ph_offset_quotient;

#endif
