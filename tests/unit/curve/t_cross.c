/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Crossings of planar splines with themselves: known curves, and the same
 * curve in other frames. */
#include "unit.h"
#include "cross_unit.h"
#include "tc_curve_unit.h"

#include "curve/segment/tc.h"

static const double PI = 3.14159265358979323846;

/* The spline through n points, and what cross.h says of it. */
static struct ph_cross cross_through(const double *v, size_t n, bool closed,
                                     const char *basis) {
  struct unit_solution u = unit_planar_of(v, n, closed);
  struct ph_cross cross;
  u.problem.field[PH_F_BASIS] =
      (struct ph_value){.kind = PH_WORD, .word = basis};
  ck_assert_int_eq(unit_planar_solve(&u), PH_OK);
  cross = unit_cross(&u.result.curve, unit_planar_size(&u));
  unit_solution_free(&u);
  return cross;
}

/* ---- curves piece by piece ---------------------------------------------- */

/* A straight stroke. */
static void chain_stroke(struct unit_chain *chain, double x, double y) {
  ph_cplx root = ph_cplx_sqrt(ph_cplx_of(x, y));
  const ph_cplx w[3] = {root, root, root};
  unit_chain_add(chain, w);
}

/* An arc like a circle's with tangents from one direction to another. */
static void chain_arc(struct unit_chain *chain, double speed, double from,
                      double to) {
  ph_cplx w[3];
  for (int i = 0; i < 3; i++) {
    w[i] = ph_cplx_scale(sqrt(speed),
                         ph_cplx_polar(0.5 * from + 0.25 * i * (to - from)));
  }
  unit_chain_add(chain, w);
}

PH_TEST(test_strokes) {
  /* Out, a short step aside, and back. */
  const double gaps[] = {1e-3, 1e-9, 1e-11, 1e-13, 1e-15};
  struct unit_chain chain;
  for (size_t i = 0; i < 5; i++) {
    for (int from = 0; from < 2; from++) {
      double f = from ? 0.3 : 0; /* less far back, or as far */
      unit_chain_begin(&chain, false);
      chain_stroke(&chain, 1, 1);
      chain_stroke(&chain, -gaps[i], gaps[i]);
      chain_stroke(&chain, f - 1, f - 1);
      ck_assert_msg(unit_cross(&chain.curve, 10).simple == (i < 3), "gap %g",
                    gaps[i]);
    }
  }
  /* An angle is no touching, a reversal is. */
  for (int i = 0; i < 2; i++) {
    unit_chain_begin(&chain, false);
    chain_stroke(&chain, 1, 1);
    chain_stroke(&chain, -1, i ? -1 : -1 + 1e-6);
    ck_assert(unit_cross(&chain.curve, 10).simple == !i);
  }
}

PH_TEST(test_corner) {
  /* Over a hump, and from its foot back through it: the corner turns the
   * shorter way, to the right. */
  const double degree = PI / 180;
  for (int far = 0; far < 2; far++) {
    struct unit_chain chain;
    double length = far ? 1 : 0.1;
    unit_chain_begin(&chain, false);
    chain_arc(&chain, 1, 80 * degree, -80 * degree);
    chain_stroke(&chain, length * cos(120 * degree),
                 length * sin(120 * degree));
    ck_assert(unit_cross(&chain.curve, 1).simple == !far);
  }
}

PH_TEST(test_arcs) {
  /* Out along an arc, a step outward, and back beside it. */
  const double gaps[] = {1e-2, 1e-4, 1e-6, 1e-8, 1e-13};
  struct unit_chain chain;
  for (size_t i = 0; i < 5; i++) {
    unit_chain_begin(&chain, false);
    chain_arc(&chain, 1, 0, 1.4);
    chain_stroke(&chain, gaps[i] * sin(1.4), -gaps[i] * cos(1.4));
    chain_arc(&chain, 1 + gaps[i], PI + 1.4, PI);
    ck_assert_msg(unit_cross(&chain.curve, 10).simple == (i < 4), "gap %g",
                  gaps[i]);
  }
}

