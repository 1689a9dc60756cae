/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Fairness of planar splines: against quadrature that spares no node. */
#include "unit.h"
#include "seg2_unit.h"
#include "tc_curve_unit.h"

#include "curve/energy.h"
#include "curve/tc.h"

#include <float.h>

enum { SEGMENTS = 60, PANELS = 400 };

static const double PI = 3.14159265358979323846;

static struct ph_quad rule;

static void begin(void) {
  ck_assert(ph_quad_gauss(&rule, 20));
}

/* Curves that do not nearly stand still: their panels are enough. */
static bool is_slow(const struct ph_seg2 *seg) {
  for (size_t i = 0; i <= 50; i++) {
    if (ph_seg2_bend(seg, (double)i / 50).speed < 0.05) {
      return true;
    }
  }
  return false;
}

static struct ph_seg2 random_segment(struct unit_random *r) {
  struct ph_seg2 seg = unit_seg2_random(r);
  for (size_t i = 0; i < 100 && is_slow(&seg); i++) {
    seg = unit_seg2_random(r);
  }
  ck_assert(!is_slow(&seg));
  return seg;
}

static struct ph_energy direct(const struct ph_seg2 *seg) {
  struct ph_energy e = {0};
  for (size_t i = 0; i < PANELS; i++) {
    for (size_t j = 0; j < rule.n; j++) {
      struct ph_bend bend =
          ph_seg2_bend(seg, ((double)i + rule.node[j]) / PANELS);
      double weight = rule.weight[j] / PANELS;
      e.bending += weight * pow(bend.curvature, 2) * bend.speed;
      e.varying += weight * pow(bend.slope, 2) / bend.speed;
    }
  }
  return e;
}

static struct ph_energy energy_of(const struct ph_seg2 *seg, size_t n) {
  struct unit_segments s;
  struct ph_energy energy;
  unit_seg2_curve(seg, n, &s);
  ck_assert(ph_energy_planar(&s.curve, &energy));
  return energy;
}

START_TEST(test_quadrature) {
  struct unit_random r = unit_random_of(520);
  for (size_t n = 0; n < SEGMENTS; n++) {
    struct ph_seg2 seg = random_segment(&r);
    struct ph_energy wanted = direct(&seg), found = energy_of(&seg, 1);
    double absolute, rotation = ph_seg2_rotation(&seg, &absolute);
    ck_rel(found.bending, wanted.bending, 2e-12);
    ck_rel(found.varying, wanted.varying, 2e-12);
    ck_abs(found.rotation, rotation / (2 * PI), 1e-14);
    ck_abs(found.absolute_rotation, absolute / (2 * PI), 1e-14);
  }
}
END_TEST

/* Segments add up, and so do parts. */
START_TEST(test_sum) {
  struct unit_random r = unit_random_of(521);
  for (size_t n = 0; n < SEGMENTS; n++) {
    struct ph_seg2 seg = random_segment(&r), part[3];
    struct ph_energy whole, parts;
    for (size_t i = 0; i < 3; i++) {
      const double at[] = {0, 0.3, 0.55, 1};
      part[i] = ph_seg2_part(&seg, &rule, at[i], at[i + 1]);
    }
    whole = energy_of(&seg, 1);
    parts = energy_of(part, 3);
    ck_rel(parts.bending, whole.bending, 1e-11);
    ck_rel(parts.varying, whole.varying, 1e-11);
    ck_abs(parts.rotation, whole.rotation, 1e-12);
    ck_abs(parts.absolute_rotation, whole.absolute_rotation, 1e-12);
  }
}
END_TEST

/* A number, or none where it is out of range. */
static void check_scaled(double found, double one, int exponent) {
  double wanted = ldexp(one, exponent);
  if (wanted >= DBL_MIN && isfinite(wanted)) {
    ck_rel(found, wanted, 1e-12);
  } else {
    ck_assert(!isfinite(found));
  }
}

/* A curve s times as large has E / s and MV / s^3, and the same IES and IMV; s
 * is a power of two, and its root too. */
