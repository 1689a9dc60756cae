/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Curves as B-splines (see nurbs.h): Bezier pieces, joined. */
#include "curve/bezier/nurbs.h"

#include "curve/bezier/cubics3.h"
#include "curve/bezier/hermite.h"
#include "curve/kind/kind.h"

#include <float.h>
#include <string.h>

/* The range of weights of a chain, beyond which another one begins. */
static const double WEIGHT_MOST = 0x1p200;

/* Bezier pieces in order, and at which knots they meet. */
struct row {
  size_t n, degree, dimension;
  const double *points;  /* [n][degree + 1][dimension] */
  bool joined;           /* where two meet, one of these (struct ph_curve) */
  const double *weights; /* [n][degree + 1]; NULL: polynomials */
  double *knots;         /* [n + 1] */
  const bool *begins;    /* [n] whether a chain begins with the piece */
  bool closed;           /* the last piece meets the first one */
  double error;
};

static const double *points_of(const struct row *row, size_t i) {
  return row->points + (row->degree + !row->joined) * row->dimension * i;
}

static const double *weights_of(const struct row *row, size_t i) {
  return row->weights + (row->degree + 1) * i;
}

/* By what the weights of piece i are multiplied: `last` is the last one of the
 * piece before, 0 if there is none.  ret NaN: it is out of range */
static double factor_of(const struct row *row, size_t i, double last) {
  const double *w = weights_of(row, i);
  const double factor = (last > 0 ? last : 1) / w[0];
  bool kept = true;
  for (size_t j = 0; j <= row->degree; j++) {
    const double x = factor * w[j];
    kept = kept && x <= WEIGHT_MOST && x >= 1 / WEIGHT_MOST;
  }
  return kept ? factor : (double)NAN;
}

/* The end of the chain that begins with piece `from`; with weights, these. */
static size_t end_of(const struct row *row, size_t from, double *weights) {
  const size_t degree = row->degree;
  double last = 0;
  size_t i = from;
  for (; i < row->n && (i == from || !row->begins || !row->begins[i]); i++) {
    double factor = 1;
    if (row->weights) {
      factor = factor_of(row, i, last);
      if (isnan(factor) && i > from) {
        break;
      }
      for (size_t j = 0; weights && j <= degree; j++) {
        weights[(i - from) * degree + j] = factor * weights_of(row, i)[j];
      }
      last = factor * weights_of(row, i)[degree];
    }
  }
  return i;
}

static enum ph_status make(const struct row *row, size_t from, size_t to,
                           struct ph_arena *arena, struct ph_spline *chain,
                           struct ph_diag *diag) {
  const size_t degree = row->degree, d = row->dimension;
  const size_t n = (to - from) * degree + 1;
  double *knot;
  *chain = (struct ph_spline){
      .closed = row->closed && from == 0 && to == row->n,
      .degree = degree,
      .knots = ph_arena_array(arena, n + degree + 1, sizeof(double)),
      .knots_n = n + degree + 1,
      .control_points = ph_arena_array(arena, n, d * sizeof(double)),
      .n = n,
      .error = row->error};
  if (row->weights) {
    chain->weights = ph_arena_array(arena, n, sizeof(double));
    chain->weights_n = n;
  }
  if (!chain->knots || !chain->control_points ||
      (row->weights && !chain->weights)) {
    return ph_fail_memory(diag);
  }
  knot = chain->knots;
  *knot++ = row->knots[from];
  for (size_t i = from; i <= to; i++) {
    for (size_t j = 0; j < degree; j++) {
      *knot++ = row->knots[i];
    }
  }
  *knot = row->knots[to];
  for (size_t i = from; i < to; i++) {
    memcpy(chain->control_points + (i - from) * degree * d, points_of(row, i),
           (degree + 1) * d * sizeof(double));
  }
  if (row->weights) {
    end_of(row, from, chain->weights);
  }
  return PH_OK;
}

/* All chains of a row. */
static enum ph_status join(const struct row *row, struct ph_arena *arena,
                           struct ph_splines *chains, struct ph_diag *diag) {
  enum ph_status status = PH_OK;
  size_t n = 0;
  for (size_t from = 0; from < row->n; n++) {
    from = end_of(row, from, NULL);
  }
  chains->v = ph_arena_array(arena, n, sizeof *chains->v);
  chains->n = n;
  if (!chains->v) {
    return ph_fail_memory(diag);
  }
  for (size_t i = 0, from = 0; status == PH_OK && i < n; i++) {
    const size_t to = end_of(row, from, NULL);
    status = make(row, from, to, arena, &chains->v[i], diag);
    from = to;
  }
  return status;
}

/* The knots of pieces of a curve's segments. */
static enum ph_status locate(const struct ph_curve *curve,
                             const size_t *segment, const double *interval,
                             struct ph_arena *arena, struct row *row,
                             struct ph_diag *diag) {
  row->knots = ph_arena_array(arena, row->n + 1, sizeof(double));
  if (!row->knots) {
    return ph_fail_memory(diag);
  }
  for (size_t i = 0; i < row->n; i++) {
    const double *knot = curve->knots + segment[i];
    const double u = interval[2 * i];
    row->knots[i] = u > 0 ? knot[0] + u * (knot[1] - knot[0]) : knot[0];
  }
  row->knots[row->n] = curve->knots[curve->n];
  return ph_knots_increase(row->knots, row->n, segment, diag);
}

