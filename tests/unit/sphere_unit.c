/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Spherical splines for tests (see sphere_unit.h). */
#include "sphere_unit.h"

#include "kernel/pi.h"
#include "kernel/s2.h"

const struct unit_sphere_kind unit_sphere_kinds[UNIT_SPHERE_KINDS] = {
    {false, PH_SPHERE_NATURAL},
    {false, PH_SPHERE_REST},
    {false, PH_SPHERE_CLAMPED},
    {true, PH_SPHERE_NATURAL}};
/* ---- data and splines ---------------------------------------------------- */
void unit_sphere_of(struct unit_sphere *u, size_t n, const ph_vec3 *p,
                    bool closed, enum ph_sphere_ends ends,
                    const struct ph_sphere_model *model) {
  struct ph_sphere_data *d = &u->data;
  memset(u, 0, sizeof *u);
  d->closed = closed;
  d->ends = ends;
  d->n = n;
  d->m = closed ? n : n - 1;
  d->p = ph_arena_array(&u->arena, n, sizeof *d->p);
  d->e = ph_arena_array(&u->arena, n, sizeof *d->e);
  d->theta = ph_arena_array(&u->arena, n, sizeof *d->theta);
  d->h = ph_arena_array(&u->arena, n, sizeof *d->h);
  d->nu = ph_arena_array(&u->arena, n, sizeof *d->nu);
  ck_assert(d->p && d->e && d->theta && d->h && d->nu);
  for (size_t i = 0; i < n; i++) {
    d->p[i] = p[i];
    d->e[i] = ph_vec3_any_normal(p[i]);
    d->nu[i] = 0;
  }
  for (size_t k = 0; k < d->m; k++) {
    d->h[k] = d->theta[k] = ph_s2_angle(p[k], p[ph_sphere_next(d, k)]);
  }
  d->end[0] = ph_vec3_unit(
      ph_vec3_normal(ph_vec3_sub(p[1], ph_vec3_scale(0.2, p[n - 1])), p[0]));
  d->end[1] = ph_vec3_unit(ph_vec3_normal(
      ph_vec3_sub(ph_vec3_scale(0.2, p[0]), p[n - 2]), p[n - 1]));
  ck_assert(ph_sphere_spline_alloc(&u->spline, d, model, &u->arena));
  ck_assert(ph_sphere_work_alloc(&u->work, &u->arena, n));
}

void unit_sphere_free(struct unit_sphere *u) {
  ph_arena_free(&u->arena);
}

struct ph_spherical unit_sphere_segment(const struct unit_sphere *u, size_t k) {
  return ph_sphere_segment(&u->spline, k);
}

double unit_sphere_apart(const struct unit_sphere *a,
                         const struct unit_sphere *b) {
  double apart = 0;
  for (size_t k = 0; k < a->data.m; k++) {
    ph_vec3 r = ph_vec3_sub(a->spline.r[k], b->spline.r[k]);
    ph_vec3 l = ph_vec3_sub(a->spline.l[k], b->spline.l[k]);
    apart = unit_larger(apart, unit_larger(ph_vec3_abs(r), ph_vec3_abs(l)));
  }
  return apart;
}

/* Uniform on the sphere. */
static ph_vec3 random_point(struct unit_random *r) {
  double z = unit_random_in(r, -1, 1), lon = unit_random_in(r, 0, 2 * PH_PI);
  double rho = sqrt(1 - z * z);
  return ph_vec3_unit(ph_vec3_of(rho * cos(lon), rho * sin(lon), z));
}

void unit_sphere_path(struct unit_random *r, size_t n, double low, double high,
                      ph_vec3 *p) {
  p[0] = random_point(r);
  for (size_t i = 1; i < n; i++) {
    double turn = unit_random_in(r, 0, 2 * PH_PI);
    double angle = unit_random_in(r, low, high);
    ph_vec3 e = ph_vec3_any_normal(p[i - 1]);
    ph_vec3 v = ph_vec3_along(ph_vec3_scale(cos(turn), e), sin(turn),
                              ph_vec3_cross(p[i - 1], e));
    p[i] = ph_vec3_unit(ph_s2_exp(p[i - 1], ph_vec3_scale(angle, v)));
  }
}

