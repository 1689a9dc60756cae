/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Segments from their control points (see segment.h). */
#include "check/segment.h"

#include "check/kind.h"
#include "check/local.h"
#include "kernel/pi.h"

/* A certificate looks at 6 nodes, and lets less pass than the coordinates have
 * where these have three digits of the curve: between its nodes it may be this
 * times as much, by the count of BETWEEN (square.c). */
static const double BETWEEN_6 = 4.25;

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

/* Powers S0^(m-j) S1^j at a node, and the functions of the preimage. */
static void powers_at(struct ph_check_space *space, double u, double power[5],
                      double square[3]) {
  double series[2][PH_CHECK_JET], p, q, pq;
  ph_check_basis(space->angle, u, 1, series);
  p = series[0][0] * series[0][0];
  q = series[1][0] * series[1][0];
  pq = series[0][0] * series[1][0];
  if (space->m == 2) {
    power[0] = p;
    power[1] = pq;
    power[2] = q;
    square[0] = series[0][0];
    square[1] = series[1][0];
    return;
  }
  power[0] = p * p;
  power[1] = p * pq;
  power[2] = p * q;
  power[3] = q * pq;
  power[4] = q * q;
  square[0] = p;
  square[1] = 2 * space->c * pq;
  square[2] = q;
}

struct ph_check_space ph_check_space_of(const struct ph_quad *rule, size_t m,
                                        double angle) {
  double half = angle >= 0 && angle < PH_PI ? angle / 2 : (double)NAN;
  double sinc = half > 0 ? sin(half) / half : 1 + half;
  struct ph_check_space space = {.m = m, .angle = angle, .c = cos(half)};
  space.normal[0] = 1;
  for (size_t i = 0; i < rule->n; i++) {
    powers_at(&space, rule->node[i], space.leg[i], space.square[i]);
    for (size_t j = 0; j <= m; j++) {
      space.mu[j] += rule->weight[i] * space.leg[i][j];
    }
  }
  for (size_t j = 0; j <= m; j++) {
    if (j > 0) {
      space.normal[j] = space.normal[j - 1] * (double)(m + 1 - j) / (double)j;
    }
    /* without the rounding of the rule, which a torsion may feel */
    space.per_mu[j] = angle > 0 ? 1 / space.mu[j < m - j ? j : m - j]
                                : (double)(m + 1) * space.normal[j];
    space.weight[j] = space.normal[j] * space.mu[j];
    for (size_t i = 0; i < rule->n; i++) {
      space.leg[i][j] /= space.mu[j];
    }
  }
  space.outer = (double)m * (space.c / sinc) / space.mu[0];
  space.inner = 1 / (sinc * space.mu[1]);
  return space;
}

/* The space of a segment, if it is not that of the last one, as it often is. */
static void set_space(const struct ph_check *v, size_t m, double angle) {
  struct ph_check_space *space = v->space;
  if (space->m != m || !(angle <= space->angle && angle >= space->angle)) {
    *space = ph_check_space_of(&v->fixed, m, angle);
  }
}

/* ---- loading ------------------------------------------------------------ */

/* r'' at an end from the legs next to it, by differentiating (1) there. */
static ph_vec3 second_at(const struct ph_check_space *space, ph_vec3 outer,
                         ph_vec3 inner) {
  return ph_vec3_sub(ph_vec3_scale(space->inner, inner),
                     ph_vec3_scale(space->outer, outer));
}

/* With z = 0, where that may be known. */
static inline ph_vec3 flat(ph_vec3 a, bool plane) {
  return ph_vec3_of(a.x, a.y, plane ? 0 : a.z);
}

static inline double farthest(double so_far, ph_vec3 a, bool plane) {
  so_far = ph_check_larger(so_far, fabs(a.x));
  so_far = ph_check_larger(so_far, fabs(a.y));
  return plane ? so_far : ph_check_larger(so_far, fabs(a.z));
}

/* The forms (1). */
PH_INLINE void load_form(const struct ph_check *v, struct ph_check_segment *s,
                         size_t m, bool plane) {
  const struct ph_check_space *space = v->space;
  const double *p = ph_curve_points(v->curve, s->k);
  ph_vec3 at = flat(ph_check_vector(v, p, plane ? 2 : 3), plane);
  double far = farthest(0, at, plane), speed = 0;
  s->end[0] = s->p[0] = at;
  for (size_t j = 0; j <= m; j++) {
    ph_vec3 to, leg;
    p += plane ? 2 : 3;
    to = flat(ph_check_vector(v, p, plane ? 2 : 3), plane);
    leg = flat(ph_vec3_sub(to, at), plane);
    s->p[j + 1] = at = to;
    s->leg[j] = leg;
    s->h[j] = flat(ph_vec3_scale(space->per_mu[j], leg), plane);
    speed = ph_check_larger(speed, ph_vec3_abs(leg) / space->weight[j]);
    far = farthest(far, to, plane);
  }
  s->end[1] = at;
  s->speed = speed;
  s->reach = DBL_EPSILON * far + v->scale.spacing;
  s->plane = plane;
}

void ph_check_form_load(const struct ph_check *v, struct ph_check_segment *s) {
  const struct ph_check_space *space = v->space;
  size_t m = v->curve->degree - 1;
  set_space(v, m, s->angle);
  s->m = m;
  if (v->curve->dimension == 2) {
    load_form(v, s, m, true);
  } else {
    load_form(v, s, m, false);
  }
  s->first[0] = s->h[0];
  s->first[1] = s->h[m];
  s->second[0] = second_at(space, s->leg[0], s->leg[1]);
  s->second[1] = ph_vec3_scale(-1, second_at(space, s->leg[m], s->leg[m - 1]));
}

