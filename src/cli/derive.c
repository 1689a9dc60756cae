/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What is derived from a curve (see derive.h). */
#include "cli/derive.h"

#include "curve/bezier/cubics.h"
#include "curve/bezier/nurbs.h"
#include "curve/offset/range.h"
#include "curve/cross/cross.h"
#include "curve/fair/enclosed.h"
#include "curve/kind/kind.h"
#include "curve/offset/loop.h"
#include "io/gcode_out.h"

#include <stdio.h>
#include <stdlib.h>

/* Default tolerance of paths of drawings, and default chord error of formats of
 * samples, relative to the size of the curve. */
static const double TOLERANCE_PATH = 1e-6;

/* A part of the size of a curve, or what its coordinates are rounded by. */
static double default_tolerance(double part, const struct ph_curve *curve) {
  return fmax(part * ph_curve_size(curve), ph_curve_rounding(curve));
}

/* That of Bezier pieces. */
static double tolerance_of(const struct ph_options *o,
                           const struct ph_curve *curve) {
  return o->tolerance > 0 ? o->tolerance
                          : default_tolerance(PH_TOLERANCE, curve);
}

/* Joints that a warning of gaps names. */
enum { GAPS_NAMED = 8 };

/* One warning for all offsets: the first one that has cusps. */
static void warn_cusps(struct ph_result *result) {
  const struct ph_offset *o = result->offsets, *end = o + result->offsets_n;
  const struct ph_place *at;
  while (o < end && !o->cusps.n) {
    o++;
  }
  if (o == end) {
    return;
  }
  at = &o->cusps.at[0];
  if (o->vector) {
    ph_warn(result, at->segment, PH_W_OFFSET_CUSP,
            "the offset at distance %g along %s turns back, where the radius "
            "of curvature towards it is smaller: %zu times, first in "
            "segment %zu at %.6g of its interval",
            o->distance, o->vector, o->cusps.n, at->segment, at->u);
  } else {
    ph_warn(result, at->segment, PH_W_OFFSET_CUSP,
            "the offset at distance %g has cusps, where the %s: %zu, the first "
            "in segment %zu at %.6g of its interval",
            o->distance, ph_kind_of(&result->curve)->cusp, o->cusps.n,
            at->segment, at->u);
  }
}

/* One warning for all offsets: the first one that has gaps. */
static void warn_gaps(struct ph_result *result) {
  const struct ph_offset *o = result->offsets, *end = o + result->offsets_n;
  char joints[32 * GAPS_NAMED];
  size_t n = 0;
  while (o < end && !o->gaps.n) {
    o++;
  }
  if (o == end) {
    return;
  }
  for (size_t i = 0; i < o->gaps.n && i < GAPS_NAMED; i++) {
    n += (size_t)snprintf(joints + n, sizeof joints - n, "%s%zu",
                          i > 0 ? ", " : "", o->gaps.before[i]);
  }
  ph_warn(result, o->gaps.before[0], PH_W_OFFSET_GAP,
          "the offset at distance %g%s%s has gaps, where the %s: %zu, before "
          "%s %s%s",
          o->distance, o->vector ? " along " : "", o->vector ? o->vector : "",
          o->vector ? "frame turns at a joint" : "curve has corners", o->gaps.n,
          o->gaps.n > 1 ? "segments" : "segment", joints,
          o->gaps.n > GAPS_NAMED ? ", ..." : "");
}

/* That nothing is left, and of what something would be. */
static void warn_empty(struct ph_result *result,
                       const struct ph_offset_rules *rules,
                       const struct ph_offset *empty, struct ph_arena *arena) {
  const double depth =
      ph_loops_depth(&result->curve, rules, empty->distance, arena);
  char left[64] = "";
  if (isfinite(depth)) {
    snprintf(left, sizeof left, "; something is left up to %.6g", depth);
  }
  ph_warn(result, PH_NO_SEGMENT, PH_W_OFFSET_EMPTY,
          "nothing is left of the offset at distance %g: no point of it keeps "
          "that distance from the curve%s",
          empty->distance, left);
}

