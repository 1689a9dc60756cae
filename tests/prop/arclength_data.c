/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Random problems with prescribed arc lengths (see arclength/system.h). */
#include "arclength_data.h"
#include "spatial_unit.h"
#include "unit.h"

#include "kernel/bern.h"
#include "kernel/quad.h"
#include "solve/method.h"

/* ---- smooth curves ---------------------------------------------------- */

/* Three waves of each coordinate: amplitude[k] cos(k t + phase[k]), k from 1;
 * open ones also advance. */
struct wave {
  double amplitude[3][3], phase[3][3], advance;
  bool flat;
  ph_quat turn;
};

static struct wave wave_of(struct unit_random *r, bool closed, bool flat) {
  struct wave w = {.advance = closed ? 0 : unit_random_in(r, 0.5, 1.5)};
  for (size_t c = 0; c < 3; c++) {
    for (size_t k = 0; k < 3; k++) {
      double most = k == 0 ? 1 : k == 1 ? 0.15 : 0.03;
      w.amplitude[c][k] = unit_random_in(r, k == 0 ? 0.5 : 0, most);
      w.phase[c][k] = unit_random_in(r, -3.2, 3.2);
    }
  }
  /* x and y of the first wave go round */
  w.phase[1][0] = w.phase[0][0] + unit_random_in(r, 1, 2);
  w.flat = flat;
  w.turn = unit_random_turn(r);
  return w;
}

static ph_vec3 turned(ph_quat q, const double v[3]) {
  ph_vec3 sum = ph_vec3_scale(v[0], ph_quat_i(q, q));
  sum = ph_vec3_along(sum, v[1], ph_quat_j(q, q));
  return ph_vec3_along(sum, v[2], ph_quat_k(q, q));
}

/* Point, or derivative. */
static ph_vec3 wave_at(const struct wave *w, double t, bool derivative) {
  double v[3] = {0, 0, derivative ? w->advance : w->advance * t};
  for (size_t c = 0; c < 3; c++) {
    for (size_t k = 0; k < 3; k++) {
      double m = (double)k + 1, x = m * t + w->phase[c][k];
      v[c] += w->amplitude[c][k] * (derivative ? -m * sin(x) : cos(x));
    }
  }
  v[2] = w->flat ? 0 : v[2];
  return turned(w->turn, v);
}

static double wave_length(const struct wave *w, double a, double b) {
  struct ph_quad rule;
  double sum = 0;
  ck_assert(ph_quad_gauss(&rule, PH_QUAD_MAX));
  for (int part = 0; part < 8; part++) {
    for (size_t i = 0; i < rule.n; i++) {
      double t = a + (b - a) * (part + rule.node[i]) / 8;
      sum += rule.weight[i] * ph_vec3_abs(wave_at(w, t, true));
    }
  }
  return sum * (b - a) / 8;
}

static void sample(struct unit_random *r, const struct wave *w, double to,
                   struct arc_data *d) {
  double t[ARC_MAX + 1] = {0}, mean = 0;
  for (size_t i = 0; i < d->n; i++) {
    t[i + 1] = t[i] + unit_random_in(r, 1, 2);
  }
  for (size_t i = 0; i <= d->n; i++) {
    d->point[i] = wave_at(w, t[i] * to / t[d->n], false);
    d->vector[i] = ph_vec3_unit(wave_at(w, t[i] * to / t[d->n], true));
  }
  for (size_t i = 0; i < d->n; i++) {
    d->length[i] = wave_length(w, t[i] * to / t[d->n], t[i + 1] * to / t[d->n]);
    mean += d->length[i] / (double)d->n;
  }
  for (size_t i = 0; d->given == ARC_DERIVATIVES && i <= d->n; i++) {
    d->vector[i] = ph_vec3_scale(mean, d->vector[i]);
  }
}

/* ---- families --------------------------------------------------------- */

static double power(struct unit_random *r, double low, double high) {
  return pow(10, unit_random_in(r, low, high));
}

