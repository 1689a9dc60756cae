/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One record, bytes to bytes (see work.h). */
#include "cli/work.h"

#include "check/certify.h"
#include "check/loop.h"
#include "cli/derive.h"
#include "cli/merged.h"
#include "cli/message.h"
#include "cli/near.h"
#include "cli/panorama.h"
#include "cli/plot.h"
#include "io/svg_out.h"
#include "io/value.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

/* Speeds below this part of the mean make corners: lengths 1.003 times the
 * chords of random points do so always, 1.1 times never (man
 * phspline-arclength). */
static const double SHARP = 0.01;

/* Texts of so many bytes do not stay in memory beside the curve. */
enum { FORGOTTEN = 1 << 20 };

/* An item on its way. */
struct task {
  const struct ph_options *options;
  struct ph_worker *worker;
  struct ph_item *item;
  struct ph_echo echo;
  struct ph_swept *swept;
  size_t swept_n;
  struct ph_swept set[PH_FIELD_N]; /* by options, */
  size_t set_n;                    /* so many */
  struct ph_problem problem;
  struct ph_merge merge;
  struct ph_result result;
  struct ph_derived derived;
  struct ph_diag diag;
};

static enum ph_status read_problem(struct task *t) {
  const struct ph_record *record = &t->item->record;
  const struct ph_schema *schema = t->options->command->schema;
  struct ph_arena *given = &t->worker->given;
  return ph_record_read(record, schema, given, &t->problem, &t->echo, &t->diag);
}

/* What the record says of its sweep, also when it fails. */
static enum ph_status name_sweep(struct task *t) {
  const struct ph_options *o = t->options;
  struct ph_swept *swept =
      ph_arena_array(&t->worker->arena, o->sweeps_n, sizeof *swept);
  enum ph_status status =
      swept ? ph_sweep_name(o->sweeps, o->sweeps_n, t->item->sweep,
                            &t->worker->arena, swept, &t->diag)
            : ph_fail_memory(&t->diag);
  if (status == PH_OK) {
    t->swept = swept;
    t->swept_n = o->sweeps_n;
  }
  return status;
}

size_t ph_work_assign(const struct ph_assignment *assignments, size_t n,
                      struct ph_problem *problem, struct ph_swept *set) {
  const struct ph_assignment *by[PH_FIELD_N] = {NULL};
  size_t set_n = 0;
  for (int override = 0; override < 2; override++) {
    for (size_t i = 0; i < n; i++) {
      const struct ph_assignment *a = &assignments[i];
      bool given = problem->field[a->field].kind != PH_ABSENT;
      if (a->override == override && (override || !given)) {
        by[a->field] = a;
      }
    }
  }
  for (size_t i = 0; n > 0 && i < PH_FIELD_N; i++) {
    if (by[i]) {
      problem->field[i] = by[i]->value;
      if (set) {
        set[set_n++] =
            (struct ph_swept){ph_field_name((enum ph_field_id)i), by[i]->json};
      }
    }
  }
  return set_n;
}

/* Under --strict the first warning is the failure. */
static enum ph_status refuse_warnings(struct task *t) {
  if (!t->options->strict || !t->result.warnings_n) {
    return PH_OK;
  }
  t->diag = t->result.warnings[0].diag;
  return t->diag.status;
}

/* That a curve is what the command promises. */
static enum ph_status certify_curve(struct task *t,
                                    const struct ph_curve *curve,
                                    struct ph_diagnostics *diagnostics) {
  return ph_certify(t->options->command->schema->command, &t->problem, curve,
                    &t->worker->scratch, diagnostics, &t->diag);
}

/* What else is said of it. */
static enum ph_status describe_curve(struct task *t,
                                     const struct ph_curve *curve,
                                     struct ph_diagnostics *diagnostics) {
  const struct ph_command *command = t->options->command;
  diagnostics->unasked = t->options->unasked;
  return command->describe ? command->describe(curve, &t->worker->scratch,
                                               diagnostics, &t->diag)
                           : PH_OK;
}

