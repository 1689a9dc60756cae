/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Adaptive Gauss quadrature (see integral.h). */
#include "check/integral.h"

#include "kernel/quad.h"

#include <float.h>
#include <math.h>

enum { N = PH_CHECK_NODES, HALVINGS_MAX = 50, PARTS_MAX = 2048 };
static const double ROUNDING = 16 * DBL_EPSILON;

/* A kink beyond the nodes takes less than this part of an interval, so that the
 * integral is wrong by no more than that of the step at the end; and what
 * rounding makes of the extrapolated value. */
static const double BLIND = 0.02, EXTRAPOLATED = 64 * DBL_EPSILON;

bool ph_check_rule_of(struct ph_check_rule *rule,
                      const struct ph_arena *arena) {
  struct ph_quad quad;
  rule->arena = arena;
  if (!ph_quad_gauss(&quad, N)) {
    return false;
  }
  for (size_t i = 0; i < N; i++) {
    rule->node[i] = quad.node[i];
    rule->weight[i] = quad.weight[i];
    rule->end[i] = rule->next[i] = 1;
    for (size_t j = 0; j < N; j++) {
      if (j != i) { /* Lagrange's polynomial at 0, and next to it */
        double apart = quad.node[j] - quad.node[i];
        rule->end[i] *= quad.node[j] / apart;
        rule->next[i] *= (quad.node[j] - PH_CHECK_NEXT) / apart;
      }
    }
  }
  return true;
}

struct task {
  const struct ph_check_rule *rule;
  const struct ph_check_integrands *of;
  double near[PH_CHECK_TOGETHER]; /* absolute tolerance, per unit of x */
  bool failed[PH_CHECK_TOGETHER]; /* not finite, or not found */
  double *sum;
  int parts;
};

/* What is known of one function on an interval. */
struct look {
  double end[2];   /* f there, and */
  double guess[2]; /* by the nodes */
  double next[2];  /* what f is next to an end at rest beyond the guess; or 0 */
  double sum;      /* the integral */
  double size;     /* the largest |f| */
};

struct part {
  double from, to;
  struct look of[PH_CHECK_TOGETHER];
};

static void evaluate(const struct task *task, double x, double *value) {
  task->of->f(task->of->context, x, value);
}

static void set_end(const struct task *task, struct part *part, size_t end,
                    const double *value) {
  for (size_t j = 0; j < task->of->n; j++) {
    part->of[j].end[end] = value[j];
  }
}

/* An end at rest has at most this part of the largest value. */
static const double REST = 1e-3;

/* Sets next[] from the guesses that it holds. */
static void look_next(const struct task *task, struct part *part) {
  double h = part->to - part->from;
  for (size_t end = 0; end < 2; end++) {
    double value[PH_CHECK_TOGETHER] = {0};
    bool rest = false;
    for (size_t j = 0; j < task->of->n; j++) {
      const struct look *of = &part->of[j];
      rest = rest || fabs(of->end[end]) <= REST * of->size;
    }
    if (rest) {
      evaluate(task,
               end ? part->to - PH_CHECK_NEXT * h
                   : part->from + PH_CHECK_NEXT * h,
               value);
    }
    for (size_t j = 0; j < task->of->n; j++) {
      struct look *of = &part->of[j];
      of->next[end] = fabs(of->end[end]) <= REST * of->size
                          ? fabs(value[j] - of->next[end])
                          : 0;
    }
  }
}

/* Fills what follows from from, to and end. */
static void look(const struct task *task, struct part *part) {
  const struct ph_check_rule *rule = task->rule;
  double h = part->to - part->from, value[PH_CHECK_TOGETHER];
  for (size_t j = 0; j < task->of->n; j++) {
    struct look *of = &part->of[j];
    of->sum = of->guess[0] = of->guess[1] = of->size = 0;
    of->next[0] = of->next[1] = 0;
  }
  for (size_t i = 0; i < N; i++) {
    evaluate(task, part->from + h * rule->node[i], value);
    for (size_t j = 0; j < task->of->n; j++) {
      struct look *of = &part->of[j];
      double x = fabs(value[j]);
      of->sum += h * rule->weight[i] * value[j];
      of->guess[0] += rule->end[i] * value[j];
      of->guess[1] += rule->end[N - 1 - i] * value[j];
      of->next[0] += rule->next[i] * value[j];
      of->next[1] += rule->next[N - 1 - i] * value[j];
      of->size = x > of->size ? x : of->size;
    }
  }
  look_next(task, part);
}

/* Whether the ends are as the nodes say, to what the integral may be off by.
 * An end where f is not finite is left alone. */
