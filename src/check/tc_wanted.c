/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What is asked of Tschirnhausen cubics (see tc_wanted.h). */
#include "check/tc_wanted.h"

#include <float.h>

/* Where it is absent and needed. */
static const double LAMBDA = 0.5;

/* A last point within so many roundings of the first repeats it: 1e-14 of the
 * largest coordinate. */
static const double REPEATED = 45;

/* Rounding of a bisector, in units of eps / |sum of two unit vectors|. */
static const double ROUND_BISECTOR = 8 * DBL_EPSILON;

static bool is(const struct ph_problem *p, enum ph_field_id id,
               const char *word) {
  return ph_value_is(&p->field[id], word);
}

static bool has(const struct ph_problem *p, enum ph_field_id id) {
  return p->field[id].kind != PH_ABSENT;
}

static double number(const struct ph_problem *p, enum ph_field_id id) {
  return has(p, id) ? p->field[id].number : (double)NAN;
}

/* Whether points alone are to have a spline whose curvature may jump. */
static bool is_spline(const struct ph_problem *p) {
  return has(p, PH_F_LAMBDA) || has(p, PH_F_END_DERIVATIVES) ||
         has(p, PH_F_SOLUTIONS) || is(p, PH_F_ENDS, "chord");
}

enum ph_tc_wanted_mode ph_tc_wanted_mode_of(const struct ph_problem *p) {
  if (!has(p, PH_F_MODE)) {
    return has(p, PH_F_CURVE)         ? PH_TC_WANTED_APPROXIMATE
           : has(p, PH_F_TANGENTS)    ? PH_TC_WANTED_EITHER
           : has(p, PH_F_DERIVATIVES) ? PH_TC_WANTED_TWO
           : is_spline(p)             ? PH_TC_WANTED_TWO
                                      : PH_TC_WANTED_G2;
  }
  return is(p, PH_F_MODE, "approximate") ? PH_TC_WANTED_APPROXIMATE
         : is(p, PH_F_MODE, "g2")        ? PH_TC_WANTED_G2
         : is(p, PH_F_MODE, "g1")        ? PH_TC_WANTED_ONE
         : is(p, PH_F_MODE, "g1-auto") || is(p, PH_F_MODE, "g1-fair")
             ? PH_TC_WANTED_EITHER
             : PH_TC_WANTED_TWO;
}

/* How many intervals: a repeated last point of closed data counts once. */
static size_t intervals(const struct ph_value *points,
                        const struct ph_tc_check *c, bool closed) {
  size_t last = points->n - 1;
  ph_cplx back = ph_cplx_sub(ph_tc_check_scaled(c, points->v + 2 * last),
                             ph_tc_check_scaled(c, points->v));
  bool repeated = hypot(back.re, back.im) <= REPEATED * c->scale.rounding;
  return closed && !repeated ? points->n : last;
}

/* The vectors of a field, one for each point; NULL where it is absent.  A
 * closed curve may have one more. */
static bool vectors(const struct ph_tc_wanted *w, enum ph_field_id id,
                    const double **v) {
  const struct ph_value *value = &w->problem->field[id];
  size_t n = w->closed ? w->n : w->n + 1;
  *v = value->kind == PH_VECTORS ? value->v : NULL;
  return value->kind == PH_ABSENT ||
         (value->kind == PH_VECTORS && value->dimension == 2 &&
          (value->n == n || (w->closed && value->n == n + 1)));
}

/* Whether a field is absent, or a vector for each end. */
static bool two_ends(const struct ph_problem *p, enum ph_field_id id) {
  const struct ph_value *value = &p->field[id];
  return value->kind == PH_ABSENT ||
         (value->kind == PH_VECTORS && value->dimension == 2 && value->n == 2);
}

enum ph_status ph_tc_wanted_of(const struct ph_problem *p,
                               const struct ph_tc_check *c,
                               struct ph_tc_wanted *w, struct ph_diag *diag) {
  const struct ph_value *points = &p->field[PH_F_POINTS];
  *w = (struct ph_tc_wanted){.mode = ph_tc_wanted_mode_of(p),
                             .all = is(p, PH_F_SOLUTIONS, "all"),
                             .on_chord = is(p, PH_F_JOINT, "chord"),
                             .joint_angle = number(p, PH_F_JOINT_ANGLE),
                             .joint_position = number(p, PH_F_JOINT_POSITION),
                             .problem = p,
                             .points = points,
                             .closed = p->field[PH_F_CLOSED].flag,
                             .lambda = number(p, PH_F_LAMBDA)};
  w->n = intervals(points, c, w->closed);
  if (w->n == 0 || w->closed != c->curve->closed ||
      !vectors(w, PH_F_TANGENTS, &w->tangents) ||
      !vectors(w, PH_F_DERIVATIVES, &w->derivatives) ||
      !two_ends(p, PH_F_END_TANGENTS) || !two_ends(p, PH_F_END_DERIVATIVES)) {
    return ph_fail(diag, PH_E_INTERNAL, "points", "do not fit the segments");
  }
  w->spline = !w->tangents && !w->derivatives;
  if (w->spline && isnan(w->lambda)) {
    w->lambda = LAMBDA;
  }
  return PH_OK;
}

