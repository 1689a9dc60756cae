/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Offsets on the sphere: distances, curvature, cusps, lengths. */
#include "spherical_unit.h"
#include "kernel/quad.h"
#include "unit.h"

#include "curve/offset/offset.h"
#include "kernel/degree.h"
#include "kernel/pi.h"

#include <gsl/gsl_sort.h>

enum { N = 10 };

static const double DEGREE = PH_PI / 180;

static struct ph_diag diag;
static const struct ph_offset_rules rules = {
    .tolerance = 1e-9, .samples = {.how = PH_SAMPLE_PARAMETER, .n = N}};
static struct ph_offset offset_of(const struct ph_curve *curve,
                                  double distance) {
  struct ph_offset o;
  ck_assert_int_eq(ph_offset(curve, distance, &rules, &unit_arena, &o, &diag),
                   PH_OK);
  ck_assert_uint_eq(o.n, 0);
  ck_assert_uint_eq(o.dimension, 3);
  ck_assert_uint_eq(o.samples.n, curve->n * (N + 1));
  ck_assert_ptr_nonnull(o.samples.lonlat);
  ck_assert_ptr_null(o.samples.torsion);
  ck_assert((o.cusps.at != NULL) == (o.cusps.n > 0));
  ck_abs(o.distance, distance, 0);
  ck_rel(o.samples.s[o.samples.n - 1], o.length, 0);
  return o;
}

/* ---- definitions, for tests --------------------------------------------- */

/* cos d - kappa sin d, whose zeros are the cusps. */
static double ahead(const struct ph_curve *curve, size_t k, double u,
                    double d) {
  double speed;
  return cos(d) - sin(d) * unit_kappa(curve, k, u, &speed);
}

/* The offset point of the unit sphere. */
static ph_vec3 moved(const struct ph_curve *curve, size_t k, double u,
                     double d) {
  struct ph_spherical segment = ph_spherical_of(curve, k);
  return unit_parallel(&segment, d, u);
}

/* ---- circles ------------------------------------------------------------ */

/* Parallels of the equator are circles of latitude, of curvature tan lat to the
 * left of who goes east; beyond the pole the offset goes west. */
static void ck_latitude(double lat) {
  const double d = lat * DEGREE, radius = 2;
  const ph_vec3 center = {1, 2, 3};
  const int back = cos(d) < 0 ? -1 : 1;
  struct unit_spherical c;
  struct ph_offset o;
  ph_vec3 p[8];
  for (size_t i = 0; i < 8; i++) {
    p[i] = ph_degree_to_unit(25.0 * (double)(i < 4 ? i : i - 1), 0);
  }
  unit_spherical_of(&c, 2, false, p);
  unit_spherical_place(&c, center, radius);
  o = offset_of(&c.curve, radius * d);
  ck_assert_uint_eq(o.cusps.n, 0);
  ck_rel(o.length, radius * 150 * DEGREE * fabs(cos(d)), 1e-13);
  for (size_t i = 0; i < o.samples.n; i++) {
    double lon = 75 * (o.samples.t[i] + (double)o.samples.segment[i]);
    ph_vec3 at = ph_degree_to_unit(lon, lat), lonlat;
    ck_vec3(unit_vector(o.samples.point, i), ph_vec3_along(center, radius, at),
            4e-15);
    ck_vec3(unit_vector(o.samples.tangent, i),
            ph_vec3_scale(back, ph_degree_to_unit(lon + 90, 0)), 2e-15);
    ck_abs(o.samples.curvature[i] * radius, sin(d) / fabs(cos(d)), 1e-13);
    ck_abs(o.samples.s[i], radius * lon * DEGREE * fabs(cos(d)), 1e-13);
    lonlat =
        ph_degree_to_unit(o.samples.lonlat[2 * i], o.samples.lonlat[2 * i + 1]);
    ck_vec3(lonlat, at, 4e-15);
  }
}

