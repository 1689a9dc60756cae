/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Verification: everything that a result says, recomputed from its control
 * points alone, by whomever it was written.
 *
 * This room stands by itself.  Of the others it includes base, kernel, and the
 * plain structs of curve/result.h and curve/problem.h; neither solvers nor the
 * closed forms of curve/: it evaluates control points by de Casteljau's
 * algorithm, in the B-basis of ATPH curves and by great circles, and integrates
 * by quadrature.  tests/lint/layers.sh sees to that.
 *
 * With solve/ and curve/ it shares kernel: algebra, Bernstein forms, s2.h,
 * degree.h, Gauss nodes, pow2.h, boxtree.h, golden.h; certificates also the
 * layout of band matrices, and the halves of forms.  One derivation stands in
 * both, in code of its own: the bound of the distance of cubics (tc_distance.h,
 * solve/tc/approx.h), which verify does not use: distance.c looks for far
 * points.
 *
 * Certificates and verification share promise.h and scale.h; of curves whose
 * hodographs are squares, but for tc, segments (segment.h), what is given at
 * the data (data.h, problem.c), joints, squares and lengths, certificates with
 * the tolerances of their promise and by fixed rules alone; and the evaluation
 * of curves on a sphere (spherical.h).
 *
 * Errors are relative: of points and lengths to the size of the curve (half the
 * diagonal of the bounding box of its control points), of vectors and numbers
 * to what is claimed; and less what rounding of the control points to doubles
 * can make of them.
 */
#ifndef PH_CHECK_VERIFY_H
#define PH_CHECK_VERIFY_H

#include "base/diag.h"
#include "base/mem.h"
#include "curve/problem.h"
#include "curve/result.h"
#include "check/promise.h"

/* What is checked: X(SYMBOL, "name in records"). */
#define PH_CHECKS(X)                       \
  X(SHAPE, "shape")                        \
  X(PYTHAGOREAN, "pythagorean_error")      \
  X(PREIMAGE, "preimage_error")            \
  X(SPHERE, "sphere_error")                \
  X(TENSION, "tension_error")              \
  X(CONTINUITY, "continuity_error")        \
  X(LENGTH, "length_error")                \
  X(INTERPOLATION, "interpolation_error")  \
  X(TANGENT, "tangent_error")              \
  X(END, "end_derivative_error")           \
  X(PRESCRIBED, "prescribed_length_error") \
  X(DIAGNOSTIC, "diagnostic_error")        \
  X(OFFSET, "offset_error")                \
  X(SAMPLE, "sample_error")                \
  X(BLASCHKE, "blaschke_error")            \
  X(NURBS, "nurbs_error")                  \
  X(DISTANCE, "distance_error")            \
  X(FRAME, "frame_error")                  \
  X(NORMAL, "normal_error")                \
  X(ISOMETRY, "isometry_error")            \
  X(PANORAMA, "panorama_error")

enum ph_check_id {
#define X(symbol, name) PH_CHECK_##symbol,
  PH_CHECKS(X)
#undef X
      PH_CHECK_N
};

/* The worst error of one check. */
struct ph_check_finding {
  bool done;            /* whether there was anything to check */
  double error;         /* not NaN: what is not finite is infinite */
  struct ph_diag where; /* field: as in "segments[2].length"; message: what was
                           found and what was expected */
};

struct ph_verdict {
  struct ph_check_finding check[PH_CHECK_N];
  enum ph_check_id worst;       /* PH_CHECK_N: nothing was checked */
  const char *const *unchecked; /* members that need more than the record, up to
                                   NULL; or NULL */
};

/* ph_check_name: the name of a check, as in records. */
const char *ph_check_name(enum ph_check_id check);

/*
 * ph_check_result: checks a result.
 *
 * in   claim    as it was read (io/json_result.h): arrays have the lengths that
 *               its struct says, numbers need not be finite
 * in   problem  NULL, or the problem that it is said to solve
 * in   promise  of the command that the result is of
 * ret  PH_OK (also where errors are large) | PH_E_NO_MEMORY
 */
enum ph_status
ph_check_result(const struct ph_result *claim, const struct ph_problem *problem,
                const struct ph_promise *promise, struct ph_arena *scratch,
                struct ph_verdict *verdict, struct ph_diag *diag);

#endif
