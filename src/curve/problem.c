/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Names of problem fields (see problem.h). */
#include "curve/problem.h"

#include <string.h>

static const char *const names[] = {
#define X(symbol, name) name,
    PH_FIELDS(X)
#undef X
};

bool ph_value_is(const struct ph_value *value, const char *word) {
  return value->kind == PH_WORD && strcmp(value->word, word) == 0;
}

const char *ph_field_name(enum ph_field_id id) {
  return names[id];
}

const struct ph_field *ph_field_find(const struct ph_schema *schema,
                                     const char *name, size_t n) {
  for (size_t i = 0; i < schema->fields_n; i++) {
    const char *candidate = names[schema->fields[i].id];
    if (strlen(candidate) == n && memcmp(candidate, name, n) == 0) {
      return &schema->fields[i];
    }
  }
  return NULL;
}
