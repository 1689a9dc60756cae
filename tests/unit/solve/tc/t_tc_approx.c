/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Approximation of Bezier curves: distances against samples, numbers of cubics,
 * symmetry, and the curves that are difficult. */
#include "unit.h"
#include "tc_curve_unit.h"

#include "kernel/pi.h"
#include "solve/tc/approx.h"

enum { POINTS_MAX = 128 };

struct known {
  const char *name;
  size_t degree;
  ph_cplx p[12];
};

static const struct known waves[] = {{"degree 7",
                                      7,
                                      {{0, 0},
                                       {.125, .5},
                                       {.375, .625},
                                       {.5, -.25},
                                       {.75, -.5},
                                       {1, .375},
                                       {1.125, .625},
                                       {1.375, 0}}},
                                     {"degree 7, symmetric ends",
                                      7,
                                      {{0, 0},
                                       {.125, .375},
                                       {.375, .5},
                                       {.5, -.625},
                                       {.625, -.5},
                                       {.75, .625},
                                       {1, .375},
                                       {1.125, 0}}}};

static const struct known quarter = {
    "quarter circle", 3, {{1, 0}, {1, .5522847498}, {.5522847498, 1}, {0, 1}}};
/* Each is within any tolerance by a few cubics. */
static const struct known smooth[] = {
    {"parabola", 2, {{0, 0}, {.5, 1}, {1, 0}}},
    {"s", 3, {{0, 0}, {.5, 0}, {.5, 1}, {1, 1}}},
    {"near cusp", 3, {{0, 0}, {1, 1}, {.001, 1}, {1, 0}}},
    {"loop", 3, {{0, 0}, {1.3, 1}, {-.3, 1}, {1, 0}}},
    {"closed", 3, {{0, 0}, {1, 1}, {-1, 1}, {0, 0}}},
    {"starts still", 3, {{0, 0}, {0, 0}, {.5, 1}, {1, 0}}},
    {"starts and ends still",
     5,
     {{0, 0}, {0, 0}, {0, 0}, {.5, 1}, {1, 0}, {1, 0}}},
    {"micro wiggles",
     6,
     {{0, 0},
      {.2, 1e-7},
      {.3, -1e-7},
      {.5, 1e-7},
      {.6, 0},
      {.8, 1e-7},
      {1, 0}}}};
/* They turn back. */
static const struct known turning[] = {
    {"cusp", 3, {{0, 0}, {1, 1}, {0, 1}, {1, 0}}},
    {"beyond its end and back", 2, {{0, 0}, {1.5, .75}, {1, .5}}},
    {"there and back", 2, {{0, 0}, {1, 0}, {0, 0}}},
    {"back and forth", 3, {{0, 0}, {1.5, 0}, {-.5, 0}, {1, 0}}}};
static struct ph_tc_bezier bezier(const struct known *k) {
  struct ph_tc_bezier b = {k->p, k->degree, 0};
  return b;
}

static double angle(ph_cplx a, ph_cplx b) {
  return fabs(atan2(ph_cplx_cross(a, b), ph_cplx_dot(a, b)));
}

static ph_cplx arc_end(const struct ph_tc_arc *arc) {
  return ph_cplx_add(arc->start, ph_tc_leg(&arc->tc));
}

/* What every approximation must be. */
static void check_chain(const char *name, const struct ph_tc_bezier *curve,
                        const struct ph_tc_arcs *arcs) {
  const struct ph_tc_arc *a = arcs->arc;
  size_t n = arcs->n;
  ck_assert_msg(n >= 1, "%s", name);
  ck_abs(a[0].from, 0, 0);
  ck_abs(a[n - 1].to, 1, 0);
  ck_abs(unit_distance(a[0].start, curve->p[0]), 0, 0);
  ck_abs(unit_distance(a[n - 1].end, curve->p[curve->degree]), 0, 0);
  for (size_t i = 0; i < n; i++) {
    ck_assert_msg(a[i].from < a[i].to, "%s: cubic %zu", name, i);
    ck_assert_msg(ph_tc_is_regular(&a[i].tc), "%s: cubic %zu", name, i);
    ck_assert_msg(!ph_tc_has_loop(&a[i].tc), "%s: cubic %zu", name, i);
    ck_abs(unit_distance(arc_end(&a[i]), a[i].end), 0, 1e-14);
    if (i > 0) {
      ph_cplx before = a[i - 1].tc.w[1], w = a[i].tc.w[0];
      ck_abs(a[i].from, a[i - 1].to, 0);
      ck_abs(unit_distance(a[i].start, a[i - 1].end), 0, 0);
      ck_abs(angle(ph_cplx_mul(before, before), ph_cplx_mul(w, w)), 0, 3e-14);
    }
  }
}

