/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Samples: the choice of places, and the arrays (see sample.h). */
#include "curve/sample.h"

#include "base/sum.h"
#include "curve/sample_kind.h"


static const struct ph_sample_kind *kind_of(const struct ph_curve *curve,
                                            const struct ph_offset *offset) {
  switch (curve->kind) {
  case PH_CURVE_SPHERICAL_NU:
    return &ph_sample_kind_spherical;
  case PH_CURVE_BEZIER:
    return &ph_sample_kind_bezier;
  default:
    return &ph_sample_kind_ph;
  }
}

enum ph_status ph_sampler_begin(struct ph_sampler *sampler,
                                const struct ph_curve *curve,
                                const struct ph_offset *offset,
                                struct ph_arena *arena, struct ph_diag *diag) {
  *sampler = (struct ph_sampler){curve, offset, arena, kind_of(curve, offset),
                                 NULL,  0,      0};
  return sampler->kind->begin(sampler, diag);
}

enum ph_status ph_sampler_enter(struct ph_sampler *sampler, size_t k,
                                struct ph_diag *diag) {
  sampler->k = k;
  return sampler->kind->enter(sampler, diag);
}

struct ph_sample ph_sampler_at(const struct ph_sampler *sampler, double u) {
  return sampler->kind->at(sampler, u);
}

double ph_sampler_length(const struct ph_sampler *sampler, double u,
                         double *speed) {
  return sampler->kind->length(sampler, u, speed);
}

double ph_sampler_bend(const struct ph_sampler *sampler, double u0, double u1) {
  return sampler->kind->bend(sampler, u0, u1);
}

enum ph_status ph_samples_alloc(struct ph_samples *s,
                                const struct ph_curve *curve, bool frame,
                                size_t room, struct ph_arena *arena,
                                struct ph_diag *diag) {
  size_t number = sizeof(double), dimension = curve->dimension;
  bool sphere = curve->kind == PH_CURVE_SPHERICAL_NU;
  bool torsion = dimension == 3 && !sphere;
  *s = (struct ph_samples){.dimension = dimension};
  s->segment = ph_arena_array(arena, room, sizeof *s->segment);
  s->t = ph_arena_array(arena, room, number);
  s->s = ph_arena_array(arena, room, number);
  s->point = ph_arena_array(arena, room, dimension * number);
  s->tangent = ph_arena_array(arena, room, dimension * number);
  s->curvature = ph_arena_array(arena, room, number);
  s->torsion = torsion ? ph_arena_array(arena, room, number) : NULL;
  s->lonlat = sphere ? ph_arena_array(arena, room, 2 * number) : NULL;
  s->normal = frame ? ph_arena_array(arena, room, 3 * number) : NULL;
  s->binormal = frame ? ph_arena_array(arena, room, 3 * number) : NULL;
  return s->segment && s->t && s->s && s->point && s->tangent && s->curvature &&
                 (s->torsion || !torsion) && (s->lonlat || !sphere) &&
                 ((s->normal && s->binormal) || !frame)
             ? PH_OK
             : ph_fail_memory(diag);
}

void ph_samples_add(struct ph_samples *samples, size_t segment, double t,
                    double s, const struct ph_sample *sample) {
  size_t dimension = samples->dimension, i = samples->n++;
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

enum ph_status ph_sample_curve(const struct ph_curve *curve,
                               const struct ph_sample_rules *rules,
                               struct ph_arena *arena,
                               struct ph_samples *samples,
                               struct ph_diag *diag) {
  const size_t n = rules->n;
  struct ph_sum start = {0, 0};
  struct ph_sampler sampler;
  enum ph_status status =
      ph_samples_alloc(samples, curve, rules->frame != PH_FRAME_NONE,
                       curve->n * (n + 1), arena, diag);
  if (status == PH_OK) {
    status = ph_sampler_begin(&sampler, curve, NULL, arena, diag);
  }
  for (size_t k = 0; status == PH_OK && k < curve->n; k++) {
    double range = curve->alpha ? curve->alpha[k] : 1;
    status = ph_sampler_enter(&sampler, k, diag);
    for (size_t i = 0; status == PH_OK && i <= n; i++) {
      double u = (double)i / (double)n, speed;
      struct ph_sample sample = ph_sampler_at(&sampler, u);
      struct ph_sum s = start;
      ph_sum_add(&s, ph_sampler_length(&sampler, u, &speed));
      ph_samples_add(samples, k, u * range, ph_sum_value(&s), &sample);
    }
    ph_sum_add(&start, curve->lengths[k]);
  }
  return status;
}

enum ph_status ph_sample_offset(const struct ph_curve *curve,
                                const struct ph_sample_rules *rules,
                                struct ph_arena *arena,
                                struct ph_offset *offset,
                                struct ph_diag *diag) {
  (void)curve, (void)rules, (void)arena, (void)offset, (void)diag;
  return PH_OK;
}
