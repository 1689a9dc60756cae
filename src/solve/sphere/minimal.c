/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The smallest tensions (see sphere.h): sequential linear programming.
 *
 * Raised nodes that are near each other are a block, whose tensions are changed
 * together while all others stay: what the criteria in and around it ask for is
 * made linear by differences, and the sum of the tensions is minimised subject
 * to that (kernel/lp.h) in a box around the tensions (a trust region).  The
 * step is taken if the criteria hold there; otherwise it is corrected for what
 * it missed, and at last the box is made smaller.
 *
 * Feasibility is not monotonic in a tension, so that a local minimum is found.
 */
#include "solve/sphere/sphere.h"

#include "kernel/lp.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

enum {
  BLOCK_MAX = 12, /* nodes of a block */
  GAP_MAX = 8,    /* nodes between raised ones of a block */
  AROUND = 5, /* nodes on either side of a block whose criteria it regards */
  REACH = 10, /* and that are solved: 3.7^-10 twice, there and back */
  NEAR = 6,   /* and around one node, for a derivative */
  SPAN_MAX = BLOCK_MAX * (GAP_MAX + 1),
  JUDGED_MAX = SPAN_MAX + 2 * AROUND,
  ROWS_MAX = JUDGED_MAX * 2 * PH_SPHERE_MEASURES,
  STEPS_MAX = 40,  /* linearisations of a block */
  CORRECTIONS = 3, /* of a linear program in a box */
  SWEEPS_MAX = 4   /* of all blocks, where a run of raised nodes has several */
};

/* The box at first, relative to the tensions (at least SMALL of the largest),
 * how it shrinks and grows, and when it is too small.  In a larger one than
 * BOX_MAX the sum is too far from linear. */
static const double BOX = 0.5;
static const double BOX_MAX = 1;
static const double BOX_MIN = 1e-3;
static const double SHRINK = 0.3;
static const double SMALL = 0.05;

/* What gives way beside a tension, in stiffnesses: 4/h- + 4/h+ less what the
 * neighbours add, 2 (2 - sqrt(3)) / h on both sides. */
static const double YIELD = 0.87;

/* Differences: short ones have slopes of rounding in criteria that a tension
 * hardly moves, whose rows are divided by their norms, and the same data in
 * another unit end elsewhere.  What long ones miss of curved criteria is
 * corrected like the rest. */
static const double DIFFERENCE = 1e-2;

/* The fall of the sum that is no progress in a box of size BOX. */
static const double PROGRESS = 1e-3;

/* A tension that comes down to its least one has rounding left, of this. */
static const double DOWN = 1e-9;

/* Angles below which the response to a step is its solution: what is neglected
 * is about 0.01 theta^2 of it, 1e-6, far less than the margins of the criteria;
 * all is solved once more in the end. */
static const double LINEAR = 1e-2;

/* Angles up to which the response, and what follows it, lead to the solution in
 * a few steps: beyond, Newton's iteration needs no more time. */
static const double RESPONDS = 0.5;

/* A block on its way. */
struct block {
  struct ph_sphere_raise *raise;
  size_t q;                      /* its nodes */
  size_t node[BLOCK_MAX];        /* in the order of the data */
  struct ph_sphere_range judged; /* whose criteria a program has */
  struct ph_sphere_range solved; /* where the spline changes */
  bool idle[BLOCK_MAX];          /* at its given tension, and left there */
  double nu[BLOCK_MAX];          /* tensions of the last good spline, */
  ph_vec3 *x;                    /* [solved.count] and its x, r and l, */
  ph_vec3 *r, *l;                /* [solved.count + 1] of the segments there */
  size_t rows;
  size_t row[JUDGED_MAX + 1]; /* the first one of each node that is judged */
  double *g;                  /* [ROWS_MAX] criteria at nu, */
  double *moved;              /* [ROWS_MAX] beside it, */
  double *jacobian;           /* [ROWS_MAX][q] and by nu */
  double *norm;               /* [ROWS_MAX] what its rows were divided by */
  double *rhs;                /* [ROWS_MAX] */
  struct ph_lp_work lp;
  bool responds; /* the model has a response to tensions, */
  bool linear;   /* which is the solution, as angles are so small */
  struct ph_sphere_response response; /* of what is solved */
};

