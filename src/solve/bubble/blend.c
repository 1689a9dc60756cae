/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Derivatives across sides as polynomials (see bubble.h). */
#include "kernel/bern.h"
#include "kernel/quad.h"
#include "solve/bubble/bubble.h"

#include <gsl/gsl_linalg.h>

#include <math.h>
#include <string.h>

/* Node i of a rule: of the second, on one half and then on the other. */
static double node_of(const struct ph_quad *gauss, size_t rule, size_t i) {
  const double node = gauss->node[i % PH_BLEND_NODES];
  return rule ? (node + (double)(i / PH_BLEND_NODES)) / 2 : node;
}

enum ph_status ph_blends_begin(struct ph_blends *blends, size_t continuity,
                               struct ph_arena *arena, struct ph_diag *diag) {
  memset(blends, 0, sizeof *blends);
  blends->continuity = continuity;
  blends->arena = arena;
  if (!ph_quad_gauss(&blends->gauss, PH_BLEND_NODES)) {
    return ph_fail_memory(diag);
  }
  for (size_t i = 0; i < 2; i++) {
    blends->rows[i] =
        ph_arena_array(arena, ph_blend_nodes(i), sizeof *blends->rows[i]);
    if (!blends->rows[i]) {
      return ph_fail_memory(diag);
    }
    for (size_t j = 0; j < ph_blend_nodes(i); j++) {
      ph_ribbon_rows_at(continuity, node_of(&blends->gauss, i, j), 0,
                        &blends->rows[i][j]);
    }
  }
  return PH_OK;
}

/* ---- least squares ------------------------------------------------------- */

/* The pseudoinverse of the basis functions inner[nodes][n], all weighed: what
 * takes residuals to coefficients, free[n][nodes].  Jacobi's method takes no
 * memory (see fit.c). */
static bool invert(const double *inner, const struct ph_quad *gauss,
                   size_t nodes, size_t n, struct ph_arena *arena,
                   double *free) {
  struct ph_mark mark = ph_arena_mark(arena);
  double *room = ph_arena_array(arena, nodes * n + n * n + n, sizeof *room);
  gsl_matrix_view A, V;
  gsl_vector_view S;
  bool good = room != NULL;
  if (good && n > 0) {
    A = gsl_matrix_view_array(room, nodes, n);
    V = gsl_matrix_view_array(room + nodes * n, n, n);
    S = gsl_vector_view_array(room + nodes * n + n * n, n);
    for (size_t i = 0; i < nodes * n; i++) {
      room[i] = sqrt(gauss->weight[i / n % PH_BLEND_NODES]) * inner[i];
    }
    good = gsl_linalg_SV_decomp_jacobi(&A.matrix, &V.matrix, &S.vector) == 0;
    for (size_t i = 0; good && i < n; i++) {
      for (size_t j = 0; j < nodes; j++) {
        double x = 0;
        for (size_t k = 0; k < n; k++) {
          x += gsl_matrix_get(&V.matrix, i, k) / gsl_vector_get(&S.vector, k) *
               gsl_matrix_get(&A.matrix, j, k);
        }
        free[nodes * i + j] = x * sqrt(gauss->weight[j % PH_BLEND_NODES]);
      }
    }
  }
  ph_arena_release(arena, mark);
  return good;
}

/* ---- what a degree has --------------------------------------------------- */

/* The coefficients of degree `degree' of the Hermite polynomials at 0. */
static void set_hermite(size_t order, size_t degree, double *hermite) {
  for (size_t j = 0; j <= order; j++) {
    double a[PH_CROSS_MAX] = {0, 0, 0}, low[PH_CROSS_MAX];
    a[j] = 1;
    ph_bern_contact(2 * order + 1, a, order + 1, low, 1);
    for (size_t i = 0; i <= degree; i++) {
      double *to = &hermite[j * (degree + 1) + i];
      *to = 0;
      for (size_t k = 0; k <= order; k++) { /* the others are 0 */
        *to += ph_bern_elevate(2 * order + 1, k, degree, i) * low[k];
      }
    }
  }
}

static bool make(struct ph_blends *blends, size_t degree,
                 struct ph_blend *blend) {
  const size_t order = blends->continuity, ends = 2 * (order + 1);
  const size_t inner_n = degree + 1 - ends, height = 4 * order + 2;
  const size_t rule = ph_blend_rule(degree), nodes = ph_blend_nodes(rule);
  double basis[PH_BLEND_MAX + 1];
  double *fixed, *free, *inner, *elevate, *hermite;
  fixed = ph_arena_array(blends->arena, nodes * ends, sizeof *fixed);
  free = ph_arena_array(blends->arena, nodes * inner_n, sizeof *free);
  inner = ph_arena_array(blends->arena, nodes * inner_n, sizeof *inner);
  elevate =
      ph_arena_array(blends->arena, height * (degree + 1), sizeof *elevate);
  hermite = ph_arena_array(blends->arena, (order + 1) * (degree + 1),
                           sizeof *hermite);
  if (!fixed || !free || !inner || !elevate || !hermite) {
    return false;
  }
  for (size_t i = 0; i < nodes; i++) {
    ph_bern_basis(degree, node_of(&blends->gauss, rule, i), basis);
    memcpy(fixed + ends * i, basis, (order + 1) * sizeof *basis);
    memcpy(fixed + ends * i + order + 1, basis + degree - order,
           (order + 1) * sizeof *basis);
    memcpy(inner + inner_n * i, basis + order + 1, inner_n * sizeof *basis);
  }
  for (size_t i = 0; i < height * (degree + 1); i++) {
    elevate[i] = ph_bern_elevate(height - 1, i % height, degree, i / height);
  }
  set_hermite(order, degree, hermite);
  *blend = (struct ph_blend){degree, fixed, free, inner, elevate, hermite};
  return invert(inner, &blends->gauss, nodes, inner_n, blends->arena, free);
}

const struct ph_blend *ph_blend_of(struct ph_blends *blends, size_t degree) {
  struct ph_blend *blend = &blends->of[degree];
  return blend->degree || make(blends, degree, blend) ? blend : NULL;
}

void ph_blend_fit(const struct ph_blend *blend, size_t continuity,
                  const double ends[2][PH_CROSS_MAX], const double *at,
                  double *c, double *miss) {
  const size_t n = continuity + 1, degree = blend->degree;
  const size_t nodes = ph_blend_nodes(ph_blend_rule(degree));
  const size_t inner = degree + 1 - 2 * n;
  ph_bern_contact(degree, ends[0], n, c, 1);
  ph_bern_contact(degree, ends[1], n, c + degree, -1);
  for (size_t i = 0; i < nodes; i++) {
    const double *row = blend->fixed + 2 * n * i;
    miss[i] = at[i];
    for (size_t j = 0; j < n; j++) {
      miss[i] -= row[j] * c[j] + row[n + j] * c[degree + 1 - n + j];
    }
  }
  memset(c + n, 0, inner * sizeof *c);
  for (size_t pass = 0; pass < 2; pass++) { /* the second for rounding */
    double change[PH_BLEND_MAX];
    for (size_t j = 0; j < inner; j++) {
      const double *row = blend->free + nodes * j;
      change[j] = 0;
      for (size_t i = 0; i < nodes; i++) {
        change[j] += row[i] * miss[i];
      }
      c[n + j] += change[j];
    }
    for (size_t i = 0; i < nodes; i++) {
      const double *row = blend->inner + inner * i;
      for (size_t j = 0; j < inner; j++) {
        miss[i] -= row[j] * change[j];
      }
    }
  }
}
