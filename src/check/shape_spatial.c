/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The shape of spatial segments (see shape_spatial.h).
 *
 * With x = S1 / S0, growing with u, the hodograph is S0^4 h(x), h(x) = sum h_j
 * x^j and h_j = leg_j / mu_j.  A factor common to all coordinates comes out of
 * their Wronskian as its cube, and x' is a positive constant / S0^2: up to a
 * positive factor
 *
 *   [r', r'', r'''] = S0^6 [h, h', h''] =
 *     sum over i < j < k of (j-i) (k-i) (k-j) [h_i, h_j, h_k]
 *                           S0^(9-i-j-k) S1^(i+j+k-3)                    (1)
 *
 * for PH quintics and ATPH segments alike.
 */
#include "check/shape_spatial.h"

#include "check/scale.h"

/* Errors of coordinates: in a leg, of the middle one, both of whose points are
 * sums of two terms; and in the chord, as far as nobody need see a direction in
 * them. */
enum { ROUND_LEG = 4, ROUND_CHORD = 32 };

/* Relative errors that are allowed for, more than the solver's: of the sine of
 * an angle, and of the volume of three directions. */
static const double NO_ANGLE = 4e-12;
static const double NO_VOLUME = 1e-12;

/* What S0^(4-j) S1^j is multiplied by for a coefficient of the size of r'. */
static const double BINOMIAL[] = {1, 4, 6, 4, 1};

/* Where the sign of (1) is looked at: in S1 / (S0 + S1), between the ends. */
enum { SAMPLES = 31 };

/* A vector, its length, and a bound of its error. */
struct vector {
  ph_vec3 v;
  double size, error;
};

/* The terms of (1). */
struct term {
  unsigned char i, j, k, degree;
  double factor;
};

static const struct term TERMS[10] = {
    {0, 1, 2, 0, 2},  {0, 1, 3, 1, 6}, {0, 1, 4, 2, 12}, {0, 2, 3, 2, 6},
    {0, 2, 4, 3, 16}, {1, 2, 3, 3, 2}, {0, 3, 4, 4, 12}, {1, 2, 4, 4, 6},
    {1, 3, 4, 5, 6},  {2, 3, 4, 6, 2}};

static struct vector vector_of(ph_vec3 v, double error) {
  struct vector result = {v, ph_vec3_abs(v), error};
  return result;
}

/* Bound of the error of a x b. */
static double cross_error(const struct vector *a, const struct vector *b) {
  return a->error * b->size + a->size * b->error + a->error * b->error;
}

static double triple_error(const struct vector *a, const struct vector *b,
                           const struct vector *c) {
  return cross_error(a, b) * (c->size + c->error) +
         a->size * b->size * c->error;
}

/* (a x b) . (a x c) > 0: at a, the legs a, b bend as a, c do. */
static bool is_convex(const struct vector *a, const struct vector *b,
                      const struct vector *c) {
  ph_vec3 bend = ph_vec3_cross(a->v, b->v), data = ph_vec3_cross(a->v, c->v);
  double bend_error = cross_error(a, b) + NO_ANGLE * a->size * b->size;
  double data_error = cross_error(a, c) + NO_ANGLE * a->size * c->size;
  double error = bend_error * (ph_vec3_abs(data) + data_error) +
                 ph_vec3_abs(bend) * data_error;
  return ph_vec3_dot(bend, data) >= -error;
}

/* sum f[m] (1-v)^(6-m) v^m. */
static double form_at(const double f[7], double v) {
  double sum = f[6], power = 1;
  for (size_t m = 6; m-- > 0;) {
    power *= 1 - v;
    sum = sum * v + f[m] * power;
  }
  return sum;
}

/* Whether (1) has the sign of the data everywhere, as far as one can tell. */
static bool winds_like(const struct vector h[5], double sign) {
  double f[7] = {0, 0, 0, 0, 0, 0, 0}, error[7] = {0, 0, 0, 0, 0, 0, 0};
  bool one_sign = true;
  for (size_t n = 0; n < 10; n++) {
    const struct term *t = &TERMS[n];
    const struct vector *a = &h[t->i], *b = &h[t->j], *c = &h[t->k];
    f[t->degree] += sign * t->factor * ph_vec3_triple(a->v, b->v, c->v);
    error[t->degree] += t->factor * triple_error(a, b, c);
  }
  for (size_t m = 0; m <= 6; m++) {
    one_sign = one_sign && f[m] >= -error[m];
  }
  if (one_sign) {
    return true;
  }
  for (int i = 0; i <= SAMPLES + 1; i++) {
    double v = (double)i / (SAMPLES + 1);
    if (!(form_at(f, v) >= -form_at(error, v))) {
      return false;
    }
  }
  return true;
}

enum ph_check_shape ph_check_shape_of(const ph_vec3 leg[5], const double mu[5],
                                      double relative, double rounding,
                                      double planarity) {
  struct vector h[5], chord;
  ph_vec3 dp = {0, 0, 0};
  double speed = 0, triple, error;
  for (size_t j = 0; j < 5; j++) {
    h[j] = vector_of(ph_vec3_scale(1 / mu[j], leg[j]), 0);
    dp = ph_vec3_add(dp, leg[j]);
    speed = ph_check_larger(speed, h[j].size / BINOMIAL[j]);
  }
  for (size_t j = 0; j < 5; j++) {
    h[j].error = BINOMIAL[j] * relative * speed + ROUND_LEG * rounding / mu[j];
  }
  chord = vector_of(dp, relative * speed + ROUND_CHORD * rounding);
  if (!is_convex(&h[0], &h[1], &chord)) {
    return PH_CHECK_SHAPE_START;
  }
  if (!is_convex(&h[4], &h[3], &chord)) {
    return PH_CHECK_SHAPE_END;
  }
  triple = ph_vec3_triple(h[0].v, dp, h[4].v);
  error = triple_error(&h[0], &chord, &h[4]) +
          (NO_VOLUME + 2 * planarity) * h[0].size * chord.size * h[4].size;
  if (fabs(triple) > error && !winds_like(h, triple > 0 ? 1 : -1)) {
    return PH_CHECK_SHAPE_TORSION;
  }
  return PH_CHECK_SHAPE_KEPT;
}
