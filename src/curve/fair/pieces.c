/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Where to integrate curvature, and by which rule (see pieces.h). */
#include "curve/fair/pieces.h"

#include "kernel/pi.h"

#include <math.h>

/* The nodes of the rules; from which ellipse on, by its major semiaxis over
 * that of the interval, each has both integrals to 3e-13: of 3000 pairs of
 * zeros, one on the ellipse and the other on it or beyond, near the same place,
 * its mirror images or anywhere, the worst was near 2e-13 there; and up to
 * which angle of an ATPH segment, of 2000 pairs. */
static const size_t NODES[PH_PIECE_RULES] = {
    4, 6, 8, 12, [PH_PIECE_SIXTEEN] = 16, 20};
static const double ENOUGH[PH_PIECE_RULES] = {200, 30, 12.5, 5.3, 3.1, 2.4};
static const double ANGLE[PH_PIECE_RULES] = {0, 0.25, 0.5, 2.1, PH_PI, PH_PI};

enum { LAST_RULE = PH_PIECE_RULES - 1 };

/* Squares of numbers whose products may be subnormal. */
static const double TINY = 1e-140;

/* A zero of w, p / d. */
struct zero {
  ph_cplx p, d;
};

struct cutter {
  struct zero zeros[2];
  double period, angle; /* of u; period 0: none */
  struct ph_piece *piece;
  size_t n;
};

bool ph_pieces_rules(struct ph_quad *rule) {
  for (size_t i = 0; i < PH_PIECE_RULES; i++) {
    if (!ph_quad_gauss(&rule[i], NODES[i])) {
      return false;
    }
  }
  return true;
}

/* u of the zero of p S0 + r S1: by (1) of atph.h, with x = a/2,
 *   tan(x u) = -p sin x / (r - p cos x)                                 (1) */
static struct zero of_angle(ph_cplx p, ph_cplx r, double x) {
  const ph_cplx s = ph_cplx_scale(-sin(x), p);
  const ph_cplx t = ph_cplx_sub(r, ph_cplx_scale(cos(x), p));
  const double s2 = ph_cplx_norm2(s), t2 = ph_cplx_norm2(t);
  const double twice = 2 * ph_cplx_cross(t, s);
  const double re = atan2(2 * ph_cplx_dot(s, t), t2 - s2);
  const double im = log1p(fmax(-1, 2 * twice / fmax(0, s2 + t2 - twice)));
  return (struct zero){ph_cplx_of(0.5 * re / x, 0.25 * im / x), {1, 0}};
}

/* The zeros of a preimage; false: rounding may have them elsewhere. */
static bool zeros_of(const struct ph_seg2 *seg, struct zero zeros[2]) {
  const ph_cplx first = seg->w[0], last = seg->w[2];
  const ph_cplx m = ph_cplx_scale(seg->space.c, seg->w[1]);
  const ph_cplx square =
      ph_cplx_sub(ph_cplx_mul(m, m), ph_cplx_mul(first, last));
  const ph_cplx root = ph_cplx_sqrt(square);
  const ph_cplx q =
      ph_cplx_dot(m, root) >= 0 ? ph_cplx_add(m, root) : ph_cplx_sub(m, root);
  if (seg->space.angle > 0) {
    zeros[0] = of_angle(q, last, 0.5 * seg->space.angle);
    zeros[1] = of_angle(first, q, 0.5 * seg->space.angle);
  } else {
    zeros[0] = (struct zero){q, ph_cplx_sub(q, last)};
    zeros[1] = (struct zero){first, ph_cplx_sub(first, q)};
  }
  return ph_cplx_norm2(q) > TINY;
}

/* The major semiaxis of the ellipse around [u0,u1], its foci, through a zero,
 * over half of u1 - u0. */
static double ellipse(const struct zero *z, double period, double u0,
                      double u1) {
  ph_cplx p = z->p, a, b;
  if (period > 0) { /* the nearest of them */
    p.re -= period * round((p.re - 0.5 * (u0 + u1)) / period);
  }
  a = ph_cplx_sub(p, ph_cplx_scale(u0, z->d));
  b = ph_cplx_sub(p, ph_cplx_scale(u1, z->d));
  return (ph_cplx_abs(a) + ph_cplx_abs(b)) / (ph_cplx_abs(z->d) * (u1 - u0));
}

/* The first rule that is enough, or the last one. */
static bool rule_of(double nearer, double angle, size_t *rule) {
  for (*rule = 0; *rule < PH_PIECE_RULES; ++*rule) {
    if (nearer >= ENOUGH[*rule] && angle <= ANGLE[*rule]) {
      return true;
    }
  }
  *rule = LAST_RULE;
  return false;
}

static void add(struct cutter *c, double u0, double u1, int cuts) {
  const double nearer = fmin(ellipse(&c->zeros[0], c->period, u0, u1),
                             ellipse(&c->zeros[1], c->period, u0, u1));
  const double middle = 0.5 * (u0 + u1);
  struct ph_piece piece = {.from = u0, .to = u1};
  piece.enough = rule_of(nearer, c->angle * (u1 - u0), &piece.rule);
  if (nearer < ENOUGH[LAST_RULE] && cuts < PH_PIECE_CUTS) {
    add(c, u0, middle, cuts + 1);
    add(c, middle, u1, cuts + 1);
  } else {
    c->piece[c->n++] = piece;
  }
}

size_t ph_pieces_of(const struct ph_seg2 *seg, struct ph_piece *piece) {
  struct cutter c = {.angle = seg->space.angle, .piece = piece};
  if (!zeros_of(seg, c.zeros)) {
    piece[0] = (struct ph_piece){0, 1, LAST_RULE, false};
    return 1;
  }
  c.period = c.angle > 0 ? 2 * PH_PI / c.angle : 0;
  add(&c, 0, 1, 0);
  return c.n;
}
