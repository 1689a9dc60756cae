/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Where the angles of Table 2.2 in Gonzalez (2018) come from: they minimise the
 * integral of (dkappa/dt)^2 |r'| over t, which is the thesis' MV with the
 * factor of the chain rule missing.  No functional of ours is that one, so that
 * the search is done here, by the simplex method of GSL.
 */
#include "planar_unit.h"
#include "unit.h"

#include "curve/segment/seg2.h"
#include "kernel/quad.h"

#include <gsl/gsl_multimin.h>

static const double PI = 3.14159265358979323846;
static const double POINTS[] = {-2.1,   1.8,    -0.8333, -0.1,
                                0.9833, 1.4167, 2.5667,  0.6};
static const double ENDS[] = {0.9918, -3.6084, 1.4668, -1.9834};
enum { N = 3, PARTS = 8, STEPS_MAX = 2000 };

static double integral(const struct ph_curve *curve, size_t k,
                       const struct ph_quad *rule) {
  struct ph_seg2 seg = ph_seg2_of(curve, k);
  double sum = 0, angle = seg.space.angle;
  for (int part = 0; part < PARTS; part++) {
    for (size_t i = 0; i < rule->n; i++) {
      struct ph_curvature bend =
          ph_seg2_curvature(&seg, (part + rule->node[i]) / PARTS);
      sum += rule->weight[i] / PARTS * bend.rate * bend.rate * bend.speed;
    }
  }
  return sum / (angle * angle);
}

static double thesis_mv(double *alpha) {
  struct unit_solution u = unit_planar_of(POINTS, N + 1, false);
  struct ph_quad rule;
  double sum = 0;
  unit_planar_ends(&u, ENDS);
  u.problem.field[PH_F_BASIS] =
      (struct ph_value){.kind = PH_WORD, .word = "atph"};
  u.problem.field[PH_F_ALPHA] =
      (struct ph_value){.kind = PH_NUMBERS, .v = alpha, .n = N, .dimension = 1};
  ck_assert_int_eq(unit_planar_solve(&u), PH_OK);
  ck_assert(ph_quad_gauss(&rule, 20));
  for (size_t k = 0; k < N; k++) {
    sum += integral(&u.result.curve, k, &rule);
  }
  unit_solution_free(&u);
  return sum;
}

/* The outer angles by their logarithms; the middle one is at its bound. */
static double objective(const gsl_vector *x, void *unused) {
  double alpha[N] = {exp(gsl_vector_get(x, 0)), 2 * PI / 3,
                     exp(gsl_vector_get(x, 1))};
  (void)unused;
  return alpha[0] < 3.1 && alpha[2] < 3.1 ? log(thesis_mv(alpha)) : 1e3;
}

PH_TEST(test_angles) {
  gsl_multimin_function f = {objective, 2, NULL};
  gsl_multimin_fminimizer *s =
      gsl_multimin_fminimizer_alloc(gsl_multimin_fminimizer_nmsimplex2, 2);
  gsl_vector *x = gsl_vector_alloc(2), *step = gsl_vector_alloc(2);
  double alpha[N];
  gsl_vector_set_all(x, 0);
  gsl_vector_set_all(step, 0.3);
  ck_assert_int_eq(gsl_multimin_fminimizer_set(s, &f, x, step), 0);
  for (int i = 0; i < STEPS_MAX && gsl_multimin_fminimizer_size(s) > 1e-7;
       i++) {
    ck_assert_int_eq(gsl_multimin_fminimizer_iterate(s), 0);
  }
  ck_assert_double_le(gsl_multimin_fminimizer_size(s), 1e-7);
  alpha[0] = exp(gsl_vector_get(s->x, 0));
  alpha[1] = 2 * PI / 3;
  alpha[2] = exp(gsl_vector_get(s->x, 1));
  ck_abs(alpha[0] / PI, 0.3671, 0.002);
  ck_abs(alpha[2] / PI, 0.3766, 0.002);
  {
    double less[N] = {alpha[0], 0.999 * alpha[1], alpha[2]};
    ck_assert_double_gt(thesis_mv(less),
                        thesis_mv(alpha)); /* the bound holds */
  }
  gsl_multimin_fminimizer_free(s);
  gsl_vector_free(x);
  gsl_vector_free(step);
}
