/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The certificate of planar C2 PH quintic and ATPH splines (see certify.h).
 *
 * The preimage that the record prints is taken as a claim: r' from the control
 * points must equal its square at the nodes of a Gauss rule, more nodes than
 * either has coefficients.  The same nodes integrate |r'|: exactly for a PH
 * quintic, to rounding for an ATPH segment.
 */
#include "check/certify.h"

#include "base/sum.h"
#include "check/error.h"
#include "kernel/cplx.h"

#include <float.h>
#include <math.h>

/* Tolerances; the solver stops at 1e-13 of each chord, and the middle leg of
 * the hodograph carries 15 times that. */
static const double INTERPOLATION = 1e-13;
static const double PYTHAGOREAN = 1e-11;
static const double PYTHAGOREAN_OF_SIZE = 1e-9; /* where the speed is huge */
static const double LENGTH = 1e-11;
static const double CONTINUITY = 1e-9;

/* Allowances in units of (rounding of a coordinate), beside error.h's: a second
 * difference of control points times 20, with a margin of 3.  Of knots the
 * difference counts, once for r' and twice for r''. */
enum { ROUND_SECOND = 256, ROUND_KNOT = 4 };

struct context {
  const struct ph_arena *arena; /* knows how much time there is */
  const struct ph_curve *curve;
  const double *points;
  size_t points_n;
  struct ph_check_scale scale;
  double farthest_knot; /* from 0, whose rounding is the largest */
  struct ph_quad rule;
  struct ph_check_space space; /* of the last segment */
};

/* A segment at unit scale, with respect to u in [0,1]. */
struct segment {
  ph_cplx start, end;
  ph_cplx leg[5]; /* differences of control points */
  ph_cplx w[3];
  ph_cplx first[2], second[2]; /* r' and r'' at both ends */
  double speed;                /* largest |coefficient| of r' */
};

static ph_cplx scaled(const struct context *c, const double *v) {
  return ph_cplx_of(ph_pow2_apply(c->scale.to_unit, v[0]),
                    ph_pow2_apply(c->scale.to_unit, v[1]));
}

static ph_cplx data_point(const struct context *c, size_t k) {
  return scaled(c, c->points + 2 * (k < c->points_n ? k : 0));
}

/* r'' at an end from the legs next to it, by differentiating (1) of error.h
 * there. */
static ph_cplx second_at(const struct ph_check_space *space, ph_cplx outer,
                         ph_cplx inner) {
  return ph_cplx_sub(ph_cplx_scale(1 / (space->of.sinc * space->mu[1]), inner),
                     ph_cplx_scale(4 * space->of.slope / space->mu[0], outer));
}

static struct segment segment_of(struct context *c, size_t k) {
  const double *p = c->curve->control_points + 12 * k;
  const double *w = c->curve->preimage.v + 6 * k;
  const double *alpha = c->curve->preimage.alpha;
  double root = alpha ? c->scale.root * sqrt(alpha[k]) : c->scale.root;
  struct segment s;
  ph_cplx from = scaled(c, p);
  ph_check_space_for(&c->space, &c->rule, c->curve, k);
  s.start = from;
  s.speed = 0;
  for (size_t i = 0; i < 5; i++) {
    ph_cplx to = scaled(c, p + 2 * (i + 1));
    s.leg[i] = ph_cplx_sub(to, from);
    s.speed =
        ph_check_larger(s.speed, ph_cplx_abs(s.leg[i]) /
                                     (ph_check_binomial(i) * c->space.mu[i]));
    from = to;
  }
  s.end = from;
  for (size_t i = 0; i < 3; i++) {
    s.w[i] = ph_cplx_of(root * w[2 * i], root * w[2 * i + 1]);
  }
  s.first[0] = ph_cplx_scale(1 / c->space.mu[0], s.leg[0]);
  s.first[1] = ph_cplx_scale(1 / c->space.mu[4], s.leg[4]);
  s.second[0] = second_at(&c->space, s.leg[0], s.leg[1]);
  s.second[1] = ph_cplx_scale(-1, second_at(&c->space, s.leg[4], s.leg[3]));
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
                           size_t k, struct ph_check_error *square) {
  double length = 0, worst = 0;
  for (size_t i = 0; i < c->rule.n; i++) {
    ph_cplx r = combine(c->space.leg[i], s->leg, 5);
    ph_cplx w = combine(c->space.square[i], s->w, 3);
    double error = ph_cplx_abs(ph_cplx_sub(r, ph_cplx_mul(w, w)));
    length += c->rule.weight[i] * ph_cplx_abs(r);
    if (!(error <= worst)) {
      worst = error;
    }
  }
  ph_check_add(square, k, worst, c->scale.size,
               ph_check_smaller(PYTHAGOREAN * s->speed,
                                PYTHAGOREAN_OF_SIZE * c->scale.size) +
                   PH_CHECK_ROUND_FIRST * c->scale.rounding);
  return length;
}

/* Jumps of r' and r'' between two segments, in the shorter interval's unit and
 * relative to the larger speed of the two. */
