/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Quintic Hermite pieces of curves and offsets (see hermite.h): two sources of
 * points and derivatives, for the plane and for space, and one engine.
 */
#include "curve/bezier/hermite.h"

#include "curve/segment/seg2.h"
#include "kernel/golden.h"

#include <float.h>
#include <math.h>

/* A dip of the speed may take 1e-12 of a segment; a million pieces are not what
 * anybody wants. */
enum { HALVINGS_MAX = 44, PIECES_MAX = 1 << 20, NODES = 12 };

/* Where |r'|, which has two dips at most, falls far, an offset moves aside
 * within a short part of the segment.  Cells among which dips are searched,
 * steps that find one, and the places that are looked at for them. */
enum { CELLS = 32, STEPS = 40, DIPS = 2, SLOW = 3 * DIPS };

/* What takes more of a segment is seen without that. */
static const double SHORT = 0.25;

/* The greatest distance of a piece is looked for between so many places where
 * it is more than this part of what it may be, or of the greatest so far. */
static const double NEARLY = 0.8;
enum { PEAKS = 16 };

/* The exact curve at a parameter: position, derivatives by u.  In the plane,
 * z = 0. */
struct jet {
  ph_vec3 r, first, second;
};

/* Part of a segment that gets a piece. */
struct part {
  struct part *next;
  size_t segment;
  double from, to;
};

struct walk {
  const struct ph_curve *curve;
  double distance, tolerance, rounding;
  enum ph_normal normal;
  struct ph_quad rule;
  size_t segment, before; /* pieces of those before it */
  struct ph_seg2 seg2;    /* the segment, in the plane or in space */
  struct ph_seg3 seg3;
  struct jet (*jet_at)(const struct walk *walk, double u);
  double slow[SLOW]; /* places where it is slow, of [0,1] and beyond */
  size_t slow_n;
  struct ph_pieces *pieces; /* n and error of the parts so far */
  struct part **end;        /* of their list */
  struct ph_arena *arena;
  struct ph_diag *diag;
};

static ph_vec3 in_space(ph_cplx z) {
  return ph_vec3_of(z.re, z.im, 0);
}

/* With left normal n = i t:  r_d = r + d n,  r_d' = (1 - d kappa) r'. */
static struct jet planar_jet(const struct walk *walk, double u) {
  const struct ph_seg2 *seg = &walk->seg2;
  struct ph_curvature at = ph_seg2_curvature(seg, u);
  double d = walk->distance, shrink = 1 - d * at.curvature;
  ph_cplx w[2], square, second, r = ph_seg2_point(seg, &walk->rule, u);
  struct jet jet;
  ph_atph_jet(&seg->space, seg->w, u, w, 2);
  square = ph_cplx_mul(w[0], w[0]);
  second = ph_cplx_scale(2 * shrink, ph_cplx_mul(w[0], w[1]));
  r.re -= d * at.tangent.im;
  r.im += d * at.tangent.re;
  jet.r = in_space(r);
  jet.first = in_space(ph_cplx_scale(shrink, square));
  jet.second =
      in_space(ph_cplx_sub(second, ph_cplx_scale(d * at.rate, square)));
  return jet;
}

/* With n = A j A* or A k A*, e = n / s and s = |A|^2:
 *   e' = (n' - s' e) / s,  e'' = (n'' - 2 s' e' - s'' e) / s. */
static void move(struct jet *jet, const ph_quat a[3], double distance,
                 enum ph_normal normal) {
  double per_s = 1 / ph_quat_dot(a[0], a[0]);
  double s1 = 2 * ph_quat_dot(a[0], a[1]);
  double s2 = 2 * (ph_quat_dot(a[0], a[2]) + ph_quat_dot(a[1], a[1]));
  ph_vec3 n1 = ph_vec3_scale(2, ph_normal_between(normal, a[0], a[1]));
  ph_vec3 n2 =
      ph_vec3_scale(2, ph_vec3_add(ph_normal_between(normal, a[0], a[2]),
                                   ph_normal_between(normal, a[1], a[1])));
  ph_vec3 e = ph_vec3_scale(per_s, ph_normal_between(normal, a[0], a[0]));
  ph_vec3 e1 = ph_vec3_scale(per_s, ph_vec3_along(n1, -s1, e));
  ph_vec3 e2 = ph_vec3_scale(
      per_s, ph_vec3_along(ph_vec3_along(n2, -2 * s1, e1), -s2, e));
  jet->r = ph_vec3_along(jet->r, distance, e);
  jet->first = ph_vec3_along(jet->first, distance, e1);
  jet->second = ph_vec3_along(jet->second, distance, e2);
}

static struct jet spatial_jet(const struct walk *walk, double u) {
  ph_quat a[3];
  struct jet jet;
  ph_seg3_jet(&walk->seg3, u, a, 3);
  jet.r = ph_seg3_point(&walk->seg3, &walk->rule, u);
  jet.first = ph_quat_i(a[0], a[0]);
  jet.second = ph_vec3_scale(2, ph_quat_i(a[0], a[1]));
  if (fabs(walk->distance) > 0) {
    move(&jet, a, walk->distance, walk->normal);
  }
  return jet;
}

