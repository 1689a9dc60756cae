/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Lines for standard error, all of one form, parts left out where unknown:
 *   phspline: FILE:LINE: record ID: FIELD: [warning: ]MESSAGE [CODE]
 * of a part of the input FILE: byte BYTE: in place of FILE:LINE:.
 * Whatever a text of the input holds, a line stays one, and a terminal does no
 * more than show it (ph_show in base/suggest.h).
 */
#ifndef PH_CLI_MESSAGE_H
#define PH_CLI_MESSAGE_H

#include "base/buf.h"
#include "base/diag.h"

struct ph_split_empty;

/* Whom a message is about; NULL and 0 are unknown. */
struct ph_subject {
  const char *file;
  size_t line;
  const char *id; /* plain text, cut to 80 bytes; NULL: the number is used */
  size_t number;  /* of the record in the stream */
  const size_t *byte; /* of a part: where it begins, which is told in place of
                         line and number; else NULL */
};

/* ph_message_error, ph_message_warning: append one line. */
void ph_message_error(struct ph_buf *buf, const struct ph_subject *subject,
                      const struct ph_diag *diag);
void ph_message_warning(struct ph_buf *buf, const struct ph_subject *subject,
                        const struct ph_diag *diag);

/* ph_message_failure: appends the line on a failure that is not a record's.  A
 * usage error is followed by a hint at the help of the command; NULL: of the
 * program. */
void ph_message_failure(struct ph_buf *buf, const struct ph_diag *diag,
                        const char *command);

/* ph_message_empty: appends that there is no such record in these files; `set`:
 * though options set its fields. */
void ph_message_empty(struct ph_buf *buf, const char *record,
                      const struct ph_split_empty *empty, bool set);

/* ph_message_subject: the beginning of a line, up to the record. */
void ph_message_subject(struct ph_buf *buf, const struct ph_subject *subject);

/* ph_message_printf: appends formatted text. */
void ph_message_printf(struct ph_buf *buf, const char *format, ...)
    PH_PRINTF(2, 3);

/* ph_message_send: writes the buffer to standard error and clears it. */
void ph_message_send(struct ph_buf *buf);

#endif