/* A curve that all but stops turns there as sharply as a corner: so it is said,
 * if the speed is known. */
static void warn_corners(struct ph_result *r) {
  double speed = r->diagnostics.value[PH_D_MIN_SPEED];
  if (ph_diagnostics_known(&r->diagnostics, PH_D_MIN_SPEED) && speed < SHARP) {
    ph_warn(r, PH_NO_SEGMENT, PH_W_SHARP_CORNERS,
            "the curve is nearly a polygon with sharp corners: its least speed "
            "is %.2g of the mean",
            speed);
  }
}

/* Does something for every curve that will be written. */
static enum ph_status
for_each_curve(struct task *t,
               enum ph_status (*what)(struct task *, const struct ph_curve *,
                                      struct ph_diagnostics *)) {
  struct ph_result *r = &t->result;
  enum ph_status status = what(t, &r->curve, &r->diagnostics);
  for (size_t i = 0; status == PH_OK && i < r->solutions_n; i++) {
    status = what(t, &r->solutions[i].curve, &r->solutions[i].diagnostics);
  }
  return status;
}

static enum ph_status certify(struct task *t) {
  enum ph_status status = for_each_curve(t, certify_curve);
  if (status == PH_E_NO_CONVERGENCE || status == PH_E_TOO_LARGE) {
    status = ph_near_points(&t->problem, &t->diag);
    ph_merge_tell(&t->merge, &t->diag);
  }
  return status;
}

static enum ph_status describe(struct task *t) {
  enum ph_status status = for_each_curve(t, describe_curve);
  if (status == PH_OK) {
    warn_corners(&t->result);
  }
  return status;
}

void ph_work_begin(const struct ph_options *options, struct ph_worker *worker) {
  ph_budget_start(&worker->budget, options->max_memory, options->time_limit);
  worker->arena.budget = &worker->budget;
  worker->given.budget = &worker->budget;
  worker->scratch.budget = &worker->budget;
}

enum ph_status ph_work_settle(const struct ph_options *options,
                              struct ph_worker *worker, enum ph_status status,
                              struct ph_diag *diag) {
  const bool late = ph_arena_late(&worker->arena);
  const size_t needed = worker->budget.needed;
  ph_budget_stop(&worker->budget);
  ph_arena_reset(&worker->scratch);
  if (needed) {
    return ph_fail(diag, PH_E_LIMIT, NULL,
                   "the record takes %zu bytes of memory or more, above the "
                   "%zu of --max-memory",
                   needed, options->max_memory);
  }
  return late ? ph_fail(diag, PH_E_LIMIT, NULL,
                        "the record takes longer than the %g seconds of "
                        "--time-limit",
                        options->time_limit)
              : status;
}

/* The problem with what the options and the sweep make of it. */
static enum ph_status prepare(struct task *t) {
  const struct ph_options *o = t->options;
  const struct ph_schema *schema = o->command->schema;
  struct ph_arena *arena = &t->worker->arena;
  enum ph_status status = read_problem(t);
  if (status == PH_OK) {
    t->set_n =
        ph_work_assign(o->assignments, o->assignments_n, &t->problem, t->set);
    status = ph_sweep_apply(o->sweeps, o->sweeps_n, t->item->sweep, arena,
                            &t->problem, &t->diag);
  }
  if (status == PH_OK) {
    status = ph_problem_trace(&t->problem, &t->diag);
  }
  if (status == PH_OK) {
    status = ph_problem_check_required(&t->problem, schema, &t->diag);
  }
  return status == PH_OK
             ? ph_merge(schema, arena, &t->problem, &t->merge, &t->diag)
             : status;
}

/* Of a large problem that was read, the text is freed. */
static void forget_text(struct task *t) {
  struct ph_item *item = t->item;
  if (item->held && item->record.n >= FORGOTTEN &&
      ph_record_forget(&item->record, &t->echo, &t->worker->arena)) {
    ph_buf_free(item->held);
  }
}

