/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Raising tensions, round by round (see sphere.h). */
#include "solve/sphere/sphere.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

enum {
  /* Nodes on either side of a raised tension that are solved again: 3.7^-30 is
   * below rounding. */
  REACH = 30,
  /* The same while they grow, after which the whole is solved once more: what
   * is missing is 3.7^-12, far less than a round changes. */
  REACH_GROWING = 12,
  ROUNDS_MAX = PH_SPHERE_ROUNDS_MAX,
  REPAIRS_MAX = 100 /* rounds after tensions were lowered */
};

/*
 * The largest tension, for knots that are angles h = 1.  Control points are
 * 4 / nu from their node, and data that turn by tau need nu h = c / sin tau.
 * Rounding u of a point turns the control polygon by u nu / 4: it tells less
 * than tau while nu < sqrt(4 c / (u h)).  At h = 1 half of the digits are left,
 * and others have the square root of their stiffness in place of that of 8.
 *
 * The first raise by doubling leads to FIRST stiffnesses.
 */
static const double TENSION_MAX = 1e8;
static const double FIRST = 0.125;

/* A small raise: by this factor, at least to this part of FIRST.  It grows from
 * round to round up to doubling: some nodes need 10^5 times their first. */
static const double REPAIR = 1.1;
static const double REPAIR_FIRST = 1.0 / 64;
static const double REPAIR_GROWS = 1.02;

/* What a round does to a node. */
enum { NOTHING, RAISE, RESET };

/* ---- looking ------------------------------------------------------------- */

/* The bit of raise->ignored for a place. */
static unsigned char bit_of(bool segment) {
  return segment ? PH_SPHERE_IGNORE_SEGMENT : PH_SPHERE_IGNORE_NODE;
}

enum ph_sphere_criterion ph_sphere_violated(const struct ph_sphere_raise *raise,
                                            struct ph_sphere_range range,
                                            size_t *from, size_t *at) {
  const struct ph_sphere_spline *s = raise->spline;
  const struct ph_sphere_data *d = s->data;
  /* places 2 j and 2 j + 1: the segment before node j of the range, and the
   * node; then the segment after the last, if it is another one */
  size_t end = 2 * range.count + (range.count < d->n);
  for (; *from < end && !ph_arena_late(raise->work->arena); ++*from) {
    size_t i = ph_sphere_node(d, range, *from / 2);
    bool segment = *from % 2 == 0;
    size_t place = segment ? ph_sphere_before(d, i) : i;
    enum ph_sphere_criterion criterion;
    if (raise->ignored[place] & bit_of(segment)) {
      continue;
    }
    criterion = segment ? ph_sphere_segment_fails(raise->shape, s, place)
                        : ph_sphere_node_fails(raise->shape, s, place);
    if (criterion != PH_SPHERE_FINE) {
      *at = place;
      ++*from;
      return criterion;
    }
  }
  return PH_SPHERE_FINE;
}

/* ---- raising ------------------------------------------------------------- */

static double largest_tension(const struct ph_sphere_data *d, size_t i) {
  size_t k = ph_sphere_before(d, i);
  double before = d->theta[k] / d->h[k], after = d->theta[i] / d->h[i];
  double most = TENSION_MAX * sqrt(0.5 / d->theta[k] + 0.5 / d->theta[i]);
  return most * (before > after ? before : after);
}

/* An end of open data, whose tension has no effect, has no stiffness either. */
static double raised(const struct ph_sphere_raise *raise, size_t i) {
  const struct ph_sphere_data *d = raise->spline->data;
  bool end = ph_sphere_is_end(d, i);
  double nu = raise->spline->nu[i], next = nu;
  double first = end ? 0 : FIRST * ph_sphere_stiffness(d, i);
  double most = end ? (double)INFINITY : largest_tension(d, i);
  switch (raise->increase) {
  case PH_SPHERE_PLUS:
    next = nu + raise->by;
    break;
  case PH_SPHERE_TIMES:
    next = nu > 0 ? nu * raise->by : raise->by;
    break;
  case PH_SPHERE_MINIMAL:
    next = 2 * nu > first ? 2 * nu : first;
    break;
  case PH_SPHERE_REPAIR:
    next = fmax(raise->by * nu, REPAIR_FIRST * first);
    break;
  }
  return next < most ? next : nu < most ? most : nu;
}

