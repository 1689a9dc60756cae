/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Results of arclength (see arclength_report.h). */
#include "solve/arclength/report.h"

#include "solve/arclength/curve.h"

#include <math.h>
#include <string.h>

/* A length that differs from the natural one by eps makes the curve wiggle by
 * this times the length times sqrt(|eps|). */
static const double WIGGLE = 0.64;
/* An amplitude is told when it exceeds this part of an interval. */
static const double WIGGLE_TOLD = 0.01;
/* F of lengths that agree with the points is at most this times F of free
 * ones. */
static const double CONSISTENT = 3;
/* Fitted lengths are missed by fewer standard deviations. */
static const double DEVIATIONS = 3;
/* Below this F is rounding. */
static const double F_ROUNDING = 1e-11;
/* Below this it is that of a curve without bending. */
static const double F_DUST = 1e-25;

/* F and lengths of ours times this are the user's. */
static double unit(const struct ph_arc_search *search) {
  const struct ph_arc_data *d = search->system.data;
  return d->root * d->root;
}

/* What may help, after a message. */
static const char *hint(const struct ph_arc_search *search) {
  const struct ph_arc_system *s = &search->system;
  return !s->data->length     ? ""
         : s->data->sigma > 0 ? "; a larger length_sigma may help"
         : s->refine < 3      ? "; a larger refine gives the curve more room, "
                                "length_sigma allows for lengths that were measured"
                              : "; length_sigma allows for lengths that were "
                                "measured";
}

/* ---- failure ------------------------------------------------------------- */

/* The interval whose rows are missed most. */
static size_t worst_interval(const struct ph_arc_system *s, const double *c) {
  size_t worst = 0, n = s->data->n;
  double most = -1;
  for (size_t i = 0; i < n; i++) {
    double sum = 0;
    for (size_t k = 0; k < s->forms_n; k++) {
      sum += fabs(c[i * s->forms_n + k]);
    }
    for (size_t k = 0; k < 2 * s->knot_rows; k++) {
      sum += fabs(c[n * s->forms_n + i * s->knot_rows + k]);
    }
    if (sum > most) {
      most = sum;
      worst = i;
    }
  }
  return worst;
}

enum ph_status ph_arc_report_failure(const struct ph_arc_search *search,
                                     struct ph_arena *scratch,
                                     struct ph_diag *diag) {
  const struct ph_arc_system *s = &search->system;
  const struct ph_arc_data *d = s->data;
  const struct ph_arc_point *p = &search->nearest;
  double back = unit(search), *c, *attained;
  size_t worst, shown;
  if (d->sigma > 0 && !search->natural.known) {
    return ph_fail(diag, PH_NO_CONVERGENCE, NULL,
                   "the curve with free lengths was not found, by which "
                   "length_sigma is weighed");
  }
  if (search->stood_still) {
    return ph_fail(diag, PH_NO_CONVERGENCE, "tangents",
                   "have no curve that was found by %zu starts but some that "
                   "stand still at one of them; \"magnitudes\":\"mean\" may "
                   "help",
                   search->starts_n);
  }
  if (p->converged) {
    return ph_fail(diag, PH_NO_CONVERGENCE, NULL,
                   "no minimum was found by %zu starts, but a saddle, F %.6g%s",
                   search->starts_n, p->f * back, hint(search));
  }
  c = ph_arena_array(scratch, s->y_n, sizeof *c);
  attained = ph_arena_array(scratch, d->n, sizeof *attained);
  if (!c || !attained) {
    return ph_fail_memory(diag);
  }
  ph_arc_residual(s, p->x, c);
  ph_arc_lengths(s, p->x, attained);
  worst = worst_interval(s, c);
  shown = ph_arc_data_user(d, worst);
  if (!d->length) {
    return ph_fail(diag, PH_NO_CONVERGENCE, NULL,
                   "no curve was found by %zu starts; interval %zu is missed "
                   "most; residual %.2g of the mean chord",
                   search->starts_n, shown, p->residual);
  }
  if (!search->natural.known) {
    return ph_fail_at(diag, PH_NO_CONVERGENCE, "lengths", shown,
                      "is not met: %.6g asked for, %.6g attained in interval "
                      "%zu by the best of %zu starts; residual %.2g of the "
                      "mean length",
                      d->length[worst] * back, attained[worst] * back, shown,
                      search->starts_n, p->residual);
  }
  return ph_fail_at(
      diag, PH_NO_CONVERGENCE, "lengths", shown,
      "is not met: %.6g asked for, %.6g attained in interval %zu by the best "
      "of %zu starts, naturally %.6g; residual %.2g of the mean length%s",
      d->length[worst] * back, attained[worst] * back, shown, search->starts_n,
      search->natural.length[worst] * back, p->residual, hint(search));
}

