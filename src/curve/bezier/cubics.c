/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Curves of all kinds as cubic Bezier curves in the plane (see cubics.h), by
 * what a sampler says of them: an arc is given by its places, and is cut into
 * parts until each is near enough to one cubic, or, by its bound of chords, to
 * a straight one: about cusps, and where a curve in space goes along z.
 *
 * With unit tangents T0 and T3 at the ends, the cubic has the control points
 *   P0, P0 + a T0, P3 - b T3, P3                                         (1)
 * and two free numbers, a and b.  At a place P of the arc with tangent T and
 * normal N, let c(t) be where the cubic meets the normal:
 *   T . (c(t) - P) = 0,  f = N . (c(t) - P)                              (2)
 * |f| is no less than the distance of P from the cubic, and that of c(t) from
 * the arc.  Newton's method makes f = 0 at two places: differentiating (2),
 * with B1 = 3 t (1-t)^2 and T . (B1 T0 + c' dt/da) = 0,
 *   df/da = B1 (N . T0 - N . c' (T . T0) / (T . c'))                    (3)
 * and likewise for b with -B2 T3, B2 = 3 t^2 (1-t).
 *
 * A difference with double zeros at the ends and zeros at x^2 = z of [-1,1] is
 * (1-x^2)^2 (x^2 - z) at first; its extrema are equal for z = 0.106, which is
 * a third and two thirds of the way nearly.
 *
 * Where arc and cubic both go forward along the chord, the feet t increase and
 * every point of the cubic is met by a normal: distances in both directions are
 * at most the greatest |f|.  Derived here; tested by t_cubics.c.
 */
#include "curve/bezier/cubics.h"

#include "curve/kind/kind.h"
#include "curve/offset/gap.h"
#include "kernel/cplx.h"
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
  double rounding; /* in the unit of the data */
  struct piece *pieces;
  size_t n, room, before; /* pieces of earlier segments */
  bool meets;             /* a piece begins where the one before ends */
  double error;
  double cusps[2]; /* at the ends of what is covered, where the tangent may be
                      that of the other side; or NaN */
};

/* An arc, by places in the order of its parameter; near unit scale. */
enum { ARC_STEPS = 12 };

struct arc {
  ph_cplx point[ARC_STEPS + 1];
  ph_cplx tangent[ARC_STEPS + 1]; /* unit, or NaN */
};

enum { LAST = ARC_STEPS, FEET_MAX = 12, NEWTON_MAX = 8 };

/* What is between the places is at most this farther. */
static const double MARGIN = 1.1;

/* The least cosine between what goes forward and the chord. */
static const double FORWARD = 0.05;

/* Handles are at least this part of the arc. */
static const double SHORTEST = 1e-3;

/* ---- a cubic against an arc ---------------------------------------------- */

static ph_cplx along(ph_cplx p, double s, ph_cplx v) {
  return ph_cplx_add(p, ph_cplx_scale(s, v));
}

/* out  c1  the derivative */
static ph_cplx cubic_at(const ph_cplx c[4], double t, ph_cplx *c1) {
  ph_cplx p[3], q[2];
  for (size_t i = 0; i < 3; i++) {
    p[i] = ph_cplx_between(c[i], c[i + 1], t);
  }
  for (size_t i = 0; i < 2; i++) {
    q[i] = ph_cplx_between(p[i], p[i + 1], t);
  }
  *c1 = ph_cplx_scale(3, ph_cplx_sub(q[1], q[0]));
  return ph_cplx_between(q[0], q[1], t);
}

/* Where the cubic meets the normal at a place, by (2). */
struct foot {
  double t, f;
  ph_cplx c1; /* of the cubic */
};

/* A bracket [low,1] is kept, as T . (c - P) goes from minus to plus; f is NaN
 * if it does not. */
