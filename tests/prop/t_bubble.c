/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Properties of surfaces over random closed meshes, boxes and tori with noise:
 * that there is one of each continuity, which its certificate accepts; that it
 * is the same where the data are turned, scaled, or numbered otherwise,
 * or faces go round the other way.
 *
 * The seed is 1, or PH_SEED; PH_LONG=1 takes ten times as many meshes.
 */
#include "motion.h"
#include "problem_unit.h"
#include "unit.h"

#include "kernel/pi.h"
#include "solve/method.h"

enum { ROUND = 8, ACROSS = 6, FACES = ROUND * ACROSS };

struct mesh {
  size_t points_n, faces_n;
  ph_vec3 p[FACES + 2];
  size_t corner[FACES][4];
};

static struct unit_solution one, other;
static struct mesh data, image;

static void finish(void) {
  unit_solution_free(&one);
  unit_solution_free(&other);
}

PH_FIXTURE(NULL, finish)

/* ---- data ---------------------------------------------------------------- */

static ph_vec3 any(struct unit_random *r, double size) {
  const double x = unit_random_in(r, -size, size);
  const double y = unit_random_in(r, -size, size);
  return ph_vec3_of(x, y, unit_random_in(r, -size, size));
}

static void torus(struct mesh *m) {
  m->points_n = m->faces_n = FACES;
  for (size_t f = 0; f < FACES; f++) {
    const size_t i = f / ACROSS, j = f % ACROSS;
    const size_t far = (i + 1) % ROUND * ACROSS, next = (j + 1) % ACROSS;
    const double u = 2 * PH_PI * (double)i / ROUND;
    const double v = 2 * PH_PI * (double)j / ACROSS;
    const size_t corner[] = {f, far + j, far + next, i * ACROSS + next};
    m->p[f] = ph_vec3_of((3 + cos(v)) * cos(u), (3 + cos(v)) * sin(u), sin(v));
    memcpy(m->corner[f], corner, sizeof corner);
  }
}

