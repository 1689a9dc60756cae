/* SPDX-License-Identifier: GPL-3.0-or-later */
/* C2 spatial PH quintic splines with prescribed arc lengths [HUA14]. */
#ifndef PH_SOLVE_ARCLENGTH_METHOD_H
#define PH_SOLVE_ARCLENGTH_METHOD_H

#include "solve/method.h"

extern const struct ph_method ph_method_arclength;

#endif
