/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Result record -> struct (see json_result.h).
 *
 * The members are found first and read in an order that suits: what says how
 * large the arrays are before the arrays.
 */
#include "io/json_result.h"

#include "base/suggest.h"
#include "io/json_in.h"
#include "io/json_read.h"
#include "io/json_result_curve.h"
#include "io/members.h"
#include "io/value.h"

#include <math.h>
#include <string.h>

enum member {
#define X(symbol, ...) symbol,
  PH_HEADING_MEMBERS(X) PH_RESULT_MEMBERS(X)
#undef X
      MEMBERS
};

#define NAME(symbol, name, ...) name,
static const char *const member_names[MEMBERS] = {PH_HEADING_MEMBERS(NAME)
                                                      PH_RESULT_MEMBERS(NAME)};

/* Which of the words a member is; `absent' where there is none, and after a
 * failure. */
static size_t read_word(struct ph_json_reader *r,
                        const struct ph_json_item *item, const char *name,
                        const char *type, size_t absent) {
  const char *const *words = ph_words(type);
  const char *text = ph_read_string(r, item, name, NULL);
  struct ph_suggest suggest;
  char clause[PH_DID_YOU_MEAN_MAX], excerpt[PH_EXCERPT_MAX];
  size_t mark;
  if (!text) {
    return absent;
  }
  ph_suggest_init(&suggest, text, strlen(text));
  for (size_t i = 0; words[i]; i++) {
    if (strcmp(text, words[i]) == 0) {
      return i;
    }
    ph_suggest_try(&suggest, words[i], strlen(words[i]));
  }
  ph_did_you_mean(&suggest, clause);
  mark = ph_read_enter(r, name);
  ph_read_fail(r, PH_BAD_VALUE, "cannot be \"%s\"%s",
               ph_excerpt(text, strlen(text), excerpt), clause);
  ph_read_leave(r, mark);
  return absent;
}

/* ---- diagnostics ------------------------------------------------------- */

enum {
  BEFORE = PH_DIAGNOSTIC_N - 1,
#define X(symbol, ...) symbol,
  PH_CERTIFICATE_MEMBERS(X)
#undef X
      DIAGNOSTIC_MEMBERS
};

/* The value of one of the numbers, flags and words. */
static double read_value(struct ph_json_reader *r,
                         const struct ph_json_item *item,
                         enum ph_diagnostic which) {
  const char *name = ph_diagnostic_name(which);
  const char *type = ph_diagnostic_type(which);
  if (ph_words(type)) {
    return (double)read_word(r, item, name, type, 0);
  }
  return strcmp(type, "flag") == 0 ? ph_read_flag(r, item, name, false)
                                   : ph_read_number(r, item, name, 0);
}

static void read_kantorovich(struct ph_json_reader *r,
                             const struct ph_json_item *from,
                             struct ph_result *result) {
  static const char *const names[] = {PH_KANTOROVICH_MEMBERS(NAME)};
  struct ph_kantorovich *k = &result->kantorovich;
  double *const values[] = {&k->b, &k->c, &k->k, &k->h, &k->radius};
  struct ph_json_item items[6];
  size_t mark;
  if (r->status != PH_OK || !from->value) {
    return;
  }
  mark = ph_read_enter(r, "kantorovich");
  ph_read_members(r, from, names, 6, items);
  for (size_t i = 0; i < sizeof values / sizeof values[0]; i++) {
    *values[i] = ph_read_number(r, &items[i], names[i], (double)INFINITY);
  }
  ph_read_required(r, &items[5], names[5]);
  k->certified = ph_read_flag(r, &items[5], names[5], false);
  result->has_kantorovich = true;
  ph_read_leave(r, mark);
}

static void read_start(struct ph_json_reader *r,
                       const struct ph_json_item *from,
                       struct ph_start *start) {
  static const char *const names[] = {PH_START_MEMBERS(NAME)};
  struct ph_json_item items[4];
  ph_read_members(r, from, names, 4, items);
  ph_read_required(r, &items[0], names[0]);
  ph_read_required(r, &items[1], names[1]);
  start->name = ph_read_string(r, &items[0], names[0], "");
  start->outcome =
      (enum ph_outcome)read_word(r, &items[1], names[1], "outcome", 0);
  start->f = ph_read_number(r, &items[2], names[2], (double)NAN);
  start->iterations = ph_read_whole(r, &items[3], names[3], 0, INT32_MAX);
}

