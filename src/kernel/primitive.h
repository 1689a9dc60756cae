/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The integral of a smooth function as a table, for many evaluations: the
 * function is interpolated on panels by Chebyshev polynomials, which are
 * integrated.  Panels are halved until the interpolant is known to rounding.
 */
#ifndef PH_KERNEL_PRIMITIVE_H
#define PH_KERNEL_PRIMITIVE_H

#include "base/mem.h"
#include "base/status.h"

#include <stddef.h>

typedef double ph_integrand(const void *context, double x);

/* Coefficients of one panel: of the integral from its start and of the
 * function, in Chebyshev polynomials over it. */
enum { PH_PRIMITIVE_NODES = 16, PH_PRIMITIVE_TERMS = 18 };

struct ph_primitive_panel {
  double from, to;
  double before;                  /* integral from 0 to `from` */
  double sum[PH_PRIMITIVE_TERMS]; /* an even number: the last one is 0 */
  double value[PH_PRIMITIVE_NODES];
  size_t terms; /* of value that count, an even number; of sum 2 more */
};

/* Zeroed at first; its memory is used again for the next function. */
struct ph_primitive {
  struct ph_primitive_panel *panels;
  size_t n, room;
  double total; /* the integral over [0,1] */
};

/*
 * ph_primitive_make: tabulates the integral of f over [0,1].
 *
 * in   breaks[breaks_n]  increasing, in (0,1): where f is not smooth
 * in   tolerance         error of every integral, relative to that of |f|;
 *                        1e-14 can be reached if f is known to rounding
 * ret  PH_OK | PH_E_NO_CONVERGENCE (some 2^12 panels do not suffice, or f is
 *      not finite) | PH_E_NO_MEMORY
 */
enum ph_status ph_primitive_make(struct ph_primitive *primitive,
                                 ph_integrand *f, const void *context,
                                 const double *breaks, size_t breaks_n,
                                 double tolerance, struct ph_arena *arena);

/* ph_primitive_at: the integral over [0,u]; out  value  NULL, or f(u), to some
 * 64 tolerances of the mean of |f| */
double ph_primitive_at(const struct ph_primitive *primitive, double u,
                       double *value);

#endif
