/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Adaptive Gauss quadrature (see adapt_unit.h). */
#include "adapt_unit.h"

#include <float.h>
#include <math.h>

/* Halvings of an interval (then it is at the rounding of x, and too short for a
 * bounded integrand to matter), and intervals in all. */
enum { HALVINGS_MAX = 50, PARTS_MAX = 4096 };
static const double ROUNDING = 16 * DBL_EPSILON;

struct task {
  const struct ph_quad *rule;
  ph_integrand *f;
  const void *context;
  double tolerance, relative;
  int parts;
};

static double over(const struct task *task, double from, double to) {
  const struct ph_quad *rule = task->rule;
  double sum = 0;
  for (size_t i = 0; i < rule->n; i++) {
    double x = from + (to - from) * rule->node[i];
    sum += rule->weight[i] * task->f(task->context, x);
  }
  return (to - from) * sum;
}

/* The integral over an interval, `whole` by one rule, from its halves. */
static double refine(struct task *task, double from, double to, double whole,
                     int depth) {
  double middle = 0.5 * (from + to);
  double left = over(task, from, middle), right = over(task, middle, to);
  double near = task->tolerance * (to - from) +
                task->relative * (fabs(left) + fabs(right));
  if (fabs(left + right - whole) <= near || depth == HALVINGS_MAX) {
    return left + right;
  }
  if (++task->parts > PARTS_MAX || !isfinite(left + right)) {
    return (double)NAN;
  }
  left = refine(task, from, middle, left, depth + 1);
  return isnan(left) ? left : left + refine(task, middle, to, right, depth + 1);
}

double unit_adapt(const struct ph_quad *rule, ph_integrand *f,
                  const void *context, double from, double to, double tolerance,
                  double relative) {
  struct task task = {rule, f, context, tolerance, relative + ROUNDING, 0};
  return refine(&task, from, to, over(&task, from, to), 0);
}
