/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Offsets of planar PH and ATPH splines (see offset.h). */
#include "curve/offset.h"

#include "curve/hermite.h"
#include "curve/ph2.h"
#include "curve/seg2.h"
#include "kernel/bern.h"

#include <string.h>

/* Halvings of a segment before its speed counts as zero: 2^-20 of a segment
 * is below any feature that its control points can describe. */
enum { HALVINGS_MAX = 20 };

/* binomial(4,j) binomial(5,k-j) / binomial(9,k) for j = 0..4, k - j = 0..5:
 * the product of Bernstein forms of degrees 4 and 5. */
static const double PRODUCT[5][6] = {
    {1.0, 5.0 / 9, 10.0 / 36, 10.0 / 84, 5.0 / 126, 1.0 / 126},
    {4.0 / 9, 20.0 / 36, 40.0 / 84, 40.0 / 126, 20.0 / 126, 4.0 / 84},
    {6.0 / 36, 30.0 / 84, 60.0 / 126, 60.0 / 126, 30.0 / 84, 6.0 / 36},
    {4.0 / 84, 20.0 / 126, 40.0 / 126, 40.0 / 84, 20.0 / 36, 4.0 / 9},
    {1.0 / 126, 5.0 / 126, 10.0 / 84, 10.0 / 36, 5.0 / 9, 1.0},
};

/* Part of a segment. */
struct piece {
  ph_cplx w[3], p[6];
  double from, to; /* in the segment's parameter */
};

/* What a walk over the pieces of a curve does with each. */
struct walk {
  struct ph_offset *offset; /* n counts the pieces */
  bool fill;                /* false: only count */
};

static struct piece segment_of(const struct ph_curve *curve, size_t k) {
  struct piece piece;
  memcpy(piece.w, curve->preimage + 6 * k, sizeof piece.w);
  memcpy(piece.p, curve->control_points + 12 * k, sizeof piece.p);
  piece.from = 0;
  piece.to = 1;
  return piece;
}

/* Coefficients of sigma at degree 9, times 1/unit; false unless all > 0. */
static bool weights_of(const double speed[5], double unit, double weight[10]) {
  bool positive = true;
  for (size_t k = 0; k < 10; k++) {
    weight[k] = 0;
  }
  for (size_t j = 0; j < 5; j++) {
    for (size_t i = 0; i < 6; i++) {
      weight[j + i] += PRODUCT[j][i] * (speed[j] / unit);
    }
  }
  for (size_t k = 0; k < 10; k++) {
    positive = positive && weight[k] > 0;
  }
  return positive;
}

/* The largest coefficient, which bounds the speed. */
static double largest_of(const double speed[5]) {
  double largest = 0;
  for (size_t j = 0; j < 5; j++) {
    largest = speed[j] > largest ? speed[j] : largest;
  }
  return largest;
}

/* Numerators over weights, relative to the first point so that coordinates far
 * from the origin keep their digits. */
static void fill_piece(struct ph_offset *offset, size_t segment,
                       const struct piece *piece, double unit,
                       const double speed[5], const double weight[10]) {
  size_t at = offset->n;
  ph_cplx hodograph[5], sum[10] = {{0, 0}};
  double *out = offset->control_points + 20 * at;
  ph_ph2_hodograph(piece->w, hodograph);
  for (size_t j = 0; j < 5; j++) {
    double s = speed[j] / unit;
    ph_cplx g = ph_cplx_scale(offset->distance / unit, hodograph[j]);
    for (size_t i = 0; i < 6; i++) {
      ph_cplx leg = ph_cplx_sub(piece->p[i], piece->p[0]);
      ph_cplx term = ph_cplx_of(s * leg.re - g.im, s * leg.im + g.re);
      sum[j + i] = ph_cplx_add(sum[j + i], ph_cplx_scale(PRODUCT[j][i], term));
    }
  }
  for (size_t k = 0; k < 10; k++) {
    out[2 * k] = piece->p[0].re + sum[k].re / weight[k];
    out[2 * k + 1] = piece->p[0].im + sum[k].im / weight[k];
    offset->weights[10 * at + k] = weight[k] * unit;
  }
  offset->segment[at] = segment;
  offset->interval[2 * at] = piece->from;
  offset->interval[2 * at + 1] = piece->to;
}

/* Visits the piece, or its halves; false if the speed vanishes in it. */
static bool visit(struct walk *walk, size_t segment, const struct piece *piece,
                  int depth) {
  double speed[5], weight[10], unit;
  struct piece left, right;
  ph_ph2_speed(piece->w, speed);
  unit = largest_of(speed);
  if (unit > 0 && weights_of(speed, unit, weight)) {
    if (walk->fill) {
      fill_piece(walk->offset, segment, piece, unit, speed, weight);
    }
    walk->offset->n++;
    return true;
  }
  if (depth == HALVINGS_MAX || !(unit > 0)) {
    return false;
  }
  ph_bern_halve(piece->w, 2, left.w, right.w);
  ph_bern_halve(piece->p, 5, left.p, right.p);
  left.from = piece->from;
  right.to = piece->to;
  left.to = right.from = 0.5 * (piece->from + piece->to);
  return visit(walk, segment, &left, depth + 1) &&
         visit(walk, segment, &right, depth + 1);
}

