/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Fields that several methods have (see fields.h). */
#include "solve/common/fields.h"

#include "base/sum.h"
#include "kernel/pi.h"
#include "kernel/pow2.h"

#include <math.h>

/* A last point within this of the first, relative to the largest coordinate,
 * repeats it. */
static const double REPEATED = 1e-14;

/* ... and a last vector within this of the first, relative to the longer. */
static const double REPEATED_VECTOR = 1e-9;

double ph_fields_largest(const double *v, size_t n) {
  double largest[4] = {0, 0, 0, 0}; /* none of which waits for another */
  size_t i = 0;
  for (; i + 4 <= n; i += 4) {
    for (size_t k = 0; k < 4; k++) {
      const double x = fabs(v[i + k]);
      largest[k] = x > largest[k] ? x : largest[k];
    }
  }
  for (; i < n; i++) {
    const double x = fabs(v[i]);
    largest[0] = x > largest[0] ? x : largest[0];
  }
  return fmax(fmax(largest[0], largest[1]), fmax(largest[2], largest[3]));
}

int ph_fields_exponent(double size) {
  int exponent = size > 0 ? -ph_pow2_exponent(size) - 2 : 0;
  return exponent - (exponent & 1);
}

/* ---- vectors ------------------------------------------------------------- */

ph_vec3 ph_fields_vector(const struct ph_value *value, size_t i) {
  const double *v = value->v + value->dimension * i;
  return ph_vec3_of(v[0], v[1], value->dimension > 2 ? v[2] : 0);
}

static double largest_of(ph_vec3 v) {
  return fmax(fmax(fabs(v.x), fabs(v.y)), fabs(v.z));
}

ph_vec3 ph_fields_unit(ph_vec3 v) {
  struct ph_pow2 scale = ph_pow2_of(-ph_pow2_exponent(largest_of(v)));
  return ph_vec3_unit(ph_vec3_of(ph_pow2_apply(scale, v.x),
                                 ph_pow2_apply(scale, v.y),
                                 ph_pow2_apply(scale, v.z)));
}

/* Whether the last vector is the first, or has its direction. */
static bool repeats_vector(const struct ph_value *value, bool direction) {
  ph_vec3 first = ph_fields_vector(value, 0);
  ph_vec3 last = ph_fields_vector(value, value->n - 1);
  double size = fmax(largest_of(first), largest_of(last));
  if (direction && largest_of(first) > 0 && largest_of(last) > 0) {
    first = ph_fields_unit(first);
    last = ph_fields_unit(last);
    size = 1;
  }
  return largest_of(ph_vec3_sub(last, first)) <= REPEATED_VECTOR * size;
}

enum ph_status ph_fields_vectors(const struct ph_problem *problem,
                                 enum ph_field_id id, size_t points_n,
                                 struct ph_diag *diag) {
  const struct ph_value *points = &problem->field[PH_F_POINTS];
  const struct ph_value *value = &problem->field[id];
  const char *name = ph_field_name(id);
  if (value->n != points->n && value->n != points_n) {
    return ph_fail(diag, PH_E_BAD_SHAPE, name,
                   "must have %zu vectors, one for each point, found %zu",
                   points->n, value->n);
  }
  if (value->dimension < points->dimension) {
    return ph_fail(diag, PH_E_BAD_SHAPE, name,
                   "must have vectors of 3 numbers, as the points have");
  }
  if (value->n > points_n && !repeats_vector(value, id == PH_F_TANGENTS)) {
    return ph_fail_at(diag, PH_E_BAD_VALUE, name, value->n - 1,
                      "must equal %s[0], as the point does", name);
  }
  for (size_t k = 0; k < points_n; k++) {
    if (!(largest_of(ph_fields_vector(value, k)) > 0)) {
      return ph_fail_at(diag, PH_E_ZERO_TANGENT, name, k, "must not be zero");
    }
  }
  return PH_OK;
}

/* ---- points, knots and angles -------------------------------------------- */

static bool repeats_first(const struct ph_value *points) {
  size_t n = points->n, dimension = points->dimension;
  const double *last = points->v + dimension * (n - 1);
  double size = ph_fields_largest(points->v, dimension * n), away = 0;
  for (size_t j = 0; j < dimension; j++) {
    away = hypot(away, last[j] - points->v[j]);
  }
  return away <= REPEATED * size;
}

