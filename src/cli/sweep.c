/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Reads and applies sweeps (see sweep.h). */
#include "cli/sweep.h"

#include "base/suggest.h"
#include "cli/option.h"
#include "io/number.h"
#include "io/value.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

/* More values than this in one sweep are a slip of the keyboard. */
static const double COUNT_MAX = 1e9;

/* Reads a whole text as a number. */
static bool read_number(const char *text, size_t n, double *x) {
  const char *end = text + n;
  return n > 0 && ph_number_read_text(text, end, x) == end && isfinite(*x);
}

/* name[1][2]: the field's name and its indices. */
static enum ph_status read_target(const char *text, size_t n,
                                  const struct ph_schema *schema,
                                  struct ph_sweep *sweep,
                                  struct ph_diag *diag) {
  const char *end = text + n, *p = memchr(text, '[', n);
  size_t index_max;
  char excerpt[PH_EXCERPT_MAX];
  p = p ? p : end;
  sweep->field = ph_command_field(schema, text, (size_t)(p - text));
  if (!sweep->field) {
    return ph_option_no_field(schema, "--sweep", text, (size_t)(p - text),
                              diag);
  }
  index_max =
      PH_SWEEP_INDICES_MAX - (sweep->field->kinds & PH_POLYLINE ? 0 : 1);
  while (p < end) {
    size_t index = 0, digits = 0;
    bool bracket = *p++ == '[';
    for (; p < end && *p >= '0' && *p <= '9' && digits < 18; p++) {
      index = 10 * index + (size_t)(*p - '0');
      digits++;
    }
    if (!bracket || p == end || *p++ != ']' || !digits ||
        sweep->index_n == index_max) {
      return ph_fail(diag, PH_E_USAGE, NULL,
                     "--sweep: '%s' is not a field or an element like "
                     "knots[2] or points[0][1]",
                     ph_excerpt(text, n, excerpt));
    }
    sweep->index[sweep->index_n++] = index;
  }
  return PH_OK;
}

/* ---- values ----------------------------------------------------------- */

/* An element of an array field is a number; a whole field is what its row
 * allows. */
static enum ph_status read_value(const char *text, size_t n,
                                 const struct ph_sweep *sweep,
                                 struct ph_arena *arena, struct ph_value *value,
                                 struct ph_diag *diag) {
  bool element = sweep->index_n > 0 || sweep->factor;
  char excerpt[PH_EXCERPT_MAX];
  const char *copy;
  struct ph_diag why;
  enum ph_status status;
  value->kind = PH_NUMBER;
  if (element && read_number(text, n, &value->number)) {
    return PH_OK;
  }
  if (element || n == 0) {
    return ph_fail(diag, PH_E_USAGE, NULL, "--sweep: %s takes %s, found '%s'",
                   sweep->name, element ? "numbers" : "values",
                   ph_excerpt(text, n, excerpt));
  }
  copy = ph_arena_copy(arena, text, n);
  status = copy ? ph_value_read_option(copy, sweep->field, arena, value, &why)
                : PH_E_NO_MEMORY;
  if (status == PH_E_NO_MEMORY) {
    return ph_fail_memory(diag);
  }
  return status == PH_OK ? PH_OK
                         : ph_fail(diag, PH_E_USAGE, NULL, "--sweep: %s %s",
                                   why.field, why.message);
}

/* START:STOP:COUNT or START:STOP:COUNT:log */
static enum ph_status read_range(const char *text, const char *first,
                                 struct ph_arena *arena, struct ph_sweep *sweep,
                                 struct ph_diag *diag) {
  struct ph_value value;
  enum ph_status status = ph_range_read(text, strlen(text), COUNT_MAX,
                                        "--sweep", &sweep->range, diag);
  sweep->n = sweep->range.n;
  /* may the field be a number? */
  return status == PH_OK ? read_value(text, (size_t)(first - text), sweep,
                                      arena, &value, diag)
                         : status;
}

/* The end of the list element at p: a comma outside of brackets, or the end. */
static const char *element_end(const char *p) {
  int depth = 0;
  for (; *p && (*p != ',' || depth > 0); p++) {
    depth += *p == '[' ? 1 : *p == ']' ? -1 : 0;
  }
  return p;
}

