/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Windows of the augmented Lagrangian (see arclength.h). */
#include "solve/arclength/arclength.h"

#include "kernel/band.h"
#include "solve/arclength/system.h"

#include <math.h>
#include <string.h>

/* Intervals of a window; fewer than LEAST have none.  A rest of fewer nodes
 * than 5 r + 1 joins the last window. */
enum { WIDTH = 16, LEAST = 24 };

/* The trusted radius at first, relative to |x| there. */
static const double RADIUS = 0.3;
/* A step is taken, and changes the radius, as those of the whole do. */
static const double GAIN = 0.01, POOR = 0.25, GOOD = 0.75, ABOUT = 0.45,
                    SHORTER = 0.5, REFUSED = 0.25, LONGER = 2.5;
enum { REFUSALS = 8 };
/* A window is left alone for this sweep where no more than this of its value is
 * to be gained. */
static const double NOTHING = 1e-11;

/* ---- where they are ------------------------------------------------------ */

/* The intervals that node j belongs to: *first, and how many after it. */
static size_t intervals_of(const struct ph_arc_system *s, size_t j,
                           size_t *first) {
  size_t n = s->data->n, r = s->refine, last = j / r;
  /* r i <= j <= r i + r + 1 */
  size_t from = j > r + 1 ? (j - 2) / r : 0;
  if (s->data->closed) {
    from = (j + n * r - r - 1 + r - 1) / r;
    last = (j + n * r) / r;
  }
  last = !s->data->closed && last >= n ? n - 1 : last;
  *first = from;
  return last - from + 1;
}

/* Adds the intervals that a window touches, each once; mark[n]. */
static void set_intervals(const struct ph_arc_system *s,
                          struct ph_arc_windows *w, size_t k, size_t *mark) {
  struct ph_arc_window *window = &w->window[k];
  size_t chi = s->turn ? 1 : 0;
  window->first = k > 0 ? w->window[k - 1].last : 0;
  window->last = window->first;
  for (size_t p = (window->low - chi) / s->dim;
       p < (window->high - chi) / s->dim; p++) {
    size_t first, count = intervals_of(s, w->node[p], &first);
    for (size_t i = first; i < first + count; i++) {
      size_t at = i % s->data->n;
      if (mark[at] != k + 1) {
        mark[at] = k + 1;
        w->interval[window->last++] = at;
      }
    }
  }
}

/* How windows follow each other, in nodes. */
struct spacing {
  size_t width, gap, tail;
};

/* One sweep, of which the first window has `size` nodes. */
static void set_sweep(const struct ph_arc_system *s, struct ph_arc_windows *w,
                      size_t size, const struct spacing *spacing) {
  size_t chi = s->turn ? 1 : 0;
  for (size_t at = 0; at < s->nodes; size = spacing->width) {
    struct ph_arc_window *window = &w->window[w->n++];
    size_t rest = s->nodes - at;
    size = rest < size + spacing->gap + spacing->tail ? rest : size;
    window->low = chi + at * s->dim;
    window->high = chi + (at + size) * s->dim;
    at += size + spacing->gap;
  }
}

bool ph_arc_windows_alloc(const struct ph_arc_system *s, struct ph_arena *arena,
                          struct ph_arc_windows *w) {
  size_t r = s->refine, n = s->data->n, chi = s->turn ? 1 : 0, *mark;
  struct spacing spacing = {
      WIDTH * r, s->data->closed ? s->order_band / s->dim + 1 : r + 1,
      5 * r + 1};
  size_t most = spacing.width + spacing.gap + spacing.tail;
  *w = (struct ph_arc_windows){0};
  if (n < LEAST) {
    return true;
  }
  w->window = ph_arena_array(arena, 2 * (s->nodes / spacing.width + 2),
                             sizeof *w->window);
  w->interval = ph_arena_array(arena, 2 * n, sizeof *w->interval);
  w->node = ph_arena_array(arena, s->nodes, sizeof *w->node);
  w->y = ph_arena_array(arena, s->y_n, sizeof *w->y);
  mark = ph_arena_array(arena, n, sizeof *mark);
  if (!w->window || !w->interval || !w->node || !w->y || !mark ||
      !ph_arc_region_alloc(most * s->dim, s->order_band, arena, &w->region)) {
    return false;
  }
  for (size_t j = 0; j < s->nodes; j++) {
    w->node[(s->order[j * s->dim] - chi) / s->dim] = (uint32_t)j;
  }
  set_sweep(s, w, spacing.width, &spacing);
  w->part[1] = w->n;
  set_sweep(s, w, spacing.width / 2, &spacing);
  w->part[2] = w->n;
  memset(mark, 0, n * sizeof *mark);
  for (size_t k = 0; k < w->n; k++) {
    set_intervals(s, w, k, mark);
  }
  return true;
}

