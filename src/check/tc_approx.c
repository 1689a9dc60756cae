/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The certificate of Tschirnhausen cubics that approximate a chain of Bezier
 * curves (see certify.h).
 *
 * The knots say which part of the chain a cubic stands for.  A joint is on the
 * curve there and has its tangent, or it is the inner joint of a pair: then
 * both joints next to it are, and the pair is C1.
 */
#include "check/tc_approx.h"

#include "check/note.h"
#include "check/tc_check.h"
#include "check/tc_distance.h"
#include "kernel/bern_low.h"

#include <float.h>
#include <math.h>
#include <stdint.h>

static const double POSITION = 1e-13;
static const double DIRECTION = 1e-12;

/* The tolerance is not exceeded by more. */
static const double TOLERANCE = 1e-9;

/* Rounding of control points that were written, in that of a coordinate. */
enum { ROUND_POINTS = 4 };

/* Steps to the point of the curve that is nearest to a joint. */
enum { STEPS = 4 };

/* One Bezier curve of the chain, with its start as the origin. */
struct piece {
  ph_cplx origin;
  ph_cplx *p, *leg; /* [degree + 1], [degree]: of the hodograph */
  size_t degree;
  double reach, speed, second; /* largest |p|, |r'|, |r''|, not underrated */
};

struct context {
  struct ph_tc_check c;
  struct ph_check_distance distance;
  const double *points; /* of all pieces, at the scale of the user */
  const size_t *sizes;  /* control points of each */
  size_t pieces, next;  /* how many; the control points of those before */
  struct piece piece;   /* number `at` */
  size_t at;
  size_t farthest; /* the cubic with the largest distance */
};

/* A place on the curve. */
struct place {
  ph_cplx point, derivative; /* by the parameter of the piece */
  double error;              /* of the point, and */
  double turned;             /* of the direction; 1 or more: it has none */
};

/* A joint as seen from the cubic that ends there. */
struct joint {
  bool on;          /* the curve, with its tangent */
  bool has_tangent; /* the curve has one */
  double t;         /* the parameter that it is matched with */
};

/* ---- the given curve ---------------------------------------------------- */

static void next_piece(struct context *x) {
  struct piece *piece = &x->piece;
  const double *p = x->points + 2 * x->next;
  size_t n = x->sizes[x->at] - 1;
  piece->degree = n;
  piece->origin = ph_tc_check_scaled(&x->c, p);
  piece->reach = piece->speed = piece->second = 0;
  for (size_t i = 0; i <= n; i++) {
    piece->p[i] =
        ph_cplx_sub(ph_tc_check_scaled(&x->c, p + 2 * i), piece->origin);
    piece->reach = ph_check_larger(piece->reach, ph_cplx_abs(piece->p[i]));
  }
  for (size_t i = 0; i < n; i++) {
    piece->leg[i] =
        ph_cplx_scale((double)n, ph_cplx_sub(piece->p[i + 1], piece->p[i]));
    piece->speed = ph_check_larger(piece->speed, ph_cplx_abs(piece->leg[i]));
  }
  for (size_t i = 0; i + 1 < n; i++) {
    ph_cplx second = ph_cplx_sub(piece->leg[i + 1], piece->leg[i]);
    piece->second =
        ph_check_larger(piece->second, (double)(n - 1) * ph_cplx_abs(second));
  }
  ph_check_distance_curve(&x->distance, piece->p, n);
  x->next += n + 1;
}

/* At a local parameter; errors are those of the knot and of evaluation. */
static struct place place_of(const struct context *x, double t) {
  const struct piece *piece = &x->piece;
  double knot = 2 * DBL_EPSILON * (double)(x->at + 1);
  double rounding = 2 * DBL_EPSILON * (double)(piece->degree + 1);
  struct place place;
  double speed;
  place.point = ph_bern_value(piece->p, piece->degree, t);
  place.derivative = ph_bern_value(piece->leg, piece->degree - 1, t);
  place.error = knot * piece->speed + rounding * piece->reach;
  speed = ph_cplx_abs(place.derivative);
  place.turned = (knot * piece->second + rounding * piece->speed) / speed;
  return place;
}

