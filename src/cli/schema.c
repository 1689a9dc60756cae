/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * JSON Schemas of problems and results (see schema.h).
 *
 * All is derived: problems from the fields of a command's schema; results from
 * the members of io/members.c, for each kind of curve that the command promises
 * (check/promise.c).  Every object is a definition of its own, which the others
 * refer to: COMMAND-KIND-OBJECT, COMMAND-OBJECT, or, where it is the same for
 * all, OBJECT.
 *
 * cJSON builds the tree, top down: an item is put into its place before it is
 * filled.  A failure is remembered, and later calls do nothing.
 */
#include "cli/schema.h"

#include "check/verify.h"
#include "cli/schema_form.h"

#include <cjson/cJSON.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* What is being built. */
struct builder {
  cJSON *definitions;
  bool failed; /* memory ran out */
};

/* ---- items --------------------------------------------------------------- */

/* Puts an item into an object, or without a name at the end of an array. */
static cJSON *add(struct builder *b, cJSON *to, const char *name, cJSON *item) {
  if (item && to &&
      (name ? cJSON_AddItemToObject(to, name, item)
            : cJSON_AddItemToArray(to, item))) {
    return item;
  }
  cJSON_Delete(item);
  b->failed = true;
  return NULL;
}

static cJSON *add_object(struct builder *b, cJSON *to, const char *name) {
  return add(b, to, name, cJSON_CreateObject());
}

static cJSON *add_array(struct builder *b, cJSON *to, const char *name) {
  return add(b, to, name, cJSON_CreateArray());
}

static void add_text(struct builder *b, cJSON *to, const char *name,
                     const char *text) {
  add(b, to, name, cJSON_CreateString(text));
}

static void add_number(struct builder *b, cJSON *to, const char *name,
                       double x) {
  add(b, to, name, cJSON_CreateNumber(x));
}

/* An object that has no other members than its properties.  ret these */
static cJSON *close_object(struct builder *b, cJSON *node) {
  cJSON *properties;
  add_text(b, node, "type", "object");
  properties = add_object(b, node, "properties");
  add(b, node, "additionalProperties", cJSON_CreateFalse());
  return properties;
}

/* The room for a name of a definition, and for one with what leads there. */
enum { KEY_MAX = 64, REFERENCE_MAX = 128 };

/* {"$ref": ...} to a definition, or to a property of it */
static void add_reference(struct builder *b, cJSON *to, const char *key,
                          const char *property) {
  char path[REFERENCE_MAX];
  snprintf(path, sizeof path, "#/$defs/%s%s%s", key,
           property ? "/properties/" : "", property ? property : "");
  add_text(b, to, "$ref", path);
}

/* A definition that may be there already.  ret it, or NULL: nothing to do */
static cJSON *define(struct builder *b, const char *key) {
  return b->failed || cJSON_GetObjectItemCaseSensitive(b->definitions, key)
             ? NULL
             : add_object(b, b->definitions, key);
}

/* ---- types --------------------------------------------------------------- */

/* The codes of errors, or those of warnings; under --strict these are errors,
 * too. */
static void fill_codes(struct builder *b, cJSON *node, bool warnings) {
  cJSON *list = add_array(b, node, "enum");
  for (int i = PH_OK + 1; i < PH_STATUS_N; i++) {
    enum ph_status status = (enum ph_status)i;
    enum ph_class class = ph_status_class(status);
    bool warning = ph_status_is_warning(status);
    if (warnings ? warning
                 : class == PH_CLASS_RECORD || class == PH_CLASS_INTERNAL) {
      add_text(b, list, NULL, ph_status_code(status));
    }
  }
}

/* A text or number that is this one. */
static bool fill_constant(struct builder *b, cJSON *node,
                          const struct ph_schema_form *f, const char *type) {
  const char *text = strcmp(type, "command") == 0  ? f->command->schema->command
                     : strcmp(type, "status") == 0 ? f->status
                     : strcmp(type, "curve") == 0  ? ph_curve_name(f->kind)
                                                   : NULL;
  size_t number =
      strcmp(type, "D") == 0        ? ph_schema_size(f, "D")
      : strcmp(type, "degree") == 0 ? ph_schema_size(f, "P") - 1
      : strcmp(type, "offset_degree") == 0 && !ph_schema_has_quotients(f)
          ? ph_schema_size(f, "O") - 1
          : 0;
  if (text) {
    add_text(b, node, "const", text);
  } else if (number > 0) {
    add_number(b, node, "const", (double)number);
  }
  return text || number > 0;
}

