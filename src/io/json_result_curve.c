/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Segments and spheres of a result record (see json_result_curve.h). */
#include "io/json_result_curve.h"

#include "io/members.h"

#include <math.h>
#include <string.h>

/* ---- members of segments ----------------------------------------------- */

enum segment_member {
#define X(symbol, ...) symbol,
  PH_SEGMENT_MEMBERS(X)
#undef X
      SEGMENT_MEMBERS
};

#define NAME(symbol, name, ...) name,
static const char *const segment_names[] = {PH_SEGMENT_MEMBERS(NAME)};

/* Segments being read. */
struct walk {
  struct ph_json_reader *r;
  struct ph_curve *curve;
  struct ph_json_item first[SEGMENT_MEMBERS]; /* what the first segment has */
  size_t blaschke_room;
};

/* Every segment has what the first one has; but angles, where there are any. */
static void compare_members(struct walk *w, const struct ph_json_item *items) {
  for (size_t i = 0; i < SEGMENT_MEMBERS; i++) {
    bool here = items[i].value != NULL, there = w->first[i].value != NULL;
    if (i == ANGLES || here == there) {
      continue;
    }
    ph_read_enter(w->r, segment_names[i]);
    ph_read_fail(w->r, here ? PH_BAD_SHAPE : PH_MISSING_FIELD,
                 here ? "is in this segment, but not in segments[0]"
                      : "is missing, but segments[0] has one");
    return;
  }
}

/* How many coefficients the preimages have, by the first segment. */
static void measure_preimage(struct walk *w) {
  struct ph_curve *c = w->curve;
  size_t mark = ph_read_enter(w->r, segment_names[PREIMAGE]);
  c->preimage.n = ph_read_size(w->r, &w->first[PREIMAGE]);
  c->preimage.dimension = c->dimension == 2 ? 2 : 4;
  if (c->preimage.n < 1 || c->preimage.n > PH_CLAIM_DEGREE_MAX) {
    ph_read_fail(w->r, PH_BAD_SHAPE,
                 "must have from 1 to %d coefficients, found %zu",
                 PH_CLAIM_DEGREE_MAX, c->preimage.n);
  }
  ph_read_leave(w->r, mark);
}

/* Memory for what the first segment says there is. */
static void allocate(struct walk *w) {
  struct ph_json_reader *r = w->r;
  struct ph_curve *c = w->curve;
  const struct ph_json_item *has = w->first;
  size_t number = sizeof(double), preimage;
  if (has[PREIMAGE].value) {
    measure_preimage(w);
  }
  preimage = c->preimage.n * c->preimage.dimension;
  c->control_points =
      ph_read_array_of(r, c->n, (c->degree + 1) * c->dimension * number);
#define NEED(member, n, size) \
  (has[member].value ? ph_read_array_of(r, (n), (size)) : NULL)
  c->knots = NEED(INTERVAL, c->n + 1, number);
  c->preimage.alpha = NEED(ALPHA, c->n, number);
  c->preimage.v = NEED(PREIMAGE, c->n, preimage * number);
  c->lengths = NEED(LENGTH, c->n, number);
  c->choice.tension = NEED(TENSION, c->n, number);
  c->choice.shape_ok = NEED(SHAPE_OK, c->n, sizeof *c->choice.shape_ok);
  /* of angles, and pieces of images, there need not be any */
  c->choice.angles = NEED(TENSION, c->n, 2 * number);
  c->blaschke.v = NEED(BLASCHKE, 1, sizeof *c->blaschke.v);
#undef NEED
  w->blaschke_room = c->blaschke.v ? 1 : 0;
}

