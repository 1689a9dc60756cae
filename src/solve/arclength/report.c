/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Curves of arclength (see arclength.h). */
#include "solve/arclength/arclength.h"

#include "base/sum.h"
#include "curve/segment/seg3.h"
#include "solve/arclength/system.h"
#include "solve/common/frame.h"

#include <math.h>
#include <string.h>

/* z of a curve in the plane, relative to the mean speed. */
static const double FLAT = 1e-10;

/* Node j, also once or twice around a closed curve, as a quaternion. */
static ph_quat node(const struct ph_arc_system *s, const double *x, size_t j) {
  size_t around = j / s->nodes;
  const double *w = x + (j % s->nodes) * s->dim;
  double v[4] = {w[0], 0, 0, 0};
  if (s->dim == 4) {
    double chi = s->turn ? (double)around * x[s->x_n - 1] : 0;
    ph_arc_phase(cos(chi), sin(chi), w, v);
  } else {
    for (size_t k = 0; k < s->dim; k++) {
      v[2 * k] = around % 2 == 0 ? w[k] : s->sign * w[k];
    }
  }
  return ph_quat_of(v[0], v[1], v[3], v[2]);
}

/* The preimage of the user's segment q, but for the phase. */
static void preimage(const struct ph_arc_system *s, const double *x, size_t q,
                     ph_quat a[3]) {
  const struct ph_arc_data *d = s->data;
  /* counted on around a closed curve, so that the phase goes on */
  size_t at = q + (s->segments - d->first * s->refine) % s->segments;
  size_t along = d->first > 0 ? 2 * s->segments - 1 : s->segments - 1;
  size_t node0 = d->reversed ? along - at : at, ours = node0 % s->segments;
  double c[3][3];
  double root = d->root * sqrt(d->h[ours / s->refine] / (double)s->refine);
  ph_arc_coefficients(s, ours, c);
  for (size_t k = 0; k < 3; k++) {
    size_t from = d->reversed ? 2 - k : k;
    ph_quat sum = {0, 0, 0, 0};
    for (size_t l = 0; l < 3; l++) {
      sum = ph_quat_add(
          sum, ph_quat_scale(root * c[from][l], node(s, x, node0 + l)));
    }
    if (d->mirrored) { /* (a, b) to (conj a, conj b): z to -z */
      sum = ph_quat_of(sum.u, -sum.v, -sum.p, sum.q);
    }
    if (d->reversed) { /* (a, b) to (-conj b, conj a): H to -H */
      sum = ph_quat_of(-sum.q, sum.p, -sum.v, sum.u);
    }
    a[k] = ph_quat_mul(d->turn, sum);
  }
}

/* The integral of r' over a segment. */
static ph_vec3 displacement(const ph_quat a[3]) {
  ph_vec3 v = ph_vec3_scale(
      1. / 5, ph_vec3_add(ph_quat_i(a[0], a[0]), ph_quat_i(a[2], a[2])));
  v = ph_vec3_along(v, 1. / 5,
                    ph_vec3_add(ph_quat_i(a[0], a[1]), ph_quat_i(a[1], a[2])));
  v = ph_vec3_along(v, 2. / 15, ph_quat_i(a[1], a[1]));
  return ph_vec3_along(v, 1. / 15, ph_quat_i(a[0], a[2]));
}

/* Where segment q ends: in a datum, if it ends an interval of points. */
static ph_vec3 end_of(const struct ph_arc_system *s, size_t q, ph_vec3 start,
                      const ph_quat a[3]) {
  const struct ph_arc_data *d = s->data;
  size_t to = (q + 1) / s->refine;
  if (d->mode == PH_ARC_POINTS && (q + 1) % s->refine == 0) {
    to = d->closed && to == d->n ? 0 : to;
    return ph_vec3_get(d->points + to * d->dimension, d->dimension);
  }
  return ph_vec3_add(start, displacement(a));
}

