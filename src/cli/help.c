/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Help and version texts (see help.h).
 *
 * Texts flow: words are set one after the other, and a line ends where the next
 * word does not fit.  The width is that of COLUMNS, if set, within bounds.
 */
#include "cli/help.h"

#include "base/version.h"
#include "cli/option.h"
#include "io/value.h"

#include <stdlib.h>
#include <string.h>

/* The column where texts on options begin. */
enum { TEXT_COLUMN = 28 };

/* Terminals of 80 columns are common; a text column of fewer than 32 is no
 * use, and lines of more than 120 are hard to read. */
enum { WIDTH_STANDARD = 80, WIDTH_MIN = 60, WIDTH_MAX = 120 };

/* A text that is being set. */
struct page {
  struct ph_buf *buf;
  size_t width;
  size_t column; /* where the next character goes */
};

static struct page page_of(struct ph_buf *buf) {
  const char *columns = getenv("COLUMNS");
  long width = columns ? strtol(columns, NULL, 10) : 0;
  width = width <= 0 ? WIDTH_STANDARD : width;
  width = width < WIDTH_MIN ? WIDTH_MIN : width;
  width = width > WIDTH_MAX ? WIDTH_MAX : width;
  return (struct page){buf, (size_t)width, 0};
}

/* One line or part of a line, as it is. */
static void put(struct page *page, const char *text, size_t n) {
  ph_buf_put(page->buf, text, n);
  page->column += n;
}

static void put_text(struct page *page, const char *text) {
  put(page, text, strlen(text));
}

static void end_line(struct page *page) {
  ph_buf_put(page->buf, "\n", 1);
  page->column = 0;
}

static void indent(struct page *page, size_t column) {
  while (page->column < column) {
    put(page, " ", 1);
  }
}

/* Words between blanks; lines begin at the column `left`. */
static void flow(struct page *page, size_t left, const char *text) {
  for (;;) {
    size_t n;
    text += strspn(text, " ");
    n = strcspn(text, " ");
    if (n == 0) {
      return;
    }
    if (page->column > left && page->column + 1 + n >= page->width) {
      end_line(page);
    }
    if (page->column > left) {
      put(page, " ", 1);
    }
    indent(page, left);
    put(page, text, n);
    text += n;
  }
}

/* Choices one|two|...; a line that begins with one begins at a column. */
static void put_choices(struct page *page, size_t left, const char *text) {
  while (*text) {
    size_t n = strcspn(text, "|");
    n += text[n] == '|';
    if (page->column + n > page->width) {
      end_line(page);
      indent(page, left);
    }
    put(page, text, n);
    text += n;
  }
}

static void paragraph(struct page *page, const char *text) {
  flow(page, 0, text);
  end_line(page);
}

static void heading(struct page *page, const char *text) {
  end_line(page);
  paragraph(page, text);
}

/* Goes to the column of the texts, on a new line if the name is too long. */
static void begin_text(struct page *page) {
  if (page->column + 2 > TEXT_COLUMN) {
    end_line(page);
  }
  indent(page, TEXT_COLUMN);
}

static void entry(struct page *page, size_t left, const char *name,
                  const char *text) {
  indent(page, left);
  put_text(page, name);
  begin_text(page);
  flow(page, TEXT_COLUMN, text);
  end_line(page);
}

static void option_entry(struct page *page, const struct ph_option *option) {
  char letter[] = "  -x, ";
  letter[3] = option->letter;
  put_text(page, option->letter ? letter : "      ");
  put_text(page, "--");
  put_text(page, option->name);
  if (option->argument) {
    put_text(page, "=");
    put_choices(page, page->column, option->argument);
  }
  entry(page, 0, "", option->help);
}

static void field_entry(struct page *page, const struct ph_field *field) {
  char phrase[PH_VALUE_PHRASE_MAX];
  indent(page, 2);
  put_text(page, ph_field_name(field->id));
  begin_text(page);
  flow(page, TEXT_COLUMN, field->help);
  put_text(page, ";");
  flow(page, TEXT_COLUMN, ph_value_describe(field, phrase));
  if (field->required) {
    flow(page, TEXT_COLUMN, "(required)");
  } else {
    flow(page, TEXT_COLUMN, "(default:");
    flow(page, TEXT_COLUMN, field->standard);
    put_text(page, ")");
  }
  end_line(page);
}

/* What the records of a command hold; nothing of one that has no fields. */
static void fields(struct page *page, const struct ph_schema *schema) {
  if (schema->fields_n == 0) {
    return;
  }
  heading(page, "Fields of a problem (each also an option: --FIELD=VALUE is "
                "--set=FIELD=VALUE):");
  for (size_t i = 0; i < schema->fields_n; i++) {
    field_entry(page, &schema->fields[i]);
  }
  entry(page, 2, "id, meta", "copied to the result (no options)");
}

