/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * General cones over ATPH curves (see cone.h).
 *
 * The contact curves are one problem of the method spatial-hermite: points and
 * derivatives, these by t in [0,alpha], where derivatives as long as the chord
 * are of unit length at unit scale, times the square of a tension.
 */
#include "solve/cone/cone.h"

#include "curve/fair/fair3.h"
#include "curve/segment/seg3.h"
#include "curve/surface/general.h"
#include "kernel/pi.h"
#include "solve/common/fields.h"
#include "solve/method.h"

#include <float.h>
#include <math.h>
#include <string.h>

/* A tangent that was written as a unit vector is one to this. */
static const double UNIT = 1e-3;

/* Vertices that are nearer to each other than this, relative to their distance
 * from the points, are at the same place. */
static const double SAME = 1e-9;

/* The common ruling of a pair. */
struct common {
  ph_vec3 v[2];    /* vertices */
  double side[2];  /* of both cones: 1 where rulings point away from these */
  ph_vec3 c, e, d; /* contact point, ruling, derivative of its given length */
};

struct general {
  const struct ph_problem *problem;
  const struct ph_cone_data *data;
  struct ph_pow2 from_unit, to_unit;
  const double *apexes;
  struct common *common;   /* [n] */
  struct ph_problem curve; /* that of spatial-hermite */
  bool unit;               /* tangent_scale */
  double loops, inflections, inside;
};

static double apex(const struct general *g, size_t k) {
  return ph_pow2_apply(g->to_unit, g->apexes[k < g->data->elements_n ? k : 0]);
}

/* The derivative at element k: of unit tangents as it was written. */
static ph_vec3 derivative_at(const struct general *g, size_t k) {
  const size_t i = k < g->data->elements_n ? k : 0;
  const ph_vec3 d = ph_fields_vector(&g->problem->field[PH_F_TANGENTS], i);
  return !g->unit                           ? g->data->element[i].d
         : fabs(ph_vec3_abs(d) - 1) <= UNIT ? d
                                            : ph_fields_unit(d);
}

/* ---- common rulings ------------------------------------------------------ */

static ph_vec3 contact_of(const struct general *g, const struct common *at,
                          ph_vec3 middle) {
  const struct ph_value *value = &g->problem->field[PH_F_CONTACT_POINT];
  const ph_vec3 way = ph_vec3_sub(at->v[1], at->v[0]);
  double part = 0.5;
  if (value->kind == PH_NUMBER) {
    part = value->number;
  } else if (!ph_value_is(value, "midpoint")) {
    part =
        ph_vec3_dot(ph_vec3_sub(middle, at->v[0]), way) / ph_vec3_dot(way, way);
  }
  return ph_vec3_along(at->v[0], part, way);
}

static enum ph_status set_common(const struct general *g, size_t i,
                                 struct ph_diag *diag) {
  const struct ph_contact_element *a = ph_cone_element(g->data, i);
  const struct ph_contact_element *b = ph_cone_element(g->data, i + 1);
  const double s[] = {apex(g, i), apex(g, i + 1)};
  struct common *at = &g->common[i];
  ph_vec3 way, back;
  at->v[0] = ph_vec3_along(a->p, s[0], a->e);
  at->v[1] = ph_vec3_along(b->p, s[1], b->e);
  at->side[0] = s[0] > 0 ? -1 : 1;
  at->side[1] = s[1] > 0 ? -1 : 1;
  way = ph_vec3_sub(at->v[1], at->v[0]);
  if (!(ph_vec3_abs(way) > SAME * (fabs(s[0]) + fabs(s[1])))) {
    return ph_fail_at(diag, PH_E_INFEASIBLE, "pairs", i,
                      "has no common ruling: both vertices are the same point");
  }
  at->c = contact_of(g, at, ph_vec3_scale(0.5, ph_vec3_add(a->p, b->p)));
  at->d = ph_vec3_scale(
      0.5, ph_vec3_add(derivative_at(g, i), derivative_at(g, i + 1)));
  way = ph_vec3_scale(at->side[0], ph_vec3_sub(at->c, at->v[0]));
  back = ph_vec3_scale(at->side[1], ph_vec3_sub(at->c, at->v[1]));
  if (!(ph_vec3_dot(way, back) > 0)) {
    return ph_fail_at(
        diag, PH_E_INFEASIBLE, "pairs", i,
        "has its contact point on the wrong side of a vertex: apexes on "
        "opposite sides of their rulings have it between them, others beyond "
        "both; look at apexes and contact_point");
  }
  at->e = ph_vec3_unit(way);
  if (!(ph_vec3_abs(ph_vec3_cross(at->e, at->d)) > SAME)) {
    return ph_fail_at(diag, PH_E_INFEASIBLE, "pairs", i,
                      "has no tangent plane on its common ruling: the mean of "
                      "both tangents is along it, or 0");
  }
  return PH_OK;
}

