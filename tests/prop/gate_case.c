/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Cases as values and as text (see gate.h). */
#include "gate.h"

#include "io/json_write.h"

const struct ph_schema *gate_schema(const struct gate_case *c) {
  return ph_commands[c->command].schema;
}

void gate_copy(struct gate_case *to, const struct gate_case *from) {
  *to = *from;
  for (size_t i = 0; i < PH_FIELD_N; i++) {
    to->problem.field[i].v = to->v[i];
    to->problem.field[i].word = to->word[i];
    to->problem.field[i].sizes = to->sizes;
  }
}

void gate_set_numbers(struct gate_case *c, enum ph_field_id id, const double *v,
                      size_t n, size_t dimension) {
  struct ph_value *value = &c->problem.field[id];
  size_t most = GATE_NUMBERS / dimension;
  *value = (struct ph_value){.kind = dimension > 1 ? PH_VECTORS : PH_NUMBERS,
                             .v = c->v[id],
                             .n = n < most ? n : most,
                             .dimension = dimension};
  memmove(value->v, v, value->n * dimension * sizeof *v);
}

void gate_set_lists(struct gate_case *c, enum ph_field_id id, const double *v,
                    const size_t *sizes, size_t sizes_n) {
  size_t n = 0;
  for (size_t i = 0; i < sizes_n; i++) {
    c->sizes[i] = sizes[i];
    n += sizes[i];
  }
  gate_set_numbers(c, id, v, n, 1);
  c->problem.field[id].kind = PH_LISTS;
  c->problem.field[id].sizes = c->sizes;
  c->problem.field[id].sizes_n = sizes_n;
}

struct gate_option *gate_add_option(struct gate_case *c, const char *text) {
  struct gate_option *o = &c->option[c->options_n++];
  *o = (struct gate_option){.text = text};
  return o;
}

void gate_add_number(struct gate_case *c, const char *text, double x) {
  struct gate_option *o = gate_add_option(c, text);
  o->v[o->n++] = x;
}

void gate_set_number(struct gate_case *c, enum ph_field_id id, double x) {
  c->problem.field[id] = (struct ph_value){.kind = PH_NUMBER, .number = x};
}

void gate_set_word(struct gate_case *c, enum ph_field_id id, const char *word,
                   double number) {
  snprintf(c->word[id], GATE_WORD, "%s", word);
  c->problem.field[id] =
      (struct ph_value){.kind = PH_WORD, .word = c->word[id], .number = number};
}

void gate_set_flag(struct gate_case *c, enum ph_field_id id, bool flag) {
  c->problem.field[id] = (struct ph_value){.kind = PH_BOOL, .flag = flag};
}

enum ph_field_id gate_data(const struct gate_case *c) {
  static const enum ph_field_id ids[] = {PH_F_POINTS, PH_F_LONLAT, PH_F_CURVE,
                                         PH_F_DERIVATIVES};
  for (size_t i = 0; i < COUNT(ids); i++) {
    if (gate_has(c, ids[i])) {
      return ids[i];
    }
  }
  return PH_F_TANGENTS;
}

static void put_lists(struct ph_buf *buf, const struct ph_value *value) {
  struct ph_json_writer w = {.buf = buf};
  const double *v = value->v;
  ph_buf_puts(buf, "[");
  for (size_t i = 0; i < value->sizes_n; v += value->sizes[i++]) {
    ph_buf_puts(buf, i > 0 ? "," : "");
    ph_write_numbers(&w, v, value->sizes[i]);
  }
  ph_buf_puts(buf, "]");
}

void gate_value(struct ph_buf *buf, const struct ph_value *value) {
  struct ph_json_writer w = {.buf = buf};
  const char *colon;
  switch (value->kind) {
  case PH_BOOL:
    ph_buf_puts(buf, value->flag ? "true" : "false");
    break;
  case PH_NUMBER:
    ph_write_number(&w, value->number);
    break;
  case PH_WORD: /* "plus:V" and its number */
    colon = strchr(value->word, ':');
    ph_buf_puts(buf, "\"");
    ph_buf_put(buf, value->word,
               colon ? (size_t)(colon + 1 - value->word) : strlen(value->word));
    if (colon) {
      ph_write_number(&w, value->number);
    }
    ph_buf_puts(buf, "\"");
    break;
  case PH_LISTS:
    put_lists(buf, value);
    break;
  case PH_NUMBERS:
    ph_write_numbers(&w, value->v, value->n);
    break;
  default:
    ph_write_vectors(&w, value->v, value->n, value->dimension);
  }
}

