/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The fairest planar splines over their angles and knots. */
#include "unit.h"
#include "planar_unit.h"

#include "curve/fair/energy.h"
#include "solve/planar/planar.h"

static const double PI = 3.14159265358979323846;

enum { UNKNOWNS_MAX = 64 };

static const enum ph_planar_functional ALL[] = {PH_PLANAR_E, PH_PLANAR_MV,
                                                PH_PLANAR_IES, PH_PLANAR_IMV};

/* A problem, its data, and where they are least. */
static struct unit_solution u;
static struct ph_planar_data data;
static struct ph_planar_min report;
static ph_cplx b[UNKNOWNS_MAX];
static size_t steps = PH_PLANAR_STEPS_MAX;

static void begin(const double *v, size_t n, bool closed, bool atph) {
  unit_solution_free(&u);
  u = unit_planar_of(v, n, closed);
  u.problem.field[PH_F_BASIS] =
      (struct ph_value){.kind = PH_WORD, .word = atph ? "atph" : "ph"};
}

static void finish(void) {
  unit_solution_free(&u);
}

static void read_data(void) {
  enum ph_status status = ph_planar_data_of(&u.problem, &u.arena, &u.arena,
                                            &u.arena, &data, &u.diag);
  ck_assert_msg(status == PH_OK, "%s", u.diag.message);
  ck_assert_uint_le(ph_planar_unknowns(&data.c2), UNKNOWNS_MAX);
}

static enum ph_status minimize(enum ph_planar_functional functional,
                               bool scale) {
  struct ph_mark before = ph_arena_mark(&u.scratch), after;
  enum ph_status status;
  read_data();
  status = ph_planar_minimize(&data, functional, scale, steps, &u.scratch, b,
                              &report, &u.diag);
  after = ph_arena_mark(&u.scratch);
  ck_assert(!before.chunk || before.chunk == after.chunk);
  ck_assert_uint_eq(before.used, after.used);
  return status;
}

static void ck_minimize(enum ph_planar_functional functional, bool scale) {
  enum ph_status status = minimize(functional, scale);
  ck_assert_msg(status == PH_OK, "seed %lu: %s", unit_seed(), u.diag.message);
}

/* The functional of the curve that the data and b say, by another path. */
static double functional_of(enum ph_planar_functional functional) {
  struct ph_planar_loops loops;
  struct ph_curve curve;
  struct ph_energy energy;
  double length;
  ck_assert_int_eq(ph_planar_curve_alloc(&data, &u.arena, &curve, &u.diag),
                   PH_OK);
  ph_planar_curve_fill(&data, b, &u.arena, &curve, &loops);
  ck_assert(ph_energy_planar(&curve, &energy));
  length = curve.length;
  return functional == PH_PLANAR_E     ? energy.bending
         : functional == PH_PLANAR_MV  ? energy.varying
         : functional == PH_PLANAR_IES ? energy.bending * length
                                       : energy.varying * pow(length, 3);
}

static double angle(size_t k) {
  return data.space[k].angle / PI;
}

/* Four points of [GON18, Table 2.2]. */
static const double TABLE[] = {-2.1,   1.8,    -0.8333, -0.1,
                               0.9833, 1.4167, 2.5667,  0.6};
static const double TABLE_ENDS[] = {0.9918, -3.6084, 1.4668, -1.9834};

/* [GON18, fig. 2.17], open: IES = 25.0506. */
PH_TEST(test_published) {
  begin(TABLE, 4, false, true);
  unit_planar_ends(&u, TABLE_ENDS);
  ck_minimize(PH_PLANAR_IES, false);
  ck_rel(report.minimum, 25.0506578, 2e-6);
  ck_rel(functional_of(PH_PLANAR_IES), report.minimum, 1e-11);
  ck_abs(angle(0), 0.1440, 0.002);
  ck_abs(angle(1), 0.1277, 0.002);
  ck_abs(angle(2), 0.1311, 0.002);
  ck_assert(!report.at_bound);
}

/* The angles of the same table do not minimise MV as it is defined; its
 * minimum has an angle at the bound. */
