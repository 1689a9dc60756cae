/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Cubic spherical Bezier segments (see spherical.h).
 *
 * One step of de Casteljau's algorithm joins u and w, an angle theta apart.
 * With m = (u + w) / 2, d = (w - u) / 2, phi = theta / 2, sigma = 2 t - 1,
 *   Z = A m + B d,   A = cos(sigma phi) / cos(phi),                     (1)
 *                    B = sin(sigma phi) / sin(phi),
 * the same as with the usual weights of u and w, but symmetric, and good for
 * points that are near: what is carried along is the displacement from p[0],
 * so that d is a difference of small vectors, to a relative error of rounding.
 *
 * A and B are smooth in E = |d|^2 = sin^2(phi).  Near, they are power series,
 *   A = sum_k (2 k + 1) b_k E^k,   B = sigma sum_k b_k E^k,             (2)
 *   b_k = product_{j=1..k} ((2 j - 1)^2 - sigma^2) / (2 j (2 j + 1)),
 * the b_k common to all steps.  Elsewhere, with Q = phi^2, Y = sigma^2 Q, the
 * functions f_n of s2.h, and f_{-1}(X) = f_0 - X f_1 = cos sqrt(X),
 *   A = f_{-1}(Y) / f_{-1}(Q),   B = sigma f_0(Y) / f_0(Q),             (3)
 *   E = Q f_0(Q)^2,   dE/dQ = f_{-1}(Q) f_0(Q),   f_n' = -f_{n+1} / 2.  (4)
 * Derivatives with respect to t follow the rules of products and chains.  What
 * depends on their order is written once, and compiled for every order that is
 * used (PH_INLINE).
 */
#include "curve/segment/spherical.h"

#include "base/inline.h"
#include "curve/segment/spherical_net.h"
#include "kernel/s2.h"

/* Derivatives of order 0, ..., order of a number, of a point (for the point
 * itself, its displacement); the others are undefined. */
struct scalar {
  double v[4];
};

struct jet {
  ph_vec3 d[4];
};

/* (2) is used below NEAR, with terms by the greatest E of neighbours. */
enum { TERMS = 11 };
static const double NEAR = 0x1p-6;

/* What is common to all steps at a parameter: sigma, and the coefficients of
 * (2). */
struct basis {
  double sigma;
  size_t terms;
  struct scalar a[TERMS], b[TERMS];
};

/* A - 1 and B. */
struct weights {
  struct scalar a, b;
};

/* -------------------------------------------------------------------------- */
/* Numbers with derivatives                                                   */
/* -------------------------------------------------------------------------- */

/* c + p e */
PH_INLINE struct scalar along(const struct scalar *c, const struct scalar *p,
                              const struct scalar *e, int order) {
  struct scalar q;
  const double *u = p->v, *w = e->v;
  q.v[0] = c->v[0] + u[0] * w[0];
  if (order >= 1) {
    q.v[1] = c->v[1] + (u[1] * w[0] + u[0] * w[1]);
  }
  if (order >= 2) {
    q.v[2] = c->v[2] + (u[2] * w[0] + 2 * u[1] * w[1] + u[0] * w[2]);
  }
  if (order >= 3) {
    q.v[3] =
        c->v[3] + (u[3] * w[0] + 3 * (u[2] * w[1] + u[1] * w[2]) + u[0] * w[3]);
  }
  return q;
}

/* f_n(x), where f[0], ..., f[3] are f_n, ..., f_{n+3} there. */
PH_INLINE struct scalar chain(const double *f, const struct scalar *x,
                              int order) {
  const double *u = x->v;
  double f1 = -f[1] / 2, f2 = f[2] / 4;
  struct scalar s;
  s.v[0] = f[0];
  if (order >= 1) {
    s.v[1] = f1 * u[1];
  }
  if (order >= 2) {
    s.v[2] = f2 * u[1] * u[1] + f1 * u[2];
  }
  if (order >= 3) {
    double f3 = -f[3] / 8;
    s.v[3] = (f3 * u[1] * u[1] + 3 * f2 * u[2]) * u[1] + f1 * u[3];
  }
  return s;
}

PH_INLINE struct scalar quotient(const struct scalar *a, const struct scalar *b,
                                 int order) {
  const double *u = a->v, *w = b->v;
  double inverse = 1 / w[0];
  double q0 = u[0] * inverse;
  struct scalar s;
  s.v[0] = q0;
  if (order >= 1) {
    s.v[1] = (u[1] - q0 * w[1]) * inverse;
  }
  if (order >= 2) {
    s.v[2] = (u[2] - q0 * w[2] - 2 * s.v[1] * w[1]) * inverse;
  }
  if (order >= 3) {
    s.v[3] = (u[3] - q0 * w[3] - 3 * (s.v[1] * w[2] + s.v[2] * w[1])) * inverse;
  }
  return s;
}

