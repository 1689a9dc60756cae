/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What tests of the certificate of Tschirnhausen cubics share: a curve, its
 * problem, and what the certificate says of them. */
#ifndef PH_TESTS_CERT_TC_UNIT_H
#define PH_TESTS_CERT_TC_UNIT_H

#include "check_unit.h"
#include "problem_unit.h"
#include "tc_curve_unit.h"

enum { UNIT_TC_POINTS = 5 };

struct unit_cert_tc {
  struct unit_cubics c;
  struct ph_problem problem;
  double points[2 * UNIT_TC_POINTS], vectors[2 * UNIT_TC_POINTS], ends[4];
};

/* The one that the functions are about. */
extern struct unit_cert_tc unit_tc;

/* unit_cert_begin: nothing in it; it is what the certificate is asked of. */
void unit_cert_begin(void);

static inline void unit_put(double *v, ph_cplx z) {
  v[0] = z.re;
  v[1] = z.im;
}

static inline ph_cplx unit_get(const double *v) {
  return ph_cplx_of(v[0], v[1]);
}

/* unit_unit: v/|v|. */
static inline ph_cplx unit_unit(ph_cplx v) {
  return ph_cplx_scale(1 / ph_cplx_abs(v), v);
}

/* unit_add_pair: two more cubics, the standard pair of [BYR11, thm 17] for the
 * derivatives a, b and this chord; its end is set to a point of the data. */
void unit_add_pair(ph_cplx a, ph_cplx b, ph_cplx chord, const double *end);

#endif