/* ---- warnings ------------------------------------------------------------ */

/* Amplitude 0.64 l sqrt(|l / natural - 1|) of the wiggle that a length asks
 * for, beside the length. */
static void warn_wiggle(const struct ph_arc_search *search,
                        struct ph_result *result) {
  const struct ph_arc_data *d = search->system.data;
  const double *natural = search->natural.length;
  double most = 0;
  size_t found = 0, worst = 0;
  for (size_t i = 0; i < d->n; i++) {
    double part = WIGGLE * sqrt(fabs(d->length[i] / natural[i] - 1));
    double amplitude = part * d->length[i];
    found += part > WIGGLE_TOLD;
    if (part > WIGGLE_TOLD && amplitude > most) {
      most = amplitude;
      worst = i;
    }
  }
  if (found > 0) {
    size_t shown = ph_arc_data_user(d, worst);
    ph_fail(ph_warning_add(result, shown * search->system.refine), PH_WIGGLE,
            NULL,
            "lengths[%zu] is %.6g, naturally %.6g: the curve wiggles by about "
            "%.2g (such intervals: %zu)",
            shown, d->length[worst] * unit(search),
            natural[worst] * unit(search), most * unit(search), found);
  }
}

/* Fitted lengths that are missed. */
static void warn_misses(struct ph_result *result) {
  double rms = result->diagnostics.value[PH_D_LENGTH_RMS];
  if (rms > DEVIATIONS) {
    ph_fail(ph_warning_add(result, PH_NO_SEGMENT), PH_INCONSISTENT_LENGTHS,
            NULL,
            "the lengths are missed by %.3g standard deviations: points that "
            "a curve hardly bends through outweigh them",
            rms);
  }
}

static void warn(const struct ph_arc_search *search, bool left_plane,
                 struct ph_result *result) {
  const struct ph_arc_data *d = search->system.data;
  const struct ph_arc_point *p = &search->found[0].point;
  if (left_plane) {
    ph_fail(ph_warning_add(result, PH_NO_SEGMENT), PH_LEAVES_PLANE, NULL,
            "the data lie in a plane, in which no curve was found: this one "
            "leaves it");
  }
  if (!p->minimiser) {
    ph_fail(ph_warning_add(result, PH_NO_SEGMENT), PH_SADDLE, NULL,
            "the curve bends least in the plane of the data, but not in "
            "space: \"planar\":\"free\" lets it leave the plane");
  }
  if (!d->length || !search->natural.known || d->n < 2) {
    return;
  }
  if (d->sigma > 0) {
    warn_misses(result);
  } else {
    warn_wiggle(search, result);
  }
  if (p->f > CONSISTENT * search->natural.f + F_ROUNDING &&
      !(d->sigma > 0 &&
        result->diagnostics.value[PH_D_LENGTH_RMS] > DEVIATIONS)) {
    ph_fail(ph_warning_add(result, PH_NO_SEGMENT), PH_INCONSISTENT_LENGTHS,
            NULL,
            "the lengths fit no smooth curve through the data: F is %.6g, with "
            "free lengths %.6g",
            p->f * unit(search), result->diagnostics.value[PH_D_F_RELAXED]);
  }
}

/* ---- the result ---------------------------------------------------------- */

static void set_diagnostics(const struct ph_arc_search *search,
                            const struct ph_arc_found *found,
                            struct ph_diagnostics *diagnostics) {
  const struct ph_arc_point *p = &found->point;
  ph_diagnostics_set(diagnostics, PH_D_ITERATIONS, (double)p->iterations);
  ph_diagnostics_set(diagnostics, PH_D_RESIDUAL, p->residual);
  ph_diagnostics_set(diagnostics, PH_D_F, p->f * unit(search));
  ph_diagnostics_set(diagnostics, PH_D_KKT_ERROR, p->kkt);
  ph_diagnostics_set(diagnostics, PH_D_SECOND_ORDER,
                     p->minimiser ? PH_OUTCOME_MINIMISER : PH_OUTCOME_SADDLE);
  if (search->natural.known) {
    double f = search->natural.f > F_DUST ? search->natural.f : 0;
    ph_diagnostics_set(diagnostics, PH_D_F_RELAXED, f * unit(search));
  }
}

/* Lengths of the intervals, in the user's order; of lengths that were fitted
 * the root mean square of (L - l) / (sigma l).
 * out  intervals  [d->n] */
