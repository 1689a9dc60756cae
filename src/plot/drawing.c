/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Drawings of results (see drawing.h).
 *
 * Strokes are drawn by a pen (pen.h); data, polygons and vectors by
 * drawing_data.c.
 */
#include "plot/drawing.h"

#include "base/sum.h"
#include "curve/kind/kind.h"
#include "curve/offset/gap.h"
#include "curve/surface/ruling.h"
#include "plot/pen.h"

#include <stdlib.h>
#include <string.h>

/* Chords, and cubics, leave the curve by so much of the size of what is drawn.
 */
static const double CHORD = 1.0 / 4000, NEAR = 1e-6;

/* A segment's chords or cubics are halved so often at most. */
enum { DEPTH_MAX = 10 };

/* ---- how much of many segments is drawn ---------------------------------- */

static size_t ratio_up(size_t n, size_t m) {
  return (n + m - 1) / m;
}

/* Every so many-th segment counts for strokes; for profiles, a multiple of
 * that. With two points or places for each there is room for all. */
static size_t stroke_step(size_t n) {
  return n <= PH_DRAWING_POINTS ? 1 : ratio_up(2 * n, PH_DRAWING_POINTS);
}

static size_t profile_step(size_t n) {
  const size_t step = stroke_step(n);
  return ratio_up(ratio_up(2 * n, PH_DRAWING_PLACES), step) * step;
}

/* As many share a stroke and a profile, which begin with one that counts. */
static size_t group_of(size_t n) {
  const size_t step = profile_step(n);
  return ratio_up(ratio_up(n, PH_DRAWING_SEGMENTS), step) * step;
}

/* ---- curve and offsets --------------------------------------------------- */

/* Whether n segments are drawn as cubics: of all there is room for one. */
static bool by_cubics(size_t n) {
  return 3 * n <= PH_DRAWING_POINTS;
}

/* From where the pen is, at u0, on to u1. */
static void draw_part(struct ph_pen *pen, const struct ph_sampler *sampler,
                      double u0, double u1, int depth) {
  double middle = (u0 + u1) / 2, h = u1 - u0;
  if (by_cubics(sampler->n)) {
    ph_pen_along(pen, sampler, u0, u1, depth);
  } else if (depth > 0 &&
             !(ph_sampler_chord_bound(sampler, u0, u1) * h * h / 8 <=
               pen->tolerance)) {
    draw_part(pen, sampler, u0, middle, depth - 1);
    draw_part(pen, sampler, middle, u1, depth - 1);
  } else {
    ph_pen_to(pen, ph_sampler_at(sampler, u1).point);
  }
}

/* A segment, from u0 to u1.  Cusps are corners of its parts: they stay sharp.
 * inout cusp  number of the next one */
static void draw_between(struct ph_pen *pen, const struct ph_sampler *sampler,
                         const struct ph_cusps *cusps, size_t *cusp, double u0,
                         double u1, int depth) {
  double from = u0;
  ph_pen_to(pen, ph_sampler_at(sampler, u0).point);
  for (; cusps && *cusp < cusps->n && cusps->at[*cusp].segment <= sampler->k;
       ++*cusp) {
    const double u = cusps->at[*cusp].u;
    if (cusps->at[*cusp].segment < sampler->k || u <= from) {
      continue;
    }
    if (u >= u1) {
      break;
    }
    draw_part(pen, sampler, from, u, depth);
    from = u;
  }
  draw_part(pen, sampler, from, u1, depth);
}

/* How often chords or cubics of n segments are halved at most. */
static int depth_of(size_t n) {
  const size_t each = by_cubics(n) ? 3 : 1;
  int depth = 0;
  while (depth < DEPTH_MAX && each * n << (depth + 1) <= PH_DRAWING_POINTS) {
    depth++;
  }
  return depth;
}

/* The curve, a stroke for each of its segments if there are not too many, or an
 * offset of it, a stroke from gap to gap, or a loop of that. */