/* Of a large problem that nothing but its curve is of any more, the points are
 * freed. */
static void forget_problem(struct task *t) {
  const struct ph_value *points = &t->problem.field[PH_F_POINTS];
  struct ph_arena *arena = &t->worker->arena;
  if (points->n * points->dimension * sizeof(double) >= FORGOTTEN &&
      !t->item->draw && t->problem.field[PH_F_AT].kind == PH_ABSENT &&
      ph_record_keep(&t->echo, arena)) {
    t->problem = (struct ph_problem){0};
    ph_arena_reset(&t->worker->given);
  }
}

/* Whether a value is what is advised, or as large. */
static bool has(const struct ph_value *value, const char *advised) {
  return value->kind != PH_ABSENT &&
         (!advised || ph_value_is(value, advised) ||
          (value->kind == PH_NUMBER && value->number >= strtod(advised, NULL)));
}

/* After a failure: the option that is the likeliest to help. */
static void advise(struct task *t) {
  const struct ph_method *method = t->options->command->method;
  for (size_t i = 0; i < method->advice_n; i++) {
    const struct ph_advice *a = &method->advice[i];
    const char *at = t->diag.field, *about = a->about;
    bool given =
        a->with == PH_FIELD_N || t->problem.field[a->with].kind != PH_ABSENT;
    if (given && (!about || strncmp(at, about, strlen(about)) == 0) &&
        (a->field == PH_FIELD_N ||
         !has(&t->problem.field[a->field], a->value))) {
      ph_diag_add(&t->diag, a->text);
      return;
    }
  }
}

/* Lengths of what is made of degrees are none. */
static void tell_degrees(struct task *t) {
  const struct ph_schema *schema = &t->options->command->method->schema;
  if (t->item->record.degrees && !ph_field_find(schema, "lonlat", 6)) {
    ph_warn(&t->result, PH_NO_SEGMENT, PH_W_DEGREES,
            "longitudes and latitudes, in degrees, were taken as x and y: "
            "sphere takes them as they are, and projected coordinates have "
            "lengths");
  }
}

static enum ph_status solve(struct task *t) {
  const struct ph_command *command = t->options->command;
  struct ph_worker *worker = t->worker;
  enum ph_status status = t->item->record.status;
  if ((status == PH_E_LIMIT || t->item->record.named) &&
      t->item->record.n > 0 && read_problem(t) == PH_E_NO_MEMORY) { /* its id */
    return PH_E_NO_MEMORY;
  }
  if (status != PH_OK) {
    t->diag = t->item->diag;
    return status;
  }
  status = name_sweep(t);
  if (status == PH_OK) {
    status = prepare(t);
  }
  if (status == PH_OK) {
    forget_text(t);
    t->result.diagnostics.unasked = t->options->unasked;
    status = command->method->solve(&t->problem, &worker->arena,
                                    &worker->scratch, &t->result, &t->diag);
    if (status == PH_OK) {
      ph_merge_result(&t->merge, &t->result);
      tell_degrees(t);
    } else {
      ph_merge_tell(&t->merge, &t->diag);
    }
  }
  if (status == PH_OK) {
    status = certify(t);
  }
  if (status == PH_E_NO_CONVERGENCE) {
    advise(t);
  }
  if (status == PH_OK) {
    forget_problem(t);
    status = describe(t);
  }
  if (status == PH_OK) {
    status = ph_derive(t->options, &t->problem, &worker->arena, &t->result,
                       &t->derived, &t->diag);
  }
  if (status == PH_OK) {
    status = ph_certify_loops(&t->derived.exact, t->result.offsets,
                              t->result.offsets_n, &worker->scratch, &t->diag);
  }
  return status == PH_OK ? refuse_warnings(t) : status;
}

/* The curve as it was found, also where Bezier pieces of it are written. */
static enum ph_status draw(struct task *t, const char *id) {
  const struct ph_plot_subject subject = {id, t->item->record.number, t->swept,
                                          t->swept_n};
  struct ph_result exact = t->result;
  exact.curve = t->derived.exact;
  return ph_plot_draw(&subject, &t->problem, &exact, &t->worker->arena,
                      &t->item->drawing, &t->diag);
}