static void put_segment(size_t q, const ph_quat a[3], const ph_vec3 p[6],
                        struct ph_curve *curve) {
  for (size_t k = 0; k < 6; k++) {
    ph_vec3_put(p[k], 3, curve->control_points + (6 * q + k) * 3);
  }
  for (size_t k = 0; k < 3; k++) {
    double *out = curve->preimage.v + (3 * q + k) * 4;
    out[0] = a[k].u + 0.0; /* no -0 */
    out[1] = a[k].v + 0.0;
    out[2] = a[k].p + 0.0;
    out[3] = a[k].q + 0.0;
  }
}

static void set_knots(const struct ph_arc_system *s, double *knots) {
  const double *t = s->data->knots;
  for (size_t i = 0; i < s->data->n; i++) {
    for (size_t k = 0; k < s->refine; k++) {
      double part = (double)k / (double)s->refine;
      knots[i * s->refine + k] = t[i] + part * (t[i + 1] - t[i]);
    }
  }
  knots[s->segments] = t[s->data->n];
}

enum ph_status ph_arc_curve(const struct ph_arc_system *s, const double *x,
                            struct ph_arena *arena, struct ph_curve *curve,
                            double *turn, struct ph_diag *diag) {
  const struct ph_arc_data *d = s->data;
  struct ph_atph space = ph_atph_of(0);
  ph_vec3 start = ph_vec3_get(d->start, 3);
  struct ph_sum length = {0, 0};
  ph_cplx phase = {1, 0};
  ph_quat a[3];
  enum ph_status status;
  *curve = (struct ph_curve){.kind = PH_CURVE_PH,
                             .closed = d->closed,
                             .dimension = 3,
                             .degree = 5,
                             .n = s->segments,
                             .preimage.n = 3,
                             .preimage.dimension = 4};
  status = ph_curve_alloc(curve, arena, diag);
  if (status != PH_OK) {
    return status;
  }
  set_knots(s, curve->knots);
  for (size_t q = 0; q < s->segments; q++) {
    ph_vec3 end, p[6];
    preimage(s, x, q, a);
    phase = q == 0 ? ph_frame_upright(a[0]) : phase;
    for (size_t k = 0; k < 3; k++) {
      a[k] = ph_quat_turn(a[k], phase);
    }
    end = end_of(s, q, start, a);
    ph_seg3_control_points(&space, a, start, end, p);
    put_segment(q, a, p, curve);
    curve->lengths[q] = ph_seg3_length(&space, a);
    ph_sum_add(&length, curve->lengths[q]);
    start = end;
  }
  curve->length = ph_sum_value(&length);
  *turn = d->closed ? ph_frame_turn(curve, a[2]) : 0;
  return PH_OK;
}

/* Products of neighbouring nodes have no z. */
bool ph_arc_is_flat(const struct ph_arc_system *s, const double *x) {
  for (size_t j = 0; s->dim == 4 && j + 1 < s->nodes; j++) {
    for (size_t k = j; k <= j + 1; k++) {
      double v[4];
      ph_arc_form(4, 3, x + 4 * k, v);
      if (!(fabs(ph_arc_dot(4, x + 4 * j, v)) <= FLAT)) {
        return false;
      }
    }
  }
  return true;
}

/* ---- the result ---------------------------------------------------------- */

/* A length that differs from the natural one by eps makes the curve wiggle by
 * this times the length times sqrt(|eps|). */
static const double WIGGLE = 0.64;
/* There is a warning where an amplitude exceeds this part of an interval. */
static const double WIGGLE_WARNED = 0.01;
/* F of lengths that agree with the points is at most this times F of free
 * ones. */
static const double CONSISTENT = 3;
/* Fitted lengths are missed by fewer standard deviations. */
static const double DEVIATIONS = 3;
/* Below this F is rounding. */
static const double F_ROUNDING = 1e-11;
/* Below this it is that of a curve without bending. */
static const double F_DUST = 1e-25;

/* F and lengths of ours times this are the user's. */
static double unit(const struct ph_arc_search *search) {
  const struct ph_arc_data *d = search->system.data;
  return d->root * d->root;
}

/* An arc that turns by the angle t is longer than its chord by t^2 over this.
 */
static const double ARC = 24;

/* ---- failure ------------------------------------------------------------- */

