/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Data of spatial Hermite interpolation (see spatial.h).
 *
 * Where no magnitudes are given, lambda is the spacing of the knots [FAR15,
 * (61)], which by default is the chord: knots are not divided by their sum,
 * which would make the scheme depend on the length of the whole.
 */
#include "solve/spatial/spatial.h"

#include "kernel/pow2.h"
#include "solve/common/fields.h"

#include <float.h>
#include <math.h>
#include <string.h>

/* A derivative below this part of a chord beside it has no direction that
 * matters; nor has the chord beside one that is longer by its inverse. */
static const double STANDSTILL = 1e-14;

/* All data are in one plane where they are each within this part of the
 * flatness of a segment, so that what three of them span is within 2 of it. */
static const double ONE_PLANE = 2.0 / 3;

/* Directions within this of exactly opposite count as a reversal. */
static const double REVERSAL = 1e-12;

struct reading {
  const struct ph_problem *problem;
  struct ph_spatial_points *points;
  struct ph_arena *arena, *keep;
  struct ph_diag *diag;
};

static double largest_of(ph_vec3 v) {
  double x = fabs(v.x), y = fabs(v.y), z = fabs(v.z);
  double largest = x > y ? x : y;
  return largest > z ? largest : z;
}

static ph_vec3 point(const struct ph_spatial_points *p, size_t k) {
  return ph_vec3_get(p->points + p->dimension * (k < p->points_n ? k : 0),
                     p->dimension);
}

/* A power of two whose square brings x to [1/8, 1/2). */
static double root_for(double x) {
  int exponent = x > 0 ? -ph_pow2_exponent(x) - 2 : 0;
  return ldexp(1, (exponent - (exponent & 1)) / 2);
}

static ph_vec3 scaled(double root, ph_vec3 v) {
  return ph_vec3_scale(root, ph_vec3_scale(root, v));
}

/* ---- points --------------------------------------------------------- */

/* The chord of segment k, at a scale where its length neither overflows nor
 * underflows. */
static ph_vec3 chord(const struct ph_spatial_points *p, size_t k,
                     double *root) {
  ph_vec3 difference = ph_vec3_sub(point(p, k + 1), point(p, k));
  *root = root_for(largest_of(difference));
  return scaled(*root, difference);
}

static enum ph_status check_chords(struct reading *r) {
  const struct ph_spatial_points *p = r->points;
  for (size_t k = 0; k < p->n; k++) {
    size_t to = k + 1 < p->points_n ? k + 1 : 0;
    ph_vec3 a = point(p, k), b = point(p, to);
    double size = fmax(largest_of(a), largest_of(b));
    double away = largest_of(ph_vec3_sub(b, a));
    if (!(away > 4 * DBL_EPSILON * size)) {
      return ph_fields_coincide(r->diag, "points", k, to);
    }
    if (!isfinite(away)) {
      return ph_fail_at(r->diag, PH_E_TOO_LARGE, "points", to,
                        "differs from points[%zu] by more than a double can "
                        "hold",
                        k);
    }
  }
  return PH_OK;
}

/* ---- tangents and derivatives --------------------------------------- */

/* Divides vectors by their lengths. */
static enum ph_status set_vectors(struct reading *r, enum ph_field_id id) {
  struct ph_spatial_points *p = r->points;
  enum ph_status status =
      ph_fields_vectors(r->problem, id, p->points_n, r->diag);
  if (status != PH_OK) {
    return status;
  }
  if (id == PH_F_DERIVATIVES) {
    p->speeds = ph_arena_array(r->arena, p->points_n, sizeof *p->speeds);
    if (!p->speeds) {
      return ph_fail_memory(r->diag);
    }
  }
  for (size_t k = 0; k < p->points_n; k++) {
    ph_vec3 v = ph_fields_vector(&r->problem->field[id], k);
    double root = root_for(largest_of(v)), size;
    v = scaled(root, v);
    size = ph_vec3_abs(v);
    p->tangents[k] = ph_vec3_scale(1 / size, v);
    if (p->speeds) {
      p->speeds[k] = size / root / root;
    }
  }
  return PH_OK;
}

