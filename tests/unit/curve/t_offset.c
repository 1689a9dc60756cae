/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Offset curves: the definition o = r + d i r'/|r'|, point by point. */
#include "unit.h"
#include "segment_unit.h"
#include "planar_unit.h"
#include "tc_curve_unit.h"

#include "curve/offset/offset.h"

static const double PI = 3.14159265358979323846;

static struct ph_diag diag;
static const struct ph_offset_rules rules = {.tolerance = 1e-9};

/* A curve of one segment from its preimage. */
struct single {
  struct ph_curve curve;
  double preimage[6], control_points[12], length;
};

static void single_of(const ph_cplx w[3], ph_cplx start, struct single *s) {
  ph_cplx hodograph[5], p[6], end = start;
  ph_hodograph(w, hodograph);
  for (int i = 0; i < 5; i++) {
    end = ph_cplx_add(end, ph_cplx_scale(0.2, hodograph[i]));
  }
  ph_control_points(w, start, end, p);
  memcpy(s->preimage, w, sizeof s->preimage);
  memcpy(s->control_points, p, sizeof s->control_points);
  s->length = ph_length(w);
  s->curve = (struct ph_curve){.kind = PH_CURVE_PH,
                               .dimension = 2,
                               .degree = 5,
                               .n = 1,
                               .control_points = s->control_points,
                               .preimage.n = 3,
                               .preimage.dimension = 2,
                               .preimage.v = s->preimage,
                               .lengths = &s->length,
                               .length = s->length};
}

/* Value of a rational Bezier piece. */
static ph_cplx rational(const struct ph_offset *o, size_t piece, double t) {
  const size_t points = o->degree + 1;
  const double *p = o->control_points + 2 * points * piece;
  const double *weight = o->weights + points * piece;
  double lifted[20], flat[20], unit = 0;
  ph_cplx numerator, denominator;
  ck_assert_uint_le(points, 10);
  for (size_t i = 0; i < points; i++) {
    unit = fmax(unit, weight[i]);
  }
  for (size_t i = 0; i < points; i++) {
    lifted[2 * i] = weight[i] / unit * p[2 * i];
    lifted[2 * i + 1] = weight[i] / unit * p[2 * i + 1];
    flat[2 * i] = weight[i] / unit;
    flat[2 * i + 1] = 0;
  }
  numerator = unit_bezier(lifted, o->degree, 0, t);
  denominator = unit_bezier(flat, o->degree, 0, t);
  return ph_cplx_scale(1 / denominator.re, numerator);
}

/* r + d i r'/|r'| from the control points and the preimage. */
static ph_cplx defined(const struct ph_curve *curve, size_t k, double d,
                       double t) {
  ph_cplx r = unit_curve(curve, k, 0, t), w = unit_preimage(curve, k, 0, t);
  ph_cplx tangent = ph_cplx_scale(1 / ph_cplx_norm2(w), ph_cplx_mul(w, w));
  return ph_cplx_of(r.re - d * tangent.im, r.im + d * tangent.re);
}

/* The pieces tile the segments in order, all weights are positive. */
static void ck_pieces(const struct ph_curve *curve, const struct ph_offset *o) {
  const size_t points = 2 * curve->degree;
  size_t piece = 0;
  ck_assert_uint_eq(o->degree, points - 1);
  ck_assert_uint_eq(o->dimension, 2);
  for (size_t k = 0; k < curve->n; k++) {
    double at = 0;
    while (at < 1) {
      ck_assert_uint_lt(piece, o->n);
      ck_assert_uint_eq(o->segment[piece], k);
      ck_abs(o->interval[2 * piece], at, 0);
      ck_assert(o->interval[2 * piece + 1] > at);
      at = o->interval[2 * piece + 1];
      for (size_t i = 0; i < points; i++) {
        ck_assert(o->weights[points * piece + i] > 0);
      }
      piece++;
    }
    ck_abs(at, 1, 0);
  }
  ck_assert_uint_eq(piece, o->n);
}

/* The offset at d, checked at the ends and the middle of every piece, and at
 * a point of its own for each. */
static struct ph_offset ck_offset(const struct ph_curve *curve, double d,
                                  double tol, struct unit_random *r) {
  struct ph_offset o;
  enum ph_status status = ph_offset(curve, d, &rules, &unit_arena, &o, &diag);
  ck_assert_msg(status == PH_OK, "seed %lu: %s", unit_seed(), diag.message);
  ck_abs(o.distance, d, 0);
  ck_pieces(curve, &o);
  for (size_t i = 0; i < o.n; i++) {
    const double at[4] = {0, 0.5, 1, unit_random_in(r, 0, 1)};
    double from = o.interval[2 * i], to = o.interval[2 * i + 1];
    for (int j = 0; j < 4; j++) {
      ph_cplx found = rational(&o, i, at[j]);
      ph_cplx wanted =
          defined(curve, o.segment[i], d, from + at[j] * (to - from));
      ck_assert_msg(unit_distance(found, wanted) <= tol,
                    "seed %lu, distance %g, piece %zu at %g: %.3g > %.3g",
                    unit_seed(), d, i, at[j], unit_distance(found, wanted),
                    tol);
    }
  }
  return o;
}

