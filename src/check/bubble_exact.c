/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Exact patches (see bubble_exact.h). */
#include "check/bubble_exact.h"

#include <stdlib.h>
#include <string.h>

/* A normal is as long as 1 to this. */
static const double UNIT = 1e-12;

/* The corner of the patch that vertex k of a face is, and its side k. */
static const size_t CORNER[] = {0, 1, 3, 2}, SIDE[] = {0, 3, 1, 2};

/* Both ends of a side, and what is opposite to them. */
static const size_t ENDS[4][2] = {{0, 1}, {2, 3}, {0, 2}, {1, 3}};
static const size_t FROM[4][2] = {{0, 1}, {0, 1}, {0, 2}, {0, 2}};
static const size_t TO[4][2] = {{2, 3}, {2, 3}, {1, 3}, {1, 3}};

/* ---- power series -------------------------------------------------------- */

enum { TERMS = 5 };

struct series {
  double c[TERMS];
};

/* A vector of them; a symmetric matrix: xx, yy, zz, xy, xz, yz. */
struct vector {
  struct series x[3];
};
struct matrix {
  struct series x[6];
};

static const size_t ENTRY[3][3] = {{0, 3, 4}, {3, 1, 5}, {4, 5, 2}};

static struct series plus(struct series a, double factor, struct series b) {
  for (size_t k = 0; k < TERMS; k++) {
    a.c[k] += factor * b.c[k];
  }
  return a;
}

static struct series times(struct series a, struct series b) {
  struct series x = {{0}};
  for (size_t k = 0; k < TERMS; k++) {
    for (size_t i = 0; i <= k; i++) {
      x.c[k] += a.c[i] * b.c[k - i];
    }
  }
  return x;
}

static struct series over(struct series a, struct series b) {
  for (size_t k = 0; k < TERMS; k++) {
    for (size_t i = 0; i < k; i++) {
      a.c[k] -= a.c[i] * b.c[k - i];
    }
    a.c[k] /= b.c[0];
  }
  return a;
}

/* The derivative; the last term is lost. */
static struct series slope(struct series a) {
  for (size_t k = 0; k + 1 < TERMS; k++) {
    a.c[k] = (double)(k + 1) * a.c[k + 1];
  }
  a.c[TERMS - 1] = 0;
  return a;
}

static struct series dot(const struct vector *a, const struct vector *b) {
  const struct series x = times(a->x[0], b->x[0]);
  return plus(plus(x, 1, times(a->x[1], b->x[1])), 1, times(a->x[2], b->x[2]));
}

/* a + factor s b */
static struct vector along(const struct vector *a, double factor,
                           struct series s, const struct vector *b) {
  struct vector x;
  for (size_t i = 0; i < 3; i++) {
    x.x[i] = plus(a->x[i], factor, times(s, b->x[i]));
  }
  return x;
}

static struct vector apply(const struct matrix *m, const struct vector *a) {
  struct vector x;
  for (size_t i = 0; i < 3; i++) {
    x.x[i] = times(m->x[ENTRY[i][0]], a->x[0]);
    for (size_t j = 1; j < 3; j++) {
      x.x[i] = plus(x.x[i], 1, times(m->x[ENTRY[i][j]], a->x[j]));
    }
  }
  return x;
}

/* What is linear between two ends, about t. */
static struct vector between(const ph_vec3 *ends, double t) {
  const ph_vec3 a = ends[0], b = ends[1];
  const struct vector x = {{{{(1 - t) * a.x + t * b.x, b.x - a.x}},
                            {{(1 - t) * a.y + t * b.y, b.y - a.y}},
                            {{(1 - t) * a.z + t * b.z, b.z - a.z}}}};
  return x;
}

/* A Bernstein form about t: of what de Casteljau's algorithm leaves, the
 * differences of order k are derivatives. */
