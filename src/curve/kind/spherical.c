/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Spherical nu-splines (see kind.h), on the unit sphere first, and offsets on
 * the sphere: parallel curves at a geodesic distance.
 *
 * On the unit sphere, with d the distance over the radius, T the unit tangent
 * and kappa the geodesic curvature of the curve S, and primes by its parameter,
 *
 *   O = cos d S + sin d (S x T)                                         (1)
 *   O' = g T,  g = cos d |S'| - sin d kappa |S'|                        (2)
 *   kappa of O = (cos d kappa + sin d) / |cos d - kappa sin d|          (3)
 *
 * O moves against T where g < 0; its tangent is -T there, and (3) is its
 * curvature to the left of its own travel.  Where g changes its sign, at
 * cot d = kappa, O has a cusp and no curvature.
 *
 * Where the curve rests (S' = 0, as at rest ends) kappa is not finite, but
 * kappa |S'| is: O goes round the point at rest as a circle of radius d, until
 * it meets the curve's parallel at a cusp, or without one.  Nothing of this
 * needs an exception in (2) and (3).
 */
#include "curve/kind/kind.h"
#include "curve/sample/chord_bound.h"
#include "curve/segment/spherical_fast.h"
#include "kernel/degree.h"
#include "kernel/golden.h"
#include "kernel/pi.h"
#include "kernel/primitive.h"

#include <float.h>

/* What is less than this of its terms is their rounding. */
static const double ROUNDING = 64 * DBL_EPSILON;

/* The same of S' alone, at rest, where |S''| + |S'''| bounds the legs that it
 * is a sum of: its direction is known before K is. */
static const double REST = 2 * DBL_EPSILON;

/*
 * How a point moves on the unit sphere, also where it is at rest: with S' = t V
 * next to rest at t = 0, K = S . (S' x S'') = t^2 K'' / 2, so that K / |S'|^2 =
 * S . (S'' x S''') / (2 |S''|^2) in the limit, whatever the curvature does.
 */
struct motion {
  ph_vec3 s;       /* S */
  ph_vec3 tangent; /* unit; NaN where the segment is a point */
  double speed;    /* |S'|, 0 at rest */
  double turn;     /* K / |S'|^2: geodesic curvature times speed */
  double noise;    /* error of turn: some eps times this */
};

/* Along which the curve goes at or next to rest: S', S'' or S''', the first of
 * them that is known.  Before rest S' is -S''. */
static ph_vec3 direction_slow(const ph_vec3 jet[4], double u) {
  double second = ph_vec3_abs(jet[2]), third = ph_vec3_abs(jet[3]);
  bool back = u > 0 && (u >= 1 || ph_vec3_dot(jet[1], jet[2]) < 0);
  if (ph_vec3_abs(jet[1]) > REST * (second + third)) {
    return jet[1];
  }
  return !(second > ROUNDING * third) ? jet[3]
                                      : ph_vec3_scale(back ? -1 : 1, jet[2]);
}

/* The motion at or next to rest, where S'' and S''' say what S' does not. */
static struct motion motion_slow(const struct ph_spherical *segment, double u) {
  struct motion motion = {.speed = 0};
  ph_vec3 jet[4];
  double first, second, third;
  ph_spherical_jet(segment, u, jet);
  jet[1] = ph_vec3_normal(jet[1], jet[0]);
  first = ph_vec3_abs(jet[1]);
  second = ph_vec3_abs(jet[2]);
  third = ph_vec3_abs(jet[3]);
  motion.s = jet[0];
  if (first > ROUNDING * (second + third)) {
    motion.speed = first;
    motion.turn = ph_vec3_triple(jet[0], jet[1], jet[2]) / (first * first);
    motion.noise = second / first;
  } else {
    double k = ph_vec3_triple(jet[0], jet[2], jet[3]);
    motion.turn =
        fabs(k) > ROUNDING * second * third ? 0.5 * k / (second * second) : 0;
  }
  /* S'' and S''' need not be normal to S. */
  motion.tangent = ph_vec3_unit(ph_vec3_normal(direction_slow(jet, u), jet[0]));
  return motion;
}

/* From S, S' and S'', of which S' is changed. */
static struct motion motion_of(const struct ph_spherical_fast *fast, double u,
                               ph_vec3 jet[3]) {
  struct motion motion;
  double square, second;
  jet[1] = ph_vec3_normal(jet[1], jet[0]);
  square = ph_vec3_dot(jet[1], jet[1]);
  second = ph_vec3_dot(jet[2], jet[2]);
  if (!(square > ROUNDING * ROUNDING * second)) {
    return motion_slow(&fast->segment, u);
  }
  motion.s = jet[0];
  motion.speed = sqrt(square);
  motion.turn = ph_vec3_triple(jet[0], jet[1], jet[2]) / square;
  motion.noise = sqrt(second / square);
  motion.tangent = ph_vec3_unit(jet[1]);
  return motion;
}

static struct motion motion_at(const struct ph_spherical_fast *fast, double u) {
  ph_vec3 jet[3];
  ph_spherical_fast_jet(fast, u, jet);
  return motion_of(fast, u, jet);
}

/* Where a point of the unit sphere is in the user's unit. */
static ph_vec3 placed(const struct ph_curve *curve, ph_vec3 s) {
  return ph_vec3_along(ph_vec3_get(curve->sphere.center, 3),
                       curve->sphere.radius, s);
}

/* The point, which at the ends is as given: without a rounding of its own. */
static ph_vec3 point_at(const struct ph_curve *curve, size_t k, double u,
                        ph_vec3 s) {
  const double *p = curve->control_points + 12 * k;
  return !(u > 0)   ? ph_vec3_get(p, 3)
         : !(u < 1) ? ph_vec3_get(p + 9, 3)
                    : placed(curve, s);
}

/* g of (2), how fast the parallel at the distance of this cosine and sine goes
 * along the tangent; 0 where g is nothing but rounding: at a cusp, or
 * everywhere in the center of a circle. */
static double parallel_speed(const struct motion *motion, double cosine,
                             double sine) {
  double speed = cosine * motion->speed - sine * motion->turn;
  double terms = fabs(cosine) * motion->speed +
                 fabs(sine) * (motion->noise + motion->speed);
  return fabs(speed) > ROUNDING * terms ? speed : 0;
}

/* ---- one segment --------------------------------------------------------- */

/* A segment of a curve, or of its parallel. */
struct state {
  struct ph_spherical_fast segment;
  double angle, cosine, sine; /* d; 0 of the curve itself */
  struct ph_primitive length; /* by u, on the unit sphere */
  double scale;               /* to the unit of the data */
  double *breaks;             /* u of cusps, those of the segment at next */
  size_t breaks_n, next;
  double *places; /* these and corners of the speed */
  size_t places_n;
};

static enum ph_status begin(struct ph_sampler *sampler, struct ph_diag *diag) {
  const struct ph_offset *offset = sampler->offset;
  const size_t n = offset ? offset->cusps.n : 0;
  struct state *state = ph_arena_array(sampler->arena, 1, sizeof *state);
  double *breaks = ph_arena_array(sampler->arena, n + 1, sizeof *breaks);
  double *places =
      ph_arena_array(sampler->arena, n + PH_SPHERICAL_CORNERS, sizeof *places);
  if (!state || !breaks || !places) {
    return ph_fail_memory(diag);
  }
  *state = (struct state){.breaks = breaks, .places = places, .cosine = 1};
  if (offset) {
    state->angle = offset->distance / sampler->curve->sphere.radius;
    state->cosine = cos(state->angle);
    state->sine = sin(state->angle);
  }
  for (size_t i = 0; i < n; i++) {
    breaks[i] = offset->cusps.at[i].u;
  }
  sampler->state = state;
  return PH_OK;
}

/* Goes to the cusps within segment k; those at its start do not count. */
static void find_breaks(struct state *state, const struct ph_offset *offset,
                        size_t k) {
  const struct ph_place *at = offset->cusps.at;
  const size_t n = offset->cusps.n;
  size_t i = state->next + state->breaks_n;
  if (i > 0 && at[i - 1].segment >= k) {
    i = 0;
  }
  while (i < n && (at[i].segment < k || (at[i].segment == k && at[i].u <= 0))) {
    i++;
  }
  state->next = i;
  while (i < n && at[i].segment == k && at[i].u < 1) {
    i++;
  }
  state->breaks_n = i - state->next;
}

/* The places where the length is split, in order. */
static void merge_places(struct state *state) {
  const double *breaks = state->breaks + state->next;
  double corner[PH_SPHERICAL_CORNERS];
  size_t n = ph_spherical_corners(&state->segment.segment, corner);
  size_t i = 0, j = 0;
  while (i < n || j < state->breaks_n) {
    bool is_corner = j == state->breaks_n || (i < n && corner[i] < breaks[j]);
    state->places[i + j] = is_corner ? corner[i] : breaks[j];
    i += is_corner;
    j += !is_corner;
  }
  state->places_n = i + j;
}

/* |g| */
static double speed_at(const void *context, double u) {
  const struct state *state = context;
  struct motion motion = motion_at(&state->segment, u);
  return fabs(parallel_speed(&motion, state->cosine, state->sine));
}

/* How well the length of a segment can be known: as |g|, which is a difference
 * of what may be much larger. */
static double precision_of(const struct state *state) {
  enum { PLACES = 8 };
  static const double least = 1e-14, rounding = 4 * DBL_EPSILON;
  double terms = 0, speed = 0;
  for (int i = 0; i < PLACES; i++) {
    struct motion motion = motion_at(&state->segment, (i + 0.5) / PLACES);
    speed += fabs(parallel_speed(&motion, state->cosine, state->sine));
    terms += fabs(state->cosine) * motion.speed +
             fabs(state->sine) * (motion.noise + motion.speed);
  }
  return fmax(least, rounding * terms / fmax(speed, DBL_MIN));
}

/* Beside a turn that is nearly a cusp |g| is known to much less; a length to
 * 1e-9 is still one. */
static enum ph_status tabulate(struct ph_sampler *sampler) {
  enum { TRIES = 6 };
  struct state *state = sampler->state;
  double precision = precision_of(state);
  enum ph_status status = PH_E_NO_CONVERGENCE;
  for (int i = 0; i < TRIES && status == PH_E_NO_CONVERGENCE; i++) {
    status = ph_primitive_make(&state->length, speed_at, state, state->places,
                               state->places_n, precision, sampler->arena);
    precision *= 10;
  }
  return status;
}

static enum ph_status enter(struct ph_sampler *sampler, struct ph_diag *diag) {
  const struct ph_curve *curve = sampler->curve;
  struct state *state = sampler->state;
  struct ph_spherical segment;
  enum ph_status status;
  segment = ph_spherical_of(curve, sampler->k);
  ph_spherical_fast_of(&segment, &state->segment);
  state->scale = curve->sphere.radius;
  sampler->length = (double)NAN;
  if (sampler->offset) {
    find_breaks(state, sampler->offset, sampler->k);
  }
  merge_places(state);
  status = tabulate(sampler);
  if (status == PH_E_NO_MEMORY) {
    return ph_fail_memory(diag);
  }
  if (status != PH_OK) {
    return sampler->offset
               ? ph_fail_at(diag, status, "segments", sampler->k,
                            "has an offset at distance %g whose length was not "
                            "found",
                            sampler->offset->distance)
               : ph_fail_at(diag, status, "segments", sampler->k,
                            "has a length that was not found");
  }
  sampler->length = curve->sphere.radius * state->length.total;
  if (!sampler->offset) {
    double found = sampler->length;
    sampler->length = curve->lengths[sampler->k];
    state->scale *= found > 0 ? sampler->length / found : 1;
  }
  return PH_OK;
}

static double length(const struct ph_sampler *sampler, double u,
                     double *speed) {
  const struct state *state = sampler->state;
  double s = state->scale * ph_primitive_at(&state->length, u, speed);
  *speed *= state->scale;
  return !(u < 1) ? sampler->length : s < sampler->length ? s : sampler->length;
}

static double chord_bound(const struct ph_sampler *sampler, double u0,
                          double u1) {
  const struct state *state = sampler->state;
  return sampler->curve->sphere.radius *
         ph_chord_bound_spherical(&state->segment.segment, state->angle, u0,
                                  u1);
}

/* ---- one place ----------------------------------------------------------- */

static struct ph_sample at_curve(const struct ph_sampler *sampler, double u,
                                 const struct motion *motion) {
  const struct ph_curve *curve = sampler->curve;
  struct ph_sample sample = {.torsion = (double)NAN};
  sample.point = point_at(curve, sampler->k, u, motion->s);
  sample.tangent = motion->tangent;
  sample.curvature = motion->speed > 0
                         ? motion->turn / motion->speed / curve->sphere.radius
                         : (double)NAN;
  ph_degree_of_unit(motion->s, sample.lonlat);
  return sample;
}

/* (1) to (3) */
static struct ph_sample at_parallel(const struct ph_sampler *sampler,
                                    const struct motion *m) {
  const struct ph_curve *curve = sampler->curve;
  const struct state *state = sampler->state;
  const double cosine = state->cosine, sine = state->sine;
  const double g = parallel_speed(m, cosine, sine);
  const double bend = cosine * m->turn + sine * m->speed;
  ph_vec3 left = ph_vec3_cross(m->s, m->tangent);
  ph_vec3 o = ph_vec3_along(ph_vec3_scale(cosine, m->s), sine, left);
  struct ph_sample sample = {.torsion = (double)NAN};
  sample.point = placed(curve, o);
  sample.tangent = g < 0 ? ph_vec3_scale(-1, m->tangent) : m->tangent;
  sample.curvature =
      fabs(g) > 0 ? bend / fabs(g) / curve->sphere.radius : (double)NAN;
  ph_degree_of_unit(o, sample.lonlat);
  return sample;
}

static struct ph_sample at_motion(const struct ph_sampler *sampler, double u,
                                  const struct motion *motion) {
  return sampler->offset ? at_parallel(sampler, motion)
                         : at_curve(sampler, u, motion);
}

static struct ph_sample at(const struct ph_sampler *sampler, double u) {
  const struct state *state = sampler->state;
  const struct motion motion = motion_at(&state->segment, u);
  return at_motion(sampler, u, &motion);
}

static void at_each(const struct ph_sampler *sampler, const double *u, size_t n,
                    struct ph_sample *samples) {
  enum { LANES = PH_SPHERICAL_FAST_LANES };
  const struct state *state = sampler->state;
  size_t i = 0;
  for (; i + LANES <= n; i += LANES) {
    ph_vec3 jet[LANES][3];
    ph_spherical_fast_jets(&state->segment, u + i, jet);
    for (size_t k = i; k < i + LANES; k++) {
      const struct motion motion = motion_of(&state->segment, u[k], jet[k - i]);
      samples[k] = at_motion(sampler, u[k], &motion);
    }
  }
  for (; i < n; i++) {
    samples[i] = at(sampler, u[i]);
  }
}

/* ---- frames -------------------------------------------------------------- */

/* The normal to the left, the binormal outward: rotation-minimising. */
static void reference(const struct ph_sampler *sampler, double u,
                      ph_vec3 e[3]) {
  const struct state *state = sampler->state;
  const struct motion motion = motion_at(&state->segment, u);
  e[0] = motion.tangent;
  e[1] = ph_vec3_cross(motion.s, motion.tangent);
  e[2] = motion.s;
}

/* kappa left - outward / radius; NaN where kappa is. */
static ph_vec3 principal(const struct ph_sampler *sampler, double u,
                         const struct ph_sample *sample) {
  const double radius = sampler->curve->sphere.radius;
  ph_vec3 e[3];
  reference(sampler, u, e);
  return ph_vec3_unit(
      ph_vec3_sub(ph_vec3_scale(sample->curvature * radius, e[1]), e[2]));
}

/* ---- cusps of parallels -------------------------------------------------- */

/*
 * CELLS of a segment in which a cusp is looked for; steps of the search for the
 * bottom of a dip and of a bisection; places that there is room for at first.
 */
enum {
  CELLS = 64,
  PLACES_MAX = CELLS + 1 + PH_SPHERICAL_CORNERS,
  STEPS_DIP = 40,
  STEPS_ROOT = 64,
  ROOM = 16
};

struct walk {
  const struct ph_curve *curve;
  struct ph_arena *arena;
  struct ph_offset *offset;
  struct ph_spherical_fast segment; /* number k */
  size_t k;
  double cosine, sine; /* of d */
  size_t room;         /* of offset->cusp */
  int sign;            /* the last one of g that was seen, 0 before any */
  bool memory;         /* is exhausted */
};

static void enter_segment(struct walk *walk, size_t k) {
  struct ph_spherical segment;
  walk->k = k;
  segment = ph_spherical_of(walk->curve, k);
  ph_spherical_fast_of(&segment, &walk->segment);
}

/* g at u, 0 if it is rounding only. */
static double signed_speed(const struct walk *walk, double u) {
  struct motion m = motion_at(&walk->segment, u);
  return parallel_speed(&m, walk->cosine, walk->sine);
}

static int sign_of(double x) {
  return x > 0 ? 1 : x < 0 ? -1 : 0;
}

static void add_cusp(struct walk *walk, double u) {
  struct ph_cusps *cusps = &walk->offset->cusps;
  cusps->at = ph_arena_grow(walk->arena, cusps->at, cusps->n, sizeof *cusps->at,
                            ROOM, &walk->room);
  if (!cusps->at) {
    walk->memory = true;
    return;
  }
  cusps->at[cusps->n++] = (struct ph_place){walk->k, u, u};
}

/* The change of sign between two places; g has `sign` at the first one. */
static double root_between(const struct walk *walk, double from, double to,
                           int sign) {
  for (int i = 0; i < STEPS_ROOT; i++) {
    double middle = 0.5 * (from + to);
    if (!(middle > from && middle < to)) {
      break;
    }
    if (sign_of(signed_speed(walk, middle)) == sign) {
      from = middle;
    } else {
      to = middle;
    }
  }
  return 0.5 * (from + to);
}

/* g at the places of a segment, in order. */
struct scan {
  size_t n;
  double u[PLACES_MAX], g[PLACES_MAX];
};

static void add_place(const struct walk *walk, double u, struct scan *scan) {
  scan->u[scan->n] = u;
  scan->g[scan->n++] = signed_speed(walk, u);
}

static void scan_segment(const struct walk *walk, struct scan *scan) {
  double corner[PH_SPHERICAL_CORNERS];
  size_t n = ph_spherical_corners(&walk->segment.segment, corner), next = 0;
  scan->n = 0;
  for (size_t i = 0; i <= CELLS; i++) {
    double v = (double)i / CELLS, u = v * v * (3 - 2 * v);
    for (; next < n && corner[next] < u; next++) {
      add_place(walk, corner[next], scan);
    }
    add_place(walk, u, scan);
  }
}

/* g, or -g, so that it is positive at the places beside a dip. */
struct dip {
  const struct walk *walk;
  int sign;
};

static double depth_at(const void *context, double u) {
  const struct dip *dip = context;
  return dip->sign * signed_speed(dip->walk, u);
}

/* Searches for the bottom of a dip about place i; whether it is below 0. */
static bool is_dip(const struct walk *walk, const struct scan *scan, size_t i,
                   int sign, double *where) {
  const struct dip dip = {walk, sign};
  const double *u = scan->u + i;
  struct ph_bracket b = {u[-1], u[0], u[1], sign * scan->g[i]};
  ph_golden(depth_at, &dip, STEPS_DIP, &b);
  *where = b.x;
  return b.value < 0;
}

/* Whether place i is so much lower than its neighbours that the parabola
 * through them, eight times as deep as it is, reaches 0. */
static bool is_low(const struct scan *scan, size_t i) {
  const double *g = scan->g + i;
  return i > 0 && i + 1 < scan->n && g[-1] * g[0] > 0 && g[0] * g[1] > 0 &&
         fabs(g[0]) < fabs(g[-1]) && fabs(g[0]) <= fabs(g[1]) &&
         3 * fabs(g[0]) <= fabs(g[-1]) + fabs(g[1]);
}

static void find_cusps(struct walk *walk) {
  struct scan scan;
  double from = 0, dip;
  scan_segment(walk, &scan);
  for (size_t i = 0; i < scan.n; i++) {
    int sign = sign_of(scan.g[i]);
    if (sign * walk->sign < 0) {
      add_cusp(walk,
               i == 0 ? 0 : root_between(walk, from, scan.u[i], walk->sign));
    }
    if (is_low(&scan, i) && is_dip(walk, &scan, i, sign, &dip)) {
      add_cusp(walk, root_between(walk, scan.u[i - 1], dip, sign));
      add_cusp(walk, root_between(walk, dip, scan.u[i + 1], -sign));
    }
    if (sign) {
      walk->sign = sign;
      from = scan.u[i];
    }
  }
}

static void find_all_cusps(struct walk *walk) {
  size_t n = walk->curve->n;
  if (walk->curve->closed) { /* the sign before the first joint */
    enter_segment(walk, n - 1);
    walk->sign = sign_of(signed_speed(walk, 1));
  }
  for (size_t k = 0; k < n && !walk->memory; k++) {
    enter_segment(walk, k);
    find_cusps(walk);
  }
}

/* ---- parallels ----------------------------------------------------------- */

/* Samples where none are asked for: so many and one for each segment. */
enum { SAMPLES = 16 };

/*
 * Samples and length are those of ph_sample_offset (curve/sample/sample.h).  At
 * a cusp that is hit exactly the tangent is that of the curve, and the
 * curvature NaN.
 *
 * Cusps are looked for between 64 places of each segment, which are denser
 * towards its ends, at corners of its speed, and at the joints (where a curve
 * that is no more than G1 may have one); a dip of |g| among these places is
 * searched for two.  Two that are nearer to each other than these places,
 * without such a dip, are missed. Each is found to rounding.  The length is the
 * integral of |g|, split at the cusps, as well as |g| is known to rounding.
 */
static enum ph_status offset(const struct ph_curve *curve, double distance,
                             const struct ph_offset_rules *rules,
                             struct ph_arena *arena, struct ph_offset *to,
                             struct ph_diag *diag) {
  const double angle = distance / curve->sphere.radius;
  struct ph_sample_rules samples = rules->samples;
  struct walk walk = {.curve = curve,
                      .arena = arena,
                      .offset = to,
                      .cosine = cos(angle),
                      .sine = sin(angle)};
  *to = (struct ph_offset){.distance = distance, .dimension = 3};
  if (!(fabs(angle) < PH_PI)) {
    return ph_fail(diag, PH_E_BAD_VALUE, NULL,
                   "the offset distance %g is not less than half the "
                   "circumference of the sphere, %g",
                   distance, PH_PI * curve->sphere.radius);
  }
  find_all_cusps(&walk);
  if (walk.memory) {
    return ph_fail_memory(diag);
  }
  if (samples.how == PH_SAMPLE_NONE) {
    samples.how = PH_SAMPLE_PARAMETER;
    samples.n = SAMPLES;
  }
  return ph_sample_offset(curve, &samples, arena, to, diag);
}

const struct ph_kind ph_kind_spherical_nu = {
    .on_sphere = true,
    .no_erf = "a curve on a sphere has no Euler-Rodrigues frame",
    .cusp = "curve bends as a circle of that radius on the sphere",
    .curve = {begin, enter, at, length, chord_bound, at_each},
    .beside = {begin, enter, at, length, chord_bound, at_each},
    .reference = reference,
    .principal = principal,
    .offsets_n = {0, 1},
    .offset = offset};