/* Whether node i can be raised, as far as is known. */
static bool can_raise(const struct ph_sphere_raise *raise, size_t i) {
  const struct ph_sphere_data *d = raise->spline->data;
  return !ph_sphere_is_end(d, i) &&
         raise->spline->nu[i] < largest_tension(d, i);
}

/* ---- the limit ----------------------------------------------------------- */

/* A tension as good as infinite, in stiffnesses: the legs at its node have
 * their directions in the limit. */
static const double INFINITE = 1e20;

static enum ph_sphere_criterion fails(const struct ph_sphere_raise *raise,
                                      enum ph_sphere_criterion criterion,
                                      size_t at) {
  return criterion == PH_SPHERE_SEGMENT
             ? ph_sphere_segment_fails(raise->shape, raise->spline, at)
             : ph_sphere_node_fails(raise->shape, raise->spline, at);
}

/* Sets or restores the unknowns and the tensions of a range. */
static void keep(struct ph_sphere_raise *raise, struct ph_sphere_range range) {
  const struct ph_sphere_spline *s = raise->spline;
  for (size_t j = 0; j < range.count; j++) {
    size_t i = ph_sphere_node(s->data, range, j);
    raise->kept_nu[j] = s->nu[i];
    raise->kept_x[j] = s->x[i];
  }
}

static void restore(struct ph_sphere_raise *raise,
                    struct ph_sphere_range range) {
  struct ph_sphere_spline *s = raise->spline;
  struct ph_sphere_part part;
  for (size_t j = 0; j < range.count; j++) {
    size_t i = ph_sphere_node(s->data, range, j);
    s->nu[i] = raise->kept_nu[j];
    s->x[i] = raise->kept_x[j];
  }
  for (size_t j = 0; j < range.count; j++) {
    size_t i = ph_sphere_node(s->data, range, j);
    s->model->segment(s, ph_sphere_before(s->data, i), false, &part);
    s->model->segment(s, i, false, &part);
  }
}

/*
 * Whether a criterion is violated in the limit of infinite tensions at its n
 * nodes, whose velocities tend to 0 as w / nu.  The spline with v = 0 there is
 * solved; one more step of the iteration makes w of it.
 */
static bool never_holds(struct ph_sphere_raise *raise,
                        enum ph_sphere_criterion criterion, size_t at,
                        const size_t *node, size_t n) {
  struct ph_sphere_spline *s = raise->spline;
  const struct ph_sphere_data *d = s->data;
  struct ph_sphere_range range;
  bool violated;
  size_t count, most = 0, free_n = 0;
  for (size_t j = 0; j < n; j++) {
    free_n += !ph_sphere_is_end(d, node[j]);
    count = node[j] >= node[0] ? node[j] - node[0] : node[j] + d->n - node[0];
    most = count > most ? count : most;
  }
  if (free_n == 0) {
    return true;
  }
  range = ph_sphere_widen(d, node[0], most + 1, REACH);
  keep(raise, range);
  for (size_t j = 0; j < n; j++) {
    if (!ph_sphere_is_end(d, node[j])) {
      s->nu[node[j]] = INFINITE * ph_sphere_stiffness(d, node[j]);
      s->x[node[j]] = ph_vec3_of(0, 0, 0);
    }
  }
  violated = ph_sphere_newton(s, range, raise->work);
  if (violated) {
    ph_sphere_step(s, range, raise->work);
    violated = fails(raise, criterion, at) != PH_SPHERE_FINE;
  }
  restore(raise, range);
  return violated;
}

