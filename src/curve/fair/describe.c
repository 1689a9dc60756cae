/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a record says of a curve (see describe.h). */
#include "curve/fair/describe.h"

#include "base/sum.h"
#include "base/team.h"
#include "curve/cross/cross.h"
#include "curve/fair/energy.h"
#include "curve/fair/fair3.h"
#include "curve/segment/seg2.h"
#include "curve/segment/tc.h"
#include "kernel/pi.h"
#include "kernel/pow2.h"

#include <math.h>

/* On more segments, fairness in space is not described. */
enum { FAIR_MAX = 1000 };

/* What is found together. */
static const uint64_t CROSSINGS = PH_BIT(PH_D_LOOPS) | PH_BIT(PH_D_SIMPLE);
static const uint64_t ENERGIES =
    PH_BIT(PH_D_ENERGY) | PH_BIT(PH_D_MV) | PH_BIT(PH_D_IES) |
    PH_BIT(PH_D_IMV) | PH_BIT(PH_D_ROTATION_INDEX) |
    PH_BIT(PH_D_ABSOLUTE_ROTATION_INDEX) | PH_BIT(PH_D_F1) | PH_BIT(PH_D_F2) |
    PH_BIT(PH_D_F3);

/* So many parts of energies, 2 ms each, are worth another thread. */
enum { WORTH = 4 };

/* The scale at which the length is near 1, an even power of 2 so that preimages
 * have one, too. */
struct unit {
  struct ph_pow2 to_unit;
  double root;
};

static struct unit unit_of(const struct ph_curve *curve) {
  int exponent = curve->length > 0 ? -ph_pow2_exponent(curve->length) : 0;
  struct unit unit;
  exponent -= exponent & 1;
  unit.to_unit = ph_pow2_of(exponent);
  unit.root = ldexp(1, exponent / 2);
  return unit;
}

/* What is said of a plane curve, in shares: its crossings are the first, parts
 * of its sums the others. */
struct shares {
  const struct ph_curve *curve;
  struct ph_arena *scratch; /* of the crossings */
  bool crossings;           /* that are asked for */
  struct ph_cross cross;
  enum ph_status status;
  struct ph_diag *diag;
  void (*add)(struct shares *s, size_t part); /* its segments */
  size_t parts_n;                             /* 0: no sums are asked for */
  union {
    struct ph_energy_part *energy;
    struct cubics *cubics;
  } part; /* [parts_n] */
};

static bool do_share(void *context, size_t thread, size_t first, size_t end) {
  struct shares *s = context;
  (void)thread, (void)end;
  if (first > 0) {
    s->add(s, first - 1);
  } else if (s->crossings) {
    s->status = ph_cross_planar(s->curve, s->scratch, &s->cross, s->diag);
  }
  return true;
}

/* All of them; a curve of few segments has one thread. */
static enum ph_status share(struct shares *s) {
  ph_team_share(s->scratch, s->parts_n + 1, WORTH, 1, do_share, s);
  return s->status;
}

/* ---- in the plane -------------------------------------------------------- */

static void add_energies(struct shares *s, size_t part) {
  ph_energy_part_add(&s->part.energy[part], s->curve, part * PH_ENERGY_PART);
}

/* Crossings and energies. */
static enum ph_status share_energies(struct shares *s) {
  const size_t n = s->parts_n;
  struct ph_energy_part empty;
  s->add = add_energies;
  s->part.energy = ph_arena_array(s->scratch, n, sizeof *s->part.energy);
  if (!s->part.energy || (n && !ph_energy_part_begin(&empty, s->curve))) {
    return ph_fail_memory(s->diag);
  }
  for (size_t i = 0; i < n; i++) {
    s->part.energy[i] = empty;
  }
  share(s);
  for (size_t i = 1; i < n; i++) {
    ph_energy_part_join(&s->part.energy[0], &s->part.energy[i]);
  }
  return s->status;
}

