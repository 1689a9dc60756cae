/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The certificate of planar C2 PH quintic and ATPH splines (see cert.h).
 *
 * The preimage that the record prints is taken as a claim: r' from the control
 * points must equal its square at the nodes of a Gauss rule, more nodes than
 * either has coefficients.  The same nodes integrate |r'|: exactly for a PH
 * quintic, to rounding for an ATPH segment.
 *
 * The derivative of the basis of control points is
 *   r'(u) = sum_j (p[j+1] - p[j]) S0^(4-j) S1^j / mu_j                 (1)
 * with S0, S1 and mu as in kernel/atph.h; mu_j is integrated here by the same
 * Gauss rule.
 */
#include "cert/cert.h"

#include "base/sum.h"
#include "curve/cross.h"
#include "curve/energy.h"
#include "kernel/atph.h"
#include "kernel/cplx.h"
#include "kernel/pow2.h"
#include "kernel/quad.h"

#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <string.h>

/* Tolerances; the solver stops at 1e-13 of each chord, and the middle leg of
 * the hodograph carries 15 times that. */
static const double INTERPOLATION = 1e-13;
static const double PYTHAGOREAN = 1e-11;
static const double PYTHAGOREAN_OF_SIZE = 1e-9; /* where the speed is huge */
static const double LENGTH = 1e-11;
static const double CONTINUITY = 1e-9;

/* The spacing of subnormal numbers. */
static const double SMALLEST = 4.9406564584124654e-324;

/* Allowances in units of (rounding of a coordinate): a first difference of
 * control points times 5, a second one times 20, with a margin of 3.  Of knots
 * the difference counts, once for r' and twice for r''. */
enum { ROUND_FIRST = 32, ROUND_SECOND = 256, ROUND_KNOT = 4 };

/* No more is allowed for: then r' = w^2 would be a claim of no digit. */
static const double ROUNDING_OF_SIZE = 1e-3 / ROUND_FIRST;

/* Nodes: exact for degree 11, as |r'| has 4 and mu_j has 4; for angles below pi
 * 12 nodes reach rounding. */
enum { NODES_PH = 6, NODES_ATPH = 12 };

static const double BINOMIAL[5] = {1, 4, 6, 4, 1};

/* A space of preimages, at the nodes. */
struct shape {
  double angle, slope, sinc;
  double mu[5];
  double leg[NODES_ATPH][5];    /* S0^(4-j) S1^j / mu_j */
  double square[NODES_ATPH][3]; /* S0^2, 2 c S0 S1, S1^2 */
};

/* One error: the largest so far, whether all were within their tolerance, and
 * by how much the worst was not. */
struct check {
  enum ph_diagnostic what;
  double reported; /* the largest, as in the record */
  double excess;   /* the largest error / allowed */
  double value;    /* the error and */
  double allowed;  /* its tolerance at the largest excess */
  size_t where;
};

struct context {
  const struct ph_curve *curve;
  const double *points;
  size_t points_n;
  struct ph_pow2 scale; /* to unit scale */
  double root;          /* for the preimage */
  double size;          /* half the diagonal, at unit scale */
  double rounding;      /* of a coordinate, at unit scale */
  double farthest_knot; /* from 0, whose rounding is the largest */
  struct ph_quad rule;
  struct shape shape; /* of the last segment */
};

/* A segment at unit scale, with respect to u in [0,1]. */
struct segment {
  ph_cplx start, end;
  ph_cplx leg[5]; /* differences of control points */
  ph_cplx w[3];
  ph_cplx first[2], second[2]; /* r' and r'' at both ends */
  double speed;                /* largest |coefficient| of r' */
};

/* Whether x is larger than the largest so far; NaN is, and stays. */
static bool is_larger(double x, double largest) {
  return !(x <= largest) && !isnan(largest);
}

static void check_add(struct check *check, size_t where, double error,
                      double unit, double allowed) {
  if (is_larger(error / unit, check->reported)) {
    check->reported = error / unit;
  }
  if (is_larger(error / allowed, check->excess)) {
    check->excess = error / allowed;
    check->value = error / unit;
    check->allowed = allowed / unit;
    check->where = where;
  }
}

/* Not fmax and fmin, which are calls of the library. */
static inline double larger(double a, double b) {
  return a > b ? a : b;
}

static inline double smaller(double a, double b) {
  return a < b ? a : b;
}

static ph_cplx scaled(const struct context *c, const double *v) {
  return ph_cplx_of(ph_pow2_apply(c->scale, v[0]),
                    ph_pow2_apply(c->scale, v[1]));
}

static ph_cplx data_point(const struct context *c, size_t k) {
  return scaled(c, c->points + 2 * (k < c->points_n ? k : 0));
}

