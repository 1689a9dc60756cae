/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A page to draw on (see page.h): all that knows cairo. */
#include "plot/page.h"

#include "base/mem.h"

#ifdef PH_CAIRO

#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <cairo.h>
#include <math.h>
#include <string.h>

struct ph_page {
  enum ph_figure_format format;
  struct ph_buf *out;
  size_t start; /* of the file in out */
  cairo_surface_t *surface;
  cairo_t *cairo;
  double size; /* of the letters that are set */
};

bool ph_page_can(void) {
  return true;
}

static cairo_status_t append(void *closure, const unsigned char *bytes,
                             unsigned n) {
  struct ph_buf *out = closure;
  ph_buf_put(out, (const char *)bytes, n);
  return out->failed ? CAIRO_STATUS_WRITE_ERROR : CAIRO_STATUS_SUCCESS;
}

static cairo_surface_t *surface_of(enum ph_figure_format format, double width,
                                   double height, struct ph_buf *out) {
  cairo_surface_t *surface;
  switch (format) {
  case PH_FIGURE_SVG:
    surface = cairo_svg_surface_create_for_stream(append, out, width, height);
#if CAIRO_VERSION >= CAIRO_VERSION_ENCODE(1, 16, 0)
    cairo_svg_surface_set_document_unit(surface, CAIRO_SVG_UNIT_PT);
#endif
    return surface;
  case PH_FIGURE_PDF:
    surface = cairo_pdf_surface_create_for_stream(append, out, width, height);
#if CAIRO_VERSION >= CAIRO_VERSION_ENCODE(1, 16, 0)
    /* any but the time of day, or no two files would be the same */
    cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATE_DATE,
                                   "2000-01-01T00:00:00Z");
#endif
    return surface;
  default:
    return cairo_image_surface_create(CAIRO_FORMAT_RGB24, (int)lround(width),
                                      (int)lround(height));
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

enum ph_status ph_page_begin(enum ph_figure_format format, double width,
                             double height, struct ph_buf *out,
                             struct ph_page **page, struct ph_diag *diag) {
  struct ph_page *p = ph_malloc(sizeof *p);
  const struct ph_rect all = {0, 0, width, height};
  *page = NULL;
  if (!p) {
    return ph_fail_memory(diag);
  }
  *p = (struct ph_page){.format = format, .out = out, .start = out->n};
  p->surface = surface_of(format, width, height, out);
  p->cairo = cairo_create(p->surface);
  if (cairo_status(p->cairo) != CAIRO_STATUS_SUCCESS) {
    return ph_page_end(p, diag);
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

/* Surfaces of SVG are numbered through all the life of the process; nothing
 * refers to the number. */
static void forget_number(struct ph_buf *out, size_t start) {
  static const char id[] = "<g id=\"surface";
  const size_t n = sizeof id - 1;
  char *from = NULL, *to;
  for (size_t i = start; !from && i + n < out->n; i++) {
    if (memcmp(out->data + i, id, n) == 0) {
      from = out->data + i + n;
    }
  }
  if (!from) {
    return;
  }
  for (to = from; to < out->data + out->n && *to >= '0' && *to <= '9';) {
    to++;
  }
  memmove(from, to, (size_t)(out->data + out->n - to));
  out->n -= (size_t)(to - from);
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
  if (status == PH_OK && page->format == PH_FIGURE_SVG) {
    forget_number(page->out, page->start);
  }
  ph_free(page);
  return status;
}

void ph_page_pen(struct ph_page *page, struct ph_colour colour, double width,
                 double dash) {
  const double dashes[2] = {dash, 0.75 * dash};
  cairo_set_source_rgb(page->cairo, colour.r, colour.g, colour.b);
  cairo_set_line_width(page->cairo, width);
  cairo_set_dash(page->cairo, dashes, dash > 0 ? 2 : 0, 0);
}

void ph_page_move(struct ph_page *page, struct ph_spot to) {
  cairo_move_to(page->cairo, to.x, to.y);
}

void ph_page_line(struct ph_page *page, struct ph_spot to) {
  cairo_line_to(page->cairo, to.x, to.y);
}

void ph_page_circle(struct ph_page *page, struct ph_spot center,
                    double radius) {
  cairo_new_sub_path(page->cairo);
  cairo_arc(page->cairo, center.x, center.y, radius, 0, 2 * acos(-1));
  cairo_close_path(page->cairo);
}

void ph_page_rect(struct ph_page *page, const struct ph_rect *rect) {
  cairo_rectangle(page->cairo, rect->x, rect->y, rect->w, rect->h);
}

void ph_page_close(struct ph_page *page) {
  cairo_close_path(page->cairo);
}

void ph_page_stroke(struct ph_page *page) {
  cairo_stroke(page->cairo);
}

void ph_page_fill(struct ph_page *page) {
  cairo_fill(page->cairo);
}

void ph_page_paint(struct ph_page *page) {
  cairo_fill_preserve(page->cairo);
  cairo_stroke(page->cairo);
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
  double before = align * ph_page_text_width(page, size, text);
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
