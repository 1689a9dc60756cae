/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * By how much a spline meets the criteria of shape: numbers that are >= 0 where
 * they hold with a margin, smooth in the tensions, for linear programs. Whether
 * a criterion does hold is for sphere_criteria.h to say: on a segment these are
 * samples.
 */
#ifndef PH_SOLVE_SPHERE_MEASURE_H
#define PH_SOLVE_SPHERE_MEASURE_H

#include "solve/sphere/criteria.h"

/* Samples of a segment; the most numbers of a segment or node. */
enum { PH_SPHERE_SAMPLES = 9, PH_SPHERE_MEASURES = PH_SPHERE_SAMPLES };

/* ph_sphere_measure_node, ph_sphere_measure_segment: the numbers of what is
 * asked of node i, or of segment k.
 * ret  how many, 0 if nothing is asked; out  g[PH_SPHERE_MEASURES] */
size_t ph_sphere_measure_node(const struct ph_sphere_shape *shape,
                              const struct ph_sphere_spline *s, size_t i,
                              double *g);
size_t ph_sphere_measure_segment(const struct ph_sphere_shape *shape,
                                 const struct ph_sphere_spline *s, size_t k,
                                 double *g);

#endif
