/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Offsets of PH and ATPH splines and of cubics (see offset.h).  Planar ones are
 * moved along e2 in space, where z = 0: one path serves both.
 */
#include "curve/offset/offset.h"

#include "base/team.h"
#include "curve/bezier/hermite.h"
#include "curve/kind/kind.h"
#include "curve/offset/cusp.h"
#include "curve/offset/gap.h"
#include "curve/offset/loop.h"
#include "curve/offset/rational.h"

/* Numbers of a quotient are about 2^-RANGE to 2^RANGE. */
enum { RANGE = 960 };

/* What a walk over the pieces of a curve does with each. */
struct walk {
  struct ph_offset *offset;
  enum ph_normal normal;
  bool fill; /* false: only count */
  size_t n;  /* of the next piece */
};

/* Segments that a thread takes at a time, and that are worth one. */
enum { PART = 128, WORTH = 512 };

static void fill_piece(const struct walk *walk,
                       const struct ph_rational *piece) {
  struct ph_offset *offset = walk->offset;
  const size_t points = 2 * piece->degree, at = walk->n;
  ph_rational_points(piece, walk->normal, offset->distance, offset->dimension,
                     offset->control_points + offset->dimension * points * at,
                     offset->weights + points * at);
  offset->segment[at] = piece->segment;
  offset->interval[2 * at] = piece->from;
  offset->interval[2 * at + 1] = piece->to;
}

static void visit(void *context, const struct ph_rational *piece) {
  struct walk *walk = context;
  if (walk->fill) {
    fill_piece(walk, piece);
  }
  walk->n++;
}

/* The power of 2 by which numerator and denominator are larger than those of A
 * at unit scale: that of |A|^2, unless |A|^2 or d |A|^2 is next to an end of
 * the range of doubles. */
static int scale_of(double distance, int norm2) {
  const int d = distance < 0 || distance > 0 ? ilogb(distance) : 0;
  const int least = -RANGE - (d < 0 ? d : 0), most = RANGE - (d > 0 ? d : 0);
  return norm2 < least ? least : norm2 > most ? most : norm2;
}

/* The quotient of segment k: d A j A* or d A k A* over |A|^2. */
static void fill_quotient(struct ph_offset *offset, size_t k,
                          struct ph_seg3 *seg, enum ph_normal normal) {
  const int norm2 = 2 * ph_seg3_rescale(seg);
  const double scale = ldexp(1, scale_of(offset->distance, norm2));
  const ph_quat *a = seg->a;
  double c = seg->space.c, middle = 1 / (2 * c * c + 1);
  double *out = offset->numerator + 5 * offset->dimension * k;
  double *below = offset->denominator + 5 * k;
  const ph_quat m = ph_quat_scale(c, a[1]);
  const ph_vec3 zero = {0, 0, 0};
  ph_vec3 move[5];
  ph_rational_turned(normal, a, 3, c, move);
  below[0] = ph_quat_dot(a[0], a[0]);
  below[1] = ph_quat_dot(a[0], a[1]);
  below[2] = middle * (2 * ph_quat_dot(m, m) + ph_quat_dot(a[0], a[2]));
  below[3] = ph_quat_dot(a[1], a[2]);
  below[4] = ph_quat_dot(a[2], a[2]);
  for (size_t j = 0; j < 5; j++) { /* from 0, so that no -0 is written */
    ph_vec3 part = ph_vec3_scale(scale, move[j]);
    ph_vec3_put(ph_vec3_along(zero, offset->distance, part), offset->dimension,
                out + offset->dimension * j);
    below[j] *= scale;
  }
  offset->segment[k] = k;
  offset->interval[2 * k] = 0;
  offset->interval[2 * k + 1] = 1;
}

/* The geometry of an offset along a normal. */
typedef enum ph_status making(const struct ph_curve *curve,
                              enum ph_normal normal, double tolerance,
                              struct ph_arena *arena, struct ph_offset *offset,
                              struct ph_diag *diag);

