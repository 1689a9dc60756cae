/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A page to draw on (see page.h): all that knows cairo, which is loaded when it
 * is needed where PH_CAIRO_NAME says what the shared library is called. */
#include "plot/page.h"

#include "base/library.h"
#include "base/mem.h"
#include "plot/page_svg.h"

#ifdef PH_CAIRO

#include <cairo-pdf.h>
#include <cairo.h>
#include <math.h>

/* ---- the library --------------------------------------------------------- */

/* What is used of it. */
#if CAIRO_VERSION >= CAIRO_VERSION_ENCODE(1, 16, 0)
#define METADATA(X) X(cairo_pdf_surface_set_metadata)
#else
#define METADATA(X)
#endif
#define CAIRO(X)                         \
  X(cairo_arc)                           \
  X(cairo_close_path)                    \
  X(cairo_create)                        \
  X(cairo_curve_to)                      \
  X(cairo_destroy)                       \
  X(cairo_fill)                          \
  X(cairo_fill_preserve)                 \
  X(cairo_font_options_create)           \
  X(cairo_font_options_destroy)          \
  X(cairo_font_options_set_antialias)    \
  X(cairo_font_options_set_hint_metrics) \
  X(cairo_font_options_set_hint_style)   \
  X(cairo_image_surface_create)          \
  X(cairo_line_to)                       \
  X(cairo_move_to)                       \
  X(cairo_new_path)                      \
  X(cairo_new_sub_path)                  \
  X(cairo_pdf_surface_create_for_stream) \
  METADATA(X)                            \
  X(cairo_restore)                       \
  X(cairo_rotate)                        \
  X(cairo_save)                          \
  X(cairo_select_font_face)              \
  X(cairo_set_dash)                      \
  X(cairo_set_font_options)              \
  X(cairo_set_font_size)                 \
  X(cairo_set_line_join)                 \
  X(cairo_set_line_width)                \
  X(cairo_set_source_rgb)                \
  X(cairo_set_tolerance)                 \
  X(cairo_show_page)                     \
  X(cairo_show_text)                     \
  X(cairo_status)                        \
  X(cairo_status_to_string)              \
  X(cairo_stroke)                        \
  X(cairo_surface_destroy)               \
  X(cairo_surface_finish)                \
  X(cairo_surface_status)                \
  X(cairo_surface_write_to_png_stream)   \
  X(cairo_text_extents)                  \
  X(cairo_translate)

/* Where each of them is. */
struct cairo {
  CAIRO(PH_LIBRARY_MEMBER)
};

#ifdef PH_CAIRO_NAME

static enum ph_status load_cairo(struct cairo *cairo, struct ph_diag *diag) {
#define SYMBOL(name) {#name, offsetof(struct cairo, name)},
  static const struct ph_library_symbol symbols[] = {CAIRO(SYMBOL)};
#undef SYMBOL
  const char *why;
  return ph_library_load(PH_CAIRO_NAME, symbols,
                         sizeof symbols / sizeof symbols[0], cairo, &why)
             ? PH_OK
             : ph_fail(diag, PH_E_USAGE, NULL,
                       "figures need the library cairo: %s", why);
}

#else

static enum ph_status load_cairo(struct cairo *cairo, struct ph_diag *diag) {
  (void)diag;
#define ADDRESS(name) cairo->name = &(name);
  CAIRO(ADDRESS)
#undef ADDRESS
  return PH_OK;
}

#endif

enum ph_status ph_page_can(struct ph_diag *diag) {
  struct cairo cairo;
  return load_cairo(&cairo, diag);
}

/* ---- the page ------------------------------------------------------------ */

struct ph_page {
  enum ph_figure_format format;
  struct ph_buf *out;
  struct ph_page_svg svg; /* of that format; cairo only measures letters */
  struct cairo lib;
  cairo_surface_t *surface;
  cairo_t *cairo;
  double size; /* of the letters that are set */
};

static bool is_svg(const struct ph_page *page) {
  return page->format == PH_FIGURE_SVG;
}

