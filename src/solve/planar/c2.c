/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The C2 equations of planar PH quintic splines (c2.h): their rows,
 * starting values, and damped Newton iteration.  Every pass is O(n).
 *
 * Starting values [GON18, (2.32)-(2.34), with the factor 1/h that the printed
 * form lacks].  A segment's derivative at its middle is known approximately:
 * from the chord, c/h, or from a cubic spline.  Its square root is w(1/2),
 * which is linear in the unknowns.  Signs are chosen so that w turns by at
 * most a quarter turn from each middle to the next.
 */
#include "solve/planar/c2.h"

#include <math.h>

/* Below this, |Re| of two unit vectors' product counts as exactly opposite
 * directions: rounding of the data turns by about 1e-16 / chord. */
static const double OPPOSITE = 1e-12;

size_t ph_planar_unknowns(const struct ph_planar_c2 *c2) {
  return c2->closed ? c2->n : c2->n + 2;
}

/* The unknowns next to that of segment k. */
struct neighbours {
  ph_cplx before, here, after;
};

static inline struct neighbours neighbours_of(const struct ph_planar_c2 *c2,
                                              const ph_cplx *b, size_t k) {
  struct neighbours s;
  if (!c2->closed) {
    s.before = b[k];
    s.here = b[k + 1];
    s.after = b[k + 2];
    return s;
  }
  s.here = b[k];
  s.before =
      k > 0 ? b[k - 1] : ph_cplx_mul(ph_cplx_conj(c2->twist), b[c2->n - 1]);
  s.after = k + 1 < c2->n ? b[k + 1] : ph_cplx_mul(c2->twist, b[0]);
  return s;
}

void ph_planar_preimage(const struct ph_planar_c2 *c2, const ph_cplx *b,
                        size_t k, ph_cplx w[3]) {
  struct neighbours s = neighbours_of(c2, b, k);
  w[0] = ph_planar_at_knot(c2->y[k], s.before, s.here);
  w[1] = s.here;
  w[2] = ph_planar_at_knot(c2->y[k + 1], s.here, s.after);
}

/* The unknowns as one for each segment. */
static inline const ph_cplx *of_segments(const struct ph_planar_c2 *c2,
                                         const ph_cplx *b) {
  return c2->closed ? b : b + 1;
}

/* Moves w from segment k - 1 to segment k, which is not the last one of a
 * closed curve. */
static inline void advance(const struct ph_planar_c2 *c2, const ph_cplx *mine,
                           size_t k, ph_cplx w[3]) {
  w[0] = w[2];
  w[1] = mine[k];
  w[2] = ph_planar_at_knot(c2->y[k + 1], mine[k], mine[k + 1]);
}

/* Derivatives of F[k] with respect to w0, w1, w2, and F[k] itself, which is
 * half their sum times the w (F is quadratic), less the chord's direction. */
struct equation {
  ph_cplx g0, g1, g2, f;
};

static inline struct equation equation_of(const struct ph_planar_c2 *c2,
                                          size_t k, const ph_cplx w[3]) {
  const double *e = ph_planar_space(c2, k)->q;
  double s = c2->ratio[k];
  struct equation q;
  ph_cplx sum;
  q.g0.re = s * (2 * e[0] * w[0].re + e[1] * w[1].re + e[3] * w[2].re);
  q.g0.im = s * (2 * e[0] * w[0].im + e[1] * w[1].im + e[3] * w[2].im);
  q.g1.re = s * (e[1] * (w[0].re + w[2].re) + 2 * e[2] * w[1].re);
  q.g1.im = s * (e[1] * (w[0].im + w[2].im) + 2 * e[2] * w[1].im);
  q.g2.re = s * (2 * e[0] * w[2].re + e[1] * w[1].re + e[3] * w[0].re);
  q.g2.im = s * (2 * e[0] * w[2].im + e[1] * w[1].im + e[3] * w[0].im);
  sum = ph_cplx_add(ph_cplx_mul(q.g0, w[0]), ph_cplx_mul(q.g1, w[1]));
  sum = ph_cplx_add(sum, ph_cplx_mul(q.g2, w[2]));
  q.f = ph_cplx_sub(ph_cplx_scale(0.5, sum), c2->direction[k]);
  return q;
}

