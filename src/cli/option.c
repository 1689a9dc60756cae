/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Reads the command line with getopt_long, from a table made of the common
 * options and the command's fields (see option.h).
 *
 * Long names are not abbreviated: an abbreviation that works today would be
 * ambiguous tomorrow.  getopt_long accepts them, so the name as typed is
 * compared afterwards.
 */
#define _GNU_SOURCE /* getopt_long; sysconf's _SC_NPROCESSORS_ONLN */
#include "cli/option.h"

#include "base/suggest.h"
#include "cli/plot.h"
#include "io/number.h"
#include "io/value.h"

#include <getopt.h>
#include <limits.h>
#include <math.h>
#include <string.h>
#include <unistd.h>

/* More threads than this do not help anyone. */
enum { JOBS_MAX = 1024 };

/* More samples of a segment than this are a slip of the keyboard. */
enum { SAMPLES_MAX = 1000000 };

const struct ph_option ph_option_table[PH_OPTION_N] = {
#define X(symbol, letter, name, argument, help) {letter, name, argument, help},
    PH_OPTIONS(X)
#undef X
};

/* What getopt_long needs, and where it stands. */
struct parser {
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
};

/* The tables that getopt_long reads; values are 256 + index into longs. */
static enum ph_status build_tables(struct parser *p) {
  const struct ph_method *method = p->options->command->method;
  size_t n = PH_OPTION_N + method->schema.fields_n, at = 0;
  char *s = p->shorts;
  p->longs = ph_arena_array(&p->options->arena, n + 1, sizeof *p->longs);
  if (!p->longs) {
    return ph_fail_memory(p->diag);
  }
  memset(p->longs, 0, (n + 1) * sizeof *p->longs);
  *s++ = ':';
  for (; at < PH_OPTION_N; at++) {
    const struct ph_option *o = &ph_option_table[at];
    p->longs[at].name = o->name;
    p->longs[at].has_arg = o->argument ? required_argument : no_argument;
    p->longs[at].val = 256 + (int)at;
    if (o->letter) {
      *s++ = o->letter;
      if (o->argument) {
        *s++ = ':';
      }
    }
  }
  *s = '\0';
  for (; at < n; at++) {
    const struct ph_field *f = &method->schema.fields[at - PH_OPTION_N];
    p->longs[at].name = ph_field_name(f->id);
    p->longs[at].has_arg =
        f->kinds & PH_BOOL ? optional_argument : required_argument;
    p->longs[at].val = 256 + (int)at;
  }
  return PH_OK;
}

/* ---- failures --------------------------------------------------------- */

static enum ph_status unknown_long(struct parser *p, const char *typed) {
  struct ph_suggest suggest;
  char clause[PH_DID_YOU_MEAN_MAX], excerpt[PH_EXCERPT_MAX];
  size_t n = strcspn(typed, "=");
  ph_suggest_init(&suggest, typed + 2, n - 2);
  for (const struct option *o = p->longs; o->name; o++) {
    ph_suggest_try(&suggest, o->name, strlen(o->name));
  }
  ph_did_you_mean(&suggest, clause);
  return ph_fail(p->diag, PH_USAGE, NULL, "unknown option '%s'%s",
                 ph_excerpt(typed, n, excerpt), clause);
}

static enum ph_status unknown_short(struct parser *p, int letter) {
  char excerpt[PH_EXCERPT_MAX], text = (char)letter;
  return ph_fail(p->diag, PH_USAGE, NULL, "unknown option '-%s'",
                 ph_excerpt(&text, 1, excerpt));
}

/* Whether a long option was typed with fewer letters than it has. */
static bool is_abbreviated(const struct parser *p, const char *typed,
                           int value) {
  return strncmp(typed, "--", 2) == 0 &&
         strcspn(typed + 2, "=") != strlen(p->longs[value - 256].name);
}

/* What getopt_long returned is no option with its value: '?' or ':'. */
static enum ph_status misused(struct parser *p, int why) {
  const char *typed = p->argv[optind - 1];
  if (optopt == 0 || (optopt >= 256 && is_abbreviated(p, typed, optopt))) {
    return unknown_long(p, typed);
  }
  if (optopt >= 256) {
    return ph_fail(p->diag, PH_USAGE, NULL, "option '--%s' %s",
                   p->longs[optopt - 256].name,
                   why == ':' ? "needs a value" : "takes no value");
  }
  return why == ':' ? ph_fail(p->diag, PH_USAGE, NULL,
                              "option '-%c' needs a value", optopt)
                    : unknown_short(p, optopt);
}