void unit_sphere_any(struct unit_random *r, struct unit_sphere_kind kind,
                     const struct ph_sphere_model *model,
                     struct unit_sphere *u) {
  ph_vec3 p[UNIT_SPHERE_ANY];
  unit_sphere_path(r, UNIT_SPHERE_ANY, 0.1, 0.8, p);
  unit_sphere_of(u, UNIT_SPHERE_ANY, p, kind.closed, kind.ends, model);
  for (size_t i = 0; i < UNIT_SPHERE_ANY; i++) {
    u->spline.nu[i] = exp(unit_random_in(r, 1, 6));
  }
  for (size_t k = 0; k < u->data.m; k++) {
    u->data.h[k] *= exp(unit_random_in(r, -0.3, 0.3));
  }
}

/* ---- published cases ----------------------------------------------------- */

/* A spline of tests/vectors/sphere-iordanov.phv. */
struct reference {
  char name[16], model[16];
  struct unit_numbers points, tensions, left, right, speed;
};

static void read_word(struct unit_vectors *vectors, char *word, size_t size) {
  const char *text = unit_vectors_word(vectors);
  ck_assert(text && strlen(text) < size);
  memcpy(word, text, strlen(text) + 1);
}

static void read_list(struct unit_vectors *vectors, const char *name,
                      struct unit_numbers *numbers) {
  char word[16];
  read_word(vectors, word, sizeof word);
  ck_assert_str_eq(word, name);
  numbers->n = 0;
  unit_vectors_numbers(vectors, numbers);
}

/* The next one, with the points of its case; false at the end. */
static bool read_reference(struct unit_vectors *vectors, struct reference *r) {
  const char *word = unit_vectors_word(vectors);
  if (word && strcmp(word, "case") == 0) {
    read_word(vectors, r->name, sizeof r->name);
    read_list(vectors, "points", &r->points);
    word = unit_vectors_word(vectors);
  }
  if (!word) {
    return false;
  }
  ck_assert_str_eq(word, "spline");
  read_word(vectors, r->model, sizeof r->model);
  read_list(vectors, "tensions", &r->tensions);
  read_list(vectors, "left", &r->left);
  read_list(vectors, "right", &r->right);
  read_list(vectors, "speed", &r->speed);
  ck_assert(r->points.n == 3 * r->tensions.n && r->left.n > 0 &&
            r->left.n <= r->tensions.n - 2 && r->right.n == r->left.n &&
            r->speed.n == r->left.n);
  return true;
}

/* What rounding of control points does to the curvature at a node, where it is
 * a product with the normal of the first two, over the square of their angle.
 */
static double known(double angle) {
  return 5e-15 / (angle * angle * angle);
}

static void ck_reference(const struct reference *r,
                         const struct ph_sphere_model *model) {
  ph_vec3 p[UNIT_SPHERE_MAX];
  size_t n = r->tensions.n;
  struct unit_sphere u;
  ck_assert(n <= UNIT_SPHERE_MAX);
  for (size_t i = 0; i < n; i++) {
    p[i] = ph_vec3_unit(ph_vec3_get(&r->points.v[3 * i], 3));
  }
  unit_sphere_of(&u, n, p, false, PH_SPHERE_REST, model);
  memcpy(u.spline.nu, r->tensions.v, n * sizeof *u.spline.nu);
  ck_assert_msg(ph_sphere_solve(&u.spline, &u.work), "case %s", r->name);
  for (size_t i = 1; i <= r->left.n; i++) {
    struct ph_spherical before = unit_sphere_segment(&u, i - 1);
    struct ph_spherical after = unit_sphere_segment(&u, i);
    double left = ph_spherical_curvature_end(&before);
    double right = ph_spherical_curvature_start(&after);
    double angle = ph_s2_angle(after.p[0], after.p[1]);
    double back = ph_s2_angle(before.p[2], before.p[3]);
    ck_abs(left, r->left.v[i - 1], 1e-12 * fabs(left) + known(back));
    ck_abs(right, r->right.v[i - 1], 1e-12 * fabs(right) + known(angle));
    ck_abs(3 * angle / u.data.h[i], r->speed.v[i - 1], 3e-14);
  }
  unit_sphere_free(&u);
}

size_t unit_sphere_reference(const struct ph_sphere_model *model) {
  struct unit_vectors vectors =
      unit_vectors_open("tests/vectors/sphere-iordanov.phv");
  struct reference r = {0};
  size_t count = 0;
  while (read_reference(&vectors, &r)) {
    if (strcmp(r.model, model->name) == 0) {
      ck_reference(&r, model);
      count++;
    }
  }
  free(r.points.v);
  free(r.tensions.v);
  free(r.left.v);
  free(r.right.v);
  free(r.speed.v);
  free(vectors.text);
  return count;
}

