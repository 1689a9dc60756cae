/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Tschirnhausen cubics and curves of them for tests, worked out from their
 * preimages in long double and by nothing of src/ but the structs that hold
 * them; and how far approximations by them are from a curve.
 */
#ifndef PH_TESTS_TC_CURVE_UNIT_H
#define PH_TESTS_TC_CURVE_UNIT_H

#include "unit.h"

#include "curve/result.h"
#include "curve/segment/tc.h"
#include "kernel/cplx.h"
#include "solve/tc/approx.h"

/* unit_tc_at: the point r(t) - r(0) of a cubic, t of any size. */
ph_cplx unit_tc_at(const struct ph_tc *tc, double t);

enum { UNIT_CUBICS = 64 };

/* A curve of up to so many cubics. */
struct unit_cubics {
  struct ph_curve curve;
  ph_cplx at; /* where the next one starts */
  double knots[UNIT_CUBICS + 1], control_points[8 * UNIT_CUBICS];
  double preimage[4 * UNIT_CUBICS], lengths[UNIT_CUBICS];
};

/* unit_cubics_begin: no cubics yet. */
void unit_cubics_begin(struct unit_cubics *c, ph_cplx start);

/* unit_cubics_add: one more. */
void unit_cubics_add(struct unit_cubics *c, ph_cplx w0, ph_cplx w1);

/* unit_cubics_random: n cubics of the size `scale` from `start` on, turning by
 * less than a whole turn each, with one tangent at each joint. */
void unit_cubics_random(struct unit_cubics *c, struct unit_random *r, size_t n,
                        double scale, ph_cplx start);

/* unit_cubic_bend: K = Im(conj(w0) w1) of cubic k: its curvature is 2 K/|w|^4.
 */
double unit_cubic_bend(const struct unit_cubics *c, size_t k);

/* unit_cubic_slowest: the least |w|^2 on [0,1], that of the foot of the origin
 * on the line of w where it is within. */
double unit_cubic_slowest(const struct unit_cubics *c, size_t k);

/* ---- approximations ------------------------------------------------------ */

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
