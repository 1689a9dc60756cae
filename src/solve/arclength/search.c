/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Starts and minima of arclength (see arclength.h). */
#include "solve/arclength/arclength.h"

#include "solve/arclength/engine.h"

#include <math.h>
#include <string.h>

/* Of all starts with one number of segments, no other is begun after. */
enum { STEPS_ALL = 1500 };

/* Minima of F nearer than this are one. */
static const double SAME = 1e-7;
static const double SAME_FLOOR = 1e-13;

/* F of data that a curve without bending fits is rounding. */
static const double F_FLOOR = 1e-12;

/* Lengths this near to the natural ones are had from the natural curve, as
 * those of dense data; in standard deviations, of lengths that were measured.
 */
static const double NATURAL = 1e-3, NATURAL_SIGMAS = 3;

/* Where the iteration of a start begins. */
enum origin {
  ORIGIN_INIT,
  ORIGIN_NATURAL,
  ORIGIN_WIGGLE, /* from the natural curve, see ph_arc_wiggle */
  ORIGIN_NEAREST
};

/* When a start is tried. */
enum use {
  USE_SINGLE, /* one segment in each interval and exact lengths, where minima
               * are many: until the lowest was found twice */
  USE_GIVEN,  /* the same, of derivatives: two that agree prove less there */
  USE_FIRST,  /* until a minimum is found; also where all are wanted */
  USE_NEAR,   /* the same, of lengths that are nearly natural */
  USE_FAR,    /* the same, of others */
  USE_LONG,   /* the same, of many intervals, see leads() */
  USE_RESCUE, /* until a minimum is found; but not where USE_SINGLE found none:
               * then there is none as a rule */
  USE_SHORT,  /* the same, where it was not USE_LONG */
  USE_LAST /* until one is found, after the others of all numbers of segments */
};

static const struct kind {
  const char *name;
  enum use use;
  enum origin origin;
  double rho;    /* weight of an augmented Lagrangian before Newton; 0: none */
  bool more;     /* Newton's steps, where it came near */
  double twist;  /* of the phases, in turn to one side and the other */
  double wave;   /* size of the random wave that is added */
  uint64_t seed; /* of its random numbers; 0: they go on */
} kinds[] = {
    {"twist", USE_SINGLE, ORIGIN_INIT, 100, false, -0.2, 0, 0},
    {"twist-left", USE_SINGLE, ORIGIN_INIT, 1e4, false, 0.2, 0, 0},
    {"twist-right", USE_SINGLE, ORIGIN_INIT, 1e4, false, -0.2, 0, 0},
    {"wave", USE_GIVEN, ORIGIN_INIT, 1e4, false, 0, 0.1, 2},
    {"relaxed", USE_NEAR, ORIGIN_NATURAL, 0, false, 0, 0, 0},
    {"penalty", USE_LONG, ORIGIN_INIT, 100, false, 0, 0, 0},
    {"wiggle", USE_LONG, ORIGIN_WIGGLE, 0, true, 0, 0, 0},
    {"init", USE_FIRST, ORIGIN_INIT, 0, false, 0, 0, 0},
    {"relaxed", USE_FAR, ORIGIN_NATURAL, 0, false, 0, 0, 0},
    {"wiggle", USE_SHORT, ORIGIN_WIGGLE, 0, true, 0, 0, 0},
    {"wiggle-1e4", USE_RESCUE, ORIGIN_WIGGLE, 1e4, false, 0, 0, 0},
    {"penalty", USE_SHORT, ORIGIN_INIT, 100, false, 0, 0, 0},
    {"penalty-1e4", USE_RESCUE, ORIGIN_INIT, 1e4, false, 0, 0, 0},
    {"wave-2", USE_LAST, ORIGIN_NEAREST, 0, false, 0, 0.02, 0},
    {"wave-10", USE_LAST, ORIGIN_NEAREST, 0, false, 0, 0.1, 0},
    {"wave-30", USE_LAST, ORIGIN_NEAREST, 0, false, 0, 0.3, 0},
    {"init-wave-2", USE_LAST, ORIGIN_INIT, 0, false, 0, 0.02, 0},
    {"init-wave-10", USE_LAST, ORIGIN_INIT, 0, false, 0, 0.1, 0},
    {"init-wave-30", USE_LAST, ORIGIN_INIT, 0, false, 0, 0.3, 0},
};
enum { FIRST_SEED = 1000 }; /* of random starts */
enum { KINDS = sizeof kinds / sizeof kinds[0] };

