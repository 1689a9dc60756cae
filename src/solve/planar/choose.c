/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The fairest of several solutions (see planar.h).
 *
 * Where the data turn by an angle x of more than a right one, the tangent may
 * as well turn by x - 2 pi, the other way round.  Of random sets of 4 to 7
 * points one in six has a curve that does, of an IES less by a tenth and more,
 * without a crossing that the first one has not.  A start with such a turn
 * leads to it: of 6400 sets, open and closed, of both bases, the turns beyond a
 * right angle, in all combinations, led to the fairest of all solutions (all.c)
 * every time, and turns beyond 120 degrees did not.
 */
#include "solve/planar/planar.h"

#include "base/team.h"
#include "curve/cross/cross.h"
#include "curve/fair/energy.h"
#include "curve/segment/seg2.h"
#include "solve/common/fields.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Every combination of turns is a start up to so many segments; of longer
 * curves so many starts, as long as their segments are not more in all. */
enum { COMBINE_MAX = 7, STARTS_MAX = 64, SEGMENTS_MAX = 300 };

/* How often the best turns are looked for beside those that were found. */
enum { ROUNDS = 2 };

/* Another curve is told if it bends at most by so much more. */
static const double ALIKE = 1.5;

/* Parts of a segment for a bound of its energy, and what rounding, and atph
 * segments, leave of it. */
enum { GENTLE_PARTS = 2, LOOP_PARTS = 8 };
static const double LOWER = 0.99;

/* Lengths, and IES, that agree to this are the same. */
static const double SAME = 1e-9;

/* Unknowns, and control points over the length, of the same curve are within
 * this of each other: other solutions are far away, but a multiple one is known
 * to the root of rounding only. */
static const double SAME_CURVE = 1e-7;

struct candidate {
  ph_cplx *b; /* [unknowns] */
  ph_cplx twist;
  struct ph_planar_report report;
  double ies; /* infinite where it stands still, or is more than is of use */
  double length;
  bool simple; /* set where it is asked for */
};

/* Segments of a part, which take 0.5 ms or more; parts that are worth another
 * thread. */
enum { PART = 1024, WORTH = 4 * PART };

/* What is found of a part of the segments of a trial. */
struct part {
  struct ph_sum length, bending;
  double gain; /* by which that is more than its bounds */
};

struct work {
  struct ph_planar_data *data;
  struct ph_arena *scratch;
  struct ph_diag *diag;
  struct ph_energy_sum sum; /* empty */
  size_t unknowns;
  double *least;     /* [n] a bound of the energy of each segment */
  struct part *part; /* [parts of PART segments] */
  struct candidate best, trial;
  bool is_first;        /* the best is what the first two starts led to */
  bool tested, crosses; /* whether that crosses itself, once it was tested */
  struct ph_planar_choice *choice;
};

/* ---- what a solution is worth -------------------------------------------- */

static void scaled(const struct ph_planar_data *d, const ph_cplx *b, size_t k,
                   struct ph_seg2 *seg) {
  double root = sqrt(d->h[k]);
  *seg =
      (struct ph_seg2){*ph_planar_space(&d->c2, k), {{0, 0}}, {0, 0}, {0, 0}};
  ph_planar_preimage(&d->c2, b, k, seg->w);
  for (size_t i = 0; i < 3; i++) {
    seg->w[i] = ph_cplx_scale(root, seg->w[i]);
  }
}

/*
 * No less than the energy of a segment: of each of its parts that turns by x,
 * at least x^2 over its length.  Simpson's rule, for the quartic |w|^2, has
 * none shorter than it is.
 */
static double energy_least(const struct ph_seg2 *seg) {
  int parts = ph_seg2_is_monotone(seg->w) ? GENTLE_PARTS : LOOP_PARTS;
  double sum = 0, step = 1.0 / parts;
  ph_cplx from = seg->w[0];
  for (int i = 1; i <= parts; i++) {
    ph_cplx middle, to;
    double turn, size;
    ph_atph_jet(&seg->space, seg->w, (i - 0.5) * step, &middle, 1);
    ph_atph_jet(&seg->space, seg->w, i * step, &to, 1);
    turn = 2 * atan2(ph_cplx_cross(from, to), ph_cplx_dot(from, to));
    size =
        step / 6 *
        (ph_cplx_norm2(from) + 4 * ph_cplx_norm2(middle) + ph_cplx_norm2(to));
    sum += turn * turn / size;
    from = to;
  }
  return sum;
}

