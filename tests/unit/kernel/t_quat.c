/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Vectors and quaternions: the multiplication table is the reference. */
#include "unit.h"
#include "spatial_unit.h"

static const ph_quat I = {0, 1, 0, 0}, J = {0, 0, 1, 0}, K = {0, 0, 0, 1};

static ph_vec3 random_vec3(struct unit_random *r) {
  return ph_vec3_scale(unit_random_in(r, 0.1, 3), unit_random_direction(r));
}

static ph_quat random_quat(struct unit_random *r) {
  return ph_quat_scale(unit_random_in(r, 0.1, 3), unit_random_turn(r));
}

static void ck_quat(ph_quat found, ph_quat wanted, double tol) {
  ck_abs(found.u, wanted.u, tol);
  ck_vec3(ph_quat_vector(found), ph_quat_vector(wanted), tol);
}

/* ---- vectors -------------------------------------------------------- */

PH_TEST(test_vec3) {
  struct unit_random r = unit_random_of(301);
  for (int i = 0; i < unit_count(2000); i++) {
    ph_vec3 a = random_vec3(&r), b = random_vec3(&r), c = random_vec3(&r);
    double s = unit_random_in(&r, -3, 3), tol = 64 * DBL_EPSILON;
    ph_vec3 ab = ph_vec3_cross(a, b);
    ck_vec3(ph_vec3_sub(ph_vec3_add(a, b), b), a, tol);
    ck_vec3(ph_vec3_along(a, s, b), ph_vec3_add(a, ph_vec3_scale(s, b)), tol);
    ck_abs(ph_vec3_dot(ab, a), 0, tol * 10);
    ck_abs(ph_vec3_dot(ab, b), 0, tol * 10);
    /* Lagrange: |a x b|^2 + (a.b)^2 = |a|^2 |b|^2. */
    ck_abs(ph_vec3_dot(ab, ab) + pow(ph_vec3_dot(a, b), 2),
           ph_vec3_dot(a, a) * ph_vec3_dot(b, b), tol * 10);
    ck_abs(ph_vec3_triple(a, b, c), ph_vec3_triple(b, c, a), tol * 10);
    ck_abs(ph_vec3_abs(ph_vec3_unit(a)), 1, 4 * DBL_EPSILON);
    ck_vec3(ph_vec3_scale(ph_vec3_abs(a), ph_vec3_unit(a)), a, tol);
  }
}

PH_TEST(test_normal) {
  struct unit_random r = unit_random_of(302);
  for (int i = 0; i < unit_count(2000); i++) {
    ph_vec3 u = unit_random_direction(&r), a = random_vec3(&r), v;
    v = ph_vec3_normal(a, u);
    ck_abs(ph_vec3_dot(v, u), 0, 8 * DBL_EPSILON);
    ck_abs(ph_vec3_abs(ph_vec3_cross(ph_vec3_sub(a, v), u)), 0, 1e-15);
    v = ph_vec3_any_normal(u);
    ck_abs(ph_vec3_dot(v, u), 0, 4 * DBL_EPSILON);
    ck_abs(ph_vec3_abs(v), 1, 4 * DBL_EPSILON);
  }
  for (int k = 0; k < 3; k++) { /* of the axes, and equal components */
    ph_vec3 u = ph_vec3_of(k == 0, k == 1, k == 2);
    ck_abs(ph_vec3_dot(ph_vec3_any_normal(u), u), 0, 0);
    u = ph_vec3_unit(ph_vec3_of(k != 0, k != 1, -1));
    ck_abs(ph_vec3_dot(ph_vec3_any_normal(u), u), 0, DBL_EPSILON);
  }
}

/* ---- quaternions ---------------------------------------------------- */

PH_TEST(test_table) {
  const ph_quat minus = {-1, 0, 0, 0};
  ck_quat(ph_quat_mul(I, I), minus, 0);
  ck_quat(ph_quat_mul(J, J), minus, 0);
  ck_quat(ph_quat_mul(K, K), minus, 0);
  ck_quat(ph_quat_mul(I, J), K, 0);
  ck_quat(ph_quat_mul(J, K), I, 0);
  ck_quat(ph_quat_mul(K, I), J, 0);
  ck_quat(ph_quat_mul(J, I), ph_quat_scale(-1, K), 0);
  ck_quat(ph_quat_mul(K, J), ph_quat_scale(-1, I), 0);
  ck_quat(ph_quat_mul(I, K), ph_quat_scale(-1, J), 0);
}