enum ph_status ph_option_no_field(const struct ph_schema *schema,
                                  const char *option, const char *name,
                                  size_t n, struct ph_diag *diag) {
  struct ph_suggest suggest;
  char clause[PH_DID_YOU_MEAN_MAX], excerpt[PH_EXCERPT_MAX];
  ph_suggest_init(&suggest, name, n);
  for (size_t i = 0; i < schema->fields_n; i++) {
    const char *candidate = ph_field_name(schema->fields[i].id);
    ph_suggest_try(&suggest, candidate, strlen(candidate));
  }
  ph_did_you_mean(&suggest, clause);
  return ph_fail(diag, PH_USAGE, NULL, "%s: %s has no field '%s'%s", option,
                 schema->command, ph_excerpt(name, n, excerpt), clause);
}

/* ---- values ----------------------------------------------------------- */

/* One of the words of the option's argument text "a|b|c". */
static enum ph_status choose(struct parser *p, enum ph_option_id id,
                             const char *words, size_t *which) {
  struct ph_suggest suggest;
  char clause[PH_DID_YOU_MEAN_MAX], excerpt[PH_EXCERPT_MAX];
  size_t n = strlen(optarg);
  *which = 0;
  for (const char *w = words; *w; w += w[strcspn(w, "|")] ? 1 : 0) {
    size_t length = strcspn(w, "|");
    if (length == n && memcmp(w, optarg, n) == 0) {
      return PH_OK;
    }
    w += length;
    ++*which;
  }
  ph_suggest_init(&suggest, optarg, n);
  ph_suggest_list(&suggest, words);
  ph_did_you_mean(&suggest, clause);
  return ph_fail(p->diag, PH_USAGE, NULL, "--%s must be %s, found '%s'%s",
                 ph_option_table[id].name, words,
                 ph_excerpt(optarg, n, excerpt), clause);
}

static enum ph_status read_count(struct parser *p, enum ph_option_id id,
                                 int max, size_t *count) {
  const char *end = optarg + strlen(optarg);
  char excerpt[PH_EXCERPT_MAX];
  double x;
  if (ph_number_read_text(optarg, end, &x) != end || !(x >= 1) || !(x <= max) ||
      floor(x) < x) {
    return ph_fail(p->diag, PH_USAGE, NULL,
                   "--%s must be a whole number from 1 to %d, found '%s'",
                   ph_option_table[id].name, max,
                   ph_excerpt(optarg, strlen(optarg), excerpt));
  }
  *count = (size_t)x;
  return PH_OK;
}

static enum ph_status read_positive(struct parser *p, enum ph_option_id id,
                                    double *x) {
  const char *end = optarg + strlen(optarg);
  char excerpt[PH_EXCERPT_MAX];
  if (ph_number_read_text(optarg, end, x) != end || !(*x > 0) ||
      !isfinite(*x)) {
    return ph_fail(p->diag, PH_USAGE, NULL,
                   "--%s must be a number greater than 0, found '%s'",
                   ph_option_table[id].name,
                   ph_excerpt(optarg, strlen(optarg), excerpt));
  }
  return PH_OK;
}

/* One of the three ways of taking samples. */
static enum ph_status read_samples(struct parser *p, enum ph_option_id id) {
  struct ph_sample_rules *rules = &p->options->samples;
  enum ph_sampling how = id == PH_O_SAMPLE    ? PH_SAMPLE_PARAMETER
                         : id == PH_O_SPACING ? PH_SAMPLE_SPACING
                                              : PH_SAMPLE_CHORD;
  if (rules->how != PH_SAMPLE_NONE && rules->how != how) {
    return ph_fail(p->diag, PH_USAGE, NULL,
                   "--sample, --spacing and --chord-error are alternatives");
  }
  rules->how = how;
  switch (how) {
  case PH_SAMPLE_PARAMETER:
    return read_count(p, id, SAMPLES_MAX, &rules->n);
  case PH_SAMPLE_SPACING:
    return read_positive(p, id, &rules->spacing);
  default:
    return read_positive(p, id, &rules->chord_error);
  }
}