PH_TEST(test_rings) {
  /* A ring of one segment, whose tangent turns once: the real part of the
   * integral of w^2 is 1/3 - 2 f^2 / 15, the imaginary one 0. */
  const ph_cplx w[3] = {{1, 0}, {0, sqrt(2.5)}, {-1, 0}};
  struct unit_chain chain;
  struct ph_cross cross;
  for (int open = 0; open < 2; open++) {
    unit_chain_begin(&chain, !open);
    chain_stroke(&chain, 1, 0);
    chain_stroke(&chain, 0, 1);
    chain_stroke(&chain, -1, 0);
    chain_stroke(&chain, 0, -1);
    cross = unit_cross(&chain.curve, 10);
    ck_assert(cross.simple == !open);
    ck_assert_uint_eq(cross.loops, 0);
    unit_chain_begin(&chain, !open);
    unit_chain_add(&chain, w);
    cross = unit_cross(&chain.curve, 10);
    ck_assert(cross.simple == !open);
    ck_assert_uint_eq(cross.loops, open);
  }
}

PH_TEST(test_loops) {
  /* Segments that go by a near stop: loops however small, until none. */
  const double sizes[] = {0.2, 1e-3, 1e-7, 0, 0.29};
  struct unit_chain chain;
  unit_chain_begin(&chain, false);
  for (size_t i = 0; i < 5; i++) {
    const ph_cplx w[3] = {{-0.5, sizes[i]}, {0, sizes[i]}, {0.5, sizes[i]}};
    struct ph_cross cross;
    chain_stroke(&chain, 0.1, 0);
    unit_chain_add(&chain, w);
    cross = unit_cross(&chain.curve, 10);
    ck_assert_uint_eq(cross.loops, i < 4 ? i + 1 : 4);
    ck_assert_uint_eq(cross.segment[0], 1);
    ck_assert_uint_eq(cross.segment[1], 1);
    ck_abs(cross.u[0], 0.5 - sqrt(3) * sizes[0], 1e-6);
  }
}

PH_TEST(test_not_finite) {
  const double bad[] = {(double)NAN, HUGE_VAL, -HUGE_VAL};
  struct unit_chain chain;
  struct ph_cross cross;
  struct ph_diag diag;
  for (size_t i = 0; i < 6; i++) {
    unit_chain_begin(&chain, false);
    chain_stroke(&chain, 1, 0);
    chain_arc(&chain, 1, 0, 3);
    *(i % 2 ? &chain.p[17] : &chain.w[9]) = bad[i / 2];
    ck_assert_int_eq(ph_cross_planar(&chain.curve, &unit_arena, &cross, &diag),
                     PH_E_NOT_FINITE);
    ck_assert_int_eq(diag.status, PH_E_NOT_FINITE);
  }
}

/* ---- splines ------------------------------------------------------------ */

PH_TEST(test_retraced) {
  const double there[] = {0, 0, 1, 0, 0, 0};
  const double further[] = {0, 0, 1, 0, 2, 0, 1, 0, 0, 0};
  const double line[] = {0, 0, 1, 2, 3, 6, 3.5, 7, 100, 200};
  ck_assert(!cross_through(there, 3, false, "ph").simple);
  ck_assert(!cross_through(further, 5, false, "ph").simple);
  ck_assert(!cross_through(further, 5, false, "atph").simple);
  ck_assert(cross_through(line, 5, false, "ph").simple);
  ck_assert(cross_through(line, 5, false, "atph").simple);
}

enum { RING = 240 };

PH_TEST(test_circles) {
  double v[2 * RING];
  for (int times = 1; times <= 3; times++) {
    struct ph_cross cross;
    for (int i = 0; i < RING; i++) {
      v[2 * i] = cos(2 * PI * times * i / RING) - 7;
      v[2 * i + 1] = sin(2 * PI * times * i / RING);
    }
    for (int closed = 0; closed < 2; closed++) {
      cross = cross_through(v, RING, closed, closed ? "ph" : "atph");
      ck_assert(cross.simple == (times == 1));
      ck_assert_uint_eq(cross.loops, 0);
    }
  }
}

PH_TEST(test_eight) {
  /* Crossing at a data point, and between data points. */
  double v[2 * RING];
  for (int i = 0; i < 2; i++) {
    struct ph_cross cross;
    for (int k = 0; k < RING; k++) {
      double t = 2 * PI * (k + 0.5 * i) / RING;
      v[2 * k] = sin(t) + 3;
      v[2 * k + 1] = sin(2 * t) + 5;
    }
    cross = cross_through(v, RING, true, "ph");
    ck_assert(!cross.simple);
    ck_assert_uint_eq(cross.loops, 0);
    ck_abs(unit_distance(cross.point, ph_cplx_of(3, 5)), 0, 1e-11);
    if (i == 1) {
      ck_assert_uint_eq(cross.segment[0], RING / 2 - 1);
      ck_assert_uint_eq(cross.segment[1], RING - 1);
      ck_abs(cross.u[0], 0.5, 1e-9);
      ck_abs(cross.u[1], 0.5, 1e-9);
    }
  }
}

