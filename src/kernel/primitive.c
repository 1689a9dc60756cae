/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The integral of a smooth function as a table (see primitive.h).
 *
 * On a panel, f is the polynomial through its values at the zeros of T_n,
 * n = PH_PRIMITIVE_NODES, x in [-1,1]:
 *
 *   f(x) = sum_k c_k T_k(x),  c_k = 2/n sum_j f(x_j) cos((2j + 1) k pi / 2n),
 *   x_j = cos((2j + 1) pi / 2n), c_0 half of that                         (1)
 *   integral of f from -1 = sum_k C_k T_k(x),
 *   C_k = (c_{k-1} - c_{k+1}) / 2k  (2 c_0 in C_1),  C_0 = sum (-1)^{k+1} C_k
 *                                                                         (2)
 *
 * Both sums are evaluated by Clenshaw's recurrence, in their even and odd parts
 * by themselves: T_{k+2} = 2 T_2 T_k - T_{k-2}.                           (3)
 */
#include "kernel/primitive.h"

#include "base/sum.h"

#include <float.h>
#include <math.h>

enum {
  NODES = PH_PRIMITIVE_NODES,
  TERMS = PH_PRIMITIVE_TERMS,
  PANELS_MAX = 4096,
  PANELS_LEAST = 8,
  HALVINGS_MAX = 50,
  PASSES_MAX = 4
};

/* What the values are not known better than, and the places. */
static const double ROUNDING = 4 * DBL_EPSILON;

/* Coefficients of less, beside the mean, are rounding of the values. */
static const double NOISE = DBL_EPSILON;

/* Beyond the last node there is less than this part of a panel, in which a kink
 * is seen by nothing but the value at the end. */
static const double BLIND = 0.01;

/* cos(k pi / 32) */
#define C1 0.99518472667219688624
#define C2 0.98078528040323044913
#define C3 0.95694033573220886494
#define C4 0.92387953251128675613
#define C5 0.88192126434835502971
#define C6 0.83146961230254523708
#define C7 0.77301045336273696081
#define C8 0.70710678118654752440
#define C9 0.63439328416364549822
#define C10 0.55557023301960222474
#define C11 0.47139673682599764856
#define C12 0.38268343236508977173
#define C13 0.29028467725446236764
#define C14 0.19509032201612826785
#define C15 0.09801714032956060199

/* T_k(x_j) in row j, and T_k(-x_j) but for the sign of odd k: x_{n-1-j} is
 * -x_j. */
static const double cosines[NODES / 2][NODES] = {
    {1, C1, C2, C3, C4, C5, C6, C7, C8, C9, C10, C11, C12, C13, C14, C15},
    {1, C3, C6, C9, C12, C15, -C14, -C11, -C8, -C5, -C2, -C1, -C4, -C7, -C10,
     -C13},
    {1, C5, C10, C15, -C12, -C7, -C2, -C3, -C8, -C13, C14, C9, C4, C1, C6, C11},
    {1, C7, C14, -C11, -C4, -C3, -C10, C15, C8, C1, C6, C13, -C12, -C5, -C2,
     -C9},
    {1, C9, -C14, -C5, -C4, -C13, C10, C1, C8, -C15, -C6, -C3, -C12, C11, C2,
     C7},
    {1, C11, -C10, -C1, -C12, C9, C2, C13, -C8, -C3, -C14, C7, C4, C15, -C6,
     -C5},
    {1, C13, -C6, -C7, C12, C1, C14, -C5, -C8, C11, C2, C15, -C4, -C9, C10, C3},
    {1, C15, -C2, -C13, C4, C11, -C6, -C9, C8, C7, -C10, -C5, C12, C3, -C14,
     -C1}};

struct task {
  struct ph_primitive *primitive;
  ph_integrand *f;
  const void *context;
  double tolerance;
  double mean; /* the integral of |f| over [0,1], or what is known of it */
  struct ph_arena *arena;
  struct ph_sum before, size; /* integrals of f and |f| so far */
};

/* ---- one panel ----------------------------------------------------------- */

/* The coefficients of f by (1), even ones from f(x) + f(-x) and odd ones from
 * f(x) - f(-x); the mean of |f| on the panel. */
static double interpolate(const struct task *task,
                          struct ph_primitive_panel *panel) {
  const double middle = 0.5 * (panel->from + panel->to);
  const double half = 0.5 * (panel->to - panel->from);
  double *c = panel->value, mean = 0;
  for (size_t k = 0; k < NODES; k++) {
    c[k] = 0;
  }
  for (size_t j = 0; j < NODES / 2; j++) {
    const double *row = cosines[j], step = half * row[1];
    const double f = task->f(task->context, middle + step);
    const double g = task->f(task->context, middle - step);
    mean += (fabs(f) + fabs(g)) / NODES;
    for (size_t k = 0; k < NODES; k += 2) {
      c[k] += (f + g) * row[k];
      c[k + 1] += (f - g) * row[k + 1];
    }
  }
  for (size_t k = 0; k < NODES; k++) {
    c[k] *= k > 0 ? 2. / NODES : 1. / NODES;
  }
  return mean;
}

