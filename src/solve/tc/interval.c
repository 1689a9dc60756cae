/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Solutions of one interval by the mode of the problem (see tc.h). */
#include "solve/tc/tc.h"

#include "curve/cross/cross.h"
#include "kernel/pi.h"
#include "solve/common/fields.h"

#include <math.h>
#include <stdlib.h>

static double angle_of(ph_cplx t) {
  return atan2(t.im, t.re);
}

/* ---- why there is none -------------------------------------------------- */

/* From this angle on at one end, the other must not be 0 [BYR11, table 4.1]. */
static const double NOT_ZERO = 2 * PH_PI / 3;

/* What to say of a range that reaches beyond the angles of directions. */
static const char *modulo(const double range[2]) {
  return range[0] < -PH_PI || range[1] > PH_PI ? " modulo 2 pi" : "";
}

static enum ph_status fail_g1(size_t k, const struct ph_tc_hermite *h, size_t n,
                              struct ph_diag *diag) {
  double a = angle_of(h->t[0]), b = angle_of(h->t[1]), range[2];
  if (n > 0) {
    return ph_fail_at(diag, PH_E_INFEASIBLE, "segments", k,
                      "a Tschirnhausen cubic with angles %.6g and %.6g to the "
                      "chord has a cusp; \"mode\":\"g1-pair\" has a curve of "
                      "two",
                      a, b);
  }
  ph_tc_g1_range(a, range);
  return ph_fail_at(
      diag, PH_E_INFEASIBLE, "segments", k,
      "no Tschirnhausen cubic has angles %.6g and %.6g to the chord: for the "
      "first, the second must be between %.6g and %.6g%s%s; "
      "\"mode\":\"g1-pair\" has a curve of two",
      a, b, range[0], range[1], modulo(range),
      fabs(a) >= NOT_ZERO ? ", and not 0" : "");
}

static enum ph_status fail_chord(const struct ph_tc_data *d, size_t k,
                                 const struct ph_tc_hermite *h,
                                 struct ph_diag *diag) {
  double range[2][2];
  for (size_t i = 0; i < 2; i++) {
    ph_tc_g1_range(angle_of(h->t[i]), range[i]);
  }
  return isnan(d->joint_angle)
             ? ph_fail_at(diag, PH_E_INFEASIBLE, "segments", k,
                          "no two cubics meet on the chord without a cusp; "
                          "\"joint\":\"free\" has a curve of two")
             : ph_fail_at(diag, PH_E_INFEASIBLE, "segments", k,
                          "no two cubics meet on the chord at the angle %.6g: "
                          "it must be between %.6g and %.6g%s and between "
                          "%.6g and %.6g%s, and not 0",
                          d->joint_angle, range[0][0], range[0][1],
                          modulo(range[0]), range[1][0], range[1][1],
                          modulo(range[1]));
}

static enum ph_status fail_pair(const struct ph_tc_data *d, size_t k,
                                struct ph_diag *diag) {
  return ph_fail_at(diag, PH_E_INFEASIBLE, "segments", k,
                    d->choice == PH_TC_STANDARD
                        ? "the standard pair has a cusp; \"solutions\":"
                          "\"best\" may have none"
                    : d->mode == PH_TC_C1
                        ? "all four pairs of cubics have a cusp with these "
                          "derivatives; other lengths of them do not"
                        : "all four pairs of cubics have a cusp with this "
                          "lambda; others do not");
}

/* ---- one ---------------------------------------------------------------- */

static enum ph_status g1(size_t k, const struct ph_tc_hermite *h,
                         struct ph_tc_fit *fit, struct ph_diag *diag) {
  struct ph_tc_fit fits[2];
  size_t n = ph_tc_g1(h, fits);
  if (n == 0 || !fits[0].regular) {
    return fail_g1(k, h, n, diag);
  }
  *fit = fits[0];
  return PH_OK;
}

/* Derivatives at both ends are given. */
static enum ph_status pair(const struct ph_tc_data *d, size_t k,
                           const struct ph_tc_hermite *h, struct ph_tc_fit *fit,
                           struct ph_diag *diag) {
  if (d->choice == PH_TC_STANDARD && ph_tc_pair_standard(h, fit)) {
    ph_tc_fit_measure(fit);
    fit->simple = ph_tc_pair_is_safe(h) || ph_tc_fit_test(fit);
    return fit->regular ? PH_OK : fail_pair(d, k, diag);
  }
  return ph_tc_pair_best(h, fit) ? PH_OK : fail_pair(d, k, diag);
}

/* Tangents alone are given. */
static enum ph_status two(const struct ph_tc_data *d, size_t k,
                          const struct ph_tc_hermite *h, struct ph_tc_fit *fit,
                          struct ph_diag *diag) {
  if (d->on_chord) {
    return ph_tc_two_chord(h, d->joint_angle, d->joint_position, fit)
               ? PH_OK
               : fail_chord(d, k, h, diag);
  }
  if (d->choice == PH_TC_STANDARD) {
    const struct ph_tc_hermite longer = ph_tc_hermite_scaled(h, PH_TC_LAMBDA);
    enum ph_status status = pair(d, k, &longer, fit, diag);
    fit->lambda = PH_TC_LAMBDA;
    return status;
  }
  return ph_tc_two_free(h, fit)
             ? PH_OK
             : ph_fail_at(diag, PH_E_NO_CONVERGENCE, "segments", k,
                          "no pair of cubics without a crossing was found");
}

