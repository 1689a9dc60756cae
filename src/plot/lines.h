/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Lines as figures draw them and as keys show them: widths, the head of an
 * arrow, and dashes of what is hidden, in ems.
 */
#ifndef PH_PLOT_LINES_H
#define PH_PLOT_LINES_H

#define PH_LINE_CURVE 0.145
#define PH_LINE_OFFSET 0.085
#define PH_LINE_POLYGON 0.06
#define PH_LINE_TRIMMED 0.05
#define PH_LINE_ARROW 0.075
#define PH_LINE_HEAD 0.62

/* Of surfaces. */
#define PH_LINE_CONTACT 0.15
#define PH_LINE_EDGE 0.085
#define PH_LINE_RULING 0.04
#define PH_LINE_HIDDEN 0.05

#define PH_LINE_DASH 0.28

#endif
