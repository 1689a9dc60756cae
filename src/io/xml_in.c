/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Documents of XML (see xml_in.h). */
#include "io/xml_in.h"

#include "base/suggest.h"
#include "io/json_text.h"

#include <stdio.h>
#include <string.h>

const char *ph_xml_attribute(const char *const *attributes, const char *name) {
  for (; *attributes; attributes += 2) {
    if (strcmp(attributes[0], name) == 0) {
      return attributes[1];
    }
  }
  return NULL;
}

void ph_xml_quote(struct ph_buf *buf, const char *text, size_t n) {
  char *to = ph_buf_reserve(buf, PH_JSON_QUOTED_MAX(n));
  if (to) {
    buf->n += ph_json_quote(to, text, n);
  }
}

void ph_xml_begin(struct ph_xml_in *xml, bool several) {
  char number[32];
  ph_buf_cut(&xml->problem, 0, 1 << 20);
  xml->problem.most = xml->most;
  xml->status = PH_OK;
  xml->ready = true;
  xml->at = xml->line;
  xml->parts++;
  ph_buf_puts(&xml->problem, "{");
  if (xml->id.n > 0) {
    ph_buf_puts(&xml->problem, "\"id\":");
    ph_buf_put(&xml->problem, xml->id.data, xml->id.n - (several ? 1 : 0));
    snprintf(number, sizeof number, "/%zu\"", xml->parts);
    ph_buf_puts(&xml->problem, several ? number : "");
  }
  xml->problem.failed = xml->problem.failed || xml->id.failed;
}

void ph_xml_fail(struct ph_xml_in *xml, enum ph_status status) {
  ph_xml_begin(xml, false);
  ph_buf_puts(&xml->problem, "}");
  xml->problem.n = xml->id.n > 0 ? xml->problem.n : 0;
  xml->status = status;
}

/* The name without the prefix of its own name space; NULL: of another one. */
static const char *local(const char *name) {
  if (strncmp(name, "svg:", 4) == 0 || strncmp(name, "gpx:", 4) == 0) {
    name += 4;
  }
  return strchr(name, ':') ? NULL : name;
}

static void begin_document(struct ph_xml_in *xml, const char *name) {
  const bool svg = name && strcmp(name, "svg") == 0;
  const bool gpx = name && strcmp(name, "gpx") == 0;
  char excerpt[PH_EXCERPT_MAX];
  if ((svg && xml->kind != PH_XML_GPX) || (gpx && xml->kind != PH_XML_SVG)) {
    static const double as_is[6] = PH_TRACE_AS_IS;
    xml->kind = svg ? PH_XML_SVG : PH_XML_GPX;
    memcpy(xml->affine[0], as_is, sizeof as_is);
    return;
  }
  name = name ? name : "?";
  xml->wrong = true;
  ph_fail(&xml->diag, PH_E_SYNTAX, NULL, "the XML is <%s>: %s",
          ph_excerpt(name, strlen(name), excerpt),
          xml->kind == PH_XML_ANY   ? "only SVG and GPX are read"
          : xml->kind == PH_XML_SVG ? "it should be <svg>"
                                    : "it should be <gpx>");
}

void ph_xml_start(struct ph_xml_in *xml, const char *name,
                  const char *const *attributes, size_t line) {
  const char *plain = local(name);
  if (xml->depth++ == 0) {
    begin_document(xml, plain);
  }
  if (xml->depth > PH_XML_DEPTH_MAX && !xml->wrong) {
    xml->wrong = true;
    ph_fail(&xml->diag, PH_E_LIMIT, NULL,
            "elements are nested more than %d deep", PH_XML_DEPTH_MAX);
  }
  if (xml->wrong || xml->hidden) {
    return;
  }
  if (!plain) {
    xml->hidden = xml->depth;
    return;
  }
  if (xml->kind == PH_XML_SVG) {
    xml->line = line;
    ph_svg_start(xml, plain, attributes);
  } else {
    ph_gpx_start(xml, plain, attributes, line);
  }
}

void ph_xml_end(struct ph_xml_in *xml) {
  if (!xml->hidden && xml->kind == PH_XML_GPX) {
    ph_gpx_end(xml);
  }
  if (xml->hidden == xml->depth) {
    xml->hidden = 0;
  }
  xml->depth--;
}

void ph_xml_text(struct ph_xml_in *xml, const char *text, size_t n) {
  if (!xml->want || xml->hidden || xml->text.failed) {
    return;
  }
  if (xml->most && n > xml->most - xml->text.n) {
    xml->text.failed = xml->over = true;
  }
  ph_buf_put(&xml->text, text, n);
}

enum ph_status ph_xml_fail_memory(struct ph_xml_in *xml, bool over) {
  return over ? ph_fail(&xml->diag, PH_E_LIMIT, NULL,
                        "the record is longer than the %zu bytes of "
                        "--max-record-bytes",
                        xml->most)
              : ph_fail_memory(&xml->diag);
}

bool ph_xml_next(struct ph_xml_in *xml) {
  const bool next = xml->ready || ph_svg_next(xml);
  const struct ph_buf *p = &xml->problem;
  xml->ready = false;
  if (next && xml->status == PH_OK && p->failed) {
    xml->status =
        ph_xml_fail_memory(xml, xml->over || (xml->most && p->n > xml->most));
    xml->problem.n = 0;
  }
  return next;
}

void ph_xml_free(struct ph_xml_in *xml) {
  ph_buf_free(&xml->problem);
  ph_buf_free(&xml->id);
  ph_buf_free(&xml->meta);
  ph_buf_free(&xml->points);
  ph_buf_free(&xml->elevation);
  ph_buf_free(&xml->time);
  ph_buf_free(&xml->text);
  ph_arena_free(&xml->arena);
}
