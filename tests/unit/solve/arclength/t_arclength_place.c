/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Parts of the equations of arclength, and places of a curve that are solved
 * alone: what they leave as it is, and that a long curve takes no more steps.
 */
#include "unit.h"

#include "solve/arclength/arclength.h"

#include <math.h>

enum { N = 80, FIRST = 30, COUNT = 20, LATE = 100 };

/* A curve of N random steps. */
struct walk {
  struct ph_arc_data data;
  struct ph_arc_system system;
  struct ph_arc_point point;
  double h[N], length[N], chord[N];
  ph_vec3 step[N];
};

static void set_up(struct walk *t, bool closed, size_t refine, double lengths) {
  struct unit_random r = unit_random_of(1 + refine);
  struct ph_arc_data *d = &t->data;
  *d = (struct ph_arc_data){.mode = PH_ARC_POINTS,
                            .closed = closed,
                            .n = N,
                            .h = t->h,
                            .length = lengths > 0 ? t->length : NULL,
                            .chord = t->chord,
                            .step = t->step};
  ph_vec3 sum = {0};
  for (size_t i = 0; i < N; i++) {
    t->step[i] = (ph_vec3){unit_random_in(&r, -1, 1), unit_random_in(&r, -1, 1),
                           unit_random_in(&r, -1, 1)};
    sum = ph_vec3_add(sum, t->step[i]);
  }
  for (size_t i = 0; i < N; i++) {
    if (closed) {
      t->step[i] = ph_vec3_sub(t->step[i], ph_vec3_scale(1. / N, sum));
    }
    t->chord[i] = t->h[i] = ph_vec3_abs(t->step[i]);
    t->length[i] = lengths * t->chord[i];
  }
  ck_assert(ph_arc_system_of(d, refine, 4, true, &unit_arena, &t->system));
  ck_assert(t->system.phases);
  ck_assert(ph_arc_point_alloc(&t->system, &unit_arena, &t->point));
  for (size_t k = 0; k < t->system.x_n; k++) {
    t->point.x[k] = unit_random_in(&r, -1, 1);
  }
  for (size_t k = 0; k < t->system.y_n; k++) {
    t->point.y[k] = unit_random_in(&r, -1, 1);
  }
}

/* A change of the whole that is one of a part: its inner nodes change, and what
 * is on its right turns. */
static void set_change(const struct walk *t, const struct ph_arc_system *part,
                       double *all, double *own) {
  const struct ph_arc_system *s = &t->system;
  struct unit_random r = unit_random_of(7);
  size_t at = FIRST * s->refine, last = at + part->nodes - 1;
  memset(all, 0, s->x_n * sizeof *all);
  for (size_t j = at + 2; j < s->nodes; j++) {
    ph_arc_turned(t->point.x + 4 * j, all + 4 * j);
    for (size_t k = 0; j + 2 <= last && k < 4; k++) {
      all[4 * j + k] = unit_random_in(&r, -1, 1);
    }
  }
  if (s->turn) {
    all[s->x_n - 1] = 1;
  }
  memcpy(own, all + 4 * at, part->x_n * sizeof *own);
}

/* Closed or not, refine. */
static const struct {
  bool closed;
  size_t refine;
} kinds[] = {{false, 1}, {false, 2}, {true, 1}, {true, 2}, {false, 3}};
enum { KINDS = sizeof kinds / sizeof kinds[0] };

