/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Planar PH quintic segments: each identity of ph2.h at random points. */
#include "unit.h"
#include "segment_unit.h"
#include "planar_unit.h"

#include "kernel/quad.h"

enum { SEGMENTS = 500 };

static const double PI = 3.14159265358979323846;

static void random_preimage(struct unit_random *r, ph_cplx w[3]) {
  for (int i = 0; i < 3; i++) {
    w[i] = unit_random_cplx(r, 1);
  }
}

/* w(u), by its definition. */
static ph_cplx preimage_at(const ph_cplx w[3], double u) {
  const double basis[3] = {(1 - u) * (1 - u), 2 * u * (1 - u), u * u};
  ph_cplx sum = {0, 0};
  for (int i = 0; i < 3; i++) {
    sum = ph_cplx_add(sum, ph_cplx_scale(basis[i], w[i]));
  }
  return sum;
}

PH_TEST(test_length) {
  struct unit_random r = unit_random_of(3);
  struct ph_quad rule;
  ck_assert(ph_quad_gauss(&rule, 8));
  for (int i = 0; i < SEGMENTS; i++) {
    double length = 0;
    ph_cplx w[3];
    random_preimage(&r, w);
    for (size_t k = 0; k < rule.n; k++) {
      length += rule.weight[k] * ph_cplx_norm2(preimage_at(w, rule.node[k]));
    }
    ck_rel(ph_length(w), length, 1e-14);
  }
}

/* Where the preimage does end at `end`, the control points are the integral of
 * its square: the derivative of their Bezier curve. */
PH_TEST(test_control_points) {
  struct unit_random r = unit_random_of(4);
  for (int i = 0; i < SEGMENTS; i++) {
    ph_cplx w[3], hodograph[5], p[6], start = unit_random_cplx(&r, 1), end;
    double u = unit_random_in(&r, 0, 1), flat[12];
    random_preimage(&r, w);
    ph_hodograph(w, hodograph);
    end = start;
    for (int k = 0; k < 5; k++) {
      end = ph_cplx_add(end, ph_cplx_scale(0.2, hodograph[k]));
    }
    ph_control_points(w, start, end, p);
    memcpy(flat, p, sizeof flat);
    ck_abs(unit_distance(p[0], start), 0, 0);
    ck_abs(unit_distance(p[5], end), 0, 0);
    ck_assert_double_le(
        unit_distance(unit_bezier(flat, 5, 1, u),
                      ph_cplx_mul(preimage_at(w, u), preimage_at(w, u))),
        2e-14);
  }
}

/* What the integral misses the end by goes into the middle leg, all of it. */
PH_TEST(test_defect) {
  struct unit_random r = unit_random_of(5);
  for (int i = 0; i < SEGMENTS; i++) {
    const ph_cplx zero = {0, 0};
    ph_cplx w[3], hodograph[5], p[6], defect = unit_random_cplx(&r, 1), end;
    random_preimage(&r, w);
    ph_hodograph(w, hodograph);
    end = defect;
    for (int k = 0; k < 5; k++) {
      end = ph_cplx_add(end, ph_cplx_scale(0.2, hodograph[k]));
    }
    ph_control_points(w, zero, end, p);
    for (int k = 0; k < 5; k++) {
      ph_cplx leg = ph_cplx_sub(p[k + 1], p[k]);
      ph_cplx own = ph_cplx_scale(0.2, hodograph[k]);
      ph_cplx more = k == 2 ? defect : zero;
      ck_assert_double_le(unit_distance(ph_cplx_sub(leg, own), more), 2e-15);
    }
  }
}

/* Run backwards, with i w in reverse order, the points are the same ones. */
PH_TEST(test_reversal) {
  struct unit_random r = unit_random_of(6);
  for (int i = 0; i < SEGMENTS; i++) {
    ph_cplx w[3], back[3], p[6], q[6];
    ph_cplx start = unit_random_cplx(&r, 1), end = unit_random_cplx(&r, 1);
    random_preimage(&r, w);
    for (int k = 0; k < 3; k++) {
      back[k] = ph_cplx_of(-w[2 - k].im, w[2 - k].re);
    }
    ph_control_points(w, start, end, p);
    ph_control_points(back, end, start, q);
    for (int k = 0; k < 6; k++) {
      ck_abs(unit_distance(p[k], q[5 - k]), 0, 0);
    }
    ck_rel(ph_length(back), ph_length(w), 1e-15);
    ck_abs(ph_rotation(back), -ph_rotation(w), 1e-13);
  }
}