static enum ph_status set_tangents(struct reading *r) {
  struct ph_spatial_points *p = r->points;
  bool tangents = ph_fields_given(r->problem, PH_F_TANGENTS);
  p->derivatives = ph_fields_given(r->problem, PH_F_DERIVATIVES);
  if (tangents && p->derivatives) {
    return ph_fail(r->diag, PH_E_BAD_VALUE, "tangents",
                   "excludes derivatives: give one of them");
  }
  p->tangents = ph_arena_array(r->arena, p->points_n, sizeof *p->tangents);
  if (!p->tangents) {
    return ph_fail_memory(r->diag);
  }
  p->estimated = !tangents && !p->derivatives;
  if (!p->estimated) {
    return set_vectors(r, tangents ? PH_F_TANGENTS : PH_F_DERIVATIVES);
  }
  ph_spatial_tangents(p->points, p->points_n, p->dimension, p->closed,
                      p->tangents);
  return PH_OK;
}

/* ---- knots, tensions, alpha ----------------------------------------- */

static enum ph_status set_knots(struct reading *r) {
  const struct ph_value *knots = &r->problem->field[PH_F_KNOTS];
  struct ph_spatial_points *p = r->points;
  enum ph_status status;
  if (knots->kind == PH_NUMBERS) {
    p->lambda = ph_arena_array(r->arena, p->n, sizeof *p->lambda);
    if (!p->lambda) {
      return ph_fail_memory(r->diag);
    }
    status = ph_fields_knots(knots, p->n, p->closed, p->lambda, r->diag);
    if (status == PH_OK) {
      memcpy(p->knots, knots->v, (p->n + 1) * sizeof *p->knots);
    }
    return status;
  }
  for (size_t k = 0; k < p->n; k++) {
    double root;
    ph_vec3 c = chord(p, k, &root);
    p->knots[k + 1] = ph_vec3_abs(c) / root / root;
  }
  ph_fields_sums(p->knots + 1, p->n, p->knots);
  for (size_t k = 0; k < p->n; k++) {
    if (p->knots[k + 1] <= p->knots[k]) {
      return ph_fail_at(
          r->diag, PH_E_COINCIDENT_POINTS, "points",
          k + 1 < p->points_n ? k + 1 : 0,
          "is so near to points[%zu] that their chordal knots "
          "are the same; \"knots\" can be given, and --merge=D joins "
          "points nearer than D",
          k);
    }
  }
  return isfinite(p->knots[p->n]) ? PH_OK
                                  : ph_fail(r->diag, PH_E_TOO_LARGE, "knots",
                                            "span more than a double can hold");
}

static enum ph_status set_planarity(struct reading *r) {
  const struct ph_value *planarity = &r->problem->field[PH_F_PLANARITY];
  double x = planarity->kind == PH_NUMBER ? planarity->number : PH_PLANARITY;
  r->points->planarity = x;
  return x >= 0 && x < 1
             ? PH_OK
             : ph_fail(r->diag, PH_E_BAD_VALUE, "planarity",
                       "must be at least 0 and below 1, found %.17g", x);
}

static enum ph_status set_tension(struct reading *r) {
  const struct ph_value *tension = &r->problem->field[PH_F_TENSION];
  struct ph_value one = {.kind = PH_NUMBER, .number = 1};
  const bool all = tension->kind == PH_ABSENT || tension->kind == PH_NUMBER;
  struct ph_spatial_points *p = r->points;
  if (!all) {
    p->tension = ph_arena_array(r->arena, p->n, sizeof *p->tension);
    if (!p->tension) {
      return ph_fail_memory(r->diag);
    }
  }
  return ph_fields_each(tension->kind == PH_ABSENT ? &one : tension, "tension",
                        all ? 1 : p->n, HUGE_VAL, "greater than 0",
                        all ? &p->same : p->tension, r->diag);
}

static enum ph_status set_alpha(struct reading *r) {
  const struct ph_value *alpha = &r->problem->field[PH_F_ALPHA];
  struct ph_spatial_points *p = r->points;
  if (alpha->kind == PH_ABSENT) {
    return PH_OK;
  }
  if (!p->atph) {
    return ph_fail(r->diag, PH_E_BAD_VALUE, "alpha",
                   "is for \"basis\":\"atph\"");
  }
  p->alpha = ph_arena_array(r->arena, p->n, sizeof *p->alpha);
  return p->alpha ? ph_fields_angles(alpha, p->n, p->alpha, r->diag)
                  : ph_fail_memory(r->diag);
}

