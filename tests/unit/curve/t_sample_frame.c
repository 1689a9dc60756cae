/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Frames of samples, against their definitions. */
#include "segment_unit.h"
#include "curve_unit.h"
#include "spherical_unit.h"
#include "unit.h"

#include "curve/bezier/convert.h"
#include "curve/sample/frame.h"

enum { SEGMENTS = 3 };

static struct ph_diag diag;

static struct ph_samples framed(const struct ph_curve *curve,
                                enum ph_frame frame, size_t n) {
  const struct ph_sample_rules rules = {
      .how = PH_SAMPLE_PARAMETER, .n = n, .frame = frame};
  struct ph_samples s = unit_samples(curve, rules);
  ck_assert(s.normal && s.binormal);
  return s;
}

/* Tangent, normal and binormal of sample i. */
static void frame_of(const struct ph_samples *s, size_t i, ph_vec3 f[3]) {
  f[0] = ph_vec3_get(s->tangent + 3 * i, 3);
  f[1] = ph_vec3_get(s->normal + 3 * i, 3);
  f[2] = ph_vec3_get(s->binormal + 3 * i, 3);
}

/* Unit vectors, at right angles to each other, right-handed. */
static void ck_orthonormal(const struct ph_samples *s) {
  for (size_t i = 0; i < s->n; i++) {
    ph_vec3 f[3];
    frame_of(s, i, f);
    ck_abs(ph_vec3_abs(f[1]), 1, 2e-15);
    ck_abs(ph_vec3_abs(f[2]), 1, 2e-15);
    ck_abs(ph_vec3_dot(f[0], f[1]), 0, 2e-15);
    ck_vec3(ph_vec3_cross(f[0], f[1]), f[2], 2e-15);
  }
}

/* A curve in space by chance: a PH or an ATPH curve, or the Bezier curve of
 * one. */
static struct ph_curve any_curve(int i, struct unit_curve3 *c,
                                 struct unit_random *r) {
  struct ph_curve bezier;
  double error;
  unit_curve3_random(c, SEGMENTS, i % 3 > 0, 0.6, r);
  if (i % 3 < 2) {
    return c->curve;
  }
  ck_assert_int_eq(
      ph_bezier_curve(&c->curve, 1e-4, &unit_arena, &bezier, &error, &diag),
      PH_OK);
  return bezier;
}

/* ---- Frenet frames ------------------------------------------------------- */

/* T' is along the normal: [T, T'] = kappa B. */
PH_TEST(test_frenet) {
  struct unit_random r = unit_random_of(1470);
  for (int i = 0; i < unit_count(30); i++) {
    enum { N = 1000 };
    struct unit_curve3 c;
    const struct ph_curve curve = any_curve(i, &c, &r);
    const struct ph_samples s = framed(&curve, PH_FRAME_FRENET, N);
    ck_orthonormal(&s);
    for (size_t k = 0; k < curve.n; k++) {
      for (size_t j = 1; j < N; j += 37) {
        const size_t at = (N + 1) * k + j;
        ph_vec3 f[3], before[3], after[3], turn;
        double step = s.s[at + 1] - s.s[at - 1];
        frame_of(&s, at, f);
        frame_of(&s, at - 1, before);
        frame_of(&s, at + 1, after);
        turn = ph_vec3_scale(1 / step, ph_vec3_sub(after[0], before[0]));
        ck_abs(ph_vec3_dot(turn, f[2]), 0, 2e-3 * (1 + s.curvature[at]));
        ck_abs(ph_vec3_dot(turn, f[1]), s.curvature[at],
               2e-3 * (1 + s.curvature[at]));
      }
    }
    ph_arena_reset(&unit_arena);
  }
}

/* Of a helix the normal is towards the axis. */
PH_TEST(test_helix) {
  const struct unit_helix h = {1.3, 2, 0.7};
  struct unit_curve3 c;
  struct ph_samples s;
  unit_helix_curve(&h, &c);
  s = framed(&c.curve, PH_FRAME_FRENET, 20);
  ck_orthonormal(&s);
  for (size_t i = 0; i < s.n; i++) {
    const double *p = s.point + 3 * i;
    ck_vec3(ph_vec3_get(s.normal + 3 * i, 3),
            ph_vec3_of(-p[0] / h.a, -p[1] / h.a, 0), 1e-13);
  }
}

/* A line has none. */
PH_TEST(test_line) {
  const ph_quat a = {1, 0.5, 0.25, 2}, line[3] = {a, a, a};
  struct unit_curve3 c;
  struct ph_samples s;
  unit_curve3_of(&c, 1, NULL, line, ph_vec3_of(0, 0, 0));
  s = framed(&c.curve, PH_FRAME_FRENET, 4);
  for (size_t i = 0; i < 3 * s.n; i++) {
    ck_assert(isnan(s.normal[i]) && isnan(s.binormal[i]));
  }
  s = framed(&c.curve, PH_FRAME_RMF, 4);
  ck_orthonormal(&s);
  for (size_t i = 3; i < 3 * s.n; i++) {
    ck_abs(s.normal[i], s.normal[i - 3], 1e-15);
  }
}

