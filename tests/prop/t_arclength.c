/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Properties of splines with prescribed arc lengths on random data, each solved
 * and certified: what must follow when the data are moved, turned, scaled,
 * mirrored or reversed, when lengths count less or not at all, when intervals
 * have more segments; and that no data have a wrong curve.
 *
 * The seed is 1, or PH_SEED; PH_LONG=1 takes ten times as many data.
 */
#include "arclength_data.h"
#include "motion.h"
#include "unit.h"

static struct unit_solution one, other;
static struct arc_data data, image;

static void finish(void) {
  unit_solution_free(&one);
  unit_solution_free(&other);
}

/* ---- motions --------------------------------------------------------- */

/* Where data k and interval k of the image are from.  Closed curves keep their
 * first point. */
static size_t knot_from(const struct motion *m, size_t k) {
  size_t n = data.n;
  return !m->reverse ? k : data.closed ? (n - k) % n : n - k;
}

static size_t interval_from(const struct motion *m, size_t k) {
  return m->reverse ? data.n - 1 - k : k;
}

/* The image of data whose curve is `one`.  Without points the curve begins
 * where the given start is: that of a reversed one is the end. */
static void move_data(const struct motion *m) {
  size_t last = one.result.curve.n - 1;
  image = data;
  for (size_t k = 0; k <= data.n; k++) {
    size_t from = knot_from(m, k);
    double sign = m->reverse ? -1 : 1;
    image.point[k] = moved(m, data.point[from]);
    image.vector[k] = turned(m, ph_vec3_scale(sign, data.vector[from]));
    if (data.given == ARC_TANGENTS) {
      image.vector[k] = ph_vec3_scale(1 / m->scale, image.vector[k]);
    }
  }
  for (size_t k = 0; k < data.n; k++) {
    image.length[k] = m->scale * data.length[interval_from(m, k)];
  }
  if (data.given > ARC_SOFT && m->reverse) {
    image.point[0] = moved(m, arc_point(&one, last, 5));
  }
}

/* F to tol, or to rounding: it has the unit of a length. */
static bool is_near_f(double a, double b, double tol) {
  double unit = other.result.curve.length / (double)data.n;
  return unit_near_rel(a, b, tol) || unit_near(a, b, 1e-14 * unit);
}

/* `other` is `one`, moved: control points to tol times the mean length, F to
 * tol. */
static void ck_moved(const struct motion *m, double tol) {
  const struct ph_curve *a = &one.result.curve, *b = &other.result.curve;
  double unit = b->length / (double)data.n, worst = 0;
  ck_that(is_near_f(arc_f(&one) * m->scale, arc_f(&other), tol),
          "F %.17g, %.17g", arc_f(&one) * m->scale, arc_f(&other));
  ck_that(a->n == b->n, "%zu and %zu segments", a->n, b->n);
  for (size_t k = 0; k < a->n; k++) {
    size_t j = m->reverse ? a->n - 1 - k : k;
    for (size_t i = 0; i < 6; i++) {
      ph_vec3 wanted = moved(m, arc_point(&one, k, i));
      size_t at = m->reverse ? 5 - i : i;
      worst = unit_larger(worst, unit_apart(wanted, arc_point(&other, j, at)));
    }
    ck_that(fabs(a->lengths[k] * m->scale - b->lengths[j]) <= tol * unit,
            "segment %zu: lengths %.17g, %.17g", k, a->lengths[k] * m->scale,
            b->lengths[j]);
  }
  ck_that(worst <= tol * unit, "it is %.3g lengths away", worst / unit);
}

/* What the invariance is tried on: smooth and rough data with one minimum
 * nearby, so many that a preimage that does not bend (F = 0) cannot meet them
 * in several ways.  With one segment in each interval exact lengths are ill
 * paired: only of few intervals. */
static void invariant(struct unit_random *r) {
  static const enum arc_family families[] = {ARC_SMOOTH, ARC_PERTURBED,
                                             ARC_WALK};
  enum arc_given given = (enum arc_given)unit_random_below(r, ARC_GIVEN_N);
  size_t n = 3 + unit_random_below(r, 6), family = unit_random_below(r, 3);
  if (given <= ARC_SOFT && unit_random_below(r, 4) == 0) {
    arc_closed(r, given, n, &data);
    return;
  }
  arc_of(r, families[given == ARC_POINTS ? family : 0], given, n, &data);
  data.refine = (int)unit_random_below(r, n == 3 ? 4 : 1);
}