/* ---- a step -------------------------------------------------------------- */

/* The rows of an interval: its own, and those of its knots. */
struct rows {
  size_t begin[2], end[2];
};

static struct rows rows_of(const struct ph_arc_system *s, size_t i) {
  size_t first = s->data->n * s->forms_n;
  return (struct rows){
      {i * s->forms_n, first + i * s->knot_rows},
      {(i + 1) * s->forms_n, first + ph_arc_knots_end(s, i) * s->knot_rows}};
}

/* The part of a window of what is minimised.  out c its rows */
static double value_at(const struct ph_arc_lagrangian *g,
                       const struct ph_arc_window *window, const double *x,
                       double *c) {
  const size_t *interval = g->w->windows.interval;
  double sum = 0;
  for (size_t k = window->first; k < window->last; k++) {
    struct rows rows = rows_of(g->s, interval[k]);
    sum += ph_arc_interval(g->s, x, interval[k], c);
    for (size_t part = 0; part < 2; part++) {
      for (size_t r = rows.begin[part]; r < rows.end[part]; r++) {
        sum += ph_arc_row_value(g, c, r);
      }
    }
  }
  return sum;
}

/* to = x + step in the window. */
static void retract(const struct ph_arc_lagrangian *g,
                    const struct ph_arc_window *window, double *to) {
  const struct ph_arc_system *s = g->s;
  size_t chi = s->turn ? 1 : 0;
  for (size_t p = (window->low - chi) / s->dim;
       p < (window->high - chi) / s->dim; p++) {
    ph_arc_retract_node(s, g->x, g->w->step, 1, g->w->windows.node[p], to);
  }
}

/* Adds a vector of the window to the step. */
static void add_step(const struct ph_arc_lagrangian *g,
                     const struct ph_arc_window *window, const double *v) {
  const struct ph_arc_system *s = g->s;
  size_t chi = s->turn ? 1 : 0, dim = s->dim;
  for (size_t k = window->low; k < window->high; k++) {
    size_t j = g->w->windows.node[(k - chi) / dim];
    g->w->step[j * dim + (k - chi) % dim] += v[k - window->low];
  }
}

/* In the window, as in x. */
static void restore(const struct ph_arc_lagrangian *g,
                    const struct ph_arc_window *window, const double *from,
                    double *to) {
  const struct ph_arc_system *s = g->s;
  size_t chi = s->turn ? 1 : 0;
  for (size_t p = (window->low - chi) / s->dim;
       p < (window->high - chi) / s->dim; p++) {
    size_t j = g->w->windows.node[p];
    memcpy(to + j * s->dim, from + j * s->dim, s->dim * sizeof *to);
  }
}

static void clear(const struct ph_arc_lagrangian *g,
                  const struct ph_arc_window *window, double *v) {
  const struct ph_arc_system *s = g->s;
  size_t chi = s->turn ? 1 : 0;
  for (size_t p = (window->low - chi) / s->dim;
       p < (window->high - chi) / s->dim; p++) {
    memset(v + g->w->windows.node[p] * s->dim, 0, s->dim * sizeof *v);
  }
}

