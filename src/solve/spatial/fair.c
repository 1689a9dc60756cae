/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Functionals by a fixed quadrature (see fairest.h).
 *
 * The integrands are (4), (5) and (6) of curve/fair/fair3.c.  Their derivatives
 * are taken backwards: at a node, by what they are made of; summed up over the
 * nodes, by the coefficients of the polynomials; then by the preimage, and then
 * by the variables.  The name of the derivative by `x` is `x_`.
 *
 * The loops over nodes are compiled for each functional (PH_INLINE): gcc takes
 * two nodes at once then.
 */
#include "solve/spatial/fairest.h"

#include "base/inline.h"

enum { NODES = PH_SPATIAL_FAIR_NODES };

/* Polynomials in y = v - 1/2: sigma, x, Re z and Im z, Im(conj(z) z'), q. */
struct form {
  ph_quat b[3]; /* B */
  double sigma[5], x[3], re[3], im[3], nu[3], q[2];
};

/* The values of one node, or the derivatives by them. */
struct node {
  double sigma, sigma1, x, x1, re, re1, im, im1, nu, nu1, q, q1;
};

static void set_form(struct form *f, double c, const ph_quat a[3]) {
  ph_quat middle = ph_quat_scale(2 * c, a[1]), *b = f->b, w[3];
  ph_quat ends = ph_quat_add(a[0], a[2]);
  b[0] = ph_quat_scale(0.25, ph_quat_add(ends, middle));
  b[1] = ph_quat_sub(a[2], a[0]);
  b[2] = ph_quat_sub(ends, middle);
  w[0] = ph_quat_between(b[0], b[1]);
  w[1] = ph_quat_scale(2, ph_quat_between(b[0], b[2]));
  w[2] = ph_quat_between(b[1], b[2]);
  for (size_t i = 0; i < 3; i++) {
    f->x[i] = w[i].v;
    f->re[i] = w[i].p;
    f->im[i] = w[i].q;
  }
  f->nu[0] = f->re[0] * f->im[1] - f->im[0] * f->re[1];
  f->nu[1] = 2 * (f->re[0] * f->im[2] - f->im[0] * f->re[2]);
  f->nu[2] = f->re[1] * f->im[2] - f->im[1] * f->re[2];
  f->sigma[0] = ph_quat_dot(b[0], b[0]);
  f->sigma[1] = 2 * ph_quat_dot(b[0], b[1]);
  f->sigma[2] = ph_quat_dot(b[1], b[1]) + 2 * ph_quat_dot(b[0], b[2]);
  f->sigma[3] = 2 * ph_quat_dot(b[1], b[2]);
  f->sigma[4] = ph_quat_dot(b[2], b[2]);
  f->q[0] = 0.5 * (1 + c);
  f->q[1] = 2 * (1 - c);
}

PH_INLINE double at(const double c[3], double y) {
  return c[0] + y * (c[1] + y * c[2]);
}

PH_INLINE double slope_at(const double c[3], double y) {
  return c[1] + 2 * y * c[2];
}

PH_INLINE struct node node_at(const struct form *f, double y) {
  const double *s = f->sigma;
  struct node n;
  n.sigma = s[0] + y * (s[1] + y * (s[2] + y * (s[3] + y * s[4])));
  n.sigma1 = s[1] + y * (2 * s[2] + y * (3 * s[3] + y * (4 * s[4])));
  n.re = at(f->re, y);
  n.im = at(f->im, y);
  n.re1 = slope_at(f->re, y);
  n.im1 = slope_at(f->im, y);
  n.x = at(f->x, y);
  n.x1 = slope_at(f->x, y);
  n.nu = at(f->nu, y);
  n.nu1 = slope_at(f->nu, y);
  n.q = f->q[0] + f->q[1] * y * y;
  n.q1 = 2 * f->q[1] * y;
  return n;
}

/* (4), F1. */
PH_INLINE double bending(const struct node *n, struct node *by) {
  double r = n->q / n->sigma, r3 = 4 * r * r * r;
  double value = r3 * (n->re * n->re + n->im * n->im);
  if (by) {
    *by = (struct node){.sigma = -3 * value / n->sigma,
                        .q = 3 * value / n->q,
                        .re = 2 * r3 * n->re,
                        .im = 2 * r3 * n->im};
  }
  return value;
}

