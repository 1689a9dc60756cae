/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The fairest members of a family (see fairest.h).
 *
 * 1. The functional over phi, for a grid of b and alpha: its local minima, a
 *    little improved.  The valleys are narrow in phi and long in b, so that a
 *    plain grid can miss them.
 * 2. Rough descents from those that are less than their neighbours in the grid.
 * 3. The best of these to the end, by ever finer quadratures until two agree;
 *    by those that do not know the place yet only so far as helps the next.
 * 4. Their values by adaptive quadrature, and the least of these.
 *
 * Plane data have members in the plane, two b with phi 0 or pi.  They are
 * searched by themselves: with an inflection their F3 is finite, but that of
 * all members nearby is not.
 *
 * What is descended is log(F + SMALL): F spans many powers of ten, and can have
 * a minimum of 0.
 */
#include "solve/spatial/fairest.h"

#include "kernel/box.h"
#include "kernel/pi.h"

#include <math.h>
#include <string.h>

enum {
  B_MAX = 20, /* of the grid, in every direction */
  PHI_N = 14,
  ALPHA_MAX = 6,
  VALLEYS = 4,                /* kept for one b and alpha */
  STARTS = PH_SPATIAL_STARTS, /* of rough descents, and of fine ones */
  GRID_PANELS = 2,            /* of the quadrature: in the grid, and at first */
  PANELS_MAX = 16,
  ROUGH_STEPS = 60,  /* of one descent */
  COARSE_STEPS = 30, /* by a quadrature that is not fine enough */
  STEPS_MAX = 100,
  /* Evaluations of a step, on average, beyond which a descent is given up: it
   * takes 1.3 of a valley, and 30 where what is minimised has an edge. */
  A_STEP = 4
};

static const double SMALL = 1e-3;
/* Steps of log(F + SMALL) that are not worth while. */
static const double ROUGH = 1e-4, COARSE = 1e-8, FINE = 1e-14;
/* Two quadratures agree, relative to this much more than F. */
static const double AGREE = 1e-9, NOTHING = 1e-6;
/* Two quadratures know a place. */
static const double RESOLVED = 1e-2;
/* Descents by the first quadrature that end so near to each other, in angles
 * and relative to their values, have found the same. */
static const double SAME_PLACE = 2e-3, SAME_VALUE = 1e-8;
/* How much a rough minimum can still lose. */
static const double PROMISING = 1.2, HOPELESS = 3;
/* ... and one that two quadratures know the place of, of their difference. */
static const double BEHIND = 10;
/* Minima at neighbouring b or alpha whose phi is nearer belong together. */
static const double APART = 0.8;

static const double TURN = 6.28318530717958647693;

struct search {
  const struct ph_spatial_search *wanted;
  const struct ph_fair3_rules *rules;
  struct ph_arena *scratch;
  struct ph_spatial_family family;
  struct ph_spatial_target target;
  size_t panels;
  double gradient[PH_SPATIAL_VARIABLES]; /* at the last value, of its log */
  size_t evaluations, work;
  size_t kept; /* rough minima, as ph_spatial_minimum has them */
  struct ph_spatial_start rough[STARTS];
  size_t known; /* ends of descents by the first quadrature */
  struct ph_spatial_start end[STARTS];
  bool repeated; /* the last descent to the end came to one of them */
};

static void begin(struct search *s, const struct ph_spatial_search *wanted,
                  const struct ph_fair3_rules *rules,
                  struct ph_arena *scratch) {
  struct ph_atph space = ph_atph_of(wanted->alpha_lower);
  s->wanted = wanted;
  s->rules = rules;
  s->scratch = scratch;
  s->family = ph_spatial_family_of(wanted->data, &space);
  ph_spatial_family_round(&s->family);
  s->target = (struct ph_spatial_target){&rules->rule, &s->family,
                                         wanted->scaled, wanted->functional};
  s->panels = GRID_PANELS;
  s->evaluations = s->work = s->kept = s->known = 0;
}

/* Counts a value by some panels, or one with its gradient, which takes about
 * twice as long. */
static void count(struct search *s, size_t panels, size_t times) {
  s->evaluations++;
  s->work += times * panels / GRID_PANELS;
}

