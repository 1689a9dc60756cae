/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Result record -> struct (see json_result.h), by the rows of members.h.
 *
 * cJSON is not for this: of 10^5 segments, 45 MB of text, its tree takes 280 MB
 * and as long to build as all of this takes (0.56 s), where the walks of
 * json_scan.h need nothing; and id, meta and messages have the text as it
 * stands.
 */
#include "io/json_result.h"

#include "io/json_form.h"
#include "io/json_in.h"
#include "io/json_read.h"
#include "io/members.h"
#include "io/value.h"

#include <math.h>
#include <string.h>

/* The most members that an object has. */
enum { MEMBERS_MAX = PH_DIAGNOSTIC_N + PH_SLOTS_MAX };

/* A result on its way in. */
struct input {
  struct ph_json_reader *r;
  struct ph_result *result;
  struct ph_sizes sizes;
  size_t images_room;
  unsigned without; /* as below, of the strip */
};

/* An object: its members, and where they belong. */
struct object {
  const struct ph_members *of;
  const struct ph_json_item *items; /* by row */
  void *at;         /* its struct, or that of the arrays of the list it is in */
  size_t i, n;      /* it is the i-th of n of these */
  unsigned without; /* bit of enum ph_of: members that it has not */
};

/* The item of the member of a name, which there must be. */
static const struct ph_json_item *item_of(const struct object *o,
                                          const char *name) {
  size_t i = 0;
  while (strcmp(o->of->rows[i].name, name) != 0) {
    i++;
  }
  return &o->items[i];
}

/* ---- members by their rows --------------------------------------------- */

static void read_slots(struct input *in, const struct object *o,
                       const struct ph_slot *slots, size_t slots_n);

/* Finds the members of an object, and reads them. */
static void read_object(struct input *in, const char *name,
                        const struct ph_json_item *from, void *at) {
  struct ph_json_item items[MEMBERS_MAX];
  struct ph_slot slots[PH_SLOTS_MAX];
  struct object o = {ph_members_of(name), items, at, 0, 1, in->without};
  ph_read_members(in->r, from, o.of->rows, items);
  read_slots(in, &o, slots, ph_slots(o.of, &in->sizes, slots));
}

/*
 * Where a member belongs; NULL: nowhere, also where memory is exhausted.  An
 * array is there from the first of its members on, or, if all curves may have
 * it, in any case.
 */
static void *place_of(struct input *in, const struct ph_slot *slot,
                      const struct object *o, bool known) {
  const struct ph_member *row = slot->row;
  char *at = (char *)o->at + row->where.at, *array;
  if (row->where.how == PH_AT) {
    return at;
  }
  memcpy(&array, at, sizeof array);
  known = known || (row->need == PH_MAY && row->of == PH_OF_ANY);
  if (!array && known) {
    array =
        ph_read_array_of(in->r, o->n + (slot->form == PH_AS_KNOTS), slot->size);
    memcpy(at, &array, sizeof array);
    for (size_t i = 0; array && i < o->i; i++) {
      ph_read_nothing(slot, array + i * slot->size);
    }
  }
  return array ? array + o->i * slot->size : NULL;
}

/* ---- segments ---------------------------------------------------------- */

/* How many coefficients the preimages have, by the first segment. */
static void measure_preimage(struct ph_json_reader *r, struct ph_curve *c,
                             const struct ph_json_item *item) {
  size_t mark = ph_read_enter(r, "preimage");
  c->preimage.n = ph_read_size(r, item);
  c->preimage.dimension = c->dimension == 2 ? 2 : 4;
  if (c->preimage.n < 1 || c->preimage.n > PH_CLAIM_DEGREE_MAX) {
    ph_read_fail(r, PH_E_BAD_SHAPE,
                 "must have from 1 to %d coefficients, found %zu",
                 PH_CLAIM_DEGREE_MAX, c->preimage.n);
  }
  ph_read_leave(r, mark);
}