static void walk(struct unit_random *r, struct arc_data *d) {
  ph_vec3 line = unit_random_direction(r);
  d->point[0] = unit_random_direction(r);
  for (size_t i = 0; i < d->n; i++) {
    bool wild = d->family == ARC_WILD;
    double step = wild ? power(r, -3, 0) : unit_random_in(r, 0.5, 2);
    ph_vec3 way = d->family == ARC_LINE ? line : unit_random_direction(r);
    d->point[i + 1] = ph_vec3_along(d->point[i], step, way);
    d->length[i] = step;
    d->length[i] *= d->family == ARC_WALK ? unit_random_in(r, 1.05, 1.5)
                    : wild                ? 1 + power(r, -6, 3)
                                          : 1;
  }
  for (size_t i = 0; i <= d->n; i++) {
    double speed = 1;
    if (d->given == ARC_DERIVATIVES) {
      speed = d->length[i < d->n ? i : i - 1] * unit_random_in(r, 0.5, 2);
    }
    d->vector[i] = ph_vec3_scale(
        speed, d->family == ARC_LINE ? line : unit_random_direction(r));
  }
}

void arc_of(struct unit_random *r, enum arc_family family, enum arc_given given,
            size_t n, struct arc_data *d) {
  *d = (struct arc_data){.family = family, .given = given, .n = n};
  d->sigma = power(r, -4, -1);
  if (family == ARC_WALK || family == ARC_WILD || family == ARC_LINE) {
    walk(r, d);
    return;
  }
  {
    struct wave w = wave_of(r, false, family == ARC_PLANE);
    sample(r, &w, 0.6 * (double)n, d);
  }
  for (size_t i = 0; family == ARC_PERTURBED && i < n; i++) {
    d->length[i] *= 1 + unit_random_in(r, -0.01, 0.01);
  }
}

void arc_closed(struct unit_random *r, enum arc_given given, size_t n,
                struct arc_data *d) {
  struct wave w = wave_of(r, true, false);
  *d = (struct arc_data){.given = given, .n = n, .closed = true};
  d->sigma = power(r, -4, -1);
  sample(r, &w, 6.283185307179586, d);
}

void arc_any(struct unit_random *r, struct arc_data *d) {
  static const char *const knots[] = {NULL, "chordal", "uniform", "lengths"};
  enum arc_given given = (enum arc_given)unit_random_below(r, ARC_GIVEN_N);
  size_t n = 1 + unit_random_below(r, ARC_MAX / 2);
  if (n > 2 && given <= ARC_SOFT && unit_random_below(r, 4) == 0) {
    arc_closed(r, given, n, d);
    return;
  }
  arc_of(r, (enum arc_family)unit_random_below(r, ARC_LINE), given, n, d);
  d->refine = (int)unit_random_below(r, 4);
  d->knots = knots[unit_random_below(r, 4)];
  if ((given == ARC_RELAXED && d->knots == knots[3]) ||
      (given > ARC_SOFT && d->knots == knots[1])) {
    d->knots = NULL; /* without lengths, or chords */
  }
}

/* ---- solutions -------------------------------------------------------- */

static void set_problem(const struct arc_data *d, struct unit_solution *s) {
  struct ph_problem *p = &s->problem;
  size_t n = d->closed ? d->n : d->n + 1;
  double *v = unit_numbers(s, 3 * n + 3);
  for (size_t i = 0; i < n; i++) {
    ph_vec3_put(d->given <= ARC_SOFT ? d->point[i] : d->vector[i], 3,
                v + 3 * i);
  }
  unit_set_array(p,
                 d->given == ARC_DERIVATIVES ? PH_F_DERIVATIVES
                 : d->given == ARC_TANGENTS  ? PH_F_TANGENTS
                                             : PH_F_POINTS,
                 v, n, 3);
  if (d->given > ARC_SOFT) {
    ph_vec3_put(d->point[0], 3, v + 3 * n);
    unit_set_array(p, PH_F_START, v + 3 * n, 3, 1);
  }
  if (d->given != ARC_RELAXED) {
    unit_set_copy(s, PH_F_LENGTHS, d->length, d->n, 1);
  }
  if (d->given == ARC_SOFT) {
    unit_set_number(p, PH_F_LENGTH_SIGMA, d->sigma);
  }
  if (d->refine) {
    unit_set_number(p, PH_F_REFINE, d->refine);
  }
  unit_set_word(p, PH_F_KNOTS, d->knots);
  unit_set_flag(p, PH_F_CLOSED, d->closed);
}

double arc_f(const struct unit_solution *s) {
  return s->result.diagnostics.value[PH_D_F];
}

bool arc_is_minimum(const struct unit_solution *s) {
  return (enum ph_outcome)s->result.diagnostics.value[PH_D_SECOND_ORDER] ==
         PH_OUTCOME_MINIMISER;
}

