/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Which loops of offsets are around which (see loop.h). */
#include "curve/offset/loop.h"

#include "kernel/cplx.h"
#include "kernel/pi.h"

#include <float.h>

/* Points of a piece at most; halvings of one beside a place. */
enum { POINTS_MAX = 2 * 9, HALVINGS_MAX = 60 };

/* Of coordinates that are no more than 1. */
static const double ROUNDING = 8 * DBL_EPSILON;

/* Control points from the place, times their weights, at a scale in range: all
 * that directions from there need. */
struct piece {
  size_t n;
  ph_cplx p[POINTS_MAX];
};

static struct piece piece_of(const struct ph_loop_piece *of, size_t points,
                             const double *at) {
  struct piece piece = {.n = points};
  double weight = 0, size = fmax(fabs(at[0]), fabs(at[1]));
  int exponent;
  for (size_t j = 0; j < points; j++) {
    const double *p = of->control_points + 2 * j;
    weight = fmax(weight, of->weights[j]);
    size = fmax(size, fmax(fabs(p[0]), fabs(p[1])));
  }
  frexp(size, &exponent);
  for (size_t j = 0; j < points; j++) {
    const double *p = of->control_points + 2 * j, w = of->weights[j] / weight;
    piece.p[j] =
        ph_cplx_of(w * (ldexp(p[0], -exponent) - ldexp(at[0], -exponent)),
                   w * (ldexp(p[1], -exponent) - ldexp(at[1], -exponent)));
  }
  return piece;
}

/* Whether all of it is where the place is, as far as can be told: so are its
 * halves, and theirs. */
static bool is_there(const struct piece *piece) {
  size_t i = 0;
  while (i < piece->n && !(ph_cplx_abs(piece->p[i]) > ROUNDING)) {
    i++;
  }
  return i == piece->n;
}

/* The angle from end to end, where a half plane through the place holds all of
 * the piece; false if none is found. */
static bool is_aside(const struct piece *piece, double *angle) {
  const ph_cplx a = piece->p[0], b = piece->p[piece->n - 1];
  const ph_cplx m = ph_cplx_add(ph_cplx_scale(1 / ph_cplx_abs(a), a),
                                ph_cplx_scale(1 / ph_cplx_abs(b), b));
  for (size_t i = 0; i < piece->n; i++) {
    if (!(ph_cplx_dot(piece->p[i], m) > 0)) {
      return false;
    }
  }
  *angle = atan2(ph_cplx_cross(a, b), ph_cplx_dot(a, b));
  return true;
}

static double angle_of(const struct piece *piece, int depth) {
  struct piece left = {.n = piece->n}, right = *piece;
  double angle = 0;
  if (is_there(piece) || is_aside(piece, &angle) || depth == HALVINGS_MAX) {
    return angle;
  }
  for (size_t i = 0, last = piece->n - 1; i <= last; i++) {
    left.p[i] = right.p[0];
    for (size_t j = 0; j + i < last; j++) {
      right.p[j] = ph_cplx_between(right.p[j], right.p[j + 1], 0.5);
    }
  }
  return angle_of(&left, depth + 1) + angle_of(&right, depth + 1);
}

/* Whether a loop goes round a place. */
static bool is_around(const struct ph_loop *loop, size_t points,
                      const double *at) {
  double sum = 0;
  for (size_t i = 0; i < loop->n; i++) {
    const struct piece piece = piece_of(&loop->pieces[i], points, at);
    sum += angle_of(&piece, 0);
  }
  return fabs(sum) > PH_PI;
}

/* The offset of the next smaller distance to the same side; NULL: none. */
static const struct ph_offset *within(const struct ph_offset *offsets, size_t n,
                                      const struct ph_offset *of) {
  const struct ph_offset *best = NULL;
  for (size_t i = 0; i < n; i++) {
    const struct ph_offset *o = &offsets[i];
    if (o->loops.mode && o->distance * of->distance > 0 &&
        fabs(o->distance) < fabs(of->distance) &&
        (!best || fabs(o->distance) > fabs(best->distance))) {
      best = o;
    }
  }
  return best;
}

void ph_loops_nest(struct ph_offset *offsets, size_t n) {
  for (size_t i = 0; i < n; i++) {
    const struct ph_offset *in = within(offsets, n, &offsets[i]);
    for (size_t k = 0; in && k < offsets[i].loops.n; k++) {
      struct ph_loop *loop = &offsets[i].loops.v[k];
      for (size_t j = 0; loop->closed && j < in->loops.n; j++) {
        const struct ph_loop *around = &in->loops.v[j];
        const bool nearer =
            loop->parent == PH_NO_SEGMENT ||
            fabs(around->area) < fabs(in->loops.v[loop->parent].area);
        if (around->closed && nearer &&
            is_around(around, in->degree + 1, loop->pieces[0].control_points)) {
          loop->parent = j;
        }
      }
    }
  }
}
