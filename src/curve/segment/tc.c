/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One Tschirnhausen cubic (see tc.h). */
#include "curve/segment/tc.h"

#include "kernel/pi.h"

#include <math.h>

/* What is nothing beside the other end, or for the sine of a sweep. */
static const double NOTHING = 1e-12;

ph_cplx ph_tc_leg(const struct ph_tc *tc) {
  ph_cplx a = tc->w[0], b = tc->w[1];
  ph_cplx sum =
      ph_cplx_add(ph_cplx_mul(a, ph_cplx_add(a, b)), ph_cplx_mul(b, b));
  return ph_cplx_of(sum.re / 3, sum.im / 3);
}

void ph_tc_control_points(const struct ph_tc *tc, ph_cplx start, ph_cplx end,
                          ph_cplx p[4]) {
  ph_cplx first = ph_cplx_mul(tc->w[0], tc->w[0]);
  ph_cplx last = ph_cplx_mul(tc->w[1], tc->w[1]);
  p[0] = start;
  p[1] = ph_cplx_of(start.re + first.re / 3, start.im + first.im / 3);
  p[2] = ph_cplx_of(end.re - last.re / 3, end.im - last.im / 3);
  p[3] = end;
}

double ph_tc_length(const struct ph_tc *tc) {
  struct ph_tc_form f = ph_tc_form_of(tc);
  return (f.a + f.r + f.b) / 3;
}

double ph_tc_turning(const struct ph_tc *tc) {
  struct ph_tc_form f = ph_tc_form_of(tc);
  return 2 * atan2(f.k, f.r);
}

static bool form_is_regular(const struct ph_tc_form *f) {
  const double e = NOTHING * NOTHING;
  return f->a > e * f->b && f->b > e * f->a &&
         (f->r >= 0 || f->k * f->k > e * (f->a * f->b));
}

bool ph_tc_is_regular(const struct ph_tc *tc) {
  struct ph_tc_form f = ph_tc_form_of(tc);
  return form_is_regular(&f);
}

bool ph_tc_has_loop(const struct ph_tc *tc) {
  struct ph_tc_form f = ph_tc_form_of(tc);
  double slower = f.a < f.b ? f.a : f.b;
  return f.r < 0 && fabs(f.k) > 0 && PH_SQRT3 * fabs(f.k) <= slower - f.r;
}

/* ---- bending energy ----------------------------------------------------- */

/*
 * Derived here; tested by t_tc.c: test_energy_table, test_energy_small.
 * (1) From the middle of the sweep, |w| at the angle y from there is
 *       |w| = a b sin D / (P cos y + Q sin y),
 *       P = (a + b) sin h, Q = (a - b) cos h, h = D/2, a = |w0|, b = |w1|,
 *     and ds = |w|^4 / |K| dy, kappa = 2 K / |w|^4, so that
 *       E = 8/|K|^3 (P^4 C4 + 6 P^2 Q^2 C22 + Q^4 C04),
 *     with C4, C22 and C04 the integrals of cos^4, cos^2 sin^2 and sin^4 over
 *     [0,h].
 * (2) C4 = C04 + sin h cos h and C22 = (C04 + sin^3 h cos h)/3: all is positive
 *     but for the closed form
 *       C04 = (3 h - (3 + 2 sin^2 h) sin h cos h)/8,
 *     which cancels for small h, where C04 is a series.
 * (3) With g = a b: 2 g sin^2 h = g - R, 2 g cos^2 h = g + R, and the product
 *     of these is K^2: the one that would cancel comes from the other.
 */

/* Above, the closed form loses a factor of 36 at most, in a term that is no
 * more than a sixteenth of the sum. */
static const double SERIES_MAX = 0.5;

/* C04 / h^5 for h <= SERIES_MAX, x = h^2: the sum of
 *   (-x)^k (4^(2k+5)/32 - 2^(2k+5)/4)/(2k+5)!. */
static double fourth_series(double x) {
  static const double c[] = {
      0.2,
      -0.095238095238095238095,
      0.022222222222222222222,
      -0.0032708032708032708033,
      0.00033645366978700312034,
      -0.000025653358986692320026,
      1.5092974943581853012e-6,
      -7.061364157808973552e-8,
      2.6900742742635055116e-9,
      -8.5061880495086124712e-11,
  };
  double x2 = x * x, x4 = x2 * x2;
  double low = c[0] + c[1] * x + (c[2] + c[3] * x) * x2;
  double high = c[4] + c[5] * x + (c[6] + c[7] * x) * x2;
  return low + x4 * (high + x4 * (c[8] + c[9] * x));
}

double ph_tc_energy(const struct ph_tc *tc) {
  struct ph_tc_form f = ph_tc_form_of(tc);
  double k = fabs(f.k), g = sqrt(f.a * f.b), near = g + fabs(f.r);
  double far = k * (k / near), sum = f.a + f.b + 2 * g;
  double squares = (f.a - f.b) * (f.a - f.b);
  double h = atan(f.r >= 0 ? k / near : near / k);
  /* 2 g sin^2 h, 2 g cos^2 h, sin h cos h; C04, and over k^3 */
  double sine = f.r >= 0 ? far : near, cosine = f.r >= 0 ? near : far;
  double both = k / (2 * g), fourth, fourth_k3;
  if (!form_is_regular(&f)) {
    return (double)INFINITY;
  }
  if (!(k > 0)) {
    return 0;
  }
  if (h < SERIES_MAX) {
    double q = h / k;
    fourth_k3 = h * h * (q * q * q) * fourth_series(h * h);
    fourth = fourth_k3 * (k * k * k);
  } else {
    fourth = (3 * h - (3 + sine / g) * both) / 8;
    fourth_k3 = fourth / (k * k * k);
  }
  return 2 / (g * g) *
         (sum * sum * k / (cosine * cosine) * (fourth + both) +
          2 * squares * (sine / (4 * g * g) + fourth_k3 * (k * k)) +
          squares / sum * (squares / sum) * (cosine * cosine) * fourth_k3);
}

/* ---- vertex, parts ------------------------------------------------------ */

double ph_tc_vertex(const struct ph_tc *tc) {
  ph_cplx d = ph_cplx_sub(tc->w[1], tc->w[0]);
  double foot = -ph_cplx_dot(tc->w[0], d), m = ph_cplx_norm2(d);
  return foot > 0 ? (foot < m ? foot / m : 1) : 0;
}

struct ph_tc ph_tc_part(const struct ph_tc *tc, double u, double v) {
  const ph_cplx *w = tc->w;
  double root = sqrt(v - u);
  struct ph_tc part = {{ph_cplx_scale(root, ph_cplx_between(w[0], w[1], u)),
                        ph_cplx_scale(root, ph_cplx_between(w[0], w[1], v))}};
  return part;
}
