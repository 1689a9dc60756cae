/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Which segments of a curve belong to which interval of the data, and what the
 * checks with a problem share.
 */
#ifndef PH_CHECK_DATA_H
#define PH_CHECK_DATA_H

#include "check/kind.h"

enum { PH_CHECK_REFINE_MAX = 3 };

struct ph_check_data {
  const struct ph_value *points;  /* what is given at the data: points */
  const struct ph_value *vectors; /* or tangents or derivatives, which may stand
                                     beside points; NULL: none */
  bool derivatives;               /* these */
  bool magnitudes; /* tangents are of derivatives whose lengths follow */
  bool lonlat;     /* points are longitudes and latitudes */
  double moved;    /* by how much of the radius points may be off a sphere */
  size_t n;        /* intervals */
  size_t *last;    /* [n] of their segments the last; NULL: each has one */
  size_t i;        /* the interval of the next segment */
  double misses; /* sum of squares of the angles to tangents that were measured,
                  * in standard deviations */
  double uncertain; /* of their root: the largest */
  size_t measured;  /* so many */
};

/* ph_check_first, ph_check_last: segments of interval i. */
static inline size_t ph_check_last(const struct ph_check_data *data, size_t i) {
  return data->last ? data->last[i] : i;
}
static inline size_t ph_check_first(const struct ph_check_data *data,
                                    size_t i) {
  return i > 0 ? ph_check_last(data, i - 1) + 1 : 0;
}

/* ph_check_interval: the interval that segment k is of. */
size_t ph_check_interval(const struct ph_check_data *data, size_t k);

/* ph_check_field: a field of the problem, or NULL. */
static inline const struct ph_value *ph_check_field(const struct ph_check *v,
                                                    enum ph_field_id id) {
  const struct ph_value *value = &v->problem->field[id];
  return value->kind == PH_ABSENT ? NULL : value;
}

/* ph_check_is_word: whether a field is a word. */
static inline bool ph_check_is_word(const struct ph_check *v,
                                    enum ph_field_id id, const char *word) {
  return ph_value_is(&v->problem->field[id], word);
}

/*
 * ph_check_data_of: the intervals of the data.
 *
 * ret  false where the curve has other ones, which is noted, and where there
 *      was no memory, which v->diag tells (*status)
 */
bool ph_check_data_of(struct ph_check *v, struct ph_check_data *data,
                      enum ph_status *status);

/* ph_check_index: of datum j in arrays, after the last one the first again. */
static inline size_t ph_check_index(const struct ph_check *v,
                                    const struct ph_check_data *data,
                                    size_t j) {
  return v->curve->closed && j == data->n ? 0 : j;
}

/* ph_check_datum: a point of the data at unit scale, after the last one the
 * first again; those of a sphere, x[], are brought onto it.
 * out  off  by how much of the radius they were off; else 0 */
ph_vec3 ph_check_datum_on_sphere(const struct ph_check *v,
                                 const struct ph_check_data *data,
                                 const double *x, double *off);
static inline ph_vec3 ph_check_datum(const struct ph_check *v,
                                     const struct ph_check_data *data, size_t j,
                                     double *off) {
  const struct ph_value *points = data->points;
  const double *x = points->v + points->dimension * ph_check_index(v, data, j);
  *off = 0;
  return v->kind->sphere ? ph_check_datum_on_sphere(v, data, x, off)
                         : ph_check_vector(v, x, points->dimension);
}

/* ph_check_direction: the unit vector of one of any size. */
ph_vec3 ph_check_direction(const double *x, size_t dimension);

/* ph_check_heading: the direction of a segment at its start (end = 0) or its
 * end (1) against a unit vector, the error in a unit of 1 or more; where
 * rounding leaves it none, nothing is said. */
void ph_check_heading(struct ph_check *v, enum ph_check_id check,
                      const struct ph_check_segment *s, size_t end,
                      ph_vec3 wanted, double unit);

/* ph_check_derivative: r' by u there against a factor times a vector
 * at unit scale, relative to the latter and the mean length of a segment.
 * in  knots  whether the factor is the spacing of knots, which are rounded */
void ph_check_derivative(struct ph_check *v, enum ph_check_id check,
                         const struct ph_check_segment *s, size_t end,
                         double factor, ph_vec3 wanted, bool knots);

#endif
