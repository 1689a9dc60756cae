/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A figure in words, for those who do not see it: the description in an SVG. */
#ifndef PH_PLOT_DESCRIBE_H
#define PH_PLOT_DESCRIBE_H

#include "base/buf.h"
#include "plot/panel.h"

/* More panels than this are counted only. */
enum { PH_DESCRIBE_PANELS = 10 };

/* ph_describe: appends a sentence for each panel. */
void ph_describe(const struct ph_panel *panels, size_t n, struct ph_buf *out);

#endif