static bool is_late(const struct block *b) {
  return ph_arena_late(b->raise->work->arena);
}

/* ---- one set of tensions ------------------------------------------------- */

static double sum_of(const struct block *b, const double *nu) {
  double sum = 0;
  for (size_t j = 0; j < b->q; j++) {
    sum += nu[j];
  }
  return sum;
}

/* Segment j of those at the nodes that are solved: it ends at node j. */
static size_t segment_at(const struct block *b, size_t j) {
  const struct ph_sphere_data *d = b->raise->spline->data;
  return j < b->solved.count
             ? ph_sphere_before(d, ph_sphere_node(d, b->solved, j))
             : ph_sphere_node(d, b->solved, j - 1);
}

/* The spline as it was kept at some of its nodes. */
static void restore_at(struct block *b, size_t first, size_t count) {
  struct ph_sphere_spline *s = b->raise->spline;
  for (size_t j = first; j < first + count; j++) {
    s->x[ph_sphere_node(s->data, b->solved, j)] = b->x[j];
  }
  for (size_t j = first; j <= first + count; j++) {
    s->r[segment_at(b, j)] = b->r[j];
    s->l[segment_at(b, j)] = b->l[j];
  }
}

/* All of it. */
static void restore(struct block *b) {
  for (size_t j = 0; j < b->q; j++) {
    b->raise->spline->nu[b->node[j]] = b->nu[j];
  }
  restore_at(b, 0, b->solved.count);
}

static void keep(struct block *b) {
  const struct ph_sphere_spline *s = b->raise->spline;
  for (size_t j = 0; j < b->q; j++) {
    b->nu[j] = s->nu[b->node[j]];
  }
  for (size_t j = 0; j < b->solved.count; j++) {
    b->x[j] = s->x[ph_sphere_node(s->data, b->solved, j)];
  }
  for (size_t j = 0; j <= b->solved.count; j++) {
    b->r[j] = s->r[segment_at(b, j)];
    b->l[j] = s->l[segment_at(b, j)];
  }
}

/* Solves at other tensions; if that fails, all is as it was kept. */
static bool solve_at(struct block *b, const double *nu) {
  struct ph_sphere_spline *s = b->raise->spline;
  for (size_t j = 0; j < b->q; j++) {
    s->nu[b->node[j]] = nu[j];
  }
  if (b->linear) {
    ph_sphere_respond(s, &b->response, 0, b->solved.count, b->raise->work);
    return true;
  }
  if (b->responds) {
    if (ph_sphere_respond_well(s, &b->response, b->raise->work)) {
      return true;
    }
    restore_at(b, 0, b->solved.count);
  }
  if (ph_sphere_newton(s, b->solved, b->raise->work)) {
    return true;
  }
  restore(b);
  return false;
}

/* ---- linear programs ----------------------------------------------------- */

/* All that is asked at node j of those that are judged, and of the segment
 * before it. */
static size_t measure_at(const struct block *b, size_t j, double *g) {
  const struct ph_sphere_raise *raise = b->raise;
  const struct ph_sphere_spline *s = raise->spline;
  size_t i = ph_sphere_node(s->data, b->judged, j);
  size_t k = ph_sphere_before(s->data, i), n = 0;
  if (!(raise->ignored[k] & PH_SPHERE_IGNORE_SEGMENT)) {
    n += ph_sphere_measure_segment(raise->shape, s, k, g);
  }
  if (!(raise->ignored[i] & PH_SPHERE_IGNORE_NODE)) {
    n += ph_sphere_measure_node(raise->shape, s, i, g + n);
  }
  return n;
}

/* Makes the rows of the jacobian of unit norm; those without a slope are no
 * constraints. */