static bool set_scale(struct context *c) {
  const double *q = c->points;
  double low[2] = {q[0], q[1]}, high[2] = {q[0], q[1]}, largest = 0;
  int exponent;
  for (size_t k = 0; k < 2 * c->points_n; k++) {
    low[k % 2] = smaller(low[k % 2], q[k]);
    high[k % 2] = larger(high[k % 2], q[k]);
    largest = larger(largest, fabs(q[k]));
  }
  if (!(largest > 0)) {
    return false;
  }
  exponent = -ph_pow2_exponent(largest) - 2;
  exponent -= exponent & 1;
  c->scale = ph_pow2_of(exponent);
  c->root = ldexp(1, exponent / 2);
  c->size =
      0.5 *
      hypot(ph_pow2_apply(c->scale, high[0]) - ph_pow2_apply(c->scale, low[0]),
            ph_pow2_apply(c->scale, high[1]) - ph_pow2_apply(c->scale, low[1]));
  c->rounding = smaller(DBL_EPSILON * ph_pow2_apply(c->scale, largest) +
                            ph_pow2_apply(c->scale, SMALLEST),
                        ROUNDING_OF_SIZE * c->size);
  return c->size > 0;
}

/* Powers S0^(4-j) S1^j at a node. */
static void powers_at(const double base[2], double power[5]) {
  double p = base[0] * base[0], q = base[1] * base[1], pq = base[0] * base[1];
  power[0] = p * p;
  power[1] = p * pq;
  power[2] = p * q;
  power[3] = q * pq;
  power[4] = q * q;
}

static struct shape shape_of(const struct ph_quad *rule, double angle) {
  struct shape shape = {.angle = angle};
  struct ph_atph space = ph_atph_of(angle);
  shape.slope = space.slope;
  shape.sinc = space.sinc;
  for (size_t i = 0; i < rule->n; i++) {
    double base[2];
    ph_atph_basis(&space, rule->node[i], base);
    powers_at(base, shape.leg[i]);
    for (size_t j = 0; j < 5; j++) {
      shape.mu[j] += rule->weight[i] * shape.leg[i][j];
    }
    shape.square[i][0] = base[0] * base[0];
    shape.square[i][1] = 2 * space.c * base[0] * base[1];
    shape.square[i][2] = base[1] * base[1];
  }
  for (size_t i = 0; i < rule->n; i++) {
    for (size_t j = 0; j < 5; j++) {
      shape.leg[i][j] /= shape.mu[j];
    }
  }
  return shape;
}

/* Makes c->shape that of segment k: neighbours often share it. */
static void set_shape(struct context *c, size_t k) {
  double angle = c->curve->alpha ? c->curve->alpha[k] : 0;
  if (!(angle <= c->shape.angle && angle >= c->shape.angle)) {
    c->shape = shape_of(&c->rule, angle);
  }
}

/* r'' at an end from the legs next to it, by differentiating (1) there. */
static ph_cplx second_at(const struct shape *shape, ph_cplx outer,
                         ph_cplx inner) {
  return ph_cplx_sub(ph_cplx_scale(1 / (shape->sinc * shape->mu[1]), inner),
                     ph_cplx_scale(4 * shape->slope / shape->mu[0], outer));
}

static struct segment segment_of(struct context *c, size_t k) {
  const double *p = c->curve->control_points + 12 * k;
  const double *w = c->curve->preimage + 6 * k;
  const double *alpha = c->curve->alpha;
  double root = alpha ? c->root * sqrt(alpha[k]) : c->root;
  struct segment s;
  ph_cplx from = scaled(c, p);
  set_shape(c, k);
  s.start = from;
  s.speed = 0;
  for (size_t i = 0; i < 5; i++) {
    ph_cplx to = scaled(c, p + 2 * (i + 1));
    s.leg[i] = ph_cplx_sub(to, from);
    s.speed =
        larger(s.speed, ph_cplx_abs(s.leg[i]) / (BINOMIAL[i] * c->shape.mu[i]));
    from = to;
  }
  s.end = from;
  for (size_t i = 0; i < 3; i++) {
    s.w[i] = ph_cplx_of(root * w[2 * i], root * w[2 * i + 1]);
  }
  s.first[0] = ph_cplx_scale(1 / c->shape.mu[0], s.leg[0]);
  s.first[1] = ph_cplx_scale(1 / c->shape.mu[4], s.leg[4]);
  s.second[0] = second_at(&c->shape, s.leg[0], s.leg[1]);
  s.second[1] = ph_cplx_scale(-1, second_at(&c->shape, s.leg[4], s.leg[3]));
  return s;
}

