/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * What the certificates of Tschirnhausen cubics that interpolate and of those
 * that approximate share: a cubic at unit scale, what every cubic must be, and
 * how two of them join.
 *
 * The coefficients of r' are three times the legs of the control points,
 *
 *   h0 = w0^2,  h1 = w0 w1,  h2 = w1^2,  h1^2 = h0 h2                     (1)
 *
 * the last of which needs no preimage.  The preimage that the record prints is
 * taken as a claim; once it has been found to be that of the control points, it
 * tells how near the curve comes to standing still, which they tell to the
 * square root of their rounding only.
 */
#ifndef PH_CHECK_TC_CHECK_H
#define PH_CHECK_TC_CHECK_H

#include "base/sum.h"
#include "check/error.h"
#include "check/segment.h"
#include "kernel/cplx.h"

/* A curve and what was found of it so far. */
struct ph_tc_check {
  const struct ph_arena *arena; /* knows how much time there is */
  const struct ph_curve *curve;
  struct ph_check_scale scale;
  struct ph_quad rule;
  struct ph_check_error point, tangent, derivative, square, joint, length;
  bool has_tangent, has_derivative; /* whether there were any */
  struct ph_sum total;              /* of the lengths */
  double allowance;                 /* for rounding, of their sum */
  bool regular;
  size_t irregular; /* the first cubic that is not */
};

/* A cubic at unit scale, with respect to u in [0,1]. */
struct ph_tc_cubic {
  ph_cplx p[4];
  ph_cplx h[3];
  ph_cplx w[2];
  double speed;     /* largest |coefficient| of r' */
  double allowance; /* for rounding of control points, in r' */
};

/*
 * ph_tc_check_begin: a finite curve of cubics, by the scale of these points.
 *
 * in   arena  knows how much time there is
 * in   points[n][2]
 * ret  PH_OK | PH_E_TOO_LARGE | PH_E_INTERNAL (it is no such curve, or they
 *      have no extent) | PH_E_NO_MEMORY
 */
enum ph_status ph_tc_check_begin(struct ph_tc_check *c,
                                 const struct ph_curve *curve,
                                 const struct ph_arena *arena,
                                 const double *points, size_t n,
                                 struct ph_diag *diag);

/* ph_tc_check_scaled: v[2] at unit scale. */
static inline ph_cplx ph_tc_check_scaled(const struct ph_tc_check *c,
                                         const double *v) {
  return ph_cplx_of(ph_pow2_apply(c->scale.to_unit, v[0]),
                    ph_pow2_apply(c->scale.to_unit, v[1]));
}

/* ph_tc_check_direction: v/|v|, NaN of 0; v of any size. */
ph_cplx ph_tc_check_direction(ph_cplx v);

/* ph_tc_check_load: cubic k. */
struct ph_tc_cubic ph_tc_check_load(const struct ph_tc_check *c, size_t k);

/* ph_tc_check_cubic: the hodograph of cubic k, its length, and whether it
 * stands still. */
void ph_tc_check_cubic(struct ph_tc_check *c, const struct ph_tc_cubic *s,
                       size_t k);

/* ph_tc_check_joint: between two cubics, b being number k: they meet, with one
 * direction. */
void ph_tc_check_joint(struct ph_tc_check *c, const struct ph_tc_cubic *a,
                       const struct ph_tc_cubic *b, size_t k);

/*
 * ph_tc_check_c1: they have one derivative.
 *
 * in   ratio  of their knot spacings, that of b over that of a
 * in   error  of it, relative
 */
void ph_tc_check_c1(struct ph_tc_check *c, const struct ph_tc_cubic *a,
                    const struct ph_tc_cubic *b, size_t k, double ratio,
                    double error);

/* ph_tc_check_gap: that they meet, alone. */
void ph_tc_check_gap(struct ph_tc_check *c, const struct ph_tc_cubic *a,
                     const struct ph_tc_cubic *b, size_t k);

/*
 * ph_tc_check_tangent: the direction at the start (end = 0) or the end (1) of
 * cubic k.
 *
 * in   wanted  a unit vector
 * in   error   of it, beside rounding
 */
void ph_tc_check_tangent(struct ph_tc_check *c, const struct ph_tc_cubic *s,
                         size_t k, size_t end, ph_cplx wanted, double error);

/* ph_tc_check_derivative: r' there, at unit scale; the error is relative. */
void ph_tc_check_derivative(struct ph_tc_check *c, const struct ph_tc_cubic *s,
                            size_t k, size_t end, ph_cplx wanted, double error);

/* ph_tc_check_join: what was found further on, too. */
void ph_tc_check_join(struct ph_tc_check *c, const struct ph_tc_check *next);

/*
 * ph_tc_check_conclude: what the checks came to, the worst place of the first
 * that fails; and regular.
 *
 * in   may_stop  an irregular curve is none to be refused
 */
enum ph_status ph_tc_check_conclude(struct ph_tc_check *c, bool may_stop,
                                    struct ph_diagnostics *diagnostics,
                                    struct ph_diag *diag);

#endif
