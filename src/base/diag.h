/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * What went wrong, where: one failure, told once, at the place that knows it.
 *
 * The message is a predicate of the field, so that both forms read well:
 *   record   "points[3] coincides with points[2]"
 *   stderr   "points[3]: coincides with points[2]"
 * Without a field the message stands alone.  Lower case, no full stop; it says
 * what was found and what is allowed.  Nothing is printed here.
 */
#ifndef PH_BASE_DIAG_H
#define PH_BASE_DIAG_H

#include "base/status.h"

#include <stdarg.h>
#include <stddef.h>

enum { PH_DIAG_FIELD_MAX = 96, PH_DIAG_MESSAGE_MAX = 320 };

struct ph_diag {
  enum ph_status status;
  char field[PH_DIAG_FIELD_MAX];     /* path such as points[3][1]; "" = none */
  char message[PH_DIAG_MESSAGE_MAX]; /* cut at a character boundary */
  size_t line;                       /* line in the file, 0 = unknown */
  size_t column;                     /* column (bytes, from 1), 0 = unknown */
};

/* PH_TEXT: what a macro stands for, as a text. */
#define PH_TEXT_OF(x) #x
#define PH_TEXT(macro) PH_TEXT_OF(macro)

#ifdef __GNUC__
#define PH_PRINTF(fmt, args) __attribute__((format(printf, fmt, args)))
#else
#define PH_PRINTF(fmt, args)
#endif

/*
 * ph_fail: records a failure and returns its status, to be returned in turn.
 *
 * in   field   path of the field, or NULL
 * in   format  printf format of the message (numbers are printed with the C
 *              locale's point, as the program never calls setlocale)
 */
enum ph_status ph_fail(struct ph_diag *diag, enum ph_status status,
                       const char *field, const char *format, ...)
    PH_PRINTF(4, 5);

/* ph_diag_set: the same without a field, from a list of arguments. */
void ph_diag_set(struct ph_diag *diag, enum ph_status status,
                 const char *format, va_list args) PH_PRINTF(3, 0);

/* ph_fail_at: the same for element `index` of an array field. */
enum ph_status ph_fail_at(struct ph_diag *diag, enum ph_status status,
                          const char *field, size_t index, const char *format,
                          ...) PH_PRINTF(5, 6);

/* ph_diag_add: what is said after a message, "; " before it. */
void ph_diag_add(struct ph_diag *diag, const char *text);

/* ph_fail_memory: the failure of an allocation. */
enum ph_status ph_fail_memory(struct ph_diag *diag);

/*
 * ph_diag_sentence: the message with its field in front, as records have it.
 *
 * out  text[size]  NUL-terminated, cut if it does not fit
 */
void ph_diag_sentence(const struct ph_diag *diag, char *text, size_t size);

#endif