/* ---- joints ------------------------------------------------------------- */

/* How far an end of a cubic is from a place, and what is allowed. */
static double apart(const struct context *x, const struct ph_tc_cubic *s,
                    size_t end, const struct place *place, double *allowed) {
  ph_cplx at = ph_cplx_sub(s->p[3 * end], x->piece.origin);
  *allowed = POSITION * x->c.scale.size + s->allowance + place->error;
  return ph_cplx_abs(ph_cplx_sub(at, place->point));
}

/* Where the curve all but stands still, it may turn back, or be said to. */
static bool has_tangent(const struct place *place) {
  return place->turned < 0.01;
}

static void check_end(struct context *x, const struct ph_tc_cubic *s, size_t k,
                      size_t end, const struct place *place) {
  double allowed, away = apart(x, s, end, place, &allowed);
  ph_check_add(&x->c.point, k, away, x->c.scale.size, allowed);
  if (has_tangent(place)) {
    ph_tc_check_tangent(&x->c, s, k, end,
                        ph_tc_check_direction(place->derivative),
                        place->turned);
  }
}

/* Whether the end of a cubic is on the curve, with its tangent if rounding has
 * left both one. */
static bool is_on(const struct context *x, const struct ph_tc_cubic *s,
                  const struct place *place) {
  double allowed, away = apart(x, s, 1, place, &allowed);
  double size = ph_cplx_abs(s->h[2]);
  double error = place->turned + (size > 0 ? s->allowance / size : 1);
  ph_cplx miss = ph_cplx_sub(ph_tc_check_direction(s->h[2]),
                             ph_tc_check_direction(place->derivative));
  return away <= allowed &&
         (!(error < 1) || ph_cplx_abs(miss) <= DIRECTION + error);
}

/* The parameter in (from, to) of a point of the curve that is near to an inner
 * joint: from t on by steps that are taken as long as they help. */
static double nearest(const struct context *x, ph_cplx joint, double from,
                      double t, double to) {
  ph_cplx p = ph_cplx_sub(joint, x->piece.origin);
  struct place place = place_of(x, t);
  double away = ph_cplx_abs(ph_cplx_sub(p, place.point));
  for (int i = 0; i < STEPS; i++) {
    double u = t + ph_cplx_dot(ph_cplx_sub(p, place.point), place.derivative) /
                       ph_cplx_norm2(place.derivative);
    double there;
    if (!(u > from && u < to)) {
      break;
    }
    place = place_of(x, u);
    there = ph_cplx_abs(ph_cplx_sub(p, place.point));
    if (!(there < away)) {
      break;
    }
    t = u;
    away = there;
  }
  return t;
}

/* The end of cubic k, which began at `before`. */
static struct joint check_joint(struct context *x, const struct ph_tc_cubic *s,
                                size_t k, const struct joint *before) {
  const double *knots = x->c.curve->knots, start = (double)x->at;
  double t = knots[k + 1] - start;
  struct place place = place_of(x, t);
  struct joint joint = {.has_tangent = has_tangent(&place), .t = t};
  joint.on = is_on(x, s, &place);
  if (joint.on || !before->on || t >= 1) {
    check_end(x, s, k, 1, &place);
    joint.on = true;
  } else {
    joint.t = nearest(x, s->p[3], knots[k] - start, t, knots[k + 2] - start);
  }
  return joint;
}

/* Between cubic k and the one before it in the same piece. */
static void check_inside(struct context *x, const struct ph_tc_cubic *a,
                         const struct ph_tc_cubic *b, size_t k,
                         const struct joint *joint) {
  const double *knots = x->c.curve->knots;
  double before = knots[k] - knots[k - 1], after = knots[k + 1] - knots[k];
  if (joint->has_tangent || !joint->on) {
    ph_tc_check_joint(&x->c, a, b, k);
  } else {
    ph_tc_check_gap(&x->c, a, b, k);
  }
  if (!joint->on) {
    double knot = 2 * DBL_EPSILON * knots[k + 1];
    ph_tc_check_c1(&x->c, a, b, k, after / before,
                   2 * knot * (1 / before + 1 / after));
  }
}

