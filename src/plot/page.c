/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A page to draw on (see page.h): all that knows cairo. */
#include "plot/page.h"

#include "base/mem.h"
#include "plot/page_svg.h"

#ifdef PH_CAIRO

#include <cairo-pdf.h>
#include <cairo.h>
#include <math.h>

struct ph_page {
  enum ph_figure_format format;
  struct ph_buf *out;
  struct ph_page_svg svg; /* of that format; cairo only measures letters */
  cairo_surface_t *surface;
  cairo_t *cairo;
  double size; /* of the letters that are set */
};

bool ph_page_can(void) {
  return true;
}

static bool is_svg(const struct ph_page *page) {
  return page->format == PH_FIGURE_SVG;
}

static cairo_status_t append(void *closure, const unsigned char *bytes,
                             unsigned n) {
  struct ph_buf *out = closure;
  ph_buf_put(out, (const char *)bytes, n);
  return out->failed ? CAIRO_STATUS_WRITE_ERROR : CAIRO_STATUS_SUCCESS;
}

static cairo_surface_t *surface_of(const struct ph_page_head *head,
                                   struct ph_buf *out) {
  cairo_surface_t *surface;
  switch (head->format) {
  case PH_FIGURE_SVG:
    return cairo_image_surface_create(CAIRO_FORMAT_A8, 1, 1);
  case PH_FIGURE_PDF:
    surface = cairo_pdf_surface_create_for_stream(append, out, head->width,
                                                  head->height);
#if CAIRO_VERSION >= CAIRO_VERSION_ENCODE(1, 16, 0)
    /* any but the time of day, or no two files would be the same */
    cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATE_DATE,
                                   "2000-01-01T00:00:00Z");
    if (head->title) {
      cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_TITLE,
                                     head->title);
    }
#endif
    return surface;
  default:
    return cairo_image_surface_create(CAIRO_FORMAT_RGB24,
                                      (int)lround(head->width),
                                      (int)lround(head->height));
  }
}

static enum ph_status failure(cairo_status_t status, const struct ph_buf *out,
                              struct ph_diag *diag) {
  if (status == CAIRO_STATUS_SUCCESS) {
    return PH_OK;
  }
  return status == CAIRO_STATUS_NO_MEMORY || out->failed
             ? ph_fail_memory(diag)
             : ph_fail(diag, PH_E_INTERNAL, NULL, "cairo cannot draw: %s",
                       cairo_status_to_string(status));
}

/* The same letters in files of every format: no hints of the screen. */
static void set_letters(cairo_t *cairo) {
  cairo_font_options_t *options = cairo_font_options_create();
  cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
  cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
  cairo_set_font_options(cairo, options);
  cairo_font_options_destroy(options);
  cairo_select_font_face(cairo, "sans-serif", CAIRO_FONT_SLANT_NORMAL,
                         CAIRO_FONT_WEIGHT_NORMAL);
}

enum ph_status ph_page_begin(const struct ph_page_head *head,
                             struct ph_buf *out, struct ph_page **page,
                             struct ph_diag *diag) {
  struct ph_page *p = ph_malloc(sizeof *p);
  const struct ph_rect all = {0, 0, head->width, head->height};
  *page = NULL;
  if (!p) {
    return ph_fail_memory(diag);
  }
  *p = (struct ph_page){.format = head->format, .out = out};
  p->surface = surface_of(head, out);
  p->cairo = cairo_create(p->surface);
  if (cairo_status(p->cairo) != CAIRO_STATUS_SUCCESS) {
    return ph_page_end(p, diag);
  }
  if (is_svg(p)) {
    ph_page_svg_begin(&p->svg, head, out);
  }
  set_letters(p->cairo);
  cairo_set_line_join(p->cairo, CAIRO_LINE_JOIN_ROUND);
  cairo_set_tolerance(p->cairo, 0.05);
  ph_page_pen(p, ph_ink(PH_INK_PAPER), 1, 0);
  ph_page_rect(p, &all);
  ph_page_fill(p);
  *page = p;
  return PH_OK;
}

enum ph_status ph_page_end(struct ph_page *page, struct ph_diag *diag) {
  enum ph_status status;
  cairo_status_t worst;
  cairo_show_page(page->cairo);
  worst = cairo_status(page->cairo);
  cairo_destroy(page->cairo);
  if (worst == CAIRO_STATUS_SUCCESS && page->format == PH_FIGURE_PNG) {
    worst = cairo_surface_write_to_png_stream(page->surface, append, page->out);
  }
  cairo_surface_finish(page->surface);
  if (worst == CAIRO_STATUS_SUCCESS) {
    worst = cairo_surface_status(page->surface);
  }
  cairo_surface_destroy(page->surface);
  status = failure(worst, page->out, diag);
  if (is_svg(page) && page->svg.out) {
    const enum ph_status written = ph_page_svg_end(&page->svg, diag);
    status = status == PH_OK ? written : status;
  }
  ph_free(page);
  return status;
}