/* Chains of an offset begin behind its gaps. */
static enum ph_status cut(const struct ph_offset *offset, const size_t *segment,
                          struct ph_arena *arena, struct row *row,
                          struct ph_diag *diag) {
  const struct ph_gaps *gaps = &offset->gaps;
  bool *begins = ph_arena_array(arena, row->n, sizeof *begins);
  if (!begins) {
    return ph_fail_memory(diag);
  }
  for (size_t i = 0, gap = 0; i < row->n; i++) {
    const bool first = i == 0 || segment[i] != segment[i - 1];
    begins[i] = first && gap < gaps->n && segment[i] == gaps->before[gap];
    gap += begins[i];
  }
  row->closed = row->closed && !(gaps->n > 0 && gaps->before[0] == 0);
  row->begins = begins;
  return PH_OK;
}

static enum ph_status
pieces_of(const struct ph_curve *curve, const struct ph_offset *offset,
          const struct ph_pieces *pieces, struct ph_arena *arena,
          struct ph_splines *chains, struct ph_diag *diag) {
  struct row row = {.n = pieces->n,
                    .degree = pieces->degree,
                    .dimension = pieces->dimension,
                    .points = pieces->control_points,
                    .closed = curve->closed,
                    .error = pieces->error};
  enum ph_status status =
      locate(curve, pieces->segment, pieces->interval, arena, &row, diag);
  if (status == PH_OK && offset) {
    status = cut(offset, pieces->segment, arena, &row, diag);
  }
  return status == PH_OK ? join(&row, arena, chains, diag) : status;
}

enum ph_status ph_nurbs_of(const struct ph_curve *curve,
                           const struct ph_offset *offset, double tolerance,
                           struct ph_arena *arena, struct ph_splines *chains,
                           struct ph_diag *diag) {
  struct row row = {.closed = curve->closed};
  struct ph_curve bezier = {0};
  struct ph_pieces pieces;
  enum ph_status status;
  if (!ph_kind_of(curve)->bezier) {
    status = ph_cubics3_of(curve, offset, tolerance, arena, &pieces, diag);
    return status == PH_OK
               ? pieces_of(curve, offset, &pieces, arena, chains, diag)
               : status;
  }
  if (offset && !offset->control_points) {
    return pieces_of(curve, offset, &offset->pieces, arena, chains, diag);
  }
  if (offset) {
    row.n = offset->n;
    row.degree = offset->degree;
    row.dimension = offset->dimension;
    row.points = offset->control_points;
    row.weights = offset->weights;
    status =
        locate(curve, offset->segment, offset->interval, arena, &row, diag);
    if (status == PH_OK) {
      status = cut(offset, offset->segment, arena, &row, diag);
    }
  } else {
    status =
        ph_bezier_curve(curve, tolerance, arena, &bezier, &row.error, diag);
    row.n = bezier.n;
    row.degree = bezier.degree;
    row.dimension = bezier.dimension;
    row.points = bezier.control_points;
    row.joined = bezier.joined;
    row.knots = bezier.knots;
  }
  return status == PH_OK ? join(&row, arena, chains, diag) : status;
}

/* The arrays of a loop's pieces, one after the other. */
static enum ph_status gather(const struct ph_loop *loop, struct ph_arena *arena,
                             struct row *row, struct ph_diag *diag) {
  const size_t each = row->degree + 1;
  double *points = ph_arena_array(arena, loop->n, 2 * each * sizeof(double));
  double *weights = ph_arena_array(arena, loop->n, each * sizeof(double));
  row->knots = ph_arena_array(arena, loop->n + 1, sizeof(double));
  if (!points || !weights || !row->knots) {
    return ph_fail_memory(diag);
  }
  row->knots[0] = 0;
  for (size_t i = 0; i < loop->n; i++) {
    const struct ph_loop_piece *piece = &loop->pieces[i];
    memcpy(points + 2 * each * i, piece->control_points,
           2 * each * sizeof(double));
    memcpy(weights + each * i, piece->weights, each * sizeof(double));
    row->knots[i + 1] = row->knots[i] + piece->length;
  }
  row->points = points;
  row->weights = weights;
  return PH_OK;
}

enum ph_status ph_nurbs_loops(struct ph_offset *offset, struct ph_arena *arena,
                              struct ph_diag *diag) {
  const double error = offset->loops.trimming.approximation;
  enum ph_status status = PH_OK;
  for (size_t i = 0; status == PH_OK && i < offset->loops.n; i++) {
    struct ph_loop *loop = &offset->loops.v[i];
    struct row row = {.n = loop->n,
                      .degree = offset->degree,
                      .dimension = 2,
                      .closed = loop->closed,
                      .error = error > 0 ? error : 0};
    status = gather(loop, arena, &row, diag);
    if (status == PH_OK) {
      status = join(&row, arena, &loop->nurbs, diag);
    }
  }
  return status;
}
