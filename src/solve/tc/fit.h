/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * What solvers of Tschirnhausen cubics have in common: Hermite data of one
 * interval, and a curve of one or two cubics that fits them.
 *
 * All is relative to the chord: the interval goes from 0 to 1 along the real
 * axis; vectors are divided by the chord (as complex numbers), preimages by its
 * square root, lengths by its length, energies multiplied by it.
 */
#ifndef PH_SOLVE_TC_FIT_H
#define PH_SOLVE_TC_FIT_H

#include "curve/result.h"
#include "curve/tc.h"

#include <stddef.h>

/* Vectors at both ends over the chord: unit tangents, or derivatives of each
 * cubic by its own parameter in [0,1].  ph_tc_hermite_of snaps them. */
struct ph_tc_hermite {
  ph_cplx t[2];
};

/* PH_TC_COLLINEAR: a vector within this angle of the chord, forward or
 * backward, is along it. */
#define PH_TC_COLLINEAR 1e-14

/* ph_tc_snap: a vector that is along the chord without what it is off it. */
static inline ph_cplx ph_tc_snap(ph_cplx t) {
  return fabs(t.im) <= PH_TC_COLLINEAR * fabs(t.re) ? ph_cplx_of(t.re, 0) : t;
}

/* ph_tc_is_along, _forward, _backward: of a snapped vector, to the chord. */
static inline bool ph_tc_is_along(ph_cplx t) {
  return !(fabs(t.im) > 0);
}

static inline bool ph_tc_is_forward(ph_cplx t) {
  return t.re > 0 && ph_tc_is_along(t);
}

static inline bool ph_tc_is_backward(ph_cplx t) {
  return t.re < 0 && ph_tc_is_along(t);
}

/* ph_tc_hermite_scaled: the same data with vectors as long by a factor. */
static inline struct ph_tc_hermite
ph_tc_hermite_scaled(const struct ph_tc_hermite *h, double factor) {
  struct ph_tc_hermite scaled = {
      {ph_cplx_scale(factor, h->t[0]), ph_cplx_scale(factor, h->t[1])}};
  return scaled;
}

/* A curve of one or two cubics that fits Hermite data. */
struct ph_tc_fit {
  struct ph_tc tc[2];
  size_t n; /* cubics */
  enum ph_root root;
  double ratio;          /* of one cubic: D; else NaN */
  double lambda;         /* of a pair with |t[0]| = |t[1]| = lambda; else NaN */
  double joint_angle;    /* of two with their joint on the chord; else NaN */
  double joint_position; /* likewise */
  bool regular;          /* every cubic is */
  unsigned loops;        /* cubics that have one */
  bool simple;           /* known to be; see ph_tc_fit_measure */
  double length;
  double energy; /* not finite unless regular */
};

/* ph_tc_fit_of: n cubics that are still to be set and measured. */
static inline struct ph_tc_fit ph_tc_fit_of(size_t n, enum ph_root root) {
  const double none = (double)NAN;
  struct ph_tc_fit fit = {.n = n,
                          .root = root,
                          .ratio = none,
                          .lambda = none,
                          .joint_angle = none,
                          .joint_position = none,
                          .length = none,
                          .energy = none};
  return fit;
}

/*
 * ph_tc_fit_measure: regular, loops, length and energy from tc[n]; simple is
 * set to false.
 */
void ph_tc_fit_measure(struct ph_tc_fit *fit);

/* ph_tc_fit_test: sets simple by curve/tc_simple.h; returns it. */
bool ph_tc_fit_test(struct ph_tc_fit *fit);

/*
 * ph_tc_fit_order: tests all fits and sorts them, best first: simple ones by
 * energy (of those that agree to 1e-9 the shorter, then the one that came
 * first), then other regular ones likewise, then irregular ones in their order.
 */
void ph_tc_fit_order(struct ph_tc_fit *fits, size_t n);

/*
 * ph_tc_fit_best: the one that ph_tc_fit_order would put first, measured and
 * tested; tests as few as it can.  fits[n] must have been measured.
 *
 * ret  NULL if none is regular
 */
struct ph_tc_fit *ph_tc_fit_best(struct ph_tc_fit *fits, size_t n);

#endif
