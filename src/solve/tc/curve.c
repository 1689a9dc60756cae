/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Curves of Tschirnhausen cubics (see tc_curve.h). */
#include "solve/tc/curve.h"

#include <math.h>

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
  double *p = curve->control_points + 8 * i, *w = curve->preimage.v + 4 * i;
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

static void describe(struct ph_tc_builder *b, const struct ph_tc_fit *fit,
                     double length) {
  struct ph_interval *interval = &b->intervals[b->done];
  *interval = PH_INTERVAL_NONE;
  interval->length = length;
  interval->first = b->curve->n - fit->n;
  interval->last = b->curve->n - 1;
  interval->root = fit->root;
  interval->ratio = fit->ratio;
  interval->lambda = fit->lambda;
  interval->joint_angle = fit->joint_angle;
  interval->joint_position = fit->joint_position;
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
  describe(b, fit, ph_sum_value(&sum));
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