/* What two solutions of one problem may differ by. */
static const double SAME = 1e-8;

static void shift(struct unit_random *r, struct motion *m) {
  m->shift = ph_vec3_scale(unit_random_in(r, 0, 100), unit_random_direction(r));
}

static void reverse(struct unit_random *r, struct motion *m) {
  (void)r;
  m->reverse = true;
}

static void scale(struct unit_random *r, struct motion *m) {
  m->scale = pow(10, (double)unit_random_below(r, 19) - 9);
}

static void (*const changes[])(struct unit_random *, struct motion *) = {
    turn, shift, mirror, reverse, scale};
PH_TEST_EACH(test_motion, COUNT(changes)) {
  struct unit_random r = unit_random_of(1 + (uint64_t)_i);
  size_t solved = 0, n = unit_cases(80);
  for (size_t i = 0; i < n; i++) {
    struct motion m = REST;
    bool again;
    invariant(&r);
    changes[_i](&r, &m);
    if (!arc_solve(&data, i, &one)) {
      continue;
    }
    solved++;
    move_data(&m);
    again = arc_solve(&image, i, &other);
    ck_that(again, "%s", other.diag.message);
    ck_moved(&m, SAME);
  }
  ck_assert_msg(10 * solved >= 9 * n, "PH_SEED=%lu: only %zu of %zu are solved",
                unit_seed(), solved, n);
}

/* Whatever was solved before, in the same memory: not a digit differs. */
PH_TEST(test_neighbours) {
  struct unit_random r = unit_random_of(6);
  for (size_t i = 0; i < unit_cases(20); i++) {
    struct motion m = REST;
    bool a, b;
    arc_any(&r, &image);
    arc_any(&r, &data);
    a = arc_solve(&data, i, &one);
    arc_solve(&image, i, &other);
    b = arc_solve(&data, i, &other);
    ck_that(a == b, "%s", b ? "once" : "not again");
    if (a) {
      ck_moved(&m, 0);
    } else {
      ck_assert_str_eq(one.diag.message, other.diag.message);
    }
  }
}

/* ---- lengths that count less ------------------------------------------ */

/* The largest distance of control points, in mean lengths. */
static double distance(void) {
  const struct ph_curve *a = &one.result.curve, *b = &other.result.curve;
  double worst = 0;
  ck_assert_uint_eq(a->n, b->n);
  for (size_t k = 0; k < a->n; k++) {
    for (size_t i = 0; i < 6; i++) {
      double d = unit_apart(arc_point(&one, k, i), arc_point(&other, k, i));
      worst = unit_larger(worst, d);
    }
  }
  return worst * (double)data.n / a->length;
}

/* Soft lengths are missed by the square of a deviation that is small enough;
 * with a large one they are free. */
PH_TEST(test_soft_limits) {
  struct unit_random r = unit_random_of(7);
  size_t solved = 0, count = unit_cases(20);
  for (size_t i = 0; i < count; i++) {
    size_t n = 3 + unit_random_below(&r, 6);
    double small, smaller, away;
    arc_of(&r, ARC_SMOOTH, ARC_POINTS, n, &data);
    data.refine = 2;
    arc_must(&data, i, &one);
    data.given = ARC_SOFT;
    data.sigma = 1e-4;
    arc_must(&data, i, &other);
    small = distance();
    data.sigma = 1e-5;
    if (arc_solve(&data, i, &other)) {
      solved++;
      smaller = distance();
      ck_that(small > 1e-3 || smaller <= 0.5 * small + 1e-8,
              "%.3g and %.3g away", small, smaller);
    }
    data.sigma = 1000;
    data.knots = "chordal";
    arc_must(&data, i, &one);
    data.given = ARC_RELAXED;
    arc_must(&data, i, &other);
    away = distance();
    ck_that(away <= 1e-6, "large: %.3g away", away);
  }
  ck_assert_msg(100 * solved >= 95 * count,
                "PH_SEED=%lu: only %zu of %zu are solved", unit_seed(), solved,
                count);
}

