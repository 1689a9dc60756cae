/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Blocks of unknowns in Newton's method (see newton.h). */
#include "solve/arclength/arclength.h"

#include "kernel/band.h"
#include "solve/arclength/system.h"

#include <math.h>
#include <string.h>

/* Intervals of a block. */
enum { WIDTH = 16 };

/* Shifts of a pair of blocks that is not convex, until it is: the first, by
 * how much they grow, and how many at most. */
static const double SHIFT_FIRST = 1e-7, SHIFT_GROWS = 8;
enum { SHIFTS = 24 };
/* A shift below this is none, and one that is raised for its rows is more. */
static const double SHIFT_NONE = 1e-10, SHIFT_LEAST = 1e-3;

/* The bend that is aimed at: what the correction leaves is about its square,
 * 1/16 of the step.  With .15 as many steps are needed. */
static const double BEND = 0.25;
/* Blocks that bend by more than BENT are raised where a step is refused, or, if
 * none does, those that bend most; below STRAIGHT it is not their rows. */
static const double BENT = 0.5, STRAIGHT = 0.1;
/* A correction that is less than this part of the largest of a block is not why
 * steps are refused: it comes from that block, and no shift makes it less. */
static const double PART = 0.1;
/* Shifts change by a factor within these bounds: the bend is about as the step
 * is, which is about as 1 / shift only where the shift is large. */
static const double LESS = 0.1, MORE = 4;
static const double RAISED_LEAST = 2, RAISED_MOST = 16;

/* How many places are before those of the nodes. */
static size_t chi_of(const struct ph_arc_system *s) {
  return s->turn ? 1 : 0;
}

/* How many nodes are before a place that is one's first. */
static size_t node_at(const struct ph_arc_system *s, size_t place) {
  return (place - chi_of(s)) / s->dim;
}

bool ph_arc_blocks_alloc(const struct ph_arc_system *s, struct ph_arena *arena,
                         struct ph_arc_blocks *b) {
  size_t width = WIDTH * s->refine * s->dim, size = sizeof(double);
  *b = (struct ph_arc_blocks){.n = s->x_n / width, .width = width};
  if (s->nodes < (s->part ? 2 * WIDTH : PH_ARC_MANY) * s->refine ||
      s->data->mode != PH_ARC_POINTS) {
    b->n = 0; /* directions take more steps with blocks */
    return true;
  }
  b->shift = ph_arena_array(arena, b->n, size);
  b->hold = ph_arena_array(arena, b->n, size);
  b->more[0] = ph_arena_array(arena, b->n, size);
  b->more[1] = ph_arena_array(arena, b->n, size);
  b->bend = ph_arena_array(arena, b->n, size);
  b->stiff = ph_arena_array(arena, b->n, size);
  b->each = ph_arena_array(arena, 2 * s->nodes, size);
  b->pair =
      ph_arena_array(arena, 3 * width, ph_sym_size(1, s->order_band) * size);
  b->node = ph_arena_array(arena, s->nodes, sizeof *b->node);
  for (size_t j = 0; b->node && j < s->nodes; j++) {
    b->node[node_at(s, s->order[j * s->dim])] = (uint32_t)j;
  }
  return b->shift && b->hold && b->more[0] && b->more[1] && b->bend &&
         b->stiff && b->each && b->pair && b->node;
}

void ph_arc_blocks_begin(struct ph_arc_blocks *b) {
  for (size_t k = 0; k < b->n; k++) {
    b->shift[k] = b->hold[k] = 0;
  }
}

/* The block of node j. */
static size_t block_of(const struct ph_arc_system *s,
                       const struct ph_arc_blocks *b, size_t j) {
  size_t k = node_at(s, s->order[j * s->dim]) * s->dim / b->width;
  return k < b->n ? k : b->n - 1;
}

/* The first place of a block, or the end. */
static size_t first_of(const struct ph_arc_system *s,
                       const struct ph_arc_blocks *b, size_t k) {
  return k == 0 ? 0 : k < b->n ? chi_of(s) + k * b->width : s->x_n;
}

void ph_arc_blocks_weights(const struct ph_arc_system *s,
                           struct ph_arc_blocks *b,
                           struct ph_arc_weights *weights) {
  for (size_t j = 0; b->n > 0 && j < s->nodes; j++) {
    size_t k = block_of(s, b, j);
    b->each[j] = b->shift[k];
    b->each[s->nodes + j] = b->hold[k];
  }
  weights->shifts = b->n > 0 ? b->each : NULL;
  weights->holds = b->n > 0 ? b->each + s->nodes : NULL;
}

/* ---- where the matrix is not convex -------------------------------------- */

/* Some columns of a matrix: places low to high - 1. */
struct columns {
  const struct ph_arc_system *s;
  const struct ph_arc_blocks *b;
  const double *x;
  size_t low, high;
  bool more; /* the matrix has all that follow, too */
};

