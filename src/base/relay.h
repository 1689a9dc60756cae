/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Text that several threads write as if one had. */
#ifndef PH_BASE_RELAY_H
#define PH_BASE_RELAY_H

#include "base/buf.h"

#include <stddef.h>

/* Elements that a thread writes before it hands them over; and lists of fewer
 * than so many are not worth a second thread: a thread takes 20 us to begin,
 * 100 elements take as long. */
enum { PH_RELAY_CHUNK = 512, PH_RELAY_WORTH = 4096 };

/*
 * ph_relay: calls write(context, to, first, end), which appends elements first
 * to end - 1 to `to', for all of n elements; what is in buf afterwards, or has
 * left it, is the same for any number of threads, which are the spare ones that
 * buf knows of.
 *
 * in   write  keeps nothing in *context that another call could see; first is
 *             a multiple of PH_RELAY_CHUNK: what an element needs to know of
 *             those before it is found first, for each chunk
 */
void ph_relay(struct ph_buf *buf, size_t n,
              void (*write)(void *context, struct ph_buf *to, size_t first,
                            size_t end),
              void *context);

#endif
