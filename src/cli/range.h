/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Ranges of numbers, START:STOP:COUNT or START:STOP:COUNT:log, as options take
 * them. */
#ifndef PH_CLI_RANGE_H
#define PH_CLI_RANGE_H

#include "base/diag.h"

#include <stdbool.h>
#include <stddef.h>

/* n numbers at equal distances, or equal ratios; both ends are exact. */
struct ph_range {
  double start, stop;
  size_t n; /* >= 1 */
  bool log;
};

/*
 * ph_range_read: reads a text of n bytes, which has a colon.
 *
 * in   most    how many numbers there may be
 * in   option  the name of the option, for the message
 * ret  PH_OK | PH_E_USAGE
 */
enum ph_status ph_range_read(const char *text, size_t n, double most,
                             const char *option, struct ph_range *range,
                             struct ph_diag *diag);

/* ph_range_at: number i of a range. */
double ph_range_at(const struct ph_range *range, size_t i);

#endif
