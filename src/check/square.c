/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Pythagorean hodographs.
 *
 * A claimed preimage is a witness: its square is compared with the form of r'
 * (segment.h), coefficient by coefficient.  Where there is none, or it is not
 * that of the control points, these alone must tell: |r'|^2 is a form of degree
 * 2 m in S0 and S1,
 *
 *   q(x) = sum_j q_j (1-x)^(2m-j) x^j,  x = S1 / (S0 + S1)               (1)
 *
 * and the square of one of degree m.  Expanded where it is large, it has the
 * root of a power series, of which the first m + 1 terms must be all.
 */
#include "check/checks.h"

#include "kernel/quat.h"

enum { SQUARE_MAX = 2 * PH_CHECK_FORM_MAX + 1, PLACES = 16 };

/* A preimage that misses r' by more than this is not that of the curve. */
static const double SAME = 1e-9;

/* The root of a series has its errors multiplied by some powers of 2. */
static const double ROUND_ROOT = 64;

/* ---- without a preimage ------------------------------------------------- */

/* (1) as a power series about x. */
static void expand(const double *q, size_t n, double x, double *series) {
  double p[SQUARE_MAX] = {1};
  for (size_t i = 0; i < n; i++) {
    series[i] = i == 0 ? q[0] : 0;
  }
  for (size_t j = 1; j < n; j++) {
    for (size_t i = n; i-- > 0;) {
      series[i] = (1 - x) * series[i] - (i > 0 ? series[i - 1] : 0);
      p[i] = x * p[i] + (i > 0 ? p[i - 1] : 0);
    }
    for (size_t i = 0; i < n; i++) {
      series[i] += q[j] * p[i];
    }
  }
}

/* What the terms of a series after the first m + 1 differ from the square of
 * its root by, the largest at places of [0,1]. */
static double not_square(const double *series, size_t m, double x) {
  double root[PH_CHECK_FORM_MAX] = {0}, rest[SQUARE_MAX] = {0}, worst = 0;
  for (size_t i = 0; i <= 2 * m; i++) {
    double sum = series[i];
    size_t from = i > m ? i - m : 1, to = i > m ? m + 1 : i;
    for (size_t j = from; j < to; j++) {
      sum -= root[j] * root[i - j];
    }
    if (i <= m) {
      root[i] = i == 0 ? sqrt(sum) : sum / (2 * root[0]);
    } else {
      rest[i] = sum;
    }
  }
  for (size_t place = 0; place <= PLACES; place++) {
    double y = (double)place / PLACES - x, sum = 0;
    for (size_t i = 2 * m + 1; i-- > 0;) {
      sum = sum * y + rest[i];
    }
    worst = fabs(sum) <= worst ? worst : fabs(sum);
  }
  return worst;
}

/* How far |r'| is from a form of its degree. */
static double irrational(const struct ph_check_segment *s) {
  double q[SQUARE_MAX] = {0}, series[SQUARE_MAX], best = 0, at = 0;
  size_t n = 2 * s->m + 1;
  for (size_t i = 0; i <= s->m; i++) {
    for (size_t j = 0; j <= s->m; j++) {
      q[i + j] += ph_vec3_dot(s->h[i], s->h[j]);
    }
  }
  for (size_t place = 0; place <= PLACES; place++) {
    double x = (double)place / PLACES;
    expand(q, n, x, series);
    if (series[0] > best) {
      best = series[0];
      at = x;
    }
  }
  if (!(best > 0)) {
    return 0; /* a point */
  }
  expand(q, n, at, series);
  return not_square(series, s->m, at) / (2 * sqrt(best));
}

/* ---- with one ----------------------------------------------------------- */

/* What coefficient i of a preimage is multiplied by, of n. */
static double factor_of(const struct ph_check_segment *s, size_t i, size_t n) {
  double binomial = 1;
  for (size_t j = 0; j < i; j++) {
    binomial *= (double)(n - 1 - j) / (double)(j + 1);
  }
  return s->angle > 0 && i == 1 ? 2 * cos(s->angle / 2) : binomial;
}

/* r' as the square of the preimage, in the form of segment.h.
 * out  square[m + 1] */
static void square_of(const struct ph_check *v,
                      const struct ph_check_segment *s, ph_vec3 *square) {
  const struct ph_curve *c = v->curve;
  const double *w = ph_curve_preimage(c, s->k);
  ph_quat a[PH_CHECK_FORM_MAX];
  double root = v->scale.root * sqrt(s->unit);
  size_t n = c->preimage.n;
  for (size_t i = 0; i < n; i++, w += c->preimage.dimension) {
    double f = root * factor_of(s, i, n);
    /* in the plane: w = x + y i as x + y k, whose square turns i */
    a[i] = c->dimension == 2
               ? ph_quat_of(f * w[0], 0, 0, f * w[1])
               : ph_quat_of(f * w[0], f * w[1], f * w[2], f * w[3]);
  }
  for (size_t j = 0; j <= s->m; j++) {
    square[j] = ph_vec3_of(0, 0, 0);
  }
  for (size_t i = 0; i < n; i++) {
    for (size_t j = 0; j < n; j++) {
      square[i + j] = ph_vec3_add(square[i + j], ph_quat_i(a[i], a[j]));
    }
  }
}

/* How far r' is from that of the claimed preimage, at places: as certificates
 * see it.  One control point that is off, as that in the middle of a curve
 * which misses its end, counts by what it does to r'. */
static double preimage_miss(const struct ph_check *v,
                            const struct ph_check_segment *s) {
  ph_vec3 square[PH_CHECK_FORM_MAX];
  double worst = 0;
  square_of(v, s, square);
  for (size_t place = 0; place <= PLACES; place++) {
    double series[2][PH_CHECK_JET], miss, power = 1;
    ph_vec3 sum = {0, 0, 0};
    ph_check_basis(s->angle, (double)place / PLACES, 1, series);
    for (size_t j = 0; j <= s->m; j++) { /* Horner's rule */
      sum = ph_vec3_scale(series[0][0], sum);
      sum = ph_vec3_along(sum, power, ph_vec3_sub(square[j], s->h[j]));
      power *= series[1][0];
    }
    miss = ph_vec3_abs(sum);
    worst = miss <= worst ? worst : miss;
  }
  return worst;
}

void ph_check_square(struct ph_check *v, struct ph_check_segment *s) {
  const struct ph_curve *c = v->curve;
  double unit = ph_check_larger(s->speed, v->mean), miss = 0;
  s->noise = PH_CHECK_ROUND_FIRST *
             ph_check_smaller(v->kind->reach(v, s), v->scale.rounding);
  v->noise[s->k] = s->noise;
  if (!v->kind->square) {
    return;
  }
  if (c->preimage.v) {
    miss = preimage_miss(v, s);
    ph_check_miss(v, PH_CHECK_PREIMAGE, ph_check_in(s->k, "preimage"), miss,
                  unit, s->noise, "misses the hodograph");
  }
  if (c->preimage.v && miss <= s->noise + SAME * unit) {
    ph_check_miss(v, PH_CHECK_PYTHAGOREAN, ph_check_in(s->k, "control_points"),
                  miss, unit, s->noise, "miss the square");
    v->noise[s->k] = s->noise += miss;
  } else {
    ph_check_miss(v, PH_CHECK_PYTHAGOREAN, ph_check_in(s->k, "control_points"),
                  irrational(s), unit, ROUND_ROOT * s->noise,
                  "are no Pythagorean hodograph");
  }
}
