/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Verification of a result: what is looked at, in which order (see verify.h).
 */
#include "check/verify.h"

#include "check/bubble.h"
#include "check/checks.h"
#include "check/cone.h"
#include "check/data.h"
#include "check/share.h"

#include <string.h>

/* Beside --tolerance: of points, of segments that meet, and of a given vector
 * and its products. */
static const struct ph_tolerance ROUNDING = {
    .point = 8, .gap = 4, .given = 8 * DBL_EPSILON};

/* Segments of a part of a long curve, which take 0.5 ms; parts that are looked
 * at together. */
enum { PART = 1024, BLOCK = 256 };

/* Numbers that were written with fewer digits may be the same to this. */
static const double SAME = 1e-12;

/* ---- a curve ------------------------------------------------------------ */

static bool begin_curve(struct ph_check *v) {
  const struct ph_curve *c = v->curve;
  double mean;
  if (!ph_check_scale_of(c->control_points, ph_curve_points_n(c), c->dimension,
                         &v->scale)) {
    ph_check_wrong(v, PH_CHECK_SHAPE,
                   ph_check_of("segments", PH_CHECK_ONE, NULL),
                   "have no extent");
    return false;
  }
  if (v->kind->sphere) { /* points may be nearer to 0 than to the center */
    ph_check_scale_round(&v->scale, 0.5 + ph_check_scaled(v, c->sphere.radius));
  }
  mean = ph_check_scaled(v, c->length) / (double)c->n;
  /* a false claim would make all errors small */
  v->mean = mean < 4 * v->scale.size ? mean : 0;
  return true;
}

enum ph_status ph_check_begin(struct ph_check *v, struct ph_check_data *data,
                              struct ph_check_space *space) {
  const struct ph_curve *c = v->curve;
  /* points next to a hairpin have fewer digits by fewer nodes */
  size_t nodes =
      v->error && !c->preimage.alpha ? PH_CHECK_NODES_PH : PH_CHECK_NODES_ATPH;
  size_t n = c->n;
  v->knot = PH_CHECK_ROUND_KNOT * DBL_EPSILON *
            ph_check_larger(fabs(c->knots[0]), fabs(c->knots[n]));
  if (!v->error || v->promise->lengths) {
    v->length = ph_arena_array(v->scratch, n, sizeof *v->length);
    v->noise = ph_arena_array(v->scratch, n, sizeof *v->noise);
    v->rooted = ph_arena_array(v->scratch, n, sizeof *v->rooted);
    if (!v->length || !v->noise || !v->rooted) {
      return ph_fail_memory(v->diag);
    }
    memset(v->noise, 0, n * sizeof *v->noise);
    memset(v->rooted, 0, n * sizeof *v->rooted);
  }
  if (!ph_quad_gauss(&v->fixed, nodes)) {
    return ph_fail_memory(v->diag);
  }
  *space = ph_check_space_of(&v->fixed, c->degree - 1, 0);
  v->space = space;
  return ph_check_given_begin(v, data);
}

/* Segments first to end - 1, of which the outermost are left in ends[2]; false:
 * it is too late. */
static bool check_range(struct ph_check *v, size_t first, size_t end,
                        struct ph_check_segment *ends) {
  struct ph_check_segment s[2];
  for (size_t k = first; k < end; k++) {
    struct ph_check_segment *now = &s[k & 1];
    if (k > first && ph_arena_late(v->scratch)) {
      return false;
    }
    ph_check_load(v, k, now);
    ph_check_square(v, now);
    if (v->data) {
      ph_check_given(v, now);
    }
    if (v->error && v->promise->segment) {
      v->promise->segment(v, now);
    }
    if (k > first) {
      ph_check_joint(v, &s[~k & 1], now);
    } else {
      ends[0] = *now;
    }
    if (k + 1 == end) {
      ends[1] = *now;
    }
  }
  return true;
}