/* sigma x, sigma' = 2 */
PH_INLINE struct scalar times_sigma(double sigma, const struct scalar *x,
                                    int order) {
  struct scalar s;
  s.v[0] = sigma * x->v[0];
  if (order >= 1) {
    s.v[1] = sigma * x->v[1] + 2 * x->v[0];
  }
  if (order >= 2) {
    s.v[2] = sigma * x->v[2] + 4 * x->v[1];
  }
  if (order >= 3) {
    s.v[3] = sigma * x->v[3] + 6 * x->v[2];
  }
  return s;
}

/* -------------------------------------------------------------------------- */
/* The weights A and B                                                        */
/* -------------------------------------------------------------------------- */

/* The coefficients of (2): b_k is b_{k-1} times a quadratic polynomial. */
PH_INLINE void basis_of(double t, size_t terms, int order,
                        struct basis *basis) {
  double sigma = 2 * t - 1, square = sigma * sigma;
  const struct scalar none = {{0, 0, 0, 0}};
  struct scalar last = {{1, 0, 0, 0}};
  basis->sigma = sigma;
  basis->terms = terms;
  basis->a[0] = basis->b[0] = last;
  for (size_t k = 1; k < terms; k++) {
    static const double inverse[TERMS] = {
        0,         1.0 / 6,   1.0 / 20,  1.0 / 42,  1.0 / 72, 1.0 / 110,
        1.0 / 156, 1.0 / 210, 1.0 / 272, 1.0 / 342, 1.0 / 420};
    double odd = (double)(2 * k - 1), two = odd + 2;
    struct scalar factor = {{(odd * odd - square) * inverse[k],
                             -4 * sigma * inverse[k], -8 * inverse[k], 0}};
    last = along(&none, &last, &factor, order);
    basis->b[k] = last;
    for (int n = 0; n <= order; n++) {
      basis->a[k].v[n] = two * last.v[n];
    }
  }
}

/* By (2), from E. */
PH_INLINE struct weights near_weights(const struct basis *basis,
                                      const struct scalar *e, int order) {
  const struct scalar none = {{0, 0, 0, 0}};
  size_t k = basis->terms - 1;
  struct scalar a = basis->a[k], b = basis->b[k];
  struct weights w;
  while (--k > 0) {
    a = along(&basis->a[k], &a, e, order);
    b = along(&basis->b[k], &b, e, order);
  }
  w.a = along(&none, &a, e, order);
  b = along(&basis->b[0], &b, e, order);
  w.b = times_sigma(basis->sigma, &b, order);
  return w;
}

/* f_{-1}, f_0, ..., f_3 */
PH_INLINE void bessel(double x, double f[5]) {
  ph_s2_bessel(x, f + 1);
  f[0] = f[1] - x * f[2];
}

/* Q, from E, by (4); f: f_{-1}(Q), ..., f_3(Q). */
PH_INLINE struct scalar angle(const double f[5], double value,
                              const struct scalar *e, int order) {
  double p = 1 / (f[0] * f[1]);
  struct scalar q;
  q.v[0] = value;
  if (order >= 1) {
    q.v[1] = e->v[1] * p;
  }
  if (order >= 2) {
    double p1 = -(f[0] * f[2] + f[1] * f[1]) / 2;
    double s1 = p1 * q.v[1];
    q.v[2] = (e->v[2] - s1 * q.v[1]) * p;
    if (order >= 3) {
      double p2 = (f[0] * f[3] + 3 * f[1] * f[2]) / 4;
      double s2 = p2 * q.v[1] * q.v[1] + p1 * q.v[2];
      q.v[3] = (e->v[3] - 2 * s1 * q.v[2] - s2 * q.v[1]) * p;
    }
  }
  return q;
}

/* By (3), from E and m. */
PH_INLINE struct weights far_weights(double sigma, const struct scalar *e,
                                     ph_vec3 m, int order) {
  double size = ph_vec3_abs(m), phi = atan2(sqrt(e->v[0]), size);
  double f[5], g[5];
  struct scalar q, y, c, r;
  struct weights w;
  bessel(phi * phi, f);
  f[0] = size;
  q = angle(f, phi * phi, e, order);
  y = times_sigma(sigma, &q, order);
  y = times_sigma(sigma, &y, order);
  bessel(y.v[0], g);
  c = chain(f, &q, order);
  r = chain(g, &y, order);
  w.a = quotient(&r, &c, order);
  w.a.v[0] -= 1;
  c = chain(f + 1, &q, order);
  r = chain(g + 1, &y, order);
  r = quotient(&r, &c, order);
  w.b = times_sigma(sigma, &r, order);
  return w;
}

