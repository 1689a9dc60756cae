/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * What two searches found, crossed (see min.h).
 *
 * How a curve bends in one place hardly depends on places far from it, and of
 * many points each search finds the better curve in some places.  Where both
 * have found about the same beside a knot one curve can go on as the other:
 * of each stretch between two such knots the fairer one is taken.
 */
#include "solve/planar/min.h"

#include <math.h>
#include <string.h>

/* Curves are about the same at a knot where the variables of so many segments
 * on either side of it differ by no more than this, but for a factor of all
 * spacings of PH quintics.  With .05 to .4 minima are as good. */
enum { MARGIN = 2 };
static const double ALIKE = 0.2;

/* What the functional would change by, of its logarithm, if the segments from
 * one on were not those of the best search. */
static double change_of(const struct ph_planar_work *w, size_t from,
                        size_t end) {
  const struct ph_planar_candidate *best = &w->best, *now = &w->now;
  const double by_part = w->weight[0] + w->weight[1], by_length = w->weight[2];
  double sum = 0;
  for (size_t k = from; k < end; k++) {
    sum += by_part * (now->part[k] - best->part[k]);
    sum += by_length * (now->length[k] - best->length[k]);
  }
  return sum;
}

/* Whether two curves are about the same before segment k and from it on.
 * out  ahead  by how much the variables of the second are larger there */
static bool is_seam(const struct ph_planar_work *w, const double *best,
                    const double *x, size_t k, double *ahead) {
  double least = HUGE_VAL, most = -HUGE_VAL;
  if (k < MARGIN || k + MARGIN > w->variables) {
    return false;
  }
  for (size_t j = k - MARGIN; j < k + MARGIN; j++) {
    least = fmin(least, x[j] - best[j]);
    most = fmax(most, x[j] - best[j]);
  }
  *ahead = w->data->atph ? 0 : 0.5 * (least + most);
  return fmax(most - *ahead, *ahead - least) <= ALIKE;
}

/* Crosses the variables.  ret whether they are new ones */
static bool cross(const struct ph_planar_work *w, const double *best,
                  const double *x, double *crossed) {
  size_t n = w->variables, taken = 0;
  double offset = 0, ahead = 0;
  bool before = false;
  for (size_t i = 0, end; i < n; i = end) {
    double next = 0;
    bool take;
    for (end = i + 1; end < n && !is_seam(w, best, x, end, &next); end++) {
    }
    take = change_of(w, i, end) < 0;
    if (i > 0 && take != before) {
      offset += take ? -ahead : ahead;
    }
    for (size_t k = i; k < end; k++) {
      crossed[k] = (take ? x[k] : best[k]) + offset;
    }
    taken += take ? end - i : 0;
    before = take;
    ahead = next;
  }
  return taken > 0 && taken < n;
}

enum ph_status ph_planar_min_cross(struct ph_planar_work *w,
                                   const struct ph_box *box, const double *best,
                                   double *x, double *crossed) {
  double value;
  enum ph_status status;
  if (!w->warm || isnan(w->best.value)) {
    return PH_OK;
  }
  ph_planar_min_weigh(w, &w->best);
  if (!cross(w, best, x, crossed)) {
    return PH_OK;
  }
  for (size_t k = 0; k < w->variables; k++) {
    crossed[k] = fmin(fmax(crossed[k], box->lower[k]), box->upper[k]);
  }
  w->warm = false; /* the curve is near neither */
  status = ph_planar_min_value(w, crossed, &value);
  w->warm = true;
  if (status == PH_OK && w->trial.value < fmin(w->now.value, w->best.value)) {
    ph_planar_min_accept(w);
    memcpy(x, crossed, w->variables * sizeof *x);
  }
  return status;
}
