/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The arc length of a spherical Bezier segment (see spherical.h).
 *
 * The speed |S'| is nearly singular where control points nearly coincide, but
 * its square is not: it is nearly a polynomial, of degree 4 up to terms of the
 * order of the square of the segment's angle.  So the square is interpolated at
 * 13 nodes, on parts of the segment if need be, and the root of the interpolant
 * is integrated adaptively, which costs no points of the curve.
 */
#include "curve/segment/spherical_net.h"
#include "kernel/quad.h"

#include <float.h>
#include <stdbool.h>

/* Gauss rules on [0,1], symmetric: on gentle segments, and on parts of the
 * others. */
enum { COARSE = 5, FINE = 13 };
static const struct ph_quad coarse = {
    COARSE,
    {0.046910077030668003601, 0.23076534494715845448, 0.5,
     0.76923465505284154552, 0.9530899229693319964},
    {0.11846344252809454376, 0.23931433524968323402, 0.28444444444444444444,
     0.23931433524968323402, 0.11846344252809454376}};
static const struct ph_quad fine = {
    FINE,
    {0.0079084726407059252636, 0.041200800388511017397, 0.099210954633345043603,
     0.17882533027982988968, 0.27575362448177657356, 0.38477084202243260297,
     0.5, 0.61522915797756739703, 0.72424637551822342644,
     0.82117466972017011032, 0.9007890453666549564, 0.9587991996114889826,
     0.99209152735929407474},
    {0.02024200238265793976, 0.046060749918864223957, 0.069436755109893619232,
     0.08907299038097286914, 0.10390802376844425116, 0.11314159013144861921,
     0.1162757766154369551, 0.11314159013144861921, 0.10390802376844425116,
     0.08907299038097286914, 0.069436755109893619232, 0.046060749918864223957,
     0.02024200238265793976}};

/* k / (k + 1), of the recurrence of Legendre polynomials,
 *   P_{k+1} = x P_k + k / (k + 1) (x P_k - P_{k-1}). */
static const double ratio[FINE + 1] = {
    0,       1.0 / 2, 2.0 / 3,  3.0 / 4,   4.0 / 5,   5.0 / 6,   6.0 / 7,
    7.0 / 8, 8.0 / 9, 9.0 / 10, 10.0 / 11, 11.0 / 12, 12.0 / 13, 13.0 / 14};

/* The Legendre coefficients of a function, as a rule has them, from its values
 * at the nodes. */
static void project(const struct ph_quad *rule, const double *value,
                    double c[FINE]) {
  for (size_t k = 0; k < rule->n; k++) {
    c[k] = 0;
  }
  for (size_t i = 0, j = rule->n; i < j--; i++) { /* node i and its mirror j */
    double x = 2 * rule->node[j] - 1, p = 1, q = x; /* P_k(x), P_{k+1}(x) */
    double left = i < j ? rule->weight[i] * value[i] : 0;
    double right = rule->weight[j] * value[j];
    for (size_t k = 0; k < rule->n; k++) {
      double r = x * q + ratio[k + 1] * (x * q - p);
      c[k] +=
          (double)(2 * k + 1) * p * (k % 2 == 0 ? right + left : right - left);
      p = q;
      q = r;
    }
  }
}

/* A polynomial by n Legendre coefficients on [from, from + width]. */
struct series {
  size_t n;
  double c[FINE];
  double from, width;
};

static double series_at(const struct series *s, double t) {
  double x = 2 * (t - s->from) / s->width - 1, p = 1, q = x, sum = 0;
  for (size_t k = 0; k < s->n; k++) {
    double r = x * q + ratio[k + 1] * (x * q - p);
    sum += s->c[k] * p;
    p = q;
    q = r;
  }
  return sum;
}

static double root_at(const struct series *s, double t) {
  double square = series_at(s, t);
  return square <= 0 ? 0 : sqrt(square);
}

/*
 * Interpolates the square of the speed on an interval; whether it is known to
 * rounding, that of derivatives as large as control points are far apart, is
 * seen at the ends, which are no nodes, and where the interpolant is worst.
 * Coefficients that are rounding only are left out.
 */
