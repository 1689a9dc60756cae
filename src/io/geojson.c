/* SPDX-License-Identifier: GPL-3.0-or-later */
/* GeoJSON (see geojson.h). */
#include "io/geojson.h"

#include "base/suggest.h"
#include "io/value.h"

#include <stdio.h>
#include <string.h>

/* The types of geometries with coordinates. */
static const struct type {
  const char *name;
  unsigned above; /* arrays between the coordinates and lines */
  bool ring, point;
} types[] = {
    {"LineString", 0, false, false}, {"MultiLineString", 1, false, false},
    {"Polygon", 1, true, false},     {"MultiPolygon", 2, true, false},
    {"MultiPoint", 0, false, false}, {"Point", 0, false, true},
};
enum { TYPES = sizeof types / sizeof *types };

static bool is(const char *text, size_t n, const char *name) {
  return strlen(name) == n && memcmp(text, name, n) == 0;
}

/* Whether a value is the string. */
static bool is_string(const struct ph_json_item *item, const char *string) {
  return item->value && *item->value == '"' &&
         is(item->value + 1, item->value_n - 2, string);
}

/* ---- objects ----------------------------------------------------------- */

enum { TYPE, GEOMETRY, COORDINATES, GEOMETRIES, ID, PROPERTIES, FEATURES, N };

static const char *const names[N] = {"type",       "geometry", "coordinates",
                                     "geometries", "id",       "properties",
                                     "features"};

/* The failure of what stands at `item`, in place of a line. */
static void fail(struct ph_geojson_line *line, const char *at) {
  line->at = at;
  line->n = 0;
}

/* The members of an object; false: it is none. */
static bool read_members(const struct ph_json_item *object, const char *field,
                         struct ph_json_item members[N],
                         struct ph_geojson_line *line) {
  struct ph_json_walk walk;
  struct ph_json_item item;
  memset(members, 0, N * sizeof *members);
  if (*object->value != '{') {
    ph_fail(&line->diag, PH_E_BAD_TYPE, field,
            field ? "must be an object, found %s"
                  : "GeoJSON must be an object, found %s",
            ph_value_type(*object->value));
    fail(line, object->value);
    return false;
  }
  ph_json_walk_init(&walk, object->value, object->value_n);
  while (ph_json_walk_next(&walk, &item)) {
    for (size_t i = 0; i < N; i++) {
      if (is(item.key, item.key_n, names[i])) {
        if (members[i].value) {
          ph_fail(&line->diag, PH_E_BAD_VALUE, names[i], "occurs twice");
          fail(line, item.value);
          return false;
        }
        members[i] = item;
      }
    }
  }
  return true;
}

/* Fails for the want of a member. */
static void miss(const struct ph_json_item *object, const char *field,
                 const char *of, struct ph_geojson_line *line) {
  ph_fail(&line->diag, PH_E_MISSING_FIELD, field, "is missing in this %s", of);
  fail(line, object->value);
}

static void push(struct ph_geojson *g, const struct ph_json_item *array,
                 struct ph_geojson_level level) {
  ph_json_walk_init(&level.walk, array->value, array->value_n);
  g->level[g->depth++] = level;
}

/* Whether a value is an array; it fails where it is not. */
static bool is_array(const struct ph_json_item *item, const char *field,
                     struct ph_geojson_line *line) {
  if (*item->value == '[') {
    return true;
  }
  ph_fail(&line->diag, PH_E_BAD_TYPE, field, "must be an array, found %s",
          ph_value_type(*item->value));
  fail(line, item->value);
  return false;
}

