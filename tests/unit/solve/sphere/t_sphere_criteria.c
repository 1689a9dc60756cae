/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The criteria of shape on the sphere: on splines of the cases of [IOR15, ch.
 * 5] whose control points an independent program has given, on random segments
 * against dense samples, and on data whose shape is known.
 */
#include "unit.h"

#include "criteria_unit.h"

#include "curve/segment/spherical.h"
#include "kernel/pi.h"
#include "kernel/s2.h"
#include "solve/sphere/sphere.h"

enum { N_MAX = 64 };

/* Data, a spline of them that a test may fill, and their shape. */
struct setting {
  struct ph_sphere_data data;
  struct ph_sphere_spline spline;
  struct ph_sphere_shape shape;
  double v[3 * N_MAX];
  ph_vec3 r[N_MAX], l[N_MAX];
};

/* Reads n points; they are written to v if they are not there yet. */
static void set_up(struct setting *t, const double *v, size_t n, bool closed,
                   double epsilon, bool legacy) {
  struct ph_problem problem;
  struct ph_diag diag;
  if (v != t->v) {
    memcpy(t->v, v, 3 * n * sizeof *v);
  }
  memset(&problem, 0, sizeof problem);
  problem.field[PH_F_POINTS] =
      (struct ph_value){.kind = PH_VECTORS, .v = t->v, .n = n, .dimension = 3};
  problem.field[PH_F_CLOSED] =
      (struct ph_value){.kind = PH_BOOL, .flag = closed};
  ck_assert_int_eq(ph_sphere_data_read(&problem, &unit_arena, &t->data, &diag),
                   PH_OK);
  ck_assert(
      ph_sphere_shape_of(&t->data, epsilon, legacy, &unit_arena, &t->shape));
  t->spline = (struct ph_sphere_spline){
      .data = &t->data, .nu = t->data.nu, .r = t->r, .l = t->l};
}

static void ck_indicators(const struct setting *t, const int *q) {
  for (size_t i = 0; i < t->data.n; i++) {
    ck_assert_int_eq(t->shape.q[i], q[i]);
  }
}

/* The inner control points of segment k. */
static void put_inner(struct setting *t, size_t k, ph_vec3 r, ph_vec3 l) {
  t->r[k] = ph_vec3_sub(r, t->data.p[k]);
  t->l[k] = ph_vec3_sub(l, t->data.p[ph_sphere_next(&t->data, k)]);
}

/* Segment k of the spline is the great circle. */
static void straighten(struct setting *t) {
  for (size_t k = 0; k < t->data.m; k++) {
    ph_vec3 p = t->data.p[k], q = t->data.p[ph_sphere_next(&t->data, k)];
    put_inner(t, k, ph_s2_slerp(p, q, 1.0 / 3), ph_s2_slerp(p, q, 2.0 / 3));
  }
}

/* Those of segment k move up by so much. */
static void lift_inner(struct setting *t, size_t k, double r, double l) {
  struct ph_spherical s = ph_sphere_segment(&t->spline, k);
  put_inner(t, k, ph_s2_exp(s.p[1], ph_vec3_of(0, 0, r)),
            ph_s2_exp(s.p[2], ph_vec3_of(0, 0, l)));
}

/* ---- cases of the thesis ------------------------------------------------- */

/* The violated criteria as text, "C1 N3 S2". */
static void violations(const struct setting *t, char text[99]) {
  static const char letter[] = " CNS";
  size_t n = 0;
  text[0] = '\0';
  for (unsigned which = PH_SPHERE_COCIRCULARITY; which <= PH_SPHERE_SEGMENT;
       which++) {
    bool segment = which == PH_SPHERE_SEGMENT;
    for (size_t i = 0; i < (segment ? t->data.m : t->data.n); i++) {
      unsigned found = segment
                           ? ph_sphere_segment_fails(&t->shape, &t->spline, i)
                           : ph_sphere_node_fails(&t->shape, &t->spline, i);
      if (found == which && n < 90) {
        n += (size_t)sprintf(text + n, n > 0 ? " %c%zu" : "%c%zu",
                             letter[which], i);
      }
    }
  }
}

