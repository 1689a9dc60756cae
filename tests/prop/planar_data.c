/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Random problems of planar splines (see planar.h). */
#include "planar_data.h"
#include "unit.h"

static const double PI = 3.14159265358979323846;

/* Sides of closed polygons are not shortened below this. */
static const double SHORTEST = 0.05;

const char *prop_name(enum prop_family family) {
  static const char *const names[] = {"smooth", "rough", "sharp", "random"};
  return names[family];
}

/* Turns of a closed polygon of n sides: they add up to a whole turn. */
static bool closed_turns(struct unit_random *r, size_t n, double largest,
                         double *turn) {
  double mean = 2 * PI / (double)n, sum = 0;
  for (size_t k = 0; k < n; k++) {
    turn[k] = unit_random_in(r, -1, 1) * (largest - mean);
    sum += turn[k] / (double)n;
  }
  for (size_t k = 0; k < n; k++) {
    turn[k] += mean - sum;
    if (!(fabs(turn[k]) <= largest)) {
      return false;
    }
  }
  return true;
}

/* Sides, changed as little as possible, so that the polygon closes. */
static bool close_sides(const double *heading, size_t n, double *side) {
  double cc = 0, cs = 0, ss = 0, x = 0, y = 0, det, a, b;
  for (size_t k = 0; k < n; k++) {
    double c = cos(heading[k]), s = sin(heading[k]);
    cc += c * c;
    cs += c * s;
    ss += s * s;
    x += side[k] * c;
    y += side[k] * s;
  }
  det = cc * ss - cs * cs;
  a = (ss * x - cs * y) / det;
  b = (cc * y - cs * x) / det;
  for (size_t k = 0; k < n; k++) {
    side[k] -= a * cos(heading[k]) + b * sin(heading[k]);
    if (!(side[k] >= SHORTEST)) {
      return false;
    }
  }
  return true;
}

/* One attempt at a polygon; false if it can not be closed. */
static bool polygon(struct unit_random *r, double largest, size_t n,
                    struct prop_data *data) {
  static double turn[PROP_POINTS_MAX], heading[PROP_POINTS_MAX];
  static double side[PROP_POINTS_MAX];
  double at = unit_random_in(r, -PI, PI);
  if (data->closed && !closed_turns(r, n, largest, turn)) {
    return false;
  }
  for (size_t k = 0; k < n; k++) {
    heading[k] = at;
    at += data->closed ? turn[k] : unit_random_in(r, -largest, largest);
    side[k] = unit_random_in(r, 0.5, 2);
  }
  if (data->closed && !close_sides(heading, n, side)) {
    return false;
  }
  data->point[0] = ph_cplx_of(0, 0);
  for (size_t k = 0; k + 1 < data->n; k++) {
    ph_cplx step = ph_cplx_scale(side[k], ph_cplx_polar(heading[k]));
    data->point[k + 1] = ph_cplx_add(data->point[k], step);
  }
  return true;
}

void prop_points(struct unit_random *r, enum prop_family family, size_t n,
                 bool closed, struct prop_data *data) {
  static const double largest[] = {1.0 / 3, 1.0 / 2, 5.0 / 6};
  data->n = closed ? n : n + 1;
  data->closed = closed;
  data->rule = NULL;
  data->has_knots = data->has_ends = false;
  ck_assert_uint_le(data->n, PROP_POINTS_MAX);
  if (family == PROP_RANDOM) {
    for (size_t k = 0; k < data->n; k++) {
      data->point[k] = unit_random_cplx(r, 0.5);
    }
    return;
  }
  for (int i = 0; i < 10000; i++) {
    if (polygon(r, largest[family] * PI, n, data)) {
      return;
    }
  }
  ck_abort_msg("seed %lu: no closed %s polygon of %zu sides found", unit_seed(),
               prop_name(family), n);
}

void prop_any(struct unit_random *r, size_t segments_max,
              struct prop_data *data) {
  static const char *const rules[] = {NULL, "chordal", "centripetal",
                                      "uniform"};
  bool closed = unit_random_below(r, 2);
  size_t least = closed ? 8 : 2; /* smooth polygons have at least 6 sides */
  size_t n = least + unit_random_below(r, segments_max - least + 1);
  size_t kind = unit_random_below(r, 5);
  prop_points(r, (enum prop_family)unit_random_below(r, PROP_FAMILY_N), n,
              closed, data);
  data->rule = kind < 4 ? rules[kind] : NULL;
  data->has_knots = kind == 4;
  data->has_ends = !closed && unit_random_below(r, 2);
  data->knots[0] = unit_random_in(r, -1, 1);
  for (size_t k = 0; k < n; k++) {
    size_t next = k + 1 < data->n ? k + 1 : 0;
    double chord = unit_distance(data->point[k], data->point[next]);
    data->knots[k + 1] = data->knots[k] + chord * unit_random_in(r, 0.7, 1.4);
  }
  for (int side = 0; side < 2; side++) {
    /* of the order of the chord over its interval, by no rule */
    size_t k = side ? data->n - 2 : 0;
    ph_cplx chord = ph_cplx_sub(data->point[k + 1], data->point[k]);
    double size = data->rule == rules[3]   ? ph_cplx_abs(chord)
                  : data->rule == rules[2] ? sqrt(ph_cplx_abs(chord))
                                           : 1;
    ph_cplx turn = ph_cplx_polar(unit_random_in(r, -1, 1));
    size *= unit_random_in(r, 0.7, 1.4) / ph_cplx_abs(chord);
    data->end[side] = ph_cplx_scale(size, ph_cplx_mul(turn, chord));
  }
}

size_t prop_segments(const struct prop_data *data) {
  return data->closed ? data->n : data->n - 1;
}

struct unit_solution prop_problem(const struct prop_data *data, size_t which) {
  static double v[2 * PROP_POINTS_MAX];
  struct unit_solution u;
  unit_case("PH_SEED=%lu, case %zu (%zu points, %s, knots %s, ends %s)",
            unit_seed(), which, data->n, data->closed ? "closed" : "open",
            data->has_knots ? "given"
            : data->rule    ? data->rule
                            : "by default",
            data->has_ends ? "given" : "by default");
  for (size_t k = 0; k < data->n; k++) {
    v[2 * k] = data->point[k].re;
    v[2 * k + 1] = data->point[k].im;
  }
  u = unit_planar_of(v, data->n, data->closed);
  if (data->rule) {
    unit_planar_rule(&u, data->rule);
  }
  if (data->has_knots) {
    unit_planar_knots(&u, data->knots, prop_segments(data) + 1);
  }
  if (data->has_ends) {
    const double ends[4] = {data->end[0].re, data->end[0].im, data->end[1].re,
                            data->end[1].im};
    unit_planar_ends(&u, ends);
  }
  return u;
}
