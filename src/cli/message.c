/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Lines for standard error (see message.h). */
#include "cli/message.h"

#include "base/suggest.h"
#include "cli/output.h"
#include "io/split.h"

#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

/* Bytes of an id, and of any text: the name of a file is shown as a whole, as
 * far as systems have such names (PATH_MAX is 4096 where it is large), each
 * byte of it as four. */
enum { ID_MAX = 80, SHOWN_MAX = 4 * 4096 };

void ph_message_printf(struct ph_buf *buf, const char *format, ...) {
  char text[1024]; /* messages are bounded by struct ph_diag; names are cut */
  va_list args;
  va_start(args, format);
  vsnprintf(text, sizeof text, format, args);
  va_end(args);
  ph_buf_puts(buf, text);
}

/* A line stays a line, and a terminal is left alone: a text may hold any
 * character.  Cut to so many bytes. */
static void put_cut(struct ph_buf *buf, const char *text, size_t most) {
  char shown[SHOWN_MAX + sizeof "..."];
  ph_buf_puts(buf, ph_show(text, strlen(text), shown, most + sizeof "..."));
}

static void put_text(struct ph_buf *buf, const char *text) {
  put_cut(buf, text, SHOWN_MAX);
}

void ph_message_subject(struct ph_buf *buf, const struct ph_subject *subject) {
  ph_buf_puts(buf, "phspline: ");
  if (subject->file) {
    put_text(buf, subject->file);
    ph_buf_puts(buf, ":");
    if (subject->byte) {
      ph_message_printf(buf, " byte %zu:", *subject->byte);
    } else if (subject->line) {
      ph_message_printf(buf, "%zu:", subject->line);
    }
    ph_buf_puts(buf, " ");
  }
  if (subject->id) {
    ph_buf_puts(buf, "record ");
    put_cut(buf, subject->id, ID_MAX);
    ph_buf_puts(buf, ": ");
  } else if (subject->number && !subject->byte) {
    ph_message_printf(buf, "record %zu: ", subject->number);
  }
}

static void message(struct ph_buf *buf, const struct ph_subject *subject,
                    const struct ph_diag *diag, const char *prefix) {
  ph_message_subject(buf, subject);
  if (diag->field[0]) {
    put_text(buf, diag->field);
    ph_buf_puts(buf, ": ");
  }
  ph_buf_puts(buf, prefix);
  put_text(buf, diag->message);
  ph_message_printf(buf, " [%s]\n", ph_status_code(diag->status));
}

void ph_message_error(struct ph_buf *buf, const struct ph_subject *subject,
                      const struct ph_diag *diag) {
  message(buf, subject, diag, "");
}

void ph_message_warning(struct ph_buf *buf, const struct ph_subject *subject,
                        const struct ph_diag *diag) {
  message(buf, subject, diag, "warning: ");
}

void ph_message_failure(struct ph_buf *buf, const struct ph_diag *diag,
                        const char *command) {
  ph_buf_puts(buf, "phspline: ");
  put_text(buf, diag->field);
  ph_buf_puts(buf, diag->field[0] ? ": " : "");
  put_text(buf, diag->message); /* it may hold the name of a file */
  ph_buf_puts(buf, "\n");
  if (diag->status == PH_E_USAGE) {
    ph_message_printf(buf, "Try 'phspline%s%s --help'.\n", command ? " " : "",
                      command ? command : "");
  }
}

void ph_message_empty(struct ph_buf *buf, const char *record,
                      const struct ph_split_empty *empty, bool set) {
  ph_message_printf(buf, "phspline: there is no %s in ", record);
  for (size_t i = 0; i < empty->n && i < PH_SPLIT_EMPTY_NAMES; i++) {
    const bool standard = strcmp(empty->names[i], "-") == 0;
    ph_buf_puts(buf, i > 0 ? ", " : "");
    put_text(buf, standard ? "standard input" : empty->names[i]);
  }
  if (empty->n > PH_SPLIT_EMPTY_NAMES) {
    ph_message_printf(buf, " and %zu more", empty->n - PH_SPLIT_EMPTY_NAMES);
  }
  ph_buf_puts(buf, set ? " ({} is one whose fields are those of the options)\n"
                       : "\n");
}

void ph_message_send(struct ph_buf *buf) {
  static const char exhausted[] = "phspline: memory is exhausted\n";
  /* A lost message has nowhere to be reported; the exit status stands. */
  ph_output_bytes(STDERR_FILENO, buf->data, buf->n);
  if (buf->failed) {
    ph_output_bytes(STDERR_FILENO, exhausted, sizeof exhausted - 1);
  }
  ph_buf_clear(buf, SIZE_MAX);
}
