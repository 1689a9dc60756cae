/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Curves of all kinds as cubic Bezier curves in the plane (see cubics.h), by
 * what a sampler says of them: an arc is given by its places, and is cut into
 * parts until each is near enough to one cubic (fit.h), or, by its bound of
 * chords, to a straight one: about cusps, and where a curve in space goes along
 * z.  Threads cover stretches of it, which are put together in their order.
 */
#include "curve/bezier/cubics.h"

#include "base/team.h"
#include "curve/bezier/fit.h"
#include "curve/kind/kind.h"
#include "curve/offset/gap.h"
#include "kernel/pow2.h"

#include <string.h>

/* Of a segment; parts that an arc is cut into, by the sixth root of what its
 * distance is too large by; pieces that are held together. */
enum { PIECES_MAX = 1 << 16, DEPTH_MAX = 48, PARTS_MAX = 4, ROOM = 64 };

/* Segments that a thread takes at a time. */
enum { STRETCH = 128 };

/* A direction that is less than this part of a tangent is none. */
static const double VERTICAL = 1e-6;

struct piece {
  size_t segment;
  double interval[2];
  ph_cplx c[4];
  bool meets; /* begins where the one before ends */
};

struct pieces {
  struct pieces *next;
  size_t n;
  struct piece piece[ROOM];
};

/* What is covered. */
struct target {
  const struct ph_curve *curve;
  const struct ph_offset *offset; /* or NULL */
  struct ph_pow2 grow, shrink;
  double tolerance;
  double rounding; /* in the unit of the data */
};

/* A stretch of segments of it, by one thread; at unit scale. */
struct work {
  const struct target *target;
  const struct ph_loop *loop; /* whose segments they are; or NULL */
  size_t first, end;          /* segments */
  size_t cusp, gap;           /* of the whole offset, those that are next */
  bool closes;                /* it ends where segment 0 begins */
  struct ph_account account;
  enum ph_status status;
  struct ph_diag diag;
  struct ph_sampler sampler;
  struct pieces *pieces, *last;
  size_t n; /* pieces of the segment */
  bool meets;
  double error;
  double cusps[2]; /* at the ends of what is covered, where the tangent may be
                      that of the other side; or NaN */
};

/* ---- pieces -------------------------------------------------------------- */

static enum ph_status no_convergence(struct work *work) {
  return ph_fail_at(
      &work->diag, PH_E_NO_CONVERGENCE, "segments", work->sampler.k,
      "needs more than %d cubics to be within the tolerance", (int)PIECES_MAX);
}

/* Room for one more, or NULL. */
static struct piece *next_piece(struct work *work) {
  if (!work->last || work->last->n == ROOM) {
    struct pieces *more = ph_arena_array(&work->account.arena, 1, sizeof *more);
    if (!more) {
      return NULL;
    }
    more->next = NULL;
    more->n = 0;
    *(work->last ? &work->last->next : &work->pieces) = more;
    work->last = more;
  }
  return &work->last->piece[work->last->n++];
}

static enum ph_status add(struct work *work, const double interval[2],
                          const ph_cplx c[4], double error) {
  struct piece *piece;
  if (work->n == PIECES_MAX) {
    return no_convergence(work);
  }
  piece = next_piece(work);
  if (!piece) {
    return ph_fail_memory(&work->diag);
  }
  piece->segment = work->sampler.k;
  for (size_t i = 0; i < 4; i++) {
    piece->c[i] = c[i];
    piece->interval[i % 2] = interval[i % 2];
  }
  piece->meets = work->meets;
  work->meets = true;
  work->n++;
  work->error = error <= work->error ? work->error : error;
  return PH_OK;
}

/* ---- arcs ---------------------------------------------------------------- */

static ph_cplx scaled(struct ph_pow2 scale, double x, double y) {
  return ph_cplx_of(ph_pow2_apply(scale, x), ph_pow2_apply(scale, y));
}

