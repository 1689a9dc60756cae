/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Data and equations of the method `arclength`. */
#ifndef PH_SOLVE_ARCLENGTH_SYSTEM_H
#define PH_SOLVE_ARCLENGTH_SYSTEM_H

#include "base/diag.h"
#include "base/mem.h"
#include "curve/problem.h"
#include "kernel/quat.h"
#include "kernel/vec3.h"

#include <math.h>
#include <stddef.h>
#include <stdint.h>

/* ---- data ---------------------------------------------------------------- */

/*
 * Data of the arc-length problem, from the fields of a problem to unit scale
 * and to a pose that does not depend on where the data lie.
 *
 * N intervals; in each the curve is given at both ends by a point, a derivative
 * or a direction.  Ours is the unit in which the mean length (of chords, where
 * lengths are free) is 1, and the frame in which the first vector is along x,
 * the next that is not is in the plane of x and y, the data turn in the sense
 * of a right-handed screw, and the sequence read backwards is not the smaller
 * one; closed data begin with their longest interval.  Data that were moved,
 * turned, mirrored or reversed give the same, and closed ones wherever they
 * begin.
 */

enum ph_arc_mode { PH_ARC_POINTS, PH_ARC_DERIVATIVES, PH_ARC_TANGENTS };

struct ph_arc_data {
  enum ph_arc_mode mode;
  bool closed;
  size_t n; /* intervals */

  double *h;      /* [n] spacings of the knots, mean 1 */
  double *length; /* [n]; NULL: they are free */
  double sigma;   /* their relative standard deviation; 0: they are exact */
  double *tangent_sigma; /* [n + 1] of tangents, radians, 0: exact; or NULL */
  double *chord;         /* [n] of points: |step|; else NULL */
  ph_vec3 *step;         /* [n] of points: to the next one; else NULL */
  ph_vec3 *given;        /* [n + 1] derivatives, or unit tangents; else NULL */

  bool plane;      /* all vectors are in the plane z = 0 */
  bool line;       /* all are along x */
  bool straight;   /* all are along x, in its sense; of points, lengths are
                    * chords */
  double rounding; /* of the vectors: below this they are zero */

  ph_quat turn;  /* takes the axes of our frame to those of the user's */
  bool mirrored; /* z is reversed, before that */
  size_t first;  /* the user's interval that the sequence begins with: of closed
                  * data; else 0 */
  bool reversed; /* it is reversed, after that */
  double root;   /* a number of ours times its square is one of the user's */

  double *knots;        /* [n + 1] of the record */
  const double *points; /* of the user: of points the n or n + 1 of them */
  size_t dimension;     /* of these: 2 or 3 */
  double start[3];      /* the first point */
};

/*
 * ph_arc_data_read: the data of a problem.
 *
 * out  data  arrays in the arena
 * ret  PH_OK | PH_E_MISSING_FIELD | PH_E_BAD_VALUE | PH_E_BAD_SHAPE |
 *      PH_E_TOO_FEW_POINTS | PH_E_COINCIDENT_POINTS | PH_E_ZERO_TANGENT |
 *      PH_E_INFEASIBLE (a length is below its chord) | PH_E_TOO_LARGE |
 *      PH_E_NO_MEMORY
 */
enum ph_status ph_arc_data_read(const struct ph_problem *problem,
                                struct ph_arena *arena,
                                struct ph_arc_data *data, struct ph_diag *diag);

/* ph_arc_data_speed: the mean of length / spacing of the intervals beside datum
 * j: derivatives of that size belong to the lengths [HUA14, sec. 5.3]. */
double ph_arc_data_speed(const struct ph_arc_data *data, size_t j);

/* ph_arc_data_user: the user's number of our interval i. */
static inline size_t ph_arc_data_user(const struct ph_arc_data *data,
                                      size_t i) {
  size_t at = data->reversed ? data->n - 1 - i : i;
  return (at + data->first) % data->n;
}

/* ph_arc_data_ours: our number of the user's interval i. */
static inline size_t ph_arc_data_ours(const struct ph_arc_data *data,
                                      size_t i) {
  size_t at = (i + data->n - data->first) % data->n;
  return data->reversed ? data->n - 1 - at : at;
}

/* ph_arc_data_pose: turns, mirrors and reverses what ph_arc_data_read found in
 * the user's frame to the pose that all such data have. */
