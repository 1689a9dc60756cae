/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Minimisation over angles and knot spacings (see planar.h).
 *
 * The variables are logarithms, in a box; the function is the logarithm of the
 * functional, with its exact gradient (planar.h).  Each evaluation
 * starts Newton's iteration from the solution at the best point so far, with b
 * scaled as 1/sqrt(h), and solves from scratch where that fails.
 *
 * The functionals have several local minima, hence several starts: the data as
 * given, and chordal angles of three sizes or powers of chords.
 * The first of equally good minima is kept.
 *
 * How a curve bends near a point depends on how the intervals beside it
 * compare, and hardly on their size.  So the second derivatives are about
 *
 *   sum over knots of (part k-1 + part k) (x[k] - x[k-1])^2              (1)
 *
 * with the parts of the functional that the segments have: a tridiagonal
 * matrix, which conditions the search.  Angles of ATPH bend their segments as
 * well by themselves, part k / 2 x[k]^2.  Without it the steps that a search
 * takes are about as many as there are intervals.
 *
 * The last search knows more: every few steps second derivatives by differences
 * (kernel/box_hessian.h), of a sum of E or MV and L with the weights that they
 * have there, as their product couples all variables.
 */
#include "solve/planar/planar.h"

#include "curve/fair/energy.h"
#include "curve/segment/seg2.h"
#include "kernel/box_hessian.h"
#include "kernel/pow2.h"

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

/* A part of a functional is at least this part of the mean; and what an angle
 * of ATPH does by itself, over what it does beside its neighbours. */
static const double PART_MIN = 1e-3, ANGLE = 0.5;

/* Curves of less than that are straight: what they bend is rounding.  At unit
 * scale, where curves have a size of about 1. */
static const double STRAIGHT = 1e-16;

/* Starts, steps from each of them, and more of E and MV: loops that grow have
 * less and less of these.  Of large data no more than WORK_MAX / n. */
enum { STARTS = 7, STEPS_FIRST = 32, STEPS_GROWING = 48, WORK_MAX = 200000 };

/* Of the last search: how far second derivatives are from the diagonal, and how
 * many steps are taken with the same. */
enum { NEAR = 8, ROUND = 20 };

struct candidate {
  double *spacing;  /* [n] */
  ph_cplx *b;       /* [unknowns] */
  double *h;        /* [n] as in the data */
  ph_cplx twist;    /* closed */
  double *part;     /* [n] of E or MV that the segments have */
  double energy[3]; /* E, MV, L at unit scale */
  double value;     /* of the functional, at unit scale; or NaN */
};

struct work {
  struct ph_planar_data *data;
  enum ph_planar_functional functional;
  bool scale;
  size_t variables, unknowns;
  const double *shape; /* [n] spacings = shape, or 1, times exp(variable) */
  struct ph_arena *scratch;
  struct ph_diag *diag;
  struct ph_energy_sum sum;
  struct ph_planar_gradient gradient;
  ph_cplx *guess;
  double *pivot, *beside; /* [n] of the matrix (1) */
  struct ph_box_hessian hessian;
  struct candidate now, trial, best;
  const struct candidate *last; /* what the last value was of */
  double weight[3];             /* of E, MV, L where `weighted` */
  bool weighted;
  bool warm; /* `now` holds a solution */
  size_t evaluations;
};

static double functional_of(enum ph_planar_functional functional,
                            const double energy[3]) {
  double length = energy[2];
  switch (functional) {
  case PH_PLANAR_E:
    return energy[0];
  case PH_PLANAR_MV:
    return energy[1];
  case PH_PLANAR_IES:
    return energy[0] * length;
  case PH_PLANAR_IMV:
    break;
  }
  return energy[1] * length * length * length;
}

/* Derivatives of the functional with respect to E, MV, L. */
static void weights_of(enum ph_planar_functional functional,
                       const double energy[3], double weight[3]) {
  double length = energy[2];
  weight[0] = weight[1] = weight[2] = 0;
  switch (functional) {
  case PH_PLANAR_E:
    weight[0] = 1;
    break;
  case PH_PLANAR_MV:
    weight[1] = 1;
    break;
  case PH_PLANAR_IES:
    weight[0] = length;
    weight[2] = energy[0];
    break;
  case PH_PLANAR_IMV:
    weight[1] = length * length * length;
    weight[2] = 3 * energy[1] * length * length;
    break;
  }
}

/* From unit scale to the unit of the data; not finite out of range. */
static double in_user_unit(const struct work *w, double value) {
  int power = w->functional == PH_PLANAR_E    ? 1
              : w->functional == PH_PLANAR_MV ? 3
                                              : 0;
  return ph_pow2_positive(value, power * w->data->exponent);
}

