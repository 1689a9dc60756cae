/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What leads a start of arclength to a minimum (see arclength.h). */
#ifndef PH_SOLVE_ARCLENGTH_ENGINE_H
#define PH_SOLVE_ARCLENGTH_ENGINE_H

#include "solve/arclength/arclength.h"
#include "solve/arclength/system.h"

/* Newton steps of a start that is near or the last resort, and after an
 * augmented Lagrangian, or where nothing else is. */
enum { PH_ARC_STEPS = 150, PH_ARC_STEPS_AFTER = 300 };

/* Residuals of a curve that is good enough to begin with, or to go on from:
 * with 1e-4 one of five cables of 500 needs another start, with 1e-2 none is
 * better. */
#define PH_ARC_NEAR 1e-3

/* What solves a system. */
struct ph_arc_engine {
  const struct ph_arc_system *s;
  struct ph_arena *arena;
  struct ph_arc_newton work;
  struct ph_arc_point point;  /* of the current start */
  struct ph_arc_point crept;  /* where it ended, before whole steps */
  bool last;                  /* nothing is tried after its starts */
  bool saddles;               /* what is stationary will do */
  struct ph_arc_system white; /* the same equations, rows whitened */
  struct ph_arc_work rough;   /* for what comes before Newton's method */
  double *rough_y;            /* [y_n] of the whitened rows; NULL: not yet */
};

/* ph_arc_engine_of: that of a system; false: no memory. */
bool ph_arc_engine_of(const struct ph_arc_system *system,
                      struct ph_arena *arena, struct ph_arc_engine *engine);

/*
 * ph_arc_engine_iterate: from engine->point, whose multipliers are set to 0.
 *
 * in   rho    of an augmented Lagrangian before Newton's method, or 0
 * in   steps  of Newton's method, at most
 * ret  false: no memory
 */
bool ph_arc_engine_iterate(struct ph_arc_engine *engine, double rho,
                           size_t steps);

/* ph_arc_engine_first_steps: steps of a start after which there are others. */
size_t ph_arc_engine_first_steps(const struct ph_arc_engine *engine);

/* ph_arc_engine_is_smooth: whether the rows nearly hold where an iteration is
 * to begin.  x[x_n] */
bool ph_arc_engine_is_smooth(const struct ph_arc_engine *engine,
                             const double *x);

/*
 * ph_arc_engine_go_on: after ph_arc_engine_iterate with first_steps.
 *
 * Where Newton's method ended with rows that nearly hold, as of many intervals,
 * it goes on.  Where rows do not hold yet the curve is far from its minimum,
 * and a new start finds a lower one.
 *
 * ret  false: no memory
 */
bool ph_arc_engine_go_on(struct ph_arc_engine *engine);

#endif
