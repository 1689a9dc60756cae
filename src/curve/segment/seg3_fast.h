/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * One segment of a PH or ATPH curve, or a cubic, prepared for many places:
 * points, derivatives of the preimage and arc lengths, all in closed form.
 *
 * Everything is taken from the nearer end u0 of [0,1], by x = u - u0, so that
 * ends are met exactly and |x| <= 1/2.  With the angle a of the space of
 * preimages (kernel/atph.h) and
 *
 *   p = sin(a x) / a,  q = (1 - cos(a x)) / a^2,                          (1)
 *   p' = 1 - a^2 q,  q' = p,  p^2 = 2 q - a^2 q^2;
 *   for a = 0 these are x and x^2 / 2
 *
 * a preimage, which has A''' = -a^2 A', is
 *
 *   A = A0 + A0' p + A0'' q,                                              (2)
 *
 * the derivatives at the end being, with D = A1 - A0 of the coefficients there
 * (at the other end, of those in reverse order and with the sign of x changed)
 *
 *   A0' = 2 slope D,  A0'' = 2 (A2 - A0 - 2 cos(a/2)^2 D) / sinc^2.       (3)
 *
 * For the parametric speed f(A,A) = |A|^2 and the hodograph f(A,A) = A i A*,
 * both symmetric, (1) and (2) give
 *
 *   f = c0 + c1 p + c2 q + c3 p q + c4 q^2,                               (4)
 *   c0 = f(A0,A0),  c1 = 2 f(A0,A0'),  c2 = 2 f(A0,A0'') + 2 f(A0',A0'),
 *   c3 = 2 f(A0',A0''),  c4 = f(A0'',A0'') - a^2 f(A0',A0'),
 *
 * whose integral from the end on is
 *
 *   c0 x + c1 q + c2 i + c3 q^2 / 2 + c4 k,                               (5)
 *   i = integral of q = (x - p) / a^2,  k = integral of q^2.
 *
 * i / x^3, q / x^2 and k / x^5 are power series in y = (a x)^2, with
 *
 *   i: (-1)^n / (2n+3)!,  q: (-1)^n / (2n+2)!,
 *   k: (-1)^n (2^(2n+3) - 2) / (2n+5)!,                                   (6)
 *
 * of which no term cancels more than a digit, whatever the angle; one term
 * each is all there is of polynomials.  [Derived here; (1)-(6) are evaluated
 * by t_seg3_fast.c]
 */
#ifndef PH_CURVE_SEGMENT_SEG3_FAST_H
#define PH_CURVE_SEGMENT_SEG3_FAST_H

#include "curve/segment/seg3.h"
#include "kernel/pow2.h"

#include <float.h>

/* Rows of the series (6), two terms each. */
enum { PH_FAST3_ROWS = 6 };

/* What there is at one end. */
struct ph_fast3_end {
  ph_quat a[3];            /* A0, A0', A0'' */
  double s[5];             /* (4) of the speed */
  double x[5], y[5], z[5]; /* and of the hodograph */
  ph_vec3 point;
};

/* A segment whose preimage is brought to unit scale by a power of two, so that
 * fourth powers of it are in range: speeds, lengths and legs are smaller than
 * they are by what `grow` grows, curvatures larger by what `shrink` shrinks. */
struct ph_fast3 {
  struct ph_seg3 seg; /* A at unit scale */
  int exponent;       /* of `grow` */
  struct ph_pow2 grow, shrink;
  double angle2; /* a^2 */
  size_t rows;   /* that the angle needs */
  struct ph_fast3_end end[2];
};

/* ph_fast3_of: prepares segment k of a curve. */
void ph_fast3_of(const struct ph_curve *curve, size_t k, struct ph_fast3 *fast);

/* A place: the end it is taken from, and (1) and (5) there. */
struct ph_fast3_place {
  const struct ph_fast3_end *end;
  double x, p, q, i, k;
  double dp; /* p' */
};

/* Coefficients of (6), two of each series in a row. */
extern const double ph_fast3_table[PH_FAST3_ROWS][6];

/* ph_fast3_series: i / x^3, q / x^2 and k / x^5 at y, by so many rows. */
static inline void ph_fast3_series(size_t rows, double y, double sum[3]) {
  double i0 = 0, i1 = 0, q0 = 0, q1 = 0, k0 = 0, k1 = 0, y2 = y * y;
  for (size_t n = rows; n-- > 0;) {
    const double *row = ph_fast3_table[n];
    i0 = i0 * y2 + row[0];
    i1 = i1 * y2 + row[1];
    q0 = q0 * y2 + row[2];
    q1 = q1 * y2 + row[3];
    k0 = k0 * y2 + row[4];
    k1 = k1 * y2 + row[5];
  }
  sum[0] = i0 + y * i1;
  sum[1] = q0 + y * q1;
  sum[2] = k0 + y * k1;
}

/* ph_fast3_from: the place at x from the end u = 0 or 1, |x| <= 1/2. */
static inline struct ph_fast3_place ph_fast3_from(const struct ph_fast3 *fast,
                                                  size_t end, double x) {
  struct ph_fast3_place at;
  double x2 = x * x, sum[3];
  ph_fast3_series(fast->rows, fast->angle2 * x2, sum);
  at.end = &fast->end[end];
  at.x = x;
  at.i = x2 * x * sum[0];
  at.q = x2 * sum[1];
  at.k = x2 * x2 * x * sum[2];
  at.p = x - fast->angle2 * at.i;
  at.dp = 1 - fast->angle2 * at.q;
  return at;
}

/* ph_fast3_at: the place at u in [0,1]. */
static inline struct ph_fast3_place ph_fast3_at(const struct ph_fast3 *fast,
                                                double u) {
  return ph_fast3_from(fast, u > 0.5, u > 0.5 ? u - 1 : u);
}

/* a + s b + t c */
static inline ph_quat ph_fast3_sum(ph_quat a, double s, ph_quat b, double t,
                                   ph_quat c) {
  return ph_quat_of(a.u + (s * b.u + t * c.u), a.v + (s * b.v + t * c.v),
                    a.p + (s * b.p + t * c.p), a.q + (s * b.q + t * c.q));
}

/* s a + t b */
static inline ph_quat ph_fast3_mix(double s, ph_quat a, double t, ph_quat b) {
  return ph_quat_of(s * a.u + t * b.u, s * a.v + t * b.v, s * a.p + t * b.p,
                    s * a.q + t * b.q);
}

/* ph_fast3_preimage: A there. */
static inline ph_quat ph_fast3_preimage(const struct ph_fast3_place *at) {
  const ph_quat *a = at->end->a;
  return ph_fast3_sum(a[0], at->p, a[1], at->q, a[2]);
}

/* ph_fast3_first: A' there. */
static inline ph_quat ph_fast3_first(const struct ph_fast3_place *at) {
  const ph_quat *a = at->end->a;
  return ph_fast3_mix(at->dp, a[1], at->p, a[2]);
}

/* ph_fast3_second: A'' there. */
static inline ph_quat ph_fast3_second(const struct ph_fast3 *fast,
                                      const struct ph_fast3_place *at) {
  const ph_quat *a = at->end->a;
  return ph_fast3_mix(at->dp, a[2], -fast->angle2 * at->p, a[1]);
}

/* A at unit scale that is less than this has no direction but its rounding. */
#define PH_FAST3_ROUNDING (64 * DBL_EPSILON)

/* ph_fast3_direction: A, or where it is 0 the first of its derivatives that is
 * not: its square has the direction that r' has on either side. */
static inline ph_quat ph_fast3_direction(const struct ph_fast3 *fast,
                                         const struct ph_fast3_place *at) {
  const ph_quat a = ph_fast3_preimage(at), first = ph_fast3_first(at);
  return ph_quat_abs(a) > PH_FAST3_ROUNDING       ? a
         : ph_quat_abs(first) > PH_FAST3_ROUNDING ? first
                                                  : ph_fast3_second(fast, at);
}

/* ph_fast3_integral: (5), from the end to the place: negative next to u = 1, of
 * what is positive. */
static inline double ph_fast3_integral(const struct ph_fast3_place *at,
                                       const double c[5]) {
  return c[0] * at->x + (c[1] * at->q + c[2] * at->i) +
         (c[3] * (0.5 * at->q * at->q) + c[4] * at->k);
}

/* ph_fast3_point: the point, in the unit of the data. */
static inline ph_vec3 ph_fast3_point(const struct ph_fast3 *fast,
                                     const struct ph_fast3_place *at) {
  const struct ph_fast3_end *end = at->end;
  const struct ph_pow2 grow = fast->grow;
  return ph_vec3_of(
      end->point.x + ph_pow2_apply(grow, ph_fast3_integral(at, end->x)),
      end->point.y + ph_pow2_apply(grow, ph_fast3_integral(at, end->y)),
      end->point.z + ph_pow2_apply(grow, ph_fast3_integral(at, end->z)));
}

#endif
