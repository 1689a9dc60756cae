/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The sampler by kind (see sample.h). */
#include "curve/sample/sample.h"

#include "curve/kind/kind.h"
#include "curve/offset/loop.h"

enum ph_status ph_sampler_begin(struct ph_sampler *sampler,
                                const struct ph_curve *curve,
                                const struct ph_offset *offset,
                                struct ph_arena *arena, struct ph_diag *diag) {
  const struct ph_kind *kind = ph_kind_of(curve);
  *sampler = (struct ph_sampler){.curve = curve,
                                 .offset = offset,
                                 .arena = arena,
                                 .ops = offset ? &kind->beside : &kind->curve,
                                 .n = curve->n};
  return sampler->ops->begin(sampler, diag);
}

enum ph_status ph_sampler_begin_loop(struct ph_sampler *sampler,
                                     const struct ph_curve *curve,
                                     const struct ph_offset *offset,
                                     const struct ph_loop *loop,
                                     struct ph_arena *arena,
                                     struct ph_diag *diag) {
  *sampler = (struct ph_sampler){.curve = curve,
                                 .offset = offset,
                                 .loop = loop,
                                 .arena = arena,
                                 .ops = &ph_loop_ops,
                                 .n = loop->n};
  return sampler->ops->begin(sampler, diag);
}

enum ph_status ph_sampler_enter(struct ph_sampler *sampler, size_t k,
                                struct ph_diag *diag) {
  sampler->k = k;
  return sampler->ops->enter(sampler, diag);
}

struct ph_sample ph_sampler_at(const struct ph_sampler *sampler, double u) {
  return sampler->ops->at(sampler, u);
}

double ph_sampler_length(const struct ph_sampler *sampler, double u,
                         double *speed) {
  return sampler->ops->length(sampler, u, speed);
}

double ph_sampler_chord_bound(const struct ph_sampler *sampler, double u0,
                              double u1) {
  return sampler->ops->chord_bound(sampler, u0, u1);
}
