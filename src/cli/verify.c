/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * One result, bytes to bytes (see verify.h): read, checked, told.
 *
 * What is right has status ok, and a result that is an error record claims no
 * curve, which is right, too.  A result whose worst error is beyond the
 * tolerance is a failure like any other.
 */
#include "cli/verify.h"

#include "base/suggest.h"
#include "cli/message.h"
#include "cli/pairing.h"
#include "curve/merge.h"
#include "io/csv_in.h"
#include "io/json_in.h"
#include "io/json_out.h"
#include "io/json_result.h"
#include "io/json_write.h"
#include "io/value.h"
#include "check/verify.h"

#include <float.h>
#include <stdio.h>
#include <string.h>
#include <time.h>

const struct ph_schema ph_verify_schema = {"verify", NULL, 0};

/* A result on its way. */
struct task {
  const struct ph_options *options;
  struct ph_worker *worker;
  const struct ph_item *item;
  struct ph_claim claim;
  bool read; /* the claim was, as a whole */
  const struct ph_promise *promise;
  struct ph_problem problem;
  bool paired;        /* there is a problem, and it could be read */
  bool about_problem; /* that it could not is the failure */
  struct ph_verdict verdict;
  bool judged; /* there is a verdict */
  struct ph_diag diag;
};

/* ---- the command ------------------------------------------------------- */

/* What the command of the result promises. */
static enum ph_status read_command(struct task *t) {
  const char *name = t->claim.command;
  char excerpt[PH_EXCERPT_MAX], list[PH_DIAG_MESSAGE_MAX / 2] = "";
  size_t n = 0;
  if (!name) {
    return ph_fail(&t->diag, PH_E_MISSING_FIELD, "command", "is missing");
  }
  t->promise = ph_promise_of(name);
  if (t->promise) {
    return PH_OK;
  }
  for (size_t i = 0; i < ph_promises_n; i++) {
    n += (size_t)snprintf(list + n, sizeof list - n, "%s\"%s\"",
                          i == 0                   ? ""
                          : i + 1 == ph_promises_n ? " or "
                                                   : ", ",
                          ph_promises[i].command);
  }
  return ph_fail(&t->diag, PH_E_BAD_VALUE, "command",
                 "must be %s, found \"%s\"", list,
                 ph_excerpt(name, strlen(name), excerpt));
}

/* ---- what was swept and set -------------------------------------------- */

/* Sets one swept field of the problem, as --sweep=NAME=VALUE does. */
static enum ph_status apply(struct task *t, const struct ph_schema *schema,
                            const struct ph_swept *swept) {
  struct ph_arena *arena = &t->worker->arena;
  size_t n = strlen(swept->name), value_n = strlen(swept->value);
  char *text = ph_arena_array(arena, n + value_n + 2, 1);
  struct ph_sweep sweep;
  struct ph_diag why;
  enum ph_status status;
  if (!text) {
    return ph_fail_memory(&t->diag);
  }
  memcpy(text, swept->name, n);
  text[n] = '=';
  memcpy(text + n + 1, swept->value, value_n + 1);
  status = ph_sweep_read(text, schema, arena, &sweep, &why);
  if (status == PH_OK) {
    return ph_sweep_apply(&sweep, 1, 0, arena, &t->problem, &t->diag);
  }
  return status == PH_E_NO_MEMORY
             ? ph_fail_memory(&t->diag)
             : ph_fail(&t->diag, PH_E_BAD_VALUE, "sweep",
                       "is none of this problem: %s", why.message);
}

static enum ph_status fail_set(struct task *t, const char *name,
                               enum ph_status status, const char *message) {
  char excerpt[PH_EXCERPT_MAX], field[PH_EXCERPT_MAX + 4];
  snprintf(field, sizeof field, "set.%s",
           ph_excerpt(name, strlen(name), excerpt));
  return ph_fail(&t->diag, status, field, "%s", message);
}

/* A field that options set when the result was made: the problem, with what
 * --set and --override make of it now, lacks it or has the same value. */
