/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Random problems of spatial Hermite interpolation (see spatial.h). */
#include "spatial_data.h"
#include "spatial_unit.h"
#include "unit.h"

#include "solve/method.h"

const char *spatial_name(enum spatial_family family) {
  static const char *const names[] = {
      "random",   "walk",     "helix",    "flat",     "tilted",
      "straight", "reversed", "parallel", "opposite", "near",
      "mixed",    "far",      "fast",     "slow"};
  return names[family];
}

size_t spatial_segments(const struct spatial_data *data) {
  return data->closed ? data->n : data->n - 1;
}

ph_vec3 spatial_chord(const struct spatial_data *data, size_t k) {
  size_t to = k + 1 < data->n ? k + 1 : 0;
  return ph_vec3_sub(data->point[to], data->point[k]);
}

/* ---- families -------------------------------------------------------- */

/* 10^x with x uniform. */
static double power(struct unit_random *r, double low, double high) {
  return pow(10, unit_random_in(r, low, high));
}

/* A vector anywhere in the cube |x|, |y|, |z| < 1, or in its plane z = 0. */
static ph_vec3 in_cube(struct unit_random *r, bool flat) {
  double x = unit_random_in(r, -1, 1), y = unit_random_in(r, -1, 1);
  return ph_vec3_of(x, y, flat ? 0 : unit_random_in(r, -1, 1));
}

static ph_vec3 direction_in(struct unit_random *r, bool flat) {
  ph_vec3 v = flat ? in_cube(r, true) : unit_random_direction(r);
  return ph_vec3_unit(v);
}

/* A direction, but for 1 to 1e-16 of it. */
static ph_vec3 nearly(struct unit_random *r, ph_vec3 direction) {
  return ph_vec3_unit(
      ph_vec3_along(direction, power(r, -17, 0), in_cube(r, false)));
}

/* The step from point k to the next. */
static ph_vec3 step_of(struct unit_random *r, enum spatial_family family,
                       ph_vec3 line) {
  double length = unit_random_in(r, 0.5, 2);
  switch (family) {
  case SPATIAL_STRAIGHT:
    return ph_vec3_scale(length, line);
  case SPATIAL_REVERSED:
    return ph_vec3_scale(unit_random_below(r, 2) ? length : -length, line);
  case SPATIAL_NEAR:
    length *= unit_random_below(r, 3) ? 1 : power(r, -12, 0);
    break;
  case SPATIAL_MIXED:
    length = power(r, -9, 0);
    break;
  default:
    break;
  }
  return ph_vec3_scale(length, direction_in(r, family == SPATIAL_FLAT ||
                                                   family == SPATIAL_TILTED));
}

static ph_vec3 tangent_of(struct unit_random *r, enum spatial_family family,
                          ph_vec3 line, size_t k) {
  switch (family) {
  case SPATIAL_STRAIGHT:
  case SPATIAL_REVERSED:
    return line;
  case SPATIAL_PARALLEL:
    return nearly(r, line);
  case SPATIAL_OPPOSITE:
    return nearly(r, ph_vec3_scale(k % 2 ? -1 : 1, line));
  default:
    return direction_in(r, family == SPATIAL_FLAT || family == SPATIAL_TILTED);
  }
}

static void helix(struct unit_random *r, struct spatial_data *data) {
  double pitch = unit_random_in(r, -2, 2), t = unit_random_in(r, -3, 3);
  for (size_t k = 0; k < data->n; k++) {
    data->point[k] = ph_vec3_of(cos(t), sin(t), pitch * t);
    data->vector[k] = ph_vec3_unit(ph_vec3_of(-sin(t), cos(t), pitch));
    t += unit_random_in(r, 0.2, 1.5);
  }
}

static void turn_all(struct unit_random *r, struct spatial_data *data) {
  ph_quat turn = unit_random_turn(r);
  ph_vec3 x = ph_quat_i(turn, turn), y = ph_quat_j(turn, turn);
  for (size_t k = 0; k < data->n; k++) {
    ph_vec3 p = data->point[k], t = data->vector[k];
    data->point[k] = ph_vec3_along(ph_vec3_scale(p.x, x), p.y, y);
    data->vector[k] = ph_vec3_along(ph_vec3_scale(t.x, x), t.y, y);
  }
}