PH_TEST(test_latitude) {
  const double latitudes[] = {0, 1e-3, 30, 60, 89, 100, 170, -30, -89, -120};
  for (size_t i = 0; i < COUNT(latitudes); i++) {
    ck_latitude(latitudes[i]);
  }
}

/* A ring of n segments around the north pole, at this latitude. */
static void ring_of(struct unit_spherical *c, size_t n, double lat,
                    double wave) {
  ph_vec3 points[UNIT_SPHERICAL_MAX + 1], velocities[UNIT_SPHERICAL_MAX + 1];
  const double step = 360 / (double)n;
  for (size_t i = 0; i <= n; i++) {
    double lon = step * (double)(i % n);
    double up = lat + wave * cos(3 * lon * DEGREE);
    double rise = -3 * wave * DEGREE * sin(3 * lon * DEGREE);
    ph_vec3 east = ph_degree_to_unit(lon + 90, 0);
    ph_vec3 north = ph_degree_to_unit(lon, up + 90);
    points[i] = ph_degree_to_unit(lon, up);
    velocities[i] =
        ph_vec3_along(ph_vec3_scale(cos(up * DEGREE), east), rise, north);
    velocities[i] = ph_vec3_scale(step * DEGREE, velocities[i]);
  }
  unit_spherical_through(c, n, true, points, velocities);
}

/* The offset of a small circle, which the segments are but nearly. */
PH_TEST(test_small_circle) {
  struct unit_spherical c;
  struct ph_offset o;
  ring_of(&c, UNIT_SPHERICAL_MAX, 40, 0);
  o = offset_of(&c.curve, 20 * DEGREE);
  ck_assert_uint_eq(o.cusps.n, 0);
  ck_rel(o.length, 2 * PH_PI * cos(60 * DEGREE), 1e-5);
  for (size_t i = 0; i < o.samples.n; i++) {
    ck_abs(o.samples.lonlat[2 * i + 1], 60, 1e-4);
    ck_rel(o.samples.curvature[i], tan(60 * DEGREE), 1e-2);
  }
  o = offset_of(&c.curve, -100 * DEGREE); /* beyond the equator: -60 */
  ck_assert_uint_eq(o.cusps.n, 0);
  ck_rel(o.length, 2 * PH_PI * cos(60 * DEGREE), 1e-5);
  ck_rel(o.samples.curvature[5], tan(-60 * DEGREE), 1e-2);
}

/* L_d = L cos d - sin d (total kappa), without cusps. */
PH_TEST(test_closed_length) {
  const double distances[] = {0, 0.01, 0.1, -0.1, -0.3, -0.6};
  struct unit_spherical c;
  struct ph_quad rule;
  double total = 0;
  ring_of(&c, 24, 40, 3);
  ck_assert(ph_quad_gauss(&rule, 20));
  for (size_t k = 0; k < c.curve.n; k++) {
    for (size_t i = 0; i < rule.n; i++) {
      double speed, kappa = unit_kappa(&c.curve, k, rule.node[i], &speed);
      total += rule.weight[i] * kappa * speed;
    }
  }
  /* 2 pi less the area around the pole, which is nearly that of a circle */
  ck_abs(total, 2 * PH_PI * sin(40 * DEGREE), 0.01);
  for (size_t i = 0; i < COUNT(distances); i++) {
    double d = distances[i];
    struct ph_offset o = offset_of(&c.curve, d);
    ck_assert_uint_eq(o.cusps.n, 0);
    ck_rel(o.length, c.curve.length * cos(d) - sin(d) * total, 1e-12);
  }
}

/* ---- curves by chance --------------------------------------------------- */

