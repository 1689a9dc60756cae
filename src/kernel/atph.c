/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Preimages of PH and ATPH segments (see atph.h).
 *
 * The integrals (3) have closed forms that lose eps/a^5 [GON18, (2.5)]:
 *
 *   mu1 = n1 / (8 s^4 a),  mu2 = n2 / (8 s^4 a),  s = sin(a/2)
 *   n1 = c (sin a - 3 a) + 4 s,  n2 = (2 + cos a) a - 3 sin a
 *
 * Their power series alternate, but converge so fast that all digits are right
 * on all of [0, pi):
 *
 *   n1 / a^5 = sum_{k>=2} (-1)^k (3^(2k+1)/2 + 9/2 - 6 (2k+1))
 *                               / ((2k+1)! 2^(2k+1)) a^(2k-4)           (4)
 *   n2 / a^5 = sum_{k>=2} (-1)^k (2k-2) / (2k+1)! a^(2k-4)              (5)
 *
 * and n0 = 6 n2 + 4 c n1, a sum of positive terms, gives mu0 without a third.
 */
#include "kernel/atph.h"

enum { TERMS = 17 };

/* Coefficients of (4) and (5) for k = 2, 3, ...  Printed by Python with
 * fractions.Fraction and math.factorial as f, correctly rounded:
 *   for k in range(2, 19):
 *     n = 2*k + 1
 *     print(float(Fraction((-1)**k * (3**n + 9 - 12*n), 2 * f(n) * 2**n)),
 *           float(Fraction((-1)**k * (2*k - 2), f(n))))                  */
static const double N1[TERMS] = {0.025,
                                 -0.001636904761904762,
                                 5.270337301587302e-05,
                                 -1.0827208092833092e-06,
                                 1.5625575114507407e-08,
                                 -1.6743031850686242e-10,
                                 1.3850078577405869e-12,
                                 -9.111905842871076e-15,
                                 4.8813789364898285e-17,
                                 -2.1705736820349106e-19,
                                 8.139651327920275e-22,
                                 -2.6088626058908948e-24,
                                 7.228991211167482e-27,
                                 -1.748949486580389e-29,
                                 3.726454871977191e-32,
                                 -7.045818035251425e-35,
                                 1.1901719654141007e-37};
static const double N2[TERMS] = {
    0.016666666666666666,    -0.0007936507936507937,  1.6534391534391536e-05,
    -2.0041686708353376e-07, 1.6059043836821615e-09,  -9.17659647818378e-12,
    3.936040156083729e-14,   -1.3153016394598927e-16, 3.523129391410427e-19,
    -7.736340341261368e-22,  1.4183290625645841e-24,  -2.204085567310931e-27,
    2.9405903504764064e-30,  -3.4051501163498504e-33, 3.4549006862315854e-36,
    -3.096829746762205e-39,  2.4702564609120444e-42};

/* Terms that reach full precision up to an angle: the last term is below
 * 1e-17 of the sum. */
static size_t terms_for(double a) {
  return !(a > 0) ? 1 : a <= 0.25 ? 6 : a <= 1 ? 9 : a <= 2.1 ? 13 : TERMS;
}

static double sinc(double x) {
  /* x^4/120 is below rounding there. */
  return x < 1e-4 ? 1 - x * x / 6 : sin(x) / x;
}

struct ph_atph ph_atph_of(double angle) {
  struct ph_atph space;
  double x = angle * angle, n1 = 0, n2 = 0, scale, c;
  for (size_t k = terms_for(angle); k-- > 0;) {
    n1 = n1 * x + N1[k];
    n2 = n2 * x + N2[k];
  }
  c = angle > 0 ? cos(angle / 2) : 1;
  space.angle = angle;
  space.c = c;
  space.sinc = sinc(angle / 2);
  space.slope = c / space.sinc;
  scale = 1 / (space.sinc * space.sinc * space.sinc * space.sinc);
  space.q[0] = (6 * n2 + 4 * c * n1) * scale;
  space.q[1] = 8 * c * n1 * scale;
  space.q[2] = 8 * c * c * n2 * scale;
  space.q[3] = 4 * n2 * scale;
  return space;
}