static double section_value(struct search *s,
                            const struct ph_spatial_section *at, double phi) {
  count(s, GRID_PANELS, 1);
  return ph_spatial_section_fair(&s->target, at, GRID_PANELS, phi);
}

static double value_at(struct search *s, size_t panels,
                       const struct ph_spatial_point *at) {
  count(s, panels, 1);
  return ph_spatial_fair(&s->target, panels, at, NULL);
}

/* ---- descent --------------------------------------------------------- */

/* The gradient beside the value: nearly all of them are wanted. */
static enum ph_status descent_value(void *context, const double *x,
                                    double *value) {
  struct search *s = context;
  struct ph_spatial_point at = {x[PH_SPATIAL_B], x[PH_SPATIAL_PHI],
                                x[PH_SPATIAL_ALPHA]};
  double f = ph_spatial_fair(&s->target, s->panels, &at, s->gradient);
  count(s, s->panels, 2);
  for (size_t i = 0; i < PH_SPATIAL_VARIABLES; i++) {
    s->gradient[i] /= f + SMALL;
  }
  if (s->wanted->alpha_lower >= s->wanted->alpha_upper) {
    s->gradient[PH_SPATIAL_ALPHA] = 0;
  }
  *value = log(f + SMALL);
  return PH_OK;
}

static void descent_gradient(void *context, double *gradient) {
  const struct search *s = context;
  memcpy(gradient, s->gradient, sizeof s->gradient);
}

static void descent_accept(void *context) {
  (void)context;
}

/* One descent by the quadrature of s->panels. */
static enum ph_status descend(struct search *s, double decrease, size_t steps,
                              struct ph_spatial_start *start) {
  const double none = HUGE_VAL;
  const double lower[] = {start->plane ? start->at.b : -none,
                          start->plane ? start->at.phi : -none,
                          s->wanted->alpha_lower};
  const double upper[] = {start->plane ? start->at.b : none,
                          start->plane ? start->at.phi : none,
                          s->wanted->alpha_upper};
  struct ph_box box = {.n = PH_SPATIAL_VARIABLES,
                       .lower = lower,
                       .upper = upper,
                       .decrease = decrease,
                       .steps_max = steps,
                       .evaluations_max = A_STEP * steps,
                       .context = s,
                       .value = descent_value,
                       .gradient = descent_gradient,
                       .accept = descent_accept};
  double x[] = {start->at.b, start->at.phi, start->at.alpha};
  struct ph_box_report report;
  enum ph_status status = ph_box_minimize(&box, s->scratch, x, &report);
  start->at = (struct ph_spatial_point){x[PH_SPATIAL_B], x[PH_SPATIAL_PHI],
                                        x[PH_SPATIAL_ALPHA]};
  start->value = exp(report.value) - SMALL;
  return status;
}

/* Whether twice as many panels agree, relative to this; finer: by these. */
static bool agrees(struct search *s, double within,
                   const struct ph_spatial_start *start, double *finer) {
  *finer = value_at(s, 2 * s->panels, &start->at);
  return fabs(*finer - start->value) <= within * (*finer + NOTHING);
}

/* The functional by adaptive quadrature. */
static double true_value(const struct search *s,
                         const struct ph_spatial_point *at) {
  struct ph_spatial_family f = ph_spatial_fair_family(&s->target, at->alpha);
  struct ph_spatial_member member = {ph_cplx_polar(at->b),
                                     ph_cplx_polar(at->phi)};
  struct ph_fair3 fair;
  ph_quat a[3];
  ph_spatial_preimage(&f, member, a);
  fair = ph_fair3_of(s->rules, &f.space, a);
  if (fair.inflected && s->target.functional == 3) {
    return HUGE_VAL; /* isolated: F3 is huge all around */
  }
  return ph_fair3_functional(&fair, ph_spatial_length(&f, member.b),
                             s->wanted->functional);
}

/* Whether another descent has ended in the same place; otherwise this one has
 * from now on. */