static struct foot foot_of(const ph_cplx c[4], ph_cplx p, ph_cplx tangent,
                           double low, double t) {
  struct foot foot = {t, (double)NAN, {0, 0}};
  double high = 1, step = 1;
  ph_cplx gap;
  for (size_t i = 0; i < FEET_MAX && fabs(step) > 1e-9; i++) {
    double ahead, slope, next;
    gap = ph_cplx_sub(cubic_at(c, foot.t, &foot.c1), p);
    ahead = ph_cplx_dot(gap, tangent);
    slope = ph_cplx_dot(foot.c1, tangent);
    *(ahead > 0 ? &high : &low) = foot.t;
    next = foot.t - ahead / slope;
    next = slope > 0 && next > low && next < high ? next : 0.5 * (low + high);
    step = next - foot.t;
    foot.t = next;
  }
  gap = ph_cplx_sub(cubic_at(c, foot.t, &foot.c1), p);
  if (ph_cplx_dot(foot.c1, tangent) > 0) {
    foot.f = ph_cplx_cross(tangent, gap);
  }
  return foot;
}

/* The greatest |f|, infinite where there is none.
 * in  part[]  of the way along the arc, where feet are at first sought */
static double distance_of(const struct arc *arc, const double *part,
                          const ph_cplx c[4]) {
  double greatest = 0, low = 0;
  for (size_t j = 1; j < LAST; j++) {
    struct foot foot = foot_of(c, arc->point[j], arc->tangent[j], low, part[j]);
    if (!(fabs(foot.f) <= greatest)) {
      greatest = fabs(foot.f);
    }
    if (isnan(greatest)) {
      return (double)INFINITY;
    }
    low = foot.t;
  }
  return MARGIN * greatest;
}

/* ---- the fit ------------------------------------------------------------- */

static void cubic_of(const struct arc *arc, double a, double b, ph_cplx c[4]) {
  c[0] = arc->point[0];
  c[1] = along(c[0], a, arc->tangent[0]);
  c[3] = arc->point[LAST];
  c[2] = along(c[3], -b, arc->tangent[LAST]);
}

/* The place that is nearest to a part of the way. */
static size_t nearest(const double *part, double wanted) {
  size_t best = 1;
  for (size_t j = 2; j < LAST; j++) {
    best = fabs(part[j] - wanted) < fabs(part[best] - wanted) ? j : best;
  }
  return best;
}

/* Within a factor of two of x, but no shorter than `least`. */
static double limited(double x, double change, double least) {
  double wanted = x + change;
  wanted = wanted > 2 * x ? 2 * x : wanted < 0.5 * x ? 0.5 * x : wanted;
  return wanted > least ? wanted : least;
}

/* One step towards f = 0 at two places; false: it is not defined. */
static bool improve(const struct arc *arc, const double *part,
                    const ph_cplx c[4], double least, double handle[2]) {
  const size_t at[2] = {nearest(part, 1. / 3), nearest(part, 2. / 3)};
  double row[2][3], det, change[2];
  for (size_t i = 0; i < 2; i++) {
    ph_cplx tangent = arc->tangent[at[i]];
    struct foot foot = foot_of(c, arc->point[at[i]], tangent, 0, part[at[i]]);
    double t = foot.t, basis = 3 * t * (1 - t);
    double lean =
        ph_cplx_cross(tangent, foot.c1) / ph_cplx_dot(tangent, foot.c1);
    const ph_cplx first = arc->tangent[0], last = arc->tangent[LAST];
    row[i][0] =
        basis * (1 - t) *
        (ph_cplx_cross(tangent, first) - lean * ph_cplx_dot(tangent, first));
    row[i][1] =
        -basis * t *
        (ph_cplx_cross(tangent, last) - lean * ph_cplx_dot(tangent, last));
    row[i][2] = -foot.f;
  }
  det = row[0][0] * row[1][1] - row[0][1] * row[1][0];
  change[0] = (row[0][2] * row[1][1] - row[0][1] * row[1][2]) / det;
  change[1] = (row[0][0] * row[1][2] - row[0][2] * row[1][0]) / det;
  if (!isfinite(change[0]) || !isfinite(change[1])) {
    return false;
  }
  handle[0] = limited(handle[0], change[0], least);
  handle[1] = limited(handle[1], change[1], least);
  return true;
}

