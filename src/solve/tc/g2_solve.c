/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The tangents of curvature-continuous splines (see g2.h).
 *
 * At a node between spans i - 1 and i of lengths L
 *
 *   F = g(a[i-1], b[i-1]) - ln L[i-1] - f(a[i], b[i]) + ln L[i] = 0
 *
 * where the turn phi is shared, b[i-1] + a[i] = phi.  Between two arcs the
 * unknown is y = ln(b/a), so that both stay positive and flat nodes cost no
 * digits; beside one bend, ln of the angle on the side of the arc; between two
 * bends the angle itself, over that of the turns around.  Nodes beside a line
 * have its tangent and no equation.
 *
 * For continuation turns and ln L are multiplied by h in (0, 1].
 */
#include "solve/tc/g2.h"

#include "kernel/pi.h"
#include "kernel/tri.h"

#include <float.h>
#include <math.h>
#include <string.h>

/* Residuals of no more are none; those that do not fall any more are rounding
 * below this, or so many times what rounding of the angles makes of them, if
 * the step is as small as this. */
static const double DONE = 4e-13, ROUNDING = 1e-8, ANGLES = 8, TINY_STEP = 1e-5;

/* No unknown changes by more in a step. */
static const double STEP_MAX = 4;

/* Where the iteration begins, ln(b/a) is no larger. */
static const double START_MAX = 25;

/* Part of a residual that a step must remove, times its length. */
static const double ARMIJO = 1e-4;

enum { NEWTON_MAX = 60, CONTINUED_MAX = 25, HALVINGS_MAX = 25 };

/* Continuation: its first step, and where it gives up. */
static const double FIRST_STEP = 0.1, LAST_STEP = 1e-3;
enum { CONTINUATIONS_MAX = 500 };

/* How the tangent at a node is unknown. */
enum kind {
  KNOWN,
  SHARED,    /* between two arcs */
  OF_BEFORE, /* an arc before it */
  OF_AFTER,  /* an arc after it */
  BETWEEN_BENDS
};

/* The curve of one iterate. */
struct state {
  double *y;               /* [nodes] the unknowns */
  double *before, *after;  /* [nodes] b before and a after each node */
  double *rate;            /* [nodes] derivative of `before` by y */
  struct ph_g2_ends *ends; /* [n] */
  double norm2, largest;   /* of the residuals */
};

struct system {
  const struct ph_g2_chain *chain;
  double h;             /* continuation */
  double smooth[2];     /* angles at the ends; NaN where the rule is */
  enum kind *kind;      /* [nodes] */
  double *turn, *scale; /* [nodes] in the sense of the node; see above */
  double *known;        /* [nodes] b before it, of known nodes */
  double *log_length;   /* [n] */
  double *step;         /* [nodes] */
  ph_cplx *x;           /* [nodes] */
  struct state now, next;
  struct ph_tri tri;
  size_t iterations;
};

/* ---- what is unknown ------------------------------------------------------
 */

static const struct ph_g2_span *before(const struct ph_g2_chain *c, size_t k) {
  return &c->span[ph_g2_before(c, k)];
}

static enum kind kind_of(const struct ph_g2_chain *c, size_t k) {
  const struct ph_g2_node *node = &c->node[k];
  enum ph_g2_form left, right;
  if (!node->inner || node->sign == 0) {
    return KNOWN;
  }
  left = before(c, k)->form;
  right = c->span[k].form;
  if (left == PH_G2_LINE || right == PH_G2_LINE) {
    return KNOWN;
  }
  return left == right       ? (left == PH_G2_ARC ? SHARED : BETWEEN_BENDS)
         : left == PH_G2_ARC ? OF_BEFORE
                             : OF_AFTER;
}

/* The largest turn within two nodes. */
static double turn_around(const struct ph_g2_chain *c, size_t k) {
  const size_t n = c->nodes_n;
  double largest = 0;
  for (size_t by = 0; by < 5; by++) {
    size_t at = k + by; /* two further */
    if (c->closed) {
      largest = fmax(largest, fabs(c->node[(at + 2 * n - 2) % n].turn));
    } else if (at >= 2 && at - 2 < n && c->node[at - 2].inner) {
      largest = fmax(largest, fabs(c->node[at - 2].turn));
    }
  }
  return largest;
}

/* The angle from the chord before a node to the tangent of the circle through
 * it and its neighbours, in the sense of the turn. */
static double circle_angle(const struct ph_g2_chain *c, size_t k, double turn) {
  double l = before(c, k)->length, r = c->span[k].length;
  return atan2(l * sin(turn), r + l * cos(turn));
}

