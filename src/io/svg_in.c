/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Shapes of SVG (see xml_in.h). */
#include "io/xml_in.h"

#include "base/suggest.h"
#include "io/number.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* An element that is read. */
struct shape {
  struct ph_xml_in *xml;
  const char *const *attributes;
  struct ph_trace *trace;
};

/* ---- numbers --------------------------------------------------------------
 */

static const char *skip(const char *p, bool comma) {
  while (*p && (strchr(" \t\r\n", *p) || (comma && *p == ','))) {
    comma = comma && *p != ',';
    p++;
  }
  return p;
}

static enum ph_status fail(struct shape *s, const char *name,
                           const char *value) {
  char excerpt[PH_EXCERPT_MAX];
  return ph_fail(&s->xml->diag, PH_E_BAD_VALUE, name,
                 "is \"%s\"; a number without unit is read",
                 ph_excerpt(value, strlen(value), excerpt));
}

/* A length in the unit of the user: a number, or one in px; absent: unset. */
static enum ph_status length(struct shape *s, const char *name, double unset,
                             double *x) {
  const char *value = ph_xml_attribute(s->attributes, name), *p;
  *x = unset;
  if (!value) {
    return PH_OK;
  }
  p = skip(value, false);
  p = ph_number_read_text(p, p + strlen(p), x);
  if (p && strncmp(p, "px", 2) == 0) {
    p += 2;
  }
  return p && !*skip(p, false) && isfinite(*x) ? PH_OK : fail(s, name, value);
}

/* Lengths that are 0 where they are absent. */
static enum ph_status lengths(struct shape *s, const char *const *names,
                              size_t n, double *x) {
  enum ph_status status = PH_OK;
  for (size_t i = 0; status == PH_OK && i < n; i++) {
    status = length(s, names[i], 0, &x[i]);
  }
  return status;
}

/* ---- transformations ------------------------------------------------------
 */

/* a = a b: b is done first. */
static void compose(double a[6], const double b[6]) {
  const double c[6] = {
      a[0] * b[0] + a[2] * b[1],        a[1] * b[0] + a[3] * b[1],
      a[0] * b[2] + a[2] * b[3],        a[1] * b[2] + a[3] * b[3],
      a[0] * b[4] + a[2] * b[5] + a[4], a[1] * b[4] + a[3] * b[5] + a[5]};
  memcpy(a, c, sizeof c);
}

/* Sine and cosine of degrees, exact where they are 0 or 1. */
static void turn(double degrees, double *c, double *s) {
  const double quarters = degrees / 90, pi = acos(-1);
  *c = cos(degrees * (pi / 180));
  *s = sin(degrees * (pi / 180));
  if (!(floor(quarters) < quarters)) {
    *c = floor(*c + 0.5);
    *s = floor(*s + 0.5);
  }
}

/* One function with n arguments; false: there is none such. */
static bool function(const char *name, size_t name_n, const double *x, size_t n,
                     double a[6]) {
  static const char *const names[] = {"matrix", "translate", "scale",
                                      "rotate", "skewX",     "skewY"};
  const double radian = acos(-1) / 180;
  double c, s;
  size_t k = 0;
  while (k < 6 &&
         (strlen(names[k]) != name_n || memcmp(names[k], name, name_n) != 0)) {
    k++;
  }
  if (k == 0 && n == 6) {
    compose(a, x);
  } else if (k == 1 && (n == 1 || n == 2)) {
    compose(a, (double[]){1, 0, 0, 1, x[0], n > 1 ? x[1] : 0});
  } else if (k == 2 && (n == 1 || n == 2)) {
    compose(a, (double[]){x[0], 0, 0, n > 1 ? x[1] : x[0], 0, 0});
  } else if (k == 3 && (n == 1 || n == 3)) {
    turn(x[0], &c, &s);
    compose(a, (double[]){1, 0, 0, 1, n > 1 ? x[1] : 0, n > 1 ? x[2] : 0});
    compose(a, (double[]){c, s, -s, c, 0, 0});
    compose(a, (double[]){1, 0, 0, 1, n > 1 ? -x[1] : 0, n > 1 ? -x[2] : 0});
  } else if (k == 4 && n == 1) {
    compose(a, (double[]){1, 0, tan(x[0] * radian), 1, 0, 0});
  } else if (k == 5 && n == 1) {
    compose(a, (double[]){1, tan(x[0] * radian), 0, 1, 0, 0});
  } else {
    return false;
  }
  return true;
}

