/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * json: reads what the program wrote, with a parser that shares nothing with
 * the program's own, and as strict as RFC 8259 allows: UTF-8, no name twice in
 * an object, no number beyond a double.
 *
 *   json lines [FILE]      every line is one value, and ends
 *   json compact [FILE]    each value on a line, without blanks
 *   json shape [FILE]      each value's skeleton: {id:number,points:[[number]]}
 *   json get PATH [FILE]   the text at a.b[2].c in each value, else "absent"
 *   json row PATH [FILE]   the same in one line, with a blank between two
 *
 * Values may follow one another with any blanks between them (`lines': with
 * line breaks).  Exit status 1 and a message when the text is anything else.
 */
#include <math.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { DEPTH_MAX = 100 };

/* A value; its members or elements follow `child' by `next'. */
struct node {
  char type; /* { [ " 0 t f n */
  const char *text, *end;
  const char *name, *name_end; /* of a member, without quotes */
  struct node *child, *next;
};

static const char *text_start, *text_end;

static void die(const char *at, const char *format, ...) {
  size_t line = 1;
  va_list args;
  for (const char *p = text_start; p < at; p++) {
    line += *p == '\n';
  }
  fprintf(stderr, "json: line %zu: ", line);
  va_start(args, format);
  vfprintf(stderr, format, args);
  va_end(args);
  fputc('\n', stderr);
  exit(1);
}

static void *allocate(void *old, size_t n) {
  void *memory = realloc(old, n);
  if (!memory) {
    fputs("json: out of memory\n", stderr);
    exit(1);
  }
  return memory;
}

static void free_nodes(struct node *node) {
  while (node) {
    struct node *next = node->next;
    free_nodes(node->child);
    free(node);
    node = next;
  }
}

/* ---- parsing ---------------------------------------------------------- */

static const char *blanks(const char *p) {
  while (p < text_end && strchr(" \t\r\n", *p) && *p) {
    p++;
  }
  return p;
}

static bool digit(const char *p) {
  return p < text_end && *p >= '0' && *p <= '9';
}

static const char *digits(const char *p) {
  if (!digit(p)) {
    die(p, "a digit is missing");
  }
  while (digit(p)) {
    p++;
  }
  return p;
}

static const char *number(const char *start) {
  const char *p = start + (*start == '-');
  p = p < text_end && *p == '0' ? p + 1 : digits(p);
  if (p < text_end && *p == '.') {
    p = digits(p + 1);
  }
  if (p < text_end && (*p == 'e' || *p == 'E')) {
    p++;
    p = digits(p + (p < text_end && (*p == '+' || *p == '-')));
  }
  if (!isfinite(strtod(start, NULL))) {
    die(start, "a number exceeds a double");
  }
  return p;
}

/* The first byte after the UTF-8 character at p (RFC 3629). */
static const char *character(const char *p) {
  const unsigned char *u = (const unsigned char *)p;
  size_t n = u[0] < 0x80 ? 1 : u[0] < 0xE0 ? 2 : u[0] < 0xF0 ? 3 : 4;
  unsigned long code = n == 1 ? u[0] : u[0] & (0x7Fu >> n);
  static const unsigned long least[] = {0, 0x20, 0x80, 0x800, 0x10000};
  if ((size_t)(text_end - p) < n) {
    die(p, "a character is cut off");
  }
  for (size_t i = 1; i < n; i++) {
    code = u[i] >> 6 == 2 ? code << 6 | (u[i] & 0x3Fu) : 0;
  }
  if (code < least[n] || (code >= 0xD800 && code < 0xE000) || code > 0x10FFFF) {
    die(p, "not UTF-8, or a control character");
  }
  return p + n;
}

/* The first byte after the string that begins at p. */
static const char *string(const char *p) {
  for (p++; p < text_end && *p != '"';) {
    if (*p != '\\') {
      p = character(p);
      continue;
    }
    if (!p[1] || !strchr("\"\\/bfnrtu", p[1])) {
      die(p, "a bad escape");
    }
    if (p[1] == 'u' && strspn(p + 2, "0123456789abcdefABCDEF") < 4) {
      die(p, "a bad \\u escape");
    }
    p += p[1] == 'u' ? 6 : 2;
  }
  if (p == text_end) {
    die(p, "the text ends inside a string");
  }
  return p + 1;
}

static struct node *value(const char *p, int depth);

/* Puts one more element or member at the end of a container. */
static const char *element(struct node *parent, struct node **last,
                           const char *p, int depth) {
  const char *name = NULL, *name_end = NULL;
  struct node *node;
  if (parent->type == '{') {
    if (p == text_end || *p != '"') {
      die(p, "a name is missing");
    }
    name = p + 1;
    p = string(p);
    name_end = p - 1;
    for (node = parent->child; node; node = node->next) {
      if (node->name_end - node->name == name_end - name &&
          memcmp(node->name, name, (size_t)(name_end - name)) == 0) {
        die(name, "the name %.*s is there twice", (int)(name_end - name), name);
      }
    }
    p = blanks(p);
    if (p == text_end || *p != ':') {
      die(p, "a colon is missing");
    }
    p = blanks(p + 1);
  }
  node = value(p, depth + 1);
  node->name = name;
  node->name_end = name_end;
  *(*last ? &(*last)->next : &parent->child) = node;
  *last = node;
  return blanks(node->end);
}

static const char *container(struct node *node, int depth) {
  char close = node->type == '{' ? '}' : ']';
  const char *p = blanks(node->text + 1);
  struct node *last = NULL;
  if (p < text_end && *p == close) {
    return p + 1;
  }
  for (;;) {
    p = element(node, &last, p, depth);
    if (p == text_end || (*p != ',' && *p != close)) {
      die(p, "a comma or %c is missing", close);
    }
    if (*p == close) {
      return p + 1;
    }
    p = blanks(p + 1);
  }
}

static const char *literal(const char *p) {
  static const char *const words[] = {"true", "false", "null"};
  for (size_t i = 0; i < sizeof words / sizeof *words; i++) {
    size_t n = strlen(words[i]);
    if ((size_t)(text_end - p) >= n && memcmp(p, words[i], n) == 0) {
      return p + n;
    }
  }
  die(p, "no value");
  return p;
}

static struct node *value(const char *p, int depth) {
  struct node *node = allocate(NULL, sizeof *node);
  memset(node, 0, sizeof *node);
  if (p == text_end || depth > DEPTH_MAX) {
    die(p, p == text_end ? "the text ends too early" : "nested too deeply");
  }
  node->text = p;
  node->type = *p;
  if (*p == '{' || *p == '[') {
    node->end = container(node, depth);
  } else if (*p == '"') {
    node->end = string(p);
  } else if (*p == '-' || digit(p)) {
    node->type = '0';
    node->end = number(p);
  } else {
    node->end = literal(p);
  }
  return node;
}

/* ---- printing --------------------------------------------------------- */

static void print_compact(const struct node *node) {
  if (node->type != '{' && node->type != '[') {
    fwrite(node->text, 1, (size_t)(node->end - node->text), stdout);
    return;
  }
  putchar(node->type);
  for (const struct node *c = node->child; c; c = c->next) {
    if (c->name) {
      printf("\"%.*s\":", (int)(c->name_end - c->name), c->name);
    }
    print_compact(c);
    if (c->next) {
      putchar(',');
    }
  }
  putchar(node->type == '{' ? '}' : ']');
}

/* A text that grows. */
struct text {
  char *data;
  size_t n;
};

static void append(struct text *text, const char *bytes, size_t n) {
  text->data = allocate(text->data, text->n + n + 1);
  memcpy(text->data + text->n, bytes, n);
  text->n += n;
  text->data[text->n] = '\0';
}

/* Kinds of elements are named once each, as they come. */
static void append_shape(struct text *text, const struct node *node) {
  static const char *const names[] = {"string", "number", "bool", "bool",
                                      "null"};
  const char *type = strchr("\"0tfn", node->type);
  struct text seen = {NULL, 0};
  if (type) {
    append(text, names[type - "\"0tfn"], strlen(names[type - "\"0tfn"]));
    return;
  }
  append(text, &node->type, 1);
  append(&seen, "|", 1);
  for (const struct node *c = node->child; c; c = c->next) {
    struct text shape = {NULL, 0};
    if (c->name) {
      append(&shape, c->name, (size_t)(c->name_end - c->name));
      append(&shape, ":", 1);
    }
    append_shape(&shape, c);
    append(&shape, "|", 1);
    if (node->type == '{' || !strstr(seen.data, shape.data)) {
      append(text, node->type == '{' ? "," : "|", seen.n > 1);
      append(text, shape.data, shape.n - 1);
      append(&seen, shape.data, shape.n);
    }
    free(shape.data);
  }
  append(text, node->type == '{' ? "}" : "]", 1);
  free(seen.data);
}

static void print_shape(const struct node *node) {
  struct text text = {NULL, 0};
  append_shape(&text, node);
  fputs(text.data, stdout);
  free(text.data);
}

static void print_at(const struct node *node, const char *path) {
  while (node && *path) {
    const struct node *child = node->child;
    if (*path == '[') {
      for (long i = strtol(path + 1, NULL, 10); child && i > 0; i--) {
        child = child->next;
      }
      child = node->type == '[' ? child : NULL;
      path = strchr(path, ']') + 1;
    } else {
      size_t n;
      path += *path == '.';
      n = strcspn(path, ".[");
      child = node->type == '{' ? child : NULL;
      while (child && ((size_t)(child->name_end - child->name) != n ||
                       memcmp(child->name, path, n) != 0)) {
        child = child->next;
      }
      path += n;
    }
    node = child;
  }
  if (node) {
    fwrite(node->text, 1, (size_t)(node->end - node->text), stdout);
  } else {
    fputs("absent", stdout);
  }
}

/* ---- the program ------------------------------------------------------ */

static char *read_all(FILE *file, size_t *n) {
  size_t room = 1 << 16;
  char *data = allocate(NULL, room);
  *n = 0;
  for (size_t got; (got = fread(data + *n, 1, room - *n - 1, file)) > 0;) {
    *n += got;
    if (*n == room - 1) {
      room *= 2;
      data = allocate(data, room);
    }
  }
  data[*n] = '\0'; /* strtod, strspn and escapes stop there */
  return data;
}

static void print(const struct node *node, char command, const char *path) {
  static bool more;
  if (command == 'r' && more) {
    putchar(' ');
  }
  more = true;
  if (command == 'c') {
    print_compact(node);
  } else if (command == 's') {
    print_shape(node);
  } else if (command == 'g' || command == 'r') {
    print_at(node, path);
  } else if (node->end == text_end || *node->end != '\n' ||
             memchr(node->text, '\n', (size_t)(node->end - node->text))) {
    die(node->text, "a value is not a line");
  }
  if (command != 'l' && command != 'r') {
    putchar('\n');
  }
}

int main(int argc, char **argv) {
  static const char *const commands[] = {"lines", "compact", "shape", "get",
                                         "row"};
  const char *path = "";
  char command = '\0';
  FILE *file;
  char *data;
  size_t n;
  for (size_t i = 0; argc > 1 && i < sizeof commands / sizeof *commands; i++) {
    command = strcmp(argv[1], commands[i]) == 0 ? *commands[i] : command;
  }
  if ((command == 'g' || command == 'r') && argc > 2) {
    path = argv[2];
    argc--;
    argv++;
  }
  file = argc > 2 ? fopen(argv[2], "r") : stdin;
  if (!command || argc > 3 || !file) {
    fputs("usage: json lines|compact|shape|get|row PATH [FILE]\n", stderr);
    return 2;
  }
  data = read_all(file, &n);
  text_start = data;
  text_end = data + n;
  for (const char *p = blanks(data); p < text_end;) {
    struct node *node = value(p, 0);
    print(node, command, path);
    p = blanks(node->end);
    free_nodes(node);
  }
  free(data);
  fclose(file);
  return 0;
}