void ph_arc_data_pose(struct ph_arc_data *data);

/* ---- forms --------------------------------------------------------------- */

/* Nodes, and the quadratic forms S_0, ..., S_3 of one: its squared length and
 * the components of its image H (see below). */

/* ph_arc_form: out = S_k v, of dim components. */
static inline void ph_arc_form(size_t dim, int k, const double *v,
                               double *out) {
  if (dim == 4) {
    double v0 = v[0], v1 = v[1], v2 = v[2], v3 = v[3];
    out[0] = k < 2 ? v0 : k == 2 ? v2 : -v3;
    out[1] = k < 2 ? v1 : k == 2 ? v3 : v2;
    out[2] = k == 0 ? v2 : k == 1 ? -v2 : k == 2 ? v0 : v1;
    out[3] = k == 0 ? v3 : k == 1 ? -v3 : k == 2 ? v1 : -v0;
  } else if (dim == 2) {
    double v0 = v[0], v1 = v[1];
    out[0] = k < 2 ? v0 : v1;
    out[1] = k == 0 ? v1 : k == 1 ? -v1 : v0;
  } else {
    out[0] = v[0];
  }
}

/* ph_arc_dot: of two vectors. */
static inline double ph_arc_dot(size_t dim, const double *u, const double *v) {
  double sum = 0;
  for (size_t i = 0; i < dim; i++) {
    sum += u[i] * v[i];
  }
  return sum;
}

/* ph_arc_largest: the largest |v[i]|; NaN if one is. */
static inline double ph_arc_largest(size_t n, const double *v) {
  double most = 0;
  for (size_t i = 0; i < n && !isnan(most); i++) {
    double size = fabs(v[i]);
    most = size <= most ? most : size;
  }
  return most;
}

/* ph_arc_form_sum: out[dim][dim] = sum_k y_k S_k of the given forms. */
static inline void ph_arc_form_sum(size_t dim, size_t n, const int *form,
                                   const double *y, double *out) {
  double w[4] = {0, 0, 0, 0};
  for (size_t k = 0; k < n; k++) {
    w[form[k]] += y[k];
  }
  if (dim == 4) {
    const double sum[16] = {
        w[0] + w[1], 0, w[2],  -w[3], 0, w[0] + w[1], w[3], w[2], w[2], w[3],
        w[0] - w[1], 0, -w[3], w[2],  0, w[0] - w[1]};
    for (size_t i = 0; i < 16; i++) {
      out[i] = sum[i];
    }
  } else if (dim == 2) {
    out[0] = w[0] + w[1];
    out[1] = out[2] = w[2];
    out[3] = w[0] - w[1];
  } else {
    out[0] = w[0] + w[1];
  }
}

/* ph_arc_spinor: a unit node in space whose image H is the unit vector d, well
 * conditioned for each. */
static inline void ph_arc_spinor(ph_vec3 d, double w[4]) {
  if (d.x >= 0) {
    double a = sqrt((1 + d.x) / 2);
    w[0] = a;
    w[1] = 0;
    w[2] = d.y / (2 * a);
    w[3] = -d.z / (2 * a);
  } else {
    double b = sqrt((1 - d.x) / 2);
    w[0] = d.y / (2 * b);
    w[1] = d.z / (2 * b);
    w[2] = b;
    w[3] = 0;
  }
}

/* ph_arc_turned: i w of a node in space. */
static inline void ph_arc_turned(const double *w, double *out) {
  double w0 = w[0], w1 = w[1], w2 = w[2], w3 = w[3];
  out[0] = -w1;
  out[1] = w0;
  out[2] = -w3;
  out[3] = w2;
}

/* ph_arc_phase: e^(i angle) w of a node in space. */
static inline void ph_arc_phase(double cosine, double sine, const double *w,
                                double *out) {
  double iw[4];
  ph_arc_turned(w, iw);
  for (size_t i = 0; i < 4; i++) {
    out[i] = cosine * w[i] + sine * iw[i];
  }
}

/* ---- equations ----------------------------------------------------------- */

