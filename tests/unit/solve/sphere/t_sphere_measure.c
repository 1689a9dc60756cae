/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Measures of shape against the criteria that they are measures of. */
#include "sphere_unit.h"
#include "unit.h"

#include "solve/sphere/sphere.h"

/* The margin, and how far a comparison of rounded numbers may be off. */
static const double MARGIN = 2e-3, ROUNDING = 1e-9;

/* What was seen of a kind of criterion: both verdicts have to occur. */
static size_t held[4], missed[4];

static double least_of(const double *g, size_t n) {
  double least = g[0];
  for (size_t j = 1; j < n; j++) {
    least = g[j] < least ? g[j] : least;
  }
  return least;
}

/* A node that fails has a negative measure; one that holds falls short of the
 * margin at most, which is a part `size` of the measure. */
static void ck_node(const struct unit_raise *t, size_t i) {
  double g[PH_SPHERE_MEASURES];
  size_t n = ph_sphere_measure_node(&t->shape, &t->u.spline, i, g);
  enum ph_sphere_criterion criterion =
      ph_sphere_node_fails(&t->shape, &t->u.spline, i);
  bool inorder = t->shape.inorder[i];
  int kind = inorder ? PH_SPHERE_COCIRCULARITY : PH_SPHERE_NODAL;
  size_t sides = t->shape.legacy ? 1 : 2;
  if (!inorder && t->shape.q[i] == 0) {
    ck_assert_uint_eq(n, 0);
    return;
  }
  ck_assert_uint_eq(n, inorder ? 4 : sides);
  if (criterion != PH_SPHERE_FINE) {
    missed[kind]++;
    ck_assert(least_of(g, n) < 0);
  } else {
    held[kind]++;
    ck_assert(least_of(g, n) >=
              -MARGIN * (inorder ? t->shape.epsilon : 1) - ROUNDING);
  }
}

static void ck_segment(const struct unit_raise *t, size_t k) {
  double g[PH_SPHERE_MEASURES], most = 0;
  size_t n = ph_sphere_measure_segment(&t->shape, &t->u.spline, k, g);
  size_t next = ph_sphere_next(&t->u.data, k);
  if (t->shape.q[k] * t->shape.q[next] <= 0) {
    ck_assert_uint_eq(n, 0);
    return;
  }
  ck_assert_uint_eq(n, PH_SPHERE_SAMPLES);
  for (size_t j = 0; j < n; j++) {
    most = unit_larger(most, g[j]);
  }
  if (ph_sphere_segment_fails(&t->shape, &t->u.spline, k) == PH_SPHERE_FINE) {
    held[PH_SPHERE_SEGMENT]++;
    ck_assert(least_of(g, n) > -MARGIN * most / (1 - MARGIN));
  } else if (least_of(g, n) < 0) {
    missed[PH_SPHERE_SEGMENT]++;
  }
}

static void ck_all(const struct unit_raise *t) {
  for (size_t i = 0; i < t->u.data.n; i++) {
    ck_node(t, i);
  }
  for (size_t k = 0; k < t->u.data.m; k++) {
    ck_segment(t, k);
  }
}

/* Tensions at random, some of them large: some criteria hold and others do not.
 */
static void change(struct unit_random *r, struct unit_raise *t) {
  for (size_t i = 0; i < t->u.data.n; i++) {
    t->u.spline.nu[i] = exp(unit_random_in(r, 0, 9));
  }
  ck_assert(ph_sphere_solve(&t->u.spline, &t->u.work));
}

PH_TEST(test_signs) {
  enum { NODES = 12 };
  struct unit_random r = {771};
  for (int t = 0; t < unit_count(300); t++) {
    struct unit_raise_kind kind = {t % 3 == 0, PH_SPHERE_NATURAL,
                                   &ph_sphere_exact, 0.05, t % 4 == 3};
    struct unit_raise one;
    ph_vec3 p[NODES];
    if (t % 2 == 0) {
      unit_raise_corners(&r, NODES, p);
    } else {
      unit_sphere_path(&r, NODES, 0.1, 0.8, p);
    }
    unit_raise_of(&one, NODES, p, &kind);
    ck_all(&one);
    change(&r, &one);
    ck_all(&one);
    unit_raise_free(&one);
  }
  for (int kind = PH_SPHERE_COCIRCULARITY; kind <= PH_SPHERE_SEGMENT; kind++) {
    ck_assert_uint_ge(held[kind], 10);
    ck_assert_uint_ge(missed[kind], 10);
  }
}

/* The four numbers of a node in order are the bound less and plus the curvature
 * on both sides. */
PH_TEST(test_bound) {
  const struct unit_raise_kind kind = {false, PH_SPHERE_NATURAL,
                                       &ph_sphere_exact, 0.01, false};
  const double bound = (1 - MARGIN) * 0.01;
  const ph_vec3 p[] = {{1, 0, 0},
                       {cos(0.3), sin(0.3), 0},
                       {cos(0.7), sin(0.7), 0},
                       {cos(0.7) * cos(0.5), sin(0.7) * cos(0.5), sin(0.5)}};
  struct unit_raise t;
  struct ph_spherical left, right;
  double g[PH_SPHERE_MEASURES], kappa;
  unit_raise_of(&t, 4, p, &kind);
  left = unit_sphere_segment(&t.u, 0);
  right = unit_sphere_segment(&t.u, 1);
  ck_assert_uint_eq(ph_sphere_measure_node(&t.shape, &t.u.spline, 1, g), 4);
  kappa = ph_spherical_curvature_end(&left);
  ck_assert(kappa < -0.01);
  ck_abs(g[0], bound - kappa, 1e-15);
  ck_abs(g[1], bound + kappa, 1e-15);
  kappa = ph_spherical_curvature_start(&right);
  ck_abs(g[2], bound - kappa, 1e-15);
  ck_abs(g[3], bound + kappa, 1e-15);
  unit_raise_free(&t);
}
