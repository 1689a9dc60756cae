/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Members that are written (see chosen.h). */
#include "io/chosen.h"

#include "base/suggest.h"
#include "io/members.h"

#include <string.h>

/* These are written in any case. */
static const char *const always[] = {"id", "status", "error", "command"};

/* ---- reading ------------------------------------------------------------ */

/* The name of the objects that a type is made of. */
static const char *object_of(const char *type) {
  while (*type == '[') {
    type = strchr(type, ']') + 1;
  }
  return type;
}

/* A list of names, on its way. */
struct reader {
  struct ph_arena *arena;
  struct ph_diag *diag;
  const char *path; /* from its beginning */
};

static enum ph_status fail(const struct reader *r, const struct ph_members *of,
                           const char *name, size_t n) {
  struct ph_suggest suggest;
  char clause[PH_DID_YOU_MEAN_MAX], excerpt[PH_EXCERPT_MAX];
  const size_t path_n = (size_t)(name + n - r->path);
  ph_suggest_init(&suggest, name, n);
  for (const struct ph_member *row = of ? of->rows : NULL; row && row->name;
       row++) {
    ph_suggest_try(&suggest, row->name, strlen(row->name));
  }
  ph_did_you_mean(&suggest, clause);
  return ph_fail(r->diag, PH_E_USAGE, NULL, "--fields: no member '%s'%s",
                 ph_excerpt(r->path, path_n, excerpt), clause);
}

/* Finds a row, or a part of the error that is written in any case. */
static const struct ph_member *row_of(const struct ph_members *of,
                                      const char *name, size_t n) {
  const struct ph_member *row = of->rows;
  while (row->name &&
         (strlen(row->name) != n || memcmp(row->name, name, n) != 0)) {
    row++;
  }
  return row->name ? row : NULL;
}

/* Adds a name to a list, where it is not in it. */
static struct ph_chosen *add(struct ph_chosen **list, const char *name,
                             struct ph_arena *arena) {
  while (*list && strcmp((*list)->name, name) != 0) {
    list = &(*list)->next;
  }
  if (!*list) {
    *list = ph_arena_array(arena, 1, sizeof **list);
    if (*list) {
      **list = (struct ph_chosen){.name = name};
    }
  }
  return *list;
}

/* Adds one path. */
static enum ph_status add_path(const struct reader *r, const char *object,
                               const char *end, struct ph_chosen **list) {
  const struct ph_members *of = ph_members_find(object);
  for (const char *name = r->path;;) {
    const size_t n = strcspn(name, ".,");
    const struct ph_member *row = of ? row_of(of, name, n) : NULL;
    struct ph_chosen *chosen;
    if (!row) {
      return fail(r, of, name, n);
    }
    chosen = add(list, row->name, r->arena);
    if (!chosen) {
      return ph_fail_memory(r->diag);
    }
    if (name + n == end) {
      chosen->whole = true;
      return PH_OK;
    }
    of = ph_members_find(object_of(row->type));
    list = &chosen->inner;
    name += n + 1;
  }
}

enum ph_status ph_chosen_read(const char *text, enum ph_parts parts,
                              struct ph_arena *arena, struct ph_chosen **chosen,
                              struct ph_diag *diag) {
  struct reader reader = {arena, diag, text};
  *chosen = NULL;
  for (size_t i = 0; i < sizeof always / sizeof *always; i++) {
    struct ph_chosen *one = add(chosen, always[i], arena);
    if (!one) {
      return ph_fail_memory(diag);
    }
    one->whole = true;
  }
  for (;;) {
    const char *end = reader.path + strcspn(reader.path, ",");
    const bool error =
        strncmp(reader.path, "error", 5) == 0 && strchr(".,", reader.path[5]);
    enum ph_status status = add_path(
        &reader, error ? "failure" : ph_members_result(parts), end, chosen);
    if (status != PH_OK || !*end) {
      return status;
    }
    reader.path = end + 1;
  }
}

/* ---- asking ---------------------------------------------------------------
 */

bool ph_chosen_enter(const struct ph_chosen **chosen, const char *name) {
  const struct ph_chosen *one = *chosen;
  if (!one) {
    return true;
  }
  while (one && strcmp(one->name, name) != 0) {
    one = one->next;
  }
  if (one) {
    *chosen = one->whole ? NULL : one->inner;
  }
  return one != NULL;
}

uint64_t ph_chosen_unasked(const struct ph_chosen *chosen) {
  const struct ph_chosen *of[2] = {chosen, chosen};
  uint64_t unasked = 0;
  const bool main = ph_chosen_enter(&of[0], "diagnostics");
  const bool others = ph_chosen_enter(&of[1], "solutions") &&
                      ph_chosen_enter(&of[1], "diagnostics");
  for (int i = 0; i <= PH_DIAGNOSTIC_N; i++) {
    const char *name = i < PH_DIAGNOSTIC_N
                           ? ph_diagnostic_name((enum ph_diagnostic)i)
                           : "kantorovich";
    const struct ph_chosen *a = of[0], *b = of[1];
    if (!(main && ph_chosen_enter(&a, name)) &&
        !(others && ph_chosen_enter(&b, name))) {
      unasked |= (uint64_t)1 << i;
    }
  }
  return unasked;
}
