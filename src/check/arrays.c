/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Whether a result holds a curve at all: arrays, and numbers in their range. */
#include "check/checks.h"

#include "kernel/pi.h"

static bool wrong(struct ph_check *v, struct ph_check_where where,
                  const char *what) {
  ph_check_wrong(v, PH_CHECK_SHAPE, where, what);
  return false;
}

/* The first of n numbers that is not finite, or n. */
static size_t finite_until(const double *x, size_t n) {
  size_t i = 0;
  while (i < n && isfinite(x[i])) {
    i++;
  }
  return i;
}

/* Whether n numbers of some kind are finite, every segment's first one `each'
 * behind that of the one before. */
static bool are_finite(struct ph_check *v, const double *x, size_t n,
                       size_t each, const char *member) {
  size_t i = finite_until(x, n), last = v->curve->n - 1;
  return i == n ||
         wrong(v, ph_check_in(i / each < last ? i / each : last, member),
               "holds what is not finite");
}

static bool wrong_in(struct ph_check *v, const char *member, const char *what) {
  return wrong(v, ph_check_of(NULL, PH_CHECK_ONE, member), what);
}

bool ph_check_is_promised(struct ph_check *v) {
  const char *member;
  const char *breach = ph_promise_breach(v->promise, v->curve, &member);
  ph_check_done(v, PH_CHECK_SHAPE);
  return !breach || wrong_in(v, member, breach);
}

/* Whether the curve is one that the command makes, with all that such a curve
 * has. */
static bool is_of_command(struct ph_check *v) {
  const struct ph_curve *c = v->curve;
  const struct ph_promise *promise = v->promise;
  if (!ph_check_is_promised(v)) {
    return false;
  }
  if (promise->intervals != (v->intervals_n > 0)) {
    return wrong_in(v, "intervals",
                    promise->intervals ? "are missing"
                                       : "are not what the command makes");
  }
  if ((promise->tension && !v->kind->converted) !=
      (c->choice.tension != NULL)) {
    return wrong(v, ph_check_in(0, "tension"),
                 c->choice.tension ? "is not of such a curve" : "is missing");
  }
  return true;
}

/* Whether intervals of the data are made of all segments, in their order. */
static bool is_divided(struct ph_check *v) {
  size_t next = 0;
  for (size_t i = 0; i < v->intervals_n; i++) {
    const struct ph_interval *in = &v->intervals[i];
    if (in->first != next || in->last < in->first || in->last >= v->curve->n) {
      return wrong(v, ph_check_of("intervals", i, "segments"),
                   "are not the next ones");
    }
    next = in->last + 1;
  }
  return v->intervals_n == 0 || next == v->curve->n ||
         wrong(v, ph_check_of("intervals", v->intervals_n - 1, "segments"),
               "are not the last ones");
}

static bool is_parametrised(struct ph_check *v) {
  const struct ph_curve *c = v->curve;
  if (!c->knots) {
    return wrong(v, ph_check_in(0, "interval"), "is missing");
  }
  for (size_t k = 0; k < c->n; k++) {
    if (!(c->knots[k + 1] > c->knots[k] && isfinite(c->knots[k]) &&
          isfinite(c->knots[k + 1]))) {
      return wrong(v, ph_check_in(k, "interval"), "is no interval");
    }
  }
  if (v->kind->angles != (c->preimage.alpha != NULL)) {
    return wrong(v, ph_check_in(0, "alpha"),
                 c->preimage.alpha ? "is of ATPH curves alone" : "is missing");
  }
  for (size_t k = 0; c->preimage.alpha && k < c->n; k++) {
    if (!(c->preimage.alpha[k] > 0 && c->preimage.alpha[k] < PH_PI)) {
      return wrong(v, ph_check_in(k, "alpha"), "is not between 0 and pi");
    }
  }
  return true;
}

static bool is_preimage(struct ph_check *v) {
  const struct ph_curve *c = v->curve;
  const size_t each = c->preimage.n * c->preimage.dimension;
  if (!c->preimage.v) {
    return true;
  }
  if (c->preimage.n != (c->degree + 1) / 2 || c->degree % 2 == 0 ||
      c->preimage.dimension != 2 * (c->dimension - 1) || !v->kind->square) {
    return wrong(v, ph_check_in(0, "preimage"),
                 "is none of such control points");
  }
  return are_finite(v, c->preimage.v, c->n * each, each, "preimage");
}

static bool is_sphere(struct ph_check *v) {
  const struct ph_curve *c = v->curve;
  size_t nodes = c->closed ? c->n : c->n + 1;
  if (!v->kind->sphere) {
    return !(c->sphere.radius > 0) ||
           wrong(v, ph_check_of("radius", PH_CHECK_ONE, NULL),
                 "is not of such a curve");
  }
  if (!(c->sphere.radius > 0) || !isfinite(c->sphere.radius)) {
    return wrong(v, ph_check_of("radius", PH_CHECK_ONE, NULL),
                 "is not positive");
  }
  if (finite_until(c->sphere.center, 3) < 3) {
    return wrong(v, ph_check_of("center", PH_CHECK_ONE, NULL), "is not finite");
  }
  if (!c->sphere.tensions || finite_until(c->sphere.tensions, nodes) < nodes) {
    return wrong(v, ph_check_of("tensions", PH_CHECK_ONE, NULL),
                 c->sphere.tensions ? "hold what is not finite"
                                    : "are missing");
  }
  return true;
}

bool ph_check_arrays(struct ph_check *v) {
  const struct ph_curve *c = v->curve;
  return is_of_command(v) && is_divided(v) &&
         are_finite(v, c->control_points, ph_curve_points_n(c) * c->dimension,
                    ph_curve_stride(c), "control_points") &&
         is_parametrised(v) && is_preimage(v) && is_sphere(v);
}
