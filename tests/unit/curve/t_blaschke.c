/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Images on the Blaschke cylinder: their definition, point by point. */
#include "unit.h"
#include "planar_unit.h"
#include "tc_curve_unit.h"

#include "curve/offset/blaschke.h"
#include "curve/offset/offset.h"
#include "kernel/vec3.h"

static struct ph_diag diag;

/* The point at t of a rational Bezier piece. */
static ph_vec3 rational(const struct ph_blaschke *piece, double t) {
  double lifted[12], flat[12], unit = 0;
  ph_cplx xy, zw;
  for (size_t i = 0; i < 6; i++) {
    unit = fmax(unit, piece->weights[i]);
  }
  for (size_t i = 0; i < 6; i++) {
    const double *p = piece->control_points[i], w = piece->weights[i] / unit;
    lifted[2 * i] = w * p[0];
    lifted[2 * i + 1] = w * p[1];
    flat[2 * i] = w * p[2];
    flat[2 * i + 1] = w;
  }
  xy = unit_bezier(lifted, 5, 0, t);
  zw = unit_bezier(flat, 5, 0, t);
  return ph_vec3_of(xy.re / zw.im, xy.im / zw.im, zw.re / zw.im);
}

/* The unit tangent of a cubic at t. */
static ph_cplx tangent_of(const struct ph_curve *curve, size_t k, double t) {
  ph_cplx w = unit_preimage(curve, k, 0, t);
  return ph_cplx_scale(1 / ph_cplx_norm2(w), ph_cplx_mul(w, w));
}

/* (n, -<n, r>) with the left normal n. */
static ph_vec3 defined(const struct ph_curve *curve, size_t k, double t) {
  ph_cplx along = tangent_of(curve, k, t), r = unit_curve(curve, k, 0, t);
  return ph_vec3_of(-along.im, along.re, along.im * r.re - along.re * r.im);
}

/* x and y to one tolerance, z to another. */
static void ck_image(ph_vec3 a, ph_vec3 b, double tol, double tol_z) {
  ck_abs(a.x, b.x, tol);
  ck_abs(a.y, b.y, tol);
  ck_abs(a.z, b.z, tol_z);
}

/* What a curve by chance is compared to. */
struct noise {
  double normal; /* of w over |w| */
  double z;      /* of <n, r> */
};

static struct noise noise_of(const struct unit_cubics *c, double scale,
                             double far) {
  struct noise noise;
  double slow = HUGE_VAL;
  for (size_t k = 0; k < c->curve.n; k++) {
    slow = fmin(slow, unit_cubic_slowest(c, k) / scale);
  }
  noise.normal = 4e-15 * (1 + 1 / sqrt(slow));
  noise.z = scale * (4e-15 + noise.normal) * (4 + 2 * far);
  return noise;
}

/* The same pieces and weights as those of an offset, and its points. */
PH_TEST(test_definition) {
  const double scales[] = {1, 1e-9, 1e9, 1e-150, 1e150};
  const struct ph_offset_rules rules = {.tolerance = 1e-9};
  const int curves = unit_count(300);
  struct unit_random r = unit_random_of(900);
  size_t cuts = 0;
  for (int i = 0; i < curves; i++) {
    const double scale = scales[i % 5], far = i % 3 ? 1 : 1e6;
    struct unit_cubics c;
    struct ph_offset o;
    struct noise noise;
    unit_cubics_random(&c, &r, 4, scale, unit_random_cplx(&r, far * scale));
    noise = noise_of(&c, scale, far);
    ck_assert_int_eq(ph_blaschke_curve(&c.curve, &unit_arena, &diag), PH_OK);
    ck_assert_int_eq(ph_offset(&c.curve, 0, &rules, &unit_arena, &o, &diag),
                     PH_OK);
    ck_assert_uint_eq(c.curve.blaschke.n, o.n);
    for (size_t j = 0; j < o.n; j++) {
      const struct ph_blaschke *b = &c.curve.blaschke.v[j];
      const double from = b->interval[0], to = b->interval[1];
      ck_assert_uint_eq(b->segment, o.segment[j]);
      ck_assert_mem_eq(b->interval, o.interval + 2 * j, sizeof b->interval);
      ck_assert_mem_eq(b->weights, o.weights + 6 * j, sizeof b->weights);
      for (size_t k = 0; k < 6; k++) {
        ck_assert(b->weights[k] > 0);
      }
      for (int k = 0; k <= 8; k++) {
        double t = k / 8.0;
        ph_vec3 at = rational(b, t);
        ck_image(at, defined(&c.curve, b->segment, from + t * (to - from)),
                 noise.normal, noise.z);
        ck_abs(hypot(at.x, at.y), 1, noise.normal);
      }
    }
    cuts += o.n - 4;
    ph_arena_reset(&unit_arena);
  }
  ck_assert_int_ge((int)cuts, curves / 5);
}

