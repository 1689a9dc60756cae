/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Places of tensor product Bezier patches (surface.h), on grids: a line of
 * constant v first, then places on it. */
#ifndef PH_CURVE_SURFACE_PATCH_H
#define PH_CURVE_SURFACE_PATCH_H

#include "kernel/vec3.h"

#include <stddef.h>

/* The highest degree of a patch by one parameter. */
enum { PH_PATCH_DEGREE_MAX = 32, PH_PATCH_ROW = PH_PATCH_DEGREE_MAX + 1 };

/* Rows of Taylor weights at a parameter (ph_bern_taylor), orders 0 to 2. */
struct ph_patch_rows {
  double w[3][PH_PATCH_ROW];
};

/* ph_patch_rows_at: those of a degree. */
void ph_patch_rows_at(size_t degree, double at, struct ph_patch_rows *rows);

/* A line of constant v: Bezier curves of the point and its derivatives by v. */
struct ph_patch_line {
  ph_vec3 c[3][PH_PATCH_ROW];
};

/* A place: derivatives by u and v. */
struct ph_patch_jet {
  ph_vec3 p, u, v, uu, uv, vv;
};

/*
 * ph_patch_line_at: of derivatives up to `order', at most 2.
 *
 * in   points  (degree + 1)^2 control points
 * in   rows    at v
 */
void ph_patch_line_at(const double *points, size_t degree,
                      const struct ph_patch_rows *rows, size_t order,
                      struct ph_patch_line *line);

/* ph_patch_jet_at: the place at u of a line; of derivatives, those up to
 * `order' are set. */
void ph_patch_jet_at(const struct ph_patch_line *line, size_t degree,
                     const struct ph_patch_rows *rows, size_t order,
                     struct ph_patch_jet *jet);

#endif
