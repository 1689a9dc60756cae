/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * What a surface looks like: rulings, near enough to one another that what is
 * between two of them is flat to the eye, in space and in the development.
 */
#ifndef PH_PLOT_SHEET_H
#define PH_PLOT_SHEET_H

#include "base/diag.h"
#include "base/mem.h"
#include "curve/result.h"
#include "kernel/vec3.h"

/* A ruling over the height, in the unit of the data. */
struct ph_rib {
  size_t strip;
  ph_vec3 end[2];                /* at both heights */
  ph_vec3 contact, normal;       /* of the contact curve, and there */
  ph_vec3 flat[2], flat_contact; /* the same in the development, z = 0 */
  bool joint, shown;             /* at the end of a strip; one of the others
                                    that are drawn */
  bool last;                     /* nothing between this one and the next */
};

/* A contact element: point, unit vectors, and where it is when laid flat. */
struct ph_element {
  ph_vec3 point, ruling, tangent;
  ph_vec3 flat, flat_ruling, flat_tangent;
};

struct ph_sheet {
  struct ph_rib *ribs; /* [ribs_n] */
  size_t ribs_n;
  bool bare; /* no height: ends of ribs are on the contact curve */
  struct ph_element *elements; /* [elements_n]; none if there are too many */
  size_t elements_n;
};

/* Rulings of all strips, and strips, of which there are more than that: every
 * so many-th one counts. */
enum { PH_SHEET_RIBS = 6000, PH_SHEET_STRIPS = 1000 };

/* ph_sheet_step: each so many-th of n strips counts. */
static inline size_t ph_sheet_step(size_t n) {
  return (n + PH_SHEET_STRIPS - 1) / PH_SHEET_STRIPS;
}

/*
 * ph_sheet_make: looks at a surface.
 *
 * ret  PH_OK | PH_E_NO_MEMORY
 */
enum ph_status ph_sheet_make(const struct ph_curve *curve,
                             struct ph_arena *arena, struct ph_sheet *sheet,
                             struct ph_diag *diag);

#endif
