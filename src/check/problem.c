/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A curve against the problem that it is said to solve: points, tangents and
 * derivatives, what is given at the ends, and lengths, as far as the command
 * promises them (promise.h).  Of a Bezier curve in place of another only the
 * direction is known.
 */
#include "check/checks.h"
#include "check/data.h"

enum { ROUND_POINT = 8 };

/* What moves points of a sphere, unless the problem says it. */
static const double MOVED = 1e-3;

struct context {
  struct ph_check *v;
  struct ph_check_data data;
  double moved; /* allowed, of the radius */
};

/* An end of an interval. */
struct end {
  const struct ph_check_segment *s;
  double u;
  size_t datum;
  bool pair; /* the interval has two segments */
};

/* ---- what the problem is ---------------------------------------------------
 */

static bool is_flag(const struct ph_check *v, enum ph_field_id id) {
  return v->problem->field[id].kind == PH_BOOL && v->problem->field[id].flag;
}

/* Whether the curve is of the kind that was asked for. */
static bool is_asked_for(struct ph_check *v) {
  const struct ph_curve *c = v->curve;
  if (c->closed != is_flag(v, PH_F_CLOSED)) {
    ph_check_wrong(v, PH_CHECK_SHAPE, ph_check_of(NULL, PH_CHECK_ONE, "closed"),
                   "is not what the problem says");
    return false;
  }
  if ((v->promise->kinds & PH_KIND(ATPH)) &&
      ph_check_is_word(v, PH_F_BASIS, "atph") != v->kind->trigonometric) {
    ph_check_wrong(v, PH_CHECK_SHAPE, ph_check_of(NULL, PH_CHECK_ONE, "curve"),
                   "is not of the basis of the problem");
    return false;
  }
  return true;
}

bool ph_check_is_approximation(const struct ph_check *v) {
  if (!v->promise->approximate) {
    return false;
  }
  if (!v->problem) {
    return ph_check_known(v, PH_D_DISTANCE);
  }
  return v->problem->field[PH_F_MODE].kind == PH_WORD
             ? ph_check_is_word(v, PH_F_MODE, "approximate")
             : ph_check_field(v, PH_F_CURVE) != NULL;
}

/* ---- points ----------------------------------------------------------------
 */

static void check_point(const struct context *x, const struct end *e) {
  struct ph_check *v = x->v;
  double off, reach;
  ph_vec3 datum = ph_check_datum(v, &x->data, e->datum, &off);
  reach = v->scale.rounding;
  if (e->s->kind->sphere) {
    reach += ph_check_reach(v, e->s->center) + DBL_EPSILON * e->s->radius;
    ph_check_miss(v, PH_CHECK_INTERPOLATION,
                  ph_check_in(e->s->k, "control_points"), off - x->moved, 1,
                  ROUND_POINT * reach / e->s->radius,
                  "stand for a point that is off the sphere");
  }
  ph_check_miss(v, PH_CHECK_INTERPOLATION,
                ph_check_in(e->s->k, "control_points"),
                ph_check_apart(ph_check_point(v, e->s, e->u), datum),
                v->scale.size, ROUND_POINT * reach, "miss the point");
}

/* Without points the curve begins at the start. */
static void check_start(const struct context *x, const struct end *e) {
  struct ph_check *v = x->v;
  const struct ph_value *given = ph_check_field(v, PH_F_START);
  bool fits = given && (given->n == 2 || given->n == 3);
  ph_vec3 start =
      fits ? ph_check_vector(v, given->v, given->n) : ph_vec3_of(0, 0, 0);
  ph_check_miss(
      v, PH_CHECK_INTERPOLATION, ph_check_in(e->s->k, "control_points"),
      ph_check_apart(ph_check_point(v, e->s, e->u), start), v->scale.size,
      ROUND_POINT * v->scale.rounding, "miss the start");
}

/* ---- tangents and derivatives ----------------------------------------------
 */

/* A given derivative against r' by u, where it is known what it is by, or else
 * its direction. */
static void check_derivative(const struct context *x, const struct end *e,
                             enum ph_check_id check, const double *w,
                             size_t dimension) {
  struct ph_check *v = x->v;
  const struct ph_curve *c = v->curve;
  enum ph_given given = v->kind->converted ? PH_GIVEN_NONE : v->promise->given;
  double factor = 1;
  if (given == PH_GIVEN_TENSION) {
    factor =
        c->choice.tension[e->s->k] * c->choice.tension[e->s->k] * e->s->unit;
  } else if (given == PH_GIVEN_KNOTS) {
    factor = e->s->spacing;
  }
  if (given == PH_GIVEN_NONE || (given == PH_GIVEN_CUBIC && !e->pair)) {
    ph_check_heading(v, check, e->s, e->u, ph_check_direction(w, dimension));
  } else {
    ph_check_derivative(v, check, e->s, e->u, factor,
                        ph_check_vector(v, w, dimension),
                        given == PH_GIVEN_KNOTS);
  }
}

