/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Ways to a spherical nu-spline (see sphere.h).
 *
 * Continuation: at tensions nu + sigma (4/h_i + 4/h_{i+1}) the spline hugs its
 * data when sigma is large; sigma falls to 0 by factors that adapt to how the
 * iteration gets on.  Relaxation from other starts.  And for more than a few
 * nodes, from a spline at other tensions block by block: Newton's iteration on
 * the whole is damped for all nodes as the worst of them asks, and of many some
 * are beside a fold.
 */
#include "solve/sphere/sphere.h"

#include <math.h>
#include <string.h>

enum {
  DESCENTS_MAX = 200, /* values of sigma */
  BLOCK = 16,         /* nodes that get other tensions at once, at most, */
  PART_MIN = 4,       /* and that are not divided further */
  HALO = 6, /* and on either side, which move with them: 3.7^-6, and what is
             * missing beyond is left to the iteration on the whole */
  SWEEPS_MAX = 4 /* of all blocks */
};

/* Continuation: the first sigma, the one from which 0 is tried, the first and
 * the smallest factor, and the one that is too near 1. */
static const double SIGMA_MAX = 64;
static const double SIGMA_MIN = 1e-2;
static const double FACTOR = 0.5;
static const double FACTOR_MIN = 0.25;
static const double FACTOR_MAX = 0.999;

/* Falls of sigma so near to 1 are a fold: the spline does not go on below it.
 */
static const double FACTOR_FOLD = 0.9;

/* Relaxation: what tau it begins with. */
static const double TAU[] = {4, 1, 0.25};

/* ---- continuation -------------------------------------------------------- */

/* Tensions at sigma, towards those aimed at; at nodes that are held, at what
 * holds them. */
static void set_tensions(struct ph_sphere_spline *s,
                         struct ph_sphere_range range, double sigma,
                         const struct ph_sphere_work *work) {
  for (size_t j = 0; j < range.count; j++) {
    size_t i = ph_sphere_node(s->data, range, j);
    double more = work->held[i] > 0 ? work->held[i] : sigma;
    s->nu[i] = work->tension[i] + more * ph_sphere_stiffness(s->data, i);
  }
}

/* Holds the nodes of a range about one at sigma, as many as it takes for one
 * that was not.  ret false: all are */
static bool hold(const struct ph_sphere_data *d, struct ph_sphere_range range,
                 size_t at, double sigma, double *held) {
  for (size_t by = 1; by <= range.count; by *= 2) {
    bool some = false;
    for (size_t j = 0; j < range.count; j++) {
      size_t i = ph_sphere_node(d, range, j), far = i > at ? i - at : at - i;
      far = d->closed && d->n - far < far ? d->n - far : far;
      if (far <= by && !(held[i] > 0)) {
        held[i] = sigma;
        some = true;
      }
    }
    if (some) {
      return true;
    }
  }
  return false;
}

/* From sigma, where x is a solution, as far down as it goes: to 0 if true; with
 * `tense`, the nodes that it would end at keep their sigma. */
static bool descend(struct ph_sphere_spline *s, struct ph_sphere_range range,
                    bool tense, struct ph_sphere_work *work) {
  double sigma = SIGMA_MAX, factor = FACTOR;
  double last = tense ? FACTOR_FOLD : FACTOR_MAX;
  for (size_t i = 0; i < DESCENTS_MAX && !ph_arena_late(work->arena); i++) {
    double next = sigma > SIGMA_MIN ? sigma * factor : 0;
    set_tensions(s, range, next, work);
    if (ph_sphere_newton(s, range, work)) {
      sigma = next;
      factor = fmax(factor * sqrt(factor), FACTOR_MIN);
      if (!(sigma > 0)) {
        return true;
      }
      continue;
    }
    factor = sqrt(factor);
    if (factor > last || !(sigma > SIGMA_MIN)) {
      if (!tense || !hold(s->data, range, ph_sphere_fold(s, range, work), sigma,
                          work->held)) {
        return false;
      }
      factor = FACTOR;
    }
  }
  return false;
}

/* By continuation from a spline that hugs the data; the tensions are the same
 * afterwards, but where it is to be tense and is found. */
static bool follow(struct ph_sphere_spline *s, struct ph_sphere_range range,
                   bool tense, struct ph_sphere_work *work) {
  bool solved;
  for (size_t j = 0; j < range.count; j++) {
    size_t i = ph_sphere_node(s->data, range, j);
    work->tension[i] = s->nu[i];
    work->held[i] = 0;
  }
  s->model->hug(s, range);
  set_tensions(s, range, SIGMA_MAX, work);
  solved = ph_sphere_newton(s, range, work) && descend(s, range, tense, work);
  for (size_t j = 0; !(solved && tense) && j < range.count; j++) {
    size_t i = ph_sphere_node(s->data, range, j);
    s->nu[i] = work->tension[i];
  }
  return solved;
}

static bool relax(struct ph_sphere_spline *s, struct ph_sphere_range range,
                  struct ph_sphere_work *work) {
  for (size_t t = 0; t < sizeof TAU / sizeof TAU[0]; t++) {
    for (size_t which = 0;
         !ph_arena_late(work->arena) && s->model->start(s, range, which, work);
         which++) {
      if (ph_sphere_relax(s, range, TAU[t], work)) {
        return true;
      }
    }
  }
  return false;
}