static void begin(struct system *s) {
  const struct ph_g2_chain *c = s->chain;
  for (size_t i = 0; i < c->n; i++) {
    s->log_length[i] = log(c->span[i].length);
  }
  for (size_t k = 0; k < c->nodes_n; k++) {
    s->kind[k] = kind_of(c, k);
    s->turn[k] = c->node[k].sign < 0 ? -c->node[k].turn : c->node[k].turn;
    s->scale[k] = s->kind[k] == BETWEEN_BENDS ? turn_around(c, k) : 1;
    s->known[k] = 0;
    if (c->node[k].inner && s->kind[k] == KNOWN &&
        before(c, k)->form != PH_G2_LINE) {
      s->known[k] = s->turn[k];
    }
  }
}

/* ---- starts ---------------------------------------------------------------
 */

/* Angles beside a bend are this part of those of the other side, or this. */
static const double OF_OTHER = 0.2, LEAST = 1e-14;

/* The angle before node k where the iteration begins. */
static double first_angle(const struct system *s, size_t k, bool halves) {
  return s->kind[k] == KNOWN ? s->known[k]
         : halves            ? s->turn[k] / 2
                             : circle_angle(s->chain, k, s->turn[k]);
}

/* Unknowns of a start. */
static void start(struct system *s, bool halves) {
  const struct ph_g2_chain *c = s->chain;
  for (size_t k = 0; k < c->nodes_n; k++) {
    double b, a, *y = &s->now.y[k];
    *y = 0;
    if (s->kind[k] == KNOWN) {
      continue;
    }
    b = first_angle(s, k, halves);
    a = s->turn[k] - b;
    if (s->kind[k] == OF_BEFORE) {
      size_t next = ph_g2_next(c, k);
      double beyond = c->node[next].inner ? first_angle(s, next, halves) : 0;
      *y = log(fmax(fmax(b, OF_OTHER * beyond), LEAST));
    } else if (s->kind[k] == OF_AFTER) {
      size_t last = ph_g2_before(c, k);
      double beyond = c->node[last].inner
                          ? s->turn[last] - first_angle(s, last, halves)
                          : 0;
      *y = log(fmax(fmax(a, OF_OTHER * beyond), LEAST));
    } else if (s->kind[k] == SHARED) {
      *y = fmax(-START_MAX, fmin(log(b / a), START_MAX));
    } else {
      *y = b / s->scale[k];
    }
    *y = isfinite(*y) ? *y : 0;
  }
}

/* ---- one iterate ----------------------------------------------------------
 */

static void set_angles(const struct system *s, struct state *at) {
  for (size_t k = 0; k < s->chain->nodes_n; k++) {
    double phi = s->h * s->turn[k], y = at->y[k], e, b, rate;
    switch (s->kind[k]) {
    case SHARED:
      e = exp(-fabs(y));
      at->before[k] = phi * (y < 0 ? e : 1) / (1 + e);
      at->after[k] = phi * (y < 0 ? 1 : e) / (1 + e);
      at->rate[k] = at->before[k] * (y < 0 ? 1 : e) / (1 + e);
      continue;
    case OF_AFTER:
      at->after[k] = exp(y);
      at->before[k] = phi - at->after[k];
      at->rate[k] = -at->after[k];
      continue;
    case OF_BEFORE:
      b = rate = exp(y);
      break;
    case BETWEEN_BENDS:
      b = y * s->scale[k];
      rate = s->scale[k];
      break;
    default:
      b = s->h * s->known[k];
      rate = 0;
      break;
    }
    at->before[k] = b;
    at->after[k] = phi - b;
    at->rate[k] = rate;
  }
}

/* An end without a tangent: that of the circle, or less where that would not
 * do. */
static double end_rule(double angle, double *slope) {
  double t = tanh(3 * angle / PH_PI);
  *slope = 1 - t * t;
  return PH_PI / 3 * t;
}

/* Whether the rule is for an end: 0 the first, 1 the last. */
static bool has_rule(const struct system *s, size_t end) {
  return !s->chain->closed && !s->chain->given[end] && isnan(s->smooth[end]);
}

/* The angle at an end of open data, in the sense of its span. */
static double end_angle(const struct system *s, const struct state *at,
                        size_t end) {
  const struct ph_g2_chain *c = s->chain;
  double slope;
  if (c->given[end]) {
    return s->h * s->turn[end * c->n];
  }
  if (!isnan(s->smooth[end])) {
    return s->h * s->smooth[end];
  }
  return end_rule(c->n == 1  ? s->h * s->turn[1 - end]
                  : end == 0 ? at->before[1]
                             : at->after[c->n - 1],
                  &slope);
}

