/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Data of planar splines (see planar.h): points to chords, knots and
 * angles by their rules, end derivatives.  Fewer points than a spline needs,
 * equal neighbours, and vanishing end derivatives are refused, each with its
 * own code.
 */
#include "solve/planar/planar.h"

#include "base/sum.h"
#include "kernel/pi.h"
#include "kernel/pow2.h"
#include "solve/common/fields.h"

#include <math.h>
#include <string.h>

/* Neighbours closer than this, relative to the largest coordinate, have no
 * direction left that rounding of the coordinates does not decide. */
static const double COINCIDENT = 1e-14;

/* A default end derivative that is smaller than this part of the end chord's
 * slope is rounding: the parabola through the three points stands still. */
static const double STANDSTILL = 1e-10;

static enum ph_status allocate(struct ph_planar_data *d, struct ph_arena *arena,
                               struct ph_arena *roots,
                               struct ph_arena *equations,
                               struct ph_diag *diag) {
  struct ph_planar_c2 *c2 = &d->c2;
  c2->n = d->n;
  c2->closed = d->closed;
  d->h = ph_arena_array(roots, d->n, sizeof *d->h);
  d->chord = ph_arena_array(equations, d->n, sizeof *d->chord);
  d->knots = ph_arena_array(roots, d->n + 1, sizeof *d->knots);
  c2->direction = ph_arena_array(equations, d->n, sizeof *c2->direction);
  c2->ratio = ph_arena_array(equations, d->n, sizeof *c2->ratio);
  c2->y = ph_arena_array(roots, d->n + 1, sizeof *c2->y);
  d->space = ph_arena_array(arena, d->atph ? d->n : 1, sizeof *d->space);
  if (!d->h || !d->chord || !d->knots || !c2->direction || !c2->ratio ||
      !c2->y || !d->space) {
    return ph_fail_memory(diag);
  }
  d->space[0] = ph_atph_of(0);
  c2->space = d->space;
  c2->space_stride = d->atph ? 1 : 0;
  return PH_OK;
}

/* Chords at unit scale: |c| and c/|c|. */
static enum ph_status set_chords(struct ph_planar_data *d,
                                 struct ph_diag *diag) {
  size_t points_n = d->closed ? d->n : d->n + 1;
  double size = ph_fields_largest(d->points, 2 * points_n);
  struct ph_pow2 scale;
  ph_cplx from, to;
  d->exponent = ph_fields_exponent(size);
  scale = ph_pow2_of(d->exponent);
  size = ph_pow2_apply(scale, size);
  from = ph_planar_point(d, 0);
  from =
      ph_cplx_of(ph_pow2_apply(scale, from.re), ph_pow2_apply(scale, from.im));
  for (size_t k = 0; k < d->n; k++) {
    ph_cplx c;
    to = ph_planar_point(d, k + 1);
    to = ph_cplx_of(ph_pow2_apply(scale, to.re), ph_pow2_apply(scale, to.im));
    c = ph_cplx_sub(to, from);
    d->chord[k] = ph_cplx_abs(c);
    if (!(d->chord[k] > COINCIDENT * size)) {
      bool wraps = d->closed && k + 1 == d->n;
      return ph_fields_coincide(diag, "points", k, wraps ? 0 : k + 1);
    }
    d->c2.direction[k] = ph_cplx_scale(1 / d->chord[k], c);
    from = to;
  }
  return PH_OK;
}

/* Spacings by rule: |c|, sqrt |c| or 1, in the user's unit. */
static void set_knots_by_rule(struct ph_planar_data *d, const char *rule) {
  struct ph_pow2 back = ph_pow2_of(-d->exponent);
  bool uniform = strcmp(rule, "uniform") == 0;
  bool centripetal = strcmp(rule, "centripetal") == 0;
  for (size_t k = 0; k < d->n; k++) {
    double chord = ph_pow2_apply(back, d->chord[k]);
    d->h[k] = uniform ? 1 : centripetal ? sqrt(chord) : chord;
  }
  ph_fields_sums(d->h, d->n, d->knots);
}

void ph_planar_data_chordal(const struct ph_planar_data *d, double power,
                            double largest, double *spacing) {
  double longest = ph_fields_largest(d->chord, d->n);
  for (size_t k = 0; k < d->n; k++) {
    spacing[k] = largest * pow(d->chord[k] / longest, power);
  }
}

/* The angles, which are the knot spacings as well unless knots are given
 * [GON18, sec. 2.2]. */
