/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Data and their intervals (see data.h). */
#include "check/data.h"

#include "kernel/degree.h"
#include "check/checks.h"

/* A joint is at a datum, where others are possible, within this of the size,
 * unless others are nearer before the curve is as far away again as this. */
static const double AT_DATUM = 1e-9;
static const double AWAY_AGAIN = 1e-6;

/* A last point that repeats the first one, in units of rounding; and a joint
 * than which none is nearer. */
enum { ROUND_REPEATED = 64 };

/* ---- which data ---------------------------------------------------------- */

static const struct ph_value *vectors(const struct ph_check *v,
                                      enum ph_field_id id) {
  const struct ph_value *value = &v->problem->field[id];
  return value->kind == PH_VECTORS && value->n > 1 ? value : NULL;
}

static void set_fields(const struct ph_check *v, struct ph_check_data *data) {
  const struct ph_value *lonlat = vectors(v, PH_F_LONLAT);
  data->n = 0;
  data->lonlat = lonlat != NULL;
  data->points = lonlat ? lonlat : vectors(v, PH_F_POINTS);
  data->vectors = vectors(v, PH_F_DERIVATIVES);
  data->derivatives = data->vectors != NULL;
  if (!data->vectors) {
    data->vectors = vectors(v, PH_F_TANGENTS);
  }
}

ph_vec3 ph_check_datum_on_sphere(const struct ph_check *v,
                                 const struct ph_check_data *data,
                                 const double *x, double *off) {
  const struct ph_curve *c = v->curve;
  ph_vec3 center = ph_check_vector(v, c->sphere.center, 3), from;
  double radius = ph_check_scaled(v, c->sphere.radius);
  if (data->lonlat) {
    return ph_vec3_along(center, radius, ph_degree_to_unit(x[0], x[1]));
  }
  from = ph_vec3_sub(ph_check_vector(v, x, data->points->dimension), center);
  *off = fabs(ph_vec3_abs(from) / radius - 1);
  return ph_vec3_along(center, radius, ph_vec3_unit(from));
}

/* ---- intervals ------------------------------------------------------------
 */

static ph_vec3 end_of(const struct ph_check *v, size_t k) {
  const struct ph_curve *c = v->curve;
  return ph_check_vector(v, ph_curve_points(c, k) + c->degree * c->dimension,
                         c->dimension);
}

/* How many intervals the data of closed Bezier curves have, of which the curve
 * does not say it. */
static size_t closed_intervals(const struct ph_check *v,
                               const struct ph_check_data *data) {
  size_t n = data->points->n;
  double off;
  ph_vec3 first = ph_check_datum(v, data, 0, &off);
  ph_vec3 last = ph_check_datum(v, data, n - 1, &off);
  return ph_check_apart(first, last) <= ROUND_REPEATED * v->scale.rounding
             ? n - 1
             : n;
}

/* How many intervals there are, each with as many segments.  A repeated last
 * point of closed data counts once: three points or more can be so in one way
 * only. */
static size_t equal_intervals(const struct ph_check *v,
                              const struct ph_check_data *data) {
  size_t n = v->curve->n;
  size_t given = (data->points ? data->points : data->vectors)->n;
  bool once =
      v->curve->closed && n % given == 0 && n / given <= PH_CHECK_REFINE_MAX;
  return once ? given : given - 1;
}

static size_t count(const struct ph_check *v,
                    const struct ph_check_data *data) {
  const struct ph_curve *c = v->curve;
  if (v->intervals_n > 0) {
    return v->intervals_n;
  }
  if (v->kind->converted && data->points) {
    return c->closed ? closed_intervals(v, data) : data->points->n - 1;
  }
  return v->promise->intervals ? equal_intervals(v, data) : c->n;
}

/* Whether an array has one element for each datum. */
static bool fits(const struct ph_check *v, const struct ph_value *value,
                 size_t n) {
  return !value || value->n == n + 1 || (v->curve->closed && value->n == n);
}

/* How far segment k ends from a datum. */
static double end_away(const struct ph_check *v, size_t k, ph_vec3 datum) {
  return ph_check_apart(end_of(v, k), datum);
}

/* Whether all intervals have as many segments: of a certificate, which is told
 * of no intervals. */
static bool is_equal(const struct ph_check *v) {
  return v->promise->intervals && v->intervals_n == 0;
}

/* The segment, from one to another, whose end is at a datum; the other one if
 * there is none. */
