/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * From problem to verdict, as the program does it: options and a record are
 * read, ph_work writes the result, and ph_verify_work reads it and the problem
 * (see gate.h).  The same again, by a worker that has done something else
 * before, must give the same bytes.
 */
#include "gate.h"

#include "cli/pairing.h"
#include "cli/verify.h"
#include "io/json_result.h"
#include "io/json_scan.h"

#include <pthread.h>
#include <stdarg.h>

void gate_wrong(struct gate_outcome *outcome, const char *way,
                const char *format, ...) {
  va_list args;
  if (outcome->fate == GATE_WRONG) {
    return;
  }
  outcome->fate = GATE_WRONG;
  snprintf(outcome->way, sizeof outcome->way, "%s", way);
  va_start(args, format);
  vsnprintf(outcome->message, sizeof outcome->message, format, args);
  va_end(args);
}

/* ---- options --------------------------------------------------------------
 */

/* getopt has state of its own. */
static enum ph_status read_options(int argc, char **argv,
                                   struct ph_options *options,
                                   struct ph_diag *diag) {
  static pthread_mutex_t one_at_a_time = PTHREAD_MUTEX_INITIALIZER;
  enum ph_status status;
  pthread_mutex_lock(&one_at_a_time);
  status = ph_options_read(argc, argv, options, diag);
  pthread_mutex_unlock(&one_at_a_time);
  return status;
}

/* A command line of the case and what it means. */
struct call {
  struct ph_options options;
  char *argv[GATE_ARGUMENTS];
};

static bool call_of(struct gate_lab *lab, const struct gate_case *c,
                    bool verify, struct call *call,
                    struct gate_outcome *outcome) {
  int argc = gate_arguments(c, verify, &lab->arena, call->argv);
  enum ph_status status;
  struct ph_diag diag;
  call->options = (struct ph_options){
      .command = verify ? ph_command_find("verify") : &ph_commands[c->command]};
  status = read_options(argc, call->argv, &call->options, &diag);
  outcome->code = status;
  if (status == PH_OK) {
    return true;
  }
  outcome->fate = GATE_REFUSED;
  if (verify || ph_status_class(status) != PH_CLASS_USAGE) {
    gate_wrong(outcome, "options", "%s", diag.message);
  }
  return false;
}

/* ---- one result --------------------------------------------------------- */

static void record_of(const struct ph_buf *text, const char *file,
                      struct ph_record *record) {
  *record = (struct ph_record){
      .text = text->data, .n = text->n, .file = file, .line = 1, .number = 1};
}

/* "way FIELD": places of a field without their numbers. */
static void way_of(const char *kind, const char *field, char *way,
                   size_t size) {
  size_t n = (size_t)snprintf(way, size, "%s ", kind);
  for (; *field && n + 1 < size; field++) {
    if (*field < '0' || *field > '9') {
      way[n++] = *field;
    }
  }
  way[n] = '\0';
}

/* A member of a text of JSON whose value is a string, "" if it is not there. */
static void member(const char *text, const char *name, char *value,
                   size_t size) {
  const char *at = strstr(text, name);
  size_t n = 0;
  if (at) {
    at += strlen(name);
    n = strcspn(at, "\"");
    n = n < size ? n : size - 1;
    memcpy(value, at, n);
  }
  value[n] = '\0';
}

/* Why a result was found wrong. */
static void refuted(struct gate_lab *lab, const char *with,
                    struct gate_outcome *outcome) {
  char check[64], field[64], kind[128], way[96], message[GATE_MESSAGE];
  ph_buf_put(&lab->verdict, "", 1);
  member(lab->verdict.data, "\"check\":\"", check, sizeof check);
  member(lab->verdict.data, "\"field\":\"", field, sizeof field);
  member(lab->verdict.data, "\"message\":\"", message, sizeof message);
  snprintf(kind, sizeof kind, "verify%s %s", with, check);
  way_of(kind, field, way, sizeof way);
  gate_wrong(outcome, way, "%s", message);
}

static void verify(struct gate_lab *lab, const struct ph_options *options,
                   bool paired, struct gate_outcome *outcome) {
  struct ph_paired problem = {.schema = NULL};
  struct ph_item item = {.paired = paired ? &problem : NULL};
  struct ph_options blind = *options;
  record_of(&lab->problem, "p.json", &problem.record);
  record_of(&lab->out, "-", &item.record);
  blind.problems = paired ? options->problems : NULL;
  ph_buf_clear(&lab->verdict, SIZE_MAX);
  ph_buf_clear(&lab->complaints, SIZE_MAX);
  ph_verify_work(&blind, &lab->verifier, &item, &lab->verdict,
                 &lab->complaints);
  if (item.status != PH_OK) {
    refuted(lab, paired ? "" : " alone", outcome);
  }
}

