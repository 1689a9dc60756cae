/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Ribbons along edges, and what follows across them (see ribbon.h).  All series
 * are of Taylor coefficients. */
#include "curve/surface/ribbon.h"

#include "base/inline.h"
#include "kernel/bern.h"

#include <string.h>

enum { CONTACT_MAX = 2 * PH_RIBBON_ORDER + 1, SERIES = PH_RIBBON_HEIGHT_ROWS };

/* ---- from points to ribbons ---------------------------------------------- */

/* Heights over the edge from a to b for which f = 0 to the order 2 n at a, one
 * after the other, as f depends on the next one by g . g = 1 times it; x, the
 * curve from a. */
static void touch(const struct ph_quadric *a, const struct ph_quadric *b,
                  size_t continuity, double *height, ph_vec3 *x) {
  const ph_vec3 edge = ph_vec3_sub(b->p, a->p), turn = ph_vec3_sub(b->g, a->g);
  ph_vec3 Hx[CONTACT_MAX];
  height[0] = 0;
  x[0] = ph_vec3_of(0, 0, 0);
  for (size_t k = 1; k <= 2 * continuity; k++) {
    double f;
    x[k] = ph_vec3_along(k == 1 ? edge : x[0], height[k - 1], turn);
    f = ph_vec3_dot(a->g, x[k]);
    for (size_t i = 1; i < k; i++) {
      f += ph_vec3_dot(x[i], Hx[k - i]) / 2;
    }
    height[k] = -f;
    x[k] = ph_vec3_along(x[k], -f, a->g);
    Hx[k] = ph_sym3_apply(&a->H, x[k]);
  }
}

/* Where the last coefficients of a Bernstein form of a degree begin, with the
 * stride -1. */
static double *from_end(double *c, size_t degree, ptrdiff_t stride) {
  return stride < 0 ? c + degree : c;
}

/* The half of a ribbon that is at a. */
static void set_half(const struct ph_quadric *a, const struct ph_quadric *b,
                     size_t continuity, ptrdiff_t stride,
                     struct ph_ribbon *ribbon) {
  const size_t height = ph_ribbon_height_degree(continuity);
  const size_t gradient = ph_ribbon_gradient_degree(continuity);
  double h[CONTACT_MAX], g[3][CONTACT_MAX], H[3] = {0, 0, 0};
  ph_vec3 x[CONTACT_MAX];
  touch(a, b, continuity, h, x);
  ph_bern_contact(height, h, 2 * continuity + 1,
                  from_end(ribbon->height, height, stride), stride);
  for (size_t k = 0; k < 2 * continuity; k++) {
    const ph_vec3 change = ph_sym3_apply(&a->H, x[k]);
    const ph_vec3 at = k ? change : a->g;
    g[0][k] = at.x;
    g[1][k] = at.y;
    g[2][k] = at.z;
  }
  for (size_t i = 0; i < 3; i++) {
    ph_bern_contact(gradient, g[i], 2 * continuity,
                    from_end(ribbon->gradient[i], gradient, stride), stride);
  }
  for (size_t i = 0; continuity == 2 && i < 6; i++) {
    H[0] = a->H.c[i];
    ph_bern_contact(5, H, 3, from_end(ribbon->hessian[i], 5, stride), stride);
  }
}

void ph_ribbon_of(const struct ph_quadric *a, const struct ph_quadric *b,
                  size_t continuity, struct ph_ribbon *ribbon) {
  set_half(a, b, continuity, 1, ribbon);
  set_half(b, a, continuity, -1, ribbon);
}

static void reverse(const double *c, size_t degree, double *to) {
  for (size_t i = 0; i <= degree; i++) {
    to[i] = c[degree - i];
  }
}

void ph_ribbon_reverse(const struct ph_ribbon *ribbon, size_t continuity,
                       struct ph_ribbon *reversed) {
  reverse(ribbon->height, ph_ribbon_height_degree(continuity),
          reversed->height);
  for (size_t i = 0; i < 3; i++) {
    reverse(ribbon->gradient[i], ph_ribbon_gradient_degree(continuity),
            reversed->gradient[i]);
  }
  for (size_t i = 0; continuity == 2 && i < 6; i++) {
    reverse(ribbon->hessian[i], 5, reversed->hessian[i]);
  }
}

/* ---- rows ---------------------------------------------------------------- */

static void set_rows(size_t degree, double s, size_t order, size_t width,
                     double *rows) {
  double dense[SERIES * PH_RIBBON_HEIGHT];
  ph_bern_taylor(degree, s, order, dense);
  for (size_t j = 0; j <= order; j++) {
    memcpy(rows + j * width, dense + j * (degree + 1),
           (degree + 1) * sizeof *rows);
  }
}

