/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Fairness of spatial segments: in closed form, and against quadrature that
 * spares no node. */
#include "segment_unit.h"
#include "unit.h"
#include "spatial_unit.h"

#include "curve/fair/fair3.h"
#include "curve/segment/seg3.h"

enum { SEGMENTS = 60, PANELS = 1000 };

static struct ph_fair3_rules rules;
static struct ph_quad rule;

static void begin(void) {
  ck_assert(ph_fair3_begin(&rules));
  ck_assert(ph_quad_gauss(&rule, 20));
}

/* Not so slow, and not so straight, that the panels are too few. */
static bool is_gentle(const struct ph_seg3 *seg) {
  for (size_t i = 0; i <= 100; i++) {
    struct unit_bend3 bend = unit_seg3_bend(seg, (double)i / 100);
    if (bend.speed < 0.05 || ph_cplx_abs(bend.z) < 0.02) {
      return false;
    }
  }
  return true;
}

static struct ph_seg3 random_segment(struct unit_random *r) {
  struct ph_seg3 seg = {.space = unit_random_space(r)};
  size_t tries = 0;
  do {
    for (size_t i = 0; i < 3; i++) {
      seg.a[i] =
          ph_quat_scale(unit_random_in(r, 0.3, 1.5), unit_random_turn(r));
    }
    ck_assert_uint_lt(tries++, 1000);
  } while (!is_gentle(&seg));
  return seg;
}

static struct ph_fair3 direct(const struct ph_seg3 *seg) {
  struct ph_fair3 sum = {0, 0, 0, false};
  for (size_t i = 0; i < PANELS; i++) {
    for (size_t j = 0; j < rule.n; j++) {
      struct unit_bend3 bend =
          unit_seg3_bend(seg, ((double)i + rule.node[j]) / PANELS);
      double weight = rule.weight[j] / PANELS;
      sum.bending += weight * pow(bend.curvature, 2) * bend.speed;
      sum.varying += weight * pow(bend.slope, 2) / bend.speed;
      sum.twisting += weight * pow(bend.torsion_slope, 2) / bend.speed;
    }
  }
  return sum;
}

PH_TEST(test_quadrature) {
  struct unit_random r = unit_random_of(1100);
  for (int n = 0; n < unit_count(SEGMENTS); n++) {
    struct ph_seg3 seg = random_segment(&r);
    struct ph_fair3 wanted = direct(&seg);
    struct ph_fair3 found = ph_fair3_of(&rules, &seg.space, seg.a);
    ck_rel(found.bending, wanted.bending, 1e-11);
    ck_rel(found.varying, wanted.varying, 1e-11);
    ck_rel(found.twisting, wanted.twisting, 1e-10);
  }
}

/* The whole is the sum of its parts, also where it nearly stands still or
 * nearly does not bend, and the parts need other nodes. */
PH_TEST(test_parts) {
  struct unit_random r = unit_random_of(1101);
  for (int n = 0; n < unit_count(10 * SEGMENTS); n++) {
    struct ph_seg3 seg = {.space = unit_random_space(&r)};
    struct ph_fair3 whole, sum = {0, 0, 0, false};
    const double at[] = {0, 0.31, 0.47, 1};
    for (size_t i = 0; i < 3; i++) {
      seg.a[i] = unit_random_turn(&r);
    }
    whole = ph_fair3_of(&rules, &seg.space, seg.a);
    for (size_t i = 0; i < 3; i++) {
      struct ph_seg3 part = unit_seg3_part(&seg, &rule, at[i], at[i + 1]);
      struct ph_fair3 fair = ph_fair3_of(&rules, &part.space, part.a);
      sum.bending += fair.bending;
      sum.varying += fair.varying;
      sum.twisting += fair.twisting;
    }
    ck_rel(whole.bending, sum.bending, 1e-10);
    ck_rel(whole.varying, sum.varying, 1e-9);
    ck_rel(whole.twisting, sum.twisting, 1e-8);
  }
}

/* A curve s times as large has E / s, MV / s^3 and so on: F1 to F3 are the
 * same.  s is a power of two, and its root too. */
PH_TEST(test_scale) {
  struct unit_random r = unit_random_of(1102);
  for (int exponent = -20; exponent <= 20; exponent += 4) {
    struct ph_seg3 seg = random_segment(&r);
    struct ph_fair3 one = ph_fair3_of(&rules, &seg.space, seg.a), other;
    double length = ph_seg3_length(&seg.space, seg.a), scaled;
    for (size_t i = 0; i < 3; i++) {
      seg.a[i] = ph_quat_scale(ldexp(1, exponent), seg.a[i]);
    }
    other = ph_fair3_of(&rules, &seg.space, seg.a);
    scaled = ph_seg3_length(&seg.space, seg.a);
    ck_rel(other.bending, ldexp(one.bending, -2 * exponent), 1e-14);
    ck_rel(other.twisting, ldexp(one.twisting, -6 * exponent), 1e-14);
    for (int k = 1; k <= 3; k++) {
      ck_rel(ph_fair3_functional(&other, scaled, k),
             ph_fair3_functional(&one, length, k), 1e-14);
    }
  }
}

/*
 * The helix (cos t, sin t, p t), t in [0,a], is an ATPH segment: with A(0) i
 * A(0)* = (0,1,p), A(t) = exp(k t/2) A(0) exp(i t/2) turns about its axis and
 * is of degree 1 in cos t and sin t.  Coefficients from the ends and the
 * middle.
 */
