/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Fairness of planar splines: against quadrature that spares no node. */
#include "unit.h"
#include "segment_unit.h"
#include "tc_curve_unit.h"

#include "curve/fair/energy.h"
#include "curve/segment/tc.h"

enum { SEGMENTS = 60, PANELS = 400 };

static const double PI = 3.14159265358979323846;

/* Curves that do not nearly stand still: their panels are enough. */
static bool is_slow(const struct ph_seg2 *seg) {
  for (size_t i = 0; i <= 50; i++) {
    if (ph_seg2_curvature(seg, (double)i / 50).speed < 0.05) {
      return true;
    }
  }
  return false;
}

static struct ph_seg2 random_segment(struct unit_random *r) {
  struct ph_seg2 seg = unit_seg2_random(r);
  for (size_t i = 0; i < 100 && is_slow(&seg); i++) {
    seg = unit_seg2_random(r);
  }
  ck_assert(!is_slow(&seg));
  return seg;
}

static struct ph_energy direct(const struct ph_seg2 *seg) {
  struct ph_energy e = {0};
  for (size_t i = 0; i < PANELS; i++) {
    for (size_t j = 0; j < unit_quad(20)->n; j++) {
      struct ph_curvature bend =
          ph_seg2_curvature(seg, ((double)i + unit_quad(20)->node[j]) / PANELS);
      double weight = unit_quad(20)->weight[j] / PANELS;
      e.bending += weight * pow(bend.curvature, 2) * bend.speed;
      e.varying += weight * pow(bend.rate, 2) / bend.speed;
    }
  }
  return e;
}

static struct ph_energy energy_of(const struct ph_seg2 *seg, size_t n) {
  struct unit_segments s;
  struct ph_energy energy;
  unit_seg2_curve(seg, n, &s);
  ck_assert(ph_energy_planar(&s.curve, &energy));
  return energy;
}

PH_TEST(test_quadrature) {
  struct unit_random r = unit_random_of(520);
  for (size_t n = 0; n < SEGMENTS; n++) {
    struct ph_seg2 seg = random_segment(&r);
    struct ph_energy wanted = direct(&seg), found = energy_of(&seg, 1);
    double absolute, rotation = ph_seg2_rotation(&seg, &absolute);
    ck_rel(found.bending, wanted.bending, 2e-12);
    ck_rel(found.varying, wanted.varying, 2e-12);
    ck_abs(found.rotation, rotation / (2 * PI), 1e-14);
    ck_abs(found.absolute_rotation, absolute / (2 * PI), 1e-14);
  }
}

/* A place on the ellipse with foci 0 and 1, by its major semiaxis over 1/2. */
static ph_cplx on_ellipse(double axis, double angle) {
  return ph_cplx_of(0.5 + 0.5 * axis * cos(angle),
                    0.5 * sqrt(axis * axis - 1) * sin(angle));
}

/* Of sin(a (u - z) / 2), or u - z, the values at u = 0 and 1, of size 1. */
static void form_of(double angle, ph_cplx z, ph_cplx form[2]) {
  for (int i = 0; i < 2; i++) {
    const ph_cplx at = ph_cplx_sub(ph_cplx_of(i, 0), z);
    const double re = 0.5 * angle * at.re, im = 0.5 * angle * at.im;
    form[i] =
        angle > 0 ? ph_cplx_of(sin(re) * cosh(im), cos(re) * sinh(im)) : at;
  }
  form[1] = ph_cplx_scale(1 / ph_cplx_abs(form[0]), form[1]);
  form[0] = ph_cplx_scale(1 / ph_cplx_abs(form[0]), form[0]);
}

/* The segment of two zeros. */
static struct ph_seg2 of_zeros(double angle, ph_cplx y, ph_cplx z) {
  ph_cplx p[2], r[2], w[3];
  form_of(angle, y, p);
  form_of(angle, z, r);
  w[0] = ph_cplx_mul(p[0], r[0]);
  w[1] = ph_cplx_add(ph_cplx_mul(p[0], r[1]), ph_cplx_mul(p[1], r[0]));
  w[1] = ph_cplx_scale(0.5 / cos(0.5 * angle), w[1]);
  w[2] = ph_cplx_mul(p[1], r[1]);
  return unit_seg2(angle, w);
}

