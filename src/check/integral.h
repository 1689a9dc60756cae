/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Adaptive Gauss quadrature that sees the ends of its intervals.
 *
 * The speed of a curve that nearly stops has a kink.  Where that is nearer to
 * the end of an interval than all nodes of a rule, the rule and those on both
 * halves agree, and are wrong; so the values at the ends are compared with what
 * the nodes say by extrapolation.  A curve that rests at its end, and turns
 * back soon, has the value 0 there in any case: then the slopes are compared.
 */
#ifndef PH_CHECK_INTEGRAL_H
#define PH_CHECK_INTEGRAL_H

#include "base/mem.h"

#include <stdbool.h>
#include <stddef.h>

enum { PH_CHECK_NODES = 8 };

/* How far from an end its slope is measured, of an interval. */
#define PH_CHECK_NEXT 2.5e-4

struct ph_check_rule {
  const struct ph_arena *arena; /* knows how much time there is */
  double node[PH_CHECK_NODES], weight[PH_CHECK_NODES];
  double end[PH_CHECK_NODES];  /* f(0) = sum end[i] f(node[i]) */
  double next[PH_CHECK_NODES]; /* f(PH_CHECK_NEXT), likewise */
};

/* ph_check_rule_of: false when memory is exhausted. */
bool ph_check_rule_of(struct ph_check_rule *rule, const struct ph_arena *arena);

/* At most so many functions at once. */
enum { PH_CHECK_TOGETHER = 10 };

/* Functions of one variable: out  value[n]. */
typedef void ph_check_integrand(const void *context, double x, double *value);

/* What is integrated together. */
struct ph_check_integrands {
  ph_check_integrand *f;
  const void *context;
  size_t n;         /* functions */
  size_t uncertain; /* 0; or n = 2 uncertain, and the second half are errors of
                       the first, which are found about, and of which these
                       need not be found better than that */
  double tolerance; /* absolute, per unit of x */
  double relative;  /* of the integral */
};

/*
 * ph_check_integral: the integrals over [from,to].
 *
 * out  sum[n]  NaN when the number of intervals or the time does not suffice,
 *              or where a function is not finite; the others do not suffer from
 *              that
 */
void ph_check_integral(const struct ph_check_rule *rule,
                       const struct ph_check_integrands *of, double from,
                       double to, double *sum);

#endif