static enum ph_status draw_curve(struct ph_pen *pen,
                                 const struct ph_offset *offset,
                                 const struct ph_loop *loop,
                                 enum ph_stroke_role role, size_t index) {
  const struct ph_curve *curve = &pen->result->curve;
  const size_t n = loop ? loop->n : curve->n;
  const size_t step = stroke_step(n), group = offset ? n : group_of(n);
  const struct ph_offset *whole = loop ? NULL : offset;
  struct ph_sampler sampler;
  const int depth = depth_of(n);
  size_t cusp = 0, gap = 0;
  enum ph_status status =
      loop
          ? ph_sampler_begin_loop(&sampler, curve, offset, loop, &pen->scratch,
                                  pen->diag)
          : ph_sampler_begin(&sampler, curve, offset, &pen->scratch, pen->diag);
  for (size_t k = 0; status == PH_OK && k < n; k++) {
    bool begins = k > 0 && k % group == 0;
    if (k % step != 0 && k + 1 < n) {
      continue;
    }
    if (whole && ph_gaps_pass(&whole->gaps, k, &gap)) {
      ph_pen_lift(pen, role, index);
    }
    status = ph_sampler_enter(&sampler, k, pen->diag);
    if (status == PH_OK && begins) { /* the one before ends here */
      ph_pen_to(pen, ph_sampler_at(&sampler, 0).point);
      ph_pen_lift(pen, role, k - group);
    }
    if (status == PH_OK) {
      draw_between(pen, &sampler, whole ? &whole->cusps : NULL, &cusp, 0, 1,
                   depth);
    }
  }
  ph_pen_lift(pen, role, offset ? index : (n - 1) / group * group);
  return status;
}

/* ---- what was trimmed ---------------------------------------------------- */

/* A part of a segment that a loop runs along. */
struct kept {
  size_t segment;
  double from, to;
};

static int compare_kept(const void *a, const void *b) {
  const struct kept *p = a, *q = b;
  return p->segment != q->segment ? (p->segment < q->segment ? -1 : 1)
                                  : (p->from > q->from) - (p->from < q->from);
}

static size_t pieces_of(const struct ph_loops *loops) {
  size_t n = 0;
  for (size_t i = 0; i < loops->n; i++) {
    n += loops->v[i].n;
  }
  return n;
}

/* What loops run along, or against, in the order of the curve.
 * out v  [pieces_of(loops)];  ret  how many */
static size_t list_kept(const struct ph_loops *loops, bool back,
                        struct kept *v) {
  size_t n = 0;
  for (size_t i = 0; i < loops->n; i++) {
    for (size_t k = 0; k < loops->v[i].n; k++) {
      const struct ph_loop_piece *piece = &loops->v[i].pieces[k];
      const double *u = piece->interval;
      if (piece->segment != PH_NO_SEGMENT && (u[1] < u[0]) == back) {
        v[n++] = (struct kept){piece->segment, u[back], u[!back]};
      }
    }
  }
  qsort(v, n, sizeof *v, compare_kept);
  return n;
}

/* Whether the pen is elsewhere: the curve has a corner. */
static bool jumps(const struct ph_pen *pen, ph_vec3 to) {
  return pen->n > 0 &&
         ph_vec3_abs(ph_vec3_sub(to, pen->points[pen->n - 1])) > pen->tolerance;
}

/* A part of the offset of the segment that was trimmed, if it is one. */
static void draw_removed(struct ph_pen *pen, const struct ph_sampler *sampler,
                         size_t *cusp, double from, double to, size_t index) {
  const struct ph_curve *curve = sampler->curve;
  if (!(from < to)) {
    ph_pen_lift(pen, PH_STROKE_TRIMMED, index);
    return;
  }
  if (jumps(pen, ph_sampler_at(sampler, from).point)) {
    ph_pen_lift(pen, PH_STROKE_TRIMMED, index);
  }
  draw_between(pen, sampler, &sampler->offset->cusps, cusp, from, to,
               depth_of(curve->n));
}