/* Adds one equation's residual to the measure. */
static inline void measure_add(struct ph_planar_measure *m, size_t k,
                               ph_cplx f) {
  double f2 = ph_cplx_norm2(f);
  m->sum2 += f2;
  if (!(f2 <= m->max2)) {
    m->max2 = f2;
    m->worst = k;
  }
}

/* The end equation (w^2 - d)/|d| = 0 at side 0 or 1, as a row. */
static struct ph_tri_row end_row(const struct ph_planar_c2 *c2,
                                 const ph_cplx *b, int side,
                                 struct ph_planar_measure *m) {
  const ph_cplx *pair = side ? b + c2->n : b;
  ph_cplx w = ph_planar_at_knot(0.5, pair[0], pair[1]);
  double size = c2->end_size[side];
  ph_cplx g = ph_cplx_scale(1 / size, w); /* 2 w / size times the weight 1/2 */
  ph_cplx f =
      ph_cplx_sub(ph_cplx_scale(1 / size, ph_cplx_mul(w, w)), c2->end[side]);
  const ph_cplx zero = {0, 0};
  struct ph_tri_row row = {side ? g : zero, g, side ? zero : g, f};
  measure_add(m, side ? c2->n - 1 : 0, f);
  return row;
}

/* The equation of segment k as a row. */
static inline struct ph_tri_row segment_row(const struct ph_planar_c2 *c2,
                                            size_t k, const ph_cplx w[3],
                                            struct ph_planar_measure *m) {
  struct equation q = equation_of(c2, k, w);
  double left = c2->y[k], right = c2->y[k + 1];
  struct ph_tri_row row;
  row.lo = ph_cplx_scale(left, q.g0);
  row.up = ph_cplx_scale(1 - right, q.g2);
  row.di.re = q.g0.re - row.lo.re + q.g1.re + right * q.g2.re;
  row.di.im = q.g0.im - row.lo.im + q.g1.im + right * q.g2.im;
  row.f = q.f;
  measure_add(m, k, q.f);
  return row;
}

/* Rows 0 and n-1 of a closed curve carry the twist in their corner entries. */
static struct ph_tri_row corner_row(const struct ph_planar_c2 *c2,
                                    const ph_cplx *b, size_t k,
                                    struct ph_planar_measure *m) {
  ph_cplx w[3];
  struct ph_tri_row row;
  ph_planar_preimage(c2, b, k, w);
  row = segment_row(c2, k, w, m);
  if (k == 0) {
    row.lo = ph_cplx_mul(ph_cplx_conj(c2->twist), row.lo);
  } else {
    row.up = ph_cplx_mul(c2->twist, row.up);
  }
  return row;
}

struct ph_tri_row ph_planar_row(const struct ph_planar_c2 *c2, const ph_cplx *b,
                                size_t i) {
  struct ph_planar_measure m = {0, 0, 0};
  ph_cplx w[3];
  if (c2->closed && (i == 0 || i == c2->n - 1)) {
    return corner_row(c2, b, i, &m);
  }
  if (!c2->closed && (i == 0 || i == c2->n + 1)) {
    return end_row(c2, b, i ? 1 : 0, &m);
  }
  i -= c2->closed ? 0 : 1;
  ph_planar_preimage(c2, b, i, w);
  return segment_row(c2, i, w, &m);
}

struct ph_planar_form ph_planar_form(const struct ph_planar_c2 *c2, size_t i) {
  struct ph_planar_form f = {0, 0, 0, 0, 0, 0, {0, 0}};
  const struct ph_atph *space;
  double s, left, right;
  if (!c2->closed && (i == 0 || i == c2->n + 1)) {
    int side = i ? 1 : 0;
    f.mm = 0.25 / c2->end_size[side];
    *(side ? &f.lm : &f.mr) = 2 * f.mm;
    *(side ? &f.ll : &f.rr) = f.mm;
    f.wanted = c2->end[side];
    return f;
  }
  i -= c2->closed ? 0 : 1;
  space = ph_planar_space(c2, i);
  s = c2->ratio[i];
  left = c2->y[i];
  right = c2->y[i + 1];
  f.ll = s * space->q[0] * left * left;
  f.lm = s * left *
         (2 * space->q[0] * (1 - left) + space->q[1] + space->q[3] * right);
  f.mm = s * (space->q[0] * ((1 - left) * (1 - left) + right * right) +
              space->q[1] * (1 - left + right) + space->q[2] +
              space->q[3] * (1 - left) * right);
  f.lr = s * space->q[3] * left * (1 - right);
  f.mr = s * (1 - right) *
         (2 * space->q[0] * right + space->q[1] + space->q[3] * (1 - left));
  f.rr = s * space->q[0] * (1 - right) * (1 - right);
  f.wanted = c2->direction[i];
  return f;
}

