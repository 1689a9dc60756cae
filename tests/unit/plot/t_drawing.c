/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Drawings: strokes near curves, profiles, vectors, and that all is bounded. */
#include "curve_unit.h"
#include "segment_unit.h"
#include "spherical_unit.h"
#include "tc_curve_unit.h"
#include "unit.h"

#include "curve/offset/cusp.h"
#include "curve/offset/gap.h"
#include "curve/offset/offset.h"
#include "curve/segment/seg2.h"
#include "kernel/pi.h"
#include "plot/drawing.h"

static const struct ph_drawing_names names = {"a title", "a = 1", 7};

static struct ph_drawing *drawing;
static struct ph_diag diag;

static void finish(void) {
  ph_drawing_free(drawing);
  drawing = NULL;
}

/* Draws anew. */
static const struct ph_drawing *draw(const struct ph_problem *problem,
                                     const struct ph_result *result) {
  ph_drawing_free(drawing);
  ck_assert_int_eq(ph_drawing_make(problem, result, &names, &drawing, &diag),
                   PH_OK);
  ck_assert_str_eq(drawing->title, names.title);
  ck_assert_str_eq(drawing->label, names.label);
  ck_assert_uint_eq(drawing->record, 7);
  ck_assert(drawing->closed == result->curve.closed);
  ck_abs(drawing->length, result->curve.length, 0);
  return drawing;
}

/* Draws a curve that is the only thing there is. */
static const struct ph_drawing *draw_curve(const struct ph_curve *curve) {
  static const struct ph_problem nothing;
  const struct ph_result result = {.curve = *curve};
  return draw(&nothing, &result);
}

/* Number i of the strokes of a role; NULL: there are fewer. */
static const struct ph_stroke *stroke_of(const struct ph_drawing *d,
                                         enum ph_stroke_role role, size_t i) {
  for (size_t k = 0; k < d->strokes_n; k++) {
    if (d->strokes[k].role == role && i-- == 0) {
      return &d->strokes[k];
    }
  }
  return NULL;
}

static size_t strokes_of(const struct ph_drawing *d, enum ph_stroke_role role) {
  size_t n = 0;
  while (stroke_of(d, role, n)) {
    n++;
  }
  return n;
}

/* Control point i of segment k. */
static ph_vec3 control_of(const struct ph_curve *curve, size_t k, size_t i) {
  return ph_vec3_get(ph_curve_points(curve, k) + curve->dimension * i,
                     curve->dimension);
}

/* A place of piece i of a stroke. */
static ph_vec3 stroke_at(const struct ph_stroke *s, size_t i, double t) {
  const ph_vec3 a = s->points[i], b = s->points[i + 1];
  const double r = 1 - t;
  if (!s->handles) {
    return ph_vec3_along(ph_vec3_scale(r, a), t, b);
  }
  return ph_vec3_add(ph_vec3_along(ph_vec3_scale(r * r * r, a), 3 * r * r * t,
                                   s->handles[2 * i]),
                     ph_vec3_along(ph_vec3_scale(t * t * t, b), 3 * r * t * t,
                                   s->handles[2 * i + 1]));
}

/* The distance to the nearest place of piece i between t = low and high, of
 * which there is one. */
static double to_piece(ph_vec3 p, const struct ph_stroke *s, size_t i,
                       double low, double high) {
  for (int k = 0; k < 60; k++) {
    const double a = low + (high - low) / 3, b = high - (high - low) / 3;
    if (unit_apart(p, stroke_at(s, i, a)) < unit_apart(p, stroke_at(s, i, b))) {
      high = b;
    } else {
      low = a;
    }
  }
  return unit_apart(p, stroke_at(s, i, low));
}

/* Whether a piece is no longer than a point is from its start. */
static bool is_far(ph_vec3 p, const struct ph_stroke *s, size_t i) {
  const ph_vec3 *h = s->handles ? s->handles + 2 * i : s->points + i;
  return unit_apart(p, s->points[i]) >
         1.01 * (unit_apart(s->points[i], h[0]) + unit_apart(h[0], h[1]) +
                 unit_apart(h[1], s->points[i + 1]));
}

