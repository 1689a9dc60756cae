/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What holds of the spherical splines of both models: derivatives against
 * differences, ends, symmetries, ranges, tiny spacings, and which of random
 * data have a spline. */
#include "sphere_unit.h"
#include "spherical_unit.h"
#include "unit.h"

#include "kernel/pi.h"
#include "kernel/s2.h"

enum { N = UNIT_SPHERE_ANY, TRIALS = 50, MODELS = 2 };

static const struct ph_sphere_model *const models[MODELS] = {
    &ph_sphere_exact, &ph_sphere_nielson};
/* Every model with data of every kind, in turn. */
static const struct ph_sphere_model *model_of(int t) {
  return models[t % MODELS];
}

static struct unit_sphere_kind kind_of(int t) {
  return unit_sphere_kinds[t / MODELS % UNIT_SPHERE_KINDS];
}

static void ck_point(ph_vec3 a, ph_vec3 b, double tol) {
  ck_abs(ph_vec3_abs(ph_vec3_sub(a, b)), 0, tol);
}

static void solve(struct unit_sphere *u) {
  ck_assert(ph_sphere_solve(&u->spline, &u->work));
}

/* ---- derivatives --------------------------------------------------------- */

static void row_at(struct unit_sphere *u, size_t i, bool derivatives,
                   struct ph_block2_row *row) {
  const struct ph_sphere_model *model = u->spline.model;
  struct ph_sphere_part left, right;
  model->segment(&u->spline, ph_sphere_before(&u->data, i), derivatives, &left);
  model->segment(&u->spline, i, derivatives, &right);
  model->node(&u->spline, i, &left, &right, derivatives, row);
}

/* How the equation of node i changes with coordinate c of node j, by
 * differences of fourth order; out  column[2] */
static void differences(struct unit_sphere *u, size_t i, size_t j, int c,
                        double column[2]) {
  static const double weight[] = {1, -8, 8, -1};
  const double by = 1e-3;
  const ph_vec3 x = u->spline.x[j];
  column[0] = column[1] = 0;
  for (int k = 0; k < 4; k++) {
    double step[2] = {0, 0};
    struct ph_block2_row row;
    step[c] = (k < 2 ? k - 2 : k - 1) * by;
    u->spline.x[j] = u->spline.model->move(&u->spline, j, step);
    row_at(u, i, false, &row);
    u->spline.x[j] = x;
    /* row.f is what is missing: the derivatives are those of -f */
    column[0] -= weight[k] * row.f[0] / (12 * by);
    column[1] -= weight[k] * row.f[1] / (12 * by);
  }
}

static void ck_block(struct unit_sphere *u, size_t i, size_t j,
                     const double block[4]) {
  for (int c = 0; c < 2; c++) {
    double column[2];
    if (!ph_sphere_is_end(&u->data, j)) {
      differences(u, i, j, c, column);
      ck_abs(block[c], column[0], 1e-8 * (1 + fabs(block[c])));
      ck_abs(block[2 + c], column[1], 1e-8 * (1 + fabs(block[2 + c])));
    }
  }
}

PH_TEST(test_derivatives) {
  struct unit_random r = unit_random_of(721);
  for (int t = 0; t < TRIALS; t++) {
    struct unit_sphere u;
    struct ph_sphere_range all;
    unit_sphere_any(&r, kind_of(t), model_of(t), &u);
    u.spline.model->hug(&u.spline, ph_sphere_all(&u.data));
    all = ph_sphere_all(&u.data);
    for (size_t k = 0; k < all.count; k++) {
      size_t i = ph_sphere_node(&u.data, all, k);
      double step[2] = {unit_random_in(&r, -1, 1), unit_random_in(&r, -1, 1)};
      u.spline.x[i] = u.spline.model->move(&u.spline, i, step);
    }
    for (size_t k = 0; k < all.count; k++) {
      size_t i = ph_sphere_node(&u.data, all, k);
      struct ph_block2_row row;
      row_at(&u, i, true, &row);
      ck_block(&u, i, i > 0 ? i - 1 : N - 1, row.lo);
      ck_block(&u, i, i, row.di);
      ck_block(&u, i, ph_sphere_next(&u.data, i), row.up);
    }
    unit_sphere_free(&u);
  }
}

