/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A page to draw on: lines, discs, letters.  All that knows cairo is page.c;
 * without it (PH_CAIRO is not defined) there are no pages.  SVG is written by
 * page_svg.c; cairo tells it how wide text is.
 *
 * Coordinates are points, of a PNG pixels, y downwards.  What fails is
 * remembered, and told at the end.
 */
#ifndef PH_PLOT_PAGE_H
#define PH_PLOT_PAGE_H

#include "base/buf.h"
#include "base/diag.h"
#include "plot/clip.h"
#include "plot/colour.h"
#include "plot/figure.h"

#include <stdbool.h>

struct ph_page;

/* ph_page_can: whether there are pages: the program was built with cairo, and
 * finds it.
 * ret  PH_OK | PH_E_USAGE (says what is missing) */
enum ph_status ph_page_can(struct ph_diag *diag);

/* What a page is, and what its file says of it. */
struct ph_page_head {
  enum ph_figure_format format;
  double width, height;
  const char *title, *description; /* UTF-8; NULL: none */
};

/*
 * ph_page_begin: a white page.
 *
 * out  page  to be ended; NULL on failure
 * ret  PH_OK | PH_E_NO_MEMORY | PH_E_INTERNAL (cairo says why) | PH_E_USAGE
 *      (there are none)
 */
enum ph_status ph_page_begin(const struct ph_page_head *head,
                             struct ph_buf *out, struct ph_page **page,
                             struct ph_diag *diag);

/* ph_page_end: finishes the file in `out`, frees the page. */
enum ph_status ph_page_end(struct ph_page *page, struct ph_diag *diag);

/* ph_page_pen: colour and width of what is stroked and filled from now on;
 * dash: length of dashes, 0: none. */
void ph_page_pen(struct ph_page *page, struct ph_colour colour, double width,
                 double dash);

/* ph_page_dash: dashes of what is stroked until the pen changes. */
void ph_page_dash(struct ph_page *page, const struct ph_dash *dash);

/* ph_page_group: what follows belongs together, up to NULL; in an SVG it is a
 * group of this class. */
void ph_page_group(struct ph_page *page, const char *name);

/* A path is built by moves, lines and cubics, then stroked or filled, and is
 * one element of the file. */
void ph_page_move(struct ph_page *page, struct ph_spot to);
void ph_page_line(struct ph_page *page, struct ph_spot to);
void ph_page_curve(struct ph_page *page, const struct ph_spot spots[3]);
void ph_page_circle(struct ph_page *page, struct ph_spot center, double radius);
void ph_page_rect(struct ph_page *page, const struct ph_rect *rect);
void ph_page_close(struct ph_page *page);
void ph_page_stroke(struct ph_page *page);
void ph_page_fill(struct ph_page *page);

/* ph_page_paint: fills and strokes it, so that no gap shows to a neighbour. */
void ph_page_paint(struct ph_page *page);

/* ph_page_text_width: of UTF-8 text in letters of a size. */
double ph_page_text_width(struct ph_page *page, double size, const char *text);

/*
 * ph_page_text: valid UTF-8 text.
 *
 * in   at     of its base line
 * in   align  0: starts there, 0.5: is centred, 1: ends there
 * in   up     reads from bottom to top
 */
void ph_page_text(struct ph_page *page, struct ph_spot at, double size,
                  double align, bool up, const char *text);

#endif