void spatial_points(struct unit_random *r, enum spatial_family family, size_t n,
                    bool closed, struct spatial_data *data) {
  ph_vec3 line = unit_random_direction(r), at = {0, 0, 0};
  *data = (struct spatial_data){.family = family, .n = n, .closed = closed};
  data->given = SPATIAL_TANGENTS;
  ck_assert_uint_le(n, SPATIAL_POINTS_MAX);
  if (family == SPATIAL_HELIX) {
    helix(r, data);
    return;
  }
  if (family == SPATIAL_FAR) {
    at = ph_vec3_scale(power(r, 3, 12), line);
  }
  for (size_t k = 0; k < n; k++) {
    data->point[k] = family == SPATIAL_RANDOM ? in_cube(r, false) : at;
    data->vector[k] = tangent_of(r, family, line, k);
    at = ph_vec3_add(at, step_of(r, family, line));
  }
  if (family == SPATIAL_TILTED) {
    turn_all(r, data);
  }
}

/* ---- the other fields ------------------------------------------------ */

/* Derivatives of about the size of the chord that follows. */
static void set_derivatives(struct unit_random *r, struct spatial_data *data) {
  data->given = SPATIAL_DERIVATIVES;
  for (size_t k = 0; k < data->n; k++) {
    double size = ph_vec3_abs(spatial_chord(data, k)) * power(r, -0.5, 0.5);
    size *= data->family == SPATIAL_FAST   ? power(r, 0, 8)
            : data->family == SPATIAL_SLOW ? power(r, -8, 0)
                                           : 1;
    data->vector[k] = ph_vec3_scale(size, data->vector[k]);
  }
}

static void set_choice(struct unit_random *r, struct spatial_data *data) {
  static const char *const criteria[] = {NULL, "cc", "cc", "hc", "bv", "zero"};
  static const char *const axes[] = {NULL, "chord", "x", "bisector"};
  size_t choice = unit_random_below(r, 7);
  data->atph = unit_random_below(r, 3) == 0;
  data->axis = axes[unit_random_below(r, 4)];
  data->has_angles = choice == 6;
  data->criterion = choice < 6 ? criteria[choice] : NULL;
  if (data->atph && choice == 0) {
    data->criterion = "cc"; /* by default it is a functional */
  }
}

void spatial_of(struct unit_random *r, enum spatial_family family,
                size_t points_max, struct spatial_data *data) {
  static const char *const shapes[] = {NULL, "true", "false"};
  bool closed = unit_random_below(r, 2);
  size_t least = closed ? 3 : 2, segments;
  size_t n = least + unit_random_below(r, points_max - least + 1);
  spatial_points(r, family, n, closed, data);
  segments = spatial_segments(data);
  if (family == SPATIAL_FAST || family == SPATIAL_SLOW ||
      unit_random_below(r, 3) == 0) {
    set_derivatives(r, data);
  } else if (unit_random_below(r, 2)) {
    data->given = SPATIAL_POINTS;
  }
  set_choice(r, data);
  data->shape = shapes[unit_random_below(r, 3)];
  data->has_tension = unit_random_below(r, 3) == 0;
  data->has_knots = unit_random_below(r, 3) == 0;
  data->knots[0] = unit_random_in(r, -1, 1);
  for (size_t k = 0; k < segments; k++) {
    double chord = ph_vec3_abs(spatial_chord(data, k));
    data->angles[2 * k] = unit_random_in(r, -3.2, 3.2);
    data->angles[2 * k + 1] = unit_random_in(r, -3.2, 3.2);
    data->alpha[k] = unit_random_in(r, 0.01, 2.5);
    data->tension[k] = unit_random_in(r, 0.3, 1.2);
    data->knots[k + 1] = data->knots[k] + chord * power(r, -0.3, 0.3);
    data->has_knots = data->has_knots && data->knots[k + 1] > data->knots[k];
  }
}

void spatial_any(struct unit_random *r, size_t points_max,
                 struct spatial_data *data) {
  enum spatial_family family =
      (enum spatial_family)unit_random_below(r, SPATIAL_FAMILY_N);
  spatial_of(r, family, points_max, data);
}

/* ---- solutions ------------------------------------------------------- */

static void set_vectors(struct unit_solution *s, enum ph_field_id id,
                        const ph_vec3 *v, size_t n) {
  double *to = unit_numbers(s, 3 * n);
  for (size_t k = 0; k < n; k++) {
    ph_vec3_put(v[k], 3, to + 3 * k);
  }
  unit_set_array(&s->problem, id, to, n, 3);
}

