/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The pose of arc-length data (see arclength_data.h). */
#include "solve/arclength/data.h"

#include <math.h>

/* Sequences that differ by less are the same backwards, data that turn by less
 * have no sense of rotation. */
static const double EQUAL = 1e-9;

/* A direction within this of vertical has no left. */
static const double VERTICAL = 1e-8;

/* The vectors that the pose is about: steps, or what is given. */
static ph_vec3 *vectors(const struct ph_arc_data *d, size_t *n) {
  *n = d->step ? d->n : d->n + 1;
  return d->step ? d->step : d->given;
}

/* ---- reversal ------------------------------------------------------------ */

/* Whether v backwards is smaller (-1), larger (1) or the same. */
static int compare_backwards(const double *v, size_t n) {
  for (size_t i = 0; v && i < n; i++) {
    double difference = v[n - 1 - i] - v[i];
    if (fabs(difference) > EQUAL * (fabs(v[i]) + fabs(v[n - 1 - i]))) {
      return difference < 0 ? -1 : 1;
    }
  }
  return 0;
}

/* The same of the lengths of vectors, and of products of neighbours. */
static int compare_vectors_backwards(const ph_vec3 *v, size_t n) {
  for (size_t i = 0; i < n; i++) {
    double a = ph_vec3_abs(v[i]), b = ph_vec3_abs(v[n - 1 - i]);
    if (fabs(b - a) > EQUAL * (a + b)) {
      return b < a ? -1 : 1;
    }
  }
  for (size_t i = 0; i + 1 < n; i++) {
    size_t j = n - 2 - i;
    double a = ph_vec3_dot(v[i], v[i + 1]), b = ph_vec3_dot(v[j], v[j + 1]);
    double size = ph_vec3_abs(v[i]) * ph_vec3_abs(v[i + 1]);
    if (fabs(b - a) > EQUAL * size) {
      return b < a ? -1 : 1;
    }
  }
  return 0;
}

static void reverse_numbers(double *v, size_t n) {
  for (size_t i = 0; v && i < n / 2; i++) {
    double first = v[i];
    v[i] = v[n - 1 - i];
    v[n - 1 - i] = first;
  }
}

static void reverse_order(ph_vec3 *v, size_t n) {
  for (size_t i = 0; i < n / 2; i++) {
    ph_vec3 first = v[i];
    v[i] = v[n - 1 - i];
    v[n - 1 - i] = first;
  }
}

/* A curve that is gone along backwards: the order and the vectors. */
static void reverse_vectors(ph_vec3 *v, size_t n) {
  reverse_order(v, n);
  for (size_t i = 0; i < n; i++) {
    v[i] = ph_vec3_scale(-1, v[i]);
  }
}

static void set_sense(struct ph_arc_data *d) {
  size_t n;
  ph_vec3 *v = vectors(d, &n);
  int order = compare_backwards(d->length, d->n);
  order = order ? order : compare_backwards(d->h, d->n);
  order = order ? order : compare_vectors_backwards(v, n);
  d->reversed = order < 0;
}

/* ---- closed data -------------------------------------------------------- */

/* The products of step i with its neighbours. */
static double turning(const struct ph_arc_data *d, size_t i) {
  size_t n = d->n;
  ph_vec3 sum = ph_vec3_add(d->step[(i + 1) % n], d->step[(i + n - 1) % n]);
  return ph_vec3_dot(d->step[i], sum);
}

/* Which of intervals i and j is the longer: by length, chord, turning. */
static int compare_intervals(const struct ph_arc_data *d, size_t i, size_t j) {
  const double by[3][2] = {
      {d->length ? d->length[i] : 0, d->length ? d->length[j] : 0},
      {d->chord[i], d->chord[j]},
      {turning(d, i), turning(d, j)}};
  for (size_t k = 0; k < 3; k++) {
    double difference = by[k][0] - by[k][1];
    if (fabs(difference) > EQUAL * (fabs(by[k][0]) + fabs(by[k][1]))) {
      return difference < 0 ? -1 : 1;
    }
  }
  return 0;
}

/* The longest interval is the first, and from it the sense is that of the
 * longer intervals. */
