/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * What tests of planar splines share: a problem with its solution, and the
 * values of its curve, computed from the control points alone and by nothing
 * of src/ but the struct that holds them.
 */
#ifndef PH_TESTS_PLANAR_UNIT_H
#define PH_TESTS_PLANAR_UNIT_H

#include "problem_unit.h"

#include "kernel/cplx.h"

#include <stdbool.h>
#include <stddef.h>

/* unit_planar_of: a problem through n points v[2 n], which are copied. */
struct unit_solution unit_planar_of(const double *v, size_t n, bool closed);

/* The optional fields; arrays are copied. */
void unit_planar_rule(struct unit_solution *u, const char *rule);
void unit_planar_knots(struct unit_solution *u, const double *v, size_t n);
void unit_planar_ends(struct unit_solution *u, const double v[4]);

/* Basis atph with these angles, one a segment. */
void unit_planar_atph(struct unit_solution *u, const double *alpha, size_t n);

/* unit_planar_solve: solves, then certifies; the memory of the solver that is
 * to be given back is checked.  May be called again. */
enum ph_status unit_planar_solve(struct unit_solution *u);

/* unit_planar_size: half the diagonal of the points' bounding box. */
double unit_planar_size(const struct unit_solution *u);

/* unit_planar_warned: whether the result has a warning of this status. */
bool unit_planar_warned(const struct unit_solution *u, enum ph_status status);

/* unit_bezier: value at t, and derivative `order` (0, 1 or 2) with respect to
 * t, of the Bezier curve of `degree` with points p[degree + 1][2]. */
ph_cplx unit_bezier(const double *p, size_t degree, size_t order, double t);

/* unit_curve: point or derivative of segment k of a curve at t in [0,1]. */
ph_cplx unit_curve(const struct ph_curve *curve, size_t k, size_t order,
                   double t);

/* unit_preimage: w of segment k at t, or its derivative. */
ph_cplx unit_preimage(const struct ph_curve *curve, size_t k, size_t order,
                      double t);

/* unit_curves_apart: the largest distance of the control points of two curves
 * of as many segments. */
double unit_curves_apart(const struct ph_curve *a, const struct ph_curve *b);

#endif