/* Whether the arc goes forward along its chord; its parts up to each place. */
static bool measure(const struct arc *arc, double *part, double *length) {
  ph_cplx chord = ph_cplx_sub(arc->point[LAST], arc->point[0]);
  double sum = 0, least = FORWARD * ph_cplx_abs(chord);
  bool forward = least > 0;
  for (size_t j = 0; j <= LAST; j++) {
    sum +=
        j > 0 ? ph_cplx_abs(ph_cplx_sub(arc->point[j], arc->point[j - 1])) : 0;
    part[j] = sum;
    forward = forward && ph_cplx_dot(arc->tangent[j], chord) > least;
  }
  for (size_t j = 0; j <= LAST; j++) {
    part[j] /= sum;
  }
  *length = sum;
  return forward;
}

static bool goes_forward(const ph_cplx c[4]) {
  ph_cplx chord = ph_cplx_sub(c[3], c[0]);
  return ph_cplx_dot(ph_cplx_sub(c[2], c[1]), chord) > 0;
}

/* The same distance, of a given cubic with the end points
 * of the arc. */
static double distance_of_cubic(const struct arc *arc, const ph_cplx c[4]) {
  double part[LAST + 1], length;
  return measure(arc, part, &length) ? distance_of(arc, part, c)
                                     : (double)INFINITY;
}

/*
 * Parameters that are equally spaced in the length of an
 * arc, as far as its places tell.
 *
 * in   u[ARC_STEPS + 1]       the parameters of its places
 * out  spaced[ARC_STEPS + 1]  the same first and last; increasing
 */
static void respace(const struct arc *arc, const double *u, double *spaced) {
  double part[LAST + 1], length;
  size_t i = 0;
  (void)measure(arc, part, &length);
  for (size_t j = 0; j <= LAST; j++) {
    double wanted = (double)j / LAST;
    while (i + 1 < LAST && part[i + 1] < wanted) {
      i++;
    }
    spaced[j] =
        u[i] + (u[i + 1] - u[i]) * (wanted - part[i]) / (part[i + 1] - part[i]);
  }
  spaced[0] = u[0];
  spaced[LAST] = u[LAST];
}

/*
 * The cubic with the end points and end tangents of an arc that
 * meets it at a third and two thirds, as the error is then least; the distance
 * is of the sixth order in the length of a regular arc.
 *
 * in   enough  any cubic with at most this distance will do
 * out  c[4]    control points; first and last always
 * ret  the greatest distance at the places of the arc, along its normals, and a
 *      tenth more for what is between them; infinite if the arc turns so much,
 *      or is so uneven, that arc and cubic do not both go forward along the
 *      chord
 */
static double fit_arc(const struct arc *arc, double enough, ph_cplx c[4]) {
  double part[LAST + 1], length, distance, handle[2];
  cubic_of(arc, 0, 0, c);
  if (!measure(arc, part, &length)) {
    return (double)INFINITY;
  }
  handle[0] = handle[1] = length / 3;
  cubic_of(arc, handle[0], handle[1], c);
  distance = distance_of(arc, part, c);
  for (size_t i = 0; i < NEWTON_MAX && !(distance <= enough); i++) {
    const double before[2] = {handle[0], handle[1]};
    if (!improve(arc, part, c, SHORTEST * length, handle)) {
      return (double)INFINITY;
    }
    cubic_of(arc, handle[0], handle[1], c);
    distance = distance_of(arc, part, c);
    if (fabs(handle[0] - before[0]) + fabs(handle[1] - before[1]) <=
        1e-6 * length) {
      break;
    }
  }
  return goes_forward(c) ? distance : (double)INFINITY;
}

/* ---- pieces -------------------------------------------------------------- */

