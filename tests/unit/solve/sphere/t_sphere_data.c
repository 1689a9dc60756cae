/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Reading the sphere problem: what comes of the fields, at any scale, and every
 * failure with its message.
 */
#include "unit.h"

#include "fields_unit.h"

#include "kernel/pi.h"
#include "kernel/s2.h"
#include "solve/sphere/sphere.h"

#define OCTANT \
  { PH_F_POINTS, VECTORS(3, 1, 0, 0, 0, 1, 0, 0, 0, 1) }
#define RING \
  { PH_F_POINTS, VECTORS(3, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0) }

static enum ph_status read_fields(const struct given given[GIVEN_MAX],
                                  struct ph_sphere_data *data,
                                  struct ph_diag *diag) {
  const struct ph_problem problem = unit_problem_of(given);
  return ph_sphere_data_read(&problem, &unit_arena, data, diag);
}

/* Reads what must be right. */
static struct ph_sphere_data data_of(const struct given given[GIVEN_MAX]) {
  struct ph_sphere_data data;
  struct ph_diag diag;
  enum ph_status status = read_fields(given, &data, &diag);
  ck_assert_msg(status == PH_OK, "%s: %s", diag.field, diag.message);
  return data;
}

static void ck_vector(ph_vec3 a, ph_vec3 b, double tol) {
  ck_abs(a.x, b.x, tol);
  ck_abs(a.y, b.y, tol);
  ck_abs(a.z, b.z, tol);
}

/* ---- failures ------------------------------------------------------------ */

/* A problem and why it is refused; tests/cli/sphere-errors.t has more. */
#define FAILS(status, field, message, ...) \
  { {__VA_ARGS__}, status, field, message }