struct ph_planar_measure ph_planar_newton_step(const struct ph_planar_c2 *c2,
                                               const ph_cplx *b,
                                               struct ph_tri *tri,
                                               ph_cplx *step) {
  struct ph_planar_measure m = {0, 0, 0};
  const ph_cplx *mine = of_segments(c2, b);
  size_t first = c2->closed ? 1 : 0, end = c2->closed ? c2->n - 1 : c2->n;
  ph_cplx w[3];
  if (c2->closed) {
    struct ph_tri_row row = corner_row(c2, b, 0, &m);
    ph_tri_begin(tri, c2->n, row, corner_row(c2, b, c2->n - 1, &m));
  } else {
    struct ph_tri_row row = end_row(c2, b, 0, &m);
    ph_tri_begin(tri, c2->n + 2, row, end_row(c2, b, 1, &m));
  }
  w[2] = ph_planar_at_knot(c2->y[first], neighbours_of(c2, b, first).before,
                           mine[first]);
  for (size_t k = first; k < end; k++) {
    struct ph_tri_row row;
    advance(c2, mine, k, w);
    row = segment_row(c2, k, w, &m);
    ph_tri_push(tri, &row);
  }
  ph_tri_finish(tri, step);
  return m;
}

/* Row i of F', 0 <= i < unknowns. */
static struct ph_tri_row row_of(const struct ph_planar_c2 *c2, const ph_cplx *b,
                                size_t i) {
  struct ph_planar_measure m = {0, 0, 0};
  ph_cplx w[3];
  if (c2->closed) {
    if (i == 0 || i + 1 == c2->n) {
      return corner_row(c2, b, i, &m);
    }
  } else if (i == 0 || i == c2->n + 1) {
    return end_row(c2, b, i > 0, &m);
  } else {
    i--;
  }
  ph_planar_preimage(c2, b, i, w);
  return segment_row(c2, i, w, &m);
}

void ph_planar_c2_adjoint(const struct ph_planar_c2 *c2, const ph_cplx *b,
                          const ph_cplx *r, struct ph_tri *tri, ph_cplx *x) {
  size_t n = ph_planar_unknowns(c2);
  struct ph_tri_row head = row_of(c2, b, 0), before, here, after;
  struct ph_tri_row tail = row_of(c2, b, n - 1);
  before = head;
  here = row_of(c2, b, 1);
  after = row_of(c2, b, n - 2);
  ph_tri_begin(tri, n, (struct ph_tri_row){tail.up, head.di, here.lo, r[0]},
               (struct ph_tri_row){after.up, tail.di, head.lo, r[n - 1]});
  for (size_t i = 1; i + 1 < n; i++) {
    struct ph_tri_row row = {before.up, here.di, {0, 0}, r[i]};
    after = row_of(c2, b, i + 1);
    row.up = after.lo;
    ph_tri_push(tri, &row);
    before = here;
    here = after;
  }
  ph_tri_finish(tri, x);
}

void ph_planar_c2_gradient(const struct ph_planar_c2 *c2, size_t k,
                           const ph_cplx w[3], ph_cplx g[3]) {
  struct equation q = equation_of(c2, k, w);
  g[0] = q.g0;
  g[1] = q.g1;
  g[2] = q.g2;
}