/* Random ones: the first of single segments. */
static const struct kind random_kinds[] = {
    {"random", USE_RESCUE, ORIGIN_INIT, 1e4, false, 0, 0.3, 0},
    {"random", USE_RESCUE, ORIGIN_INIT, 0, false, 0, 1, 0},
};

struct run {
  const struct ph_arc_request *request;
  struct ph_arena *arena;
  struct ph_arc_search *search;
  struct ph_arc_engine engine;
  bool single;    /* see USE_SINGLE */
  bool near;      /* see USE_NEAR */
  bool smooth;    /* the rows nearly hold at init */
  bool twice;     /* the lowest minimum was */
  double *init;   /* [x_n] */
  uint64_t state; /* of the random numbers */
  size_t steps;   /* of all starts */
};

/* ---- the natural lengths ------------------------------------------------- */

/* What leads to the natural curve: as the starts.  0: the steps of a first one,
 * which comes last where another leads (see leads). */
static const struct {
  double rho, wave;
  size_t steps;
} natural_kinds[] = {{0, 0, 0},
                     {100, 0, PH_ARC_STEPS_AFTER},
                     {1e4, 0, PH_ARC_STEPS_AFTER},
                     {0, 0.02, PH_ARC_STEPS},
                     {0, 0.1, PH_ARC_STEPS},
                     {0, 0.3, PH_ARC_STEPS}};
enum { NATURAL_KINDS = sizeof natural_kinds / sizeof natural_kinds[0] };

/* Keeps the curve of a system whose lengths are free. */
static void set_natural(const struct ph_arc_engine *e,
                        struct ph_arc_natural *natural) {
  const struct ph_arc_point *p = &e->point;
  natural->known = p->minimiser;
  natural->residual = p->residual;
  natural->f = p->f;
  ph_arc_lengths(e->s, p->x, natural->length);
  memcpy(natural->x, p->x, e->s->x_n * sizeof *p->x);
}

/* From where the rows begin; from a saddle, or nowhere, random waves lead away.
 * Where none leads to a minimum the curve is what comes nearest to one.  F of
 * exact lengths does not depend on it: what takes the fewest steps comes first.
 * false: no memory. */
static bool solve_natural(struct ph_arc_system *s, struct ph_arc_engine *e,
                          struct ph_arc_natural *natural) {
  uint64_t state = 0;
  size_t steps = 0, first = 0;
  natural->residual = (double)INFINITY;
  for (size_t k = 0; k < NATURAL_KINDS && !natural->known && steps < STEPS_ALL;
       k++) {
    size_t at;
    if (!ph_arc_start(s, e->arena, e->point.x)) {
      return false;
    }
    if (k == 0 && e->work.blocks.n > 0 && s->data->sigma > 0 &&
        !ph_arc_engine_is_smooth(e, e->point.x)) {
      first = 1;
    }
    at = (k + first) % NATURAL_KINDS;
    ph_arc_perturb(s, natural_kinds[at].wave, &state, e->point.x);
    if (!ph_arc_engine_iterate(e, natural_kinds[at].rho,
                               at > 0 ? natural_kinds[at].steps
                                      : ph_arc_engine_first_steps(e))) {
      return false;
    }
    steps += e->point.iterations;
    natural->steps = steps;
    if (e->point.minimiser || e->point.residual < natural->residual) {
      set_natural(e, natural);
    }
  }
  return true;
}

static bool find_natural(const struct ph_arc_request *request,
                         struct ph_arena *arena,
                         struct ph_arc_natural *natural) {
  const struct ph_arc_data *d = request->data;
  struct ph_arc_system s;
  struct ph_arc_engine engine;
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
       ph_arc_engine_of(&s, arena, &engine) &&
       solve_natural(&s, &engine, natural);
  ph_arena_release(arena, mark);
  return ok;
}

bool ph_arc_natural_copy(const struct ph_arc_natural *from, size_t n,
                         size_t x_n, struct ph_arena *arena,
                         struct ph_arc_natural *to) {
  double *length = ph_arena_array(arena, n, sizeof *length);
  double *x = ph_arena_array(arena, x_n, sizeof *x);
  if (!length || !x) {
    return false;
  }
  memcpy(length, from->length, n * sizeof *length);
  memcpy(x, from->x, x_n * sizeof *x);
  *to = *from;
  to->length = length;
  to->x = x;
  return true;
}

