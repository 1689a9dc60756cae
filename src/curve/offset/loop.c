/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Offsets as loops (see loop.h). */
#include "curve/offset/loop.h"

#include "curve/bezier/hermite.h"
#include "curve/offset/cusp.h"
#include "curve/offset/rational.h"
#include "curve/segment/seg2.h"
#include "kernel/quad.h"

#include <float.h>
#include <math.h>
#include <string.h>

/* Nodes that integrate A0 exactly of polynomials, to rounding of others. */
enum { NODES = 5, NODES_ATPH = 12, ROOM = 8, DEGREE_MAX = 5 };

/* Of the size: loops that are no wider. */
static const double THIN = 1e-9;

struct writer {
  const struct ph_curve *curve;
  const struct ph_strands *strands;
  const struct ph_outline *outline;
  struct ph_arena *arena;
  struct ph_offset *offset;
  struct ph_loop *loop;
  size_t room; /* of its pieces, and at least */
  size_t least;
  double *numbers; /* of pieces to come, so many */
  size_t numbers_n;
  size_t degree; /* of the curve whose offsets have the degree of the pieces */
  double tolerance;
  const struct ph_span *span;
  const struct ph_strand *strand; /* of the span */
  ph_cplx from;               /* the first place of the loop, at unit scale */
  struct ph_strand_eval eval; /* of that strand, once it is entered */
  struct ph_quad rule;
  double cross[DEGREE_MAX + 1][DEGREE_MAX + 1]; /* A0 by control points */
  double area, length;                          /* of the loop, at unit scale */
  bool memory;                                  /* is exhausted */
};

/* ---- pieces ---------------------------------------------------------------
 */

static ph_cplx to_data(const struct ph_strands *strands, ph_cplx at) {
  const struct ph_pow2 unit = ph_pow2_of(strands->exponent);
  return ph_cplx_of(strands->center.re + ph_pow2_apply(unit, at.re),
                    strands->center.im + ph_pow2_apply(unit, at.im));
}

/* So many numbers, of those of a whole block; NULL: memory is exhausted. */
static double *take(struct writer *w, size_t n) {
  double *numbers = w->numbers;
  if (w->numbers_n < n) {
    w->numbers_n = w->least * n;
    numbers = ph_arena_array(w->arena, w->numbers_n, sizeof *numbers);
    w->numbers_n = numbers ? w->numbers_n : 0;
  }
  if (numbers) {
    w->numbers = numbers + n;
    w->numbers_n -= n;
  }
  return numbers;
}

/* A new piece of the loop; NULL: memory is exhausted. */
static struct ph_loop_piece *add(struct writer *w) {
  const size_t points = w->offset->degree + 1;
  struct ph_loop *loop = w->loop;
  struct ph_loop_piece *piece;
  double *numbers = take(w, 3 * points);
  loop->pieces = ph_arena_grow(w->arena, loop->pieces, loop->n,
                               sizeof *loop->pieces, w->least, &w->room);
  if (!loop->pieces || !numbers) {
    w->memory = true;
    return NULL;
  }
  piece = &loop->pieces[loop->n];
  *piece = (struct ph_loop_piece){.segment = PH_NO_SEGMENT,
                                  .interval = {(double)NAN, (double)NAN},
                                  .join = PH_NO_SEGMENT,
                                  .angle = (double)NAN,
                                  .control_points = numbers,
                                  .weights = numbers + 2 * points};
  loop->n++;
  return piece;
}

static void swap(double *a, double *b) {
  const double c = *a;
  *a = *b;
  *b = c;
}

/* Turns a piece round. */
static void turn_round(struct ph_loop_piece *piece, size_t points) {
  swap(&piece->interval[0], &piece->interval[1]);
  for (size_t i = 0; i < points / 2; i++) {
    const size_t j = points - 1 - i;
    swap(&piece->weights[i], &piece->weights[j]);
    swap(&piece->control_points[2 * i], &piece->control_points[2 * j]);
    swap(&piece->control_points[2 * i + 1], &piece->control_points[2 * j + 1]);
  }
}

/* The length of the part of the span between two of its parameters. */
static double length_between(struct writer *w, double u0, double u1) {
  const double *u = w->span->u;
  double length = w->span->length;
  if (u0 > u[0] || u1 < u[1]) {
    struct ph_spot a, b;
    ph_strand_enter(&w->eval, w->strands, w->span->strand);
    a = ph_strand_spot(&w->eval, u0);
    b = ph_strand_spot(&w->eval, u1);
    length = ph_spot_length(w->strands->distance, &a, &b);
  }
  return ldexp(fabs(length), w->strands->exponent);
}

