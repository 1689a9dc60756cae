/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The spline of global control points: its formulas as they are printed, the
 * published cases, ends, the starts and the last resort. */
#include "sphere_unit.h"
#include "unit.h"

#include "kernel/pi.h"
#include "kernel/s2.h"

#include <string.h>

enum { N = 7, TRIALS = 100 };

/* Data of N nodes with random tensions and knots; not so wild that there would
 * be no spline. */
static void make(struct unit_random *r, struct unit_sphere_kind kind,
                 struct unit_sphere *u) {
  ph_vec3 p[N];
  unit_sphere_path(r, N, 0.1, 0.8, p);
  unit_sphere_of(u, N, p, kind.closed, kind.ends, &ph_sphere_nielson);
  for (size_t i = 0; i < N; i++) {
    u->spline.nu[i] = exp(unit_random_in(r, 1, 6));
  }
  for (size_t k = 0; k < u->data.m; k++) {
    u->data.h[k] *= exp(unit_random_in(r, -0.3, 0.3));
  }
}

/* x, anything near the data. */
static void shake(struct unit_random *r, struct unit_sphere *u) {
  static const double none[2] = {0, 0};
  const struct ph_sphere_model *model = u->spline.model;
  struct ph_sphere_range all = ph_sphere_all(&u->data);
  model->hug(&u->spline);
  for (size_t j = 0; j < all.count; j++) {
    size_t i = ph_sphere_node(&u->data, all, j);
    double step[2] = {unit_random_in(r, -1, 1), unit_random_in(r, -1, 1)};
    u->spline.x[i] = model->move(&u->spline, i, step);
    /* no step: the same, to rounding */
    step[0] = ph_vec3_abs(
        ph_vec3_sub(model->move(&u->spline, i, none), u->spline.x[i]));
    ck_abs(step[0], 0, 1e-15);
  }
}

/* ---- formulas ------------------------------------------------------------ */

static double spacing(const struct unit_sphere *u, size_t i, bool after) {
  return after ? ph_sphere_right(&u->data, i) : ph_sphere_left(&u->data, i);
}

static double gamma_of(const struct unit_sphere *u, size_t i) {
  double a = spacing(u, i, false), b = spacing(u, i, true);
  return ph_sphere_is_end(&u->data, i)
             ? 1
             : 2 * (a + b) / (u->spline.nu[i] * a * b + 2 * (a + b));
}

static ph_vec3 control_at(const struct unit_sphere *u, size_t i) {
  return ph_vec3_add(u->data.p[i], u->spline.x[i]);
}

/* R and L of segment k by the printed formulas. */
static void by_formula(const struct unit_sphere *u, size_t k, ph_vec3 *r,
                       ph_vec3 *l) {
  const struct ph_sphere_data *d = &u->data;
  size_t next = ph_sphere_next(d, k);
  double a = gamma_of(u, k) * spacing(u, k, false), b = d->h[k];
  double sum = a + b + gamma_of(u, next) * spacing(u, next, true);
  ph_vec3 p = control_at(u, k), q = control_at(u, next);
  bool natural = d->ends == PH_SPHERE_NATURAL;
  *r = ph_s2_slerp(p, q, a / sum);
  *l = ph_s2_slerp(p, q, (a + b) / sum);
  if (natural && ph_sphere_is_end(d, k)) {
    double part = (a + b) / sum;
    *l = ph_s2_slerp(d->p[k], q, 2 * part / (1 + part));
    *r = ph_s2_slerp(d->p[k], *l, 0.5);
  } else if (natural && ph_sphere_is_end(d, next)) {
    double part = 1 - a / sum;
    *r = ph_s2_slerp(d->p[next], p, 2 * part / (1 + part));
    *l = ph_s2_slerp(d->p[next], *r, 0.5);
  }
}

static void ck_point(ph_vec3 a, ph_vec3 b, double tol) {
  ck_abs(ph_vec3_abs(ph_vec3_sub(a, b)), 0, tol);
}

/* The equation of node i: the point's place on the great circle. */
static void ck_node(const struct unit_sphere *u, size_t i,
                    const struct ph_sphere_part part[2]) {
  const struct ph_sphere_data *d = &u->data;
  size_t before = ph_sphere_before(d, i);
  double a = d->h[before], b = d->h[i];
  double size = fmax(d->theta[before], d->theta[i]);
  ph_vec3 p = d->p[i], e = d->e[i];
  ph_vec3 g = ph_s2_slerp(u->spline.l[before], u->spline.r[i], a / (a + b));
  struct ph_block2_row row;
  double scale = -2 / (1 + ph_vec3_dot(g, p)) / size;
  u->spline.model->node(&u->spline, i, &part[0], &part[1], false, &row);
  ck_rel(row.f[0], scale * ph_vec3_dot(g, e), 1e-11);
  ck_rel(row.f[1], scale * ph_vec3_triple(p, e, g), 1e-11);
}

