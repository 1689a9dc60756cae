/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * G1 interpolation by one Tschirnhausen cubic: examples of the thesis, all
 * solutions against a search along D, and their number against both.
 */
#include "unit.h"
#include "tc_curve_unit.h"
#include "tc_unit.h"

#include "solve/tc/tc.h"

static size_t solve(double a, double b, struct ph_tc_fit fits[2]) {
  struct ph_tc_hermite h = unit_tc_data(a, 1, b, 1);
  return ph_tc_g1(&h, fits);
}

static struct unit_tc_count count_fits(const struct ph_tc_fit *fits, size_t n) {
  struct unit_tc_count count = {0, 0};
  for (size_t i = 0; i < n; i++) {
    count.with_loop += fits[i].loops;
    count.without_loop += 1 - fits[i].loops;
  }
  return count;
}

static void ck_count(double a, double b, struct unit_tc_count found,
                     struct unit_tc_count wanted) {
  ck_assert_msg(found.without_loop == wanted.without_loop &&
                    found.with_loop == wanted.with_loop,
                "angles %.17g, %.17g: %u without and %u with a loop, not %u "
                "and %u",
                a, b, found.without_loop, found.with_loop, wanted.without_loop,
                wanted.with_loop);
}

/* ---- examples ------------------------------------------------------------ */

struct known_fit {
  double size; /* |D| */
  double length, energy;
};

#define ROW(a, b, chord, n, loops, ...) \
  {                                     \
    a, b, chord, n, loops, {            \
      __VA_ARGS__                       \
    }                                   \
  }

/* [BYR11, examples 1 to 3, table 4.1]; the energies are ours. */
static const struct {
  double a, b, chord;
  size_t n, loops; /* the last ones have loops */
  struct known_fit fits[2];
} KNOWN[] = {
    ROW(-PH_PI / 4, PH_PI / 4, 6, 2, 1,
        {1, 6.727922061357855, 0.3699971383413053},
        {1, 18.727922061357855, 3.5648223355906916}),
    ROW(-PH_PI / 12, -7 * PH_PI / 10, 6, 2, 0,
        {0.7221794073105794, 15.957313902630892, 2.8141746981582116},
        {0.4429895540911155, 8.071605787816384, 10.675595359701827}),
    ROW(-5 * PH_PI / 6, -PH_PI / 12, 6, 1, 0,
        {3.2331316184946672, 6.958312232857506, 15.483312717359647}),
    ROW(-1, 0, 1, 1, 1,
        {1.7551651237807455, 1.2209442829929322, 281.13552763699374}),
    ROW(-0.7, PH_PI, 1, 1, 0,
        {0.6857956149109027, 2.3318751166118568, 11.33411389039291}),
    ROW(0, 1.5, 1, 1, 1,
        {0.683350562336113, 1.8140899135512605, 50.258408337238215}),
    ROW(0, 5 - 2 * PH_PI, 1, 1, 1,
        {0.6241078257344089, 1.457045030259654, 104.89711620012109}),
    ROW(-PH_PI, 0.8, 1, 1, 0,
        {1.2839662277738915, 3.312783013294853, 8.010591084193905}),
    ROW(-PH_PI, 5.6 - 2 * PH_PI, 1, 1, 0,
        {1.4925901103286716, 2.221672233349834, 11.958728355556726}),
    ROW(-2.2, 0, 1, 0, 0, {0, 0, 0}),
    ROW(-1.2, PH_PI, 1, 0, 0, {0, 0, 0}),
    ROW(0, 3, 1, 0, 0, {0, 0, 0}),
    ROW(-PH_PI, 2, 1, 0, 0, {0, 0, 0}),
    ROW(-11 * PH_PI / 12, 3 * PH_PI / 5, 6.0827625302982193, 0, 0, {0, 0, 0}),
};

