/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The method `tc`: from the fields of a problem to a curve of Tschirnhausen
 * cubics.
 *
 * The data are read (tc.h), every interval is solved by itself
 * (tc.h), a block of them by all threads, and put into the curve (tc.h): O(n),
 * and nothing is allocated for an interval.  Curves that are approximated go
 * their own way (tc.h).
 */
#include "solve/method.h"

#include "base/team.h"
#include "curve/offset/blaschke.h"
#include "solve/common/fields.h"
#include "solve/tc/tc.h"

#include <math.h>

static void warn_crossings(const struct ph_tc_crossings *crossings,
                           struct ph_result *result) {
  if (crossings->n > 0) {
    const struct ph_interval *at = &result->intervals[crossings->first];
    ph_warn(result, at->first, PH_W_LOOP,
            "the curve of interval %zu has a loop or crosses itself (such "
            "intervals: %zu)",
            crossings->first, crossings->n);
  }
}

/* Intervals that are looked for together; so many, 1 ms, are worth another
 * thread; how many one takes at a time. */
enum { BLOCK = 4096, WORTH = 1024, CHUNK = 128 };

struct found {
  struct ph_tc_fit fit;
  enum ph_status status;
};

struct block {
  const struct ph_tc_data *data;
  const struct ph_arena *clock;
  size_t first; /* of them */
  struct found *found;
};

static bool find_some(void *context, size_t thread, size_t first, size_t end) {
  const struct block *b = context;
  struct ph_diag why;
  (void)thread;
  for (size_t i = first; i < end; i++) {
    struct found *found = &b->found[i];
    found->status =
        ph_arena_late(b->clock)
            ? PH_E_NO_MEMORY
            : ph_tc_interval(b->data, b->first + i, &found->fit, &why);
    if (found->status != PH_OK) {
      return false; /* the first of all is the one to be told */
    }
  }
  return true;
}

/* Why an interval was not found. */
static enum ph_status tell(const struct ph_tc_data *d, size_t k,
                           struct found *found, struct ph_diag *diag) {
  return found->status == PH_E_NO_MEMORY
             ? ph_fail_memory(diag)
             : ph_tc_interval(d, k, &found->fit, diag);
}

/* The intervals of a block, in their order. */
static enum ph_status add_block(const struct block *b, size_t n,
                                struct ph_tc_builder *builder,
                                struct ph_tc_crossings *crossings,
                                struct ph_diag *diag) {
  for (size_t i = 0; i < n; i++) {
    struct found *found = &b->found[i];
    if (found->status != PH_OK) {
      return tell(b->data, b->first + i, found, diag);
    }
    ph_tc_build_add(builder, &found->fit);
    ph_tc_crossings_see(crossings, b->first + i, &found->fit);
  }
  return PH_OK;
}

/* Each interval by itself. */
static enum ph_status solve_each(const struct ph_tc_data *d,
                                 struct ph_arena *out, struct ph_arena *scratch,
                                 struct ph_result *result,
                                 struct ph_tc_crossings *crossings,
                                 struct ph_diag *diag) {
  const size_t most = d->n < BLOCK ? d->n : BLOCK;
  struct block block = {d, scratch, 0,
                        ph_arena_array(scratch, most, sizeof *block.found)};
  struct ph_tc_builder builder;
  enum ph_status status =
      ph_tc_build_begin(&builder, d, out, &result->curve, diag);
  if (!block.found) {
    return ph_fail_memory(diag);
  }
  for (; status == PH_OK && block.first < d->n; block.first += most) {
    const size_t n = d->n - block.first < most ? d->n - block.first : most;
    ph_team_share(scratch, n, WORTH, CHUNK, find_some, &block);
    status = add_block(&block, n, &builder, crossings, diag);
  }
  if (status == PH_OK) {
    ph_tc_build_end(&builder, &result->diagnostics);
    result->intervals = builder.intervals;
    result->intervals_n = d->n;
  }
  return status;
}