static void scale_rows(struct block *b) {
  for (size_t row = 0; row < b->rows; row++) {
    double *slope = b->jacobian + row * b->q, norm = 0;
    for (size_t j = 0; j < b->q; j++) {
      norm += slope[j] * slope[j];
    }
    norm = sqrt(norm);
    b->norm[row] = norm > 0 && isfinite(norm) ? norm : (double)INFINITY;
    for (size_t j = 0; j < b->q; j++) {
      slope[j] = isfinite(b->norm[row]) ? slope[j] / norm : 0;
    }
  }
}

/* The nodes around one, of those that are solved: the first, and how many. */
static struct ph_sphere_range near_of(const struct block *b, size_t i) {
  const struct ph_sphere_data *d = b->raise->spline->data;
  struct ph_sphere_range near = ph_sphere_widen(d, i, 1, NEAR);
  size_t n = b->solved.count;
  near.first += near.first < b->solved.first ? d->n : 0;
  near.first -= b->solved.first;
  if (near.count >= n || near.first + near.count > n) {
    return (struct ph_sphere_range){0, n};
  }
  return near;
}

/* One step of Newton's iteration at these. */
static void step_at(struct block *b, struct ph_sphere_range near) {
  struct ph_sphere_spline *s = b->raise->spline;
  if (b->responds) {
    ph_sphere_respond(s, &b->response, near.first, near.count, b->raise->work);
  } else {
    near.first = ph_sphere_node(s->data, b->solved, near.first);
    ph_sphere_step(s, near, b->raise->work);
  }
}

/* The derivatives of g by the tension of node j of the block: by one step
 * around it, beyond which there is hardly an effect. */
static void differentiate_by(struct block *b, size_t j) {
  const struct ph_sphere_spline *s = b->raise->spline;
  const struct ph_sphere_data *d = s->data;
  size_t i = b->node[j];
  struct ph_sphere_range near = near_of(b, i);
  double step = DIFFERENCE * fmax(b->nu[j], ph_sphere_stiffness(d, i) / 64);
  s->nu[i] += step;
  step_at(b, near);
  for (size_t at = 0; at < b->judged.count; at++) {
    size_t node = ph_sphere_node(d, b->judged, at);
    size_t far = node > i ? node - i : i - node;
    far = d->closed && d->n - far < far ? d->n - far : far;
    if (far >= NEAR) {
      continue;
    }
    measure_at(b, at, b->moved + b->row[at]);
    for (size_t row = b->row[at]; row < b->row[at + 1]; row++) {
      b->jacobian[row * b->q + j] = (b->moved[row] - b->g[row]) / step;
    }
  }
  s->nu[i] = b->nu[j];
  restore_at(b, near.first, near.count);
}

/* g and its derivatives at the tensions that are kept. */
static void differentiate(struct block *b) {
  if (b->responds) {
    ph_sphere_response_of(b->raise->spline, b->solved, &b->response);
  }
  b->row[0] = 0;
  for (size_t at = 0; at < b->judged.count; at++) {
    b->row[at + 1] = b->row[at] + measure_at(b, at, b->g + b->row[at]);
  }
  b->rows = b->row[b->judged.count];
  memset(b->jacobian, 0, b->rows * b->q * sizeof *b->jacobian);
  for (size_t j = 0; j < b->q; j++) {
    if (!b->idle[j]) {
      differentiate_by(b, j);
    }
  }
  scale_rows(b);
}

/* What the linear criteria miss at nu + step, where the spline is, is added to
 * them: the next step meets the curved ones better. */
static void correct(struct block *b, const double *step) {
  for (size_t at = 0; at < b->judged.count; at++) {
    measure_at(b, at, b->moved + b->row[at]);
  }
  for (size_t row = 0; row < b->rows; row++) {
    const double *slope = b->jacobian + row * b->q;
    double along = 0;
    for (size_t j = 0; j < b->q; j++) {
      along += slope[j] * step[j];
    }
    b->rhs[row] = along - b->moved[row] / b->norm[row];
  }
}

/*
 * Velocities are about w / (a + nu) with a = YIELD stiffnesses, which is linear
 * in 1 / (a + nu): steps z of a linear program are those of -(a + nu0)^2 times
 * that, by which nu begins to move as z does and goes on as
 *   nu - nu0 = z / (1 - z / (a + nu0)).
 */