PH_TEST_EACH(test_known, COUNT(KNOWN)) {
  struct ph_tc_fit fits[2];
  double a = KNOWN[_i].a, b = KNOWN[_i].b, chord = KNOWN[_i].chord;
  struct unit_tc_count wanted = {(unsigned)(KNOWN[_i].n - KNOWN[_i].loops),
                                 (unsigned)KNOWN[_i].loops};
  size_t n = solve(a, b, fits);
  ck_assert_uint_eq(n, KNOWN[_i].n);
  ck_count(a, b, count_fits(fits, n), wanted);
  ck_count(a, b, unit_tc_count_by_angles(a, b), wanted);
  for (size_t i = 0; i < n; i++) {
    const struct known_fit *k = &KNOWN[_i].fits[i];
    ck_rel(fabs(fits[i].ratio), k->size, 1e-12);
    ck_rel(fits[i].length * chord, k->length, 1e-12);
    ck_rel(fits[i].energy / chord, k->energy, 1e-11);
    ck_assert_int_eq(fits[i].root,
                     fits[i].ratio > 0 ? PH_ROOT_PLUS : PH_ROOT_MINUS);
    ck_assert(fits[i].simple == (fits[i].loops == 0));
  }
}

/* Tangents along the chord: a line if both are forward. */
PH_TEST(test_straight) {
  struct ph_tc_fit fits[2];
  ck_assert_uint_eq(solve(0, 0, fits), 1);
  ck_assert_int_eq(fits[0].root, PH_ROOT_STRAIGHT);
  ck_assert(fits[0].simple && fits[0].regular);
  ck_abs(fits[0].ratio, 1, 0);
  ck_rel(fits[0].length, 1, DBL_EPSILON);
  ck_abs(fits[0].energy, 0, 0);
  ck_assert_uint_eq(unit_tc_count_by_angles(0, 0).without_loop, 1);
  ck_assert_uint_eq(unit_tc_count_by_angles(0, 0).with_loop, 0);
  for (int i = 1; i < 9; i++) {
    double a = (i % 3 - 1) * PH_PI, b = (i / 3 - 1) * PH_PI;
    struct unit_tc_count none = {0, 0};
    if (fabs(a) > 0 || fabs(b) > 0) {
      ck_assert_uint_eq(solve(a, b, fits), 0);
      ck_count(a, b, unit_tc_count_by_angles(a, b), none);
      a -= copysign(1e-15, a);
      b -= copysign(1e-15, b);
      ck_assert_uint_eq(solve(a, b, fits), 0);
      ck_count(a, b, unit_tc_count_by_angles(a, b), none);
    }
  }
}

/* ---- borders ------------------------------------------------------------- */

/* One tangent along the chord: what is printed for D and G, up to the angles
 * where G = 0. */
PH_TEST_EACH(test_along, 4) {
  static const double near[] = {-1, -1e-3, -1e-9, 1e-9, 1e-3, 1};
  const bool backward = _i & 1, first = _i & 2;
  const double border = backward ? PH_PI / 3 : 2 * PH_PI / 3;
  const double along = backward ? PH_PI : 0;
  struct ph_tc_fit fits[2];
  for (size_t i = 0; i < 12; i++) {
    double angle = (border + near[i % 6]) * (i < 6 ? 1 : -1);
    double a = first ? along : angle, b = first ? angle : along;
    size_t n = solve(a, b, fits);
    double size = 2 * fabs(backward ? sin(angle / 2) : cos(angle / 2));
    double legs = 2 * cos(angle) + (backward ? -1 : 1); /* G, or G/D^2 */
    struct unit_tc_count wanted = {backward, !backward};
    if (near[i % 6] > 0) {
      wanted.with_loop = wanted.without_loop = 0;
    }
    ck_count(a, b, count_fits(fits, n), wanted);
    ck_count(a, b, unit_tc_count_by_angles(a, b), wanted);
    if (n > 0) {
      ph_cplx end = unit_tc_end(&fits[0], first);
      ck_rel(fabs(fits[0].ratio), first ? 1 / size : size, 1e-14);
      ck_rel(3 / ph_cplx_abs(end), legs, 1e-6); /* near 0, at 1e-9 */
      ck_assert(!backward || fits[0].ratio > 0);
    }
  }
  /* closed curves are none */
  ck_assert_uint_eq(
      first ? solve(along, border, fits) : solve(border, along, fits), 0);
}

