/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Points that are hard in some way (see gate.h): families of steps from point
 * to point, then symmetry, planes in space, rounding to a few decimals, and
 * scale and place.
 */
#include "gate.h"

#include <float.h>

static const double PI = 3.14159265358979323846;

enum family {
  SMOOTH,   /* turns of at most 60 degrees */
  ANYWHERE, /* no order at all */
  WALK,     /* steps anywhere */
  LINE,     /* one after the other on a line */
  TO_AND_FRO,
  NEARLY, /* a line but for 1e-16 to 1e-2 */
  NEAR,   /* some points within 1e-15 to 1e-1 of the one before */
  MIXED,  /* steps of 1e-9 to 1 */
  SPIKES, /* back to where it came from, nearly */
  CIRCLE, /* a regular polygon, or part of it */
  TRACK,  /* small steps after large ones, 6 decimals, as from GPS */
  FAMILY_N
};

double gate_power(struct unit_random *r, double low, double high) {
  return pow(10, unit_random_in(r, low, high));
}

double gate_decimals(double x, int decimals) {
  double unit = pow(10, decimals);
  return round(x * unit) / unit;
}

static bool chance(struct unit_random *r, size_t n) {
  return unit_random_below(r, n) == 0;
}

static void anywhere(struct unit_random *r, size_t dimension, double *v) {
  for (size_t i = 0; i < dimension; i++) {
    v[i] = unit_random_in(r, -1, 1);
  }
}

static double size_of(const double *v, size_t dimension) {
  return sqrt(v[0] * v[0] + v[1] * v[1] + (dimension > 2 ? v[2] * v[2] : 0));
}

/* v to unit length; along x if it is 0. */
static void normalise(double *v, size_t dimension) {
  double size = size_of(v, dimension);
  for (size_t i = 0; i < dimension; i++) { /* it may be beyond all numbers */
    v[i] = size > 0 && isfinite(size) ? v[i] / size : i == 0;
  }
}

static void along(double *to, double a, const double *v, size_t dimension) {
  for (size_t i = 0; i < dimension; i++) {
    to[i] += a * v[i];
  }
}

static double step_size(struct unit_random *r, enum family family) {
  switch (family) {
  case NEAR:
    return chance(r, 3) ? gate_power(r, -15, -1) : unit_random_in(r, 0.5, 2);
  case MIXED:
    return gate_power(r, -9, 0);
  case TRACK:
    return chance(r, 3) ? gate_power(r, -6, -1) : 1;
  default:
    return unit_random_in(r, 0.5, 2);
  }
}

/* The direction of the next step, from that of the last. */
static void turn(struct unit_random *r, enum family family, size_t dimension,
                 double *direction) {
  double v[3];
  anywhere(r, dimension, v);
  switch (family) {
  case LINE:
    return;
  case TO_AND_FRO:
    along(direction, chance(r, 2) ? -2 : 0, direction, dimension);
    return;
  case NEARLY:
    along(direction, gate_power(r, -17, -2), v, dimension);
    break;
  case SMOOTH:
  case TRACK:
    normalise(v, dimension);
    along(direction, unit_random_in(r, 0, 0.8), v, dimension);
    break;
  case SPIKES:
    along(direction, chance(r, 2) ? -2 : 0, direction, dimension);
    along(direction, gate_power(r, -12, 0), v, dimension);
    break;
  default:
    memcpy(direction, v, sizeof v);
  }
  normalise(direction, dimension);
}

static void circle(struct unit_random *r, size_t n, size_t dimension,
                   double *v) {
  size_t of = n + unit_random_below(r, 4);
  double pitch = chance(r, 2) ? 0 : unit_random_in(r, -1, 1);
  for (size_t k = 0; k < n; k++) {
    double angle = 2 * PI * (double)k / (double)of;
    double *p = v + dimension * k;
    p[0] = cos(angle);
    p[1] = sin(angle);
    if (dimension > 2) {
      p[2] = pitch * angle;
    }
  }
}

static void steps(struct unit_random *r, enum family family, size_t n,
                  size_t dimension, double *v) {
  double direction[3];
  anywhere(r, dimension, direction);
  normalise(direction, dimension);
  memset(v, 0, dimension * sizeof *v);
  for (size_t k = 1; k < n; k++) {
    double *p = v + dimension * k;
    memcpy(p, p - dimension, dimension * sizeof *v);
    along(p, step_size(r, family), direction, dimension);
    turn(r, family, dimension, direction);
  }
}

/* The second half is the first one in a mirror. */
static void mirror(size_t n, size_t dimension, double *v) {
  double middle = v[dimension * (n / 2)];
  for (size_t k = n / 2; k < n; k++) {
    const double *from = v + dimension * (n - 1 - k);
    double *p = v + dimension * k;
    memcpy(p, from, dimension * sizeof *v);
    p[0] = n % 2 && k == n / 2 ? middle : 2 * middle - from[0];
  }
}

/* A plane in space: z = 0, or a constant, or tilted. */
static void flatten(struct unit_random *r, size_t n, double *v) {
  size_t how = unit_random_below(r, 3);
  double a = unit_random_in(r, -1, 1), b = unit_random_in(r, -1, 1);
  for (size_t k = 0; k < n; k++) {
    v[3 * k + 2] = how == 0   ? 0
                   : how == 1 ? a
                              : a * v[3 * k] + b * v[3 * k + 1];
  }
}

