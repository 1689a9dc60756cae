/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * GeoJSON (RFC 7946) as problems: each line, ring and MultiPoint of a text is
 * one, handed out as the JSON text of a problem.
 *
 *   positions   the field points, or lonlat where the command has that; where
 *               the field is of the plane, an elevation goes to meta
 *   a ring      closed
 *   id          of the feature, with /1, /2, ... where it has several lines
 *   properties  meta
 *
 * Line breaks among the positions are kept, so that lines can be counted.
 */
#ifndef PH_IO_GEOJSON_H
#define PH_IO_GEOJSON_H

#include "base/buf.h"
#include "base/diag.h"
#include "curve/problem.h"
#include "io/json_scan.h"

#include <stdbool.h>
#include <stddef.h>

/* What is still to be gone through: the items of an array. */
struct ph_geojson_level {
  struct ph_json_walk walk;
  unsigned above;  /* arrays between an item and its lines */
  bool ring;       /* its lines are rings */
  bool geometries; /* items are geometries */
};

/* A line or ring, or what is in the place of one. */
struct ph_geojson_line {
  const char *at; /* in the text */
  size_t n;       /* 0: it is none, diag says why */
  bool ring;
  struct ph_diag diag;
};

/* A text that is gone through. */
struct ph_geojson {
  const char *text;
  size_t n;
  struct ph_json_item id, properties; /* value NULL: absent */
  struct ph_geojson_level level[PH_JSON_DEPTH_MAX];
  size_t depth;
  struct ph_geojson_line next;
  bool more;   /* next is one */
  size_t line; /* that were handed out */
};

/*
 * ph_geojson_begin: begins with a text: a Feature or a geometry, one JSON value
 * that ph_json_scan has found good and that stays where it is.  There is at
 * least one line, or what is in its place.
 */
void ph_geojson_begin(struct ph_geojson *geojson, const char *text, size_t n);

/*
 * ph_geojson_next: the next line as a problem.
 *
 * in   schema   of the command
 * out  problem  its text; of one that failed the id, if there is one, else
 *               empty
 * out  at       offset in the text of the line, or of what is wrong
 * ret  PH_OK; PH_E_BAD_TYPE, PH_E_BAD_VALUE, PH_E_MISSING_FIELD, with field and
 *      message; PH_E_NO_MEMORY
 */
enum ph_status ph_geojson_next(struct ph_geojson *geojson,
                               const struct ph_schema *schema,
                               struct ph_buf *problem, size_t *at,
                               struct ph_diag *diag);

/* ---- streams --------------------------------------------------------------
 */

/* How far the beginning of a text was looked through for its features. */
struct ph_geojson_head {
  size_t at;
  struct ph_json_scan scan; /* of the string or value there */
  unsigned char expect;
  unsigned char name; /* of the member */
};

/*
 * ph_geojson_features: whether text[n] is a FeatureCollection, which begins
 * with its first byte; {0} is the beginning.
 *
 * ret  PH_JSON_DONE: it is, head->at is the first byte after the bracket of
 *      its features; PH_JSON_MORE: the text ends before that; PH_JSON_ERROR: it
 *      is not
 */
enum ph_json_state ph_geojson_features(struct ph_geojson_head *head,
                                       const char *text, size_t n);

/*
 * ph_geojson_is: whether text[n] begins as GeoJSON does and no problem: an
 * object, perhaps of an array, whose first member is one of GeoJSON alone.
 *
 * ret  PH_JSON_DONE: it does; PH_JSON_MORE: the text ends too early to tell;
 *      PH_JSON_ERROR: it does not
 */
enum ph_json_state ph_geojson_is(const char *text, size_t n);

#endif
