/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The model `exact`: unknown velocities v_i at the nodes, control points
 *   R_i = Exp_{P_i}(h_{i+1} v_i / 3),   L_i = Exp_{P_i}(-h_i v_i / 3),
 * so that the curve is C1 at any tension, and at every node the equation
 *   A(P_i, R_i, L_{i+1}) / h_{i+1}^2 - A(P_i, L_i, R_{i-1}) / h_i^2
 *     = nu_i v_i                                                       (1)
 * where A(P,B,C) is the covariant second derivative at t = 0 of the spherical
 * Bezier curve P, B, C, *.  The covariant acceleration jumps along the velocity
 * only: the geodesic curvature is continuous (G2), and the acceleration too
 * where nu_i = 0.  As spacings fall this becomes the nu-spline of the plane.
 * (The spline of [IOR15] is not G2: its construction satisfies (1) in the plane
 * only.)
 *
 * A in the frame e1, e2 = P x e1 of P, in complex numbers [derived here]:
 * (2) u = Log_P B with coordinates z, X = |u|^2; by f_n of kernel/s2.h
 *     q = B - P = f0 u - c P,  c = 1 - cos|u| = (X/2) f0(X/4)^2.
 * (3) W = Log_B C = g (d + (s/2) B) with d = C - B, s = |d|^2, g = phi / sin
 *     phi of the angle phi from B to C.
 * (4) With T, N along and across the geodesic from P to B, A = 6 ((W.T_B) T_P +
 *     (W.N) N |u| / sin |u| - u): W is carried to P as it is, and its part
 *     across is stretched.  The first is W - (W.P) (P + B) / (1 + P.B), the
 *     rest k Im(conj(z) delta) g i z with k = (1/f0 - 1) / X.
 * (5) All together, delta being the coordinates of d,
 *     A/6 = w (g delta + g f0 (s/2 - d.P) / (2 - c) z
 *              + k g Im(conj(z) delta) i z) - z,
 *     where w = 1, and w = 1/2 at a natural end: there B' = C is the midpoint
 *     of B and the end point, and d leads to that point.
 * Nothing cancels when d is summed from the difference of the data, which is
 * exact, and q: residuals reach rounding whatever the spacing.
 * Tested by t_sphere_exact.c: (5) against jets, derivatives against
 * differences; by t_sphere_newton.c: those of the plane.
 */
#include "kernel/cplx.h"
#include "kernel/s2.h"
#include "solve/sphere/sphere.h"

/* Below these X and s series are used, NEAR of them with few terms, TINY with
 * two. */
static const double TINY = 1e-6, NEAR = 1.0 / 64;
static const double FAR = 0.5;
enum { TERMS_NEAR = 5, TERMS = 9, TERMS_SPAN = 8 };

/* m = (1 - f0) / X and what follows from it: f0 = 1 - X m, f1 = 2 (m + X m'),
 * c of (2), k of (4) and its derivative by X. */
struct stretch {
  double x, f0, f1, c, k, dk;
};

/* A velocity of this square or larger would go round the sphere: there is no
 * such control point. */
static const double AROUND = 9;

static struct stretch stretch_of(double x) {
  static const double series[TERMS] = {
      1 / 6.0,          -1 / 120.0,          1 / 5040.0,
      -1 / 362880.0,    1 / 39916800.0,      -1 / 6227020800.0,
      1 / 1307674368e3, -1 / 355687428096e3, 1 / 121645100408832e3};
  size_t terms = x < NEAR ? TERMS_NEAR : TERMS;
  double m = series[terms - 1], dm = 0;
  struct stretch s = {.x = x};
  if (x < FAR) {
    for (size_t k = terms - 1; k-- > 0;) {
      dm = m + x * dm;
      m = series[k] + x * m;
    }
    s.f0 = 1 - x * m;
    s.f1 = 2 * (m + x * dm);
  } else {
    double f[4];
    ph_s2_bessel(x < AROUND ? x : (double)NAN, f);
    s.f0 = f[0];
    s.f1 = f[1];
    m = (1 - s.f0) / x;
    dm = (s.f1 / 2 - m) / x;
  }
  s.c = x * (m + s.f1);
  s.k = m / s.f0;
  s.dk = (dm + s.k * s.f1 / 2) / s.f0;
  return s;
}

/* One end of a segment: P with its frame, u and what (2) says of it. */
struct end {
  ph_vec3 e1, e2, p;
  double z[2];
  struct stretch by; /* of X = |z|^2 */
  ph_vec3 q;
};