/*
 * The equations of C2 PH quintic splines with prescribed arc lengths.
 *
 * The preimage is a quadratic C1 spline w(t) of spinors (a, b), r' = H(w) =
 * (|a|^2 - |b|^2, 2 Re a conj(b), 2 Im a conj(b)), |r'| = |w|^2.  An interval
 * between two data has `refine` segments; w_j is the middle Bernstein
 * coefficient of segment j = 1, ..., M, with w_0 and w_M+1 beyond the ends
 * [HUA14, (8)].  Unknown are these nodes; with node vectors X of an interval
 *
 *   rows of an interval   sum_ab G[a][b] X_a . S_k X_b = target_k          (1)
 *   rows of a knot        m . S_k m = d_k,  m = mu w_j + nu w_j+1          (2)
 *                         or, of a direction with the spinor s,
 *                         -s_b m_a + s_a m_b = 0                           (3)
 *   functional            F = integral of |w''|^2 = sum_q |e_q . X|^2      (4)
 *
 * where S_0 is the length and S_1, S_2, S_3 are the components of H.  They are
 * [HUA14, (15)-(19), (24)] in other words.  [HUA14] has refine = 1.
 *
 * A node has `dim` real components: 4 in space (Re a, Im a, Re b, Im b), 2 in
 * the plane z = 0, where a and b are real, 1 on the axis x, where b is 0.  Rows
 * are ordered by intervals, then by knots.  Nodes of a closed curve repeat:
 * w_M+j = e^(i chi) w_j with chi unknown (in the plane e^(i chi) = +-1).
 */

enum {
  PH_ARC_SPAN = 5,                   /* nodes of an interval, at most */
  PH_ARC_LOCAL = 4 * PH_ARC_SPAN + 1 /* unknowns of an interval: and chi */
};

/* |r'| at a datum, relative to the mean, below which there is no direction. */
#define PH_ARC_STANDSTILL 1e-8

/* Intervals from which on points are many: from here on they have blocks. */
enum { PH_ARC_MANY = 48 };

struct ph_arc_system {
  const struct ph_arena *arena; /* knows how much time there is */
  const struct ph_arc_data *data;
  size_t refine;
  size_t dim;
  size_t segments; /* M */
  size_t span;     /* nodes of an interval: refine + 2 */
  size_t nodes;    /* stored: M + 2, or M of a closed curve */
  bool turn;       /* closed in space: the last unknown is chi */
  double sign;     /* closed, not in space: w_M+j = sign w_j */
  bool phases;     /* steps and matrices know phases, see ph_arc_weights */
  bool part;       /* see ph_arc_part_of, */
  bool held[2];    /* whose two nodes at this end are held */
  size_t x_n;      /* unknowns */
  size_t y_n;      /* rows */

  size_t forms_n; /* rows of an interval */
  int form[4];    /* k of each */
  size_t knot_rows;

  double *gram;       /* [n][span][span] G of (1), 0 for |a - b| > 2 */
  double *second;     /* [M][3] e_q of (4) */
  double *knot;       /* [n + 1][2] mu and nu of (2) */
  double *target;     /* [n][forms_n] */
  double *direction;  /* [n + 1][knot_rows][dim] of (3), or NULL */
  double *compliance; /* [n] of length rows, c - compliance y = 0; or NULL */
  double *knot_compliance; /* [n + 1] of the rows (3) of a knot; or NULL */
  double *white; /* [n][forms_n][forms_n] taken to the rows (1); or NULL */

  uint32_t *place_x; /* [x_n] places of the unknowns in the KKT matrix */
  uint32_t *place_y; /* [y_n] and of the multipliers */
  size_t kkt_n, kkt_band;
  uint32_t *order; /* [x_n] places of the unknowns in matrices of them alone */
  size_t order_band;
};

/* The rows and their derivatives at x. */
struct ph_arc_linear {
  double f;     /* F */
  double *c;    /* [y_n] rows minus targets; without compliance */
  double *f_x;  /* [x_n] gradient of F */
  double *l_x;  /* [x_n] gradient of F + y . c */
  double *rows; /* [n][forms_n][local], local = span dim (+ 1 if turn): of (1)
                 * by the unknowns of the interval, see ph_arc_index */
  double *knot_rows; /* [n + 1][knot_rows][2 dim]: of (2), (3) */
};

/* ph_arc_coefficients: Bernstein coefficients of segment q from its nodes,
 * c[k] = sum_l out[k][l] w_(q+l) [HUA14, (8)]. */
