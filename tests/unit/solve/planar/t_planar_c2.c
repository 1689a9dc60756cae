/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The C2 equations of planar PH quintic splines (planar.h): every numbered
 * formula against its meaning, by quadrature where an integral is meant, and
 * the starting values against splines of other makes.
 */
#include "segment_unit.h"
#include "unit.h"

#include "kernel/quad.h"
#include "solve/planar/planar.h"

#include <gsl/gsl_spline.h>

enum { N_MAX = 30, SYSTEMS = 200 };

/* The equations with room of their own, and a vector of unknowns. */
struct system {
  struct ph_planar_c2 c2;
  ph_cplx direction[N_MAX];
  double ratio[N_MAX], y[N_MAX + 1], h[N_MAX];
  ph_cplx b[N_MAX + 2];
};

/* Weights (1) of the spacings h. */
static void set_weights(struct system *s) {
  size_t n = s->c2.n;
  const double *h = s->h;
  for (size_t k = 1; k < n; k++) {
    s->y[k] = h[k] / (h[k - 1] + h[k]);
  }
  s->y[0] = s->y[n] = s->c2.closed ? h[0] / (h[n - 1] + h[0]) : 0.5;
}

static void random_system(struct unit_random *r, bool closed,
                          struct system *s) {
  size_t n = (closed ? 3 : 1) + unit_random_below(r, N_MAX - 3);
  s->c2 = (struct ph_planar_c2){.n = n,
                                .closed = closed,
                                .direction = s->direction,
                                .space = &ph_quintic,
                                .ratio = s->ratio,
                                .y = s->y};
  s->c2.twist = ph_cplx_polar(unit_random_in(r, -3, 3));
  for (size_t k = 0; k < n; k++) {
    s->direction[k] = ph_cplx_polar(unit_random_in(r, -4, 4));
    s->h[k] = unit_random_in(r, 0.1, 2);
    s->ratio[k] = s->h[k] / unit_random_in(r, 0.1, 2);
  }
  for (int side = 0; side < 2; side++) {
    s->c2.end[side] = ph_cplx_polar(unit_random_in(r, -4, 4));
    s->c2.end_size[side] = unit_random_in(r, 0.1, 2);
  }
  set_weights(s);
  for (size_t i = 0; i < ph_planar_unknowns(&s->c2); i++) {
    s->b[i] = unit_random_cplx(r, 1);
  }
}

static ph_cplx preimage_at(const ph_cplx w[3], double u) {
  const double basis[3] = {(1 - u) * (1 - u), 2 * u * (1 - u), u * u};
  ph_cplx sum = {0, 0};
  for (int i = 0; i < 3; i++) {
    sum = ph_cplx_add(sum, ph_cplx_scale(basis[i], w[i]));
  }
  return sum;
}

/* F[k] by quadrature of w^2; with F[n], F[n+1] the end equations if open. */
static void residual_by_quadrature(const struct ph_planar_c2 *c2,
                                   const ph_cplx *b, ph_cplx *f) {
  for (size_t k = 0; k < c2->n; k++) {
    ph_cplx w[3], chord = {0, 0};
    ph_planar_preimage(c2, b, k, w);
    for (size_t i = 0; i < unit_quad(6)->n; i++) {
      ph_cplx at = preimage_at(w, unit_quad(6)->node[i]);
      chord = ph_cplx_add(
          chord, ph_cplx_scale(unit_quad(6)->weight[i], ph_cplx_mul(at, at)));
    }
    f[k] = ph_cplx_sub(ph_cplx_scale(c2->ratio[k], chord), c2->direction[k]);
  }
  for (size_t side = 0; side < 2 && !c2->closed; side++) {
    ph_cplx w[3];
    ph_planar_preimage(c2, b, side ? c2->n - 1 : 0, w);
    f[c2->n + side] =
        ph_cplx_sub(ph_cplx_scale(1 / c2->end_size[side],
                                  ph_cplx_mul(w[2 * side], w[2 * side])),
                    c2->end[side]);
  }
}

