/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The certificate of Tschirnhausen cubics that approximate (see certify.h). */
#ifndef PH_CHECK_TC_APPROX_H
#define PH_CHECK_TC_APPROX_H

#include "check/certify.h"

/* ph_check_tc_approximation: ph_check_tc of the mode approximate. */
ph_promise_fn ph_check_tc_approximation;

#endif
