/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Properties of planar splines on random data: what must follow when the data
 * are moved, turned, scaled, reversed, mirrored, started elsewhere or refined.
 *
 * The seed is 1, or PH_SEED; PH_LONG=1 takes ten times as many data.  Control
 * points are compared relative to the size of the data, half the diagonal of
 * their bounding box.
 */
#include "planar_data.h"
#include "planar_unit.h"
#include "unit.h"

/* What two solutions of one problem may differ by.  Newton stops at 1e-13 of
 * each chord; over 12000 problems the largest difference was 2e-13. */
#define SAME 1e-11

static struct unit_solution one, other;
static struct prop_data data, image;

static void finish(void) {
  unit_solution_free(&one);
  unit_solution_free(&other);
}

static void solve(struct unit_solution *u, const struct prop_data *d,
                  size_t which) {
  enum ph_status status;
  unit_solution_free(u);
  *u = prop_problem(d, which);
  status = unit_planar_solve(u);
  ck_that(status == PH_OK, "%s %s", u->diag.field, u->diag.message);
}

static void solve_both(size_t which) {
  solve(&one, &data, which);
  solve(&other, &image, which);
}

/* A similarity of the plane: p times `turn`, its conjugate if `mirror`, plus
 * `shift`; and how many times longer the parameter is than before. */
struct motion {
  ph_cplx turn, shift;
  bool mirror;
  double parameter;
};

static const struct motion REST = {{1, 0}, {0, 0}, false, 1};

static ph_cplx moved(const struct motion *m, ph_cplx p) {
  ph_cplx z = m->mirror ? ph_cplx_conj(p) : p;
  return ph_cplx_add(ph_cplx_mul(m->turn, z), m->shift);
}

static void move_data(const struct motion *m) {
  struct motion linear = *m;
  linear.shift = ph_cplx_of(0, 0);
  image = data;
  for (size_t i = 0; i < data.n; i++) {
    image.point[i] = moved(m, data.point[i]);
  }
  for (int side = 0; side < 2; side++) {
    ph_cplx end = moved(&linear, data.end[side]);
    image.end[side] = ph_cplx_scale(1 / m->parameter, end);
  }
  for (size_t i = 0; i <= prop_segments(&data); i++) {
    image.knots[i] = m->parameter * data.knots[i];
  }
}

/* How much longer the parameter gets when lengths do. */
static double stretch_of(double length) {
  bool root = data.rule && strcmp(data.rule, "centripetal") == 0;
  bool none = data.rule && strcmp(data.rule, "uniform") == 0;
  return none ? 1 : root ? sqrt(length) : length;
}

static ph_cplx control_point(const struct ph_curve *curve, size_t i) {
  const double *p = curve->control_points + 2 * i;
  return ph_cplx_of(p[0], p[1]);
}

/* The control points of `other` are those of `one`, moved. */
static void ck_moved(const struct motion *m, double tol) {
  const struct ph_curve *a = &one.result.curve, *b = &other.result.curve;
  double apart = 0, size = unit_planar_size(&other);
  ck_assert_uint_eq(a->n, b->n);
  for (size_t i = 0; i < 6 * a->n; i++) {
    ph_cplx wanted = moved(m, control_point(a, i));
    apart = unit_larger(apart, unit_distance(wanted, control_point(b, i)));
  }
  ck_that(apart <= tol * size, "apart by %.3g of the size", apart / size);
}

static void choose_shift(struct unit_random *r, struct motion *m) {
  m->shift = unit_random_cplx(r, 100);
}

static void choose_far(struct unit_random *r, struct motion *m) {
  double size = unit_planar_size(&one), angle = unit_random_in(r, -4, 4);
  m->shift = ph_cplx_scale(1e6 * size, ph_cplx_polar(angle));
}

/* A million times their size away the data have ten digits left, and the curve
 * loses one more at most: 17 times the rounding of a coordinate over 6000
 * problems. */
