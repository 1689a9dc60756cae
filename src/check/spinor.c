/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Preimages as one spline, and its elements (see spinor.h). */
#include "check/spinor.h"

#include "check/error.h"

#include <float.h>
#include <math.h>

/* |A|^2 is of degree 4 in a segment. */
enum { NODES = 3 };

/* Of a difference of knots, in units of the rounding of the farthest. */
enum { ROUND_KNOT = 4 };

/* A speed that tells nothing, relative to the mean one. */
static const double SLOW = 1e-3;

/* Coefficient i of segment k at unit scale, by the local parameter. */
static ph_quat local_coefficient(const struct ph_spinor *s,
                                 const struct ph_curve *curve, size_t k,
                                 size_t i) {
  const double *v = curve->preimage.v + 12 * k + 4 * i;
  double root = 1 / sqrt(s->unit);
  return ph_quat_of(root * v[0], root * v[1], root * v[2], root * v[3]);
}

/* The same by the global parameter. */
static ph_quat coefficient(const struct ph_spinor *s,
                           const struct ph_curve *curve, size_t k, size_t i) {
  return ph_quat_scale(1 / sqrt(s->h[k]), local_coefficient(s, curve, k, i));
}

/*
 * The spacings.  Of a long curve the knots have too few digits for that, but
 * the preimage tells the ratios: A is the same at both sides of a joint, and
 * its coefficients are A times the root of the spacing.  A ratio that does not
 * agree with the knots, or where A all but vanishes, is none.
 */
static void set_spacings(struct ph_spinor *s, const struct ph_curve *curve,
                         double spacing) {
  const double *t = curve->knots;
  double farthest = ph_check_larger(fabs(t[0]), fabs(t[s->segments]));
  double rounding = ROUND_KNOT * DBL_EPSILON * farthest / spacing;
  for (size_t k = 0; k < s->segments; k++) {
    double h = (t[k + 1] - t[k]) / spacing;
    s->h[k] = h;
    if (k > 0) {
      ph_quat before = local_coefficient(s, curve, k - 1, 2);
      ph_quat after = local_coefficient(s, curve, k, 0);
      double size = ph_quat_dot(before, before);
      double better = s->h[k - 1] * ph_quat_dot(after, after) / size;
      if (size > SLOW * h && fabs(better - h) <= rounding) {
        s->h[k] = better;
      }
    }
  }
}

/* The weights of the nodes k, k + 1, k + 2 in the coefficients of segment k:
 * knots beyond the ends are as far away as those inside, or as at the seam. */
static void weights_of(const struct ph_spinor *s, bool closed, size_t k,
                       double c[3][3]) {
  size_t last = s->segments - 1;
  double h = s->h[k];
  double before = k > 0 ? s->h[k - 1] : closed ? s->h[last] : h;
  double after = k < last ? s->h[k + 1] : closed ? s->h[0] : h;
  c[0][0] = h / (before + h);
  c[0][1] = before / (before + h);
  c[1][1] = 1;
  c[2][1] = after / (h + after);
  c[2][2] = h / (h + after);
  c[0][2] = c[1][0] = c[1][2] = c[2][0] = 0;
}

static bool is_closed(const struct ph_spinor *s) {
  return s->stored == s->segments;
}

/* The nodes beyond the ends; those of a closed spline from the other end, with
 * the phase by which the preimage misses itself at the seam. */
static void set_ends(struct ph_spinor *s, const struct ph_curve *curve) {
  size_t m = s->segments;
  ph_quat first = coefficient(s, curve, 0, 0);
  ph_quat last = coefficient(s, curve, m - 1, 2);
  s->seam = ph_cplx_of(1, 0);
  if (is_closed(s)) {
    ph_quat turn = ph_quat_between(first, last);
    double size = hypot(turn.u, turn.v);
    if (size > 0) {
      s->seam = ph_cplx_of(turn.u / size, turn.v / size);
    }
    s->w[0] = ph_quat_turn(s->w[m], ph_cplx_conj(s->seam));
    s->w[m + 1] = ph_quat_turn(s->w[1], s->seam);
  } else {
    s->w[0] = ph_quat_sub(ph_quat_scale(2, first), s->w[1]);
    s->w[m + 1] = ph_quat_sub(ph_quat_scale(2, last), s->w[m]);
  }
}

/* The largest node, and how far the coefficients are from the spline's. */
static void measure(struct ph_spinor *s, const struct ph_curve *curve) {
  double defect = 0;
  s->largest = 0;
  for (size_t j = 0; j < s->segments + 2; j++) {
    s->largest = ph_check_larger(s->largest, ph_quat_dot(s->w[j], s->w[j]));
  }
  for (size_t k = 0; k < s->segments; k++) {
    double c[3][3];
    weights_of(s, is_closed(s), k, c);
    for (size_t i = 0; i < 3; i += 2) {
      ph_quat miss = coefficient(s, curve, k, i);
      for (size_t a = 0; a < 3; a++) {
        miss = ph_quat_sub(miss, ph_quat_scale(c[i][a], s->w[k + a]));
      }
      double size = ph_quat_dot(miss, miss);
      defect = ph_check_is_larger(size, defect) ? size : defect;
    }
  }
  s->defect = sqrt(defect / s->largest);
}