static enum ph_status read_list(const char *text, struct ph_arena *arena,
                                struct ph_sweep *sweep, struct ph_diag *diag) {
  const char *p = text;
  sweep->n = 1;
  for (const char *q = element_end(p); *q; q = element_end(q + 1)) {
    sweep->n++;
  }
  sweep->values = ph_arena_array(arena, sweep->n, sizeof *sweep->values);
  sweep->texts = ph_arena_array(arena, sweep->n, sizeof *sweep->texts);
  if (!sweep->values || !sweep->texts) {
    return ph_fail_memory(diag);
  }
  memset(sweep->values, 0, sweep->n * sizeof *sweep->values);
  for (size_t i = 0; i < sweep->n; i++) {
    const char *end = element_end(p);
    enum ph_status status =
        read_value(p, (size_t)(end - p), sweep, arena, &sweep->values[i], diag);
    if (status != PH_OK) {
      return status;
    }
    sweep->texts[i] = ph_value_text(&sweep->values[i], arena);
    if (!sweep->texts[i]) {
      return ph_fail_memory(diag);
    }
    p = end + 1;
  }
  return PH_OK;
}

enum ph_status ph_sweep_read(const char *text, const struct ph_schema *schema,
                             struct ph_arena *arena, struct ph_sweep *sweep,
                             struct ph_diag *diag) {
  const char *equals = strchr(text, '=');
  const char *first, *second;
  char excerpt[PH_EXCERPT_MAX];
  size_t name_n = equals ? (size_t)(equals - text) : 0, target_n = name_n;
  enum ph_status status;
  char *name;
  memset(sweep, 0, sizeof *sweep);
  if (!equals || name_n == 0) {
    return ph_fail(diag, PH_E_USAGE, NULL,
                   "--sweep: '%s' is not FIELD=START:STOP:COUNT or "
                   "FIELD=V1,V2,...",
                   ph_excerpt(text, strlen(text), excerpt));
  }
  name = ph_arena_copy(arena, text, name_n);
  if (!name) {
    return ph_fail_memory(diag);
  }
  sweep->name = name;
  if (text[name_n - 1] == '*') {
    sweep->factor = true;
    target_n--;
  }
  status = read_target(text, target_n, schema, sweep, diag);
  if (status != PH_OK) {
    return status;
  }
  for (size_t i = 0; name[i] && name[i] != '['; i++) { /* as the field is */
    name[i] = name[i] == '-' ? '_' : name[i];
  }
  first = strchr(equals + 1, ':');
  second = first ? strchr(first + 1, ':') : NULL;
  return second ? read_range(equals + 1, first, arena, sweep, diag)
                : read_list(equals + 1, arena, sweep, diag);
}

bool ph_sweep_same(const struct ph_sweep *a, const struct ph_sweep *b) {
  return a->field == b->field && a->index_n == b->index_n &&
         memcmp(a->index, b->index, a->index_n * sizeof *a->index) == 0;
}

/* ---- combinations ----------------------------------------------------- */

size_t ph_sweep_count(const struct ph_sweep *sweeps, size_t n) {
  size_t count = 1;
  for (size_t i = 0; i < n; i++) {
    if (count > SIZE_MAX / sweeps[i].n) {
      return 0;
    }
    count *= sweeps[i].n;
  }
  return count;
}

/* Number i of the values. */
static struct ph_value value_at(const struct ph_sweep *sweep, size_t i) {
  struct ph_value value = {.kind = PH_NUMBER};
  if (sweep->values) {
    return sweep->values[i];
  }
  value.number = ph_range_at(&sweep->range, i);
  return value;
}

enum ph_status ph_sweep_name(const struct ph_sweep *sweeps, size_t n,
                             size_t which, struct ph_arena *arena,
                             struct ph_swept *swept, struct ph_diag *diag) {
  for (size_t i = n; i-- > 0;) {
    const struct ph_sweep *sweep = &sweeps[i];
    size_t at = which % sweep->n;
    which /= sweep->n;
    swept[i].name = sweep->name;
    if (sweep->texts) {
      swept[i].value = sweep->texts[at];
    } else {
      struct ph_value value = value_at(sweep, at);
      swept[i].value = ph_value_text(&value, arena);
    }
    if (!swept[i].value) {
      return ph_fail_memory(diag);
    }
  }
  return PH_OK;
}

