/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Tracks and routes of GPX (see xml_in.h). */
#include "io/xml_in.h"

#include "io/number.h"

#include <math.h>
#include <string.h>

/* A number that is all of a text but for blanks; false: it is none. */
static bool read_number(const char *text, size_t n, double *x) {
  const char *end = text + n, *after;
  while (text < end && strchr(" \t\r\n", *text)) {
    text++;
  }
  after = ph_number_read_text(text, end, x);
  while (after && after < end && strchr(" \t\r\n", *after)) {
    after++;
  }
  return after == end && isfinite(*x);
}

static void put_number(struct ph_buf *buf, double x) {
  char *to = ph_buf_reserve(buf, PH_NUMBER_MAX);
  if (to) {
    buf->n += ph_number_write(to, x);
  }
}

static void clear(struct ph_xml_in *xml) {
  ph_buf_cut(&xml->points, 0, 1 << 20);
  ph_buf_cut(&xml->elevation, 0, 1 << 20);
  ph_buf_cut(&xml->time, 0, 1 << 20);
  xml->points_n = 0;
  xml->has_elevation = xml->has_time = xml->held = false;
}

static void begin_line(struct ph_xml_in *xml, size_t line) {
  clear(xml);
  xml->points.most = xml->elevation.most = xml->time.most = xml->most;
  xml->line = xml->points_line = line;
  xml->line_status = PH_OK;
  xml->over = xml->over && xml->id.failed;
}

/* The line that is held becomes a problem. */
static void finish(struct ph_xml_in *xml, bool several) {
  struct ph_buf *p = &xml->problem;
  const bool lonlat = ph_field_find(xml->schema, "lonlat", 6) != NULL;
  if (!xml->held) {
    return;
  }
  if (xml->line_status != PH_OK) {
    ph_xml_fail(xml, xml->line_status);
    clear(xml);
    return;
  }
  ph_xml_begin(xml, several);
  ph_buf_puts(p, xml->id.n > 0 ? "," : "");
  ph_buf_puts(p, lonlat ? "\"lonlat\":[" : "\"points\":[");
  ph_buf_put(p, xml->points.data, xml->points.n);
  ph_buf_puts(p, "]");
  if (xml->has_elevation || xml->has_time) {
    ph_buf_puts(p, ",\"meta\":{");
    if (xml->has_elevation) {
      ph_buf_puts(p, "\"elevation\":[");
      ph_buf_put(p, xml->elevation.data, xml->elevation.n);
      ph_buf_puts(p, xml->has_time ? "]," : "]");
    }
    if (xml->has_time) {
      ph_buf_puts(p, "\"time\":[");
      ph_buf_put(p, xml->time.data, xml->time.n);
      ph_buf_puts(p, "]");
    }
    ph_buf_puts(p, "}");
  }
  ph_buf_puts(p, "}");
  p->failed = p->failed || xml->points.failed || xml->elevation.failed ||
              xml->time.failed;
  p->n = xml->points.failed ? xml->points.n : p->n;
  clear(xml);
}

/* A point of the line: <trkpt lat="" lon="">. */
static void add_point(struct ph_xml_in *xml, const char *const *attributes,
                      size_t line) {
  static const char *const names[2] = {"lon", "lat"};
  double at[2] = {0};
  xml->point = xml->depth;
  for (size_t k = 0; k < 2; k++) {
    const char *value = ph_xml_attribute(attributes, names[k]);
    if (!value || !read_number(value, strlen(value), &at[k])) {
      xml->line_status =
          ph_fail(&xml->diag, PH_E_BAD_VALUE, names[k],
                  value ? "must be a number" : "is missing in this point");
      xml->diag.line = line;
      xml->points_n++;
      return;
    }
  }
  ph_buf_puts(&xml->points, xml->points_n > 0 ? "," : "");
  for (; xml->points_line < line; xml->points_line++) {
    ph_buf_puts(&xml->points, "\n");
  }
  ph_buf_puts(&xml->points, "[");
  put_number(&xml->points, at[0]);
  ph_buf_puts(&xml->points, ",");
  put_number(&xml->points, at[1]);
  ph_buf_puts(&xml->points, "]");
  ph_buf_puts(&xml->elevation, xml->points_n > 0 ? ",null" : "null");
  ph_buf_puts(&xml->time, xml->points_n > 0 ? ",null" : "null");
  xml->points_n++;
}

