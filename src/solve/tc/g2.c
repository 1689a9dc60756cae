/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Curvature-continuous splines (see g2.h): from the data to the curve.
 */
#include "solve/tc/g2.h"

#include <math.h>
#include <string.h>

/* The roots of the outer legs of a cubic that is nearly a cusp have a larger
 * ratio. */
static const double CUSP = 1e3;

/* From this quotient of neighbouring chords on splines of the command planar
 * have less than two thirds of energy times length, for most data. */
static const double UNEVEN = 1e3;

/* ---- the curve ----------------------------------------------------------- */

struct builder {
  const struct ph_tc_data *data;
  const struct ph_g2_chain *chain; /* of the part that is being built */
  const struct ph_g2_solution *s;
  struct ph_curve *curve;
  size_t *start; /* [intervals] the first cubic of each */
  struct ph_sum length;
  size_t interval; /* that is being built, */
  size_t first;    /* from this cubic on */
  double ratio;    /* of outer legs, the largest or its inverse */
  size_t pairs;
};

/* A point of the chain in the unit of the data: that of the user, if it is
 * one. */
static ph_cplx point_of(const struct ph_g2_chain *chain, size_t k) {
  const struct ph_tc_data *d = chain->data;
  const struct ph_g2_node *node = &chain->node[k];
  const struct ph_pow2 grow = ph_pow2_of(-d->exponent);
  return node->datum != PH_G2_ADDED
             ? ph_tc_point(d, node->datum)
             : ph_cplx_of(ph_pow2_apply(grow, node->p.re),
                          ph_pow2_apply(grow, node->p.im));
}

/* A cubic on a chord at unit scale, of the sense +-1. */
static struct ph_tc cubic_of(double a, double b, ph_cplx chord, int sense) {
  double length = hypot(chord.re, chord.im);
  ph_cplx along = ph_cplx_of(chord.re / length, chord.im / length);
  ph_cplx root = ph_cplx_scale(sqrt(length), ph_cplx_sqrt(along));
  struct ph_tc tc = ph_g2_preimage(a, b);
  for (size_t i = 0; i < 2; i++) {
    tc.w[i] = ph_cplx_mul(root, sense > 0 ? tc.w[i] : ph_cplx_conj(tc.w[i]));
  }
  return tc;
}

static void put(struct builder *b, const struct ph_tc *tc, ph_cplx from,
                ph_cplx to) {
  struct ph_curve *curve = b->curve;
  size_t i = curve->n++;
  double ratio = ph_cplx_abs(tc->w[1]) / ph_cplx_abs(tc->w[0]);
  ph_tc_curve_put(curve, i, tc, from, to, b->data->exponent);
  curve->knots[i + 1] = (double)(i + 1);
  b->ratio = fmax(b->ratio, fmax(ratio, 1 / ratio));
  ph_sum_add(&b->length, curve->lengths[i]);
}

/* The curvature at an end of cubic i, in the unit of the data. */
static double curvature_at(const struct builder *b, size_t i, size_t end) {
  const int exponent = b->data->exponent;
  const double *v = b->curve->preimage.v + 4 * i;
  const double root = ldexp(1, exponent / 2);
  struct ph_tc tc = {{ph_cplx_of(root * v[0], root * v[1]),
                      ph_cplx_of(root * v[2], root * v[3])}};
  double speed = ph_cplx_norm2(tc.w[end]);
  return ldexp(2 * ph_cplx_cross(tc.w[0], tc.w[1]) / (speed * speed), exponent);
}

/* The curvature jumps before cubic i, from that at the end of the last.  Joints
 * are found nearly in their order. */
static void add_joint(struct builder *b, size_t i, enum ph_joint_kind kind) {
  struct ph_curve *curve = b->curve;
  struct ph_joint *joint = curve->g2.joints;
  size_t last = i > 0 ? i - 1 : curve->n - 1, at = curve->g2.joints_n++;
  const double *p = ph_curve_points(curve, i);
  for (; at > 0 && joint[at - 1].segment > i; at--) {
    joint[at] = joint[at - 1];
  }
  joint[at] = (struct ph_joint){
      .segment = i,
      .point = {p[0], p[1]},
      .curvature = {curvature_at(b, last, 1), curvature_at(b, i, 0)},
      .kind = kind};
}