/* Every segment has what the first one has; but angles, where there are any. */
static void compare_members(struct ph_json_reader *r, const struct object *o,
                            const struct ph_json_item *first) {
  for (size_t i = 0; o->of->rows[i].name; i++) {
    bool here = o->items[i].value != NULL, there = first[i].value != NULL;
    if (strcmp(o->of->rows[i].name, "angles") == 0 || here == there) {
      continue;
    }
    ph_read_enter(r, o->of->rows[i].name);
    ph_read_fail(r, here ? PH_E_BAD_SHAPE : PH_E_MISSING_FIELD,
                 here ? "is in this segment, but not in segments[0]"
                      : "is missing, but segments[0] has one");
    return;
  }
}

/* The pieces of the image of segment k; there need not be any. */
static void read_images(struct input *in, const struct ph_json_item *item,
                        const char *name, struct ph_images *images, size_t k) {
  struct ph_json_reader *r = in->r;
  size_t mark = ph_read_enter(r, name), n = ph_read_size(r, item);
  struct ph_json_walk walk;
  struct ph_json_item piece;
  if (!images->v) {
    images->v = ph_read_array_of(r, 1, sizeof *images->v);
    in->images_room = 1;
  }
  ph_json_walk_init(&walk, item->value, item->value_n);
  for (size_t i = 0; r->status == PH_OK && i < n; i++) {
    size_t inner = ph_read_enter_at(r, i);
    ph_json_walk_next(&walk, &piece);
    images->v = ph_arena_grow(r->arena, images->v, images->n, sizeof *images->v,
                              1, &in->images_room);
    if (images->v) {
      images->v[images->n].segment = k;
      read_object(in, "image", &piece, &images->v[images->n++]);
    } else {
      r->status = ph_fail_memory(r->diag);
    }
    ph_read_leave(r, inner);
  }
  ph_read_leave(r, mark);
}

/* ---- lists ------------------------------------------------------------- */

/* How many control points the first piece has, less one. */
static size_t degree_of(struct ph_json_reader *r, const struct object *first) {
  static const char name[] = "control_points";
  const struct ph_json_item *item = item_of(first, name);
  size_t n = 0, mark;
  if (ph_read_required(r, item, name)) {
    mark = ph_read_enter(r, name);
    n = ph_read_size(r, item);
    if (n < 2 || n > PH_CLAIM_DEGREE_MAX + 1) {
      ph_read_fail(r, PH_E_BAD_SHAPE,
                   "must have from 2 to %d vectors, found %zu",
                   PH_CLAIM_DEGREE_MAX + 1, n);
    }
    ph_read_leave(r, mark);
  }
  return r->status == PH_OK ? n - 1 : 0;
}

/* What the first object of a list says of all. */
static void begin_list(struct input *in, enum ph_form form,
                       struct object *first) {
  struct ph_json_reader *r = in->r;
  const struct ph_json_item *item;
  struct ph_pieces *pieces;
  switch (form) {
  case PH_AS_SEGMENTS:
    item = item_of(first, "preimage");
    ph_read_required(r, item_of(first, "control_points"), "control_points");
    if (item->value) {
      measure_preimage(r, first->at, item);
    }
    break;
  case PH_AS_PIECES:
    first->without = item_of(first, "numerator")->value ? 1u << PH_OF_RATIONAL
                                                        : 1u << PH_OF_QUOTIENT;
    break;
  case PH_AS_BEZIERS:
    pieces = first->at;
    pieces->degree = degree_of(r, first);
    pieces->dimension = in->sizes.of['D' - 'A'];
    break;
  case PH_AS_SAMPLES:
    ((struct ph_samples *)first->at)->dimension = in->sizes.of['D' - 'A'];
    break;
  default:
    return;
  }
  ph_sizes_enter(&in->sizes, form, first->at);
}