static double to_stroke(ph_vec3 p, const struct ph_stroke *s) {
  enum { STEPS = 32 };
  double least = (double)INFINITY;
  for (size_t i = 0; i < STEPS * (s->n - 1); i++) {
    const double low = (double)(i % STEPS) / STEPS, high = low + 1.0 / STEPS;
    const ph_vec3 a = stroke_at(s, i / STEPS, low);
    const ph_vec3 b = stroke_at(s, i / STEPS, high);
    const double step = unit_apart(a, b);
    if (is_far(p, s, i / STEPS)) {
      i += STEPS - 1;
    } else if (fmin(unit_apart(p, a), unit_apart(p, b)) <= step) {
      least = fmin(least, to_piece(p, s, i / STEPS, low, high));
    }
  }
  return least;
}

/* Every segment of a curve by its stroke and profile. */
static void ck_segments(const struct ph_curve *curve) {
  const double tolerance = 2e-6 * ph_curve_size(curve);
  const struct ph_drawing *d = draw_curve(curve);
  double start = 0;
  ck_assert_uint_eq(d->segments_n, curve->n);
  ck_assert_uint_eq(strokes_of(d, PH_STROKE_CURVE), curve->n);
  ck_assert_uint_eq(strokes_of(d, PH_STROKE_POLYGON), curve->n);
  ck_assert_uint_eq(d->strokes_n, 2 * curve->n);
  for (size_t k = 0; k < curve->n; k++) {
    const struct ph_stroke *s = stroke_of(d, PH_STROKE_CURVE, k);
    const struct ph_stroke *polygon = stroke_of(d, PH_STROKE_POLYGON, k);
    const struct ph_profile *p = &d->profiles[k];
    struct ph_sampler sampler = unit_sampler(curve, NULL, k);
    ck_assert_uint_eq(s->index, k);
    ck_assert_uint_ge(s->n, 2);
    ck_vec3(s->points[0], control_of(curve, k, 0), 0);
    ck_vec3(s->points[s->n - 1], control_of(curve, k, curve->degree), 0);
    for (size_t i = 1; s->handles && i + 1 < s->n; i++) { /* no corners */
      const ph_vec3 in = ph_vec3_sub(s->points[i], s->handles[2 * i - 1]);
      const ph_vec3 out = ph_vec3_sub(s->handles[2 * i], s->points[i]);
      ck_vec3(ph_vec3_unit(in), ph_vec3_unit(out),
              1e-9 + 1e-14 * ph_curve_size(curve) /
                         fmin(ph_vec3_abs(in), ph_vec3_abs(out)));
    }
    ck_assert_uint_eq(polygon->index, k);
    ck_vec3(polygon->points[0], control_of(curve, k, 0), 0);
    ck_vec3(polygon->points[polygon->n - 1],
            control_of(curve, k, curve->degree), 0);
    ck_assert_uint_eq(p->n, 65);
    ck_assert((p->torsion != NULL) == (d->space == PH_SPACE));
    for (size_t i = 0; i <= 256; i++) {
      double u = (double)i / 256;
      struct ph_sample at = ph_sampler_at(&sampler, u);
      ck_assert(i % 2 > 0 || to_stroke(at.point, s) <= tolerance);
      if (i % 4 == 0) {
        ck_rel(p->s[i / 4], start + unit_length(&sampler, u), 1e-15);
        ck_assert(unit_same(p->curvature[i / 4], at.curvature) ||
                  (!isfinite(at.curvature) && isnan(p->curvature[i / 4])));
        ck_assert(!p->torsion || unit_same(p->torsion[i / 4], at.torsion) ||
                  isnan(at.torsion));
      }
    }
    start += curve->lengths[k];
  }
}

/* ---- curves by themselves ------------------------------------------------ */

/* w = e^(it), t in [0,3]: most of a circle of radius 1/2 about (0, 1/2). */
static void circle(struct unit_segments *c) {
  const double angle = 3, root = sqrt(angle);
  const struct ph_atph space = ph_atph_of(angle);
  const ph_cplx w[3] = {
      {root, 0},
      {root, root * angle / (2 * space.slope)},
      {root * cos(angle), root * sin(angle)},
  };
  struct ph_seg2 seg = unit_seg2(angle, w);
  unit_seg2_curve(&seg, 1, c);
  c->lengths[0] = c->curve.length = angle;
}