static cairo_status_t append(void *closure, const unsigned char *bytes,
                             unsigned n) {
  struct ph_buf *out = closure;
  ph_buf_put(out, (const char *)bytes, n);
  return out->failed ? CAIRO_STATUS_WRITE_ERROR : CAIRO_STATUS_SUCCESS;
}

static cairo_surface_t *surface_of(const struct cairo *lib,
                                   const struct ph_page_head *head,
                                   struct ph_buf *out) {
  cairo_surface_t *surface;
  switch (head->format) {
  case PH_FIGURE_SVG:
    return lib->cairo_image_surface_create(CAIRO_FORMAT_A8, 1, 1);
  case PH_FIGURE_PDF:
    surface = lib->cairo_pdf_surface_create_for_stream(append, out, head->width,
                                                       head->height);
#if CAIRO_VERSION >= CAIRO_VERSION_ENCODE(1, 16, 0)
    /* any but the time of day, or no two files would be the same */
    lib->cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATE_DATE,
                                        "2000-01-01T00:00:00Z");
    if (head->title) {
      lib->cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_TITLE,
                                          head->title);
    }
#endif
    return surface;
  default:
    return lib->cairo_image_surface_create(CAIRO_FORMAT_RGB24,
                                           (int)lround(head->width),
                                           (int)lround(head->height));
  }
}

static enum ph_status failure(const struct ph_page *page, cairo_status_t status,
                              struct ph_diag *diag) {
  if (status == CAIRO_STATUS_SUCCESS) {
    return PH_OK;
  }
  return status == CAIRO_STATUS_NO_MEMORY || page->out->failed
             ? ph_fail_memory(diag)
             : ph_fail(diag, PH_E_INTERNAL, NULL, "cairo cannot draw: %s",
                       page->lib.cairo_status_to_string(status));
}

/* The same letters in files of every format: no hints of the screen. */
static void set_letters(const struct cairo *lib, cairo_t *cairo) {
  cairo_font_options_t *options = lib->cairo_font_options_create();
  lib->cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
  lib->cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
  lib->cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
  lib->cairo_set_font_options(cairo, options);
  lib->cairo_font_options_destroy(options);
  lib->cairo_select_font_face(cairo, "sans-serif", CAIRO_FONT_SLANT_NORMAL,
                              CAIRO_FONT_WEIGHT_NORMAL);
}

enum ph_status ph_page_begin(const struct ph_page_head *head,
                             struct ph_buf *out, struct ph_page **page,
                             struct ph_diag *diag) {
  struct ph_page *p = ph_malloc(sizeof *p);
  enum ph_status status;
  const struct ph_rect all = {0, 0, head->width, head->height};
  *page = NULL;
  if (!p) {
    return ph_fail_memory(diag);
  }
  *p = (struct ph_page){.format = head->format, .out = out};
  status = load_cairo(&p->lib, diag);
  if (status != PH_OK) {
    ph_free(p);
    return status;
  }
  p->surface = surface_of(&p->lib, head, out);
  p->cairo = p->lib.cairo_create(p->surface);
  if (p->lib.cairo_status(p->cairo) != CAIRO_STATUS_SUCCESS) {
    return ph_page_end(p, diag);
  }
  if (is_svg(p)) {
    ph_page_svg_begin(&p->svg, head, out);
  }
  set_letters(&p->lib, p->cairo);
  p->lib.cairo_set_line_join(p->cairo, CAIRO_LINE_JOIN_ROUND);
  p->lib.cairo_set_tolerance(p->cairo, 0.05);
  ph_page_pen(p, ph_ink(PH_INK_PAPER), 1, 0);
  ph_page_rect(p, &all);
  ph_page_fill(p);
  *page = p;
  return PH_OK;
}