static const struct {
  struct given given[GIVEN_MAX];
  enum ph_status status;
  const char *field, *message;
} failures[] = {
    FAILS(PH_E_BAD_SHAPE, "points",
          "must have 3 numbers for each point, found 2",
          {PH_F_POINTS, VECTORS(2, 1, 0, 0, 1)}),
    FAILS(PH_E_BAD_SHAPE, "lonlat",
          "must have 2 numbers for each point, found 3",
          {PH_F_LONLAT, VECTORS(3, 1, 0, 0, 0, 1, 0)}),
    FAILS(PH_E_BAD_VALUE, "lonlat[1][0]",
          "must be between -360 and 360 degrees, found 361",
          {PH_F_LONLAT, VECTORS(2, 0, 0, 361, 1)}),
    FAILS(
        PH_E_BAD_VALUE, "lonlat[2][1]",
        "must be between -90 and 90 degrees, found -90.5; the longitude comes "
        "first",
        {PH_F_LONLAT, VECTORS(2, 0, 0, 1, 1, 2, -90.5)}),
    FAILS(PH_E_BAD_VALUE, "radius", "must be at least 1e-300, found nan",
          OCTANT, {PH_F_RADIUS, NUMBER((double)NAN)}),
    FAILS(PH_E_NOT_ON_SPHERE, "points[1]",
          "is 1.002 from the center, and the radius is 1: they may differ by "
          "radius_tolerance, 0.001 of the radius",
          {PH_F_POINTS, VECTORS(3, 1, 0, 0, 0, 1.002, 0)}),
    FAILS(PH_E_NOT_ON_SPHERE, "points[0]",
          "is 50 from the center, and the radius is 1: they may differ "
          "by radius_tolerance, 0.001 of the radius; degrees are lonlat, in "
          "tables columns lon and lat",
          {PH_F_POINTS, VECTORS(3, 30, 40, 0, 0, 1.002, 0)}),
    FAILS(PH_E_NOT_ON_SPHERE, "points[0]",
          "is 4 from the center, and the radius is 4.5: they may differ by "
          "radius_tolerance, 0.1 of the radius",
          {PH_F_POINTS, VECTORS(3, 5, 2, 3, 1, 6, 3)},
          {PH_F_CENTER, NUMBERS(1, 2, 3)}, {PH_F_RADIUS, NUMBER(4.5)},
          {PH_F_RADIUS_TOLERANCE, NUMBER(0.1)}),
    FAILS(PH_E_NOT_ON_SPHERE, "points[0]",
          "is 1e+300 from the center, and the radius is 1e-300: they may "
          "differ by "
          "radius_tolerance, 0.001 of the radius",
          {PH_F_POINTS, VECTORS(3, 1e300, 0, 0, 0, 1, 0)},
          {PH_F_RADIUS, NUMBER(1e-300)}),
    FAILS(PH_E_COINCIDENT_POINTS, "points[2]",
          "coincides with points[1]: they are less than 1e-10 rad apart" JOINS,
          {PH_F_POINTS, VECTORS(3, 0, 1, 0, 1, 0, 0, 1, 9e-11, 0)}),
    FAILS(PH_E_COINCIDENT_POINTS, "lonlat[0]",
          "coincides with lonlat[3]: they are less than 1e-10 rad apart" JOINS,
          CLOSED, {PH_F_LONLAT, VECTORS(2, 0, 90, 10, 0, 90, 0, 7, 90, 0, 90)}),
    FAILS(
        PH_E_ANTIPODAL_POINTS, "points[2]",
        "is opposite to points[1] on the sphere, to 1e-06 rad: every direction "
        "leads from one to the other",
        {PH_F_POINTS, VECTORS(3, 0, 1, 0, 1, 0, 0, -1, 9e-7, 0)}),
    FAILS(PH_E_TOO_LARGE, "knots[1]",
          "must be after the knot before by more than 1e-12 of the largest "
          "spacing, and by 1e-50 to 1e+50",
          OCTANT, {PH_F_KNOTS, NUMBERS(0, 1e-13, 1)}),
    FAILS(PH_E_TOO_LARGE, "knots[1]",
          "must be after the knot before by more than 1e-12 of the largest "
          "spacing, and by 1e-50 to 1e+50",
          OCTANT, {PH_F_KNOTS, NUMBERS(0, 1e91, 2e91)}),
    FAILS(PH_E_BAD_VALUE, "tension[2]",
          "must be between 0 and 1e+12, found 2000000000000", OCTANT,
          {PH_F_TENSION, NUMBERS(1, 2, 2e12)}),
    FAILS(PH_E_BAD_SHAPE, "end_tangents",
          "must be two vectors of 3 numbers, found 2 of 2", OCTANT,
          {PH_F_ENDS, WORD("clamped")},
          {PH_F_END_TANGENTS, VECTORS(2, 1, 0, 0, 1)}),
    FAILS(PH_E_ZERO_TANGENT, "end_tangents[1]",
          "must not be at right angles to the sphere at points[2]", OCTANT,
          {PH_F_ENDS, WORD("clamped")},
          {PH_F_END_TANGENTS, VECTORS(3, 0, 1, 0, 1e-14, 0, -7)}),
};

PH_TEST_EACH(test_failure, COUNT(failures)) {
  struct ph_sphere_data data;
  struct ph_diag diag;
  ck_assert_int_eq(read_fields(failures[_i].given, &data, &diag),
                   failures[_i].status);
  ck_assert_int_eq(diag.status, failures[_i].status);
  ck_assert_str_eq(diag.field, failures[_i].field);
  ck_assert_str_eq(diag.message, failures[_i].message);
}

/* ---- points -------------------------------------------------------------- */