/* Tangent and curvature from differences of offset points. */
static void ck_travel(const struct ph_curve *curve, const struct ph_offset *o,
                      size_t i, double d) {
  static const double steps[5] = {-2, -1, 0, 1, 2};
  const double h = 1e-3, u = o->samples.t[i];
  const size_t k = o->samples.segment[i];
  ph_vec3 p[5], d1, d2;
  double pace;
  for (size_t j = 0; j < 5; j++) {
    p[j] = moved(curve, k, u + steps[j] * h, d);
  }
  d1 = ph_vec3_sub(ph_vec3_scale(8, ph_vec3_sub(p[3], p[1])),
                   ph_vec3_sub(p[4], p[0]));
  d2 = ph_vec3_sub(
      ph_vec3_scale(16, ph_vec3_add(p[3], p[1])),
      ph_vec3_add(ph_vec3_add(p[4], p[0]), ph_vec3_scale(30, p[2])));
  d1 = ph_vec3_scale(1 / (12 * h), d1);
  d2 = ph_vec3_scale(1 / (12 * h * h), d2);
  pace = ph_vec3_abs(d1);
  if (pace > 0.05) {
    ck_vec3(unit_vector(o->samples.tangent, i), ph_vec3_scale(1 / pace, d1),
            1e-6);
    ck_abs(o->samples.curvature[i] * curve->sphere.radius,
           ph_vec3_triple(p[2], d1, d2) / (pace * pace * pace),
           1e-4 * (1 + 1 / pace));
  }
}

PH_TEST(test_random) {
  struct unit_random r = unit_random_of(1320);
  for (int n = 0; n < unit_count(60); n++) {
    const double radius = exp(unit_random_in(&r, -3, 3));
    const double d = unit_random_in(&r, -2, 2);
    const ph_vec3 center = {radius, 0, -radius};
    struct unit_spherical c;
    struct ph_offset o;
    unit_spherical_random(&c, 3, 0.4, &r);
    unit_spherical_place(&c, center, radius);
    o = offset_of(&c.curve, radius * d);
    for (size_t i = 0; i < o.samples.n; i++) {
      struct ph_spherical segment =
          ph_spherical_of(&c.curve, o.samples.segment[i]);
      ph_vec3 at = ph_vec3_sub(unit_vector(o.samples.point, i), center), jet[4];
      ph_vec3 tangent = unit_vector(o.samples.tangent, i);
      ph_spherical_jet(&segment, o.samples.t[i], jet);
      at = ph_vec3_scale(1 / radius, at);
      ck_abs(ph_vec3_abs(at), 1, 4e-15);
      ck_abs(ph_s2_angle(at, jet[0]), fabs(d), 1e-12);
      ck_abs(ph_vec3_dot(ph_s2_log(jet[0], ph_vec3_unit(at)),
                         ph_vec3_unit(jet[1])),
             0, 1e-12);
      ck_assert(d * ph_vec3_triple(jet[0], jet[1], at) >= 0);
      ck_abs(ph_vec3_abs(tangent), 1, 1e-14);
      ck_abs(ph_vec3_dot(tangent, at), 0, 1e-14);
      if (o.samples.t[i] > 0.01 && o.samples.t[i] < 0.99) {
        ck_travel(&c.curve, &o, i, d);
      }
    }
    ph_arena_reset(&unit_arena);
  }
}

/* ---- cusps -------------------------------------------------------------- */

/* Whether the offset turns back at the joint before segment k. */
static bool turns(const struct ph_curve *curve, size_t k, double d) {
  size_t before = (k + curve->n - 1) % curve->n;
  return (k > 0 || curve->closed) &&
         ahead(curve, before, 1, d) * ahead(curve, k, 0, d) < 0;
}

/* All of them, by looking at 4000 places; the length by as many chords, with
 * Richardson's extrapolation. */