void gate_problem(struct ph_buf *buf, const struct gate_case *c) {
  const char *separator = "{";
  for (size_t i = 0; i < PH_FIELD_N; i++) {
    if (c->problem.field[i].kind != PH_ABSENT && !c->set[i]) {
      ph_buf_puts(buf, separator);
      ph_buf_puts(buf, "\"");
      ph_buf_puts(buf, ph_field_name((enum ph_field_id)i));
      ph_buf_puts(buf, "\":");
      gate_value(buf, &c->problem.field[i]);
      separator = ",";
    }
  }
  ph_buf_puts(buf, *separator == '{' ? "{}" : "}");
}

/* FIELD=VALUE */
static void assignment(struct ph_buf *buf, const struct gate_case *c,
                       size_t field) {
  ph_buf_puts(buf, "--set=");
  ph_buf_puts(buf, ph_field_name((enum ph_field_id)field));
  ph_buf_puts(buf, "=");
  gate_value(buf, &c->problem.field[field]);
}

static void put_option(struct ph_buf *buf, const struct gate_option *o) {
  struct ph_json_writer w = {.buf = buf};
  ph_buf_puts(buf, o->text);
  for (size_t i = 0; i < o->n; i++) {
    ph_buf_puts(buf, i > 0 ? "," : "");
    ph_write_number(&w, o->v[i]);
  }
}

static char *text_of(struct ph_buf *buf, struct ph_arena *arena) {
  char *text = ph_arena_copy(arena, buf->data, buf->n);
  ph_buf_clear(buf, 0);
  return text;
}

int gate_arguments(const struct gate_case *c, bool verify,
                   struct ph_arena *arena, char **argv) {
  struct ph_buf buf = {0};
  int n = 0;
  ph_buf_puts(&buf, verify ? "verify" : gate_schema(c)->command);
  argv[n++] = text_of(&buf, arena);
  if (verify) {
    ph_buf_puts(&buf, "--problems=p.json");
    argv[n++] = text_of(&buf, arena);
  }
  for (size_t i = 0; i < c->options_n && !verify; i++) {
    put_option(&buf, &c->option[i]);
    argv[n++] = text_of(&buf, arena);
  }
  for (size_t i = 0; i < PH_FIELD_N; i++) {
    if (c->set[i] && gate_has(c, (enum ph_field_id)i)) {
      assignment(&buf, c, i);
      argv[n++] = text_of(&buf, arena);
    }
  }
  ph_buf_free(&buf);
  argv[n] = NULL;
  return n;
}

void gate_command_line(struct ph_buf *buf, const struct gate_case *c) {
  char *argv[GATE_ARGUMENTS];
  struct ph_arena arena = {0};
  ph_buf_puts(buf, "echo '");
  gate_problem(buf, c);
  ph_buf_puts(buf, "' >p.json;");
  for (int verify = 0; verify < 2; verify++) {
    int n = gate_arguments(c, verify, &arena, argv);
    ph_buf_puts(buf, verify ? " p.json | phspline" : " phspline");
    for (int i = 0; i < n; i++) {
      const char *quote = strpbrk(argv[i], "\"[]*") ? "'" : "";
      ph_buf_puts(buf, " ");
      ph_buf_puts(buf, quote);
      ph_buf_puts(buf, argv[i]);
      ph_buf_puts(buf, quote);
    }
  }
  ph_arena_free(&arena);
}

void gate_word(struct unit_random *r, struct gate_case *c,
               enum ph_field_id id) {
  const char *name = ph_field_name(id);
  const struct ph_field *row =
      ph_field_find(gate_schema(c), name, strlen(name));
  const char *words = row->words;
  char text[GATE_WORD];
  size_t n = 1, which;
  for (const char *p = words; *p; p++) {
    n += *p == '|';
  }
  which = unit_random_below(r, n);
  while (which-- > 0) {
    words = strchr(words, '|') + 1;
  }
  n = strcspn(words, "|");
  memcpy(text, words, n);
  text[n] = '\0';
  gate_set_word(c, id, text, gate_decimals(unit_random_in(r, 1.1, 3), 2));
}
