/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Problems written down as lists of fields, for tests of what reads them. */
#ifndef PH_TESTS_FIELDS_UNIT_H
#define PH_TESTS_FIELDS_UNIT_H

#include "curve/problem.h"

#include <string.h>

enum { GIVEN_MAX = 5 };

/* A field that is given; the list ends with one of kind PH_ABSENT. */
struct given {
  enum ph_field_id id;
  struct ph_value value;
};

#define GIVEN_N(...) (sizeof((double[]){__VA_ARGS__}) / sizeof(double))
#define VECTORS(size, ...)                                  \
  {                                                         \
    .kind = PH_VECTORS, .v = (double[]){__VA_ARGS__},       \
    .n = GIVEN_N(__VA_ARGS__) / (size), .dimension = (size) \
  }
#define NUMBERS(...)                                  \
  {                                                   \
    .kind = PH_NUMBERS, .v = (double[]){__VA_ARGS__}, \
    .n = GIVEN_N(__VA_ARGS__), .dimension = 1         \
  }
#define NUMBER(x) \
  { .kind = PH_NUMBER, .number = (x) }
#define WORD(x) \
  { .kind = PH_WORD, .word = (x) }
#define TRUE_FLAG \
  { .kind = PH_BOOL, .flag = true }
#define CLOSED \
  { PH_F_CLOSED, TRUE_FLAG }

/* The problem of these fields; it holds their arrays. */
static inline struct ph_problem
unit_problem_of(const struct given given[GIVEN_MAX]) {
  struct ph_problem problem;

  memset(&problem, 0, sizeof problem);
  for (size_t i = 0; i < GIVEN_MAX && given[i].value.kind != PH_ABSENT; i++) {
    problem.field[given[i].id] = given[i].value;
  }
  return problem;
}

#endif