/* Whether all lengths are nearly those of the natural curve. */
static bool is_near(const struct ph_arc_data *d,
                    const struct ph_arc_natural *natural) {
  double most = fmax(NATURAL, NATURAL_SIGMAS * d->sigma);
  bool near = natural->known;
  for (size_t i = 0; near && i < d->n; i++) {
    near = fabs(d->length[i] / natural->length[i] - 1) <= most;
  }
  return near;
}

/* ---- one start ----------------------------------------------------------- */

bool ph_arc_is_same(double f, double g) {
  return fabs(f - g) <= SAME * (f > g ? f : g) + SAME_FLOOR;
}

/* Keeps a minimum among those found, lowest first, each once. */
static bool keep(struct run *run, size_t start) {
  struct ph_arc_search *search = run->search;
  struct ph_arc_found found = {.start = start};
  size_t at = 0;
  while (at < search->found_n &&
         search->found[at].point.f < run->engine.point.f &&
         !ph_arc_is_same(search->found[at].point.f, run->engine.point.f)) {
    at++;
  }
  if (at < search->found_n &&
      ph_arc_is_same(search->found[at].point.f, run->engine.point.f)) {
    run->twice = run->twice || at == 0;
    return true;
  }
  run->twice = run->twice && at > 0;
  if (!ph_arc_point_alloc(&search->system, run->arena, &found.point)) {
    return false;
  }
  ph_arc_point_copy(&search->system, &run->engine.point, &found.point);
  memmove(search->found + at + 1, search->found + at,
          (search->found_n - at) * sizeof found);
  search->found[at] = found;
  search->found_n++;
  return true;
}

static void set_nearest(struct run *run) {
  struct ph_arc_point *nearest = &run->search->nearest;
  if (run->search->starts_n == 1 || isnan(nearest->residual) ||
      run->engine.point.residual < nearest->residual) {
    ph_arc_point_copy(&run->search->system, &run->engine.point, nearest);
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
    if (!(speed > PH_ARC_STANDSTILL)) {
      return true;
    }
  }
  return false;
}

/* Where a start begins. */
static void begin(struct run *run, const struct kind *kind) {
  const struct ph_arc_search *search = run->search;
  const struct ph_arc_system *s = &search->system;
  double *x = run->engine.point.x;
  const double *from = kind->origin == ORIGIN_INIT      ? run->init
                       : kind->origin == ORIGIN_NEAREST ? search->nearest.x
                                                        : search->natural.x;
  memcpy(x, from, s->x_n * sizeof *from);
  if (kind->origin == ORIGIN_WIGGLE) {
    ph_arc_wiggle(s, search->natural.length, x);
  }
  ph_arc_twist(s, kind->twist, x);
  if (kind->wave > 0) {
    run->state = kind->seed > 0 ? kind->seed : run->state;
    ph_arc_perturb(s, kind->wave, &run->state, x);
  }
}

/* Keeps what was not proved to be a minimum, for where nothing else is. */
static void keep_saddle(struct run *run, size_t start) {
  struct ph_arc_search *search = run->search;
  if (!search->has_saddle) {
    search->has_saddle = true;
    search->saddle.start = start;
    ph_arc_point_copy(&search->system, &run->engine.point,
                      &search->saddle.point);
  }
}

/* Keeps what a start led to; false: no memory. */
static bool note(struct run *run, const char *name) {
  struct ph_arc_search *search = run->search;
  struct ph_arc_point *p = &run->engine.point;
  size_t start = search->starts_n - 1;
  if (p->converged && stands_still(&search->system, p->x)) {
    p->converged = p->minimiser = false;
    search->stood_still = true;
  }
  run->steps += p->iterations;
  search->starts[start] =
      (struct ph_start){name,
                        p->minimiser   ? PH_OUTCOME_MINIMISER
                        : p->converged ? PH_OUTCOME_SADDLE
                                       : PH_OUTCOME_NO_SOLUTION,
                        p->converged ? p->f : (double)NAN, p->iterations};
  if (p->minimiser) {
    return keep(run, start);
  }
  if (p->converged) {
    keep_saddle(run, start);
  }
  set_nearest(run);
  return true;
}

/* Tries a start; false: no memory, or no time. */
static bool try_start(struct run *run, const struct kind *kind) {
  size_t steps = run->request->stay ? 0
                 : kind->rho > 0    ? PH_ARC_STEPS_AFTER
                 : run->single || kind->wave > 0
                     ? PH_ARC_STEPS
                     : ph_arc_engine_first_steps(&run->engine);
  if (ph_arena_late(run->arena)) {
    return false;
  }
  begin(run, kind);
  run->search->starts_n++;
  return ph_arc_engine_iterate(&run->engine, kind->rho, steps) &&
         (!kind->more || ph_arc_engine_go_on(&run->engine)) &&
         note(run, kind->name);
}

