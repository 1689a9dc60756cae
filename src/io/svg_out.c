/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SVG paths and drawings (see svg_out.h). */
#include "io/svg_out.h"

#include "base/relay.h"
#include "base/suggest.h"
#include "io/number.h"

#include <string.h>

/* x,y after what separates it from what comes before. */
static void point(struct ph_buf *buf, char before, const double *p) {
  char *to = ph_buf_reserve(buf, 2 * PH_NUMBER_MAX + 2);
  if (to) {
    char *at = to;
    *at++ = before;
    at += ph_number_write(at, p[0]);
    *at++ = ',';
    at += ph_number_write(at, p[1]);
    buf->n += (size_t)(at - to);
  }
}

/* Whether two points are the same to the last bit. */
static bool same(const double *a, const double *b) {
  return !(a[0] < b[0]) && !(a[0] > b[0]) && !(a[1] < b[1]) && !(a[1] > b[1]);
}

struct path {
  const struct ph_pieces *cubics;
  bool closed;
};

/* Whether cubic i begins a subpath, and where the one begins that it is of. */
static bool begins(const struct ph_pieces *cubics, size_t i) {
  const double *p = cubics->control_points + 8 * i;
  return i == 0 || i == cubics->n || !same(p - 2, p);
}

static const double *beginning(const struct ph_pieces *cubics, size_t i) {
  while (!begins(cubics, i)) {
    i--;
  }
  return cubics->control_points + 8 * i;
}

static void some_cubics(void *context, struct ph_buf *to, size_t first,
                        size_t end) {
  const struct path *path = context;
  const struct ph_pieces *cubics = path->cubics;
  const double *p = cubics->control_points + 8 * first;
  for (size_t i = first; i < end; i++, p += 8) {
    if (begins(cubics, i)) {
      point(to, 'M', p);
    }
    point(to, 'C', p + 2);
    point(to, ' ', p + 4);
    point(to, ' ', p + 6);
    if (path->closed && begins(cubics, i + 1) &&
        same(p + 6, beginning(cubics, i))) {
      ph_buf_put(to, "Z", 1);
    }
  }
}

void ph_svg_path(struct ph_buf *buf, const struct ph_pieces *cubics,
                 bool closed) {
  struct path path = {cubics, closed};
  ph_relay(buf, cubics->n, some_cubics, &path);
}

/* ---- drawings ---------------------------------------------------------- */

/* So much of the size of what is drawn is around it. */
static const double MARGIN = 0.02;

/* How wide lines are, of the same: many programs scale lines with a drawing
 * whatever it says; and dashes, of this width. */
static const double STROKE = 0x1p-9;
enum { DASH = 4 };

void ph_svg_join(double box[4], const double other[4]) {
  for (size_t k = 0; k < 2; k++) {
    box[k] = fmin(box[k], other[k]);
    box[2 + k] = fmax(box[2 + k], other[2 + k]);
  }
}

static void number(struct ph_buf *buf, double x) {
  char *to = ph_buf_reserve(buf, PH_NUMBER_MAX);
  if (to) {
    buf->n += ph_number_write(to, x);
  }
}

/* A text in an attribute. */
static void text(struct ph_buf *buf, const char *p) {
  static const char special[] = "&<>\"";
  static const char *const names[] = {"&amp;", "&lt;", "&gt;", "&quot;"};
  const char *end = p + strlen(p);
  while (p < end) {
    const char *found = strchr(special, *p);
    size_t n = ph_shown_length(p, end);
    if (found) {
      ph_buf_puts(buf, names[found - special]);
    } else {
      ph_buf_put(buf, n == 0 || *p == ' ' ? "_" : p, n ? n : 1);
    }
    p += n ? n : 1;
  }
}

void ph_svg_name_put(struct ph_buf *buf, const struct ph_svg_name *name) {
  text(buf, name->id);
  for (size_t i = 0; i < name->swept_n; i++) {
    ph_buf_puts(buf, i > 0 ? "," : ":");
    text(buf, name->swept[i].name);
    ph_buf_puts(buf, "=");
    text(buf, name->swept[i].value);
  }
  if (name->distance) {
    ph_buf_puts(buf, "@");
    number(buf, *name->distance);
  }
  if (name->rulings) {
    ph_buf_puts(buf, "/rulings");
  }
}

void ph_svg_element(struct ph_buf *buf, const struct ph_svg_name *name,
                    const struct ph_pieces *cubics, bool closed, bool up,
                    double box[4]) {
  static const char *const classes[2][2] = {
      {"\"", "\" class=\"offset\""},
      {"\" class=\"ruling\"", "\" class=\"offset ruling\""}};
  const double *p = cubics->control_points;
  if (cubics->n == 0) {
    return;
  }
  for (size_t i = 0; i < 4 * cubics->n; i++, p += 2) {
    const double y = up ? -p[1] : p[1];
    ph_svg_join(box, (double[]){p[0], y, p[0], y});
  }
  ph_buf_puts(buf, "<path id=\"");
  ph_svg_name_put(buf, name);
  ph_buf_puts(buf, classes[name->rulings][!!name->distance]);
  ph_buf_puts(buf, up ? " transform=\"scale(1,-1)\" d=\"" : " d=\"");
  ph_svg_path(buf, cubics, closed);
  ph_buf_puts(buf, "\"/>\n");
}

/* A length of the page, in millimetres. */
static void extent(struct ph_buf *buf, const char *name, double x) {
  ph_buf_puts(buf, name);
  number(buf, x);
  ph_buf_puts(buf, "mm\"");
}

void ph_svg_header(struct ph_buf *buf, const double box[4], double unit) {
  const bool nothing = !(box[0] <= box[2]);
  const double width = nothing ? 1 : box[2] - box[0];
  const double height = nothing ? 1 : box[3] - box[1];
  const double size = fmax(width, height) > 0 ? fmax(width, height) : 1;
  const double view[4] = {nothing ? 0 : box[0] - MARGIN * size,
                          nothing ? 0 : box[1] - MARGIN * size,
                          width + 2 * MARGIN * size,
                          height + 2 * MARGIN * size};
  ph_buf_puts(buf, "<svg xmlns=\"http://www.w3.org/2000/svg\"");
  if (unit > 0) {
    extent(buf, " width=\"", unit * view[2]);
    extent(buf, " height=\"", unit * view[3]);
  }
  ph_buf_puts(buf, " viewBox=\"");
  for (size_t k = 0; k < 4; k++) {
    ph_buf_puts(buf, k > 0 ? " " : "");
    number(buf, view[k]);
  }
  ph_buf_puts(buf, "\">\n<style>path { fill: none; stroke: black; "
                   "stroke-width: ");
  number(buf, STROKE * size);
  ph_buf_puts(buf, " }\n.offset { stroke: gray }\n"
                   ".ruling { stroke-dasharray: ");
  number(buf, DASH * STROKE * size);
  ph_buf_puts(buf, " }</style>\n");
}

void ph_svg_footer(struct ph_buf *buf) {
  ph_buf_puts(buf, "</svg>\n");
}