static enum ph_status set_angles(struct ph_planar_data *d,
                                 const struct ph_value *given,
                                 struct ph_diag *diag) {
  enum ph_status status;
  if (given->kind == PH_ABSENT || given->kind == PH_WORD) {
    bool chosen = given->kind == PH_WORD && !ph_value_is(given, "chordal");
    struct ph_value largest = {.kind = PH_NUMBER, .number = PH_PI / 2};
    largest.number = chosen ? given->number : largest.number;
    status = ph_fields_angles(&largest, d->n, d->h, diag);
    ph_planar_data_chordal(d, 1, largest.number, d->h);
  } else {
    status = ph_fields_angles(given, d->n, d->h, diag);
  }
  for (size_t k = 0; status == PH_OK && k < d->n; k++) {
    d->space[k] = ph_atph_of(d->h[k]);
  }
  ph_fields_sums(d->h, d->n, d->knots);
  return status;
}

/* Divides the spacings by their mean; ratios and weights (1) follow. */
static enum ph_status set_spacing(struct ph_planar_data *d,
                                  struct ph_diag *diag) {
  struct ph_planar_c2 *c2 = &d->c2;
  size_t n = d->n;
  double before, slope_before;
  d->h_mean = (d->knots[n] - d->knots[0]) / (double)n;
  if (!(d->h_mean > 0) || !isfinite(d->h_mean)) {
    return ph_fail(diag, PH_E_TOO_LARGE, "knots",
                   "span more than a double can hold");
  }
  before = d->h[n - 1] / d->h_mean;
  slope_before = ph_planar_space(c2, n - 1)->slope;
  for (size_t k = 0; k < n; k++) {
    double h = d->h[k] / d->h_mean, slope = ph_planar_space(c2, k)->slope;
    c2->y[k] = slope_before * h / (slope_before * h + slope * before);
    c2->ratio[k] = h / d->chord[k];
    d->h[k] = before = h;
    slope_before = slope;
  }
  c2->y[n] = d->closed ? c2->y[0] : 0.5;
  c2->y[0] = c2->y[n];
  return PH_OK;
}

/*
 * The derivative at an end of the parabola through three points on their knots:
 * s1 + (s1 - s2) h1 / (h1 + h2), s = c/h                  [GON18, Table 2.2].
 *
 * out  s     of the segment at the end, and of the next one
 * out  part  h1 / (h1 + h2); 0 where that stands still, and it is s1
 */
static ph_cplx parabola_end(const struct ph_planar_data *d, int side,
                            ph_cplx s[2], double *part) {
  const struct ph_planar_c2 *c2 = &d->c2;
  size_t near = side ? d->n - 1 : 0;
  size_t far = d->n == 1 ? near : side ? near - 1 : 1;
  ph_cplx v;
  s[0] = ph_cplx_scale(1 / c2->ratio[near], c2->direction[near]);
  s[1] = ph_cplx_scale(1 / c2->ratio[far], c2->direction[far]);
  *part = d->h[near] / (d->h[near] + d->h[far]);
  v = ph_cplx_add(s[0], ph_cplx_scale(*part, ph_cplx_sub(s[0], s[1])));
  if (!(ph_cplx_abs(v) > STANDSTILL * ph_cplx_abs(s[0]))) {
    *part = 0;
    return s[0];
  }
  return v;
}

void ph_planar_ends_change(const struct ph_planar_data *d, int side,
                           ph_cplx change[2]) {
  ph_cplx s[2], turn;
  double part;
  parabola_end(d, side, s, &part);
  turn = ph_cplx_scale(part * (1 - part), ph_cplx_sub(s[0], s[1]));
  change[0] = ph_cplx_sub(turn, ph_cplx_scale(1 + part, s[0]));
  change[1] = ph_cplx_sub(ph_cplx_scale(part, s[1]), turn);
}

static enum ph_status set_ends(struct ph_planar_data *d, struct ph_diag *diag) {
  struct ph_planar_c2 *c2 = &d->c2;
  struct ph_pow2 scale = ph_pow2_of(d->exponent);
  if (!d->ends) {
    for (int side = 0; side < 2; side++) {
      ph_cplx s[2];
      double part;
      c2->end[side] = parabola_end(d, side, s, &part);
    }
  } else {
    for (int side = 0; side < 2; side++) {
      const double *v = d->ends + 2 * side;
      c2->end[side].re = ph_pow2_apply(scale, v[0]) * d->h_mean;
      c2->end[side].im = ph_pow2_apply(scale, v[1]) * d->h_mean;
    }
  }
  for (int side = 0; side < 2; side++) {
    double size = hypot(c2->end[side].re, c2->end[side].im);
    if (!(size > 0)) {
      return ph_fail_at(diag, PH_E_ZERO_TANGENT, "end_derivatives",
                        (size_t)side, "must not be zero");
    }
    if (!isfinite(size)) {
      return ph_fail_at(diag, PH_E_TOO_LARGE, "end_derivatives", (size_t)side,
                        "is too large for these points");
    }
    c2->end_size[side] = size;
    c2->end[side] =
        ph_cplx_of(c2->end[side].re / size, c2->end[side].im / size);
  }
  return PH_OK;
}

