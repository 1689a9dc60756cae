/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Quaternions u + v i + p j + q k, for geometry in space: a vector is a pure
 * quaternion, and A w A* turns the vector w and scales it by |A|^2.
 *
 * Operands are expected near unit scale: nothing here guards against overflow.
 */
#ifndef PH_KERNEL_QUAT_H
#define PH_KERNEL_QUAT_H

#include "kernel/cplx.h"
#include "kernel/vec3.h"

typedef struct {
  double u, v, p, q;
} ph_quat;

static inline ph_quat ph_quat_of(double u, double v, double p, double q) {
  ph_quat a = {u, v, p, q};
  return a;
}

/* ph_quat_pure: the vector x i + y j + z k. */
static inline ph_quat ph_quat_pure(ph_vec3 x) {
  return ph_quat_of(0, x.x, x.y, x.z);
}

static inline ph_vec3 ph_quat_vector(ph_quat a) {
  return ph_vec3_of(a.v, a.p, a.q);
}

static inline ph_quat ph_quat_add(ph_quat a, ph_quat b) {
  return ph_quat_of(a.u + b.u, a.v + b.v, a.p + b.p, a.q + b.q);
}

static inline ph_quat ph_quat_sub(ph_quat a, ph_quat b) {
  return ph_quat_of(a.u - b.u, a.v - b.v, a.p - b.p, a.q - b.q);
}

static inline ph_quat ph_quat_scale(double s, ph_quat a) {
  return ph_quat_of(s * a.u, s * a.v, s * a.p, s * a.q);
}

static inline ph_quat ph_quat_conj(ph_quat a) {
  return ph_quat_of(a.u, -a.v, -a.p, -a.q);
}

static inline double ph_quat_dot(ph_quat a, ph_quat b) {
  return a.u * b.u + a.v * b.v + a.p * b.p + a.q * b.q;
}

static inline double ph_quat_abs(ph_quat a) {
  return sqrt(ph_quat_dot(a, a));
}

static inline ph_quat ph_quat_mul(ph_quat a, ph_quat b) {
  return ph_quat_of(a.u * b.u - a.v * b.v - a.p * b.p - a.q * b.q,
                    a.u * b.v + a.v * b.u + a.p * b.q - a.q * b.p,
                    a.u * b.p - a.v * b.q + a.p * b.u + a.q * b.v,
                    a.u * b.q + a.v * b.p - a.p * b.v + a.q * b.u);
}

/* ph_quat_turn: a (e.re + e.im i). */
static inline ph_quat ph_quat_turn(ph_quat a, ph_cplx e) {
  return ph_quat_of(a.u * e.re - a.v * e.im, a.v * e.re + a.u * e.im,
                    a.p * e.re + a.q * e.im, a.q * e.re - a.p * e.im);
}

/* ph_quat_i, ph_quat_j: vect(a i b*) and vect(a j b*), symmetric in a and b. */
static inline ph_vec3 ph_quat_i(ph_quat a, ph_quat b) {
  return ph_vec3_of(a.u * b.u + a.v * b.v - a.p * b.p - a.q * b.q,
                    a.u * b.q + a.q * b.u + a.v * b.p + a.p * b.v,
                    a.v * b.q + a.q * b.v - a.u * b.p - a.p * b.u);
}

static inline ph_vec3 ph_quat_j(ph_quat a, ph_quat b) {
  return ph_vec3_of(a.v * b.p + a.p * b.v - a.u * b.q - a.q * b.u,
                    a.u * b.u - a.v * b.v + a.p * b.p - a.q * b.q,
                    a.p * b.q + a.q * b.p + a.u * b.v + a.v * b.u);
}

/* ph_quat_k: vect(a k b*). */
static inline ph_vec3 ph_quat_k(ph_quat a, ph_quat b) {
  return ph_vec3_of(a.v * b.q + a.q * b.v + a.u * b.p + a.p * b.u,
                    a.p * b.q + a.q * b.p - a.u * b.v - a.v * b.u,
                    a.u * b.u - a.v * b.v - a.p * b.p + a.q * b.q);
}

/* ph_quat_between: conj(a) b, for the invariants of a curve: the part v is that
 * of the twist, p + i q that of the curvature. */
static inline ph_quat ph_quat_between(ph_quat a, ph_quat b) {
  return ph_quat_mul(ph_quat_conj(a), b);
}

/*
 * ph_quat_of_frame: a unit quaternion R that turns i, j, k into the
 * right-handed orthonormal e1, e2, e3: R i R* = e1 and so on.
 *
 * Of the four rows of R R^T the one with the largest diagonal is normalised, so
 * that nothing cancels.
 */
static inline ph_quat ph_quat_of_frame(ph_vec3 e1, ph_vec3 e2, ph_vec3 e3) {
  double u = 1 + e1.x + e2.y + e3.z, v = 1 + e1.x - e2.y - e3.z;
  double p = 1 - e1.x + e2.y - e3.z, q = 1 - e1.x - e2.y + e3.z;
  ph_quat r;
  if (u >= v && u >= p && u >= q) {
    r = ph_quat_of(u, e2.z - e3.y, e3.x - e1.z, e1.y - e2.x);
  } else if (v >= p && v >= q) {
    r = ph_quat_of(e2.z - e3.y, v, e1.y + e2.x, e3.x + e1.z);
  } else if (p >= q) {
    r = ph_quat_of(e3.x - e1.z, e1.y + e2.x, p, e2.z + e3.y);
  } else {
    r = ph_quat_of(e1.y - e2.x, e3.x + e1.z, e2.z + e3.y, q);
  }
  return ph_quat_scale(1 / ph_quat_abs(r), r);
}

#endif
