/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Tangents from points: they have the shape of the polygon [FAR15, (63)],
 * commute with motions, and are defined where a polygon turns back.
 */
#include "solve/spatial/spatial.h"

#include "kernel/quat.h"
#include "unit.h"

enum { POLYGONS = 300, POINTS_MAX = 12 };

struct polygon {
  size_t n;
  bool closed;
  double points[3 * POINTS_MAX];
  ph_vec3 tangents[POINTS_MAX];
};

static void set_tangents(struct polygon *p) {
  ph_spatial_tangents(p->points, p->n, 3, p->closed, p->tangents);
  for (size_t j = 0; j < p->n; j++) {
    ck_abs(ph_vec3_abs(p->tangents[j]), 1, 4e-16);
  }
}

static struct polygon polygon_of(size_t n, bool closed, const double *points) {
  struct polygon p = {.n = n, .closed = closed};
  memcpy(p.points, points, 3 * n * sizeof *points);
  set_tangents(&p);
  return p;
}

static struct polygon random_polygon(struct unit_random *r, size_t least,
                                     bool closed) {
  double points[3 * POINTS_MAX];
  size_t n = least + unit_random_below(r, POINTS_MAX + 1 - least);
  for (size_t i = 0; i < 3 * n; i++) {
    points[i] = unit_random_in(r, -1, 1);
  }
  return polygon_of(n, closed, points);
}

static ph_vec3 point(const struct polygon *p, size_t j) {
  const double *x = p->points + 3 * (j % p->n);
  return ph_vec3_of(x[0], x[1], x[2]);
}

/* Edge k - 1 of the polygon, with the one before the first and the one after
 * the last; the mirror images of the open one come from points. */
static ph_vec3 edge(const struct polygon *p, size_t k) {
  size_t edges = p->n - (p->closed ? 0 : 1);
  ph_vec3 d, u;
  if (p->closed) {
    k += p->n;
  } else if (k == 0 || k == edges + 1) {
    size_t end = k == 0 ? 0 : p->n - 1, next = k == 0 ? 1 : p->n - 2;
    size_t third = k == 0 ? 2 : p->n - 3;
    ph_vec3 middle = ph_vec3_add(point(p, end), point(p, next));
    u = ph_vec3_unit(ph_vec3_sub(point(p, next), point(p, end)));
    d = ph_vec3_sub(point(p, third), ph_vec3_scale(0.5, middle));
    d = ph_vec3_along(point(p, third), -2 * ph_vec3_dot(d, u), u);
    return k == 0 ? ph_vec3_sub(point(p, end), d)
                  : ph_vec3_sub(d, point(p, end));
  }
  return ph_vec3_sub(point(p, k), point(p, k - 1));
}

static ph_vec3 unit_or_zero(ph_vec3 v) {
  double length = ph_vec3_abs(v);
  return length > 0 ? ph_vec3_scale(1 / length, v) : v;
}

/* ---- shape ---------------------------------------------------------- */

/* The sign of a triple or scalar product of vectors near unit length, 0 where
 * rounding decides. */
static int sign_of(double x) {
  return x > 1e-12 ? 1 : x < -1e-12 ? -1 : 0;
}

/* Whether (63) holds at all segments; seen[]: signs of torsion and of
 * inflection that occurred. */
static void ck_shape(const struct polygon *p, size_t seen[2][3]) {
  size_t edges = p->n - (p->closed ? 0 : 1);
  for (size_t k = 0; k < edges; k++) {
    ph_vec3 before = unit_or_zero(edge(p, k));
    ph_vec3 d = unit_or_zero(edge(p, k + 1));
    ph_vec3 after = unit_or_zero(edge(p, k + 2));
    ph_vec3 ti = p->tangents[k], tf = p->tangents[(k + 1) % p->n];
    ph_vec3 ni = unit_or_zero(ph_vec3_cross(ti, d));
    ph_vec3 nf = unit_or_zero(ph_vec3_cross(d, tf));
    ph_vec3 bi = unit_or_zero(ph_vec3_cross(before, d));
    ph_vec3 bf = unit_or_zero(ph_vec3_cross(d, after));
    int torsion = sign_of(ph_vec3_triple(before, d, after));
    int inflection = sign_of(ph_vec3_dot(bi, bf));
    ck_assert_int_eq(sign_of(ph_vec3_triple(ti, d, tf)), torsion);
    ck_assert_int_eq(sign_of(ph_vec3_dot(ni, nf)), inflection);
    seen[0][torsion + 1]++;
    seen[1][inflection + 1]++;
  }
}

