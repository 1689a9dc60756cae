/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Spans of curvature-continuous splines (see g2.h).
 *
 * With d = (a + b)/2, p = (b - a)/2 and P = sin a sin b, the preimage of the
 * cubic has |w1/w0|^2 = (sin a / sin b) e^(-2q), where sinh q = sin p / (2
 * sqrt P), and 3 chord / (|w0| |w1|) = sin d W / P, where W = cos p sin d +
 * cos d S and S^2 = sin^2 p + 4 P: the root of the quadratic of [BYR11, (4.5)]
 * by the angles.  For obtuse d the same number is P (1 - 4 cos^2 d) / (cos p
 * sin d - cos d S), which does not cancel.
 */
#include "solve/tc/g2.h"

#include "kernel/pi.h"

#include <math.h>

/* What the formulas have in common. */
struct terms {
  double sin_a, cos_a, sin_b, cos_b, sin_d, cos_d, sin_p, cos_p;
  double product; /* P */
  double root;    /* S */
  double w;       /* W */
  double grow;    /* e^(2q) */
};

/* All from the half angles: four functions, and no difference of angles. */
static struct terms terms_of(double a, double b) {
  double s = sin(a / 2), c = cos(a / 2), u = sin(b / 2), v = cos(b / 2);
  struct terms t = {.sin_a = 2 * s * c,
                    .cos_a = 1 - 2 * s * s,
                    .sin_b = 2 * u * v,
                    .cos_b = 1 - 2 * u * u,
                    .sin_d = s * v + c * u,
                    .cos_d = c * v - s * u,
                    .sin_p = u * c - v * s,
                    .cos_p = c * v + s * u};
  double sum;
  t.product = t.sin_a * t.sin_b;
  t.root = sqrt(t.sin_p * t.sin_p + 4 * t.product);
  t.w = t.cos_d >= 0 ? t.cos_p * t.sin_d + t.cos_d * t.root
                     : t.product * (1 - 4 * t.cos_d * t.cos_d) /
                           (t.cos_p * t.sin_d - t.cos_d * t.root);
  sum = fabs(t.sin_p) + t.root;
  t.grow = sum * sum / (4 * t.product);
  t.grow = t.sin_p >= 0 ? t.grow : 1 / t.grow;
  return t;
}

bool ph_g2_arc(double a, double b, struct ph_g2_ends *e) {
  struct terms t;
  double base, cot_d, w_a, w_b, s_a, s_b, q_a, q_b, cot_a, cot_b;
  if (!(a > 0 && b > 0 && a < PH_PI && b < PH_PI && a + b < PH_G2_TURN_MAX)) {
    return false;
  }
  t = terms_of(a, b);
  base = 2. / 3 * t.sin_d * t.sin_d * t.w;
  e->f = log(base / (t.sin_b * t.sin_b * t.grow));
  e->g = log(base / (t.sin_a * t.sin_a) * t.grow);
  cot_a = t.cos_a / t.sin_a;
  cot_b = t.cos_b / t.sin_b;
  cot_d = t.cos_d / t.sin_d;
  s_a = (2 * t.cos_a * t.sin_b - t.sin_p * t.cos_p / 2) / t.root;
  s_b = (2 * t.sin_a * t.cos_b + t.sin_p * t.cos_p / 2) / t.root;
  q_a = -(t.cos_p + t.sin_p * cot_a) / (2 * t.root);
  q_b = (t.cos_p - t.sin_p * cot_b) / (2 * t.root);
  w_a = (t.sin_p * t.sin_d + t.cos_p * t.cos_d - t.sin_d * t.root) / 2 +
        t.cos_d * s_a;
  w_b = (t.cos_p * t.cos_d - t.sin_p * t.sin_d - t.sin_d * t.root) / 2 +
        t.cos_d * s_b;
  e->f_a = cot_d + w_a / t.w - 2 * q_a;
  e->f_b = cot_d + w_b / t.w - 2 * cot_b - 2 * q_b;
  e->g_a = cot_d + w_a / t.w - 2 * cot_a + 2 * q_a;
  e->g_b = cot_d + w_b / t.w + 2 * q_b;
  return isfinite(e->f) && isfinite(e->g);
}

struct ph_tc ph_g2_preimage(double a, double b) {
  struct terms t = terms_of(a, b);
  double both = 3 * t.product / (t.sin_d * t.w); /* |w0| |w1| */
  double ratio = sqrt(t.sin_a / (t.sin_b * t.grow));
  struct ph_tc tc = {{ph_cplx_scale(sqrt(both / ratio), ph_cplx_polar(-a / 2)),
                      ph_cplx_scale(sqrt(both * ratio), ph_cplx_polar(b / 2))}};
  return tc;
}

