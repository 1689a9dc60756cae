/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Panoramas, as checks see them: every point of the picture is looked for on
 * the rulings laid flat, by their sides, and the volume asked there.
 */
#ifndef PH_CHECK_PANORAMA_H
#define PH_CHECK_PANORAMA_H

#include "check/note.h"

/* A ruling at unit scale, laid flat and in space; the ruling is to the left of
 * the direction at the angle. */
struct ph_check_ruling {
  double x, y, angle;
  ph_vec3 c, e;
};

/* How a surface is laid flat, strip by strip. */
struct ph_check_sheet {
  void *context;
  /* that strip i is looked at from now on; ret the steps in which its rulings
   * turn by less than a half */
  size_t (*load)(void *context, size_t i);
  struct ph_check_ruling (*at)(void *context, double u);
};

/*
 * ph_check_panorama: the panorama of the record: that the development is in the
 * picture, and how many points are on it; with the volume how many of these are
 * outside of it, range and mean of the values.
 *
 * ret  PH_OK | PH_E_NO_MEMORY
 */
enum ph_status ph_check_panorama(struct ph_check *v,
                                 const struct ph_check_sheet *sheet);

#endif