enum ph_status ph_describe_planar(const struct ph_curve *curve,
                                  struct ph_arena *scratch,
                                  struct ph_diagnostics *diagnostics,
                                  struct ph_diag *diag) {
  struct shares shares = {
      .curve = curve,
      .scratch = scratch,
      .crossings = ph_diagnostics_asked(diagnostics, CROSSINGS),
      .parts_n = ph_diagnostics_asked(diagnostics, ENERGIES)
                     ? (curve->n + PH_ENERGY_PART - 1) / PH_ENERGY_PART
                     : 0,
      .diag = diag};
  enum ph_status status = share_energies(&shares);
  struct ph_energy energy;
  if (status != PH_OK) {
    return status;
  }
  if (shares.crossings) {
    ph_diagnostics_set(diagnostics, PH_D_LOOPS, (double)shares.cross.loops);
    ph_diagnostics_set(diagnostics, PH_D_SIMPLE, shares.cross.simple);
  }
  if (!shares.parts_n) {
    return PH_OK;
  }
  energy = ph_energy_of(shares.part.energy, curve);
  ph_diagnostics_set_finite(diagnostics, PH_D_ENERGY, energy.bending);
  ph_diagnostics_set_finite(diagnostics, PH_D_MV, energy.varying);
  ph_diagnostics_set_finite(diagnostics, PH_D_IES, energy.ies);
  ph_diagnostics_set_finite(diagnostics, PH_D_IMV, energy.imv);
  ph_diagnostics_set_finite(diagnostics, PH_D_ROTATION_INDEX, energy.rotation);
  ph_diagnostics_set_finite(diagnostics, PH_D_ABSOLUTE_ROTATION_INDEX,
                            energy.absolute_rotation);
  return PH_OK;
}

/* ---- in space ------------------------------------------------------------ */

/* The preimage of segment k at unit scale, by u in [0,1]. */
static void load_preimage(const struct ph_curve *curve, const struct unit *unit,
                          size_t k, ph_quat a[3]) {
  const double *v = curve->preimage.v + 12 * k;
  double root = unit->root * sqrt(ph_curve_range(curve, k));
  for (size_t i = 0; i < 3; i++, v += 4) {
    a[i] = ph_quat_of(root * v[0], root * v[1], root * v[2], root * v[3]);
  }
}

enum ph_status ph_describe_spatial(const struct ph_curve *curve,
                                   struct ph_arena *scratch,
                                   struct ph_diagnostics *diagnostics,
                                   struct ph_diag *diag) {
  static const enum ph_diagnostic name[3] = {PH_D_F1, PH_D_F2, PH_D_F3};
  const struct unit unit = unit_of(curve);
  struct ph_fair3_rules rules;
  double bending = 0, functional[3] = {0, 0, 0};
  (void)scratch;
  if (curve->n > FAIR_MAX || !ph_diagnostics_asked(diagnostics, ENERGIES)) {
    return PH_OK;
  }
  if (!ph_fair3_begin(&rules)) {
    return ph_fail_memory(diag);
  }
  for (size_t k = 0; k < curve->n; k++) {
    struct ph_atph space = ph_atph_of(ph_curve_angle(curve, k));
    double length = ph_pow2_apply(unit.to_unit, curve->lengths[k]);
    struct ph_fair3 fair;
    ph_quat a[3];
    load_preimage(curve, &unit, k, a);
    fair = ph_fair3_of(&rules, &space, a);
    bending += fair.bending;
    for (size_t i = 0; i < 3; i++) {
      functional[i] += ph_fair3_functional(&fair, length, (int)i + 1);
    }
  }
  /* The bending is the inverse of a length. */
  ph_diagnostics_set_finite(diagnostics, PH_D_ENERGY,
                            ph_pow2_apply(unit.to_unit, bending));
  for (size_t i = 0; i < 3; i++) {
    ph_diagnostics_set_finite(diagnostics, name[i], functional[i]);
  }
  return PH_OK;
}

/* ---- Tschirnhausen cubics ------------------------------------------------ */

/* Sums over the cubics, at unit scale. */
struct cubics {
  struct ph_sum energy, rotation, absolute;
  double curvature; /* the largest */
  size_t loops;
  bool stands_still;
};

/* Cubics of a part, which take 2 ms. */
enum { PART = 1024 };

/* The largest |curvature|, 2 |K| / |w|^4: where w is nearest to 0, that is at
 * its distance from the line of w, or at the nearer end. */
static double largest_curvature(const struct ph_tc *tc) {
  ph_cplx step = ph_cplx_sub(tc->w[1], tc->w[0]);
  /* |w x step|; of a step that is rounded, where one end is nearly 0, it would
   * be noise */
  double turn = fabs(ph_cplx_cross(tc->w[0], tc->w[1]));
  double nearest = fmin(ph_cplx_abs(tc->w[0]), ph_cplx_abs(tc->w[1]));
  if (ph_cplx_dot(tc->w[0], step) < 0 && ph_cplx_dot(tc->w[1], step) > 0) {
    nearest = turn / ph_cplx_abs(step);
  }
  return 2 * turn / (nearest * nearest * nearest * nearest);
}

