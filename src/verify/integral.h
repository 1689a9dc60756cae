/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Adaptive Gauss quadrature that sees the ends of its intervals.
 *
 * The speed of a curve that nearly stops has a kink.  Where that is nearer to
 * the end of an interval than all nodes of a rule, the rule and those on both
 * halves agree, and are wrong; so the values at the ends are compared with what
 * the nodes say by extrapolation.
 */
#ifndef PH_VERIFY_INTEGRAL_H
#define PH_VERIFY_INTEGRAL_H

#include <stdbool.h>
#include <stddef.h>

enum { PH_VERIFY_NODES = 8 };

struct ph_verify_rule {
  double node[PH_VERIFY_NODES], weight[PH_VERIFY_NODES];
  double end[PH_VERIFY_NODES]; /* f(0) = sum end[i] f(node[i]) */
};

/* ph_verify_rule_of: false when memory is exhausted. */
bool ph_verify_rule_of(struct ph_verify_rule *rule);

/* A function of one variable. */
typedef double ph_verify_integrand(const void *context, double x);

/*
 * ph_verify_integral: the integral of f over [from,to].
 *
 * in   tolerance  absolute, per unit of x
 * in   relative   of the integral of each part
 * ret  NaN when the number of intervals does not suffice
 */
double ph_verify_integral(const struct ph_verify_rule *rule,
                          ph_verify_integrand *f, const void *context,
                          double from, double to, double tolerance,
                          double relative);

#endif
