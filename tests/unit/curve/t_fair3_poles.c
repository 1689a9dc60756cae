/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Fairness of spatial segments near cusps and inflections, against the
 * definitions in long double.  With g = B i B* of the quintic that has the same
 * tangents (see curve/fair/fair3.c), C = g x g' and primes by v,
 *
 *   ds = sinc |g| / q^3 dv
 *   kappa = q^3 |C| / (sinc |g|^3)                                       (1)
 *   tau = q^3 C . g'' / (sinc |C|^2)                                     (2)
 *
 * [0,1] is halved until no zero of |g| or C, real or not, is nearer to the
 * middle of a part than three times its ends: there 16 nodes err by 1e-24,
 * times what the order of the poles makes of it.
 */
#include "unit.h"
#include "spatial_unit.h"

#include "curve/fair/fair3.h"
#include "curve/segment/seg3.h"

#include <complex.h>

typedef long double real;
typedef long double complex number;

enum { SEGMENTS = 2000, STEPS = 200, DEPTH = 60, ZEROS = 6 };

static struct ph_fair3_rules rules;
static struct ph_quad rule;

static void begin(void) {
  ck_assert(ph_fair3_begin(&rules));
  ck_assert(ph_quad_gauss(&rule, 16));
}

struct quat {
  real x[4];
};

struct vec {
  real x[3];
};

/* B = b0 + b1 v + b2 v^2, q = 1 - k v (1 - v). */
struct exact {
  struct quat b[3];
  real k, sinc;
  number zero[ZEROS];
  real sum[3];
};

static real dot4(struct quat a, struct quat b) {
  return a.x[0] * b.x[0] + a.x[1] * b.x[1] + a.x[2] * b.x[2] + a.x[3] * b.x[3];
}

static real dot3(struct vec a, struct vec b) {
  return a.x[0] * b.x[0] + a.x[1] * b.x[1] + a.x[2] * b.x[2];
}

static struct vec cross3(struct vec a, struct vec b) {
  return (struct vec){{a.x[1] * b.x[2] - a.x[2] * b.x[1],
                       a.x[2] * b.x[0] - a.x[0] * b.x[2],
                       a.x[0] * b.x[1] - a.x[1] * b.x[0]}};
}

/* s (a i b* + b i a*) / 2 */
static struct vec turned(real s, struct quat a, struct quat b) {
  const real *x = a.x, *y = b.x;
  return (struct vec){
      {s * (x[0] * y[0] + x[1] * y[1] - x[2] * y[2] - x[3] * y[3]),
       s * (x[1] * y[2] + x[2] * y[1] + x[0] * y[3] + x[3] * y[0]),
       s * (x[1] * y[3] + x[3] * y[1] - x[0] * y[2] - x[2] * y[0])}};
}

/* p + i q of vect(a* b) */
static number between(struct quat a, struct quat b) {
  const real *x = a.x, *y = b.x;
  real p = x[0] * y[2] - x[2] * y[0] + x[1] * y[3] - x[3] * y[1];
  real q = x[0] * y[3] - x[3] * y[0] - x[1] * y[2] + x[2] * y[1];
  return p + q * I;
}

/* The zeros of |B|^2, by the iteration of Durand and Kerner, and of z. */
static void find_zeros(struct exact *e) {
  const struct quat *b = e->b;
  const real c[5] = {dot4(b[0], b[0]), 2 * dot4(b[0], b[1]),
                     dot4(b[1], b[1]) + 2 * dot4(b[0], b[2]),
                     2 * dot4(b[1], b[2]), dot4(b[2], b[2])};
  number *x = e->zero, z0 = between(b[0], b[1]), z1 = 2 * between(b[0], b[2]);
  number z2 = between(b[1], b[2]), root, sum;
  for (int i = 0; i < 4; i++) {
    x[i] = 0.5L + cexpl(1.5L * i * I + 0.4L * I);
  }
  for (int n = 0; n < STEPS; n++) {
    for (int i = 0; i < 4; i++) {
      number y = c[4], p = 1;
      for (int j = 3; j >= 0; j--) {
        y = y * x[i] + c[j];
      }
      for (int j = 0; j < 4; j++) {
        p *= j != i ? x[i] - x[j] : c[4];
      }
      x[i] -= y / p;
    }
  }
  root = csqrtl(z1 * z1 - 4 * z0 * z2);
  sum = creall(conjl(z1) * root) < 0 ? -z1 + root : -z1 - root;
  x[4] = sum / (2 * z2);
  x[5] = 2 * z0 / sum;
}

/* (1) and (2) */
static void add_node(struct exact *e, real v, real weight) {
  struct quat b, b1, b2;
  struct vec g, g1, g2, g3, c, c1;
  real q = 1 - e->k * v * (1 - v), dq = 3 * e->k * (2 * v - 1) / q;
  real sigma, square, rate, ds, kappa, slope, tau, turn, q3 = q * q * q;
  for (int i = 0; i < 4; i++) {
    b.x[i] = e->b[0].x[i] + v * (e->b[1].x[i] + v * e->b[2].x[i]);
    b1.x[i] = e->b[1].x[i] + 2 * v * e->b[2].x[i];
    b2.x[i] = 2 * e->b[2].x[i];
  }
  g = turned(1, b, b);
  g1 = turned(2, b, b1);
  g3 = turned(6, b1, b2);
  g2 = turned(2, b1, b1);
  for (int i = 0; i < 3; i++) {
    g2.x[i] += turned(2, b, b2).x[i];
  }
  c = cross3(g, g1);
  c1 = cross3(g, g2);
  square = dot3(c, c);
  rate = dot3(c, c1) / square;
  sigma = sqrtl(dot3(g, g));
  ds = e->sinc * sigma / q3;
  kappa = q3 * sqrtl(square) / (e->sinc * sigma * sigma * sigma);
  slope = kappa * (rate + dq - 3 * dot3(g, g1) / (sigma * sigma));
  tau = q3 / e->sinc * dot3(c, g2) / square;
  turn = q3 / e->sinc * dot3(c, g3) / square + tau * (dq - 2 * rate);
  e->sum[0] += weight * kappa * kappa * ds;
  e->sum[1] += weight * slope * slope / ds;
  e->sum[2] += weight * turn * turn / ds;
}

