/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Raising tensions: against a plain loop that solves and judges the whole
 * spline in every round; what cannot be reached; ends; what is waived.
 */
#include "sphere_unit.h"
#include "unit.h"

enum { LONG = 140, ROUNDS = 400 };

static const struct unit_raise_kind open_kind = {false, PH_SPHERE_NATURAL,
                                                 &ph_sphere_exact, 0.05, false};
static const struct unit_raise_kind closed_kind = {
    true, PH_SPHERE_NATURAL, &ph_sphere_exact, 0.05, false};
/* ---- a plain loop -------------------------------------------------------- */
static void touch(const struct unit_raise *t,
                  enum ph_sphere_criterion criterion, size_t at,
                  bool *touched) {
  size_t node[4], n = ph_sphere_touched(&t->shape, criterion, at, node);
  for (size_t j = 0; j < n; j++) {
    touched[node[j]] = true;
  }
}

/* Which nodes are to be raised; how many. */
static size_t find_touched(const struct unit_raise *t, bool *touched) {
  const struct ph_sphere_data *d = &t->u.data;
  size_t n = 0;
  memset(touched, 0, d->n * sizeof *touched);
  for (size_t i = 0; i < d->n; i++) {
    touch(t, ph_sphere_node_fails(&t->shape, &t->u.spline, i), i, touched);
  }
  for (size_t k = 0; k < d->m; k++) {
    touch(t, ph_sphere_segment_fails(&t->shape, &t->u.spline, k), k, touched);
  }
  for (size_t i = 0; i < d->n; i++) {
    n += touched[i];
  }
  return n;
}

/* ret  in how many rounds all criteria hold */
static size_t raise_plainly(struct unit_raise *t) {
  bool times = t->raise.increase == PH_SPHERE_TIMES;
  double by = t->raise.by, *nu = t->u.spline.nu;
  bool touched[LONG];
  size_t rounds = 1;
  for (; find_touched(t, touched) > 0; rounds++) {
    ck_assert_uint_lt(rounds, ROUNDS);
    for (size_t i = 0; i < t->u.data.n; i++) {
      if (touched[i]) {
        nu[i] = !times ? nu[i] + by : nu[i] > 0 ? nu[i] * by : by;
      }
    }
    ck_assert(
        ph_sphere_newton(&t->u.spline, ph_sphere_all(&t->u.data), &t->u.work));
  }
  return rounds;
}

/* ret  the rounds, which are the same */
static size_t ck_plain(const ph_vec3 *p, size_t n,
                       const struct unit_raise_kind *kind,
                       enum ph_sphere_increase increase, double by) {
  struct unit_raise one, plain;
  size_t rounds;
  unit_raise_of(&one, n, p, kind);
  unit_raise_of(&plain, n, p, kind);
  one.raise.increase = plain.raise.increase = increase;
  one.raise.by = plain.raise.by = by;
  ck_assert_int_eq(unit_raise_go(&one), PH_OK);
  rounds = raise_plainly(&plain);
  ck_assert_msg(one.raise.rounds == rounds, "n %zu: %zu rounds, plainly %zu", n,
                one.raise.rounds, rounds);
  for (size_t i = 0; i < n; i++) {
    ck_rel(one.u.spline.nu[i], plain.u.spline.nu[i], 0);
  }
  ck_abs(unit_sphere_apart(&one.u, &plain.u), 0, 1e-12);
  ck_abs(unit_raise_missing(&one.u), 0, 1e-12);
  unit_raise_free(&one);
  unit_raise_free(&plain);
  return rounds;
}

/* Nearly a circle, but for `places` where three nodes leave it. */
static void bumps(size_t n, bool closed, const size_t *place, size_t places,
                  ph_vec3 *p) {
  struct unit_random none = {1};
  unit_raise_ring(&none, n, 0, closed, p);
  for (size_t i = 0; i < n; i++) {
    p[i] = ph_vec3_unit(ph_vec3_of(p[i].x, p[i].y, 0.3));
  }
  for (size_t j = 0; j < places; j++) {
    ph_vec3 q = p[place[j] % n];
    double off = 0.3 + 1.5 / (double)n;
    p[place[j] % n] = ph_vec3_unit(ph_vec3_of(q.x, q.y, off));
  }
}

/* Short data are solved whole; longer ones, from twice 30 nodes and one on, in
 * ranges, which may wrap, meet, and begin before the first node. */
