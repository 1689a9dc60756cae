/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Internal declarations of the method `tc`. */
#ifndef PH_SOLVE_TC_TC_H
#define PH_SOLVE_TC_TC_H

#include "base/diag.h"
#include "base/mem.h"
#include "base/sum.h"
#include "curve/problem.h"
#include "curve/result.h"
#include "curve/segment/tc.h"
#include "kernel/pow2.h"

#include <stddef.h>

/* ---- fits ---------------------------------------------------------------- */

/*
 * What solvers of Tschirnhausen cubics have in common: Hermite data of one
 * interval, and a curve of one or two cubics that fits them.
 *
 * All is relative to the chord: the interval goes from 0 to 1 along the real
 * axis; vectors are divided by the chord (as complex numbers), preimages by its
 * square root, lengths by its length, energies multiplied by it.
 */

/* Vectors at both ends over the chord: unit tangents, or derivatives of each
 * cubic by its own parameter in [0,1].  ph_tc_hermite_of snaps them. */
struct ph_tc_hermite {
  ph_cplx t[2];
};

/* PH_TC_COLLINEAR: a vector within this angle of the chord, forward or
 * backward, is along it. */
#define PH_TC_COLLINEAR 1e-14

/* ph_tc_snap: a vector that is along the chord without what it is off it. */
static inline ph_cplx ph_tc_snap(ph_cplx t) {
  return fabs(t.im) <= PH_TC_COLLINEAR * fabs(t.re) ? ph_cplx_of(t.re, 0) : t;
}

/* ph_tc_is_along, _forward, _backward: of a snapped vector, to the chord. */
static inline bool ph_tc_is_along(ph_cplx t) {
  return !(fabs(t.im) > 0);
}

static inline bool ph_tc_is_forward(ph_cplx t) {
  return t.re > 0 && ph_tc_is_along(t);
}

static inline bool ph_tc_is_backward(ph_cplx t) {
  return t.re < 0 && ph_tc_is_along(t);
}

/* ph_tc_hermite_scaled: the same data with vectors as long by a factor. */
static inline struct ph_tc_hermite
ph_tc_hermite_scaled(const struct ph_tc_hermite *h, double factor) {
  struct ph_tc_hermite scaled = {
      {ph_cplx_scale(factor, h->t[0]), ph_cplx_scale(factor, h->t[1])}};
  return scaled;
}

/* A curve of one or two cubics that fits Hermite data. */
struct ph_tc_fit {
  struct ph_tc tc[2];
  size_t n; /* cubics */
  enum ph_root root;
  double ratio;          /* of one cubic: D; else NaN */
  double lambda;         /* of a pair with |t[0]| = |t[1]| = lambda; else NaN */
  double joint_angle;    /* of two with their joint on the chord; else NaN */
  double joint_position; /* likewise */
  bool regular;          /* every cubic is */
  unsigned loops;        /* cubics that have one */
  bool simple;           /* known to be; see ph_tc_fit_measure */
  double length;
  double energy; /* not finite unless regular */
};

/* ph_tc_fit_of: n cubics that are still to be set and measured. */
static inline struct ph_tc_fit ph_tc_fit_of(size_t n, enum ph_root root) {
  const double none = (double)NAN;
  struct ph_tc_fit fit = {.n = n,
                          .root = root,
                          .ratio = none,
                          .lambda = none,
                          .joint_angle = none,
                          .joint_position = none,
                          .length = none,
                          .energy = none};
  return fit;
}

/*
 * ph_tc_fit_measure: regular, loops, length and energy from tc[n]; simple is
 * set to false.
 */
void ph_tc_fit_measure(struct ph_tc_fit *fit);

/* ph_tc_fit_test: sets simple by curve/cross/tc_simple.h; returns it. */
bool ph_tc_fit_test(struct ph_tc_fit *fit);