PH_TEST(test_spirals) {
  /* About as far from turn to turn as from point to point, and one chord more
   * across all of it. */
  const size_t N = (size_t)unit_count(100000);
  double *v = malloc((2 * N + 2) * sizeof *v);
  ck_assert_ptr_nonnull(v);
  for (size_t i = 0; i < N; i++) {
    double t = sqrt(4 * PI * (double)i + 1);
    v[2 * i] = t / (2 * PI) * cos(t);
    v[2 * i + 1] = t / (2 * PI) * sin(t);
  }
  v[2 * N] = 1000;
  v[2 * N + 1] = -1000;
  ck_assert(cross_through(v, N, false, "ph").simple);
  v[2 * N] = 0.3;
  v[2 * N + 1] = 0.2;
  ck_assert(!cross_through(v, N + 1, false, "ph").simple);
  free(v);
}

PH_TEST(test_scribble) {
  enum { N = 2000 };
  struct unit_random r = unit_random_of(2);
  double v[2 * N];
  struct unit_solution u;
  for (int i = 0; i < 2 * N; i++) {
    v[i] = unit_random_in(&r, -1, 1);
  }
  u = unit_planar_of(v, N, true);
  ck_assert_int_eq(unit_planar_solve(&u), PH_OK);
  ck_assert(!unit_cross(&u.result.curve, unit_planar_size(&u)).simple);
  unit_solution_free(&u);
}

/* ---- Tschirnhausen cubics ----------------------------------------------- */

/* One cubic has a loop where it turns by more than 4 pi/3 and far enough to
 * either side of its vertex, at every scale and far from the origin. */
PH_TEST(test_cubic_loops) {
  const double scales[] = {1, 1e-9, 1e9, 1e-150, 1e150};
  const int cubics = unit_count(2000);
  struct unit_random r = unit_random_of(5);
  size_t loops = 0;
  for (int i = 0; i < cubics; i++) {
    const double scale = scales[i % 5], far = i % 3 ? 1 : 1e6;
    struct unit_cubics c;
    struct ph_cross cross;
    double a, b, m;
    bool loop;
    unit_cubics_random(&c, &r, 1, scale, unit_random_cplx(&r, far * scale));
    a = pow(c.preimage[0], 2) + pow(c.preimage[1], 2);
    b = pow(c.preimage[2], 2) + pow(c.preimage[3], 2);
    m = c.preimage[0] * c.preimage[2] + c.preimage[1] * c.preimage[3];
    loop = m < 0 && sqrt(3) * fabs(unit_cubic_bend(&c, 0)) <= fmin(a, b) - m;
    cross = unit_cross(&c.curve, 1e3 * far * scale);
    ck_assert_msg((cross.loops == 1) == loop, "seed %lu, cubic %d", unit_seed(),
                  i);
    ck_assert(cross.simple == !loop);
    loops += loop;
  }
  ck_assert_int_ge((int)loops, cubics / 10);
}

/* Several, as the quintics that they are too: the same but for rounding. */
PH_TEST(test_cubic_chains) {
  const int chains = unit_count(300);
  static struct unit_chain chain;
  struct unit_random r = unit_random_of(6);
  size_t crossed = 0;
  for (int i = 0; i < chains; i++) {
    const size_t n = 2 + unit_random_below(&r, 5);
    const ph_cplx zero = {0, 0};
    struct unit_cubics c;
    struct ph_cross cross, raised;
    unit_cubics_random(&c, &r, n, 1, zero);
    if (i % 2) { /* with corners */
      unit_cubics_begin(&c, zero);
      for (size_t k = 0; k < n; k++) {
        ph_cplx w0 = unit_random_cplx(&r, 1);
        unit_cubics_add(&c, w0, unit_random_cplx(&r, 1));
      }
    }
    unit_chain_begin(&chain, false);
    for (size_t k = 0; k < n; k++) {
      const double *v = c.preimage + 4 * k;
      const ph_cplx w[3] = {
          {v[0], v[1]}, {(v[0] + v[2]) / 2, (v[1] + v[3]) / 2}, {v[2], v[3]}};
      unit_chain_add(&chain, w);
    }
    cross = unit_cross(&c.curve, 10);
    raised = unit_cross(&chain.curve, 10);
    ck_assert_uint_eq(cross.loops, raised.loops);
    ck_assert(cross.simple == raised.simple);
    crossed += !cross.simple && cross.loops == 0;
  }
  ck_assert_int_ge((int)crossed, chains / 20);
}

