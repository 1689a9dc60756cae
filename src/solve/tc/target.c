/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Approximation of a chain of Bezier curves (see tc.h).
 *
 * The chain is moved to the middle of its box and brought to unit scale by a
 * power of two, where curves far from the origin lose nothing.
 */
#include "solve/tc/tc.h"

#include "base/sum.h"
#include "kernel/pow2.h"
#include "solve/common/fields.h"
#include "solve/tc/approx.h"

#include <float.h>
#include <math.h>
#include <string.h>

/* A number of cubics is given no smaller tolerance than so many times what
 * rounding of coordinates may add; shorter cubics than SHORT times that have no
 * direction. */
static const double CLEAR = 1024, SHORT = 64;

/* As many cubics as a user may ask for. */
static const double PIECES_MAX = 1e6;

struct target {
  const struct ph_value *value; /* of the field */
  const char *field;
  bool closed;
  size_t n; /* Bezier curves */
  struct ph_tc_bezier *bezier;
  size_t *first;    /* [n + 1] cubics of each */
  double tolerance; /* 0: pieces */
  size_t pieces;
  double middle[2];
  double far; /* the largest coordinate */
  int exponent;
};

static size_t size_of(const struct target *t, size_t k) {
  return t->value->kind == PH_POLYLINE ? t->value->sizes[k] : t->value->n;
}

/* ---- reading ------------------------------------------------------------ */

static enum ph_status fail_curve(const struct target *t, size_t k,
                                 enum ph_status why, struct ph_diag *diag,
                                 const char *text) {
  return t->value->kind == PH_POLYLINE
             ? ph_fail_at(diag, why, t->field, k, "%s", text)
             : ph_fail(diag, why, t->field, "%s", text);
}

static enum ph_status fail_degree(const struct target *t, size_t k,
                                  struct ph_diag *diag) {
  static const char text[] = "has degree %zu, at most %d is allowed";
  size_t degree = size_of(t, k) - 1;
  return t->value->kind == PH_POLYLINE
             ? ph_fail_at(diag, PH_E_BAD_VALUE, t->field, k, text, degree,
                          PH_TC_DEGREE_MAX)
             : ph_fail(diag, PH_E_BAD_VALUE, t->field, text, degree,
                       PH_TC_DEGREE_MAX);
}

static enum ph_status read_goal(const struct ph_problem *p, struct target *t,
                                struct ph_diag *diag) {
  const struct ph_value *tolerance = &p->field[PH_F_TOLERANCE];
  const struct ph_value *pieces = &p->field[PH_F_PIECES];
  double count = pieces->number;
  if ((tolerance->kind == PH_ABSENT) == (pieces->kind == PH_ABSENT)) {
    return tolerance->kind == PH_ABSENT
               ? ph_fail(diag, PH_E_MISSING_FIELD, "tolerance",
                         "or pieces is required by the mode approximate")
               : ph_fail(diag, PH_E_BAD_VALUE, "pieces",
                         "excludes tolerance: give one of them");
  }
  if (tolerance->kind != PH_ABSENT) {
    t->tolerance = tolerance->number;
    return t->tolerance > 0
               ? PH_OK
               : ph_fail(diag, PH_E_BAD_VALUE, "tolerance",
                         "must be greater than 0, found %.17g", t->tolerance);
  }
  if (!(count >= 1 && count <= PIECES_MAX && floor(count) >= count)) {
    return ph_fail(diag, PH_E_BAD_VALUE, "pieces",
                   "must be a whole number from 1 to %.0f, found %.17g",
                   PIECES_MAX, count);
  }
  t->pieces = (size_t)count;
  return PH_OK;
}

