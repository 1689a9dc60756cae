/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Ways to a spherical nu-spline (see sphere_solve.h).
 *
 * Continuation: at tensions nu + sigma (4/h_i + 4/h_{i+1}) the spline hugs its
 * data when sigma is large; sigma falls to 0 by factors that adapt to how the
 * iteration gets on.
 */
#include "solve/sphere/solve.h"

#include <string.h>

enum { DESCENTS_MAX = 200 /* values of sigma */ };

/* Continuation: the first sigma, the one from which 0 is tried, the first and
 * the smallest factor, and the one that is too near 1. */
static const double SIGMA_MAX = 64;
static const double SIGMA_MIN = 1e-2;
static const double FACTOR = 0.5;
static const double FACTOR_MIN = 0.25;
static const double FACTOR_MAX = 0.999;

/* Relaxation: what tau it begins with. */
static const double TAU[] = {4, 1, 0.25};

/* ---- continuation -------------------------------------------------------- */

/* Tensions at sigma, towards those aimed at. */
static void set_tensions(struct ph_sphere_spline *s, double sigma,
                         const double *aim) {
  const struct ph_sphere_data *d = s->data;
  struct ph_sphere_range all = ph_sphere_all(d);
  for (size_t j = 0; j < all.count; j++) {
    size_t i = ph_sphere_node(d, all, j);
    s->nu[i] = aim[i] + sigma * ph_sphere_stiffness(d, i);
  }
}

/* From sigma, where x is a solution, as far down as it goes: to 0 if true. */
static bool descend(struct ph_sphere_spline *s, struct ph_sphere_work *work) {
  struct ph_sphere_range all = ph_sphere_all(s->data);
  double sigma = SIGMA_MAX, factor = FACTOR;
  for (size_t i = 0; i < DESCENTS_MAX; i++) {
    double next = sigma > SIGMA_MIN ? sigma * factor : 0;
    set_tensions(s, next, work->tension);
    if (ph_sphere_newton(s, all, work)) {
      sigma = next;
      factor = factor * sqrt(factor);
      factor = factor > FACTOR_MIN ? factor : FACTOR_MIN;
      if (!(sigma > 0)) {
        return true;
      }
    } else {
      factor = sqrt(factor);
      if (factor > FACTOR_MAX || !(sigma > SIGMA_MIN)) {
        return false;
      }
    }
  }
  return false;
}

/* By continuation; the tensions are the same afterwards. */
static bool follow(struct ph_sphere_spline *s, struct ph_sphere_work *work) {
  size_t size = s->data->n * sizeof *s->nu;
  bool solved;
  memcpy(work->tension, s->nu, size);
  s->model->hug(s);
  set_tensions(s, SIGMA_MAX, work->tension);
  solved =
      ph_sphere_newton(s, ph_sphere_all(s->data), work) && descend(s, work);
  memcpy(s->nu, work->tension, size);
  return solved;
}

/* ---- other starts -------------------------------------------------------- */

static bool relax(struct ph_sphere_spline *s, struct ph_sphere_work *work) {
  for (size_t t = 0; t < sizeof TAU / sizeof TAU[0]; t++) {
    for (size_t which = 0; s->model->start(s, which, work); which++) {
      if (ph_sphere_relax(s, ph_sphere_all(s->data), TAU[t], work)) {
        return true;
      }
    }
  }
  return false;
}

bool ph_sphere_solve(struct ph_sphere_spline *s, struct ph_sphere_work *work) {
  struct ph_sphere_range all = ph_sphere_all(s->data);
  s->model->start(s, 0, work);
  return ph_sphere_newton(s, all, work) || follow(s, work) || relax(s, work) ||
         (s->model->last_resort && s->model->last_resort(s, work));
}