PH_TEST_EACH(test_plain, 2) {
  static const size_t sizes[] = {59, 60, 61, 62, 63, 64, 66, 90, 125, LONG};
  static const size_t places[][3] = {
      {1, 0, 0}, {30, 31, 0}, {2, 58, 33}, {0, 64, 0}, {57, 25, 59}};
  size_t first = (size_t)_i, step = (size_t)(unit_count(10) < 10 ? 5 : 1);
  for (size_t k = first; k < COUNT(sizes); k += step) {
    for (size_t j = 0; j < 5; j += step) {
      bool closed = _i == 1;
      size_t place[3], n = sizes[k];
      ph_vec3 p[LONG];
      for (size_t c = 0; c < 3; c++) {
        place[c] = closed ? places[j][c] : 3 + places[j][c] % (n - 6);
      }
      bumps(n, closed, place, 3, p);
      ck_assert_uint_gt(ck_plain(p, n, closed ? &closed_kind : &open_kind,
                                 PH_SPHERE_TIMES, 2),
                        2);
    }
  }
}

PH_TEST(test_small) {
  struct unit_random r = {753};
  size_t raised = 0;
  for (int t = 0; t < unit_count(60); t++) {
    struct unit_raise_kind kind = t % 2 == 0 ? open_kind : closed_kind;
    size_t n = 3 + (size_t)(t / 2) % 4;
    ph_vec3 p[6];
    unit_sphere_path(&r, n, 0.2, 0.9, p);
    kind.model = t % 5 == 4 ? &ph_sphere_nielson : &ph_sphere_exact;
    raised += ck_plain(p, n, &kind, PH_SPHERE_PLUS, 40) > 1;
    ck_plain(p, n, &kind, PH_SPHERE_TIMES, 1.5);
  }
  ck_assert_uint_ge(raised, 1);
}

/* ---- what cannot be ------------------------------------------------------ */

/* From the equator, in steps of 0.4, off it after `straight` nodes. */
static void corner(size_t n, size_t straight, ph_vec3 *p) {
  for (size_t i = 0; i < n; i++) {
    double lon = 0.4 * (double)(i < straight ? i : straight - 1);
    double lat = i < straight ? 0 : 0.4 * (double)(i + 1 - straight);
    p[i] = ph_vec3_unit(
        ph_vec3_of(cos(lat) * cos(lon), cos(lat) * sin(lon), sin(lat)));
  }
}

/* At the bound of rounding only an infinite tension would do: the node that
 * bounds the run is raised to the largest one and not beyond; then nodes 1 and
 * 3 are done without, and it begins anew. */
PH_TEST_EACH(test_largest, 3) {
  static const double by[] = {0, 3e6, 3};
  struct unit_raise_kind kind = open_kind;
  struct unit_raise t;
  ph_vec3 p[5];
  kind.epsilon = 1e-12;
  corner(5, 3, p);
  unit_raise_of(&t, 5, p, &kind);
  t.raise.increase = (enum ph_sphere_increase)_i;
  t.raise.by = by[_i];
  t.raise.strict = true;
  for (size_t k = 0; k < 4; k++) {
    ck_abs(t.u.data.theta[k], 0.4, 1e-15);
    t.u.data.h[k] = t.u.data.theta[k] / 2;
  }
  ck_assert(ph_sphere_solve(&t.u.spline, &t.u.work));
  ck_assert_int_eq(unit_raise_go(&t), PH_E_NO_CONVERGENCE);
  ck_assert(t.raise.beyond);
  ck_assert_int_eq(t.raise.criterion, PH_SPHERE_COCIRCULARITY);
  ck_assert_uint_eq(t.raise.at, 1);
  /* of nodes 1, 2, 3, when these were given up: 2e8 / sqrt(0.4) */
  ck_rel(t.raise.kept_nu[0], 0, 0);
  ck_rel(t.raise.kept_nu[1], 2e8 * sqrt(2.5), 1e-15);
  t.raise.strict = false;
  ck_assert_int_eq(unit_raise_go(&t), PH_OK);
  ck_assert_uint_eq(t.raise.waived, 2);
  ck_assert_uint_eq(t.raise.never, 0);
  ck_rel(t.u.spline.nu[2], 0, 0);
  unit_raise_free(&t);
}

/* The ends of these data bound the run, and cannot be raised: what is done
 * without is counted, and the rest holds at the tensions of data that do not
 * ask it; the same for data read backwards. */
