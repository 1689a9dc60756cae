/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Figures: all drawings of a run on one page, as SVG, PDF or PNG.
 *
 * Every problem is a panel of a grid, with its views above and its profiles of
 * curvature and torsion below; results of a sweep share the panel of their
 * problem and are told apart by colour, with a legend.  Cairo does the drawing,
 * behind page.c; the same drawings give the same bytes.
 *
 * There is 1 view of a plane curve; of one in space there are 4: x-y, x-z, y-z
 * and one of all; of one on a sphere 1, or 2 where part of it is behind; of a
 * surface 1, and 1 of its development.  In an SVG, these are elements of their
 * own, told apart by their colour (red, green, blue in percent: colour.h):
 *
 *   stroke 8,39,70 and 90,47,8  segments of the curve in turn; 49,32,66: the
 *                               last of a closed curve of an odd number of them
 *   stroke 66,66,66             polygons
 *   stroke 5,58,44              offsets
 *   stroke 36,36,36             tangents, without their heads
 *          1 in each view, and 1 more on a sphere if it is hidden in part; of
 *          segments 1 more in each profile that has more than one value for it
 *   stroke 85,85,85             joints: 1 in each profile, if there is room
 *   stroke 44,44,44             ticks: 1 each, also of boxes
 *   stroke 45,45,45             frames: 1 of each view and profile with axes
 *   stroke 87,88,90             lines of the graticule
 *   stroke 55,56,58             outlines of spheres
 *   stroke 22,24,28             edges of surfaces, rulings between strips, in
 *                               pieces; 1 of all that is hidden
 *   stroke 58,60,64             other rulings of surfaces
 *   fill 10,10,10               data points: 1 in each view; hidden ones
 *                               55,56,58
 *
 * Below all is a key of the kinds of things that are shown: in an SVG a group
 * of the class key, which the numbers above do not count.  An SVG has its text
 * as text, and a title and a description.
 *
 * What is out of its frame is not there.  In a sweep curves and offsets have
 * the colours of the ramp, as have points and tangents that not all curves
 * share, and there are neither polygons nor joints; up to 10 curves have dashes
 * of their own (colour.h), to be told apart without colours.
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
  const char *title;    /* above all panels, any bytes; NULL: none */
  bool labels;          /* points have their numbers */
};

/* More panels than this, or results of a sweep in one, are not drawn. */
enum { PH_FIGURE_PANELS_MAX = 100, PH_FIGURE_SWEEP_MAX = 1000 };

/* ph_figure_format_of: the format that a file's name asks for;
 * PH_FIGURE_FORMAT_N: none of them. */
enum ph_figure_format ph_figure_format_of(const char *file);

/* ph_figure_can: whether there can be figures (ph_page_can). */
enum ph_status ph_figure_can(struct ph_diag *diag);

/*
 * ph_figure_write: appends the bytes of the figure.
 *
 * Titles and labels may be any bytes and of any length, numbers any doubles.
 *
 * in   drawings[n]  in the order of the records; n = 0 is an empty page
 * ret  PH_OK | PH_E_NO_MEMORY | PH_E_INTERNAL (cairo failed; says why) |
 *      PH_E_USAGE (it is not there)
 */
enum ph_status ph_figure_write(const struct ph_drawing *const *drawings,
                               size_t n, const struct ph_figure_rules *rules,
                               struct ph_buf *out, struct ph_diag *diag);

#endif
