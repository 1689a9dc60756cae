/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Minimisation over angles and knot spacings (see planar.h), in a box.
 *
 * The functionals have several local minima, hence several starts: the data as
 * given, and chordal angles of three sizes or powers of chords.
 * What each comes to is crossed with the best (min_cross.c); the first of
 * equally good minima is kept.  All that is never above the curve that
 * ph_planar_choose takes for the data as given: the last search begins there
 * where no start came below it.
 *
 * A search begins with the matrix (1) of min_value.c.  The last one knows more,
 * and so do some before it: every few steps second derivatives by differences
 * (kernel/box_hessian.h), of a sum of E or MV and L with the weights that they
 * have there, as their product couples all variables.
 */
#include "solve/planar/min.h"

#include <math.h>
#include <string.h>

static const double ANGLE_MIN = 1e-3, ANGLE_MAX = 2.0943951023931953;
static const double SPACING_RANGE = 20;

/* Gains of a step, relative, that count as none: of the starts, and in the end;
 * with the latter a search that is cut short is as good as done; of one start
 * over another. */
static const double COARSE = 1e-6, GAIN = 1e-13, DONE = 1e-8, BETTER = 1e-5;

/* Logarithms of spacings that differ by rounding. */
static const double SAME = 1e-12;

/* Starts.  Of large data no more than WORK_MAX / n steps. */
enum { STARTS = 7, WORK_MAX = 200000 };

/* How far second derivatives are from the diagonal, and how many steps the last
 * search takes with the same: with 20 MV of 320 points takes 6 % longer. */
enum { NEAR = 8, ROUND = 30 };

static bool candidate_alloc(struct ph_planar_candidate *c,
                            const struct ph_planar_work *w) {
  size_t n = w->data->n;
  c->spacing = ph_arena_array(w->scratch, n, sizeof *c->spacing);
  c->h = ph_arena_array(w->scratch, n, sizeof *c->h);
  c->part = ph_arena_array(w->scratch, n, sizeof *c->part);
  c->length = ph_arena_array(w->scratch, n, sizeof *c->length);
  c->b = ph_arena_array(w->scratch, w->unknowns, sizeof *c->b);
  c->value = (double)NAN;
  return c->spacing && c->h && c->part && c->length && c->b;
}

static enum ph_status allocate(struct ph_planar_work *w) {
  w->guess = ph_arena_array(w->scratch, w->unknowns, sizeof *w->guess);
  w->pivot = ph_arena_array(w->scratch, w->data->n, sizeof *w->pivot);
  w->beside = ph_arena_array(w->scratch, w->data->n, sizeof *w->beside);
  if (!w->guess || !w->pivot || !w->beside || !candidate_alloc(&w->now, w) ||
      !candidate_alloc(&w->trial, w) || !candidate_alloc(&w->best, w) ||
      !candidate_alloc(&w->chosen, w) || !ph_energy_begin(&w->sum)) {
    return ph_fail_memory(w->diag);
  }
  if (ph_box_hessian_alloc(&w->hessian, w->scratch, w->data->n, NEAR)) {
    return ph_fail_memory(w->diag);
  }
  return ph_planar_gradient_alloc(&w->gradient, w->data, w->scratch, w->diag);
}

/* Spacings of start number i; the first is what the data have. */
static void start_of(const struct ph_planar_work *w, size_t i,
                     const double *given, double *spacing) {
  static const double angle[STARTS] = {0, 0.4, 1, 1.8, 1, 1, 1};
  static const double power[STARTS] = {0, 1, 1, 1, 0.5, 0.25, 0};
  const struct ph_planar_data *d = w->data;
  if (i == 0) {
    memcpy(spacing, given, d->n * sizeof *spacing);
  } else {
    ph_planar_data_chordal(d, power[i], angle[i], spacing);
  }
}

struct room {
  double *given, *shape, *x, *best, *crossed, *lower, *upper;
  double *tried; /* [STARTS][n] */
};

static enum ph_status room_alloc(struct room *r, size_t n,
                                 struct ph_arena *arena, struct ph_diag *diag) {
  double *v = ph_arena_array(arena, n, (7 + STARTS) * sizeof *v);
  if (!v) {
    return ph_fail_memory(diag);
  }
  r->given = v;
  r->shape = v + n;
  r->x = v + 2 * n;
  r->lower = v + 3 * n;
  r->upper = v + 4 * n;
  r->best = v + 5 * n;
  r->crossed = v + 6 * n;
  r->tried = v + 7 * n;
  return PH_OK;
}

