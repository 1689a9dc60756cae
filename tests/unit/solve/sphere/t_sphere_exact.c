/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The spline of velocities: its acceleration in closed form against jets, the
 * published cases, and that it is G2. */
#include "sphere_unit.h"
#include "unit.h"

#include "kernel/s2.h"

enum { N = UNIT_SPHERE_ANY, TRIALS = 100 };

/* The covariant acceleration by the knots, at an end of a segment. */
static ph_vec3 acceleration(const struct unit_sphere *u, size_t k, int end) {
  struct ph_spherical s = unit_sphere_segment(u, k);
  double h = u->data.h[k];
  ph_vec3 jet[4];
  ph_spherical_jet(&s, end, jet);
  return ph_vec3_scale(1 / (h * h), ph_vec3_normal(jet[2], jet[0]));
}

/* The parts of a segment at those of its nodes that have an equation. */
static void ck_parts(const struct unit_sphere *u, size_t k,
                     const struct ph_sphere_part *part) {
  size_t node[2] = {k, ph_sphere_next(&u->data, k)};
  for (int w = 0; w < 2; w++) {
    if (!ph_sphere_is_end(&u->data, node[w])) {
      ph_vec3 p = u->data.p[node[w]], e = u->data.e[node[w]];
      ph_vec3 a = acceleration(u, k, w);
      double tol = 1e-12 / (u->data.h[k] * u->data.h[k]);
      ck_abs(part->f[w].x, ph_vec3_dot(a, e), tol);
      ck_abs(part->f[w].y, ph_vec3_triple(p, e, a), tol);
    }
  }
}

/* Velocities from none to such that control points are 1 radian away. */
PH_TEST(test_acceleration) {
  struct unit_random r = unit_random_of(711);
  for (int t = 0; t < TRIALS; t++) {
    struct unit_sphere u;
    struct ph_sphere_part part;
    unit_sphere_any(&r, unit_sphere_kinds[t % UNIT_SPHERE_KINDS],
                    &ph_sphere_exact, &u);
    u.spline.model->hug(&u.spline, ph_sphere_all(&u.data));
    for (size_t i = 1; i < N; i++) {
      double size = unit_random_in(&r, -1, 1);
      double step[2] = {size, unit_random_in(&r, -1, 1) * size};
      if (!ph_sphere_is_end(&u.data, i)) {
        step[0] /= u.spline.model->reach(&u.spline, i);
        u.spline.x[i] = u.spline.model->move(&u.spline, i, step);
      }
    }
    for (size_t k = 0; k < u.data.m; k++) {
      u.spline.model->segment(&u.spline, k, false, &part);
      ck_parts(&u, k, &part);
    }
    unit_sphere_free(&u);
  }
}

PH_TEST(test_reference) {
  ck_assert_uint_eq(unit_sphere_reference(&ph_sphere_exact), 28);
}

/* The acceleration jumps by nu v, so that the curvature does not jump. */
PH_TEST(test_g2) {
  struct unit_random r = unit_random_of(712);
  for (int t = 0; t < TRIALS; t++) {
    struct unit_sphere u;
    unit_sphere_any(&r, unit_sphere_kinds[t % UNIT_SPHERE_KINDS],
                    &ph_sphere_exact, &u);
    ck_assert(ph_sphere_solve(&u.spline, &u.work));
    for (size_t i = 1; i + 1 < N; i++) {
      struct ph_spherical left = unit_sphere_segment(&u, i - 1);
      struct ph_spherical right = unit_sphere_segment(&u, i);
      ph_vec3 v = u.spline.x[i];
      ph_vec3 jump =
          ph_vec3_sub(acceleration(&u, i, 0), acceleration(&u, i - 1, 1));
      double size = 1 / u.data.h[i - 1] + 1 / u.data.h[i];
      double before = ph_spherical_curvature_end(&left);
      double after = ph_spherical_curvature_start(&right);
      jump = ph_vec3_along(jump, -u.spline.nu[i], v);
      ck_abs(ph_vec3_abs(jump), 0, 1e-13 * (size * size + u.spline.nu[i]));
      ck_abs(before, after, 1e-10 * (1 + fabs(after)));
    }
    unit_sphere_free(&u);
  }
}

/* What other tensions make of a spline, by steps with the matrix of those that
 * it has: up to where steps are half a radian. */
PH_TEST(test_response) {
  struct unit_random r = unit_random_of(713);
  for (int t = 0; t < TRIALS; t++) {
    struct ph_sphere_response response;
    struct unit_sphere u;
    struct ph_sphere_range all;
    ph_vec3 p[UNIT_SPHERE_MAX], x[UNIT_SPHERE_MAX];
    double most = t % 2 ? 0.5 : 0.02;
    unit_sphere_path(&r, UNIT_SPHERE_MAX, most / 2, most, p);
    unit_sphere_of(&u, UNIT_SPHERE_MAX, p, false, PH_SPHERE_NATURAL,
                   &ph_sphere_exact);
    all = ph_sphere_all(&u.data);
    ck_assert(ph_sphere_response_alloc(&response, &u.arena, all.count));
    ck_assert(ph_sphere_solve(&u.spline, &u.work));
    ph_sphere_response_of(&u.spline, all, &response);
    for (size_t i = 3; i < UNIT_SPHERE_MAX; i += 5) {
      u.spline.nu[i] =
          ph_sphere_stiffness(&u.data, i) * unit_random_in(&r, 0, 30);
    }
    ck_assert(ph_sphere_respond_well(&u.spline, &response, &u.work));
    memcpy(x, u.spline.x, sizeof x);
    ck_assert(ph_sphere_newton(&u.spline, all, &u.work));
    for (size_t i = 1; i + 1 < UNIT_SPHERE_MAX; i++) {
      ck_abs(ph_vec3_abs(ph_vec3_sub(x[i], u.spline.x[i])), 0, 1e-6);
    }
    unit_sphere_free(&u);
  }
}