static size_t ends_at(const struct ph_check *v, size_t from, size_t to,
                      ph_vec3 datum) {
  const double same = ROUND_REPEATED * v->scale.rounding;
  size_t at = from;
  double nearest = end_away(v, at, datum), away;
  while (at < to && !(nearest <= AT_DATUM * v->scale.size)) {
    nearest = end_away(v, ++at, datum);
  }
  for (size_t k = at + 1; k <= to && nearest > same; k++) {
    away = end_away(v, k, datum);
    if (!(away <= AWAY_AGAIN * v->scale.size)) {
      break;
    }
    if (away < nearest) {
      nearest = away;
      at = k;
    }
  }
  return at;
}

/* The segments of each interval.  Those of a Bezier curve in place of another
 * are cut: an interval ends with that which ends at its datum, or, where none
 * does, so that all others have one. */
static void set_segments(const struct ph_check *v, struct ph_check_data *data) {
  const struct ph_curve *c = v->curve;
  size_t next = 0;
  for (size_t i = 0; i < data->n; i++) {
    size_t most = c->n - (data->n - i), last = next;
    if (v->intervals_n > 0) {
      last = v->intervals[i].last;
    } else if (is_equal(v)) {
      last += c->n / data->n - 1;
    } else if (i + 1 == data->n) {
      last = c->n - 1;
    } else if (c->n > data->n) {
      double off;
      ph_vec3 datum = ph_check_datum(v, data, i + 1, &off);
      last = ends_at(v, next, most, datum);
    }
    data->last[i] = last;
    next = last + 1;
  }
}

bool ph_check_data_of(struct ph_check *v, struct ph_check_data *data,
                      enum ph_status *status) {
  set_fields(v, data);
  if (data->points || data->vectors) {
    data->n = count(v, data);
  }
  if (data->n == 0 || !fits(v, data->points, data->n) ||
      !fits(v, data->vectors, data->n) || data->n > v->curve->n ||
      (is_equal(v) && v->curve->n % data->n != 0)) {
    ph_check_wrong(v, PH_CHECK_SHAPE,
                   ph_check_of("segments", PH_CHECK_ONE, NULL),
                   "are not as many as the data of the problem want");
    return false;
  }
  data->i = 0;
  data->misses = 0;
  data->uncertain = 0;
  data->measured = 0;
  data->last = NULL;
  if (v->intervals_n == 0 && v->curve->n == data->n) {
    return true;
  }
  data->last = ph_arena_array(v->scratch, data->n, sizeof *data->last);
  if (!data->last) {
    *status = ph_fail_memory(v->diag);
    return false;
  }
  set_segments(v, data);
  return true;
}

size_t ph_check_interval(const struct ph_check_data *data, size_t k) {
  size_t i = 0, end = data->n;
  while (end - i > 1) {
    const size_t middle = i + (end - i) / 2;
    if (ph_check_first(data, middle) <= k) {
      i = middle;
    } else {
      end = middle;
    }
  }
  return i;
}

/* ---- ends of segments ------------------------------------------------------
 */

ph_vec3 ph_check_direction(const double *x, size_t dimension) {
  ph_vec3 a = ph_vec3_get(x, dimension);
  double largest = ph_check_larger(fabs(a.x), fabs(a.y));
  struct ph_pow2 scale;
  largest = ph_check_larger(largest, fabs(a.z));
  scale = ph_pow2_of(largest > 0 ? -ph_pow2_exponent(largest) : 0);
  return ph_vec3_unit(ph_vec3_of(ph_pow2_apply(scale, a.x),
                                 ph_pow2_apply(scale, a.y),
                                 ph_pow2_apply(scale, a.z)));
}

void ph_check_heading(struct ph_check *v, enum ph_check_id check,
                      const struct ph_check_segment *s, size_t end,
                      ph_vec3 wanted, double unit) {
  double speed = ph_vec3_abs(s->first[end]), error = s->noise / speed;
  if (error < PH_CHECK_NO_DIRECTION) {
    double miss = v->allow->miss * sqrt(s->spacing * v->mean_speed / speed);
    ph_check_miss(
        v, check, ph_check_in(s->k, "control_points"),
        ph_check_apart(ph_vec3_scale(1 / speed, s->first[end]), wanted), unit,
        error + v->allow->given + miss, "miss the given direction");
  } else {
    ph_check_done(v, check);
  }
}

void ph_check_derivative(struct ph_check *v, enum ph_check_id check,
                         const struct ph_check_segment *s, size_t end,
                         double factor, ph_vec3 wanted, bool knots) {
  ph_vec3 there = ph_vec3_scale(factor, wanted);
  double size = ph_vec3_abs(there);
  double error = v->allow->given + (knots ? v->knot / s->spacing : 0);
  ph_check_miss(
      v, check, ph_check_in(s->k, "control_points"),
      ph_check_apart(s->first[end], there), ph_check_larger(size, v->mean),
      s->noise + error * size + v->allow->miss * s->spacing * v->mean_speed,
      "miss the given derivative");
}