static void ck_cusps(const struct ph_curve *curve, double d) {
  enum { LOOKS = 4000 };
  struct ph_offset o = offset_of(curve, d);
  size_t found = 0;
  double length[2] = {0, 0};
  for (size_t k = 0; k < curve->n; k++) {
    ph_vec3 last[2] = {moved(curve, k, 0, d), moved(curve, k, 0, d)};
    double before = ahead(curve, k, 0, d);
    if (turns(curve, k, d)) {
      ck_assert_uint_lt(found, o.cusps.n);
      ck_assert_uint_eq(o.cusps.at[found].segment, k);
      ck_abs(o.cusps.at[found].u, 0, 0);
      found++;
    }
    for (size_t i = 1; i <= LOOKS; i++) {
      double u = (double)i / LOOKS, now = ahead(curve, k, u, d);
      ph_vec3 at = moved(curve, k, u, d);
      if (before * now < 0) {
        ck_assert_uint_lt(found, o.cusps.n);
        ck_assert_uint_eq(o.cusps.at[found].segment, k);
        ck_abs(o.cusps.at[found].u, u - 0.5 / LOOKS, 0.5 / LOOKS);
        ck_abs(ahead(curve, k, o.cusps.at[found].u, d), 0, 1e-11);
        found++;
      }
      before = now;
      length[0] += ph_s2_angle(last[0], at);
      last[0] = at;
      if (i % 2 == 0) {
        length[1] += ph_s2_angle(last[1], at);
        last[1] = at;
      }
    }
  }
  ck_assert_uint_eq(found, o.cusps.n);
  ck_rel(o.length, (4 * length[0] - length[1]) / 3, found ? 1e-6 : 1e-9);
}

/* A closed curve whose curvature jumps at its joints. */
static void closed_random(struct unit_spherical *c, size_t n,
                          struct unit_random *r) {
  ph_vec3 points[UNIT_SPHERICAL_MAX + 1], velocities[UNIT_SPHERICAL_MAX + 1];
  const double step = 360 / (double)n;
  for (size_t i = 0; i < n; i++) {
    double lon = step * (double)i, lat = unit_random_in(r, 20, 50);
    ph_vec3 east = ph_degree_to_unit(lon + 90, 0);
    points[i] = ph_degree_to_unit(lon, lat);
    velocities[i] = ph_vec3_along(east, unit_random_in(r, -0.5, 0.5),
                                  ph_degree_to_unit(lon, lat + 90));
    velocities[i] = ph_vec3_scale(unit_random_in(r, 0.3, 0.9) * step * DEGREE,
                                  velocities[i]);
  }
  points[n] = points[0];
  velocities[n] = velocities[0];
  unit_spherical_through(c, n, true, points, velocities);
}

PH_TEST(test_cusps) {
  struct unit_random r = unit_random_of(1321);
  for (int i = 0; i < unit_count(20); i++) {
    struct unit_spherical c;
    if (i % 2) {
      unit_spherical_random(&c, 3, 0.5, &r);
    } else {
      closed_random(&c, 5, &r);
    }
    ck_cusps(&c.curve, unit_random_in(&r, -2.5, 2.5));
    ph_arena_reset(&unit_arena);
  }
}

/* Where the curvature of a segment is greatest. */
static double peak_of(const struct ph_curve *curve, double *peak) {
  double from = 0, to = 1, speed;
  for (int i = 0; i < 100; i++) {
    double a = from + (to - from) / 3, b = to - (to - from) / 3;
    if (unit_kappa(curve, 0, a, &speed) < unit_kappa(curve, 0, b, &speed)) {
      from = a;
    } else {
      to = b;
    }
  }
  *peak = unit_kappa(curve, 0, from, &speed);
  return from;
}

/* Two cusps about the place where a bend is sharpest, the nearer to each other
 * the nearer the distance is to the radius of curvature there. */
PH_TEST(test_pairs) {
  const double apart[] = {1e-1, 1e-2, 1e-4, 1e-6, 1e-8};
  const ph_vec3 p[4] = {ph_degree_to_unit(-20, 22), ph_degree_to_unit(-8, -5),
                        ph_degree_to_unit(9, -4), ph_degree_to_unit(20, 20)};
  struct unit_spherical c;
  double where, peak, before = 1;
  unit_spherical_of(&c, 1, false, p);
  where = peak_of(&c.curve, &peak);
  ck_assert(where > 0.1 && where < 0.9);
  for (size_t i = 0; i < COUNT(apart); i++) {
    double d = atan2(1, peak * (1 - apart[i])), width;
    struct ph_offset o = offset_of(&c.curve, d);
    ck_assert_uint_eq(o.cusps.n, 2);
    width = o.cusps.at[1].u - o.cusps.at[0].u;
    ck_assert(width > 0 && width < before);
    ck_assert(o.cusps.at[0].u < where && o.cusps.at[1].u > where);
    before = width;
    for (size_t j = 0; j < 2; j++) {
      ck_assert_uint_eq(o.cusps.at[j].segment, 0);
      ck_abs(ahead(&c.curve, 0, o.cusps.at[j].u, d), 0, 1e-13);
    }
    o = offset_of(&c.curve, atan2(1, peak * (1 + apart[i])));
    ck_assert_uint_eq(o.cusps.n, 0);
  }
}

