/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * What every planar spline on random data promises: that there is one, its
 * interpolation, hodograph, continuity and lengths, evaluated by code of our
 * own, and what follows for its pieces and its offsets.
 *
 * The seed is 1, or PH_SEED; PH_LONG=1 takes ten times as many data.
 */
#include "planar_data.h"
#include "planar_unit.h"
#include "segment_unit.h"
#include "unit.h"

#include "curve/offset/offset.h"
#include "kernel/bern.h"
#include "kernel/quad.h"

static struct unit_solution u;
static struct prop_data data;
static const struct ph_offset_rules within = {.tolerance = 1e-9};

static void finish(void) {
  unit_solution_free(&u);
}

static void solve(size_t which) {
  enum ph_status status;
  unit_solution_free(&u);
  u = prop_problem(&data, which);
  status = unit_planar_solve(&u);
  ck_that(status == PH_OK, "%s %s", u.diag.field, u.diag.message);
}

/* One class of the families of the method's measurements: `sets` problems of
 * n segments, all of which have to be solved in so many steps. */
static void ck_class(struct unit_random *r, enum prop_family family, size_t n,
                     size_t sets, size_t *solved) {
  static const char *const rules[] = {"chordal", "centripetal", "uniform"};
  for (size_t i = 0; i < 2 * sets; i++) {
    prop_points(r, family, n, i % 2, &data);
    for (size_t k = 0; k < 3; k++) {
      double steps;
      data.rule = rules[k];
      solve(*solved);
      steps = u.result.diagnostics.value[PH_D_ITERATIONS];
      ck_that(steps <= (k < 2 ? 6 : 12), "%s: %g steps", prop_name(family),
              steps);
      ck_that(family > PROP_ROUGH || k == 2 ||
                  !unit_planar_warned(&u, PH_W_LOOP),
              "%s: a loop", prop_name(family));
      ++*solved;
    }
  }
}

/* 60, 20 and 4 sets of 10, 100 and 1000 segments in each family, open and
 * closed, with knots of three kinds: every one has a solution, after a number
 * of steps that does not depend on the size. */
PH_TEST(test_families) {
  static const struct {
    size_t n;
    int sets;
  } classes[] = {{10, 60}, {100, 20}, {1000, 4}};
  struct unit_random r = unit_random_of(1);
  size_t solved = 0, tried = 0;
  for (int family = 0; family < PROP_FAMILY_N; family++) {
    for (size_t k = 0; k < 3; k++) {
      size_t sets = (size_t)unit_count(classes[k].sets);
      ck_class(&r, (enum prop_family)family, classes[k].n, sets, &solved);
      tried += 6 * sets;
    }
  }
  ck_assert_uint_eq(solved, tried);
}

/* r' = w^2 inside of segment k, and its length is the integral of |r'|. */
static void ck_segment(struct unit_random *r, size_t k) {
  const struct ph_curve *c = &u.result.curve;
  double length = 0, size = unit_planar_size(&u), error;
  double at = unit_random_in(r, 0, 1);
  ph_cplx w = unit_preimage(c, k, 0, at);
  error = unit_distance(unit_curve(c, k, 1, at), ph_cplx_mul(w, w));
  ck_that(error <= 1e-11 * size, "segment %zu is no PH curve by %.3g", k,
          error / size);
  for (size_t i = 0; i < unit_quad(8)->n; i++) {
    ph_cplx speed = unit_curve(c, k, 1, unit_quad(8)->node[i]);
    length += unit_quad(8)->weight[i] * ph_cplx_abs(speed);
  }
  ck_that(unit_near(c->lengths[k], length, 1e-11 * size),
          "segment %zu has length %.17g, not %.17g", k, length, c->lengths[k]);
}

/* Position, and first and second derivative with respect to the knots, agree
 * between segment k and the one after it. */