/* ---- ends ---------------------------------------------------------------- */

/* No covariant acceleration, no curvature, and the second control point the
 * midpoint of its neighbours. */
PH_TEST(test_natural) {
  struct unit_random r = unit_random_of(722);
  for (int t = 0; t < TRIALS; t++) {
    struct unit_sphere u;
    unit_sphere_any(&r, unit_sphere_kinds[0], model_of(t), &u);
    solve(&u);
    for (int w = 0; w < 2; w++) {
      struct ph_spherical s = unit_sphere_segment(&u, w == 0 ? 0 : N - 2);
      ph_vec3 jet[4], *p = w == 0 ? s.p : s.p + 1;
      double curvature = w == 0 ? ph_spherical_curvature_start(&s)
                                : ph_spherical_curvature_end(&s);
      double speed;
      ph_spherical_jet(&s, w, jet);
      speed = ph_vec3_abs(jet[1]);
      ck_point(ph_vec3_normal(jet[2], jet[0]), ph_vec3_of(0, 0, 0), 1e-13);
      ck_abs(curvature, 0, 1e-14 / (speed * speed));
      ck_point(p[1], ph_s2_slerp(p[0], p[2], 0.5), 1e-15);
    }
    unit_sphere_free(&u);
  }
}

PH_TEST(test_clamped) {
  struct unit_random r = unit_random_of(723);
  for (int t = 0; t < TRIALS; t++) {
    struct unit_sphere u;
    unit_sphere_any(&r, unit_sphere_kinds[2], model_of(t), &u);
    u.data.end[0] = ph_vec3_scale(unit_random_in(&r, 0, 2), u.data.end[0]);
    solve(&u);
    for (int w = 0; w < 2; w++) {
      size_t k = w == 0 ? 0 : N - 2;
      struct ph_spherical s = unit_sphere_segment(&u, k);
      ph_vec3 jet[4];
      ph_spherical_jet(&s, w, jet);
      ck_point(jet[1], ph_vec3_scale(u.data.h[k], u.data.end[w]), 1e-13);
    }
    unit_sphere_free(&u);
  }
}

static void ck_two_points(enum ph_sphere_ends ends,
                          const struct ph_sphere_model *model) {
  const ph_vec3 p[2] = {{1, 0, 0}, {0, 0, 1}};
  ph_vec3 inner[2] = {p[0], p[1]};
  struct unit_sphere u;
  unit_sphere_of(&u, 2, p, false, ends, model);
  solve(&u);
  for (int w = 0; w < 2; w++) {
    double third = (w == 0 ? 1 : -1) * u.data.h[0] / 3;
    if (ends == PH_SPHERE_CLAMPED) {
      inner[w] = ph_s2_exp(p[w], ph_vec3_scale(third, u.data.end[w]));
    } else if (ends == PH_SPHERE_NATURAL) {
      inner[w] = ph_s2_slerp(p[w], p[1 - w], 1 / 3.0);
    }
  }
  ck_point(ph_sphere_segment(&u.spline, 0).p[1], inner[0], 1e-15);
  ck_point(ph_sphere_segment(&u.spline, 0).p[2], inner[1], 1e-15);
  unit_sphere_free(&u);
}

PH_TEST(test_two_points) {
  for (int model = 0; model < MODELS; model++) {
    ck_two_points(PH_SPHERE_NATURAL, models[model]);
    ck_two_points(PH_SPHERE_REST, models[model]);
    ck_two_points(PH_SPHERE_CLAMPED, models[model]);
  }
}

/* ---- symmetries ---------------------------------------------------------- */

/* Points of the equator give the equator, once around. */
PH_TEST(test_equator) {
  struct unit_random r = unit_random_of(724);
  for (size_t n = 4; n <= 12; n++) {
    ph_vec3 p[12];
    struct unit_sphere u;
    double length = 0;
    for (size_t i = 0; i < n; i++) {
      double lon =
          2 * PH_PI * ((double)i + unit_random_in(&r, -0.2, 0.2)) / (double)n;
      p[i] = ph_vec3_of(cos(lon), sin(lon), 0);
    }
    unit_sphere_of(&u, n, p, true, PH_SPHERE_NATURAL, model_of((int)n));
    solve(&u);
    for (size_t k = 0; k < n; k++) {
      struct ph_spherical s = unit_sphere_segment(&u, k);
      ck_abs(s.p[1].z, 0, 1e-15);
      ck_abs(s.p[2].z, 0, 1e-15);
      length += unit_spherical_length(&s);
    }
    ck_rel(length, 2 * PH_PI, 1e-14);
    unit_sphere_free(&u);
  }
}