static enum ph_status set_field(struct task *t, const struct ph_schema *schema,
                                const struct ph_swept *set) {
  struct ph_arena *arena = &t->worker->arena;
  size_t n = strlen(set->name);
  const struct ph_field *field = ph_field_find(schema, set->name, n);
  struct ph_value value, *has;
  struct ph_diag why;
  const char *text, *other;
  enum ph_status status;
  if (!field) {
    return fail_set(t, set->name, PH_E_BAD_VALUE, "is no field of the command");
  }
  status =
      ph_value_read(set->value, strlen(set->value), field, arena, &value, &why);
  if (status != PH_OK) {
    return status == PH_E_NO_MEMORY
               ? ph_fail_memory(&t->diag)
               : fail_set(t, set->name, status, why.message);
  }
  has = &t->problem.field[field->id];
  if (has->kind == PH_ABSENT) {
    *has = value;
    return PH_OK;
  }
  text = ph_value_text(&value, arena);
  other = ph_value_text(has, arena);
  if (!text || !other) {
    return ph_fail_memory(&t->diag);
  }
  return strcmp(text, other) == 0
             ? PH_OK
             : fail_set(t, set->name, PH_E_NOT_VERIFIED,
                        "is not what the problem has; --override sets that of "
                        "the problem");
}

/* ---- the problem ------------------------------------------------------- */

/* --set and --override, as of the command that the result is of. */
static enum ph_status assign(struct task *t, const struct ph_schema *schema) {
  const struct ph_options *o = t->options;
  struct ph_arena *arena = &t->worker->arena;
  size_t n = o->assignments_n;
  struct ph_assignment *all = ph_arena_array(arena, n, sizeof *all);
  struct ph_diag why;
  if (!all) {
    return ph_fail_memory(&t->diag);
  }
  for (size_t i = 0; i < n; i++) {
    enum ph_status status;
    all[i] = o->assignments[i];
    status = ph_option_assign(schema, arena, &all[i], &why);
    if (status != PH_OK) {
      return status == PH_E_NO_MEMORY
                 ? ph_fail_memory(&t->diag)
                 : ph_fail(&t->diag, PH_E_BAD_VALUE, NULL, "%s", why.message);
    }
  }
  ph_work_assign(all, n, &t->problem, NULL);
  return PH_OK;
}

static enum ph_status read_record(struct task *t,
                                  const struct ph_paired *paired,
                                  const struct ph_schema *schema) {
  const struct ph_record *record = &paired->record;
  struct ph_arena *arena = &t->worker->arena;
  struct ph_echo echo;
  if (record->status != PH_OK) {
    t->diag = paired->diag;
    return record->status;
  }
  if (record->columns && paired->schema != schema) {
    return ph_fail(&t->diag, PH_E_BAD_VALUE, "command",
                   "is %s, but the columns of %s were read as those of %s, "
                   "which the first result is of",
                   schema->command, record->file, paired->schema->command);
  }
  return ph_record_read(record, schema, arena, &t->problem, &echo, &t->diag);
}

/* Joins points of the problem, the ones that the result says. */
static enum ph_status merge(struct task *t, const struct ph_schema *schema) {
  const struct ph_result *r = &t->claim.result;
  struct ph_merge merge;
  enum ph_status status =
      ph_merge(schema, &t->worker->arena, &t->problem, &merge, &t->diag);
  if (status == PH_OK && r->merged_n > 0 &&
      (r->merged_n != merge.gone_n ||
       memcmp(r->merged, merge.gone, r->merged_n * sizeof *r->merged) != 0)) {
    return ph_fail(&t->diag, PH_E_NOT_VERIFIED, "merged",
                   "are not the points that merge joins");
  }
  return status;
}

/* The problem that the result solves, with what the options and the sweep make
 * of it. */
static enum ph_status read_problem(struct task *t) {
  const struct ph_paired *paired = t->item->paired;
  const struct ph_command *command = ph_command_find(t->claim.command);
  enum ph_status status;
  t->about_problem = true;
  status = read_record(t, paired, command->schema);
  if (status == PH_OK) {
    status = assign(t, command->schema);
  }
  for (size_t i = 0; status == PH_OK && i < t->claim.set_n; i++) {
    status = set_field(t, command->schema, &t->claim.set[i]);
  }
  for (size_t i = 0; status == PH_OK && i < t->claim.swept_n; i++) {
    status = apply(t, command->schema, &t->claim.swept[i]);
  }
  if (status == PH_OK) {
    status = ph_problem_trace(&t->problem, &t->diag);
  }
  if (status == PH_OK) {
    status = ph_problem_check_required(&t->problem, command->schema, &t->diag);
  }
  if (status == PH_OK) {
    status = merge(t, command->schema);
  }
  t->about_problem = status != PH_OK && strcmp(t->diag.field, "sweep") != 0 &&
                     strcmp(t->diag.field, "merged") != 0 &&
                     strncmp(t->diag.field, "set.", 4) != 0;
  t->paired = status == PH_OK;
  return status;
}

