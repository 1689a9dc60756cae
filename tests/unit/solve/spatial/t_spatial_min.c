/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The fairest members of spatial families: known minima, and what a dense grid
 * finds. */
#include "unit.h"
#include "spatial_unit.h"

#include "solve/spatial/fairest.h"

static const double TURN = 6.283185307179586;

static struct ph_fair3_rules rules;

static void begin(void) {
  ck_assert(ph_fair3_begin(&rules));
}

static struct ph_spatial_search search_of(const struct ph_spatial_data *data,
                                          bool atph, int functional) {
  struct ph_spatial_search search = {data, atph, 0, 0, functional, false};
  if (atph) {
    search.alpha_lower = PH_SPATIAL_ALPHA_MIN;
    search.alpha_upper = PH_SPATIAL_ALPHA_MAX;
  }
  return search;
}

static struct ph_spatial_minimum
minimize(const struct ph_spatial_search *search) {
  struct ph_spatial_minimum found;
  ck_assert_int_eq(ph_spatial_minimize(search, &rules, &unit_arena, &found),
                   PH_OK);
  return found;
}

/* The family at alpha, made without the shortcuts of spatial/fair.c. */
static struct ph_spatial_family
family_at(const struct ph_spatial_search *search, double alpha) {
  struct ph_spatial_data data = *search->data;
  struct ph_atph space = ph_atph_of(alpha);
  if (search->scaled) {
    data.ni *= alpha;
    data.nf *= alpha;
  }
  return ph_spatial_family_of(&data, &space);
}

static double value_of(const struct ph_spatial_search *search,
                       const struct ph_spatial_minimum *found) {
  struct ph_spatial_family family = family_at(search, found->alpha);
  struct ph_fair3 fair;
  ph_quat a[3];
  ph_spatial_preimage(&family, found->member, a);
  fair = ph_fair3_of(&rules, &family.space, a);
  return ph_fair3_functional(&fair, ph_seg3_length(&family.space, a),
                             search->functional);
}

/* ---- the functional and its gradient ---------------------------------- */

PH_TEST(test_gradient) {
  const double h = 1e-5;
  struct unit_random r = unit_random_of(1110);
  int smooth = 0;
  for (int n = 0; n < unit_count(300); n++) {
    struct ph_spatial_data data = unit_random_spatial(&r);
    struct ph_atph space = ph_atph_of(1);
    struct ph_spatial_family family = ph_spatial_family_of(&data, &space);
    struct ph_spatial_target target = {&rules.rule, &family, n % 2,
                                       1 + n / 2 % 3};
    double gradient[3], size = 0;
    const double x[3] = {unit_random_in(&r, -3, 3), unit_random_in(&r, -3, 3),
                         unit_random_in(&r, 0.01, 2)};
    struct ph_spatial_point at = {x[0], x[1], x[2]};
    double value = ph_spatial_fair(&target, 8, &at, gradient);
    for (int i = 0; i < 3; i++) {
      size += fabs(gradient[i]);
    }
    if (size > 100 * value) {
      continue; /* too steep for the difference below */
    }
    smooth++;
    for (int i = 0; i < 3; i++) {
      double side[2];
      for (int k = 0; k < 2; k++) {
        double to[3] = {x[0], x[1], x[2]};
        to[i] += k ? h : -h;
        at = (struct ph_spatial_point){to[0], to[1], to[2]};
        side[k] = ph_spatial_fair(&target, 8, &at, NULL);
      }
      ck_abs(gradient[i], (side[1] - side[0]) / (2 * h), 1e-5 * (value + size));
    }
  }
  ck_assert_int_ge(smooth, unit_count(300) / 2);
}

