/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The arc length of a spherical Bezier segment (see spherical.h).
 *
 * The speed |S'| is nearly singular where control points nearly coincide, but
 * its square g is not: it is nearly a polynomial, of degree 4 up to terms of
 * the order of the square of the segment's angle.  So g is interpolated at 13
 * nodes, on parts of the segment if need be, and the root of the interpolant is
 * integrated adaptively, which costs no points of the curve.  What converges is
 * seen from Legendre coefficients.
 */
#include "curve/spherical_net.h"

#include <stdbool.h>

/* A Gauss rule on [-1, 1]: its nodes >= 0, and weights with sum 1. */
enum { NODES = 13, HALF = 7 };
struct rule {
  size_t n;
  double node[HALF];
  double weight[HALF];
};

static const struct rule coarse = {
    5,
    {0.0, 0.53846931010568309104, 0.9061798459386639928},
    {0.28444444444444444444, 0.23931433524968323402, 0.11846344252809454376}};

static const struct rule fine = {
    NODES,
    {0.0, 0.23045831595513479407, 0.44849275103644685288,
     0.64234933944034022064, 0.80157809073330991279, 0.91759839922297796521,
     0.98418305471858814947},
    {0.1162757766154369551, 0.11314159013144861921, 0.10390802376844425116,
     0.08907299038097286914, 0.069436755109893619232, 0.046060749918864223957,
     0.02024200238265793976}};

/* k / (k + 1), of the recurrence
 *   P_{k+1} = x P_k + k / (k + 1) (x P_k - P_{k-1}). */
static const double ratio[NODES + 1] = {
    0,       1.0 / 2, 2.0 / 3,  3.0 / 4,   4.0 / 5,   5.0 / 6,   6.0 / 7,
    7.0 / 8, 8.0 / 9, 9.0 / 10, 10.0 / 11, 11.0 / 12, 12.0 / 13, 13.0 / 14};

/* Where the speed comes from: a segment, or, where net is NULL, n Legendre
 * coefficients of its square on [middle - half, middle + half]. */
struct source {
  const struct ph_spherical_net *net;
  size_t n;
  double g[NODES];
  double middle, half;
};

static double speed(const struct source *source, double t) {
  double x, p = 1, q, g = 0;
  if (source->net) {
    return ph_spherical_net_speed(source->net, t);
  }
  q = x = (t - source->middle) / source->half;
  for (size_t k = 0; k < source->n; k++) {
    double next = x * q + ratio[k + 1] * (x * q - p);
    g += source->g[k] * p;
    p = q;
    q = next;
  }
  return g <= 0 ? 0 : sqrt(g);
}

/* Speeds at the nodes of a rule on [a, a + width]: r to the right of the middle
 * and l to the left; the middle itself counts as right. */
static void sample(const struct source *source, const struct rule *rule,
                   double a, double width, double *r, double *l) {
  double half = width / 2;
  for (size_t i = 0; i < (rule->n + 1) / 2; i++) {
    double x = half * rule->node[i];
    r[i] = speed(source, a + half + x);
    l[i] = i > 0 ? speed(source, a + half - x) : 0;
  }
}

/* The Legendre coefficients of a function, as a rule has them, from its values
 * at the nodes. */
static void project(const struct rule *rule, const double *r, const double *l,
                    double c[NODES]) {
  for (size_t k = 0; k < rule->n; k++) {
    c[k] = 0;
  }
  for (size_t i = 0; i < (rule->n + 1) / 2; i++) {
    double x = rule->node[i], p = 1, q = x; /* P_k(x), P_{k+1}(x) */
    double even = rule->weight[i] * (r[i] + l[i]);
    double odd = rule->weight[i] * (r[i] - l[i]);
    for (size_t k = 0; k < rule->n; k++) {
      double next = x * q + ratio[k + 1] * (x * q - p);
      c[k] += (double)(2 * k + 1) * p * (k % 2 == 0 ? even : odd);
      p = q;
      q = next;
    }
  }
}

static double largest(const double c[4]) {
  return fmax(fmax(fabs(c[0]), fabs(c[1])), fmax(fabs(c[2]), fabs(c[3])));
}

