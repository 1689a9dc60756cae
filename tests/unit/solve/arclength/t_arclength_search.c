/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Searches for minima of arclength: what one that finds none knows, the next
 * need not find again; and steps to the natural curve of many intervals.
 */
#include "unit.h"

#include "solve/arclength/arclength.h"

#include <math.h>

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

enum { LONG = 500 };

/* A random walk with measured lengths, of which the natural curve is as that of
 * free ones: its worst place does not slow all others. */
PH_TEST(test_natural_long) {
  static double h[LONG], lengths[LONG], chords[LONG];
  static ph_vec3 steps[LONG];
  const struct ph_arc_data walk = {.mode = PH_ARC_POINTS,
                                   .n = LONG,
                                   .h = h,
                                   .length = lengths,
                                   .sigma = 0.1,
                                   .chord = chords,
                                   .step = steps};
  const struct ph_arc_request request = {
      .data = &walk, .refine = 2, .dim = 4, .rescue = true, .waves = true};
  struct ph_arc_search search;
  struct unit_random r = unit_random_of(1);
  for (size_t i = 0; i < LONG; i++) {
    steps[i] = (ph_vec3){unit_random_in(&r, -1, 1), unit_random_in(&r, -1, 1),
                         unit_random_in(&r, -1, 1)};
    h[i] = chords[i] = sqrt(ph_vec3_dot(steps[i], steps[i]));
    lengths[i] = chords[i] * unit_random_in(&r, 1.2, 1.6);
  }
  ck_assert(ph_arc_search_run(&request, &unit_arena, &search));
  ck_assert_uint_eq(search.found_n, 1);
  ck_assert_uint_lt(search.natural.steps, 80);
}
