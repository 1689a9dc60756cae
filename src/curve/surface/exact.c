/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Patches as quotients (see exact.h). */
#include "curve/surface/exact.h"

#include "kernel/bern.h"

#include <string.h>

/* The corner of the face that is corner i of its patch. */
static const size_t FACE[] = {0, 1, 3, 2};

/* The corners opposite to the ends of a side, and those that the parameter
 * across leads from. */
static const size_t OPPOSITE[4][2] = {{2, 3}, {2, 3}, {1, 3}, {1, 3}};
static const size_t BASE[4][2] = {{0, 1}, {0, 1}, {0, 2}, {0, 2}};

/* The side of the face that is the side of its patch. */
static const size_t SIDE[] = {0, 2, 3, 1};

/* ---- corners ------------------------------------------------------------- */

/* The height around a corner by u and v away from it: f(b(u,v)) = 0, solved for
 * one coefficient after the other, on which f depends by g . g = 1 times it. */
static void set_jet(const struct ph_quadric *at, const ph_vec3 d[2][2],
                    const ph_vec3 n[2][2], size_t order,
                    double h[PH_CROSS_MAX][PH_CROSS_MAX]) {
  ph_vec3 b[PH_CROSS_MAX][PH_CROSS_MAX], Hb[PH_CROSS_MAX][PH_CROSS_MAX];
  for (size_t sum = 0; sum <= 2 * order; sum++) {
    for (size_t i = sum > order ? sum - order : 0; i <= order && i <= sum;
         i++) {
      const size_t j = sum - i;
      ph_vec3 x = i < 2 && j < 2 && sum > 0 ? d[i][j] : ph_vec3_of(0, 0, 0);
      double f;
      for (size_t k = 0; k < 4; k++) {
        const size_t p = k & 1, q = k >> 1;
        if (k > 0 && p <= i && q <= j) {
          x = ph_vec3_along(x, h[i - p][j - q], n[p][q]);
        }
      }
      f = ph_vec3_dot(at->g, x);
      for (size_t p = 0; p <= i; p++) {
        for (size_t q = 0; q <= j; q++) {
          if (p + q > 0 && p + q < sum) {
            f += ph_vec3_dot(b[p][q], Hb[i - p][j - q]) / 2;
          }
        }
      }
      h[i][j] = sum > 0 ? -f : 0;
      b[i][j] = ph_vec3_along(x, h[i][j], at->g);
      Hb[i][j] = ph_sym3_apply(&at->H, b[i][j]);
    }
  }
}

/* The same by u and v of the patch. */
static void set_corner(struct ph_exact_patch *patch, size_t corner) {
  const struct ph_quadric *c = patch->corner;
  const size_t u = corner ^ 1, v = corner ^ 2, far = corner ^ 3;
  double(*jet)[PH_CROSS_MAX] = patch->jet[corner];
  ph_vec3 d[2][2], n[2][2];
  d[0][0] = ph_vec3_of(0, 0, 0);
  d[1][0] = ph_vec3_sub(c[u].p, c[corner].p);
  d[0][1] = ph_vec3_sub(c[v].p, c[corner].p);
  d[1][1] = ph_vec3_sub(ph_vec3_sub(c[far].p, c[v].p), d[1][0]);
  n[0][0] = c[corner].g;
  n[1][0] = ph_vec3_sub(c[u].g, c[corner].g);
  n[0][1] = ph_vec3_sub(c[v].g, c[corner].g);
  n[1][1] = ph_vec3_sub(ph_vec3_sub(c[far].g, c[v].g), n[1][0]);
  set_jet(&c[corner], d, n, patch->continuity, jet);
  for (size_t i = 0; i <= patch->continuity; i++) {
    for (size_t j = 0; j <= patch->continuity; j++) {
      const size_t turns = i * (corner & 1) + j * (corner >> 1);
      jet[i][j] = turns % 2 ? -jet[i][j] : jet[i][j];
    }
  }
}

void ph_exact_begin(const struct ph_patchwork *work, size_t i,
                    struct ph_exact_patch *patch) {
  const struct ph_mesh *mesh = &work->mesh;
  const struct ph_quadric *c = patch->corner;
  const size_t *face = mesh->face[i];
  patch->continuity = work->continuity;
  for (size_t k = 0; k < 4; k++) {
    patch->corner[k] = work->at[face[FACE[k]]];
  }
  for (size_t k = 0; work->continuity > 0 && k < 4; k++) {
    const struct ph_ribbon *ribbon = &work->ribbons[mesh->side[i][SIDE[k]]];
    struct ph_side *side = &patch->side[k];
    if (face[FACE[ph_side_corner(k, 0)]] < face[FACE[ph_side_corner(k, 1)]]) {
      side->ribbon = *ribbon;
    } else {
      ph_ribbon_reverse(ribbon, work->continuity, &side->ribbon);
    }
    for (size_t j = 0; j < 2; j++) {
      const struct ph_quadric *from = &c[BASE[k][j]], *to = &c[OPPOSITE[k][j]];
      side->p[j] = c[ph_side_corner(k, j)].p;
      side->g[j] = c[ph_side_corner(k, j)].g;
      side->to[j] = ph_vec3_sub(to->p, from->p);
      side->turn[j] = ph_vec3_sub(to->g, from->g);
    }
    set_corner(patch, k);
  }
}