static ph_cplx combine(const double *basis, const ph_cplx *coefficient,
                       size_t n) {
  ph_cplx sum = {0, 0};
  for (size_t i = 0; i < n; i++) {
    sum.re += basis[i] * coefficient[i].re;
    sum.im += basis[i] * coefficient[i].im;
  }
  return sum;
}

/* r' = w^2 at the nodes; returns the integral of |r'|. */
static double check_square(const struct context *c, const struct segment *s,
                           size_t k, struct check *square) {
  double length = 0, worst = 0;
  for (size_t i = 0; i < c->rule.n; i++) {
    ph_cplx r = combine(c->shape.leg[i], s->leg, 5);
    ph_cplx w = combine(c->shape.square[i], s->w, 3);
    double error = ph_cplx_abs(ph_cplx_sub(r, ph_cplx_mul(w, w)));
    length += c->rule.weight[i] * ph_cplx_abs(r);
    if (!(error <= worst)) {
      worst = error;
    }
  }
  check_add(square, k, worst, c->size,
            smaller(PYTHAGOREAN * s->speed, PYTHAGOREAN_OF_SIZE * c->size) +
                ROUND_FIRST * c->rounding);
  return length;
}

/* Jumps of r' and r'' between two segments, in the shorter interval's unit and
 * relative to the larger speed of the two. */
static void check_joint(const struct context *c, const struct segment *a,
                        double ha, const struct segment *b, double hb, size_t k,
                        struct check *joint) {
  double h = smaller(ha, hb), fa = h / ha, fb = h / hb;
  double knot = ROUND_KNOT * DBL_EPSILON * c->farthest_knot / h;
  double speed = larger(fa * a->speed, fb * b->speed);
  ph_cplx first = ph_cplx_sub(ph_cplx_scale(fa, a->first[1]),
                              ph_cplx_scale(fb, b->first[0]));
  ph_cplx second = ph_cplx_sub(ph_cplx_scale(fa * fa, a->second[1]),
                               ph_cplx_scale(fb * fb, b->second[0]));
  check_add(joint, k, ph_cplx_abs(first), speed,
            (CONTINUITY + knot) * speed + ROUND_FIRST * c->rounding);
  check_add(joint, k, ph_cplx_abs(second), speed,
            (CONTINUITY + 8 * knot) * speed + ROUND_SECOND * c->rounding);
}

static void check_end(const struct context *c, const double *given,
                      ph_cplx derivative, double h, size_t segment,
                      struct check *end) {
  ph_cplx wanted = ph_cplx_scale(h, scaled(c, given));
  double size = ph_cplx_abs(wanted);
  double knot = ROUND_KNOT * DBL_EPSILON * c->farthest_knot / h;
  check_add(end, segment, ph_cplx_abs(ph_cplx_sub(derivative, wanted)), size,
            (CONTINUITY + knot) * size + ROUND_FIRST * c->rounding);
}

struct checks {
  struct check point, end, square, joint, length;
};

static void check_segments(struct context *c, const struct ph_value *ends,
                           struct checks *checks) {
  const struct ph_curve *curve = c->curve;
  const double *t = curve->knots;
  size_t n = curve->n;
  struct segment first = segment_of(c, 0), before = first;
  struct ph_sum total = {0, 0};
  double claimed = ph_pow2_apply(c->scale, curve->length);
  for (size_t k = 0; k < n; k++) {
    struct segment s = segment_of(c, k);
    double length = check_square(c, &s, k, &checks->square);
    double wanted = ph_pow2_apply(c->scale, curve->lengths[k]);
    double away = larger(ph_cplx_abs(ph_cplx_sub(s.start, data_point(c, k))),
                         ph_cplx_abs(ph_cplx_sub(s.end, data_point(c, k + 1))));
    check_add(&checks->point, k, away, c->size, INTERPOLATION * c->size);
    check_add(&checks->length, k, fabs(length - wanted), claimed,
              LENGTH * wanted + ROUND_FIRST * c->rounding);
    ph_sum_add(&total, length);
    if (k > 0) {
      check_joint(c, &before, t[k] - t[k - 1], &s, t[k + 1] - t[k], k,
                  &checks->joint);
    }
    before = s;
  }
  check_add(&checks->length, n - 1, fabs(ph_sum_value(&total) - claimed),
            claimed, LENGTH * claimed + (double)n * ROUND_FIRST * c->rounding);
  if (curve->closed) {
    check_joint(c, &before, t[n] - t[n - 1], &first, t[1] - t[0], 0,
                &checks->joint);
  } else if (ends->kind == PH_VECTORS) {
    check_end(c, ends->v, first.first[0], t[1] - t[0], 0, &checks->end);
    check_end(c, ends->v + 2, before.first[1], t[n] - t[n - 1], n - 1,
              &checks->end);
  }
}

