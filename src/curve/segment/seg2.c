/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Segments of planar splines (see seg2.h). */
#include "curve/segment/seg2.h"

#include <math.h>

static ph_cplx pair(const double *v) {
  return ph_cplx_of(v[0], v[1]);
}

void ph_seg2_preimage(const struct ph_curve *curve, size_t k, ph_cplx w[3]) {
  const double *v = ph_curve_preimage(curve, k);
  size_t last = curve->preimage.n - 1;
  w[0] = pair(v);
  w[2] = pair(v + 2 * last);
  w[1] = last == 2 ? pair(v + 2) : ph_cplx_scale(0.5, ph_cplx_add(w[0], w[2]));
}

struct ph_seg2 ph_seg2_of(const struct ph_curve *curve, size_t k) {
  double angle = ph_curve_angle(curve, k),
         root = sqrt(ph_curve_range(curve, k));
  const double *p = ph_curve_points(curve, k);
  struct ph_seg2 seg;
  seg.space = ph_atph_of(angle);
  ph_seg2_preimage(curve, k, seg.w);
  for (size_t i = 0; i < 3; i++) {
    seg.w[i] = ph_cplx_scale(root, seg.w[i]);
  }
  seg.start = pair(p);
  seg.end = pair(p + 2 * curve->degree);
  return seg;
}

/* The integral of w^2 over [u0,u1]. */
static ph_cplx leg(const struct ph_seg2 *seg, const struct ph_quad *rule,
                   double u0, double u1) {
  ph_cplx sum = {0, 0};
  for (size_t i = 0; i < rule->n; i++) {
    ph_cplx w;
    ph_atph_jet(&seg->space, seg->w, u0 + (u1 - u0) * rule->node[i], &w, 1);
    sum = ph_cplx_add(sum, ph_cplx_scale(rule->weight[i], ph_cplx_mul(w, w)));
  }
  return ph_cplx_scale(u1 - u0, sum);
}

ph_cplx ph_seg2_point(const struct ph_seg2 *seg, const struct ph_quad *rule,
                      double u) {
  return u <= 0.5 ? ph_cplx_add(seg->start, leg(seg, rule, 0, u))
                  : ph_cplx_sub(seg->end, leg(seg, rule, u, 1));
}

static double angle_between(ph_cplx a, ph_cplx b) {
  return atan2(ph_cplx_cross(a, b), ph_cplx_dot(a, b));
}

/* A linear form p (1-v) + r v; v stands for the ratio S1 : S0. */
struct form {
  ph_cplx p, r;
};

static ph_cplx form_at(const struct form *form, double v) {
  return ph_cplx_add(ph_cplx_scale(1 - v, form->p), ph_cplx_scale(v, form->r));
}

static double turn(const struct form forms[2], double from, double to) {
  double sum = 0;
  for (size_t i = 0; i < 2; i++) {
    sum += angle_between(form_at(&forms[i], from), form_at(&forms[i], to));
  }
  return 2 * sum;
}

/*
 * Inflections, as v = x / (1 + x) with x = S1/S0, sorted.  With m = c w1,
 *   Im(conj(w) w') ~ Im(conj(w0) m) + Im(conj(w0) w2) x + Im(conj(m) w2) x^2
 * up to a positive factor.
 */
static size_t inflections(const ph_cplx w[3], ph_cplx m, double v[2]) {
  double a0 = ph_cplx_cross(w[0], m), a1 = ph_cplx_cross(w[0], w[2]);
  double a2 = ph_cplx_cross(m, w[2]);
  double disc = a1 * a1 - 4 * a0 * a2;
  size_t n = 0;
  double q, low, high;
  if (!(disc > 0)) {
    return 0;
  }
  q = -0.5 * (a1 + copysign(sqrt(disc), a1));
  /* The roots q/a2 and a0/q, as v; their denominators may vanish. */
  low = a0 / (a0 + q);
  high = q / (q + a2);
  if (high < low) {
    double keep = low;
    low = high;
    high = keep;
  }
  if (low > 0 && low < 1) {
    v[n++] = low;
  }
  if (high > 0 && high < 1) {
    v[n++] = high;
  }
  return n;
}

