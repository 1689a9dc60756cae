/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Samples: the choice of places, and the arrays (see sample.h). */
#include "curve/sample.h"

#include "base/sum.h"
#include "curve/sample_kind.h"

#include <stdint.h>

/* Nodes for points of PH and ATPH segments, and for lengths of Bezier ones. */
enum { NODES = 12, NODES_BEZIER = 16 };

bool ph_sampler_begin(struct ph_sampler *sampler,
                      const struct ph_curve *curve) {
  sampler->curve = curve;
  return ph_quad_gauss(&sampler->rule,
                       curve->kind == PH_CURVE_BEZIER ? NODES_BEZIER : NODES);
}

struct ph_sample ph_sample_at(const struct ph_sampler *sampler, size_t k,
                              double u) {
  const struct ph_curve *curve = sampler->curve;
  struct ph_sample sample;
  if (curve->kind == PH_CURVE_SPHERICAL_NU) {
    sample = ph_sample_spherical(sampler, k, u);
  } else if (curve->kind == PH_CURVE_BEZIER) {
    sample = ph_sample_bezier(sampler, k, u);
  } else {
    sample = ph_sample_ph(sampler, k, u);
  }
  if (!(u < 1)) {
    sample.length = curve->lengths[k];
  }
  return sample;
}

size_t ph_samples_count(size_t segments, size_t n) {
  return n < SIZE_MAX / segments ? segments * (n + 1) : 0;
}

enum ph_status ph_samples_alloc(struct ph_samples *s, size_t dimension,
                                bool torsion, bool lonlat,
                                struct ph_arena *arena, struct ph_diag *diag) {
  size_t n = s->n, number = sizeof(double);
  s->dimension = dimension;
  s->segment = ph_arena_array(arena, n, sizeof *s->segment);
  s->t = ph_arena_array(arena, n, number);
  s->s = ph_arena_array(arena, n, number);
  s->point = ph_arena_array(arena, n, dimension * number);
  s->tangent = ph_arena_array(arena, n, dimension * number);
  s->curvature = ph_arena_array(arena, n, number);
  s->torsion = torsion ? ph_arena_array(arena, n, number) : NULL;
  s->lonlat = lonlat ? ph_arena_array(arena, n, 2 * number) : NULL;
  return s->segment && s->t && s->s && s->point && s->tangent && s->curvature &&
                 (s->torsion || !torsion) && (s->lonlat || !lonlat)
             ? PH_OK
             : ph_fail_memory(diag);
}

void ph_samples_put(struct ph_samples *samples, size_t i, size_t segment,
                    double t, double s, const struct ph_sample *sample) {
  size_t dimension = samples->dimension;
  samples->segment[i] = segment;
  samples->t[i] = t;
  samples->s[i] = s;
  ph_vec3_put(sample->point, dimension, samples->point + dimension * i);
  ph_vec3_put(sample->tangent, dimension, samples->tangent + dimension * i);
  samples->curvature[i] = sample->curvature;
  if (samples->torsion) {
    samples->torsion[i] = sample->torsion;
  }
  if (samples->lonlat) {
    samples->lonlat[2 * i] = sample->lonlat[0];
    samples->lonlat[2 * i + 1] = sample->lonlat[1];
  }
}

enum ph_status ph_sample_curve(const struct ph_curve *curve, size_t n,
                               struct ph_arena *arena,
                               struct ph_samples *samples,
                               struct ph_diag *diag) {
  bool sphere = curve->kind == PH_CURVE_SPHERICAL_NU;
  struct ph_sum start = {0, 0};
  struct ph_sampler sampler;
  enum ph_status status;
  samples->n = ph_samples_count(curve->n, n);
  if (samples->n == 0 || !ph_sampler_begin(&sampler, curve)) {
    return ph_fail_memory(diag);
  }
  status =
      ph_samples_alloc(samples, curve->dimension,
                       curve->dimension == 3 && !sphere, sphere, arena, diag);
  for (size_t k = 0; status == PH_OK && k < curve->n; k++) {
    double range = curve->alpha ? curve->alpha[k] : 1;
    for (size_t i = 0; i <= n; i++) {
      double u = (double)i / (double)n;
      struct ph_sample sample = ph_sample_at(&sampler, k, u);
      struct ph_sum s = start;
      ph_sum_add(&s, sample.length);
      ph_samples_put(samples, (n + 1) * k + i, k, u * range, ph_sum_value(&s),
                     &sample);
    }
    ph_sum_add(&start, curve->lengths[k]);
  }
  return status;
}