/* The same data from another node on. */
PH_TEST(test_start_index) {
  struct unit_random r = unit_random_of(725);
  for (int t = 0; t < TRIALS; t++) {
    struct unit_sphere u, v;
    ph_vec3 p[N];
    size_t from = 1 + unit_random_below(&r, N - 1);
    unit_sphere_any(&r, unit_sphere_kinds[3], model_of(t), &u);
    for (size_t i = 0; i < N; i++) {
      p[i] = u.data.p[(i + from) % N];
    }
    unit_sphere_of(&v, N, p, true, PH_SPHERE_NATURAL, model_of(t));
    for (size_t i = 0; i < N; i++) {
      v.data.h[i] = u.data.h[(i + from) % N];
      v.spline.nu[i] = u.spline.nu[(i + from) % N];
    }
    if (ph_sphere_solve(&u.spline, &u.work)) {
      solve(&v);
      for (size_t i = 0; i < N; i++) {
        ck_point(v.spline.r[i], u.spline.r[(i + from) % N], 1e-12);
        ck_point(v.spline.l[i], u.spline.l[(i + from) % N], 1e-12);
      }
    } else {
      ck_assert_ptr_eq(model_of(t), &ph_sphere_nielson);
    }
    unit_sphere_free(&u);
    unit_sphere_free(&v);
  }
}

/* Rotated or, with sign = -1, mirrored. */
static ph_vec3 turned(const ph_vec3 axes[3], double sign, ph_vec3 v) {
  ph_vec3 a = ph_vec3_along(ph_vec3_scale(v.x, axes[0]), v.y, axes[1]);
  return ph_vec3_along(a, sign * v.z, axes[2]);
}

/* The spline of u's data, turned; or, with axes NULL, in reverse order. */
static void make_image(const struct unit_sphere *u, const ph_vec3 axes[3],
                       double sign, struct unit_sphere *v) {
  const struct ph_sphere_data *d = &u->data;
  ph_vec3 p[N];
  for (size_t i = 0; i < N; i++) {
    p[i] = axes ? turned(axes, sign, d->p[i]) : d->p[N - 1 - i];
  }
  unit_sphere_of(v, N, p, d->closed, d->ends, u->spline.model);
  for (size_t i = 0; i < N; i++) {
    v->spline.nu[i] = u->spline.nu[axes ? i : N - 1 - i];
  }
  for (size_t k = 0; k < d->m; k++) {
    /* reversed, the closing segment of closed data stays the last one */
    v->data.h[k] = d->h[axes || k == N - 1 ? k : N - 2 - k];
  }
  for (int w = 0; w < 2; w++) {
    v->data.end[w] =
        axes ? turned(axes, sign, d->end[w]) : ph_vec3_scale(-1, d->end[1 - w]);
  }
}

PH_TEST(test_rotation) {
  struct unit_random r = unit_random_of(726);
  for (int t = 0; t < TRIALS; t++) {
    struct unit_sphere u, v;
    ph_vec3 axes[3], pair[2];
    double sign = t % 3 == 0 ? -1 : 1;
    unit_sphere_any(&r, kind_of(t), model_of(t), &u);
    unit_sphere_path(&r, 2, 1, 1, pair);
    axes[0] = pair[0];
    axes[1] = ph_vec3_unit(ph_vec3_normal(pair[1], pair[0]));
    axes[2] = ph_vec3_cross(axes[0], axes[1]);
    make_image(&u, axes, sign, &v);
    if (ph_sphere_solve(&u.spline, &u.work)) {
      solve(&v);
      for (size_t k = 0; k < u.data.m; k++) {
        ck_point(v.spline.r[k], turned(axes, sign, u.spline.r[k]), 1e-12);
        ck_point(v.spline.l[k], turned(axes, sign, u.spline.l[k]), 1e-12);
      }
    } else {
      ck_assert_ptr_eq(model_of(t), &ph_sphere_nielson);
    }
    unit_sphere_free(&u);
    unit_sphere_free(&v);
  }
}

