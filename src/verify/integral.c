/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Adaptive Gauss quadrature (see integral.h). */
#include "verify/integral.h"

#include "kernel/quad.h"

#include <float.h>
#include <math.h>

enum { N = PH_VERIFY_NODES, HALVINGS_MAX = 50, PARTS_MAX = 4096 };
static const double ROUNDING = 16 * DBL_EPSILON;

/* A kink beyond the nodes takes less than this part of an interval, so that the
 * integral is wrong by no more than that of the step at the end; and what
 * rounding makes of the extrapolated value. */
static const double BLIND = 0.02, EXTRAPOLATED = 64 * DBL_EPSILON;

bool ph_verify_rule_of(struct ph_verify_rule *rule) {
  struct ph_quad quad;
  if (!ph_quad_gauss(&quad, N)) {
    return false;
  }
  for (size_t i = 0; i < N; i++) {
    rule->node[i] = quad.node[i];
    rule->weight[i] = quad.weight[i];
    rule->end[i] = 1;
    for (size_t j = 0; j < N; j++) {
      if (j != i) { /* Lagrange's polynomial at 0 */
        rule->end[i] *= quad.node[j] / (quad.node[j] - quad.node[i]);
      }
    }
  }
  return true;
}

struct task {
  const struct ph_verify_rule *rule;
  ph_verify_integrand *f;
  const void *context;
  double tolerance, relative;
  int parts;
};

/* An interval, with values of f. */
struct part {
  double from, to;
  double end[2];   /* f there, and */
  double guess[2]; /* by the nodes */
  double sum;      /* the integral */
  double size;     /* the largest |f| */
};

/* Fills what follows from from, to and end. */
static void look(const struct task *task, struct part *part) {
  const struct ph_verify_rule *rule = task->rule;
  double h = part->to - part->from, value[N];
  part->sum = part->guess[0] = part->guess[1] = part->size = 0;
  for (size_t i = 0; i < N; i++) {
    value[i] = task->f(task->context, part->from + h * rule->node[i]);
    part->sum += h * rule->weight[i] * value[i];
    part->size = fabs(value[i]) > part->size ? fabs(value[i]) : part->size;
  }
  for (size_t i = 0; i < N; i++) {
    part->guess[0] += rule->end[i] * value[i];
    part->guess[1] += rule->end[N - 1 - i] * value[i];
  }
}

/* Whether the ends are as the nodes say, to what the integral may be off by.
 * An end where f is not finite is left alone. */
static bool is_seen(const struct part *part, double near) {
  double h = fabs(part->to - part->from);
  for (size_t i = 0; i < 2; i++) {
    double step = fabs(part->end[i] - part->guess[i]);
    if (isfinite(part->end[i]) &&
        !(BLIND * h * step <= near + EXTRAPOLATED * h * part->size)) {
      return false;
    }
  }
  return true;
}

static double refine(struct task *task, const struct part *whole, int depth) {
  double middle = 0.5 * (whole->from + whole->to), near, sum;
  double at = task->f(task->context, middle);
  struct part left = {.from = whole->from, .to = middle};
  struct part right = {.from = middle, .to = whole->to};
  left.end[0] = whole->end[0];
  left.end[1] = right.end[0] = at;
  right.end[1] = whole->end[1];
  look(task, &left);
  look(task, &right);
  near = task->tolerance * fabs(whole->to - whole->from) +
         task->relative * (fabs(left.sum) + fabs(right.sum));
  sum = left.sum + right.sum;
  if (depth == HALVINGS_MAX ||
      (fabs(sum - whole->sum) <= near && is_seen(&left, near) &&
       is_seen(&right, near))) {
    return sum;
  }
  if (++task->parts > PARTS_MAX || !isfinite(sum)) {
    return (double)NAN;
  }
  sum = refine(task, &left, depth + 1);
  return isnan(sum) ? sum : sum + refine(task, &right, depth + 1);
}

double ph_verify_integral(const struct ph_verify_rule *rule,
                          ph_verify_integrand *f, const void *context,
                          double from, double to, double tolerance,
                          double relative) {
  struct task task = {rule, f, context, tolerance, relative + ROUNDING, 0};
  struct part whole = {.from = from, .to = to};
  whole.end[0] = f(context, from);
  whole.end[1] = f(context, to);
  look(&task, &whole);
  return refine(&task, &whole, 0);
}
