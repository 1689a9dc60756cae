/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The fields of the sphere problem (see sphere.h).
 *
 * Points are taken relative to the center and divided by their distance from
 * it, at a scale of each point's own: neither 1e300 nor 1e-300 is special.
 */
#include "solve/sphere/sphere.h"

#include "base/sum.h"
#include "kernel/degree.h"
#include "kernel/pi.h"
#include "kernel/pow2.h"
#include "kernel/s2.h"
#include "solve/common/fields.h"

#include <float.h>
#include <string.h>

/* Angles between neighbours: below, their great circle is lost in the rounding
 * of the coordinates; above pi less this, it is as good as any other. */
static const double COINCIDENT = 1e-10, OPPOSITE = 1e-6;

/* A point that was computed on the sphere, and printed with all its digits, is
 * moved by rounding only, and that is not worth a warning; one that was printed
 * with six is moved by 1e-7 or more. */
static const double MOVED = 1e-12;

static const double TOLERANCE = 1e-3, NU_MAX = 1e12;

/* The smallest radius: curvatures are in range. */
static const double RADIUS_MIN = 1e-300;

/* Spacings of knots: their cubes must not leave the range of a double, and they
 * must not differ by more than this. */
static const double SPACING_MAX = 1e50, SPACINGS = 1e-12;

/* The part of a direction that is along the sphere. */
static const double NOTHING_LEFT = 1e-12;

struct reading {
  const struct ph_problem *problem;
  struct ph_sphere_data *data;
  struct ph_arena *arena;
  struct ph_diag *diag;
  const struct ph_value *points; /* points or lonlat */
  const char *name;              /* of these */
  double tolerance;
};

static const struct ph_value *field(const struct reading *r,
                                    enum ph_field_id id) {
  return &r->problem->field[id];
}

/* ---- the sphere ---------------------------------------------------------- */

static enum ph_status read_sphere(struct reading *r) {
  const struct ph_value *center = field(r, PH_F_CENTER);
  const struct ph_value *radius = field(r, PH_F_RADIUS);
  const struct ph_value *tolerance = field(r, PH_F_RADIUS_TOLERANCE);
  struct ph_sphere_data *d = r->data;
  if (center->kind != PH_ABSENT && center->n != 3) {
    return ph_fail(r->diag, PH_E_BAD_SHAPE, "center",
                   "must have 3 numbers, found %zu", center->n);
  }
  if (center->kind != PH_ABSENT) {
    memcpy(d->center, center->v, sizeof d->center);
  }
  d->radius = radius->kind == PH_ABSENT ? 1 : radius->number;
  if (!(d->radius >= RADIUS_MIN && isfinite(d->radius))) {
    return ph_fail(r->diag, PH_E_BAD_VALUE, "radius",
                   "must be at least %g, found %.17g", RADIUS_MIN, d->radius);
  }
  r->tolerance = tolerance->kind == PH_ABSENT ? TOLERANCE : tolerance->number;
  if (!(r->tolerance > 0 && r->tolerance < 1)) {
    return ph_fail(r->diag, PH_E_BAD_VALUE, "radius_tolerance",
                   "must be greater than 0 and less than 1, found %.17g",
                   r->tolerance);
  }
  return PH_OK;
}

/* ---- points -------------------------------------------------------------- */

static enum ph_status find_points(struct reading *r) {
  bool points = ph_fields_given(r->problem, PH_F_POINTS);
  if (points && ph_fields_given(r->problem, PH_F_LONLAT)) {
    return ph_fail(r->diag, PH_E_BAD_VALUE, "lonlat",
                   "excludes points: give one of them");
  }
  if (!points && !ph_fields_given(r->problem, PH_F_LONLAT)) {
    return ph_fail(r->diag, PH_E_MISSING_FIELD, "points",
                   "or lonlat must be given");
  }
  r->points = field(r, points ? PH_F_POINTS : PH_F_LONLAT);
  r->name = points ? "points" : "lonlat";
  if (r->points->dimension != (points ? 3u : 2u)) {
    return ph_fail(r->diag, PH_E_BAD_SHAPE, r->name,
                   "must have %d numbers for each point, found %zu",
                   points ? 3 : 2, r->points->dimension);
  }
  return PH_OK;
}

/* The scale at which the largest of a point, the center and the radius is near
 * 1. */
static struct ph_pow2 scale_of(const double *v, const struct ph_sphere_data *d,
                               int *exponent) {
  double most = fmax(ph_fields_largest(v, 3), ph_fields_largest(d->center, 3));
  *exponent = ph_pow2_exponent(fmax(most, d->radius));
  return ph_pow2_of(-*exponent);
}