/* What (5) and (6) share. */
struct shared {
  double z2, per_z2, per_sigma, per_q, q9, dz, ds, dq;
};

PH_INLINE struct shared shared_of(const struct node *n) {
  struct shared s;
  double q3 = n->q * n->q * n->q, per;
  s.q9 = q3 * q3 * q3;
  s.z2 = n->re * n->re + n->im * n->im;
  per = 1 / (n->sigma * n->q * s.z2); /* one division for three */
  s.per_q = n->sigma * s.z2 * per;
  s.per_z2 = n->sigma * n->q * per;
  s.per_sigma = n->q * s.z2 * per;
  s.dz = (n->re * n->re1 + n->im * n->im1) * s.per_z2;
  s.ds = n->sigma1 * s.per_sigma;
  s.dq = n->q1 * s.per_q;
  return s;
}

/* Passes on derivatives by dz, ds, dq and z2 to what these are made of. */
PH_INLINE void pass_on(const struct node *n, const struct shared *s, double dz_,
                       double ds_, double dq_, double z2_, struct node *by) {
  double p_ = dz_ * s->per_z2;
  z2_ -= s->dz * p_;
  by->re += 2 * n->re * z2_ + n->re1 * p_;
  by->im += 2 * n->im * z2_ + n->im1 * p_;
  by->re1 += n->re * p_;
  by->im1 += n->im * p_;
  by->sigma1 += ds_ * s->per_sigma;
  by->sigma -= s->ds * ds_ * s->per_sigma;
  by->q1 += dq_ * s->per_q;
  by->q -= s->dq * dq_ * s->per_q;
}

/* (5) */
PH_INLINE double varying(const struct node *n, struct node *by) {
  struct shared s = shared_of(n);
  double per2 = s.per_sigma * s.per_sigma;
  double factor = 4 * s.q9 * per2 * per2 * s.per_sigma;
  double r = 3 * s.dq + s.dz - 2 * s.ds;
  double value = factor * s.z2 * r * r, r_ = 2 * factor * s.z2 * r;
  if (by) {
    *by = (struct node){.sigma = -5 * value * s.per_sigma,
                        .q = 9 * value * s.per_q};
    pass_on(n, &s, r_, -2 * r_, 3 * r_, factor * r * r, by);
  }
  return value;
}

/* (6); adds to `by`. */
PH_INLINE double twisting(const struct node *n, struct node *by) {
  struct shared s = shared_of(n);
  double factor = s.q9 * s.per_sigma * s.per_sigma * s.per_sigma;
  double turn = n->nu * s.per_z2, twist = 2 * n->x * s.per_sigma;
  double r = 3 * s.dq - s.ds, t = turn + twist;
  double turn1 = n->nu1 * s.per_z2 - 2 * turn * s.dz;
  double twist1 = 2 * n->x1 * s.per_sigma - twist * s.ds;
  double m = r * t + turn1 + twist1, value = factor * m * m;
  if (by) {
    double m_ = 2 * factor * m, z2_;
    double turn_ = (r - 2 * s.dz) * m_, twist_ = (r - s.ds) * m_;
    by->nu1 += m_ * s.per_z2;
    by->nu += turn_ * s.per_z2;
    z2_ = -(n->nu1 * m_ * s.per_z2 + turn * turn_) * s.per_z2;
    by->x1 += 2 * m_ * s.per_sigma;
    by->x += 2 * twist_ * s.per_sigma;
    by->sigma -= (3 * value + 2 * n->x1 * m_ * s.per_sigma + twist * twist_) *
                 s.per_sigma;
    by->q += 9 * value * s.per_q;
    pass_on(n, &s, -2 * turn * m_, -(t + twist) * m_, 3 * t * m_, z2_, by);
  }
  return value;
}

PH_INLINE double integrand(int functional, const struct node *n,
                           struct node *by) {
  double value;
  if (functional == 1) {
    return bending(n, by);
  }
  value = varying(n, by);
  return functional == 2 ? value : value + twisting(n, by);
}

/* The nodes of a panel and their weights. */
struct panel {
  double y[NODES], weight[NODES];
};

