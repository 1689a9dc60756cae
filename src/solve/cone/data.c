/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The contact elements of a problem (see cone.h). */
#include "solve/common/fields.h"
#include "solve/cone/cone.h"

#include <float.h>
#include <math.h>

/* Cosine of ruling and tangent: what was written with four digits has 1e-4,
 * and every misprint that was met more than this. */
static const double ORTHOGONAL = 1e-3;

/* Distance of a given normal from ruling x tangent, or its opposite. */
static const double NORMAL = 5e-3;

/* A tolerance of this is none any more. */
static const double DEGENERATE_MAX = 0.1;

static ph_vec3 scaled(struct ph_pow2 scale, ph_vec3 v) {
  return ph_vec3_of(ph_pow2_apply(scale, v.x), ph_pow2_apply(scale, v.y),
                    ph_pow2_apply(scale, v.z));
}

static enum ph_status set_element(const struct ph_problem *p, size_t i,
                                  struct ph_pow2 scale,
                                  struct ph_contact_element *element,
                                  struct ph_diag *diag) {
  const struct ph_value *normals = &p->field[PH_F_NORMALS];
  const ph_vec3 e =
      ph_fields_unit(ph_fields_vector(&p->field[PH_F_RULINGS], i));
  const ph_vec3 d =
      ph_fields_unit(ph_fields_vector(&p->field[PH_F_TANGENTS], i));
  const double cosine = ph_vec3_dot(e, d);
  ph_vec3 given;
  double off;
  if (!(fabs(cosine) <= ORTHOGONAL)) {
    return ph_fail_at(diag, PH_E_BAD_VALUE, "tangents", i,
                      "is not orthogonal to rulings[%zu]: the cosine is %.3g, "
                      "at most %g is allowed; look for misprints in both",
                      i, cosine, ORTHOGONAL);
  }
  element->p = scaled(scale, ph_fields_vector(&p->field[PH_F_POINTS], i));
  element->e = e;
  element->d = ph_vec3_unit(ph_vec3_normal(d, e));
  element->n = ph_vec3_cross(element->e, element->d);
  if (normals->kind == PH_ABSENT) {
    return PH_OK;
  }
  given = ph_fields_unit(ph_fields_vector(normals, i));
  off = fmin(ph_vec3_abs(ph_vec3_sub(given, element->n)),
             ph_vec3_abs(ph_vec3_add(given, element->n)));
  return off <= NORMAL
             ? PH_OK
             : ph_fail_at(diag, PH_E_BAD_VALUE, "normals", i,
                          "is neither rulings[%zu] x tangents[%zu] nor its "
                          "opposite: it is off by %.3g, at most %g is allowed",
                          i, i, off, NORMAL);
}

/* Neighbours are at different points. */
static enum ph_status check_points(const struct ph_cone_data *data,
                                   struct ph_diag *diag) {
  for (size_t i = 0; i < data->n; i++) {
    const size_t to = i + 1 < data->elements_n ? i + 1 : 0;
    const ph_vec3 a = data->element[i].p, b = data->element[to].p;
    if (!(ph_vec3_abs(ph_vec3_sub(b, a)) >
          4 * DBL_EPSILON * ph_vec3_abs(ph_vec3_add(a, b)))) {
      return ph_fields_coincide(diag, "points", i, to);
    }
  }
  return PH_OK;
}

static enum ph_status set_elements(const struct ph_problem *p,
                                   struct ph_cone_data *data,
                                   struct ph_contact_element *element,
                                   struct ph_diag *diag) {
  static const enum ph_field_id vectors[] = {PH_F_RULINGS, PH_F_TANGENTS,
                                             PH_F_NORMALS};
  const struct ph_pow2 scale = ph_pow2_of(data->exponent);
  enum ph_status status = PH_OK;
  for (size_t i = 0; status == PH_OK && i < 3; i++) {
    if (ph_fields_given(p, vectors[i])) {
      status = ph_fields_vectors(p, vectors[i], data->elements_n, diag);
    }
  }
  for (size_t i = 0; status == PH_OK && i < data->elements_n; i++) {
    status = set_element(p, i, scale, &element[i], diag);
  }
  data->element = element;
  return status == PH_OK ? check_points(data, diag) : status;
}