static enum ph_status no_convergence(const struct work *work) {
  return ph_fail_at(
      work->diag, PH_E_NO_CONVERGENCE, "segments", work->sampler.k,
      "needs more than %d cubics to be within the tolerance", (int)PIECES_MAX);
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

/* The arc by its places u[ARC_STEPS + 1]. */
static struct arc arc_of(const struct work *work, const double *u) {
  const size_t last = ARC_STEPS;
  struct arc arc;
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
  double u[ARC_STEPS + 1], spaced[ARC_STEPS + 1], error, other;
  struct arc arc;
  for (size_t j = 0; j < ARC_STEPS; j++) {
    u[j] = u0 + (u1 - u0) * (double)j / ARC_STEPS;
  }
  u[ARC_STEPS] = u1;
  arc = arc_of(work, u);
  error = fit_arc(&arc, work->tolerance, c);
  if (!(error <= work->tolerance)) {
    return error;
  }
  respace(&arc, u, spaced);
  arc = arc_of(work, spaced);
  other = distance_of_cubic(&arc, c);
  return other <= error ? error : other;
}

/* How far an arc is from its chord at most: by the bound of chords, and as no
 * point of it is farther from both ends than half its length. */
static double straight_error(const struct work *work, double u0, double u1) {
  double h = u1 - u0, speed;
  double bend = ph_sampler_chord_bound(&work->sampler, u0, u1);
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
  status = depth > 0
               ? PH_OK
               : ph_rounding_allows(work->rounding,
                                    ph_pow2_apply(work->grow, work->tolerance),
                                    work->diag);
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
static enum ph_status cover_segment(struct work *work, size_t *cusp) {
  const struct ph_offset *offset = work->sampler.offset;
  const size_t k = work->sampler.k;
  const size_t n = offset && !work->sampler.loop ? offset->cusps.n : 0;
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

/* A curve, an offset, or a loop of it. */
static enum ph_status cover_path(struct work *work, const struct ph_offset *gap,
                                 bool closed) {
  const struct ph_curve *curve = work->sampler.curve;
  const bool exact = !work->sampler.offset && curve->degree == 3 &&
                     ph_kind_of(curve)->bernstein;
  const size_t first = work->n;
  size_t cusp = 0, next = 0;
  enum ph_status status = PH_OK;
  for (size_t k = 0; status == PH_OK && k < work->sampler.n; k++) {
    work->before = work->n;
    work->meets = !(gap && ph_gaps_pass(&gap->gaps, k, &next)) && k > 0;
    status = ph_sampler_enter(&work->sampler, k, work->diag);
    if (status == PH_OK) {
      status = exact ? copy_segment(work, curve) : cover_segment(work, &cusp);
    }
  }
  if (status == PH_OK && closed) {
    work->pieces[work->n - 1].c[3] = work->pieces[first].c[0];
  }
  return status;
}

enum ph_status ph_cubics_of(const struct ph_curve *curve,
                            const struct ph_offset *offset, double tolerance,
                            struct ph_arena *arena, struct ph_pieces *cubics,
                            struct ph_diag *diag) {
  const int exponent = exponent_of(curve);
  const struct ph_loops *loops = offset ? &offset->loops : NULL;
  struct work work = {.arena = arena,
                      .diag = diag,
                      .grow = ph_pow2_of(exponent),
                      .shrink = ph_pow2_of(-exponent)};
  enum ph_status status = PH_OK;
  work.tolerance = ph_pow2_apply(work.shrink, tolerance);
  work.rounding = ph_curve_rounding(curve);
  for (size_t i = 0; loops && status == PH_OK && i < loops->n; i++) {
    status = ph_sampler_begin_loop(&work.sampler, curve, offset, &loops->v[i],
                                   arena, diag);
    if (status == PH_OK) {
      status = cover_path(&work, NULL, loops->v[i].closed);
    }
  }
  if (!loops || !loops->mode) {
    status = ph_sampler_begin(&work.sampler, curve, offset, arena, diag);
    if (status == PH_OK) {
      status =
          cover_path(&work, offset,
                     curve->closed && !(offset && ph_gaps_open(&offset->gaps)));
    }
  }
  return status == PH_OK ? store(&work, cubics) : status;
}