/* The fixed quadrature tends to the adaptive one. */
PH_TEST(test_value) {
  struct unit_random r = unit_random_of(1111);
  for (int n = 0; n < 60; n++) {
    struct ph_spatial_data data = unit_random_spatial(&r);
    struct ph_spatial_search search = search_of(&data, n % 2, 1 + n / 2 % 3);
    struct ph_atph space = ph_atph_of(1);
    struct ph_spatial_family family = ph_spatial_family_of(&data, &space);
    struct ph_spatial_target target = {&rules.rule, &family, search.scaled,
                                       search.functional};
    struct ph_spatial_point at = {unit_random_in(&r, -3, 3), 0.3,
                                  unit_random_in(&r, 0.01, 2)};
    struct ph_spatial_minimum same = {
        .member = {ph_cplx_polar(at.b), ph_cplx_polar(at.phi)},
        .alpha = at.alpha};
    double found = ph_spatial_fair(&target, 64, &at, NULL);
    if (fabs(found / ph_spatial_fair(&target, 32, &at, NULL) - 1) < 1e-9) {
      ck_rel(found, value_of(&search, &same), 1e-9);
    }
  }
}

/* ---- known minima ----------------------------------------------------- */

/* Not in the reference. */
#define UNKNOWN 1e300

struct row {
  const char *name;
  double dp[3], d[2][3];
  double most[2][3];   /* the least known values: PH and ATPH, F1 to F3 */
  double length[2][3]; /* there */
};

/* [GON18, tables 3.4 to 3.7, figures 3.14 and 3.15], recomputed; 2c is the case
 * that its table 3.3 means by 2.  The circular helix is in the family. */
static const struct row ROWS[] = {
    {"case 1",
     {1, 1, 1},
     {{1, 0, 1}, {0, 1, 1}},
     {{2.301113653, 25.41701026, 33.95313444},
      {2.214068262, 1.409643253e-08, 0.009444206204}},
     {{1.822729147, 1.825091323, 1.819387052},
      {1.83692427, 1.871952995, 1.871941125}}},
    {"case 2",
     {1, 1, 1},
     {{-0.8, 0.3, 1.2}, {0, 1, 1}},
     {{11.45712303, 293.8431472, 338.3088617},
      {10.71140342, 6.104196722, 36.69347877}},
     {{1.877965761, 1.905638705, 1.928403754},
      {1.93793773, 2.511019783, 2.564697591}}},
    {"case 2c",
     {1, 1, 1},
     {{-0.8, 0.3, 1.2}, {0.5, -1.3, -1}},
     {{19.48842885, 515.1433671, 549.659718},
      {14.78142477, 13.58291874, 43.14650926}},
     {{2.358241369, 2.343934904, 2.355535962},
      {3.2061294, 3.274205019, 3.144936093}}},
    {"case 3",
     {1, 1, 1},
     {{0.4, -1.5, -1.2}, {-1.2, -0.6, -1.2}},
     {{46.37518841, 1918.62728, 1921.917706},
      {30.84415268, 143.5353063, 143.8706154}},
     {{2.8756214, 2.874313166, 2.874268804},
      {4.564003776, 4.563637826, 4.564665024}}},
    {"case 4",
     {0.15396, -0.60997, 0.40867},
     {{-0.8, 0.3, 1.2}, {0.5, -1.3, -1}},
     {{7.464018848, 11.46317741, 18.47540449},
      {7.228382906, 0.6664293605, 1.004508892}},
     {{1.065427191, 1.068824083, 1.1054502},
      {1.014539944, 1.024163668, 1.020815145}}},
    {"case 5",
     {1, 1, 1},
     {{10, 0, 10}, {0, 1, 1}},
     {{35.32384558, 1240.318056, 1811.016473},
      {2.548826872, 5.717833904, 1293.774609}},
     {{2.742368401, 3.28955858, 3.34554772},
      {1.869736562, 1.924541753, 2.227692522}}},
    {"circular helix",
     {-0.2928932188134524, 0.7071067811865475, 0.7853981633974483},
     {{0, 1, 1}, {-0.7071067811865475, 0.7071067811865476, 1}},
     {{UNKNOWN, UNKNOWN, 0.2521438278}, {UNKNOWN, UNKNOWN, 0}},
     {{UNKNOWN, UNKNOWN, 1.112220807}, {UNKNOWN, UNKNOWN, 1.110720735}}},
    {"hyperbolic helix",
     {0.10241255214024814, 0.46401878746056757, 0.4488},
     {{0, 1, 1}, {0.46401878746056757, 1.1024125521402481, 1}},
     {{UNKNOWN, UNKNOWN, 393.7387895}, {UNKNOWN, UNKNOWN, 0.003517812563}},
     {{UNKNOWN, UNKNOWN, 0.6593181207}, {UNKNOWN, UNKNOWN, 0.6561972799}}},
};

