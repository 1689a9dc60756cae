/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Problems and their results (see pairing.h).
 *
 * Ids are compared as what they stand for: 1 and 1.0 are one, "a" and "\u0061"
 * are, and 1 and "1" are not.  A key is an id in that form.
 */
#include "cli/pairing.h"

#include "io/json_in.h"
#include "io/json_read.h"
#include "io/number.h"
#include "io/value.h"
#include "check/promise.h"

#include <stdlib.h>
#include <string.h>

/* ---- keys ---------------------------------------------------------------- */

/* "s" and a string, or "n" and a number; NULL when memory is exhausted. */
static const char *key_of(const struct ph_echo *echo, struct ph_arena *arena) {
  char number[PH_NUMBER_MAX + 1] = "n";
  const char *text;
  char *key;
  double x;
  if (ph_number_read(echo->id, echo->id + echo->id_n, &x)) {
    return ph_arena_copy(arena, number, 1 + ph_number_write(number + 1, x));
  }
  text = ph_value_string(echo->id, echo->id_n, arena);
  key = text ? ph_arena_array(arena, strlen(text) + 2, 1) : NULL;
  if (key) {
    key[0] = 's';
    memcpy(key + 1, text, strlen(text) + 1);
  }
  return key;
}

/* For qsort and bsearch: those without a key come first. */
static int compare_keys(const char *a, const char *b) {
  return !a || !b ? (a != NULL) - (b != NULL) : strcmp(a, b);
}

static int compare_paired(const void *a, const void *b) {
  const struct ph_paired *x = *(struct ph_paired *const *)a;
  const struct ph_paired *y = *(struct ph_paired *const *)b;
  int order = compare_keys(x->key, y->key);
  return order ? order : x->index < y->index ? -1 : 1;
}

static int compare_group(const void *key, const void *group) {
  const struct ph_paired_group *g = group;
  return compare_keys(*(const char *const *)key, g->paired[0]->key);
}

/* ---- problems ------------------------------------------------------------ */

/* The id of a record that is an object. */
static enum ph_status read_json_id(const struct ph_record *record,
                                   struct ph_arena *arena, struct ph_echo *echo,
                                   struct ph_diag *diag) {
  static const struct ph_member rows[] = {{.name = "id"}, {.name = NULL}};
  const struct ph_json_item whole = {NULL, 0, record->text, record->n};
  const struct ph_json_item none = {NULL, 0, NULL, 0};
  struct ph_json_reader r = {.arena = arena, .diag = diag};
  struct ph_json_item id;
  ph_read_members(&r, &whole, rows, &id);
  return r.status == PH_OK ? ph_json_echo(&id, &none, arena, echo, diag)
                           : r.status;
}

/* The key of a problem.  What is wrong with it otherwise is told when it is
 * read. */
static enum ph_status find_key(struct ph_pairing *p,
                               const struct ph_schema *schema,
                               struct ph_paired *paired, struct ph_diag *diag) {
  const struct ph_record *record = &paired->record;
  struct ph_echo echo = {0};
  struct ph_problem problem;
  struct ph_diag ignored;
  struct ph_mark mark = ph_arena_mark(&p->scratch);
  enum ph_status status = PH_OK;
  if (record->n > 0 && !record->mesh &&
      (record->status == PH_OK || record->status == PH_E_LIMIT ||
       record->named)) {
    status =
        record->columns
            ? ph_csv_in(record, schema, &p->scratch, &problem, &echo, &ignored)
            : read_json_id(record, &p->scratch, &echo, &ignored);
  }
  if (status != PH_E_NO_MEMORY && echo.id) {
    paired->key = key_of(&echo, &p->arena);
    status = paired->key ? PH_OK : PH_E_NO_MEMORY;
  }
  ph_arena_release(&p->scratch, mark);
  return status == PH_E_NO_MEMORY ? ph_fail_memory(diag) : PH_OK;
}

static enum ph_status keep(struct ph_pairing *p, const struct ph_schema *schema,
                           const struct ph_record *record,
                           const struct ph_diag *why, size_t *room,
                           struct ph_diag *diag) {
  struct ph_paired *paired = ph_arena_array(&p->arena, 1, sizeof *paired);
  const char *text = ph_arena_copy(&p->arena, record->text, record->n);
  p->paired = ph_arena_grow(&p->arena, p->paired, p->paired_n,
                            sizeof *p->paired, 64, room);
  if (!paired || !text || !p->paired) {
    return ph_fail_memory(diag);
  }
  *paired = (struct ph_paired){
      .record = *record, .schema = schema, .index = p->paired_n};
  paired->record.text = text;
  if (record->status != PH_OK) {
    paired->diag = *why;
  }
  p->paired[p->paired_n++] = paired;
  return find_key(p, schema, paired, diag);
}