static struct ph_seg3 helix(double a, double p) {
  struct ph_seg3 seg = {.space = ph_atph_of(a)};
  ph_vec3 tangent = ph_vec3_unit(ph_vec3_of(0, 1, p));
  ph_vec3 normal = ph_vec3_any_normal(tangent);
  ph_quat start = ph_quat_scale(
      sqrt(a) * pow(1 + p * p, 0.25),
      ph_quat_of_frame(tangent, normal, ph_vec3_cross(tangent, normal)));
  ph_quat half = ph_quat_of(cos(a / 4), 0, 0, sin(a / 4));
  ph_cplx turn = ph_cplx_polar(a / 4);
  ph_quat middle = ph_quat_turn(ph_quat_mul(half, start), turn);
  double s[2], u = 0.5;
  ph_atph_basis(&seg.space, u, s);
  seg.a[0] = start;
  seg.a[2] = ph_quat_turn(ph_quat_mul(half, middle), turn);
  seg.a[1] = ph_quat_scale(
      1 / (2 * seg.space.c * s[0] * s[1]),
      ph_quat_sub(middle,
                  ph_quat_scale(s[0] * s[0], ph_quat_add(seg.a[0], seg.a[2]))));
  return seg;
}

/* Curvature 1 / (1 + p^2), torsion p / (1 + p^2), length a sqrt(1 + p^2); a
 * circle for p = 0. */
PH_TEST(test_helix) {
  for (double a = 0.125; a < 3; a += 0.25) {
    for (double p = 0; p < 3; p += 0.5) {
      struct ph_seg3 seg = helix(a, p);
      struct ph_fair3 fair = ph_fair3_of(&rules, &seg.space, seg.a);
      double length = ph_seg3_length(&seg.space, seg.a), l3 = pow(length, 3);
      ck_rel(length, a * sqrt(1 + p * p), 1e-13);
      ck_rel(fair.bending, length / pow(1 + p * p, 2), 1e-12);
      ck_abs(l3 * fair.varying, 0, 1e-20);
      ck_abs(l3 * fair.twisting, 0, 1e-20);
    }
  }
}

/* The curve r' = (u + q i)^2 of the plane of i and j, turned in space. */
static struct ph_seg3 plane(const double w[3][2], ph_quat turn, double angle) {
  struct ph_seg3 seg = {.space = ph_atph_of(angle)};
  for (size_t i = 0; i < 3; i++) {
    seg.a[i] = ph_quat_mul(turn, ph_quat_of(w[i][0], 0, 0, w[i][1]));
  }
  return seg;
}

/* An S in a tilted plane has no torsion, and the `varying` of its signed
 * curvature; the same S, bent out of the plane at its end, has some. */
PH_TEST(test_plane) {
  struct unit_random r = unit_random_of(1103);
  const double w[3][2] = {{1, -0.4}, {0.9, 0.5}, {1, -0.5}};
  for (int n = 0; n < unit_count(100); n++) {
    struct ph_seg3 seg =
        plane(w, unit_random_turn(&r), unit_random_in(&r, 0, 2));
    struct ph_fair3 fair = ph_fair3_of(&rules, &seg.space, seg.a);
    struct ph_fair3 wanted = direct(&seg);
    ck_abs(fair.twisting, 0, 0);
    ck_rel(fair.bending, wanted.bending, 1e-11);
    ck_rel(fair.varying, wanted.varying, 1e-11);
    ck_rel(ph_fair3_functional(&fair, 2, 3), ph_fair3_functional(&fair, 2, 2),
           0);
    seg.a[2].v += 0.1;
    fair = ph_fair3_of(&rules, &seg.space, seg.a);
    ck_assert(fair.twisting > 1e-3);
  }
}

/* A* A' = i in the middle of a curve that is not plane: it does not bend
 * there, and its torsion is finite on either side; those nearby have a peak. */
PH_TEST(test_inflection) {
  struct ph_seg3 seg = {.space = ph_atph_of(0)};
  ph_quat middle = {1, 0, 0, 0}, slope = {0, 1, 0, 0}, bend = {0, 0, 1, 0.5};
  struct ph_fair3 fair;
  for (int side = 0; side < 3; side++) {
    double y = 0.5 * (side - 1);
    ph_quat at = ph_quat_add(middle, ph_quat_scale(y, slope));
    at = ph_quat_add(at, ph_quat_scale(y * y, bend));
    seg.a[side] = side == 1 ? ph_quat_sub(at, ph_quat_scale(0.25, bend)) : at;
  }
  fair = ph_fair3_of(&rules, &seg.space, seg.a);
  ck_assert(isfinite(fair.bending) && isfinite(fair.varying));
  ck_assert(fair.varying > 0);
  ck_assert(fair.inflected);
  ck_rel(fair.twisting, 2.2367471970, 1e-10);
  seg.a[1].p += 0.01; /* a peak, of finite height */
  fair = ph_fair3_of(&rules, &seg.space, seg.a);
  ck_assert(!fair.inflected && fair.twisting > 100);
}

PH_TEST(test_straight) {
  struct unit_random r = unit_random_of(1104);
  for (int n = 0; n < 20; n++) {
    ph_quat turn = unit_random_turn(&r);
    struct ph_atph space = unit_random_space(&r);
    const ph_quat a[3] = {turn, ph_quat_scale(0.7, turn),
                          ph_quat_scale(2, turn)};
    struct ph_fair3 fair = ph_fair3_of(&rules, &space, a);
    ck_abs(fair.bending, 0, 0);
    ck_abs(fair.varying, 0, 0);
    ck_abs(fair.twisting, 0, 0);
  }
}

/* A curve that stands still at its start, turning. */
PH_TEST(test_cusp) {
  const ph_quat a[3] = {{0, 0, 0, 0}, {1, 0, 0.5, 0}, {1, 0.5, 0, 1}};
  struct ph_atph space = ph_atph_of(0);
  struct ph_fair3 fair = ph_fair3_of(&rules, &space, a);
  ck_assert(fair.bending > 1e6);
}

PH_FIXTURE(begin, NULL)