static void build_bend(struct builder *b, size_t i, ph_cplx from, ph_cplx to) {
  const struct ph_g2_span *span = &b->chain->span[i];
  const int exponent = b->data->exponent;
  struct ph_g2_bend bend = ph_g2_bend_of(b->s->a[i], b->s->b[i]);
  ph_cplx joint = span->sense > 0 ? bend.joint : ph_cplx_conj(bend.joint);
  ph_cplx first = ph_cplx_mul(joint, span->chord);
  ph_cplx last = ph_cplx_sub(span->chord, first), at;
  struct ph_tc tc;
  at = ph_cplx_of(from.re + ldexp(first.re, -exponent),
                  from.im + ldexp(first.im, -exponent));
  tc = cubic_of(bend.a[0], bend.b[0], first, span->sense);
  put(b, &tc, from, at);
  tc = cubic_of(bend.a[1], bend.b[1], last, -span->sense);
  put(b, &tc, at, to);
  add_joint(b, b->curve->n - 1, PH_JOINT_INFLECTION);
}

static void build_span(struct builder *b, size_t i) {
  const struct ph_g2_span *span = &b->chain->span[i];
  ph_cplx from = point_of(b->chain, i);
  ph_cplx to = point_of(b->chain, ph_g2_next(b->chain, i));
  struct ph_tc tc;
  if (span->form == PH_G2_BEND) {
    build_bend(b, i, from, to);
  } else if (span->form == PH_G2_ARC) {
    tc = cubic_of(b->s->a[i], b->s->b[i], span->chord, span->sense);
    put(b, &tc, from, to);
  } else {
    ph_cplx root =
        ph_cplx_scale(sqrt(span->length),
                      ph_cplx_sqrt(ph_cplx_of(span->chord.re / span->length,
                                              span->chord.im / span->length)));
    tc = (struct ph_tc){{root, root}};
    put(b, &tc, from, to);
  }
}

/* Whether a line ends or begins where span i does. */
static bool is_straight_joint(const struct ph_g2_chain *c, size_t i) {
  const struct ph_g2_node *node = &c->node[i];
  enum ph_g2_form before;
  if (!node->inner) {
    return false;
  }
  before = c->span[ph_g2_before(c, i)].form;
  return (before == PH_G2_LINE) != (c->span[i].form == PH_G2_LINE) ||
         (node->sign == 0 && before != PH_G2_LINE);
}

/* What is before cubic `first`, the first of span i: a point that was added, or
 * one where a line ends or begins. */
static void describe_node(struct builder *b, size_t i, size_t first) {
  struct ph_g2 *g2 = &b->curve->g2;
  if (b->chain->node[i].datum == PH_G2_ADDED) {
    g2->auxiliary[g2->auxiliary_n++] = first;
  }
  if (is_straight_joint(b->chain, i)) {
    add_joint(b, first, PH_JOINT_STRAIGHT);
  }
}

/* An interval is complete; what is built from here on is of the next. */
static void next_interval(struct builder *b) {
  b->start[b->interval] = b->first;
  b->first = b->curve->n;
  b->interval = b->interval + 1 < b->data->n ? b->interval + 1 : 0;
}

/* An interval of the data may be complete whose last span is i. */
static void end_interval(struct builder *b, size_t i) {
  const struct ph_g2_chain *c = b->chain;
  if (c->node[ph_g2_next(c, i)].datum != PH_G2_ADDED) {
    next_interval(b);
  }
}

static void build_chain(struct builder *b, const struct ph_g2_part *part) {
  const struct ph_g2_chain *chain = &part->chain;
  size_t start = b->curve->n;
  b->chain = chain;
  b->s = &part->solution;
  for (size_t i = 0; i < chain->n; i++) {
    size_t first = b->curve->n;
    build_span(b, i);
    if (i > 0) {
      describe_node(b, i, first);
    }
    end_interval(b, i);
  }
  describe_node(b, 0, start);
}

/* The pair of the mode spline. */
static void build_pair(struct builder *b, const struct ph_g2_part *part) {
  struct ph_tc_builder pair = {
      .data = b->data, .curve = b->curve, .done = b->interval};
  size_t first = b->curve->n;
  ph_tc_build_add(&pair, &part->fit);
  for (size_t i = first; i < b->curve->n; i++) {
    ph_sum_add(&b->length, b->curve->lengths[i]);
  }
  for (size_t i = first + 1; i < b->curve->n; i++) {
    add_joint(b, i, PH_JOINT_PAIR);
  }
  next_interval(b);
  b->pairs++;
}

static void build_part(struct builder *b, const struct ph_g2_part *part) {
  size_t first = b->curve->n;
  if (part->pair) {
    build_pair(b, part);
  } else {
    build_chain(b, part);
  }
  if (first > 0) {
    add_joint(b, first, PH_JOINT_TANGENT);
  }
}

/* ---- where closed data begin ----------------------------------------------
 */

/* Reverses the elements from..to-1 of so many bytes. */
static void reverse(void *v, size_t from, size_t to, size_t width) {
  unsigned char *bytes = v;
  for (; from + 1 < to; from++) {
    to--;
    for (size_t j = 0; j < width; j++) {
      const unsigned char x = bytes[width * from + j];
      bytes[width * from + j] = bytes[width * to + j];
      bytes[width * to + j] = x;
    }
  }
}

