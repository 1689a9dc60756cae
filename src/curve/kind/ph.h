/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The sampler of offsets of curves with a preimage: for ph.c alone. */
#ifndef PH_CURVE_KIND_PH_H
#define PH_CURVE_KIND_PH_H

#include "curve/sample/sample.h"

/* As in struct ph_sampler_ops (curve/kind/kind.h). */
enum ph_status ph_beside_begin(struct ph_sampler *sampler,
                               struct ph_diag *diag);
enum ph_status ph_beside_enter(struct ph_sampler *sampler,
                               struct ph_diag *diag);
struct ph_sample ph_beside_at(const struct ph_sampler *sampler, double u);
double ph_beside_length(const struct ph_sampler *sampler, double u,
                        double *speed);
double ph_beside_chord_bound(const struct ph_sampler *sampler, double u0,
                             double u1);

#endif
