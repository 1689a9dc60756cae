/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The equations of curvature-continuous splines (see g2_system.h). */
#include "solve/tc/g2_system.h"

#include "kernel/pi.h"

#include <math.h>

/* Where the iteration begins, ln(b/a) is no larger. */
static const double START_MAX = 25;

/* ---- what is unknown ------------------------------------------------------
 */

static const struct ph_g2_span *before(const struct ph_g2_chain *c, size_t k) {
  return &c->span[ph_g2_before(c, k)];
}

static enum ph_g2_kind kind_of(const struct ph_g2_chain *c, size_t k) {
  const struct ph_g2_node *node = &c->node[k];
  enum ph_g2_form left, right;
  if (!node->inner || node->sign == 0) {
    return PH_G2_KNOWN;
  }
  left = before(c, k)->form;
  right = c->span[k].form;
  if (left == PH_G2_LINE || right == PH_G2_LINE) {
    return PH_G2_KNOWN;
  }
  return left == right
             ? (left == PH_G2_ARC ? PH_G2_SHARED : PH_G2_BETWEEN_BENDS)
         : left == PH_G2_ARC ? PH_G2_OF_BEFORE
                             : PH_G2_OF_AFTER;
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

static bool begin_some(void *context, size_t thread, size_t first, size_t end) {
  const struct ph_g2_system *s = context;
  const struct ph_g2_chain *c = s->chain;
  (void)thread;
  for (size_t i = first; i < end && i < c->n; i++) {
    s->log_length[i] = log(c->span[i].length);
  }
  for (size_t k = first; k < end; k++) {
    s->kind[k] = (unsigned char)kind_of(c, k);
  }
  return true;
}

/* The turn in the sense of the node. */
static inline double turn_at(const struct ph_g2_chain *c, size_t k) {
  return c->node[k].sign < 0 ? -c->node[k].turn : c->node[k].turn;
}

/* The angle before a known node. */
static double known_angle(const struct ph_g2_system *s, size_t k) {
  return s->chain->node[k].inner && before(s->chain, k)->form != PH_G2_LINE
             ? turn_at(s->chain, k)
             : 0;
}

void ph_g2_system_begin(struct ph_g2_system *s) {
  ph_g2_share(s->arena, s->chain->nodes_n, begin_some, s);
}

/* A node of a part where it ends, with this angle in the sense of the node. */
static void end_part(struct ph_g2_node *node, double angle) {
  node->inner = false;
  node->turn = node->sign < 0 ? -angle : angle;
}

void ph_g2_system_part(const struct ph_g2_system *s, size_t first, size_t n,
                       struct ph_g2_chain *part) {
  const struct ph_g2_chain *c = s->chain;
  const size_t last = (first + n) % c->nodes_n;
  struct ph_g2_node *node = part->node;
  struct ph_g2_span *span = part->span;
  *part = *c;
  part->closed = false;
  part->n = n;
  part->nodes_n = n + 1;
  part->node = node;
  part->span = span;
  for (size_t k = 0; k <= n; k++) {
    part->node[k] = c->node[(first + k) % c->nodes_n];
  }
  for (size_t i = 0; i < n; i++) {
    part->span[i] = c->span[(first + i) % c->n];
  }
  if (c->node[first].inner) {
    part->given[0] = true;
    end_part(&part->node[0], s->now.after[first]);
  }
  if (c->node[last].inner) {
    part->given[1] = true;
    end_part(&part->node[n], s->now.before[last]);
  }
}

/* ---- starts ---------------------------------------------------------------
 */

/* Angles beside a bend are this part of those of the other side, or this. */
static const double OF_OTHER = 0.2, LEAST = 1e-14;

/* The angle before node k where the iteration begins. */
static double first_angle(const struct ph_g2_system *s, size_t k, bool halves) {
  return s->kind[k] == PH_G2_KNOWN ? known_angle(s, k)
         : halves                  ? turn_at(s->chain, k) / 2
                  : circle_angle(s->chain, k, turn_at(s->chain, k));
}

/* The unknown of node k. */
static double first_unknown(const struct ph_g2_system *s, size_t k,
                            bool halves) {
  const struct ph_g2_chain *c = s->chain;
  const double b = first_angle(s, k, halves), a = turn_at(s->chain, k) - b;
  double beyond = 0;
  if (s->kind[k] == PH_G2_OF_BEFORE) {
    const size_t next = ph_g2_next(c, k);
    beyond = c->node[next].inner ? first_angle(s, next, halves) : 0;
    return log(fmax(fmax(b, OF_OTHER * beyond), LEAST));
  }
  if (s->kind[k] == PH_G2_OF_AFTER) {
    const size_t last = ph_g2_before(c, k);
    beyond = c->node[last].inner
                 ? turn_at(s->chain, last) - first_angle(s, last, halves)
                 : 0;
    return log(fmax(fmax(a, OF_OTHER * beyond), LEAST));
  }
  return s->kind[k] == PH_G2_SHARED
             ? fmax(-START_MAX, fmin(log(b / a), START_MAX))
             : b / turn_around(c, k);
}

struct starting {
  const struct ph_g2_system *s;
  bool halves;
};

static bool start_some(void *context, size_t thread, size_t first, size_t end) {
  const struct starting *t = context;
  (void)thread;
  for (size_t k = first; k < end; k++) {
    const double y =
        t->s->kind[k] == PH_G2_KNOWN ? 0 : first_unknown(t->s, k, t->halves);
    t->s->now.y[k] = isfinite(y) ? y : 0;
  }
  return true;
}

void ph_g2_system_start(struct ph_g2_system *s, bool halves) {
  struct starting t = {s, halves};
  ph_g2_share(s->arena, s->chain->nodes_n, start_some, &t);
}

/* ---- one iterate ----------------------------------------------------------
 */

/* One iterate that is being evaluated. */
struct evaluation {
  const struct ph_g2_system *s;
  atomic_bool refused;
};

static bool set_angles(void *context, size_t thread, size_t first, size_t end) {
  const struct evaluation *evaluation = context;
  const struct ph_g2_system *s = evaluation->s;
  const struct ph_g2_state *at = &s->now;
  (void)thread;
  for (size_t k = first; k < end; k++) {
    double phi = s->h * turn_at(s->chain, k), y = at->y[k], e, b, rate;
    switch (s->kind[k]) {
    case PH_G2_SHARED:
      e = exp(-fabs(y));
      at->before[k] = phi * (y < 0 ? e : 1) / (1 + e);
      at->after[k] = phi * (y < 0 ? 1 : e) / (1 + e);
      at->rate[k] = at->before[k] * (y < 0 ? 1 : e) / (1 + e);
      continue;
    case PH_G2_OF_AFTER:
      at->after[k] = exp(y);
      at->before[k] = phi - at->after[k];
      at->rate[k] = -at->after[k];
      continue;
    case PH_G2_OF_BEFORE:
      b = rate = exp(y);
      break;
    case PH_G2_BETWEEN_BENDS:
      rate = turn_around(s->chain, k);
      b = y * rate;
      break;
    default:
      b = s->h * known_angle(s, k);
      rate = 0;
      break;
    }
    at->before[k] = b;
    at->after[k] = phi - b;
    at->rate[k] = rate;
  }
  return true;
}

/* An end without a tangent: that of the circle, or less where that would not
 * do. */
static double end_rule(double angle, double *slope) {
  double t = tanh(3 * angle / PH_PI);
  *slope = 1 - t * t;
  return PH_PI / 3 * t;
}

/* Whether the rule is for an end: 0 the first, 1 the last. */
static bool has_rule(const struct ph_g2_system *s, size_t end) {
  return !s->chain->closed && !s->chain->given[end] && isnan(s->smooth[end]);
}

/* The angle at an end of open data, in the sense of its span. */
static double end_angle(const struct ph_g2_system *s, size_t end) {
  const struct ph_g2_chain *c = s->chain;
  const struct ph_g2_state *at = &s->now;
  double slope;
  if (c->given[end]) {
    return s->h * turn_at(s->chain, end * c->n);
  }
  if (!isnan(s->smooth[end])) {
    return s->h * s->smooth[end];
  }
  return end_rule(c->n == 1  ? s->h * turn_at(s->chain, 1 - end)
                  : end == 0 ? at->before[1]
                             : at->after[c->n - 1],
                  &slope);
}

/* Residual of node k, known or not. */
double ph_g2_system_residual(const struct ph_g2_system *s, size_t k) {
  const struct ph_g2_ends *ends = s->now.ends;
  return s->kind[k] == PH_G2_KNOWN
             ? 0
             : ends[ph_g2_before(s->chain, k)].g - ends[k].f;
}

static bool set_ends(void *context, size_t thread, size_t first, size_t end) {
  struct evaluation *evaluation = context;
  const struct ph_g2_system *s = evaluation->s;
  const struct ph_g2_chain *c = s->chain;
  const struct ph_g2_state *at = &s->now;
  (void)thread;
  for (size_t i = first; i < end; i++) {
    double a = at->after[i], b = at->before[ph_g2_next(c, i)];
    struct ph_g2_ends *e = &at->ends[i];
    if (c->span[i].form == PH_G2_LINE) {
      continue;
    }
    if (!(c->span[i].form == PH_G2_ARC ? ph_g2_arc(a, b, e)
                                       : ph_g2_bend_ends(a, b, e))) {
      atomic_store(&evaluation->refused, true);
      e->f = e->g = (double)NAN; /* the others are the same for any threads */
    }
    e->f -= s->h * s->log_length[i];
    e->g -= s->h * s->log_length[i];
  }
  return true;
}

static bool add_residuals(void *context, size_t thread, size_t first,
                          size_t end) {
  const struct evaluation *evaluation = context;
  struct ph_g2_sum sum = {0, 0};
  (void)thread;
  for (size_t k = first; k < end; k++) {
    double f = ph_g2_system_residual(evaluation->s, k);
    sum.norm2 += f * f;
    sum.largest = fmax(sum.largest, fabs(f));
  }
  evaluation->s->now.sum[first / PH_G2_PART] = sum;
  return true;
}

bool ph_g2_system_evaluate(struct ph_g2_system *s) {
  const struct ph_g2_chain *c = s->chain;
  const size_t nodes = c->nodes_n;
  struct ph_g2_state *at = &s->now;
  struct evaluation e = {.s = s};
  atomic_init(&e.refused, false);
  ph_g2_share(s->arena, nodes, set_angles, &e);
  if (!c->closed) {
    at->after[0] = end_angle(s, 0);
    at->before[c->n] = end_angle(s, 1);
  }
  ph_g2_share(s->arena, c->n, set_ends, &e);
  if (atomic_load(&e.refused)) {
    return false;
  }
  ph_g2_share(s->arena, nodes, add_residuals, &e);
  at->norm2 = at->largest = 0;
  for (size_t i = 0; i * PH_G2_PART < nodes; i++) {
    at->norm2 += at->sum[i].norm2;
    at->largest = fmax(at->largest, at->sum[i].largest);
  }
  return isfinite(at->norm2);
}

/* ---- Newton's method ------------------------------------------------------
 */

struct ph_tri_row ph_g2_system_row(const struct ph_g2_system *s, size_t k) {
  const struct ph_g2_chain *c = s->chain;
  const struct ph_g2_state *at = &s->now;
  struct ph_tri_row row = {{0, 0}, {1, 0}, {0, 0}, {0, 0}};
  size_t l = ph_g2_before(c, k), next = ph_g2_next(c, k);
  double slope;
  if (s->kind[k] == PH_G2_KNOWN) {
    return row;
  }
  row.f.re = -ph_g2_system_residual(s, k);
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