/* What an element of a list is before it is read. */
static void begin_element(struct input *in, struct object *o) {
  const struct ph_curve *c = &in->result->curve;
  memset(o->at, 0, o->of->size);
  if (strcmp(o->of->name, "offset") == 0) {
    ((struct ph_offset *)o->at)->dimension = c->dimension;
    o->without = (unsigned)!item_of(o, "segments")->value << PH_OF_FLAT |
                 1u << (item_of(o, "loops")->value ? PH_OF_RAW : PH_OF_LOOPS) |
                 (unsigned)!item_of(o, "beziers")->value << PH_OF_QUOTIENT;
  } else if (strcmp(o->of->name, "strip") == 0) {
    const bool general =
        item_of(o, "alpha")->value || item_of(o, "control_points")->value;
    in->without = o->without =
        1u << (general ? PH_OF_CIRCULAR : PH_OF_GENERAL) |
        (unsigned)!item_of(o, "control_points")->value << PH_OF_DIRECTRIX;
  } else if (strcmp(o->of->name, "solution") == 0) {
    ((struct ph_solution *)o->at)->curve =
        (struct ph_curve){.kind = c->kind,
                          .dimension = c->dimension,
                          .degree = c->degree,
                          .closed = c->closed};
  }
}

static void read_list(struct input *in, const struct ph_slot *slot,
                      const struct ph_json_item *from, char *at, size_t *n) {
  struct ph_json_reader *r = in->r;
  struct ph_json_item items[MEMBERS_MAX], first[MEMBERS_MAX], item;
  struct object o = {ph_members_of(slot->row->as->name), items, at, 0, 1, 0};
  struct ph_slot slots[PH_SLOTS_MAX];
  struct ph_json_walk walk;
  size_t mark = ph_read_enter(r, slot->row->name), slots_n = 0;
  *n = ph_read_size(r, from);
  if (strcmp(o.of->name, "loop") == 0) {
    ph_sizes_enter(&in->sizes, PH_AS_PIECES, at - slot->row->where.at);
  }
  if (*n == 0 && slot->form == PH_AS_SEGMENTS) {
    ph_read_fail(r, PH_E_BAD_SHAPE, "is empty");
  }
  if (slot->indirect) {
    o.at = *n ? ph_read_array_of(r, *n, o.of->size) : NULL;
    memcpy(at, &o.at, sizeof o.at);
  } else {
    o.n = *n;
  }
  ph_json_walk_init(&walk, from->value, from->value_n);
  for (size_t i = 0; r->status == PH_OK && i < *n; i++) {
    size_t inner = ph_read_enter_at(r, i);
    ph_json_walk_next(&walk, &item);
    ph_read_members(r, &item, o.of->rows, items);
    if (slot->indirect) {
      begin_element(in, &o);
    }
    if (i == 0 && r->status == PH_OK) {
      begin_list(in, slot->form, &o);
      memcpy(first, items, sizeof first);
      in->sizes.of['I' - 'A'] = in->result->intervals_n;
      slots_n = ph_slots(o.of, &in->sizes, slots);
    }
    if (slot->form == PH_AS_SEGMENTS && r->status == PH_OK) {
      compare_members(r, &o, first);
    }
    read_slots(in, &o, slots, slots_n);
    ph_read_leave(r, inner);
    o.at = (char *)o.at + o.of->size;
    o.i += !slot->indirect;
  }
  ph_read_leave(r, mark);
}

/* The intervals of a solution: as many as the record has. */
static void read_as_many(struct input *in, const struct ph_slot *slot,
                         const struct ph_json_item *from, void *at) {
  size_t n, mark;
  read_list(in, slot, from, at, &n);
  if (n != slot->n) {
    mark = ph_read_enter(in->r, slot->row->name);
    ph_read_fail(in->r, PH_E_BAD_SHAPE,
                 "must be %zu as of the best solution, found %zu", slot->n, n);
    ph_read_leave(in->r, mark);
  }
}

/* ---- diagnostics ------------------------------------------------------- */