/* Residual of node k, known or not. */
static double residual(const struct system *s, const struct state *at,
                       size_t k) {
  return s->kind[k] == KNOWN
             ? 0
             : at->ends[ph_g2_before(s->chain, k)].g - at->ends[k].f;
}

/* All of an iterate from its unknowns.  ret false: not allowed */
static bool evaluate(const struct system *s, struct state *at) {
  const struct ph_g2_chain *c = s->chain;
  set_angles(s, at);
  if (!c->closed) {
    at->after[0] = end_angle(s, at, 0);
    at->before[c->n] = end_angle(s, at, 1);
  }
  for (size_t i = 0; i < c->n; i++) {
    double a = at->after[i], b = at->before[ph_g2_next(c, i)];
    struct ph_g2_ends *e = &at->ends[i];
    if (c->span[i].form == PH_G2_LINE) {
      continue;
    }
    if (!(c->span[i].form == PH_G2_ARC ? ph_g2_arc(a, b, e)
                                       : ph_g2_bend_ends(a, b, e))) {
      return false;
    }
    e->f -= s->h * s->log_length[i];
    e->g -= s->h * s->log_length[i];
  }
  at->norm2 = at->largest = 0;
  for (size_t k = 0; k < c->nodes_n; k++) {
    double f = residual(s, at, k);
    at->norm2 += f * f;
    at->largest = fmax(at->largest, fabs(f));
  }
  return isfinite(at->norm2);
}

/* ---- Newton's method ------------------------------------------------------
 */

static struct ph_tri_row row_of(const struct system *s, size_t k) {
  const struct ph_g2_chain *c = s->chain;
  const struct state *at = &s->now;
  struct ph_tri_row row = {{0, 0}, {1, 0}, {0, 0}, {0, 0}};
  size_t l = ph_g2_before(c, k), next = ph_g2_next(c, k);
  double slope;
  if (s->kind[k] == KNOWN) {
    return row;
  }
  row.f.re = -residual(s, at, k);
  row.di.re = (at->ends[l].g_b + at->ends[k].f_a) * at->rate[k];
  row.lo.re = -at->ends[l].g_a * at->rate[l];
  row.up.re = -at->ends[k].f_b * at->rate[next];
  if (!c->closed && k == 1 && has_rule(s, 0)) {
    end_rule(at->before[k], &slope);
    row.di.re += at->ends[l].g_a * slope * at->rate[k];
  }
  if (!c->closed && next == c->n && has_rule(s, 1)) {
    end_rule(at->after[k], &slope);
    row.di.re += at->ends[k].f_b * slope * at->rate[k];
  }
  return row;
}

/* The step of Newton's method.  ret its largest element, or not finite */
static double newton_step(struct system *s) {
  const size_t n = s->chain->nodes_n;
  struct ph_tri_row row;
  double largest = 0, sum = 0;
  ph_tri_begin(&s->tri, n, row_of(s, 0), row_of(s, n - 1));
  for (size_t k = 1; k + 1 < n; k++) {
    row = row_of(s, k);
    ph_tri_push(&s->tri, &row);
  }
  ph_tri_finish(&s->tri, s->x);
  for (size_t k = 0; k < n; k++) {
    s->step[k] = s->x[k].re;
    largest = fmax(largest, fabs(s->step[k]));
    sum += s->step[k] - s->step[k];
  }
  return largest + sum;
}

/* Goes along the step until the residual falls. */
static bool descend(struct system *s, double largest) {
  double part = fmin(1, STEP_MAX / largest);
  for (size_t halving = 0; halving < HALVINGS_MAX; halving++, part /= 2) {
    double most = (1 - ARMIJO * part) * sqrt(s->now.norm2);
    for (size_t k = 0; k < s->chain->nodes_n; k++) {
      s->next.y[k] = s->now.y[k] + part * s->step[k];
    }
    if (evaluate(s, &s->next) && sqrt(s->next.norm2) <= most) {
      struct state swap = s->now;
      s->now = s->next;
      s->next = swap;
      return true;
    }
  }
  return false;
}

/* What rounding makes of the angles at node k: one is the turn less the other.
 */
static double angle_error(const struct state *at, size_t k) {
  return DBL_EPSILON * (fabs(at->before[k]) + fabs(at->after[k]));
}

