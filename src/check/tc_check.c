/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Checks of Tschirnhausen cubics (see tc_check.h). */
#include "check/tc_check.h"

#include <float.h>
#include <math.h>

/* Tolerances.  Everything is in closed form: beside the rounding of control
 * points there is that of some operations. */
static const double INTERPOLATION = 1e-13;
static const double PYTHAGOREAN = 1e-11;
static const double LENGTH = 1e-11;
static const double DIRECTION = 1e-12;

/* h1^2 - h0 h2 carries the errors of four factors. */
enum { ROUND_PRODUCT = 3 };

/* A direction that rounding may have turned by more than this is none. */
static const double NO_DIRECTION = 1;

/* A preimage that comes nearer to 0 than this part of its larger end is one
 * that vanishes. */
static const double STANDING = 1e-12;

/* ---- a cubic ------------------------------------------------------------ */

enum ph_status ph_tc_check_begin(struct ph_tc_check *c,
                                 const struct ph_curve *curve,
                                 const struct ph_arena *arena,
                                 const double *points, size_t n,
                                 struct ph_diag *diag) {
  *c = (struct ph_tc_check){.arena = arena,
                            .curve = curve,
                            .point = {.what = PH_D_INTERPOLATION_ERROR},
                            .tangent = {.what = PH_D_TANGENT_ERROR},
                            .derivative = {.what = PH_D_END_DERIVATIVE_ERROR},
                            .square = {.what = PH_D_PYTHAGOREAN_ERROR},
                            .joint = {.what = PH_D_CONTINUITY_ERROR},
                            .length = {.what = PH_D_LENGTH_ERROR},
                            .regular = true};
  if (curve->preimage.n != 2 || curve->preimage.dimension != 2) {
    return ph_fail(diag, PH_E_INTERNAL, "segments",
                   "are no Tschirnhausen cubics");
  }
  if (!ph_quad_gauss(&c->rule, PH_CHECK_NODES_PH)) {
    return ph_fail_memory(diag);
  }
  return ph_check_scale_of(points, n, 2, &c->scale)
             ? PH_OK
             : ph_fail(diag, PH_E_INTERNAL, "points", "have no extent");
}

ph_cplx ph_tc_check_direction(ph_cplx v) {
  double size = hypot(v.re, v.im);
  return ph_cplx_of(v.re / size, v.im / size);
}

struct ph_tc_cubic ph_tc_check_load(const struct ph_tc_check *c, size_t k) {
  const double *p = ph_curve_points(c->curve, k);
  const double *w = c->curve->preimage.v + 4 * k;
  struct ph_tc_cubic s = {.speed = 0};
  double reach = 0, rounding = c->scale.rounding;
  for (size_t i = 0; i < 4; i++) {
    s.p[i] = ph_tc_check_scaled(c, p + 2 * i);
    reach = ph_check_larger(reach,
                            ph_check_larger(fabs(s.p[i].re), fabs(s.p[i].im)));
  }
  for (size_t i = 0; i < 3; i++) {
    s.h[i] = ph_cplx_scale(3, ph_cplx_sub(s.p[i + 1], s.p[i]));
    s.speed = ph_check_larger(s.speed, ph_cplx_abs(s.h[i]));
  }
  for (size_t i = 0; i < 2; i++) {
    s.w[i] = ph_cplx_of(c->scale.root * w[2 * i], c->scale.root * w[2 * i + 1]);
  }
  /* The data are within 1/2 at unit scale. */
  if (reach > 1) {
    rounding += DBL_EPSILON * reach;
  }
  s.allowance = PH_CHECK_ROUND_FIRST * rounding;
  return s;
}

/* ---- what every cubic must be ------------------------------------------- */

/* (1), with and without the preimage. */
static void check_square(struct ph_tc_check *c, const struct ph_tc_cubic *s,
                         size_t k) {
  double allowed = PYTHAGOREAN * s->speed + s->allowance;
  ph_cplx alone =
      ph_cplx_sub(ph_cplx_mul(s->h[1], s->h[1]), ph_cplx_mul(s->h[0], s->h[2]));
  for (size_t i = 0; i < 3; i++) {
    ph_cplx product = ph_cplx_mul(s->w[i / 2], s->w[(i + 1) / 2]);
    ph_check_add(&c->square, k, ph_cplx_abs(ph_cplx_sub(s->h[i], product)),
                 s->speed, allowed);
  }
  ph_check_add(&c->square, k, ph_cplx_abs(alone) / s->speed, s->speed,
               ROUND_PRODUCT * allowed);
}

/* The length against the integral of |r'|. */
static void check_length(struct ph_tc_check *c, const struct ph_tc_cubic *s,
                         size_t k) {
  double claimed = ph_pow2_apply(c->scale.to_unit, c->curve->lengths[k]);
  double whole = ph_pow2_apply(c->scale.to_unit, c->curve->length);
  double length = 0;
  for (size_t i = 0; i < c->rule.n; i++) {
    double u = c->rule.node[i], v = 1 - u;
    ph_cplx r = ph_cplx_add(ph_cplx_scale(v * v, s->h[0]),
                            ph_cplx_add(ph_cplx_scale(2 * u * v, s->h[1]),
                                        ph_cplx_scale(u * u, s->h[2])));
    length += c->rule.weight[i] * ph_cplx_abs(r);
  }
  ph_check_add(&c->length, k, fabs(length - claimed), whole,
               LENGTH * claimed + s->allowance);
  ph_sum_add(&c->total, length);
  c->allowance += s->allowance;
}

/* How near w comes to 0: its distance from the line of w, or from the nearer
 * end of it. */