/* The arc by its places u[PH_ARC_STEPS + 1]. */
static struct ph_arc arc_of(const struct work *work, const double *u) {
  const size_t last = PH_ARC_STEPS;
  struct ph_arc arc;
  for (size_t j = 0; j <= last; j++) {
    struct ph_sample sample = ph_sampler_at(&work->sampler, u[j]);
    ph_cplx tangent = ph_cplx_of(sample.tangent.x, sample.tangent.y);
    double size = ph_cplx_abs(tangent);
    arc.point[j] = scaled(work->target->shrink, sample.point.x, sample.point.y);
    arc.tangent[j] =
        ph_cplx_scale(size > VERTICAL ? 1 / size : (double)NAN, tangent);
  }
  for (size_t i = 0; i < 2; i++) {
    size_t from = i > 0 ? last - 1 : 0, end = i > 0 ? last : 0;
    ph_cplx step = ph_cplx_sub(arc.point[from + 1], arc.point[from]);
    bool cusp = u[end] >= work->cusps[i] && u[end] <= work->cusps[i];
    if (cusp && ph_cplx_dot(step, arc.tangent[end]) < 0) {
      arc.tangent[end] = ph_cplx_scale(-1, arc.tangent[end]);
    }
  }
  return arc;
}

/* The cubic of an arc and its error, also at places that are even in length. */
static double fit(const struct work *work, double u0, double u1, ph_cplx c[4]) {
  double u[PH_ARC_STEPS + 1], spaced[PH_ARC_STEPS + 1], error, other;
  struct ph_arc arc;
  for (size_t j = 0; j < PH_ARC_STEPS; j++) {
    u[j] = u0 + (u1 - u0) * (double)j / PH_ARC_STEPS;
  }
  u[PH_ARC_STEPS] = u1;
  arc = arc_of(work, u);
  error = ph_cubics_fit(&arc, work->target->tolerance, c);
  if (!(error <= work->target->tolerance)) {
    return error;
  }
  ph_cubics_respace(&arc, u, spaced);
  arc = arc_of(work, spaced);
  other = ph_cubics_distance(&arc, c);
  return other <= error ? error : other;
}

/* How far an arc is from its chord at most: by the bound of chords, and as no
 * point of it is farther from both ends than half its length. */
static double straight_error(const struct work *work, double u0, double u1) {
  double h = u1 - u0, speed;
  double bend = ph_sampler_chord_bound(&work->sampler, u0, u1);
  double length = ph_sampler_length(&work->sampler, u1, &speed) -
                  ph_sampler_length(&work->sampler, u0, &speed);
  double error = ph_pow2_apply(work->target->shrink, bend * h * h / 8);
  double half = ph_pow2_apply(work->target->shrink, length / 2);
  return error <= half ? error : half;
}

static enum ph_status cover(struct work *work, double u0, double u1,
                            int depth) {
  const double interval[2] = {u0, u1};
  ph_cplx c[4];
  double error = fit(work, u0, u1, c), parts;
  enum ph_status status = PH_OK;
  if (error <= work->target->tolerance) {
    return add(work, interval, c, error);
  }
  parts = ceil(pow(error / work->target->tolerance, 1. / 6));
  error = straight_error(work, u0, u1);
  if (error <= work->target->tolerance) {
    c[1] = ph_cplx_between(c[0], c[3], 1. / 3);
    c[2] = ph_cplx_between(c[0], c[3], 2. / 3);
    return add(work, interval, c, error);
  }
  status = depth > 0
               ? PH_OK
               : ph_rounding_allows(
                     work->target->rounding,
                     ph_pow2_apply(work->target->grow, work->target->tolerance),
                     &work->diag);
  if (status != PH_OK) {
    return status;
  }
  if (depth == DEPTH_MAX) {
    return no_convergence(work);
  }
  parts = parts > 2 && parts <= PARTS_MAX ? parts : 2;
  for (double i = 0; i < parts && status == PH_OK; i++) {
    double from = u0 + (u1 - u0) * i / parts;
    double to = i + 1 < parts ? u0 + (u1 - u0) * (i + 1) / parts : u1;
    status = cover(work, from, to, depth + 1);
  }
  return status;
}

/* ---- segments ------------------------------------------------------------ */

/* A segment, cut at the cusps of the offset. */
static enum ph_status cover_segment(struct work *work) {
  const struct ph_offset *offset = work->target->offset;
  const size_t k = work->sampler.k;
  const size_t n = offset && !work->loop ? offset->cusps.n : 0;
  enum ph_status status = PH_OK;
  double from = 0;
  work->cusps[0] = (double)NAN;
  for (; status == PH_OK && work->cusp < n &&
         offset->cusps.at[work->cusp].segment == k;
       work->cusp++) {
    double u = offset->cusps.at[work->cusp].u;
    if (u > from && u < 1) {
      work->cusps[1] = u;
      status = cover(work, from, u, 0);
      work->cusps[0] = from = u;
    }
  }
  work->cusps[1] = (double)NAN;
  return status == PH_OK ? cover(work, from, 1, 0) : status;
}

