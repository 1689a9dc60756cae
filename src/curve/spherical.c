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
 * In Q = phi^2 and Y = sigma^2 Q, by the functions f_n of s2.h and their
 * predecessor f_{-1}(X) = cos(theta) = f_0 - X f_1,
 *   A = f_{-1}(Y) / f_{-1}(Q),   B = sigma f_0(Y) / f_0(Q),             (2)
 *   |d|^2 = E = Q f_0(Q)^2,      dE/dQ = P = f_{-1}(Q) f_0(Q).          (3)
 * Derivatives: those of E are products, those of Q follow from (3), and those
 * of f_n(Q) from f_n' = -f_{n+1} / 2.
 */
#include "curve/spherical.h"

#include "kernel/s2.h"

/* The halves of the sum, as a displacement and in full, and of the difference
 * of two points; Q, and 1 / f_{-1}(Q), 1 / f_0(Q). */
struct arc {
  ph_vec3 mu, m, d;
  double q, ic, ig;
};

/* A segment prepared: p[0] and the arcs between neighbours. */
struct net {
  ph_vec3 base;
  struct arc arc[3];
};

/* Derivatives of order 0 to 3; of a point, value is its displacement. */
struct jet {
  ph_vec3 value, d1, d2, d3;
};

/* The functions f_{-1}, f_0, ..., f_3 at X. */
struct bessel {
  double f[5];
};

/* Derivatives of order 0 to 3 of a number. */
struct scalar {
  double v[4];
};

/* -------------------------------------------------------------------------- */
/* Functions of the angle                                                     */
/* -------------------------------------------------------------------------- */

static inline struct bessel bessel_at(double x) {
  struct bessel b;
  ph_s2_bessel(x, b.f + 1);
  b.f[0] = b.f[1] - x * b.f[2];
  return b;
}

/* Q of E = |d|^2 and m, which is unused where they are near. */
static inline double half_angle2(double e, ph_vec3 m) {
  double phi = atan2(sqrt(e), ph_vec3_abs(m));
  return phi * phi;
}

/* Derivatives of f_n(x(t)), where f[0], ..., f[3] are f_n, ..., f_{n+3}. */
static inline struct scalar chain(const double *f, const struct scalar *x) {
  double f1 = -f[1] / 2, f2 = f[2] / 4, f3 = -f[3] / 8;
  double x1 = x->v[1], x2 = x->v[2], x3 = x->v[3];
  struct scalar s = {{f[0], f1 * x1, f2 * x1 * x1 + f1 * x2,
                      (f3 * x1 * x1 + 3 * f2 * x2) * x1 + f1 * x3}};
  return s;
}

static inline struct scalar quotient(struct scalar a, struct scalar b) {
  double inverse = 1 / b.v[0];
  struct scalar q;
  q.v[0] = a.v[0] * inverse;
  q.v[1] = (a.v[1] - q.v[0] * b.v[1]) * inverse;
  q.v[2] = (a.v[2] - q.v[0] * b.v[2] - 2 * q.v[1] * b.v[1]) * inverse;
  q.v[3] =
      (a.v[3] - q.v[0] * b.v[3] - 3 * q.v[1] * b.v[2] - 3 * q.v[2] * b.v[1]) *
      inverse;
  return q;
}

/* -------------------------------------------------------------------------- */
/* The first level: fixed points                                              */
/* -------------------------------------------------------------------------- */

static inline struct arc arc_of(ph_vec3 base, ph_vec3 u, ph_vec3 w) {
  struct arc a;
  struct bessel b;
  a.mu = ph_vec3_scale(0.5,
                       ph_vec3_add(ph_vec3_sub(u, base), ph_vec3_sub(w, base)));
  a.m = ph_vec3_scale(0.5, ph_vec3_add(u, w));
  a.d = ph_vec3_scale(0.5, ph_vec3_sub(w, u));
  a.q = half_angle2(ph_vec3_dot(a.d, a.d), a.m);
  b = bessel_at(a.q);
  a.ic = 1 / b.f[0];
  a.ig = 1 / b.f[1];
  return a;
}