struct ph_planar_measure ph_planar_residual(const struct ph_planar_c2 *c2,
                                            const ph_cplx *b) {
  struct ph_planar_measure m = {0, 0, 0};
  const ph_cplx *mine = of_segments(c2, b);
  size_t end = c2->closed ? c2->n - 1 : c2->n;
  ph_cplx w[3];
  w[2] = ph_planar_at_knot(c2->y[0], neighbours_of(c2, b, 0).before, mine[0]);
  for (size_t k = 0; k < end; k++) {
    advance(c2, mine, k, w);
    measure_add(&m, k, ph_planar_closing(c2, k, w));
  }
  if (c2->closed) {
    ph_planar_preimage(c2, b, end, w);
    measure_add(&m, end, ph_planar_closing(c2, end, w));
  } else {
    end_row(c2, b, 0, &m);
    end_row(c2, b, 1, &m);
  }
  return m;
}

double ph_planar_rounding(const struct ph_planar_c2 *c2, const ph_cplx *b) {
  double largest = 0;
  for (size_t k = 0; k < c2->n; k++) {
    ph_cplx w[3];
    double terms, f;
    ph_planar_preimage(c2, b, k, w);
    terms = ph_cplx_norm2(w[0]) + ph_cplx_norm2(w[1]) + ph_cplx_norm2(w[2]);
    f = ph_cplx_abs(equation_of(c2, k, w).f) / (1 + c2->ratio[k] * terms);
    if (!(f <= largest)) {
      largest = f;
    }
    if (isnan(f)) {
      return f;
    }
  }
  for (int side = 0; side < 2 && !c2->closed; side++) {
    /* The error of w = (b + b')/2 is that of its terms, times 2 |w| / |d|. */
    const ph_cplx *pair = side ? b + c2->n : b;
    double w = ph_cplx_abs(ph_planar_at_knot(0.5, pair[0], pair[1]));
    double terms = w * (ph_cplx_abs(pair[0]) + ph_cplx_abs(pair[1]));
    struct ph_planar_measure m = {0, 0, 0};
    double f;
    end_row(c2, b, side, &m);
    f = sqrt(m.max2) / (1 + terms / c2->end_size[side]);
    if (!(f <= largest)) {
      largest = f;
    }
  }
  return largest;
}

/* Whether b, a root next to a, needs the other sign to turn by at most a
 * quarter; of two opposite directions the turn is taken to the left. */
static bool needs_flip(ph_cplx a, ph_cplx b) {
  double dot = ph_cplx_dot(a, b), cross = ph_cplx_cross(a, b);
  if (fabs(dot) <= OPPOSITE * fabs(cross)) {
    return cross < 0;
  }
  return dot < 0;
}

static bool is_turned(const struct ph_planar_c2 *c2, size_t k) {
  return c2->turned && c2->turned[k];
}

/* Makes the roots continuous from one to the next, but where a turn is to be
 * the other way round; sets the twist. */
static void choose_signs(struct ph_planar_c2 *c2, ph_cplx *root) {
  size_t n = ph_planar_unknowns(c2);
  for (size_t k = 1; k < n; k++) {
    if (needs_flip(root[k - 1], root[k]) != is_turned(c2, k)) {
      root[k] = ph_cplx_scale(-1, root[k]);
    }
  }
  if (c2->closed) {
    bool flip = needs_flip(root[n - 1], root[0]) != is_turned(c2, 0);
    c2->twist = ph_cplx_of(flip ? -1 : 1, 0);
  }
}

static struct ph_tri_row middle_row(const struct ph_planar_c2 *c2, size_t k,
                                    ph_cplx root) {
  double left = c2->y[k], right = c2->y[k + 1], c = ph_planar_space(c2, k)->c;
  double part = 1 / (2 * (1 + c));
  struct ph_tri_row row = {{left * part, 0},
                           {(1 - left + 2 * c + right) * part, 0},
                           {(1 - right) * part, 0},
                           root};
  return row;
}

