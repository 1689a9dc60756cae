/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Spheres: from where they are looked at, their outline and graticule. */
#ifndef PH_PLOT_GLOBE_H
#define PH_PLOT_GLOBE_H

#include "plot/strokes.h"

enum { PH_GLOBE_CAPTION_MAX = 64 };

/*
 * ph_globe_views: a view on the middle of the curves, and where part of them is
 * behind the sphere, a second one on the middle of that part.
 *
 * ret  how many, 1 or 2
 */
size_t ph_globe_views(const struct ph_panel *panel, struct ph_view views[2]);

/*
 * ph_globe_reach: how far from the middle of a view what is drawn goes, 1 for
 * the whole sphere; a curve that takes little of the sphere is seen from
 * nearer.
 *
 * out  middle  what is to be in the middle of the view
 */
double ph_globe_reach(const struct ph_panel *panel, const struct ph_view *view,
                      struct ph_seen *middle);

/* ph_globe_step: degrees from line to line of the graticule: 30, or less where
 * the view shows less than the whole sphere. */
double ph_globe_step(double reach);

/* ph_globe_caption: "from longitude 30, latitude -20", in degrees. */
void ph_globe_caption(const struct ph_view *view,
                      char text[PH_GLOBE_CAPTION_MAX]);

/* ph_globe_draw: outline and graticule, of which each line is a path. */
void ph_globe_draw(const struct ph_look *look, double reach);

#endif
