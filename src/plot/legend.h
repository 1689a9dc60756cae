/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The legend of a sweep: a line of its colour for every value, or a bar of
 * colours where there are many. */
#ifndef PH_PLOT_LEGEND_H
#define PH_PLOT_LEGEND_H

#include "plot/panel.h"

/* More values than this have a bar. */
enum { PH_LEGEND_MAX = 10 };

/* ph_legend_width: how much room it takes, at most `most`; 0: nothing needs
 * one. */
double ph_legend_width(const struct ph_panel *panel, struct ph_page *page,
                       double em, double most);

/* ph_legend_draw: at the top of its place. */
void ph_legend_draw(const struct ph_panel *panel, struct ph_page *page,
                    const struct ph_rect *place, double em);

/*
 * ph_legend_common: how many bytes at the start all labels have in common: the
 * name that "name = value" begins with, and " = ".
 */
size_t ph_legend_common(const struct ph_panel *panel);

#endif