/* The end at node i with u = scale x[i]; u = 0 with scale = 0. */
static struct end end_of(const struct ph_sphere_spline *s, size_t i,
                         double scale) {
  const struct ph_sphere_data *d = s->data;
  struct end e;
  ph_vec3 u = ph_vec3_scale(scale, s->x[i]);
  e.p = d->p[i];
  e.e1 = d->e[i];
  e.e2 = ph_vec3_cross(e.p, e.e1);
  e.z[0] = ph_vec3_dot(u, e.e1);
  e.z[1] = ph_vec3_dot(u, e.e2);
  e.by = stretch_of(e.z[0] * e.z[0] + e.z[1] * e.z[1]);
  e.q = ph_vec3_along(ph_vec3_scale(e.by.f0, u), -e.by.c, e.p);
  return e;
}

/* d of (3), as it is from both ends. */
struct span {
  ph_vec3 d; /* from the first end's B to the second's */
  double s, g;
  double dg; /* of g by s */
};

/* Squares of legs up to which derivatives are those of the plane, in which
 * A/6 = w delta - z: what is neglected of a step is 0.1 theta^2, at most 4e-9.
 * With 1e-6 tensions whose least sum is 4265 come down to 4269. */
static const double FLAT = 4e-8;

/* Control points whose sum is shorter are opposite to each other: interpolation
 * between them loses digits. */
static const double OPPOSITE = 1e-3;

/* With y = s/4 = sin^2(phi/2),
 *   g = asin(sqrt y) / sqrt(y (1 - y)) = 1 + (2/3) y + (8/15) y^2 + ...,
 * or dg = g^3 f1(phi^2) / 2 where that converges slowly. */
static struct span span_of(const struct end *a, const struct end *b) {
  static const double series[TERMS_SPAN] = {
      1,           2.0 / 3,     8.0 / 15,      16.0 / 35,
      128.0 / 315, 256.0 / 693, 1024.0 / 3003, 2048.0 / 6435};
  struct span r;
  r.d = ph_vec3_add(ph_vec3_sub(b->p, a->p), ph_vec3_sub(b->q, a->q));
  r.s = ph_vec3_dot(r.d, r.d);
  if (r.s < NEAR) {
    double y = r.s / 4;
    r.g = series[TERMS_SPAN - 1];
    r.dg = 0;
    for (size_t k = TERMS_SPAN - 1; k-- > 0;) {
      r.dg = r.g + y * r.dg;
      r.g = series[k] + y * r.g;
    }
    r.dg /= 4;
  } else {
    ph_vec3 sum = ph_vec3_add(ph_vec3_add(a->p, a->q), ph_vec3_add(b->p, b->q));
    double apart = ph_vec3_abs(sum);
    double angle = 2 * atan2(sqrt(r.s), apart > OPPOSITE ? apart : (double)NAN);
    double f[4];
    ph_s2_bessel(angle * angle, f);
    r.g = 1 / f[0];
    r.dg = r.g * r.g * r.g * f[1] / 2;
  }
  return r;
}

/* A vector in the frame of an end: e1, e2, p. */
static ph_vec3 local(const struct end *e, ph_vec3 v) {
  return ph_vec3_of(ph_vec3_dot(v, e->e1), ph_vec3_dot(v, e->e2),
                    ph_vec3_dot(v, e->p));
}

/* dq by z[j], in the end's own frame. */
static ph_vec3 move_of(const struct end *e, int j) {
  double f0 = e->by.f0, f1 = e->by.f1;
  ph_vec3 v = ph_vec3_of(-f1 * e->z[0] * e->z[j], -f1 * e->z[1] * e->z[j],
                         -f0 * e->z[j]);
  *(j == 0 ? &v.x : &v.y) += f0;
  return v;
}

/* A/6 of (5) at an end, and what it depends on. */
struct acceleration {
  const struct end *end;
  const struct span *span;
  double w;       /* of (5) */
  ph_vec3 d;      /* in the end's frame */
  double over;    /* f0 / (2 - c) */
  double along;   /* f0 (s/2 - d.P) / (2 - c) */
  double cross;   /* Im(conj(z) delta) */
  double wide[2]; /* A / (6 w g) but for the last z */
};

static struct acceleration acceleration_of(const struct end *e,
                                           const struct span *span, double sign,
                                           double w) {
  struct acceleration b = {.end = e, .span = span, .w = w};
  const double *z = e->z;
  double k;
  b.d = local(e, ph_vec3_scale(sign, span->d));
  b.over = e->by.f0 / (2 - e->by.c);
  b.along = b.over * (span->s / 2 - b.d.z);
  b.cross = z[0] * b.d.y - z[1] * b.d.x;
  k = e->by.k * b.cross;
  b.wide[0] = b.d.x + b.along * z[0] - k * z[1];
  b.wide[1] = b.d.y + b.along * z[1] + k * z[0];
  return b;
}

