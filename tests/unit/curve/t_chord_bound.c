/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Bounds of chords: dense samples of curves of all kinds never leave their
 * chords, nor chords the curve, by more than the bound; for short intervals it
 * is near the truth, and of circles and helices it is the truth.
 */
#include "curve/sample/chord_bound.h"

#include "unit.h"
#include "segment_unit.h"

enum { STEPS = 60, CURVES = 60 };

static const double PI = 3.141592653589793;

/* ---- curves -------------------------------------------------------------- */

enum kind { PLANE, SPACE, CUBIC, OFFSET_PLANE, OFFSET_SPACE, BEZIER, KINDS };

struct path {
  enum kind kind;
  struct ph_seg3 seg;
  double distance;
  enum ph_normal normal;
  ph_vec3 p[6];
  size_t degree;
};

static ph_quat in_plane(ph_quat a) {
  return ph_quat_of(a.u, 0, 0, a.q);
}

/* Wild: preimages may turn by any angle and come near 0, ATPH angles are up to
 * 0.95 pi.  Offsets are to either side, with cusps and without. */
static struct path path_random(enum kind kind, struct unit_random *r) {
  struct path path = {.kind = kind, .seg = unit_seg3_random(r)};
  double angle = path.seg.space.angle;
  ph_quat *a = path.seg.a;
  if (kind == PLANE || kind == CUBIC || kind == OFFSET_PLANE) {
    for (size_t i = 0; i < 3; i++) {
      a[i] = in_plane(a[i]);
    }
  }
  if (kind == CUBIC) {
    a[1] = ph_quat_scale(0.5, ph_quat_add(a[0], a[2]));
    angle = 0;
  }
  path.seg = unit_seg3(fmin(angle, 0.95 * PI), a, unit_random_vec3(r, 1));
  path.distance = unit_random_in(r, -2, 2);
  path.normal = kind == OFFSET_SPACE && unit_random_below(r, 2) ? PH_E3 : PH_E2;
  path.degree = 1 + unit_random_below(r, 5);
  for (size_t i = 0; i <= path.degree; i++) {
    path.p[i] = unit_random_vec3(r, 1);
  }
  return path;
}

static ph_vec3 path_at(const struct path *path, double u) {
  ph_vec3 e[3], point, p[6];
  if (path->kind == BEZIER) {
    for (size_t i = 0; i <= path->degree; i++) {
      p[i] = path->p[i];
    }
    for (size_t m = path->degree; m > 0; m--) {
      for (size_t i = 0; i < m; i++) {
        p[i] = ph_vec3_along(ph_vec3_scale(1 - u, p[i]), u, p[i + 1]);
      }
    }
    return p[0];
  }
  point = ph_seg3_point(&path->seg, unit_quad(12), u);
  if (path->kind != OFFSET_PLANE && path->kind != OFFSET_SPACE) {
    return point;
  }
  unit_seg3_frame(&path->seg, u, e);
  return ph_vec3_along(point, path->distance, e[path->normal == PH_E2 ? 1 : 2]);
}

static double bend_of(const struct path *path, double u0, double u1) {
  switch (path->kind) {
  case OFFSET_PLANE:
  case OFFSET_SPACE:
    return ph_chord_bound_offset(&path->seg, path->normal, path->distance, u0,
                                 u1);
  case BEZIER:
    return ph_chord_bound_bezier(path->p, path->degree, u0, u1);
  default:
    return ph_chord_bound_ph(&path->seg, u0, u1);
  }
}

/* ---- the truth ----------------------------------------------------------- */

static double from_chord(ph_vec3 p, ph_vec3 from, ph_vec3 to) {
  ph_vec3 along = ph_vec3_sub(to, from);
  double square = ph_vec3_dot(along, along);
  double t = square > 0 ? ph_vec3_dot(ph_vec3_sub(p, from), along) / square : 0;
  t = fmin(fmax(t, 0), 1);
  return unit_apart(p, ph_vec3_along(from, t, along));
}

/* The greatest distance between [v,w] of a curve and its chord, either way. */
static double distance_of(const struct path *path, double v, double w) {
  ph_vec3 p[STEPS + 1];
  double greatest = 0;
  for (size_t i = 0; i <= STEPS; i++) {
    p[i] = path_at(path, v + (w - v) * (double)i / STEPS);
  }
  for (size_t i = 0; i <= STEPS; i++) {
    ph_vec3 place =
        ph_vec3_along(p[0], (double)i / STEPS, ph_vec3_sub(p[STEPS], p[0]));
    double least = (double)INFINITY;
    for (size_t j = 0; j < STEPS; j++) {
      least = fmin(least, from_chord(place, p[j], p[j + 1]));
    }
    greatest = unit_larger(greatest, least);
    greatest = unit_larger(greatest, from_chord(p[i], p[0], p[STEPS]));
  }
  return greatest;
}

/* ---- tests --------------------------------------------------------------- */

/* Points are known to this, at unit scale. */
static const double POINT = 2e-14;