static void unknown_type(const struct ph_json_item *object,
                         const struct ph_json_item *type, bool geometry,
                         struct ph_geojson_line *line) {
  char excerpt[PH_EXCERPT_MAX], clause[PH_DID_YOU_MEAN_MAX];
  struct ph_suggest suggest;
  if (!type->value) {
    miss(object, "type", "object of GeoJSON", line);
    return;
  }
  if (*type->value != '"') {
    ph_fail(&line->diag, PH_E_BAD_TYPE, "type", "must be a string, found %s",
            ph_value_type(*type->value));
    fail(line, type->value);
    return;
  }
  ph_suggest_init(&suggest, type->value + 1, type->value_n - 2);
  for (size_t i = 0; i < TYPES; i++) {
    ph_suggest_try(&suggest, types[i].name, strlen(types[i].name));
  }
  ph_suggest_list(&suggest, geometry ? "GeometryCollection"
                                     : "GeometryCollection|Feature");
  ph_did_you_mean(&suggest, clause);
  ph_fail(&line->diag, PH_E_BAD_VALUE, "type", "is \"%s\", which is no %s%s",
          ph_excerpt(type->value + 1, type->value_n - 2, excerpt),
          geometry ? "geometry of GeoJSON" : "GeoJSON here", clause);
  fail(line, type->value);
}

/* A geometry with its members; `geometry`: it is not the whole text.
 * ret  whether next is found, or has failed; else there is one more level */
static bool open_members(struct ph_geojson *g,
                         const struct ph_json_item *object,
                         const struct ph_json_item members[N], bool geometry) {
  const struct ph_json_item *list = &members[GEOMETRIES];
  const struct ph_json_item *coordinates = &members[COORDINATES];
  const struct type *type = types;
  if (is_string(&members[TYPE], "GeometryCollection")) {
    if (!list->value) {
      miss(object, "geometries", "GeometryCollection", &g->next);
      return true;
    }
    if (is_array(list, "geometries", &g->next)) {
      push(g, list, (struct ph_geojson_level){.geometries = true});
      return false;
    }
    return true;
  }
  while (type < types + TYPES && !is_string(&members[TYPE], type->name)) {
    type++;
  }
  if (type == types + TYPES) {
    unknown_type(object, &members[TYPE], geometry, &g->next);
  } else if (type->point) {
    ph_fail(&g->next.diag, PH_E_BAD_VALUE, "type",
            "is Point, and no curve goes through one point; read are "
            "LineString, Polygon, these with Multi, and MultiPoint");
    fail(&g->next, members[TYPE].value);
  } else if (!coordinates->value) {
    miss(object, "coordinates", type->name, &g->next);
  } else if (is_array(coordinates, "coordinates", &g->next)) {
    if (type->above) {
      push(g, coordinates,
           (struct ph_geojson_level){.above = type->above - 1,
                                     .ring = type->ring});
      return false;
    }
    g->next.at = coordinates->value;
    g->next.n = coordinates->value_n;
    g->next.ring = false;
  }
  return true;
}

static bool open_geometry(struct ph_geojson *g,
                          const struct ph_json_item *object) {
  struct ph_json_item members[N];
  return !read_members(object, "geometry", members, &g->next) ||
         open_members(g, object, members, true);
}

/* Goes on to the next line; false: there is none. */
static bool advance(struct ph_geojson *g) {
  struct ph_json_item item;
  while (g->depth > 0) {
    struct ph_geojson_level *level = &g->level[g->depth - 1];
    if (!ph_json_walk_next(&level->walk, &item)) {
      g->depth--;
    } else if (level->geometries) {
      if (open_geometry(g, &item)) {
        return true;
      }
    } else if (!is_array(&item, "coordinates", &g->next)) {
      return true;
    } else if (level->above) {
      push(g, &item,
           (struct ph_geojson_level){.above = level->above - 1,
                                     .ring = level->ring});
    } else {
      g->next.at = item.value;
      g->next.n = item.value_n;
      g->next.ring = level->ring;
      return true;
    }
  }
  return false;
}

/* ret  as open_members */
static bool open_feature(struct ph_geojson *g,
                         const struct ph_json_item members[N]) {
  const struct ph_json_item whole = {NULL, 0, g->text, g->n};
  const struct ph_json_item *geometry = &members[GEOMETRY];
  g->id = members[ID];
  g->properties = members[PROPERTIES];
  if (!geometry->value) {
    miss(&whole, "geometry", "Feature", &g->next);
    return true;
  }
  if (*geometry->value == 'n') {
    ph_fail(&g->next.diag, PH_E_BAD_VALUE, "geometry",
            "is null: the feature has no line");
    fail(&g->next, geometry->value);
    return true;
  }
  return open_geometry(g, geometry);
}

