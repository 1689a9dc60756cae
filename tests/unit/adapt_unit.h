/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Adaptive Gauss quadrature of a function of one variable: what lengths are
 * compared with. */
#ifndef ADAPT_UNIT_H
#define ADAPT_UNIT_H

#include "kernel/primitive.h"
#include "kernel/quad.h"

/*
 * unit_adapt: the integral of f over [from,to].
 *
 * An interval is halved until one rule on it and the rule on either half agree
 * to `tolerance` times its length, or to `relative` times themselves.  The
 * halves are kept, which are far better than the difference says.
 *
 * in   tolerance  absolute, per unit of x
 * in   relative   as well as f is known, at least
 * ret  NaN when the number of intervals does not suffice
 */
double unit_adapt(const struct ph_quad *rule, ph_integrand *f,
                  const void *context, double from, double to, double tolerance,
                  double relative);

#endif
