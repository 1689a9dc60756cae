/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Reads single members (see json_form.h). */
#include "io/json_form.h"

#include "base/suggest.h"

#include <math.h>
#include <string.h>

size_t ph_read_word(struct ph_json_reader *r, const struct ph_json_item *item,
                    const char *name, const char *const *words, size_t absent) {
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
  ph_read_fail(r, PH_E_BAD_VALUE, "cannot be \"%s\"%s",
               ph_excerpt(text, strlen(text), excerpt), clause);
  ph_read_leave(r, mark);
  return absent;
}

/* In space, e2 or e3. */
static const char *read_vector(struct ph_json_reader *r,
                               const struct ph_json_item *item,
                               const char *name) {
  const char *vector = ph_read_string(r, item, name, NULL);
  if (vector && strcmp(vector, "e2") != 0 && strcmp(vector, "e3") != 0) {
    ph_read_enter(r, name);
    ph_read_fail(r, PH_E_BAD_VALUE, "must be \"e2\" or \"e3\"");
  }
  return vector;
}

static double read_radius(struct ph_json_reader *r,
                          const struct ph_json_item *item, const char *name) {
  double radius = ph_read_number(r, item, name, 0);
  if (!(radius > 0)) {
    ph_read_enter(r, name);
    ph_read_fail(r, PH_E_BAD_VALUE, "must be greater than 0, found %g", radius);
  }
  return radius;
}

/* The signs at the nodes. */
static void read_signs(struct ph_json_reader *r,
                       const struct ph_json_item *item, const char *name,
                       signed char *signs, size_t n) {
  double *v = ph_read_array_of(r, n, sizeof *v);
  ph_read_numbers(r, item, name, v, n);
  for (size_t i = 0; r->status == PH_OK && i < n; i++) {
    if (!(fabs(v[i]) <= 0) && !(fabs(v[i]) >= 1 && fabs(v[i]) <= 1)) {
      ph_read_enter(r, name);
      ph_read_enter_at(r, i);
      ph_read_fail(r, PH_E_BAD_VALUE, "must be -1, 0 or 1, found %g", v[i]);
    } else {
      signs[i] = (signed char)v[i];
    }
  }
}

/* The first and the last segment of an interval. */
static void read_range(struct ph_json_reader *r,
                       const struct ph_json_item *item, const char *name,
                       size_t *ends, size_t last) {
  double v[2] = {0, 0};
  ph_read_numbers(r, item, name, v, 2);
  if (!(v[0] >= 0) || !(v[0] <= v[1]) || !(v[1] <= (double)last) ||
      floor(v[0]) < v[0] || floor(v[1]) < v[1]) {
    ph_read_enter(r, name);
    ph_read_fail(r, PH_E_BAD_VALUE,
                 "must be the first and the last of its segments, at most "
                 "%zu, found [%g,%g]",
                 last, v[0], v[1]);
    return;
  }
  ends[0] = (size_t)v[0];
  ends[1] = (size_t)v[1];
}

/* The knots: a segment begins where the one before ended. */
static void read_knots(struct ph_json_reader *r,
                       const struct ph_json_item *item, const char *name,
                       double *knots, size_t k) {
  double ends[2] = {0, 0};
  ph_read_numbers(r, item, name, ends, 2);
  if (k > 0 && (ends[0] < *knots || ends[0] > *knots)) {
    ph_read_enter(r, name);
    ph_read_fail(r, PH_E_BAD_VALUE,
                 "begins at %.17g, but segments[%zu] ends at %.17g", ends[0],
                 k - 1, *knots);
  }
  knots[0] = ends[0];
  knots[1] = ends[1];
}

void ph_read_list(struct ph_json_reader *r, const struct ph_slot *slot,
                  const struct ph_json_item *item, void *at, size_t *n) {
  const size_t dimension = slot->dimension ? slot->dimension : 1;
  const char *name = slot->row->name;
  double *v;
  *n = ph_read_size(r, item);
  v = *n ? ph_read_array_of(r, *n, dimension * sizeof *v) : NULL;
  memcpy(at, &v, sizeof v);
  if (v && slot->dimension) {
    ph_read_vectors(r, item, name, v, *n, dimension);
  } else if (v) {
    ph_read_numbers(r, item, name, v, *n);
  }
}