static void add_distance(struct context *x, const struct ph_tc_cubic *s,
                         size_t k, double from, double to) {
  double before = x->distance.bound;
  ph_cplx p[4];
  for (size_t i = 0; i < 4; i++) {
    p[i] = ph_cplx_sub(s->p[i], x->piece.origin);
  }
  ph_check_distance_add(&x->distance, from, to, p);
  if (!(x->distance.bound <= before)) {
    x->farthest = k;
  }
}

/* ---- the whole ---------------------------------------------------------- */

static void check_cubics(struct context *x) {
  const struct ph_curve *curve = x->c.curve;
  struct ph_tc_cubic start, before, now;
  struct joint joint = {.on = true, .t = 1};
  for (size_t k = 0; k < curve->n && !(k > 0 && ph_arena_late(x->c.arena));
       k++) {
    struct joint end;
    now = ph_tc_check_load(&x->c, k);
    ph_tc_check_cubic(&x->c, &now, k);
    if (k == 0) {
      start = now;
    }
    if (joint.t >= 1) {
      struct place place;
      x->at += k > 0;
      next_piece(x);
      place = place_of(x, 0);
      check_end(x, &now, k, 0, &place);
      if (k > 0) {
        ph_tc_check_gap(&x->c, &before, &now, k);
      }
      joint = (struct joint){.on = true, .t = 0};
    } else {
      check_inside(x, &before, &now, k, &joint);
    }
    end = check_joint(x, &now, k, &joint);
    add_distance(x, &now, k, joint.t, end.t);
    joint = end;
    before = now;
  }
  if (curve->closed) {
    ph_tc_check_gap(&x->c, &before, &start, 0);
  }
}

/* Knots increase, from 0 to the number of pieces, and pass through the numbers
 * between. */
static enum ph_status check_knots(const struct context *x,
                                  struct ph_diag *diag) {
  const double *t = x->c.curve->knots;
  size_t n = x->c.curve->n, piece = 0, bad = n + 1;
  if (!(fabs(t[0]) <= 0)) {
    bad = 0;
  }
  for (size_t k = 0; k < n && bad > n; k++) {
    double end = (double)piece + 1;
    bool reached = t[k + 1] >= end;
    if (!(t[k + 1] > t[k]) || !(t[k + 1] <= end) || piece == x->pieces) {
      bad = k + 1;
    }
    piece += reached;
  }
  if (bad > n && piece != x->pieces) {
    bad = n;
  }
  return bad > n ? PH_OK
                 : ph_fail_at(diag, PH_E_INTERNAL, "knots", bad,
                              "is %.17g, which does not fit %zu curves", t[bad],
                              x->pieces);
}

/* What is allowed of the distance, in the unit of the data: the tolerance, if
 * there is one. */
static double distance_allowed(const struct ph_problem *problem) {
  const struct ph_value *tolerance = &problem->field[PH_F_TOLERANCE];
  return tolerance->kind == PH_NUMBER ? tolerance->number : HUGE_VAL;
}

/* What is claimed of it, or allowed: worth looking for. */
static double distance_wanted(const struct ph_problem *problem,
                              const struct ph_diagnostics *diagnostics) {
  double allowed = distance_allowed(problem);
  return ph_diagnostics_known(diagnostics, PH_D_DISTANCE)
             ? ph_check_smaller(diagnostics->value[PH_D_DISTANCE], allowed)
             : allowed;
}

/* ... at unit scale, with what the rounding of control points makes of it. */
static double allowed_at_unit(const struct ph_tc_check *c, double allowed) {
  return ph_pow2_apply(c->scale.to_unit, allowed) +
         ROUND_POINTS * c->scale.rounding;
}

/* The bound that was found here is what is told, and judged by the tolerance; a
 * claim that it confirms, but for rounding, may be a little less. */