/* A cubic is itself. */
static enum ph_status copy_segment(struct work *work) {
  const struct ph_curve *curve = work->target->curve;
  const double interval[2] = {0, 1};
  const double *p = ph_curve_points(curve, work->sampler.k);
  ph_cplx c[4];
  for (size_t i = 0; i < 4; i++, p += curve->dimension) {
    c[i] = scaled(work->target->shrink, p[0], p[1]);
  }
  return add(work, interval, c, 0);
}

/* Whether there is a gap before segment k, from one segment to the next. */
static bool passes_gap(struct work *work, size_t k) {
  const struct ph_offset *offset = work->target->offset;
  return offset && !work->loop && ph_gaps_pass(&offset->gaps, k, &work->gap);
}

static enum ph_status cover_all(struct work *work) {
  const struct target *t = work->target;
  const bool exact =
      !t->offset && t->curve->degree == 3 && ph_kind_of(t->curve)->bernstein;
  struct ph_arena *arena = &work->account.arena;
  enum ph_status status =
      work->loop ? ph_sampler_begin_loop(&work->sampler, t->curve, t->offset,
                                         work->loop, arena, &work->diag)
                 : ph_sampler_begin(&work->sampler, t->curve, t->offset, arena,
                                    &work->diag);
  for (size_t k = work->first; status == PH_OK && k < work->end; k++) {
    work->n = 0;
    work->meets = !passes_gap(work, k) && k > 0;
    status = ph_sampler_enter(&work->sampler, k, &work->diag);
    if (status == PH_OK) {
      status = exact ? copy_segment(work) : cover_segment(work);
    }
  }
  return status;
}

/* ---- stretches ----------------------------------------------------------- */

/* All stretches of a curve, of an offset, or of its loops. */
struct stretches {
  struct work *v;
  size_t n;
};

static bool cover_stretch(void *context, size_t thread, size_t first,
                          size_t end) {
  struct work *work = &((struct stretches *)context)->v[first];
  (void)thread, (void)end;
  work->status = cover_all(work);
  return ph_account_done(&work->account) && work->status == PH_OK;
}

/* Those of a loop, or of all where it is NULL, with their cusps and gaps. */
static void add_stretches(struct stretches *all, const struct target *target,
                          const struct ph_loop *loop, bool closed,
                          const struct ph_arena *arena) {
  const struct ph_offset *whole = loop ? NULL : target->offset;
  const size_t n = loop ? loop->n : target->curve->n;
  size_t cusp = 0, gap = 0;
  for (size_t k = 0; k < n; k += STRETCH) {
    struct work *work = &all->v[all->n++];
    const size_t end = n - k < STRETCH ? n : k + STRETCH;
    *work = (struct work){.target = target,
                          .loop = loop,
                          .first = k,
                          .end = end,
                          .cusp = cusp,
                          .gap = gap,
                          .closes = closed && end == n};
    ph_account_begin(&work->account, arena);
    while (whole && cusp < whole->cusps.n &&
           whole->cusps.at[cusp].segment < end) {
      cusp++;
    }
    while (whole && gap < whole->gaps.n && whole->gaps.before[gap] < end) {
      gap++;
    }
  }
}

static enum ph_status begin_stretches(struct stretches *all,
                                      const struct target *target,
                                      struct ph_arena *arena,
                                      struct ph_diag *diag) {
  const struct ph_curve *curve = target->curve;
  const struct ph_offset *offset = target->offset;
  const struct ph_loops *loops =
      offset && offset->loops.mode ? &offset->loops : NULL;
  size_t n = loops ? 0 : curve->n / STRETCH + 1;
  for (size_t i = 0; loops && i < loops->n; i++) {
    n += loops->v[i].n / STRETCH + 1;
  }
  *all = (struct stretches){ph_arena_array(arena, n, sizeof *all->v), 0};
  if (!all->v) {
    return ph_fail_memory(diag);
  }
  for (size_t i = 0; loops && i < loops->n; i++) {
    add_stretches(all, target, &loops->v[i], loops->v[i].closed, arena);
  }
  if (!loops) {
    const bool open = offset && ph_gaps_open(&offset->gaps);
    add_stretches(all, target, NULL, curve->closed && !open, arena);
  }
  return PH_OK;
}

