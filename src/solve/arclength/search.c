/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Starts and minima of arclength (see arclength.h). */
#include "solve/arclength/arclength.h"

#include <math.h>
#include <string.h>

/* Steps of one start: dense data whose lengths are wrong need 35 to 123; where
 * they are very many, such data are not worth the time. */
enum { STEPS = 150, STEPS_OF_MANY = 50, MANY = 1000 };

/* Those of an augmented Lagrangian, its last weight, and the residuals that
 * it ends with. */
enum { ROUGH_STEPS = 250 };
static const double RHO_MAX = 1e8, ROUGH = 1e-5;

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

/* When a start is tried. */
enum use {
  USE_SINGLE, /* one segment in each interval and exact lengths, where minima
               * are many: until the lowest was found twice */
  USE_GIVEN,  /* the same, of derivatives: two that agree prove less there */
  USE_FIRST,  /* until a minimum is found; also where all are wanted */
  USE_MANY,   /* the same, of many intervals: dense data have nearly their
               * natural lengths */
  USE_FEW,    /* the same, of few */
  USE_RESCUE  /* until a minimum is found; of few intervals, but where
               * USE_SINGLE found none: then there is none as a rule */
};

static const struct kind {
  const char *name;
  enum use use;
  enum origin origin;
  double rho;    /* weight of an augmented Lagrangian before Newton; 0: none */
  double twist;  /* of the phases, in turn to one side and the other */
  double wave;   /* size of the random wave that is added */
  uint64_t seed; /* of its random numbers; 0: they go on */
} kinds[] = {
    {"twist", USE_SINGLE, ORIGIN_INIT, 100, -0.2, 0, 0},
    {"twist-left", USE_SINGLE, ORIGIN_INIT, 1e4, 0.2, 0, 0},
    {"twist-right", USE_SINGLE, ORIGIN_INIT, 1e4, -0.2, 0, 0},
    {"wave", USE_GIVEN, ORIGIN_INIT, 1e4, 0, 0.1, 2},
    {"relaxed", USE_MANY, ORIGIN_NATURAL, 0, 0, 0, 0},
    {"init", USE_FIRST, ORIGIN_INIT, 0, 0, 0, 0},
    {"relaxed", USE_FEW, ORIGIN_NATURAL, 0, 0, 0, 0},
    {"penalty", USE_RESCUE, ORIGIN_INIT, 100, 0, 0, 0},
    {"penalty-1e4", USE_RESCUE, ORIGIN_INIT, 1e4, 0, 0, 0},
    {"wave-2", USE_RESCUE, ORIGIN_NEAREST, 0, 0, 0.02, 0},
    {"wave-10", USE_RESCUE, ORIGIN_NEAREST, 0, 0, 0.1, 0},
    {"wave-30", USE_RESCUE, ORIGIN_NEAREST, 0, 0, 0.3, 0},
    {"init-wave-2", USE_RESCUE, ORIGIN_INIT, 0, 0, 0.02, 0},
    {"init-wave-10", USE_RESCUE, ORIGIN_INIT, 0, 0, 0.1, 0},
    {"init-wave-30", USE_RESCUE, ORIGIN_INIT, 0, 0, 0.3, 0},
};
enum { FIRST_SEED = 1000 }; /* of random starts */
enum { KINDS = sizeof kinds / sizeof kinds[0] };

/* Random ones: the first of single segments. */
static const struct kind random_kinds[] = {
    {"random", USE_RESCUE, ORIGIN_INIT, 1e4, 0, 0.3, 0},
    {"random", USE_RESCUE, ORIGIN_INIT, 0, 0, 1, 0},
};

struct run {
  const struct ph_arc_request *request;
  struct ph_arena *arena;
  struct ph_arc_search *search;
  struct ph_arc_newton work;
  bool single;                /* see USE_SINGLE */
  bool twice;                 /* the lowest minimum was */
  struct ph_arc_system white; /* the same equations, rows whitened */
  struct ph_arc_work rough;   /* for what comes before Newton's method */
  struct ph_arc_point point;  /* of the current start */
  double *init;               /* [x_n] */
  double *rough_y;            /* [y_n] of the whitened rows */
  uint64_t state;             /* of the random numbers */
};

