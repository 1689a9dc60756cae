/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The reader of test vectors (see vectors_unit.h). */
#include "vectors_unit.h"
#include "unit.h"

static const char BLANKS[] = " \t\r\n";

static void number_add(struct unit_numbers *numbers, double x) {
  if (numbers->n == numbers->capacity) {
    numbers->capacity = numbers->capacity ? 2 * numbers->capacity : 64;
    numbers->v = realloc(numbers->v, numbers->capacity * sizeof *numbers->v);
    ck_assert_ptr_nonnull(numbers->v);
  }
  numbers->v[numbers->n++] = x;
}

struct unit_vectors unit_vectors_open(const char *path) {
  const char *srcdir = getenv("srcdir");
  struct unit_vectors vectors = {NULL, NULL, path};
  char name[4096];
  size_t n;
  FILE *file;
  snprintf(name, sizeof name, "%s/%s", srcdir ? srcdir : ".", path);
  file = fopen(name, "rb");
  ck_assert_msg(file != NULL, "%s cannot be read", name);
  ck_assert_int_eq(fseek(file, 0, SEEK_END), 0);
  n = (size_t)ftell(file);
  rewind(file);
  vectors.text = malloc(n + 1);
  ck_assert_ptr_nonnull(vectors.text);
  ck_assert_uint_eq(fread(vectors.text, 1, n, file), n);
  ck_assert_int_eq(fclose(file), 0);
  vectors.text[n] = '\0';
  /* Comments become blanks. */
  for (char *p = strchr(vectors.text, '#'); p; p = strchr(p, '#')) {
    memset(p, ' ', strcspn(p, "\n"));
  }
  vectors.at = vectors.text;
  return vectors;
}

char *unit_vectors_word(struct unit_vectors *vectors) {
  char *word = vectors->at + strspn(vectors->at, BLANKS);
  char *end = word + strcspn(word, BLANKS);
  vectors->at = *end ? end + 1 : end;
  *end = '\0';
  return *word ? word : NULL;
}

void unit_vectors_numbers(struct unit_vectors *vectors,
                          struct unit_numbers *numbers) {
  for (;;) {
    char *end, *word = vectors->at + strspn(vectors->at, BLANKS);
    double x = strtod(word, &end);
    if (end == word || !strchr(BLANKS, *end)) {
      return;
    }
    number_add(numbers, x);
    vectors->at = end;
  }
}

static void read_name(struct unit_vectors *vectors, char *name, size_t size) {
  const char *word = unit_vectors_word(vectors);
  ck_assert(word && strlen(word) < size);
  memcpy(name, word, strlen(word) + 1);
}

static void clear(struct unit_vector *v) {
  struct unit_numbers *const list[] = {&v->points,  &v->knots,   &v->ends,
                                       &v->control, &v->lengths, &v->length};
  for (size_t i = 0; i < COUNT(list); i++) {
    list[i]->n = 0;
  }
  v->name[0] = v->rule[0] = '\0';
  v->closed = false;
  v->tolerance = 0;
}

/* A whole problem has as many of everything as it has segments. */
static void ck_whole(const struct unit_vectors *vectors,
                     const struct unit_vector *v) {
  size_t segments = v->points.n / 2 - (v->closed ? 0 : 1);
  bool whole = v->points.n >= 4 && v->points.n % 2 == 0 &&
               (v->knots.n == 0 || v->knots.n == segments + 1) &&
               (v->ends.n == 0 || v->ends.n == 4) &&
               v->control.n == 12 * segments && v->lengths.n == segments &&
               v->length.n == 1 && v->tolerance > 0;
  ck_assert_msg(whole, "%s: problem %s is not whole", vectors->path, v->name);
}

bool unit_vectors_next(struct unit_vectors *vectors, struct unit_vector *v) {
  struct {
    const char *name;
    struct unit_numbers *numbers;
  } const fields[] = {{"points", &v->points},   {"knots", &v->knots},
                      {"ends", &v->ends},       {"control", &v->control},
                      {"lengths", &v->lengths}, {"length", &v->length}};
  const size_t fields_n = COUNT(fields);
  const char *word = unit_vectors_word(vectors);
  if (!word) {
    return false;
  }
  ck_assert_msg(strcmp(word, "problem") == 0, "%s: '%s' is no problem",
                vectors->path, word);
  clear(v);
  read_name(vectors, v->name, sizeof v->name);
  while (v->length.n == 0) {
    size_t i = 0;
    word = unit_vectors_word(vectors);
    ck_assert_msg(word != NULL, "%s: %s is cut off", vectors->path, v->name);
    while (i < fields_n && strcmp(word, fields[i].name) != 0) {
      i++;
    }
    if (i < fields_n) {
      unit_vectors_numbers(vectors, fields[i].numbers);
    } else if (strcmp(word, "closed") == 0) {
      v->closed = true;
    } else if (strcmp(word, "rule") == 0) {
      read_name(vectors, v->rule, sizeof v->rule);
    } else {
      ck_assert_msg(strcmp(word, "tolerance") == 0, "%s: %s: what is '%s'?",
                    vectors->path, v->name, word);
      word = unit_vectors_word(vectors);
      v->tolerance = word ? strtod(word, NULL) : 0;
    }
  }
  ck_whole(vectors, v);
  return true;
}

void unit_vectors_close(struct unit_vectors *vectors, struct unit_vector *v) {
  free(vectors->text);
  free(v->points.v);
  free(v->knots.v);
  free(v->ends.v);
  free(v->control.v);
  free(v->lengths.v);
  free(v->length.v);
  *vectors = (struct unit_vectors){0};
  *v = (struct unit_vector){0};
}

struct unit_solution unit_vector_problem(const struct unit_vector *v) {
  struct unit_solution u =
      unit_planar_of(v->points.v, v->points.n / 2, v->closed);
  if (v->rule[0]) {
    unit_planar_rule(&u, v->rule);
  }
  if (v->knots.n) {
    unit_planar_knots(&u, v->knots.v, v->knots.n);
  }
  if (v->ends.n) {
    unit_planar_ends(&u, v->ends.v);
  }
  return u;
}
