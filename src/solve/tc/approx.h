/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Internal declarations of the mode `approximate` of the method `tc`. */
#ifndef PH_SOLVE_TC_APPROX_H
#define PH_SOLVE_TC_APPROX_H

#include "base/diag.h"
#include "base/mem.h"
#include "curve/segment/tc.h"
#include "kernel/bern_low.h"

#include <math.h>
#include <stddef.h>

/* ---- approximation ------------------------------------------------------- */

/*
 * Approximation of a Bezier curve by Tschirnhausen cubics: C1 pairs with the
 * derivatives of the curve, third order [BYR11, sec. 5.4], and single cubics
 * with its tangents where these are nearer.
 */

/* A Bezier curve of any degree >= 1, at unit scale. */
struct ph_tc_bezier {
  const ph_cplx *p; /* [degree + 1] */
  size_t degree;
  double shortest; /* chords of its cubics are longer; 0: than rounding */
};

/* Curves of higher degree are refused: binomial coefficients of twice the
 * degree must be finite. */
enum { PH_TC_DEGREE_MAX = 500 };

/* One cubic of an approximation. */
struct ph_tc_arc {
  double from, to; /* the part of the curve it stands for, in [0,1] */
  ph_cplx start, end;
  struct ph_tc tc;
};

/* Cubics that are collected; room grows by doubling, in an arena. */
struct ph_tc_arcs {
  struct ph_arena *arena;
  struct ph_tc_arc *arc;
  size_t n, room;
  double distance; /* an upper bound of the Hausdorff distance, proved */
};

/*
 * ph_tc_approximate: cubics within a Hausdorff distance of a Bezier curve, as
 * few as are found.  They begin and end on the curve, with its tangents; the
 * same curve backward gives the same cubics backward.
 *
 * in     tolerance  > 0
 * inout  arcs       appended to; distance is raised to that of these
 * ret  PH_OK | PH_E_NO_CONVERGENCE (says where) | PH_E_NO_MEMORY
 */
enum ph_status ph_tc_approximate(const struct ph_tc_bezier *curve,
                                 double tolerance, struct ph_tc_arcs *arcs,
                                 struct ph_diag *diag);

/*
 * ph_tc_approximate_pieces: the same with a number of cubics for a chain of
 * Bezier curves, all of them together: at a distance as small as is found with
 * at most `pieces` of them.
 *
 * in   curves[n]
 * in   pieces  >= n
 * in   least   no smaller distance is looked for
 * out  arcs    first[k] is the first one of curve k, first[n] = arcs->n
 * ret  as above; PH_E_BAD_VALUE if all that is found takes more than `pieces`
 */
enum ph_status ph_tc_approximate_pieces(const struct ph_tc_bezier *curves,
                                        size_t n, size_t pieces, double least,
                                        struct ph_tc_arcs *arcs, size_t *first,
                                        struct ph_diag *diag);

/* ---- parts and their bounds ---------------------------------------------- */

/*
 * Approximation of a part of a Bezier curve by one cubic or a pair, and a
 * bound of its distance; private to tc_approx*.c.
 */

/* A curve, and the room to work on it, which several may have in common. */
struct ph_tc_target {
  const ph_cplx *p; /* [degree + 1] */
  size_t degree;
  double size;    /* of the coordinates */
  double extent;  /* from the first point */
  double noise;   /* what rounding may add to a distance */
  double still;   /* derivatives up to this size have no direction */
  double same;    /* points no further apart than this are the same */
  ph_cplx *part;  /* [degree + 1] the part in work, */
  ph_cplx *cut;   /* [degree + 1] its second half for pairs, */
  ph_cplx *spare; /* [degree + 1] */
  ph_cplx *pool;  /* and the parts of the matching */
  struct ph_bern_low low;
};

/* ph_tc_target_room: points of room for a curve of this degree, or less. */
size_t ph_tc_target_room(size_t degree);

/* ph_tc_target_of: a curve; its control points are not copied.
 *
 * ws   room[ph_tc_target_room(degree)]  as long as the target is used */
struct ph_tc_target ph_tc_target_of(const struct ph_tc_bezier *curve,
                                    ph_cplx *room);

/*
 * ph_tc_shortest: no chord of cubics is shorter.  Where a curve turns back
 * there are parts of any length with a chord of almost none; a chord that is
 * small beside the tolerance gains nothing and loses its direction to rounding.
 */