static enum ph_status read_offsets(struct parser *p) {
  struct ph_options *o = p->options;
  size_t room = 1;
  char excerpt[PH_EXCERPT_MAX];
  double *all;
  const char *at = optarg, *end;
  for (const char *c = optarg; *c; c++) {
    room += *c == ',';
  }
  all = ph_arena_array(&o->arena, o->offsets_n + room, sizeof *all);
  if (!all) {
    return ph_fail_memory(p->diag);
  }
  if (o->offsets_n) {
    memcpy(all, o->offsets, o->offsets_n * sizeof *all);
  }
  o->offsets = all;
  for (; room-- > 0; at = end + 1) {
    double *x = &o->offsets[o->offsets_n++];
    end = at + strcspn(at, ",");
    if (end == at || ph_number_read_text(at, end, x) != end || !isfinite(*x)) {
      return ph_fail(p->diag, PH_USAGE, NULL,
                     "--offset takes numbers, found '%s'",
                     ph_excerpt(optarg, strlen(optarg), excerpt));
    }
  }
  return PH_OK;
}

/* A character, or the two characters \t, which are easier to type. */
static enum ph_status read_delimiter(struct parser *p) {
  char excerpt[PH_EXCERPT_MAX];
  if (strlen(optarg) == 1) {
    p->options->input.delimiter = optarg[0];
  } else if (strcmp(optarg, "\\t") == 0) {
    p->options->input.delimiter = '\t';
  } else {
    return ph_fail(p->diag, PH_USAGE, NULL,
                   "--delimiter must be one character or \\t, found '%s'",
                   ph_excerpt(optarg, strlen(optarg), excerpt));
  }
  return PH_OK;
}

/* A value for a field, from --set, --override or the field's own option. */
static enum ph_status assign(struct parser *p, const struct ph_field *field,
                             const char *option, const char *text,
                             bool override) {
  struct ph_options *o = p->options;
  struct ph_assignment *a = &o->assignments[o->assignments_n++];
  struct ph_diag diag;
  enum ph_status status =
      ph_value_read_option(text, field, &o->arena, &a->value, &diag);
  if (status == PH_NO_MEMORY) {
    return ph_fail_memory(p->diag);
  }
  if (status != PH_OK) {
    return ph_fail(p->diag, PH_USAGE, NULL, "%s: %s %s", option, diag.field,
                   diag.message);
  }
  a->field = field->id;
  a->override = override;
  return PH_OK;
}

/* FIELD=VALUE */
static enum ph_status read_assignment(struct parser *p, enum ph_option_id id) {
  const struct ph_schema *schema = &p->options->command->method->schema;
  const char *option = id == PH_O_SET ? "--set" : "--override";
  const struct ph_field *field;
  char excerpt[PH_EXCERPT_MAX];
  size_t n = strcspn(optarg, "=");
  if (n == 0 || !optarg[n]) {
    return ph_fail(p->diag, PH_USAGE, NULL, "%s: '%s' is not FIELD=VALUE",
                   option, ph_excerpt(optarg, strlen(optarg), excerpt));
  }
  field = ph_field_find(schema, optarg, n);
  return field ? assign(p, field, option, optarg + n + 1, id == PH_O_OVERRIDE)
               : ph_option_no_field(schema, option, optarg, n, p->diag);
}

static enum ph_status read_sweep(struct parser *p) {
  struct ph_options *o = p->options;
  const struct ph_schema *schema = &o->command->method->schema;
  struct ph_sweep *sweep = &o->sweeps[o->sweeps_n];
  enum ph_status status =
      ph_sweep_read(optarg, schema, &o->arena, sweep, p->diag);
  if (status != PH_OK) {
    return status;
  }
  for (size_t i = 0; i < o->sweeps_n; i++) {
    if (ph_sweep_same(&o->sweeps[i], sweep)) {
      return ph_fail(p->diag, PH_USAGE, NULL, "--sweep: %s is swept twice",
                     o->sweeps[i].name);
    }
  }
  o->sweeps_n++;
  o->sweep_count = ph_sweep_count(o->sweeps, o->sweeps_n);
  return o->sweep_count ? PH_OK
                        : ph_fail(p->diag, PH_USAGE, NULL,
                                  "--sweep: too many combinations");
}

/* The words of the tables as "a|b|c". */
static const char table_words[] =
#define X(symbol, name, what) "|" name
    PH_TABLES(X)
#undef X
    ;