static int compare(const void *a, const void *b) {
  double x = *(const double *)a, y = *(const double *)b;
  return (x > y) - (x < y);
}

/* Intervals of a length: the chords of all of it and of a part. */
static void check_bounds(enum kind kind, double h, struct unit_random *r,
                         double *ratio) {
  struct path path = path_random(kind, r);
  double u0 = unit_random_in(r, 0, 1 - h);
  double x = unit_random_in(r, 0, h), y = unit_random_in(r, 0, h);
  double m = bend_of(&path, u0, u0 + h), distance, part;
  distance = distance_of(&path, u0, u0 + h);
  part = distance_of(&path, u0 + fmin(x, y), u0 + fmax(x, y));
  ck_assert_double_le(distance, m * h * h / 8 * (1 + 1e-12) + POINT);
  ck_assert_double_le(part, m * (x - y) * (x - y) / 8 * (1 + 1e-12) + POINT);
  *ratio = distance > 0 ? m * h * h / 8 / distance : 1;
}

PH_TEST_EACH(test_holds, KINDS) {
  static const double lengths[] = {1, 0.5, 0.25, 0.0625, 1. / 64, 1. / 512};
  struct unit_random r = unit_random_of(100 + (uint64_t)_i);
  for (size_t k = 0; k < COUNT(lengths); k++) {
    for (int n = 0; n < unit_count(CURVES); n++) {
      double ratio;
      check_bounds((enum kind)_i, lengths[k], &r, &ratio);
    }
  }
}

/* Half of all bounds are within a tenth (of offsets, a fifth) of the truth
 * for intervals of 1/64. */
PH_TEST_EACH(test_tight, KINDS) {
  struct unit_random r = unit_random_of(200 + (uint64_t)_i);
  bool offset = _i == OFFSET_PLANE || _i == OFFSET_SPACE;
  double ratio[2 * CURVES];
  for (size_t n = 0; n < 2 * CURVES; n++) {
    check_bounds((enum kind)_i, 1. / 64, &r, &ratio[n]);
  }
  qsort(ratio, 2 * CURVES, sizeof ratio[0], compare);
  ck_assert_double_le(ratio[CURVES], offset ? 1.2 : 1.1);
}

/* g / sigma of a planar offset: 0 at cusps. */
static double speed_along(const struct path *path, double u) {
  struct unit_bend3 b = unit_seg3_bend(&path->seg, u);
  return 1 - path->distance * 2 * b.z.im / (b.speed * b.speed);
}

/* From a cusp on there is more than (1), which is that of the speed's slope:
 * chords leave the curve by the third power of their length alone. */
PH_TEST(test_cusp) {
  struct unit_random r = unit_random_of(250);
  size_t cusps = 0;
  for (int n = 0; n < 5 * unit_count(CURVES); n++) {
    struct path path = path_random(OFFSET_PLANE, &r);
    double low = 0.25, high = 0.5, h = 1. / 256, distance[2], bound[2];
    if (!(speed_along(&path, low) > 0 && speed_along(&path, high) < 0)) {
      continue;
    }
    for (size_t i = 0; i < 60; i++) {
      double middle = 0.5 * (low + high);
      *(speed_along(&path, middle) > 0 ? &low : &high) = middle;
    }
    for (size_t i = 0; i < 2; i++, h /= 16) {
      distance[i] = distance_of(&path, low, low + h);
      bound[i] = bend_of(&path, low, low + h) * h * h / 8;
      ck_assert_double_le(distance[i], bound[i] * (1 + 1e-12) + POINT);
    }
    if (bound[0] < 1e-3) { /* not so wild that h is long */
      ck_assert_double_le(bound[1], bound[0] / 1000);
      cusps++;
    }
  }
  ck_assert_uint_ge(cusps, 1);
}

/* In the limit it is |r''| across the curve, of offsets from the curve's
 * geometry: kappa / |1 - d kappa| times the square of sigma (1 - d kappa). */
PH_TEST(test_limit) {
  const double h = 1e-6;
  struct unit_random r = unit_random_of(300);
  for (int n = 0; n < 10 * unit_count(CURVES); n++) {
    struct path path = path_random(n % 2 ? PLANE : SPACE, &r);
    double u = unit_random_in(&r, 0, 1 - h);
    struct unit_bend3 b = unit_seg3_bend(&path.seg, u);
    double across = b.curvature * b.speed * b.speed;
    double kappa = 2 * b.z.im / (b.speed * b.speed);
    ck_abs(ph_chord_bound_ph(&path.seg, u, u + h), across, 1e-3 * (1 + across));
    if (path.kind == PLANE && b.speed > 0.1) {
      double x = 1 - path.distance * kappa;
      double m =
          ph_chord_bound_offset(&path.seg, PH_E2, path.distance, u, u + h);
      double wanted = fabs(kappa * x) * b.speed * b.speed;
      ck_abs(m, wanted, 1e-3 * (1 + wanted) * (1 + kappa * kappa));
    }
  }
}