PH_TEST(test_circle) {
  const struct ph_drawing *d;
  const struct ph_stroke *s;
  struct unit_segments c;
  circle(&c);
  d = draw_curve(&c.curve);
  ck_assert_int_eq(d->space, PH_PLANE);
  ck_assert_uint_eq(d->data_n, 2);
  ck_vec3(d->data[0], ph_vec3_of(0, 0, 0), 0);
  ck_vec3(d->data[1], ph_vec3_of(sin(6) / 2, (1 - cos(6)) / 2, 0), 1e-15);
  /* the curve is 1 high; also where it turns between two of the points */
  ck_vec3(d->low, ph_vec3_of(-0.5, 0, 0), 2e-6);
  ck_vec3(d->high, ph_vec3_of(0.5, 1, 0), 2e-6);
  s = stroke_of(d, PH_STROKE_CURVE, 0);
  /* the error of a cubic for an arc of A is A^6 of 1e-5, about */
  ck_assert_uint_ge(s->n, 9);
  ck_assert_uint_le(s->n, 17);
  ck_assert(s->handles != NULL);
  for (size_t i = 0; i < s->n; i++) {
    ck_abs(unit_apart(s->points[i], ph_vec3_of(0, 0.5, 0)), 0.5, 1e-14);
  }
  for (size_t i = 0; i < 16 * (s->n - 1); i++) {
    ck_abs(unit_apart(stroke_at(s, i / 16, (double)(i % 16) / 16),
                      ph_vec3_of(0, 0.5, 0)),
           0.5, 2e-6);
  }
  for (size_t i = 0; i < d->profiles[0].n; i++) {
    ck_abs(d->profiles[0].s[i], 3 * (double)i / 64, 1e-14);
    ck_abs(d->profiles[0].curvature[i], 2, 1e-13);
  }
}

PH_TEST(test_planar) {
  struct unit_random r = unit_random_of(1);
  for (int i = 0; i < unit_count(50); i++) {
    struct unit_segments c;
    struct ph_seg2 seg = unit_seg2_random(&r);
    unit_seg2_curve(&seg, 1, &c);
    c.lengths[0] = c.curve.length = ph_seg2_length(&seg.space, seg.w);
    ck_segments(&c.curve);
  }
}

PH_TEST(test_cubics) {
  struct unit_random r = unit_random_of(2);
  for (int i = 0; i < unit_count(50); i++) {
    struct unit_cubics c;
    unit_cubics_random(&c, &r, 3, 1e3, ph_cplx_of(1, 2));
    ck_segments(&c.curve);
    for (size_t k = 0; k < 3; k++) { /* they are drawn as themselves */
      const struct ph_stroke *s = stroke_of(drawing, PH_STROKE_CURVE, k);
      ck_assert_uint_eq(s->n, 2);
      for (size_t j = 0; j < 2; j++) {
        ck_vec3(s->handles[j], control_of(&c.curve, k, 1 + j), 1e-12 * 1e3);
      }
    }
  }
}

PH_TEST(test_space) {
  struct unit_random r = unit_random_of(3);
  for (int i = 0; i < unit_count(50); i++) {
    struct unit_curve3 c;
    unit_curve3_random(&c, 3, i % 2, 0.5, &r);
    ck_segments(&c.curve);
    ck_assert_int_eq(drawing->space, PH_SPACE);
  }
}

/* On a sphere, polygons are on it too, and data. */
PH_TEST(test_sphere) {
  const ph_vec3 center = {1, -2, 3};
  struct unit_random r = unit_random_of(4);
  for (int i = 0; i < unit_count(50); i++) {
    struct unit_spherical c;
    unit_spherical_random(&c, 3, 0.4, &r);
    unit_spherical_place(&c, center, 10);
    ck_segments(&c.curve);
    ck_assert_int_eq(drawing->space, PH_SPHERE);
    ck_abs(drawing->radius, 10, 0);
    ck_vec3(ph_vec3_get(drawing->center, 3), center, 0);
    for (size_t k = 0; k < 3; k++) {
      const struct ph_stroke *s = stroke_of(drawing, PH_STROKE_POLYGON, k);
      for (size_t j = 0; j < s->n; j++) {
        ck_abs(unit_apart(s->points[j], center), 10, 1e-13);
        ck_assert(j == 0 || unit_apart(s->points[j - 1], s->points[j]) <= 0.4);
      }
    }
  }
}