static inline struct net net_of(const struct ph_spherical *s) {
  struct net net = {s->p[0],
                    {arc_of(s->p[0], s->p[0], s->p[1]),
                     arc_of(s->p[0], s->p[1], s->p[2]),
                     arc_of(s->p[0], s->p[2], s->p[3])}};
  return net;
}

/* (1) where m and d do not depend on t: Z'' = -theta^2 Z. */
static inline struct jet arc_jet(const struct arc *a, double sigma) {
  struct bessel y = bessel_at(sigma * sigma * a->q);
  double ca = y.f[0] * a->ic, cb = sigma * y.f[1] * a->ig;
  ph_vec3 z = ph_vec3_along(ph_vec3_scale(ca, a->m), cb, a->d);
  struct jet jet;
  jet.value = ph_vec3_along(ph_vec3_along(a->mu, ca - 1, a->m), cb, a->d);
  jet.d1 =
      ph_vec3_along(ph_vec3_scale(-2 * a->q * sigma * y.f[1] * a->ic, a->m),
                    2 * y.f[0] * a->ig, a->d);
  jet.d2 = ph_vec3_scale(-4 * a->q, z);
  jet.d3 = ph_vec3_scale(-4 * a->q, jet.d1);
  return jet;
}

/* -------------------------------------------------------------------------- */
/* The other levels                                                           */
/* -------------------------------------------------------------------------- */

static inline ph_vec3 half_sum(ph_vec3 u, ph_vec3 w) {
  return ph_vec3_scale(0.5, ph_vec3_add(u, w));
}

static inline ph_vec3 half_difference(ph_vec3 u, ph_vec3 w) {
  return ph_vec3_scale(0.5, ph_vec3_sub(w, u));
}

/* Derivatives of Q from those of d, by (3). */
static inline struct scalar angle_jet(const struct jet *d, ph_vec3 m,
                                      struct bessel *b) {
  double e1 = 2 * ph_vec3_dot(d->value, d->d1);
  double e2 = 2 * (ph_vec3_dot(d->value, d->d2) + ph_vec3_dot(d->d1, d->d1));
  double e3 =
      2 * (ph_vec3_dot(d->value, d->d3) + 3 * ph_vec3_dot(d->d1, d->d2));
  double p, p1, p2, s1, s2;
  struct scalar q;
  q.v[0] = half_angle2(ph_vec3_dot(d->value, d->value), m);
  *b = bessel_at(q.v[0]);
  p = 1 / (b->f[0] * b->f[1]);
  p1 = -(b->f[0] * b->f[2] + b->f[1] * b->f[1]) / 2;
  p2 = (b->f[0] * b->f[3] + 3 * b->f[1] * b->f[2]) / 4;
  q.v[1] = e1 * p;
  s1 = p1 * q.v[1];
  q.v[2] = (e2 - s1 * q.v[1]) * p;
  s2 = p2 * q.v[1] * q.v[1] + p1 * q.v[2];
  q.v[3] = (e3 - 2 * s1 * q.v[2] - s2 * q.v[1]) * p;
  return q;
}

/* Derivatives of sigma^2 Q. */
static inline struct scalar square_jet(double sigma, const struct scalar *q) {
  double ss = sigma * sigma;
  struct scalar y = {{ss * q->v[0], ss * q->v[1] + 4 * sigma * q->v[0],
                      ss * q->v[2] + 8 * (sigma * q->v[1] + q->v[0]),
                      ss * q->v[3] + 12 * sigma * q->v[2] + 24 * q->v[1]}};
  return y;
}