/* Plans what a violated criterion asks for, all of a round at once: its nodes
 * are raised, or, where that cannot help, it is waived, and they begin anew.
 * Whether that is allowed. */
static bool plan(struct ph_sphere_raise *raise,
                 enum ph_sphere_criterion criterion, size_t at,
                 size_t *touched_n) {
  size_t node[4];
  size_t n = ph_sphere_touched(raise->shape, criterion, at, node);
  bool can = false;
  for (size_t j = 0; j < n; j++) {
    can = can || can_raise(raise, node[j]);
  }
  if (!can) {
    unsigned char bit = bit_of(criterion == PH_SPHERE_SEGMENT);
    bool never = never_holds(raise, criterion, at, node, n);
    raise->ignored[at] |=
        (unsigned char)(never ? bit | bit << PH_SPHERE_NEVER : bit);
  }
  for (size_t j = 0; j < n; j++) {
    if (raise->planned[node[j]] == NOTHING) {
      raise->touched[(*touched_n)++] = node[j];
    }
    if (!can || raise->planned[node[j]] == NOTHING) {
      raise->planned[node[j]] = can ? RAISE : RESET;
    }
  }
  return can || raise->waive;
}

/* Does what was planned. */
static void carry_out(struct ph_sphere_raise *raise, size_t touched_n) {
  struct ph_sphere_spline *s = raise->spline;
  for (size_t j = 0; j < touched_n; j++) {
    size_t i = raise->touched[j];
    if (raise->planned[i] == RESET) {
      s->nu[i] = s->data->nu[i];
    } else {
      s->nu[i] = raised(raise, i);
    }
    raise->planned[i] = NOTHING;
  }
}

/* ---- where to look again ------------------------------------------------- */

static int compare(const void *a, const void *b) {
  const size_t *x = a, *y = b;
  return (*x > *y) - (*x < *y);
}

/* The ranges around the touched nodes: where two would meet they are one. */
static void find_ranges(struct ph_sphere_raise *raise, size_t touched_n) {
  const struct ph_sphere_data *d = raise->spline->data;
  size_t *t = raise->touched, begin = 0;
  size_t reach = raise->increase == PH_SPHERE_MINIMAL ? REACH_GROWING : REACH;
  qsort(t, touched_n, sizeof *t, compare);
  raise->ranges_n = 0;
  if (d->closed) {
    /* begin after a gap, and count on beyond n */
    while (begin < touched_n &&
           (begin > 0 ? t[begin] - t[begin - 1]
                      : t[0] + d->n - t[touched_n - 1]) <= 2 * reach + 1) {
      begin++;
    }
    if (begin == touched_n) {
      raise->ranges[raise->ranges_n++] = ph_sphere_all(d);
      return;
    }
  }
  for (size_t j = 0; j < touched_n;) {
    size_t first = t[(begin + j) % touched_n], last = first;
    for (j++; j < touched_n; j++) {
      size_t next = t[(begin + j) % touched_n];
      next += next < first ? d->n : 0;
      if (next - last > 2 * reach + 1) {
        break;
      }
      last = next;
    }
    raise->ranges[raise->ranges_n++] =
        ph_sphere_widen(d, first, last - first + 1, reach);
  }
}

/* ---- the whole ----------------------------------------------------------- */

/* There is a solution at the tensions of a range. */
static void note_solved(struct ph_sphere_raise *raise,
                        struct ph_sphere_range range) {
  const struct ph_sphere_spline *s = raise->spline;
  for (size_t j = 0; j < range.count; j++) {
    size_t i = ph_sphere_node(s->data, range, j);
    raise->solved[i] = s->nu[i];
  }
}

/* Goes to the new tensions of a range block by block, from those it has a
 * solution at; if that fails, x is anything. */
