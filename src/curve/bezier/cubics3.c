/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Curves as cubics in space (see cubics3.h). */
#include "curve/bezier/cubics3.h"

#include "curve/bezier/hermite.h"
#include "curve/kind/kind.h"

/* Of a segment; how often one is halved; room at first. */
enum { PIECES_MAX = 1 << 16, HALVINGS_MAX = 40, ROOM = 64 };

struct piece {
  size_t segment;
  double from, to;
  ph_vec3 c[4];
};

/* A place, and the derivative by u. */
struct end {
  double u;
  ph_vec3 point, first;
};

struct work {
  struct ph_sampler sampler;
  double tolerance, rounding;
  struct ph_arena *arena;
  struct ph_diag *diag;
  struct piece *pieces;
  size_t n, room, before; /* pieces of earlier segments */
  double error;
};

/* At rest there is no direction, nor is one needed. */
static struct end end_at(const struct work *work, double u) {
  const struct ph_sample s = ph_sampler_at(&work->sampler, u);
  struct end end = {u, s.point, {0, 0, 0}};
  double speed;
  (void)ph_sampler_length(&work->sampler, u, &speed);
  if (speed > 0) {
    end.first = ph_vec3_scale(speed, s.tangent);
  }
  return end;
}

static void cubic_of(const struct end *a, const struct end *b, ph_vec3 c[4]) {
  const double third = (b->u - a->u) / 3;
  c[0] = a->point;
  c[1] = ph_vec3_along(a->point, third, a->first);
  c[2] = ph_vec3_along(b->point, -third, b->first);
  c[3] = b->point;
}

/* The greatest distance at places between, or the first one seen that is not
 * within the tolerance. */
static double error_of(const struct work *work, const ph_vec3 c[4], double from,
                       double to) {
  static const double at[] = {0.5, 0.375, 0.625, 0.25, 0.75, 0.125, 0.875};
  double worst = 0;
  for (size_t i = 0; i < sizeof at / sizeof at[0] && worst <= work->tolerance;
       i++) {
    const struct ph_sample s =
        ph_sampler_at(&work->sampler, from + at[i] * (to - from));
    const ph_vec3 away = ph_vec3_sub(ph_hermite_at(c, 3, at[i]), s.point);
    const double error = hypot(hypot(away.x, away.y), away.z);
    worst = error <= worst ? worst : error;
  }
  return worst;
}

static enum ph_status add(struct work *work, const struct end *a,
                          const struct end *b, const ph_vec3 c[4],
                          double error) {
  struct piece *piece;
  work->pieces = ph_arena_grow(work->arena, work->pieces, work->n,
                               sizeof *piece, ROOM, &work->room);
  if (!work->pieces) {
    return ph_fail_memory(work->diag);
  }
  piece = &work->pieces[work->n++];
  piece->segment = work->sampler.k;
  piece->from = a->u;
  piece->to = b->u;
  for (size_t i = 0; i < 4; i++) {
    piece->c[i] = c[i];
  }
  work->error = error > work->error ? error : work->error;
  return PH_OK;
}

/* Finds the pieces from one place to another. */
static enum ph_status visit(struct work *work, const struct end *a,
                            const struct end *b, int depth) {
  ph_vec3 c[4];
  struct end middle;
  enum ph_status status;
  double error;
  cubic_of(a, b, c);
  error = error_of(work, c, a->u, b->u);
  if (error <= work->tolerance) {
    return add(work, a, b, c, error);
  }
  status = depth > 0 ? PH_OK
                     : ph_rounding_allows(work->rounding, work->tolerance,
                                          work->diag);
  if (status != PH_OK) {
    return status;
  }
  if (depth == HALVINGS_MAX || work->n - work->before >= PIECES_MAX ||
      !isfinite(error)) {
    return ph_fail_at(
        work->diag, PH_E_NO_CONVERGENCE, "segments", work->sampler.k,
        "has no Bezier pieces within %.3g of the exact curve", work->tolerance);
  }
  middle = end_at(work, 0.5 * (a->u + b->u));
  status = visit(work, a, &middle, depth + 1);
  return status == PH_OK ? visit(work, &middle, b, depth + 1) : status;
}

/* One segment, from cusp to cusp. */
static enum ph_status segment(struct work *work, size_t k, size_t *cusp,
                              const struct ph_cusps *cusps) {
  enum ph_status status = ph_sampler_enter(&work->sampler, k, work->diag);
  struct end a, b;
  work->before = work->n;
  for (a.u = 0, b.u = 0; status == PH_OK && b.u < 1; a = b) {
    a = b.u > 0 ? a : end_at(work, 0);
    b.u = 1;
    while (cusps && *cusp < cusps->n && cusps->at[*cusp].segment == k &&
           b.u >= 1) {
      const double u = cusps->at[(*cusp)++].u;
      b.u = u > a.u && u < 1 ? u : 1;
    }
    b = end_at(work, b.u);
    status = visit(work, &a, &b, 0);
  }
  return status;
}

static enum ph_status fill(const struct work *work, struct ph_pieces *cubics) {
  cubics->n = work->n;
  cubics->error = work->error;
  cubics->segment = ph_arena_array(work->arena, work->n, sizeof(size_t));
  cubics->interval = ph_arena_array(work->arena, work->n, 2 * sizeof(double));
  cubics->control_points =
      ph_arena_array(work->arena, work->n, 12 * sizeof(double));
  if (!cubics->segment || !cubics->interval || !cubics->control_points) {
    return ph_fail_memory(work->diag);
  }
  for (size_t i = 0; i < work->n; i++) {
    const struct piece *piece = &work->pieces[i];
    cubics->segment[i] = piece->segment;
    cubics->interval[2 * i] = piece->from;
    cubics->interval[2 * i + 1] = piece->to;
    for (size_t j = 0; j < 4; j++) {
      ph_vec3_put(piece->c[j], 3, cubics->control_points + 12 * i + 3 * j);
    }
  }
  return PH_OK;
}

enum ph_status ph_cubics3_of(const struct ph_curve *curve,
                             const struct ph_offset *offset, double tolerance,
                             struct ph_arena *arena, struct ph_pieces *cubics,
                             struct ph_diag *diag) {
  struct work work = {.tolerance = tolerance,
                      .rounding = ph_curve_rounding(curve),
                      .arena = arena,
                      .diag = diag};
  enum ph_status status =
      ph_sampler_begin(&work.sampler, curve, offset, arena, diag);
  size_t cusp = 0;
  *cubics = (struct ph_pieces){.degree = 3, .dimension = 3};
  for (size_t k = 0; status == PH_OK && k < curve->n; k++) {
    status = segment(&work, k, &cusp, offset ? &offset->cusps : NULL);
  }
  return status == PH_OK ? fill(&work, cubics) : status;
}