/* The energy that is minimised, or a factor of what is. */
static const struct ph_sum *sum_of(const struct work *w) {
  bool bends = w->functional == PH_PLANAR_E || w->functional == PH_PLANAR_IES;
  return bends ? &w->sum.bending : &w->sum.varying;
}

/* Energies of the trial's curve; in NaN where it stands still. */
static void measure(struct work *w) {
  const struct ph_planar_data *d = w->data;
  struct candidate *t = &w->trial;
  struct ph_sum length = {0, 0};
  ph_energy_clear(&w->sum);
  for (size_t k = 0; k < d->n; k++) {
    struct ph_seg2 seg = {
        *ph_planar_space(&d->c2, k), {{0, 0}}, {0, 0}, {0, 0}};
    double root = sqrt(d->h[k]);
    ph_planar_preimage(&d->c2, t->b, k, seg.w);
    for (size_t i = 0; i < 3; i++) {
      seg.w[i] = ph_cplx_scale(root, seg.w[i]);
    }
    t->part[k] = -ph_sum_value(sum_of(w));
    ph_energy_add(&w->sum, &seg);
    t->part[k] += ph_sum_value(sum_of(w));
    ph_sum_add(&length, ph_seg2_length(&seg.space, seg.w));
  }
  t->energy[0] = ph_sum_value(&w->sum.bending);
  t->energy[1] = ph_sum_value(&w->sum.varying);
  t->energy[2] = ph_sum_value(&length);
  t->value = functional_of(w->functional, t->energy);
}

/* Newton from the solution at `now`. */
static enum ph_status solve_near(struct work *w, bool *solved) {
  struct ph_planar_c2 *c2 = &w->data->c2;
  size_t n = w->data->n, shift = c2->closed ? 0 : 1;
  for (size_t k = 0; k < n; k++) {
    double factor = sqrt(w->now.h[k] / w->data->h[k]);
    w->guess[k + shift] = ph_cplx_scale(factor, w->now.b[k + shift]);
    if (!c2->closed && k == 0) {
      w->guess[0] = ph_cplx_scale(factor, w->now.b[0]);
    }
    if (!c2->closed && k + 1 == n) {
      w->guess[n + 1] = ph_cplx_scale(factor, w->now.b[n + 1]);
    }
  }
  c2->twist = w->now.twist;
  return ph_planar_c2_near(c2, w->scratch, w->guess, w->trial.b, solved,
                           w->diag);
}

/* The solution for the data as they are, and its energies, into the trial.
 * No solution: a value that is NaN, and PH_OK. */
static enum ph_status solve_trial(struct work *w) {
  struct ph_planar_data *d = w->data;
  struct candidate *t = &w->trial;
  struct ph_planar_report report;
  bool solved = false;
  enum ph_status status = w->warm ? solve_near(w, &solved) : PH_OK;
  t->value = (double)NAN;
  w->evaluations++;
  if (status == PH_OK && !solved) {
    struct ph_mark mark = ph_arena_mark(w->scratch);
    status = ph_planar_c2_solve(&d->c2, w->scratch, t->b, &report, w->diag);
    ph_arena_release(w->scratch, mark);
    solved = status == PH_OK;
    status = status == PH_E_NO_CONVERGENCE ? PH_OK : status;
  }
  if (solved) {
    t->twist = d->c2.twist;
    memcpy(t->h, d->h, d->n * sizeof *t->h);
    if (w->weighted) {
      t->value = w->now.value; /* of no use: weights are held fixed */
    } else {
      measure(w);
    }
  }
  return status;
}

static void copy(struct candidate *to, const struct candidate *from,
                 const struct work *w) {
  size_t n = w->data->n;
  memcpy(to->spacing, from->spacing, n * sizeof *to->spacing);
  memcpy(to->h, from->h, n * sizeof *to->h);
  memcpy(to->part, from->part, n * sizeof *to->part);
  memcpy(to->b, from->b, w->unknowns * sizeof *to->b);
  memcpy(to->energy, from->energy, sizeof to->energy);
  to->twist = from->twist;
  to->value = from->value;
}

static enum ph_status value(void *context, const double *x, double *result) {
  struct work *w = context;
  struct candidate *t = &w->trial;
  enum ph_status status;
  for (size_t k = 0; k < w->data->n; k++) {
    t->spacing[k] = w->scale ? w->shape[k] * exp(x[0]) : exp(x[k]);
  }
  *result = (double)NAN;
  if (ph_planar_data_space(w->data, t->spacing, w->diag) != PH_OK) {
    return PH_OK;
  }
  status = solve_trial(w);
  w->last = t;
  *result = log(t->value + STRAIGHT);
  return status;
}

