/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The two shapes of record (see json_out.h). */
#include "io/json_out.h"

#include "base/relay.h"
#include "curve/kind/kind.h"

#include "io/json_write.h"
#include "io/members.h"

#include <math.h>
#include <string.h>

void ph_json_fields(struct ph_json_writer *w, const char *name,
                    const struct ph_swept *fields, size_t n) {
  if (n == 0) {
    return;
  }
  ph_write_key(w, name);
  ph_write_begin(w, '{');
  for (size_t i = 0; i < n; i++) {
    ph_write_key_raw(w, fields[i].name, fields[i].value,
                     strlen(fields[i].value));
  }
  ph_write_end(w, '}');
}

/* Whether a member of the heading is written. */
static bool has(const struct ph_heading *heading, const char *name) {
  const struct ph_chosen *chosen = heading->chosen;
  return ph_chosen_enter(&chosen, name);
}

void ph_json_heading(struct ph_json_writer *w, const struct ph_heading *heading,
                     const char *status) {
  const struct ph_echo *echo = heading->echo;
  ph_write_key_raw(w, "id", echo->id, echo->id_n);
  ph_write_key_string(w, "command", heading->command);
  ph_write_key_string(w, "status", status);
  if (heading->file && has(heading, "file")) {
    ph_write_key_string(w, "file", heading->file);
  }
  if (has(heading, "meta")) {
    ph_write_key_raw(w, "meta", echo->meta, echo->meta_n);
  }
  if (has(heading, "sweep")) {
    ph_json_fields(w, "sweep", heading->swept, heading->swept_n);
  }
  if (has(heading, "set")) {
    ph_json_fields(w, "set", heading->set, heading->set_n);
  }
}

/* ---- members by their rows ----------------------------------------------- */

/* A result on its way out. */
struct output {
  struct ph_json_writer *w;
  const struct ph_result *result;
  struct ph_sizes sizes;
  enum ph_of without;             /* members that a strip has not */
  const struct ph_chosen *chosen; /* members of the object that are written;
                                     NULL: all */
};

/* Begins a member, if it is chosen: then what was chosen of the object has to
 * be put back behind its value. */
static bool begin_member(struct output *out, const char *name) {
  if (!ph_chosen_enter(&out->chosen, name)) {
    return false;
  }
  ph_write_key(out->w, name);
  return true;
}

/* Where a member of object i is, NULL: nowhere; and how many there are. */
static const void *find(const struct ph_slot *slot, const char *object,
                        size_t i, size_t *n) {
  const struct ph_where *where = &slot->row->where;
  const char *at = object + where->at;
  *n = slot->form == PH_AS_LIST ? slot->n : 1;
  if (where->n) {
    memcpy(n, object + where->n - 1, sizeof *n);
  }
  if (slot->indirect) {
    const char *to;
    memcpy(&to, at, sizeof to);
    at = to;
  }
  return where->how == PH_EACH && at ? at + i * slot->stride : at;
}

/* Whether it is not known what is there. */
static bool is_unknown(const struct ph_slot *slot, const void *at) {
  const struct ph_type *type = slot->row->as;
  const char *text;
  unsigned word;
  switch (slot->form) {
  case PH_AS_DOUBLE:
    return slot->row->need == PH_MAY && !isfinite(*(const double *)at);
  case PH_AS_SIZE:
    return slot->row->need == PH_MAY && !slot->indirect &&
           *(const size_t *)at == PH_NO_SEGMENT;
  case PH_AS_TEXT:
  case PH_AS_VECTOR:
    memcpy(&text, at, sizeof text);
    return !text;
  case PH_AS_ENUM:
    memcpy(&word, at, sizeof word);
    return word < type->least || !ph_words(type->name)[word - type->least];
  default:
    return false;
  }
}

static void write_object(struct output *out, const struct ph_slot *slots,
                         size_t slots_n, const void *object, size_t i);

/* An object that is a struct. */
static void write_struct(struct output *out, const char *name,
                         const void *object) {
  struct ph_slot slots[PH_SLOTS_MAX];
  write_object(out, slots, ph_slots(ph_members_of(name), &out->sizes, slots),
               object, 0);
}

/* n objects: structs, or members of arrays. */
struct list {
  struct output *out;
  const struct ph_members *of;
  struct ph_slot slots[PH_SLOTS_MAX];
  size_t slots_n;
  const char *at;
};