/* Angles as given; knot spacings and chordal ones with the same sum. */
static void describe(const struct ph_planar_data *d, struct room *r) {
  double sum = 0, largest = 0;
  ph_planar_data_chordal(d, 1, 1, r->shape);
  for (size_t k = 0; k < d->n; k++) {
    sum += r->shape[k];
    r->given[k] = d->atph ? d->space[k].angle : d->h[k];
    largest = r->given[k] > largest ? r->given[k] : largest;
  }
  for (size_t k = 0; k < d->n; k++) {
    double chordal = r->shape[k] * (double)d->n / sum;
    r->lower[k] = log(d->atph ? ANGLE_MIN : chordal / SPACING_RANGE);
    r->upper[k] = log(d->atph ? ANGLE_MAX : chordal * SPACING_RANGE);
    r->shape[k] = r->given[k] / largest;
  }
}

/* The variables of a start, moved into the box. */
static void enter(const struct ph_planar_work *w, struct room *r,
                  size_t start) {
  double *spacing = w->trial.spacing, sum = 0, largest = 0;
  size_t n = w->data->n;
  start_of(w, start, r->given, spacing);
  for (size_t k = 0; k < n; k++) {
    sum += spacing[k];
    largest = spacing[k] > largest ? spacing[k] : largest;
  }
  for (size_t k = 0; k < w->variables; k++) {
    double v = w->scale        ? largest
               : w->data->atph ? spacing[k]
                               : spacing[k] * (double)n / sum;
    double x = log(v);
    x = x < r->lower[k] ? r->lower[k] : x;
    r->x[k] = x > r->upper[k] ? r->upper[k] : x;
  }
}

/* Whether a start is another than those before it: knots have no size of their
 * own, and the data may have what a start would give them. */
static bool is_another(const struct ph_planar_work *w, struct room *r,
                       size_t start) {
  size_t n = w->variables;
  memcpy(r->tried + start * n, r->x, n * sizeof *r->x);
  for (size_t i = 0; i < start; i++) {
    size_t k = 0;
    while (k < n && fabs(r->x[k] - r->tried[i * n + k]) <= SAME) {
      k++;
    }
    if (k == n) {
      return false;
    }
  }
  return true;
}

static bool touches(const struct ph_planar_work *w, const struct room *r,
                    const double *x) {
  for (size_t k = 0; k < w->variables; k++) {
    if (x[k] <= r->lower[k] || x[k] >= r->upper[k]) {
      return true;
    }
  }
  return false;
}

static struct ph_box box_of(struct ph_planar_work *w, const struct room *r,
                            size_t steps_max, double decrease) {
  return (struct ph_box){.n = w->variables,
                         .lower = r->lower,
                         .upper = r->upper,
                         .decrease = decrease,
                         .steps_max = steps_max,
                         .context = w,
                         .value = ph_planar_min_value,
                         .gradient = ph_planar_min_gradient,
                         .accept = ph_planar_min_accept,
                         .condition =
                             w->scale ? NULL : ph_planar_min_condition};
}

/* Keeps what a search came to if it is better than the best. */
static void keep(struct ph_planar_work *w, struct room *r, double better) {
  if (w->warm && !(w->now.value >= w->best.value * (1 - better))) {
    ph_planar_min_copy(&w->best, &w->now, w);
    memcpy(r->best, r->x, w->variables * sizeof *r->best);
  }
}

static size_t least(size_t a, size_t b) {
  return a < b ? a : b;
}

static void condition_by_differences(void *context, const bool *fixed,
                                     double *v) {
  struct ph_planar_work *w = context;
  ph_box_hessian_solve(&w->hessian, fixed, v);
}

/* A search with second derivatives, from where another one ended. */
static enum ph_status descend_by_differences(struct ph_planar_work *w,
                                             struct room *r, struct ph_box *box,
                                             struct ph_box_report *found) {
  enum ph_status status;
  ph_planar_min_weigh(w, &w->now);
  w->weighted = true;
  status = ph_box_hessian_find(&w->hessian, box, r->x);
  w->weighted = false;
  box->to_scale = w->hessian.found;
  box->condition =
      box->to_scale ? condition_by_differences : ph_planar_min_condition;
  return status == PH_OK ? ph_box_minimize(box, w->scratch, r->x, found)
                         : status;
}

