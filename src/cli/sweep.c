/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Reads and applies sweeps (see sweep.h). */
#include "cli/sweep.h"

#include "base/suggest.h"
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
  size_t name_n;
  p = p ? p : end;
  name_n = (size_t)(p - text);
  sweep->field = ph_field_find(schema, text, name_n);
  if (!sweep->field) {
    return ph_fail(diag, PH_USAGE, NULL, "--sweep: unknown field '%.*s'",
                   (int)name_n, text);
  }
  while (p < end) {
    size_t index = 0, digits = 0;
    bool bracket = *p++ == '[';
    for (; p < end && *p >= '0' && *p <= '9' && digits < 18; p++) {
      index = 10 * index + (size_t)(*p - '0');
      digits++;
    }
    if (!bracket || p == end || *p++ != ']' || !digits ||
        sweep->index_n == PH_SWEEP_INDICES_MAX) {
      return ph_fail(diag, PH_USAGE, NULL,
                     "--sweep: '%.*s' is not a field or an element like "
                     "knots[2] or points[0][1]",
                     (int)n, text);
    }
    sweep->index[sweep->index_n++] = index;
  }
  return PH_OK;
}

/* An element of an array field is a number; a whole field is what its row
 * allows. */
static enum ph_status read_value(const char *text, size_t n, size_t i,
                                 struct ph_arena *arena, struct ph_sweep *sweep,
                                 struct ph_diag *diag) {
  struct ph_value *value = &sweep->values[i];
  char *copy = ph_arena_copy(arena, text, n);
  if (!copy) {
    return ph_fail_memory(diag);
  }
  if (sweep->index_n == 0) {
    struct ph_diag why;
    enum ph_status status =
        ph_value_read_option(copy, sweep->field, arena, value, &why);
    if (status == PH_NO_MEMORY) {
      return ph_fail_memory(diag);
    }
    if (status != PH_OK) {
      return ph_fail(diag, PH_USAGE, NULL, "--sweep: %s %s", why.field,
                     why.message);
    }
  } else if (!read_number(text, n, &value->number)) {
    return ph_fail(diag, PH_USAGE, NULL,
                   "--sweep: %s takes numbers, found '%.*s'", sweep->name,
                   (int)n, text);
  }
  if (sweep->index_n > 0 || value->kind == PH_NUMBER) {
    copy = ph_arena_array(arena, PH_NUMBER_MAX + 1, 1);
    if (copy) {
      copy[ph_number_write(copy, value->number)] = '\0';
    }
  } else if (value->kind == PH_WORD) {
    size_t length = strlen(value->word); /* words need no escapes */
    copy = ph_arena_array(arena, length + 3, 1);
    if (copy) {
      copy[0] = copy[length + 1] = '"';
      memcpy(copy + 1, value->word, length);
      copy[length + 2] = '\0';
    }
  }
  sweep->texts[i] = copy;
  return copy ? PH_OK : ph_fail_memory(diag);
}

static enum ph_status allocate(struct ph_sweep *sweep, struct ph_arena *arena,
                               struct ph_diag *diag) {
  sweep->values = ph_arena_array(arena, sweep->n, sizeof *sweep->values);
  sweep->texts = ph_arena_array(arena, sweep->n, sizeof *sweep->texts);
  if (!sweep->values || !sweep->texts) {
    return ph_fail_memory(diag);
  }
  memset(sweep->values, 0, sweep->n * sizeof *sweep->values);
  return PH_OK;
}