void ph_arc_coefficients(const struct ph_arc_system *system, size_t q,
                         double out[3][3]);

/* ph_arc_local: how many unknowns an interval may have. */
static inline size_t ph_arc_local(const struct ph_arc_system *system) {
  return system->span * system->dim + (system->turn ? 1 : 0);
}

/* ph_arc_wraps: whether an interval has nodes beyond the seam. */
static inline bool ph_arc_wraps(const struct ph_arc_system *system,
                                size_t interval) {
  return interval * system->refine + system->span > system->nodes;
}

/* ph_arc_touched: how many unknowns this one has: chi only beyond the seam. */
static inline size_t ph_arc_touched(const struct ph_arc_system *system,
                                    size_t interval) {
  return system->span * system->dim +
         (system->turn && ph_arc_wraps(system, interval) ? 1 : 0);
}

/* ph_arc_compliance: what row r yields to its multiplier; 0: it is exact. */
static inline double ph_arc_compliance(const struct ph_arc_system *system,
                                       size_t r) {
  size_t knots = system->data->n * system->forms_n;
  if (r >= knots) {
    return system->knot_compliance
               ? system->knot_compliance[(r - knots) / system->knot_rows]
               : 0;
  }
  return system->compliance && r % system->forms_n == 0
             ? system->compliance[r / system->forms_n]
             : 0;
}

/* ph_arc_index: which unknowns of x an interval has, in the order of its rows.
 * out index[PH_ARC_LOCAL] */
void ph_arc_index(const struct ph_arc_system *system, size_t interval,
                  size_t *index);

/*
 * ph_arc_system_of: the equations of data.
 *
 * in   refine  1, 2 or 3
 * in   dim     4; 2 if data->plane; 1 if data->straight
 * in   exact   false: the lengths are free, whatever the data say
 * ret  false when memory is exhausted
 */
bool ph_arc_system_of(const struct ph_arc_data *data, size_t refine, size_t dim,
                      bool exact, struct ph_arena *arena,
                      struct ph_arc_system *system);

/*
 * ph_arc_soften: lengths in the sense of least squares: minimise
 * F + F_ref / (9 n) sum ((L_i - l_i) / (sigma l_i))^2, whose rows are
 * L_i - l_i - compliance_i y_i = 0.
 *
 * in   f_relaxed  F_ref > 0: F where the lengths are free
 * ret  false when memory is exhausted
 */
bool ph_arc_soften(struct ph_arc_system *system, double f_relaxed,
                   struct ph_arena *arena);

/*
 * ph_arc_part_of: the equations of n intervals of points, from one on and, of
 * closed curves, beyond the seam.  Of the two nodes at each end, which belong
 * to intervals beside these, too, only a common phase changes: where all on
 * that side turns with them, nothing else does.
 *
 * out  data  of the part: mode and n alone
 * ret  false when memory is exhausted
 */
bool ph_arc_part_of(const struct ph_arc_system *system, size_t first, size_t n,
                    struct ph_arena *arena, struct ph_arc_data *data,
                    struct ph_arc_system *part);

/* ph_arc_linear_alloc: the arrays of a linearisation; false: no memory. */
bool ph_arc_linear_alloc(const struct ph_arc_system *system,
                         struct ph_arena *arena, struct ph_arc_linear *linear);

/* ph_arc_functional: F at x. */
double ph_arc_functional(const struct ph_arc_system *system, const double *x);

/* ph_arc_residual: the rows minus their targets.  out c[y_n] */
void ph_arc_residual(const struct ph_arc_system *system, const double *x,
                     double *c);

/* ph_arc_lengths: the lengths of the intervals.  out length[n] */
void ph_arc_lengths(const struct ph_arc_system *system, const double *x,
                    double *length);

/* ph_arc_deviation: the angle from r' at knot j to the direction that is given
 * there; NaN where the curve stands still. */
double ph_arc_deviation(const struct ph_arc_system *system, const double *x,
                        size_t j);

/* ph_arc_linearise: everything at x with multipliers y. */
void ph_arc_linearise(const struct ph_arc_system *system, const double *x,
                      const double *y, struct ph_arc_linear *linear);

/* ph_arc_add_rows: out += sum_k v_k (gradient of row k).  out[x_n], v[y_n] */
void ph_arc_add_rows(const struct ph_arc_system *system,
                     const struct ph_arc_linear *linear, const double *v,
                     double *out);

