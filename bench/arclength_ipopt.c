/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * IPOPT on the problem of [HUA14], for comparison: for each of the data a line
 * "KIND N F ITERATIONS SECONDS", or "-" for F where it does not converge.
 * The better of two: with the phase that all a_j and b_j have in common free,
 * and with Im b_1 fixed instead.
 *
 *   minimise   sum_j |a_j-1 - 2 a_j + a_j+1|^2 + the same of b            (19)
 *   such that  sum_jk g_jk a_j conj(a_k) = 60 (l + dx)                    (17)
 *              sum_jk g_jk b_j conj(b_k) = 60 (l - dx)                    (18)
 *              sum_jk g_jk a_j conj(b_k) = 60 (dy + i dz)                 (15)
 *
 * for the three neighbours j, k of each segment, with exact sparse Jacobian and
 * Hessian.  Unknown 4 j + c is the real or imaginary part c of a_j or b_j.  The
 * start is that of [HUA14, section 4.4].
 */
#include "arclength.h"

#include <IpStdCInterface.h>

static const double GRAM[3][3] = {{6, 13, 1}, {13, 54, 13}, {1, 13, 6}};
static const double BEND[3] = {1, -2, 1};
static const double TOLERANCE = 1e-10;
enum { ITERATIONS_MAX = 500, ROUNDS = 5 };

/* Row q of a segment is the sum of two products of components, with signs: (17)
 * (18), and the two parts of (15). */
static const int PAIR[4][2][2] = {
    {{0, 0}, {1, 1}}, {{2, 2}, {3, 3}}, {{0, 2}, {1, 3}}, {{1, 2}, {0, 3}}};
static const double SIGN[4][2] = {{1, 1}, {1, 1}, {1, 1}, {1, -1}};

struct task {
  const struct bench_arc *data;
  const double *start;
  bool pinned;
  double f;
  int iterations;
  bool solved;
};

/* ---- the problem ------------------------------------------------------ */

static double second(const double *x, size_t i, size_t c) {
  const double *node = x + 4 * i + c;
  return node[0] - 2 * node[4] + node[8];
}

static Bool eval_f(Index n, Number *x, Bool is_new, Number *f,
                   UserDataPtr user) {
  const struct task *task = user;
  (void)n, (void)is_new;
  *f = 0;
  for (size_t i = 0; i < task->data->n; i++) {
    for (size_t c = 0; c < 4; c++) {
      double d = second(x, i, c);
      *f += d * d;
    }
  }
  return TRUE;
}

static Bool eval_gradient(Index n, Number *x, Bool is_new, Number *gradient,
                          UserDataPtr user) {
  const struct task *task = user;
  (void)is_new;
  memset(gradient, 0, (size_t)n * sizeof *gradient);
  for (size_t i = 0; i < task->data->n; i++) {
    for (size_t c = 0; c < 4; c++) {
      double d = 2 * second(x, i, c);
      for (size_t j = 0; j < 3; j++) {
        gradient[4 * (i + j) + c] += BEND[j] * d;
      }
    }
  }
  return TRUE;
}

static double target(const struct bench_arc *data, size_t i, size_t q) {
  const double *p = data->points + 3 * i;
  const double sides[] = {data->lengths[i] + p[3] - p[0],
                          data->lengths[i] - p[3] + p[0], p[4] - p[1],
                          p[5] - p[2]};
  return 0.5 * sides[q];
}

static Bool eval_rows(Index n, Number *x, Bool is_new, Index m, Number *rows,
                      UserDataPtr user) {
  const struct task *task = user;
  (void)n, (void)is_new, (void)m;
  for (size_t i = 0; i < task->data->n; i++) {
    const double *node = x + 4 * i;
    for (size_t q = 0; q < 4; q++) {
      double sum = 0;
      for (size_t t = 0; t < 2; t++) {
        const double *u = node + PAIR[q][t][0], *v = node + PAIR[q][t][1];
        for (size_t j = 0; j < 3; j++) {
          for (size_t k = 0; k < 3; k++) {
            sum += SIGN[q][t] * GRAM[j][k] * u[4 * j] * v[4 * k];
          }
        }
      }
      rows[4 * i + q] = sum / 120 - target(task->data, i, q);
    }
  }
  return TRUE;
}

