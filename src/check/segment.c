/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Segments from their control points (see segment.h). */
#include "check/segment.h"

#include "check/kind.h"

/* Lengths, relative. */
static const double LENGTH = 1e-13;

/* ---- the basis ---------------------------------------------------------- */

/* sin(a x) / sin(a) for a in (0, pi/2), x for a = 0, with derivatives by x over
 * factorials. */
static void sine(double a, double x, size_t n, double *series) {
  double s = sin(a * x), c = cos(a * x), unit = 1 / sin(a);
  series[0] = s * unit;
  for (size_t i = 1; i < n; i++) {
    double factor = a / (double)i, swap = s;
    /* the next derivative: sin, cos, -sin, -cos */
    s = c;
    c = -swap;
    unit *= factor;
    series[i] = s * unit;
  }
}

void ph_check_basis(double angle, double u, size_t n,
                    double series[2][PH_CHECK_JET]) {
  if (angle > 0) {
    sine(angle / 2, 1 - u, n, series[0]);
    sine(angle / 2, u, n, series[1]);
    for (size_t i = 1; i < n; i += 2) {
      series[0][i] = -series[0][i];
    }
    return;
  }
  for (size_t i = 0; i < n; i++) {
    series[0][i] = i == 0 ? 1 - u : i == 1 ? -1 : 0;
    series[1][i] = i == 0 ? u : i == 1 ? 1 : 0;
  }
}

static double power(double x, size_t n) {
  double y = 1;
  for (; n > 0; n--) {
    y *= x;
  }
  return y;
}

/* mu_j of (1): 1 / ((m + 1) binomial(m, j)), or by quadrature. */
static double leg_weight(const struct ph_check *v, double angle, size_t m,
                         size_t j, double normal) {
  double sum = 0;
  if (!(angle > 0)) {
    return 1 / ((double)(m + 1) * normal);
  }
  for (size_t i = 0; i < v->fine.n; i++) {
    double series[2][PH_CHECK_JET];
    ph_check_basis(angle, v->fine.node[i], 1, series);
    sum +=
        v->fine.weight[i] * power(series[0][0], m - j) * power(series[1][0], j);
  }
  return sum;
}

/* ---- loading ------------------------------------------------------------ */

void ph_check_form_load(const struct ph_check *v, struct ph_check_segment *s) {
  double mu[PH_CHECK_FORM_MAX] = {0}, binomial = 1;
  s->m = v->curve->degree - 1;
  for (size_t j = 0; j <= s->m; j++) {
    s->normal[j] = binomial;
    binomial *= (double)(s->m - j) / (double)(j + 1);
    mu[j] = 2 * j <= s->m ? leg_weight(v, s->angle, s->m, j, s->normal[j])
                          : mu[s->m - j];
    s->h[j] = ph_vec3_scale(1 / mu[j], ph_vec3_sub(s->p[j + 1], s->p[j]));
    s->speed = ph_check_larger(s->speed, ph_vec3_abs(s->h[j]) / s->normal[j]);
  }
}

void ph_check_load(const struct ph_check *v, size_t k,
                   struct ph_check_segment *s) {
  const struct ph_curve *c = v->curve;
  const double *p = ph_curve_points(c, k);
  s->kind = v->kind;
  s->k = k;
  s->angle = c->preimage.alpha ? c->preimage.alpha[k] : 0;
  s->unit = c->preimage.alpha ? c->preimage.alpha[k] : 1;
  s->spacing = c->knots[k + 1] - c->knots[k];
  s->speed = 0;
  for (size_t i = 0; i <= c->degree; i++) {
    s->p[i] = ph_check_vector(v, p + c->dimension * i, c->dimension);
  }
  s->kind->load(v, s);
  s->noise = v->noise[k];
}

/* ---- evaluation --------------------------------------------------------- */

/* Products of power series of n terms. */
static void multiply(size_t n, const double *a, double *b) {
  for (size_t i = n; i-- > 0;) {
    double sum = 0;
    for (size_t j = 0; j <= i; j++) {
      sum += a[j] * b[i - j];
    }
    b[i] = sum;
  }
}

static void multiply_vector(size_t n, const double *a, ph_vec3 *b) {
  for (size_t i = n; i-- > 0;) {
    ph_vec3 sum = ph_vec3_scale(a[0], b[i]);
    for (size_t j = 1; j <= i; j++) {
      sum = ph_vec3_along(sum, a[j], b[i - j]);
    }
    b[i] = sum;
  }
}

/* (1) by Horner's rule, as power series. */
void ph_check_form_jet(const struct ph_check_segment *s, double u, ph_vec3 *jet,
                       size_t n) {
  double series[2][PH_CHECK_JET], p[PH_CHECK_JET] = {1, 0, 0, 0};
  double factorial = 1;
  ph_check_basis(s->angle, u, n, series);
  for (size_t i = 0; i < n; i++) {
    jet[i] = ph_vec3_scale(p[i], s->h[0]);
  }
  for (size_t j = 1; j <= s->m; j++) {
    multiply_vector(n, series[0], jet);
    multiply(n, series[1], p);
    for (size_t i = 0; i < n; i++) {
      jet[i] = ph_vec3_along(jet[i], p[i], s->h[j]);
    }
  }
  for (size_t i = 2; i < n; i++) {
    factorial *= (double)i;
    jet[i] = ph_vec3_scale(factorial, jet[i]);
  }
}

void ph_check_jet(const struct ph_check_segment *s, double u, ph_vec3 *jet,
                  size_t n) {
  s->kind->jet(s, u, jet, n);
}

/* The integral of r' over [from,to]; exact for polynomials of degree 31, to
 * rounding for ATPH segments. */
static ph_vec3 chord(const struct ph_check *v, const struct ph_check_segment *s,
                     double from, double to) {
  ph_vec3 sum = {0, 0, 0};
  for (size_t i = 0; i < v->fine.n; i++) {
    ph_vec3 first;
    ph_check_form_jet(s, from + (to - from) * v->fine.node[i], &first, 1);
    sum = ph_vec3_along(sum, v->fine.weight[i], first);
  }
  return ph_vec3_scale(to - from, sum);
}

ph_vec3 ph_check_form_point(const struct ph_check *v,
                            const struct ph_check_segment *s, double u) {
  return u < 0.5 ? ph_vec3_add(s->p[0], chord(v, s, 0, u))
                 : ph_vec3_sub(s->p[s->m + 1], chord(v, s, u, 1));
}

ph_vec3 ph_check_point(const struct ph_check *v,
                       const struct ph_check_segment *s, double u) {
  return s->kind->point(v, s, u);
}

double ph_check_form_reach(const struct ph_check *v,
                           const struct ph_check_segment *s) {
  double reach = 0;
  for (size_t i = 0; i <= s->m + 1; i++) {
    reach = ph_check_larger(reach, ph_check_reach(v, s->p[i]));
  }
  return reach;
}

static void speed_at(const void *context, double u, double *value) {
  ph_vec3 first;
  ph_check_jet(context, u, &first, 1);
  *value = ph_vec3_abs(first);
}

double ph_check_length_of(const struct ph_check *v,
                          const struct ph_check_segment *s, double from,
                          double to) {
  const struct ph_check_integrands of = {speed_at, s, 1, 0, s->noise, LENGTH};
  double length;
  ph_check_integral(&v->rule, &of, from, to, &length);
  return length;
}
