/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The area inside of a curve (see enclosed.h). */
#include "curve/fair/enclosed.h"

#include "base/sum.h"
#include "base/team.h"
#include "curve/kind/kind.h"
#include "kernel/quad.h"

#include <math.h>

enum { NODES = 20, DEGREE_MAX = 5 };

/* Segments of a part, and parts that are worth another thread, 0.1 ms each. */
enum { PART = 1024, WORTH = 8 };

/* Curves shorter than this are enlarged by 2^UP: their areas may be subnormal,
 * and rounded once then, not with each product. */
static const double SMALL = 1e-100;
enum { UP = 400 };

static double binomial(size_t n, size_t k) {
  double b = 1;
  for (size_t i = 1; i <= k; i++) {
    b = b * (double)(n + 1 - i) / (double)i;
  }
  return b;
}

static double cross(double up, const double *o, const double *p,
                    const double *a, const double *b) {
  const double x = (p[0] - o[0]) * up, y = (p[1] - o[1]) * up;
  return x * ((b[1] - a[1]) * up) - y * ((b[0] - a[0]) * up);
}

/* Of Bezier curves: parts of PART segments each have sums of their own. */
struct beziers {
  const struct ph_curve *curve;
  double weight[DEGREE_MAX + 1][DEGREE_MAX];
  double up; /* what the curve is enlarged by */
  struct ph_sum *part;
};

static bool add_part(void *context, size_t thread, size_t first, size_t end) {
  const struct beziers *b = context;
  const size_t n = b->curve->degree;
  const double *origin = b->curve->control_points;
  struct ph_sum sum = {0, 0};
  (void)thread;
  for (size_t k = first; k < end; k++) {
    const double *p = ph_curve_points(b->curve, k);
    double part = 0;
    for (size_t i = 0; i <= n; i++) {
      for (size_t j = 0; j < n; j++) {
        part += b->weight[i][j] *
                cross(b->up, origin, p + 2 * i, p + 2 * j, p + 2 * j + 2);
      }
    }
    ph_sum_add(&sum, part);
  }
  b->part[first / PART] = sum;
  return true;
}

static enum ph_status add_beziers(const struct ph_curve *curve, double up,
                                  struct ph_arena *arena, struct ph_sum *sum,
                                  struct ph_diag *diag) {
  const size_t n = curve->degree, parts_n = (curve->n + PART - 1) / PART;
  struct beziers b = {.curve = curve, .up = up};
  b.part = ph_arena_array(arena, parts_n, sizeof *b.part);
  if (!b.part) {
    return ph_fail_memory(diag);
  }
  for (size_t i = 0; i <= n; i++) {
    for (size_t j = 0; j < n; j++) {
      b.weight[i][j] =
          binomial(n, i) * binomial(n - 1, j) / binomial(2 * n - 1, i + j) / 4;
    }
  }
  ph_team_share(arena, curve->n, WORTH * PART, PART, add_part, &b);
  for (size_t i = 0; i < parts_n; i++) {
    ph_sum_join(sum, &b.part[i]);
  }
  return PH_OK;
}

static enum ph_status add_others(const struct ph_curve *curve, double up,
                                 struct ph_arena *arena, struct ph_sum *sum,
                                 struct ph_diag *diag) {
  const double *origin = curve->control_points;
  struct ph_sampler sampler;
  struct ph_quad rule;
  enum ph_status status = ph_sampler_begin(&sampler, curve, NULL, arena, diag);
  if (status == PH_OK && !ph_quad_gauss(&rule, NODES)) {
    status = ph_fail_memory(diag);
  }
  for (size_t k = 0; status == PH_OK && k < curve->n; k++) {
    status = ph_sampler_enter(&sampler, k, diag);
    for (size_t i = 0; status == PH_OK && i < rule.n; i++) {
      const struct ph_sample s = ph_sampler_at(&sampler, rule.node[i]);
      double speed;
      (void)ph_sampler_length(&sampler, rule.node[i], &speed);
      ph_sum_add(sum, rule.weight[i] * (speed * up) / 2 *
                          ((s.point.x - origin[0]) * up * s.tangent.y -
                           (s.point.y - origin[1]) * up * s.tangent.x));
    }
  }
  return status;
}

enum ph_status ph_enclosed_area(const struct ph_curve *curve,
                                struct ph_arena *arena, double *area,
                                struct ph_diag *diag) {
  const struct ph_kind *kind = ph_kind_of(curve);
  const bool small = curve->length < SMALL;
  const double up = small ? ldexp(1, UP) : 1;
  struct ph_sum sum = {0, 0};
  enum ph_status status = PH_OK;
  *area = (double)NAN;
  if (!curve->closed || ph_kind_space(kind, curve->dimension) != PH_PLANE) {
    return PH_OK;
  }
  if (kind->bernstein) {
    status = add_beziers(curve, up, arena, &sum, diag);
  } else {
    status = add_others(curve, up, arena, &sum, diag);
  }
  *area = small ? ldexp(ph_sum_value(&sum), -2 * UP) : ph_sum_value(&sum);
  return status;
}