/* Parts of a long curve from segment `from' on, and the segments at their ends.
 */
struct ends {
  size_t from;
  struct ph_check_segment (*part)[2];
};

static void check_part(const void *context, struct ph_check *v, size_t first,
                       size_t end) {
  const struct ends *ends = context;
  struct ph_check_space space = *v->space;
  struct ph_check_data data = *v->data;
  struct ph_check part = *v;
  part.space = &space;
  part.data = &data;
  data.i = ph_check_interval(&data, ends->from + first);
  check_range(&part, ends->from + first, ends->from + end,
              ends->part[first / PART]);
  part.space = v->space;
  part.data = v->data;
  *v = part;
}

/* Certifies a long curve in parts; what comes out does not depend on who does
 * which.  False: it is to be gone through in one. */
static bool check_parts(struct ph_check *v) {
  const size_t n = v->curve->n, most = (n + PART - 1) / PART;
  struct ph_check_segment first, before;
  struct ends ends = {0, NULL};
  if (n < 2 * PART || !v->error || !v->data ||
      ph_check_field(v, PH_F_TANGENT_SIGMA)) {
    return false;
  }
  ends.part = ph_arena_array(v->scratch, most < BLOCK ? most : BLOCK,
                             sizeof *ends.part);
  if (!ends.part) {
    return false;
  }
  for (; ends.from < n && !ph_arena_late(v->scratch);
       ends.from += (size_t)BLOCK * PART) {
    const size_t rest = n - ends.from;
    const size_t size =
        rest < (size_t)BLOCK * PART ? rest : (size_t)BLOCK * PART;
    ph_check_share(v, size, PART, check_part, &ends);
    for (size_t i = 0; i * PART < size && !ph_arena_late(v->scratch); i++) {
      if (ends.from + i > 0) {
        ph_check_joint(v, &before, &ends.part[i][0]);
      } else {
        first = ends.part[i][0];
      }
      before = ends.part[i][1];
    }
  }
  if (v->curve->closed && !ph_arena_late(v->scratch)) {
    ph_check_joint(v, &before, &first);
  }
  return true;
}

void ph_check_segments(struct ph_check *v) {
  const struct ph_curve *c = v->curve;
  struct ph_check_segment ends[2];
  v->found = (struct ph_sum){0, 0};
  v->doubt = 0;
  if (!check_parts(v) && check_range(v, 0, c->n, ends) && c->closed) {
    ph_check_joint(v, &ends[1], &ends[0]);
  }
}

/* What its kind asks for. */
static void check_whole(struct ph_check *v) {
  if (v->kind->whole) {
    v->kind->whole(v);
  }
}

/* What was made of it, if it is the curve of the record. */
static void check_derived(struct ph_check *v) {
  const struct ph_result *claim = v->claim;
  double length, error;
  if (v->curve != &claim->curve) {
    return;
  }
  if (claim->samples.n > 0) {
    ph_check_samples(v, &claim->samples, NULL, &length, &error);
  }
  if (claim->nurbs.n > 0 && !v->kind->converted) {
    ph_check_nurbs(v, &claim->nurbs, NULL);
  }
  if (claim->offset_range && !v->kind->converted) {
    ph_check_range(v);
  }
  for (size_t i = 0; i < claim->offsets_n; i++) {
    ph_check_prefix(v, "offsets", i);
    ph_check_offset(v, &claim->offsets[i]);
  }
  ph_check_prefix(v, NULL, 0);
}