/* The value of one of the numbers, flags and words. */
static double read_value(struct ph_json_reader *r,
                         const struct ph_json_item *item,
                         enum ph_diagnostic which) {
  const char *name = ph_diagnostic_name(which);
  const char *type = ph_diagnostic_type(which);
  const char *const *words = ph_words(type);
  if (words) {
    return (double)ph_read_word(r, item, name, words, 0);
  }
  return strcmp(type, "flag") == 0 ? ph_read_flag(r, item, name, false)
                                   : ph_read_number(r, item, name, 0);
}

/* Those of PH_DIAGNOSTICS; the items are in the order of these. */
static void read_diagnostics(struct ph_json_reader *r,
                             const struct ph_json_item *items,
                             struct ph_diagnostics *diagnostics) {
  for (size_t i = 0; r->status == PH_OK && i < PH_DIAGNOSTIC_N; i++) {
    enum ph_diagnostic which = (enum ph_diagnostic)i;
    if (items[i].value) {
      ph_diagnostics_set(diagnostics, which, read_value(r, &items[i], which));
    }
  }
}

/* The certificate of a record, or the diagnostics of a solution. */
static void read_certificate(struct input *in, const struct ph_slot *slot,
                             const struct ph_json_item *from,
                             struct ph_diagnostics *diagnostics) {
  struct ph_json_reader *r = in->r;
  struct ph_json_item items[MEMBERS_MAX];
  struct ph_slot slots[PH_SLOTS_MAX];
  struct object o = {
      ph_members_of(slot->row->as->name), items, in->result, 0, 1, 0};
  const struct ph_json_item *item;
  size_t mark = ph_read_enter(r, slot->row->name), inner;
  ph_read_members(r, from, o.of->rows, items);
  read_diagnostics(r, items, diagnostics);
  if (slot->form == PH_AS_CERTIFICATE && r->status == PH_OK) {
    const char *won = ph_read_string(r, item_of(&o, "start"), "start", "");
    item = item_of(&o, "kantorovich");
    if (item->value) {
      inner = ph_read_enter(r, "kantorovich");
      read_object(in, "kantorovich", item, &in->result->kantorovich);
      ph_read_leave(r, inner);
      in->result->has_kantorovich = true;
    }
    read_slots(in, &o, slots, ph_slots(o.of, &in->sizes, slots));
    for (size_t i = 0; r->status == PH_OK && i < in->result->starts_n; i++) {
      if (strcmp(in->result->starts[i].name, won) == 0) {
        in->result->start = i;
      }
    }
  }
  ph_read_leave(r, mark);
}

/* ---- the whole --------------------------------------------------------- */

/* The intervals of lambda: as many as there are pairs. */
static void read_bounds(struct input *in, const struct ph_json_item *from,
                        const char *name) {
  const struct ph_surface *surface = &in->result->curve.surface;
  struct ph_json_reader *r = in->r;
  struct ph_json_walk walk;
  struct ph_json_item item;
  size_t mark = ph_read_enter(r, name), n = ph_read_size(r, from);
  if (n != surface->pairs_n) {
    ph_read_fail(r, PH_E_BAD_SHAPE, "must be %zu, one for each pair, found %zu",
                 surface->pairs_n, n);
  }
  ph_json_walk_init(&walk, from->value, from->value_n);
  for (size_t i = 0; r->status == PH_OK && i < n; i++) {
    size_t inner = ph_read_enter_at(r, i);
    ph_json_walk_next(&walk, &item);
    ph_read_open(r, &item, NULL, surface->pairs[i].interval, 2);
    ph_read_leave(r, inner);
  }
  ph_read_leave(r, mark);
}

