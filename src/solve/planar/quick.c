/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The C2 equations of many smooth data, PH quintics, in less work than Newton's
 * method takes from the chords (c2.h).  What is found is measured as there.
 *
 * Start.  The mean of the derivative over segment k is d_k = c_k / h_k, so that
 * of the parabola with the means d_-, d, d_+ the value in the middle is
 *   m = d - f ((1 - y') (d_+ - d) - y (d - d_-)),                       (1)
 *   f = y (1 - y') / (4 (1 - y' + y y')),  y = y[k], y' = y[k+1].
 * w(1/2) = b + E b is its root r, with
 *   (E b)_k = y/4 (b_- - b) + (1 - y')/4 (b_+ - b),                     (2)
 * and so b = r - E r + E E r to the third order of E, without a solution.  At
 * open ends, where (b_- + b) / 2 is the root R of the end derivative, what is
 * before b is 2 R - b, and the correction in (1) is that of the next segment,
 * by the square of h.
 *
 * Step.  Where neighbours nearly agree, the rows of F' are
 *   2/3 h/|c| b_k [y, 2 - y + y', 1 - y'],                              (3)
 * so that the step solves a real tridiagonal system T s = 3/2 F |c| / (h b);
 * rows of open ends are [1, 1] s = (w^2 - d) / w.  The error falls by the
 * square of the turn from one datum to the next over 12, about.  T is the same
 * in every step.  Where neighbours agree less, the steps are Newton's, with the
 * rows of F' as they are, which need no pivots there.  The factors of both
 * forget where elimination began: that of a closed curve begins WARM rows
 * before the cut.  [Derived here]
 */
#include "solve/planar/c2.h"

#include <math.h>

enum { WARM = 32, STEPS = 8 };

/* Relative closing errors of the start: above FAR others begin, below NEAR the
 * steps (3) are good, between them Newton's; they are given up where one does
 * not gain WANTED. */
static const double FAR = 0.05, NEAR = 1e-4, WANTED = 0.1;
/* Below, the next step is likely the last one: (3), and Newton's, whose error
 * is a quarter of the square of the last one, about. */
static const double LAST = 1e-10, LAST_OF_NEWTON = 5e-7;

struct quick {
  const struct ph_planar_c2 *c2;
  double twist;    /* closed: 1 or -1 */
  ph_cplx root[2]; /* open: R of both ends */
  ph_cplx end;     /* open: right-hand side of the first row */
  ph_cplx *b;      /* [n] of the segments; open: b[-1] and b[n], too */
  ph_cplx *work;   /* [n] roots, right-hand sides */
  double *inverse; /* [n] of pivots of T */
  bool is_newton;  /* the steps are Newton's: */
  ph_cplx *up;     /* [n] what is above the diagonal over the pivots */
};

/* ---- the start ----------------------------------------------------------- */

static inline ph_cplx slope_at(const struct ph_planar_c2 *c2, size_t k) {
  return ph_cplx_scale(1 / c2->ratio[k], c2->direction[k]);
}

/* What (1) subtracts. */
static inline ph_cplx bend(const struct ph_planar_c2 *c2, size_t k,
                           ph_cplx before, ph_cplx here, ph_cplx after) {
  const double left = c2->y[k], right = 1 - c2->y[k + 1];
  const double f = 0.25 * left * right / (right + left * c2->y[k + 1]);
  const double a = f * right, b = f * left;
  return ph_cplx_of(a * (after.re - here.re) - b * (here.re - before.re),
                    a * (after.im - here.im) - b * (here.im - before.im));
}

/* The root with the sign of the one before; whether it is near that. */
static inline bool next_root(ph_cplx m, ph_cplx *root) {
  ph_cplx r = ph_cplx_sqrt(m);
  double dot = ph_cplx_dot(*root, r);
  *root = dot < 0 ? ph_cplx_scale(-1, r) : r;
  return fabs(dot) >= fabs(ph_cplx_cross(*root, r));
}

/* (1) of the first or last segment of an open curve. */
static ph_cplx end_middle(const struct ph_planar_c2 *c2, int side) {
  const size_t n = c2->n, end = side ? n - 1 : 0, k = side ? n - 2 : 1;
  const double part =
      side ? c2->y[n - 1] / (1 - c2->y[n - 1]) : (1 - c2->y[1]) / c2->y[1];
  ph_cplx other =
      bend(c2, k, slope_at(c2, k - 1), slope_at(c2, k), slope_at(c2, k + 1));
  return ph_cplx_sub(slope_at(c2, end), ph_cplx_scale(part * part, other));
}

/* The roots of all segments; whether they are near each other. */
static bool find_roots(struct quick *q) {
  const struct ph_planar_c2 *c2 = q->c2;
  const size_t n = c2->n;
  ph_cplx before = slope_at(c2, n - 1), here = slope_at(c2, 0), root;
  bool near = true;
  if (c2->closed) {
    root = ph_cplx_sqrt(here);
  } else {
    root = q->root[0] =
        ph_cplx_scale(sqrt(c2->end_size[0]), ph_cplx_sqrt(c2->end[0]));
  }
  for (size_t k = 0; k < n; k++) {
    const ph_cplx after = slope_at(c2, k + 1 < n ? k + 1 : 0);
    ph_cplx m = ph_cplx_sub(here, bend(c2, k, before, here, after));
    if (!c2->closed && (k == 0 || k + 1 == n)) {
      m = end_middle(c2, k > 0);
    }
    near = next_root(m, &root) && near;
    q->work[k] = root;
    before = here;
    here = after;
  }
  if (c2->closed) {
    q->twist = ph_cplx_dot(root, q->work[0]) < 0 ? -1 : 1;
    return near && fabs(ph_cplx_dot(root, q->work[0])) >=
                       fabs(ph_cplx_cross(root, q->work[0]));
  }
  near = next_root(ph_cplx_scale(c2->end_size[1], c2->end[1]), &root) && near;
  q->root[1] = root;
  return near;
}

/* (2) */
static inline ph_cplx spread(const struct ph_planar_c2 *c2, size_t k,
                             ph_cplx before, ph_cplx here, ph_cplx after) {
  const double left = 0.25 * c2->y[k], right = 0.25 * (1 - c2->y[k + 1]);
  return ph_cplx_of(left * (before.re - here.re) + right * (after.re - here.re),
                    left * (before.im - here.im) +
                        right * (after.im - here.im));
}

/* What is beyond an end, of which x is next to it and other next to the other
 * end, and end is R. */
static ph_cplx beyond(const struct quick *q, ph_cplx end, ph_cplx x,
                      ph_cplx other) {
  return q->c2->closed ? ph_cplx_scale(q->twist, other)
                       : ph_cplx_of(2 * end.re - x.re, 2 * end.im - x.im);
}

/* Whether the start is likely too rough for the steps (3): what remains of the
 * equations is about twice the last term of the series, relative to b. */
static bool start(struct quick *q) {
  const struct ph_planar_c2 *c2 = q->c2;
  const size_t n = c2->n;
  const ph_cplx *r = q->work, zero = {0, 0};
  const ph_cplx first = beyond(q, q->root[0], r[0], r[n - 1]);
  const ph_cplx last = beyond(q, q->root[1], r[n - 1], r[0]);
  const ph_cplx low = spread(c2, 0, first, r[0], r[1]);
  const ph_cplx high = spread(c2, n - 1, r[n - 2], r[n - 1], last);
  ph_cplx before = beyond(q, zero, low, high), here = low;
  bool rough = false;
  for (size_t k = 0; k < n; k++) {
    const ph_cplx after = k + 2 < n
                              ? spread(c2, k + 1, r[k], r[k + 1], r[k + 2])
                          : k + 1 < n ? high
                                      : beyond(q, zero, high, low);
    const ph_cplx again = spread(c2, k, before, here, after);
    rough |= ph_cplx_norm2(again) > 0.25 * NEAR * NEAR * ph_cplx_norm2(r[k]);
    q->b[k].re = r[k].re - here.re + again.re;
    q->b[k].im = r[k].im - here.im + again.im;
    before = here;
    here = after;
  }
  if (!c2->closed) {
    q->b[-1] = beyond(q, q->root[0], q->b[0], zero);
    q->b[n] = beyond(q, q->root[1], q->b[n - 1], zero);
  }
  return rough;
}

/* ---- steps --------------------------------------------------------------- */

/* times a / (per b) */
static inline ph_cplx over(double times, ph_cplx a, double per, ph_cplx b) {
  const double part = times / (per * ph_cplx_norm2(b));
  return ph_cplx_of(part * (a.re * b.re + a.im * b.im),
                    part * (a.im * b.re - a.re * b.im));
}

static inline void measure(struct ph_planar_measure *m, size_t k, ph_cplx f) {
  const double f2 = ph_cplx_norm2(f);
  m->sum2 += f2;
  if (!(f2 <= m->max2)) {
    m->max2 = f2;
    m->worst = k;
  }
}

/* Elimination so far: 1 / pivot times what is above the diagonal, and the
 * right-hand side. */
struct row {
  ph_cplx up, f;
};

/* w at the beginning of a segment. */
static ph_cplx first_of(const struct quick *q, size_t k) {
  const struct ph_planar_c2 *c2 = q->c2;
  return !c2->closed && k == 0 ? ph_planar_at_knot(0.5, q->b[-1], q->b[0])
         : k > 0 ? ph_planar_at_knot(c2->y[k], q->b[k - 1], q->b[k])
                 : ph_planar_at_knot(c2->y[k],
                                     ph_cplx_scale(q->twist, q->b[c2->n - 1]),
                                     q->b[k]);
}

/* Moves w to segment k. */
static inline void next_segment(const struct quick *q, size_t k, ph_cplx w[3]) {
  const struct ph_planar_c2 *c2 = q->c2;
  w[0] = w[2];
  w[1] = q->b[k];
  w[2] = ph_planar_at_knot(c2->y[k + 1], w[1],
                           !c2->closed || k + 1 < c2->n
                               ? q->b[k + 1]
                               : ph_cplx_scale(q->twist, q->b[0]));
}

/* Rows from .. to - 1 of T s, eliminated from `above` on; the measure of F. */
static struct row eliminate(struct quick *q, size_t from, size_t to,
                            bool factors, struct row above,
                            struct ph_planar_measure *m) {
  const struct ph_planar_c2 *c2 = q->c2;
  ph_cplx w[3];
  w[2] = first_of(q, from);
  for (size_t k = from; k < to; k++) {
    const double low = c2->y[k], high = c2->y[k + 1];
    ph_cplx f, r;
    next_segment(q, k, w);
    f = ph_planar_closing(c2, k, w);
    measure(m, k, f);
    r = over(1.5, f, c2->ratio[k], w[1]);
    if (factors) {
      q->inverse[k] = 1 / (2 - low + high - low * above.up.re);
    }
    above.up.re = (1 - high) * q->inverse[k];
    above.f.re = (r.re - low * above.f.re) * q->inverse[k];
    above.f.im = (r.im - low * above.f.im) * q->inverse[k];
    q->work[k] = above.f;
  }
  return above;
}

/* The same of F' s: F[k] = s (e0 (w0^2 + w2^2) + e1 (w0 + w2) w1 + e2 w1^2 +
 * e3 w0 w2) - c/|c|, s = h/|c|, by w0, w1 and w2. */
static struct row eliminate_newton(struct quick *q, size_t from, size_t to,
                                   struct row above,
                                   struct ph_planar_measure *m) {
  const struct ph_planar_c2 *c2 = q->c2;
  const double *space = c2->space->q;
  const double e0 = 2 * space[0], e1 = space[1], e2 = 2 * space[2],
               e3 = space[3];
  ph_cplx w[3];
  w[2] = first_of(q, from);
  for (size_t k = from; k < to; k++) {
    const double low = c2->y[k], high = c2->y[k + 1], s = c2->ratio[k];
    ph_cplx g0, g1, g2, f, down, here, inverse;
    next_segment(q, k, w);
    g0 = ph_cplx_of(s * (e0 * w[0].re + e1 * w[1].re + e3 * w[2].re),
                    s * (e0 * w[0].im + e1 * w[1].im + e3 * w[2].im));
    g1 = ph_cplx_of(s * (e1 * (w[0].re + w[2].re) + e2 * w[1].re),
                    s * (e1 * (w[0].im + w[2].im) + e2 * w[1].im));
    g2 = ph_cplx_of(s * (e0 * w[2].re + e1 * w[1].re + e3 * w[0].re),
                    s * (e0 * w[2].im + e1 * w[1].im + e3 * w[0].im));
    f = ph_cplx_add(ph_cplx_mul(g0, w[0]), ph_cplx_mul(g1, w[1]));
    f = ph_cplx_add(f, ph_cplx_mul(g2, w[2]));
    f = ph_cplx_sub(ph_cplx_scale(0.5, f), c2->direction[k]);
    measure(m, k, f);
    down = ph_cplx_scale(low, g0);
    here = ph_cplx_of(g0.re - down.re + g1.re + high * g2.re,
                      g0.im - down.im + g1.im + high * g2.im);
    inverse = ph_cplx_inverse(ph_cplx_sub(here, ph_cplx_mul(down, above.up)));
    above.f = ph_cplx_mul(ph_cplx_sub(f, ph_cplx_mul(down, above.f)), inverse);
    above.up = ph_cplx_mul(ph_cplx_scale(1 - high, g2), inverse);
    q->up[k] = above.up;
    q->work[k] = above.f;
  }
  return above;
}

/* The right-hand side at an open end; b of both sides of it. */
static ph_cplx end_side(const struct quick *q, int side, ph_cplx a, ph_cplx b,
                        struct ph_planar_measure *m) {
  const struct ph_planar_c2 *c2 = q->c2;
  const double size = c2->end_size[side];
  const ph_cplx w = ph_planar_at_knot(0.5, a, b);
  const ph_cplx f =
      ph_cplx_sub(ph_cplx_mul(w, w), ph_cplx_scale(size, c2->end[side]));
  measure(m, side ? c2->n - 1 : 0, ph_cplx_scale(1 / size, f));
  return over(1, f, 1, w);
}

/* b - s, from the last row up, beyond which s is x. */
static ph_cplx substitute(struct quick *q, size_t n, ph_cplx x, bool move) {
  const struct ph_planar_c2 *c2 = q->c2;
  for (size_t k = q->is_newton ? n : 0; k-- > 0;) {
    x = ph_cplx_sub(q->work[k], ph_cplx_mul(q->up[k], x));
    if (move) {
      q->b[k] = ph_cplx_sub(q->b[k], x);
    }
  }
  for (size_t k = q->is_newton ? 0 : n; k-- > 0;) {
    const double up = (1 - c2->y[k + 1]) * q->inverse[k];
    x.re = q->work[k].re - up * x.re;
    x.im = q->work[k].im - up * x.im;
    if (move) {
      q->b[k] = ph_cplx_sub(q->b[k], x);
    }
  }
  return x;
}

/* Rows by either step. */
static struct row eliminate_any(struct quick *q, size_t from, bool factors,
                                struct row above, struct ph_planar_measure *m) {
  return q->is_newton ? eliminate_newton(q, from, q->c2->n, above, m)
                      : eliminate(q, from, q->c2->n, factors, above, m);
}

/* The measure of F, and what `finish` needs for a step. */
static struct ph_planar_measure prepare(struct quick *q, bool factors,
                                        ph_cplx *x) {
  const size_t n = q->c2->n;
  struct ph_planar_measure m = {0, 0, 0}, again = {0, 0, 0};
  struct row above = {{0, 0}, {0, 0}};
  if (q->c2->closed) {
    above = eliminate_any(q, n - WARM, factors, above, &again);
    above.f = ph_cplx_scale(q->twist, above.f);
    eliminate_any(q, 0, factors, above, &m);
    *x = ph_cplx_scale(q->twist, substitute(q, WARM, ph_cplx_of(0, 0), false));
  } else {
    above.up.re = 1;
    above.f = q->end = end_side(q, 0, q->b[-1], q->b[0], &m);
    above = eliminate_any(q, 0, factors, above, &m);
    *x = ph_cplx_sub(end_side(q, 1, q->b[n - 1], q->b[n], &m), above.f);
    *x = q->is_newton
             ? ph_cplx_mul(
                   *x, ph_cplx_inverse(ph_cplx_sub(ph_cplx_of(1, 0), above.up)))
             : ph_cplx_scale(1 / (1 - above.up.re), *x);
  }
  return m;
}

/* x is s beyond the last segment; of open curves, of the end. */
static void finish(struct quick *q, ph_cplx x) {
  const size_t n = q->c2->n;
  if (q->c2->closed) {
    substitute(q, n, x, true);
  } else {
    q->b[n] = ph_cplx_sub(q->b[n], x);
    x = substitute(q, n, x, true);
    q->b[-1] = ph_cplx_sub(q->b[-1], ph_cplx_sub(q->end, x));
  }
}

/* Steps from the start, of the measure *m; x is of the first one, if that is
 * prepared. */
static enum ph_planar_quick iterate(struct quick *q, const ph_cplx *b,
                                    const struct ph_arena *clock, double solved,
                                    bool prepared, ph_cplx x,
                                    size_t *iterations,
                                    struct ph_planar_measure *m) {
  const double likely = q->is_newton ? LAST_OF_NEWTON : LAST;
  bool factors = !prepared;
  for (int i = 0; i < STEPS && !ph_arena_late(clock); i++) {
    struct ph_planar_measure last = *m;
    if (last.max2 <= solved * solved) {
      return PH_PLANAR_QUICK_SOLVED;
    }
    if (!prepared) {
      prepare(q, factors, &x);
      factors = false;
    }
    finish(q, x);
    ++*iterations;
    prepared = last.max2 > likely * likely;
    *m = prepared ? prepare(q, false, &x) : ph_planar_residual(q->c2, b);
    if (!(m->max2 <= WANTED * WANTED * last.max2)) {
      break;
    }
  }
  return m->max2 <= solved * solved ? PH_PLANAR_QUICK_SOLVED
                                    : PH_PLANAR_QUICK_NEAR;
}

enum ph_planar_quick ph_planar_c2_quick(struct ph_planar_c2 *c2,
                                        const struct ph_arena *clock,
                                        double solved, ph_cplx *b,
                                        ph_cplx *work, double *inverse,
                                        ph_cplx *up, size_t *iterations,
                                        struct ph_planar_measure *m) {
  struct quick q = {.c2 = c2,
                    .twist = 1,
                    .b = c2->closed ? b : b + 1,
                    .work = work,
                    .inverse = inverse,
                    .up = up};
  ph_cplx x = {0, 0};
  bool prepared = true;
  if (!find_roots(&q)) {
    return PH_PLANAR_QUICK_NONE;
  }
  q.is_newton = start(&q);
  if (c2->closed) {
    c2->twist = ph_cplx_of(q.twist, 0);
  }
  *m = prepare(&q, true, &x);
  if (!q.is_newton && !(m->max2 <= NEAR * NEAR)) {
    q.is_newton = true;
    prepared = false;
  }
  return !(m->max2 <= FAR * FAR)
             ? PH_PLANAR_QUICK_NONE
             : iterate(&q, b, clock, solved, prepared, x, iterations, m);
}