/* c' = -kappa sigma (t, -<t, r>) at both ends of a segment, kappa sigma =
 * 2 K / |w|^2: two that join smoothly have one tangent there [BYR11, thm 19].
 */
PH_TEST(test_ends) {
  struct unit_random r = unit_random_of(901);
  for (int i = 0; i < 200; i++) {
    struct unit_cubics c;
    unit_cubics_random(&c, &r, 3, 1, unit_random_cplx(&r, 1));
    ck_assert_int_eq(ph_blaschke_curve(&c.curve, &unit_arena, &diag), PH_OK);
    for (size_t j = 0; j < c.curve.blaschke.n; j++) {
      const struct ph_blaschke *b = &c.curve.blaschke.v[j];
      const double width = b->interval[1] - b->interval[0];
      for (size_t end = 0; end < 2; end++) {
        const size_t at = 5 * end, near = end ? 4 : 1;
        const double t = b->interval[end];
        const double *p = b->control_points[at], *q = b->control_points[near];
        const ph_cplx along = tangent_of(&c.curve, b->segment, t);
        const ph_cplx point = unit_curve(&c.curve, b->segment, 0, t);
        const ph_cplx w = unit_preimage(&c.curve, b->segment, 0, t);
        const double f =
            -2 * unit_cubic_bend(&c, b->segment) / ph_cplx_norm2(w);
        const double g = (end ? -5 : 5) * b->weights[near] / b->weights[at];
        const double tol = 1e-14 * (1 + fabs(f)) * (1 + 1 / ph_cplx_abs(w));
        ck_image(
            ph_vec3_of(g * (q[0] - p[0]), g * (q[1] - p[1]), g * (q[2] - p[2])),
            ph_vec3_of(width * f * along.re, width * f * along.im,
                       -width * f * ph_cplx_dot(along, point)),
            tol * (1 + g * g), 10 * tol * (1 + g * g));
      }
    }
    ph_arena_reset(&unit_arena);
  }
}

/* All tangents of a line are the line. */
PH_TEST(test_line) {
  struct unit_cubics c;
  unit_cubics_begin(&c, ph_cplx_of(1, 7));
  unit_cubics_add(&c, ph_cplx_of(2, 0), ph_cplx_of(3, 0));
  ck_assert_int_eq(ph_blaschke_curve(&c.curve, &unit_arena, &diag), PH_OK);
  ck_assert_uint_eq(c.curve.blaschke.n, 1);
  for (size_t k = 0; k < 6; k++) {
    const double *p = c.curve.blaschke.v[0].control_points[k];
    ck_abs(p[0], 0, 0);
    ck_abs(p[1], 1, 1e-15);
    ck_abs(p[2], -7, 1e-14);
    ck_assert(!signbit(p[0]));
  }
}

PH_TEST(test_standstill) {
  struct unit_cubics c;
  unit_cubics_begin(&c, ph_cplx_of(0, 0));
  unit_cubics_add(&c, ph_cplx_of(1, 0), ph_cplx_of(1, 1));
  unit_cubics_add(&c, ph_cplx_of(1, 1), ph_cplx_of(-2, -2));
  ck_assert_int_eq(ph_blaschke_curve(&c.curve, &unit_arena, &diag),
                   PH_E_INFEASIBLE);
  ck_assert_str_eq(diag.field, "segments[1]");
  ck_assert_str_eq(diag.message,
                   "has no image on the Blaschke cylinder: the curve stands "
                   "still in it and has no normal there");
}

PH_TEST(test_too_large) {
  struct unit_cubics c;
  unit_cubics_begin(&c, ph_cplx_of(1.7e308, 1.7e308));
  unit_cubics_add(&c, ph_cplx_of(1e150, 1e150), ph_cplx_of(1e150, 1e150));
  unit_cubics_add(&c, ph_cplx_of(1, -0.4), ph_cplx_of(1, -0.4));
  ck_assert_int_eq(ph_blaschke_curve(&c.curve, &unit_arena, &diag),
                   PH_E_TOO_LARGE);
  ck_assert_str_eq(diag.field, "segments[1]");
  ck_assert_str_eq(diag.message, "its image on the Blaschke cylinder exceeds "
                                 "the range of a double");
}