/* A curve that stands still at its start has no curvature there. */
PH_TEST(test_rest) {
  const ph_vec3 p[4] = {{1, 0, 0}, {1, 0, 0}, {0.8, 0.6, 0}, {0, 0, 1}};
  const struct ph_drawing *d;
  struct unit_spherical c;
  unit_spherical_of(&c, 1, false, p);
  d = draw_curve(&c.curve);
  ck_assert(isnan(d->profiles[0].curvature[0]));
  for (size_t i = 1; i < d->profiles[0].n; i++) {
    ck_assert(isfinite(d->profiles[0].curvature[i]));
  }
}

/* ---- data and vectors ---------------------------------------------------- */

PH_TEST(test_intervals) {
  struct ph_interval intervals[2] = {PH_INTERVAL_NONE, PH_INTERVAL_NONE};
  const struct ph_problem nothing = {.field = {{.kind = PH_ABSENT}}};
  struct unit_random r = unit_random_of(5);
  struct unit_curve3 c;
  struct ph_result result = {.intervals = intervals, .intervals_n = 2};
  const struct ph_drawing *d;
  unit_curve3_random(&c, 3, false, 0.3, &r);
  result.curve = c.curve;
  intervals[0].last = 1;
  intervals[1].first = intervals[1].last = 2;
  d = draw(&nothing, &result);
  ck_assert_uint_eq(d->data_n, 3);
  ck_vec3(d->data[0], control_of(&c.curve, 0, 0), 0);
  ck_vec3(d->data[1], control_of(&c.curve, 2, 0), 0);
  ck_vec3(d->data[2], control_of(&c.curve, 2, 5), 0);
  result.curve.closed = true;
  ck_assert_uint_eq(draw(&nothing, &result)->data_n, 2);
}

/* Derivatives keep their proportions, directions do not. */
PH_TEST(test_vectors) {
  static const enum ph_field_id fields[] = {
      PH_F_TANGENTS, PH_F_DERIVATIVES, PH_F_END_TANGENTS, PH_F_END_DERIVATIVES};
  double v[] = {1, 0, 0, 2, 0, 0, -3, -4};
  struct unit_random r = unit_random_of(6);
  struct unit_cubics c;
  struct ph_result result = {.curve = {.n = 0}};
  unit_cubics_random(&c, &r, 3, 1, ph_cplx_of(0, 0));
  result.curve = c.curve;
  for (size_t f = 0; f < 4; f++) {
    const size_t n = f < 2 ? 4 : 2;
    struct ph_problem problem = {.field = {{.kind = PH_ABSENT}}};
    const struct ph_drawing *d;
    double first = 0, longest = 0, box = 2 * ph_curve_size(&c.curve);
    problem.field[fields[f]] = (struct ph_value){
        .kind = PH_VECTORS, .v = f < 2 ? v : v + 4, .n = n, .dimension = 2};
    d = draw(&problem, &result);
    /* the third of the four vectors is 0 */
    ck_assert_uint_eq(strokes_of(d, PH_STROKE_TANGENT), f < 2 ? 3 : 1);
    for (size_t i = 0; i < strokes_of(d, PH_STROKE_TANGENT); i++) {
      const struct ph_stroke *s = stroke_of(d, PH_STROKE_TANGENT, i);
      const size_t at = f >= 2 || i == 2 ? 3 : i;
      const ph_vec3 given = ph_vec3_get(v + 2 * at, 2);
      const ph_vec3 drawn = ph_vec3_sub(s->points[1], s->points[0]);
      const double length = ph_vec3_abs(drawn);
      const double scale = f % 2 ? length / ph_vec3_abs(given) : length;
      ck_assert_uint_eq(s->index, at);
      ck_assert_uint_eq(s->n, 2);
      ck_vec3(s->points[0], d->data[at], 0);
      ck_vec3(ph_vec3_unit(drawn), ph_vec3_unit(given), 1e-13);
      first = i == 0 ? scale : first;
      ck_rel(scale, first, 1e-13);
      longest = fmax(longest, length);
    }
    ck_assert_double_ge(longest, 0.02 * box);
    ck_assert_double_le(longest, 0.2 * box);
    result.curve.closed = true; /* it has no ends */
    ck_assert_uint_eq(strokes_of(draw(&problem, &result), PH_STROKE_TANGENT),
                      f < 2 ? 2 : 0);
    result.curve.closed = false;
  }
}