static void check_vector(const struct context *x, const struct end *e) {
  const struct ph_value *given = x->data.vectors;
  size_t j = e->datum < given->n ? e->datum : 0;
  const double *w = given->v + given->dimension * j;
  if (x->data.derivatives) {
    check_derivative(x, e, PH_CHECK_TANGENT, w, given->dimension);
  } else {
    ph_check_heading(x->v, PH_CHECK_TANGENT, e->s, e->u,
                     ph_check_direction(w, given->dimension));
  }
}

/* The first and the last end of an open curve. */
static void check_ends(const struct context *x, const struct end *e) {
  struct ph_check *v = x->v;
  const struct ph_value *derivatives = ph_check_field(v, PH_F_END_DERIVATIVES);
  const struct ph_value *tangents = ph_check_field(v, PH_F_END_TANGENTS);
  const struct ph_value *given = derivatives ? derivatives : tangents;
  const double *w;
  if (!given || given->n != 2) {
    return;
  }
  w = given->v + (e->datum > 0 ? given->dimension : 0);
  if (derivatives) {
    check_derivative(x, e, PH_CHECK_END, w, given->dimension);
  } else {
    ph_check_heading(v, PH_CHECK_END, e->s, e->u,
                     ph_check_direction(w, given->dimension));
  }
}

/* ---- intervals -------------------------------------------------------------
 */

static void check_end(const struct context *x, const struct end *e) {
  bool outer = !x->v->curve->closed &&
               (e->u < 1 ? e->datum == 0 : e->datum == x->data.n);
  if (x->data.points) {
    check_point(x, e);
  } else if (outer && e->datum == 0) {
    check_start(x, e);
  }
  if (x->data.vectors) {
    check_vector(x, e);
  }
  if (outer && x->v->promise->ends) {
    check_ends(x, e);
  }
}

static void check_interval(const struct context *x, size_t i) {
  const struct ph_check_data *data = &x->data;
  struct ph_check_segment s;
  bool pair = data->last[i] == data->first[i] + 1;
  struct end e = {&s, 0, i, pair};
  ph_check_load(x->v, data->first[i], &s);
  check_end(x, &e);
  if (data->last[i] > data->first[i]) {
    ph_check_load(x->v, data->last[i], &s);
  }
  e.u = 1;
  e.datum = i + 1;
  check_end(x, &e);
}

/* Lengths that are to be reached. */
static void check_lengths(const struct context *x) {
  struct ph_check *v = x->v;
  const struct ph_value *given = ph_check_field(v, PH_F_LENGTHS);
  if (!v->promise->lengths || !given || ph_check_field(v, PH_F_LENGTH_SIGMA)) {
    return;
  }
  if (given->kind == PH_NUMBERS && given->n != x->data.n) {
    ph_check_wrong(v, PH_CHECK_SHAPE,
                   ph_check_of("segments", PH_CHECK_ONE, NULL),
                   "are not as many as the lengths of the problem");
    return;
  }
  for (size_t i = 0; i < x->data.n; i++) {
    double wanted = given->kind == PH_NUMBERS ? given->v[i] : given->number;
    double length = 0, allowance = 0;
    for (size_t k = x->data.first[i]; k <= x->data.last[i]; k++) {
      length += v->length[k];
      allowance += v->noise[k];
    }
    wanted = ph_check_scaled(v, wanted);
    ph_check_miss(v, PH_CHECK_PRESCRIBED, ph_check_of("intervals", i, "length"),
                  fabs(length - wanted), ph_check_larger(length, v->mean),
                  allowance, "misses what was prescribed");
  }
}

enum ph_status ph_check_solves(struct ph_check *v) {
  const struct ph_value *moved;
  struct context x = {.v = v};
  enum ph_status status = PH_OK;
  if (!v->problem || !is_asked_for(v)) {
    return PH_OK;
  }
  if (ph_check_is_approximation(v)) {
    return ph_check_approximation(v);
  }
  if (!ph_check_data_of(v, &x.data, &status)) {
    return status;
  }
  moved = ph_check_field(v, PH_F_RADIUS_TOLERANCE);
  x.moved = moved ? moved->number : MOVED;
  for (size_t i = 0; i < x.data.n && !ph_arena_late(v->scratch); i++) {
    check_interval(&x, i);
  }
  check_lengths(&x);
  return PH_OK;
}
