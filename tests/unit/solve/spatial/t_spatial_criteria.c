/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The criteria CC, HC and BV: CC against the printed formulas in long double,
 * all of them against what they promise, and under rotation, change of scale,
 * reversal and reflection.
 *
 * Members depend on rounding of the data as much as 1/s, 1/c, the inverse of
 * the projection of A0 + A2 and, for HC and BV, that of the second derivative
 * let them.  Of random data few have large ones: see struct spread.
 */
#include "unit.h"
#include "spatial_unit.h"

#include "solve/spatial/spatial.h"

enum { CRITERIA = 3 };

static const double PI = 3.14159265358979323846;

static struct ph_spatial_member choose(size_t criterion,
                                       const struct ph_spatial_family *family) {
  return criterion == 0   ? ph_spatial_cc(family)
         : criterion == 1 ? ph_spatial_hc(family)
                          : ph_spatial_bv(family);
}

static void points_of(const struct ph_spatial_data *data,
                      const struct ph_atph *space, size_t criterion,
                      ph_vec3 p[6]) {
  struct ph_spatial_family f = ph_spatial_family_of(data, space);
  unit_spatial_points(&f, choose(criterion, &f), p);
}

/* Data that are, in turn, in general position, and at a random distance down to
 * 1e-15 from parallel tangents, opposite tangents and a plane. */
static struct ph_spatial_data near_singular(struct unit_random *r, int turn) {
  struct ph_spatial_data data = unit_random_spatial(r);
  double size = pow(10, -unit_random_in(r, 0, 15));
  if (turn % 4 == 1 || turn % 4 == 2) {
    data.tf = ph_vec3_unit(ph_vec3_along(data.ti, size, data.tf));
    data.tf = ph_vec3_scale(turn % 4 == 1 ? 1 : -1, data.tf);
  } else if (turn % 4 == 3) {
    data.ti.z *= size;
    data.tf.z *= size;
    data.dp.z *= size;
    data.ti = ph_vec3_unit(data.ti);
    data.tf = ph_vec3_unit(data.tf);
  }
  return data;
}

/* Errors of random segments: 1e-14 but for two and one in a thousand, and those
 * below 1e-12.  Of 400 000 against the printed formulas the worst was 2.5e-14,
 * and 999 of 1000 were below 1e-15. */
struct spread {
  int n, beyond;
};

static void add_error(struct spread *spread, double error) {
  ck_abs(error, 0, 1e-12);
  spread->n++;
  spread->beyond += error > 1e-14;
}

static void ck_spread(const struct spread *spread) {
  ck_assert_msg(spread->beyond <= 2 + spread->n / 1000,
                "seed %lu: %d of %d errors above 1e-14", unit_seed(),
                spread->beyond, spread->n);
}

/* ---- CC as printed -------------------------------------------------- */

/* A quaternion with vector part v; vectors have w = 0. */
struct lquat {
  long double w, v[3];
};

static struct lquat lpure(ph_vec3 v) {
  struct lquat a = {0, {(long double)v.x, (long double)v.y, (long double)v.z}};
  return a;
}

/* x a + y b */
static struct lquat lsum(long double x, struct lquat a, long double y,
                         struct lquat b) {
  struct lquat sum = {x * a.w + y * b.w, {0}};
  for (size_t i = 0; i < 3; i++) {
    sum.v[i] = x * a.v[i] + y * b.v[i];
  }
  return sum;
}

static struct lquat lscale(long double x, struct lquat a) {
  return lsum(x, a, 0, a);
}

/* Of vectors. */
static long double ldot(struct lquat a, struct lquat b) {
  return a.v[0] * b.v[0] + a.v[1] * b.v[1] + a.v[2] * b.v[2];
}

static long double labs3(struct lquat a) {
  return sqrtl(ldot(a, a));
}

static struct lquat lunit(struct lquat a) {
  return lscale(1 / labs3(a), a);
}

static struct lquat lmul(struct lquat a, struct lquat b) {
  struct lquat p = {a.w * b.w - ldot(a, b), {0}};
  for (size_t i = 0; i < 3; i++) {
    size_t j = (i + 1) % 3, k = (i + 2) % 3;
    p.v[i] = a.w * b.v[i] + b.w * a.v[i] + a.v[j] * b.v[k] - a.v[k] * b.v[j];
  }
  return p;
}

