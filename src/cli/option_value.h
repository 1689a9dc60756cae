/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The arguments of options, between the two files that read the command line:
 * option.c knows which options there are, option_value.c what they may be. */
#ifndef PH_CLI_OPTION_VALUE_H
#define PH_CLI_OPTION_VALUE_H

#include "cli/option.h"

struct option;

/* What getopt_long needs, and where it stands. */
struct ph_option_parser {
  int argc;
  char **argv;
  struct ph_options *options;
  struct ph_diag *diag;
  struct option *longs; /* common options, then fields */
  char shorts[2 * PH_OPTION_N + 2];
  size_t argument_n;     /* upper bound for every list */
  const char *tolerance; /* the last argument of --tolerance, or NULL */
  const char *format;    /* and of --format */
  bool table;            /* --table was given */
  const char *loops;     /* an --offset-... about loops, or NULL */
};

/* More threads than this do not help anyone. */
enum { PH_JOBS_MAX = 1024 };

/* ph_option_read_part: --shard and --range, with getopt's optarg.
 * ret PH_OK | PH_E_USAGE */
enum ph_status ph_option_read_part(struct ph_option_parser *p,
                                   enum ph_option_id id);

/* ph_option_check_part: what does not go with these.
 * ret PH_OK | PH_E_USAGE */
enum ph_status ph_option_check_part(struct ph_option_parser *p);

/* ph_option_read_common, ph_option_read_field: what an option says, with
 * getopt's optarg or the text.  ret PH_OK | PH_E_USAGE | PH_E_NO_MEMORY */
enum ph_status ph_option_read_common(struct ph_option_parser *p,
                                     enum ph_option_id id);
enum ph_status ph_option_read_field(struct ph_option_parser *p,
                                    const struct ph_field *field,
                                    const char *text);

#endif
