/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Gauss rules: exact for the degrees promised, and for no more. */
#include "unit.h"

#include "kernel/quad.h"

static double moment(const struct ph_quad *rule, double power) {
  double sum = 0;
  for (size_t i = 0; i < rule->n; i++) {
    sum += rule->weight[i] * pow(rule->node[i], power);
  }
  return sum;
}

PH_TEST(test_moments) {
  for (size_t n = 1; n <= PH_QUAD_MAX; n++) {
    struct ph_quad rule;
    ck_assert(ph_quad_gauss(&rule, n));
    ck_assert_uint_eq(rule.n, n);
    for (size_t power = 0; power < 2 * n; power++) {
      ck_rel(moment(&rule, (double)power), 1 / (double)(power + 1),
             32 * DBL_EPSILON);
    }
  }
}

/* The next moment is missed by (n!)^4 / ((2n + 1) (2n)!^2). */
PH_TEST(test_next_moment) {
  double missed = 1;
  for (size_t n = 1; n <= 10; n++) {
    double k = (double)n, wanted;
    struct ph_quad rule;
    missed *= pow(k, 4) / pow((2 * k - 1) * 2 * k, 2);
    wanted = 1 / (2 * k + 1) - missed / (2 * k + 1);
    ck_assert(ph_quad_gauss(&rule, n));
    ck_rel(moment(&rule, 2 * k), wanted, 32 * DBL_EPSILON);
  }
}

PH_TEST(test_nodes) {
  for (size_t n = 1; n <= PH_QUAD_MAX; n++) {
    struct ph_quad rule;
    ck_assert(ph_quad_gauss(&rule, n));
    for (size_t i = 0; i < n; i++) {
      size_t j = n - 1 - i;
      ck_assert(rule.node[i] > 0 && rule.node[i] < 1);
      ck_assert(rule.weight[i] > 0);
      ck_assert(i == 0 || rule.node[i] > rule.node[i - 1]);
      ck_abs(rule.node[i], 1 - rule.node[j], DBL_EPSILON);
      ck_rel(rule.weight[i], rule.weight[j], DBL_EPSILON);
    }
  }
}
