/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Meshes of OBJ (see obj_in.h): one pass counts, the next one reads. */
#include "io/obj_in.h"

#include "base/suggest.h"
#include "io/number.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/* What a line is. */
enum word { POINT, NORMAL, FACE, IGNORED, OTHER, WORDS };

/* Numbers of a point: x, y, z, and a weight or a colour. */
enum { LEAST = 3, MOST = 7 };

#define NONE SIZE_MAX

/* A line, without its first word, that may go on after a backslash. */
struct line {
  const char *at, *end;
  const char *name; /* the word */
  size_t name_n;
  size_t number; /* of the line */
  enum word word;
};

/* A text that is gone through. */
struct text {
  const char *at, *end;
  size_t number; /* of the line at */
};

struct reader {
  struct text text;
  struct ph_arena *arena;
  struct ph_diag *diag;
  double *points, *normals; /* [.][3] */
  double *corners;          /* numbers of points, face after face */
  size_t *sizes;
  size_t n[WORDS]; /* points, normals and faces there are; */
  size_t seen[WORDS];
  size_t corners_n; /* so many so far */
  size_t *normal;   /* of each point, by number; NONE: no corner has named it */
  size_t *lines;    /* of each point, where a corner first named it */
  bool named;       /* corners have normals */
};

/* ---- lines --------------------------------------------------------------- */

static bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

/* Past blanks, and joined line ends. */
static const char *skip(const char *p, const char *end) {
  while (p < end) {
    const char *next = p + 1;
    if (*p == '\\') {
      next += next < end && *next == '\r';
      if (next == end || *next != '\n') {
        return p;
      }
      p = next + 1;
    } else if (is_blank(*p)) {
      p = next;
    } else {
      return p;
    }
  }
  return p;
}

static const char *word_end(const char *p, const char *end) {
  while (p < end && !is_blank(*p) && *p != '\n' &&
         !(*p == '\\' && skip(p, end) > p)) {
    p++;
  }
  return p;
}

static enum word word_of(const char *word, size_t n) {
  static const struct {
    const char *name;
    enum word word;
  } words[] = {{"v", POINT},        {"vn", NORMAL},      {"f", FACE},
               {"vt", IGNORED},     {"g", IGNORED},      {"o", IGNORED},
               {"s", IGNORED},      {"l", IGNORED},      {"p", IGNORED},
               {"usemtl", IGNORED}, {"mtllib", IGNORED}, {"mg", IGNORED}};
  for (size_t i = 0; i < sizeof words / sizeof words[0]; i++) {
    if (strlen(words[i].name) == n && memcmp(words[i].name, word, n) == 0) {
      return words[i].word;
    }
  }
  return n == 0 || *word == '#' ? IGNORED : OTHER;
}

/* The next line; false at the end. */
static bool next_line(struct text *text, struct line *line) {
  const char *p = text->at, *end = p;
  if (p >= text->end) {
    return false;
  }
  line->number = text->number;
  while (end < text->end) {
    const char *stop = memchr(end, '\n', (size_t)(text->end - end));
    const char *before;
    end = stop ? stop : text->end;
    before = end > p && end[-1] == '\r' ? end - 1 : end;
    if (!stop || before == p || before[-1] != '\\') {
      break;
    }
    text->number++;
    end++;
  }
  text->at = end < text->end ? end + 1 : end;
  text->number++;
  line->name = skip(p, end);
  line->at = word_end(line->name, end);
  line->name_n = (size_t)(line->at - line->name);
  line->end = end;
  line->word = word_of(line->name, line->name_n);
  return true;
}

/* ---- failures ------------------------------------------------------------ */

static enum ph_status fail(struct reader *r, const struct line *line,
                           enum ph_status status, const char *what,
                           const char *at, size_t n) {
  char excerpt[PH_EXCERPT_MAX];
  ph_fail(r->diag, status, NULL, "%s, found '%s'", what,
          ph_excerpt(at, n, excerpt));
  r->diag->line = line->number;
  return status;
}

/* ---- points and normals -------------------------------------------------- */

