/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A segment of a spherical spline (see sphere_segment.h).
 *
 * At an end P with the next control points B and C, a = Log_P B of length th,
 * and W = Log_B C moved in parallel along the great circle from B to P,
 *
 *   W~ = W - (W.P) / (1 + P.B) (P + B),
 *
 * the velocity is 3 a and the covariant acceleration is
 *
 *   A = 6 (W~ - a + (th / sin th - 1) (W~ - the part of it along a)),      (1)
 *
 * because what is normal to the great circle grows as a Jacobi field does.  No
 * direction of a is needed where a is short: with long tensions it has few
 * digits.  The geodesic curvature is P . (a x A) / (9 th^3), which is
 * (2/3) (W.N) / (th sin th) with N normal to P and B.
 */
#include "check/sphere_segment.h"

#include "check/error.h"
#include "check/spherical.h"

#include <string.h>

/* Margins of the errors, over what was met with random control points. */
static const double ROUND_LEG = 4;
static const double ROUND_FIRST = 16, ROUND_SECOND = 64;

/* ---- the ends -------------------------------------------------------- */

/* A velocity at B, moved in parallel to P. */
static ph_vec3 transported(ph_vec3 w, ph_vec3 b, ph_vec3 p) {
  double factor = ph_vec3_dot(w, p) / (1 + ph_vec3_dot(p, b));
  return ph_vec3_along(w, -factor, ph_vec3_add(p, b));
}

/* The end P with b = B, the velocity w = Log_B C, both by the squares of their
 * angles. */
static void set_end(ph_vec3 p, ph_vec3 b, double xb, ph_vec3 w, double xw,
                    double rounding, struct ph_check_nu_end *e) {
  double growth = 1 / ph_s2_f0(xb), aa, size = sqrt(xw), w_error;
  ph_vec3 d = ph_vec3_sub(b, p), moved = transported(w, b, p), normal;
  e->at = p;
  e->leg = ph_vec3_scale(growth, ph_vec3_along(d, ph_vec3_dot(d, d) / 2, p));
  e->angle = sqrt(xb);
  aa = ph_vec3_dot(e->leg, e->leg);
  normal = aa > 0
               ? ph_vec3_along(moved, -ph_vec3_dot(moved, e->leg) / aa, e->leg)
               : moved;
  e->acceleration = ph_vec3_scale(
      6, ph_vec3_along(ph_vec3_sub(moved, e->leg), growth - 1, normal));
  e->curvature = ph_vec3_triple(p, e->leg, e->acceleration) /
                 (9 * e->angle * e->angle * e->angle);
  e->leg_error = ROUND_LEG * rounding * growth;
  w_error = ROUND_LEG * rounding * (1 / ph_s2_f0(xw) + size);
  e->acceleration_error = 6 * growth * (w_error + e->leg_error);
  e->curvature_error = growth * (w_error + 2 * size * e->leg_error / e->angle) /
                       (e->angle * e->angle);
}

void ph_check_nu_segment_of(const ph_vec3 p[4], double rounding,
                            struct ph_check_nu_segment *s) {
  ph_vec3 d = ph_vec3_sub(p[2], p[1]), w[2];
  double growth;
  memcpy(s->p, p, sizeof s->p);
  s->rounding = rounding;
  s->angle = ph_s2_angle(p[0], p[3]);
  ph_check_great_angles(p, s->x);
  growth = 1 / ph_s2_f0(s->x[1]);
  w[0] = ph_vec3_scale(growth, ph_vec3_along(d, ph_vec3_dot(d, d) / 2, p[1]));
  w[1] = ph_vec3_scale(-growth, ph_vec3_along(d, -ph_vec3_dot(d, d) / 2, p[2]));
  set_end(p[0], p[1], s->x[0], w[0], s->x[1], rounding, &s->end[0]);
  set_end(p[3], p[2], s->x[2], w[1], s->x[1], rounding, &s->end[1]);
}

double ph_check_nu_numerator_end(const struct ph_check_nu_segment *s,
                                 size_t end, double *error) {
  const struct ph_check_nu_end *e = &s->end[end];
  *error = 3 * (e->angle * e->acceleration_error +
                ph_vec3_abs(e->acceleration) * e->leg_error);
  return (end == 0 ? 3 : -3) * ph_vec3_triple(e->at, e->leg, e->acceleration);
}