PH_TEST_EACH(test_case, 2 * COUNT(unit_sphere_cases)) {
  size_t which = (size_t)_i / 2, from = unit_sphere_cases[which].inner;
  bool legacy = _i % 2 == 0;
  struct setting t;
  char text[99];
  set_up(&t, unit_sphere_points[unit_sphere_cases[which].points],
         unit_sphere_cases[which].n, false, legacy ? 1e-3 : 1e-2, legacy);
  ck_indicators(&t, unit_sphere_cases[which].q);
  for (size_t k = 0; k < t.data.m; k++) {
    put_inner(&t, k, unit_sphere_inner[from + k][0],
              unit_sphere_inner[from + k][1]);
  }
  violations(&t, text);
  ck_assert_str_eq(text, legacy ? unit_sphere_cases[which].legacy
                                : unit_sphere_cases[which].geodesic);
}

/* ---- random segments ----------------------------------------------------- */

/* A control polygon of three legs, each to the left of the one before by an
 * angle. */
static struct ph_spherical polygon(struct unit_random *r, const double leg[3],
                                   const double turn[2]) {
  struct ph_spherical s;
  ph_vec3 d;
  s.p[0] = ph_vec3_unit(ph_vec3_of(unit_random_in(r, -1, 1),
                                   unit_random_in(r, -1, 1),
                                   unit_random_in(r, 0.01, 1)));
  d = ph_vec3_any_normal(s.p[0]);
  for (size_t j = 0; j < 3; j++) {
    ph_vec3 p = s.p[j], side;
    if (j > 0) {
      side = ph_vec3_cross(p, d);
      d = ph_vec3_along(ph_vec3_scale(cos(turn[j - 1]), d), sin(turn[j - 1]),
                        side);
    }
    s.p[j + 1] = ph_vec3_unit(
        ph_vec3_along(ph_vec3_scale(cos(leg[j]), p), sin(leg[j]), d));
    d = ph_vec3_along(ph_vec3_scale(cos(leg[j]), d), -sin(leg[j]), p);
    d = ph_vec3_unit(ph_vec3_normal(d, s.p[j + 1]));
  }
  return s;
}

/* Legs that sum to `sum`, with ratios up to 1000; turns of every kind. */
static struct ph_spherical random_segment(struct unit_random *r, double sum,
                                          int kind) {
  double leg[3], turn[2], whole = 0;
  for (size_t j = 0; j < 3; j++) {
    leg[j] = pow(10, -unit_random_in(r, 0, kind % 2 == 0 ? 0.5 : 3));
    whole += leg[j];
  }
  for (size_t j = 0; j < 3; j++) {
    leg[j] *= sum / whole;
  }
  for (size_t j = 0; j < 2; j++) {
    turn[j] = kind % 4 == 0   ? unit_random_in(r, -PH_PI, PH_PI)
              : kind % 4 == 1 ? unit_random_in(r, 0, 2.2)
              : kind % 4 == 2 ? unit_random_in(r, 0.9, 1.5)
                              : pow(10, -unit_random_in(r, 0, 6));
  }
  return polygon(r, leg, turn);
}

static enum ph_sphere_criterion judge(const struct ph_spherical *s, int sign) {
  ph_vec3 p[4] = {s->p[0], s->p[0], s->p[3], s->p[3]};
  ph_vec3 r[3] = {{0, 0, 0}, ph_vec3_sub(s->p[1], s->p[0]), {0, 0, 0}};
  ph_vec3 l[3] = {{0, 0, 0}, ph_vec3_sub(s->p[2], s->p[3]), {0, 0, 0}};
  signed char q[4] = {0, (signed char)sign, (signed char)sign, 0};
  struct ph_sphere_data data = {.n = 4, .m = 3, .p = p};
  struct ph_sphere_spline spline = {.data = &data, .r = r, .l = l};
  struct ph_sphere_shape shape = {.data = &data, .q = q};
  return ph_sphere_segment_fails(&shape, &spline, 1);
}

