/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How the energies of a planar spline change with its angles and knots. */
#ifndef PH_SOLVE_PLANAR_GRADIENT_H
#define PH_SOLVE_PLANAR_GRADIENT_H

#include "kernel/quad.h"
#include "solve/planar/data.h"

struct ph_planar_gradient {
  struct ph_tri tri;
  struct ph_quad rule;
  ph_cplx *by_w;     /* [n][3] */
  ph_cplx *equation; /* [n] change of the equations with the angles */
  ph_cplx *by_b;     /* [unknowns] */
  ph_cplx *adjoint;  /* [unknowns] */
  double *by_y;      /* [n + 1] */
  double *by_angle;  /* [n] result: a d/da */
  double *by_h;      /* [n] result: h d/dh, the mean of all h aside */
};

/* ph_planar_gradient_alloc: workspace.  ret PH_OK | PH_NO_MEMORY */
enum ph_status ph_planar_gradient_alloc(struct ph_planar_gradient *g,
                                        const struct ph_planar_data *data,
                                        struct ph_arena *arena,
                                        struct ph_diag *diag);

/*
 * ph_planar_gradient_of: gradient of
 *   weight[0] E + weight[1] MV + weight[2] L  at unit scale.
 *
 * in   b[unknowns]  a solution of the C2 equations
 * in   parts[n]     intervals that its energies were integrated on
 * out  g->by_angle, g->by_h
 */
void ph_planar_gradient_of(struct ph_planar_gradient *g,
                           const struct ph_planar_data *data, const ph_cplx *b,
                           const double weight[3], const size_t *parts);

#endif
