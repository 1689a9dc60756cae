/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The fairest members of a family (see spatial_min.h).
 *
 * 1. The functional on a grid, by a coarse quadrature.
 * 2. Rough descents from the best local minima of the grid, and from CC.
 * 3. The best of these to the end, by ever finer quadratures until two agree.
 * 4. Their values by adaptive quadrature, and the least of these.
 *
 * What is descended is log(F + SMALL): F spans many powers of ten, and can have
 * a minimum of 0.
 */
#include "solve/spatial_min.h"

#include "kernel/box.h"
#include "solve/spatial_fair.h"

#include <math.h>

enum {
  B_N = 10,
  PHI_N = 10,
  ALPHA_N = 5,
  STARTS = 8,   /* of rough descents */
  POLISHED = 8, /* of these */
  GRID_PANELS = 2,
  PANELS = 2, /* at first, and at most */
  PANELS_MAX = 32,
  ROUGH_STEPS = 60,
  STEPS_MAX = 200
};

static const double SMALL = 1e-3;
/* Rough values that may still become the least. */
static const double PROMISING = 1.2;
/* Steps of log(F + SMALL) that are not worth while. */
static const double ROUGH = 1e-4, FINE = 1e-14;
/* Two quadratures agree. */
static const double AGREE = 1e-9;

static const double TURN = 6.283185307179586;

struct search {
  const struct ph_spatial_search *wanted;
  const struct ph_fair3_rules *rules;
  struct ph_arena *scratch;
  struct ph_spatial_family family;
  struct ph_spatial_target target;
  size_t panels;
  struct ph_spatial_point at; /* of the last value */
  double last;                /* F there */
  size_t evaluations;
};

struct start {
  struct ph_spatial_point at;
  double value;
};

static void begin(struct search *s, const struct ph_spatial_search *wanted,
                  const struct ph_fair3_rules *rules,
                  struct ph_arena *scratch) {
  struct ph_atph space = ph_atph_of(wanted->alpha_lower);
  s->wanted = wanted;
  s->rules = rules;
  s->scratch = scratch;
  s->family = ph_spatial_family_of(wanted->data, &space);
  s->target = (struct ph_spatial_target){&rules->fine, &s->family,
                                         wanted->scaled, wanted->functional};
  s->panels = PANELS;
  s->evaluations = 0;
}

static double value_at(struct search *s, size_t panels,
                       const struct ph_spatial_point *at) {
  s->evaluations++;
  return ph_spatial_fair(&s->target, panels, at, NULL);
}

/* ---- descent --------------------------------------------------------- */

static enum ph_status descent_value(void *context, const double *x,
                                    double *value) {
  struct search *s = context;
  s->at.b = x[PH_SPATIAL_B];
  s->at.phi = x[PH_SPATIAL_PHI];
  s->at.alpha = x[PH_SPATIAL_ALPHA];
  s->last = value_at(s, s->panels, &s->at);
  *value = log(s->last + SMALL);
  return PH_OK;
}

static void descent_gradient(void *context, double *gradient) {
  struct search *s = context;
  double value = ph_spatial_fair(&s->target, s->panels, &s->at, gradient);
  for (size_t i = 0; i < PH_SPATIAL_VARIABLES; i++) {
    gradient[i] /= value + SMALL;
  }
  if (s->wanted->alpha_lower >= s->wanted->alpha_upper) {
    gradient[PH_SPATIAL_ALPHA] = 0;
  }
}

static void descent_accept(void *context) {
  (void)context;
}

/* One descent by the quadrature of s->panels. */
static enum ph_status descend(struct search *s, double decrease, size_t steps,
                              struct start *start) {
  const double lower[] = {-INFINITY, -INFINITY, s->wanted->alpha_lower};
  const double upper[] = {INFINITY, INFINITY, s->wanted->alpha_upper};
  struct ph_box box = {PH_SPATIAL_VARIABLES,
                       lower,
                       upper,
                       decrease,
                       steps,
                       s,
                       descent_value,
                       descent_gradient,
                       descent_accept};
  double x[] = {start->at.b, start->at.phi, start->at.alpha};
  struct ph_box_report report;
  enum ph_status status = ph_box_minimize(&box, s->scratch, x, &report);
  start->at = (struct ph_spatial_point){x[PH_SPATIAL_B], x[PH_SPATIAL_PHI],
                                        x[PH_SPATIAL_ALPHA]};
  start->value = exp(report.value) - SMALL;
  return status;
}

/* To the end, by a quadrature that is fine enough there. */
static enum ph_status polish(struct search *s, struct start *start) {
  s->panels = PANELS;
  for (;;) {
    double finer;
    enum ph_status status = descend(s, FINE, STEPS_MAX, start);
    if (status != PH_OK) {
      return status;
    }
    finer = value_at(s, 2 * s->panels, &start->at);
    if (fabs(finer - start->value) <= AGREE * (finer + 1e-6) ||
        s->panels >= PANELS_MAX) {
      return PH_OK;
    }
    s->panels *= 2;
  }
}

/* The functional to the end. */
static double true_value(const struct search *s,
                         const struct ph_spatial_point *at) {
  struct ph_spatial_family f = ph_spatial_fair_family(&s->target, at->alpha);
  struct ph_spatial_member member = {ph_cplx_polar(at->b),
                                     ph_cplx_polar(at->phi)};
  struct ph_fair3 fair;
  ph_quat a[3];
  ph_spatial_preimage(&f, member, a);
  fair = ph_fair3_of(s->rules, &f.space, a);
  return ph_fair3_functional(&fair, ph_spatial_length(&f, member.b),
                             s->wanted->functional);
}