/* Approximates, and checks what comes out; the caller frees arcs->arena. */
static void approximate(const char *name, const struct ph_tc_bezier *curve,
                        double tolerance, struct ph_tc_arcs *arcs) {
  struct ph_diag diag;
  enum ph_status status = ph_tc_approximate(curve, tolerance, arcs, &diag);
  ck_assert_msg(status == PH_OK, "%s to %g: %s", name, tolerance,
                status == PH_OK ? "" : diag.message);
  ck_assert_msg(arcs->distance <= tolerance, "%s", name);
  check_chain(name, curve, arcs);
}

static void check_known(const struct known *k, double tolerance, size_t most) {
  struct ph_tc_arcs arcs = {.arena = &unit_arena};
  struct ph_tc_bezier curve = bezier(k);
  double sampled;
  approximate(k->name, &curve, tolerance, &arcs);
  sampled = unit_arcs_distance(&curve, &arcs);
  ck_assert_msg(sampled <= arcs.distance, "%s: sampled %g, claimed %g", k->name,
                sampled, arcs.distance);
  ck_assert_msg(arcs.n <= most, "%s to %g: %zu cubics, expected %zu at most",
                k->name, tolerance, arcs.n, most);
}

/* Half of what bisection takes, and a fraction of 200 pairs. */
PH_TEST(test_counts) {
  check_known(&waves[0], 1e-3, 12);
  check_known(&waves[0], 1e-6, 58);
  check_known(&waves[1], 1e-6, 56);
  check_known(&quarter, 1e-1, 1);
  check_known(&quarter, 1e-6, 10);
}

PH_TEST(test_smooth) {
  for (size_t i = 0; i < COUNT(smooth); i++) {
    check_known(&smooth[i], 1e-2, 4);
    check_known(&smooth[i], 1e-5, 20);
    check_known(&smooth[i], 1e-7, 60);
  }
}

PH_TEST(test_turning) {
  for (size_t i = 0; i < COUNT(turning); i++) {
    check_known(&turning[i], 1e-1, 6);
    check_known(&turning[i], 1e-3, 12);
    check_known(&turning[i], 1e-6, 24);
  }
}

/* The bound is near the distance where curves run side by side. */
PH_TEST(test_tight) {
  for (size_t i = 0; i < COUNT(waves); i++) {
    struct ph_tc_arcs arcs = {.arena = &unit_arena};
    struct ph_tc_bezier curve = bezier(&waves[i]);
    approximate(waves[i].name, &curve, 1e-4, &arcs);
    ck_assert(arcs.distance <= 1.06 * unit_arcs_distance(&curve, &arcs));
  }
}

PH_TEST(test_straight) {
  const struct known lines[] = {
      {"degree 1", 1, {{0, 0}, {1, .5}}},
      {"degree 5",
       5,
       {{0, 0},
        {.125, .0625},
        {.25, .125},
        {.75, .375},
        {.875, .4375},
        {1, .5}}},
      {"still at both ends", 3, {{0, 0}, {0, 0}, {.5, 1}, {.5, 1}}}};
  for (size_t i = 0; i < COUNT(lines); i++) {
    check_known(&lines[i], .1, 1);
    check_known(&lines[i], 1e-12, 1);
  }
}

/* A Tschirnhausen cubic is one, also where it turns by more than a half turn.
 */
PH_TEST(test_own) {
  struct unit_random r = unit_random_of(1);
  for (int i = 0; i < unit_count(200); i++) {
    double size = unit_random_in(&r, .3, 3), turn = unit_random_in(&r, -2, 2);
    ph_cplx w = ph_cplx_polar(unit_random_in(&r, -PH_PI, PH_PI));
    struct ph_tc tc = {
        {w, ph_cplx_scale(size, ph_cplx_mul(w, ph_cplx_polar(turn)))}};
    struct known own = {"its own", 3, {{0, 0}}};
    if (ph_tc_has_loop(&tc)) {
      continue;
    }
    ph_tc_control_points(&tc, ph_cplx_of(0, 0), ph_tc_leg(&tc), own.p);
    check_known(&own, 1e-11, 1);
  }
}

