/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The method `planar`: C2 interpolation of points in the plane [GON18, ch. 2]
 * by PH quintic splines, open or closed. */
#ifndef PH_SOLVE_PLANAR_METHOD_H
#define PH_SOLVE_PLANAR_METHOD_H

#include "solve/method.h"

extern const struct ph_method ph_method_planar;

#endif
