/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Strands of offsets (see strand.h). */
#include "curve/offset/strand.h"

#include "kernel/pi.h"

#include <string.h>

/* Of the size: a jump of the offset that is less comes of tolerances of joints,
 * and a distance that is less has no side. */
static const double JUMP = 1e-9, NOTHING = 1e-13;

/* A round join that turns by more is two of them. */
static const double TURN = PH_PI / 2 + 1e-9;

/* Strands at a corner, and around an end that nothing goes on from. */
enum { JOIN_MAX = 2, CIRCLE = 4 };

/* ---- the curve at unit scale ----------------------------------------------
 */

struct box {
  double low[2], high[2];
};

static struct box box_of(const struct ph_curve *curve) {
  struct box box = {{HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, -HUGE_VAL}};
  for (size_t i = 0; i < ph_curve_points_n(curve); i++) {
    for (size_t j = 0; j < 2; j++) {
      double x = curve->control_points[2 * i + j];
      box.low[j] = x < box.low[j] ? x : box.low[j];
      box.high[j] = x > box.high[j] ? x : box.high[j];
    }
  }
  return box;
}

/* Segment k of the given curve as segment k or, reversed, 2n - 1 - k. */
static void copy_segment(const struct ph_strands *strands,
                         const struct ph_curve *from, size_t k, bool back) {
  const struct ph_curve *to = &strands->curve;
  const size_t at = back ? 2 * strands->n - 1 - k : k, last = from->degree;
  const size_t w_n = from->preimage.n;
  const struct ph_pow2 unit = ph_pow2_of(-strands->exponent);
  const struct ph_pow2 root = ph_pow2_of(-strands->exponent / 2);
  const double *p = ph_curve_points(from, k), *w = ph_curve_preimage(from, k);
  double *q = to->control_points + 2 * (last + 1) * at;
  double *v = to->preimage.v + 2 * w_n * at;
  for (size_t i = 0; i <= last; i++) {
    const double *of = p + 2 * (back ? last - i : i);
    q[2 * i] = ph_pow2_apply(unit, of[0] - strands->center.re);
    q[2 * i + 1] = ph_pow2_apply(unit, of[1] - strands->center.im);
  }
  for (size_t i = 0; i < w_n; i++) {
    const double *of = w + 2 * (back ? w_n - 1 - i : i);
    v[2 * i] = ph_pow2_apply(root, back ? -of[1] : of[0]);
    v[2 * i + 1] = ph_pow2_apply(root, back ? of[0] : of[1]);
  }
  if (from->preimage.alpha) {
    to->preimage.alpha[at] = from->preimage.alpha[k];
  }
}

static enum ph_status copy_curve(struct ph_strands *strands,
                                 const struct ph_curve *from, bool twice,
                                 struct ph_diag *diag) {
  const struct box box = box_of(from);
  const double side = fmax(box.high[0] - box.low[0], box.high[1] - box.low[1]);
  struct ph_curve *to = &strands->curve;
  enum ph_status status;
  *to = *from;
  to->n = (twice ? 2 : 1) * from->n;
  to->joined = false;
  to->knots = NULL;
  strands->n = from->n;
  strands->center = ph_cplx_of(box.low[0] + (box.high[0] - box.low[0]) / 2,
                               box.low[1] + (box.high[1] - box.low[1]) / 2);
  strands->exponent = side > 0 ? 2 * (ph_pow2_exponent(side) / 2) : 0;
  strands->distance = ldexp(strands->distance, -strands->exponent);
  strands->size = ldexp(side, -strands->exponent) + fabs(strands->distance);
  status = ph_curve_alloc(to, strands->arena, diag);
  for (size_t k = 0; status == PH_OK && k < from->n; k++) {
    copy_segment(strands, from, k, false);
    if (twice) {
      copy_segment(strands, from, k, true);
    }
  }
  return status;
}

/* ---- strands --------------------------------------------------------------
 */

struct maker {
  struct ph_strands *strands;
  double miter; /* the limit; 0: all joins are round */
  bool passive;
};

