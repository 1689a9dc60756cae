/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A place on the offset of a PH or ATPH segment, or a cubic (see sample.h), at
 * a distance d along a normal e2 or e3 of the Euler-Rodrigues frame.
 *
 * In the plane, where e2 is the left normal and theta the angle of the tangent,
 * (1) o = r + d e2,  o' = (sigma - d theta') e1,  theta' = kappa sigma, so that
 *     the tangent is e1 or -e1 and the curvature theta' / |sigma - d theta'|.
 * (2) The length between two cusps is that of F(u) = s(u) - d theta(u).
 * (3) theta = 2 arg w.  From an end on, w is w0 + w0' p + w0'' q (seg3_fast.h),
 *     and arg(w / w0) = atan2(C, D), C = g p + h q, D = |w0|^2 + ..., with the
 *     cross products g, h and the scalar products of w0 with w0', w0''.
 * (4) C vanishes at the end, and again only where q / p = tan(a x / 2) / a is
 *     -g / h = c, thus p = 2 c / (1 + a^2 c^2).  There w is a multiple of w0:
 *     a negative one where D < 0, and from there on a whole turn is missing
 *     in (3), to the side to which C turned at first.
 *
 * In space, with coordinates in the frame, W = vect(A* A') and its derivatives
 * W1 = vect(A* A''), W2 = vect(A* A''' + A'* A'') = vect(A'* A'') - a^2 W, and
 * n = e2 or e3:
 * (5) the frame turns with Omega = 2 W / sigma: e' = Omega x e; so that
 *     sigma Omega' = 2 W1 - sigma' Omega,
 *     sigma Omega'' = 2 W2 - 2 sigma' Omega' - sigma'' Omega,
 *     sigma' = 2 A . A',  sigma'' = 2 A . A'' + 2 |A'|^2.
 * (6) o' = V = sigma e1 + d Omega x n,  o'' = V' + Omega x V,
 *     o''' = V'' + Omega x (V' + o'') + Omega' x V,
 *     V' and V'' by coordinates; curvature and torsion by their definitions.
 * (7) The length is the integral of |V|, as a table (kernel/primitive.h).
 *
 * Derived here; tested by t_sample_offset.c.  All of it is at the unit scale of
 * seg3_fast.h, but V, which is of the size of d where that is larger.  What
 * stands still has no offset, and is not asked for.
 */
#include "curve/kind/ph.h"

#include "curve/sample/chord_bound.h"
#include "curve/segment/seg3_fast.h"
#include "kernel/pi.h"
#include "kernel/primitive.h"

#include <float.h>
#include <string.h>

/* What is less than this of its terms is their rounding. */
static const double ROUNDING = 64 * DBL_EPSILON;
/* Of the length in space, relative. */
static const double TOLERANCE = 1e-14;

/* More cusps than a form of degree 8 has roots are none (curve/offset/cusp.h).
 */
enum { CUSPS_MAX = 8 };

/* (3) and (4) next to an end. */
struct turn {
  double norm2, dot[2]; /* D */
  double cross[2];      /* g and h */
  bool wraps;           /* D < 0 where C vanishes again */
};

/* A part between two cusps, of the plane. */
struct part {
  double from;
  double travel; /* F there */
  double before; /* the length up to there */
  double sign;   /* of 1 - d kappa */
};

struct state {
  struct ph_fast3 fast;
  enum ph_normal normal;
  struct ph_pow2 grow, shrink; /* of lengths, of curvatures */
  double distance;             /* at this scale */
  double unit;                 /* that of `fast`, at this scale */
  struct turn turn[2];
  double whole; /* F over the segment */
  struct part part[CUSPS_MAX + 1];
  size_t parts;
  struct ph_primitive table; /* of |V|, in space */
};

/* ---- in the plane -------------------------------------------------------- */

/* Im(conj(a) b) and Re(conj(a) b) of A = Re w + Im w k. */
static double cross(ph_quat a, ph_quat b) {
  return a.u * b.q - a.q * b.u;
}

static double dot(ph_quat a, ph_quat b) {
  return a.u * b.u + a.q * b.q;
}

static struct turn turn_of(const struct ph_fast3_end *end, double angle2) {
  const ph_quat *a = end->a;
  struct turn turn = {dot(a[0], a[0]),
                      {dot(a[0], a[1]), dot(a[0], a[2])},
                      {cross(a[0], a[1]), cross(a[0], a[2])},
                      false};
  const double c = -turn.cross[0] / turn.cross[1];
  const double p = 2 * c / (1 + angle2 * c * c);
  turn.wraps = turn.norm2 + p * (turn.dot[0] + c * turn.dot[1]) < 0;
  return turn;
}

/* arg(w / w0), positive to the left.  It is less than a right angle nearly
 * always, and atan takes 5 ns less than atan2. */
static double angle_at(const struct turn *turn,
                       const struct ph_fast3_place *at) {
  const double c = turn->cross[0] * at->p + turn->cross[1] * at->q;
  const double d = turn->norm2 + turn->dot[0] * at->p + turn->dot[1] * at->q;
  const double first = turn->cross[0] * at->x;
  const double angle = d > 0 ? atan(c / d) : atan2(c, d);
  return turn->wraps && c * first < 0 ? angle + copysign(2 * PH_PI, first)
                                      : angle;
}

/* F from the end of a place to it. */
static double travel_from(const struct state *state, size_t end,
                          const struct ph_fast3_place *at) {
  return ph_fast3_integral(at, at->end->s) -
         2 * state->distance * angle_at(&state->turn[end], at);
}

static double travel_at(const struct state *state, double u,
                        const struct ph_fast3_place *at) {
  return u > 0.5 ? state->whole + travel_from(state, 1, at)
                 : travel_from(state, 0, at);
}

/* theta' */
static double turning(ph_quat a, ph_quat first) {
  return 2 * cross(a, first) / dot(a, a);
}

/* F' = sigma (1 - d kappa) */
static double travel_rate(const struct state *state, ph_quat a, ph_quat first) {
  return dot(a, a) - state->distance * turning(a, first);
}

/* What of F' is rounding. */
static double travel_noise(const struct state *state, ph_quat a,
                           ph_quat first) {
  const double speed = dot(a, a);
  return ROUNDING *
         (speed + 2 * fabs(state->distance) * sqrt(dot(first, first) / speed));
}

static const struct part *part_at(const struct state *state, double u) {
  size_t i = state->parts - 1;
  while (i > 0 && !(u >= state->part[i].from)) {
    i--;
  }
  return &state->part[i];
}

/* The first of the cusps that is on segment k or later: they are in order, but
 * for that of the joint of a closed curve, which has u = 0. */
static size_t first_cusp(const struct ph_cusps *cusps, size_t k) {
  size_t low = 0, high = cusps->n;
  if (high > 1 && cusps->at[high - 1].segment < cusps->at[high - 2].segment) {
    high--;
  }
  while (low < high) {
    size_t middle = low + (high - low) / 2;
    if (cusps->at[middle].segment < k) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low;
}

/* The sign of 1 - d kappa in the middle of the longest part: it is the opposite
 * in the next ones, as it changes at a cusp. */
static void set_signs(struct state *state) {
  size_t longest = 0;
  double most = 0, middle = 0.5, sign;
  struct ph_fast3_place at;
  for (size_t i = 0; i < state->parts; i++) {
    double from = state->part[i].from;
    double to = i + 1 < state->parts ? state->part[i + 1].from : 1;
    if (to - from > most) {
      most = to - from;
      middle = 0.5 * (from + to);
      longest = i;
    }
  }
  at = ph_fast3_at(&state->fast, middle);
  sign = copysign(
      1, travel_rate(state, ph_fast3_preimage(&at), ph_fast3_first(&at)));
  for (size_t i = 0; i < state->parts; i++) {
    state->part[i].sign = (i + longest) % 2 == 0 ? sign : -sign;
  }
}

/* The length from the start of a part on, where F is so much. */
static double length_in(const struct part *part, double travel) {
  const double s = part->sign * (travel - part->travel);
  return s < 0 ? part->before : part->before + s;
}

/* Cuts the segment at its cusps; its length. */
static double cut(struct state *state, const struct ph_cusps *cusps, size_t k) {
  struct part *part = state->part;
  part[0] = (struct part){0, 0, 0, 1};
  state->parts = 1;
  for (size_t i = first_cusp(cusps, k);
       i < cusps->n && cusps->at[i].segment == k; i++) {
    double u = cusps->at[i].u;
    if (u > 0 && u < 1 && state->parts <= CUSPS_MAX) {
      struct ph_fast3_place at = ph_fast3_at(&state->fast, u);
      part[state->parts].from = u;
      part[state->parts++].travel = travel_at(state, u, &at);
    }
  }
  set_signs(state);
  for (size_t i = 1; i < state->parts; i++) {
    part[i].before = length_in(&part[i - 1], part[i].travel);
  }
  return length_in(&part[state->parts - 1], state->whole);
}

static double enter_plane(struct state *state, const struct ph_offset *offset,
                          size_t k) {
  const struct ph_fast3 *fast = &state->fast;
  struct ph_fast3_place left = ph_fast3_from(fast, 0, 0.5);
  struct ph_fast3_place right = ph_fast3_from(fast, 1, -0.5);
  for (size_t i = 0; i < 2; i++) {
    state->turn[i] = turn_of(&fast->end[i], fast->angle2);
  }
  state->whole = travel_from(state, 0, &left) - travel_from(state, 1, &right);
  return cut(state, &offset->cusps, k);
}

static double length_plane(const struct state *state, double u, double *speed) {
  const struct ph_fast3_place at = ph_fast3_at(&state->fast, u);
  *speed =
      fabs(travel_rate(state, ph_fast3_preimage(&at), ph_fast3_first(&at)));
  return length_in(part_at(state, u), travel_at(state, u, &at));
}

/* Point, tangent and curvature (1); none at a cusp. */
static struct ph_sample at_plane(const struct state *state, double distance,
                                 double u) {
  const struct ph_fast3_place place = ph_fast3_at(&state->fast, u);
  const struct part *part = part_at(state, u);
  const bool cusp = part > state->part && !(u > part->from);
  const ph_quat a = ph_fast3_preimage(&place);
  const ph_quat first = ph_fast3_first(&place);
  const double rate = fabs(travel_rate(state, a, first));
  const double per = 1 / dot(a, a);
  const ph_vec3 e1 = ph_vec3_scale(per, ph_quat_i(a, a));
  const ph_vec3 left = ph_vec3_of(-e1.y, e1.x, 0), none = {0, 0, 0};
  struct ph_sample sample = {.lonlat = {0, 0}};
  sample.point =
      ph_vec3_along(ph_fast3_point(&state->fast, &place), distance, left);
  sample.tangent = part->sign > 0 ? e1 : ph_vec3_sub(none, e1); /* no -0 */
  sample.curvature = sample.torsion = (double)NAN;
  if (!cusp && rate > travel_noise(state, a, first)) {
    sample.curvature = ph_pow2_apply(state->shrink, turning(a, first) / rate);
  }
  return sample;
}

/* ---- in space ------------------------------------------------------------ */

/* Omega x n */
static ph_vec3 side(enum ph_normal normal, ph_vec3 omega) {
  return normal == PH_E2 ? ph_vec3_of(-omega.z, 0, omega.x)
                         : ph_vec3_of(omega.y, -omega.x, 0);
}

/* V, V' or V'' from the derivative of sigma of that order and Omega's. */
static ph_vec3 velocity(const struct state *state, double speed,
                        ph_vec3 omega) {
  ph_vec3 v = ph_vec3_scale(state->distance, side(state->normal, omega));
  v.x += state->unit * speed;
  return v;
}

static ph_vec3 velocity_at(const struct state *state, ph_quat a,
                           ph_quat first) {
  const double speed = ph_quat_dot(a, a);
  const ph_vec3 w = ph_quat_vector(ph_quat_between(a, first));
  return velocity(state, speed, ph_vec3_scale(2 / speed, w));
}

static double speed_at(const void *context, double u) {
  const struct state *state = context;
  const struct ph_fast3_place at = ph_fast3_at(&state->fast, u);
  return ph_vec3_abs(
      velocity_at(state, ph_fast3_preimage(&at), ph_fast3_first(&at)));
}

/* Three derivatives of the offset (6), in the frame; |o'|, and what of it and
 * of o'' is rounding. */
struct motion {
  ph_vec3 o[3];
  double speed;
  double noise[2];
};

/* A bound of |a|, of no more than twice it. */
static double size(ph_quat a) {
  return fabs(a.u) + fabs(a.v) + fabs(a.p) + fabs(a.q);
}

static struct motion motion_of(const struct state *state, const ph_quat a[3],
                               double per) {
  const double speed = ph_quat_dot(a[0], a[0]), unit = state->unit;
  const double d = fabs(state->distance);
  const double a0 = size(a[0]), a1 = size(a[1]), a2 = size(a[2]);
  const ph_quat w = ph_quat_between(a[0], a[1]);
  const ph_quat w1 = ph_quat_between(a[0], a[2]);
  const ph_vec3 w2 = ph_vec3_along(ph_quat_vector(ph_quat_between(a[1], a[2])),
                                   -state->fast.angle2, ph_quat_vector(w));
  const double s1 = 2 * w.u, s2 = 2 * (w1.u + ph_quat_dot(a[1], a[1]));
  const ph_vec3 turn = ph_vec3_scale(2 * per, ph_quat_vector(w));
  const ph_vec3 turn1 = ph_vec3_along(
      ph_vec3_scale(2 * per, ph_quat_vector(w1)), -s1 * per, turn);
  const ph_vec3 turn2 = ph_vec3_along(
      ph_vec3_along(ph_vec3_scale(2 * per, w2), -2 * s1 * per, turn1),
      -s2 * per, turn);
  const ph_vec3 v = velocity(state, speed, turn);
  const ph_vec3 v1 = velocity(state, s1, turn1);
  struct motion m;
  m.o[0] = v;
  m.o[1] = ph_vec3_add(v1, ph_vec3_cross(turn, v));
  m.o[2] = ph_vec3_add(
      ph_vec3_add(velocity(state, s2, turn2), ph_vec3_cross(turn1, v)),
      ph_vec3_cross(turn, ph_vec3_add(v1, m.o[1])));
  m.speed = ph_vec3_abs(v);
  m.noise[0] = ROUNDING * (unit * speed + d * per * (a0 * a1));
  m.noise[1] = ROUNDING * (unit * a0 * a1 + d * per * (a0 * a2)) +
               m.noise[0] * (per * (a0 * a1));
  return m;
}

/* Curvature and torsion at unit scale, by their definitions, where the offset
 * moves. */
static void curvature_at(const struct motion *m, struct ph_sample *sample) {
  const ph_vec3 across = ph_vec3_cross(m->o[0], m->o[1]);
  const double square = ph_vec3_dot(across, across), c = sqrt(square);
  sample->curvature = c / (m->speed * m->speed * m->speed);
  if (c > m->speed * m->noise[1] + m->noise[0] * ph_vec3_abs(m->o[1])) {
    sample->torsion = ph_vec3_dot(across, m->o[2]) / square;
  }
}

/* The direction of o', in the frame: where that is 0, its limit. */
static ph_vec3 direction(const struct motion *m, double u) {
  return m->speed > m->noise[0] ? ph_vec3_scale(1 / m->speed, m->o[0])
         : ph_vec3_abs(m->o[1]) > m->noise[1]
             ? ph_vec3_scale(u < 1 ? 1 : -1, ph_vec3_unit(m->o[1]))
             : ph_vec3_unit(m->o[2]);
}

static struct ph_sample at_space(const struct state *state, double distance,
                                 double u) {
  const struct ph_fast3 *fast = &state->fast;
  const struct ph_fast3_place place = ph_fast3_at(fast, u);
  const ph_quat a[3] = {ph_fast3_preimage(&place), ph_fast3_first(&place),
                        ph_fast3_second(fast, &place)};
  const double per = 1 / ph_quat_dot(a[0], a[0]);
  const ph_vec3 e[3] = {ph_vec3_scale(per, ph_quat_i(a[0], a[0])),
                        ph_vec3_scale(per, ph_quat_j(a[0], a[0])),
                        ph_vec3_scale(per, ph_quat_k(a[0], a[0]))};
  const struct motion m = motion_of(state, a, per);
  const ph_vec3 t = direction(&m, u);
  struct ph_sample sample;
  sample.lonlat[0] = sample.lonlat[1] = 0;
  sample.point = ph_vec3_along(ph_fast3_point(fast, &place), distance,
                               state->normal == PH_E2 ? e[1] : e[2]);
  sample.tangent = ph_vec3_along(
      ph_vec3_along(ph_vec3_scale(t.x, e[0]), t.y, e[1]), t.z, e[2]);
  sample.curvature = sample.torsion = (double)NAN;
  if (m.speed > m.noise[0]) {
    curvature_at(&m, &sample);
    sample.curvature = ph_pow2_apply(state->shrink, sample.curvature);
    sample.torsion = ph_pow2_apply(state->shrink, sample.torsion);
  }
  return sample;
}

/* Tabulates the length; it is NaN where it was not found. */
static enum ph_status enter_space(struct state *state,
                                  const struct ph_offset *offset, size_t k,
                                  struct ph_arena *arena, double *length) {
  const struct ph_cusps *cusps = &offset->cusps;
  double breaks[CUSPS_MAX];
  size_t n = 0;
  enum ph_status status;
  for (size_t i = first_cusp(cusps, k);
       i < cusps->n && cusps->at[i].segment == k; i++) {
    double u = cusps->at[i].u;
    if (u > (n > 0 ? breaks[n - 1] : 0) && u < 1 && n < CUSPS_MAX) {
      breaks[n++] = u;
    }
  }
  status = ph_primitive_make(&state->table, speed_at, state, breaks, n,
                             TOLERANCE, arena);
  *length = status == PH_OK ? state->table.total : (double)NAN;
  return status == PH_E_NO_MEMORY ? status : PH_OK;
}

/* ---- the interface ------------------------------------------------------- */

enum ph_status ph_beside_begin(struct ph_sampler *sampler,
                               struct ph_diag *diag) {
  const char *vector = sampler->offset->vector;
  struct state *state = ph_arena_array(sampler->arena, 1, sizeof *state);
  sampler->state = state;
  if (!state) {
    return ph_fail_memory(diag);
  }
  memset(&state->table, 0, sizeof state->table);
  state->normal = vector && strcmp(vector, "e3") == 0 ? PH_E3 : PH_E2;
  return PH_OK;
}

/* The scale: in space V is as large as the larger of sigma and d, which is its
 * unit, so that products of its derivatives are in range. */
static void set_scale(struct state *state, double distance, bool space) {
  const int unit = state->fast.exponent;
  int larger = unit;
  if (space && (distance < 0 || distance > 0)) {
    larger = ilogb(distance) > unit ? ilogb(distance) : unit;
  }
  state->grow = ph_pow2_of(larger);
  state->shrink = ph_pow2_of(-larger);
  state->distance = ph_pow2_apply(state->shrink, distance);
  state->unit = ldexp(1, unit - larger);
}

enum ph_status ph_beside_enter(struct ph_sampler *sampler,
                               struct ph_diag *diag) {
  struct state *state = sampler->state;
  const struct ph_offset *offset = sampler->offset;
  enum ph_status status = PH_OK;
  double length;
  ph_fast3_of(sampler->curve, sampler->k, &state->fast);
  set_scale(state, offset->distance, sampler->curve->dimension == 3);
  if (sampler->curve->dimension == 2) {
    length = enter_plane(state, offset, sampler->k);
  } else {
    status = enter_space(state, offset, sampler->k, sampler->arena, &length);
  }
  sampler->length = ph_pow2_apply(state->grow, length);
  return status == PH_OK ? PH_OK : ph_fail_memory(diag);
}

double ph_beside_length(const struct ph_sampler *sampler, double u,
                        double *speed) {
  const struct state *state = sampler->state;
  double s = (double)NAN;
  *speed = (double)NAN;
  if (sampler->curve->dimension == 2) {
    s = length_plane(state, u, speed);
  } else if (!isnan(sampler->length)) {
    s = ph_primitive_at(&state->table, u, speed);
  }
  *speed = ph_pow2_apply(state->grow, *speed);
  return ph_pow2_apply(state->grow, s);
}

struct ph_sample ph_beside_at(const struct ph_sampler *sampler, double u) {
  const struct state *state = sampler->state;
  const double distance = sampler->offset->distance;
  return sampler->curve->dimension == 2 ? at_plane(state, distance, u)
                                        : at_space(state, distance, u);
}

double ph_beside_chord_bound(const struct ph_sampler *sampler, double u0,
                             double u1) {
  const struct state *state = sampler->state;
  const double distance =
      ph_pow2_apply(state->fast.shrink, sampler->offset->distance);
  return ph_pow2_apply(
      state->fast.grow,
      ph_chord_bound_offset(&state->fast.seg, state->normal, distance, u0, u1));
}