/* What nodes contribute, summed up over panels: values, and derivatives by the
 * polynomials. */
struct sums {
  double value[NODES];
  double sigma[5][NODES], x[3][NODES], re[3][NODES], im[3][NODES];
  double nu[3][NODES], q[2][NODES];
};

static struct panel panel_of(const struct ph_quad *rule, size_t k,
                             double step) {
  struct panel on;
  for (size_t i = 0; i < NODES; i++) {
    on.y[i] = step * ((double)k + rule->node[i]) - 0.5;
    on.weight[i] = step * rule->weight[i];
  }
  return on;
}

/* All nodes by the same instructions, so that the compiler takes two at once.
 */
PH_INLINE void add_values(int functional, const struct form *restrict f,
                          const struct panel *restrict on,
                          double *restrict value) {
  for (size_t i = 0; i < NODES; i++) {
    struct node n = node_at(f, on->y[i]);
    value[i] += on->weight[i] * integrand(functional, &n, NULL);
  }
}

/* Adds the derivatives by a polynomial from those by its value and slope. */
PH_INLINE void add(double (*restrict c_)[NODES], size_t i, double y,
                   double value_, double slope_) {
  c_[0][i] += value_;
  c_[1][i] += y * value_ + slope_;
  c_[2][i] += y * (y * value_ + 2 * slope_);
}

PH_INLINE void add_derivatives(int functional, const struct form *restrict f,
                               const struct panel *restrict on,
                               struct sums *restrict to) {
  for (size_t i = 0; i < NODES; i++) {
    double y = on->y[i], weight = on->weight[i], y2 = y * y, value_, slope_;
    struct node n = node_at(f, y), by = {0};
    to->value[i] += weight * integrand(functional, &n, &by);
    value_ = weight * by.sigma;
    slope_ = weight * by.sigma1;
    add(to->sigma, i, y, value_, slope_);
    to->sigma[3][i] += y2 * (y * value_ + 3 * slope_);
    to->sigma[4][i] += y2 * y * (y * value_ + 4 * slope_);
    add(to->re, i, y, weight * by.re, weight * by.re1);
    add(to->im, i, y, weight * by.im, weight * by.im1);
    to->q[0][i] += weight * by.q;
    to->q[1][i] += weight * (y2 * by.q + 2 * y * by.q1);
    if (functional == 3) {
      add(to->x, i, y, weight * by.x, weight * by.x1);
      add(to->nu, i, y, weight * by.nu, weight * by.nu1);
    }
  }
}

static double sum_of(const double *v) {
  double part[4] = {0, 0, 0, 0};
  for (size_t i = 0; i < NODES; i += 4) {
    for (size_t k = 0; k < 4; k++) {
      part[k] += v[i + k];
    }
  }
  return part[0] + part[1] + (part[2] + part[3]);
}

/* The integral by v. */
static double integrate(const struct ph_quad *rule, size_t panels,
                        int functional, const struct form *f) {
  double value[NODES] = {0};
  for (size_t k = 0; k < panels; k++) {
    struct panel on = panel_of(rule, k, 1 / (double)panels);
    switch (functional) {
    case 1:
      add_values(1, f, &on, value);
      break;
    case 2:
      add_values(2, f, &on, value);
      break;
    default:
      add_values(3, f, &on, value);
    }
  }
  return sum_of(value);
}

/* The integral by v, and its derivatives by the polynomials. */
static double integrate_with(const struct ph_quad *rule, size_t panels,
                             int functional, const struct form *f,
                             struct form *f_) {
  struct sums to = {0};
  for (size_t k = 0; k < panels; k++) {
    struct panel on = panel_of(rule, k, 1 / (double)panels);
    switch (functional) {
    case 1:
      add_derivatives(1, f, &on, &to);
      break;
    case 2:
      add_derivatives(2, f, &on, &to);
      break;
    default:
      add_derivatives(3, f, &on, &to);
    }
  }
  for (size_t i = 0; i < 5; i++) {
    f_->sigma[i] = sum_of(to.sigma[i]);
  }
  for (size_t i = 0; i < 3; i++) {
    f_->x[i] = sum_of(to.x[i]);
    f_->re[i] = sum_of(to.re[i]);
    f_->im[i] = sum_of(to.im[i]);
    f_->nu[i] = sum_of(to.nu[i]);
  }
  f_->q[0] = sum_of(to.q[0]);
  f_->q[1] = sum_of(to.q[1]);
  return sum_of(to.value);
}