static inline struct jet slerp_jet(ph_vec3 base, const struct jet *u,
                                   const struct jet *w, double sigma) {
  struct jet mu = {half_sum(u->value, w->value), half_sum(u->d1, w->d1),
                   half_sum(u->d2, w->d2), half_sum(u->d3, w->d3)};
  struct jet d = {half_difference(u->value, w->value),
                  half_difference(u->d1, w->d1), half_difference(u->d2, w->d2),
                  half_difference(u->d3, w->d3)};
  ph_vec3 m = ph_vec3_add(base, mu.value);
  struct bessel bq, by;
  struct scalar q = angle_jet(&d, m, &bq), y = square_jet(sigma, &q), a, r;
  double b[4];
  struct jet z;
  by = bessel_at(y.v[0]);
  a = quotient(chain(by.f, &y), chain(bq.f, &q));
  r = quotient(chain(by.f + 1, &y), chain(bq.f + 1, &q));
  b[0] = sigma * r.v[0];
  b[1] = sigma * r.v[1] + 2 * r.v[0];
  b[2] = sigma * r.v[2] + 4 * r.v[1];
  b[3] = sigma * r.v[3] + 6 * r.v[2];
  z.value =
      ph_vec3_along(ph_vec3_along(mu.value, a.v[0] - 1, m), b[0], d.value);
  z.d1 = ph_vec3_add(ph_vec3_along(ph_vec3_scale(a.v[1], m), a.v[0], mu.d1),
                     ph_vec3_along(ph_vec3_scale(b[1], d.value), b[0], d.d1));
  z.d2 = ph_vec3_add(
      ph_vec3_along(ph_vec3_along(ph_vec3_scale(a.v[2], m), 2 * a.v[1], mu.d1),
                    a.v[0], mu.d2),
      ph_vec3_along(ph_vec3_along(ph_vec3_scale(b[2], d.value), 2 * b[1], d.d1),
                    b[0], d.d2));
  z.d3 = ph_vec3_add(
      ph_vec3_along(ph_vec3_along(ph_vec3_along(ph_vec3_scale(a.v[3], m),
                                                3 * a.v[2], mu.d1),
                                  3 * a.v[1], mu.d2),
                    a.v[0], mu.d3),
      ph_vec3_along(ph_vec3_along(ph_vec3_along(ph_vec3_scale(b[3], d.value),
                                                3 * b[2], d.d1),
                                  3 * b[1], d.d2),
                    b[0], d.d3));
  return z;
}

static inline struct jet net_jet(const struct net *net, double t) {
  double sigma = 2 * t - 1;
  struct jet a = arc_jet(&net->arc[0], sigma), b = arc_jet(&net->arc[1], sigma),
             c = arc_jet(&net->arc[2], sigma);
  a = slerp_jet(net->base, &a, &b, sigma);
  b = slerp_jet(net->base, &b, &c, sigma);
  return slerp_jet(net->base, &a, &b, sigma);
}

/* -------------------------------------------------------------------------- */
/* Values and first derivatives                                               */
/* -------------------------------------------------------------------------- */

/* Displacement and first derivative. */
struct first {
  ph_vec3 value, d1;
};

static inline struct first arc_first(const struct arc *a, double sigma) {
  struct bessel y = bessel_at(sigma * sigma * a->q);
  double cb = sigma * y.f[1] * a->ig;
  struct first z;
  z.value =
      ph_vec3_along(ph_vec3_along(a->mu, y.f[0] * a->ic - 1, a->m), cb, a->d);
  z.d1 = ph_vec3_along(ph_vec3_scale(-2 * a->q * sigma * y.f[1] * a->ic, a->m),
                       2 * y.f[0] * a->ig, a->d);
  return z;
}

static inline struct first slerp_first(ph_vec3 base, const struct first *u,
                                       const struct first *w, double sigma) {
  ph_vec3 mu = half_sum(u->value, w->value), mu1 = half_sum(u->d1, w->d1);
  ph_vec3 d = half_difference(u->value, w->value);
  ph_vec3 d1 = half_difference(u->d1, w->d1);
  ph_vec3 m = ph_vec3_add(base, mu);
  double q = half_angle2(ph_vec3_dot(d, d), m), ss = sigma * sigma;
  struct bessel bq = bessel_at(q), by = bessel_at(ss * q);
  double ic = 1 / bq.f[0], ig = 1 / bq.f[1];
  double q1 = 2 * ph_vec3_dot(d, d1) * ic * ig;
  double y1 = ss * q1 + 4 * sigma * q;
  double a = by.f[0] * ic, r = by.f[1] * ig;
  double a1 = (a * bq.f[1] * q1 - by.f[1] * y1) * ic / 2;
  double r1 = (r * bq.f[2] * q1 - by.f[2] * y1) * ig / 2;
  struct first z;
  z.value = ph_vec3_along(ph_vec3_along(mu, a - 1, m), sigma * r, d);
  z.d1 = ph_vec3_add(
      ph_vec3_along(ph_vec3_scale(a1, m), a, mu1),
      ph_vec3_along(ph_vec3_scale(sigma * r1 + 2 * r, d), sigma * r, d1));
  return z;
}

