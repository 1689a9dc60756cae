/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Drawings of results (see drawing.h).
 *
 * Strokes grow in a scratch arena and are copied to the drawing's when their
 * size is known.
 */
#include "plot/drawing.h"

#include "base/sum.h"
#include "curve/kind/kind.h"
#include "curve/offset/gap.h"
#include "curve/surface/ruling.h"
#include "kernel/s2.h"

#include <string.h>

/* Chords leave the curve by so much of the size of what is drawn. */
static const double CHORD = 1.0 / 4000;

/* A segment's chords are halved so often at most. */
enum { DEPTH_MAX = 10 };

/* A step along a great circle, whose chord leaves it by 1/4000 of the radius.
 */
static const double ARC_STEP = 0.04;

/* The longest vector, relative to the size of the data and to the mean length
 * of the curve from one to the next. */
static const double VECTOR_SIZE = 0.12, VECTOR_SPACING = 0.5;

/* A drawing while it is made. */
struct pen {
  struct ph_drawing *drawing;
  const struct ph_problem *problem;
  const struct ph_result *result;
  struct ph_arena scratch;
  ph_vec3 *points; /* of the stroke that is being drawn, in scratch */
  size_t n, room;
  bool box;         /* they count for the bounding box */
  bool failed;      /* for want of memory */
  double tolerance; /* of chords */
  struct ph_diag *diag;
};

static bool is_finite(ph_vec3 p) {
  return isfinite(p.x) && isfinite(p.y) && isfinite(p.z);
}

static bool is_same(ph_vec3 a, ph_vec3 b) {
  return memcmp(&a, &b, sizeof a) == 0;
}

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

/* ---- strokes ------------------------------------------------------------- */

static void extend_box(struct ph_drawing *d, ph_vec3 p) {
  d->low =
      ph_vec3_of(fmin(d->low.x, p.x), fmin(d->low.y, p.y), fmin(d->low.z, p.z));
  d->high = ph_vec3_of(fmax(d->high.x, p.x), fmax(d->high.y, p.y),
                       fmax(d->high.z, p.z));
}

/* Draws on to a point, unless the pen is there already. */
static void draw_to(struct pen *pen, ph_vec3 p) {
  ph_vec3 *grown;
  if (pen->failed || !is_finite(p) ||
      (pen->n > 0 && is_same(pen->points[pen->n - 1], p))) {
    return;
  }
  grown = ph_arena_grow(&pen->scratch, pen->points, pen->n, sizeof p, 64,
                        &pen->room);
  if (!grown) {
    pen->failed = true;
    return;
  }
  pen->points = grown;
  pen->points[pen->n++] = p;
  if (pen->box) {
    extend_box(pen->drawing, p);
  }
}

/* Ends a stroke; what has no length is a stroke of two equal points. */
static void lift(struct pen *pen, enum ph_stroke_role role, size_t index) {
  struct ph_drawing *d = pen->drawing;
  size_t n = pen->n < 2 ? 2 : pen->n;
  struct ph_stroke stroke = {role, index, n, NULL};
  if (pen->failed || pen->n == 0) {
    return;
  }
  stroke.points = ph_arena_array(&d->arena, n, sizeof *stroke.points);
  if (!stroke.points) {
    pen->failed = true;
    return;
  }
  stroke.points[1] = pen->points[0];
  memcpy(stroke.points, pen->points, pen->n * sizeof *stroke.points);
  d->strokes[d->strokes_n++] = stroke;
  d->places += n;
  pen->n = 0;
}

/* ---- curve and offsets --------------------------------------------------- */

/* From where the pen is, at u0, on to u1. */
static void draw_part(struct pen *pen, const struct ph_sampler *sampler,
                      double u0, double u1, int depth) {
  double middle = (u0 + u1) / 2, h = u1 - u0;
  if (depth > 0 && !(ph_sampler_chord_bound(sampler, u0, u1) * h * h / 8 <=
                     pen->tolerance)) {
    draw_part(pen, sampler, u0, middle, depth - 1);
    draw_part(pen, sampler, middle, u1, depth - 1);
  } else {
    draw_to(pen, ph_sampler_at(sampler, u1).point);
  }
}