/* Other scales and places. */
void gate_place(struct unit_random *r, size_t n, size_t dimension, double *v) {
  size_t how = unit_random_below(r, 20);
  double scale = how < 12    ? 1
                 : how < 18  ? gate_power(r, -9, 9)
                 : how == 18 ? gate_power(r, -300, 300)
                             : ldexp(1, (int)unit_random_below(r, 40) - 20);
  double far[3] = {0, 0, 0};
  if (chance(r, 8)) {
    anywhere(r, 3, far);
    along(far, gate_power(r, 0, 9), far, 3);
  }
  for (size_t k = 0; k < n; k++) {
    for (size_t i = 0; i < dimension; i++) {
      const double x = scale * (v[dimension * k + i] + far[i]);
      v[dimension * k + i] = fmax(-DBL_MAX, fmin(x, DBL_MAX));
    }
  }
}

/* Seldom many, as time grows with them and most that goes wrong needs few. */
static size_t count(struct unit_random *r) {
  return chance(r, 100) ? 2 + unit_random_below(r, GATE_POINTS - 1)
         : chance(r, 4) ? 2 + unit_random_below(r, 3)
                        : 3 + unit_random_below(r, 4);
}

size_t gate_points(struct unit_random *r, size_t dimension, double *v) {
  enum family family = (enum family)unit_random_below(r, FAMILY_N);
  size_t n = count(r);
  int decimals = (int)unit_random_below(r, 7);
  bool rounded = family == TRACK || chance(r, 2);
  if (family == CIRCLE) {
    circle(r, n, dimension, v);
  } else if (family == ANYWHERE) {
    anywhere(r, n * dimension, v);
  } else {
    steps(r, family, n, dimension, v);
  }
  if (chance(r, 6)) {
    mirror(n, dimension, v);
  }
  if (dimension == 3 && chance(r, 4)) {
    flatten(r, n, v);
  }
  for (size_t i = 0; i < n * dimension && rounded; i++) {
    v[i] = gate_decimals(v[i], family == TRACK ? 6 : decimals);
  }
  if (!rounded || chance(r, 3)) {
    gate_place(r, n, dimension, v);
  }
  return n;
}

/* ---- spheres ----------------------------------------------------------- */

/* A step along the great circle in the direction of d, which is carried on. */
static void go(double *p, double *d, double angle) {
  double c = cos(angle), s = sin(angle);
  for (size_t i = 0; i < 3; i++) {
    double x = p[i];
    p[i] = c * x + s * d[i];
    d[i] = c * d[i] - s * x;
  }
  normalise(p, 3);
}

/* Turns d about p. */
static void steer(const double *p, double *d, double angle) {
  double side[3] = {p[1] * d[2] - p[2] * d[1], p[2] * d[0] - p[0] * d[2],
                    p[0] * d[1] - p[1] * d[0]};
  double c = cos(angle), s = sin(angle);
  for (size_t i = 0; i < 3; i++) {
    d[i] = c * d[i] + s * side[i];
  }
}

size_t gate_sphere_points(struct unit_random *r, double *v) {
  enum family family = (enum family)unit_random_below(r, FAMILY_N);
  size_t n = count(r);
  double p[3] = {1, 0, 0}, d[3] = {0, 1, 0};
  double step = chance(r, 3)   ? unit_random_in(r, 0.5, 3.1)
                : chance(r, 3) ? gate_power(r, -7, -1)
                               : unit_random_in(r, 0.05, 0.5);
  if (chance(r, 2)) {
    double angle = unit_random_in(r, -PI, PI);
    steer(p, d, unit_random_in(r, -PI, PI));
    go(p, d, angle);
    steer(p, d, unit_random_in(r, -PI, PI));
  }
  for (size_t k = 0; k < n; k++) {
    double size = step_size(r, family);
    memcpy(v + 3 * k, p, sizeof p);
    go(p, d, step * size);
    steer(p, d,
          family == LINE       ? 0
          : family == CIRCLE   ? 1
          : family == SMOOTH   ? unit_random_in(r, -0.5, 0.5)
          : family == NEARLY   ? gate_power(r, -16, -2)
          : family == SPIKES   ? PI - gate_power(r, -12, 0)
          : family == ANYWHERE ? unit_random_in(r, -PI, PI)
                               : unit_random_in(r, -1, 1));
  }
  return n;
}

/* ---- directions -----------------------------------------------------------
 */

void gate_directions(struct unit_random *r, const double *points, size_t n,
                     size_t dimension, double *v) {
  size_t how = unit_random_below(r, 5);
  for (size_t k = 0; k < n; k++) {
    double *d = v + dimension * k;
    size_t next = k + 1 < n ? k + 1 : k, last = k > 0 ? k - 1 : 0;
    double noise[3];
    anywhere(r, 3, noise);
    memset(d, 0, dimension * sizeof *d);
    if (how == 0) { /* anywhere */
      memcpy(d, noise, dimension * sizeof *d);
    } else if (how == 1) { /* along axes */
      d[unit_random_below(r, dimension)] = chance(r, 2) ? 1 : -1;
    } else { /* from the point before to the one after, more or less */
      along(d, 1, points + dimension * next, dimension);
      along(d, -1, points + dimension * last, dimension);
      normalise(d, dimension);
      along(d,
            how == 2   ? 0
            : how == 3 ? 0.3
                       : gate_power(r, -16, -2),
            noise, dimension);
    }
    normalise(d, dimension);
  }
}
