/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The ways to a spline when Newton's iteration alone does not lead there: each
 * by itself, with models that block or count the others. */
#include "sphere_unit.h"
#include "unit.h"

/* Data of N nodes far apart; of 60 from this generator about 25 are beyond
 * Newton's iteration, whatever PH_SEED is. */
enum { N = 6, DATA = 60, STREAM = 1031 };

/* How often the functions of a model were called. */
static size_t starts, hugs, resorts;

static bool start(struct ph_sphere_spline *s, struct ph_sphere_range range,
                  size_t which, struct ph_sphere_work *work) {
  starts++;
  return ph_sphere_exact.start(s, range, which, work);
}

static bool start_once(struct ph_sphere_spline *s, struct ph_sphere_range range,
                       size_t which, struct ph_sphere_work *work) {
  return starts++ == 0 && ph_sphere_exact.start(s, range, which, work);
}

static void hug(struct ph_sphere_spline *s, struct ph_sphere_range range) {
  hugs++;
  ph_sphere_exact.hug(s, range);
}

static void hug_nothing(struct ph_sphere_spline *s,
                        struct ph_sphere_range range) {
  hugs++;
  for (size_t j = 0; j < range.count; j++) {
    s->x[ph_sphere_node(s->data, range, j)].x = (double)NAN;
  }
}

static bool resort(struct ph_sphere_spline *s, struct ph_sphere_range range,
                   struct ph_sphere_work *work) {
  resorts++;
  return ph_sphere_nielson.last_resort(s, range, work);
}

static struct ph_sphere_model
exact_of(bool (*start_of)(struct ph_sphere_spline *, struct ph_sphere_range,
                          size_t, struct ph_sphere_work *),
         void (*hug_of)(struct ph_sphere_spline *, struct ph_sphere_range)) {
  struct ph_sphere_model model = ph_sphere_exact;
  model.start = start_of;
  model.hug = hug_of;
  return model;
}

static void data_of(struct unit_random *r, double low, double high,
                    const struct ph_sphere_model *model,
                    struct unit_sphere *u) {
  ph_vec3 p[N];
  unit_sphere_path(r, N, low, high, p);
  unit_sphere_of(u, N, p, true, PH_SPHERE_NATURAL, model);
}

static bool is_easy(struct unit_sphere *u) {
  struct ph_sphere_range all = ph_sphere_all(&u->data);
  ph_sphere_exact.start(&u->spline, all, 0, &u->work);
  return ph_sphere_newton(&u->spline, all, &u->work);
}

/* How many data that are not easy are solved; out  hard: how many there are */
static size_t solve_hard(const struct ph_sphere_model *model, size_t data,
                         size_t *hard) {
  struct unit_random r = {STREAM};
  size_t solved = 0;
  *hard = 0;
  for (size_t t = 0; t < data; t++) {
    struct unit_sphere u;
    data_of(&r, 2.6, 3.13, model, &u);
    for (size_t i = 0; i < N; i++) {
      u.spline.nu[i] = 1e-3 * (double)i;
    }
    if (!is_easy(&u)) {
      ++*hard;
      starts = hugs = 0;
      solved += ph_sphere_solve(&u.spline, &u.work);
      for (size_t i = 0; i < N; i++) {
        ck_rel(u.spline.nu[i], 1e-3 * (double)i, 0);
      }
    }
    unit_sphere_free(&u);
  }
  return solved;
}

/* ---- tests --------------------------------------------------------------- */

PH_TEST(test_easy) {
  struct unit_random r = {1};
  struct ph_sphere_model model = exact_of(start, hug);
  for (int t = 0; t < 20; t++) {
    struct unit_sphere u;
    data_of(&r, 0.1, 0.8, &model, &u);
    starts = hugs = 0;
    ck_assert(ph_sphere_solve(&u.spline, &u.work));
    ck_assert_uint_eq(starts, 1);
    ck_assert_uint_eq(hugs, 0);
    unit_sphere_free(&u);
  }
}

PH_TEST(test_continuation) {
  struct ph_sphere_model model = exact_of(start_once, hug);
  size_t hard, solved = solve_hard(&model, DATA, &hard);
  ck_assert_uint_ge(hard, 20);
  ck_assert_uint_ge(solved, hard * 3 / 4);
  ck_assert_uint_eq(hugs, 1);
}

