/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Numbers as text, exactly: what is written reads back as the same double,
 * and what is read is the double nearest to the text.  The locale is never
 * consulted, nothing is allocated, and every function is thread safe.
 */
#ifndef PH_IO_NUMBER_H
#define PH_IO_NUMBER_H

#include <stddef.h>

/* Room for any number; the longest is -0.0000012345678901234567. */
#define PH_NUMBER_MAX 32

/*
 * ph_number_write: writes x with the fewest digits that read back as x, and of
 * those the closest to x.
 *
 * in   x    finite
 * out  out  room for PH_NUMBER_MAX bytes, all of which may be overwritten; the
 *           text is a JSON number and gets no terminating NUL
 * ret  length of the text
 *
 * Plain notation for 1e-6 <= |x| < 1e21, else 1.5e-7 or 1e22 (the form of
 * ECMAScript, without its plus sign).  Negative zero is -0.
 */
size_t ph_number_write(char *out, double x);

/*
 * ph_number_read: reads the longest JSON number (RFC 8259, sec. 6) that begins
 * at p; never looks at or beyond end.
 *
 * in   p, end  the text; no NUL is needed
 * out  x       the nearest double, ties to even, whatever the number of
 *              digits; a number too large for a double gives +-HUGE_VAL, one
 *              too small +-0.  Untouched when the result is NULL.
 * ret  the place after the number, or NULL when there is none at p
 */
const char *ph_number_read(const char *p, const char *end, double *x);

/*
 * ph_number_read_text: the same for CSV cells and command line values, where
 * a leading +, leading zeros, .5 and 5. are numbers, too.
 */
const char *ph_number_read_text(const char *p, const char *end, double *x);

#endif
