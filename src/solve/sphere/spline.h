/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A spherical nu-spline at given tensions, and the two models of it: nodes
 * p[0], ..., p[n-1], one unknown x[i] with two coordinates at each, and the
 * inner control points r[k], l[k] of every segment:
 *   segment k:   p[k], r[k], l[k], p[k+1].
 *
 * A model says what a segment means for the equations at its two nodes
 * (struct ph_sphere_part), and what the equation of a node is.  The
 * equation of node i contains x[i-1], x[i] and x[i+1] only, so that part of a
 * spline can be solved while the rest stands still.
 */
#ifndef PH_SOLVE_SPHERE_SPLINE_H
#define PH_SOLVE_SPHERE_SPLINE_H

#include "curve/spherical.h"
#include "kernel/block2.h"
#include "solve/sphere/data.h"

struct ph_sphere_model;
struct ph_sphere_work; /* solve/sphere/newton.h */

struct ph_sphere_spline {
  const struct ph_sphere_data *data;
  const struct ph_sphere_model *model;
  double *nu; /* [n] tensions */
  ph_vec3 *x; /* [n] exact: velocities; nielson: the global control points, less
               * the nodes */
  ph_vec3 *r; /* [m] control points after each node, and */
  ph_vec3 *l; /* [m] before the next one */
};

/* ph_sphere_segment: segment k. */
static inline struct ph_spherical
ph_sphere_segment(const struct ph_sphere_spline *s, size_t k) {
  const ph_vec3 *p = s->data->p;
  struct ph_spherical segment = {
      {p[k], s->r[k], s->l[k], p[ph_sphere_next(s->data, k)]}};
  return segment;
}

/*
 * What a segment contributes to the equations of its nodes: one vector to that
 * of the node it begins at, f[0], and one to that of the node it ends at, f[1],
 * with derivatives: d[e][w][c] is that of f[e] when x at the segment's begin
 * (w = 0) or end (w = 1) moves along the frame's vector c.
 */
struct ph_sphere_part {
  ph_vec3 f[2];
  ph_vec3 d[2][2][2];
};

struct ph_sphere_model {
  const char *name;
  /* segment: sets r[k] and l[k] from x, and the part; its derivatives only if
   * asked for */
  void (*segment)(struct ph_sphere_spline *s, size_t k, bool derivatives,
                  struct ph_sphere_part *part);
  /* node: the equation of node i, which is no end, between two parts: its
   * derivatives, if asked for, and what is missing, in the node's frame; scaled
   * so that 1 means as large as the data */
  void (*node)(const struct ph_sphere_spline *s, size_t i,
               const struct ph_sphere_part *left,
               const struct ph_sphere_part *right, bool derivatives,
               struct ph_block2_row *row);
  /* move: x[i] when it moves by these coordinates in the frame */
  ph_vec3 (*move)(const struct ph_sphere_spline *s, size_t i,
                  const double step[2]);
  /* reach: how far control points go at most when x[i] moves by 1, in radians
   */
  double (*reach)(const struct ph_sphere_spline *s, size_t i);
  /* hug: x of a spline that is nearly at infinite tension; of the ends of open
   * data, whatever it stays */
  void (*hug)(struct ph_sphere_spline *s);
  /* start: x to begin an iteration from; false when there is none of that
   * number, 0, 1, ... */
  bool (*start)(struct ph_sphere_spline *s, size_t which,
                struct ph_sphere_work *work);
  /* last_resort: another way to a solution, which is true if it is one; or
   * NULL */
  bool (*last_resort)(struct ph_sphere_spline *s, struct ph_sphere_work *work);
};

/* The models: velocities, truly G2 [derived in sphere_exact.c], and global
 * control points [IOR15, sec. 3.2]. */
extern const struct ph_sphere_model ph_sphere_exact;
extern const struct ph_sphere_model ph_sphere_nielson;

#endif