static bool settle(struct ph_sphere_raise *raise,
                   struct ph_sphere_range range) {
  struct ph_sphere_spline *s = raise->spline;
  double *aim = raise->work->aim;
  bool settled;
  for (size_t j = 0; j < range.count; j++) {
    size_t i = ph_sphere_node(s->data, range, j);
    aim[i] = s->nu[i];
    s->nu[i] = raise->solved[i];
  }
  settled = ph_sphere_settle(s, range, aim, true, raise->work);
  for (size_t j = 0; !settled && j < range.count; j++) {
    size_t i = ph_sphere_node(s->data, range, j);
    s->nu[i] = aim[i];
  }
  return settled;
}

/* Solves again; from nothing where the way from the last solution fails, with
 * more tension where there is no other. */
static bool solve_ranges(struct ph_sphere_raise *raise) {
  struct ph_sphere_spline *s = raise->spline;
  for (size_t r = 0; r < raise->ranges_n; r++) {
    struct ph_sphere_range range = raise->ranges[r];
    if (!ph_sphere_newton(s, range, raise->work) && !settle(raise, range)) {
      raise->ranges[0] = range = ph_sphere_all(s->data);
      raise->ranges_n = 1;
      if (!ph_sphere_solve_tense(s, raise->work)) {
        return false;
      }
    }
    note_solved(raise, range);
  }
  return true;
}

/* One round: PH_OK, with no more ranges when nothing is violated. */
static enum ph_status go_round(struct ph_sphere_raise *raise) {
  size_t touched_n = 0;
  raise->rounds++;
  for (size_t r = 0; r < raise->ranges_n; r++) {
    size_t from = 0, at = 0;
    enum ph_sphere_criterion criterion;
    while ((criterion = ph_sphere_violated(raise, raise->ranges[r], &from,
                                           &at)) != PH_SPHERE_FINE) {
      if (!plan(raise, criterion, at, &touched_n)) {
        return PH_E_NO_CONVERGENCE;
      }
    }
  }
  carry_out(raise, touched_n);
  raise->ranges_n = 0;
  if (touched_n > 0) {
    find_ranges(raise, touched_n);
  }
  return solve_ranges(raise) ? PH_OK : PH_E_NO_CONVERGENCE;
}

/* What is violated after all: of all criteria. */
static void count_waived(struct ph_sphere_raise *raise) {
  struct ph_sphere_range all = ph_sphere_all(raise->spline->data);
  size_t from = 0, at = 0;
  enum ph_sphere_criterion criterion;
  memset(raise->planned, NOTHING, raise->spline->data->n);
  for (size_t i = 0; i < raise->spline->data->n; i++) {
    raise->ignored[i] &=
        (unsigned char)~(PH_SPHERE_IGNORE_NODE | PH_SPHERE_IGNORE_SEGMENT);
  }
  while ((criterion = ph_sphere_violated(raise, all, &from, &at)) !=
         PH_SPHERE_FINE) {
    unsigned char bit = bit_of(criterion == PH_SPHERE_SEGMENT);
    bool never = raise->ignored[at] >> PH_SPHERE_NEVER & bit;
    raise->never += never;
    raise->planned[at] |= bit;
    if (raise->waived++ == 0) {
      raise->beyond = !never;
      raise->at = at;
      raise->criterion = criterion;
    }
  }
  memcpy(raise->ignored, raise->planned, raise->spline->data->n);
}

/* ---- lowering again ------------------------------------------------------ */

/* Rounds of small raises, until nothing is violated; nothing more is waived. */
static bool repair(struct ph_sphere_raise *raise) {
  size_t before = raise->rounds;
  enum ph_status status = PH_OK;
  raise->increase = PH_SPHERE_REPAIR;
  raise->by = REPAIR;
  raise->ranges[0] = ph_sphere_all(raise->spline->data);
  raise->ranges_n = 1;
  if (!ph_sphere_newton(raise->spline, raise->ranges[0], raise->work)) {
    return false;
  }
  note_solved(raise, raise->ranges[0]);
  raise->waive = false;
  while (status == PH_OK && raise->ranges_n > 0) {
    status = raise->rounds - before < REPAIRS_MAX ? go_round(raise)
                                                  : PH_E_NO_CONVERGENCE;
    raise->by = fmin(REPAIR_GROWS * raise->by, 2);
  }
  return status == PH_OK;
}

