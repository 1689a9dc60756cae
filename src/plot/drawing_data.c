/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Of drawings: control polygons, data, and vectors at these (see pen.h). */
#include "plot/pen.h"

#include "kernel/s2.h"

#include <math.h>

/* A step along a great circle, whose chord leaves it by 1/4000 of the radius.
 */
static const double ARC_STEP = 0.04;

/* The longest vector, relative to the size of the data and to the mean length
 * of the curve from one to the next. */
static const double VECTOR_SIZE = 0.12, VECTOR_SPACING = 0.5;

/* ---- control polygons ---------------------------------------------------- */

/* A point of the unit sphere, and back. */
static ph_vec3 to_unit(const struct ph_curve *curve, ph_vec3 p) {
  return ph_vec3_unit(ph_vec3_sub(p, ph_vec3_get(curve->sphere.center, 3)));
}

static ph_vec3 from_unit(const struct ph_curve *curve, ph_vec3 p) {
  return ph_vec3_along(ph_vec3_get(curve->sphere.center, 3),
                       curve->sphere.radius, p);
}

/* From where the pen is, at p, along a great circle to q. */
static void draw_arc(struct ph_pen *pen, const struct ph_curve *curve,
                     ph_vec3 p, ph_vec3 q) {
  ph_vec3 a = to_unit(curve, p), b = to_unit(curve, q);
  size_t steps = 1 + (size_t)(ph_s2_angle(a, b) / ARC_STEP);
  for (size_t i = 1; i < steps; i++) {
    ph_pen_to(pen,
              from_unit(curve, ph_s2_slerp(a, b, (double)i / (double)steps)));
  }
  ph_pen_to(pen, q);
}

void ph_pen_polygons(struct ph_pen *pen) {
  const struct ph_curve *curve = &pen->result->curve;
  pen->box = false;
  for (size_t k = 0; k < curve->n; k++) {
    const double *v = ph_curve_points(curve, k);
    ph_vec3 p, last = {0, 0, 0};
    for (size_t i = 0; i <= curve->degree; i++, last = p) {
      p = ph_vec3_get(v + curve->dimension * i, curve->dimension);
      if (i > 0 && pen->drawing->space == PH_SPHERE) {
        draw_arc(pen, curve, last, p);
      } else {
        ph_pen_to(pen, p);
      }
    }
    ph_pen_lift(pen, PH_STROKE_POLYGON, k);
  }
  pen->box = true;
}

/* ---- data ---------------------------------------------------------------- */

void ph_pen_numbers(struct ph_pen *pen, size_t n) {
  const struct ph_result *r = pen->result;
  struct ph_drawing *d = pen->drawing;
  size_t gone = 0, number = 0;
  if (r->merged_n == 0) {
    return;
  }
  d->numbers = ph_arena_array(&d->arena, n, sizeof *d->numbers);
  pen->failed = pen->failed || !d->numbers;
  for (size_t i = 0; !pen->failed && i < n; i++, number++) {
    for (; gone < r->merged_n && r->merged[gone] == number; gone++) {
      number++;
    }
    d->numbers[i] = number;
  }
}

void ph_pen_data(struct ph_pen *pen) {
  const struct ph_result *r = pen->result;
  const struct ph_curve *curve = &r->curve;
  struct ph_drawing *d = pen->drawing;
  const size_t n = r->intervals_n ? r->intervals_n : curve->n;
  d->data = ph_arena_array(&d->arena, n + 1, sizeof *d->data);
  if (!d->data) {
    pen->failed = true;
    return;
  }
  for (size_t i = 0; i < n; i++) {
    const double *v =
        ph_curve_points(curve, r->intervals_n ? r->intervals[i].first : i);
    d->data[i] = ph_vec3_get(v, curve->dimension);
  }
  d->data_n = n;
  if (!curve->closed) {
    const double *v =
        ph_curve_points(curve, curve->n - 1) + curve->degree * curve->dimension;
    d->data[d->data_n++] = ph_vec3_get(v, curve->dimension);
  }
  for (size_t i = 0; i < d->data_n; i++) {
    ph_pen_box(d, d->data[i]);
  }
  ph_pen_numbers(pen, d->data_n);
}