enum ph_status ph_spinor_of(const struct ph_curve *curve,
                            const struct ph_spinor_rows *rows,
                            struct ph_arena *arena, struct ph_spinor *s,
                            struct ph_diag *diag) {
  size_t m = curve->n;
  double n = (double)rows->n;
  double spacing = (curve->knots[m] - curve->knots[0]) / n;
  s->rows = *rows;
  s->segments = m;
  s->stored = curve->closed ? m : m + 2;
  s->unit = curve->length / n;
  s->w = ph_arena_array(arena, m + 2, sizeof *s->w);
  s->h = ph_arena_array(arena, m, sizeof *s->h);
  if (!s->w || !s->h || !ph_quad_gauss(&s->rule, NODES)) {
    return ph_fail_memory(diag);
  }
  set_spacings(s, curve, spacing);
  for (size_t k = 0; k < m; k++) {
    s->w[k + 1] = coefficient(s, curve, k, 1);
  }
  set_ends(s, curve);
  measure(s, curve);
  return PH_OK;
}

static void add_form(struct ph_spinor_element *e, double s, ph_vec3 v) {
  struct ph_spinor_form form = {s, v};
  e->form[e->rows++] = form;
}

static struct ph_spinor_element segment_of(const struct ph_spinor *s,
                                           size_t k) {
  struct ph_spinor_element e = {.first = k, .nodes = 3};
  double c[3][3], h = s->h[k], power = 2 / (h * sqrt(h));
  weights_of(s, is_closed(s), k, c);
  for (size_t i = 0; i < s->rule.n; i++) {
    double u = s->rule.node[i], b[3];
    for (size_t a = 0; a < 3; a++) {
      b[a] = (1 - u) * (1 - u) * c[0][a] + 2 * u * (1 - u) * c[1][a] +
             u * u * c[2][a];
    }
    for (size_t a = 0; a < 3; a++) {
      for (size_t j = 0; j < 3; j++) {
        e.gram[a][j] += h * s->rule.weight[i] * b[a] * b[j];
      }
    }
  }
  for (size_t a = 0; a < 3; a++) {
    e.second[a] = power * (c[0][a] - 2 * c[1][a] + c[2][a]);
  }
  e.row = k / s->rows.refine * ph_spinor_interval_rows(s);
  if (s->rows.lengths) {
    add_form(&e, 1, ph_vec3_of(0, 0, 0));
  }
  if (s->rows.points) {
    add_form(&e, 0, ph_vec3_of(1, 0, 0));
    add_form(&e, 0, ph_vec3_of(0, 1, 0));
    add_form(&e, 0, ph_vec3_of(0, 0, 1));
  }
  return e;
}

/* The knot before interval j: r' there, or its components that are normal to
 * what they are, in which a curve with that direction has none. */
static struct ph_spinor_element knot_of(const struct ph_spinor *s, size_t j) {
  struct ph_spinor_element e = {.first = s->rows.refine * j, .nodes = 2};
  double c[3][3];
  size_t last = s->segments - 1;
  bool end = e.first > last;
  weights_of(s, false, end ? last : e.first, c);
  for (size_t a = 0; a < 2; a++) {
    for (size_t b = 0; b < 2; b++) {
      e.gram[a][b] = end ? c[2][a + 1] * c[2][b + 1] : c[0][a] * c[0][b];
    }
  }
  e.row = s->rows.n * ph_spinor_interval_rows(s) + j * s->rows.knot_rows;
  if (s->rows.knot_rows == 3) {
    add_form(&e, 0, ph_vec3_of(1, 0, 0));
    add_form(&e, 0, ph_vec3_of(0, 1, 0));
    add_form(&e, 0, ph_vec3_of(0, 0, 1));
  } else if (s->rows.toward && ph_vec3_abs(s->rows.toward[j]) > 0) {
    add_form(&e, 1, ph_vec3_scale(-1, s->rows.toward[j]));
    add_form(&e, 0, ph_vec3_of(0, 0, 0));
  } else {
    double x = end ? c[2][1] : c[0][0], y = end ? c[2][2] : c[0][1];
    ph_quat m = ph_quat_add(ph_quat_scale(x, s->w[e.first]),
                            ph_quat_scale(y, s->w[e.first + 1]));
    ph_vec3 normal = ph_vec3_unit(ph_quat_j(m, m));
    add_form(&e, 0, normal);
    add_form(&e, 0, ph_vec3_unit(ph_quat_k(m, m)));
  }
  return e;
}

struct ph_spinor_element ph_spinor_element_of(const struct ph_spinor *s,
                                              size_t k) {
  return k < s->segments ? segment_of(s, k) : knot_of(s, k - s->segments);
}