/* A/6. */
static ph_vec3 acceleration_value(const struct acceleration *b) {
  double wg = b->w * b->span->g;
  return ph_vec3_of(wg * b->wide[0] - b->end->z[0],
                    wg * b->wide[1] - b->end->z[1], 0);
}

/* The derivative of A/6 when d moves by dd, in the end's frame: s moves by
 * 2 d.dd. */
static inline ph_vec3 acceleration_moved(const struct acceleration *b,
                                         ph_vec3 dd) {
  const double *z = b->end->z;
  double half = ph_vec3_dot(b->d, dd), wg = b->w * b->span->g;
  double wdg = 2 * b->w * b->span->dg * half;
  double along = b->over * (half - dd.z);
  double k = b->end->by.k * (z[0] * dd.y - z[1] * dd.x);
  return ph_vec3_of(wdg * b->wide[0] + wg * (dd.x + along * z[0] - k * z[1]),
                    wdg * b->wide[1] + wg * (dd.y + along * z[1] + k * z[0]),
                    0);
}

/* The same when z[j] moves and d does not: f0' = -f1 / 2, c' = f0 / 2. */
static inline ph_vec3 acceleration_turned(const struct acceleration *b, int j) {
  const struct stretch *by = &b->end->by;
  const double *z = b->end->z;
  double wg = b->w * b->span->g, dx = 2 * z[j], rest = 2 - by->c;
  double along =
      (b->span->s / 2 - b->d.z) * (b->over * b->over - by->f1 / rest) / 2 * dx;
  double cross = j == 0 ? b->d.y : -b->d.x;
  double k = by->k * b->cross;
  double dk = by->dk * dx * b->cross + by->k * cross;
  double same = wg * b->along - 1;
  ph_vec3 v = ph_vec3_of(wg * (along * z[0] - dk * z[1]),
                         wg * (along * z[1] + dk * z[0]), 0);
  v.x += j == 0 ? same : -wg * k;
  v.y += j == 0 ? wg * k : same;
  return v;
}

/* The rotation from one end's frame to the other's, by its columns. */
struct turn {
  ph_vec3 column[3];
};

static struct turn turn_of(const struct end *from, const struct end *to) {
  struct turn turn = {
      {local(to, from->e1), local(to, from->e2), local(to, from->p)}};
  return turn;
}

static inline ph_vec3 turned(const struct turn *turn, ph_vec3 v) {
  return ph_vec3_along(
      ph_vec3_along(ph_vec3_scale(v.x, turn->column[0]), v.y, turn->column[1]),
      v.z, turn->column[2]);
}

/* The derivatives of both ends' A/6 by both ends' z. */
static void derive(const struct end e[2], const struct acceleration a6[2],
                   struct ph_sphere_part *part, const double scale[2],
                   double by) {
  for (int w = 0; w < 2; w++) {
    int other = 1 - w;
    struct turn turn = turn_of(&e[w], &e[other]);
    for (int j = 0; j < 2; j++) {
      /* d leads away from this end's B, and towards it seen from the other */
      ph_vec3 move = move_of(&e[w], j);
      ph_vec3 own = acceleration_moved(&a6[w], ph_vec3_scale(-1, move));
      ph_vec3 far = acceleration_moved(&a6[other], turned(&turn, move));
      own = ph_vec3_add(own, acceleration_turned(&a6[w], j));
      part->d[w][w][j] = ph_vec3_scale(by * scale[w], own);
      part->d[other][w][j] = ph_vec3_scale(by * scale[w], far);
    }
  }
}

/* The same of short legs, as in the plane. */
static void derive_flat(const struct end e[2], const struct acceleration a6[2],
                        struct ph_sphere_part *part, const double scale[2],
                        double by) {
  for (int w = 0; w < 2; w++) {
    const struct end *far = &e[1 - w];
    const double f = by * scale[w], own = -f * (1 + a6[w].w);
    const double other = f * a6[1 - w].w;
    part->d[w][w][0] = ph_vec3_of(own, 0, 0);
    part->d[w][w][1] = ph_vec3_of(0, own, 0);
    part->d[1 - w][w][0] = ph_vec3_of(other * ph_vec3_dot(e[w].e1, far->e1),
                                      other * ph_vec3_dot(e[w].e1, far->e2), 0);
    part->d[1 - w][w][1] = ph_vec3_of(other * ph_vec3_dot(e[w].e2, far->e1),
                                      other * ph_vec3_dot(e[w].e2, far->e2), 0);
  }
}

