/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Data of Tschirnhausen cubics (see tc.h).
 *
 * Tangents of a spline are bisectors of the directions of the chords [BYR11,
 * (5.24)], their lengths lambda times the shorter one [BYR11, (5.25)].
 */
#include "solve/tc/tc.h"

#include "kernel/pi.h"
#include "solve/common/fields.h"

#include <float.h>
#include <math.h>

/* Chords that are shorter, of data at unit scale, are none: their squares would
 * not be numbers. */
static const double NOTHING = 1e-140;

/* Directions whose sum is less than this are opposite. */
static const double REVERSAL = 1e-12;

/* Derivatives beyond this part or multiple of a chord beside them leave no
 * digits to the curve. */
static const double RATIO_MAX = 1e12;

/* ---- fields ------------------------------------------------------------- */

static const struct {
  const char *name;
  enum ph_tc_mode mode;
  enum ph_field_id vectors; /* that it needs; PH_F_POINTS: none */
} modes[] = {
    {"g1", PH_TC_G1, PH_F_TANGENTS},
    {"g1-pair", PH_TC_G1_PAIR, PH_F_TANGENTS},
    {"g1-auto", PH_TC_G1_AUTO, PH_F_TANGENTS},
    {"g1-fair", PH_TC_G1_FAIR, PH_F_TANGENTS},
    {"c1", PH_TC_C1, PH_F_DERIVATIVES},
    {"spline", PH_TC_SPLINE, PH_F_POINTS},
    {"g2", PH_TC_G2, PH_F_POINTS},
    {"approximate", PH_TC_APPROXIMATE, PH_F_POINTS},
};

/* Whether a problem with points alone says something of a spline that the mode
 * g2 does not have. */
static bool is_spline(const struct ph_problem *p) {
  return ph_fields_given(p, PH_F_LAMBDA) ||
         ph_fields_given(p, PH_F_END_DERIVATIVES) ||
         ph_fields_given(p, PH_F_SOLUTIONS) ||
         ph_value_is(&p->field[PH_F_ENDS], "chord");
}

static enum ph_tc_mode implied(const struct ph_problem *p) {
  return ph_fields_given(p, PH_F_CURVE)         ? PH_TC_APPROXIMATE
         : ph_fields_given(p, PH_F_TANGENTS)    ? PH_TC_G1_FAIR
         : ph_fields_given(p, PH_F_DERIVATIVES) ? PH_TC_C1
         : is_spline(p)                         ? PH_TC_SPLINE
                                                : PH_TC_G2;
}

/* Fields that say something in some modes alone: where they would be ignored
 * they are refused. */
