/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Cusps of offsets (see cusp.h).
 *
 * With m = c w1 and all derivatives by u [derived here]:
 * (1) S0 S1' - S0' S1 = 1 / sinc,  sinc = sin(a/2) / (a/2)
 * (2) Im(conj(w) w') = (2/sinc) (Im(conj(w0) m) S0^2 + Im(conj(w0) w2) S0 S1
 *                                + Im(conj(m) w2) S1^2)
 * (3) kappa = 2 Im(conj(w) w') / |w|^4, so that with d the distance
 *     g = |w|^4 - 2 d Im(conj(w) w') has the sign of 1 - d kappa
 * (4) 1 = (S0^2 + 2 c S0 S1 + S1^2)^3 makes (2) a form of degree 8, like |w|^4.
 * The signs of its Bernstein coefficients (kernel/form.h) bound the number of
 * roots; halving isolates them. Tested by t_cusp.c: the form, against
 * 1 - d kappa at many u.
 */
#include "curve/cusp.h"

#include "curve/seg2.h"
#include "kernel/form.h"

#include <math.h>

/* Degree of g; halvings until v is known to rounding. */
enum { DEGREE = 8, HALVINGS_MAX = 50 };

struct form {
  double b[DEGREE + 1]; /* Bernstein coefficients */
};

static struct form form_of(const struct ph_seg2 *seg, double distance) {
  const ph_cplx *w = seg->w;
  ph_cplx m = ph_cplx_scale(seg->space.c, w[1]);
  double speed[5] = {ph_cplx_norm2(w[0]), 4 * ph_cplx_dot(w[0], m),
                     4 * ph_cplx_norm2(m) + 2 * ph_cplx_dot(w[0], w[2]),
                     4 * ph_cplx_dot(m, w[2]), ph_cplx_norm2(w[2])};
  double cross[3] = {ph_cplx_cross(w[0], m), ph_cplx_cross(w[0], w[2]),
                     ph_cplx_cross(m, w[2])};
  double one[3] = {1, 2 * seg->space.c, 1};
  double raised4[5], raised6[7], raised8[DEGREE + 1];
  double factor = 4 * distance / seg->space.sinc;
  struct form form;
  ph_form_multiply(cross, 2, one, 2, raised4);
  ph_form_multiply(raised4, 4, one, 2, raised6);
  ph_form_multiply(raised6, 6, one, 2, raised8);
  ph_form_multiply(speed, 4, speed, 4, form.b);
  for (size_t k = 0; k <= DEGREE; k++) {
    form.b[k] -= factor * raised8[k];
  }
  ph_form_bernstein(form.b, DEGREE, form.b);
  return form;
}

/* The local parameter at which S1 : S0 = v : 1 - v. */
static double parameter_of(const struct ph_atph *space, double v) {
  double half = space->angle / 2;
  return half > 0 ? atan2(v * sin(half), 1 - v + v * cos(half)) / half : v;
}

/* The signs of g along the curve so far. */
struct walk {
  struct ph_cusps cusps;
  size_t segment;
  const struct ph_atph *space;
  int sign; /* the last one seen, 0 before any */
};

static int sign_of(double x) {
  return x > 0 ? 1 : x < 0 ? -1 : 0;
}

/* An interval from v on that has one sign, or none. */
static void see(struct walk *walk, int sign, double v) {
  struct ph_cusps *cusps = &walk->cusps;
  if (sign * walk->sign < 0 && cusps->n++ == 0) {
    cusps->segment = walk->segment;
    cusps->u = parameter_of(walk->space, v);
  }
  walk->sign = sign ? sign : walk->sign;
}

/* Visits intervals without a change of sign, in order. */
static void visit(struct walk *walk, const struct form *form, double v0,
                  double v1, int depth) {
  struct form half[2];
  int sign = 0;
  for (size_t k = 0; k <= DEGREE && sign == 0; k++) {
    sign = sign_of(form->b[k]);
  }
  if (!ph_form_is_mixed(form->b, DEGREE)) {
    see(walk, sign, v0);
  } else if (depth == HALVINGS_MAX) {
    see(walk, sign, v0);
    see(walk, sign_of(form->b[DEGREE]), v1);
  } else {
    ph_form_halve(form->b, DEGREE, half[0].b, half[1].b);
    visit(walk, &half[0], v0, 0.5 * (v0 + v1), depth + 1);
    visit(walk, &half[1], 0.5 * (v0 + v1), v1, depth + 1);
  }
}

struct ph_cusps ph_cusps_planar(const struct ph_curve *curve, double distance) {
  struct walk walk = {{0, 0, 0}, 0, NULL, 0};
  int first = 0;
  for (size_t k = 0; k < curve->n; k++) {
    struct ph_seg2 seg = ph_seg2_of(curve, k);
    struct form form = form_of(&seg, distance);
    first = k == 0 ? sign_of(form.b[0]) : first;
    walk.segment = k;
    walk.space = &seg.space;
    visit(&walk, &form, 0, 1, 0);
  }
  if (curve->closed && first != 0) {
    walk.segment = 0;
    see(&walk, first, 0);
  }
  return walk.cusps;
}