static enum ph_status interpolate(const struct ph_problem *problem,
                                  enum ph_tc_mode mode, struct ph_arena *out,
                                  struct ph_arena *scratch,
                                  struct ph_result *result,
                                  struct ph_diag *diag) {
  struct ph_tc_crossings crossings = {0, 0};
  struct ph_tc_data data;
  enum ph_status status = ph_tc_data_of(problem, mode, scratch, &data, diag);
  if (status == PH_OK && mode == PH_TC_G2) {
    return ph_tc_g2(problem, &data, out, scratch, result, diag);
  }
  if (status == PH_OK) {
    status = data.choice == PH_TC_ALL
                 ? ph_tc_all(&data, out, scratch, result, &crossings, diag)
                 : solve_each(&data, out, scratch, result, &crossings, diag);
  }
  if (status == PH_OK) {
    warn_crossings(&crossings, result);
  }
  return status;
}

/* Images on the Blaschke cylinder, of all regular curves. */
static enum ph_status add_images(struct ph_arena *out, struct ph_result *result,
                                 struct ph_diag *diag) {
  enum ph_status status = ph_blaschke_curve(&result->curve, out, diag);
  for (size_t i = 0; status == PH_OK && i < result->solutions_n; i++) {
    status = ph_blaschke_curve(&result->solutions[i].curve, out, diag);
    status = status == PH_E_INFEASIBLE ? PH_OK : status;
  }
  return status;
}

static enum ph_status solve(const struct ph_problem *problem,
                            struct ph_arena *out, struct ph_arena *scratch,
                            struct ph_result *result, struct ph_diag *diag) {
  struct ph_mark mark = ph_arena_mark(scratch);
  enum ph_tc_mode mode;
  enum ph_status status = ph_tc_mode_of(problem, &mode, diag);
  if (status == PH_OK) {
    status = mode == PH_TC_APPROXIMATE
                 ? ph_tc_target(problem, out, scratch, result, diag)
                 : interpolate(problem, mode, out, scratch, result, diag);
  }
  if (status == PH_OK && problem->field[PH_F_BLASCHKE].flag) {
    status = add_images(out, result, diag);
  }
  ph_arena_release(scratch, mark);
  return status;
}

static const struct ph_field fields[] = {
    {PH_F_POINTS, PH_VECTORS | PH_DATUM, 1u << 2, false, NULL, "none",
     "the points to interpolate, 2 or more, 3 or more if closed"},
    {PH_F_TANGENTS, PH_VECTORS | PH_DATUM, 1u << 2, false, NULL, "none",
     "directions of the curve, one for each point"},
    {PH_F_DERIVATIVES, PH_VECTORS | PH_DATUM, 1u << 2, false, NULL, "none",
     "derivatives, one for each point, by each cubic's own parameter in [0,1]"},
    {PH_F_CURVE, PH_VECTORS | PH_POLYLINE, 1u << 2, false, NULL, "points",
     "the curve to approximate: control points of a Bezier curve, or of "
     "several, one after another"},
    {PH_F_PATH, PH_PATH, 0, false, NULL, "curve",
     "the same as the data of an SVG path: one subpath"},
    {PH_F_CLOSED, PH_BOOL, 0, false, NULL, "false",
     "close the curve, a repeated last point is dropped"},
    PH_FIELD_MERGE,
    PH_FIELD_AT,
    {PH_F_MODE, PH_WORD, 0, false,
     "g1|g1-pair|g1-auto|g1-fair|c1|spline|g2|approximate",
     "approximate, g1-fair, c1, spline or g2, by what is given",
     "cubics in each interval: one, two, one if it has no loop, or what is "
     "fairer; two with derivatives, given or by rule; with continuous "
     "curvature; or an approximation"},
    {PH_F_LAMBDA, PH_NUMBER, 0, false, NULL,
     "0.5 for spline, else the fairest of each interval",
     "length of derivatives over that of the shorter chord beside them"},
    {PH_F_ENDS, PH_WORD, 0, false, "chord|circle|smooth", "chord, of g2 circle",
     "end tangents of an open spline: along the chord, or of a circle; of g2 "
     "of "
     "a circle, or as smooth as beside it"},
    {PH_F_END_TANGENTS, PH_VECTORS, 1u << 2, false, NULL, "by ends",
     "directions at the first and the last point of a spline"},
    {PH_F_END_DERIVATIVES, PH_VECTORS, 1u << 2, false, NULL, "by ends",
     "derivatives at the first and the last point of a spline"},
    {PH_F_AUXILIARY, PH_WORD, 0, false, "auto|never", "auto",
     "whether g2 may add points where the data turn too much"},
    {PH_F_JOINT, PH_WORD, 0, false, "free|chord", "free",
     "where the two cubics of g1-pair meet: anywhere, or on the chord"},
    {PH_F_JOINT_ANGLE, PH_NUMBER, 0, false, NULL, "the fairest",
     "angle from the chord to the curve at a joint on it, to the left"},
    {PH_F_JOINT_POSITION, PH_NUMBER, 0, false, NULL, "the fairest",
     "part of the chord before a joint on it, between 0 and 1"},
    {PH_F_SOLUTIONS, PH_WORD, 0, false, "best|standard|all", "best",
     "the best of several curves, the standard one, or all, the best first"},
    {PH_F_TOLERANCE, PH_NUMBER, 0, false, NULL, "none",
     "greatest distance of an approximation from the curve, of Hausdorff"},
    {PH_F_PIECES, PH_NUMBER, 0, false, NULL, "none",
     "in place of tolerance: greatest number of cubics"},
    {PH_F_BLASCHKE, PH_BOOL, 0, false, NULL, "false",
     "add the image of each segment on the Blaschke cylinder"},
};