/* The knots: a segment begins where the one before ended. */
static void read_interval(struct walk *w, const struct ph_json_item *item,
                          size_t k) {
  double *knots = w->curve->knots, ends[2] = {0, 0};
  size_t mark;
  ph_read_numbers(w->r, item, segment_names[INTERVAL], ends, 2);
  if (k > 0 && (ends[0] < knots[k] || ends[0] > knots[k])) {
    mark = ph_read_enter(w->r, segment_names[INTERVAL]);
    ph_read_fail(w->r, PH_BAD_VALUE,
                 "begins at %.17g, but segments[%zu] ends at %.17g", ends[0],
                 k - 1, knots[k]);
    ph_read_leave(w->r, mark);
  }
  knots[k] = ends[0];
  knots[k + 1] = ends[1];
}

/* ---- images on the Blaschke cylinder ----------------------------------- */

static void read_piece(struct walk *w, const struct ph_json_item *from,
                       size_t k) {
  static const char *const names[] = {PH_IMAGE_MEMBERS(NAME)};
  struct ph_json_item items[3];
  struct ph_curve *c = w->curve;
  struct ph_blaschke *piece;
  c->blaschke.v = ph_arena_grow(w->r->arena, c->blaschke.v, c->blaschke.n,
                                sizeof *c->blaschke.v, 1, &w->blaschke_room);
  if (!c->blaschke.v) {
    w->r->status = ph_fail_memory(w->r->diag);
    return;
  }
  piece = &c->blaschke.v[c->blaschke.n++];
  piece->segment = k;
  ph_read_members(w->r, from, names, 3, items);
  ph_read_numbers(w->r, &items[0], names[0], piece->interval, 2);
  ph_read_vectors(w->r, &items[1], names[1], piece->control_points[0], 6, 3);
  ph_read_numbers(w->r, &items[2], names[2], piece->weights, 6);
}

static void read_blaschke(struct walk *w, const struct ph_json_item *item,
                          size_t k) {
  size_t mark = ph_read_enter(w->r, segment_names[BLASCHKE]);
  size_t n = ph_read_size(w->r, item);
  struct ph_json_walk walk;
  struct ph_json_item piece;
  ph_json_walk_init(&walk, item->value, item->value_n);
  for (size_t i = 0; w->r->status == PH_OK && i < n; i++) {
    size_t inner = ph_read_enter_at(w->r, i);
    ph_json_walk_next(&walk, &piece);
    read_piece(w, &piece, k);
    ph_read_leave(w->r, inner);
  }
  ph_read_leave(w->r, mark);
}

/* ---- segments ---------------------------------------------------------- */

/* What was chosen for a segment. */
static void read_choice(struct walk *w, const struct ph_json_item *items,
                        size_t k) {
  struct ph_curve *c = w->curve;
  if (c->choice.tension) {
    c->choice.tension[k] = ph_read_number(w->r, &items[TENSION],
                                          segment_names[TENSION], (double)NAN);
  }
  if (c->choice.angles) {
    c->choice.angles[2 * k] = c->choice.angles[2 * k + 1] = (double)NAN;
  }
  if (c->choice.angles && items[ANGLES].value) {
    ph_read_numbers(w->r, &items[ANGLES], segment_names[ANGLES],
                    c->choice.angles + 2 * k, 2);
  }
  if (c->choice.shape_ok) {
    c->choice.shape_ok[k] =
        ph_read_flag(w->r, &items[SHAPE_OK], segment_names[SHAPE_OK], false);
  }
}

