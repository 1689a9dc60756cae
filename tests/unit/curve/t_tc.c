/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One Tschirnhausen cubic: leg, length, turning, loops, bending, parts. */
#include "unit.h"
#include "tc_curve_unit.h"

#include "curve/segment/tc.h"
#include "kernel/pi.h"

enum { CUBICS = 2000, STEPS = 16 };

/* Ends between 2^-8 and 1 in modulus, every direction. */
static ph_cplx random_preimage(struct unit_random *r) {
  double size = exp2(unit_random_in(r, -8, 0));
  double angle = unit_random_in(r, -PH_PI, PH_PI);
  return ph_cplx_scale(size, ph_cplx_polar(angle));
}

static struct ph_tc random_tc(struct unit_random *r) {
  struct ph_tc tc;
  tc.w[0] = random_preimage(r);
  tc.w[1] = random_preimage(r);
  return tc;
}

static struct ph_tc tc_of(double re0, double im0, double re1, double im1) {
  struct ph_tc tc = {{{re0, im0}, {re1, im1}}};
  return tc;
}

/* ---- legs and control points -------------------------------------------- */

/* Some eps of the length, also of short parts at either end. */
PH_TEST(test_leg) {
  struct unit_random r = unit_random_of(1);
  int n = unit_count(CUBICS);
  for (int i = 0; i < n; i++) {
    struct ph_tc tc = random_tc(&r);
    double eps = DBL_EPSILON * ph_tc_length(&tc);
    double h = exp2(-floor(unit_random_in(&r, 20, 50)));
    struct ph_tc head = ph_tc_part(&tc, 0, h), tail = ph_tc_part(&tc, 1 - h, 1);
    ph_cplx leg = ph_tc_leg(&tc), rest = ph_cplx_sub(leg, ph_tc_leg(&tail));
    ck_abs(unit_distance(leg, unit_tc_at(&tc, 1)), 0, 8 * eps);
    ck_abs(unit_distance(rest, unit_tc_at(&tc, 1 - h)), 0, 8 * eps);
    ck_abs(unit_distance(ph_tc_leg(&head), unit_tc_at(&tc, h)), 0,
           8 * DBL_EPSILON * ph_tc_length(&head));
  }
}

