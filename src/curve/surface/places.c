/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Places of patches (see places.h). */
#include "curve/surface/places.h"

#include "base/team.h"

#include <float.h>
#include <math.h>
#include <string.h>

/* b_u x b_v over |b_u| |b_v|: below this it is rounding. */
static const double FLAT = 1e-9;

/* ---- patch by patch ------------------------------------------------------ */

/* Patches that a thread takes at once, and as many as are worth a thread. */
enum { CHUNK = 64, WORTH = 256 };

/* The rows of all degrees that there are. */
static bool set_rows(struct ph_places *p, struct ph_arena *arena) {
  const struct ph_curve *c = p->curve;
  for (size_t i = 0; i < c->n; i++) {
    const size_t degree = c->surface.patches[i].bidegree[0];
    struct ph_patch_rows *rows = p->rows[degree];
    if (rows) {
      continue;
    }
    rows = ph_arena_array(arena, p->n, sizeof *rows);
    if (!rows) {
      return false;
    }
    for (size_t j = 0; j < p->n; j++) {
      ph_patch_rows_at(degree, p->at[j], &rows[j]);
    }
    p->rows[degree] = rows;
  }
  return true;
}

static bool begin(struct ph_places *p, const struct ph_curve *curve,
                  const double *at, size_t n, struct ph_arena *arena) {
  const struct ph_surface *s = &curve->surface;
  *p = (struct ph_places){.curve = curve, .at = at, .n = n};
  p->to_unit = ph_pow2_of(s->base->exponent);
  p->from_unit = ph_pow2_of(-s->base->exponent);
  if (!s->exact) {
    p->line = ph_arena_array(arena, 1, sizeof *p->line);
    p->points = ph_arena_array(arena, 3 * PH_PATCH_ROW * PH_PATCH_ROW,
                               sizeof *p->points);
    return p->line && p->points && set_rows(p, arena);
  }
  p->exact_rows = ph_arena_array(arena, n, sizeof *p->exact_rows);
  p->exact = ph_arena_array(arena, 1, sizeof *p->exact);
  p->cross[0] = ph_arena_array(arena, n, sizeof *p->cross[0]);
  p->cross[1] = ph_arena_array(arena, n, sizeof *p->cross[1]);
  if (!p->exact_rows || !p->exact || !p->cross[0] || !p->cross[1]) {
    return false;
  }
  for (size_t i = 0; i < n; i++) {
    ph_exact_rows_at(s->continuity, at[i], &p->exact_rows[i]);
  }
  return true;
}

static void enter(struct ph_places *p, size_t patch) {
  const struct ph_surface *s = &p->curve->surface;
  p->patch = patch;
  if (s->exact) {
    ph_exact_begin(s->base, patch, p->exact);
    for (size_t i = 0; i < 2 * p->n; i++) {
      ph_exact_cross(p->exact, i & 1, &p->exact_rows[i / 2],
                     p->cross[i & 1][i / 2]);
    }
    return;
  }
  for (size_t i = 0; i < 3 * s->patches[patch].points_n; i++) {
    p->points[i] =
        ph_pow2_apply(p->to_unit, s->patches[patch].control_points[i]);
  }
}

struct spread {
  struct ph_places *places; /* [threads] */
  const struct ph_arena *arena;
  bool (*look)(void *, struct ph_places *);
  void *context;
};

static bool look_at_some(void *context, size_t thread, size_t first,
                         size_t end) {
  const struct spread *s = context;
  bool good = thread || !ph_arena_late(s->arena); /* it is for one to ask */
  for (size_t i = first; good && i < end; i++) {
    enter(&s->places[thread], i);
    good = s->look(s->context, &s->places[thread]);
  }
  return good;
}

enum ph_status ph_places_spread(const struct ph_curve *curve, const double *at,
                                size_t n, struct ph_arena *arena,
                                bool (*look)(void *context,
                                             struct ph_places *places),
                                void *context, struct ph_diag *diag) {
  atomic_int *spare = arena->budget ? arena->budget->spare : NULL;
  const size_t threads = ph_team_take(spare, curve->n / WORTH);
  struct spread s = {NULL, arena, look, context};
  bool good;
  s.places = ph_arena_array(arena, threads, sizeof *s.places);
  good = s.places != NULL;
  for (size_t i = 0; good && i < threads; i++) {
    good = begin(&s.places[i], curve, at, n, arena);
  }
  /* where there is no memory the threads are given back all the same */
  ph_team_spread(spare, threads, good ? curve->n : 0, CHUNK, look_at_some, &s);
  return good && !ph_arena_late(arena) ? PH_OK : ph_fail_memory(diag);
}