PH_TEST(test_shape) {
  struct unit_random r = unit_random_of(540);
  size_t seen[2][3] = {{0}};
  for (size_t n = 0; n < POLYGONS; n++) {
    struct polygon p = random_polygon(&r, 3, n % 2);
    ck_shape(&p, seen);
  }
  for (size_t i = 0; i < 2; i++) {
    ck_assert_uint_ge(seen[i][0], POLYGONS);
    ck_assert_uint_ge(seen[i][2], POLYGONS);
  }
}

/* A polygon with right angles and plane quadruples, such as a chair: signs are
 * zero too. */
PH_TEST(test_chair) {
  const double points[] = {0, 0, 0, 0, 0, 2, 0, 0, 4, 2, 0, 4, 2,  0, 2,
                           2, 2, 2, 2, 2, 0, 0, 2, 0, 0, 2, 2, -1, 1, 2};
  size_t seen[2][3] = {{0}};
  struct polygon p = polygon_of(10, true, points);
  ck_shape(&p, seen);
  for (size_t i = 0; i < 3; i++) {
    ck_assert_uint_ge(seen[0][i], 1);
  }
  ck_assert_uint_ge(seen[1][2], 1);
}

/* Points of a circle at any spacing, in any plane: its tangents. */
PH_TEST(test_circle) {
  struct unit_random r = unit_random_of(541);
  for (size_t n = 0; n < POLYGONS; n++) {
    ph_vec3 u = ph_vec3_unit(
        ph_vec3_of(unit_random_in(&r, -1, 1), unit_random_in(&r, -1, 1), 1.5));
    ph_vec3 v = ph_vec3_any_normal(u), center = {0.3, -0.2, 0.1};
    double points[3 * POINTS_MAX], angle[POINTS_MAX], at = 0;
    struct polygon p;
    for (size_t j = 0; j < POINTS_MAX; j++) {
      ph_vec3 x;
      at += unit_random_in(&r, 0.05, 0.5);
      angle[j] = at;
      x = ph_vec3_along(center, cos(at), u);
      x = ph_vec3_along(x, sin(at), v);
      points[3 * j] = x.x;
      points[3 * j + 1] = x.y;
      points[3 * j + 2] = x.z;
    }
    p = polygon_of(POINTS_MAX, n % 2, points);
    for (size_t j = 0; j < POINTS_MAX; j++) {
      ck_vec3(p.tangents[j],
              ph_vec3_along(ph_vec3_scale(-sin(angle[j]), u), cos(angle[j]), v),
              2e-14);
    }
  }
}

/* The ends of an open polygon are those of plane arcs: the first tangent is the
 * mirror image of the second. */
PH_TEST(test_ends) {
  struct unit_random r = unit_random_of(542);
  for (size_t n = 0; n < POLYGONS; n++) {
    struct polygon p = random_polygon(&r, 3, false);
    for (size_t end = 0; end < 2; end++) {
      size_t j = end ? p.n - 1 : 0, next = end ? p.n - 2 : 1;
      ph_vec3 u = ph_vec3_unit(ph_vec3_sub(point(&p, j), point(&p, next)));
      ph_vec3 t = p.tangents[next];
      ck_vec3(p.tangents[j],
              ph_vec3_along(ph_vec3_scale(-1, t), 2 * ph_vec3_dot(t, u), u),
              1e-12);
    }
  }
}

PH_TEST(test_two_points) {
  const double points[] = {1, 2, 3, 3, 3, 5};
  struct polygon p = polygon_of(2, false, points);
  for (size_t j = 0; j < 2; j++) {
    ck_vec3(p.tangents[j], ph_vec3_of(2.0 / 3, 1.0 / 3, 2.0 / 3), 1e-15);
  }
}

/* ---- invariance ----------------------------------------------------- */

static struct polygon reversed(const struct polygon *p) {
  struct polygon image = *p;
  for (size_t j = 0; j < p->n; j++) {
    memcpy(image.points + 3 * j, p->points + 3 * (p->n - 1 - j),
           3 * sizeof *p->points);
  }
  set_tangents(&image);
  return image;
}

