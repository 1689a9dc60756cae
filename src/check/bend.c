/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How a segment bends and twists (see bend.h). */
#include "check/bend.h"

/* Derivatives are as uncertain as (note.h). */
static const double NEXT = PH_CHECK_ROUND_NEXT;

/* A torsion that comes and goes with changes of r' by this, relative, is that
 * of a plane curve. */
static const double PLANE = 1e-10;

/* Rounding of r' x r'', of the sizes of r' and of what r'' is summed from: at
 * an inflection, which integrals are cut at, its direction is no other than
 * that of its derivative. */
static const double ROUND_TURN = 16 * DBL_EPSILON;

/* Control points know a segment in space well enough where rounding changes r'
 * by less than this part of it, and the curve is nowhere slow: their jets take
 * fewer products than those of a preimage. */
static const double WELL_KNOWN = 1e-9;

/* What rounding may change r' by, relative. */
static const double STILL = 0x1p-6;

struct ph_check_bent ph_check_bent_of(const struct ph_check *v,
                                      const struct ph_check_segment *s) {
  struct ph_check_bent bent = {.s = s, .plane = v->curve->dimension == 2};
  bent.slow = ph_check_slow_of(s);
  bent.rooted = s->rooted && (bent.plane || bent.slow.n > 0 ||
                              s->noise > WELL_KNOWN * s->speed);
  if (bent.rooted) {
    ph_check_root_of(v, s, &bent.root);
    ph_check_root_slow(&bent.root, &bent.slow);
  }
  return bent;
}

/* r', r'', ... */
struct jet {
  ph_vec3 of[PH_CHECK_JET];
  double error[PH_CHECK_JET];
};

static void jet_at(const struct ph_check_bent *bent, double u, size_t n,
                   struct jet *jet) {
  double noise = bent->s->noise;
  if (bent->rooted) {
    ph_check_root_jet(&bent->root, u, jet->of, jet->error, n);
    return;
  }
  ph_check_jet(bent->s, u, jet->of, n);
  for (size_t i = 0; i < n; i++) {
    jet->error[i] = noise;
    noise *= NEXT;
  }
}

/* The error of a x b. */
static double product(double a, double a_error, double b, double b_error) {
  return a * b_error + b * a_error;
}

/* The same of jets where a plane curve is none. */
static void loosen(const struct ph_check_bent *bent, struct jet *jet) {
  double more = PLANE * bent->s->speed;
  for (size_t i = 0; i < PH_CHECK_JET; i++) {
    jet->error[i] += more;
    more *= NEXT;
  }
}

static void twist(struct jet jet, ph_vec3 turn, ph_vec3 change,
                  struct ph_check_bend *b) {
  const double *e = jet.error;
  double square = ph_vec3_dot(turn, turn), size = sqrt(square);
  double second = ph_vec3_abs(jet.of[1]), third = ph_vec3_abs(jet.of[2]);
  double tau = ph_vec3_dot(turn, jet.of[2]) / square;
  double rate = ph_vec3_dot(turn, change) / square;
  double part = product(b->speed, e[0], second, e[1]) / size;
  b->twist = ph_vec3_dot(turn, jet.of[3]) / square - 2 * tau * rate;
  b->twist_error = (e[3] + ph_vec3_abs(jet.of[3]) * part) / size +
                   2 * fabs(rate) * (e[2] + 2 * third * part) / size +
                   2 * fabs(tau) *
                       (product(b->speed, e[0], third, e[2]) +
                        3 * ph_vec3_abs(change) * part) /
                       size;
}

/*
 * In the plane by w = A, with n = |w|^2, C = w x w', D = w x w'', S = w . w':
 *
 *   kappa = 2 C / n^2,  kappa' = 2 D / n^2 - 8 C S / n^3                 (2)
 *
 * [derived here from (1), with r' = w^2; tested by verify-degenerate.t]
 */
static struct ph_check_bend plane_at(const struct ph_check_root *root,
                                     double u) {
  struct ph_check_bend b = {.twist = 0};
  ph_quat a[PH_CHECK_JET];
  double n, per, square, c, d, s, size, next, off_c, off_d, fast;
  ph_check_root_at(root, u, a);
  n = a[0].u * a[0].u + a[0].q * a[0].q;
  c = a[0].u * a[1].q - a[0].q * a[1].u;
  d = 2 * (a[0].u * a[2].q - a[0].q * a[2].u); /* a series */
  s = a[0].u * a[1].u + a[0].q * a[1].q;
  per = 1 / n;
  square = 2 * per * per;
  size = sqrt(n);
  next = sqrt(a[1].u * a[1].u + a[1].q * a[1].q);
  off_c = root->error * (next + NEXT * size);
  off_d =
      root->error * (2 * (fabs(a[2].u) + fabs(a[2].q)) + NEXT * NEXT * size);
  fast = 4 * root->error / size;
  b.speed = n;
  b.kappa = square * c;
  b.rate = square * (d - 4 * c * s * per);
  b.kappa_error = square * (off_c + fabs(c) * fast);
  b.rate_error =
      square *
      (off_d + fabs(d) * fast +
       per * (4 * off_c * (fabs(c) + fabs(s)) + 6 * fabs(c * s) * fast));
  return b;
}

