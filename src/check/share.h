/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A long certificate in parts, by all threads that there are. */
#ifndef PH_CHECK_SHARE_H
#define PH_CHECK_SHARE_H

#include "check/note.h"

/*
 * ph_check_share: check(context, v, first, end) for n elements, `part' at a
 * time: errors, status and fault of each part are joined in their order.
 * Verification, whose findings are sentences, goes through all of them at once.
 *
 * in   check  writes to *v alone, and takes no memory; it ends where
 *             ph_arena_late
 */
void ph_check_share(struct ph_check *v, size_t n, size_t part,
                    void (*check)(const void *context, struct ph_check *v,
                                  size_t first, size_t end),
                    const void *context);

#endif