/* The tangents 1e-15 off the chord are along it, those 1e-13 off are not. */
PH_TEST(test_snap) {
  struct ph_tc_fit fits[2], snapped[2];
  for (int i = 0; i < 4; i++) {
    double along = i & 1 ? PH_PI : 0, off = i & 2 ? 1e-15 : -1e-15;
    double a = along - (along > 0 ? fabs(off) : off);
    ck_assert_uint_eq(solve(a, 0.5, snapped), solve(along, 0.5, fits));
    ck_assert_uint_eq(count_fits(fits, 1).with_loop, along > 0 ? 0 : 1);
    ck_abs(unit_tc_apart(&snapped[0], false, false, &fits[0]), 0, 0);
    ck_count(a, 0.5, unit_tc_count_by_angles(a, 0.5),
             unit_tc_count_by_angles(along, 0.5));
    ck_count(0.5, a, unit_tc_count_by_angles(0.5, a),
             unit_tc_count_by_angles(0.5, along));
  }
  ck_assert_uint_eq(solve(-1e-13, 0.5, fits), 2);
  ck_assert(!fits[1].regular && !fits[1].simple);
  ck_assert(fits[0].regular && fits[0].loops == 1);
}

/* Along the border of existence, the two solutions are one: two nearer the
 * chord, none beyond. */
PH_TEST(test_double_root) {
  for (int i = 1; i < 100; i++) {
    double d = i * PH_PI / 300, p = asin(2 * sin(d) / sqrt(3));
    struct ph_tc_fit fits[2];
    ck_assert_uint_eq(solve(p - d, p + d, fits), 1);
    ck_abs(unit_tc_miss(&fits[0]), 0, 1e-14);
    ck_assert_uint_eq(solve(p + d, p - d, fits), 1);
    ck_assert_uint_eq(solve(p - d + 1e-6 * d, p + d + 1e-6 * d, fits), 0);
    p *= 1 - 1e-8;
    ck_assert_uint_eq(solve(p - d, p + d, fits), 2);
    ck_count(p - d, p + d, unit_tc_count_by_angles(p - d, p + d),
             count_fits(fits, 2));
  }
}

/* Tangents 2 pi/3 apart: only one of the two solutions is not closed. */
PH_TEST(test_sixty_degrees) {
  struct ph_tc_fit fits[2];
  for (int i = -60; i < 60; i++) {
    double p = (i + 0.5) * PH_PI / 60, d = PH_PI / 3;
    size_t n = solve(p - d, p + d, fits);
    struct unit_tc_count wanted = {fabs(p) < PH_PI / 2, 0};
    ck_count(p - d, p + d, count_fits(fits, n), wanted);
    ck_assert(n == 0 || unit_tc_miss(&fits[0]) <= 1e-15);
  }
}

/* ---- number -------------------------------------------------------------- */

/* Whether the open polygon p[n] crosses itself. */
static bool polygon_crosses(const ph_cplx *p, size_t n) {
  for (size_t i = 0; i + 1 < n; i++) {
    ph_cplx u = ph_cplx_sub(p[i + 1], p[i]);
    for (size_t j = i + 2; j + 1 < n; j++) {
      ph_cplx v = ph_cplx_sub(p[j + 1], p[j]), w = ph_cplx_sub(p[j], p[i]);
      double k = ph_cplx_cross(u, v), s = ph_cplx_cross(w, v) / k;
      double t = ph_cplx_cross(w, u) / k;
      if (s >= 0 && s <= 1 && t >= 0 && t <= 1) {
        return true;
      }
    }
  }
  return false;
}