static void visit_segment(void *context, const struct ph_rational *rational) {
  struct writer *w = context;
  const bool back = w->strand->at >= w->strands->n;
  struct ph_loop_piece *piece = add(w);
  const double d = ldexp(w->strands->distance, w->strands->exponent);
  if (!piece) {
    return;
  }
  piece->segment = rational->segment;
  piece->interval[0] = rational->from;
  piece->interval[1] = rational->to;
  piece->length = back ? length_between(w, 1 - rational->to, 1 - rational->from)
                       : length_between(w, rational->from, rational->to);
  ph_rational_points(rational, PH_E2, back ? -d : d, 2, piece->control_points,
                     piece->weights);
  if (back) {
    turn_round(piece, w->offset->degree + 1);
  }
}

static void visit_join(void *context, const struct ph_rational *rational) {
  struct writer *w = context;
  struct ph_loop_piece *piece = add(w);
  if (piece) {
    piece->join = w->strand->at;
    piece->angle = w->span->turn;
    piece->length = ldexp(fabs(w->span->length), w->strands->exponent);
    ph_rational_points(rational, PH_E2,
                       ldexp(w->strands->distance, w->strands->exponent), 2,
                       piece->control_points, piece->weights);
  }
}

/* The part [from,to] of an ATPH segment as a curve of one segment. */
static void cut_atph(const struct writer *w, size_t k, double from, double to,
                     struct ph_curve *part, double *numbers) {
  const struct ph_seg2 seg = ph_seg2_of(w->curve, k);
  const struct ph_spot *end = w->span->end;
  const bool back = w->strand->at >= w->strands->n;
  const ph_cplx a = to_data(w->strands, end[back].r);
  const ph_cplx b = to_data(w->strands, end[!back].r);
  struct ph_atph space;
  ph_cplx v[3];
  double *p = numbers, *preimage = numbers + 12, *alpha = preimage + 6;
  ph_atph_part(&seg.space, seg.w, from, to, &space, v);
  *alpha = space.angle;
  for (size_t i = 0; i < 3; i++) { /* with respect to t */
    const ph_cplx at = ph_cplx_scale(1 / sqrt(seg.space.angle), v[i]);
    preimage[2 * i] = at.re;
    preimage[2 * i + 1] = at.im;
  }
  for (size_t i = 0; i < 6; i++) {
    p[2 * i] = i < 3 ? a.re : b.re;
    p[2 * i + 1] = i < 3 ? a.im : b.im;
  }
  *part = (struct ph_curve){.kind = PH_CURVE_ATPH,
                            .dimension = 2,
                            .degree = 5,
                            .n = 1,
                            .control_points = p,
                            .preimage = {3, 2, preimage, alpha}};
}

/* Pieces within the tolerance, of equal weights. */
static enum ph_status write_atph(struct writer *w, size_t k, double from,
                                 double to, struct ph_diag *diag) {
  const bool back = w->strand->at >= w->strands->n;
  const double d = ldexp(w->strands->distance, w->strands->exponent);
  double *error = &w->offset->loops.trimming.approximation;
  double numbers[12 + 6 + 1];
  struct ph_curve part;
  struct ph_pieces pieces;
  enum ph_status status;
  cut_atph(w, k, from, to, &part, numbers);
  status = ph_hermite_pieces(&part, back ? -d : d, PH_E2, w->tolerance,
                             w->strands->arena, &pieces, diag);
  for (size_t i = 0; status == PH_OK && i < pieces.n; i++) {
    struct ph_loop_piece *piece = add(w);
    const double *in = pieces.interval + 2 * i;
    if (!piece) {
      return PH_OK;
    }
    piece->segment = k;
    piece->interval[0] = i ? from + in[0] * (to - from) : from;
    piece->interval[1] = in[1] < 1 ? from + in[1] * (to - from) : to;
    piece->length =
        back ? length_between(w, 1 - piece->interval[1], 1 - piece->interval[0])
             : length_between(w, piece->interval[0], piece->interval[1]);
    memcpy(piece->control_points, pieces.control_points + 12 * i,
           12 * sizeof(double));
    for (size_t j = 0; j < 6; j++) {
      piece->weights[j] = 1;
    }
    if (back) {
      turn_round(piece, 6);
    }
  }
  *error = pieces.error > *error ? pieces.error : *error;
  return status;
}

