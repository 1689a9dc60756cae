/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The distances at which offsets are regular, against the curvature of control
 * points, which is bounded everywhere, not sampled.
 *
 * With v of kernel/form.h, b[j] = h[j] / binomial(m, j) of segment.h, P the
 * polynomial with these coefficients, and q = (1-v)^2 + 2 c v (1-v) + v^2,
 * which is 1 / (S0 + S1)^2, c = cos(a/2) [derived here: r' = q^(-m/2) P, and
 * dv/du = q / sinc]:
 *
 *   kappa = q^(k/2) P x P_v / (sinc |P|^3),  k = m + 2                    (1)
 *
 * so that |kappa| <= M where no Bernstein coefficient of
 *
 *   (M sinc)^2 |P|^6 - (P x P_v)^2 q^k,  of degree 6 m + 2                (2)
 *
 * is below 0, and kappa <= 0 where none of P x P_v is above.  Parts are halved
 * until one of both says that none bends more than a place that was looked at.
 * The search of curve/offset/range.c has other forms, of the preimage.
 */
#include "check/checks.h"
#include "kernel/form.h"
#include "kernel/pi.h"

/* Halvings until a part is a place; M of (2) is more than what was found by so
 * much of it, or of the inverse of the size. */
enum { HALVINGS = 40, M_MAX = 4, TOP = 6 * M_MAX + 2 };

/* Parts of one segment: of data that are no curve there is no end. */
enum { PARTS_MAX = 100000 };

static const double NEAR = 1e-11;

/* Where the curve stands still no distance is: there it bends by no less, over
 * the inverse of its size. */
static const double STOP = 1e6;

/* Over the inverse of the size: what bends by less is straight to rounding. */
static const double NONE = 1e-9;

struct bends {
  const struct ph_check *v;
  struct ph_check_path path;
  double side;        /* 1: to the left */
  double most, error; /* the largest, and by how much it may be off */
  double c, sinc;     /* of (1) */
  double scale;       /* what P is multiplied by */
  size_t parts;       /* of this segment */
};

/* Bernstein coefficients from v[0] to v[1] of what (1) is made of. */
struct part {
  double v[2];
  double x[M_MAX + 1], y[M_MAX + 1], dx[M_MAX], dy[M_MAX], q[3];
};

static void bend_at(struct bends *b, double v) {
  const double half = b->path.s->angle / 2;
  const double u =
      half > 0 ? atan2(v * sin(half), 1 - v + v * cos(half)) / half : v;
  const struct ph_check_local at = ph_check_local_at(&b->path, u);
  const double bend = b->side * at.curvature;
  if (bend > b->most) {
    b->most = bend;
    b->error = at.curvature_error;
  }
}

/* A form whose products are those of its coefficients, from its Bernstein
 * coefficients. */
static void form_of(const double *b, size_t degree, double *f) {
  double binomial = 1;
  for (size_t k = 0; k <= degree; k++) {
    f[k] = binomial * b[k];
    binomial *= (double)(degree - k) / (double)(k + 1);
  }
}

/* f and as many factors g of degree 2; ret  the degree of the product */
static size_t multiply_by(double *f, size_t degree, const double g[3],
                          size_t times) {
  for (size_t i = 0; i < times; i++, degree += 2) {
    double product[TOP + 1];
    ph_form_multiply(f, degree, g, 2, product);
    for (size_t k = 0; k <= degree + 2; k++) {
      f[k] = product[k];
    }
  }
  return degree;
}

/* P x P_v to the side that is asked for; ret  its degree */
static size_t turning(const struct bends *b, const struct part *p, double *f) {
  const size_t m = b->path.s->m;
  double x[M_MAX + 1], y[M_MAX + 1], dx[M_MAX], dy[M_MAX], xy[2 * M_MAX];
  form_of(p->x, m, x);
  form_of(p->y, m, y);
  form_of(p->dx, m - 1, dx);
  form_of(p->dy, m - 1, dy);
  ph_form_multiply(x, m, dy, m - 1, f);
  ph_form_multiply(y, m, dx, m - 1, xy);
  for (size_t k = 0; k < 2 * m; k++) {
    f[k] = b->side * (f[k] - xy[k]);
  }
  return 2 * m - 1;
}

/* Of (2), with M sinc = 1: both terms. */
static size_t terms_of(const struct bends *b, const struct part *p,
                       const double *turn, double *speed, double *bend) {
  const size_t m = b->path.s->m;
  const double one[3] = {1, 2, 1};
  double x[M_MAX + 1], square[2 * M_MAX + 1], more[2 * M_MAX + 1];
  double q[3], fourth[4 * M_MAX + 1];
  form_of(p->x, m, x);
  ph_form_multiply(x, m, x, m, square);
  form_of(p->y, m, x);
  ph_form_multiply(x, m, x, m, more);
  for (size_t k = 0; k <= 2 * m; k++) {
    square[k] += more[k];
  }
  ph_form_multiply(square, 2 * m, square, 2 * m, fourth);
  ph_form_multiply(fourth, 4 * m, square, 2 * m, speed);
  multiply_by(speed, 6 * m, one, 1);
  form_of(p->q, 2, q);
  ph_form_multiply(turn, 2 * m - 1, turn, 2 * m - 1, bend);
  return multiply_by(bend, 4 * m - 2, q, m + 2);
}

