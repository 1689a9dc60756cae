/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Strips at a distance from general ones (see general.h). */
#include "curve/surface/general.h"
#include "kernel/golden.h"

#include <string.h>

enum { COARSE = 8, PARTS_MAX = 8192, STEPS = 40 };

/* What the rule on a part and those on its halves may differ by, relative to
 * all that is moved, and to the length. */
static const double AGREE = 1e-12;

/* Parts are no shorter than this. */
static const double SHORTEST = 1e-9;

/* ---- integrals ----------------------------------------------------------- */

/* The derivatives of (2) at u, where the rulings have turned by phi. */
static void rates(const struct ph_directrix *d, double u, double phi,
                  double rate[3]) {
  const struct ph_general_place at = ph_general_at(d, u);
  const double along = ph_vec3_dot(at.w, at.first) / at.rho;
  const double by = d->distance * d->side * at.bend;
  rate[0] = -by * cos(phi);
  rate[1] = by * d->side * sin(phi);
  rate[2] = hypot(at.rate * at.rho - by, along);
}

/* Their integrals over [from,to], within one part of the directrix. */
static void integrate(const struct ph_directrix *d, double from, double to,
                      double sum[3]) {
  const struct ph_quad *rule = d->rule;
  sum[0] = sum[1] = sum[2] = 0;
  for (size_t i = 0; i < rule->n; i++) {
    const double u = from + (to - from) * rule->node[i];
    double rate[3];
    rates(d, u, ph_general_phi(d, u), rate);
    for (size_t j = 0; j < 3; j++) {
      sum[j] += (to - from) * rule->weight[i] * rate[j];
    }
  }
}

void ph_general_moved(const struct ph_directrix *d, double u, double moved[3]) {
  size_t low = 0, high = d->n;
  double more[3];
  while (high - low > 1) {
    const size_t middle = (low + high) / 2;
    *(d->u[middle] <= u ? &low : &high) = middle;
  }
  integrate(d, d->u[low], u, more);
  for (size_t j = 0; j < 3; j++) {
    moved[j] = d->moved[low][j] + more[j];
  }
}

/* ---- parts --------------------------------------------------------------- */

/* Parts in the making, shorter than those of the cone. */
struct parts {
  size_t n;
  double u[PARTS_MAX + 1], moved[PARTS_MAX + 1][3];
};

/* Adds both halves of a part. */
static void add_halves(struct parts *p, double middle, double to,
                       const double left[3], const double right[3]) {
  p->u[p->n + 1] = middle;
  p->u[p->n + 2] = to;
  for (size_t j = 0; j < 3; j++) {
    p->moved[p->n + 1][j] = p->moved[p->n][j] + left[j];
    p->moved[p->n + 2][j] = p->moved[p->n + 1][j] + right[j];
  }
  p->n += 2;
}

/* Parts, from 0 to 1, as short as the rule needs them, each within one of the
 * directrix: phi is not known otherwise. */
static bool divide(const struct ph_directrix *d, struct parts *p) {
  const double size = fabs(d->distance) * d->turn + d->far;
  double step = 1.0 / COARSE, u = 0;
  size_t part = 0;
  memset(p->moved[0], 0, sizeof p->moved[0]);
  p->n = 0;
  p->u[0] = 0;
  while (u < 1) {
    const double end = d->u[part + 1];
    const double to = u + step < end - SHORTEST ? u + step : end;
    const double middle = u + (to - u) / 2;
    double whole[3], left[3], right[3], off = 0;
    integrate(d, u, to, whole);
    integrate(d, u, middle, left);
    integrate(d, middle, to, right);
    for (size_t j = 0; j < 3; j++) {
      off = fmax(off, fabs(whole[j] - left[j] - right[j]));
    }
    if (off <= AGREE * size) {
      if (p->n + 2 > PARTS_MAX) {
        return false;
      }
      add_halves(p, middle, to, left, right);
      part += to >= end;
      u = to;
      step *= 2;
    } else {
      step = (to - u) / 2;
      if (!(step > SHORTEST)) {
        return false;
      }
    }
  }
  return true;
}

/* ---- where there is none ------------------------------------------------- */

/* A strip, and the heights at which it is meant. */
struct meant {
  const struct ph_directrix *d;
  double height[2]; /* by the unit of `fast' */
};

/* The least of 1 - kn D on a ruling, kn being that at each height; -inf where
 * a height reaches the vertex. */