static ph_quat axpy(ph_quat a, double s, ph_quat b) {
  return ph_quat_add(a, ph_quat_scale(s, b));
}

/* Adds the derivatives by a and b from those by conj(a) b. */
static void unmultiply(ph_quat w_, ph_quat a, ph_quat b, ph_quat *a_,
                       ph_quat *b_) {
  *a_ = ph_quat_add(*a_, ph_quat_mul(b, ph_quat_conj(w_)));
  *b_ = ph_quat_add(*b_, ph_quat_mul(a, w_));
}

/* From derivatives by the polynomials to those by a[3] and c. */
static void unform(const struct form *f, struct form *g, double c,
                   const ph_quat a[3], ph_quat a_[3], double *c_) {
  const ph_quat *b = f->b;
  ph_quat b_[3] = {{0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}}, middle;
  const double *s = g->sigma;
  g->re[0] += g->nu[0] * f->im[1] + 2 * g->nu[1] * f->im[2];
  g->im[0] -= g->nu[0] * f->re[1] + 2 * g->nu[1] * f->re[2];
  g->re[1] += -g->nu[0] * f->im[0] + g->nu[2] * f->im[2];
  g->im[1] += g->nu[0] * f->re[0] - g->nu[2] * f->re[2];
  g->re[2] -= 2 * g->nu[1] * f->im[0] + g->nu[2] * f->im[1];
  g->im[2] += 2 * g->nu[1] * f->re[0] + g->nu[2] * f->re[1];
  unmultiply(ph_quat_of(0, g->x[0], g->re[0], g->im[0]), b[0], b[1], &b_[0],
             &b_[1]);
  unmultiply(ph_quat_of(0, 2 * g->x[1], 2 * g->re[1], 2 * g->im[1]), b[0], b[2],
             &b_[0], &b_[2]);
  unmultiply(ph_quat_of(0, g->x[2], g->re[2], g->im[2]), b[1], b[2], &b_[1],
             &b_[2]);
  for (size_t i = 0; i < 3; i++) {
    b_[0] = axpy(b_[0], 2 * s[i], b[i]);
    b_[1] = axpy(b_[1], 2 * s[i + 1], b[i]);
    b_[2] = axpy(b_[2], 2 * s[i + 2], b[i]);
  }
  middle = axpy(ph_quat_scale(0.25, b_[0]), -1, b_[2]);
  a_[0] = ph_quat_sub(axpy(b_[2], 0.25, b_[0]), b_[1]);
  a_[1] = ph_quat_scale(2 * c, middle);
  a_[2] = ph_quat_add(axpy(b_[2], 0.25, b_[0]), b_[1]);
  *c_ = 2 * ph_quat_dot(middle, a[1]) + 0.5 * g->q[0] - 2 * g->q[1];
}

/* ---- variables ------------------------------------------------------- */

struct ph_spatial_family
ph_spatial_fair_family(const struct ph_spatial_target *target, double alpha) {
  struct ph_spatial_family f = *target->family;
  struct ph_atph space = ph_atph_of(alpha);
  if (target->scaled) {
    double root = sqrt(alpha);
    f.ni *= alpha;
    f.nf *= alpha;
    f.m *= alpha;
    f.root[0] *= root;
    f.root[1] *= root;
    f.sum = ph_vec3_scale(alpha, f.sum);
  }
  ph_spatial_family_space(&f, &space);
  return f;
}

/* How a preimage and the length change with a variable. */
struct change {
  ph_quat a[3];
  double length;
};

/* The change of D by that of d, turned about i so as to stay at the same phase:
 * D(0) i is normal to Q = A0 + A2, unless D(0) stays in a plane. */