void ph_page_dash(struct ph_page *page, const struct ph_dash *dash) {
  if (is_svg(page)) {
    page->svg.dash = *dash;
  } else {
    cairo_set_dash(page->cairo, dash->length, (int)dash->n, dash->phase);
  }
}

void ph_page_pen(struct ph_page *page, struct ph_colour colour, double width,
                 double dash) {
  const struct ph_dash dashes = {dash > 0 ? 2 : 0, {dash, 0.75 * dash}, 0};
  page->svg.colour = colour;
  page->svg.width = width;
  cairo_set_source_rgb(page->cairo, colour.r, colour.g, colour.b);
  cairo_set_line_width(page->cairo, width);
  ph_page_dash(page, &dashes);
}

void ph_page_group(struct ph_page *page, const char *name) {
  if (is_svg(page)) {
    ph_page_svg_group(&page->svg, name);
  }
}

void ph_page_move(struct ph_page *page, struct ph_spot to) {
  if (is_svg(page)) {
    ph_page_svg_path(&page->svg, 'M', &to, 1);
  } else {
    cairo_move_to(page->cairo, to.x, to.y);
  }
}

void ph_page_line(struct ph_page *page, struct ph_spot to) {
  if (is_svg(page)) {
    ph_page_svg_path(&page->svg, 'L', &to, 1);
  } else {
    cairo_line_to(page->cairo, to.x, to.y);
  }
}

void ph_page_curve(struct ph_page *page, const struct ph_spot spots[3]) {
  if (is_svg(page)) {
    ph_page_svg_path(&page->svg, 'C', spots, 3);
  } else {
    cairo_curve_to(page->cairo, spots[0].x, spots[0].y, spots[1].x, spots[1].y,
                   spots[2].x, spots[2].y);
  }
}

void ph_page_circle(struct ph_page *page, struct ph_spot center,
                    double radius) {
  if (is_svg(page)) {
    ph_page_svg_circle(&page->svg, center, radius);
  } else {
    cairo_new_sub_path(page->cairo);
    cairo_arc(page->cairo, center.x, center.y, radius, 0, 2 * acos(-1));
    cairo_close_path(page->cairo);
  }
}

void ph_page_rect(struct ph_page *page, const struct ph_rect *rect) {
  const struct ph_spot corners[4] = {{rect->x, rect->y},
                                     {rect->x + rect->w, rect->y},
                                     {rect->x + rect->w, rect->y + rect->h},
                                     {rect->x, rect->y + rect->h}};
  ph_page_move(page, corners[0]);
  for (int i = 1; i < 4; i++) {
    ph_page_line(page, corners[i]);
  }
  ph_page_close(page);
}

void ph_page_close(struct ph_page *page) {
  if (is_svg(page)) {
    ph_page_svg_path(&page->svg, 'Z', NULL, 0);
  } else {
    cairo_close_path(page->cairo);
  }
}

void ph_page_stroke(struct ph_page *page) {
  if (is_svg(page)) {
    ph_page_svg_draw(&page->svg, false, true);
  } else {
    cairo_stroke(page->cairo);
  }
}

void ph_page_fill(struct ph_page *page) {
  if (is_svg(page)) {
    ph_page_svg_draw(&page->svg, true, false);
  } else {
    cairo_fill(page->cairo);
  }
}

void ph_page_paint(struct ph_page *page) {
  if (is_svg(page)) {
    ph_page_svg_draw(&page->svg, true, true);
  } else {
    cairo_fill_preserve(page->cairo);
    cairo_stroke(page->cairo);
  }
}

static void set_size(struct ph_page *page, double size) {
  if (!(fabs(page->size - size) <= 0)) {
    page->size = size;
    cairo_set_font_size(page->cairo, size);
  }
}

double ph_page_text_width(struct ph_page *page, double size, const char *text) {
  cairo_text_extents_t extents;
  set_size(page, size);
  cairo_text_extents(page->cairo, text, &extents);
  return extents.x_advance;
}

void ph_page_text(struct ph_page *page, struct ph_spot at, double size,
                  double align, bool up, const char *text) {
  double before;
  if (is_svg(page)) {
    ph_page_svg_text(&page->svg, at, size, align, up, text);
    return;
  }
  before = align * ph_page_text_width(page, size, text);
  cairo_save(page->cairo);
  cairo_set_source_rgb(page->cairo, ph_ink(PH_INK_TEXT).r,
                       ph_ink(PH_INK_TEXT).g, ph_ink(PH_INK_TEXT).b);
  cairo_translate(page->cairo, at.x, at.y);
  if (up) {
    cairo_rotate(page->cairo, -0.5 * acos(-1));
  }
  cairo_move_to(page->cairo, -before, 0);
  cairo_show_text(page->cairo, text);
  cairo_restore(page->cairo);
  cairo_new_path(page->cairo);
}

#endif
