/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Figures: all drawings of a run on one page, as SVG, PDF or PNG.
 *
 * Every problem is a panel of a grid, with its views above and its profiles of
 * curvature and torsion below; results of a sweep share the panel of their
 * problem and are told apart by colour, with a legend.  Cairo does the drawing,
 * behind page.c; the same drawings give the same bytes.
 *
 * Views of a plane curve: 1; of one in space: 4, x-y, x-z, y-z and one of all;
 * of one on a sphere: 1, or 2 where part of it is behind.  An SVG has, as
 * elements with a stroke of a colour (colour.h; percent of red, green, blue):
 *
 *   a segment of the curve   1 in each view, on a sphere 1 more where it is
 *       (8,39,70 and 90,47,8  partly hidden; 1 in each profile, which it needs
 *       in turn, 49,32,66     more than one value for.  Not with a sweep: there
 *       the last of a closed  the ramp has the colours
 *       odd number of them)
 *   an offset (5,58,44), a polygon (66,66,66), a tangent (36,36,36; its head
 *       is filled)            1 in each view, on a sphere as above
 *   a joint (85,85,85)        1 in each profile, if there is room for them
 *   a tick (44,44,44), a frame (45,45,45), a line of the graticule (87,88,90),
 *       the outline of a sphere (55,56,58)   1
 *
 * and dots (10,10,10; behind a sphere 55,56,58) that are filled.  What is out
 * of its frame is not there.  Of the points and tangents of a sweep those that
 * all curves share are there once, others in the colours of the ramp.
 */
#ifndef PH_PLOT_FIGURE_H
#define PH_PLOT_FIGURE_H

#include "base/buf.h"
#include "base/diag.h"
#include "plot/drawing.h"

#include <stdbool.h>

/* Formats: X(SYMBOL, "suffix"). */
#define PH_FIGURE_FORMATS(X) \
  X(SVG, ".svg")             \
  X(PDF, ".pdf")             \
  X(PNG, ".png")

enum ph_figure_format {
#define X(symbol, suffix) PH_FIGURE_##symbol,
  PH_FIGURE_FORMATS(X)
#undef X
      PH_FIGURE_FORMAT_N
};

/* How a figure is made. */
struct ph_figure_rules {
  enum ph_figure_format format;
  double width, height; /* points, or pixels of a PNG; 0: as is needed */
};

/* More panels than this, or results of a sweep in one, are not drawn. */
enum { PH_FIGURE_PANELS_MAX = 100, PH_FIGURE_SWEEP_MAX = 1000 };

/* ph_figure_format_of: the format that a file's name asks for;
 * PH_FIGURE_FORMAT_N: none of them. */
enum ph_figure_format ph_figure_format_of(const char *file);

/* ph_figure_can: whether the program was built with cairo. */
bool ph_figure_can(void);

/*
 * ph_figure_write: appends the bytes of the figure.
 *
 * Titles and labels may be any bytes and of any length, numbers any doubles.
 *
 * in   drawings[n]  in the order of the records; n = 0 is an empty page
 * ret  PH_OK | PH_NO_MEMORY | PH_INTERNAL (cairo failed, or is not there; says
 *      why)
 */
enum ph_status ph_figure_write(const struct ph_drawing *const *drawings,
                               size_t n, const struct ph_figure_rules *rules,
                               struct ph_buf *out, struct ph_diag *diag);

#endif