static enum ph_status g1_pair(const struct ph_tc_data *d, size_t k,
                              const struct ph_tc_hermite *h,
                              struct ph_tc_fit *fit, struct ph_diag *diag) {
  return d->c1 ? pair(d, k, h, fit, diag) : two(d, k, h, fit, diag);
}

/* The data as unit tangents. */
static struct ph_tc_hermite tangents_of(const struct ph_tc_data *d,
                                        const struct ph_tc_hermite *h) {
  struct ph_tc_hermite unit = *h;
  for (size_t i = 0; d->c1 && i < 2; i++) {
    unit.t[i] = ph_cplx_scale(1 / ph_cplx_abs(h->t[i]), h->t[i]);
  }
  return unit;
}

/* Whether a cubic comes so near to a cusp that no one would draw it. */
static bool is_sharp(const struct ph_tc *tc) {
  const double sharp = 1e-6;
  double t = ph_tc_vertex(tc);
  struct ph_tc_form f = ph_tc_form_of(tc);
  ph_cplx w = ph_cplx_between(tc->w[0], tc->w[1], t);
  return !(ph_cplx_norm2(w) > sharp * sharp * fmax(f.a, f.b));
}

/* One cubic where a mode that has the choice takes it, else two. */
static enum ph_status one_or_two(const struct ph_tc_data *d, size_t k,
                                 const struct ph_tc_hermite *h,
                                 struct ph_tc_fit *fit, struct ph_diag *diag) {
  const struct ph_tc_hermite unit = tangents_of(d, h);
  struct ph_tc_fit fits[2];
  bool one = ph_tc_g1(&unit, fits) > 0 && !is_sharp(&fits[0].tc[0]) &&
             fits[0].loops == 0;
  enum ph_status status = PH_OK;
  if (!one || d->mode == PH_TC_G1_FAIR) {
    status = g1_pair(d, k, h, fit, diag);
  }
  if (one && (d->mode == PH_TC_G1_AUTO || status != PH_OK ||
              fits[0].energy * fits[0].length <= fit->energy * fit->length)) {
    *fit = fits[0];
    status = PH_OK;
  }
  return status;
}

enum ph_status ph_tc_interval(const struct ph_tc_data *d, size_t k,
                              struct ph_tc_fit *fit, struct ph_diag *diag) {
  const struct ph_tc_hermite h = ph_tc_hermite_of(d, k);
  switch (d->mode) {
  case PH_TC_G1:
    return g1(k, &h, fit, diag);
  case PH_TC_G1_AUTO:
  case PH_TC_G1_FAIR:
    return one_or_two(d, k, &h, fit, diag);
  case PH_TC_G1_PAIR:
    return g1_pair(d, k, &h, fit, diag);
  default:
    return pair(d, k, &h, fit, diag);
  }
}

/* ---- all ---------------------------------------------------------------- */

static void all_pairs(const struct ph_tc_hermite *h, double lambda,
                      struct ph_tc_fit fits[PH_TC_FITS_MAX]) {
  ph_tc_pairs(h, fits);
  for (size_t i = 0; i < PH_TC_PAIRS; i++) {
    ph_tc_fit_measure(&fits[i]);
    fits[i].lambda = lambda;
  }
  ph_tc_fit_order(fits, PH_TC_PAIRS);
}

enum ph_status ph_tc_interval_all(const struct ph_tc_data *d, size_t k,
                                  struct ph_tc_fit fits[PH_TC_FITS_MAX],
                                  size_t *n, struct ph_diag *diag) {
  const struct ph_tc_hermite h = ph_tc_hermite_of(d, k);
  enum ph_status status = ph_tc_interval(d, k, &fits[0], diag);
  if (status != PH_OK || d->on_chord) {
    *n = 1;
  } else if (fits[0].n == 1) {
    const struct ph_tc_hermite unit = tangents_of(d, &h);
    *n = ph_tc_g1(&unit, fits);
  } else {
    double lambda = fits[0].lambda;
    const struct ph_tc_hermite longer =
        d->c1 ? h : ph_tc_hermite_scaled(&h, lambda);
    all_pairs(&longer, lambda, fits);
    *n = PH_TC_PAIRS;
  }
  return status;
}

/* ---- every curve --------------------------------------------------------- */

/* Energies that agree to this are the same; then the shorter curve is better.
 */
static const double SAME = 1e-9;

/* What one interval may have. */
struct options {
  struct ph_tc_fit fit[PH_TC_FITS_MAX];
  size_t n;
};