static bool fill_words(struct builder *b, cJSON *node, const char *type) {
#define NAME(symbol, name) name,
  static const char *const checks[] = {PH_CHECKS(NAME) NULL};
#undef NAME
  const char *const *words =
      strcmp(type, "check") == 0 ? checks : ph_words(type);
  bool method = strcmp(type, "method") == 0;
  cJSON *list;
  if (strcmp(type, "code") == 0 || strcmp(type, "warning_code") == 0) {
    fill_codes(b, node, *type == 'w');
    return true;
  }
  if (!method && !words) {
    return false;
  }
  list = add_array(b, node, "enum");
  for (size_t i = 0; method && i < ph_promises_n; i++) {
    add_text(b, list, NULL, ph_promises[i].command);
  }
  for (; words && *words; words++) {
    add_text(b, list, NULL, *words);
  }
  return true;
}

/* Types that are the same everywhere. */
static bool fill_scalar(struct builder *b, cJSON *node, const char *type) {
  static const char *const scalars[][2] = {
      {"number", "{\"type\":\"number\"}"},
      {"positive", "{\"type\":\"number\",\"exclusiveMinimum\":0}"},
      {"radius", "{\"type\":\"number\",\"exclusiveMinimum\":0}"},
      {"whole", "{\"type\":\"integer\",\"minimum\":0}"},
      {"index", "{\"type\":\"integer\",\"minimum\":0}"},
      {"continuity", "{\"enum\":[0,1,2]}"},
      {"bidegree", "{\"type\":\"integer\",\"minimum\":1,"
                   "\"maximum\":" PH_TEXT(PH_BIDEGREE_MAX) "}"},
      {"knots", "{\"type\":\"array\",\"items\":{\"type\":\"number\"},"
                "\"minItems\":2,\"maxItems\":2}"},
      {"range", "{\"type\":\"array\",\"items\":{\"type\":\"integer\","
                "\"minimum\":0},\"minItems\":2,\"maxItems\":2}"},
      {"open", "{\"type\":[\"number\",\"null\"]}"},
      {"bounds", "{\"type\":\"array\",\"items\":{\"type\":[\"number\","
                 "\"null\"]},\"minItems\":2,\"maxItems\":2}"},
      {"sign", "{\"enum\":[-1,0,1]}"},
      {"flag", "{\"type\":\"boolean\"}"},
      {"text", "{\"type\":\"string\"}"},
      {"id", "{\"type\":[\"string\",\"number\"]}"},
      {"offset_degree", "{\"type\":\"integer\",\"minimum\":1}"},
      {"any", "{}"},
      {"fields", "{\"type\":\"object\"}"},
      {"vector", "{\"enum\":[\"e2\",\"e3\"]}"},
      {"no_claims", "{\"const\":\"error\"}"}};
  for (size_t i = 0; i < sizeof scalars / sizeof scalars[0]; i++) {
    if (strcmp(type, scalars[i][0]) == 0) {
      cJSON *item = cJSON_Parse(scalars[i][1]);
      b->failed = b->failed || !item;
      while (item && item->child) {
        cJSON *member = cJSON_DetachItemViaPointer(item, item->child);
        add(b, node, member->string, member);
      }
      cJSON_Delete(item);
      return true;
    }
  }
  return false;
}

static void fill_object(struct builder *b, cJSON *node,
                        const struct ph_schema_form *f, const char *name);