/* The flag that an option without argument sets. */
static bool *flag_of(struct ph_options *o, enum ph_option_id id) {
  switch (id) {
  case PH_O_PRETTY:
    return &o->pretty;
  case PH_O_STRICT:
    return &o->strict;
  case PH_O_FAIL_FAST:
    return &o->fail_fast;
  case PH_O_PROGRESS:
    return &o->progress;
  case PH_O_QUIET:
    return &o->quiet;
  case PH_O_VERBOSE:
    return &o->verbose;
  case PH_O_HELP:
    return &o->help;
  case PH_O_VERSION:
    return &o->version;
  default:
    return NULL;
  }
}

static enum ph_status read_argument(struct parser *p, enum ph_option_id id) {
  struct ph_options *o = p->options;
  const char *words = ph_option_table[id].argument;
  enum ph_status status = PH_OK;
  size_t which = 0;
  switch (id) {
  case PH_O_INPUT_FORMAT:
    status = choose(p, id, words, &which);
    o->input.format = (enum ph_split_format)which;
    break;
  case PH_O_FORMAT:
    status = choose(p, id, words, &which);
    o->format = (enum ph_format)which;
    p->format = optarg;
    break;
  case PH_O_TABLE:
    status = choose(p, id, table_words + 1, &which);
    o->table = (enum ph_table)which;
    p->table = true;
    break;
  case PH_O_COLUMNS:
    o->input.columns = optarg;
    break;
  case PH_O_DELIMITER:
    status = read_delimiter(p);
    break;
  case PH_O_OUTPUT:
    o->output = optarg;
    status = *optarg ? PH_OK
                     : ph_fail(p->diag, PH_USAGE, NULL,
                               "--output must be the name of a file");
    break;
  case PH_O_SET:
  case PH_O_OVERRIDE:
    status = read_assignment(p, id);
    break;
  case PH_O_SWEEP:
    status = read_sweep(p);
    break;
  case PH_O_OFFSET:
    status = read_offsets(p);
    break;
  case PH_O_CONVERT:
    status = choose(p, id, words, &which);
    o->convert = true;
    break;
  case PH_O_TOLERANCE:
    status = read_positive(p, id, &o->tolerance);
    p->tolerance = optarg;
    break;
  case PH_O_JOBS:
    status = read_count(p, id, JOBS_MAX, &o->jobs);
    break;
  case PH_O_SAMPLE:
  case PH_O_SPACING:
  case PH_O_CHORD_ERROR:
    status = read_samples(p, id);
    break;
  case PH_O_FRAME:
    status = choose(p, id, words, &which);
    o->samples.frame = (enum ph_frame)(which + 1);
    break;
  case PH_O_PLOT:
    o->plot = optarg;
    break;
  case PH_O_PLOT_SIZE:
    status = ph_plot_read_size(optarg, o, p->diag);
    break;
  default:
    break;
  }
  return status;
}

static enum ph_status read_field(struct parser *p, const struct ph_field *field,
                                 const char *text) {
  char option[64] = "--";
  strncat(option, ph_field_name(field->id), sizeof option - 3);
  return assign(p, field, option, text ? text : "", false);
}

static enum ph_status read_common(struct parser *p, enum ph_option_id id) {
  bool *flag = flag_of(p->options, id);
  if (flag) {
    *flag = true;
    return PH_OK;
  }
  return read_argument(p, id);
}

/* --tolerance is the field of that name, too, where the command has one, but
 * not beside --convert, of which it then is the tolerance. */
static enum ph_status assign_tolerance(struct parser *p) {
  const char *name = ph_option_table[PH_O_TOLERANCE].name;
  const struct ph_field *field =
      ph_field_find(&p->options->command->method->schema, name, strlen(name));
  return field && p->tolerance && !p->options->convert
             ? read_field(p, field, p->tolerance)
             : PH_OK;
}

/* One option that getopt_long returned. */
static enum ph_status read_option(struct parser *p, int value) {
  const struct ph_field *fields = p->options->command->method->schema.fields;
  bool apart = optarg && optarg == p->argv[optind - 1];
  const char *typed = p->argv[optind - (apart ? 2 : 1)];
  if (value == '?' || value == ':') {
    return misused(p, value);
  }
  if (value < 256) {
    for (int i = 0; i < PH_OPTION_N; i++) {
      if (ph_option_table[i].letter == value) {
        return read_common(p, (enum ph_option_id)i);
      }
    }
  }
  if (is_abbreviated(p, typed, value)) {
    return unknown_long(p, typed);
  }
  value -= 256;
  return value < PH_OPTION_N
             ? read_common(p, (enum ph_option_id)value)
             : read_field(p, &fields[value - PH_OPTION_N], optarg);
}