static void read_segment(struct walk *w, const struct ph_json_item *from,
                         size_t k) {
  struct ph_json_reader *r = w->r;
  struct ph_curve *c = w->curve;
  struct ph_json_item items[SEGMENT_MEMBERS];
  size_t points = c->degree + 1, preimage = c->preimage.n;
  ph_read_members(r, from, segment_names, SEGMENT_MEMBERS, items);
  compare_members(w, items);
  if (r->status != PH_OK) {
    return;
  }
  if (c->knots) {
    read_interval(w, &items[INTERVAL], k);
  }
  if (c->preimage.alpha) {
    c->preimage.alpha[k] =
        ph_read_number(r, &items[ALPHA], segment_names[ALPHA], 0);
  }
  ph_read_vectors(r, &items[CONTROL_POINTS], segment_names[CONTROL_POINTS],
                  c->control_points + k * points * c->dimension, points,
                  c->dimension);
  if (c->preimage.v) {
    ph_read_vectors(r, &items[PREIMAGE], segment_names[PREIMAGE],
                    c->preimage.v + k * preimage * c->preimage.dimension,
                    preimage, c->preimage.dimension);
  }
  if (c->lengths) {
    c->lengths[k] = ph_read_number(r, &items[LENGTH], segment_names[LENGTH], 0);
  }
  read_choice(w, items, k);
  if (c->blaschke.v) {
    read_blaschke(w, &items[BLASCHKE], k);
  }
}

void ph_read_segments(struct ph_json_reader *r, const struct ph_json_item *item,
                      struct ph_curve *curve) {
  struct walk w = {.r = r, .curve = curve};
  size_t mark = ph_read_enter(r, "segments");
  struct ph_json_walk walk;
  struct ph_json_item segment;
  curve->n = ph_read_size(r, item);
  if (curve->n == 0) {
    ph_read_fail(r, PH_BAD_SHAPE, "is empty");
  }
  ph_json_walk_init(&walk, item->value, item->value_n);
  for (size_t k = 0; r->status == PH_OK && k < curve->n; k++) {
    size_t inner = ph_read_enter_at(r, k);
    ph_json_walk_next(&walk, &segment);
    if (k == 0) {
      ph_read_members(r, &segment, segment_names, SEGMENT_MEMBERS, w.first);
      ph_read_required(r, &w.first[CONTROL_POINTS],
                       segment_names[CONTROL_POINTS]);
      allocate(&w);
    }
    if (r->status == PH_OK) {
      read_segment(&w, &segment, k);
    }
    ph_read_leave(r, inner);
  }
  ph_read_leave(r, mark);
}

/* ---- spheres ----------------------------------------------------------- */

/* The signs at the nodes. */
static void read_indicators(struct ph_json_reader *r,
                            const struct ph_json_item *item, size_t n,
                            struct ph_curve *curve) {
  double *signs = ph_read_array_of(r, n, sizeof *signs);
  curve->sphere.indicators =
      ph_read_array_of(r, n, sizeof *curve->sphere.indicators);
  ph_read_numbers(r, item, "indicators", signs, n);
  for (size_t i = 0; r->status == PH_OK && i < n; i++) {
    double x = signs[i];
    if (!(fabs(x) <= 0) && !(fabs(x) >= 1 && fabs(x) <= 1)) {
      ph_read_enter(r, "indicators");
      ph_read_enter_at(r, i);
      ph_read_fail(r, PH_BAD_VALUE, "must be -1, 0 or 1, found %g", x);
    } else {
      curve->sphere.indicators[i] = (signed char)x;
    }
  }
}

void ph_read_sphere(struct ph_json_reader *r, const struct ph_json_item *items,
                    struct ph_curve *curve) {
  size_t nodes = curve->closed ? curve->n : curve->n + 1, mark;
  if (r->status != PH_OK || !items[1].value) {
    return;
  }
  ph_read_numbers(r, &items[0], "center", curve->sphere.center, 3);
  curve->sphere.radius = ph_read_number(r, &items[1], "radius", 0);
  if (!(curve->sphere.radius > 0)) {
    mark = ph_read_enter(r, "radius");
    ph_read_fail(r, PH_BAD_VALUE, "must be greater than 0, found %g",
                 curve->sphere.radius);
    ph_read_leave(r, mark);
  }
  if (items[2].value) {
    curve->sphere.tensions =
        ph_read_array_of(r, nodes, sizeof *curve->sphere.tensions);
    ph_read_numbers(r, &items[2], "tensions", curve->sphere.tensions, nodes);
  }
  if (items[3].value) {
    read_indicators(r, &items[3], nodes, curve);
  }
}
