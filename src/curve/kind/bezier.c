/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Bezier curves (see kind.h), by derivatives of their control points.  They
 * stand for curves of another kind, whose lengths they have.
 *
 * The reference frame are axes a, b, c that are taken along by the shortest
 * rotation from a to the tangent T,
 *   e2 = b - (T . b) / (1 + a . T) (a + T),  e3 likewise,               (1)
 *   e2' . e3 = -a . (T x T') / (1 + a . T)
 *            = -a . (r' x r'') / (|r'| (|r'| + a . r')),                (2)
 * with that axis, of some, from whose opposite T stays farthest.
 *
 * (2) derived here from (1); tested by t_sample_frame.c.
 */
#include "curve/kind/kind.h"
#include "curve/sample/chord_bound.h"
#include "kernel/pow2.h"
#include "kernel/primitive.h"

#include <assert.h>
#include <float.h>

enum { DEGREE_MAX = 5, ORDERS = 4 };

/* Directions of the axes, and tangents that are looked at for them. */
enum { LOOKS = 33, AXES = 9 };

/* Lengths are found to this. */
static const double TOLERANCE = 1e-14;
/* What is less than this of its terms is their rounding. */
static const double ROUNDING = 64 * DBL_EPSILON;
/* The same of r' alone, whose direction is known before the curvature is. */
static const double REST = 2 * DBL_EPSILON;

/* ---- derivatives --------------------------------------------------------- */

/*
 * One segment, prepared for many places: Taylor coefficients at both ends, of
 * the points brought to unit scale by a power of two, so that the ends are met
 * exactly and |x| <= 1/2.
 */
struct bezier {
  size_t degree;
  int exponent; /* p is smaller by 2^exponent than the curve's */
  ph_vec3 p[DEGREE_MAX + 1];
  ph_vec3 taylor[2][DEGREE_MAX + 1];
  double polygon; /* length of the control polygon */
};

/* The coefficients by x from p[0], which is at u = 0, or at u = 1 of the points
 * in reverse order: binomial(n, k) times the k-th difference. */
static void expand(const struct bezier *b, bool end, ph_vec3 *taylor) {
  const size_t n = b->degree;
  double binomial = 1;
  for (size_t i = 0; i <= n; i++) {
    taylor[i] = b->p[end ? n - i : i];
  }
  for (size_t k = 0; k <= n; k++) {
    for (size_t i = n; i > k; i--) {
      taylor[i] = ph_vec3_sub(taylor[i], taylor[i - 1]);
    }
    taylor[k] = ph_vec3_scale(end && k % 2 ? -binomial : binomial, taylor[k]);
    binomial *= (double)(n - k) / (double)(k + 1);
  }
}

static struct bezier bezier_of(const struct ph_curve *curve, size_t k) {
  const size_t dimension = curve->dimension, degree = curve->degree;
  const double *v = ph_curve_points(curve, k);
  struct bezier b = {.degree = degree};
  struct ph_pow2 shrink;
  double largest = 0;
  assert(degree <= DEGREE_MAX);
  for (size_t i = 0; i < (degree + 1) * dimension; i++) {
    largest = fmax(largest, fabs(v[i]));
  }
  b.exponent = largest > 0 ? ph_pow2_exponent(largest) : 0;
  shrink = ph_pow2_of(-b.exponent);
  for (size_t i = 0; i <= degree; i++) {
    ph_vec3 p = ph_vec3_get(v + dimension * i, dimension);
    b.p[i] = ph_vec3_of(ph_pow2_apply(shrink, p.x), ph_pow2_apply(shrink, p.y),
                        ph_pow2_apply(shrink, p.z));
    b.polygon += i > 0 ? ph_vec3_abs(ph_vec3_sub(b.p[i], b.p[i - 1])) : 0;
  }
  expand(&b, false, b.taylor[0]);
  expand(&b, true, b.taylor[1]);
  return b;
}