static ph_vec3 mirrored(ph_vec3 v) {
  return ph_vec3_of(v.x, v.y, -v.z);
}

/* The segment criterion accepts nothing that has a sample of the wrong sign,
 * and everything that is well away from 0. */
PH_TEST_EACH(test_segment, 2) {
  enum { SAMPLES = 128 };
  struct unit_random r = unit_random_of(3200 + (uint64_t)_i);
  int count = unit_count(1000), accepted = 0, rejected = 0;
  for (int j = 0; j < count; j++) {
    double sum = pow(10, unit_random_in(&r, _i == 0 ? -5 : -1, 0.7));
    struct ph_spherical s = random_segment(&r, sum, j), m;
    double least = HUGE_VAL, most = 0;
    enum ph_sphere_criterion found = judge(&s, 1);
    for (int i = 0; i <= SAMPLES; i++) {
      double k[2];
      ph_spherical_numerator(&s, (double)i / SAMPLES, k);
      least = fmin(least, k[0]);
      most = fmax(most, k[0]);
    }
    if (found == PH_SPHERE_FINE) {
      accepted++;
      ck_assert_msg(least > 0, "seed %lu: segment %d", unit_seed(), j);
    } else {
      rejected++;
      ck_assert_msg(!(least > 1e-3 * most), "seed %lu: segment %d", unit_seed(),
                    j);
    }
    for (size_t i = 0; i < 4; i++) {
      m.p[i] = mirrored(s.p[i]);
    }
    ck_assert_int_eq(judge(&m, -1), found);
  }
  ck_assert_int_gt(accepted, count / 10);
  ck_assert_int_gt(rejected, count / 10);
}

/* The least K of a segment whose K falls and rises again. */
static double least_numerator(const struct ph_spherical *s) {
  double low = 0, high = 1, k[2];
  for (int i = 0; i < 60; i++) {
    double middle = (low + high) / 2;
    ph_spherical_numerator(s, middle, k);
    *(k[1] < 0 ? &low : &high) = middle;
  }
  ph_spherical_numerator(s, low, k);
  return k[0];
}

/* Polygons that turn more and more, until K comes down to 0 in between: what is
 * accepted ends where its sign does, but for the square of the last piece. */
PH_TEST(test_threshold) {
  struct unit_random r = unit_random_of(3220);
  int count = unit_count(100);
  for (int j = 0; j < count; j++) {
    double sum = pow(10, unit_random_in(&r, -0.5, 0.5));
    double leg[3] = {sum * unit_random_in(&r, 0.3, 0.4),
                     sum * unit_random_in(&r, 0.1, 0.2),
                     sum * unit_random_in(&r, 0.3, 0.4)};
    double low = 1, high = 2.6, most[2];
    struct ph_spherical s;
    for (int i = 0; i < 48; i++) {
      double turn[2] = {(low + high) / 2, (low + high) / 2};
      struct unit_random same = r;
      s = polygon(&same, leg, turn);
      *(judge(&s, 1) == PH_SPHERE_FINE ? &low : &high) = turn[0];
    }
    ph_spherical_numerator(&s, 0, most);
    ck_abs(least_numerator(&s), 0, 1e-8 * most[0]);
  }
}

/* Beside the quadratic of a plane cubic: (4) of sphere/criteria.c, with
 * C = 1/2. */
