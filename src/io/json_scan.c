/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The scanner of JSON text (see json_scan.h).
 *
 * A pushdown automaton whose stack is one bit per level: array or object.  Its
 * state `expect` says what the grammar allows at the next byte; strings and
 * numbers are states of their own, so that the scan can stop at any byte and
 * go on when more text is there.  Words (true, NaN), escapes and characters
 * are looked at only when they are complete: what is found in them must not
 * depend on the portions in which the text arrives.
 *
 * Reference: RFC 8259 (JSON), RFC 3629 (UTF-8).  Values are not interpreted
 * here; names are not compared.
 */
#include "io/json_scan.h"

#include "base/suggest.h"

#include <stdio.h>
#include <string.h>

enum expect {
  VALUE,       /* a value */
  FIRST_VALUE, /* a value or ']' */
  FIRST_NAME,  /* a name or '}' */
  NAME,        /* a name */
  COLON,       /* ':' */
  NEXT,        /* ',' or the end of the container */
  STRING,      /* the rest of a string */
  NUMBER,      /* the rest of a number */
  WHOLE        /* nothing: the value is complete */
};

/* Parts of a number, by what was read last (RFC 8259, sec. 6). */
enum number { MINUS, ZERO, INTEGER, POINT, FRACTION, E, E_SIGN, EXPONENT };

/* No literal is longer than this, nor worth reading to its end. */
enum { WORD_MAX = 15 };

/* One call of ph_json_scan. */
struct reader {
  struct ph_json_scan *scan;
  const char *p;
  const char *end;
  bool last;
};

/* Steps return PH_JSON_MORE or PH_JSON_ERROR, or this. */
enum { GO_ON = PH_JSON_ERROR + 1 };

const char *ph_json_blanks(const char *p, const char *end) {
  while (p < end && (*p == ' ' || *p == '\n' || *p == '\t' || *p == '\r')) {
    p++;
  }
  return p;
}

static bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

static bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

/* ---- failures ------------------------------------------------------- */

static int fail(struct reader *r, const char *message) {
  snprintf(r->scan->message, sizeof r->scan->message, "%s", message);
  return PH_JSON_ERROR;
}

/* "expected X, found 'y'"; a character is shown once it is all there. */
static int unexpected(struct reader *r, const char *expected) {
  int n = ph_utf8_length(r->p, r->end);
  const char *quote = *r->p == '\'' ? "\"" : "'";
  char found[PH_EXCERPT_MAX];
  if (n < 0 && !r->last) {
    return PH_JSON_MORE;
  }
  ph_excerpt(r->p, n > 0 ? (size_t)n : 1, found);
  if (*r->p == '\n') {
    snprintf(r->scan->message, sizeof r->scan->message,
             "expected %s, found the end of the line", expected);
  } else {
    snprintf(r->scan->message, sizeof r->scan->message,
             "expected %s, found %s%s%s%s", expected, quote, found, quote,
             *r->p == '/'   ? "; JSON has no comments"
             : *r->p == '<' ? "; --input-format=svg and gpx read SVG and GPX"
                            : "");
  }
  return PH_JSON_ERROR;
}

static int cut_off(struct reader *r) {
  const struct ph_json_scan *scan = r->scan;
  const char *in = "a value";
  if (scan->expect == STRING) {
    in = "a string";
  } else if (scan->expect == NUMBER) {
    in = "a number";
  } else if (scan->depth > 0) {
    in = scan->objects >> (scan->depth - 1) & 1 ? "an object" : "an array";
  }
  snprintf(r->scan->message, sizeof r->scan->message, "the text ends inside %s",
           in);
  return PH_JSON_ERROR;
}

/* ---- structure ------------------------------------------------------ */

/* A value is complete. */
static void finish_value(struct ph_json_scan *scan) {
  scan->expect = scan->depth > 0 ? NEXT : WHOLE;
}

static int open_container(struct reader *r, bool object) {
  struct ph_json_scan *scan = r->scan;
  uint64_t bit;
  if (scan->depth == PH_JSON_DEPTH_MAX) {
    return fail(r, "arrays and objects are nested more than 64 deep");
  }
  bit = UINT64_C(1) << scan->depth;
  scan->objects = object ? scan->objects | bit : scan->objects & ~bit;
  scan->depth++;
  scan->expect = object ? FIRST_NAME : FIRST_VALUE;
  r->p++;
  return GO_ON;
}

