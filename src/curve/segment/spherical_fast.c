/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * S, S' and S'' of a spherical Bezier segment (see spherical_fast.h).
 *
 * As in spherical.c, a step of de Casteljau's algorithm joins u and w, with
 * m = (u + w) / 2, d = (w - u) / 2, E = |d|^2 = sin^2(phi), sigma = 2 t - 1, by
 *   Z = A m + B d,   A = cos(sigma phi) / cos(phi),                     (1)
 *                    B = sin(sigma phi) / sin(phi) = sigma b.
 * Instead of carrying derivatives by t through the series of A and B, these are
 * seen as functions of sigma and E, whose derivatives follow from those of
 * b by E and from H = phi / (sin(phi) cos(phi)) [derived here]:
 *   A = b + 2 E b_E,   A_E = 3 b_E + 2 E b_EE,                          (2)
 *   A_EE = (3 A_E - sigma^2 b_E) / (2 (1 - E)),
 *   A_sigma = -E H B,   B_sigma = (1 - E) H A,                          (3)
 *   A_sigma sigma = -phi^2 A,   B_sigma sigma = -phi^2 B,
 *   phi^2 = E (1 - E) H^2,   2 E (1 - E) H_E = 1 - (1 - 2 E) H.         (4)
 * Near, b and H_E are power series; with y = 1 - sigma^2 = 4 t (1 - t),
 *   b = sum_k b_k E^k,   b_k = b_{k-1} (4k (k - 1) + y) / (2k (2k + 1)),
 *   H = sum_k h_k E^k,   h_k = h_{k-1} 2k / (2k + 1),                   (5)
 * so that nothing is divided by what may be small; elsewhere (1), (2) and (4)
 * give them from sines and cosines, and lose two digits of b_EE at most.
 *
 * Between control points E is fixed, and A - 1 and b - 1 are polynomials in y
 * to rounding: by f_n of s2.h, with Q = phi^2 and f_{-1} = cos(phi),
 *   A = sum_k (Q/2)^k f_{k-1} / (k! f_{-1}) y^k,
 *   b = sum_k (Q/2)^k f_k / (k! f_0) y^k;                               (6)
 *   Z' = -theta tan(phi) B m + theta cot(phi) A d,  theta = 2 phi,
 *   Z'' = -theta^2 Z.                                                   (7)
 *
 * Points are carried as displacements U, W from the first control point, or,
 * from the middle on, from the last one, P:
 *   Z = P + (A - 1) P + (A - B)/2 U + (A + B)/2 W,                      (8)
 * in which no large terms cancel: next to an end at rest, S' is known to a
 * relative error of rounding.
 */
#include "curve/segment/spherical_fast.h"

#include "kernel/s2.h"

#include <float.h>
#include <stdbool.h>

/* Terms of (5) at most, which suffice below NEAR. */
enum { TERMS = 20 };
static const double NEAR = 0x1p-3;

/* ---- functions of sigma and E -------------------------------------------- */

/* 1 / (2k (2k + 1)) */
static const double inverse[TERMS] = {
    0,         1.0 / 6,    1.0 / 20,   1.0 / 42,   1.0 / 72,
    1.0 / 110, 1.0 / 156,  1.0 / 210,  1.0 / 272,  1.0 / 342,
    1.0 / 420, 1.0 / 506,  1.0 / 600,  1.0 / 702,  1.0 / 812,
    1.0 / 930, 1.0 / 1056, 1.0 / 1190, 1.0 / 1332, 1.0 / 1482};

/* k h_k */
static const double slope[TERMS + 2] = {0,
                                        2.0 / 3,
                                        16.0 / 15,
                                        48.0 / 35,
                                        512.0 / 315,
                                        1280.0 / 693,
                                        2048.0 / 1001,
                                        14336.0 / 6435,
                                        262144.0 / 109395,
                                        589824.0 / 230945,
                                        2621440.0 / 969969,
                                        5767168.0 / 2028117,
                                        50331648.0 / 16900975,
                                        109051904.0 / 35102025,
                                        469762048.0 / 145422675,
                                        67108864.0 / 20036013,
                                        34359738368.0 / 9917826435,
                                        73014444032.0 / 20419054425,
                                        103079215104.0 / 27981667175,
                                        652835028992.0 / 172308161025,
                                        1099511627776.0 / 282585384081,
                                        3848290697216.0 / 964378691705};