static size_t steps_for(const struct ph_arc_data *d) {
  return d->n > MANY ? STEPS_OF_MANY : STEPS;
}

/* ---- the natural lengths ------------------------------------------------- */

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
    ph_arc_newton_solve(s, work, steps_for(s->data), p);
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

/* ---- one start ----------------------------------------------------------- */

bool ph_arc_is_same(double f, double g) {
  return fabs(f - g) <= SAME * (f > g ? f : g) + SAME_FLOOR;
}

/* Keeps a minimum among those found, lowest first, each once. */
static bool keep(struct run *run, size_t start) {
  struct ph_arc_search *search = run->search;
  struct ph_arc_found found = {.start = start};
  size_t at = 0;
  while (at < search->found_n && search->found[at].point.f < run->point.f &&
         !ph_arc_is_same(search->found[at].point.f, run->point.f)) {
    at++;
  }
  if (at < search->found_n &&
      ph_arc_is_same(search->found[at].point.f, run->point.f)) {
    run->twice = run->twice || at == 0;
    return true;
  }
  run->twice = run->twice && at > 0;
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
  if (run->search->starts_n == 1 || isnan(nearest->residual) ||
      run->point.residual < nearest->residual) {
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

/* Newton's method from run->point. */
static void iterate(struct run *run) {
  const struct ph_arc_system *s = &run->search->system;
  struct ph_arc_point *p = &run->point;
  ph_arc_newton_solve(s, &run->work, steps_for(s->data), p);
  if (p->converged && stands_still(s, p->x)) {
    p->converged = p->minimiser = false;
    run->search->stood_still = true;
  }
}

/* Whitened rows prove a minimum where the plain ones are too nearly dependent.
 */
static void judge_white(struct run *run) {
  struct ph_arc_point *p = &run->point;
  if (p->converged && !p->minimiser && run->white.white) {
    ph_arc_whitened(&run->white, p->y, run->rough_y);
    p->minimiser =
        ph_arc_is_minimum(&run->white, &run->work, p->x, run->rough_y);
  }
}

/* An augmented Lagrangian brings run->point to where Newton's method takes
 * over. */
static void approach(struct run *run, const struct kind *kind) {
  const struct ph_arc_penalty_options options = {kind->rho, RHO_MAX, ROUGH,
                                                 ROUGH_STEPS};
  const struct ph_arc_system *white = &run->white;
  struct ph_arc_point *p = &run->point;
  struct ph_arc_penalty_report report;
  double *y = run->rough_y;
  memset(y, 0, white->y_n * sizeof *y);
  ph_arc_penalty(white, &options, &run->rough, p->x, y, &report);
  p->iterations += report.iterations;
  ph_arc_plain(white, y, p->y);
  iterate(run);
  judge_white(run);
}

/* Tries a start; false: no memory, or no time. */
static bool try_start(struct run *run, const struct kind *kind) {
  struct ph_arc_search *search = run->search;
  const struct ph_arc_system *s = &search->system;
  struct ph_arc_point *p = &run->point;
  struct ph_start *start = &search->starts[search->starts_n++];
  const double *from = kind->origin == ORIGIN_INIT      ? run->init
                       : kind->origin == ORIGIN_NATURAL ? search->natural.x
                                                        : search->nearest.x;
  memcpy(p->x, from, s->x_n * sizeof *from);
  memset(p->y, 0, s->y_n * sizeof *p->y);
  p->iterations = 0;
  p->converged = p->minimiser = false;
  if (ph_arena_late(run->arena)) {
    return false;
  }
  ph_arc_twist(s, kind->twist, p->x);
  if (kind->wave > 0) {
    run->state = kind->seed > 0 ? kind->seed : run->state;
    ph_arc_perturb(s, kind->wave, &run->state, p->x);
  }
  if (kind->rho > 0) {
    approach(run, kind);
  } else {
    iterate(run);
  }
  *start = (struct ph_start){kind->name,
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

/* ---- all starts ---------------------------------------------------------- */

/* Whether a start is to be tried now. */
static bool is_due(const struct run *run, const struct kind *kind) {
  const struct ph_arc_search *search = run->search;
  bool none = search->found_n == 0, all = run->request->all;
  bool few = run->request->data->n < FEW;
  bool given = run->request->data->mode == PH_ARC_DERIVATIVES;
  if ((kind->origin == ORIGIN_NATURAL && !search->natural.known) ||
      (kind->origin == ORIGIN_NEAREST && search->starts_n == 0) ||
      (kind->rho > 0 && search->system.compliance)) {
    return false;
  }
  switch (kind->use) {
  case USE_SINGLE:
    return run->single && (all || given || !run->twice);
  case USE_GIVEN:
    return run->single && given;
  case USE_FIRST:
    return none || all;
  case USE_MANY:
    return (none || all) && !few;
  case USE_FEW:
    return (none || all) && few;
  default:
    return none && few && !run->single;
  }
}

static bool try_kinds(struct run *run) {
  const struct ph_arc_request *request = run->request;
  for (size_t k = 0; k < KINDS; k++) {
    if (is_due(run, &kinds[k]) && !try_start(run, &kinds[k])) {
      return false;
    }
  }
  for (size_t k = 0; k < request->random; k++) {
    run->state = FIRST_SEED + k; /* whatever was tried before */
    if (!try_start(run, &random_kinds[run->single ? 0 : 1])) {
      return false;
    }
  }
  return true;
}

/* What comes before Newton's method; of many intervals nothing does. */
static bool allocate_rough(struct run *run) {
  const struct ph_arc_system *s = &run->search->system;
  run->white = *s;
  if (!run->single && s->data->n >= FEW) {
    return true;
  }
  run->rough_y = ph_arena_array(run->arena, s->y_n, sizeof *run->rough_y);
  return run->rough_y && ph_arc_whiten(&run->white, run->arena) &&
         ph_arc_work_alloc(s, run->arena, &run->rough);
}

static bool allocate(struct run *run) {
  struct ph_arc_search *search = run->search;
  const struct ph_arc_system *s = &search->system;
  size_t most = KINDS + run->request->random;
  search->starts = ph_arena_array(run->arena, most, sizeof *search->starts);
  search->found = ph_arena_array(run->arena, most, sizeof *search->found);
  run->init = ph_arena_array(run->arena, s->x_n, sizeof *run->init);
  return search->starts && search->found && run->init && allocate_rough(run) &&
         ph_arc_newton_alloc(s, run->arena, &run->work) &&
         ph_arc_point_alloc(s, run->arena, &run->point) &&
         ph_arc_point_alloc(s, run->arena, &search->nearest);
}

bool ph_arc_search_run(const struct ph_arc_request *request,
                       struct ph_arena *arena, struct ph_arc_search *search) {
  struct run run = {.request = request, .arena = arena, .search = search};
  const struct ph_arc_data *d = request->data;
  struct ph_arc_system *s = &search->system;
  memset(search, 0, sizeof *search);
  search->all = request->all;
  if (!ph_arc_system_of(d, request->refine, request->dim, true, arena, s)) {
    return false;
  }
  /* tangents have no natural lengths: the curve would shrink to a point */
  if (d->length && d->mode != PH_ARC_TANGENTS &&
      !find_natural(request, arena, &search->natural)) {
    return false;
  }
  if (d->sigma > 0 && !search->natural.known) {
    return true; /* without it lengths have no weight */
  }
  if (d->sigma > 0 &&
      !ph_arc_soften(s, fmax(search->natural.f, F_FLOOR), arena)) {
    return false;
  }
  run.single = request->refine == 1 && d->length && !(d->sigma > 0) &&
               d->mode != PH_ARC_TANGENTS && request->dim > 1;
  if (!allocate(&run) || !ph_arc_start(s, arena, run.init)) {
    return false;
  }
  run.white.sign = s->sign;
  return try_kinds(&run);
}
