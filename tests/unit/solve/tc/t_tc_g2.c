/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Spans of curvature-continuous cubics: their curvatures and derivatives
 * against the cubics themselves and differences, and where there are none; that
 * the system has several solutions beyond what is proved of it; what memory is
 * counted for it.
 */
#include "problem_unit.h"
#include "unit.h"

#include "kernel/pi.h"
#include "solve/tc/g2.h"

#include <string.h>

/* ---- one cubic ----------------------------------------------------------- */

static double curvature(const struct ph_tc *tc, size_t end) {
  double speed = ph_cplx_norm2(tc->w[end]);
  return 2 * ph_cplx_cross(tc->w[0], tc->w[1]) / (speed * speed);
}

/* Angles that have a cubic, small ones among them. */
static void random_angles(struct unit_random *r, double *a, double *b) {
  do {
    double scale = pow(10, unit_random_in(r, -6, 0));
    *a = scale * unit_random_in(r, 1e-3, PH_PI);
    *b = scale * unit_random_in(r, 1e-3, PH_PI);
  } while (*a + *b > 4.15);
}

PH_TEST(test_arc) {
  struct unit_random r = unit_random_of(1);
  for (size_t i = 0; i < unit_cases(2000); i++) {
    struct ph_g2_ends e;
    struct ph_tc tc;
    ph_cplx leg;
    double a, b;
    random_angles(&r, &a, &b);
    unit_case("angles %.17g, %.17g", a, b);
    ck_assert(ph_g2_arc(a, b, &e));
    tc = ph_g2_preimage(a, b);
    leg = ph_tc_leg(&tc);
    ck_abs(hypot(leg.re - 1, leg.im), 0, 1e-11);
    ck_abs(ph_tc_turning(&tc), a + b, 1e-13);
    ck_assert(!ph_tc_has_loop(&tc));
    ck_rel(exp(e.f), curvature(&tc, 0), 1e-11);
    ck_rel(exp(e.g), curvature(&tc, 1), 1e-11);
  }
}

/* With equal angles the curvature is (2/3) sin a (1 + 2 cos a). */
PH_TEST(test_equal_angles) {
  for (int i = 1; i < 20; i++) {
    double a = i * PH_PI / 30;
    struct ph_g2_ends e;
    ck_assert(ph_g2_arc(a, a, &e));
    ck_rel(exp(e.f), 2. / 3 * sin(a) * (1 + 2 * cos(a)), 1e-13);
    ck_rel(exp(e.g), exp(e.f), 1e-14);
  }
}

typedef bool span(double a, double b, struct ph_g2_ends *ends);

/* All derivatives of a span against differences. */
static void ck_derivatives(span *of, double a, double b) {
  const double step = 1e-5 * fmin(fabs(a) + fabs(b), 0.1);
  struct ph_g2_ends e, up, down;
  double size;
  unit_case("angles %.17g, %.17g", a, b);
  ck_assert(of(a, b, &e));
  size = 1 / (fmin(fabs(a), fabs(b)) + step);
  ck_assert(of(a + step, b, &up) && of(a - step, b, &down));
  ck_abs(e.f_a, (up.f - down.f) / (2 * step), 1e-5 * size);
  ck_abs(e.g_a, (up.g - down.g) / (2 * step), 1e-5 * size);
  ck_assert(of(a, b + step, &up) && of(a, b - step, &down));
  ck_abs(e.f_b, (up.f - down.f) / (2 * step), 1e-5 * size);
  ck_abs(e.g_b, (up.g - down.g) / (2 * step), 1e-5 * size);
}

PH_TEST(test_arc_derivatives) {
  struct unit_random r = unit_random_of(2);
  for (size_t i = 0; i < unit_cases(500); i++) {
    double a, b;
    do {
      random_angles(&r, &a, &b);
    } while (a < b / 100 || b < a / 100 || a + b > 4);
    ck_derivatives(ph_g2_arc, a, b);
  }
}

/* ---- bends --------------------------------------------------------------- */

