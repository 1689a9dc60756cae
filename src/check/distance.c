/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Cubics against the chain of Bezier curves that they approximate: the claimed
 * distance is no less than any that is found, and within the tolerance.
 *
 * Knots say which part of the chain a cubic stands for.  Both are sampled, and
 * for each sample the nearest point of the other is looked for in the cubics
 * beside it; where that is farther than what was claimed, more closely, and
 * everywhere.  What is found can only be too large by a bad match, and only
 * what is larger than the claim counts; so those are looked at again.
 */
#include "check/checks.h"
#include "check/data.h"

#include "kernel/bern.h"

/* Samples of each cubic, steps to a nearest point, searches everywhere; cells
 * that one looks at, and how often one is halved. */
enum { GRID = 16, STEPS = 12, SEARCHES = 64, CELLS = 4096, DEPTH = 40 };

/* A cell that is shorter than this part of the distance is not halved. */
static const double SHORT = 1e-3;

/* Rounding of points, for each degree too. */
enum { ROUND_POINT = 32, ROUND_DEGREE = 4 };

/* The tolerance is not exceeded by more. */
static const double TOLERANCE = 1e-9;

/* The part of the chain that a cubic stands for. */
struct part {
  size_t first;  /* control point */
  size_t degree; /* of the piece */
  double from, to;
};

struct context {
  struct ph_check *v;
  const struct ph_value *chain;
  const size_t *sizes; /* control points of each piece */
  size_t pieces;
  double *basis;       /* [largest degree + 1] */
  ph_vec3 *chain_p;    /* control points at unit scale */
  struct part *part;   /* [n] */
  ph_vec3 *grid[2];    /* [n][GRID + 1]: of the chain and of the cubics */
  double limit, worst; /* only what is larger counts; the largest found */
  size_t worst_at;
  size_t searches;
  double rounding;
};

/* ---- both curves ------------------------------------------------------------
 */

/* A point of the chain, side 0, or of the cubics, side 1, at u in [0,1] of what
 * belongs to cubic k, with the derivative by u. */
static ph_vec3 point_of(const struct context *x, size_t side, size_t k,
                        double u, ph_vec3 *derivative) {
  const struct ph_curve *c = x->v->curve;
  const struct part *part = &x->part[k];
  size_t n = side == 0 ? part->degree : 3;
  double width = side == 0 ? part->to - part->from : 1;
  double t = side == 0 ? part->from + width * u : u;
  ph_vec3 p[4], sum = {0, 0, 0}, slope = {0, 0, 0};
  const ph_vec3 *control = p;
  if (side == 0) {
    control = x->chain_p + part->first;
  } else {
    for (size_t i = 0; i < 4; i++) {
      p[i] = ph_check_vector(x->v, ph_curve_points(c, k) + 2 * i, 2);
    }
  }
  ph_bern_basis(n, t, x->basis);
  for (size_t i = 0; i <= n; i++) {
    sum = ph_vec3_along(sum, x->basis[i], control[i]);
  }
  ph_bern_basis(n - 1, t, x->basis);
  for (size_t i = 0; i < n; i++) {
    slope = ph_vec3_along(slope, x->basis[i],
                          ph_vec3_sub(control[i + 1], control[i]));
  }
  *derivative = ph_vec3_scale((double)n * width, slope);
  return sum;
}

static ph_vec3 grid_at(const struct context *x, size_t side, size_t k,
                       size_t i) {
  return x->grid[side][(GRID + 1) * k + i];
}

static void set_grid(struct context *x) {
  for (size_t side = 0; side < 2; side++) {
    for (size_t k = 0; k < x->v->curve->n && !ph_arena_late(x->v->scratch);
         k++) {
      for (size_t i = 0; i <= GRID; i++) {
        ph_vec3 slope;
        x->grid[side][(GRID + 1) * k + i] =
            point_of(x, side, k, (double)i / GRID, &slope);
      }
    }
  }
}

/* ---- nearest points ---------------------------------------------------------
 */

/* From u on towards the nearest point, within what belongs to cubic k: a step
 * that does not help is halved. */
static double refine(const struct context *x, size_t side, ph_vec3 p, size_t k,
                     double u) {
  ph_vec3 slope, at = point_of(x, side, k, u, &slope);
  double away = ph_check_apart(p, at), part = 1;
  for (int i = 0; i < STEPS; i++) {
    ph_vec3 there;
    double step = part * ph_vec3_dot(ph_vec3_sub(p, at), slope) /
                  ph_vec3_dot(slope, slope);
    double to = u + step, next;
    to = to > 0 ? ph_check_smaller(to, 1) : 0;
    at = point_of(x, side, k, to, &there);
    next = ph_check_apart(p, at);
    if (next < away) {
      away = next;
      u = to;
      slope = there;
    } else {
      at = point_of(x, side, k, u, &slope);
      part /= 2;
    }
  }
  return away;
}