static void add_cubic(struct cubics *sum, const struct ph_curve *curve,
                      double root, size_t k) {
  const double *w = curve->preimage.v + 4 * k;
  const struct ph_tc tc = {{ph_cplx_of(root * w[0], root * w[1]),
                            ph_cplx_of(root * w[2], root * w[3])}};
  const struct ph_seg2 seg = ph_seg2_of(curve, k);
  bool still = ph_seg2_stands_still(&seg, NULL);
  double turning = ph_tc_turning(&tc), curvature = largest_curvature(&tc);
  sum->stands_still = sum->stands_still || still;
  sum->loops += still || ph_tc_has_loop(&tc);
  sum->curvature = curvature <= sum->curvature ? sum->curvature : curvature;
  ph_sum_add(&sum->energy, ph_tc_energy(&tc));
  ph_sum_add(&sum->rotation, turning);
  ph_sum_add(&sum->absolute, fabs(turning));
}

static void add_cubics(struct shares *s, size_t part) {
  const struct unit unit = unit_of(s->curve);
  struct cubics sum = {.loops = 0};
  for (size_t k = part * PART; k < s->curve->n && k < (part + 1) * PART; k++) {
    add_cubic(&sum, s->curve, unit.root, k);
  }
  s->part.cubics[part] = sum;
}

static void join_cubics(struct cubics *sum, const struct cubics *more) {
  sum->stands_still |= more->stands_still;
  sum->loops += more->loops;
  sum->curvature =
      more->curvature <= sum->curvature ? sum->curvature : more->curvature;
  ph_sum_join(&sum->energy, &more->energy);
  ph_sum_join(&sum->rotation, &more->rotation);
  ph_sum_join(&sum->absolute, &more->absolute);
}

/* Crossings and sums, the first of which is that of all. */
static enum ph_status share_cubics(struct shares *s) {
  const size_t n = s->parts_n;
  s->add = add_cubics;
  s->part.cubics = ph_arena_array(s->scratch, n, sizeof *s->part.cubics);
  if (!s->part.cubics) {
    return ph_fail_memory(s->diag);
  }
  share(s);
  for (size_t i = 1; i < n; i++) {
    join_cubics(&s->part.cubics[0], &s->part.cubics[i]);
  }
  return s->status;
}

enum ph_status ph_describe_cubics(const struct ph_curve *curve,
                                  struct ph_arena *scratch,
                                  struct ph_diagnostics *diagnostics,
                                  struct ph_diag *diag) {
  const double turn = 2 * PH_PI;
  const struct unit unit = unit_of(curve);
  struct shares shares = {
      .curve = curve,
      .scratch = scratch,
      .crossings = ph_diagnostics_asked(diagnostics, PH_BIT(PH_D_SIMPLE)),
      .parts_n =
          ph_diagnostics_asked(diagnostics, ENERGIES | PH_BIT(PH_D_LOOPS) |
                                                PH_BIT(PH_D_MAX_CURVATURE))
              ? (curve->n + PART - 1) / PART
              : 0,
      .diag = diag};
  enum ph_status status = share_cubics(&shares);
  struct cubics sum;
  if (status != PH_OK) {
    return status;
  }
  if (shares.crossings) {
    ph_diagnostics_set(diagnostics, PH_D_SIMPLE,
                       shares.cross.simple &&
                           diagnostics->value[PH_D_REGULAR] > 0);
  }
  if (!shares.parts_n) {
    return PH_OK;
  }
  sum = shares.part.cubics[0];
  ph_diagnostics_set(diagnostics, PH_D_LOOPS, (double)sum.loops);
  if (!sum.stands_still) {
    /* Both are inverses of a length. */
    ph_diagnostics_set_finite(
        diagnostics, PH_D_ENERGY,
        ph_pow2_apply(unit.to_unit, ph_sum_value(&sum.energy)));
    ph_diagnostics_set_finite(diagnostics, PH_D_MAX_CURVATURE,
                              ph_pow2_apply(unit.to_unit, sum.curvature));
    ph_diagnostics_set_finite(diagnostics, PH_D_ROTATION_INDEX,
                              ph_sum_value(&sum.rotation) / turn);
    ph_diagnostics_set_finite(diagnostics, PH_D_ABSOLUTE_ROTATION_INDEX,
                              ph_sum_value(&sum.absolute) / turn);
  }
  return PH_OK;
}