/* A circle of radius 3, x from 0 to `end`, A = exp(k x / 2). */
static struct ph_seg3 circle(double end) {
  double root = sqrt(3 * end), angle = end / 2;
  struct ph_seg3 seg = {.space = ph_atph_of(angle)};
  seg.a[0] = ph_quat_of(root, 0, 0, 0);
  seg.a[1] = ph_quat_of(root, 0, 0, root * angle / (2 * seg.space.slope));
  seg.a[2] = ph_quat_of(root * cos(angle), 0, 0, root * sin(angle));
  seg.end = ph_vec3_of(3 * sin(end), 3 - 3 * cos(end), 0);
  return seg;
}

/* Of a circle M is the radius times the square of the angle, and so is that of
 * its offsets; the tangent turns by less than a quarter. */
PH_TEST(test_circle) {
  static const double ends[] = {0.1, 1, 1.5};
  for (size_t i = 0; i < 3; i++) {
    struct ph_seg3 seg = circle(ends[i]);
    double square = ends[i] * ends[i];
    ck_abs(ph_chord_bound_ph(&seg, 0, 1), 3 * square, 1e-10);
    ck_abs(ph_chord_bound_ph(&seg, 0.25, 0.75), 3 * square, 1e-10);
    ck_abs(ph_chord_bound_offset(&seg, PH_E2, 1, 0, 1), 2 * square, 1e-10);
    ck_abs(ph_chord_bound_offset(&seg, PH_E2, -1, 0, 1), 4 * square, 1e-10);
    ck_abs(ph_chord_bound_offset(&seg, PH_E2, 5, 0.25, 0.5), 2 * square, 1e-10);
    /* e3 is upright: the offset is the circle, above */
    ck_abs(ph_chord_bound_offset(&seg, PH_E3, 5, 0, 0.5), 3 * square, 1e-10);
  }
}

PH_TEST(test_line) {
  static const ph_vec3 p[4] = {
      {0, 0, 0}, {0.1, 0.2, 0.3}, {0.3, 0.6, 0.9}, {1, 2, 3}};
  const ph_quat a = {1, 2, -1, 0.5};
  const ph_quat even[3] = {a, a, a};
  struct ph_seg3 seg = unit_seg3(0, even, ph_vec3_of(0, 0, 0));
  ck_abs(ph_chord_bound_ph(&seg, 0.25, 1), 0, 1e-11);
  ck_abs(ph_chord_bound_offset(&seg, PH_E3, 3, 0, 1), 0, 1e-11);
  ck_abs(ph_chord_bound_bezier(p, 3, 0, 0.75), 0, 1e-11);
  ck_abs(ph_chord_bound_bezier(p, 1, 0, 1), 0, 0);
}

/* y = x^2 has r'' = (0, 2) everywhere. */
PH_TEST(test_parabola) {
  static const ph_vec3 p[3] = {{-1, 1, 0}, {0, -1, 0}, {1, 1, 0}};
  ck_rel(ph_chord_bound_bezier(p, 2, 0, 1), 8, 1e-13);
  ck_rel(ph_chord_bound_bezier(p, 2, 0.25, 0.75), 8, 1e-13);
  ck_rel(ph_chord_bound_bezier(p, 2, 0.5, 0.5), 8, 1e-13);
}

/* The curve stands still at 1/2, where there is a bound of its chords and no
 * offset. */
PH_TEST(test_standing) {
  const ph_quat still[3] = {{-1, 0, 0, 0}, {0, 0, 0, -0.25}, {1, 0, 0, 0.5}};
  struct path path = {.kind = PLANE};
  path.seg = unit_seg3(0, still, ph_vec3_of(0, 0, 0));
  ck_assert(isfinite(ph_chord_bound_ph(&path.seg, 0, 1)));
  ck_assert_double_le(distance_of(&path, 0.3, 0.6),
                      ph_chord_bound_ph(&path.seg, 0.3, 0.6) * 0.09 / 8);
  ck_abs(ph_chord_bound_offset(&path.seg, PH_E2, 1, 0.4, 0.6), (double)INFINITY,
         0);
  ck_assert(isfinite(ph_chord_bound_offset(&path.seg, PH_E2, 1, 0.6, 0.7)));
}

/* What is no number has no bound. */
PH_TEST(test_not_a_number) {
  const double nan = (double)NAN;
  struct ph_seg3 seg = circle(1), bad = seg;
  ph_vec3 p[4] = {{0, 0, 0}, {1, 0, 0}, {nan, 1, 0}, {3, 0, 0}};
  bad.a[1].q = nan;
  bad.a[2].q = nan;
  ck_abs(ph_chord_bound_ph(&bad, 0, 1), (double)INFINITY, 0);
  ck_abs(ph_chord_bound_offset(&bad, PH_E2, 1, 0, 1), (double)INFINITY, 0);
  ck_abs(ph_chord_bound_offset(&seg, PH_E2, nan, 0, 1), (double)INFINITY, 0);
  ck_abs(ph_chord_bound_bezier(p, 3, 0, 1), (double)INFINITY, 0);
}