/* Ends them in their order, up to the first that failed. */
static enum ph_status end_stretches(struct stretches *all,
                                    struct ph_diag *diag) {
  for (size_t i = 0; i < all->n; i++) {
    if (!ph_account_end(&all->v[i].account)) {
      return ph_fail_memory(diag);
    }
    if (all->v[i].status != PH_OK) {
      *diag = all->v[i].diag;
      return all->v[i].status;
    }
  }
  return PH_OK;
}

/* ---- what is found ------------------------------------------------------- */

/* In the unit of the data. */
static void put_piece(const struct target *target, const struct piece *piece,
                      struct ph_pieces *cubics) {
  const size_t i = cubics->n++;
  double *p = cubics->control_points + 8 * i;
  cubics->segment[i] = piece->segment;
  cubics->interval[2 * i] = piece->interval[0];
  cubics->interval[2 * i + 1] = piece->interval[1];
  for (size_t j = 0; j < 4; j++) {
    p[2 * j] = ph_pow2_apply(target->grow, piece->c[j].re);
    p[2 * j + 1] = ph_pow2_apply(target->grow, piece->c[j].im);
  }
  if (piece->meets) {
    p[0] = p[-2];
    p[1] = p[-1];
  }
}

static enum ph_status store(const struct stretches *all,
                            const struct target *target, struct ph_arena *arena,
                            struct ph_pieces *cubics, struct ph_diag *diag) {
  size_t n = 0, first = 0;
  double error = 0;
  for (size_t i = 0; i < all->n; i++) {
    const struct work *work = &all->v[i];
    for (const struct pieces *p = work->pieces; p; p = p->next) {
      n += p->n;
    }
    error = fmax(error, work->error);
  }
  *cubics = (struct ph_pieces){
      .degree = 3,
      .dimension = 2,
      .segment = ph_arena_array(arena, n, sizeof(size_t)),
      .interval = ph_arena_array(arena, 2 * n, sizeof(double)),
      .control_points = ph_arena_array(arena, 8 * n, sizeof(double)),
      .error = ph_pow2_apply(target->grow, error)};
  if (!cubics->segment || !cubics->interval || !cubics->control_points) {
    return ph_fail_memory(diag);
  }
  for (size_t i = 0; i < all->n; i++) {
    struct work *work = &all->v[i];
    first = work->first > 0 ? first : cubics->n;
    for (const struct pieces *p = work->pieces; p; p = p->next) {
      for (size_t j = 0; j < p->n; j++) {
        put_piece(target, &p->piece[j], cubics);
      }
    }
    if (work->closes) {
      memcpy(cubics->control_points + 8 * cubics->n - 2,
             cubics->control_points + 8 * first, 2 * sizeof(double));
    }
    ph_arena_free(&work->account.arena);
  }
  return PH_OK;
}

/* Of 2, the power at the scale of the control points. */
static int exponent_of(const struct ph_curve *curve) {
  double largest = 0;
  for (size_t i = 0; i < ph_curve_points_n(curve) * curve->dimension; i++) {
    largest = fmax(largest, fabs(curve->control_points[i]));
  }
  return largest > 0 ? ph_pow2_exponent(largest) : 0;
}

enum ph_status ph_cubics_of(const struct ph_curve *curve,
                            const struct ph_offset *offset, double tolerance,
                            struct ph_arena *arena, struct ph_pieces *cubics,
                            struct ph_diag *diag) {
  const int exponent = exponent_of(curve);
  const struct target target = {
      .curve = curve,
      .offset = offset,
      .grow = ph_pow2_of(exponent),
      .shrink = ph_pow2_of(-exponent),
      .tolerance = ph_pow2_apply(ph_pow2_of(-exponent), tolerance),
      .rounding = ph_curve_rounding(curve)};
  struct stretches all;
  enum ph_status status = begin_stretches(&all, &target, arena, diag);
  if (status == PH_OK) {
    ph_team_share(arena, all.n, 1, 1, cover_stretch, &all);
    status = end_stretches(&all, diag);
  }
  if (status == PH_OK) {
    status = store(&all, &target, arena, cubics, diag);
  }
  for (size_t i = 0; i < all.n; i++) {
    ph_arena_free(&all.v[i].account.arena);
  }
  return status;
}