/* One warning each, of the first offset concerned. */
static void warn_loops(struct ph_result *result,
                       const struct ph_offset_rules *rules,
                       struct ph_arena *arena) {
  const struct ph_offset *o = result->offsets, *end = o + result->offsets_n;
  const struct ph_offset *empty = NULL, *touch = NULL;
  for (; o < end && o->loops.mode; o++) {
    empty = !empty && o->loops.n == 0 ? o : empty;
    touch = !touch && o->loops.trimming.touches ? o : touch;
  }
  if (empty) {
    warn_empty(result, rules, empty, arena);
  }
  if (touch) {
    ph_warn(result, PH_NO_SEGMENT, PH_W_OFFSET_TOUCH,
            "the offset at distance %g touches itself: a slightly different "
            "distance may give other loops",
            touch->distance);
  }
  if (rules->crosses && !rules->both && result->curve.closed) {
    ph_warn(result, PH_NO_SEGMENT, PH_W_SELF_CROSSING,
            "the curve crosses itself: the trimmed offset to one side is open "
            "where the other side takes over; --offset-sides=both closes it");
  }
}

/* Joined and trimmed offsets are of plane curves; of a closed one that is
 * trimmed, whether it crosses itself. */
static enum ph_status prepare_loops(const struct ph_curve *curve,
                                    struct ph_arena *arena,
                                    struct ph_offset_rules *rules,
                                    struct ph_diag *diag) {
  struct ph_cross cross = {.simple = true};
  enum ph_status status = PH_OK;
  if (ph_kind_space(ph_kind_of(curve), curve->dimension) != PH_PLANE) {
    return ph_fail(diag, PH_E_BAD_VALUE, NULL,
                   "only curves in the plane have joined and trimmed offsets; "
                   "--offset-mode=raw is for all");
  }
  if (rules->mode == PH_OFFSET_TRIMMED && curve->closed) {
    struct ph_arena scratch = ph_arena_beside(arena);
    status = ph_cross_planar(curve, &scratch, &cross, diag);
    ph_arena_free(&scratch);
  }
  rules->crosses = !cross.simple;
  return status;
}

/* The samples that are asked for, or that the format has anyway. */
static struct ph_sample_rules sample_rules(const struct ph_options *o,
                                           const struct ph_curve *curve) {
  struct ph_sample_rules rules = o->samples;
  if (ph_formats[o->format].is_cubics) {
    rules.how = PH_SAMPLE_NONE;
  }
  if (ph_formats[o->format].is_lines && rules.how == PH_SAMPLE_NONE) {
    rules.how = PH_SAMPLE_CHORD;
    rules.chord_error = default_tolerance(TOLERANCE_PATH, curve);
  }
  return rules;
}

static enum ph_status derive_offsets(const struct ph_options *o,
                                     const struct ph_sample_rules *samples,
                                     double tolerance, struct ph_arena *arena,
                                     struct ph_result *r,
                                     struct ph_diag *diag) {
  struct ph_offset_rules rules = o->offset;
  const size_t each =
      ph_kind_offsets(ph_kind_of(&r->curve), r->curve.dimension);
  const size_t n = o->offsets_n * each;
  enum ph_status status = PH_OK;
  rules.tolerance = tolerance;
  rules.samples = *samples;
  if (n > 0 && rules.mode != PH_OFFSET_RAW) {
    status = prepare_loops(&r->curve, arena, &rules, diag);
  }
  r->offsets = ph_arena_array(arena, n, sizeof *r->offsets);
  if (!r->offsets) {
    return ph_fail_memory(diag);
  }
  for (size_t i = 0; status == PH_OK && i < o->offsets_n; i++) {
    status = ph_offset(&r->curve, o->offsets[i], &rules, arena,
                       r->offsets + i * each, diag);
  }
  r->offsets_n = n;
  if (status == PH_OK) {
    ph_loops_nest(r->offsets, n);
    warn_cusps(r);
    warn_gaps(r);
    warn_loops(r, &rules, arena);
  }
  return status;
}

