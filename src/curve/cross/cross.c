/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Whether a planar spline crosses itself (see cross.h).
 *
 * Over the segments, in order of travel, stands a binary tree.  A node knows
 * the box and the cone of tangents (bound2.h) of its segments.  A node with a
 * narrow cone does not meet itself; of any other, the children are searched,
 * and the one against the other.  Two nodes whose boxes are apart, or with a
 * narrow cone from one to the other, do not meet; of any others the larger is
 * split.  Two single segments are left to meet.h.  On a smooth curve nearly
 * all of the time goes into building the tree.
 *
 * Nodes of a few segments are not stored but built when they are looked at.
 *
 * All is done in a frame of its own, whose origin is the middle of the curve,
 * whose unit is about its size, and whose axes are along the most part of the
 * curve: boxes are thin for strokes in one direction, or in two at right
 * angles, whatever the directions.
 */
#include "curve/cross/cross.h"

#include "curve/cross/bound2.h"
#include "curve/cross/meet.h"

#include <float.h>
#include <math.h>

/*
 * STORED: nodes are stored from this level on, which has 2^STORED segments.
 * STEPS, STEPS_EACH: halvings of pairs of segments that are allowed in all, and
 * for each segment; LOOP_STEPS: of one segment against itself.  Crossings and
 * touchings take some 100.  Segments that turn by 1.6 radians take 250 side by
 * side at 1e-6 of their length, 1000 at 1e-8, and 5000 at 1e-10: a curve that
 * does so all along counts as meeting itself.
 */
enum {
  STORED = 3,
  LEVELS = 64,
  STEPS_EACH = 1024,
  STEPS = 1 << 16,
  LOOP_STEPS = 4096
};

/* Segments that are looked at to choose the axes; control points of one. */
enum { SAMPLES = 1024, POINTS_MAX = 6 };

struct node {
  struct ph_box2 box;
  struct ph_cone cone;
};

/* The same in less memory: the box is a little larger. */
struct stored {
  float low[2], high[2];
  struct ph_cone cone;
};

struct tree {
  const struct ph_curve *curve;
  struct ph_box2 box;          /* of the stored nodes, as it is */
  ph_cplx origin;              /* of the frame */
  ph_cplx factor;              /* frame = factor (data - origin) */
  ph_cplx root;                /* of the factor, for the preimage */
  size_t levels;               /* the root is node 0 of level levels - 1 */
  struct stored *node[LEVELS]; /* [level][i], level >= STORED */
  struct ph_quad rule;
  struct ph_meet meet;
};

/* Node i of a level holds segments from i 2^level to (i + 1) 2^level - 1. */
struct place {
  size_t level, i;
};

static ph_cplx pair(const double *v) {
  return ph_cplx_of(v[0], v[1]);
}

/* ---- the frame ---------------------------------------------------------- */

/* The box of the control points; false unless all numbers are finite. */
static bool measure(const struct ph_curve *curve, struct ph_box2 *box) {
  const double *p = curve->control_points, *w = curve->preimage.v;
  const size_t points = 2 * (curve->degree + 1), roots = 2 * curve->preimage.n;
  double test = 0;
  *box = (struct ph_box2){{p[0], p[1]}, {p[0], p[1]}};
  for (size_t k = 0; k < curve->n; k++, w += roots) {
    p = ph_curve_points(curve, k);
    for (size_t i = 0; i < points; i++) {
      double *low = &box->low[i % 2], *high = &box->high[i % 2];
      *low = p[i] < *low ? p[i] : *low;
      *high = p[i] > *high ? p[i] : *high;
      test += 0 * p[i]; /* NaN from infinities too */
    }
    for (size_t i = 0; i < roots; i++) {
      test += 0 * w[i];
    }
    test += 0 * ph_curve_range(curve, k);
  }
  return isfinite(test);
}

/* The direction d that most of the curve takes, forward, backward or across:
 * that of the mean of chord^4, which is the same for all four. */
static ph_cplx main_direction(const struct ph_curve *curve, double scale) {
  size_t step = curve->n / SAMPLES + 1;
  ph_cplx sum = {0, 0};
  for (size_t k = 0; k < curve->n; k += step) {
    const double *p = ph_curve_points(curve, k), *q = p + 2 * curve->degree;
    ph_cplx chord = ph_cplx_scale(scale, ph_cplx_sub(pair(q), pair(p)));
    double length = ph_cplx_abs(chord);
    if (length > 0) {
      ph_cplx square = ph_cplx_scale(1 / length, ph_cplx_mul(chord, chord));
      sum = ph_cplx_add(sum,
                        ph_cplx_scale(1 / length, ph_cplx_mul(square, square)));
    }
  }
  return ph_cplx_polar(0.25 * atan2(sum.im, sum.re));
}