/* Of vectors. */
static struct lquat lcross(struct lquat a, struct lquat b) {
  struct lquat p = lmul(a, b);
  p.w = 0;
  return p;
}

/* (a u b* + b u a*) / 2 */
static struct lquat lsandwich(struct lquat a, struct lquat u, struct lquat b) {
  struct lquat ca = lscale(-1, a), cb = lscale(-1, b);
  ca.w = a.w;
  cb.w = b.w;
  return lsum(0.5L, lmul(lmul(a, u), cb), 0.5L, lmul(lmul(b, u), ca));
}

/* n (cos angle + u sin angle) */
static struct lquat lturned(struct lquat n, struct lquat u, long double angle) {
  struct lquat e = lscale(sinl(angle), u);
  e.w = cosl(angle);
  return lmul(n, e);
}

/* Data as they are printed, with s = 1. */
struct printed {
  struct lquat dp, ti, tf, u, ni, nf; /* ni, nf: bisectors (15) */
  long double li, lf;                 /* lambda */
};

static struct printed printed_of(const struct ph_spatial_data *data,
                                 ph_vec3 axis) {
  struct printed p = {.dp = lpure(data->dp),
                      .ti = lunit(lpure(data->ti)),
                      .tf = lunit(lpure(data->tf)),
                      .u = lunit(lpure(axis)),
                      .li = (long double)data->ni,
                      .lf = (long double)data->nf};
  p.ni = lunit(lsum(1, p.u, 1, p.ti));
  p.nf = lunit(lsum(1, p.u, 1, p.tf));
  return p;
}

/* beta of (25), with e and f of (20) and the right side of (28). */
static long double printed_beta(const struct printed *p) {
  struct lquat sum = lsum(1, p->ti, 1, p->tf);
  struct lquat difference = lsum(1, p->tf, -1, p->ti);
  struct lquat cross = lcross(p->ti, p->tf);
  struct lquat minus = lunit(difference), plus = lunit(sum), hat = lunit(cross);
  long double per =
      1 / (labs3(lsum(1, p->u, 1, p->ti)) * labs3(lsum(1, p->u, 1, p->tf)));
  struct lquat e =
      lsum(1 + ldot(p->u, p->tf), p->ti, 1 + ldot(p->u, p->ti), p->tf);
  struct lquat f = lsum(1, lcross(difference, p->u), -1, cross);
  struct lquat w = lsum(p->li, p->ti, p->lf, p->tf), right;
  long double ee, ff, ef, re, rf;
  e = lscale(per, lsum(1, e, 1 - ldot(p->ti, p->tf), p->u));
  f = lscale(per, f);
  w = lsum(3, p->dp, -1, w);
  w = lsum(1, w, -ldot(w, minus), minus);
  right = lscale(labs3(cross) / hypotl(ldot(w, plus) * labs3(cross),
                                       ldot(w, hat) * labs3(sum)),
                 w);
  /* e and f are a basis of the plane of `right`. */
  ee = ldot(e, e);
  ff = ldot(f, f);
  ef = ldot(e, f);
  re = ldot(right, e);
  rf = ldot(right, f);
  return atan2l(ee * rf - ef * re, ff * re - ef * rf);
}

/* alpha of (30) and (31), with n of d. */
static long double printed_alpha(const struct printed *p, long double beta,
                                 struct lquat n) {
  long double ri = sqrtl(p->li), rf = sqrtl(p->lf), t = tanl(beta / 2);
  struct lquat ui = lcross(p->u, p->ni), uf = lcross(p->u, p->nf);
  long double a = ldot(lsum(ri, p->ni, -rf, p->nf), n);
  long double b = ldot(lsum(ri, ui, rf, uf), n);
  long double c = ldot(lsum(ri, p->ni, rf, p->nf), n);
  long double d = ldot(lsum(ri, ui, -rf, uf), n);
  return atan2l(a * t - b, c + d * t);
}