static bool is_known(struct search *s, const struct ph_spatial_start *start) {
  for (size_t i = 0; i < s->known; i++) {
    const struct ph_spatial_start *end = &s->end[i];
    if (fabs(remainder(start->at.b - end->at.b, TURN)) < SAME_PLACE &&
        fabs(remainder(start->at.phi - end->at.phi, TURN)) < SAME_PLACE &&
        fabs(start->at.alpha - end->at.alpha) < SAME_PLACE &&
        fabs(start->value - end->value) < SAME_VALUE * (end->value + SMALL)) {
      return true;
    }
  }
  if (s->known < STARTS) {
    s->end[s->known++] = *start;
  }
  return false;
}

/* To the end, by a quadrature that is fine enough there: not far by one that is
 * not.  What the first ones do not see may be far above the best: it is left
 * then, as is what another descent has found. */
static enum ph_status polish(struct search *s, struct ph_spatial_start start,
                             struct ph_spatial_start *best) {
  const double limit = best->value + SMALL;
  enum ph_status status = PH_OK;
  bool done = false;
  for (s->panels = GRID_PANELS;
       status == PH_OK && !done && s->panels <= PANELS_MAX; s->panels *= 2) {
    double finer;
    bool whole;
    start.value = value_at(s, s->panels, &start.at);
    whole = s->panels == PANELS_MAX || agrees(s, RESOLVED, &start, &finer);
    status = descend(s, whole ? FINE : COARSE, whole ? STEPS_MAX : COARSE_STEPS,
                     &start);
    if (s->panels == GRID_PANELS) {
      s->repeated = is_known(s, &start);
      if (s->repeated) {
        return status;
      }
    }
    done = (agrees(s, AGREE, &start, &finer) && whole) ||
           !(finer <= HOPELESS * limit) ||
           (whole && finer - BEHIND * fabs(finer - start.value) > limit);
  }
  start.value = true_value(s, &start.at);
  *best = start.value < best->value ? start : *best;
  return status;
}

static void finish(const struct search *s, const struct ph_spatial_start *best,
                   struct ph_spatial_minimum *found) {
  const struct ph_spatial_search *w = s->wanted;
  double alpha = best->at.alpha;
  found->member.b = ph_cplx_polar(best->at.b);
  found->member.phi = ph_cplx_polar(best->at.phi);
  found->alpha = alpha;
  found->functional = w->functional;
  found->value = best->value;
  found->evaluations = s->evaluations;
  found->work = s->work;
  found->starts = s->kept;
  memcpy(found->start, s->rough, s->kept * sizeof *s->rough);
  found->at_bound = w->alpha_lower < w->alpha_upper &&
                    (alpha <= w->alpha_lower || alpha >= w->alpha_upper);
}

/* ---- global search --------------------------------------------------- */