/* ---- bends --------------------------------------------------------------- */

/* A number and its derivatives by a and b. */
struct dual {
  double x, a, b;
};

/* What a bend consists of.
 *
 *   u = (2a + b)/(3(a + b)), v = (a - b)/3       joint (u, -u (1-u) v)
 *   left = atan((1-u) v), right = atan(u v)      of both chords to the one
 *   first = a - left, last = b + right
 *   X = tanh((first + last)/4 + 0.2 first last / (first + last))
 *   inner angles  X + (left + right)/2,  X - (left + right)/2
 */
struct bend {
  struct dual u, left, right, first, last, before, after;
};

static struct dual arctan(struct dual z) {
  double d = 1 / (1 + z.x * z.x);
  struct dual r = {atan(z.x), z.a * d, z.b * d};
  return r;
}

/* How much the tangent at the joint turns. */
static struct dual inner_turn(struct dual p, struct dual q) {
  double sum = p.x + q.x, d;
  double p_part = q.x / sum, q_part = p.x / sum;
  struct dual r = {.x = tanh(sum / 4 + 0.2 * p.x * p_part)};
  d = 1 - r.x * r.x;
  p_part = d * (0.25 + 0.2 * p_part * p_part);
  q_part = d * (0.25 + 0.2 * q_part * q_part);
  r.a = p_part * p.a + q_part * q.a;
  r.b = p_part * p.b + q_part * q.b;
  return r;
}

static struct bend bend_of(double a, double b) {
  const double sum = a + b, third = 1 / (3 * sum), v = (a - b) / 3;
  struct bend s = {
      .u = {(2 * a + b) * third, b * third / sum, -a * third / sum}};
  struct dual rest = {(1 - s.u.x) * v, (1 - s.u.x) / 3 - s.u.a * v,
                      -(1 - s.u.x) / 3 - s.u.b * v};
  struct dual part = {s.u.x * v, s.u.x / 3 + s.u.a * v, -s.u.x / 3 + s.u.b * v};
  struct dual turn, half;
  s.left = arctan(rest);
  s.right = arctan(part);
  s.first = (struct dual){a - s.left.x, 1 - s.left.a, -s.left.b};
  s.last = (struct dual){b + s.right.x, s.right.a, 1 + s.right.b};
  turn = inner_turn(s.first, s.last);
  half = (struct dual){(s.left.x + s.right.x) / 2, (s.left.a + s.right.a) / 2,
                       (s.left.b + s.right.b) / 2};
  s.before = (struct dual){turn.x + half.x, turn.a + half.a, turn.b + half.b};
  s.after = (struct dual){turn.x - half.x, turn.a - half.a, turn.b - half.b};
  return s;
}

struct ph_g2_bend ph_g2_bend_of(double a, double b) {
  struct bend s = bend_of(a, b);
  struct ph_g2_bend bend = {
      .joint = {s.u.x, -s.u.x * (1 - s.u.x) * (a - b) / 3},
      .a = {s.first.x, s.after.x},
      .b = {s.before.x, s.last.x}};
  return bend;
}

bool ph_g2_bend_ends(double a, double b, struct ph_g2_ends *e) {
  struct ph_g2_ends one, two;
  struct bend s;
  double left, right;
  if (!(a + b > 0)) {
    return false;
  }
  s = bend_of(a, b);
  if (!(s.u.x > 0 && s.u.x < 1) || !ph_g2_arc(s.first.x, s.before.x, &one) ||
      !ph_g2_arc(s.after.x, s.last.x, &two)) {
    return false;
  }
  left = tan(s.left.x);
  right = tan(s.right.x);
  /* the chords are u / cos(left) and (1 - u) / cos(right) */
  e->f = one.f - log(s.u.x / cos(s.left.x));
  e->f_a = one.f_a * s.first.a + one.f_b * s.before.a - s.u.a / s.u.x -
           left * s.left.a;
  e->f_b = one.f_a * s.first.b + one.f_b * s.before.b - s.u.b / s.u.x -
           left * s.left.b;
  e->g = two.g - log((1 - s.u.x) / cos(s.right.x));
  e->g_a = two.g_a * s.after.a + two.g_b * s.last.a + s.u.a / (1 - s.u.x) -
           right * s.right.a;
  e->g_b = two.g_a * s.after.b + two.g_b * s.last.b + s.u.b / (1 - s.u.x) -
           right * s.right.b;
  return true;
}