const size_t *ph_work_byte(const struct ph_options *options,
                           const struct ph_record *record) {
  return options->input.part.how == PH_PART_ALL ? NULL : &record->byte;
}

const char *ph_work_id(const struct ph_echo *echo, struct ph_arena *arena) {
  if (!echo->id) {
    return NULL;
  }
  return echo->id[0] == '"' ? ph_value_string(echo->id, echo->id_n, arena)
                            : ph_arena_copy(arena, echo->id, echo->id_n);
}

static void write_result(struct task *t, const struct ph_heading *heading,
                         const char *id, struct ph_buf *out) {
  const struct ph_print print = ph_options_print(t->options);
  struct ph_solved solved = {id,
                             (t->item->record.number - 1) *
                                     t->options->sweep_count +
                                 t->item->sweep + 1,
                             heading,
                             &t->result,
                             t->derived.paths,
                             t->derived.paths_n,
                             t->item->record.downward,
                             t->item->box,
                             t->derived.tilings,
                             t->derived.tilings_n};
  static const double nothing[4] = PH_SVG_NOTHING;
  char number[32];
  if (!id) {
    snprintf(number, sizeof number, heading->byte ? "@%zu" : "%zu",
             heading->byte ? *heading->byte : t->item->record.number);
    solved.id = number;
  }
  memcpy(t->item->box, nothing, sizeof nothing);
  ph_formats[t->options->format].solved(out, &print, &solved);
}

/*
 * Writes the result where there is memory for it; else none of it is left.  Of
 * a text that may leave before it is whole, no more than a piece is in memory:
 * where there is room for that, the text has room.
 */
static enum ph_status try_write(struct task *t,
                                const struct ph_heading *heading,
                                const char *id, struct ph_buf *out) {
  const size_t start = out->n, most = t->options->max_memory;
  const size_t used = t->worker->budget.used;
  const size_t room = most > used ? most - used : 0;
  const bool kept = ph_formats[t->options->format].frame != NULL;
  enum ph_status status = PH_OK;
  if (out->spill && !kept && room >= PH_WORK_PIECE) {
    out->piece = PH_WORK_PIECE;
  } else {
    out->most = start + room;
  }
  out->spare = t->worker->budget.spare;
  write_result(t, heading, id, out);
  out->spare = NULL;
  if (!out->piece && out->n > start + room) {
    status = ph_fail(&t->diag, PH_E_LIMIT, NULL,
                     "the record takes more bytes of memory, with its result "
                     "as text, than the %zu of --max-memory",
                     most);
  } else if (out->failed) {
    status = ph_fail_memory(&t->diag);
  }
  out->most = 0;
  out->piece = 0;
  if (status != PH_OK) {
    ph_buf_cut(out, start, PH_WORK_KEEP);
  }
  return status;
}

/* What fails at last is in no figure and no panorama. */
static void drop_pictures(struct ph_item *item) {
  ph_drawing_free(item->drawing);
  item->drawing = NULL;
  ph_free(item->panorama);
  item->panorama = NULL;
}

/* The record of a failure. */
static void write_failure(struct task *t, const struct ph_heading *heading,
                          struct ph_buf *out) {
  const struct ph_format_row *format = &ph_formats[t->options->format];
  const struct ph_print print = ph_options_print(t->options);
  const struct ph_record *record = &t->item->record;
  struct ph_heading failed = *heading;
  failed.file = NULL; /* the error has it */
  if (!t->diag.line) {
    t->diag.line = record->status == PH_OK
                       ? ph_record_line(record, t->diag.field)
                       : record->line;
  }
  if (format->failed) {
    format->failed(out, &print, &failed, &t->diag, record->file);
  }
}

