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

/* ph_check_dips_of: of f(segment, u). */
struct ph_check_dips ph_check_dips_of(double (*f)(const void *, double),
                                      const struct ph_check_segment *s);

/* ph_check_square_speed: |r'|^2 of a segment at u. */
double ph_check_square_speed(const void *s, double u);

#endif
