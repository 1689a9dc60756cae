/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The values of problem fields: typed, checked reading of JSON by the rows of
 * struct ph_field, for records and for command line options alike.
 */
#ifndef PH_IO_VALUE_H
#define PH_IO_VALUE_H

#include "base/diag.h"
#include "base/mem.h"
#include "curve/problem.h"
#include "io/record.h"

#include <stddef.h>

/* Room for the phrase of ph_value_describe: longer ones are cut. */
enum { PH_VALUE_PHRASE_MAX = 224 };

/*
 * ph_value_read: the value of a field from its JSON text.
 *
 * in   text, n  one JSON value that ph_json_scan has found good
 * in   row      what the field may hold
 * in   arena    takes the value's memory
 * out  value    complete only when PH_OK is returned; numbers are finite,
 *               vectors are all of one allowed size; an empty array has n = 0,
 *               no piece of several is empty
 * ret  PH_OK; PH_E_BAD_TYPE (also for null), PH_E_BAD_VALUE (a word that is not
 *      in the list), PH_E_BAD_SHAPE (a vector of a wrong size, an empty piece),
 *      PH_E_NOT_FINITE (a number that overflows), PH_E_NO_MEMORY; diag names
 *      the field with its path, points[4][1]
 */
enum ph_status ph_value_read(const char *text, size_t n,
                             const struct ph_field *row, struct ph_arena *arena,
                             struct ph_value *value, struct ph_diag *diag);

/*
 * ph_value_read_option: the same for a VALUE of the command line: JSON, or a
 * number as people write it (.5), or else a bare word.  An empty VALUE of a
 * field that may be a truth value means true.
 *
 * in   text  NUL-terminated
 * ret  as ph_value_read; PH_E_SYNTAX when the text begins like a JSON array,
 *      object or string but is none
 */
enum ph_status ph_value_read_option(const char *text,
                                    const struct ph_field *row,
                                    struct ph_arena *arena,
                                    struct ph_value *value,
                                    struct ph_diag *diag);

/* ph_value_text: a value as JSON on one line, NUL-terminated; NULL when memory
 * is exhausted. */
const char *ph_value_text(const struct ph_value *value, struct ph_arena *arena);

/* ph_value_describe: what a row allows, as in messages: "chordal" or an array
 * of numbers.  ret phrase */
const char *ph_value_describe(const struct ph_field *row,
                              char phrase[PH_VALUE_PHRASE_MAX]);

/*
 * ph_value_string: the bytes that a JSON string stands for.
 *
 * in   text, n  the string with its quotes, found good by ph_json_scan
 * ret  NUL-terminated, in the arena; NULL when memory is exhausted.  A string
 *      with an escaped NUL is returned as it is written, between its quotes:
 *      such a text is no word or name.
 */
const char *ph_value_string(const char *text, size_t n, struct ph_arena *arena);

/* ph_value_type: the type of a JSON value in messages, by its first byte:
 * "a string", "null". */
const char *ph_value_type(char first);

/* ph_problem_trace: the field path becomes the field curve, and closed if it
 * is.  ret  PH_OK; PH_E_BAD_VALUE where there are both */
enum ph_status ph_problem_trace(struct ph_problem *problem,
                                struct ph_diag *diag);

/* ph_problem_check_required: PH_OK, or PH_E_MISSING_FIELD for the first field
 * that the schema requires and the problem lacks. */
enum ph_status ph_problem_check_required(const struct ph_problem *problem,
                                         const struct ph_schema *schema,
                                         struct ph_diag *diag);

#endif
