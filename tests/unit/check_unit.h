/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What tests of certificates share: one that is asked, and its verdict. */
#ifndef PH_TESTS_CHECK_UNIT_H
#define PH_TESTS_CHECK_UNIT_H

#include "check/certify.h"

#include <stdbool.h>
#include <stddef.h>

/* A certificate: of which command and what it is asked, which a test sets
 * once, and what it says. */
struct unit_checked {
  const char *command;
  const struct ph_problem *problem;
  const struct ph_curve *curve;
  struct ph_diagnostics claims; /* known before */
  struct ph_diagnostics diagnostics;
  struct ph_diag diag;
};

/* The one that the functions are about. */
extern struct unit_checked checked;

/* certify: asks it, with the claims; a curve that it accepts is described. */
enum ph_status certify(void);

/* value_of: a diagnostic, which must be known. */
bool is_known(enum ph_diagnostic what);
double value_of(enum ph_diagnostic what);

/* Accepted; refused for this reason, in any segment, in a or b, in this one. */
void ck_accepted(void);
void ck_refused_somewhere(enum ph_diagnostic what);
void ck_refused_in(enum ph_diagnostic what, size_t a, size_t b);
void ck_refused(enum ph_diagnostic what, size_t segment);

/* ck_each_moved, ck_each_scaled: each of x[n], of which a segment has `per`, is
 * refused for this reason in its segment when `by` is added to it, or it is
 * multiplied by 1 + by; as they are, they are accepted. */
void ck_each_moved(double *x, size_t n, size_t per, double by,
                   enum ph_diagnostic what);
void ck_each_scaled(double *x, size_t n, double by, enum ph_diagnostic what);

/* Refused in words that have these. */
void ck_refused_for(const char *words);

/* ck_not_finite: n numbers of the curve that are none are refused as such. */
void ck_not_finite(double *x, size_t n);

#endif