static enum ph_status
set_intervals(const struct ph_arc_search *search,
              const struct ph_arc_found *found, struct ph_arena *scratch,
              struct ph_arena *out, struct ph_interval **intervals,
              struct ph_diagnostics *diagnostics, struct ph_diag *diag) {
  const struct ph_arc_system *s = &search->system;
  const struct ph_arc_data *d = s->data;
  const struct ph_arc_natural *natural = &search->natural;
  double *length = ph_arena_array(scratch, d->n, sizeof *length), sum = 0;
  *intervals = ph_arena_array(out, d->n, sizeof **intervals);
  if (!length || !*intervals) {
    return ph_fail_memory(diag);
  }
  ph_arc_lengths(s, found->point.x, length);
  for (size_t i = 0; i < d->n; i++) {
    size_t shown = ph_arc_data_user(d, i);
    double free_length = natural->known ? natural->length[i] * unit(search)
                         : d->length    ? (double)NAN
                                        : length[i] * unit(search);
    struct ph_interval *interval = *intervals + shown;
    *interval = PH_INTERVAL_NONE;
    interval->length = length[i] * unit(search);
    interval->natural_length = free_length;
    interval->first = shown * s->refine;
    interval->last = (shown + 1) * s->refine - 1;
    if (d->sigma > 0) {
      double off = (length[i] / d->length[i] - 1) / d->sigma;
      sum += off * off;
    }
  }
  if (d->sigma > 0) {
    ph_diagnostics_set(diagnostics, PH_D_LENGTH_RMS, sqrt(sum / (double)d->n));
  }
  return PH_OK;
}

static enum ph_status set_starts(const struct ph_arc_search *search,
                                 struct ph_arena *out, struct ph_result *result,
                                 struct ph_diag *diag) {
  result->starts =
      ph_arena_array(out, search->starts_n, sizeof *result->starts);
  if (!result->starts) {
    return ph_fail_memory(diag);
  }
  memcpy(result->starts, search->starts,
         search->starts_n * sizeof *result->starts);
  result->starts_n = search->starts_n;
  result->start = search->found[0].start;
  for (size_t i = 0; i < result->starts_n; i++) {
    result->starts[i].f *= unit(search);
  }
  return PH_OK;
}

static enum ph_status set_solutions(const struct ph_arc_search *search,
                                    struct ph_arena *scratch,
                                    struct ph_arena *out,
                                    struct ph_result *result,
                                    struct ph_diag *diag) {
  enum ph_status status = PH_OK;
  double turn;
  result->solutions =
      ph_arena_array(out, search->found_n, sizeof *result->solutions);
  if (!result->solutions) {
    return ph_fail_memory(diag);
  }
  for (size_t i = 0; status == PH_OK && i < search->found_n; i++) {
    struct ph_solution *solution = &result->solutions[i];
    *solution = (struct ph_solution){.good = i == 0};
    set_diagnostics(search, &search->found[i], &solution->diagnostics);
    status = ph_arc_curve(&search->system, search->found[i].point.x, out,
                          &solution->curve, &turn, diag);
    if (status == PH_OK) {
      status =
          set_intervals(search, &search->found[i], scratch, out,
                        &solution->intervals, &solution->diagnostics, diag);
    }
  }
  result->solutions_n = status == PH_OK ? search->found_n : 0;
  return status;
}

enum ph_status ph_arc_report(const struct ph_arc_search *search,
                             bool left_plane, struct ph_arena *scratch,
                             struct ph_arena *out, struct ph_result *result,
                             struct ph_diag *diag) {
  double turn;
  enum ph_status status = PH_OK;
  if (!isfinite(search->found[0].point.f * unit(search))) {
    return ph_fail(diag, PH_TOO_LARGE, NULL,
                   "the curve exceeds the range of a double");
  }
  status = ph_arc_curve(&search->system, search->found[0].point.x, out,
                        &result->curve, &turn, diag);
  if (status == PH_OK && result->curve.closed) {
    ph_diagnostics_set(&result->diagnostics, PH_D_FRAME_TURN, turn);
  }
  if (status == PH_OK) {
    result->intervals_n = search->system.data->n;
    status = set_intervals(search, &search->found[0], scratch, out,
                           &result->intervals, &result->diagnostics, diag);
  }
  if (status == PH_OK) {
    status = set_starts(search, out, result, diag);
  }
  if (status == PH_OK && search->all) {
    status = set_solutions(search, scratch, out, result, diag);
  }
  if (status == PH_OK) {
    bool flat = search->system.data->plane &&
                ph_arc_is_flat(&search->system, search->found[0].point.x);
    set_diagnostics(search, &search->found[0], &result->diagnostics);
    if (search->system.data->plane) {
      ph_diagnostics_set(&result->diagnostics, PH_D_PLANAR, flat);
    }
    warn(search, left_plane && !flat, result);
  }
  return status;
}