/* (11)-(17), and (6). */
static void printed_points(const struct ph_spatial_data *data, ph_vec3 axis,
                           ph_vec3 points[6]) {
  struct printed p = printed_of(data, axis);
  long double beta = printed_beta(&p), alpha;
  struct lquat a[3], d, n, at = {0, {0}}, leg[5];
  a[0] = lturned(p.ni, p.u, -beta / 2);
  a[2] = lturned(p.nf, p.u, beta / 2);
  d = lsum(10 * sqrtl(p.li * p.lf), lsandwich(a[0], p.u, a[2]), 120, p.dp);
  d = lsum(1, d, -15, lsum(p.li, p.ti, p.lf, p.tf));
  n = lunit(lsum(1, p.u, 1, lunit(d)));
  alpha = printed_alpha(&p, beta, n);
  a[0] = lscale(sqrtl(p.li), lturned(p.ni, p.u, alpha - beta / 2));
  a[2] = lscale(sqrtl(p.lf), lturned(p.nf, p.u, alpha + beta / 2));
  a[1] = lsum(0.25L * sqrtl(labs3(d)), n, -0.75L, lsum(1, a[0], 1, a[2]));
  leg[0] = lscale(0.2L, lsandwich(a[0], p.u, a[0]));
  leg[1] = lscale(0.2L, lsandwich(a[0], p.u, a[1]));
  leg[2] = lsum(1 / 15.0L, lsandwich(a[0], p.u, a[2]), 2 / 15.0L,
                lsandwich(a[1], p.u, a[1]));
  leg[3] = lscale(0.2L, lsandwich(a[1], p.u, a[2]));
  leg[4] = lscale(0.2L, lsandwich(a[2], p.u, a[2]));
  for (size_t i = 0;; i++) {
    points[i] = ph_vec3_of((double)at.v[0], (double)at.v[1], (double)at.v[2]);
    if (i == 5) {
      return;
    }
    at = lsum(1, at, 1, leg[i]);
  }
}

enum { PRINTED = 10000, DATA = 2000 };

/* With the axis (34), and others: the criterion does not depend on it. */
PH_TEST(test_printed) {
  struct unit_random r = unit_random_of(501);
  const struct ph_atph space = ph_atph_of(0);
  struct spread spread = {0, 0};
  for (int i = 0; i < unit_count(PRINTED); i++) {
    struct ph_spatial_data data = unit_random_spatial(&r);
    ph_vec3 axis = i & 1 ? unit_random_direction(&r) : data.dp;
    ph_vec3 found[6], wanted[6];
    points_of(&data, &space, 0, found);
    printed_points(&data, axis, wanted);
    add_error(&spread, unit_spatial_error(found, wanted));
  }
  ck_spread(&spread);
}

/* ---- transformed data ----------------------------------------------- */

enum transform { ROTATION, SCALE, REVERSAL, REFLECTION };

struct motion {
  enum transform kind;
  ph_quat turn;
  double factor;
};

static ph_vec3 moved(const struct motion *m, ph_vec3 v) {
  ph_quat turned;
  switch (m->kind) {
  case ROTATION:
    turned = ph_quat_mul(m->turn, ph_quat_pure(v));
    return ph_quat_vector(ph_quat_mul(turned, ph_quat_conj(m->turn)));
  case SCALE:
    return ph_vec3_scale(m->factor, v);
  case REFLECTION:
    return ph_vec3_of(v.x, -v.y, v.z);
  default:
    return v;
  }
}

static struct ph_spatial_data moved_data(const struct motion *m,
                                         struct ph_spatial_data data) {
  struct ph_spatial_data to = data;
  to.dp = moved(m, data.dp);
  if (m->kind == SCALE) {
    to.ni *= m->factor;
    to.nf *= m->factor;
  } else if (m->kind == REVERSAL) {
    to.dp = ph_vec3_scale(-1, data.dp);
    to.ti = ph_vec3_scale(-1, data.tf);
    to.tf = ph_vec3_scale(-1, data.ti);
    to.ni = data.nf;
    to.nf = data.ni;
  } else {
    to.ti = moved(m, data.ti);
    to.tf = moved(m, data.tf);
  }
  return to;
}

static double moved_error(const struct motion *m,
                          const struct ph_spatial_data *data,
                          const struct ph_atph *space, size_t criterion) {
  struct ph_spatial_data to = moved_data(m, *data);
  ph_vec3 p[6], found[6], wanted[6];
  points_of(data, space, criterion, p);
  points_of(&to, space, criterion, found);
  for (size_t i = 0; i < 6; i++) {
    wanted[i] =
        m->kind == REVERSAL ? ph_vec3_sub(p[5 - i], p[5]) : moved(m, p[i]);
  }
  return unit_spatial_error(found, wanted);
}

