/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A spherical nu-spline at given tensions, from nothing. */
#ifndef PH_SOLVE_SPHERE_SOLVE_H
#define PH_SOLVE_SPHERE_SOLVE_H

#include "solve/sphere/newton.h"

/*
 * ph_sphere_solve: the whole spline, from the start of its model.  Where
 * Newton's iteration fails, from large tensions, at which the spline hugs the
 * data, down to those asked for; then by relaxation from other starts, and at
 * last in a way of the model's own.
 *
 * out  s    x, r, l
 * ret  whether a solution was found
 */
bool ph_sphere_solve(struct ph_sphere_spline *s, struct ph_sphere_work *work);

#endif