static void check_joint(const struct context *c, const struct segment *a,
                        double ha, const struct segment *b, double hb, size_t k,
                        struct ph_check_error *joint) {
  double h = ph_check_smaller(ha, hb), fa = h / ha, fb = h / hb;
  double knot = ROUND_KNOT * DBL_EPSILON * c->farthest_knot / h;
  double speed = ph_check_larger(fa * a->speed, fb * b->speed);
  ph_cplx first = ph_cplx_sub(ph_cplx_scale(fa, a->first[1]),
                              ph_cplx_scale(fb, b->first[0]));
  ph_cplx second = ph_cplx_sub(ph_cplx_scale(fa * fa, a->second[1]),
                               ph_cplx_scale(fb * fb, b->second[0]));
  ph_check_add(joint, k, ph_cplx_abs(first), speed,
               (CONTINUITY + knot) * speed +
                   PH_CHECK_ROUND_FIRST * c->scale.rounding);
  ph_check_add(joint, k, ph_cplx_abs(second), speed,
               (CONTINUITY + 8 * knot) * speed +
                   ROUND_SECOND * c->scale.rounding);
}

static void check_end(const struct context *c, const double *given,
                      ph_cplx derivative, double h, size_t segment,
                      struct ph_check_error *end) {
  ph_cplx wanted = ph_cplx_scale(h, scaled(c, given));
  double size = ph_cplx_abs(wanted);
  double knot = ROUND_KNOT * DBL_EPSILON * c->farthest_knot / h;
  ph_check_add(end, segment, ph_cplx_abs(ph_cplx_sub(derivative, wanted)), size,
               (CONTINUITY + knot) * size +
                   PH_CHECK_ROUND_FIRST * c->scale.rounding);
}

struct checks {
  struct ph_check_error point, end, square, joint, length;
};

static void check_segments(struct context *c, const struct ph_value *ends,
                           struct checks *checks) {
  const struct ph_curve *curve = c->curve;
  const double *t = curve->knots;
  size_t n = curve->n;
  struct segment first = segment_of(c, 0), before = first;
  struct ph_sum total = {0, 0};
  double claimed = ph_pow2_apply(c->scale.to_unit, curve->length);
  for (size_t k = 0; k < n && !ph_arena_late(c->arena); k++) {
    struct segment s = segment_of(c, k);
    double length = check_square(c, &s, k, &checks->square);
    double wanted = ph_pow2_apply(c->scale.to_unit, curve->lengths[k]);
    double away =
        ph_check_larger(ph_cplx_abs(ph_cplx_sub(s.start, data_point(c, k))),
                        ph_cplx_abs(ph_cplx_sub(s.end, data_point(c, k + 1))));
    ph_check_add(&checks->point, k, away, c->scale.size,
                 INTERPOLATION * c->scale.size);
    ph_check_add(&checks->length, k, fabs(length - wanted), claimed,
                 LENGTH * wanted + PH_CHECK_ROUND_FIRST * c->scale.rounding);
    ph_sum_add(&total, length);
    if (k > 0) {
      check_joint(c, &before, t[k] - t[k - 1], &s, t[k + 1] - t[k], k,
                  &checks->joint);
    }
    before = s;
  }
  ph_check_add(
      &checks->length, n - 1, fabs(ph_sum_value(&total) - claimed), claimed,
      LENGTH * claimed + (double)n * PH_CHECK_ROUND_FIRST * c->scale.rounding);
  if (curve->closed) {
    check_joint(c, &before, t[n] - t[n - 1], &first, t[1] - t[0], 0,
                &checks->joint);
  } else if (ends->kind == PH_VECTORS) {
    check_end(c, ends->v, first.first[0], t[1] - t[0], 0, &checks->end);
    check_end(c, ends->v + 2, before.first[1], t[n] - t[n - 1], n - 1,
              &checks->end);
  }
}

enum ph_status ph_check_planar(const struct ph_problem *problem,
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
  const struct ph_check_error *const list[] = {
      &checks.point, ends->kind == PH_VECTORS ? &checks.end : NULL,
      &checks.square, &checks.joint, &checks.length};
  struct context c = {.arena = scratch,
                      .curve = curve,
                      .points = problem->field[PH_F_POINTS].v,
                      .points_n = curve->closed ? curve->n : curve->n + 1,
                      .farthest_knot = ph_check_larger(
                          fabs(curve->knots[0]), fabs(curve->knots[curve->n]))};
  if (!ph_quad_gauss(&c.rule, curve->preimage.alpha ? PH_CHECK_NODES_ATPH
                                                    : PH_CHECK_NODES_PH)) {
    return ph_fail_memory(diag);
  }
  c.space = ph_check_space_of(&c.rule, 0);
  if (!ph_check_scale_of(c.points, c.points_n, 2, &c.scale)) {
    return ph_fail(diag, PH_INTERNAL, "points", "have no extent");
  }
  check_segments(&c, ends, &checks);
  return ph_check_conclude(list, 5, diagnostics, diag);
}