double ph_spatial_segment(const struct ph_spatial_points *p, size_t k,
                          double tension, struct ph_spatial_data *data) {
  size_t to = k + 1 < p->points_n ? k + 1 : 0;
  double ni, nf, root;
  double size = fmax(largest_of(point(p, k)), largest_of(point(p, to)));
  data->dp = chord(p, k, &root);
  if (p->speeds || p->lambda) {
    ni = p->speeds ? p->speeds[k] : p->lambda[k];
    nf = p->speeds ? p->speeds[to] : p->lambda[k];
  } else {
    ni = nf = ph_vec3_abs(data->dp) / root / root;
  }
  data->noise = DBL_EPSILON * size * root * root;
  data->planarity = p->planarity;
  data->normal = p->normal;
  data->ti = p->tangents[k];
  data->tf = p->tangents[to];
  data->ni = ni * root * root * tension * tension;
  data->nf = nf * root * root * tension * tension;
  return root;
}

double ph_spatial_double(struct ph_spatial_data *data) {
  if (!(largest_of(data->dp) < 0.25)) {
    return 1;
  }
  data->dp = ph_vec3_scale(2, data->dp);
  data->noise *= 2;
  data->ni *= 2;
  data->nf *= 2;
  return 2;
}

/* The directions of a segment, and how far each may be out of the plane of all
 * data. */
struct directions {
  ph_vec3 v[3];
  double away;
};

static struct directions directions_of(const struct ph_spatial_points *p,
                                       size_t k) {
  struct ph_spatial_data data;
  struct directions d;
  double h;
  ph_spatial_segment(p, k, 1, &data);
  h = ph_vec3_abs(data.dp);
  d.v[0] = ph_vec3_scale(1 / h, data.dp);
  d.v[1] = data.ti;
  d.v[2] = data.tf;
  d.away = ONE_PLANE * ph_spatial_flatness(&data) / h;
  return d;
}

/* An order of vectors, so that what is chosen depends on no first one. */
static bool is_before(ph_vec3 a, ph_vec3 b) {
  return a.x < b.x ||
         (!(b.x < a.x) && (a.y < b.y || (!(b.y < a.y) && a.z < b.z)));
}

/* The last one of all directions. */
static ph_vec3 last_direction(const struct ph_spatial_points *p) {
  ph_vec3 last = directions_of(p, 0).v[0];
  for (size_t k = 0; k < p->n; k++) {
    struct directions d = directions_of(p, k);
    for (size_t i = 0; i < 3; i++) {
      last = is_before(last, d.v[i]) ? d.v[i] : last;
    }
  }
  return last;
}

/* The normal of a direction and of the one farthest from its line; 0 for data
 * on a line. */
static ph_vec3 normal_to(const struct ph_spatial_points *p, ph_vec3 direction) {
  ph_vec3 normal = {0, 0, 0};
  double largest = 0;
  for (size_t k = 0; k < p->n; k++) {
    struct directions d = directions_of(p, k);
    for (size_t i = 0; i < 3; i++) {
      ph_vec3 n = ph_vec3_cross(direction, d.v[i]);
      double size = ph_vec3_abs(n);
      if (size > fmax(largest, d.away) ||
          (size >= fmax(largest, d.away) && is_before(normal, n))) {
        largest = size;
        normal = n;
      }
    }
  }
  return largest > 0 ? ph_vec3_scale(1 / largest, normal) : normal;
}

/* By how much the data turn about a normal, altogether. */
static double turn_about(const struct ph_spatial_points *p, ph_vec3 normal) {
  double turn = 0;
  for (size_t k = 0; k < p->n; k++) {
    struct directions d = directions_of(p, k);
    ph_vec3 between = ph_vec3_sub(d.v[1], d.v[2]);
    turn += ph_vec3_dot(ph_vec3_cross(between, d.v[0]), normal);
  }
  return turn;
}

/* The plane that all data are in, if there is one; with the side from which
 * they turn to the left, which turns and is mirrored with them. */
static enum ph_status set_normal(struct reading *r) {
  struct ph_spatial_points *p = r->points;
  ph_vec3 normal;
  for (size_t k = 0; k < p->n; k++) { /* most data end here */
    struct directions d = directions_of(p, k);
    if (fabs(ph_vec3_triple(d.v[0], d.v[1], d.v[2])) > 3 * d.away) {
      return PH_OK;
    }
  }
  normal = normal_to(p, last_direction(p));
  for (size_t k = 0; k < p->n; k++) {
    struct directions d = directions_of(p, k);
    for (size_t i = 0; i < 3; i++) {
      if (fabs(ph_vec3_dot(normal, d.v[i])) > d.away) {
        return PH_OK;
      }
    }
  }
  p->normal = turn_about(p, normal) < 0 ? ph_vec3_scale(-1, normal) : normal;
  return PH_OK;
}

/* A speed beside a chord: -1 too small, 1 too large. */
static int judge(double speed, double chord) {
  return speed < STANDSTILL * chord      ? -1
         : !(STANDSTILL * speed < chord) ? 1
                                         : 0;
}

