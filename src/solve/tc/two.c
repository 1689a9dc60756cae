/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Two Tschirnhausen cubics for G1 Hermite data: the scale of the end
 * derivatives, or the tangent at the joint, is a free number x.  The product F
 * of energy and length, which does not depend on the scale, is looked at on a
 * grid of x, and its minimum is then refined between the neighbours of the
 * best.
 */
#include "solve/tc/tc.h"

#include "kernel/golden.h"
#include "kernel/pi.h"

/* ---- a minimum of one variable ------------------------------------------- */

/* F of x, infinite where there is no curve to take. */
struct fairness {
  double (*f)(const void *self, double x);
  const struct ph_tc_hermite *h;
  size_t root;     /* of a pair */
  double position; /* of the joint on the chord; or NaN */
  double start;    /* of a range of angles at the joint */
  double end;
  unsigned rank; /* of curves that are looked for */
};

/* Golden section leaves 1.2e-3 of a bracket.  Newton's method squares what is
 * left, relative, so that two steps come to the rounding of F; a third is kept
 * in reserve.  F may rise by RISE in it, some hundred roundings. */
enum { GOLDEN_STEPS = 14, POLISH_STEPS = 3 };
static const double RISE = 1e-13;

/* The step of the difference quotient in a bracket, so long that rounding of F
 * does not show; its error, of the fourth order, moves lambda by some 1e-9. */
static const double STEP = 1.0 / 32;

/*
 * Newton's method on a difference quotient of fourth order gives all but the
 * last few digits, so that the same data seen from elsewhere give the same
 * curve.
 *
 * ret  whether it took a step
 */
static bool polish(const struct fairness *fair, double step,
                   struct ph_bracket *b) {
  bool moved = false;
  for (int i = 0; i < POLISH_STEPS; i++) {
    double f[5], first, second, x; /* derivatives, by step */
    for (int k = 0; k < 5; k++) {
      f[k] = k == 2 ? b->value : fair->f(fair, b->x + (k - 2) * step);
    }
    first = (8 * (f[3] - f[1]) - (f[4] - f[0])) / 12;
    second = (16 * (f[3] + f[1]) - (f[4] + f[0]) - 30 * f[2]) / 12;
    x = b->x - step * first / second;
    if (!(second > 0 && fabs(first) <= second)) {
      return moved;
    }
    f[2] = fair->f(fair, x);
    if (!(f[2] <= b->value * (1 + RISE))) {
      return moved;
    }
    b->x = x;
    b->value = f[2];
    moved = true;
  }
  return moved;
}

/* No step of it leads to a larger F, but for rounding. */
static void refine(const struct fairness *fair, struct ph_bracket *b) {
  struct ph_bracket fine = *b;
  double step = STEP * (b->high - b->low);
  ph_golden(fair->f, fair, GOLDEN_STEPS, &fine);
  b->x = fine.x;
  b->value = fine.value;
  if (b->x - b->low > 2 * step && b->high - b->x > 2 * step) {
    polish(fair, step, b);
  }
}

/* Of values that agree so well the first one is taken. */
static bool is_less(double a, double b) {
  return a < b && !(a >= b * (1 - 1e-9));
}

static double fairness_of(const struct ph_tc_fit *fit) {
  double f = fit->energy * fit->length;
  return fit->regular && f < (double)INFINITY ? f : (double)INFINITY;
}

/* ---- joint anywhere ------------------------------------------------------ */

/* x is the logarithm of lambda over the least one. */
#define LAMBDA_LEAST 0.15
#define LAMBDA_MOST PH_TC_PAIR_LONGEST

/* Half as many find the same minima of 1500 random data, a quarter misses 3. */
enum { LAMBDAS = 25 };

/* Of them that next to 1/2, which is nearly that of a shallow arc. */
enum { LAMBDA_OF_ARC = 13 };

static double lambda_of(double x) {
  return fmin(LAMBDA_LEAST * exp(x), LAMBDA_MOST);
}

