/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A curve against the problem that it is said to solve: points, tangents and
 * derivatives, what is given at the ends, and lengths, as far as the command
 * promises them (promise.h).  Of a Bezier curve in place of another only the
 * direction is known.
 */
#include "check/checks.h"
#include "check/data.h"

/* What moves points of a sphere, unless the problem says it. */
static const double MOVED = 1e-3;

/* A root mean square of angles is the same to this. */
static const double SAME_RMS = 1e-9;

/* An end of an interval. */
struct end {
  const struct ph_check_segment *s;
  size_t end; /* of the segment: 0 or 1 */
  size_t datum;
  bool pair; /* the interval has two segments */
};

/* ---- what the problem is ---------------------------------------------------
 */

static bool is_flag(const struct ph_check *v, enum ph_field_id id) {
  return v->problem->field[id].kind == PH_BOOL && v->problem->field[id].flag;
}

/* Whether the curve is of the kind that was asked for. */
static bool is_asked_for(struct ph_check *v) {
  const struct ph_curve *c = v->curve;
  if (c->closed != is_flag(v, PH_F_CLOSED)) {
    ph_check_wrong(v, PH_CHECK_SHAPE, ph_check_of(NULL, PH_CHECK_ONE, "closed"),
                   "is not what the problem says");
    return false;
  }
  if ((v->promise->kinds & PH_KIND(ATPH)) &&
      ph_check_is_word(v, PH_F_BASIS, "atph") != v->kind->trigonometric) {
    ph_check_wrong(v, PH_CHECK_SHAPE, ph_check_of(NULL, PH_CHECK_ONE, "curve"),
                   "is not of the basis of the problem");
    return false;
  }
  return true;
}

bool ph_check_is_approximation(const struct ph_check *v) {
  if (!v->promise->approximate) {
    return false;
  }
  if (!v->problem) {
    return ph_check_known(v, PH_D_DISTANCE);
  }
  return v->problem->field[PH_F_MODE].kind == PH_WORD
             ? ph_check_is_word(v, PH_F_MODE, "approximate")
             : ph_check_field(v, PH_F_CURVE) != NULL;
}

/* ---- points ----------------------------------------------------------------
 */

static void check_point(struct ph_check *v, const struct end *e) {
  const struct ph_check_segment *s = e->s;
  double off, reach = v->scale.rounding, round = v->allow->point;
  ph_vec3 datum = ph_check_datum(v, v->data, e->datum, &off);
  if (s->kind->sphere) {
    reach += s->reach;
    ph_check_miss(v, PH_CHECK_INTERPOLATION,
                  ph_check_in(s->k, "control_points"), off - v->data->moved, 1,
                  round * reach / s->radius,
                  "stand for a point that is off the sphere");
  }
  ph_check_miss(v, PH_CHECK_INTERPOLATION, ph_check_in(s->k, "control_points"),
                ph_check_apart(s->end[e->end], datum), v->scale.size,
                v->allow->of_size * v->scale.size + round * reach,
                "miss the point");
}

/* Without points the curve begins at the start. */
static void check_start(struct ph_check *v, const struct end *e) {
  const struct ph_value *given = ph_check_field(v, PH_F_START);
  bool fits = given && (given->n == 2 || given->n == 3);
  ph_vec3 start =
      fits ? ph_check_vector(v, given->v, given->n) : ph_vec3_of(0, 0, 0);
  ph_check_miss(
      v, PH_CHECK_INTERPOLATION, ph_check_in(e->s->k, "control_points"),
      ph_check_apart(e->s->end[e->end], start), v->scale.size,
      v->allow->of_size * v->scale.size + v->allow->point * v->scale.rounding,
      "miss the start");
}

/* ---- tangents and derivatives ----------------------------------------------
 */

/* By how much an end is slower than the curve, at least 1.  A derivative was
 * met to a part of the mean one: that is what is left of its direction where
 * Bezier pieces are in the place of the curve. */
static double slowness(const struct ph_check *v, const struct end *e) {
  const struct ph_curve *c = v->curve;
  double range = (c->knots[c->n] - c->knots[0]) / e->s->spacing;
  double speed = ph_check_scaled(v, c->length) / range;
  return ph_check_larger(speed / ph_vec3_abs(e->s->first[e->end]), 1);
}

/* A given derivative against r' by u, where it is known what it is by, or else
 * its direction. */