static double yield_of(const struct block *b, size_t j) {
  const struct ph_sphere_data *d = b->raise->spline->data;
  return YIELD * ph_sphere_stiffness(d, b->node[j]) + b->nu[j];
}

static double to_step(const struct block *b, size_t j, double change) {
  return change / (1 + change / yield_of(b, j));
}

static double to_change(const struct block *b, size_t j, double step) {
  return step / (1 - step / yield_of(b, j));
}

/* The step to the least sum in a box. */
static bool find_step(struct block *b, double box, double *step) {
  const struct ph_sphere_data *d = b->raise->spline->data;
  double one[BLOCK_MAX], lower[BLOCK_MAX], upper[BLOCK_MAX], largest = 0;
  struct ph_lp lp = {.n = b->q,
                     .m = b->rows,
                     .c = one,
                     .lower = lower,
                     .upper = upper,
                     .a = b->jacobian,
                     .b = b->rhs};
  for (size_t j = 0; j < b->q; j++) {
    largest = fmax(largest, b->nu[j]);
  }
  for (size_t j = 0; j < b->q; j++) {
    double side = box * fmax(b->nu[j], SMALL * largest);
    double down = b->nu[j] - d->nu[b->node[j]];
    one[j] = 1;
    lower[j] = to_step(b, j, down < side ? -down : -side);
    upper[j] = b->idle[j] ? 0 : to_step(b, j, side);
  }
  return ph_lp_solve(&lp, &b->lp, step) == PH_LP_OPTIMAL;
}

/* Takes other tensions if the criteria hold there; otherwise the spline is left
 * there, or as it was kept where there is none. */
static bool take(struct block *b, double *nu) {
  const struct ph_sphere_data *d = b->raise->spline->data;
  size_t from = 0, at;
  for (size_t j = 0; j < b->q; j++) {
    double least = d->nu[b->node[j]];
    nu[j] = nu[j] - least > DOWN * yield_of(b, j) ? nu[j] : least;
  }
  if (!solve_at(b, nu) ||
      ph_sphere_violated(b->raise, b->solved, &from, &at) != PH_SPHERE_FINE) {
    return false;
  }
  keep(b);
  return true;
}

/* By how much a part of a step makes the sum fall. */
static double fall_of(const struct block *b, const double *step, double part) {
  double fall = 0;
  for (size_t j = 0; j < b->q; j++) {
    fall -= to_change(b, j, part * step[j]);
  }
  return fall;
}

/* The same with a part of a step. */
static bool take_step(struct block *b, const double *step, double part) {
  double nu[BLOCK_MAX];
  for (size_t j = 0; j < b->q; j++) {
    nu[j] = b->nu[j] + to_change(b, j, part * step[j]);
  }
  return take(b, nu);
}

/* The fall of the sum that is no progress in a box. */
static double too_little(const struct block *b, double box) {
  return PROGRESS * sum_of(b, b->nu) * fmin(box / BOX, 1);
}

/* Takes the step that a linear program finds in the box, corrected some times
 * for the curvature of the criteria, if they hold there: those of the program
 * have a margin.  Or a part of the last one.  Which part: 0 is none, and less
 * than 0 where the program itself makes no progress.  The sum is linear to it
 * alone: what it takes for a fall may be none. */
static double go(struct block *b, double box) {
  static const double parts[] = {0.5, 0.2, 0.05};
  double step[BLOCK_MAX];
  for (size_t row = 0; row < b->rows; row++) {
    b->rhs[row] = -fmax(b->g[row], 0) / b->norm[row];
  }
  if (!find_step(b, box, step)) {
    return 0;
  }
  if (-sum_of(b, step) < too_little(b, box)) {
    return -1;
  }
  for (size_t i = 0; fall_of(b, step, 1) > 0; i++) {
    double next[BLOCK_MAX];
    if (take_step(b, step, 1)) {
      return 1;
    }
    correct(b, step);
    restore(b);
    if (i == CORRECTIONS || !find_step(b, box, next)) {
      break;
    }
    memcpy(step, next, sizeof next);
  }
  for (size_t i = 0; i < sizeof parts / sizeof parts[0]; i++) {
    if (fall_of(b, step, parts[i]) > 0 && take_step(b, step, parts[i])) {
      return parts[i];
    }
    restore(b);
  }
  return 0;
}