enum { ROW_N = COUNT(ROWS) };

static const double VALUE = 1e-5, NOTHING = 1e-12, LENGTH = 2e-3;

static ph_vec3 vector(const double v[3]) {
  return ph_vec3_of(v[0], v[1], v[2]);
}

static struct ph_spatial_data row_data(const struct row *row, double scale) {
  ph_vec3 d0 = vector(row->d[0]), d1 = vector(row->d[1]);
  struct ph_spatial_data data = {ph_vec3_scale(scale, vector(row->dp)),
                                 ph_vec3_unit(d0),
                                 ph_vec3_unit(d1),
                                 scale * ph_vec3_abs(d0),
                                 scale * ph_vec3_abs(d1),
                                 0,
                                 0,
                                 {0, 0, 0}};
  return data;
}

PH_TEST(test_reference) {
  for (size_t i = 0; i < ROW_N * 6; i++) {
    const struct row *row = &ROWS[i / 6];
    const size_t atph = i / 3 % 2, k = i % 3;
    double most = row->most[atph][k], length;
    struct ph_spatial_data data = row_data(row, 1);
    struct ph_spatial_search search = search_of(&data, atph, 1 + (int)k);
    struct ph_spatial_minimum found = minimize(&search);
    struct ph_spatial_family family = family_at(&search, found.alpha);
    ck_assert_msg(found.value <= most * (1 + VALUE) + NOTHING,
                  "%s, %zu, F%zu: %.17g > %.17g", row->name, atph, k + 1,
                  found.value, most);
    ck_abs(found.value, value_of(&search, &found), 1e-9 * found.value + 1e-15);
    length = ph_spatial_length(&family, found.member.b);
    if (found.value >= most * (1 - VALUE) - NOTHING) {
      ck_rel(length, row->length[atph][k], LENGTH);
    }
  }
}

static void ck_same(const struct ph_spatial_minimum *a,
                    const struct ph_spatial_minimum *b) {
  ck_abs(a->value, b->value, 0);
  ck_abs(a->alpha, b->alpha, 0);
  ck_abs(a->member.b.re, b->member.b.re, 0);
  ck_abs(a->member.b.im, b->member.b.im, 0);
  ck_abs(a->member.phi.re, b->member.phi.re, 0);
  ck_abs(a->member.phi.im, b->member.phi.im, 0);
  ck_assert_uint_eq(a->evaluations, b->evaluations);
}

static ph_vec3 turned(ph_quat turn, ph_vec3 v) {
  return ph_quat_vector(
      ph_quat_mul(ph_quat_mul(turn, ph_quat_pure(v)), ph_quat_conj(turn)));
}

/* Scale and position do not matter, and the same call gives the same bits. */
PH_TEST(test_invariance) {
  struct unit_random r = unit_random_of(1112);
  for (size_t i = 0; i < ROW_N * 6; i += 5) {
    const struct row *row = &ROWS[i / 6];
    struct ph_spatial_data data = row_data(row, 1);
    struct ph_spatial_search search =
        search_of(&data, i / 3 % 2, 1 + (int)(i % 3));
    struct ph_spatial_minimum one = minimize(&search);
    struct ph_spatial_minimum again = minimize(&search), other;
    ph_quat turn = unit_random_turn(&r);
    ck_same(&one, &again);
    data = row_data(row, 0.37);
    other = minimize(&search);
    ck_abs(other.value, one.value, 1e-8 * one.value + 1e-12);
    data.dp = turned(turn, data.dp);
    data.ti = turned(turn, data.ti);
    data.tf = turned(turn, data.tf);
    other = minimize(&search);
    ck_abs(other.value, one.value, 1e-8 * one.value + 1e-12);
  }
}