PH_TEST(test_plane) {
  struct unit_random r = unit_random_of(3210 + (uint64_t)_i);
  int count = unit_count(2000);
  for (int j = 0; j < count; j++) {
    double largest = j % 3 == 0 ? 1 : pow(10, unit_random_in(&r, -3, 0));
    struct ph_spherical s = random_segment(&r, largest, j);
    ph_vec3 a = ph_vec3_sub(s.p[1], s.p[0]), b = ph_vec3_sub(s.p[2], s.p[1]);
    ph_vec3 c = ph_vec3_sub(s.p[3], s.p[2]);
    ph_vec3 middle = ph_vec3_unit(ph_vec3_add(s.p[1], s.p[2]));
    double sum = ph_vec3_abs(a) + ph_vec3_abs(b) + ph_vec3_abs(c);
    double b0 = 18 * ph_vec3_triple(s.p[0], a, b);
    double b1 = 9 * ph_vec3_triple(middle, a, c);
    double b2 = 18 * ph_vec3_triple(s.p[3], b, c);
    double most = fmax(fmax(fabs(b0), fabs(b1)), fabs(b2));
    for (int i = 0; i <= 20; i++) {
      double t = i / 20.0, u = 1 - t, k[2];
      ph_spherical_numerator(&s, t, k);
      ck_abs(k[0], b0 * u * u + 2 * b1 * t * u + b2 * t * t,
             most * sum * sum / 2 + 1e-15 * sum * sum);
    }
  }
}

/* ---- data of known shape ------------------------------------------------- */

/* n points from longitude 0 on a circle of latitude, `step` apart. */
static void put_circle(double *v, size_t n, double latitude, double step) {
  for (size_t i = 0; i < n; i++) {
    double lon = (double)i * step;
    v[3 * i] = cos(latitude) * cos(lon);
    v[3 * i + 1] = cos(latitude) * sin(lon);
    v[3 * i + 2] = sin(latitude);
  }
}

/* A circle of latitude has the curvature tan(latitude) at every spacing: it is
 * convex, however dense, unless that is below epsilon / 4. */
PH_TEST_EACH(test_dense, 4) {
  static const double steps[] = {0.3, 1e-2, 1e-4, 3e-6};
  struct setting t;
  for (int curved = 0; curved < 2; curved++) {
    put_circle(t.v, 20, curved ? 0.003 : 0.002, steps[_i]);
    set_up(&t, t.v, 20, false, 1e-2, false);
    for (size_t i = 1; i < 19; i++) {
      bool order = !curved && steps[_i] < 0.1;
      ck_assert_int_eq(t.shape.q[i], order ? 0 : 1);
      ck_assert_int_eq(t.shape.inorder[i], order);
    }
  }
}

/* Where rounding hides a curvature of epsilon, nothing is asked. */
PH_TEST(test_rounding) {
  struct setting t;
  put_circle(t.v, 20, 1e-3, 5e-8);
  set_up(&t, t.v, 20, false, 1e-2, false);
  straighten(&t);
  for (size_t i = 0; i < 20; i++) {
    ck_assert_int_eq(t.shape.q[i], 0);
    ck_assert(!t.shape.inorder[i]);
    ck_assert_int_eq(ph_sphere_node_fails(&t.shape, &t.spline, i),
                     PH_SPHERE_FINE);
  }
}

/* Back and forth on a great circle: the turn has no sign, and the data do not
 * go on; by the thesis's distances neither. */
PH_TEST_EACH(test_reversal, 2) {
  static const int q[7] = {0};
  struct setting t;
  double lon[] = {0, 0.5, 1, 0.3, 0.1, 1.6, 3.1};
  const bool inorder[] = {false, true, false, true, false, true, false};
  for (size_t i = 0; i < 7; i++) {
    t.v[3 * i] = cos(lon[i]);
    t.v[3 * i + 1] = sin(lon[i]);
    t.v[3 * i + 2] = 0;
  }
  set_up(&t, t.v, 7, false, 1e-2, _i == 1);
  ck_indicators(&t, q);
  for (size_t i = 0; i < 7; i++) {
    ck_assert_int_eq(t.shape.inorder[i], inorder[i]);
  }
}