/* ---- Euler-Rodrigues frames ---------------------------------------------- */

PH_TEST(test_erf) {
  struct unit_random r = unit_random_of(1471);
  for (int i = 0; i < unit_count(60); i++) {
    enum { N = 20 };
    struct unit_curve3 c;
    struct ph_samples s;
    unit_curve3_random(&c, SEGMENTS, i % 2, 1, &r);
    s = framed(&c.curve, PH_FRAME_ERF, N);
    ck_orthonormal(&s);
    for (size_t j = 0; j < s.n; j++) {
      const struct ph_seg3 seg = ph_seg3_of(&c.curve, s.segment[j]);
      ph_vec3 e[3], f[3];
      unit_seg3_frame(&seg, (double)(j % (N + 1)) / N, e);
      frame_of(&s, j, f);
      ck_vec3(f[0], e[0], 1e-14);
      ck_vec3(f[1], e[1], 1e-14);
      ck_vec3(f[2], e[2], 1e-14);
    }
    ph_arena_reset(&unit_arena);
  }
}

/* ---- rotation-minimising frames ------------------------------------------ */

/* From one sample to the next, of step h, a frame that does not rotate turns as
 * the tangent, but for O(h^3), of both signs: the sum over the curve is O(h^2).
 * Returns the greatest of the sums from the start. */
static double rotation(const struct ph_samples *s) {
  double sum = 0, most = 0;
  for (size_t i = 1; i < s->n; i++) {
    ph_vec3 f[3], g[3], moved;
    frame_of(s, i - 1, f);
    frame_of(s, i, g);
    /* by the shortest rotation from f[0] to g[0] */
    moved = ph_vec3_along(
        f[1], -ph_vec3_dot(f[1], g[0]) / (1 + ph_vec3_dot(f[0], g[0])),
        ph_vec3_add(f[0], g[0]));
    sum += asin(ph_vec3_dot(moved, g[2]));
    most = fmax(most, fabs(sum));
  }
  return most;
}

PH_TEST(test_rmf) {
  struct unit_random r = unit_random_of(1472);
  for (int i = 0; i < unit_count(30); i++) {
    enum { N = 600 };
    struct unit_curve3 c;
    const struct ph_curve curve = any_curve(i, &c, &r);
    const struct ph_samples s = framed(&curve, PH_FRAME_RMF, N);
    const struct ph_samples half = framed(&curve, PH_FRAME_RMF, N / 2);
    ph_vec3 f[3], g[3], e[3];
    ck_orthonormal(&s);
    ck_assert(rotation(&s) <= 1e-3);
    ck_assert(rotation(&s) <= 0.3 * rotation(&half) + 1e-11);
    for (size_t k = 1; k < curve.n; k++) { /* through joints */
      frame_of(&s, (N + 1) * k - 1, f);
      frame_of(&s, (N + 1) * k, g);
      ck_vec3(f[1], g[1], 1e-11);
    }
    if (i % 3 < 2) {
      const struct ph_seg3 seg = ph_seg3_of(&curve, 0);
      unit_seg3_frame(&seg, 0, e);
      ck_vec3(ph_vec3_get(s.normal, 3), e[1], 1e-14);
    } else {
      ck_vec3(ph_vec3_get(s.normal, 3),
              ph_vec3_any_normal(ph_vec3_get(s.tangent, 3)), 1e-14);
    }
    ph_arena_reset(&unit_arena);
  }
}

/* The frame does not depend on where samples are taken. */
PH_TEST(test_rmf_anywhere) {
  struct unit_random r = unit_random_of(1473);
  for (int i = 0; i < unit_count(30); i++) {
    struct unit_curve3 c;
    struct ph_samples s, t;
    struct ph_sample_rules rules = {.how = PH_SAMPLE_SPACING,
                                    .frame = PH_FRAME_RMF};
    ph_vec3 f[3], g[3];
    unit_curve3_random(&c, SEGMENTS, i % 2, 0.8, &r);
    s = framed(&c.curve, PH_FRAME_RMF, 7);
    rules.spacing = 0.7 * c.curve.length; /* segments without samples */
    t = unit_samples(&c.curve, rules);
    frame_of(&s, s.n - 1, f);
    frame_of(&t, t.n - 1, g);
    ck_vec3(f[1], g[1], 1e-15);
  }
}

/* A = (u - 1/2) a + (u - 1/2)^2 b stands still, and goes on as it came; how it
 * turns there is not known to any digit. */