/* The circular helix itself: pi/4 of radius 1 and pitch 2 pi. */
PH_TEST(test_helix) {
  struct ph_spatial_data data = row_data(&ROWS[6], 1);
  struct ph_spatial_search search = search_of(&data, true, 3);
  struct ph_spatial_minimum found = minimize(&search);
  struct ph_spatial_family family = family_at(&search, found.alpha);
  ck_abs(found.value, 0, 1e-12);
  ck_rel(found.alpha, TURN / 8, 1e-6);
  ck_rel(ph_spatial_length(&family, found.member.b), sqrt(2) * TURN / 8, 1e-6);
}

/* alpha: given, and on a bound. */
PH_TEST(test_alpha) {
  struct ph_spatial_data data = row_data(&ROWS[0], 1);
  struct ph_spatial_search search = search_of(&data, true, 1);
  struct ph_spatial_minimum least = minimize(&search), found;
  ck_assert(!least.at_bound);
  search.alpha_lower = search.alpha_upper = least.alpha;
  found = minimize(&search);
  ck_rel(found.value, least.value, 1e-10);
  ck_abs(found.alpha, least.alpha, 0);
  ck_assert(!found.at_bound);
  search.alpha_lower = PH_SPATIAL_ALPHA_MIN;
  search.alpha_upper = 0.9 * least.alpha;
  found = minimize(&search);
  ck_assert(found.at_bound);
  ck_abs(found.alpha, search.alpha_upper, 0);
  ck_assert(found.value > least.value);
}

/* A start is descended from to a minimum that is one, and is kept there. */
PH_TEST(test_descend) {
  struct unit_random r = unit_random_of(1113);
  for (int n = 0; n < unit_count(60); n++) {
    struct ph_spatial_data data = unit_random_spatial(&r);
    struct ph_spatial_search search = search_of(&data, n % 2, 1 + n / 2 % 2);
    struct ph_spatial_minimum least = minimize(&search), found = least;
    struct ph_spatial_minimum start = {
        .member = {unit_random_phase(&r), unit_random_phase(&r)},
        .alpha = n % 2 ? 0.8 : 0};
    double before = value_of(&search, &start);
    ck_assert_int_eq(ph_spatial_descend(&search, &rules, &unit_arena, &found),
                     PH_OK);
    ck_rel(found.value, least.value, 1e-9);
    found = start;
    ck_assert_int_eq(ph_spatial_descend(&search, &rules, &unit_arena, &found),
                     PH_OK);
    ck_assert(found.value <= before * (1 + 1e-9));
    ck_assert_msg(found.value >= least.value * (1 - 1e-6),
                  "seed %lu, %d: %.17g, minimum %.17g", unit_seed(), n,
                  found.value, least.value);
    data.ni *= 0.99; /* the next step of a tension */
    found = least;
    ck_assert_int_eq(ph_spatial_descend(&search, &rules, &unit_arena, &found),
                     PH_OK);
    ck_assert(found.value <= value_of(&search, &least) * (1 + 1e-9));
  }
}

/* ---- data in a plane --------------------------------------------------- */

PH_TEST(test_straight) {
  const ph_vec3 x = {1, 0, 0};
  for (int k = 1; k <= 3; k++) {
    for (int atph = 0; atph < 2; atph++) {
      struct ph_spatial_data data = {x, x, x, 1, 0.8, 0, 0, {0, 0, 0}};
      struct ph_spatial_search search = search_of(&data, atph, k);
      struct ph_spatial_minimum found = minimize(&search);
      ck_abs(found.value, 0, 1e-20);
    }
  }
}

/* Half a circle, of which F1 is pi^2: for opposite tangents, too, the frame has
 * an answer. */
PH_TEST(test_circle) {
  struct ph_spatial_data data = {{2, 0, 0}, {0, 1, 0}, {0, -1, 0}, 2,
                                 2,         0,         0,          {0, 0, 0}};
  struct ph_spatial_search search = search_of(&data, true, 1);
  struct ph_spatial_minimum found = minimize(&search);
  ck_rel(found.value, 9.869604401089358, 1e-12);
  ck_abs(found.alpha, TURN / 4, 1e-6);
  for (search.functional = 2; search.functional <= 3; search.functional++) {
    found = minimize(&search);
    ck_abs(found.value, 0, 1e-12);
    ck_abs(found.alpha, TURN / 4, 1e-6);
  }
}

