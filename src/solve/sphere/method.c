/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The method `sphere`: points on a sphere to a spherical nu-spline that bends
 * to the side to which the data bend.
 *
 * The spline is solved at the tensions that are given (sphere.h), and
 * where it does not keep the shape of the data (sphere.h) its tensions
 * are raised (sphere.h).  [IOR15]
 */
#include "solve/method.h"

#include "base/sum.h"
#include "solve/common/fields.h"
#include "solve/sphere/sphere.h"

#include <math.h>
#include <string.h>

/* Less than this of curvature cannot be told from rounding. */
static const double EPSILON_MIN = 1e-11;

/* Nodes that a warning lists. */
enum { LIST_MAX = 8 };

/* A problem on its way. */
struct task {
  const struct ph_problem *problem;
  struct ph_arena *scratch;
  struct ph_diag *diag;
  struct ph_sphere_data data;
  struct ph_sphere_shape shape;
  struct ph_sphere_spline spline;
  struct ph_sphere_work work;
  struct ph_sphere_raise raise;
  bool keep_shape;
};

/* ---- reading ------------------------------------------------------------- */

static enum ph_status read_increase(struct task *t) {
  const struct ph_value *increase = &t->problem->field[PH_F_INCREASE];
  struct ph_sphere_raise *raise = &t->raise;
  raise->increase = PH_SPHERE_MINIMAL;
  if (increase->kind == PH_ABSENT || ph_value_is(increase, "minimal")) {
    return PH_OK;
  }
  raise->increase = strncmp(increase->word, "plus", 4) == 0 ? PH_SPHERE_PLUS
                                                            : PH_SPHERE_TIMES;
  raise->by = increase->number;
  if (raise->increase == PH_SPHERE_PLUS && !(raise->by > 0)) {
    return ph_fail(t->diag, PH_E_BAD_VALUE, "increase",
                   "must add more than 0, found %.17g", raise->by);
  }
  if (raise->increase == PH_SPHERE_TIMES && !(raise->by > 1)) {
    return ph_fail(t->diag, PH_E_BAD_VALUE, "increase",
                   "must multiply by more than 1, found %.17g", raise->by);
  }
  return PH_OK;
}

static enum ph_status read_shape(struct task *t) {
  const struct ph_problem *p = t->problem;
  const struct ph_value *shape = &p->field[PH_F_SHAPE];
  const struct ph_value *epsilon = &p->field[PH_F_EPSILON];
  double bound =
      epsilon->kind == PH_ABSENT ? PH_SPHERE_EPSILON : epsilon->number;
  t->keep_shape = shape->kind != PH_BOOL || shape->flag;
  t->raise.strict = shape->kind == PH_BOOL;
  if (!(bound >= EPSILON_MIN)) {
    return ph_fail(t->diag, PH_E_BAD_VALUE, "epsilon",
                   "must be at least %g, found %.17g", EPSILON_MIN, bound);
  }
  return ph_sphere_shape_of(&t->data, bound,
                            ph_value_is(&p->field[PH_F_CRITERION], "legacy"),
                            t->scratch, &t->shape)
             ? PH_OK
             : ph_fail_memory(t->diag);
}

static enum ph_status read_task(struct task *t) {
  enum ph_status status =
      ph_sphere_data_read(t->problem, t->scratch, &t->data, t->diag);
  if (status == PH_OK) {
    status = read_shape(t);
  }
  return status == PH_OK ? read_increase(t) : status;
}

/* ---- solving ------------------------------------------------------------- */

/* What a failure or a warning says of a criterion. */
static const char *place_of(const struct ph_sphere_raise *raise) {
  return raise->criterion == PH_SPHERE_SEGMENT ? "segment" : "node";
}

/* What finds a spline where there is none: spacings unrelated to the angles, as
 * those that are given can be, have none at tensions of 1000 either. */
static const char *advice_of(const struct task *t) {
  bool given = t->problem->field[PH_F_KNOTS].kind == PH_NUMBERS;
  bool exact = t->spline.model == &ph_sphere_exact;
  return given && !exact ? "--knots=geodesic with --model=exact finds one"
         : given         ? "--knots=geodesic finds one as a rule"
         : !exact        ? "--model=exact finds one as a rule"
                         : "try larger ones";
}

/* Where nothing was found; a residual that is NaN says nothing. */
static enum ph_status fail_spline(const struct task *t, const char *tensions) {
  double residual = t->work.residual;
  return isfinite(residual)
             ? ph_fail(t->diag, PH_E_NO_CONVERGENCE, "tension",
                       "no spline was found at %s, residual %.2g: %s", tensions,
                       residual, advice_of(t))
             : ph_fail(t->diag, PH_E_NO_CONVERGENCE, "tension",
                       "no spline was found at %s: %s", tensions, advice_of(t));
}