/* Whether row q depends on component c. */
static bool depends(size_t q, size_t c) {
  return q > 1 || (q == 0) == (c < 2);
}

/* Row q by the 12 unknowns of its segment. */
static void row_gradient(const double *node, size_t q, double g[12]) {
  memset(g, 0, 12 * sizeof *g);
  for (size_t t = 0; t < 2; t++) {
    const int u = PAIR[q][t][0], v = PAIR[q][t][1];
    for (int j = 0; j < 3; j++) {
      for (int k = 0; k < 3; k++) {
        double weight = SIGN[q][t] * GRAM[j][k] / 120;
        g[4 * j + u] += weight * node[4 * k + v];
        g[4 * k + v] += weight * node[4 * j + u];
      }
    }
  }
}

static Bool eval_jacobian(Index n, Number *x, Bool is_new, Index m, Index size,
                          Index *row, Index *column, Number *value,
                          UserDataPtr user) {
  const struct task *task = user;
  size_t at = 0;
  (void)n, (void)is_new, (void)m, (void)size;
  for (size_t i = 0; i < task->data->n; i++) {
    for (size_t q = 0; q < 4; q++) {
      double g[12];
      if (value) {
        row_gradient(x + 4 * i, q, g);
      }
      for (size_t k = 0; k < 12; k++) {
        if (!depends(q, k % 4)) {
          continue;
        }
        if (value) {
          value[at] = g[k];
        } else {
          row[at] = (Index)(4 * i + q);
          column[at] = (Index)(4 * i + k);
        }
        at++;
      }
    }
  }
  return TRUE;
}

/* What the rows of a segment, with multipliers, couple components c and d by.
 */
static double coupling(const double *y, size_t c, size_t d) {
  size_t low = c < d ? c : d, high = c < d ? d : c;
  if (c == d) {
    return 2 * y[c < 2 ? 0 : 1];
  }
  if (low + 2 == high) {
    return y[2];
  }
  return low == 1 && high == 2 ? y[3] : low == 0 && high == 3 ? -y[3] : 0;
}

/* The lower triangle, segment by segment: IPOPT adds up what overlaps. */
static Bool eval_hessian(Index n, Number *x, Bool is_new, Number weight,
                         Index m, Number *y, Bool is_new_y, Index size,
                         Index *row, Index *column, Number *value,
                         UserDataPtr user) {
  const struct task *task = user;
  size_t at = 0;
  (void)n, (void)x, (void)is_new, (void)m, (void)is_new_y, (void)size;
  for (size_t i = 0; i < task->data->n; i++) {
    for (size_t s = 0; s < 12; s++) {
      for (size_t t = 0; t <= s; t++, at++) {
        size_t j = s / 4, k = t / 4, c = s % 4, d = t % 4;
        if (value) {
          double bend = c == d ? 2 * weight * BEND[j] * BEND[k] : 0;
          value[at] = bend + GRAM[j][k] * coupling(y + 4 * i, c, d) / 120;
        } else {
          row[at] = (Index)(4 * i + s);
          column[at] = (Index)(4 * i + t);
        }
      }
    }
  }
  return TRUE;
}

static Bool count(Index mode, Index iteration, Number f, Number primal,
                  Number dual, Number mu, Number norm, Number regularization,
                  Number step_dual, Number step, Index trials,
                  UserDataPtr user) {
  struct task *task = user;
  (void)mode, (void)f, (void)primal, (void)dual, (void)mu, (void)norm;
  (void)regularization, (void)step_dual, (void)step, (void)trials;
  task->iterations = iteration;
  return TRUE;
}

/* ---- a solution ------------------------------------------------------- */

/* The spinor of every chord, with the phase that turns least from the one
 * before it; the nodes beyond the ends by extrapolation. */
