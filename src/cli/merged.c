/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What is said of joined points (see merged.h). */
#include "cli/merged.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* How many points a warning names. */
enum { NAMED_MAX = 8 };

/* The element that was given as that of index i of a field. */
static size_t given_as(const struct ph_merge *merge, const struct ph_field *row,
                       size_t i) {
  if (i < merge->kept_n) {
    return row->kinds & PH_DATUM      ? merge->kept[i]
           : row->kinds & PH_SEGMENTS ? merge->interval[i]
                                      : i;
  }
  return row->id == PH_F_KNOTS ? merge->n + (i - merge->kept_n) : i;
}

static bool is_of_name(char c) {
  return c == '_' || c == '.' || (c >= 'a' && c <= 'z');
}

/* Renumbers the elements of fields that a text[size] names. */
static void renumber(const struct ph_merge *merge, char *text, size_t size) {
  char old[PH_DIAG_MESSAGE_MAX];
  size_t n = 0;
  snprintf(old, sizeof old, "%s", text);
  for (const char *p = old; *p && n + 1 < size;) {
    size_t name_n = 0;
    const struct ph_field *row;
    char *end;
    while (is_of_name(p[name_n])) {
      name_n++;
    }
    row = p[name_n] == '[' ? ph_field_find(merge->schema, p, name_n) : NULL;
    name_n += name_n == 0;
    if (row && p[name_n + 1] >= '0' && p[name_n + 1] <= '9') {
      size_t i = strtoul(p + name_n + 1, &end, 10);
      n += (size_t)snprintf(text + n, size - n, "%.*s[%zu", (int)name_n, p,
                            given_as(merge, row, i));
      p = end;
    } else {
      n += (size_t)snprintf(text + n, size - n, "%.*s", (int)name_n, p);
      p += name_n;
    }
  }
}

void ph_merge_tell(const struct ph_merge *merge, struct ph_diag *diag) {
  size_t n;
  if (!merge->schema) {
    return;
  }
  renumber(merge, diag->field, sizeof diag->field);
  renumber(merge, diag->message, sizeof diag->message);
  if (diag->status == PH_E_TOO_FEW_POINTS) {
    n = strlen(diag->message);
    snprintf(diag->message + n, sizeof diag->message - n,
             ": merge joined %zu of %zu", merge->gone_n, merge->n);
  }
}

void ph_merge_result(const struct ph_merge *merge, struct ph_result *result) {
  char list[PH_DIAG_MESSAGE_MAX / 2];
  size_t n = 0;
  if (!merge->schema) {
    return;
  }
  for (size_t i = 0; i < result->warnings_n; i++) {
    ph_merge_tell(merge, &result->warnings[i].diag);
  }
  result->merged = merge->gone;
  result->merged_n = merge->gone_n;
  for (size_t i = 0; i < merge->gone_n && i < NAMED_MAX; i++) {
    n += (size_t)snprintf(list + n, sizeof list - n, "%s%s[%zu]",
                          i > 0 ? ", " : "", ph_field_name(merge->points),
                          merge->gone[i]);
  }
  if (merge->gone_n > 0) {
    ph_warn(result, PH_NO_SEGMENT, PH_W_MERGED_POINTS,
            "%zu of %zu points were joined with neighbours nearer than %g: "
            "%s%s",
            merge->gone_n, merge->n, merge->distance, list,
            merge->gone_n > NAMED_MAX ? ", ..." : "");
  }
}
