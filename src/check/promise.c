/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The table of promises (see promise.h). */
#include "check/promise.h"

#include <string.h>

/* curves that are found, and Bezier curves in place of atph */
#define SMOOTH (PH_KIND(PH) | PH_KIND(ATPH) | PH_KIND(BEZIER))

const struct ph_promise ph_promises[] = {
    {.command = "planar",
     .kinds = SMOOTH,
     .dimension = 2,
     .degree = 5,
     .join = PH_JOIN_SECOND,
     .given = PH_GIVEN_KNOTS,
     .ends = true},
    {.command = "spatial-hermite",
     .kinds = SMOOTH,
     .dimension = 3,
     .degree = 5,
     .join = PH_JOIN_TANGENT,
     .given = PH_GIVEN_TENSION,
     .tension = true},
    {.command = "arclength",
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
     .kinds = PH_KIND(SPHERICAL_NU),
     .dimension = 3,
     .degree = 3,
     .join = PH_JOIN_FIRST},
    {.command = "tc",
     .kinds = PH_KIND(TC),
     .dimension = 2,
     .degree = 3,
     .join = PH_JOIN_TANGENT,
     .given = PH_GIVEN_CUBIC,
     .ends = true,
     .intervals = true,
     .approximate = true}};

const size_t ph_promises_n = sizeof ph_promises / sizeof ph_promises[0];

const struct ph_promise *ph_promise_of(const char *command) {
  for (size_t i = 0; i < ph_promises_n; i++) {
    if (strcmp(ph_promises[i].command, command) == 0) {
      return &ph_promises[i];
    }
  }
  return NULL;
}