/* A line of a miter: of the same degree, with equal weights. */
static void write_line(struct writer *w) {
  const size_t degree = w->offset->degree;
  struct ph_loop_piece *piece = add(w);
  if (piece) {
    piece->join = w->strand->at;
    piece->angle = 0;
    piece->length = ldexp(fabs(w->span->length), w->strands->exponent);
    for (size_t i = 0; i <= degree; i++) {
      const double x = (double)i / (double)degree;
      const ph_cplx at = to_data(
          w->strands, ph_cplx_between(w->span->end[0].o, w->span->end[1].o, x));
      piece->control_points[2 * i] = at.re;
      piece->control_points[2 * i + 1] = at.im;
      piece->weights[i] = 1;
    }
  }
}

/* The pieces of a span, in its order. */
static enum ph_status write_span(struct writer *w, struct ph_diag *diag) {
  const struct ph_span *span = w->span;
  const struct ph_strand *s = &w->strands->v[span->strand];
  const size_t n = w->strands->n, first = w->loop->n;
  const bool back = s->kind == PH_STRAND_SEGMENT && s->at >= n;
  enum ph_status status = PH_OK;
  w->strand = s;
  if (s->kind == PH_STRAND_LINE) {
    write_line(w);
  } else if (s->kind == PH_STRAND_ROUND) {
    const ph_cplx ends[2] = {span->end[0].w, span->end[1].w};
    status = ph_rational_arc(w->degree, to_data(w->strands, s->point), ends,
                             visit_join, w);
  } else {
    const size_t k = back ? 2 * n - 1 - s->at : s->at;
    const double from = back ? 1 - span->u[1] : span->u[0];
    const double to = back ? 1 - span->u[0] : span->u[1];
    status = w->curve->preimage.alpha
                 ? write_atph(w, k, from, to, diag)
                 : ph_rational_part(w->curve, k, from, to, visit_segment, w);
  }
  for (size_t i = first, j = w->loop->n; back && i + 1 < j--; i++) {
    const struct ph_loop_piece piece = w->loop->pieces[i];
    w->loop->pieces[i] = w->loop->pieces[j];
    w->loop->pieces[j] = piece;
  }
  return status;
}

/* ---- areas ----------------------------------------------------------------
 */

/* A0 of the span from its first foot: of a whole polynomial by control points,
 *
 *   1/2 sum over i < j of (j - i) binomial(n,i) binomial(n,j)
 *     / ((2n - 1) binomial(2n - 2, i + j - 1)) p_i x p_j,                 (2)
 *
 * as the integral of B_i B_j' - B_j B_i' is that. */
static void tabulate(struct writer *w, size_t n) {
  double choose[2 * DEGREE_MAX + 1][2 * DEGREE_MAX + 1] = {{0}};
  for (size_t i = 0; i <= 2 * n; i++) {
    choose[i][0] = 1;
    for (size_t j = 1; j <= i; j++) {
      choose[i][j] = choose[i - 1][j - 1] + choose[i - 1][j];
    }
  }
  for (size_t i = 0; i <= n; i++) {
    for (size_t j = i + 1; j <= n; j++) {
      w->cross[i][j] = (double)(j - i) * choose[n][i] * choose[n][j] /
                       (double)(2 * (2 * n - 1)) / choose[2 * n - 2][i + j - 1];
    }
  }
}

static double area_of_points(const struct writer *w) {
  const size_t n = w->strands->curve.degree;
  const double *p = ph_curve_points(&w->strands->curve, w->strand->at);
  double area = 0;
  for (size_t i = 1; i < n; i++) {
    for (size_t j = i + 1; j <= n; j++) {
      area += w->cross[i][j] * ((p[2 * i] - p[0]) * (p[2 * j + 1] - p[1]) -
                                (p[2 * i + 1] - p[1]) * (p[2 * j] - p[0]));
    }
  }
  return area;
}