/* 5e-13 of a square, and what rounding leaves of its root, some of w: with 256
 * eps four nodes are enough for an angle of 1.5, too, and with 32 rounding is
 * too much. */
static double allowance(double square) {
  return 5e-13 * square + 64 * DBL_EPSILON * (sqrt(square) + DBL_EPSILON);
}

/* One zero of w just where a rule is enough, or not, the other there, too, near
 * the same place, mirrored or turned, or farther off. */
static void check_zeros(double angle, double axis, double at) {
  const ph_cplx z = on_ellipse(axis, at);
  const ph_cplx others[] = {
      on_ellipse(axis, 1.7 * at), on_ellipse(1.01 * axis, 0.02 - at),
      on_ellipse(1.001 * axis, 1.01 * at), on_ellipse(3 * axis, 2 * at),
      on_ellipse(1.1 * axis, at + 3.3)};
  for (size_t j = 0; j < COUNT(others); j++) {
    const struct ph_seg2 seg = of_zeros(angle, z, others[j]);
    const struct ph_energy wanted = direct(&seg), found = energy_of(&seg, 1);
    ck_abs(found.bending, wanted.bending, allowance(wanted.bending));
    ck_abs(found.varying, wanted.varying, allowance(wanted.varying));
  }
}

PH_TEST(test_zeros) {
  static const double axes[] = {1.3,  1.7,  2.39, 2.41, 3.09, 3.11, 5.29,
                                5.31, 12.4, 12.6, 29,   31,   199,  201};
  static const double angles[] = {0, 0.06, 0.5, 1.5, 2.1};
  for (size_t i = 0; i < COUNT(axes); i++) {
    for (size_t j = 0; j < COUNT(angles); j++) {
      for (int k = 0; k < 16; k++) {
        check_zeros(angles[j], axes[i], 0.05 + 0.4 * k);
      }
    }
  }
}

/* Segments add up, and so do parts. */
PH_TEST(test_sum) {
  struct unit_random r = unit_random_of(521);
  for (size_t n = 0; n < SEGMENTS; n++) {
    struct ph_seg2 seg = random_segment(&r), part[3];
    struct ph_energy whole, parts;
    for (size_t i = 0; i < 3; i++) {
      const double at[] = {0, 0.3, 0.55, 1};
      part[i] = unit_seg2_part(&seg, unit_quad(20), at[i], at[i + 1]);
    }
    whole = energy_of(&seg, 1);
    parts = energy_of(part, 3);
    ck_rel(parts.bending, whole.bending, 1e-11);
    ck_rel(parts.varying, whole.varying, 1e-11);
    ck_abs(parts.rotation, whole.rotation, 1e-12);
    ck_abs(parts.absolute_rotation, whole.absolute_rotation, 1e-12);
  }
}

/* A number, or none where it is out of range. */
static void check_scaled(double found, double one, int exponent) {
  double wanted = ldexp(one, exponent);
  if (wanted >= DBL_MIN && isfinite(wanted)) {
    ck_rel(found, wanted, 1e-12);
  } else {
    ck_assert(!isfinite(found));
  }
}

/* A curve s times as large has E / s and MV / s^3, and the same IES and IMV; s
 * is a power of two, and its root too. */
PH_TEST(test_scale) {
  struct unit_random r = unit_random_of(522);
  for (int exponent = -504; exponent <= 504; exponent += 8) {
    struct ph_seg2 seg = random_segment(&r);
    struct ph_energy one = energy_of(&seg, 1), other;
    ph_cplx w[3];
    for (size_t i = 0; i < 3; i++) {
      w[i] = ph_cplx_scale(ldexp(1, exponent), seg.w[i]);
    }
    seg = unit_seg2(seg.space.angle, w);
    other = energy_of(&seg, 1);
    check_scaled(other.bending, one.bending, -2 * exponent);
    check_scaled(other.varying, one.varying, -6 * exponent);
    ck_rel(other.ies, one.ies, 1e-12);
    ck_rel(other.imv, one.imv, 1e-12);
    ck_rel(other.rotation, one.rotation, 1e-14);
  }
}