/* On a sphere vectors are bent to it. */
PH_TEST(test_vectors_sphere) {
  double v[] = {0, 3, 0, 1, 2, 3};
  const ph_vec3 center = {1, -2, 3};
  struct ph_problem problem = {.field = {{.kind = PH_ABSENT}}};
  struct unit_random r = unit_random_of(7);
  struct unit_spherical c;
  struct ph_result result = {.offsets_n = 0};
  const struct ph_drawing *d;
  unit_spherical_random(&c, 3, 0.2, &r);
  unit_spherical_place(&c, center, 10);
  result.curve = c.curve;
  problem.field[PH_F_END_TANGENTS] =
      (struct ph_value){.kind = PH_VECTORS, .v = v, .n = 2, .dimension = 3};
  d = draw(&problem, &result);
  ck_assert_uint_eq(strokes_of(d, PH_STROKE_TANGENT), 2);
  for (size_t i = 0; i < 2; i++) {
    const struct ph_stroke *s = stroke_of(d, PH_STROKE_TANGENT, i);
    ph_vec3 out = ph_vec3_unit(ph_vec3_sub(d->data[3 * i], center));
    ph_vec3 step =
        ph_vec3_normal(ph_vec3_sub(s->points[s->n - 1], s->points[0]), out);
    ck_assert_uint_eq(s->index, 3 * i);
    ck_vec3(s->points[0], d->data[3 * i], 0);
    ck_vec3(ph_vec3_unit(step),
            ph_vec3_unit(ph_vec3_normal(ph_vec3_get(v + 3 * i, 3), out)),
            1e-12);
    for (size_t j = 0; j < s->n; j++) {
      ck_abs(unit_apart(s->points[j], center), 10, 1e-13);
    }
  }
}

/* ---- offsets ------------------------------------------------------------- */

/* Within the circle, far outside of it, and one that is a point: it is drawn
 * too.  What is far away makes the box larger and the cubics coarser. */
PH_TEST(test_offsets) {
  const struct ph_problem nothing = {.field = {{.kind = PH_ABSENT}}};
  struct ph_offset offsets[] = {
      {.distance = 0.2}, {.distance = -9.5}, {.distance = 0.5}};
  const double radii[] = {0.3, 10, 0};
  struct ph_result result = {.offsets = offsets, .offsets_n = 3};
  const struct ph_drawing *d;
  struct unit_segments c;
  circle(&c);
  result.curve = c.curve;
  d = draw(&nothing, &result);
  ck_assert_uint_eq(strokes_of(d, PH_STROKE_OFFSET), 3);
  for (size_t i = 0; i < 3; i++) {
    const struct ph_stroke *s = stroke_of(d, PH_STROKE_OFFSET, i);
    ck_assert_uint_eq(s->index, i);
    ck_assert_uint_ge(s->n, 2);
    for (size_t j = 0; j < s->n; j++) {
      ck_abs(unit_apart(s->points[j], ph_vec3_of(0, 0.5, 0)), radii[i], 1e-13);
    }
  }
  ck_assert_uint_ge(stroke_of(d, PH_STROKE_OFFSET, 1)->n, 9);
  ck_assert_uint_le(stroke_of(d, PH_STROKE_CURVE, 0)->n, 9);
  ck_vec3(d->low, ph_vec3_of(-10, -9.5, 0), 1e-4);
  ck_vec3(d->high, ph_vec3_of(10, 10.5, 0), 1e-4);
}

static double length_of(const struct ph_drawing *d, enum ph_stroke_role role) {
  const struct ph_stroke *s;
  double length = 0;
  for (size_t i = 0; (s = stroke_of(d, role, i)) != NULL; i++) {
    for (size_t j = 0; j < 64 * (s->n - 1); j++) {
      length += unit_apart(stroke_at(s, j / 64, (double)(j % 64) / 64),
                           stroke_at(s, j / 64, (double)(j % 64 + 1) / 64));
    }
  }
  return length;
}

/* Loops and what was trimmed are the raw offset together, each part of it once,
 * and what was trimmed does not count for the box. */
