/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Bounds of chords of spherical curves and parallels, against dense samples. */
#include "spherical_unit.h"
#include "unit.h"

#include "curve/sample/chord_bound.h"
#include "kernel/degree.h"
#include "kernel/pi.h"
#include "kernel/s2.h"

/* Points of a chord's arc that are looked at; chords of a block: 1, 3, 9. */
enum { LOOKS = 24, SIZES = 3 };

/* Deviations are known to this. */
static const double ROUNDING = 2e-15;

/* The most of 8 (deviation) / h^2 of some chords of a block. */
static double bend_of(const struct ph_spherical *s, double d, double u0,
                      double u1) {
  double most = 0;
  for (size_t i = 0, n = 1; i < SIZES; i++, n *= 3) {
    double h = (u1 - u0) / (double)n;
    for (size_t k = 0; k < n; k++) {
      double from = u0 + (double)k * h;
      ph_vec3 a = unit_parallel(s, d, from), b = unit_parallel(s, d, from + h);
      for (size_t j = 1; j < LOOKS; j++) {
        double u = from + h * (double)j / LOOKS;
        double away =
            unit_chord_distance(unit_parallel(s, d, u), a, b) - ROUNDING;
        most = fmax(most, 8 * away / (h * h));
      }
    }
  }
  return most;
}

/* A walk of three steps of about this angle; the larger `wild`, the more it
 * turns. */
static struct ph_spherical random_segment(struct unit_random *r, double angle,
                                          double wild) {
  struct ph_spherical s;
  ph_vec3 at = ph_degree_to_unit(unit_random_in(r, -180, 180),
                                 unit_random_in(r, -80, 80));
  ph_vec3 way = ph_vec3_any_normal(at);
  for (size_t i = 0; i < 4; i++) {
    double by = angle * unit_random_in(r, 0.5, 1);
    ph_vec3 turn = ph_vec3_scale(unit_random_in(r, -wild, wild),
                                 ph_vec3_cross(at, way)),
            next;
    s.p[i] = at;
    way = ph_vec3_unit(ph_vec3_normal(ph_vec3_add(way, turn), at));
    next = ph_vec3_unit(ph_s2_exp(at, ph_vec3_scale(by, way)));
    way = ph_vec3_scale(-1, ph_vec3_unit(ph_s2_log(next, at)));
    at = next;
  }
  return s;
}

/* The bound over a block holds; true if there is one. */
static bool ck_holds(const struct ph_spherical *s, double d, double u0,
                     double u1) {
  double bound = ph_chord_bound_spherical(s, d, u0, u1);
  ck_assert(bound >= 0);
  if (isfinite(bound)) {
    double seen = bend_of(s, d, u0, u1);
    ck_assert_msg(seen <= bound * (1 + 1e-9),
                  "d %.17g, [%.17g,%.17g]: %.17g > %.17g", d, u0, u1, seen,
                  bound);
  }
  return isfinite(bound);
}

static double random_distance(struct unit_random *r) {
  return unit_random_below(r, 3) ? unit_random_in(r, -3, 3) : 0;
}

PH_TEST(test_random) {
  struct unit_random r = unit_random_of(1330);
  const double angles[] = {1e-6, 1e-3, 0.1, 0.5, 1, 2, 3.12};
  for (int i = 0; i < unit_count(2000); i++) {
    double angle = angles[(size_t)i % (COUNT(angles))];
    struct ph_spherical s = random_segment(&r, angle, unit_random_in(&r, 0, 4));
    double d = random_distance(&r);
    double h = pow(2, -unit_random_in(&r, 0, 9));
    double u0 = unit_random_in(&r, 0, 1 - h);
    if (unit_random_below(&r, 4) == 0) { /* nearly at rest */
      double by = pow(10, -unit_random_in(&r, 1, 9));
      s.p[1] = ph_s2_slerp(s.p[0], s.p[1], by);
      u0 = unit_random_below(&r, 2) ? 0 : h < 0.5 ? h : 0;
    }
    ck_holds(&s, d, u0, u0 + h);
  }
}