PH_TEST_EACH(test_waive, 2) {
  struct unit_raise_kind kind = open_kind;
  struct unit_raise t;
  bool back = _i == 1;
  ph_vec3 p[3], q[3];
  kind.ends = PH_SPHERE_CLAMPED;
  corner(3, 3, q);
  for (size_t i = 0; i < 3; i++) {
    p[i] = q[back ? 2 - i : i];
  }
  unit_raise_of(&t, 3, p, &kind);
  t.u.data.end[0] = ph_vec3_of(0, 0, 1);
  t.u.data.end[1] = ph_vec3_of(0, 0, -1);
  ck_assert(ph_sphere_solve(&t.u.spline, &t.u.work));
  t.raise.strict = true;
  ck_assert_int_eq(unit_raise_go(&t), PH_E_INFEASIBLE);
  ck_assert_int_eq(t.raise.criterion, PH_SPHERE_COCIRCULARITY);
  ck_assert_uint_eq(t.raise.at, 1);
  t.raise.strict = false;
  ck_assert_int_eq(unit_raise_go(&t), PH_OK);
  ck_assert_uint_eq(t.raise.waived, 1);
  ck_assert_uint_eq(t.raise.never, 1);
  ck_assert_uint_eq(t.raise.ignored[1], PH_SPHERE_IGNORE_NODE);
  ck_assert_int_eq(t.raise.criterion, PH_SPHERE_COCIRCULARITY);
  ck_assert_uint_eq(t.raise.at, 1);
  ck_rel(unit_raise_sum(&t), 0, 0);
  unit_raise_free(&t);
}

/* Where a run at either end cannot be straight, which tensions there are in the
 * end does not depend on the direction. */
PH_TEST(test_waive_reversed) {
  struct unit_random r = {755};
  size_t waived = 0, n = 12;
  for (int t = 0; t < unit_count(20); t++) {
    struct unit_raise_kind kind = open_kind;
    struct unit_raise one, other;
    ph_vec3 p[12], q[12];
    unit_raise_corners(&r, n, p);
    for (size_t i = 0; i < n; i++) {
      q[i] = p[n - 1 - i];
    }
    kind.epsilon = 1e-9; /* of which some cannot be reached */
    unit_raise_of(&one, n, p, &kind);
    unit_raise_of(&other, n, q, &kind);
    one.raise.increase = other.raise.increase = PH_SPHERE_TIMES;
    one.raise.by = other.raise.by = 2;
    ck_assert_int_eq(unit_raise_go(&one), PH_OK);
    ck_assert_int_eq(unit_raise_go(&other), PH_OK);
    ck_assert_uint_eq(one.raise.waived, other.raise.waived);
    ck_assert_uint_eq(one.raise.rounds, other.raise.rounds);
    for (size_t i = 0; i < n; i++) {
      ck_rel(one.u.spline.nu[i], other.u.spline.nu[n - 1 - i], 0);
    }
    if (one.raise.waived > 0) {
      size_t from = 0, at;
      memset(one.raise.ignored, 0, n);
      ck_assert_int_eq(ph_sphere_violated(
                           &one.raise, ph_sphere_all(&one.u.data), &from, &at),
                       one.raise.criterion);
      ck_assert_uint_eq(at, one.raise.at);
      waived++;
    }
    unit_raise_free(&one);
    unit_raise_free(&other);
  }
  ck_assert_uint_ge(waived, 1);
}

/* ---- ends ---------------------------------------------------------------- */

/* The ends of open data are raised in the measures of the thesis only, and not
 * where the least tensions are sought. */
PH_TEST_EACH(test_ends, 3) {
  struct unit_raise_kind kind = open_kind;
  struct unit_raise t;
  ph_vec3 p[5];
  double *nu;
  bool legacy = _i == 0;
  corner(5, 3, p);
  kind.legacy = legacy;
  kind.epsilon = legacy ? 1e-3 : 0.05;
  unit_raise_of(&t, 5, p, &kind);
  t.raise.increase = _i == 2 ? PH_SPHERE_MINIMAL : PH_SPHERE_PLUS;
  t.raise.by = 10;
  nu = t.u.spline.nu;
  ck_assert_int_eq(unit_raise_go(&t), PH_OK);
  ck_assert(unit_raise_holds(&t));
  ck_assert_uint_gt(t.raise.rounds, 1);
  ck_assert_int_eq(nu[0] > 0, legacy);
  ck_assert(nu[2] > 0);
  ck_rel(nu[4], nu[0], 0);
  unit_raise_free(&t);
}
