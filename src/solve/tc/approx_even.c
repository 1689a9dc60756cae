/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Parts with even distances, and no more of them than needed (see
 * tc_approx_plan.h).
 *
 * The distance of one cubic grows like the fourth power of its part: a part at
 * the distance e counts (e/tolerance)^(1/4), and the sum of all is how many it
 * takes, about, whatever the parts are.  Knots move to where each part counts
 * the same (equidistribution); the distances there give new counts.
 *
 * Knots are rounded to few bits, so that rounding errors, which differ for the
 * curve backward or turned, do not show.
 */
#include "solve/tc/approx_plan.h"

#include <math.h>

/*
 * Sweeps for one number of parts, all sweeps, and those that only make an
 * accepted mesh more even.  A number of parts is given up when a sweep leaves
 * more than SHRINK of what is beyond the tolerance, or the counts promise more
 * than HOPELESS times as many.
 *
 * With 1000 random curves, twice as many sweeps save no cubic and half as many
 * cost one in 400; SHRINK from .5 to .9 and HOPELESS from 1 to 1.1 matter less.
 */
enum { TRIES = 12, SWEEPS = 36, POLISH = 2 };
static const double SHRINK = 0.7, HOPELESS = 1.02;

/* A knot is rounded to this fraction of the parts beside it, which changes
 * their distances by a percent at most. */
static const double GRAIN = 0x1p-10;

struct mesh {
  size_t n;
  double *u;             /* [n + 1] */
  double *e;             /* [n] distances */
  double *count;         /* [n] */
  unsigned char *cubics; /* [n] */
  double worst;          /* distance */
  double sum;            /* of counts */
  size_t total;          /* of cubics */
};

struct evener {
  const struct ph_tc_target *target;
  double tolerance;
  struct mesh best, tried, next;
  int sweeps; /* that are left */
};

static bool mesh_alloc(struct mesh *m, struct ph_arena *arena, size_t n) {
  m->u = ph_arena_array(arena, n + 1, sizeof *m->u);
  m->e = ph_arena_array(arena, n, sizeof *m->e);
  m->count = ph_arena_array(arena, n, sizeof *m->count);
  m->cubics = ph_arena_array(arena, n, sizeof *m->cubics);
  return m->u && m->e && m->count && m->cubics;
}

/* Counts; a part far beyond the tolerance counts as two. */
static void weigh(const struct evener *s, struct mesh *m) {
  double noise = s->target->noise;
  m->worst = m->sum = 0;
  m->total = 0;
  for (size_t i = 0; i < m->n; i++) {
    double ratio = (m->e[i] - noise) / (s->tolerance - noise);
    m->count[i] = ratio < 16 ? sqrt(sqrt(ratio)) : 2;
    m->sum += m->count[i];
    m->worst = m->e[i] > m->worst ? m->e[i] : m->worst;
    m->total += m->cubics[i];
  }
}

/* n + 1 knots where each part counts the same by the mesh `old`. */
static void place(const struct mesh *old, struct mesh *m, size_t n) {
  size_t i = 0;
  double before = 0;
  m->n = n;
  m->u[0] = old->u[0];
  m->u[n] = old->u[old->n];
  for (size_t j = 1; j < n; j++) {
    double goal = old->sum * ((double)j / (double)n), v;
    while (i + 1 < old->n && before + old->count[i] < goal) {
      before += old->count[i++];
    }
    v = (goal - before) / old->count[i];
    v = v < 1 ? v : 1;
    m->u[j] = old->u[i] + v * (old->u[i + 1] - old->u[i]);
  }
}

static void round_knots(struct mesh *m) {
  double left = m->u[0];
  for (size_t j = 1; j < m->n; j++) {
    double here = m->u[j], a = here - left, b = m->u[j + 1] - here;
    double gap = a < b ? a : b;
    /* 4/3: even parts of a power of two are not at a step of ilogb */
    double grain = gap > 0 ? ldexp(GRAIN, ilogb(gap * 4 / 3)) : 0;
    left = here;
    m->u[j] = grain > 0 ? grain * round(here / grain) : here;
  }
}

static void swap(struct mesh *a, struct mesh *b) {
  struct mesh m = *a;
  *a = *b;
  *b = m;
}