/* Step (2) in ph_seg2_rotation. */
PH_TEST(test_factorisation) {
  struct unit_random r = unit_random_of(7);
  for (int i = 0; i < SEGMENTS; i++) {
    double u = unit_random_in(&r, -1, 2);
    ph_cplx w[3], d, q, left, right;
    random_preimage(&r, w);
    d = ph_cplx_sqrt(
        ph_cplx_sub(ph_cplx_mul(w[1], w[1]), ph_cplx_mul(w[0], w[2])));
    q = ph_cplx_dot(w[1], d) >= 0 ? ph_cplx_add(w[1], d) : ph_cplx_sub(w[1], d);
    left = ph_cplx_add(ph_cplx_scale(1 - u, q), ph_cplx_scale(u, w[2]));
    right = ph_cplx_add(ph_cplx_scale(1 - u, w[0]), ph_cplx_scale(u, q));
    ck_assert_double_le(unit_distance(ph_cplx_mul(q, preimage_at(w, u)),
                                      ph_cplx_mul(left, right)),
                        1e-13);
    ck_assert_double_ge(ph_cplx_abs(q), ph_cplx_abs(w[1]) * (1 - 1e-15));
  }
}

/* The turn of the tangent, added up in steps so small that none is ambiguous;
 * false where the curve comes too near to standing still for that. */
static bool rotation_in_steps(const ph_cplx w[3], double *rotation) {
  enum { STEPS = 2000 };
  ph_cplx before = w[0];
  *rotation = 0;
  for (int i = 1; i <= STEPS; i++) {
    ph_cplx here = preimage_at(w, (double)i / STEPS);
    double turn = atan2(ph_cplx_cross(before, here), ph_cplx_dot(before, here));
    if (fabs(turn) > 0.5) {
      return false;
    }
    *rotation += 2 * turn;
    before = here;
  }
  return true;
}

PH_TEST(test_rotation) {
  struct unit_random r = unit_random_of(8);
  int loops = 0, compared = 0;
  for (int i = 0; i < SEGMENTS; i++) {
    double rotation;
    ph_cplx w[3];
    random_preimage(&r, w);
    if (rotation_in_steps(w, &rotation)) {
      ck_abs(ph_rotation(w), rotation, 1e-10);
      loops += fabs(rotation) > PI;
      compared++;
    }
  }
  ck_assert_int_ge(compared, SEGMENTS * 9 / 10);
  ck_assert_int_ge(loops, 10);
}

PH_TEST(test_rotation_special) {
  const ph_cplx straight[3] = {{1, 0}, {2, 0}, {0.5, 0}};
  const ph_cplx arc[3] = {{1, 0}, {1, 0.5}, {1, 1}};
  const ph_cplx no_middle[3] = {{1, 0}, {0, 0}, {0, 1}};
  const ph_cplx square[3] = {{1, 0}, {0, 1}, {-1, 0}}; /* (1 - u + i u)^2 */
  const ph_cplx from_rest[3] = {{0, 0}, {1, 0}, {0, 1}};
  const ph_cplx to_rest[3] = {{1, 0}, {0, 1}, {0, 0}};
  ck_abs(ph_rotation(straight), 0, 0);
  ck_abs(ph_rotation(arc), PI / 2, 1e-15);
  ck_abs(ph_rotation(no_middle), PI, 1e-14);
  ck_abs(ph_rotation(square), 2 * PI, 1e-14);
  /* At rest there is no tangent: the limits count. */
  ck_abs(ph_rotation(from_rest), PI, 1e-14);
  ck_abs(ph_rotation(to_rest), PI, 1e-14);
}

/* A mirror image turns the other way, and a turned one likewise. */
PH_TEST(test_rotation_symmetry) {
  struct unit_random r = unit_random_of(9);
  for (int i = 0; i < SEGMENTS; i++) {
    ph_cplx w[3], mirror[3], turned[3], f = unit_random_cplx(&r, 1);
    double rotation;
    random_preimage(&r, w);
    for (int k = 0; k < 3; k++) {
      mirror[k] = ph_cplx_conj(w[k]);
      turned[k] = ph_cplx_mul(f, w[k]);
    }
    rotation = ph_rotation(w);
    ck_abs(ph_rotation(mirror), -rotation, 1e-12);
    ck_abs(ph_rotation(turned), rotation, 1e-10);
  }
}
