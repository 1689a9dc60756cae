/* SPDX-License-Identifier: GPL-3.0-or-later */
/* CSV tables (see csv_out.h): one function a table, one writer of rows. */
#include "io/csv_out.h"

#include "base/sum.h"
#include "io/number.h"

#include <math.h>
#include <string.h>

/* Curves differ in what is known of a place on them. */
enum space { PLANE, SPACE, SPHERE, SPACES };

/* Columns between `id` and the swept fields. */
static const char *const columns[PH_TABLE_N][SPACES] = {
    [PH_TABLE_CONTROL_POINTS] = {",segment,index,x,y", ",segment,index,x,y,z",
                                 ",segment,index,x,y,z"},
    [PH_TABLE_LENGTHS] = {",segment,t0,t1,length,cumulative",
                          ",segment,t0,t1,length,cumulative",
                          ",segment,t0,t1,length,cumulative"},
    [PH_TABLE_SAMPLES] = {",segment,t,s,x,y,tx,ty,curvature",
                          ",segment,t,s,x,y,z,tx,ty,tz,curvature,torsion",
                          ",segment,t,s,x,y,z,tx,ty,tz,curvature,lon,lat"},
    [PH_TABLE_OFFSETS] =
        {",distance,segment,index,x,y,weight",
         ",distance,segment,index,x,y,z,weight,vector",
         ",distance,segment,t,s,x,y,z,tx,ty,tz,curvature,lon,lat"},
};

/* A row: cells with commas before all but the first. */
struct row {
  struct ph_buf *buf;
  const struct ph_csv_heading *heading;
};

static void text_cell(struct ph_buf *buf, const char *text, size_t n) {
  bool quoted = false;
  for (size_t i = 0; i < n; i++) {
    quoted |= memchr(",\"\r\n", text[i], 4) != NULL;
  }
  if (!quoted) {
    ph_buf_put(buf, text, n);
    return;
  }
  ph_buf_put(buf, "\"", 1);
  for (size_t i = 0; i < n; i++) {
    ph_buf_put(buf, "\"", text[i] == '"');
    ph_buf_put(buf, text + i, 1);
  }
  ph_buf_put(buf, "\"", 1);
}

/* A JSON value; of a string, which holds no escapes, what it stands for. */
static void json_cell(struct ph_buf *buf, const char *json) {
  size_t n = strlen(json);
  size_t quote = *json == '"';
  text_cell(buf, json + quote, n - 2 * quote);
}

/* A number that is not finite leaves its cell empty. */
static void number_cell(struct ph_buf *buf, double x) {
  char *to = ph_buf_reserve(buf, PH_NUMBER_MAX + 1);
  if (to) {
    *to = ',';
    buf->n += 1 + (isfinite(x) ? ph_number_write(to + 1, x) : 0);
  }
}

static void number_cells(struct ph_buf *buf, const double *v, size_t n) {
  for (size_t i = 0; i < n; i++) {
    number_cell(buf, v[i]);
  }
}

static void begin_row(const struct row *row) {
  text_cell(row->buf, row->heading->id, strlen(row->heading->id));
}

static void end_row(const struct row *row) {
  for (size_t i = 0; i < row->heading->swept_n; i++) {
    ph_buf_put(row->buf, ",", 1);
    json_cell(row->buf, row->heading->swept[i].value);
  }
  ph_buf_put(row->buf, "\n", 1);
}

void ph_csv_header(struct ph_buf *buf, enum ph_table table, size_t dimension,
                   bool on_sphere, const struct ph_swept *swept,
                   size_t swept_n) {
  enum space space = on_sphere ? SPHERE : dimension == 3 ? SPACE : PLANE;
  ph_buf_puts(buf, "id");
  ph_buf_puts(buf, columns[table][space]);
  for (size_t i = 0; i < swept_n; i++) {
    ph_buf_put(buf, ",", 1);
    text_cell(buf, swept[i].name, strlen(swept[i].name));
  }
  ph_buf_put(buf, "\n", 1);
}

