/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Splines of Tschirnhausen cubics whose curvature is continuous (mode g2).
 *
 * A cubic has curvature of one sign, or none.  Between points where the data
 * turn to one side stands one cubic, given by the angles of its end tangents to
 * its chord: it exists, without a loop, and is the only one, where both are
 * positive in the sense of the turn and their sum is below 4 pi/3.  Between
 * points of opposite turns stand two, which meet at an inflection beside the
 * chord: a bend.  There, and where a straight run begins or ends, the curvature
 * jumps; it has to, as often as that, for any curve of such cubics.  Everywhere
 * else it is the same on both sides.
 *
 * One unknown for each point, the angle of its tangent, and one equation, that
 * the logarithms of both curvatures are equal: a tridiagonal system, cyclic for
 * closed data.  Newton's method with steps that are halved until the residual
 * falls; if it fails, continuation from data that are nearly straight; long
 * chains block by block, as what is far away hardly matters.  Where
 * neighbouring turns are so large that solutions would be several, or none,
 * points are added between them.
 *
 * Angles a and b: from the start tangent to the chord and from the chord to the
 * end tangent, both positive in the sense of the turn.
 */
#ifndef PH_SOLVE_TC_G2_H
#define PH_SOLVE_TC_G2_H

#include "base/team.h"
#include "solve/tc/tc.h"

/* ---- one span ------------------------------------------------------------ */

/* A cubic turns by less than this. */
#define PH_G2_TURN_MAX (4 * PH_PI / 3)

/*
 * ln(|curvature| chord) at both ends of a span, f and g, and their derivatives
 * by the angles.
 */
struct ph_g2_ends {
  double f, g, f_a, f_b, g_a, g_b;
};

/*
 * ph_g2_arc: of the cubic with these angles.
 *
 * ret  false unless there is one without a loop
 */
bool ph_g2_arc(double a, double b, struct ph_g2_ends *ends);

/* ph_g2_preimage: of the same, on the chord 1, turning left; a, b as ph_g2_arc
 * has taken. */
struct ph_tc ph_g2_preimage(double a, double b);

/*
 * The two cubics of a bend on the chord 1: the first turns left.  Their joint
 * is at the inflection of the ordinary cubic Hermite polynomial with these
 * tangents.
 */
struct ph_g2_bend {
  ph_cplx joint;
  double a[2], b[2]; /* angles of the first and of the second, each to its own
                        chord and in its own sense */
};

/* ph_g2_bend_of: for angles each in the sense of its own end, a + b > 0. */
struct ph_g2_bend ph_g2_bend_of(double a, double b);

/*
 * ph_g2_bend_ends: as ph_g2_arc; both angles may be negative, about -b/2 and
 * -a/2 at most.
 */
bool ph_g2_bend_ends(double a, double b, struct ph_g2_ends *ends);

/* ---- the chain ----------------------------------------------------------- */

/* What stands between two points. */
enum ph_g2_form { PH_G2_LINE, PH_G2_ARC, PH_G2_BEND };

struct ph_g2_span {
  ph_cplx chord;
  double length;
  enum ph_g2_form form;
  signed char sense; /* of the turn at its start: 1 to the left, or -1 */
};

#define PH_G2_ADDED SIZE_MAX

/* A point: of the data, or one that was added. */
struct ph_g2_node {
  ph_cplx p;        /* at unit scale */
  size_t datum;     /* or PH_G2_ADDED */
  double turn;      /* from chord to chord, to the left; at an end of open data
                       from the given tangent to the chord or back, else 0 */
  signed char sign; /* of the turn, or as it was chosen; 0: straight */
  bool inner;       /* it has two spans */
};

/* An interval of the data where there is no curve: none was found, or the data
 * turn back or have a corner at one of its ends. */
enum ph_g2_hard { PH_G2_EASY, PH_G2_HARD, PH_G2_STUCK };

struct ph_g2_chain {
  const struct ph_tc_data *data;
  size_t n;       /* spans */
  size_t nodes_n; /* n if closed, else n + 1 */
  bool closed;
  bool given[2];              /* whether there are end tangents */
  ph_cplx tangent[2];         /* these */
  const unsigned char *loose; /* [points] whether at a datum that ends a
                                 straight run the tangent need not be along
                                 it */
  unsigned char *hard;        /* [intervals of the data] enum ph_g2_hard */
  struct ph_g2_node *node;
  struct ph_g2_span *span;
};

/* ph_g2_next: the node at the end of span i. */
static inline size_t ph_g2_next(const struct ph_g2_chain *chain, size_t i) {
  return i + 1 < chain->nodes_n ? i + 1 : 0;
}

/* ph_g2_before: the span that ends at an inner node. */
static inline size_t ph_g2_before(const struct ph_g2_chain *chain, size_t k) {
  return k > 0 ? k - 1 : chain->n - 1;
}

