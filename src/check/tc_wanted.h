/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * What a problem of Tschirnhausen cubics asks for, read anew from its fields:
 * the mode, and the direction or derivative at each point of the data.
 */
#ifndef PH_CHECK_TC_WANTED_H
#define PH_CHECK_TC_WANTED_H

#include "check/tc_check.h"
#include "curve/problem.h"

enum ph_tc_wanted_mode {
  PH_TC_WANTED_ONE,    /* g1: one cubic in each interval */
  PH_TC_WANTED_TWO,    /* g1-pair, c1, spline: two */
  PH_TC_WANTED_EITHER, /* g1-auto, g1-fair */
  PH_TC_WANTED_APPROXIMATE,
  PH_TC_WANTED_G2
};

struct ph_tc_wanted {
  enum ph_tc_wanted_mode mode;
  bool all;      /* every solution is wanted, whatever it is like */
  bool on_chord; /* the joint of a pair is */
  double joint_angle, joint_position; /* NaN where they are free */
  const struct ph_problem *problem;
  const struct ph_value *points; /* or control points of approximations */
  size_t n;                      /* intervals */
  bool closed;
  bool spline;
  const double *tangents, *derivatives; /* or NULL */
  double lambda; /* NaN where the lengths of derivatives are free */
};

/* ph_tc_wanted_mode_of: by the field mode, or by those that are given. */
enum ph_tc_wanted_mode ph_tc_wanted_mode_of(const struct ph_problem *problem);

/*
 * ph_tc_wanted_of: of a problem whose points are interpolated.
 *
 * ret  PH_OK | PH_E_INTERNAL (the arrays do not fit together)
 */
enum ph_status ph_tc_wanted_of(const struct ph_problem *problem,
                               const struct ph_tc_check *c,
                               struct ph_tc_wanted *wanted,
                               struct ph_diag *diag);

/* What is wanted at a point. */
struct ph_tc_wanted_end {
  bool has_direction, has_length;
  ph_cplx direction;
  double length; /* of the derivative, at unit scale */
  double error;  /* of the direction, by cancellation */
};

/* ph_tc_wanted_point: point k of the data at unit scale, 0 <= k <= n. */
ph_cplx ph_tc_wanted_point(const struct ph_tc_wanted *wanted,
                           const struct ph_tc_check *c, size_t k);

/* ph_tc_wanted_end_of: at point k. */
struct ph_tc_wanted_end ph_tc_wanted_end_of(const struct ph_tc_wanted *wanted,
                                            const struct ph_tc_check *c,
                                            size_t k);

#endif