static void report(struct task *t, const struct ph_subject *subject,
                   enum ph_status status, const struct timespec *start,
                   struct ph_buf *err) {
  const struct ph_options *o = t->options;
  const double *d = t->result.diagnostics.value;
  struct timespec now;
  for (size_t i = 0; status == PH_OK && !o->quiet && i < t->result.warnings_n;
       i++) {
    ph_message_warning(err, subject, &t->result.warnings[i].diag);
  }
  if (status != PH_OK) {
    ph_message_error(err, subject, &t->diag);
  } else if (o->verbose) {
    clock_gettime(CLOCK_MONOTONIC, &now);
    ph_message_subject(err, subject);
    ph_message_printf(err, "%.0f iterations, residual %.2g, %.3g ms\n",
                      d[PH_D_ITERATIONS], d[PH_D_RESIDUAL],
                      1e3 * (double)(now.tv_sec - start->tv_sec) +
                          1e-6 * (double)(now.tv_nsec - start->tv_nsec));
  }
}

/* Where there are others, they fail. */
static enum ph_status refuse_second(struct task *t) {
  const enum ph_format format = t->options->format;
  const bool second = t->item->record.number > 1 || t->item->sweep > 0;
  return ph_formats[format].is_single && second
             ? ph_fail(&t->diag, PH_E_BAD_VALUE, NULL,
                       "is not the only problem: --format=%s is the mesh of "
                       "one",
                       ph_format_name(format))
             : PH_OK;
}

/* Of the first record; where there are others, they fail. */
static enum ph_status keep_panorama(struct task *t) {
  if (t->item->record.number > 1) {
    return ph_fail(&t->diag, PH_E_BAD_VALUE, NULL,
                   "is not the only problem: --panorama is the picture of one");
  }
  t->item->panorama = ph_panorama_copy(&t->result.panorama);
  return t->item->panorama ? PH_OK : ph_fail_memory(&t->diag);
}

void ph_work(const struct ph_options *options, struct ph_worker *worker,
             struct ph_item *item, struct ph_buf *out, struct ph_buf *err) {
  const struct ph_record *record = &item->record;
  struct task t = {.options = options, .worker = worker, .item = item};
  struct ph_subject subject = {record->file, record->line, NULL, record->number,
                               ph_work_byte(options, record)};
  struct ph_heading heading = {
      .chosen = options->chosen,
      .byte = subject.byte,
      .file = strcmp(record->file, "-") == 0 ? NULL : record->file,
      .echo = &t.echo,
      .command = options->command->schema->command};
  struct timespec start = {0, 0};
  if (options->verbose) {
    clock_gettime(CLOCK_MONOTONIC, &start);
  }
  ph_work_begin(options, worker);
  item->status = solve(&t);
  if (record->status == PH_OK) {
    item->status = ph_work_settle(options, worker, item->status, &t.diag);
  }
  subject.id = ph_work_id(&t.echo, &worker->arena);
  if (item->status == PH_OK && t.echo.id && !subject.id) {
    item->status = ph_fail_memory(&t.diag);
  }
  if (item->status == PH_OK && item->draw) {
    item->status = draw(&t, subject.id);
  }
  if (item->status == PH_OK && options->panorama) {
    item->status = keep_panorama(&t);
  }
  if (item->status == PH_OK) {
    item->status = refuse_second(&t);
  }
  heading.swept = t.swept;
  heading.swept_n = t.swept_n;
  heading.set = t.set;
  heading.set_n = t.set_n;
  if (item->status == PH_OK) {
    item->status = try_write(&t, &heading, subject.id, out);
  }
  if (item->status != PH_OK) {
    drop_pictures(item);
    write_failure(&t, &heading, out);
    subject.line = t.diag.line;
  }
  report(&t, &subject, item->status, &start, err);
  ph_arena_reset(&worker->given);
  ph_arena_reset(&worker->arena);
}

void ph_worker_free(struct ph_worker *worker) {
  ph_arena_free(&worker->arena);
  ph_arena_free(&worker->given);
  ph_arena_free(&worker->scratch);
}
