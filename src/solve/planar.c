/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The method `planar`: from the fields of a problem to a C2 PH quintic spline.
 *
 * Checks the data, brings them to unit scale by a power of two, chooses knots
 * and end derivatives, has the C2 equations solved (planar_c2.h), and maps the
 * preimage back.  Fewer points than a spline needs, equal neighbours, and
 * vanishing end derivatives are refused, each with its own code.
 *
 * [GON18] gives the equations for equal or free angles alpha; the knots here
 * are any, chordal by default.
 */
#include "solve/planar.h"

#include "base/sum.h"
#include "curve/ph2.h"
#include "kernel/pow2.h"
#include "solve/planar_c2.h"

#include <math.h>
#include <string.h>

/* Neighbours closer than this, relative to the largest coordinate, have no
 * direction left that rounding of the coordinates does not decide. */
static const double COINCIDENT = 1e-14;

/* A default end derivative that is smaller than this part of the end chord's
 * slope is rounding: the parabola through the three points stands still. */
static const double STANDSTILL = 1e-10;

/* Directions within this of exactly opposite count as a reversal. */
static const double REVERSAL = 1e-12;

/* The problem at unit scale. */
struct data {
  const double *points; /* [points_n][2], the user's */
  size_t n;             /* segments */
  bool closed;
  int exponent;  /* unit scale = data times 2^exponent; even */
  double *h;     /* [n] knot spacings, mean 1 */
  double h_mean; /* in the user's parameter */
  double *knots; /* [n + 1], the user's parameter */
  double *chord; /* [n] |c| at unit scale */
  struct ph_planar_c2 c2;
};

static ph_cplx point_at(const struct data *d, size_t k) {
  size_t i = d->closed && k == d->n ? 0 : k;
  return ph_cplx_of(d->points[2 * i], d->points[2 * i + 1]);
}

static double largest_coordinate(const double *v, size_t n) {
  double largest = 0;
  for (size_t i = 0; i < n; i++) {
    double x = fabs(v[i]);
    largest = x > largest ? x : largest;
  }
  return largest;
}

static enum ph_status count_segments(const struct ph_problem *problem,
                                     struct data *d, struct ph_diag *diag) {
  const struct ph_value *points = &problem->field[PH_F_POINTS];
  size_t n = points->n;
  d->points = points->v;
  d->closed = problem->field[PH_F_CLOSED].flag;
  if (d->closed && n > 1) {
    const double *last = points->v + 2 * (n - 1);
    double size = largest_coordinate(points->v, 2 * n);
    if (hypot(last[0] - points->v[0], last[1] - points->v[1]) <=
        COINCIDENT * size) {
      n--; /* a repeated last point closes the curve */
    }
  }
  if (n < (d->closed ? 3u : 2u)) {
    return ph_fail(diag, PH_TOO_FEW_POINTS, "points",
                   d->closed ? "must be at least 3 different points for a "
                               "closed curve, found %zu"
                             : "must be at least 2, found %zu",
                   n);
  }
  d->n = d->closed ? n : n - 1;
  return PH_OK;
}

static enum ph_status allocate(struct data *d, struct ph_arena *scratch,
                               struct ph_arena *out, struct ph_diag *diag) {
  struct ph_planar_c2 *c2 = &d->c2;
  c2->n = d->n;
  c2->closed = d->closed;
  d->h = ph_arena_array(scratch, d->n, sizeof *d->h);
  d->chord = ph_arena_array(scratch, d->n, sizeof *d->chord);
  d->knots = ph_arena_array(out, d->n + 1, sizeof *d->knots);
  c2->direction = ph_arena_array(scratch, d->n, sizeof *c2->direction);
  c2->ratio = ph_arena_array(scratch, d->n, sizeof *c2->ratio);
  c2->y = ph_arena_array(scratch, d->n + 1, sizeof *c2->y);
  return d->h && d->chord && d->knots && c2->direction && c2->ratio && c2->y
             ? PH_OK
             : ph_fail_memory(diag);
}

/* Chords at unit scale: |c| and c/|c|. */
static enum ph_status set_chords(struct data *d, struct ph_diag *diag) {
  size_t points_n = d->closed ? d->n : d->n + 1;
  double size = largest_coordinate(d->points, 2 * points_n);
  struct ph_pow2 scale;
  ph_cplx from, to;
  /* Two more: neither sums nor squares of coordinates reach 1. */
  d->exponent = size > 0 ? -ph_pow2_exponent(size) - 2 : 0;
  d->exponent -= d->exponent & 1;
  scale = ph_pow2_of(d->exponent);
  size = ph_pow2_apply(scale, size);
  from = point_at(d, 0);
  from =
      ph_cplx_of(ph_pow2_apply(scale, from.re), ph_pow2_apply(scale, from.im));
  for (size_t k = 0; k < d->n; k++) {
    ph_cplx c;
    to = point_at(d, k + 1);
    to = ph_cplx_of(ph_pow2_apply(scale, to.re), ph_pow2_apply(scale, to.im));
    c = ph_cplx_sub(to, from);
    d->chord[k] = ph_cplx_abs(c);
    if (!(d->chord[k] > COINCIDENT * size)) {
      bool wraps = d->closed && k + 1 == d->n;
      return ph_fail_at(diag, PH_COINCIDENT_POINTS, "points", wraps ? 0 : k + 1,
                        "coincides with points[%zu]", k);
    }
    d->c2.direction[k] = ph_cplx_scale(1 / d->chord[k], c);
    from = to;
  }
  return PH_OK;
}

