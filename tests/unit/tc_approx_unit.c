/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Distances by sampling (see tc_approx_unit.h). */
#include "tc_approx_unit.h"

#include "kernel/bern.h"
#include "unit.h"
#include "tc_curve_unit.h"

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
