/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Random data of spatial Hermite interpolation, for benchmarks. */
#ifndef PH_BENCH_SPATIAL_H
#define PH_BENCH_SPATIAL_H

#include "bench.h"

#include "solve/spatial/spatial.h"

/* bench_direction: a unit vector, anywhere on the sphere. */
static inline ph_vec3 bench_direction(uint64_t *state) {
  double z = bench_uniform(state, -1, 1), r = sqrt(1 - z * z);
  ph_cplx e = ph_cplx_polar(bench_uniform(state, 0, 6.283185307179586));
  return ph_vec3_of(r * e.re, r * e.im, z);
}

/* bench_hermite: a chord of length 1, any tangents, derivatives by t of 0.3 to
 * 3.3. */
static inline struct ph_spatial_data bench_hermite(uint64_t *state) {
  struct ph_spatial_data data = {.noise = 0};
  data.dp = bench_direction(state);
  data.ti = bench_direction(state);
  data.tf = bench_direction(state);
  data.ni = exp(bench_uniform(state, -1.2, 1.2));
  data.nf = exp(bench_uniform(state, -1.2, 1.2));
  return data;
}

#endif