static int close_container(struct reader *r) {
  r->scan->depth--;
  finish_value(r->scan);
  r->p++;
  return GO_ON;
}

static void open_string(struct reader *r, bool name) {
  r->scan->expect = STRING;
  r->scan->name = name;
  r->p++;
}

/* ---- words ---------------------------------------------------------- */

/* true, false, null, or, also after a minus sign, a word that is no JSON. */
static int word(struct reader *r, bool signed_word) {
  static const char *const literals[] = {"true", "false", "null"};
  size_t n = 0;
  char found[PH_EXCERPT_MAX];
  while (n < WORD_MAX && r->p + n < r->end && is_letter(r->p[n])) {
    n++;
  }
  if (n < WORD_MAX && r->p + n == r->end && !r->last) {
    return PH_JSON_MORE;
  }
  for (size_t i = 0; i < sizeof literals / sizeof *literals; i++) {
    if (!signed_word && strlen(literals[i]) == n &&
        memcmp(r->p, literals[i], n) == 0) {
      finish_value(r->scan);
      r->p += n;
      return GO_ON;
    }
  }
  ph_excerpt(r->p, n, found);
  if (ph_word_is(r->p, n, "nan") || ph_word_is(r->p, n, "inf") ||
      ph_word_is(r->p, n, "infinity")) {
    snprintf(r->scan->message, sizeof r->scan->message,
             "%s is not JSON: numbers are finite", found);
  } else if (signed_word) {
    return unexpected(r, "a digit");
  } else {
    snprintf(r->scan->message, sizeof r->scan->message,
             "expected a value, found \"%s\"", found);
  }
  return PH_JSON_ERROR;
}

/* ---- numbers -------------------------------------------------------- */

/* The part of a number that c begins after `part`; -1: c ends the number. */
static int next_part(int part, char c) {
  switch (part) {
  case MINUS:
    return c == '0' ? ZERO : is_digit(c) ? INTEGER : -1;
  case ZERO:
  case INTEGER:
    return c == '.' ? POINT : c == 'e' || c == 'E' ? E : -1;
  case POINT:
    return is_digit(c) ? FRACTION : -1;
  case FRACTION:
    return c == 'e' || c == 'E' ? E : -1;
  case E:
    return c == '+' || c == '-' ? E_SIGN : is_digit(c) ? EXPONENT : -1;
  default: /* E_SIGN, EXPONENT */
    return part == E_SIGN && is_digit(c) ? EXPONENT : -1;
  }
}

static bool may_end(int part) {
  return part == ZERO || part == INTEGER || part == FRACTION ||
         part == EXPONENT;
}

static int number(struct reader *r) {
  int part = r->scan->number;
  for (;;) {
    int next;
    if (part == INTEGER || part == FRACTION || part == EXPONENT) {
      const char *p = r->p;
      while (p < r->end && is_digit(*p)) {
        p++;
      }
      r->p = p;
    }
    r->scan->number = (unsigned char)part;
    if (r->p == r->end) {
      break;
    }
    next = next_part(part, *r->p);
    if (next < 0) {
      break;
    }
    part = next;
    r->p++;
  }
  if (r->p == r->end && (!r->last || !may_end(part))) {
    return PH_JSON_MORE;
  }
  if (r->p < r->end && part == MINUS && is_letter(*r->p)) {
    return word(r, true); /* -Infinity */
  }
  if (!may_end(part)) {
    return unexpected(r, "a digit");
  }
  if (part == ZERO && r->p < r->end && is_digit(*r->p)) {
    return fail(r, "a number has no leading zero");
  }
  finish_value(r->scan);
  return GO_ON;
}

/* ---- strings -------------------------------------------------------- */

/* The value of four hexadecimal digits, or -1. */
static int hex4(const char *p) {
  int value = 0;
  for (int i = 0; i < 4; i++) {
    char c = p[i];
    int digit = is_digit(c)            ? c - '0'
                : c >= 'a' && c <= 'f' ? c - 'a' + 10
                : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                       : -1;
    if (digit < 0) {
      return -1;
    }
    value = 16 * value + digit;
  }
  return value;
}