static enum ph_status read_field(const struct ph_problem *p, struct target *t,
                                 struct ph_diag *diag) {
  bool curve = p->field[PH_F_CURVE].kind != PH_ABSENT;
  bool points = p->field[PH_F_POINTS].kind != PH_ABSENT;
  if (curve == points) {
    return curve ? ph_fail(diag, PH_E_BAD_VALUE, "points",
                           "excludes curve: give one of them")
                 : ph_fail(diag, PH_E_MISSING_FIELD, "curve",
                           "is required by the mode approximate");
  }
  t->field = curve ? "curve" : "points";
  t->value = &p->field[curve ? PH_F_CURVE : PH_F_POINTS];
  t->closed = p->field[PH_F_CLOSED].flag;
  t->n = t->value->kind == PH_POLYLINE ? t->value->sizes_n : 1;
  if (t->n == 0) {
    return ph_fail(diag, PH_E_TOO_FEW_POINTS, t->field, "has no curves");
  }
  for (size_t k = 0; k < t->n; k++) {
    if (size_of(t, k) < 2) {
      return fail_curve(t, k, PH_E_TOO_FEW_POINTS, diag,
                        "must have at least 2 control points");
    }
    if (size_of(t, k) > PH_TC_DEGREE_MAX + 1) {
      return fail_degree(t, k, diag);
    }
  }
  return PH_OK;
}

/* A curve that is a point has no direction, and no cubics. */
static enum ph_status check_extent(const struct target *t,
                                   struct ph_diag *diag) {
  const double near =
      4 * DBL_EPSILON * ph_pow2_apply(ph_pow2_of(t->exponent), t->far);
  for (size_t k = 0; k < t->n; k++) {
    const struct ph_tc_bezier *b = &t->bezier[k];
    bool point = true;
    for (size_t i = 1; i <= b->degree && point; i++) {
      point = !(ph_cplx_abs(ph_cplx_sub(b->p[i], b->p[0])) > near);
    }
    if (point) {
      return fail_curve(t, k, PH_E_COINCIDENT_POINTS, diag,
                        "has control points that are all the same");
    }
  }
  return PH_OK;
}

/* The box of all control points: its middle, and the scale of the rest. */
static enum ph_status measure(struct target *t, struct ph_diag *diag) {
  const double *v = t->value->v;
  double half = 0;
  t->far = 0;
  for (size_t j = 0; j < 2; j++) {
    double low = v[j], high = low;
    for (size_t i = 0; i < t->value->n; i++) {
      double x = v[2 * i + j];
      low = x < low ? x : low;
      high = x > high ? x : high;
    }
    t->middle[j] = 0.5 * low + 0.5 * high;
    half = fmax(half, 0.5 * high - 0.5 * low);
    t->far = fmax(t->far, fmax(fabs(low), fabs(high)));
  }
  if (!(half > 4 * DBL_EPSILON * t->far)) {
    return ph_fail(diag, PH_E_COINCIDENT_POINTS, t->field,
                   "has control points that are all the same");
  }
  t->exponent = ph_fields_exponent(half);
  return PH_OK;
}

/* What rounding of the user's coordinates may add to a distance. */
static double rounding(const struct target *t) {
  return 4 * DBL_EPSILON * t->far;
}

/* Each curve begins where the one before ends, exactly: the later start is
 * taken. */
static enum ph_status join(struct target *t, ph_cplx *p, struct ph_diag *diag) {
  struct ph_pow2 scale = ph_pow2_of(t->exponent);
  double near = 4 * DBL_EPSILON * ph_pow2_apply(scale, t->far);
  for (size_t k = 0, at = size_of(t, 0); k < t->n; k++) {
    bool last = k + 1 == t->n;
    size_t to = last ? 0 : at;
    if (last && !t->closed) {
      break;
    }
    if (!(ph_cplx_abs(ph_cplx_sub(p[to], p[at - 1])) <= near)) {
      return last ? ph_fail(diag, PH_E_BAD_VALUE, t->field,
                            "must end where it begins if closed")
                  : ph_fail_at(diag, PH_E_BAD_VALUE, t->field, k + 1,
                               "must begin where %s[%zu] ends", t->field, k);
    }
    p[at - 1] = p[to];
    at += last ? 0 : size_of(t, k + 1);
  }
  return PH_OK;
}