/* Stores the error; a failure if it exceeded its tolerance anywhere. */
static enum ph_status conclude(const struct check *check,
                               struct ph_diagnostics *diagnostics,
                               struct ph_diag *diag) {
  ph_diagnostics_set(diagnostics, check->what, check->reported);
  if (check->excess <= 1 && isfinite(check->reported)) {
    return PH_OK;
  }
  return ph_fail_at(diag, PH_NO_CONVERGENCE, "segments", check->where,
                    "is refused by its certificate: %s is %.3g, at most %.3g "
                    "is allowed",
                    ph_diagnostic_name(check->what), check->value,
                    check->allowed);
}

static bool all_finite(const double *v, size_t n) {
  for (size_t i = 0; i < n; i++) {
    if (!isfinite(v[i])) {
      return false;
    }
  }
  return true;
}

static void set_finite(struct ph_diagnostics *diagnostics,
                       enum ph_diagnostic which, double value) {
  if (isfinite(value)) {
    ph_diagnostics_set(diagnostics, which, value);
  }
}

/* How fair the curve is, no number where it stands still and has no curvature,
 * and whether it crosses itself. */
static enum ph_status describe(const struct ph_curve *curve,
                               struct ph_arena *scratch,
                               struct ph_diagnostics *diagnostics,
                               struct ph_diag *diag) {
  double length = curve->length;
  struct ph_energy energy;
  struct ph_cross cross;
  enum ph_status status = ph_cross_planar(curve, scratch, &cross, diag);
  if (status != PH_OK) {
    return status;
  }
  if (!ph_energy_planar(curve, &energy)) {
    return ph_fail_memory(diag);
  }
  ph_diagnostics_set(diagnostics, PH_D_LOOPS, (double)cross.loops);
  ph_diagnostics_set(diagnostics, PH_D_SIMPLE, cross.simple);
  set_finite(diagnostics, PH_D_ENERGY, energy.bending);
  set_finite(diagnostics, PH_D_MV, energy.varying);
  set_finite(diagnostics, PH_D_IES, energy.bending * length);
  set_finite(diagnostics, PH_D_IMV, energy.varying * length * length * length);
  set_finite(diagnostics, PH_D_ROTATION_INDEX, energy.rotation);
  set_finite(diagnostics, PH_D_ABSOLUTE_ROTATION_INDEX,
             energy.absolute_rotation);
  return PH_OK;
}

enum ph_status ph_cert_planar(const struct ph_problem *problem,
                              const struct ph_curve *curve,
                              struct ph_arena *scratch,
                              struct ph_diagnostics *diagnostics,
                              struct ph_diag *diag) {
  const struct ph_value *ends = &problem->field[PH_F_END_DERIVATIVES];
  struct checks checks = {{.what = PH_D_INTERPOLATION_ERROR},
                          {.what = PH_D_END_DERIVATIVE_ERROR},
                          {.what = PH_D_PYTHAGOREAN_ERROR},
                          {.what = PH_D_CONTINUITY_ERROR},
                          {.what = PH_D_LENGTH_ERROR}};
  const struct check *const list[] = {&checks.point, &checks.end,
                                      &checks.square, &checks.joint,
                                      &checks.length};
  struct context c = {.curve = curve,
                      .points = problem->field[PH_F_POINTS].v,
                      .points_n = curve->closed ? curve->n : curve->n + 1,
                      .farthest_knot = larger(fabs(curve->knots[0]),
                                              fabs(curve->knots[curve->n]))};
  if (!all_finite(curve->control_points, 12 * curve->n) ||
      !all_finite(curve->preimage, 6 * curve->n) ||
      !all_finite(curve->knots, curve->n + 1) ||
      !all_finite(curve->lengths, curve->n) || !isfinite(curve->length)) {
    return ph_fail(diag, PH_TOO_LARGE, NULL,
                   "the curve exceeds the range of a double");
  }
  if (!ph_quad_gauss(&c.rule, curve->alpha ? NODES_ATPH : NODES_PH)) {
    return ph_fail_memory(diag);
  }
  c.shape = shape_of(&c.rule, 0);
  if (!set_scale(&c)) {
    return ph_fail(diag, PH_INTERNAL, "points", "have no extent");
  }
  check_segments(&c, ends, &checks);
  for (size_t i = 0; i < sizeof list / sizeof list[0]; i++) {
    enum ph_status status = PH_OK;
    if (list[i] != &checks.end || ends->kind == PH_VECTORS) {
      status = conclude(list[i], diagnostics, diag);
    }
    if (status != PH_OK) {
      return status;
    }
  }
  return describe(curve, scratch, diagnostics, diag);
}