/* A \u escape, with its second half where it is a surrogate. */
static int unicode_escape(struct reader *r) {
  size_t have = (size_t)(r->end - r->p);
  int unit;
  if (have < 6) {
    return PH_JSON_MORE;
  }
  unit = hex4(r->p + 2);
  if (unit < 0) {
    return fail(r, "expected four hexadecimal digits after \\u");
  }
  if (unit < 0xD800 || unit > 0xDFFF) {
    r->p += 6;
    return GO_ON;
  }
  if (unit < 0xDC00) {
    int low;
    if (have < 12 && (have < 7 || r->p[6] == '\\') &&
        (have < 8 || r->p[7] == 'u')) {
      return PH_JSON_MORE;
    }
    low = r->p[6] == '\\' && r->p[7] == 'u' ? hex4(r->p + 8) : -1;
    if (low >= 0xDC00 && low <= 0xDFFF) {
      r->p += 12;
      return GO_ON;
    }
  }
  return fail(r, "a \\u escape is half of a surrogate pair");
}

static int escape(struct reader *r) {
  if (r->end - r->p < 2) {
    return PH_JSON_MORE;
  }
  switch (r->p[1]) {
  case '"':
  case '\\':
  case '/':
  case 'b':
  case 'f':
  case 'n':
  case 'r':
  case 't':
    r->p += 2;
    return GO_ON;
  case 'u':
    return unicode_escape(r);
  default:
    return fail(r, "a backslash in a string begins none of "
                   "\\\" \\\\ \\/ \\b \\f \\n \\r \\t \\u");
  }
}

/* A byte of a string that is not plain ASCII. */
static int special(struct reader *r) {
  unsigned char c = (unsigned char)*r->p;
  int n;
  if (c == '\\') {
    return escape(r);
  }
  if (c < 0x20) {
    snprintf(r->scan->message, sizeof r->scan->message,
             "a string has the control character \\x%02x, "
             "which must be escaped",
             c);
    return PH_JSON_ERROR;
  }
  n = ph_utf8_length(r->p, r->end);
  if (n < 0) {
    return PH_JSON_MORE;
  }
  if (n == 0) {
    snprintf(r->scan->message, sizeof r->scan->message,
             "the byte \\x%02x is not UTF-8", c);
    return PH_JSON_ERROR;
  }
  r->p += n;
  return GO_ON;
}

static int string(struct reader *r) {
  for (;;) {
    int outcome;
    while (r->p < r->end && *r->p != '"' && *r->p != '\\' &&
           (unsigned char)(*r->p - 0x20) < 0x60) {
      r->p++;
    }
    if (r->p == r->end) {
      return PH_JSON_MORE;
    }
    if (*r->p == '"') {
      break;
    }
    outcome = special(r);
    if (outcome != GO_ON) {
      return outcome;
    }
  }
  r->p++;
  if (r->scan->name) {
    r->scan->expect = COLON;
  } else {
    finish_value(r->scan);
  }
  return GO_ON;
}

/* ---- the automaton -------------------------------------------------- */

static int begin_value(struct reader *r) {
  char c = *r->p;
  if (c == '-' || is_digit(c)) {
    r->scan->expect = NUMBER;
    r->scan->number = c == '-' ? MINUS : c == '0' ? ZERO : INTEGER;
    r->p++;
    return GO_ON;
  }
  if (c == '[' || c == '{') {
    return open_container(r, c == '{');
  }
  if (c == '"') {
    open_string(r, false);
    return GO_ON;
  }
  if (is_letter(c)) {
    return word(r, false);
  }
  if (c == ']' && r->scan->expect == FIRST_VALUE) {
    return close_container(r);
  }
  return unexpected(r, r->scan->expect == FIRST_VALUE ? "a value or ']'"
                                                      : "a value");
}

static int begin_name(struct reader *r) {
  if (*r->p == '"') {
    open_string(r, true);
    return GO_ON;
  }
  if (*r->p == '}' && r->scan->expect == FIRST_NAME) {
    return close_container(r);
  }
  return unexpected(r, r->scan->expect == FIRST_NAME
                           ? "a name in double quotes or '}'"
                           : "a name in double quotes");
}

static int after_item(struct reader *r) {
  bool object = r->scan->objects >> (r->scan->depth - 1) & 1;
  if (*r->p == ',') {
    r->scan->expect = object ? NAME : VALUE;
    r->p++;
    return GO_ON;
  }
  if (*r->p == (object ? '}' : ']')) {
    return close_container(r);
  }
  return unexpected(r, object ? "',' or '}'" : "',' or ']'");
}