/* All ways but the start's. */
static bool find(struct ph_sphere_spline *s, struct ph_sphere_range range,
                 bool tense, struct ph_sphere_work *work) {
  return follow(s, range, false, work) || relax(s, range, work) ||
         (s->model->last_resort && s->model->last_resort(s, range, work)) ||
         (tense && follow(s, range, true, work));
}

/* ---- block by block ------------------------------------------------------ */

/* What is asked of all blocks. */
struct settle {
  double *aim;
  bool tense;
  struct ph_sphere_work *work;
};

/* The nodes that a block moves, and how they were. */
struct block {
  struct ph_sphere_range range;
  double nu[BLOCK + 2 * HALO];
  ph_vec3 x[BLOCK + 2 * HALO];
};

static void keep(const struct ph_sphere_spline *s, struct block *b) {
  for (size_t j = 0; j < b->range.count; j++) {
    size_t i = ph_sphere_node(s->data, b->range, j);
    b->nu[j] = s->nu[i];
    b->x[j] = s->x[i];
  }
}

static void restore(struct ph_sphere_spline *s, const struct block *b) {
  for (size_t j = 0; j < b->range.count; j++) {
    size_t i = ph_sphere_node(s->data, b->range, j);
    s->nu[i] = b->nu[j];
    s->x[i] = b->x[j];
  }
}

/* Nodes begin, begin + 1, ..., end - 1 of a range with those on either side
 * that move with them, of the range. */
static struct ph_sphere_range reach_of(const struct ph_sphere_data *d,
                                       struct ph_sphere_range range,
                                       size_t begin, size_t end) {
  struct ph_sphere_range wide;
  if (range.count == d->n) {
    return ph_sphere_widen(d, ph_sphere_node(d, range, begin), end - begin,
                           HALO);
  }
  begin = begin > HALO ? begin - HALO : 0;
  end = range.count - end > HALO ? end + HALO : range.count;
  wide.first = ph_sphere_node(d, range, begin);
  wide.count = end - begin;
  return wide;
}

/* Gives the tensions that are aimed at to some nodes of a range, and solves
 * what they reach; in halves where that fails, and the smallest parts from
 * nothing. */
static bool settle_part(struct ph_sphere_spline *s,
                        struct ph_sphere_range range, size_t begin, size_t end,
                        const struct settle *how) {
  const struct ph_sphere_data *d = s->data;
  struct block b = {.range = reach_of(d, range, begin, end)};
  keep(s, &b);
  for (size_t j = begin; j < end; j++) {
    size_t i = ph_sphere_node(d, range, j);
    s->nu[i] = how->aim[i];
  }
  if (ph_sphere_newton(s, b.range, how->work)) {
    return true;
  }
  if (end - begin > PART_MIN) {
    size_t middle = (begin + end) / 2;
    restore(s, &b);
    return settle_part(s, range, begin, middle, how) &&
           settle_part(s, range, middle, end, how);
  }
  if (!find(s, b.range, how->tense, how->work)) {
    restore(s, &b);
    return false;
  }
  for (size_t j = begin > HALO ? begin - HALO : 0; j < end; j++) {
    size_t i = ph_sphere_node(d, range, j);
    how->aim[i] = how->work->held[i] > 0 ? s->nu[i] : how->aim[i];
  }
  return true;
}

bool ph_sphere_settle(struct ph_sphere_spline *s, struct ph_sphere_range range,
                      double *aim, bool tense, struct ph_sphere_work *work) {
  struct settle how = {aim, tense, work};
  for (size_t sweep = 0; sweep < SWEEPS_MAX && !ph_arena_late(work->arena);
       sweep++) {
    for (size_t j = 0; j < range.count; j += BLOCK) {
      size_t end = range.count - j < BLOCK ? range.count : j + BLOCK;
      if (!settle_part(s, range, j, end, &how)) {
        return false;
      }
    }
    if (ph_sphere_newton(s, range, work)) {
      return true;
    }
  }
  return false;
}

/* The whole from nothing, from tensions at which it hugs the data. */
static bool settle_all(struct ph_sphere_spline *s, bool tense,
                       struct ph_sphere_work *work) {
  struct ph_sphere_range all = ph_sphere_all(s->data);
  size_t size = s->data->n * sizeof *s->nu;
  memcpy(work->aim, s->nu, size);
  memcpy(work->tension, s->nu, size);
  memset(work->held, 0, size);
  s->model->hug(s, all);
  set_tensions(s, all, SIGMA_MAX, work);
  return ph_sphere_newton(s, all, work) &&
         ph_sphere_settle(s, all, work->aim, tense, work);
}

static bool solve(struct ph_sphere_spline *s, bool tense,
                  struct ph_sphere_work *work) {
  struct ph_sphere_range all = ph_sphere_all(s->data);
  size_t size = s->data->n * sizeof *s->nu;
  s->model->start(s, all, 0, work);
  if (ph_sphere_newton(s, all, work)) {
    return true;
  }
  if (all.count > BLOCK) {
    memcpy(work->given, s->nu, size);
    if (settle_all(s, tense, work)) {
      return true;
    }
    memcpy(s->nu, work->given, size);
  }
  return find(s, all, tense, work);
}

bool ph_sphere_solve(struct ph_sphere_spline *s, struct ph_sphere_work *work) {
  return solve(s, false, work);
}

bool ph_sphere_solve_tense(struct ph_sphere_spline *s,
                           struct ph_sphere_work *work) {
  return solve(s, true, work);
}