/* -------------------------------------------------------------------------- */
/* The steps                                                                  */
/* -------------------------------------------------------------------------- */

PH_INLINE ph_vec3 half_sum(ph_vec3 u, ph_vec3 w) {
  return ph_vec3_scale(0.5, ph_vec3_add(u, w));
}

PH_INLINE ph_vec3 half_difference(ph_vec3 u, ph_vec3 w) {
  return ph_vec3_scale(0.5, ph_vec3_sub(w, u));
}

/* (1) between fixed points: Z'' = -theta^2 Z. */
PH_INLINE void arc_step(const struct ph_spherical_arc *arc,
                        const struct basis *basis, int order, struct jet *z) {
  double a, b; /* A - 1 and B */
  if (basis->terms > 0) {
    struct scalar e = {{arc->e, 0, 0, 0}};
    struct weights w = near_weights(basis, &e, 0);
    a = w.a.v[0];
    b = w.b.v[0];
  } else {
    double f[5];
    bessel(basis->sigma * basis->sigma * arc->q, f);
    a = f[0] * arc->ic - 1;
    b = basis->sigma * f[1] * arc->ig;
  }
  z->d[0] = ph_vec3_along(ph_vec3_along(arc->mu, a, arc->m), b, arc->d);
  if (order >= 1) {
    z->d[1] = ph_vec3_along(ph_vec3_scale(-arc->a * b, arc->m),
                            arc->b * (1 + a), arc->d);
  }
  if (order >= 2) {
    ph_vec3 full = ph_vec3_along(ph_vec3_scale(1 + a, arc->m), b, arc->d);
    z->d[2] = ph_vec3_scale(-arc->square, full);
  }
  if (order >= 3) {
    z->d[3] = ph_vec3_scale(-arc->square, z->d[1]);
  }
}

/* sum_i binomial(n, i) x_{n-i} v_i, with v for v_0 */
PH_INLINE ph_vec3 product(const struct scalar *x, ph_vec3 v,
                          const struct jet *jet, int n) {
  ph_vec3 sum = ph_vec3_scale(x->v[n], v);
  if (n >= 2) {
    sum = ph_vec3_along(sum, n * x->v[n - 1], jet->d[1]);
  }
  if (n >= 3) {
    sum = ph_vec3_along(sum, n * x->v[n - 2], jet->d[2]);
  }
  return ph_vec3_along(sum, x->v[0], jet->d[n]);
}

/* Half the sum and half the difference. */
PH_INLINE void split(const struct jet *u, const struct jet *w, int order,
                     struct jet *mu, struct jet *d) {
  for (int n = 0; n <= order; n++) {
    mu->d[n] = half_sum(u->d[n], w->d[n]);
    d->d[n] = half_difference(u->d[n], w->d[n]);
  }
}

/* (1) between moving points. */
PH_INLINE void step(ph_vec3 base, const struct basis *basis,
                    const struct jet *u, const struct jet *w, int order,
                    struct jet *z) {
  struct jet mu, d;
  struct scalar e;
  struct weights k;
  ph_vec3 m;
  split(u, w, order, &mu, &d);
  m = ph_vec3_add(base, mu.d[0]);
  e.v[0] = ph_vec3_dot(d.d[0], d.d[0]);
  if (order >= 1) {
    e.v[1] = 2 * ph_vec3_dot(d.d[0], d.d[1]);
  }
  if (order >= 2) {
    e.v[2] = 2 * (ph_vec3_dot(d.d[0], d.d[2]) + ph_vec3_dot(d.d[1], d.d[1]));
  }
  if (order >= 3) {
    e.v[3] =
        2 * (ph_vec3_dot(d.d[0], d.d[3]) + 3 * ph_vec3_dot(d.d[1], d.d[2]));
  }
  k = basis->terms > 0 ? near_weights(basis, &e, order)
                       : far_weights(basis->sigma, &e, m, order);
  z->d[0] =
      ph_vec3_along(ph_vec3_along(mu.d[0], k.a.v[0], m), k.b.v[0], d.d[0]);
  k.a.v[0] += 1;
  for (int n = 1; n <= order; n++) {
    z->d[n] =
        ph_vec3_add(product(&k.a, m, &mu, n), product(&k.b, d.d[0], &d, n));
  }
}

/* -------------------------------------------------------------------------- */
/* Segments                                                                   */
/* -------------------------------------------------------------------------- */

