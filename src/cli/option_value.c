/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the arguments of options may be (see option_value.h). */
#include "cli/option_value.h"

#include "base/suggest.h"
#include "cli/plot.h"
#include "cli/range.h"
#include "io/number.h"
#include "io/value.h"

#include <getopt.h>
#include <math.h>
#include <string.h>

/* More samples of a segment than this are a slip of the keyboard. */
enum { SAMPLES_MAX = 1000000 };

/* And more distances of a range. */
static const double OFFSETS_MAX = 1e6;

/* The most that the options about limits can allow: samples, bytes. */
enum { SAMPLES_LIMIT_MAX = 1000000000 };
static const double BYTES_MAX = 1e15;

/* ---- values ----------------------------------------------------------- */

/* One of the words of the option's argument text "a|b|c". */
static enum ph_status choose(struct ph_option_parser *p, enum ph_option_id id,
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
  return ph_fail(p->diag, PH_E_USAGE, NULL, "--%s must be %s, found '%s'%s",
                 ph_option_table[id].name, words,
                 ph_excerpt(optarg, n, excerpt), clause);
}

static enum ph_status read_count(struct ph_option_parser *p,
                                 enum ph_option_id id, int max, size_t *count) {
  const char *end = optarg + strlen(optarg);
  char excerpt[PH_EXCERPT_MAX];
  double x;
  if (ph_number_read_text(optarg, end, &x) != end || !(x >= 1) || !(x <= max) ||
      floor(x) < x) {
    return ph_fail(p->diag, PH_E_USAGE, NULL,
                   "--%s must be a whole number from 1 to %d, found '%s'",
                   ph_option_table[id].name, max,
                   ph_excerpt(optarg, strlen(optarg), excerpt));
  }
  *count = (size_t)x;
  return PH_OK;
}

/* A number of bytes, or with a suffix of units of 2^10, 2^20 or 2^30 bytes. */
static enum ph_status read_bytes(struct ph_option_parser *p,
                                 enum ph_option_id id, size_t *bytes) {
  static const char suffixes[] = "KMG";
  const size_t n = strlen(optarg);
  const char *suffix = n ? strchr(suffixes, optarg[n - 1]) : NULL;
  const char *end = optarg + n - (suffix ? 1 : 0);
  char excerpt[PH_EXCERPT_MAX];
  double x;
  if (ph_number_read_text(optarg, end, &x) == end) {
    x = suffix ? ldexp(x, 10 * (int)(suffix - suffixes + 1)) : x;
    if (x >= 1 && x <= BYTES_MAX && !(floor(x) < x)) {
      *bytes = (size_t)x;
      return PH_OK;
    }
  }
  return ph_fail(p->diag, PH_E_USAGE, NULL,
                 "--%s must be a whole number of bytes from 1 to %g, or one "
                 "of K, M or G, found '%s'",
                 ph_option_table[id].name, BYTES_MAX,
                 ph_excerpt(optarg, n, excerpt));
}

static enum ph_status read_positive(struct ph_option_parser *p,
                                    enum ph_option_id id, double *x) {
  const char *end = optarg + strlen(optarg);
  char excerpt[PH_EXCERPT_MAX];
  if (ph_number_read_text(optarg, end, x) != end || !(*x > 0) ||
      !isfinite(*x)) {
    return ph_fail(p->diag, PH_E_USAGE, NULL,
                   "--%s must be a number greater than 0, found '%s'",
                   ph_option_table[id].name,
                   ph_excerpt(optarg, strlen(optarg), excerpt));
  }
  return PH_OK;
}

static enum ph_status read_fill(struct ph_option_parser *p) {
  struct ph_options *o = p->options;
  const char *end = optarg + strlen(optarg);
  char excerpt[PH_EXCERPT_MAX];
  o->fill_given = true;
  return ph_number_read_text(optarg, end, &o->fill) == end && isfinite(o->fill)
             ? PH_OK
             : ph_fail(p->diag, PH_E_USAGE, NULL,
                       "--fill must be a number, found '%s'",
                       ph_excerpt(optarg, strlen(optarg), excerpt));
}

