/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Quintic Hermite pieces of planar curves and offsets (see hermite.h). */
#include "curve/hermite.h"

#include "curve/seg2.h"

#include <math.h>

/* A million pieces of a segment are not what anybody wants. */
enum { HALVINGS_MAX = 20, NODES = 12, PROBES = 8 };

struct walk {
  struct ph_quad rule;
  struct ph_seg2 seg;
  size_t segment;
  double distance, tolerance;
  bool fill; /* false: only count */
  struct ph_pieces *pieces;
};

/* The exact curve at a parameter: position, derivatives by u. */
struct jet {
  ph_cplx r, first, second;
};

/* With left normal n = i t:  r_d = r + d n,  r_d' = (1 - d kappa) r'. */
static struct jet jet_at(const struct walk *walk, double u) {
  struct ph_bend bend = ph_seg2_bend(&walk->seg, u);
  double d = walk->distance, shrink = 1 - d * bend.curvature;
  ph_cplx w[2], square, slope;
  struct jet jet;
  ph_atph_jet(&walk->seg.space, walk->seg.w, u, w, 2);
  square = ph_cplx_mul(w[0], w[0]);
  slope = ph_cplx_scale(2 * shrink, ph_cplx_mul(w[0], w[1]));
  jet.r = ph_seg2_point(&walk->seg, &walk->rule, u);
  jet.r.re -= d * bend.tangent.im;
  jet.r.im += d * bend.tangent.re;
  jet.first = ph_cplx_scale(shrink, square);
  jet.second = ph_cplx_sub(slope, ph_cplx_scale(d * bend.slope, square));
  return jet;
}

static void bezier_of(const struct jet *a, const struct jet *b, double h,
                      ph_cplx p[6]) {
  ph_cplx a1 = ph_cplx_scale(h / 5, a->first);
  ph_cplx b1 = ph_cplx_scale(h / 5, b->first);
  p[0] = a->r;
  p[1] = ph_cplx_add(a->r, a1);
  p[2] =
      ph_cplx_add(ph_cplx_add(p[1], a1), ph_cplx_scale(h * h / 20, a->second));
  p[5] = b->r;
  p[4] = ph_cplx_sub(b->r, b1);
  p[3] =
      ph_cplx_add(ph_cplx_sub(p[4], b1), ph_cplx_scale(h * h / 20, b->second));
}

/* De Casteljau. */
static ph_cplx bezier_at(const ph_cplx p[6], double x) {
  ph_cplx q[6];
  for (size_t i = 0; i < 6; i++) {
    q[i] = p[i];
  }
  for (size_t n = 5; n > 0; n--) {
    for (size_t i = 0; i < n; i++) {
      q[i].re += x * (q[i + 1].re - q[i].re);
      q[i].im += x * (q[i + 1].im - q[i].im);
    }
  }
  return q[0];
}

/* The greatest distance from the exact curve; NaN if there is one. */
static double error_of(const struct walk *walk, const ph_cplx p[6], double u0,
                       double u1) {
  double worst = 0;
  for (size_t i = 1; i < PROBES; i++) {
    double x = (double)i / PROBES;
    struct jet exact = jet_at(walk, u0 + x * (u1 - u0));
    double error = ph_cplx_abs(ph_cplx_sub(bezier_at(p, x), exact.r));
    if (!(error <= worst)) {
      worst = error;
    }
  }
  return worst;
}

static void put(struct walk *walk, const ph_cplx p[6], double u0, double u1,
                double error) {
  struct ph_pieces *pieces = walk->pieces;
  size_t at = pieces->n++;
  if (walk->fill) {
    pieces->segment[at] = walk->segment;
    pieces->interval[2 * at] = u0;
    pieces->interval[2 * at + 1] = u1;
    for (size_t i = 0; i < 6; i++) {
      pieces->control_points[12 * at + 2 * i] = p[i].re;
      pieces->control_points[12 * at + 2 * i + 1] = p[i].im;
    }
  }
  pieces->error = error > pieces->error ? error : pieces->error;
}

static bool visit(struct walk *walk, const struct jet *a, double u0,
                  const struct jet *b, double u1, int depth) {
  ph_cplx p[6];
  double error, middle = 0.5 * (u0 + u1);
  struct jet m;
  bezier_of(a, b, u1 - u0, p);
  error = error_of(walk, p, u0, u1);
  if (error <= walk->tolerance) {
    put(walk, p, u0, u1, error);
    return true;
  }
  if (depth == HALVINGS_MAX || !isfinite(error)) {
    return false;
  }
  m = jet_at(walk, middle);
  return visit(walk, a, u0, &m, middle, depth + 1) &&
         visit(walk, &m, middle, b, u1, depth + 1);
}

static enum ph_status visit_all(struct walk *walk, const struct ph_curve *curve,
                                struct ph_diag *diag) {
  walk->pieces->n = 0;
  walk->pieces->error = 0;
  for (size_t k = 0; k < curve->n; k++) {
    struct jet a, b;
    walk->segment = k;
    walk->seg = ph_seg2_of(curve, k);
    a = jet_at(walk, 0);
    b = jet_at(walk, 1);
    if (!visit(walk, &a, 0, &b, 1, 0)) {
      return ph_fail_at(diag, PH_NO_CONVERGENCE, "segments", k,
                        "has no Bezier pieces within %.3g of the exact curve",
                        walk->tolerance);
    }
  }
  return PH_OK;
}

enum ph_status ph_hermite_pieces(const struct ph_curve *curve, double distance,
                                 double tolerance, struct ph_arena *arena,
                                 struct ph_pieces *pieces,
                                 struct ph_diag *diag) {
  struct walk walk = {
      .distance = distance, .tolerance = tolerance, .pieces = pieces};
  enum ph_status status;
  *pieces = (struct ph_pieces){.degree = 5, .dimension = 2};
  if (!ph_quad_gauss(&walk.rule, NODES)) {
    return ph_fail_memory(diag);
  }
  status = visit_all(&walk, curve, diag);
  if (status != PH_OK) {
    return status;
  }
  pieces->segment = ph_arena_array(arena, pieces->n, sizeof(size_t));
  pieces->interval = ph_arena_array(arena, pieces->n, 2 * sizeof(double));
  pieces->control_points =
      ph_arena_array(arena, pieces->n, 12 * sizeof(double));
  if (!pieces->segment || !pieces->interval || !pieces->control_points) {
    return ph_fail_memory(diag);
  }
  walk.fill = true;
  return visit_all(&walk, curve, diag);
}
