/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Places on pieces of loops (see loop_piece.h). */
#include "check/loop_piece.h"

#include "kernel/bern.h"

enum { N = PH_CHECK_SPOTS };

/* Lobatto's rule on [-1,1], of degree 13: the nodes above 0 and their weights.
 */
static const double LOBATTO[N / 2][2] = {
    {0.20929921790247886877, 0.41245879465870388157},
    {0.59170018143314230214, 0.34112269248350436476},
    {0.87174014850960661534, 0.21070422714350603938},
    {1, 1.0 / 28}};

/* The basis at the nodes. */
static void tabulate(size_t degree, struct ph_check_nodes *nodes) {
  for (size_t k = 0; k < N; k++) {
    double b[PH_CHECK_POINTS_MAX], lower[PH_CHECK_POINTS_MAX];
    ph_bern_basis(degree, nodes->node[k], b);
    ph_bern_basis(degree - 1, nodes->node[k], lower);
    for (size_t i = 0; i <= degree; i++) {
      nodes->basis[i][k] = b[i];
      nodes->slope[i][k] = (double)degree * ((i > 0 ? lower[i - 1] : 0) -
                                             (i < degree ? lower[i] : 0));
    }
  }
}

bool ph_check_nodes_of(size_t degree, struct ph_check_nodes *few,
                       struct ph_check_nodes *many) {
  struct ph_quad rule;
  if (!ph_quad_gauss(&rule, PH_CHECK_MANY * N / 2)) {
    return false;
  }
  for (size_t k = 0; k < N; k++) {
    const bool above = k >= N / 2;
    const double *row = LOBATTO[above ? k - N / 2 : N / 2 - 1 - k];
    few->node[k] = 0.5 * (above ? 1 + row[0] : 1 - row[0]);
    few->weight[k] = 0.5 * row[1];
  }
  tabulate(degree, few);
  for (size_t j = 0; j < PH_CHECK_MANY; j++) {
    const size_t half = j / (PH_CHECK_MANY / 2), first = j * N - half * rule.n;
    for (size_t k = 0; k < N; k++) {
      many[j].node[k] = 0.5 * ((double)half + rule.node[first + k]);
      many[j].weight[k] = 0.5 * rule.weight[first + k];
    }
    tabulate(degree, &many[j]);
  }
  return true;
}

void ph_check_piece_of(const struct ph_check *v,
                       const struct ph_loop_piece *piece, size_t degree,
                       struct ph_check_piece *out) {
  const double *p = piece->control_points, *w = piece->weights;
  const double n = (double)degree, to_first = 1 / w[0];
  double back;
  out->of = piece;
  out->degree = degree;
  out->first = out->last = ph_check_vector(v, p, 2);
  out->box = ph_boxtree_empty();
  for (size_t i = 0; i <= degree; i++) {
    out->last = ph_check_vector(v, p + 2 * i, 2);
    out->w[i] = w[i] * to_first;
    out->x[i] = out->w[i] * (out->last.x - out->first.x);
    out->y[i] = out->w[i] * (out->last.y - out->first.y);
    ph_boxtree_add(&out->box, out->last.x, out->last.y);
  }
  out->end[0] = ph_vec3_of(n * out->x[1], n * out->y[1], 0);
  back = n * w[degree - 1] / w[degree];
  out->end[1] = ph_vec3_scale(
      back,
      ph_vec3_sub(out->last, ph_check_vector(v, p + 2 * (degree - 1), 2)));
}

struct ph_check_spot ph_check_piece_at(const struct ph_check_piece *piece,
                                       double x) {
  const size_t n = piece->degree;
  double b[PH_CHECK_POINTS_MAX], lower[PH_CHECK_POINTS_MAX], w = 0, dw = 0;
  ph_vec3 sum = {0, 0, 0}, rate = {0, 0, 0};
  struct ph_check_spot at;
  ph_bern_basis(n, x, b);
  ph_bern_basis(n - 1, x, lower);
  for (size_t i = 0; i <= n; i++) {
    const ph_vec3 of = {piece->x[i], piece->y[i], 0};
    const double d =
        (double)n * ((i > 0 ? lower[i - 1] : 0) - (i < n ? lower[i] : 0));
    sum = ph_vec3_along(sum, b[i], of);
    rate = ph_vec3_along(rate, d, of);
    w += b[i] * piece->w[i];
    dw += d * piece->w[i];
  }
  sum = ph_vec3_scale(1 / w, sum);
  at.o = ph_vec3_add(piece->first, sum);
  at.d = ph_vec3_scale(1 / w, ph_vec3_along(rate, -dw, sum));
  return at;
}