/* ph_arc_rows_times: out = J v.  v[x_n], out[y_n] */
void ph_arc_rows_times(const struct ph_arc_system *system,
                       const struct ph_arc_linear *linear, const double *v,
                       double *out);

/* The rows of an interval are those of it and of its first knot, of the last
 * interval also of the last knot: ph_arc_knots_end is the knot after these. */
static inline size_t ph_arc_knots_end(const struct ph_arc_system *system,
                                      size_t interval) {
  return interval + (interval + 1 == system->data->n ? 2 : 1);
}

/* ph_arc_interval: sets the rows of an interval, minus their targets, in
 * c[y_n].  ret its part of F */
double ph_arc_interval(const struct ph_arc_system *system, const double *x,
                       size_t interval, double *c);

/* ph_arc_add_rows_of, ph_arc_rows_times_of: the same as ph_arc_add_rows and
 * ph_arc_rows_times, of the rows of an interval alone. */
void ph_arc_add_rows_of(const struct ph_arc_system *system,
                        const struct ph_arc_linear *linear, size_t interval,
                        const double *v, double *out);
void ph_arc_rows_times_of(const struct ph_arc_system *system,
                          const struct ph_arc_linear *linear, size_t interval,
                          const double *v, double *out);

/* What a matrix of second derivatives is made of. */
struct ph_arc_weights {
  double functional; /* times the Hessian of F: 1, or 0 for none */
  double shift;      /* times the changes of nodes, see below */
  double pin;        /* weight of what fixes the common phase of the spinors */
  double rounding;   /* of penalised matrices: times the largest element on the
                      * diagonal of the Hessian, as a further shift; or 0 */
  double yield;      /* of ph_arc_kkt_negative: compliance of all rows */
  const double *shifts; /* [nodes] a further one of each node; or NULL */
  const double *holds;  /* [nodes] times its unit matrix; or NULL */
  bool retracted; /* second derivatives along ph_arc_retract, not along lines,
                   * of a system with phases */
};

/*
 * Phases in these matrices.  A common phase of all nodes leaves the curve as it
 * is, one of all that are on one side of a node changes it at that node only.
 *
 * Second derivatives of F + y . c along ph_arc_retract, by changes d and phases
 * p of nodes, w + t (d + i p w) + t^2 (i p d - p^2 w / 2), have a further part
 * of their gradient g by a node (ph_arc_retract_square).  With it the matrix
 * knows at every x that a common phase changes nothing; without, a step that
 * turns one side of a curve sees curvature that is not there.
 *
 * A shift weighs changes by
 *
 *   sum_j shift_j |d_j|^2 + (shift_j + shift_j+1) / 2
 *                           min(|w_j|, |w_j+1|)^2 (p_j+1 - p_j)^2:
 *
 * the unit matrix would take the turn of one side for a change of all its
 * nodes, the larger the longer the curve is.  Systems of many points or
 * directions in space have phases; few lead as well without, to other minima:
 * there d is the whole change.
 */

/* ph_arc_retract_square: g . (second derivatives of ph_arc_retract_node). */
void ph_arc_retract_square(const double *w, const double *g, double out[16]);

/* ph_arc_change_square: second derivatives / 2 of shift |d|^2.
 * out out[dim][dim] */
void ph_arc_change_square(const struct ph_arc_system *system, const double *w,
                          double shift, double *out);

/* ph_arc_link_square: of shift min(|w|, |v|)^2 (p_v - p_w)^2, nodes w and v.
 * out own by w, cross by v and w */
void ph_arc_link_square(const double *w, const double *v, double shift,
                        double own[16], double cross[16]);

/* ph_arc_ends_gradient: what is left of a gradient where ends are held.
 * inout gradient[x_n] */
void ph_arc_ends_gradient(const struct ph_arc_system *system, const double *x,
                          double *gradient);

/* ph_arc_split: p and d = rest of a change v of node w; without phases p is 0.
 */
double ph_arc_split(const struct ph_arc_system *system, const double *w,
                    const double *v, double *rest);

/*
 * ph_arc_kkt: the matrix [A J^T; J -compliance] in the order of place_x and
 * place_y; A is the Hessian of F + y . c, shifted and pinned.
 *
 * out  matrix  general band matrix (kernel/band.h), kkt_n, kkt_band
 */
