/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The splitter's way through XML (see split.h), by expat, which may be missing:
 * then there is the news that there is none.
 *
 * The parser is fed in blocks, and stops with each problem.  Entities are
 * refused where they are declared, so that none is ever expanded, and nothing
 * outside of the file is read.  What the parser has to keep of a token is
 * bounded like a record.
 */
#include "io/split.h"

#ifdef PH_EXPAT

#include "base/mem.h"
#include "base/suggest.h"
#include "io/xml_in.h"

#include <expat.h>
#include <string.h>

/* The parser gets a document in blocks of so many bytes, however they arrive:
 * what it says of a broken one, and where, depends on where its input is cut,
 * and so does the encoding that it guesses. */
enum { BLOCK = 1 << 16 };

struct ph_split_xml {
  XML_Parser parser;
  struct ph_xml_in in;
  size_t lines; /* before the parser's first */
  size_t fed;   /* bytes */
  size_t last;  /* of these, the last time */
  bool ended;   /* it has all of the file, and has told it */
};

bool ph_split_xml_can(void) {
  return true;
}

/* ---- events ---------------------------------------------------------------
 */

static void pause(struct ph_split_xml *xml) {
  if (xml->in.wrong || xml->in.ready || xml->in.trace.parts_n > 0) {
    XML_StopParser(xml->parser, !xml->in.wrong);
  }
}

/* Whether a token of n bytes, or more, is longer than a record may be. */
static bool is_over(struct ph_split_xml *xml, size_t n) {
  if (!xml->in.most || n <= xml->in.most) {
    return false;
  }
  xml->in.wrong = true;
  ph_fail(&xml->in.diag, PH_E_LIMIT, NULL,
          "an element is longer than the %zu bytes of --max-record-bytes",
          xml->in.most);
  return true;
}

/* The same of one that is all there. */
static bool event_is_over(struct ph_split_xml *xml) {
  const int n = XML_GetCurrentByteCount(xml->parser);
  if (!is_over(xml, n > 0 ? (size_t)n : 0)) {
    return false;
  }
  XML_StopParser(xml->parser, XML_FALSE);
  return true;
}

/* What is neither an element nor text. */
static void other(void *data, const XML_Char *characters, int n) {
  (void)characters, (void)n;
  event_is_over(data);
}

static void start_element(void *data, const XML_Char *name,
                          const XML_Char **attributes) {
  struct ph_split_xml *xml = data;
  xml->in.trace.parts_n = 0;
  if (event_is_over(xml)) {
    return;
  }
  ph_xml_start(&xml->in, name, attributes,
               xml->lines + XML_GetCurrentLineNumber(xml->parser));
  pause(xml);
}

static void end_element(void *data, const XML_Char *name) {
  struct ph_split_xml *xml = data;
  (void)name;
  ph_xml_end(&xml->in);
  if (xml->in.ready) {
    pause(xml);
  }
}

static void text(void *data, const XML_Char *characters, int n) {
  struct ph_split_xml *xml = data;
  ph_xml_text(&xml->in, characters, (size_t)n);
}

static void declare_entity(void *data, const XML_Char *name, int is_parameter,
                           const XML_Char *value, int n, const XML_Char *base,
                           const XML_Char *system, const XML_Char *public,
                           const XML_Char *notation) {
  struct ph_split_xml *xml = data;
  char excerpt[PH_EXCERPT_MAX];
  (void)is_parameter, (void)value, (void)n, (void)base, (void)system;
  (void)public, (void)notation;
  xml->in.wrong = true;
  ph_fail(&xml->in.diag, PH_E_SYNTAX, NULL,
          "the XML declares the entity %s: entities are refused",
          ph_excerpt(name, strlen(name), excerpt));
  XML_StopParser(xml->parser, XML_FALSE);
}

/* ---- the parser -----------------------------------------------------------
 */

void ph_split_xml_close(struct ph_split *split) {
  if (split->xml) {
    if (split->xml->parser) {
      XML_ParserFree(split->xml->parser);
    }
    ph_xml_free(&split->xml->in);
    ph_free(split->xml);
    split->xml = NULL;
  }
}

static bool open_parser(struct ph_split *split) {
  struct ph_split_xml *xml = ph_malloc(sizeof *xml);
  if (!xml) {
    return false;
  }
  memset(xml, 0, sizeof *xml);
  split->xml = xml;
  xml->in.schema = split->schema;
  xml->in.most = split->options.most;
  xml->in.kind = split->format == PH_SPLIT_SVG   ? PH_XML_SVG
                 : split->format == PH_SPLIT_GPX ? PH_XML_GPX
                                                 : PH_XML_ANY;
  xml->in.arena.budget = &xml->in.budget;
  ph_budget_start(&xml->in.budget, PH_XML_GROWTH * split->options.most, 0);
  xml->lines = split->place.line - 1;
  xml->parser = XML_ParserCreate(NULL);
  if (!xml->parser) {
    return false;
  }
  XML_SetUserData(xml->parser, xml);
  XML_SetElementHandler(xml->parser, start_element, end_element);
  XML_SetCharacterDataHandler(xml->parser, text);
  XML_SetEntityDeclHandler(xml->parser, declare_entity);
  XML_SetDefaultHandler(xml->parser, other);
  ph_split_drop(split, split->blanks);
  split->blanks = 0;
  return true;
}