/* Some of them: the relay of a list. */
static void write_some(void *context, struct ph_buf *to, size_t first,
                       size_t end) {
  const struct list *list = context;
  const struct ph_members *of = list->of;
  struct ph_json_writer w = *list->out->w;
  struct output out = *list->out;
  w.buf = to;
  w.comma[w.depth] = first > 0;
  out.w = &w;
  for (size_t i = first; i < end; i++) {
    const char *object = list->at + i * of->size;
    ph_write_element(&w);
    if (strcmp(of->name, "offset") == 0) {
      ph_sizes_enter(&out.sizes, PH_AS_PIECES, object);
    }
    if (strcmp(of->name, "strip") == 0) {
      const struct ph_strip *strip = (const struct ph_strip *)object;
      out.without =
          strip->method == PH_STRIP_CIRCULAR ? PH_OF_GENERAL : PH_OF_CIRCULAR;
    }
    write_object(&out, list->slots, list->slots_n, object, of->size ? 0 : i);
  }
}

static void write_list(struct output *out, const struct ph_slot *slot,
                       const char *at, size_t n) {
  struct list list = {.out = out, .of = ph_members_of(slot->row->as->name)};
  list.at = at;
  ph_sizes_enter(&out->sizes, slot->form, at);
  list.slots_n = ph_slots(list.of, &out->sizes, list.slots);
  ph_write_begin(out->w, '[');
  ph_relay(out->w->buf, n, write_some, &list);
  out->w->comma[out->w->depth] = n > 0;
  ph_write_end(out->w, ']');
}

/* The first image of segment k, or behind it. */
static size_t image_of(const struct ph_images *images, size_t k) {
  size_t first = 0, end = images->n;
  while (first < end) {
    const size_t middle = first + (end - first) / 2;
    if (images->v[middle].segment < k) {
      first = middle + 1;
    } else {
      end = middle;
    }
  }
  return first;
}

/* The pieces of the image of segment k. */
static void write_images(struct output *out, const struct ph_slot *slot,
                         const struct ph_images *images, size_t k) {
  const size_t first = image_of(images, k), end = image_of(images, k + 1);
  write_list(out, slot, (const char *)(images->v + first), end - first);
}

/* Of an array of any number, there are n. */
static void write_doubles(struct ph_json_writer *w, const struct ph_slot *slot,
                          const double *v, size_t n) {
  n = slot->numbers ? n : slot->n;
  if (slot->dimension) {
    ph_write_vectors(w, v, n, slot->dimension);
  } else if (slot->numbers || n) {
    ph_write_numbers(w, v, n);
  } else {
    ph_write_number(w, *v);
  }
}

static void write_signs(struct ph_json_writer *w, const signed char *signs,
                        size_t n) {
  for (size_t i = 0; i < n; i++) {
    ph_write_put(w, i > 0 ? ',' : '[');
    ph_write_number(w, signs[i]);
  }
  ph_write_put(w, ']');
}

static void write_sizes(struct ph_json_writer *w, const struct ph_slot *slot,
                        const size_t *sizes, size_t n) {
  if (slot->form == PH_AS_AMONG && *sizes == PH_NO_SEGMENT) {
    ph_buf_puts(w->buf, "null");
    return;
  }
  if (slot->n == 0 && (!slot->indirect || slot->row->where.how == PH_EACH)) {
    ph_write_number(w, (double)*sizes);
    return;
  }
  n = slot->n ? slot->n : n;
  ph_write_begin(w, '[');
  for (size_t i = 0; i < n; i++) {
    ph_write_element(w);
    ph_write_number(w, (double)sizes[i]);
  }
  ph_write_end(w, ']');
}

static void write_range(struct ph_json_writer *w, const size_t *ends) {
  const double numbers[] = {(double)ends[0], (double)ends[1]};
  ph_write_numbers(w, numbers, 2);
}

static void write_word(struct ph_json_writer *w, const struct ph_type *type,
                       const void *at) {
  unsigned word;
  memcpy(&word, at, sizeof word);
  ph_write_string(w, ph_words(type->name)[word - type->least]);
}

static void write_text(struct ph_json_writer *w, const void *at) {
  const char *text;
  memcpy(&text, at, sizeof text);
  ph_write_string(w, text);
}

/* ---- diagnostics and warnings -------------------------------------------- */