static bool set_frame(struct tree *t) {
  struct ph_box2 box;
  double size = 0, far = 0, scale;
  ph_cplx axis;
  int exponent;
  if (!measure(t->curve, &box)) {
    return false;
  }
  for (size_t i = 0; i < 2; i++) {
    size = fmax(size, 0.5 * box.high[i] - 0.5 * box.low[i]);
    far = fmax(far, fmax(fabs(box.low[i]), fabs(box.high[i])));
  }
  t->origin = ph_cplx_of(0.5 * box.low[0] + 0.5 * box.high[0],
                         0.5 * box.low[1] + 0.5 * box.high[1]);
  /* Even, for its root; beyond 2^1000 either way the unit is not the size. */
  exponent = size > 0 ? ilogb(size) / 2 * 2 : 0;
  exponent = exponent > 1000 ? 1000 : exponent < -1000 ? -1000 : exponent;
  scale = ldexp(1, -exponent);
  axis = ph_cplx_conj(main_direction(t->curve, scale));
  t->factor = ph_cplx_scale(scale, axis);
  t->root = ph_cplx_scale(ldexp(1, -exponent / 2), ph_cplx_sqrt(axis));
  /* Numbers far from 0 are no more exact than their rounding. */
  t->meet.tolerance = 8 * DBL_EPSILON * scale * far;
  return true;
}

static ph_cplx to_frame(const struct tree *t, const double *p) {
  return ph_cplx_mul(t->factor, ph_cplx_sub(pair(p), t->origin));
}

static struct ph_seg2 seg_of(const struct tree *t, size_t k) {
  struct ph_seg2 seg = ph_seg2_of(t->curve, k);
  const double *p = ph_curve_points(t->curve, k);
  for (size_t i = 0; i < 3; i++) {
    seg.w[i] = ph_cplx_mul(t->root, seg.w[i]);
  }
  seg.start = to_frame(t, p);
  seg.end = to_frame(t, p + 2 * t->curve->degree);
  return seg;
}

/* ---- the tree ----------------------------------------------------------- */

/* The turn of the tangent at the joint before segment k: none to speak of on a
 * smooth curve. */
static struct ph_cone joint(const struct tree *t, size_t k) {
  const struct ph_curve *curve = t->curve;
  size_t before = k > 0 ? k - 1 : curve->n - 1, last = curve->preimage.n - 1;
  ph_cplx from, to;
  if (k == 0 && !curve->closed) {
    return PH_CONE_NONE;
  }
  from =
      ph_cplx_mul(t->root, pair(ph_curve_preimage(curve, before) + 2 * last));
  to = ph_cplx_mul(t->root, pair(ph_curve_preimage(curve, k)));
  return ph_cone_turn(ph_cplx_mul(from, from), ph_cplx_mul(to, to));
}

/* The preimage of segment k in the frame, up to a positive factor. */
static void preimage(const struct tree *t, size_t k, ph_cplx w[3]) {
  ph_seg2_preimage(t->curve, k, w);
  for (size_t i = 0; i < 3; i++) {
    w[i] = ph_cplx_mul(t->root, w[i]);
  }
}

/* The node of one segment, and of the joint before it. */
static struct node leaf(const struct tree *t, size_t k) {
  const double *p = ph_curve_points(t->curve, k);
  const size_t points = t->curve->degree + 1;
  ph_cplx w[3], q[POINTS_MAX] = {to_frame(t, p)};
  struct ph_cone cone, turn = joint(t, k);
  struct node node;
  preimage(t, k, w);
  for (size_t i = 1; i < points; i++) {
    q[i] = to_frame(t, p + 2 * i);
  }
  cone = ph_piece_cone(w);
  node.box = ph_box2_of(q, points);
  node.cone = ph_cone_join(&turn, &cone);
  return node;
}

static size_t children(const struct tree *t, struct place at,
                       struct place child[2]) {
  child[0] = (struct place){at.level - 1, 2 * at.i};
  child[1] = (struct place){at.level - 1, 2 * at.i + 1};
  return child[1].i << child[1].level < t->curve->n ? 2 : 1;
}