static void ck_knot(size_t k) {
  const struct ph_curve *c = &u.result.curve;
  size_t next = k + 1 < c->n ? k + 1 : 0;
  double h0 = c->knots[k + 1] - c->knots[k];
  double h1 = c->knots[next + 1] - c->knots[next], h = fmin(h0, h1);
  double speed = ph_cplx_abs(unit_curve(c, k, 1, 1)) * (h / h0);
  for (size_t order = 0; order <= 2; order++) {
    ph_cplx a = unit_curve(c, k, order, 1), b = unit_curve(c, next, order, 0);
    double apart;
    a = ph_cplx_scale(pow(h / h0, (double)order), a);
    b = ph_cplx_scale(pow(h / h1, (double)order), b);
    apart = unit_distance(a, b);
    ck_that(apart <= (order ? 1e-9 * speed : 0),
            "derivative %zu jumps by %.3g of the speed at the end of "
            "segment %zu",
            order, apart / speed, k);
  }
}

PH_TEST(test_promises) {
  struct unit_random r = unit_random_of(2);
  for (size_t i = 0; i < unit_cases(300); i++) {
    const struct ph_curve *c = &u.result.curve;
    double total = 0;
    prop_any(&r, 60, &data);
    solve(i);
    ck_assert_uint_eq(c->n, prop_segments(&data));
    for (size_t k = 0; k < c->n; k++) {
      ph_cplx p = unit_curve(c, k, 0, 0), q = unit_curve(c, k, 0, 1);
      ck_that(unit_distance(p, data.point[k]) <= 0 &&
                  unit_distance(q, data.point[(k + 1) % data.n]) <= 0,
              "segment %zu misses its points", k);
      ck_segment(&r, k);
      if (k + 1 < c->n || c->closed) {
        ck_knot(k);
      }
      total += c->lengths[k];
    }
    ck_that(unit_near_rel(c->length, total, 1e-14),
            "the length is %.17g, not %.17g", c->length, total);
  }
}

/* Data as no one should have them: points that coincide, or nearly, or lie on
 * a line, or far apart, knots that have nothing to do with them. */
static void wild_data(struct unit_random *r, struct prop_data *d) {
  size_t n = 2 + unit_random_below(r, 199);
  double decades = (double)unit_random_below(r, 5) * 3;
  bool tangled = unit_random_below(r, 4) == 0;
  double grid = unit_random_below(r, 3) ? 0 : 4;
  ph_cplx at = {0, 0};
  d->closed = unit_random_below(r, 2);
  d->n = n + !d->closed;
  d->rule = unit_random_below(r, 2) ? "uniform" : NULL;
  d->has_knots = unit_random_below(r, 4) == 0;
  d->has_ends = !d->closed && unit_random_below(r, 4) == 0;
  d->knots[0] = 0;
  for (size_t k = 0; k < d->n; k++) {
    double length = pow(10, -unit_random_in(r, 0, 1) * decades);
    ph_cplx step = ph_cplx_polar(unit_random_in(r, -4, 4));
    step = ph_cplx_scale(length, step);
    d->point[k] = at;
    at = tangled ? unit_random_cplx(r, 1) : ph_cplx_add(at, step);
    if (grid > 0) {
      at = ph_cplx_of(round(grid * at.re) / grid, round(grid * at.im) / grid);
    }
    d->knots[k + 1] = d->knots[k] + length * unit_random_in(r, 0.1, 1);
  }
  for (int side = 0; side < 2; side++) {
    double length = pow(10, unit_random_in(r, -1, 1) * decades);
    d->end[side] = ph_cplx_scale(length, unit_random_cplx(r, 1));
  }
}

/* Each has a curve that keeps its promises, or an error that says why not. */
PH_TEST(test_wild) {
  struct unit_random r = unit_random_of(3);
  size_t solved = 0;
  for (size_t i = 0; i < unit_cases(800); i++) {
    enum ph_status status;
    unit_solution_free(&u);
    wild_data(&r, &data);
    u = prop_problem(&data, i);
    status = unit_planar_solve(&u);
    if (status != PH_OK) {
      ck_that(status == PH_E_COINCIDENT_POINTS ||
                  status == PH_E_NO_CONVERGENCE || status == PH_E_TOO_LARGE ||
                  status == PH_E_BAD_VALUE || status == PH_E_BAD_SHAPE ||
                  status == PH_E_TOO_FEW_POINTS,
              "%s", ph_status_code(status));
      ck_that(u.diag.message[0] != '\0', "no message");
      continue;
    }
    solved++;
    for (size_t k = 0; k < 12 * u.result.curve.n; k++) {
      double x = u.result.curve.control_points[k];
      ck_that(isfinite(x), "%g", x);
    }
    ck_that(isfinite(u.result.curve.length) && u.result.curve.length > 0,
            "length %g", u.result.curve.length);
  }
  ck_assert_uint_ge(solved, unit_cases(800) / 2);
}