/* The pair of one root, measured. */
static struct ph_tc_fit pair_at(const struct fairness *fair, double x) {
  struct ph_tc_fit fits[PH_TC_PAIRS];
  double lambda = lambda_of(x);
  struct ph_tc_hermite h = ph_tc_hermite_scaled(fair->h, lambda);
  if (!(fair->root == 0 && ph_tc_pair_standard(&h, &fits[0]))) {
    ph_tc_pairs(&h, fits);
  }
  ph_tc_fit_measure(&fits[fair->root]);
  fits[fair->root].lambda = lambda;
  return fits[fair->root];
}

static double pair_fairness(const void *self, double x) {
  const struct fairness *fair = self;
  struct ph_tc_fit fit = pair_at(fair, x);
  return fit.loops == 0 ? fairness_of(&fit) : (double)INFINITY;
}

static bool is_straight(const struct ph_tc_hermite *h) {
  return ph_tc_is_forward(h->t[0]) && ph_tc_is_forward(h->t[1]);
}

static double grid_at(size_t k) {
  return (double)k * log(LAMBDA_MOST / LAMBDA_LEAST) / (LAMBDAS - 1);
}

static void look_at_lambdas(const struct ph_tc_hermite *h,
                            double value[LAMBDAS][PH_TC_PAIRS]) {
  for (size_t k = 0; k < LAMBDAS; k++) {
    struct ph_tc_fit fits[PH_TC_PAIRS];
    struct ph_tc_hermite s = ph_tc_hermite_scaled(h, lambda_of(grid_at(k)));
    ph_tc_pairs(&s, fits);
    for (size_t i = 0; i < PH_TC_PAIRS; i++) {
      ph_tc_fit_measure(&fits[i]);
      value[k][i] =
          fits[i].loops == 0 ? fairness_of(&fits[i]) : (double)INFINITY;
    }
  }
}

/* The simple pair of the least value; those that are not simple are made
 * infinite.  False if there is none. */
static bool least_simple(struct fairness *fair,
                         double value[LAMBDAS][PH_TC_PAIRS], size_t *at,
                         struct ph_tc_fit *fit) {
  for (size_t tries = 0; tries < (size_t)LAMBDAS * PH_TC_PAIRS; tries++) {
    double least = (double)INFINITY;
    for (size_t k = 0; k < LAMBDAS; k++) {
      for (size_t i = 0; i < PH_TC_PAIRS; i++) {
        if (is_less(value[k][i], least)) {
          least = value[k][i];
          fair->root = i;
          *at = k;
        }
      }
    }
    if (!(least < (double)INFINITY)) {
      return false;
    }
    *fit = pair_at(fair, grid_at(*at));
    if (ph_tc_fit_test(fit)) {
      return true;
    }
    value[*at][fair->root] = (double)INFINITY;
  }
  return false;
}

/* Both tangents are within a right angle of the chord: the standard pair is
 * simple and the best for every lambda, and F has one minimum. */
static bool is_smooth(const struct ph_tc_hermite *h) {
  const struct ph_tc_hermite safe = ph_tc_hermite_scaled(h, 0.5);
  return ph_tc_pair_is_safe(&safe);
}

/*
 * The minimum of smooth F: downhill on the grid, from the lambda of a shallow
 * arc, to a value with larger ones on either side; from the vertex of their
 * parabola by Newton's method.
 */
static struct ph_bracket least_smooth(const struct fairness *fair) {
  const double step = grid_at(1);
  size_t at = LAMBDA_OF_ARC;
  double below = fair->f(fair, grid_at(at - 1)), here, above;
  struct ph_bracket b;
  here = fair->f(fair, grid_at(at));
  above = fair->f(fair, grid_at(at + 1));
  while (at > 1 && is_less(below, here)) {
    above = here;
    here = below;
    below = fair->f(fair, grid_at(--at - 1));
  }
  while (at + 2 < LAMBDAS && is_less(above, here)) {
    below = here;
    here = above;
    above = fair->f(fair, grid_at(++at + 1));
  }
  b = (struct ph_bracket){grid_at(at - 1), grid_at(at), grid_at(at + 1), here};
  if (is_less(below, here) || is_less(above, here)) { /* an end of the grid */
    *(below < above ? &b.high : &b.low) = b.x;
    b.x = below < above ? b.low : b.high;
    b.value = fmin(below, above);
    refine(fair, &b);
    return b;
  }
  b.x += 0.5 * step * (below - above) / (below - 2 * here + above);
  b.value = fair->f(fair, b.x);
  if (!(b.value <= here) || !polish(fair, STEP * 2 * step, &b)) {
    b.x = grid_at(at);
    b.value = here;
    refine(fair, &b);
  }
  return b;
}

