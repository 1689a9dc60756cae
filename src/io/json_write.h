/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Writes JSON, compact or indented, into a buffer.
 *
 * The writer keeps one bit of state for each level, whether a comma is due.
 * Numbers and vectors of numbers stay on one line even when indented.
 */
#ifndef PH_IO_JSON_WRITE_H
#define PH_IO_JSON_WRITE_H

#include "base/buf.h"

#include <stdbool.h>
#include <stddef.h>

enum { PH_JSON_WRITE_DEPTH_MAX = 16 };

struct ph_json_writer {
  struct ph_buf *buf;
  bool pretty;
  size_t depth;
  bool comma[PH_JSON_WRITE_DEPTH_MAX];
};

/* ph_write_put: a character as it is. */
void ph_write_put(struct ph_json_writer *w, char c);

/* ph_write_begin, ph_write_end: an array or an object, by its brackets. */
void ph_write_begin(struct ph_json_writer *w, char bracket);
void ph_write_end(struct ph_json_writer *w, char bracket);

/* ph_write_element: to be called before an element of an array that does not
 * stay on one line. */
void ph_write_element(struct ph_json_writer *w);

/* ph_write_key: the name of a member, in which nothing needs an escape. */
void ph_write_key(struct ph_json_writer *w, const char *name);

/* ---- values ---------------------------------------------------------- */

void ph_write_string(struct ph_json_writer *w, const char *text);
void ph_write_flag(struct ph_json_writer *w, bool flag);

/* ph_write_number: a finite number, as do all that follow. */
void ph_write_number(struct ph_json_writer *w, double x);

/* ph_write_numbers: [a,b,c] */
void ph_write_numbers(struct ph_json_writer *w, const double *v, size_t n);

/* ph_write_open: the same, null in place of each that is not finite, and of all
 * if none is. */
void ph_write_open(struct ph_json_writer *w, const double *v, size_t n);

/* ph_write_vectors: [[a,b],[c,d]], of v[n][dimension] */
void ph_write_vectors(struct ph_json_writer *w, const double *v, size_t n,
                      size_t dimension);

/* ---- members: a name and its value ------------------------------------- */

void ph_write_key_string(struct ph_json_writer *w, const char *name,
                         const char *text);
void ph_write_key_number(struct ph_json_writer *w, const char *name, double x);

/* ph_write_key_raw: json[n] as it is; none if it is NULL */
void ph_write_key_raw(struct ph_json_writer *w, const char *name,
                      const char *json, size_t n);

#endif