/* n elements, those before `by` behind the others. */
static void turn(void *v, size_t n, size_t width, size_t by) {
  reverse(v, 0, by, width);
  reverse(v, by, n, width);
  reverse(v, 0, n, width);
}

/* Parts began with some interval of closed data; the curve begins with the
 * first. */
static void begin_with_data(struct builder *b) {
  struct ph_curve *curve = b->curve;
  struct ph_g2 *g2 = &curve->g2;
  const size_t n = curve->n, number = sizeof(double);
  double *p = curve->control_points;
  const size_t by = b->start[0];
  size_t joints = 0, added = 0;
  if (by == 0) {
    return;
  }
  turn(p, n, 6 * number, by);
  memcpy(p + 6 * n, p, 2 * number); /* where it is closed */
  turn(curve->preimage.v, n, 4 * number, by);
  turn(curve->lengths, n, number, by);
  for (size_t i = 0; i < b->data->n; i++) {
    b->start[i] = (b->start[i] + n - by) % n;
  }
  for (size_t i = 0; i < g2->joints_n; i++) {
    joints += g2->joints[i].segment < by;
    g2->joints[i].segment = (g2->joints[i].segment + n - by) % n;
  }
  for (size_t i = 0; i < g2->auxiliary_n; i++) {
    added += g2->auxiliary[i] < by;
    g2->auxiliary[i] = (g2->auxiliary[i] + n - by) % n;
  }
  turn(g2->joints, g2->joints_n, sizeof *g2->joints, joints);
  turn(g2->auxiliary, g2->auxiliary_n, sizeof *g2->auxiliary, added);
}

/* ---- the curve of all parts -----------------------------------------------
 */

/* Cubics of all parts; joints and added points at most. */
static size_t count(const struct ph_g2_parts *parts, size_t *joints,
                    size_t *added) {
  size_t cubics = 0;
  *joints = parts->n; /* between parts */
  *added = 0;
  for (size_t k = 0; k < parts->n; k++) {
    const struct ph_g2_part *part = &parts->part[k];
    size_t spans = part->pair ? part->fit.n : part->chain.n;
    *joints += part->pair ? spans - 1 : 0;
    cubics += spans;
    for (size_t i = 0; !part->pair && i < spans; i++) {
      const bool bend = part->chain.span[i].form == PH_G2_BEND;
      *joints += bend + is_straight_joint(&part->chain, i);
      cubics += bend;
    }
    *added += part->pair ? 0 : spans - part->n;
  }
  return cubics;
}

/* All but what intervals are. */
static enum ph_status build(struct builder *b, const struct ph_g2_parts *parts,
                            struct ph_arena *out, struct ph_arena *scratch,
                            struct ph_curve *curve, struct ph_diag *diag) {
  size_t joints, added, cubics = count(parts, &joints, &added);
  *curve = (struct ph_curve){.kind = PH_CURVE_TC,
                             .closed = b->data->closed,
                             .joined = true,
                             .dimension = 2,
                             .degree = 3,
                             .n = cubics,
                             .preimage.n = 2,
                             .preimage.dimension = 2};
  b->curve = curve;
  b->start = ph_arena_array(scratch, b->data->n, sizeof *b->start);
  curve->g2.joints = ph_arena_array(out, joints, sizeof *curve->g2.joints);
  curve->g2.auxiliary = ph_arena_array(out, added, sizeof *curve->g2.auxiliary);
  if (!b->start || !curve->g2.joints || !curve->g2.auxiliary ||
      ph_curve_alloc(curve, out, diag) != PH_OK) {
    return ph_fail_memory(diag);
  }
  curve->n = 0;
  curve->knots[0] = 0;
  b->interval = parts->part[0].first;
  for (size_t k = 0; k < parts->n; k++) {
    build_part(b, &parts->part[k]);
  }
  if (curve->closed && parts->n > 1) {
    add_joint(b, 0, PH_JOINT_TANGENT);
  }
  begin_with_data(b);
  curve->length = ph_sum_value(&b->length);
  return PH_OK;
}

