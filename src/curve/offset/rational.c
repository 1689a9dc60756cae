/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Pieces of PH curves with positive weights (see rational.h). */
#include "curve/offset/rational.h"

#include "curve/segment/seg3.h"
#include "curve/segment/tc.h"
#include "kernel/bern.h"
#include "kernel/pow2.h"

/* Halvings of a quintic before its speed counts as zero: 2^-20 of a segment is
 * below any feature that its control points can describe. */
enum { HALVINGS_MAX = 20 };

/* binomial(4,j) binomial(5,i) / binomial(9,j+i) for j = 0..4, i = 0..5: the
 * product of Bernstein forms of degrees 4 and 5. */
static const double QUINTIC[5 * 6] = {
    1.0,       5.0 / 9,    10.0 / 36,  10.0 / 84,  5.0 / 126,  1.0 / 126,
    4.0 / 9,   20.0 / 36,  40.0 / 84,  40.0 / 126, 20.0 / 126, 4.0 / 84,
    6.0 / 36,  30.0 / 84,  60.0 / 126, 60.0 / 126, 30.0 / 84,  6.0 / 36,
    4.0 / 84,  20.0 / 126, 40.0 / 126, 40.0 / 84,  20.0 / 36,  4.0 / 9,
    1.0 / 126, 5.0 / 126,  10.0 / 84,  10.0 / 36,  5.0 / 9,    1.0,
};

/* binomial(2,j) binomial(3,i) / binomial(5,j+i): of degrees 2 and 3.  Tested by
 * t_offset.c, against points at the distance along the normal. */
static const double CUBIC[3 * 4] = {
    1.0,      3.0 / 5,  3.0 / 10, 1.0 / 10, /* j = 0 */
    2.0 / 5,  6.0 / 10, 6.0 / 10, 2.0 / 5,  /* 1 */
    1.0 / 10, 3.0 / 10, 3.0 / 5,  1.0,      /* 2 */
};

/* Part of a segment: preimage A = a[0] + a[1] j, points p[0] and, along z, the
 * real parts of p[1]. */
struct piece {
  ph_cplx a[2][3], p[2][6];
  double from, to; /* in the segment's parameter */
};

struct walk {
  size_t degree, segment;
  ph_rational_visit *visit;
  void *context;
};

static struct piece segment_of(const struct ph_curve *curve, size_t k) {
  struct ph_seg3 seg = ph_seg3_of(curve, k);
  size_t dimension = curve->dimension;
  const double *p = ph_curve_points(curve, k);
  struct piece piece = {.from = 0, .to = 1};
  if (curve->preimage.n == 2) {
    seg.a[1] = seg.a[2];
  }
  ph_seg3_pair(&seg, piece.a);
  for (size_t i = 0; i <= curve->degree; i++) {
    ph_vec3 at = ph_vec3_get(p + dimension * i, dimension);
    piece.p[0][i] = ph_cplx_of(at.x, at.y);
    piece.p[1][i] = ph_cplx_of(at.z, 0);
  }
  return piece;
}

/* Coefficients of sigma at the degree of what is written, times 1/unit; false
 * unless all > 0. */
static bool set_weights(struct ph_rational *r) {
  const size_t n = r->degree;
  bool positive = true;
  for (size_t k = 0; k < 2 * n; k++) {
    r->weight[k] = 0;
  }
  for (size_t j = 0; j < n; j++) {
    r->speed[j] /= r->unit;
    for (size_t i = 0; i <= n; i++) {
      r->weight[j + i] += r->product[(n + 1) * j + i] * r->speed[j];
    }
  }
  for (size_t k = 0; k < 2 * n; k++) {
    positive = positive && r->weight[k] > 0;
  }
  return positive;
}

/* Coefficients of sigma; `whole` unless the piece ends at the vertex. */
static void set_speed(struct ph_rational *r, bool whole) {
  const ph_quat *a = r->a;
  if (r->degree == 5) {
    ph_seg3_speed(a, r->speed);
  } else {
    r->speed[0] = ph_quat_dot(a[0], a[0]);
    r->speed[2] = ph_quat_dot(a[1], a[1]);
    r->speed[1] =
        whole ? ph_quat_dot(a[0], a[1]) : fmin(r->speed[0], r->speed[2]);
  }
  r->unit = 0;
  for (size_t j = 0; j < r->degree; j++) {
    r->unit = r->speed[j] > r->unit ? r->speed[j] : r->unit;
  }
}