static enum ph_status fail_shape(const struct task *t, enum ph_status status) {
  const struct ph_sphere_raise *raise = &t->raise;
  bool lonlat = t->problem->field[PH_F_LONLAT].kind != PH_ABSENT;
  const char *field = raise->criterion == PH_SPHERE_SEGMENT ? "segments"
                      : lonlat                              ? "lonlat"
                                                            : "points";
  switch (status) {
  case PH_E_INFEASIBLE:
    return ph_fail_at(t->diag, status, field, raise->at,
                      "no tension makes the criterion of %s hold here; with "
                      "\"shape\":\"warn\" it is done without",
                      ph_sphere_criterion_name(raise->criterion));
  case PH_E_NO_MEMORY:
    return ph_fail_memory(t->diag);
  default:
    if (raise->rounds == PH_SPHERE_ROUNDS_MAX) {
      return ph_fail(t->diag, status, "increase",
                     "the shape was not reached by %zu increases of tensions, "
                     "try larger ones",
                     raise->rounds);
    }
    if (raise->beyond) {
      return ph_fail_at(t->diag, status, field, raise->at,
                        "the criterion of %s asks for tensions beyond "
                        "precision here%s; with \"shape\":\"warn\" it is done "
                        "without",
                        ph_sphere_criterion_name(raise->criterion),
                        raise->criterion == PH_SPHERE_COCIRCULARITY
                            ? ", a larger epsilon for less"
                            : "");
    }
    return fail_spline(t, "tensions that were raised to keep the shape");
  }
}

/* The spline at the tensions that are given, then at those it needs. */
static enum ph_status find(struct task *t) {
  const struct ph_value *model = &t->problem->field[PH_F_MODEL];
  enum ph_status status;
  if (!ph_sphere_spline_alloc(&t->spline, &t->data,
                              ph_value_is(model, "nielson") ? &ph_sphere_nielson
                                                            : &ph_sphere_exact,
                              t->scratch) ||
      !ph_sphere_work_alloc(&t->work, t->scratch, t->data.n)) {
    return ph_fail_memory(t->diag);
  }
  if (!(t->keep_shape ? ph_sphere_solve_tense(&t->spline, &t->work)
                      : ph_sphere_solve(&t->spline, &t->work))) {
    return fail_spline(t, "these tensions");
  }
  if (!t->keep_shape) {
    return PH_OK;
  }
  t->raise.shape = &t->shape;
  t->raise.spline = &t->spline;
  t->raise.work = &t->work;
  status = ph_sphere_keep_shape(&t->raise, t->scratch);
  return status == PH_OK ? PH_OK : fail_shape(t, status);
}

/* ---- the result ---------------------------------------------------------- */

/* Where the data turn back on a great circle, and the curve has to. */
static void warn_reversal(const struct task *t, struct ph_result *result) {
  size_t first = 0, n = 0;
  for (size_t i = t->data.n; i-- > 0;) {
    if (!ph_sphere_is_end(&t->data, i) && t->shape.q[i] == 0 &&
        !t->shape.inorder[i]) {
      n++;
      first = i;
    }
  }
  if (n > 0) {
    ph_warn(result, PH_NO_SEGMENT, PH_W_REVERSAL,
            "the data turn back on a great circle at %zu point%s, first at "
            "node %zu",
            n, n == 1 ? "" : "s", first);
  }
}

/* The first few points where a criterion was waived, ", ..." if there are more,
 * made as a message is. */
static void list_waived(const struct ph_sphere_raise *raise, size_t n,
                        struct ph_diag *list) {
  size_t shown = 0;
  ph_fail(list, PH_OK, NULL, "%s", "");
  for (size_t i = 0; i < n && shown <= LIST_MAX; i++) {
    if (raise->ignored[i]) {
      struct ph_diag before = *list;
      if (shown++ < LIST_MAX) {
        ph_fail(list, PH_OK, NULL, "%s%s %zu", before.message,
                shown > 1 ? "," : "", i);
      } else {
        ph_fail(list, PH_OK, NULL, "%s, ...", before.message);
      }
    }
  }
}

/* What the criteria that fail have in common. */
static const char *why_waived(const struct ph_sphere_raise *raise) {
  return raise->rounds == PH_SPHERE_ROUNDS_MAX ? "after all increases"
         : raise->never == raise->waived       ? "at any tension"
         : raise->never == 0 ? "as they ask for tensions beyond precision"
                             : "at any tension within precision";
}