/* r, r', r'' and r''' at u.  out  jet[ORDERS] */
static void jet_at(const struct bezier *b, double u, ph_vec3 *jet) {
  const bool end = u > 0.5;
  const double x = end ? u - 1 : u;
  const ph_vec3 *c = b->taylor[end];
  ph_vec3 j[ORDERS] = {c[b->degree]};
  for (size_t k = b->degree; k-- > 0;) {
    j[3] = ph_vec3_along(j[2], x, j[3]);
    j[2] = ph_vec3_along(j[1], x, j[2]);
    j[1] = ph_vec3_along(j[0], x, j[1]);
    j[0] = ph_vec3_along(c[k], x, j[0]);
  }
  jet[0] = j[0];
  jet[1] = j[1];
  jet[2] = ph_vec3_scale(2, j[2]);
  jet[3] = ph_vec3_scale(6, j[3]);
}

static double speed_at(const void *context, double u) {
  ph_vec3 jet[ORDERS];
  jet_at(context, u, jet);
  return ph_vec3_abs(jet[1]);
}

/* The direction of r', of r'' or r''' where r' is 0; against r'' before that,
 * as at the end of the segment, where r' = -(1 - u) r''. */
static ph_vec3 direction_of(const struct bezier *b, const ph_vec3 jet[ORDERS],
                            double u) {
  const bool back = u > 0 && (u >= 1 || ph_vec3_dot(jet[1], jet[2]) < 0);
  const size_t i = ph_vec3_abs(jet[1]) > REST * b->polygon       ? 1
                   : ph_vec3_abs(jet[2]) > ROUNDING * b->polygon ? 2
                                                                 : 3;
  const double sign = i == 2 && back ? -1 : 1;
  return ph_vec3_scale(sign / ph_vec3_abs(jet[i]), jet[i]);
}

/* The unit tangent, by higher derivatives where r' is 0; NaN where the segment
 * is a point. */
static ph_vec3 tangent_at(const struct bezier *b, double u) {
  ph_vec3 jet[ORDERS];
  jet_at(b, u, jet);
  return direction_of(b, jet, u);
}

/* ---- the sampler --------------------------------------------------------- */

struct state {
  struct bezier b;
  struct ph_pow2 grow, shrink;
  struct ph_primitive table; /* of the speed */
  double scale;              /* of what the curve stands for to that */
  ph_vec3 axes[3];           /* of frames */
};

static enum ph_status begin(struct ph_sampler *sampler, struct ph_diag *diag) {
  const struct state none = {.scale = 0};
  struct state *state = ph_arena_array(sampler->arena, 1, sizeof *state);
  if (!state) {
    return ph_fail_memory(diag);
  }
  *state = none;
  sampler->state = state;
  return PH_OK;
}

/* The axes of a segment. */
static void choose_axes(struct state *state) {
  ph_vec3 tangents[LOOKS], axes[AXES];
  double best = -1;
  for (size_t i = 0; i < LOOKS; i++) {
    tangents[i] = tangent_at(&state->b, (double)i / (LOOKS - 1));
  }
  for (size_t i = 0; i < AXES; i++) {
    double sign = i % 2 ? -1 : 1, least = 2;
    axes[i] = i < 2   ? ph_vec3_of(sign, 0, 0)
              : i < 4 ? ph_vec3_of(0, sign, 0)
              : i < 6 ? ph_vec3_of(0, 0, sign)
                      : tangents[(i - 6) * (LOOKS / 2)];
    for (size_t j = 0; j < LOOKS; j++) {
      least = fmin(least, 1 + ph_vec3_dot(axes[i], tangents[j]));
    }
    if (least > best) {
      best = least;
      state->axes[0] = axes[i];
    }
  }
  state->axes[1] = ph_vec3_any_normal(state->axes[0]);
  state->axes[2] = ph_vec3_cross(state->axes[0], state->axes[1]);
}