static void control_points(const struct row *row, const struct ph_curve *c) {
  const double *p = c->control_points;
  for (size_t k = 0; k < c->n; k++) {
    for (size_t i = 0; i <= c->degree; i++) {
      begin_row(row);
      number_cell(row->buf, (double)k);
      number_cell(row->buf, (double)i);
      number_cells(row->buf, p, c->dimension);
      p += c->dimension;
      end_row(row);
    }
  }
}

static void lengths(const struct row *row, const struct ph_curve *c) {
  struct ph_sum cumulative = {0, 0};
  for (size_t k = 0; k < c->n; k++) {
    ph_sum_add(&cumulative, c->lengths[k]);
    begin_row(row);
    number_cell(row->buf, (double)k);
    number_cell(row->buf, c->knots[k]);
    number_cell(row->buf, c->knots[k + 1]);
    number_cell(row->buf, c->lengths[k]);
    number_cell(row->buf, ph_sum_value(&cumulative));
    end_row(row);
  }
}

/* Samples of the curve, or of the offset that is not NULL. */
static void samples(const struct row *row, const struct ph_samples *s,
                    const struct ph_offset *o) {
  struct ph_buf *buf = row->buf;
  size_t d = s->dimension;
  for (size_t i = 0; i < s->n; i++) {
    begin_row(row);
    if (o) {
      number_cell(buf, o->distance);
    }
    number_cell(buf, (double)s->segment[i]);
    number_cell(buf, s->t[i]);
    number_cell(buf, s->s[i]);
    number_cells(buf, s->point + d * i, d);
    number_cells(buf, s->tangent + d * i, d);
    number_cell(buf, s->curvature[i]);
    if (s->torsion) {
      number_cell(buf, s->torsion[i]);
    }
    if (s->lonlat) {
      number_cells(buf, s->lonlat + 2 * i, 2);
    }
    end_row(row);
  }
}

/* Pieces of an offset; no weights are ones.  A segment in several pieces goes
 * on counting its points. */
static void offset_pieces(const struct row *row, const struct ph_offset *o,
                          const struct ph_pieces *pieces,
                          const double *weight) {
  const double *p = pieces->control_points;
  size_t index = 0;
  for (size_t piece = 0; piece < pieces->n; piece++) {
    if (piece == 0 || pieces->segment[piece] != pieces->segment[piece - 1]) {
      index = 0;
    }
    for (size_t i = 0; i <= pieces->degree; i++) {
      begin_row(row);
      number_cell(row->buf, o->distance);
      number_cell(row->buf, (double)pieces->segment[piece]);
      number_cell(row->buf, (double)index++);
      number_cells(row->buf, p, pieces->dimension);
      p += pieces->dimension;
      number_cell(row->buf, weight ? *weight++ : 1);
      if (o->vector) {
        ph_buf_puts(row->buf, ",");
        ph_buf_puts(row->buf, o->vector);
      }
      end_row(row);
    }
  }
}

static void offset(const struct row *row, const struct ph_offset *o) {
  struct ph_pieces rational = {o->degree,   o->dimension,      o->n, o->segment,
                               o->interval, o->control_points, 0};
  if (o->samples.n) {
    samples(row, &o->samples, o);
  } else {
    offset_pieces(row, o, o->weights ? &rational : &o->pieces, o->weights);
  }
}

void ph_csv_result(struct ph_buf *buf, enum ph_table table,
                   const struct ph_csv_heading *heading,
                   const struct ph_result *result) {
  struct row row = {buf, heading};
  switch (table) {
  case PH_TABLE_CONTROL_POINTS:
    control_points(&row, &result->curve);
    break;
  case PH_TABLE_LENGTHS:
    lengths(&row, &result->curve);
    break;
  case PH_TABLE_SAMPLES:
    samples(&row, &result->samples, NULL);
    break;
  case PH_TABLE_OFFSETS:
    for (size_t i = 0; i < result->offsets_n; i++) {
      offset(&row, &result->offsets[i]);
    }
    break;
  case PH_TABLE_N:
    break;
  }
}
