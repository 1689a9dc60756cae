/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The arc length of a spherical Bezier segment (see spherical.h).
 *
 * Five values of the speed are enough for a gentle segment, which most of
 * smooth data are; that of any other is tabulated (kernel/primitive.h): it may
 * be nearly singular, where control points nearly coincide.  GSL's QAG does not
 * see a corner at an end there, and is wrong by 4e-8 where it says 1e-12; its
 * CQUAD takes twice as long.
 */
#include "curve/segment/spherical_net.h"
#include "kernel/quad.h"

#include <float.h>
#include <stdbool.h>

/* The Gauss rule of gentle segments, symmetric. */
enum { NODES = 5 };
static const double node[NODES] = {
    0.046910077030668003601, 0.23076534494715845448, 0.5,
    0.76923465505284154552, 0.9530899229693319964};
static const double weight[NODES] = {
    0.11846344252809454376, 0.23931433524968323402, 0.28444444444444444444,
    0.23931433524968323402, 0.11846344252809454376};

/* The Legendre coefficients of a function, as the rule has them, from its
 * values at the nodes:  P_{k+1} = x P_k + k / (k + 1) (x P_k - P_{k-1}). */
static void project(const double *value, double c[NODES]) {
  static const double ratio[NODES + 1] = {0,       1.0 / 2, 2.0 / 3,
                                          3.0 / 4, 4.0 / 5, 5.0 / 6};
  for (size_t k = 0; k < NODES; k++) {
    c[k] = 0;
  }
  for (size_t i = 0, j = NODES; i < j--; i++) { /* node i and its mirror j */
    double x = 2 * node[j] - 1, p = 1, q = x;   /* P_k(x), P_{k+1}(x) */
    double left = i < j ? weight[i] * value[i] : 0;
    double right = weight[j] * value[j];
    for (size_t k = 0; k < NODES; k++) {
      double r = x * q + ratio[k + 1] * (x * q - p);
      c[k] +=
          (double)(2 * k + 1) * p * (k % 2 == 0 ? right + left : right - left);
      p = q;
      q = r;
    }
  }
}

/* Whether 5 nodes suffice for a segment: the coefficients of the speed fall so
 * fast that the tenth, which is the error, does not matter. */
static bool is_gentle(const struct ph_spherical_net *net,
                      const double c[NODES]) {
  static const double fall = 0.04;
  double bound = c[0];
  bool small = net->e <= 1e-3;
  for (size_t k = 1; k < NODES; k++) {
    bound *= fall;
    small = small && fabs(c[k]) <= bound;
  }
  return small;
}

/* The velocity, unrolled into the tangent plane of p[0]: legs as the angles
 * they are, carried there along the legs before them, are the coefficients of
 * D = sum_k B_k L_k, B_k of degree 2.  It is S' / 3 itself of points that are
 * near each other, and up to its sign of all on one great circle. */
static void unroll(const struct ph_spherical *s,
                   const struct ph_spherical_net *net, ph_vec3 leg[3]) {
  for (size_t k = 0; k < 3; k++) {
    const struct ph_spherical_arc *arc = &net->arc[k];
    ph_vec3 along = ph_vec3_normal(arc->d, s->p[k]);
    double size = ph_vec3_abs(along);
    leg[k] = ph_vec3_scale(size > 0 ? sqrt(arc->square) / size : 0, along);
    for (size_t j = k; j-- > 0;) {
      leg[k] = ph_vec3_carried(leg[k], s->p[j + 1], s->p[j]);
    }
  }
}

/*
 * With b' normal to c, D = v + b' r + c r^2, r = t - t0.  One place where D
 * nearly vanishes is a corner of |D| that nobody misses; two near each other
 * are about r = 0, where v is small: at r^2 = -v.c / c.c.
 */
static size_t corners_of(const struct ph_spherical *s,
                         const struct ph_spherical_net *net,
                         double at[PH_SPHERICAL_CORNERS]) {
  static const double small = 0x1p-4; /* all within half a segment */
  static const double end = 1e-6; /* what is shorter has a length of its cube */
  ph_vec3 leg[3], b, c, v;
  double square, t, r, place[PH_SPHERICAL_CORNERS];
  size_t n = 0;
  unroll(s, net, leg);
  b = ph_vec3_scale(2, ph_vec3_sub(leg[1], leg[0]));
  c = ph_vec3_along(ph_vec3_sub(leg[2], leg[1]), -0.5, b);
  square = ph_vec3_dot(c, c);
  t = -ph_vec3_dot(b, c) / (2 * square);
  v = ph_vec3_along(ph_vec3_along(leg[0], t, b), t * t, c);
  if (!(ph_vec3_dot(v, v) < small * small * square)) {
    return 0;
  }
  r = sqrt(fmax(-ph_vec3_dot(v, c) / square, 0));
  place[0] = t - r;
  place[1] = t;
  place[2] = t + r;
  for (size_t i = 0; i < PH_SPHERICAL_CORNERS; i++) {
    if (place[i] > (n > 0 ? at[n - 1] : 0) + end && place[i] < 1 - end) {
      at[n++] = place[i];
    }
  }
  return n;
}