PH_TEST(test_moved) {
  struct unit_random r = unit_random_of(502);
  struct spread spread[CRITERIA] = {{0, 0}};
  for (int i = 0; i < unit_count(DATA); i++) {
    struct ph_spatial_data data = unit_random_spatial(&r);
    struct ph_atph space = unit_random_space(&r);
    struct motion m = {ROTATION, unit_random_turn(&r), 1};
    for (size_t j = 0; j < CRITERIA; j++) {
      m.kind = ROTATION;
      add_error(&spread[j], moved_error(&m, &data, &space, j));
      m.kind = SCALE;
      m.factor = exp(unit_random_in(&r, -3, 3));
      add_error(&spread[j], moved_error(&m, &data, &space, j));
      m.factor = pow(4, i % 9 - 4); /* its root is exact */
      ck_abs(moved_error(&m, &data, &space, j), 0, 0);
      m.kind = REVERSAL;
      ck_abs(moved_error(&m, &data, &space, j), 0, 1e-14);
      m.kind = REFLECTION;
      ck_abs(moved_error(&m, &data, &space, j), 0, 1e-14);
    }
  }
  for (size_t j = 0; j < CRITERIA; j++) {
    ck_spread(&spread[j]);
  }
}

/* ---- cubics --------------------------------------------------------- */

/* The data of a PH cubic, and its control points, raised to degree 5: CC and BV
 * find it. */
PH_TEST(test_cubic) {
  struct unit_random r = unit_random_of(503);
  const struct ph_atph space = ph_atph_of(0);
  struct spread spread[2] = {{0, 0}};
  for (int i = 0; i < unit_count(DATA); i++) {
    ph_quat a = ph_quat_scale(unit_random_in(&r, 0.5, 2), unit_random_turn(&r));
    ph_quat c = ph_quat_scale(unit_random_in(&r, 0.5, 2), unit_random_turn(&r));
    const ph_quat all[3] = {a, ph_quat_scale(0.5, ph_quat_add(a, c)), c};
    ph_vec3 leg[5], wanted[6] = {{0, 0, 0}}, found[6];
    struct ph_spatial_data data = {
        .ti = ph_vec3_unit(ph_quat_i(a, a)),
        .tf = ph_vec3_unit(ph_quat_i(c, c)),
        .ni = ph_quat_dot(a, a),
        .nf = ph_quat_dot(c, c),
    };
    unit_spatial_legs(&space, all, leg);
    for (size_t k = 0; k < 5; k++) {
      wanted[k + 1] = ph_vec3_add(wanted[k], leg[k]);
    }
    data.dp = wanted[5];
    points_of(&data, &space, 0, found);
    add_error(&spread[0], unit_spatial_error(found, wanted));
    points_of(&data, &space, 2, found);
    add_error(&spread[1], unit_spatial_error(found, wanted));
  }
  ck_spread(&spread[0]);
  ck_spread(&spread[1]);
}

/* ---- extrema -------------------------------------------------------- */

/* |A1 - (A0 + A2) / 2| */
static double gap_of(const struct ph_spatial_family *f,
                     struct ph_spatial_member member) {
  ph_quat a[3];
  ph_spatial_preimage(f, member, a);
  return ph_quat_abs(
      ph_quat_sub(a[1], ph_quat_scale(0.5, ph_quat_add(a[0], a[2]))));
}

/* dL/db by differences of four values. */
static double length_slope(const struct ph_spatial_family *f, ph_cplx b) {
  const double h = 1e-3;
  double d[2];
  for (int i = 1; i <= 2; i++) {
    const ph_cplx step = ph_cplx_polar(i * h);
    d[i - 1] = ph_spatial_length(f, ph_cplx_mul(b, step)) -
               ph_spatial_length(f, ph_cplx_mul(b, ph_cplx_conj(step)));
  }
  return (8 * d[0] - d[1]) / (12 * h);
}

/* No member of many is longer than HC or nearer than BV, of plane data no plane
 * one; HC is stationary. */