/* ---- the verdict ------------------------------------------------------- */

/* The worst error as a failure, if it is one. */
static enum ph_status judge(struct task *t) {
  const double tolerance =
      t->options->tolerance > 0 ? t->options->tolerance : PH_TOLERANCE_VERIFY;
  const struct ph_verdict *v = &t->verdict;
  const struct ph_check_finding *worst;
  t->judged = true;
  if (v->worst == PH_CHECK_N || v->check[v->worst].error <= tolerance) {
    return PH_OK;
  }
  worst = &v->check[v->worst];
  if (worst->error > DBL_MAX) {
    return ph_fail(&t->diag, PH_E_NOT_VERIFIED, worst->where.field, "%s (%s)",
                   worst->where.message, ph_check_name(v->worst));
  }
  return ph_fail(&t->diag, PH_E_NOT_VERIFIED, worst->where.field,
                 "%s (%s %.3g)", worst->where.message, ph_check_name(v->worst),
                 worst->error);
}

static enum ph_status verify(struct task *t) {
  const struct ph_item *item = t->item;
  struct ph_claim *claim = &t->claim;
  enum ph_status status = item->record.status;
  if (status == PH_E_LIMIT && item->record.n > 0 && /* its id */
      ph_json_result_in(&item->record, &t->worker->arena, claim, &t->diag) ==
          PH_E_NO_MEMORY) {
    return PH_E_NO_MEMORY;
  }
  if (status != PH_OK) {
    t->diag = item->diag;
    return status;
  }
  status = ph_json_result_in(&item->record, &t->worker->arena, claim, &t->diag);
  if (status != PH_OK) {
    return status;
  }
  t->read = true;
  status = read_command(t);
  if (status == PH_OK && t->options->problems && !item->paired) {
    t->diag = item->diag;
    status = item->diag.status;
  }
  if (status == PH_OK && item->paired && claim->solved) {
    status = read_problem(t);
  }
  if (status == PH_OK && claim->solved) {
    claim->result.panorama.volume =
        t->options->volume_file ? &t->options->volume : NULL;
    status =
        ph_check_result(&claim->result, t->paired ? &t->problem : NULL,
                        t->promise, &t->worker->scratch, &t->verdict, &t->diag);
    if (status == PH_OK) {
      status = judge(t);
    }
  }
  return status;
}

/* ---- telling ----------------------------------------------------------- */

/* An error as a number of JSON: one that is infinite as the largest there is.
 */
static void write_error(struct ph_json_writer *w, const char *name, double x) {
  ph_write_key_number(w, name, x <= DBL_MAX ? x : DBL_MAX);
}

static void write_verdict(struct ph_json_writer *w, const struct task *t) {
  const struct ph_curve *curve = &t->claim.result.curve;
  const struct ph_verdict *v = &t->verdict;
  const enum ph_parts parts = t->promise->parts;
  ph_write_key_string(w, parts ? "surface" : "curve",
                      ph_curve_name(curve->kind));
  ph_write_key_number(w, ph_parts_name(parts), (double)curve->n);
  if (v->worst != PH_CHECK_N) {
    ph_write_key(w, "worst");
    ph_write_begin(w, '{');
    ph_write_key_string(w, "check", ph_check_name(v->worst));
    write_error(w, "error", v->check[v->worst].error);
    ph_write_end(w, '}');
  }
  ph_write_key(w, "checks");
  ph_write_begin(w, '{');
  for (int i = 0; i < PH_CHECK_N; i++) {
    if (v->check[i].done) {
      write_error(w, ph_check_name((enum ph_check_id)i), v->check[i].error);
    }
  }
  ph_write_end(w, '}');
  if (v->unchecked) {
    ph_write_key(w, "unchecked");
    ph_write_begin(w, '[');
    for (const char *const *name = v->unchecked; *name; name++) {
      ph_write_element(w);
      ph_write_string(w, *name);
    }
    ph_write_end(w, ']');
  }
}