static double factor(const void *context, double u) {
  const struct meant *meant = context;
  const struct ph_directrix *d = meant->d;
  const struct ph_general_place at = ph_general_at(d, u);
  const double by = d->distance * d->side * at.bend / at.rate;
  double least = 1 - by / at.rho;
  for (size_t j = 0; j < 2; j++) {
    const double far = at.rho + d->side * meant->height[j];
    least = fmin(least, far > 0 ? 1 - by / far : -HUGE_VAL);
  }
  return least;
}

/* The least of that on a strip. */
static struct ph_bracket least_of(const struct meant *meant) {
  const struct ph_directrix *d = meant->d;
  struct ph_bracket least = {0, 0, 0, HUGE_VAL};
  double before = 0;
  for (size_t i = 0; i < d->n; i++) {
    const double step = d->u[i + 1] - d->u[i];
    for (size_t j = 0; j <= d->rule->n; j++) {
      const double u = j ? d->u[i] + step * d->rule->node[j - 1] : d->u[i];
      const double next =
          j < d->rule->n ? d->u[i] + step * d->rule->node[j] : d->u[i + 1];
      const double value = factor(meant, u);
      if (value < least.value) {
        least = (struct ph_bracket){before, u, next, value};
      }
      before = u;
    }
  }
  if (factor(meant, 1) < least.value) {
    least = (struct ph_bracket){before, 1, 1, factor(meant, 1)};
  }
  ph_golden(factor, meant, STEPS, &least);
  return least;
}

static enum ph_status check(const struct ph_curve *curve, size_t i,
                            const struct ph_directrix *d, double distance,
                            struct ph_diag *diag) {
  const double *height = curve->surface.height;
  const struct meant meant = {d,
                              {ph_pow2_apply(d->fast.shrink, height[0]),
                               ph_pow2_apply(d->fast.shrink, height[1])}};
  const struct ph_bracket least = least_of(&meant);
  if (least.value > 0) {
    return PH_OK;
  }
  if (!(least.value > -HUGE_VAL)) {
    return ph_fail_at(diag, PH_E_INFEASIBLE, "strips", i,
                      "has no parallel surface: its vertex is within the "
                      "height");
  }
  return ph_fail_at(diag, PH_E_INFEASIBLE, "strips", i,
                    "has no parallel surface at the distance %g: the least "
                    "radius of normal curvature within the height is %g",
                    distance, distance / (1 - least.value));
}

/* ---- the whole ----------------------------------------------------------- */

static enum ph_status prepare(struct ph_directrix *d, struct ph_arena *arena,
                              size_t i, struct ph_diag *diag) {
  struct parts *parts = ph_arena_array(arena, 1, sizeof *parts);
  const struct ph_directrix cone = *d;
  double *phi;
  if (!parts) {
    return ph_fail_memory(diag);
  }
  if (!divide(d, parts)) {
    return ph_fail_at(diag, PH_E_NO_CONVERGENCE, "strips", i,
                      "has a parallel surface that cannot be laid flat: it "
                      "bends too sharply");
  }
  phi = ph_arena_array(arena, parts->n + 1, sizeof *phi);
  if (!phi) {
    return ph_fail_memory(diag);
  }
  for (size_t j = 0; j <= parts->n; j++) {
    phi[j] = ph_general_phi(&cone, parts->u[j]);
  }
  d->n = parts->n;
  d->u = parts->u;
  d->phi = phi;
  d->moved = parts->moved;
  return PH_OK;
}

enum ph_status ph_general_beside(const struct ph_curve *curve, size_t i,
                                 double distance, struct ph_arena *arena,
                                 struct ph_strip *to, struct ph_diag *diag) {
  const struct ph_strip *from = &curve->surface.strips[i];
  const double nan = (double)NAN;
  struct ph_directrix *d = ph_arena_array(arena, 1, sizeof *d);
  enum ph_status status;
  if (!d) {
    return ph_fail_memory(diag);
  }
  *d = *from->directrix;
  d->distance = ph_pow2_apply(d->fast.shrink, distance);
  status = check(curve, i, d, distance, diag);
  if (status == PH_OK) {
    status = prepare(d, arena, i, diag);
  }
  if (status != PH_OK) {
    return status;
  }
  *to = *from;
  to->directrix = d;
  to->control_points = to->preimage = to->angles = NULL;
  to->length = ph_pow2_apply(d->fast.grow, d->moved[d->n][2]);
  to->development.samples = NULL;
  to->development.samples_n = 0;
  for (size_t j = 0; j < 3; j++) {
    to->frame.point[j] += distance * from->frame.normal[j];
    to->vertex[j] = to->fairness[j] = nan;
  }
  return PH_OK;
}