static enum ph_status wrong_speed(const struct ph_spatial_points *p, size_t k,
                                  const char *field, size_t index, int verdict,
                                  struct ph_diag *diag) {
  return ph_fail_at(
      diag, verdict < 0 ? PH_E_ZERO_TANGENT : PH_E_TOO_LARGE, field, index,
      "%stoo %s beside the chord between points[%zu] and "
      "points[%zu]",
      strcmp(field, "derivatives") == 0 ? "is " : "makes derivatives ",
      verdict < 0 ? "small" : "large", k, k + 1 < p->points_n ? k + 1 : 0);
}

/* Derivatives that are nothing beside their chord, or all but everything; they
 * are so by themselves, by the knots, or by the tension. */
static enum ph_status check_speeds(struct reading *r) {
  const struct ph_spatial_points *p = r->points;
  struct ph_diag *diag = r->diag;
  for (size_t k = 0; k < p->n; k++) {
    size_t to = k + 1 < p->points_n ? k + 1 : 0;
    struct ph_spatial_data data;
    const double tension = ph_spatial_tension_of(p, k);
    double chord, square = tension * tension;
    double alpha = p->speeds && p->alpha ? p->alpha[k] : 1;
    ph_spatial_segment(p, k, 1, &data);
    chord = ph_vec3_abs(data.dp);
    for (size_t i = 0; i < 2; i++) {
      double speed = i ? data.nf : data.ni;
      int given = judge(speed, chord), by_u = judge(speed * alpha, chord);
      int tense = judge(speed * alpha * square, chord);
      if (given != 0) {
        return p->speeds
                   ? wrong_speed(p, k, "derivatives", i ? to : k, given, diag)
                   : wrong_speed(p, k, "knots", k + 1, given, diag);
      }
      if (by_u != 0 || tense != 0) {
        return wrong_speed(p, k, by_u != 0 ? "alpha" : "tension", k,
                           by_u != 0 ? by_u : tense, diag);
      }
    }
  }
  return PH_OK;
}

static enum ph_status read_points(struct reading *r) {
  const struct ph_value *points = &r->problem->field[PH_F_POINTS];
  struct ph_spatial_points *p = r->points;
  enum ph_status status = ph_fields_segments(r->problem, &p->n, r->diag);
  if (status != PH_OK) {
    return status;
  }
  p->points_n = p->closed ? p->n : p->n + 1;
  p->points = points->v;
  p->dimension = points->dimension;
  p->knots = ph_arena_array(r->keep, p->n + 1, sizeof *p->knots);
  return p->knots ? PH_OK : ph_fail_memory(r->diag);
}

enum ph_status ph_spatial_points_of(const struct ph_problem *problem,
                                    struct ph_arena *keep,
                                    struct ph_arena *arena,
                                    struct ph_spatial_points *points,
                                    struct ph_diag *diag) {
  static enum ph_status (*const steps[])(struct reading *) = {
      read_points,   check_chords, set_knots,    set_tangents, set_alpha,
      set_planarity, set_tension,  check_speeds, set_normal};
  struct reading r = {problem, points, arena, keep, diag};
  enum ph_status status = PH_OK;
  *points = (struct ph_spatial_points){
      .closed = problem->field[PH_F_CLOSED].flag,
      .atph = ph_value_is(&problem->field[PH_F_BASIS], "atph")};
  for (size_t i = 0; status == PH_OK && i < sizeof steps / sizeof *steps; i++) {
    status = steps[i](&r);
  }
  return status;
}

void ph_spatial_warn_reversals(const struct ph_spatial_points *p,
                               struct ph_result *result) {
  size_t found = 0, first = 0;
  for (size_t k = p->closed ? 0 : 1; k < p->n; k++) {
    struct ph_spatial_data a, b;
    ph_vec3 u, v;
    ph_spatial_segment(p, k > 0 ? k - 1 : p->n - 1, 1, &a);
    ph_spatial_segment(p, k, 1, &b);
    u = ph_vec3_unit(a.dp);
    v = ph_vec3_unit(b.dp);
    if (ph_vec3_dot(u, v) < 0 && ph_vec3_abs(ph_vec3_cross(u, v)) <= REVERSAL &&
        found++ == 0) {
      first = k;
    }
  }
  if (found) {
    ph_warn(result, first, PH_W_REVERSAL,
            "the data turn back by 180 degrees at points[%zu] (such points: "
            "%zu): of many tangents one was taken",
            first, found);
  }
}