bool ph_tc_two_free(const struct ph_tc_hermite *h, struct ph_tc_fit *fit) {
  struct fairness fair = {.f = pair_fairness, .h = h};
  double value[LAMBDAS][PH_TC_PAIRS];
  struct ph_tc_fit fine;
  struct ph_bracket b;
  size_t at = 0;
  if (is_straight(h)) {
    struct ph_tc_hermite half = ph_tc_hermite_scaled(h, 0.5);
    ph_tc_pair_standard(&half, fit);
    ph_tc_fit_measure(fit);
    fit->lambda = 0.5;
    return ph_tc_fit_test(fit);
  }
  if (is_smooth(h)) {
    *fit = pair_at(&fair, least_smooth(&fair).x);
    fit->simple = true;
    return true;
  }
  look_at_lambdas(h, value);
  if (!least_simple(&fair, value, &at, fit)) {
    return false;
  }
  b.low = grid_at(at > 0 ? at - 1 : at);
  b.x = grid_at(at);
  b.high = grid_at(at + 1 < LAMBDAS ? at + 1 : at);
  b.value = value[at][fair.root];
  refine(&fair, &b);
  fine = pair_at(&fair, b.x);
  if (ph_tc_fit_test(&fine)) {
    *fit = fine;
  }
  return true;
}

/* ---- joint on the chord -------------------------------------------------- */

/* x is the angle over the end of the range of angles, in (0, 1).  Twice as many
 * find less F for 15 % of random data, by a percent for .4 %: where it is least
 * next to a loop. */
enum { ANGLES = 64 };

static void part_of(const struct ph_tc *tc, double part, struct ph_tc *out) {
  for (int i = 0; i < 2; i++) {
    out->w[i] = ph_cplx_scale(sqrt(part), tc->w[i]);
  }
}

/*
 * A cubic over either part of the chord has the same shape whatever the parts:
 * of E1 and E2 over the whole chord comes E1/m + E2/(1 - m), which is least,
 * (sqrt E1 + sqrt E2)^2, at m = sqrt E1/(sqrt E1 + sqrt E2).
 */
static bool chord_at(const struct ph_tc_hermite *h, double angle,
                     double position, struct ph_tc_fit *fit) {
  ph_cplx u = ph_cplx_polar(angle);
  struct ph_tc_hermite first = {{h->t[0], u}}, second = {{u, h->t[1]}};
  struct ph_tc_fit a[2], b[2];
  if (ph_tc_g1(&first, a) == 0 || ph_tc_g1(&second, b) == 0) {
    return false;
  }
  if (isnan(position)) {
    double ea = sqrt(a[0].energy), eb = sqrt(b[0].energy);
    position = ea / (ea + eb);
  }
  if (!(position > 0 && position < 1)) {
    return false;
  }
  *fit = ph_tc_fit_of(2, PH_ROOT_ON_CHORD);
  fit->joint_angle = angle;
  fit->joint_position = position;
  part_of(&a[0].tc[0], position, &fit->tc[0]);
  part_of(&b[0].tc[0], 1 - position, &fit->tc[1]);
  ph_tc_fit_measure(fit);
  return fit->regular;
}

/* How much a curve on the chord is worth: simple, also if its cubics go on a
 * little, as one that all but ends on itself is no better than a loop; simple;
 * with crossings of its two cubics, one loop, or two. */
enum { RANKS = 5 };

static unsigned rank_of(const struct ph_tc_fit *fit) {
  const double margin = 0.01;
  struct ph_tc_fit tested = *fit;
  unsigned near = 0;
  if (fit->loops > 0 || !ph_tc_fit_test(&tested)) {
    return 2 + fit->loops;
  }
  for (size_t i = 0; i < fit->n; i++) {
    struct ph_tc longer = ph_tc_part(&fit->tc[i], -margin, 1 + margin);
    near |= ph_tc_has_loop(&longer);
  }
  return near;
}