/* What a value of a type (io/members.h) must be. */
static void fill(struct builder *b, cJSON *node, const struct ph_schema_form *f,
                 const char *type) {
  for (; *type == '['; type = strchr(type, ']') + 1) {
    size_t n = ph_schema_size(f, type + 1);
    cJSON *items;
    if (strcmp(strchr(type, ']') + 1, "open") == 0) { /* null: none is */
      items = add_array(b, node, "type");
      add_text(b, items, NULL, "array");
      add_text(b, items, NULL, "null");
    } else {
      add_text(b, node, "type", "array");
    }
    items = add_object(b, node, "items");
    if (type[1] != ']') {
      add_number(b, node, "minItems", n > 0 ? (double)n : 1);
    }
    if (n > 0) {
      add_number(b, node, "maxItems", (double)n);
    }
    node = items;
  }
  if (!(f && fill_constant(b, node, f, type)) && !fill_scalar(b, node, type) &&
      !fill_words(b, node, type)) {
    fill_object(b, node, f, type);
  }
}

/* ---- problems ------------------------------------------------------------ */

/* A number behind a word, as in "plus:0.5". */
#define NUMBER "[+-]?([0-9]+[.]?[0-9]*|[.][0-9]+)([eE][+-]?[0-9]+)?"

/* The words of a field; as a pattern where numbers belong to them. */
static void fill_choice(struct builder *b, cJSON *node, const char *words) {
  bool numbers = strstr(words, ":V") != NULL;
  cJSON *list = numbers ? NULL : add_array(b, node, "enum");
  struct ph_buf pattern = {0};
  ph_buf_puts(&pattern, "^(");
  while (*words) {
    size_t n = strcspn(words, "|");
    char word[KEY_MAX];
    bool number = n > 2 && memcmp(words + n - 2, ":V", 2) == 0;
    snprintf(word, sizeof word, "%.*s", (int)(number ? n - 1 : n), words);
    if (list) {
      add_text(b, list, NULL, word);
    }
    ph_buf_puts(&pattern, word);
    ph_buf_puts(&pattern, number ? NUMBER : "");
    ph_buf_puts(&pattern, words[n] ? "|" : ")$");
    words += n + (words[n] == '|');
  }
  ph_buf_put(&pattern, "", 1);
  if (numbers) {
    add_text(b, node, "type", "string");
    add_text(b, node, "pattern", pattern.failed ? "" : pattern.data);
  }
  b->failed = b->failed || pattern.failed;
  ph_buf_free(&pattern);
}

/* What a field may hold: one thing, or one of several. */
static void fill_field(struct builder *b, cJSON *node,
                       const struct ph_field *row) {
  static const struct {
    unsigned kind, dimensions;
    const char *type;
  } kinds[] = {{PH_BOOL, 0, "flag"},
               {PH_NUMBER, 0, "number"},
               {PH_NUMBERS, 0, "[]number"},
               {PH_VECTORS, 1u << 2, "[][2]number"},
               {PH_VECTORS, 1u << 3, "[][3]number"},
               {PH_POLYLINE, 1u << 2, "[][+][2]number"},
               {PH_POLYLINE, 1u << 3, "[][+][3]number"},
               {PH_LISTS, 0, "[][]number"},
               {PH_PATH, 0, "text"},
               {PH_WORD, 0, NULL}};
  const char *types[sizeof kinds / sizeof kinds[0]];
  size_t n = 0;
  cJSON *any;
  char text[1024];
  snprintf(text, sizeof text, "%s%s%s%s", row->help,
           row->required ? "" : " (default: ",
           row->required ? "" : row->standard, row->required ? "" : ")");
  add_text(b, node, "description", text);
  for (size_t i = 0; i < sizeof kinds / sizeof kinds[0]; i++) {
    if (row->kinds & kinds[i].kind &&
        (!kinds[i].dimensions || row->dimensions & kinds[i].dimensions)) {
      types[n++] = kinds[i].type;
    }
  }
  any = n > 1 ? add_array(b, node, "anyOf") : NULL;
  for (size_t i = 0; i < n; i++) {
    cJSON *to = n > 1 ? add_object(b, any, NULL) : node;
    if (types[i]) {
      fill(b, to, NULL, types[i]);
    } else {
      fill_choice(b, to, row->words);
    }
  }
}

