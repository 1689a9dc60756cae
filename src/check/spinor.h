/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The preimage of a C2 spatial PH quintic spline as one C1 quadratic spline
 * A(t) of quaternions, r' = A i A*, t the global parameter: its nodes w_0, ...,
 * w_(M+1), of which w_(k+1) is the middle coefficient of segment k and the
 * outer ones lie beyond the ends [HUA14, (8)]; and its elements, the segments
 * and the data knots, on which everything is a quadratic form of two or three
 * neighbouring nodes.
 *
 * Unit scale here: the mean length of an interval of the data is 1, and so is
 * the mean spacing of their knots.  Nodes of a closed spline repeat but for a
 * phase: w_(M+j) = w_j e^(i chi).
 */
#ifndef PH_CHECK_SPINOR_H
#define PH_CHECK_SPINOR_H

#include "base/mem.h"
#include "curve/result.h"
#include "kernel/quad.h"
#include "kernel/quat.h"

/* What is prescribed for the curve. */
struct ph_spinor_rows {
  size_t n;              /* intervals */
  size_t refine;         /* segments in each */
  bool lengths;          /* of intervals */
  bool points;           /* at their ends */
  size_t knot_rows;      /* of a derivative at each of their ends 3; 2 of its
                            direction; 0 */
  const ph_vec3 *toward; /* [n + 1] of a direction that was measured the unit
                            vector, of others 0; or NULL.  Its rows are the
                            forms |A|^2 - toward . A i A* and 0 */
};

struct ph_spinor {
  struct ph_spinor_rows rows;
  size_t segments; /* M */
  size_t stored;   /* nodes that are unknown: M + 2, or M of a closed one */
  ph_cplx seam;    /* e^(i chi); 1 of an open one */
  ph_quat *w;      /* [M + 2] */
  double *h;       /* [M] spacings */
  double unit;     /* the mean length */
  double largest;  /* |w|^2, the largest */
  double defect;   /* how far the preimage is from the spline, relative to
                      the largest |w| */
  struct ph_quad rule;
};

/* A linear combination s |A|^2 + v . (A i A*) of what a row may prescribe. */
struct ph_spinor_form {
  double s;
  ph_vec3 v;
};

/* Forms of the nodes w_first, ...: with X_a = w_(first + a)
 *   the integral of (or the value at the knot of) A i A* is
 *   sum gram[a][b] X_a i X_b*, and so on
 *   the integral of |A''|^2 is |sum second[a] X_a|^2 */
struct ph_spinor_element {
  size_t first, nodes;
  double gram[3][3];
  double second[3];
  size_t row, rows; /* which rows it is a part of, and their forms */
  struct ph_spinor_form form[4];
};

/* ph_spinor_of: the spline of a curve; PH_OK | PH_E_NO_MEMORY. */
enum ph_status ph_spinor_of(const struct ph_curve *curve,
                            const struct ph_spinor_rows *rows,
                            struct ph_arena *arena, struct ph_spinor *spline,
                            struct ph_diag *diag);

/* ph_spinor_interval_rows: how many rows an interval has; those of knots are
 * after those of all intervals. */
static inline size_t ph_spinor_interval_rows(const struct ph_spinor *s) {
  return (size_t)s->rows.lengths + 3 * (size_t)s->rows.points;
}

/* ph_spinor_rows_n: how many rows there are in all. */
static inline size_t ph_spinor_rows_n(const struct ph_spinor *s) {
  return s->rows.n * ph_spinor_interval_rows(s) +
         (s->rows.n + 1) * s->rows.knot_rows;
}

/* ph_spinor_elements: how many elements: segments, then knots with rows. */
static inline size_t ph_spinor_elements(const struct ph_spinor *s) {
  return s->segments + (s->rows.knot_rows > 0 ? s->rows.n + 1 : 0);
}

/* ph_spinor_element_of: element k, gram by Gauss quadrature. */
struct ph_spinor_element ph_spinor_element_of(const struct ph_spinor *s,
                                              size_t k);

/* ph_spinor_gradient: half the gradient of a form by A: s A - v A i. */
static inline ph_quat ph_spinor_gradient(struct ph_spinor_form f, ph_quat a) {
  ph_quat turned = ph_quat_of(-a.v, a.u, a.q, -a.p); /* a i */
  return ph_quat_sub(ph_quat_scale(f.s, a),
                     ph_quat_mul(ph_quat_pure(f.v), turned));
}

/* ph_spinor_product: half the gradient of the element's quadratic form of unit
 * weight by its node a: sum_b gram[a][b] X_b. */
static inline ph_quat ph_spinor_product(const struct ph_spinor *s,
                                        const struct ph_spinor_element *e,
                                        size_t a) {
  ph_quat sum = {0, 0, 0, 0};
  for (size_t b = 0; b < e->nodes; b++) {
    sum = ph_quat_add(sum, ph_quat_scale(e->gram[a][b], s->w[e->first + b]));
  }
  return sum;
}

/* ph_spinor_second: sum_a second[a] X_a. */
static inline ph_quat ph_spinor_second(const struct ph_spinor *s,
                                       const struct ph_spinor_element *e) {
  ph_quat sum = {0, 0, 0, 0};
  for (size_t a = 0; a < e->nodes; a++) {
    sum = ph_quat_add(sum, ph_quat_scale(e->second[a], s->w[e->first + a]));
  }
  return sum;
}

#endif