static enum ph_status set_apexes(struct general *g, struct ph_diag *diag) {
  const struct ph_value *value = &g->problem->field[PH_F_APEXES];
  const struct ph_value *contact = &g->problem->field[PH_F_CONTACT_POINT];
  const size_t n = g->data->elements_n;
  if (value->n != n && !(g->data->closed && value->n == n + 1)) {
    return ph_fail(diag, PH_E_BAD_SHAPE, "apexes",
                   "must have %zu numbers, one for each point, found %zu", n,
                   value->n);
  }
  for (size_t k = 0; k < n; k++) {
    if (!(fabs(value->v[k]) > 0)) {
      return ph_fail_at(diag, PH_E_BAD_VALUE, "apexes", k,
                        "must not be 0: a vertex is away from its point");
    }
  }
  if (contact->kind == PH_NUMBER &&
      !(contact->number >= 0 && contact->number <= 1)) {
    return ph_fail(diag, PH_E_BAD_VALUE, "contact_point",
                   "must be from 0, the first vertex, to 1, the second, found "
                   "%.17g",
                   contact->number);
  }
  g->apexes = value->v;
  return PH_OK;
}

/* One of a field for each strip, or for all. */
static enum ph_status check_each(const struct general *g, enum ph_field_id id,
                                 struct ph_diag *diag) {
  const struct ph_value *value = &g->problem->field[id];
  const size_t n = 2 * g->data->n;
  const bool vectors = id == PH_F_ANGLES && value->kind == PH_VECTORS;
  if ((!vectors && !(id == PH_F_ALPHA && value->kind == PH_NUMBERS)) ||
      value->n == n || (vectors && value->n == 1)) {
    return PH_OK;
  }
  return ph_fail(diag, PH_E_BAD_SHAPE, ph_field_name(id),
                 "must be one for all strips, or as many as there are, %zu, "
                 "found %zu",
                 n, value->n);
}

/* ---- the problem of the contact curve ------------------------------------ */

static struct ph_value vectors(double *v, size_t n) {
  return (struct ph_value){.kind = PH_VECTORS, .v = v, .n = n, .dimension = 3};
}

static struct ph_value word(const char *text) {
  return (struct ph_value){.kind = PH_WORD, .word = text};
}

/* The length of a chord between contact points, at unit scale. */
static double chord_of(const struct general *g, size_t strip) {
  const size_t i = strip / 2;
  return ph_vec3_abs(
      ph_vec3_sub(g->common[i].c, ph_cone_element(g->data, i + strip % 2)->p));
}

static enum ph_status set_curve(struct general *g, struct ph_arena *scratch,
                                struct ph_diag *diag) {
  const struct ph_cone_data *data = g->data;
  const struct ph_value *given = g->problem->field;
  struct ph_value *field = g->curve.field;
  const size_t n = 2 * data->n, points_n = n + (data->closed ? 0 : 1);
  double *p = ph_arena_array(scratch, 3 * points_n, sizeof *p);
  double *d = ph_arena_array(scratch, 3 * points_n, sizeof *d);
  double *tension = ph_arena_array(scratch, n, sizeof *tension);
  if (!p || !d || !tension) {
    return ph_fail_memory(diag);
  }
  for (size_t i = 0; i < points_n; i++) {
    const struct common *at = &g->common[i / 2 < data->n ? i / 2 : 0];
    ph_vec3 by = i % 2 ? at->d : derivative_at(g, i / 2);
    if (i % 2) {
      ph_vec3_put(ph_vec3_of(ph_pow2_apply(g->from_unit, at->c.x),
                             ph_pow2_apply(g->from_unit, at->c.y),
                             ph_pow2_apply(g->from_unit, at->c.z)),
                  3, p + 3 * i);
    } else {
      memcpy(p + 3 * i, given[PH_F_POINTS].v + 3 * (i / 2), 3 * sizeof *p);
    }
    if (!g->unit) {
      by = ph_vec3_scale(ph_pow2_apply(g->from_unit, 1), ph_vec3_unit(by));
    }
    ph_vec3_put(by, 3, d + 3 * i);
  }
  for (size_t i = 0; i < n; i++) {
    const double chord = chord_of(g, i);
    tension[i] = g->unit ? 1 : sqrt(chord);
    if (!(chord > 0)) {
      return ph_fail_at(diag, PH_E_INFEASIBLE, "strips", i,
                        "has no length: the contact point of the common ruling "
                        "is a given one");
    }
  }
  field[PH_F_POINTS] = vectors(p, points_n);
  field[PH_F_DERIVATIVES] = vectors(d, points_n);
  field[PH_F_TENSION] = (struct ph_value){
      .kind = PH_NUMBERS, .v = tension, .n = n, .dimension = 1};
  field[PH_F_CLOSED] = (struct ph_value){.kind = PH_BOOL, .flag = data->closed};
  field[PH_F_BASIS] = word("atph");
  field[PH_F_AXIS] = word("x");
  field[PH_F_ALPHA] = given[PH_F_ALPHA];
  field[PH_F_ANGLES] = given[PH_F_ANGLES];
  field[PH_F_CRITERION] = given[PH_F_CRITERION];
  if (given[PH_F_ANGLES].kind == PH_ABSENT &&
      given[PH_F_CRITERION].kind == PH_ABSENT) {
    field[PH_F_CRITERION] = word("F1");
  }
  return PH_OK;
}

