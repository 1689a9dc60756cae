/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Every curve of Tschirnhausen cubics: the product of what the intervals have,
 * its order and its limits. */
#include "tc_unit.h"
#include "unit.h"

#include "curve/cross/cross.h"
#include "curve/fair/energy.h"
#include "solve/tc/tc.h"

enum { ROOM = 20 };

/* Points that go right and up and down. */
static double zigzag[2 * ROOM];

static struct unit_solution spline_of(double *v, size_t n, const char *which) {
  struct unit_solution s = {.result = {.offsets_n = 0}};
  unit_set_array(&s.problem, PH_F_POINTS, v, n, 2);
  unit_set_word(&s.problem, PH_F_SOLUTIONS, which);
  return s;
}

static void set_zigzag(void) {
  struct unit_random r = unit_random_of(1);
  for (size_t i = 0; i < ROOM; i++) {
    zigzag[2 * i] = (double)i;
    zigzag[2 * i + 1] = unit_random_in(&r, -1, 1);
  }
}

static bool is_regular(const struct ph_curve *curve) {
  bool regular = true;
  for (size_t i = 0; i < curve->n; i++) {
    const double *w = ph_curve_preimage(curve, i);
    struct ph_tc tc = {{unit_get(w), unit_get(w + 2)}};
    regular = regular && ph_tc_is_regular(&tc);
  }
  return regular;
}

static bool is_simple(const struct ph_curve *curve) {
  struct ph_cross cross;
  struct ph_diag diag;
  ck_assert_int_eq(ph_cross_planar(curve, &unit_arena, &cross, &diag), PH_OK);
  return cross.simple;
}

/* Simple ones, then regular ones, each by energy. */
static void check_order(const struct ph_result *r) {
  int kind_before = 0;
  double energy_before = 0;
  for (size_t i = 0; i < r->solutions_n; i++) {
    const struct ph_curve *curve = &r->solutions[i].curve;
    int kind = !is_regular(curve) ? 2 : is_simple(curve) ? 0 : 1;
    struct ph_energy energy = {.bending = 0};
    ck_assert_int_ge(kind, kind_before);
    if (kind < 2) {
      ck_assert(ph_energy_planar(curve, &energy));
      ck_assert(kind > kind_before ||
                energy.bending >= energy_before * (1 - 1e-8));
    }
    kind_before = kind;
    energy_before = energy.bending;
  }
}

/* The roots of the intervals of a solution, as a number. */
static size_t code_of(const struct ph_solution *s, size_t intervals) {
  size_t code = 0;
  for (size_t k = 0; k < intervals; k++) {
    code = code * PH_ROOT_N + s->intervals[k].root;
  }
  return code;
}

/* No two are the same, and each says what its intervals are. */
static void check_solutions(const struct ph_result *r) {
  for (size_t i = 0; i < r->solutions_n; i++) {
    const struct ph_solution *s = &r->solutions[i];
    size_t next = 0;
    double length = 0;
    for (size_t k = 0; k < r->intervals_n; k++) {
      ck_assert_uint_eq(s->intervals[k].first, next);
      next = s->intervals[k].last + 1;
      length += s->intervals[k].length;
    }
    ck_assert_uint_eq(next, s->curve.n);
    ck_rel(s->curve.length, length, 1e-14);
    for (size_t j = 0; j < i; j++) {
      ck_assert_uint_ne(code_of(s, r->intervals_n),
                        code_of(&r->solutions[j], r->intervals_n));
    }
  }
}

/* One is good: that which is given alone.  Returns its place. */
static size_t check_good(struct unit_solution *all) {
  struct unit_solution best = {.problem = all->problem};
  size_t good = 0, n = 0;
  unit_set_word(&best.problem, PH_F_SOLUTIONS, "best");
  unit_tc_solve_ok(&best);
  for (size_t i = 0; i < all->result.solutions_n; i++) {
    if (all->result.solutions[i].good) {
      good = i;
      n++;
    }
  }
  ck_assert_uint_eq(n, 1);
  ck_assert_uint_eq(best.result.solutions_n, 0);
  ck_abs(
      unit_curves_apart(&best.result.curve, &all->result.solutions[good].curve),
      0, 1e-14);
  unit_solution_free(&best);
  return good;
}

/* The curve is the first one. */
static void check_first(const struct ph_result *r) {
  const struct ph_solution *first = &r->solutions[0];
  ck_assert_ptr_eq(r->curve.control_points, first->curve.control_points);
  ck_assert_ptr_eq(r->intervals, first->intervals);
  ck_assert_int_eq(
      memcmp(&r->diagnostics, &first->diagnostics, sizeof r->diagnostics), 0);
}

/* ---- products ------------------------------------------------------------ */