static void bezier_of(const struct jet *a, const struct jet *b, double h,
                      ph_vec3 p[6]) {
  p[0] = a->r;
  p[1] = ph_vec3_along(a->r, h / 5, a->first);
  p[2] = ph_vec3_along(ph_vec3_along(p[1], h / 5, a->first), h * h / 20,
                       a->second);
  p[5] = b->r;
  p[4] = ph_vec3_along(b->r, -h / 5, b->first);
  p[3] = ph_vec3_along(ph_vec3_along(p[4], -h / 5, b->first), h * h / 20,
                       b->second);
}

/* |A| and |A'|, or |w| and |w'|; ret  A . A', of the sign of |A|' */
static double preimage_at(const struct walk *walk, double u, double size[2]) {
  ph_quat a[2];
  if (walk->curve->dimension == 2) {
    ph_cplx w[2];
    ph_atph_jet(&walk->seg2.space, walk->seg2.w, u, w, 2);
    a[0] = ph_quat_of(w[0].re, w[0].im, 0, 0);
    a[1] = ph_quat_of(w[1].re, w[1].im, 0, 0);
  } else {
    ph_seg3_jet(&walk->seg3, u, a, 2);
  }
  size[0] = ph_quat_abs(a[0]);
  size[1] = ph_quat_abs(a[1]);
  return ph_quat_dot(a[0], a[1]);
}

static double size_at(const void *walk, double u) {
  double size[2];
  preimage_at(walk, u, size);
  return size[0];
}

/* Places of dips, and beside each, where the curve has turned by a quarter. */
static void find_slow(struct walk *walk) {
  double g[CELLS + 1], size[2];
  const bool falls = preimage_at(walk, 0, size) < 0;
  const bool rises = preimage_at(walk, 1, size) > 0;
  walk->slow_n = 0;
  for (size_t i = 0; i <= CELLS; i++) {
    g[i] = size_at(walk, (double)i / CELLS);
  }
  for (size_t i = 0; i <= CELLS && walk->slow_n + 3 <= SLOW; i++) {
    const size_t before = i > 0 ? i - 1 : i, after = i < CELLS ? i + 1 : i;
    if ((i > 0 ? g[i] < g[before] : falls) &&
        (i < CELLS ? g[i] <= g[after] : rises)) {
      struct ph_bracket b = {(double)before / CELLS, (double)i / CELLS,
                             (double)after / CELLS, g[i]};
      double width;
      ph_golden(size_at, walk, STEPS, &b);
      preimage_at(walk, b.x, size);
      width = size[0] / size[1];
      for (int side = -1; side <= 1 && width < SHORT; side++) {
        walk->slow[walk->slow_n++] = b.x + side * width;
      }
    }
  }
}

/* A part of the segment, and its piece. */
struct piece {
  const struct walk *walk;
  ph_vec3 p[6];
  double u0, u1;
};

/* The distance from the exact curve at x in [0,1]. */
static double error_at(const void *context, double x) {
  const struct piece *piece = context;
  const struct walk *walk = piece->walk;
  struct jet exact =
      walk->jet_at(walk, piece->u0 + x * (piece->u1 - piece->u0));
  ph_vec3 away = ph_vec3_sub(ph_hermite_at(piece->p, 5, x), exact.r);
  return hypot(hypot(away.x, away.y), away.z); /* at any scale */
}

/* The greatest distance from the exact curve, or the first one seen that is not
 * within the tolerance; where it tends to be greatest it is seen first. */
static double error_of(const struct piece *piece) {
  static const double at[] = {0.5, 0.375, 0.625, 0.25, 0.75, 0.125, 0.875};
  const size_t n = sizeof at / sizeof at[0];
  const struct walk *walk = piece->walk;
  double worst = 0;
  for (size_t i = 0; i < n + walk->slow_n && worst <= walk->tolerance; i++) {
    double x = i < n
                   ? at[i]
                   : (walk->slow[i - n] - piece->u0) / (piece->u1 - piece->u0);
    if (x > 0 && x < 1) {
      double error = error_at(piece, x);
      worst = error <= worst ? worst : error;
    }
  }
  return worst;
}

static enum ph_status found(struct walk *walk, double u0, double u1,
                            double error) {
  struct part *part = ph_arena_array(walk->arena, 1, sizeof *part);
  struct ph_pieces *pieces = walk->pieces;
  if (!part) {
    return ph_fail_memory(walk->diag);
  }
  *part = (struct part){NULL, walk->segment, u0, u1};
  *walk->end = part;
  walk->end = &part->next;
  pieces->n++;
  pieces->error = error > pieces->error ? error : pieces->error;
  return PH_OK;
}

/* Whether derivatives, which are less than 64 times the speed, may leave the
 * range of a double. */