PH_TEST(test_translate_far) {
  struct unit_random r = unit_random_of(12);
  for (size_t i = 0; i < unit_cases(200); i++) {
    struct motion m = REST;
    prop_any(&r, 50, &data);
    solve(&one, &data, i);
    choose_far(&r, &m);
    move_data(&m);
    solve(&other, &image, i);
    ck_moved(&m, 128 * 1e6 * DBL_EPSILON);
  }
}

static void choose_turn(struct unit_random *r, struct motion *m) {
  m->turn = ph_cplx_polar(unit_random_in(r, -4, 4));
}

static void choose_half_turn(struct unit_random *r, struct motion *m) {
  (void)r;
  m->turn = ph_cplx_of(-1, 0);
}

static void choose_power_of_ten(struct unit_random *r, struct motion *m) {
  double s = pow(10, (double)unit_random_below(r, 19) - 9);
  m->turn = ph_cplx_of(s, 0);
  m->parameter = stretch_of(s);
}

static void choose_power_of_two(struct unit_random *r, struct motion *m) {
  double s = ldexp(1, (int)unit_random_below(r, 61) - 30);
  m->turn = ph_cplx_of(s, 0);
  m->parameter = stretch_of(s);
}

static void choose_power_of_four(struct unit_random *r, struct motion *m) {
  double s = ldexp(1, 2 * ((int)unit_random_below(r, 401) - 200));
  m->turn = ph_cplx_of(s, 0);
  m->parameter = stretch_of(s);
}

static void choose_mirror(struct unit_random *r, struct motion *m) {
  (void)r;
  m->mirror = true;
}

static void choose_parameter(struct unit_random *r, struct motion *m) {
  m->parameter = data.has_knots ? pow(10, unit_random_in(r, -9, 9)) : 1;
}

static const struct {
  const char *name;
  void (*choose)(struct unit_random *, struct motion *);
  size_t n;
  double tol;
} changes[] = {
    {"moved", choose_shift, 400, SAME},
    {"turned", choose_turn, 400, SAME},
    /* only signs change: not a digit differs */
    {"turned by half a turn", choose_half_turn, 200, 0},
    {"scaled by a power of ten", choose_power_of_ten, 400, SAME},
    {"scaled by a power of two", choose_power_of_two, 400, SAME},
    /* a power of four has a root: not a digit differs */
    {"scaled by a power of four", choose_power_of_four, 200, 0},
    {"mirrored", choose_mirror, 200, 0}, /* only signs change */
    {"in another unit of the parameter", choose_parameter, 400, SAME}};

/* Moves the data of many problems, and compares. */
PH_TEST_EACH(test_motion, COUNT(changes)) {
  struct unit_random r = unit_random_of(1 + (uint64_t)_i);
  for (size_t i = 0; i < unit_cases(changes[_i].n); i++) {
    struct motion m = REST;
    prop_any(&r, 50, &data);
    changes[_i].choose(&r, &m);
    move_data(&m);
    solve_both(i);
    ck_moved(&m, changes[_i].tol);
  }
}

/* Run through backwards. */
PH_TEST(test_reverse) {
  struct unit_random r = unit_random_of(9);
  for (size_t i = 0; i < unit_cases(400); i++) {
    const struct ph_curve *a = &one.result.curve, *b = &other.result.curve;
    double apart = 0;
    size_t n, segments;
    prop_any(&r, 50, &data);
    n = data.n;
    segments = prop_segments(&data);
    image = data;
    for (size_t k = 0; k < n; k++) {
      /* closed curves keep their first point */
      size_t from = data.closed ? (n - k) % n : n - 1 - k;
      image.point[k] = data.point[from];
    }
    for (size_t k = 0; k <= segments; k++) {
      image.knots[k] = -data.knots[segments - k];
    }
    image.end[0] = ph_cplx_scale(-1, data.end[1]);
    image.end[1] = ph_cplx_scale(-1, data.end[0]);
    solve_both(i);
    for (size_t k = 0; k < 6 * segments; k++) {
      ph_cplx p = control_point(a, k),
              q = control_point(b, 6 * segments - 1 - k);
      apart = unit_larger(apart, unit_distance(p, q));
    }
    ck_that(apart <= SAME * unit_planar_size(&one), "apart by %.3g", apart);
    ck_that(unit_near_rel(a->length, b->length, SAME), "lengths %.17g, %.17g",
            a->length, b->length);
  }
}