/* Knots given as numbers. */
static enum ph_status set_given_knots(struct data *d,
                                      const struct ph_value *given,
                                      struct ph_diag *diag) {
  if (given->n != d->n + 1) {
    return ph_fail(diag, PH_BAD_SHAPE, "knots",
                   d->closed ? "must have %zu numbers, one for each point and "
                               "one that closes the period, found %zu"
                             : "must have %zu numbers, one for each point, "
                               "found %zu",
                   d->n + 1, given->n);
  }
  for (size_t k = 0; k < d->n; k++) {
    if (!(given->v[k + 1] > given->v[k])) {
      return ph_fail_at(diag, PH_BAD_VALUE, "knots", k + 1,
                        "must be greater than the knot before, %.17g, found "
                        "%.17g",
                        given->v[k], given->v[k + 1]);
    }
    d->h[k] = given->v[k + 1] - given->v[k];
    if (!isfinite(d->h[k])) {
      return ph_fail_at(diag, PH_TOO_LARGE, "knots", k + 1,
                        "differs from the knot before by more than a double "
                        "can hold");
    }
  }
  memcpy(d->knots, given->v, (d->n + 1) * sizeof *d->knots);
  return PH_OK;
}

/* Knots by rule: spacing |c|, sqrt |c| or 1, in the user's units, from 0. */
static void set_knots_by_rule(struct data *d, const char *rule) {
  struct ph_pow2 back = ph_pow2_of(-d->exponent);
  bool uniform = strcmp(rule, "uniform") == 0;
  bool centripetal = strcmp(rule, "centripetal") == 0;
  struct ph_sum knot = {0, 0};
  d->knots[0] = 0;
  for (size_t k = 0; k < d->n; k++) {
    double chord = ph_pow2_apply(back, d->chord[k]);
    d->h[k] = uniform ? 1 : centripetal ? sqrt(chord) : chord;
    ph_sum_add(&knot, d->h[k]);
    d->knots[k + 1] = ph_sum_value(&knot);
  }
}

/* Divides the spacings by their mean; ratios and weights (1) follow. */
static enum ph_status set_spacing(struct data *d, struct ph_diag *diag) {
  struct ph_planar_c2 *c2 = &d->c2;
  size_t n = d->n;
  double before;
  d->h_mean = (d->knots[n] - d->knots[0]) / (double)n;
  if (!(d->h_mean > 0) || !isfinite(d->h_mean)) {
    return ph_fail(diag, PH_TOO_LARGE, "knots",
                   "span more than a double can hold");
  }
  before = d->h[n - 1] / d->h_mean;
  for (size_t k = 0; k < n; k++) {
    double h = d->h[k] / d->h_mean;
    c2->y[k] = h / (before + h);
    c2->ratio[k] = h / d->chord[k];
    d->h[k] = before = h;
  }
  c2->y[n] = d->closed ? c2->y[0] : 0.5;
  c2->y[0] = c2->y[n];
  return PH_OK;
}

/*
 * The derivative at the start of segment `near` of the parabola through three
 * points on their knots, `far` being the next segment inwards:
 * s1 + (s1 - s2) h1 / (h1 + h2), s = c/h                  [GON18, Table 2.2].
 */
static ph_cplx parabola_end(const struct data *d, size_t near, size_t far) {
  const struct ph_planar_c2 *c2 = &d->c2;
  ph_cplx s1 = ph_cplx_scale(1 / c2->ratio[near], c2->direction[near]);
  ph_cplx s2 = ph_cplx_scale(1 / c2->ratio[far], c2->direction[far]);
  double part = d->h[near] / (d->h[near] + d->h[far]);
  ph_cplx v = ph_cplx_add(s1, ph_cplx_scale(part, ph_cplx_sub(s1, s2)));
  return ph_cplx_abs(v) > STANDSTILL * ph_cplx_abs(s1) ? v : s1;
}