static void warn_waived(const struct task *t, struct ph_result *result) {
  const struct ph_sphere_raise *raise = &t->raise;
  struct ph_diag list;
  list_waived(raise, t->data.n, &list);
  ph_warn(
      result, raise->criterion == PH_SPHERE_SEGMENT ? raise->at : PH_NO_SEGMENT,
      PH_W_SHAPE_UNSATISFIABLE,
      "%zu %s of shape %s %s, at the nodes%s; the first is %s at %s %zu",
      raise->waived, raise->waived == 1 ? "criterion" : "criteria",
      raise->waived == 1 ? "fails" : "fail", why_waived(raise), list.message,
      ph_sphere_criterion_name(raise->criterion), place_of(raise), raise->at);
}

static void warn(const struct task *t, struct ph_result *result) {
  if (t->data.tell_moved) {
    ph_warn(result, PH_NO_SEGMENT, PH_W_MOVED_POINTS,
            "points are not on the sphere and were moved onto it, "
            "points[%zu] farthest, by %.2g of the radius",
            t->data.moved_at, t->data.moved);
  }
  if (t->keep_shape && t->raise.waived > 0) {
    warn_waived(t, result);
  }
}

static void join(struct ph_sphere_spline *s) {
  const struct ph_sphere_range inner = ph_sphere_all(s->data);
  for (size_t j = 0; s->model->join && j < inner.count; j++) {
    s->model->join(s, ph_sphere_node(s->data, inner, j));
  }
}

static enum ph_status solve(const struct ph_problem *problem,
                            struct ph_arena *out, struct ph_arena *scratch,
                            struct ph_result *result, struct ph_diag *diag) {
  struct ph_mark mark = ph_arena_mark(scratch);
  struct task t = {.problem = problem, .scratch = scratch, .diag = diag};
  enum ph_status status = read_task(&t);
  if (status == PH_OK) {
    status = find(&t);
  }
  if (status == PH_OK) {
    join(&t.spline);
    status = ph_sphere_curve(&t.spline, &t.shape,
                             t.raise.waived > 0 ? t.raise.ignored : NULL, out,
                             &result->curve, diag);
  }
  if (status == PH_OK) {
    ph_diagnostics_set(&result->diagnostics, PH_D_ITERATIONS,
                       (double)t.work.iterations);
    ph_diagnostics_set(&result->diagnostics, PH_D_RESIDUAL, t.work.residual);
    warn_reversal(&t, result);
    warn(&t, result);
  }
  ph_arena_release(scratch, mark);
  return status;
}

static const struct ph_field fields[] = {
    {PH_F_POINTS, PH_VECTORS | PH_DATUM, 1u << 3, false, NULL, "lonlat",
     "the points to interpolate, 2 or more, 3 or more if closed"},
    {PH_F_LONLAT, PH_VECTORS | PH_DATUM, 1u << 2, false, NULL, "points",
     "in place of points: longitudes and latitudes, in degrees"},
    {PH_F_CLOSED, PH_BOOL, 0, false, NULL, "false",
     "close the curve, a repeated last point is dropped"},
    PH_FIELD_MERGE,
    PH_FIELD_AT,
    {PH_F_CENTER, PH_NUMBERS, 0, false, NULL, "[0,0,0]",
     "the center of the sphere"},
    {PH_F_RADIUS, PH_NUMBER, 0, false, NULL, "1", "the radius of the sphere"},
    {PH_F_RADIUS_TOLERANCE, PH_NUMBER, 0, false, NULL, "1e-3",
     "points that are off the sphere by no more of its radius are moved onto "
     "it"},
    {PH_F_MODEL, PH_WORD, 0, false, "exact|nielson", "exact",
     "the curve: continuous in curvature, or as published"},
    {PH_F_KNOTS, PH_WORD | PH_NUMBERS | PH_DATUM, 0, false, "geodesic|uniform",
     "geodesic",
     "spacing of the knots: the angles between points, or all the same; or "
     "the knots themselves, increasing"},
    {PH_F_ENDS, PH_WORD, 0, false, "natural|rest|clamped",
     "natural, with end_tangents clamped",
     "ends of an open curve: no curvature, no velocity, or given tangents"},
    {PH_F_END_TANGENTS, PH_VECTORS, 1u << 3, false, NULL, "none",
     "directions of the curve at its first and its last point"},
    {PH_F_TENSION, PH_NUMBER | PH_NUMBERS | PH_DATUM, 0, false, NULL, "0",
     "least tensions, one for all points or one each"},
    {PH_F_SHAPE, PH_BOOL | PH_WORD, 0, false, "warn", "warn",
     "raise tensions until the curve keeps the shape of the data; true: fail "
     "where none does, warn: warn of it"},
    {PH_F_INCREASE, PH_WORD, 0, false, "minimal|plus:V|times:V", "minimal",
     "how tensions are raised: to the smallest that do, or by a step or a "
     "factor V"},
    {PH_F_CRITERION, PH_WORD, 0, false, "geodesic|legacy", "geodesic",
     "the curvature that is judged: the geodesic one, or as published"},
    {PH_F_EPSILON, PH_NUMBER, 0, false, NULL, PH_TEXT(PH_SPHERE_EPSILON),
     "bound of the curvature where data are on a great circle, on the unit "
     "sphere"},
};