/* Groups of those that have one key. */
static enum ph_status make_groups(struct ph_pairing *p, struct ph_diag *diag) {
  size_t n = p->paired_n;
  p->by_key = ph_arena_array(&p->arena, n, sizeof(struct ph_paired *));
  p->groups = ph_arena_array(&p->arena, n, sizeof *p->groups);
  if (!p->by_key || !p->groups) {
    return ph_fail_memory(diag);
  }
  p->all = (struct ph_paired_group){p->paired, n, 0, NULL};
  if (n > 0) {
    memcpy(p->by_key, p->paired, n * sizeof(struct ph_paired *));
    qsort(p->by_key, n, sizeof(struct ph_paired *), compare_paired);
  }
  for (size_t i = 0; i < n; i++) {
    struct ph_paired_group *group = p->groups + p->groups_n;
    if (i > 0 && compare_keys(p->by_key[i - 1]->key, p->by_key[i]->key) == 0) {
      group[-1].n++;
    } else {
      *group = (struct ph_paired_group){p->by_key + i, 1, 0, NULL};
      p->groups_n++;
    }
  }
  return PH_OK;
}

static enum ph_status load(struct ph_pairing *p, const struct ph_options *o,
                           const struct ph_schema *schema,
                           struct ph_diag *diag) {
  struct ph_record record;
  struct ph_diag why;
  size_t room = 0;
  enum ph_status status = ph_split_init(&p->split, &o->problems, 1,
                                        &o->problems_input, schema, diag);
  p->split_begun = true;
  p->loaded = true;
  while (status == PH_OK) {
    switch (ph_split_next(&p->split, true, &record, &why)) {
    case PH_SPLIT_RECORD:
      p->cut_off = ph_split_stopped(&p->split);
      status = keep(p, schema, &record, &why, &room, diag);
      break;
    case PH_SPLIT_FAILED:
      *diag = why;
      return why.status;
    default:
      status = make_groups(p, diag);
      if (p->groups_n && !p->groups[0].paired[0]->key) {
        p->groups[0].next = p->before;
      }
      return status;
    }
  }
  return status;
}

/* ---- results ------------------------------------------------------------- */

/* What pairing needs to know of a result. */
struct head {
  struct ph_echo echo;
  const char *key;
  const struct ph_command *command;
  const char *sweep;
};

/* As far as there is something; the rest is told when the result is read. */
static enum ph_status read_head(const struct ph_record *result,
                                struct ph_arena *arena, struct head *head,
                                struct ph_diag *diag) {
  static const struct ph_member rows[] = {
      {.name = "id"}, {.name = "command"}, {.name = "sweep"}, {.name = NULL}};
  const struct ph_json_item whole = {NULL, 0, result->text, result->n};
  const struct ph_json_item none = {NULL, 0, NULL, 0};
  struct ph_diag ignored;
  struct ph_json_reader r = {.arena = arena, .diag = &ignored};
  struct ph_json_item items[3];
  const char *command;
  *head = (struct head){.key = NULL};
  if (result->n == 0 ||
      (result->status != PH_OK && result->status != PH_E_LIMIT)) {
    return PH_OK;
  }
  ph_read_members(&r, &whole, rows, items);
  command = ph_read_string(&r, &items[1], rows[1].name, NULL);
  if (r.status == PH_OK && items[2].value) {
    head->sweep = ph_arena_copy(arena, items[2].value, items[2].value_n);
    r.status = head->sweep ? PH_OK : PH_E_NO_MEMORY;
  }
  if (r.status == PH_OK) {
    head->command =
        command && ph_promise_of(command) ? ph_command_find(command) : NULL;
    r.status = ph_json_echo(&items[0], &none, arena, &head->echo, &ignored);
  }
  if (r.status == PH_OK && head->echo.id) {
    head->key = key_of(&head->echo, arena);
    r.status = head->key ? PH_OK : PH_E_NO_MEMORY;
  }
  return r.status == PH_E_NO_MEMORY ? ph_fail_memory(diag) : PH_OK;
}

