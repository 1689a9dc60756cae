/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Speed, length and control points of spatial PH and ATPH segments. */
#include "unit.h"
#include "segment_unit.h"

enum { SEGMENTS = 200 };

static double binomial4(size_t j) {
  static const double binomial[5] = {1, 4, 6, 4, 1};
  return binomial[j];
}

/* S0^(4-j) S1^j at u, by definition. */
static double power_at(double angle, double u, size_t j) {
  double s0 = angle > 0 ? sin(angle * (1 - u) / 2) / sin(angle / 2) : 1 - u;
  double s1 = angle > 0 ? sin(angle * u / 2) / sin(angle / 2) : u;
  return pow(s0, 4 - (double)j) * pow(s1, (double)j);
}

/* |A|^2 of PH quintics, from its Bernstein coefficients. */
PH_TEST(test_speed) {
  struct unit_random r = unit_random_of(920);
  for (size_t i = 0; i < SEGMENTS; i++) {
    struct ph_seg3 seg = unit_seg3_random(&r);
    double speed[5], u = unit_random_in(&r, 0, 1), sum = 0;
    ph_quat a;
    seg.space = ph_atph_of(0);
    a = unit_seg3_preimage(&seg, u);
    ph_seg3_speed(seg.a, speed);
    for (size_t j = 0; j < 5; j++) {
      sum += binomial4(j) * speed[j] * power_at(0, u, j);
    }
    ck_abs(sum, ph_quat_dot(a, a), 1e-13);
    ck_abs(sum, ph_vec3_abs(unit_seg3_hodograph(&seg, u)), 1e-13);
  }
}

PH_TEST(test_length) {
  struct unit_random r = unit_random_of(921);
  for (size_t i = 0; i < SEGMENTS; i++) {
    struct ph_seg3 seg = unit_seg3_random(&r);
    double sum = 0;
    for (size_t k = 0; k < unit_quad(20)->n; k++) {
      sum += unit_quad(20)->weight[k] *
             ph_vec3_abs(unit_seg3_hodograph(&seg, unit_quad(20)->node[k]));
    }
    ck_rel(ph_seg3_length(&seg.space, seg.a), sum, 1e-14);
  }
}

/* The integrals of the products of basis functions, one by one: lengths of
 * preimages with one coefficient, or two. */
PH_TEST(test_length_simple) {
  struct ph_atph quintic = ph_atph_of(0);
  const ph_quat zero = {0, 0, 0, 0}, one = {1, 0, 0, 0}, other = {0, 0, 3, 0};
  const ph_quat first[3] = {one, zero, zero}, middle[3] = {zero, one, zero};
  const ph_quat both[3] = {one, zero, one}, line[3] = {one, one, one};
  const ph_quat apart[3] = {one, other, zero};
  ck_rel(ph_seg3_length(&quintic, first), 1. / 5, 1e-15);
  ck_rel(ph_seg3_length(&quintic, middle), 2. / 15, 1e-15);
  ck_rel(ph_seg3_length(&quintic, both), 2. / 5 + 1. / 15, 1e-15);
  ck_rel(ph_seg3_length(&quintic, line), 1, 1e-15);
  ck_rel(ph_seg3_length(&quintic, apart), 1. / 5 + 9 * 2. / 15, 1e-15);
}

/* Control points are those of the integral of A i A*: their legs in the basis
 * of the space are the hodograph. */
PH_TEST(test_control_points) {
  struct unit_random r = unit_random_of(922);
  for (size_t i = 0; i < SEGMENTS; i++) {
    struct ph_seg3 seg = unit_seg3_random(&r);
    double u = unit_random_in(&r, 0, 1), angle = seg.space.angle;
    ph_vec3 p[6], sum = {0, 0, 0};
    ph_seg3_control_points(&seg.space, seg.a, seg.start, seg.end, p);
    ck_abs(unit_apart(p[0], seg.start), 0, 0);
    ck_abs(unit_apart(p[5], seg.end), 0, 0);
    for (size_t j = 0; j < 5; j++) {
      double mu = 0;
      for (size_t k = 0; k < unit_quad(20)->n; k++) {
        mu += unit_quad(20)->weight[k] *
              power_at(angle, unit_quad(20)->node[k], j);
      }
      sum = ph_vec3_along(sum, power_at(angle, u, j) / mu,
                          ph_vec3_sub(p[j + 1], p[j]));
    }
    ck_assert_double_le(unit_apart(sum, unit_seg3_hodograph(&seg, u)), 2e-13);
  }
}