PH_TEST(test_unknowns) {
  struct ph_planar_c2 c2 = {.n = 7, .closed = true};
  ck_assert_uint_eq(ph_planar_unknowns(&c2), 7);
  c2.closed = false;
  ck_assert_uint_eq(ph_planar_unknowns(&c2), 9);
}

/* Equation (1): w and dw/dt are continuous at every knot, up to the twist. */
PH_TEST(test_knots) {
  struct unit_random r = unit_random_of(1);
  struct system s;
  for (int i = 0; i < SYSTEMS; i++) {
    size_t n;
    random_system(&r, i % 2, &s);
    n = s.c2.n;
    for (size_t k = 0; k < (s.c2.closed ? n : n - 1); k++) {
      ph_cplx a[3], b[3], da, db;
      size_t next = (k + 1) % n;
      ph_planar_preimage(&s.c2, s.b, k, a);
      ph_planar_preimage(&s.c2, s.b, next, b);
      for (int j = 0; j < 3 && next == 0; j++) {
        b[j] = ph_cplx_mul(s.c2.twist, b[j]);
      }
      da = ph_cplx_scale(2 / s.h[k], ph_cplx_sub(a[2], a[1]));
      db = ph_cplx_scale(2 / s.h[next], ph_cplx_sub(b[1], b[0]));
      ck_assert_double_le(unit_distance(a[2], b[0]), next ? 0 : 1e-15);
      ck_assert_double_le(unit_distance(da, db), 1e-13);
    }
  }
}

/* At open ends the end value is the mean of two unknowns. */
PH_TEST(test_open_ends) {
  struct unit_random r = unit_random_of(2);
  struct system s;
  for (int i = 0; i < SYSTEMS; i++) {
    ph_cplx w[3], mean;
    random_system(&r, false, &s);
    ph_planar_preimage(&s.c2, s.b, 0, w);
    mean = ph_cplx_scale(0.5, ph_cplx_add(s.b[0], s.b[1]));
    ck_assert_double_le(unit_distance(w[0], mean), 1e-15);
    ck_assert_double_le(unit_distance(w[1], s.b[1]), 0);
    ph_planar_preimage(&s.c2, s.b, s.c2.n - 1, w);
    mean = ph_cplx_scale(0.5, ph_cplx_add(s.b[s.c2.n], s.b[s.c2.n + 1]));
    ck_assert_double_le(unit_distance(w[2], mean), 1e-15);
  }
}

/* Equations (2) and (3): the coefficients are those of the integral. */
PH_TEST(test_residual) {
  struct unit_random r = unit_random_of(3);
  struct system s;
  for (int i = 0; i < SYSTEMS; i++) {
    struct ph_planar_measure m;
    ph_cplx f[N_MAX + 2];
    double sum2 = 0, max2 = 0;
    random_system(&r, i % 2, &s);
    m = ph_planar_residual(&s.c2, s.b);
    residual_by_quadrature(&s.c2, s.b, f);
    for (size_t k = 0; k < ph_planar_unknowns(&s.c2); k++) {
      sum2 += ph_cplx_norm2(f[k]);
      max2 = unit_larger(max2, ph_cplx_norm2(f[k]));
    }
    ck_rel(m.sum2, sum2, 1e-13);
    ck_rel(m.max2, max2, 1e-13);
    ck_assert_uint_lt(m.worst, s.c2.n);
  }
}

PH_TEST(test_worst_segment) {
  struct unit_random r = unit_random_of(4);
  struct system s;
  for (int i = 0; i < SYSTEMS; i++) {
    ph_cplx f[N_MAX + 2];
    struct ph_planar_measure m;
    random_system(&r, true, &s);
    m = ph_planar_residual(&s.c2, s.b);
    residual_by_quadrature(&s.c2, s.b, f);
    ck_rel(ph_cplx_norm2(f[m.worst]), m.max2, 1e-13);
    s.b[i % 3] = ph_cplx_of(nan(""), 0);
    m = ph_planar_residual(&s.c2, s.b);
    ck_assert(isnan(m.sum2));
  }
}