static struct series expand(const double *b, size_t degree, double t) {
  static const double difference[TERMS][TERMS] = {
      {1}, {-1, 1}, {1, -2, 1}, {-1, 3, -3, 1}, {1, -4, 6, -4, 1}};
  struct series x = {{0}};
  double c[PH_CHECK_HEIGHTS], choose[TERMS] = {1};
  for (size_t k = 1; k < TERMS && k <= degree; k++) {
    choose[k] = choose[k - 1] * (double)(degree + 1 - k) / (double)k;
  }
  memcpy(c, b, (degree + 1) * sizeof *c);
  for (size_t left = degree;; left--) {
    for (size_t i = 0; left < TERMS && i <= left; i++) {
      x.c[left] += choose[left] * difference[left][i] * c[i];
    }
    if (left == 0) {
      return x;
    }
    for (size_t i = 0; i < left; i++) {
      c[i] = (1 - t) * c[i] + t * c[i + 1];
    }
  }
}

/* ---- sides --------------------------------------------------------------- */

/* (6.19): the Hessian that agrees with the change of the gradient. */
static struct matrix complete(const struct ph_check_strip *s, double t,
                              const struct vector *g, const struct vector *q) {
  const struct series one = {{1}}, square = over(one, dot(q, q));
  struct matrix H;
  struct vector r;
  struct series rest;
  for (size_t i = 0; i < 6; i++) {
    H.x[i] = expand(s->hessian[i], PH_CHECK_HESSIANS - 1, t);
  }
  r = apply(&H, q);
  for (size_t i = 0; i < 3; i++) {
    r.x[i] = plus(slope(g->x[i]), -1, r.x[i]);
  }
  rest = times(times(dot(q, &r), square), square);
  for (size_t i = 0; i < 3; i++) {
    for (size_t j = i; j < 3; j++) {
      struct series *x = &H.x[ENTRY[i][j]];
      const struct series both =
          plus(times(r.x[i], q->x[j]), 1, times(q->x[i], r.x[j]));
      *x = plus(*x, 1, times(both, square));
      *x = plus(*x, -1, times(rest, times(q->x[i], q->x[j])));
    }
  }
  return H;
}

static void set_cross(const struct ph_check_strip *s, size_t continuity,
                      double t, struct ph_check_cross *cross) {
  const size_t gradients = 4 * continuity - 1;
  const struct series h = expand(s->height, 4 * continuity + 1, t);
  const struct vector n = between(s->g, t), d = between(s->to, t);
  const struct vector e = between(s->turn, t), edge = between(s->p, t);
  const struct vector p = along(&edge, 1, h, &n);
  struct vector q, g, b;
  struct series gn, ge, hw, hww = {{0}};
  for (size_t i = 0; i < 3; i++) {
    q.x[i] = slope(p.x[i]);
    g.x[i] = expand(s->gradient[i], gradients, t);
  }
  g = along(&g, -1, over(dot(&g, &q), dot(&q, &q)), &q);
  gn = dot(&g, &n);
  ge = dot(&g, &e);
  hw = over(plus(dot(&g, &d), 1, times(h, ge)), gn);
  hw = plus((struct series){{0}}, -1, hw);
  if (continuity == 2) {
    const struct matrix H = complete(s, t, &g, &q);
    struct vector Hb;
    b = along(&d, 1, hw, &n);
    b = along(&b, 1, h, &e);
    Hb = apply(&H, &b);
    hww = over(plus(dot(&b, &Hb), 2, times(hw, ge)), gn);
  }
  for (size_t k = 0; k < PH_CHECK_ORDERS; k++) {
    cross->h[0][k] = h.c[k];
    cross->h[1][k] = hw.c[k];
    cross->h[2][k] = -hww.c[k] / 2;
  }
}

void ph_check_quotient_cross(const struct ph_check_quotient *patch, size_t side,
                             double t, struct ph_check_cross *cross) {
  if (patch->continuity > 0) {
    set_cross(&patch->side[side], patch->continuity, t, cross);
  }
}

/* ---- patches ------------------------------------------------------------- */