enum ph_status ph_fields_segments(const struct ph_problem *problem,
                                  size_t *segments, struct ph_diag *diag) {
  const struct ph_value *points = &problem->field[PH_F_POINTS];
  bool closed = problem->field[PH_F_CLOSED].flag;
  size_t n = points->n;
  if (closed && n > 1 && repeats_first(points)) {
    n--;
  }
  if (n < (closed ? 3u : 2u)) {
    return ph_fail(diag, PH_E_TOO_FEW_POINTS, "points",
                   closed ? "must be at least 3 different points for a "
                            "closed curve, found %zu"
                          : "must be at least 2, found %zu",
                   n);
  }
  *segments = closed ? n : n - 1;
  return PH_OK;
}

enum ph_status ph_fields_coincide(struct ph_diag *diag, const char *name,
                                  size_t k, size_t to) {
  return ph_fail_at(diag, PH_E_COINCIDENT_POINTS, name, to,
                    "coincides with %s[%zu]; --merge=D joins points nearer "
                    "than D",
                    name, k);
}

enum ph_status ph_fields_knots(const struct ph_value *knots, size_t n,
                               bool closed, double *h, struct ph_diag *diag) {
  if (knots->n != n + 1) {
    return ph_fail(diag, PH_E_BAD_SHAPE, "knots",
                   closed ? "must have %zu numbers, one for each point and "
                            "one that closes the period, found %zu"
                          : "must have %zu numbers, one for each point, "
                            "found %zu",
                   n + 1, knots->n);
  }
  for (size_t k = 0; k < n; k++) {
    if (!(knots->v[k + 1] > knots->v[k])) {
      return ph_fail_at(diag, PH_E_BAD_VALUE, "knots", k + 1,
                        "must be greater than the knot before, %.17g, found "
                        "%.17g",
                        knots->v[k], knots->v[k + 1]);
    }
    h[k] = knots->v[k + 1] - knots->v[k];
    if (!isfinite(h[k])) {
      return ph_fail_at(diag, PH_E_TOO_LARGE, "knots", k + 1,
                        "differs from the knot before by more than a double "
                        "can hold");
    }
  }
  return PH_OK;
}

void ph_fields_sums(const double *h, size_t n, double *knots) {
  struct ph_sum sum = {0, 0};
  knots[0] = 0;
  for (size_t k = 0; k < n; k++) {
    ph_sum_add(&sum, h[k]);
    knots[k + 1] = ph_sum_value(&sum);
  }
}

double ph_fields_sum(const double *h, size_t n) {
  struct ph_sum sum = {0, 0};
  for (size_t k = 0; k < n; k++) {
    ph_sum_add(&sum, h[k]);
  }
  return ph_sum_value(&sum);
}

static enum ph_status out_of_range(const char *what, bool one, size_t k,
                                   const char *range, double x,
                                   struct ph_diag *diag) {
  static const char problem[] = "must be %s, found %.17g";
  return one ? ph_fail(diag, PH_E_BAD_VALUE, what, problem, range, x)
             : ph_fail_at(diag, PH_E_BAD_VALUE, what, k, problem, range, x);
}

enum ph_status ph_fields_each(const struct ph_value *value, const char *what,
                              size_t n, double below, const char *range,
                              double *v, struct ph_diag *diag) {
  bool one = value->kind == PH_NUMBER;
  if (!one && value->n != n) {
    return ph_fail(diag, PH_E_BAD_SHAPE, what,
                   "must have %zu numbers, one for each segment, found %zu", n,
                   value->n);
  }
  for (size_t k = 0; k < n; k++) {
    v[k] = one ? value->number : value->v[k];
    if (!(v[k] > 0 && v[k] < below)) {
      return out_of_range(what, one, k, range, v[k], diag);
    }
  }
  return PH_OK;
}

enum ph_status ph_fields_angles(const struct ph_value *value, size_t n,
                                double *angle, struct ph_diag *diag) {
  return ph_fields_each(value, "alpha", n, PH_PI, "between 0 and pi", angle,
                        diag);
}

void ph_warn_alpha(const struct ph_curve *curve, struct ph_result *result) {
  const double usual = 2.095; /* 2 pi/3, also as 0.6667 pi */
  size_t found = 0, first = 0;
  for (size_t k = 0; curve->preimage.alpha && k < curve->n; k++) {
    if (curve->preimage.alpha[k] > usual && found++ == 0) {
      first = k;
    }
  }
  if (found) {
    ph_warn(result, first, PH_W_LARGE_ALPHA,
            "alpha[%zu] is above 2 pi/3 (such segments: %zu)", first, found);
  }
}