enum { CORNERS = 64 };

/* Whether a cubic crosses itself: as a polygon, at equal angles of w. */
static bool crosses(ph_cplx w0, ph_cplx w1) {
  struct ph_tc tc = {{w0, w1}};
  ph_cplx p[CORNERS + 1];
  double sweep = atan2(ph_cplx_cross(w0, w1), ph_cplx_dot(w0, w1));
  double from = ph_cplx_abs(w0), to = ph_cplx_abs(w1);
  for (int i = 0; i <= CORNERS; i++) {
    double angle = sweep * i / CORNERS, x = from * sin(angle);
    p[i] = unit_tc_at(&tc, x / (x + to * sin(sweep - angle)));
  }
  return polygon_crosses(p, CORNERS + 1);
}

/* 3 (r(1) - r(0)) of the preimages e^(ia/2), D e^(ib/2). */
static ph_cplx leg_of(ph_cplx w0, ph_cplx unit, double root) {
  ph_cplx w1 = ph_cplx_scale(root, unit);
  return ph_cplx_add(ph_cplx_mul(w0, ph_cplx_add(w0, w1)), ph_cplx_mul(w1, w1));
}

/* All D at which that is along the chord and forward, by its sign beside the
 * chord at |D| = e^-9 to e^9; whether they cross themselves, by a polygon. */
static struct unit_tc_count search(double a, double b, int steps) {
  struct unit_tc_count count = {0, 0};
  ph_cplx u = ph_cplx_polar(a / 2), v = ph_cplx_polar(b / 2);
  const double factor = exp(18.0 / steps);
  for (int sign = -1; sign <= 1; sign += 2) {
    double root = sign * exp(-9);
    ph_cplx last = leg_of(u, v, root);
    for (int i = 0; i < steps; i++, root *= factor) {
      ph_cplx next = leg_of(u, v, root * factor);
      if ((last.im > 0) != (next.im > 0) && last.re + next.re > 0) {
        double part = last.im / (last.im - next.im);
        double at = root * (1 + part * (factor - 1));
        bool loop = crosses(u, ph_cplx_scale(at, v));
        count.with_loop += loop;
        count.without_loop += !loop;
      }
      last = next;
    }
  }
  return count;
}

/* A search on a grid that is on no border. */
PH_TEST(test_search) {
  const int n = 42, steps = unit_count(3000);
  for (int i = 0; i < n; i++) {
    for (int j = 0; j < n; j++) {
      double a = ((i + 0.51) / n * 2 - 1) * PH_PI;
      double b = ((j + 0.53) / n * 2 - 1) * PH_PI;
      ck_count(a, b, unit_tc_count_by_angles(a, b), search(a, b, steps));
    }
  }
}

/* What is solved has the number that the angles say; on a grid with angles 0
 * and pi, and with others near them. */
PH_TEST(test_count) {
  const int n = unit_count(200);
  struct ph_tc_fit fits[2];
  for (int i = -n; i <= n; i++) {
    double a = i * PH_PI / n;
    for (int j = -n; j <= n; j++) {
      double b = j * PH_PI / n;
      ck_count(a, b, count_fits(fits, solve(a, b, fits)),
               unit_tc_count_by_angles(a, b));
    }
  }
}

PH_TEST(test_count_near_chord) {
  struct ph_tc_fit fits[2];
  for (int k = 0; k < 48; k++) {
    double off = pow(10, -1 - k / 4) * (k & 1 ? 1 : -1);
    double a = k & 2 ? copysign(PH_PI, off) - off : off;
    for (int j = -50; j <= 50; j++) {
      double b = (j + 0.3) * PH_PI / 51;
      ck_count(a, b, count_fits(fits, solve(a, b, fits)),
               unit_tc_count_by_angles(a, b));
      ck_count(b, a, count_fits(fits, solve(b, a, fits)),
               unit_tc_count_by_angles(b, a));
    }
  }
}