/* w by a power of two, so that fourth powers of it are in range. */
static void at_unit_scale(const ph_cplx w[3], ph_cplx out[3]) {
  double largest = 0, scale;
  for (size_t i = 0; i < 3; i++) {
    largest = fmax(largest, fmax(fabs(w[i].re), fabs(w[i].im)));
  }
  scale = largest > 0 ? ldexp(1, -ilogb(largest)) : 1;
  for (size_t i = 0; i < 3; i++) {
    out[i] = ph_cplx_scale(scale, w[i]);
  }
}

/*
 * The two linear forms whose product w is, up to a positive factor.
 *
 * (1) w ~ w0 (1-v)^2 + 2 m (1-v) v + w2 v^2,  m = c w1.
 * (2) With d = sqrt(m^2 - w0 w2), signed so that q = m + d does not cancel:
 *     q w ~ (q (1-v) + w2 v) (w0 (1-v) + q v),  as w0 w2 + q^2 = 2 m q.
 *     Tested by t_seg2.c: factorisation.
 */
static void split(const ph_cplx w[3], ph_cplx m, struct form forms[2]) {
  const ph_cplx d =
      ph_cplx_sqrt(ph_cplx_sub(ph_cplx_mul(m, m), ph_cplx_mul(w[0], w[2])));
  const ph_cplx q =
      ph_cplx_dot(m, d) >= 0 ? ph_cplx_add(m, d) : ph_cplx_sub(m, d);
  forms[0] = (struct form){q, w[2]};
  forms[1] = (struct form){w[0], q};
}

/* ---- standing still ----------------------------------------------------- */

/* Where in [0,1] a form is nearest to 0. */
static double nearest(const struct form *form) {
  ph_cplx step = ph_cplx_sub(form->r, form->p);
  double foot = -ph_cplx_dot(form->p, step), whole = ph_cplx_norm2(step);
  return foot > 0 ? (foot < whole ? foot / whole : 1) : 0;
}

/* u for v = S1 / (S0 + S1). */
static double parameter_of(const struct ph_atph *space, double v) {
  double half = 0.5 * space->angle;
  return half > 0 ? atan2(v * sin(half), 1 - v + v * space->c) / half : v;
}

void ph_seg2_slow(const struct ph_seg2 *seg, double u[2]) {
  struct form forms[2];
  ph_cplx w[3];
  at_unit_scale(seg->w, w);
  split(w, ph_cplx_scale(seg->space.c, w[1]), forms);
  for (size_t i = 0; i < 2; i++) {
    u[i] = parameter_of(&seg->space, nearest(&forms[i]));
  }
}

bool ph_seg2_stands_still(const struct ph_seg2 *seg, double *u) {
  ph_cplx w[3];
  double most, at[4] = {0, 1};
  if (ph_seg2_moves_on(seg->w)) {
    return false;
  }
  ph_seg2_slow(seg, at + 2);
  at_unit_scale(seg->w, w);
  most = ph_cplx_norm2(ph_cplx_scale(seg->space.c, w[1]));
  most = fmax(most, fmax(ph_cplx_norm2(w[0]), ph_cplx_norm2(w[2])));
  for (size_t i = 0; i < 4; i++) {
    ph_cplx here;
    ph_atph_jet(&seg->space, w, at[i], &here, 1);
    if (!(ph_cplx_norm2(here) > PH_SEG2_STILL * most)) {
      if (u) {
        *u = at[i];
      }
      return true;
    }
  }
  return false;
}

/* ---- rotation ----------------------------------------------------------- */

double ph_seg2_rotation(const struct ph_seg2 *seg, double *absolute) {
  struct form forms[2];
  ph_cplx w[3], m;
  at_unit_scale(seg->w, w);
  m = ph_cplx_scale(seg->space.c, w[1]);
  split(w, m, forms);
  if (absolute) {
    double v[4] = {0};
    size_t n = inflections(w, m, v + 1);
    v[n + 1] = 1;
    *absolute = 0;
    for (size_t i = 0; i <= n; i++) {
      *absolute += fabs(turn(forms, v[i], v[i + 1]));
    }
  }
  return turn(forms, 0, 1);
}