/* Rounding is measured in the terms of each equation. */
PH_TEST(test_rounding) {
  struct unit_random r = unit_random_of(10);
  struct system s;
  for (int i = 0; i < SYSTEMS; i++) {
    ph_cplx f[N_MAX + 2];
    double largest = 0;
    random_system(&r, i % 2, &s);
    residual_by_quadrature(&s.c2, s.b, f);
    for (size_t k = 0; k < s.c2.n; k++) {
      ph_cplx w[3];
      double terms = 1;
      ph_planar_preimage(&s.c2, s.b, k, w);
      for (int j = 0; j < 3; j++) {
        terms += s.ratio[k] * ph_cplx_norm2(w[j]);
      }
      largest = unit_larger(largest, ph_cplx_abs(f[k]) / terms);
    }
    for (size_t side = 0; s.c2.n + side < ph_planar_unknowns(&s.c2); side++) {
      const ph_cplx *pair = s.b + side * s.c2.n;
      double w = ph_cplx_abs(ph_cplx_add(pair[0], pair[1])) / 2;
      double terms = w * (ph_cplx_abs(pair[0]) + ph_cplx_abs(pair[1]));
      largest = unit_larger(largest, ph_cplx_abs(f[s.c2.n + side]) /
                                         (1 + terms / s.c2.end_size[side]));
    }
    ck_rel(ph_planar_rounding(&s.c2, s.b), largest, 1e-13);
  }
}

/* F is quadratic: F(b + s) - F(b - s) = 2 F'(b) s, exactly, which for the
 * Newton step s is 2 F(b). */
PH_TEST(test_newton_step) {
  struct unit_random r = unit_random_of(5);
  struct system s;
  for (int i = 0; i < SYSTEMS; i++) {
    ph_cplx step[N_MAX + 2], to[2][N_MAX + 2], f[3][N_MAX + 2];
    struct ph_planar_measure found, wanted;
    struct ph_tri tri;
    size_t unknowns;
    double size = 0;
    random_system(&r, i % 2, &s);
    unknowns = ph_planar_unknowns(&s.c2);
    ck_assert(ph_tri_alloc(&tri, &unit_arena, unknowns));
    found = ph_planar_newton_step(&s.c2, s.b, &tri, step);
    wanted = ph_planar_residual(&s.c2, s.b);
    ck_rel(found.sum2, wanted.sum2, 1e-13);
    ck_rel(found.max2, wanted.max2, 1e-13);
    for (size_t k = 0; k < unknowns; k++) {
      to[0][k] = ph_cplx_sub(s.b[k], step[k]);
      to[1][k] = ph_cplx_add(s.b[k], step[k]);
      size = fmax(size, ph_cplx_norm2(step[k]));
    }
    residual_by_quadrature(&s.c2, to[0], f[0]);
    residual_by_quadrature(&s.c2, to[1], f[1]);
    residual_by_quadrature(&s.c2, s.b, f[2]);
    for (size_t k = 0; k < unknowns; k++) {
      ph_cplx slope = ph_cplx_scale(0.5, ph_cplx_sub(f[1][k], f[0][k]));
      ck_assert_msg(unit_distance(slope, f[2][k]) <= 1e-12 * (1 + size),
                    "seed %lu, system %d, equation %zu: %.3g, step^2 %.3g",
                    unit_seed(), i, k, unit_distance(slope, f[2][k]), size);
    }
    ph_arena_reset(&unit_arena);
  }
}

PH_TEST(test_chord_middles) {
  struct unit_random r = unit_random_of(6);
  ph_cplx middle[N_MAX];
  struct system s;
  for (int i = 0; i < SYSTEMS; i++) {
    random_system(&r, i % 2, &s);
    ph_planar_chord_middles(&s.c2, middle);
    for (size_t k = 0; k < s.c2.n; k++) {
      double chord = s.h[k] / s.ratio[k];
      ph_cplx wanted = ph_cplx_scale(chord / s.h[k], s.direction[k]);
      ck_assert_double_le(unit_distance(middle[k], wanted),
                          1e-14 * ph_cplx_abs(wanted));
    }
  }
}

/* Starting values have the middles that were asked for, and at open ends the
 * end derivatives; w never turns by more than a quarter between them. */
