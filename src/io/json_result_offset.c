/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Offsets and samples of a result record (see json_result_curve.h). */
#include "io/json_result_curve.h"

#include "io/members.h"

#include <math.h>
#include <string.h>

/* The segment that something belongs to. */
static size_t read_place(struct ph_json_reader *r,
                         const struct ph_json_item *item,
                         const struct ph_curve *curve) {
  return ph_read_whole(r, item, "segment", 0, curve->n - 1);
}

/* ---- samples ----------------------------------------------------------- */

enum sample_member {
#define X(symbol, ...) symbol,
  PH_SAMPLE_MEMBERS(X)
#undef X
      SAMPLE_MEMBERS
};

#define NAME(symbol, name, ...) name,
static const char *const sample_names[] = {PH_SAMPLE_MEMBERS(NAME)};

/* Memory for samples, with what any of them has. */
static void allocate_samples(struct ph_json_reader *r,
                             const struct ph_json_item *from,
                             struct ph_samples *s) {
  size_t n = s->n, number = sizeof(double);
  bool any[SAMPLE_MEMBERS] = {false};
  struct ph_json_item items[SAMPLE_MEMBERS], sample;
  struct ph_json_walk walk;
  ph_json_walk_init(&walk, from->value, from->value_n);
  for (size_t i = 0; r->status == PH_OK && i < n; i++) {
    size_t mark = ph_read_enter_at(r, i);
    ph_json_walk_next(&walk, &sample);
    ph_read_members(r, &sample, sample_names, SAMPLE_MEMBERS, items);
    for (size_t j = 0; j < SAMPLE_MEMBERS; j++) {
      any[j] = any[j] || items[j].value;
    }
    ph_read_leave(r, mark);
  }
  s->segment = ph_read_array_of(r, n, sizeof *s->segment);
  s->t = ph_read_array_of(r, n, number);
  s->s = ph_read_array_of(r, n, number);
  s->point = ph_read_array_of(r, n, s->dimension * number);
  s->tangent = ph_read_array_of(r, n, s->dimension * number);
  s->curvature = ph_read_array_of(r, n, number);
#define IF_ANY(member, size) \
  (any[member] ? ph_read_array_of(r, n, (size)) : NULL)
  s->torsion = IF_ANY(TORSION, number);
  s->lonlat = IF_ANY(LONLAT, 2 * number);
  s->normal = IF_ANY(NORMAL, 3 * number);
  s->binormal = IF_ANY(BINORMAL, 3 * number);
#undef IF_ANY
}

/* A vector that is not defined everywhere. */
static void read_vector(struct ph_json_reader *r,
                        const struct ph_json_item *items,
                        enum sample_member which, double *v, size_t n) {
  for (size_t i = 0; i < n; i++) {
    v[i] = (double)NAN;
  }
  if (items[which].value) {
    ph_read_numbers(r, &items[which], sample_names[which], v, n);
  }
}

static double read_required(struct ph_json_reader *r,
                            const struct ph_json_item *items,
                            enum sample_member which) {
  ph_read_required(r, &items[which], sample_names[which]);
  return ph_read_number(r, &items[which], sample_names[which], 0);
}

static void read_sample(struct ph_json_reader *r,
                        const struct ph_json_item *from,
                        const struct ph_curve *curve, struct ph_samples *s,
                        size_t i) {
  size_t d = s->dimension;
  struct ph_json_item items[SAMPLE_MEMBERS];
  ph_read_members(r, from, sample_names, SAMPLE_MEMBERS, items);
  s->segment[i] = read_place(r, &items[SEGMENT], curve);
  s->t[i] = read_required(r, items, T);
  s->s[i] = read_required(r, items, S);
  ph_read_numbers(r, &items[POINT], sample_names[POINT], s->point + d * i, d);
  read_vector(r, items, TANGENT, s->tangent + d * i, d);
  s->curvature[i] = ph_read_number(r, &items[CURVATURE],
                                   sample_names[CURVATURE], (double)NAN);
  if (s->torsion) {
    s->torsion[i] =
        ph_read_number(r, &items[TORSION], sample_names[TORSION], (double)NAN);
  }
  if (s->lonlat) {
    read_vector(r, items, LONLAT, s->lonlat + 2 * i, 2);
  }
  if (s->normal) {
    read_vector(r, items, NORMAL, s->normal + 3 * i, 3);
  }
  if (s->binormal) {
    read_vector(r, items, BINORMAL, s->binormal + 3 * i, 3);
  }
}