PH_TEST(test_control_points) {
  struct unit_random r = unit_random_of(3);
  int n = unit_count(CUBICS);
  for (int i = 0; i < n; i++) {
    struct ph_tc tc = random_tc(&r);
    ph_cplx start = unit_random_cplx(&r, 1), p[4];
    ph_cplx end = ph_cplx_add(start, ph_tc_leg(&tc));
    ph_tc_control_points(&tc, start, end, p);
    ck_abs(unit_distance(p[0], start), 0, 0);
    ck_abs(unit_distance(p[3], end), 0, 0);
    for (int k = 0; k <= STEPS; k++) {
      double t = (double)k / STEPS, s = 1 - t;
      const double b[4] = {s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
      ph_cplx at = ph_cplx_add(start, unit_tc_at(&tc, t)), sum = {0, 0};
      for (int j = 0; j < 4; j++) {
        sum = ph_cplx_add(sum, ph_cplx_scale(b[j], p[j]));
      }
      ck_abs(unit_distance(at, sum), 0, 1e-14);
    }
  }
}

/* An end that the leg misses is met all the same, with the right directions. */
PH_TEST(test_control_points_missed_end) {
  struct ph_tc tc = tc_of(1, 0.5, -0.25, 1);
  ph_cplx start = {7, -3}, end = ph_cplx_add(start, ph_tc_leg(&tc)), p[4];
  end.re += 1e-3;
  ph_tc_control_points(&tc, start, end, p);
  ck_abs(unit_distance(p[3], end), 0, 0);
  for (int i = 0; i < 2; i++) {
    ph_cplx leg = ph_cplx_sub(p[2 * i + 1], p[2 * i]);
    ph_cplx square = ph_cplx_mul(tc.w[i], tc.w[i]);
    ck_abs(unit_distance(ph_cplx_scale(3, leg), square), 0, 1e-14);
  }
}

PH_TEST(test_parts) {
  struct unit_random r = unit_random_of(4);
  int n = unit_count(CUBICS);
  for (int i = 0; i < n; i++) {
    struct ph_tc tc = random_tc(&r), part;
    double eps = DBL_EPSILON * ph_tc_length(&tc), length = 0, turning = 0;
    for (int k = 0; k < STEPS; k++) {
      double u = (double)k / STEPS, v = (double)(k + 1) / STEPS;
      ph_cplx way = ph_cplx_sub(unit_tc_at(&tc, v), unit_tc_at(&tc, u));
      part = ph_tc_part(&tc, u, v);
      ck_abs(unit_distance(ph_tc_leg(&part), way), 0, 8 * eps);
      length += ph_tc_length(&part);
      turning += ph_tc_turning(&part);
    }
    ck_rel(length, ph_tc_length(&tc), 16 * DBL_EPSILON);
    ck_abs(turning, ph_tc_turning(&tc), 1e-12);
  }
}

/* ---- length, turning, curvature ----------------------------------------- */

PH_TEST(test_known) {
  /* [BYR11, ex. 1]: 6 wide, tangents at -45 and 45 degrees */
  double leg = 6 / (1 + sqrt(2)), size = sqrt(3 * leg);
  ph_cplx w0 = ph_cplx_scale(size, ph_cplx_polar(-PH_PI / 8));
  ph_cplx w1 = ph_cplx_scale(size, ph_cplx_polar(PH_PI / 8));
  struct ph_tc tc = {{w0, w1}}, loop = {{w0, {0, 0}}};
  ck_abs(unit_distance(ph_tc_leg(&tc), ph_cplx_of(6, 0)), 0, 1e-14);
  ck_rel(ph_tc_length(&tc), 6.727922061357855, 1e-15);
  ck_rel(ph_tc_turning(&tc), PH_PI / 2, 1e-15);
  ck_assert(!ph_tc_has_loop(&tc));
  /* and the one with a loop */
  size = sqrt(18 / (sqrt(2) - 1));
  loop.w[0] = ph_cplx_scale(size, ph_cplx_polar(-PH_PI / 8));
  loop.w[1] = ph_cplx_scale(-size, ph_cplx_polar(PH_PI / 8));
  ck_abs(unit_distance(ph_tc_leg(&loop), ph_cplx_of(6, 0)), 0, 1e-13);
  ck_rel(ph_tc_length(&loop), 18.727922061357855, 1e-15);
  ck_rel(ph_tc_turning(&loop), -1.5 * PH_PI, 1e-15);
  ck_assert(ph_tc_has_loop(&loop));
}

/* 2 K/|w|^4 */
static double curvature(const struct ph_tc *tc, double t) {
  ph_cplx w = ph_cplx_between(tc->w[0], tc->w[1], t);
  return 2 * ph_cplx_cross(tc->w[0], tc->w[1]) / pow(ph_cplx_norm2(w), 2);
}

/* Curvature is the turning over the length, of a short part. */
PH_TEST(test_curvature) {
  struct unit_random r = unit_random_of(5);
  int n = unit_count(CUBICS);
  for (int i = 0; i < n; i++) {
    struct ph_tc tc = random_tc(&r);
    double h = 0x1p-13;
    double t = unit_random_in(&r, h, 1 - h);
    struct ph_tc part = ph_tc_part(&tc, t - h, t + h);
    double mean = ph_tc_turning(&part) / ph_tc_length(&part);
    double w2 = ph_cplx_norm2(part.w[0]) / (2 * h);
    double d2 = ph_cplx_norm2(ph_cplx_sub(tc.w[1], tc.w[0]));
    double at = curvature(&tc, t);
    /* the change of |w|^-4 to the second order in h, and the rounding of K */
    double change = 40 * h * h * d2 / w2;
    double rounding = 32 * DBL_EPSILON / fabs(ph_tc_turning(&part));
    ck_rel(at, mean, change + rounding);
  }
}

PH_TEST(test_vertex) {
  struct unit_random r = unit_random_of(6);
  int n = unit_count(CUBICS), inner = 0;
  for (int i = 0; i < n; i++) {
    struct ph_tc tc = random_tc(&r);
    double t = ph_tc_vertex(&tc), most = fabs(curvature(&tc, t));
    ck_assert(t >= 0 && t <= 1);
    inner += t > 0 && t < 1;
    for (int k = 0; k <= STEPS; k++) {
      double other = curvature(&tc, (double)k / STEPS);
      ck_assert_double_le(fabs(other), most * (1 + 1e-12));
    }
  }
  ck_assert_int_gt(inner, n / 4);
  ck_assert_int_lt(inner, n);
}

PH_TEST(test_vertex_known) {
  const struct ph_tc even = tc_of(0.5, -0.5, 0.5, 0.5);
  const struct ph_tc quarter = tc_of(1, -0.25, 1, 0.75);
  const struct ph_tc slower = tc_of(2, 0, 1, 0.5), faster = tc_of(1, 0.5, 2, 0);
  const struct ph_tc same = tc_of(1, 0.5, 1, 0.5);
  ck_abs(ph_tc_vertex(&even), 0.5, 0);
  ck_abs(ph_tc_vertex(&quarter), 0.25, 0);
  ck_abs(ph_tc_vertex(&slower), 1, 0);
  ck_abs(ph_tc_vertex(&faster), 0, 0);
  ck_abs(ph_tc_vertex(&same), 0, 0);
}

/* ---- regular, loops ----------------------------------------------------- */

PH_TEST(test_regular) {
  const double inf = (double)INFINITY, nan = (double)NAN;
  const struct {
    struct ph_tc tc;
    bool regular;
  } cases[] = {
      {{{{1, 0}, {1, 0}}}, true},      {{{{1, 0}, {0, 1}}}, true},
      {{{{1, 0}, {1e-11, 0}}}, true},  {{{{1e-11, 0}, {0, 1}}}, true},
      {{{{1, 0}, {1e-13, 0}}}, false}, {{{{1e-13, 0}, {0, 1}}}, false},
      {{{{0, 0}, {0, 1}}}, false},     {{{{1, 1}, {0, 0}}}, false},
      {{{{0, 0}, {0, 0}}}, false},     {{{{1, 0}, {-1, 0}}}, false},
      {{{{3, 4}, {-6, -8}}}, false},   {{{{1, 0}, {-1, 1e-13}}}, false},
      {{{{1, 0}, {-1, 1e-11}}}, true}, {{{{1, 0}, {-1, -1e-11}}}, true},
      {{{{1, 0}, {1, 1e-300}}}, true}, {{{{nan, 0}, {1, 1}}}, false},
      {{{{1, 0}, {1, nan}}}, false},   {{{{inf, 0}, {1, 0}}}, false},
      {{{{1, 0}, {0, inf}}}, false},   {{{{inf, 0}, {inf, 0}}}, false},
  };
  for (size_t i = 0; i < COUNT(cases); i++) {
    const struct ph_tc *tc = &cases[i].tc;
    double energy = ph_tc_energy(tc);
    ck_assert_msg(ph_tc_is_regular(tc) == cases[i].regular, "case %zu", i);
    ck_assert_msg(isfinite(energy) == cases[i].regular, "case %zu: %g", i,
                  energy);
  }
}

/* The parameters of the double point of the unbounded cubic [BYR11, (5.16),
 * (5.17)]: (A - R -+ sqrt3 |K|)/M, with differences of w that do not cancel. */
static void double_point(const struct ph_tc *tc, double t[2]) {
  ph_cplx d = ph_cplx_sub(tc->w[1], tc->w[0]);
  double square = ph_cplx_norm2(d), foot = -ph_cplx_dot(tc->w[0], d);
  double half = sqrt(3) * fabs(ph_cplx_cross(tc->w[0], d));
  t[0] = (foot - half) / square;
  t[1] = (foot + half) / square;
}

/* A loop is where both are on it; the formula is tested with it. */
PH_TEST(test_has_loop) {
  struct unit_random r = unit_random_of(7);
  int n = unit_count(10 * CUBICS), loops = 0;
  for (int i = 0; i < n; i++) {
    struct ph_tc tc = random_tc(&r);
    double t[2], reach;
    bool inside;
    double_point(&tc, t);
    reach = 1 + fabs(t[0]) + fabs(t[1]);
    ck_abs(unit_distance(unit_tc_at(&tc, t[0]), unit_tc_at(&tc, t[1])), 0,
           1e-13 * reach * reach * reach);
    inside = t[0] >= 0 && t[1] <= 1;
    ck_assert_int_eq(ph_tc_has_loop(&tc), inside);
    loops += inside;
    if (inside) {
      ck_assert_double_gt(fabs(ph_tc_turning(&tc)), 4 * PH_PI / 3 - 1e-12);
    }
  }
  ck_assert_int_gt(loops, n / 50);
}

/* Straight to rounding: no loop, though the inequality without R < 0 says so of
 * the last two; and a cusp is none. */
PH_TEST(test_no_loop) {
  const struct ph_tc none[] = {
      tc_of(0.1, 0.7, 0.1, 0.7),
      tc_of(0.1, 0.7, -0.1, -0.7),
      tc_of(-0x1.7a198fa264e1cp-1, 0x1.75049005263ccp-1, -0x1.7a198fa264e1dp-1,
            0x1.75049005263cbp-1),
      tc_of(-0x1.7df2afb1543ccp-2, 0x1.b535ea000e390p-4, -0x1.7df2afb1543cbp-2,
            0x1.b535ea000e392p-4),
  };
  for (size_t i = 0; i < COUNT(none); i++) {
    ck_assert_msg(!ph_tc_has_loop(&none[i]), "%zu", i);
  }
}

/* ---- bending energy ----------------------------------------------------- */

/* From the closed form of the integrals with 110 digits; what is measured is
 * 7.1e-16 here, and 1.2e-15 over 24000 random cubics with sweeps from 1e-12 to
 * pi - 1e-4 and ratios |w1|/|w0| from 1e-3 to 1e3. */
PH_TEST(test_energy_table) {
  static const double cases[][4] = {
      /* w0, w1, energy; sweep and ratio of moduli: */
      {1, 1, 0x1.19799812dea11p-40, 3.9999999999999998e-24}, /* 1e-12, 1 */
      {1, 0x1.004189374bc53p+0, 0x1.aded1d2b3252ap-24,
       3.9960079880167856e-14}, /* 1e-7, 1.001 */
      {0x1p-5, 0x1.f3ffef9db243fp+4, 0x1.fffffa6858247p-6,
       0.82002003972009453}, /* .001, 1000 */
      {1, 0x1.ffc505a355cf6p-3, 0x1.eb723f19667c6p-8,
       0.061384417564864688}, /* .03, .25 */
      {1, 0x1.c1528065b7d50p-1, 0x1.eaee8744b05f0p-2,
       1.0440169855855241}, /* .5, 1 */
      {32, 0x1.45e713e070c67p-6, 0x1.9ab05babe1cefp-6,
       652639.05272430842}, /* .9, .001 */
      {1, 0x1.e4dd553cefbe4p+1, 0x1.78bc9c208f202p+2,
       7.0274768066294316}, /* .999, 7 */
      {1, 0x1.e35b4e78a1866p+1, 0x1.79388acfc5f12p+2,
       7.0583747926945424}, /* 1.001, 7 */
      {1, 0x1.813284e1d6cd9p+3, 0x1.3993647cf6e3ap+4,
       21.111155503170873}, /* 1.02, 23 */
      {32, 0x1.187e2b87d3bc6p-6, 0x1.f92e97273d54bp-5,
       181191.25070828777}, /* 1.3, .002 */
      {1, -0x1.de67ac55f1633p-6, 0x1.ffc81c7e042c5p-1,
       18.601167255389739}, /* 1.6, 1 */
      {1, -0x1.e219a127448b4p-3, 0x1.4b28fe15578d4p-2,
       362.85513133689065}, /* 2.2, .4 */
      {0x1p-5, -0x1.e57aa527d6d44p+4, 0x1.de7fa81427fbep+2,
       353684581.31146499}, /* 2.9, 1000 */
      {1, -0x1.ff8ea4756a624p-1, 0x1.54a0f8298102ep-5,
       1047879.2036560822}, /* 3.1, 1 */
      {32, -0x1.758e17d55e797p-3, 0x1.55755176aa9c5p-13,
       35738943525694.6}, /* 3.1407, .0057 */
      {1, -0x1.ffffffd50ce24p-1, 0x1.a36e2ea607ce7p-14,
       75398223686405.195}, /* 3.14149, 1 */
  };
  for (size_t i = 0; i < COUNT(cases); i++) {
    const double *c = cases[i];
    struct ph_tc tc = tc_of(c[0], 0, c[1], c[2]);
    struct ph_tc mirrored = tc_of(c[0], 0, c[1], -c[2]);
    struct ph_tc reversed = tc_of(-c[2], c[1], 0, c[0]);
    struct ph_tc negated = tc_of(-c[0], 0, -c[1], -c[2]);
    ck_rel(ph_tc_energy(&tc), c[3], 2e-15);
    ck_rel(ph_tc_energy(&mirrored), c[3], 2e-15);
    ck_rel(ph_tc_energy(&reversed), c[3], 2e-15);
    ck_rel(ph_tc_energy(&negated), c[3], 2e-15);
  }
}

/* Straight lines bend not at all, and a sweep that is almost none by its
 * square: nothing in between underflows. */
PH_TEST(test_energy_small) {
  const struct ph_tc line = tc_of(0.3, 0.4, 0.6, 0.8);
  ck_abs(ph_tc_energy(&line), 0, 0);
  for (int i = 20; i <= 150; i += 10) {
    double sweep = pow(10, -i);
    struct ph_tc tc = tc_of(1, 0, 1, sweep);
    ck_rel(ph_tc_energy(&tc) / sweep / sweep, 4, 1e-14);
  }
}

/* What the parts bend adds up, though cut so that they use other formulas; and
 * no curve of this length turns so far with less. */
PH_TEST(test_energy_adds) {
  struct unit_random r = unit_random_of(8);
  int n = unit_count(CUBICS);
  for (int i = 0; i < n; i++) {
    struct ph_tc tc = random_tc(&r);
    double all = ph_tc_energy(&tc), turning = ph_tc_turning(&tc), sum = 0;
    double sine = fabs(sin(0.5 * turning));
    for (int k = 0; k < STEPS; k++) {
      struct ph_tc part =
          ph_tc_part(&tc, (double)k / STEPS, (double)(k + 1) / STEPS);
      sum += ph_tc_energy(&part);
    }
    /* K is the difference of products, known to eps/sin D */
    ck_rel(sum, all, 64 * DBL_EPSILON * (1 + 1 / sine));
    ck_assert_double_ge(all * ph_tc_length(&tc) * (1 + 1e-14),
                        turning * turning);
  }
}