/* The tangents of the reversed polygon are these, negated. */
static void ck_reversed(const struct polygon *p) {
  struct polygon back = reversed(p);
  for (size_t j = 0; j < p->n; j++) {
    ck_vec3(back.tangents[p->n - 1 - j], ph_vec3_scale(-1, p->tangents[j]),
            1e-15);
  }
}

/* Turned by q, and moved. */
static void ck_moved(const struct polygon *p, ph_quat q, double tol) {
  struct polygon image = *p;
  for (size_t j = 0; j < p->n; j++) {
    ph_quat x = ph_quat_mul(q, ph_quat_pure(point(p, j)));
    ph_vec3 v = ph_quat_vector(ph_quat_mul(x, ph_quat_conj(q)));
    image.points[3 * j] = v.x + 2;
    image.points[3 * j + 1] = v.y - 3;
    image.points[3 * j + 2] = v.z + 1;
  }
  set_tangents(&image);
  for (size_t j = 0; j < p->n; j++) {
    ph_quat x = ph_quat_mul(q, ph_quat_pure(p->tangents[j]));
    ck_vec3(image.tangents[j], ph_quat_vector(ph_quat_mul(x, ph_quat_conj(q))),
            tol);
  }
}

/* Scaled by a power of two: the same digits. */
static void ck_scaled(const struct polygon *p, int exponent) {
  struct polygon image = *p;
  for (size_t i = 0; i < 3 * p->n; i++) {
    image.points[i] = ldexp(p->points[i], exponent);
  }
  set_tangents(&image);
  for (size_t j = 0; j < p->n; j++) {
    ck_vec3(image.tangents[j], p->tangents[j], 0);
  }
}

static ph_quat random_rotation(struct unit_random *r) {
  ph_quat q = ph_quat_of(1.5, unit_random_in(r, -2, 2),
                         unit_random_in(r, -2, 2), unit_random_in(r, -2, 2));
  return ph_quat_scale(1 / ph_quat_abs(q), q);
}

PH_TEST(test_invariance) {
  struct unit_random r = unit_random_of(543);
  const int exponents[] = {-960, -101, -3, 1, 64, 1023};
  for (size_t n = 0; n < POLYGONS; n++) {
    struct polygon p = random_polygon(&r, 2 + n % 2, n % 2), rolled = p;
    ck_reversed(&p);
    ck_moved(&p, random_rotation(&r), 1e-11);
    for (size_t i = 0; i < COUNT(exponents); i++) {
      ck_scaled(&p, exponents[i]);
    }
    if (p.closed) {
      memcpy(rolled.points, p.points + 3, 3 * (p.n - 1) * sizeof *p.points);
      memcpy(rolled.points + 3 * (p.n - 1), p.points, 3 * sizeof *p.points);
      set_tangents(&rolled);
      for (size_t j = 0; j < p.n; j++) {
        ck_vec3(rolled.tangents[j], p.tangents[(j + 1) % p.n], 0);
      }
    }
  }
}

PH_TEST(test_planar) {
  struct unit_random r = unit_random_of(544);
  for (size_t n = 0; n < POLYGONS; n++) {
    struct polygon p = random_polygon(&r, 2 + n % 2, n % 2);
    double slope[2] = {unit_random_in(&r, -1, 1), unit_random_in(&r, -1, 1)};
    ph_vec3 normal = ph_vec3_unit(ph_vec3_of(slope[0], slope[1], -1));
    double z = n % 4 < 2 ? 0 : 0.7;
    for (size_t j = 0; j < p.n; j++) {
      p.points[3 * j + 2] = z;
    }
    set_tangents(&p);
    for (size_t j = 0; j < p.n; j++) {
      ck_abs(p.tangents[j].z, 0, 0);
    }
    for (size_t j = 0; j < p.n; j++) {
      p.points[3 * j + 2] =
          slope[0] * p.points[3 * j] + slope[1] * p.points[3 * j + 1];
    }
    set_tangents(&p);
    for (size_t j = 0; j < p.n; j++) {
      ck_abs(ph_vec3_dot(p.tangents[j], normal), 0, 1e-11);
    }
  }
}

/* ---- where the polygon turns back ----------------------------------- */

