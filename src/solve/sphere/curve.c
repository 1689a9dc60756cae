/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The curve of a spherical nu-spline (see sphere_curve.h). */
#include "solve/sphere/curve.h"

#include "base/sum.h"

#include <math.h>
#include <string.h>

static void put(const struct ph_sphere_data *d, ph_vec3 p, double *to) {
  to[0] = d->center[0] + d->radius * p.x;
  to[1] = d->center[1] + d->radius * p.y;
  to[2] = d->center[2] + d->radius * p.z;
}

static enum ph_status set_segments(const struct ph_sphere_spline *s,
                                   struct ph_curve *curve,
                                   struct ph_diag *diag) {
  const struct ph_sphere_data *d = s->data;
  struct ph_sum sum = {0, 0};
  for (size_t k = 0; k < d->m; k++) {
    struct ph_spherical segment = ph_sphere_segment(s, k);
    double length = ph_spherical_length(&segment, 1);
    if (isnan(length)) {
      return ph_fail_at(diag, PH_NO_CONVERGENCE, "segments", k,
                        "has no length to 1e-12, as far as was found");
    }
    for (size_t j = 0; j < 4; j++) {
      put(d, segment.p[j], curve->control_points + (4 * k + j) * 3);
    }
    curve->lengths[k] = d->radius * length;
    ph_sum_add(&sum, curve->lengths[k]);
  }
  curve->length = ph_sum_value(&sum);
  return PH_OK;
}

enum ph_status ph_sphere_curve(const struct ph_sphere_spline *s,
                               const struct ph_sphere_shape *shape,
                               struct ph_arena *arena, struct ph_curve *curve,
                               struct ph_diag *diag) {
  const struct ph_sphere_data *d = s->data;
  *curve = (struct ph_curve){.kind = PH_CURVE_SPHERICAL_NU,
                             .closed = d->closed,
                             .dimension = 3,
                             .degree = 3,
                             .n = d->m,
                             .sphere.radius = d->radius};
  if (ph_curve_alloc(curve, arena, diag) != PH_OK) {
    return diag->status;
  }
  curve->sphere.tensions =
      ph_arena_array(arena, d->n, sizeof *curve->sphere.tensions);
  curve->sphere.indicators =
      ph_arena_array(arena, d->n, sizeof *curve->sphere.indicators);
  if (!curve->sphere.tensions || !curve->sphere.indicators) {
    return ph_fail_memory(diag);
  }
  memcpy(curve->sphere.center, d->center, sizeof curve->sphere.center);
  memcpy(curve->knots, d->knots, (d->m + 1) * sizeof *curve->knots);
  memcpy(curve->sphere.tensions, s->nu, d->n * sizeof *curve->sphere.tensions);
  memcpy(curve->sphere.indicators, shape->q,
         d->n * sizeof *curve->sphere.indicators);
  return set_segments(s, curve, diag);
}