static void cube(struct mesh *m) {
  static const size_t corner[][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                     {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  m->points_n = 8;
  m->faces_n = 6;
  for (size_t i = 0; i < 8; i++) {
    m->p[i] = ph_vec3_of(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
  }
  memcpy(m->corner, corner, sizeof corner);
}

static void scatter(struct unit_random *r, double noise, struct mesh *m) {
  (unit_random_below(r, 2) ? torus : cube)(m);
  for (size_t i = 0; i < m->points_n; i++) {
    m->p[i] = ph_vec3_add(m->p[i], any(r, noise));
  }
}

static enum ph_status solve(struct unit_solution *s, const struct mesh *m,
                            double continuity) {
  enum ph_status status;
  size_t *sizes;
  double *corner, *x;
  unit_solution_free(s);
  x = unit_numbers(s, 3 * m->points_n);
  corner = unit_numbers(s, 4 * m->faces_n);
  sizes = ph_arena_array(&s->arena, m->faces_n, sizeof *sizes);
  ck_assert_ptr_nonnull(sizes);
  for (size_t i = 0; i < m->points_n; i++) {
    ph_vec3_put(m->p[i], 3, x + 3 * i);
  }
  for (size_t i = 0; i < 4 * m->faces_n; i++) {
    corner[i] = (double)m->corner[i / 4][i % 4];
    sizes[i / 4] = 4;
  }
  unit_set_array(&s->problem, PH_F_POINTS, x, m->points_n, 3);
  s->problem.field[PH_F_FACES] = (struct ph_value){.kind = PH_LISTS,
                                                   .v = corner,
                                                   .n = 4 * m->faces_n,
                                                   .dimension = 1,
                                                   .sizes = sizes,
                                                   .sizes_n = m->faces_n};
  unit_set_number(&s->problem, PH_F_CONTINUITY, continuity);
  status = unit_solve(&ph_method_bubble, s);
  return status == PH_OK ? unit_certify("bubble", s) : status;
}

/* ---- surfaces ------------------------------------------------------------ */

static double found(const struct unit_solution *s, enum ph_diagnostic which) {
  return unit_diagnostic(&s->result.diagnostics, which);
}

static void ck_sound(const struct unit_solution *s, double continuity) {
  ck_that(found(s, PH_D_NORMAL_JUMP) <= 1e-6, "seed %lu: normals jump by %.3g",
          unit_seed(), found(s, PH_D_NORMAL_JUMP));
  ck_that(continuity < 2 || found(s, PH_D_CURVATURE_JUMP) <= 1e-3,
          "seed %lu: curvatures jump by %.3g", unit_seed(),
          found(s, PH_D_CURVATURE_JUMP));
  ck_that(found(s, PH_D_CONTINUITY_ERROR) <= 1e-12 &&
              found(s, PH_D_INTERPOLATION_ERROR) <= 1e-12,
          "seed %lu: gaps of %.3g, points missed by %.3g", unit_seed(),
          found(s, PH_D_CONTINUITY_ERROR), found(s, PH_D_INTERPOLATION_ERROR));
}

/* Some 27 faces each. */
PH_TEST_EACH(test_any_mesh, 2) {
  struct unit_random r = unit_random_of((uint64_t)_i + 1);
  const double continuity = _i + 1;
  const size_t n = unit_cases(200);
  for (size_t i = 0; i < n; i++) {
    enum ph_status status;
    unit_case("G%d, mesh %zu", _i + 1, i);
    scatter(&r, 0.05, &data);
    status = solve(&one, &data, continuity);
    ck_that(status == PH_OK, "seed %lu: %s", unit_seed(), one.diag.message);
    ck_sound(&one, continuity);
  }
}

/* ---- what does not change ------------------------------------------------ */

/* How points and faces are numbered in the image, the first corner of each
 * face, and whether it goes round the other way. */
struct order {
  size_t point[FACES + 2], face[FACES], first[FACES];
  bool back[FACES];
};

static void keep(struct order *o) {
  for (size_t i = 0; i < FACES; i++) {
    o->point[i] = o->face[i] = i;
    o->first[i] = 0;
    o->back[i] = false;
  }
}

static void shuffle(struct unit_random *r, size_t n, size_t *v) {
  for (size_t i = n; i > 1; i--) {
    const size_t j = unit_random_below(r, i), kept = v[i - 1];
    v[i - 1] = v[j];
    v[j] = kept;
  }
}

static void make_image(const struct motion *m, const struct order *o) {
  image.points_n = data.points_n;
  image.faces_n = data.faces_n;
  for (size_t i = 0; i < data.points_n; i++) {
    image.p[o->point[i]] = moved(m, data.p[i]);
  }
  for (size_t i = 0; i < 4 * data.faces_n; i++) {
    const size_t f = i / 4, k = (i + o->first[f]) % 4;
    const size_t to = o->back[f] ? 3 - i % 4 : i % 4;
    image.corner[o->face[f]][to] = o->point[data.corner[f][k]];
  }
}

static void any_turn(struct unit_random *r, struct motion *m, struct order *o) {
  (void)o;
  turn(r, m);
}

static void any_scale(struct unit_random *r, struct motion *m,
                      struct order *o) {
  (void)o;
  m->scale = pow(10, unit_random_in(r, -9, 9));
}

static void any_points(struct unit_random *r, struct motion *m,
                       struct order *o) {
  (void)m;
  shuffle(r, data.points_n, o->point);
}

static void any_faces(struct unit_random *r, struct motion *m,
                      struct order *o) {
  (void)m;
  shuffle(r, data.faces_n, o->face);
}

static void any_first(struct unit_random *r, struct motion *m,
                      struct order *o) {
  (void)m;
  for (size_t f = 0; f < data.faces_n; f++) {
    o->first[f] = unit_random_below(r, 4);
  }
}

/* The volume may then have the other sign. */
static void any_side(struct unit_random *r, struct motion *m, struct order *o) {
  m->reverse = true;
  for (size_t f = 0; f < data.faces_n; f++) {
    o->back[f] = unit_random_below(r, 2);
  }
}

static void (*const motions[])(struct unit_random *, struct motion *,
                               struct order *) = {
    any_turn, any_scale, any_points, any_faces, any_first, any_side};

/* Area and volume, within what degree auto leaves open. */
static void ck_same(const struct motion *m) {
  const double area = m->scale * m->scale;
  const struct ph_surface *a = &one.result.curve.surface;
  const struct ph_surface *b = &other.result.curve.surface;
  ck_rel(b->area, area * a->area, 1e-9);
  ck_rel(m->reverse ? fabs(b->volume) : b->volume,
         area * m->scale * (m->reverse ? fabs(a->volume) : a->volume), 1e-9);
}

PH_TEST_EACH(test_moved, 2 * COUNT(motions)) {
  struct unit_random r = unit_random_of(10 + (uint64_t)_i);
  const double continuity = 1 + _i % 2;
  const size_t n = unit_cases(20);
  for (size_t i = 0; i < n; i++) {
    struct motion m = REST;
    struct order o;
    unit_case("motion %d, mesh %zu", _i, i);
    scatter(&r, 0.05, &data);
    keep(&o);
    motions[_i / 2](&r, &m, &o);
    make_image(&m, &o);
    ck_assert_int_eq(solve(&one, &data, continuity), PH_OK);
    ck_assert_int_eq(solve(&other, &image, continuity), PH_OK);
    ck_sound(&other, continuity);
    ck_same(&m);
  }
}
