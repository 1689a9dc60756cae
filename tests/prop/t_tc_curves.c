/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Splines of Tschirnhausen cubics through random points: their derivatives are
 * those of the rules; and approximations of random Bezier curves: they are as
 * near as is said, by this file's own sight.
 *
 * The seed is 1, or PH_SEED; PH_LONG=1 takes ten times as many data.
 */
#include "tc_data.h"
#include "unit.h"

static struct unit_solution one, other;
static struct tc_data data;

static void finish(void) {
  unit_solution_free(&one);
  unit_solution_free(&other);
}

static double distance_of(const struct unit_solution *s) {
  return unit_diagnostic(&s->result.diagnostics, PH_D_DISTANCE);
}

/* ---- splines ---------------------------------------------------------------
 */

static ph_cplx unit_of(ph_cplx z) {
  return ph_cplx_scale(1 / ph_cplx_abs(z), z);
}

/* The derivative at a point between two intervals. */
static void ck_bisector(size_t k, double lambda) {
  size_t n = tc_intervals(&data), before = k > 0 ? k - 1 : n - 1;
  const struct ph_interval *interval = &one.result.intervals[k];
  ph_cplx a = tc_chord(&data, before), b = tc_chord(&data, k);
  double size = lambda * fmin(ph_cplx_abs(a), ph_cplx_abs(b));
  ph_cplx wanted = ph_cplx_add(unit_of(a), unit_of(b)), found, last;
  wanted = ph_cplx_scale(size, unit_of(wanted));
  found = tc_derivative(&one.result.curve, interval->first, 0);
  last = tc_derivative(&one.result.curve, one.result.intervals[before].last, 3);
  ck_that(unit_distance(found, wanted) <= 1e-12 * size &&
              unit_distance(last, wanted) <= 1e-12 * size,
          "derivative (%g, %g) at point %zu, not (%g, %g)", found.re, found.im,
          k, wanted.re, wanted.im);
}

/* The derivative at an end, by the rule of ends. */
static void ck_end_rule(size_t end, double lambda) {
  size_t n = tc_intervals(&data), k = end ? n - 1 : 0;
  const struct ph_interval *interval = &one.result.intervals[k];
  const struct ph_curve *c = &one.result.curve;
  ph_cplx at[2] = {tc_derivative(c, interval->first, 0),
                   tc_derivative(c, interval->last, 3)};
  ph_cplx chord = tc_chord(&data, k);
  double size = lambda * ph_cplx_abs(chord);
  ph_cplx wanted = ph_cplx_scale(lambda, chord);
  if (data.ends && strcmp(data.ends, "given") == 0) {
    wanted = data.end[end];
  } else if (data.ends && strcmp(data.ends, "circle") == 0 &&
             n > 1) { /* as far to one side as it comes back */
    ph_cplx inner = unit_of(ph_cplx_mul(ph_cplx_conj(chord), at[1 - end]));
    wanted = ph_cplx_mul(wanted, ph_cplx_conj(inner));
  }
  ck_that(unit_distance(at[end], wanted) <= 1e-11 * size,
          "derivative (%g, %g) at end %zu, not (%g, %g)", at[end].re,
          at[end].im, end, wanted.re, wanted.im);
}

PH_TEST(test_spline) {
  static const char *const ends[] = {NULL, "chord", "circle", "given"};
  struct unit_random r = unit_random_of(28);
  size_t closed = 0;
  for (size_t i = 0; i < unit_cases(200); i++) {
    double lambda = 0.5;
    tc_of(&r, TC_SPLINE, &data);
    closed += data.closed;
    data.ends = data.closed ? NULL : ends[unit_random_below(&r, 4)];
    if (i % 2) {
      lambda = data.lambda = unit_random_in(&r, 0.2, 1.4);
    }
    for (size_t k = 0; k < 2; k++) {
      data.end[k] = ph_cplx_scale(unit_random_in(&r, 0.3, 1),
                                  ph_cplx_polar(unit_random_in(&r, -4, 4)));
    }
    tc_must(&data, i, &one);
    for (size_t k = data.closed ? 0 : 1; k < tc_intervals(&data); k++) {
      ck_bisector(k, lambda);
    }
    for (size_t end = 0; !data.closed && end < 2; end++) {
      ck_end_rule(end, lambda);
    }
  }
  ck_assert_uint_gt(closed, unit_cases(200) / 10);
}

/* ---- approximation ------------------------------------------------------- */

/* The Bezier curve of the data at t, by de Casteljau. */
static ph_cplx bezier(double t) {
  ph_cplx p[TC_MAX];
  memcpy(p, data.point, sizeof p);
  for (size_t n = data.n - 1; n > 0; n--) {
    for (size_t i = 0; i < n; i++) {
      p[i] =
          ph_cplx_add(ph_cplx_scale(1 - t, p[i]), ph_cplx_scale(t, p[i + 1]));
    }
  }
  return p[0];
}