static enum ph_status read_vector(struct reader *r, struct line *line,
                                  double *to) {
  const bool point = line->word == POINT;
  double x[MOST];
  size_t n = 0;
  const char *p = skip(line->at, line->end);
  for (; p < line->end && *p != '#'; p = skip(p, line->end)) {
    const char *end = word_end(p, line->end);
    if (n == (point ? MOST : LEAST) ||
        ph_number_read_text(p, end, &x[n]) != end) {
      return fail(r, line, PH_E_SYNTAX,
                  point ? "v must have 3 numbers, and then at most 4 others"
                        : "vn must have 3 numbers",
                  p, (size_t)(end - p));
    }
    if (!isfinite(x[n])) {
      return fail(r, line, PH_E_NOT_FINITE, "must be a finite number", p,
                  (size_t)(end - p));
    }
    n++;
    p = end;
  }
  if (n < LEAST) {
    return fail(r, line, PH_E_BAD_SHAPE, "must have 3 numbers", line->name,
                (size_t)(p - line->name));
  }
  memcpy(to, x, LEAST * sizeof *x);
  return PH_OK;
}

/* ---- faces --------------------------------------------------------------- */

/* The index before a slash, or at the end; 0 where there is none. */
static const char *read_index(const char *p, const char *end, double *index) {
  const char *stop = memchr(p, '/', (size_t)(end - p));
  stop = stop ? stop : end;
  *index = 0;
  return stop == p || ph_number_read(p, stop, index) == stop ? stop : NULL;
}

/* A number from 0 of what is counted from 1, or backwards; NONE: there is
 * none such. */
static size_t number_of(double index, size_t all, size_t seen) {
  if (!(fabs(index) >= 1) || floor(index) < index) {
    return NONE;
  }
  if (index > 0) {
    return index <= (double)all ? (size_t)index - 1 : NONE;
  }
  return -index <= (double)seen ? seen - (size_t)-index : NONE;
}

static enum ph_status read_corner(struct reader *r, const struct line *line,
                                  const char *p, const char *end) {
  double index[3] = {0, 0, 0};
  const char *at = p;
  size_t point, normal = NONE;
  for (size_t i = 0; at && i < 3; i++) {
    at = read_index(at, end, &index[i]);
    if (!at || at == end) {
      break;
    }
    at++;
  }
  if (at != end || p == end) {
    return fail(r, line, PH_E_SYNTAX,
                "a corner must be numbers, as in 7, 7/2, 7//5 or 7/2/5", p,
                (size_t)(end - p));
  }
  point = number_of(index[0], r->n[POINT], r->seen[POINT]);
  if (fabs(index[2]) > 0) {
    normal = number_of(index[2], r->n[NORMAL], r->seen[NORMAL]);
  }
  if (point == NONE || (fabs(index[2]) > 0 && normal == NONE)) {
    return fail(r, line, PH_E_BAD_VALUE,
                point == NONE ? "a corner must be one of the points"
                              : "a corner must have one of the normals",
                p, (size_t)(end - p));
  }
  r->corners[r->corners_n++] = (double)point;
  if (r->lines[point] != 0 && normal != r->normal[point] &&
      (normal == NONE || r->normal[point] == NONE ||
       memcmp(r->normals + 3 * normal, r->normals + 3 * r->normal[point],
              3 * sizeof(double)) != 0)) {
    ph_fail_at(r->diag, PH_E_BAD_VALUE, "points", point,
               "has another normal here than in line %zu; leave out the "
               "normals of corners, or give each point one",
               r->lines[point]);
    r->diag->line = line->number;
    return PH_E_BAD_VALUE;
  }
  r->lines[point] = r->lines[point] ? r->lines[point] : line->number;
  r->normal[point] = normal;
  r->named = r->named || normal != NONE;
  return PH_OK;
}

static enum ph_status read_face(struct reader *r, struct line *line) {
  const size_t before = r->corners_n;
  const char *p = skip(line->at, line->end);
  while (p < line->end && *p != '#') {
    const char *end = word_end(p, line->end);
    enum ph_status status = read_corner(r, line, p, end);
    if (status != PH_OK) {
      return status;
    }
    p = skip(end, line->end);
  }
  r->sizes[r->seen[FACE]] = r->corners_n - before;
  return PH_OK;
}

/* ---- the whole ----------------------------------------------------------- */