static bool is_seen(const struct look *of, double h, double near) {
  for (size_t i = 0; i < 2; i++) {
    double step = fabs(of->end[i] - of->guess[i]);
    double turn = BLIND / PH_CHECK_NEXT * of->next[i]; /* of the slope */
    if (isfinite(of->end[i]) &&
        !(BLIND * h * fmax(step, turn) <= near + EXTRAPOLATED * h * of->size)) {
      return false;
    }
  }
  return true;
}

/* Part of an uncertainty that its integral, and that of the function, may be
 * off by. */
static const double UNCERTAIN = 0.1;

/* Its integral is known to this part of itself, or it counts for nothing: where
 * it has a peak that no node is on, so may the function. */
static const double KNOWN = 0.01;

/* It is looked for until it is known to this part, where it matters: it may
 * have a peak where the function has none, as of a straight curve that nearly
 * stops. */
static const double ABOUT = 0.5;

/* Whether the halves of an interval agree with the whole, and with its ends. */
static bool is_near(const struct look *whole, const struct look *left,
                    const struct look *right, double h, double near) {
  return fabs(left->sum + right->sum - whole->sum) <= near &&
         is_seen(left, h / 2, near) && is_seen(right, h / 2, near);
}

/* Whether the halves of an interval agree with the whole, for one function. */
static bool is_found(const struct task *task, const struct part *whole,
                     const struct part *left, const struct part *right,
                     size_t j) {
  double h = fabs(whole->to - whole->from);
  double near =
      task->near[j] * h + (task->of->relative + ROUNDING) *
                              (fabs(left->of[j].sum) + fabs(right->of[j].sum));
  bool found = true;
  if (task->of->uncertain) {
    size_t k = task->of->uncertain + j;
    const struct look *w = &whole->of[k], *l = &left->of[k], *r = &right->of[k];
    double error = l->sum + r->sum;
    found = !isfinite(error) || is_near(w, l, r, h, near + ABOUT * error);
    if (isfinite(error) && is_near(w, l, r, h, KNOWN * error)) {
      near += UNCERTAIN * error;
    }
  }
  return found && is_near(&whole->of[j], &left->of[j], &right->of[j], h, near);
}

/* Whether the halves of an interval agree with the whole. */
static bool is_enough(struct task *task, const struct part *whole,
                      const struct part *left, const struct part *right) {
  size_t uncertain = task->of->uncertain;
  bool enough = true;
  for (size_t j = 0; j < (uncertain ? uncertain : task->of->n); j++) {
    task->failed[j] =
        task->failed[j] || !isfinite(left->of[j].sum + right->of[j].sum);
    enough =
        enough && (task->failed[j] || is_found(task, whole, left, right, j));
  }
  return enough;
}

static void refine(struct task *task, const struct part *whole, int depth) {
  double middle = 0.5 * (whole->from + whole->to), at[PH_CHECK_TOGETHER];
  struct part left, right;
  left.from = whole->from;
  left.to = right.from = middle;
  right.to = whole->to;
  evaluate(task, middle, at);
  for (size_t j = 0; j < task->of->n; j++) {
    left.of[j].end[0] = whole->of[j].end[0];
    right.of[j].end[1] = whole->of[j].end[1];
  }
  set_end(task, &left, 1, at);
  set_end(task, &right, 0, at);
  look(task, &left);
  look(task, &right);
  if (depth == HALVINGS_MAX || is_enough(task, whole, &left, &right)) {
    for (size_t j = 0; j < task->of->n; j++) {
      task->sum[j] += left.of[j].sum + right.of[j].sum;
    }
  } else if (++task->parts <= PARTS_MAX && !ph_arena_late(task->rule->arena)) {
    refine(task, &left, depth + 1);
    refine(task, &right, depth + 1);
  }
}

void ph_check_integral(const struct ph_check_rule *rule,
                       const struct ph_check_integrands *of, double from,
                       double to, double *sum) {
  struct task task = {.rule = rule, .of = of, .sum = sum};
  struct part whole = {.from = from, .to = to};
  double at[2][PH_CHECK_TOGETHER], h = fabs(to - from);
  for (size_t j = 0; j < of->n; j++) {
    sum[j] = (double)NAN;
  }
  if (ph_arena_late(rule->arena)) {
    return;
  }
  evaluate(&task, from, at[0]);
  evaluate(&task, to, at[1]);
  set_end(&task, &whole, 0, at[0]);
  set_end(&task, &whole, 1, at[1]);
  look(&task, &whole);
  for (size_t j = 0; j < of->n; j++) {
    double total = fabs(whole.of[j].sum);
    sum[j] = 0;
    task.near[j] = of->tolerance +
                   (h > 0 && isfinite(total) ? of->relative * total / h : 0);
  }
  refine(&task, &whole, 0);
  for (size_t j = 0; j < of->n; j++) {
    if (task.parts > PARTS_MAX || task.failed[j]) {
      sum[j] = (double)NAN;
    }
  }
}
