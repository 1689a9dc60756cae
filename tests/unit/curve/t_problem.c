/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The names of problem fields, and which of them a schema has. */
#include "unit.h"

#include "curve/problem.h"

static const struct ph_field rows[] = {
    {PH_F_KNOTS, PH_NUMBERS, 0, false, NULL, "", ""},
    {PH_F_POINTS, PH_VECTORS, 1u << 2, true, NULL, NULL, ""},
};
static const struct ph_schema schema = {"some", rows, 2};
/* Names that begin alike. */
static const struct ph_field alike_rows[] = {
    {PH_F_STARTS, PH_NUMBER, 0, false, NULL, "0", ""},
    {PH_F_PLANARITY, PH_NUMBER, 0, false, NULL, "", ""},
    {PH_F_LENGTH_SIGMA, PH_NUMBER, 0, false, NULL, "", ""},
    {PH_F_START, PH_NUMBERS, 0, false, NULL, "", ""},
    {PH_F_PLANAR, PH_WORD, 0, false, "keep|free", "", ""},
    {PH_F_LENGTHS, PH_NUMBERS | PH_SEGMENTS, 0, false, NULL, "", ""},
};
static const struct ph_schema alike = {"alike", alike_rows, 6};

PH_TEST(test_names) {
  ck_assert_str_eq(ph_field_name(PH_F_POINTS), "points");
  ck_assert_str_eq(ph_field_name(PH_F_END_DERIVATIVES), "end_derivatives");
  ck_assert_str_eq(ph_field_name(PH_F_LENGTHS), "lengths");
  ck_assert_str_eq(ph_field_name(PH_F_LENGTH_SIGMA), "length_sigma");
  for (int i = 0; i < PH_FIELD_N; i++) {
    for (int j = 0; j < i; j++) {
      ck_assert_str_ne(ph_field_name((enum ph_field_id)i),
                       ph_field_name((enum ph_field_id)j));
    }
  }
}

PH_TEST(test_find) {
  ck_assert_ptr_eq(ph_field_find(&schema, "knots", 5), &rows[0]);
  ck_assert_ptr_eq(ph_field_find(&schema, "points", 6), &rows[1]);
  ck_assert_ptr_eq(ph_field_find(&schema, "points[3]", 6), &rows[1]);
  ck_assert_ptr_null(ph_field_find(&schema, "points", 5));
  ck_assert_ptr_null(ph_field_find(&schema, "pointss", 7));
  ck_assert_ptr_null(ph_field_find(&schema, "Points", 6));
  ck_assert_ptr_null(ph_field_find(&schema, "", 0));
  ck_assert_ptr_null(ph_field_find(&schema, "closed", 6)); /* not in it */
}

PH_TEST(test_alike) {
  static const char *const names[] = {"starts", "planarity", "length_sigma",
                                      "start",  "planar",    "lengths"};
  for (size_t i = 0; i < 6; i++) {
    ck_assert_ptr_eq(ph_field_find(&alike, names[i], strlen(names[i])),
                     &alike_rows[i]);
  }
  ck_assert_ptr_null(ph_field_find(&alike, "length", 6));
}
