/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Offsets of PH and ATPH splines (see offset.h).  Planar ones are moved along
 * e2 in space, where z = 0: one path serves both.
 */
#include "curve/offset.h"

#include "curve/cusp.h"
#include "curve/hermite.h"
#include "curve/ph3.h"
#include "kernel/bern.h"

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

/* Part of a segment: preimage A = a[0] + a[1] j, points p[0] and, along z, the
 * real parts of p[1]. */
struct piece {
  ph_cplx a[2][3], p[2][6];
  double from, to; /* in the segment's parameter */
};

/* What a walk over the pieces of a curve does with each. */
struct walk {
  struct ph_offset *offset; /* n counts the pieces */
  enum ph_normal normal;
  bool fill; /* false: only count */
};

static struct piece segment_of(const struct ph_curve *curve, size_t k) {
  struct ph_seg3 seg = ph_seg3_of(curve, k);
  size_t dimension = curve->dimension;
  const double *p = curve->control_points + 6 * dimension * k;
  struct piece piece;
  ph_seg3_pair(&seg, piece.a);
  for (size_t i = 0; i < 6; i++) {
    ph_vec3 at = ph_vec3_get(p + dimension * i, dimension);
    piece.p[0][i] = ph_cplx_of(at.x, at.y);
    piece.p[1][i] = ph_cplx_of(at.z, 0);
  }
  piece.from = 0;
  piece.to = 1;
  return piece;
}

static void preimage_of(const struct piece *piece, ph_quat a[3]) {
  for (size_t i = 0; i < 3; i++) {
    ph_cplx left = piece->a[0][i], right = piece->a[1][i];
    a[i] = ph_quat_of(left.re, left.im, right.re, right.im);
  }
}

/* Coefficients of A j A* or A k A*, in the B-basis of products of two functions
 * of the space with this c. */