/* What the integral misses the end by goes into the middle leg, all of it. */
PH_TEST(test_defect) {
  struct unit_random r = unit_random_of(923);
  for (size_t i = 0; i < SEGMENTS; i++) {
    struct ph_seg3 seg = unit_seg3_random(&r);
    ph_vec3 defect = unit_random_vec3(&r, 1), p[6], q[6];
    ph_seg3_control_points(&seg.space, seg.a, seg.start, seg.end, p);
    ph_seg3_control_points(&seg.space, seg.a, seg.start,
                           ph_vec3_add(seg.end, defect), q);
    for (size_t k = 0; k < 6; k++) {
      ph_vec3 moved = ph_vec3_sub(q[k], p[k]);
      ck_assert_double_le(
          k < 3 ? ph_vec3_abs(moved) : unit_apart(moved, defect), 1e-14);
    }
  }
}

/* Run backwards, with A(1-u) j, the points are the same ones: j i j* = -i. */
PH_TEST(test_reversal) {
  struct unit_random r = unit_random_of(924);
  const ph_quat j = {0, 0, 1, 0};
  for (size_t i = 0; i < SEGMENTS; i++) {
    struct ph_seg3 seg = unit_seg3_random(&r);
    ph_quat back[3];
    ph_vec3 p[6], q[6];
    for (size_t k = 0; k < 3; k++) {
      back[k] = ph_quat_mul(seg.a[2 - k], j);
    }
    ph_seg3_control_points(&seg.space, seg.a, seg.start, seg.end, p);
    ph_seg3_control_points(&seg.space, back, seg.end, seg.start, q);
    for (size_t k = 0; k < 6; k++) {
      ck_assert_double_le(unit_apart(p[k], q[5 - k]), 1e-14);
    }
    ck_rel(ph_seg3_length(&seg.space, back), ph_seg3_length(&seg.space, seg.a),
           1e-15);
  }
}

/* The phase of a preimage is free: A exp(x i) gives the same curve. */
PH_TEST(test_phase) {
  struct unit_random r = unit_random_of(925);
  for (size_t i = 0; i < SEGMENTS; i++) {
    struct ph_seg3 seg = unit_seg3_random(&r);
    ph_cplx e = ph_cplx_polar(unit_random_in(&r, -3, 3));
    ph_quat turned[3];
    ph_vec3 p[6], q[6];
    for (size_t k = 0; k < 3; k++) {
      turned[k] = ph_quat_turn(seg.a[k], e);
    }
    ph_seg3_control_points(&seg.space, seg.a, seg.start, seg.end, p);
    ph_seg3_control_points(&seg.space, turned, seg.start, seg.end, q);
    for (size_t k = 0; k < 6; k++) {
      ck_assert_double_le(unit_apart(p[k], q[k]), 2e-14);
    }
  }
}

/* A plane curve is the planar one: with A = Re w + Im w k the hodograph is that
 * of w^2, in the plane z = 0. */
PH_TEST(test_plane) {
  struct unit_random r = unit_random_of(926);
  for (size_t i = 0; i < SEGMENTS; i++) {
    struct ph_seg3 seg = unit_seg3_random(&r);
    double u = unit_random_in(&r, 0, 1);
    ph_cplx w, square;
    ph_vec3 hodograph;
    ph_quat a;
    for (size_t k = 0; k < 3; k++) {
      seg.a[k].v = seg.a[k].p = 0;
    }
    a = unit_seg3_preimage(&seg, u);
    w = ph_cplx_of(a.u, a.q);
    square = ph_cplx_mul(w, w);
    hodograph = ph_quat_i(a, a);
    ck_assert_double_le(
        unit_apart(hodograph, ph_vec3_of(square.re, square.im, 0)), 1e-14);
  }
}
