/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The table of promises (see promise.h). */
#include "check/certify.h"

#include <string.h>

/* curves that are found, and Bezier curves in place of atph */
#define SMOOTH (PH_KIND(PH) | PH_KIND(ATPH) | PH_KIND(BEZIER))

/* The solver stops at 1e-13 of each chord, and the middle leg of the hodograph
 * carries 15 times that. */
static const struct ph_tolerance PLANAR = {.of_size = 1e-13,
                                           .square = 1e-11,
                                           .square_of_size = 1e-9,
                                           .length = 1e-11,
                                           .joint = 1e-9,
                                           .given = 1e-9};

/* Beside the rounding of control points, the solver leaves that of a few
 * operations. */
static const struct ph_tolerance SPATIAL = {.of_size = 1e-13,
                                            .square = 1e-13,
                                            .length = 1e-13,
                                            .joint = 1e-12,
                                            .given = 1e-12};

/* The solver meets each equation to 1e-12 of the mean length.  A middle leg
 * that is off by that in each coordinate makes 1.875 sqrt(3) = 3.3 times as
 * much in r'. */
static const struct ph_tolerance ARCLENGTH = {.point = 1,
                                              .gap = 1,
                                              .square = 1e-13,
                                              .length = 1e-13,
                                              .joint = 1e-12,
                                              .given = 1e-13,
                                              .miss = 4e-12};

const struct ph_promise ph_promises[] = {
    {.command = "planar",
     .allow = &PLANAR,
     .unit = PH_UNIT_DATA,
     .kinds = SMOOTH,
     .dimension = 2,
     .degree = 5,
     .join = PH_JOIN_SECOND,
     .given = PH_GIVEN_KNOTS,
     .ends = true},
    {.command = "spatial-hermite",
     .allow = &SPATIAL,
     .segment = ph_check_spatial_shape,
     .certify = ph_check_spatial_hermite,
     .kinds = SMOOTH,
     .dimension = 3,
     .degree = 5,
     .join = PH_JOIN_TANGENT,
     .given = PH_GIVEN_TENSION,
     .tension = true},
    {.command = "arclength",
     .allow = &ARCLENGTH,
     .unit = PH_UNIT_INTERVAL,
     .certify = ph_check_arclength,
     .kinds = PH_KIND(PH),
     .dimension = 3,
     .degree = 5,
     .join = PH_JOIN_SECOND,
     .given = PH_GIVEN_KNOTS,
     .lengths = true,
     .intervals = true},
    /* r'', the geodesic curvature, is a matter of the model (tension.c), and
     * so are the ends (on_sphere.c) */
    {.command = "sphere",
     .certify = ph_check_sphere,
     .kinds = PH_KIND(SPHERICAL_NU),
     .dimension = 3,
     .degree = 3,
     .join = PH_JOIN_FIRST},
    {.command = "tc",
     .certify = ph_check_tc,
     .kinds = PH_KIND(TC),
     .dimension = 2,
     .degree = 3,
     .join = PH_JOIN_TANGENT,
     .given = PH_GIVEN_CUBIC,
     .ends = true,
     .intervals = true,
     .approximate = true},
    {.command = "cone",
     .certify = ph_check_cone,
     .kinds = PH_KIND(CONE),
     .dimension = 3,
     .parts = PH_STRIPS_PARTS},
    {.command = "bubble",
     .certify = ph_check_bubble,
     .kinds = PH_KIND(BUBBLE),
     .dimension = 3,
     .parts = PH_PATCHES_PARTS}};

const size_t ph_promises_n = sizeof ph_promises / sizeof ph_promises[0];

const struct ph_promise *ph_promise_of(const char *command) {
  for (size_t i = 0; i < ph_promises_n; i++) {
    if (strcmp(ph_promises[i].command, command) == 0) {
      return &ph_promises[i];
    }
  }
  return NULL;
}

/* Whether a curve has what it consists of. */
static bool has_parts(const struct ph_promise *promise,
                      const struct ph_curve *curve) {
  const void *const parts[] = {[PH_SEGMENTS_PARTS] = curve->control_points,
                               [PH_STRIPS_PARTS] = curve->surface.strips,
                               [PH_PATCHES_PARTS] = curve->surface.patches};
  return curve->n > 0 && parts[promise->parts];
}

const char *ph_promise_breach(const struct ph_promise *promise,
                              const struct ph_curve *curve,
                              const char **member) {
  if (!promise->parts && !has_parts(promise, curve)) {
    *member = "segments";
    return "are missing";
  }
  if (!(promise->kinds >> curve->kind & 1)) {
    *member = "curve";
    return "is of no kind that the command makes";
  }
  if (!has_parts(promise, curve)) {
    *member = ph_parts_name(promise->parts);
    return "are missing";
  }
  if (curve->dimension != promise->dimension) {
    *member = "dimension";
    return "is not that of curves of the command";
  }
  *member = "degree";
  return promise->parts || curve->degree == promise->degree
             ? NULL
             : "is not that of curves of the command";
}
