/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The spline of global control points: its formulas as they are printed, the
 * published cases, the starts and the last resort. */
#include "sphere_unit.h"
#include "unit.h"

#include "kernel/pi.h"
#include "kernel/s2.h"

enum { N = UNIT_SPHERE_ANY, TRIALS = 100 };

/* x, anything near the data. */
static void shake(struct unit_random *r, struct unit_sphere *u) {
  static const double none[2] = {0, 0};
  const struct ph_sphere_model *model = u->spline.model;
  struct ph_sphere_range all = ph_sphere_all(&u->data);
  model->hug(&u->spline, ph_sphere_all(&u->data));
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
  ph_vec3 g = ph_s2_slerp(ph_sphere_segment(&u->spline, before).p[2],
                          ph_sphere_segment(&u->spline, i).p[1], a / (a + b));
  struct ph_block2_row row;
  double scale = -2 / (1 + ph_vec3_dot(g, p)) / size;
  u->spline.model->node(&u->spline, i, &part[0], &part[1], false, &row);
  ck_abs(row.f[0], scale * ph_vec3_dot(g, e), 1e-13 / size);
  ck_abs(row.f[1], scale * ph_vec3_triple(p, e, g), 1e-13 / size);
}

PH_TEST(test_formulas) {
  struct unit_random r = unit_random_of(701);
  for (int t = 0; t < TRIALS; t++) {
    struct ph_sphere_part part[N];
    struct unit_sphere u;
    unit_sphere_any(&r, unit_sphere_kinds[t % UNIT_SPHERE_KINDS],
                    &ph_sphere_nielson, &u);
    shake(&r, &u);
    for (size_t k = 0; k < u.data.m; k++) {
      ph_vec3 right, left;
      struct ph_spherical segment;
      u.spline.model->segment(&u.spline, k, false, &part[k]);
      by_formula(&u, k, &right, &left);
      segment = ph_sphere_segment(&u.spline, k);
      ck_point(segment.p[1], right, 1e-13);
      ck_point(segment.p[2], left, 1e-13);
    }
    for (size_t i = 1; i + 1 < N; i++) {
      ck_node(&u, i, &part[i - 1]);
    }
    unit_sphere_free(&u);
  }
}

PH_TEST(test_reference) {
  ck_assert_uint_eq(unit_sphere_reference(&ph_sphere_nielson), 28);
}

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
PH_TEST(test_picard) {
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
    u.spline.model->hug(&u.spline, ph_sphere_all(&u.data));
    ck_assert_double_ge(missing(&u), 1e-2);
    ck_assert(
        u.spline.model->start(&u.spline, ph_sphere_all(&u.data), 0, &u.work));
    ck_assert_double_le(missing(&u), 1e-5);
    ck_assert(
        !u.spline.model->start(&u.spline, ph_sphere_all(&u.data), 2, &u.work));
    unit_sphere_free(&u);
  }
}

/* The sweeps find what Newton's iteration finds, if there is anything. */
PH_TEST(test_last_resort) {
  struct unit_random r = unit_random_of(705);
  int found = 0;
  for (int t = 0; t < TRIALS; t++) {
    struct unit_sphere u, v;
    unit_sphere_any(&r, unit_sphere_kinds[t % UNIT_SPHERE_KINDS],
                    &ph_sphere_nielson, &u);
    unit_sphere_of(&v, N, u.data.p, u.data.closed, u.data.ends,
                   &ph_sphere_nielson);
    memcpy(v.data.h, u.data.h, u.data.m * sizeof *v.data.h);
    memcpy(v.spline.nu, u.spline.nu, N * sizeof *v.spline.nu);
    u.spline.model->start(&u.spline, ph_sphere_all(&u.data), 0, &u.work);
    if (v.spline.model->last_resort(&v.spline, ph_sphere_all(&v.data),
                                    &v.work)) {
      ck_assert(ph_sphere_newton(&u.spline, ph_sphere_all(&u.data), &u.work));
      ck_abs(unit_sphere_apart(&u, &v), 0, 1e-12);
      found++;
    }
    unit_sphere_free(&u);
    unit_sphere_free(&v);
  }
  ck_assert_int_ge(found, TRIALS * 9 / 10);
}

/* Of three nodes, with the middle control point near -P. */
PH_TEST(test_antipode) {
  const ph_vec3 p[3] = {{0.6, -0.8, 0}, {1, 0, 0}, {0.6, 0.8, 0}};
  struct ph_sphere_part part[2];
  struct ph_block2_row row;
  struct unit_sphere u;
  unit_sphere_of(&u, 3, p, false, PH_SPHERE_REST, &ph_sphere_nielson);
  u.spline.model->hug(&u.spline, ph_sphere_all(&u.data));
  u.spline.x[1] = ph_vec3_of(-1 - cos(0.01), 0, sin(0.01));
  u.spline.model->segment(&u.spline, 0, false, &part[0]);
  u.spline.model->segment(&u.spline, 1, false, &part[1]);
  u.spline.model->node(&u.spline, 1, &part[0], &part[1], false, &row);
  ck_assert(hypot(row.f[0], row.f[1]) > 10);
  unit_sphere_free(&u);
}

/* Of two nodes, with control points that are nearly antipodal: those of the
 * segment are at thirds, to the rounding of the great circle; nearer there are
 * no equations. */
PH_TEST_EACH(test_antipodal, 2) {
  const ph_vec3 p[2] = {{1, 0, 0}, {0, 1, 0}}, e = {0, 0.6, 0.8};
  const double off = _i == 0 ? 2.1e-3 : 1.9e-3, angle = PH_PI - off;
  struct ph_sphere_part part;
  struct unit_sphere u;
  unit_sphere_of(&u, 2, p, false, PH_SPHERE_NATURAL, &ph_sphere_nielson);
  u.spline.x[0] = ph_vec3_of(0, 0, 0);
  u.spline.x[1] = ph_vec3_sub(
      ph_vec3_along(ph_vec3_scale(-cos(off), p[0]), sin(off), e), p[1]);
  u.spline.model->segment(&u.spline, 0, true, &part);
  for (int w = 0; w < 2; w++) {
    double at = angle * (w + 1) / 3;
    ph_vec3 c = ph_vec3_add(p[w], part.f[w]);
    ck_assert_int_eq(isnan(c.x), _i);
    if (_i == 0) {
      ck_point(c, ph_vec3_along(ph_vec3_scale(cos(at), p[0]), sin(at), e),
               1e-12);
    }
  }
  unit_sphere_free(&u);
}