/* The mean by 13 nodes, and the greatest of the last four coefficients. */
static double mean(const double r[HALF], const double l[HALF], double *last) {
  /* of coefficients 9 to 12, by nodes */
  static const double row[HALF][4] = {
      {0, -0.60090957993055895154, 0, 0.65575450190834806219},
      {0.45164862615846419554, 0.45447487281537307582, -0.27803296876289690034,
       -0.62944432598732976004},
      {-0.51793879297386034982, -0.099925996619652646047,
       0.47627413007079880773, 0.55405767405932377834},
      {0.1735345667179657736, -0.26103383705326386787, -0.54156405377957005691,
       -0.43987771317686819643},
      {0.239040836283967845, 0.43468497312272458509, 0.46548442184557562754,
       0.30297913614688563855},
      {-0.35693283447076656585, -0.35511986573935663408,
       -0.28854134333967968427, -0.16406230622896526186},
      {0.15510010835170129707, 0.12737464343945496286, 0.091431962098649541868,
       0.048470284232779770355}};
  double c[4] = {0, 0, 0, 0}, sum = 0;
  for (size_t i = 0; i < HALF; i++) {
    double even = r[i] + l[i], odd = r[i] - l[i];
    sum += fine.weight[i] * even;
    c[0] += row[i][0] * odd;
    c[1] += row[i][1] * even;
    c[2] += row[i][2] * odd;
    c[3] += row[i][3] * even;
  }
  *last = largest(c);
  return sum;
}

/* Whether 5 nodes suffice for a segment: the coefficients fall so fast that the
 * tenth, which is the error, does not matter. */
static bool gentle(const struct ph_spherical_net *net, const double f[NODES]) {
  static const double fall = 0.04;
  double bound = f[0];
  bool small = net->e <= 1e-3;
  for (size_t k = 1; k < coarse.n; k++) {
    bound *= fall;
    small = small && fabs(f[k]) <= bound;
  }
  return small;
}

/* Whether g is known to rounding: the rest is estimated by the last two
 * coefficients and by half of how those from 5 on fall in four. */
static bool smooth(const double g[NODES]) {
  double middle = largest(g + 5), high = largest(g + 9);
  double rest = fmax(fabs(g[11]), fabs(g[12]));
  if (high < middle) {
    rest *= sqrt(high / middle);
  }
  return rest <= 1e-14 * g[0];
}

/* How many coefficients matter. */
static size_t significant(const double g[NODES]) {
  size_t n = NODES;
  while (n > 1 && fabs(g[n - 1]) <= 1e-15 * g[0]) {
    n--;
  }
  return n;
}

/* Goes on to the next part of an interval that is halved: part number at of
 * 2^depth is done, or must be halved.  False when all are done. */
static bool next_part(bool done, size_t *at, size_t *depth) {
  if (!done) {
    ++*depth;
    *at *= 2;
    return true;
  }
  for (++*at; *at % 2 == 0 && *depth > 0; --*depth) {
    *at /= 2;
  }
  return *depth > 0;
}

/* The interpolant of the square of the speed, from values of the speed; false
 * where it is none. */
static bool square_of(double r[HALF], double l[HALF], double a, double width,
                      struct source *square) {
  for (size_t i = 0; i < HALF; i++) {
    r[i] *= r[i];
    l[i] *= l[i];
  }
  project(&fine, r, l, square->g);
  square->net = NULL;
  square->n = significant(square->g);
  square->half = width / 2;
  square->middle = a + square->half;
  return smooth(square->g);
}

/* The integral of the speed over [from, from + all], to a tolerance; NaN where
 * halving does not help.  The last coefficients bound the error, generously:
 * they do not fall for ever where there are two scales.  Of a segment, parts
 * where only the square of the speed is smooth are done by a second call. */
static double integral(const struct source *source, double from, double all,
                       double tolerance) {
  enum { HALVINGS = 50, PARTS = 2000 }; /* and parts that are tried, at most */
  /* a polynomial is here because its root did not converge on the whole */
  size_t at = 0, depth = source->net ? 0 : 1;
  double sum = 0;
  for (size_t parts = 0; parts < PARTS && depth <= HALVINGS; parts++) {
    double width = ldexp(all, -(int)depth), a = from + (double)at * width;
    double r[HALF], l[HALF], last, value;
    bool done;
    sample(source, &fine, a, width, r, l);
    value = width * mean(r, l, &last);
    done = width * last <= tolerance;
    if (!done && source->net) {
      struct source square;
      done = square_of(r, l, a, width, &square);
      value = done ? integral(&square, a, width, tolerance) : 0;
    }
    sum += done ? value : 0;
    if (!next_part(done, &at, &depth)) {
      return sum;
    }
  }
  return (double)NAN;
}

double ph_spherical_length(const struct ph_spherical *s, double to) {
  static const double precision = 1e-13;
  struct ph_spherical_net net;
  struct source source = {.net = &net};
  double r[HALF], l[HALF], f[NODES];
  ph_spherical_net_of(s, &net);
  sample(&source, &coarse, 0, to, r, l);
  project(&coarse, r, l, f);
  return gentle(&net, f) ? to * f[0]
                         : integral(&source, 0, to, precision * f[0] * to);
}
