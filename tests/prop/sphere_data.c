/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Random points on spheres (see sphere.h). */
#include "sphere_data.h"
#include "spatial_unit.h"
#include "unit.h"

#include "kernel/pi.h"
#include "kernel/s2.h"
#include "solve/method.h"

/* ---- families ------------------------------------------------------------ */

static double power(struct unit_random *r, double low, double high) {
  return pow(10, unit_random_in(r, low, high));
}

/* Steps of a family, and by how much to turn before each but the first. */
struct pace {
  double least, most;        /* of steps */
  double bend, wave, rhythm; /* turn = step (bend + wave sin(rhythm i)) */
};

static struct pace pace_of(struct unit_random *r, enum sphere_family family) {
  static const double steps[SPHERE_FAMILY_N][2] = {
      {0.05, 0.3}, {0.1, 1.57}, {0.1, 2.2}, {0.1, 3},
      {0.05, 1.5}, {0.1, 1.2},  {0.1, 1.2}, {0, 0}};
  struct pace p = {steps[family][0], steps[family][1],
                   unit_random_in(r, -1.5, 1.5), unit_random_in(r, 0, 1.5),
                   unit_random_in(r, 0.1, 0.7)};
  if (family == SPHERE_DENSE) {
    p.least = power(r, -6, -3);
    p.most = 3 * p.least;
  }
  return p;
}

static double turn_of(struct unit_random *r, enum sphere_family family,
                      const struct pace *p, size_t i, double step) {
  switch (family) {
  case SPHERE_SMOOTH:
  case SPHERE_DENSE:
    return step * (p->bend + p->wave * sin(p->rhythm * (double)i));
  case SPHERE_CIRCLE:
    return 0;
  case SPHERE_RUNS:
    return unit_random_below(r, 5) < 3 ? 0 : unit_random_in(r, -1.5, 1.5);
  case SPHERE_NEARLY:
    return power(r, -9, -2) * (unit_random_below(r, 2) ? 1 : -1);
  default:
    return unit_random_in(r, -PH_PI, PH_PI);
  }
}

static void walk(struct unit_random *r, struct sphere_data *d) {
  struct pace pace = pace_of(r, d->family);
  ph_vec3 at = unit_random_direction(r);
  ph_vec3 left = ph_vec3_unit(ph_vec3_cross(at, unit_random_direction(r)));
  for (size_t i = 0; i < d->n; i++) {
    double step = unit_random_in(r, pace.least, pace.most);
    ph_cplx turn = ph_cplx_polar(turn_of(r, d->family, &pace, i, step));
    ph_cplx go = ph_cplx_polar(step);
    ph_vec3 on = ph_vec3_cross(left, at);
    d->point[i] = at;
    left = ph_vec3_along(ph_vec3_scale(turn.re, left), -turn.im, on);
    on = ph_vec3_cross(left, at);
    at = ph_vec3_unit(ph_vec3_along(ph_vec3_scale(go.re, at), go.im, on));
    left = ph_vec3_unit(ph_vec3_normal(left, at));
  }
}

static void ring(struct unit_random *r, struct sphere_data *d) {
  ph_quat q = unit_random_turn(r);
  double high = unit_random_in(r, -0.8, 0.8), wave = unit_random_in(r, 0, 0.5);
  double phase = unit_random_in(r, -3.2, 3.2);
  size_t waves = 2 + unit_random_below(r, 3);
  for (size_t i = 0; i < d->n; i++) {
    double u = (double)i + unit_random_in(r, 0, 0.5);
    double t = 2 * PH_PI * u / (double)d->n;
    ph_cplx lon = ph_cplx_polar(t);
    ph_cplx lat = ph_cplx_polar(high + wave * cos((double)waves * t + phase));
    ph_vec3 v = ph_vec3_scale(lat.re * lon.re, ph_quat_i(q, q));
    v = ph_vec3_along(v, lat.re * lon.im, ph_quat_j(q, q));
    d->point[i] = ph_vec3_unit(ph_vec3_along(v, lat.im, ph_quat_k(q, q)));
  }
}

void sphere_of(struct unit_random *r, enum sphere_family family, size_t n,
               struct sphere_data *d) {
  ck_assert_uint_le(n, SPHERE_MAX);
  *d = (struct sphere_data){.family = family, .n = n, .radius = 1};
  d->closed = family == SPHERE_RING;
  if (family == SPHERE_RING) {
    ring(r, d);
  } else {
    walk(r, d);
  }
}

void sphere_options(struct unit_random *r, struct sphere_data *d) {
  static const char *const ends[] = {NULL, "natural", "rest", "clamped"};
  static const char *const knots[] = {NULL, "geodesic", "uniform"};
  static const char *const models[] = {NULL, "exact", "nielson"};
  d->model = models[unit_random_below(r, 3)];
  d->knots = knots[unit_random_below(r, 3)];
  d->ends = d->closed ? NULL : ends[unit_random_below(r, 4)];
  d->tension = unit_random_below(r, 3) ? 0 : power(r, -1, 2);
  for (size_t e = 0; e < 2; e++) {
    d->end_tangent[e] = unit_random_direction(r);
  }
}

void sphere_any(struct unit_random *r, struct sphere_data *d) {
  enum sphere_family family =
      (enum sphere_family)unit_random_below(r, SPHERE_FAMILY_N);
  size_t n = 3 + unit_random_below(r, 10);
  sphere_of(r, family, family == SPHERE_RING ? n + 2 : n, d);
  sphere_options(r, d);
  d->shape = unit_random_below(r, 2);
  switch (unit_random_below(r, 4)) {
  case 0:
    d->radius = power(r, -9, 9);
    d->center = ph_vec3_scale(d->radius, unit_random_direction(r));
    break;
  case 1:
    d->center = ph_vec3_scale(power(r, 0, 4), unit_random_direction(r));
    break;
  case 2:
    d->lonlat = true;
    break;
  default:
    break;
  }
}

