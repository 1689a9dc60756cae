/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Offsets on the sphere (see parallel.h, whose formulas are cited here). */
#include "curve/offset/parallel.h"

#include "curve/kind/kind.h"
#include "kernel/pi.h"

/*
 * CELLS of a segment in which a cusp is looked for; steps of the search for the
 * bottom of a dip (0.618^40 < 1e-8, the root of rounding) and of a bisection;
 * places that there is room for at first.
 */
enum { CELLS = 64, STEPS_DIP = 40, STEPS_ROOT = 64, ROOM = 16 };

static const double GOLDEN = 0.6180339887498949;

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

static void enter(struct walk *walk, size_t k) {
  struct ph_spherical segment;
  walk->k = k;
  segment = ph_spherical_of(walk->curve, k);
  ph_spherical_fast_of(&segment, &walk->segment);
}

/* ---- (2) and its cusps -------------------------------------------------- */

/* g at u, 0 if it is rounding only. */
static double pace_at(const struct walk *walk, double u) {
  struct ph_motion m = ph_motion_at(&walk->segment, u);
  return ph_motion_pace(&m, walk->cosine, walk->sine);
}

static int sign_of(double x) {
  return x > 0 ? 1 : x < 0 ? -1 : 0;
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
};

static void scan_segment(const struct walk *walk, struct scan *scan) {
  for (size_t i = 0; i <= CELLS; i++) {
    double v = (double)i / CELLS, u = v * v * (3 - 2 * v);
    scan->u[i] = u;
    scan->g[i] = pace_at(walk, u);
  }
}

/* Whether place i is so much lower than its neighbours that the parabola
 * through them, eight times as deep as it is, reaches 0. */
static bool is_low(const struct scan *scan, size_t i) {
  const double *g = scan->g + i;
  return i > 0 && i < CELLS && g[-1] * g[0] > 0 && g[0] * g[1] > 0 &&
         fabs(g[0]) < fabs(g[-1]) && fabs(g[0]) <= fabs(g[1]) &&
         3 * fabs(g[0]) <= fabs(g[-1]) + fabs(g[1]);
}

static void find_cusps(struct walk *walk) {
  struct scan scan;
  double from = 0, dip;
  scan_segment(walk, &scan);
  for (size_t i = 0; i <= CELLS; i++) {
    int sign = sign_of(scan.g[i]);
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
    enter(walk, n - 1);
    walk->sign = sign_of(pace_at(walk, 1));
  }
  for (size_t k = 0; k < n && !walk->memory; k++) {
    enter(walk, k);
    find_cusps(walk);
  }
}

/* ---- samples ------------------------------------------------------------ */

/* Whether all points are in range. */
static bool is_finite(const struct ph_samples *samples) {
  bool finite = true;
  for (size_t i = 0; i < samples->n * samples->dimension; i++) {
    finite = finite && isfinite(samples->point[i]);
  }
  return finite;
}

enum ph_status
ph_offset_spherical(const struct ph_curve *curve, double distance,
                    const struct ph_offset_rules *rules, struct ph_arena *arena,
                    struct ph_offset *offset, struct ph_diag *diag) {
  const double angle = distance / curve->sphere.radius;
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
                   distance, PH_PI * curve->sphere.radius);
  }
  find_all_cusps(&walk);
  if (walk.memory) {
    return ph_fail_memory(diag);
  }
  status = ph_sample_offset(curve, &rules->samples, arena, offset, diag);
  if (status == PH_OK && !is_finite(&offset->samples)) {
    return ph_fail(diag, PH_TOO_LARGE, NULL,
                   "the offset at distance %g exceeds the range of a double",
                   distance);
  }
  return status;
}