/* One curve: number `index` of the product, the last interval fastest. */
struct candidate {
  size_t index;
  bool regular, simple;
  struct ph_tc_crossings crossings;
  double level; /* log(energy) in units of SAME, rounded; straight lines are
                   lowest */
  double length;
  struct ph_solution solution;
};

static int compare(const void *left, const void *right) {
  const struct candidate *a = left, *b = right;
  int by_kind = (int)b->regular - (int)a->regular;
  by_kind = by_kind ? by_kind : (int)b->simple - (int)a->simple;
  if (by_kind == 0 && a->regular) {
    by_kind = ph_fields_order(a->level, b->level);
    by_kind = by_kind ? by_kind : ph_fields_order(a->length, b->length);
  }
  return by_kind ? by_kind : (a->index > b->index) - (a->index < b->index);
}

static enum ph_status gather(const struct ph_tc_data *d,
                             struct options *options, size_t *total,
                             struct ph_diag *diag) {
  *total = 1;
  for (size_t k = 0; k < d->n; k++) {
    enum ph_status status =
        ph_tc_interval_all(d, k, options[k].fit, &options[k].n, diag);
    if (status != PH_OK) {
      return status;
    }
    *total *= options[k].n;
    if (*total > PH_TC_ALL_MAX || *total > PH_TC_ALL_INTERVALS / d->n) {
      return ph_fail(diag, PH_E_BAD_VALUE, "solutions",
                     "must not be all with more than %d curves, or %d "
                     "intervals in all of them: give fewer points",
                     PH_TC_ALL_MAX, PH_TC_ALL_INTERVALS);
    }
  }
  return PH_OK;
}

/* The curve of one candidate, and what it is ordered by. */
static enum ph_status build(const struct ph_tc_data *d,
                            const struct options *options, size_t total,
                            struct ph_arena *out, struct ph_arena *scratch,
                            struct candidate *c, struct ph_diag *diag) {
  struct ph_tc_builder builder;
  struct ph_cross cross;
  size_t index = c->index, among = total;
  double energy = 0;
  enum ph_status status =
      ph_tc_build_begin(&builder, d, out, &c->solution.curve, diag);
  if (status != PH_OK) {
    return status;
  }
  c->regular = true;
  for (size_t k = 0; k < d->n; k++) {
    const struct ph_tc_fit *fit;
    among /= options[k].n;
    fit = &options[k].fit[index / among];
    index %= among;
    energy += fit->energy / d->chord[k];
    c->regular = c->regular && fit->regular;
    ph_tc_crossings_see(&c->crossings, k, fit);
    ph_tc_build_add(&builder, fit);
  }
  ph_tc_build_end(&builder, &c->solution.diagnostics);
  c->solution.intervals = builder.intervals;
  c->solution.good = c->index == 0;
  c->level = energy > 0 ? round(log(energy) / SAME) : -HUGE_VAL;
  c->length = c->solution.curve.length;
  c->simple = c->crossings.n == 0;
  if (c->simple && d->n > 1) { /* of one interval it is known */
    status = ph_cross_planar(&c->solution.curve, scratch, &cross, diag);
    c->simple = status == PH_OK && cross.simple;
  }
  return status;
}

/* All curves, in order, with their own memory. */
static enum ph_status
rank(const struct ph_tc_data *d, const struct options *options, size_t total,
     struct ph_arena *out, struct ph_arena *scratch, struct ph_result *result,
     struct ph_tc_crossings *crossings, struct ph_diag *diag) {
  struct candidate *candidates =
      ph_arena_array(scratch, total, sizeof *candidates);
  result->solutions = ph_arena_array(out, total, sizeof *result->solutions);
  if (!candidates || !result->solutions) {
    return ph_fail_memory(diag);
  }
  for (size_t i = 0; i < total; i++) {
    enum ph_status status;
    candidates[i] = (struct candidate){.index = i};
    status = build(d, options, total, out, scratch, &candidates[i], diag);
    if (status != PH_OK) {
      return status;
    }
  }
  if (d->n > 1) { /* those of one interval are in order */
    qsort(candidates, total, sizeof *candidates, compare);
  }
  for (size_t i = 0; i < total; i++) {
    result->solutions[i] = candidates[i].solution;
  }
  result->solutions_n = total;
  *crossings = candidates[0].crossings;
  return PH_OK;
}

enum ph_status ph_tc_all(const struct ph_tc_data *d, struct ph_arena *out,
                         struct ph_arena *scratch, struct ph_result *result,
                         struct ph_tc_crossings *crossings,
                         struct ph_diag *diag) {
  struct options *options = ph_arena_array(scratch, d->n, sizeof *options);
  size_t total = 0;
  enum ph_status status =
      options ? gather(d, options, &total, diag) : ph_fail_memory(diag);
  if (status == PH_OK) {
    status = rank(d, options, total, out, scratch, result, crossings, diag);
  }
  if (status == PH_OK) {
    const struct ph_solution *best = &result->solutions[0];
    result->curve = best->curve;
    result->diagnostics = best->diagnostics;
    result->intervals = best->intervals;
    result->intervals_n = d->n;
  }
  return status;
}