PH_TEST(test_open) {
  struct ph_sphere_data d = data_of((struct given[GIVEN_MAX]){OCTANT});
  ck_assert(!d.closed);
  ck_assert_int_eq(d.ends, PH_SPHERE_NATURAL);
  ck_assert_uint_eq(d.n, 3);
  ck_assert_uint_eq(d.m, 2);
  ck_vector(d.p[2], ph_vec3_of(0, 0, 1), 0);
  for (size_t i = 0; i < d.n; i++) {
    ck_abs(ph_vec3_dot(d.p[i], d.e[i]), 0, DBL_EPSILON);
    ck_rel(ph_vec3_abs(d.e[i]), 1, DBL_EPSILON);
    ck_rel(d.nu[i], 0, 0);
    ck_rel(d.knots[i], (double)i * PH_PI / 2, DBL_EPSILON);
  }
  ck_rel(d.theta[0], PH_PI / 2, DBL_EPSILON);
  ck_rel(d.h[1], d.theta[1], 0);
  ck_vector(ph_vec3_of(d.center[0], d.center[1], d.center[2]),
            ph_vec3_of(0, 0, 0), 0);
  ck_rel(d.radius, 1, 0);
  ck_rel(d.moved, 0, 0);
  ck_assert(!d.tell_moved);
}

PH_TEST_EACH(test_closed, 4) {
  const struct given given[][GIVEN_MAX] = {
      {CLOSED, OCTANT, {PH_F_TENSION, NUMBERS(1, 2, 3)}},
      {CLOSED, RING, {PH_F_TENSION, NUMBERS(1, 2, 3)}},
      {CLOSED, RING, {PH_F_TENSION, NUMBERS(1, 2, 3, 1)}},
      {CLOSED,
       {PH_F_LONLAT, VECTORS(2, 180, 0, -90, 0, 55, 90, -180, 0)},
       {PH_F_TENSION, NUMBERS(1, 2, 3, 1)}}};
  struct ph_sphere_data d = data_of(given[_i]);
  ck_assert(d.closed);
  ck_assert_uint_eq(d.n, 3);
  ck_assert_uint_eq(d.m, 3);
  for (size_t i = 0; i < d.n; i++) {
    ck_rel(d.theta[i], PH_PI / 2, DBL_EPSILON);
    ck_rel(d.nu[i], (double)(i + 1), 0);
  }
  ck_rel(d.knots[3], 3 * PH_PI / 2, DBL_EPSILON);
}

/* A repeated last point of open data is a point like others. */
PH_TEST(test_open_ring) {
  struct ph_sphere_data d = data_of((struct given[GIVEN_MAX]){RING});
  ck_assert_uint_eq(d.n, 4);
  ck_assert_uint_eq(d.m, 3);
}

PH_TEST(test_lonlat) {
  const struct given given[GIVEN_MAX] = {
      {PH_F_LONLAT, VECTORS(2, 0, 0, 90, 0, -360, 60, 0, -90)},
      {PH_F_RADIUS, NUMBER(6371)},
      {PH_F_CENTER, NUMBERS(1, 2, 3)}};
  struct ph_sphere_data d = data_of(given);
  ck_vector(d.p[0], ph_vec3_of(1, 0, 0), 0);
  ck_vector(d.p[1], ph_vec3_of(0, 1, 0), 0);
  ck_vector(d.p[2], ph_vec3_of(0.5, 0, sqrt(0.75)), DBL_EPSILON);
  ck_vector(d.p[3], ph_vec3_of(0, 0, -1), 0);
  ck_rel(d.radius, 6371, 0);
  ck_rel(d.center[2], 3, 0);
  ck_rel(d.moved, 0, 0);
}

/* Points of spheres of any size, anywhere; how far off they are is relative to
 * the radius. */