/* The coefficients of an edge, from end 0 of the side on. */
static void set_strip(const struct ph_check *v,
                      const struct ph_patch_strip *from, bool back,
                      struct ph_check_strip *to) {
  for (size_t i = 0; i < from->height_n; i++) {
    const size_t k = back ? from->height_n - 1 - i : i;
    to->height[i] = ph_check_scaled(v, from->height[k]);
  }
  for (size_t i = 0; i < from->gradient_n; i++) {
    const size_t k = back ? from->gradient_n - 1 - i : i;
    for (size_t j = 0; j < 3; j++) {
      to->gradient[j][i] = from->gradient[3 * k + j];
    }
  }
  for (size_t i = 0; i < from->hessian_n; i++) {
    const size_t k = back ? from->hessian_n - 1 - i : i;
    for (size_t j = 0; j < 6; j++) {
      to->hessian[j][i] = ph_check_unscaled(v, from->hessian[6 * k + j]);
    }
  }
}

void ph_check_quotient_begin(const struct ph_check_patchwork *w, size_t i,
                             struct ph_check_quotient *patch) {
  const struct ph_surface *s = &w->curve->surface;
  const struct ph_patch *p = &s->patches[i];
  patch->continuity = s->continuity;
  for (size_t k = 0; k < 4; k++) {
    const struct ph_patch_vertex *at = &s->vertices[p->vertices[k]];
    patch->p[CORNER[k]] = ph_check_vector(w->v, at->point, 3);
    patch->g[CORNER[k]] = ph_vec3_get(at->normal, 3);
  }
  for (size_t k = 0; k < 4 && s->continuity > 0; k++) {
    const struct ph_patch_edge *edge = &s->edges.v[w->edges[4 * i + k]];
    const size_t side = SIDE[k];
    struct ph_check_strip *to = &patch->side[side];
    /* sides 1 and 2 run against the face */
    const size_t start = p->vertices[k < 2 ? k : (k + 1) % 4];
    set_strip(w->v, &edge->strip, start != edge->vertices[0], to);
    for (size_t j = 0; j < 2; j++) {
      const size_t from = FROM[side][j], over_there = TO[side][j];
      to->p[j] = patch->p[ENDS[side][j]];
      to->g[j] = patch->g[ENDS[side][j]];
      to->to[j] = ph_vec3_sub(patch->p[over_there], patch->p[from]);
      to->turn[j] = ph_vec3_sub(patch->g[over_there], patch->g[from]);
    }
    set_cross(to, s->continuity, 0, &to->end[0]);
    set_cross(to, s->continuity, 1, &to->end[1]);
  }
}

/* ---- places -------------------------------------------------------------- */

/* a^j b^(n+1) sum_i binomial(n+i, i) a^i, i to n - j, with a + b = 1. */
static struct series hermite(size_t n, size_t j, struct series a,
                             struct series b) {
  struct series sum = {{0}}, power = {{1}};
  double choose = 1;
  for (size_t i = 0; i + j <= n; i++) {
    sum = plus(sum, choose, power);
    power = times(power, a);
    choose = choose * (double)(n + i + 1) / (double)(i + 1);
  }
  for (size_t i = 0; i < j; i++) {
    sum = times(sum, a);
  }
  for (size_t i = 0; i <= n; i++) {
    sum = times(sum, b);
  }
  return sum;
}

void ph_check_node_at(size_t continuity, double t, struct ph_check_node *node) {
  const struct series a = {{t, 1}}, b = {{1 - t, -1}};
  *node = (struct ph_check_node){.t = t};
  for (size_t j = 0; j <= continuity; j++) {
    const struct series low = hermite(continuity, j, a, b);
    const struct series high = hermite(continuity, j, b, a);
    for (size_t k = 0; k < PH_CHECK_ORDERS; k++) {
      node->hermite[0][j][k] = low.c[k];
      node->hermite[1][j][k] = j % 2 ? -high.c[k] : high.c[k];
    }
  }
}