/* The unit w at an end of a segment, and the point there. */
static ph_cplx root_at(const struct ph_curve *curve, size_t k, bool end) {
  const double *w = ph_curve_preimage(curve, k);
  const double *of = end ? w + 2 * (curve->preimage.n - 1) : w;
  const double scale = 1 / hypot(of[0], of[1]);
  return ph_cplx_of(scale * of[0], scale * of[1]);
}

static ph_cplx point_at(const struct ph_curve *curve, size_t k, bool end) {
  const double *p = ph_curve_points(curve, k) + (end ? 2 * curve->degree : 0);
  return ph_cplx_of(p[0], p[1]);
}

static size_t add(struct maker *m, struct ph_strand strand) {
  struct ph_strands *strands = m->strands;
  strand.passive = m->passive;
  strand.next = PH_NO_STRAND;
  strands->v[strands->strands_n] = strand;
  return strands->strands_n++;
}

static ph_cplx unit(ph_cplx a) {
  return ph_cplx_scale(1 / ph_cplx_abs(a), a);
}

static ph_cplx beside(const struct maker *m, ph_cplx point, ph_cplx w) {
  const ph_cplx t = ph_cplx_mul(w, w);
  const double d = m->strands->distance;
  return ph_cplx_of(point.re - d * t.im, point.im + d * t.re);
}

/* A join of one strand, or two, from unit w `a` to `b`; ret the last one. */
static size_t join(struct maker *m, size_t from, size_t corner, ph_cplx point,
                   ph_cplx a, ph_cplx b) {
  const double angle = 2 * atan2(ph_cplx_cross(a, b), ph_cplx_dot(a, b));
  const double limit = m->miter, c = cos(angle / 2);
  const ph_cplx middle = unit(ph_cplx_add(a, b));
  const ph_cplx tip = beside(m, point, middle);
  struct ph_strand s = {
      .kind = PH_STRAND_ROUND, .at = corner, .point = point, .angle = angle};
  if (limit > 0 && limit * c >= 1) {
    const ph_cplx away = ph_cplx_sub(tip, point);
    s.kind = PH_STRAND_LINE;
    s.angle = 0;
    for (size_t i = 0; i < 2; i++) {
      const ph_cplx to = ph_cplx_add(point, ph_cplx_scale(1 / c, away));
      s.w[0] = s.w[1] = i ? b : a;
      s.line[0] = i ? to : beside(m, point, a);
      s.line[1] = i ? beside(m, point, b) : to;
      m->strands->v[from].next = m->strands->strands_n;
      from = add(m, s);
    }
  } else {
    const bool two = fabs(angle) > TURN;
    for (size_t i = 0; i < (two ? 2 : 1); i++) {
      s.w[0] = i ? middle : a;
      s.w[1] = two && i == 0 ? middle : b;
      m->strands->v[from].next = m->strands->strands_n;
      from = add(m, s);
    }
  }
  return from;
}

/* The corner of the given curve between segments k and l, which it is before:
 * n after the last one of an open curve. */
static size_t corner_of(const struct ph_strands *strands, size_t k, size_t l) {
  const size_t n = strands->n;
  const size_t before = k < n ? k + 1 : l < n ? 0 : l == n ? n : 2 * n - l;
  return strands->curve.closed ? before % n : before;
}

/* What is between two segments, of strands `from` and, unless it is the next
 * one that is added, `to`: nothing, a join, or a corner where nothing goes on.
 * around: it is an end of the given curve. */
