/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Certificates (see certify.h).  What verify.c goes through from segment to
 * segment, they do, too, by fixed rules: with the tolerances of the promise,
 * and without anything that is told about the curve but the curve.
 */
#include "check/certify.h"

#include "check/checks.h"
#include "check/data.h"

/* What is told, in this order; always, or where something was given. */
static const struct {
  enum ph_check_id check;
  enum ph_diagnostic what;
  bool always;
} TOLD[] = {{PH_CHECK_INTERPOLATION, PH_D_INTERPOLATION_ERROR, true},
            {PH_CHECK_TANGENT, PH_D_TANGENT_ERROR, false},
            {PH_CHECK_END, PH_D_END_DERIVATIVE_ERROR, false},
            {PH_CHECK_PYTHAGOREAN, PH_D_PYTHAGOREAN_ERROR, true},
            {PH_CHECK_CONTINUITY, PH_D_CONTINUITY_ERROR, true},
            {PH_CHECK_LENGTH, PH_D_LENGTH_ERROR, true}};

enum { TOLD_N = sizeof TOLD / sizeof TOLD[0] };

/* The scale is that of the points that are given, a repeated last one left out,
 * or of the control points. */
static bool set_scale(struct ph_check *v) {
  const struct ph_promise *promise = v->promise;
  const struct ph_curve *c = v->curve;
  const struct ph_value *points = v->data->points;
  size_t n = ph_curve_points_n(c);
  if (promise->unit != PH_UNIT_INTERVAL && points) {
    n = c->closed ? c->n : c->n + 1;
    return ph_check_scale_of(points->v, n, points->dimension, &v->scale);
  }
  return ph_check_scale_of(c->control_points, n, c->dimension, &v->scale);
}

/* What errors are relative to. */
static void set_units(struct ph_check *v) {
  const struct ph_curve *c = v->curve;
  double n = (double)v->data->n, length = ph_check_scaled(v, c->length);
  v->interval = length / n;
  v->mean_speed = length / (c->knots[c->n] - c->knots[0]);
  if (v->promise->unit == PH_UNIT_DATA) {
    v->unit_square = v->scale.size;
    v->unit_length = length;
  } else if (v->promise->unit == PH_UNIT_INTERVAL) {
    v->unit_square = v->unit_length = v->interval;
  }
}

static enum ph_status conclude(struct ph_check *v,
                               struct ph_diagnostics *diagnostics) {
  const struct ph_check_error *list[TOLD_N];
  for (size_t i = 0; i < TOLD_N; i++) {
    struct ph_check_error *error = &v->error[TOLD[i].check];
    error->what = TOLD[i].what;
    list[i] = TOLD[i].always || error->done ? error : NULL;
  }
  return v->status == PH_OK
             ? ph_check_conclude(list, TOLD_N, diagnostics, v->diag)
             : v->status;
}

/* What is promised of all curves of segments whose hodographs are squares. */
static enum ph_status check_curve(struct ph_check *v,
                                  struct ph_diagnostics *diagnostics) {
  struct ph_check_error error[PH_CHECK_N] = {{.done = false}};
  struct ph_check_space space;
  struct ph_check_data data;
  enum ph_status status;
  v->error = error;
  v->allow = v->promise->allow;
  status = ph_check_begin(v, &data, &space);
  if (status != PH_OK || !v->data) {
    return status != PH_OK ? status : v->status;
  }
  if (!set_scale(v)) {
    return ph_fail(v->diag, PH_E_INTERNAL, "points", "have no extent");
  }
  set_units(v);
  ph_check_segments(v);
  if (ph_arena_late(v->scratch)) {
    return ph_fail_memory(v->diag);
  }
  ph_check_lengths(v);
  ph_check_given_lengths(v);
  status = conclude(v, diagnostics);
  return status == PH_OK && v->promise->certify
             ? v->promise->certify(v, diagnostics)
             : status;
}

enum ph_status ph_certify(const char *command, const struct ph_problem *problem,
                          const struct ph_curve *curve,
                          struct ph_arena *scratch,
                          struct ph_diagnostics *diagnostics,
                          struct ph_diag *diag) {
  const struct ph_promise *promise = ph_promise_of(command);
  struct ph_check v = {.scratch = scratch,
                       .diag = diag,
                       .promise = promise,
                       .problem = problem,
                       .curve = curve,
                       .diagnostics = diagnostics};
  const char *member = "command", *wrong = "is none that promises a curve";
  struct ph_mark mark = ph_arena_mark(scratch);
  enum ph_status status;
  if (promise) {
    wrong = ph_promise_breach(promise, curve, &member);
  }
  if (wrong) {
    return ph_fail(diag, PH_E_INTERNAL, member, "%s", wrong);
  }
  v.kind = &ph_check_kinds[curve->kind];
  status = promise->parts ? PH_OK : ph_check_finite(curve, diag);
  if (status == PH_OK) {
    status = promise->allow ? check_curve(&v, diagnostics)
                            : promise->certify(&v, diagnostics);
  }
  ph_arena_release(scratch, mark);
  /* what was broken off has found nothing */
  return ph_arena_late(scratch) ? ph_fail_memory(diag) : status;
}