/* ---- other frames ------------------------------------------------------- */

/* The curve scaled, turned and shifted. */
static void move_curve(struct ph_curve *curve, double scale, double angle,
                       ph_cplx d) {
  ph_cplx *p = (ph_cplx *)curve->control_points;
  ph_cplx *w = (ph_cplx *)curve->preimage.v;
  ph_cplx f = ph_cplx_scale(scale, ph_cplx_polar(angle));
  ph_cplx root = ph_cplx_scale(sqrt(scale), ph_cplx_polar(angle / 2));
  for (size_t i = 0; i < 6 * curve->n; i++) {
    p[i] = ph_cplx_add(ph_cplx_mul(f, p[i]), d);
  }
  for (size_t i = 0; i < 3 * curve->n; i++) {
    w[i] = ph_cplx_mul(root, w[i]);
  }
}

static void reverse_points(ph_cplx *p, size_t n) {
  for (size_t i = 0; 2 * i + 1 < n; i++) {
    ph_cplx keep = p[i];
    p[i] = p[n - 1 - i];
    p[n - 1 - i] = keep;
  }
}

/* The curve in the other direction; its angles too. */
static void reverse_curve(struct ph_curve *curve) {
  ph_cplx *w = (ph_cplx *)curve->preimage.v;
  reverse_points((ph_cplx *)curve->control_points, 6 * curve->n);
  reverse_points(w, 3 * curve->n);
  for (size_t i = 0; i < 3 * curve->n; i++) {
    w[i] = ph_cplx_mul(w[i], ph_cplx_of(0, 1));
  }
  for (size_t i = 0; curve->preimage.alpha && 2 * i + 1 < curve->n; i++) {
    double keep = curve->preimage.alpha[i];
    curve->preimage.alpha[i] = curve->preimage.alpha[curve->n - 1 - i];
    curve->preimage.alpha[curve->n - 1 - i] = keep;
  }
}

PH_TEST(test_frames) {
  const int splines = unit_count(120);
  const double scales[] = {1e-9, 1, 1e9, 1e-200, 1e140};
  struct unit_random r = unit_random_of(3);
  for (int i = 0; i < splines; i++) {
    struct unit_solution u = unit_planar_random(&r, i);
    struct ph_curve *curve = &u.result.curve;
    double size = unit_planar_size(&u), scale = scales[i % 5];
    struct ph_cross first = unit_cross(curve, size), moved, back;
    move_curve(curve, scale, unit_random_in(&r, -3, 3),
               unit_random_cplx(&r, 30 * scale));
    moved = unit_cross(curve, 10 * scale * size);
    ck_assert_uint_eq(moved.loops, first.loops);
    ck_assert(moved.simple == first.simple);
    reverse_curve(curve);
    back = unit_cross(curve, 10 * scale * size);
    ck_assert_uint_eq(back.loops, first.loops);
    ck_assert(back.simple == first.simple);
    unit_solution_free(&u);
  }
}

PH_TEST(test_again) {
  /* The same to the last bit, and for curves of any small number. */
  struct unit_random r = unit_random_of(4);
  for (size_t n = 2; n < 20; n++) {
    double v[40];
    struct unit_solution u;
    struct ph_cross first, second;
    for (size_t i = 0; i < 2 * n; i++) {
      v[i] = unit_random_in(&r, -1, 1);
    }
    u = unit_planar_of(v, n, n > 2 && n % 2);
    ck_assert_int_eq(unit_planar_solve(&u), PH_OK);
    first = unit_cross(&u.result.curve, 1);
    second = unit_cross(&u.result.curve, 1);
    ck_assert_mem_eq(first.segment, second.segment, sizeof first.segment);
    ck_assert_mem_eq(first.u, second.u, sizeof first.u);
    ck_assert_mem_eq(&first.point, &second.point, sizeof first.point);
    unit_solution_free(&u);
  }
}
