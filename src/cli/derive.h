/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the options ask for beside a curve: offsets, Bezier curves in its place,
 * samples, paths. */
#ifndef PH_CLI_DERIVE_H
#define PH_CLI_DERIVE_H

#include "cli/option.h"

/* What is no part of the result. */
struct ph_derived {
  struct ph_curve exact;   /* what offsets are of: as it was before --convert */
  struct ph_pieces *paths; /* formats of cubics: the curve, then its offsets */
  size_t paths_n;          /* 0: not asked for */
  struct ph_tiling *tilings; /* formats of meshes: the surface, then those
                                beside it */
  size_t tilings_n;          /* 0: not asked for */
};

/*
 * ph_derive: fills offsets and samples of a result, with warnings about cusps,
 * and replaces its curves.
 *
 * ret  PH_OK | PH_E_BAD_VALUE (of the field at) | what offsets, conversion and
 *      samples return
 */
enum ph_status ph_derive(const struct ph_options *options,
                         const struct ph_problem *problem,
                         struct ph_arena *arena, struct ph_result *result,
                         struct ph_derived *derived, struct ph_diag *diag);

/* ph_derive_surface: the same of surfaces: parallel ones, samples, edges, paths
 * of developments, meshes. */
enum ph_status ph_derive_surface(const struct ph_options *options,
                                 struct ph_arena *arena,
                                 struct ph_result *result,
                                 struct ph_derived *derived,
                                 struct ph_diag *diag);

#endif