void ph_geojson_begin(struct ph_geojson *g, const char *text, size_t n) {
  const struct ph_json_item whole = {NULL, 0, text, n};
  struct ph_json_item members[N];
  bool found;
  *g = (struct ph_geojson){.text = text, .n = n, .more = true};
  if (!read_members(&whole, NULL, members, &g->next)) {
    return;
  }
  if (is_string(&members[TYPE], "Feature")) {
    found = open_feature(g, members);
  } else if (is_string(&members[TYPE], "FeatureCollection") &&
             members[FEATURES].value) {
    /* in a collection; or its features are none */
    ph_fail(&g->next.diag, PH_E_BAD_TYPE, "features",
            *members[FEATURES].value == '['
                ? "must stand in one FeatureCollection, not in one of others"
                : "must be an array");
    fail(&g->next, members[FEATURES].value);
    found = true;
  } else if (is_string(&members[TYPE], "FeatureCollection")) {
    miss(&whole, "features", "FeatureCollection", &g->next);
    found = true;
  } else {
    found = open_members(g, &whole, members, false);
  }
  if (!found && !advance(g)) {
    ph_fail(&g->next.diag, PH_E_BAD_VALUE, NULL, "there is no line in this %s",
            g->id.value || g->properties.value ? "feature" : "geometry");
    fail(&g->next, text);
  }
}

/* ---- problems ---------------------------------------------------------- */

/* As many line breaks as there are in [p,end). */
static void breaks(struct ph_buf *buf, const char *p, const char *end) {
  while (p < end && (p = memchr(p, '\n', (size_t)(end - p)))) {
    ph_buf_puts(buf, "\n");
    p++;
  }
}

/* The coordinate `index` of a position; false: there is none. */
static bool coordinate(const struct ph_json_item *position, size_t index,
                       struct ph_json_item *found) {
  struct ph_json_walk walk;
  ph_json_walk_init(&walk, position->value, position->value_n);
  for (size_t i = 0; ph_json_walk_next(&walk, found); i++) {
    if (i == index) {
      return *position->value == '[';
    }
  }
  return false;
}

/* Whether a position of the line has an elevation. */
static bool has_elevation(const struct ph_geojson_line *line) {
  struct ph_json_walk walk;
  struct ph_json_item item, z;
  ph_json_walk_init(&walk, line->at, line->n);
  while (ph_json_walk_next(&walk, &item)) {
    if (coordinate(&item, 2, &z)) {
      return true;
    }
  }
  return false;
}

/* The positions without their elevations. */
static void put_plane(struct ph_buf *buf, const struct ph_geojson_line *line) {
  const char *cursor = line->at;
  struct ph_json_walk walk;
  struct ph_json_item item, x, y, z;
  const char *separator = "[";
  ph_json_walk_init(&walk, line->at, line->n);
  while (ph_json_walk_next(&walk, &item)) {
    ph_buf_puts(buf, separator);
    breaks(buf, cursor, item.value);
    cursor = item.value + item.value_n;
    separator = ",";
    if (!coordinate(&item, 2, &z)) {
      ph_buf_put(buf, item.value, item.value_n);
      continue;
    }
    coordinate(&item, 0, &x);
    coordinate(&item, 1, &y);
    ph_buf_puts(buf, "[");
    ph_buf_put(buf, x.value, x.value_n);
    ph_buf_puts(buf, ",");
    ph_buf_put(buf, y.value, y.value_n);
    ph_buf_puts(buf, "]");
    breaks(buf, item.value, cursor);
  }
  ph_buf_puts(buf, "]");
}

/* "elevation":[...], null where there is none */
static void put_elevation(struct ph_buf *buf,
                          const struct ph_geojson_line *line) {
  struct ph_json_walk walk;
  struct ph_json_item item, z;
  const char *separator = "\"elevation\":[";
  ph_json_walk_init(&walk, line->at, line->n);
  while (ph_json_walk_next(&walk, &item)) {
    ph_buf_puts(buf, separator);
    separator = ",";
    if (coordinate(&item, 2, &z)) {
      ph_buf_put(buf, z.value, z.value_n);
    } else {
      ph_buf_puts(buf, "null");
    }
  }
  ph_buf_puts(buf, "]");
}