/* The largest angle where the spline changes. */
static double largest_angle(const struct block *b) {
  const struct ph_sphere_data *d = b->raise->spline->data;
  double largest = 0;
  for (size_t j = 0; j <= b->solved.count; j++) {
    largest = fmax(largest, d->theta[segment_at(b, j)]);
  }
  return largest;
}

/* Leaves the nodes alone that are at their given tensions, if any may be:
 * most of them stay there, and to ask takes a derivative.  Whether some are. */
static bool set_idle(struct block *b, bool any) {
  const struct ph_sphere_data *d = b->raise->spline->data;
  bool some = false;
  for (size_t j = 0; j < b->q; j++) {
    b->idle[j] = any && !(b->nu[j] > d->nu[b->node[j]]);
    some = some || b->idle[j];
  }
  return some;
}

/* Steps from one linearisation to the next, of all nodes in the end. */
static void minimise_block(struct block *b) {
  double box = BOX, angle = largest_angle(b);
  bool idle = false;
  b->responds = b->raise->spline->model->retension && angle <= RESPONDS;
  b->linear = b->responds && angle <= LINEAR;
  keep(b);
  for (size_t i = 0; i < STEPS_MAX && box > BOX_MIN && !is_late(b); i++) {
    double sum = sum_of(b, b->nu), least = too_little(b, box), part = 0;
    if (!(sum > 0)) {
      return;
    }
    idle = set_idle(b, idle);
    differentiate(b);
    while (!(part > 0 || part < 0) && box > BOX_MIN && !is_late(b)) {
      part = go(b, box);
      box *= part < 0 || part >= 1 ? 1 : SHRINK;
    }
    if (part > 0 && sum - sum_of(b, b->nu) >= least) {
      box = part < 1 ? box : fmin(2 * box, BOX_MAX);
      idle = true;
    } else if (idle) {
      idle = false;
    } else {
      return;
    }
  }
}

/* ---- blocks -------------------------------------------------------------- */

static bool is_raised(const struct ph_sphere_spline *s, size_t i) {
  return s->nu[i] > s->data->nu[i];
}

/* Where to begin: closed data after their longest stretch of nodes that are not
 * raised, so that no run begins before. */
static size_t origin_of(const struct ph_sphere_spline *s) {
  struct ph_sphere_range all = ph_sphere_all(s->data);
  size_t best = 0, origin = all.first, stretch = 0;
  for (size_t j = 0; s->data->closed && j < 2 * all.count; j++) {
    size_t i = j % all.count;
    if (!is_raised(s, i)) {
      stretch++;
    } else {
      if (stretch > best) {
        best = stretch;
        origin = i;
      }
      stretch = 0;
    }
  }
  return origin;
}

/* The raised nodes of a range, by their numbers in it, in order; how many. */
static size_t list_raised(const struct ph_sphere_spline *s,
                          struct ph_sphere_range range, size_t *raised) {
  size_t n = 0;
  for (size_t j = 0; j < range.count; j++) {
    if (is_raised(s, ph_sphere_node(s->data, range, j))) {
      raised[n++] = j;
    }
  }
  return n;
}

/* Whether the tensions of a run lean to its end: a sense that data read
 * backwards do not share. */
static bool leans_back(const struct ph_sphere_spline *s,
                       struct ph_sphere_range range, const size_t *raised,
                       size_t n) {
  double moment = 0;
  for (size_t j = 0; j < n / 2; j++) {
    moment += s->nu[ph_sphere_node(s->data, range, raised[j])] -
              s->nu[ph_sphere_node(s->data, range, raised[n - 1 - j])];
  }
  return moment < 0;
}