/* Of b or b + a turn or b - a turn, whether it is in a range. */
static bool is_in(double b, const double range[2]) {
  return (b > range[0] && b < range[1]) ||
         (b + 2 * PH_PI > range[0] && b + 2 * PH_PI < range[1]) ||
         (b - 2 * PH_PI > range[0] && b - 2 * PH_PI < range[1]);
}

PH_TEST(test_range) {
  const int n = unit_count(200);
  for (int i = -n; i <= n; i++) {
    double a = i * PH_PI / n, range[2];
    ph_tc_g1_range(a, range);
    ck_assert(range[0] < 0 && range[1] > 0 && range[1] - range[0] < 2 * PH_PI);
    for (int j = -n; j < n; j++) {
      double b = (j + 0.37) * PH_PI / n;
      struct unit_tc_count count = unit_tc_count_by_angles(a, b);
      ck_assert_msg(is_in(b, range) ==
                        (count.with_loop + count.without_loop > 0),
                    "angles %.17g, %.17g", a, b);
    }
  }
}

/* Just inside and just beyond both ends. */
PH_TEST(test_range_ends) {
  const int n = unit_count(3000);
  for (int i = -n; i <= n; i++) {
    double a = i * PH_PI / n, range[2];
    ph_tc_g1_range(a, range);
    for (int k = 0; k < 4; k++) {
      double b = remainder(range[k / 2] + (k & 1 ? 1e-9 : -1e-9), 2 * PH_PI);
      struct unit_tc_count count = unit_tc_count_by_angles(a, b);
      ck_assert_msg((k == 1 || k == 2) ==
                        (count.with_loop + count.without_loop > 0),
                    "angles %.17g, %.17g", a, b);
    }
  }
}

/* The angle 0 in the middle of a range. */
PH_TEST(test_range_zero) {
  struct ph_tc_fit fits[2];
  for (int i = -100; i <= 100; i++) {
    double a = i * PH_PI / 100;
    size_t n = solve(a, 0, fits);
    ck_assert_uint_eq(n, fabs(a) < 2 * PH_PI / 3);
    ck_assert(n == 0 || (fits[0].loops == 1) == (i != 0));
  }
}

/* ---- solutions ----------------------------------------------------------- */

/* Tangents in all directions, some of them near the chord. */
static double random_angle(struct unit_random *r) {
  double angle = unit_random_in(r, -PH_PI, PH_PI);
  switch (unit_random_below(r, 4)) {
  case 0:
    return angle * pow(10, -unit_random_in(r, 0, 10));
  case 1:
    return copysign(PH_PI, angle) - angle * pow(10, -unit_random_in(r, 1, 10));
  default:
    return angle;
  }
}

PH_TEST(test_residual) {
  struct unit_random r = unit_random_of(1);
  double worst = 0, turned = 0;
  for (int i = 0; i < unit_count(20000); i++) {
    double a = random_angle(&r), b = random_angle(&r);
    struct ph_tc_hermite h = unit_tc_data(a, 1, b, 1);
    struct ph_tc_fit fits[2];
    size_t n = ph_tc_g1(&h, fits);
    for (size_t j = 0; j < n; j++) {
      worst = unit_larger(worst, unit_tc_miss(&fits[j]));
      for (size_t k = 0; k < 2; k++) {
        ph_cplx t = unit_tc_end(&fits[j], k);
        t = ph_cplx_scale(1 / ph_cplx_abs(t), t);
        turned = unit_larger(turned, unit_distance(t, h.t[k]));
      }
    }
  }
  ck_assert_msg(worst <= 4e-15, "seed %lu: %.3g", unit_seed(), worst);
  ck_assert_msg(turned <= 1e-15, "seed %lu: %.3g", unit_seed(), turned);
}

