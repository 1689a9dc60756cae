/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The certificate of Tschirnhausen cubics that approximate (see cert.h). */
#ifndef PH_CERT_TC_APPROX_H
#define PH_CERT_TC_APPROX_H

#include "cert/cert.h"

/* ph_cert_tc_approximation: ph_cert_tc of the mode approximate. */
ph_cert_fn ph_cert_tc_approximation;

#endif