PH_TEST(test_at_bound) {
  static const double mv[] = {0.3539, 2 / 3.0, 0.3760};
  static const double imv[] = {0.3566, 2 / 3.0, 0.3737};
  begin(TABLE, 4, false, true);
  unit_planar_ends(&u, TABLE_ENDS);
  ck_minimize(PH_PLANAR_MV, false);
  ck_assert(report.at_bound);
  for (size_t k = 0; k < 3; k++) {
    ck_abs(angle(k), mv[k], 1e-4);
  }
  ck_minimize(PH_PLANAR_IMV, false);
  ck_assert(report.at_bound);
  ck_rel(report.minimum, 1491.61, 1e-5);
  for (size_t k = 0; k < 3; k++) {
    ck_abs(angle(k), imv[k], 1e-4);
  }
}

/* A bent ring or arc of n points, none of them too near to the next. */
static void random_ring(struct unit_random *r, size_t n, double *v) {
  for (size_t k = 0; k < n; k++) {
    double at = ((double)k + unit_random_in(r, -0.3, 0.3)) / (double)n;
    double radius = 1 + unit_random_in(r, -0.5, 0.5) / (double)n;
    v[2 * k] = 1.5 * radius * cos(2 * PI * at);
    v[2 * k + 1] = radius * sin(2 * PI * at);
  }
}

/* Solves, and measures one functional, for given spacings. */
static double value_at(enum ph_planar_functional functional,
                       const double *spacing) {
  struct ph_planar_report newton;
  ck_assert_int_eq(ph_planar_data_space(&data, spacing, &u.diag), PH_OK);
  ck_assert_int_eq(
      ph_planar_c2_solve(&data.c2, &u.scratch, b, &newton, &u.diag), PH_OK);
  return functional_of(functional);
}

/* d log J / d log spacing[k] by differences of fourth order. */
static double difference(enum ph_planar_functional functional,
                         const double *given, size_t k) {
  const double step = 2e-3;
  double spacing[8], value[4];
  static const double at[] = {-2, -1, 1, 2};
  memcpy(spacing, given, data.n * sizeof *spacing);
  for (size_t i = 0; i < 4; i++) {
    spacing[k] = given[k] * exp(at[i] * step);
    value[i] = log(value_at(functional, spacing));
  }
  return (value[0] - value[3] + 8 * (value[2] - value[1])) / (12 * step);
}

/* The gradient of E and MV against differences: open and closed, angles and
 * knots, end derivatives given and by rule. */
PH_TEST_EACH(test_gradient, 16) {
  struct unit_random r = unit_random_of(30);
  const bool closed = _i & 1, atph = _i & 2, ends = _i & 4, knots = _i & 8;
  const double given_ends[] = {0.1, 2, 0.2, 2}, own[] = {0, 1, 1.5, 3, 4, 5, 7};
  double v[12], spacing[6];
  if (closed && ends) {
    return; /* a closed curve has none */
  }
  random_ring(&r, 6, v);
  begin(v, 6, closed, atph);
  if (ends) {
    unit_planar_ends(&u, given_ends);
  }
  if (knots) {
    unit_planar_knots(&u, own, closed ? 7 : 6);
  }
  read_data();
  for (size_t k = 0; k < data.n; k++) {
    spacing[k] = (atph ? 0.7 : 1) * unit_random_in(&r, 0.8, 1.6);
  }
  for (int which = 0; which < 2; which++) {
    struct ph_planar_gradient g;
    const double weight[] = {which == 0, which == 1, 0};
    double value = value_at(ALL[which], spacing), sum = 0;
    ck_assert_int_eq(ph_planar_gradient_alloc(&g, &data, &u.arena, &u.diag),
                     PH_OK);
    ph_planar_gradient_of(&g, &data, b, weight);
    value = ldexp(value, -(which ? 3 : 1) * data.exponent);
    for (size_t k = 0; k < data.n; k++) {
      sum += g.by_h[k];
    }
    for (size_t k = 0; k < data.n; k++) {
      double by_h = atph && knots ? 0 : g.by_h[k];
      double exact = by_h + g.by_angle[k];
      ck_assert_int_eq(ph_planar_data_space(&data, spacing, &u.diag), PH_OK);
      exact -= atph ? 0 : sum * data.h[k] / (double)data.n;
      ck_abs(difference(ALL[which], spacing, k), exact / value, 1e-8);
    }
  }
}