/* Whether a point far from the unit sphere may be longitude, latitude and an
 * elevation. */
static bool like_degrees(const double *v, const struct ph_sphere_data *d) {
  return !(d->radius < 1) && !(d->radius > 1) && fabs(v[0]) <= 360 &&
         fabs(v[1]) <= 90 && hypot(v[0], v[1]) > 2;
}

static enum ph_status read_point(struct reading *r, size_t i) {
  struct ph_sphere_data *d = r->data;
  const double *v = r->points->v + 3 * i, *c = d->center;
  int exponent;
  struct ph_pow2 s = scale_of(v, d, &exponent);
  ph_vec3 u = ph_vec3_of(ph_pow2_apply(s, v[0]) - ph_pow2_apply(s, c[0]),
                         ph_pow2_apply(s, v[1]) - ph_pow2_apply(s, c[1]),
                         ph_pow2_apply(s, v[2]) - ph_pow2_apply(s, c[2]));
  double size = hypot(hypot(u.x, u.y), u.z),
         radius = ph_pow2_apply(s, d->radius);
  double off = fabs(size - radius) / radius;
  if (!(off <= r->tolerance)) {
    return ph_fail_at(r->diag, PH_E_NOT_ON_SPHERE, r->name, i,
                      "is %.10g from the center, and the radius is %.10g: "
                      "they may differ by radius_tolerance, %g of the radius%s",
                      ph_pow2_apply(ph_pow2_of(exponent), size), d->radius,
                      r->tolerance,
                      like_degrees(v, d) ? "; degrees are lonlat, in tables "
                                           "columns lon and lat"
                                         : "");
  }
  if (off > d->moved) {
    d->moved = off;
    d->moved_at = i;
  }
  d->rounding = fmax(d->rounding, 4 * DBL_EPSILON / radius);
  d->p[i] = ph_fields_unit(u);
  return PH_OK;
}

/* The failure of one of the two numbers of a point. */
static enum ph_status bad_degrees(struct reading *r, size_t i, size_t which,
                                  double range) {
  enum ph_status status =
      ph_fail_at(r->diag, PH_E_BAD_VALUE, r->name, i,
                 "must be between -%g and %g degrees, "
                 "found %.17g%s",
                 range, range, r->points->v[2 * i + which],
                 which == 1 ? "; the longitude comes first" : "");
  strcat(r->diag->field, which == 0 ? "[0]" : "[1]");
  return status;
}

static enum ph_status read_lonlat(struct reading *r, size_t i) {
  const double *v = r->points->v + 2 * i;
  if (!(fabs(v[0]) <= 360)) {
    return bad_degrees(r, i, 0, 360);
  }
  if (!(fabs(v[1]) <= 90)) {
    return bad_degrees(r, i, 1, 90);
  }
  r->data->p[i] = ph_degree_to_unit(v[0], v[1]);
  return PH_OK;
}

/* Reads the points, and counts them. */
static enum ph_status read_points(struct reading *r) {
  struct ph_sphere_data *d = r->data;
  size_t n = r->points->n;
  d->p = ph_arena_array(r->arena, n, sizeof *d->p);
  if (!d->p) {
    return ph_fail_memory(r->diag);
  }
  d->rounding = 4 * DBL_EPSILON;
  for (size_t i = 0; i < n; i++) {
    enum ph_status status = ph_fields_given(r->problem, PH_F_POINTS)
                                ? read_point(r, i)
                                : read_lonlat(r, i);
    if (status != PH_OK) {
      return status;
    }
  }
  d->tell_moved = d->moved > fmax(MOVED, 4 * d->rounding);
  if (d->closed && n > 1 && ph_s2_angle(d->p[0], d->p[n - 1]) < COINCIDENT) {
    n--;
  }
  if (n < (d->closed ? 3u : 2u)) {
    return ph_fail(r->diag, PH_E_TOO_FEW_POINTS, r->name,
                   d->closed ? "must be at least 3 different points for a "
                               "closed curve, found %zu"
                             : "must be at least 2, found %zu",
                   n);
  }
  d->n = n;
  d->m = d->closed ? n : n - 1;
  return PH_OK;
}