void ph_read_samples(struct ph_json_reader *r, const struct ph_json_item *item,
                     const struct ph_curve *curve, struct ph_samples *s) {
  struct ph_json_walk walk;
  struct ph_json_item sample;
  size_t mark;
  if (r->status != PH_OK || !item->value) {
    return;
  }
  mark = ph_read_enter(r, "samples");
  s->n = ph_read_size(r, item);
  s->dimension = curve->dimension;
  allocate_samples(r, item, s);
  ph_json_walk_init(&walk, item->value, item->value_n);
  for (size_t i = 0; r->status == PH_OK && i < s->n; i++) {
    size_t inner = ph_read_enter_at(r, i);
    ph_json_walk_next(&walk, &sample);
    read_sample(r, &sample, curve, s, i);
    ph_read_leave(r, inner);
  }
  ph_read_leave(r, mark);
}

/* ---- pieces of offsets --------------------------------------------------- */

enum piece_member {
#define X(symbol, ...) symbol,
  PH_PIECE_MEMBERS(X)
#undef X
      PIECE_MEMBERS
};

static const char *const piece_names[] = {PH_PIECE_MEMBERS(NAME)};

/* A list of pieces, rational or quotients; polynomial ones are the former
 * without weights. */
struct pieces {
  struct ph_json_reader *r;
  const struct ph_curve *curve;
  size_t n, degree;
  size_t *segment;
  double *interval;
  double *points;  /* control points or numerators */
  double *weights; /* or denominators; NULL: neither */
  bool quotients;
};

static void read_piece(struct pieces *p, const struct ph_json_item *from,
                       size_t i) {
  struct ph_json_item items[PIECE_MEMBERS];
  enum piece_member points = p->quotients ? NUMERATOR : CONTROL_POINTS;
  enum piece_member weights = p->quotients ? DENOMINATOR : WEIGHTS;
  size_t n = p->degree + 1, dimension = p->curve->dimension;
  ph_read_members(p->r, from, piece_names, PIECE_MEMBERS, items);
  p->segment[i] = read_place(p->r, &items[PIECE_SEGMENT], p->curve);
  ph_read_numbers(p->r, &items[INTERVAL], piece_names[INTERVAL],
                  p->interval + 2 * i, 2);
  ph_read_vectors(p->r, &items[points], piece_names[points],
                  p->points + i * n * dimension, n, dimension);
  if (p->weights) {
    ph_read_numbers(p->r, &items[weights], piece_names[weights],
                    p->weights + i * n, n);
  }
}

/* An array of pieces; the degree is given. */
static void read_pieces(struct pieces *p, const struct ph_json_item *from,
                        bool weights) {
  struct ph_json_reader *r = p->r;
  struct ph_json_walk walk;
  struct ph_json_item piece;
  size_t points = p->degree + 1, number = sizeof(double);
  p->segment = ph_read_array_of(r, p->n, sizeof *p->segment);
  p->interval = ph_read_array_of(r, p->n, 2 * number);
  p->points = ph_read_array_of(r, p->n, points * p->curve->dimension * number);
  p->weights = weights ? ph_read_array_of(r, p->n, points * number) : NULL;
  ph_json_walk_init(&walk, from->value, from->value_n);
  for (size_t i = 0; r->status == PH_OK && i < p->n; i++) {
    size_t mark = ph_read_enter_at(r, i);
    ph_json_walk_next(&walk, &piece);
    read_piece(p, &piece, i);
    ph_read_leave(r, mark);
  }
}

/* Whether the first piece is a quotient. */
static bool has_quotients(struct ph_json_reader *r,
                          const struct ph_json_item *from) {
  struct ph_json_item items[PIECE_MEMBERS], piece;
  struct ph_json_walk walk;
  ph_json_walk_init(&walk, from->value, from->value_n);
  if (!ph_json_walk_next(&walk, &piece)) {
    return false;
  }
  ph_read_members(r, &piece, piece_names, PIECE_MEMBERS, items);
  return items[NUMERATOR].value != NULL;
}