/* ---- between the ends ------------------------------------------------ */

/* K at t, and what rounding can make of it. */
static double numerator(const struct ph_check_nu_segment *s, double t,
                        double *error) {
  ph_vec3 jet[3];
  double growth = ph_check_great(s->p, s->x, t, jet);
  *error =
      s->rounding * growth *
      (ROUND_SECOND * ph_vec3_abs(jet[1]) + ROUND_FIRST * ph_vec3_abs(jet[2]));
  return ph_vec3_triple(jet[0], jet[1], jet[2]);
}

/* ---- the sign of K --------------------------------------------------- */

/* K is nearly quadratic on a short segment, as it is in the plane.  One with
 * longer legs is looked at in PARTS from the beginning; a part is halved, at
 * most to 1/256, unless the quadratic through its ends and its middle stays
 * away from 0. */
static const double SHORT = 0.5;
enum { PARTS = 4, HALVINGS = 6, STACK = PARTS + HALVINGS + 1 };

/* q K at both ends of a part. */
struct part {
  double from, to, at_from, at_to;
  int halvings;
};

static size_t first_parts(const struct ph_check_nu_segment *s, int q,
                          struct part stack[STACK], int *fine) {
  double error[2], k[2];
  size_t n;
  for (size_t i = 0; i < 2; i++) {
    k[i] = q * ph_check_nu_numerator_end(s, i, &error[i]);
    *fine = *fine && k[i] >= -error[i];
  }
  n = sqrt(s->x[0]) + sqrt(s->x[1]) + sqrt(s->x[2]) <= SHORT ? 1 : PARTS;
  for (size_t i = 0; i < n; i++) {
    double to = (double)(i + 1) / (double)n, at_to = k[1];
    if (i + 1 < n) {
      at_to = q * numerator(s, to, &error[0]);
      *fine = *fine && at_to >= -error[0];
    }
    stack[i] = (struct part){(double)i / (double)n, to,
                             i > 0 ? stack[i - 1].at_to : k[0], at_to, 0};
  }
  return n;
}

int ph_check_nu_turns(const struct ph_check_nu_segment *s, int q) {
  struct part stack[STACK];
  int fine = 1;
  size_t n = first_parts(s, q, stack, &fine);
  while (n > 0 && fine) {
    struct part a = stack[--n], b;
    double error, middle = (a.from + a.to) / 2;
    double k = q * numerator(s, middle, &error);
    double least = ph_check_smaller(k, ph_check_smaller(a.at_from, a.at_to));
    fine = k >= -error;
    if (!(least > fabs(a.at_from - 2 * k + a.at_to)) && a.halvings < HALVINGS) {
      b = a;
      a.to = b.from = middle;
      a.at_to = b.at_from = k;
      a.halvings = ++b.halvings;
      stack[n++] = a;
      stack[n++] = b;
    }
  }
  return fine;
}

/* ---- the length ------------------------------------------------------ */

/* Points of an interval, equally spaced; an interval is 2^-DEPTH of the segment
 * at least, and there are INTERVALS at most: a segment of which both ends are
 * at rest takes 80. */
enum { POINTS = 17, ROWS = 5, DEPTH = 40, INTERVALS = 2000 };

/* An interval is done when the extrapolations of 8 and of 16 distances agree to
 * this, relative to what is claimed: the latter is nearer to the truth by far,
 * but near a cusp it is not safe to say by how much. */
static const double ENOUGH = 1e-13;

/* Where an extrapolation agrees with the claim, its last step was at most
 * this. */
static const double NEAR = 1e-5;

/* Where it agrees with the one before, the step before was at most this many
 * times as large: two alone may agree by chance. */
static const double CALM = 1000;

/* The widest interval at an end, in units of the r below. */
static const double COARSE = 4;

/* In units of the rounding of a point; the sum of distances that is made of it,
 * where halves would tell no more. */
static const double ROUND_SUM = 4, NO_LENGTH = 8;

