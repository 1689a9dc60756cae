/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Points that are joined to their neighbours: which, and what becomes of what
 * is given at them and between them. */
#include "unit.h"

#include "fields_unit.h"
#include "problem_unit.h"

#include "curve/merge.h"
#include "kernel/pi.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define MERGE(d) \
  { PH_F_MERGE, NUMBER(d) }
#define POINTS(...) \
  { PH_F_POINTS, VECTORS(2, __VA_ARGS__) }

/* What was joined, of a method, and why it was not. */
static struct ph_problem problem;
static struct ph_merge merge;
static struct ph_diag diag;

static enum ph_status joined(const struct ph_method *method,
                             const struct given given[GIVEN_MAX]) {
  problem = unit_problem_of(given);
  return ph_merge(&method->schema, &unit_arena, &problem, &merge, &diag);
}

#define JOIN(method, ...) \
  joined(&ph_method_##method, (struct given[GIVEN_MAX]){__VA_ARGS__})

/* A function, so that the literals live as long as the test. */
static void is_ok(enum ph_status status) {
  ck_assert_int_eq(status, PH_OK);
}

#define JOINED(method, ...) is_ok(JOIN(method, __VA_ARGS__))

/* The numbers of a field, as a text. */
static const char *text_of(enum ph_field_id id) {
  static char text[200];
  const struct ph_value *v = &problem.field[id];
  size_t n = 0;
  *text = '\0';
  for (size_t i = 0; i < v->n * v->dimension; i++) {
    n += (size_t)snprintf(text + n, sizeof text - n, "%s%g", i > 0 ? " " : "",
                          v->v[i]);
  }
  return text;
}

static const char *gone(void) {
  static char text[200];
  size_t n = 0;
  *text = '\0';
  for (size_t i = 0; i < merge.gone_n; i++) {
    n += (size_t)snprintf(text + n, sizeof text - n, "%s%zu", i > 0 ? " " : "",
                          merge.gone[i]);
  }
  return text;
}

PH_TEST(test_which) {
  /* none, and exactly at the distance */
  JOINED(planar, POINTS(0, 0, 1, 0, 3, 0));
  ck_assert_uint_eq(problem.field[PH_F_POINTS].n, 3);
  JOINED(planar, MERGE(1), POINTS(0, 0, 1, 0, 3, 0));
  ck_assert_str_eq(text_of(PH_F_POINTS), "0 0 1 0 3 0");
  ck_assert_uint_eq(merge.gone_n, 0);
  /* equal ones, however small the distance */
  JOINED(planar, MERGE(1e-300), POINTS(0, 0, 1, 0, 1, 0, 1, 0, 3, 0));
  ck_assert_str_eq(text_of(PH_F_POINTS), "0 0 1 0 3 0");
  ck_assert_str_eq(gone(), "2 3");
  /* of a chain each with the last that stays */
  JOINED(planar, MERGE(1), POINTS(0, 0, 0.6, 0, 1.2, 0, 1.8, 0, 5, 0));
  ck_assert_str_eq(text_of(PH_F_POINTS), "0 0 1.2 0 5 0");
  ck_assert_str_eq(gone(), "1 3");
  /* the last point stays, and so does the first */
  JOINED(planar, MERGE(1), POINTS(0, 0, 2, 0, 4, 0, 4.5, 0));
  ck_assert_str_eq(text_of(PH_F_POINTS), "0 0 2 0 4.5 0");
  ck_assert_str_eq(gone(), "2");
  JOINED(planar, MERGE(1), POINTS(0, 0, 2, 0, 3, 0, 3.6, 0, 2.4, 0));
  ck_assert_str_eq(text_of(PH_F_POINTS), "0 0 2.4 0");
  ck_assert_str_eq(gone(), "1 2 3");
  JOINED(planar, MERGE(1), POINTS(0, 0, 1.2, 0, 0.6, 0));
  ck_assert_str_eq(text_of(PH_F_POINTS), "0 0");
  ck_assert_str_eq(gone(), "1 2");
  /* ends of open data may meet */
  JOINED(planar, MERGE(1), POINTS(0, 0, 2, 0, 2, 2, 0, 0));
  ck_assert_uint_eq(merge.gone_n, 0);
}

PH_TEST(test_closed) {
  JOINED(planar, CLOSED, MERGE(1), POINTS(0, 0, 2, 0, 2, 2, 0.5, 0.5));
  ck_assert_str_eq(text_of(PH_F_POINTS), "0 0 2 0 2 2");
  ck_assert_str_eq(gone(), "3");
  JOINED(planar, CLOSED, MERGE(1),
         POINTS(0, 0, 2, 0, 2, 2, 0, 0.9, 0, 0.2, 0, 0));
  ck_assert_str_eq(text_of(PH_F_POINTS), "0 0 2 0 2 2");
  ck_assert_str_eq(gone(), "3 4"); /* the repeated one is expected */
  JOINED(planar, CLOSED, MERGE(1), POINTS(0, 0, 2, 0, 2, 2, 0, 0));
  ck_assert_str_eq(text_of(PH_F_POINTS), "0 0 2 0 2 2");
  ck_assert_uint_eq(merge.gone_n, 0);
  JOINED(planar, CLOSED, MERGE(9), POINTS(0, 0, 2, 0, 2, 2));
  ck_assert_str_eq(text_of(PH_F_POINTS), "0 0");
}

PH_TEST(test_scales) {
  JOINED(planar, MERGE(1e300), POINTS(-1.7e308, 0, 1.7e308, 0, 1.7e308, 1e299));
  ck_assert_str_eq(gone(), "1");
  JOINED(planar, MERGE(1e-310), POINTS(0, 0, 5e-311, 0, 1e-309, 0));
  ck_assert_str_eq(gone(), "1");
}

/* Great circles, in the unit of the radius; the centre has no direction. */
PH_TEST(test_sphere) {
  const double earth = 6371000, degree = earth * PH_PI / 180;
  JOINED(sphere, MERGE(degree * 1.001), {PH_F_RADIUS, NUMBER(earth)},
         {PH_F_LONLAT, VECTORS(2, 0, 0, 1, 0, 3, 0, 179.5, 0, -179.9, 0)});
  ck_assert_str_eq(text_of(PH_F_LONLAT), "0 0 3 0 -179.9 0");
  ck_assert_str_eq(gone(), "1 3");
  JOINED(sphere, MERGE(degree * 0.999), {PH_F_RADIUS, NUMBER(earth)},
         {PH_F_LONLAT, VECTORS(2, 0, 0, 1, 0, 3, 0)});
  ck_assert_uint_eq(merge.gone_n, 0);
  JOINED(sphere, MERGE(0.02), {PH_F_CENTER, NUMBERS(5, 0, 0)},
         {PH_F_POINTS, VECTORS(3, 6, 0, 0, 6, 0.01, 0, 5, 0, 0, 5, 1, 0)});
  ck_assert_str_eq(gone(), "1");
}

PH_TEST(test_data_of_points) {
  /* those of the point that stays; knots with its own, the last one closes */
  JOINED(spatial_hermite, MERGE(1), POINTS(0, 0, 0.5, 0, 2, 0, 2.5, 0),
         {PH_F_TANGENTS, VECTORS(2, 9, 0, 1, 0.09, 0, 1, 0, 7)},
         {PH_F_KNOTS, NUMBERS(0, 1, 2, 3)});
  ck_assert_str_eq(text_of(PH_F_TANGENTS), "9 0 0 7");
  ck_assert_str_eq(text_of(PH_F_KNOTS), "0 3");
  JOINED(planar, CLOSED, MERGE(1), POINTS(0, 0, 2, 0, 2.1, 0, 2, 2, 0, 0.1),
         {PH_F_KNOTS, NUMBERS(0, 1, 2, 3, 4, 7)});
  ck_assert_str_eq(text_of(PH_F_KNOTS), "0 1 3 7");
  JOINED(sphere, MERGE(0.1), {PH_F_TENSION, NUMBERS(1, 2, 2.1, 3)},
         {PH_F_LONLAT, VECTORS(2, 0, 0, 30, 0, 31, 0, 60, 0)});
  ck_assert_str_eq(text_of(PH_F_TENSION), "1 2 3");
}

PH_TEST(test_data_of_intervals) {
  JOINED(arclength, MERGE(1), POINTS(0, 0, 2, 0, 2.5, 0, 5, 0, 7, 0, 7.1, 0),
         {PH_F_LENGTHS, NUMBERS(3, 0.5, 4, 5, 0.25)});
  ck_assert_str_eq(text_of(PH_F_LENGTHS), "3 4.5 5.25");
  JOINED(arclength, CLOSED, MERGE(1), POINTS(0, 0, 2, 0, 2, 2, 0.1, 0),
         {PH_F_LENGTHS, NUMBERS(3, 4, 5, 0.25)});
  ck_assert_str_eq(text_of(PH_F_LENGTHS), "3 4 5.25");
  /* the last point repeats the first, if not to the digit */
  JOINED(arclength, CLOSED, MERGE(1), POINTS(0, 0, 2, 0, 2, 2, 0.1, 0),
         {PH_F_LENGTHS, NUMBERS(3, 4, 5)});
  ck_assert_str_eq(text_of(PH_F_LENGTHS), "3 4 5");
  JOINED(spatial_hermite, MERGE(1), POINTS(0, 0, 2, 0, 2.5, 0, 5, 0, 5.1, 0),
         {PH_F_ALPHA, NUMBERS(1, 2, 3, 4)},
         {PH_F_ANGLES, VECTORS(2, 1, 1, 2, 2, 3, 3, 4, 4)});
  ck_assert_str_eq(text_of(PH_F_ALPHA), "1 3");
  ck_assert_str_eq(text_of(PH_F_ANGLES), "1 1 3 3");
  /* what is for all intervals stays */
  JOINED(spatial_hermite, MERGE(1), POINTS(0, 0, 2, 0, 2.5, 0, 5, 0),
         {PH_F_ALPHA, NUMBER(1)}, {PH_F_ANGLES, NUMBERS(1, 2)});
  ck_assert_str_eq(text_of(PH_F_ANGLES), "1 2");
  JOINED(spatial_hermite, MERGE(1), POINTS(0, 0, 2, 0, 2.5, 0, 5, 0),
         {PH_F_ANGLES, VECTORS(2, 1, 2)});
  ck_assert_str_eq(text_of(PH_F_ANGLES), "1 2");
}

/* The arrays that were given stay as they are: a sweep reads them again. */
PH_TEST(test_input_is_kept) {
  double v[] = {0, 0, 2, 0, 2.5, 0, 5, 0}, lengths[] = {3, 1, 4};
  struct given given[GIVEN_MAX] = {
      MERGE(1),
      {PH_F_POINTS, {.kind = PH_VECTORS, .v = v, .n = 4, .dimension = 2}},
      {PH_F_LENGTHS,
       {.kind = PH_NUMBERS, .v = lengths, .n = 3, .dimension = 1}}};
  ck_assert_int_eq(joined(&ph_method_arclength, given), PH_OK);
  ck_assert_str_eq(text_of(PH_F_LENGTHS), "3 5");
  ck_abs(v[4], 2.5, 0);
  ck_abs(lengths[1], 1, 0);
}

static void refused(enum ph_status found, enum ph_status status,
                    const char *field, const char *message) {
  ck_assert_int_eq(found, status);
  ck_assert_str_eq(diag.field, field);
  ck_assert_str_eq(diag.message, message);
  ck_assert_ptr_null(merge.schema);
}

PH_TEST(test_refused) {
  refused(JOIN(planar, MERGE(0), POINTS(0, 0, 1, 1)), PH_E_BAD_VALUE, "merge",
          "must be greater than 0, found 0");
  refused(JOIN(planar, MERGE(-1), POINTS(0, 0, 1, 1)), PH_E_BAD_VALUE, "merge",
          "must be greater than 0, found -1");
  refused(JOIN(planar, MERGE((double)NAN), POINTS(0, 0, 1, 1)), PH_E_BAD_VALUE,
          "merge", "must be greater than 0, found nan");
  refused(JOIN(arclength, MERGE(1), {PH_F_TANGENTS, VECTORS(2, 1, 0, 0, 1)}),
          PH_E_BAD_VALUE, "merge", "is for points");
  refused(JOIN(tc, MERGE(1), POINTS(0, 0, 2, 0, 2, 0, 4, 0),
               {PH_F_TANGENTS, VECTORS(2, 1, 0, 1, 0, 1, 0.2, 1, 0)}),
          PH_E_BAD_VALUE, "tangents[2]",
          "differs from tangents[1] by more than a tenth, but merge joins "
          "points[2] to points[1]");
  refused(JOIN(tc, MERGE(1), POINTS(0, 0, 2, 0, 4, 0, 4, 0),
               {PH_F_DERIVATIVES, VECTORS(2, 1, 0, 1, 0, 2, 0, 1, 0)}),
          PH_E_BAD_VALUE, "derivatives[2]",
          "differs from derivatives[3] by more than a tenth, but merge joins "
          "points[2] to points[3]");
  refused(JOIN(sphere, MERGE(0.1), {PH_F_TENSION, NUMBERS(1, 0, 2)},
               {PH_F_LONLAT, VECTORS(2, 0, 0, 1, 0, 60, 0)}),
          PH_E_BAD_VALUE, "tension[1]",
          "differs from tension[0] by more than a tenth, but merge joins "
          "lonlat[1] to lonlat[0]");
  refused(JOIN(arclength, MERGE(1), POINTS(0, 0, 2, 0, 2, 0, 4, 0),
               {PH_F_LENGTHS, NUMBERS(1, 2)}),
          PH_E_BAD_SHAPE, "lengths",
          "must have 3 elements, one for each interval, before merge joins "
          "points, found 2");
  refused(JOIN(planar, MERGE(1), POINTS(0, 0, 2, 0, 2, 0, 4, 0),
               {PH_F_KNOTS, NUMBERS(0, 1, 2)}),
          PH_E_BAD_SHAPE, "knots",
          "must have 4 elements, one for each point, before merge joins "
          "points, found 3");
}
