/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The unit sphere: the f_n against numbers of 40 digits, the rest against what
 * they mean. */
#include "unit.h"
#include "spatial_unit.h"

#include "kernel/pi.h"
#include "kernel/s2.h"

/* f_0, ..., f_3 by mpmath: besselj, and the series (2) below X = 1. */
static const struct {
  double x, f[4];
} bessel[] = {{0.0,
               {1.0, 0.3333333333333333333, 0.06666666666666666667,
                0.00952380952380952381}},
              {1e-300,
               {1.0, 0.3333333333333333333, 0.06666666666666666667,
                0.00952380952380952381}},
              {1e-10,
               {0.9999999999833333333, 0.33333333333, 0.06666666666619047619,
                0.009523809523756613757}},
              {0.001,
               {0.9998333416664682567, 0.3333000011904541449,
                0.06666190489417789003, 0.00952328043530528114}},
              {0.03,
               {0.9950074946450886772, 0.332334404166869542,
                0.06652392851733162359, 0.009507947326285866728}},
              {0.0624999,
               {0.9896158535808240478, 0.3312546482376291513,
                0.0663695643043173894, 0.009490787728585096491}},
              {0.0625,
               {0.9896158370180917184, 0.3312546449191509479,
                0.06636956382977800427, 0.009490787675825175571}},
              {0.5,
               {0.9187253698655684378, 0.3169615455798765731,
                0.0643185337481225628, 0.009262246321472481875}},
              {1.0,
               {0.8414709848078965067, 0.3011686789397567893,
                0.0620350520113738611, 0.009006581117112516259}},
              {2.0,
               {0.6984559986366083598, 0.2712561519356169432,
                0.05765622858512123487, 0.008512495494994615577}},
              {3.999999,
               {0.4546488222622908094, 0.2176989122959903931,
                0.04961199105941785904, 0.007590262647840387754}},
              {4.0,
               {0.4546487134128408477, 0.2176988874899958087,
                0.04961198726428664458, 0.007590262207859353558}},
              {5.5,
               {0.3048056687032542981, 0.182563858926927948,
                0.04416107419591446291, 0.006953002191389884823}},
              {7.0,
               {0.1798248520800360432, 0.1513419408840378351,
                0.03917156722458249458, 0.006359413605553519688}},
              {9.0,
               {0.04704000268662240737, 0.1152258332541186516,
                0.03318194411952594972, 0.005631543038167899666}},
              {9.8,
               {0.003544888814891374783, 0.1023962563631819018,
                0.03098406941578105189, 0.005359601093441158559}}};

/* An angle in (0, 3.1), as often in one decade as in another, from 1e-12. */
static double random_angle(struct unit_random *r) {
  double angle = pow(10, unit_random_in(r, -12, 0.5));
  return angle < 3.1 ? angle : 3.1;
}

/* A unit vector normal to p. */
static ph_vec3 random_tangent(struct unit_random *r, ph_vec3 p) {
  return ph_vec3_unit(
      ph_vec3_normal(ph_vec3_cross(p, unit_random_direction(r)), p));
}

/* f_0 vanishes at pi^2: its error is one of the angle. */
PH_TEST(test_bessel) {
  for (size_t i = 0; i < COUNT(bessel); i++) {
    double f[4], x = bessel[i].x;
    ph_s2_bessel(x, f);
    ck_abs(f[0], bessel[i].f[0], 2 * DBL_EPSILON);
    ck_abs(ph_s2_f0(x), bessel[i].f[0], DBL_EPSILON);
    for (size_t n = 1; n < 4; n++) {
      ck_rel(f[n], bessel[i].f[n], (x < 4 ? 4 : 16) * DBL_EPSILON);
    }
  }
}

/* f_0 = 1 - integral, f_{n-1} = (2 n + 1) f_n - X f_{n+1}, on both sides of
 * every threshold. */
