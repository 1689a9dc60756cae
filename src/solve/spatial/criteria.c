/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The criteria HC and BV (see spatial.h).
 *
 * In the frame of the data, with d of spatial.h, (3),
 *
 *   d(b) = (x + K cos b, y, z - K s sin b),  K = 2 k m > 0              (1)
 *
 * HC maximises m11 L(b) = |d| - K c cos b + const.  Where its derivative
 *
 *   (d.d') / |d| + K c sin b,
 *   d.d' = -K (x sin b + s z cos b + K c^2 sin b cos b)                 (2)
 *
 * vanishes, c^2 sin^2 b |d|^2 is the square of the bracket, and terms of degree
 * above 2 cancel:
 *
 *   (s z)^2 cos^2 b + (s^2 (x^2 - c^2 K^2) - c^2 (y^2 + z^2)) sin^2 b
 *     + 2 s z sin b (x cos b + K c^2) = 0                               (3)
 *
 * BV minimises m11 |A1 - Q/2| = |D - w Q| with Q = A0 + A2, w = m01 + m11/2.
 * With the projection P of Q on the plane of D, |P|^2 = (|Q|^2 + d.q/|d|) / 2,
 * the least distance for a given b is
 *
 *   G(b) = |d| + w^2 |Q|^2 - 2 w sqrt(H),  H = (|d| |Q|^2 + d.q) / 2    (4)
 *   q = Q i Q* = Di + Df + 2 m E(b),  |Q|^2 = |Di| + |Df| + 2 m c cos b
 *
 * (3) and (4) are tested by t_spatial_criteria.c.
 */
#include "solve/spatial/spatial.h"

#include "kernel/pi.h"

#include <stddef.h>

/* Two values nearer than this, relative to their terms, are the same. */
static const double TIE = 1e-14;

/* Newton's steps or bisections of a bracket: the latter reach rounding. */
enum { STEPS_MAX = 60 };

/* A function of b with two derivatives. */
struct jet {
  double value, first, second;
};

/* v0 + scale (cos b, 0, -s sin b), and its derivatives. */
static void ellipse(const struct ph_spatial_family *f, ph_vec3 v0, double scale,
                    ph_cplx b, ph_vec3 v[3]) {
  double x = scale * b.re, z = scale * f->s * b.im;
  v[0] = ph_vec3_of(v0.x + x, v0.y, v0.z - z);
  v[1] = ph_vec3_of(-scale * b.im, 0, -scale * f->s * b.re);
  v[2] = ph_vec3_of(-x, 0, z);
}

/* |d|; where d = 0 its derivatives are not finite. */
static struct jet size_of(const ph_vec3 d[3]) {
  struct jet size;
  size.value = ph_vec3_abs(d[0]);
  size.first = ph_vec3_dot(d[0], d[1]) / size.value;
  size.second = (ph_vec3_dot(d[1], d[1]) + ph_vec3_dot(d[0], d[2]) -
                 size.first * size.first) /
                size.value;
  return size;
}

/* ---- roots of a quartic --------------------------------------------- */

/* GSL finds all four roots as complex numbers in 0.9 us, and double ones to
 * half of their digits; what is needed are the real ones in [-1,1], and where
 * there might be one, in 0.25 us.  HC asks twice for each tension that is
 * tried. */

enum { DEGREE = 4 };

static double horner(const double *p, size_t degree, double t) {
  double sum = p[degree];
  for (size_t i = degree; i-- > 0;) {
    sum = sum * t + p[i];
  }
  return sum;
}

/* The root of p in [low,high], where it changes its sign; derivative = p'. */
static double root_between(const double *p, const double *derivative,
                           size_t degree, double low, double high) {
  bool rising = horner(p, degree, low) < 0;
  double t = 0.5 * (low + high);
  for (int i = 0; i < STEPS_MAX; i++) {
    double value = horner(p, degree, t);
    double step = -value / horner(derivative, degree - 1, t);
    if (fabs(step) < 1e-9) { /* the next one is below rounding */
      return t + step;
    }
    if ((value < 0) == rising) {
      low = t;
    } else {
      high = t;
    }
    t += step;
    if (!(t > low && t < high)) {
      t = 0.5 * (low + high);
    }
  }
  return t;
}

/*
 * The roots of p in [-1,1], with those of p' between them: where p has a double
 * root, or seems to have none by rounding, p' has one.
 *
 * Those of each derivative part [-1,1] into intervals where the one before it
 * is monotone.
 */
static size_t roots_of(const double p[DEGREE + 1], double roots[2 * DEGREE]) {
  double d[DEGREE + 1][DEGREE + 1]; /* d[n]: the derivative of degree n */
  double at[DEGREE + 1] = {-1, 1};
  size_t n = 1, kept = 0; /* intervals */
  for (size_t i = 0; i <= DEGREE; i++) {
    d[DEGREE][i] = p[i];
  }
  for (size_t m = DEGREE; m > 1; m--) {
    for (size_t i = 0; i < m; i++) {
      d[m - 1][i] = (double)(i + 1) * d[m][i + 1];
    }
  }
  d[0][0] = d[1][1];
  for (size_t m = 1; m <= DEGREE; m++) {
    double next[DEGREE + 2] = {-1};
    size_t found = 1;
    for (size_t i = 0; i < n; i++) {
      double left = horner(d[m], m, at[i]), right = horner(d[m], m, at[i + 1]);
      if ((left < 0) != (right < 0)) {
        next[found++] = root_between(d[m], d[m - 1], m, at[i], at[i + 1]);
      }
    }
    for (size_t i = 1; m >= DEGREE - 1 && i < found; i++) {
      roots[kept++] = next[i];
    }
    next[found] = 1;
    n = found;
    for (size_t i = 0; m < DEGREE && i <= n; i++) {
      at[i] = next[i];
    }
  }
  return kept;
}

/* ---- HC ------------------------------------------------------------- */

/* m11 L(b) but for a constant. */
static struct jet length_at(const struct ph_spatial_family *f, ph_cplx b) {
  double scale = 2 * f->k * f->m, around = scale * f->c;
  ph_vec3 d[3];
  struct jet length;
  ellipse(f, f->d0, scale, b, d);
  length = size_of(d);
  length.value -= around * b.re;
  length.first += around * b.im;
  length.second += around * b.re;
  return length;
}

/* (3) times (1 + t^2)^2, t = tan(b/2). */
static void quartic(const struct ph_spatial_family *f, double p[DEGREE + 1]) {
  double scale = 2 * f->k * f->m, c2 = f->c * f->c, s2 = f->s * f->s;
  ph_vec3 d0 = f->d0;
  double sz = f->s * d0.z;
  double sin2 = s2 * (d0.x * d0.x - c2 * scale * scale) -
                c2 * (d0.y * d0.y + d0.z * d0.z);
  p[0] = p[4] = sz * sz;
  p[1] = 4 * sz * (scale * c2 + d0.x);
  p[2] = 4 * sin2 - 2 * sz * sz;
  p[3] = 4 * sz * (scale * c2 - d0.x);
}

static void choose_longer(const struct ph_spatial_family *f, ph_cplx b,
                          double *length, ph_cplx *best) {
  double value = length_at(f, b).value;
  if (value > *length) {
    *length = value;
    *best = b;
  }
}

/* Newton's method for the maximum next to b.  What (3) has besides the
 * stationary points is far from a maximum, or so near to one that the lengths
 * are the same. */
static ph_cplx polish_longest(const struct ph_spatial_family *f, ph_cplx b) {
  double angle = atan2(b.im, b.re);
  for (int i = 0; i < 6; i++) {
    struct jet length = length_at(f, ph_cplx_polar(angle));
    double step = -length.first / length.second;
    if (!(length.second < 0) || !(fabs(step) < 0.1)) {
      break;
    }
    angle += step;
    if (fabs(step) < 1e-9) {
      break;
    }
  }
  return ph_cplx_polar(angle);
}

struct ph_spatial_member ph_spatial_hc(const struct ph_spatial_family *f) {
  struct ph_spatial_member member = {f->plane_b, {1, 0}};
  const ph_cplx opposite = ph_cplx_scale(-1, f->plane_b);
  double length = length_at(f, member.b).value, p[DEGREE + 1];
  double size = fabs(length) + 4 * f->k * f->m;
  if (f->planar) { /* (3) is sin^2 b = 0, or all lengths are the same */
    length += TIE * size;
    choose_longer(f, opposite, &length, &member.b);
    return member;
  }
  choose_longer(f, opposite, &length, &member.b);
  quartic(f, p);
  for (int chart = 0; chart < 2; chart++) {
    double roots[2 * DEGREE], swap;
    size_t n = roots_of(p, roots);
    for (size_t i = 0; i < n; i++) {
      double t = roots[i], per = 1 / (1 + t * t);
      double cosine = (1 - t) * (1 + t) * per;
      choose_longer(f, ph_cplx_of(chart ? -cosine : cosine, 2 * t * per),
                    &length, &member.b);
    }
    swap = p[1]; /* t -> 1/t */
    p[1] = p[3];
    p[3] = swap;
  }
  member.b = polish_longest(f, member.b);
  return member;
}

/* ---- BV ------------------------------------------------------------- */

enum { SAMPLES = 64 };

/* G of (4).  Not differentiable where d or H is 0: there it has no minimum, and
 * the derivatives are not finite. */
static struct jet gap_at(const struct ph_spatial_family *f, ph_cplx b) {
  double w = f->m01 + 0.5 * f->m11, h, h1, h2, root, q2, q2_1, q2_2;
  ph_vec3 d[3], q[3];
  struct jet size, gap;
  ellipse(f, f->d0, 2 * f->k * f->m, b, d);
  ellipse(f, f->sum, 2 * f->m, b, q);
  size = size_of(d);
  q2_2 = -2 * f->m * f->c * b.re;
  q2_1 = -2 * f->m * f->c * b.im;
  q2 = f->ni + f->nf - q2_2;
  h = 0.5 * (size.value * q2 + ph_vec3_dot(d[0], q[0]));
  h1 = 0.5 * (size.first * q2 + size.value * q2_1 + ph_vec3_dot(d[1], q[0]) +
              ph_vec3_dot(d[0], q[1]));
  h2 = 0.5 * (size.second * q2 + 2 * size.first * q2_1 + size.value * q2_2 +
              ph_vec3_dot(d[2], q[0]) + 2 * ph_vec3_dot(d[1], q[1]) +
              ph_vec3_dot(d[0], q[2]));
  root = sqrt(h > 0 ? h : 0);
  gap.value = size.value + w * w * q2 - 2 * w * root;
  gap.first = size.first + w * w * q2_1 - w * h1 / root;
  gap.second = size.second + w * w * q2_2 - w * (h2 - h1 * h1 / (2 * h)) / root;
  return gap;
}

/* The angle of a minimum between two angles where the derivative has different
 * signs, by Newton's method inside of the bracket. */
static double minimum_between(const struct ph_spatial_family *f, double low,
                              double high) {
  double angle = 0.5 * (low + high);
  for (int i = 0; i < STEPS_MAX; i++) {
    struct jet gap = gap_at(f, ph_cplx_polar(angle));
    double step = -gap.first / gap.second;
    if (gap.second > 0 && fabs(step) < 1e-9) {
      return angle + step;
    }
    if (gap.first > 0) {
      high = angle;
    } else {
      low = angle;
    }
    angle += step;
    if (!(gap.second > 0 && angle > low && angle < high)) {
      angle = 0.5 * (low + high);
    }
  }
  return angle;
}

static void choose_nearer(const struct ph_spatial_family *f, ph_cplx b,
                          double tolerance, double *least, ph_cplx *best) {
  double value = gap_at(f, b).value;
  if (value < *least - tolerance) {
    *least = value;
    *best = b;
  }
}

struct ph_spatial_member ph_spatial_bv(const struct ph_spatial_family *f) {
  struct ph_spatial_member member = {f->plane_b, {1, 0}};
  const double step = 2 * PH_PI / SAMPLES;
  const ph_cplx opposite = ph_cplx_scale(-1, f->plane_b),
                turn = ph_cplx_polar(step);
  double least = gap_at(f, member.b).value;
  double tie = TIE * f->m11 * (f->h + f->ni + f->nf), before;
  ph_cplx b = {-1, 0};
  choose_nearer(f, opposite, f->planar ? tie : 0, &least, &member.b);
  if (f->planar) {
    return member; /* all others leave the plane */
  }
  before = gap_at(f, b).first;
  for (int i = 1 - SAMPLES / 2; i <= SAMPLES / 2; i++) {
    double after = gap_at(f, b = ph_cplx_mul(b, turn)).first;
    if (before <= 0 && after > 0) {
      double angle = minimum_between(f, step * (i - 1), step * i);
      /* Near 0 and pi rounding would decide between these and the minimum. */
      choose_nearer(f, ph_cplx_polar(angle), -tie, &least, &member.b);
    }
    before = after;
  }
  return member;
}