START_TEST(test_formulas) {
  struct unit_random r = unit_random_of(701);
  for (int t = 0; t < TRIALS; t++) {
    struct ph_sphere_part part[N];
    struct unit_sphere u;
    make(&r, unit_sphere_kinds[t % UNIT_SPHERE_KINDS], &u);
    shake(&r, &u);
    for (size_t k = 0; k < u.data.m; k++) {
      ph_vec3 right, left;
      u.spline.model->segment(&u.spline, k, false, &part[k]);
      by_formula(&u, k, &right, &left);
      ck_point(u.spline.r[k], right, 1e-14);
      ck_point(u.spline.l[k], left, 1e-14);
    }
    for (size_t i = 1; i + 1 < N; i++) {
      ck_node(&u, i, &part[i - 1]);
    }
    unit_sphere_free(&u);
  }
}
END_TEST

START_TEST(test_reference) {
  ck_assert_uint_eq(unit_sphere_reference(&ph_sphere_nielson), 28);
}
END_TEST

/* ---- ends ---------------------------------------------------------------- */

/* The covariant acceleration at both ends, and R the midpoint of P and L. */
START_TEST(test_natural) {
  struct unit_random r = unit_random_of(702);
  for (int t = 0; t < TRIALS; t++) {
    struct unit_sphere u;
    make(&r, unit_sphere_kinds[0], &u);
    ck_assert(ph_sphere_solve(&u.spline, &u.work));
    for (int w = 0; w < 2; w++) {
      struct ph_spherical s = unit_sphere_segment(&u, w == 0 ? 0 : N - 2);
      ph_vec3 jet[4], *p = s.p;
      ph_spherical_jet(&s, w, jet);
      ck_point(ph_vec3_normal(jet[2], jet[0]), ph_vec3_of(0, 0, 0), 1e-13);
      ck_point(w == 0 ? p[1] : p[2],
               w == 0 ? ph_s2_slerp(p[0], p[2], 0.5)
                      : ph_s2_slerp(p[1], p[3], 0.5),
               1e-15);
    }
    unit_sphere_free(&u);
  }
}
END_TEST

START_TEST(test_clamped) {
  struct unit_random r = unit_random_of(703);
  for (int t = 0; t < TRIALS; t++) {
    struct unit_sphere u;
    make(&r, unit_sphere_kinds[2], &u);
    u.data.end[0] = ph_vec3_scale(unit_random_in(&r, 0, 2), u.data.end[0]);
    ck_assert(ph_sphere_solve(&u.spline, &u.work));
    for (int w = 0; w < 2; w++) {
      size_t k = w == 0 ? 0 : N - 2;
      struct ph_spherical s = unit_sphere_segment(&u, k);
      ph_vec3 jet[2];
      ph_spherical_first(&s, w, jet);
      ck_point(jet[1], ph_vec3_scale(u.data.h[k], u.data.end[w]), 1e-13);
    }
    unit_sphere_free(&u);
  }
}
END_TEST

START_TEST(test_two_points) {
  const ph_vec3 p[2] = {{1, 0, 0}, {0, 0, 1}};
  for (size_t i = 0; i < 3; i++) {
    enum ph_sphere_ends ends = unit_sphere_kinds[i].ends;
    struct unit_sphere u;
    struct ph_spherical s;
    unit_sphere_of(&u, 2, p, false, ends, &ph_sphere_nielson);
    ck_assert(ph_sphere_solve(&u.spline, &u.work));
    s = unit_sphere_segment(&u, 0);
    if (ends == PH_SPHERE_NATURAL) {
      ck_point(s.p[1], ph_vec3_of(cos(PH_PI / 6), 0, 0.5), 1e-15);
      ck_point(s.p[2], ph_vec3_of(0.5, 0, cos(PH_PI / 6)), 1e-15);
    } else if (ends == PH_SPHERE_REST) {
      ck_point(s.p[1], p[0], 0);
      ck_point(s.p[2], p[1], 0);
    } else {
      double third = u.data.h[0] / 3;
      ph_vec3 v = ph_vec3_scale(third, u.data.end[0]);
      ck_point(s.p[1], ph_s2_exp(p[0], v), 1e-15);
      v = ph_vec3_scale(-third, u.data.end[1]);
      ck_point(s.p[2], ph_s2_exp(p[1], v), 1e-15);
    }
    unit_sphere_free(&u);
  }
}
END_TEST

/* Points of the equator give the equator, once around. */
START_TEST(test_equator) {
  struct unit_random r = unit_random_of(704);
  for (size_t n = 3; n <= 12; n++) {
    ph_vec3 p[12];
    struct unit_sphere u;
    double length = 0;
    for (size_t i = 0; i < n; i++) {
      double lon =
          2 * PH_PI * ((double)i + unit_random_in(&r, -0.2, 0.2)) / (double)n;
      p[i] = ph_vec3_of(cos(lon), sin(lon), 0);
    }
    unit_sphere_of(&u, n, p, true, PH_SPHERE_NATURAL, &ph_sphere_nielson);
    ck_assert(ph_sphere_solve(&u.spline, &u.work));
    for (size_t k = 0; k < n; k++) {
      struct ph_spherical s = unit_sphere_segment(&u, k);
      ck_abs(s.p[1].z, 0, 1e-15);
      ck_abs(s.p[2].z, 0, 1e-15);
      length += ph_spherical_length(&s, 1);
    }
    ck_rel(length, 2 * PH_PI, 1e-14);
    unit_sphere_free(&u);
  }
}
END_TEST

