/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Reads single members of results, by how they are in memory. */
#ifndef PH_IO_JSON_FORM_H
#define PH_IO_JSON_FORM_H

#include "io/json_read.h"
#include "io/members.h"

/* ph_read_word: which of the words a member is; `absent' where there is none,
 * and after a failure. */
size_t ph_read_word(struct ph_json_reader *r, const struct ph_json_item *item,
                    const char *name, const char *const *words, size_t absent);

/*
 * ph_read_form: one that is there, and consists of no others.
 *
 * in   k   it is of segment k, if of one
 * out  at  as its form says, slot->size bytes
 */
void ph_read_form(struct ph_json_reader *r, const struct ph_slot *slot,
                  const struct ph_json_item *item, void *at, size_t k);

/* ph_read_list: an array of numbers, or vectors; at is a pointer to it.  out n
 */
void ph_read_list(struct ph_json_reader *r, const struct ph_slot *slot,
                  const struct ph_json_item *item, void *at, size_t *n);

/* ph_read_indices: an array of indices of segments; at is a pointer to it. */
void ph_read_indices(struct ph_json_reader *r, const struct ph_slot *slot,
                     const struct ph_json_item *item, void *at, size_t *n);

/* ph_read_nothing: what there is where a member is not. */
void ph_read_nothing(const struct ph_slot *slot, char *at);

#endif