static enum ph_status allocate(struct reading *r) {
  struct ph_sphere_data *d = r->data;
  d->e = ph_arena_array(r->arena, d->n, sizeof *d->e);
  d->theta = ph_arena_array(r->arena, d->m, sizeof *d->theta);
  d->h = ph_arena_array(r->arena, d->m, sizeof *d->h);
  d->nu = ph_arena_array(r->arena, d->n, sizeof *d->nu);
  d->knots = ph_arena_array(r->arena, d->m + 1, sizeof *d->knots);
  return d->e && d->theta && d->h && d->nu && d->knots
             ? PH_OK
             : ph_fail_memory(r->diag);
}

static enum ph_status measure(struct reading *r) {
  struct ph_sphere_data *d = r->data;
  for (size_t i = 0; i < d->n; i++) {
    d->e[i] = ph_vec3_any_normal(d->p[i]);
  }
  for (size_t k = 0; k < d->m; k++) {
    size_t to = ph_sphere_next(d, k);
    d->theta[k] = ph_s2_angle(d->p[k], d->p[to]);
    if (!(d->theta[k] >= COINCIDENT)) {
      return ph_fail_at(r->diag, PH_E_COINCIDENT_POINTS, r->name, to,
                        "coincides with %s[%zu]: they are less than %g rad "
                        "apart; --merge=D joins points nearer than D",
                        r->name, k, COINCIDENT);
    }
    if (!(d->theta[k] <= PH_PI - OPPOSITE)) {
      return ph_fail_at(r->diag, PH_E_ANTIPODAL_POINTS, r->name, to,
                        "is opposite to %s[%zu] on the sphere, to %g rad: "
                        "every direction leads from one to the other",
                        r->name, k, OPPOSITE);
    }
  }
  return PH_OK;
}

/* ---- knots and tensions -------------------------------------------------- */

static enum ph_status read_knot_numbers(struct reading *r) {
  struct ph_sphere_data *d = r->data;
  const struct ph_value *knots = field(r, PH_F_KNOTS);
  enum ph_status status =
      ph_fields_knots(knots, d->m, d->closed, d->h, r->diag);
  double most = ph_fields_largest(d->h, status == PH_OK ? d->m : 0);
  if (status != PH_OK) {
    return status;
  }
  for (size_t k = 0; k < d->m; k++) {
    if (!(d->h[k] < SPACING_MAX && d->h[k] > 1 / SPACING_MAX &&
          d->h[k] > SPACINGS * most)) {
      return ph_fail_at(r->diag, PH_E_TOO_LARGE, "knots", k + 1,
                        "must be after the knot before by more than %g of the "
                        "largest spacing, and by %g to %g",
                        SPACINGS, 1 / SPACING_MAX, SPACING_MAX);
    }
  }
  memcpy(d->knots, knots->v, (d->m + 1) * sizeof *d->knots);
  return PH_OK;
}

static enum ph_status read_knots(struct reading *r) {
  struct ph_sphere_data *d = r->data;
  bool uniform = ph_value_is(field(r, PH_F_KNOTS), "uniform");
  double mean = ph_fields_sum(d->theta, d->m) / (double)d->m;
  if (field(r, PH_F_KNOTS)->kind == PH_NUMBERS) {
    return read_knot_numbers(r);
  }
  for (size_t k = 0; k < d->m; k++) {
    d->h[k] = uniform ? mean : d->theta[k];
  }
  ph_fields_sums(d->h, d->m, d->knots);
  return PH_OK;
}

/* One number is for the nodes where a tension has an effect. */
static enum ph_status set_tensions(struct reading *r, double nu) {
  struct ph_sphere_data *d = r->data;
  if (!(nu >= 0 && nu <= NU_MAX)) {
    return ph_fail(r->diag, PH_E_BAD_VALUE, "tension",
                   "must be between 0 and %g, found %.17g", NU_MAX, nu);
  }
  for (size_t i = 0; i < d->n; i++) {
    d->nu[i] = ph_sphere_is_end(d, i) ? 0 : nu;
  }
  return PH_OK;
}

static enum ph_status read_tensions(struct reading *r) {
  struct ph_sphere_data *d = r->data;
  const struct ph_value *tension = field(r, PH_F_TENSION);
  if (tension->kind != PH_NUMBERS) {
    return set_tensions(r, tension->kind == PH_ABSENT ? 0 : tension->number);
  }
  if (tension->n != d->n && tension->n != r->points->n) {
    return ph_fail(r->diag, PH_E_BAD_SHAPE, "tension",
                   "must have %zu numbers, one for each point, found %zu",
                   r->points->n, tension->n);
  }
  for (size_t i = 0; i < tension->n; i++) {
    double nu = tension->v[i];
    if (!(nu >= 0 && nu <= NU_MAX)) {
      return ph_fail_at(r->diag, PH_E_BAD_VALUE, "tension", i,
                        "must be between 0 and %g, found %.17g", NU_MAX, nu);
    }
    if (i == d->n && !(nu >= tension->v[0] && nu <= tension->v[0])) {
      return ph_fail_at(r->diag, PH_E_BAD_VALUE, "tension", i,
                        "must equal tension[0], as the point does");
    }
  }
  memcpy(d->nu, tension->v, d->n * sizeof *d->nu);
  return PH_OK;
}