/* What of the offset to one side is in no loop. */
static enum ph_status draw_trimmed(struct ph_pen *pen,
                                   const struct ph_offset *offset, bool back,
                                   size_t index) {
  const struct ph_curve *curve = &pen->result->curve;
  struct kept *kept = ph_arena_array(
      &pen->scratch, pieces_of(&offset->loops) + 1, sizeof *kept);
  const size_t n = kept ? list_kept(&offset->loops, back, kept) : 0;
  struct ph_sampler sampler;
  enum ph_status status =
      kept ? ph_sampler_begin(&sampler, curve, &offset->loops.sides[back],
                              &pen->scratch, pen->diag)
           : ph_fail_memory(pen->diag);
  for (size_t k = 0, i = 0, cusp = 0; status == PH_OK && k < curve->n; k++) {
    double from = 0;
    status = ph_sampler_enter(&sampler, k, pen->diag);
    for (; status == PH_OK && i < n && kept[i].segment == k; i++) {
      draw_removed(pen, &sampler, &cusp, from, kept[i].from, index);
      ph_pen_lift(pen, PH_STROKE_TRIMMED, index);
      from = fmax(from, kept[i].to);
    }
    if (status == PH_OK) {
      draw_removed(pen, &sampler, &cusp, from, 1, index);
    }
  }
  ph_pen_lift(pen, PH_STROKE_TRIMMED, index);
  return status;
}

/* Of every offset that was trimmed; it does not count for the size. */
static enum ph_status draw_all_trimmed(struct ph_pen *pen) {
  const struct ph_result *r = pen->result;
  enum ph_status status = PH_OK;
  pen->box = false;
  for (size_t i = 0; status == PH_OK && i < r->offsets_n; i++) {
    const struct ph_loops *loops = &r->offsets[i].loops;
    const int sides = !loops->mode ? 0 : loops->both ? 2 : 1;
    for (int side = 0; status == PH_OK && side < sides; side++) {
      status = draw_trimmed(pen, &r->offsets[i], side > 0, i);
    }
  }
  pen->box = true;
  return status;
}

static enum ph_status draw_offsets(struct ph_pen *pen) {
  enum ph_status status =
      pen->result->curve.n <= PH_DRAWING_POINTS ? draw_all_trimmed(pen) : PH_OK;
  for (size_t i = 0; status == PH_OK && i < pen->result->offsets_n; i++) {
    const struct ph_offset *o = &pen->result->offsets[i];
    for (size_t k = 0; status == PH_OK && k < o->loops.n; k++) {
      status = draw_curve(pen, o, &o->loops.v[k], PH_STROKE_OFFSET, i);
    }
    if (!o->loops.mode) {
      status = draw_curve(pen, o, NULL, PH_STROKE_OFFSET, i);
    }
  }
  return status;
}

/* ---- profiles ------------------------------------------------------------ */

static double defined(double x) {
  return isfinite(x) ? x : (double)NAN;
}

/* Appends places of the segment that begins at s. */
static void profile_segment(const struct ph_sampler *sampler, double s,
                            size_t intervals, struct ph_profile *profile) {
  for (size_t i = 0; i <= intervals; i++) {
    double u = (double)i / (double)intervals, speed;
    struct ph_sample sample = ph_sampler_at(sampler, u);
    profile->s[profile->n] = s + ph_sampler_length(sampler, u, &speed);
    profile->curvature[profile->n] = defined(sample.curvature);
    if (profile->torsion) {
      profile->torsion[profile->n] = defined(sample.torsion);
    }
    profile->n++;
  }
}

/* Arrays of a new profile. */
static struct ph_profile *new_profile(struct ph_pen *pen, size_t room) {
  struct ph_drawing *d = pen->drawing;
  struct ph_profile *p = &d->profiles[d->segments_n++];
  const bool space = d->space == PH_SPACE || d->space == PH_SURFACE;
  p->n = 0;
  p->s = ph_arena_array(&d->arena, room, sizeof *p->s);
  p->curvature = ph_arena_array(&d->arena, room, sizeof *p->curvature);
  p->torsion =
      space ? ph_arena_array(&d->arena, room, sizeof *p->torsion) : NULL;
  pen->failed = pen->failed || !p->s || !p->curvature || (space && !p->torsion);
  return p;
}

