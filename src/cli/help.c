/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Help and version texts (see help.h). */
#include "cli/help.h"

#include "base/version.h"
#include "cli/option.h"

#include <string.h>

/* The column where help texts begin; the longest option just fits. */
enum { TEXT_COLUMN = 28 };

static void pad(struct ph_buf *buf, size_t from, size_t to) {
  while (from++ < to) {
    ph_buf_put(buf, " ", 1);
  }
}

/* "left   text", further lines of the text below the first. */
static void entry(struct ph_buf *buf, const char *left, const char *text) {
  size_t column = strlen(left);
  ph_buf_puts(buf, left);
  if (column + 2 > TEXT_COLUMN) {
    ph_buf_put(buf, "\n", 1);
    column = 0;
  }
  for (const char *line = text;;) {
    size_t n = strcspn(line, "\n");
    pad(buf, column, TEXT_COLUMN);
    ph_buf_put(buf, line, n);
    ph_buf_put(buf, "\n", 1);
    if (!line[n]) {
      return;
    }
    line += n + 1;
    column = 0;
  }
}

static void option_entry(struct ph_buf *buf, const struct ph_option *option) {
  char left[64] = "      --";
  if (option->letter) {
    left[2] = '-';
    left[3] = option->letter;
    left[4] = ',';
  }
  strcat(left, option->name);
  if (option->argument) {
    strcat(left, "=");
    strcat(left, option->argument);
  }
  entry(buf, left, option->help);
}

static void field_entry(struct ph_buf *buf, const struct ph_field *field) {
  char left[64] = "  ", text[256] = "";
  strcat(left, ph_field_name(field->id));
  strcat(text, field->help);
  if (field->words && strchr(field->words, '|')) {
    strcat(text, "\n(");
    strcat(text, field->words);
    strcat(text, ")");
  }
  if (field->required) {
    strcat(text, "; required");
  } else {
    strcat(text, "\n(default: ");
    strcat(text, field->standard);
    strcat(text, ")");
  }
  entry(buf, left, text);
}

static void statuses(struct ph_buf *buf) {
  ph_buf_puts(buf, "\nExit status:\n"
                   "  0  every problem solved\n"
                   "  1  at least one problem failed; all others are written\n"
                   "  2  usage error; nothing was read or written\n"
                   "  3  input could not be read, or broke off\n"
                   "  4  output could not be written\n"
                   "  5  out of memory, or an error in the program\n");
}

static void options(struct ph_buf *buf) {
  ph_buf_puts(buf, "\nOptions:\n");
  for (int i = 0; i < PH_OPTION_N; i++) {
    option_entry(buf, &ph_option_table[i]);
    if (i == PH_O_TABLE) {
#define X(symbol, name, what) entry(buf, "        " name, what);
      PH_TABLES(X)
#undef X
    }
  }
}

void ph_help_program(struct ph_buf *buf) {
  ph_buf_puts(buf,
              "Usage: phspline COMMAND [OPTION]... [FILE]...\n"
              "Interpolates points with curves whose arc length and offsets "
              "are exact.\n\nCommands:\n");
  for (size_t i = 0; i < ph_commands_n; i++) {
    const struct ph_method *method = ph_commands[i].method;
    char left[64] = "  ";
    strcat(left, method->schema.command);
    entry(buf, left, method->title);
  }
  entry(buf, "  help COMMAND", "the options and fields of a command");
  options(buf);
  ph_buf_puts(buf,
              "\nA FILE of -, or none, is standard input.  Problems are read "
              "as JSON, JSON Lines\nor CSV; each gives one result record, in "
              "order, whether it could be solved or not.\n");
  statuses(buf);
  ph_buf_puts(buf, "\nManual: man phspline, man phspline-planar, man 5 "
                   "phspline\n");
}

void ph_help_command(struct ph_buf *buf, const struct ph_command *command) {
  const struct ph_method *method = command->method;
  ph_buf_puts(buf, "Usage: phspline ");
  ph_buf_puts(buf, method->schema.command);
  ph_buf_puts(buf, " [OPTION]... [FILE]...\n");
  ph_buf_puts(buf, method->title);
  ph_buf_puts(buf,
              ".\n\nFields of a problem (each also an option, --FIELD=VALUE, "
              "the same as --set):\n");
  for (size_t i = 0; i < method->schema.fields_n; i++) {
    field_entry(buf, &method->schema.fields[i]);
  }
  entry(buf, "  id, meta", "copied to the result");
  options(buf);
  ph_buf_puts(buf, "\nExamples:\n");
  for (const char *line = command->examples; *line;) {
    size_t n = strcspn(line, "\n");
    ph_buf_puts(buf, "  ");
    ph_buf_put(buf, line, n + 1);
    line += n + 1;
  }
  statuses(buf);
  ph_buf_puts(buf, "\nManual: man phspline-");
  ph_buf_puts(buf, method->schema.command);
  ph_buf_puts(buf, "\n");
}

void ph_help_version(struct ph_buf *buf) {
  ph_buf_puts(buf, "phspline " PH_VERSION "\n"
                   "License GPL-3.0-or-later.  There is NO WARRANTY.\n");
}