/* Whether all residuals are rounding: of a bend on a short chord, with angles
 * of 1e-9 beside one of 1, they cannot be less than 1e-7. */
static bool is_rounding(const struct system *s) {
  const struct ph_g2_chain *c = s->chain;
  const struct state *at = &s->now;
  for (size_t k = 0; k < c->nodes_n; k++) {
    const size_t l = ph_g2_before(c, k), next = ph_g2_next(c, k);
    double most = ROUNDING;
    if (s->kind[k] == KNOWN) {
      continue;
    }
    most =
        fmax(most, ANGLES * ((fabs(at->ends[l].g_b) + fabs(at->ends[k].f_a)) *
                                 angle_error(at, k) +
                             fabs(at->ends[l].g_a) * angle_error(at, l) +
                             fabs(at->ends[k].f_b) * angle_error(at, next)));
    if (!(fabs(residual(s, at, k)) < most)) {
      return false;
    }
  }
  return true;
}

/* From s->now.y.  ret whether s->now is a solution */
static bool newton(struct system *s, size_t most,
                   const struct ph_arena *arena) {
  if (!evaluate(s, &s->now)) {
    return false;
  }
  for (size_t i = 0; i < most && !ph_arena_late(arena); i++) {
    double largest;
    if (s->now.largest < DONE) {
      return true;
    }
    s->iterations++;
    largest = newton_step(s);
    if (!isfinite(largest)) {
      return false;
    }
    if (!descend(s, largest)) {
      return largest < TINY_STEP && is_rounding(s);
    }
  }
  return s->now.largest < DONE;
}

/* ---- continuation ---------------------------------------------------------
 */

/* Unknowns for another h, by the same parts of the turns. */
static void shift(struct system *s, const double *y, double from, double to) {
  for (size_t k = 0; k < s->chain->nodes_n; k++) {
    bool is_log = s->kind[k] == OF_BEFORE || s->kind[k] == OF_AFTER;
    s->now.y[k] = is_log                        ? y[k] + log(to / from)
                  : s->kind[k] == BETWEEN_BENDS ? y[k] * (to / from)
                                                : y[k];
  }
}

/* From nearly straight data; y[nodes] is memory for the last solution. */
static bool continued(struct system *s, double *y,
                      const struct ph_arena *arena) {
  const size_t size = s->chain->nodes_n * sizeof *y;
  double from = 1, reached = 0, step = FIRST_STEP;
  start(s, true);
  memcpy(y, s->now.y, size);
  for (size_t i = 0; i < CONTINUATIONS_MAX && reached < 1; i++) {
    s->h = fmin(1, reached + step);
    shift(s, y, from, s->h);
    if (newton(s, CONTINUED_MAX, arena)) {
      memcpy(y, s->now.y, size);
      from = reached = s->h;
      step *= 1.5;
    } else {
      step /= 2;
      if (step < LAST_STEP || ph_arena_late(arena)) {
        break;
      }
    }
  }
  s->h = 1;
  return reached >= 1;
}

/* ---- all ------------------------------------------------------------------
 */

static bool alloc_state(struct state *at, const struct ph_g2_chain *c,
                        struct ph_arena *arena) {
  double *v = ph_arena_array(arena, c->nodes_n, 4 * sizeof *v);
  at->ends = ph_arena_array(arena, c->n, sizeof *at->ends);
  if (!v || !at->ends) {
    return false;
  }
  at->y = v;
  at->before = v + c->nodes_n;
  at->after = v + 2 * c->nodes_n;
  at->rate = v + 3 * c->nodes_n;
  return true;
}

static bool alloc_system(struct system *s, struct ph_arena *arena) {
  const struct ph_g2_chain *c = s->chain;
  const size_t nodes = c->nodes_n;
  double *v = ph_arena_array(arena, nodes, 4 * sizeof *v);
  s->log_length = ph_arena_array(arena, c->n, sizeof *s->log_length);
  s->kind = ph_arena_array(arena, nodes, sizeof *s->kind);
  s->x = ph_arena_array(arena, nodes, sizeof *s->x);
  if (!v || !s->log_length || !s->kind || !s->x) {
    return false;
  }
  s->turn = v;
  s->scale = v + nodes;
  s->known = v + 2 * nodes;
  s->step = v + 3 * nodes;
  return alloc_state(&s->now, c, arena) && alloc_state(&s->next, c, arena) &&
         ph_tri_alloc(&s->tri, arena, nodes);
}