size_t ph_spherical_corners(const struct ph_spherical *s,
                            double at[PH_SPHERICAL_CORNERS]) {
  struct ph_spherical_net net;
  ph_spherical_net_of(s, &net);
  return corners_of(s, &net, at);
}

static double speed_at(const void *context, double t) {
  return ph_spherical_net_speed(context, t);
}

/*
 * The velocity of a segment with short legs, as the polynomial
 * sum_k c[k] T_k(2 t - 1) of degree 8.  In the plane its degree is 2, and every
 * power of the length h of the legs adds 3: c[3], c[4], c[5] are about h / 10
 * of the velocity, the next three h^2 / 1000, and what is left out h^3 / 10^4,
 * of which odd powers are across.
 */
enum { COURSE = 9 };
static const double SHORT = 0x1p-21; /* the greatest E: h = 1.4e-3 */

struct course {
  ph_vec3 c[COURSE];
  size_t terms; /* that count */
};

static void course_of(const struct ph_spherical_net *net,
                      struct course *course) {
  static const double place[COURSE] = {/* cos((2 j + 1) pi / 18) */
                                       0.98480775301220805937,
                                       0.86602540378443864676,
                                       0.64278760968653932632,
                                       0.34202014332566873304,
                                       0,
                                       -0.34202014332566873304,
                                       -0.64278760968653932632,
                                       -0.86602540378443864676,
                                       -0.98480775301220805937};
  const ph_vec3 none = {0, 0, 0};
  double largest = 0;
  for (size_t k = 0; k < COURSE; k++) {
    course->c[k] = none;
  }
  for (size_t j = 0; j < COURSE; j++) {
    double x = place[j], cheb = 1, last = x; /* T_k(x), T_{k-1}(x) */
    ph_vec3 v = ph_spherical_net_velocity(net, 0.5 + 0.5 * x);
    for (size_t k = 0; k < COURSE; k++) {
      double next = 2 * x * cheb - last;
      course->c[k] = ph_vec3_along(course->c[k], 2.0 / COURSE * cheb, v);
      last = cheb;
      cheb = next;
    }
  }
  course->c[0] = ph_vec3_scale(0.5, course->c[0]);
  for (size_t k = 0; k < 3; k++) {
    largest = fmax(largest, ph_vec3_abs(course->c[k]));
  }
  course->terms = COURSE;
  while (course->terms > 3 && ph_vec3_abs(course->c[course->terms - 1]) <=
                                  4 * DBL_EPSILON * largest) {
    course->terms--;
  }
}

static double speed_by_course(const void *context, double t) {
  const struct course *course = context;
  const ph_vec3 *c = course->c;
  double x = 2 * t - 1;
  ph_vec3 a = c[course->terms - 1], last = {0, 0, 0};
  for (size_t k = course->terms - 1; k-- > 1;) {
    ph_vec3 next = ph_vec3_sub(ph_vec3_along(c[k], 2 * x, a), last);
    last = a;
    a = next;
  }
  return ph_vec3_abs(ph_vec3_sub(ph_vec3_along(c[0], x, a), last));
}

enum ph_status ph_spherical_length(const struct ph_spherical *s,
                                   struct ph_primitive *table,
                                   struct ph_arena *arena, double *length) {
  /* of values in the table; their integral is known 100 times better */
  static const double precision = 3e-12;
  struct ph_spherical_net net;
  double speed[NODES], c[NODES], corner[PH_SPHERICAL_CORNERS];
  enum ph_status status;
  size_t corners;
  ph_spherical_net_of(s, &net);
  for (size_t i = 0; i < NODES; i++) {
    speed[i] = ph_spherical_net_speed(&net, node[i]);
  }
  project(speed, c);
  *length = c[0];
  if (is_gentle(&net, c)) {
    return PH_OK;
  }
  corners = corners_of(s, &net, corner);
  if (net.e < SHORT) {
    struct course course;
    course_of(&net, &course);
    status = ph_primitive_make(table, speed_by_course, &course, corner, corners,
                               precision, arena);
  } else {
    status = ph_primitive_make(table, speed_at, &net, corner, corners,
                               precision, arena);
  }
  *length = table->total;
  return status;
}
