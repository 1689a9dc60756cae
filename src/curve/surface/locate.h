/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Points of the development back on the surface (surface.h).
 */
#ifndef PH_CURVE_SURFACE_LOCATE_H
#define PH_CURVE_SURFACE_LOCATE_H

#include "base/diag.h"
#include "base/mem.h"
#include "curve/result.h"

/* A box in the plane of the development. */
struct ph_flat_box {
  double low[2], high[2];
};

/*
 * ph_flat_boxes: around the developments of all strips, within the height.
 *
 * out  near  what a point may be off by the rounding of coordinates
 * ret  [curve.n], NULL: memory is exhausted
 */
struct ph_flat_box *ph_flat_boxes(const struct ph_curve *curve,
                                  struct ph_arena *arena, double *near);

/* ph_flat_has: whether a point is in a box. */
static inline bool ph_flat_has(const struct ph_flat_box *box,
                               const double flat[2]) {
  return flat[0] >= box->low[0] && flat[0] <= box->high[0] &&
         flat[1] >= box->low[1] && flat[1] <= box->high[1];
}

/*
 * ph_strip_locate: the place of strip i that is at a point of the development.
 *
 * in   near  how far from the strip a point is still on its edge
 * ret  whether there is one within the length and the height
 */
bool ph_strip_locate(const struct ph_curve *curve, size_t i,
                     const double flat[2], double near,
                     struct ph_surface_sample *at);

/*
 * ph_surface_locate: the places of n points of the development.  Where it
 * covers itself, the first strip counts; what is on no strip is left out.
 *
 * ret  PH_OK | PH_E_NO_MEMORY
 */
enum ph_status ph_surface_locate(const struct ph_curve *curve,
                                 const double (*flat)[2], size_t n,
                                 struct ph_arena *arena,
                                 struct ph_located_list *list,
                                 struct ph_diag *diag);

#endif