static enum ph_status make_profiles(struct ph_pen *pen) {
  const struct ph_curve *curve = &pen->result->curve;
  struct ph_drawing *d = pen->drawing;
  const size_t n = curve->n, most = PH_DRAWING_PLACES;
  const size_t step = profile_step(n), group = group_of(n);
  size_t intervals = most / n > 2 ? most / n - 1 : 1;
  struct ph_profile *profile = NULL;
  struct ph_sum s = {0, 0};
  struct ph_sampler sampler;
  enum ph_status status =
      ph_sampler_begin(&sampler, curve, NULL, &pen->scratch, pen->diag);
  intervals =
      intervals < PH_DRAWING_INTERVALS ? intervals : PH_DRAWING_INTERVALS;
  for (size_t k = 0; status == PH_OK && !pen->failed && k < n; k++) {
    if (k % group == 0) {
      profile = new_profile(pen, group / step * (intervals + 1));
    }
    if (k % step == 0 && !pen->failed) {
      status = ph_sampler_enter(&sampler, k, pen->diag);
      if (status == PH_OK) {
        profile_segment(&sampler, ph_sum_value(&s), intervals, profile);
        d->places += intervals + 1;
      }
    }
    ph_sum_add(&s, curve->lengths[k]);
  }
  return status;
}

/* ---- surfaces ------------------------------------------------------------ */

/* Places of the profile of a strip. */
enum { STRIP_PLACES = 33 };

static enum ph_status add_sheet(struct ph_pen *pen,
                                const struct ph_curve *curve) {
  struct ph_drawing *d = pen->drawing;
  struct ph_sheet *sheet = &d->sheets[d->sheets_n++];
  enum ph_status status = ph_sheet_make(curve, &d->arena, sheet, pen->diag);
  for (size_t i = 0; status == PH_OK && i < sheet->ribs_n; i++) {
    ph_pen_box(d, sheet->ribs[i].end[0]);
    ph_pen_box(d, sheet->ribs[i].end[1]);
    d->places += 2;
  }
  for (size_t i = 0; status == PH_OK && i < sheet->elements_n; i++) {
    ph_pen_box(d, sheet->elements[i].point);
  }
  return status;
}

/* Normal and geodesic curvature of the strips that are drawn. */
static void profile_strips(struct ph_pen *pen) {
  const struct ph_curve *curve = &pen->result->curve;
  const size_t step = ph_sheet_step(curve->n);
  struct ph_sum s = {0, 0};
  for (size_t i = 0; !pen->failed && i < curve->n; i++) {
    struct ph_profile *p =
        i % step == 0 ? new_profile(pen, STRIP_PLACES) : NULL;
    for (int j = 0; p && !pen->failed && j < STRIP_PLACES; j++) {
      const struct ph_ruling r = ph_ruling_at(&curve->surface.strips[i],
                                              (double)j / (STRIP_PLACES - 1));
      p->s[p->n] = ph_sum_value(&s) + r.s;
      p->curvature[p->n] = r.kn;
      p->torsion[p->n++] = r.k;
      pen->drawing->places++;
    }
    ph_sum_add(&s, curve->lengths[i]);
  }
}

static enum ph_status draw_surface(struct ph_pen *pen) {
  const struct ph_result *r = pen->result;
  struct ph_drawing *d = pen->drawing;
  enum ph_status status;
  d->sheets = ph_arena_array(&d->arena, r->parallels_n + 1, sizeof *d->sheets);
  if (!d->sheets) {
    return ph_fail_memory(pen->diag);
  }
  status = add_sheet(pen, &r->curve);
  ph_pen_numbers(pen, d->sheets[0].elements_n);
  for (size_t i = 0; status == PH_OK && i < r->parallels_n; i++) {
    status = add_sheet(pen, &r->parallels[i].curve);
  }
  if (status == PH_OK) {
    profile_strips(pen);
  }
  return status;
}

/* ---- the whole ----------------------------------------------------------- */

/* The size of what is drawn, near enough: offsets may be far away. */
static double size_of(const struct ph_result *r) {
  double farthest = 0;
  for (size_t i = 0; i < r->offsets_n; i++) {
    farthest = fmax(farthest, fabs(r->offsets[i].distance));
  }
  return 2 * (ph_curve_size(&r->curve) + farthest);
}

static const char *copy(struct ph_pen *pen, const char *text) {
  const char *kept =
      text ? ph_arena_copy(&pen->drawing->arena, text, strlen(text)) : NULL;
  pen->failed = pen->failed || (text && !kept);
  return kept;
}