/* The great circle itself satisfies all there is. */
PH_TEST_EACH(test_great_circle, 2) {
  struct setting t;
  char text[99];
  put_circle(t.v, 12, 0, PH_PI / 6);
  set_up(&t, t.v, 12, _i > 0, 1e-9, false);
  straighten(&t);
  violations(&t, text);
  ck_assert_str_eq(text, "");
  for (size_t i = 0; i < 12; i++) {
    size_t node[4];
    ck_assert_int_eq(t.shape.inorder[i], _i > 0 || (i > 0 && i < 11));
    if (t.shape.inorder[i]) {
      ck_assert_uint_eq(
          ph_sphere_touched(&t.shape, PH_SPHERE_COCIRCULARITY, i, node), 0);
    }
  }
}

/* The thesis looks at the side after a node only. */
PH_TEST_EACH(test_sides, 2) {
  bool legacy = _i == 1;
  struct setting t;
  for (int curved = 0; curved < 2; curved++) {
    double lift = curved ? -1 : 1; /* against the turn, or out of line */
    enum ph_sphere_criterion bad =
        curved ? PH_SPHERE_NODAL : PH_SPHERE_COCIRCULARITY;
    put_circle(t.v, 3, curved ? 0.5 : 0, 0.5);
    set_up(&t, t.v, 3, false, 1e-2, legacy);
    straighten(&t);
    for (size_t k = 0; curved && k < 2; k++) {
      lift_inner(&t, k, -0.03, -0.03);
    }
    ck_assert_int_eq(ph_sphere_node_fails(&t.shape, &t.spline, 1),
                     PH_SPHERE_FINE);
    lift_inner(&t, 0, 0.2 * lift, 0);
    ck_assert_int_eq(ph_sphere_node_fails(&t.shape, &t.spline, 1),
                     legacy ? PH_SPHERE_FINE : bad);
    lift_inner(&t, 1, 0, 0.2 * lift);
    ck_assert_int_eq(ph_sphere_node_fails(&t.shape, &t.spline, 1), bad);
  }
}

/* A node whose velocity is 0 has no curvature that could be small. */
PH_TEST(test_standstill) {
  struct setting t;
  put_circle(t.v, 3, 0, 0.5);
  set_up(&t, t.v, 3, false, 1e-2, false);
  straighten(&t);
  ck_assert_int_eq(ph_sphere_node_fails(&t.shape, &t.spline, 1),
                   PH_SPHERE_FINE);
  t.r[1] = ph_vec3_of(0, 0, 0);
  ck_assert_int_eq(ph_sphere_node_fails(&t.shape, &t.spline, 1),
                   PH_SPHERE_COCIRCULARITY);
}

/* ---- tensions ------------------------------------------------------------ */

static void ck_touched(const struct setting *t,
                       enum ph_sphere_criterion criterion, size_t at,
                       const char *expected) {
  size_t node[4], n = ph_sphere_touched(&t->shape, criterion, at, node);
  char text[99] = "";
  for (size_t j = 0, length = 0; j < n; j++) {
    length += (size_t)sprintf(text + length, j > 0 ? " %zu" : "%zu", node[j]);
  }
  ck_assert_str_eq(text, expected);
}

/* Along the equator with bends at 3, 6 and 7: nodes 1, 2 and 4, 5 and 8 are in
 * order. */
static void put_bends(double *v) {
  static const double turn[10] = {0, 0, 0, 0.5, 0, 0, -0.7, 0.4, 0, 0};
  ph_vec3 p = {1, 0, 0}, d = {0, 1, 0};
  for (size_t i = 0; i < 10; i++) {
    ph_vec3 q, side = ph_vec3_cross(p, d);
    ph_vec3_put(p, 3, v + 3 * i);
    d = ph_vec3_along(ph_vec3_scale(cos(turn[i]), d), sin(turn[i]), side);
    q = ph_s2_exp(p, ph_vec3_scale(0.2, d));
    d = ph_vec3_along(ph_vec3_scale(cos(0.2), d), -sin(0.2), p);
    p = q;
  }
}