static const struct ph_advice advice[] = {
    {"segments", PH_F_MODE, PH_F_MODE, "g1-fair",
     "--mode=g1-fair takes one cubic where that is fairer"},
    {NULL, PH_F_TOLERANCE, PH_FIELD_N, NULL,
     "a larger --tolerance needs fewer cubics"},
};

const struct ph_method ph_method_tc = {
    .schema = {"tc", fields, sizeof fields / sizeof fields[0]},
    .title = "Tschirnhausen cubics: one, two, or a spline of them",
    .dimension = 2,
    .kind = PH_CURVE_TC,
    .solve = solve,
    .advice = advice,
    .advice_n = sizeof advice / sizeof advice[0],
};

/* ---- the curve ----------------------------------------------------------- */

static ph_cplx grown(struct ph_pow2 grow, ph_cplx z) {
  return ph_cplx_of(ph_pow2_apply(grow, z.re), ph_pow2_apply(grow, z.im));
}

static void put(double *v, ph_cplx z) {
  v[0] = z.re;
  v[1] = z.im;
}

void ph_tc_curve_put(struct ph_curve *curve, size_t i, const struct ph_tc *tc,
                     ph_cplx start, ph_cplx end, int exponent) {
  const struct ph_pow2 grow = ph_pow2_of(-exponent);
  const double root = ldexp(1, -exponent / 2);
  const ph_cplx zero = {0, 0};
  double *p = curve->control_points + ph_curve_stride(curve) * i;
  double *w = curve->preimage.v + 4 * i;
  ph_cplx leg[4];
  ph_tc_control_points(tc, zero, zero, leg);
  put(p, start);
  put(p + 2, ph_cplx_add(start, grown(grow, leg[1])));
  put(p + 4, ph_cplx_add(end, grown(grow, leg[2])));
  put(p + 6, end);
  put(w, ph_cplx_scale(root, tc->w[0]));
  put(w + 2, ph_cplx_scale(root, tc->w[1]));
  curve->lengths[i] = ph_pow2_apply(grow, ph_tc_length(tc));
}

enum ph_status ph_tc_build_begin(struct ph_tc_builder *b,
                                 const struct ph_tc_data *data,
                                 struct ph_arena *arena, struct ph_curve *curve,
                                 struct ph_diag *diag) {
  *curve =
      (struct ph_curve){.kind = PH_CURVE_TC,
                        .closed = data->closed,
                        .joined = true,
                        .dimension = 2,
                        .degree = 3,
                        .n = data->mode == PH_TC_G1 ? data->n : 2 * data->n,
                        .preimage.n = 2,
                        .preimage.dimension = 2};
  *b = (struct ph_tc_builder){.data = data, .curve = curve};
  b->intervals = ph_arena_array(arena, data->n, sizeof *b->intervals);
  if (!b->intervals || ph_curve_alloc(curve, arena, diag) != PH_OK) {
    return ph_fail_memory(diag);
  }
  curve->n = 0;
  curve->knots[0] = 0;
  return PH_OK;
}

