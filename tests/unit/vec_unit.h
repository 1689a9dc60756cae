/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Comparisons of points: they fail where their distance is more than tol. */
#ifndef PH_TESTS_VEC_UNIT_H
#define PH_TESTS_VEC_UNIT_H

#include "random_unit.h"
#include "unit.h"

#include "kernel/vec3.h"

#define ck_cplx(found, wanted, tol)                                           \
  do {                                                                        \
    const ph_cplx ck_p_ = (found), ck_q_ = (wanted);                          \
    const double ck_d_ = unit_distance(ck_p_, ck_q_), ck_most_ = (tol);       \
    ck_assert_msg(ck_d_ <= ck_most_,                                          \
                  "seed %lu: (%.17g, %.17g), not (%.17g, %.17g): %.3g > "     \
                  "%.3g",                                                     \
                  unit_seed(), ck_p_.re, ck_p_.im, ck_q_.re, ck_q_.im, ck_d_, \
                  ck_most_);                                                  \
  } while (0)

#define ck_vec3(found, wanted, tol)                                         \
  do {                                                                      \
    const ph_vec3 ck_p_ = (found), ck_q_ = (wanted);                        \
    const double ck_d_ = ph_vec3_abs(ph_vec3_sub(ck_p_, ck_q_));            \
    const double ck_most_ = (tol);                                          \
    ck_assert_msg(ck_d_ <= ck_most_,                                        \
                  "seed %lu: (%.17g, %.17g, %.17g), not (%.17g, %.17g, "    \
                  "%.17g): %.3g > %.3g",                                    \
                  unit_seed(), ck_p_.x, ck_p_.y, ck_p_.z, ck_q_.x, ck_q_.y, \
                  ck_q_.z, ck_d_, ck_most_);                                \
  } while (0)

#endif
