/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Formats the one failure of a record into its struct ph_diag; no output. */
#include "base/diag.h"

#include <stdio.h>
#include <string.h>

/* A text cut in the middle of a UTF-8 sequence would spoil the JSON record. */
static void trim_partial_utf8(char *text) {
  size_t n = strlen(text);
  size_t tail = 0; /* continuation bytes at the end */
  while (tail < 3 && tail < n &&
         ((unsigned char)text[n - 1 - tail] >> 6) == 2) {
    tail++;
  }
  if (tail < n) {
    unsigned char lead = (unsigned char)text[n - 1 - tail];
    size_t want = lead >= 0xF0 ? 3 : lead >= 0xE0 ? 2 : lead >= 0xC0 ? 1 : 0;
    if (want > tail) {
      text[n - 1 - tail] = '\0';
    }
  }
}

static void set(struct ph_diag *diag, enum ph_status status, const char *format,
                va_list args) {
  diag->status = status;
  diag->line = 0;
  diag->column = 0;
  vsnprintf(diag->message, sizeof diag->message, format, args);
  trim_partial_utf8(diag->message);
  trim_partial_utf8(diag->field);
}

void ph_diag_set(struct ph_diag *diag, enum ph_status status,
                 const char *format, va_list args) {
  diag->field[0] = '\0';
  set(diag, status, format, args);
}

enum ph_status ph_fail(struct ph_diag *diag, enum ph_status status,
                       const char *field, const char *format, ...) {
  va_list args;
  snprintf(diag->field, sizeof diag->field, "%s", field ? field : "");
  va_start(args, format);
  set(diag, status, format, args);
  va_end(args);
  return status;
}

enum ph_status ph_fail_at(struct ph_diag *diag, enum ph_status status,
                          const char *field, size_t index, const char *format,
                          ...) {
  va_list args;
  snprintf(diag->field, sizeof diag->field, "%s[%zu]", field, index);
  va_start(args, format);
  set(diag, status, format, args);
  va_end(args);
  return status;
}

void ph_diag_add(struct ph_diag *diag, const char *text) {
  size_t n = strlen(diag->message);
  snprintf(diag->message + n, sizeof diag->message - n, "; %s", text);
  trim_partial_utf8(diag->message);
}

enum ph_status ph_fail_memory(struct ph_diag *diag) {
  return ph_fail(diag, PH_E_NO_MEMORY, NULL, "memory is exhausted");
}

void ph_diag_sentence(const struct ph_diag *diag, char *text, size_t size) {
  const char *gap = diag->field[0] ? " " : "";
  snprintf(text, size, "%s%s%s", diag->field, gap, diag->message);
}
