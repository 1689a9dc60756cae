/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Pythagorean hodographs.
 *
 * A claimed preimage is a witness: r' is compared with its square at the nodes
 * of a Gauss rule, more nodes than either has coefficients; where that fits,
 * the rule finds the length.
 *
 * Where there is no preimage, or it is not that of the control points, these
 * alone must tell: |r'|^2 is a form of degree 2 m in S0 and S1,
 *
 *   q(x) = sum_j q_j (1-x)^(2m-j) x^j,  x = S1 / (S0 + S1)               (1)
 *
 * and the square of one of degree m.  Expanded where it is large, it has the
 * root of a power series, of which the first m + 1 terms must be all.
 */
#include "check/checks.h"

#include "check/sphere_segment.h"

#include "kernel/quat.h"

enum { SQUARE_MAX = 2 * PH_CHECK_FORM_MAX + 1, PLACES = 16 };

/* A preimage that misses r' by more than this is not that of the curve. */
static const double SAME = 1e-9;

/* Between the 12 nodes, and at the ends, it may miss it by this times as much
 * as at the nodes, that being of degree 4: they are at most pi / 12.5 apart on
 * the circle over [0,1], and T_4(1 / the last) / cos(4 pi / 25) is 1.5. */
static const double BETWEEN = 1.5;

/* One that misses it by no more, relative to the speed, tells its length. */
static const double EXACT = 1e-13;

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

void ph_check_preimage(const struct ph_check *v, size_t k, ph_quat *a) {
  const struct ph_curve *c = v->curve;
  const double *w = ph_curve_preimage(c, k);
  double root = v->scale.root;
  root = c->preimage.alpha ? root * sqrt(c->preimage.alpha[k]) : root;
  for (size_t i = 0; i < c->preimage.n; i++, w += c->preimage.dimension) {
    /* in the plane: w = x + y i as x + y k, whose square turns i */
    a[i] = c->dimension == 2
               ? ph_quat_of(root * w[0], 0, 0, root * w[1])
               : ph_quat_of(root * w[0], root * w[1], root * w[2], root * w[3]);
  }
}

/* a + s b, where z may be known to be 0. */
static inline ph_vec3 along(ph_vec3 a, double s, ph_vec3 b, bool plane) {
  return ph_vec3_of(a.x + s * b.x, a.y + s * b.y, plane ? 0 : a.z + s * b.z);
}

static inline ph_quat more(ph_quat a, double s, ph_quat b, bool plane) {
  return ph_quat_of(a.u + s * b.u, plane ? 0 : a.v + s * b.v,
                    plane ? 0 : a.p + s * b.p, a.q + s * b.q);
}

static inline double norm2(ph_vec3 a, bool plane) {
  return plane ? a.x * a.x + a.y * a.y : ph_vec3_dot(a, a);
}

/* r' = A i A* at the nodes of the fixed rule, m being that of the segment.
 *
 * out  miss  the largest |r' - A i A*|
 * ret  the integral of |r'| */
PH_INLINE double at_nodes(const struct ph_check *v,
                          const struct ph_check_segment *s, const ph_quat *a,
                          size_t m, bool plane, double *miss) {
  const struct ph_check_space *space = v->space;
  double length = 0, worst = 0;
  for (size_t i = 0; i < v->fixed.n; i++) {
    const double *b = space->leg[i], *c = space->square[i];
    ph_vec3 r = ph_vec3_scale(b[0], s->leg[0]);
    ph_quat w = ph_quat_scale(c[0], a[0]);
    double error;
    r = along(along(r, b[1], s->leg[1], plane), b[2], s->leg[2], plane);
    w = more(w, c[1], a[1], plane);
    if (m == 4) {
      r = along(along(r, b[3], s->leg[3], plane), b[4], s->leg[4], plane);
      w = more(w, c[2], a[2], plane);
    }
    error = norm2(ph_vec3_sub(r, ph_quat_i(w, w)), plane);
    length += v->fixed.weight[i] * sqrt(norm2(r, plane));
    worst = error <= worst ? worst : error;
  }
  *miss = sqrt(worst);
  return length;
}