/* ---- ends ---------------------------------------------------------------- */

static enum ph_status check_ends(struct reading *r) {
  const struct ph_value *ends = field(r, PH_F_ENDS);
  const struct ph_value *tangents = field(r, PH_F_END_TANGENTS);
  bool given = tangents->kind != PH_ABSENT;
  if (r->data->closed && (given || ends->kind != PH_ABSENT)) {
    return ph_fail(r->diag, PH_E_BAD_VALUE, given ? "end_tangents" : "ends",
                   "is for open curves: a closed curve has no ends");
  }
  if (ph_value_is(ends, "clamped") && !given) {
    return ph_fail(r->diag, PH_E_MISSING_FIELD, "end_tangents",
                   "must be given with \"ends\":\"clamped\"");
  }
  if (given && ends->kind != PH_ABSENT && !ph_value_is(ends, "clamped")) {
    return ph_fail(r->diag, PH_E_BAD_VALUE, "end_tangents",
                   "excludes \"ends\":\"%s\"", ends->word);
  }
  if (given && (tangents->n != 2 || tangents->dimension != 3)) {
    return ph_fail(r->diag, PH_E_BAD_SHAPE, "end_tangents",
                   "must be two vectors of 3 numbers, found %zu of %zu",
                   tangents->n, tangents->dimension);
  }
  return PH_OK;
}

/* Of a direction, the part along the sphere; its speed is that of the great
 * circle to the next node. */
static enum ph_status read_end(struct reading *r, size_t side) {
  struct ph_sphere_data *d = r->data;
  const double *v = field(r, PH_F_END_TANGENTS)->v + 3 * side;
  size_t node = side == 0 ? 0 : d->n - 1, k = side == 0 ? 0 : d->m - 1;
  double most = ph_fields_largest(v, 3);
  ph_vec3 along;
  if (!(most > 0)) {
    return ph_fail_at(r->diag, PH_E_ZERO_TANGENT, "end_tangents", side,
                      "must not be zero");
  }
  along = ph_fields_unit(ph_vec3_get(v, 3));
  along = ph_vec3_normal(along, d->p[node]);
  if (!(ph_vec3_abs(along) > NOTHING_LEFT)) {
    return ph_fail_at(r->diag, PH_E_ZERO_TANGENT, "end_tangents", side,
                      "must not be at right angles to the sphere at %s[%zu]",
                      r->name, node);
  }
  /* again, as little may have been left */
  along = ph_vec3_normal(ph_vec3_unit(along), d->p[node]);
  d->end[side] =
      ph_vec3_scale(d->theta[k] / d->h[k] / ph_vec3_abs(along), along);
  return PH_OK;
}

static enum ph_status read_ends(struct reading *r) {
  const struct ph_value *ends = field(r, PH_F_ENDS);
  enum ph_status status;
  if (field(r, PH_F_END_TANGENTS)->kind == PH_ABSENT) {
    r->data->ends =
        ph_value_is(ends, "rest") ? PH_SPHERE_REST : PH_SPHERE_NATURAL;
    return PH_OK;
  }
  r->data->ends = PH_SPHERE_CLAMPED;
  status = read_end(r, 0);
  return status == PH_OK ? read_end(r, 1) : status;
}

enum ph_status ph_sphere_data_read(const struct ph_problem *problem,
                                   struct ph_arena *arena,
                                   struct ph_sphere_data *d,
                                   struct ph_diag *diag) {
  static enum ph_status (*const steps[])(struct reading *) = {
      find_points, check_ends, read_sphere,   read_points, allocate,
      measure,     read_knots, read_tensions, read_ends};
  struct reading r = {
      .problem = problem, .data = d, .arena = arena, .diag = diag};
  enum ph_status status = PH_OK;
  *d = (struct ph_sphere_data){.closed = problem->field[PH_F_CLOSED].flag};
  for (size_t i = 0; status == PH_OK && i < sizeof steps / sizeof *steps; i++) {
    status = steps[i](&r);
  }
  return status;
}
