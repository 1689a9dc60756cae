/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The certificate of spatial PH quintic and ATPH curves (see certify.h).
 *
 * Every segment is measured by its own size, as each was found by itself.
 */
#include "check/certify.h"

#include "base/sum.h"
#include "check/segment3.h"
#include "check/shape_spatial.h"

/* Tolerances.  Beside the rounding of control points, the solver leaves that of
 * a few operations. */
static const double INTERPOLATION = 1e-13;
static const double PYTHAGOREAN = 1e-13;
static const double LENGTH = 1e-13;
static const double DIRECTION = 1e-12;

/* A direction that rounding may have turned by more than this is none: a first
 * leg that is far shorter than its coordinates may vanish. */
static const double NO_DIRECTION = 1;

struct context {
  const struct ph_arena *arena; /* knows how much time there is */
  struct ph_check3 at;
  struct ph_check3_data points, tangents, derivatives;
  double planarity;
};

struct checks {
  struct ph_check_error point, tangent, square, joint, length;
  enum ph_check_shape shape; /* the first that is not kept */
  size_t shape_at;
};

/* Vector k of the data; the first one again after the last of closed data. */
static ph_vec3 vector_at(const struct context *c,
                         const struct ph_check3_data *data, size_t k) {
  return ph_vec3_get(data->v + data->dimension * (k < c->points.n ? k : 0),
                     data->dimension);
}

/* r' = A i A* at the nodes; returns the integral of |r'|. */
static double check_hodograph(const struct context *c,
                              const struct ph_check3_segment *s, size_t k,
                              struct ph_check_error *square) {
  double miss, length = ph_check3_hodograph(&c->at, s, &miss);
  ph_check_add(square, k, miss, s->speed,
               PYTHAGOREAN * s->speed + s->allowance);
  return length;
}

static void check_length(double length, double claimed, double allowance,
                         size_t k, struct ph_check_error *check) {
  ph_check_add(check, k, fabs(length - claimed), length,
               LENGTH * length + allowance);
}

/* The tangent or the derivative that was given for one end of segment k. */
static void check_tangent(const struct context *c,
                          const struct ph_check3_segment *s, size_t k,
                          size_t end, struct ph_check_error *check) {
  if (c->derivatives.n > 0) {
    ph_vec3 given =
        ph_check3_scaled(&c->at, vector_at(c, &c->derivatives, k + end));
    double factor = s->tension * s->tension * s->unit;
    double size = factor * ph_vec3_abs(given);
    ph_vec3 miss = ph_vec3_along(s->first[end], -factor, given);
    ph_check_add(check, k, ph_vec3_abs(miss), size,
                 DIRECTION * size + s->allowance);
  } else {
    ph_vec3 given = ph_check3_direction(vector_at(c, &c->tangents, k + end));
    ph_vec3 miss = ph_vec3_sub(s->tangent[end], given);
    if (s->error[end] < NO_DIRECTION) {
      ph_check_add(check, k, ph_vec3_abs(miss), 1, DIRECTION + s->error[end]);
    }
  }
}

/* The jump between two segments: of the direction, and of the derivative by the
 * local parameter where it was given and scaled alike. */
static void check_joint(const struct context *c,
                        const struct ph_check3_segment *a,
                        const struct ph_check3_segment *b, size_t k,
                        struct ph_check_error *joint) {
  ph_vec3 jump = ph_vec3_sub(a->tangent[1], b->tangent[0]);
  double error = DIRECTION + a->error[1] + b->error[0];
  if (!(error < NO_DIRECTION)) {
    return;
  }
  ph_check_add(joint, k, ph_vec3_abs(jump), 1, error);
  if (c->derivatives.n > 0 && a->tension >= b->tension &&
      a->tension <= b->tension) {
    ph_vec3 left = ph_vec3_scale(1 / a->unit, a->first[1]);
    ph_vec3 right = ph_vec3_scale(1 / b->unit, b->first[0]);
    double size = ph_vec3_abs(right);
    jump = ph_vec3_sub(left, right);
    ph_check_add(joint, k, ph_vec3_abs(jump), size, error * size);
  }
}

static void check_points(const struct context *c,
                         const struct ph_check3_segment *s, size_t k,
                         struct ph_check_error *point) {
  ph_vec3 from = ph_check3_scaled(&c->at, vector_at(c, &c->points, k));
  ph_vec3 to = ph_check3_scaled(&c->at, vector_at(c, &c->points, k + 1));
  double away = ph_check_larger(ph_vec3_abs(ph_vec3_sub(s->start, from)),
                                ph_vec3_abs(ph_vec3_sub(s->end, to)));
  ph_check_add(point, k, away, c->at.scale.size,
               INTERPOLATION * c->at.scale.size);
}

/* The shape that the segment claims to keep. */
static void check_shape(const struct context *c,
                        const struct ph_check3_segment *s, size_t k,
                        struct checks *checks) {
  if (c->at.curve->choice.shape_ok && c->at.curve->choice.shape_ok[k] &&
      checks->shape == PH_CHECK_SHAPE_KEPT) {
    checks->shape = ph_check_shape_of(s->leg, c->at.space.mu, PYTHAGOREAN,
                                      s->rounding, c->planarity);
    checks->shape_at = k;
  }
}