/* ---- tangents and derivatives -------------------------------------------- */

/* A field of vectors at the points, or at both ends. */
struct vectors {
  const struct ph_value *value; /* NULL: there is none */
  bool ends;
  bool directions; /* their lengths say nothing */
};

static struct vectors given_vectors(const struct ph_problem *problem,
                                    bool closed) {
  static const struct {
    enum ph_field_id id;
    bool ends, directions;
  } fields[] = {{PH_F_TANGENTS, false, true},
                {PH_F_DERIVATIVES, false, false},
                {PH_F_END_TANGENTS, true, true},
                {PH_F_END_DERIVATIVES, true, false}};
  struct vectors none = {NULL, false, false};
  for (size_t i = 0; i < sizeof fields / sizeof fields[0]; i++) {
    const struct ph_value *value = &problem->field[fields[i].id];
    if (value->kind == PH_VECTORS && !(fields[i].ends && closed)) {
      return (struct vectors){value, fields[i].ends, fields[i].directions};
    }
  }
  return none;
}

/* Number i of the vectors that belong to data points, and its point. */
static ph_vec3 vector_at(const struct ph_drawing *d, const struct vectors *v,
                         size_t i, size_t *point) {
  *point = v->ends && i > 0 ? d->data_n - 1 : i;
  return ph_vec3_get(v->value->v + v->value->dimension * i,
                     v->value->dimension);
}

/* From a data point by a vector: on a sphere by what of it is tangent. */
static void draw_vector(struct ph_pen *pen, ph_vec3 from, ph_vec3 vector) {
  const struct ph_curve *curve = &pen->result->curve;
  ph_pen_to(pen, from);
  if (pen->drawing->space == PH_SPHERE) {
    ph_vec3 p = to_unit(curve, from), v = ph_vec3_normal(vector, p);
    double angle = ph_vec3_abs(vector) / curve->sphere.radius;
    size_t steps = 1 + (size_t)(angle / ARC_STEP);
    v = ph_vec3_scale(angle / ph_vec3_abs(v), v);
    for (size_t i = 1; i <= steps; i++) {
      double t = (double)i / (double)steps;
      ph_pen_to(pen, from_unit(curve, ph_s2_exp(p, ph_vec3_scale(t, v))));
    }
  } else {
    ph_pen_to(pen, ph_vec3_add(from, vector));
  }
}

void ph_pen_vectors(struct ph_pen *pen) {
  const struct ph_curve *curve = &pen->result->curve;
  const struct ph_drawing *d = pen->drawing;
  const struct vectors given = given_vectors(pen->problem, curve->closed);
  size_t n = given.value ? given.value->n : 0, at;
  double longest = 0, size;
  n = n < d->data_n ? n : d->data_n;
  size = fmin(2 * VECTOR_SIZE * ph_curve_size(curve),
              VECTOR_SPACING * curve->length / (double)d->data_n);
  for (size_t i = 0; i < n; i++) {
    longest = fmax(longest, ph_vec3_abs(vector_at(d, &given, i, &at)));
  }
  for (size_t i = 0; i < n; i++) {
    ph_vec3 vector = vector_at(d, &given, i, &at);
    double length = ph_vec3_abs(vector);
    if (length > 0) {
      draw_vector(
          pen, d->data[at],
          ph_vec3_scale(size / (given.directions ? length : longest), vector));
      ph_pen_lift(pen, PH_STROKE_TANGENT, at);
    }
  }
}

size_t ph_pen_vectors_n(const struct ph_pen *pen) {
  const struct ph_value *given =
      given_vectors(pen->problem, pen->result->curve.closed).value;
  return given ? given->n : 0;
}