/* g of (2), by the definition. */
static double forward(const struct ph_curve *curve, double u, double d) {
  double speed, kappa = unit_kappa(curve, 0, u, &speed);
  return speed * (cos(d) - sin(d) * kappa);
}

static double turning(const struct ph_curve *curve, double from, double to,
                      double d) {
  bool ahead_first = forward(curve, from, d) > 0;
  for (int i = 0; i < 80; i++) {
    double u = 0.5 * (from + to);
    if ((forward(curve, u, d) > 0) == ahead_first) {
      from = u;
    } else {
      to = u;
    }
  }
  return 0.5 * (from + to);
}

/* The cusps of the parallel of one segment, whose number this returns, and its
 * length, with places that crowd at two others. */
static size_t crowded(const struct ph_curve *curve, const double at[2],
                      double d, double *length) {
  enum { EVEN = 256, HALVINGS = 40, PLACES = EVEN + 1 + 4 * HALVINGS + 2 };
  struct ph_quad rule;
  double u[PLACES];
  size_t n = 0, cusps = 0;
  for (size_t i = 0; i <= EVEN; i++) {
    u[n++] = (double)i / EVEN;
  }
  for (size_t i = 0; i < 2; i++) {
    double near = at[1] > at[0] ? 0.5 * (at[1] - at[0]) : 0.1;
    u[n++] = at[i];
    for (size_t j = 0; j < HALVINGS; j++, near *= 0.5) {
      u[n++] = fmax(at[i] - near, 0);
      u[n++] = fmin(at[i] + near, 1);
    }
  }
  gsl_sort(u, 1, n);
  ck_assert(ph_quad_gauss(&rule, 20));
  *length = 0;
  for (size_t i = 0; i + 1 < n; i++) {
    double from[3] = {u[i], u[i + 1], u[i + 1]};
    if ((forward(curve, u[i], d) > 0) != (forward(curve, u[i + 1], d) > 0)) {
      from[1] = turning(curve, u[i], u[i + 1], d);
      cusps++;
    }
    for (size_t part = 0; part < 2; part++) {
      double width = from[part + 1] - from[part];
      for (size_t j = 0; width > 0 && j < rule.n; j++) {
        *length += rule.weight[j] * width *
                   fabs(forward(curve, from[part] + rule.node[j] * width, d));
      }
    }
  }
  return cusps;
}

static double slowness(const struct ph_curve *curve, double u) {
  double speed;
  unit_kappa(curve, 0, u, &speed);
  return speed;
}

/* The two places of least speed between others, or the only one twice. */
static void slow_places(const struct ph_curve *curve, double at[2]) {
  enum { STEPS = 4000, THIRDS = 80 };
  size_t n = 0;
  for (size_t i = 1; i < STEPS && n < 2; i++) {
    double from = (double)(i - 1) / STEPS, to = (double)(i + 1) / STEPS;
    double here = slowness(curve, (double)i / STEPS);
    if (here <= slowness(curve, from) && here < slowness(curve, to)) {
      for (int k = 0; k < THIRDS; k++) {
        double a = from + (to - from) / 3, b = to - (to - from) / 3;
        if (slowness(curve, a) < slowness(curve, b)) {
          to = b;
        } else {
          from = a;
        }
      }
      at[n++] = 0.5 * (from + to);
    }
  }
  ck_assert_uint_gt(n, 0);
  at[1] = n < 2 ? at[0] : at[1];
}