/* The starts that were tried, and which of them won. */
static void read_starts(struct ph_json_reader *r,
                        const struct ph_json_item *items,
                        struct ph_result *result) {
  const char *won = ph_read_string(r, &items[START], "start", "");
  const struct ph_json_item *from = &items[STARTS];
  struct ph_json_walk walk;
  struct ph_json_item item;
  size_t mark, n;
  if (r->status != PH_OK || !from->value) {
    return;
  }
  mark = ph_read_enter(r, "starts");
  n = ph_read_size(r, from);
  result->starts = ph_read_array_of(r, n, sizeof *result->starts);
  ph_json_walk_init(&walk, from->value, from->value_n);
  for (size_t i = 0; r->status == PH_OK && i < n; i++) {
    struct ph_start *start = &result->starts[i];
    size_t inner = ph_read_enter_at(r, i);
    ph_json_walk_next(&walk, &item);
    read_start(r, &item, start);
    if (strcmp(start->name, won) == 0) {
      result->start = i;
    }
    ph_read_leave(r, inner);
  }
  result->starts_n = n;
  ph_read_leave(r, mark);
}

/* result: of the record, or NULL of one of its solutions */
static void read_diagnostics(struct ph_json_reader *r,
                             const struct ph_json_item *from,
                             struct ph_diagnostics *diagnostics,
                             struct ph_result *result) {
  static const char *const others[] = {PH_CERTIFICATE_MEMBERS(NAME)};
  const char *names[DIAGNOSTIC_MEMBERS];
  struct ph_json_item items[DIAGNOSTIC_MEMBERS];
  size_t mark;
  if (r->status != PH_OK || !from->value) {
    return;
  }
  for (size_t i = 0; i < PH_DIAGNOSTIC_N; i++) {
    names[i] = ph_diagnostic_name((enum ph_diagnostic)i);
  }
  memcpy(names + PH_DIAGNOSTIC_N, others, sizeof others);
  mark = ph_read_enter(r, member_names[DIAGNOSTICS]);
  ph_read_members(r, from, names, DIAGNOSTIC_MEMBERS, items);
  for (size_t i = 0; r->status == PH_OK && i < PH_DIAGNOSTIC_N; i++) {
    enum ph_diagnostic which = (enum ph_diagnostic)i;
    if (items[i].value) {
      ph_diagnostics_set(diagnostics, which, read_value(r, &items[i], which));
    }
  }
  if (result) {
    read_kantorovich(r, &items[KANTOROVICH], result);
    read_starts(r, items, result);
  }
  ph_read_leave(r, mark);
}

/* ---- intervals ----------------------------------------------------------- */

static void read_interval(struct ph_json_reader *r,
                          const struct ph_json_item *from, size_t segments,
                          struct ph_interval *interval) {
  static const char *const names[] = {PH_INTERVAL_MEMBERS(NAME)};
  struct ph_json_item items[8];
  double *const values[] = {&interval->ratio, &interval->lambda,
                            &interval->joint_angle, &interval->joint_position};
  double range[2] = {0, 0};
  *interval = PH_INTERVAL_NONE;
  ph_read_members(r, from, names, 8, items);
  ph_read_required(r, &items[0], names[0]);
  interval->length = ph_read_number(r, &items[0], names[0], 0);
  interval->natural_length =
      ph_read_number(r, &items[1], names[1], (double)NAN);
  ph_read_numbers(r, &items[2], names[2], range, 2);
  if (!(range[0] >= 0) || !(range[0] <= range[1]) ||
      !(range[1] <= (double)(segments - 1)) || floor(range[0]) < range[0] ||
      floor(range[1]) < range[1]) {
    ph_read_enter(r, names[2]);
    ph_read_fail(r, PH_BAD_VALUE,
                 "must be the first and the last of its segments, at most "
                 "%zu, found [%g,%g]",
                 segments - 1, range[0], range[1]);
    return;
  }
  interval->first = (size_t)range[0];
  interval->last = (size_t)range[1];
  interval->root =
      (enum ph_root)read_word(r, &items[3], names[3], "root", PH_ROOT_N);
  for (size_t i = 0; i < sizeof values / sizeof values[0]; i++) {
    *values[i] = ph_read_number(r, &items[4 + i], names[4 + i], (double)NAN);
  }
}