/* A closed curve that begins at another of its points. */
PH_TEST(test_other_start) {
  struct unit_random r = unit_random_of(10);
  for (size_t i = 0; i < unit_cases(400); i++) {
    const struct ph_curve *a = &one.result.curve, *b = &other.result.curve;
    double apart = 0;
    size_t n, first;
    do {
      prop_any(&r, 50, &data);
    } while (!data.closed);
    n = data.n;
    first = 1 + unit_random_below(&r, n - 1);
    image = data;
    image.knots[0] = 0;
    for (size_t k = 0; k < n; k++) {
      size_t from = (first + k) % n;
      image.point[k] = data.point[from];
      image.knots[k + 1] =
          image.knots[k] + (data.knots[from + 1] - data.knots[from]);
    }
    solve_both(i);
    for (size_t k = 0; k < 6 * n; k++) {
      ph_cplx p = control_point(a, (6 * first + k) % (6 * n));
      apart = unit_larger(apart, unit_distance(p, control_point(b, k)));
    }
    ck_that(apart <= SAME * unit_planar_size(&one),
            "apart by %.3g, begun at %zu", apart, first);
  }
}

/* Points of the curve, added to the data, change nothing: the curve is a C2 PH
 * spline on the finer knots, too. */
PH_TEST(test_refine) {
  struct unit_random r = unit_random_of(11);
  for (size_t i = 0; i < unit_cases(200); i++) {
    const struct ph_curve *a = &one.result.curve;
    double apart = 0, size;
    prop_points(&r, PROP_ROUGH, 8 + unit_random_below(&r, 30), i % 2, &data);
    solve(&one, &data, i);
    size = unit_planar_size(&one);
    image = (struct prop_data){
        .n = 2 * a->n + !a->closed, .closed = a->closed, .has_knots = true};
    for (size_t k = 0; k < a->n; k++) {
      double t0 = a->knots[k], t1 = a->knots[k + 1];
      double t = t0 + unit_random_in(&r, 0.3, 0.7) * (t1 - t0);
      image.point[2 * k] = data.point[k];
      image.knots[2 * k] = t0;
      image.knots[2 * k + 1] = t;
      image.point[2 * k + 1] = unit_curve(a, k, 0, (t - t0) / (t1 - t0));
    }
    image.knots[2 * a->n] = a->knots[a->n];
    if (!a->closed) {
      double h0 = a->knots[1] - a->knots[0];
      double h1 = a->knots[a->n] - a->knots[a->n - 1];
      image.point[2 * a->n] = data.point[a->n];
      image.has_ends = true;
      image.end[0] = ph_cplx_scale(1 / h0, unit_curve(a, 0, 1, 0));
      image.end[1] = ph_cplx_scale(1 / h1, unit_curve(a, a->n - 1, 1, 1));
    }
    solve(&other, &image, i);
    for (size_t k = 0; k < 2 * a->n; k++) {
      const double *knots = a->knots + k / 2;
      double t = 0.5 * (image.knots[k] + image.knots[k + 1]);
      double u = (t - knots[0]) / (knots[1] - knots[0]);
      ph_cplx p = unit_curve(a, k / 2, 0, u);
      ph_cplx q = unit_curve(&other.result.curve, k, 0, 0.5);
      apart = unit_larger(apart, unit_distance(p, q));
    }
    ck_that(apart <= SAME * size, "apart by %.3g", apart);
    ck_that(unit_near_rel(a->length, other.result.curve.length, SAME),
            "lengths %.17g, %.17g", a->length, other.result.curve.length);
  }
}

PH_FIXTURE(NULL, finish)