/* The tangents at the ends, also of a curve that stands still there. */
PH_TEST(test_end_tangents) {
  for (size_t i = 0; i < COUNT(smooth); i++) {
    struct ph_tc_arcs arcs = {.arena = &unit_arena};
    struct ph_tc_bezier c = bezier(&smooth[i]);
    size_t a = 1, b = 1;
    ph_cplx w, v;
    while (unit_distance(c.p[a], c.p[0]) <= 0) {
      a++;
    }
    while (unit_distance(c.p[c.degree - b], c.p[c.degree]) <= 0) {
      b++;
    }
    approximate(smooth[i].name, &c, 1e-3, &arcs);
    w = arcs.arc[0].tc.w[0];
    v = arcs.arc[arcs.n - 1].tc.w[1];
    ck_abs(angle(ph_cplx_mul(w, w), ph_cplx_sub(c.p[a], c.p[0])), 0, 3e-14);
    ck_abs(
        angle(ph_cplx_mul(v, v), ph_cplx_sub(c.p[c.degree], c.p[c.degree - b])),
        0, 3e-14);
  }
}

/* Without a tolerance to speak of: one cubic or a pair; two for closed ones. */
PH_TEST(test_huge_tolerance) {
  for (size_t i = 0; i < COUNT(smooth); i++) {
    check_known(&smooth[i], 1e3, 2);
  }
  check_known(&waves[0], 1e3, 2);
}

static void random_curve(struct unit_random *r, size_t degree, ph_cplx *p) {
  bool wave = unit_random_below(r, 2) == 1;
  for (size_t k = 0; k <= degree; k++) {
    p[k] = unit_random_cplx(r, wave ? .3 : 1);
    p[k].re += wave ? (double)k : 0;
  }
  for (size_t k = 0; wave && k <= degree; k++) {
    p[k] = ph_cplx_scale(1 / (double)degree, p[k]);
  }
}

PH_TEST(test_random) {
  struct unit_random r = unit_random_of(2);
  for (int i = 0; i < unit_count(60); i++) {
    struct ph_tc_arcs arcs = {.arena = &unit_arena};
    ph_cplx p[16];
    struct ph_tc_bezier curve = {p, 1 + unit_random_below(&r, 15), 0};
    double sampled;
    random_curve(&r, curve.degree, p);
    approximate("random", &curve, pow(10, unit_random_in(&r, -5, 0)), &arcs);
    sampled = unit_arcs_distance(&curve, &arcs);
    ck_assert_msg(sampled <= arcs.distance,
                  "curve %d of degree %zu: sampled %.9g, claimed %.9g", i,
                  curve.degree, sampled, arcs.distance);
  }
}

/* ---- symmetry ----------------------------------------------------------- */

static void move(const struct ph_tc_bezier *curve, ph_cplx by, bool mirror,
                 bool backward, ph_cplx *p) {
  for (size_t k = 0; k <= curve->degree; k++) {
    ph_cplx z = curve->p[backward ? curve->degree - k : k];
    p[k] = ph_cplx_mul(by, mirror ? ph_cplx_conj(z) : z);
  }
}

/* The same knots, and cubics that are moved alike; the bound may be worked out
 * to one halving more or less, which in hairpins makes some difference. */
static void check_moved(const struct known *k, double tolerance, ph_cplx by,
                        bool mirror, bool backward) {
  struct ph_tc_arcs a = {.arena = &unit_arena}, b = {.arena = &unit_arena};
  struct ph_tc_bezier curve = bezier(k), moved;
  double size = ph_cplx_abs(by);
  ph_cplx p[POINTS_MAX];
  double same = k == &turning[0] ? 1e-2 : 1e-6;
  move(&curve, by, mirror, backward, p);
  moved = (struct ph_tc_bezier){p, curve.degree, 0};
  approximate(k->name, &curve, tolerance, &a);
  approximate(k->name, &moved, size * tolerance, &b);
  ck_assert_msg(a.n == b.n, "%s to %g: %zu and %zu", k->name, tolerance, a.n,
                b.n);
  ck_rel(b.distance, size * a.distance, same);
  for (size_t i = 0; i < a.n; i++) {
    const struct ph_tc_arc *x = &a.arc[i];
    const struct ph_tc_arc *y = &b.arc[backward ? a.n - 1 - i : i];
    ph_cplx start = ph_cplx_mul(by, mirror ? ph_cplx_conj(x->start) : x->start);
    ck_abs(backward ? 1 - y->to : y->from, x->from, same);
    ck_abs(unit_distance(start, backward ? y->end : y->start), 0, same * size);
    ck_abs(ph_tc_length(&y->tc), size * ph_tc_length(&x->tc), same * size);
  }
}

PH_TEST(test_symmetry) {
  const struct known *all[] = {&waves[0],  &waves[1],  &quarter,
                               &smooth[1], &smooth[4], &turning[0]};
  for (size_t i = 0; i < COUNT(all); i++) {
    for (int e = 2; e <= 6; e += 2) {
      double tolerance = pow(10, -e);
      check_moved(all[i], tolerance, ph_cplx_of(1, 0), false, true);
      check_moved(all[i], tolerance, ph_cplx_of(1, 0), true, false);
      check_moved(all[i], tolerance, ph_cplx_of(.6, -.7), false, false);
      check_moved(all[i], tolerance, ph_cplx_of(-.3, 1.1), true, true);
    }
  }
}