/* The blocks of a run of raised nodes, of equal size, on odd sweeps half a
 * block further. */
static void minimise_run(struct block *b, struct ph_sphere_range range,
                         const size_t *raised, size_t n, size_t sweep) {
  const struct ph_sphere_spline *s = b->raise->spline;
  size_t blocks = (n + BLOCK_MAX - 1) / BLOCK_MAX;
  bool back = leans_back(s, range, raised, n);
  size_t end = sweep % 2 == 1 ? n / (2 * blocks) : n / blocks;
  for (size_t i = 1, begin = 0; begin < n && !is_late(b); i++) {
    size_t first, last;
    b->q = end - begin;
    for (size_t j = 0; j < b->q; j++) {
      size_t at = back ? n - end + j : begin + j;
      b->node[j] = ph_sphere_node(s->data, range, raised[at]);
    }
    first = raised[back ? n - end : begin];
    last = raised[back ? n - 1 - begin : end - 1];
    b->judged = ph_sphere_widen(s->data, b->node[0], last - first + 1, AROUND);
    b->solved = ph_sphere_widen(s->data, b->node[0], last - first + 1, REACH);
    if (b->q > 0) {
      minimise_block(b);
    }
    begin = end;
    end =
        sweep % 2 == 1 ? (2 * i + 1) * n / (2 * blocks) : (i + 1) * n / blocks;
    end = end < n ? end : n;
  }
}

static double total(const struct ph_sphere_spline *s) {
  double sum = 0;
  for (size_t i = 0; i < s->data->n; i++) {
    sum += s->nu[i];
  }
  return sum;
}

/* Every run once, and again while there is progress those of several blocks. */
static void sweep_all(struct block *b, size_t *raised) {
  const struct ph_sphere_spline *s = b->raise->spline;
  struct ph_sphere_range range = {origin_of(s), ph_sphere_all(s->data).count};
  size_t n = list_raised(s, range, raised);
  bool again = true;
  for (size_t sweep = 0; again && sweep < SWEEPS_MAX; sweep++) {
    double before = total(s);
    again = false;
    for (size_t begin = 0, end = 1; begin < n; begin = end, end++) {
      while (end < n && raised[end] - raised[end - 1] <= GAP_MAX + 1) {
        end++;
      }
      if (sweep == 0 || end - begin > BLOCK_MAX) {
        minimise_run(b, range, raised + begin, end - begin, sweep);
        again = again || end - begin > BLOCK_MAX;
      }
    }
    again = again && before - total(s) >= PROGRESS * before;
  }
}

static bool alloc(struct block *b, struct ph_arena *scratch) {
  size_t number = sizeof(double);
  size_t nodes = SPAN_MAX + 2 * REACH;
  b->x = ph_arena_array(scratch, nodes, sizeof *b->x);
  b->r = ph_arena_array(scratch, nodes + 1, sizeof *b->r);
  b->l = ph_arena_array(scratch, nodes + 1, sizeof *b->l);
  b->g = ph_arena_array(scratch, ROWS_MAX, number);
  b->moved = ph_arena_array(scratch, ROWS_MAX, number);
  b->jacobian = ph_arena_array(scratch, ROWS_MAX, BLOCK_MAX * number);
  b->norm = ph_arena_array(scratch, ROWS_MAX, number);
  b->rhs = ph_arena_array(scratch, ROWS_MAX, number);
  return b->x && b->r && b->l && b->g && b->moved && b->jacobian && b->norm &&
         b->rhs && ph_sphere_response_alloc(&b->response, scratch, nodes) &&
         ph_lp_alloc(&b->lp, scratch, BLOCK_MAX, ROWS_MAX);
}

bool ph_sphere_minimise(struct ph_sphere_raise *raise,
                        struct ph_arena *scratch) {
  struct block b = {.raise = raise};
  size_t *raised =
      ph_arena_array(scratch, raise->spline->data->n, sizeof *raised);
  if (!raised || !alloc(&b, scratch)) {
    return false;
  }
  sweep_all(&b, raised);
  return true;
}