/* A whole segment.  Cusps are corners of its parts: they stay sharp.
 * inout cusp  number of the next one */
static void draw_segment(struct pen *pen, const struct ph_sampler *sampler,
                         const struct ph_cusps *cusps, size_t *cusp,
                         int depth) {
  double from = 0;
  draw_to(pen, ph_sampler_at(sampler, 0).point);
  for (; cusps && *cusp < cusps->n && cusps->at[*cusp].segment <= sampler->k;
       ++*cusp) {
    double u = cusps->at[*cusp].u;
    if (cusps->at[*cusp].segment == sampler->k && from < u && u < 1) {
      draw_part(pen, sampler, from, u, depth);
      from = u;
    }
  }
  draw_part(pen, sampler, from, 1, depth);
}

/* The curve, a stroke for each of its segments if there are not too many, or an
 * offset of it, a stroke from gap to gap, or a loop of that. */
static enum ph_status draw_curve(struct pen *pen,
                                 const struct ph_offset *offset,
                                 const struct ph_loop *loop,
                                 enum ph_stroke_role role, size_t index) {
  const struct ph_curve *curve = &pen->result->curve;
  const size_t n = loop ? loop->n : curve->n;
  const size_t step = stroke_step(n), group = offset ? n : group_of(n);
  const struct ph_offset *whole = loop ? NULL : offset;
  struct ph_sampler sampler;
  size_t cusp = 0, gap = 0;
  int depth = 0;
  enum ph_status status =
      loop
          ? ph_sampler_begin_loop(&sampler, curve, offset, loop, &pen->scratch,
                                  pen->diag)
          : ph_sampler_begin(&sampler, curve, offset, &pen->scratch, pen->diag);
  while (depth < DEPTH_MAX && n << (depth + 1) <= PH_DRAWING_POINTS) {
    depth++;
  }
  for (size_t k = 0; status == PH_OK && k < n; k++) {
    bool begins = k > 0 && k % group == 0;
    if (k % step != 0 && k + 1 < n) {
      continue;
    }
    if (whole && ph_gaps_pass(&whole->gaps, k, &gap)) {
      lift(pen, role, index);
    }
    status = ph_sampler_enter(&sampler, k, pen->diag);
    if (status == PH_OK && begins) { /* the one before ends here */
      draw_to(pen, ph_sampler_at(&sampler, 0).point);
      lift(pen, role, k - group);
    }
    if (status == PH_OK) {
      draw_segment(pen, &sampler, whole ? &whole->cusps : NULL, &cusp, depth);
    }
  }
  lift(pen, role, offset ? index : (n - 1) / group * group);
  return status;
}