/* The interval whose rows are missed most. */
static size_t worst_interval(const struct ph_arc_system *s, const double *c) {
  size_t worst = 0, n = s->data->n;
  double most = -1;
  for (size_t i = 0; i < n; i++) {
    double sum = 0;
    for (size_t k = 0; k < s->forms_n; k++) {
      sum += fabs(c[i * s->forms_n + k]);
    }
    for (size_t k = 0; k < 2 * s->knot_rows; k++) {
      sum += fabs(c[n * s->forms_n + i * s->knot_rows + k]);
    }
    if (sum > most) {
      most = sum;
      worst = i;
    }
  }
  return worst;
}

/* An interval that is short for what its data turn by. */
struct shortage {
  size_t interval;
  double turn;   /* of the chords on either side, in the mean */
  double excess; /* length / chord - 1 */
  double needed; /* that of an arc with this turn: turn^2 / 24 */
};

/* The angle between the chords before datum j and after it; 0 at an end. */
static double turn_at(const struct ph_arc_data *d, size_t j) {
  ph_vec3 a, b;
  if (!d->closed && (j == 0 || j == d->n)) {
    return 0;
  }
  a = d->step[(j + d->n - 1) % d->n];
  b = d->step[j % d->n];
  return atan2(ph_vec3_abs(ph_vec3_cross(a, b)), ph_vec3_dot(a, b));
}

/* Of points with lengths: the interval that lacks most, if one does. */
static bool find_shortage(const struct ph_arc_data *d, struct shortage *most) {
  bool found = false;
  for (size_t i = 0; d->chord && d->length && d->n > 1 && i < d->n; i++) {
    bool ends = !d->closed && (i == 0 || i + 1 == d->n);
    double turn = (turn_at(d, i) + turn_at(d, i + 1)) / (ends ? 1 : 2);
    struct shortage s = {i, turn, d->length[i] / d->chord[i] - 1,
                         turn * turn / ARC};
    if (s.needed - s.excess > (found ? most->needed - most->excess : 0)) {
      *most = s;
      found = true;
    }
  }
  return found;
}

/* Lengths, or points alone, that no start met. */
static enum ph_status fail_missed(const struct ph_arc_search *search,
                                  struct ph_arena *scratch,
                                  struct ph_diag *diag) {
  const struct ph_arc_system *s = &search->system;
  const struct ph_arc_data *d = s->data;
  const struct ph_arc_point *p = &search->nearest;
  double back = unit(search), *c, *attained;
  size_t worst, shown;
  struct shortage lacks;
  c = ph_arena_array(scratch, s->y_n, sizeof *c);
  attained = ph_arena_array(scratch, d->n, sizeof *attained);
  if (!c || !attained) {
    return ph_fail_memory(diag);
  }
  ph_arc_residual(s, p->x, c);
  ph_arc_lengths(s, p->x, attained);
  worst = worst_interval(s, c);
  shown = ph_arc_data_user(d, worst);
  if (!d->length) {
    return ph_fail(diag, PH_E_NO_CONVERGENCE, NULL,
                   "no curve was found by %zu starts; interval %zu is missed "
                   "most; residual %.2g of the mean chord",
                   search->starts_n, shown, p->residual);
  }
  if (find_shortage(d, &lacks)) {
    shown = ph_arc_data_user(d, lacks.interval);
    return ph_fail_at(
        diag, PH_E_NO_CONVERGENCE, "lengths", shown,
        "is not met by %zu starts: it is %.3g %s its chord, relative, where "
        "a turn of %.3g takes %.3g; residual %.2g of the mean length",
        search->starts_n, fabs(lacks.excess),
        lacks.excess < 0 ? "below" : "above", lacks.turn, lacks.needed,
        p->residual);
  }
  if (!search->natural.known) {
    return ph_fail_at(diag, PH_E_NO_CONVERGENCE, "lengths", shown,
                      "is not met: %.6g asked for, %.6g attained in interval "
                      "%zu by the best of %zu starts; residual %.2g of the "
                      "mean length",
                      d->length[worst] * back, attained[worst] * back, shown,
                      search->starts_n, p->residual);
  }
  return ph_fail_at(
      diag, PH_E_NO_CONVERGENCE, "lengths", shown,
      "is not met: %.6g asked for, %.6g attained in interval %zu by the best "
      "of %zu starts, naturally %.6g; residual %.2g of the mean length",
      d->length[worst] * back, attained[worst] * back, shown, search->starts_n,
      search->natural.length[worst] * back, p->residual);
}