static void accept(void *context) {
  struct work *w = context;
  struct candidate keep = w->now;
  w->now = w->trial;
  w->trial = keep;
  w->last = &w->now;
  w->warm = true;
}

/* The weights of the logarithm's derivatives. */
static void weigh(struct work *w, const struct candidate *at) {
  weights_of(w->functional, at->energy, w->weight);
  for (size_t i = 0; i < 3; i++) {
    w->weight[i] /= at->value + STRAIGHT;
  }
}

static void gradient(void *context, double *result) {
  struct work *w = context;
  const struct ph_planar_data *d = w->data;
  struct ph_planar_gradient *g = &w->gradient;
  double sum = 0;
  if (!w->weighted) {
    weigh(w, w->last);
  }
  ph_planar_gradient_of(g, d, w->last->b, w->weight);
  result[0] = 0;
  for (size_t k = 0; k < d->n; k++) {
    double by_h = d->atph && d->own_knots ? 0 : g->by_h[k];
    double change = by_h + (d->atph ? g->by_angle[k] : 0);
    sum += change;
    result[w->scale ? 0 : k] = w->scale ? sum : change;
  }
  for (size_t k = 0; !d->atph && k < d->n; k++) {
    result[k] -= sum * d->h[k] / (double)d->n; /* the mean of h is fixed */
  }
}

/* v <- the inverse of (1) times v, over the variables that are not fixed. */
static void condition(void *context, const bool *fixed, double *v) {
  const struct work *w = context;
  const double *part = w->now.part;
  size_t n = w->data->n;
  double sum = 0, least, own = w->data->atph ? ANGLE : 0;
  for (size_t k = 0; k < n; k++) {
    sum += part[k];
  }
  if (!(sum > 0)) {
    return; /* straight */
  }
  least = PART_MIN / (double)n;
  for (size_t k = 0; k < n; k++) {
    double before = k > 0 ? (part[k - 1] + part[k]) / sum + least : 0;
    double after = k + 1 < n ? (part[k] + part[k + 1]) / sum + least : 0;
    bool joined = k > 0 && !fixed[k] && !fixed[k - 1];
    w->beside[k] = joined ? -before : 0;
    w->pivot[k] = before + after + least + own * part[k] / sum;
    v[k] = fixed[k] ? 0 : v[k];
    if (joined) {
      double factor = w->beside[k] / w->pivot[k - 1];
      w->pivot[k] -= factor * w->beside[k];
      v[k] -= factor * v[k - 1];
    }
  }
  for (size_t k = n; k-- > 0;) {
    double after = k + 1 < n ? w->beside[k + 1] * v[k + 1] : 0;
    v[k] = (v[k] - after) / w->pivot[k];
  }
}

static bool candidate_alloc(struct candidate *c, const struct work *w) {
  size_t n = w->data->n;
  c->spacing = ph_arena_array(w->scratch, n, sizeof *c->spacing);
  c->h = ph_arena_array(w->scratch, n, sizeof *c->h);
  c->part = ph_arena_array(w->scratch, n, sizeof *c->part);
  c->b = ph_arena_array(w->scratch, w->unknowns, sizeof *c->b);
  c->value = (double)NAN;
  return c->spacing && c->h && c->part && c->b;
}

static enum ph_status allocate(struct work *w) {
  w->guess = ph_arena_array(w->scratch, w->unknowns, sizeof *w->guess);
  w->pivot = ph_arena_array(w->scratch, w->data->n, sizeof *w->pivot);
  w->beside = ph_arena_array(w->scratch, w->data->n, sizeof *w->beside);
  if (!w->guess || !w->pivot || !w->beside || !candidate_alloc(&w->now, w) ||
      !candidate_alloc(&w->trial, w) || !candidate_alloc(&w->best, w) ||
      !ph_energy_begin(&w->sum)) {
    return ph_fail_memory(w->diag);
  }
  if (ph_box_hessian_alloc(&w->hessian, w->scratch, w->data->n, NEAR)) {
    return ph_fail_memory(w->diag);
  }
  return ph_planar_gradient_alloc(&w->gradient, w->data, w->scratch, w->diag);
}

/* Spacings of start number i; the first is what the data have. */
static void start_of(const struct work *w, size_t i, const double *given,
                     double *spacing) {
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
  double *given, *shape, *x, *best, *lower, *upper;
  double *tried; /* [STARTS][n] */
};