/* Hands out the problem that is ready. */
static enum ph_split_state
give(struct ph_split *split, struct ph_record *record, struct ph_diag *diag) {
  struct ph_split_xml *xml = split->xml;
  ph_split_give(split, 0, 0, record);
  record->text = xml->in.problem.data;
  record->n = xml->in.problem.n;
  record->line = xml->in.at;
  record->status = xml->in.status;
  record->downward = xml->in.kind == PH_XML_SVG;
  record->degrees = xml->in.kind == PH_XML_GPX;
  if (record->status != PH_OK) {
    record->named = record->n > 0;
    *diag = xml->in.diag;
    diag->line = diag->line ? diag->line : record->line;
    xml->in.diag.line = 0;
  }
  return PH_SPLIT_RECORD;
}

/* Hands out what is wrong with the document, the last record. */
static enum ph_split_state
stop(struct ph_split *split, struct ph_record *record, struct ph_diag *diag) {
  struct ph_split_xml *xml = split->xml;
  ph_split_give(split, 0, 0, record);
  if (xml->in.wrong) {
    *diag = xml->in.diag;
  } else if (XML_GetErrorCode(xml->parser) == XML_ERROR_NO_MEMORY) {
    ph_fail_memory(diag);
  } else {
    ph_fail(diag, PH_E_SYNTAX, NULL, "XML: %s%s",
            XML_ErrorString(XML_GetErrorCode(xml->parser)),
            XML_GetCurrentByteIndex(xml->parser) > 0
                ? ""
                : "; the input does not begin as SVG or GPX do");
  }
  record->status = diag->status;
  record->line = diag->line =
      xml->lines + XML_GetCurrentLineNumber(xml->parser);
  diag->column = XML_GetCurrentColumnNumber(xml->parser) + 1;
  split->stopped = true;
  return PH_SPLIT_RECORD;
}

/* Whether there is more of a token than a record may have.  The parser may put
 * off looking at it until there is twice as much. */
static bool token_is_over(struct ph_split *split) {
  struct ph_split_xml *xml = split->xml;
  const long at = (long)XML_GetCurrentByteIndex(xml->parser);
  const size_t n = at >= 0 ? xml->fed - (size_t)at : 0;
  return n > xml->last && is_over(xml, (n - xml->last) / 2);
}

static enum XML_Parsing parsing_of(const struct ph_split *split) {
  XML_ParsingStatus status;
  XML_GetParsingStatus(split->xml->parser, &status);
  return status.parsing;
}

/* Gives the parser what is in the window, or lets it go on. */
static enum XML_Status feed(struct ph_split *split) {
  struct ph_split_xml *xml = split->xml;
  const size_t there = split->fill - split->start;
  const size_t n = there < BLOCK ? there : BLOCK;
  enum XML_Status result;
  if (parsing_of(split) == XML_SUSPENDED) {
    return XML_ResumeParser(xml->parser);
  }
  result = XML_Parse(xml->parser, split->data + split->start, (int)n, n == 0);
  xml->fed += n;
  xml->last = n;
  ph_split_drop(split, n);
  return result;
}

/* Whether the parser waits for more than what was read. */
static bool is_hungry(const struct ph_split *split) {
  return parsing_of(split) != XML_SUSPENDED &&
         split->fill - split->start < BLOCK && !split->end_of_file;
}

enum ph_split_state ph_split_xml(struct ph_split *split, bool may_wait,
                                 struct ph_record *record,
                                 struct ph_diag *diag) {
  if (!split->xml && !open_parser(split)) {
    split->ended = true;
    ph_fail_memory(diag);
    return PH_SPLIT_FAILED;
  }
  for (;;) {
    enum ph_split_state state;
    enum XML_Status result;
    if (ph_xml_next(&split->xml->in)) {
      return give(split, record, diag);
    }
    if (split->xml->in.wrong) {
      return stop(split, record, diag);
    }
    if (split->xml->ended) {
      return PH_SPLIT_END;
    }
    while (is_hungry(split)) {
      state = ph_split_fill(split, may_wait, diag);
      if (state == PH_SPLIT_WAIT || state == PH_SPLIT_FAILED) {
        return state;
      }
    }
    result = feed(split);
    split->xml->ended = parsing_of(split) == XML_FINISHED;
    if (result == XML_STATUS_ERROR ||
        (result == XML_STATUS_OK && !split->xml->ended &&
         token_is_over(split))) {
      return stop(split, record, diag);
    }
  }
}

#else

#include <string.h>

bool ph_split_xml_can(void) {
  return false;
}

void ph_split_xml_close(struct ph_split *split) {
  (void)split;
}

enum ph_split_state ph_split_xml(struct ph_split *split, bool may_wait,
                                 struct ph_record *record,
                                 struct ph_diag *diag) {
  (void)may_wait, (void)record;
  split->ended = true;
  ph_fail(diag, PH_E_INPUT, NULL,
          "cannot read %s: SVG and GPX need expat, which this program was "
          "built without: install libexpat1-dev (Debian, Ubuntu) or expat "
          "(elsewhere) and build it again",
          split->name);
  return PH_SPLIT_FAILED;
}

#endif