/*
 * ph_tc_fit_order: tests all fits and sorts them, best first: simple ones by
 * energy (of those that agree to 1e-9 the shorter, then the one that came
 * first), then other regular ones likewise, then irregular ones in their order.
 */
void ph_tc_fit_order(struct ph_tc_fit *fits, size_t n);

/*
 * ph_tc_fit_best: the one that ph_tc_fit_order would put first, measured and
 * tested; tests as few as it can.  fits[n] must have been measured.
 *
 * ret  NULL if none is regular
 */
struct ph_tc_fit *ph_tc_fit_best(struct ph_tc_fit *fits, size_t n);

/* ---- one cubic ----------------------------------------------------------- */

/*
 * G1 Hermite interpolation by one Tschirnhausen cubic [BYR11, ch. 4].
 *
 * With a = arg t0 and b = arg t1, phi = (a + b)/2 and delta = (b - a)/2, every
 * real root D != 0 of
 *
 *   D^2 sin b + D sin phi + sin a = 0                            [BYR11, (4.5)]
 *   with  G(D) = cos a + D cos phi + D^2 cos b > 0
 *
 * gives one: w0 = sqrt(3/G) e^(ia/2), w1 = D sqrt(3/G) e^(ib/2) for the
 * chord 1. |D| is the square root of the ratio of the outer legs; D has a sign.
 * The angle of a backward tangent is taken as pi or -pi such that D > 0, as in
 * the mirror image.
 */

/*
 * ph_tc_g1: all cubics with these unit tangents, best first: regular ones,
 * without a loop before those with one, then the one that bends less.  Roots
 * and G that are 0 to rounding are 0: a double root is one cubic, a closed one
 * is none.
 *
 * Both tangents along the chord and forward give the straight line (root
 * PH_ROOT_STRAIGHT, D = 1); along the chord otherwise there is none.
 *
 * in   h     unit tangents over the direction of the chord, snapped
 * out  fits  measured, but not tested: one cubic is simple if it is regular and
 *            has no loop, and simple says so
 * ret  how many: 0, 1 or 2
 */
size_t ph_tc_g1(const struct ph_tc_hermite *h, struct ph_tc_fit fits[2]);

/*
 * ph_tc_g1_range: the open interval of angles at one end for which there is a
 * cubic, given the angle at the other; it holds 0, and is less than a turn
 * long, but an end of it may be beyond pi or -pi.  The angle 0 itself is not
 * among them if |a| >= 2 pi/3, or else a cubic with a loop; for a = 0 it is the
 * straight line.
 *
 * in   a         in [-pi, pi]
 * out  range[2]  in (-2 pi, 2 pi)
 */
void ph_tc_g1_range(double a, double range[2]);

/* ---- pairs --------------------------------------------------------------- */

/*
 * C1 Hermite interpolation by a pair of Tschirnhausen cubics [BYR11, thm 17],
 * each on its own [0,1], with the same preimage z at the joint.
 *
 *   w0 = sqrt(t0), w2 = +-sqrt(t1)                           principal roots
 *   2 z^2 + (w0 + w2) z + w0^2 + w2^2 - 3 = 0
 *   z = (-(w0 + w2) +- rho)/4,  rho = sqrt((w0 + w2)^2 - 8 (w0^2 + w2^2 - 3))
 *
 * gives four pairs; the standard one has both signs +.  The larger root is
 * taken by this formula, the other by their product.
 */

enum { PH_TC_PAIRS = 4 };

/* ph_tc_pairs: the four, in the order ++, +-, -+, --; not measured.
 *
 * in   h  derivatives over the chord, not 0, snapped */
void ph_tc_pairs(const struct ph_tc_hermite *h,
                 struct ph_tc_fit fits[PH_TC_PAIRS]);

/* Derivatives over the chord: standard pairs are simple to 1.46, and have no
 * sharp bend at an end from .03. */
#define PH_TC_PAIR_SHORTEST 0.03
#define PH_TC_PAIR_LONGEST 1.4