/* The nearest point among what belongs to cubic k. */
static double nearest_of(const struct context *x, size_t side, ph_vec3 p,
                         size_t k) {
  double away = HUGE_VAL;
  size_t best = 0;
  for (size_t i = 0; i <= GRID; i++) {
    double next = ph_check_apart(p, grid_at(x, side, k, i));
    if (next < away) {
      away = next;
      best = i;
    }
  }
  return away <= x->limit ? away : refine(x, side, p, k, (double)best / GRID);
}

/* The smallest distance to what belongs to the cubics `from' to `to'. */
static double nearest(const struct context *x, size_t side, ph_vec3 p,
                      size_t from, size_t to) {
  double away = HUGE_VAL;
  for (size_t k = from;
       k <= to && !(away <= x->limit) && !ph_arena_late(x->v->scratch); k++) {
    away = ph_check_smaller(away, nearest_of(x, side, p, k));
  }
  return away;
}

/* A place in what belongs to a cubic: its distance, and the speed there. */
struct spot {
  double u, away, speed;
};

static struct spot spot_at(const struct context *x, size_t side, ph_vec3 p,
                           size_t k, double u) {
  ph_vec3 slope, at = point_of(x, side, k, u, &slope);
  struct spot spot = {u, ph_check_apart(p, at), ph_vec3_abs(slope)};
  return spot;
}

/* The largest |r''| by u of what belongs to cubic k. */
static double second_of(const struct context *x, size_t side, size_t k) {
  const struct part *part = &x->part[k];
  size_t n = side == 0 ? part->degree : 3;
  double width = side == 0 ? part->to - part->from : 1, most = 0;
  const double *p = ph_curve_points(x->v->curve, k);
  for (size_t i = 0; i + 2 <= n; i++) {
    ph_vec3 c[3];
    for (size_t j = 0; j < 3; j++) {
      c[j] = side == 0 ? x->chain_p[part->first + i + j]
                       : ph_check_vector(x->v, p + 2 * (i + j), 2);
    }
    c[0] = ph_vec3_along(ph_vec3_add(c[0], c[2]), -2, c[1]);
    most = ph_check_larger(most, ph_vec3_abs(c[0]));
  }
  return (double)(n * (n - 1)) * width * width * most;
}

/* nearest_of, wherever in what belongs to cubic k: the speed of a cell is at
 * most the mean of those at its ends and half the change that r'' makes, so
 * that its length may keep it away.  Others are halved, until they are short.
 */
static double nearest_closely(const struct context *x, size_t side, ph_vec3 p,
                              size_t k) {
  const double second = second_of(x, side, k);
  struct spot stack[GRID + DEPTH + 1], best = {0, HUGE_VAL, 0};
  size_t n = 0;
  for (size_t i = GRID + 1; i-- > 0;) {
    stack[n] = spot_at(x, side, p, k, (double)i / GRID);
    best = stack[n].away < best.away ? stack[n] : best;
    n++;
  }
  for (int seen = 0; n > 1 && seen < CELLS; seen++) { /* from left to right */
    const struct spot a = stack[n - 1], b = stack[n - 2];
    double h = b.u - a.u, length = (a.speed + b.speed + second * h) / 2 * h;
    if (length <= SHORT * best.away || n > GRID + DEPTH ||
        a.away + b.away - length >= 2 * best.away) {
      n--;
      continue;
    }
    stack[n - 1] = spot_at(x, side, p, k, a.u + h / 2);
    best = stack[n - 1].away < best.away ? stack[n - 1] : best;
    stack[n++] = a;
  }
  return refine(x, side, p, k, best.u);
}

static void check_sample(struct context *x, size_t side, size_t k, size_t i) {
  ph_vec3 p = grid_at(x, side, k, i);
  size_t last = x->v->curve->n - 1;
  size_t from = k > 0 ? k - 1 : 0, to = k < last ? k + 1 : last;
  double away = nearest(x, 1 - side, p, from, to);
  if (!(away <= x->worst) && x->searches < SEARCHES) {
    x->searches++;
    for (size_t j = from; j <= to && !(away <= x->limit); j++) {
      away = ph_check_smaller(away, nearest_closely(x, 1 - side, p, j));
    }
    away = ph_check_smaller(away, nearest(x, 1 - side, p, 0, last));
    if (!(away <= x->worst)) {
      x->worst = away;
      x->worst_at = k;
    }
  }
}

/* ---- the chain --------------------------------------------------------------
 */

/* Which part of the chain each cubic stands for; false where knots are those of
 * no such curve. */
static bool set_parts(struct context *x) {
  const struct ph_curve *c = x->v->curve;
  size_t piece = 0, first = 0;
  for (size_t k = 0; k < c->n; k++) {
    double from, to;
    if (piece >= x->pieces) {
      return false;
    }
    from = c->knots[k] - (double)piece;
    to = c->knots[k + 1] - (double)piece;
    if (!(from >= 0 && to <= 1 && from < to)) {
      return false;
    }
    x->part[k] = (struct part){first, x->sizes[piece] - 1, from, to};
    if (to >= 1) {
      first += x->sizes[piece];
      piece++;
    }
  }
  return piece == x->pieces;
}