static inline double ph_tc_shortest(const struct ph_tc_target *target,
                                    double tolerance) {
  double chord = fmin(tolerance / 16, 0x1p-30 * target->extent);
  return fmax(chord, target->same);
}

/* A point of the curve. */
struct ph_tc_knot {
  double u;
  ph_cplx p;
  ph_cplx derivative;
  ph_cplx tangent; /* unit; 0 within the curve where it stands still; at its
                      ends the limit */
};

/* ph_tc_knot_at: the point at u in [0,1]. */
struct ph_tc_knot ph_tc_knot_at(const struct ph_tc_target *target, double u);

/* What is tried on a part. */
enum ph_tc_kind {
  PH_TC_ONE,         /* one cubic, a pair only where there is no such cubic */
  PH_TC_ONE_OR_PAIR, /* a pair also where it is needed for the tolerance */
};

/* Distances of so many tolerances and more need not be told apart. */
enum { PH_TC_FAR = 16 };

/* Cubics for a part of the curve. */
struct ph_tc_patch {
  size_t n;        /* 1 or 2; 0: there are none */
  double distance; /* proved, or that far; infinite if there are none */
  struct ph_tc tc[2];
  ph_cplx joint; /* of two */
  double at;     /* and the parameter of the curve that it stands for */
};

/*
 * ph_tc_patch_of: the cubics for the part between two knots.
 *
 * in   tolerance  distances far beyond it are not worked out
 */
struct ph_tc_patch ph_tc_patch_of(const struct ph_tc_target *target,
                                  const struct ph_tc_knot *from,
                                  const struct ph_tc_knot *to,
                                  enum ph_tc_kind kind, double tolerance);

/* A cubic and the part of the curve that it is compared with. */
struct ph_tc_match {
  const ph_cplx *q; /* [degree + 1] */
  ph_cplx c[4];     /* begins and ends near it */
};

/* ph_tc_match_room: points that ph_tc_match_distance needs as `pool`. */
size_t ph_tc_match_room(size_t degree);

/*
 * ph_tc_match_distance: an upper bound of the Hausdorff distance between the
 * cubic and the part of the curve, a few percent above it where both run side
 * by side.  Without what rounding adds.
 *
 * in   same    points no further apart than this are the same
 * in   enough  bounds of distances beyond it may be loose
 * ws   pool[ph_tc_match_room(degree)]
 */
double ph_tc_match_distance(const struct ph_tc_match *match, size_t degree,
                            double same, double enough, ph_cplx *pool);

/*
 * ph_tc_least_distance: a lower bound of the Hausdorff distance between a cubic
 * and the part [from,to] of a curve, of use where they are far apart.
 */
double ph_tc_least_distance(const struct ph_tc_target *target, double from,
                            double to, const ph_cplx c[4]);

/*
 * ph_tc_inflections: where the curvature changes sign, each at the middle of a
 * dyadic interval of width 2^-31, or at its end; increasing.
 *
 * ws   arena  as it was after the call
 * out  u[2 * degree]
 * ret  PH_OK | PH_E_NO_MEMORY
 */
enum ph_status ph_tc_inflections(const struct ph_tc_bezier *curve,
                                 struct ph_arena *arena, double *u, size_t *n,
                                 struct ph_diag *diag);

/* ---- plans --------------------------------------------------------------- */

/*
 * The parts of a Bezier curve that its cubics stand for; private to
 * tc_approx*.c.
 */

/* One part of the curve, with the cubics of ph_tc_patch_of. */
struct ph_tc_part {
  double from, to;
  double distance;
  enum ph_tc_kind kind;
  unsigned n; /* cubics: 1 or 2 */
};

/* Parts in their order; room grows by doubling, in an arena. */
struct ph_tc_plan {
  struct ph_arena *arena;
  struct ph_tc_part *part;
  size_t n, room;
  size_t cubics;
  size_t limit; /* of parts */
};

/*
 * ph_tc_plan_curve: parts of a curve within a tolerance, as few cubics as are
 * found; appended.
 *
 * in   u[n]  its inflections
 * ret  PH_OK | PH_E_NO_CONVERGENCE | PH_E_NO_MEMORY
 */
enum ph_status ph_tc_plan_curve(const struct ph_tc_target *target,
                                const double *u, size_t n, double tolerance,
                                struct ph_tc_plan *plan, struct ph_diag *diag);

#endif