/* The search from one start, to some digits, crossed with the best. */
static enum ph_status descend_twice(struct ph_planar_work *w, struct room *r,
                                    const size_t steps[2]) {
  struct ph_box box = box_of(w, r, steps[0], COARSE);
  struct ph_box_report found = {0};
  enum ph_status status = ph_box_minimize(&box, w->scratch, r->x, &found);
  if (status == PH_OK && w->warm && !found.converged && steps[1] > 0) {
    box.steps_max = steps[1];
    status = descend_by_differences(w, r, &box, &found);
  }
  if (status == PH_OK) {
    status = ph_planar_min_cross(w, &box, r->best, r->x, r->crossed);
    keep(w, r, BETTER);
  }
  return status;
}

/* The last search, from the best of all starts, to all digits. */
static enum ph_status finish(struct ph_planar_work *w, struct room *r,
                             size_t steps_max, struct ph_box_report *found) {
  enum ph_status status = PH_OK;
  *found = (struct ph_box_report){0};
  for (size_t i = 0; status == PH_OK && !found->converged && i < steps_max;
       i += ROUND) {
    struct ph_box box = box_of(w, r, least(ROUND, steps_max - i), GAIN);
    status = w->scale ? ph_box_minimize(&box, w->scratch, r->x, found)
                      : descend_by_differences(w, r, &box, found);
  }
  keep(w, r, 0);
  return status;
}

/*
 * Steps from each start, with the matrix (1) and then with second derivatives.
 *
 * With (1) alone MV of many points is far from its minimum after 48: of 60
 * random walks of 60 points, PH, it ends 46 % lower like this (the mean of the
 * logarithms), IMV 4 % and IES .06 %.  E wants all 48, as loops that grow have
 * less of it: with 8 and 30 it ends 4 % higher at 30 points.  So do angles of
 * ATPH: with 8 and 30, MV of 12 points ends higher in 22 of 40 and lower in 7.
 *
 * Of more than `few' variables the last ones are fewer, by a power of these:
 * what is fair in places is crossed, and the search from the best goes on,
 * which needs more steps of many variables.  Against all steps and nothing
 * crossed IES of 60 walks of 120 points ends .1 % lower then, but with a third
 * as the power, MV 27 % higher, IMV of ATPH .8 %, and IES of ATPH of 240 points
 * .2 %.
 */
struct plan {
  size_t first, second, few;
  double power;
};

/* Steps of the second kind, or of the first where there is no other, for n
 * variables. */
static size_t fewer(const struct plan *p, size_t n) {
  size_t steps = p->second > 0 ? p->second : p->first;
  double part = pow((double)p->few / (double)n, p->power);
  return part < 1 ? (size_t)((double)steps * part + 0.5) : steps;
}

static void plan(const struct ph_planar_work *w, size_t most, size_t steps[2]) {
  static const struct plan alone[] = {
      {48, 0, 1, 0}, {48, 0, 1, 0}, {32, 0, 40, 0.25}, {32, 0, 1, 0}};
  static const struct plan both[] = {{48, 10, 1, 0},
                                     {8, 30, 1, 0},
                                     {8, 20, 20, 1.0 / 3},
                                     {8, 20, 20, 1.0 / 3}};
  const bool is_alone = w->scale || w->data->atph;
  const struct plan *p = (is_alone ? alone : both) + w->functional;
  const size_t last = fewer(p, w->variables);
  steps[0] = least(is_alone ? last : p->first, most);
  steps[1] = is_alone ? 0 : least(last, most - steps[0]);
}

/* The curve that is made where nothing is minimised is kept if no start came
 * below it: its turns may be others than those from a chord start. */
static enum ph_status compare_chosen(struct ph_planar_work *w, struct room *r) {
  double value;
  enum ph_status status;
  if (isnan(w->chosen.value) || w->chosen.value >= w->best.value) {
    return PH_OK;
  }
  ph_planar_min_copy(&w->now, &w->chosen, w);
  w->warm = true;
  enter(w, r, 0);
  status = ph_planar_min_value(w, r->x, &value);
  if (status == PH_OK && w->trial.value < HUGE_VAL) {
    ph_planar_min_accept(w);
    keep(w, r, 0);
  }
  return status;
}