/* The connected parts of all offsets, those that are drawn at most; of what was
 * trimmed, no more than pieces of loops and segments end. */
static size_t parts_of(const struct ph_result *r) {
  const bool trimmed = r->curve.n <= PH_DRAWING_POINTS;
  size_t n = 0;
  for (size_t i = 0; i < r->offsets_n; i++) {
    const size_t gaps = r->offsets[i].gaps.n;
    const struct ph_loops *loops = &r->offsets[i].loops;
    n += 1 + (gaps < PH_DRAWING_POINTS ? gaps : PH_DRAWING_POINTS) + loops->n;
    if (loops->mode && trimmed) {
      n += pieces_of(loops) + 2 * (r->curve.n + 1);
    }
  }
  return n;
}

/* All but strokes and profiles; makes room for these. */
static void prepare(struct ph_pen *pen, const struct ph_drawing_names *names) {
  const struct ph_curve *curve = &pen->result->curve;
  struct ph_drawing *d = pen->drawing;
  const double far = (double)INFINITY;
  size_t shown =
      curve->n < PH_DRAWING_SEGMENTS ? curve->n : PH_DRAWING_SEGMENTS;
  d->title = copy(pen, names->title);
  d->label = copy(pen, names->label);
  d->record = names->record;
  d->space = ph_kind_space(ph_kind_of(curve), curve->dimension);
  d->closed = curve->closed;
  memcpy(d->center, curve->sphere.center, sizeof d->center);
  d->radius = curve->sphere.radius;
  d->low = ph_vec3_of(far, far, far);
  d->high = ph_vec3_of(-far, -far, -far);
  d->length = curve->length;
  d->strokes = ph_arena_array(
      &d->arena, 2 * shown + parts_of(pen->result) + ph_pen_vectors_n(pen),
      sizeof *d->strokes);
  d->profiles = ph_arena_array(&d->arena, shown, sizeof *d->profiles);
  pen->failed = pen->failed || !d->strokes || !d->profiles;
  pen->box = true;
}

static enum ph_status draw(struct ph_pen *pen,
                           const struct ph_drawing_names *names) {
  const bool details = pen->result->curve.n <= PH_DRAWING_SEGMENTS;
  enum ph_status status;
  prepare(pen, names);
  if (!pen->failed && pen->drawing->space == PH_SURFACE) {
    status = draw_surface(pen);
    return pen->failed ? ph_fail_memory(pen->diag) : status;
  }
  pen->tolerance = CHORD * size_of(pen->result);
  pen->near = NEAR * size_of(pen->result);
  if (!pen->failed && details) {
    ph_pen_data(pen);
    ph_pen_polygons(pen);
  }
  status = pen->failed ? PH_OK : draw_offsets(pen);
  if (!pen->failed && status == PH_OK) {
    status = draw_curve(pen, NULL, NULL, PH_STROKE_CURVE, 0);
  }
  if (!pen->failed && status == PH_OK && details) {
    ph_pen_vectors(pen);
  }
  if (!pen->failed && status == PH_OK) {
    status = make_profiles(pen);
  }
  return pen->failed ? ph_fail_memory(pen->diag) : status;
}

enum ph_status ph_drawing_make(const struct ph_problem *problem,
                               const struct ph_result *result,
                               const struct ph_drawing_names *names,
                               struct ph_drawing **drawing,
                               struct ph_diag *diag) {
  struct ph_pen pen = {.problem = problem, .result = result, .diag = diag};
  enum ph_status status;
  *drawing = NULL;
  pen.drawing = ph_malloc(sizeof *pen.drawing);
  if (!pen.drawing) {
    return ph_fail_memory(diag);
  }
  memset(pen.drawing, 0, sizeof *pen.drawing);
  status = draw(&pen, names);
  ph_arena_free(&pen.scratch);
  if (status == PH_OK) {
    *drawing = pen.drawing;
  } else {
    ph_drawing_free(pen.drawing);
  }
  return status;
}

void ph_drawing_free(struct ph_drawing *drawing) {
  if (drawing) {
    ph_arena_free(&drawing->arena);
    ph_free(drawing);
  }
}