/* What meta is: the properties, and elevations unless they have some. */
static void put_meta(struct ph_buf *buf, const struct ph_geojson *g,
                     bool elevation) {
  const struct ph_json_item *p = &g->properties;
  const bool object = p->value && *p->value == '{';
  const bool none = !p->value || *p->value == 'n';
  struct ph_json_walk walk;
  struct ph_json_item item;
  size_t members = 0;
  if (none && !elevation) {
    return;
  }
  if (object) {
    ph_json_walk_init(&walk, p->value, p->value_n);
  }
  while (object && ph_json_walk_next(&walk, &item)) {
    members++;
    elevation &= !is(item.key, item.key_n, "elevation");
  }
  ph_buf_puts(buf, ",\"meta\":");
  if (!elevation || !(object || none)) {
    ph_buf_put(buf, p->value, p->value_n);
    return;
  }
  ph_buf_put(buf, none ? "{" : p->value, none ? 1 : p->value_n - 1);
  ph_buf_puts(buf, members > 0 ? "," : "");
  put_elevation(buf, &g->next);
  ph_buf_puts(buf, "}");
}

/* The member id, of one of several lines with its number. */
static void put_id(struct ph_buf *buf, const struct ph_geojson *g,
                   bool several) {
  const struct ph_json_item *id = &g->id;
  const bool string = id->value && *id->value == '"';
  char number[32];
  if (!id->value) {
    return;
  }
  ph_buf_puts(buf, "\"id\":");
  if (!several || !strchr("\"-0123456789", *id->value)) {
    ph_buf_put(buf, id->value, id->value_n);
    return;
  }
  snprintf(number, sizeof number, "/%zu\"", g->line);
  ph_buf_puts(buf, string ? "" : "\"");
  ph_buf_put(buf, id->value, id->value_n - string);
  ph_buf_puts(buf, number);
}

/* The field of the schema that the positions are. */
static const struct ph_field *positions(const struct ph_schema *schema) {
  const struct ph_field *lonlat = ph_field_find(schema, "lonlat", 6);
  return lonlat ? lonlat : ph_field_find(schema, "points", 6);
}

enum ph_status ph_geojson_next(struct ph_geojson *g,
                               const struct ph_schema *schema,
                               struct ph_buf *problem, size_t *at,
                               struct ph_diag *diag) {
  const struct ph_field *field = positions(schema);
  const struct ph_geojson_line line = g->next;
  const bool plane = field && field->dimensions == 1u << 2;
  const bool elevation = line.n && plane && has_elevation(&line);
  struct ph_geojson here = *g;
  problem->n = 0;
  *at = (size_t)(line.at - g->text);
  g->more = advance(g);
  here.line = ++g->line;
  ph_buf_puts(problem, "{");
  put_id(problem, &here, g->more || g->line > 1);
  if (line.n) {
    ph_buf_puts(problem, problem->n > 1 ? ",\"" : "\"");
    ph_buf_puts(problem, field ? ph_field_name(field->id) : "points");
    ph_buf_puts(problem, "\":");
    if (elevation) {
      put_plane(problem, &line);
    } else {
      ph_buf_put(problem, line.at, line.n);
    }
    ph_buf_puts(problem, line.ring ? ",\"closed\":true" : "");
    put_meta(problem, &here, elevation);
  }
  ph_buf_puts(problem, "}");
  if (problem->failed) {
    return ph_fail_memory(diag);
  }
  if (!line.n) {
    *diag = line.diag;
    problem->n = g->id.value ? problem->n : 0;
    return diag->status;
  }
  return PH_OK;
}

/* ---- streams ----------------------------------------------------------- */

/* What the head of a collection may go on with. */
enum expect { BEGIN, NAME, COLON, VALUE, COMMA };

/* Goes over the value at the head.  ret  as ph_json_scan */
static enum ph_json_state pass(struct ph_geojson_head *head, const char *text,
                               size_t n, struct ph_json_item *item) {
  enum ph_json_state state =
      ph_json_scan(&head->scan, text + head->at, n - head->at, false);
  if (state == PH_JSON_DONE) {
    *item = (struct ph_json_item){NULL, 0, text + head->at, head->scan.at};
    head->at += head->scan.at;
    head->scan = (struct ph_json_scan){0};
  }
  return state;
}

