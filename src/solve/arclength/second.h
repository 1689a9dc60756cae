/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Second derivatives of an interval, of which matrices are made (matrix.c). */
#ifndef PH_SOLVE_ARCLENGTH_SECOND_H
#define PH_SOLVE_ARCLENGTH_SECOND_H

#include "solve/arclength/system.h"

/* Those of an interval by its unknowns. */
struct ph_arc_second {
  size_t n;
  double a[PH_ARC_LOCAL][PH_ARC_LOCAL];
};

/* ph_arc_second_lambda: sum_k y_k S_k of an interval; y NULL: 0. */
void ph_arc_second_lambda(const struct ph_arc_system *system, size_t interval,
                          const double *y, double lambda[16]);

/* ph_arc_second_nodes: by nodes a and b of interval i,
 * 2 G_ab lambda + 2 functional sum_q e_qa e_qb.  out square[dim][dim] */
static inline void ph_arc_second_nodes(const struct ph_arc_system *s, size_t i,
                                       size_t a, size_t b, double functional,
                                       const double *lambda, size_t dim,
                                       double *square) {
  const double *second = s->second + 3 * i * s->refine;
  double f = 0, g = 2 * s->gram[(i * s->span + a) * s->span + b];
  for (size_t q = 0; q < s->refine; q++) {
    bool has = q <= a && a <= q + 2 && q <= b && b <= q + 2;
    f += has ? second[3 * q + a - q] * second[3 * q + b - q] : 0;
  }
  for (size_t d = 0; d < dim; d++) {
    for (size_t e = 0; e < dim; e++) {
      square[d * dim + e] = g * lambda[d * dim + e];
    }
    square[d * dim + d] += 2 * functional * f;
  }
}

/* ph_arc_second_wrapped: of an interval with nodes beyond the seam. */
void ph_arc_second_wrapped(const struct ph_arc_system *system, size_t interval,
                           const double *x, const double *y, double functional,
                           struct ph_arc_second *second);

/* ph_arc_second_meet: whether unknowns a and b of an interval have second
 * derivatives: nodes that are in one segment, and all with chi. */
static inline bool ph_arc_second_meet(const struct ph_arc_system *system,
                                      size_t a, size_t b) {
  size_t i = a / system->dim, j = b / system->dim, span = system->span;
  return i == span || j == span || (i <= j + 2 && j <= i + 2);
}

/* ph_arc_pins: what leaves all equations as they are: the common phase; of data
 * on a line also a turn about it, so that a and b have a phase each.  One node
 * is held.
 * out node, out  the directions in which it is
 * ret  how many there are, 0 to 2 */
size_t ph_arc_pins(const struct ph_arc_system *system, const double *x,
                   size_t *node, double out[2][4]);

#endif