/* A member that consists of others. */
static void read_parts(struct input *in, const struct ph_slot *slot,
                       const struct ph_json_item *item,
                       const struct object *o) {
  const struct ph_where *where = &slot->row->where;
  void *at = (char *)o->at + where->at;
  void *n = where->n ? (char *)o->at + where->n - 1 : NULL;
  size_t mark;
  switch (slot->form) {
  case PH_AS_SIZE:
    ph_read_indices(in->r, slot, item, at, n);
    break;
  case PH_AS_DOUBLE:
    ph_read_list(in->r, slot, item, at, n);
    break;
  case PH_AS_IMAGES:
    read_images(in, item, slot->row->name,
                &((struct ph_curve *)o->at)->blaschke, o->i);
    break;
  case PH_AS_CERTIFICATE:
  case PH_AS_DIAGNOSTIC_SET:
    read_certificate(in, slot, item, at);
    break;
  case PH_AS_WARNING_LIST:
    break; /* it is no claim */
  case PH_AS_OBJECT:
    mark = ph_read_enter(in->r, slot->row->name);
    read_object(in, slot->row->as->name, item, at);
    ph_read_leave(in->r, mark);
    break;
  case PH_AS_BOUNDS:
    read_bounds(in, item, slot->row->name);
    break;
  default:
    if (n) {
      read_list(in, slot, item, at, n);
    } else {
      read_as_many(in, slot, item, at);
    }
  }
}

static void read_slots(struct input *in, const struct object *o,
                       const struct ph_slot *slots, size_t slots_n) {
  for (const struct ph_slot *slot = slots;
       in->r->status == PH_OK && slot < slots + slots_n; slot++) {
    const struct ph_member *row = slot->row;
    const struct ph_json_item *item = &o->items[row - o->of->rows];
    bool parts =
        slot->form >= PH_AS_LIST || slot->numbers ||
        (slot->form == PH_AS_SIZE && slot->indirect && row->where.how == PH_AT);
    void *at;
    if (o->without >> row->of & 1) {
      continue;
    }
    if (row->need == PH_MUST || (parts && slot->n > 0)) {
      ph_read_required(in->r, item, row->name);
    }
    if (parts && item->value) {
      read_parts(in, slot, item, o);
    }
    at = parts ? NULL : place_of(in, slot, o, item->value != NULL);
    if (at && item->value) {
      ph_read_form(in->r, slot, item, at, o->i);
    } else if (at) {
      ph_read_nothing(slot, at);
    }
  }
}

/* What a result is made of. */
static const char *parts_of(const struct object *o) {
  size_t parts = 0;
  while (strcmp(ph_members_result((enum ph_parts)parts), o->of->name) != 0) {
    parts++;
  }
  return ph_parts_name((enum ph_parts)parts);
}

static void read_result(struct input *in, struct object *o) {
  struct ph_slot slots[PH_SLOTS_MAX];
  size_t head = 0, n;
  const char *parts = parts_of(o);
  if (!item_of(o, parts)->value) {
    ph_read_enter(in->r, parts);
    ph_read_fail(in->r, PH_E_MISSING_FIELD, "is missing: this is no result");
  }
  if (!item_of(o, "status")->value) {
    ph_read_enter(in->r, "status");
    ph_read_fail(in->r, PH_E_MISSING_FIELD, "is missing");
  }
  if (strcmp(parts, "segments") != 0) {
    in->result->curve.dimension = 3;
    read_slots(in, o, slots, ph_slots(o->of, &in->sizes, slots));
    return;
  }
  o->without = (unsigned)!item_of(o, "radius")->value << PH_OF_SPHERE;
  n = ph_slots(o->of, &in->sizes, slots);
  while (slots[head++].form != PH_AS_SEGMENTS) { /* which say the sizes */
  }
  read_slots(in, o, slots, head);
  ph_slots(o->of, &in->sizes, slots);
  read_slots(in, o, slots + head, n - head);
}