/* De Casteljau's algorithm in the middle; c becomes the right half. */
static void cut(size_t degree, double *c, double *left) {
  for (size_t j = 0; j <= degree; j++) {
    left[j] = c[0];
    for (size_t i = 0; i + j < degree; i++) {
      c[i] = 0.5 * (c[i] + c[i + 1]);
    }
  }
}

void ph_check_piece_halve(const struct ph_check_piece *piece,
                          struct ph_check_piece half[2]) {
  half[0] = half[1] = *piece;
  cut(piece->degree, half[1].x, half[0].x);
  cut(piece->degree, half[1].y, half[0].y);
  cut(piece->degree, half[1].w, half[0].w);
}

/* sum over i of x[i] table[i], all nodes at once. */
static void sums(double table[][N], size_t degree, const double *x,
                 double *restrict sum) {
  double all[N];
  for (size_t k = 0; k < N; k++) {
    all[k] = table[0][k] * x[0];
  }
  for (size_t i = 1; i <= degree; i++) {
    const double *row = table[i], factor = x[i];
    for (size_t k = 0; k < N; k++) {
      all[k] += row[k] * factor;
    }
  }
  for (size_t k = 0; k < N; k++) {
    sum[k] = all[k];
  }
}

void ph_check_piece_spots(const struct ph_check_nodes *nodes,
                          const struct ph_check_piece *piece,
                          struct ph_check_spots *spots) {
  const size_t n = piece->degree;
  double w[N], dw[N];
  sums((double(*)[N])nodes->basis, n, piece->w, w);
  sums((double(*)[N])nodes->basis, n, piece->x, spots->x);
  sums((double(*)[N])nodes->basis, n, piece->y, spots->y);
  sums((double(*)[N])nodes->slope, n, piece->w, dw);
  sums((double(*)[N])nodes->slope, n, piece->x, spots->dx);
  sums((double(*)[N])nodes->slope, n, piece->y, spots->dy);
  for (size_t k = 0; k < N; k++) {
    const double over = 1 / w[k];
    spots->x[k] *= over;
    spots->y[k] *= over;
    spots->dx[k] = over * (spots->dx[k] - dw[k] * spots->x[k]);
    spots->dy[k] = over * (spots->dy[k] - dw[k] * spots->y[k]);
  }
}

/* De Casteljau's algorithm at all nodes at once: a point in each, and the
 * derivative. */
static void casteljau(double p[][N], size_t degree, const double *restrict u,
                      double *at, double *slope) {
  for (size_t n = degree; n > 1; n--) {
    for (size_t i = 0; i < n; i++) {
      double *restrict to = p[i];
      const double *restrict next = p[i + 1];
      for (size_t k = 0; k < N; k++) {
        to[k] += u[k] * (next[k] - to[k]);
      }
    }
  }
  for (size_t k = 0; k < N; k++) {
    slope[k] = (double)degree * (p[1][k] - p[0][k]);
    at[k] = p[0][k] + u[k] * (p[1][k] - p[0][k]);
  }
}

void ph_check_segment_spots(const struct ph_check *v,
                            const struct ph_check_nodes *nodes, size_t segment,
                            const double in[2], ph_vec3 origin,
                            struct ph_check_spots *spots) {
  const size_t degree = v->curve->degree;
  const double *p = ph_curve_points(v->curve, segment);
  double x[PH_CHECK_DEGREE_MAX + 1][N], y[PH_CHECK_DEGREE_MAX + 1][N], u[N];
  for (size_t i = 0; i <= degree; i++) {
    const ph_vec3 at = ph_check_vector(v, p + 2 * i, 2);
    for (size_t k = 0; k < N; k++) {
      x[i][k] = at.x - origin.x;
      y[i][k] = at.y - origin.y;
    }
  }
  for (size_t k = 0; k < N; k++) {
    u[k] = in[0] + nodes->node[k] * (in[1] - in[0]);
  }
  casteljau(x, degree, u, spots->x, spots->dx);
  casteljau(y, degree, u, spots->y, spots->dy);
}
