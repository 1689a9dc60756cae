/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Whether two Tschirnhausen cubics cross (see tc_simple.h).
 *
 * A cubic without a loop does not meet itself.  Of two, what can be seen from
 * their joint answers nearly always; else meet.h searches.  What matters of a
 * cubic is z = conj(v) w, with the preimages v at the joint and w at its other
 * end: its argument is half the turn from the joint to there.
 *
 * Derived here; tested by t_tc_simple.c: test_slow, test_cross.
 */
#include "curve/cross/tc_simple.h"

#include "curve/cross/meet.h"

#include <math.h>

/* Cuts at most; past them the cubics are said to meet.  Those that just
 * touch take 32 on average (244 of 18006 random such at most). */
enum { STEPS = 4096 };

/* Directions closer than this, in radians, are not told apart by sectors(). */
static const double CLEAR = 1e-6;

/*
 * Whether the tangent turns by less than a half turn from the outer end of one
 * arc to the outer end of the other: then the chain moves along an axis.
 *
 * Each arc turns to one side.  If both turn to the same side the sum counts:
 * arg z_a and arg z_b, of different signs, are less than a quarter turn apart.
 * If not, the sum is less than the larger, and each alone must be narrow.
 */
static bool is_narrow(ph_cplx a, ph_cplx b) {
  return a.re > 0 && b.re > 0 && ph_cplx_dot(a, b) > 0;
}

/*
 * The direction from the joint to the outmost control point of an arc, seen
 * from the tangent there, turned to the left of it: one of
 *   n + z, n^2 + n z + z^2,  n = |v|^2, z with |K| for K.
 */
static ph_cplx outmost(double n, ph_cplx z) {
  ph_cplx left = ph_cplx_of(z.re, fabs(z.im));
  ph_cplx second = ph_cplx_of(n + left.re, left.im);
  ph_cplx third = ph_cplx_mul(left, second);
  third.re += n * n;
  return ph_cplx_cross(second, third) > 0 ? third : second;
}

/*
 * Whether the joint sees the arcs in sectors of their own.
 *
 * An arc lies in the sector of its control points, between the tangent of the
 * joint and the outmost one, if that is below a half turn: R > -n/2.  If the
 * arcs turn to different sides the tangent separates them; else their angles
 * must add up to less than a half turn.
 */
static bool sectors(double na, ph_cplx a, double nb, ph_cplx b) {
  ph_cplx product;
  if (!(na + 2 * a.re > CLEAR * na && nb + 2 * b.re > CLEAR * nb)) {
    return false;
  }
  if ((a.im >= 0) == (b.im >= 0)) {
    return true;
  }
  product = ph_cplx_mul(outmost(na, a), outmost(nb, b));
  return product.re > 0 ? product.im >= 0 : product.im > -CLEAR * product.re;
}

/* The cubic as a piece from `start` to `end`. */
static struct ph_piece piece_of(const struct ph_tc *tc, ph_cplx start,
                                ph_cplx end) {
  struct ph_seg2 seg = {.space = ph_atph_of(0), .start = start, .end = end};
  seg.w[0] = tc->w[0];
  seg.w[1] = ph_cplx_scale(0.5, ph_cplx_add(tc->w[0], tc->w[1]));
  seg.w[2] = tc->w[1];
  return ph_piece_of(&seg, 0);
}

static bool is_fine(const struct ph_tc *tc) {
  return ph_tc_is_regular(tc) && !ph_tc_has_loop(tc);
}

bool ph_tc_is_simple(const struct ph_tc *tc, size_t n) {
  const struct ph_between between = {PH_CONE_NONE, PH_CONE_ALL};
  const ph_cplx joint = {0, 0};
  struct ph_meet meet = {.steps = STEPS};
  struct ph_tc_form f[2];
  struct ph_piece a, b;
  ph_cplx z[2], leg;
  if (!is_fine(&tc[0]) || (n == 2 && !is_fine(&tc[1]))) {
    return false;
  }
  if (n == 1) {
    return true;
  }
  f[0] = ph_tc_form_of(&tc[0]);
  f[1] = ph_tc_form_of(&tc[1]);
  z[0] = ph_cplx_of(f[0].r, -f[0].k);
  z[1] = ph_cplx_of(f[1].r, f[1].k);
  if (is_narrow(z[0], z[1]) || sectors(f[0].b, z[0], f[1].a, z[1])) {
    return true;
  }
  meet.tolerance =
      PH_TC_SIMPLE_NEAR * (ph_tc_length(&tc[0]) + ph_tc_length(&tc[1]));
  leg = ph_tc_leg(&tc[0]);
  a = piece_of(&tc[0], ph_cplx_scale(-1, leg), joint);
  b = piece_of(&tc[1], joint, ph_tc_leg(&tc[1]));
  ph_meet_pair(&meet, &a, &b, &between);
  return !meet.found;
}