/* "sweep" or "set": names and values as they stand there. */
static void read_fields(struct ph_json_reader *r,
                        const struct ph_json_item *from, const char *name,
                        struct ph_swept **fields, size_t *fields_n) {
  struct ph_json_walk walk;
  struct ph_json_item item;
  size_t n = 0, mark;
  if (r->status != PH_OK || !from->value) {
    return;
  }
  mark = ph_read_enter(r, name);
  if (*from->value != '{') {
    ph_read_fail(r, PH_E_BAD_TYPE, "must be an object");
    return;
  }
  ph_json_walk_init(&walk, from->value, from->value_n);
  while (ph_json_walk_next(&walk, &item)) {
    n++;
  }
  *fields = ph_read_array_of(r, n, sizeof **fields);
  ph_json_walk_init(&walk, from->value, from->value_n);
  while (r->status == PH_OK && ph_json_walk_next(&walk, &item)) {
    struct ph_swept *field = *fields + *fields_n;
    field->name = ph_arena_copy(r->arena, item.key, item.key_n);
    field->value = ph_json_one_line(&item, r->arena);
    if (!field->name || !field->value) {
      r->status = ph_fail_memory(r->diag);
      return;
    }
    *fields_n += 1;
  }
  ph_read_leave(r, mark);
}

/* What a record says of itself. */
static void read_heading(struct ph_json_reader *r, const struct object *o,
                         struct ph_claim *claim) {
  const char *status;
  claim->command = ph_read_string(r, item_of(o, "command"), "command", NULL);
  status = ph_read_string(r, item_of(o, "status"), "status", "ok");
  claim->solved = strcmp(status, "error") != 0;
  if (claim->solved && strcmp(status, "ok") != 0) {
    ph_read_enter(r, "status");
    ph_read_fail(r, PH_E_BAD_VALUE, "must be \"ok\" or \"error\"");
  }
  if (!claim->solved && item_of(o, parts_of(o))->value) {
    ph_read_enter(r, parts_of(o));
    ph_read_fail(r, PH_E_BAD_SHAPE, "are not of an error record");
  }
  read_fields(r, item_of(o, "sweep"), "sweep", &claim->swept, &claim->swept_n);
  read_fields(r, item_of(o, "set"), "set", &claim->set, &claim->set_n);
}

/* What a record consists of, by the first of its members that says so. */
static enum ph_parts parts_in(const struct ph_record *record) {
  struct ph_json_walk walk;
  struct ph_json_item item;
  bool surface = false;
  ph_json_walk_init(&walk, record->text, record->n);
  while (ph_json_walk_next(&walk, &item)) {
    surface |= item.key_n == 7 && memcmp(item.key, "surface", 7) == 0;
    for (size_t i = 0; i < PH_PARTS_N; i++) {
      const char *name = ph_parts_name((enum ph_parts)i);
      if (item.key_n == strlen(name) &&
          memcmp(item.key, name, item.key_n) == 0) {
        return (enum ph_parts)i;
      }
    }
  }
  return surface ? PH_STRIPS_PARTS : PH_SEGMENTS_PARTS;
}

enum ph_status ph_json_result_in(const struct ph_record *record,
                                 struct ph_arena *arena, struct ph_claim *claim,
                                 struct ph_diag *diag) {
  struct ph_json_reader r = {.arena = arena, .diag = diag};
  struct input in = {.r = &r, .result = &claim->result};
  struct ph_json_item items[MEMBERS_MAX];
  struct object o = {NULL, items, &claim->result, 0, 1, 0};
  const struct ph_json_item whole = {NULL, 0, record->text, record->n};
  struct ph_diag later;
  enum ph_status status;
  memset(claim, 0, sizeof *claim);
  if (*record->text != '{') {
    return ph_fail(diag, PH_E_BAD_TYPE, NULL,
                   "a result must be an object, found %s",
                   ph_value_type(*record->text));
  }
  o.of = ph_members_of(ph_members_result(parts_in(record)));
  ph_read_members(&r, &whole, o.of->rows, items);
  status = ph_json_echo(item_of(&o, "id"), item_of(&o, "meta"), arena,
                        &claim->echo, r.status == PH_OK ? diag : &later);
  r.status = r.status == PH_OK ? status : r.status;
  read_heading(&r, &o, claim);
  if (r.status == PH_OK && claim->solved) {
    read_result(&in, &o);
  }
  return r.status;
}