/* A cubic is among the solutions for its own tangents. */
PH_TEST(test_own) {
  struct unit_random r = unit_random_of(2);
  for (int i = 0; i < unit_count(5000); i++) {
    ph_cplx first = unit_random_cplx(&r, 1);
    struct ph_tc tc = {{first, unit_random_cplx(&r, 1)}};
    ph_cplx over = ph_cplx_inverse(ph_tc_leg(&tc));
    struct ph_tc_fit own = {.tc = {tc}, .n = 1}, fits[2];
    struct ph_tc_hermite h;
    double apart = 1;
    size_t n;
    for (size_t j = 0; j < 2; j++) {
      ph_cplx t = ph_cplx_mul(unit_tc_end(&own, j), over);
      h.t[j] = ph_tc_snap(ph_cplx_scale(1 / ph_cplx_abs(t), t));
      own.tc[0].w[j] = ph_cplx_mul(tc.w[j], ph_cplx_sqrt(over));
    }
    n = ph_tc_g1(&h, fits);
    for (size_t j = 0; j < n; j++) {
      double d = unit_tc_apart(&fits[j], false, false, &own);
      apart = d < apart ? d : apart;
    }
    ck_assert_msg(apart <= 1e-6, "seed %lu, %d: %.3g", unit_seed(), i, apart);
  }
}

/* What differs by a rounding of the data, near a border. */
#define SENSITIVE 1e-7

/* From the other end and in a mirror: the same curves in the same order. */
PH_TEST(test_seen) {
  struct unit_random r = unit_random_of(3);
  for (int i = 0; i < unit_count(5000); i++) {
    double a = unit_random_in(&r, -PH_PI, PH_PI);
    double b = unit_random_in(&r, -PH_PI, PH_PI);
    struct ph_tc_hermite h, seen;
    struct ph_tc_fit fits[2], others[2];
    size_t n;
    a = i % 5 == 0 ? PH_PI : a;
    b = i % 5 == 1 ? PH_PI : b;
    h = unit_tc_data(a, 1, b, 1);
    n = ph_tc_g1(&h, fits);
    seen = unit_tc_reversed(h);
    ck_assert_uint_eq(ph_tc_g1(&seen, others), n);
    for (size_t j = 0; j < n; j++) {
      ck_abs(unit_tc_apart(&others[j], true, false, &fits[j]), 0, SENSITIVE);
      ck_rel(others[j].ratio, 1 / fits[j].ratio, SENSITIVE);
      ck_assert_int_eq(others[j].root, fits[j].root);
    }
    seen = unit_tc_mirrored(h);
    ck_assert_uint_eq(ph_tc_g1(&seen, others), n);
    for (size_t j = 0; j < n; j++) {
      ck_abs(unit_tc_apart(&others[j], false, true, &fits[j]), 0, 0);
      ck_rel(others[j].ratio, fits[j].ratio, 0);
      ck_assert_int_eq(others[j].root, fits[j].root);
    }
  }
}

/* No loop comes first; of two alike the one that bends less, which is the one
 * with |D| nearer to 1. */
PH_TEST(test_order) {
  struct unit_random r = unit_random_of(4);
  int alike = 0;
  for (int i = 0; i < unit_count(20000); i++) {
    struct ph_tc_fit f[2];
    double a = unit_random_in(&r, -PH_PI, PH_PI);
    double b = unit_random_in(&r, -PH_PI, PH_PI);
    if (solve(a, b, f) == 2) {
      ck_assert(f[0].regular >= f[1].regular && f[0].loops <= f[1].loops);
      if (f[0].loops == f[1].loops) {
        ck_assert(f[0].energy <= f[1].energy);
        ck_assert(fabs(log(fabs(f[0].ratio))) <= fabs(log(fabs(f[1].ratio))));
        alike++;
      }
    }
  }
  ck_assert_int_gt(alike, 0);
}
