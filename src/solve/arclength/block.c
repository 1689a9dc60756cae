/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Blocks of unknowns in Newton's method (see arclength.h). */
#include "solve/arclength/arclength.h"

#include "kernel/band.h"
#include "solve/arclength/system.h"

#include <math.h>
#include <string.h>

/* Intervals of a block; fewer blocks than LEAST are none. */
enum { WIDTH = 16, LEAST = 3 };

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
/* Shifts change by a factor within these bounds: the bend is about as the step
 * is, which is about as 1 / shift only where the shift is large. */
static const double LESS = 0.1, MORE = 4;
static const double RAISED_LEAST = 2, RAISED_MOST = 16;

/* Points with free or exact lengths have blocks: with measured lengths F comes
 * out higher by some thousandths, and directions take more steps. */
static bool has_blocks(const struct ph_arc_system *s) {
  bool soft = s->data->sigma > 0 && s->form[0] == 0;
  return s->data->mode == PH_ARC_POINTS && !soft;
}

bool ph_arc_blocks_alloc(const struct ph_arc_system *s, struct ph_arena *arena,
                         struct ph_arc_blocks *b) {
  size_t width = WIDTH * s->refine * s->dim, size = sizeof(double);
  *b = (struct ph_arc_blocks){.n = s->x_n / width, .width = width};
  if (b->n < LEAST || !has_blocks(s)) {
    b->n = 0;
    return true;
  }
  b->shift = ph_arena_array(arena, b->n, size);
  b->bend = ph_arena_array(arena, b->n, size);
  b->stiff = ph_arena_array(arena, b->n, size);
  b->each = ph_arena_array(arena, s->x_n, size);
  b->pair =
      ph_arena_array(arena, 3 * width, ph_sym_size(1, s->order_band) * size);
  return b->shift && b->bend && b->stiff && b->each && b->pair;
}

void ph_arc_blocks_begin(struct ph_arc_blocks *b) {
  for (size_t k = 0; k < b->n; k++) {
    b->shift[k] = 0;
  }
}

/* The block of a place in the order of matrices. */
static size_t block_at(const struct ph_arc_blocks *b, size_t place) {
  size_t k = place / b->width;
  return k < b->n ? k : b->n - 1;
}

const double *ph_arc_blocks_shifts(const struct ph_arc_system *s,
                                   struct ph_arc_blocks *b) {
  for (size_t k = 0; b->n > 0 && k < s->x_n; k++) {
    b->each[k] = b->shift[block_at(b, s->order[k])];
  }
  return b->n > 0 ? b->each : NULL;
}

/* ---- where the matrix is not convex -------------------------------------- */

/* Adds to the diagonal of some columns. */
static void add_shift(double *matrix, size_t band, size_t from, size_t to,
                      double shift) {
  for (size_t j = from; j < to; j++) {
    *ph_sym_at(matrix, band, j, j) += shift;
  }
}

/* What makes the matrix of the columns of two blocks positive definite, where
 * all before them are eliminated; NaN: nothing does. */
static double missing(double *matrix, size_t band, size_t n, double had,
                      double *pair) {
  double more = 0;
  for (size_t i = 0; i < SHIFTS; i++) {
    memcpy(pair, matrix, ph_sym_size(n, band) * sizeof *pair);
    add_shift(pair, band, 0, n, more);
    if (ph_sym_factor(pair, n, band)) {
      return more;
    }
    more = more > 0 ? SHIFT_GROWS * more : fmax(had, SHIFT_FIRST);
  }
  return (double)NAN;
}

enum ph_arc_shape ph_arc_blocks_convex(const struct ph_arc_system *s,
                                       double *matrix,
                                       struct ph_arc_blocks *b) {
  size_t band = s->order_band;
  enum ph_arc_shape shape = PH_ARC_CONVEX;
  memset(b->bend, 0, b->n * sizeof *b->bend); /* what is added */
  for (size_t k = 0; k + 1 < b->n; k++) {
    size_t low = k * b->width;
    size_t high = k + 2 < b->n ? low + 2 * b->width : s->x_n;
    double *head = ph_sym_at(matrix, band, low, low);
    double more = missing(head, band, high - low,
                          fmax(b->shift[k], b->shift[k + 1]), b->pair);
    if (isnan(more) || ph_arena_late(s->arena)) {
      return PH_ARC_UNKNOWN;
    }
    if (more > 0) {
      add_shift(matrix, band, low, high, more);
      b->bend[k] += more;
      b->bend[k + 1] += more;
      shape = PH_ARC_BENT;
    }
    if (!ph_sym_reduce(head, s->x_n - low, band, b->width)) {
      return PH_ARC_UNKNOWN;
    }
  }
  return shape;
}

void ph_arc_blocks_apply(struct ph_arc_blocks *b) {
  for (size_t k = 0; k < b->n; k++) {
    b->shift[k] += b->bend[k];
  }
}

/* ---- where the rows bend ------------------------------------------------- */

void ph_arc_blocks_look(const struct ph_arc_system *s, const double *gradient,
                        const double *dx, double step, const double *dx2,
                        struct ph_arc_blocks *b) {
  double *size = b->each; /* [n] of them */
  memset(size, 0, b->n * sizeof *size);
  memset(b->bend, 0, b->n * sizeof *b->bend);
  memset(b->stiff, 0, b->n * sizeof *b->stiff);
  for (size_t k = 0; k < s->x_n; k++) {
    size_t at = block_at(b, s->order[k]);
    double v = step * dx[k], c = dx2[k] - v, g = step * gradient[k];
    size[at] += v * v;
    b->bend[at] += c * c;
    b->stiff[at] += g * g;
  }
  for (size_t k = 0; k < b->n; k++) {
    b->bend[k] = size[k] > 0 ? sqrt(b->bend[k] / size[k]) : 0;
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
      double factor = fmin(fmax(b->bend[k] / BEND, RAISED_LEAST), RAISED_MOST);
      b->shift[k] = fmax(factor * b->shift[k], fmax(b->stiff[k], SHIFT_LEAST));
      raised = true;
    }
  }
  return raised;
}

void ph_arc_blocks_settle(struct ph_arc_blocks *b) {
  for (size_t k = 0; k < b->n; k++) {
    b->shift[k] *= fmin(fmax(b->bend[k] / BEND, LESS), MORE);
    b->shift[k] = b->shift[k] < SHIFT_NONE ? 0 : b->shift[k];
  }
}
