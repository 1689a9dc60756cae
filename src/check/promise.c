/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The table of promises (see promise.h). */
#include "check/certify.h"
#include "check/error.h"

#include <string.h>

/* curves that are found, and Bezier curves in place of atph */
#define SMOOTH (PH_KIND(PH) | PH_KIND(ATPH) | PH_KIND(BEZIER))

const struct ph_promise ph_promises[] = {
    {.command = "planar",
     .certify = ph_check_planar,
     .kinds = SMOOTH,
     .dimension = 2,
     .degree = 5,
     .join = PH_JOIN_SECOND,
     .given = PH_GIVEN_KNOTS,
     .ends = true},
    {.command = "spatial-hermite",
     .certify = ph_check_spatial_hermite,
     .kinds = SMOOTH,
     .dimension = 3,
     .degree = 5,
     .join = PH_JOIN_TANGENT,
     .given = PH_GIVEN_TENSION,
     .tension = true},
    {.command = "arclength",
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

const char *ph_promise_breach(const struct ph_promise *promise,
                              const struct ph_curve *curve,
                              const char **member) {
  if (curve->n == 0 || !curve->control_points) {
    *member = "segments";
    return "are missing";
  }
  if (!(promise->kinds >> curve->kind & 1)) {
    *member = "curve";
    return "is of no kind that the command makes";
  }
  if (curve->dimension != promise->dimension) {
    *member = "dimension";
    return "is not that of curves of the command";
  }
  *member = "degree";
  return curve->degree == promise->degree
             ? NULL
             : "is not that of curves of the command";
}

enum ph_status ph_certify(const char *command, const struct ph_problem *problem,
                          const struct ph_curve *curve,
                          struct ph_arena *scratch,
                          struct ph_diagnostics *diagnostics,
                          struct ph_diag *diag) {
  const struct ph_promise *promise = ph_promise_of(command);
  const char *member = "command", *wrong = "is none that promises a curve";
  enum ph_status status;
  if (promise) {
    wrong = ph_promise_breach(promise, curve, &member);
  }
  if (wrong) {
    return ph_fail(diag, PH_INTERNAL, member, "%s", wrong);
  }
  status = ph_check_finite(curve, diag);
  if (status == PH_OK) {
    status = promise->certify(problem, curve, scratch, diagnostics, diag);
  }
  /* what was broken off has found nothing */
  return ph_arena_late(scratch) ? ph_fail_memory(diag) : status;
}