/* Pairs have four curves in each interval. */
PH_TEST(test_splines) {
  struct unit_random r = unit_random_of(2);
  for (int i = 0; i < unit_count(10); i++) {
    bool closed = i % 2;
    size_t n = 3 + (size_t)i % 2;
    double v[2 * 4];
    struct unit_solution s;
    for (size_t k = 0; k < 2 * n; k++) {
      v[k] = unit_random_in(&r, -1, 1);
    }
    s = spline_of(v, n, "all");
    if (closed) {
      unit_tc_flag(&s, PH_F_CLOSED);
    }
    unit_tc_solve_ok(&s);
    n -= closed ? 0 : 1;
    ck_assert_uint_eq(s.result.intervals_n, n);
    ck_assert_uint_eq(s.result.solutions_n, (size_t)1 << 2 * n);
    check_solutions(&s.result);
    check_order(&s.result);
    check_first(&s.result);
    check_good(&s);
    unit_solution_free(&s);
  }
}

/* One cubic has two, of which one has a loop [BYR11, example 1]. */
PH_TEST(test_one_interval) {
  double v[] = {0, 1, 6, 1}, tangents[] = {1, -1, 1, 1};
  struct unit_solution s = spline_of(v, 2, "all");
  const struct ph_result *r = &s.result;
  unit_set_array(&s.problem, PH_F_TANGENTS, tangents, 2, 2);
  unit_set_word(&s.problem, PH_F_MODE, "g1");
  unit_tc_solve_ok(&s);
  ck_assert_uint_eq(r->solutions_n, 2);
  check_solutions(r);
  check_first(r);
  ck_assert_uint_eq(check_good(&s), 0);
  ck_assert(is_simple(&r->solutions[0].curve));
  ck_assert(!is_simple(&r->solutions[1].curve));
  ck_assert_uint_eq(r->warnings_n, 0);
  for (size_t i = 0; i < 2; i++) {
    const struct ph_solution *one = &r->solutions[i];
    ck_abs(one->diagnostics.value[PH_D_ROOT], one->intervals[0].root, 0);
    ck_abs(one->diagnostics.value[PH_D_RATIO], one->intervals[0].ratio, 0);
    ck_abs(fabs(one->intervals[0].ratio), 1, 1e-14);
  }
  unit_solution_free(&s);
}

/* Each interval the same: all curves of the second are those of the first,
 * moved. */
PH_TEST(test_combinations) {
  double v[] = {0, 1, 6, 1, 12, 1}, tangents[] = {1, -1, 1, 1, 1, -1};
  struct unit_solution s = spline_of(v, 3, "all");
  size_t seen[2][2] = {{0, 0}, {0, 0}};
  unit_set_array(&s.problem, PH_F_TANGENTS, tangents, 3, 2);
  unit_set_word(&s.problem, PH_F_MODE, "g1");
  unit_tc_solve_ok(&s);
  ck_assert_uint_eq(s.result.solutions_n, 4);
  for (size_t i = 0; i < 4; i++) {
    const struct ph_interval *at = s.result.solutions[i].intervals;
    ck_assert_int_le(at[0].root, PH_ROOT_MINUS);
    ck_assert_int_le(at[1].root, PH_ROOT_MINUS);
    seen[at[0].root][at[1].root]++;
  }
  for (size_t i = 0; i < 4; i++) {
    ck_assert_uint_eq(seen[i / 2][i % 2], 1);
  }
  check_order(&s.result);
  ck_assert_uint_eq(check_good(&s), 0);
  unit_solution_free(&s);
}

/* The best curves of the intervals may cross each other: then good is not
 * first. */
PH_TEST(test_good_is_not_first) {
  struct unit_random r = unit_random_of(3);
  size_t later = 0;
  for (int i = 0; i < 40; i++) {
    double v[6];
    struct unit_solution s = spline_of(v, 3, "all");
    size_t good;
    for (size_t k = 0; k < 6; k++) {
      v[k] = unit_random_in(&r, -1, 1);
    }
    unit_set_number(&s.problem, PH_F_LAMBDA, unit_random_in(&r, 2, 6));
    unit_tc_solve_ok(&s);
    good = check_good(&s);
    check_order(&s.result);
    later += good > 0;
    ck_assert(good == 0 || !is_simple(&s.result.solutions[good].curve));
    unit_solution_free(&s);
  }
  ck_assert_uint_gt(later, 0);
}

/* ---- limits -------------------------------------------------------------- */

static void too_many(struct unit_solution *s) {
  unit_tc_refused(s, PH_E_BAD_VALUE, "solutions",
                  "must not be all with more than 4096 curves, or 65536 "
                  "intervals in all of them");
  unit_solution_free(s);
}