/* Where the failure is: in the result, or in the problem. */
static void locate(struct task *t, struct ph_subject *subject) {
  const struct ph_record *record =
      t->about_problem ? &t->item->paired->record : &t->item->record;
  subject->file = record->file;
  if (!t->diag.line) {
    t->diag.line = record->status == PH_OK
                       ? ph_record_line(record, t->diag.field)
                       : record->line;
  }
  subject->line = t->diag.line;
}

/* The record, and where a failure is. */
static void write_record(struct task *t, enum ph_status status,
                         struct ph_subject *subject, struct ph_buf *out) {
  const struct ph_claim *claim = &t->claim;
  const struct ph_heading heading = {&claim->echo, ph_verify_schema.command,
                                     claim->swept, claim->swept_n,
                                     claim->set,   claim->set_n,
                                     NULL,         NULL,
                                     subject->byte};
  struct ph_json_writer w = {.buf = out, .pretty = t->options->pretty};
  ph_write_begin(&w, '{');
  ph_json_heading(&w, &heading, status == PH_OK ? "ok" : "error");
  if (status != PH_OK) {
    locate(t, subject);
    ph_json_failure(&w, &t->diag, subject->file, subject->byte);
  }
  if (t->read && t->claim.command) {
    ph_write_key_string(&w, "of", t->claim.command);
  }
  if (t->judged) {
    write_verdict(&w, t);
  } else if (t->read && !t->claim.solved) {
    ph_write_key_string(&w, "claims", "error");
  }
  ph_write_end(&w, '}');
  ph_write_put(&w, '\n');
}

static void report(const struct task *t, const struct ph_subject *subject,
                   enum ph_status status, const struct timespec *start,
                   struct ph_buf *err) {
  const struct ph_verdict *v = &t->verdict;
  struct timespec now;
  double ms;
  if (status != PH_OK) {
    ph_message_error(err, subject, &t->diag);
    return;
  }
  if (!t->options->verbose) {
    return;
  }
  clock_gettime(CLOCK_MONOTONIC, &now);
  ms = 1e3 * (double)(now.tv_sec - start->tv_sec) +
       1e-6 * (double)(now.tv_nsec - start->tv_nsec);
  ph_message_subject(err, subject);
  if (t->judged && v->worst != PH_CHECK_N) {
    ph_message_printf(err, "%s %.2g, %.3g ms\n", ph_check_name(v->worst),
                      v->check[v->worst].error, ms);
  } else {
    ph_message_printf(err, "nothing to verify, %.3g ms\n", ms);
  }
}

void ph_verify_work(const struct ph_options *options, struct ph_worker *worker,
                    struct ph_item *item, struct ph_buf *out,
                    struct ph_buf *err) {
  const struct ph_record *record = &item->record;
  struct task t = {.options = options, .worker = worker, .item = item};
  struct ph_subject subject = {record->file, record->line, NULL, record->number,
                               ph_work_byte(options, record)};
  struct timespec start = {0, 0};
  const size_t before = out->n;
  if (options->verbose) {
    clock_gettime(CLOCK_MONOTONIC, &start);
  }
  ph_work_begin(options, worker);
  item->status = verify(&t);
  if (record->status == PH_OK) {
    item->status = ph_work_settle(options, worker, item->status, &t.diag);
  }
  subject.id = ph_work_id(&t.claim.echo, &worker->arena);
  if (item->status == PH_OK && t.claim.echo.id && !subject.id) {
    item->status = ph_fail_memory(&t.diag);
  }
  write_record(&t, item->status, &subject, out);
  if (out->failed) { /* there is nothing left of it */
    item->status = ph_fail_memory(&t.diag);
    t.about_problem = t.judged = false;
    ph_buf_cut(out, before, PH_WORK_KEEP);
    write_record(&t, item->status, &subject, out);
  }
  report(&t, &subject, item->status, &start, err);
  ph_arena_reset(&worker->arena);
}