/* What the values at the ends say of f beyond the nodes.  An end where f is not
 * finite is left alone. */
static double miss_at_ends(const struct ph_primitive_panel *panel,
                           const double end[2]) {
  const double *c = panel->value;
  double even = 0, odd = 0, left, right;
  for (size_t k = 0; k < NODES; k += 2) {
    even += c[k];
    odd += c[k + 1];
  }
  left = fabs(even - odd - end[0]);
  right = fabs(even + odd - end[1]);
  return BLIND *
         ((isfinite(end[0]) ? left : 0) + (isfinite(end[1]) ? right : 0));
}

/* The last coefficients that are no more than the rounding of the values are
 * nothing else, and left out. */
static void shorten(struct ph_primitive_panel *panel, double mean) {
  size_t n = NODES;
  while (n > 2 && fabs(panel->value[n - 1]) <= NOISE * mean &&
         fabs(panel->value[n - 2]) <= NOISE * mean) {
    panel->value[n - 1] = panel->value[n - 2] = 0;
    n -= 2;
  }
  panel->terms = n;
}

/* The coefficients of the integral by (2); the integral over the panel. */
static double integrate(struct ph_primitive_panel *panel) {
  const double half = 0.5 * (panel->to - panel->from), *c = panel->value;
  double whole = 0;
  panel->sum[0] = 0;
  for (size_t k = 1; k <= NODES; k++) {
    double below = k > 1 ? c[k - 1] : 2 * c[0];
    double above = k + 1 < NODES ? c[k + 1] : 0;
    panel->sum[k] = half * (below - above) / (2 * (double)k);
    panel->sum[0] += k % 2 ? panel->sum[k] : -panel->sum[k];
    whole += k % 2 ? 2 * panel->sum[k] : 0;
  }
  return whole;
}

static enum ph_status
keep(struct task *task, const struct ph_primitive_panel *panel, double mean) {
  struct ph_primitive *p = task->primitive;
  struct ph_primitive_panel *grown;
  if (p->n == PANELS_MAX) {
    return PH_E_NO_CONVERGENCE;
  }
  grown = ph_arena_grow(task->arena, p->panels, p->n, sizeof *grown,
                        PANELS_LEAST, &p->room);
  if (!grown) {
    return PH_E_NO_MEMORY;
  }
  p->panels = grown;
  grown[p->n] = *panel;
  grown[p->n].before = ph_sum_value(&task->before);
  shorten(&grown[p->n], mean);
  ph_sum_add(&task->before, integrate(&grown[p->n]));
  ph_sum_add(&task->size, mean * (panel->to - panel->from));
  p->n++;
  return PH_OK;
}

/* By how much values are off as their places are rounded: a panel that is short
 * beside its distance from 0 may have a steep f. */
static double misplaced(const struct ph_primitive_panel *panel) {
  double change = 0;
  for (size_t k = 1; k < NODES; k++) {
    change += fabs(panel->value[k]);
  }
  return ROUNDING * panel->to / (panel->to - panel->from) * change;
}

static double value_at(const struct task *task, double u) {
  return task->f(task->context, u);
}

/* Tabulates [from,to], halved as often as needed, from f at its ends on. */
static enum ph_status tabulate(struct task *task, double from, double to,
                               const double end[2], int depth) {
  struct ph_primitive_panel panel = {.from = from, .to = to};
  const double middle = 0.5 * (from + to), width = to - from;
  const double mean = interpolate(task, &panel), *c = panel.value;
  const double tail =
      fmax(fabs(c[NODES - 2]) + fabs(c[NODES - 1]), miss_at_ends(&panel, end));
  double left[2] = {end[0]}, right[2] = {0, end[1]};
  enum ph_status status;
  if (!isfinite(mean)) {
    return PH_E_NO_CONVERGENCE;
  }
  task->mean = fmax(task->mean, mean * width);
  /* known well enough here, or of no matter for the whole */
  if (tail <= (task->tolerance + ROUNDING) * fmax(mean, task->mean) ||
      tail <= misplaced(&panel) ||
      tail * width <= task->tolerance / 64 * task->mean ||
      depth == HALVINGS_MAX) {
    return keep(task, &panel, mean);
  }
  left[1] = right[0] = value_at(task, middle);
  status = tabulate(task, from, middle, left, depth + 1);
  return status == PH_OK ? tabulate(task, middle, to, right, depth + 1)
                         : status;
}

/* ---- the table ----------------------------------------------------------- */

/* One pass over [0,1]; at a break f may jump.  The mean is known after it: if
 * it was thought to be larger, by values at a few places, the table is not as
 * good as it must be. */