void ph_arc_kkt(const struct ph_arc_system *system, const double *x,
                const double *y, const struct ph_arc_linear *linear,
                const struct ph_arc_weights *weights, double *matrix);

/* ph_arc_kkt_factor: its factors, of ph_band_factor, while it is in the cache.
 * ret false when it is singular or time is over */
bool ph_arc_kkt_factor(const struct ph_arc_system *system, const double *x,
                       const double *y, const struct ph_arc_linear *linear,
                       const struct ph_arc_weights *weights, double *matrix,
                       uint32_t *pivot);

/* ph_arc_kkt_negative: how many negative eigenvalues it has, A raised by
 * weights->rounding; SIZE_MAX when something is not finite or time is over.
 * out matrix [ph_sym_size(kkt_n, kkt_band)], work [ph_inertia_size(kkt_band)]
 */
size_t ph_arc_kkt_negative(const struct ph_arc_system *system, const double *x,
                           const double *y, const struct ph_arc_linear *linear,
                           const struct ph_arc_weights *weights, double *matrix,
                           double *work);

/*
 * ph_arc_penalised: A + sum_k row_k row_k^T / (compliance_k + 1 / rho), in the
 * order of `order`.
 *
 * in   y       NULL: A has no part of the rows
 * out  matrix  symmetric band matrix, x_n, order_band
 */
void ph_arc_penalised(const struct ph_arc_system *system, const double *x,
                      const double *y, const struct ph_arc_linear *linear,
                      const struct ph_arc_weights *weights, double rho,
                      double *matrix);

/* ph_arc_penalised_factor: its factor, of ph_sym_factor.
 * ret false when it is not positive definite or time is over */
bool ph_arc_penalised_factor(const struct ph_arc_system *system,
                             const double *x, const double *y,
                             const struct ph_arc_linear *linear,
                             const struct ph_arc_weights *weights, double rho,
                             double *matrix);

/*
 * ph_arc_retract: x + step (dx), where the part of dx that turns the phase of a
 * node is applied as a turn: w <- e^(i p) (w + dw - i p w), p = <i w, dw> /
 * |w|^2.  Phases that change slowly along the curve leave it nearly as it is,
 * but are of the order of 1: added linearly they would break the rows.
 *
 * out  to[x_n]  may not be x
 */
void ph_arc_retract(const struct ph_arc_system *system, const double *x,
                    const double *dx, double step, double *to);

/* ph_arc_retract_node: the same of node j alone. */
void ph_arc_retract_node(const struct ph_arc_system *system, const double *x,
                         const double *dx, double step, size_t j, double *to);

/*
 * ph_arc_retract_rows: y + step dy of multipliers, along ph_arc_retract.
 *
 * Where phases turn the rows (3) turn as well, and with them their multipliers:
 * y <- e^(i p) (y + dy - i p y), p that of the knot.  What is left of both is
 * then as if nothing had turned.
 *
 * out  to[y_n]  may be y
 */
void ph_arc_retract_rows(const struct ph_arc_system *system, const double *x,
                         const double *dx, double step, const double *y,
                         const double *dy, double *to);

/* ph_arc_yield: multipliers of rows (3) that yield, c / compliance: linear rows
 * have no need of others on the way.  inout y[y_n] */
void ph_arc_yield(const struct ph_arc_system *system, const double *x,
                  double *y);

/* ---- pieces -------------------------------------------------------------- */

/* One interval of the equations: its nodes, with those of a closed curve beyond
 * the seam turned or reversed (see above). */

struct ph_arc_piece {
  size_t interval;
  size_t inside;              /* its nodes before the seam */
  double cosine, sine;        /* of chi */
  double w[4 * PH_ARC_SPAN];  /* nodes [span][dim] */
  double gw[4 * PH_ARC_SPAN]; /* G w */
};

/* ph_arc_piece_of: an interval at x. */
void ph_arc_piece_of(const struct ph_arc_system *system, const double *x,
                     size_t interval, struct ph_arc_piece *piece);

/* ph_arc_piece_back: derivatives by the nodes become derivatives by the
 * unknowns.  inout v[local] */
void ph_arc_piece_back(const struct ph_arc_system *system,
                       const struct ph_arc_piece *piece, double *v);

#endif