/* What it calls segments are strips. */
static void name_strips(struct ph_diag *diag) {
  static const char other[] = "segments", own[] = "strips";
  char *field = diag->field;
  if (strncmp(field, other, sizeof other - 1) == 0) {
    memmove(field + sizeof own - 1, field + sizeof other - 1,
            strlen(field + sizeof other - 1) + 1);
    memcpy(field, own, sizeof own - 1);
  }
}

/* ---- strips -------------------------------------------------------------- */

static void set_strip(const struct general *g, size_t i,
                      struct ph_curve *curve) {
  const struct common *at = &g->common[i / 2];
  const struct ph_contact_element *a = ph_cone_element(g->data, i / 2);
  const ph_vec3 e = i % 2 ? at->e : a->e;
  const ph_vec3 d = i % 2 ? ph_vec3_unit(ph_vec3_normal(at->d, e)) : a->d;
  const ph_vec3 v = at->v[i % 2];
  const double nan = (double)NAN;
  struct ph_strip *s = &curve->surface.strips[i];
  *s = (struct ph_strip){.pair = i / 2,
                         .method = PH_STRIP_ATPH,
                         .k = nan,
                         .kn = nan,
                         .length = curve->lengths[i],
                         .half_angle = nan,
                         .sweep = nan};
  s->alpha = curve->preimage.alpha + i;
  s->control_points = curve->control_points + ph_curve_stride(curve) * i;
  s->preimage = curve->preimage.v + 12 * i;
  s->angles = curve->choice.angles + 2 * i;
  memcpy(s->frame.point, s->control_points, 3 * sizeof(double));
  ph_vec3_put(e, 3, s->frame.ruling);
  ph_vec3_put(d, 3, s->frame.tangent);
  ph_vec3_put(ph_vec3_cross(e, d), 3, s->frame.normal);
  ph_vec3_put(ph_vec3_of(ph_pow2_apply(g->from_unit, v.x),
                         ph_pow2_apply(g->from_unit, v.y),
                         ph_pow2_apply(g->from_unit, v.z)),
              3, s->vertex);
}

static void set_fairness(const struct ph_fair3_rules *rules,
                         const struct ph_curve *curve, size_t i) {
  struct ph_seg3 segment = ph_seg3_of(curve, i);
  struct ph_fair3 fair;
  ph_seg3_rescale(&segment);
  fair = ph_fair3_of(rules, &segment.space, segment.a);
  for (int j = 0; j < 3; j++) {
    curve->surface.strips[i].fairness[j] = ph_fair3_functional(
        &fair, ph_seg3_length(&segment.space, segment.a), j + 1);
  }
}

/* Whether rulings meet the vertex within the height. */
static bool is_inside(const struct ph_strip *s, const double height[2]) {
  const struct ph_directrix *d = s->directrix;
  const size_t far = d->side > 0; /* the height that is */
  const double low =
      ph_pow2_apply(d->fast.grow, d->near) + d->side * height[1 - far];
  const double high =
      ph_pow2_apply(d->fast.grow, d->far) + d->side * height[far];
  return !ph_surface_bare(height) && low <= 0 && high >= 0;
}