static void connect(struct maker *m, size_t from, size_t k, size_t to, size_t l,
                    bool around) {
  struct ph_strands *strands = m->strands;
  const struct ph_curve *c = &strands->curve;
  const double d = strands->distance;
  ph_cplx a = root_at(c, k, true), b = root_at(c, l, false);
  double angle;
  if (ph_cplx_dot(a, b) < 0) {
    b = ph_cplx_scale(-1, b);
  }
  angle = 2 * atan2(ph_cplx_cross(a, b), ph_cplx_dot(a, b));
  if (around || !(fabs(fabs(angle) - PH_PI) > 1e-9)) {
    const double side = d > 0 ? -1 : 1; /* it turns the longer way round */
    b = ph_cplx_of(-side * a.im, side * a.re);
    angle = side * PH_PI;
  }
  if (!(fabs(d * angle) > JUMP * strands->size)) {
    strands->v[from].next = to != PH_NO_STRAND ? to : strands->strands_n;
  } else if (d * angle < 0) {
    const size_t at = corner_of(strands, k, l);
    const size_t last = join(m, from, at, point_at(c, k, true), a, b);
    strands->v[last].next = to != PH_NO_STRAND ? to : strands->strands_n;
  }
}

/* A chain of segments first .. first + n - 1. */
static void chain(struct maker *m, size_t first, size_t n, bool closed) {
  const size_t given = m->strands->n, begin = m->strands->strands_n;
  size_t at = begin;
  for (size_t k = first; k < first + n; k++) {
    if (k > first) {
      connect(m, at, k - 1, PH_NO_STRAND, k, k == given && n > given);
    }
    at = add(m, (struct ph_strand){.kind = PH_STRAND_SEGMENT, .at = k});
  }
  if (closed) {
    connect(m, at, first + n - 1, begin, first, n > given);
  }
}

/* The circle around an end: passive. */
static void circle(struct maker *m, size_t k, bool end) {
  const struct ph_curve *c = &m->strands->curve;
  const double side = m->strands->distance > 0 ? -1 : 1;
  const ph_cplx step = ph_cplx_polar(side * PH_PI / CIRCLE);
  const size_t begin = m->strands->strands_n;
  struct ph_strand s = {.kind = PH_STRAND_ROUND,
                        .at = end ? k + 1 : k,
                        .point = point_at(c, k, end),
                        .angle = side * 2 * PH_PI / CIRCLE};
  s.w[1] = root_at(c, k, end);
  for (size_t i = 0; i < CIRCLE; i++) {
    s.w[0] = s.w[1];
    s.w[1] = ph_cplx_mul(step, s.w[0]);
    m->strands->v[add(m, s)].next = begin + (i + 1) % CIRCLE;
  }
}

/* Whether what is of such a size has an area, with room for its parts. */
static bool has_area(double size) {
  return isfinite(256 * size * size);
}

enum ph_status ph_strands_of(const struct ph_curve *curve, double distance,
                             const struct ph_offset_rules *rules, bool crosses,
                             struct ph_arena *arena, struct ph_strands *strands,
                             struct ph_diag *diag) {
  const bool trim = rules->mode == PH_OFFSET_TRIMMED, closed = curve->closed;
  const bool both = closed ? rules->both : rules->round_ends;
  const bool miter = rules->miter > 0; /* a tip may be beyond the curve */
  const bool bounds = trim && !both && (!closed || crosses || miter);
  const size_t n = curve->n;
  struct maker m = {strands, rules->miter, false};
  enum ph_status status;
  *strands = (struct ph_strands){.distance = both ? -fabs(distance) : distance,
                                 .both = both,
                                 .has_inside = closed && !both && !crosses,
                                 .effort = rules->effort,
                                 .arena = arena};
  status = copy_curve(strands, curve, both || bounds, diag);
  if (status != PH_OK) {
    return status;
  }
  if (!(fabs(strands->distance) > NOTHING * strands->size)) {
    return ph_fail(diag, PH_E_BAD_VALUE, NULL,
                   "the distance %g of a joined or trimmed offset is too small "
                   "beside the size of the curve",
                   distance);
  }
  if (!has_area(strands->size) ||
      !has_area(ldexp(strands->size, strands->exponent))) {
    return ph_fail(diag, PH_E_TOO_LARGE, NULL,
                   "the area of the offset at distance %g exceeds the range "
                   "of a double",
                   distance);
  }
  strands->v =
      ph_arena_array(arena, (1 + JOIN_MAX) * strands->curve.n + 2 * CIRCLE,
                     sizeof *strands->v);
  if (!strands->v) {
    return ph_fail_memory(diag);
  }
  if (both && !closed) {
    chain(&m, 0, 2 * n, true);
    return PH_OK;
  }
  chain(&m, 0, n, closed);
  if (both || bounds) {
    m.passive = bounds;
    m.miter = strands->has_inside ? 0 : m.miter; /* there nothing is kept */
    chain(&m, n, n, closed);
  }
  if (bounds && !closed) {
    circle(&m, 0, false);
    circle(&m, n - 1, true);
  }
  return PH_OK;
}