PH_TEST_EACH(test_sphere, 12) {
  static const struct {
    double radius, center;
    double off; /* by this part of the radius the second point is moved */
    double tol;
    bool tell;
  } spheres[] = {
      {1, 0, 0, 1e-15, false},           {1, 0, 1e-13, 1e-15, false},
      {1, 0, 3e-12, 1e-15, true},        {1, 0, -9e-4, 1e-15, true},
      {1e300, 0, 0, 1e-15, false},       {1e300, -1e300, 5e-4, 1e-14, true},
      {1e308, 0, 5e-4, 1e-14, true},     {1e-300, 0, 5e-4, 1e-15, true},
      {1e-300, 1e-299, 0, 1e-14, false}, {5, 1e8, 0, 1e-7, false},
      {5, 1e8, 1e-4, 1e-7, true},        {1e-5, 1e7, 0, 1e-2, false}};
  double radius = spheres[_i].radius, c = spheres[_i].center;
  double s = radius * (1 + spheres[_i].off), tol = spheres[_i].tol;
  double v[9] = {c + 0.6 * radius, c + 0.8 * radius, -c, c - 0.48 * s,
                 c + 0.64 * s,     -c + 0.6 * s,     c,  c,
                 -c - radius};
  double center[3] = {c, c, -c};
  struct given given[GIVEN_MAX] = {
      {PH_F_POINTS, {.kind = PH_VECTORS, .v = v, .n = 3, .dimension = 3}},
      {PH_F_CENTER, {.kind = PH_NUMBERS, .v = center, .n = 3, .dimension = 1}},
      {PH_F_RADIUS, NUMBER(radius)},
      {PH_F_RADIUS_TOLERANCE, NUMBER(tol > 1e-3 ? 0.5 : 1e-3)}};
  struct ph_sphere_data d = data_of(given);
  ck_vector(d.p[0], ph_vec3_of(0.6, 0.8, 0), tol);
  ck_vector(d.p[1], ph_vec3_of(-0.48, 0.64, 0.6), tol);
  ck_vector(d.p[2], ph_vec3_of(0, 0, -1), tol);
  for (size_t i = 0; i < 3; i++) {
    ck_rel(ph_vec3_abs(d.p[i]), 1, DBL_EPSILON);
  }
  ck_rel(d.radius, radius, 0);
  ck_assert_int_eq(d.tell_moved, spheres[_i].tell);
  ck_abs(d.moved, fabs(spheres[_i].off), tol);
  if (spheres[_i].tell) {
    ck_assert_uint_eq(d.moved_at, 1);
  }
}

/* The same sphere, turned, shifted and of another size: the same data. */
PH_TEST_EACH(test_scales, 50) {
  enum { N = 8 };
  struct unit_random r = unit_random_of(3100 + (uint64_t)_i);
  double radius = pow(10, unit_random_in(&r, -200, 200)), v[3 * N], center[3];
  ph_vec3 u[N];
  struct given given[GIVEN_MAX] = {
      {PH_F_POINTS, {.kind = PH_VECTORS, .v = v, .n = N, .dimension = 3}},
      {PH_F_CENTER, {.kind = PH_NUMBERS, .v = center, .n = 3, .dimension = 1}},
      {PH_F_RADIUS, NUMBER(radius)}};
  struct ph_sphere_data d;
  for (size_t j = 0; j < 3; j++) {
    center[j] = radius * unit_random_in(&r, -3, 3);
  }
  for (size_t i = 0; i < N; i++) {
    u[i] = ph_vec3_unit(ph_vec3_of(unit_random_in(&r, -1, 1),
                                   unit_random_in(&r, -1, 1),
                                   unit_random_in(&r, 0.01, 1)));
    ph_vec3_put(u[i], 3, v + 3 * i);
    for (size_t j = 0; j < 3; j++) {
      v[3 * i + j] = center[j] + radius * v[3 * i + j];
    }
  }
  d = data_of(given);
  for (size_t i = 0; i < N; i++) {
    ck_vector(d.p[i], u[i], 4e-15);
  }
  for (size_t k = 0; k + 1 < N; k++) {
    ck_abs(d.theta[k], ph_s2_angle(u[k], u[k + 1]), 8e-15);
  }
  ck_assert(!d.tell_moved);
}

/* ---- knots, tensions, ends ----------------------------------------------- */

