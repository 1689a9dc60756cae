/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Exact gradients of energies (see planar.h), by the adjoint of the C2
 * equations: O(n) for all n variables.
 *
 * With p the angles and spacings, F(b,p) = 0 and J(b,p) the functional,
 *
 *   dJ = J_p dp - Re(x^T F_p) dp,   F_b^T x = J_b                        (1)
 *
 * where real functions of complex z have derivatives c with dJ = Re(c dz). Both
 * J and F depend on b and the weights y by w at the knots (c2.h), on h
 * by W = sqrt(h) w and the factor h of F, and on the angle by the functions
 * of its space (kernel/atph.h).
 */
#include "solve/planar/planar.h"

#include <math.h>

enum ph_status ph_planar_gradient_alloc(struct ph_planar_gradient *g,
                                        const struct ph_planar_data *d,
                                        struct ph_arena *arena,
                                        struct ph_diag *diag) {
  size_t n = d->n, unknowns = ph_planar_unknowns(&d->c2);
  g->by_w = ph_arena_array(arena, n, 3 * sizeof *g->by_w);
  g->equation = ph_arena_array(arena, n, sizeof *g->equation);
  g->by_b = ph_arena_array(arena, unknowns, sizeof *g->by_b);
  g->adjoint = ph_arena_array(arena, unknowns, sizeof *g->adjoint);
  g->by_y = ph_arena_array(arena, n + 1, sizeof *g->by_y);
  g->by_angle = ph_arena_array(arena, n, sizeof *g->by_angle);
  g->by_h = ph_arena_array(arena, n, sizeof *g->by_h);
  return g->by_w && g->equation && g->by_b && g->adjoint && g->by_y &&
                 g->by_angle && g->by_h &&
                 ph_tri_alloc(&g->tri, arena, unknowns) &&
                 ph_pieces_rules(g->rule)
             ? PH_OK
             : ph_fail_memory(diag);
}

/*
 * Derivatives of weight . (kappa^2 |z|^2, (dkappa/du)^2 / |z|^2, |z|^2) with
 * respect to z = w(u), z', z''.  With s = |z|^2, a = Im(conj(z) z'),
 * r = Re(conj(z) z'), a1 = Im(conj(z) z''):
 *   kappa = 2 a / s^2,  dkappa/du = 2 a1 / s^2 - 8 a r / s^3
 */
static void by_jet(const ph_cplx z[3], const double weight[3], ph_cplx c[3]) {
  const ph_cplx i = {0, 1};
  double s = ph_cplx_norm2(z[0]), s2 = s * s, s3 = s2 * s;
  double a = ph_cplx_cross(z[0], z[1]), r = ph_cplx_dot(z[0], z[1]);
  double a1 = ph_cplx_cross(z[0], z[2]);
  double slope = 2 * a1 / s2 - 8 * a * r / s3;
  double by_slope = 2 * weight[1] * slope / s;
  double by_s = -12 * weight[0] * a * a / (s2 * s2) -
                weight[1] * slope * slope / s2 + weight[2] +
                by_slope * (24 * a * r / s - 4 * a1) / s3;
  double by_a = 8 * weight[0] * a / s3 - 8 * by_slope * r / s3;
  double by_r = -8 * by_slope * a / s3, by_a1 = 2 * by_slope / s2;
  ph_cplx z0 = ph_cplx_conj(z[0]), z1 = ph_cplx_conj(z[1]);
  ph_cplx turned = ph_cplx_add(ph_cplx_scale(by_a, z1),
                               ph_cplx_scale(by_a1, ph_cplx_conj(z[2])));
  c[0] = ph_cplx_add(ph_cplx_scale(2 * by_s, z0), ph_cplx_scale(by_r, z1));
  c[0] = ph_cplx_add(c[0], ph_cplx_mul(i, turned));
  c[1] = ph_cplx_mul(ph_cplx_of(by_r, -by_a), z0);
  c[2] = ph_cplx_mul(ph_cplx_of(0, -by_a1), z0);
}

/* What one node adds to the derivatives of segment k by w; c <- those of the
 * integrand by w, w', w'' there. */
