/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Tschirnhausen cubics for tests (see tc_curve_unit.h). */
#include "tc_curve_unit.h"

#include "kernel/bern.h"

/* t (w0^2 + t (w0 d + t/3 d^2)), d = w1 - w0 */
ph_cplx unit_tc_at(const struct ph_tc *tc, double t) {
  const long double a = (long double)tc->w[0].re, b = (long double)tc->w[0].im;
  const long double c = (long double)tc->w[1].re - a;
  const long double d = (long double)tc->w[1].im - b, x = (long double)t;
  long double re = a * c - b * d + x / 3 * (c * c - d * d);
  long double im = a * d + b * c + x / 3 * (2 * c * d);
  re = x * (a * a - b * b + x * re);
  im = x * (2 * a * b + x * im);
  return ph_cplx_of((double)re, (double)im);
}

void unit_cubics_begin(struct unit_cubics *c, ph_cplx start) {
  memset(c, 0, sizeof *c);
  c->at = start;
  c->curve = (struct ph_curve){.kind = PH_CURVE_TC,
                               .dimension = 2,
                               .degree = 3,
                               .knots = c->knots,
                               .control_points = c->control_points,
                               .preimage.n = 2,
                               .preimage.dimension = 2,
                               .preimage.v = c->preimage,
                               .lengths = c->lengths};
}

void unit_cubics_add(struct unit_cubics *c, ph_cplx w0, ph_cplx w1) {
  const size_t k = c->curve.n++;
  const long double a = (long double)w0.re, b = (long double)w0.im;
  const long double g = (long double)w1.re, h = (long double)w1.im;
  const long double re[3] = {a * a - b * b, a * g - b * h, g * g - h * h};
  const long double im[3] = {2 * a * b, a * h + b * g, 2 * g * h};
  long double x = (long double)c->at.re, y = (long double)c->at.im;
  double *p = c->control_points + 8 * k, *w = c->preimage + 4 * k;
  ck_assert_uint_lt(k, UNIT_CUBICS);
  p[0] = c->at.re;
  p[1] = c->at.im;
  for (size_t i = 0; i < 3; i++) {
    x += re[i] / 3;
    y += im[i] / 3;
    p[2 * i + 2] = (double)x;
    p[2 * i + 3] = (double)y;
  }
  c->at = ph_cplx_of((double)x, (double)y);
  w[0] = w0.re;
  w[1] = w0.im;
  w[2] = w1.re;
  w[3] = w1.im;
  c->lengths[k] = (double)((a * a + b * b + a * g + b * h + g * g + h * h) / 3);
  c->curve.length += c->lengths[k];
  c->knots[k + 1] = (double)k + 1;
}

void unit_cubics_random(struct unit_cubics *c, struct unit_random *r, size_t n,
                        double scale, ph_cplx start) {
  double direction = unit_random_in(r, -3, 3), root = sqrt(scale);
  ph_cplx w0 = ph_cplx_scale(root * unit_random_in(r, 0.2, 1.5),
                             ph_cplx_polar(direction));
  unit_cubics_begin(c, start);
  for (size_t k = 0; k < n; k++) {
    ph_cplx w1;
    direction += unit_random_in(r, -2.9, 2.9);
    w1 = ph_cplx_scale(root * unit_random_in(r, 0.2, 1.5),
                       ph_cplx_polar(direction));
    unit_cubics_add(c, w0, w1);
    w0 = w1;
  }
}

static ph_cplx preimage(const struct unit_cubics *c, size_t k, size_t i) {
  const double *w = c->preimage + 4 * k + 2 * i;
  return ph_cplx_of(w[0], w[1]);
}

double unit_cubic_bend(const struct unit_cubics *c, size_t k) {
  return ph_cplx_cross(preimage(c, k, 0), preimage(c, k, 1));
}

double unit_cubic_slowest(const struct unit_cubics *c, size_t k) {
  ph_cplx w0 = preimage(c, k, 0), w1 = preimage(c, k, 1);
  ph_cplx along = ph_cplx_sub(w1, w0);
  double bend = unit_cubic_bend(c, k);
  bool within = ph_cplx_dot(w0, along) < 0 && ph_cplx_dot(w1, along) > 0;
  return within ? bend / ph_cplx_norm2(along) * bend
                : fmin(ph_cplx_norm2(w0), ph_cplx_norm2(w1));
}

