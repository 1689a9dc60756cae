/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Claimed preimages (see root.h). */
#include "check/root.h"

#include "check/checks.h"

enum { N = PH_CHECK_JET };

/* Coefficients of a preimage are rounded, and so are products of them. */
static const double ROUND = 8 * DBL_EPSILON;

void ph_check_root_of(const struct ph_check *v,
                      const struct ph_check_segment *s,
                      struct ph_check_root *root) {
  double largest = 0;
  root->n = v->curve->preimage.n;
  root->angle = s->angle;
  root->middle = s->angle > 0 ? 2 * cos(s->angle / 2) : (double)(root->n - 1);
  ph_check_preimage(v, s->k, root->a);
  for (size_t i = 0; i < root->n; i++) {
    largest = ph_check_larger(largest, ph_quat_dot(root->a[i], root->a[i]));
  }
  root->error = ROUND * sqrt(largest);
}

static ph_quat along(ph_quat a, double s, ph_quat b) {
  return ph_quat_add(a, ph_quat_scale(s, b));
}

/* Of degree 1 or 2. */
static void polynomial_at(const struct ph_check_root *root, double u,
                          ph_quat *a) {
  const ph_quat *w = root->a, first = ph_quat_sub(w[1], w[0]);
  a[0] = along(ph_quat_scale(1 - u, w[0]), u, w[1]);
  a[1] = first;
  a[2] = ph_quat_of(0, 0, 0, 0);
  if (root->n > 2) {
    const ph_quat last = ph_quat_sub(w[2], w[1]);
    const ph_quat next = along(ph_quat_scale(1 - u, w[1]), u, w[2]);
    a[0] = along(ph_quat_scale(1 - u, a[0]), u, next);
    a[1] = ph_quat_scale(2, along(ph_quat_scale(1 - u, first), u, last));
    a[2] = ph_quat_sub(last, first);
  }
  a[3] = ph_quat_of(0, 0, 0, 0);
}

/* Of <1, sin t, cos t>: S0^2, 2 cos(a/2) S0 S1, S1^2. */
static void trigonometric_at(const struct ph_check_root *root, double u,
                             ph_quat *a) {
  double s[2][N];
  ph_check_basis(root->angle, u, N, s);
  for (size_t l = 0; l < N; l++) {
    double b[3] = {0, 0, 0};
    for (size_t m = 0; m <= l; m++) {
      b[0] += s[0][m] * s[0][l - m];
      b[1] += root->middle * s[0][m] * s[1][l - m];
      b[2] += s[1][m] * s[1][l - m];
    }
    a[l] = along(along(ph_quat_scale(b[0], root->a[0]), b[1], root->a[1]), b[2],
                 root->a[2]);
  }
}

void ph_check_root_at(const struct ph_check_root *root, double u, ph_quat *a) {
  if (root->angle > 0) {
    trigonometric_at(root, u, a);
  } else {
    polynomial_at(root, u, a);
  }
}

void ph_check_root_jet(const struct ph_check_root *root, double u, ph_vec3 *jet,
                       double *error, size_t n) {
  ph_quat a[N];
  double size[N], off[N], factorial = 1, next = root->error;
  ph_check_root_at(root, u, a);
  for (size_t l = 0; l < n; l++) {
    size[l] = ph_quat_abs(a[l]);
    off[l] = next;
    next *= (double)PH_CHECK_ROUND_NEXT / (double)(l + 1);
  }
  for (size_t l = 0; l < n; l++) {
    factorial *= l > 0 ? (double)l : 1;
    jet[l] = ph_vec3_of(0, 0, 0);
    error[l] = 0;
    for (size_t m = 0; 2 * m <= l; m++) { /* products are symmetric */
      const double times = (2 * m < l ? 2 : 1) * factorial;
      jet[l] = ph_vec3_along(jet[l], times, ph_quat_i(a[m], a[l - m]));
      error[l] += times * (size[m] * off[l - m] + size[l - m] * off[m] +
                           off[m] * off[l - m]);
    }
  }
}

/* ---- where it is least --------------------------------------------------- */

/* |r'|^2 */
static double square_at(const void *root, double u) {
  ph_quat a[N];
  double speed;
  ph_check_root_at(root, u, a);
  speed = ph_quat_dot(a[0], a[0]);
  return speed * speed;
}

/* Steps of Newton's method to where |A| is least, and how far they may lead. */
enum { STEPS = 4 };
static const double SLOWEST = 1e-4;

void ph_check_root_slow(const struct ph_check_root *root,
                        struct ph_check_dips *slow) {
  if (slow->n > 0) {
    *slow = ph_check_dips_of(square_at, root);
  }
  for (size_t i = 0; i < slow->n; i++) {
    ph_quat a[N];
    double u = slow->x[i];
    for (int step = 0; step < STEPS; step++) {
      ph_check_root_at(root, u, a);
      u -= ph_quat_dot(a[0], a[1]) / ph_quat_dot(a[1], a[1]);
    }
    if (fabs(u - slow->x[i]) < SLOWEST && u > 0 && u < 1) {
      slow->x[i] = u;
      slow->low = ph_check_smaller(slow->low, square_at(root, u));
    }
  }
}
