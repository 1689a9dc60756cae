/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Strings as JSON writes them. */
#ifndef PH_IO_JSON_TEXT_H
#define PH_IO_JSON_TEXT_H

#include <stddef.h>

/* Room for a quoted text of n bytes. */
#define PH_JSON_QUOTED_MAX(n) (6 * (n) + 2)

/*
 * ph_json_quote: text[n] as a JSON string.  Control characters, quotes and
 * backslashes are escaped; a byte that is not UTF-8 becomes U+FFFD.
 *
 * out  quoted   PH_JSON_QUOTED_MAX(n) bytes, not NUL-terminated
 * ret  bytes written
 */
size_t ph_json_quote(char *quoted, const char *text, size_t n);

#endif