static enum ph_status visit_all(struct walk *walk, const struct ph_curve *curve,
                                struct ph_diag *diag) {
  walk->offset->n = 0;
  for (size_t k = 0; k < curve->n; k++) {
    struct piece piece = segment_of(curve, k);
    if (!visit(walk, k, &piece, 0)) {
      return ph_fail_at(diag, PH_INFEASIBLE, "segments", k,
                        "has no offset: the curve stands still in it and has "
                        "no normal there");
    }
  }
  return PH_OK;
}

/* The quotient of segment k: d i w^2 over |w|^2. */
static void fill_quotient(struct ph_offset *offset, size_t k,
                          const struct ph_seg2 *seg) {
  double c = seg->space.c, middle = 1 / (2 * c * c + 1);
  const ph_cplx *w = seg->w;
  double *out = offset->numerator + 10 * k,
         *below = offset->denominator + 5 * k;
  ph_cplx m = ph_cplx_scale(c, w[1]);
  ph_cplx square[5] = {
      ph_cplx_mul(w[0], w[0]), ph_cplx_mul(w[0], w[1]),
      ph_cplx_scale(middle, ph_cplx_add(ph_cplx_scale(2, ph_cplx_mul(m, m)),
                                        ph_cplx_mul(w[0], w[2]))),
      ph_cplx_mul(w[1], w[2]), ph_cplx_mul(w[2], w[2])};
  below[0] = ph_cplx_norm2(w[0]);
  below[1] = ph_cplx_dot(w[0], w[1]);
  below[2] = middle * (2 * ph_cplx_norm2(m) + ph_cplx_dot(w[0], w[2]));
  below[3] = ph_cplx_dot(w[1], w[2]);
  below[4] = ph_cplx_norm2(w[2]);
  for (size_t j = 0; j < 5; j++) {
    out[2 * j] = -offset->distance * square[j].im;
    out[2 * j + 1] = offset->distance * square[j].re;
  }
  offset->segment[k] = k;
  offset->interval[2 * k] = 0;
  offset->interval[2 * k + 1] = 1;
}

static enum ph_status offset_atph(const struct ph_curve *curve,
                                  double tolerance, struct ph_arena *arena,
                                  struct ph_offset *offset,
                                  struct ph_diag *diag) {
  size_t n = curve->n;
  offset->degree = 4;
  offset->n = n;
  offset->segment = ph_arena_array(arena, n, sizeof *offset->segment);
  offset->interval = ph_arena_array(arena, n, 2 * sizeof(double));
  offset->numerator = ph_arena_array(arena, n, 10 * sizeof(double));
  offset->denominator = ph_arena_array(arena, n, 5 * sizeof(double));
  if (!offset->segment || !offset->interval || !offset->numerator ||
      !offset->denominator) {
    return ph_fail_memory(diag);
  }
  for (size_t k = 0; k < n; k++) {
    struct ph_seg2 seg = ph_seg2_of(curve, k);
    fill_quotient(offset, k, &seg);
  }
  return ph_hermite_pieces(curve, offset->distance, PH_E2, tolerance, arena,
                           &offset->pieces, diag);
}

static enum ph_status offset_ph(const struct ph_curve *curve,
                                struct ph_arena *arena,
                                struct ph_offset *offset,
                                struct ph_diag *diag) {
  struct walk walk = {offset, false};
  enum ph_status status = visit_all(&walk, curve, diag);
  size_t n = offset->n;
  if (status != PH_OK) {
    return status;
  }
  offset->segment = ph_arena_array(arena, n, sizeof *offset->segment);
  offset->interval = ph_arena_array(arena, n, 2 * sizeof(double));
  offset->control_points = ph_arena_array(arena, n, 20 * sizeof(double));
  offset->weights = ph_arena_array(arena, n, 10 * sizeof(double));
  if (!offset->segment || !offset->interval || !offset->control_points ||
      !offset->weights) {
    return ph_fail_memory(diag);
  }
  walk.fill = true;
  return visit_all(&walk, curve, diag);
}

enum ph_status ph_offset_planar(const struct ph_curve *curve, double distance,
                                double tolerance, struct ph_arena *arena,
                                struct ph_offset *offset,
                                struct ph_diag *diag) {
  const double *points;
  size_t n;
  enum ph_status status;
  *offset =
      (struct ph_offset){.distance = distance, .degree = 9, .dimension = 2};
  status = curve->alpha ? offset_atph(curve, tolerance, arena, offset, diag)
                        : offset_ph(curve, arena, offset, diag);
  points =
      curve->alpha ? offset->pieces.control_points : offset->control_points;
  n = curve->alpha ? 12 * offset->pieces.n : 20 * offset->n;
  for (size_t i = 0; status == PH_OK && i < n; i++) {
    if (!isfinite(points[i])) {
      status = ph_fail(diag, PH_TOO_LARGE, NULL,
                       "the offset at distance %g exceeds the range of a "
                       "double",
                       distance);
    }
  }
  return status;
}
