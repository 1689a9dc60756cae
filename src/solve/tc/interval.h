/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The curves of one or two Tschirnhausen cubics that an interval of the data
 * may have, by the mode of the problem. */
#ifndef PH_SOLVE_TC_INTERVAL_H
#define PH_SOLVE_TC_INTERVAL_H

#include "solve/tc/data.h"
#include "solve/tc/pair.h"

enum { PH_TC_FITS_MAX = PH_TC_PAIRS };

/*
 * ph_tc_interval: the best, or the standard one, for interval k.
 *
 * out  fit   complete but for what need not be known: simple is true only where
 *            the curve is known to be, by a test or by sight of the data
 * ret  PH_OK | PH_INFEASIBLE (says why)
 */
enum ph_status ph_tc_interval(const struct ph_tc_data *data, size_t k,
                              struct ph_tc_fit *fit, struct ph_diag *diag);

/* ph_tc_interval_all: all of them, best first, measured and tested.
 *
 * out  n  how many, at least 1 if PH_OK
 */
enum ph_status ph_tc_interval_all(const struct ph_tc_data *data, size_t k,
                                  struct ph_tc_fit fits[PH_TC_FITS_MAX],
                                  size_t *n, struct ph_diag *diag);

/* Intervals whose curve is not known to be simple. */
struct ph_tc_crossings {
  size_t n, first;
};

/* ph_tc_crossings_see: interval k has this curve; in the order of k. */
static inline void ph_tc_crossings_see(struct ph_tc_crossings *crossings,
                                       size_t k, const struct ph_tc_fit *fit) {
  if (!fit->simple && crossings->n++ == 0) {
    crossings->first = k;
  }
}

#endif