static bool measure_bounds(void *context, size_t thread, size_t first,
                           size_t end) {
  const struct work *w = context;
  struct part *part = &w->part[first / PART];
  struct ph_seg2 seg;
  (void)thread;
  *part = (struct part){.gain = 0};
  for (size_t k = first; k < end; k++) {
    scaled(w->data, w->trial.b, k, &seg);
    ph_sum_add(&part->length, ph_seg2_length(&seg.space, seg.w));
    w->least[k] = LOWER * energy_least(&seg);
  }
  return true;
}

/* Energies in place of bounds. */
struct energies {
  const struct work *w;
  double least; /* the sum of all bounds */
  double most;  /* that is of use */
  atomic_bool beyond;
};

static bool measure_energies(void *context, size_t thread, size_t first,
                             size_t end) {
  struct energies *e = context;
  const struct work *w = e->w;
  struct part *part = &w->part[first / PART];
  struct ph_energy_sum sum = w->sum;
  struct ph_seg2 seg;
  double least = e->least;
  (void)thread;
  for (size_t k = first; k < end && least <= e->most; k++) {
    double before = ph_sum_value(&sum.bending);
    scaled(w->data, w->trial.b, k, &seg);
    ph_energy_add(&sum, &seg);
    least += ph_sum_value(&sum.bending) - before - w->least[k];
  }
  part->bending = sum.bending;
  part->gain = least - e->least;
  if (!(least <= e->most)) {
    atomic_store(&e->beyond, true);
  }
  return !atomic_load(&e->beyond);
}

/*
 * IES and length of the trial, for the twist in the data.
 *
 * From one segment to the next the energy takes the place of its bound, until
 * the sum is beyond the limit: segments with loops, which take long, are seldom
 * integrated.  Parts of a long curve do so each for itself.
 */
static void measure(struct work *w, double limit) {
  const size_t n = w->data->n;
  struct candidate *t = &w->trial;
  struct energies e = {.w = w};
  struct ph_sum length = {0, 0}, bending = {0, 0};
  double sum;
  t->twist = w->data->c2.twist;
  t->ies = (double)INFINITY;
  ph_team_share(w->scratch, n, WORTH, PART, measure_bounds, w);
  for (size_t k = 0; k < n; k++) {
    e.least += w->least[k];
  }
  for (size_t i = 0; i * PART < n; i++) {
    ph_sum_join(&length, &w->part[i].length);
  }
  t->length = ph_sum_value(&length);
  e.most = limit / t->length;
  atomic_init(&e.beyond, false);
  ph_team_share(w->scratch, n, WORTH, PART, measure_energies, &e);
  if (atomic_load(&e.beyond)) {
    return;
  }
  sum = e.least;
  for (size_t i = 0; i * PART < n; i++) {
    sum += w->part[i].gain;
    ph_sum_join(&bending, &w->part[i].bending);
  }
  if (sum <= e.most) {
    t->ies = ph_sum_value(&bending) * t->length;
  }
}

static enum ph_status curve_of(struct work *w, const struct candidate *c,
                               struct ph_curve *curve) {
  struct ph_planar_data *d = w->data;
  const ph_cplx twist = d->c2.twist;
  struct ph_planar_loops loops;
  enum ph_status status = ph_planar_curve_alloc(d, w->scratch, curve, w->diag);
  if (status == PH_OK) {
    d->c2.twist = c->twist;
    ph_planar_curve_fill(d, c->b, w->scratch, curve, &loops);
    d->c2.twist = twist;
  }
  return status;
}

static enum ph_status test_simple(struct work *w, struct candidate *c) {
  struct ph_mark mark = ph_arena_mark(w->scratch);
  struct ph_cross cross = {.simple = false};
  struct ph_curve curve;
  enum ph_status status = curve_of(w, c, &curve);
  if (status == PH_OK) {
    status = ph_cross_planar(&curve, w->scratch, &cross, w->diag);
    status = status == PH_E_NOT_FINITE ? PH_OK : status;
  }
  c->simple = cross.simple;
  ph_arena_release(w->scratch, mark);
  return status;
}