static enum ph_status check_distance(const struct context *x,
                                     const struct ph_problem *problem,
                                     struct ph_diagnostics *diagnostics,
                                     struct ph_diag *diag) {
  const struct ph_pow2 unit = x->c.scale.to_unit;
  const struct ph_pow2 back = {1 / unit.first, 1 / unit.second};
  const struct ph_check_distance *d = &x->distance;
  double wanted = distance_wanted(problem, diagnostics);
  double allowed = allowed_at_unit(&x->c, distance_allowed(problem));
  struct ph_check_error check = {.what = PH_D_DISTANCE};
  const struct ph_check_error *const one = &check;
  allowed = (1 + TOLERANCE) * allowed + d->noise;
  ph_check_add(&check, x->farthest, ph_pow2_apply(back, d->bound), 1,
               ph_pow2_apply(back, allowed));
  if (d->bound <= (1 + TOLERANCE) * allowed_at_unit(&x->c, wanted) + d->noise) {
    check.reported = ph_check_smaller(check.reported, wanted);
  }
  return ph_check_conclude(&one, 1, diagnostics, diag);
}

/* The control points of the chain, and those of each curve in it. */
static enum ph_status begin(struct context *x, const struct ph_problem *problem,
                            const struct ph_curve *curve,
                            struct ph_arena *scratch, double allowed,
                            struct ph_diag *diag) {
  const struct ph_value *chain = &problem->field[PH_F_CURVE];
  size_t most = 0, least = SIZE_MAX;
  enum ph_status status;
  if (chain->kind == PH_ABSENT) {
    chain = &problem->field[PH_F_POINTS];
  }
  x->points = chain->v;
  x->sizes = chain->kind == PH_POLYLINE ? chain->sizes : &chain->n;
  x->pieces = chain->kind == PH_POLYLINE ? chain->sizes_n : 1;
  for (size_t i = 0; i < x->pieces; i++) {
    most = x->sizes[i] > most ? x->sizes[i] : most;
    least = x->sizes[i] < least ? x->sizes[i] : least;
  }
  if ((chain->kind != PH_POLYLINE && chain->kind != PH_VECTORS) ||
      chain->dimension != 2 || least < 2) {
    return ph_fail(diag, PH_E_INTERNAL, "curve", "is none in the plane");
  }
  status = ph_tc_check_begin(&x->c, curve, scratch, chain->v, chain->n, diag);
  if (status != PH_OK) {
    return status;
  }
  x->piece.p = ph_arena_array(scratch, most, sizeof *x->piece.p);
  x->piece.leg = ph_arena_array(scratch, most, sizeof *x->piece.leg);
  return x->piece.p && x->piece.leg &&
                 ph_check_distance_begin(&x->distance, scratch, most,
                                         allowed_at_unit(&x->c, allowed))
             ? PH_OK
             : ph_fail_memory(diag);
}

static enum ph_status certify(struct context *x,
                              const struct ph_problem *problem,
                              struct ph_diagnostics *diagnostics,
                              struct ph_diag *diag) {
  const struct ph_value *pieces = &problem->field[PH_F_PIECES];
  size_t n = x->c.curve->n;
  enum ph_status status = check_knots(x, diag);
  if (status != PH_OK) {
    return status;
  }
  if (pieces->kind == PH_NUMBER && !((double)n <= pieces->number)) {
    return ph_fail(
        diag, PH_E_NO_CONVERGENCE, "segments",
        "is refused by its certificate: there are %zu, at most %.17g "
        "are allowed",
        n, pieces->number);
  }
  check_cubics(x);
  status = ph_tc_check_conclude(&x->c, false, diagnostics, diag);
  return status == PH_OK ? check_distance(x, problem, diagnostics, diag)
                         : status;
}

enum ph_status ph_check_tc_approximation(struct ph_check *v,
                                         struct ph_diagnostics *diagnostics) {
  double allowed = distance_wanted(v->problem, diagnostics);
  struct context x = {.next = 0};
  enum ph_status status =
      begin(&x, v->problem, v->curve, v->scratch, allowed, v->diag);
  return status == PH_OK ? certify(&x, v->problem, diagnostics, v->diag)
                         : status;
}