void ph_atph_basis(const struct ph_atph *space, double u, double s[2]) {
  s[0] = (1 - u) * sinc(space->angle * (1 - u) / 2) / space->sinc;
  s[1] = u * sinc(space->angle * u / 2) / space->sinc;
}

/* Both at once, as compilers find out where both are of the same number. */
static double sinc_and_cos(double x, double *c) {
  const double s = sin(x);
  *c = cos(x);
  return x < 1e-4 ? 1 - x * x / 6 : s / x;
}

/* S0, S1 and their derivatives. */
static void basis_jet(const struct ph_atph *space, double u, double s[4][2]) {
  double factor = -space->angle * space->angle / 4; /* S'' = factor S */
  double left, right;
  s[0][0] =
      (1 - u) * sinc_and_cos(space->angle * (1 - u) / 2, &left) / space->sinc;
  s[0][1] = u * sinc_and_cos(space->angle * u / 2, &right) / space->sinc;
  s[1][0] = -left / space->sinc;
  s[1][1] = right / space->sinc;
  for (size_t i = 0; i < 2; i++) {
    s[2][i] = factor * s[0][i];
    s[3][i] = factor * s[1][i];
  }
}

/* The same by one sine and cosine, with errors of rounding in S0 and S0' by 1,
 * not by what they are; for every angle but 0. */
static void basis_jet_at_once(const struct ph_atph *space, double u,
                              double s[4][2]) {
  const double half = space->angle / 2, factor = -half * half;
  const double sine = half * space->sinc, by_sine = 1 / sine;
  const double right = sin(half * u), right_cos = cos(half * u);
  s[0][0] = right_cos - space->c * right * by_sine;
  s[0][1] = right * by_sine;
  s[1][0] = -(space->c * right_cos + sine * right) / space->sinc;
  s[1][1] = right_cos / space->sinc;
  for (size_t i = 0; i < 2; i++) {
    s[2][i] = factor * s[0][i];
    s[3][i] = factor * s[1][i];
  }
}

static const double BINOMIAL[4][4] = {
    {1, 0, 0, 0}, {1, 1, 0, 0}, {1, 2, 1, 0}, {1, 3, 3, 1}};

/* Leibniz's rule for each product of two of them. */
void ph_atph_jet_by_basis(const struct ph_atph *space, const ph_cplx *w,
                          double u, ph_cplx *jet, size_t n) {
  double s[4][2];
  basis_jet(space, u, s);
  for (size_t d = 0; d < n; d++) {
    double b[3] = {0, 0, 0};
    for (size_t i = 0; i <= d; i++) {
      b[0] += BINOMIAL[d][i] * s[i][0] * s[d - i][0];
      b[1] += BINOMIAL[d][i] * s[i][0] * s[d - i][1];
      b[2] += BINOMIAL[d][i] * s[i][1] * s[d - i][1];
    }
    b[1] *= 2 * space->c;
    jet[d].re = b[0] * w[0].re + b[1] * w[1].re + b[2] * w[2].re;
    jet[d].im = b[0] * w[0].im + b[1] * w[1].im + b[2] * w[2].im;
  }
}

/*
 * S0 depends on a and 1-u nearly only by their product, S1 on a and u:
 *   a dS0/da = -(1-u) S0' - slope S0,  a dS1/da = u S1' - slope S1
 * and derivatives of that by u.
 */
static void change_jet(const struct ph_atph *space, double u,
                       const double s[4][2], double t[3][2]) {
  for (size_t d = 0; d < 3; d++) {
    t[d][0] =
        -(1 - u) * s[d + 1][0] - space->slope * s[d][0] + (double)d * s[d][0];
    t[d][1] = u * s[d + 1][1] - space->slope * s[d][1] + (double)d * s[d][1];
  }
}

/* factor times the product of two functions, with its derivatives. */
static inline void leibniz(double factor, const double p[3], const double q[3],
                           double product[3]) {
  product[0] = factor * (p[0] * q[0]);
  product[1] = factor * (p[0] * q[1] + p[1] * q[0]);
  product[2] = factor * (p[0] * q[2] + 2 * p[1] * q[1] + p[2] * q[0]);
}