/* The problems that a result may be of; NULL: there are none. */
static struct ph_paired_group *group_of(struct ph_pairing *p, const char *key) {
  bool without = p->groups_n && !p->groups[0].paired[0]->key;
  bool no_keys = p->groups_n == 1 && without;
  if (no_keys || (!key && !without)) {
    return &p->all;
  }
  return bsearch(&key, p->groups, p->groups_n, sizeof *p->groups,
                 compare_group);
}

/* Takes the next problem of a group, or, in a sweep, the last one again. */
static enum ph_status take(struct ph_pairing *p, struct ph_paired_group *group,
                           const char *sweep, const struct ph_paired **paired,
                           struct ph_diag *diag) {
  bool again = sweep && group->sweep && strcmp(sweep, group->sweep) != 0;
  *paired = NULL;
  if (!again) {
    group->next++;
    group->sweep = NULL;
  }
  if (group->next > group->n) {
    return PH_OK;
  }
  group->paired[group->next - 1]->used = true;
  *paired = group->paired[group->next - 1];
  if (sweep && !again) {
    group->sweep = ph_arena_copy(&p->arena, sweep, strlen(sweep));
    return group->sweep ? PH_OK : ph_fail_memory(diag);
  }
  return PH_OK;
}

static enum ph_status find(struct ph_pairing *p, const struct ph_options *o,
                           const struct ph_record *result,
                           const struct head *head,
                           const struct ph_paired **paired,
                           struct ph_diag *diag) {
  struct ph_paired_group *group;
  enum ph_status status = PH_OK;
  if (!p->loaded && !head->command) {
    p->before += head->key ? 0 : 1;
    ph_fail(diag, PH_E_MISSING_FIELD, "command",
            "is missing: it is not known what problems this result solves");
    return PH_OK;
  }
  if (!p->loaded) {
    status = load(p, o, head->command->schema, diag);
  }
  if (status != PH_OK) {
    return status;
  }
  group = group_of(p, head->key);
  if (result->status != PH_OK && group == &p->all && p->paired_n &&
      p->groups[0].paired[0]->key) {
    return PH_OK; /* it may be of any */
  }
  status = group ? take(p, group, head->sweep, paired, diag) : PH_OK;
  if (status == PH_OK && !*paired) {
    if (group) {
      ph_fail(diag, PH_E_NOT_VERIFIED, NULL,
              "%s has only %zu problem%s%s, and this is a further result",
              o->problems, group->n, group->n == 1 ? "" : "s",
              group == &p->all ? ""
              : head->key      ? " of this id"
                               : " without id");
    } else {
      ph_fail(diag, PH_E_NOT_VERIFIED, "id", "is that of no problem in %s",
              o->problems);
    }
  }
  return status;
}

enum ph_status ph_pairing_find(struct ph_pairing *pairing,
                               const struct ph_options *options,
                               const struct ph_record *result,
                               const struct ph_paired **paired,
                               struct ph_diag *diag) {
  struct head head;
  enum ph_status status = read_head(result, &pairing->scratch, &head, diag);
  *paired = NULL;
  if (status == PH_OK) {
    status = find(pairing, options, result, &head, paired, diag);
  }
  ph_arena_reset(&pairing->scratch);
  return status;
}

/* ---- the end ---------------------------------------------------------------
 */

enum ph_status ph_pairing_finish(const struct ph_pairing *p,
                                 const struct ph_options *o,
                                 struct ph_diag *diag) {
  size_t unused = 0, line = 0;
  if (!p->loaded) {
    return ph_fail(diag, PH_E_NOT_VERIFIED, NULL,
                   "%s was not read: no result says what it solves",
                   o->problems);
  }
  for (size_t i = p->paired_n; i-- > 0;) {
    if (!p->paired[i]->used) {
      unused++;
      line = p->paired[i]->record.line;
    }
  }
  if (unused) {
    return ph_fail(diag, PH_E_NOT_VERIFIED, NULL,
                   "%s:%zu: %zu of %zu problems have no result, this one first",
                   o->problems, line, unused, p->paired_n);
  }
  return p->cut_off ? ph_fail(diag, PH_E_INPUT, NULL,
                              "%s is cut off by a syntax error", o->problems)
                    : PH_OK;
}

void ph_pairing_free(struct ph_pairing *pairing) {
  if (pairing->split_begun) {
    ph_split_free(&pairing->split);
  }
  ph_arena_free(&pairing->arena);
  ph_arena_free(&pairing->scratch);
}