static void read_intervals(struct ph_json_reader *r,
                           const struct ph_json_item *from, size_t segments,
                           struct ph_interval **intervals, size_t *n) {
  struct ph_json_walk walk;
  struct ph_json_item item;
  size_t mark;
  if (r->status != PH_OK || !from->value) {
    return;
  }
  mark = ph_read_enter(r, member_names[INTERVALS]);
  *n = ph_read_size(r, from);
  *intervals = ph_read_array_of(r, *n, sizeof **intervals);
  ph_json_walk_init(&walk, from->value, from->value_n);
  for (size_t i = 0; r->status == PH_OK && i < *n; i++) {
    size_t inner = ph_read_enter_at(r, i);
    ph_json_walk_next(&walk, &item);
    read_interval(r, &item, segments, *intervals + i);
    ph_read_leave(r, inner);
  }
  ph_read_leave(r, mark);
}

/* ---- solutions ----------------------------------------------------------- */

static void read_solution(struct ph_json_reader *r,
                          const struct ph_json_item *from,
                          const struct ph_result *result,
                          struct ph_solution *solution) {
  static const char *const names[] = {PH_SOLUTION_MEMBERS(NAME)};
  struct ph_json_item items[5];
  size_t intervals_n = result->intervals_n, mark;
  const struct ph_curve *c = &result->curve;
  *solution = (struct ph_solution){.curve = {.kind = c->kind,
                                             .dimension = c->dimension,
                                             .degree = c->degree,
                                             .closed = c->closed}};
  ph_read_members(r, from, names, 5, items);
  solution->good = ph_read_flag(r, &items[0], names[0], false);
  if (r->status != PH_OK || !ph_read_required(r, &items[1], names[1])) {
    return;
  }
  ph_read_segments(r, &items[1], &solution->curve);
  if (result->intervals_n > 0) {
    ph_read_required(r, &items[2], names[2]);
  }
  read_intervals(r, &items[2], solution->curve.n, &solution->intervals,
                 &intervals_n);
  if (r->status == PH_OK && intervals_n != result->intervals_n) {
    mark = ph_read_enter(r, names[2]);
    ph_read_fail(r, PH_BAD_SHAPE,
                 "must be %zu as of the best solution, found "
                 "%zu",
                 result->intervals_n, intervals_n);
    ph_read_leave(r, mark);
  }
  solution->curve.length = ph_read_number(r, &items[3], names[3], (double)NAN);
  read_diagnostics(r, &items[4], &solution->diagnostics, NULL);
}

static void read_solutions(struct ph_json_reader *r,
                           const struct ph_json_item *from,
                           struct ph_result *result) {
  struct ph_json_walk walk;
  struct ph_json_item item;
  size_t mark, n;
  if (r->status != PH_OK || !from->value) {
    return;
  }
  mark = ph_read_enter(r, member_names[SOLUTIONS]);
  n = ph_read_size(r, from);
  result->solutions = ph_read_array_of(r, n, sizeof *result->solutions);
  ph_json_walk_init(&walk, from->value, from->value_n);
  for (size_t i = 0; r->status == PH_OK && i < n; i++) {
    size_t inner = ph_read_enter_at(r, i);
    ph_json_walk_next(&walk, &item);
    read_solution(r, &item, result, &result->solutions[i]);
    ph_read_leave(r, inner);
  }
  result->solutions_n = n;
  ph_read_leave(r, mark);
}

/* ---- the whole ----------------------------------------------------------- */

/* What says how the curve is to be read. */
static void read_kind(struct ph_json_reader *r,
                      const struct ph_json_item *items, struct ph_curve *c) {
  static const enum member required[] = {CURVE, DIMENSION, DEGREE, CLOSED};
  if (!items[SEGMENTS].value) {
    ph_read_enter(r, member_names[SEGMENTS]);
    ph_read_fail(r, PH_MISSING_FIELD, "is missing: this is no result");
    return;
  }
  for (size_t i = 0; i < sizeof required / sizeof required[0]; i++) {
    ph_read_required(r, &items[required[i]], member_names[required[i]]);
  }
  c->kind = (enum ph_curve_kind)read_word(r, &items[CURVE], member_names[CURVE],
                                          "kind", 0);
  c->dimension =
      ph_read_whole(r, &items[DIMENSION], member_names[DIMENSION], 2, 3);
  c->degree = ph_read_whole(r, &items[DEGREE], member_names[DEGREE], 1,
                            PH_CLAIM_DEGREE_MAX);
  c->closed = ph_read_flag(r, &items[CLOSED], member_names[CLOSED], false);
}

