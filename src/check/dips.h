/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Dips of functions of a segment: where a curve nearly stops, what happens in a
 * short part of it is seen from there, and nowhere else.
 */
#ifndef PH_CHECK_DIPS_H
#define PH_CHECK_DIPS_H

#include "check/segment.h"

/* How many there are at most in a quintic. */
enum { PH_CHECK_DIPS = 4 };

struct ph_check_dips {
  double x[PH_CHECK_DIPS]; /* inside [0,1], in order */
  double low, high;        /* the least and the largest value */
  size_t n;
};

/* ph_check_dips_of: of f(of, u). */
struct ph_check_dips ph_check_dips_of(double (*f)(const void *, double),
                                      const void *of);

/* ph_check_slow_of: of |r'|^2, where it falls far below its largest value; else
 * none, with a bound as low, and high is not known.  What is in the convex hull
 * of control points is no nearer to 0 than they are to the side of a plane; of
 * ATPH segments (S0 + S1)^m >= 1 in the place of 1. */
struct ph_check_dips ph_check_slow_of(const struct ph_check_segment *s);

#endif