static enum ph_status check_fields(const struct ph_problem *p,
                                   enum ph_tc_mode mode, struct ph_diag *diag) {
  bool g1 = mode <= PH_TC_G1_FAIR, approximate = mode == PH_TC_APPROXIMATE;
  bool chord = ph_value_is(&p->field[PH_F_JOINT], "chord");
  bool open =
      (mode == PH_TC_SPLINE || mode == PH_TC_G2) && !p->field[PH_F_CLOSED].flag;
  const struct {
    enum ph_field_id id;
    bool allowed;
    const char *why;
  } rules[] = {
      {PH_F_TANGENTS, g1, "are for the modes g1, g1-pair, g1-auto, g1-fair"},
      {PH_F_DERIVATIVES, mode == PH_TC_C1, "are for the mode c1"},
      {PH_F_CURVE, approximate, "is for the mode approximate"},
      {PH_F_TOLERANCE, approximate, "is for the mode approximate"},
      {PH_F_PIECES, approximate, "is for the mode approximate"},
      {PH_F_SOLUTIONS,
       !(approximate || mode == PH_TC_G2) ||
           !ph_value_is(&p->field[PH_F_SOLUTIONS], "all"),
       "must not be all in the modes approximate and g2"},
      {PH_F_LAMBDA, (g1 && mode != PH_TC_G1 && !chord) || mode == PH_TC_SPLINE,
       chord ? "is for joints that are free"
             : "is for the modes spline, g1-pair, g1-auto, g1-fair"},
      {PH_F_END_TANGENTS, open,
       "are for the modes spline and g2 of open curves"},
      {PH_F_END_DERIVATIVES,
       mode == PH_TC_SPLINE && open && !ph_fields_given(p, PH_F_END_TANGENTS),
       "are for the mode spline of open curves, without end_tangents"},
      {PH_F_ENDS,
       open && !ph_fields_given(p, PH_F_END_TANGENTS) &&
           !ph_fields_given(p, PH_F_END_DERIVATIVES),
       "is for the modes spline and g2 of open curves whose ends are not "
       "given"},
      {PH_F_AUXILIARY, mode == PH_TC_G2, "is for the mode g2"},
      {PH_F_JOINT, mode == PH_TC_G1_PAIR, "is for the mode g1-pair"},
      {PH_F_JOINT_ANGLE, chord, "is for \"joint\":\"chord\""},
      {PH_F_JOINT_POSITION, chord, "is for \"joint\":\"chord\""},
  };
  if ((ph_value_is(&p->field[PH_F_ENDS], "smooth") && mode == PH_TC_SPLINE) ||
      (ph_value_is(&p->field[PH_F_ENDS], "chord") && mode == PH_TC_G2)) {
    return ph_fail(diag, PH_E_BAD_VALUE, "ends",
                   "must be circle or %s in the mode %s",
                   mode == PH_TC_G2 ? "smooth" : "chord",
                   mode == PH_TC_G2 ? "g2" : "spline");
  }
  for (size_t i = 0; i < sizeof rules / sizeof *rules; i++) {
    if (!rules[i].allowed && ph_fields_given(p, rules[i].id)) {
      return ph_fail(diag, PH_E_BAD_VALUE, ph_field_name(rules[i].id), "%s",
                     rules[i].why);
    }
  }
  return PH_OK;
}

enum ph_status ph_tc_mode_of(const struct ph_problem *p, enum ph_tc_mode *mode,
                             struct ph_diag *diag) {
  const struct ph_value *said = &p->field[PH_F_MODE];
  enum ph_status status;
  if (ph_fields_given(p, PH_F_TANGENTS) &&
      ph_fields_given(p, PH_F_DERIVATIVES)) {
    return ph_fail(diag, PH_E_BAD_VALUE, "tangents",
                   "excludes derivatives: give one of them");
  }
  *mode = implied(p);
  for (size_t i = 0; i < sizeof modes / sizeof *modes; i++) {
    if (ph_value_is(said, modes[i].name)) {
      enum ph_field_id needs = modes[i].vectors;
      *mode = modes[i].mode;
      if (needs != PH_F_POINTS && !ph_fields_given(p, needs)) {
        return ph_fail(diag, PH_E_MISSING_FIELD, ph_field_name(needs),
                       "is required by the mode %s", modes[i].name);
      }
    }
  }
  status = check_fields(p, *mode, diag);
  if (status == PH_OK && *mode != PH_TC_APPROXIMATE &&
      !ph_fields_given(p, PH_F_POINTS)) {
    status = ph_fail(diag, PH_E_MISSING_FIELD, "points",
                     "or curve or path must be given");
  }
  return status;
}

/* A number of a field in an open range; `none` where it is absent. */
static enum ph_status read_number(const struct ph_problem *p,
                                  enum ph_field_id id, double above,
                                  double below, const char *range, double none,
                                  double *x, struct ph_diag *diag) {
  *x = ph_fields_given(p, id) ? p->field[id].number : none;
  return !ph_fields_given(p, id) || (*x > above && *x < below)
             ? PH_OK
             : ph_fail(diag, PH_E_BAD_VALUE, ph_field_name(id),
                       "must be %s, found %.17g", range, *x);
}