static struct node node_join(const struct node *a, const struct node *b) {
  struct node node;
  node.box = ph_box2_join(&a->box, &b->box);
  node.cone = ph_cone_join(&a->cone, &b->cone);
  return node;
}

/* More than what rounding to a float changes. */
static inline double float_rounding(double x) {
  return (double)FLT_EPSILON * fabs(x) + (double)FLT_MIN;
}

static struct stored stored_of(const struct node *node) {
  struct stored s = {.cone = node->cone};
  for (size_t i = 0; i < 2; i++) {
    const double low = node->box.low[i], high = node->box.high[i];
    s.low[i] = (float)(low - float_rounding(low));
    s.high[i] = (float)(high + float_rounding(high));
  }
  return s;
}

static struct node node_of(const struct tree *t, struct place at) {
  size_t k = at.i << at.level, end = k + ((size_t)1 << at.level);
  struct node node;
  if (at.level >= STORED) {
    const struct stored *s = &t->node[at.level][at.i];
    return (struct node){{{(double)s->low[0], (double)s->low[1]},
                          {(double)s->high[0], (double)s->high[1]}},
                         s->cone};
  }
  node = leaf(t, k++);
  for (; k < end && k < t->curve->n; k++) {
    struct node next = leaf(t, k);
    node = node_join(&node, &next);
  }
  return node;
}

static bool build(struct tree *t, struct ph_arena *scratch) {
  size_t n = t->curve->n, level = 0;
  for (; level == 0 || (n - 1) >> (level - 1) > 0; level++) {
    size_t count = ((n - 1) >> level) + 1;
    if (level < STORED) {
      continue;
    }
    t->node[level] = ph_arena_array(scratch, count, sizeof **t->node);
    if (!t->node[level]) {
      return false;
    }
    for (size_t i = 0; i < count; i++) {
      struct place child[2];
      size_t children_n = children(t, (struct place){level, i}, child);
      struct node node = node_of(t, child[0]);
      if (children_n == 2) {
        struct node second = node_of(t, child[1]);
        node = node_join(&node, &second);
      }
      if (level == STORED) {
        t->box = i > 0 ? ph_box2_join(&t->box, &node.box) : node.box;
      }
      t->node[level][i] = stored_of(&node);
    }
  }
  t->levels = level;
  return true;
}

/* ---- the search --------------------------------------------------------- */

/* Segments that meet themselves. */
static size_t loops(struct tree *t) {
  const struct ph_curve *curve = t->curve;
  size_t found = 0;
  for (size_t k = 0; k < curve->n; k++) {
    struct ph_seg2 seg;
    struct ph_meet meet = t->meet;
    /* The rest of a closed curve is wide unless there is none. */
    struct ph_cone outer =
        curve->n == 1 && curve->closed ? joint(t, 0) : PH_CONE_ALL;
    ph_cplx w[3];
    struct ph_piece piece;
    preimage(t, k, w);
    if (ph_seg2_moves_on(w)) {
      continue;
    }
    seg = seg_of(t, k);
    meet.found = ph_seg2_stands_still(&seg, &meet.u[0]);
    meet.u[1] = meet.u[0];
    meet.segment[0] = meet.segment[1] = k;
    meet.steps = LOOP_STEPS;
    if (!meet.found && !ph_seg2_is_monotone(seg.w)) {
      piece = ph_piece_of(&seg, k);
      ph_meet_self(&meet, &piece, &outer);
    }
    if (meet.found && found++ == 0) {
      t->meet = meet;
    }
  }
  return found;
}

static void search_segments(struct tree *t, size_t i, size_t j,
                            const struct ph_between *between) {
  struct ph_seg2 first = seg_of(t, i), second = seg_of(t, j);
  struct ph_piece a = ph_piece_of(&first, i), b = ph_piece_of(&second, j);
  struct ph_cone before_a = joint(t, i), before_b = joint(t, j);
  struct ph_between all;
  all.inner = ph_cone_join(&between->inner, &before_b);
  all.outer = ph_cone_join(&between->outer, &before_a);
  ph_meet_pair(&t->meet, &a, &b, &all);
}