/* w = e^(it), t in [-a/2,a/2]: an arc of radius 1/2 by t, that turns by 2 a. */
PH_TEST(test_circle) {
  for (double a = 0.125; a < 3; a += 0.25) {
    const double root = sqrt(a);
    ph_cplx w[3] = {ph_cplx_scale(root, ph_cplx_polar(-a / 2)),
                    ph_cplx_of(root / cos(a / 2), 0),
                    ph_cplx_scale(root, ph_cplx_polar(a / 2))};
    struct ph_seg2 seg = unit_seg2(a, w);
    struct ph_energy e = energy_of(&seg, 1);
    ck_rel(e.bending, 4 * a, 1e-12);
    ck_abs(e.varying, 0, 1e-20);
    ck_rel(e.rotation, a / PI, 1e-14);
    ck_rel(e.absolute_rotation, a / PI, 1e-14);
  }
}

/* A line bends nowhere. */
PH_TEST(test_line) {
  for (int atph = 0; atph < 2; atph++) {
    const ph_cplx w[3] = {{1, 2}, {2, 4}, {0.5, 1}};
    struct ph_seg2 seg = unit_seg2(atph, w);
    struct ph_energy e = energy_of(&seg, 1);
    ck_abs(e.bending, 0, 1e-25);
    ck_abs(e.varying, 0, 1e-25);
    ck_abs(e.absolute_rotation, 0, 1e-15);
  }
}

/* (integral of |kappa|)^2 <= E L, by Cauchy and Schwarz. */
PH_TEST(test_bound) {
  struct unit_random r = unit_random_of(523);
  for (size_t n = 0; n < SEGMENTS; n++) {
    struct ph_seg2 seg = random_segment(&r);
    struct ph_energy e = energy_of(&seg, 1);
    double length = 0;
    for (size_t j = 0; j < unit_quad(20)->n; j++) {
      length += unit_quad(20)->weight[j] *
                ph_seg2_curvature(&seg, unit_quad(20)->node[j]).speed;
    }
    ck_assert_double_ge(e.bending * length * (1 + 1e-12),
                        pow(2 * PI * e.absolute_rotation, 2));
  }
}

/* Of cubics both are known in closed form. */
PH_TEST(test_cubics) {
  const double scales[] = {1, 1e-9, 1e9};
  struct unit_random r = unit_random_of(524);
  for (size_t n = 0; n < SEGMENTS; n++) {
    const double scale = scales[n % 3];
    struct unit_cubics c;
    struct ph_energy found;
    double bending = 0, turned = 0, absolute = 0;
    unit_cubics_random(&c, &r, 3, scale, unit_random_cplx(&r, scale));
    for (size_t k = 0; k < 3; k++) {
      const double *w = c.preimage + 4 * k;
      const struct ph_tc tc = {{{w[0], w[1]}, {w[2], w[3]}}};
      bending += ph_tc_energy(&tc);
      turned += ph_tc_turning(&tc);
      absolute += fabs(ph_tc_turning(&tc));
    }
    ck_assert(ph_energy_planar(&c.curve, &found));
    ck_rel(found.bending, bending, 1e-12);
    ck_abs(2 * PI * found.rotation, turned, 1e-14);
    ck_abs(2 * PI * found.absolute_rotation, absolute, 1e-14);
  }
}

/* ---- curves that nearly stand still -------------------------------------- */

/* The sum of what energy.c integrates, in long double. */
struct sums {
  long double bending, varying, turned, absolute;
};

/* w and two derivatives, straight from the definition (1), (2) of atph.h. */
static void exact_jet(const struct ph_seg2 *seg, long double u,
                      long double re[3], long double im[3]) {
  long double h = seg->space.angle / 2.0L, v = 1 - u, b[3][3];
  long double s[3] = {v, -1, 0}, t[3] = {u, 1, 0}, c = 1;
  if (h > 0) {
    c = cosl(h);
    s[0] = sinl(h * v) / sinl(h), s[1] = -h * cosl(h * v) / sinl(h);
    t[0] = sinl(h * u) / sinl(h), t[1] = h * cosl(h * u) / sinl(h);
    s[2] = -h * h * s[0], t[2] = -h * h * t[0];
  }
  b[0][0] = s[0] * s[0], b[0][1] = 2 * c * s[0] * t[0], b[0][2] = t[0] * t[0];
  b[1][0] = 2 * s[0] * s[1], b[1][2] = 2 * t[0] * t[1];
  b[1][1] = 2 * c * (s[1] * t[0] + s[0] * t[1]);
  b[2][0] = 2 * (s[1] * s[1] + s[0] * s[2]);
  b[2][1] = 2 * c * (s[2] * t[0] + 2 * s[1] * t[1] + s[0] * t[2]);
  b[2][2] = 2 * (t[1] * t[1] + t[0] * t[2]);
  for (size_t i = 0; i < 3; i++) {
    re[i] = im[i] = 0;
    for (size_t j = 0; j < 3; j++) {
      re[i] += b[i][j] * seg->w[j].re;
      im[i] += b[i][j] * seg->w[j].im;
    }
  }
}