/* Both halves of a segment are PH curves with halves of the preimage, turned
 * by 1/sqrt(2) for the shorter parameter, and their lengths add up. */
PH_TEST(test_halves) {
  struct unit_random r = unit_random_of(4);
  for (size_t i = 0; i < unit_cases(100); i++) {
    const struct ph_curve *c = &u.result.curve;
    prop_any(&r, 20, &data);
    solve(i);
    for (size_t k = 0; k < c->n; k++) {
      ph_cplx p[6], w[3], half[2][6], root[2][3], square[5];
      double size = unit_planar_size(&u), length = 0;
      memcpy(p, c->control_points + 12 * k, sizeof p);
      memcpy(w, c->preimage.v + 6 * k, sizeof w);
      ph_bern_cut(p, 5, 0.5, half[0], half[1]);
      ph_bern_cut(w, 2, 0.5, root[0], root[1]);
      for (int side = 0; side < 2; side++) {
        for (int j = 0; j < 3; j++) {
          root[side][j] = ph_cplx_scale(sqrt(0.5), root[side][j]);
        }
        ph_hodograph(root[side], square);
        for (int j = 0; j < 5; j++) {
          ph_cplx leg = ph_cplx_sub(half[side][j + 1], half[side][j]);
          double error = unit_distance(ph_cplx_scale(5, leg), square[j]);
          ck_that(error <= 1e-11 * size,
                  "half %d of segment %zu: leg %d is off by %.3g", side, k, j,
                  error / size);
        }
        length += ph_length(root[side]);
      }
      ck_that(unit_near_rel(length, c->lengths[k], 1e-13),
              "segment %zu: %.17g, not %.17g", k, length, c->lengths[k]);
    }
  }
}

/* Half the radius of the narrowest bend, roughly, to either side. */
static double some_distance(struct unit_random *r) {
  const struct ph_curve *c = &u.result.curve;
  double bend = 0;
  for (size_t k = 0; k < c->n; k++) {
    for (int i = 0; i <= 32; i++) {
      ph_cplx w = unit_preimage(c, k, 0, i / 32.0);
      ph_cplx slope = unit_preimage(c, k, 1, i / 32.0);
      double speed = ph_cplx_norm2(w);
      double kappa = 2 * ph_cplx_cross(w, slope) / (speed * speed);
      bend = fmax(bend, fabs(kappa));
    }
  }
  return unit_random_in(r, -0.5, 0.5) / bend;
}

/* Length of one piece of an offset curve, from its control points: each turns
 * by less than a circle's quarter, where 20 nodes are plenty. */
static double piece_length(const struct ph_offset *o, size_t piece) {
  const double *p = o->control_points + 20 * piece;
  const double *weight = o->weights + 10 * piece;
  struct ph_quad fine;
  double lifted[20], flat[20] = {0}, length = 0;
  ck_assert(ph_quad_gauss(&fine, 20));
  for (size_t i = 0; i < 10; i++) {
    lifted[2 * i] = weight[i] * p[2 * i];
    lifted[2 * i + 1] = weight[i] * p[2 * i + 1];
    flat[2 * i] = weight[i];
  }
  for (size_t i = 0; i < fine.n; i++) {
    double t = fine.node[i];
    double s = unit_bezier(flat, 9, 0, t).re,
           ds = unit_bezier(flat, 9, 1, t).re;
    ph_cplx f = unit_bezier(lifted, 9, 0, t), df = unit_bezier(lifted, 9, 1, t);
    ph_cplx slope = ph_cplx_sub(ph_cplx_scale(s, df), ph_cplx_scale(ds, f));
    length += fine.weight[i] * ph_cplx_abs(slope) / (s * s);
  }
  return length;
}