static void search_pair(struct tree *t, struct place p, const struct node *a,
                        struct place q, const struct node *b,
                        const struct ph_between *between) {
  struct ph_between beside = *between;
  struct node half[2];
  struct place child[2];
  if (t->meet.found || ph_box2_apart(&a->box, &b->box, t->meet.tolerance) ||
      ph_between_narrow(between, &a->cone, &b->cone)) {
    return;
  }
  if (p.level == 0 && q.level == 0) {
    search_segments(t, p.i, q.i, between);
  } else if (q.level == 0 ||
             (p.level > 0 && ph_box2_size(&a->box) >= ph_box2_size(&b->box))) {
    size_t n = children(t, p, child);
    half[0] = node_of(t, child[0]);
    if (n == 2) {
      half[1] = node_of(t, child[1]);
      beside.outer = ph_cone_join(&between->outer, &half[0].cone);
      search_pair(t, child[1], &half[1], q, b, &beside);
      beside.outer = between->outer;
      beside.inner = ph_cone_join(&half[1].cone, &between->inner);
    }
    search_pair(t, child[0], &half[0], q, b, &beside);
  } else {
    size_t n = children(t, q, child);
    half[0] = node_of(t, child[0]);
    if (n == 2) {
      half[1] = node_of(t, child[1]);
      beside.inner = ph_cone_join(&between->inner, &half[0].cone);
      search_pair(t, p, a, child[1], &half[1], &beside);
      beside.inner = between->inner;
      beside.outer = ph_cone_join(&half[1].cone, &between->outer);
    }
    search_pair(t, p, a, child[0], &half[0], &beside);
  }
}

/* Single segments are left out: loops() has seen to them. */
static void search_self(struct tree *t, struct place p,
                        const struct ph_cone *outer) {
  struct node node = node_of(t, p), half[2];
  struct ph_between between = {PH_CONE_NONE, *outer};
  struct ph_cone rest;
  struct place child[2];
  if (t->meet.found || p.level == 0 || node.cone.kind == PH_CONE_NARROW) {
    return;
  }
  if (children(t, p, child) == 1) {
    search_self(t, child[0], outer);
    return;
  }
  half[0] = node_of(t, child[0]);
  half[1] = node_of(t, child[1]);
  rest = ph_cone_join(&half[1].cone, outer);
  search_self(t, child[0], &rest);
  rest = ph_cone_join(outer, &half[0].cone);
  search_self(t, child[1], &rest);
  search_pair(t, child[0], &half[0], child[1], &half[1], &between);
}

/* The tolerance, once the tree knows the curve's box. */
static void set_tolerance(struct tree *t, const struct ph_box2 *box) {
  double size =
      0.5 * hypot(box->high[0] - box->low[0], box->high[1] - box->low[1]);
  t->meet.tolerance = fmax(t->meet.tolerance, PH_CROSS_NEAR * size);
}

enum ph_status ph_cross_planar(const struct ph_curve *curve,
                               struct ph_arena *scratch, struct ph_cross *cross,
                               struct ph_diag *diag) {
  struct ph_mark mark = ph_arena_mark(scratch);
  struct tree t = {.curve = curve};
  struct place top;
  struct node all;
  struct ph_seg2 seg;
  if (!ph_quad_gauss(&t.rule, 12)) {
    return ph_fail_memory(diag);
  }
  if (!set_frame(&t)) {
    return ph_fail(diag, PH_E_NOT_FINITE, NULL, "the curve is not finite");
  }
  if (!build(&t, scratch)) {
    ph_arena_release(scratch, mark);
    return ph_fail_memory(diag);
  }
  top = (struct place){t.levels - 1, 0};
  all = node_of(&t, top);
  set_tolerance(&t, t.levels > STORED ? &t.box : &all.box);
  t.meet.rule = &t.rule;
  t.meet.steps = STEPS + STEPS_EACH * curve->n;
  *cross = (struct ph_cross){.loops = loops(&t)};
  search_self(&t, top, curve->closed ? &PH_CONE_NONE : &PH_CONE_ALL);
  ph_arena_release(scratch, mark);
  cross->simple = !t.meet.found;
  if (t.meet.found) {
    for (size_t i = 0; i < 2; i++) {
      cross->segment[i] = t.meet.segment[i];
      cross->u[i] = t.meet.u[i];
    }
    seg = ph_seg2_of(curve, cross->segment[0]);
    cross->point = ph_seg2_point(&seg, &t.rule, cross->u[0]);
  }
  return PH_OK;
}
