/* SPDX-License-Identifier: GPL-3.0-or-later */
/* GeoJSON (see geojson_out.h). */
#include "io/geojson_out.h"

#include "base/mem.h"
#include "base/relay.h"
#include "curve/offset/gap.h"

#include <math.h>
#include <string.h>

void ph_geojson_header(struct ph_buf *buf) {
  ph_buf_puts(buf, "{\"type\":\"FeatureCollection\",\"features\":[\n");
}

void ph_geojson_footer(struct ph_buf *buf) {
  ph_buf_puts(buf, "\n]}\n");
}

/* ---- positions --------------------------------------------------------- */

/* A position: its coordinates. */
struct position {
  double at[3];
  size_t n;
};

static struct position position(const struct ph_samples *s, size_t i) {
  struct position p = {{0}, s->lonlat ? 2 : s->dimension};
  memcpy(p.at, s->lonlat ? s->lonlat + 2 * i : s->point + s->dimension * i,
         p.n * sizeof *p.at);
  return p;
}

static bool same(const struct position *a, const struct position *b) {
  bool same = true;
  for (size_t i = 0; i < a->n; i++) {
    same &= !(a->at[i] < b->at[i]) && !(a->at[i] > b->at[i]);
  }
  return same;
}

static void put(struct ph_json_writer *w, const struct position *p) {
  ph_write_element(w);
  ph_write_numbers(w, p->at, p->n);
}

/* ---- lines ------------------------------------------------------------- */

/* Lines through samples, which are cut. */
struct lines {
  struct ph_json_writer *w; /* NULL: they are counted */
  const struct ph_samples *s;
  const struct ph_gaps *gaps; /* that cut them, or NULL */
  const double *center;       /* of the sphere */
  bool ring;                  /* the last sample is the first */
  bool several;               /* there are */
  size_t gap;                 /* the next one */
  size_t n;                   /* lines */
  bool begun;                 /* the last one */
  struct position last;       /* of it */
};

static void begin_line(struct lines *l) {
  if (l->begun && l->w) {
    ph_write_end(l->w, ']');
  }
  if (l->w && l->several) {
    ph_write_element(l->w);
  }
  if (l->w) {
    ph_write_begin(l->w, '[');
  }
  l->begun = false;
  l->n++;
}

static void add(struct lines *l, const struct position *p) {
  if (!l->begun || !same(p, &l->last)) {
    if (l->w) {
      put(l->w, p);
    }
    l->last = *p;
    l->begun = true;
  }
}

/* Whether a latitude is that of a pole, to rounding. */
static bool at_pole(double latitude) {
  return !(fabs(latitude) < 90 - 1e-12);
}

/* The longitude of the first sample after i that is at no pole; `unset` if
 * there is none. */
static double longitude_after(const struct ph_samples *s, size_t i,
                              double unset) {
  do {
    i++;
  } while (i < s->n && at_pole(s->lonlat[2 * i + 1]));
  return i < s->n ? s->lonlat[2 * i] : unset;
}

/* The longitude of a pole, and the sign of one of 180 degrees, are those of
 * what is beside it. */
static void settle(const struct lines *l, size_t i, struct position *p) {
  const double beside =
      l->begun ? l->last.at[0] : longitude_after(l->s, i, p->at[0]);
  if (at_pole(p->at[1])) {
    p->at[0] = beside;
  } else if (!(fabs(p->at[0]) < 180)) {
    p->at[0] = copysign(180, beside);
  }
}

/* The line is at a pole, and goes on at another longitude: as another line. */
static void leave_pole(struct lines *l, double longitude) {
  struct position p = l->last;
  if (fabs(longitude - p.at[0]) > 1e-9) {
    begin_line(l);
    p.at[0] = longitude;
    add(l, &p);
  }
}

/* Whether the line passes a pole, to rounding, on the way to p. */
static bool over_pole(const struct lines *l, const struct position *p) {
  return !at_pole(l->last.at[1]) && !at_pole(p->at[1]) &&
         fabs(fabs(p->at[0] - l->last.at[0]) - 180) < 1e-9;
}

static void cross_pole(struct lines *l, const struct position *p) {
  struct position pole = {
      {l->last.at[0], copysign(90, l->last.at[1] + p->at[1])}, 2};
  add(l, &pole);
  leave_pole(l, p->at[0]);
}

/* Between the samples i - 1 and i the line passes the longitude 180: there the
 * plane y = 0 meets the chord. */
