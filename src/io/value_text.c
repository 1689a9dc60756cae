/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Values of fields as JSON (see value.h). */
#include "io/value.h"

#include "io/number.h"

#include <string.h>

/* [a,b] */
static char *put_numbers(char *to, const double *v, size_t n) {
  *to++ = '[';
  for (size_t i = 0; i < n; i++) {
    if (i > 0) {
      *to++ = ',';
    }
    to += ph_number_write(to, v[i]);
  }
  *to++ = ']';
  return to;
}

/* [[a,b],[c,d]] */
static char *put_vectors(char *to, const double *v, size_t n,
                         size_t dimension) {
  *to++ = '[';
  for (size_t i = 0; i < n; i++) {
    if (i > 0) {
      *to++ = ',';
    }
    to = put_numbers(to, v + i * dimension, dimension);
  }
  *to++ = ']';
  return to;
}

/* [[a,b,c],[a]] */
static char *put_lists(char *to, const struct ph_value *value) {
  const double *v = value->v;
  *to++ = '[';
  for (size_t i = 0; i < value->sizes_n; i++) {
    if (i > 0) {
      *to++ = ',';
    }
    to = put_numbers(to, v, value->sizes[i]);
    v += value->sizes[i];
  }
  *to++ = ']';
  return to;
}

/* [[[a,b],[c,d]],[[c,d],[e,f]]] */
static char *put_polyline(char *to, const struct ph_value *value) {
  const double *v = value->v;
  *to++ = '[';
  for (size_t i = 0; i < value->sizes_n; i++) {
    if (i > 0) {
      *to++ = ',';
    }
    to = put_vectors(to, v, value->sizes[i], value->dimension);
    v += value->sizes[i] * value->dimension;
  }
  *to++ = ']';
  return to;
}

const char *ph_value_text(const struct ph_value *value,
                          struct ph_arena *arena) {
  size_t numbers = value->v ? value->n * value->dimension : 1;
  size_t arrays = value->n + value->sizes_n + 1;
  size_t word = value->word ? strlen(value->word) : 0;
  char *text = ph_arena_array(
      arena, numbers * (PH_NUMBER_MAX + 1) + 3 * arrays + word + 3, 1);
  char *to = text;
  if (!text) {
    return NULL;
  }
  if (value->kind == PH_NUMBER) {
    to += ph_number_write(to, value->number);
  } else if (value->kind == PH_BOOL) {
    return value->flag ? "true" : "false";
  } else if (value->word) { /* words and paths need no escapes */
    *to++ = '"';
    memcpy(to, value->word, word);
    to += word;
    *to++ = '"';
  } else if (value->kind == PH_NUMBERS) {
    to = put_numbers(to, value->v, value->n);
  } else if (value->kind == PH_VECTORS) {
    to = put_vectors(to, value->v, value->n, value->dimension);
  } else if (value->kind == PH_LISTS) {
    to = put_lists(to, value);
  } else {
    to = put_polyline(to, value);
  }
  *to = '\0';
  return text;
}