static enum ph_status read_numbers(const struct ph_problem *p,
                                   struct ph_tc_data *d, struct ph_diag *diag) {
  const double none = d->mode == PH_TC_SPLINE ? PH_TC_LAMBDA : (double)NAN;
  enum ph_status status =
      read_number(p, PH_F_LAMBDA, 1 / RATIO_MAX, RATIO_MAX,
                  "between 1e-12 and 1e12", none, &d->lambda, diag);
  if (status == PH_OK) {
    status = read_number(p, PH_F_JOINT_ANGLE, -2 * PH_PI, 2 * PH_PI,
                         "between -2 pi and 2 pi", (double)NAN, &d->joint_angle,
                         diag);
  }
  return status == PH_OK
             ? read_number(p, PH_F_JOINT_POSITION, 0, 1, "between 0 and 1",
                           (double)NAN, &d->joint_position, diag)
             : status;
}

/* ---- points ------------------------------------------------------------- */

static ph_cplx scaled(const struct ph_tc_data *d, const double *v) {
  return ph_cplx_of(ph_pow2_apply(d->to_unit, v[0]),
                    ph_pow2_apply(d->to_unit, v[1]));
}

static ph_cplx unit_point(const struct ph_tc_data *d, size_t k) {
  return scaled(d, d->points + 2 * (k < d->points_n ? k : 0));
}

ph_cplx ph_tc_chord(const struct ph_tc_data *d, size_t k) {
  return ph_cplx_sub(unit_point(d, k + 1), unit_point(d, k));
}

static ph_cplx direction(const struct ph_tc_data *d, size_t k) {
  ph_cplx c = ph_tc_chord(d, k);
  return ph_cplx_of(c.re / d->chord[k], c.im / d->chord[k]);
}

ph_cplx ph_tc_root(const struct ph_tc_data *d, size_t k) {
  return ph_cplx_scale(sqrt(d->chord[k]), ph_cplx_sqrt(direction(d, k)));
}

static enum ph_status set_chords(struct ph_tc_data *d, struct ph_diag *diag) {
  d->exponent =
      ph_fields_exponent(ph_fields_largest(d->points, 2 * d->points_n));
  d->to_unit = ph_pow2_of(d->exponent);
  for (size_t k = 0; k < d->n; k++) {
    size_t to = k + 1 < d->points_n ? k + 1 : 0;
    ph_cplx a = unit_point(d, k), b = unit_point(d, to), c = ph_tc_chord(d, k);
    double far =
        fmax(fmax(fabs(a.re), fabs(a.im)), fmax(fabs(b.re), fabs(b.im)));
    d->chord[k] = hypot(c.re, c.im);
    if (!(d->chord[k] > 4 * DBL_EPSILON * far) || !(d->chord[k] > NOTHING)) {
      return ph_fields_coincide(diag, "points", k, to);
    }
  }
  return PH_OK;
}

/* ---- vectors ------------------------------------------------------------ */

/* v / |v| */
static ph_cplx unit_of(const double *v) {
  ph_vec3 unit = ph_fields_unit(ph_vec3_of(v[0], v[1], 0));
  return ph_cplx_of(unit.x, unit.y);
}

/* The end tangent of an open spline by its rule: along the chord, or that of
 * the circle through two points with the tangent at the inner one. */
static ph_cplx end_direction(const struct ph_problem *p,
                             const struct ph_tc_data *d, size_t end) {
  ph_cplx chord = direction(d, end == 0 ? 0 : d->n - 1);
  ph_cplx inner;
  if (d->n == 1 || !ph_value_is(&p->field[PH_F_ENDS], "circle")) {
    return chord;
  }
  inner = d->vector[end == 0 ? 1 : d->n - 1];
  return ph_cplx_mul(ph_cplx_mul(chord, chord), ph_cplx_conj(inner));
}

/* What is given of the two ends: a field of two vectors. */
static enum ph_status check_ends(const struct ph_problem *p,
                                 enum ph_field_id id, struct ph_diag *diag) {
  const struct ph_value *value = &p->field[id];
  if (!ph_fields_given(p, id)) {
    return PH_OK;
  }
  if (value->n != 2) {
    return ph_fail(diag, PH_E_BAD_SHAPE, ph_field_name(id),
                   "must have 2 vectors, one for each end, found %zu",
                   value->n);
  }
  for (size_t i = 0; i < 2; i++) {
    if (!(ph_fields_largest(value->v + 2 * i, 2) > 0)) {
      return ph_fail_at(diag, PH_E_ZERO_TANGENT, ph_field_name(id), i,
                        "must not be zero");
    }
  }
  return PH_OK;
}