/* From P to the middle of the great circle from P to P + d; where that is long,
 * by its length, as cosine has lost digits. */
static ph_vec3 half_way(ph_vec3 p, ph_vec3 d) {
  double y = ph_vec3_dot(d, d) / 4, cosine = sqrt(1 - y);
  if (y > 0.5) {
    return ph_vec3_sub(ph_vec3_unit(ph_vec3_along(d, 2, p)), p);
  }
  return ph_vec3_along(ph_vec3_scale(0.5 / cosine, d),
                       y / (cosine * (1 + cosine)), p);
}

/* B - P of (2) at node i with u = scale x[i]. */
static ph_vec3 leg_at(const struct ph_sphere_spline *s, size_t i,
                      double scale) {
  ph_vec3 u = ph_vec3_scale(scale, s->x[i]);
  double x = ph_vec3_dot(u, u);
  if (x < TINY) {
    double f0 = 1 - x / 6 * (1 - x / 20), c = x / 2 * (1 - x / 12);
    return ph_vec3_along(ph_vec3_scale(f0, u), -c, s->data->p[i]);
  } else {
    struct stretch by = stretch_of(x);
    return ph_vec3_along(ph_vec3_scale(by.f0, u), -by.c, s->data->p[i]);
  }
}

static void segment(struct ph_sphere_spline *s, size_t k, bool derivatives,
                    struct ph_sphere_part *part) {
  const struct ph_sphere_data *d = s->data;
  size_t node[2] = {k, ph_sphere_next(d, k)};
  double h = d->h[k], by = 6 / (h * h);
  bool natural[2];
  struct end e[2];
  struct span span;
  struct acceleration a6[2];
  double scale[2] = {h / 3, -h / 3};
  for (int w = 0; w < 2; w++) {
    natural[w] = d->ends == PH_SPHERE_NATURAL && ph_sphere_is_end(d, node[w]);
  }
  if (!part && !natural[0] && !natural[1]) {
    s->r[k] = leg_at(s, node[0], scale[0]);
    s->l[k] = leg_at(s, node[1], scale[1]);
    return;
  }
  for (int w = 0; w < 2; w++) {
    e[w] = end_of(s, node[w], natural[w] ? 0 : scale[w]);
  }
  span = span_of(&e[0], &e[1]);
  s->r[k] = e[0].q;
  s->l[k] = e[1].q;
  if (natural[0] && natural[1]) {
    /* both on one great circle, however well the data tell which */
    ph_vec3 v = ph_vec3_normal(ph_s2_log(e[0].p, e[1].p), e[0].p);
    v = ph_vec3_scale(d->theta[k] / ph_vec3_abs(v), v);
    ph_vec3 r = ph_vec3_unit(ph_s2_exp(e[0].p, ph_vec3_scale(1 / 3.0, v)));
    ph_vec3 l = ph_vec3_unit(ph_s2_exp(e[0].p, ph_vec3_scale(2 / 3.0, v)));
    s->r[k] = ph_vec3_sub(r, e[0].p);
    s->l[k] = ph_vec3_sub(l, e[1].p);
  } else if (natural[0]) {
    s->r[k] = half_way(e[0].p, span.d);
  } else if (natural[1]) {
    s->l[k] = half_way(e[1].p, ph_vec3_scale(-1, span.d));
  }
  if (!part) {
    return;
  }
  for (int w = 0; w < 2; w++) {
    a6[w] = acceleration_of(&e[w], &span, w == 0 ? 1 : -1,
                            natural[1 - w] ? 0.5 : 1);
    part->f[w] = ph_vec3_scale(by, acceleration_value(&a6[w]));
  }
  if (derivatives && e[0].by.x <= FLAT && e[1].by.x <= FLAT && span.s <= FLAT) {
    derive_flat(e, a6, part, scale, by);
  } else if (derivatives) {
    derive(e, a6, part, scale, by);
  }
}

/* What (1) is divided by: what v_i is multiplied by in the plane, and the speed
 * there. */
static double scale_at(const struct ph_sphere_spline *s, size_t i, double nu) {
  const struct ph_sphere_data *d = s->data;
  size_t before = ph_sphere_before(d, i);
  double speed[2] = {d->theta[before] / d->h[before], d->theta[i] / d->h[i]};
  return 1 / ((ph_sphere_stiffness(d, i) + nu) *
              (speed[0] > speed[1] ? speed[0] : speed[1]));
}