/* Pieces begin and end where the chain's do. */
static void check_ends(const struct context *x) {
  struct ph_check *v = x->v;
  for (size_t k = 0; k < v->curve->n; k++) {
    for (size_t end = 0; end < 2; end++) {
      bool is_end = end == 0 ? !(x->part[k].from > 0) : x->part[k].to >= 1;
      if (is_end) {
        ph_check_miss(v, PH_CHECK_INTERPOLATION,
                      ph_check_in(k, "control_points"),
                      ph_check_apart(grid_at(x, 0, k, GRID * end),
                                     grid_at(x, 1, k, GRID * end)),
                      v->scale.size, x->rounding, "miss an end of the curve");
      }
    }
  }
}

/* Whether the problem has a curve in the plane. */
static bool is_chain(const struct context *x) {
  bool fits = x->chain->kind == PH_VECTORS || x->chain->kind == PH_POLYLINE;
  fits = fits && x->chain->dimension == 2;
  for (size_t i = 0; fits && i < x->pieces; i++) {
    fits = x->sizes[i] > 1;
  }
  return fits;
}

static bool begin(struct context *x) {
  struct ph_check *v = x->v;
  size_t n = v->curve->n, most = 4;
  double reach = v->scale.rounding;
  for (size_t i = 0; i < x->pieces; i++) {
    most = x->sizes[i] > most ? x->sizes[i] : most;
  }
  x->basis = ph_arena_array(v->scratch, most, sizeof *x->basis);
  x->chain_p = ph_arena_array(v->scratch, x->chain->n, sizeof *x->chain_p);
  x->part = ph_arena_array(v->scratch, n, sizeof *x->part);
  for (size_t side = 0; side < 2; side++) {
    x->grid[side] =
        ph_arena_array(v->scratch, (GRID + 1) * n, sizeof *x->grid[side]);
  }
  if (!x->basis || !x->chain_p || !x->part || !x->grid[0] || !x->grid[1]) {
    return false;
  }
  for (size_t i = 0; i < x->chain->n; i++) {
    x->chain_p[i] = ph_check_vector(v, x->chain->v + 2 * i, 2);
    reach = ph_check_larger(reach, ph_check_reach(v, x->chain_p[i]));
  }
  x->rounding = (ROUND_POINT + ROUND_DEGREE * (double)most) * reach;
  return true;
}

/* ---- what is claimed --------------------------------------------------------
 */

static void check_distance(struct context *x) {
  struct ph_check *v = x->v;
  const struct ph_value *tolerance = ph_check_field(v, PH_F_TOLERANCE);
  const struct ph_check_where where =
      ph_check_of("diagnostics", PH_CHECK_ONE, "distance");
  double claimed =
      ph_check_known(v, PH_D_DISTANCE)
          ? ph_check_scaled(v, v->diagnostics->value[PH_D_DISTANCE])
          : HUGE_VAL;
  double allowed = tolerance
                       ? (1 + TOLERANCE) * ph_check_scaled(v, tolerance->number)
                       : HUGE_VAL;
  x->worst = x->limit = ph_check_smaller(claimed, allowed);
  for (size_t k = 0; k < v->curve->n && !ph_arena_late(v->scratch); k++) {
    for (size_t i = 0; i <= GRID && !ph_arena_late(v->scratch); i++) {
      check_sample(x, 0, k, i);
      check_sample(x, 1, k, i);
    }
  }
  ph_check_done(v, PH_CHECK_DISTANCE);
  if (claimed < HUGE_VAL) {
    ph_check_miss(v, PH_CHECK_DISTANCE, where, x->worst - claimed, x->worst,
                  x->rounding, "is less than one that there is");
  }
  if (tolerance) {
    double larger = claimed < HUGE_VAL ? claimed : 0;
    larger = ph_check_larger(larger, x->worst);
    ph_check_miss(v, PH_CHECK_DISTANCE, where, larger - allowed, larger,
                  x->rounding, "exceeds the tolerance");
  }
}

enum ph_status ph_check_approximation(struct ph_check *v) {
  const struct ph_value *chain = ph_check_field(v, PH_F_CURVE);
  const struct ph_value *pieces = ph_check_field(v, PH_F_PIECES);
  struct context x = {.v = v};
  x.chain = chain ? chain : &v->problem->field[PH_F_POINTS];
  x.sizes = x.chain->kind == PH_POLYLINE ? x.chain->sizes : &x.chain->n;
  x.pieces = x.chain->kind == PH_POLYLINE ? x.chain->sizes_n : 1;
  if (!is_chain(&x) || (pieces && !((double)v->curve->n <= pieces->number))) {
    ph_check_wrong(v, PH_CHECK_SHAPE,
                   ph_check_of("segments", PH_CHECK_ONE, NULL),
                   "are not what the problem wants");
    return PH_OK;
  }
  if (!begin(&x)) {
    return ph_fail_memory(v->diag);
  }
  if (!set_parts(&x)) {
    ph_check_wrong(v, PH_CHECK_SHAPE,
                   ph_check_of("segments", PH_CHECK_ONE, "interval"),
                   "are no parts of the given curve");
    return PH_OK;
  }
  set_grid(&x);
  check_ends(&x);
  check_distance(&x);
  return PH_OK;
}