const struct ph_method ph_method_sphere = {
    .schema = {"sphere", fields, sizeof fields / sizeof fields[0]},
    .title = "shape-preserving G2 curves on the sphere",
    .dimension = 3,
    .kind = PH_CURVE_SPHERICAL_NU,
    .solve = solve,
};

/* ---- the curve ----------------------------------------------------------- */

static enum ph_status set_segments(const struct ph_sphere_spline *s,
                                   struct ph_arena *arena,
                                   struct ph_curve *curve,
                                   struct ph_diag *diag) {
  const struct ph_sphere_data *d = s->data;
  struct ph_primitive table = {.n = 0};
  struct ph_sum sum = {0, 0};
  for (size_t k = 0; k < d->m; k++) {
    struct ph_spherical segment = ph_sphere_segment(s, k);
    double length;
    enum ph_status status =
        ph_spherical_length(&segment, &table, arena, &length);
    if (status == PH_E_NO_MEMORY || ph_arena_late(arena)) {
      return ph_fail_memory(diag);
    }
    if (status != PH_OK) {
      return ph_fail_at(diag, PH_E_NO_CONVERGENCE, "segments", k,
                        "has no length to 1e-12, as far as was found");
    }
    for (size_t j = 0; j < 4; j++) {
      double *to = curve->control_points + (4 * k + j) * 3;
      to[0] = d->center[0] + d->radius * segment.p[j].x;
      to[1] = d->center[1] + d->radius * segment.p[j].y;
      to[2] = d->center[2] + d->radius * segment.p[j].z;
    }
    curve->lengths[k] = d->radius * length;
    ph_sum_add(&sum, curve->lengths[k]);
  }
  curve->length = ph_sum_value(&sum);
  return PH_OK;
}

static enum ph_status set_waived(const unsigned char *waived, size_t n,
                                 struct ph_arena *arena, struct ph_curve *curve,
                                 struct ph_diag *diag) {
  struct ph_sphere *sphere = &curve->sphere;
  for (size_t i = 0; waived && i < n; i++) {
    sphere->waived_n += waived[i] != 0;
  }
  if (sphere->waived_n == 0) {
    return PH_OK;
  }
  sphere->waived =
      ph_arena_array(arena, sphere->waived_n, sizeof *sphere->waived);
  if (!sphere->waived) {
    return ph_fail_memory(diag);
  }
  for (size_t i = 0, j = 0; i < n; i++) {
    if (waived[i]) {
      sphere->waived[j++] = i;
    }
  }
  return PH_OK;
}

enum ph_status ph_sphere_curve(const struct ph_sphere_spline *s,
                               const struct ph_sphere_shape *shape,
                               const unsigned char *waived,
                               struct ph_arena *arena, struct ph_curve *curve,
                               struct ph_diag *diag) {
  const struct ph_sphere_data *d = s->data;
  *curve = (struct ph_curve){.kind = PH_CURVE_SPHERICAL_NU,
                             .closed = d->closed,
                             .dimension = 3,
                             .degree = 3,
                             .n = d->m,
                             .sphere.radius = d->radius};
  if (ph_curve_alloc(curve, arena, diag) != PH_OK) {
    return diag->status;
  }
  curve->sphere.tensions =
      ph_arena_array(arena, d->n, sizeof *curve->sphere.tensions);
  curve->sphere.indicators =
      ph_arena_array(arena, d->n, sizeof *curve->sphere.indicators);
  if (!curve->sphere.tensions || !curve->sphere.indicators) {
    return ph_fail_memory(diag);
  }
  memcpy(curve->sphere.center, d->center, sizeof curve->sphere.center);
  memcpy(curve->knots, d->knots, (d->m + 1) * sizeof *curve->knots);
  memcpy(curve->sphere.tensions, s->nu, d->n * sizeof *curve->sphere.tensions);
  memcpy(curve->sphere.indicators, shape->q,
         d->n * sizeof *curve->sphere.indicators);
  if (set_waived(waived, d->n, arena, curve, diag) != PH_OK) {
    return diag->status;
  }
  return set_segments(s, arena, curve, diag);
}