static void define_problem(struct builder *b, const struct ph_schema *schema,
                           const char *key) {
  const struct ph_member *echoed = ph_members_of("failure")->rows;
  cJSON *node = define(b, key), *properties, *required;
  if (!node) {
    return;
  }
  properties = close_object(b, node);
  required = add_array(b, node, "required");
  for (size_t i = 0; i < 2; i++) { /* id and meta */
    fill(b, add_object(b, properties, echoed[i].name), NULL, echoed[i].type);
  }
  for (size_t i = 0; i < schema->fields_n; i++) {
    const struct ph_field *row = &schema->fields[i];
    fill_field(b, add_object(b, properties, ph_field_name(row->id)), row);
    if (row->required) {
      add_text(b, required, NULL, ph_field_name(row->id));
    }
  }
}

/* "set" or "sweep": what fields were set to, elements of arrays included. */
static void fill_fields(struct builder *b, cJSON *node,
                        const struct ph_schema *schema, bool elements) {
  cJSON *properties = close_object(b, node), *patterns = NULL;
  const unsigned numbers = PH_NUMBER | PH_NUMBERS | PH_VECTORS | PH_POLYLINE;
  char key[KEY_MAX], text[KEY_MAX];
  snprintf(key, sizeof key, "%s-problem", schema->command);
  add_number(b, node, "minProperties", 1);
  if (elements) {
    patterns = add_object(b, node, "patternProperties");
  }
  for (size_t i = 0; i < schema->fields_n; i++) {
    const char *name = ph_field_name(schema->fields[i].id);
    add_reference(b, add_object(b, properties, name), key, name);
    if (elements && schema->fields[i].kinds & numbers) {
      snprintf(text, sizeof text, "^%s((\\[[0-9]+\\])+[*]?|[*])$", name);
      fill(b, add_object(b, patterns, text), NULL, "number");
    }
  }
}

/* ---- results ------------------------------------------------------------- */

/* The members that a form has. */
static void fill_members(struct builder *b, cJSON *node,
                         const struct ph_schema_form *f,
                         const struct ph_member *rows) {
  cJSON *properties = close_object(b, node);
  cJSON *required = add_array(b, node, "required");
  for (size_t i = 0; rows[i].name; i++) {
    const struct ph_member *row = &rows[i];
    cJSON *member;
    if (!ph_schema_has(f, row)) {
      continue;
    }
    member = add_object(b, properties, row->name);
    if (row->what) {
      add_text(b, member, "description", row->what);
    }
    fill(b, member, f, row->type);
    if (!ph_schema_may_lack(f, row)) {
      add_text(b, required, NULL, row->name);
    }
  }
}

static const struct ph_members *members_of(const char *name) {
#define CHECK(symbol, name) \
  {name, PH_MAY, PH_OF_ANY, "number", NULL, {0}, NULL},
  static const struct ph_member rows[] = {PH_CHECKS(CHECK){0}};
#undef CHECK
  static const struct ph_members checks = {"checks", true, rows, 0};
  return strcmp(name, checks.name) == 0 ? &checks : ph_members_of(name);
}

/* An object by its name: a reference to its definition. */
static void fill_object(struct builder *b, cJSON *node,
                        const struct ph_schema_form *f, const char *name) {
  const struct ph_schema *schema = f->command->schema;
  bool fields = strcmp(name, "sweep") == 0 || strcmp(name, "set") == 0;
  const struct ph_members *object = fields ? NULL : members_of(name);
  bool kind;
  char key[KEY_MAX];
  cJSON *definition;
  if (fields && !schema->fields) { /* of verify: as they stand in its records */
    fill(b, node, f, "fields");
    return;
  }
  kind = !fields && f->promise;
  snprintf(key, sizeof key, "%s%s%s%s%s", schema->command, kind ? "-" : "",
           kind ? ph_curve_name(f->kind) : "", "-", name);
  if (!fields && object->shared) {
    snprintf(key, sizeof key, "%s", name);
  }
  add_reference(b, node, key, NULL);
  definition = define(b, key);
  if (definition && fields) {
    fill_fields(b, definition, schema, strcmp(name, "sweep") == 0);
  } else if (definition) {
    fill_members(b, definition, f, object->rows);
  }
}

/* ---- commands ------------------------------------------------------------ */

/* A record among those that a result may be. */
static void add_form(struct builder *b, cJSON *one, const char *name,
                     struct ph_schema_form form) {
  fill_object(b, add_object(b, one, NULL), &form, name);
}