/* A list of functions; false: it is none. */
static bool transform(const char *p, double a[6]) {
  for (p = skip(p, false); *p; p = skip(p, true)) {
    const char *name = p;
    double x[6];
    size_t n = 0, name_n = strspn(p, "abcdefghijklmnopqrstuvwxyzXY");
    p = skip(p + name_n, false);
    if (*p++ != '(') {
      return false;
    }
    for (p = skip(p, false); *p && *p != ')'; p = skip(p, true)) {
      const char *after =
          n < 6 ? ph_number_read_text(p, p + strlen(p), &x[n]) : NULL;
      if (!after || !isfinite(x[n])) {
        return false;
      }
      p = after;
      n++;
    }
    if (*p != ')' || !function(name, name_n, x, n, a)) {
      return false;
    }
    p++;
  }
  return true;
}

/* ---- shapes ---------------------------------------------------------------
 */

static enum ph_status draw_path(struct shape *s) {
  const char *d = ph_xml_attribute(s->attributes, "d");
  return d ? ph_svg_path_read(s->trace, d, strlen(d), "d", &s->xml->diag)
           : PH_OK;
}

static enum ph_status draw_points(struct shape *s, bool closed) {
  const char *value = ph_xml_attribute(s->attributes, "points");
  const char *p = skip(value ? value : "", false);
  for (size_t i = 0; *p; i++, p = skip(p, true)) {
    double x[2];
    for (size_t k = 0; k < 2; k++) {
      p = k > 0 ? skip(p, true) : p;
      p = ph_number_read_text(p, p + strlen(p), &x[k]);
      if (!p || !isfinite(x[k])) {
        return ph_fail(&s->xml->diag, PH_E_SYNTAX, "points",
                       "must be pairs of numbers; something else stands in "
                       "the place of pair %zu",
                       i);
      }
    }
    if (i == 0) {
      ph_trace_move(s->trace, x[0], x[1]);
    } else {
      ph_trace_line(s->trace, x[0], x[1]);
    }
  }
  if (closed) {
    ph_trace_close(s->trace);
  }
  return PH_OK;
}

static enum ph_status draw_line(struct shape *s) {
  static const char *const names[] = {"x1", "y1", "x2", "y2"};
  double x[4];
  enum ph_status status = lengths(s, names, 4, x);
  if (status == PH_OK) {
    ph_trace_move(s->trace, x[0], x[1]);
    ph_trace_line(s->trace, x[2], x[3]);
  }
  return status;
}

/* SVG 1.1, sec. 9.2: clockwise as seen, from the top left corner. */
static enum ph_status draw_rect(struct shape *s) {
  static const char *const names[] = {"x", "y", "width", "height"};
  struct ph_trace *t = s->trace;
  double x[4], r[2];
  enum ph_status status = lengths(s, names, 4, x);
  status = status == PH_OK ? length(s, "rx", -1, &r[0]) : status;
  status = status == PH_OK ? length(s, "ry", -1, &r[1]) : status;
  if (status != PH_OK || !(x[2] > 0 && x[3] > 0)) {
    return status;
  }
  r[0] = r[0] < 0 ? r[1] : r[0];
  r[1] = r[1] < 0 ? r[0] : r[1];
  r[0] = fmin(fmax(r[0], 0), x[2] / 2);
  r[1] = fmin(fmax(r[1], 0), x[3] / 2);
  if (!(r[0] > 0 && r[1] > 0)) {
    r[0] = r[1] = 0;
  }
  ph_trace_move(t, x[0] + r[0], x[1]);
  ph_trace_line(t, x[0] + x[2] - r[0], x[1]);
  ph_trace_arc(t, r, 0, false, true, x[0] + x[2], x[1] + r[1]);
  ph_trace_line(t, x[0] + x[2], x[1] + x[3] - r[1]);
  ph_trace_arc(t, r, 0, false, true, x[0] + x[2] - r[0], x[1] + x[3]);
  ph_trace_line(t, x[0] + r[0], x[1] + x[3]);
  ph_trace_arc(t, r, 0, false, true, x[0], x[1] + x[3] - r[1]);
  ph_trace_line(t, x[0], x[1] + r[1]);
  ph_trace_arc(t, r, 0, false, true, x[0] + r[0], x[1]);
  ph_trace_close(t);
  return PH_OK;
}

