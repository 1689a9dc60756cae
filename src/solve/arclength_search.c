/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Starts and minima of arclength (see arclength_search.h). */
#include "solve/arclength_search.h"

#include "solve/arclength_start.h"

#include <math.h>
#include <string.h>

/* Steps of one start: dense data whose lengths are wrong need 35 to 123. */
enum { STEPS = 150 };

/* On more intervals a start costs more than it promises. */
enum { FEW = 100 };

/* Minima of F nearer than this are one. */
static const double SAME = 1e-7;
static const double SAME_FLOOR = 1e-13;

/* |r'| at a datum, relative to the mean, below which there is no direction. */
static const double STANDSTILL = 1e-8;

/* F of data that a curve without bending fits is rounding. */
static const double F_FLOOR = 1e-12;

/* Where the iteration of a start begins. */
enum origin { ORIGIN_INIT, ORIGIN_NATURAL, ORIGIN_NEAREST };

static const struct kind {
  const char *name;
  enum origin origin;
  double wave; /* size of the random wave that is added */
} kinds[] = {
    {"init", ORIGIN_INIT, 0},           {"relaxed", ORIGIN_NATURAL, 0},
    {"wave-2", ORIGIN_NEAREST, 0.02},   {"wave-10", ORIGIN_NEAREST, 0.1},
    {"wave-30", ORIGIN_NEAREST, 0.3},   {"init-wave-2", ORIGIN_INIT, 0.02},
    {"init-wave-10", ORIGIN_INIT, 0.1}, {"init-wave-30", ORIGIN_INIT, 0.3},
};
enum { KINDS = sizeof kinds / sizeof kinds[0], FIRST_WAVE = 2 };

static const struct kind random_kind = {"random", ORIGIN_INIT, 1};

struct run {
  const struct ph_arc_request *request;
  struct ph_arena *arena;
  struct ph_arc_search *search;
  struct ph_arc_newton work;
  struct ph_arc_point point; /* of the current start */
  double *init;              /* [x_n] */
  uint64_t state;            /* of the random numbers */
};

/* ---- the natural lengths ------------------------------------------------- */

/* Tangents have none: the curve would shrink to a point. */
static bool has_natural(const struct ph_arc_data *d) {
  return d->length && d->mode != PH_ARC_TANGENTS;
}

/* From where the rows begin; from a saddle, or nowhere, random waves lead away.
 * false: no memory. */
static bool solve_natural(struct ph_arc_system *s, struct ph_arc_newton *work,
                          struct ph_arena *arena, struct ph_arc_point *p) {
  static const double waves[] = {0, 0.02, 0.1, 0.3};
  size_t tries = s->data->n < FEW ? 4 : 1;
  uint64_t state = 0;
  for (size_t k = 0; k < tries && !p->minimiser; k++) {
    if (!ph_arc_start(s, arena, p->x)) {
      return false;
    }
    memset(p->y, 0, s->y_n * sizeof *p->y);
    ph_arc_perturb(s, waves[k], &state, p->x);
    ph_arc_newton_solve(s, work, STEPS, p);
  }
  return true;
}

static bool find_natural(const struct ph_arc_request *request,
                         struct ph_arena *arena,
                         struct ph_arc_natural *natural) {
  const struct ph_arc_data *d = request->data;
  struct ph_arc_system s;
  struct ph_arc_newton work;
  struct ph_arc_point p;
  struct ph_mark mark;
  bool ok;
  natural->length = ph_arena_array(arena, d->n, sizeof(double));
  natural->x = ph_arena_array(
      arena, (request->refine * d->n + 2) * request->dim + 1, sizeof(double));
  if (!natural->length || !natural->x) {
    return false;
  }
  mark = ph_arena_mark(arena);
  ok = ph_arc_system_of(d, request->refine, request->dim, false, arena, &s) &&
       ph_arc_newton_alloc(&s, arena, &work) &&
       ph_arc_point_alloc(&s, arena, &p) && solve_natural(&s, &work, arena, &p);
  if (ok && p.minimiser) {
    natural->known = true;
    natural->f = p.f;
    ph_arc_lengths(&s, p.x, natural->length);
    memcpy(natural->x, p.x, s.x_n * sizeof *p.x);
  }
  ph_arena_release(arena, mark);
  return ok;
}

/* ---- one start --------------------------------------------------------------
 */

static bool is_same(double f, double g) {
  return fabs(f - g) <= SAME * (f > g ? f : g) + SAME_FLOOR;
}

/* Keeps a minimum among those found, lowest first, each once. */
static bool keep(struct run *run, size_t start) {
  struct ph_arc_search *search = run->search;
  struct ph_arc_found found = {.start = start};
  size_t at = 0;
  while (at < search->found_n && search->found[at].point.f < run->point.f &&
         !is_same(search->found[at].point.f, run->point.f)) {
    at++;
  }
  if (at < search->found_n &&
      is_same(search->found[at].point.f, run->point.f)) {
    return true;
  }
  if (!ph_arc_point_alloc(&search->system, run->arena, &found.point)) {
    return false;
  }
  ph_arc_point_copy(&search->system, &run->point, &found.point);
  memmove(search->found + at + 1, search->found + at,
          (search->found_n - at) * sizeof found);
  search->found[at] = found;
  search->found_n++;
  return true;
}