static void start(const struct bench_arc *data, double *x) {
  size_t n = data->n;
  double complex a = 0, b = 0;
  for (size_t i = 1; i <= n; i++) {
    const double *p = data->points + 3 * (i - 1);
    double dx = p[3] - p[0], dy = p[4] - p[1], dz = p[5] - p[2];
    double chord = sqrt(dx * dx + dy * dy + dz * dz);
    double ratio = data->lengths[i - 1] / chord, theta = atan2(dz, dy);
    double complex before = a, before_b = b, turn;
    a = sqrt(0.5 * ratio * (chord + dx)) *
        (cos(theta) + (double complex)I * sin(theta));
    b = sqrt(0.5 * ratio * (chord - dx));
    turn = before * conj(a) + before_b * conj(b);
    if (i > 1 && cabs(turn) > 0) {
      a *= turn / cabs(turn);
      b *= turn / cabs(turn);
    }
    x[4 * i] = creal(a);
    x[4 * i + 1] = cimag(a);
    x[4 * i + 2] = creal(b);
    x[4 * i + 3] = cimag(b);
  }
  for (size_t c = 0; c < 4; c++) {
    x[c] = 2 * x[4 + c] - x[8 + c];
    x[4 * (n + 1) + c] = 2 * x[4 * n + c] - x[4 * (n - 1) + c];
  }
}

static void solve(void *user) {
  struct task *task = user;
  size_t n = task->data->n, x_n = 4 * n + 8, rows_n = 4 * n;
  double *x = bench_malloc(3 * x_n + rows_n, sizeof *x);
  double *low = x + x_n, *high = low + x_n, *zero = high + x_n;
  IpoptProblem problem;
  memcpy(x, task->start, x_n * sizeof *x);
  for (size_t i = 0; i < x_n; i++) {
    low[i] = -2e19; /* IPOPT's infinity is 1e19 */
    high[i] = 2e19;
  }
  if (task->pinned) {
    low[7] = high[7] = x[7];
  }
  problem =
      CreateIpoptProblem((Index)x_n, low, high, (Index)rows_n, zero, zero,
                         (Index)(36 * n), (Index)(78 * n), 0, eval_f, eval_rows,
                         eval_gradient, eval_jacobian, eval_hessian);
  if (!problem) {
    bench_die("no IPOPT problem");
  }
  AddIpoptIntOption(problem, "print_level", 0);
  AddIpoptStrOption(problem, "sb", "yes");
  AddIpoptNumOption(problem, "tol", TOLERANCE);
  AddIpoptIntOption(problem, "max_iter", ITERATIONS_MAX);
  SetIntermediateCallback(problem, count);
  task->solved = IpoptSolve(problem, x, NULL, &task->f, NULL, NULL, NULL,
                            task) == Solve_Succeeded;
  FreeIpoptProblem(problem);
  free(x);
}

/* The lower minimum; of the same one, the faster. */
static bool is_better(const struct task *a, double a_seconds,
                      const struct task *b, double b_seconds) {
  if (!a->solved || !b->solved) {
    return a->solved;
  }
  return fabs(a->f - b->f) <= 1e-6 * b->f ? a_seconds < b_seconds : a->f < b->f;
}

static void measure(size_t kind, size_t n) {
  struct bench_arc data = bench_arc_of(kind, n);
  double *x = bench_malloc(4 * n + 8, sizeof *x);
  struct task task[2] = {{&data, x, false, 0, 0, false},
                         {&data, x, true, 0, 0, false}};
  struct bench_contender c[2] = {{solve, &task[0], 0}, {solve, &task[1], 0}};
  size_t k;
  start(&data, x);
  bench_alternate(c, 2, ROUNDS, 1);
  k = is_better(&task[1], c[1].best, &task[0], c[0].best);
  printf("%s %zu ", bench_arc_kinds[kind], n);
  if (task[k].solved) {
    printf("%.9g", task[k].f);
  } else {
    putchar('-');
  }
  printf(" %d %.9g\n", task[k].iterations, c[k].best);
  free(x);
  bench_arc_free(&data);
}

int main(void) {
  for (size_t kind = 0; kind < BENCH_ARC_KINDS; kind++) {
    for (size_t i = 0; i < BENCH_ARC_SIZES; i++) {
      measure(kind, bench_arc_sizes[i]);
    }
  }
  return 0;
}