/* ---- all starts ---------------------------------------------------------- */

/* Whether there is what a start begins with. */
static bool has_origin(const struct run *run, const struct kind *kind) {
  const struct ph_arc_search *search = run->search;
  bool natural = search->natural.residual <= PH_ARC_NEAR;
  switch (kind->origin) {
  case ORIGIN_INIT:
    return true;
  case ORIGIN_NATURAL:
    return search->natural.known;
  case ORIGIN_WIGGLE:
    return natural && search->system.refine > 1 && search->system.dim > 1;
  default:
    return search->starts_n > 0;
  }
}

/* Whether a start comes before others, of many intervals: what begins at the
 * natural curve or, where lengths are free and data rough, an augmented
 * Lagrangian. */
static bool leads(const struct run *run, const struct kind *kind) {
  const bool is_free = !run->request->data->length;
  return run->engine.work.blocks.n > 0 && !run->near &&
         (kind->origin == ORIGIN_WIGGLE || (is_free && !run->smooth));
}

/* Whether a start is to be tried now. */
static bool is_due(const struct run *run, const struct kind *kind) {
  const struct ph_arc_request *request = run->request;
  bool none = run->search->found_n == 0, all = request->all;
  bool given = request->data->mode == PH_ARC_DERIVATIVES;
  if (!has_origin(run, kind)) {
    return false;
  }
  switch (kind->use) {
  case USE_SINGLE:
    return run->single && (all || given || !run->twice);
  case USE_GIVEN:
    return run->single && given;
  case USE_FIRST:
    return none || all;
  case USE_NEAR:
    return (none || all) && run->near;
  case USE_FAR:
    return (none || all) && !run->near;
  case USE_LONG:
    return (none || all) && request->rescue && leads(run, kind);
  default:
    return none && !run->single && run->steps < STEPS_ALL &&
           (kind->use == USE_LAST ? request->waves : request->rescue) &&
           !(kind->use == USE_SHORT && leads(run, kind));
  }
}

static bool try_kinds(struct run *run) {
  const struct ph_arc_request *request = run->request;
  for (size_t k = 0; k < KINDS; k++) {
    if (is_due(run, &kinds[k]) && !try_start(run, &kinds[k])) {
      return false;
    }
  }
  for (size_t k = 0; request->rescue && k < request->random; k++) {
    run->state = FIRST_SEED + k; /* whatever was tried before */
    if (!try_start(run, &random_kinds[run->single ? 0 : 1])) {
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
  run->init = ph_arena_array(run->arena, s->x_n, sizeof *run->init);
  return search->starts && search->found && run->init &&
         ph_arc_engine_of(s, run->arena, &run->engine) &&
         ph_arc_point_alloc(s, run->arena, &search->nearest) &&
         ph_arc_point_alloc(s, run->arena, &search->saddle.point);
}

bool ph_arc_search_run(const struct ph_arc_request *request,
                       struct ph_arena *arena, struct ph_arc_search *search) {
  struct run run = {.request = request, .arena = arena, .search = search};
  const struct ph_arc_data *d = request->data;
  struct ph_arc_system *s = &search->system;
  memset(search, 0, sizeof *search);
  search->all = request->all;
  search->natural.residual = (double)INFINITY;
  if (!ph_arc_system_of(d, request->refine, request->dim, true, arena, s)) {
    return false;
  }
  /* tangents have no natural lengths: the curve would shrink to a point */
  if (d->length && d->mode != PH_ARC_TANGENTS) {
    if (request->natural) {
      search->natural = *request->natural;
      search->natural.steps = 0;
    } else if (!find_natural(request, arena, &search->natural)) {
      return false;
    }
    run.near = is_near(d, &search->natural);
  }
  if (d->sigma > 0 &&
      !ph_arc_soften(s, fmax(search->natural.f, F_FLOOR), arena)) {
    return false;
  }
  run.single = request->refine == 1 && d->length && !(d->sigma > 0) &&
               d->mode != PH_ARC_TANGENTS && request->dim > 1;
  if (!allocate(&run)) {
    return false;
  }
  run.engine.last = request->waves;
  run.engine.saddles = request->saddles;
  if (!ph_arc_start(s, arena, run.init)) {
    return false;
  }
  run.smooth = ph_arc_engine_is_smooth(&run.engine, run.init);
  return try_kinds(&run);
}