/* Adds at rows i, i + 1, ... and columns j, j + 1, ... */
static void add_square(const struct columns *c, double *matrix, size_t i,
                       size_t j, const double *square) {
  size_t dim = c->s->dim;
  for (size_t e = 0; e < dim; e++) {
    for (size_t d = i == j ? e : 0; d < dim; d++) {
      *ph_sym_at(matrix, c->s->order_band, i - c->low + d, j - c->low + e) +=
          square[d * dim + e];
    }
  }
}

/* What links the phase of node j to that of a neighbour.  Before the columns
 * all is eliminated: there it is left out, as it is not negative. */
static void add_link(const struct columns *c, size_t j, size_t neighbour,
                     double shift, double *matrix) {
  const double *w = c->x + 4 * j, *v = c->x + 4 * neighbour;
  size_t here = c->s->order[4 * j], there = c->s->order[4 * neighbour],
         end = c->more ? c->s->x_n : c->high;
  double own[16], cross[16], back[16];
  if (there < c->low) {
    return;
  }
  ph_arc_link_square(w, v, shift, own, cross);
  add_square(c, matrix, here, here, own);
  if (there < end) {
    ph_arc_link_square(v, w, shift, own, back);
    add_square(c, matrix, there, there, own);
    if (there > here) {
      add_square(c, matrix, there, here, cross);
    } else {
      add_square(c, matrix, here, there, back);
    }
  }
}

/* Adds a shift to the nodes of the columns, as ph_arc_weights has it: each has
 * half of what links it to its neighbours. */
static void add_shift(const struct columns *c, double shift, double *matrix) {
  const struct ph_arc_system *s = c->s;
  size_t chi = chi_of(s), dim = s->dim;
  for (size_t place = c->low > chi ? c->low : chi; place < c->high;
       place += dim) {
    size_t j = c->b->node[node_at(s, place)];
    double square[16];
    ph_arc_change_square(s, c->x + j * dim, shift, square);
    add_square(c, matrix, place, place, square);
    if (s->phases && j > 0) {
      add_link(c, j, j - 1, shift / 2, matrix);
    }
    if (s->phases && j + 1 < s->nodes) {
      add_link(c, j, j + 1, shift / 2, matrix);
    }
  }
  if (chi > c->low) {
    *ph_sym_at(matrix, s->order_band, 0, 0) += shift;
  }
}

/* The same of a hold. */
static void add_hold(const struct columns *c, double hold, double *matrix) {
  for (size_t k = 0; k < c->high - c->low; k++) {
    *ph_sym_at(matrix, c->s->order_band, k, k) += hold;
  }
}

static void add(const struct columns *c, bool hold, double more,
                double *matrix) {
  if (more > 0) {
    (hold ? add_hold : add_shift)(c, more, matrix);
  }
}

/* The shift, or hold, that makes the matrix of the columns of two blocks
 * positive definite, where all before them are eliminated; NaN: none up to
 * `most' does. */
static double missing(const struct columns *c, const double *matrix, bool hold,
                      double had, double most) {
  double more = 0, *pair = c->b->pair;
  size_t n = c->high - c->low, band = c->s->order_band;
  for (size_t i = 0; i < SHIFTS && more <= most; i++) {
    memcpy(pair, matrix, ph_sym_size(n, band) * sizeof *pair);
    add(c, hold, more, pair);
    if (ph_sym_factor(pair, n, band)) {
      return more;
    }
    more = more > 0 ? SHIFT_GROWS * more : fmax(had, SHIFT_FIRST);
  }
  return (double)NAN;
}

/* Makes the columns of blocks k and k + 1 positive definite.  A shift does
 * where they bend; where all that is on one side of a place before them wants
 * to turn about it, they are held.  ret false: nothing does */
static bool straighten(struct columns *c, size_t k, double *head) {
  const struct ph_arc_blocks *b = c->b;
  bool hold = false;
  double had = fmax(b->shift[k], b->shift[k + 1]);
  double more = missing(c, head, false, had, b->most);
  if (isnan(more)) {
    hold = true;
    had = fmax(b->hold[k], b->hold[k + 1]);
    more = missing(c, head, true, had, (double)INFINITY);
  }
  if (isnan(more)) {
    return false;
  }
  c->more = true;
  add(c, hold, more, head);
  b->more[hold][k] += more;
  b->more[hold][k + 1] += more;
  return true;
}