static void cross_seam(struct lines *l, size_t i) {
  const double *a = l->s->point + 3 * (i - 1), *b = a + 3;
  double p[3], q[3], t;
  struct position seam = {{copysign(180, l->last.at[0])}, 2};
  for (size_t k = 0; k < 3; k++) {
    p[k] = a[k] - l->center[k];
    q[k] = b[k] - l->center[k];
  }
  t = p[1] / (p[1] - q[1]);
  t = t >= 0 && t <= 1 ? t : 0;
  seam.at[1] = atan2(p[2] + t * (q[2] - p[2]), fabs(p[0] + t * (q[0] - p[0]))) *
               (180 / acos(-1));
  add(l, &seam);
  begin_line(l);
  seam.at[0] = -seam.at[0];
  add(l, &seam);
}

/* Goes through some of the samples, from where it is. */
static void go(struct lines *l, size_t first, size_t end) {
  const struct ph_samples *s = l->s;
  for (size_t i = first; i < end; i++) {
    struct position p = position(s, l->ring && i + 1 == s->n ? 0 : i);
    bool cut = l->gaps && ph_gaps_pass(l->gaps, s->segment[i], &l->gap);
    if (i == 0 || cut) {
      begin_line(l);
    }
    if (s->lonlat) {
      settle(l, i, &p);
      if (l->begun && over_pole(l, &p)) {
        cross_pole(l, &p);
      } else if (l->begun && fabs(p.at[0] - l->last.at[0]) > 180) {
        cross_seam(l, i);
      }
    }
    add(l, &p);
    if (s->lonlat && at_pole(p.at[1])) {
      leave_pole(l, longitude_after(s, i, p.at[0]));
    }
  }
}

/* Lines as they are before each chunk of samples. */
struct course {
  struct ph_json_writer *w; /* behind the first bracket */
  bool several;
  struct lines *at;
};

static void write_some(void *context, struct ph_buf *to, size_t first,
                       size_t end) {
  const struct course *course = context;
  struct lines lines = course->at[first / PH_RELAY_CHUNK];
  struct ph_json_writer w = *course->w;
  w.buf = to;
  if (first > 0) { /* in a line */
    w.comma[w.depth] = true;
    w.comma[++w.depth] = lines.begun;
  }
  lines.w = &w;
  lines.several = course->several;
  go(&lines, first, end);
}

/* Brings lines to the end; out  at  as they are before each chunk. */
static void look_ahead(struct lines *l, struct lines *at) {
  for (size_t i = 0; i < l->s->n; i += PH_RELAY_CHUNK) {
    const size_t left = l->s->n - i;
    at[i / PH_RELAY_CHUNK] = *l;
    go(l, i, i + (left < PH_RELAY_CHUNK ? left : PH_RELAY_CHUNK));
  }
}

/* Lines that are at their beginning; `several`: one of them has no bracket of
 * its own.  at has room for what comes before each chunk. */
static void write_course(struct ph_json_writer *w, size_t n, bool several,
                         struct lines *at) {
  struct course course = {w, several, at};
  ph_relay(w->buf, n, write_some, &course);
  w->comma[w->depth] = true;
  w->comma[++w->depth] = true;
  ph_write_end(w, ']');
}

static void write_lines(struct ph_json_writer *w, const struct ph_samples *s,
                        const struct ph_gaps *gaps, const double *center,
                        bool ring, struct lines *at) {
  struct lines count = {.s = s, .gaps = gaps, .center = center, .ring = ring};
  bool several;
  look_ahead(&count, at);
  several = count.n > 1;
  ph_write_key_string(w, "type", several ? "MultiLineString" : "LineString");
  ph_write_key(w, "coordinates");
  if (several) {
    ph_write_begin(w, '[');
  }
  write_course(w, s->n, several, at);
  if (several) {
    ph_write_end(w, ']');
  }
}

/* ---- rings ------------------------------------------------------------- */

/* Twice the area of the polygon, positive counter-clockwise. */
static double area(const struct ph_samples *s) {
  const double *p = s->point, *first = p;
  double sum = 0;
  for (size_t i = 1; i < s->n; i++) {
    const double *a = p + 2 * (i - 1), *b = p + 2 * i;
    sum += (a[0] - first[0]) * (b[1] - first[1]) -
           (a[1] - first[1]) * (b[0] - first[0]);
  }
  return sum;
}

/* The samples of a ring in their order. */
struct ring {
  struct ph_json_writer *w; /* behind its bracket */
  const struct ph_samples *s;
  bool reversed;
};

static struct position ring_position(const struct ring *ring, size_t i) {
  const size_t n = ring->s->n;
  return position(ring->s, i + 1 == n || i == 0 ? 0
                           : ring->reversed     ? n - 1 - i
                                                : i);
}

static void write_some_of_ring(void *context, struct ph_buf *to, size_t first,
                               size_t end) {
  const struct ring *ring = context;
  struct ph_json_writer w = *ring->w;
  struct position last = ring_position(ring, first > 0 ? first - 1 : 0);
  w.buf = to;
  w.comma[w.depth] = first > 0;
  for (size_t i = first; i < end; i++) {
    struct position p = ring_position(ring, i);
    if (i == 0 || !same(&p, &last)) {
      put(&w, &p);
    }
    last = p;
  }
}

