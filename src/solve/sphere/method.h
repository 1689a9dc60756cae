/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The method `sphere`: shape-preserving G2 curves on the sphere. */
#ifndef PH_SOLVE_SPHERE_METHOD_H
#define PH_SOLVE_SPHERE_METHOD_H

#include "solve/method.h"

extern const struct ph_method ph_method_sphere;

#endif