/* ---- numbers of cubics -------------------------------------------------- */

PH_TEST(test_pieces) {
  const struct ph_tc_bezier chain[2] = {bezier(&waves[0]), bezier(&quarter)};
  double before = 1e9;
  for (size_t pieces = 2; pieces <= 128; pieces *= 2) {
    struct ph_tc_arcs arcs = {.arena = &unit_arena};
    struct ph_diag diag;
    size_t first[3];
    ck_assert_int_eq(
        ph_tc_approximate_pieces(chain, 2, pieces, 0, &arcs, first, &diag),
        PH_OK);
    ck_assert_uint_le(arcs.n, pieces);
    ck_assert_uint_gt(4 * arcs.n, 3 * pieces); /* they are used */
    ck_assert_uint_eq(first[0], 0);
    ck_assert_uint_eq(first[2], arcs.n);
    ck_assert(first[1] > 0 && first[1] < arcs.n);
    ck_assert(arcs.distance < before);
    before = arcs.distance;
    for (size_t k = 0; k < 2; k++) {
      struct ph_tc_arcs part = {.arc = arcs.arc + first[k],
                                .n = first[k + 1] - first[k]};
      check_chain("piece", &chain[k], &part);
    }
  }
  ck_assert(before < 1e-7);
}

/* A line takes one cubic, however many there may be. */
PH_TEST(test_pieces_of_line) {
  const ph_cplx p[] = {{0, 0}, {1, .5}};
  const struct ph_tc_bezier line = {p, 1, 0};
  struct ph_tc_arcs arcs = {.arena = &unit_arena};
  struct ph_diag diag;
  size_t first[2];
  ck_assert_int_eq(
      ph_tc_approximate_pieces(&line, 1, 100, 0, &arcs, first, &diag), PH_OK);
  ck_assert_uint_eq(arcs.n, 1);
}

PH_TEST(test_too_few_pieces) {
  const struct ph_tc_bezier closed = bezier(&smooth[4]);
  struct ph_tc_arcs arcs = {.arena = &unit_arena};
  struct ph_diag diag;
  size_t first[2];
  ck_assert_int_eq(
      ph_tc_approximate_pieces(&closed, 1, 1, 0, &arcs, first, &diag),
      PH_E_BAD_VALUE);
  ck_assert_str_eq(diag.field, "pieces");
  ck_assert_str_eq(diag.message, "is too few: the fewest cubics found are 2");
}

/* ---- limits ------------------------------------------------------------- */

static void check_refused(const struct ph_tc_bezier *curve, double tolerance,
                          const char *text) {
  struct ph_tc_arcs arcs = {.arena = &unit_arena};
  struct ph_diag diag;
  ck_assert_int_eq(ph_tc_approximate(curve, tolerance, &arcs, &diag),
                   PH_E_NO_CONVERGENCE);
  ck_assert_msg(strstr(diag.message, text) != NULL, "%s", diag.message);
}

PH_TEST(test_refused) {
  const struct ph_tc_bezier curve = bezier(&quarter);
  const ph_cplx same[] = {{1, 1}, {1, 1}, {1, 1}};
  const struct ph_tc_bezier point = {same, 2, 0}, none = {same, 0, 0};
  check_refused(&curve, 1e-15, "rounding alone");
  check_refused(&curve, 0, "rounding alone");
  check_refused(&curve, (double)NAN, "rounding alone");
  check_refused(&point, 1e-3, "within the tolerance");
  check_refused(&none, 1e-3, "degree 0");
}

/* Near rounding it ends, with a curve that is as near as it says. */
PH_TEST(test_near_rounding) {
  struct ph_tc_arcs arcs = {.arena = &unit_arena};
  struct ph_tc_bezier curve = bezier(&quarter);
  approximate(quarter.name, &curve, 1e-12, &arcs);
  ck_assert_uint_le(arcs.n, 400);
}

PH_TEST(test_high_degree) {
  static ph_cplx p[POINTS_MAX];
  struct ph_tc_arcs arcs = {.arena = &unit_arena};
  struct ph_tc_bezier curve = {p, 100, 0};
  for (size_t k = 0; k <= 100; k++) {
    p[k] = ph_cplx_polar(.06 * (double)k);
  }
  approximate("degree 100", &curve, 1e-3, &arcs);
  ck_assert_uint_le(arcs.n, 8);
  ck_assert(unit_arcs_distance(&curve, &arcs) <= arcs.distance);
}