/* Directions of a spline [BYR11, (5.24)]. */
static enum ph_status set_directions(const struct ph_problem *p,
                                     struct ph_tc_data *d,
                                     struct ph_diag *diag) {
  for (size_t k = d->closed ? 0 : 1; k < d->n; k++) {
    ph_cplx sum =
        ph_cplx_add(direction(d, k > 0 ? k - 1 : d->n - 1), direction(d, k));
    double size = ph_cplx_abs(sum);
    if (!(size > REVERSAL)) {
      return ph_fail_at(diag, PH_E_INFEASIBLE, "points", k,
                        "is where the data turn back by 180 degrees: the "
                        "chords have no bisector there");
    }
    d->vector[k] = ph_cplx_scale(1 / size, sum);
  }
  for (size_t end = 0; !d->closed && end < 2; end++) {
    const struct ph_value *given = &p->field[PH_F_END_TANGENTS];
    d->vector[end == 0 ? 0 : d->n] = given->kind == PH_ABSENT
                                         ? end_direction(p, d, end)
                                         : unit_of(given->v + 2 * end);
  }
  return PH_OK;
}

/* Lengths for directions [BYR11, (5.25)], and end derivatives that are given.
 */
static void set_lengths(const struct ph_problem *p, struct ph_tc_data *d) {
  const struct ph_value *ends = &p->field[PH_F_END_DERIVATIVES];
  for (size_t k = 0; k < d->points_n; k++) {
    bool first = k == 0 && !d->closed, last = k == d->n && !d->closed;
    double before = d->chord[k > 0 ? k - 1 : d->n - 1];
    double after = d->chord[last ? d->n - 1 : k];
    double shorter = first ? after : last ? before : fmin(before, after);
    d->vector[k] = ph_cplx_scale(d->lambda * shorter, d->vector[k]);
  }
  if (ends->kind != PH_ABSENT) {
    d->vector[0] = scaled(d, ends->v);
    d->vector[d->n] = scaled(d, ends->v + 2);
  }
  d->c1 = true;
}

/* The ratio of the derivative at points[at] to the chord of segment k. */
static enum ph_status check_ratio(const struct ph_problem *p,
                                  const struct ph_tc_data *d, size_t k,
                                  size_t at, struct ph_diag *diag) {
  const bool given = d->mode == PH_TC_C1;
  const bool end = !d->closed && (at == 0 || at == d->n) &&
                   p->field[PH_F_END_DERIVATIVES].kind != PH_ABSENT;
  const double ratio = hypot(d->vector[at].re, d->vector[at].im) / d->chord[k];
  const bool small = ratio * RATIO_MAX < 1;
  if (small || !(ratio < RATIO_MAX)) {
    return ph_fail_at(
        diag,
        !small  ? PH_E_TOO_LARGE
        : given ? PH_E_ZERO_TANGENT
                : PH_E_COINCIDENT_POINTS,
        given ? "derivatives" : "points", at,
        "%s too %s beside the chord from points[%zu] to "
        "points[%zu]%s",
        given ? "is" : "gets a derivative that is", small ? "small" : "large",
        k, k + 1 < d->points_n ? k + 1 : 0,
        small && !given && !end ? "; --merge=D joins points nearer than D"
                                : "");
  }
  return PH_OK;
}

/* Derivatives that are nothing beside a chord, or all but everything. */
static enum ph_status check_ratios(const struct ph_problem *p,
                                   const struct ph_tc_data *d,
                                   struct ph_diag *diag) {
  for (size_t k = 0; d->c1 && k < d->n; k++) {
    size_t next = k + 1 < d->points_n ? k + 1 : 0;
    if (check_ratio(p, d, k, k, diag) != PH_OK ||
        check_ratio(p, d, k, next, diag) != PH_OK) {
      return diag->status;
    }
  }
  return PH_OK;
}