/* Where the element of a sweep is among the numbers of an array; false when
 * the array has none such. */
static bool find_element(const struct ph_sweep *sweep,
                         const struct ph_value *value, size_t *at) {
  const size_t *index = sweep->index;
  size_t depth = value->kind == PH_NUMBERS    ? 1
                 : value->kind == PH_VECTORS  ? 2
                 : value->kind == PH_POLYLINE ? 3
                                              : 0;
  size_t first = 0, n = value->n;
  if (depth != sweep->index_n) {
    return false;
  }
  if (depth == 3) {
    if (index[0] >= value->sizes_n) {
      return false;
    }
    for (size_t i = 0; i < index[0]; i++) {
      first += value->sizes[i];
    }
    n = value->sizes[*index++];
  }
  if (*index >= n || (depth > 1 && index[1] >= value->dimension)) {
    return false;
  }
  *at = (first + index[0]) * value->dimension + (depth > 1 ? index[1] : 0);
  return true;
}

/* A copy of an array's numbers, as other results of the same problem keep their
 * own; NULL when memory is exhausted. */
static double *copy_of(const struct ph_value *value, struct ph_arena *arena) {
  size_t total = value->n * value->dimension;
  double *copy = ph_arena_array(arena, total, sizeof *copy);
  if (copy) {
    memcpy(copy, value->v, total * sizeof *copy);
  }
  return copy;
}

/* Sets, or multiplies, one number of a problem's array. */
static enum ph_status set_element(const struct ph_sweep *sweep, double x,
                                  struct ph_arena *arena,
                                  struct ph_value *value,
                                  struct ph_diag *diag) {
  size_t at;
  double *copy;
  if (!find_element(sweep, value, &at)) {
    return ph_fail(diag, PH_E_BAD_SHAPE, ph_field_name(sweep->field->id),
                   "has no element %s for --sweep to set", sweep->name);
  }
  copy = copy_of(value, arena);
  if (!copy) {
    return ph_fail_memory(diag);
  }
  copy[at] = sweep->factor ? copy[at] * x : x;
  value->v = copy;
  return PH_OK;
}

/* Multiplies all numbers of a field. */
static enum ph_status multiply(const struct ph_sweep *sweep, double x,
                               struct ph_arena *arena, struct ph_value *value,
                               struct ph_diag *diag) {
  const unsigned arrays = PH_NUMBERS | PH_VECTORS | PH_POLYLINE;
  double *copy;
  if (value->kind == PH_NUMBER) {
    value->number *= x;
    return PH_OK;
  }
  if (!(value->kind & arrays)) {
    return ph_fail(diag, PH_E_BAD_SHAPE, ph_field_name(sweep->field->id),
                   "has no numbers for --sweep to multiply");
  }
  copy = copy_of(value, arena);
  if (!copy) {
    return ph_fail_memory(diag);
  }
  for (size_t i = 0; i < value->n * value->dimension; i++) {
    copy[i] *= x;
  }
  value->v = copy;
  return PH_OK;
}

enum ph_status ph_sweep_apply(const struct ph_sweep *sweeps, size_t n,
                              size_t which, struct ph_arena *arena,
                              struct ph_problem *problem,
                              struct ph_diag *diag) {
  size_t stride = ph_sweep_count(sweeps, n);
  enum ph_status status = PH_OK;
  for (size_t i = 0; status == PH_OK && i < n; i++) {
    const struct ph_sweep *sweep = &sweeps[i];
    struct ph_value *field = &problem->field[sweep->field->id];
    struct ph_value value;
    stride /= sweep->n;
    value = value_at(sweep, which / stride % sweep->n);
    if (sweep->index_n > 0) {
      status = set_element(sweep, value.number, arena, field, diag);
    } else if (sweep->factor) {
      status = multiply(sweep, value.number, arena, field, diag);
    } else {
      *field = value;
    }
  }
  return status;
}
