/* SPDX-License-Identifier: GPL-3.0-or-later */
/* All curves of Tschirnhausen cubics (see tc_all.h). */
#include "solve/tc/all.h"

#include "curve/cross.h"
#include "solve/tc/curve.h"

#include <math.h>
#include <stdlib.h>

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

static int order(double a, double b) {
  return (a > b) - (a < b);
}

static int compare(const void *left, const void *right) {
  const struct candidate *a = left, *b = right;
  int by_kind = (int)b->regular - (int)a->regular;
  by_kind = by_kind ? by_kind : (int)b->simple - (int)a->simple;
  if (by_kind == 0 && a->regular) {
    by_kind = order(a->level, b->level);
    by_kind = by_kind ? by_kind : order(a->length, b->length);
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
      return ph_fail(diag, PH_BAD_VALUE, "solutions",
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