/* Never worse than the start, inside the bounds, and the curve is what the
 * report says; for a second time (some of them), bit for bit the same. */
PH_TEST(test_improves) {
  for (uint64_t i = 0; i < (uint64_t)unit_count(20); i++) {
    struct unit_random r = unit_random_of(100 + i);
    size_t n = 4 + unit_random_below(&r, 4);
    const bool closed = i & 1, atph = i & 2;
    double v[16], first[8];
    struct ph_planar_min before;
    random_ring(&r, n, v);
    begin(v, n, closed, atph);
    ck_minimize(ALL[i / 4 % 4], false);
    ck_assert_double_lt(report.minimum, report.start);
    ck_rel(functional_of(ALL[i / 4 % 4]), report.minimum, 1e-10);
    for (size_t k = 0; k < data.n; k++) {
      first[k] = atph ? angle(k) : data.h[k];
      ck_assert(first[k] > 0);
      ck_assert(!atph || (angle(k) * PI >= 0.001 * (1 - 1e-14) &&
                          first[k] <= (2 / 3.0) * (1 + 1e-14)));
    }
    if (i % 5) {
      continue;
    }
    before = report;
    ck_minimize(ALL[i / 4 % 4], false);
    ck_rel(report.minimum, before.minimum, 0);
    ck_assert_uint_eq(report.evaluations, before.evaluations);
    for (size_t k = 0; k < data.n; k++) {
      ck_rel(atph ? angle(k) : data.h[k], first[k], 0);
    }
  }
}

/* A minimum: no angle or knot can be moved a little to any profit. */
PH_TEST_EACH(test_stationary, 2) {
  struct unit_random r = unit_random_of(31);
  double v[12], spacing[6];
  const bool atph = _i;
  random_ring(&r, 6, v);
  begin(v, 6, false, atph);
  ck_minimize(PH_PLANAR_IES, false);
  for (size_t k = 0; k < data.n; k++) {
    spacing[k] = atph ? data.space[k].angle : data.h[k];
  }
  for (size_t k = 0; k < data.n; k++) {
    double keep = spacing[k];
    for (int sign = -1; sign <= 1; sign += 2) {
      spacing[k] = keep * (1 + sign * 1e-3);
      if (!atph || spacing[k] <= 2 * PI / 3) {
        ck_assert_double_ge(value_at(PH_PLANAR_IES, spacing),
                            report.minimum * (1 - 1e-11));
      }
    }
    spacing[k] = keep;
  }
}

/* Curves scale and turn with their points; IES stays. */
PH_TEST_EACH(test_invariant, 2) {
  struct unit_random r = unit_random_of(32);
  const double scale = 3e-7, turn = 0.7;
  double v[14], first[7], minimum;
  random_ring(&r, 7, v);
  begin(v, 7, false, _i);
  ck_minimize(PH_PLANAR_IES, false);
  minimum = report.minimum;
  for (size_t k = 0; k < data.n; k++) {
    first[k] = _i ? angle(k) : data.h[k];
  }
  for (size_t k = 0; k < 7; k++) {
    double x = v[2 * k], y = v[2 * k + 1];
    v[2 * k] = scale * (x * cos(turn) - y * sin(turn));
    v[2 * k + 1] = scale * (x * sin(turn) + y * cos(turn));
  }
  begin(v, 7, false, _i);
  ck_minimize(PH_PLANAR_IES, false);
  ck_rel(report.minimum, minimum, 1e-10);
  for (size_t k = 0; k < data.n; k++) {
    ck_rel(_i ? angle(k) : data.h[k], first[k], 1e-3);
  }
}

/* It is found to all digits, though knots have no size of their own: turned by
 * a quarter, and at another size, random data have the same. */
PH_TEST(test_all_digits) {
  enum { POINTS = 12, SETS = 40 };
  for (unsigned long i = 0; i < SETS; i++) {
    struct unit_random r = unit_random_of(600 + i);
    double v[2 * POINTS], minimum;
    random_ring(&r, POINTS, v);
    begin(v, POINTS, false, false);
    ck_minimize(PH_PLANAR_IES, false);
    minimum = report.minimum;
    for (size_t k = 0; k < POINTS; k++) {
      double x = v[2 * k];
      v[2 * k] = -3 * v[2 * k + 1];
      v[2 * k + 1] = 3 * x;
    }
    begin(v, POINTS, false, false);
    ck_minimize(PH_PLANAR_IES, false);
    ck_rel(report.minimum, minimum, 1e-10);
  }
}