/* A curve, alone or one of several solutions. */
static enum ph_status check_curve(struct ph_check *v) {
  static void (*const parts[])(struct ph_check *) = {
      ph_check_segments, ph_check_lengths, ph_check_fairness,     check_whole,
      ph_check_blaschke, check_derived,    ph_check_given_lengths};
  struct ph_check_space space;
  struct ph_check_data data;
  enum ph_status status;
  v->kind = &ph_check_kinds[v->curve->kind];
  if (v->promise->parts == PH_PATCHES_PARTS) {
    return ph_check_patchwork(v);
  }
  if (v->promise->parts == PH_STRIPS_PARTS) {
    return ph_check_surface(v);
  }
  if (!ph_check_arrays(v) || !begin_curve(v)) {
    return PH_OK;
  }
  status = ph_check_begin(v, &data, &space);
  if (status != PH_OK) {
    return status;
  }
  for (size_t i = 0; i < sizeof parts / sizeof parts[0]; i++) {
    parts[i](v);
    if (ph_arena_late(v->scratch)) {
      return ph_fail_memory(v->diag);
    }
  }
  return v->problem && ph_check_is_approximation(v) ? ph_check_approximation(v)
                                                    : PH_OK;
}

/* Whether two curves have the same control points, but for rounding of them to
 * text. */
static bool is_same(const struct ph_curve *a, const struct ph_curve *b) {
  const size_t n = ph_curve_points_n(a) * a->dimension;
  bool same = a->kind == b->kind && a->n == b->n && a->degree == b->degree &&
              a->joined == b->joined && a->dimension == b->dimension &&
              a->control_points && b->control_points;
  for (size_t i = 0; same && i < n; i++) {
    double x = a->control_points[i], y = b->control_points[i];
    same = fabs(x - y) <= SAME * fabs(x);
  }
  return same;
}

static enum ph_status check_solutions(struct ph_check *v) {
  const struct ph_result *claim = v->claim;
  enum ph_status status = PH_OK;
  if (claim->solutions_n > 0 &&
      !is_same(&claim->solutions[0].curve, &claim->curve)) {
    ph_check_wrong(v, PH_CHECK_SHAPE, ph_check_of("solutions", 0, NULL),
                   "is not the curve of the record");
  }
  for (size_t i = 0; i < claim->solutions_n && status == PH_OK; i++) {
    const struct ph_solution *solution = &claim->solutions[i];
    struct ph_mark mark = ph_arena_mark(v->scratch);
    ph_check_prefix(v, "solutions", i);
    v->curve = &solution->curve;
    v->diagnostics = &solution->diagnostics;
    v->intervals = solution->intervals;
    v->intervals_n = solution->intervals ? claim->intervals_n : 0;
    status = check_curve(v);
    ph_arena_release(v->scratch, mark);
  }
  return status;
}

static void conclude(struct ph_verdict *verdict) {
  verdict->worst = PH_CHECK_N;
  for (int i = 0; i < PH_CHECK_N; i++) {
    const struct ph_check_finding *e = &verdict->check[i];
    if (e->done && (verdict->worst == PH_CHECK_N ||
                    e->error > verdict->check[verdict->worst].error)) {
      verdict->worst = (enum ph_check_id)i;
    }
  }
}

enum ph_status
ph_check_result(const struct ph_result *claim, const struct ph_problem *problem,
                const struct ph_promise *promise, struct ph_arena *scratch,
                struct ph_verdict *verdict, struct ph_diag *diag) {
  struct ph_check v = {.verdict = verdict,
                       .scratch = scratch,
                       .diag = diag,
                       .promise = promise,
                       .allow = &ROUNDING,
                       .problem = problem,
                       .claim = claim,
                       .curve = &claim->curve,
                       .diagnostics = &claim->diagnostics,
                       .intervals = claim->intervals,
                       .intervals_n = claim->intervals_n};
  struct ph_mark mark = ph_arena_mark(scratch);
  enum ph_status status;
  *verdict = (struct ph_verdict){.worst = PH_CHECK_N};
  if (!ph_check_rule_of(&v.rule, scratch)) {
    return ph_fail_memory(diag);
  }
  status = check_curve(&v);
  if (status == PH_OK) {
    status = check_solutions(&v);
  }
  ph_arena_release(scratch, mark);
  conclude(verdict);
  return status;
}