/* ---- tensions that are raised -------------------------------------------- */

void unit_raise_of(struct unit_raise *t, size_t n, const ph_vec3 *p,
                   const struct unit_raise_kind *kind) {
  unit_sphere_of(&t->u, n, p, kind->closed, kind->ends, kind->model);
  ck_assert(ph_sphere_shape_of(&t->u.data, kind->epsilon, kind->legacy,
                               &t->u.arena, &t->shape));
  t->raise = (struct ph_sphere_raise){.shape = &t->shape,
                                      .increase = PH_SPHERE_MINIMAL,
                                      .spline = &t->u.spline,
                                      .work = &t->u.work};
  t->raise.ignored = ph_arena_array(&t->u.arena, n, 1);
  ck_assert_ptr_nonnull(t->raise.ignored);
  memset(t->raise.ignored, 0, n);
  ck_assert(ph_sphere_solve(&t->u.spline, &t->u.work));
}

void unit_raise_free(struct unit_raise *t) {
  unit_sphere_free(&t->u);
}

enum ph_status unit_raise_go(struct unit_raise *t) {
  return ph_sphere_keep_shape(&t->raise, &t->u.arena);
}

bool unit_raise_holds(const struct unit_raise *t) {
  const struct ph_sphere_data *d = &t->u.data;
  for (size_t i = 0; i < d->n; i++) {
    if (ph_sphere_node_fails(&t->shape, &t->u.spline, i) != PH_SPHERE_FINE) {
      return false;
    }
  }
  for (size_t k = 0; k < d->m; k++) {
    if (ph_sphere_segment_fails(&t->shape, &t->u.spline, k) != PH_SPHERE_FINE) {
      return false;
    }
  }
  return true;
}

double unit_raise_sum(const struct unit_raise *t) {
  double sum = 0;
  for (size_t i = 0; i < t->u.data.n; i++) {
    sum += t->u.spline.nu[i];
  }
  return sum;
}

double unit_raise_missing(struct unit_sphere *u) {
  const struct ph_sphere_model *model = u->spline.model;
  struct ph_sphere_range all = ph_sphere_all(&u->data);
  double worst = 0;
  for (size_t j = 0; j < all.count; j++) {
    size_t i = ph_sphere_node(&u->data, all, j);
    struct ph_sphere_part left, right;
    struct ph_block2_row row;
    model->segment(&u->spline, ph_sphere_before(&u->data, i), false, &left);
    model->segment(&u->spline, i, false, &right);
    model->node(&u->spline, i, &left, &right, false, &row);
    worst = unit_larger(worst, unit_larger(fabs(row.f[0]), fabs(row.f[1])));
  }
  return worst;
}

/* ---- data ---------------------------------------------------------------- */

void unit_raise_corners(struct unit_random *r, size_t n, ph_vec3 *p) {
  static const double turns[] = {0, 0, 0.8, -0.8, 0.3}, steps[] = {0.1, 0.3};
  ph_vec3 on = {0, 1, 0};
  p[0] = ph_vec3_of(1, 0, 0);
  for (size_t i = 1; i < n; i++) {
    ph_vec3 at = p[i - 1];
    double turn = turns[unit_random_below(r, 5)];
    double step = steps[unit_random_below(r, 2)];
    on = ph_vec3_along(ph_vec3_scale(cos(turn), on), sin(turn),
                       ph_vec3_cross(at, on));
    p[i] = ph_vec3_unit(
        ph_vec3_along(ph_vec3_scale(cos(step), at), sin(step), on));
    on = ph_vec3_along(ph_vec3_scale(cos(step), on), -sin(step), at);
    on = ph_vec3_unit(ph_vec3_normal(on, p[i]));
  }
}

void unit_raise_ring(struct unit_random *r, size_t n, double size, bool closed,
                     ph_vec3 *p) {
  double step = closed ? 2 * PH_PI / (double)n : 5 / (double)n;
  for (size_t i = 0; i < n; i++) {
    double lon = step * (double)i;
    p[i] = ph_vec3_unit(
        ph_vec3_of(cos(lon), sin(lon), unit_random_in(r, -size, size)));
  }
}