static enum ph_status room_alloc(struct room *r, size_t n,
                                 struct ph_arena *arena, struct ph_diag *diag) {
  double *v = ph_arena_array(arena, n, (6 + STARTS) * sizeof *v);
  if (!v) {
    return ph_fail_memory(diag);
  }
  r->given = v;
  r->shape = v + n;
  r->x = v + 2 * n;
  r->lower = v + 3 * n;
  r->upper = v + 4 * n;
  r->best = v + 5 * n;
  r->tried = v + 6 * n;
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
static void enter(const struct work *w, struct room *r, size_t start) {
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
static bool is_another(const struct work *w, struct room *r, size_t start) {
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

static bool touches(const struct work *w, const struct room *r,
                    const double *x) {
  for (size_t k = 0; k < w->variables; k++) {
    if (x[k] <= r->lower[k] || x[k] >= r->upper[k]) {
      return true;
    }
  }
  return false;
}

static struct ph_box box_of(struct work *w, const struct room *r,
                            size_t steps_max, double decrease) {
  return (struct ph_box){.n = w->variables,
                         .lower = r->lower,
                         .upper = r->upper,
                         .decrease = decrease,
                         .steps_max = steps_max,
                         .context = w,
                         .value = value,
                         .gradient = gradient,
                         .accept = accept,
                         .condition = w->scale ? NULL : condition};
}

/* One search from the variables in r->x; keeps what is better than the best. */
static enum ph_status descend(struct work *w, struct room *r,
                              const struct ph_box *box, double better,
                              struct ph_box_report *found) {
  enum ph_status status = ph_box_minimize(box, w->scratch, r->x, found);
  if (status == PH_OK && w->warm &&
      !(w->now.value >= w->best.value * (1 - better))) {
    copy(&w->best, &w->now, w);
    memcpy(r->best, r->x, w->variables * sizeof *r->best);
  }
  return status;
}

static void condition_by_differences(void *context, const bool *fixed,
                                     double *v) {
  struct work *w = context;
  ph_box_hessian_solve(&w->hessian, fixed, v);
}

/* The last search, from the best of all starts, to all digits. */
static enum ph_status finish(struct work *w, struct room *r, size_t steps_max,
                             struct ph_box_report *found) {
  enum ph_status status = PH_OK;
  *found = (struct ph_box_report){0};
  for (size_t i = 0; status == PH_OK && !found->converged && i < steps_max;
       i += ROUND) {
    size_t left = steps_max - i;
    struct ph_box box = box_of(w, r, left < ROUND ? left : ROUND, GAIN);
    if (!w->scale) {
      weigh(w, &w->now);
      w->weighted = true;
      status = ph_box_hessian_find(&w->hessian, &box, r->x);
      w->weighted = false;
      box.to_scale = w->hessian.found;
      box.condition = box.to_scale ? condition_by_differences : condition;
    }
    status = status == PH_OK ? descend(w, r, &box, 0, found) : status;
  }
  return status;
}

/* From every start to some digits, from the best of them to all. */
static enum ph_status search(struct work *w, struct room *r,
                             struct ph_planar_min *report, bool *converged) {
  bool grows = w->functional == PH_PLANAR_E || w->functional == PH_PLANAR_MV;
  size_t work = 1 + WORK_MAX / w->data->n;
  size_t first = grows ? STEPS_GROWING : STEPS_FIRST;
  struct ph_box box;
  struct ph_box_report found = {0};
  enum ph_status status = PH_OK;
  report->steps_max = work < report->steps_max ? work : report->steps_max;
  first = first < report->steps_max ? first : report->steps_max;
  box = box_of(w, r, first, COARSE);
  for (size_t i = 0; status == PH_OK && i < STARTS; i++) {
    w->warm = false;
    enter(w, r, i);
    if (is_another(w, r, i)) {
      status = descend(w, r, &box, BETTER, &found);
    }
  }
  if (status == PH_OK && !isnan(w->best.value)) {
    memcpy(r->x, r->best, w->variables * sizeof *r->x);
    copy(&w->now, &w->best, w);
    w->warm = true;
    status = finish(w, r, report->steps_max, &found);
    report->at_bound = touches(w, r, r->best);
  }
  *converged = found.converged || found.gain <= DONE;
  return status == PH_E_NO_MEMORY ? ph_fail_memory(w->diag) : status;
}

static enum ph_status conclude(struct work *w, ph_cplx *b, bool converged,
                               struct ph_planar_min *report) {
  struct ph_planar_data *d = w->data;
  enum ph_status status = ph_planar_data_space(d, w->best.spacing, w->diag);
  report->minimum = in_user_unit(w, w->best.value);
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

static enum ph_status run(struct work *w, ph_cplx *b,
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
  status = solve_trial(w);
  if (status == PH_OK) {
    report->start = in_user_unit(w, w->trial.value);
    memcpy(w->trial.spacing, room.given, w->data->n * sizeof *room.given);
    copy(&w->best, &w->trial, w);
    w->best.value = (double)NAN; /* may be outside the box */
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
  struct work w = {.data = data,
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