static enum ph_status draw_ellipse(struct shape *s, bool circle) {
  static const char *const names[] = {"cx", "cy"};
  struct ph_trace *t = s->trace;
  double c[2], r[2];
  enum ph_status status = lengths(s, names, 2, c);
  status = status == PH_OK ? length(s, circle ? "r" : "rx", 0, &r[0]) : status;
  status = status == PH_OK ? length(s, circle ? "r" : "ry", 0, &r[1]) : status;
  if (status != PH_OK || !(r[0] > 0 && r[1] > 0)) {
    return status;
  }
  ph_trace_move(t, c[0] + r[0], c[1]);
  ph_trace_arc(t, r, 0, false, true, c[0], c[1] + r[1]);
  ph_trace_arc(t, r, 0, false, true, c[0] - r[0], c[1]);
  ph_trace_arc(t, r, 0, false, true, c[0], c[1] - r[1]);
  ph_trace_arc(t, r, 0, false, true, c[0] + r[0], c[1]);
  ph_trace_close(t);
  return PH_OK;
}

/* ---- elements -------------------------------------------------------------
 */

enum { PATH, POLYLINE, POLYGON, LINE, RECT, CIRCLE, ELLIPSE, SHAPES };

static enum ph_status draw(struct shape *s, size_t which) {
  switch (which) {
  case PATH:
    return draw_path(s);
  case POLYLINE:
  case POLYGON:
    return draw_points(s, which == POLYGON);
  case LINE:
    return draw_line(s);
  case RECT:
    return draw_rect(s);
  default:
    return draw_ellipse(s, which == CIRCLE);
  }
}

/* Begins to hand out what is drawn. */
static void read_shape(struct ph_xml_in *xml, size_t which,
                       const char *const *attributes) {
  struct shape s = {xml, attributes, &xml->trace};
  enum ph_status status;
  ph_arena_reset(&xml->arena);
  xml->trace = (struct ph_trace){.arena = &xml->arena};
  memcpy(xml->trace.affine, xml->affine[xml->depth], sizeof xml->affine[0]);
  xml->next_part = 0;
  status = draw(&s, which);
  if (xml->trace.failed) {
    status = ph_xml_fail_memory(xml, xml->budget.needed > 0);
    xml->budget.needed = 0;
  }
  for (size_t i = 0; status == PH_OK && i < 2 * xml->trace.n; i++) {
    if (!isfinite(xml->trace.v[i])) {
      status = ph_fail(&xml->diag, PH_E_NOT_FINITE, NULL,
                       "the element goes beyond what a double can have");
    }
  }
  if (status == PH_OK && xml->trace.parts_n == 0) {
    status =
        ph_fail(&xml->diag, PH_E_BAD_VALUE, NULL, "the element draws nothing");
  }
  if (status != PH_OK) {
    xml->trace.parts_n = 0;
    ph_xml_fail(xml, status);
  }
}

/* viewBox and units of the document. */
static void tell(struct ph_xml_in *xml, const char *const *attributes) {
  static const char *const names[] = {"width", "height", "viewBox"};
  for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
    const char *value = ph_xml_attribute(attributes, names[i]);
    if (value) {
      ph_buf_puts(&xml->meta, xml->meta.n > 0 ? "," : "");
      ph_xml_quote(&xml->meta, names[i], strlen(names[i]));
      ph_buf_puts(&xml->meta, ":");
      ph_xml_quote(&xml->meta, value, strlen(value));
    }
  }
}

void ph_svg_start(struct ph_xml_in *xml, const char *name,
                  const char *const *attributes) {
  static const char *const shapes[SHAPES] = {
      "path", "polyline", "polygon", "line", "rect", "circle", "ellipse"};
  static const char *const hidden[] = {"defs", "symbol", "clipPath",
                                       "mask", "marker", "pattern"};
  const char *value = ph_xml_attribute(attributes, "transform");
  const char *id = ph_xml_attribute(attributes, "id");
  const bool use = strcmp(name, "use") == 0;
  const bool inner =
      xml->depth > 1 && strcmp(name, "svg") == 0 &&
      (ph_xml_attribute(attributes, "x") || ph_xml_attribute(attributes, "y") ||
       ph_xml_attribute(attributes, "viewBox"));
  size_t which = 0;
  bool good;
  for (size_t i = 0; i < sizeof hidden / sizeof *hidden; i++) {
    if (strcmp(name, hidden[i]) == 0) {
      xml->hidden = xml->depth;
      return;
    }
  }
  if (xml->depth == 1) {
    tell(xml, attributes);
  }
  memcpy(xml->affine[xml->depth], xml->affine[xml->depth - 1],
         sizeof xml->affine[0]);
  good = !value || transform(value, xml->affine[xml->depth]);
  while (which < SHAPES && strcmp(name, shapes[which]) != 0) {
    which++;
  }
  ph_buf_cut(&xml->id, 0, 1 << 20);
  xml->parts = 0;
  if (id) {
    ph_xml_quote(&xml->id, id, strlen(id));
  }
  if (!good) {
    char excerpt[PH_EXCERPT_MAX];
    ph_fail(&xml->diag, PH_E_BAD_VALUE, "transform",
            "is \"%s\", which is no list of transformations",
            ph_excerpt(value, strlen(value), excerpt));
    ph_xml_fail(xml, PH_E_BAD_VALUE);
    xml->hidden = xml->depth;
  } else if (inner) {
    ph_fail(&xml->diag, PH_E_BAD_VALUE, NULL,
            "the element is <svg> inside of another, with x, y or viewBox: "
            "what is in it is not read");
    ph_xml_fail(xml, PH_E_BAD_VALUE);
    xml->hidden = xml->depth;
  } else if (use) {
    ph_fail(&xml->diag, PH_E_BAD_VALUE, NULL,
            "the element is <use>: what it refers to is not read");
    ph_xml_fail(xml, PH_E_BAD_VALUE);
  } else if (which < SHAPES) {
    read_shape(xml, which, attributes);
  }
}

