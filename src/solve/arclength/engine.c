/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Iterations of arclength, from a start to a minimum (see engine.h). */
#include "solve/arclength/engine.h"

#include <math.h>
#include <string.h>

/* Newton steps of a start where something else is to be tried after it, which
 * is better at what is far off; and with blocks, where the first leads to a
 * minimum as a rule, of 1000 in 60 to 130. */
enum { STEPS_FIRST = 40, STEPS_LONG = 100 };

/* Whole steps from a curve that crept, whose rows hold to this. */
enum { STEPS_WHOLE = 30 };
static const double CREPT = 1e-4;

/* Steps of an augmented Lagrangian, its last weight and what an inner step may
 * gain of F. */
enum { ROUGH_STEPS = 250, ROUGH_STEPS_BLOCKS = 14 };
static const double RHO_MAX = 1e8, INNER_F = 1e-8;

/* The residuals that it ends with, and what an inner step may gain of the
 * penalty: it brings the curve near a minimum, from where Newton's method needs
 * fewer steps, which cost less.  Five free walks of 500 take 36 and 84 in mean;
 * with .1 53 and 59, with 1 12 and 119; with 1e-2 18, with 1e-4 43. */
static const double ROUGH = 0.3, CREEPS = 1e-3;
/* The same before blocks.  What is not near a minimum after so many steps is
 * left to places: of 12 free walks of 1000 F is the same in the mean (+.06 %,
 * with 11 steps .4 % higher), and 30 steps do what took 36. */
static const double ROUGH_BLOCKS = 0.1, CREEPS_BLOCKS = 0.03;

/* Rows that miss no more where no step was taken are those of data whose chords
 * turn little, from where Newton's method needs no help: of smooth curves of
 * 100 to 1000 intervals they miss .002 to .04, of random walks 1.3 to 1.8. */
static const double SMOOTH = 0.1;

bool ph_arc_engine_of(const struct ph_arc_system *s, struct ph_arena *arena,
                      struct ph_arc_engine *e) {
  *e = (struct ph_arc_engine){.s = s, .arena = arena};
  return ph_arc_newton_alloc(s, arena, &e->work) &&
         ph_arc_point_alloc(s, arena, &e->point) &&
         ph_arc_point_alloc(s, arena, &e->crept);
}

/* Whitened rows and an augmented Lagrangian, where they are needed. */
static bool need_rough(struct ph_arc_engine *e) {
  if (e->rough_y) {
    return true;
  }
  e->white = *e->s;
  e->rough_y = ph_arena_array(e->arena, e->s->y_n, sizeof *e->rough_y);
  return e->rough_y && ph_arc_whiten(&e->white, e->arena) &&
         ph_arc_work_alloc(e->s, e->arena, &e->rough);
}

/* Where the search creeps along a valley there may be a minimum at its end,
 * beyond what each single step may lose; another start, where there is one,
 * leads as a rule to a lower one. */
static void leave_valley(struct ph_arc_engine *e) {
  struct ph_arc_point *p = &e->point;
  if (!e->last || p->converged || !(p->residual <= CREPT)) {
    return;
  }
  ph_arc_point_copy(e->s, p, &e->crept);
  ph_arc_newton_plain(e->s, &e->work, STEPS_WHOLE, p);
  if (!(p->minimiser || (p->converged && e->saddles))) {
    ph_arc_point_copy(e->s, &e->crept, p);
  }
}

/* An augmented Lagrangian with this rho from e->point, for which there is
 * memory. */
static void penalise(struct ph_arc_engine *e, double rho) {
  struct ph_arc_point *p = &e->point;
  bool blocks = e->work.blocks.n > 0;
  struct ph_arc_penalty_options options = {
      .rho = rho,
      .rho_max = RHO_MAX,
      .tolerance = blocks ? ROUGH_BLOCKS : ROUGH,
      .inner = INNER_F,
      .iterations = blocks ? ROUGH_STEPS_BLOCKS : ROUGH_STEPS,
      .creeps = blocks ? CREEPS_BLOCKS : CREEPS};
  struct ph_arc_penalty_report report;
  ph_arc_whitened(&e->white, p->y, e->rough_y);
  ph_arc_penalty(&e->white, &options, &e->rough, p->x, e->rough_y, &report);
  p->iterations += report.iterations;
  ph_arc_plain(&e->white, e->rough_y, p->y);
}

bool ph_arc_engine_iterate(struct ph_arc_engine *e, double rho, size_t steps) {
  struct ph_arc_point *p = &e->point;
  p->iterations = 0;
  p->converged = p->minimiser = false;
  memset(p->y, 0, e->s->y_n * sizeof *p->y);
  ph_arc_blocks_begin(&e->work.blocks);
  if (rho > 0) {
    if (!need_rough(e)) {
      return false;
    }
    penalise(e, rho);
  }
  ph_arc_newton_solve(e->s, &e->work, steps, p);
  leave_valley(e);
  return !e->work.starved;
}

bool ph_arc_engine_is_smooth(const struct ph_arc_engine *e, const double *x) {
  double *c = e->work.c;
  bool smooth = true;
  ph_arc_residual(e->s, x, c);
  for (size_t r = 0; r < e->s->y_n && smooth; r++) {
    smooth = fabs(c[r]) <= SMOOTH;
  }
  return smooth;
}

size_t ph_arc_engine_first_steps(const struct ph_arc_engine *e) {
  return e->work.blocks.n > 0 ? STEPS_LONG : STEPS_FIRST;
}

bool ph_arc_engine_go_on(struct ph_arc_engine *e) {
  struct ph_arc_point *p = &e->point;
  if (!p->converged && p->residual <= PH_ARC_NEAR) {
    ph_arc_newton_solve(e->s, &e->work,
                        PH_ARC_STEPS - ph_arc_engine_first_steps(e), p);
  }
  return !e->work.starved;
}