static void add_node(struct ph_planar_gradient *g, size_t k,
                     const struct ph_atph_table *table, const ph_cplx w[3],
                     double part, const double weight[3], ph_cplx z[3],
                     ph_cplx c[3]) {
  ph_cplx *sum = &g->by_w[3 * k];
  for (size_t d = 0; d < 3; d++) {
    const double *b = table->b[d];
    z[d].re = b[0] * w[0].re + b[1] * w[1].re + b[2] * w[2].re;
    z[d].im = b[0] * w[0].im + b[1] * w[1].im + b[2] * w[2].im;
  }
  by_jet(z, weight, c);
  for (size_t i = 0; i < 3; i++) {
    const double b[3] = {table->b[0][i], table->b[1][i], table->b[2][i]};
    sum[i].re += part * (b[0] * c[0].re + b[1] * c[1].re + b[2] * c[2].re);
    sum[i].im += part * (b[0] * c[0].im + b[1] * c[1].im + b[2] * c[2].im);
  }
}

/* What the angle changes there. */
static void add_change(struct ph_planar_gradient *g, size_t k,
                       const struct ph_atph_table *table, const ph_cplx w[3],
                       double part, const ph_cplx z[3], const ph_cplx c[3]) {
  ph_cplx change[3];
  for (size_t d = 0; d < 3; d++) {
    const double *b = table->change[d];
    change[d].re = b[0] * w[0].re + b[1] * w[1].re + b[2] * w[2].re;
    change[d].im = b[0] * w[0].im + b[1] * w[1].im + b[2] * w[2].im;
    g->by_angle[k] += part * ph_cplx_mul(c[d], change[d]).re;
  }
  g->equation[k] = ph_cplx_add(
      g->equation[k], ph_cplx_scale(2 * part, ph_cplx_mul(z[0], change[0])));
}

static void integrate(struct ph_planar_gradient *g, size_t k,
                      const struct ph_seg2 *seg, const struct ph_piece *piece,
                      const double weight[3]) {
  const struct ph_quad *rule = &g->rule[piece->rule];
  const double step = piece->to - piece->from;
  for (size_t i = 0; i < rule->n; i++) {
    const double u = piece->from + step * rule->node[i];
    const double part = step * rule->weight[i];
    const struct ph_atph_table table = ph_atph_table_of(&seg->space, u);
    ph_cplx z[3], c[3];
    add_node(g, k, &table, seg->w, part, weight, z, c);
    if (seg->space.angle > 0) {
      add_change(g, k, &table, seg->w, part, z, c);
    }
  }
}

/* Derivatives of segment k's functional, and of its equation, by themselves. */
static void differentiate(struct ph_planar_gradient *g,
                          const struct ph_planar_data *d, const ph_cplx *b,
                          size_t k, const double weight[3]) {
  struct ph_seg2 seg = {*ph_planar_space(&d->c2, k), {{0, 0}}, {0, 0}, {0, 0}};
  struct ph_piece piece[PH_PIECES_MAX];
  const double root = sqrt(d->h[k]);
  size_t n;
  ph_planar_preimage(&d->c2, b, k, seg.w);
  for (size_t i = 0; i < 3; i++) {
    seg.w[i] = ph_cplx_scale(root, seg.w[i]);
    g->by_w[3 * k + i] = ph_cplx_of(0, 0);
  }
  g->equation[k] = ph_cplx_of(0, 0);
  g->by_angle[k] = g->by_h[k] = 0;
  n = ph_pieces_of(&seg, piece);
  for (size_t p = 0; p < n; p++) {
    integrate(g, k, &seg, &piece[p], weight);
  }
  g->equation[k] = ph_cplx_scale(1 / d->chord[k], g->equation[k]);
  for (size_t i = 0; i < 3; i++) { /* dW = W/2 dh/h */
    g->by_h[k] += 0.5 * ph_cplx_mul(g->by_w[3 * k + i], seg.w[i]).re;
    g->by_w[3 * k + i] = ph_cplx_scale(root, g->by_w[3 * k + i]);
  }
}

static void add_to(ph_cplx *sum, double factor, ph_cplx z) {
  *sum = ph_cplx_add(*sum, ph_cplx_scale(factor, z));
}