/* The Lagrangian of a part, and its rows, change as those of the whole. */
PH_TEST_EACH(test_part, KINDS) {
  struct walk t;
  struct ph_arc_system part;
  struct ph_arc_data data;
  struct ph_arc_linear whole, own;
  double *all, *change;
  set_up(&t, kinds[_i].closed, kinds[_i].refine, 1.4);
  ck_assert(ph_arc_part_of(&t.system, FIRST, COUNT, &unit_arena, &data, &part));
  ck_assert(ph_arc_linear_alloc(&t.system, &unit_arena, &whole));
  ck_assert(ph_arc_linear_alloc(&part, &unit_arena, &own));
  all = ph_arena_array(&unit_arena, t.system.x_n, sizeof *all);
  change = ph_arena_array(&unit_arena, part.x_n, sizeof *change);
  ck_assert(all && change);
  set_change(&t, &part, all, change);
  ph_arc_linearise(&t.system, t.point.x, t.point.y, &whole);
  ph_arc_linearise(&part, t.point.x + 4 * FIRST * part.refine,
                   t.point.y + FIRST * part.forms_n, &own);
  for (size_t r = 0; r < part.y_n; r++) {
    ck_abs(own.c[r], whole.c[FIRST * part.forms_n + r], 0);
  }
  ph_arc_ends_gradient(&part, t.point.x + 4 * FIRST * part.refine, own.l_x);
  ck_rel(ph_arc_dot(part.x_n, own.l_x, change),
         ph_arc_dot(t.system.x_n, whole.l_x, all), 1e-10);
}

/* One node of a solved curve is moved: its place is solved again, and all that
 * is beside it is as it was. */
PH_TEST_EACH(test_place, KINDS) {
  struct walk t;
  struct ph_arc_newton work;
  double lengths[N], before[N], *c;
  size_t moved;
  set_up(&t, kinds[_i].closed, kinds[_i].refine,
         kinds[_i].refine > 1 ? 1.4 : 0);
  ck_assert(ph_arc_newton_alloc(&t.system, &unit_arena, &work));
  ck_assert(ph_arc_start(&t.system, &unit_arena, t.point.x));
  memset(t.point.y, 0, t.system.y_n * sizeof *t.point.y);
  t.point.iterations = 0;
  ph_arc_blocks_begin(&work.blocks);
  ck_assert(ph_arc_newton_solve(&t.system, &work, 300, &t.point));
  ph_arc_lengths(&t.system, t.point.x, before);
  memset(work.dx, 0, t.system.x_n * sizeof *work.dx);
  ph_arc_blocks_begin(&work.blocks);
  work.times = 0;
  moved = 4 * (FIRST * t.system.refine + 1);
  t.point.x[moved] += work.dx[moved] = 0.2;
  t.point.iterations = 0;
  ck_assert(ph_arc_places(&t.system, &work, 1, LATE, &t.point));
  ck_assert_uint_gt(t.point.iterations, 0);
  ck_assert_uint_lt(t.point.iterations, 5);
  c = work.c;
  ph_arc_residual(&t.system, t.point.x, c);
  ck_abs(ph_arc_largest(t.system.y_n, c), 0, 2e-6);
  ph_arc_lengths(&t.system, t.point.x, lengths);
  for (size_t i = 0; i < N; i++) {
    bool near = i + 12 > FIRST && i < FIRST + 12;
    ck_rel(lengths[i], before[i], near ? 1e-5 : 1e-12);
  }
}

/* Nothing is done where nothing moved, nor where rows leave no choice. */
PH_TEST(test_no_place) {
  for (size_t k = 0; k < 2; k++) {
    struct walk t;
    struct ph_arc_newton work;
    double *x;
    set_up(&t, false, k > 0 ? 1 : 2, 1.4);
    ck_assert(ph_arc_newton_alloc(&t.system, &unit_arena, &work));
    x = ph_arena_array(&unit_arena, t.system.x_n, sizeof *x);
    ck_assert_ptr_nonnull(x);
    memcpy(x, t.point.x, t.system.x_n * sizeof *x);
    for (size_t i = 0; i < t.system.x_n; i++) {
      work.dx[i] = k > 0 ? 1 : 1e-3;
    }
    ph_arc_blocks_begin(&work.blocks);
    work.times = 0;
    t.point.iterations = 0;
    ck_assert(ph_arc_places(&t.system, &work, 1, LATE, &t.point));
    ck_assert_uint_eq(t.point.iterations, 0);
    ck_assert_mem_eq(x, t.point.x, t.system.x_n * sizeof *x);
  }
}