static ph_quat follow(bool plane, ph_quat d, ph_vec3 at, ph_vec3 change,
                      ph_quat nearest, ph_quat q, ph_quat q_change) {
  const ph_cplx i = {0, 1};
  double size2 = ph_vec3_dot(at, at), rate;
  ph_quat by = ph_quat_scale(
      -0.5 / size2, ph_quat_mul(ph_quat_pure(change), ph_quat_pure(at)));
  rate = (ph_quat_dot(ph_quat_turn(ph_quat_mul(by, nearest), i), q) +
          ph_quat_dot(ph_quat_turn(nearest, i), q_change)) /
         ph_quat_dot(nearest, q);
  by = ph_quat_mul(by, d);
  return isfinite(rate) && !plane ? axpy(by, rate, ph_quat_turn(d, i)) : by;
}

/* What the changes have in common. */
struct member {
  const struct ph_spatial_family *f;
  const ph_quat *a;
  ph_quat q, d, nearest; /* A0 + A2, D and D(0) */
  ph_cplx b;
  bool plane; /* of plane data, in their plane */
};

static void change_by_b(const struct member *m, struct change *by) {
  const struct ph_spatial_family *f = m->f;
  const ph_cplx left = {0, -0.5}, right = {0, 0.5};
  double k = 2 * f->k * f->m;
  ph_vec3 d = ph_spatial_d(f, m->b);
  ph_vec3 d_change = ph_vec3_of(-k * m->b.im, 0, -k * f->s * m->b.re);
  ph_quat q_change;
  by->a[0] = ph_quat_turn(m->a[0], left);
  by->a[2] = ph_quat_turn(m->a[2], right);
  q_change = ph_quat_add(by->a[0], by->a[2]);
  by->a[1] = ph_quat_scale(1 / f->m11, axpy(follow(m->plane, m->d, d, d_change,
                                                   m->nearest, m->q, q_change),
                                            -f->m01, q_change));
  by->length =
      (ph_vec3_dot(d, d_change) / ph_vec3_abs(d) + k * f->c * m->b.im) / f->m11;
}

static void change_by_phi(const struct member *m, struct change *by) {
  const ph_cplx i = {0, 1};
  by->a[0] = by->a[2] = ph_quat_of(0, 0, 0, 0);
  by->a[1] = ph_quat_scale(1 / m->f->m11, ph_quat_turn(m->d, i));
  by->length = 0;
}

/* alpha d/d alpha. */
static void change_by_alpha(const struct member *m, bool scaled,
                            struct change *by) {
  const struct ph_spatial_family *f = m->f;
  double q[4], grow = scaled ? 1 : 0, m00, m01, m02, m11, k, k1, k1_change;
  double around, k_change;
  ph_vec3 d = ph_spatial_d(f, m->b), d_change;
  ph_quat q_change = ph_quat_scale(0.5 * grow, m->q), turned;
  ph_atph_q_change(&f->space, q);
  m00 = q[0];
  m01 = 0.5 * q[1];
  m02 = 0.5 * q[3];
  m11 = q[2];
  k = f->k;
  k1 = f->m01 * f->m01 - f->m11 * f->m00;
  k_change = 2 * f->m01 * m01 - m02 * f->m11 - f->m02 * m11;
  k1_change = 2 * f->m01 * m01 - m11 * f->m00 - f->m11 * m00;
  d_change =
      ph_vec3_along(ph_vec3_scale(m11, f->dp), k1_change + grow * k1, f->sum);
  k_change = 2 * (k_change + grow * k) * f->m;
  d_change.x += k_change * m->b.re;
  d_change.z -= k_change * f->s * m->b.im;
  by->a[0] = ph_quat_scale(0.5 * grow, m->a[0]);
  by->a[2] = ph_quat_scale(0.5 * grow, m->a[2]);
  turned = follow(m->plane, m->d, d, d_change, m->nearest, m->q, q_change);
  turned = axpy(axpy(turned, -f->m01, q_change), -m01, m->q);
  by->a[1] = ph_quat_scale(1 / f->m11, axpy(turned, -m11, m->a[1]));
  around = (k1_change + grow * k1) * (f->ni + f->nf);
  by->length = (ph_vec3_dot(d, d_change) / ph_vec3_abs(d) - around -
                k_change * f->c * m->b.re - m11 * ph_spatial_length(f, m->b)) /
               f->m11;
}

/* The derivatives of log(length / sinc)^power times an integral, from those of
 * the integral by its polynomials. */