/* 4^6 curves, and 4^7. */
PH_TEST(test_most_curves) {
  struct unit_solution s = spline_of(zigzag, 7, "all");
  set_zigzag();
  unit_tc_solve_ok(&s);
  ck_assert_uint_eq(s.result.solutions_n, PH_TC_ALL_MAX);
  check_first(&s.result);
  unit_solution_free(&s);
  s = spline_of(zigzag, 8, "all");
  too_many(&s);
}

/* Twelve intervals with two cubics and some with one, a line: 2^12 curves of
 * sixteen intervals, and no more. */
PH_TEST(test_most_intervals) {
  for (size_t lines = 4; lines <= 5; lines++) {
    double tangents[2 * ROOM], v[2 * ROOM];
    size_t n = 12 + lines;
    struct unit_solution s = spline_of(v, n + 1, "all");
    for (size_t i = 0; i <= n; i++) {
      v[2 * i] = (double)i;
      v[2 * i + 1] = 0;
      tangents[2 * i] = 1;
      tangents[2 * i + 1] = i <= 12 ? (i % 2 ? 1 : -1) : 0;
    }
    unit_set_array(&s.problem, PH_F_TANGENTS, tangents, n + 1, 2);
    unit_set_word(&s.problem, PH_F_MODE, "g1");
    if (n <= PH_TC_ALL_INTERVALS / PH_TC_ALL_MAX) {
      unit_tc_solve_ok(&s);
      ck_assert_uint_eq(s.result.solutions_n, PH_TC_ALL_MAX);
      ck_assert_uint_eq(s.result.intervals_n, n);
      unit_solution_free(&s);
    } else {
      too_many(&s);
    }
  }
}

/* Of one curve there may be too many intervals, too. */
PH_TEST(test_long_line) {
  size_t n = PH_TC_ALL_INTERVALS + 2;
  double *v = calloc(2 * n, sizeof *v);
  struct unit_solution s = spline_of(v, n, "all");
  ck_assert_ptr_nonnull(v);
  for (size_t i = 0; i < n; i++) {
    v[2 * i] = (double)i;
  }
  too_many(&s);
  free(v);
}

/* ---- failures and crossings ---------------------------------------------- */

/* An interval without a curve. */
PH_TEST(test_none) {
  double v[] = {0, 1, 6, 1, 12, 1}, tangents[] = {1, -1, 1, 1, 1, 1};
  struct unit_solution s = spline_of(v, 3, "all");
  unit_set_array(&s.problem, PH_F_TANGENTS, tangents, 3, 2);
  unit_set_word(&s.problem, PH_F_MODE, "g1");
  unit_tc_refused(&s, PH_E_INFEASIBLE, "segments[1]",
                  "no Tschirnhausen cubic has angles");
  unit_solution_free(&s);
}

/* The curve of one interval by itself. */
static struct ph_curve part_of(const struct ph_result *r, size_t k) {
  const struct ph_interval *at = &r->intervals[k];
  struct ph_curve part = r->curve;
  part.closed = false;
  part.n = at->last - at->first + 1;
  part.length = at->length;
  part.knots += at->first;
  part.control_points += ph_curve_stride(&part) * at->first;
  part.preimage.v += 4 * at->first;
  part.lengths += at->first;
  return part;
}

/* Crossings are those of the first curve, by interval. */
PH_TEST(test_crossings) {
  struct unit_random r = unit_random_of(4);
  size_t seen[3] = {0, 0, 0};
  for (int i = 0; i < 40; i++) {
    double v[] = {0, 0, 1, 0, 2, 0}, vectors[6];
    struct unit_solution s = spline_of(v, 3, "all");
    struct ph_tc_crossings crossings = {0, 0};
    struct ph_tc_data data;
    size_t n = 0, first = 0;
    for (size_t k = 0; k < 6; k++) {
      vectors[k] = unit_random_in(&r, -4, 4);
    }
    unit_set_array(&s.problem, PH_F_DERIVATIVES, vectors, 3, 2);
    ck_assert_int_eq(
        ph_tc_data_of(&s.problem, PH_TC_C1, &s.scratch, &data, &s.diag), PH_OK);
    ck_assert_int_eq(
        ph_tc_all(&data, &s.arena, &s.scratch, &s.result, &crossings, &s.diag),
        PH_OK);
    for (size_t k = 0; k < 2; k++) {
      struct ph_curve part = part_of(&s.result, k);
      if (!is_simple(&part)) {
        first = n == 0 ? k : first;
        n++;
      }
    }
    ck_assert_uint_eq(crossings.n, n);
    ck_assert_uint_eq(crossings.first, first);
    seen[n]++;
    unit_solution_free(&s);
  }
  for (size_t n = 0; n < 2; n++) {
    ck_assert_uint_gt(seen[n], 0);
  }
}