enum ph_status ph_arc_report_failure(const struct ph_arc_search *search,
                                     struct ph_arena *scratch,
                                     struct ph_diag *diag) {
  if (search->stood_still) {
    return ph_fail(diag, PH_E_NO_CONVERGENCE, "tangents",
                   "have no curve that was found by %zu starts but some that "
                   "stand still at one of them",
                   search->starts_n);
  }
  return fail_missed(search, scratch, diag);
}

/* ---- warnings ------------------------------------------------------------ */

/* Amplitude 0.64 l sqrt(|l / natural - 1|) of the wiggle that a length asks
 * for, beside the length. */
static void warn_wiggle(const struct ph_arc_search *search,
                        struct ph_result *result) {
  const struct ph_arc_data *d = search->system.data;
  const double *natural = search->natural.length;
  double most = 0;
  size_t found = 0, worst = 0;
  for (size_t i = 0; i < d->n; i++) {
    double part = WIGGLE * sqrt(fabs(d->length[i] / natural[i] - 1));
    double amplitude = part * d->length[i];
    found += part > WIGGLE_WARNED;
    if (part > WIGGLE_WARNED && amplitude > most) {
      most = amplitude;
      worst = i;
    }
  }
  if (found > 0) {
    size_t shown = ph_arc_data_user(d, worst);
    ph_warn(result, shown * search->system.refine, PH_W_WIGGLE,
            "lengths[%zu] is %.6g, naturally %.6g: the curve wiggles by about "
            "%.2g (such intervals: %zu)",
            shown, d->length[worst] * unit(search),
            natural[worst] * unit(search), most * unit(search), found);
  }
}

/* The interval that is short where exact lengths are, is the likeliest cause.
 */
static void warn_inconsistent(const struct ph_arc_search *search,
                              struct ph_result *result) {
  const struct ph_arc_data *d = search->system.data;
  double f = search->found[0].point.f * unit(search);
  double relaxed = result->diagnostics.value[PH_D_F_RELAXED];
  struct shortage s;
  if (!(d->sigma > 0) && find_shortage(d, &s)) {
    size_t shown = ph_arc_data_user(d, s.interval);
    ph_warn(
        result, shown * search->system.refine, PH_W_INCONSISTENT_LENGTHS,
        "the lengths fit no smooth curve through the data: F is %.6g, with "
        "free lengths %.6g; lengths[%zu] is %.3g above its chord, relative, "
        "where a turn of %.3g takes %.3g",
        f, relaxed, shown, s.excess, s.turn, s.needed);
  } else {
    ph_warn(result, PH_NO_SEGMENT, PH_W_INCONSISTENT_LENGTHS,
            "the lengths fit no smooth curve through the data: F is %.6g, with "
            "free lengths %.6g",
            f, relaxed);
  }
}

static void warn(const struct ph_arc_search *search, bool left_plane,
                 struct ph_result *result) {
  const struct ph_arc_data *d = search->system.data;
  const struct ph_arc_point *p = &search->found[0].point;
  double rms = result->diagnostics.value[PH_D_LENGTH_RMS];
  if (left_plane) {
    ph_warn(result, PH_NO_SEGMENT, PH_W_LEAVES_PLANE,
            "the data lie in a plane, in which no curve was found: this one "
            "leaves it");
  }
  if (!p->minimiser) {
    ph_warn(result, PH_NO_SEGMENT, PH_W_SADDLE,
            search->system.dim < 4
                ? "the curve bends least in the plane of the data, but not in "
                  "space: \"planar\":\"free\" lets it leave the plane"
                : "no minimum was found: the curve is stationary, and others "
                  "nearby may bend less");
  }
  if (d->sigma > 0 && !search->natural.known) {
    ph_warn(result, PH_NO_SEGMENT, PH_W_NATURAL_UNKNOWN,
            "the curve with free lengths was not found: lengths weigh as much "
            "as its nearest iterate bends, F %.6g, residual %.2g",
            search->natural.f * unit(search), search->natural.residual);
  }
  if (!d->length || d->mode == PH_ARC_TANGENTS || d->n < 2 ||
      !(d->sigma > 0 || search->natural.known)) {
    return;
  }
  if (!(d->sigma > 0)) {
    warn_wiggle(search, result);
  } else if (rms > DEVIATIONS) {
    ph_warn(result, PH_NO_SEGMENT, PH_W_INCONSISTENT_LENGTHS,
            "the lengths are missed by %.3g standard deviations: points that "
            "a curve hardly bends through outweigh them",
            rms);
    return;
  }
  if (p->f > CONSISTENT * search->natural.f + F_ROUNDING) {
    warn_inconsistent(search, result);
  }
}