void ph_ribbon_rows_at(size_t continuity, double s, size_t order,
                       struct ph_ribbon_rows *rows) {
  rows->s = s;
  set_rows(ph_ribbon_height_degree(continuity), s, order + continuity,
           PH_RIBBON_HEIGHT, rows->height[0]);
  set_rows(ph_ribbon_gradient_degree(continuity), s, order + continuity - 1,
           PH_RIBBON_GRADIENT, rows->gradient[0]);
  if (continuity == 2) {
    set_rows(5, s, order, PH_RIBBON_HESSIAN, rows->hessian[0]);
  }
}

/* ---- across -------------------------------------------------------------- */

/* Series at a place: a scalar or a vector for each power of s. */
struct series {
  double h[SERIES];
  ph_vec3 q[SERIES];        /* p' */
  ph_vec3 g[SERIES];        /* the gradient */
  ph_vec3 n[2], d[2], e[2]; /* normal, change of point and normal across */
  double gn[PH_CROSS_MAX], ge[PH_CROSS_MAX];
};

PH_INLINE double sum(const double *row, const double *c, size_t n) {
  double x = 0;
  for (size_t i = 0; i < n; i++) {
    x += row[i] * c[i];
  }
  return x;
}

PH_INLINE ph_vec3 between(const ph_vec3 *ends, double s) {
  return ph_vec3_of((1 - s) * ends[0].x + s * ends[1].x,
                    (1 - s) * ends[0].y + s * ends[1].y,
                    (1 - s) * ends[0].z + s * ends[1].z);
}

/* The linear series of what is between two ends. */
PH_INLINE void linear(const ph_vec3 *ends, double s, ph_vec3 *x) {
  x[0] = between(ends, s);
  x[1] = ph_vec3_sub(ends[1], ends[0]);
}

PH_INLINE double dot(const ph_vec3 *a, const ph_vec3 *b, size_t k) {
  double x = 0;
  for (size_t i = 0; i <= k; i++) {
    x += ph_vec3_dot(a[i], b[k - i]);
  }
  return x;
}

/* ... where b is linear. */
PH_INLINE double dot_linear(const ph_vec3 *a, const ph_vec3 *b, size_t k) {
  return ph_vec3_dot(a[k], b[0]) + (k ? ph_vec3_dot(a[k - 1], b[1]) : 0);
}

PH_INLINE double product(const double *a, const double *b, size_t k) {
  double x = 0;
  for (size_t i = 0; i <= k; i++) {
    x += a[i] * b[k - i];
  }
  return x;
}

/* Coefficient k of the quotient x of two series: that of the numerator is
 * `top'; x[0] to x[k - 1] are known. */
PH_INLINE double quotient(double top, const double *x, const double *below,
                          size_t k) {
  for (size_t i = 0; i < k; i++) {
    top -= x[i] * below[k - i];
  }
  return top / below[0];
}

/* The gradient along the ribbon, to the order m. */
PH_INLINE void set_gradient(const struct ph_side *side, size_t continuity,
                            const struct ph_ribbon_rows *rows, size_t m,
                            struct series *x) {
  const size_t height = ph_ribbon_height_degree(continuity) + 1;
  const size_t gradient = ph_ribbon_gradient_degree(continuity) + 1;
  const ph_vec3 edge = ph_vec3_sub(side->p[1], side->p[0]);
  double along[SERIES], square[SERIES];
  linear(side->g, rows->s, x->n);
  for (size_t k = 0; k <= m + 1; k++) {
    x->h[k] = sum(rows->height[k], side->ribbon.height, height);
  }
  for (size_t k = 0; k <= m; k++) {
    const ph_vec3 p =
        ph_vec3_along(ph_vec3_scale(x->h[k + 1], x->n[0]), x->h[k], x->n[1]);
    x->q[k] = ph_vec3_scale((double)(k + 1), k ? p : ph_vec3_add(p, edge));
    x->g[k] =
        ph_vec3_of(sum(rows->gradient[k], side->ribbon.gradient[0], gradient),
                   sum(rows->gradient[k], side->ribbon.gradient[1], gradient),
                   sum(rows->gradient[k], side->ribbon.gradient[2], gradient));
  }
  for (size_t k = 0; k <= m; k++) {
    square[k] = dot(x->q, x->q, k);
    along[k] = quotient(dot(x->g, x->q, k), along, square, k);
  }
  for (size_t k = m + 1; k-- > 0;) {
    for (size_t i = 0; i <= k; i++) {
      x->g[k] = ph_vec3_along(x->g[k], -along[i], x->q[k - i]);
    }
  }
}

/* b^T H b along the ribbon, with the H of (6.19): with r = g' - H^ q it is
 *   b^T H^ b + 2 (r.b) (q.b) / q.q - (q.r) ((q.b) / q.q)^2. */