static int colon(struct reader *r) {
  if (*r->p != ':') {
    return unexpected(r, "':'");
  }
  r->scan->expect = VALUE;
  r->p++;
  return GO_ON;
}

static int step(struct reader *r) {
  switch ((enum expect)r->scan->expect) {
  case VALUE:
  case FIRST_VALUE:
    return begin_value(r);
  case FIRST_NAME:
  case NAME:
    return begin_name(r);
  case COLON:
    return colon(r);
  case NEXT:
    return after_item(r);
  case STRING:
    return string(r);
  case NUMBER:
    return number(r);
  case WHOLE:
    break;
  }
  return PH_JSON_DONE;
}

enum ph_json_state ph_json_scan(struct ph_json_scan *scan, const char *text,
                                size_t n, bool last) {
  struct reader r = {scan, text + scan->at, text + n, last};
  int state = GO_ON;
  while (state == GO_ON && scan->expect != WHOLE) {
    bool token = scan->expect == STRING || scan->expect == NUMBER;
    if (!token) {
      r.p = ph_json_blanks(r.p, r.end);
    }
    state = r.p < r.end || token ? step(&r) : PH_JSON_MORE;
  }
  if (state == GO_ON) {
    state = PH_JSON_DONE;
  } else if (state == PH_JSON_MORE && last) {
    r.p = r.end;
    state = cut_off(&r);
  }
  scan->at = (size_t)(r.p - text);
  return (enum ph_json_state)state;
}

struct ph_json_scan ph_json_scan_rest(void) {
  return (struct ph_json_scan){.objects = 1, .depth = 1, .expect = NEXT};
}

enum ph_json_state ph_json_unexpected(struct ph_json_scan *scan,
                                      const char *expected, const char *text,
                                      size_t n, bool last) {
  struct reader r = {scan, text + scan->at, text + n, last};
  return (enum ph_json_state)unexpected(&r, expected);
}

/* ---- walking -------------------------------------------------------- */

/* The bytes inside a container at which skipping has to look. */
static const bool is_mark[256] = {
    ['"'] = true, ['['] = true, [']'] = true, ['{'] = true, ['}'] = true};

/* The first byte after the string that begins at p. */
static const char *skip_string(const char *p, const char *end) {
  for (p++; p < end && *p != '"'; p++) {
    if (*p == '\\' && p + 1 < end) {
      p++;
    }
  }
  return p < end ? p + 1 : end;
}

/* The first byte after the value that begins at p. */
static const char *skip_value(const char *p, const char *end) {
  size_t depth = 0;
  if (p < end && *p != '"' && *p != '[' && *p != '{') {
    while (p < end && !memchr(",]} \t\r\n", *p, 7)) {
      p++;
    }
    return p;
  }
  while (p < end) {
    if (*p == '"') {
      p = skip_string(p, end);
    } else {
      depth += *p == '[' || *p == '{';
      depth -= *p == ']' || *p == '}';
      p++;
    }
    if (depth == 0) {
      return p;
    }
    while (p < end && !is_mark[(unsigned char)*p]) {
      p++;
    }
  }
  return end;
}

void ph_json_walk_init(struct ph_json_walk *walk, const char *text, size_t n) {
  const char *end = text + n;
  const char *p = ph_json_blanks(text, end);
  bool container = p < end && (*p == '[' || *p == '{');
  walk->object = container && *p == '{';
  walk->p = container ? p + 1 : end;
  walk->end = end;
}

bool ph_json_walk_next(struct ph_json_walk *walk, struct ph_json_item *item) {
  const char *end = walk->end;
  const char *p = ph_json_blanks(walk->p, end);
  if (p < end && *p == ',') {
    p = ph_json_blanks(p + 1, end);
  }
  walk->p = p;
  if (p == end || *p == ']' || *p == '}') {
    return false;
  }
  item->key = NULL;
  item->key_n = 0;
  if (walk->object) {
    const char *key_end = skip_string(p, end);
    item->key = p + 1;
    item->key_n = (size_t)(key_end - p) - 2;
    p = ph_json_blanks(key_end, end);
    p = ph_json_blanks(p + (p < end), end);
  }
  item->value = p;
  p = skip_value(p, end);
  item->value_n = (size_t)(p - item->value);
  walk->p = p;
  return true;
}