void ph_gpx_start(struct ph_xml_in *xml, const char *name,
                  const char *const *attributes, size_t line) {
  xml->want = PH_GPX_NONE;
  if (xml->depth == 2 &&
      (strcmp(name, "rte") == 0 || strcmp(name, "trk") == 0)) {
    xml->track = xml->depth;
    ph_buf_cut(&xml->id, 0, 1 << 20);
    xml->parts = 0;
    begin_line(xml, line);
  } else if (xml->track && !xml->point && strcmp(name, "trkseg") == 0) {
    finish(xml, true);
    begin_line(xml, line);
  } else if (xml->track && !xml->point &&
             (strcmp(name, "trkpt") == 0 || strcmp(name, "rtept") == 0)) {
    add_point(xml, attributes, line);
  } else if (xml->point && xml->depth == xml->point + 1) {
    xml->want = strcmp(name, "ele") == 0    ? PH_GPX_ELEVATION
                : strcmp(name, "time") == 0 ? PH_GPX_TIME
                                            : PH_GPX_NONE;
  } else if (xml->track && xml->depth == xml->track + 1 &&
             strcmp(name, "name") == 0) {
    xml->want = PH_GPX_NAME;
  }
  xml->text.n = 0;
}

/* Whether a list ends with the null that stands for what is not known yet. */
static bool is_due(const struct ph_buf *list) {
  return !list->failed && list->n >= 4 &&
         memcmp(list->data + list->n - 4, "null", 4) == 0;
}

/* The text of an element is complete: in place of a null, or the name. */
static void take_text(struct ph_xml_in *xml) {
  const char *p = xml->text.data, *end = p;
  double x;
  if (xml->text.failed && xml->want == PH_GPX_NAME) {
    xml->id.failed = true; /* of all lines of the track */
  } else if (xml->text.failed) {
    xml->line_status = ph_xml_fail_memory(xml, xml->over);
  }
  if (xml->text.failed || xml->text.n == 0) {
    return;
  }
  end += xml->text.n;
  while (p < end && strchr(" \t\r\n", *p)) {
    p++;
  }
  while (end > p && strchr(" \t\r\n", end[-1])) {
    end--;
  }
  if (p == end) {
    return;
  }
  if (xml->want == PH_GPX_NAME) {
    xml->id.n = 0;
    ph_xml_quote(&xml->id, p, (size_t)(end - p));
  } else if (xml->want == PH_GPX_TIME && is_due(&xml->time)) {
    xml->time.n -= 4;
    ph_xml_quote(&xml->time, p, (size_t)(end - p));
    xml->has_time = true;
  } else if (xml->want == PH_GPX_ELEVATION && is_due(&xml->elevation) &&
             read_number(p, (size_t)(end - p), &x)) {
    xml->elevation.n -= 4;
    put_number(&xml->elevation, x);
    xml->has_elevation = true;
  }
}

void ph_gpx_end(struct ph_xml_in *xml) {
  if (xml->want) {
    take_text(xml);
    xml->want = PH_GPX_NONE;
    ph_buf_cut(&xml->text, 0, 1 << 20);
  } else if (xml->depth == xml->point) {
    xml->point = 0;
  } else if (xml->track && !xml->point && xml->depth == xml->track + 1) {
    xml->held = xml->held || xml->points_n > 0;
  } else if (xml->track && xml->depth == xml->track) {
    xml->held = xml->held || xml->points_n > 0;
    finish(xml, xml->parts > 0);
    xml->track = 0;
  }
}