/* Which of two curves is farther to the left of its chords where they part, or
 * farther on along them; 0 where they are the same. */
int ph_planar_compare_sides(const struct ph_curve *x,
                            const struct ph_curve *y) {
  double apart = SAME_CURVE * x->length;
  for (size_t i = 0; i < 6 * x->n; i++) {
    const double *chord = ph_curve_points(x, i / 6);
    const double *p = chord + 2 * (i % 6);
    const double *q = ph_curve_points(y, i / 6) + 2 * (i % 6);
    ph_cplx off = ph_cplx_of(p[0] - q[0], p[1] - q[1]);
    ph_cplx c = ph_cplx_of(chord[10] - chord[0], chord[11] - chord[1]);
    double size = hypot(c.re, c.im), left, on;
    c = ph_cplx_of(c.re / size, c.im / size);
    left = ph_cplx_cross(c, off);
    on = ph_cplx_dot(c, off);
    if (fabs(left) > apart || fabs(on) > apart) {
      return fabs(left) > apart ? ph_fields_order(0, left)
                                : ph_fields_order(0, on);
    }
  }
  return 0;
}

/* ---- one against another ------------------------------------------------- */

static bool is_same(double a, double b) {
  return fabs(a - b) <= SAME * b;
}

/* Whether the trial is the best one, or its negative. */
static bool is_best(const struct work *w) {
  double plus = 0, minus = 0, size = 0;
  for (size_t i = 0; i < w->unknowns; i++) {
    ph_cplx a = w->best.b[i], b = w->trial.b[i];
    plus = fmax(plus, ph_cplx_norm2(ph_cplx_add(a, b)));
    minus = fmax(minus, ph_cplx_norm2(ph_cplx_sub(a, b)));
    size = fmax(size, ph_cplx_norm2(a));
  }
  return fmin(plus, minus) <= SAME_CURVE * SAME_CURVE * size;
}

/* Whether the trial comes before the best where both bend alike: the shorter,
 * then the first found alone, then the one to the left. */
static enum ph_status comes_before(struct work *w, bool *before) {
  struct ph_mark mark = ph_arena_mark(w->scratch);
  struct ph_curve curve[2];
  enum ph_status status;
  *before = w->trial.length < w->best.length;
  if (!is_same(w->trial.length, w->best.length) || w->is_first) {
    *before = *before && !is_same(w->trial.length, w->best.length);
    return PH_OK;
  }
  status = curve_of(w, &w->trial, &curve[0]);
  status = status == PH_OK ? curve_of(w, &w->best, &curve[1]) : status;
  *before =
      status == PH_OK && ph_planar_compare_sides(&curve[0], &curve[1]) < 0;
  ph_arena_release(w->scratch, mark);
  return status;
}

/* Whether the trial crosses itself where what was found first does not. */
static enum ph_status is_worse(struct work *w, bool *worse) {
  enum ph_status status = PH_OK;
  if (!w->tested) {
    status = test_simple(w, &w->best); /* which is the first */
    w->crosses = !w->best.simple;
    w->tested = true;
  }
  *worse = false;
  if (status == PH_OK && !w->crosses) {
    status = test_simple(w, &w->trial);
    *worse = !w->trial.simple;
  }
  return status;
}

/*
 * Keeps the better one of the trial and the best.
 *
 * in   limited  a trial that crosses itself is of no use if the first does not
 * out  ies      of the trial, infinite where it is of no use
 */
static enum ph_status consider(struct work *w, bool limited, double *ies) {
  struct ph_planar_choice *choice = w->choice;
  bool before, worse = false;
  enum ph_status status = PH_OK;
  *ies = w->best.ies;
  if (is_best(w)) {
    return PH_OK;
  }
  measure(w, ALIKE * w->best.ies);
  *ies = w->trial.ies;
  if (!(*ies <= ALIKE * w->best.ies)) {
    return PH_OK;
  }
  before = *ies < w->best.ies;
  if (is_same(*ies, w->best.ies)) {
    status = comes_before(w, &before);
  }
  if (status == PH_OK && limited) {
    status = is_worse(w, &worse);
  }
  if (worse) {
    *ies = (double)INFINITY;
    return status;
  }
  if (before) {
    struct candidate swap = w->best;
    w->best = w->trial;
    w->trial = swap;
    w->is_first = !limited;
  }
  if (!(choice->other_ies <= w->trial.ies)) {
    choice->other_ies = w->trial.ies;
    choice->other_length = w->trial.length;
  }
  return status;
}

