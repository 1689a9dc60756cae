/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Reads JSON whose members are known: objects by the rows of members.h, arrays
 * by the sizes they must have.
 *
 * The reader knows where it is (segments[2].interval[1]) and says so when it
 * fails.  A failure, as that there is no more time, is remembered in `status'
 * and makes every later call a no-op, so that whoever reads checks once, at the
 * end, or before memory that may not be there is touched.
 */
#ifndef PH_IO_JSON_READ_H
#define PH_IO_JSON_READ_H

#include "base/diag.h"
#include "base/mem.h"
#include "io/json_scan.h"
#include "io/members.h"

#include <stdbool.h>
#include <stddef.h>

struct ph_json_reader {
  struct ph_arena *arena;
  struct ph_diag *diag;
  enum ph_status status;
  size_t n; /* of path */
  char path[PH_DIAG_FIELD_MAX];
};

/* ---- where it is ------------------------------------------------------- */

/* ph_read_enter, ph_read_enter_at: into a member or an element.  ret what
 * ph_read_leave needs to come back. */
size_t ph_read_enter(struct ph_json_reader *r, const char *name);
size_t ph_read_enter_at(struct ph_json_reader *r, size_t index);
void ph_read_leave(struct ph_json_reader *r, size_t mark);

/* ph_read_fail: a failure here, unless there was one before. */
void ph_read_fail(struct ph_json_reader *r, enum ph_status status,
                  const char *format, ...) PH_PRINTF(3, 4);

/* ph_read_array_of: memory for n elements; NULL after a failure. */
void *ph_read_array_of(struct ph_json_reader *r, size_t n, size_t size);

/* ---- containers -------------------------------------------------------- */

/*
 * ph_read_members: finds the members of an object.  One that has a row must not
 * occur twice; others are passed over.
 *
 * out  items  by row; value NULL: absent
 */
void ph_read_members(struct ph_json_reader *r, const struct ph_json_item *from,
                     const struct ph_member *rows, struct ph_json_item *items);

/* ph_read_size: how many elements an array has; 0 after a failure. */
size_t ph_read_size(struct ph_json_reader *r, const struct ph_json_item *from);

/* ---- members: an item, its name, what it is ------------------------------ */

/* ph_read_required: fails if a member is absent.  ret whether it is there */
bool ph_read_required(struct ph_json_reader *r, const struct ph_json_item *item,
                      const char *name);

/* ph_read_number, ph_read_flag, ph_read_string: `absent' where there is none,
 * and after a failure. */
double ph_read_number(struct ph_json_reader *r, const struct ph_json_item *item,
                      const char *name, double absent);
bool ph_read_flag(struct ph_json_reader *r, const struct ph_json_item *item,
                  const char *name, bool absent);
const char *ph_read_string(struct ph_json_reader *r,
                           const struct ph_json_item *item, const char *name,
                           const char *absent);

/* ph_read_whole: a whole number from least to most, which must be there;
 * `least' after a failure.  Without a name the item is itself the number. */
size_t ph_read_whole(struct ph_json_reader *r, const struct ph_json_item *item,
                     const char *name, size_t least, size_t most);

/*
 * ph_read_numbers, ph_read_vectors: an array of n numbers, or of n vectors of
 * the dimension, which must be there.
 *
 * out  v  untouched after a failure that was before
 */
void ph_read_numbers(struct ph_json_reader *r, const struct ph_json_item *item,
                     const char *name, double *v, size_t n);
void ph_read_vectors(struct ph_json_reader *r, const struct ph_json_item *item,
                     const char *name, double *v, size_t n, size_t dimension);

/* ph_read_open: the same, of numbers that may be null, each or all: NaN.
 * Without a name the item is itself the array. */
void ph_read_open(struct ph_json_reader *r, const struct ph_json_item *item,
                  const char *name, double *v, size_t n);

#endif
