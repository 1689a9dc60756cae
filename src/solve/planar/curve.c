/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Curves of planar splines (see planar_curve.h). */
#include "solve/planar/curve.h"

#include "base/sum.h"
#include "curve/ph2.h"
#include "curve/seg2.h"
#include "kernel/pi.h"

#include <math.h>
#include <string.h>

enum ph_status ph_planar_curve_alloc(const struct ph_planar_data *d,
                                     struct ph_arena *arena,
                                     struct ph_curve *curve,
                                     struct ph_diag *diag) {
  *curve = (struct ph_curve){.kind = d->atph ? PH_CURVE_ATPH : PH_CURVE_PH,
                             .closed = d->closed,
                             .dimension = 2,
                             .degree = 5,
                             .n = d->n,
                             .preimage.n = 3,
                             .preimage.dimension = 2};
  return ph_curve_alloc(curve, arena, diag);
}

/* The tangent stays within a half turn if w stays within a quarter turn. */
static bool is_tame(const ph_cplx w[3]) {
  return ph_cplx_dot(w[0], w[1]) > 0 && ph_cplx_dot(w[1], w[2]) > 0 &&
         ph_cplx_dot(w[0], w[2]) > 0;
}

static void loops_add(struct ph_planar_loops *loops, size_t k,
                      const struct ph_atph *space, const ph_cplx w[3]) {
  struct ph_seg2 seg = {*space, {w[0], w[1], w[2]}, {0, 0}, {0, 0}};
  double angle = is_tame(w) ? 0 : ph_seg2_rotation(&seg, NULL);
  if (!(fabs(angle) <= PH_PI) && loops->n++ == 0) {
    loops->first = k;
    loops->angle = angle;
  }
}

/* Control points and lengths come from the preimage with respect to u in [0,1];
 * that of an atph curve is written with respect to t. */
void ph_planar_curve_fill(const struct ph_planar_data *d, const ph_cplx *b,
                          struct ph_curve *curve,
                          struct ph_planar_loops *loops) {
  double root = ldexp(1, -d->exponent / 2);
  struct ph_sum length = {0, 0};
  *loops = (struct ph_planar_loops){0, 0, 0};
  memcpy(curve->knots, d->knots, (d->n + 1) * sizeof *d->knots);
  for (size_t k = 0; k < d->n; k++) {
    const struct ph_atph *space = ph_planar_space(&d->c2, k);
    double size = root * sqrt(d->h[k]);
    ph_cplx w[3];
    ph_planar_preimage(&d->c2, b, k, w);
    loops_add(loops, k, space, w);
    for (int i = 0; i < 3; i++) {
      w[i] = ph_cplx_scale(size, w[i]);
    }
    ph_ph2_control_points(space, w, ph_planar_point(d, k),
                          ph_planar_point(d, k + 1),
                          (ph_cplx *)(curve->control_points + 12 * k));
    curve->lengths[k] = ph_ph2_length(space, w);
    ph_sum_add(&length, curve->lengths[k]);
    for (int i = 0; d->atph && i < 3; i++) {
      w[i] = ph_cplx_scale(1 / sqrt(space->angle), w[i]);
    }
    if (d->atph) {
      curve->preimage.alpha[k] = space->angle;
    }
    memcpy(curve->preimage.v + 6 * k, w, sizeof w);
  }
  curve->length = ph_sum_value(&length);
}
