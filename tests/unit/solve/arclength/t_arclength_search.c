/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Searches for minima of arclength that find none: what one of them knows, the
 * next need not find again.
 */
#include "unit.h"

#include "solve/arclength/arclength.h"

enum { N = 3 };

/* Three chords of length 1, one to be two thousand long: no start leads to a
 * curve. */
static double spacing[N] = {1, 1, 1}, length[N] = {1, 2000, 1};
static double chord[N] = {1, 1, 1};
static ph_vec3 step[N] = {{1, 0, 0}, {0.8, 0.6, 0}, {0, 0.6, 0.8}};

static const struct ph_arc_data data = {.mode = PH_ARC_POINTS,
                                        .n = N,
                                        .h = spacing,
                                        .length = length,
                                        .chord = chord,
                                        .step = step};

/* The same outcome of the same starts. */
static void ck_same(const struct ph_arc_search *a,
                    const struct ph_arc_search *b) {
  size_t x_n = a->system.x_n;
  ck_assert_uint_eq(a->starts_n, b->starts_n);
  for (size_t i = 0; i < a->starts_n; i++) {
    ck_assert_str_eq(a->starts[i].name, b->starts[i].name);
    ck_assert_int_eq(a->starts[i].outcome, b->starts[i].outcome);
    ck_assert_uint_eq(a->starts[i].iterations, b->starts[i].iterations);
  }
  ck_assert_uint_eq(b->found_n, 0);
  ck_assert_mem_eq(a->nearest.x, b->nearest.x, x_n * sizeof(double));
}

PH_TEST(test_natural_again) {
  struct ph_arc_request request = {
      .data = &data, .refine = 2, .dim = 4, .rescue = true, .waves = true};
  struct ph_arc_search first, again;
  struct ph_arc_natural natural;
  ck_assert(ph_arc_search_run(&request, &unit_arena, &first));
  ck_assert_uint_eq(first.found_n, 0);
  ck_assert_uint_gt(first.natural.steps, 0);
  ck_assert(ph_arc_natural_copy(&first.natural, N, first.system.x_n,
                                &unit_arena, &natural));
  request.natural = &natural;
  ck_assert(ph_arc_search_run(&request, &unit_arena, &again));
  ck_assert_uint_eq(again.natural.steps, 0);
  ck_same(&first, &again);
}