static enum ph_status set_lambda(const struct ph_problem *p,
                                 struct ph_arena *arena,
                                 struct ph_cone_data *data,
                                 struct ph_diag *diag) {
  const struct ph_value *value = &p->field[PH_F_LAMBDA];
  const struct ph_pow2 scale = ph_pow2_of(data->exponent);
  enum ph_status status;
  double *lambda;
  data->lambda = NULL;
  if (value->kind == PH_ABSENT || value->kind == PH_WORD) {
    return PH_OK;
  }
  if (value->kind == PH_NUMBERS && value->n != data->n) {
    return ph_fail(diag, PH_E_BAD_SHAPE, "lambda",
                   "must be a number, or as many as there are pairs, %zu, "
                   "found %zu",
                   data->n, value->n);
  }
  lambda = ph_arena_array(arena, data->n, sizeof *lambda);
  if (!lambda) {
    return ph_fail_memory(diag);
  }
  status = ph_fields_each(value, "lambda", data->n, HUGE_VAL, "greater than 0",
                          lambda, diag);
  for (size_t i = 0; status == PH_OK && i < data->n; i++) {
    lambda[i] = ph_pow2_apply(scale, lambda[i]);
  }
  data->lambda = lambda;
  return status;
}

static enum ph_status set_rest(const struct ph_problem *p,
                               struct ph_cone_data *data,
                               struct ph_diag *diag) {
  const struct ph_value *degenerate = &p->field[PH_F_DEGENERATE];
  const struct ph_value *height = &p->field[PH_F_HEIGHT];
  const struct ph_pow2 scale = ph_pow2_of(data->exponent);
  data->degenerate = PH_CONE_DEGENERATE;
  data->height[0] = data->height[1] = 0;
  if (degenerate->kind != PH_ABSENT) {
    data->degenerate = degenerate->number;
    if (!(data->degenerate > 0 && data->degenerate <= DEGENERATE_MAX)) {
      return ph_fail(diag, PH_E_BAD_VALUE, "degenerate_tolerance",
                     "must be greater than 0 and at most %g, found %.17g",
                     DEGENERATE_MAX, degenerate->number);
    }
  }
  if (height->kind == PH_ABSENT) {
    return PH_OK;
  }
  if (height->n != 2) {
    return ph_fail(diag, PH_E_BAD_SHAPE, "height",
                   "must have 2 numbers, from where to where, found %zu",
                   height->n);
  }
  if (!(height->v[0] <= height->v[1])) {
    return ph_fail(diag, PH_E_BAD_VALUE, "height",
                   "must not begin above its end, found [%.17g,%.17g]",
                   height->v[0], height->v[1]);
  }
  data->height[0] = ph_pow2_apply(scale, height->v[0]);
  data->height[1] = ph_pow2_apply(scale, height->v[1]);
  return PH_OK;
}

/* Fields of one method are none of the other. */
static enum ph_status check_method(const struct ph_problem *p,
                                   struct ph_cone_data *data,
                                   struct ph_diag *diag) {
  static const enum ph_field_id own[2][6] = {
      {PH_F_APEXES, PH_F_CONTACT_POINT, PH_F_TANGENT_SCALE, PH_F_CRITERION,
       PH_F_ANGLES, PH_F_ALPHA},
      {PH_F_LAMBDA, PH_F_DEGENERATE, PH_FIELD_N, PH_FIELD_N, PH_FIELD_N,
       PH_FIELD_N}};
  data->general = ph_value_is(&p->field[PH_F_METHOD], "atph");
  for (size_t i = 0; i < 6; i++) {
    const enum ph_field_id id = own[data->general][i];
    if (id != PH_FIELD_N && ph_fields_given(p, id)) {
      return ph_fail(diag, PH_E_BAD_VALUE, ph_field_name(id),
                     "is of \"method\":\"%s\"",
                     data->general ? "circular" : "atph");
    }
  }
  if (data->general && !ph_fields_given(p, PH_F_APEXES)) {
    return ph_fail(diag, PH_E_MISSING_FIELD, "apexes",
                   "is missing: \"method\":\"atph\" has its vertices there");
  }
  return PH_OK;
}

enum ph_status ph_cone_data_of(const struct ph_problem *problem,
                               struct ph_arena *arena,
                               struct ph_cone_data *data,
                               struct ph_diag *diag) {
  const struct ph_value *points = &problem->field[PH_F_POINTS];
  struct ph_contact_element *element;
  enum ph_status status = ph_fields_segments(problem, &data->n, diag);
  if (status == PH_OK) {
    status = check_method(problem, data, diag);
  }
  if (status != PH_OK) {
    return status;
  }
  data->closed = problem->field[PH_F_CLOSED].flag;
  data->elements_n = data->closed ? data->n : data->n + 1;
  data->exponent = ph_fields_exponent(
      ph_fields_largest(points->v, points->dimension * points->n));
  element = ph_arena_array(arena, data->elements_n, sizeof *element);
  if (!element) {
    return ph_fail_memory(diag);
  }
  status = set_elements(problem, data, element, diag);
  if (status == PH_OK) {
    status = set_lambda(problem, arena, data, diag);
  }
  return status == PH_OK ? set_rest(problem, data, diag) : status;
}