/* ---- places -------------------------------------------------------------- */

void ph_exact_rows_at(size_t continuity, double at,
                      struct ph_exact_rows *rows) {
  const size_t degree = 2 * continuity + 1;
  double taylor[PH_CROSS_MAX * 2 * PH_CROSS_MAX]; /* [k][degree + 1] */
  *rows = (struct ph_exact_rows){.at = at};
  if (continuity == 0) {
    return;
  }
  ph_ribbon_rows_at(continuity, at, 2, &rows->ribbon);
  memset(taylor, 0, sizeof taylor);
  ph_bern_taylor(degree, at, 2, taylor);
  for (size_t j = 0; j <= continuity; j++) {
    double a[PH_CROSS_MAX] = {0, 0, 0}, low[PH_CROSS_MAX];
    a[j] = 1;
    ph_bern_contact(degree, a, continuity + 1, low, 1);
    for (size_t k = 0; k < PH_CROSS_MAX; k++) {
      const double *row = taylor + k * (degree + 1);
      for (size_t i = 0; i <= continuity; i++) { /* the others are 0 */
        rows->hermite[0][j][k] += row[i] * low[i];
        rows->hermite[1][j][k] += (j % 2 ? -1 : 1) * row[degree - i] * low[i];
      }
    }
  }
}

void ph_exact_cross(const struct ph_exact_patch *patch, size_t d,
                    const struct ph_exact_rows *rows,
                    struct ph_cross cross[2]) {
  for (size_t k = 0; patch->continuity > 0 && k < 2; k++) {
    ph_side_at(&patch->side[2 * d + k], patch->continuity, &rows->ribbon, 2,
               &cross[k]);
  }
}

/* The Taylor coefficient of u^a v^b of the height. */
static double height_at(const struct ph_exact_patch *patch,
                        const struct ph_exact_rows *u,
                        const struct ph_cross by_u[2],
                        const struct ph_exact_rows *v,
                        const struct ph_cross by_v[2], size_t a, size_t b) {
  const size_t n = patch->continuity;
  double h = 0;
  for (size_t k = 0; k < 2; k++) {
    for (size_t j = 0; j <= n; j++) {
      h += v->hermite[k][j][b] * by_u[k].h[j][a] +
           u->hermite[k][j][a] * by_v[k].h[j][b];
    }
  }
  for (size_t corner = 0; corner < 4; corner++) {
    for (size_t i = 0; i <= n; i++) {
      for (size_t j = 0; j <= n; j++) {
        h -= u->hermite[corner & 1][i][a] * v->hermite[corner >> 1][j][b] *
             patch->jet[corner][i][j];
      }
    }
  }
  return h;
}

/* What is bilinear between corners, as Taylor coefficients [a][b]. */
static void bilinear(ph_vec3 c00, ph_vec3 c10, ph_vec3 c01, ph_vec3 c11,
                     double u, double v, ph_vec3 x[2][2]) {
  const ph_vec3 low = ph_vec3_sub(c10, c00), high = ph_vec3_sub(c11, c01);
  x[1][1] = ph_vec3_sub(high, low);
  x[1][0] = ph_vec3_along(low, v, x[1][1]);
  x[0][1] = ph_vec3_along(ph_vec3_sub(c01, c00), u, x[1][1]);
  /* exactly a corner there */
  x[0][0] = ph_vec3_along(
      ph_vec3_along(ph_vec3_along(ph_vec3_scale((1 - u) * (1 - v), c00),
                                  u * (1 - v), c10),
                    (1 - u) * v, c01),
      u * v, c11);
}

void ph_exact_jet_at(const struct ph_exact_patch *patch,
                     const struct ph_exact_rows *u,
                     const struct ph_cross by_u[2],
                     const struct ph_exact_rows *v,
                     const struct ph_cross by_v[2], struct ph_patch_jet *jet) {
  const struct ph_quadric *c = patch->corner;
  ph_vec3 d[2][2], n[2][2];
  ph_vec3 *to[PH_CROSS_MAX][PH_CROSS_MAX] = {{&jet->p, &jet->v, &jet->vv},
                                             {&jet->u, &jet->uv, NULL},
                                             {&jet->uu, NULL, NULL}};
  double h[PH_CROSS_MAX][PH_CROSS_MAX];
  bilinear(c[0].p, c[1].p, c[2].p, c[3].p, u->at, v->at, d);
  bilinear(c[0].g, c[1].g, c[2].g, c[3].g, u->at, v->at, n);
  for (size_t a = 0; a < PH_CROSS_MAX; a++) {
    for (size_t b = 0; a + b < PH_CROSS_MAX; b++) {
      ph_vec3 x = a < 2 && b < 2 ? d[a][b] : ph_vec3_of(0, 0, 0);
      h[a][b] =
          patch->continuity > 0 ? height_at(patch, u, by_u, v, by_v, a, b) : 0;
      for (size_t k = 0; k < 4; k++) {
        const size_t p = k & 1, q = k >> 1;
        if (p <= a && q <= b) {
          x = ph_vec3_along(x, h[a - p][b - q], n[p][q]);
        }
      }
      *to[a][b] = ph_vec3_scale(a == 2 || b == 2 ? 2 : 1, x);
    }
  }
}
