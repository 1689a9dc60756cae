/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Measuring and choosing fits of Tschirnhausen cubics (see tc_fit.h).
 *
 * "Agree to 1e-9" is not transitive.  So the one of least energy says which
 * others agree with it, of these the shortest says which agree in length, and
 * of those the first is best; the second best is the best of the rest.
 */
#include "solve/tc/fit.h"

#include "curve/tc_simple.h"

static const double AGREE = 1e-9;

void ph_tc_fit_measure(struct ph_tc_fit *fit) {
  fit->regular = true;
  fit->loops = 0;
  fit->simple = false;
  fit->length = 0;
  fit->energy = 0;
  for (size_t i = 0; i < fit->n; i++) {
    fit->regular = fit->regular && ph_tc_is_regular(&fit->tc[i]);
    fit->loops += ph_tc_has_loop(&fit->tc[i]);
    fit->length += ph_tc_length(&fit->tc[i]);
    fit->energy += ph_tc_energy(&fit->tc[i]);
  }
}

bool ph_tc_fit_test(struct ph_tc_fit *fit) {
  fit->simple = fit->loops == 0 && ph_tc_is_simple(fit->tc, fit->n);
  return fit->simple;
}

/* ---- the best of some --------------------------------------------------- */

/* Which fits may be chosen; irregular ones never. */
typedef bool admit(struct ph_tc_fit *fit);

static bool admit_simple(struct ph_tc_fit *fit) {
  return fit->simple || ph_tc_fit_test(fit);
}

static bool admit_tested(struct ph_tc_fit *fit) {
  return fit->simple;
}

static bool admit_regular(struct ph_tc_fit *fit) {
  return fit->regular;
}

static double limit_of(double value) {
  return value + AGREE * value;
}

/* The regular one that comes after `last` (NULL: the first) in the order of
 * energy; NULL if none does. */
static struct ph_tc_fit *next_energy(struct ph_tc_fit *fits, size_t n,
                                     const struct ph_tc_fit *last) {
  struct ph_tc_fit *next = NULL;
  for (struct ph_tc_fit *f = fits; f < fits + n; f++) {
    bool after = last == NULL || f->energy > last->energy ||
                 (f->energy >= last->energy && f > last);
    if (f->regular && after && (next == NULL || f->energy < next->energy)) {
      next = f;
    }
  }
  return next;
}

/* The best of those that bend no more than `energy`. */
static struct ph_tc_fit *best_of(struct ph_tc_fit *fits, size_t n,
                                 double energy, admit *admitted) {
  struct ph_tc_fit *shortest = NULL;
  for (struct ph_tc_fit *f = fits; f < fits + n; f++) {
    if (f->energy <= energy &&
        (shortest == NULL || f->length < shortest->length) && admitted(f)) {
      shortest = f;
    }
  }
  for (struct ph_tc_fit *f = fits; shortest != NULL && f < shortest; f++) {
    if (f->energy <= energy && f->length <= limit_of(shortest->length) &&
        admitted(f)) {
      return f;
    }
  }
  return shortest;
}

/* NULL if none is regular and admitted. */
static struct ph_tc_fit *choose(struct ph_tc_fit *fits, size_t n,
                                admit *admitted) {
  struct ph_tc_fit *least = next_energy(fits, n, NULL);
  while (least != NULL && !admitted(least)) {
    least = next_energy(fits, n, least);
  }
  return least == NULL ? NULL
                       : best_of(fits, n, limit_of(least->energy), admitted);
}

struct ph_tc_fit *ph_tc_fit_best(struct ph_tc_fit *fits, size_t n) {
  struct ph_tc_fit *best = choose(fits, n, admit_simple);
  return best != NULL ? best : choose(fits, n, admit_regular);
}

/* ---- all in order ------------------------------------------------------- */

void ph_tc_fit_order(struct ph_tc_fit *fits, size_t n) {
  for (size_t i = 0; i < n; i++) {
    ph_tc_fit_test(&fits[i]);
  }
  for (size_t i = 0; i < n; i++) {
    struct ph_tc_fit *best = choose(fits + i, n - i, admit_tested), moved;
    if (best == NULL) {
      best = choose(fits + i, n - i, admit_regular);
    }
    if (best == NULL) {
      return;
    }
    moved = *best;
    for (; best > fits + i; best--) {
      best[0] = best[-1];
    }
    fits[i] = moved;
  }
}
