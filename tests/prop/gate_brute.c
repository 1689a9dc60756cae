/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Diagnostics by brute force (see gate.h): adaptive quadrature in long double
 * of what the preimages say, and polygons in the place of curves.
 *
 *   plane  w:  sigma = |w|^2, kappa = 2 Im(w* w') / sigma^2
 *   space  A:  r' = A i A*, kappa = |r' x r''| / sigma^3
 *   E = int kappa^2 sigma, MV = int kappa'^2 / sigma, IES = E L, IMV = MV L^3,
 *   F1, F2 the sums of IES and IMV of the segments,
 *   F of arclength = sum |2 (A0 - 2 A1 + A2)|^2 / h^4, intervals of mean 1
 */
#include "gate.h"

typedef long double real;

/* Numbers that agree to this, relative, are the same. */
static const double SAME = 1e-6;

/* Rounding of the preimage turns r' by a few of these: kappa L, and kappa' L^2,
 * are known to these numbers of them, and so is an angle. */
static const real ROUNDING = DBL_EPSILON;
enum { ROUND_CURVATURE = 16, ROUND_SLOPE = 256, ROUND_ANGLE = 16 };

/* In space what is as straight as 1e-13 (FLAT of curve/fair/fair3.c) is a line:
 * its kappa L is 0 then, and not ten times that. */
static const real STRAIGHT = 1e-12L;

/* Panels of the quadrature, and halvings of one, at most; how well halves agree
 * with the whole. */
enum { PANELS = 8, HALVINGS = 60, CALLS = 20000 };
static const real AGREE = 1e-11L;

/* Where the curvature changes its sign, |kappa| has a kink that nodes may miss:
 * it is halved until its part of the angle is this of that of the segment. */
static const real KINKED = 1e-9L;

/* Places of a segment where its polygon has points. */
enum { PLACES = 128, SEGMENTS = 6 };

enum integral { LENGTH, BENDING, VARYING, TURNING, ABSOLUTE, INTEGRALS };

struct segment {
  size_t dimension, n; /* of the preimage: 2 or 4; coefficients: 2 or 3 */
  real end;            /* of the local parameter */
  bool atph;
  real a[3][4];
  real angle; /* the integral of |kappa|, about */
  size_t calls;
};

/* ---- a segment ---------------------------------------------------------- */

static void load(const struct ph_curve *curve, size_t k, struct segment *s) {
  const double *a = ph_curve_preimage(curve, k);
  s->dimension = curve->preimage.dimension;
  s->n = curve->preimage.n;
  s->atph = curve->kind == PH_CURVE_ATPH;
  s->end = s->atph ? curve->preimage.alpha[k] : 1;
  s->calls = 0;
  memset(s->a, 0, sizeof s->a);
  for (size_t i = 0; i < s->n; i++) {
    for (size_t j = 0; j < s->dimension; j++) {
      s->a[i][j] = a[s->dimension * i + j];
    }
  }
}

/* The preimage and two derivatives at t. */
static void jet(const struct segment *s, real t, real w[3][4]) {
  real half = s->end / 2, sine = sinl(half), middle = 2, b[3][3];
  real x[3] = {1 - t, -1, 0}, y[3] = {t, 1, 0};
  if (s->atph) {
    x[0] = sinl((s->end - t) / 2) / sine;
    x[1] = -cosl((s->end - t) / 2) / sine / 2;
    x[2] = -x[0] / 4;
    y[0] = sinl(t / 2) / sine;
    y[1] = cosl(t / 2) / sine / 2;
    y[2] = -y[0] / 4;
    middle = 2 * cosl(half);
  }
  for (size_t d = 0; d < 3; d++) {
    if (s->n == 2) {
      b[d][0] = x[d];
      b[d][1] = y[d];
      b[d][2] = 0;
      continue;
    }
    b[d][0] = d == 0   ? x[0] * x[0]
              : d == 1 ? 2 * x[0] * x[1]
                       : 2 * (x[1] * x[1] + x[0] * x[2]);
    b[d][1] = middle * (d == 0   ? x[0] * y[0]
                        : d == 1 ? x[0] * y[1] + x[1] * y[0]
                                 : x[2] * y[0] + 2 * x[1] * y[1] + x[0] * y[2]);
    b[d][2] = d == 0   ? y[0] * y[0]
              : d == 1 ? 2 * y[0] * y[1]
                       : 2 * (y[1] * y[1] + y[0] * y[2]);
  }
  for (size_t d = 0; d < 3; d++) {
    for (size_t j = 0; j < 4; j++) {
      w[d][j] =
          b[d][0] * s->a[0][j] + b[d][1] * s->a[1][j] + b[d][2] * s->a[2][j];
    }
  }
}

static real square(real x) {
  return x * x;
}

static real dot(const real *a, const real *b, size_t n) {
  real sum = 0;
  for (size_t i = 0; i < n; i++) {
    sum += a[i] * b[i];
  }
  return sum;
}

static void cross(const real *a, const real *b, real *c) {
  c[0] = a[1] * b[2] - a[2] * b[1];
  c[1] = a[2] * b[0] - a[0] * b[2];
  c[2] = a[0] * b[1] - a[1] * b[0];
}

/* v += factor times the vector part of a i b* */
static void add_product(real factor, const real *a, const real *b, real *v) {
  real u = -a[1], x = a[0], y = a[3], z = -a[2]; /* a i */
  v[0] += factor * (-u * b[1] + x * b[0] - y * b[3] + z * b[2]);
  v[1] += factor * (-u * b[2] + x * b[3] + y * b[0] - z * b[1]);
  v[2] += factor * (-u * b[3] - x * b[2] + y * b[1] + z * b[0]);
}

/* Speed, curvature, and the derivative of the latter by t. */
static void bend(const struct segment *s, real t, real *sigma, real *kappa,
                 real *slope) {
  real w[3][4], rate;
  jet(s, t, w);
  *sigma = dot(w[0], w[0], s->dimension);
  rate = 2 * dot(w[0], w[1], s->dimension) / *sigma;
  if (s->dimension == 2) {
    real turn = w[0][0] * w[1][1] - w[0][1] * w[1][0];
    real change = w[0][0] * w[2][1] - w[0][1] * w[2][0];
    *kappa = 2 * turn / (*sigma * *sigma);
    *slope = 2 * change / (*sigma * *sigma) - 2 * *kappa * rate;
  } else {
    real r[3][3] = {{0}}, c[3], e[3], size;
    add_product(1, w[0], w[0], r[0]);
    add_product(1, w[0], w[1], r[1]);
    add_product(1, w[1], w[0], r[1]);
    add_product(1, w[0], w[2], r[2]);
    add_product(2, w[1], w[1], r[2]);
    add_product(1, w[2], w[0], r[2]);
    cross(r[0], r[1], c);
    cross(r[0], r[2], e);
    size = sqrtl(dot(c, c, 3));
    *kappa = size / (*sigma * *sigma * *sigma);
    *slope = (size > 0 ? dot(c, e, 3) / size : 0) / (*sigma * *sigma * *sigma) -
             3 * *kappa * rate;
  }
}

/* ---- integrals ---------------------------------------------------------- */

/* Gauss's rule of 8 nodes. */
static void panel(struct segment *s, real from, real to, real *sum) {
  static const real node[4] = {0.18343464249564980493947614236018398L,
                               0.52553240991632898581773904918924635L,
                               0.79666647741362673959155393647583044L,
                               0.96028985649753623168356086856947299L};
  static const real weight[4] = {0.36268378337836198296515044927719561L,
                                 0.31370664587788728733796220198660131L,
                                 0.22238103445337447054435599442624088L,
                                 0.10122853629037625915253135430996219L};
  real middle = (from + to) / 2, half = (to - from) / 2;
  memset(sum, 0, INTEGRALS * sizeof *sum);
  s->calls++;
  for (int i = 0; i < 8; i++) {
    real sigma, kappa, slope, w = weight[i / 2] * half;
    bend(s, middle + (i % 2 ? half : -half) * node[i / 2], &sigma, &kappa,
         &slope);
    sum[LENGTH] += w * sigma;
    sum[BENDING] += w * kappa * kappa * sigma;
    sum[VARYING] += w * slope * slope / sigma;
    sum[TURNING] += w * kappa * sigma;
    sum[ABSOLUTE] += w * fabsl(kappa) * sigma;
  }
}

/* Whether the curvature changes its sign in a panel, or nearly: less of it is
 * of the other sign at an end than nodes can see. */
static bool is_kinked(const struct segment *s, real from, real to,
                      const real *sum) {
  real sigma, slope, kappa[2];
  bend(s, from, &sigma, &kappa[0], &slope);
  bend(s, to, &sigma, &kappa[1], &slope);
  return !(kappa[0] * kappa[1] > 0 && sum[ABSOLUTE] <= fabsl(sum[TURNING]));
}

/* Adds the integrals over [from,to]; false where they are not found. */
static bool integrate(struct segment *s, real from, real to, const real *whole,
                      int halvings, real *total) {
  real middle = (from + to) / 2, left[INTEGRALS], right[INTEGRALS];
  bool agree = true;
  if (s->calls > CALLS || halvings == 0) {
    return false;
  }
  panel(s, from, middle, left);
  panel(s, middle, to, right);
  for (int i = 0; i < INTEGRALS; i++) {
    real sum = left[i] + right[i];
    real scale = i == TURNING ? left[ABSOLUTE] + right[ABSOLUTE] : fabsl(sum);
    agree = agree && fabsl(sum - whole[i]) <= AGREE * scale;
  }
  agree = agree && (left[ABSOLUTE] + right[ABSOLUTE] <= KINKED * s->angle ||
                    !is_kinked(s, from, to, whole));
  if (agree) {
    for (int i = 0; i < INTEGRALS; i++) {
      total[i] += left[i] + right[i];
    }
    return true;
  }
  return integrate(s, from, middle, left, halvings - 1, total) &&
         integrate(s, middle, to, right, halvings - 1, total);
}

static bool integrals(struct segment *s, real *total) {
  real whole[PANELS][INTEGRALS];
  memset(total, 0, INTEGRALS * sizeof *total);
  s->angle = 0;
  for (int i = 0; i < PANELS; i++) {
    panel(s, s->end * i / PANELS, s->end * (i + 1) / PANELS, whole[i]);
    s->angle += whole[i][ABSOLUTE];
  }
  for (int i = 0; i < PANELS; i++) {
    if (!integrate(s, s->end * i / PANELS, s->end * (i + 1) / PANELS, whole[i],
                   HALVINGS, total)) {
      return false;
    }
  }
  return true;
}

/* ---- what is claimed ------------------------------------------------------
 */

static void claim(const struct ph_diagnostics *d, enum ph_diagnostic which,
                  real found, real unit, struct gate_outcome *outcome) {
  bool known = d->known >> which & 1;
  double value = d->value[which];
  char way[64];
  if (!(fabsl(found) < (real)DBL_MAX) || !known ||
      (fabsl(found) < (real)DBL_MIN && fabsl(found) > 0)) {
    return;
  }
  snprintf(way, sizeof way, "brute %s", ph_diagnostic_name(which));
  if (!(fabsl(value - found) <= SAME * fabsl(unit))) {
    gate_wrong(outcome, way, "%.17g is claimed, %.17g was found", value,
               (double)found);
  }
}

/* Sums over segments: of integrals, and F1, F2; and what rounding of them may
 * make of E, MV, F1, F2, over SAME. */
struct fair {
  real sum[INTEGRALS], f1, f2;
  real bending, varying, f1_rounding, f2_rounding;
};

/* What rounding makes of the integral of the square of x, if it changes x by no
 * more than an error of which that integral is `square': 2 x error + error^2,
 * by the inequality of Schwarz, over SAME. */
static real rounding_of(real integral, real square) {
  return (2 * sqrtl(integral * square) + square) / SAME;
}

static bool fair_of(const struct ph_curve *curve, struct fair *fair) {
  const real round =
      curve->dimension == 2 ? ROUND_CURVATURE * ROUNDING : STRAIGHT;
  const real f1 = square(round);
  const real f2 = square(round * ROUND_SLOPE / ROUND_CURVATURE);
  *fair = (struct fair){.f1 = 0};
  for (size_t k = 0; k < curve->n; k++) {
    struct segment s;
    real of[INTEGRALS], cube;
    load(curve, k, &s);
    if (!integrals(&s, of)) {
      return false;
    }
    for (int i = 0; i < INTEGRALS; i++) {
      fair->sum[i] += of[i];
    }
    cube = of[LENGTH] * of[LENGTH] * of[LENGTH];
    fair->f1 += of[LENGTH] * of[BENDING];
    fair->f2 += cube * of[VARYING];
    fair->bending += rounding_of(of[BENDING], f1 / of[LENGTH]);
    fair->varying += rounding_of(of[VARYING], f2 / cube);
    fair->f1_rounding += rounding_of(of[LENGTH] * of[BENDING], f1);
    fair->f2_rounding += rounding_of(cube * of[VARYING], f2);
  }
  return true;
}

static void energies(const struct ph_curve *curve,
                     const struct ph_diagnostics *d,
                     struct gate_outcome *outcome) {
  const real turn = 8 * atanl(1);
  struct fair f;
  real length, cube, energy, mv, angle, *sum = f.sum;
  if (!fair_of(curve, &f)) {
    return;
  }
  length = sum[LENGTH];
  cube = length * length * length;
  energy = sum[BENDING] + f.bending;
  mv = sum[VARYING] + f.varying;
  angle = sum[ABSOLUTE] / turn + ROUND_ANGLE * ROUNDING / SAME;
  claim(d, PH_D_ENERGY, sum[BENDING], energy, outcome);
  claim(d, PH_D_MV, sum[VARYING], mv, outcome);
  claim(d, PH_D_IES, sum[BENDING] * length, energy * length, outcome);
  claim(d, PH_D_IMV, sum[VARYING] * cube, mv * cube, outcome);
  claim(d, PH_D_F1, f.f1, f.f1 + f.f1_rounding, outcome);
  claim(d, PH_D_F2, f.f2, f.f2 + f.f2_rounding, outcome);
  claim(d, PH_D_ROTATION_INDEX, sum[TURNING] / turn, angle, outcome);
  claim(d, PH_D_ABSOLUTE_ROTATION_INDEX, sum[ABSOLUTE] / turn, angle, outcome);
}

/* The functional of arclength. */
static void functional(const struct ph_curve *curve, size_t intervals,
                       const struct ph_diagnostics *d,
                       struct gate_outcome *outcome) {
  real sum = 0, terms = 0, h, x;
  real mean = ((real)curve->knots[curve->n] - curve->knots[0]) / intervals;
  for (size_t k = 0; k < curve->n; k++) {
    struct segment s;
    load(curve, k, &s);
    h = ((real)curve->knots[k + 1] - curve->knots[k]) / mean;
    for (size_t j = 0; j < 4; j++) {
      x = 2 * (s.a[0][j] - 2 * s.a[1][j] + s.a[2][j]);
      sum += x * x / (h * h * h * h);
      x = fabsl(s.a[0][j]) + 2 * fabsl(s.a[1][j]) + fabsl(s.a[2][j]);
      terms += 1e-6L * x * x / (h * h * h * h);
    }
  }
  claim(d, PH_D_F, sum, sum + terms, outcome);
}

/* ---- speed and curvature at places ----------------------------------------
 */

/* By how much the curvature at t is off, at most, where rounding moves each
 * coefficient of the preimage by a part of the largest:
 *   |dw| <= e, |dw'| <= 2 (n - 1) e, kappa = 2 Im(w* w') / sigma^2 */
static real loose(const struct segment *s, real t, real sigma, real kappa) {
  real w[3][4], e = 0, size = sqrtl(sigma), rate;
  jet(s, t, w);
  rate = sqrtl(dot(w[1], w[1], s->dimension));
  for (size_t i = 0; i < s->n; i++) {
    e = fmaxl(e, ROUNDING * sqrtl(dot(s->a[i], s->a[i], s->dimension)));
  }
  return 2 * e * (rate + 2 * (real)(s->n - 1) * size) / (sigma * sigma) +
         4 * fabsl(kappa) * e / size;
}

static void extremes(const struct ph_curve *curve,
                     const struct ph_diagnostics *d,
                     struct gate_outcome *outcome) {
  real least = LDBL_MAX, most = 0;
  for (size_t k = 0; k < curve->n; k++) {
    struct segment s;
    load(curve, k, &s);
    for (int i = 0; i <= PLACES; i++) {
      real sigma, kappa, slope;
      bend(&s, s.end * i / PLACES, &sigma, &kappa, &slope);
      kappa = fabsl(kappa) - loose(&s, s.end * i / PLACES, sigma, kappa);
      most = kappa > most ? kappa : most;
      sigma /= (real)curve->knots[k + 1] - curve->knots[k];
      least = sigma < least ? sigma : least;
    }
  }
  least *= ((real)curve->knots[curve->n] - curve->knots[0]) / curve->length;
  if (d->known >> PH_D_MIN_SPEED & 1 &&
      !(d->value[PH_D_MIN_SPEED] <= least + SAME &&
        d->value[PH_D_MIN_SPEED] >= 0.8L * least - 1e-3L)) {
    gate_wrong(outcome, "brute min_speed", "%.17g is claimed, %.17g was found",
               d->value[PH_D_MIN_SPEED], (double)least);
  }
  if (d->known >> PH_D_MAX_CURVATURE & 1 &&
      !(d->value[PH_D_MAX_CURVATURE] + SAME / curve->length >=
        most * (1 - SAME))) {
    gate_wrong(outcome, "brute max_curvature",
               "%.17g is claimed, %.17g was found",
               d->value[PH_D_MAX_CURVATURE], (double)most);
  }
}

/* ---- polygons ---------------------------------------------------------------
 */

/* A point of segment k, seen from the first control point of all. */
static void point(const struct ph_curve *curve, size_t k, real t, real *p) {
  const double *c = ph_curve_points(curve, k);
  real b[6][2];
  for (size_t j = 0; j <= curve->degree; j++) {
    b[j][0] = c[2 * j] - (real)curve->control_points[0];
    b[j][1] = c[2 * j + 1] - (real)curve->control_points[1];
  }
  for (size_t n = curve->degree; n > 0; n--) {
    for (size_t j = 0; j < n; j++) {
      b[j][0] += t * (b[j + 1][0] - b[j][0]);
      b[j][1] += t * (b[j + 1][1] - b[j][1]);
    }
  }
  p[0] = b[0][0];
  p[1] = b[0][1];
}

/* Points of the curve, exactly as far as needed; n * PLACES + 1 of them. */
static size_t polygon(const struct ph_curve *curve, real *p) {
  size_t m = 0;
  for (size_t k = 0; k < curve->n; k++) {
    for (int i = 0; i < PLACES; i++, m++) {
      point(curve, k, (real)i / PLACES, p + 2 * m);
    }
  }
  return m;
}

static real side(const real *a, const real *b, const real *c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/* Whether two edges cross, inside both by this part of them. */
static bool crosses(const real *a, const real *b, real inside) {
  real x = side(a, a + 2, b), y = side(a, a + 2, b + 2);
  real u = side(b, b + 2, a), v = side(b, b + 2, a + 2);
  return x * y < 0 && u * v < 0 && fabsl(x) > inside * fabsl(x - y) &&
         fabsl(y) > inside * fabsl(x - y) && fabsl(u) > inside * fabsl(u - v) &&
         fabsl(v) > inside * fabsl(u - v);
}

static const real INSIDE = 0.05L;

/* Points of edge i of that polygon, finer: PIECES + 1 of them. */
enum { PIECES = 32, FINER = 2 };

static void finer(const struct ph_curve *curve, size_t i, real from, real to,
                  real *p) {
  const real first = (real)(i % PLACES);
  for (int j = 0; j <= PIECES; j++) {
    const real x = from + (to - from) * j / PIECES;
    point(curve, i / PLACES, (first + x) / PLACES, p + 2 * j);
  }
}

/* Whether parts of edges i and k still cross where these are finer, so many
 * times: about a sharp turn edges cross that the curve does not follow. */
static bool still_cross(const struct ph_curve *curve, size_t i,
                        const real of_i[2], size_t k, const real of_k[2],
                        int times) {
  real p[2 * (PIECES + 1)], q[2 * (PIECES + 1)];
  bool cross = times == 0;
  finer(curve, i, of_i[0], of_i[1], p);
  finer(curve, k, of_k[0], of_k[1], q);
  for (int j = 0; j < PIECES && !cross; j++) {
    for (int l = 0; l < PIECES && !cross; l++) {
      const real a = (of_i[1] - of_i[0]) / PIECES;
      const real b = (of_k[1] - of_k[0]) / PIECES;
      const real in[2] = {of_i[0] + a * j, of_i[0] + a * (j + 1)};
      const real on[2] = {of_k[0] + b * l, of_k[0] + b * (l + 1)};
      cross = crosses(p + 2 * j, q + 2 * l, 0) &&
              still_cross(curve, i, in, k, on, times - 1);
    }
  }
  return cross;
}

static void crossings(const struct ph_curve *curve,
                      const struct ph_diagnostics *d,
                      struct gate_outcome *outcome) {
  static _Thread_local real p[2 * (SEGMENTS * PLACES + 1)];
  const real whole[2] = {0, 1};
  size_t n;
  bool looped[SEGMENTS] = {false}, simple = true;
  double loops = 0;
  if (curve->n > SEGMENTS || curve->kind == PH_CURVE_ATPH ||
      !(d->known >> PH_D_SIMPLE & 1)) {
    return;
  }
  n = polygon(curve, p);
  for (size_t i = 0; i + 1 < n; i++) {
    for (size_t j = i + 8; j + 1 < n; j++) {
      if (crosses(p + 2 * i, p + 2 * j, INSIDE) &&
          still_cross(curve, i, whole, j, whole, FINER)) {
        simple = false;
        looped[i / PLACES] =
            looped[i / PLACES] || i / PLACES == (j + 1) / PLACES;
      }
    }
  }
  for (size_t k = 0; k < curve->n; k++) {
    loops += looped[k];
  }
  if (!simple && d->value[PH_D_SIMPLE] > 0) {
    gate_wrong(outcome, "brute simple", "the curve crosses itself");
  }
  if (d->known >> PH_D_LOOPS & 1 && loops > d->value[PH_D_LOOPS]) {
    gate_wrong(outcome, "brute loops", "%g are claimed, %g were found",
               d->value[PH_D_LOOPS], loops);
  }
}

/* ---- all --------------------------------------------------------------------
 */

static void look_at(const struct ph_curve *curve, size_t intervals,
                    const struct ph_diagnostics *d,
                    struct gate_outcome *outcome) {
  if (!curve->preimage.v) {
    return;
  }
  energies(curve, d, outcome);
  extremes(curve, d, outcome);
  functional(curve, intervals ? intervals : curve->n, d, outcome);
  if (curve->dimension == 2) {
    crossings(curve, d, outcome);
  }
}

void gate_brute(const struct ph_result *result, struct gate_outcome *outcome) {
  look_at(&result->curve, result->intervals_n, &result->diagnostics, outcome);
  for (size_t i = 0; i < result->solutions_n; i++) {
    const struct ph_solution *s = &result->solutions[i];
    look_at(&s->curve, result->intervals_n, &s->diagnostics, outcome);
  }
}