/* Fields that contradict each other. */
static enum ph_status check_together(const struct ph_problem *problem,
                                     const struct ph_planar_data *d,
                                     struct ph_diag *diag) {
  if (d->closed && ph_fields_given(problem, PH_F_END_DERIVATIVES)) {
    return ph_fail(diag, PH_E_BAD_VALUE, "end_derivatives",
                   "is for open curves: a closed curve has no ends");
  }
  if (!d->atph && ph_fields_given(problem, PH_F_ALPHA)) {
    return ph_fail(diag, PH_E_BAD_VALUE, "alpha", "is for \"basis\":\"atph\"");
  }
  if (ph_fields_given(problem, PH_F_FREE) &&
      !ph_fields_given(problem, PH_F_MINIMIZE)) {
    return ph_fail(diag, PH_E_BAD_VALUE, "free", "is for \"minimize\"");
  }
  return PH_OK;
}

/* The end derivatives are checked last: all else about the data comes first. */
static enum ph_status read_ends(const struct ph_problem *problem,
                                struct ph_planar_data *d,
                                struct ph_diag *diag) {
  const struct ph_value *given = &problem->field[PH_F_END_DERIVATIVES];
  if (given->kind != PH_ABSENT && given->n != 2) {
    return ph_fail(diag, PH_E_BAD_SHAPE, "end_derivatives",
                   "must be two vectors, found %zu", given->n);
  }
  d->ends = given->kind == PH_ABSENT ? NULL : given->v;
  return set_ends(d, diag);
}

static enum ph_status set_knots(const struct ph_problem *problem,
                                struct ph_planar_data *d,
                                struct ph_diag *diag) {
  const struct ph_value *knots = &problem->field[PH_F_KNOTS];
  enum ph_status status = PH_OK;
  d->own_knots = knots->kind != PH_ABSENT;
  if (d->atph) {
    status = set_angles(d, &problem->field[PH_F_ALPHA], diag);
  }
  if (status == PH_OK && knots->kind == PH_NUMBERS) {
    status = ph_fields_knots(knots, d->n, d->closed, d->h, diag);
    if (status == PH_OK) {
      memcpy(d->knots, knots->v, (d->n + 1) * sizeof *d->knots);
    }
    return status;
  }
  if (status == PH_OK && (knots->kind == PH_WORD || !d->atph)) {
    set_knots_by_rule(d, knots->kind == PH_WORD ? knots->word : "chordal");
  }
  return status;
}

enum ph_status ph_planar_data_of(const struct ph_problem *problem,
                                 struct ph_arena *arena, struct ph_arena *roots,
                                 struct ph_arena *equations,
                                 struct ph_planar_data *d,
                                 struct ph_diag *diag) {
  const struct ph_value *basis = &problem->field[PH_F_BASIS];
  enum ph_status status;
  memset(d, 0, sizeof *d);
  d->atph = ph_value_is(basis, "atph");
  d->points = problem->field[PH_F_POINTS].v;
  d->closed = problem->field[PH_F_CLOSED].flag;
  status = ph_fields_segments(problem, &d->n, diag);
  status = status == PH_OK ? check_together(problem, d, diag) : status;
  status =
      status == PH_OK ? allocate(d, arena, roots, equations, diag) : status;
  status = status == PH_OK ? set_chords(d, diag) : status;
  status = status == PH_OK ? set_knots(problem, d, diag) : status;
  status = status == PH_OK ? set_spacing(d, diag) : status;
  return status == PH_OK && !d->closed ? read_ends(problem, d, diag) : status;
}

/* Knots in new proportions between the first and the last that there were. */
static void respace_knots(struct ph_planar_data *d, const double *spacing) {
  double first = d->knots[0], last = d->knots[d->n];
  double sum = ph_fields_sum(spacing, d->n);
  struct ph_sum part = {0, 0};
  for (size_t k = 0; k + 1 < d->n; k++) {
    ph_sum_add(&part, spacing[k]);
    d->knots[k + 1] = first + (last - first) * (ph_sum_value(&part) / sum);
  }
}

enum ph_status ph_planar_data_space(struct ph_planar_data *d,
                                    const double *spacing,
                                    struct ph_diag *diag) {
  enum ph_status status;
  for (size_t k = 0; k < d->n; k++) {
    if (d->atph) {
      d->space[k] = ph_atph_of(spacing[k]);
    }
    d->h[k] = spacing[k];
  }
  if (d->atph && !d->own_knots) {
    ph_fields_sums(d->h, d->n, d->knots);
  } else {
    if (!d->atph) {
      respace_knots(d, spacing);
    }
    for (size_t k = 0; k < d->n; k++) {
      d->h[k] = d->knots[k + 1] - d->knots[k];
    }
  }
  status = set_spacing(d, diag);
  return status == PH_OK && !d->closed ? set_ends(d, diag) : status;
}
