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
 * What z'' adds is left out where MV has no weight.
 */
static void by_jet(const ph_cplx z[3], const double weight[3], ph_cplx c[3]) {
  const double q = 1 / ph_cplx_norm2(z[0]), q2 = q * q, q3 = q2 * q;
  const double a = ph_cplx_cross(z[0], z[1]), bend = a * q2;
  double by_s = weight[2] - 12 * weight[0] * bend * bend;
  double by_a = 8 * weight[0] * a * q3, by_r = 0;
  c[2] = ph_cplx_of(0, 0);
  if (fabs(weight[1]) > 0) {
    const double r = ph_cplx_dot(z[0], z[1]), a1 = ph_cplx_cross(z[0], z[2]);
    const double slope = 2 * q2 * (a1 - 4 * a * r * q);
    const double by_slope = 2 * weight[1] * slope * q,
                 by_a1 = 2 * by_slope * q2;
    by_s += (24 * a * r * q - 4 * a1) * by_slope * q3;
    by_s -= weight[1] * slope * slope * q2;
    by_a -= 8 * by_slope * r * q3;
    by_r = -8 * by_slope * a * q3;
    c[2] = ph_cplx_of(-by_a1 * z[0].im, -by_a1 * z[0].re);
    c[0] = ph_cplx_of(by_a1 * z[2].im, by_a1 * z[2].re);
  } else {
    c[0] = c[2];
  }
  c[0].re += 2 * by_s * z[0].re + by_r * z[1].re + by_a * z[1].im;
  c[0].im += by_a * z[1].re - by_r * z[1].im - 2 * by_s * z[0].im;
  c[1] = ph_cplx_of(by_r * z[0].re - by_a * z[0].im,
                    -by_a * z[0].re - by_r * z[0].im);
}

static void add_to(ph_cplx *sum, double factor, ph_cplx z) {
  sum->re += factor * z.re;
  sum->im += factor * z.im;
}

/* What the angle changes at a node. */
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
  add_to(&g->equation[k], 2 * part, ph_cplx_mul(z[0], change[0]));
}

/* What a node adds to the derivatives of segment k by w, and by its angle. */
static void add_node(struct ph_planar_gradient *g, size_t k,
                     const struct ph_seg2 *seg, double u, double part,
                     const double weight[3]) {
  const struct ph_atph_table table = ph_atph_table_of(&seg->space, u);
  const ph_cplx *w = seg->w;
  ph_cplx z[3], c[3], *sum = &g->by_w[3 * k];
  for (size_t d = 0; d < 3; d++) {
    const double *b = table.b[d];
    z[d].re = b[0] * w[0].re + b[1] * w[1].re + b[2] * w[2].re;
    z[d].im = b[0] * w[0].im + b[1] * w[1].im + b[2] * w[2].im;
  }
  by_jet(z, weight, c);
  for (size_t i = 0; i < 3; i++) {
    for (size_t d = 0; d < 3; d++) {
      add_to(&sum[i], part * table.b[d][i], c[d]);
    }
  }
  add_change(g, k, &table, w, part, z, c);
}

static void integrate(struct ph_planar_gradient *g, size_t k,
                      const struct ph_seg2 *seg, const struct ph_piece *piece,
                      const double weight[3]) {
  const struct ph_quad *rule = &g->rule[piece->rule];
  const double step = piece->to - piece->from;
  for (size_t i = 0; i < rule->n; i++) {
    add_node(g, k, seg, piece->from + step * rule->node[i],
             step * rule->weight[i], weight);
  }
}

/* The same of a PH segment: its w' goes from one difference of its w[i] to the
 * other, and w'' is the difference of these. */
static void integrate_ph(struct ph_planar_gradient *g, size_t k,
                         const struct ph_seg2 *seg,
                         const struct ph_piece *piece, const double weight[3]) {
  const struct ph_quad *rule = &g->rule[piece->rule];
  const double step = piece->to - piece->from;
  const ph_cplx *w = seg->w;
  const ph_cplx first = ph_cplx_scale(2, ph_cplx_sub(w[1], w[0]));
  const ph_cplx last = ph_cplx_scale(2, ph_cplx_sub(w[2], w[1]));
  ph_cplx z[3], by[3] = {{0, 0}}, at_0 = {0, 0}, at_1 = {0, 0}, second = {0, 0};
  z[2] = ph_cplx_sub(last, first);
  for (size_t i = 0; i < rule->n; i++) {
    const double u = piece->from + step * rule->node[i], v = 1 - u;
    const double part = step * rule->weight[i];
    const double b[3] = {v * v, 2 * u * v, u * u};
    ph_cplx c[3];
    z[0] = ph_cplx_of(b[0] * w[0].re + b[1] * w[1].re + b[2] * w[2].re,
                      b[0] * w[0].im + b[1] * w[1].im + b[2] * w[2].im);
    z[1] = ph_cplx_of(v * first.re + u * last.re, v * first.im + u * last.im);
    by_jet(z, weight, c);
    for (size_t j = 0; j < 3; j++) {
      add_to(&by[j], part * b[j], c[0]);
    }
    add_to(&at_0, part * v, c[1]);
    add_to(&at_1, part * u, c[1]);
    add_to(&second, part, c[2]);
  }
  at_0 = ph_cplx_sub(at_0, second);
  at_1 = ph_cplx_add(at_1, second);
  add_to(&by[0], -2, at_0);
  add_to(&by[1], 2, ph_cplx_sub(at_0, at_1));
  add_to(&by[2], 2, at_1);
  for (size_t j = 0; j < 3; j++) {
    add_to(&g->by_w[3 * k + j], 1, by[j]);
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
    (seg.space.angle > 0 ? integrate : integrate_ph)(g, k, &seg, &piece[p],
                                                     weight);
  }
  g->equation[k] = ph_cplx_scale(1 / d->chord[k], g->equation[k]);
  for (size_t i = 0; i < 3; i++) { /* dW = W/2 dh/h */
    g->by_h[k] += 0.5 * ph_cplx_mul(g->by_w[3 * k + i], seg.w[i]).re;
    g->by_w[3 * k + i] = ph_cplx_scale(root, g->by_w[3 * k + i]);
  }
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
