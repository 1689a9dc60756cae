/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Dual simplex method for small dense linear programs (method in lp.h). */
#include "kernel/lp.h"

#include <math.h>
#include <string.h>

/* Violations below this part of |x| + |b| are rounding. */
static const double FEASIBLE = 1e-12;

/* A constraint whose share in the new one is below this part of the largest
 * does not leave for it: what remained would be nearly dependent. */
static const double SHARE = 1e-11;

/* Multipliers may fall below 0 by this part of the largest |c|, so that among
 * nearly equal ratios the largest share can be taken [HAR73]. */
static const double DUAL = 1e-12;

/* The most violated constraint is added in so many steps; that of the least
 * index in the rest.  Programs of 16 unknowns and 400 rows take 20 to 80. */
static size_t steep_steps(const struct ph_lp *lp) {
  return 100 + 10 * lp->n;
}

static size_t most_steps(const struct ph_lp *lp) {
  return 10 * steep_steps(lp);
}

bool ph_lp_alloc(struct ph_lp_work *w, struct ph_arena *arena, size_t n,
                 size_t m) {
  w->row = ph_arena_array(arena, n, sizeof *w->row);
  w->price = ph_arena_array(arena, n, 2 * sizeof *w->price);
  w->at = ph_arena_array(arena, n, sizeof *w->at);
  w->free = ph_arena_array(arena, n, sizeof *w->free);
  w->order = ph_arena_array(arena, n, sizeof *w->order);
  w->lu = ph_arena_array(arena, n, n * sizeof *w->lu);
  w->normal = ph_arena_array(arena, n, sizeof *w->normal);
  w->share = ph_arena_array(arena, n, 2 * sizeof *w->share);
  w->scratch = ph_arena_array(arena, n, sizeof *w->scratch);
  w->active = ph_arena_array(arena, m, sizeof *w->active);
  return w->row && w->price && w->at && w->free && w->order && w->lu &&
         w->normal && w->share && w->scratch && w->active;
}

/* ---- the active rows in the free unknowns: P G = L U --------------------- */

static bool factor(const struct ph_lp *lp, struct ph_lp_work *w) {
  const size_t q = w->q;
  double *g = w->lu;
  size_t f = 0;
  for (size_t j = 0; j < lp->n; j++) {
    if (w->at[j] == PH_LP_FREE) {
      w->free[f++] = j;
    }
  }
  for (size_t i = 0; i < q; i++) {
    w->order[i] = i;
    for (size_t k = 0; k < q; k++) {
      g[i * q + k] = lp->a[w->row[i] * lp->n + w->free[k]];
    }
  }
  for (size_t k = 0; k < q; k++) {
    size_t best = k, keep = w->order[k];
    for (size_t i = k + 1; i < q; i++) {
      best = fabs(g[i * q + k]) > fabs(g[best * q + k]) ? i : best;
    }
    w->order[k] = w->order[best];
    w->order[best] = keep;
    for (size_t c = 0; best != k && c < q; c++) {
      double value = g[k * q + c];
      g[k * q + c] = g[best * q + c];
      g[best * q + c] = value;
    }
    if (!(fabs(g[k * q + k]) > 0)) {
      return false;
    }
    for (size_t i = k + 1; i < q; i++) {
      double part = g[i * q + k] /= g[k * q + k];
      for (size_t c = k + 1; c < q; c++) {
        g[i * q + c] -= part * g[k * q + c];
      }
    }
  }
  return true;
}

/* x: the bounds, and in the free unknowns G x = b - the bounds' part. */
static void place(const struct ph_lp *lp, struct ph_lp_work *w, double *x) {
  const size_t n = lp->n, q = w->q;
  double *s = w->scratch;
  for (size_t j = 0; j < n; j++) {
    x[j] = w->at[j] == PH_LP_LOWER   ? lp->lower[j]
           : w->at[j] == PH_LP_UPPER ? lp->upper[j]
                                     : 0;
  }
  for (size_t i = 0; i < q; i++) {
    const size_t row = w->row[w->order[i]];
    s[i] = lp->b[row];
    for (size_t j = 0; j < n; j++) {
      s[i] -= lp->a[row * n + j] * x[j];
    }
    for (size_t k = 0; k < i; k++) {
      s[i] -= w->lu[i * q + k] * s[k];
    }
  }
  for (size_t i = q; i-- > 0;) {
    for (size_t k = i + 1; k < q; k++) {
      s[i] -= w->lu[i * q + k] * s[k];
    }
    s[i] /= w->lu[i * q + i];
  }
  for (size_t i = 0; i < q; i++) {
    x[w->free[i]] = s[i];
  }
}