static inline struct first net_first(const struct net *net, double t) {
  double sigma = 2 * t - 1;
  struct first a = arc_first(&net->arc[0], sigma),
               b = arc_first(&net->arc[1], sigma),
               c = arc_first(&net->arc[2], sigma);
  a = slerp_first(net->base, &a, &b, sigma);
  b = slerp_first(net->base, &b, &c, sigma);
  return slerp_first(net->base, &a, &b, sigma);
}

/* -------------------------------------------------------------------------- */
/* Points, derivatives, curvature                                             */
/* -------------------------------------------------------------------------- */

struct ph_spherical ph_spherical_of(const struct ph_curve *curve, size_t k) {
  const double *p = curve->control_points + 12 * k;
  ph_vec3 center = ph_vec3_get(curve->center, 3);
  struct ph_spherical s;
  for (size_t i = 0; i < 4; i++) {
    ph_vec3 v = ph_vec3_sub(ph_vec3_get(p + 3 * i, 3), center);
    s.p[i] = ph_vec3_unit(ph_vec3_scale(1 / curve->radius, v));
  }
  return s;
}

ph_vec3 ph_spherical_point(const struct ph_spherical *s, double t) {
  struct net net = net_of(s);
  return ph_vec3_add(net.base, net_first(&net, t).value);
}

void ph_spherical_first(const struct ph_spherical *s, double t,
                        ph_vec3 jet[2]) {
  struct net net = net_of(s);
  struct first z = net_first(&net, t);
  jet[0] = ph_vec3_add(net.base, z.value);
  jet[1] = z.d1;
}

void ph_spherical_jet(const struct ph_spherical *s, double t, ph_vec3 jet[4]) {
  struct net net = net_of(s);
  struct jet z = net_jet(&net, t);
  jet[0] = ph_vec3_add(net.base, z.value);
  jet[1] = z.d1;
  jet[2] = z.d2;
  jet[3] = z.d3;
}

void ph_spherical_numerator(const struct ph_spherical *s, double t,
                            double k[2]) {
  ph_vec3 jet[4], side;
  ph_spherical_jet(s, t, jet);
  side = ph_vec3_cross(jet[0], jet[1]);
  k[0] = ph_vec3_dot(side, jet[2]);
  k[1] = ph_vec3_dot(side, jet[3]);
}

double ph_spherical_curvature(const struct ph_spherical *s, double t) {
  ph_vec3 jet[4];
  ph_spherical_jet(s, t, jet);
  return ph_vec3_triple(jet[0], jet[1], jet[2]) /
         pow(ph_vec3_dot(jet[1], jet[1]), 1.5);
}

/* K at p, the first of three control points, and the angle to the second. */
static double start(ph_vec3 p, ph_vec3 q, ph_vec3 r, double *angle) {
  double theta = ph_s2_angle(p, q), omega = ph_s2_angle(q, r);
  double f = ph_s2_f0(theta * theta);
  *angle = theta;
  return 18 * ph_vec3_triple(p, ph_vec3_sub(q, p), ph_vec3_sub(r, q)) /
         (f * f * ph_s2_f0(omega * omega));
}

double ph_spherical_numerator_start(const struct ph_spherical *s) {
  double theta;
  return start(s->p[0], s->p[1], s->p[2], &theta);
}

double ph_spherical_numerator_end(const struct ph_spherical *s) {
  double theta;
  return -start(s->p[3], s->p[2], s->p[1], &theta);
}

double ph_spherical_curvature_start(const struct ph_spherical *s) {
  double theta, k = start(s->p[0], s->p[1], s->p[2], &theta);
  return k / (27 * theta * theta * theta);
}

double ph_spherical_curvature_end(const struct ph_spherical *s) {
  double theta, k = start(s->p[3], s->p[2], s->p[1], &theta);
  return -k / (27 * theta * theta * theta);
}

/* -------------------------------------------------------------------------- */
/* Arc length                                                                 */
/* -------------------------------------------------------------------------- */