PH_TEST(test_trimmed) {
  const struct ph_problem nothing = {.field = {{.kind = PH_ABSENT}}};
  const struct ph_offset_rules rules = {.mode = PH_OFFSET_TRIMMED,
                                        .crosses = true};
  struct unit_random r = unit_random_of(12);
  size_t trimmed = 0;
  for (int i = 0; i < unit_count(100); i++) {
    struct unit_cubics c;
    struct ph_offset raw = {.distance = unit_random_in(&r, -0.5, 0.5)};
    struct ph_offset offset;
    struct ph_result result = {.offsets = &raw, .offsets_n = 1};
    const struct ph_drawing *d;
    double whole, least;
    unit_cubics_random(&c, &r, 3, 1, ph_cplx_of(0, 0));
    result.curve = c.curve;
    ck_assert_int_eq(ph_cusps_of(&c.curve, raw.distance, PH_E2, &unit_arena,
                                 &raw.cusps, &diag),
                     PH_OK);
    d = draw(&nothing, &result);
    whole = length_of(d, PH_STROKE_OFFSET);
    least = d->low.x;
    ck_assert_uint_eq(strokes_of(d, PH_STROKE_TRIMMED), 0);
    ck_assert_int_eq(
        ph_offset(&c.curve, raw.distance, &rules, &unit_arena, &offset, &diag),
        PH_OK);
    result.offsets = &offset;
    d = draw(&nothing, &result);
    ck_abs(length_of(d, PH_STROKE_OFFSET) + length_of(d, PH_STROKE_TRIMMED),
           whole, 1e-4 * whole);
    ck_abs(length_of(d, PH_STROKE_OFFSET), offset.length, 1e-4 * whole);
    ck_assert(d->low.x >= least - 2e-3 * whole);
    trimmed += strokes_of(d, PH_STROKE_TRIMMED) > 0;
  }
  ck_assert_uint_gt(trimmed, 0);
}

/* The tips of cusps are drawn. */
PH_TEST(test_cusps) {
  const struct ph_problem nothing = {.field = {{.kind = PH_ABSENT}}};
  struct unit_random r = unit_random_of(8);
  size_t cusps = 0;
  for (int i = 0; i < unit_count(100); i++) {
    struct unit_cubics c;
    struct ph_offset offset = {.distance = unit_random_in(&r, -0.5, 0.5)};
    struct ph_result result = {.offsets = &offset, .offsets_n = 1};
    struct ph_sampler sampler;
    const struct ph_stroke *s;
    unit_cubics_random(&c, &r, 3, 1, ph_cplx_of(0, 0));
    result.curve = c.curve;
    ck_assert_int_eq(ph_cusps_of(&c.curve, offset.distance, PH_E2, &unit_arena,
                                 &offset.cusps, &diag),
                     PH_OK);
    s = stroke_of(draw(&nothing, &result), PH_STROKE_OFFSET, 0);
    for (size_t k = 0; k < offset.cusps.n; k++) {
      const struct ph_place *at = &offset.cusps.at[k];
      double least = (double)INFINITY;
      ph_vec3 tip;
      sampler = unit_sampler(&c.curve, &offset, at->segment);
      tip = ph_sampler_at(&sampler, at->u).point;
      for (size_t j = 0; j < s->n; j++) {
        least = fmin(least, unit_apart(tip, s->points[j]));
      }
      ck_abs(least, 0, 0);
    }
    cusps += offset.cusps.n;
  }
  ck_assert_uint_ge(cusps, 10);
}

