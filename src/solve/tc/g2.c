/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Curvature-continuous splines (see g2.h): from the data to the curve.
 *
 * Cubics of the solution that turn by more than 2 pi/3 get a point at the apex
 * of their tangents, and the data are solved again: such cubics are long loops
 * beside which the curve could be much fairer.
 */
#include "solve/tc/g2.h"

#include "kernel/pi.h"

#include <math.h>

/* A cubic that turns by more gets a point; how often this is done: once or not
 * at all, but for a handful of data. */
static const double TURN = 2 * PH_PI / 3;
enum { ROUNDS_MAX = 6 };

/* The roots of the outer legs of a cubic that is nearly a cusp have a larger
 * ratio. */
static const double CUSP = 1e3;

/* ---- solutions ----------------------------------------------------------- */

/* Points over cubics that turn too much.  ret NULL when memory is exhausted */
static struct ph_g2_apex *loops_of(const struct ph_g2_chain *chain,
                                   const struct ph_g2_solution *s,
                                   struct ph_arena *arena, size_t *n) {
  struct ph_g2_apex *apex = ph_arena_array(arena, chain->n, sizeof *apex);
  *n = 0;
  for (size_t i = 0; apex && i < chain->n; i++) {
    if (chain->span[i].form == PH_G2_ARC && s->a[i] + s->b[i] > TURN) {
      apex[(*n)++] = (struct ph_g2_apex){
          i, {s->a[i] / 2, s->b[i] / 2}, chain->span[i].sense};
    }
  }
  return apex;
}

/* What stands between the points of a chain, and its angles; with more points
 * if that fails. */
static enum ph_status plan_and_solve(struct ph_g2_chain *chain, bool may_add,
                                     enum ph_g2_rule rule,
                                     struct ph_arena *arena,
                                     struct ph_g2_solution *s,
                                     struct ph_diag *diag) {
  const struct ph_g2_chain given = *chain;
  enum ph_status status = ph_g2_plan(chain, PH_G2_TURNS, may_add, arena, diag);
  if (status == PH_OK) {
    status = ph_g2_solve(chain, rule, arena, s, diag);
  }
  if (status == PH_E_NO_CONVERGENCE && may_add && !ph_arena_late(arena)) {
    *chain = given;
    status = ph_g2_plan(chain, PH_G2_TURNS_SAFE, true, arena, diag);
    if (status == PH_OK) {
      status = ph_g2_solve(chain, rule, arena, s, diag);
    }
  }
  return status;
}

static enum ph_status find(struct ph_g2_chain *chain, bool may_add,
                           enum ph_g2_rule rule, struct ph_arena *arena,
                           struct ph_g2_solution *s, struct ph_diag *diag) {
  enum ph_status status = plan_and_solve(chain, may_add, rule, arena, s, diag);
  size_t iterations = s->iterations;
  for (size_t round = 0; status == PH_OK && may_add && round < ROUNDS_MAX;
       round++) {
    size_t n;
    struct ph_g2_apex *apex = loops_of(chain, s, arena, &n);
    if (!apex) {
      return ph_fail_memory(diag);
    }
    if (n == 0) {
      break;
    }
    status = ph_g2_add(chain, apex, n, arena, chain, diag);
    if (status == PH_OK) {
      status = plan_and_solve(chain, true, rule, arena, s, diag);
      iterations += s->iterations;
    }
  }
  s->iterations = iterations;
  return status;
}

/* ---- the curve ----------------------------------------------------------- */

struct builder {
  const struct ph_g2_chain *chain;
  const struct ph_g2_solution *s;
  struct ph_curve *curve;
  struct ph_interval *intervals;
  struct ph_sum length, part;
  size_t interval; /* that is being built */
  double ratio;    /* of outer legs, the largest or its inverse */
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
  ph_tc_curve_put(curve, i, tc, from, to, b->chain->data->exponent);
  curve->knots[i + 1] = (double)(i + 1);
  b->ratio = fmax(b->ratio, fmax(ratio, 1 / ratio));
  ph_sum_add(&b->length, curve->lengths[i]);
  ph_sum_add(&b->part, curve->lengths[i]);
}

