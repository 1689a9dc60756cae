/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Offsets on the sphere (see parallel.h, whose formulas are cited here). */
#include "curve/parallel.h"

#include "base/sum.h"
#include "curve/sample_kind.h"
#include "kernel/adapt.h"
#include "kernel/degree.h"
#include "kernel/pi.h"

#include <float.h>
#include <string.h>

/*
 * CELLS of a segment in which a cusp is looked for; steps of the search for the
 * bottom of a dip (0.618^40 < 1e-8, the root of rounding) and of a bisection;
 * nodes of the rule for lengths, enough between a dozen samples a segment;
 * places that there is room for at first.
 */
enum { CELLS = 64, STEPS_DIP = 40, STEPS_ROOT = 64, NODES = 5, ROOM = 16 };

static const double GOLDEN = 0.6180339887498949;
/* Of the length, relative to that of the curve and of an arc of radius sin d.
 */
static const double TOLERANCE = 1e-10;
/* What is less than this of its terms is their rounding. */
static const double ROUNDING = 64 * DBL_EPSILON;

struct walk {
  const struct ph_curve *curve;
  struct ph_arena *arena;
  struct ph_offset *offset;
  struct ph_spherical segment; /* number k */
  size_t k;
  double cosine, sine; /* of d */
  size_t room;         /* of offset->cusp */
  int sign;            /* the last one of g that was seen, 0 before any */
  bool memory;         /* is exhausted */
};

static void enter(struct walk *walk, size_t k) {
  walk->k = k;
  walk->segment = ph_spherical_of(walk->curve, k);
}

/* ---- (2) and its cusps -------------------------------------------------- */

static double pace_of(const struct walk *walk, const struct ph_motion *m) {
  return walk->cosine * m->speed - walk->sine * m->turn;
}

/* g at u. */
static double pace_at(const struct walk *walk, double u) {
  struct ph_motion m = ph_motion_at(&walk->segment, u);
  return pace_of(walk, &m);
}

static int sign_of(double x) {
  return x > 0 ? 1 : x < 0 ? -1 : 0;
}

/* Whether g is nothing but rounding: the cusp itself, or a circle's center. */
static bool stands(const struct walk *walk, const struct ph_motion *m) {
  double terms =
      fabs(walk->cosine) * m->speed + fabs(walk->sine) * (m->noise + m->speed);
  return !(fabs(pace_of(walk, m)) > ROUNDING * terms);
}

static void add_cusp(struct walk *walk, double u) {
  struct ph_offset *offset = walk->offset;
  size_t n = offset->cusps.n;
  struct ph_place *cusp = ph_arena_grow(walk->arena, offset->cusps.at, n,
                                        sizeof *cusp, ROOM, &walk->room);
  if (!cusp) {
    walk->memory = true;
    return;
  }
  offset->cusps.at = cusp;
  cusp[n].segment = walk->k;
  cusp[n].u = u;
  cusp[n].t = u;
  offset->cusps.n++;
}

/* The change of sign between two places; g has `sign` at the first one. */
static double root_between(const struct walk *walk, double from, double to,
                           int sign) {
  for (int i = 0; i < STEPS_ROOT; i++) {
    double middle = 0.5 * (from + to);
    if (!(middle > from && middle < to)) {
      break;
    }
    if (sign_of(pace_at(walk, middle)) == sign) {
      from = middle;
    } else {
      to = middle;
    }
  }
  return 0.5 * (from + to);
}

/* Searches for the least of sign * g between two places; true, and where, if it
 * is below 0. */
static bool is_dip(const struct walk *walk, double from, double to, int sign,
                   double *where) {
  double u[2] = {to - GOLDEN * (to - from), from + GOLDEN * (to - from)};
  double g[2] = {sign * pace_at(walk, u[0]), sign * pace_at(walk, u[1])};
  for (int i = 0; i < STEPS_DIP && g[0] >= 0 && g[1] >= 0; i++) {
    if (g[0] < g[1]) {
      to = u[1];
      u[1] = u[0];
      g[1] = g[0];
      u[0] = to - GOLDEN * (to - from);
      g[0] = sign * pace_at(walk, u[0]);
    } else {
      from = u[0];
      u[0] = u[1];
      g[0] = g[1];
      u[1] = from + GOLDEN * (to - from);
      g[1] = sign * pace_at(walk, u[1]);
    }
  }
  *where = g[0] < 0 ? u[0] : u[1];
  return g[0] < 0 || g[1] < 0;
}

/* g at the places of a segment. */
struct scan {
  double u[CELLS + 1], g[CELLS + 1];
  int sign[CELLS + 1]; /* 0: of rounding */
};

static void scan_segment(const struct walk *walk, struct scan *scan) {
  for (size_t i = 0; i <= CELLS; i++) {
    double v = (double)i / CELLS, u = v * v * (3 - 2 * v);
    struct ph_motion m = ph_motion_at(&walk->segment, u);
    scan->u[i] = u;
    scan->g[i] = pace_of(walk, &m);
    scan->sign[i] = stands(walk, &m) ? 0 : sign_of(scan->g[i]);
  }
}

/* Whether place i is so much lower than its neighbours that the parabola
 * through them, eight times as deep as it is, reaches 0. */
static bool is_low(const struct scan *scan, size_t i) {
  const double *g = scan->g + i;
  const int *sign = scan->sign + i;
  return i > 0 && i < CELLS && sign[0] && sign[-1] == sign[0] &&
         sign[1] == sign[0] && fabs(g[0]) < fabs(g[-1]) &&
         fabs(g[0]) <= fabs(g[1]) && 3 * fabs(g[0]) <= fabs(g[-1]) + fabs(g[1]);
}