/* One step.  ret  DONE: the features are there; MORE: go on; ERROR */
static enum ph_json_state step(struct ph_geojson_head *head, const char *text,
                               size_t n, bool *wait) {
  const char c = text[head->at];
  struct ph_json_item item = {0};
  enum ph_json_state state = PH_JSON_DONE;
  const enum expect expect = (enum expect)head->expect;
  if (expect == BEGIN || expect == COLON || expect == COMMA) {
    static const char due[] = {[BEGIN] = '{', [COLON] = ':', [COMMA] = ','};
    head->at++;
    head->expect = expect == COLON ? VALUE : NAME;
    return c == due[expect] ? PH_JSON_MORE : PH_JSON_ERROR;
  }
  if (expect == NAME && c != '"') {
    return PH_JSON_ERROR;
  }
  if (expect == VALUE && head->name == FEATURES) {
    head->at++;
    return c == '[' ? PH_JSON_DONE : PH_JSON_ERROR;
  }
  state = pass(head, text, n, &item);
  if (state != PH_JSON_DONE) {
    *wait = true;
    return state;
  }
  if (expect == NAME) {
    head->name = is_string(&item, "features") ? FEATURES
                 : is_string(&item, "type")   ? TYPE
                                              : N;
    head->expect = COLON;
    return PH_JSON_MORE;
  }
  head->expect = COMMA;
  return head->name == TYPE && !is_string(&item, "FeatureCollection")
             ? PH_JSON_ERROR
             : PH_JSON_MORE;
}

enum ph_json_state ph_geojson_features(struct ph_geojson_head *head,
                                       const char *text, size_t n) {
  enum ph_json_state state = PH_JSON_MORE;
  bool wait = false;
  while (state == PH_JSON_MORE && !wait) {
    if (head->scan.at == 0) {
      head->at = (size_t)(ph_json_blanks(text + head->at, text + n) - text);
    }
    if (head->at == n) {
      return PH_JSON_MORE;
    }
    state = step(head, text, n, &wait);
  }
  return state;
}

enum ph_json_state ph_geojson_is(const char *text, size_t n) {
  static const char *const own[] = {"features", "geometry", "geometries",
                                    "coordinates", "bbox"};
  static const char *const others[] = {"Feature", "FeatureCollection",
                                       "GeometryCollection"};
  const char *end = text + n, *p = ph_json_blanks(text, end);
  struct ph_geojson_head head = {.expect = BEGIN};
  struct ph_json_item name = {0}, value = {0};
  enum ph_json_state state;
  bool found = false;
  if (p < end && *p == '[') {
    p = ph_json_blanks(p + 1, end);
  }
  for (size_t i = 0; i < 2; i++) { /* the name, and its value */
    static const char before[2] = {'{', ':'};
    p = ph_json_blanks(p, end);
    if (p < end && *p != before[i]) {
      return PH_JSON_ERROR;
    }
    p = p < end ? ph_json_blanks(p + 1, end) : end;
    if (p == end) {
      return PH_JSON_MORE;
    }
    if (*p != '"') {
      return PH_JSON_ERROR;
    }
    head.at = (size_t)(p - text);
    state = pass(&head, text, n, i > 0 ? &value : &name);
    if (state != PH_JSON_DONE) {
      return state;
    }
    p = text + head.at;
    for (size_t k = 0; i == 0 && k < sizeof own / sizeof *own; k++) {
      found |= is_string(&name, own[k]);
    }
    if (found || (i == 0 && !is_string(&name, "type"))) {
      return found ? PH_JSON_DONE : PH_JSON_ERROR;
    }
  }
  for (size_t k = 0; k < TYPES; k++) {
    found |= is_string(&value, types[k].name);
  }
  for (size_t k = 0; k < sizeof others / sizeof *others; k++) {
    found |= is_string(&value, others[k]);
  }
  return found ? PH_JSON_DONE : PH_JSON_ERROR;
}