PH_TEST(test_recurrence) {
  for (int i = 0; i <= 986; i++) {
    double f[4], x = 0.01 * i, cosine;
    ph_s2_bessel(x, f);
    cosine = f[0] - x * f[1];
    ck_abs(cosine, cos(sqrt(x)), 8 * DBL_EPSILON);
    ck_abs(f[0], 3 * f[1] - x * f[2], 8 * DBL_EPSILON);
    ck_abs(f[1], 5 * f[2] - x * f[3], 8 * DBL_EPSILON);
    ck_abs(ph_s2_f0(x), f[0], 4 * DBL_EPSILON);
  }
}

PH_TEST(test_angle) {
  struct unit_random r = unit_random_of(601);
  for (int i = 0; i < unit_count(2000); i++) {
    double angle = random_angle(&r);
    /* exact to rounding: q is p turned in a plane of coordinates */
    ph_vec3 p = {1, 0, 0}, q = {cos(angle), 0, sin(angle)};
    ck_rel(ph_s2_angle(p, q), angle, 4 * DBL_EPSILON);
    ck_rel(ph_s2_angle(q, p), angle, 4 * DBL_EPSILON);
    ck_rel(ph_s2_square(p, q), angle * angle, 8 * DBL_EPSILON);
  }
  ck_abs(ph_s2_angle(ph_vec3_of(0, 1, 0), ph_vec3_of(0, 1, 0)), 0, 0);
  ck_rel(ph_s2_angle(ph_vec3_of(0, 1, 0), ph_vec3_of(0, -1, 0)), PH_PI, 0);
}

PH_TEST(test_weight) {
  struct unit_random r = unit_random_of(602);
  for (int i = 0; i < unit_count(2000); i++) {
    double angle = random_angle(&r), tau = unit_random_in(&r, 0, 1);
    ck_rel(ph_s2_weight(tau, angle * angle), sin(tau * angle) / sin(angle),
           4 * DBL_EPSILON * (1 + 1 / sin(angle)));
  }
  ck_abs(ph_s2_weight(0.3, 0), 0.3, 0);
}

PH_TEST(test_slerp) {
  struct unit_random r = unit_random_of(603);
  for (int i = 0; i < unit_count(2000); i++) {
    ph_vec3 p = unit_random_direction(&r), v = random_tangent(&r, p), q, z;
    double angle = random_angle(&r), t = unit_random_in(&r, 0, 1);
    double tol = 16 * DBL_EPSILON / sin(angle < 1 ? 1 : angle);
    q = ph_s2_exp(p, ph_vec3_scale(angle, v));
    z = ph_s2_slerp(p, q, t);
    ck_abs(ph_vec3_abs(z), 1, tol);
    ck_vec3(z, ph_s2_exp(p, ph_vec3_scale(t * angle, v)), tol);
    ck_vec3(z, ph_s2_slerp(q, p, 1 - t), tol);
    ck_vec3(ph_s2_slerp(p, q, 0), p, DBL_EPSILON);
    ck_vec3(ph_s2_slerp(p, q, 1), q, DBL_EPSILON);
    ck_vec3(ph_s2_slerp(p, p, t), p, 4 * DBL_EPSILON);
  }
}

/* The points are rounded, which moves q by 1e-16 absolutely. */
PH_TEST(test_exp_log) {
  struct unit_random r = unit_random_of(604);
  for (int i = 0; i < unit_count(2000); i++) {
    ph_vec3 p = unit_random_direction(&r);
    double angle = random_angle(&r);
    double tol = 16 * DBL_EPSILON / sin(angle < 1 ? 1 : angle);
    ph_vec3 v = ph_vec3_scale(angle, random_tangent(&r, p));
    ph_vec3 q = ph_s2_exp(p, v), back = ph_s2_log(p, q);
    ck_abs(ph_vec3_abs(q), 1, 4 * DBL_EPSILON);
    ck_vec3(back, v, tol * (angle < 1 ? 1 : PH_PI));
    ck_rel(ph_vec3_abs(back), ph_s2_angle(p, q), tol);
    ck_abs(ph_vec3_dot(back, p), 0, tol);
    ck_vec3(ph_s2_exp(p, back), q, tol);
  }
  ck_vec3(ph_s2_log(ph_vec3_of(0, 0, 1), ph_vec3_of(0, 0, 1)),
          ph_vec3_of(0, 0, 0), 0);
}