/* ---- offsets ------------------------------------------------------------- */

enum offset_member {
#define X(symbol, ...) symbol,
  PH_OFFSET_MEMBERS(X)
#undef X
      OFFSET_MEMBERS
};

static const char *const offset_names[] = {PH_OFFSET_MEMBERS(NAME)};

/* The exact pieces. */
static void read_offset_pieces(struct ph_json_reader *r,
                               const struct ph_json_item *items,
                               const struct ph_curve *curve,
                               struct ph_offset *o) {
  struct pieces p = {.r = r, .curve = curve};
  size_t mark;
  if (r->status != PH_OK || !items[SEGMENTS].value) {
    return;
  }
  o->degree = ph_read_whole(r, &items[DEGREE], offset_names[DEGREE], 1,
                            PH_CLAIM_DEGREE_MAX);
  mark = ph_read_enter(r, offset_names[SEGMENTS]);
  p.n = ph_read_size(r, &items[SEGMENTS]);
  p.degree = o->degree;
  p.quotients = r->status == PH_OK && has_quotients(r, &items[SEGMENTS]);
  read_pieces(&p, &items[SEGMENTS], true);
  ph_read_leave(r, mark);
  o->n = p.n;
  o->segment = p.segment;
  o->interval = p.interval;
  *(p.quotients ? &o->numerator : &o->control_points) = p.points;
  *(p.quotients ? &o->denominator : &o->weights) = p.weights;
}

/* How many control points the first piece has, less one. */
static size_t degree_of(struct ph_json_reader *r,
                        const struct ph_json_item *from) {
  struct ph_json_item items[PIECE_MEMBERS], piece;
  struct ph_json_walk walk;
  size_t n = 0, mark = ph_read_enter_at(r, 0), inner;
  ph_json_walk_init(&walk, from->value, from->value_n);
  ph_json_walk_next(&walk, &piece);
  ph_read_members(r, &piece, piece_names, PIECE_MEMBERS, items);
  if (ph_read_required(r, &items[CONTROL_POINTS],
                       piece_names[CONTROL_POINTS])) {
    inner = ph_read_enter(r, piece_names[CONTROL_POINTS]);
    n = ph_read_size(r, &items[CONTROL_POINTS]);
    if (n < 2 || n > PH_CLAIM_DEGREE_MAX + 1) {
      ph_read_fail(r, PH_BAD_SHAPE, "must have from 2 to %d vectors, found %zu",
                   PH_CLAIM_DEGREE_MAX + 1, n);
    }
    ph_read_leave(r, inner);
  }
  ph_read_leave(r, mark);
  return r->status == PH_OK ? n - 1 : 0;
}

/* The polynomial pieces. */
static void read_beziers(struct ph_json_reader *r,
                         const struct ph_json_item *items,
                         const struct ph_curve *curve, struct ph_offset *o) {
  struct pieces p = {.r = r, .curve = curve};
  size_t mark;
  if (r->status != PH_OK || !items[BEZIERS].value) {
    return;
  }
  mark = ph_read_enter(r, offset_names[BEZIERS]);
  p.n = ph_read_size(r, &items[BEZIERS]);
  p.degree = p.n ? degree_of(r, &items[BEZIERS]) : 0;
  read_pieces(&p, &items[BEZIERS], false);
  ph_read_leave(r, mark);
  o->pieces = (struct ph_pieces){
      p.degree,
      curve->dimension,
      p.n,
      p.segment,
      p.interval,
      p.points,
      ph_read_number(r, &items[ERROR], offset_names[ERROR], (double)NAN)};
}