/* ---- one place ----------------------------------------------------------- */

#define REAL double
#define NAME(name) one_##name

struct one_basis;
struct one_functions;
struct one_jet;
static void far(const struct one_basis *basis, double e,
                const struct one_jet *u, const struct one_jet *w,
                struct one_functions *f);

static inline bool one_all_less(double x, double y) {
  return x < y;
}

#include "curve/segment/spherical_fast.def"

/* By (1), (2) and (4), from |m| too. */
static void far(const struct one_basis *basis, double e,
                const struct one_jet *u, const struct one_jet *w,
                struct one_functions *f) {
  const ph_vec3 sum =
      ph_vec3_of(u->v.x + w->v.x, u->v.y + w->v.y, u->v.z + w->v.z);
  const double m = ph_vec3_abs(ph_vec3_along(basis->base, 0.5, sum));
  const double sine = sqrt(e), phi = atan2(sine, m), z = basis->sigma * phi;
  const double square = m * m, a = cos(z) / m;
  const double b = ph_s2_f0(z * z) * phi / sine, whole = 2 * sine * m;
  const double ae = (a - (1 - basis->y) * b) / (2 * square);
  f->a = 2 * sin(basis->t * phi) * sin(basis->s * phi) / m;
  f->before = sin(2 * basis->s * phi) / whole;
  f->after = sin(2 * basis->t * phi) / whole;
  f->b = b;
  f->b1 = (a - b) / (2 * e);
  f->b2 = (ae - 3 * f->b1) / (2 * e);
  f->h = phi / (sine * m);
  f->h1 = (1 - (1 - 2 * e) * f->h) / (2 * e * square);
}

static size_t end_of(double t) {
  return t < 0.5 ? 0 : 3;
}

void ph_spherical_fast_jet(const struct ph_spherical_fast *fast, double t,
                           ph_vec3 jet[3]) {
  const size_t end = end_of(t);
  const ph_vec3 base = fast->segment.p[end];
  struct one_jet z;
  one_curve(fast, t, end, &z);
  jet[0] = ph_vec3_of(base.x + z.v.x, base.y + z.v.y, base.z + z.v.z);
  jet[1] = ph_vec3_of(z.first.x, z.first.y, z.first.z);
  jet[2] = ph_vec3_of(z.second.x, z.second.y, z.second.z);
}

/* ---- several places ------------------------------------------------------ */

#if defined(__GNUC__) && !defined(PH_SPHERICAL_FAST_ONE)

#define LANES PH_SPHERICAL_FAST_LANES
typedef double lanes __attribute__((vector_size(LANES * sizeof(double))));
#define REAL lanes
#define NAME(name) some_##name

static inline bool some_all_less(lanes x, double y) {
  bool all = true;
  for (size_t i = 0; i < LANES; i++) {
    all = all && x[i] < y;
  }
  return all;
}

#include "curve/segment/spherical_fast.def"

void ph_spherical_fast_jets(const struct ph_spherical_fast *fast,
                            const double t[], ph_vec3 jet[][3]) {
  const size_t end = end_of(t[0]);
  const ph_vec3 base = fast->segment.p[end];
  struct some_jet z;
  bool same = true;
  lanes at;
  for (size_t i = 0; i < LANES; i++) {
    at[i] = t[i];
    same = same && end_of(t[i]) == end;
  }
  same = same && some_curve(fast, at, end, &z);
  for (size_t i = 0; i < LANES; i++) {
    if (same) {
      jet[i][0] =
          ph_vec3_of(base.x + z.v.x[i], base.y + z.v.y[i], base.z + z.v.z[i]);
      jet[i][1] = ph_vec3_of(z.first.x[i], z.first.y[i], z.first.z[i]);
      jet[i][2] = ph_vec3_of(z.second.x[i], z.second.y[i], z.second.z[i]);
    } else {
      ph_spherical_fast_jet(fast, t[i], jet[i]);
    }
  }
}