/* (1) */
static void node(const struct ph_sphere_spline *s, size_t i,
                 const struct ph_sphere_part *left,
                 const struct ph_sphere_part *right, bool derivatives,
                 struct ph_block2_row *row) {
  const struct ph_sphere_data *d = s->data;
  double nu = s->nu[i], scale = scale_at(s, i, nu);
  double v[2] = {ph_vec3_dot(s->x[i], d->e[i]),
                 ph_vec3_triple(d->p[i], d->e[i], s->x[i])};
  row->f[0] = -scale * (right->f[0].x - left->f[1].x - nu * v[0]);
  row->f[1] = -scale * (right->f[0].y - left->f[1].y - nu * v[1]);
  if (!derivatives) {
    return;
  }
  for (int j = 0; j < 2; j++) {
    row->lo[j] = -scale * left->d[1][0][j].x;
    row->lo[2 + j] = -scale * left->d[1][0][j].y;
    row->up[j] = scale * right->d[0][1][j].x;
    row->up[2 + j] = scale * right->d[0][1][j].y;
    row->di[j] =
        scale * (right->d[0][0][j].x - left->d[1][1][j].x - (j == 0) * nu);
    row->di[2 + j] =
        scale * (right->d[0][0][j].y - left->d[1][1][j].y - (j == 1) * nu);
  }
}

static void retension(const struct ph_sphere_spline *s, size_t i, ph_vec3 x,
                      double from, struct ph_block2_row *row) {
  const struct ph_sphere_data *d = s->data;
  double by = scale_at(s, i, from) * (s->nu[i] - from);
  row->f[0] += by * ph_vec3_dot(x, d->e[i]);
  row->f[1] += by * ph_vec3_triple(d->p[i], d->e[i], x);
  row->di[0] -= by;
  row->di[3] -= by;
}

static ph_vec3 move(const struct ph_sphere_spline *s, size_t i,
                    const double step[2]) {
  ph_vec3 p = s->data->p[i], e = s->data->e[i];
  ph_vec3 x = ph_vec3_along(s->x[i], step[0], e);
  return ph_vec3_normal(ph_vec3_along(x, step[1], ph_vec3_cross(p, e)), p);
}

static double reach(const struct ph_sphere_spline *s, size_t i) {
  const struct ph_sphere_data *d = s->data;
  double before = d->h[ph_sphere_before(d, i)], after = d->h[i];
  return (before > after ? before : after) / 3;
}

/* No velocities, but those that are given. */
static void hug(struct ph_sphere_spline *s, struct ph_sphere_range range) {
  const struct ph_sphere_data *d = s->data;
  bool clamped = d->ends == PH_SPHERE_CLAMPED;
  for (size_t j = 0; j < range.count; j++) {
    s->x[ph_sphere_node(d, range, j)] = ph_vec3_of(0, 0, 0);
  }
  if (!d->closed) {
    s->x[0] = clamped ? d->end[0] : ph_vec3_of(0, 0, 0);
    s->x[d->n - 1] = clamped ? d->end[1] : ph_vec3_of(0, 0, 0);
  }
}

/* Velocities of the parabola through three nodes, times a factor.  With factor
 * 0, one step of Newton's iteration is the nu-spline of the plane, wrapped
 * around the sphere. */
static bool start(struct ph_sphere_spline *s, struct ph_sphere_range range,
                  size_t which, struct ph_sphere_work *work) {
  static const double factors[] = {0, 1, 0.5, 2, -1};
  const struct ph_sphere_data *d = s->data;
  (void)work;
  if (which >= sizeof factors / sizeof factors[0]) {
    return false;
  }
  hug(s, range);
  for (size_t j = 0; which > 0 && j < range.count; j++) {
    size_t i = ph_sphere_node(d, range, j), before = ph_sphere_before(d, i);
    double a = d->h[before], b = d->h[i], f = factors[which] / (a + b);
    ph_vec3 to = ph_s2_log(d->p[i], d->p[ph_sphere_next(d, i)]);
    ph_vec3 from = ph_s2_log(d->p[i], d->p[before]);
    s->x[i] = ph_vec3_along(ph_vec3_scale(f * a / b, to), -f * b / a, from);
  }
  return true;
}

const struct ph_sphere_model ph_sphere_exact = {
    "exact", segment, node, retension, move, reach, hug, start, NULL, NULL};
