/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "kernel/bern_low.h"

#include "kernel/bern.h"
#include "kernel/pi.h"

#include <float.h>
#include <math.h>

enum { N = PH_BERN_LOW + 1 };

/* Terms are left away from where they are this part of the largest. */
static const double TAIL = 0x1p-70;

/* Rounding of a part, in eps of the largest coordinate: of values, sqrt(n) and
 * one, times Lebesgue's constant of N nodes, at most 4; of the solution of a
 * totally positive system, which does not grow [HIG02, thm. 9.12], 3 N of it,
 * times that constant. */
static const double ROUNDING_BY_ROOT = 16, ROUNDING = 16 * N;

/* Rounding of two cuts, in eps of the largest coordinate for each degree. */
static const double CUTTING = 4;

/* Ellipses that are tried: half the sum of their axes over half of the width,
 * and by how much each is larger than the one before.  Beyond, 64^LOW, nothing
 * is lost but by rounding. */
static const double ELLIPSE = 2, LARGER = 1.5, LARGEST = 64;

/* ---- values -------------------------------------------------------------- */

/* The points of a form: coefficients, or their differences. */
static ph_cplx point_at(const ph_cplx *c, size_t k, bool slope) {
  return slope ? ph_cplx_sub(c[k + 1], c[k]) : c[k];
}

/* The sum of the terms beside the largest, number k, on one side of it, from
 * there in steps; each over that term's weight. */
static void add_side(const ph_cplx *c, size_t n, size_t k, double u, bool up,
                     bool slope, ph_cplx *sum, double *weights) {
  ph_cplx middle = point_at(c, k, slope);
  double odds = up ? u / (1 - u) : (1 - u) / u, weight = 1;
  for (size_t at = k; up ? at < n : at > 0;) {
    size_t left = up ? n - at : at, taken = up ? at + 1 : n - at + 1;
    weight *= (double)left / (double)taken * odds;
    if (!(weight > TAIL)) {
      return;
    }
    at = up ? at + 1 : at - 1;
    *weights += weight;
    *sum = ph_cplx_add(
        *sum,
        ph_cplx_scale(weight, ph_cplx_sub(point_at(c, at, slope), middle)));
  }
}

static ph_cplx value_of(const ph_cplx *c, size_t n, double u, bool slope) {
  size_t k = u < 1 ? (size_t)(u * (double)(n + 1)) : n;
  ph_cplx sum = {0, 0};
  double weights = 1;
  k = k < n ? k : n;
  if (u > 0 && u < 1) {
    add_side(c, n, k, u, true, slope, &sum, &weights);
    add_side(c, n, k, u, false, slope, &sum, &weights);
  }
  return ph_cplx_add(point_at(c, k, slope), ph_cplx_scale(1 / weights, sum));
}

ph_cplx ph_bern_value(const ph_cplx *c, size_t degree, double u) {
  return value_of(c, degree, u, false);
}

ph_cplx ph_bern_slope(const ph_cplx *c, size_t degree, double u) {
  return ph_cplx_scale((double)degree, value_of(c, degree - 1, u, true));
}

/* ---- parts --------------------------------------------------------------- */

/* Factors the values of the basis at the nodes; no pivots are needed. */
static void factor(struct ph_bern_low *low) {
  for (size_t i = 0; i < N; i++) {
    low->node[i] = 0.5 - 0.5 * cos(PH_PI * ((double)i + 0.5) / N);
    ph_bern_basis(PH_BERN_LOW, low->node[i], low->lu[i]);
  }
  for (size_t k = 0; k < N; k++) {
    for (size_t i = k + 1; i < N; i++) {
      low->lu[i][k] /= low->lu[k][k];
      for (size_t j = k + 1; j < N; j++) {
        low->lu[i][j] -= low->lu[i][k] * low->lu[k][j];
      }
    }
  }
}

/* The coefficients of values at the nodes, in place. */
static void solve(const struct ph_bern_low *low, ph_cplx *x) {
  for (size_t i = 1; i < N; i++) {
    for (size_t j = 0; j < i; j++) {
      x[i] = ph_cplx_sub(x[i], ph_cplx_scale(low->lu[i][j], x[j]));
    }
  }
  for (size_t i = N; i-- > 0;) {
    for (size_t j = i + 1; j < N; j++) {
      x[i] = ph_cplx_sub(x[i], ph_cplx_scale(low->lu[i][j], x[j]));
    }
    x[i] = ph_cplx_scale(1 / low->lu[i][i], x[i]);
  }
}

/* One more difference of n of them; the largest after it. */
static double difference(ph_cplx *c, size_t n) {
  double largest = 0;
  for (size_t k = 0; k + 1 < n; k++) {
    double d;
    c[k] = ph_cplx_sub(c[k + 1], c[k]);
    d = ph_cplx_abs(c[k]);
    largest = d > largest || isnan(d) ? d : largest;
  }
  return largest;
}