/* One sweep: n parts by the counts of `old`, to s->tried. */
static void sweep(struct evener *s, const struct mesh *old, size_t n) {
  struct mesh *m = &s->next;
  struct ph_tc_knot from;
  place(old, m, n);
  round_knots(m);
  from = ph_tc_knot_at(s->target, m->u[0]);
  for (size_t i = 0; i < n; i++) {
    struct ph_tc_knot to = ph_tc_knot_at(s->target, m->u[i + 1]);
    struct ph_tc_patch patch =
        ph_tc_patch_of(s->target, &from, &to, PH_TC_ONE, s->tolerance);
    m->e[i] = patch.distance;
    m->cubics[i] = (unsigned char)patch.n;
    from = to;
  }
  weigh(s, m);
  swap(m, &s->tried);
  s->sweeps--;
}

/* Whether n parts were found; they are the best then.  What is beyond the
 * tolerance must shrink from sweep to sweep. */
static bool try_count(struct evener *s, size_t n) {
  double beyond = (double)INFINITY;
  for (int i = 0; i < TRIES && s->sweeps > 0; i++) {
    double before = beyond;
    sweep(s, i > 0 ? &s->tried : &s->best, n);
    beyond = s->tried.worst - s->tolerance;
    if (beyond <= 0 && s->tried.total <= s->best.total) {
      swap(&s->best, &s->tried);
      return true;
    }
    if (i > 0 &&
        (!(beyond < SHRINK * before) || s->tried.sum > HOPELESS * (double)n)) {
      return false;
    }
  }
  return false;
}

/* What the counts promise, but more than `failed` and less than the best. */
static size_t promise(const struct evener *s, size_t failed) {
  double sum = ceil(s->best.sum);
  size_t n = sum < (double)s->best.n ? (size_t)sum : s->best.n;
  return n > failed ? n : failed + 1;
}

static void even(struct evener *s) {
  size_t failed = 0;
  for (size_t n; n = promise(s, failed), n < s->best.n && s->sweeps > 0;) {
    failed = try_count(s, n) ? failed : n;
  }
  s->sweeps = POLISH;
  while (s->sweeps > 0 && s->best.n > 1) {
    sweep(s, &s->best, s->best.n);
    if (s->tried.worst < s->best.worst && s->tried.total <= s->best.total) {
      swap(&s->best, &s->tried);
    }
  }
}

/* The mesh of the parts from `first` on, to s->best. */
static void read_plan(struct evener *s, const struct ph_tc_plan *plan,
                      size_t first) {
  struct mesh *m = &s->best;
  m->n = plan->n - first;
  m->u[0] = plan->part[first].from;
  for (size_t i = 0; i < m->n; i++) {
    const struct ph_tc_part *part = &plan->part[first + i];
    m->u[i + 1] = part->to;
    m->e[i] = part->distance;
    m->cubics[i] = (unsigned char)part->n;
  }
  weigh(s, m);
}

enum ph_status ph_tc_plan_even(const struct ph_tc_target *target, size_t first,
                               double tolerance, struct ph_tc_plan *plan,
                               struct ph_diag *diag) {
  struct ph_arena scratch = ph_arena_beside(plan->arena);
  struct evener s = {
      .target = target, .tolerance = tolerance, .sweeps = SWEEPS};
  size_t n = plan->n - first;
  enum ph_status status = PH_OK;
  if (n < 2) {
    return PH_OK;
  }
  if (!mesh_alloc(&s.best, &scratch, n) || !mesh_alloc(&s.tried, &scratch, n) ||
      !mesh_alloc(&s.next, &scratch, n)) {
    ph_arena_free(&scratch);
    return ph_fail_memory(diag);
  }
  read_plan(&s, plan, first);
  plan->cubics -= s.best.total;
  plan->n = first;
  even(&s);
  for (size_t i = 0; status == PH_OK && i < s.best.n; i++) {
    struct ph_tc_part part = {.from = s.best.u[i],
                              .to = s.best.u[i + 1],
                              .distance = s.best.e[i],
                              .kind = PH_TC_ONE,
                              .n = s.best.cubics[i]};
    status = ph_tc_plan_add(plan, &part, diag);
  }
  ph_arena_free(&scratch);
  return status;
}