static void check_derivative(struct ph_check *v, const struct end *e,
                             enum ph_check_id check, const double *w,
                             size_t dimension) {
  const struct ph_check_segment *s = e->s;
  enum ph_given given = v->kind->converted ? PH_GIVEN_NONE : v->promise->given;
  double factor = 1;
  if (given == PH_GIVEN_TENSION) {
    const double *tension = v->curve->choice.tension;
    factor = tension ? tension[s->k] * tension[s->k] * s->unit : s->unit;
  } else if (given == PH_GIVEN_KNOTS) {
    factor = s->spacing;
  }
  if (given == PH_GIVEN_NONE || (given == PH_GIVEN_CUBIC && !e->pair)) {
    ph_check_heading(v, check, s, e->end, ph_check_direction(w, dimension),
                     v->kind->converted ? slowness(v, e) : 1);
  } else {
    ph_check_derivative(v, check, s, e->end, factor,
                        ph_check_vector(v, w, dimension),
                        given == PH_GIVEN_KNOTS);
  }
}

/* The length of interval i that is given, at unit scale. */
static double length_of(const struct ph_check *v, const struct ph_value *given,
                        size_t i) {
  return ph_check_scaled(v, given->kind == PH_NUMBERS ? given->v[i]
                                                      : given->number);
}

/* Whether there is a length for each interval, or one for all. */
static bool has_lengths(struct ph_check *v, const struct ph_value *given) {
  if (given && (given->kind != PH_NUMBERS || given->n == v->data->n)) {
    return true;
  }
  ph_check_wrong(v, PH_CHECK_SHAPE, ph_check_of("segments", PH_CHECK_ONE, NULL),
                 "are not as many as the lengths of the problem");
  return false;
}

/* The length of a derivative at datum j, from the lengths and spacings of the
 * neighbouring intervals. [HUA14, sec. 5.3] */
static double mean_magnitude(const struct ph_check *v, size_t j) {
  const struct ph_check_data *data = v->data;
  const struct ph_value *given = ph_check_field(v, PH_F_LENGTHS);
  const double *t = v->curve->knots;
  double sum = 0;
  size_t first = j > 0 ? j - 1 : 0, last = j < data->n ? j : data->n - 1;
  for (size_t i = first; i <= last; i++) {
    double h = t[ph_check_last(data, i) + 1] - t[ph_check_first(data, i)];
    sum += length_of(v, given, i) / h;
  }
  return sum / (double)(last - first + 1);
}

/* The standard deviation of the direction at datum j; 0: it is exact. */
static double sigma_of(const struct ph_check *v, size_t j) {
  const struct ph_value *sigma = ph_check_field(v, PH_F_TANGENT_SIGMA);
  return !sigma                      ? 0
         : sigma->kind != PH_NUMBERS ? sigma->number
         : j < sigma->n              ? sigma->v[j]
                                     : 0;
}

/* The angle to a direction that was measured, against what is claimed. */
static void check_deviation(struct ph_check *v, const struct end *e, size_t j,
                            ph_vec3 direction, double sigma) {
  struct ph_check_data *data = v->data;
  ph_vec3 there = e->s->first[e->end];
  double error = e->s->noise / ph_vec3_abs(there) + v->allow->given;
  double angle = atan2(ph_vec3_abs(ph_vec3_cross(there, direction)),
                       ph_vec3_dot(there, direction));
  data->misses += angle / sigma * (angle / sigma);
  data->uncertain = ph_check_larger(data->uncertain, error / sigma);
  data->measured++;
  if (v->claim && v->curve == &v->claim->curve && v->claim->deviations_n > j) {
    ph_check_miss(v, PH_CHECK_TANGENT,
                  ph_check_of("tangent_deviations", j, NULL),
                  fabs(v->claim->deviations[j] - angle), 1, error,
                  "is not the angle to the tangent");
  }
}

/* Their root mean square, against what is claimed. */
static void check_rms(struct ph_check *v) {
  const struct ph_check_data *data = v->data;
  double rms = sqrt(data->misses / (double)data->measured);
  if (ph_check_known(v, PH_D_TANGENT_RMS)) {
    ph_check_miss(v, PH_CHECK_TANGENT,
                  ph_check_of("diagnostics", PH_CHECK_ONE, "tangent_rms"),
                  fabs(v->diagnostics->value[PH_D_TANGENT_RMS] - rms), 1,
                  data->uncertain + SAME_RMS * rms,
                  "is not that of the angles to the tangents");
  }
}