/* What is taken parts of. */
static const ph_cplx *source(const struct ph_bern_low *low, size_t *degree) {
  *degree = low->near_degree > 0 ? low->near_degree : low->degree;
  return low->near_degree > 0 ? low->near : low->c;
}

void ph_bern_low_of(struct ph_bern_low *low, const ph_cplx *c, size_t degree,
                    ph_cplx *room) {
  double size = 0, reach = 0, largest = 0, error = 0, scale = 2;
  const ph_cplx *from;
  size_t n;
  low->c = c;
  low->degree = degree;
  low->near_degree = 0;
  low->away = 0;
  low->rest = (double)INFINITY;
  low->rounding = (double)INFINITY;
  if (degree < PH_BERN_HIGH) {
    return;
  }
  low->near_degree = ph_bern_near(c, degree, room, low->near, &low->away);
  from = source(low, &n);
  for (size_t k = 0; k <= n; k++) {
    double away = ph_cplx_abs(ph_cplx_sub(from[k], from[0]));
    size = fmax(size, ph_cplx_abs(from[k]));
    reach = away > reach || isnan(away) ? away : reach;
    room[k] = from[k];
  }
  low->reach = reach;
  for (size_t step = 0; step < N; step++) {
    largest = difference(room, n + 1 - step);
    error = 2 * error + DBL_EPSILON * largest;
    scale *= (double)(n - step) / (double)(step + 1) / 4;
  }
  low->rest = scale * (largest + error);
  low->rounding =
      (ROUNDING_BY_ROOT * sqrt((double)n) + ROUNDING) * DBL_EPSILON * size;
  low->cutting = CUTTING * (double)n * DBL_EPSILON * size;
  factor(low);
}

/* What is lost by (1), of the best of some ellipses.  They lie in polygons
 * whose corners are at the angles of the nodes. */
static double lost_in_ellipses(const struct ph_bern_low *low, double from,
                               double to) {
  const double middle = from + (to - from) / 2;
  const double unit = (to - from) / 4 / cos(PH_PI / (2 * N));
  double least = (double)INFINITY;
  size_t n;
  source(low, &n);
  for (double rho = ELLIPSE; rho <= LARGEST; rho *= LARGER) {
    double a = unit * (rho + 1 / rho), b = unit * (rho - 1 / rho), far = 1;
    for (size_t i = 0; i < N; i++) {
      double x = middle + a * (2 * low->node[i] - 1);
      double y2 = 4 * b * b * low->node[i] * (1 - low->node[i]);
      far = fmax(far, sqrt(x * x + y2) + sqrt((1 - x) * (1 - x) + y2));
    }
    least = fmin(least, 4 * low->reach * pow(far, (double)n) *
                            pow(rho, -PH_BERN_LOW) / (rho - 1));
  }
  return least;
}

/* The part by values; their differences from the first are what is small. */
static void interpolate(const struct ph_bern_low *low, double from, double to,
                        ph_cplx *part) {
  size_t n;
  const ph_cplx *c = source(low, &n);
  const ph_cplx first = ph_bern_value(c, n, from);
  for (size_t i = 0; i < N; i++) {
    double u = from + low->node[i] * (to - from);
    part[i] = ph_cplx_sub(ph_bern_value(c, n, u), first);
  }
  solve(low, part);
  for (size_t i = 0; i < N; i++) {
    part[i] = ph_cplx_add(part[i], first);
  }
}

/* The part of what stands for the whole. */
static void cut_near(const struct ph_bern_low *low, double from, double to,
                     ph_cplx *part) {
  ph_cplx left[PH_BERN_NEAR + 1], right[PH_BERN_NEAR + 1];
  ph_bern_cut(low->near, low->near_degree, to, left, right);
  ph_bern_cut(left, low->near_degree, to > 0 ? from / to : 0, right, part);
}

size_t ph_bern_low_part(const struct ph_bern_low *low, double from, double to,
                        double allowed, ph_cplx *part, double *lost) {
  double noise = low->rounding + low->away;
  double miss = low->rest * pow(to - from, N) + noise;
  size_t degree = PH_BERN_LOW;
  if (!(miss <= allowed) && noise < allowed) {
    miss = fmin(miss, lost_in_ellipses(low, from, to) + noise);
  }
  if (miss <= allowed) {
    interpolate(low, from, to, part);
  } else if (low->near_degree > 0 && low->away + low->cutting <= allowed) {
    degree = low->near_degree;
    miss = low->away + low->cutting;
    cut_near(low, from, to, part);
  } else {
    return 0;
  }
  /* it begins and ends where the curve does */
  for (size_t i = 0; i < 2; i++) {
    ph_cplx *at = &part[i * degree];
    ph_cplx end = ph_bern_value(low->c, low->degree, i == 0 ? from : to);
    miss += ph_cplx_abs(ph_cplx_sub(end, *at));
    *at = end;
  }
  *lost = miss;
  return miss <= allowed ? degree : 0;
}