static void find_cusps(struct walk *walk) {
  struct scan scan;
  double from = 0, dip;
  scan_segment(walk, &scan);
  for (size_t i = 0; i <= CELLS; i++) {
    int sign = scan.sign[i];
    if (sign * walk->sign < 0) {
      add_cusp(walk,
               i == 0 ? 0 : root_between(walk, from, scan.u[i], walk->sign));
    }
    if (is_low(&scan, i) &&
        is_dip(walk, scan.u[i - 1], scan.u[i + 1], sign, &dip)) {
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
    struct ph_motion m;
    enter(walk, n - 1);
    m = ph_motion_at(&walk->segment, 1);
    walk->sign = stands(walk, &m) ? 0 : sign_of(pace_of(walk, &m));
  }
  for (size_t k = 0; k < n && !walk->memory; k++) {
    enter(walk, k);
    find_cusps(walk);
  }
}

/* ---- samples and length ------------------------------------------------- */

static double pace_abs(const void *context, double u) {
  return fabs(pace_at(context, u));
}

/* The length of O over [from,to], which begins at cusp `*next` or after that;
 * *next becomes the first cusp beyond. */
static double length_over(const struct walk *walk, const struct ph_quad *rule,
                          double from, double to, size_t *next) {
  const struct ph_offset *offset = walk->offset;
  double length = walk->curve->lengths[walk->k] / walk->curve->radius;
  /* the offset goes round a turn of the curve on an arc of radius sin d */
  double tolerance = TOLERANCE * (length + fabs(walk->sine)), sum = 0;
  for (; *next < offset->cusps.n; ++*next) {
    const struct ph_place *cusp = &offset->cusps.at[*next];
    bool here = cusp->segment == walk->k; /* else at a joint before */
    if (cusp->segment > walk->k || (here && cusp->u >= to)) {
      break;
    }
    if (here && cusp->u > from) {
      sum +=
          ph_adapt(rule, pace_abs, walk, from, cusp->u, tolerance, TOLERANCE);
      from = cusp->u;
    }
  }
  return sum + ph_adapt(rule, pace_abs, walk, from, to, tolerance, TOLERANCE);
}

/* (1) to (3) at u. */
static struct ph_sample sample_at(const struct walk *walk, double u) {
  const struct ph_curve *curve = walk->curve;
  struct ph_motion m = ph_motion_at(&walk->segment, u);
  ph_vec3 left = ph_vec3_cross(m.s, m.tangent);
  ph_vec3 o = ph_vec3_along(ph_vec3_scale(walk->cosine, m.s), walk->sine, left);
  double g = pace_of(walk, &m);
  double bend = walk->cosine * m.turn + walk->sine * m.speed;
  bool at_cusp = stands(walk, &m);
  struct ph_sample sample = {.torsion = (double)NAN};
  sample.point = ph_motion_point(curve, o);
  sample.tangent = g < 0 && !at_cusp ? ph_vec3_scale(-1, m.tangent) : m.tangent;
  sample.curvature = at_cusp ? (double)NAN : bend / fabs(g) / curve->radius;
  ph_degree_of_unit(o, sample.lonlat);
  return sample;
}

static bool is_finite(ph_vec3 v) {
  return isfinite(v.x) && isfinite(v.y) && isfinite(v.z);
}

static enum ph_status sample_all(struct walk *walk, size_t n,
                                 struct ph_diag *diag) {
  struct ph_offset *offset = walk->offset;
  struct ph_sum sum = {0, 0};
  struct ph_quad rule;
  size_t next = 0;
  if (!ph_quad_gauss(&rule, NODES)) {
    return ph_fail_memory(diag);
  }
  for (size_t k = 0; k < walk->curve->n; k++) {
    enter(walk, k);
    for (size_t i = 0; i <= n; i++) {
      double u = (double)i / (double)n;
      struct ph_sample sample = sample_at(walk, u);
      if (i > 0) {
        double from = (double)(i - 1) / (double)n;
        ph_sum_add(&sum, length_over(walk, &rule, from, u, &next));
      }
      if (!is_finite(sample.point)) {
        return ph_fail(diag, PH_TOO_LARGE, NULL,
                       "the offset at distance %g exceeds the range of a "
                       "double",
                       offset->distance);
      }
      ph_samples_add(&offset->samples, k, u,
                     walk->curve->radius * ph_sum_value(&sum), &sample);
    }
    if (!isfinite(ph_sum_value(&sum))) {
      return ph_fail_at(diag, PH_NO_CONVERGENCE, "segments", k,
                        "has an offset at distance %g whose length was not "
                        "found",
                        offset->distance);
    }
  }
  offset->length = walk->curve->radius * ph_sum_value(&sum);
  return PH_OK;
}

enum ph_status
ph_offset_spherical(const struct ph_curve *curve, double distance,
                    const struct ph_offset_rules *rules, struct ph_arena *arena,
                    struct ph_offset *offset, struct ph_diag *diag) {
  const double angle = distance / curve->radius;
  struct walk walk = {.curve = curve,
                      .arena = arena,
                      .offset = offset,
                      .cosine = cos(angle),
                      .sine = sin(angle)};
  enum ph_status status;
  *offset = (struct ph_offset){.distance = distance, .dimension = 3};
  if (!(fabs(angle) < PH_PI)) {
    return ph_fail(diag, PH_BAD_VALUE, NULL,
                   "the offset distance %g is not less than half the "
                   "circumference of the sphere, %g",
                   distance, PH_PI * curve->radius);
  }
  status = ph_samples_alloc(&offset->samples, curve, false,
                            curve->n * (rules->samples.n + 1), arena, diag);
  if (status != PH_OK) {
    return status;
  }
  find_all_cusps(&walk);
  return walk.memory ? ph_fail_memory(diag)
                     : sample_all(&walk, rules->samples.n, diag);
}