/* Before the first cusp the offset at d is shorter than the curve by d times
 * the angle that the tangent turns by (Steiner). */
PH_TEST(test_offset_length) {
  struct unit_random r = unit_random_of(5);
  for (size_t i = 0; i < unit_cases(60); i++) {
    const struct ph_curve *c = &u.result.curve;
    struct ph_offset o;
    double length = 0, turned = 0, d;
    prop_points(&r, i % 2 ? PROP_SMOOTH : PROP_ROUGH,
                8 + unit_random_below(&r, 20), i / 2 % 2, &data);
    solve(i);
    d = some_distance(&r);
    ck_assert_int_eq(ph_offset(c, d, &within, &u.arena, &o, &u.diag), PH_OK);
    for (size_t k = 0; k < o.n; k++) {
      length += piece_length(&o, k);
    }
    for (size_t k = 0; k < c->n; k++) {
      ph_cplx w[3];
      memcpy(w, c->preimage.v + 6 * k, sizeof w);
      turned += ph_rotation(w);
    }
    ck_that(unit_near_rel(length, c->length - d * turned, 1e-10),
            "at %g: length %.17g, not %.17g", d, length,
            c->length - d * turned);
  }
}

/* Control points k of o and l of p, as far as they matter: those of small
 * weight beside the largest of their piece are as uncertain as they are far
 * away. */
static void ck_same_point(const struct ph_offset *o, size_t k,
                          const struct ph_offset *p, size_t l) {
  const double *a = o->control_points + 2 * k, *b = p->control_points + 2 * l;
  double size = unit_planar_size(&u) + fabs(o->distance), largest = 0, apart;
  for (size_t i = k / 10 * 10; i < k / 10 * 10 + 10; i++) {
    largest = fmax(largest, o->weights[i]);
  }
  apart = hypot(a[0] - b[0], a[1] - b[1]) * (o->weights[k] / largest);
  ck_that(apart <= 1e-13 * size, "at %g: apart by %.3g", o->distance,
          apart / size);
  ck_that(unit_near(o->weights[k], p->weights[l], 1e-13 * largest),
          "at %g: weights %.17g, %.17g", o->distance, o->weights[k],
          p->weights[l]);
}

/* The offset of the curve run through backwards, to the other side. */
PH_TEST(test_offset_reverse) {
  struct unit_random r = unit_random_of(6);
  for (size_t i = 0; i < unit_cases(60); i++) {
    struct ph_curve back;
    struct ph_offset o, p;
    double *points, *w, d = unit_random_in(&r, -2, 2);
    size_t n;
    prop_any(&r, 30, &data);
    solve(i);
    back = u.result.curve;
    n = back.n;
    points = ph_arena_array(&u.arena, 12 * n, sizeof *points);
    w = ph_arena_array(&u.arena, 6 * n, sizeof *w);
    ck_assert(points && w);
    for (size_t k = 0; k < 6 * n; k++) {
      memcpy(points + 2 * k, back.control_points + 2 * (6 * n - 1 - k),
             2 * sizeof *points);
    }
    for (size_t k = 0; k < 3 * n; k++) { /* i w, as its square points back */
      w[2 * k] = -back.preimage.v[2 * (3 * n - 1 - k) + 1];
      w[2 * k + 1] = back.preimage.v[2 * (3 * n - 1 - k)];
    }
    back.control_points = points;
    back.preimage.v = w;
    ck_assert_int_eq(
        ph_offset(&u.result.curve, d, &within, &u.arena, &o, &u.diag), PH_OK);
    ck_assert_int_eq(ph_offset(&back, -d, &within, &u.arena, &p, &u.diag),
                     PH_OK);
    ck_assert_uint_eq(o.n, p.n);
    for (size_t k = 0; k < 10 * o.n; k++) {
      ck_same_point(&o, k, &p, 10 * o.n - 1 - k);
    }
  }
}

PH_FIXTURE(NULL, finish)