/* ---- starts -------------------------------------------------------------- */

/* A turn between one chord and the next, or an end derivative. */
struct turn {
  size_t at;     /* as of ph_planar_c2_turned */
  double cosine; /* below 0 */
};

static double cosine_before(const struct ph_planar_c2 *c2, size_t i) {
  size_t n = c2->n;
  const ph_cplx *u = c2->direction;
  if (c2->closed) {
    return ph_cplx_dot(u[i > 0 ? i - 1 : n - 1], u[i]);
  }
  return i == 1   ? ph_cplx_dot(c2->end[0], u[0])
         : i <= n ? ph_cplx_dot(u[i - 2], u[i - 1])
                  : ph_cplx_dot(u[n - 1], c2->end[1]);
}

bool ph_planar_turns_sharply(const struct ph_planar_c2 *c2) {
  const ph_cplx *u = c2->direction;
  bool sharp =
      c2->closed ? cosine_before(c2, 0) < 0
                 : cosine_before(c2, 1) < 0 || cosine_before(c2, c2->n + 1) < 0;
  for (size_t k = 1; k < c2->n && !sharp; k++) {
    sharp = ph_cplx_dot(u[k - 1], u[k]) < 0;
  }
  return sharp;
}

static int sharper(const void *left, const void *right) {
  const struct turn *a = left, *b = right;
  int order = ph_fields_order(a->cosine, b->cosine);
  return order ? order : (a->at > b->at) - (a->at < b->at);
}

/* The turns beyond a right angle, the sharpest first. */
static size_t turns_of(const struct ph_planar_c2 *c2, struct turn *turns) {
  size_t n = 0;
  for (size_t i = c2->closed ? 0 : 1; i < ph_planar_unknowns(c2); i++) {
    double cosine = cosine_before(c2, i);
    if (cosine < 0) {
      turns[n++] = (struct turn){i, cosine};
    }
  }
  qsort(turns, n, sizeof *turns, sharper);
  return n;
}

/* A start without a solution is no failure; lack of memory is. */
static enum ph_status skip(struct work *w, enum ph_status status,
                           const struct ph_diag *why) {
  if (status == PH_E_NO_CONVERGENCE) {
    return PH_OK;
  }
  *w->diag = *why;
  return status;
}

/* Compares the solution with these turns the other way round.
 * out  ies  infinite where there is none of use */
static enum ph_status try_turned(struct work *w, const bool *turned,
                                 double *ies) {
  struct ph_mark mark = ph_arena_mark(w->scratch);
  struct ph_diag why;
  enum ph_status status = ph_planar_c2_turned(
      &w->data->c2, turned, w->scratch, w->trial.b, &w->trial.report, &why);
  ph_arena_release(w->scratch, mark);
  *ies = (double)INFINITY;
  if (ph_arena_late(w->scratch)) {
    return ph_fail_memory(w->diag);
  }
  return status == PH_OK ? consider(w, true, ies) : skip(w, status, &why);
}

/* All combinations of n turns. */
static enum ph_status combine(struct work *w, const struct turn *turns,
                              size_t n, bool *turned) {
  enum ph_status status = PH_OK;
  for (size_t mask = 1; mask < (size_t)1 << n && status == PH_OK; mask++) {
    double ies;
    for (size_t i = 0; i < n; i++) {
      turned[turns[i].at] = mask >> i & 1;
    }
    status = try_turned(w, turned, &ies);
  }
  return status;
}

/* Each turn by itself beside those that are made already, then together those
 * that help; and so once more from the best of these. */
