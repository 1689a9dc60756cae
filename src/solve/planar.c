/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The method `planar`: from the fields of a problem to a C2 PH quintic or ATPH
 * spline.
 *
 * The data are checked and brought to unit scale (planar_data.h), the C2
 * equations solved (planar_c2.h), and the preimage mapped back.
 *
 * [GON18] gives the equations for knots that are sums of the angles alpha; PH
 * quintics may have any knots, chordal by default.
 */
#include "solve/planar.h"

#include "base/sum.h"
#include "curve/ph2.h"
#include "curve/seg2.h"
#include "solve/planar_data.h"

#include <math.h>
#include <string.h>

/* Directions within this of exactly opposite count as a reversal. */
static const double REVERSAL = 1e-12;

/* Segments that turn by more than half a turn. */
struct loops {
  size_t n, first;
  double angle; /* of the first */
};

/* The tangent stays within a half turn if w stays within a quarter turn. */
static bool is_tame(const ph_cplx w[3]) {
  return ph_cplx_dot(w[0], w[1]) > 0 && ph_cplx_dot(w[1], w[2]) > 0 &&
         ph_cplx_dot(w[0], w[2]) > 0;
}

static void loops_add(struct loops *loops, size_t k,
                      const struct ph_atph *space, const ph_cplx w[3]) {
  const double half_turn = 3.141592653589793;
  struct ph_seg2 seg = {*space, {w[0], w[1], w[2]}, {0, 0}, {0, 0}};
  double angle = is_tame(w) ? 0 : ph_seg2_rotation(&seg, NULL);
  if (!(fabs(angle) <= half_turn) && loops->n++ == 0) {
    loops->first = k;
    loops->angle = angle;
  }
}

static void warn_loops(const struct loops *loops, struct ph_result *result) {
  if (loops->n) {
    ph_fail(ph_warning_add(result, loops->first), PH_LOOP, NULL,
            "segment %zu turns by %.4g radians, more than half a turn (such "
            "segments: %zu)",
            loops->first, loops->angle, loops->n);
  }
}

/* A curve of n segments without its numbers. */
static enum ph_status allocate_curve(const struct ph_planar_data *d,
                                     struct ph_arena *out,
                                     struct ph_curve *curve,
                                     struct ph_diag *diag) {
  size_t n = d->n;
  *curve = (struct ph_curve){.kind = d->atph ? PH_CURVE_ATPH : PH_CURVE_PH,
                             .closed = d->closed,
                             .dimension = 2,
                             .degree = 5,
                             .n = n,
                             .knots = d->knots,
                             .preimage_n = 3,
                             .preimage_dimension = 2};
  curve->control_points = ph_arena_array(out, n, 12 * sizeof(double));
  curve->preimage = ph_arena_array(out, n, 6 * sizeof(double));
  curve->lengths = ph_arena_array(out, n, sizeof(double));
  curve->alpha = d->atph ? ph_arena_array(out, n, sizeof(double)) : NULL;
  return curve->control_points && curve->preimage && curve->lengths &&
                 (curve->alpha || !d->atph)
             ? PH_OK
             : ph_fail_memory(diag);
}

/* Maps the unknowns to the curve in the user's units.  Control points and
 * lengths come from the preimage with respect to u in [0,1]; that of an atph
 * curve is written with respect to t. */
static enum ph_status fill_curve(const struct ph_planar_data *d,
                                 const ph_cplx *b, struct ph_arena *out,
                                 struct ph_result *result,
                                 struct ph_diag *diag) {
  struct ph_curve *curve = &result->curve;
  double root = ldexp(1, -d->exponent / 2);
  struct ph_sum length = {0, 0};
  struct loops loops = {0, 0, 0};
  enum ph_status status = allocate_curve(d, out, curve, diag);
  for (size_t k = 0; status == PH_OK && k < d->n; k++) {
    const struct ph_atph *space = ph_planar_space(&d->c2, k);
    double size = root * sqrt(d->h[k]);
    ph_cplx w[3];
    ph_planar_preimage(&d->c2, b, k, w);
    loops_add(&loops, k, space, w);
    for (int i = 0; i < 3; i++) {
      w[i] = ph_cplx_scale(size, w[i]);
    }
    ph_ph2_control_points(space, w, ph_planar_point(d, k),
                          ph_planar_point(d, k + 1),
                          (ph_cplx *)(curve->control_points + 12 * k));
    curve->lengths[k] = ph_ph2_length(space, w);
    ph_sum_add(&length, curve->lengths[k]);
    for (int i = 0; d->atph && i < 3; i++) {
      w[i] = ph_cplx_scale(1 / sqrt(space->angle), w[i]);
    }
    if (d->atph) {
      curve->alpha[k] = space->angle;
    }
    memcpy(curve->preimage + 6 * k, w, sizeof w);
  }
  curve->length = ph_sum_value(&length);
  warn_loops(&loops, result);
  return status;
}