/* Of a part, or of what is no polynomial, by quadrature. */
static double area_of_places(struct writer *w) {
  const struct ph_span *span = w->span;
  const ph_cplx from = span->end[0].r;
  const double h = span->u[1] - span->u[0];
  double area = 0;
  ph_strand_enter(&w->eval, w->strands, span->strand);
  for (size_t i = 0; i < w->rule.n; i++) {
    const struct ph_spot at =
        ph_strand_spot(&w->eval, span->u[0] + h * w->rule.node[i]);
    const ph_cplx move = ph_cplx_scale(at.speed, ph_spot_tangent(&at));
    area += 0.5 * h * w->rule.weight[i] *
            ph_cplx_cross(ph_cplx_sub(at.r, from), move);
  }
  return area;
}

/* (1) of a span, from a place of the loop: of a small one nothing cancels. */
static double area_of(struct writer *w) {
  const struct ph_span *span = w->span;
  const struct ph_spot *a = &span->end[0], *b = &span->end[1];
  const double d = w->strands->distance;
  const ph_cplx r0 = ph_cplx_sub(a->r, w->from);
  const ph_cplx r1 = ph_cplx_sub(b->r, w->from);
  const double product =
      ph_cplx_dot(r1, ph_spot_tangent(b)) - ph_cplx_dot(r0, ph_spot_tangent(a));
  const bool whole = !(span->u[0] > 0) && !(span->u[1] < 1);
  double area = 0.5 * ph_cplx_cross(r0, r1);
  if (w->strand->kind == PH_STRAND_LINE) {
    return 0.5 * ph_cplx_cross(ph_cplx_sub(a->o, w->from),
                               ph_cplx_sub(b->o, w->from));
  }
  if (w->strand->kind == PH_STRAND_SEGMENT) {
    area += whole && !w->curve->preimage.alpha ? area_of_points(w)
                                               : area_of_places(w);
  }
  return area - d * (b->s - a->s) + 0.5 * d * d * span->turn +
         0.5 * d * product;
}

/* ---- loops ----------------------------------------------------------------
 */

/* Where pieces meet their points are one, the mean of both. */
static void join_ends(struct ph_loop_piece *a, struct ph_loop_piece *b,
                      size_t degree) {
  double *p = a->control_points + 2 * degree, *q = b->control_points;
  for (size_t i = 0; i < 2; i++) {
    p[i] = q[i] = q[i] + (p[i] - q[i]) / 2;
  }
}

static enum ph_status fail_range(const struct writer *w, const char *what,
                                 enum ph_status status, struct ph_diag *diag) {
  return ph_fail(diag, status, NULL,
                 "the %soffset at distance %g exceeds the range of a double",
                 what, w->offset->distance);
}

static enum ph_status write_loop(struct writer *w, const struct ph_chain *chain,
                                 struct ph_diag *diag) {
  struct ph_loop *loop = w->loop;
  enum ph_status status = PH_OK;
  *loop = (struct ph_loop){
      .closed = chain->closed, .area = (double)NAN, .parent = PH_NO_SEGMENT};
  w->area = w->length = 0;
  w->room = 0;
  w->least = chain->n + ROOM;
  w->from = w->outline->spans[chain->first].end[0].o;
  for (size_t i = 0; status == PH_OK && i < chain->n; i++) {
    w->span = &w->outline->spans[chain->first + i];
    status = write_span(w, diag);
    w->area += area_of(w);
    w->length += fabs(w->span->length);
  }
  if (status != PH_OK || w->memory) {
    return status != PH_E_INFEASIBLE && status != PH_E_TOO_LARGE
               ? status
               : fail_range(w, "", status, diag);
  }
  for (size_t i = 0; i + 1 < loop->n; i++) {
    join_ends(&loop->pieces[i], &loop->pieces[i + 1], w->offset->degree);
  }
  if (loop->closed) {
    join_ends(&loop->pieces[loop->n - 1], &loop->pieces[0], w->offset->degree);
    loop->area = ldexp(w->area, 2 * w->strands->exponent);
  }
  loop->length = ldexp(w->length, w->strands->exponent);
  return PH_OK;
}

static bool is_narrow(const struct writer *w) {
  return fabs(w->area) <= THIN * w->strands->size * w->length;
}

/* Whether there is nothing within a loop: it is between parts that touch. */
static bool is_thin(const struct writer *w) {
  return w->loop->closed && w->outline->touches > 0 && is_narrow(w);
}

/* Whether the area is no double, though the points are. */
static bool is_beyond(const struct writer *w) {
  const double area = fabs(w->loop->area);
  return w->loop->closed && (isinf(area) || (area < DBL_MIN && !is_narrow(w)));
}