static enum ph_status read(const struct ph_problem *problem,
                           struct ph_arena *scratch, struct target *t,
                           struct ph_diag *diag) {
  enum ph_status status = read_goal(problem, t, diag);
  struct ph_pow2 scale;
  ph_cplx *p;
  status = status == PH_OK ? read_field(problem, t, diag) : status;
  status = status == PH_OK ? measure(t, diag) : status;
  if (status != PH_OK) {
    return status;
  }
  p = ph_arena_array(scratch, t->value->n, sizeof *p);
  t->bezier = ph_arena_array(scratch, t->n, sizeof *t->bezier);
  t->first = ph_arena_array(scratch, t->n + 1, sizeof *t->first);
  if (!p || !t->bezier || !t->first) {
    return ph_fail_memory(diag);
  }
  scale = ph_pow2_of(t->exponent);
  for (size_t i = 0; i < t->value->n; i++) {
    const double *v = t->value->v + 2 * i;
    p[i] = ph_cplx_of(ph_pow2_apply(scale, v[0] - t->middle[0]),
                      ph_pow2_apply(scale, v[1] - t->middle[1]));
  }
  for (size_t k = 0, at = 0; k < t->n; at += size_of(t, k), k++) {
    t->bezier[k] = (struct ph_tc_bezier){
        p + at, size_of(t, k) - 1, SHORT * ph_pow2_apply(scale, rounding(t))};
  }
  status = join(t, p, diag);
  return status == PH_OK ? check_extent(t, diag) : status;
}

/* ---- solving ------------------------------------------------------------ */

/* Says of which curve a failure is. */
static enum ph_status name_curve(const struct target *t, size_t k,
                                 enum ph_status status, struct ph_diag *diag) {
  char why[PH_DIAG_MESSAGE_MAX];
  if (status != PH_E_NO_CONVERGENCE) {
    return status;
  }
  memcpy(why, diag->message, sizeof why);
  return fail_curve(t, k, status, diag, why);
}

static enum ph_status within_tolerance(struct target *t,
                                       struct ph_tc_arcs *arcs,
                                       struct ph_diag *diag) {
  double tolerance =
      ph_pow2_apply(ph_pow2_of(t->exponent), t->tolerance - rounding(t));
  enum ph_status status = PH_OK;
  if (!(tolerance > 0)) {
    return ph_fail(diag, PH_E_NO_CONVERGENCE, "tolerance",
                   "is no larger than the rounding of coordinates, %.2g",
                   rounding(t));
  }
  for (size_t k = 0; status == PH_OK && k < t->n; k++) {
    t->first[k] = arcs->n;
    status = ph_tc_approximate(&t->bezier[k], tolerance, arcs, diag);
    status = name_curve(t, k, status, diag);
    t->first[k + 1] = arcs->n;
  }
  return status;
}

static enum ph_status approximate(struct target *t, struct ph_tc_arcs *arcs,
                                  struct ph_diag *diag) {
  if (t->pieces == 0) {
    return within_tolerance(t, arcs, diag);
  }
  if (t->pieces < t->n) {
    return ph_fail(diag, PH_E_BAD_VALUE, "pieces",
                   "must be at least %zu, one for each curve, found %zu", t->n,
                   t->pieces);
  }
  return ph_tc_approximate_pieces(
      t->bezier, t->n, t->pieces,
      CLEAR * ph_pow2_apply(ph_pow2_of(t->exponent), rounding(t)), arcs,
      t->first, diag);
}

/* ---- the result --------------------------------------------------------- */

static ph_cplx to_user(const struct target *t, ph_cplx z) {
  struct ph_pow2 grow = ph_pow2_of(-t->exponent);
  return ph_cplx_of(t->middle[0] + ph_pow2_apply(grow, z.re),
                    t->middle[1] + ph_pow2_apply(grow, z.im));
}