static void set_first(struct ph_arc_data *d) {
  size_t n = d->n, longest = 0;
  int order = 0;
  for (size_t i = 1; i < n; i++) {
    if (compare_intervals(d, i, longest) > 0) {
      longest = i;
    }
  }
  for (size_t k = 1; k < n && order == 0; k++) {
    order = compare_intervals(d, (longest + k) % n, (longest + n - k) % n);
  }
  d->reversed = order < 0;
  d->first = d->reversed ? (longest + 1) % n : longest;
}

/* Begins with interval `first`: three reversals. */
static void shift_numbers(double *v, size_t n, size_t first) {
  reverse_numbers(v, first);
  reverse_numbers(v ? v + first : NULL, n - first);
  reverse_numbers(v, n);
}

static void shift(struct ph_arc_data *d) {
  shift_numbers(d->length, d->n, d->first);
  shift_numbers(d->h, d->n, d->first);
  shift_numbers(d->chord, d->n, d->first);
  reverse_order(d->step, d->first);
  reverse_order(d->step + d->first, d->n - d->first);
  reverse_order(d->step, d->n);
}

/* Puts the sequence into its order. */
static void set_order(struct ph_arc_data *d) {
  size_t n;
  ph_vec3 *v = vectors(d, &n);
  if (d->closed) {
    set_first(d);
    shift(d);
  } else {
    set_sense(d);
  }
  if (d->reversed) {
    reverse_numbers(d->length, d->n);
    reverse_numbers(d->h, d->n);
    reverse_numbers(d->chord, d->n);
    reverse_vectors(v, n);
  }
}

/* ---- frame --------------------------------------------------------------- */

/* The first vector that leaves the line of u by at least half as much as the
 * one that leaves it most; NULL: none leaves it. */
static const ph_vec3 *second_vector(const struct ph_arc_data *d, ph_vec3 u) {
  size_t n;
  const ph_vec3 *v = vectors(d, &n);
  double most = 0;
  for (size_t i = 0; i < n; i++) {
    double away = ph_vec3_abs(ph_vec3_normal(v[i], u));
    most = away > most ? away : most;
  }
  for (size_t i = 0; most > d->rounding && i < n; i++) {
    if (ph_vec3_abs(ph_vec3_normal(v[i], u)) >= most / 2) {
      return &v[i];
    }
  }
  return NULL;
}

/* Data on a line: e3 as near to z as it can be. */
static ph_vec3 upright(ph_vec3 e1) {
  bool vertical = hypot(e1.x, e1.y) <= VERTICAL;
  ph_vec3 up = vertical ? ph_vec3_of(1, 0, 0) : ph_vec3_of(0, 0, 1);
  ph_vec3 e3 = ph_vec3_unit(ph_vec3_normal(up, e1));
  return ph_vec3_unit(ph_vec3_cross(e3, e1));
}

static double chirality(const ph_vec3 *v, size_t n) {
  double sum = 0;
  for (size_t i = 2; i < n; i++) {
    sum += ph_vec3_triple(v[i - 2], v[i - 1], v[i]);
  }
  return sum;
}

void ph_arc_data_pose(struct ph_arc_data *d) {
  size_t n;
  ph_vec3 *v = vectors(d, &n), e1, e2, e3;
  const ph_vec3 *second;
  double handed = 0;
  set_order(d);
  e1 = ph_vec3_unit(v[0]);
  second = second_vector(d, e1);
  e2 = second ? ph_vec3_unit(ph_vec3_normal(*second, e1)) : upright(e1);
  e3 = ph_vec3_unit(ph_vec3_cross(e1, e2));
  e2 = ph_vec3_cross(e3,
                     e1); /* where all hardly leave a line e2 is not normal */
  d->turn = ph_quat_of_frame(e1, e2, e3);
  d->plane = true;
  d->line = d->straight = !second;
  for (size_t i = 0; i < n; i++) {
    v[i] = ph_vec3_of(ph_vec3_dot(e1, v[i]), ph_vec3_dot(e2, v[i]),
                      ph_vec3_dot(e3, v[i]));
    d->plane = d->plane && fabs(v[i].z) <= d->rounding;
    d->straight = d->straight && v[i].x > 0;
  }
  for (size_t i = 0; i < n; i++) {
    v[i].z = d->plane ? 0 : v[i].z;
    v[i].y = d->line ? 0 : v[i].y;
  }
  handed = chirality(v, n);
  d->mirrored = handed < -EQUAL;
  for (size_t i = 0; d->mirrored && i < n; i++) {
    v[i].z = -v[i].z;
  }
}