PH_TEST(test_product) {
  struct unit_random r = unit_random_of(303);
  for (int i = 0; i < unit_count(2000); i++) {
    ph_quat a = random_quat(&r), b = random_quat(&r), c = random_quat(&r);
    ph_vec3 v = random_vec3(&r), w = random_vec3(&r);
    ph_cplx e = unit_random_cplx(&r, 2);
    ph_quat vw = ph_quat_mul(ph_quat_pure(v), ph_quat_pure(w));
    ck_quat(ph_quat_mul(ph_quat_mul(a, b), c),
            ph_quat_mul(a, ph_quat_mul(b, c)), 1e-13);
    ck_quat(ph_quat_mul(a, ph_quat_sub(ph_quat_add(b, c), c)),
            ph_quat_mul(a, b), 1e-13);
    ck_rel(ph_quat_abs(ph_quat_mul(a, b)), ph_quat_abs(a) * ph_quat_abs(b),
           8 * DBL_EPSILON);
    ck_quat(ph_quat_conj(ph_quat_mul(a, b)),
            ph_quat_mul(ph_quat_conj(b), ph_quat_conj(a)), 1e-14);
    ck_abs(ph_quat_mul(a, ph_quat_conj(b)).u, ph_quat_dot(a, b), 1e-14);
    ck_quat(ph_quat_turn(a, e), ph_quat_mul(a, ph_quat_of(e.re, e.im, 0, 0)),
            1e-14);
    ck_quat(ph_quat_between(a, b), ph_quat_mul(ph_quat_conj(a), b), 0);
    /* Of vectors: v w = -v.w + v x w. */
    ck_abs(vw.u, -ph_vec3_dot(v, w), 1e-14);
    ck_vec3(ph_quat_vector(vw), ph_vec3_cross(v, w), 1e-14);
  }
}

static ph_vec3 sandwich(ph_quat a, ph_quat axis, ph_quat b) {
  return ph_quat_vector(ph_quat_mul(ph_quat_mul(a, axis), ph_quat_conj(b)));
}

/* vect(a i b*) and so on, and that they are symmetric. */
PH_TEST(test_maps) {
  struct unit_random r = unit_random_of(304);
  for (int i = 0; i < unit_count(2000); i++) {
    ph_quat a = random_quat(&r), b = random_quat(&r);
    double s = ph_quat_dot(a, a);
    ph_vec3 e1 = ph_vec3_scale(1 / s, ph_quat_i(a, a));
    ph_vec3 e2 = ph_vec3_scale(1 / s, ph_quat_j(a, a));
    ph_vec3 e3 = ph_vec3_scale(1 / s, ph_quat_k(a, a));
    ck_vec3(ph_quat_i(a, b), sandwich(a, I, b), 1e-13);
    ck_vec3(ph_quat_j(a, b), sandwich(a, J, b), 1e-13);
    ck_vec3(ph_quat_k(a, b), sandwich(a, K, b), 1e-13);
    ck_vec3(ph_quat_i(b, a), sandwich(a, I, b), 1e-13);
    ck_vec3(ph_quat_j(b, a), sandwich(a, J, b), 1e-13);
    ck_vec3(ph_quat_k(b, a), sandwich(a, K, b), 1e-13);
    ck_vec3(ph_vec3_cross(e1, e2), e3, 1e-15);
    ck_abs(ph_vec3_triple(e1, e2, e3), 1, 2e-15);
  }
}

/* ---- frames --------------------------------------------------------- */

/* The unit quaternion q or -q from its frame; which one does not matter. */
static void ck_frame(ph_quat q) {
  ph_quat found =
      ph_quat_of_frame(ph_quat_i(q, q), ph_quat_j(q, q), ph_quat_k(q, q));
  double sign = ph_quat_dot(found, q) < 0 ? -1 : 1;
  ck_abs(ph_quat_abs(found), 1, 2 * DBL_EPSILON);
  ck_quat(ph_quat_scale(sign, found), q, 8 * DBL_EPSILON);
}

static size_t largest(ph_quat q) {
  const double v[] = {fabs(q.u), fabs(q.v), fabs(q.p), fabs(q.q)};
  size_t at = 0;
  for (size_t i = 1; i < 4; i++) {
    at = v[i] > v[at] ? i : at;
  }
  return at;
}

PH_TEST(test_of_frame) {
  struct unit_random r = unit_random_of(305);
  int seen[4] = {0};
  for (int i = 0; i < unit_count(4000); i++) {
    ph_quat q = unit_random_turn(&r);
    seen[largest(q)]++;
    ck_frame(q);
  }
  for (size_t i = 0; i < 4; i++) {
    ck_assert_int_gt(seen[i], unit_count(50));
  }
}

/* No turn, half turns, and all turns whose quaternion has entries 0 and +-1:
 * several diagonals are the largest. */
PH_TEST(test_of_frame_even) {
  for (int i = 0; i < 81; i++) {
    ph_quat q = ph_quat_of(i % 3 - 1, i / 3 % 3 - 1, i / 9 % 3 - 1, i / 27 - 1);
    if (ph_quat_dot(q, q) > 0) {
      ck_frame(ph_quat_scale(1 / ph_quat_abs(q), q));
    }
  }
}
