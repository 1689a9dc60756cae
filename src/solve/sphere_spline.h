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

#include "solve/sphere_data.h"

struct ph_sphere_model;

struct ph_sphere_spline {
  const struct ph_sphere_data *data;
  const struct ph_sphere_model *model;
  double *nu; /* [n] tensions */
  ph_vec3 *x; /* [n] exact: velocities; nielson: the global control points */
  ph_vec3 *r; /* [m] control points after each node, and */
  ph_vec3 *l; /* [m] before the next one */
};

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

/* The equation of a node, in its frame: 2x2 blocks by rows, and the residual,
 * scaled: 1 means as large as the data. */
struct ph_sphere_row {
  double lo[4], di[4], up[4];
  double f[2];
};

struct ph_sphere_model {
  const char *name;
  /* segment: sets r[k] and l[k] from x, and the part; its derivatives only if
   * asked for */
  void (*segment)(struct ph_sphere_spline *s, size_t k, bool derivatives,
                  struct ph_sphere_part *part);
  /* node: the equation of node i, which is no end, between two parts */
  void (*node)(const struct ph_sphere_spline *s, size_t i,
               const struct ph_sphere_part *left,
               const struct ph_sphere_part *right, bool derivatives,
               struct ph_sphere_row *row);
  /* move: x[i] when it moves by these coordinates in the frame */
  ph_vec3 (*move)(const struct ph_sphere_spline *s, size_t i,
                  const double step[2]);
};

/* The models: velocities, truly G2 [derived in sphere_exact.c], and global
 * control points [IOR15, sec. 3.2]. */
extern const struct ph_sphere_model ph_sphere_exact;
extern const struct ph_sphere_model ph_sphere_nielson;

#endif