/* The smallest tensions, raised a little where they turn out not to do; as they
 * were where that does not help. */
static enum ph_status lower(struct ph_sphere_raise *raise,
                            struct ph_arena *scratch) {
  struct ph_sphere_spline *s = raise->spline;
  size_t n = s->data->n;
  double *nu = ph_arena_array(scratch, n, sizeof *nu);
  ph_vec3 *x = ph_arena_array(scratch, n, sizeof *x);
  if (!nu || !x) {
    return PH_E_NO_MEMORY;
  }
  memcpy(nu, s->nu, n * sizeof *nu);
  memcpy(x, s->x, n * sizeof *x);
  if (!ph_sphere_minimise(raise, scratch)) {
    return PH_E_NO_MEMORY;
  }
  if (repair(raise)) {
    return PH_OK;
  }
  memcpy(s->nu, nu, n * sizeof *nu);
  memcpy(s->x, x, n * sizeof *x);
  return repair(raise) ||
                 ph_sphere_newton(s, ph_sphere_all(s->data), raise->work)
             ? PH_OK
             : PH_E_NO_CONVERGENCE;
}

/* ---- memory -------------------------------------------------------------- */

static bool alloc(struct ph_sphere_raise *raise, struct ph_arena *scratch) {
  size_t n = raise->spline->data->n;
  raise->ignored = ph_arena_array(scratch, n, sizeof *raise->ignored);
  raise->touched = ph_arena_array(scratch, n, sizeof *raise->touched);
  raise->planned = ph_arena_array(scratch, n, sizeof *raise->planned);
  raise->kept_nu = ph_arena_array(scratch, n, sizeof *raise->kept_nu);
  raise->kept_x = ph_arena_array(scratch, n, sizeof *raise->kept_x);
  raise->solved = ph_arena_array(scratch, n, sizeof *raise->solved);
  raise->ranges = ph_arena_array(scratch, n, sizeof *raise->ranges);
  if (!raise->ignored || !raise->touched || !raise->planned || !raise->ranges ||
      !raise->kept_nu || !raise->kept_x || !raise->solved) {
    return false;
  }
  memset(raise->ignored, 0, n * sizeof *raise->ignored);
  memset(raise->planned, NOTHING, n * sizeof *raise->planned);
  return true;
}

enum ph_status ph_sphere_keep_shape(struct ph_sphere_raise *raise,
                                    struct ph_arena *scratch) {
  const struct ph_sphere_data *d = raise->spline->data;
  enum ph_status status = PH_OK;
  raise->rounds = 0;
  raise->waived = raise->never = 0;
  raise->beyond = false;
  raise->waive = true;
  if (!alloc(raise, scratch)) {
    return PH_E_NO_MEMORY;
  }
  raise->ranges[0] = ph_sphere_all(d);
  raise->ranges_n = raise->ranges[0].count > 0;
  note_solved(raise, raise->ranges[0]);
  while (status == PH_OK && raise->ranges_n > 0) {
    if (ph_arena_late(scratch)) {
      return PH_E_NO_MEMORY;
    }
    if (raise->rounds == ROUNDS_MAX) {
      break;
    }
    status = go_round(raise);
  }
  if (status == PH_OK && raise->increase == PH_SPHERE_MINIMAL &&
      raise->rounds > 1) {
    status = lower(raise, scratch);
  }
  if (status != PH_OK) {
    return status;
  }
  count_waived(raise);
  return !raise->strict || raise->waived == 0 ? PH_OK
         : raise->beyond                      ? PH_E_NO_CONVERGENCE
                                              : PH_E_INFEASIBLE;
}