PH_TEST(test_reversal) {
  struct unit_random r = unit_random_of(727);
  for (int t = 0; t < TRIALS; t++) {
    struct unit_sphere u, v;
    unit_sphere_any(&r, kind_of(t), model_of(t), &u);
    make_image(&u, NULL, 1, &v);
    if (ph_sphere_solve(&u.spline, &u.work)) {
      solve(&v);
      for (size_t k = 0; k < u.data.m; k++) {
        size_t j = k == N - 1 ? k : N - 2 - k;
        ck_point(v.spline.r[j], u.spline.l[k], 1e-12);
        ck_point(v.spline.l[j], u.spline.r[k], 1e-12);
      }
    } else {
      ck_assert_ptr_eq(model_of(t), &ph_sphere_nielson);
    }
    unit_sphere_free(&u);
    unit_sphere_free(&v);
  }
}

/* ---- the iteration ------------------------------------------------------- */

/* Part of a spline, also across the first node of closed data, is found again
 * while the rest stands still. */
PH_TEST(test_range) {
  struct unit_random r = unit_random_of(728);
  for (int t = 0; t < TRIALS; t++) {
    struct unit_sphere u;
    ph_vec3 x[N];
    struct ph_sphere_range range;
    unit_sphere_any(&r, kind_of(t), model_of(t), &u);
    range.count = 1 + unit_random_below(&r, N - 2);
    range.first = u.data.closed
                      ? unit_random_below(&r, N)
                      : 1 + unit_random_below(&r, N - 1 - range.count);
    if (ph_sphere_solve(&u.spline, &u.work)) {
      memcpy(x, u.spline.x, sizeof x);
      for (size_t j = 0; j < range.count; j++) {
        size_t i = ph_sphere_node(&u.data, range, j);
        double step[2] = {unit_random_in(&r, -0.02, 0.02),
                          unit_random_in(&r, -0.02, 0.02)};
        u.spline.x[i] = u.spline.model->move(&u.spline, i, step);
      }
      ck_assert(ph_sphere_newton(&u.spline, range, &u.work));
      for (size_t i = 0; i < N; i++) {
        size_t j = i >= range.first ? i - range.first : i + N - range.first;
        ck_point(u.spline.x[i], x[i], j < range.count ? 1e-12 : 0);
      }
    } else {
      ck_assert_ptr_eq(model_of(t), &ph_sphere_nielson);
    }
    unit_sphere_free(&u);
  }
}

/* Tiny spacings: equations hold to rounding of the spacing, and both models
 * come to the spline of the plane. */
PH_TEST(test_tiny) {
  static const double sizes[] = {1e-3, 1e-5, 1e-7};
  struct unit_random r = unit_random_of(729);
  for (int t = 0; t < TRIALS; t++) {
    double size = sizes[t % 3];
    struct unit_sphere_kind kind = unit_sphere_kinds[t % UNIT_SPHERE_KINDS];
    struct unit_sphere u, v;
    ph_vec3 p[N];
    unit_sphere_path(&r, N, 0.5 * size, size, p);
    unit_sphere_of(&u, N, p, kind.closed, kind.ends, models[0]);
    unit_sphere_of(&v, N, p, kind.closed, kind.ends, models[1]);
    solve(&u);
    solve(&v);
    ck_assert_double_le(u.work.residual, 1e-14);
    ck_assert_double_le(v.work.residual, 1e-14);
    ck_abs(unit_sphere_apart(&u, &v), 0, 10 * size * size * size + 1e-15);
    unit_sphere_free(&u);
    unit_sphere_free(&v);
  }
}

/* Where the iteration finds no spline, nothing has moved. */
PH_TEST(test_none) {
  struct unit_random r = unit_random_of(730);
  int none = 0;
  for (int t = 0; t < TRIALS; t++) {
    ph_vec3 p[N], x[N];
    struct unit_sphere u;
    unit_sphere_path(&r, N, 2, 3, p);
    unit_sphere_of(&u, N, p, false, PH_SPHERE_REST, &ph_sphere_nielson);
    u.spline.model->start(&u.spline, ph_sphere_all(&u.data), 0, &u.work);
    memcpy(x, u.spline.x, sizeof x);
    if (!ph_sphere_newton(&u.spline, ph_sphere_all(&u.data), &u.work)) {
      ck_assert_mem_eq(x, u.spline.x, sizeof x);
      none++;
    }
    unit_sphere_free(&u);
  }
  ck_assert_int_gt(none, 0);
}

