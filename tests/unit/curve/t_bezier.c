/* SPDX-License-Identifier: GPL-3.0-or-later */
/* ATPH curves in space as Bezier curves: how near, which parts, how long. */
#include "segment_unit.h"
#include "unit.h"
#include "curve_unit.h"
#include "tc_curve_unit.h"

#include "curve/bezier/convert.h"
#include "solve/spatial/spatial.h"

static struct ph_diag diag;
static struct unit_curve3 c;

static struct ph_curve convert(double tolerance, double *error) {
  struct ph_curve bezier;
  ck_assert_int_eq(
      ph_bezier_curve(&c.curve, tolerance, &unit_arena, &bezier, error, &diag),
      PH_OK);
  return bezier;
}

PH_TEST(test_ph) {
  struct unit_random r = unit_random_of(540);
  struct ph_curve bezier;
  double error;
  unit_curve3_random(&c, 2, false, 0.6, &r);
  bezier = convert(1e-9, &error);
  ck_assert_int_eq(memcmp(&bezier, &c.curve, sizeof bezier), 0);
  ck_abs(error, 0, 0);
}

PH_TEST(test_cubics) {
  struct unit_random r = unit_random_of(545);
  struct unit_cubics cubics;
  struct ph_curve bezier;
  double error;
  unit_cubics_random(&cubics, &r, 3, 1, ph_cplx_of(1, 2));
  ck_assert_int_eq(
      ph_bezier_curve(&cubics.curve, 1e-9, &unit_arena, &bezier, &error, &diag),
      PH_OK);
  ck_assert_int_eq(memcmp(&bezier, &cubics.curve, sizeof bezier), 0);
  ck_abs(error, 0, 0);
}

/* Knots cut the curve where the pieces do; what is said of each segment no
 * longer belongs to anything. */
PH_TEST(test_atph) {
  struct unit_random r = unit_random_of(541);
  struct ph_curve bezier;
  double error, numbers[2 * UNIT_CURVE3_MAX] = {0}, sum = 0;
  bool flags[UNIT_CURVE3_MAX] = {false};
  size_t k = 0;
  unit_curve3_random(&c, 3, true, 0.6, &r);
  c.curve.choice.tension = c.curve.choice.angles = numbers;
  c.curve.choice.shape_ok = flags;
  bezier = convert(1e-8, &error);
  ck_assert_double_le(error, 1e-8);
  ck_assert_int_eq(bezier.kind, PH_CURVE_BEZIER);
  ck_assert_uint_eq(bezier.dimension, 3);
  ck_assert_uint_eq(bezier.degree, 5);
  ck_assert_uint_gt(bezier.n, 3);
  ck_assert_ptr_null(bezier.preimage.alpha);
  ck_assert_ptr_null(bezier.preimage.v);
  ck_assert_ptr_null(bezier.choice.tension);
  ck_assert_ptr_null(bezier.choice.angles);
  ck_assert_ptr_null(bezier.choice.shape_ok);
  ck_rel(bezier.length, c.curve.length, 0);
  ck_rel(bezier.knots[bezier.n], c.knots[3], 0);
  for (size_t i = 0; i < bezier.n; i++) {
    const double *knot = bezier.knots + i, *p = bezier.control_points + 18 * i;
    const double middle = 0.5 * (knot[0] + knot[1]);
    ck_assert(knot[0] < knot[1]);
    k += middle > c.knots[k + 1];
    ck_assert_double_le(
        unit_apart(
            unit_bezier3(p, 5, 0, 0.5),
            unit_curve3_point(&c.curve, k, (middle - c.knots[k]) / c.alpha[k])),
        1e-8);
    sum += bezier.lengths[i];
  }
  ck_rel(sum, c.curve.length, 1e-14);
}

/* The length of a piece by quadrature of its speed, which is near. */
PH_TEST(test_lengths) {
  struct unit_random r = unit_random_of(542);
  struct ph_curve bezier;
  struct ph_quad rule;
  double error;
  ck_assert(ph_quad_gauss(&rule, 12));
  unit_curve3_random(&c, 2, true, 0.6, &r);
  bezier = convert(1e-9, &error);
  for (size_t i = 0; i < bezier.n; i++) {
    double sum = 0;
    for (size_t j = 0; j < rule.n; j++) {
      sum += rule.weight[j] *
             ph_vec3_abs(unit_bezier3(bezier.control_points + 18 * i, 5, 1,
                                      rule.node[j]));
    }
    ck_abs(bezier.lengths[i], sum, 1e-8);
  }
}

/* One piece for a unit segment with unit end derivatives: the error is that of
 * the reference implementation for such data, and grows as alpha^2. */
PH_TEST_EACH(test_one_piece, 4) {
  static const struct {
    double alpha, error;
  } known[] = {{0.1, 1.8e-5}, {0.5, 4.4e-4}, {1, 1.8e-3}, {2.0943951, 9.2e-3}};
  const double alpha = known[_i].alpha;
  const struct ph_spatial_data data = {
      {1, 0, 0}, {0.8, 0.6, 0}, {0.8, 0, 0.6}, 1, 1, 0, 0, {0, 0, 0}};
  const struct ph_atph space = ph_atph_of(alpha);
  const struct ph_spatial_family family = ph_spatial_family_of(&data, &space);
  ph_quat a[3];
  struct ph_curve bezier;
  double error;
  ph_spatial_preimage(&family, ph_spatial_cc(&family), a);
  unit_curve3_of(&c, 1, &alpha, a, ph_vec3_of(0, 0, 0));
  bezier = convert(1, &error);
  ck_assert_uint_eq(bezier.n, 1);
  ck_rel(error, known[_i].error, 0.2);
}

/* Parts of one segment: 2^-6 of the error for each halving. */
PH_TEST(test_order) {
  const ph_quat a[3] = {{1, 0.1, 0, 0.2}, {0.9, 0, 0.5, 0}, {1, 0.2, 0, -0.4}};
  const double alpha = 2;
  struct ph_seg3 seg;
  struct ph_quad rule;
  double before = 0;
  ck_assert(ph_quad_gauss(&rule, 12));
  unit_curve3_of(&c, 1, &alpha, a, ph_vec3_of(0, 0, 0));
  seg = ph_seg3_of(&c.curve, 0);
  for (int i = 1; i <= 4; i++) {
    struct ph_seg3 part = unit_seg3_part(&seg, &rule, 0.3, 0.3 + ldexp(1, -i));
    double error;
    unit_curve3_of(&c, 1, &part.space.angle, part.a, part.start);
    ck_assert_uint_eq(convert(1, &error).n, 1);
    if (i > 1) {
      ck_rel(before / error, 64, 0.25);
    }
    before = error;
  }
}

PH_TEST(test_refused) {
  struct unit_random r = unit_random_of(543);
  struct ph_curve bezier;
  double error;
  unit_curve3_random(&c, 1, true, 0.6, &r);
  ck_assert_int_eq(
      ph_bezier_curve(&c.curve, 1e-30, &unit_arena, &bezier, &error, &diag),
      PH_E_NO_CONVERGENCE);
  ck_assert_str_eq(diag.field, "tolerance");
}