/* START:STOP:COUNT, if the text has that form. */
static enum ph_status read_range(const char *text, const char *first,
                                 const char *second, struct ph_arena *arena,
                                 struct ph_sweep *sweep, struct ph_diag *diag) {
  double start, stop, count;
  enum ph_status status = PH_OK;
  if (!read_number(text, (size_t)(first - text), &start) ||
      !read_number(first + 1, (size_t)(second - first - 1), &stop) ||
      !read_number(second + 1, strlen(second + 1), &count) || !(count >= 1) ||
      count > COUNT_MAX || floor(count) < count) {
    return ph_fail(diag, PH_USAGE, NULL,
                   "--sweep: '%s' is not START:STOP:COUNT with a COUNT of at "
                   "least 1",
                   text);
  }
  sweep->n = (size_t)count;
  status = allocate(sweep, arena, diag);
  for (size_t i = 0; status == PH_OK && i < sweep->n; i++) {
    double part = sweep->n > 1 ? (double)i / (double)(sweep->n - 1) : 0;
    double x =
        i + 1 == sweep->n && i > 0 ? stop : start + part * (stop - start);
    char digits[PH_NUMBER_MAX];
    size_t n = ph_number_write(digits, x);
    status = read_value(digits, n, i, arena, sweep, diag);
  }
  return status;
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
  enum ph_status status;
  const char *p = text;
  sweep->n = 1;
  for (const char *q = element_end(p); *q; q = element_end(q + 1)) {
    sweep->n++;
  }
  status = allocate(sweep, arena, diag);
  for (size_t i = 0; status == PH_OK && i < sweep->n; i++) {
    const char *end = element_end(p);
    status = read_value(p, (size_t)(end - p), i, arena, sweep, diag);
    p = end + 1;
  }
  return status;
}

enum ph_status ph_sweep_read(const char *text, const struct ph_schema *schema,
                             struct ph_arena *arena, struct ph_sweep *sweep,
                             struct ph_diag *diag) {
  const char *equals = strchr(text, '=');
  const char *first, *second;
  size_t name_n = equals ? (size_t)(equals - text) : 0;
  enum ph_status status;
  memset(sweep, 0, sizeof *sweep);
  if (!equals || name_n == 0) {
    return ph_fail(diag, PH_USAGE, NULL,
                   "--sweep: '%s' is not FIELD=START:STOP:COUNT or "
                   "FIELD=V1,V2,...",
                   text);
  }
  sweep->name = ph_arena_copy(arena, text, name_n);
  if (!sweep->name) {
    return ph_fail_memory(diag);
  }
  status = read_target(text, name_n, schema, sweep, diag);
  if (status != PH_OK) {
    return status;
  }
  first = strchr(equals + 1, ':');
  second = first ? strchr(first + 1, ':') : NULL;
  return second ? read_range(equals + 1, first, second, arena, sweep, diag)
                : read_list(equals + 1, arena, sweep, diag);
}

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

/* The number in a problem's array that a sweep sets; the array is copied, as
 * other results of the same problem keep their own. */
static enum ph_status set_element(const struct ph_sweep *sweep, double x,
                                  struct ph_arena *arena,
                                  struct ph_value *value,
                                  struct ph_diag *diag) {
  const char *name = ph_field_name(sweep->field->id);
  size_t at = sweep->index[0], total, depth;
  double *copy;
  depth = value->kind == PH_NUMBERS ? 1 : value->kind == PH_VECTORS ? 2 : 0;
  if (depth != sweep->index_n || at >= value->n ||
      (depth == 2 && sweep->index[1] >= value->dimension)) {
    return ph_fail(diag, PH_BAD_SHAPE, name,
                   "has no element %s for --sweep to set", sweep->name);
  }
  total = depth == 2 ? value->n * value->dimension : value->n;
  copy = ph_arena_array(arena, total, sizeof *copy);
  if (!copy) {
    return ph_fail_memory(diag);
  }
  memcpy(copy, value->v, total * sizeof *copy);
  copy[depth == 2 ? at * value->dimension + sweep->index[1] : at] = x;
  value->v = copy;
  return PH_OK;
}

enum ph_status ph_sweep_apply(const struct ph_sweep *sweeps, size_t n,
                              size_t which, struct ph_arena *arena,
                              struct ph_problem *problem,
                              struct ph_swept *swept, struct ph_diag *diag) {
  enum ph_status status = PH_OK;
  for (size_t i = n; i-- > 0;) {
    const struct ph_sweep *sweep = &sweeps[i];
    struct ph_value *value = &problem->field[sweep->field->id];
    size_t at = which % sweep->n;
    which /= sweep->n;
    swept[i].name = sweep->name;
    swept[i].value = sweep->texts[at];
    if (status == PH_OK && sweep->index_n > 0) {
      double x = sweep->values[at].number;
      status = set_element(sweep, x, arena, value, diag);
    } else if (status == PH_OK) {
      *value = sweep->values[at];
    }
  }
  return status;
}
