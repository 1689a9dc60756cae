/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Curves of all kinds as cubic Bezier curves in the plane (see cubics.h), by
 * what a sampler says of them: an arc is given by its places, and is cut into
 * parts until each is near enough to one cubic (curve/bezier/fit.h), or, by its
 * bound of chords, to a straight one: about cusps, and where a curve in space
 * goes along z.
 */
#include "curve/bezier/cubics.h"

#include "curve/bezier/fit.h"
#include "curve/kind/kind.h"
#include "curve/offset/gap.h"
#include "kernel/pow2.h"

/* Of a segment; parts that an arc is cut into, by the sixth root of what its
 * distance is too large by; room at first. */
enum { PIECES_MAX = 1 << 16, DEPTH_MAX = 48, PARTS_MAX = 4, ROOM = 64 };

/* A direction that is less than this part of a tangent is none. */
static const double VERTICAL = 1e-6;

struct piece {
  size_t segment;
  double interval[2];
  ph_cplx c[4];
};

/* At unit scale. */
struct work {
  struct ph_sampler sampler;
  struct ph_arena *arena;
  struct ph_diag *diag;
  struct ph_pow2 grow, shrink;
  double tolerance;
  struct piece *pieces;
  size_t n, room, before; /* pieces of earlier segments */
  bool meets;             /* a piece begins where the one before ends */
  double error;
  double cusps[2]; /* at the ends of what is covered, where the tangent may be
                      that of the other side; or NaN */
};

/* ---- pieces -------------------------------------------------------------- */

static enum ph_status no_convergence(const struct work *work) {
  return ph_fail_at(work->diag, PH_NO_CONVERGENCE, "segments", work->sampler.k,
                    "needs more than %d cubics to be within the tolerance",
                    (int)PIECES_MAX);
}