/* The Taylor coefficient of u^a v^b of the Coons patch. */
static double
height_of(const struct ph_check_quotient *x, const struct ph_check_node *u,
          const struct ph_check_cross by_u[2], const struct ph_check_node *v,
          const struct ph_check_cross by_v[2], size_t a, size_t b) {
  double h = 0;
  if (x->continuity == 0) {
    return 0;
  }
  for (size_t k = 0; k < 2; k++) {
    for (size_t j = 0; j <= x->continuity; j++) {
      double there = by_u[k].h[j][a]; /* less what the other sides have of it */
      for (size_t l = 0; l < 2; l++) {
        for (size_t i = 0; i <= x->continuity; i++) {
          there -= u->hermite[l][i][a] * x->side[k].end[l].h[j][i];
        }
      }
      h += v->hermite[k][j][b] * there + u->hermite[k][j][a] * by_v[k].h[j][b];
    }
  }
  return h;
}

/* Taylor coefficients of what is bilinear between corners. */
static void bilinear(const ph_vec3 c[4], double u, double v, ph_vec3 x[2][2]) {
  const ph_vec3 low = ph_vec3_along(ph_vec3_scale(1 - u, c[0]), u, c[1]);
  const ph_vec3 high = ph_vec3_along(ph_vec3_scale(1 - u, c[2]), u, c[3]);
  const ph_vec3 south = ph_vec3_sub(c[1], c[0]);
  const ph_vec3 north = ph_vec3_sub(c[3], c[2]);
  x[0][0] = ph_vec3_along(ph_vec3_scale(1 - v, low), v, high);
  x[1][0] = ph_vec3_along(ph_vec3_scale(1 - v, south), v, north);
  x[0][1] = ph_vec3_sub(high, low);
  x[1][1] = ph_vec3_sub(north, south);
}

void ph_check_quotient_at(const struct ph_check_quotient *patch,
                          const struct ph_check_node *u,
                          const struct ph_check_cross by_u[2],
                          const struct ph_check_node *v,
                          const struct ph_check_cross by_v[2],
                          struct ph_check_place *place) {
  double h[PH_CHECK_ORDERS][PH_CHECK_ORDERS];
  ph_vec3 d[2][2], n[2][2];
  bilinear(patch->p, u->t, v->t, d);
  bilinear(patch->g, u->t, v->t, n);
  for (size_t a = 0; a < PH_CHECK_ORDERS; a++) {
    for (size_t b = 0; a + b < PH_CHECK_ORDERS; b++) {
      ph_vec3 x = a < 2 && b < 2 ? d[a][b] : ph_vec3_of(0, 0, 0);
      h[a][b] = height_of(patch, u, by_u, v, by_v, a, b);
      for (size_t i = 0; i <= a && i < 2; i++) {
        for (size_t j = 0; j <= b && j < 2; j++) {
          x = ph_vec3_along(x, h[a - i][b - j], n[i][j]);
        }
      }
      place->x[a][b] = ph_vec3_scale(a == 2 || b == 2 ? 2 : 1, x);
    }
  }
}

void ph_check_quotient_place(const struct ph_check_quotient *patch, double u,
                             double v, struct ph_check_place *place) {
  const double at[] = {u, v};
  struct ph_check_node node[2];
  struct ph_check_cross cross[2][2];
  for (size_t d = 0; d < 2; d++) {
    ph_check_node_at(patch->continuity, at[d], &node[d]);
    for (size_t k = 0; k < 2; k++) {
      ph_check_quotient_cross(patch, 2 * d + k, at[d], &cross[d][k]);
    }
  }
  ph_check_quotient_at(patch, &node[0], (const struct ph_check_cross *)cross[0],
                       &node[1], (const struct ph_check_cross *)cross[1],
                       place);
}

/* ---- records ------------------------------------------------------------- */

/* An edge of the record, and its points in order. */
struct key {
  size_t low, high, edge;
};

static int by_points(const void *left, const void *right) {
  const struct key *a = left, *b = right;
  return a->low != b->low     ? (a->low > b->low) - (a->low < b->low)
         : a->high != b->high ? (a->high > b->high) - (a->high < b->high)
                              : (a->edge > b->edge) - (a->edge < b->edge);
}