/* Parts of an offset from gap to gap are strokes of their own. */
PH_TEST(test_gaps) {
  const struct ph_problem nothing = {.field = {{.kind = PH_ABSENT}}};
  struct ph_offset offsets[] = {{.distance = -1}, {.distance = 1}};
  struct ph_result result = {.offsets = offsets, .offsets_n = 2};
  const struct ph_drawing *d;
  struct unit_cubics c;
  unit_cubics_begin(&c, ph_cplx_of(0, 0));
  for (int i = 0; i < 4; i++) { /* a square */
    const ph_cplx w = ph_cplx_polar(PH_PI / 4 * i);
    unit_cubics_add(&c, w, w);
  }
  c.curve.closed = true;
  result.curve = c.curve;
  for (size_t i = 0; i < 2; i++) {
    ck_assert_int_eq(ph_gaps_of(&c.curve, offsets[i].distance, PH_E2,
                                &unit_arena, &offsets[i].gaps, &diag),
                     PH_OK);
  }
  d = draw(&nothing, &result);
  ck_assert_uint_eq(strokes_of(d, PH_STROKE_OFFSET), 8);
  for (size_t i = 0; i < 8; i++) {
    const struct ph_stroke *s = stroke_of(d, PH_STROKE_OFFSET, i);
    ck_assert_uint_eq(s->index, i / 4);
    ck_assert_uint_eq(s->n, 2);
    ck_abs(unit_apart(s->points[0], s->points[1]), 1, 1e-14);
  }
}

/* ---- bounds -------------------------------------------------------------- */

/* n straight segments of length 1. */
static struct ph_curve straight(size_t n) {
  struct ph_curve curve = {.kind = PH_CURVE_PH,
                           .dimension = 2,
                           .degree = 5,
                           .n = n,
                           .preimage.n = 3,
                           .preimage.dimension = 2};
  ck_assert_int_eq(ph_curve_alloc(&curve, &unit_arena, &diag), PH_OK);
  for (size_t k = 0; k < n; k++) {
    for (size_t i = 0; i < 6; i++) {
      curve.control_points[12 * k + 2 * i] = (double)k + (double)i / 5;
      curve.control_points[12 * k + 2 * i + 1] = 0;
    }
    for (size_t i = 0; i < 3; i++) {
      curve.preimage.v[6 * k + 2 * i] = 1;
      curve.preimage.v[6 * k + 2 * i + 1] = 0;
    }
    curve.lengths[k] = 1;
  }
  curve.length = (double)n;
  return curve;
}

PH_TEST(test_many) {
  static const size_t numbers[] = {1000, 1001, 2500, 10001, 100001, 250000};
  const size_t count = unit_count(50) < 50 ? 4 : 6; /* the large take long */
  for (size_t i = 0; i < count; i++) {
    const size_t n = numbers[i];
    const struct ph_curve curve = straight(n);
    const struct ph_drawing *d = draw_curve(&curve);
    const bool details = n <= PH_DRAWING_SEGMENTS;
    size_t points = 0, handles = 0, places = 0, polygons = details ? n : 0;
    double s = 0;
    ck_assert_uint_eq(d->data_n, details ? n + 1 : 0);
    ck_assert_uint_eq(strokes_of(d, PH_STROKE_POLYGON), polygons);
    ck_assert_uint_eq(d->strokes_n, polygons + d->segments_n);
    ck_assert_uint_le(d->segments_n, PH_DRAWING_SEGMENTS);
    ck_assert_uint_ge(d->segments_n, PH_DRAWING_SEGMENTS / 2);
    for (size_t k = 0; k < d->segments_n; k++) {
      const struct ph_stroke *stroke = &d->strokes[polygons + k];
      const struct ph_profile *profile = &d->profiles[k];
      ck_assert_int_eq(stroke->role, PH_STROKE_CURVE);
      ck_abs(stroke->points[0].x, (double)stroke->index, 0);
      ck_abs(stroke->points[stroke->n - 1].x,
             k + 1 < d->segments_n ? (double)stroke[1].index : (double)n, 0);
      for (size_t j = 0; j < profile->n; j++) {
        ck_abs(profile->curvature[j], 0, 0);
        ck_assert_double_ge(profile->s[j], s);
        s = profile->s[j];
      }
      points += stroke->n;
      handles += stroke->handles ? 2 * (stroke->n - 1) : 0;
      places += profile->n;
    }
    ck_assert_uint_ge(points, n < PH_DRAWING_POINTS ? n : 50000);
    ck_assert_uint_le(points + handles,
                      PH_DRAWING_POINTS + PH_DRAWING_SEGMENTS + 1);
    ck_assert_uint_ge(places, PH_DRAWING_PLACES / 2);
    ck_assert_uint_le(places, PH_DRAWING_PLACES);
    ck_assert_uint_eq(d->places, points + handles + places + 6 * polygons);
    ck_abs(d->high.x, (double)n, 0);
  }
}

PH_FIXTURE(NULL, finish)