PH_TEST(test_standstill) {
  enum { N = 2000 };
  const struct ph_sample_rules rules = {
      .how = PH_SAMPLE_PARAMETER, .n = N, .frame = PH_FRAME_RMF};
  const ph_quat cusp[3] = {
      {-0.5, 0.25, 0.1, 0}, {0, -0.25, -0.1, 0}, {0.5, 0.25, 0.1, 0}};
  struct unit_curve3 c;
  struct ph_samples s;
  unit_curve3_of(&c, 1, NULL, cusp, ph_vec3_of(0, 0, 0));
  s = framed(&c.curve, PH_FRAME_ERF, N);
  ck_orthonormal(&s);
  for (size_t j = 1; j < s.n; j++) {
    ck_vec3(ph_vec3_get(s.normal + 3 * j, 3),
            ph_vec3_get(s.normal + 3 * j - 3, 3), 1e-2);
  }
  ck_assert_int_eq(ph_sample_curve(&c.curve, &rules, &unit_arena, &s, &diag),
                   PH_E_NO_CONVERGENCE);
  ck_assert_str_eq(diag.field, "segments[0]");
}

/* unit_seg3_twist is the same by other means. */
PH_TEST(test_twist) {
  struct unit_random r = unit_random_of(1474);
  struct ph_quad rule;
  ck_assert(ph_quad_gauss(&rule, 12));
  for (int i = 0; i < unit_count(30); i++) {
    struct unit_curve3 c;
    struct ph_samples s;
    struct ph_seg3 seg;
    ph_vec3 e[3], normal;
    double twist;
    unit_curve3_random(&c, 1, i % 2, 0.8, &r);
    s = framed(&c.curve, PH_FRAME_RMF, 1);
    seg = ph_seg3_of(&c.curve, 0);
    twist = unit_seg3_twist(&seg, &rule, 1);
    unit_seg3_frame(&seg, 1, e);
    normal = ph_vec3_along(ph_vec3_scale(cos(twist), e[1]), -sin(twist), e[2]);
    ck_vec3(ph_vec3_get(s.normal + 3, 3), normal, 1e-11);
  }
}

/* ---- on a sphere --------------------------------------------------------- */

PH_TEST(test_sphere) {
  const ph_vec3 center = {1e6, -3, 2};
  struct unit_random r = unit_random_of(1475);
  for (int i = 0; i < unit_count(30); i++) {
    struct unit_spherical c;
    struct ph_samples s, t;
    unit_spherical_random(&c, SEGMENTS, 0.4, &r);
    unit_spherical_place(&c, center, 4);
    s = framed(&c.curve, PH_FRAME_RMF, 30);
    t = framed(&c.curve, PH_FRAME_FRENET, 30);
    ck_orthonormal(&s);
    ck_orthonormal(&t);
    for (size_t j = 0; j < s.n; j++) {
      ph_vec3 f[3], g[3];
      const ph_vec3 p = ph_vec3_get(s.point + 3 * j, 3);
      const double kappa = s.curvature[j];
      frame_of(&s, j, f);
      frame_of(&t, j, g);
      ck_vec3(f[2], ph_vec3_scale(0.25, ph_vec3_sub(p, center)), 1e-9);
      ck_abs(ph_vec3_dot(g[1], f[1]), kappa / hypot(kappa, 0.25), 1e-14);
      ck_abs(ph_vec3_dot(g[1], f[2]), -0.25 / hypot(kappa, 0.25), 1e-14);
    }
    ph_arena_reset(&unit_arena);
  }
}

/* ---- refusals ------------------------------------------------------------ */

static void ck_refused(const struct ph_curve *curve, enum ph_frame frame,
                       enum ph_status status, const char *message) {
  const struct ph_sample_rules rules = {
      .how = PH_SAMPLE_PARAMETER, .n = 3, .frame = frame};
  struct ph_samples s;
  ck_assert_int_eq(ph_sample_curve(curve, &rules, &unit_arena, &s, &diag),
                   status);
  ck_assert_str_eq(diag.message, message);
}

PH_TEST(test_refusals) {
  struct unit_random r = unit_random_of(1476);
  struct unit_curve3 c;
  struct ph_curve curve;
  struct unit_segments flat;
  struct unit_spherical sphere;
  unit_circle(1, 1, &flat);
  ck_refused(&flat.curve, PH_FRAME_RMF, PH_E_INFEASIBLE,
             "a curve in the plane has no frames in space");
  unit_spherical_random(&sphere, 1, 0.4, &r);
  ck_refused(&sphere.curve, PH_FRAME_ERF, PH_E_INFEASIBLE,
             "a curve on a sphere has no Euler-Rodrigues frame");
  curve = any_curve(2, &c, &r);
  ck_refused(&curve, PH_FRAME_ERF, PH_E_INFEASIBLE,
             "Bezier curves have no preimage and no Euler-Rodrigues frame: ask "
             "for the frame without the conversion");
}
