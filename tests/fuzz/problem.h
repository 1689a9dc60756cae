/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * What the targets that solve problems share: taking bytes, and what holds for
 * any failure and any result.
 */
#ifndef PH_TESTS_FUZZ_PROBLEM_H
#define PH_TESTS_FUZZ_PROBLEM_H

#include "fuzz.h"

#include "check/certify.h"
#include "curve/fair/describe.h"
#include "curve/offset/offset.h"
#include "io/json_out.h"
#include "io/json_scan.h"
#include "solve/method.h"

#include <gsl/gsl_errno.h>

#include <math.h>
#include <stdbool.h>
#include <string.h>

struct fuzz_bytes {
  const uint8_t *data;
  size_t n, at;
};

/* Takes n bytes; false when there are not so many. */
static inline bool fuzz_take(struct fuzz_bytes *in, void *to, size_t n) {
  if (in->n - in->at < n) {
    return false;
  }
  memcpy(to, in->data + in->at, n);
  in->at += n;
  return true;
}

/* A vector of signed bytes, 16-bit numbers (coding 1) or doubles (2). */
static inline bool fuzz_take_vector(struct fuzz_bytes *in, int coding, size_t n,
                                    double *v) {
  for (size_t i = 0; i < n; i++) {
    int8_t small;
    int16_t wide;
    bool taken = coding == 2   ? fuzz_take(in, &v[i], sizeof v[i])
                 : coding == 1 ? fuzz_take(in, &wide, sizeof wide)
                               : fuzz_take(in, &small, sizeof small);
    if (!taken) {
      return false;
    }
    v[i] = coding == 2 ? v[i] : coding == 1 ? wide : small;
  }
  return true;
}

static inline bool fuzz_is_finite(const double *v, size_t n) {
  size_t i = 0;
  while (i < n && isfinite(v[i])) {
    i++;
  }
  return i == n;
}

/* A byte as a number from 2^-12 to nearly 16, in steps that are exact; the
 * least where none is wanted. */
static inline bool fuzz_take_small(struct fuzz_bytes *in, bool wanted,
                                   double *x) {
  uint8_t byte = 0;
  bool taken = !wanted || fuzz_take(in, &byte, 1);
  *x = ldexp(1 + byte % 16 / 16.0, byte / 16 - 12);
  return taken;
}

/* Where a walk has come to. */
struct fuzz_walk {
  double heading, at[3];
};

/* A step (turn about z, rise in space, length) becomes the point it leads to.
 */
static inline void fuzz_step(struct fuzz_walk *walk, size_t dimension,
                             double *p) {
  const double unit = 3.141592653589793 / 128;
  double rise = dimension > 2 ? unit / 2 * p[1] : 0;
  double length = exp2(p[dimension - 1] / 8);
  walk->heading += unit * p[0];
  walk->at[0] += length * cos(rise) * cos(walk->heading);
  walk->at[1] += length * cos(rise) * sin(walk->heading);
  walk->at[2] += length * sin(rise);
  memcpy(p, walk->at, dimension * sizeof *p);
}

/* Values of fields; an array of numbers where the dimension is 1. */
static inline struct ph_value fuzz_word(const char *word) {
  return (struct ph_value){.kind = PH_WORD, .word = word};
}

static inline struct ph_value fuzz_number(double x) {
  return (struct ph_value){.kind = PH_NUMBER, .number = x};
}

static inline struct ph_value fuzz_flag(bool flag) {
  return (struct ph_value){.kind = PH_BOOL, .flag = flag};
}

static inline struct ph_value fuzz_array(double *v, size_t n,
                                         size_t dimension) {
  return (struct ph_value){.kind = dimension > 1 ? PH_VECTORS : PH_NUMBERS,
                           .v = v,
                           .n = n,
                           .dimension = dimension};
}

/* Fields that are given, unless NULL, NaN or false. */
static inline void fuzz_set_word(struct ph_problem *problem,
                                 enum ph_field_id id, const char *word) {
  if (word) {
    problem->field[id] = fuzz_word(word);
  }
}

static inline void fuzz_set_number(struct ph_problem *problem,
                                   enum ph_field_id id, double x) {
  if (!isnan(x)) {
    problem->field[id] = fuzz_number(x);
  }
}

static inline void fuzz_set_flag(struct ph_problem *problem,
                                 enum ph_field_id id, bool flag) {
  if (flag) {
    problem->field[id] = fuzz_flag(true);
  }
}

static inline void fuzz_check_failure(const struct ph_diag *diag,
                                      enum ph_status status) {
  FUZZ_REQUIRE(diag->status == status);
  FUZZ_REQUIRE(ph_status_class(status) == PH_CLASS_RECORD);
  FUZZ_REQUIRE(diag->message[0] != '\0');
}

/* What is known is finite; a curve is no start that led nowhere. */
static inline void
fuzz_check_diagnostics(const struct ph_diagnostics *diagnostics) {
  for (int i = 0; i < PH_DIAGNOSTIC_N; i++) {
    double value = diagnostics->value[i];
    if (diagnostics->known >> i & 1) {
      FUZZ_REQUIRE(isfinite(value));
      FUZZ_REQUIRE(i != PH_D_SECOND_ORDER ||
                   (value >= 0 && value < PH_OUTCOME_NO_SOLUTION));
      FUZZ_REQUIRE(i != PH_D_ROOT || (value >= 0 && value < PH_ROOT_N));
    }
  }
}