/* Whether no place of a part bends by more than was found, to the side. */
static bool is_bounded(const struct bends *b, const struct part *p) {
  const double floor = fmax(b->most, 1 / b->v->scale.size);
  const double most = (fmax(b->most, 0) + NEAR * floor) * b->sinc / b->scale;
  double turn[2 * M_MAX], speed[TOP + 1], bend[TOP + 1];
  const size_t of_turn = turning(b, p, turn);
  bool none = true, bounded = true;
  size_t degree;
  for (size_t k = 0; k <= of_turn; k++) {
    none = none && turn[k] <= 0;
  }
  if (none) {
    return true;
  }
  degree = terms_of(b, p, turn, speed, bend);
  for (size_t k = 0; k <= degree; k++) {
    bounded = bounded && bend[k] <= most * most * speed[k];
  }
  return bounded;
}

static void visit(struct bends *b, const struct part *p, int depth) {
  const size_t m = b->path.s->m;
  struct part half[2];
  bend_at(b, p->v[0]);
  bend_at(b, p->v[1]);
  if (depth == HALVINGS || b->parts >= PARTS_MAX || is_bounded(b, p)) {
    return;
  }
  b->parts += 2;
  half[0].v[0] = p->v[0];
  half[0].v[1] = half[1].v[0] = 0.5 * (p->v[0] + p->v[1]);
  half[1].v[1] = p->v[1];
  ph_form_halve(p->x, m, half[0].x, half[1].x);
  ph_form_halve(p->y, m, half[0].y, half[1].y);
  ph_form_halve(p->dx, m - 1, half[0].dx, half[1].dx);
  ph_form_halve(p->dy, m - 1, half[0].dy, half[1].dy);
  ph_form_halve(p->q, 2, half[0].q, half[1].q);
  visit(b, &half[0], depth + 1);
  visit(b, &half[1], depth + 1);
}

/* ret  false: its bends are not bounded */
static bool see_segment(struct bends *b) {
  const struct ph_check_segment *s = b->path.s;
  const size_t m = s->m;
  const double half = s->angle / 2;
  struct part p = {.v = {0, 1}};
  double binomial = 1;
  b->c = cos(half);
  b->sinc = half > 0 ? sin(half) / half : 1;
  b->scale = ldexp(1, s->speed > 0 ? -ilogb(s->speed) : 0);
  for (size_t j = 0; j <= m; j++) {
    const double by = b->scale / binomial;
    p.x[j] = by * s->h[j].x;
    p.y[j] = by * s->h[j].y;
    binomial *= (double)(m - j) / (double)(j + 1);
  }
  for (size_t j = 0; j < m; j++) {
    p.dx[j] = (double)m * (p.x[j + 1] - p.x[j]);
    p.dy[j] = (double)m * (p.y[j + 1] - p.y[j]);
  }
  p.q[0] = p.q[2] = 1;
  p.q[1] = b->c;
  b->parts = 1;
  visit(b, &p, 0);
  return b->parts < PARTS_MAX;
}

static void check_side(struct ph_check *v, size_t side) {
  const double size = v->scale.size, claimed = v->claim->offset_range[side];
  const double sign = side ? -1 : 1, unit = ph_check_scaled(v, claimed);
  const bool any = !isfinite(claimed);
  const struct ph_check_where where = ph_check_of("offset_range", side, NULL);
  struct ph_check_segment s;
  const double wanted = any ? 0 : sign / unit;
  struct bends b = {.v = v, .path = {.v = v, .s = &s}, .side = sign};
  if (!any && !(sign * claimed >= 0)) {
    ph_check_wrong(v, PH_CHECK_OFFSET, where, "is to the other side");
    return;
  }
  for (size_t k = 0; k < v->curve->n; k++) {
    ph_check_load(v, k, &s);
    if (!see_segment(&b)) {
      ph_check_wrong(v, PH_CHECK_OFFSET, where, "cannot be bounded");
      return;
    }
  }
  if (any || (wanted * size <= NONE && b.most * size <= NONE)) {
    ph_check_miss(v, PH_CHECK_OFFSET, where, b.most, 1 / size,
                  b.error + NONE / size, "is none, and the curve bends");
  } else if (!(fabs(claimed) > 0)) {
    ph_check_miss(v, PH_CHECK_OFFSET, where, STOP, b.most * size, 0,
                  "is 0, and the curve stands still nowhere");
  } else { /* errors are those of curvatures, of these or 1 over the size */
    const double part = fabs(claimed) / b.most;
    ph_check_number(v, PH_CHECK_OFFSET, where, claimed,
                    claimed * (wanted / b.most),
                    part * ph_check_larger(b.most, 1 / size), part * b.error);
  }
}

void ph_check_range(struct ph_check *v) {
  if (v->curve->dimension != 2) {
    ph_check_wrong(v, PH_CHECK_OFFSET,
                   ph_check_of("offset_range", PH_CHECK_ONE, NULL),
                   "is of curves in the plane");
    return;
  }
  check_side(v, 0);
  check_side(v, 1);
}
