/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * phspline: finds the command, reads its options, runs it.
 *
 * The locale is never set: numbers have a decimal point everywhere.  GSL's
 * error handler, which aborts, is switched off before any thread exists; cJSON
 * allocates as we do.
 */
#include "base/mem.h"
#include "base/suggest.h"
#include "cli/help.h"
#include "cli/message.h"
#include "cli/output.h"
#include "cli/run.h"
#include "cli/schema.h"

#include <cjson/cJSON.h>
#include <gsl/gsl_errno.h>
#include <string.h>
#include <unistd.h>

/* Reports a failure; the exit status. */
static int report(const struct ph_diag *diag, const char *command) {
  struct ph_buf message = {0};
  enum ph_class class = ph_status_class(diag->status);
  ph_message_failure(&message, diag, command);
  class = message.failed ? PH_CLASS_INTERNAL : class;
  ph_message_send(&message);
  ph_buf_free(&message);
  return (int)class;
}

/* Writes a text that was asked for; the exit status. */
static int print(struct ph_buf *text) {
  struct ph_output output;
  struct ph_diag diag;
  enum ph_status status = text->failed ? ph_fail_memory(&diag) : PH_OK;
  if (status == PH_OK) {
    status = ph_output_open(&output, NULL, false, &diag);
  }
  if (status == PH_OK) {
    status = ph_output_write(&output, text->data, text->n, &diag);
  }
  if (status == PH_OK) {
    status = ph_output_commit(&output, &diag);
  }
  ph_buf_free(text);
  return status == PH_OK ? PH_CLASS_OK : report(&diag, NULL);
}

static int print_help(const struct ph_command *command) {
  struct ph_buf text = {0};
  if (command) {
    ph_help_command(&text, command);
  } else {
    ph_help_program(&text);
  }
  return print(&text);
}

static int print_schema(const struct ph_command *command) {
  struct ph_buf text = {0};
  ph_schema_text(&text, command);
  return print(&text);
}

static int print_version(void) {
  struct ph_buf text = {0};
  ph_help_version(&text);
  return print(&text);
}

/* A command line that makes no sense. */
static int refuse(const char *message, const char *command) {
  struct ph_diag diag;
  ph_fail(&diag, PH_E_USAGE, NULL, "%s", message);
  return report(&diag, command);
}

static int run_command(const struct ph_command *command, int argc,
                       char **argv) {
  struct ph_options options = {.command = command};
  const char *name = command->schema->command;
  struct ph_diag diag;
  int result;
  if (ph_options_read(argc, argv, &options, &diag) != PH_OK) {
    result = report(&diag, name);
  } else if (options.help) {
    result = print_help(command);
  } else if (options.version) {
    result = print_version();
  } else if (!options.files_given && isatty(STDIN_FILENO)) {
    result = refuse("no FILE, and standard input is a terminal", name);
  } else {
    result = ph_run(&options);
  }
  ph_options_free(&options);
  return result;
}

/* The first word is none that we know. */
static int unknown_word(const char *word) {
  bool option = word[0] == '-' && word[1];
  size_t n = option ? strcspn(word, "=") : strlen(word);
  size_t dashes = option ? strspn(word, "-") : 0;
  struct ph_suggest suggest;
  struct ph_diag diag;
  char excerpt[PH_EXCERPT_MAX], clause[PH_DID_YOU_MEAN_MAX];
  ph_suggest_init(&suggest, word + dashes, n - dashes);
  if (option && (strncmp(word, "--help=", 7) == 0 ||
                 strncmp(word, "--version=", 10) == 0)) {
    ph_fail(&diag, PH_E_USAGE, NULL, "option '%.*s' takes no value", (int)n,
            word);
    return report(&diag, NULL);
  }
  if (option) {
    ph_suggest_list(&suggest, "help|version");
  }
  for (size_t i = 0; !option && i < ph_commands_n; i++) {
    const char *candidate = ph_commands[i].schema->command;
    ph_suggest_try(&suggest, candidate, strlen(candidate));
  }
  if (!option) {
    ph_suggest_list(&suggest, "help|schema");
  }
  ph_did_you_mean(&suggest, clause);
  ph_fail(&diag, PH_E_USAGE, NULL, "unknown %s '%s'%s",
          option ? "option" : "command", ph_excerpt(word, n, excerpt), clause);
  return report(&diag, NULL);
}

/* phspline help WORD */
static int help_on(const char *word) {
  const struct ph_command *command = word ? ph_command_find(word) : NULL;
  bool itself = !word || strcmp(word, "help") == 0 ||
                strcmp(word, "schema") == 0 || strcmp(word, "--help") == 0 ||
                strcmp(word, "-h") == 0;
  return command || itself ? print_help(command) : unknown_word(word);
}

/* phspline schema [COMMAND] */
static int schema_of(int argc, char **argv) {
  const char *word = argc > 2 ? argv[2] : NULL;
  const struct ph_command *command = word ? ph_command_find(word) : NULL;
  if (argc > 3) {
    return refuse("schema takes one command", NULL);
  }
  return word && (strcmp(word, "--help") == 0 || strcmp(word, "-h") == 0)
             ? print_help(NULL)
         : command || !word ? print_schema(command)
                            : unknown_word(word);
}

int main(int argc, char **argv) {
  static cJSON_Hooks hooks = {ph_malloc, ph_free};
  const char *name = argc > 1 ? argv[1] : NULL;
  const struct ph_command *command;
  ph_output_prepare();
  ph_memory_keep();
  gsl_set_error_handler_off();
  cJSON_InitHooks(&hooks);
  if (!name) {
    return refuse("no command", NULL);
  }
  if (strcmp(name, "--version") == 0 || strcmp(name, "-V") == 0) {
    return print_version();
  }
  if (strcmp(name, "--help") == 0 || strcmp(name, "-h") == 0) {
    return print_help(NULL);
  }
  if (strcmp(name, "help") == 0) {
    return help_on(argc > 2 ? argv[2] : NULL);
  }
  if (strcmp(name, "schema") == 0) {
    return schema_of(argc, argv);
  }
  command = ph_command_find(name);
  return command ? run_command(command, argc - 1, argv + 1)
                 : unknown_word(name);
}