/* Where the cubics of a fit meet, over the chord; what both together miss the
 * end by is shared by their lengths. */
static ph_cplx joint_of(const struct ph_tc_fit *fit) {
  ph_cplx before = ph_tc_leg(&fit->tc[0]), after = ph_tc_leg(&fit->tc[1]);
  double first = ph_tc_length(&fit->tc[0]), last = ph_tc_length(&fit->tc[1]);
  double share = first / (first + last);
  return ph_cplx_of(before.re - share * (before.re + after.re - 1),
                    before.im - share * (before.im + after.im));
}

void ph_tc_describe(const struct ph_tc_fit *fit, struct ph_interval *interval) {
  interval->root = fit->root;
  interval->ratio = fit->ratio;
  interval->lambda = fit->lambda;
  interval->joint_angle = fit->joint_angle;
  interval->joint_position = fit->joint_position;
}

static void describe(struct ph_tc_builder *b, const struct ph_tc_fit *fit,
                     double length) {
  struct ph_interval *interval = &b->intervals[b->done];
  *interval = PH_INTERVAL_NONE;
  interval->length = length;
  interval->first = b->curve->n - fit->n;
  interval->last = b->curve->n - 1;
  ph_tc_describe(fit, interval);
}

void ph_tc_build_add(struct ph_tc_builder *b, const struct ph_tc_fit *fit) {
  const struct ph_tc_data *d = b->data;
  struct ph_curve *curve = b->curve;
  ph_cplx chord = ph_tc_chord(d, b->done), root = ph_tc_root(d, b->done);
  ph_cplx from = ph_tc_point(d, b->done), end = ph_tc_point(d, b->done + 1);
  ph_cplx missed = {-1, 0};
  struct ph_sum sum = {0, 0};
  double over_chord = 0;
  for (size_t i = 0; i < fit->n; i++) {
    struct ph_tc tc = {{ph_cplx_mul(root, fit->tc[i].w[0]),
                        ph_cplx_mul(root, fit->tc[i].w[1])}};
    ph_cplx to =
        i + 1 == fit->n
            ? end
            : ph_cplx_add(from, grown(ph_pow2_of(-d->exponent),
                                      ph_cplx_mul(chord, joint_of(fit))));
    ph_tc_curve_put(curve, curve->n, &tc, from, to, d->exponent);
    missed = ph_cplx_add(missed, ph_tc_leg(&fit->tc[i]));
    over_chord += ph_tc_length(&fit->tc[i]);
    ph_sum_add(&sum, curve->lengths[curve->n]);
    ph_sum_add(&b->length, curve->lengths[curve->n]);
    curve->n++;
    curve->knots[curve->n] = (double)curve->n;
    from = to;
  }
  b->residual = fmax(b->residual, ph_cplx_abs(missed) / over_chord);
  if (b->intervals) {
    describe(b, fit, ph_sum_value(&sum));
  }
  b->done++;
}

void ph_tc_build_end(const struct ph_tc_builder *b,
                     struct ph_diagnostics *diagnostics) {
  b->curve->length = ph_sum_value(&b->length);
  ph_diagnostics_set(diagnostics, PH_D_ITERATIONS, 0);
  ph_diagnostics_set(diagnostics, PH_D_RESIDUAL, b->residual);
  if (b->data->n == 1) {
    const struct ph_interval *only = &b->intervals[0];
    ph_diagnostics_set(diagnostics, PH_D_ROOT, only->root);
    ph_diagnostics_set_finite(diagnostics, PH_D_RATIO, only->ratio);
    ph_diagnostics_set_finite(diagnostics, PH_D_LAMBDA, only->lambda);
  }
  ph_diagnostics_set_finite(diagnostics, PH_D_LAMBDA, b->data->lambda);
}