/* Starts that differ in the size of their spacings are one where knots are
 * free, and what the data have may be another's: each takes one evaluation if
 * none takes a step, and so do the data. */
PH_TEST(test_starts) {
  const double knots[] = {10, 11, 13, 14};
  steps = 0;
  begin(TABLE, 4, false, false);
  ck_minimize(PH_PLANAR_IES, false);
  ck_assert_uint_eq(report.evaluations, 1 + 4);
  unit_planar_knots(&u, knots, 4);
  ck_minimize(PH_PLANAR_IES, false);
  ck_assert_uint_eq(report.evaluations, 1 + 5);
  begin(TABLE, 4, false, true);
  ck_minimize(PH_PLANAR_IES, false);
  ck_assert_uint_eq(report.evaluations, 1 + 7);
  steps = PH_PLANAR_STEPS_MAX;
}

/* One factor on chordal angles: they stay chordal, and every angle by itself
 * does as well or better. */
PH_TEST(test_scale) {
  double minimum;
  begin(TABLE, 4, false, true);
  unit_planar_ends(&u, TABLE_ENDS);
  ck_minimize(PH_PLANAR_IES, true);
  minimum = report.minimum;
  for (size_t k = 1; k < 3; k++) {
    ck_rel(angle(k) / angle(0), data.chord[k] / data.chord[0], 1e-14);
  }
  ck_minimize(PH_PLANAR_IES, false);
  ck_assert_double_lt(report.minimum, minimum);
  begin(TABLE, 4, false, false);
  ck_assert_int_eq(minimize(PH_PLANAR_IES, true), PH_E_BAD_VALUE);
  ck_assert_str_eq(u.diag.field, "free");
}

/* Knots of PH quintics keep their first and last; knots that were given beside
 * angles stay. */
PH_TEST_EACH(test_knots, 2) {
  const double knots[] = {10, 11, 13, 14};
  begin(TABLE, 4, false, _i);
  unit_planar_knots(&u, knots, 4);
  ck_minimize(PH_PLANAR_IES, false);
  ck_assert_double_lt(report.minimum, report.start);
  for (size_t k = 0; k < 4; k++) {
    ck_assert(k % 3 ? data.knots[k] > data.knots[k - 1] : 1);
    if (_i || k % 3 == 0) {
      ck_rel(data.knots[k], knots[k], 0);
    }
  }
}

/* A search that is cut short says so, and gives the best that it had. */
PH_TEST_EACH(test_cut_short, 2) {
  begin(TABLE, 4, false, _i);
  steps = 1;
  ck_minimize(PH_PLANAR_IES, false);
  steps = PH_PLANAR_STEPS_MAX;
  ck_assert(report.cut_short);
  ck_assert_uint_eq(report.steps_max, 1);
  ck_assert_double_lt(report.minimum, report.start);
  ck_rel(functional_of(PH_PLANAR_IES), report.minimum, 1e-10);
  ck_minimize(PH_PLANAR_IES, false);
  ck_assert(!report.cut_short);
}

/* Many intervals take hardly more steps than a few. */
PH_TEST_EACH(test_many, 2) {
  enum { MANY = 50 };
  double v[2 * MANY];
  for (size_t k = 0; k < MANY; k++) {
    v[2 * k] = (double)k;
    v[2 * k + 1] = 2 * sin(0.6 * (double)k) + 0.5 * cos(1.7 * (double)k);
  }
  begin(v, MANY, false, _i);
  ck_minimize(PH_PLANAR_IES, false);
  ck_assert(!report.cut_short);
  ck_assert_uint_le(report.evaluations, 400);
}

/* A straight line can not be improved, nor does it do harm. */
PH_TEST_EACH(test_straight, 2) {
  const double v[] = {0, 0, 1, 2, 3, 6, 4, 8};
  begin(v, 4, false, _i);
  ck_minimize(PH_PLANAR_IES, false);
  ck_assert_double_le(report.minimum, 1e-16);
}

PH_FIXTURE(NULL, finish)
