/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Places where Newton's steps are not small (see newton.h). */
#include "solve/arclength/arclength.h"

#include "solve/arclength/system.h"

#include <math.h>
#include <string.h>

/* A node that changed by less than this, relative to its size and that of all,
 * is quiet. */
static const double QUIET = 0.05;
/* Nodes beside one that is not which are of its place, too. */
enum { MARGIN = 8 };
/* Steps of the whole before places are solved: they give the curve its shape,
 * and smooth curves are done by then.  With 1, of 52 of them, one has a larger
 * F (by 8 %), and they take 875 steps, not 739. */
enum { SHAPED = 8 };
/* Newton's steps of a place, for each time. */
enum { STEPS = 20 };
/* Intervals of a place: longer ones, of up to twice that, are rare.  Six walks
 * of 1000 with exact lengths take 50 steps with 32, 56 with 96. */
enum { WIDTH = 32 };

/* Times that places are solved, of one start: where one comes again and again
 * what is held beside it has to move, too. */
enum { TIMES = 6 };

/* A curve whose places are solved one after the other.  What is on the right of
 * a place turns with its end. */
struct pass {
  const struct ph_arc_system *s;
  struct ph_arc_newton *w;
  struct ph_arc_point *p;
  const bool *busy; /* [n] intervals of places */
  size_t done;      /* nodes that have their new phase */
  double phase;     /* by which the others are to be turned */
  double steps;     /* as parts of those of the whole */
};

/* Whether rows leave a stretch a choice if its ends are held. */
static bool is_free(const struct ph_arc_system *s) {
  size_t hard = s->forms_n - (s->compliance ? 1 : 0);
  return s->refine * s->dim > hard;
}

/* Marks an interval and those beside it. */
static void mark_near(const struct ph_arc_system *s, size_t i, bool *busy) {
  size_t n = s->data->n, margin = (MARGIN + s->refine - 1) / s->refine;
  for (size_t k = n + i - margin; k <= n + i + margin; k++) {
    if (s->data->closed || (k >= n && k < 2 * n)) {
      busy[k % n] = true;
    }
  }
}

/* Marks the intervals of places.  ret whether there are any */
static bool mark(const struct ph_arc_system *s, const struct ph_arc_newton *w,
                 const double *x, double step, bool *busy) {
  size_t n = s->data->n, dim = s->dim;
  double all = ph_arc_dot(s->nodes * dim, x, x) / (double)s->nodes, phase = 0;
  bool any = false;
  memset(busy, 0, n * sizeof *busy);
  for (size_t j = 0; j < s->nodes; j++) {
    const double *w_j = x + j * dim;
    double d[4], size = ph_arc_dot(dim, w_j, w_j) + all;
    for (size_t k = 0; k < dim; k++) {
      d[k] = step * w->dx[j * dim + k];
    }
    if (!(ph_arc_blocks_change(s, x, j, d, &phase) <= QUIET * QUIET * size) ||
        ph_arc_blocks_raised(s, &w->blocks, j)) {
      size_t i = j / s->refine;
      mark_near(s, i < n ? i : n - 1, busy);
      any = true;
    }
  }
  return any;
}

/* ---- one place ----------------------------------------------------------- */

/* Node j of the curve, which may be beyond the seam; and back. */
static void take(const struct ph_arc_system *s, const double *x, size_t j,
                 double *node) {
  bool beyond = j >= s->nodes;
  double chi = beyond && s->turn ? x[s->x_n - 1] : 0;
  const double *w = x + (beyond ? j - s->nodes : j) * s->dim;
  if (s->dim == 4) {
    ph_arc_phase(cos(chi), sin(chi), w, node);
  }
  for (size_t k = 0; s->dim < 4 && k < s->dim; k++) {
    node[k] = (beyond ? s->sign : 1) * w[k];
  }
}

static void put(const struct ph_arc_system *s, const double *node, double phase,
                size_t j, double *x) {
  bool beyond = j >= s->nodes;
  double *w = x + (beyond ? j - s->nodes : j) * s->dim;
  phase -= beyond && s->turn ? x[s->x_n - 1] : 0;
  if (s->dim == 4) {
    ph_arc_phase(cos(phase), sin(phase), node, w);
  }
  for (size_t k = 0; s->dim < 4 && k < s->dim; k++) {
    w[k] = (beyond ? s->sign : 1) * node[k];
  }
}

/* By how much a node was turned. */
static double turned(const struct ph_arc_system *s, const double *from,
                     const double *to) {
  double iw[4];
  if (!s->phases) {
    return 0;
  }
  ph_arc_turned(from, iw);
  return atan2(ph_arc_dot(4, iw, to), ph_arc_dot(4, from, to));
}

/* Turns what is left of a node of the whole. */
static void turn(struct pass *pass, size_t end) {
  double c = cos(pass->phase), s = sin(pass->phase), *x = pass->p->x;
  for (size_t j = pass->done; pass->s->phases && j < end; j++) {
    ph_arc_phase(c, s, x + 4 * j, x + 4 * j);
  }
  pass->done = end;
}

/* Takes over a place that begins with an interval; what is beyond the seam has
 * the turn of the seam. */