/* The user's own point where curve k begins, or the last one ends. */
static ph_cplx corner(const struct target *t, size_t k) {
  size_t at = k < t->n    ? (size_t)(t->bezier[k].p - t->bezier[0].p)
              : t->closed ? 0
                          : t->value->n - 1;
  const double *v = t->value->v + 2 * at;
  return ph_cplx_of(v[0], v[1]);
}

/* The most by which a cubic misses its end / its length. */
static double residual(const struct ph_tc_arcs *arcs) {
  double worst = 0;
  for (size_t i = 0; i < arcs->n; i++) {
    const struct ph_tc_arc *arc = &arcs->arc[i];
    ph_cplx missed =
        ph_cplx_sub(ph_cplx_sub(arc->end, arc->start), ph_tc_leg(&arc->tc));
    worst = fmax(worst, ph_cplx_abs(missed) / ph_tc_length(&arc->tc));
  }
  return worst;
}

/* The cubics of one Bezier curve; returns their length. */
static double put_curve(const struct target *t, const struct ph_tc_arcs *arcs,
                        size_t k, struct ph_curve *curve) {
  struct ph_sum length = {0, 0};
  ph_cplx from = corner(t, k), end = corner(t, k + 1);
  for (size_t i = t->first[k]; i < t->first[k + 1]; i++) {
    const struct ph_tc_arc *arc = &arcs->arc[i];
    bool last = i + 1 == t->first[k + 1];
    ph_cplx to = last ? end : to_user(t, arc->end);
    ph_tc_curve_put(curve, i, &arc->tc, from, to, t->exponent);
    curve->knots[i] = (double)k + arc->from;
    ph_sum_add(&length, curve->lengths[i]);
    from = to;
  }
  return ph_sum_value(&length);
}

static enum ph_status write(const struct target *t,
                            const struct ph_tc_arcs *arcs, struct ph_arena *out,
                            struct ph_result *result, struct ph_diag *diag) {
  struct ph_curve *curve = &result->curve;
  struct ph_sum length = {0, 0};
  *curve = (struct ph_curve){.kind = PH_CURVE_TC,
                             .closed = t->closed,
                             .dimension = 2,
                             .degree = 3,
                             .n = arcs->n,
                             .preimage.n = 2,
                             .preimage.dimension = 2};
  result->intervals = ph_arena_array(out, t->n, sizeof *result->intervals);
  result->intervals_n = t->n;
  if (!result->intervals || ph_curve_alloc(curve, out, diag) != PH_OK) {
    return ph_fail_memory(diag);
  }
  for (size_t k = 0; k < t->n; k++) {
    struct ph_interval *interval = &result->intervals[k];
    *interval = PH_INTERVAL_NONE;
    interval->length = put_curve(t, arcs, k, curve);
    interval->first = t->first[k];
    interval->last = t->first[k + 1] - 1;
    ph_sum_add(&length, interval->length);
  }
  curve->knots[curve->n] = (double)t->n;
  curve->length = ph_sum_value(&length);
  ph_diagnostics_set(&result->diagnostics, PH_D_ITERATIONS, 0);
  ph_diagnostics_set(&result->diagnostics, PH_D_RESIDUAL, residual(arcs));
  ph_diagnostics_set(&result->diagnostics, PH_D_DISTANCE,
                     ph_pow2_apply(ph_pow2_of(-t->exponent), arcs->distance) +
                         rounding(t));
  return PH_OK;
}

enum ph_status ph_tc_target(const struct ph_problem *problem,
                            struct ph_arena *out, struct ph_arena *scratch,
                            struct ph_result *result, struct ph_diag *diag) {
  struct target t = {.value = NULL};
  struct ph_tc_arcs arcs = {.arena = scratch};
  enum ph_status status = read(problem, scratch, &t, diag);
  if (status == PH_OK) {
    status = approximate(&t, &arcs, diag);
  }
  return status == PH_OK ? write(&t, &arcs, out, result, diag) : status;
}