/* ---- places -------------------------------------------------------------- */

void ph_places_line(struct ph_places *p, size_t j) {
  const struct ph_patch *patch = &p->curve->surface.patches[p->patch];
  p->j = j;
  if (!p->exact) {
    ph_patch_line_at(p->points, patch->bidegree[0],
                     &p->rows[patch->bidegree[0]][j], 2, p->line);
  }
}

void ph_places_jet(const struct ph_places *p, size_t i,
                   struct ph_patch_jet *jet) {
  const size_t degree = p->curve->surface.patches[p->patch].bidegree[0];
  if (!p->exact) {
    ph_patch_jet_at(p->line, degree, &p->rows[degree][i], 2, jet);
    return;
  }
  ph_exact_jet_at(p->exact, &p->exact_rows[i],
                  (const struct ph_cross *)p->cross[0][i], &p->exact_rows[p->j],
                  (const struct ph_cross *)p->cross[1][p->j], jet);
}

/* ---- at a place ---------------------------------------------------------- */

ph_vec3 ph_patch_normal(const struct ph_patch_jet *jet, double u, double v) {
  const double lu = ph_vec3_abs(jet->u), lv = ph_vec3_abs(jet->v);
  const ph_vec3 a = ph_vec3_scale(1 / lu, jet->u);
  const ph_vec3 b = ph_vec3_scale(1 / lv, jet->v);
  ph_vec3 normal = ph_vec3_cross(a, b);
  if (!(ph_vec3_abs(normal) > FLAT)) { /* by its change inwards */
    const double su = u < 0.5 ? 1 : -1, sv = v < 0.5 ? 1 : -1;
    const ph_vec3 du = ph_vec3_along(ph_vec3_scale(su, jet->uu), sv, jet->uv);
    const ph_vec3 dv = ph_vec3_along(ph_vec3_scale(su, jet->uv), sv, jet->vv);
    normal = ph_vec3_add(ph_vec3_cross(ph_vec3_scale(1 / lu, du), b),
                         ph_vec3_cross(a, ph_vec3_scale(1 / lv, dv)));
  }
  return ph_vec3_scale(1 / ph_vec3_abs(normal), normal);
}

void ph_patch_bend(const struct ph_patch_jet *jet, ph_vec3 normal,
                   double form[3]) {
  /* b_u = x e1, b_v = y e1 + z e2 */
  const double x = ph_vec3_abs(jet->u);
  const ph_vec3 e1 = ph_vec3_scale(1 / x, jet->u);
  const ph_vec3 e2 = ph_vec3_cross(normal, e1);
  const double y = ph_vec3_dot(jet->v, e1), z = ph_vec3_dot(jet->v, e2);
  const double l = ph_vec3_dot(jet->uu, normal) / x / x;
  const double m = ph_vec3_dot(jet->uv, normal) / x;
  const double n = ph_vec3_dot(jet->vv, normal);
  form[0] = l;
  form[1] = (m - y * l) / z;
  form[2] = (n - 2 * y * m + y * y * l) / z / z;
}

/* ---- samples ------------------------------------------------------------- */

static double finite(double x) {
  return isfinite(x) ? x : (double)NAN;
}

/* ... of which it is known where they are: what there is at a distance, at unit
 * scale.
 * ret whether the surface goes on there as it does at the place */