PH_INLINE void set_form(const struct ph_side *side,
                        const struct ph_ribbon_rows *rows, size_t order,
                        const struct series *x, const ph_vec3 *b,
                        double *form) {
  struct ph_sym3 H[PH_CROSS_MAX];
  ph_vec3 r[PH_CROSS_MAX], Hb[PH_CROSS_MAX];
  double qq[PH_CROSS_MAX], qr[PH_CROSS_MAX], rb[PH_CROSS_MAX];
  double part[PH_CROSS_MAX], other[PH_CROSS_MAX];
  for (size_t k = 0; k <= order; k++) {
    for (size_t i = 0; i < 6; i++) {
      H[k].c[i] =
          sum(rows->hessian[k], side->ribbon.hessian[i], PH_RIBBON_HESSIAN);
    }
    r[k] = ph_vec3_scale((double)(k + 1), x->g[k + 1]);
    Hb[k] = ph_vec3_of(0, 0, 0);
    for (size_t i = 0; i <= k; i++) {
      r[k] = ph_vec3_sub(r[k], ph_sym3_apply(&H[i], x->q[k - i]));
      Hb[k] = ph_vec3_add(Hb[k], ph_sym3_apply(&H[i], b[k - i]));
    }
  }
  for (size_t k = 0; k <= order; k++) {
    qq[k] = dot(x->q, x->q, k);
    qr[k] = dot(x->q, r, k);
    rb[k] = 2 * dot(r, b, k);
    part[k] = quotient(dot(x->q, b, k), part, qq, k);
  }
  for (size_t k = 0; k <= order; k++) {
    other[k] = rb[k] - product(qr, part, k);
  }
  for (size_t k = 0; k <= order; k++) {
    form[k] = dot(b, Hb, k) + product(other, part, k);
  }
}

/* How far b_w turns the tangent plane. */
PH_INLINE void set_plane(const struct series *x, struct ph_cross *cross) {
  const double g = ph_vec3_abs(x->g[0]);
  const ph_vec3 b = ph_vec3_along(
      ph_vec3_along(x->d[0], cross->h[1][0], x->n[0]), cross->h[0][0], x->e[0]);
  cross->speed = ph_vec3_abs(x->q[0]);
  cross->across = ph_vec3_abs(ph_vec3_cross(x->q[0], b)) / cross->speed;
  cross->cosine = x->gn[0] / g / ph_vec3_abs(x->n[0]);
  cross->tilt = fabs(x->gn[0]) / g / cross->across;
}

PH_INLINE void evaluate(const struct ph_side *side, size_t continuity,
                        const struct ph_ribbon_rows *rows, size_t order,
                        struct ph_cross *cross) {
  const size_t m = order + continuity - 1;
  struct series x;
  ph_vec3 b[PH_CROSS_MAX];
  double form[PH_CROSS_MAX], *h = cross->h[1];
  set_gradient(side, continuity, rows, m, &x);
  linear(side->to, rows->s, x.d);
  linear(side->turn, rows->s, x.e);
  for (size_t k = 0; k <= order; k++) {
    cross->h[0][k] = x.h[k];
    x.gn[k] = dot_linear(x.g, x.n, k);
    x.ge[k] = dot_linear(x.g, x.e, k);
  }
  for (size_t k = 0; k <= order; k++) {
    h[k] =
        quotient(-dot_linear(x.g, x.d, k) - product(x.h, x.ge, k), h, x.gn, k);
  }
  set_plane(&x, cross);
  if (continuity < 2) {
    return;
  }
  for (size_t k = 0; k <= order; k++) {
    b[k] = ph_vec3_along(ph_vec3_scale(h[k], x.n[0]), x.h[k], x.e[0]);
    if (k < 2) {
      b[k] = ph_vec3_add(b[k], x.d[k]);
    }
    if (k > 0) {
      b[k] = ph_vec3_along(ph_vec3_along(b[k], h[k - 1], x.n[1]), x.h[k - 1],
                           x.e[1]);
    }
  }
  set_form(side, rows, order, &x, b, form);
  for (size_t k = 0; k <= order; k++) { /* half of h_ww */
    cross->h[2][k] =
        quotient(-form[k] / 2 - product(h, x.ge, k), cross->h[2], x.gn, k);
  }
}

void ph_side_at(const struct ph_side *side, size_t continuity,
                const struct ph_ribbon_rows *rows, size_t order,
                struct ph_cross *cross) {
  if (order > 0) {
    evaluate(side, continuity, rows, order, cross);
  } else if (continuity == 1) { /* for the compiler, */
    evaluate(side, 1, rows, 0, cross);
  } else { /* whose loops then are short */
    evaluate(side, 2, rows, 0, cross);
  }
}