#else

void ph_spherical_fast_jets(const struct ph_spherical_fast *fast,
                            const double t[], ph_vec3 jet[][3]) {
  for (size_t i = 0; i < PH_SPHERICAL_FAST_LANES; i++) {
    ph_spherical_fast_jet(fast, t[i], jet[i]);
  }
}

#endif

/* ---- preparation --------------------------------------------------------- */

/* Terms of (5) for all E <= e: the first one left out, of second derivatives
 * too, is rounding. */
static size_t terms_for(double e) {
  return e < 0x1p-15   ? 4
         : e < 0x1p-10 ? 6
         : e < 0x1p-8  ? 8
         : e < 0x1p-6  ? 10
         : e < 0x1p-5  ? 12
         : e < 0x1p-4  ? 15
                       : TERMS;
}

/* Terms of the cosine of angles with phi^2 <= q, up to rounding. */
static size_t arc_terms_for(double q) {
  double term = 1;
  size_t n = 1;
  while (n < PH_SPHERICAL_FAST_TERMS && term > DBL_EPSILON / 32) {
    double two = (double)(2 * n);
    term *= q / (two * (two - 1));
    n++;
  }
  return n;
}

/* (2) of s2.h: f_n, where n is so large that few terms are enough. */
static double f_of(size_t n, double x) {
  enum { ENOUGH = 8 };
  double sum = 0, term = 1;
  for (size_t k = 1; k <= n; k++) {
    term /= (double)(2 * k + 1);
  }
  for (size_t k = 1; k <= ENOUGH; k++) {
    sum += term;
    term *= -0.5 * x / (double)(k * (2 * n + 2 * k + 1));
  }
  return sum;
}

/* (6) and (7); by (3) of s2.h downward. */
static void arc_of(ph_vec3 u, ph_vec3 w, struct ph_spherical_fast_arc *arc) {
  enum { N = PH_SPHERICAL_FAST_TERMS };
  const ph_vec3 m = ph_vec3_scale(0.5, ph_vec3_add(u, w));
  const ph_vec3 d = ph_vec3_scale(0.5, ph_vec3_sub(w, u));
  const double phi = 0.5 * ph_s2_angle(u, w), q = phi * phi;
  double f[N + 1], factor = 1, cosine = ph_vec3_abs(m);
  f[N] = f_of(N, q);
  f[N - 1] = f_of(N - 1, q);
  for (size_t n = N - 1; n > 0; n--) {
    f[n - 1] = (double)(2 * n + 1) * f[n] - q * f[n + 1];
  }
  for (size_t k = 1; k <= N; k++) {
    factor *= 0.5 * q / (double)k;
    arc->a[k - 1] = factor * f[k - 1] / cosine;
    arc->b[k - 1] = factor * f[k] / f[0];
  }
  arc->square = 4 * q;
  arc->dm = ph_vec3_scale(-2 * q * f[0] / cosine, m);
  arc->dd = ph_vec3_scale(2 * cosine / f[0], d);
}

void ph_spherical_fast_of(const struct ph_spherical *segment,
                          struct ph_spherical_fast *fast) {
  const ph_vec3 *p = segment->p;
  double e = 0, q = 0;
  fast->segment = *segment;
  for (size_t k = 0; k < 4; k++) {
    fast->at[0][k] = ph_vec3_sub(p[k], p[0]);
    fast->at[1][k] = ph_vec3_sub(p[k], p[3]);
  }
  for (size_t k = 0; k < 3; k++) {
    ph_vec3 d = ph_vec3_sub(p[k + 1], p[k]);
    arc_of(p[k], p[k + 1], &fast->arc[k]);
    e = fmax(e, 0.25 * ph_vec3_dot(d, d));
    q = fmax(q, 0.25 * fast->arc[k].square);
  }
  fast->terms = terms_for(e);
  fast->arc_terms = arc_terms_for(q);
}