START_TEST(test_scale) {
  struct unit_random r = unit_random_of(522);
  for (int exponent = -504; exponent <= 504; exponent += 8) {
    struct ph_seg2 seg = random_segment(&r);
    struct ph_energy one = energy_of(&seg, 1), other;
    ph_cplx w[3];
    for (size_t i = 0; i < 3; i++) {
      w[i] = ph_cplx_scale(ldexp(1, exponent), seg.w[i]);
    }
    seg = unit_seg2(seg.space.angle, w);
    other = energy_of(&seg, 1);
    check_scaled(other.bending, one.bending, -2 * exponent);
    check_scaled(other.varying, one.varying, -6 * exponent);
    ck_rel(other.ies, one.ies, 1e-12);
    ck_rel(other.imv, one.imv, 1e-12);
    ck_rel(other.rotation, one.rotation, 1e-14);
  }
}
END_TEST

/* w = e^(it), t in [-a/2,a/2]: an arc of radius 1/2 by t, that turns by 2 a. */
START_TEST(test_circle) {
  for (double a = 0.125; a < 3; a += 0.25) {
    const double root = sqrt(a);
    ph_cplx w[3] = {ph_cplx_scale(root, ph_cplx_polar(-a / 2)),
                    ph_cplx_of(root / cos(a / 2), 0),
                    ph_cplx_scale(root, ph_cplx_polar(a / 2))};
    struct ph_seg2 seg = unit_seg2(a, w);
    struct ph_energy e = energy_of(&seg, 1);
    ck_rel(e.bending, 4 * a, 1e-12);
    ck_abs(e.varying, 0, 1e-20);
    ck_rel(e.rotation, a / PI, 1e-14);
    ck_rel(e.absolute_rotation, a / PI, 1e-14);
  }
}
END_TEST

/* A line bends nowhere. */
START_TEST(test_line) {
  for (int atph = 0; atph < 2; atph++) {
    const ph_cplx w[3] = {{1, 2}, {2, 4}, {0.5, 1}};
    struct ph_seg2 seg = unit_seg2(atph, w);
    struct ph_energy e = energy_of(&seg, 1);
    ck_abs(e.bending, 0, 1e-25);
    ck_abs(e.varying, 0, 1e-25);
    ck_abs(e.absolute_rotation, 0, 1e-15);
  }
}
END_TEST

/* (integral of |kappa|)^2 <= E L, by Cauchy and Schwarz. */
START_TEST(test_bound) {
  struct unit_random r = unit_random_of(523);
  for (size_t n = 0; n < SEGMENTS; n++) {
    struct ph_seg2 seg = random_segment(&r);
    struct ph_energy e = energy_of(&seg, 1);
    double length = 0;
    for (size_t j = 0; j < rule.n; j++) {
      length += rule.weight[j] * ph_seg2_bend(&seg, rule.node[j]).speed;
    }
    ck_assert_double_ge(e.bending * length * (1 + 1e-12),
                        pow(2 * PI * e.absolute_rotation, 2));
  }
}
END_TEST

/* Of cubics both are known in closed form. */
START_TEST(test_cubics) {
  const double scales[] = {1, 1e-9, 1e9};
  struct unit_random r = unit_random_of(524);
  for (size_t n = 0; n < SEGMENTS; n++) {
    const double scale = scales[n % 3];
    struct unit_cubics c;
    struct ph_energy found;
    double bending = 0, turned = 0, absolute = 0;
    unit_cubics_random(&c, &r, 3, scale, unit_random_cplx(&r, scale));
    for (size_t k = 0; k < 3; k++) {
      const double *w = c.preimage + 4 * k;
      const struct ph_tc tc = {{{w[0], w[1]}, {w[2], w[3]}}};
      bending += ph_tc_energy(&tc);
      turned += ph_tc_turning(&tc);
      absolute += fabs(ph_tc_turning(&tc));
    }
    ck_assert(ph_energy_planar(&c.curve, &found));
    ck_rel(found.bending, bending, 1e-12);
    ck_abs(2 * PI * found.rotation, turned, 1e-14);
    ck_abs(2 * PI * found.absolute_rotation, absolute, 1e-14);
  }
}
END_TEST

static Suite *suite(void) {
  Suite *s = suite_create("energy");
  TCase *t = tcase_create("energy");
  tcase_add_checked_fixture(t, begin, NULL);
  tcase_add_test(t, test_quadrature);
  tcase_add_test(t, test_sum);
  tcase_add_test(t, test_scale);
  tcase_add_test(t, test_circle);
  tcase_add_test(t, test_line);
  tcase_add_test(t, test_bound);
  tcase_add_test(t, test_cubics);
  suite_add_tcase(s, t);
  return s;
}

PH_TEST_MAIN(suite)