static enum ph_status enter(struct ph_sampler *sampler, struct ph_diag *diag) {
  struct state *state = sampler->state;
  enum ph_status status;
  state->b = bezier_of(sampler->curve, sampler->k);
  state->grow = ph_pow2_of(state->b.exponent);
  state->shrink = ph_pow2_of(-state->b.exponent);
  sampler->length = sampler->curve->lengths[sampler->k];
  if (sampler->framed) {
    choose_axes(state);
  }
  status = ph_primitive_make(&state->table, speed_at, &state->b, NULL, 0,
                             TOLERANCE, sampler->arena);
  state->scale =
      state->table.total > 0 ? sampler->length / state->table.total : 0;
  if (status == PH_E_NO_CONVERGENCE) {
    sampler->length = (double)NAN;
    status = PH_OK;
  }
  return status == PH_OK ? PH_OK : ph_fail_memory(diag);
}

static double length(const struct ph_sampler *sampler, double u,
                     double *speed) {
  const struct state *state = sampler->state;
  double s = state->scale * ph_primitive_at(&state->table, u, speed);
  *speed *= state->scale;
  return u < 1 ? s : sampler->length;
}

static double chord_bound(const struct ph_sampler *sampler, double u0,
                          double u1) {
  const struct state *state = sampler->state;
  const struct bezier *b = &state->b;
  return ph_pow2_apply(state->grow,
                       ph_chord_bound_bezier(b->p, b->degree, u0, u1));
}

static struct ph_sample at(const struct ph_sampler *sampler, double u) {
  const struct state *state = sampler->state;
  const double least = ROUNDING * state->b.polygon;
  struct ph_sample sample = {.lonlat = {0, 0}};
  ph_vec3 jet[ORDERS], cross;
  double speed, bent;
  jet_at(&state->b, u, jet);
  sample.point = ph_vec3_of(ph_pow2_apply(state->grow, jet[0].x),
                            ph_pow2_apply(state->grow, jet[0].y),
                            ph_pow2_apply(state->grow, jet[0].z));
  sample.tangent = direction_of(&state->b, jet, u);
  sample.curvature = sample.torsion = (double)NAN;
  speed = ph_vec3_abs(jet[1]);
  if (speed > least) {
    cross = ph_vec3_cross(jet[1], jet[2]);
    bent = sampler->curve->dimension == 2 ? cross.z : ph_vec3_abs(cross);
    sample.curvature =
        ph_pow2_apply(state->shrink, bent / (speed * speed * speed));
    if (fabs(bent) > least * speed) {
      sample.torsion =
          ph_pow2_apply(state->shrink,
                        ph_vec3_dot(cross, jet[3]) / ph_vec3_dot(cross, cross));
    }
  }
  return sample;
}

/* ---- frames -------------------------------------------------------------- */

/* (1) */
static void reference(const struct ph_sampler *sampler, double u,
                      ph_vec3 e[3]) {
  const struct state *state = sampler->state;
  e[0] = tangent_at(&state->b, u);
  e[1] = ph_vec3_carried(state->axes[1], state->axes[0], e[0]);
  e[2] = ph_vec3_carried(state->axes[2], state->axes[0], e[0]);
}

/* (2) */
static double turn(const void *context, double u) {
  const struct ph_sampler *sampler = context;
  const struct state *state = sampler->state;
  const ph_vec3 a = state->axes[0];
  ph_vec3 jet[ORDERS];
  double speed;
  jet_at(&state->b, u, jet);
  speed = ph_vec3_abs(jet[1]);
  return 1 - ph_vec3_triple(a, jet[1], jet[2]) /
                 (speed * (speed + ph_vec3_dot(a, jet[1])));
}

static ph_vec3 principal(const struct ph_sampler *sampler, double u,
                         const struct ph_sample *sample) {
  const struct state *state = sampler->state;
  ph_vec3 jet[ORDERS];
  jet_at(&state->b, u, jet);
  return ph_sample_principal(sample, ph_vec3_normal(jet[2], sample->tangent));
}

const struct ph_kind ph_kind_bezier = {
    .bernstein = true,
    .no_erf = "Bezier curves have no preimage and no Euler-Rodrigues frame: "
              "ask for the frame without the conversion",
    .curve = {begin, enter, at, length, chord_bound, NULL},
    .beside = {begin, enter, at, length, chord_bound, NULL},
    .reference = reference,
    .turn = turn,
    .principal = principal,
    .bezier = ph_bezier_itself};
