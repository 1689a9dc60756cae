/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The function that planar splines are minimised by (see min.h): its variables
 * are logarithms, and it is that of the functional, with its exact gradient
 * (planar.h).  Each evaluation starts Newton's iteration from the solution at
 * the best point so far, with b scaled as 1/sqrt(h), and solves from scratch
 * where that fails.
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
 */
#include "solve/planar/min.h"

#include "curve/segment/seg2.h"
#include "kernel/pow2.h"

#include <math.h>
#include <string.h>

/* A part of a functional is at least this part of the mean; and what an angle
 * of ATPH does by itself, over what it does beside its neighbours. */
static const double PART_MIN = 1e-3, ANGLE = 0.5;

/* Curves of less than that are straight: what they bend is rounding.  At unit
 * scale, where curves have a size of about 1. */
static const double STRAIGHT = 1e-16;

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
double ph_planar_min_in_user_unit(const struct ph_planar_work *w,
                                  double value) {
  int power = w->functional == PH_PLANAR_E    ? 1
              : w->functional == PH_PLANAR_MV ? 3
                                              : 0;
  return ph_pow2_positive(value, power * w->data->exponent);
}

/* The energy that is minimised, or a factor of what is. */
static const struct ph_sum *sum_of(const struct ph_planar_work *w) {
  bool bends = w->functional == PH_PLANAR_E || w->functional == PH_PLANAR_IES;
  return bends ? &w->sum.bending : &w->sum.varying;
}

/* Energies of the trial's curve; in NaN where it stands still. */
static void measure(struct ph_planar_work *w) {
  const struct ph_planar_data *d = w->data;
  struct ph_planar_candidate *t = &w->trial;
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
    t->length[k] = ph_seg2_length(&seg.space, seg.w);
    ph_sum_add(&length, t->length[k]);
  }
  t->energy[0] = ph_sum_value(&w->sum.bending);
  t->energy[1] = ph_sum_value(&w->sum.varying);
  t->energy[2] = ph_sum_value(&length);
  t->value = functional_of(w->functional, t->energy);
}

/* Newton from the solution at `now`. */
static enum ph_status solve_near(struct ph_planar_work *w, bool *solved) {
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

/* What was solved for the data as they are, into the trial. */
static void record(struct ph_planar_work *w) {
  const struct ph_planar_data *d = w->data;
  struct ph_planar_candidate *t = &w->trial;
  t->twist = d->c2.twist;
  memcpy(t->h, d->h, d->n * sizeof *t->h);
  if (w->weighted) {
    t->value = w->now.value; /* of no use: weights are held fixed */
  } else {
    measure(w);
  }
}

/* The solution for the data as they are, and its energies, into the trial.
 * No solution: a value that is NaN, and PH_OK. */
enum ph_status ph_planar_min_solve_trial(struct ph_planar_work *w) {
  struct ph_planar_data *d = w->data;
  struct ph_planar_candidate *t = &w->trial;
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
    record(w);
  }
  return status;
}

enum ph_status ph_planar_min_solve_default(struct ph_planar_work *w) {
  struct ph_planar_data *d = w->data;
  struct ph_mark mark = ph_arena_mark(w->scratch);
  struct ph_planar_report report;
  struct ph_planar_second second;
  struct ph_planar_choice choice;
  enum ph_status status = ph_planar_c2_both(&d->c2, w->scratch, w->trial.b,
                                            &report, &second, w->diag);
  bool solved = status == PH_OK;
  w->trial.value = (double)NAN;
  if (solved) {
    status = ph_planar_choose(d, w->scratch, w->trial.b, &report, &second,
                              &choice, w->diag);
  }
  ph_arena_release(w->scratch, mark);
  if (solved && status == PH_OK) {
    record(w);
  }
  return status == PH_E_NO_CONVERGENCE ? PH_OK : status;
}

void ph_planar_min_copy(struct ph_planar_candidate *to,
                        const struct ph_planar_candidate *from,
                        const struct ph_planar_work *w) {
  size_t n = w->data->n;
  memcpy(to->spacing, from->spacing, n * sizeof *to->spacing);
  memcpy(to->h, from->h, n * sizeof *to->h);
  memcpy(to->part, from->part, n * sizeof *to->part);
  memcpy(to->length, from->length, n * sizeof *to->length);
  memcpy(to->b, from->b, w->unknowns * sizeof *to->b);
  memcpy(to->energy, from->energy, sizeof to->energy);
  to->twist = from->twist;
  to->value = from->value;
}

enum ph_status ph_planar_min_value(void *context, const double *x,
                                   double *result) {
  struct ph_planar_work *w = context;
  struct ph_planar_candidate *t = &w->trial;
  enum ph_status status;
  for (size_t k = 0; k < w->data->n; k++) {
    t->spacing[k] = w->scale ? w->shape[k] * exp(x[0]) : exp(x[k]);
  }
  *result = (double)NAN;
  if (ph_planar_data_space(w->data, t->spacing, w->diag) != PH_OK) {
    return PH_OK;
  }
  status = ph_planar_min_solve_trial(w);
  w->last = t;
  *result = log(t->value + STRAIGHT);
  return status;
}

void ph_planar_min_accept(void *context) {
  struct ph_planar_work *w = context;
  struct ph_planar_candidate keep = w->now;
  w->now = w->trial;
  w->trial = keep;
  w->last = &w->now;
  w->warm = true;
}

/* The weights of the logarithm's derivatives. */
void ph_planar_min_weigh(struct ph_planar_work *w,
                         const struct ph_planar_candidate *at) {
  weights_of(w->functional, at->energy, w->weight);
  for (size_t i = 0; i < 3; i++) {
    w->weight[i] /= at->value + STRAIGHT;
  }
}

void ph_planar_min_gradient(void *context, double *result) {
  struct ph_planar_work *w = context;
  const struct ph_planar_data *d = w->data;
  struct ph_planar_gradient *g = &w->gradient;
  double sum = 0;
  if (!w->weighted) {
    ph_planar_min_weigh(w, w->last);
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
void ph_planar_min_condition(void *context, const bool *fixed, double *v) {
  const struct ph_planar_work *w = context;
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