/* Work of one item, into two buffers. */
static enum ph_status work(const struct ph_options *options,
                           struct ph_worker *worker, const struct ph_buf *text,
                           size_t sweep, struct ph_buf *out,
                           struct ph_buf *err) {
  struct ph_item item = {.sweep = sweep};
  record_of(text, "p.json", &item.record);
  ph_buf_clear(out, SIZE_MAX);
  ph_buf_clear(err, SIZE_MAX);
  ph_work(options, worker, &item, out, err);
  return item.status;
}

static void repeat(struct gate_lab *lab, const struct ph_options *options,
                   size_t sweep, struct gate_outcome *outcome) {
  work(options, &lab->again, &lab->problem, sweep, &lab->repeated,
       &lab->complaints);
  if (lab->repeated.n != lab->out.n ||
      memcmp(lab->repeated.data, lab->out.data, lab->out.n) != 0) {
    gate_wrong(outcome, "repeated", "the same problem has another result");
  }
}

/* The text of a result: JSON, and nothing behind it. */
static void look_at_text(struct gate_lab *lab, struct gate_outcome *outcome) {
  struct ph_json_scan scan = {0};
  const struct ph_buf *out = &lab->out;
  if (ph_json_scan(&scan, out->data, out->n, true) != PH_JSON_DONE ||
      scan.at + 1 != out->n || out->data[scan.at] != '\n') {
    gate_wrong(outcome, "text", "no JSON: %s", scan.message);
  }
}

static void look_at_result(struct gate_lab *lab, enum gate_look look,
                           bool first, struct gate_outcome *outcome) {
  struct ph_record record;
  struct ph_claim claim;
  struct ph_diag diag;
  record_of(&lab->out, "-", &record);
  if (ph_json_result_in(&record, &lab->arena, &claim, &diag) != PH_OK) {
    gate_wrong(outcome, "text", "unreadable: %s %s", diag.field, diag.message);
    return;
  }
  ph_buf_put(&lab->err, "", 1);
  if (first) {
    const struct ph_curve *curve = &claim.result.curve;
    outcome->length = curve->length;
    outcome->segments = curve->n;
    for (size_t i = 0; curve->lengths && i < curve->n && i < GATE_POINTS; i++) {
      outcome->lengths[i] = curve->lengths[i];
    }
    outcome->ambiguous = strstr(lab->err.data, "[ambiguous]") != NULL ||
                         strstr(lab->err.data, "[cut-short]") != NULL;
  }
  if (look == GATE_CLOSELY || outcome->fate == GATE_WRONG) {
    struct gate_outcome brute = {.fate = GATE_SOLVED};
    gate_brute(&claim.result, &brute);
    if (brute.fate == GATE_WRONG) {
      gate_wrong(outcome, brute.way, "%s", brute.message);
    } else {
      outcome->disputed = outcome->fate == GATE_WRONG;
    }
  }
}

/* One result of the case. */
static void one(struct gate_lab *lab, const struct call *solve,
                const struct call *check, size_t sweep, enum gate_look look,
                struct gate_outcome *outcome) {
  enum ph_status status = work(&solve->options, &lab->first, &lab->problem,
                               sweep, &lab->out, &lab->err);
  look_at_text(lab, outcome);
  if (look == GATE_CLOSELY) {
    repeat(lab, &solve->options, sweep, outcome);
  }
  if (status != PH_OK) {
    outcome->code = status;
    outcome->fate = outcome->fate == GATE_WRONG ? GATE_WRONG : GATE_REFUSED;
    if (ph_status_class(status) != PH_CLASS_RECORD) {
      gate_wrong(outcome, "class", "%s", ph_status_code(status));
    }
    return;
  }
  verify(lab, &check->options, true, outcome);
  if (look == GATE_CLOSELY) {
    verify(lab, &check->options, false, outcome);
  }
  if (look != GATE_VERIFIED || outcome->fate == GATE_WRONG) {
    look_at_result(lab, look, sweep == 0, outcome);
  }
}

void gate_run(struct gate_lab *lab, const struct gate_case *c,
              enum gate_look look, struct gate_outcome *outcome) {
  struct call solve, check;
  memset(outcome, 0, sizeof *outcome);
  ph_arena_reset(&lab->arena);
  ph_buf_clear(&lab->problem, SIZE_MAX);
  gate_problem(&lab->problem, c);
  if (call_of(lab, c, false, &solve, outcome)) {
    if (call_of(lab, c, true, &check, outcome)) {
      for (size_t i = 0; i < solve.options.sweep_count; i++) {
        one(lab, &solve, &check, i, look, outcome);
      }
    }
    ph_options_free(&check.options);
  }
  ph_options_free(&solve.options);
}

void gate_lab_free(struct gate_lab *lab) {
  struct ph_buf *bufs[] = {&lab->problem,  &lab->out,        &lab->err,
                           &lab->repeated, &lab->complaints, &lab->verdict};
  for (size_t i = 0; i < COUNT(bufs); i++) {
    ph_buf_free(bufs[i]);
  }
  ph_worker_free(&lab->first);
  ph_worker_free(&lab->again);
  ph_worker_free(&lab->verifier);
  ph_arena_free(&lab->arena);
}