/* Intervals are all segments, in order. */
static inline void fuzz_check_intervals(const struct ph_result *result) {
  size_t next = 0;
  for (size_t i = 0; i < result->intervals_n; i++) {
    const struct ph_interval *interval = &result->intervals[i];
    double natural = interval->natural_length;
    FUZZ_REQUIRE(interval->first == next && interval->last >= next);
    FUZZ_REQUIRE(interval->length > 0 && isfinite(interval->length));
    FUZZ_REQUIRE(isnan(natural) || (natural > 0 && isfinite(natural)));
    next = interval->last + 1;
  }
  FUZZ_REQUIRE(result->intervals_n == 0 || next == result->curve.n);
}

/* One of the starts has led to the curve. */
static inline void fuzz_check_starts(const struct ph_result *result) {
  for (size_t i = 0; i < result->starts_n; i++) {
    const struct ph_start *start = &result->starts[i];
    bool solved = start->outcome != PH_OUTCOME_NO_SOLUTION;
    FUZZ_REQUIRE(start->name != NULL);
    FUZZ_REQUIRE(solved ? isfinite(start->f) : isnan(start->f));
  }
  FUZZ_REQUIRE(result->starts_n == 0 ||
               (result->start < result->starts_n &&
                isfinite(result->starts[result->start].f)));
}

/* Rational Bezier pieces without a pole. */
static inline void fuzz_check_offset(const struct ph_offset *offset) {
  size_t points = offset->degree + 1;
  for (size_t i = 0; i < offset->n; i++) {
    FUZZ_REQUIRE(offset->interval[2 * i] < offset->interval[2 * i + 1]);
    for (size_t k = 0; offset->weights && k < points; k++) {
      FUZZ_REQUIRE(offset->weights[points * i + k] > 0);
    }
  }
  if (offset->weights) {
    FUZZ_REQUIRE(fuzz_is_finite(offset->weights, points * offset->n));
    FUZZ_REQUIRE(fuzz_is_finite(offset->control_points,
                                points * offset->n * offset->dimension));
  }
}

/* What is printed is a line of JSON. */
static inline void fuzz_check_output(const struct ph_result *result,
                                     const char *command, bool pretty) {
  const struct ph_echo echo = {0};
  const struct ph_heading heading = {.echo = &echo, .command = command};
  struct ph_json_scan scan = {0};
  struct ph_buf out = {0};
  ph_json_result(&out, &heading, result, pretty);
  FUZZ_REQUIRE(!out.failed);
  FUZZ_REQUIRE(ph_json_scan(&scan, out.data, out.n, true) == PH_JSON_DONE);
  FUZZ_REQUIRE(scan.at == out.n - 1 && out.data[scan.at] == '\n');
  ph_buf_free(&out);
}

/* The n offsets of a curve, at that distance by these rules: a failure, or
 * sound and printed with it.  The first one is returned, NULL after a failure.
 */
static inline const struct ph_offset *
fuzz_check_offsets(struct ph_result *result, size_t n, double distance,
                   const struct ph_offset_rules *rules, struct ph_arena *arena,
                   const char *command, bool pretty) {
  static struct ph_offset offsets[PH_OFFSETS_SPATIAL];
  struct ph_diag diag;
  enum ph_status status =
      ph_offset(&result->curve, distance, rules, arena, offsets, &diag);
  if (status != PH_OK) {
    fuzz_check_failure(&diag, status);
    return NULL;
  }
  for (size_t i = 0; i < n; i++) {
    fuzz_check_offset(&offsets[i]);
  }
  result->offsets = offsets;
  result->offsets_n = n;
  fuzz_check_output(result, command, pretty);
  result->offsets_n = 0;
  return offsets;
}

/* Those of a curve in space, as far away as it is long. */
static inline void fuzz_check_offsets3(struct ph_result *result,
                                       struct ph_arena *arena,
                                       const char *command, bool pretty) {
  double size = result->curve.length;
  const struct ph_offset_rules rules = {.tolerance = 1e-3 * size};
  fuzz_check_offsets(result, PH_OFFSETS_SPATIAL, size, &rules, arena, command,
                     pretty);
}

/* What becomes of a problem.  {0} is nothing. */
struct fuzz_run {
  struct ph_arena out, scratch;
  struct ph_result result;
  struct ph_diag diag;
  enum ph_status status;
};

/* Solves; the method gives its scratch memory back. */
static inline void fuzz_solve(struct fuzz_run *run,
                              const struct ph_method *method,
                              const struct ph_problem *problem) {
  struct ph_mark mark, after;
  gsl_set_error_handler_off(); /* as main() does */
  FUZZ_REQUIRE(ph_arena_array(&run->scratch, 1, 1) != NULL);
  mark = ph_arena_mark(&run->scratch);
  run->status = method->solve(problem, &run->out, &run->scratch, &run->result,
                              &run->diag);
  after = ph_arena_mark(&run->scratch);
  FUZZ_REQUIRE(after.chunk == mark.chunk && after.used == mark.used);
}

/* Certifies what was solved, then describes it where the kind has something
 * to say. */
static inline void fuzz_certify(struct fuzz_run *run, const char *command,
                                const struct ph_problem *problem,
                                ph_describe_fn *describe) {
  run->status = ph_certify(command, problem, &run->result.curve, &run->scratch,
                           &run->result.diagnostics, &run->diag);
  if (run->status == PH_OK && describe) {
    run->status = describe(&run->result.curve, &run->scratch,
                           &run->result.diagnostics, &run->diag);
  }
}

/* Looks at a failure, and gives all memory back. */
static inline void fuzz_end(struct fuzz_run *run) {
  if (run->status != PH_OK) {
    fuzz_check_failure(&run->diag, run->status);
  }
  ph_arena_free(&run->out);
  ph_arena_free(&run->scratch);
}

#endif
