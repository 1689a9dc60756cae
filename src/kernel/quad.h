/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Gauss-Legendre rules on [0,1], from GSL's tables. */
#ifndef PH_KERNEL_QUAD_H
#define PH_KERNEL_QUAD_H

#include <stdbool.h>
#include <stddef.h>

enum { PH_QUAD_MAX = 20 };

/* A rule: the integral of f over [0,1] is about sum weight[i] f(node[i]),
 * exact for polynomials of degree 2 n - 1. */
struct ph_quad {
  size_t n;
  double node[PH_QUAD_MAX];
  double weight[PH_QUAD_MAX];
};

/* ph_quad_gauss: the rule of n nodes, 1 <= n <= PH_QUAD_MAX; false when memory
 * is exhausted. */
bool ph_quad_gauss(struct ph_quad *rule, size_t n);

#endif