/* What intervals are, from the curve and the pairs. */
static enum ph_status set_intervals(const struct builder *b,
                                    const struct ph_g2_parts *parts,
                                    struct ph_arena *out,
                                    struct ph_result *result,
                                    struct ph_diag *diag) {
  const size_t n = b->data->n;
  struct ph_interval *interval = ph_arena_array(out, n, sizeof *interval);
  if (!interval) {
    return ph_fail_memory(diag);
  }
  for (size_t i = 0; i < n; i++) {
    const size_t end = i + 1 < n ? b->start[i + 1] : b->curve->n;
    struct ph_sum length = {0, 0};
    for (size_t k = b->start[i]; k < end; k++) {
      ph_sum_add(&length, b->curve->lengths[k]);
    }
    interval[i] = PH_INTERVAL_NONE;
    interval[i].length = ph_sum_value(&length);
    interval[i].first = b->start[i];
    interval[i].last = end - 1;
  }
  for (size_t k = 0; k < parts->n; k++) {
    const struct ph_g2_part *part = &parts->part[k];
    if (part->pair) {
      ph_tc_describe(&part->fit, &interval[part->first]);
    }
  }
  result->intervals = interval;
  result->intervals_n = n;
  return PH_OK;
}

/* ---- all ----------------------------------------------------------------- */

/* Joints where the curve turns to the other side or is straight. */
static void warn_joints(struct ph_result *result) {
  const struct ph_g2 *g2 = &result->curve.g2;
  size_t n = 0, first = 0;
  for (size_t i = g2->joints_n; i-- > 0;) {
    if (g2->joints[i].kind <= PH_JOINT_STRAIGHT) {
      first = g2->joints[i].segment;
      n++;
    }
  }
  if (n > 0) {
    ph_warn(result, first, PH_W_G1_JOINTS,
            "the curvature jumps at %zu joint%s, where the curve turns to the "
            "other side or is straight; the first is before segment %zu",
            n, n > 1 ? "s" : "", first);
  }
}

/* The largest quotient of chords beside one another. */
static double unevenness(const struct ph_tc_data *d) {
  double most = 1;
  for (size_t i = d->closed ? 0 : 1; i < d->n; i++) {
    double q = d->chord[i] / d->chord[i > 0 ? i - 1 : d->n - 1];
    most = fmax(most, fmax(q, 1 / q));
  }
  return most;
}

static void warn(struct ph_result *result, const struct builder *b) {
  const struct ph_g2 *g2 = &result->curve.g2;
  const double uneven = unevenness(b->data);
  size_t pair = 0;
  warn_joints(result);
  if (g2->auxiliary_n > 0) {
    ph_warn(result, g2->auxiliary[0], PH_W_AUXILIARY_POINTS,
            "%zu point%s added where the data turn too much for one cubic, the "
            "first before segment %zu",
            g2->auxiliary_n, g2->auxiliary_n > 1 ? "s were" : " was",
            g2->auxiliary[0]);
  }
  while (pair + 1 < b->data->n && result->intervals[pair].root == PH_ROOT_N) {
    pair++; /* intervals of chains have none */
  }
  pair = b->pairs > 0 ? result->intervals[pair].first : 0;
  if (b->pairs > 0) {
    ph_warn(result, pair, PH_W_SPLINE_PAIRS,
            "the curvature jumps in and beside %zu interval%s with the cubics "
            "of the mode spline, which bend less there; the first cubic is "
            "segment %zu",
            b->pairs, b->pairs > 1 ? "s" : "", pair);
  }
  if (uneven > UNEVEN) {
    ph_warn(result, PH_NO_SEGMENT, PH_W_UNEVEN_CHORDS,
            "of chords beside one another one is %.3g times as long: the "
            "curves of the command planar bend less there",
            uneven);
  }
  if (b->ratio > CUSP) {
    ph_warn(result, PH_NO_SEGMENT, PH_W_NEAR_CUSP,
            "a cubic has end derivatives whose ratio is %.3g: its curvature is "
            "large at one end",
            b->ratio * b->ratio);
  }
}

enum ph_status ph_tc_g2(const struct ph_problem *problem,
                        const struct ph_tc_data *data, struct ph_arena *out,
                        struct ph_arena *scratch, struct ph_result *result,
                        struct ph_diag *diag) {
  struct ph_g2_parts parts;
  struct builder b = {.data = data, .ratio = 1};
  struct ph_arena chains = ph_arena_beside(scratch);
  enum ph_status status =
      ph_g2_parts_of(problem, data, scratch, &chains, &parts, diag);
  if (status == PH_OK) {
    status = build(&b, &parts, out, scratch, &result->curve, diag);
  }
  ph_arena_free(&chains);
  if (status == PH_OK) {
    status = set_intervals(&b, &parts, out, result, diag);
  }
  if (status == PH_OK) {
    double iterations = 0, residual = 0;
    for (size_t k = 0; k < parts.n; k++) {
      iterations += (double)parts.part[k].solution.iterations;
      residual = fmax(residual, parts.part[k].solution.residual);
    }
    warn(result, &b);
    ph_diagnostics_set(&result->diagnostics, PH_D_ITERATIONS, iterations);
    ph_diagnostics_set(&result->diagnostics, PH_D_RESIDUAL, residual);
  }
  return status;
}
