/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The table of kinds (see kind.h). */
#include "check/kind.h"

#include "check/checks.h"
#include "check/spherical.h"
#include "check/tc_g2.h"

/* Points and tensions of a spline on a sphere. */
static void check_spline(struct ph_check *v) {
  ph_check_on_sphere(v);
  ph_check_tensions(v);
}

/* Products of S0 and S1, and great circles. */
#define FORM                                            \
  .load = ph_check_form_load, .jet = ph_check_form_jet, \
  .point = ph_check_form_point, .local = ph_check_form_local
#define GREAT                                             \
  .load = ph_check_great_load, .jet = ph_check_great_jet, \
  .point = ph_check_great_point, .local = ph_check_great_local

const struct ph_check_kind ph_check_kinds[PH_CURVE_N] = {
    [PH_CURVE_PH] = {FORM, .square = true},
    [PH_CURVE_ATPH] = {FORM, .square = true, .angles = true,
                       .trigonometric = true},
    [PH_CURVE_BEZIER] = {FORM, .trigonometric = true, .converted = true},
    [PH_CURVE_TC] = {FORM, .square = true, .whole = ph_check_curvature},
    [PH_CURVE_SPHERICAL_NU] = {GREAT, .sphere = true, .whole = check_spline},
    /* cone.h, in place of all, but of contact curves of general cones */
    [PH_CURVE_CONE] = {FORM, .square = true, .angles = true,
                       .trigonometric = true},
    [PH_CURVE_BUBBLE] = {0}}; /* bubble.h, in place of all */