/* Both cubics, on their chords of the chord 1; the second turns right. */
PH_TEST(test_bend) {
  struct unit_random r = unit_random_of(3);
  for (size_t i = 0; i < unit_cases(500); i++) {
    double a = unit_random_in(&r, 0.02, 1.2);
    double b = unit_random_in(&r, -a / 5, a);
    struct ph_g2_bend bend = ph_g2_bend_of(a, b);
    struct ph_g2_ends e;
    double first = atan2(bend.joint.im, bend.joint.re);
    double last = atan2(-bend.joint.im, 1 - bend.joint.re), k;
    struct ph_tc tc = ph_g2_preimage(bend.a[0], bend.b[0]);
    unit_case("angles %.17g, %.17g", a, b);
    ck_assert(ph_g2_bend_ends(a, b, &e));
    /* the tangents at the ends and, from both sides, at the joint */
    ck_abs(first - bend.a[0], -a, 1e-14);
    ck_abs(last - bend.b[1], -b, 1e-14);
    ck_abs(first + bend.b[0], last + bend.a[1], 1e-14);
    k = curvature(&tc, 0) / hypot(bend.joint.re, bend.joint.im);
    ck_rel(exp(e.f), k, 1e-12);
    tc = ph_g2_preimage(bend.a[1], bend.b[1]);
    k = curvature(&tc, 1) / hypot(1 - bend.joint.re, bend.joint.im);
    ck_rel(exp(e.g), k, 1e-12);
    if (fabs(b) > 0.01) {
      ck_derivatives(ph_g2_bend_ends, a, b);
    }
  }
}

/* ---- where there are none ------------------------------------------------ */

static const struct {
  span *of;
  double a, b;
} NONE[] = {{ph_g2_arc, 0, 1},           {ph_g2_arc, 1, 0},
            {ph_g2_arc, -1e-9, 1},       {ph_g2_arc, 1.1, PH_PI},
            {ph_g2_arc, 2.1, 2.1},       {ph_g2_arc, (double)NAN, 1},
            {ph_g2_arc, 1, (double)NAN}, {ph_g2_bend_ends, -0.2, 0.2},
            {ph_g2_bend_ends, -1, 0.5},  {ph_g2_bend_ends, 0.5, -0.4},
            {ph_g2_bend_ends, 3.5, 0.5}, {ph_g2_bend_ends, (double)NAN, 1}};

PH_TEST_EACH(test_none, COUNT(NONE)) {
  struct ph_g2_ends e;
  ck_assert(!NONE[_i].of(NONE[_i].a, NONE[_i].b, &e));
}

/* ---- several solutions ----------------------------------------------------
 */

/*
 * Equal chords, six turns of 115 degrees, and 57.5 degrees at both ends: parts
 * of the turns before each point, of which the first solve the system by
 * symmetry, and the second, too.  The sum of neighbouring turns, 230 degrees,
 * is below the bound pi + arccos(1/sqrt 3) = 234.7 degrees that is quoted for
 * there being only one.
 */
static const double PARTS[][6] = {{0.5, 0.5, 0.5, 0.5, 0.5, 0.5},
                                  {.6824320875, .2246041364, .8293779436,
                                   .1706220564, .7753958636, .3175679125}};

PH_TEST_EACH(test_not_unique, COUNT(PARTS)) {
  const double turn = 115 * PH_PI / 180;
  double a[7], b[7], worst = 0;
  a[0] = b[6] = turn / 2;
  for (size_t k = 0; k < 6; k++) {
    b[k] = turn * PARTS[_i][k];
    a[k + 1] = turn * (1 - PARTS[_i][k]);
  }
  for (size_t k = 0; k < 6; k++) {
    struct ph_g2_ends before, after;
    ck_assert(ph_g2_arc(a[k], b[k], &before));
    ck_assert(ph_g2_arc(a[k + 1], b[k + 1], &after));
    worst = fmax(worst, fabs(before.g - after.f));
  }
  ck_abs(worst, 0, 1e-8);
}

/* ---- the memory of blocks ------------------------------------------------ */