double ph_check_rounding(const struct ph_check *v,
                         const struct ph_check_segment *s) {
  return PH_CHECK_ROUND_FIRST *
         ph_check_smaller(s->reach,
                          (v->error ? 1 : BETWEEN_6) * v->scale.rounding);
}

void ph_check_load(const struct ph_check *v, size_t k,
                   struct ph_check_segment *s) {
  const struct ph_curve *c = v->curve;
  s->kind = v->kind;
  s->k = k;
  s->angle = c->preimage.alpha ? c->preimage.alpha[k] : 0;
  s->unit = c->preimage.alpha ? c->preimage.alpha[k] : 1;
  s->spacing = c->knots[k + 1] - c->knots[k];
  s->speed = 0;
  s->kind->load(v, s);
  s->noise = v->noise ? v->noise[k] : ph_check_rounding(v, s);
  s->rooted = v->rooted && v->rooted[k];
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
static void series_jet(const struct ph_check_segment *s, double u, ph_vec3 *jet,
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

/* A step of the same for polynomials, of which S0 and S1 have two terms: terms
 * of p S1 and, with it, jet S0 + p h. */
PH_INLINE void step(size_t n, double u, double *p, ph_vec3 *jet, ph_vec3 h,
                    bool plane) {
  for (size_t i = n - 1; i > 0; i--) {
    p[i] = u * p[i] + p[i - 1];
    jet[i] = ph_vec3_sub(ph_vec3_scale(1 - u, jet[i]), jet[i - 1]);
    jet[i] = flat(ph_vec3_along(jet[i], p[i], h), plane);
  }
  p[0] *= u;
  jet[0] = ph_vec3_along(ph_vec3_scale(1 - u, jet[0]), p[0], h);
  jet[0] = flat(jet[0], plane);
}

PH_INLINE void polynomial_jet(const struct ph_check_segment *s, double u,
                              ph_vec3 *out, size_t n, bool plane) {
  double p[PH_CHECK_JET] = {1, 0, 0, 0};
  ph_vec3 jet[PH_CHECK_JET] = {{0, 0, 0}};
  jet[0] = flat(s->h[0], plane);
  for (size_t j = 1; j <= s->m; j++) {
    step(n, u, p, jet, s->h[j], plane);
  }
  for (size_t i = 0; i < n; i++) {
    out[i] = i < 2 ? jet[i] : ph_vec3_scale(i < 3 ? 2 : 6, jet[i]);
  }
}

PH_INLINE void polynomial(const struct ph_check_segment *s, double u,
                          ph_vec3 *jet, size_t n, bool plane) {
  switch (n) {
  case 1:
    polynomial_jet(s, u, jet, 1, plane);
    break;
  case 2:
    polynomial_jet(s, u, jet, 2, plane);
    break;
  case 3:
    polynomial_jet(s, u, jet, 3, plane);
    break;
  default:
    polynomial_jet(s, u, jet, 4, plane);
  }
}

void ph_check_form_jet(const struct ph_check_segment *s, double u, ph_vec3 *jet,
                       size_t n) {
  if (s->angle > 0) {
    series_jet(s, u, jet, n);
  } else if (s->plane) {
    polynomial(s, u, jet, n, true);
  } else {
    polynomial(s, u, jet, n, false);
  }
}

void ph_check_jet(const struct ph_check_segment *s, double u, ph_vec3 *jet,
                  size_t n) {
  s->kind->jet(s, u, jet, n);
}

/* The integral of r' over [from,to]. */
static ph_vec3 chord(const struct ph_check *v, const struct ph_check_segment *s,
                     double from, double to) {
  ph_vec3 sum = {0, 0, 0};
  for (size_t i = 0; i < v->fixed.n; i++) {
    ph_vec3 first;
    ph_check_form_jet(s, from + (to - from) * v->fixed.node[i], &first, 1);
    sum = ph_vec3_along(sum, v->fixed.weight[i], first);
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

static void speed_at(const void *context, double u, double *value) {
  ph_vec3 first;
  ph_check_jet(context, u, &first, 1);
  *value = ph_vec3_abs(first);
}

/* By so many times that it is uncertain |r'| need not be found better (of which
 * a tenth counts, check/integral.c): values between control points that are
 * nearly antipodal are rounded up to a hundred times as much. */
static const double FOUND = 4096;

static void uncertain_speed_at(const void *context, double u, double *value) {
  struct ph_check_local local = ph_check_local_at(context, u);
  value[0] = local.speed;
  value[1] = FOUND * local.speed_error;
}

double ph_check_length_of(const struct ph_check *v,
                          const struct ph_check_segment *s, double from,
                          double to) {
  const struct ph_check_integrands of = {speed_at, s, 1, 0, s->noise, LENGTH};
  const struct ph_check_path path = {.v = v, .s = s};
  const struct ph_check_integrands uncertain = {uncertain_speed_at, &path, 2, 1,
                                                s->noise,           LENGTH};
  double length, sum[2];
  ph_check_integral(&v->rule, &of, from, to, &length);
  if (isnan(length)) { /* it may be known to less in some places */
    ph_check_integral(&v->rule, &uncertain, from, to, sum);
    length = sum[0];
  }
  return length;
}