ph_cplx ph_tc_wanted_point(const struct ph_tc_wanted *w,
                           const struct ph_tc_check *c, size_t k) {
  size_t i = w->closed && k == w->n ? 0 : k;
  return ph_tc_check_scaled(c, w->points->v + 2 * i);
}

/* A vector of any size, so that its length neither over- nor underflows. */
static ph_cplx any_direction(const double *v) {
  double largest = ph_check_larger(fabs(v[0]), fabs(v[1]));
  struct ph_pow2 scale =
      ph_pow2_of(largest > 0 ? -ph_pow2_exponent(largest) : 0);
  return ph_tc_check_direction(
      ph_cplx_of(ph_pow2_apply(scale, v[0]), ph_pow2_apply(scale, v[1])));
}

/* ---- splines ------------------------------------------------------------ */

/* From point k to the next one. */
static ph_cplx chord(const struct ph_tc_wanted *w, const struct ph_tc_check *c,
                     size_t k) {
  return ph_cplx_sub(ph_tc_wanted_point(w, c, k + 1),
                     ph_tc_wanted_point(w, c, k));
}

static bool is_end(const struct ph_tc_wanted *w, size_t k) {
  return !w->closed && (k == 0 || k == w->n);
}

/* The chords before and after point k; at an end its only one, twice. */
static void chords_at(const struct ph_tc_wanted *w, const struct ph_tc_check *c,
                      size_t k, ph_cplx at[2]) {
  size_t before = k > 0 ? k - 1 : w->closed ? w->n - 1 : 0;
  size_t after = k < w->n ? k : w->closed ? 0 : w->n - 1;
  at[0] = chord(w, c, before);
  at[1] = chord(w, c, after);
}

/* The bisector of the chords [BYR11, (5.24)]. */
static void bisect(const ph_cplx at[2], struct ph_tc_wanted_end *end) {
  ph_cplx sum =
      ph_cplx_add(ph_tc_check_direction(at[0]), ph_tc_check_direction(at[1]));
  end->direction = ph_tc_check_direction(sum);
  end->error = ROUND_BISECTOR / ph_cplx_abs(sum);
}

/* An end of an open spline whose derivative is not given: by its tangent, or
 * by the circle that has the bisector at its other point (the mirror image of
 * that in the perpendicular of the chord, turned round), or the chord. */
static void set_end(const struct ph_tc_wanted *w, const struct ph_tc_check *c,
                    size_t k, struct ph_tc_wanted_end *end) {
  const struct ph_problem *p = w->problem;
  if (has(p, PH_F_END_TANGENTS)) {
    end->direction =
        any_direction(p->field[PH_F_END_TANGENTS].v + (k > 0 ? 2 : 0));
  } else if (is(p, PH_F_ENDS, "circle") && w->n > 1) {
    ph_cplx at[2], along, across, beside;
    chords_at(w, c, k > 0 ? k - 1 : 1, at);
    bisect(at, end);
    along = ph_tc_check_direction(chord(w, c, k > 0 ? k - 1 : 0));
    across = ph_cplx_of(-along.im, along.re);
    beside = ph_cplx_scale(ph_cplx_dot(end->direction, across), across);
    end->direction = ph_cplx_sub(end->direction, ph_cplx_scale(2, beside));
  }
}

static struct ph_tc_wanted_end spline_end(const struct ph_tc_wanted *w,
                                          const struct ph_tc_check *c,
                                          size_t k) {
  const struct ph_value *given = &w->problem->field[PH_F_END_DERIVATIVES];
  struct ph_tc_wanted_end end = {.has_direction = true, .has_length = true};
  ph_cplx at[2];
  if (is_end(w, k) && given->kind != PH_ABSENT) {
    const double *v = given->v + (k > 0 ? 2 : 0);
    ph_cplx derivative = ph_tc_check_scaled(c, v);
    end.direction = any_direction(v);
    end.length = hypot(derivative.re, derivative.im);
    return end;
  }
  chords_at(w, c, k, at);
  bisect(at, &end);
  if (is_end(w, k)) {
    set_end(w, c, k, &end);
  }
  end.length = w->lambda * ph_check_smaller(hypot(at[0].re, at[0].im),
                                            hypot(at[1].re, at[1].im));
  return end;
}

/* ---- all ---------------------------------------------------------------- */

struct ph_tc_wanted_end ph_tc_wanted_end_of(const struct ph_tc_wanted *w,
                                            const struct ph_tc_check *c,
                                            size_t k) {
  size_t i = w->closed && k == w->n ? 0 : k;
  struct ph_tc_wanted_end end = {.has_direction = true};
  if (w->spline) {
    return spline_end(w, c, i);
  }
  if (w->derivatives) {
    ph_cplx derivative = ph_tc_check_scaled(c, w->derivatives + 2 * i);
    end.direction = any_direction(w->derivatives + 2 * i);
    end.has_direction = false;
    end.has_length = true;
    end.length = hypot(derivative.re, derivative.im);
    return end;
  }
  end.direction = any_direction(w->tangents + 2 * i);
  if (!isnan(w->lambda)) {
    ph_cplx at[2];
    chords_at(w, c, i, at);
    end.has_length = true;
    end.length = w->lambda * ph_check_smaller(hypot(at[0].re, at[0].im),
                                              hypot(at[1].re, at[1].im));
  }
  return end;
}