/* How many there are of each. */
static enum ph_status count(struct reader *r) {
  struct text text = r->text;
  struct line line;
  size_t corners = 0;
  while (next_line(&text, &line)) {
    if (line.word == OTHER) {
      return fail(r, &line, PH_E_SYNTAX,
                  "must be a line of OBJ that begins with v, vn, f or what is "
                  "ignored",
                  line.name, line.name_n);
    }
    r->n[line.word]++;
    corners += line.word == FACE ? (size_t)(line.end - line.at) / 2 + 1 : 0;
  }
  r->points = ph_arena_array(r->arena, r->n[POINT], 3 * sizeof(double));
  r->normals = ph_arena_array(r->arena, r->n[NORMAL], 3 * sizeof(double));
  r->corners = ph_arena_array(r->arena, corners, sizeof *r->corners);
  r->sizes = ph_arena_array(r->arena, r->n[FACE], sizeof *r->sizes);
  r->normal = ph_arena_array(r->arena, r->n[POINT], sizeof *r->normal);
  r->lines = ph_arena_array(r->arena, r->n[POINT], sizeof *r->lines);
  if (!r->points || !r->normals || !r->corners || !r->sizes || !r->normal ||
      !r->lines) {
    return ph_fail_memory(r->diag);
  }
  memset(r->lines, 0, r->n[POINT] * sizeof *r->lines);
  for (size_t i = 0; i < r->n[POINT]; i++) {
    r->normal[i] = NONE;
  }
  return PH_OK;
}

/* Lines of some words, in order: normals come before the faces that name
 * them. */
static enum ph_status read_lines(struct reader *r, bool faces) {
  struct text text = r->text;
  struct line line;
  enum ph_status status = PH_OK;
  memset(r->seen, 0, sizeof r->seen);
  while (status == PH_OK && next_line(&text, &line)) {
    const size_t i = r->seen[line.word];
    if (line.word == FACE && faces) {
      status = read_face(r, &line);
    } else if (line.word == POINT && !faces) {
      status = read_vector(r, &line, r->points + 3 * i);
    } else if (line.word == NORMAL && !faces) {
      status = read_vector(r, &line, r->normals + 3 * i);
    }
    r->seen[line.word]++;
  }
  return status;
}

static struct ph_value vectors(double *v, size_t n) {
  return (struct ph_value){.kind = PH_VECTORS, .v = v, .n = n, .dimension = 3};
}

static enum ph_status put(struct reader *r, struct ph_problem *problem) {
  double *normals = NULL;
  if (r->n[POINT]) {
    problem->field[PH_F_POINTS] = vectors(r->points, r->n[POINT]);
  }
  if (r->n[FACE]) {
    problem->field[PH_F_FACES] = (struct ph_value){.kind = PH_LISTS,
                                                   .v = r->corners,
                                                   .n = r->corners_n,
                                                   .dimension = 1,
                                                   .sizes = r->sizes,
                                                   .sizes_n = r->n[FACE]};
  }
  if (!r->named) {
    return PH_OK;
  }
  normals = ph_arena_array(r->arena, r->n[POINT], 3 * sizeof *normals);
  if (!normals) {
    return ph_fail_memory(r->diag);
  }
  for (size_t i = 0; i < r->n[POINT]; i++) {
    if (r->normal[i] == NONE) {
      return ph_fail_at(r->diag, PH_E_BAD_VALUE, "points", i,
                        r->lines[i] ? "has no normal, but others have"
                                    : "belongs to no face");
    }
    memcpy(normals + 3 * i, r->normals + 3 * r->normal[i], 3 * sizeof *normals);
  }
  problem->field[PH_F_NORMALS] = vectors(normals, r->n[POINT]);
  return PH_OK;
}

enum ph_status ph_obj_in(const struct ph_record *record,
                         const struct ph_schema *schema, struct ph_arena *arena,
                         struct ph_problem *problem, struct ph_diag *diag) {
  struct reader r = {
      .text = {record->text, record->text + record->n, record->line},
      .arena = arena,
      .diag = diag};
  enum ph_status status;
  memset(problem, 0, sizeof *problem);
  if (!ph_field_find(schema, "faces", strlen("faces"))) {
    return ph_fail(diag, PH_E_BAD_VALUE, NULL,
                   "is a mesh, which %s does not read", schema->command);
  }
  status = count(&r);
  if (status == PH_OK) {
    status = read_lines(&r, false);
  }
  if (status == PH_OK) {
    status = read_lines(&r, true);
  }
  return status == PH_OK ? put(&r, problem) : status;
}

size_t ph_obj_line(const struct ph_record *record, const char *path) {
  struct text text = {record->text, record->text + record->n, record->line};
  const enum word word = strncmp(path, "points[", 7) == 0    ? POINT
                         : strncmp(path, "normals[", 8) == 0 ? NORMAL
                         : strncmp(path, "faces[", 6) == 0   ? FACE
                                                             : OTHER;
  const char *index = strchr(path, '[');
  unsigned long i = index ? strtoul(index + 1, NULL, 10) : 0;
  struct line line;
  while (word != OTHER && next_line(&text, &line)) {
    if (line.word == word && i-- == 0) {
      return line.number;
    }
  }
  return record->line;
}