static void check_segments(struct context *c, struct checks *checks) {
  const struct ph_curve *curve = c->at.curve;
  size_t n = curve->n;
  struct ph_check3_segment first = ph_check3_segment_of(&c->at, 0);
  struct ph_check3_segment before = first;
  struct ph_sum total = {0, 0};
  double claimed = ph_pow2_apply(c->at.scale.to_unit, curve->length),
         allowance = 0;
  for (size_t k = 0; k < n && !ph_arena_late(c->arena); k++) {
    struct ph_check3_segment s = ph_check3_segment_of(&c->at, k);
    double length = check_hodograph(c, &s, k, &checks->square);
    double wanted = ph_pow2_apply(c->at.scale.to_unit, curve->lengths[k]);
    check_points(c, &s, k, &checks->point);
    check_length(length, wanted, s.allowance, k, &checks->length);
    if (c->tangents.n > 0 || c->derivatives.n > 0) {
      check_tangent(c, &s, k, 0, &checks->tangent);
      check_tangent(c, &s, k, 1, &checks->tangent);
    }
    if (k > 0) {
      check_joint(c, &before, &s, k, &checks->joint);
    }
    check_shape(c, &s, k, checks);
    ph_sum_add(&total, length);
    allowance += s.allowance;
    before = s;
  }
  check_length(ph_sum_value(&total), claimed, allowance, n - 1,
               &checks->length);
  if (curve->closed) {
    check_joint(c, &before, &first, 0, &checks->joint);
  }
}

/* What the checks came to, the worst place of the first that fails. */
static enum ph_status conclude(const struct context *c,
                               const struct checks *checks,
                               struct ph_diagnostics *diagnostics,
                               struct ph_diag *diag) {
  static const char *const wrong[] = {
      [PH_CHECK_SHAPE_START] = "it is not convex at its start",
      [PH_CHECK_SHAPE_END] = "it is not convex at its end",
      [PH_CHECK_SHAPE_TORSION] = "its torsion changes sign"};
  const bool vectors = c->tangents.n > 0 || c->derivatives.n > 0;
  const struct ph_check_error *const list[] = {
      &checks->point, vectors ? &checks->tangent : NULL, &checks->square,
      &checks->joint, &checks->length};
  enum ph_status status = ph_check_conclude(list, 5, diagnostics, diag);
  if (status != PH_OK) {
    return status;
  }
  if (checks->shape != PH_CHECK_SHAPE_KEPT) {
    return ph_fail_at(diag, PH_NO_CONVERGENCE, "segments", checks->shape_at,
                      "is refused by its certificate: %s is claimed, but %s",
                      ph_diagnostic_name(PH_D_SHAPE_OK), wrong[checks->shape]);
  }
  return PH_OK;
}

/* Whether all segments keep the shape of the data. */
static void describe_shape(const struct ph_curve *curve,
                           struct ph_diagnostics *diagnostics) {
  bool shape_ok = true;
  for (size_t k = 0; curve->choice.shape_ok && k < curve->n; k++) {
    shape_ok = shape_ok && curve->choice.shape_ok[k];
  }
  if (curve->choice.shape_ok) {
    ph_diagnostics_set(diagnostics, PH_D_SHAPE_OK, shape_ok);
  }
}

/* Whether there is a segment for every pair of points; a repeated last point of
 * closed data counts once. */
static bool all_joined(struct context *c) {
  size_t n = c->at.curve->n, given = c->points.n;
  c->points.n = c->at.curve->closed ? n : n + 1;
  return n > 0 &&
         (given == c->points.n || (c->at.curve->closed && given == n + 1));
}

enum ph_status ph_check_spatial_hermite(const struct ph_problem *problem,
                                        const struct ph_curve *curve,
                                        struct ph_arena *scratch,
                                        struct ph_diagnostics *diagnostics,
                                        struct ph_diag *diag) {
  struct checks checks = {{.what = PH_D_INTERPOLATION_ERROR},
                          {.what = PH_D_TANGENT_ERROR},
                          {.what = PH_D_PYTHAGOREAN_ERROR},
                          {.what = PH_D_CONTINUITY_ERROR},
                          {.what = PH_D_LENGTH_ERROR},
                          PH_CHECK_SHAPE_KEPT,
                          0};
  const struct ph_value *planarity = &problem->field[PH_F_PLANARITY];
  struct context c = {
      .arena = scratch,
      .points = ph_check3_data_of(problem, PH_F_POINTS),
      .tangents = ph_check3_data_of(problem, PH_F_TANGENTS),
      .derivatives = ph_check3_data_of(problem, PH_F_DERIVATIVES),
      .planarity =
          planarity->kind == PH_NUMBER ? planarity->number : PH_PLANARITY};
  enum ph_status status;
  c.at.curve = curve;
  if (!all_joined(&c)) {
    return ph_fail(diag, PH_INTERNAL, "points",
                   "are not as many as are joined");
  }
  status = ph_check3_begin(&c.at, curve, c.points.v, c.points.n,
                           c.points.dimension, diag);
  if (status != PH_OK) {
    return status;
  }
  check_segments(&c, &checks);
  status = conclude(&c, &checks, diagnostics, diag);
  if (status == PH_OK) {
    describe_shape(curve, diagnostics);
  }
  return status;
}