static bool interpolate(const struct ph_spherical_net *net, struct series *s) {
  static const double precision = 1e-13, rounding = 1e-15;
  double value[FINE], error = 0;
  for (size_t i = 0; i < FINE; i++) {
    double speed =
        ph_spherical_net_speed(net, s->from + s->width * fine.node[i]);
    value[i] = speed * speed;
  }
  project(&fine, value, s->c);
  s->n = FINE;
  while (s->n > 1 && fabs(s->c[s->n - 1]) <= rounding * s->c[0]) {
    s->n--;
  }
  for (int end = 0; end <= 1; end++) {
    double t = s->from + end * s->width, speed = ph_spherical_net_speed(net, t);
    error += fabs(series_at(s, t) - speed * speed);
  }
  return error <=
         precision * s->c[0] + 256 * DBL_EPSILON * sqrt(net->e * s->c[0]);
}

/* ---- integrals ------------------------------------------------------------
 */

/* Halvings of an interval, and parts of it that are tried, at most. */
enum { HALVINGS = 50, PARTS = 2000 };

/* Part number at of an interval that was halved depth times. */
struct part {
  size_t at, depth;
};

/* Goes on from a part: to the first half of it, or, where it is done, to what
 * follows it.  False when all is done. */
static bool next(struct part *part, bool done) {
  if (!done) {
    part->depth++;
    part->at *= 2;
    return true;
  }
  for (part->at++; part->at % 2 == 0 && part->depth > 0; part->depth--) {
    part->at /= 2;
  }
  return part->depth > 0;
}

/* The mean of the root of a series on an interval, and how well a polynomial of
 * degree 12 is that root: its last four coefficients, and what it misses at the
 * ends, beyond the last nodes. */
static double mean(const struct series *s, double from, double width,
                   double *miss) {
  double value[FINE], c[FINE], left = 0, right = 0;
  for (size_t i = 0; i < FINE; i++) {
    value[i] = root_at(s, from + width * fine.node[i]);
  }
  project(&fine, value, c);
  for (size_t k = 0; k < FINE; k++) { /* P_k is 1 and (-1)^k there */
    right += c[k];
    left += k % 2 == 0 ? c[k] : -c[k];
  }
  *miss = fmax(fabs(left - root_at(s, from)),
               fabs(right - root_at(s, from + width)));
  for (size_t k = FINE - 4; k < FINE; k++) {
    *miss = fmax(*miss, fabs(c[k]));
  }
  return c[0];
}

/*
 * The integral of the root of a series.  What mean() misses bounds its error,
 * generously; halves do not tell it: next to a place where the speed is nearly
 * 0, the error of a rule is the same on an interval and on its half, until that
 * is as small as the place.
 */
static double root_integral(const struct series *s, double tolerance) {
  struct part part = {0, 0};
  double sum = 0;
  for (int n = 0; n < PARTS && part.depth <= HALVINGS; n++) {
    double width = ldexp(s->width, -(int)part.depth), miss;
    double value = mean(s, s->from + (double)part.at * width, width, &miss);
    bool done = width * miss <= tolerance;
    sum += done ? width * value : 0;
    if (!next(&part, done)) {
      return sum;
    }
  }
  return (double)NAN;
}

/* Whether 5 nodes suffice for a segment: the coefficients of the speed fall so
 * fast that the tenth, which is the error, does not matter. */
static bool gentle(const struct ph_spherical_net *net, const double c[FINE]) {
  static const double fall = 0.04;
  double bound = c[0];
  bool small = net->e <= 1e-3;
  for (size_t k = 1; k < COARSE; k++) {
    bound *= fall;
    small = small && fabs(c[k]) <= bound;
  }
  return small;
}

double ph_spherical_length(const struct ph_spherical *s, double to) {
  static const double precision = 1e-13;
  struct ph_spherical_net net;
  struct part part = {0, 0};
  double speed[COARSE], c[FINE], sum = 0;
  ph_spherical_net_of(s, &net);
  for (size_t i = 0; i < COARSE; i++) {
    speed[i] = ph_spherical_net_speed(&net, to * coarse.node[i]);
  }
  project(&coarse, speed, c);
  if (gentle(&net, c)) {
    return to * c[0];
  }
  for (int n = 0; n < PARTS && part.depth <= HALVINGS; n++) {
    struct series square = {.width = ldexp(to, -(int)part.depth)};
    bool done;
    square.from = (double)part.at * square.width;
    done = interpolate(&net, &square);
    sum += done ? root_integral(&square, precision * c[0] * to) : 0;
    if (!next(&part, done)) {
      return sum;
    }
  }
  return (double)NAN;
}