/* ---- the result ---------------------------------------------------------- */

static void set_diagnostics(const struct ph_arc_search *search,
                            const struct ph_arc_found *found,
                            struct ph_diagnostics *diagnostics) {
  const struct ph_arc_point *p = &found->point;
  ph_diagnostics_set(diagnostics, PH_D_ITERATIONS, (double)p->iterations);
  ph_diagnostics_set(diagnostics, PH_D_RESIDUAL, p->residual);
  ph_diagnostics_set(diagnostics, PH_D_F, p->f * unit(search));
  ph_diagnostics_set(diagnostics, PH_D_KKT_ERROR, p->kkt);
  ph_diagnostics_set(diagnostics, PH_D_SECOND_ORDER,
                     p->minimiser ? PH_OUTCOME_MINIMISER : PH_OUTCOME_SADDLE);
  if (found->weight > 0) {
    ph_diagnostics_set(diagnostics, PH_D_TANGENT_WEIGHT,
                       found->weight * unit(search));
  } else if (search->natural.known || search->system.compliance) {
    double f = search->natural.f > F_DUST ? search->natural.f : 0;
    ph_diagnostics_set(diagnostics, PH_D_F_RELAXED, f * unit(search));
  }
}

/* Lengths of the intervals, in the user's order; of lengths that were fitted
 * the root mean square of (L - l) / (sigma l).
 * out  intervals  [d->n] */
static enum ph_status
set_intervals(const struct ph_arc_search *search,
              const struct ph_arc_found *found, struct ph_arena *scratch,
              struct ph_arena *out, struct ph_interval **intervals,
              struct ph_diagnostics *diagnostics, struct ph_diag *diag) {
  const struct ph_arc_system *s = &search->system;
  const struct ph_arc_data *d = s->data;
  const struct ph_arc_natural *natural = &search->natural;
  double *length = ph_arena_array(scratch, d->n, sizeof *length), sum = 0;
  *intervals = ph_arena_array(out, d->n, sizeof **intervals);
  if (!length || !*intervals) {
    return ph_fail_memory(diag);
  }
  ph_arc_lengths(s, found->point.x, length);
  for (size_t i = 0; i < d->n; i++) {
    size_t shown = ph_arc_data_user(d, i);
    double free_length = natural->known ? natural->length[i] * unit(search)
                         : d->length    ? (double)NAN
                                        : length[i] * unit(search);
    struct ph_interval *interval = *intervals + shown;
    *interval = PH_INTERVAL_NONE;
    interval->length = length[i] * unit(search);
    interval->natural_length = free_length;
    interval->first = shown * s->refine;
    interval->last = (shown + 1) * s->refine - 1;
    if (d->sigma > 0) {
      double off = (length[i] / d->length[i] - 1) / d->sigma;
      sum += off * off;
    }
  }
  if (d->sigma > 0) {
    ph_diagnostics_set(diagnostics, PH_D_LENGTH_RMS, sqrt(sum / (double)d->n));
  }
  return PH_OK;
}

/* The angles to the directions that were measured, in the user's order, and the
 * root mean square of these in standard deviations.
 * out  each  [n + 1], or NULL */