/* Bernstein polynomials. */
static struct ph_atph_table table_of_ph(double u) {
  const double v = 1 - u;
  return (struct ph_atph_table){.b = {{v * v, 2 * (v * u), u * u},
                                      {-2 * v, 2 * (v - u), 2 * u},
                                      {2, -4, 2}}};
}

struct ph_atph_table ph_atph_table_of(const struct ph_atph *space, double u) {
  struct ph_atph_table table;
  double s[4][2], t[3][2], left[2][3], right[2][3], b[3][3], change[3][3];
  const double half = space->angle / 2, twice = 2 * space->c;
  const double twice_change = -2 * half * half * space->sinc;
  double other[3];
  if (!(space->angle > 0)) {
    return table_of_ph(u);
  }
  basis_jet_at_once(space, u, s);
  change_jet(space, u, (const double(*)[2])s, t);
  for (size_t d = 0; d < 3; d++) {
    left[0][d] = s[d][0];
    left[1][d] = t[d][0];
    right[0][d] = s[d][1];
    right[1][d] = t[d][1];
  }
  leibniz(1, left[0], left[0], b[0]);
  leibniz(1, left[0], right[0], b[1]);
  leibniz(1, right[0], right[0], b[2]);
  leibniz(2, left[0], left[1], change[0]);
  leibniz(twice, left[0], right[1], change[1]);
  leibniz(twice, left[1], right[0], other);
  leibniz(2, right[0], right[1], change[2]);
  for (size_t d = 0; d < 3; d++) {
    table.b[d][0] = b[0][d];
    table.b[d][1] = twice * b[1][d];
    table.b[d][2] = b[2][d];
    table.change[d][0] = change[0][d];
    table.change[d][1] = change[1][d] + other[d] + twice_change * b[1][d];
    table.change[d][2] = change[2][d];
  }
  return table;
}

double ph_atph_slope_change(const struct ph_atph *space) {
  /* With x = a/2: x (x cot x)' = x cot x - x^2 - (x cot x)^2. */
  double half = space->angle / 2;
  return 1 - space->slope - half * half / space->slope;
}

void ph_atph_q_change(const struct ph_atph *space, double change[4]) {
  double x = space->angle * space->angle, half = space->angle / 2;
  double n1 = 0, n2 = 0, n1_change = 0, n2_change = 0;
  double c = space->c, c_change = -half * half * space->sinc, scale;
  double scale_change = -4 * (c - space->sinc) / space->sinc; /* of the log */
  for (size_t k = terms_for(space->angle); k-- > 0;) {
    n1 = n1 * x + N1[k];
    n2 = n2 * x + N2[k];
    n1_change = n1_change * x + 2 * (double)k * N1[k];
    n2_change = n2_change * x + 2 * (double)k * N2[k];
  }
  scale = 1 / (space->sinc * space->sinc * space->sinc * space->sinc);
  change[0] = scale * (6 * n2_change + 4 * c * n1_change + 4 * c_change * n1);
  change[1] = scale * 8 * (c * n1_change + c_change * n1);
  change[2] = scale * 8 * (c * c * n2_change + 2 * c * c_change * n2);
  change[3] = scale * 4 * n2_change;
  for (size_t i = 0; i < 4; i++) {
    change[i] += scale_change * space->q[i];
  }
}

void ph_atph_part(const struct ph_atph *space, const ph_cplx w[3], double u0,
                  double u1, struct ph_atph *part, ph_cplx v[3]) {
  ph_cplx jet[2];
  double step;
  *part = ph_atph_of(space->angle * (u1 - u0));
  ph_atph_jet(space, w, u1, &v[2], 1);
  ph_atph_jet(space, w, u0, jet, 2);
  v[0] = jet[0];
  step = (u1 - u0) / (2 * part->slope);
  v[1] = ph_cplx_add(jet[0], ph_cplx_scale(step, jet[1]));
}