static void set_nearest(struct run *run) {
  struct ph_arc_point *nearest = &run->search->nearest;
  if (!(run->search->starts_n > 1 &&
        nearest->residual <= run->point.residual)) {
    ph_arc_point_copy(&run->search->system, &run->point, nearest);
  }
}

/* A direction is held by a derivative of size 0 as well: such a curve stands
 * still at a datum. */
static bool stands_still(const struct ph_arc_system *s, const double *x) {
  size_t dim = s->dim,
         n = s->data->mode == PH_ARC_TANGENTS ? s->data->n + 1 : 0;
  for (size_t j = 0; j < n; j++) {
    const double *w = x + j * s->refine * dim;
    double speed = 0;
    for (size_t k = 0; k < dim; k++) {
      double m = s->knot[2 * j] * w[k] + s->knot[2 * j + 1] * w[dim + k];
      speed += m * m;
    }
    if (!(speed > STANDSTILL)) {
      return true;
    }
  }
  return false;
}

/* Iterates from run->point.x; false: no memory. */
static bool finish_start(struct run *run, const char *name) {
  struct ph_arc_search *search = run->search;
  const struct ph_arc_system *s = &search->system;
  struct ph_arc_point *p = &run->point;
  struct ph_start *start = &search->starts[search->starts_n++];
  ph_arc_newton_solve(s, &run->work, STEPS, p);
  if (stands_still(s, p->x)) {
    p->converged = p->minimiser = false;
  }
  *start = (struct ph_start){name,
                             p->minimiser   ? PH_OUTCOME_MINIMISER
                             : p->converged ? PH_OUTCOME_SADDLE
                                            : PH_OUTCOME_NO_SOLUTION,
                             p->converged ? p->f : (double)NAN, p->iterations};
  if (p->minimiser) {
    return keep(run, search->starts_n - 1);
  }
  set_nearest(run);
  return true;
}

static bool try_start(struct run *run, const struct kind *kind) {
  const struct ph_arc_system *s = &run->search->system;
  const double *from = kind->origin == ORIGIN_INIT ? run->init
                       : kind->origin == ORIGIN_NATURAL
                           ? run->search->natural.x
                           : run->search->nearest.x;
  memmove(run->point.x, from, s->x_n * sizeof *from);
  memset(run->point.y, 0, s->y_n * sizeof *run->point.y);
  run->point.iterations = 0;
  if (kind->wave > 0) {
    ph_arc_perturb(s, kind->wave, &run->state, run->point.x);
  }
  return finish_start(run, kind->name);
}

/* ---- all starts
 * --------------------------------------------------------------- */

static bool try_kinds(struct run *run) {
  const struct ph_arc_request *request = run->request;
  struct ph_arc_search *search = run->search;
  size_t kinds_n = request->data->n < FEW ? KINDS : FIRST_WAVE;
  for (size_t k = 0; k < kinds_n; k++) {
    bool needed = search->found_n == 0 || (request->all && k < FIRST_WAVE);
    bool possible = kinds[k].origin == ORIGIN_INIT ||
                    (kinds[k].origin == ORIGIN_NATURAL ? search->natural.known
                                                       : search->starts_n > 0);
    if (needed && possible && !try_start(run, &kinds[k])) {
      return false;
    }
  }
  for (size_t k = 0; k < request->random; k++) {
    if (!try_start(run, &random_kind)) {
      return false;
    }
  }
  return true;
}

static bool allocate(struct run *run) {
  struct ph_arc_search *search = run->search;
  const struct ph_arc_system *s = &search->system;
  size_t most = KINDS + run->request->random;
  search->starts = ph_arena_array(run->arena, most, sizeof *search->starts);
  search->found = ph_arena_array(run->arena, most, sizeof *search->found);
  return search->starts && search->found &&
         ph_arc_point_alloc(s, run->arena, &search->nearest);
}

bool ph_arc_search_run(const struct ph_arc_request *request,
                       struct ph_arena *arena, struct ph_arc_search *search) {
  struct run run = {.request = request, .arena = arena, .search = search};
  const struct ph_arc_data *d = request->data;
  struct ph_arc_system *s = &search->system;
  memset(search, 0, sizeof *search);
  search->all = request->all;
  if (!ph_arc_system_of(d, request->refine, request->dim, true, arena, s) ||
      (has_natural(d) && !find_natural(request, arena, &search->natural))) {
    return false;
  }
  if (d->sigma > 0 && !search->natural.known) {
    return true; /* without it lengths have no weight */
  }
  if (d->sigma > 0 &&
      !ph_arc_soften(s, fmax(search->natural.f, F_FLOOR), arena)) {
    return false;
  }
  run.init = ph_arena_array(arena, s->x_n, sizeof *run.init);
  return run.init && allocate(&run) &&
         ph_arc_newton_alloc(s, arena, &run.work) &&
         ph_arc_point_alloc(s, arena, &run.point) &&
         ph_arc_start(s, arena, run.init) && try_kinds(&run);
}
