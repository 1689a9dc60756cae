/* SPDX-License-Identifier: GPL-3.0-or-later */
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
#ifndef PH_SOLVE_ARCLENGTH_SYSTEM_H
#define PH_SOLVE_ARCLENGTH_SYSTEM_H

#include "solve/arclength/data.h"

#include <stdint.h>

enum {
  PH_ARC_SPAN = 5,                   /* nodes of an interval, at most */
  PH_ARC_LOCAL = 4 * PH_ARC_SPAN + 1 /* unknowns of an interval: and chi */
};

struct ph_arc_system {
  const struct ph_arc_data *data;
  size_t refine;
  size_t dim;
  size_t segments; /* M */
  size_t span;     /* nodes of an interval: refine + 2 */
  size_t nodes;    /* stored: M + 2, or M of a closed curve */
  bool turn;       /* closed in space: the last unknown is chi */
  double sign;     /* closed, not in space: w_M+j = sign w_j */
  size_t x_n;      /* unknowns */
  size_t y_n;      /* rows */

  size_t forms_n; /* rows of an interval */
  int form[4];    /* k of each */
  size_t knot_rows;

  double *gram;       /* [n][span][span] G of (1), 0 for |a - b| > 2 */
  double *bend;       /* [M][3] e_q of (4) */
  double *knot;       /* [n + 1][2] mu and nu of (2) */
  double *target;     /* [n][forms_n] */
  double *direction;  /* [n + 1][knot_rows][dim] of (3), or NULL */
  double *compliance; /* [n] of length rows, c - compliance y = 0; or NULL */
  double *white;      /* [n][forms_n][forms_n] taken to the rows (1); or NULL */

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

/* What a matrix of second derivatives is made of. */
struct ph_arc_weights {
  double functional; /* times the Hessian of F: 1, or 0 for none */
  double shift;      /* times the unit matrix */
  double pin;        /* weight of what fixes the common phase of the spinors */
};

/*
 * ph_arc_kkt: the matrix [A J^T; J -compliance] in the order of place_x and
 * place_y; A is the Hessian of F + y . c, shifted and pinned.
 *
 * out  matrix  general band matrix (kernel/band.h), kkt_n, kkt_band
 */
void ph_arc_kkt(const struct ph_arc_system *system, const double *x,
                const double *y, const struct ph_arc_linear *linear,
                const struct ph_arc_weights *weights, double *matrix);

/*
 * ph_arc_penalised: A + sum_k row_k row_k^T / max(compliance_k, 1 / rho), in
 * the order of `order`.
 *
 * in   y       NULL: A has no part of the rows
 * out  matrix  symmetric band matrix, x_n, order_band
 */
void ph_arc_penalised(const struct ph_arc_system *system, const double *x,
                      const double *y, const struct ph_arc_linear *linear,
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

#endif