/* Both sides, and no distance at all, of a curve with curvature both ways. */
PH_TEST(test_spline) {
  const double points[] = {0, 0, 2, 1, 3, 0, 5, 2, 4, 4, 1, 3};
  const double distances[] = {0.25, -0.25, 1, -3, 100, 1e-6, -1e-12, 0};
  struct unit_random r = unit_random_of(1);
  struct unit_solution u = unit_planar_of(points, 6, true);
  ck_assert_int_eq(unit_planar_solve(&u), PH_OK);
  for (size_t i = 0; i < COUNT(distances); i++) {
    double d = distances[i];
    struct ph_offset o =
        ck_offset(&u.result.curve, d, 1e-14 * (5 + fabs(d)), &r);
    ck_assert_uint_eq(o.n, 6);
  }
  unit_solution_free(&u);
}

/* Left is left: a line to the east moves to the north. */
PH_TEST(test_side) {
  const double points[] = {1, 1, 2, 1};
  struct unit_solution u = unit_planar_of(points, 2, false);
  struct ph_offset o;
  ck_assert_int_eq(unit_planar_solve(&u), PH_OK);
  ck_assert_int_eq(
      ph_offset(&u.result.curve, 3, &rules, &unit_arena, &o, &diag), PH_OK);
  ck_assert_uint_eq(o.n, 1);
  for (size_t i = 0; i < 10; i++) {
    ck_abs(o.control_points[2 * i], 1 + (double)i / 9, 1e-15);
    ck_abs(o.control_points[2 * i + 1], 4, 1e-15);
    ck_abs(o.weights[i], 1, 1e-15);
  }
  unit_solution_free(&u);
}

PH_TEST(test_random) {
  struct unit_random r = unit_random_of(2);
  size_t halved = 0;
  for (int i = 0; i < 300; i++) {
    ph_cplx w[3];
    struct single s;
    double d = unit_random_in(&r, -2, 2), slow = HUGE_VAL;
    for (int k = 0; k < 3; k++) {
      w[k] = unit_random_cplx(&r, 1);
    }
    single_of(w, unit_random_cplx(&r, 1), &s);
    for (int k = 0; k <= 100; k++) {
      slow = fmin(slow, ph_cplx_norm2(unit_preimage(&s.curve, 0, 0, k * 0.01)));
    }
    /* The normal is uncertain by the rounding of w over |w|. */
    halved +=
        ck_offset(&s.curve, d, 1e-15 * (10 + 50 * fabs(d) / slow), &r).n - 1;
    ph_arena_reset(&unit_arena);
  }
  ck_assert_uint_ge(halved, 50);
}

/* The more a segment turns, the more it is halved: nearly a cusp here. */
PH_TEST(test_high_curvature) {
  struct unit_random r = unit_random_of(3);
  size_t before = 1;
  for (int e = 0; e <= 16; e++) {
    double near = ldexp(1, -e); /* w = u - 0.3 + i near */
    const ph_cplx w[3] = {{-0.3, near}, {0.2, near}, {0.7, near}};
    const ph_cplx zero = {0, 0};
    struct single s;
    struct ph_offset o;
    single_of(w, zero, &s);
    o = ck_offset(&s.curve, 0.5, 1e-14 * ldexp(1, e), &r);
    ck_assert_uint_ge(o.n, before);
    ck_assert_uint_le(o.n, (size_t)(8 + 4 * e));
    before = o.n;
  }
  ck_assert_uint_ge(before, 8);
}

/* At distance 0 a segment that needs no halving gives the curve itself. */
PH_TEST(test_zero_distance) {
  struct unit_random r = unit_random_of(4);
  const ph_cplx w[3] = {{1, 0}, {1, 0.3}, {0.8, 0.9}};
  struct single s;
  struct ph_offset o;
  single_of(w, ph_cplx_of(7, -3), &s);
  o = ck_offset(&s.curve, 0, 2e-15, &r);
  ck_assert_uint_eq(o.n, 1);
  ck_abs(o.control_points[0], 7, 0);
  ck_abs(o.control_points[1], -3, 0);
}