struct interval {
  ph_vec3 s[POINTS];
  double from, to;
};

static ph_vec3 point_at(const struct ph_check_nu_segment *s, double t) {
  ph_vec3 z[3];
  for (size_t i = 0; i < 3; i++) {
    z[i] = ph_s2_between(s->p[i], s->p[i + 1], s->x[i], t);
  }
  z[0] = ph_s2_slerp(z[0], z[1], t);
  z[1] = ph_s2_slerp(z[1], z[2], t);
  return ph_s2_slerp(z[0], z[1], t);
}

static ph_vec3 between(ph_vec3 p, ph_vec3 q) {
  return ph_vec3_unit(ph_vec3_add(p, q));
}

/* The point at j/4 of a great circle, by halves: no angle is needed. */
static ph_vec3 quarter(ph_vec3 p, ph_vec3 q, size_t j) {
  ph_vec3 half = between(p, q);
  return j == 1 ? between(p, half) : j == 3 ? between(half, q) : half;
}

/* The first five points, which are all on a short segment. */
static void first_points(const struct ph_check_nu_segment *s,
                         struct interval *v) {
  v->from = 0;
  v->to = 1;
  v->s[0] = s->p[0];
  v->s[POINTS - 1] = s->p[3];
  for (size_t j = 1; j < 4; j++) {
    ph_vec3 z[3];
    for (size_t i = 0; i < 3; i++) {
      z[i] = quarter(s->p[i], s->p[i + 1], j);
    }
    z[0] = quarter(z[0], z[1], j);
    z[1] = quarter(z[1], z[2], j);
    v->s[(POINTS - 1) / 4 * j] = quarter(z[0], z[1], j);
  }
}

/* The points between those that there are, every second `step'. */
static void more_points(const struct ph_check_nu_segment *s, struct interval *v,
                        size_t step) {
  for (size_t i = step; i < POINTS; i += 2 * step) {
    double u = (double)i / (POINTS - 1);
    v->s[i] = point_at(s, v->from + (v->to - v->from) * u);
  }
}

static double distance(ph_vec3 a, ph_vec3 b) {
  ph_vec3 d = ph_vec3_sub(a, b);
  double square = ph_vec3_dot(d, d);
  return square < 0x1p-12 ? sqrt(ph_s2_near_square(square))
         : square <= 2    ? 2 * asin(sqrt(square) / 2)
                          : ph_s2_angle(a, b);
}

/* The sum of distances from each point to the next. */
static double sum_of(const struct interval *v, size_t step) {
  double sum = 0;
  for (size_t i = 0; i + step < POINTS; i += step) {
    sum += distance(v->s[i], v->s[i + step]);
  }
  return sum;
}

/* One more row of Romberg's table, after rows of 1, 2, ..., 2^(k-1) distances:
 * the extrapolation from all. */
static double extrapolate(double table[ROWS], size_t k, double sum) {
  double power = 1, next;
  for (size_t i = 0; i < k; i++) {
    power *= 4;
    next = sum + (sum - table[i]) / (power - 1);
    table[i] = sum;
    sum = next;
  }
  table[k] = sum;
  return sum;
}

/* The halves of an interval with all its points. */
static void halve(const struct interval *v, struct interval *a,
                  struct interval *b) {
  struct interval whole = *v;
  a->from = whole.from;
  a->to = b->from = (whole.from + whole.to) / 2;
  b->to = whole.to;
  for (size_t i = 0; i < POINTS; i += 2) {
    a->s[i] = whole.s[i / 2];
    b->s[i] = whole.s[(POINTS - 1 + i) / 2];
  }
}

/* Whether an interval is narrow enough for its points to show what the curve
 * does.  Where the first leg is short, r of the middle one, the curve turns
 * within t = r and may turn back, on a length of about r^2: no point farther
 * away would tell. */
static int is_narrow(const struct ph_check_nu_segment *s,
                     const struct interval *v) {
  double width = v->to - v->from, r[2];
  for (size_t end = 0; end < 2; end++) {
    r[end] = s->end[end].angle / sqrt(s->x[1]);
    if (!(r[end] * r[end] > ENOUGH)) {
      r[end] = 1;
    }
  }
  return (v->from > 0 || !(width > COARSE * r[0])) &&
         (v->to < 1 || !(width > COARSE * r[1]));
}

