/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A page as SVG (see page_svg.h). */
#include "plot/page_svg.h"

#include <math.h>
#include <string.h>

/* Coordinates are multiples of 1/1000, and no larger than cairo's limit. */
enum { DECIMALS = 3, COORDINATE_MAX = 100000, NUMBER_MAX = 16 };

/* ---- attributes ---------------------------------------------------------- */

/* A number with a few decimals, without zeros at its end. */
static void put_number(struct ph_buf *buf, double x, int decimals) {
  char text[NUMBER_MAX + 1];
  size_t at = NUMBER_MAX;
  const double most = COORDINATE_MAX;
  const double kept = isfinite(x) ? fmax(-most, fmin(most, x)) : 0;
  unsigned long left;
  bool shown = false;
  text[at] = '\0';
  left = (unsigned long)floor(fabs(kept) * pow(10, decimals) + 0.5);
  if (kept < 0 && left > 0) {
    ph_buf_puts(buf, "-");
  }
  for (int i = 0; i < decimals; i++, left /= 10) {
    const char digit = (char)('0' + left % 10);
    shown = shown || digit != '0';
    if (shown) {
      text[--at] = digit;
    }
  }
  if (shown) {
    text[--at] = '.';
  }
  do {
    text[--at] = (char)('0' + left % 10);
    left /= 10;
  } while (left > 0);
  ph_buf_puts(buf, text + at);
}

static void put(struct ph_buf *buf, const char *before, double x) {
  ph_buf_puts(buf, before);
  put_number(buf, x, DECIMALS);
}

static void put_colour(struct ph_buf *buf, const char *name,
                       struct ph_colour colour) {
  ph_buf_puts(buf, name);
  ph_buf_puts(buf, "=\"rgb(");
  put_number(buf, 100 * colour.r, 4);
  ph_buf_puts(buf, "%,");
  put_number(buf, 100 * colour.g, 4);
  ph_buf_puts(buf, "%,");
  put_number(buf, 100 * colour.b, 4);
  ph_buf_puts(buf, "%)\"");
}

/* UTF-8 text as XML has it. */
static void put_text(struct ph_buf *buf, const char *text) {
  for (; *text; text++) {
    switch (*text) {
    case '&':
      ph_buf_puts(buf, "&amp;");
      break;
    case '<':
      ph_buf_puts(buf, "&lt;");
      break;
    case '>':
      ph_buf_puts(buf, "&gt;");
      break;
    default:
      ph_buf_put(buf, text, 1);
    }
  }
}

static void put_element(struct ph_buf *buf, const char *name,
                        const char *text) {
  if (text && *text) {
    ph_buf_puts(buf, "<");
    ph_buf_puts(buf, name);
    ph_buf_puts(buf, ">");
    put_text(buf, text);
    ph_buf_puts(buf, "</");
    ph_buf_puts(buf, name);
    ph_buf_puts(buf, ">\n");
  }
}

/* ---- the document -------------------------------------------------------- */

void ph_page_svg_begin(struct ph_page_svg *svg, const struct ph_page_head *head,
                       struct ph_buf *out) {
  *svg = (struct ph_page_svg){.out = out};
  ph_buf_puts(out, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
                   "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\"");
  put(out, " width=\"", head->width);
  put(out, "pt\" height=\"", head->height);
  put(out, "pt\" viewBox=\"0 0 ", head->width);
  put(out, " ", head->height);
  ph_buf_puts(out, "\" font-family=\"sans-serif\" stroke-linejoin=\"round\" "
                   "stroke-miterlimit=\"10\">\n");
  put_element(out, "title", head->title);
  put_element(out, "desc", head->description);
}

enum ph_status ph_page_svg_end(struct ph_page_svg *svg, struct ph_diag *diag) {
  ph_buf_puts(svg->out, "</svg>\n");
  ph_buf_free(&svg->path);
  return svg->out->failed ? ph_fail_memory(diag) : PH_OK;
}

void ph_page_svg_group(struct ph_page_svg *svg, const char *name) {
  if (name) {
    ph_buf_puts(svg->out, "<g class=\"");
    ph_buf_puts(svg->out, name);
    ph_buf_puts(svg->out, "\">\n");
  } else {
    ph_buf_puts(svg->out, "</g>\n");
  }
}

/* ---- paths --------------------------------------------------------------- */

void ph_page_svg_path(struct ph_page_svg *svg, char command,
                      const struct ph_spot *spots, size_t n) {
  ph_buf_put(&svg->path, &command, 1);
  for (size_t i = 0; i < n; i++) {
    put(&svg->path, i > 0 ? " " : "", spots[i].x);
    put(&svg->path, ",", spots[i].y);
  }
}

void ph_page_svg_circle(struct ph_page_svg *svg, struct ph_spot center,
                        double radius) {
  const struct ph_spot from = {center.x - radius, center.y};
  ph_page_svg_path(svg, 'M', &from, 1);
  for (int i = 0; i < 2; i++) {
    put(&svg->path, "a", radius);
    put(&svg->path, ",", radius);
    put(&svg->path, " 0 0 0 ", i == 0 ? 2 * radius : -2 * radius);
    ph_buf_puts(&svg->path, ",0");
  }
  ph_buf_puts(&svg->path, "Z");
}

static void put_stroke(struct ph_page_svg *svg) {
  struct ph_buf *out = svg->out;
  put_colour(out, " stroke", svg->colour);
  put(out, " stroke-width=\"", svg->width);
  ph_buf_puts(out, "\"");
  for (size_t i = 0; i < svg->dash.n; i++) {
    put(out, i > 0 ? " " : " stroke-dasharray=\"", svg->dash.length[i]);
  }
  if (svg->dash.n > 0) {
    put(out, "\" stroke-dashoffset=\"", svg->dash.phase);
    ph_buf_puts(out, "\"");
  }
}

void ph_page_svg_draw(struct ph_page_svg *svg, bool fill, bool stroke) {
  struct ph_buf *out = svg->out;
  if (svg->path.n > 0) {
    ph_buf_puts(out, "<path");
    if (fill) {
      put_colour(out, " fill", svg->colour);
    } else {
      ph_buf_puts(out, " fill=\"none\"");
    }
    if (stroke) {
      put_stroke(svg);
    }
    ph_buf_puts(out, " d=\"");
    ph_buf_put(out, svg->path.data, svg->path.n);
    ph_buf_puts(out, "\"/>\n");
  }
  out->failed |= svg->path.failed;
  ph_buf_cut(&svg->path, 0, 1 << 16);
}

void ph_page_svg_text(struct ph_page_svg *svg, struct ph_spot at, double size,
                      double align, bool up, const char *text) {
  struct ph_buf *out = svg->out;
  put(out, "<text x=\"", at.x);
  put(out, "\" y=\"", at.y);
  put(out, "\" font-size=\"", size);
  ph_buf_puts(out, "\"");
  if (align > 0) {
    ph_buf_puts(out,
                align < 1 ? " text-anchor=\"middle\"" : " text-anchor=\"end\"");
  }
  if (up) {
    put(out, " transform=\"rotate(-90 ", at.x);
    put(out, " ", at.y);
    ph_buf_puts(out, ")\"");
  }
  put_colour(out, " fill", ph_ink(PH_INK_TEXT));
  ph_buf_puts(out, ">");
  put_text(out, text);
  ph_buf_puts(out, "</text>\n");
}