void ph_planar_start(struct ph_planar_c2 *c2, struct ph_tri *tri, ph_cplx *root,
                     ph_cplx *b) {
  size_t n = c2->n, shift = c2->closed ? 0 : 1;
  for (size_t k = shift; k < n + shift; k++) {
    root[k] = ph_cplx_sqrt(root[k]);
  }
  if (c2->closed) {
    struct ph_tri_row first, last;
    choose_signs(c2, root);
    first = middle_row(c2, 0, root[0]);
    last = middle_row(c2, n - 1, root[n - 1]);
    first.lo = ph_cplx_scale(first.lo.re, ph_cplx_conj(c2->twist));
    last.up = ph_cplx_scale(last.up.re, c2->twist);
    ph_tri_begin(tri, n, first, last);
  } else {
    const ph_cplx half = {0.5, 0}, zero = {0, 0};
    struct ph_tri_row first = {zero, half, half, zero};
    struct ph_tri_row last = {half, half, zero, zero};
    for (int side = 0; side < 2; side++) {
      root[side ? n + 1 : 0] =
          ph_cplx_scale(sqrt(c2->end_size[side]), ph_cplx_sqrt(c2->end[side]));
    }
    choose_signs(c2, root);
    first.f = root[0];
    last.f = root[n + 1];
    ph_tri_begin(tri, n + 2, first, last);
  }
  for (size_t k = 1 - shift; k < n - 1 + shift; k++) {
    struct ph_tri_row row = middle_row(c2, k, root[k + shift]);
    ph_tri_push(tri, &row);
  }
  ph_tri_finish(tri, b);
}

/* c/h */
static ph_cplx chord_slope(const struct ph_planar_c2 *c2, size_t k) {
  return ph_cplx_scale(1 / c2->ratio[k], c2->direction[k]);
}

void ph_planar_chord_middles(const struct ph_planar_c2 *c2, ph_cplx *middle) {
  for (size_t k = 0; k < c2->n; k++) {
    middle[k] = chord_slope(c2, k);
  }
}

/* The row of the C2 cubic spline at the knot between segments k and k + 1, for
 * its derivatives there [GON18, sec. 2.4]. */
static struct ph_tri_row spline_row(const struct ph_planar_c2 *c2, size_t k) {
  size_t next = k + 1 < c2->n ? k + 1 : 0;
  double from = c2->y[k + 1] * ph_planar_space(c2, next)->slope;
  double to = (1 - c2->y[k + 1]) * ph_planar_space(c2, k)->slope;
  double y = from / (from + to); /* h[k+1] / (h[k] + h[k+1]), from (1) */
  ph_cplx left = chord_slope(c2, k), right = chord_slope(c2, next);
  struct ph_tri_row row = {{y, 0},
                           {2, 0},
                           {1 - y, 0},
                           ph_cplx_scale(3, ph_planar_at_knot(y, left, right))};
  return row;
}

/* Derivatives at the knots 0..n of the C2 cubic spline through the points,
 * clamped at open ends. */
static void spline_derivatives(const struct ph_planar_c2 *c2,
                               struct ph_tri *tri, ph_cplx *derivative) {
  size_t n = c2->n;
  const ph_cplx zero = {0, 0}, one = {1, 0};
  if (c2->closed) { /* unknown k is the derivative at knot k + 1 */
    ph_tri_begin(tri, n, spline_row(c2, 0), spline_row(c2, n - 1));
    for (size_t k = 1; k + 1 < n; k++) {
      struct ph_tri_row row = spline_row(c2, k);
      ph_tri_push(tri, &row);
    }
    ph_tri_finish(tri, derivative + 1);
    derivative[0] = derivative[n];
    return;
  }
  derivative[0] = ph_cplx_scale(c2->end_size[0], c2->end[0]);
  derivative[n] = ph_cplx_scale(c2->end_size[1], c2->end[1]);
  if (n >= 2) {
    struct ph_tri_row first = {zero, one, zero, derivative[0]};
    struct ph_tri_row last = {zero, one, zero, derivative[n]};
    ph_tri_begin(tri, n + 1, first, last);
    for (size_t k = 0; k + 1 < n; k++) {
      struct ph_tri_row row = spline_row(c2, k);
      ph_tri_push(tri, &row);
    }
    ph_tri_finish(tri, derivative);
  }
}

/* c'(1/2) = (3/2) c/h - (c'(0) + c'(1)) / 4 for the cubic of each segment. */
void ph_planar_spline_middles(const struct ph_planar_c2 *c2, struct ph_tri *tri,
                              ph_cplx *middle) {
  spline_derivatives(c2, tri, middle);
  for (size_t k = 0; k < c2->n; k++) {
    ph_cplx ends = ph_cplx_add(middle[k], middle[k + 1]);
    middle[k] = ph_cplx_sub(ph_cplx_scale(1.5, chord_slope(c2, k)),
                            ph_cplx_scale(0.25, ends));
  }
}