/* Whether a curve through these equally spaced points, near the first one,
 * leaves it in the direction of the second.  If not, it turns back in between,
 * and on a great circle all sums of distances may agree for all that.  The
 * second distance is 3 times the first where the curve turns at the first
 * point, about: less as it is slower later on. */
static int goes_on(ph_vec3 a, ph_vec3 b, ph_vec3 c) {
  ph_vec3 first = ph_vec3_sub(b, a), second = ph_vec3_sub(c, b);
  return !(2 * ph_vec3_dot(first, first) <= ph_vec3_dot(first, second));
}

/* Whether the curve does not turn back at a point, as it would next to it, nor
 * is any distance so much shorter than those beside it that the curve may turn
 * back within and on again: where it rests for a moment between points, at a
 * speed of t^2, the squares of these are 50 times that of the shorter one at
 * least. */
static int keeps_on(const struct interval *v, size_t step) {
  ph_vec3 last = {0, 0, 0};
  double before = 0, here = HUGE_VAL;
  int on = 1;
  for (size_t i = 0; i + step < POINTS; i += step) {
    ph_vec3 d = ph_vec3_sub(v->s[i + step], v->s[i]);
    double next = ph_vec3_dot(d, d);
    on = on && !(18 * here <= before + next) && !(ph_vec3_dot(last, d) < 0);
    before = i > 0 ? here : 0;
    here = next;
    last = d;
  }
  return on;
}

/* Whether the points of an interval, or every step-th one, can be trusted. */
static int is_fine(const struct ph_check_nu_segment *s,
                   const struct interval *v, size_t step) {
  const ph_vec3 *last = v->s + POINTS - 1;
  return is_narrow(s, v) && keeps_on(v, step) &&
         goes_on(v->s[0], v->s[step], v->s[2 * step]) &&
         goes_on(*last, *(last - step), *(last - 2 * step));
}

/*
 * The length of an interval of which the first `rows' rows of points are there.
 *
 * out  done  whether it is good enough, or agrees with the claim of the whole
 */
static double extrapolated(const struct ph_check_nu_segment *s,
                           struct interval *v, size_t rows, double claimed,
                           double allowed, int *done) {
  double enough = ENOUGH * claimed + ROUND_SUM * s->rounding;
  double table[ROWS], length = 0, step = 0, before = 0, sum = 0;
  int whole = v->to - v->from >= 1;
  *done = 0;
  for (size_t k = 0; k < ROWS && !*done; k++) {
    size_t stride = (size_t)(POINTS - 1) >> k;
    double last = length;
    if (k >= rows) {
      more_points(s, v, stride);
    }
    sum = sum_of(v, stride);
    length = extrapolate(table, k, sum);
    before = step;
    step = fabs(length - last);
    *done = whole && k > 1 && fabs(length - claimed) <= allowed &&
            step <= NEAR * claimed && is_fine(s, v, stride);
  }
  *done = *done || sum <= enough / 4 || sum <= NO_LENGTH * s->rounding ||
          (!(step > enough) && !(before > CALM * enough) && is_fine(s, v, 1));
  return length;
}

double ph_check_nu_length(const struct ph_check_nu_segment *s, double claimed,
                          double allowed) {
  struct interval stack[DEPTH + 1];
  double length = 0;
  size_t n = 1, rows = 3;
  first_points(s, &stack[0]);
  for (size_t seen = 0; n > 0; seen++) {
    int done;
    double part = extrapolated(s, &stack[--n], rows, claimed, allowed, &done);
    rows = ROWS - 1;
    if (done || n + 2 > DEPTH || seen > INTERVALS) {
      length += part;
    } else {
      halve(&stack[n], &stack[n], &stack[n + 1]);
      n += 2;
    }
  }
  return length;
}

double ph_check_nu_allowed(const struct ph_check_nu_segment *s,
                           double claimed) {
  /* the sum of up to 80 intervals, each as rounded as a point */
  static const double relative = 1e-11, roundings = 96;
  return relative * claimed + roundings * s->rounding;
}