/* Forth, back for a short way, and forth, beside a great circle: two sharp
 * turns near each other. */
PH_TEST(test_running_back) {
  struct unit_random r = unit_random_of(612909);
  for (int i = 0; i < unit_count(100); i++) {
    double scale = pow(10, unit_random_in(&r, -3, -0.5));
    double t = unit_random_in(&r, 0.1, 0.9), at = 0, length;
    double back = pow(10, unit_random_in(&r, -2.5, -1.1));
    double beside = scale * pow(10, unit_random_in(&r, -4, -1));
    double d = unit_random_in(&r, -1, 1), turns[2];
    const double b[3] = {t * t - back * back, t * t - back * back - t,
                         t * t - back * back - 2 * t + 1};
    struct unit_spherical c;
    struct ph_offset o;
    ph_vec3 p[4];
    size_t cusps;
    for (size_t k = 0; k < 4; k++) {
      double up = beside * unit_random_in(&r, -1, 1);
      p[k] = ph_degree_to_unit(at / DEGREE, up / DEGREE);
      at += k < 3 ? scale * b[k] : 0;
    }
    unit_spherical_of(&c, 1, false, p);
    slow_places(&c.curve, turns);
    cusps = crowded(&c.curve, turns, d, &length);
    o = offset_of(&c.curve, d);
    ck_assert_uint_eq(o.cusps.n, cusps);
    ck_rel(o.length, length, 1e-9);
    ph_arena_reset(&unit_arena);
  }
}

/* Where the curvature jumps at a joint, the offset may turn back there. */
PH_TEST(test_joint) {
  const ph_vec3 p[8] = {ph_degree_to_unit(-30, 10), ph_degree_to_unit(-20, 3),
                        ph_degree_to_unit(-10, 0),  ph_degree_to_unit(0, 0),
                        ph_degree_to_unit(0, 0),    ph_degree_to_unit(10, 0),
                        ph_degree_to_unit(20, 10),  ph_degree_to_unit(20, 30)};
  struct unit_spherical c;
  struct ph_offset o;
  double speed, before, after, d;
  unit_spherical_of(&c, 2, false, p);
  before = unit_kappa(&c.curve, 0, 1, &speed);
  after = unit_kappa(&c.curve, 1, 0, &speed);
  ck_assert(after > before + 0.5);
  d = atan2(1, 0.5 * (before + after));
  o = offset_of(&c.curve, d);
  ck_assert_uint_ge(o.cusps.n, 1);
  ck_assert(ahead(&c.curve, 0, 1, d) > 0 && ahead(&c.curve, 1, 0, d) < 0);
  for (size_t i = 0; i < o.cusps.n; i++) {
    if (o.cusps.at[i].segment == 1) {
      ck_abs(o.cusps.at[i].u, 0, 0);
      return;
    }
  }
  ck_abort_msg("no cusp at the joint");
}

/* ---- ends at rest ------------------------------------------------------- */

/* The offset goes round the point at rest on a circle of radius d, of curvature
 * cot d, and turns back where the curve's curvature has come down to that. */
PH_TEST(test_rest) {
  const ph_vec3 a = ph_degree_to_unit(0, 0);
  const ph_vec3 p[4] = {a, a, ph_degree_to_unit(20, 0),
                        ph_degree_to_unit(30, 20)};
  struct unit_spherical c;
  struct ph_offset o;
  double d = 0.3, speed;
  unit_spherical_of(&c, 1, false, p);
  ck_assert(unit_kappa(&c.curve, 0, 1e-3, &speed) > 100);
  o = offset_of(&c.curve, d);
  ck_assert_uint_ge(o.cusps.n, 1);
  ck_abs(ahead(&c.curve, 0, o.cusps.at[0].u, d), 0, 1e-11);
  ck_abs(o.samples.curvature[0], cos(d) / sin(d), 1e-12);
  ck_vec3(unit_vector(o.samples.point, 0), ph_degree_to_unit(0, d / DEGREE),
          1e-14);
  ck_vec3(unit_vector(o.samples.tangent, 0), ph_vec3_of(0, -1, 0), 1e-14);
  o = offset_of(&c.curve, -d);
  ck_assert_uint_eq(o.cusps.n, 0);
  ck_abs(o.samples.curvature[0], cos(d) / sin(d), 1e-12);
  ck_vec3(unit_vector(o.samples.tangent, 0), ph_vec3_of(0, 1, 0), 1e-14);
  o = offset_of(&c.curve, 0);
  ck_assert(isnan(o.samples.curvature[0]));
  ck_rel(o.length, c.curve.length, 1e-12);
}