static void read_cusps(struct ph_json_reader *r,
                       const struct ph_json_item *item,
                       const struct ph_curve *curve, struct ph_cusps *cusps) {
  static const char *const names[] = {PH_CUSP_MEMBERS(NAME)};
  struct ph_json_item items[2], cusp;
  struct ph_json_walk walk;
  size_t mark;
  if (r->status != PH_OK || !item->value) {
    return;
  }
  mark = ph_read_enter(r, offset_names[CUSPS]);
  cusps->n = ph_read_size(r, item);
  cusps->at =
      cusps->n ? ph_read_array_of(r, cusps->n, sizeof *cusps->at) : NULL;
  ph_json_walk_init(&walk, item->value, item->value_n);
  for (size_t i = 0; r->status == PH_OK && i < cusps->n; i++) {
    struct ph_place *at = &cusps->at[i];
    size_t inner = ph_read_enter_at(r, i);
    ph_json_walk_next(&walk, &cusp);
    ph_read_members(r, &cusp, names, 2, items);
    at->segment = read_place(r, &items[0], curve);
    ph_read_required(r, &items[1], names[1]);
    at->t = ph_read_number(r, &items[1], names[1], 0);
    at->u = at->t / ph_curve_range(curve, at->segment);
    ph_read_leave(r, inner);
  }
  ph_read_leave(r, mark);
}

static void read_gaps(struct ph_json_reader *r, const struct ph_json_item *item,
                      const struct ph_curve *curve, struct ph_gaps *gaps) {
  struct ph_json_item before;
  struct ph_json_walk walk;
  size_t mark;
  if (r->status != PH_OK || !item->value) {
    return;
  }
  mark = ph_read_enter(r, offset_names[GAPS]);
  gaps->n = ph_read_size(r, item);
  gaps->before =
      gaps->n ? ph_read_array_of(r, gaps->n, sizeof *gaps->before) : NULL;
  ph_json_walk_init(&walk, item->value, item->value_n);
  for (size_t i = 0; r->status == PH_OK && i < gaps->n; i++) {
    size_t inner = ph_read_enter_at(r, i);
    ph_json_walk_next(&walk, &before);
    gaps->before[i] = ph_read_whole(r, &before, NULL, 0, curve->n - 1);
    ph_read_leave(r, inner);
  }
  ph_read_leave(r, mark);
}

/* In space, e2 or e3. */
static const char *read_frame_vector(struct ph_json_reader *r,
                                     const struct ph_json_item *item) {
  const char *vector = ph_read_string(r, item, offset_names[VECTOR], NULL);
  size_t mark;
  if (vector && strcmp(vector, "e2") != 0 && strcmp(vector, "e3") != 0) {
    mark = ph_read_enter(r, offset_names[VECTOR]);
    ph_read_fail(r, PH_BAD_VALUE, "must be \"e2\" or \"e3\"");
    ph_read_leave(r, mark);
  }
  return vector;
}

static void read_offset(struct ph_json_reader *r,
                        const struct ph_json_item *from,
                        const struct ph_curve *curve, struct ph_offset *o) {
  struct ph_json_item items[OFFSET_MEMBERS];
  *o = (struct ph_offset){.dimension = curve->dimension};
  ph_read_members(r, from, offset_names, OFFSET_MEMBERS, items);
  ph_read_required(r, &items[DISTANCE], offset_names[DISTANCE]);
  o->distance = ph_read_number(r, &items[DISTANCE], offset_names[DISTANCE], 0);
  o->vector = read_frame_vector(r, &items[VECTOR]);
  read_offset_pieces(r, items, curve, o);
  read_beziers(r, items, curve, o);
  o->length =
      ph_read_number(r, &items[LENGTH], offset_names[LENGTH], (double)NAN);
  read_cusps(r, &items[CUSPS], curve, &o->cusps);
  read_gaps(r, &items[GAPS], curve, &o->gaps);
  ph_read_samples(r, &items[SAMPLES], curve, &o->samples);
}

void ph_read_offsets(struct ph_json_reader *r, const struct ph_json_item *item,
                     const struct ph_curve *curve, struct ph_offset **offsets,
                     size_t *offsets_n) {
  struct ph_json_walk walk;
  struct ph_json_item offset;
  size_t mark, n;
  if (r->status != PH_OK || !item->value) {
    return;
  }
  mark = ph_read_enter(r, "offsets");
  n = ph_read_size(r, item);
  *offsets = ph_read_array_of(r, n, sizeof **offsets);
  ph_json_walk_init(&walk, item->value, item->value_n);
  for (size_t i = 0; r->status == PH_OK && i < n; i++) {
    size_t inner = ph_read_enter_at(r, i);
    ph_json_walk_next(&walk, &offset);
    read_offset(r, &offset, curve, *offsets + i);
    ph_read_leave(r, inner);
  }
  ph_read_leave(r, mark);
  *offsets_n = n;
}