static void set_problem(const struct spatial_data *d, struct unit_solution *s) {
  struct ph_problem *p = &s->problem;
  size_t n = spatial_segments(d);
  set_vectors(s, PH_F_POINTS, d->point, d->n);
  unit_set_flag(p, PH_F_CLOSED, d->closed);
  if (d->given != SPATIAL_POINTS) {
    set_vectors(s,
                d->given == SPATIAL_TANGENTS ? PH_F_TANGENTS : PH_F_DERIVATIVES,
                d->vector, d->n);
  }
  unit_set_word(p, PH_F_CRITERION, d->criterion);
  unit_set_word(p, PH_F_AXIS, d->axis);
  if (d->has_angles) {
    unit_set_copy(s, PH_F_ANGLES, d->angles, n, 2);
  }
  if (d->atph) {
    unit_set_word(p, PH_F_BASIS, "atph");
    unit_set_copy(s, PH_F_ALPHA, d->alpha, n, 1);
  }
  if (d->has_knots) {
    unit_set_copy(s, PH_F_KNOTS, d->knots, n + 1, 1);
  }
  if (d->has_tension) {
    unit_set_copy(s, PH_F_TENSION, d->tension, n, 1);
  }
  if (d->shape) {
    unit_set_flag(p, PH_F_SHAPE, strcmp(d->shape, "true") == 0);
  }
}

enum ph_status spatial_solve(const struct spatial_data *d, size_t which,
                             struct unit_solution *s) {
  static const char *const given[] = {"points", "tangents", "derivatives"};
  enum ph_status status;
  unit_case(
      "PH_SEED=%lu, case %zu (%s, %zu points, %s, %s, %s, %s, axis "
      "%s, shape %s%s%s)",
      unit_seed(), which, spatial_name(d->family), d->n,
      d->closed ? "closed" : "open", given[d->given], d->atph ? "atph" : "ph",
      d->has_angles  ? "angles"
      : d->criterion ? d->criterion
                     : "by default",
      d->axis ? d->axis : "by default", d->shape ? d->shape : "by default",
      d->has_knots ? ", knots" : "", d->has_tension ? ", tension" : "");
  unit_solution_free(s);
  set_problem(d, s);
  status = unit_solve(&ph_method_spatial_hermite, s);
  if (status == PH_OK) {
    status = unit_certify("spatial-hermite", s);
  }
  return status;
}

bool spatial_is_chosen(const struct spatial_data *d, const char *criterion) {
  return d->criterion && strcmp(d->criterion, criterion) == 0;
}

/* The error that a problem may have: no angles about an axis that a vector is
 * opposite to; an F3 that no quadrature reaches. */
static enum ph_status possible_error(const struct spatial_data *d) {
  bool axis = !d->axis || strcmp(d->axis, "bisector") != 0;
  if (axis && (d->has_angles || spatial_is_chosen(d, "zero"))) {
    return PH_E_INFEASIBLE;
  }
  return spatial_is_chosen(d, "F3") ? PH_E_NO_CONVERGENCE : PH_OK;
}

bool spatial_answer(const struct spatial_data *d, size_t which,
                    struct unit_solution *s) {
  enum ph_status status = spatial_solve(d, which, s);
  bool expected = status == PH_OK || status == possible_error(d);
  ck_that(expected && !s->refused, "%s %s", s->diag.field, s->diag.message);
  return status == PH_OK;
}

ph_vec3 spatial_point(const struct ph_curve *curve, size_t k, size_t i) {
  return ph_vec3_get(curve->control_points + 18 * k + 3 * i, 3);
}

double spatial_segment_size(const struct ph_curve *curve, size_t k) {
  double size = 0;
  for (size_t i = 0; i < 5; i++) {
    size += ph_vec3_abs(ph_vec3_sub(spatial_point(curve, k, i + 1),
                                    spatial_point(curve, k, i)));
  }
  return size;
}

double spatial_rounding(const struct ph_curve *curve, size_t k) {
  double largest = 0;
  for (size_t i = 0; i < 18; i++) {
    largest = unit_larger(largest, fabs(curve->control_points[18 * k + i]));
  }
  return DBL_EPSILON * largest;
}
