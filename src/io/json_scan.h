/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * JSON as bytes: finds the end of one value, strictly, and walks through the
 * parts of a value that was found.  Nothing is allocated.
 */
#ifndef PH_IO_JSON_SCAN_H
#define PH_IO_JSON_SCAN_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Containers inside one another; the bits of ph_json_scan.objects. */
enum { PH_JSON_DEPTH_MAX = 64 };

enum { PH_JSON_MESSAGE_MAX = 128 };

enum ph_json_state {
  PH_JSON_DONE, /* a whole value: at is the first byte after it */
  PH_JSON_MORE, /* the text ends inside the value */
  PH_JSON_ERROR /* no JSON: at is the offending byte, message says why */
};

/* A scan that can be interrupted; {0} is the beginning of a value. */
struct ph_json_scan {
  size_t at;            /* offset of the next byte to look at */
  uint64_t objects;     /* bit d: the container at depth d is an object */
  unsigned depth;       /* containers that are open */
  unsigned char expect; /* what may come at `at` */
  unsigned char number; /* inside a number: its last part */
  bool name;            /* inside a string: it names a member */
  char message[PH_JSON_MESSAGE_MAX]; /* "expected ',' or ']', found 'x'" */
};

/*
 * ph_json_scan: goes on with the scan of one JSON value (RFC 8259, blanks
 * before it allowed) in text[n].
 *
 * in   text, n  the value from its beginning; after PH_JSON_MORE the same
 *               bytes, perhaps elsewhere in memory, with more behind them
 * in   last     nothing will follow the n bytes: a text that ends too early
 *               is then an error at offset n
 * ret  DONE, MORE or ERROR, which depend on the text alone and not on the
 *      portions it came in
 *
 * Every byte is looked at once, but for the at most 15 bytes of an unfinished
 * word, escape or character.  Refused beyond the grammar: lone surrogates,
 * bytes that are not UTF-8, and more than PH_JSON_DEPTH_MAX levels.
 */
enum ph_json_state ph_json_scan(struct ph_json_scan *scan, const char *text,
                                size_t n, bool last);

/* ph_json_scan_rest: the beginning of the scan of the rest of an object, behind
 * the value of a member: the closing brace, or a comma and other members. */
struct ph_json_scan ph_json_scan_rest(void);

/*
 * ph_json_unexpected: the failure of a text that goes on with a wrong byte at
 * offset scan->at, which must be less than n.
 *
 * in   expected  what would have been right
 * ret  ERROR, with the message; MORE when the byte begins a character that
 *      the text ends inside, unless it is the last of it
 */
enum ph_json_state ph_json_unexpected(struct ph_json_scan *scan,
                                      const char *expected, const char *text,
                                      size_t n, bool last);

/* A member of an object or an element of an array, as ranges of the text. */
struct ph_json_item {
  const char *key; /* between its quotes, not unescaped; NULL: no object */
  size_t key_n;
  const char *value;
  size_t value_n;
};

/* A walk through the items of a container. */
struct ph_json_walk {
  const char *p;
  const char *end;
  bool object;
};

/* ph_json_walk_init: begins a walk; text[n] is one value that ph_json_scan
 * has found good.  A value that is no container has no items. */
void ph_json_walk_init(struct ph_json_walk *walk, const char *text, size_t n);

/* ph_json_walk_next: the next item; false when there is none. */
bool ph_json_walk_next(struct ph_json_walk *walk, struct ph_json_item *item);

/* ph_json_blanks: the first byte in [p,end) that is no JSON blank, or end. */
const char *ph_json_blanks(const char *p, const char *end);

#endif