static void take_over(struct pass *pass, const struct ph_arc_system *part,
                      size_t first, const struct ph_arc_point *solved) {
  const struct ph_arc_system *s = pass->s;
  size_t at = first * s->refine, dim = s->dim, n = part->nodes;
  size_t from = part->held[0] ? 2 : 0, to = n - (part->held[1] ? 2 : 0);
  double *x = pass->p->x, node[4], left = 0, right = 0;
  if (part->held[0]) {
    take(s, x, at, node);
    left = turned(s, node, solved->x);
  }
  if (part->held[1]) {
    take(s, x, at + n - 1, node);
    right = turned(s, node, solved->x + (n - 1) * dim);
  }
  turn(pass, at + from);
  pass->phase -= left;
  if (at + n > s->nodes && s->turn) {
    x[s->x_n - 1] += right - left;
  }
  for (size_t j = from; j < to; j++) {
    put(s, solved->x + j * dim, pass->phase, at + j, x);
  }
  pass->done = at + to;
  pass->phase += right;
  for (size_t i = 0; i < part->data->n; i++) {
    memcpy(pass->p->y + (first + i) % s->data->n * s->forms_n,
           solved->y + i * s->forms_n, s->forms_n * sizeof *solved->y);
  }
  for (size_t j = at; solved->converged && j < at + n; j++) {
    ph_arc_blocks_lower(s, &pass->w->blocks, j % s->nodes);
  }
}

/* Solves a place of n intervals; false: no memory. */
static bool solve(struct pass *pass, size_t first, size_t n) {
  const struct ph_arc_system *s = pass->s;
  struct ph_arena *arena = pass->w->arena;
  struct ph_mark before = ph_arena_mark(arena);
  struct ph_arc_data data;
  struct ph_arc_system part;
  struct ph_arc_newton work;
  struct ph_arc_point point;
  bool enough = ph_arc_part_of(s, first, n, arena, &data, &part) &&
                ph_arc_newton_alloc(&part, arena, &work) &&
                ph_arc_point_alloc(&part, arena, &point);
  if (enough && !ph_arena_late(arena)) {
    for (size_t j = 0; j < part.nodes; j++) {
      take(s, pass->p->x, first * s->refine + j, point.x + j * s->dim);
    }
    for (size_t i = 0; i < n; i++) {
      memcpy(point.y + i * s->forms_n,
             pass->p->y + (first + i) % s->data->n * s->forms_n,
             s->forms_n * sizeof *point.y);
    }
    point.iterations = 0;
    ph_arc_blocks_begin(&work.blocks);
    ph_arc_newton_solve(&part, &work, STEPS, &point);
    if (isfinite(point.f)) {
      take_over(pass, &part, first, &point);
    }
    pass->steps += (double)point.iterations * (double)n / (double)s->data->n;
  }
  ph_arena_release(arena, before);
  return enough;
}

/* ---- all places ---------------------------------------------------------- */

/* The end of a place in busy intervals that end at `end': long ones are cut,
 * not where they were the last time. */
static size_t cut(size_t first, size_t end, size_t times) {
  size_t odd = times % 2 > 0 ? WIDTH / 2 : 0, at;
  if (end - first <= 2 * WIDTH) {
    return end;
  }
  at = (first + WIDTH / 2 + odd + WIDTH - 1) / WIDTH * WIDTH - odd;
  return end - at < WIDTH / 2 ? end : at;
}

/* How many intervals from one on are busy, of half of WIDTH. */
static size_t run(const struct pass *pass, size_t at, bool back) {
  size_t n = 0;
  while (n < WIDTH / 2 && pass->busy[back ? at - n : at + n]) {
    n++;
  }
  return n;
}

/* Solves all, that over the seam at last; false: no memory.  One that begins or
 * ends just there is left to the whole. */
static bool solve_all(struct pass *pass, size_t times) {
  const struct ph_arc_system *s = pass->s;
  size_t n = s->data->n, head = 0, tail = 0;
  bool enough = true;
  if (s->data->closed && pass->busy[0] && pass->busy[n - 1]) {
    head = run(pass, 0, false);
    tail = run(pass, n - 1, true);
  }
  for (size_t i = head, end; enough && i < n - tail; i = end) {
    for (end = i; end < n - tail && pass->busy[end]; end++) {
    }
    if (end > i) {
      end = cut(i, end, times);
      enough = ph_arc_wraps(s, end - 1) || solve(pass, i, end - i);
    } else {
      end++;
    }
  }
  turn(pass, s->nodes);
  if (s->turn) {
    pass->p->x[s->x_n - 1] += pass->phase;
  }
  pass->phase = 0;
  return enough && (tail == 0 || solve(pass, n - tail, head + tail));
}

bool ph_arc_places(const struct ph_arc_system *s, struct ph_arc_newton *w,
                   double step, size_t steps, struct ph_arc_point *p) {
  struct pass pass = {.s = s, .w = w, .p = p};
  struct ph_mark before = ph_arena_mark(w->arena);
  bool *busy, enough = true;
  if (steps < SHAPED || w->times >= TIMES || !is_free(s)) {
    return true;
  }
  busy = ph_arena_array(w->arena, s->data->n, sizeof *busy);
  if (!busy) {
    return false;
  }
  pass.busy = busy;
  if (mark(s, w, p->x, step, busy)) {
    enough = solve_all(&pass, w->times++);
    p->iterations += (size_t)ceil(pass.steps);
  }
  ph_arena_release(w->arena, before);
  return enough;
}