/* A cubic smaller by 2^exponent, so that w is at unit scale. */
static struct ph_tc cubic_of(const struct piece *piece, int *exponent) {
  struct ph_tc tc = {{{0, 0}, {0, 0}}};
  double largest = 0;
  for (size_t i = 0; i < 2; i++) {
    tc.w[i] = ph_cplx_of(piece->a[0][i].re, piece->a[1][i].im);
    largest = fmax(largest, fmax(fabs(tc.w[i].re), fabs(tc.w[i].im)));
  }
  *exponent = largest > 0 ? ph_pow2_exponent(largest) : 0;
  for (size_t i = 0; i < 2; i++) {
    tc.w[i] = ph_cplx_scale(ldexp(1, -*exponent), tc.w[i]);
  }
  return tc;
}

/* The foot of the origin on the line of w: what w0 and w1 have in common across
 * it. */
static ph_cplx foot_of(const struct ph_tc *tc) {
  ph_cplx along = ph_cplx_sub(tc->w[1], tc->w[0]);
  return ph_cplx_scale(ph_cplx_cross(tc->w[0], tc->w[1]) / ph_cplx_norm2(along),
                       ph_cplx_of(along.im, -along.re));
}

/* Cuts a piece in two; false where a cubic has no vertex within. */
static bool cut(const struct piece *piece, size_t degree, struct piece *left,
                struct piece *right) {
  int exponent;
  const struct ph_tc tc = cubic_of(piece, &exponent);
  const double u = degree == 5 ? 0.5 : ph_tc_vertex(&tc);
  for (size_t i = 0; i < 2; i++) {
    ph_bern_cut(piece->a[i], (degree - 1) / 2, u, left->a[i], right->a[i]);
    ph_bern_cut(piece->p[i], degree, u, left->p[i], right->p[i]);
  }
  if (degree == 3) {
    ph_cplx foot = ph_cplx_scale(ldexp(1, exponent), foot_of(&tc));
    left->a[0][1] = right->a[0][0] = ph_cplx_of(foot.re, 0);
    left->a[1][1] = right->a[1][0] = ph_cplx_of(0, foot.im);
  }
  left->from = piece->from;
  right->to = piece->to;
  left->to = right->from = piece->from + u * (piece->to - piece->from);
  return u > 0 && u < 1;
}

/* Visits the piece, or its parts; PH_E_INFEASIBLE if the speed vanishes in it,
 * PH_E_TOO_LARGE if it leaves the range of a double. */
static enum ph_status visit(const struct walk *walk, const struct piece *piece,
                            int depth) {
  const bool quintic = walk->degree == 5;
  const int depth_max = quintic ? HALVINGS_MAX : 1;
  struct ph_rational r = {.degree = walk->degree,
                          .segment = walk->segment,
                          .from = piece->from,
                          .to = piece->to,
                          .product = quintic ? QUINTIC : CUBIC};
  struct piece left = *piece, right = *piece;
  enum ph_status status;
  for (size_t i = 0; i < 3; i++) {
    ph_cplx uv = piece->a[0][i], pq = piece->a[1][i];
    r.a[i] = ph_quat_of(uv.re, uv.im, pq.re, pq.im);
  }
  set_speed(&r, depth == 0);
  if (!(r.unit > 0) || !isfinite(r.unit)) {
    return r.unit > 0 ? PH_E_TOO_LARGE : PH_E_INFEASIBLE;
  }
  if (set_weights(&r)) {
    for (size_t i = 0; i <= r.degree; i++) {
      ph_cplx xy = piece->p[0][i];
      r.p[i] = ph_vec3_of(xy.re, xy.im, piece->p[1][i].re);
    }
    walk->visit(walk->context, &r);
    return PH_OK;
  }
  if (depth == depth_max || !cut(piece, walk->degree, &left, &right)) {
    return PH_E_INFEASIBLE;
  }
  status = visit(walk, &left, depth + 1);
  return status == PH_OK ? visit(walk, &right, depth + 1) : status;
}

/* Whether the curve stands still in a cubic, to rounding, that the weights of
 * its two parts cannot tell from a turn on the spot. */
static bool rests(const struct piece *piece) {
  int exponent;
  const struct ph_tc tc = cubic_of(piece, &exponent);
  return !ph_tc_is_regular(&tc);
}