/* The deviation grows: lengths go from the exact to the natural ones, and F
 * from the one to the other. */
PH_TEST(test_soft_is_monotone) {
  struct unit_random r = unit_random_of(8);
  for (size_t i = 0; i < unit_cases(20); i++) {
    double before = HUGE_VAL;
    arc_of(&r, ARC_PERTURBED, ARC_SOFT, 5, &data);
    for (int k = -3; k <= 1; k++) {
      data.sigma = pow(10, k);
      arc_must(&data, i, &one);
      ck_that(arc_f(&one) <= before * (1 + 1e-8), "F %.17g > %.17g",
              arc_f(&one), before);
      before = arc_f(&one);
    }
  }
}

/* Lengths that are asked for, and are natural, change nothing; where F is 0 to
 * rounding (three points) more than one curve has them. */
PH_TEST(test_natural_lengths) {
  struct unit_random r = unit_random_of(9);
  for (size_t i = 0; i < unit_cases(20); i++) {
    double away;
    arc_of(&r, ARC_SMOOTH, ARC_RELAXED, 2 + unit_random_below(&r, 7), &data);
    data.refine = 1 + (int)unit_random_below(&r, 2);
    data.knots = "chordal";
    arc_must(&data, i, &one);
    data.given = ARC_POINTS;
    for (size_t k = 0; k < data.n; k++) {
      data.length[k] = arc_length(&one, data.n, k);
    }
    arc_must(&data, i, &other);
    away = distance();
    ck_that((away <= 1e-5 || arc_f(&one) < 1e-25) &&
                is_near_f(arc_f(&one), arc_f(&other), 1e-6),
            "%zu intervals, refine %d: %.3g away, F %.17g, %.17g", data.n,
            data.refine, away, arc_f(&one), arc_f(&other));
  }
}

/* ---- segments, intervals ---------------------------------------------- */

/* Of two F. */
static bool is_at_most(double a, double b) {
  return a <= b || is_near_f(a, b, 1e-8);
}

/* The splines of one segment in each interval are among those of two; lengths
 * that are prescribed cost. */
PH_TEST(test_nested) {
  struct unit_random r = unit_random_of(10);
  for (size_t i = 0; i < unit_cases(50); i++) {
    enum arc_given given = (enum arc_given)unit_random_below(&r, ARC_GIVEN_N);
    size_t n = 3 + unit_random_below(&r, 3);
    double fine;
    given = given == ARC_SOFT ? ARC_POINTS : given;
    arc_of(&r, ARC_SMOOTH, given, n, &data);
    data.refine = 2;
    arc_must(&data, i, &one);
    fine = arc_f(&one);
    data.refine = 1;
    if (arc_solve(&data, i, &other)) {
      ck_that(is_at_most(fine, arc_f(&other)), "F %.17g > %.17g", fine,
              arc_f(&other));
    }
    if (given == ARC_POINTS) {
      data.refine = 2;
      data.knots = "chordal";
      arc_must(&data, i, &one);
      data.given = ARC_RELAXED;
      arc_must(&data, i, &other);
      ck_that(is_at_most(arc_f(&other), arc_f(&one)), "F %.17g > %.17g",
              arc_f(&other), arc_f(&one));
    }
  }
}

/* A single interval has a curve that does not bend its preimage at all: F = 0,
 * but for a plane loop. */
PH_TEST(test_one_interval) {
  struct unit_random r = unit_random_of(11);
  for (size_t i = 0; i < unit_cases(50); i++) {
    arc_of(&r, i % 2 ? ARC_SMOOTH : ARC_WALK, ARC_POINTS, 1, &data);
    data.refine = 1 + (int)unit_random_below(&r, 3);
    arc_must(&data, i, &one);
    ck_that(arc_f(&one) <= 1e-12 * data.length[0], "F %.3g", arc_f(&one));
  }
}

/* Few intervals, anything given, anything smooth: there is a curve. */
PH_TEST(test_few_intervals) {
  struct unit_random r = unit_random_of(12);
  for (size_t i = 0; i < unit_cases(100); i++) {
    enum arc_given given = (enum arc_given)unit_random_below(&r, ARC_GIVEN_N);
    enum arc_family family = i % 2 ? ARC_SMOOTH : ARC_PLANE;
    arc_of(&r, family, given, 1 + unit_random_below(&r, 3), &data);
    arc_must(&data, i, &one);
  }
}

