/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Points that are joined to their neighbours (see merge.h). */
#include "curve/merge.h"

#include "kernel/degree.h"
#include "kernel/s2.h"

#include <math.h>
#include <string.h>

/* What is given at joined points is the same to this, relative to the larger.
 */
static const double SAME = 0.1;

/* A last point of closed data repeats the first one to this, of the largest
 * coordinate or of the radius: it is expected, and not told. */
static const double REPEATED = 1e-14;

/* A merge on its way. */
struct task {
  struct ph_merge *merge;
  struct ph_problem *problem;
  struct ph_arena *arena;
  struct ph_diag *diag;
  const struct ph_value *points;
  bool closed;
  bool sphere;
  double size; /* of the points: the largest coordinate, or the radius */
  double center[3];
  size_t *to, *kept, *interval; /* as of merge */
};

/* ---- distances ----------------------------------------------------------- */

static ph_vec3 vector_of(const struct ph_value *value, size_t i) {
  const double *v = value->v + value->dimension * i;
  return ph_vec3_of(v[0], v[1], value->dimension > 2 ? v[2] : 0);
}

/* |v| at any scale. */
static double size_of(ph_vec3 v) {
  return hypot(hypot(v.x, v.y), v.z);
}

static ph_vec3 unit_of(ph_vec3 v) {
  double size = size_of(v);
  return ph_vec3_of(v.x / size, v.y / size, v.z / size);
}

/* The direction of a point from the centre of the sphere. */
static ph_vec3 direction(const struct task *t, size_t i) {
  ph_vec3 p = vector_of(t->points, i);
  const double *c = t->center;
  return t->merge->points == PH_F_LONLAT
             ? ph_degree_to_unit(p.x, p.y)
             : unit_of(ph_vec3_of(p.x - c[0], p.y - c[1], p.z - c[2]));
}

static double apart(const struct task *t, size_t i, size_t k) {
  return t->sphere ? t->size * ph_s2_angle(direction(t, i), direction(t, k))
                   : size_of(ph_vec3_sub(vector_of(t->points, i),
                                         vector_of(t->points, k)));
}

/* Also false where the distance is not a number, which the method refuses. */
static bool near(const struct task *t, size_t i, size_t k) {
  return apart(t, i, k) < t->merge->distance;
}

/* ---- which points -------------------------------------------------------- */

static void choose(struct task *t) {
  size_t n = t->points->n, m = 1, *kept = t->kept;
  kept[0] = 0;
  for (size_t i = 1; i < n; i++) {
    if (!near(t, kept[m - 1], i)) {
      kept[m++] = i;
    }
  }
  if (t->closed) {
    while (m > 1 && near(t, kept[m - 1], 0)) {
      m--;
    }
  } else if (kept[m - 1] < n - 1) { /* what is near the last one goes */
    while (m > 1 && near(t, kept[m - 1], n - 1)) {
      m--;
    }
    if (m > 1 || !near(t, 0, n - 1)) {
      kept[m++] = n - 1;
    }
  }
  t->merge->kept_n = m;
}

/* The point that stays for each: the one before, or else the one after. */
static void assign(struct task *t) {
  const size_t n = t->points->n, m = t->merge->kept_n;
  for (size_t j = 0; j < m; j++) {
    size_t first = t->kept[j], end = j + 1 < m ? t->kept[j + 1] : n;
    size_t next = j + 1 < m ? end : 0;
    bool before = true;
    t->to[first] = first;
    for (size_t i = first + 1; i < end; i++) {
      before = before && near(t, first, i);
      t->to[i] = before ? first : next;
    }
  }
}

/* The longest interval between the points that stay; not the one from a last
 * point to the first that it is joined to, of which closed data may say
 * nothing.
 */
static void set_intervals(struct task *t) {
  const size_t n = t->points->n, m = t->merge->kept_n;
  for (size_t j = 0; j < m; j++) {
    size_t end = j + 1 < m ? t->kept[j + 1] : n;
    double most = -1;
    for (size_t i = t->kept[j]; i < end; i++) {
      bool closes = i == n - 1 && t->to[i] < i;
      double chord =
          end - t->kept[j] > 1 ? apart(t, i, i + 1 < n ? i + 1 : 0) : 0;
      if (chord > most && !closes) {
        most = chord;
        t->interval[j] = i;
      }
    }
  }
}

/* ---- fields -------------------------------------------------------------- */

static enum ph_status disagree(struct task *t, const char *name, size_t i) {
  size_t to = t->to[i];
  return ph_fail_at(t->diag, PH_E_BAD_VALUE, name, i,
                    "differs from %s[%zu] by more than a tenth, but merge "
                    "joins %s[%zu] to %s[%zu]",
                    name, to, ph_field_name(t->merge->points), i,
                    ph_field_name(t->merge->points), to);
}