static enum ph_status pass(struct task *task, const double *breaks,
                           size_t breaks_n) {
  const struct ph_sum none = {0, 0};
  enum ph_status status = PH_OK;
  double from = 0, end[2];
  task->primitive->n = 0;
  task->before = task->size = none;
  for (size_t i = 0; status == PH_OK && i <= breaks_n; i++) {
    double to = i < breaks_n ? breaks[i] : 1;
    if (to > from) {
      end[0] = value_at(task, from > 0 ? nextafter(from, to) : from);
      end[1] = value_at(task, to < 1 ? nextafter(to, from) : to);
      status = tabulate(task, from, to, end, 0);
      from = to;
    }
  }
  return status;
}

/* The mean of |f|, about: a short first part, where f is small, is not asked to
 * be as good as if it were all. */
static double mean_of(const struct task *task, const double *breaks,
                      size_t breaks_n) {
  struct ph_primitive_panel panel = {.to = 0};
  double mean = 0;
  for (size_t i = 0; i <= breaks_n && breaks_n > 0; i++) {
    panel.from = panel.to;
    panel.to = i < breaks_n ? breaks[i] : 1;
    mean += (panel.to - panel.from) * interpolate(task, &panel);
  }
  return isfinite(mean) ? mean : 0;
}

enum ph_status ph_primitive_make(struct ph_primitive *primitive,
                                 ph_integrand *f, const void *context,
                                 const double *breaks, size_t breaks_n,
                                 double tolerance, struct ph_arena *arena) {
  struct task task = {.primitive = primitive,
                      .f = f,
                      .context = context,
                      .tolerance = tolerance,
                      .arena = arena};
  enum ph_status status;
  double mean;
  int passes = 0;
  task.mean = mean_of(&task, breaks, breaks_n);
  do {
    status = pass(&task, breaks, breaks_n);
    mean = task.mean;
    task.mean = ph_sum_value(&task.size);
    passes++;
  } while (status == PH_OK && task.mean < mean / 2 && passes < PASSES_MAX);
  primitive->total = ph_sum_value(&task.before);
  return status;
}

/* The panel that u is in. */
static const struct ph_primitive_panel *
panel_of(const struct ph_primitive *primitive, double u) {
  size_t low = 0, high = primitive->n;
  while (high - low > 1) {
    size_t middle = low + (high - low) / 2;
    if (primitive->panels[middle].from <= u) {
      low = middle;
    } else {
      high = middle;
    }
  }
  return &primitive->panels[low];
}

/* The even and the odd part of a sum, which go through the same operations. */
#if defined(__GNUC__)
typedef double pair __attribute__((vector_size(2 * sizeof(double))));

static inline pair pair_of(const double c[2]) {
  return (pair){c[0], c[1]};
}

/* c + t a - b */
static inline pair pair_next(pair c, double t, pair a, pair b) {
  return c + t * a - b;
}

static inline double part(pair a, size_t i) {
  return a[i];
}
#else
typedef struct {
  double v[2];
} pair;

static inline pair pair_of(const double c[2]) {
  return (pair){{c[0], c[1]}};
}

static inline pair pair_next(pair c, double t, pair a, pair b) {
  return (pair){{c.v[0] + t * a.v[0] - b.v[0], c.v[1] + t * a.v[1] - b.v[1]}};
}

static inline double part(pair a, size_t i) {
  return a.v[i];
}
#endif

/* sum_k c[k] T_k(x), k < n, by (3), for two c of which the first is longer by
 * a pair; the second one only if it is wanted. */
static void chebyshev(const double *c, const double *also, size_t n, double x,
                      double sum[2]) {
  static const double zero[2] = {0, 0};
  const double twice = 4 * x * x - 2; /* 2 T_2 */
  pair a = pair_of(c + n), before = pair_of(zero);
  pair b = before, b_before = before;
  for (size_t k = n / 2; k-- > 0;) {
    const pair next = pair_next(pair_of(c + 2 * k), twice, a, before);
    before = a;
    a = next;
    if (also) {
      const pair b_next = pair_next(pair_of(also + 2 * k), twice, b, b_before);
      b_before = b;
      b = b_next;
    }
  }
  sum[0] = part(a, 0) - twice / 2 * part(before, 0) +
           x * (part(a, 1) - part(before, 1));
  sum[1] = part(b, 0) - twice / 2 * part(b_before, 0) +
           x * (part(b, 1) - part(b_before, 1));
}

double ph_primitive_at(const struct ph_primitive *primitive, double u,
                       double *value) {
  const struct ph_primitive_panel *p = panel_of(primitive, u);
  const double x = ((u - p->from) + (u - p->to)) / (p->to - p->from);
  double sum[2];
  chebyshev(p->sum, value ? p->value : NULL, p->terms, x, sum);
  if (value) {
    *value = sum[1];
  }
  return !(u > 0) ? 0 : u < 1 ? p->before + sum[0] : primitive->total;
}