/* An S: F3 of the plane members is finite, and that of their neighbours is not,
 * so that no descent could find them.  Turned, it is the same. */
PH_TEST(test_plane) {
  struct unit_random r = unit_random_of(1114);
  for (int n = 0; n < unit_count(20); n++) {
    ph_quat turn = n == 0 ? ph_quat_of(1, 0, 0, 0) : unit_random_turn(&r);
    ph_vec3 x = ph_quat_i(turn, turn), y = ph_quat_j(turn, turn);
    struct ph_spatial_data data = {x,
                                   ph_vec3_along(ph_vec3_scale(0.6, x), 0.8, y),
                                   ph_vec3_along(ph_vec3_scale(0.8, x), 0.6, y),
                                   1,
                                   0.7,
                                   0,
                                   0,
                                   {0, 0, 0}};
    struct ph_spatial_search search = search_of(&data, false, 3);
    struct ph_spatial_minimum found = minimize(&search);
    ck_rel(found.value, 276.5791974, 1e-8);
    ck_abs(found.member.b.im, 0, 1e-12);
    ck_abs(found.member.phi.im, 0, 1e-12);
    ck_assert_int_eq(ph_spatial_descend(&search, &rules, &unit_arena, &found),
                     PH_OK);
    ck_rel(found.value, 276.5791974, 1e-8);
  }
}

/* ---- against a dense grid ---------------------------------------------- */

enum { GRID = 24, GRID_ALPHA = 8, DESCENTS = 12 };

/* The best descent from the best points of a grid. */
static double grid_least(const struct ph_spatial_search *search) {
  struct ph_atph space = ph_atph_of(1);
  struct ph_spatial_family family = ph_spatial_family_of(search->data, &space);
  struct ph_spatial_target target = {&rules.rule, &family, search->scaled,
                                     search->functional};
  struct ph_spatial_point best[DESCENTS];
  double value[DESCENTS], least = (double)HUGE_VAL;
  size_t kept = 0, alphas = search->scaled ? GRID_ALPHA : 1;
  for (size_t k = 0; k < alphas * GRID * GRID; k++) {
    size_t i = k / GRID % GRID, j = k % GRID, m = k / (GRID * GRID), at;
    struct ph_spatial_point point = {
        TURN * (double)i / GRID, TURN * (double)j / GRID,
        search->scaled ? ((double)m + 0.5) / GRID_ALPHA * PH_SPATIAL_ALPHA_MAX
                       : 0};
    double v = ph_spatial_fair(&target, 2, &point, NULL);
    if (kept == DESCENTS && !(v < value[DESCENTS - 1])) {
      continue;
    }
    kept += kept < DESCENTS ? 1 : 0;
    for (at = kept - 1; at > 0 && v < value[at - 1]; at--) {
      value[at] = value[at - 1];
      best[at] = best[at - 1];
    }
    value[at] = v;
    best[at] = point;
  }
  for (size_t k = 0; k < kept; k++) {
    struct ph_spatial_minimum found = {
        .member = {ph_cplx_polar(best[k].b), ph_cplx_polar(best[k].phi)},
        .alpha = best[k].alpha};
    ck_assert_int_eq(ph_spatial_descend(search, &rules, &unit_arena, &found),
                     PH_OK);
    least = found.value < least ? found.value : least;
  }
  return least;
}

/* F1 and F2 on every one; of F3, with its needles, bench/spatial_min.c tells.
 */
PH_TEST(test_grid) {
  struct unit_random r = unit_random_of(1115);
  for (int n = 0; n < unit_count(80); n++) {
    struct ph_spatial_data data = unit_random_spatial(&r);
    struct ph_spatial_search search = search_of(&data, n % 2, 1 + n / 2 % 2);
    double found = minimize(&search).value, least = grid_least(&search);
    ck_assert_msg(found <= least * (1 + 1e-6),
                  "seed %lu, %d: %.17g, grid %.17g", unit_seed(), n, found,
                  least);
  }
}

PH_FIXTURE(begin, NULL)