static enum ph_status quotients(const struct ph_curve *curve,
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

/* The pieces of a curve in parts. */
struct parts {
  const struct ph_curve *curve;
  struct walk walk;
  size_t *first; /* piece of each part; before they are counted, their number */
};

/* Nobody reads the message: who puts parts together finds the failure again. */
static bool walk_part(void *context, size_t thread, size_t first, size_t end) {
  const struct parts *parts = context;
  struct walk walk = parts->walk;
  struct ph_diag diag;
  enum ph_status status;
  (void)thread;
  walk.n = walk.fill ? parts->first[first / PART] : 0;
  status =
      ph_rational_walk(parts->curve, first, end, "offset", visit, &walk, &diag);
  if (!walk.fill) {
    parts->first[first / PART] = status == PH_OK ? walk.n : SIZE_MAX;
  }
  return status == PH_OK;
}

/* Counts the pieces; the first failure is that of the first part that has
 * one. */
static enum ph_status count_pieces(struct parts *parts, struct ph_arena *arena,
                                   struct ph_diag *diag) {
  const size_t n = parts->curve->n;
  struct walk *walk = &parts->walk;
  walk->offset->n = 0;
  parts->first = ph_arena_array(arena, n / PART + 1, sizeof *parts->first);
  if (!parts->first) {
    return ph_fail_memory(diag);
  }
  ph_team_share(arena, n, WORTH, PART, walk_part, parts);
  for (size_t i = 0; i < n; i += PART) {
    const size_t count = parts->first[i / PART];
    if (count == SIZE_MAX) {
      return ph_rational_walk(parts->curve, i, n, "offset", visit, walk, diag);
    }
    parts->first[i / PART] = walk->offset->n;
    walk->offset->n += count;
  }
  return PH_OK;
}

static enum ph_status rationals(const struct ph_curve *curve,
                                enum ph_normal normal, double tolerance,
                                struct ph_arena *arena,
                                struct ph_offset *offset,
                                struct ph_diag *diag) {
  struct parts parts = {.curve = curve, .walk = {offset, normal, false, 0}};
  size_t n, points = 2 * curve->degree, number = sizeof(double);
  enum ph_status status = count_pieces(&parts, arena, diag);
  (void)tolerance;
  if (status != PH_OK) {
    return status;
  }
  n = offset->n;
  offset->degree = points - 1;
  offset->segment = ph_arena_array(arena, n, sizeof *offset->segment);
  offset->interval = ph_arena_array(arena, n, 2 * number);
  offset->control_points =
      ph_arena_array(arena, n, points * curve->dimension * number);
  offset->weights = ph_arena_array(arena, n, points * number);
  if (!offset->segment || !offset->interval || !offset->control_points ||
      !offset->weights) {
    return ph_fail_memory(diag);
  }
  parts.walk.fill = true;
  ph_team_share(arena, curve->n, WORTH, PART, walk_part, &parts);
  return PH_OK;
}

/* Whether every number of an offset is one. */
static bool is_finite(const struct ph_offset *offset) {
  const struct ph_pieces *pieces = &offset->pieces;
  size_t points = (offset->degree + 1) * offset->n;
  size_t n = offset->dimension * points;
  return offset->control_points
             ? ph_are_finite(offset->control_points, n) &&
                   ph_are_finite(offset->weights, points)
             : ph_are_finite(offset->numerator, n) &&
                   ph_are_finite(offset->denominator, points) &&
                   ph_are_finite(pieces->control_points,
                                 6 * offset->dimension * pieces->n);
}

/* The offset along a normal, which has no name in the plane. */
static enum ph_status
offset_along(making *make, const struct ph_curve *curve, double distance,
             enum ph_normal normal, const char *name,
             const struct ph_offset_rules *rules, struct ph_arena *arena,
             struct ph_offset *offset, struct ph_diag *diag) {
  enum ph_status status;
  *offset = (struct ph_offset){.distance = distance,
                               .vector = name,
                               .dimension = curve->dimension,
                               .length = (double)NAN};
  if (rules->mode != PH_OFFSET_RAW) {
    return ph_loops_of(curve, rules, arena, offset, diag);
  }
  status = make(curve, normal, rules->tolerance, arena, offset, diag);
  if (status == PH_OK && !is_finite(offset)) {
    status = ph_fail(diag, PH_E_TOO_LARGE, NULL,
                     "the offset at distance %g exceeds the range of a double",
                     distance);
  }
  if (status == PH_OK) {
    status = ph_cusps_of(curve, distance, normal, arena, &offset->cusps, diag);
  }
  if (status == PH_OK) {
    status = ph_gaps_of(curve, distance, normal, arena, &offset->gaps, diag);
  }
  if (status == PH_OK && rules->samples.how != PH_SAMPLE_NONE) {
    status = ph_sample_offset(curve, &rules->samples, arena, offset, diag);
  }
  return status;
}

static enum ph_status
offset_all(making *make, const struct ph_curve *curve, double distance,
           const struct ph_offset_rules *rules, struct ph_arena *arena,
           struct ph_offset *offsets, struct ph_diag *diag) {
  static const char *const names[] = {[PH_E2] = "e2", [PH_E3] = "e3"};
  const size_t n = ph_kind_offsets(ph_kind_of(curve), curve->dimension);
  enum ph_status status = PH_OK;
  for (size_t i = 0; status == PH_OK && i < n; i++) {
    enum ph_normal normal = i < 2 ? PH_E2 : PH_E3;
    /* The other side of 0 is no -0. */
    status = offset_along(make, curve, i % 2 ? 0 - distance : distance, normal,
                          n > 1 ? names[normal] : NULL, rules, arena,
                          &offsets[i], diag);
  }
  return status;
}

enum ph_status ph_offset_rational(const struct ph_curve *curve, double distance,
                                  const struct ph_offset_rules *rules,
                                  struct ph_arena *arena,
                                  struct ph_offset *offsets,
                                  struct ph_diag *diag) {
  return offset_all(rationals, curve, distance, rules, arena, offsets, diag);
}

enum ph_status ph_offset_quotient(const struct ph_curve *curve, double distance,
                                  const struct ph_offset_rules *rules,
                                  struct ph_arena *arena,
                                  struct ph_offset *offsets,
                                  struct ph_diag *diag) {
  return offset_all(quotients, curve, distance, rules, arena, offsets, diag);
}

enum ph_status ph_offset(const struct ph_curve *curve, double distance,
                         const struct ph_offset_rules *rules,
                         struct ph_arena *arena, struct ph_offset *offsets,
                         struct ph_diag *diag) {
  return ph_kind_of(curve)->offset(curve, distance, rules, arena, offsets,
                                   diag);
}