/* All loops, their sums, and samples. */
static enum ph_status write_loops(struct writer *w,
                                  const struct ph_offset_rules *rules,
                                  struct ph_diag *diag) {
  struct ph_offset *offset = w->offset;
  struct ph_loops *loops = &offset->loops;
  const size_t n = w->outline->chains_n;
  enum ph_status status = PH_OK;
  loops->v = ph_arena_array(w->arena, n + 1, sizeof *loops->v);
  offset->length = loops->area = 0;
  if (!loops->v ||
      !ph_quad_gauss(&w->rule, w->curve->preimage.alpha ? NODES_ATPH : NODES)) {
    return ph_fail_memory(diag);
  }
  tabulate(w, w->curve->degree);
  for (size_t i = 0; status == PH_OK && i < n; i++) {
    w->loop = &loops->v[loops->n];
    status = write_loop(w, &w->outline->chains[i], diag);
    if (w->memory) {
      return ph_fail_memory(diag);
    }
    if (status != PH_OK || is_thin(w)) {
      continue;
    }
    if (is_beyond(w)) {
      return fail_range(w, "area of the ", PH_E_TOO_LARGE, diag);
    }
    loops->n++;
    offset->length += w->loop->length;
    loops->area += w->loop->area;
    if (rules->samples.how != PH_SAMPLE_NONE) {
      status = ph_sample_loop(w->curve, &rules->samples, offset, w->loop,
                              w->arena, diag);
    }
  }
  return status;
}

/* The raw offsets to both sides, for what is asked of places of pieces; where
 * none goes against the curve, without the cusps of the other side. */
static enum ph_status find_sides(const struct ph_curve *curve, double distance,
                                 struct ph_arena *arena,
                                 struct ph_offset *offset,
                                 struct ph_diag *diag) {
  struct ph_offset *sides = ph_arena_array(arena, 2, sizeof *sides);
  enum ph_status status = sides ? PH_OK : ph_fail_memory(diag);
  offset->loops.sides = sides;
  for (size_t i = 0; status == PH_OK && i < 2; i++) {
    const double d = i ? 0 - distance : distance;
    sides[i] = (struct ph_offset){.distance = d, .dimension = 2};
    if (i == 0 || offset->loops.both) {
      status = ph_cusps_of(curve, d, PH_E2, arena, &sides[i].cusps, diag);
    }
  }
  return status;
}

enum ph_status ph_loops_of(const struct ph_curve *curve,
                           const struct ph_offset_rules *rules,
                           struct ph_arena *arena, struct ph_offset *offset,
                           struct ph_diag *diag) {
  struct ph_arena scratch = ph_arena_beside(arena);
  struct ph_strands strands;
  struct ph_outline outline;
  struct writer w = {.curve = curve,
                     .strands = &strands,
                     .outline = &outline,
                     .arena = arena,
                     .offset = offset,
                     .degree = curve->preimage.alpha ? 3 : curve->degree,
                     .tolerance = rules->tolerance};
  const bool crosses = rules->crosses;
  const bool open =
      !(curve->closed ? rules->both || !crosses : rules->round_ends);
  enum ph_status status = ph_strands_of(curve, offset->distance, rules, crosses,
                                        &scratch, &strands, diag);
  offset->degree = 2 * w.degree - 1;
  offset->loops = (struct ph_loops){
      .mode = rules->mode == PH_OFFSET_JOINED ? "joined" : "trimmed",
      .join = rules->miter > 0 ? "miter" : "round",
      .both = strands.both};
  if (status == PH_OK) {
    status = ph_outline_of(&strands, rules, open, &outline, diag);
  }
  if (status == PH_OK) {
    status = find_sides(curve, ldexp(strands.distance, strands.exponent), arena,
                        offset, diag);
  }
  if (status == PH_OK) {
    offset->loops.trimming = (struct ph_trimming){
        .crossings = outline.crossings,
        .touches = outline.touches,
        .removed = ldexp(outline.removed, strands.exponent),
        .approximation = curve->preimage.alpha ? 0 : (double)NAN,
        .closure_error = outline.gap / strands.size,
        .distance_error = (double)NAN,
        .area_error = (double)NAN};
    status = write_loops(&w, rules, diag);
  }
  ph_arena_free(&scratch);
  return status;
}