enum { LONG = 2000, HARD = 300, BESIDE_AND_BLOCK = 176 };

/* LONG turns of 0.2 to the left on chords of 1, but for some from `hard' on,
 * which are to both sides on chords whose lengths are far apart: Newton's
 * method fails there, for all at once. */
static void set_spiral(double *points, size_t hard) {
  struct unit_random r = unit_random_of(4);
  ph_cplx p = {0, 0};
  double angle = 0;
  for (size_t k = 0; k <= LONG; k++) {
    const bool is_hard = k >= hard && k < hard + HARD;
    const double chord = is_hard ? exp(unit_random_in(&r, -1, 1)) : 1;
    points[2 * k] = p.re;
    points[2 * k + 1] = p.im;
    angle += is_hard ? unit_random_in(&r, -1, 1) : 0.2;
    p = ph_cplx_add(p, ph_cplx_scale(chord, ph_cplx_polar(angle)));
  }
}

/* With so many bytes for the angles of the chain, and threads to spare. */
static enum ph_status solve_within(const struct ph_g2_chain *chain,
                                   size_t bytes, int threads) {
  atomic_int spare = threads;
  struct ph_budget budget = {.spare = &spare};
  struct ph_arena arena = {.budget = &budget};
  struct ph_g2_solution solution;
  struct ph_diag diag;
  enum ph_status status;
  ph_budget_start(&budget, bytes, 0);
  status = ph_g2_solve(chain, PH_G2_CIRCLE, &arena, &solution, &diag);
  ck_assert_int_eq(atomic_load(&spare), threads);
  ck_assert_uint_eq(budget.needed > 0, status == PH_E_NO_MEMORY);
  ph_arena_free(&arena);
  return status;
}

/* The least that is enough, to 16 bytes. */
static size_t least_for(const struct ph_g2_chain *chain, int threads) {
  size_t low = 0, high = 1 << 21;
  ck_assert_int_eq(solve_within(chain, high, threads), PH_OK);
  while (high - low > 16) {
    const size_t middle = (low + high) / 2;
    if (solve_within(chain, middle, threads) == PH_OK) {
      high = middle;
    } else {
      low = middle;
    }
  }
  return high;
}

static size_t least_of_spiral(size_t hard, int threads) {
  static double points[2 * (LONG + 1)];
  struct ph_problem problem = {.field = {{.kind = PH_ABSENT}}};
  struct ph_tc_data data;
  struct ph_g2_chain chain;
  struct ph_diag diag;
  const ph_cplx free_ends[2] = {{(double)NAN, 0}, {(double)NAN, 0}};
  unsigned char *marks = ph_arena_array(&unit_arena, 2 * (LONG + 1), 1);
  set_spiral(points, hard);
  memset(marks, 0, 2 * (LONG + 1));
  unit_set_array(&problem, PH_F_POINTS, points, LONG + 1, 2);
  ck_assert_int_eq(ph_tc_data_of(&problem, PH_TC_G2, &unit_arena, &data, &diag),
                   PH_OK);
  chain = (struct ph_g2_chain){
      .data = &data, .loose = marks, .hard = marks + LONG + 1};
  ck_assert_int_eq(
      ph_g2_chain_of(0, LONG, free_ends, &unit_arena, &chain, &diag), PH_OK);
  ck_assert_int_eq(ph_g2_plan(&chain, false, &unit_arena, &diag), PH_OK);
  ck_assert_uint_eq(chain.n, LONG);
  return least_for(&chain, threads);
}

/* What blocks are solved in counts for the budget, and more threads take no
 * more than there is: the least is that of one. */
PH_TEST(test_blocks_in_budget) {
  const size_t easy = least_of_spiral(LONG, 0), hard = least_of_spiral(999, 0);
  ck_assert_uint_ge(hard - easy,
                    BESIDE_AND_BLOCK *
                        (sizeof(struct ph_g2_node) + sizeof(struct ph_g2_span) +
                         sizeof(struct ph_g2_ends)));
  ck_assert_uint_eq(least_of_spiral(999, 3), hard);
}