/* theta^2 and theta / tan phi, by series: with phi = asin sqrt(E),
 *   dQ/dE = phi / (sin(phi) cos(phi)) = sum_k h_k E^k,
 *   h_k = h_{k-1} 2 k / (2 k + 1). */
PH_INLINE void near_arc(struct ph_spherical_arc *arc, size_t terms) {
  static const double h[TERMS] = {1.0,
                                  2.0 / 3,
                                  8.0 / 15,
                                  16.0 / 35,
                                  128.0 / 315,
                                  256.0 / 693,
                                  1024.0 / 3003,
                                  2048.0 / 6435,
                                  32768.0 / 109395,
                                  65536.0 / 230945,
                                  262144.0 / 969969};
  static const double integral[TERMS] = {1.0,
                                         1.0 / 3,
                                         8.0 / 45,
                                         4.0 / 35,
                                         128.0 / 1575,
                                         128.0 / 2079,
                                         1024.0 / 21021,
                                         256.0 / 6435,
                                         32768.0 / 984555,
                                         32768.0 / 1154725,
                                         262144.0 / 10669659};
  double sum = 0, q = 0;
  for (size_t k = terms; k-- > 0;) {
    sum = h[k] + arc->e * sum;
    q = integral[k] + arc->e * q;
  }
  arc->square = 4 * arc->e * q;
  arc->a = 2 * arc->e * sum;
  arc->b = 2 * (1 - arc->e) * sum;
}

PH_INLINE void far_arc(struct ph_spherical_arc *arc) {
  double c = ph_vec3_abs(arc->m), phi = atan2(sqrt(arc->e), c), f[4];
  arc->q = phi * phi;
  ph_s2_bessel(arc->q, f);
  arc->ic = 1 / c;
  arc->ig = 1 / f[0];
  arc->square = 4 * arc->q;
  arc->a = 2 * arc->q * f[0] * arc->ic;
  arc->b = 2 * c * arc->ig;
}

/* Terms of (2) for all E <= e. */
PH_INLINE size_t terms_for(double e) {
  return e < 0x1p-39   ? 2
         : e < 0x1p-26 ? 3
         : e < 0x1p-17 ? 5
         : e < 0x1p-11 ? 7
         : e < NEAR    ? TERMS
                       : 0;
}

/* at: control points as displacements from the first. */
static void make_net(const struct ph_spherical_legs *s, const ph_vec3 at[4],
                     struct ph_spherical_net *net) {
  double e = 0;
  net->base = s->s.p[0];
  for (size_t k = 0; k < 3; k++) {
    struct ph_spherical_arc *arc = &net->arc[k];
    arc->mu = half_sum(at[k], at[k + 1]);
    arc->m = half_sum(s->s.p[k], s->s.p[k + 1]);
    arc->d = ph_vec3_scale(0.5, s->leg[k]);
    arc->e = ph_vec3_dot(arc->d, arc->d);
    e = e < arc->e ? arc->e : e;
  }
  net->e = e;
  net->terms = terms_for(e);
  for (size_t k = 0; k < 3; k++) {
    if (net->terms > 0) {
      near_arc(&net->arc[k], net->terms);
    } else {
      far_arc(&net->arc[k]);
    }
  }
}

void ph_spherical_net_of(const struct ph_spherical *s,
                         struct ph_spherical_net *net) {
  struct ph_spherical_legs legs = ph_spherical_legs_of(s);
  ph_vec3 at[4];
  for (size_t k = 0; k < 4; k++) {
    at[k] = ph_vec3_sub(s->p[k], s->p[0]);
  }
  make_net(&legs, at, net);
}

void ph_spherical_net_of_legs(const struct ph_spherical_legs *s,
                              struct ph_spherical_net *net) {
  ph_vec3 at[4] = {{0, 0, 0}};
  for (size_t k = 0; k < 3; k++) {
    at[k + 1] = ph_vec3_add(at[k], s->leg[k]);
  }
  make_net(s, at, net);
}

/* The curve and its derivatives at t, by three steps, two, and one. */
PH_INLINE void net_jet(const struct ph_spherical_net *net, double t, int order,
                       struct jet *z) {
  struct basis basis;
  struct jet a, b, c;
  basis_of(t, net->terms, order, &basis);
  arc_step(&net->arc[0], &basis, order, &a);
  arc_step(&net->arc[1], &basis, order, &b);
  arc_step(&net->arc[2], &basis, order, &c);
  step(net->base, &basis, &a, &b, order, &a);
  step(net->base, &basis, &b, &c, order, &b);
  step(net->base, &basis, &a, &b, order, z);
}