static enum ph_status see_strip(struct general *g, struct ph_curve *curve,
                                size_t i, struct ph_diag *diag) {
  struct ph_strip *s = &curve->surface.strips[i];
  const struct ph_directrix *d = s->directrix;
  s->development_angle = d->phi[d->n];
  s->turn = d->turn;
  g->inflections += (double)d->bends;
  g->inside += is_inside(s, curve->surface.height);
  return d->range <= PH_PI
             ? PH_OK
             : ph_fail_at(diag, PH_E_NO_CONVERGENCE, "strips", i,
                          "is a loop: its spherical image turns by %.3g to one "
                          "side, at most pi is allowed; other apexes, "
                          "\"contact_point\":\"nearest\", or another criterion "
                          "may have none",
                          d->range);
}

/* ---- the whole ----------------------------------------------------------- */

static void report(const struct general *g, struct ph_result *result) {
  struct ph_diagnostics *diagnostics = &result->diagnostics;
  const struct ph_curve *curve = &result->curve;
  double sum[3] = {0, 0, 0};
  const enum ph_diagnostic f[] = {PH_D_F1, PH_D_F2, PH_D_F3};
  diagnostics->known &= ~((uint64_t)1 << PH_D_REDUCED);
  diagnostics->known &= ~((uint64_t)1 << PH_D_FRAME_TURN);
  for (size_t i = 0; i < curve->n; i++) {
    for (size_t j = 0; j < 3; j++) {
      sum[j] += curve->surface.strips[i].fairness[j];
    }
  }
  for (size_t j = 0; j < 3; j++) {
    ph_diagnostics_set_finite(diagnostics, f[j], sum[j]);
  }
  ph_diagnostics_set(diagnostics, PH_D_SHIFT, 0);
  ph_diagnostics_set(diagnostics, PH_D_VERTICES_INSIDE, g->inside);
  ph_diagnostics_set(diagnostics, PH_D_INFLECTIONS, g->inflections);
  if (g->inside > 0) {
    size_t first = 0;
    while (!is_inside(&curve->surface.strips[first], curve->surface.height)) {
      first++;
    }
    ph_warn(result, first, PH_W_VERTEX_INSIDE,
            "the vertex of strip %zu is within the height (such strips: %.0f)",
            first, g->inside);
  }
  ph_cone_see_folds(g->inside > 0, result);
}

static enum ph_status build(struct general *g, struct ph_arena *out,
                            struct ph_result *result, struct ph_diag *diag) {
  struct ph_curve *curve = &result->curve;
  struct ph_fair3_rules rules;
  enum ph_status status;
  curve->kind = PH_CURVE_CONE;
  curve->surface.height[0] = ph_pow2_apply(g->from_unit, g->data->height[0]);
  curve->surface.height[1] = ph_pow2_apply(g->from_unit, g->data->height[1]);
  curve->surface.strips =
      ph_arena_array(out, curve->n, sizeof *curve->surface.strips);
  if (!curve->surface.strips || !ph_fair3_begin(&rules)) {
    return ph_fail_memory(diag);
  }
  for (size_t i = 0; i < curve->n; i++) {
    set_strip(g, i, curve);
    set_fairness(&rules, curve, i);
  }
  status = ph_general_of(curve, out, diag);
  for (size_t i = 0; status == PH_OK && i < curve->n; i++) {
    status = see_strip(g, curve, i, diag);
  }
  if (status == PH_OK) {
    ph_develop(curve);
    ph_surface_measure(curve);
    report(g, result);
  }
  return status;
}

enum ph_status ph_cone_general(const struct ph_problem *problem,
                               const struct ph_cone_data *data,
                               struct ph_arena *out, struct ph_arena *scratch,
                               struct ph_result *result, struct ph_diag *diag) {
  struct general g = {
      .problem = problem,
      .data = data,
      .from_unit = ph_pow2_of(-data->exponent),
      .to_unit = ph_pow2_of(data->exponent),
      .common = ph_arena_array(scratch, data->n, sizeof *g.common),
      .unit = ph_value_is(&problem->field[PH_F_TANGENT_SCALE], "unit")};
  enum ph_status status =
      g.common ? set_apexes(&g, diag) : ph_fail_memory(diag);
  for (size_t i = 0; status == PH_OK && i < data->n; i++) {
    status = set_common(&g, i, diag);
  }
  if (status == PH_OK) {
    status = check_each(&g, PH_F_ALPHA, diag);
  }
  if (status == PH_OK) {
    status = check_each(&g, PH_F_ANGLES, diag);
  }
  if (status == PH_OK) {
    status = set_curve(&g, scratch, diag);
  }
  if (status == PH_OK) {
    status =
        ph_method_spatial_hermite.solve(&g.curve, out, scratch, result, diag);
    if (status != PH_OK) {
      name_strips(diag);
    }
  }
  return status == PH_OK ? build(&g, out, result, diag) : status;
}