/* From every start to some digits, from the best of them to all. */
static enum ph_status search(struct ph_planar_work *w, struct room *r,
                             struct ph_planar_min *report, bool *converged) {
  struct ph_box_report found = {0};
  enum ph_status status = PH_OK;
  size_t steps[2];
  report->steps_max = least(report->steps_max, 1 + WORK_MAX / w->data->n);
  plan(w, report->steps_max, steps);
  for (size_t i = 0; status == PH_OK && i < STARTS; i++) {
    w->warm = false;
    enter(w, r, i);
    if (is_another(w, r, i)) {
      status = descend_twice(w, r, steps);
    }
  }
  if (status == PH_OK) {
    status = compare_chosen(w, r);
  }
  if (status == PH_OK && !isnan(w->best.value)) {
    memcpy(r->x, r->best, w->variables * sizeof *r->x);
    ph_planar_min_copy(&w->now, &w->best, w);
    w->warm = true;
    status = finish(w, r, report->steps_max, &found);
    report->at_bound = touches(w, r, r->best);
  }
  *converged = found.converged || found.gain <= DONE;
  return status == PH_E_NO_MEMORY ? ph_fail_memory(w->diag) : status;
}

static enum ph_status conclude(struct ph_planar_work *w, ph_cplx *b,
                               bool converged, struct ph_planar_min *report) {
  struct ph_planar_data *d = w->data;
  enum ph_status status = ph_planar_data_space(d, w->best.spacing, w->diag);
  report->minimum = ph_planar_min_in_user_unit(w, w->best.value);
  report->evaluations = w->evaluations;
  if (isnan(w->best.value)) {
    return ph_fail(w->diag, PH_E_NO_CONVERGENCE, "minimize",
                   "found no solution at any of its starts");
  }
  d->c2.twist = w->best.twist;
  memcpy(b, w->best.b, w->unknowns * sizeof *b);
  report->cut_short = !converged;
  return status;
}

static enum ph_status run(struct ph_planar_work *w, ph_cplx *b,
                          struct ph_planar_min *report) {
  struct room room = {0};
  bool converged = false;
  enum ph_status status = allocate(w);
  if (status == PH_OK) {
    status = room_alloc(&room, w->data->n, w->scratch, w->diag);
  }
  if (status != PH_OK) {
    return status;
  }
  describe(w->data, &room);
  w->shape = room.shape;
  status = ph_planar_min_solve_trial(w);
  if (status == PH_OK) {
    report->start = ph_planar_min_in_user_unit(w, w->trial.value);
    memcpy(w->trial.spacing, room.given, w->data->n * sizeof *room.given);
    ph_planar_min_copy(&w->best, &w->trial, w);
    w->best.value = (double)NAN; /* may be outside the box */
    if (ph_planar_turns_sharply(&w->data->c2)) {
      status = ph_planar_min_solve_default(w);
      ph_planar_min_copy(&w->chosen, &w->trial, w);
    }
  }
  if (status == PH_OK) {
    status = search(w, &room, report, &converged);
  }
  return status == PH_OK ? conclude(w, b, converged, report) : status;
}

enum ph_status ph_planar_minimize(struct ph_planar_data *data,
                                  enum ph_planar_functional functional,
                                  bool scale, size_t steps_max,
                                  struct ph_arena *scratch, ph_cplx *b,
                                  struct ph_planar_min *report,
                                  struct ph_diag *diag) {
  struct ph_mark mark = ph_arena_mark(scratch);
  struct ph_planar_work w = {.data = data,
                             .functional = functional,
                             .scale = scale,
                             .variables = scale ? 1 : data->n,
                             .unknowns = ph_planar_unknowns(&data->c2),
                             .scratch = scratch,
                             .diag = diag};
  enum ph_status status;
  *report = (struct ph_planar_min){(double)NAN, (double)NAN, 0,
                                   steps_max,   false,       false};
  if (scale && !data->atph) {
    return ph_fail(diag, PH_E_BAD_VALUE, "free",
                   "must be \"each\" for \"basis\":\"ph\": the knots of PH "
                   "quintics have no scale of their own");
  }
  status = run(&w, b, report);
  ph_arena_release(scratch, mark);
  return status;
}