/* Of curves with continuous curvature: what is given at the ends. */
static enum ph_status set_end_tangents(const struct ph_problem *p,
                                       struct ph_tc_data *d,
                                       struct ph_diag *diag) {
  const struct ph_value *given = &p->field[PH_F_END_TANGENTS];
  for (size_t end = 0; !d->closed && end < 2; end++) {
    d->vector[end * d->n] = ph_cplx_of((double)NAN, (double)NAN);
  }
  if (check_ends(p, PH_F_END_TANGENTS, diag) != PH_OK) {
    return diag->status;
  }
  for (size_t end = 0; given->kind != PH_ABSENT && end < 2; end++) {
    d->vector[end * d->n] = unit_of(given->v + 2 * end);
  }
  return PH_OK;
}

static enum ph_status set_vectors(const struct ph_problem *p,
                                  struct ph_tc_data *d, struct ph_diag *diag) {
  enum ph_status status;
  d->c1 = d->mode == PH_TC_C1;
  if (d->mode == PH_TC_G2) {
    return set_end_tangents(p, d, diag);
  }
  if (d->mode == PH_TC_SPLINE) {
    status = check_ends(p, PH_F_END_TANGENTS, diag);
    if (status == PH_OK) {
      status = check_ends(p, PH_F_END_DERIVATIVES, diag);
    }
    if (status == PH_OK) {
      status = set_directions(p, d, diag);
    }
  } else {
    enum ph_field_id id = d->c1 ? PH_F_DERIVATIVES : PH_F_TANGENTS;
    status = ph_fields_vectors(p, id, d->points_n, diag);
    for (size_t k = 0; status == PH_OK && k < d->points_n; k++) {
      const double *v = p->field[id].v + 2 * k;
      d->vector[k] = d->c1 ? scaled(d, v) : unit_of(v);
    }
  }
  if (status == PH_OK && !isnan(d->lambda)) {
    set_lengths(p, d);
  }
  return status == PH_OK ? check_ratios(p, d, diag) : status;
}

struct ph_tc_hermite ph_tc_hermite_of(const struct ph_tc_data *d, size_t k) {
  ph_cplx back = ph_cplx_conj(direction(d, k));
  double size = d->c1 ? d->chord[k] : 1;
  struct ph_tc_hermite h;
  for (size_t i = 0; i < 2; i++) {
    ph_cplx v = d->vector[k + i < d->points_n ? k + i : 0];
    h.t[i] =
        ph_tc_snap(ph_cplx_mul(back, ph_cplx_of(v.re / size, v.im / size)));
  }
  return h;
}

enum ph_status ph_tc_data_of(const struct ph_problem *p, enum ph_tc_mode mode,
                             struct ph_arena *arena, struct ph_tc_data *d,
                             struct ph_diag *diag) {
  const struct ph_value *solutions = &p->field[PH_F_SOLUTIONS];
  enum ph_status status;
  *d = (struct ph_tc_data){.mode = mode,
                           .closed = p->field[PH_F_CLOSED].flag,
                           .points = p->field[PH_F_POINTS].v};
  d->choice = ph_value_is(solutions, "all")        ? PH_TC_ALL
              : ph_value_is(solutions, "standard") ? PH_TC_STANDARD
                                                   : PH_TC_BEST;
  d->on_chord = ph_value_is(&p->field[PH_F_JOINT], "chord");
  status = read_numbers(p, d, diag);
  if (status == PH_OK) {
    status = ph_fields_segments(p, &d->n, diag);
  }
  if (status != PH_OK) {
    return status;
  }
  d->points_n = d->closed ? d->n : d->n + 1;
  d->vector = ph_arena_array(arena, d->points_n, sizeof *d->vector);
  d->chord = ph_arena_array(arena, d->n, sizeof *d->chord);
  if (!d->vector || !d->chord) {
    return ph_fail_memory(diag);
  }
  status = set_chords(d, diag);
  return status == PH_OK ? set_vectors(p, d, diag) : status;
}