enum ph_arc_shape ph_arc_blocks_convex(const struct ph_arc_system *s,
                                       const double *x, double *matrix,
                                       struct ph_arc_blocks *b) {
  size_t band = s->order_band;
  enum ph_arc_shape shape = PH_ARC_CONVEX;
  memset(b->more[0], 0, b->n * sizeof *b->more[0]);
  memset(b->more[1], 0, b->n * sizeof *b->more[1]);
  for (size_t k = 0; k + 1 < b->n; k++) {
    struct columns c = {s,    b, x, first_of(s, b, k), first_of(s, b, k + 2),
                        false};
    double *head = ph_sym_at(matrix, band, c.low, c.low);
    if (ph_arena_late(s->arena) || !straighten(&c, k, head) ||
        !ph_sym_reduce(head, s->x_n - c.low, band,
                       first_of(s, b, k + 1) - c.low)) {
      return PH_ARC_UNKNOWN;
    }
    if (fmax(b->more[0][k], b->more[1][k]) > 0) { /* or of k - 1 and k */
      shape = PH_ARC_BENT;
    }
  }
  return shape;
}

void ph_arc_blocks_apply(struct ph_arc_blocks *b) {
  for (size_t k = 0; k < b->n; k++) {
    b->shift[k] += b->more[0][k];
    b->hold[k] += b->more[1][k];
  }
}

/* ---- where the rows bend ------------------------------------------------- */

double ph_arc_blocks_change(const struct ph_arc_system *s, const double *x,
                            size_t j, const double *change, double *phase) {
  const double *w = x + j * s->dim;
  double rest[4], p = ph_arc_split(s, w, change, rest);
  double turn = j > 0 ? p - *phase : 0;
  *phase = p;
  return ph_arc_dot(s->dim, rest, rest) +
         ph_arc_dot(s->dim, w, w) * turn * turn;
}

void ph_arc_blocks_look(const struct ph_arc_system *s, const double *x,
                        const double *gradient, const double *dx, double step,
                        const double *dx2, struct ph_arc_blocks *b) {
  double *size = b->each, phases[2] = {0, 0}, most = 0; /* [n] of sizes */
  memset(size, 0, b->n * sizeof *size);
  memset(b->bend, 0, b->n * sizeof *b->bend);
  memset(b->stiff, 0, b->n * sizeof *b->stiff);
  for (size_t j = 0; j < s->nodes; j++) {
    size_t at = block_of(s, b, j);
    double v[4], c[4];
    for (size_t k = 0; k < s->dim; k++) {
      size_t i = j * s->dim + k;
      double g = step * gradient[i];
      v[k] = step * dx[i];
      c[k] = dx2[i] - v[k];
      b->stiff[at] += g * g;
    }
    size[at] += ph_arc_blocks_change(s, x, j, v, &phases[0]);
    b->bend[at] += ph_arc_blocks_change(s, x, j, c, &phases[1]);
  }
  for (size_t k = 0; k < b->n; k++) {
    most = b->bend[k] <= most ? most : b->bend[k];
  }
  for (size_t k = 0; k < b->n; k++) {
    bool less = b->bend[k] < PART * PART * most || !(size[k] > 0);
    b->bend[k] = less ? 0 : sqrt(b->bend[k] / size[k]);
    b->stiff[k] = size[k] > 0 ? sqrt(b->stiff[k] / size[k]) : 0;
  }
}

bool ph_arc_blocks_raise(struct ph_arc_blocks *b) {
  double worst = 0, most;
  bool raised = false;
  for (size_t k = 0; k < b->n; k++) {
    worst = b->bend[k] <= worst ? worst : b->bend[k];
  }
  most = worst > BENT ? BENT : worst / 2;
  for (size_t k = 0; k < b->n && !(worst <= STRAIGHT); k++) {
    if (!(b->bend[k] <= most)) {
      double shift = fmin(fmax(b->bend[k] / BEND, RAISED_LEAST), RAISED_MOST);
      shift = fmax(shift * b->shift[k], fmax(b->stiff[k], SHIFT_LEAST));
      shift = fmax(fmin(shift, b->most), b->shift[k]);
      raised = raised || shift > b->shift[k];
      b->shift[k] = shift;
    }
  }
  return raised;
}

void ph_arc_blocks_settle(struct ph_arc_blocks *b) {
  for (size_t k = 0; k < b->n; k++) {
    double shift = fmin(fmax(b->bend[k] / BEND, LESS), MORE) * b->shift[k];
    b->shift[k] = fmin(shift, fmax(b->most, b->shift[k]));
    b->shift[k] = b->shift[k] < SHIFT_NONE ? 0 : b->shift[k];
    b->hold[k] *= b->hold[k] > SHIFT_NONE ? LESS : 0;
  }
}

/* ---- of a node ----------------------------------------------------------- */

bool ph_arc_blocks_raised(const struct ph_arc_system *s,
                          const struct ph_arc_blocks *b, size_t j) {
  size_t k = block_of(s, b, j);
  return b->shift[k] > 0 || b->hold[k] > 0;
}

void ph_arc_blocks_lower(const struct ph_arc_system *s, struct ph_arc_blocks *b,
                         size_t j) {
  size_t k = block_of(s, b, j);
  b->shift[k] = b->hold[k] = 0;
}