/* The curve and its offsets as cubics. */
static enum ph_status derive_paths(const struct ph_options *o,
                                   struct ph_arena *arena,
                                   const struct ph_result *r,
                                   struct ph_derived *derived,
                                   struct ph_diag *diag) {
  const bool drawing = ph_formats[o->format].is_drawing && o->tolerance > 0;
  const double tolerance =
      o->samples.how == PH_SAMPLE_CHORD ? o->samples.chord_error
      : drawing                         ? o->tolerance
                : default_tolerance(TOLERANCE_PATH, &r->curve);
  size_t n = r->offsets_n + 1;
  enum ph_status status = PH_OK;
  derived->paths = ph_arena_array(arena, n, sizeof *derived->paths);
  if (!derived->paths) {
    return ph_fail_memory(diag);
  }
  for (size_t i = 0; status == PH_OK && i < n; i++) {
    status = ph_cubics_of(&r->curve, i > 0 ? &r->offsets[i - 1] : NULL,
                          tolerance, arena, &derived->paths[i], diag);
  }
  derived->paths_n = n;
  return status;
}

/* Replaces a curve by Bezier curves. */
static enum ph_status convert(const struct ph_options *o,
                              struct ph_arena *arena, struct ph_curve *curve,
                              struct ph_diagnostics *diagnostics,
                              struct ph_diag *diag) {
  struct ph_curve bezier;
  double error;
  enum ph_status status = ph_bezier_curve(curve, tolerance_of(o, curve), arena,
                                          &bezier, &error, diag);
  if (status == PH_OK) {
    *curve = bezier;
    ph_diagnostics_set(diagnostics, PH_D_CONVERSION_ERROR, error);
  }
  return status;
}

static enum ph_status convert_all(const struct ph_options *o,
                                  struct ph_arena *arena, struct ph_result *r,
                                  struct ph_diag *diag) {
  enum ph_status status = convert(o, arena, &r->curve, &r->diagnostics, diag);
  for (size_t i = 0; status == PH_OK && i < r->solutions_n; i++) {
    status = convert(o, arena, &r->solutions[i].curve,
                     &r->solutions[i].diagnostics, diag);
  }
  return status;
}

/* The curve and its offsets as B-splines. */
static enum ph_status derive_nurbs(double tolerance, struct ph_arena *arena,
                                   struct ph_result *r, struct ph_diag *diag) {
  enum ph_status status =
      ph_nurbs_of(&r->curve, NULL, tolerance, arena, &r->nurbs, diag);
  for (size_t i = 0; status == PH_OK && i < r->offsets_n; i++) {
    struct ph_offset *o = &r->offsets[i];
    status = o->loops.mode
                 ? ph_nurbs_loops(o, arena, diag)
                 : ph_nurbs_of(&r->curve, o, tolerance, arena, &o->nurbs, diag);
  }
  return status;
}

/* ---- given lengths ------------------------------------------------------- */

/* A length may be beyond the curve's by what a sum of its parts is rounded. */
static const double BEYOND = 1e-12;

static int order(const void *a, const void *b) {
  const double x = *(const double *)a, y = *(const double *)b;
  return (x > y) - (x < y);
}

/* The lengths of the field at, from the start and increasing, each once. */
static enum ph_status read_lengths(const struct ph_value *at,
                                   const struct ph_curve *curve,
                                   struct ph_arena *arena,
                                   struct ph_sample_rules *rules,
                                   struct ph_diag *diag) {
  const bool one = at->kind == PH_NUMBER;
  const size_t n = one ? 1 : at->n;
  const double length = curve->length;
  double *s = ph_arena_array(arena, n, sizeof *s);
  size_t kept = 0;
  if (!s) {
    return ph_fail_memory(diag);
  }
  for (size_t i = 0; i < n; i++) {
    const double given = one ? at->number : at->v[i];
    if (!(fabs(given) <= length * (1 + BEYOND))) {
      return ph_fail_at(diag, PH_E_BAD_VALUE, "at", i,
                        "must be within the length of the curve, which is "
                        "%.15g, or the same from its end, found %.15g",
                        length, given);
    }
    s[i] = signbit(given) && fabs(given) > 0 ? fmax(length + given, 0)
                                             : fmin(given, length);
  }
  qsort(s, n, sizeof *s, order);
  for (size_t i = 0; i < n; i++) {
    if (kept == 0 || s[i] > s[kept - 1]) {
      s[kept++] = s[i];
    }
  }
  rules->how = kept ? PH_SAMPLE_LENGTHS : PH_SAMPLE_NONE;
  rules->n = kept;
  rules->lengths = s;
  return PH_OK;
}