/* So many whole numbers. */
static void read_wholes(struct ph_json_reader *r, const struct ph_slot *slot,
                        const struct ph_json_item *item, size_t *v, size_t n) {
  struct ph_json_walk walk;
  struct ph_json_item index;
  ph_json_walk_init(&walk, item->value, item->value_n);
  for (size_t i = 0; r->status == PH_OK && i < n; i++) {
    size_t inner = ph_read_enter_at(r, i);
    ph_json_walk_next(&walk, &index);
    v[i] = ph_read_whole(r, &index, NULL, slot->row->as->least, slot->most);
    ph_read_leave(r, inner);
  }
}

/* Exactly n of them. */
static void read_fixed(struct ph_json_reader *r, const struct ph_slot *slot,
                       const struct ph_json_item *item, size_t *v) {
  size_t mark = ph_read_enter(r, slot->row->name);
  size_t found = ph_read_size(r, item);
  if (r->status == PH_OK && found != slot->n) {
    ph_read_fail(r, PH_E_BAD_SHAPE, "must have %zu numbers, found %zu", slot->n,
                 found);
  }
  read_wholes(r, slot, item, v, slot->n);
  ph_read_leave(r, mark);
}

void ph_read_indices(struct ph_json_reader *r, const struct ph_slot *slot,
                     const struct ph_json_item *item, void *at, size_t *n) {
  size_t mark = ph_read_enter(r, slot->row->name), *v;
  *n = ph_read_size(r, item);
  v = *n ? ph_read_array_of(r, *n, sizeof *v) : NULL;
  memcpy(at, &v, sizeof v);
  read_wholes(r, slot, item, v, *n);
  ph_read_leave(r, mark);
}

static void read_doubles(struct ph_json_reader *r, const struct ph_slot *slot,
                         const struct ph_json_item *item, double *v) {
  const char *name = slot->row->name;
  if (slot->dimension) {
    ph_read_vectors(r, item, name, v, slot->n, slot->dimension);
  } else if (slot->n) {
    ph_read_numbers(r, item, name, v, slot->n);
  } else {
    *v = ph_read_number(r, item, name, (double)NAN);
  }
}

void ph_read_nothing(const struct ph_slot *slot, char *at) {
  const double nan = (double)NAN;
  const struct ph_type *type = slot->row->as;
  const bool numbers = slot->form == PH_AS_DOUBLE || slot->form == PH_AS_OPEN;
  unsigned word = 0;
  memset(at, slot->form == PH_AS_AMONG || slot->form == PH_AS_SIZE ? 255 : 0,
         slot->size);
  for (size_t i = 0; numbers && i < slot->size; i += sizeof(double)) {
    memcpy(at + i, &nan, sizeof nan);
  }
  if (slot->form == PH_AS_ENUM && type->least == 0) { /* what is after all */
    const char *const *words = ph_words(type->name);
    while (words[word]) {
      word++;
    }
    memcpy(at, &word, sizeof word);
  }
}

void ph_read_form(struct ph_json_reader *r, const struct ph_slot *slot,
                  const struct ph_json_item *item, void *at, size_t k) {
  const struct ph_type *type = slot->row->as;
  const char *name = slot->row->name;
  unsigned word;
  switch (slot->form) {
  case PH_AS_DOUBLE:
    read_doubles(r, slot, item, at);
    break;
  case PH_AS_OPEN:
    ph_read_open(r, item, name, at, slot->n);
    break;
  case PH_AS_RADIUS:
    *(double *)at = read_radius(r, item, name);
    break;
  case PH_AS_KNOTS:
    read_knots(r, item, name, at, k);
    break;
  case PH_AS_SIZE:
    if (slot->n) {
      read_fixed(r, slot, item, at);
    } else {
      *(size_t *)at = ph_read_whole(r, item, name, type->least, slot->most);
    }
    break;
  case PH_AS_AMONG:
    *(size_t *)at = *item->value == 'n'
                        ? PH_NO_SEGMENT
                        : ph_read_whole(r, item, name, type->least, type->most);
    break;
  case PH_AS_RANGE:
    read_range(r, item, name, at, slot->most);
    break;
  case PH_AS_SIGN:
    read_signs(r, item, name, at, slot->n);
    break;
  case PH_AS_FLAG:
    *(bool *)at = ph_read_flag(r, item, name, false);
    break;
  case PH_AS_TEXT:
    *(const char **)at = ph_read_string(r, item, name, "");
    break;
  case PH_AS_VECTOR:
    *(const char **)at = read_vector(r, item, name);
    break;
  default:
    word = (unsigned)(type->least +
                      ph_read_word(r, item, name, ph_words(type->name), 0));
    memcpy(at, &word, sizeof word);
  }
}