static void write_ring(struct ph_json_writer *w, const struct ph_samples *s,
                       bool hole) {
  struct ring ring = {w, s, (area(s) < 0) != hole};
  ph_write_element(w);
  ph_write_begin(w, '[');
  ph_relay(w->buf, s->n, write_some_of_ring, &ring);
  w->comma[w->depth] = s->n > 0;
  ph_write_end(w, ']');
}

/* Whether a point is inside a ring: a ray from it meets the ring an odd number
 * of times. */
static bool is_inside(const double *p, const struct ph_samples *s) {
  bool inside = false;
  for (size_t i = 1; i < s->n; i++) {
    const double *a = s->point + 2 * (i - 1), *b = a + 2;
    if ((a[1] > p[1]) != (b[1] > p[1]) &&
        p[0] - a[0] < (p[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0])) {
      inside = !inside;
    }
  }
  return inside;
}

/* A place of a loop that is hardly one where it touches another. */
static const double *inner_point(const struct ph_loop *loop) {
  return loop->samples.point + 2 * (loop->samples.n / 3);
}

static void bounds(const struct ph_samples *s, double box[4]) {
  box[0] = box[1] = (double)INFINITY;
  box[2] = box[3] = -(double)INFINITY;
  for (size_t i = 0; i < s->n; i++) {
    for (size_t k = 0; k < 2; k++) {
      box[k] = fmin(box[k], s->point[2 * i + k]);
      box[2 + k] = fmax(box[2 + k], s->point[2 * i + k]);
    }
  }
}

/* Where a loop stands. */
struct nest {
  size_t depth; /* loops around it */
  size_t inner; /* the smallest of these */
};

static void find_nests(const struct ph_loops *loops, struct nest *nest) {
  memset(nest, 0, loops->n * sizeof *nest);
  for (size_t j = 0; j < loops->n; j++) {
    const struct ph_loop *outer = &loops->v[j];
    double box[4];
    bounds(&outer->samples, box);
    for (size_t i = 0; i < loops->n; i++) {
      const double *p = inner_point(&loops->v[i]);
      if (fabs(loops->v[i].area) < fabs(outer->area) && p[0] >= box[0] &&
          p[1] >= box[1] && p[0] <= box[2] && p[1] <= box[3] &&
          is_inside(p, &outer->samples)) {
        nest[i].inner =
            nest[i].depth == 0 ||
                    fabs(outer->area) < fabs(loops->v[nest[i].inner].area)
                ? j
                : nest[i].inner;
        nest[i].depth++;
      }
    }
  }
}

/* A polygon: an outer ring with the holes in it. */
static void write_polygon(struct ph_json_writer *w,
                          const struct ph_loops *loops, const struct nest *nest,
                          size_t outer) {
  ph_write_begin(w, '[');
  write_ring(w, &loops->v[outer].samples, false);
  for (size_t i = 0; i < loops->n; i++) {
    if (nest[i].depth % 2 == 1 && nest[i].inner == outer) {
      write_ring(w, &loops->v[i].samples, true);
    }
  }
  ph_write_end(w, ']');
}

/* Closed loops; nest has room for them. */
static void write_polygons(struct ph_json_writer *w,
                           const struct ph_loops *loops, struct nest *nest) {
  size_t outer = 0;
  find_nests(loops, nest);
  for (size_t i = 0; i < loops->n; i++) {
    outer += nest[i].depth % 2 == 0;
  }
  ph_write_key_string(w, "type", outer > 1 ? "MultiPolygon" : "Polygon");
  ph_write_key(w, "coordinates");
  if (outer > 1) {
    ph_write_begin(w, '[');
  }
  for (size_t i = 0; i < loops->n; i++) {
    if (nest[i].depth % 2 == 0) {
      if (outer > 1) {
        ph_write_element(w);
      }
      write_polygon(w, loops, nest, i);
    }
  }
  if (outer > 1) {
    ph_write_end(w, ']');
  }
}

/* Loops of which one is open. */
static void write_open(struct ph_json_writer *w, const struct ph_loops *loops,
                       struct lines *at) {
  const bool several = loops->n > 1;
  ph_write_key_string(w, "type", several ? "MultiLineString" : "LineString");
  ph_write_key(w, "coordinates");
  if (several) {
    ph_write_begin(w, '[');
  }
  for (size_t i = 0; i < loops->n; i++) {
    const struct ph_samples *s = &loops->v[i].samples;
    struct lines lines = {.s = s, .ring = loops->v[i].closed};
    look_ahead(&lines, at);
    write_course(w, s->n, several, at);
  }
  if (several) {
    ph_write_end(w, ']');
  }
}