PH_TEST_EACH(test_touched_open, 2) {
  static const int q[10] = {0, 0, 0, 1, 0, 0, -1, 1, 0, 0};
  struct setting t;
  put_bends(t.v);
  set_up(&t, t.v, 10, false, 1e-2, _i == 1);
  ck_indicators(&t, q);
  ck_touched(&t, PH_SPHERE_FINE, 3, "");
  if (_i == 1) {
    ck_touched(&t, PH_SPHERE_COCIRCULARITY, 1, "0 1 2");
    ck_touched(&t, PH_SPHERE_COCIRCULARITY, 4, "3 4 5");
    ck_touched(&t, PH_SPHERE_COCIRCULARITY, 8, "7 8 9");
    ck_touched(&t, PH_SPHERE_NODAL, 1, "0 1 2");
    ck_touched(&t, PH_SPHERE_SEGMENT, 1, "0 1 2 3");
    ck_touched(&t, PH_SPHERE_SEGMENT, 7, "6 7 8 9");
  } else {
    ck_touched(&t, PH_SPHERE_COCIRCULARITY, 1, "3");
    ck_touched(&t, PH_SPHERE_COCIRCULARITY, 2, "3");
    ck_touched(&t, PH_SPHERE_COCIRCULARITY, 4, "3 6");
    ck_touched(&t, PH_SPHERE_COCIRCULARITY, 5, "3 6");
    ck_touched(&t, PH_SPHERE_COCIRCULARITY, 8, "7");
    /* in place of those in order, whose curvature a tension would raise, the
     * ones beyond */
    ck_touched(&t, PH_SPHERE_NODAL, 3, "3 6");
    ck_touched(&t, PH_SPHERE_NODAL, 6, "3 6 7");
    ck_touched(&t, PH_SPHERE_SEGMENT, 6, "3 6 7");
  }
}

PH_TEST(test_touched_closed) {
  /* an equator with one bend out of it and back, from node 4 over 5 to 6 */
  static const int q[8] = {0, 0, 0, 0, 1, -1, 1, 0};
  struct setting t;
  put_circle(t.v, 8, 0, PH_PI / 4);
  t.v[3 * 5 + 2] = 0.02;
  set_up(&t, t.v, 8, true, 1e-2, false);
  ck_indicators(&t, q);
  ck_touched(&t, PH_SPHERE_COCIRCULARITY, 7, "6 4");
  ck_touched(&t, PH_SPHERE_COCIRCULARITY, 0, "6 4");
  ck_touched(&t, PH_SPHERE_COCIRCULARITY, 3, "6 4");
  ck_touched(&t, PH_SPHERE_NODAL, 5, "4 5 6");
  ck_touched(&t, PH_SPHERE_NODAL, 6, "5 6 4");
  ck_touched(&t, PH_SPHERE_SEGMENT, 4, "6 4 5");
}

/* Of three nodes, a segment touches each once. */
PH_TEST(test_touched_triangle) {
  static const double v[] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  struct setting t;
  set_up(&t, v, 3, true, 1e-2, false);
  ck_touched(&t, PH_SPHERE_SEGMENT, 1, "0 1 2");
  ck_touched(&t, PH_SPHERE_NODAL, 2, "1 2 0");
}

PH_TEST(test_names) {
  ck_assert_str_eq(ph_sphere_criterion_name(PH_SPHERE_FINE), "none");
  ck_assert_str_eq(ph_sphere_criterion_name(PH_SPHERE_COCIRCULARITY),
                   "co-circularity");
  ck_assert_str_eq(ph_sphere_criterion_name(PH_SPHERE_NODAL),
                   "nodal convexity");
  ck_assert_str_eq(ph_sphere_criterion_name(PH_SPHERE_SEGMENT),
                   "segment convexity");
}
