/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Data of Tschirnhausen cubics for the tests, from lists of fields. */
#ifndef PH_TESTS_TC_DATA_UNIT_H
#define PH_TESTS_TC_DATA_UNIT_H

#include "fields_unit.h"
#include "unit.h"

#include "solve/tc/tc.h"

/* What becomes of a problem: its mode, then its data. */
static inline enum ph_status unit_tc_read(const struct given given[GIVEN_MAX],
                                          struct ph_tc_data *data,
                                          struct ph_diag *diag) {
  const struct ph_problem problem = unit_problem_of(given);
  enum ph_tc_mode mode;
  enum ph_status status = ph_tc_mode_of(&problem, &mode, diag);
  return status == PH_OK && mode != PH_TC_APPROXIMATE
             ? ph_tc_data_of(&problem, mode, &unit_arena, data, diag)
             : status;
}

/* Reads what must be right. */
static inline struct ph_tc_data
unit_tc_given(const struct given given[GIVEN_MAX]) {
  struct ph_tc_data data;
  struct ph_diag diag;
  enum ph_status status = unit_tc_read(given, &data, &diag);
  ck_assert_msg(status == PH_OK, "%s: %s", diag.field, diag.message);
  return data;
}

#endif