/* Comes from a side, turns back at (1,0,0), goes on to a side. */
static struct polygon hairpin(ph_vec3 from, ph_vec3 to) {
  const double points[] = {-from.x, -from.y, -from.z, 0, 0,    0,    1,   0,
                           0,       0,       0,       0, to.x, to.y, to.z};
  return polygon_of(5, false, points);
}

PH_TEST(test_hairpin) {
  const ph_vec3 x = {1, 0, 0}, y = {0, 1, 0}, z = {0, 0, 1};
  const ph_vec3 down = {0.5, -2, 0}, up = {-1, 3, 0};
  const ph_vec3 middle = {0, sqrt(0.5), sqrt(0.5)};
  struct unit_random r = unit_random_of(545);
  struct {
    ph_vec3 from, to, side;
  } c[] = {{y, y, y},
           {up, y, y},
           {up, z, middle},
           {x, y, y},
           {z, x, z},
           {y, down, y},
           {down, up, ph_vec3_of(0, -1, 0)},
           {x, x, ph_vec3_of(0, -1, 0)}};
  for (size_t i = 0; i < COUNT(c); i++) {
    struct polygon p = hairpin(c[i].from, c[i].to);
    ck_vec3(p.tangents[2], c[i].side, 1e-15);
    if (i < 5) { /* otherwise reversal maps the hairpin to itself */
      ck_reversed(&p);
      ck_moved(&p, random_rotation(&r), 1e-14);
    }
    ck_scaled(&p, -900);
    ck_scaled(&p, 900);
  }
}

/* Back and forth on a line: the sides of what lies before and after are found
 * at any distance, also around a closed polygon. */
PH_TEST(test_zigzag) {
  const double points[] = {0, 0, 0, 3, 0, 0, 0, 0, 0, 3, 0, 0,
                           0, 0, 0, 0, 2, 5, 0, 4, 5, 0, 4, 4};
  const ph_vec3 side = ph_vec3_unit(ph_vec3_of(0, 2, 5));
  const ph_vec3 from = ph_vec3_unit(ph_vec3_of(0, -4, -4));
  const ph_vec3 middle = ph_vec3_unit(ph_vec3_add(side, from));
  struct polygon p = polygon_of(8, false, points);
  for (size_t j = 0; j < 4; j++) {
    ck_vec3(p.tangents[j], side, 1e-15);
  }
  ck_reversed(&p);
  p.closed = true;
  set_tangents(&p);
  for (size_t j = 1; j < 4; j++) {
    ck_vec3(p.tangents[j], middle, 1e-14);
  }
  ck_reversed(&p);
}

/* Only back and forth, along any line: round and round, normal to it, and in
 * the plane z = 0 where the line is. */
PH_TEST(test_line) {
  const ph_vec3 lines[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {3, -4, 0},
                           {1, 1, 1}, {0, 2, 5}, {5, 0, 2}};
  for (size_t i = 0; i < COUNT(lines); i++) {
    for (size_t n = 2; n <= 6; n++) {
      double points[18] = {0};
      struct polygon p;
      for (size_t j = 1; j < n; j += 2) {
        points[3 * j] = lines[i].x;
        points[3 * j + 1] = lines[i].y;
        points[3 * j + 2] = lines[i].z;
      }
      p = polygon_of(n, n % 2 == 0, points);
      for (size_t j = 0; j < n; j++) {
        ck_abs(ph_vec3_dot(p.tangents[j], lines[i]), 0, 1e-15);
        ck_vec3(p.tangents[j], ph_vec3_scale(j % 2 ? -1 : 1, p.tangents[0]),
                1e-15);
        ck_assert(lines[i].z > 0 || unit_same(p.tangents[j].z, 0));
      }
    }
  }
}

/* Points that differ in less than the others have digits for: an edge keeps its
 * direction. */
PH_TEST(test_short_edge) {
  const double huge[] = {0, 0, 0, 0, 4e-320, 3e-320, 1e284, 4e-320, 3e-320};
  struct polygon p = polygon_of(3, false, huge);
  ck_vec3(p.tangents[0], ph_vec3_of(0, 0.8, 0.6), 1e-4);
  ck_vec3(p.tangents[1], p.tangents[0], 1e-15);
  /* the last one is that of a circle through three points */
  ck_vec3(p.tangents[2], ph_vec3_scale(-1, p.tangents[0]), 1e-15);
}
