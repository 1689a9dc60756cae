/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Tensions that make a spherical nu-spline keep the shape of its data
 * [IOR15, sec. 4.2].
 *
 * Where a criterion is violated, the tensions of the nodes around are raised
 * and the spline is solved again, until all criteria hold.  A tension has an
 * effect on its neighbourhood only, which falls by a factor of about 3.7 from
 * node to node: only there the spline is solved, and judged, again.
 */
#ifndef PH_SOLVE_SPHERE_TENSION_H
#define PH_SOLVE_SPHERE_TENSION_H

#include "solve/sphere/criteria.h"
#include "solve/sphere/newton.h"

enum ph_sphere_increase {
  PH_SPHERE_MINIMAL, /* in the end the smallest that were found sufficient */
  PH_SPHERE_PLUS,    /* nu + by */
  PH_SPHERE_TIMES,   /* nu * by; by itself where nu is 0 */
  PH_SPHERE_REPAIR   /* a little; not for the caller */
};

/* How often tensions are raised at most. */
enum { PH_SPHERE_ROUNDS_MAX = 10000 };

/* Bits of criteria that are gone on without, at a node and of the segment after
 * it. */
enum { PH_SPHERE_IGNORE_NODE = 1, PH_SPHERE_IGNORE_SEGMENT = 2 };

/* How tensions are raised, and where. */
struct ph_sphere_raise {
  const struct ph_sphere_shape *shape;
  enum ph_sphere_increase increase;
  double by;
  bool waive; /* go on without criteria that no tension satisfies */
  struct ph_sphere_spline *spline;
  struct ph_sphere_work *work;
  size_t rounds; /* out: how often tensions were raised */
  size_t waived; /* out: criteria that are violated by the spline, and */
  size_t at; /* the node or segment of the first, or of the one that failed */
  enum ph_sphere_criterion criterion; /* which that is */
  /* Of the work: */
  unsigned char *ignored;         /* [n] bits of criteria that were waived */
  size_t *touched;                /* [n] nodes of this round */
  unsigned char *planned;         /* [n] and what it does to them */
  struct ph_sphere_range *ranges; /* [n] where to look, in order and apart */
  size_t ranges_n;
};

/*
 * ph_sphere_keep_shape: raises the tensions of a solution.
 *
 * inout raise  the first six members are given
 * ret  PH_OK | PH_INFEASIBLE (no tension up to 1e8 satisfies the
 *      criterion) | PH_NO_CONVERGENCE (no spline, or too many
 *      rounds) | PH_NO_MEMORY
 */
enum ph_status ph_sphere_keep_shape(struct ph_sphere_raise *raise,
                                    struct ph_arena *scratch);

/* ph_sphere_violated: the first criterion in a range that the spline violates,
 * FINE if none; at: its node or segment, from `from` places into the range,
 * which is increased past it. */
enum ph_sphere_criterion ph_sphere_violated(const struct ph_sphere_raise *raise,
                                            struct ph_sphere_range range,
                                            size_t *from, size_t *at);

#endif