static bool any_unknown(const struct system *s) {
  for (size_t k = 0; k < s->chain->nodes_n; k++) {
    if (s->kind[k] != KNOWN) {
      return true;
    }
  }
  return false;
}

/* By either start, or by continuation from the second. */
static bool find(struct system *s, struct ph_arena *arena) {
  double *y;
  if (!any_unknown(s)) {
    return evaluate(s, &s->now);
  }
  start(s, false);
  if (newton(s, NEWTON_MAX, arena)) {
    return true;
  }
  start(s, true);
  if (newton(s, NEWTON_MAX, arena)) {
    return true;
  }
  y = ph_arena_array(arena, s->chain->nodes_n, sizeof *y);
  return y && continued(s, y, arena);
}

/*
 * The angle at an end by which the curvature goes on as it does beside it, from
 * the solution with circles: of the first span b[0] times the ratio a[1]/b[1]
 * of the next one, between 1/2 and 2, to the power of the squared ratio of
 * their lengths, at most 1.  (Tested by tests/cli/tc-g2.t: a circle's arcs come
 * out more even.)
 */
static double smooth_angle(const struct ph_g2_chain *c, const struct state *at,
                           size_t end) {
  size_t inner = end == 0 ? 1 : c->n - 1;
  size_t first = end == 0 ? 0 : c->n - 1, second = end == 0 ? 1 : c->n - 2;
  double near = end == 0 ? at->before[inner] : at->after[inner];
  double far = end == 0 ? at->after[inner] : at->before[inner];
  double beyond = end == 0 ? at->before[2] : at->after[c->n - 2];
  double lengths = c->span[first].length / c->span[second].length;
  double power = fmin(1, lengths * lengths);
  return near * pow(fmax(0.5, fmin(far / beyond, 2)), power);
}

/* Once more, with ends that go on smoothly. */
static bool smooth_ends(struct system *s, const struct ph_arena *arena) {
  const struct ph_g2_chain *c = s->chain;
  double smooth[2] = {(double)NAN, (double)NAN};
  for (size_t end = 0; !c->closed && c->n >= 3 && end < 2; end++) {
    size_t first = end == 0 ? 0 : c->n - 1, second = end == 0 ? 1 : c->n - 2;
    if (!c->given[end] && c->span[first].form == PH_G2_ARC &&
        c->span[second].form == PH_G2_ARC) {
      smooth[end] = smooth_angle(c, &s->now, end);
    }
  }
  memcpy(s->smooth, smooth, sizeof smooth);
  return (isnan(smooth[0]) && isnan(smooth[1])) || newton(s, NEWTON_MAX, arena);
}

/* The angles of the chain, from the system of its turns. */
static enum ph_status solve_system(struct system *s, enum ph_g2_rule rule,
                                   struct ph_arena *arena,
                                   struct ph_g2_solution *solution,
                                   struct ph_diag *diag) {
  const struct ph_g2_chain *chain = s->chain;
  begin(s);
  if (!find(s, arena)) {
    return ph_fail(diag, PH_E_NO_CONVERGENCE, "points",
                   "have no curve that was found, by Newton's method and by "
                   "continuation in the turns");
  }
  if (rule == PH_G2_SMOOTH && !smooth_ends(s, arena)) {
    return ph_fail(diag, PH_E_NO_CONVERGENCE, "ends",
                   "is smooth, for which no curve was found");
  }
  for (size_t i = 0; i < chain->n; i++) {
    solution->a[i] = s->now.after[i];
    solution->b[i] = s->now.before[ph_g2_next(chain, i)];
  }
  solution->iterations = s->iterations;
  solution->residual = s->now.largest;
  return PH_OK;
}

enum ph_status ph_g2_solve(const struct ph_g2_chain *chain,
                           enum ph_g2_rule rule, struct ph_arena *arena,
                           struct ph_g2_solution *solution,
                           struct ph_diag *diag) {
  struct system s = {
      .chain = chain, .h = 1, .smooth = {(double)NAN, (double)NAN}};
  struct ph_mark mark;
  enum ph_status status;
  solution->a = ph_arena_array(arena, chain->n, sizeof *solution->a);
  solution->b = ph_arena_array(arena, chain->n, sizeof *solution->b);
  if (!solution->a || !solution->b) {
    return ph_fail_memory(diag);
  }
  mark = ph_arena_mark(arena);
  status = alloc_system(&s, arena)
               ? solve_system(&s, rule, arena, solution, diag)
               : ph_fail_memory(diag);
  ph_arena_release(arena, mark);
  return status;
}