/* Keeps the best n starts, in order; others than finite values go last. */
static void insert(struct ph_spatial_start *list, size_t *n, size_t most,
                   const struct ph_spatial_start *start) {
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

/* Local minima in phi, for each b and alpha of a grid. */
struct valley {
  size_t n;
  struct ph_spatial_start at[VALLEYS];
};

struct grid {
  size_t alphas, bs;
  double alpha[ALPHA_MAX];
  struct valley valley[ALPHA_MAX][B_MAX];
};

/* The samples of phi.  D(0) is the smoothest choice as a rule, and the valleys
 * are crowded there. */
static const double PHI[PHI_N] = {-2.4, -1.6, -1.0, -0.6, -0.36, -0.17, 0,
                                  0.17, 0.36, 0.6,  1.0,  1.6,   2.4,   3.141};

/* The least of a parabola through log F at -left, 0, right. */
static double vertex(const double f[3], double left, double right) {
  double fl = log(f[0] / f[1]), fr = log(f[2] / f[1]);
  double x =
      0.5 * (fl * right * right - fr * left * left) / (fl * right + fr * left);
  return isfinite(x) ? x : 0;
}

/* Takes another phi if the functional is less there. */
static double attempt(struct search *s, const struct ph_spatial_section *on,
                      struct ph_spatial_start *best, double phi) {
  struct ph_spatial_start next = *best;
  next.at.phi = phi;
  next.value = section_value(s, on, phi);
  *best = next.value < best->value ? next : *best;
  return next.value;
}

/* A few steps down in phi from the middle of three values. */
static struct ph_spatial_start bottom(struct search *s,
                                      const struct ph_spatial_section *on,
                                      const struct ph_spatial_point *at,
                                      const double three[3], double left,
                                      double right) {
  const double step = 0.3 * (left < right ? left : right);
  struct ph_spatial_start best = {*at, three[1], false}, middle;
  double f[3];
  attempt(s, on, &best, at->phi + vertex(three, left, right));
  middle = best;
  f[0] = attempt(s, on, &best, middle.at.phi - step);
  f[1] = middle.value;
  f[2] = attempt(s, on, &best, middle.at.phi + step);
  if (f[0] >= f[1] && f[2] >= f[1]) {
    attempt(s, on, &best, middle.at.phi + vertex(f, step, step));
  }
  return best;
}

static void fill_valley(struct search *s, double alpha, double b,
                        struct valley *v) {
  struct ph_spatial_section on = ph_spatial_section_of(&s->target, alpha, b);
  double f[PHI_N];
  struct ph_spatial_point at = {b, 0, alpha};
  for (size_t j = 0; j < PHI_N; j++) {
    f[j] = section_value(s, &on, PHI[j]);
    f[j] = isfinite(f[j]) ? f[j] : HUGE_VAL;
  }
  v->n = 0;
  for (size_t j = 0; j < PHI_N; j++) {
    size_t before = (j + PHI_N - 1) % PHI_N, after = (j + 1) % PHI_N;
    const double three[3] = {f[before], f[j], f[after]};
    if (three[1] <= three[0] && three[1] < three[2]) {
      double left = PHI[j] - PHI[before], right = PHI[after] - PHI[j];
      struct ph_spatial_start start;
      at.phi = PHI[j];
      start = bottom(s, &on, &at, three, left > 0 ? left : left + TURN,
                     right > 0 ? right : right + TURN);
      insert(v->at, &v->n, VALLEYS, &start);
    }
  }
}

/* F1 is smoother than the others. */
static void fill(struct search *s, struct grid *g) {
  double lower = s->wanted->alpha_lower, upper = s->wanted->alpha_upper;
  bool smooth = s->wanted->functional == 1;
  g->bs = smooth ? B_MAX / 2 : B_MAX;
  g->alphas = !(lower < upper) ? 1 : smooth ? ALPHA_MAX - 1 : ALPHA_MAX;
  for (size_t k = 0; k < g->alphas; k++) {
    double part =
        g->alphas > 1 ? ((double)k + 0.25) / ((double)g->alphas - 0.5) : 0;
    g->alpha[k] = lower + part * (upper - lower);
    for (size_t i = 0; i < g->bs; i++) {
      fill_valley(s, g->alpha[k], TURN * ((double)i + 0.5) / (double)g->bs,
                  &g->valley[k][i]);
    }
  }
}

/* Whether a valley rises towards its neighbour, or ends. */
static bool rises(const struct ph_spatial_start *from,
                  const struct valley *to) {
  double nearest = APART, value = HUGE_VAL;
  for (size_t i = 0; i < to->n; i++) {
    double d = fabs(remainder(to->at[i].at.phi - from->at.phi, TURN));
    if (d < nearest) {
      nearest = d;
      value = to->at[i].value;
    }
  }
  return value >= from->value;
}

static bool is_least(const struct grid *g, size_t k, size_t i,
                     const struct ph_spatial_start *start) {
  return rises(start, &g->valley[k][(i + 1) % g->bs]) &&
         rises(start, &g->valley[k][(i + g->bs - 1) % g->bs]) &&
         (k == 0 || rises(start, &g->valley[k - 1][i])) &&
         (k + 1 == g->alphas || rises(start, &g->valley[k + 1][i]));
}

/* The members in the plane, descended to the end at once. */
static enum ph_status search_plane(struct search *s, const struct grid *g,
                                   struct ph_spatial_start *best) {
  double b;
  ph_spatial_in_plane(&s->family, s->family.plane_b, &b);
  for (size_t k = 0; k < g->alphas; k++) {
    for (int i = 0; i < 4; i++) {
      struct ph_spatial_start start = {
          {i % 2 ? b + PH_PI : b, i / 2 ? PH_PI : 0, g->alpha[k]}, 0, true};
      enum ph_status status = polish(s, start, best);
      if (status != PH_OK) {
        return status;
      }
    }
  }
  return PH_OK;
}

/* The least of the minima that n places lead to, or what there was. */
static enum ph_status search_from(struct search *s,
                                  struct ph_spatial_start *list, size_t n,
                                  struct ph_spatial_start *best) {
  enum ph_status status = PH_OK;
  s->panels = GRID_PANELS;
  for (size_t i = 0; status == PH_OK && i < n; i++) {
    status = descend(s, ROUGH, ROUGH_STEPS, &list[i]);
    insert(s->rough, &s->kept, STARTS, &list[i]);
  }
  for (size_t i = 0; status == PH_OK && i < s->kept &&
                     s->rough[i].value <= PROMISING * (best->value + SMALL);) {
    status = polish(s, s->rough[i], best);
    if (s->repeated) { /* once is enough, at other tensions too */
      s->kept--;
      memmove(&s->rough[i], &s->rough[i + 1], (s->kept - i) * sizeof *s->rough);
    } else {
      i++;
    }
  }
  return status;
}

static enum ph_status search_grid(struct search *s, const struct grid *g,
                                  struct ph_spatial_start *best) {
  struct ph_spatial_start list[STARTS];
  size_t n = 0;
  for (size_t k = 0; k < g->alphas; k++) {
    for (size_t i = 0; i < g->bs; i++) {
      const struct valley *v = &g->valley[k][i];
      for (size_t j = 0; j < v->n; j++) {
        if (is_least(g, k, i, &v->at[j])) {
          insert(list, &n, STARTS, &v->at[j]);
        }
      }
    }
  }
  return search_from(s, list, n, best);
}

static enum ph_status minimize(const struct ph_spatial_search *search,
                               const struct ph_fair3_rules *rules,
                               struct ph_arena *scratch,
                               struct ph_spatial_minimum *found) {
  struct search s;
  struct grid grid;
  struct ph_spatial_start best = {{0, 0, search->alpha_lower}, HUGE_VAL, false};
  enum ph_status status = PH_OK;
  begin(&s, search, rules, scratch);
  fill(&s, &grid);
  if (s.family.flat) {
    status = search_plane(&s, &grid, &best);
  }
  if (status == PH_OK && !(search->plane && s.family.flat)) {
    status = search_grid(&s, &grid, &best);
  }
  finish(&s, &best, found);
  return status;
}

enum ph_status ph_spatial_descend(const struct ph_spatial_search *search,
                                  const struct ph_fair3_rules *rules,
                                  struct ph_arena *scratch,
                                  struct ph_spatial_minimum *found) {
  struct search s;
  struct ph_spatial_start start = {{0, 0, found->alpha}, 0, false};
  struct ph_spatial_start best = {{0, 0, found->alpha}, HUGE_VAL, false};
  enum ph_status status = PH_OK;
  const double rounding = 1e-12;
  ph_cplx phi = found->member.phi;
  begin(&s, search, rules, scratch);
  start.plane = ph_spatial_in_plane(&s.family, found->member.b, &start.at.b) &&
                fabs(phi.im) <= rounding;
  start.at.phi = !start.plane ? atan2(phi.im, phi.re) : phi.re > 0 ? 0 : PH_PI;
  if (start.plane || found->starts == 0) {
    best.at = start.at;
    status = polish(&s, start, &best);
  }
  if (status == PH_OK) {
    status = search_from(&s, found->start, found->starts, &best);
  }
  finish(&s, &best, found);
  return status;
}

enum ph_status ph_spatial_minimize(const struct ph_spatial_search *search,
                                   const struct ph_fair3_rules *rules,
                                   struct ph_arena *scratch,
                                   struct ph_spatial_minimum *found) {
  enum ph_status status = minimize(search, rules, scratch, found);
  if (status == PH_OK && !isfinite(found->value) && search->functional > 1) {
    struct ph_spatial_search bending = *search;
    const struct ph_spatial_minimum before = *found;
    bending.functional = 1;
    status = minimize(&bending, rules, scratch, found);
    found->evaluations += before.evaluations;
    found->work += before.work;
  }
  return status;
}