static void define_command(struct builder *b, const struct ph_command *command);

/* The results of verify; its problems are the results of the others. */
static void define_verify(struct builder *b, const struct ph_command *command,
                          cJSON *results, const char *problem) {
  static const char *const right[] = {"verdict", "none"};
  static const char *const wrong[] = {"wrong", "wrong-none", "unknown"};
  cJSON *one = add_array(b, define(b, problem), "oneOf");
  char key[KEY_MAX];
  for (size_t i = 0; i < ph_commands_n; i++) {
    if (ph_commands[i].method) {
      define_command(b, &ph_commands[i]);
      snprintf(key, sizeof key, "%s-result", ph_commands[i].schema->command);
      add_reference(b, add_object(b, one, NULL), key, NULL);
    }
  }
  for (size_t i = 0; i < sizeof right / sizeof right[0]; i++) {
    add_form(b, results, right[i],
             (struct ph_schema_form){command, "ok", NULL, PH_CURVE_N});
  }
  for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
    add_form(b, results, wrong[i],
             (struct ph_schema_form){command, "error", NULL, PH_CURVE_N});
  }
}

/* COMMAND-problem and COMMAND-result. */
static void define_command(struct builder *b,
                           const struct ph_command *command) {
  const char *name = command->schema->command;
  const struct ph_promise *promise = ph_promise_of(name);
  char problem[KEY_MAX], result[KEY_MAX];
  cJSON *node, *one;
  snprintf(problem, sizeof problem, "%s-problem", name);
  snprintf(result, sizeof result, "%s-result", name);
  node = define(b, result);
  if (!node) {
    return;
  }
  one = add_array(b, node, "oneOf");
  if (promise) {
    define_problem(b, command->schema, problem);
  } else {
    define_verify(b, command, one, problem);
  }
  for (int kind = 0; promise && kind < PH_CURVE_N; kind++) {
    if (promise->kinds >> kind & 1) {
      add_form(b, one, ph_members_result(promise->parts),
               (struct ph_schema_form){command, "ok", promise,
                                       (enum ph_curve_kind)kind});
    }
  }
  add_form(b, one, "failure",
           (struct ph_schema_form){command, "error", NULL, PH_CURVE_N});
}

/* "problem" and "result": of any of the commands, which many problems are of,
 * but a result of one. */
static void define_both(struct builder *b, cJSON *root,
                        const struct ph_command *only) {
  static const char *const both[] = {"problem", "result"};
  cJSON *any = add_array(b, root, "anyOf");
  b->definitions = add_object(b, root, "$defs");
  for (size_t i = 0; i < 2; i++) {
    cJSON *list = add_array(b, define(b, both[i]), i ? "oneOf" : "anyOf");
    add_reference(b, add_object(b, any, NULL), both[i], NULL);
    for (size_t k = 0; k < ph_commands_n; k++) {
      char key[KEY_MAX];
      if (!only || only == &ph_commands[k]) {
        snprintf(key, sizeof key, "%s-%s", ph_commands[k].schema->command,
                 both[i]);
        add_reference(b, add_object(b, list, NULL), key, NULL);
      }
    }
  }
  for (size_t k = 0; k < ph_commands_n; k++) {
    if (!only || only == &ph_commands[k]) {
      define_command(b, &ph_commands[k]);
    }
  }
}

void ph_schema_text(struct ph_buf *buf, const struct ph_command *command) {
  cJSON *root = cJSON_CreateObject();
  struct builder b = {.failed = !root};
  char title[KEY_MAX];
  char *text;
  snprintf(title, sizeof title, "phspline%s%s", command ? " " : "",
           command ? command->schema->command : "");
  add_text(&b, root, "$schema", "https://json-schema.org/draft/2020-12/schema");
  add_text(&b, root, "title", title);
  add_text(&b, root, "description",
           command ? command->title : "problems and results of all commands");
  define_both(&b, root, command);
  text = b.failed ? NULL : cJSON_Print(root);
  if (text) {
    ph_buf_puts(buf, text);
    ph_buf_puts(buf, "\n");
  } else {
    buf->failed = true;
  }
  cJSON_free(text);
  cJSON_Delete(root);
}