/* Weights are in the unit of the speed, which is that of the data. */
PH_TEST(test_weights) {
  const ph_cplx w[3] = {{3, 0}, {2, 1}, {1, 2}};
  const ph_cplx zero = {0, 0};
  struct single s;
  struct ph_offset o;
  double sum = 0;
  single_of(w, zero, &s);
  ck_assert_int_eq(ph_offset(&s.curve, 1, &rules, &unit_arena, &o, &diag),
                   PH_OK);
  ck_rel(o.weights[0], ph_cplx_norm2(w[0]), 1e-15);
  ck_rel(o.weights[9], ph_cplx_norm2(w[2]), 1e-15);
  for (size_t i = 0; i < 10; i++) {
    sum += o.weights[i];
  }
  ck_rel(sum / 10, s.length, 1e-15); /* both are the integral of the speed */
}

/* Units as small and as large as there are. */
PH_TEST(test_scales) {
  const double points[] = {0, 0, 2, 1, 3, 0, 5, 2};
  const int exponents[] = {-1000, -300, 300, 1000};
  struct unit_random r = unit_random_of(5);
  for (size_t i = 0; i < COUNT(exponents); i++) {
    double s = ldexp(1, exponents[i]), scaled[8];
    struct unit_solution u;
    for (size_t k = 0; k < 8; k++) {
      scaled[k] = s * points[k];
    }
    u = unit_planar_of(scaled, 4, false);
    ck_assert_int_eq(unit_planar_solve(&u), PH_OK);
    ck_offset(&u.result.curve, 0.5 * s, 1e-14 * s, &r);
    unit_solution_free(&u);
  }
}

static void ck_standstill(double w0, double w1, double w2) {
  const ph_cplx w[3] = {{w0, 0}, {w1, 0}, {w2, 0}};
  const ph_cplx zero = {0, 0};
  struct single s;
  struct ph_offset o;
  single_of(w, zero, &s);
  ck_assert_int_eq(ph_offset(&s.curve, 1, &rules, &unit_arena, &o, &diag),
                   PH_E_INFEASIBLE);
  ck_assert_str_eq(diag.field, "segments[0]");
  ck_assert_str_eq(diag.message, "has no offset: the curve stands still in it "
                                 "and has no normal there");
}

PH_TEST(test_standstill) {
  ck_standstill(1, 0, -1);         /* in the middle, a node of the halving */
  ck_standstill(1, -0.25, -0.875); /* elsewhere */
  ck_standstill(0, 1, 1);          /* at an end */
  ck_standstill(1, 1, 0);
  ck_standstill(0, 0, 0);
}

PH_TEST(test_too_large) {
  const double points[] = {0, 1.5e308, 1e307, 1.5e308};
  struct unit_solution u = unit_planar_of(points, 2, false);
  struct ph_offset o;
  ck_assert_int_eq(unit_planar_solve(&u), PH_OK);
  ck_assert_int_eq(
      ph_offset(&u.result.curve, 1e308, &rules, &unit_arena, &o, &diag),
      PH_E_TOO_LARGE);
  ck_assert_str_eq(diag.message, "the offset at distance 1e+308 exceeds the "
                                 "range of a double");
  unit_solution_free(&u);
}

/* ---- Tschirnhausen cubics ----------------------------------------------- */

/* The offset is at d along the normal from the curve, to rounding: of w over
 * |w|, and of the points. */
PH_TEST(test_cubics) {
  const double scales[] = {1, 1e-9, 1e9, 1e-150, 1e150};
  const int curves = unit_count(300);
  struct unit_random r = unit_random_of(6);
  size_t cuts = 0;
  for (int i = 0; i < curves; i++) {
    const double scale = scales[i % 5], far = i % 3 ? 1 : 1e6;
    double d = scale * unit_random_in(&r, -2, 2), slow = HUGE_VAL;
    struct unit_cubics c;
    struct ph_offset o;
    unit_cubics_random(&c, &r, 4, scale, unit_random_cplx(&r, far * scale));
    for (size_t k = 0; k < 4; k++) {
      slow = fmin(slow, unit_cubic_slowest(&c, k) / scale);
    }
    o = ck_offset(&c.curve, d,
                  1e-15 * scale * (20 + far) +
                      4e-16 * fabs(d) * (10 + 10 / sqrt(slow)),
                  &r);
    ck_assert_uint_le(o.n, 8);
    cuts += o.n - 4;
    ph_arena_reset(&unit_arena);
  }
  ck_assert_int_ge((int)cuts, curves / 5);
}

/* Cut at the foot of the origin on the line of w, which is where |w| is least,
 * however near: there the weights are least and equal. */