static bool is_too_fast(const struct walk *walk) {
  double most = 0;
  for (size_t i = 0; i < 3; i++) {
    double speed = walk->curve->dimension == 2
                       ? ph_cplx_norm2(walk->seg2.w[i])
                       : ph_quat_dot(walk->seg3.a[i], walk->seg3.a[i]);
    most = speed > most ? speed : most;
  }
  return most > DBL_MAX / 64;
}

/* Finds the parts of [u0,u1]. */
static enum ph_status visit(struct walk *walk, const struct jet *a, double u0,
                            const struct jet *b, double u1, int depth) {
  struct piece piece = {.walk = walk, .u0 = u0, .u1 = u1};
  double error, middle = 0.5 * (u0 + u1);
  struct jet m;
  enum ph_status status;
  bezier_of(a, b, u1 - u0, piece.p);
  error = error_of(&piece);
  if (error <= walk->tolerance &&
      error > NEARLY * fmin(walk->pieces->error, walk->tolerance)) {
    error = ph_golden_greatest(error_at, &piece, PEAKS, error);
  }
  if (error <= walk->tolerance) {
    return found(walk, u0, u1, error);
  }
  status = depth > 0 ? PH_OK
                     : ph_rounding_allows(walk->rounding, walk->tolerance,
                                          walk->diag);
  if (status != PH_OK) {
    return status;
  }
  if (!isfinite(error) && is_too_fast(walk)) {
    return ph_fail_at(walk->diag, PH_E_TOO_LARGE, "segments", walk->segment,
                      "has no Bezier pieces in the range of a double");
  }
  if (depth == HALVINGS_MAX || walk->pieces->n - walk->before > PIECES_MAX ||
      !isfinite(error)) {
    return ph_fail_at(
        walk->diag, PH_E_NO_CONVERGENCE, "segments", walk->segment,
        "has no Bezier pieces within %.3g of the exact curve", walk->tolerance);
  }
  m = walk->jet_at(walk, middle);
  status = visit(walk, a, u0, &m, middle, depth + 1);
  return status == PH_OK ? visit(walk, &m, middle, b, u1, depth + 1) : status;
}

static void enter(struct walk *walk, size_t k) {
  walk->segment = k;
  walk->before = walk->pieces->n;
  if (walk->curve->dimension == 2) {
    walk->seg2 = ph_seg2_of(walk->curve, k);
    walk->jet_at = planar_jet;
  } else {
    walk->seg3 = ph_seg3_of(walk->curve, k);
    walk->jet_at = spatial_jet;
  }
}

/* Segment k in parts. */
static enum ph_status cut(struct walk *walk, size_t k) {
  struct jet a, b;
  enter(walk, k);
  if (fabs(walk->distance) > 0) {
    find_slow(walk);
  }
  a = walk->jet_at(walk, 0);
  b = walk->jet_at(walk, 1);
  return visit(walk, &a, 0, &b, 1, 0);
}

/* Writes the pieces of all parts. */
static void fill(struct walk *walk, const struct part *part) {
  struct ph_pieces *pieces = walk->pieces;
  size_t dimension = pieces->dimension;
  double *out = pieces->control_points;
  struct jet a, b;
  for (size_t at = 0; part; part = part->next, at++) {
    ph_vec3 p[6];
    if (part->from > 0) {
      a = b;
    } else {
      enter(walk, part->segment);
      a = walk->jet_at(walk, 0);
    }
    b = walk->jet_at(walk, part->to);
    bezier_of(&a, &b, part->to - part->from, p);
    pieces->segment[at] = part->segment;
    pieces->interval[2 * at] = part->from;
    pieces->interval[2 * at + 1] = part->to;
    for (size_t i = 0; i < 6; i++, out += dimension) {
      ph_vec3_put(p[i], dimension, out);
    }
  }
}

enum ph_status ph_hermite_pieces(const struct ph_curve *curve, double distance,
                                 enum ph_normal normal, double tolerance,
                                 struct ph_arena *arena,
                                 struct ph_pieces *pieces,
                                 struct ph_diag *diag) {
  size_t stride = 6 * curve->dimension;
  struct part *parts = NULL;
  struct walk walk = {.curve = curve,
                      .distance = distance,
                      .tolerance = tolerance,
                      .rounding = ph_curve_rounding(curve),
                      .normal = normal,
                      .pieces = pieces,
                      .end = &parts,
                      .arena = arena,
                      .diag = diag};
  *pieces = (struct ph_pieces){.degree = 5, .dimension = curve->dimension};
  if (!ph_quad_gauss(&walk.rule, NODES)) {
    return ph_fail_memory(diag);
  }
  for (size_t k = 0; k < curve->n; k++) {
    enum ph_status status = cut(&walk, k);
    if (status != PH_OK) {
      return status;
    }
  }
  pieces->segment = ph_arena_array(arena, pieces->n, sizeof(size_t));
  pieces->interval = ph_arena_array(arena, pieces->n, 2 * sizeof(double));
  pieces->control_points =
      ph_arena_array(arena, pieces->n, stride * sizeof(double));
  if (!pieces->segment || !pieces->interval || !pieces->control_points) {
    return ph_fail_memory(diag);
  }
  fill(&walk, parts);
  return PH_OK;
}
