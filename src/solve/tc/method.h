/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The method `tc`: plane data to curves of Tschirnhausen cubics, the PH cubics:
 * one for each interval, two, or as many as approximate a curve. [BYR11]
 */
#ifndef PH_SOLVE_TC_METHOD_H
#define PH_SOLVE_TC_METHOD_H

#include "solve/method.h"

extern const struct ph_method ph_method_tc;

#endif
