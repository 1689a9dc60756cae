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
#include "cli/option_value.h"

#include "base/suggest.h"
#include "cli/panorama.h"
#include "cli/plot.h"

#include <getopt.h>
#include <stdint.h>
#include <string.h>
#include <unistd.h>

/* Feeds that are no slip of the keyboard, mm a minute. */
static const double FEED_MIN = 1e-6, FEED_MAX = 1e9;

const struct ph_option ph_option_table[PH_OPTION_N] = {
#define X(symbol, use, letter, name, argument, help) \
  {PH_USE_##use, letter, name, argument, help},
    PH_OPTIONS(X)
#undef X
};

/* The common options of the command. */
static struct option *add_options(struct ph_option_parser *p,
                                  struct option *to) {
  char *s = p->shorts;
  *s++ = ':';
  for (int i = 0; i < PH_OPTION_N; i++) {
    const struct ph_option *o = &ph_option_table[i];
    if (!(o->use & p->options->command->use)) {
      continue;
    }
    to->name = o->name;
    to->has_arg = o->argument ? required_argument : no_argument;
    to->val = 256 + i;
    to++;
    if (o->letter) {
      *s++ = o->letter;
      if (o->argument) {
        *s++ = ':';
      }
    }
  }
  *s = '\0';
  return to;
}

/* A name with dashes in place of underscores; NULL: it has none, or (*failed)
 * memory is exhausted. */
static const char *with_dashes(const char *name, struct ph_arena *arena,
                               bool *failed) {
  char *dashes;
  if (!strchr(name, '_')) {
    return NULL;
  }
  dashes = ph_arena_copy(arena, name, strlen(name));
  *failed |= !dashes;
  for (char *c = dashes; c && *c; c++) {
    *c = *c == '_' ? '-' : *c;
  }
  return dashes;
}

/* The tables that getopt_long reads; values are 256 + id, of the fields 256 +
 * PH_OPTION_N + index; fields have two names where they have underscores. */
static enum ph_status build_tables(struct ph_option_parser *p) {
  const struct ph_schema *schema = p->options->command->schema;
  size_t n = PH_OPTION_N + 2 * schema->fields_n + 1;
  struct option *to, *fields;
  bool failed = false;
  p->longs = ph_arena_array(&p->options->arena, n, sizeof *p->longs);
  if (!p->longs) {
    return ph_fail_memory(p->diag);
  }
  memset(p->longs, 0, n * sizeof *p->longs);
  fields = to = add_options(p, p->longs);
  for (size_t i = 0; i < schema->fields_n; i++, to++) {
    const struct ph_field *f = &schema->fields[i];
    to->name = ph_field_name(f->id);
    to->has_arg = f->kinds & PH_BOOL ? optional_argument : required_argument;
    to->val = 256 + PH_OPTION_N + (int)i;
  }
  for (size_t i = 0; i < schema->fields_n; i++) {
    *to = fields[i];
    to->name = with_dashes(fields[i].name, &p->options->arena, &failed);
    to += to->name != NULL;
  }
  to->name = NULL;
  return failed ? ph_fail_memory(p->diag) : PH_OK;
}

/* The long name of an option or field. */
static const char *name_of(const struct ph_option_parser *p, int value) {
  const struct ph_field *fields = p->options->command->schema->fields;
  value -= 256;
  return value < PH_OPTION_N ? ph_option_table[value].name
                             : ph_field_name(fields[value - PH_OPTION_N].id);
}

/* ---- failures --------------------------------------------------------- */

/* What other commands have: an option, or a field of that one. */
static enum ph_status not_here(struct ph_option_parser *p, const char *dashes,
                               const char *name, size_t n, const char *there) {
  return ph_fail(p->diag, PH_E_USAGE, NULL, "%s has no option '%s%.*s'%s%s",
                 p->options->command->schema->command, dashes, (int)n, name,
                 there ? ", but there is one of " : "", there ? there : "");
}

static enum ph_status unknown_long(struct ph_option_parser *p,
                                   const char *typed) {
  struct ph_suggest suggest;
  char clause[PH_DID_YOU_MEAN_MAX], excerpt[PH_EXCERPT_MAX];
  size_t n = strcspn(typed, "=");
  for (int i = 0; i < PH_OPTION_N; i++) {
    const struct ph_option *o = &ph_option_table[i];
    if (!(o->use & p->options->command->use) && strlen(o->name) == n - 2 &&
        memcmp(o->name, typed + 2, n - 2) == 0) {
      return not_here(p, "--", o->name, n - 2, NULL);
    }
  }
  for (size_t i = 0; i < ph_commands_n; i++) {
    const struct ph_schema *schema = ph_commands[i].schema;
    if (ph_command_field(schema, typed + 2, n - 2)) {
      return not_here(p, "--", typed + 2, n - 2, schema->command);
    }
  }
  ph_suggest_init(&suggest, typed + 2, n - 2);
  for (const struct option *o = p->longs; o->name; o++) {
    ph_suggest_try(&suggest, o->name, strlen(o->name));
  }
  ph_did_you_mean(&suggest, clause);
  return ph_fail(p->diag, PH_E_USAGE, NULL, "unknown option '%s'%s",
                 ph_excerpt(typed, n, excerpt), clause);
}

static enum ph_status unknown_short(struct ph_option_parser *p, int letter) {
  char excerpt[PH_EXCERPT_MAX], text = (char)letter;
  for (int i = 0; i < PH_OPTION_N; i++) {
    if (ph_option_table[i].letter == letter) {
      return not_here(p, "-", &text, 1, NULL);
    }
  }
  return ph_fail(p->diag, PH_E_USAGE, NULL, "unknown option '-%s'",
                 ph_excerpt(&text, 1, excerpt));
}

/* Whether a long option was typed with fewer letters than it has. */
static bool is_abbreviated(const struct ph_option_parser *p, const char *typed,
                           int value) {
  return strncmp(typed, "--", 2) == 0 &&
         strcspn(typed + 2, "=") != strlen(name_of(p, value));
}

/* What getopt_long returned is no option with its value: '?' or ':'. */
static enum ph_status misused(struct ph_option_parser *p, int why) {
  const char *typed = p->argv[optind - 1];
  if (optopt == 0 || (optopt >= 256 && is_abbreviated(p, typed, optopt))) {
    return unknown_long(p, typed);
  }
  if (optopt >= 256) {
    return ph_fail(p->diag, PH_E_USAGE, NULL, "option '--%s' %s",
                   name_of(p, optopt),
                   why == ':' ? "needs a value" : "takes no value");
  }
  return why == ':' ? ph_fail(p->diag, PH_E_USAGE, NULL,
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
  return ph_fail(diag, PH_E_USAGE, NULL, "%s: %s has no field '%s'%s", option,
                 schema->command, ph_excerpt(name, n, excerpt), clause);
}

/* ---- the whole -------------------------------------------------------- */

/* --tolerance is the field of that name, too, where the command has one, but
 * not beside --convert, of which it then is the tolerance. */
static enum ph_status assign_tolerance(struct ph_option_parser *p) {
  const char *name = ph_option_table[PH_O_TOLERANCE].name;
  const struct ph_field *field =
      ph_field_find(p->options->command->schema, name, strlen(name));
  return field && p->tolerance && !p->options->convert
             ? ph_option_read_field(p, field, p->tolerance)
             : PH_OK;
}

/* One option that getopt_long returned. */
static enum ph_status read_option(struct ph_option_parser *p, int value) {
  const struct ph_field *fields = p->options->command->schema->fields;
  bool apart = optarg && optarg == p->argv[optind - 1];
  const char *typed = p->argv[optind - (apart ? 2 : 1)];
  if (value == '?' || value == ':') {
    return misused(p, value);
  }
  if (value < 256) {
    for (int i = 0; i < PH_OPTION_N; i++) {
      if (ph_option_table[i].letter == value &&
          ph_option_table[i].use & p->options->command->use) {
        return ph_option_read_common(p, (enum ph_option_id)i);
      }
    }
  }
  if (is_abbreviated(p, typed, value)) {
    return unknown_long(p, typed);
  }
  value -= 256;
  return value < PH_OPTION_N
             ? ph_option_read_common(p, (enum ph_option_id)value)
             : ph_option_read_field(p, &fields[value - PH_OPTION_N], optarg);
}

/* Options of verify that make no sense together. */
static enum ph_status check_problems(struct ph_option_parser *p) {
  const struct ph_options *o = p->options;
  const struct ph_split_options *input = &o->problems_input;
  bool about = o->assignments_n || input->format != PH_SPLIT_AUTO ||
               input->columns || input->delimiter || input->ignore_columns;
  if (!o->problems && about) {
    return ph_fail(p->diag, PH_E_USAGE, NULL,
                   "--input-format, --columns, --ignore-columns, "
                   "--delimiter, --set and --override are about the file of "
                   "--problems");
  }
  for (size_t i = 0; o->problems && i < o->files_n; i++) {
    if (strcmp(o->problems, "-") == 0 && strcmp(o->files[i], "-") == 0) {
      return ph_fail(p->diag, PH_E_USAGE, NULL,
                     "problems and results cannot both be standard input");
    }
  }
  return PH_OK;
}

static enum ph_space space_of(const struct ph_options *o) {
  return ph_kind_space(ph_command_kind(o->command),
                       o->command->method->dimension);
}

/* Whether samples are asked for: by an option, or the field at. */
static bool has_samples(const struct ph_options *o) {
  bool has = o->samples.how != PH_SAMPLE_NONE || o->grid.along > 0;
  for (size_t i = 0; i < o->assignments_n; i++) {
    has = has || o->assignments[i].field == PH_F_AT;
  }
  return has;
}

/* Tables and formats that are of surfaces, or of curves. */
static enum ph_status check_printed(struct ph_option_parser *p) {
  struct ph_options *o = p->options;
  const bool surface = space_of(o) == PH_SURFACE;
  const bool patches = space_of(o) == PH_PATCHWORK;
  if ((surface || patches) && !p->table) {
    o->table = surface ? PH_TABLE_STRIPS : PH_TABLE_PATCHES;
  }
  if (p->table && !ph_csv_has(o->table, space_of(o))) {
    return ph_fail(p->diag, PH_E_USAGE, NULL,
                   surface
                       ? "--table: the surfaces of %s have strips, samples, "
                         "development and located"
                   : patches ? "--table: the surfaces of %s have patches, "
                               "samples and edges"
                             : "--table: strips, development, located, "
                               "patches and edges are of surfaces, %s makes "
                               "curves",
                   o->command->schema->command);
  }
  o->edges = o->edges || (p->table && o->table == PH_TABLE_EDGES);
  if (patches && ph_formats[o->format].is_cubics) {
    return ph_fail(p->diag, PH_E_USAGE, NULL,
                   "--format=%s is not of surfaces of patches",
                   ph_format_name(o->format));
  }
  if ((surface || patches) && ph_formats[o->format].is_lines) {
    return ph_fail(p->diag, PH_E_USAGE, NULL,
                   "--format=%s is of curves, %s makes surfaces",
                   ph_format_name(o->format), o->command->schema->command);
  }
  if (ph_formats[o->format].is_mesh && !surface && !patches) {
    return ph_fail(p->diag, PH_E_USAGE, NULL,
                   "--format=%s is of surfaces, %s makes curves",
                   ph_format_name(o->format), o->command->schema->command);
  }
  if (o->table == PH_TABLE_SAMPLES && !has_samples(o)) {
    return ph_fail(p->diag, PH_E_USAGE, NULL,
                   surface || patches
                       ? "--table=samples needs --sample"
                       : "--table=samples needs --sample, --spacing, "
                         "--chord-error or --at");
  }
  return PH_OK;
}

/* Options about offsets. */
static enum ph_status check_offsets(struct ph_option_parser *p) {
  const struct ph_options *o = p->options;
  const bool loops = o->offset.mode != PH_OFFSET_RAW;
  if (space_of(o) == PH_PATCHWORK && o->offsets_n && !o->grid.along &&
      !ph_formats[o->format].is_mesh) {
    return ph_fail(p->diag, PH_E_USAGE, NULL,
                   "--offset needs --sample, or a format of meshes: surfaces "
                   "beside those of %s are samples",
                   o->command->schema->command);
  }
  if (!loops && p->loops) {
    return ph_fail(p->diag, PH_E_USAGE, NULL,
                   "--offset-%s needs --offset-mode=joined or trimmed",
                   p->loops);
  }
  if ((loops || o->table == PH_TABLE_OFFSETS) && !o->offsets_n) {
    return ph_fail(p->diag, PH_E_USAGE, NULL, "%s needs --offset",
                   loops ? "--offset-mode" : "--table=offsets");
  }
  return PH_OK;
}

/* Frames of samples. */
static enum ph_status check_frame(struct ph_option_parser *p) {
  const struct ph_options *o = p->options;
  if (o->samples.frame && !has_samples(o)) {
    return ph_fail(p->diag, PH_E_USAGE, NULL,
                   "--frame needs --sample, --spacing, --chord-error or --at");
  }
  if (o->samples.frame && ph_formats[o->format].is_lines) {
    return ph_fail(p->diag, PH_E_USAGE, NULL, "--format=%s has no frames",
                   ph_format_name(o->format));
  }
  if (o->samples.frame && o->command->method->dimension == 2) {
    return ph_fail(p->diag, PH_E_USAGE, NULL,
                   "--frame: the curves of %s are in the plane, where the "
                   "normal is (-ty,tx)",
                   o->command->schema->command);
  }
  if (o->samples.frame == PH_FRAME_ERF && !ph_command_kind(o->command)->erf) {
    return ph_fail(p->diag, PH_E_USAGE, NULL,
                   "--frame: the curves of %s have no Euler-Rodrigues frame; "
                   "take rmf or frenet",
                   o->command->schema->command);
  }
  return PH_OK;
}

/* B-splines, as a format or beside the curve; and what else is beside it. */
static enum ph_status check_nurbs(struct ph_option_parser *p) {
  const struct ph_options *o = p->options;
  const struct ph_format_row *format = &ph_formats[o->format];
  const enum ph_space space = space_of(o);
  const char *name = ph_format_name(o->format);
  if (o->unit && !format->is_sheet) {
    return ph_fail(p->diag, PH_E_USAGE, NULL,
                   "--unit needs --format=svg or --format=dxf");
  }
  if (format->is_nurbs && space == PH_PATCHWORK) {
    return ph_fail(p->diag, PH_E_USAGE, NULL,
                   "--format=%s is of curves, %s makes surfaces", name,
                   o->command->schema->command);
  }
  if (format->is_nurbs && o->samples.how != PH_SAMPLE_NONE) {
    return ph_fail(p->diag, PH_E_USAGE, NULL,
                   "--format=%s has no samples; it is of exact curves, or "
                   "within --tolerance",
                   name);
  }
  if (o->nurbs && !format->is_objects) {
    return ph_fail(p->diag, PH_E_USAGE, NULL, "--nurbs needs --format=json");
  }
  if (o->offset_range && (!format->is_objects || space != PH_PLANE)) {
    return ph_fail(p->diag, PH_E_USAGE, NULL,
                   "--offset-range is of curves in the plane, and needs "
                   "--format=json");
  }
  if ((o->nurbs || format->is_nurbs) && o->convert) {
    return ph_fail(p->diag, PH_E_USAGE, NULL,
                   "B-splines are of the curve as it was found; --convert does "
                   "nothing there");
  }
  return PH_OK;
}

/* The lines of roads, and moves. */
static enum ph_status check_drive(struct ph_option_parser *p) {
  const struct ph_options *o = p->options;
  const struct ph_format_row *format = &ph_formats[o->format];
  const char *name = ph_format_name(o->format);
  const char *command = o->command->schema->command;
  if (format->is_road && !ph_command_kind(o->command)->cubic) {
    return ph_fail(p->diag, PH_E_USAGE, NULL,
                   "--format=%s is of plane cubics, which %s does not make: tc "
                   "does",
                   name, command);
  }
  if (format->is_road && (o->samples.how || o->offsets_n || o->convert)) {
    return ph_fail(p->diag, PH_E_USAGE, NULL,
                   "--format=%s is of the curve itself, without samples and "
                   "offsets",
                   name);
  }
  if (format->is_moves && space_of(o) != PH_PLANE) {
    return ph_fail(p->diag, PH_E_USAGE, NULL,
                   "--format=%s is of curves in the plane, those of planar and "
                   "tc",
                   name);
  }
  if (format->is_moves && (o->samples.how == PH_SAMPLE_PARAMETER ||
                           o->samples.how == PH_SAMPLE_SPACING || o->convert)) {
    return ph_fail(p->diag, PH_E_USAGE, NULL,
                   "--format=%s has no samples; --chord-error says how near "
                   "moves are to the curve",
                   name);
  }
  if (format->is_moves != (o->feed > 0)) {
    return ph_fail(p->diag, PH_E_USAGE, NULL,
                   format->is_moves ? "--format=gcode needs --feed"
                                    : "--feed needs --format=gcode");
  }
  if (format->is_moves && !(o->feed >= FEED_MIN && o->feed <= FEED_MAX)) {
    return ph_fail(p->diag, PH_E_USAGE, NULL,
                   "--feed must be from %g to %g mm a minute", FEED_MIN,
                   FEED_MAX);
  }
  return PH_OK;
}

/* Options about tables. */
static enum ph_status check_tables(struct ph_option_parser *p) {
  const struct ph_options *o = p->options;
  const struct ph_format_row *format = &ph_formats[o->format];
  if (format->is_binary && !o->output) {
    return ph_fail(p->diag, PH_E_USAGE, NULL, "--format=%s needs --output",
                   ph_format_name(o->format));
  }
  if (o->with_file && (!format->is_table || format->is_binary)) {
    return ph_fail(p->diag, PH_E_USAGE, NULL,
                   "--with-file needs --format=csv or --format=text");
  }
  return PH_OK;
}

/* Options that contradict each other. */
static enum ph_status check_together(struct ph_option_parser *p) {
  struct ph_options *o = p->options;
  const struct ph_format_row *format;
  enum ph_status status;
  if (p->table && !p->format) {
    o->format = PH_FORMAT_CSV;
  }
  format = &ph_formats[o->format];
  if (p->table && !format->is_table) {
    return ph_fail(p->diag, PH_E_USAGE, NULL,
                   "--table needs --format=csv, text or npy");
  }
  if (check_printed(p) != PH_OK) {
    return PH_E_USAGE;
  }
  if (format->is_cubics && (o->samples.how == PH_SAMPLE_PARAMETER ||
                            o->samples.how == PH_SAMPLE_SPACING)) {
    return ph_fail(p->diag, PH_E_USAGE, NULL,
                   "--format=%s has no samples; --chord-error says how near "
                   "paths are to the curve",
                   ph_format_name(o->format));
  }
  if (format->is_cubics && o->convert) {
    return ph_fail(p->diag, PH_E_USAGE, NULL,
                   "--format=%s is of cubics; --convert does nothing there",
                   ph_format_name(o->format));
  }
  if (check_nurbs(p) != PH_OK || check_drive(p) != PH_OK) {
    return PH_E_USAGE;
  }
  if (check_tables(p) != PH_OK) {
    return PH_E_USAGE;
  }
  if (o->chosen && !format->is_objects) {
    return ph_fail(p->diag, PH_E_USAGE, NULL, "--fields needs --format=json");
  }
  o->unasked = format->is_objects ? ph_chosen_unasked(o->chosen)
               : format->is_lines ? ~PH_BIT(PH_D_SIMPLE)
                                  : UINT64_MAX;
  if (o->pretty && !format->is_objects) {
    return ph_fail(p->diag, PH_E_USAGE, NULL, "--pretty needs --format=json");
  }
  if (check_offsets(p) != PH_OK) {
    return PH_E_USAGE;
  }
  if (check_frame(p) != PH_OK) {
    return PH_E_USAGE;
  }
  if (o->convert && !ph_command_kind(o->command)->bezier) {
    return ph_fail(p->diag, PH_E_USAGE, NULL,
                   "--convert: the curves of %s are no Bezier curves",
                   o->command->schema->command);
  }
  status = ph_plot_check(o, p->diag);
  return status == PH_OK ? ph_panorama_check(o, p->diag) : status;
}

/* What a record may take, unless --max-memory says it: a quarter of all. */
static size_t memory_default(void) {
  const long pages = sysconf(_SC_PHYS_PAGES), size = sysconf(_SC_PAGESIZE);
  return pages > 3 && size > 0 ? (size_t)pages / 4 * (size_t)size
                               : SIZE_MAX / 4;
}

static size_t processors(void) {
  long n = sysconf(_SC_NPROCESSORS_ONLN);
  return n < 1 ? 1 : n > PH_JOBS_MAX ? PH_JOBS_MAX : (size_t)n;
}

enum ph_status ph_options_read(int argc, char **argv,
                               struct ph_options *options,
                               struct ph_diag *diag) {
  static char *standard_input[] = {"-"};
  struct ph_option_parser p = {argc,         argv, options, diag,  NULL, "",
                               (size_t)argc, NULL, NULL,    false, NULL};
  enum ph_status status = build_tables(&p);
  int value;
  options->sweep_count = 1;
  options->input.format =
      options->command->use == PH_USE_VERIFY ? PH_SPLIT_JSON : PH_SPLIT_AUTO;
  options->jobs = processors();
  options->max_memory = memory_default();
  options->samples.most = options->grid.most = PH_SAMPLES_MAX;
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
  if (!options->input.most) {
    options->input.most = options->max_memory;
  }
  options->problems_input.most = options->input.most;
  if (status == PH_OK) {
    status = assign_tolerance(&p);
  }
  if (status != PH_OK) {
    return status;
  }
  status = options->command->use == PH_USE_VERIFY ? check_problems(&p)
                                                  : check_together(&p);
  return status == PH_OK ? ph_option_check_part(&p) : status;
}

struct ph_print ph_options_print(const struct ph_options *options) {
  return (struct ph_print){
      {options->table, ph_formats[options->format].is_text, space_of(options),
       options->offsets_n, options->offset.mode != PH_OFFSET_RAW,
       options->samples.frame != PH_FRAME_NONE, options->with_file,
       ph_formats[options->format].is_binary},
      options->pretty,
      options->feed,
      options->unit};
}

void ph_options_free(struct ph_options *options) {
  ph_arena_free(&options->arena);
}