PH_TEST(test_start) {
  struct unit_random r = unit_random_of(7);
  struct system s;
  for (int i = 0; i < SYSTEMS; i++) {
    ph_cplx middle[N_MAX], root[N_MAX + 2], end, before = {0, 0};
    ph_cplx first = {0, 0};
    struct ph_tri tri;
    random_system(&r, i % 2, &s);
    ck_assert(ph_tri_alloc(&tri, &unit_arena, ph_planar_unknowns(&s.c2)));
    ph_planar_chord_middles(&s.c2, middle);
    ph_planar_chord_middles(&s.c2, ph_planar_middles(&s.c2, root));
    ph_planar_start(&s.c2, &tri, root, s.b);
    for (size_t k = 0; k < s.c2.n; k++) {
      ph_cplx w[3], at;
      ph_planar_preimage(&s.c2, s.b, k, w);
      at = preimage_at(w, 0.5);
      ck_assert_double_le(unit_distance(ph_cplx_mul(at, at), middle[k]),
                          1e-13 * ph_cplx_abs(middle[k]));
      ck_assert(k == 0 || ph_cplx_dot(before, at) >= 0);
      first = k == 0 ? at : first;
      before = at;
    }
    if (s.c2.closed) {
      ck_abs(s.c2.twist.im, 0, 0);
      ck_abs(fabs(s.c2.twist.re), 1, 0);
      ck_assert(s.c2.twist.re * ph_cplx_dot(before, first) >= 0);
    } else {
      ph_cplx w[3], wanted = ph_cplx_scale(s.c2.end_size[0], s.c2.end[0]);
      ph_planar_preimage(&s.c2, s.b, 0, w);
      end = ph_cplx_mul(w[0], w[0]);
      ck_assert_double_le(unit_distance(end, wanted), 1e-14);
      ck_assert(ph_cplx_dot(w[0], first) >= 0);
      wanted = ph_cplx_scale(s.c2.end_size[1], s.c2.end[1]);
      ph_planar_preimage(&s.c2, s.b, s.c2.n - 1, w);
      end = ph_cplx_mul(w[2], w[2]);
      ck_assert_double_le(unit_distance(end, wanted), 1e-14);
      ck_assert(ph_cplx_dot(w[2], before) >= 0);
    }
    ph_arena_reset(&unit_arena);
  }
}

/* Of two opposite directions the turn is taken to the left, for rounding that
 * goes either way. */
PH_TEST(test_start_reversal) {
  const double wobble[] = {0, 1e-16, -1e-16};
  for (size_t i = 0; i < 3; i++) {
    ph_cplx root[4], at[2], w[3];
    struct system s = {.c2 = {.n = 2,
                              .direction = s.direction,
                              .space = &ph_quintic,
                              .ratio = s.ratio,
                              .y = s.y,
                              .end = {{1, 0}, {-1, wobble[i]}},
                              .end_size = {1, 1}},
                       .direction = {{1, 0}, {-1, wobble[i]}},
                       .ratio = {1, 1},
                       .h = {1, 1}};
    struct ph_tri tri;
    set_weights(&s);
    ck_assert(ph_tri_alloc(&tri, &unit_arena, 4));
    ph_planar_chord_middles(&s.c2, ph_planar_middles(&s.c2, root));
    ph_planar_start(&s.c2, &tri, root, s.b);
    for (size_t k = 0; k < 2; k++) {
      ph_planar_preimage(&s.c2, s.b, k, w);
      at[k] = preimage_at(w, 0.5);
    }
    ck_assert(ph_cplx_cross(at[0], at[1]) > 0);
  }
}

/* c[0] + c[1] t + c[2] t^2 + c[3] t^3 */
static ph_cplx cubic(const ph_cplx c[4], double t) {
  ph_cplx sum = c[3];
  for (int i = 2; i >= 0; i--) {
    sum = ph_cplx_add(c[i], ph_cplx_scale(t, sum));
  }
  return sum;
}

static ph_cplx cubic_slope(const ph_cplx c[4], double t) {
  ph_cplx sum = ph_cplx_scale(3, c[3]);
  for (int i = 2; i >= 1; i--) {
    sum = ph_cplx_add(ph_cplx_scale(i, c[i]), ph_cplx_scale(t, sum));
  }
  return sum;
}