/* From rest to rest on a great circle: no curvature at the ends, no cusps. */
PH_TEST(test_rest_great_circle) {
  const ph_vec3 a = ph_degree_to_unit(0, 0), b = ph_degree_to_unit(40, 0);
  const ph_vec3 p[4] = {a, a, b, b};
  struct unit_spherical c;
  struct ph_offset o;
  unit_spherical_of(&c, 1, false, p);
  o = offset_of(&c.curve, 60 * DEGREE);
  ck_assert_uint_eq(o.cusps.n, 0);
  ck_rel(o.length, 20 * DEGREE, 1e-13);
  for (size_t i = 0; i <= N; i++) {
    ck_vec3(unit_vector(o.samples.tangent, i),
            ph_degree_to_unit(o.samples.lonlat[2 * i] + 90, 0), 1e-14);
    ck_assert(i % N ? unit_near(o.samples.curvature[i], sqrt(3), 1e-12)
                    : isnan(o.samples.curvature[i]));
  }
}

/* ---- refusals ----------------------------------------------------------- */

PH_TEST(test_refusals) {
  const struct ph_offset_rules many = {
      .samples = {.how = PH_SAMPLE_PARAMETER, .n = SIZE_MAX}};
  const double refused[] = {8 * PH_PI, -8 * PH_PI, 100, (double)INFINITY,
                            (double)NAN};
  struct unit_random r = unit_random_of(1322);
  const ph_vec3 zero = {0, 0, 0};
  struct unit_spherical c;
  struct ph_offset o;
  unit_spherical_random(&c, 2, 0.4, &r);
  unit_spherical_place(&c, zero, 8);
  for (size_t i = 0; i < COUNT(refused); i++) {
    ck_assert_int_eq(
        ph_offset(&c.curve, refused[i], &rules, &unit_arena, &o, &diag),
        PH_E_BAD_VALUE);
  }
  ck_assert_int_eq(ph_offset(&c.curve, 26, &rules, &unit_arena, &o, &diag),
                   PH_E_BAD_VALUE);
  ck_assert_str_eq(diag.message, "the offset distance 26 is not less than half "
                                 "the circumference of the sphere, 25.1327");
  ck_assert_uint_eq(offset_of(&c.curve, 25).samples.n, 2 * (N + 1));
  ck_assert_int_eq(ph_offset(&c.curve, 1, &many, &unit_arena, &o, &diag),
                   PH_E_LIMIT);
}

/* A curve to the north, whose offset is to the west, out of range. */
PH_TEST(test_too_large) {
  const ph_vec3 p[4] = {ph_degree_to_unit(0, 0), ph_degree_to_unit(0, 10),
                        ph_degree_to_unit(0, 20), ph_degree_to_unit(0, 30)};
  const ph_vec3 far = {0, -1.7e308, 0};
  struct unit_spherical c;
  struct ph_offset o;
  unit_spherical_of(&c, 1, false, p);
  unit_spherical_place(&c, far, 1e307);
  ck_assert_int_eq(ph_offset(&c.curve, 1.5e307, &rules, &unit_arena, &o, &diag),
                   PH_E_TOO_LARGE);
  ck_assert_str_eq(diag.message, "the offset at distance 1.5e+307 exceeds the "
                                 "range of a double");
  o = offset_of(&c.curve, 1e306);
  ck_rel(o.length, 1e307 * (30 * DEGREE * cos(0.1)), 1e-13);
}