/* ---- random data --------------------------------------------------------- */

/* How many of `count` random paths of 8 points have a spline without tension;
 * what is found is one. */
static int solved(uint64_t stream, int count, double low, double high,
                  const struct ph_sphere_model *model) {
  struct unit_random r = unit_random_of(stream);
  int found = 0;
  for (int t = 0; t < count; t++) {
    enum { M = 8 };
    ph_vec3 p[M];
    struct unit_sphere u;
    unit_sphere_path(&r, M, low, high, p);
    unit_sphere_of(&u, M, p, false, PH_SPHERE_NATURAL, model);
    if (ph_sphere_solve(&u.spline, &u.work)) {
      found++;
      for (size_t i = 1; i + 1 < M; i++) {
        double a = u.data.h[i - 1], b = u.data.h[i];
        ph_vec3 l = ph_sphere_segment(&u.spline, i - 1).p[2];
        ph_vec3 rr = ph_sphere_segment(&u.spline, i).p[1];
        ph_vec3 in = ph_s2_log(p[i], l), out = ph_s2_log(p[i], rr);
        /* C1 through the point */
        ck_point(ph_vec3_scale(-1 / a, in), ph_vec3_scale(1 / b, out),
                 1e-10 / fmin(a, b));
      }
    }
    unit_sphere_free(&u);
  }
  return found;
}

/* What other tensions make of a spline, to first order: all but 0.02 theta^2 of
 * it, by how much they differ; 0.2 theta^2 with derivatives of the plane. */
PH_TEST_EACH(test_response, 3) {
  enum { M = 12 };
  static const double theta[] = {0.1, 1e-2, 1e-4}, part[] = {0.02, 0.02, 0.2};
  struct unit_random r = unit_random_of(739);
  struct ph_sphere_response response;
  struct unit_sphere u;
  ph_vec3 p[M], x[M];
  double change = 0, miss = 0;
  unit_sphere_path(&r, M, theta[_i] / 2, theta[_i], p);
  unit_sphere_of(&u, M, p, false, PH_SPHERE_NATURAL, &ph_sphere_exact);
  u.spline.nu[3] = 20 / theta[_i];
  solve(&u);
  memcpy(x, u.spline.x, sizeof x);
  ck_assert(ph_sphere_response_alloc(&response, &unit_arena, M));
  ph_sphere_response_of(&u.spline, ph_sphere_all(&u.data), &response);
  u.spline.nu[3] = 3 / theta[_i];
  u.spline.nu[5] = 50 / theta[_i];
  ph_sphere_respond(&u.spline, &response, 0, M - 2, &u.work);
  for (size_t i = 0; i < M; i++) {
    change = fmax(change, ph_vec3_abs(ph_vec3_sub(u.spline.x[i], x[i])));
    x[i] = u.spline.x[i];
  }
  ck_assert(change > 0.1);
  ck_assert(ph_sphere_newton(&u.spline, ph_sphere_all(&u.data), &u.work));
  for (size_t i = 0; i < M; i++) {
    miss = fmax(miss, ph_vec3_abs(ph_vec3_sub(u.spline.x[i], x[i])));
  }
  ck_abs(miss, 0, (part[_i] * theta[_i] * theta[_i] + 1e-13) * change);
  unit_sphere_free(&u);
}

PH_TEST(test_random) {
  int count = unit_count(1000), few = unit_count(200);
  ck_assert_int_eq(solved(731, count, 0.1, PH_PI / 2, models[0]), count);
  ck_assert_int_eq(solved(732, count, 0.5, 2.2, models[0]), count);
  ck_assert_int_ge(solved(733, few, 2, 3, models[0]), few * 19 / 20);
  ck_assert_int_eq(solved(734, few, 0.1, 0.8, models[1]), few);
  ck_assert_int_ge(solved(735, few, 0.1, PH_PI / 2, models[1]), few * 3 / 4);
}