/* An open cubic spline, clamped, is any cubic polynomial itself. */
PH_TEST(test_spline_middles_open) {
  struct unit_random r = unit_random_of(8);
  struct system s;
  for (int i = 0; i < SYSTEMS; i++) {
    ph_cplx c[4], middle[N_MAX + 1];
    struct ph_tri tri;
    double t = unit_random_in(&r, -3, 0), from = t;
    random_system(&r, false, &s);
    ck_assert(ph_tri_alloc(&tri, &unit_arena, ph_planar_unknowns(&s.c2)));
    for (int k = 0; k < 4; k++) {
      c[k] = unit_random_cplx(&r, 1);
    }
    for (size_t k = 0; k < s.c2.n; k++) {
      ph_cplx chord = ph_cplx_sub(cubic(c, t + s.h[k]), cubic(c, t));
      s.ratio[k] = s.h[k] / ph_cplx_abs(chord);
      s.direction[k] = ph_cplx_scale(1 / ph_cplx_abs(chord), chord);
      t += s.h[k];
    }
    for (int side = 0; side < 2; side++) {
      ph_cplx d = cubic_slope(c, side ? t : from);
      s.c2.end_size[side] = ph_cplx_abs(d);
      s.c2.end[side] = ph_cplx_scale(1 / ph_cplx_abs(d), d);
    }
    ph_planar_spline_middles(&s.c2, &tri, middle);
    t = from;
    for (size_t k = 0; k < s.c2.n; k++) {
      ph_cplx wanted = cubic_slope(c, t + s.h[k] / 2);
      ck_assert_double_le(unit_distance(middle[k], wanted), 1e-8);
      t += s.h[k];
    }
    ph_arena_reset(&unit_arena);
  }
}

/* One coordinate of a periodic spline of GSL's: slopes at the middles. */
static void gsl_middles(const double *knots, const double *value, size_t n,
                        double *middle) {
  gsl_spline *spline = gsl_spline_alloc(gsl_interp_cspline_periodic, n + 1);
  ck_assert_ptr_nonnull(spline);
  ck_assert_int_eq(gsl_spline_init(spline, knots, value, n + 1), 0);
  for (size_t k = 0; k < n; k++) {
    double t = (knots[k] + knots[k + 1]) / 2;
    middle[k] = gsl_spline_eval_deriv(spline, t, NULL);
  }
  gsl_spline_free(spline);
}

PH_TEST(test_spline_middles_closed) {
  struct unit_random r = unit_random_of(9);
  struct system s;
  for (int i = 0; i < SYSTEMS; i++) {
    ph_cplx middle[N_MAX + 1], wanted;
    double knots[N_MAX + 1] = {0}, x[N_MAX + 1], y[N_MAX + 1];
    double dx[N_MAX], dy[N_MAX];
    struct ph_tri tri;
    size_t n;
    random_system(&r, true, &s);
    n = s.c2.n;
    ck_assert(ph_tri_alloc(&tri, &unit_arena, n));
    for (size_t k = 0; k < n; k++) {
      x[k] = unit_random_in(&r, -1, 1);
      y[k] = unit_random_in(&r, -1, 1);
      knots[k + 1] = knots[k] + s.h[k];
    }
    x[n] = x[0];
    y[n] = y[0];
    for (size_t k = 0; k < n; k++) {
      ph_cplx chord = ph_cplx_of(x[k + 1] - x[k], y[k + 1] - y[k]);
      s.ratio[k] = s.h[k] / ph_cplx_abs(chord);
      s.direction[k] = ph_cplx_scale(1 / ph_cplx_abs(chord), chord);
    }
    gsl_middles(knots, x, n, dx);
    gsl_middles(knots, y, n, dy);
    ph_planar_spline_middles(&s.c2, &tri, middle);
    for (size_t k = 0; k < n; k++) {
      wanted = ph_cplx_of(dx[k], dy[k]);
      ck_assert_msg(unit_distance(middle[k], wanted) <= 1e-11,
                    "seed %lu, spline %d, segment %zu of %zu: %.3g",
                    unit_seed(), i, k, n, unit_distance(middle[k], wanted));
    }
    ph_arena_reset(&unit_arena);
  }
}