static void add_exact(const struct ph_seg2 *seg, long double u,
                      long double weight, struct sums *sums) {
  long double x[3], y[3], speed, turn, slope;
  exact_jet(seg, u, x, y);
  speed = x[0] * x[0] + y[0] * y[0];
  turn = 2 * (x[0] * y[1] - y[0] * x[1]) / speed;
  slope = 2 * (x[0] * y[2] - y[0] * x[2]) / (speed * speed) -
          4 * turn * (x[0] * x[1] + y[0] * y[1]) / (speed * speed);
  sums->bending += weight * turn * turn / speed;
  sums->varying += weight * slope * slope / speed;
  sums->turned += weight * turn;
  sums->absolute += weight * fabsl(turn);
}

/* From u = at to the side, by panels that grow from 1/4 of `near`, which is the
 * distance of a zero of w from there. */
static void add_graded(const struct ph_seg2 *seg, double at, int side,
                       long double room, double near, struct sums *sums) {
  long double from = 0;
  while (from < room) {
    long double to = from + fmaxl(near, from) / 4;
    to = to < room ? to : room;
    for (size_t i = 0; i < unit_quad(20)->n; i++) {
      long double away = from + (to - from) * unit_quad(20)->node[i];
      add_exact(seg, at + side * away, (to - from) * unit_quad(20)->weight[i],
                sums);
    }
    from = to;
  }
}

/* To either side of a place that is near to a zero of w. */
static struct sums exact(const struct ph_seg2 *seg, double at, double near) {
  struct sums sums = {0, 0, 0, 0};
  add_graded(seg, at, -1, at, near, &sums);
  add_graded(seg, at, 1, 1 - (long double)at, near, &sums);
  return sums;
}

/*
 * A segment whose preimage is 0 beside u = at, at a distance of about near:
 * along a line but for that, or, if it bends, with another zero off the line.
 */
static struct ph_seg2 near_stop(int kind, double at, double near, bool bends,
                                ph_cplx factor) {
  double half = kind == 1 ? 0.7 : 0, c = cos(half);
  double v =
      kind == 1 ? sin(half * at) / (sin(half * (1 - at)) + sin(half * at)) : at;
  ph_cplx p = {-v, near}, r = {1 - v, near};
  ph_cplx other[2] = {{1, 0}, {kind == 2 ? 1 : 0.4, bends ? 0.8 : 0}};
  ph_cplx w[3] = {
      ph_cplx_mul(p, other[0]),
      ph_cplx_add(ph_cplx_mul(p, other[1]), ph_cplx_mul(r, other[0])),
      ph_cplx_mul(r, other[1])};
  w[1] = ph_cplx_scale(0.5 / c, w[1]);
  for (size_t i = 0; i < 3; i++) {
    w[i] = ph_cplx_mul(factor, w[i]);
  }
  return unit_seg2(2 * half, w);
}