static struct ph_check_bend by_jet(const struct ph_check_bent *bent, double u) {
  struct ph_check_bend b = {.twist = 0};
  struct jet jet;
  jet_at(bent, u, bent->twists ? 4 : 3, &jet);
  const ph_vec3 turn = ph_vec3_cross(jet.of[0], jet.of[1]);
  const ph_vec3 change = ph_vec3_cross(jet.of[0], jet.of[2]);
  const double *e = jet.error, second = ph_vec3_abs(jet.of[1]);
  const double third = ph_vec3_abs(jet.of[2]), speed = ph_vec3_abs(jet.of[0]);
  const double per = 1 / speed, cube = speed * speed * speed;
  const double size = bent->plane ? turn.z : ph_vec3_abs(turn);
  const double slope = ph_vec3_dot(jet.of[0], jet.of[1]) * per * per;
  const double to =
      bent->plane ? change.z
      : size > ROUND_TURN * speed * (second + NEXT * bent->s->speed)
          ? ph_vec3_dot(turn, change) / size
          : ph_vec3_abs(change);
  const double part = product(speed, e[0], second, e[1]); /* of C, r' . r'' */
  const double fast = e[0] * per;
  b.speed = speed;
  b.kappa = size / cube;
  b.rate = to / cube - 3 * b.kappa * slope;
  b.kappa_error = part / cube + 3 * fabs(b.kappa) * fast;
  b.rate_error =
      (product(speed, e[0], third, e[2]) + 3 * fabs(to) * fast) / cube +
      3 * (fabs(slope) * b.kappa_error +
           fabs(b.kappa) * (part * per * per + 2 * fabs(slope) * fast));
  if (!bent->plane) { /* the direction of r' x r'' */
    double loose = part / size;
    b.rate_error += (loose < 1 ? loose : 1) * ph_vec3_abs(change) / cube;
  }
  if (bent->twists) {
    loosen(bent, &jet);
    twist(jet, turn, change, &b);
  }
  return b;
}

struct ph_check_bend ph_check_bend_at(const struct ph_check_bent *bent,
                                      double u) {
  return bent->plane && bent->rooted ? plane_at(&bent->root, u)
                                     : by_jet(bent, u);
}

bool ph_check_bent_stands(const struct ph_check_bent *bent) {
  const double speed = sqrt(bent->slow.low);
  const double error =
      bent->rooted ? 2 * bent->root.error * sqrt(speed) : bent->s->noise;
  return !(speed > error / STILL);
}

double ph_check_bent_length(const struct ph_check *v,
                            const struct ph_check_bent *bent, double *error) {
  double length = 0;
  if (!bent->rooted) {
    *error = bent->s->noise;
    return v->length[bent->s->k];
  }
  for (size_t i = 0; i < v->fixed.n; i++) { /* exact: segment.h */
    ph_quat a[PH_CHECK_JET];
    ph_check_root_at(&bent->root, v->fixed.node[i], a);
    length += v->fixed.weight[i] * ph_quat_dot(a[0], a[0]);
  }
  *error = 2 * bent->root.error * sqrt(length);
  return length;
}

double ph_check_bending(const void *bent, double u) {
  struct jet jet;
  jet_at(bent, u, 2, &jet);
  const ph_vec3 turn = ph_vec3_cross(jet.of[0], jet.of[1]);
  const double square = ph_vec3_dot(jet.of[0], jet.of[0]);
  return ph_vec3_dot(turn, turn) / (square * square);
}

bool ph_check_bent_straight(const struct ph_check_bent *bent, double u) {
  struct jet jet;
  jet_at(bent, u, 2, &jet);
  ph_vec3 turn = ph_vec3_cross(jet.of[0], jet.of[1]);
  jet.of[2] = jet.of[3] = ph_vec3_of(0, 0, 0);
  jet.error[2] = jet.error[3] = 0;
  loosen(bent, &jet);
  return !(product(ph_vec3_abs(jet.of[0]), jet.error[0], ph_vec3_abs(jet.of[1]),
                   jet.error[1]) < PH_CHECK_NO_DIRECTION * ph_vec3_abs(turn));
}