/*
 * ph_g2_chain_of: n intervals of the data.
 *
 * in    tangent  [2] unit tangents at its ends, NaN where they are free; NULL
 *                for all of closed data
 * inout chain    with `data', `loose' and `hard'
 * ret   PH_OK | PH_E_NO_MEMORY
 */
enum ph_status ph_g2_chain_of(size_t first, size_t n, const ph_cplx tangent[2],
                              struct ph_arena *arena, struct ph_g2_chain *chain,
                              struct ph_diag *diag);

/* An apex that is to be added over a span. */
struct ph_g2_apex {
  size_t span;
  double base[2]; /* angles at both ends, in the sense of the turn */
  double sense;
};

/*
 * ph_g2_add: another chain, with apexes added.
 *
 * in   apex[n]  in the order of spans
 */
enum ph_status ph_g2_add(const struct ph_g2_chain *chain,
                         const struct ph_g2_apex *apex, size_t n,
                         struct ph_arena *arena, struct ph_g2_chain *grown,
                         struct ph_diag *diag);

/* ph_g2_mark: that intervals are hard, or no longer: those of spans first to
 * end - 1. */
void ph_g2_mark(const struct ph_g2_chain *chain, size_t first, size_t end,
                enum ph_g2_hard hard);

/*
 * ph_g2_plan: adds points where turns are too large, more where intervals are
 * hard, and says what stands between all.
 *
 * in   may_add  whether points may be added
 * ret  PH_OK | PH_E_INFEASIBLE (the data turn back; they may not be added to)
 *      | PH_E_NO_CONVERGENCE (they have a corner between straight runs) |
 *      PH_E_NO_MEMORY
 */
enum ph_status ph_g2_plan(struct ph_g2_chain *chain, bool may_add,
                          struct ph_arena *arena, struct ph_diag *diag);

/* Long chains are gone through in parts of so many nodes; so many, 2 ms or
 * more, are worth another thread. */
enum { PH_G2_PART = 1024, PH_G2_WORTH = 4096 };

/* ph_g2_share: work for n nodes, spans or intervals by the threads that the
 * arena knows of (ph_team_share). */
static inline void ph_g2_share(const struct ph_arena *arena, size_t n,
                               bool (*work)(void *context, size_t thread,
                                            size_t first, size_t end),
                               void *context) {
  ph_team_share(arena, n, PH_G2_WORTH, PH_G2_PART, work, context);
}

/* ---- the system ---------------------------------------------------------- */

/* The rule for an end whose tangent is not given. */
enum ph_g2_rule { PH_G2_CIRCLE, PH_G2_SMOOTH };

/* Angles of all spans that make curvatures equal. */
struct ph_g2_solution {
  double *a, *b;     /* [n] at the start and at the end of each span */
  size_t iterations; /* of Newton's method */
  double residual;   /* largest |ln| of a quotient of curvatures */
};

/*
 * ph_g2_solve: the angles; where none are found intervals are hard.
 *
 * ret  PH_OK | PH_E_NO_CONVERGENCE | PH_E_NO_MEMORY
 */
enum ph_status ph_g2_solve(const struct ph_g2_chain *chain,
                           enum ph_g2_rule rule, struct ph_arena *arena,
                           struct ph_g2_solution *solution,
                           struct ph_diag *diag);

/*
 * ph_g2_find: what stands between n intervals of the data, and its angles, with
 * more points where that makes it fairer, or is needed.
 *
 * in    tangent  as for ph_g2_chain_of
 * in    may_add  whether points may be added
 * inout chain    with `data', `loose' and `hard'; the one that was found
 * ret   as ph_g2_chain_of, ph_g2_plan and ph_g2_solve
 */
enum ph_status ph_g2_find(size_t first, size_t n, const ph_cplx tangent[2],
                          bool may_add, enum ph_g2_rule rule,
                          struct ph_arena *arena, struct ph_g2_chain *chain,
                          struct ph_g2_solution *solution,
                          struct ph_diag *diag);

/* ---- parts --------------------------------------------------------------- */

/* Intervals of the data whose curvature is continuous, or one that has the pair
 * of the mode spline. */
struct ph_g2_part {
  size_t first, n; /* intervals */
  bool pair;
  bool solved;
  struct ph_tc_fit fit; /* of a pair */
  struct ph_g2_chain chain;
  struct ph_g2_solution solution;
};

struct ph_g2_parts {
  struct ph_g2_part *part;
  size_t n;
};

/*
 * ph_g2_parts_of: one part, or more where the curve would bend more than that
 * of the mode spline, or is not found.
 *
 * inout  chains  the memory of the chains of the parts and of their solutions
 * ret  PH_OK | PH_E_INFEASIBLE | PH_E_NO_CONVERGENCE | PH_E_NO_MEMORY
 */
enum ph_status ph_g2_parts_of(const struct ph_problem *problem,
                              const struct ph_tc_data *data,
                              struct ph_arena *arena, struct ph_arena *chains,
                              struct ph_g2_parts *parts, struct ph_diag *diag);

#endif