PH_TEST(test_vertex) {
  struct unit_random r = unit_random_of(7);
  for (int e = 0; e <= 36; e += 4) {
    const double near = ldexp(1, -e); /* w = u - 0.3 + i near */
    struct unit_cubics c;
    struct ph_offset o;
    unit_cubics_begin(&c, ph_cplx_of(0, 0));
    unit_cubics_add(&c, ph_cplx_of(-0.3, near), ph_cplx_of(0.7, near));
    o = ck_offset(&c.curve, 0.5, 1e-15 * (1 + ldexp(1, e)), &r);
    ck_assert_uint_eq(o.n, near > 0.5 ? 1 : 2);
    if (o.n == 2) {
      ck_rel(o.interval[1], 0.3, 1e-15);
      ck_rel(o.weights[5], near * near, 1e-14);
      ck_rel(o.weights[4], near * near, 1e-14);
      ck_rel(o.weights[6], near * near, 1e-14);
      ck_rel(o.weights[7], near * near, 1e-14);
    }
  }
}

/* One cut is enough for every cubic that does not stand still: lengths of w far
 * apart, turns as near to a whole one as there are.  However sharp it turns,
 * the offset keeps its distance. */
PH_TEST(test_one_cut) {
  const int cubics = unit_count(2000);
  struct unit_random r = unit_random_of(8);
  size_t cuts = 0;
  for (int i = 0; i < cubics; i++) {
    const double direction = unit_random_in(&r, -3, 3);
    const double sweep = PI - pow(10, unit_random_in(&r, -11.5, 0));
    const double lengths[2] = {1, pow(10, unit_random_in(&r, -11.5, 0))};
    const double side = i % 4 < 2 ? -1 : 1;
    struct unit_cubics c;
    struct ph_offset o;
    enum ph_status status;
    unit_cubics_begin(&c, ph_cplx_of(0, 0));
    unit_cubics_add(&c, ph_cplx_scale(lengths[i % 2], ph_cplx_polar(direction)),
                    ph_cplx_scale(lengths[1 - i % 2],
                                  ph_cplx_polar(direction + side * sweep)));
    status = ph_offset(&c.curve, 1, &rules, &unit_arena, &o, &diag);
    ck_assert_msg(status == PH_OK, "seed %lu, cubic %d: %s", unit_seed(), i,
                  diag.message);
    ck_pieces(&c.curve, &o);
    ck_assert_uint_le(o.n, 2);
    for (size_t j = 0; j < o.n; j++) {
      const double *in = o.interval + 2 * j;
      const double t = 1 - pow(10, unit_random_in(&r, -12, 0));
      const double at = j == 0 ? t : 1 - t;
      ph_cplx found = rational(&o, j, at);
      ph_cplx on = unit_curve(&c.curve, 0, 0, in[0] + at * (in[1] - in[0]));
      ck_abs(unit_distance(found, on), 1, 4e-15);
    }
    cuts += o.n - 1;
    ph_arena_reset(&unit_arena);
  }
  ck_assert_int_ge((int)cuts, cubics / 2);
}

/* A stop in the middle or at an end. */
PH_TEST(test_cubic_standstill) {
  /* w0 and w1 in units of a direction */
  const double ends[][2] = {{-1, 1}, {-0.3, 0.7}, {0.1, -3},
                            {0, 1},  {1, 0},      {0, 0}};
  for (size_t i = 0; i < 10 * COUNT(ends); i++) {
    const ph_cplx along = ph_cplx_polar((double)i);
    const double *w = ends[i / 10];
    struct unit_cubics c;
    struct ph_offset o;
    unit_cubics_begin(&c, ph_cplx_of(0, 0));
    unit_cubics_add(&c, ph_cplx_of(1, 0), ph_cplx_of(1, 1));
    unit_cubics_add(&c, ph_cplx_scale(w[0], along), ph_cplx_scale(w[1], along));
    ck_assert_int_eq(ph_offset(&c.curve, 1, &rules, &unit_arena, &o, &diag),
                     PH_E_INFEASIBLE);
    ck_assert_str_eq(diag.field, "segments[1]");
    ck_assert_str_eq(diag.message, "has no offset: the curve stands still in "
                                   "it and has no normal there");
  }
}

/* A line moves aside, its weights are its speed. */
PH_TEST(test_cubic_line) {
  struct unit_cubics c;
  struct ph_offset o;
  unit_cubics_begin(&c, ph_cplx_of(1, 1));
  unit_cubics_add(&c, ph_cplx_of(2, 0), ph_cplx_of(2, 0));
  ck_assert_int_eq(ph_offset(&c.curve, 3, &rules, &unit_arena, &o, &diag),
                   PH_OK);
  ck_assert_uint_eq(o.n, 1);
  for (size_t i = 0; i < 6; i++) {
    ck_abs(o.control_points[2 * i], 1 + 0.8 * (double)i, 1e-15);
    ck_abs(o.control_points[2 * i + 1], 4, 1e-15);
    ck_abs(o.weights[i], 4, 1e-15);
  }
}
