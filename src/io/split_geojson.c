/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The splitter's way through GeoJSON (see split.h): texts as split_json.c finds
 * them, of a FeatureCollection its features, one at a time; of each text its
 * lines are the records (io/geojson.h).
 *
 * In a sequence of texts (RFC 8142: before each the byte 0x1E) a text that is
 * broken ends at the next such byte.
 */
#include "io/split.h"

#include <string.h>

/* So far is looked for what tells GeoJSON from problems. */
enum { TELL_MAX = 1 << 12 };

enum ph_split_state ph_split_tell_geojson(struct ph_split *split, bool may_wait,
                                          struct ph_diag *diag) {
  for (;;) {
    const char *p = split->data + split->start,
               *end = split->data + split->fill;
    const char *first = ph_json_blanks(p + split->blanks, end);
    size_t n = (size_t)(end - first);
    enum ph_json_state is = PH_JSON_MORE;
    enum ph_split_state state;
    if (n > 0 && *first == PH_RECORD_SEPARATOR) {
      is = PH_JSON_DONE;
    } else if (n > 0) {
      is = ph_geojson_is(first, n < TELL_MAX ? n : TELL_MAX);
    } else {
      split->json.line_start |= memchr(p, '\n', (size_t)(first - p)) != NULL;
      ph_split_drop(split, (size_t)(first - p));
      split->blanks = 0;
    }
    if (is == PH_JSON_DONE) {
      split->format = PH_SPLIT_GEOJSON;
    }
    if (is != PH_JSON_MORE || n >= TELL_MAX) {
      break;
    }
    state = ph_split_fill(split, may_wait, diag);
    if (state == PH_SPLIT_END) {
      break;
    }
    if (state != PH_SPLIT_RECORD) {
      return state;
    }
  }
  split->geojson.told = true;
  return PH_SPLIT_RECORD;
}

bool ph_split_collection(struct ph_split *split, enum ph_json_state *state) {
  struct ph_split_geojson *geojson = &split->geojson;
  const size_t most = split->options.most, n = split->fill - split->start;
  enum ph_json_state features;
  bool over;
  *state = PH_JSON_DONE;
  if (split->format != PH_SPLIT_GEOJSON || geojson->whole) {
    return false;
  }
  features = ph_geojson_features(&geojson->head, split->data + split->start, n);
  over = most && geojson->head.at + geojson->head.scan.at > most;
  if (features == PH_JSON_MORE && !split->end_of_file && !over) {
    *state = PH_JSON_MORE;
    return false;
  }
  if (features != PH_JSON_DONE || over) {
    geojson->whole = true;
    return false;
  }
  ph_split_drop(split, geojson->head.at);
  geojson->head = (struct ph_geojson_head){.at = 0};
  geojson->collection = true;
  return true;
}

enum ph_split_state ph_split_pass_text(struct ph_split *split, bool may_wait,
                                       struct ph_diag *diag) {
  while (split->geojson.skip) {
    const char *p = split->data + split->start;
    const size_t n = split->fill - split->start;
    const char *next = n ? memchr(p, PH_RECORD_SEPARATOR, n) : NULL;
    enum ph_split_state state;
    ph_split_drop(split, next ? (size_t)(next - p) : n);
    split->geojson.skip = !next;
    if (next) {
      break;
    }
    state = ph_split_fill(split, may_wait, diag);
    if (state != PH_SPLIT_RECORD) {
      return state;
    }
  }
  return PH_SPLIT_RECORD;
}

enum ph_split_state ph_split_geojson_line(struct ph_split *split,
                                          struct ph_record *record,
                                          struct ph_diag *diag) {
  struct ph_split_geojson *geojson = &split->geojson;
  struct ph_diag place;
  size_t at;
  ph_buf_clear(&geojson->problem, PH_SPLIT_KEEP);
  *record = geojson->record;
  record->status = ph_geojson_next(&geojson->text, split->schema,
                                   &geojson->problem, &at, diag);
  if (record->status == PH_E_NO_MEMORY) {
    split->ended = true;
    return PH_SPLIT_FAILED;
  }
  ph_split_locate(split, at, &place);
  record->line = place.line;
  if (record->status != PH_OK) {
    diag->line = place.line;
    diag->column = place.column;
  }
  record->text = geojson->problem.data;
  record->n = geojson->problem.n;
  record->named = record->status != PH_OK && record->n > 0;
  record->number = geojson->text.line > 1 ? ++split->number : split->number;
  return PH_SPLIT_RECORD;
}

enum ph_split_state ph_split_geojson(struct ph_split *split, bool may_wait,
                                     struct ph_record *record,
                                     struct ph_diag *diag) {
  struct ph_split_geojson *geojson = &split->geojson;
  enum ph_split_state state = ph_split_json(split, may_wait, record, diag);
  if (state != PH_SPLIT_RECORD || record->status != PH_OK) {
    return state;
  }
  geojson->record = *record;
  ph_geojson_begin(&geojson->text, record->text, record->n);
  return ph_split_geojson_line(split, record, diag);
}