enum ph_status ph_rational_walk(const struct ph_curve *curve, size_t first,
                                size_t end, const char *what,
                                ph_rational_visit *each, void *context,
                                struct ph_diag *diag) {
  struct walk walk = {curve->degree, 0, each, context};
  for (size_t k = first; k < end; k++) {
    struct piece piece = segment_of(curve, k);
    enum ph_status status;
    walk.segment = k;
    status = curve->degree == 3 && rests(&piece) ? PH_E_INFEASIBLE
                                                 : visit(&walk, &piece, 0);
    if (status != PH_OK) {
      return ph_fail_at(diag, status, "segments", k,
                        status == PH_E_TOO_LARGE
                            ? "has no %s: its speed exceeds the range of a "
                              "double"
                            : "has no %s: the curve stands still in it and has "
                              "no normal there",
                        what);
    }
  }
  return PH_OK;
}

enum ph_status ph_rational_part(const struct ph_curve *curve, size_t k,
                                double from, double to, ph_rational_visit *each,
                                void *context) {
  const struct walk walk = {curve->degree, k, each, context};
  struct piece piece = segment_of(curve, k), left = piece, right = piece;
  for (size_t i = 0; i < 2 && (from > 0 || to < 1); i++) {
    ph_bern_cut(piece.a[i], (walk.degree - 1) / 2, to, left.a[i], right.a[i]);
    ph_bern_cut(left.a[i], (walk.degree - 1) / 2, from / to, right.a[i],
                piece.a[i]);
    ph_bern_cut(piece.p[i], walk.degree, to, left.p[i], right.p[i]);
    ph_bern_cut(left.p[i], walk.degree, from / to, right.p[i], piece.p[i]);
  }
  piece.from = from;
  piece.to = to;
  return visit(&walk, &piece, 0);
}

enum ph_status ph_rational_arc(size_t degree, ph_cplx point, const ph_cplx w[2],
                               ph_rational_visit *each, void *context) {
  const struct walk walk = {degree, 0, each, context};
  struct piece piece = {.from = 0, .to = 1};
  const size_t last = (degree - 1) / 2;
  for (size_t i = 0; i <= last; i++) {
    const ph_cplx at = ph_cplx_between(w[0], w[1], (double)i / (double)last);
    piece.a[0][i] = ph_cplx_of(at.re, 0);
    piece.a[1][i] = ph_cplx_of(0, at.im);
  }
  for (size_t i = 0; i <= degree; i++) {
    piece.p[0][i] = point;
    piece.p[1][i] = ph_cplx_of(0, 0);
  }
  return visit(&walk, &piece, 0);
}

/* Numerators over weights, relative to the first point so that coordinates far
 * from the origin keep their digits. */
void ph_rational_points(const struct ph_rational *piece, enum ph_normal normal,
                        double distance, size_t dimension, double *p,
                        double *weights) {
  const size_t degree = piece->degree;
  ph_vec3 move[5], sum[10] = {{0, 0, 0}};
  ph_rational_turned(normal, piece->a, (degree + 1) / 2, 1, move);
  for (size_t j = 0; j < degree; j++) {
    ph_vec3 g = ph_vec3_scale(distance / piece->unit, move[j]);
    for (size_t i = 0; i <= degree; i++) {
      ph_vec3 leg = ph_vec3_sub(piece->p[i], piece->p[0]);
      ph_vec3 term = ph_vec3_along(g, piece->speed[j], leg);
      sum[j + i] =
          ph_vec3_along(sum[j + i], piece->product[(degree + 1) * j + i], term);
    }
  }
  for (size_t k = 0; k < 2 * degree; k++) {
    double w = piece->weight[k];
    ph_vec3 from_p0 = ph_vec3_of(sum[k].x / w, sum[k].y / w, sum[k].z / w);
    ph_vec3_put(ph_vec3_add(piece->p[0], from_p0), dimension,
                p + dimension * k);
    weights[k] = w * piece->unit;
  }
}

void ph_rational_turned(enum ph_normal normal, const ph_quat *a, size_t n,
                        double c, ph_vec3 *out) {
  out[0] = ph_normal_between(normal, a[0], a[0]);
  out[1] = ph_normal_between(normal, a[0], a[1]);
  if (n == 3) {
    ph_quat m = ph_quat_scale(c, a[1]);
    ph_vec3 square = ph_normal_between(normal, m, m);
    out[2] = ph_vec3_scale(1 / (2 * c * c + 1),
                           ph_vec3_add(ph_vec3_scale(2, square),
                                       ph_normal_between(normal, a[0], a[2])));
    out[3] = ph_normal_between(normal, a[1], a[2]);
  }
  out[2 * n - 2] = ph_normal_between(normal, a[n - 1], a[n - 1]);
}