static void ck_extrema(const struct ph_spatial_family *f) {
  struct ph_spatial_member hc = ph_spatial_hc(f), bv = ph_spatial_bv(f), m;
  double longest = ph_spatial_length(f, hc.b), nearest = gap_of(f, bv);
  double longer = 0, nearer = 0;
  for (int i = 0; i < 360; i++) {
    m.b = ph_cplx_polar(i * PI / 180);
    m.phi = ph_cplx_polar((i % 4) * 1e-3); /* 0 is best */
    longer = unit_larger(ph_spatial_length(f, m.b) - longest, longer);
    if (!f->planar || i % 180 == 0) {
      nearer = unit_larger(nearest - gap_of(f, m), nearer);
    }
  }
  ck_abs(longer, 0, 4e-15);
  ck_abs(nearer, 0, 1e-14);
  ck_abs(ph_cplx_abs(hc.b), 1, 4e-16);
  ck_abs(ph_cplx_abs(bv.b), 1, 4e-16);
  ck_abs(length_slope(f, hc.b), 0, 1e-8);
}

PH_TEST(test_extrema) {
  struct unit_random r = unit_random_of(504);
  for (int i = 0; i < unit_count(DATA); i++) {
    struct ph_spatial_data data = near_singular(&r, i);
    struct ph_atph space = unit_random_space(&r);
    struct ph_spatial_family f = ph_spatial_family_of(&data, &space);
    ck_extrema(&f);
  }
}

/* Next to plane data the lengths at two roots of the quartic are the same, and
 * rounding chooses the one that is refined. */
PH_TEST(test_nearly_plane) {
  struct unit_random r = unit_random_of(507);
  for (int i = 0; i < unit_count(DATA); i++) {
    struct ph_spatial_data data = unit_random_spatial(&r);
    struct ph_atph space = unit_random_space(&r);
    struct motion m = {ROTATION, unit_random_turn(&r), 1};
    double size = pow(10, -4 - i % 7);
    data.ti.z *= size;
    data.tf.z *= size;
    data.dp.z *= size;
    data.ti = ph_vec3_unit(data.ti);
    data.tf = ph_vec3_unit(data.tf);
    ck_abs(moved_error(&m, &data, &space, 1), 0, 1e-11);
  }
}

/* ---- plane and straight data ---------------------------------------- */

/* All are plane, and their reversals are the same. */
PH_TEST(test_plane) {
  struct unit_random r = unit_random_of(505);
  const struct motion reversal = {.kind = REVERSAL};
  int opposite = 0;
  for (int i = 0; i < unit_count(DATA); i++) {
    struct ph_spatial_data data = unit_random_spatial(&r);
    struct ph_atph space = unit_random_space(&r);
    struct motion m = {ROTATION, unit_random_turn(&r), 1};
    struct ph_spatial_family f;
    struct ph_spatial_member bv;
    data.ti.z = data.tf.z = data.dp.z = 0;
    data.ti = ph_vec3_unit(data.ti);
    data.tf = ph_vec3_unit(data.tf);
    data = i & 1 ? moved_data(&m, data) : data;
    f = ph_spatial_family_of(&data, &space);
    if (!f.planar) { /* its tangents are too near to opposite */
      ck_assert_double_lt(f.c, 2e-3);
      continue;
    }
    bv = ph_spatial_bv(&f);
    ck_abs(ph_spatial_cc(&f).b.im, 0, 0);
    ck_abs(ph_spatial_hc(&f).b.im, 0, 0);
    ck_abs(bv.b.im, 0, 0);
    ck_extrema(&f);
    opposite += bv.b.re < 0;
    for (size_t k = 0; k < CRITERIA; k++) {
      ck_abs(moved_error(&reversal, &data, &space, k), 0, 1e-13);
    }
  }
  ck_assert_int_gt(opposite, 0); /* or this has tested nothing */
}

/* A line is found by all, although all members are as long as it. */
PH_TEST(test_straight) {
  struct unit_random r = unit_random_of(506);
  for (int i = 0; i < unit_count(DATA); i++) {
    struct ph_spatial_data data = unit_random_spatial(&r);
    struct ph_atph space = unit_random_space(&r);
    struct ph_spatial_family f;
    data.ti = data.tf = data.dp;
    data.ni = unit_random_in(&r, 0.1, 1);
    data.nf = unit_random_in(&r, 0.1, 1);
    f = ph_spatial_family_of(&data, &space);
    for (size_t k = 0; k < CRITERIA; k++) {
      ck_abs(choose(k, &f).b.re, 1, 0);
    }
    ck_rel(ph_spatial_length(&f, ph_cplx_of(1, 0)), f.h, 1e-14);
  }
}