/* ---- lines ------------------------------------------------------------ */

/* Data of a line, lengths equal to the chords: the line, at every point of it.
 * Knots by length are met with constant speed: F = 0. */
PH_TEST(test_line) {
  struct unit_random r = unit_random_of(13);
  for (size_t i = 0; i < unit_cases(50); i++) {
    static const enum arc_given given[] = {ARC_POINTS, ARC_RELAXED, ARC_SOFT,
                                           ARC_TANGENTS};
    ph_vec3 from, way;
    arc_of(&r, ARC_LINE, given[i % 4], 1 + unit_random_below(&r, 6), &data);
    arc_must(&data, i, &one);
    ck_that(arc_f(&one) <= 1e-12 * data.length[0], "F %.3g", arc_f(&one));
    from = data.point[0];
    way = ph_vec3_unit(ph_vec3_sub(data.point[1], from));
    for (size_t k = 0; k < one.result.curve.n; k++) {
      for (size_t j = 0; j < 6; j++) {
        ph_vec3 v = ph_vec3_sub(arc_point(&one, k, j), from);
        double off = ph_vec3_abs(ph_vec3_cross(v, way));
        ck_that(off <= 1e-12 * (1 + ph_vec3_abs(v)),
                "segment %zu is %.3g off the line", k, off);
      }
    }
  }
}

/* Data of a line with longer lengths: a curve, or none; never a wrong one. */
PH_TEST(test_line_with_slack) {
  struct unit_random r = unit_random_of(14);
  for (size_t i = 0; i < unit_cases(20); i++) {
    arc_of(&r, ARC_LINE, ARC_POINTS, 1 + unit_random_below(&r, 4), &data);
    for (size_t k = 0; k < data.n; k++) {
      data.length[k] *= unit_random_in(&r, 1.001, 2);
    }
    arc_solve(&data, i, &one);
  }
}

/* ---- anything --------------------------------------------------------- */

/* A curve that is right, or none: arc_solve looks.  Most have one. */
PH_TEST(test_any) {
  struct unit_random r = unit_random_of(15);
  size_t solved = 0, n = unit_cases(100);
  for (size_t i = 0; i < n; i++) {
    arc_any(&r, &data);
    solved += arc_solve(&data, i, &one);
  }
  ck_assert_msg(2 * solved >= n, "PH_SEED=%lu: only %zu of %zu are solved",
                unit_seed(), solved, n);
}

/* The same closed data, from another of their points on. */
static void start_at(size_t first) {
  image = data;
  for (size_t k = 0; k < data.n; k++) {
    image.point[k] = data.point[(first + k) % data.n];
    image.length[k] = data.length[(first + k) % data.n];
  }
}

/* The largest distance of control points, in mean lengths. */
static double distance_from(size_t first) {
  size_t segments = one.result.curve.n;
  double worst = 0;
  for (size_t k = 0; k < 6 * segments; k++) {
    size_t from = (k / 6 + first * segments / data.n) % segments;
    worst = unit_larger(worst, unit_apart(arc_point(&one, from, k % 6),
                                          arc_point(&other, k / 6, k % 6)));
  }
  return worst * (double)data.n / one.result.curve.length;
}

/* Closed curves are the same wherever they begin. */
PH_TEST(test_closed_start) {
  struct unit_random r = unit_random_of(16);
  for (size_t i = 0; i < unit_cases(20); i++) {
    enum arc_given given = (enum arc_given)unit_random_below(&r, ARC_SOFT + 1);
    size_t first;
    double away;
    arc_closed(&r, given, 10 + unit_random_below(&r, 7), &data);
    first = 1 + unit_random_below(&r, data.n - 1);
    start_at(first);
    arc_must(&data, i, &one);
    arc_must(&image, i, &other);
    ck_that(is_near_f(arc_f(&one), arc_f(&other), SAME), "F is %.15g and %.15g",
            arc_f(&one), arc_f(&other));
    away = distance_from(first);
    ck_that(away <= 1e-6, "it is %.3g away", away);
  }
}

PH_FIXTURE(NULL, finish)