static enum ph_status set_ends(struct data *d, const struct ph_value *given,
                               struct ph_diag *diag) {
  struct ph_planar_c2 *c2 = &d->c2;
  struct ph_pow2 scale = ph_pow2_of(d->exponent);
  if (given->kind == PH_ABSENT) {
    c2->end[0] = parabola_end(d, 0, d->n > 1 ? 1 : 0);
    c2->end[1] = parabola_end(d, d->n - 1, d->n > 1 ? d->n - 2 : 0);
  } else if (given->n != 2) {
    return ph_fail(diag, PH_BAD_SHAPE, "end_derivatives",
                   "must be two vectors, found %zu", given->n);
  } else {
    for (int side = 0; side < 2; side++) {
      const double *v = given->v + 2 * side;
      c2->end[side].re = ph_pow2_apply(scale, v[0]) * d->h_mean;
      c2->end[side].im = ph_pow2_apply(scale, v[1]) * d->h_mean;
    }
  }
  for (int side = 0; side < 2; side++) {
    double size = hypot(c2->end[side].re, c2->end[side].im);
    if (!(size > 0)) {
      return ph_fail_at(diag, PH_ZERO_TANGENT, "end_derivatives", (size_t)side,
                        "must not be zero");
    }
    if (!isfinite(size)) {
      return ph_fail_at(diag, PH_TOO_LARGE, "end_derivatives", (size_t)side,
                        "is too large for these points");
    }
    c2->end_size[side] = size;
    c2->end[side] =
        ph_cplx_of(c2->end[side].re / size, c2->end[side].im / size);
  }
  return PH_OK;
}

static enum ph_status prepare(const struct ph_problem *problem, struct data *d,
                              struct ph_arena *out, struct ph_arena *scratch,
                              struct ph_diag *diag) {
  const struct ph_value *knots = &problem->field[PH_F_KNOTS];
  const struct ph_value *ends = &problem->field[PH_F_END_DERIVATIVES];
  enum ph_status status = count_segments(problem, d, diag);
  if (status == PH_OK && d->closed && ends->kind != PH_ABSENT) {
    status = ph_fail(diag, PH_BAD_VALUE, "end_derivatives",
                     "is for open curves: a closed curve has no ends");
  }
  if (status == PH_OK) {
    status = allocate(d, scratch, out, diag);
  }
  if (status == PH_OK) {
    status = set_chords(d, diag);
  }
  if (status == PH_OK && knots->kind == PH_NUMBERS) {
    status = set_given_knots(d, knots, diag);
  } else if (status == PH_OK) {
    set_knots_by_rule(d, knots->kind == PH_WORD ? knots->word : "chordal");
  }
  if (status == PH_OK) {
    status = set_spacing(d, diag);
  }
  if (status == PH_OK && !d->closed) {
    status = set_ends(d, ends, diag);
  }
  return status;
}

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

static void loops_add(struct loops *loops, size_t k, const ph_cplx w[3]) {
  const double half_turn = 3.141592653589793;
  double angle = is_tame(w) ? 0 : ph_ph2_rotation(w);
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

/* Maps the unknowns to the curve in the user's units. */
static enum ph_status fill_curve(const struct data *d, const ph_cplx *b,
                                 struct ph_arena *out, struct ph_result *result,
                                 struct ph_diag *diag) {
  struct ph_curve *curve = &result->curve;
  double root = ldexp(1, -d->exponent / 2);
  size_t n = d->n;
  struct ph_sum length = {0, 0};
  struct loops loops = {0, 0, 0};
  *curve = (struct ph_curve){.kind = PH_CURVE_PH,
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
  if (!curve->control_points || !curve->preimage || !curve->lengths) {
    return ph_fail_memory(diag);
  }
  for (size_t k = 0; k < n; k++) {
    double size = root * sqrt(d->h[k]);
    ph_cplx w[3];
    ph_planar_preimage(&d->c2, b, k, w);
    loops_add(&loops, k, w);
    for (int i = 0; i < 3; i++) {
      w[i] = ph_cplx_scale(size, w[i]);
    }
    ph_ph2_control_points(w, point_at(d, k), point_at(d, k + 1),
                          (ph_cplx *)(curve->control_points + 12 * k));
    memcpy(curve->preimage + 6 * k, w, sizeof w);
    curve->lengths[k] = ph_ph2_length(w);
    ph_sum_add(&length, curve->lengths[k]);
  }
  curve->length = ph_sum_value(&length);
  warn_loops(&loops, result);
  return PH_OK;
}

static void warn_reversals(const struct data *d, struct ph_result *result) {
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
  struct data d = {0};
  ph_cplx *b = NULL;
  enum ph_status status = prepare(problem, &d, out, scratch, diag);
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
    {PH_F_BASIS, PH_WORD, 0, false, "ph", "ph",
     "kind of the segments, polynomial PH quintics"},
    {PH_F_KNOTS, PH_WORD | PH_NUMBERS, 0, false, "chordal|centripetal|uniform",
     "chordal", "spacing of the knots, or the knots themselves, increasing"},
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