static void read_result(struct ph_json_reader *r,
                        const struct ph_json_item *items,
                        struct ph_result *result) {
  struct ph_curve *c = &result->curve;
  read_kind(r, items, c);
  if (r->status != PH_OK) {
    return;
  }
  ph_read_segments(r, &items[SEGMENTS], c);
  ph_read_sphere(r, &items[CENTER], c);
  c->length =
      ph_read_number(r, &items[LENGTH], member_names[LENGTH], (double)NAN);
  read_intervals(r, &items[INTERVALS], c->n, &result->intervals,
                 &result->intervals_n);
  ph_read_offsets(r, &items[OFFSETS], c, &result->offsets, &result->offsets_n);
  ph_read_samples(r, &items[SAMPLES], c, &result->samples);
  if (items[FRAME].value) {
    result->samples.frame = (enum ph_frame)(
        1 + read_word(r, &items[FRAME], member_names[FRAME], "frame", 0));
  }
  read_diagnostics(r, &items[DIAGNOSTICS], &result->diagnostics, result);
  read_solutions(r, &items[SOLUTIONS], result);
}

/* "sweep" or "set": names and values as they stand there. */
static void read_fields(struct ph_json_reader *r,
                        const struct ph_json_item *from, const char *name,
                        struct ph_swept **fields, size_t *fields_n) {
  struct ph_json_walk walk;
  struct ph_json_item item;
  size_t n = 0, mark;
  if (r->status != PH_OK || !from->value) {
    return;
  }
  mark = ph_read_enter(r, name);
  if (*from->value != '{') {
    ph_read_fail(r, PH_BAD_TYPE, "must be an object");
    return;
  }
  ph_json_walk_init(&walk, from->value, from->value_n);
  while (ph_json_walk_next(&walk, &item)) {
    n++;
  }
  *fields = ph_read_array_of(r, n, sizeof **fields);
  ph_json_walk_init(&walk, from->value, from->value_n);
  while (r->status == PH_OK && ph_json_walk_next(&walk, &item)) {
    struct ph_swept *field = *fields + *fields_n;
    field->name = ph_arena_copy(r->arena, item.key, item.key_n);
    field->value = ph_json_one_line(&item, r->arena);
    if (!field->name || !field->value) {
      r->status = ph_fail_memory(r->diag);
      return;
    }
    *fields_n += 1;
  }
  ph_read_leave(r, mark);
}

/* What a record says of itself. */
static void read_heading(struct ph_json_reader *r,
                         const struct ph_json_item *items,
                         struct ph_claim *claim) {
  const char *status;
  claim->command =
      ph_read_string(r, &items[COMMAND], member_names[COMMAND], NULL);
  status = ph_read_string(r, &items[STATUS], member_names[STATUS], "ok");
  claim->solved = strcmp(status, "error") != 0;
  if (claim->solved && strcmp(status, "ok") != 0) {
    ph_read_enter(r, member_names[STATUS]);
    ph_read_fail(r, PH_BAD_VALUE, "must be \"ok\" or \"error\"");
  }
  if (!claim->solved && items[SEGMENTS].value) {
    ph_read_enter(r, member_names[SEGMENTS]);
    ph_read_fail(r, PH_BAD_SHAPE, "are not of an error record");
  }
  read_fields(r, &items[SWEEP], member_names[SWEEP], &claim->swept,
              &claim->swept_n);
  read_fields(r, &items[SET], member_names[SET], &claim->set, &claim->set_n);
}

enum ph_status ph_json_result_in(const struct ph_record *record,
                                 struct ph_arena *arena, struct ph_claim *claim,
                                 struct ph_diag *diag) {
  struct ph_json_reader r = {.arena = arena, .diag = diag};
  struct ph_json_item items[MEMBERS];
  const struct ph_json_item whole = {NULL, 0, record->text, record->n};
  struct ph_diag later;
  enum ph_status status;
  memset(claim, 0, sizeof *claim);
  if (*record->text != '{') {
    return ph_fail(diag, PH_BAD_TYPE, NULL,
                   "a result must be an object, found %s",
                   ph_value_type(*record->text));
  }
  ph_read_members(&r, &whole, member_names, MEMBERS, items);
  status = ph_json_echo(&items[ID], &items[META], arena, &claim->echo,
                        r.status == PH_OK ? diag : &later);
  r.status = r.status == PH_OK ? status : r.status;
  read_heading(&r, items, claim);
  if (r.status == PH_OK && claim->solved) {
    read_result(&r, items, &claim->result);
  }
  return r.status;
}