/* The common options of a use, but for those that are fields, too; the tables
 * of what lies in a space, or all. */
static void options(struct page *page, const char *title, enum ph_use use,
                    const struct ph_schema *schema,
                    const enum ph_space *space) {
  heading(page, title);
  for (int i = 0; i < PH_OPTION_N; i++) {
    const struct ph_option *option = &ph_option_table[i];
    if (!(option->use & use) ||
        ph_field_find(schema, option->name, strlen(option->name))) {
      continue;
    }
    option_entry(page, option);
    if (i == PH_O_TABLE) {
#define X(symbol, name, what)                            \
  if (!space || ph_csv_has(PH_TABLE_##symbol, *space)) { \
    entry(page, 8, name, what);                          \
  }
      PH_TABLES(X)
#undef X
    }
  }
}

/* Lines "command, tab, what it does". */
static void examples(struct page *page, const char *text) {
  heading(page, "Examples:");
  while (*text) {
    size_t command = strcspn(text, "\t");
    size_t line = strcspn(text, "\n");
    indent(page, 2);
    put(page, text + command + 1, line - command - 1);
    put(page, ":", 1);
    end_line(page);
    indent(page, 4);
    put(page, text, command);
    end_line(page);
    text += line + 1;
  }
}

static void statuses(struct page *page, enum ph_use use) {
  bool verify = use == PH_USE_VERIFY;
  const char *const text[] = {
      verify ? "every result is right" : "every problem solved",
      verify ? "at least one is not, or could not be read; all were looked at"
             : "at least one problem failed; every other result was written",
      "usage error; nothing was read or written",
      "input could not be read, or was cut off by a syntax error",
      "output could not be written",
      "out of memory, or an error in the program",
  };
  heading(page, "Exit status (the highest that applies):");
  for (size_t i = 0; i < sizeof text / sizeof text[0]; i++) {
    char digit[] = "  0 ";
    digit[2] = (char)('0' + i);
    put_text(page, digit);
    flow(page, 5, text[i]);
    end_line(page);
  }
}

static void version_line(struct page *page) {
  paragraph(page, "phspline " PH_VERSION);
}

void ph_help_program(struct ph_buf *buf) {
  static const struct ph_schema no_fields = {"", NULL, 0};
  struct page page = page_of(buf);
  version_line(&page);
  paragraph(&page, "Usage: phspline COMMAND [OPTION]... [FILE]...");
  paragraph(&page, "Interpolates points with curves whose arc length and "
                   "offset curves are exact, and contact elements with "
                   "developable surfaces.");
  heading(&page, "Commands:");
  for (size_t i = 0; i < ph_commands_n; i++) {
    entry(&page, 2, ph_commands[i].schema->command, ph_commands[i].title);
  }
  entry(&page, 2, "help COMMAND", "the fields and options of a command");
  entry(&page, 2, "schema [COMMAND]",
        "a JSON Schema of the problems and results of a command, or of all");
  options(&page, "Options of the commands that make curves:", PH_USE_CURVE,
          &no_fields, NULL);
  heading(&page,
          "Problems are read from each FILE in turn, or from standard input "
          "where there is none or it is -, as JSON, JSON Lines or CSV. Each "
          "gives one result, in order, whether it could be solved or not.");
  statuses(&page, PH_USE_SOLVE);
  heading(&page, "Manual: man phspline, man phspline-COMMAND, man 5 phspline");
}

void ph_help_command(struct ph_buf *buf, const struct ph_command *command) {
  struct page page = page_of(buf);
  const struct ph_schema *schema = command->schema;
  enum ph_space space = PH_PLANE;
  version_line(&page);
  flow(&page, 0, "Usage: phspline");
  flow(&page, 0, schema->command);
  paragraph(&page, "[OPTION]... [FILE]...");
  put_text(&page, command->title);
  put_text(&page, ".");
  end_line(&page);
  fields(&page, schema);
  if (command->method) {
    space = ph_kind_space(ph_command_kind(command), command->method->dimension);
  }
  options(&page, "Options:", command->use, schema, &space);
  examples(&page, command->examples);
  statuses(&page, command->use);
  end_line(&page);
  put_text(&page, "Manual: man phspline-");
  put_text(&page, schema->command);
  end_line(&page);
}

void ph_help_version(struct ph_buf *buf) {
  struct page page = page_of(buf);
  version_line(&page);
  paragraph(&page, "License GPL-3.0-or-later. There is NO WARRANTY.");
}