static void write_diagnostics(struct output *out,
                              const struct ph_diagnostics *diagnostics) {
  const struct ph_chosen *outer = out->chosen;
  struct ph_json_writer *w = out->w;
  for (uint64_t i = 0; diagnostics->known >> i; i++) {
    enum ph_diagnostic which = (enum ph_diagnostic)i;
    double value = diagnostics->value[i];
    const char *name, *type;
    if (!(diagnostics->known >> i & 1)) {
      continue;
    }
    name = ph_diagnostic_name(which);
    type = ph_diagnostic_type(which);
    out->chosen = outer;
    if (!begin_member(out, name)) {
      continue;
    }
    if (strcmp(type, "number") == 0) {
      ph_write_number(w, value);
    } else if (strcmp(type, "flag") == 0) {
      ph_write_flag(w, value > 0);
    } else {
      ph_write_string(w, ph_words(type)[(size_t)value]);
    }
  }
  out->chosen = outer;
}

/* The lengths of the curve with free lengths, if it is known everywhere. */
static void write_natural_lengths(struct output *out,
                                  const struct ph_result *result) {
  struct ph_json_writer *w = out->w;
  for (size_t i = 0; i < result->intervals_n; i++) {
    if (isnan(result->intervals[i].natural_length)) {
      return;
    }
  }
  if (!begin_member(out, "natural_lengths")) {
    return;
  }
  for (size_t i = 0; i < result->intervals_n; i++) {
    ph_write_put(w, i > 0 ? ',' : '[');
    ph_write_number(w, result->intervals[i].natural_length);
  }
  ph_write_put(w, ']');
}

/* The intervals of lambda of n pairs. */
static void write_bounds(struct ph_json_writer *w, const struct ph_pair *pairs,
                         size_t n) {
  ph_write_begin(w, '[');
  for (size_t i = 0; i < n; i++) {
    ph_write_element(w);
    ph_write_open(w, pairs[i].interval, 2);
  }
  ph_write_end(w, ']');
}

/* The certificate of the curve, and how it was found. */
static void write_certificate(struct output *out) {
  const struct ph_result *result = out->result;
  const struct ph_chosen *outer = out->chosen;
  struct ph_slot slots[PH_SLOTS_MAX];
  ph_write_begin(out->w, '{');
  write_diagnostics(out, &result->diagnostics);
  if (result->intervals_n) {
    write_natural_lengths(out, result);
  }
  out->chosen = outer;
  if (result->curve.surface.pairs_n && begin_member(out, "lambda_interval")) {
    write_bounds(out->w, result->curve.surface.pairs,
                 result->curve.surface.pairs_n);
  }
  out->chosen = outer;
  if (result->starts_n && begin_member(out, "start")) {
    ph_write_string(out->w, result->starts[result->start].name);
  }
  out->chosen = outer;
  if (result->starts_n && begin_member(out, "starts")) {
    ph_slots(ph_members_of("certificate"), &out->sizes, slots);
    write_list(out, slots, (const char *)result->starts, result->starts_n);
  }
  out->chosen = outer;
  if (result->has_kantorovich && begin_member(out, "kantorovich")) {
    write_struct(out, "kantorovich", &result->kantorovich);
  }
  out->chosen = outer;
  ph_write_end(out->w, '}');
}

static void write_warnings(struct ph_json_writer *w,
                           const struct ph_warning *warnings, size_t n) {
  ph_write_begin(w, '[');
  for (size_t i = 0; i < n; i++) {
    const struct ph_warning *warning = &warnings[i];
    ph_write_element(w);
    ph_write_begin(w, '{');
    ph_write_key_string(w, "code", ph_status_code(warning->diag.status));
    if (warning->segment != PH_NO_SEGMENT) {
      ph_write_key_number(w, "segment", (double)warning->segment);
    }
    ph_write_key_string(w, "message", warning->diag.message);
    ph_write_end(w, '}');
  }
  ph_write_end(w, ']');
}

/* ---- records ----------------------------------------------------------- */

static void write_value(struct output *out, const struct ph_slot *slot,
                        const void *object, size_t i, const void *at,
                        size_t n) {
  struct ph_json_writer *w = out->w;
  switch (slot->form) {
  case PH_AS_DOUBLE:
  case PH_AS_RADIUS:
    write_doubles(w, slot, at, n);
    break;
  case PH_AS_KNOTS:
    ph_write_numbers(w, at, 2);
    break;
  case PH_AS_OPEN:
    ph_write_open(w, at, slot->n);
    break;
  case PH_AS_SIZE:
  case PH_AS_AMONG:
    write_sizes(w, slot, at, n);
    break;
  case PH_AS_RANGE:
    write_range(w, at);
    break;
  case PH_AS_SIGN:
    write_signs(w, at, slot->n);
    break;
  case PH_AS_FLAG:
    ph_write_flag(w, *(const bool *)at);
    break;
  case PH_AS_TEXT:
  case PH_AS_VECTOR:
    write_text(w, at);
    break;
  case PH_AS_ENUM:
    write_word(w, slot->row->as, at);
    break;
  case PH_AS_IMAGES:
    write_images(out, slot, &((const struct ph_curve *)object)->blaschke, i);
    break;
  case PH_AS_CERTIFICATE:
    write_certificate(out);
    break;
  case PH_AS_DIAGNOSTIC_SET:
    ph_write_begin(w, '{');
    write_diagnostics(out, at);
    ph_write_end(w, '}');
    break;
  case PH_AS_WARNING_LIST:
    write_warnings(w, at, n);
    break;
  case PH_AS_OBJECT:
    write_struct(out, slot->row->as->name, at);
    break;
  default:
    write_list(out, slot, at, n);
  }
}