ph_vec3 ph_spherical_net_velocity(const struct ph_spherical_net *net,
                                  double t) {
  struct jet z;
  net_jet(net, t, 1, &z);
  return z.d[1];
}

double ph_spherical_net_speed(const struct ph_spherical_net *net, double t) {
  return ph_vec3_abs(ph_spherical_net_velocity(net, t));
}

/* -------------------------------------------------------------------------- */
/* Points, derivatives, curvature                                             */
/* -------------------------------------------------------------------------- */

struct ph_spherical ph_spherical_of(const struct ph_curve *curve, size_t k) {
  const double *p = curve->control_points + 12 * k;
  ph_vec3 center = ph_vec3_get(curve->sphere.center, 3);
  struct ph_spherical s;
  for (size_t i = 0; i < 4; i++) {
    ph_vec3 v = ph_vec3_sub(ph_vec3_get(p + 3 * i, 3), center);
    s.p[i] = ph_vec3_unit(ph_vec3_scale(1 / curve->sphere.radius, v));
  }
  return s;
}

void ph_spherical_jet(const struct ph_spherical *s, double t, ph_vec3 jet[4]) {
  struct ph_spherical_net net;
  struct jet z;
  ph_spherical_net_of(s, &net);
  net_jet(&net, t, 3, &z);
  jet[0] = ph_vec3_add(net.base, z.d[0]);
  jet[1] = z.d[1];
  jet[2] = z.d[2];
  jet[3] = z.d[3];
}

/* (S x S') . S'' and, of order 3, (S x S') . S''' */
PH_INLINE void numerators(const struct ph_spherical_net *net, double t,
                          int order, double k[]) {
  struct jet z;
  ph_vec3 side;
  net_jet(net, t, order, &z);
  side = ph_vec3_cross(ph_vec3_add(net->base, z.d[0]), z.d[1]);
  for (int n = 2; n <= order; n++) {
    k[n - 2] = ph_vec3_dot(side, z.d[n]);
  }
}

double ph_spherical_net_numerator(const struct ph_spherical_net *net,
                                  double t) {
  double k[1];
  numerators(net, t, 2, k);
  return k[0];
}

void ph_spherical_net_numerators(const struct ph_spherical_net *net, double t,
                                 double k[2]) {
  numerators(net, t, 3, k);
}

void ph_spherical_numerator(const struct ph_spherical *s, double t,
                            double k[2]) {
  struct ph_spherical_net net;
  ph_spherical_net_of(s, &net);
  ph_spherical_net_numerators(&net, t, k);
}

/* The angle of a chord of the unit sphere from p. */
static double angle_of(ph_vec3 p, ph_vec3 chord) {
  ph_vec3 sum = ph_vec3_along(chord, 2, p);
  return 2 * atan2(ph_vec3_abs(chord), ph_vec3_abs(sum));
}

/* K at p, where the legs a and then b begin, and the angle of a. */
static double start(ph_vec3 p, ph_vec3 a, ph_vec3 b, double *angle) {
  double theta = angle_of(p, a), omega = angle_of(ph_vec3_add(p, a), b);
  double f = ph_s2_f0(theta * theta);
  *angle = theta;
  return 18 * ph_vec3_triple(p, a, b) / (f * f * ph_s2_f0(omega * omega));
}

static double first(const struct ph_spherical_legs *s, double *angle) {
  return start(s->s.p[0], s->leg[0], s->leg[1], angle);
}

static double last(const struct ph_spherical_legs *s, double *angle) {
  return -start(s->s.p[3], ph_vec3_scale(-1, s->leg[2]),
                ph_vec3_scale(-1, s->leg[1]), angle);
}

double ph_spherical_legs_numerator_start(const struct ph_spherical_legs *s) {
  double theta;
  return first(s, &theta);
}

double ph_spherical_legs_numerator_end(const struct ph_spherical_legs *s) {
  double theta;
  return last(s, &theta);
}

double ph_spherical_legs_curvature_start(const struct ph_spherical_legs *s) {
  double theta, k = first(s, &theta);
  return k / (27 * theta * theta * theta);
}

double ph_spherical_legs_curvature_end(const struct ph_spherical_legs *s) {
  double theta, k = last(s, &theta);
  return k / (27 * theta * theta * theta);
}

/* The same by points. */
#define BY_POINTS(what)                                      \
  double ph_spherical_##what(const struct ph_spherical *s) { \
    struct ph_spherical_legs legs = ph_spherical_legs_of(s); \
    return ph_spherical_legs_##what(&legs);                  \
  }
BY_POINTS(numerator_start)
BY_POINTS(curvature_start)
BY_POINTS(curvature_end)
#undef BY_POINTS