/* A vector v as a sum of the normals of the active rows, y[q], and of those of
 * the bounds, y + q. */
static void resolve(const struct ph_lp *lp, struct ph_lp_work *w,
                    const double *v, double *y) {
  const size_t q = w->q;
  double *s = w->scratch;
  for (size_t i = 0; i < q; i++) {
    s[i] = v[w->free[i]];
    for (size_t k = 0; k < i; k++) {
      s[i] -= w->lu[k * q + i] * s[k];
    }
    s[i] /= w->lu[i * q + i];
  }
  for (size_t i = q; i-- > 0;) {
    for (size_t k = i + 1; k < q; k++) {
      s[i] -= w->lu[k * q + i] * s[k];
    }
    y[w->order[i]] = s[i];
  }
  for (size_t j = 0; j < lp->n; j++) {
    double part = v[j];
    for (size_t i = 0; i < q; i++) {
      part -= y[i] * lp->a[w->row[i] * lp->n + j];
    }
    y[q + j] = w->at[j] == PH_LP_LOWER   ? part
               : w->at[j] == PH_LP_UPPER ? -part
                                         : 0;
  }
}

/* ---- a step -------------------------------------------------------------- */

/* A constraint: a row, or the lower or upper bound of an unknown. */
enum kind { ROW, LOWER, UPPER, NONE };

struct constraint {
  enum kind kind;
  size_t index;
};

/* a . x, in two sums that need not wait for each other. */
static double dot(const double *a, const double *x, size_t n) {
  double even = 0, odd = 0;
  size_t j = 0;
  for (; j + 2 <= n; j += 2) {
    even += a[j] * x[j];
    odd += a[j + 1] * x[j + 1];
  }
  return even + odd + (j < n ? a[j] * x[j] : 0);
}

/* The constraint that x violates most, or the first one that it violates. */
static struct constraint violated(const struct ph_lp *lp,
                                  const struct ph_lp_work *w, const double *x,
                                  bool first) {
  struct constraint which = {NONE, 0};
  double size = 0, worst = 0;
  for (size_t j = 0; j < lp->n; j++) {
    size += fabs(x[j]);
  }
  for (size_t f = 0; f < w->q && !(first && which.kind != NONE); f++) {
    const size_t j = w->free[f];
    double low = lp->lower[j] - x[j], high = x[j] - lp->upper[j];
    double excess = low > high ? low : high;
    if (!(excess <= FEASIBLE * size) && !(excess <= worst)) {
      worst = excess;
      which = (struct constraint){low > high ? LOWER : UPPER, j};
    }
  }
  for (size_t i = 0; i < lp->m && !(first && which.kind != NONE); i++) {
    double excess = lp->b[i] - dot(lp->a + i * lp->n, x, lp->n);
    if (!(excess <= worst) && !w->active[i] &&
        !(excess <= FEASIBLE * (size + fabs(lp->b[i])))) {
      worst = excess;
      which = (struct constraint){ROW, i};
    }
  }
  return which;
}

/* Whether active constraint k is a bound of an unknown that cannot move. */
static bool is_fixed(const struct ph_lp *lp, const struct ph_lp_work *w,
                     size_t k) {
  return k >= w->q && !(lp->lower[k - w->q] < lp->upper[k - w->q]);
}

/* The place of active constraint k (rows, then bounds) among all of them, in
 * the order of violated(). */
static size_t place_of(const struct ph_lp *lp, const struct ph_lp_work *w,
                       size_t k) {
  return k < w->q ? lp->n + w->row[k] : k - w->q;
}

/*
 * The active constraint that leaves: a smallest quotient of multiplier and
 * share, of these the largest share, or the first; q + n if no share is
 * positive.  The bounds of an unknown that cannot move never leave.
 */
static size_t leaving(const struct ph_lp *lp, const struct ph_lp_work *w,
                      bool first) {
  const size_t count = w->q + lp->n;
  double least = (double)INFINITY, floor = 0, slack = 0;
  size_t which = count;
  for (size_t j = 0; j < lp->n; j++) {
    slack = fmax(slack, DUAL * fabs(lp->c[j]));
  }
  for (size_t k = 0; k < count; k++) {
    floor = fmax(floor, SHARE * fabs(w->share[k]));
  }
  for (size_t k = 0; k < count; k++) {
    if (w->share[k] > floor && !is_fixed(lp, w, k)) {
      least = fmin(least, (fmax(w->price[k], 0) + slack) / w->share[k]);
    }
  }
  for (size_t k = 0; k < count; k++) {
    if (w->share[k] > floor && !is_fixed(lp, w, k) &&
        fmax(w->price[k], 0) <= least * w->share[k] &&
        (which == count || (first ? place_of(lp, w, k) < place_of(lp, w, which)
                                  : w->share[k] > w->share[which]))) {
      which = k;
    }
  }
  return which;
}