static void check_stop(int kind, double at, double near, bool bends,
                       ph_cplx factor) {
  struct ph_seg2 seg = near_stop(kind, at, near, bends, factor);
  struct ph_energy found = energy_of(&seg, 1);
  double place = -1, tolerance = 1e-12 + 200 * DBL_EPSILON / fabs(near);
  struct sums wanted;
  if (fabs(near) < 1e-8) {
    ck_assert(ph_seg2_stands_still(&seg, &place));
    ck_abs(place, at, 1e-8);
    ck_assert(isnan(found.bending) && isnan(found.varying));
    ck_assert(isnan(found.ies) && isnan(found.imv));
    ck_assert(isnan(found.rotation) && isnan(found.absolute_rotation));
    return;
  }
  ck_assert(!ph_seg2_stands_still(&seg, NULL));
  wanted = exact(&seg, at, fabs(near));
  ck_rel(found.bending, (double)wanted.bending, tolerance);
  ck_rel(found.varying, (double)wanted.varying, tolerance);
  ck_abs(found.rotation, (double)wanted.turned / (2 * PI), tolerance);
  /* what is integrated has kinks where the segment bends the other way */
  ck_abs(found.absolute_rotation, (double)wanted.absolute / (2 * PI),
         bends ? 1e-5 : tolerance);
}

/* Near to a stop, within and at the ends, everything is right or, where it is
 * rounding, is not told: in every direction, at every scale. */
PH_TEST(test_stops) {
  const double nears[] = {0,    1e-17, -1e-16, 1e-12, -1e-10, 1e-9,
                          1e-6, -1e-5, 1e-4,   -1e-3, 1e-2};
  const double places[] = {0, 1e-3, 0.25, 0.5, 0.71, 1};
  const double scales[] = {1, 0x1p-40, 0x1p40};
  for (int kind = 0; kind < 3; kind++) {
    for (size_t i = 0; i < COUNT(nears); i++) {
      for (size_t j = 0; j < COUNT(places); j++) {
        for (int direction = 0; direction < 4; direction++) {
          ph_cplx factor = ph_cplx_scale(scales[(i + j) % 3],
                                         ph_cplx_polar(0.8 * direction));
          check_stop(kind, places[j], nears[i], kind < 2 && direction % 2,
                     factor);
        }
      }
    }
  }
}

/* The square of a linear form: two zeros in one place, or nearly so. */
PH_TEST(test_double_stops) {
  for (int kind = 0; kind < 2; kind++) {
    for (double apart = 1e-1; apart > 1e-12; apart *= 0.1) {
      for (int direction = 0; direction < 4; direction++) {
        ph_cplx f = ph_cplx_polar(0.8 * direction);
        ph_cplx w[3] = {
            ph_cplx_scale(0.3 * (0.3 + apart), f),
            ph_cplx_scale(-0.5 * (0.42 + 0.4 * apart) / cos(kind * 0.7), f),
            ph_cplx_scale(0.7 * (0.7 - apart), f)};
        struct ph_seg2 seg = unit_seg2(kind * 1.4, w);
        ck_assert(ph_seg2_stands_still(&seg, NULL));
        ck_assert(isnan(energy_of(&seg, 1).rotation));
      }
    }
  }
}

/* A segment that turns little and is slow at both ends has a peak at each, of
 * which no rule saw the second where halving came to it after the first. */
PH_TEST(test_slow_ends) {
  for (double slow = 0.5; slow > 3e-7; slow *= 0.3) {
    for (double ratio = 0.1; ratio < 20; ratio *= 3) {
      const ph_cplx w[3] = {
          {slow, slow}, {-0.6, 0.8}, {0, slow * fmin(ratio, 1 / slow)}};
      const double near = 0.25 * slow * fmin(ratio, 1);
      struct ph_seg2 seg = unit_seg2(0, w);
      struct ph_energy found = energy_of(&seg, 1);
      struct sums wanted = {0, 0, 0, 0};
      add_graded(&seg, 0, 1, 0.5L, near, &wanted);
      add_graded(&seg, 1, -1, 0.5L, near, &wanted);
      ck_rel(found.bending, (double)wanted.bending, 1e-11 + 1e-15 / near);
      ck_rel(found.varying, (double)wanted.varying, 1e-11 + 1e-15 / near);
    }
  }
}

/* Nothing is told of what is not a number. */
PH_TEST(test_not_numbers) {
  for (size_t i = 0; i < 6; i++) {
    ph_cplx w[3] = {{1, 0.1}, {1, 0.2}, {1, 0.3}};
    struct ph_seg2 seg;
    *(i % 2 ? &w[i / 2].re : &w[i / 2].im) = (double)NAN;
    seg = unit_seg2(0, w);
    ck_assert(ph_seg2_stands_still(&seg, NULL));
  }
}