/* J_b from the derivatives by w. */
static void gather(struct ph_planar_gradient *g,
                   const struct ph_planar_data *d) {
  const struct ph_planar_c2 *c2 = &d->c2;
  size_t n = d->n, unknowns = ph_planar_unknowns(c2);
  for (size_t i = 0; i < unknowns; i++) {
    g->by_b[i] = ph_cplx_of(0, 0);
  }
  for (size_t k = 0; k < n; k++) {
    const ph_cplx *by_w = g->by_w + 3 * k;
    size_t here = c2->closed ? k : k + 1;
    size_t before = (here + unknowns - 1) % unknowns;
    size_t after = (here + 1) % unknowns;
    double left = c2->y[k], right = c2->y[k + 1];
    ph_cplx first = by_w[0], last = by_w[2];
    add_to(&g->by_b[here], 1 - left, first);
    add_to(&g->by_b[here], 1, by_w[1]);
    add_to(&g->by_b[here], right, last);
    if (c2->closed && k == 0) {
      first = ph_cplx_mul(ph_cplx_conj(c2->twist), first);
    }
    if (c2->closed && k + 1 == n) {
      last = ph_cplx_mul(c2->twist, last);
    }
    add_to(&g->by_b[before], left, first);
    add_to(&g->by_b[after], 1 - right, last);
  }
}

/* Adds -Re(x^T F_p) for segment k's equation, and what its weights do. */
static void add_equation(struct ph_planar_gradient *g,
                         const struct ph_planar_data *d, const ph_cplx *b,
                         size_t k) {
  const struct ph_planar_c2 *c2 = &d->c2;
  size_t n = ph_planar_unknowns(c2), here = c2->closed ? k : k + 1;
  ph_cplx x = g->adjoint[here], w[3], by_w[3];
  ph_cplx before = b[(here + n - 1) % n], after = b[(here + 1) % n];
  if (c2->closed && k == 0) {
    before = ph_cplx_mul(ph_cplx_conj(c2->twist), before);
  }
  if (c2->closed && k + 1 == d->n) {
    after = ph_cplx_mul(c2->twist, after);
  }
  ph_planar_preimage(c2, b, k, w);
  ph_planar_c2_gradient(c2, k, w, by_w);
  for (size_t i = 0; i < 3; i++) {
    by_w[i] = ph_cplx_sub(g->by_w[3 * k + i], ph_cplx_mul(x, by_w[i]));
  }
  g->by_h[k] -= ph_cplx_mul(x, c2->direction[k]).re; /* F = h (...) - c/|c| */
  g->by_angle[k] -= ph_cplx_mul(x, g->equation[k]).re;
  g->by_y[k] += ph_cplx_mul(by_w[0], ph_cplx_sub(before, b[here])).re;
  g->by_y[k + 1] += ph_cplx_mul(by_w[2], ph_cplx_sub(b[here], after)).re;
}

/* The weight between two segments, from their slopes and spacings. */
static void add_weight(struct ph_planar_gradient *g,
                       const struct ph_planar_data *d, size_t knot) {
  double y = d->c2.y[knot], change = g->by_y[knot] * y * (1 - y);
  size_t left = knot > 0 ? knot - 1 : d->n - 1;
  g->by_h[left] -= change;
  g->by_h[knot] += change;
  g->by_angle[left] +=
      change * ph_atph_slope_change(ph_planar_space(&d->c2, left));
  g->by_angle[knot] -=
      change * ph_atph_slope_change(ph_planar_space(&d->c2, knot));
}

/* End derivatives by rule depend on two spacings; F = (w^2 - d)/|d|. */
static void add_end(struct ph_planar_gradient *g,
                    const struct ph_planar_data *d, int side) {
  ph_cplx change[2], x = g->adjoint[side ? d->n + 1 : 0];
  size_t near = side ? d->n - 1 : 0;
  size_t far = d->n == 1 ? near : side ? near - 1 : 1;
  ph_planar_ends_change(d, side, change);
  g->by_h[near] += ph_cplx_mul(x, change[0]).re / d->c2.end_size[side];
  g->by_h[far] += ph_cplx_mul(x, change[1]).re / d->c2.end_size[side];
}

void ph_planar_gradient_of(struct ph_planar_gradient *g,
                           const struct ph_planar_data *d, const ph_cplx *b,
                           const double weight[3]) {
  size_t n = d->n;
  for (size_t k = 0; k < n; k++) {
    differentiate(g, d, b, k, weight);
    g->by_y[k] = 0;
  }
  g->by_y[n] = 0;
  gather(g, d);
  ph_planar_c2_adjoint(&d->c2, b, g->by_b, &g->tri, g->adjoint);
  for (size_t k = 0; k < n; k++) {
    add_equation(g, d, b, k);
  }
  if (d->closed) {
    g->by_y[0] += g->by_y[n];
    add_weight(g, d, 0);
  }
  for (size_t k = 1; k < n; k++) {
    add_weight(g, d, k);
  }
  for (int side = 0; side < 2 && !d->closed && !d->ends; side++) {
    add_end(g, d, side);
  }
}