static enum ph_status add(struct work *work, const double interval[2],
                          const ph_cplx c[4], double error) {
  struct piece *piece;
  work->pieces = ph_arena_grow(work->arena, work->pieces, work->n,
                               sizeof *piece, ROOM, &work->room);
  if (!work->pieces) {
    return ph_fail_memory(work->diag);
  }
  if (work->n - work->before == PIECES_MAX) {
    return no_convergence(work);
  }
  piece = &work->pieces[work->n];
  piece->segment = work->sampler.k;
  for (size_t i = 0; i < 4; i++) {
    piece->c[i] = c[i];
    piece->interval[i % 2] = interval[i % 2];
  }
  if (work->meets) {
    piece->c[0] = piece[-1].c[3];
  }
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
    arc.point[j] = scaled(work->shrink, sample.point.x, sample.point.y);
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
  error = ph_cubics_fit(&arc, work->tolerance, c);
  if (!(error <= work->tolerance)) {
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
  double bend = ph_sampler_bend(&work->sampler, u0, u1);
  double length = ph_sampler_length(&work->sampler, u1, &speed) -
                  ph_sampler_length(&work->sampler, u0, &speed);
  double error = ph_pow2_apply(work->shrink, bend * h * h / 8);
  double half = ph_pow2_apply(work->shrink, length / 2);
  return error <= half ? error : half;
}

static enum ph_status cover(struct work *work, double u0, double u1,
                            int depth) {
  const double interval[2] = {u0, u1};
  ph_cplx c[4];
  double error = fit(work, u0, u1, c), parts;
  enum ph_status status = PH_OK;
  if (error <= work->tolerance) {
    return add(work, interval, c, error);
  }
  parts = ceil(pow(error / work->tolerance, 1. / 6));
  error = straight_error(work, u0, u1);
  if (error <= work->tolerance) {
    c[1] = ph_cplx_between(c[0], c[3], 1. / 3);
    c[2] = ph_cplx_between(c[0], c[3], 2. / 3);
    return add(work, interval, c, error);
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
static enum ph_status cover_segment(struct work *work, size_t *cusp) {
  const struct ph_offset *offset = work->sampler.offset;
  const size_t k = work->sampler.k, n = offset ? offset->cusps.n : 0;
  enum ph_status status = PH_OK;
  double from = 0;
  work->cusps[0] = (double)NAN;
  for (; status == PH_OK && *cusp < n && offset->cusps.at[*cusp].segment == k;
       ++*cusp) {
    double u = offset->cusps.at[*cusp].u;
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
static enum ph_status copy_segment(struct work *work,
                                   const struct ph_curve *curve) {
  const double interval[2] = {0, 1};
  const double *p = ph_curve_points(curve, work->sampler.k);
  ph_cplx c[4];
  for (size_t i = 0; i < 4; i++, p += curve->dimension) {
    c[i] = scaled(work->shrink, p[0], p[1]);
  }
  return add(work, interval, c, 0);
}

/* Out of the work, in the unit of the data. */
static enum ph_status store(const struct work *work, struct ph_pieces *cubics) {
  const size_t n = work->n;
  *cubics = (struct ph_pieces){
      .degree = 3,
      .dimension = 2,
      .n = n,
      .segment = ph_arena_array(work->arena, n, sizeof(size_t)),
      .interval = ph_arena_array(work->arena, 2 * n, sizeof(double)),
      .control_points = ph_arena_array(work->arena, 8 * n, sizeof(double)),
      .error = ph_pow2_apply(work->grow, work->error)};
  if (!cubics->segment || !cubics->interval || !cubics->control_points) {
    return ph_fail_memory(work->diag);
  }
  for (size_t i = 0; i < n; i++) {
    const struct piece *piece = &work->pieces[i];
    double *p = cubics->control_points + 8 * i;
    cubics->segment[i] = piece->segment;
    cubics->interval[2 * i] = piece->interval[0];
    cubics->interval[2 * i + 1] = piece->interval[1];
    for (size_t j = 0; j < 4; j++) {
      p[2 * j] = ph_pow2_apply(work->grow, piece->c[j].re);
      p[2 * j + 1] = ph_pow2_apply(work->grow, piece->c[j].im);
    }
  }
  return PH_OK;
}

/* Of 2, the power at the scale of the control points. */
static int exponent_of(const struct ph_curve *curve) {
  double largest = 0;
  for (size_t i = 0; i < (curve->degree + 1) * curve->dimension * curve->n;
       i++) {
    largest = fmax(largest, fabs(curve->control_points[i]));
  }
  return largest > 0 ? ph_pow2_exponent(largest) : 0;
}

enum ph_status ph_cubics_of(const struct ph_curve *curve,
                            const struct ph_offset *offset, double tolerance,
                            struct ph_arena *arena, struct ph_pieces *cubics,
                            struct ph_diag *diag) {
  const int exponent = exponent_of(curve);
  const bool exact =
      !offset && curve->degree == 3 && ph_kind_of(curve)->bernstein;
  struct work work = {.arena = arena,
                      .diag = diag,
                      .grow = ph_pow2_of(exponent),
                      .shrink = ph_pow2_of(-exponent)};
  size_t cusp = 0, gap = 0;
  enum ph_status status =
      ph_sampler_begin(&work.sampler, curve, offset, arena, diag);
  work.tolerance = ph_pow2_apply(work.shrink, tolerance);
  for (size_t k = 0; status == PH_OK && k < curve->n; k++) {
    work.before = work.n;
    work.meets = !(offset && ph_gaps_pass(&offset->gaps, k, &gap)) && k > 0;
    status = ph_sampler_enter(&work.sampler, k, diag);
    if (status == PH_OK) {
      status = exact ? copy_segment(&work, curve) : cover_segment(&work, &cusp);
    }
  }
  if (status == PH_OK && curve->closed &&
      !(offset && ph_gaps_open(&offset->gaps))) {
    work.pieces[work.n - 1].c[3] = work.pieces[0].c[0];
  }
  return status == PH_OK ? store(&work, cubics) : status;
}