static void finish(const struct search *s, const struct start *best,
                   struct ph_spatial_minimum *found) {
  const struct ph_spatial_search *w = s->wanted;
  double alpha = best->at.alpha;
  found->member.b = ph_cplx_polar(best->at.b);
  found->member.phi = ph_cplx_polar(best->at.phi);
  found->alpha = alpha;
  found->value = best->value;
  found->evaluations = s->evaluations;
  found->at_bound = w->alpha_lower < w->alpha_upper &&
                    (alpha <= w->alpha_lower || alpha >= w->alpha_upper);
}

enum ph_status ph_spatial_descend(const struct ph_spatial_search *search,
                                  const struct ph_fair3_rules *rules,
                                  struct ph_arena *scratch,
                                  struct ph_spatial_minimum *found) {
  struct search s;
  const struct ph_spatial_member *m = &found->member;
  struct start start = {
      {atan2(m->b.im, m->b.re), atan2(m->phi.im, m->phi.re), found->alpha}, 0};
  enum ph_status status;
  begin(&s, search, rules, scratch);
  status = polish(&s, &start);
  start.value = true_value(&s, &start.at);
  finish(&s, &start, found);
  return status;
}

/* ---- global search --------------------------------------------------- */

/* Keeps the best n starts, in order; others than finite values go last. */
static void insert(struct start *list, size_t *n, size_t most,
                   const struct start *start) {
  size_t i;
  if (!isfinite(start->value)) {
    return;
  }
  if (*n == most) {
    if (!(start->value < list[most - 1].value)) {
      return;
    }
    (*n)--;
  }
  for (i = *n; i > 0 && start->value < list[i - 1].value; i--) {
    list[i] = list[i - 1];
  }
  list[i] = *start;
  (*n)++;
}

struct grid {
  size_t alphas;
  double alpha[ALPHA_N];
  double value[ALPHA_N][B_N][PHI_N];
};

static struct ph_spatial_point grid_point(const struct grid *g, size_t k,
                                          size_t i, size_t j) {
  struct ph_spatial_point at = {TURN * ((double)i + 0.5) / B_N,
                                TURN * ((double)j + 0.5) / PHI_N, g->alpha[k]};
  return at;
}

static void fill(struct search *s, struct grid *g) {
  double lower = s->wanted->alpha_lower, upper = s->wanted->alpha_upper;
  g->alphas = lower < upper ? ALPHA_N : 1;
  for (size_t k = 0; k < g->alphas; k++) {
    double part = g->alphas > 1 ? ((double)k + 0.25) / (ALPHA_N - 0.5) : 0;
    g->alpha[k] = lower + part * (upper - lower);
    for (size_t i = 0; i < B_N; i++) {
      for (size_t j = 0; j < PHI_N; j++) {
        struct ph_spatial_point at = grid_point(g, k, i, j);
        double value = value_at(s, GRID_PANELS, &at);
        g->value[k][i][j] = isfinite(value) ? value : (double)INFINITY;
      }
    }
  }
}

/* Whether no neighbour along the axes is less. */
static bool is_least(const struct grid *g, size_t k, size_t i, size_t j) {
  double v = g->value[k][i][j];
  return v <= g->value[k][(i + 1) % B_N][j] &&
         v <= g->value[k][(i + B_N - 1) % B_N][j] &&
         v <= g->value[k][i][(j + 1) % PHI_N] &&
         v <= g->value[k][i][(j + PHI_N - 1) % PHI_N] &&
         (k == 0 || v <= g->value[k - 1][i][j]) &&
         (k + 1 == g->alphas || v <= g->value[k + 1][i][j]);
}

static size_t starts_of(struct search *s, struct start *list) {
  struct grid grid;
  size_t n = 0;
  fill(s, &grid);
  for (size_t k = 0; k < grid.alphas; k++) {
    for (size_t i = 0; i < B_N; i++) {
      for (size_t j = 0; j < PHI_N; j++) {
        if (is_least(&grid, k, i, j)) {
          struct start start = {grid_point(&grid, k, i, j),
                                grid.value[k][i][j]};
          insert(list, &n, STARTS, &start);
        }
      }
    }
  }
  for (size_t k = 0; k < grid.alphas; k++) {
    struct ph_spatial_family f =
        ph_spatial_fair_family(&s->target, grid.alpha[k]);
    struct ph_spatial_member cc = ph_spatial_cc(&f);
    struct start start = {{atan2(cc.b.im, cc.b.re), 0, grid.alpha[k]}, 0};
    start.value = value_at(s, GRID_PANELS, &start.at);
    insert(list, &n, STARTS, &start);
  }
  return n;
}

enum ph_status ph_spatial_minimize(const struct ph_spatial_search *search,
                                   const struct ph_fair3_rules *rules,
                                   struct ph_arena *scratch,
                                   struct ph_spatial_minimum *found) {
  struct search s;
  struct start list[STARTS], rough[POLISHED], best = {{0, 0, 0}, INFINITY};
  size_t n, kept = 0;
  begin(&s, search, rules, scratch);
  n = starts_of(&s, list);
  for (size_t i = 0; i < n; i++) {
    enum ph_status status = descend(&s, ROUGH, ROUGH_STEPS, &list[i]);
    if (status != PH_OK) {
      return status;
    }
    insert(rough, &kept, POLISHED, &list[i]);
  }
  for (size_t i = 0;
       i < kept && rough[i].value <= PROMISING * (best.value + SMALL); i++) {
    enum ph_status status = polish(&s, &rough[i]);
    if (status != PH_OK) {
      return status;
    }
    rough[i].value = true_value(&s, &rough[i].at);
    if (rough[i].value < best.value) {
      best = rough[i];
    }
  }
  finish(&s, &best, found);
  return PH_OK;
}