static bool wrong(struct ph_check_patchwork *w, const char *list, size_t i,
                  const char *member, const char *what) {
  ph_check_wrong(w->v, PH_CHECK_SHAPE, ph_check_of(list, i, member), what);
  return false;
}

static bool check_strips(struct ph_check_patchwork *w) {
  const struct ph_surface *s = &w->curve->surface;
  const size_t n = s->continuity;
  for (size_t i = 0; n > 0 && i < s->edges.n; i++) {
    const struct ph_patch_strip *strip = &s->edges.v[i].strip;
    if (strip->height_n != 4 * n + 2 || strip->gradient_n != 4 * n ||
        strip->hessian_n != (n == 2 ? PH_CHECK_HESSIANS : 0)) {
      return wrong(w, "edges", i, "strip", "has not what the continuity asks");
    }
    if (!ph_are_finite(strip->height, strip->height_n) ||
        !ph_are_finite(strip->gradient, 3 * strip->gradient_n) ||
        !ph_are_finite(strip->hessian, 6 * strip->hessian_n)) {
      if (w->v->error) {
        w->v->status = ph_fail_at(w->v->diag, PH_E_TOO_LARGE, "edges", i,
                                  "holds what is not finite");
        return false;
      }
      return wrong(w, "edges", i, "strip", "holds what is not finite");
    }
  }
  return true;
}

static bool check_vertices(struct ph_check_patchwork *w) {
  const struct ph_surface *s = &w->curve->surface;
  if (s->vertices_n == 0) {
    return wrong(w, NULL, PH_CHECK_ONE, "vertices",
                 "are missing, which a surface without control points needs");
  }
  for (size_t i = 0; i < s->vertices_n; i++) {
    const struct ph_patch_vertex *at = &s->vertices[i];
    const double length = ph_vec3_abs(ph_vec3_get(at->normal, 3));
    if (!ph_are_finite(at->point, 3) || !ph_are_finite(at->normal, 3)) {
      return wrong(w, "vertices", i, NULL, "holds what is not finite");
    }
    if (!(fabs(length - 1) <= UNIT)) {
      return wrong(w, "vertices", i, "normal", "is not a unit vector");
    }
  }
  for (size_t i = 0; i < 4 * w->curve->n; i++) {
    if (s->patches[i / 4].vertices[i % 4] >= s->vertices_n) {
      return wrong(w, "patches", i / 4, "vertices", "are not in the record");
    }
  }
  return true;
}

/* Each side finds its edge: both are in the order of their points. */
static bool find_edges(struct ph_check_patchwork *w, const struct key *keys,
                       size_t n) {
  for (size_t i = 0, k = 0; i < 4 * w->curve->n; i++) {
    const struct ph_check_side *side = &w->sides[i];
    while (k < n && (keys[k].low < side->low ||
                     (keys[k].low == side->low && keys[k].high < side->high))) {
      k++;
    }
    if (k == n || keys[k].low != side->low || keys[k].high != side->high) {
      return wrong(w, "patches", side->patch, "vertices",
                   "have an edge that is not in the record");
    }
    w->edges[4 * side->patch + side->k] = keys[k].edge;
  }
  return true;
}

enum ph_status ph_check_patch_strips(struct ph_check_patchwork *w, bool *good) {
  const struct ph_patch_edges *edges = &w->curve->surface.edges;
  struct key *keys = ph_arena_array(w->v->scratch, edges->n, sizeof *keys);
  w->edges = ph_arena_array(w->v->scratch, 4 * w->curve->n, sizeof *w->edges);
  if (!keys || !w->edges) {
    return ph_fail_memory(w->v->diag);
  }
  for (size_t i = 0; i < edges->n; i++) {
    const size_t a = edges->v[i].vertices[0], b = edges->v[i].vertices[1];
    keys[i] = (struct key){a < b ? a : b, a < b ? b : a, i};
  }
  qsort(keys, edges->n, sizeof *keys, by_points);
  *good = check_vertices(w) && check_strips(w) && find_edges(w, keys, edges->n);
  return PH_OK;
}