/*
 * A Gauss rule on [-1/2, 1/2] by pairs of nodes, with what shows whether it
 * converges: four Legendre coefficients of the interpolant, two in the middle
 * and the last two.  Row 0 of even gives the mean, the others coefficients; a
 * node in the centre counts twice.
 */
struct rule {
  size_t pairs;
  double node[6];
  double even[3][6];
  double odd[2][6];
};

static const struct rule coarse = {
    3,
    {0.0, 0.26923465505284154552, 0.4530899229693319964},
    {{0.14222222222222222222, 0.23931433524968323402, 0.11846344252809454376},
     {-0.35555555555555555556, -0.077868341440967528549, 0.4334238969965230841},
     {0.48, -0.74199601592044532879, 0.26199601592044532879}},
    {{0.0, 0.38659027500089126226, 0.32204755229841746931},
     {0.0, -0.69919864488923337627, 0.41547714135083258685}}};

static const struct rule fine = {
    6,
    {0.062616704255734457736, 0.18391574949909009688, 0.29365897714330872365,
     0.38495133709715234352, 0.45205862818523742834, 0.49078031712335962535},
    {{0.1245735229067013925, 0.11674626826917740438, 0.10158371336153296087,
      0.080039164271673113167, 0.05346966299765921548, 0.023587668193255913597},
     {-0.34715378214889289156, 0.38058509091808292126, 0.26573067079623031459,
      -0.3465072903130101249, -0.15110587102212645101, 0.19845118176971623163},
     {-0.1604625453605403859, 0.42763805622508023892, -0.5543681498504460557,
      0.50861689081657065533, -0.3268652502223004072, 0.10544099839163595456}},
    {{0.29854843120289561917, 0.39456584681068129361, -0.13534950141601142323,
      -0.36919629498002251604, -0.0082478954702026470128,
      0.19221786265920149397},
     {-0.67116123783272482009, 0.60897690166332891715, -0.49442267934928262056,
      0.34604162358432194396, -0.18937270565563256635,
      0.056268555635291563007}}};

/* The error that is allowed, relative to the length, and how often the
 * interval is halved and how many parts of it are tried at most. */
static const double PRECISION = 2e-14;
enum { HALVINGS = 50, PARTS = 2000 };

/*
 * Integral of the speed over [a, a + width], and a bound of its error: the
 * coefficients fall by high / middle over half the degree of the interpolant,
 * and the first one that a Gauss rule takes for a constant is as far again.
 */
static double part(const struct net *net, const struct rule *rule, double a,
                   double width, double *error) {
  double even[3] = {0, 0, 0}, odd[2] = {0, 0}, middle, high;
  double c = a + width / 2;
  for (size_t i = 0; i < rule->pairs; i++) {
    double x = width * rule->node[i];
    double r = ph_vec3_abs(net_first(net, c + x).d1);
    double l = x > 0 ? ph_vec3_abs(net_first(net, c - x).d1) : r;
    for (size_t k = 0; k < 3; k++) {
      even[k] += rule->even[k][i] * (r + l);
    }
    for (size_t k = 0; k < 2; k++) {
      odd[k] += rule->odd[k][i] * (r - l);
    }
  }
  middle = fmax(fabs(even[1]), fabs(odd[0]));
  high = fmax(fabs(even[2]), fabs(odd[1]));
  *error = width * (high < middle ? high * pow(high / middle, 2) : high);
  return width * even[0];
}

double ph_spherical_length(const struct ph_spherical *s, double to) {
  struct net net = net_of(s);
  double error, length = part(&net, &coarse, 0, to, &error), tolerance;
  double sum = 0, width = to;
  size_t at = 0, depth = 0; /* the part is [at, at + 1] width */
  tolerance = PRECISION * length;
  if (error <= tolerance) {
    return length;
  }
  for (size_t parts = 0; parts < PARTS; parts++) {
    length = part(&net, &fine, (double)at * width, width, &error);
    if (error <= tolerance) {
      sum += length;
      for (at++; at % 2 == 0 && depth > 0; depth--) {
        at /= 2;
        width *= 2;
      }
      if (depth == 0) {
        return sum;
      }
    } else if (depth < HALVINGS) {
      depth++;
      at *= 2;
      width /= 2;
    } else {
      break;
    }
  }
  return (double)NAN;
}