/* One of the three ways of taking samples. */
static enum ph_status read_samples(struct ph_option_parser *p,
                                   enum ph_option_id id) {
  struct ph_sample_rules *rules = &p->options->samples;
  enum ph_sampling how = id == PH_O_SAMPLE    ? PH_SAMPLE_PARAMETER
                         : id == PH_O_SPACING ? PH_SAMPLE_SPACING
                                              : PH_SAMPLE_CHORD;
  if (rules->how != PH_SAMPLE_NONE && rules->how != how) {
    return ph_fail(p->diag, PH_E_USAGE, NULL,
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

/* N, or NxM. */
static enum ph_status read_grid(struct ph_option_parser *p) {
  struct ph_grid_rules *rules = &p->options->grid;
  const char *times = strchr(optarg, 'x'), *end = optarg + strlen(optarg);
  char excerpt[PH_EXCERPT_MAX];
  double n, m = 0;
  const bool patches = p->options->command->use == PH_USE_PATCHES;
  bool ok = !(times && patches) &&
            ph_number_read_text(optarg, times ? times : end, &n) ==
                (times ? times : end);
  ok = ok &&
       (!times || (ph_number_read_text(times + 1, end, &m) == end && m >= 1));
  if (!ok || !(n >= 1 && n <= SAMPLES_MAX && m <= SAMPLES_MAX) ||
      floor(n) < n || floor(m) < m) {
    return ph_fail(p->diag, PH_E_USAGE, NULL,
                   patches
                       ? "--sample must be a whole number from 1 to %d, found "
                         "'%s'"
                       : "--sample must be one or two whole numbers from 1 to "
                         "%d, as 20 or 20x4, found '%s'",
                   SAMPLES_MAX, ph_excerpt(optarg, strlen(optarg), excerpt));
  }
  rules->along = (size_t)n;
  rules->across = (size_t)m;
  return PH_OK;
}

/* One distance, or a range of them.
 *
 * out  range  n = 1 of a number */
static enum ph_status read_distance(const char *at, const char *end,
                                    struct ph_range *range,
                                    struct ph_diag *diag) {
  char excerpt[PH_EXCERPT_MAX];
  *range = (struct ph_range){.n = 1};
  if (memchr(at, ':', (size_t)(end - at))) {
    return ph_range_read(at, (size_t)(end - at), OFFSETS_MAX, "--offset", range,
                         diag);
  }
  if (end == at || ph_number_read_text(at, end, &range->start) != end ||
      !isfinite(range->start)) {
    return ph_fail(diag, PH_E_USAGE, NULL, "--offset takes numbers, found '%s'",
                   ph_excerpt(optarg, strlen(optarg), excerpt));
  }
  return PH_OK;
}

/* All distances of the argument; NULL: how many there are. */
static enum ph_status read_distances(double *distance, size_t *n,
                                     struct ph_diag *diag) {
  const char *at = optarg, *end;
  *n = 0;
  do {
    struct ph_range range;
    end = at + strcspn(at, ",");
    if (read_distance(at, end, &range, diag) != PH_OK) {
      return PH_E_USAGE;
    }
    for (size_t i = 0; distance && i < range.n; i++) {
      distance[*n + i] = ph_range_at(&range, i);
    }
    *n += range.n;
    at = end + 1;
  } while (*end);
  return PH_OK;
}

static enum ph_status read_offsets(struct ph_option_parser *p) {
  struct ph_options *o = p->options;
  size_t more;
  double *all;
  if (read_distances(NULL, &more, p->diag) != PH_OK) {
    return PH_E_USAGE;
  }
  all = ph_arena_array(&o->arena, o->offsets_n + more, sizeof *all);
  if (!all) {
    return ph_fail_memory(p->diag);
  }
  if (o->offsets_n) {
    memcpy(all, o->offsets, o->offsets_n * sizeof *all);
  }
  o->offsets = all;
  read_distances(all + o->offsets_n, &more, p->diag);
  o->offsets_n += more;
  return PH_OK;
}

/* round, miter or miter:LIMIT. */
static enum ph_status read_join(struct ph_option_parser *p) {
  double *limit = &p->options->offset.miter;
  const char *at = optarg + strlen("miter"), *end = optarg + strlen(optarg);
  char excerpt[PH_EXCERPT_MAX];
  if (strcmp(optarg, "round") == 0) {
    *limit = 0;
    return PH_OK;
  }
  *limit = PH_MITER_LIMIT;
  if (strncmp(optarg, "miter", 5) == 0 &&
      (at == end || (*at == ':' && at + 1 < end &&
                     ph_number_read_text(at + 1, end, limit) == end &&
                     *limit >= 1 && isfinite(*limit)))) {
    return PH_OK;
  }
  return ph_fail(p->diag, PH_E_USAGE, NULL,
                 "--offset-join must be round, miter or miter:LIMIT with a "
                 "number of 1 or more, found '%s'",
                 ph_excerpt(optarg, strlen(optarg), excerpt));
}

/* The options about joined and trimmed offsets. */
static enum ph_status read_loops(struct ph_option_parser *p,
                                 enum ph_option_id id) {
  struct ph_offset_rules *rules = &p->options->offset;
  const char *words = ph_option_table[id].argument;
  size_t which = 0;
  enum ph_status status =
      id == PH_O_OFFSET_JOIN ? read_join(p) : choose(p, id, words, &which);
  if (id != PH_O_OFFSET_MODE) {
    p->loops = ph_option_table[id].name + strlen("offset-");
  }
  switch (id) {
  case PH_O_OFFSET_MODE:
    rules->mode = (enum ph_offset_mode)which;
    break;
  case PH_O_OFFSET_ENDS:
    rules->round_ends = which == 1;
    break;
  case PH_O_OFFSET_SIDES:
    rules->both = which == 1;
    break;
  case PH_O_OFFSET_TOUCHING:
    rules->keep = which == 1;
    break;
  default:
    break;
  }
  return status;
}

/* What options about CSV are about: results are JSON. */
static struct ph_split_options *input_of(struct ph_options *o) {
  return o->command->use == PH_USE_VERIFY ? &o->problems_input : &o->input;
}

/* A character, or the two characters \t, which are easier to type. */
static enum ph_status read_delimiter(struct ph_option_parser *p) {
  char excerpt[PH_EXCERPT_MAX];
  if (strlen(optarg) == 1) {
    input_of(p->options)->delimiter = optarg[0];
  } else if (strcmp(optarg, "\\t") == 0) {
    input_of(p->options)->delimiter = '\t';
  } else {
    return ph_fail(p->diag, PH_E_USAGE, NULL,
                   "--delimiter must be one character or \\t, found '%s'",
                   ph_excerpt(optarg, strlen(optarg), excerpt));
  }
  return PH_OK;
}

/* ---- fields ----------------------------------------------------------- */

/* A value for a field, from --set, --override or the field's own option. */
static enum ph_status assign(const struct ph_field *field, const char *option,
                             const char *text, struct ph_arena *arena,
                             struct ph_assignment *assignment,
                             struct ph_diag *diag) {
  struct ph_diag why;
  enum ph_status status =
      ph_value_read_option(text, field, arena, &assignment->value, &why);
  if (status == PH_E_NO_MEMORY) {
    return ph_fail_memory(diag);
  }
  if (status != PH_OK) {
    return ph_fail(diag, PH_E_USAGE, NULL, "%s: %s %s", option, why.field,
                   why.message);
  }
  assignment->field = field->id;
  assignment->json = ph_value_text(&assignment->value, arena);
  return assignment->json ? PH_OK : ph_fail_memory(diag);
}

enum ph_status ph_option_read_field(struct ph_option_parser *p,
                                    const struct ph_field *field,
                                    const char *text) {
  struct ph_options *o = p->options;
  struct ph_assignment *a = &o->assignments[o->assignments_n++];
  char option[64] = "--";
  strncat(option, ph_field_name(field->id), sizeof option - 3);
  a->text = NULL;
  a->override = false;
  return assign(field, option, text ? text : "", &o->arena, a, p->diag);
}

enum ph_status ph_option_assign(const struct ph_schema *schema,
                                struct ph_arena *arena,
                                struct ph_assignment *assignment,
                                struct ph_diag *diag) {
  const char *option = assignment->override ? "--override" : "--set";
  const char *text = assignment->text;
  size_t n = strcspn(text, "=");
  const struct ph_field *field = ph_command_field(schema, text, n);
  return field ? assign(field, option, text + n + 1, arena, assignment, diag)
               : ph_option_no_field(schema, option, text, n, diag);
}

/* Whether a field of that name belongs to any command. */
static bool is_field(const char *name, size_t n) {
  for (size_t i = 0; i < ph_commands_n; i++) {
    if (ph_command_field(ph_commands[i].schema, name, n)) {
      return true;
    }
  }
  return false;
}

/* FIELD=VALUE; read now, unless of verify. */
static enum ph_status read_assignment(struct ph_option_parser *p,
                                      enum ph_option_id id) {
  struct ph_options *o = p->options;
  struct ph_assignment *a = &o->assignments[o->assignments_n++];
  const char *option = id == PH_O_SET ? "--set" : "--override";
  char excerpt[PH_EXCERPT_MAX];
  size_t n = strcspn(optarg, "=");
  if (n == 0 || !optarg[n]) {
    return ph_fail(p->diag, PH_E_USAGE, NULL, "%s: '%s' is not FIELD=VALUE",
                   option, ph_excerpt(optarg, strlen(optarg), excerpt));
  }
  a->text = optarg;
  a->override = id == PH_O_OVERRIDE;
  if (o->command->use != PH_USE_VERIFY) {
    return ph_option_assign(o->command->schema, &o->arena, a, p->diag);
  }
  return is_field(optarg, n) ? PH_OK
                             : ph_fail(p->diag, PH_E_USAGE, NULL,
                                       "%s: no command has a field '%s'",
                                       option, ph_excerpt(optarg, n, excerpt));
}

static enum ph_status read_sweep(struct ph_option_parser *p) {
  struct ph_options *o = p->options;
  const struct ph_schema *schema = o->command->schema;
  struct ph_sweep *sweep = &o->sweeps[o->sweeps_n];
  enum ph_status status =
      ph_sweep_read(optarg, schema, &o->arena, sweep, p->diag);
  if (status != PH_OK) {
    return status;
  }
  for (size_t i = 0; i < o->sweeps_n; i++) {
    if (ph_sweep_same(&o->sweeps[i], sweep)) {
      return ph_fail(p->diag, PH_E_USAGE, NULL, "--sweep: %s is swept twice",
                     o->sweeps[i].name);
    }
  }
  o->sweeps_n++;
  o->sweep_count = ph_sweep_count(o->sweeps, o->sweeps_n);
  return o->sweep_count ? PH_OK
                        : ph_fail(p->diag, PH_E_USAGE, NULL,
                                  "--sweep: too many combinations");
}

/* ---- options ---------------------------------------------------------- */

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
  case PH_O_EDGES:
    return &o->edges;
  case PH_O_NURBS:
    return &o->nurbs;
  case PH_O_OFFSET_RANGE:
    return &o->offset_range;
  case PH_O_IF_CHANGED:
    return &o->if_changed;
  case PH_O_NO_SYNC:
    return &o->no_sync;
  case PH_O_WITH_FILE:
    return &o->with_file;
  case PH_O_IGNORE_COLUMNS:
    return &input_of(o)->ignore_columns;
  case PH_O_LABELS:
    return &o->labels;
  case PH_O_STRICT:
    return &o->strict;
  case PH_O_FAIL_FAST:
    return &o->fail_fast;
  case PH_O_PROGRESS:
    return &o->progress;
  case PH_O_QUIET:
    return &o->quiet;
  case PH_O_VERBOSE:
  case PH_O_VERBOSE_VERIFY:
    return &o->verbose;
  case PH_O_HELP:
    return &o->help;
  case PH_O_VERSION:
    return &o->version;
  default:
    return NULL;
  }
}

/* Options about what is read and written. */
static enum ph_status read_stream(struct ph_option_parser *p,
                                  enum ph_option_id id) {
  struct ph_options *o = p->options;
  const char *words = ph_option_table[id].argument;
  enum ph_status status = PH_OK;
  size_t which = 0;
  switch (id) {
  case PH_O_INPUT_FORMAT:
    status = choose(p, id, words, &which);
    o->input.format = (enum ph_split_format)which;
    break;
  case PH_O_SHARD:
  case PH_O_RANGE:
    return ph_option_read_part(p, id);
  case PH_O_FIELDS:
    return ph_chosen_read(optarg, ph_command_kind(o->command)->parts, &o->arena,
                          &o->chosen, p->diag);
  case PH_O_PROBLEMS:
    o->problems = optarg;
    break;
  case PH_O_PROBLEMS_FORMAT:
    status = choose(p, id, words, &which);
    o->problems_input.format = (enum ph_split_format)which;
    break;
  case PH_O_COLUMNS:
    input_of(o)->columns = optarg;
    break;
  case PH_O_DELIMITER:
    status = read_delimiter(p);
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
  case PH_O_OUTPUT:
    o->output = optarg;
    status = *optarg ? PH_OK
                     : ph_fail(p->diag, PH_E_USAGE, NULL,
                               "--output must be the name of a file");
    break;
  default:
    break;
  }
  return status;
}

/* What pictures are made of, and else of what is read and written. */
static enum ph_status read_picture(struct ph_option_parser *p,
                                   enum ph_option_id id) {
  struct ph_options *o = p->options;
  switch (id) {
  case PH_O_VOLUME:
  case PH_O_VOLUME_OF:
  case PH_O_PANORAMA:
    *(id == PH_O_PANORAMA ? &o->panorama : &o->volume_file) = optarg;
    return PH_OK;
  case PH_O_RESOLUTION:
    return read_positive(p, id, &o->resolution);
  case PH_O_FEED:
    return read_positive(p, id, &o->feed);
  case PH_O_FILL:
    return read_fill(p);
  case PH_O_PLOT:
    o->plot = optarg;
    return PH_OK;
  case PH_O_PLOT_SIZE:
    return ph_plot_read_size(optarg, o, p->diag);
  case PH_O_TITLE:
    o->title = optarg;
    return PH_OK;
  default:
    return read_stream(p, id);
  }
}

/* The other options with arguments. */
static enum ph_status read_argument(struct ph_option_parser *p,
                                    enum ph_option_id id) {
  struct ph_options *o = p->options;
  const char *words = ph_option_table[id].argument;
  enum ph_status status = PH_OK;
  size_t which = 0;
  switch (id) {
  case PH_O_SET:
  case PH_O_OVERRIDE:
    return read_assignment(p, id);
  case PH_O_SWEEP:
    return read_sweep(p);
  case PH_O_OFFSET:
  case PH_O_PARALLEL:
    return read_offsets(p);
  case PH_O_OFFSET_MODE:
  case PH_O_OFFSET_JOIN:
  case PH_O_OFFSET_ENDS:
  case PH_O_OFFSET_SIDES:
  case PH_O_OFFSET_TOUCHING:
    return read_loops(p, id);
  case PH_O_GRID:
  case PH_O_PATCH_GRID:
    return read_grid(p);
  case PH_O_CONVERT:
    o->convert = true;
    return choose(p, id, words, &which);
  case PH_O_TOLERANCE:
  case PH_O_FLAT:
  case PH_O_LIMIT:
    p->tolerance = optarg;
    return read_positive(p, id, &o->tolerance);
  case PH_O_JOBS:
    return read_count(p, id, PH_JOBS_MAX, &o->jobs);
  case PH_O_MAX_SAMPLES:
    status = read_count(p, id, SAMPLES_LIMIT_MAX, &o->samples.most);
    o->grid.most = o->samples.most;
    return status;
  case PH_O_MAX_MEMORY:
    return read_bytes(p, id, &o->max_memory);
  case PH_O_MAX_RECORD_BYTES:
    return read_bytes(p, id, &o->input.most);
  case PH_O_TIME_LIMIT:
    return read_positive(p, id, &o->time_limit);
  case PH_O_SAMPLE:
  case PH_O_SPACING:
  case PH_O_CHORD_ERROR:
    return read_samples(p, id);
  case PH_O_UNIT:
    status = choose(p, id, words, &which);
    o->unit = (enum ph_sheet_unit)(which + 1);
    return status;
  case PH_O_FRAME:
    status = choose(p, id, words, &which);
    o->samples.frame = (enum ph_frame)(which + 1);
    return status;
  default:
    return read_picture(p, id);
  }
}

enum ph_status ph_option_read_common(struct ph_option_parser *p,
                                     enum ph_option_id id) {
  bool *flag = flag_of(p->options, id);
  if (flag) {
    *flag = true;
    return PH_OK;
  }
  return read_argument(p, id);
}