static void turned(enum ph_normal normal, const ph_quat a[3], double c,
                   ph_vec3 out[5]) {
  ph_quat m = ph_quat_scale(c, a[1]);
  ph_vec3 square = ph_normal_between(normal, m, m);
  out[0] = ph_normal_between(normal, a[0], a[0]);
  out[1] = ph_normal_between(normal, a[0], a[1]);
  out[2] = ph_vec3_scale(1 / (2 * c * c + 1),
                         ph_vec3_add(ph_vec3_scale(2, square),
                                     ph_normal_between(normal, a[0], a[2])));
  out[3] = ph_normal_between(normal, a[1], a[2]);
  out[4] = ph_normal_between(normal, a[2], a[2]);
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
static void fill_piece(const struct walk *walk, size_t segment,
                       const struct piece *piece, const ph_quat a[3],
                       double unit, const double speed[5],
                       const double weight[10]) {
  struct ph_offset *offset = walk->offset;
  size_t at = offset->n, dimension = offset->dimension;
  ph_vec3 move[5], p[6], sum[10] = {{0, 0, 0}};
  turned(walk->normal, a, 1, move);
  for (size_t i = 0; i < 6; i++) {
    ph_cplx xy = piece->p[0][i];
    p[i] = ph_vec3_of(xy.re, xy.im, piece->p[1][i].re);
  }
  for (size_t j = 0; j < 5; j++) {
    ph_vec3 g = ph_vec3_scale(offset->distance / unit, move[j]);
    for (size_t i = 0; i < 6; i++) {
      ph_vec3 leg = ph_vec3_sub(p[i], p[0]);
      ph_vec3 term = ph_vec3_along(g, speed[j] / unit, leg);
      sum[j + i] = ph_vec3_along(sum[j + i], PRODUCT[j][i], term);
    }
  }
  for (size_t k = 0; k < 10; k++) {
    double w = weight[k];
    ph_vec3 from_p0 = ph_vec3_of(sum[k].x / w, sum[k].y / w, sum[k].z / w);
    ph_vec3_put(ph_vec3_add(p[0], from_p0), dimension,
                offset->control_points + dimension * (10 * at + k));
    offset->weights[10 * at + k] = w * unit;
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
  ph_quat a[3];
  preimage_of(piece, a);
  ph_ph3_speed(a, speed);
  unit = largest_of(speed);
  if (unit > 0 && weights_of(speed, unit, weight)) {
    if (walk->fill) {
      fill_piece(walk, segment, piece, a, unit, speed, weight);
    }
    walk->offset->n++;
    return true;
  }
  if (depth == HALVINGS_MAX || !(unit > 0)) {
    return false;
  }
  for (size_t i = 0; i < 2; i++) {
    ph_bern_halve(piece->a[i], 2, left.a[i], right.a[i]);
    ph_bern_halve(piece->p[i], 5, left.p[i], right.p[i]);
  }
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

/* The quotient of segment k: d A j A* or d A k A* over |A|^2. */
static void fill_quotient(struct ph_offset *offset, size_t k,
                          const struct ph_seg3 *seg, enum ph_normal normal) {
  double c = seg->space.c, middle = 1 / (2 * c * c + 1);
  const ph_quat *a = seg->a;
  double *out = offset->numerator + 5 * offset->dimension * k;
  double *below = offset->denominator + 5 * k;
  const ph_quat m = ph_quat_scale(c, a[1]);
  const ph_vec3 zero = {0, 0, 0};
  ph_vec3 move[5];
  turned(normal, a, c, move);
  below[0] = ph_quat_dot(a[0], a[0]);
  below[1] = ph_quat_dot(a[0], a[1]);
  below[2] = middle * (2 * ph_quat_dot(m, m) + ph_quat_dot(a[0], a[2]));
  below[3] = ph_quat_dot(a[1], a[2]);
  below[4] = ph_quat_dot(a[2], a[2]);
  for (size_t j = 0; j < 5; j++) { /* from 0, so that no -0 is written */
    ph_vec3_put(ph_vec3_along(zero, offset->distance, move[j]),
                offset->dimension, out + offset->dimension * j);
  }
  offset->segment[k] = k;
  offset->interval[2 * k] = 0;
  offset->interval[2 * k + 1] = 1;
}

static enum ph_status offset_atph(const struct ph_curve *curve,
                                  enum ph_normal normal, double tolerance,
                                  struct ph_arena *arena,
                                  struct ph_offset *offset,
                                  struct ph_diag *diag) {
  size_t n = curve->n, stride = 5 * curve->dimension;
  offset->degree = 4;
  offset->n = n;
  offset->segment = ph_arena_array(arena, n, sizeof *offset->segment);
  offset->interval = ph_arena_array(arena, n, 2 * sizeof(double));
  offset->numerator = ph_arena_array(arena, n, stride * sizeof(double));
  offset->denominator = ph_arena_array(arena, n, 5 * sizeof(double));
  if (!offset->segment || !offset->interval || !offset->numerator ||
      !offset->denominator) {
    return ph_fail_memory(diag);
  }
  for (size_t k = 0; k < n; k++) {
    struct ph_seg3 seg = ph_seg3_of(curve, k);
    fill_quotient(offset, k, &seg, normal);
  }
  return ph_hermite_pieces(curve, offset->distance, normal, tolerance, arena,
                           &offset->pieces, diag);
}

static enum ph_status offset_ph(const struct ph_curve *curve,
                                enum ph_normal normal, struct ph_arena *arena,
                                struct ph_offset *offset,
                                struct ph_diag *diag) {
  struct walk walk = {offset, normal, false};
  enum ph_status status = visit_all(&walk, curve, diag);
  size_t n = offset->n, stride = 10 * curve->dimension;
  if (status != PH_OK) {
    return status;
  }
  offset->segment = ph_arena_array(arena, n, sizeof *offset->segment);
  offset->interval = ph_arena_array(arena, n, 2 * sizeof(double));
  offset->control_points = ph_arena_array(arena, n, stride * sizeof(double));
  offset->weights = ph_arena_array(arena, n, 10 * sizeof(double));
  if (!offset->segment || !offset->interval || !offset->control_points ||
      !offset->weights) {
    return ph_fail_memory(diag);
  }
  walk.fill = true;
  return visit_all(&walk, curve, diag);
}

static bool all_finite(const double *v, size_t n) {
  for (size_t i = 0; i < n; i++) {
    if (!isfinite(v[i])) {
      return false;
    }
  }
  return true;
}

/* Whether every number of an offset is one. */
static bool is_finite(const struct ph_offset *offset) {
  const struct ph_pieces *pieces = &offset->pieces;
  size_t n = offset->dimension * offset->n;
  return offset->control_points
             ? all_finite(offset->control_points, 10 * n) &&
                   all_finite(offset->weights, 10 * offset->n)
             : all_finite(offset->numerator, 5 * n) &&
                   all_finite(offset->denominator, 5 * offset->n) &&
                   all_finite(pieces->control_points,
                              6 * offset->dimension * pieces->n);
}

/* The offset along a normal, which has no name in the plane. */
static enum ph_status offset_along(const struct ph_curve *curve,
                                   double distance, enum ph_normal normal,
                                   const char *name, double tolerance,
                                   struct ph_arena *arena,
                                   struct ph_offset *offset,
                                   struct ph_diag *diag) {
  enum ph_status status;
  *offset = (struct ph_offset){.distance = distance,
                               .vector = name,
                               .degree = 9,
                               .dimension = curve->dimension};
  status = curve->alpha
               ? offset_atph(curve, normal, tolerance, arena, offset, diag)
               : offset_ph(curve, normal, arena, offset, diag);
  if (status == PH_OK && !is_finite(offset)) {
    status = ph_fail(diag, PH_TOO_LARGE, NULL,
                     "the offset at distance %g exceeds the range of a double",
                     distance);
  }
  if (status == PH_OK) {
    offset->cusps = ph_cusps_of(curve, distance, normal);
  }
  return status;
}

enum ph_status ph_offset_planar(const struct ph_curve *curve, double distance,
                                const struct ph_offset_rules *rules,
                                struct ph_arena *arena,
                                struct ph_offset *offset,
                                struct ph_diag *diag) {
  return offset_along(curve, distance, PH_E2, NULL, rules->tolerance, arena,
                      offset, diag);
}

enum ph_status ph_offset_spatial(const struct ph_curve *curve, double distance,
                                 const struct ph_offset_rules *rules,
                                 struct ph_arena *arena,
                                 struct ph_offset *offsets,
                                 struct ph_diag *diag) {
  static const char *const names[] = {[PH_E2] = "e2", [PH_E3] = "e3"};
  enum ph_status status = PH_OK;
  for (size_t i = 0; status == PH_OK && i < PH_OFFSETS_SPATIAL; i++) {
    enum ph_normal normal = i < 2 ? PH_E2 : PH_E3;
    /* The other side of 0 is no -0. */
    status =
        offset_along(curve, i % 2 ? 0 - distance : distance, normal,
                     names[normal], rules->tolerance, arena, &offsets[i], diag);
  }
  return status;
}
