/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Newton's iteration for a spherical nu-spline at given tensions, of either
 * model, on all of its nodes or on a range of them while the rest stands still;
 * and relaxation, which comes nearer from where Newton's iteration fails.
 */
#ifndef PH_SOLVE_SPHERE_NEWTON_H
#define PH_SOLVE_SPHERE_NEWTON_H

#include "solve/sphere/spline.h"

/* Nodes first, first + 1, ..., count of them, modulo n if closed; none is an
 * end of open data. */
struct ph_sphere_range {
  size_t first, count;
};

/* ph_sphere_node: node j of a range. */
static inline size_t ph_sphere_node(const struct ph_sphere_data *d,
                                    struct ph_sphere_range range, size_t j) {
  size_t i = range.first + j;
  return i < d->n ? i : i - d->n;
}

/* ph_sphere_all: all nodes that have an equation. */
struct ph_sphere_range ph_sphere_all(const struct ph_sphere_data *data);

/* ph_sphere_widen: count nodes from first on with `by` more on either side, at
 * most all; first may be an end of open data. */
struct ph_sphere_range ph_sphere_widen(const struct ph_sphere_data *data,
                                       size_t first, size_t count, size_t by);

struct ph_sphere_work {
  const struct ph_arena *arena; /* of all this; knows how much time there is */
  struct ph_block2 system;
  double (*step)[2];
  ph_vec3 *before;   /* x at the begin of an iteration, and */
  ph_vec3 *kept;     /* of a whole solution */
  double *tension;   /* tensions that are aimed at */
  size_t iterations; /* in all */
  double residual;   /* of the last solution: root mean square */
};

/* ph_sphere_work_alloc: for up to n nodes; false when memory is exhausted. */
bool ph_sphere_work_alloc(struct ph_sphere_work *work, struct ph_arena *arena,
                          size_t n);

/* ph_sphere_spline_alloc: arrays of a spline, its tensions those of the data;
 * false when memory is exhausted. */
bool ph_sphere_spline_alloc(struct ph_sphere_spline *s,
                            const struct ph_sphere_data *data,
                            const struct ph_sphere_model *model,
                            struct ph_arena *arena);

/*
 * ph_sphere_newton: from x as it is to a solution, if there is one nearby.
 *
 * The step is halved until the residual falls; the iteration ends where all
 * equations hold to rounding, or where they no longer come nearer and hold
 * nearly.
 *
 * inout s  x; r and l of the segments at the range's nodes
 * ret   whether a solution was found; if not, x is as before
 */
bool ph_sphere_newton(struct ph_sphere_spline *s, struct ph_sphere_range range,
                      struct ph_sphere_work *work);

/* ph_sphere_step: one step of the iteration, at most of such a length as the
 * iteration takes, for derivatives. */
void ph_sphere_step(struct ph_sphere_spline *s, struct ph_sphere_range range,
                    struct ph_sphere_work *work);

/*
 * ph_sphere_relax: the same from farther away, by relaxation and then Newton's
 * iteration.
 *
 * in    tau  what is added to the diagonal in the first step, where it is about
 *            1: small tau means long steps
 * inout s    x, which is anything afterwards if no solution was found
 */
bool ph_sphere_relax(struct ph_sphere_spline *s, struct ph_sphere_range range,
                     double tau, struct ph_sphere_work *work);

#endif