/* Takes the curvature of the rows back with the same factor. */
static void correct(struct ph_arc_lagrangian *g,
                    const struct ph_arc_window *window) {
  const struct ph_arc_system *s = g->s;
  struct ph_arc_work *w = g->w;
  struct ph_arc_windows *all = &w->windows;
  double *q = all->y, *second = w->ordered, *v = all->region.other;
  size_t chi = s->turn ? 1 : 0, dim = s->dim;
  for (size_t k = window->first; k < window->last; k++) {
    size_t index[PH_ARC_LOCAL], touched = ph_arc_touched(s, all->interval[k]);
    ph_arc_index(s, all->interval[k], index);
    for (size_t a = 0; a < touched; a++) {
      second[index[a]] = 0;
    }
  }
  for (size_t k = window->first; k < window->last; k++) {
    size_t i = all->interval[k];
    struct rows rows = rows_of(s, i);
    ph_arc_rows_times_of(s, &w->linear, i, w->step, q);
    for (size_t part = 0; part < 2; part++) {
      for (size_t r = rows.begin[part]; r < rows.end[part]; r++) {
        q[r] = ph_arc_row_weight(g, r) * (w->c_to[r] - w->c[r] - q[r]);
      }
    }
    ph_arc_add_rows_of(s, &w->linear, i, q, second);
  }
  for (size_t k = window->low; k < window->high; k++) {
    size_t j = all->node[(k - chi) / dim];
    v[k - window->low] = second[j * dim + (k - chi) % dim];
  }
  ph_arc_region_solve(&all->region, v);
  add_step(g, window, v);
}

/* The step of the region, corrected if that is better, in w->to.  ret what it
 * gained */
static double try_step(struct ph_arc_lagrangian *g,
                       const struct ph_arc_window *window, double before) {
  struct ph_arc_work *w = g->w;
  double to, better;
  add_step(g, window, w->windows.region.step);
  retract(g, window, w->to);
  to = value_at(g, window, w->to, w->c_to);
  correct(g, window);
  retract(g, window, w->better);
  clear(g, window, w->step);
  better = value_at(g, window, w->better, w->c_better);
  if (better < to || isnan(to)) {
    restore(g, window, w->better, w->to);
    to = better;
  }
  return before - to;
}

/* Moves the nodes of a window; all else stays. */
static void advance(struct ph_arc_lagrangian *g, struct ph_arc_window *window) {
  struct ph_arc_work *w = g->w;
  struct ph_arc_region *region = &w->windows.region;
  double above = 0, before = value_at(g, window, g->x, w->c_better);
  region->n = window->high - window->low;
  region->matrix =
      ph_sym_at(w->region.matrix, region->band, window->low, window->low);
  region->g = w->region.g + window->low;
  region->hint = window->hint;
  region->shift = 0;
  for (size_t k = 0; k < REFUSALS; k++) {
    double gain;
    if (!ph_arc_region_step(region, window->radius, above) ||
        !(region->fall > NOTHING * fabs(before))) {
      break;
    }
    gain = try_step(g, window, before) / region->fall;
    if (gain >= GAIN) {
      restore(g, window, w->to, g->x);
      if (gain <= POOR) {
        window->radius = SHORTER * region->length;
      } else if (gain > GOOD && region->length > ABOUT * window->radius) {
        window->radius *= LONGER;
      }
      break;
    }
    window->radius = REFUSED * region->length;
    above = region->shift;
  }
  window->hint = region->hint;
}

void ph_arc_windows_begin(struct ph_arc_lagrangian *g) {
  const struct ph_arc_system *s = g->s;
  struct ph_arc_windows *w = &g->w->windows;
  size_t chi = s->turn ? 1 : 0;
  for (size_t k = 0; k < w->n; k++) {
    struct ph_arc_window *window = &w->window[k];
    double sum = 0;
    for (size_t p = (window->low - chi) / s->dim;
         p < (window->high - chi) / s->dim; p++) {
      const double *x = g->x + w->node[p] * s->dim;
      sum += ph_arc_dot(s->dim, x, x);
    }
    window->radius = RADIUS * sqrt(sum);
    window->hint = 0;
  }
}

void ph_arc_sweep(struct ph_arc_lagrangian *g, size_t sweep) {
  const struct ph_arc_system *s = g->s;
  struct ph_arc_work *w = g->w;
  ph_arc_model(g);
  memcpy(w->to, g->x, s->x_n * sizeof *g->x);
  memcpy(w->better, g->x, s->x_n * sizeof *g->x);
  memset(w->step, 0, s->x_n * sizeof *w->step);
  for (size_t k = w->windows.part[sweep];
       k < w->windows.part[sweep + 1] && !ph_arena_late(w->arena); k++) {
    advance(g, &w->windows.window[k]);
  }
}