/*
 * Whether the new constraint (normal . x >= bound) and the active rows, each
 * taken as often as it is missing in the new one, add up to a row that no point
 * of the box satisfies.  This is a proof whatever the errors of the shares.
 */
static bool excludes_box(const struct ph_lp *lp, const struct ph_lp_work *w,
                         double bound) {
  double most = 0, size = fabs(bound);
  for (size_t i = 0; i < w->q; i++) {
    double times = w->share[i] < 0 ? -w->share[i] : 0;
    bound += times * lp->b[w->row[i]];
    size += times * fabs(lp->b[w->row[i]]);
  }
  for (size_t j = 0; j < lp->n; j++) {
    double y = w->normal[j];
    for (size_t i = 0; i < w->q; i++) {
      double times = w->share[i] < 0 ? -w->share[i] : 0;
      y += times * lp->a[w->row[i] * lp->n + j];
    }
    most += y * (y > 0 ? lp->upper[j] : lp->lower[j]);
    size += fabs(y) * fmax(fabs(lp->lower[j]), fabs(lp->upper[j]));
  }
  return most < bound - 1e-15 * size;
}

static void exchange(struct ph_lp_work *w, struct constraint in, size_t out) {
  if (out >= w->q) {
    w->at[out - w->q] = PH_LP_FREE;
  } else {
    w->active[w->row[out]] = false;
    w->row[out] = w->row[--w->q];
  }
  if (in.kind == ROW) {
    w->active[in.index] = true;
    w->row[w->q++] = in.index;
  } else {
    w->at[in.index] = in.kind == LOWER ? PH_LP_LOWER : PH_LP_UPPER;
  }
}

/* Makes a constraint the one to be added; returns its right-hand side. */
static double set_normal(const struct ph_lp *lp, struct ph_lp_work *w,
                         struct constraint in) {
  if (in.kind == ROW) {
    memcpy(w->normal, lp->a + in.index * lp->n, lp->n * sizeof *w->normal);
    return lp->b[in.index];
  }
  for (size_t j = 0; j < lp->n; j++) {
    w->normal[j] = 0;
  }
  w->normal[in.index] = in.kind == LOWER ? 1 : -1;
  return in.kind == LOWER ? lp->lower[in.index] : -lp->upper[in.index];
}

/* Starts at a corner of the box; false if c or the box is not finite. */
static bool begin(const struct ph_lp *lp, struct ph_lp_work *w) {
  bool finite = true;
  w->q = 0;
  w->steps = 0;
  w->violated = lp->m;
  for (size_t j = 0; j < lp->n; j++) {
    w->at[j] = lp->c[j] >= 0 ? PH_LP_LOWER : PH_LP_UPPER;
    finite = finite && isfinite(lp->c[j]) && isfinite(lp->lower[j]) &&
             isfinite(lp->upper[j]);
  }
  for (size_t i = 0; i < lp->m; i++) {
    w->active[i] = false;
  }
  return finite;
}

/* The solution lies in the box, not only nearly so. */
static void clip(const struct ph_lp *lp, double *x) {
  for (size_t j = 0; j < lp->n; j++) {
    x[j] = x[j] < lp->lower[j] ? lp->lower[j] : x[j];
    x[j] = x[j] > lp->upper[j] ? lp->upper[j] : x[j];
  }
}

enum ph_lp_outcome ph_lp_solve(const struct ph_lp *lp, struct ph_lp_work *w,
                               double *x) {
  if (!begin(lp, w)) {
    memcpy(x, lp->lower, lp->n * sizeof *x);
    return PH_LP_STALLED;
  }
  for (; w->steps < most_steps(lp) && factor(lp, w); w->steps++) {
    const bool first = w->steps >= steep_steps(lp);
    struct constraint in;
    double bound;
    size_t out;
    place(lp, w, x);
    resolve(lp, w, lp->c, w->price);
    in = violated(lp, w, x, first);
    w->violated = in.kind == ROW ? in.index : lp->m;
    if (in.kind == NONE) {
      clip(lp, x);
      return PH_LP_OPTIMAL;
    }
    bound = set_normal(lp, w, in);
    resolve(lp, w, w->normal, w->share);
    out = leaving(lp, w, first);
    if (out == w->q + lp->n) {
      return excludes_box(lp, w, bound) ? PH_LP_INFEASIBLE : PH_LP_STALLED;
    }
    exchange(w, in, out);
  }
  return PH_LP_STALLED;
}
