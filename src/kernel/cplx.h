/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Complex numbers as plain pairs of doubles, for planar geometry: points,
 * vectors and preimages are all ph_cplx.
 *
 * C11's double complex is not used: its product checks for infinities (a
 * library call at every multiplication), and it is optional in the standard.
 * Operands are expected near unit scale; nothing here guards against overflow.
 */
#ifndef PH_KERNEL_CPLX_H
#define PH_KERNEL_CPLX_H

#include <math.h>
#include <stdbool.h>

typedef struct {
  double re;
  double im;
} ph_cplx;

static inline ph_cplx ph_cplx_of(double re, double im) {
  ph_cplx z = {re, im};
  return z;
}

static inline ph_cplx ph_cplx_add(ph_cplx a, ph_cplx b) {
  return ph_cplx_of(a.re + b.re, a.im + b.im);
}

static inline ph_cplx ph_cplx_sub(ph_cplx a, ph_cplx b) {
  return ph_cplx_of(a.re - b.re, a.im - b.im);
}

static inline ph_cplx ph_cplx_mul(ph_cplx a, ph_cplx b) {
  return ph_cplx_of(a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re);
}

static inline ph_cplx ph_cplx_scale(double s, ph_cplx a) {
  return ph_cplx_of(s * a.re, s * a.im);
}

static inline ph_cplx ph_cplx_conj(ph_cplx a) {
  return ph_cplx_of(a.re, -a.im);
}

/* ph_cplx_between: (1 - u) a + u b. */
static inline ph_cplx ph_cplx_between(ph_cplx a, ph_cplx b, double u) {
  return ph_cplx_of((1 - u) * a.re + u * b.re, (1 - u) * a.im + u * b.im);
}

/* ph_cplx_norm2: |a|^2. */
static inline double ph_cplx_norm2(ph_cplx a) {
  return a.re * a.re + a.im * a.im;
}

static inline double ph_cplx_abs(ph_cplx a) {
  return sqrt(ph_cplx_norm2(a));
}

/* ph_cplx_dot: Re(a conj(b)), the scalar product of two plane vectors. */
static inline double ph_cplx_dot(ph_cplx a, ph_cplx b) {
  return a.re * b.re + a.im * b.im;
}

/* ph_cplx_cross: Im(conj(a) b), positive when b lies to the left of a. */
static inline double ph_cplx_cross(ph_cplx a, ph_cplx b) {
  return a.re * b.im - a.im * b.re;
}

/* ph_cplx_inverse: 1 / a; a = 0 gives non-finite parts. */
static inline ph_cplx ph_cplx_inverse(ph_cplx a) {
  return ph_cplx_scale(1 / ph_cplx_norm2(a), ph_cplx_conj(a));
}

/* ph_cplx_polar: exp(i angle). */
static inline ph_cplx ph_cplx_polar(double angle) {
  return ph_cplx_of(cos(angle), sin(angle));
}

/* ph_cplx_sqrt: the square root with non-negative real part; by half-angle
 * formulas in the form that does not cancel. */
static inline ph_cplx ph_cplx_sqrt(ph_cplx a) {
  double modulus = ph_cplx_abs(a);
  double large = sqrt(0.5 * (modulus + fabs(a.re)));
  double small = large > 0 ? 0.5 * fabs(a.im) / large : 0;
  return a.re >= 0 ? ph_cplx_of(large, copysign(small, a.im))
                   : ph_cplx_of(small, copysign(large, a.im));
}

static inline bool ph_cplx_is_finite(ph_cplx a) {
  return isfinite(a.re) && isfinite(a.im);
}

/* ph_cplx_angle: the angle from a to b, in [-pi, pi]. */
static inline double ph_cplx_angle(ph_cplx a, ph_cplx b) {
  const double cross = ph_cplx_cross(a, b), dot = ph_cplx_dot(a, b);
  if (fabs(cross) < 0.01 * dot) { /* a series: the next term is t^7 / 7 */
    const double t = cross / dot, t2 = t * t;
    return t * (1 - t2 * (1.0 / 3 - t2 * (1.0 / 5)));
  }
  return atan2(cross, dot);
}

#endif