static bool set_sample(const struct ph_places *p,
                       const struct ph_patch_jet *jet, double side,
                       double distance, struct ph_patch_sample *to) {
  const ph_vec3 normal =
      ph_vec3_scale(side, ph_patch_normal(jet, to->u, to->v));
  double form[3], mean, half, k[2], factor[2], gauss;
  ph_patch_bend(jet, ph_vec3_scale(side, normal), form);
  mean = side * (form[0] + form[2]) / 2;
  half = hypot((form[0] - form[2]) / 2, form[1]);
  for (size_t i = 0; i < 2; i++) {
    k[i] = mean + (i ? -half : half);
    factor[i] = 1 - distance * k[i];
    k[i] = ph_pow2_apply(p->to_unit, k[i] / factor[i]);
  }
  gauss = k[0] * k[1];
  if (!(fabs(distance) > 0)) { /* without cancellation */
    gauss = ph_pow2_apply(
        p->to_unit,
        ph_pow2_apply(p->to_unit, form[0] * form[2] - form[1] * form[1]));
  }
  if (!isfinite(k[0]) || !isfinite(k[1])) {
    k[0] = k[1] = gauss = (double)NAN;
  }
  to->principal[0] = k[0] < k[1] ? k[1] : k[0];
  to->principal[1] = k[0] < k[1] ? k[0] : k[1];
  to->gauss = finite(gauss);
  to->mean = k[0] / 2 + k[1] / 2;
  ph_vec3_put(ph_vec3_along(jet->p, distance, normal), 3, to->point);
  for (size_t i = 0; i < 3; i++) {
    to->point[i] = ph_pow2_apply(p->from_unit, to->point[i]);
  }
  ph_vec3_put(normal, 3, to->normal);
  return !(factor[0] <= 0) && !(factor[1] <= 0);
}

/* Samples on their way. */
struct filler {
  double distance; /* at unit scale */
  struct ph_patch_sample *to;
  atomic_size_t back, large; /* the first patch that turns back, and that whose
                                samples are too large; PH_NO_SEGMENT: none */
};

/* A patch, if it is before the first one so far. */
static void note(atomic_size_t *first, size_t patch) {
  size_t before = atomic_load(first);
  while (patch < before &&
         !atomic_compare_exchange_weak(first, &before, patch)) {
  }
}

static bool fill(void *context, struct ph_places *places) {
  struct filler *f = context;
  const size_t patch = places->patch, n = places->n;
  const double side = places->curve->surface.patches[patch].side;
  struct ph_patch_sample *to = f->to + patch * n * n;
  for (size_t j = 0; j < n; j++) {
    ph_places_line(places, j);
    for (size_t i = 0; i < n; i++, to++) {
      struct ph_patch_jet jet;
      ph_places_jet(places, i, &jet);
      to->patch = patch;
      to->u = places->at[i];
      to->v = places->at[j];
      if (!set_sample(places, &jet, side, f->distance, to)) {
        note(&f->back, patch);
      }
      if (!ph_are_finite(to->point, 3)) {
        note(&f->large, patch);
        return false;
      }
    }
  }
  return true;
}

enum ph_status ph_patch_grid_of(const struct ph_curve *curve, double distance,
                                size_t steps, size_t most,
                                struct ph_arena *arena,
                                struct ph_patch_samples *grid, size_t *back,
                                struct ph_diag *diag) {
  const double each = (double)steps + 1,
               wanted = (double)curve->n * each * each;
  struct ph_arena scratch = ph_arena_beside(arena);
  struct filler f;
  enum ph_status status;
  double *at = ph_arena_array(&scratch, steps + 1, sizeof *at);
  if (!(wanted <= (double)most)) {
    ph_arena_free(&scratch);
    return ph_fail(diag, PH_E_LIMIT, NULL,
                   "the surface would have %.0f samples, more than the %zu of "
                   "--max-samples",
                   wanted, most);
  }
  grid->n = curve->n * (steps + 1) * (steps + 1);
  grid->v = ph_arena_array(arena, grid->n, sizeof *grid->v);
  status = at && grid->v ? PH_OK : ph_fail_memory(diag);
  for (size_t i = 0; at && i <= steps; i++) {
    at[i] = (double)i / (double)steps;
  }
  f.distance =
      ph_pow2_apply(ph_pow2_of(curve->surface.base->exponent), distance);
  f.to = grid->v;
  atomic_init(&f.back, PH_NO_SEGMENT);
  atomic_init(&f.large, PH_NO_SEGMENT);
  if (status == PH_OK) {
    status = ph_places_spread(curve, at, steps + 1, &scratch, fill, &f, diag);
  }
  *back = atomic_load(&f.back);
  if (status == PH_OK && atomic_load(&f.large) != PH_NO_SEGMENT) {
    status = ph_fail_at(diag, PH_E_TOO_LARGE, "patches", atomic_load(&f.large),
                        "has samples beyond the range of a double");
  }
  ph_arena_free(&scratch);
  return status;
}
