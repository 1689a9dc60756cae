/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * SVG and GPX as problems, from the events of an XML parser (io/split_xml.c).
 *
 * Of SVG each subpath of path, polyline, polygon, line, rect, circle and
 * ellipse is a problem: the field curve, where the command has it, and else
 * points, if it is of lines alone.  Its coordinates are those of the outermost
 * svg element, all transformations applied; viewBox and units are not, but
 * told in meta.  What is drawn from elsewhere (defs, symbol, clipPath, mask,
 * marker, pattern) is no problem.
 *
 * Of GPX each segment of a track (trkseg) and each route (rte) is one:
 * longitude and latitude, with elevation and time of its points in meta.
 *
 * The id is that of the element, or the name of the track, with /1, /2, ...
 * where there are several.
 */
#ifndef PH_IO_XML_IN_H
#define PH_IO_XML_IN_H

#include "base/buf.h"
#include "base/diag.h"
#include "io/svg_path.h"

#include <stdbool.h>
#include <stddef.h>

/* Elements inside one another. */
enum { PH_XML_DEPTH_MAX = 256 };

/* Of what is drawn, for each byte of a record. */
enum { PH_XML_GROWTH = 16 };

enum ph_xml_kind { PH_XML_ANY, PH_XML_SVG, PH_XML_GPX };

/* A document; {.schema, .kind, .most} at first, everything else is private to
 * io/svg_in.c, io/gpx_in.c and io/xml_in.c. */
struct ph_xml_in {
  const struct ph_schema *schema; /* of the command */
  enum ph_xml_kind kind;          /* allowed, then found */
  size_t most;                    /* bytes of a problem; 0: any number */
  size_t depth;
  size_t hidden;       /* depth of the element whose content is none; 0: none */
  bool wrong;          /* the document cannot be read, */
  struct ph_diag diag; /* why; or of the element */
  /* the problem */
  struct ph_buf problem;
  enum ph_status status; /* of it */
  bool ready;
  size_t at;          /* its line */
  size_t line;        /* of the element */
  struct ph_buf id;   /* JSON, empty: none */
  size_t parts;       /* of that id so far */
  struct ph_buf meta; /* members, of SVG */
  /* SVG */
  struct ph_arena arena;
  struct ph_budget budget; /* of it: in a record that may be, there is less */
  double affine[PH_XML_DEPTH_MAX + 1][6];
  struct ph_trace trace; /* whose parts are handed out */
  size_t next_part;
  /* GPX */
  size_t track, point; /* depths of the elements; 0: outside */
  struct ph_buf points, elevation, time, text;
  enum { PH_GPX_NONE, PH_GPX_NAME, PH_GPX_ELEVATION, PH_GPX_TIME } want;
  size_t points_n, points_line; /* so many; the line of the last one */
  enum ph_status line_status;   /* of the line so far */
  bool has_elevation, has_time, held;
  bool over; /* a text is longer than a record may be */
};

/* ph_xml_start, ph_xml_end, ph_xml_text: an element begins, with its attributes
 * (name, value, ..., NULL) and its line; ends; text[n].  Where `wrong` or
 * `ready` is set by a start or an end, no start may come before
 * ph_xml_next. */
void ph_xml_start(struct ph_xml_in *xml, const char *name,
                  const char *const *attributes, size_t line);
void ph_xml_end(struct ph_xml_in *xml);
void ph_xml_text(struct ph_xml_in *xml, const char *text, size_t n);

/*
 * ph_xml_next: the next problem that is ready; false: there is none.
 *
 * xml->problem has its text, with line breaks such that points of GPX are on
 * their lines from xml->at on; xml->status is PH_OK, or what is wrong, in
 * xml->diag, and the text has then the id alone, or is empty.
 */
bool ph_xml_next(struct ph_xml_in *xml);

void ph_xml_free(struct ph_xml_in *xml);

/* ---- between its files ------------------------------------------------- */

/* ph_xml_attribute: the value of an attribute, or NULL. */
const char *ph_xml_attribute(const char *const *attributes, const char *name);

/* ph_xml_quote: appends a text as a JSON string. */
void ph_xml_quote(struct ph_buf *buf, const char *text, size_t n);

/* ph_xml_begin: begins the problem with the id; `several`: with a number. */
void ph_xml_begin(struct ph_xml_in *xml, bool several);

/* ph_xml_fail: the element is none of the problems, as diag says. */
void ph_xml_fail(struct ph_xml_in *xml, enum ph_status status);

/* ph_xml_fail_memory: memory is exhausted, or `over` what a record may have.
 * ret  PH_E_NO_MEMORY | PH_E_LIMIT, with diag */
enum ph_status ph_xml_fail_memory(struct ph_xml_in *xml, bool over);

void ph_svg_start(struct ph_xml_in *xml, const char *name,
                  const char *const *attributes);
bool ph_svg_next(struct ph_xml_in *xml);
void ph_gpx_start(struct ph_xml_in *xml, const char *name,
                  const char *const *attributes, size_t line);
void ph_gpx_end(struct ph_xml_in *xml);

#endif