static void add_part(struct exact *e, real from, real to, int depth) {
  real middle = 0.5L * (from + to), nearest = 1;
  for (int i = 0; i < ZEROS; i++) {
    nearest = fminl(nearest, cabsl(e->zero[i] - middle));
  }
  if (nearest < 1.5L * (to - from) && depth < DEPTH) {
    add_part(e, from, middle, depth + 1);
    add_part(e, middle, to, depth + 1);
    return;
  }
  for (size_t i = 0; i < rule.n; i++) {
    add_node(e, from + (to - from) * (real)rule.node[i],
             (to - from) * (real)rule.weight[i]);
  }
}

static struct ph_fair3 exact(const struct ph_atph *space, const ph_quat a[3]) {
  struct exact e = {.k = 2 * (1 - (real)space->c), .sinc = space->sinc};
  const real c2 = 2 * (real)space->c;
  for (int i = 0; i < 4; i++) {
    real x[3];
    for (int j = 0; j < 3; j++) {
      x[j] = i == 0 ? a[j].u : i == 1 ? a[j].v : i == 2 ? a[j].p : a[j].q;
    }
    e.b[0].x[i] = x[0];
    e.b[1].x[i] = c2 * x[1] - 2 * x[0];
    e.b[2].x[i] = x[0] - c2 * x[1] + x[2];
  }
  find_zeros(&e);
  add_part(&e, 0, 1, 0);
  return (struct ph_fair3){(double)e.sum[0], (double)e.sum[1], (double)e.sum[2],
                           false};
}

/* Random data with derivatives of 1e-6 to 10 of the chord, and any of the
 * segments that they have. */
static void random_preimage(struct unit_random *r, const struct ph_atph *space,
                            ph_quat a[3]) {
  struct ph_spatial_data data = unit_random_spatial(r);
  struct ph_spatial_member member = {unit_random_phase(r),
                                     unit_random_phase(r)};
  struct ph_spatial_family family;
  data.ni = pow(10, unit_random_in(r, -6, 1));
  data.nf = pow(10, unit_random_in(r, -6, 1));
  family = ph_spatial_family_of(&data, space);
  ph_spatial_preimage(&family, member, a);
}

/* Near an inflection, rounding counts in F3. */
static void ck_fair(const struct ph_fair3 *found, const struct ph_fair3 *wanted,
                    double tolerance) {
  for (int k = 1; k <= 3; k++) {
    ck_rel(ph_fair3_functional(found, 1, k), ph_fair3_functional(wanted, 1, k),
           k < 3 ? tolerance : 10 * tolerance);
  }
}

/* PH segments, then ATPH segments. */
PH_TEST_EACH(test_derivatives, 2) {
  struct unit_random r = unit_random_of(1106);
  for (int n = 0; n < unit_count(SEGMENTS); n++) {
    struct ph_atph space =
        _i == 0 ? ph_atph_of(0) : ph_atph_of(exp(unit_random_in(&r, -9, 1.1)));
    struct ph_fair3 found, wanted;
    ph_quat a[3];
    random_preimage(&r, &space, a);
    found = ph_fair3_of(&rules, &space, a);
    wanted = exact(&space, a);
    ck_fair(&found, &wanted, 1e-9);
  }
}

/* Near-cusps of any sharpness anywhere: A nearly vanishes at a place, where the
 * speed and all integrands have peaks that no node need see. */
PH_TEST(test_near_cusps) {
  struct unit_random r = unit_random_of(1105);
  for (int n = 0; n < unit_count(2000); n++) {
    struct ph_seg3 seg = {.space = ph_atph_of(0)};
    double place = unit_random_in(&r, 0.01, 0.99);
    double sharp = pow(10, unit_random_in(&r, -5, 0));
    ph_quat least = ph_quat_scale(sharp, unit_random_turn(&r));
    ph_quat slope = unit_random_turn(&r);
    ph_quat bend =
        ph_quat_scale(unit_random_in(&r, 0, 1), unit_random_turn(&r));
    struct ph_fair3 found, wanted;
    slope =
        ph_quat_add(slope, ph_quat_scale(-ph_quat_dot(slope, least) /
                                             ph_quat_dot(least, least),
                                         least)); /* the least speed is there */
    for (size_t i = 0; i < 3;
         i++) { /* blossoms of least + slope y + bend y^2 */
      double y0 = (i == 2) - place, y1 = (i > 0) - place;
      seg.a[i] = ph_quat_add(least, ph_quat_scale(0.5 * (y0 + y1), slope));
      seg.a[i] = ph_quat_add(seg.a[i], ph_quat_scale(y0 * y1, bend));
    }
    found = ph_fair3_of(&rules, &seg.space, seg.a);
    wanted = exact(&seg.space, seg.a);
    ck_fair(&found, &wanted, 5e-10 + 64 * DBL_EPSILON / sharp);
  }
}

PH_FIXTURE(begin, NULL)
