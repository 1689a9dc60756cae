/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Kinds of curves, as checks see them: how a segment is evaluated from its
 * control points, and what can be asked of it.  Nobody else compares a curve's
 * kind with a name: a new kind is its functions and a row in kind.c, and it is
 * made by no command whose promise (promise.h) does not list it.
 */
#ifndef PH_CHECK_KIND_H
#define PH_CHECK_KIND_H

#include "check/local.h"

struct ph_check_kind {
  /* of a segment that has its control points, at unit scale (segment.h):
   * load   what else is in it
   * jet    r', r'', ... by u
   * point  r(u), exact at u = 0 and u = 1
   * local  what can be said of a place, or of the offset there (local.h) */
  void (*load)(const struct ph_check *v, struct ph_check_segment *s);
  void (*jet)(const struct ph_check_segment *s, double u, ph_vec3 *jet,
              size_t n);
  ph_vec3 (*point)(const struct ph_check *v, const struct ph_check_segment *s,
                   double u);
  struct ph_check_local (*local)(const struct ph_check_path *path, double u);

  /* of the whole curve, beside what all have; or NULL */
  void (*whole)(struct ph_check *v);

  bool square;        /* the hodograph is one: there may be a preimage, and
                         energies are those of this curve */
  bool angles;        /* a segment has an angle alpha, and pieces of offsets are
                         quotients of its functions */
  bool sphere;        /* it lies on a sphere, which it names */
  bool trigonometric; /* of the basis atph, or in place of such a curve */
  bool converted;     /* in place of another, whose joints, tensions, given
                         derivatives and offsets nobody says */
};

/* ph_check_kinds: the rows, by kind. */
extern const struct ph_check_kind ph_check_kinds[PH_CURVE_N];

#endif