/* ph_tc_pair_is_safe: whether the standard pair is known to be the best by
 * sight of the data: both within a right angle of the chord, and of a length
 * between those. */
bool ph_tc_pair_is_safe(const struct ph_tc_hermite *h);

/*
 * ph_tc_pair_standard: the standard pair, not measured.  Where a derivative is
 * exactly backward it is not defined (its mirror image has the same right to
 * the name).
 *
 * ret  false there; fit is then not set
 */
bool ph_tc_pair_standard(const struct ph_tc_hermite *h, struct ph_tc_fit *fit);

/*
 * ph_tc_pair_best: of the four the best by ph_tc_fit_best, measured; safe data
 * are not tested.  Of data that are their own mirror image from the other end
 * two pairs may be equally good.
 *
 * ret  false if all four are irregular
 */
bool ph_tc_pair_best(const struct ph_tc_hermite *h, struct ph_tc_fit *fit);

/* ---- two cubics for tangents --------------------------------------------- */

/* G1 Hermite interpolation by two Tschirnhausen cubics, for all data. */

/*
 * ph_tc_two_free: the C1 pair (tc.h) with |t0| = |t1| = lambda whose F =
 * energy * length is least over its four roots and lambda in [.15, 1.4], among
 * those that are simple.  Both tangents along the chord and forward give the
 * straight line with lambda = 1/2.
 *
 * in   h    unit tangents over the direction of the chord, snapped
 * out  fit  measured and tested
 * ret  false if no pair is simple
 */
bool ph_tc_two_free(const struct ph_tc_hermite *h, struct ph_tc_fit *fit);

/*
 * ph_tc_two_chord: two cubics whose joint is on the chord [BYR11, thm 14], with
 * the tangent there at an angle to it, each the best of ph_tc_g1.  What is NaN
 * is chosen: the angle for the best rank (simple, then with the fewest loops)
 * and of these the least F, the position for the least energy.  Both tangents
 * along the chord and forward give the straight line where no angle is given.
 *
 * in   angle     in (-pi, pi), not 0; or NaN
 * in   position  of the joint, in (0, 1); or NaN
 * out  fit       measured and tested; joint_angle and joint_position
 * ret  false if there is none at this angle: it must be in the ranges of
 *      ph_tc_g1_range of both angles
 */
bool ph_tc_two_chord(const struct ph_tc_hermite *h, double angle,
                     double position, struct ph_tc_fit *fit);

/* ---- data ---------------------------------------------------------------- */

/*
 * The data of interpolation by Tschirnhausen cubics: what the fields of a
 * problem say, checked, with what is absent filled in by its rule, at unit
 * scale (a power of two).
 */

enum ph_tc_mode {
  PH_TC_G1,
  PH_TC_G1_PAIR,
  PH_TC_G1_AUTO,
  PH_TC_G1_FAIR,
  PH_TC_C1,
  PH_TC_SPLINE,
  PH_TC_G2,
  PH_TC_APPROXIMATE
};

enum ph_tc_choice { PH_TC_BEST, PH_TC_STANDARD, PH_TC_ALL };

struct ph_tc_data {
  enum ph_tc_mode mode;
  enum ph_tc_choice choice;
  size_t n;             /* intervals */
  size_t points_n;      /* n if closed, else n + 1 */
  const double *points; /* [points_n][2], the user's */
  bool closed;
  bool c1;               /* vectors are derivatives, else unit tangents */
  bool on_chord;         /* joints are */
  double joint_angle;    /* NaN: to be chosen */
  double joint_position; /* NaN: to be chosen */
  double lambda;         /* NaN: to be chosen, or derivatives are given */
  int exponent;          /* unit scale = data times 2^exponent; even */
  struct ph_pow2 to_unit;
  ph_cplx *vector; /* [points_n]; of the mode g2 unit tangents at the ends
                      alone, NaN where they are not given */
  double *chord;   /* [n] lengths at unit scale */
};