PH_TEST(test_knots) {
  const struct given uniform[GIVEN_MAX] = {
      {PH_F_LONLAT, VECTORS(2, 0, 0, 30, 0, 90, 0)},
      {PH_F_KNOTS, WORD("uniform")}};
  const struct given numbers[GIVEN_MAX] = {
      {PH_F_LONLAT, VECTORS(2, 0, 0, 30, 0, 90, 0)},
      {PH_F_KNOTS, NUMBERS(-1, 6, 106)}};
  const struct given period[GIVEN_MAX] = {
      CLOSED, RING, {PH_F_KNOTS, NUMBERS(5, 6, 8, 11)}};
  struct ph_sphere_data d = data_of(uniform);
  ck_rel(d.theta[0], PH_PI / 6, DBL_EPSILON);
  ck_rel(d.h[0], PH_PI / 4, DBL_EPSILON);
  ck_rel(d.h[1], d.h[0], 0);
  ck_rel(d.knots[1], d.h[0], 0);
  ck_rel(d.knots[2], PH_PI / 2, DBL_EPSILON);
  d = data_of(numbers);
  ck_rel(d.h[0], 7, 0);
  ck_rel(d.h[1], 100, 0);
  ck_rel(d.knots[0], -1, 0);
  ck_rel(d.knots[2], 106, 0);
  d = data_of(period);
  ck_rel(d.h[2], 3, 0);
  ck_rel(d.knots[3], 11, 0);
}

/* A number is for the nodes where it has an effect; numbers are kept. */
PH_TEST_EACH(test_tensions, 3) {
  const struct {
    struct given given[GIVEN_MAX];
    double nu[3];
  } cases[] = {{{OCTANT, {PH_F_TENSION, NUMBER(7)}}, {0, 7, 0}},
               {{RING, CLOSED, {PH_F_TENSION, NUMBER(7)}}, {7, 7, 7}},
               {{OCTANT, {PH_F_TENSION, NUMBERS(1, 0, 1e8)}}, {1, 0, 1e8}}};
  struct ph_sphere_data d = data_of(cases[_i].given);
  for (size_t i = 0; i < 3; i++) {
    ck_rel(d.nu[i], cases[_i].nu[i], 0);
  }
}

/* Directions of any length, which say by themselves that the ends are clamped;
 * the speed is theta / h. */
PH_TEST(test_ends) {
  const struct given rest[GIVEN_MAX] = {OCTANT, {PH_F_ENDS, WORD("rest")}};
  const struct given natural[GIVEN_MAX] = {OCTANT,
                                           {PH_F_ENDS, WORD("natural")}};
  const struct given clamped[GIVEN_MAX] = {
      OCTANT,
      {PH_F_ENDS, WORD("clamped")},
      {PH_F_END_TANGENTS, VECTORS(3, 5e300, 0, -1e300, 3e-320, 0, 1e-310)}};
  const struct given knots[GIVEN_MAX] = {
      OCTANT,
      {PH_F_KNOTS, NUMBERS(0, 1, 5)},
      {PH_F_END_TANGENTS, VECTORS(3, 3, 3, 4, 0, -2, 9)}};
  struct ph_sphere_data d = data_of(rest);
  ck_assert_int_eq(d.ends, PH_SPHERE_REST);
  d = data_of(natural);
  ck_assert_int_eq(d.ends, PH_SPHERE_NATURAL);
  d = data_of(clamped);
  ck_assert_int_eq(d.ends, PH_SPHERE_CLAMPED);
  ck_vector(d.end[0], ph_vec3_of(0, 0, -1), DBL_EPSILON);
  ck_vector(d.end[1], ph_vec3_of(1, 0, 0), DBL_EPSILON);
  d = data_of(knots);
  ck_assert_int_eq(d.ends, PH_SPHERE_CLAMPED);
  ck_vector(d.end[0], ph_vec3_scale(PH_PI / 2, ph_vec3_of(0, 0.6, 0.8)), 1e-15);
  ck_vector(d.end[1], ph_vec3_of(0, -PH_PI / 8, 0), 1e-15);
}