/* Whether what is given at a point is what is given where it is joined to; of
 * tangents the lengths mean nothing. */
static bool agree(const struct task *t, const struct ph_field *row,
                  const struct ph_value *value, size_t i) {
  size_t to = t->to[i];
  ph_vec3 a, b;
  double size;
  if (to == i || i >= value->n) {
    return true;
  }
  if (value->kind == PH_NUMBERS) {
    size = fmax(fabs(value->v[i]), fabs(value->v[to]));
    return !(fabs(value->v[i] - value->v[to]) > SAME * size);
  }
  a = vector_of(value, i);
  b = vector_of(value, to);
  if (row->id == PH_F_TANGENTS) {
    a = unit_of(a);
    b = unit_of(b);
  }
  size = fmax(size_of(a), size_of(b));
  return !(size_of(ph_vec3_sub(a, b)) > SAME * size); /* NaN: of zero */
}

/* That a field has as many elements as there are points, or intervals, plus
 * `more`.  Closed data may have their last point once more. */
static enum ph_status check_shape(struct task *t, const char *name,
                                  const struct ph_value *value, size_t n,
                                  const char *what) {
  if (value->n == n || (t->closed && value->n + 1 == n)) {
    return PH_OK;
  }
  return ph_fail(t->diag, PH_E_BAD_SHAPE, name,
                 "must have %zu elements, one for each %s, before merge joins "
                 "points, found %zu",
                 n, what, value->n);
}

/* Puts m elements, of the given indices, in place of those of a field. */
static enum ph_status pick(struct task *t, struct ph_value *value,
                           const size_t *which, size_t m) {
  size_t d = value->dimension;
  double *v = ph_arena_array(t->arena, m, d * sizeof *v);
  if (!v) {
    return ph_fail_memory(t->diag);
  }
  while (m > 0 && which[m - 1] >= value->n) { /* it was left out as repeated */
    m--;
  }
  for (size_t j = 0; j < m; j++) {
    memcpy(v + d * j, value->v + d * which[j], d * sizeof *v);
  }
  value->v = v;
  value->n = m;
  return PH_OK;
}

static enum ph_status join_points(struct task *t, const struct ph_field *row,
                                  struct ph_value *value) {
  const char *name = ph_field_name(row->id);
  bool given = row->id != PH_F_POINTS && row->id != PH_F_LONLAT;
  enum ph_status status = check_shape(t, name, value, t->points->n, "point");
  for (size_t i = 0; status == PH_OK && given && i < value->n; i++) {
    if (!agree(t, row, value, i)) {
      status = disagree(t, name, i);
    }
  }
  return status == PH_OK ? pick(t, value, t->kept, t->merge->kept_n) : status;
}

/* Of closed data the last knot closes the period. */
static enum ph_status join_knots(struct task *t, struct ph_value *value) {
  size_t m = t->merge->kept_n, more = t->closed ? 1 : 0;
  double last = value->n > 0 ? value->v[value->n - 1] : 0, *v;
  enum ph_status status =
      check_shape(t, "knots", value, t->points->n + more, "point");
  if (status != PH_OK || !more) {
    return status == PH_OK ? pick(t, value, t->kept, m) : status;
  }
  v = ph_arena_array(t->arena, m + 1, sizeof *v);
  if (!v) {
    return ph_fail_memory(t->diag);
  }
  value->n--;
  status = pick(t, value, t->kept, m);
  if (status == PH_OK) {
    memcpy(v, value->v, value->n * sizeof *v);
    v[value->n++] = last;
    value->v = v;
  }
  return status;
}

static enum ph_status join_intervals(struct task *t, enum ph_field_id id,
                                     struct ph_value *value) {
  size_t n = t->points->n - (t->closed ? 0 : 1), given = value->n;
  size_t m = t->merge->kept_n - (t->closed ? 0 : 1);
  const double *was = value->v;
  enum ph_status status =
      check_shape(t, ph_field_name(id), value, n, "interval");
  if (status == PH_OK) {
    status = pick(t, value, t->interval, m);
  }
  for (size_t j = 0; status == PH_OK && id == PH_F_LENGTHS && j < value->n;
       j++) {
    size_t end = j + 1 < t->merge->kept_n ? t->kept[j + 1] : given;
    value->v[j] = 0;
    for (size_t i = t->kept[j]; i < end; i++) {
      value->v[j] += was[i];
    }
  }
  return status;
}

