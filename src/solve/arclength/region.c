/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Steps within a trusted radius (see arclength.h). */
#include "solve/arclength/arclength.h"

#include "kernel/band.h"
#include "solve/arclength/system.h"

#include <float.h>
#include <math.h>
#include <stdint.h>
#include <string.h>

/* How exactly the radius is kept: a factor costs more than it gains. */
static const double SHORT = 0.5, LONG = 1.6;

/* The first shift of a matrix that is not positive definite, and how shifts
 * grow. */
static const double SHIFT_FIRST = 1e-2, SHIFT_GROWS = 4;

/* Factors for one step: 2 or 3 are the rule.  After some, a step that is short
 * is taken. */
enum { FACTORS = 40, FACTORS_MANY = 8 };

/* Bounds of the shift this near to each other leave nothing to choose. */
static const double NARROW = 1.05;

/* Inverse iterations for the lowest direction. */
enum { INVERSE = 3 };

bool ph_arc_region_alloc(size_t n, size_t band, struct ph_arena *arena,
                         struct ph_arc_region *r) {
  size_t size = ph_sym_size(n, band);
  *r = (struct ph_arc_region){
      .n = n,
      .band = band,
      .matrix = ph_arena_array(arena, size, sizeof(double)),
      .factor = ph_arena_array(arena, size, sizeof(double)),
      .g = ph_arena_array(arena, n, sizeof(double)),
      .step = ph_arena_array(arena, n, sizeof(double)),
      .other = ph_arena_array(arena, n, sizeof(double))};
  return r->matrix && r->factor && r->g && r->step && r->other;
}

void ph_arc_region_solve(const struct ph_arc_region *r, double *v) {
  for (size_t k = 0; k < r->n; k++) {
    v[k] = -v[k];
  }
  ph_sym_solve(r->factor, r->n, r->band, v);
}

static bool factor(struct ph_arc_region *r, double shift) {
  memcpy(r->factor, r->matrix, ph_sym_size(r->n, r->band) * sizeof *r->factor);
  for (size_t k = 0; k < r->n; k++) {
    *ph_sym_at(r->factor, r->band, k, k) += shift;
  }
  r->factors++;
  return ph_sym_factor(r->factor, r->n, r->band);
}

static double norm(const struct ph_arc_region *r, const double *v) {
  return sqrt(ph_arc_dot(r->n, v, v));
}

/* The step of this factor. */
static void set_step(struct ph_arc_region *r, double shift) {
  memcpy(r->step, r->g, r->n * sizeof *r->g);
  ph_arc_region_solve(r, r->step);
  r->shift = shift;
  r->length = norm(r, r->step);
}

/* Between these bounds is the shift. */
struct bounds {
  double low, high;
};

/* The next shift to try, between the bounds. */
static double between(const struct bounds *b) {
  return isfinite(b->high)
             ? fmax(sqrt(b->low * b->high), 0.95 * b->low + 0.05 * b->high)
             : fmax(SHIFT_GROWS * b->low, SHIFT_FIRST);
}

/* Newton's method for 1 / |s| = 1 / radius, which is nearly linear in the
 * shift; narrows the bounds. */
static double next_shift(struct ph_arc_region *r, double radius,
                         struct bounds *b) {
  double slope, next;
  memcpy(r->other, r->step, r->n * sizeof *r->step);
  ph_sym_solve(r->factor, r->n, r->band, r->other);
  slope = ph_arc_dot(r->n, r->step, r->other);
  next =
      r->shift + r->length * r->length / slope * (r->length - radius) / radius;
  if (r->length > radius) {
    b->low = r->shift;
  } else {
    b->high = r->shift;
  }
  if (!(next > 0) && !(b->low > 0)) {
    return 0;
  }
  return next > b->low && next < b->high ? next : between(b);
}

/* A factor and step near the radius; false: none. */
static bool search(struct ph_arc_region *r, double radius, double above) {
  struct bounds b = {above, (double)INFINITY};
  double shift = above > 0      ? fmax(SHIFT_GROWS / 2 * above, r->hint)
                 : r->shift > 0 ? r->hint
                                : 0;
  for (size_t k = 0; k < FACTORS; k++) {
    if (!factor(r, shift)) {
      b.low = fmax(fmax(b.low, shift), DBL_MIN); /* tried, if 0 */
      shift = k == 0 && r->hint > b.low ? r->hint : between(&b);
      continue;
    }
    set_step(r, shift);
    if (!(r->length > radius) &&
        (!(shift > 0) || r->length >= SHORT * radius ||
         b.high <= NARROW * b.low || k > FACTORS_MANY)) {
      return true;
    }
    if (r->length > radius && r->length <= LONG * radius) {
      return true;
    }
    shift = next_shift(r, radius, &b);
  }
  return false;
}

/* z . A z, where A + shift = L L^T. */
static double curvature(const struct ph_arc_region *r, const double *z) {
  double sum = 0;
  for (size_t j = 0; j < r->n; j++) {
    size_t rest = r->n - j, rows = rest < r->band + 1 ? rest : r->band + 1;
    double v = ph_arc_dot(rows, ph_sym_at(r->factor, r->band, j, j), z + j);
    sum += v * v;
  }
  return sum - r->shift * ph_arc_dot(r->n, z, z);
}

/* A unit vector along which A has nearly its least curvature, in r->other. */
static void set_lowest(struct ph_arc_region *r) {
  uint64_t state = 1;
  double *z = r->other;
  for (size_t k = 0; k < r->n; k++) { /* any vector */
    state = state * 6364136223846793005u + 1442695040888963407u;
    z[k] = (double)(state >> 11) / 9007199254740992.0 - 0.5;
  }
  for (size_t i = 0; i < INVERSE; i++) {
    double size;
    ph_sym_solve(r->factor, r->n, r->band, z);
    size = norm(r, z);
    for (size_t k = 0; k < r->n; k++) {
      z[k] /= size;
    }
  }
}

/* The step is too short although the shift is nearly the least: the rest is
 * along the lowest direction. */
static void go_lowest(struct ph_arc_region *r, double radius) {
  double along, rest, more;
  set_lowest(r);
  along = ph_arc_dot(r->n, r->step, r->other);
  rest = sqrt(along * along + radius * radius - r->length * r->length) -
         fabs(along);
  rest = along < 0 ? -rest : rest;
  more = rest * (r->shift * along - rest / 2 * curvature(r, r->other));
  if (more > 0) {
    for (size_t k = 0; k < r->n; k++) {
      r->step[k] += rest * r->other[k];
    }
    r->fall += more;
    r->length = radius;
  }
}

bool ph_arc_region_step(struct ph_arc_region *r, double radius, double above) {
  if (!search(r, radius, above)) {
    return false;
  }
  r->hint = r->shift > 0 ? r->shift : r->hint;
  r->fall =
      (r->shift * r->length * r->length - ph_arc_dot(r->n, r->g, r->step)) / 2;
  if (r->shift > 0 && r->length < SHORT * radius) {
    go_lowest(r, radius);
  }
  return r->length <= DBL_MAX;
}