static enum ph_status improve(struct work *w, const struct turn *turns,
                              size_t n, double first, bool *turned) {
  bool helps[STARTS_MAX];
  for (int round = 0; round < ROUNDS; round++) {
    double least = first, ies;
    size_t at = n, count = 0;
    enum ph_status status;
    for (size_t i = 0; i < n; i++) {
      turned[turns[i].at] ^= 1;
      status = try_turned(w, turned, &ies);
      turned[turns[i].at] ^= 1;
      if (status != PH_OK) {
        return status;
      }
      helps[i] = ies < first * (1 - SAME);
      count += helps[i];
      at = ies < least ? i : at;
      least = fmin(ies, least);
    }
    if (count == 0) {
      return PH_OK;
    }
    for (size_t i = 0; i < n; i++) {
      turned[turns[i].at] ^= helps[i];
    }
    status = count > 1 ? try_turned(w, turned, &ies) : PH_OK;
    if (status != PH_OK) {
      return status;
    }
    if (count > 1 && !(ies <= least)) { /* not all at once */
      for (size_t i = 0; i < n; i++) {
        turned[turns[i].at] ^= helps[i] && i != at;
      }
      ies = least;
    }
    first = count > 1 ? ies : least;
  }
  return PH_OK;
}

/* in   first  IES with no turn the other way round */
static enum ph_status try_turns(struct work *w, double first) {
  const struct ph_planar_c2 *c2 = &w->data->c2;
  size_t starts = SEGMENTS_MAX / c2->n, n;
  struct turn *turns = ph_arena_array(w->scratch, w->unknowns, sizeof *turns);
  bool *turned = ph_arena_array(w->scratch, w->unknowns, sizeof *turned);
  if (!turns || !turned) {
    return ph_fail_memory(w->diag);
  }
  memset(turned, 0, w->unknowns * sizeof *turned);
  starts = starts < STARTS_MAX ? starts : STARTS_MAX;
  n = turns_of(c2, turns);
  if (c2->n <= COMBINE_MAX) {
    return combine(w, turns, n, turned);
  }
  n = n < starts / ROUNDS ? n : starts / ROUNDS;
  return improve(w, turns, n, first, turned);
}

static enum ph_status try_second(struct work *w,
                                 const struct ph_planar_second *second) {
  double ies;
  if (second->status != PH_OK) {
    return skip(w, second->status, &second->why);
  }
  w->trial.b = second->b;
  w->trial.report = second->report;
  w->data->c2.twist = second->twist;
  return consider(w, false, &ies);
}

static enum ph_status run(struct work *w, ph_cplx *b,
                          struct ph_planar_report *report,
                          const struct ph_planar_second *second) {
  const size_t n = w->data->n, parts_n = (n + PART - 1) / PART;
  struct ph_planar_c2 *c2 = &w->data->c2;
  enum ph_status status;
  double first;
  w->trial = (struct candidate){.b = b, .report = *report};
  w->least = ph_arena_array(w->scratch, c2->n, sizeof *w->least);
  w->part = ph_arena_array(w->scratch, parts_n, sizeof *w->part);
  if (!w->least || !w->part || !ph_energy_begin(&w->sum)) {
    return ph_fail_memory(w->diag);
  }
  measure(w, (double)INFINITY);
  w->best = w->trial;
  first = w->best.ies;
  status = try_second(w, second);
  if (status == PH_OK && SEGMENTS_MAX / c2->n >= ROUNDS) {
    status = try_turns(w, first);
  }
  c2->twist = w->best.twist;
  if (w->best.b != b) {
    memcpy(b, w->best.b, w->unknowns * sizeof *b);
  }
  *report = w->best.report;
  w->choice->ies = w->best.ies;
  if (!(w->choice->other_ies <= ALIKE * w->best.ies)) {
    w->choice->other_ies = (double)NAN;
  }
  return status;
}

enum ph_status ph_planar_choose(struct ph_planar_data *data,
                                struct ph_arena *scratch, ph_cplx *b,
                                struct ph_planar_report *report,
                                const struct ph_planar_second *second,
                                struct ph_planar_choice *choice,
                                struct ph_diag *diag) {
  struct ph_mark mark = ph_arena_mark(scratch);
  struct work w = {.data = data,
                   .scratch = scratch,
                   .diag = diag,
                   .unknowns = ph_planar_unknowns(&data->c2),
                   .is_first = true,
                   .choice = choice};
  const double none = (double)NAN;
  enum ph_status status = PH_OK;
  *choice = (struct ph_planar_choice){none, none, none};
  if (ph_planar_turns_sharply(&data->c2)) {
    status = run(&w, b, report, second);
  }
  ph_arena_release(scratch, mark);
  return status;
}