static enum ph_status draw_offsets(struct pen *pen) {
  enum ph_status status = PH_OK;
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

/* ---- control polygons ---------------------------------------------------- */

/* A point of the unit sphere, and back. */
static ph_vec3 to_unit(const struct ph_curve *curve, ph_vec3 p) {
  return ph_vec3_unit(ph_vec3_sub(p, ph_vec3_get(curve->sphere.center, 3)));
}

static ph_vec3 from_unit(const struct ph_curve *curve, ph_vec3 p) {
  return ph_vec3_along(ph_vec3_get(curve->sphere.center, 3),
                       curve->sphere.radius, p);
}

/* From where the pen is, at p, along a great circle to q. */
static void draw_arc(struct pen *pen, const struct ph_curve *curve, ph_vec3 p,
                     ph_vec3 q) {
  ph_vec3 a = to_unit(curve, p), b = to_unit(curve, q);
  size_t steps = 1 + (size_t)(ph_s2_angle(a, b) / ARC_STEP);
  for (size_t i = 1; i < steps; i++) {
    draw_to(pen,
            from_unit(curve, ph_s2_slerp(a, b, (double)i / (double)steps)));
  }
  draw_to(pen, q);
}

static void draw_polygons(struct pen *pen) {
  const struct ph_curve *curve = &pen->result->curve;
  pen->box = false;
  for (size_t k = 0; k < curve->n; k++) {
    const double *v = ph_curve_points(curve, k);
    ph_vec3 p, last = {0, 0, 0};
    for (size_t i = 0; i <= curve->degree; i++, last = p) {
      p = ph_vec3_get(v + curve->dimension * i, curve->dimension);
      if (i > 0 && pen->drawing->space == PH_SPHERE) {
        draw_arc(pen, curve, last, p);
      } else {
        draw_to(pen, p);
      }
    }
    lift(pen, PH_STROKE_POLYGON, k);
  }
  pen->box = true;
}

/* ---- data ---------------------------------------------------------------- */

/* The ends of the intervals of the data, or the joints. */
static void place_data(struct pen *pen) {
  const struct ph_result *r = pen->result;
  const struct ph_curve *curve = &r->curve;
  struct ph_drawing *d = pen->drawing;
  const size_t n = r->intervals_n ? r->intervals_n : curve->n;
  d->data = ph_arena_array(&d->arena, n + 1, sizeof *d->data);
  if (!d->data) {
    pen->failed = true;
    return;
  }
  for (size_t i = 0; i < n; i++) {
    const double *v =
        ph_curve_points(curve, r->intervals_n ? r->intervals[i].first : i);
    d->data[i] = ph_vec3_get(v, curve->dimension);
  }
  d->data_n = n;
  if (!curve->closed) {
    const double *v =
        ph_curve_points(curve, curve->n - 1) + curve->degree * curve->dimension;
    d->data[d->data_n++] = ph_vec3_get(v, curve->dimension);
  }
  for (size_t i = 0; i < d->data_n; i++) {
    extend_box(d, d->data[i]);
  }
}

/* ---- tangents and derivatives -------------------------------------------- */

/* A field of vectors at the points, or at both ends. */
struct vectors {
  const struct ph_value *value; /* NULL: there is none */
  bool ends;
  bool directions; /* their lengths say nothing */
};

static struct vectors given_vectors(const struct ph_problem *problem,
                                    bool closed) {
  static const struct {
    enum ph_field_id id;
    bool ends, directions;
  } fields[] = {{PH_F_TANGENTS, false, true},
                {PH_F_DERIVATIVES, false, false},
                {PH_F_END_TANGENTS, true, true},
                {PH_F_END_DERIVATIVES, true, false}};
  struct vectors none = {NULL, false, false};
  for (size_t i = 0; i < sizeof fields / sizeof fields[0]; i++) {
    const struct ph_value *value = &problem->field[fields[i].id];
    if (value->kind == PH_VECTORS && !(fields[i].ends && closed)) {
      return (struct vectors){value, fields[i].ends, fields[i].directions};
    }
  }
  return none;
}

/* Number i of the vectors that belong to data points, and its point. */
static ph_vec3 vector_at(const struct ph_drawing *d, const struct vectors *v,
                         size_t i, size_t *point) {
  *point = v->ends && i > 0 ? d->data_n - 1 : i;
  return ph_vec3_get(v->value->v + v->value->dimension * i,
                     v->value->dimension);
}

/* From a data point by a vector: on a sphere by what of it is tangent. */
static void draw_vector(struct pen *pen, ph_vec3 from, ph_vec3 vector) {
  const struct ph_curve *curve = &pen->result->curve;
  draw_to(pen, from);
  if (pen->drawing->space == PH_SPHERE) {
    ph_vec3 p = to_unit(curve, from), v = ph_vec3_normal(vector, p);
    double angle = ph_vec3_abs(vector) / curve->sphere.radius;
    size_t steps = 1 + (size_t)(angle / ARC_STEP);
    v = ph_vec3_scale(angle / ph_vec3_abs(v), v);
    for (size_t i = 1; i <= steps; i++) {
      double t = (double)i / (double)steps;
      draw_to(pen, from_unit(curve, ph_s2_exp(p, ph_vec3_scale(t, v))));
    }
  } else {
    draw_to(pen, ph_vec3_add(from, vector));
  }
}

static void draw_vectors(struct pen *pen) {
  const struct ph_curve *curve = &pen->result->curve;
  const struct ph_drawing *d = pen->drawing;
  const struct vectors given = given_vectors(pen->problem, curve->closed);
  size_t n = given.value ? given.value->n : 0, at;
  double longest = 0, size;
  n = n < d->data_n ? n : d->data_n;
  size = fmin(2 * VECTOR_SIZE * ph_curve_size(curve),
              VECTOR_SPACING * curve->length / (double)d->data_n);
  for (size_t i = 0; i < n; i++) {
    longest = fmax(longest, ph_vec3_abs(vector_at(d, &given, i, &at)));
  }
  for (size_t i = 0; i < n; i++) {
    ph_vec3 vector = vector_at(d, &given, i, &at);
    double length = ph_vec3_abs(vector);
    if (length > 0) {
      draw_vector(
          pen, d->data[at],
          ph_vec3_scale(size / (given.directions ? length : longest), vector));
      lift(pen, PH_STROKE_TANGENT, at);
    }
  }
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
static struct ph_profile *new_profile(struct pen *pen, size_t room) {
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

static enum ph_status make_profiles(struct pen *pen) {
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

static enum ph_status add_sheet(struct pen *pen, const struct ph_curve *curve) {
  struct ph_drawing *d = pen->drawing;
  struct ph_sheet *sheet = &d->sheets[d->sheets_n++];
  enum ph_status status = ph_sheet_make(curve, &d->arena, sheet, pen->diag);
  for (size_t i = 0; status == PH_OK && i < sheet->ribs_n; i++) {
    extend_box(d, sheet->ribs[i].end[0]);
    extend_box(d, sheet->ribs[i].end[1]);
    d->places += 2;
  }
  for (size_t i = 0; status == PH_OK && i < sheet->elements_n; i++) {
    extend_box(d, sheet->elements[i].point);
  }
  return status;
}

/* Normal and geodesic curvature of the strips that are drawn. */
static void profile_strips(struct pen *pen) {
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

static enum ph_status draw_surface(struct pen *pen) {
  const struct ph_result *r = pen->result;
  struct ph_drawing *d = pen->drawing;
  enum ph_status status;
  d->sheets = ph_arena_array(&d->arena, r->parallels_n + 1, sizeof *d->sheets);
  if (!d->sheets) {
    return ph_fail_memory(pen->diag);
  }
  status = add_sheet(pen, &r->curve);
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

static const char *copy(struct pen *pen, const char *text) {
  const char *kept =
      text ? ph_arena_copy(&pen->drawing->arena, text, strlen(text)) : NULL;
  pen->failed = pen->failed || (text && !kept);
  return kept;
}

/* The connected parts of all offsets, those that are drawn at most. */
static size_t parts_of(const struct ph_result *r) {
  size_t n = 0;
  for (size_t i = 0; i < r->offsets_n; i++) {
    const size_t gaps = r->offsets[i].gaps.n;
    n += 1 + (gaps < PH_DRAWING_POINTS ? gaps : PH_DRAWING_POINTS) +
         r->offsets[i].loops.n;
  }
  return n;
}

/* All but strokes and profiles; makes room for these. */
static void prepare(struct pen *pen, const struct ph_drawing_names *names) {
  const struct ph_curve *curve = &pen->result->curve;
  const struct ph_value *given =
      given_vectors(pen->problem, curve->closed).value;
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
      &d->arena, 2 * shown + parts_of(pen->result) + (given ? given->n : 0),
      sizeof *d->strokes);
  d->profiles = ph_arena_array(&d->arena, shown, sizeof *d->profiles);
  pen->failed = pen->failed || !d->strokes || !d->profiles;
  pen->box = true;
}

static enum ph_status draw(struct pen *pen,
                           const struct ph_drawing_names *names) {
  const bool details = pen->result->curve.n <= PH_DRAWING_SEGMENTS;
  enum ph_status status;
  prepare(pen, names);
  if (!pen->failed && pen->drawing->space == PH_SURFACE) {
    status = draw_surface(pen);
    return pen->failed ? ph_fail_memory(pen->diag) : status;
  }
  pen->tolerance = CHORD * size_of(pen->result);
  if (!pen->failed && details) {
    place_data(pen);
    draw_polygons(pen);
  }
  status = pen->failed ? PH_OK : draw_offsets(pen);
  if (!pen->failed && status == PH_OK) {
    status = draw_curve(pen, NULL, NULL, PH_STROKE_CURVE, 0);
  }
  if (!pen->failed && status == PH_OK && details) {
    draw_vectors(pen);
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
  struct pen pen = {.problem = problem, .result = result, .diag = diag};
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
