/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The equations for the tangents of curvature-continuous splines (see g2.h).
 *
 * At a node between spans i - 1 and i of lengths L
 *
 *   F = g(a[i-1], b[i-1]) - ln L[i-1] - f(a[i], b[i]) + ln L[i] = 0
 *
 * where the turn phi is shared, b[i-1] + a[i] = phi.  Between two arcs the
 * unknown is y = ln(b/a), so that both stay positive and flat nodes cost no
 * digits; beside one bend, ln of the angle on the side of the arc; between two
 * bends the angle itself, over that of the turns around.  Nodes beside a line
 * have its tangent and no equation.
 *
 * For continuation turns and ln L are multiplied by h in (0, 1].
 */
#ifndef PH_SOLVE_TC_G2_SYSTEM_H
#define PH_SOLVE_TC_G2_SYSTEM_H

#include "kernel/tri.h"
#include "solve/tc/g2.h"

/* Of the residuals of one part. */
struct ph_g2_sum {
  double norm2, largest;
};

/* How the tangent at a node is unknown. */
enum ph_g2_kind {
  PH_G2_KNOWN,
  PH_G2_SHARED,    /* between two arcs */
  PH_G2_OF_BEFORE, /* an arc before it */
  PH_G2_OF_AFTER,  /* an arc after it */
  PH_G2_BETWEEN_BENDS
};

/* The curve of one iterate. */
struct ph_g2_state {
  double *y;               /* [nodes] the unknowns */
  double *before, *after;  /* [nodes] b before and a after each node */
  double *rate;            /* [nodes] derivative of `before` by y */
  struct ph_g2_ends *ends; /* [n] */
  struct ph_g2_sum *sum;   /* [parts] */
  double norm2, largest;   /* of the residuals */
};

struct ph_g2_system {
  const struct ph_g2_chain *chain;
  const struct ph_arena *arena; /* its threads share what is long */
  double h;                     /* continuation */
  double smooth[2];             /* angles at the ends; NaN where the rule is */
  unsigned char *kind;          /* [nodes] enum ph_g2_kind */
  double *log_length;           /* [n] */
  double *last;                 /* [nodes] unknowns that it begins at */
  struct ph_g2_state now;
  struct ph_tri tri;
  size_t iterations;
};

/* ph_g2_system_begin: what is unknown, of a chain. */
void ph_g2_system_begin(struct ph_g2_system *s);

/*
 * ph_g2_system_part: the chain of n spans from node `first` on, between the
 * tangents of s->now.
 *
 * inout  part  has room for n + 1 nodes and n spans
 */
void ph_g2_system_part(const struct ph_g2_system *s, size_t first, size_t n,
                       struct ph_g2_chain *part);

/* ph_g2_system_start: unknowns s->now.y for the iteration to begin with: from
 * circles through three points, or from halves of the turns. */
void ph_g2_system_start(struct ph_g2_system *s, bool halves);

/*
 * ph_g2_system_evaluate: all of the iterate s->now from its unknowns.
 *
 * ret  false: it is not allowed
 */
bool ph_g2_system_evaluate(struct ph_g2_system *s);

/* ph_g2_system_residual: of node k, known or not, at s->now. */
double ph_g2_system_residual(const struct ph_g2_system *s, size_t k);

/* ph_g2_system_row: of Newton's method, at s->now. */
struct ph_tri_row ph_g2_system_row(const struct ph_g2_system *s, size_t k);

/* ph_g2_system_step: of the unknown of node k, after ph_tri_finish_here. */
static inline double ph_g2_system_step(const struct ph_g2_system *s, size_t k) {
  return s->tri.pivot[k].f.re;
}

#endif