/* ... where that and the dimension are known when this is compiled: planar
 * quintics take 540 instructions in place of 790. */
static double hodograph(const struct ph_check *v,
                        const struct ph_check_segment *s, const ph_quat *a,
                        double *miss) {
  return s->m == 2                  ? at_nodes(v, s, a, 2, true, miss)
         : v->curve->dimension == 2 ? at_nodes(v, s, a, 4, true, miss)
                                    : at_nodes(v, s, a, 4, false, miss);
}

/* ---- both --------------------------------------------------------------- */

/* By the fixed rule alone. */
static void certify(struct ph_check *v, const struct ph_check_segment *s) {
  const struct ph_tolerance *allow = v->allow;
  double length, miss, allowed = allow->square * s->speed;
  ph_quat a[3];
  if (allow->square_of_size > 0) {
    allowed = ph_check_smaller(allowed, allow->square_of_size * v->scale.size);
  }
  ph_check_preimage(v, s->k, a);
  length = hodograph(v, s, a, &miss);
  ph_check_miss(v, PH_CHECK_PYTHAGOREAN, ph_check_in(s->k, "preimage"), miss,
                ph_check_unit(v->unit_square, s->speed, 0),
                allowed + allow->miss * v->interval + s->noise, NULL);
  if (v->length) {
    v->length[s->k] = length;
  } else {
    ph_check_length(v, s->k, length, s->noise);
  }
}

/* A preimage that fits, or none. */
static void verify(struct ph_check *v, struct ph_check_segment *s,
                   bool preimage, double miss) {
  double unit = ph_check_larger(s->speed, v->mean);
  if (preimage) {
    ph_check_miss(v, PH_CHECK_PREIMAGE, ph_check_in(s->k, "preimage"), miss,
                  unit, s->noise, "misses the hodograph");
  }
  if (preimage && miss <= s->noise + SAME * unit) {
    ph_check_miss(v, PH_CHECK_PYTHAGOREAN, ph_check_in(s->k, "control_points"),
                  miss, unit, s->noise, "miss the square");
    v->rooted[s->k] = s->rooted = miss <= s->noise;
    v->noise[s->k] = s->noise += BETWEEN * miss;
  } else {
    ph_check_miss(v, PH_CHECK_PYTHAGOREAN, ph_check_in(s->k, "control_points"),
                  irrational(s), unit, ROUND_ROOT * s->noise,
                  "are no Pythagorean hodograph");
  }
}

/* By quadrature; on a sphere by the certificate's way, which sees where the
 * curve runs back for a moment: a claim that it allows is the length. */
static double length_of(const struct ph_check *v,
                        const struct ph_check_segment *s) {
  const double *claimed = v->curve->lengths;
  struct ph_check_nu_segment nu;
  double length, found, allowed;
  if (!v->kind->sphere || !claimed) {
    return ph_check_length_of(v, s, 0, 1);
  }
  length = ph_check_scaled(v, claimed[s->k]) / s->radius;
  ph_check_nu_segment_of(s->p, 3 * DBL_EPSILON + v->scale.rounding / s->radius,
                         &nu);
  allowed = ph_check_nu_allowed(&nu, length);
  found = ph_check_nu_length(&nu, length, allowed);
  return s->radius * (fabs(found - length) <= allowed ? length : found);
}

void ph_check_square(struct ph_check *v, struct ph_check_segment *s) {
  bool preimage = v->kind->square && v->curve->preimage.v;
  double miss = HUGE_VAL;
  ph_quat a[3];
  s->noise = ph_check_rounding(v, s);
  if (v->noise) {
    v->noise[s->k] = s->noise;
  }
  if (v->error) {
    certify(v, s);
    return;
  }
  if (preimage) {
    ph_check_preimage(v, s->k, a);
    v->length[s->k] = hodograph(v, s, a, &miss);
  }
  if (!(miss <= s->noise + EXACT * s->speed)) {
    v->length[s->k] = (double)NAN;
  }
  if (v->kind->square) {
    verify(v, s, preimage, miss);
  }
  if (isnan(v->length[s->k])) {
    v->length[s->k] = length_of(v, s);
  }
}
