/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Segments prepared for many places: each formula against its definition. */
#include "segment_unit.h"
#include "unit.h"

#include "curve/segment/seg3_fast.h"
#include "curve_unit.h"

static const double ANGLES[] = {0,   1e-9, 1e-4, 0.01, 0.1,
                                0.5, 1,    2,    3,    3.14159};
enum { ANGLES_N = COUNT(ANGLES), STEPS = 16 };

/* p and q by their definitions, without a difference. */
static double p_of(double a, double x) {
  return a > 0 ? sin(a * x) / a : x;
}

static double q_of(double a, double x) {
  double s = p_of(a / 2, x);
  return s * s / 2;
}

/* The integral of q^power over [0,x]. */
static double integral_of_q(double a, double x, int power) {
  struct ph_quad rule;
  double sum = 0;
  ck_assert(ph_quad_gauss(&rule, 20));
  for (size_t i = 0; i < rule.n; i++) {
    double q = q_of(a, x * rule.node[i]);
    sum += rule.weight[i] * (power == 1 ? q : q * q);
  }
  return x * sum;
}

/* A segment by chance, prepared, with its preimage by u. */
struct prepared {
  struct unit_curve3 c;
  struct ph_fast3 fast;
  double unit; /* of lengths */
};

static void prepare(struct prepared *s, double angle, double wild,
                    struct unit_random *r) {
  ph_quat a[3];
  for (size_t i = 0; i < 3; i++) {
    ph_cplx left = unit_random_cplx(r, wild), right = unit_random_cplx(r, wild);
    a[i] = ph_quat_of(1 + left.re, left.im, right.re, right.im);
  }
  /* Next to pi, A1 counts by its product with cos(a/2). */
  a[1] = ph_quat_scale(1 / cos(angle / 2), a[1]);
  unit_curve3_of(&s->c, 1, angle > 0 ? &angle : NULL, a, ph_vec3_of(3, -1, 2));
  ph_fast3_of(&s->c.curve, 0, &s->fast);
  s->unit = ph_pow2_apply(s->fast.grow, 1);
}

/* (1), (5) and (6) */
PH_TEST_EACH(test_functions, ANGLES_N) {
  struct unit_random r = unit_random_of(1320);
  const double a = ANGLES[_i];
  struct prepared s;
  prepare(&s, a, 1, &r);
  for (int i = 0; i <= STEPS; i++) {
    double x = 0.5 * i / STEPS;
    for (size_t end = 0; end < 2; end++) {
      double signed_x = end == 0 ? x : -x;
      struct ph_fast3_place at = ph_fast3_from(&s.fast, end, signed_x);
      ck_rel(at.p, p_of(a, signed_x), 4e-16);
      ck_rel(at.q, q_of(a, signed_x), 1e-15);
      ck_abs(at.dp, cos(a * x), 4e-16);
      ck_rel(at.i, integral_of_q(a, signed_x, 1), 2e-15);
      ck_rel(at.k, integral_of_q(a, signed_x, 2), 2e-15);
      ck_abs(at.p * at.p, 2 * at.q - a * a * at.q * at.q, 1e-15);
      ck_assert(at.end == &s.fast.end[end]);
    }
  }
}

static void ck_quat(ph_quat a, ph_quat b, double tol) {
  ck_abs(a.u, b.u, tol);
  ck_abs(a.v, b.v, tol);
  ck_abs(a.p, b.p, tol);
  ck_abs(a.q, b.q, tol);
}

/* (2) and (3), against the segment's own jet. */
PH_TEST_EACH(test_preimage, ANGLES_N) {
  struct unit_random r = unit_random_of(1321 + (uint64_t)_i);
  for (int n = 0; n < 20; n++) {
    struct prepared s;
    prepare(&s, ANGLES[_i], 1, &r);
    for (int i = 0; i <= STEPS; i++) {
      double u = (double)i / STEPS, root = sqrt(s.unit);
      struct ph_fast3_place at = ph_fast3_at(&s.fast, u);
      ph_quat a = unit_curve3_preimage(&s.c.curve, 0, u), jet[4];
      double noise = 1e-14 / s.fast.seg.space.c;
      ck_quat(ph_quat_scale(root, ph_fast3_preimage(&at)), a, 4e-15);
      ph_seg3_jet(&s.fast.seg, u, jet, 3);
      ck_quat(ph_fast3_first(&at), jet[1], noise);
      ck_quat(ph_fast3_second(&s.fast, &at), jet[2], 4 * noise);
    }
  }
}

static double form_at(const struct ph_fast3_place *at, const double c[5]) {
  return c[0] + c[1] * at->p + c[2] * at->q + c[3] * at->p * at->q +
         c[4] * at->q * at->q;
}

/* (4): the speed and the hodograph from either end. */
PH_TEST_EACH(test_forms, ANGLES_N) {
  struct unit_random r = unit_random_of(1340 + (uint64_t)_i);
  for (int n = 0; n < 20; n++) {
    struct prepared s;
    prepare(&s, ANGLES[_i], 1, &r);
    for (int i = 0; i <= 2 * STEPS; i++) {
      double u = 0.5 * i / STEPS;
      struct ph_fast3_place at = ph_fast3_at(&s.fast, u);
      ph_quat a = unit_curve3_preimage(&s.c.curve, 0, u);
      ph_vec3 hodograph = unit_turned(a, ph_quat_of(0, 1, 0, 0));
      const double tol = 4e-14 * s.unit;
      ck_abs(s.unit * form_at(&at, at.end->s), ph_quat_dot(a, a), tol);
      ck_abs(s.unit * form_at(&at, at.end->x), hodograph.x, tol);
      ck_abs(s.unit * form_at(&at, at.end->y), hodograph.y, tol);
      ck_abs(s.unit * form_at(&at, at.end->z), hodograph.z, tol);
    }
  }
}

/* (5), against quadrature from the end. */
PH_TEST_EACH(test_integrals, ANGLES_N) {
  struct unit_random r = unit_random_of(1360 + (uint64_t)_i);
  struct ph_quad rule;
  ck_assert(ph_quad_gauss(&rule, 20));
  for (int n = 0; n < 20; n++) {
    struct prepared s;
    prepare(&s, ANGLES[_i], 1, &r);
    for (int i = 0; i <= STEPS; i++) {
      double u = unit_random_in(&r, 0, 1), end = u > 0.5 ? 1 : 0, length = 0;
      struct ph_fast3_place at = ph_fast3_at(&s.fast, u);
      ph_vec3 point = at.end->point, got = ph_fast3_point(&s.fast, &at);
      for (size_t j = 0; j < rule.n; j++) {
        double v = end + (u - end) * rule.node[j];
        double weight = (u - end) * rule.weight[j];
        ph_quat a = unit_curve3_preimage(&s.c.curve, 0, v);
        length += weight * ph_quat_dot(a, a);
        point = ph_vec3_along(point, weight,
                              unit_turned(a, ph_quat_of(0, 1, 0, 0)));
      }
      ck_abs(s.unit * ph_fast3_integral(&at, at.end->s), length,
             2e-15 * s.c.curve.length);
      ck_abs(unit_apart(got, point), 0, 4e-15 * (4 + s.c.curve.length));
    }
  }
}