/* The places of the curve at lengths, for its offsets. */
static enum ph_status find_places(const struct ph_curve *curve,
                                  const struct ph_sample_rules *rules,
                                  struct ph_arena *arena,
                                  struct ph_sample_rules *beside,
                                  struct ph_diag *diag) {
  struct ph_place *places = ph_arena_array(arena, rules->n, sizeof *places);
  struct ph_samples samples;
  enum ph_status status =
      places ? ph_sample_curve(curve, rules, arena, &samples, diag)
             : ph_fail_memory(diag);
  for (size_t i = 0; status == PH_OK && i < rules->n; i++) {
    const size_t k = samples.segment[i];
    places[i].segment = k;
    places[i].t = samples.t[i];
    places[i].u = samples.t[i] / ph_curve_range(curve, k);
  }
  *beside = (struct ph_sample_rules){
      .how = PH_SAMPLE_PLACES, .n = rules->n, .places = places};
  return status;
}

/* Samples at given lengths, of offsets beside these. */
static enum ph_status
sample_lengths(const struct ph_options *o, const struct ph_value *at,
               struct ph_arena *arena, const struct ph_curve *curve,
               struct ph_sample_rules *rules, struct ph_sample_rules *beside,
               struct ph_diag *diag) {
  enum ph_status status;
  if (o->samples.how) {
    return ph_fail(diag, PH_E_BAD_VALUE, "at",
                   "is one way to take samples, and --sample, --spacing and "
                   "--chord-error are others");
  }
  if (o->offsets_n && o->offset.mode != PH_OFFSET_RAW) {
    return ph_fail(diag, PH_E_BAD_VALUE, "at",
                   "is of the curve and its raw offsets: loops begin anywhere");
  }
  *rules = o->samples;
  status = read_lengths(at, curve, arena, rules, diag);
  return status == PH_OK && rules->how && o->offsets_n
             ? find_places(curve, rules, arena, beside, diag)
             : status;
}

static enum ph_status derive_range(struct ph_arena *arena, struct ph_result *r,
                                   struct ph_diag *diag) {
  r->offset_range = ph_arena_array(arena, 2, sizeof *r->offset_range);
  if (!r->offset_range) {
    return ph_fail_memory(diag);
  }
  ph_offset_range(&r->curve, r->offset_range);
  return PH_OK;
}

enum ph_status ph_derive(const struct ph_options *options,
                         const struct ph_problem *problem,
                         struct ph_arena *arena, struct ph_result *result,
                         struct ph_derived *derived, struct ph_diag *diag) {
  const struct ph_options *o = options;
  const struct ph_value *at = &problem->field[PH_F_AT];
  const struct ph_format_row *format = &ph_formats[o->format];
  struct ph_sample_rules rules, beside;
  enum ph_status status = PH_OK;
  double tolerance;
  derived->exact = result->curve;
  if (ph_kind_of(&result->curve)->parts != PH_SEGMENTS_PARTS) {
    return ph_derive_surface(o, arena, result, derived, diag);
  }
  tolerance = tolerance_of(o, &result->curve);
  status = ph_enclosed_area(&result->curve, arena, &result->area, diag);
  if (status == PH_OK && o->offset_range) {
    status = derive_range(arena, result, diag);
  }
  rules = beside = sample_rules(o, &result->curve);
  if (status == PH_OK && at->kind != PH_ABSENT && !format->is_cubics &&
      !format->is_nurbs && !format->is_road && !format->is_moves) {
    status =
        sample_lengths(o, at, arena, &result->curve, &rules, &beside, diag);
  }
  if (status == PH_OK) {
    status = derive_offsets(o, &beside, tolerance, arena, result, diag);
  }
  if (status == PH_OK && format->is_cubics) {
    return derive_paths(o, arena, result, derived, diag);
  }
  if (status == PH_OK && (o->nurbs || format->is_nurbs)) {
    status = derive_nurbs(tolerance, arena, result, diag);
  }
  if (status == PH_OK && o->convert) {
    status = convert_all(o, arena, result, diag);
  }
  if (status == PH_OK && rules.how) { /* of the segments in the record */
    status =
        ph_sample_curve(&result->curve, &rules, arena, &result->samples, diag);
  }
  return status == PH_OK && format->is_moves ? ph_gcode_fits(result, diag)
                                             : status;
}