/* PH_TC_LAMBDA: what the field lambda is where it is absent and needed. */
#define PH_TC_LAMBDA 0.5

/* ph_tc_mode_of: the mode that a problem says or implies; what fields it must
 * not have together.
 *
 * ret  PH_OK | PH_E_BAD_VALUE | PH_E_MISSING_FIELD */
enum ph_status ph_tc_mode_of(const struct ph_problem *problem,
                             enum ph_tc_mode *mode, struct ph_diag *diag);

/*
 * ph_tc_data_of: reads and checks a problem of a mode that interpolates.
 *
 * ret  PH_OK | PH_E_MISSING_FIELD | PH_E_TOO_FEW_POINTS |
 *      PH_E_COINCIDENT_POINTS | PH_E_BAD_SHAPE | PH_E_BAD_VALUE |
 *      PH_E_ZERO_TANGENT | PH_E_TOO_LARGE | PH_E_INFEASIBLE (points that turn
 *      back have no bisector) | PH_E_NO_MEMORY
 */
enum ph_status ph_tc_data_of(const struct ph_problem *problem,
                             enum ph_tc_mode mode, struct ph_arena *arena,
                             struct ph_tc_data *data, struct ph_diag *diag);

/* ph_tc_point: point k, 0 <= k <= n, of the user. */
static inline ph_cplx ph_tc_point(const struct ph_tc_data *d, size_t k) {
  size_t i = k < d->points_n ? k : 0;
  return ph_cplx_of(d->points[2 * i], d->points[2 * i + 1]);
}

/* ph_tc_chord: from point k to point k + 1, at unit scale. */
ph_cplx ph_tc_chord(const struct ph_tc_data *d, size_t k);

/* ph_tc_root: the principal square root of that chord. */
ph_cplx ph_tc_root(const struct ph_tc_data *d, size_t k);

/* ph_tc_hermite_of: the vectors of interval k over its chord, snapped. */
struct ph_tc_hermite ph_tc_hermite_of(const struct ph_tc_data *d, size_t k);

/* ---- intervals ----------------------------------------------------------- */

/* The curves of one or two Tschirnhausen cubics that an interval of the data
 * may have, by the mode of the problem. */

enum { PH_TC_FITS_MAX = PH_TC_PAIRS };

/*
 * ph_tc_interval: the best, or the standard one, for interval k.
 *
 * out  fit   complete but for what need not be known: simple is true only where
 *            the curve is known to be, by a test or by sight of the data
 * ret  PH_OK | PH_E_INFEASIBLE (says why)
 */
enum ph_status ph_tc_interval(const struct ph_tc_data *data, size_t k,
                              struct ph_tc_fit *fit, struct ph_diag *diag);

/* ph_tc_interval_all: all of them, best first, measured and tested.
 *
 * out  n  how many, at least 1 if PH_OK
 */
enum ph_status ph_tc_interval_all(const struct ph_tc_data *data, size_t k,
                                  struct ph_tc_fit fits[PH_TC_FITS_MAX],
                                  size_t *n, struct ph_diag *diag);

/* Intervals whose curve is not known to be simple. */
struct ph_tc_crossings {
  size_t n, first;
};

/* ph_tc_crossings_see: interval k has this curve; in the order of k. */
static inline void ph_tc_crossings_see(struct ph_tc_crossings *crossings,
                                       size_t k, const struct ph_tc_fit *fit) {
  if (!fit->simple && crossings->n++ == 0) {
    crossings->first = k;
  }
}

/* ---- the curve ----------------------------------------------------------- */

/* From fits of intervals (tc.h) to a curve of Tschirnhausen cubics. */

/* A curve that grows by intervals. */
struct ph_tc_builder {
  const struct ph_tc_data *data;
  struct ph_curve *curve;
  struct ph_interval *intervals; /* [data->n]; NULL: they are not wanted */
  size_t done;                   /* intervals */
  struct ph_sum length;
  double residual; /* the largest misfit of an end / length of the interval */
};

