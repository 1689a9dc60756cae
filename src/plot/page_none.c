/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What there is of pages without cairo (see page.h): the news that there are
 * none. */
#include "plot/page.h"

#ifndef PH_CAIRO

enum ph_status ph_page_can(struct ph_diag *diag) {
  return ph_fail(diag, PH_E_USAGE, NULL,
                 "this phspline was built without cairo: install libcairo2-dev "
                 "(Debian, Ubuntu), cairo-devel (Fedora) or cairo (elsewhere) "
                 "and build it again");
}

enum ph_status ph_page_begin(const struct ph_page_head *head,
                             struct ph_buf *out, struct ph_page **page,
                             struct ph_diag *diag) {
  (void)head, (void)out;
  *page = NULL;
  return ph_page_can(diag);
}

/* There is no page: nothing of what follows is ever called. */
enum ph_status ph_page_end(struct ph_page *page, struct ph_diag *diag) {
  (void)page, (void)diag;
  return PH_OK;
}

void ph_page_pen(struct ph_page *page, struct ph_colour colour, double width,
                 double dash) {
  (void)page, (void)colour, (void)width, (void)dash;
}

void ph_page_dash(struct ph_page *page, const struct ph_dash *dash) {
  (void)page, (void)dash;
}

void ph_page_group(struct ph_page *page, const char *name) {
  (void)page, (void)name;
}

void ph_page_move(struct ph_page *page, struct ph_spot to) {
  (void)page, (void)to;
}

void ph_page_line(struct ph_page *page, struct ph_spot to) {
  (void)page, (void)to;
}

void ph_page_curve(struct ph_page *page, const struct ph_spot spots[3]) {
  (void)page, (void)spots;
}

void ph_page_circle(struct ph_page *page, struct ph_spot center,
                    double radius) {
  (void)page, (void)center, (void)radius;
}

void ph_page_rect(struct ph_page *page, const struct ph_rect *rect) {
  (void)page, (void)rect;
}

void ph_page_close(struct ph_page *page) {
  (void)page;
}

void ph_page_stroke(struct ph_page *page) {
  (void)page;
}

void ph_page_fill(struct ph_page *page) {
  (void)page;
}

void ph_page_paint(struct ph_page *page) {
  (void)page;
}

double ph_page_text_width(struct ph_page *page, double size, const char *text) {
  (void)page, (void)size, (void)text;
  return 0;
}

void ph_page_text(struct ph_page *page, struct ph_spot at, double size,
                  double align, bool up, const char *text) {
  (void)page, (void)at, (void)size, (void)align, (void)up, (void)text;
}

#endif