/* ---- problems -------------------------------------------------------------
 */

static void put_point(struct ph_buf *buf, const double *p, const char *before) {
  char *to = ph_buf_reserve(buf, 2 * PH_NUMBER_MAX + 4);
  if (to) {
    char *at = to;
    *at++ = *before;
    *at++ = '[';
    at += ph_number_write(at, p[0]);
    *at++ = ',';
    at += ph_number_write(at, p[1]);
    *at++ = ']';
    buf->n += (size_t)(at - to);
  }
}

/* The control points of each piece. */
static void put_curve(struct ph_xml_in *xml, size_t from, size_t to,
                      const double *p) {
  const struct ph_trace *t = &xml->trace;
  ph_buf_puts(&xml->problem, "\"curve\":[");
  for (size_t i = from; i < to; i++) {
    ph_buf_puts(&xml->problem, i > from ? "," : "");
    for (size_t k = 0; k < t->sizes[i]; k++, p += 2) {
      put_point(&xml->problem, p, k > 0 ? "," : "[");
    }
    ph_buf_puts(&xml->problem, "]");
  }
  ph_buf_puts(&xml->problem, "]");
}

/* The ends of lines; false: there are others. */
static bool put_points(struct ph_xml_in *xml, size_t from, size_t to,
                       const double *p) {
  ph_buf_puts(&xml->problem, "\"points\":");
  put_point(&xml->problem, p, "[");
  for (size_t i = from; i < to; i++, p += 4) {
    if (xml->trace.sizes[i] != 2) {
      return false;
    }
    put_point(&xml->problem, p + 2, ",");
  }
  ph_buf_puts(&xml->problem, "]");
  return true;
}

bool ph_svg_next(struct ph_xml_in *xml) {
  const struct ph_trace *t = &xml->trace;
  const struct ph_trace_part *part;
  const bool curve = ph_field_find(xml->schema, "curve", 5) != NULL;
  size_t end;
  if (xml->next_part >= t->parts_n) {
    return false;
  }
  part = t->part + xml->next_part;
  end = xml->next_part + 1 < t->parts_n ? part[1].piece : t->pieces_n;
  ph_xml_begin(xml, t->parts_n > 1);
  ph_buf_puts(&xml->problem, xml->id.n > 0 ? "," : "");
  if (curve) {
    put_curve(xml, part->piece, end, t->v + 2 * part->point);
  } else if (!put_points(xml, part->piece, end, t->v + 2 * part->point)) {
    ph_fail(&xml->diag, PH_E_BAD_VALUE, NULL,
            "the element has curves: %s takes points, tc approximates curves",
            xml->schema->command);
    xml->next_part = t->parts_n;
    ph_xml_fail(xml, PH_E_BAD_VALUE);
    return true;
  }
  ph_buf_puts(&xml->problem, part->closed ? ",\"closed\":true" : "");
  if (xml->meta.n > 0) {
    ph_buf_puts(&xml->problem, ",\"meta\":{");
    ph_buf_put(&xml->problem, xml->meta.data, xml->meta.n);
    ph_buf_puts(&xml->problem, "}");
  }
  xml->problem.failed = xml->problem.failed || xml->meta.failed;
  ph_buf_puts(&xml->problem, "}");
  xml->next_part++;
  return true;
}
