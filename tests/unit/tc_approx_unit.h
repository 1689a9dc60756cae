/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the tests of approximations by Tschirnhausen cubics have in common. */
#ifndef PH_TESTS_TC_APPROX_UNIT_H
#define PH_TESTS_TC_APPROX_UNIT_H

#include "solve/tc/approx.h"

/* The point of a Bezier curve. */
ph_cplx unit_bezier_at(const struct ph_tc_bezier *curve, double u);

/* How far p is from the curve, or from some cubics: the least distance of many
 * points, those brought nearer that are near to it. */
double unit_bezier_away(const struct ph_tc_bezier *curve, ph_cplx p);
double unit_arcs_away(const struct ph_tc_arc *arcs, size_t n, ph_cplx p);

/* The largest of such distances both ways: no more than the Hausdorff distance
 * if the nearest points are found. */
double unit_arcs_distance(const struct ph_tc_bezier *curve,
                          const struct ph_tc_arcs *arcs);

#endif