static ph_cplx cubic(const struct ph_curve *c, size_t k, double t) {
  double s = 1 - t, b[4] = {s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
  ph_cplx p = ph_cplx_of(0, 0);
  for (size_t i = 0; i < 4; i++) {
    p = ph_cplx_add(p, ph_cplx_scale(b[i], tc_point(c, k, i)));
  }
  return p;
}

/* A cubic, or a part of the data's curve. */
struct part {
  const struct ph_curve *cubics; /* NULL: of the data's curve */
  size_t k;
  double from, to;
};

static ph_cplx place(const struct part *part, double u) {
  return part->cubics ? cubic(part->cubics, part->k, u)
                      : bezier(part->from + u * (part->to - part->from));
}

enum { PLACES = 16, THIRDS = 60 };

/* The square of the distance of p from the straight line from a to b. */
static double off_line(ph_cplx a, ph_cplx b, ph_cplx p) {
  ph_cplx d = ph_cplx_sub(b, a), v = ph_cplx_sub(p, a);
  double u = ph_cplx_dot(d, v) / ph_cplx_norm2(d);
  u = u > 0 ? fmin(u, 1) : 0;
  return ph_cplx_norm2(ph_cplx_sub(v, ph_cplx_scale(u, d)));
}

/* The distance of a point from a part: from what is around the nearest of some
 * straight lines, by thirds. */
static double distance_to(const struct part *part, ph_cplx p) {
  double least = HUGE_VAL, low = 0, high = 1;
  ph_cplx a = place(part, 0);
  for (size_t i = 0; i < PLACES; i++) {
    ph_cplx b = place(part, (double)(i + 1) / PLACES);
    double d = off_line(a, b, p);
    if (d < least) {
      least = d;
      low = fmax((double)i - 1, 0) / PLACES;
      high = fmin((double)i + 2, PLACES) / PLACES;
    }
    a = b;
  }
  for (size_t i = 0; i < THIRDS; i++) {
    double u = low + (high - low) / 3, v = high - (high - low) / 3;
    bool left =
        unit_distance(p, place(part, u)) < unit_distance(p, place(part, v));
    low = left ? low : u;
    high = left ? v : high;
  }
  least = unit_distance(p, place(part, low));
  return fmin(least, unit_distance(p, place(part, high)));
}

/* How far cubic k and its part of the curve are from each other, or from what
 * is next to the other: pairs meet beside the curve. */
static double apart(const struct ph_curve *c, size_t k) {
  const size_t first = k > 0 ? k - 1 : k, last = k + 1 < c->n ? k + 1 : k;
  const struct part own = {NULL, k, c->knots[k], c->knots[k + 1]};
  double worst = 0;
  for (size_t i = 0; i <= PLACES; i++) {
    double u = (double)i / PLACES, here = HUGE_VAL, there = HUGE_VAL;
    for (size_t j = first; j <= last; j++) {
      const struct part arc = {c, j, 0, 1};
      const struct part part = {NULL, j, c->knots[j], c->knots[j + 1]};
      here = fmin(here, distance_to(&arc, place(&own, u)));
      there = fmin(there, distance_to(&part, cubic(c, k, u)));
    }
    worst = unit_larger(worst, unit_larger(here, there));
  }
  return worst;
}

static void ck_near(double distance) {
  const struct ph_curve *c = &one.result.curve;
  for (size_t k = 0; k < c->n; k++) {
    double d = apart(c, k);
    ck_that(d <= (1 + 1e-6) * distance + 1e-10,
            "cubic %zu of %zu is off by %.3g", k, c->n, d);
  }
}

PH_TEST(test_approximate) {
  struct unit_random r = unit_random_of(29);
  for (size_t i = 0; i < unit_cases(20); i++) {
    double distance;
    tc_of(&r, TC_APPROXIMATE, &data);
    tc_must(&data, i, &one);
    distance = distance_of(&one);
    ck_that(distance <= data.tolerance, "distance %.17g of %.17g", distance,
            data.tolerance);
    ck_near(distance);
  }
}

/* So many cubics at most; four times as many are nearer by far. */
PH_TEST(test_pieces) {
  struct unit_random r = unit_random_of(30);
  for (size_t i = 0; i < unit_cases(8); i++) {
    double distance;
    do { /* straight lines are met at once */
      tc_of(&r, TC_APPROXIMATE, &data);
    } while (data.n < 3);
    data.tolerance = (double)NAN;
    data.pieces = 6 + (double)unit_random_below(&r, 10);
    tc_must(&data, i, &one);
    distance = distance_of(&one);
    ck_that((double)one.result.curve.n <= data.pieces, "%zu of %g pieces",
            one.result.curve.n, data.pieces);
    ck_near(distance);
    data.pieces *= 4;
    tc_must(&data, i, &other);
    ck_that(distance_of(&other) <= 0.25 * distance,
            "distance %.3g, of four times as many %.3g", distance,
            distance_of(&other));
  }
}

PH_FIXTURE(NULL, finish)