/* What is found before it is written. */
struct room {
  struct nest *nest; /* [loops] */
  struct lines *at;  /* [chunks of samples] */
};

static void write_loops(struct ph_json_writer *w, const struct ph_loops *loops,
                        const struct room *room) {
  bool closed = true;
  for (size_t i = 0; i < loops->n; i++) {
    closed &= loops->v[i].closed && loops->v[i].samples.n >= 4;
  }
  if (closed) {
    write_polygons(w, loops, room->nest);
  } else {
    write_open(w, loops, room->at);
  }
}

/* ---- features ---------------------------------------------------------- */

static void write_curve(struct ph_json_writer *w, const struct ph_result *r,
                        const struct room *room) {
  const struct ph_samples *s = &r->samples;
  if (r->curve.closed && s->n >= 4 && s->dimension == 2 &&
      ph_diagnostics_known(&r->diagnostics, PH_D_SIMPLE) &&
      r->diagnostics.value[PH_D_SIMPLE] > 0) {
    ph_write_key_string(w, "type", "Polygon");
    ph_write_key(w, "coordinates");
    ph_write_begin(w, '[');
    write_ring(w, s, false);
    ph_write_end(w, ']');
  } else {
    write_lines(w, s, NULL, r->curve.sphere.center, r->curve.closed, room->at);
  }
}

static void write_offset(struct ph_json_writer *w, const struct ph_result *r,
                         const struct ph_offset *o, const struct room *room) {
  if (o->loops.mode) {
    write_loops(w, &o->loops, room);
  } else {
    write_lines(w, &o->samples, &o->gaps, r->curve.sphere.center,
                r->curve.closed && !ph_gaps_open(&o->gaps), room->at);
  }
}

/* A curve, or an offset of it. */
static void write_feature(struct ph_buf *buf, const struct ph_heading *heading,
                          const struct ph_result *r, const struct ph_offset *o,
                          const struct room *room) {
  struct ph_json_writer w = {.buf = buf};
  const struct ph_echo *echo = heading->echo;
  const double length = o ? o->length : r->curve.length;
  const bool empty = o && o->loops.mode && o->loops.n == 0;
  ph_buf_puts(buf, PH_GEOJSON_JOINT);
  ph_write_begin(&w, '{');
  ph_write_key_string(&w, "type", "Feature");
  if (!o && heading->swept_n == 0) {
    ph_write_key_raw(&w, "id", echo->id, echo->id_n);
  }
  ph_write_key(&w, "properties");
  ph_write_begin(&w, '{');
  ph_write_key_raw(&w, "id", echo->id, echo->id_n);
  if (o) {
    ph_write_key_number(&w, "distance", o->distance);
  }
  if (o && o->vector) {
    ph_write_key_string(&w, "vector", o->vector);
  }
  if (isfinite(length)) {
    ph_write_key_number(&w, "length", length);
  }
  if (heading->file) {
    ph_write_key_string(&w, "file", heading->file);
  }
  ph_json_fields(&w, "sweep", heading->swept, heading->swept_n);
  ph_write_key_raw(&w, "meta", echo->meta, echo->meta_n);
  ph_write_end(&w, '}');
  ph_write_key(&w, "geometry");
  if (empty) {
    ph_buf_puts(buf, "null");
  } else {
    ph_write_begin(&w, '{');
    if (o) {
      write_offset(&w, r, o, room);
    } else {
      write_curve(&w, r, room);
    }
    ph_write_end(&w, '}');
  }
  ph_write_end(&w, '}');
}

/* Room for the largest of them, before the first byte; false: memory is
 * exhausted. */
static bool reserve(struct room *room, const struct ph_result *r) {
  size_t loops = 0, samples = r->samples.n;
  for (size_t i = 0; i < r->offsets_n; i++) {
    const struct ph_offset *o = &r->offsets[i];
    loops = o->loops.n > loops ? o->loops.n : loops;
    samples = o->samples.n > samples ? o->samples.n : samples;
    for (size_t j = 0; j < o->loops.n; j++) {
      const size_t n = o->loops.v[j].samples.n;
      samples = n > samples ? n : samples;
    }
  }
  room->nest = ph_malloc(loops * sizeof *room->nest);
  room->at = ph_malloc((samples / PH_RELAY_CHUNK + 1) * sizeof *room->at);
  return room->nest && room->at;
}

void ph_geojson_out(struct ph_buf *buf, const struct ph_heading *heading,
                    const struct ph_result *result) {
  struct room room;
  if (reserve(&room, result)) {
    write_feature(buf, heading, result, NULL, &room);
    for (size_t i = 0; i < result->offsets_n; i++) {
      write_feature(buf, heading, result, &result->offsets[i], &room);
    }
  } else {
    buf->failed = true;
  }
  ph_free(room.at);
  ph_free(room.nest);
}