static void check_stop(struct ph_tc_check *c, const struct ph_tc_cubic *s,
                       size_t k) {
  ph_cplx step = ph_cplx_sub(s->w[1], s->w[0]);
  double a = ph_cplx_abs(s->w[0]), b = ph_cplx_abs(s->w[1]);
  double turn = fabs(ph_cplx_cross(s->w[0], step));
  double nearest = ph_check_smaller(a, b);
  if (ph_cplx_dot(s->w[0], step) < 0 && ph_cplx_dot(s->w[1], step) > 0) {
    nearest = turn / ph_cplx_abs(step);
  }
  if (!(nearest > STANDING * ph_check_larger(a, b)) && c->regular) {
    c->regular = false;
    c->irregular = k;
  }
}

void ph_tc_check_cubic(struct ph_tc_check *c, const struct ph_tc_cubic *s,
                       size_t k) {
  check_square(c, s, k);
  check_length(c, s, k);
  check_stop(c, s, k);
}

/* ---- ends and joints ---------------------------------------------------- */

/* By how much rounding of control points may turn r' at an end. */
static double turned(const struct ph_tc_cubic *s, size_t end) {
  double size = ph_cplx_abs(s->h[2 * end]);
  return size > 0 ? s->allowance / size : NO_DIRECTION;
}

void ph_tc_check_gap(struct ph_tc_check *c, const struct ph_tc_cubic *a,
                     const struct ph_tc_cubic *b, size_t k) {
  ph_check_add(&c->joint, k, ph_cplx_abs(ph_cplx_sub(a->p[3], b->p[0])),
               c->scale.size, INTERPOLATION * c->scale.size);
}

void ph_tc_check_joint(struct ph_tc_check *c, const struct ph_tc_cubic *a,
                       const struct ph_tc_cubic *b, size_t k) {
  double error = turned(a, 1) + turned(b, 0);
  ph_tc_check_gap(c, a, b, k);
  if (error < NO_DIRECTION) {
    ph_cplx jump = ph_cplx_sub(ph_tc_check_direction(a->h[2]),
                               ph_tc_check_direction(b->h[0]));
    ph_check_add(&c->joint, k, ph_cplx_abs(jump), 1, 2 * DIRECTION + error);
  }
}

void ph_tc_check_c1(struct ph_tc_check *c, const struct ph_tc_cubic *a,
                    const struct ph_tc_cubic *b, size_t k, double ratio,
                    double error) {
  ph_cplx jump = ph_cplx_sub(ph_cplx_scale(ratio, a->h[2]), b->h[0]);
  double speed = ph_check_larger(ratio * a->speed, b->speed);
  ph_check_add(&c->joint, k, ph_cplx_abs(jump), speed,
               (DIRECTION + error) * speed + ratio * a->allowance +
                   b->allowance);
}

void ph_tc_check_tangent(struct ph_tc_check *c, const struct ph_tc_cubic *s,
                         size_t k, size_t end, ph_cplx wanted, double error) {
  ph_cplx miss = ph_cplx_sub(ph_tc_check_direction(s->h[2 * end]), wanted);
  c->has_tangent = true;
  error += turned(s, end);
  if (!(error >= NO_DIRECTION)) {
    ph_check_add(&c->tangent, k, ph_cplx_abs(miss), 1, DIRECTION + error);
  }
}

void ph_tc_check_derivative(struct ph_tc_check *c, const struct ph_tc_cubic *s,
                            size_t k, size_t end, ph_cplx wanted,
                            double error) {
  double size = ph_cplx_abs(wanted);
  c->has_derivative = true;
  ph_check_add(&c->derivative, k,
               ph_cplx_abs(ph_cplx_sub(s->h[2 * end], wanted)), size,
               (DIRECTION + error) * size + s->allowance);
}

/* ---- the whole curve ---------------------------------------------------- */

void ph_tc_check_join(struct ph_tc_check *c, const struct ph_tc_check *next) {
  ph_check_join(&c->point, &next->point);
  ph_check_join(&c->tangent, &next->tangent);
  ph_check_join(&c->derivative, &next->derivative);
  ph_check_join(&c->square, &next->square);
  ph_check_join(&c->joint, &next->joint);
  ph_check_join(&c->length, &next->length);
  ph_sum_join(&c->total, &next->total);
  c->has_tangent |= next->has_tangent;
  c->has_derivative |= next->has_derivative;
  c->allowance += next->allowance;
  if (c->regular && !next->regular) {
    c->regular = false;
    c->irregular = next->irregular;
  }
}

enum ph_status ph_tc_check_conclude(struct ph_tc_check *c, bool may_stop,
                                    struct ph_diagnostics *diagnostics,
                                    struct ph_diag *diag) {
  const struct ph_check_error *const list[] = {
      &c->point,
      c->has_tangent ? &c->tangent : NULL,
      c->has_derivative ? &c->derivative : NULL,
      &c->square,
      &c->joint,
      &c->length};
  enum ph_status status;
  double claimed = ph_pow2_apply(c->scale.to_unit, c->curve->length);
  ph_check_add(&c->length, c->curve->n - 1,
               fabs(ph_sum_value(&c->total) - claimed), claimed,
               LENGTH * claimed + c->allowance);
  status = ph_check_conclude(list, 6, diagnostics, diag);
  if (status != PH_OK) {
    return status;
  }
  if (!c->regular && !may_stop) {
    ph_diagnostics_set(diagnostics, PH_D_REGULAR, 0);
    return ph_fail_at(diag, PH_E_NO_CONVERGENCE, "segments", c->irregular,
                      "is refused by its certificate: %s is false: it stands "
                      "still",
                      ph_diagnostic_name(PH_D_REGULAR));
  }
  ph_diagnostics_set(diagnostics, PH_D_REGULAR, c->regular);
  return PH_OK;
}