static void check_vector(struct ph_check *v, const struct end *e) {
  const struct ph_value *given = v->data->vectors;
  size_t j = ph_check_index(v, v->data, e->datum);
  const double *w = given->v + given->dimension * j;
  ph_vec3 direction;
  if (v->data->derivatives) {
    check_derivative(v, e, PH_CHECK_TANGENT, w, given->dimension);
    return;
  }
  direction = ph_check_direction(w, given->dimension);
  if (v->data->magnitudes) {
    ph_check_derivative(v, PH_CHECK_TANGENT, e->s, e->end, e->s->spacing,
                        ph_vec3_scale(mean_magnitude(v, j), direction), true);
  } else if (sigma_of(v, j) > 0) {
    /* where two intervals meet, with the second */
    if (e->end == 0 || e->datum == v->data->n) {
      check_deviation(v, e, j, direction, sigma_of(v, j));
    }
  } else {
    ph_check_heading(v, PH_CHECK_TANGENT, e->s, e->end, direction, 1);
  }
  if (e->end == 1 && e->datum == v->data->n && v->data->measured > 0) {
    check_rms(v);
  }
}

/* The first and the last end of an open curve. */
static void check_given_end(struct ph_check *v, const struct end *e) {
  const struct ph_value *derivatives = ph_check_field(v, PH_F_END_DERIVATIVES);
  const struct ph_value *tangents = ph_check_field(v, PH_F_END_TANGENTS);
  const struct ph_value *given = derivatives ? derivatives : tangents;
  const double *w;
  if (!given || given->n != 2) {
    return;
  }
  w = given->v + (e->datum > 0 ? given->dimension : 0);
  if (derivatives) {
    check_derivative(v, e, PH_CHECK_END, w, given->dimension);
  } else {
    ph_check_heading(v, PH_CHECK_END, e->s, e->end,
                     ph_check_direction(w, given->dimension), 1);
  }
}

/* ---- intervals -------------------------------------------------------------
 */

/* What is given where an open curve begins or ends. */
static void check_outer(struct ph_check *v, const struct end *e) {
  if (v->curve->closed) {
    return;
  }
  if (!v->data->points && e->datum == 0) {
    check_start(v, e);
  }
  if (v->promise->ends) {
    check_given_end(v, e);
  }
}

static void check_end(struct ph_check *v, const struct end *e) {
  const struct ph_check_data *data = v->data;
  if (data->points) {
    check_point(v, e);
  }
  if (data->vectors) {
    check_vector(v, e);
  }
  if (e->datum == (e->end == 0 ? 0 : data->n)) {
    check_outer(v, e);
  }
}

void ph_check_given(struct ph_check *v, const struct ph_check_segment *s) {
  struct ph_check_data *data = v->data;
  size_t i = data->i;
  struct end e = {s, 0, i,
                  ph_check_last(data, i) == ph_check_first(data, i) + 1};
  if (s->k == ph_check_first(data, i)) {
    check_end(v, &e);
  }
  if (s->k == ph_check_last(data, i)) {
    e.end = 1;
    e.datum = ++data->i;
    check_end(v, &e);
  }
}

/* Lengths that are to be reached. */
void ph_check_given_lengths(struct ph_check *v) {
  const struct ph_check_data *data = v->data;
  const struct ph_value *given = data ? ph_check_field(v, PH_F_LENGTHS) : NULL;
  if (!v->promise->lengths || !given || ph_check_field(v, PH_F_LENGTH_SIGMA) ||
      !has_lengths(v, given)) {
    return;
  }
  for (size_t i = 0; i < data->n; i++) {
    double wanted = length_of(v, given, i), length = 0, allowance = 0;
    for (size_t k = ph_check_first(data, i); k <= ph_check_last(data, i); k++) {
      length += v->length[k];
      allowance += v->noise[k];
    }
    ph_check_miss(
        v, v->error ? PH_CHECK_LENGTH : PH_CHECK_PRESCRIBED,
        v->error ? ph_check_in(ph_check_last(data, i), NULL)
                 : ph_check_of("intervals", i, "length"),
        fabs(length - wanted), ph_check_unit(v->unit_length, length, v->mean),
        v->allow->length * length + v->allow->miss * v->interval + allowance,
        "misses what was prescribed");
  }
}

enum ph_status ph_check_given_begin(struct ph_check *v,
                                    struct ph_check_data *data) {
  const struct ph_value *moved;
  enum ph_status status = PH_OK;
  v->data = NULL;
  if (!v->problem || (!v->error && !is_asked_for(v)) ||
      ph_check_is_approximation(v) || !ph_check_data_of(v, data, &status)) {
    return status;
  }
  moved = ph_check_field(v, PH_F_RADIUS_TOLERANCE);
  data->moved = moved ? moved->number : MOVED;
  v->data = data;
  data->magnitudes = v->promise->lengths &&
                     ph_check_is_word(v, PH_F_MAGNITUDES, "mean") &&
                     !data->derivatives && data->vectors &&
                     has_lengths(v, ph_check_field(v, PH_F_LENGTHS));
  return PH_OK;
}