/* Options that contradict each other. */
static enum ph_status check_together(struct parser *p) {
  struct ph_options *o = p->options;
  const struct ph_method *method = o->command->method;
  if (p->table && !p->format) {
    o->format = PH_FORMAT_CSV;
  }
  if (p->table && o->format != PH_FORMAT_CSV && o->format != PH_FORMAT_TEXT) {
    return ph_fail(p->diag, PH_USAGE, NULL,
                   "--table needs --format=csv or --format=text");
  }
  if (o->pretty && o->format != PH_FORMAT_JSON) {
    return ph_fail(p->diag, PH_USAGE, NULL, "--pretty needs --format=json");
  }
  if (o->table == PH_TABLE_OFFSETS && !o->offsets_n) {
    return ph_fail(p->diag, PH_USAGE, NULL, "--table=offsets needs --offset");
  }
  if (o->table == PH_TABLE_SAMPLES && o->samples.how == PH_SAMPLE_NONE) {
    return ph_fail(p->diag, PH_USAGE, NULL,
                   "--table=samples needs --sample, --spacing or "
                   "--chord-error");
  }
  if (o->samples.frame && o->samples.how == PH_SAMPLE_NONE) {
    return ph_fail(p->diag, PH_USAGE, NULL,
                   "--frame needs --sample, --spacing or --chord-error");
  }
  if (o->samples.frame && method->dimension == 2) {
    return ph_fail(p->diag, PH_USAGE, NULL,
                   "--frame: the curves of %s are in the plane, where the "
                   "normal is (-ty,tx)",
                   method->schema.command);
  }
  if (o->samples.frame == PH_FRAME_ERF && method->on_sphere) {
    return ph_fail(p->diag, PH_USAGE, NULL,
                   "--frame: the curves of %s have no Euler-Rodrigues frame; "
                   "take rmf or frenet",
                   method->schema.command);
  }
  if (o->convert && !o->command->convert) {
    return ph_fail(p->diag, PH_USAGE, NULL,
                   "--convert: the curves of %s are no Bezier curves",
                   o->command->method->schema.command);
  }
  return ph_plot_check(o, p->diag);
}

static size_t processors(void) {
  long n = sysconf(_SC_NPROCESSORS_ONLN);
  return n < 1 ? 1 : n > JOBS_MAX ? JOBS_MAX : (size_t)n;
}

enum ph_status ph_options_read(int argc, char **argv,
                               struct ph_options *options,
                               struct ph_diag *diag) {
  static char *standard_input[] = {"-"};
  struct parser p = {argc, argv,         options, diag, NULL,
                     "",   (size_t)argc, NULL,    NULL, false};
  enum ph_status status = build_tables(&p);
  int value;
  options->sweep_count = 1;
  options->jobs = processors();
  options->assignments = ph_arena_array(&options->arena, p.argument_n,
                                        sizeof *options->assignments);
  options->sweeps =
      ph_arena_array(&options->arena, p.argument_n, sizeof *options->sweeps);
  if (!options->assignments || !options->sweeps) {
    return ph_fail_memory(diag);
  }
  opterr = 0;
  optind = 0; /* anew, also after a command line that ended in an error */
  while (status == PH_OK &&
         (value = getopt_long(argc, argv, p.shorts, p.longs, NULL)) != -1) {
    status = read_option(&p, value);
    if (options->help || options->version) {
      return PH_OK;
    }
  }
  options->files =
      (const char *const *)(optind < argc ? argv + optind : standard_input);
  options->files_n = optind < argc ? (size_t)(argc - optind) : 1;
  options->files_given = optind < argc;
  if (status == PH_OK) {
    status = assign_tolerance(&p);
  }
  return status == PH_OK ? check_together(&p) : status;
}

struct ph_csv_shape ph_options_shape(const struct ph_options *options) {
  const struct ph_method *method = options->command->method;
  return (struct ph_csv_shape){
      options->table,     options->format == PH_FORMAT_TEXT,
      method->dimension,  method->on_sphere,
      options->offsets_n, options->samples.frame != PH_FRAME_NONE};
}

void ph_options_free(struct ph_options *options) {
  ph_arena_free(&options->arena);
}