ph_vec3 arc_point(const struct unit_solution *s, size_t k, size_t i) {
  return ph_vec3_get(s->result.curve.control_points + 18 * k + 3 * i, 3);
}

/* Derivative with respect to the local parameter. */
static ph_vec3 derivative(const struct unit_solution *s, size_t k, double u) {
  ph_vec3 sum = {0, 0, 0};
  double basis[5];
  ph_bern_basis(4, u, basis);
  for (size_t i = 0; i < 5; i++) {
    ph_vec3 leg = ph_vec3_sub(arc_point(s, k, i + 1), arc_point(s, k, i));
    sum = ph_vec3_along(sum, 5 * basis[i], leg);
  }
  return sum;
}

double arc_length(const struct unit_solution *s, size_t n, size_t i) {
  size_t refine = s->result.curve.n / n;
  struct ph_quad rule;
  double sum = 0;
  ck_assert(ph_quad_gauss(&rule, PH_QUAD_MAX));
  /* |r'| is a polynomial of degree 4 */
  for (size_t k = refine * i; k < refine * (i + 1); k++) {
    for (size_t j = 0; j < rule.n; j++) {
      sum += rule.weight[j] * ph_vec3_abs(derivative(s, k, rule.node[j]));
    }
  }
  return sum;
}

/* Points or directions, lengths: straight from the control points. */
static void ck_curve(const struct arc_data *d, const struct unit_solution *s) {
  size_t segments = s->result.curve.n, refine = segments / d->n;
  double mean = s->result.curve.length / (double)d->n;
  ck_that(segments == refine * d->n && refine >= 1 && refine <= 3 &&
              (!d->refine || (size_t)d->refine == refine),
          "%zu segments", segments);
  for (size_t i = 0; i < d->n; i++) {
    size_t first = refine * i, last = first + refine - 1;
    if (d->given <= ARC_SOFT) {
      ph_vec3 to = d->point[i + 1 < d->n || !d->closed ? i + 1 : 0];
      double away = unit_apart(arc_point(s, first, 0), d->point[i]);
      away = unit_larger(away, unit_apart(arc_point(s, last, 5), to));
      ck_that(away <= 1e-12 * (mean + ph_vec3_abs(to)),
              "point %zu is missed by %.3g", i, away);
    } else {
      ph_vec3 t = ph_vec3_unit(derivative(s, first, 0));
      double away = unit_apart(t, ph_vec3_unit(d->vector[i]));
      ck_that(away <= 1e-9, "direction %zu is missed by %.3g", i, away);
    }
    if (d->given != ARC_RELAXED && d->given != ARC_SOFT) {
      double length = arc_length(s, d->n, i);
      ck_that(fabs(length - d->length[i]) <= 1e-11 * mean,
              "length %zu is %.17g, not %.17g", i, length, d->length[i]);
    }
  }
}

bool arc_solve(const struct arc_data *d, size_t which,
               struct unit_solution *s) {
  static const char *const families[] = {"smooth", "perturbed", "plane",
                                         "walk",   "wild",      "line"};
  static const char *const given[] = {"points", "relaxed", "soft",
                                      "derivatives", "tangents"};
  enum ph_status status;
  unit_case("PH_SEED=%lu, case %zu (%s, %s, %zu intervals, %s, refine %d, "
            "knots %s, sigma %g)",
            unit_seed(), which, families[d->family], given[d->given], d->n,
            d->closed ? "closed" : "open", d->refine,
            d->knots ? d->knots : "by default", d->sigma);
  unit_solution_free(s);
  set_problem(d, s);
  status = unit_solve(&ph_method_arclength, s);
  if (status != PH_OK) {
    ck_that(status == PH_E_INFEASIBLE || status == PH_E_NO_CONVERGENCE, "%s %s",
            s->diag.field, s->diag.message);
    return false;
  }
  status = unit_certify("arclength", s);
  ck_that(!s->refused || d->family == ARC_WILD, "%s %s", s->diag.field,
          s->diag.message);
  if (!s->refused) {
    ck_curve(d, s);
  }
  return !s->refused;
}

void arc_must(const struct arc_data *d, size_t which, struct unit_solution *s) {
  bool solved = arc_solve(d, which, s);
  ck_that(solved, "%s %s", s->diag.field, s->diag.message);
}