static void set_gradient(const struct member *m, bool scaled, double integral,
                         double power, const struct form *form,
                         struct form *form_, double *gradient) {
  const struct ph_spatial_family *f = m->f;
  const struct ph_atph *space = &f->space;
  double per_length = power * integral / ph_spatial_length(f, m->b), c_;
  double half = 0.5 * space->angle;
  struct change by[PH_SPATIAL_VARIABLES];
  ph_quat a_[3];
  unform(form, form_, space->c, m->a, a_, &c_);
  change_by_b(m, &by[PH_SPATIAL_B]);
  change_by_phi(m, &by[PH_SPATIAL_PHI]);
  change_by_alpha(m, scaled, &by[PH_SPATIAL_ALPHA]);
  for (size_t i = 0; i < PH_SPATIAL_VARIABLES; i++) {
    gradient[i] = per_length * by[i].length;
    for (size_t j = 0; j < 3; j++) {
      gradient[i] += ph_quat_dot(a_[j], by[i].a[j]);
    }
  }
  /* a dc/da = -(a/2)^2 sinc, a d(log sinc)/da = (c - sinc) / sinc */
  gradient[PH_SPATIAL_ALPHA] -=
      c_ * half * half * space->sinc +
      power * integral * (space->c - space->sinc) / space->sinc;
}

struct ph_spatial_section
ph_spatial_section_of(const struct ph_spatial_target *target, double alpha,
                      double b) {
  struct ph_spatial_section at = {.b = ph_cplx_polar(b)};
  struct ph_spatial_member nearest = {at.b, {1, 0}};
  ph_quat a[3];
  double scale;
  at.family = ph_spatial_fair_family(target, alpha);
  ph_spatial_preimage(&at.family, nearest, a);
  at.ends[0] = a[0];
  at.ends[1] = a[2];
  at.sum = ph_quat_add(a[0], a[2]);
  at.nearest = axpy(ph_quat_scale(at.family.m11, a[1]), at.family.m01, at.sum);
  scale = ph_spatial_length(&at.family, at.b) / at.family.space.sinc;
  at.scale = target->functional == 1 ? scale : scale * scale * scale;
  return at;
}

/* A member of a section. */
static ph_quat phase(const struct ph_spatial_section *at, double phi,
                     ph_quat a[3]) {
  const struct ph_spatial_family *f = &at->family;
  ph_quat d = ph_quat_turn(at->nearest, ph_cplx_polar(phi));
  a[0] = at->ends[0];
  a[1] = ph_quat_scale(1 / f->m11, axpy(d, -f->m01, at->sum));
  a[2] = at->ends[1];
  return d;
}

double ph_spatial_section_fair(const struct ph_spatial_target *target,
                               const struct ph_spatial_section *at,
                               size_t panels, double phi) {
  struct form form;
  ph_quat a[3];
  phase(at, phi, a);
  set_form(&form, at->family.space.c, a);
  return at->scale * integrate(target->rule, panels, target->functional, &form);
}

double ph_spatial_fair(const struct ph_spatial_target *target, size_t panels,
                       const struct ph_spatial_point *at, double *gradient) {
  const int k = target->functional;
  struct ph_spatial_section on =
      ph_spatial_section_of(target, at->alpha, at->b);
  const struct ph_spatial_family *f = &on.family;
  struct form form, form_;
  struct member m = {f, NULL, on.sum, .nearest = on.nearest, .b = on.b};
  double integral, b;
  ph_quat a[3];
  if (!gradient) {
    return ph_spatial_section_fair(target, &on, panels, at->phi);
  }
  m.d = phase(&on, at->phi, a);
  m.a = a;
  m.plane = ph_spatial_in_plane(f, on.b, &b);
  set_form(&form, f->space.c, a);
  integral = integrate_with(target->rule, panels, k, &form, &form_);
  set_gradient(&m, target->scaled, integral, k == 1 ? 1 : 3, &form, &form_,
               gradient);
  for (size_t i = 0; i < PH_SPATIAL_VARIABLES; i++) {
    gradient[i] *= on.scale;
  }
  gradient[PH_SPATIAL_ALPHA] /= at->alpha;
  return on.scale * integral;
}