enum ph_status ph_page_end(struct ph_page *page, struct ph_diag *diag) {
  enum ph_status status;
  cairo_status_t worst;
  page->lib.cairo_show_page(page->cairo);
  worst = page->lib.cairo_status(page->cairo);
  page->lib.cairo_destroy(page->cairo);
  if (worst == CAIRO_STATUS_SUCCESS && page->format == PH_FIGURE_PNG) {
    worst = page->lib.cairo_surface_write_to_png_stream(page->surface, append,
                                                        page->out);
  }
  page->lib.cairo_surface_finish(page->surface);
  if (worst == CAIRO_STATUS_SUCCESS) {
    worst = page->lib.cairo_surface_status(page->surface);
  }
  page->lib.cairo_surface_destroy(page->surface);
  status = failure(page, worst, diag);
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
    page->lib.cairo_set_dash(page->cairo, dash->length, (int)dash->n,
                             dash->phase);
  }
}

void ph_page_pen(struct ph_page *page, struct ph_colour colour, double width,
                 double dash) {
  const struct ph_dash dashes = {dash > 0 ? 2 : 0, {dash, 0.75 * dash}, 0};
  page->svg.colour = colour;
  page->svg.width = width;
  page->lib.cairo_set_source_rgb(page->cairo, colour.r, colour.g, colour.b);
  page->lib.cairo_set_line_width(page->cairo, width);
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
    page->lib.cairo_move_to(page->cairo, to.x, to.y);
  }
}

void ph_page_line(struct ph_page *page, struct ph_spot to) {
  if (is_svg(page)) {
    ph_page_svg_path(&page->svg, 'L', &to, 1);
  } else {
    page->lib.cairo_line_to(page->cairo, to.x, to.y);
  }
}

void ph_page_curve(struct ph_page *page, const struct ph_spot spots[3]) {
  if (is_svg(page)) {
    ph_page_svg_path(&page->svg, 'C', spots, 3);
  } else {
    page->lib.cairo_curve_to(page->cairo, spots[0].x, spots[0].y, spots[1].x,
                             spots[1].y, spots[2].x, spots[2].y);
  }
}

void ph_page_circle(struct ph_page *page, struct ph_spot center,
                    double radius) {
  if (is_svg(page)) {
    ph_page_svg_circle(&page->svg, center, radius);
  } else {
    page->lib.cairo_new_sub_path(page->cairo);
    page->lib.cairo_arc(page->cairo, center.x, center.y, radius, 0,
                        2 * acos(-1));
    page->lib.cairo_close_path(page->cairo);
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
    page->lib.cairo_close_path(page->cairo);
  }
}

void ph_page_stroke(struct ph_page *page) {
  if (is_svg(page)) {
    ph_page_svg_draw(&page->svg, false, true);
  } else {
    page->lib.cairo_stroke(page->cairo);
  }
}

void ph_page_fill(struct ph_page *page) {
  if (is_svg(page)) {
    ph_page_svg_draw(&page->svg, true, false);
  } else {
    page->lib.cairo_fill(page->cairo);
  }
}

void ph_page_paint(struct ph_page *page) {
  if (is_svg(page)) {
    ph_page_svg_draw(&page->svg, true, true);
  } else {
    page->lib.cairo_fill_preserve(page->cairo);
    page->lib.cairo_stroke(page->cairo);
  }
}

static void set_size(struct ph_page *page, double size) {
  if (!(fabs(page->size - size) <= 0)) {
    page->size = size;
    page->lib.cairo_set_font_size(page->cairo, size);
  }
}

double ph_page_text_width(struct ph_page *page, double size, const char *text) {
  cairo_text_extents_t extents;
  set_size(page, size);
  page->lib.cairo_text_extents(page->cairo, text, &extents);
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
  page->lib.cairo_save(page->cairo);
  page->lib.cairo_set_source_rgb(page->cairo, ph_ink(PH_INK_TEXT).r,
                                 ph_ink(PH_INK_TEXT).g, ph_ink(PH_INK_TEXT).b);
  page->lib.cairo_translate(page->cairo, at.x, at.y);
  if (up) {
    page->lib.cairo_rotate(page->cairo, -0.5 * acos(-1));
  }
  page->lib.cairo_move_to(page->cairo, -before, 0);
  page->lib.cairo_show_text(page->cairo, text);
  page->lib.cairo_restore(page->cairo);
  page->lib.cairo_new_path(page->cairo);
}

#endif
