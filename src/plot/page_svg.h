/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A page as SVG: an element a line, paths by their colours, text as text, so
 * that it can be read, searched and changed.  Coordinates have 3 decimals.
 *
 * It is what page.h says of the functions of the same names.
 */
#ifndef PH_PLOT_PAGE_SVG_H
#define PH_PLOT_PAGE_SVG_H

#include "plot/page.h"

struct ph_page_svg {
  struct ph_buf *out;
  struct ph_buf path; /* the commands so far */
  struct ph_colour colour;
  double width;
  struct ph_dash dash;
};

/* ph_page_svg_begin: the document, with its title and description. */
void ph_page_svg_begin(struct ph_page_svg *svg, const struct ph_page_head *head,
                       struct ph_buf *out);

/* ph_page_svg_end: ret  PH_OK | PH_E_NO_MEMORY */
enum ph_status ph_page_svg_end(struct ph_page_svg *svg, struct ph_diag *diag);

/* ph_page_svg_group: elements of a class from here to the end of it (NULL). */
void ph_page_svg_group(struct ph_page_svg *svg, const char *name);

/* ph_page_svg_path: a command, and up to three spots. */
void ph_page_svg_path(struct ph_page_svg *svg, char command,
                      const struct ph_spot *spots, size_t n);

void ph_page_svg_circle(struct ph_page_svg *svg, struct ph_spot center,
                        double radius);

/* ph_page_svg_draw: the path is an element, and a new one begins. */
void ph_page_svg_draw(struct ph_page_svg *svg, bool fill, bool stroke);

void ph_page_svg_text(struct ph_page_svg *svg, struct ph_spot at, double size,
                      double align, bool up, const char *text);

#endif