/* The angle at x in (0, 1) of a range. */
static double angle_of(const struct fairness *fair, double x) {
  return fair->start + x * (fair->end - fair->start);
}

static double chord_fairness(const void *self, double x) {
  const struct fairness *fair = self;
  struct ph_tc_fit fit;
  bool is = x > 0 && x < 1 &&
            chord_at(fair->h, angle_of(fair, x), fair->position, &fit) &&
            rank_of(&fit) == fair->rank;
  return is ? fairness_of(&fit) : (double)INFINITY;
}

static double angle_at(size_t k) {
  double s = sin(0.5 * PH_PI * (double)k / (ANGLES + 1));
  return s * s;
}

/* The least in a range. */
static struct ph_bracket least_of(const struct fairness *fair) {
  struct ph_bracket b = {.high = 1, .value = (double)INFINITY};
  for (size_t k = 1; k <= ANGLES; k++) {
    double x = angle_at(k), value = fair->f(fair, x);
    if (is_less(value, b.value)) {
      b = (struct ph_bracket){.low = angle_at(k - 1),
                              .x = x,
                              .high = angle_at(k + 1),
                              .value = value};
    }
  }
  if (b.value < (double)INFINITY) {
    refine(fair, &b);
  }
  return b;
}

/*
 * Ranges of angles for which both cubics are: what the ranges of both tangents
 * have in common, to either side of 0, and modulo a turn, where that is
 * something.
 */
static size_t ranges_of(const struct ph_tc_hermite *h, double range[4][2]) {
  double r[2][2];
  size_t n = 0;
  for (int i = 0; i < 2; i++) {
    ph_tc_g1_range(atan2(h->t[i].im, h->t[i].re), r[i]);
  }
  for (int turn = -1; turn <= 1; turn++) {
    double low = fmax(r[0][0], r[1][0] + 2 * PH_PI * turn);
    double high = fmin(r[0][1], r[1][1] + 2 * PH_PI * turn);
    if (turn == 0) {
      range[n][0] = range[n + 1][0] = 0;
      range[n][1] = high;
      range[n + 1][1] = low;
      n += 2;
    } else if (low < high) {
      range[n][0] = low;
      range[n++][1] = high;
    }
  }
  return n;
}

/* The angle of the least F with as few loops as there can be; NaN if there is
 * none. */
static double best_angle(const struct ph_tc_hermite *h, double position) {
  struct fairness fair = {.f = chord_fairness, .h = h, .position = position};
  double range[4][2];
  size_t n = ranges_of(h, range);
  for (fair.rank = 0; fair.rank < RANKS; fair.rank++) {
    double angle = (double)NAN, least = (double)INFINITY;
    for (size_t i = 0; i < n; i++) {
      struct ph_bracket b;
      fair.start = range[i][0];
      fair.end = range[i][1];
      b = least_of(&fair);
      if (is_less(b.value, least)) {
        least = b.value;
        angle = remainder(angle_of(&fair, b.x), 2 * PH_PI);
      }
    }
    if (!isnan(angle)) {
      return angle;
    }
  }
  return (double)NAN;
}

/* The chord itself, in two parts. */
static bool straight(double position, struct ph_tc_fit *fit) {
  struct ph_tc chord = {{{1, 0}, {1, 0}}};
  *fit = ph_tc_fit_of(2, PH_ROOT_ON_CHORD);
  fit->joint_angle = 0;
  fit->joint_position = isnan(position) ? 0.5 : position;
  part_of(&chord, fit->joint_position, &fit->tc[0]);
  part_of(&chord, 1 - fit->joint_position, &fit->tc[1]);
  ph_tc_fit_measure(fit);
  return ph_tc_fit_test(fit);
}

bool ph_tc_two_chord(const struct ph_tc_hermite *h, double angle,
                     double position, struct ph_tc_fit *fit) {
  if (isnan(angle) && is_straight(h)) {
    return straight(position, fit);
  }
  if (isnan(angle)) {
    angle = best_angle(h, position);
  }
  if (!(fabs(angle) > 0) || !chord_at(h, angle, position, fit)) {
    return false;
  }
  ph_tc_fit_test(fit);
  return true;
}