/* ---- starts -------------------------------------------------------------- */

static double missing(struct unit_sphere *u) {
  struct ph_sphere_range all = ph_sphere_all(&u->data);
  double largest = 0;
  for (size_t j = 0; j < all.count; j++) {
    size_t i = ph_sphere_node(&u->data, all, j);
    struct ph_sphere_part part[2];
    struct ph_block2_row row;
    const struct ph_sphere_model *model = u->spline.model;
    model->segment(&u->spline, ph_sphere_before(&u->data, i), false, &part[0]);
    model->segment(&u->spline, i, false, &part[1]);
    model->node(&u->spline, i, &part[0], &part[1], false, &row);
    largest = unit_larger(largest, hypot(row.f[0], row.f[1]));
  }
  return largest;
}

/* On a track that turns little from node to node, three Picard steps leave
 * next to nothing for Newton's iteration. */
START_TEST(test_picard) {
  enum { M = 32 };
  for (size_t which = 0; which < UNIT_SPHERE_KINDS; which++) {
    struct unit_sphere_kind kind = unit_sphere_kinds[which];
    ph_vec3 p[M];
    struct unit_sphere u;
    for (size_t i = 0; i < M; i++) {
      double lon = 2 * PH_PI * (double)i / M, lat = 0.3 * sin(2 * lon);
      p[i] = ph_vec3_of(cos(lat) * cos(lon), cos(lat) * sin(lon), sin(lat));
    }
    unit_sphere_of(&u, M, p, kind.closed, kind.ends, &ph_sphere_nielson);
    u.spline.model->hug(&u.spline);
    ck_assert_double_ge(missing(&u), 1e-2);
    ck_assert(u.spline.model->start(&u.spline, 0, &u.work));
    ck_assert_double_le(missing(&u), 1e-5);
    ck_assert(!u.spline.model->start(&u.spline, 2, &u.work));
    unit_sphere_free(&u);
  }
}
END_TEST

/* The sweeps find what Newton's iteration finds, if there is anything. */
START_TEST(test_last_resort) {
  struct unit_random r = unit_random_of(705);
  int found = 0;
  for (int t = 0; t < TRIALS; t++) {
    struct unit_sphere u, v;
    make(&r, unit_sphere_kinds[t % UNIT_SPHERE_KINDS], &u);
    unit_sphere_of(&v, N, u.data.p, u.data.closed, u.data.ends,
                   &ph_sphere_nielson);
    memcpy(v.data.h, u.data.h, u.data.m * sizeof *v.data.h);
    memcpy(v.spline.nu, u.spline.nu, N * sizeof *v.spline.nu);
    u.spline.model->start(&u.spline, 0, &u.work);
    if (v.spline.model->last_resort(&v.spline, &v.work)) {
      ck_assert(ph_sphere_newton(&u.spline, ph_sphere_all(&u.data), &u.work));
      ck_abs(unit_sphere_apart(&u, &v), 0, 1e-12);
      found++;
    }
    unit_sphere_free(&u);
    unit_sphere_free(&v);
  }
  ck_assert_int_ge(found, TRIALS * 9 / 10);
}
END_TEST

/* Of three nodes, with the middle control point near -P. */
START_TEST(test_antipode) {
  const ph_vec3 p[3] = {{0.6, -0.8, 0}, {1, 0, 0}, {0.6, 0.8, 0}};
  struct ph_sphere_part part[2];
  struct ph_block2_row row;
  struct unit_sphere u;
  unit_sphere_of(&u, 3, p, false, PH_SPHERE_REST, &ph_sphere_nielson);
  u.spline.model->hug(&u.spline);
  u.spline.x[1] = ph_vec3_of(-1 - cos(0.01), 0, sin(0.01));
  u.spline.model->segment(&u.spline, 0, false, &part[0]);
  u.spline.model->segment(&u.spline, 1, false, &part[1]);
  u.spline.model->node(&u.spline, 1, &part[0], &part[1], false, &row);
  ck_assert(hypot(row.f[0], row.f[1]) > 10);
  unit_sphere_free(&u);
}
END_TEST

static Suite *suite(void) {
  Suite *s = suite_create("sphere_nielson");
  TCase *tc = tcase_create("nielson");

  suite_add_tcase(s, tc);
  tcase_add_test(tc, test_formulas);
  tcase_add_test(tc, test_reference);
  tcase_add_test(tc, test_natural);
  tcase_add_test(tc, test_clamped);
  tcase_add_test(tc, test_two_points);
  tcase_add_test(tc, test_equator);
  tcase_add_test(tc, test_picard);
  tcase_add_test(tc, test_last_resort);
  tcase_add_test(tc, test_antipode);
  return s;
}

PH_TEST_MAIN(suite)