static void warn_reversals(const struct ph_planar_data *d,
                           struct ph_result *result) {
  size_t found = 0, first = 0;
  for (size_t k = d->closed ? 0 : 1; k < d->n; k++) {
    ph_cplx before = d->c2.direction[k > 0 ? k - 1 : d->n - 1];
    ph_cplx after = d->c2.direction[k];
    if (ph_cplx_dot(before, after) < 0 &&
        fabs(ph_cplx_cross(before, after)) <= REVERSAL) {
      first = found ? first : k;
      found++;
    }
  }
  if (found) {
    ph_fail(ph_warning_add(result, first), PH_REVERSAL, NULL,
            "the data turn back by 180 degrees at points[%zu] (such points: "
            "%zu): of two mirror images the left turn was taken",
            first, found);
  }
}

/* Knots unrelated to the chords are what makes data unsolvable. */
static enum ph_status advise(const struct ph_value *knots,
                             struct ph_diag *diag) {
  static const char advice[] = "; try \"knots\":\"chordal\"";
  bool chordal =
      knots->kind == PH_ABSENT ||
      (knots->kind == PH_WORD && strcmp(knots->word, "chordal") == 0);
  if (diag->status == PH_NO_CONVERGENCE && !chordal) {
    strncat(diag->message, advice,
            sizeof diag->message - 1 - strlen(diag->message));
  }
  return diag->status;
}

static enum ph_status solve(const struct ph_problem *problem,
                            struct ph_arena *out, struct ph_arena *scratch,
                            struct ph_result *result, struct ph_diag *diag) {
  struct ph_mark mark = ph_arena_mark(scratch);
  struct ph_planar_report report;
  struct ph_planar_data d;
  ph_cplx *b = NULL;
  enum ph_status status = ph_planar_data_of(problem, out, scratch, &d, diag);
  if (status == PH_OK) {
    b = ph_arena_array(scratch, ph_planar_unknowns(&d.c2), sizeof *b);
    status = b ? ph_planar_c2_solve(&d.c2, scratch, b, &report, diag)
               : ph_fail_memory(diag);
    if (status != PH_OK) {
      status = advise(&problem->field[PH_F_KNOTS], diag);
    }
  }
  if (status == PH_OK) {
    warn_reversals(&d, result);
    status = fill_curve(&d, b, out, result, diag);
  }
  if (status == PH_OK) {
    struct ph_diagnostics *diagnostics = &result->diagnostics;
    ph_diagnostics_set(diagnostics, PH_D_ITERATIONS, (double)report.iterations);
    ph_diagnostics_set(diagnostics, PH_D_RESIDUAL, report.residual);
  }
  ph_arena_release(scratch, mark);
  return status;
}

static const struct ph_field fields[] = {
    {PH_F_POINTS, PH_VECTORS, 1u << 2, true, NULL, NULL,
     "the points to interpolate, 2 or more, 3 or more if closed"},
    {PH_F_CLOSED, PH_BOOL, 0, false, NULL, "false",
     "close the curve, a repeated last point is dropped"},
    {PH_F_BASIS, PH_WORD, 0, false, "ph|atph", "ph",
     "kind of the segments, polynomial or algebraic-trigonometric"},
    {PH_F_KNOTS, PH_WORD | PH_NUMBERS, 0, false, "chordal|centripetal|uniform",
     "chordal, atph: the sums of alpha",
     "spacing of the knots, or the knots themselves, increasing"},
    {PH_F_ALPHA, PH_NUMBER | PH_NUMBERS | PH_WORD, 0, false,
     "chordal|chordal:V", "chordal, the largest pi/2",
     "angles of atph segments below pi, one for all or one each"},
    {PH_F_END_DERIVATIVES, PH_VECTORS, 1u << 2, false, NULL,
     "those of a parabola through three points",
     "the two end derivatives of an open curve, per unit of the knots"},
};

const struct ph_method ph_method_planar = {
    .schema = {"planar", fields, sizeof fields / sizeof fields[0]},
    .title = "C2 PH quintic splines through points in the plane",
    .dimension = 2,
    .solve = solve,
};