/* Whether a member is of other offsets than this one. */
static bool is_other(enum ph_of of, const void *object) {
  return (of == PH_OF_LOOPS || of == PH_OF_RAW) &&
         (of == PH_OF_LOOPS) !=
             (((const struct ph_offset *)object)->loops.mode != NULL);
}

/* The members of object i, or that this one has of arrays. */
static void write_members(struct output *out, const struct ph_slot *slots,
                          size_t slots_n, const void *object, size_t i) {
  const struct ph_chosen *outer = out->chosen;
  bool plain = !ph_kind_of(&out->result->curve)->on_sphere;
  for (const struct ph_slot *slot = slots; slot < slots + slots_n; slot++) {
    size_t n;
    const void *at = find(slot, object, i, &n);
    if ((n == 0 && strncmp(slot->row->type, "[]", 2) != 0) ||
        (!at && slot->row->where.how == PH_EACH) || is_unknown(slot, at) ||
        (plain && slot->row->of == PH_OF_SPHERE) ||
        (out->without && slot->row->of == out->without) ||
        is_other(slot->row->of, object) ||
        !begin_member(out, slot->row->name)) {
      continue;
    }
    write_value(out, slot, object, i, at, n);
    out->chosen = outer;
  }
}

static void write_object(struct output *out, const struct ph_slot *slots,
                         size_t slots_n, const void *object, size_t i) {
  ph_write_begin(out->w, '{');
  write_members(out, slots, slots_n, object, i);
  ph_write_end(out->w, '}');
}

static void finish(struct ph_json_writer *w) {
  ph_write_end(w, '}');
  ph_write_put(w, '\n');
}

void ph_json_result(struct ph_buf *buf, const struct ph_heading *heading,
                    const struct ph_result *result, bool pretty) {
  struct ph_json_writer w = {.buf = buf, .pretty = pretty};
  struct output out = {.w = &w, .result = result, .chosen = heading->chosen};
  struct ph_slot slots[PH_SLOTS_MAX];
  const char *object = ph_members_result(ph_kind_of(&result->curve)->parts);
  out.sizes.of['I' - 'A'] = result->intervals_n;
  ph_sizes_enter(&out.sizes, PH_AS_SEGMENTS, &result->curve);
  ph_write_begin(&w, '{');
  ph_json_heading(&w, heading, "ok");
  write_members(&out, slots, ph_slots(ph_members_of(object), &out.sizes, slots),
                result, 0);
  finish(&w);
}

void ph_json_failure(struct ph_json_writer *w, const struct ph_diag *diag,
                     const char *file, const size_t *byte) {
  char sentence[PH_DIAG_FIELD_MAX + PH_DIAG_MESSAGE_MAX];
  ph_diag_sentence(diag, sentence, sizeof sentence);
  ph_write_key(w, "error");
  ph_write_begin(w, '{');
  ph_write_key_string(w, "code", ph_status_code(diag->status));
  ph_write_key_string(w, "message", sentence);
  if (diag->field[0]) {
    ph_write_key_string(w, "field", diag->field);
  }
  if (file) {
    ph_write_key_string(w, "file", file);
  }
  if (byte) {
    ph_write_key_number(w, "byte", (double)*byte);
  } else if (diag->line) {
    ph_write_key_number(w, "line", (double)diag->line);
  }
  if (diag->column) {
    ph_write_key_number(w, "column", (double)diag->column);
  }
  ph_write_end(w, '}');
}

void ph_json_error(struct ph_buf *buf, const struct ph_heading *heading,
                   const struct ph_diag *diag, const char *file, bool pretty) {
  struct ph_json_writer w = {.buf = buf, .pretty = pretty};
  ph_write_begin(&w, '{');
  ph_json_heading(&w, heading, "error");
  ph_json_failure(&w, diag, file, heading->byte);
  finish(&w);
}