/* Halvings find a bound, whatever the segment and the distance. */
static void ck_halves(const struct ph_spherical *s, double d, double u0,
                      double u1, int depth) {
  if (!ck_holds(s, d, u0, u1)) {
    double middle = 0.5 * (u0 + u1);
    ck_assert_int_lt(depth, 40);
    ck_halves(s, d, u0, middle, depth + 1);
    ck_halves(s, d, middle, u1, depth + 1);
  }
}

PH_TEST(test_rest) {
  struct unit_random r = unit_random_of(1331);
  for (int i = 0; i < unit_count(60); i++) {
    struct ph_spherical s = random_segment(&r, unit_random_in(&r, 0.01, 1),
                                           unit_random_in(&r, 0, 2));
    double d = random_distance(&r);
    if (i % 3 != 1) {
      s.p[1] = s.p[0];
    }
    if (i % 3 != 0) {
      s.p[2] = s.p[3];
    }
    ck_halves(&s, d, 0, 1, 0);
    ck_assert(ck_holds(&s, 0, 0, 0x1p-10));
    ck_assert(ck_holds(&s, 0, 1 - 0x1p-10, 1));
    ck_assert(isfinite(ph_chord_bound_spherical(&s, d, 0, 0x1p-20)));
    ck_assert(isfinite(ph_chord_bound_spherical(&s, d, 1 - 0x1p-20, 1)));
  }
}

/* From rest with three points in one place: a great circle. */
PH_TEST(test_thrice) {
  const ph_vec3 a = ph_degree_to_unit(0, 0), b = ph_degree_to_unit(40, 30);
  const struct ph_spherical start = {{a, a, a, b}}, end = {{a, b, b, b}};
  for (size_t i = 0; i < 8; i++) {
    double u0 = (double)i / 8, u1 = u0 + 0.125;
    ck_assert(ck_holds(&start, 0.7, u0, u1));
    ck_assert(ck_holds(&end, -1.2, u0, u1));
  }
}

/* Great circles at one speed, their parallels: theta^2 cos d. */
PH_TEST(test_great_circle) {
  const double step = 20 * (PH_PI / 180), speed = 3 * step;
  struct ph_spherical s;
  for (size_t i = 0; i < 4; i++) {
    s.p[i] = ph_degree_to_unit(20.0 * (double)i, 0);
  }
  for (double d = -1.5; d <= 1.5; d += 0.25) {
    for (double h = 0x1p-6; h > 0x1p-14; h /= 4) {
      double bound = ph_chord_bound_spherical(&s, d, 0.3, 0.3 + h);
      double exact = speed * speed * cos(d);
      ck_assert(bound >= exact * (1 - 1e-12));
      ck_rel(bound, exact, 3 * h + 1e-12);
    }
  }
}

/* The shorter the block, the nearer the bound is to |g| times the rate at which
 * T turns: what chords leave the curve by. */
PH_TEST(test_tight) {
  struct unit_random r = unit_random_of(1332);
  const double h = 0x1p-12;
  for (int i = 0; i < unit_count(200); i++) {
    struct ph_spherical s =
        random_segment(&r, unit_random_in(&r, 0.01, 1), 0.3);
    double d = random_distance(&r) / 4, u = unit_random_in(&r, 0.1, 0.9);
    double square, turn, g, exact;
    ph_vec3 jet[4];
    ph_spherical_jet(&s, u, jet);
    square = ph_vec3_dot(jet[1], jet[1]);
    turn = ph_vec3_triple(jet[0], jet[1], jet[2]) / square;
    g = sqrt(square) * cos(d) - turn * sin(d);
    exact = fabs(g) * hypot(sqrt(square), turn);
    if (fabs(g) > 0.1 * sqrt(square)) {
      double bound = ph_chord_bound_spherical(&s, d, u - h / 2, u + h / 2);
      ck_assert(bound >= exact * (1 - 1e-9));
      ck_rel(bound, exact, 0.05);
    }
  }
}