size_t ph_strand_foot(const struct ph_strands *strands, size_t strand, double u,
                      double *foot) {
  const struct ph_strand *s = &strands->v[strand];
  const size_t n = strands->n;
  if (s->kind != PH_STRAND_SEGMENT) {
    *foot = s->at < n ? 0 : 1;
    return s->at < n ? s->at : n - 1;
  }
  *foot = s->at < n ? u : 1 - u;
  return s->at < n ? s->at : 2 * n - 1 - s->at;
}

/* ---- places ---------------------------------------------------------------
 */

void ph_strand_enter(struct ph_strand_eval *eval,
                     const struct ph_strands *strands, size_t strand) {
  const struct ph_strand *s = &strands->v[strand];
  if (eval->of == s) {
    return;
  }
  eval->of = s;
  eval->distance = strands->distance;
  if (s->kind == PH_STRAND_SEGMENT) {
    struct ph_fast3_place left, right;
    ph_fast3_of(&strands->curve, s->at, &eval->fast);
    left = ph_fast3_from(&eval->fast, 0, 0.5);
    right = ph_fast3_from(&eval->fast, 1, -0.5);
    eval->whole = ph_fast3_integral(&left, left.end->s) -
                  ph_fast3_integral(&right, right.end->s);
  }
}

static struct ph_spot spot_of_join(const struct ph_strand *s, double distance,
                                   double u) {
  struct ph_spot at = {.r = s->point};
  const ph_cplx across = ph_cplx_sub(s->w[1], s->w[0]);
  ph_cplx n;
  at.w = ph_cplx_between(s->w[0], s->w[1], u);
  if (s->kind == PH_STRAND_LINE) {
    at.o = ph_cplx_between(s->line[0], s->line[1], u);
    at.rate = ph_cplx_abs(ph_cplx_sub(s->line[1], s->line[0]));
    at.s = u * at.rate;
    return at;
  }
  n = ph_spot_normal(&at);
  at.o = ph_cplx_add(at.r, ph_cplx_scale(distance, n));
  at.bend = 2 * ph_cplx_cross(at.w, across) / ph_cplx_norm2(at.w);
  at.rate = -distance * at.bend;
  return at;
}

struct ph_spot ph_strand_spot(const struct ph_strand_eval *eval, double u) {
  const struct ph_fast3 *fast = &eval->fast;
  struct ph_fast3_place place;
  struct ph_spot at;
  ph_quat a, first;
  ph_vec3 r;
  double norm2, s;
  if (eval->of->kind != PH_STRAND_SEGMENT) {
    return spot_of_join(eval->of, eval->distance, u);
  }
  place = ph_fast3_at(fast, u);
  a = ph_fast3_preimage(&place);
  first = ph_fast3_first(&place);
  r = ph_fast3_point(fast, &place);
  at.r = ph_cplx_of(r.x, r.y);
  at.w = ph_cplx_of(a.u, a.q);
  norm2 = ph_cplx_norm2(at.w);
  s = ph_fast3_integral(&place, place.end->s);
  s += u > 0.5 ? eval->whole : 0;
  at.s = ph_pow2_apply(fast->grow, s);
  at.speed = ph_pow2_apply(fast->grow, norm2);
  at.bend = 2 * ph_cplx_cross(at.w, ph_cplx_of(first.u, first.q)) / norm2;
  at.rate = at.speed - eval->distance * at.bend;
  at.o = ph_cplx_add(at.r, ph_cplx_scale(eval->distance, ph_spot_normal(&at)));
  return at;
}