size_t sphere_steps(const struct sphere_data *d, double *step) {
  size_t m = d->closed ? d->n : d->n - 1;
  for (size_t k = 0; k < m; k++) {
    step[k] = ph_s2_angle(d->point[k], d->point[k + 1 < d->n ? k + 1 : 0]);
  }
  return m;
}

/* ---- problems ------------------------------------------------------------ */

static void set_points(const struct sphere_data *d, struct unit_solution *s) {
  double *v = unit_numbers(s, 3 * d->n + 9), *center = v + 3 * d->n;
  for (size_t i = 0; i < d->n; i++) {
    ph_vec3 p = d->point[i];
    if (d->lonlat) {
      v[2 * i] = 180 / PH_PI * atan2(p.y, p.x);
      v[2 * i + 1] = 180 / PH_PI * atan2(p.z, hypot(p.x, p.y));
    } else {
      ph_vec3_put(ph_vec3_along(d->center, d->radius, p), 3, v + 3 * i);
    }
  }
  ph_vec3_put(d->center, 3, center);
  unit_set_array(&s->problem, PH_F_CENTER, center, 3, 1);
  unit_set_number(&s->problem, PH_F_RADIUS, d->radius);
  unit_set_array(&s->problem, d->lonlat ? PH_F_LONLAT : PH_F_POINTS, v, d->n,
                 d->lonlat ? 2 : 3);
  if (d->ends && strcmp(d->ends, "clamped") == 0) {
    ph_vec3_put(d->end_tangent[0], 3, center + 3);
    ph_vec3_put(d->end_tangent[1], 3, center + 6);
    unit_set_array(&s->problem, PH_F_END_TANGENTS, center + 3, 2, 3);
  }
}

static void set_problem(const struct sphere_data *d, struct unit_solution *s) {
  struct ph_problem *p = &s->problem;
  set_points(d, s);
  unit_set_word(p, PH_F_MODEL, d->model);
  unit_set_word(p, PH_F_ENDS, d->ends);
  unit_set_word(p, PH_F_KNOTS, d->knots);
  unit_set_word(p, PH_F_CRITERION, d->criterion);
  unit_set_word(p, PH_F_INCREASE, d->increase);
  p->field[PH_F_INCREASE].number = d->by;
  unit_set_flag(p, PH_F_CLOSED, d->closed);
  unit_set_flag(p, PH_F_SHAPE, d->shape);
  if (d->tension > 0) {
    unit_set_number(p, PH_F_TENSION, d->tension);
  }
}

/* ---- solutions ----------------------------------------------------------- */

ph_vec3 sphere_point(const struct unit_solution *s, size_t k, size_t i) {
  return ph_spherical_of(&s->result.curve, k).p[i];
}

/* What rounding of coordinates moves a point by, on the unit sphere. */
static double rounding(const struct sphere_data *d) {
  return 8 * DBL_EPSILON * (1 + ph_vec3_abs(d->center) / d->radius);
}

/* Points, and no segment shorter than the way between its ends. */
static void ck_curve(const struct sphere_data *d,
                     const struct unit_solution *s) {
  const struct ph_curve *c = &s->result.curve;
  double step[SPHERE_MAX], sum = 0;
  ck_that(c->n == sphere_steps(d, step), "%zu segments", c->n);
  for (size_t k = 0; k < c->n; k++) {
    ph_vec3 to = d->point[k + 1 < d->n ? k + 1 : 0];
    double away = ph_s2_angle(sphere_point(s, k, 0), d->point[k]);
    double length = c->lengths[k] / d->radius;
    away = unit_larger(away, ph_s2_angle(sphere_point(s, k, 3), to));
    ck_that(away <= rounding(d), "point %zu is missed by %.3g", k, away);
    ck_that(length >= step[k] * (1 - 1e-12) - rounding(d),
            "segment %zu has length %.17g < %.17g", k, length, step[k]);
    sum += c->lengths[k];
  }
  ck_that(unit_near_rel(sum, c->length, 1e-14),
          "length %.17g, the sum is %.17g", c->length, sum);
}

static const char *word(const char *text) {
  return text ? text : "by default";
}

bool sphere_solve(const struct sphere_data *d, size_t which,
                  struct unit_solution *s) {
  static const char *const families[] = {"smooth",   "walk",   "far",
                                         "farthest", "circle", "runs",
                                         "nearly",   "dense",  "ring"};
  enum ph_status status;
  unit_case("PH_SEED=%lu, case %zu (%s, %zu points, model %s, ends %s, "
            "knots %s, tension %.17g, shape %d, radius %.17g, center at "
            "%.3g, %s)",
            unit_seed(), which, families[d->family], d->n, word(d->model),
            word(d->ends), word(d->knots), d->tension, d->shape, d->radius,
            ph_vec3_abs(d->center), d->lonlat ? "lonlat" : "points");
  unit_solution_free(s);
  set_problem(d, s);
  status = unit_solve(&ph_method_sphere, s);
  if (status != PH_OK) {
    ck_that(status == PH_E_NO_CONVERGENCE ||
                (status == PH_E_INFEASIBLE && d->shape),
            "%s %s", s->diag.field, s->diag.message);
    return false;
  }
  status = unit_certify("sphere", s);
  if (!s->refused) {
    ck_curve(d, s);
  }
  return !s->refused;
}

void sphere_must(const struct sphere_data *d, size_t which,
                 struct unit_solution *s) {
  bool solved = sphere_solve(d, which, s);
  ck_that(solved, "%s %s", s->diag.field, s->diag.message);
}