/*
 * ph_tc_build_begin: the arrays of a curve, empty yet.
 *
 * ret  PH_OK | PH_E_NO_MEMORY
 */
enum ph_status ph_tc_build_begin(struct ph_tc_builder *builder,
                                 const struct ph_tc_data *data,
                                 struct ph_arena *arena, struct ph_curve *curve,
                                 struct ph_diag *diag);

/* ph_tc_build_add: the next interval. */
void ph_tc_build_add(struct ph_tc_builder *builder,
                     const struct ph_tc_fit *fit);

/* ph_tc_describe: of an interval, what its fit says: all but its length and its
 * segments. */
void ph_tc_describe(const struct ph_tc_fit *fit, struct ph_interval *interval);

/* ph_tc_build_end: the length, and the diagnostics of the solver. */
void ph_tc_build_end(const struct ph_tc_builder *builder,
                     struct ph_diagnostics *diagnostics);

/* ph_tc_curve_put: cubic i of a curve.
 *
 * in   start, end  the user's
 * in   tc          at unit scale
 * in   exponent    unit scale = data times 2^exponent; even
 */
void ph_tc_curve_put(struct ph_curve *curve, size_t i, const struct ph_tc *tc,
                     ph_cplx start, ph_cplx end, int exponent);

/*
 * ph_tc_g2: the curve whose curvature is continuous (g2.h), with its intervals
 * and warnings.
 *
 * in   data  of the mode g2
 * ret  PH_OK | PH_E_INFEASIBLE | PH_E_NO_CONVERGENCE | PH_E_NO_MEMORY
 */
enum ph_status ph_tc_g2(const struct ph_problem *problem,
                        const struct ph_tc_data *data, struct ph_arena *out,
                        struct ph_arena *scratch, struct ph_result *result,
                        struct ph_diag *diag);

/* ---- every curve --------------------------------------------------------- */

/* Every curve of Tschirnhausen cubics through the data, best first. */

/* PH_TC_ALL_MAX, PH_TC_ALL_INTERVALS: at most so many curves, with so many
 * intervals in all. */
enum { PH_TC_ALL_MAX = 4096, PH_TC_ALL_INTERVALS = 65536 };

/*
 * ph_tc_all: the product of what the intervals may have (tc.h), simple
 * curves first, then regular ones, each by energy.
 *
 * out  result     solutions, of which the first is the curve
 * out  crossings  of the intervals of that one
 * ret  PH_OK | PH_E_INFEASIBLE | PH_E_BAD_VALUE (too many) | PH_E_NO_MEMORY
 */
enum ph_status ph_tc_all(const struct ph_tc_data *data, struct ph_arena *out,
                         struct ph_arena *scratch, struct ph_result *result,
                         struct ph_tc_crossings *crossings,
                         struct ph_diag *diag);

/* ---- approximation ------------------------------------------------------- */

/* The mode `approximate`: a chain of Bezier curves to Tschirnhausen cubics. */

/*
 * ph_tc_target: reads the field curve (or points, the control points of one
 * Bezier curve), approximates it within `tolerance` or with `pieces` cubics,
 * and fills result: the curve, an interval for each Bezier curve, and the
 * distance. A knot is the parameter of the chain, k + t on its curve k.
 *
 * ret  PH_OK | PH_E_MISSING_FIELD | PH_E_BAD_VALUE | PH_E_BAD_SHAPE |
 *      PH_E_TOO_FEW_POINTS | PH_E_COINCIDENT_POINTS | PH_E_NO_CONVERGENCE |
 *      PH_E_TOO_LARGE | PH_E_NO_MEMORY
 */
enum ph_status ph_tc_target(const struct ph_problem *problem,
                            struct ph_arena *out, struct ph_arena *scratch,
                            struct ph_result *result, struct ph_diag *diag);

#endif