/* ---- approximations ------------------------------------------------------ */

enum { DEGREE_MAX = 128, STARTS = 400, SAMPLES = 13 };

ph_cplx unit_bezier_at(const struct ph_tc_bezier *curve, double u) {
  double basis[DEGREE_MAX + 1];
  ph_cplx sum = {0, 0};
  ph_bern_basis(curve->degree, u, basis);
  for (size_t k = 0; k <= curve->degree; k++) {
    sum = ph_cplx_add(sum, ph_cplx_scale(basis[k], curve->p[k]));
  }
  return sum;
}

/* A curve on [0,1], whatever it is. */
struct path {
  const struct ph_tc_bezier *curve; /* or */
  const struct ph_tc_arc *arc;
};

static ph_cplx path_at(const struct path *path, double u) {
  return path->curve
             ? unit_bezier_at(path->curve, u)
             : ph_cplx_add(path->arc->start, unit_tc_at(&path->arc->tc, u));
}

/* The distance of p from the path on [a,b], which is short. */
static double nearer(const struct path *path, ph_cplx p, double a, double b) {
  const double golden = 0.6180339887498949;
  for (int i = 0; i < 64; i++) {
    double x = b - golden * (b - a), y = a + golden * (b - a);
    bool left =
        unit_distance(path_at(path, x), p) < unit_distance(path_at(path, y), p);
    a = left ? a : x;
    b = left ? y : b;
  }
  return unit_distance(path_at(path, (a + b) / 2), p);
}

/* All short parts are looked at that may hold a nearer point than those seen:
 * a part that is L long and x and y away at its ends is (x + y - L)/2 away. */
static double path_away(const struct path *path, ph_cplx p, int starts) {
  const double longer = 1.2; /* a part than its chord */
  double away[STARTS + 1], length[STARTS + 1], best = (double)INFINITY;
  ph_cplx before = path_at(path, 0);
  for (int i = 0; i <= starts; i++) {
    ph_cplx here = path_at(path, (double)i / starts);
    away[i] = unit_distance(here, p);
    length[i] = longer * unit_distance(here, before);
    best = fmin(away[i], best);
    before = here;
  }
  for (int i = 1; i <= starts; i++) {
    if (away[i - 1] + away[i] - length[i] <= 2 * best) {
      double a = (double)(i - 1) / starts, b = (double)i / starts;
      best = fmin(nearer(path, p, a, b), best);
    }
  }
  return best;
}

double unit_bezier_away(const struct ph_tc_bezier *curve, ph_cplx p) {
  struct path path = {curve, NULL};
  return path_away(&path, p, STARTS);
}

double unit_arcs_away(const struct ph_tc_arc *arcs, size_t n, ph_cplx p) {
  double best = (double)INFINITY;
  for (size_t i = 0; i < n; i++) {
    struct path path = {NULL, &arcs[i]};
    /* only those that may be nearer */
    if (unit_distance(arcs[i].start, p) - ph_tc_length(&arcs[i].tc) < best) {
      best = fmin(best, path_away(&path, p, 24));
    }
  }
  return best;
}

/* Where every step takes long, by one in four of the points, in turn. */
double unit_arcs_distance(const struct ph_tc_bezier *curve,
                          const struct ph_tc_arcs *arcs) {
  size_t step = unit_count(10) < 10 ? 4 : 1;
  double distance = 0;
  for (size_t i = 0; i < arcs->n; i++) {
    const struct ph_tc_arc *arc = &arcs->arc[i];
    for (size_t k = i % step; k <= SAMPLES; k += step) {
      double t = (double)k / SAMPLES;
      ph_cplx on_arc = ph_cplx_add(arc->start, unit_tc_at(&arc->tc, t));
      ph_cplx on_curve =
          unit_bezier_at(curve, arc->from + t * (arc->to - arc->from));
      distance = unit_larger(unit_bezier_away(curve, on_arc), distance);
      distance =
          unit_larger(unit_arcs_away(arcs->arc, arcs->n, on_curve), distance);
    }
  }
  return distance;
}