PH_TEST(test_relaxation) {
  struct ph_sphere_model model = exact_of(start, hug_nothing);
  size_t hard, solved = solve_hard(&model, (size_t)unit_count(DATA), &hard);
  ck_assert_uint_ge(hard, 1);
  ck_assert_uint_ge(solved, hard * 9 / 10);
  ck_assert_uint_eq(hugs, 1);
  ck_assert_uint_ge(starts, 2);
}

/* Both together find all; the equations hold, and no leg goes round. */
PH_TEST(test_all) {
  struct unit_random r = {STREAM};
  size_t data = (size_t)unit_count(DATA);
  for (size_t t = 0; t < data; t++) {
    struct unit_sphere u;
    data_of(&r, 2.6, 3.13, &ph_sphere_exact, &u);
    ck_assert_msg(ph_sphere_solve(&u.spline, &u.work), "data %zu", t);
    ck_abs(unit_raise_missing(&u), 0, 1e-12);
    for (size_t k = 0; k < u.data.m; k++) {
      struct ph_spherical s = unit_sphere_segment(&u, k);
      size_t next = ph_sphere_next(&u.data, k);
      double third = u.data.h[k] / 3;
      ck_assert(third * ph_vec3_abs(u.spline.x[k]) < 3);
      ck_assert(third * ph_vec3_abs(u.spline.x[next]) < 3);
      for (size_t j = 0; j < 4; j++) {
        ck_abs(ph_vec3_abs(s.p[j]), 1, 1e-14);
      }
    }
    unit_sphere_free(&u);
  }
}

/* Where a leg goes nearly round the sphere or farther there are no equations:
 * an iteration that begins there is over, with everything as it was. */
PH_TEST(test_legs) {
  struct unit_random r = {7};
  for (int t = 0; t < 30; t++) {
    struct unit_sphere u;
    ph_vec3 far;
    data_of(&r, 0.5, 1.5, &ph_sphere_exact, &u);
    ck_assert(ph_sphere_solve(&u.spline, &u.work));
    far = ph_vec3_scale(unit_random_in(&r, 9.1, 18) /
                            fmax(u.data.h[1], u.data.h[2]),
                        ph_vec3_unit(u.spline.x[2]));
    u.spline.x[2] = far;
    ck_assert(!ph_sphere_newton(&u.spline, ph_sphere_all(&u.data), &u.work));
    ck_abs(ph_vec3_abs(ph_vec3_sub(u.spline.x[2], far)), 0, 0);
    unit_sphere_free(&u);
  }
}

/* Many nodes far apart, where Newton's iteration on all of them fails: block by
 * block, with tensions where there is no spline without.  Afterwards it is at
 * rest on the whole. */
PH_TEST(test_blocks) {
  enum { MANY = 120 };
  struct unit_random r = {11};
  for (int t = 0; t < 4; t++) {
    bool closed = t % 2 == 1;
    struct unit_sphere u;
    ph_vec3 p[MANY];
    struct ph_sphere_range all;
    size_t before;
    unit_sphere_path(&r, MANY, 0.9, 3.1, p);
    unit_sphere_of(&u, MANY, p, closed, PH_SPHERE_NATURAL,
                   t < 2 ? &ph_sphere_exact : &ph_sphere_nielson);
    all = ph_sphere_all(&u.data);
    ck_assert(t >= 2 || !is_easy(&u));
    ck_assert(ph_sphere_solve_tense(&u.spline, &u.work));
    before = u.work.iterations;
    ck_assert(ph_sphere_newton(&u.spline, all, &u.work));
    ck_assert_uint_le(u.work.iterations - before, 1);
    ck_assert(u.work.residual <= 1e-12);
    for (size_t i = 0; i < MANY; i++) {
      ck_assert(u.spline.nu[i] >= 0 && isfinite(u.spline.nu[i]));
    }
    unit_sphere_free(&u);
  }
}

/* Everything is tried, once, and the tensions are as they were. */
PH_TEST(test_none) {
  struct unit_random r = {STREAM};
  struct ph_sphere_model model = ph_sphere_nielson;
  size_t failed = 0, most = 5000;
  model.last_resort = resort;
  for (int t = 0; t < unit_count(20); t++) {
    struct unit_sphere u;
    data_of(&r, 2.6, 3.13, &model, &u);
    u.spline.nu[1] = 0.25;
    resorts = 0;
    if (!ph_sphere_solve(&u.spline, &u.work)) {
      failed++;
      ck_assert_uint_eq(resorts, 1);
    }
    ck_assert_uint_lt(u.work.iterations, most);
    ck_rel(u.spline.nu[1], 0.25, 0);
    unit_sphere_free(&u);
  }
  ck_assert_uint_ge(failed, 1);
}