/* The curvature at an end of cubic i, in the unit of the data. */
static double curvature_at(const struct builder *b, size_t i, size_t end) {
  const int exponent = b->chain->data->exponent;
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
  const double *p = curve->control_points + 8 * i;
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
  const int exponent = b->chain->data->exponent;
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

/* What is before cubic `first`, the first of span i: a point that was added, or
 * one where a line ends or begins. */
static void describe_node(struct builder *b, size_t i, size_t first) {
  const struct ph_g2_chain *c = b->chain;
  struct ph_g2 *g2 = &b->curve->g2;
  const struct ph_g2_node *node = &c->node[i];
  enum ph_g2_form before;
  if (node->datum == PH_G2_ADDED) {
    g2->auxiliary[g2->auxiliary_n++] = first;
  }
  if (!node->inner) {
    return;
  }
  before = c->span[ph_g2_before(c, i)].form;
  if ((before == PH_G2_LINE) != (c->span[i].form == PH_G2_LINE) ||
      (node->sign == 0 && before != PH_G2_LINE)) {
    add_joint(b, first, PH_JOINT_STRAIGHT);
  }
}

/* The interval of the data is complete whose last span is i. */
static void end_interval(struct builder *b, size_t i) {
  const struct ph_g2_chain *c = b->chain;
  struct ph_interval *interval = &b->intervals[b->interval];
  size_t next = ph_g2_next(c, i);
  if (c->node[next].datum == PH_G2_ADDED) {
    return;
  }
  *interval = PH_INTERVAL_NONE;
  interval->length = ph_sum_value(&b->part);
  interval->first = b->interval > 0 ? interval[-1].last + 1 : 0;
  interval->last = b->curve->n - 1;
  b->part = (struct ph_sum){0, 0};
  b->interval++;
}

static enum ph_status build(const struct ph_g2_chain *chain,
                            const struct ph_g2_solution *s,
                            struct ph_arena *out, struct ph_result *result,
                            double *ratio, struct ph_diag *diag) {
  struct ph_curve *curve = &result->curve;
  struct builder b = {.chain = chain, .s = s, .curve = curve};
  size_t bends = 0;
  for (size_t i = 0; i < chain->n; i++) {
    bends += chain->span[i].form == PH_G2_BEND;
  }
  *curve = (struct ph_curve){.kind = PH_CURVE_TC,
                             .closed = chain->closed,
                             .dimension = 2,
                             .degree = 3,
                             .n = chain->n + bends,
                             .preimage.n = 2,
                             .preimage.dimension = 2};
  b.intervals = ph_arena_array(out, chain->data->n, sizeof *b.intervals);
  curve->g2.joints =
      ph_arena_array(out, chain->nodes_n + bends, sizeof *curve->g2.joints);
  curve->g2.auxiliary = ph_arena_array(out, chain->nodes_n - chain->data->n,
                                       sizeof *curve->g2.auxiliary);
  if (!b.intervals || !curve->g2.joints || !curve->g2.auxiliary ||
      ph_curve_alloc(curve, out, diag) != PH_OK) {
    return ph_fail_memory(diag);
  }
  curve->n = 0;
  curve->knots[0] = 0;
  for (size_t i = 0; i < chain->n; i++) {
    size_t first = curve->n;
    build_span(&b, i);
    if (i > 0) {
      describe_node(&b, i, first);
    }
    end_interval(&b, i);
  }
  describe_node(&b, 0, 0);
  curve->length = ph_sum_value(&b.length);
  result->intervals = b.intervals;
  result->intervals_n = chain->data->n;
  *ratio = b.ratio;
  return PH_OK;
}

/* ---- all ----------------------------------------------------------------- */

static void warn(struct ph_result *result, double ratio) {
  const struct ph_g2 *g2 = &result->curve.g2;
  if (g2->joints_n > 0) {
    ph_warn(result, g2->joints[0].segment, PH_W_G1_JOINTS,
            "the curvature jumps at %zu joint%s, where the curve turns to the "
            "other side or is straight; the first is before segment %zu",
            g2->joints_n, g2->joints_n > 1 ? "s" : "", g2->joints[0].segment);
  }
  if (g2->auxiliary_n > 0) {
    ph_warn(result, g2->auxiliary[0], PH_W_AUXILIARY_POINTS,
            "%zu point%s added where the data turn too much for one cubic, the "
            "first before segment %zu",
            g2->auxiliary_n, g2->auxiliary_n > 1 ? "s were" : " was",
            g2->auxiliary[0]);
  }
  if (ratio > CUSP) {
    ph_warn(result, PH_NO_SEGMENT, PH_W_NEAR_CUSP,
            "a cubic has end derivatives whose ratio is %.3g: its curvature is "
            "large at one end",
            ratio * ratio);
  }
}

enum ph_status ph_tc_g2(const struct ph_problem *problem,
                        const struct ph_tc_data *data, struct ph_arena *out,
                        struct ph_arena *scratch, struct ph_result *result,
                        struct ph_diag *diag) {
  bool may_add = !ph_value_is(&problem->field[PH_F_AUXILIARY], "never");
  enum ph_g2_rule rule = ph_value_is(&problem->field[PH_F_ENDS], "smooth")
                             ? PH_G2_SMOOTH
                             : PH_G2_CIRCLE;
  struct ph_g2_solution solution = {.iterations = 0};
  struct ph_g2_chain chain;
  double ratio = 1;
  enum ph_status status = ph_g2_chain_of(data, scratch, &chain, diag);
  if (status == PH_OK) {
    status = find(&chain, may_add, rule, scratch, &solution, diag);
  }
  if (status == PH_OK) {
    status = build(&chain, &solution, out, result, &ratio, diag);
  }
  if (status == PH_OK) {
    warn(result, ratio);
    ph_diagnostics_set(&result->diagnostics, PH_D_ITERATIONS,
                       (double)solution.iterations);
    ph_diagnostics_set(&result->diagnostics, PH_D_RESIDUAL, solution.residual);
  }
  return status;
}