/* One field.  A pair of angles for all is no list of intervals. */
static enum ph_status join(struct task *t, const struct ph_field *row) {
  struct ph_value *value = &t->problem->field[row->id];
  bool vectors = row->kinds & PH_VECTORS;
  bool each =
      value->kind == PH_VECTORS || (value->kind == PH_NUMBERS && !vectors);
  if (!each) {
    return PH_OK;
  }
  if (row->id == PH_F_KNOTS) {
    return join_knots(t, value);
  }
  if (row->kinds & PH_DATUM) {
    return join_points(t, row, value);
  }
  return row->kinds & PH_SEGMENTS && !(vectors && value->n == 1)
             ? join_intervals(t, row->id, value)
             : PH_OK;
}

/* ---- the whole ----------------------------------------------------------- */

/* Where the points are, and how they are measured. */
static void read_points(struct task *t, const struct ph_schema *schema) {
  const struct ph_value *field = t->problem->field;
  t->merge->points =
      field[PH_F_POINTS].kind == PH_VECTORS ? PH_F_POINTS : PH_F_LONLAT;
  t->points = &field[t->merge->points];
  t->closed = field[PH_F_CLOSED].flag;
  t->sphere = ph_field_find(schema, "lonlat", strlen("lonlat")) != NULL;
  t->size =
      field[PH_F_RADIUS].kind == PH_NUMBER ? field[PH_F_RADIUS].number : 1;
  if (field[PH_F_CENTER].kind == PH_NUMBERS && field[PH_F_CENTER].n == 3) {
    memcpy(t->center, field[PH_F_CENTER].v, sizeof t->center);
  }
  for (size_t i = 0; !t->sphere && i < t->points->n; i++) {
    ph_vec3 p = vector_of(t->points, i);
    t->size =
        fmax(fmax(i > 0 ? t->size : 0, fabs(p.x)), fmax(fabs(p.y), fabs(p.z)));
  }
}

static enum ph_status allocate(struct task *t) {
  size_t n = t->points->n;
  t->to = ph_arena_array(t->arena, n, sizeof *t->to);
  t->kept = ph_arena_array(t->arena, n, sizeof *t->kept);
  t->interval = ph_arena_array(t->arena, n, sizeof *t->interval);
  t->merge->to = t->to;
  t->merge->kept = t->kept;
  t->merge->interval = t->interval;
  t->merge->n = n;
  return t->to && t->kept && t->interval ? PH_OK : ph_fail_memory(t->diag);
}

static enum ph_status list_gone(struct task *t) {
  struct ph_merge *merge = t->merge;
  size_t n = merge->n, *gone = ph_arena_array(t->arena, n, sizeof *gone);
  bool repeated = t->closed && merge->to[n - 1] == 0 &&
                  apart(t, 0, n - 1) <= REPEATED * t->size;
  if (!gone) {
    return ph_fail_memory(t->diag);
  }
  for (size_t i = 0; i < n - repeated; i++) {
    if (merge->to[i] != i) {
      gone[merge->gone_n++] = i;
    }
  }
  merge->gone = gone;
  return PH_OK;
}

enum ph_status ph_merge(const struct ph_schema *schema, struct ph_arena *arena,
                        struct ph_problem *problem, struct ph_merge *merge,
                        struct ph_diag *diag) {
  const struct ph_value *distance = &problem->field[PH_F_MERGE];
  struct task t = {
      .merge = merge, .problem = problem, .arena = arena, .diag = diag};
  struct ph_value points;
  enum ph_status status;
  *merge = (struct ph_merge){0};
  if (distance->kind == PH_ABSENT) {
    return PH_OK;
  }
  merge->distance = distance->number;
  if (!(merge->distance > 0)) {
    return ph_fail(diag, PH_E_BAD_VALUE, "merge",
                   "must be greater than 0, found %.17g", merge->distance);
  }
  read_points(&t, schema);
  if (t.points->kind != PH_VECTORS) {
    return ph_fail(diag, PH_E_BAD_VALUE, "merge", "is for points");
  }
  points = *t.points; /* as they were: the field is replaced */
  t.points = &points;
  status = points.n > 0 ? allocate(&t) : PH_OK;
  if (status != PH_OK || points.n == 0) {
    return status;
  }
  choose(&t);
  if (merge->kept_n == points.n) {
    return PH_OK;
  }
  assign(&t);
  set_intervals(&t);
  for (size_t i = 0; status == PH_OK && i < schema->fields_n; i++) {
    status = join(&t, &schema->fields[i]);
  }
  if (status == PH_OK) {
    status = list_gone(&t);
  }
  merge->schema = status == PH_OK ? schema : NULL;
  return status;
}