static void set_deviations(const struct ph_arc_search *search, const double *x,
                           double *each, struct ph_diagnostics *diagnostics) {
  const struct ph_arc_data *d = search->system.data;
  double sum = 0;
  size_t terms = 0;
  for (size_t j = 0; d->tangent_sigma && j <= d->n; j++) {
    double angle = ph_arc_deviation(&search->system, x, j);
    double sigma = d->tangent_sigma[j];
    if (each) {
      each[d->reversed ? d->n - j : j] = angle;
    }
    if (sigma > 0) {
      sum += angle / sigma * (angle / sigma);
      terms++;
    }
  }
  if (terms > 0) {
    ph_diagnostics_set(diagnostics, PH_D_TANGENT_RMS,
                       sqrt(sum / (double)terms));
  }
}

static enum ph_status set_starts(const struct ph_arc_search *search,
                                 struct ph_arena *out, struct ph_result *result,
                                 struct ph_diag *diag) {
  result->starts =
      ph_arena_array(out, search->starts_n, sizeof *result->starts);
  if (!result->starts) {
    return ph_fail_memory(diag);
  }
  memcpy(result->starts, search->starts,
         search->starts_n * sizeof *result->starts);
  result->starts_n = search->starts_n;
  result->start = search->found[0].start;
  for (size_t i = 0; i < result->starts_n; i++) {
    result->starts[i].f *= unit(search);
  }
  return PH_OK;
}

static enum ph_status set_solutions(const struct ph_arc_search *search,
                                    struct ph_arena *scratch,
                                    struct ph_arena *out,
                                    struct ph_result *result,
                                    struct ph_diag *diag) {
  enum ph_status status = PH_OK;
  double turn;
  result->solutions =
      ph_arena_array(out, search->found_n, sizeof *result->solutions);
  if (!result->solutions) {
    return ph_fail_memory(diag);
  }
  for (size_t i = 0; status == PH_OK && i < search->found_n; i++) {
    struct ph_solution *solution = &result->solutions[i];
    *solution = (struct ph_solution){.good = i == 0};
    set_diagnostics(search, &search->found[i], &solution->diagnostics);
    set_deviations(search, search->found[i].point.x, NULL,
                   &solution->diagnostics);
    status = ph_arc_curve(&search->system, search->found[i].point.x, out,
                          &solution->curve, &turn, diag);
    if (status == PH_OK) {
      status =
          set_intervals(search, &search->found[i], scratch, out,
                        &solution->intervals, &solution->diagnostics, diag);
    }
  }
  result->solutions_n = status == PH_OK ? search->found_n : 0;
  return status;
}

enum ph_status ph_arc_report(const struct ph_arc_search *search,
                             bool left_plane, struct ph_arena *scratch,
                             struct ph_arena *out, struct ph_result *result,
                             struct ph_diag *diag) {
  double turn;
  enum ph_status status = PH_OK;
  if (!isfinite(search->found[0].point.f * unit(search))) {
    return ph_fail(diag, PH_E_TOO_LARGE, NULL,
                   "the curve exceeds the range of a double");
  }
  status = ph_arc_curve(&search->system, search->found[0].point.x, out,
                        &result->curve, &turn, diag);
  if (status == PH_OK && result->curve.closed) {
    ph_diagnostics_set(&result->diagnostics, PH_D_FRAME_TURN, turn);
  }
  if (status == PH_OK) {
    result->intervals_n = search->system.data->n;
    status = set_intervals(search, &search->found[0], scratch, out,
                           &result->intervals, &result->diagnostics, diag);
  }
  if (status == PH_OK && search->system.data->tangent_sigma) {
    result->deviations_n = search->system.data->n + 1;
    result->deviations =
        ph_arena_array(out, result->deviations_n, sizeof *result->deviations);
    status = result->deviations ? PH_OK : ph_fail_memory(diag);
  }
  if (status == PH_OK) {
    set_deviations(search, search->found[0].point.x, result->deviations,
                   &result->diagnostics);
    status = set_starts(search, out, result, diag);
  }
  if (status == PH_OK && search->all) {
    status = set_solutions(search, scratch, out, result, diag);
  }
  if (status == PH_OK) {
    bool flat = search->system.data->plane &&
                ph_arc_is_flat(&search->system, search->found[0].point.x);
    set_diagnostics(search, &search->found[0], &result->diagnostics);
    if (search->system.data->plane) {
      ph_diagnostics_set(&result->diagnostics, PH_D_PLANAR, flat);
    }
    warn(search, left_plane && !flat, result);
  }
  return status;
}
