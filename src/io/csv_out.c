/* SPDX-License-Identifier: GPL-3.0-or-later */
/* CSV tables (see csv_out.h): one function a table, one writer of rows. */
#include "io/csv_out.h"

#include "base/mem.h"
#include "base/relay.h"
#include "base/sum.h"
#include "curve/offset/gap.h"
#include "io/csv_cell.h"

#include <math.h>
#include <string.h>

/* Columns between `id` and the swept fields.  Curves differ in what is known of
 * a place on them; NULL: there is no such table. */
static const char *const columns[PH_TABLE_N][PH_SPACES] = {
    [PH_TABLE_CONTROL_POINTS] = {",segment,index,x,y", ",segment,index,x,y,z",
                                 ",segment,index,x,y,z"},
    [PH_TABLE_LENGTHS] = {",segment,t0,t1,length,cumulative",
                          ",segment,t0,t1,length,cumulative",
                          ",segment,t0,t1,length,cumulative"},
    [PH_TABLE_SAMPLES] = {",segment,t,s,x,y,tx,ty,curvature",
                          ",segment,t,s,x,y,z,tx,ty,tz,curvature,torsion",
                          ",segment,t,s,x,y,z,tx,ty,tz,curvature,lon,lat",
                          ",strip,s,h,x,y,z,nx,ny,nz,u,v",
                          ",patch,u,v,x,y,z,nx,ny,nz,gauss,mean,k1,k2"},
    [PH_TABLE_OFFSETS] =
        {",distance,segment,index,x,y,weight",
         ",distance,segment,index,x,y,z,weight,vector",
         ",distance,segment,t,s,x,y,z,tx,ty,tz,curvature,lon,lat"},
    [PH_TABLE_STRIPS] = {NULL, NULL, NULL,
                         ",strip,pair,x,y,z,rx,ry,rz,tx,ty,tz,nx,ny,nz,"
                         "geodesic_curvature,normal_curvature,length,vx,vy,vz,"
                         "half_angle,sweep,development_angle"},
    [PH_TABLE_PATCHES] = {NULL, NULL, NULL, NULL, ",patch,row,column,x,y,z"},
    [PH_TABLE_EDGES] = {NULL, NULL, NULL, NULL,
                        ",edge,vertex0,vertex1,face0,face1,normal_jump,"
                        "curvature_jump"},
    [PH_TABLE_DEVELOPMENT] = {NULL, NULL, NULL, ",strip,index,u,v,weight"},
    [PH_TABLE_LOCATED] = {NULL, NULL, NULL,
                          ",index,strip,s,h,x,y,z,nx,ny,nz,u,v"},
};

bool ph_csv_has(enum ph_table table, enum ph_space space) {
  return columns[table][space] != NULL;
}

/* Before row or piece number i, of a segment, of the offset that is not NULL:
 * after a gap it begins a part. */
static void end_part(const struct ph_csv_row *row, const struct ph_offset *o,
                     size_t segment, size_t i, size_t *gap) {
  if (o && ph_gaps_pass(&o->gaps, segment, gap) && i > 0) {
    ph_csv_end_curve(row);
  }
}

/* Gaps before row or piece number i of such an offset. */
static size_t begin_parts(const struct ph_offset *o, const size_t *segment,
                          size_t i) {
  size_t gap = 0;
  if (o && i > 0) {
    ph_gaps_pass(&o->gaps, segment[i - 1], &gap);
  }
  return gap;
}

/* Names in one list, separated by commas. */
static void names(const struct ph_csv_row *row, const char *list) {
  for (; *list; list++) {
    if (*list == ',') {
      ph_csv_between(row);
    } else {
      ph_buf_put(row->buf, list, 1);
    }
  }
}

void ph_csv_header(struct ph_buf *buf, const struct ph_csv_shape *shape,
                   const struct ph_swept *swept, size_t swept_n) {
  const struct ph_csv_row row = ph_csv_row_of(buf, shape, NULL);
  const bool samples =
      shape->table == PH_TABLE_SAMPLES || shape->space == PH_SURFACE;
  ph_buf_puts(buf, shape->text ? "# id" : "id");
  names(&row, columns[shape->table][shape->space]);
  if (samples && shape->frame) {
    names(&row, ",nx,ny,nz,bx,by,bz");
  }
  if (samples && shape->offsets) {
    names(&row, shape->space == PH_SPACE ? ",distance,vector" : ",distance");
  }
  if (shape->loops && (samples || shape->table == PH_TABLE_OFFSETS)) {
    names(&row, samples ? ",loop" : ",loop,piece");
  }
  for (size_t i = 0; i < swept_n; i++) {
    ph_csv_between(&row);
    ph_csv_text_cell(&row, swept[i].name, strlen(swept[i].name));
  }
  names(&row, shape->file ? ",file" : "");
  ph_buf_put(buf, "\n", 1);
}

/* A row of so many that they have a relay. */
struct rows {
  const struct ph_csv_row *row;
  const struct ph_curve *curve;
  const struct ph_samples *samples;
  const struct ph_offset *offset; /* that they are of, or NULL */
  const struct ph_pieces *pieces; /* of it */
  double loop;                    /* of it */
  const struct ph_sum *sums;      /* of lengths before each chunk */
};

static void some_control_points(void *context, struct ph_buf *to, size_t first,
                                size_t end) {
  const struct rows *rows = context;
  const struct ph_curve *c = rows->curve;
  const struct ph_csv_row row =
      ph_csv_row_of(to, rows->row->shape, rows->row->heading);
  for (size_t k = first; k < end; k++) {
    const double *p = ph_curve_points(c, k);
    for (size_t i = 0; i <= c->degree; i++) {
      ph_csv_begin_row(&row);
      ph_csv_number_cell(&row, (double)k);
      ph_csv_number_cell(&row, (double)i);
      ph_csv_number_cells(&row, p, c->dimension);
      p += c->dimension;
      ph_csv_end_row(&row);
    }
  }
}

static void control_points(const struct ph_csv_row *row,
                           const struct ph_curve *c) {
  struct rows rows = {.row = row, .curve = c};
  ph_relay(row->buf, c->n, some_control_points, &rows);
}

static void some_lengths(void *context, struct ph_buf *to, size_t first,
                         size_t end) {
  const struct rows *rows = context;
  const struct ph_curve *c = rows->curve;
  struct ph_sum cumulative = rows->sums[first / PH_RELAY_CHUNK];
  const struct ph_csv_row row =
      ph_csv_row_of(to, rows->row->shape, rows->row->heading);
  for (size_t k = first; k < end; k++) {
    ph_sum_add(&cumulative, c->lengths[k]);
    ph_csv_begin_row(&row);
    ph_csv_number_cell(&row, (double)k);
    ph_csv_number_cells(&row, c->knots + k, 2);
    ph_csv_number_cell(&row, c->lengths[k]);
    ph_csv_number_cell(&row, ph_sum_value(&cumulative));
    ph_csv_end_row(&row);
  }
}

static void lengths(const struct ph_csv_row *row, const struct ph_curve *c) {
  struct ph_sum *sums = ph_malloc((c->n / PH_RELAY_CHUNK + 1) * sizeof *sums),
                sum = {0, 0};
  struct rows rows = {.row = row, .curve = c, .sums = sums};
  if (!sums) {
    row->buf->failed = true;
    return;
  }
  for (size_t k = 0; k < c->n; k++) {
    if (k % PH_RELAY_CHUNK == 0) {
      sums[k / PH_RELAY_CHUNK] = sum;
    }
    ph_sum_add(&sum, c->lengths[k]);
  }
  ph_relay(row->buf, c->n, some_lengths, &rows);
  ph_free(sums);
}

/* What all tables of samples say of a place. */
static void place_cells(const struct ph_csv_row *row,
                        const struct ph_samples *s, size_t i) {
  size_t d = s->dimension;
  ph_csv_number_cell(row, (double)s->segment[i]);
  ph_csv_number_cell(row, s->t[i]);
  ph_csv_number_cell(row, s->s[i]);
  ph_csv_number_cells(row, s->point + d * i, d);
  ph_csv_number_cells(row, s->tangent + d * i, d);
  ph_csv_number_cell(row, s->curvature[i]);
  if (s->torsion) {
    ph_csv_number_cell(row, s->torsion[i]);
  }
  if (s->lonlat) {
    ph_csv_number_cells(row, s->lonlat + 2 * i, 2);
  }
}

static void vector_cell(const struct ph_csv_row *row, const char *vector) {
  if (row->shape->binary) {
    ph_csv_number_cell(row, vector ? (double)(vector[1] - '0') : (double)NAN);
    return;
  }
  ph_csv_between(row);
  ph_buf_puts(row->buf, vector ? vector : row->shape->text ? "-" : "");
}

/* What is said of a place in the table of samples alone. */
static void asked_cells(const struct ph_csv_row *row, const struct rows *rows,
                        size_t i) {
  static const double none[] = {(double)NAN, (double)NAN, (double)NAN};
  const struct ph_samples *s = rows->samples;
  const struct ph_offset *o = rows->offset;
  if (row->shape->frame) {
    ph_csv_number_cells(row, s->normal ? s->normal + 3 * i : none, 3);
    ph_csv_number_cells(row, s->binormal ? s->binormal + 3 * i : none, 3);
  }
  if (row->shape->offsets) {
    ph_csv_number_cell(row, o ? o->distance : 0);
    if (row->shape->space == PH_SPACE) {
      vector_cell(row, o ? o->vector : NULL);
    }
  }
  if (row->shape->loops) {
    ph_csv_number_cell(row, rows->loop);
  }
}

/* In the table of offsets the distance comes first. */
static void some_samples(void *context, struct ph_buf *to, size_t first,
                         size_t end) {
  const struct rows *rows = context;
  const bool beside = rows->row->shape->table == PH_TABLE_OFFSETS;
  const struct ph_samples *s = rows->samples;
  const struct ph_offset *o = rows->offset;
  const struct ph_csv_row row =
      ph_csv_row_of(to, rows->row->shape, rows->row->heading);
  size_t gap = begin_parts(o, s->segment, first);
  for (size_t i = first; i < end; i++) {
    end_part(&row, o, s->segment[i], i, &gap);
    ph_csv_begin_row(&row);
    if (beside) {
      ph_csv_number_cell(&row, o->distance);
    }
    place_cells(&row, s, i);
    if (!beside) {
      asked_cells(&row, rows, i);
    }
    ph_csv_end_row(&row);
  }
}

/* Of the curve, or of the offset that is not NULL, or of a loop of it. */
static void samples(const struct ph_csv_row *row, const struct ph_samples *s,
                    const struct ph_offset *o, double loop) {
  struct rows rows = {.row = row, .samples = s, .offset = o, .loop = loop};
  ph_relay(row->buf, s->n, some_samples, &rows);
}

/* Of an offset. */
static void samples_beside(const struct ph_csv_row *row,
                           const struct ph_offset *o) {
  const struct ph_loops *loops = &o->loops;
  for (size_t i = 0; i < loops->n; i++) {
    ph_csv_end_curve(row);
    samples(row, &loops->v[i].samples, o, (double)i);
  }
  if (!loops->mode) {
    ph_csv_end_curve(row);
    samples(row, &o->samples, o, (double)NAN);
  }
}

/* Pieces of an offset; no weights are ones.  A segment in several pieces goes
 * on counting its points. */
static void some_pieces(void *context, struct ph_buf *to, size_t first,
                        size_t end) {
  const struct rows *rows = context;
  const struct ph_offset *o = rows->offset;
  const struct ph_pieces *pieces = rows->pieces;
  const size_t points = pieces->degree + 1;
  const double *p = pieces->control_points + first * points * pieces->dimension;
  const double *weight = o->weights ? o->weights + first * points : NULL;
  const struct ph_csv_row row =
      ph_csv_row_of(to, rows->row->shape, rows->row->heading);
  size_t index = 0, gap = begin_parts(o, pieces->segment, first);
  for (size_t i = first; i > 0 && pieces->segment[i] == pieces->segment[i - 1];
       i--) {
    index += points;
  }
  for (size_t k = first; k < end; k++) {
    end_part(&row, o, pieces->segment[k], k, &gap);
    if (k == 0 || pieces->segment[k] != pieces->segment[k - 1]) {
      index = 0;
    }
    for (size_t i = 0; i < points; i++) {
      ph_csv_begin_row(&row);
      ph_csv_number_cell(&row, o->distance);
      ph_csv_number_cell(&row, (double)pieces->segment[k]);
      ph_csv_number_cell(&row, (double)index++);
      ph_csv_number_cells(&row, p, pieces->dimension);
      p += pieces->dimension;
      ph_csv_number_cell(&row, weight ? *weight++ : 1);
      if (o->vector) {
        vector_cell(&row, o->vector);
      }
      ph_csv_end_row(&row);
    }
  }
}

/* The pieces of loops; joins are of no segment. */
static void offset_loops(const struct ph_csv_row *row,
                         const struct ph_offset *o) {
  for (size_t i = 0; i < o->loops.n; i++) {
    const struct ph_loop *loop = &o->loops.v[i];
    if (i > 0) {
      ph_csv_end_curve(row);
    }
    for (size_t k = 0; k < loop->n; k++) {
      const struct ph_loop_piece *piece = &loop->pieces[k];
      const bool join = piece->segment == PH_NO_SEGMENT;
      for (size_t j = 0; j <= o->degree; j++) {
        ph_csv_begin_row(row);
        ph_csv_number_cell(row, o->distance);
        ph_csv_number_cell(row, join ? (double)NAN : (double)piece->segment);
        ph_csv_number_cell(row, (double)j);
        ph_csv_number_cells(row, piece->control_points + 2 * j, 2);
        ph_csv_number_cell(row, piece->weights[j]);
        ph_csv_number_cell(row, (double)i);
        ph_csv_number_cell(row, (double)k);
        ph_csv_end_row(row);
      }
    }
  }
}

static void offset(const struct ph_csv_row *row, const struct ph_offset *o) {
  struct ph_pieces rational = {o->degree,   o->dimension,      o->n, o->segment,
                               o->interval, o->control_points, 0};
  struct rows rows = {
      .row = row, .offset = o, .pieces = o->weights ? &rational : &o->pieces};
  if (o->loops.mode) {
    offset_loops(row, o);
  } else if (row->shape->space == PH_SPHERE) {
    samples(row, &o->samples, o, (double)NAN);
  } else {
    ph_relay(row->buf, rows.pieces->n, some_pieces, &rows);
  }
}

/* ---- surfaces ------------------------------------------------------------ */

static void end_surface_row(const struct ph_csv_row *row, double distance) {
  if (row->shape->offsets) {
    ph_csv_number_cell(row, distance);
  }
  ph_csv_end_row(row);
}

static void strips(const struct ph_csv_row *row, const struct ph_curve *c,
                   double distance) {
  for (size_t i = 0; i < c->n; i++) {
    const struct ph_strip *strip = &c->surface.strips[i];
    ph_csv_begin_row(row);
    ph_csv_number_cell(row, (double)i);
    ph_csv_number_cell(row, (double)strip->pair);
    ph_csv_number_cells(row, strip->frame.point, 3);
    ph_csv_number_cells(row, strip->frame.ruling, 3);
    ph_csv_number_cells(row, strip->frame.tangent, 3);
    ph_csv_number_cells(row, strip->frame.normal, 3);
    ph_csv_number_cell(row, strip->k);
    ph_csv_number_cell(row, strip->kn);
    ph_csv_number_cell(row, strip->length);
    ph_csv_number_cells(row, strip->vertex, 3);
    ph_csv_number_cell(row, strip->half_angle);
    ph_csv_number_cell(row, strip->sweep);
    ph_csv_number_cell(row, strip->development_angle);
    end_surface_row(row, distance);
  }
}

static void patches(const struct ph_csv_row *row, const struct ph_curve *c) {
  for (size_t i = 0; i < c->n; i++) {
    const struct ph_patch *patch = &c->surface.patches[i];
    const size_t width = patch->bidegree[0] + 1;
    for (size_t k = 0; k < patch->points_n; k++) {
      ph_csv_begin_row(row);
      ph_csv_number_cell(row, (double)i);
      ph_csv_number_cell(row, (double)(k / width));
      ph_csv_number_cell(row, (double)(k % width));
      ph_csv_number_cells(row, patch->control_points + 3 * k, 3);
      ph_csv_end_row(row);
    }
  }
}

static void edges(const struct ph_csv_row *row,
                  const struct ph_patch_edges *list) {
  for (size_t i = 0; i < list->n; i++) {
    const struct ph_patch_edge *e = &list->v[i];
    ph_csv_begin_row(row);
    ph_csv_number_cell(row, (double)i);
    ph_csv_number_cell(row, (double)e->vertices[0]);
    ph_csv_number_cell(row, (double)e->vertices[1]);
    ph_csv_number_cell(row, (double)e->faces[0]);
    ph_csv_number_cell(row, e->faces_n > 1 ? (double)e->faces[1] : (double)NAN);
    ph_csv_number_cell(row, e->normal_jump);
    ph_csv_number_cell(row, e->curvature_jump);
    ph_csv_end_row(row);
  }
}

static void patch_samples(const struct ph_csv_row *row,
                          const struct ph_patch_samples *grid,
                          double distance) {
  for (size_t i = 0; i < grid->n; i++) {
    const struct ph_patch_sample *at = &grid->v[i];
    ph_csv_begin_row(row);
    ph_csv_number_cell(row, (double)at->patch);
    ph_csv_number_cell(row, at->u);
    ph_csv_number_cell(row, at->v);
    ph_csv_number_cells(row, at->point, 3);
    ph_csv_number_cells(row, at->normal, 3);
    ph_csv_number_cell(row, at->gauss);
    ph_csv_number_cell(row, at->mean);
    ph_csv_number_cells(row, at->principal, 2);
    end_surface_row(row, distance);
  }
}

static void development(const struct ph_csv_row *row, const struct ph_curve *c,
                        double distance) {
  for (size_t k = 0; k < c->n; k++) {
    const struct ph_arc2 *flat = &c->surface.strips[k].development;
    const size_t n = flat->samples_n ? flat->samples_n : 3;
    for (size_t i = 0; i < n; i++) {
      ph_csv_begin_row(row);
      ph_csv_number_cell(row, (double)k);
      ph_csv_number_cell(row, (double)i);
      ph_csv_number_cells(row,
                          flat->samples_n ? flat->samples[i].point
                                          : flat->control_points[i],
                          2);
      ph_csv_number_cell(row, flat->samples_n ? (double)NAN : flat->weights[i]);
      end_surface_row(row, distance);
    }
  }
}

static void node_cells(const struct ph_csv_row *row,
                       const struct ph_surface_sample *at) {
  ph_csv_number_cell(row, (double)at->strip);
  ph_csv_number_cell(row, at->s);
  ph_csv_number_cell(row, at->h);
  ph_csv_number_cells(row, at->point, 3);
  ph_csv_number_cells(row, at->normal, 3);
  ph_csv_number_cells(row, at->flat, 2);
}

static void nodes(const struct ph_csv_row *row,
                  const struct ph_surface_samples *grid, double distance) {
  for (size_t i = 0; i < grid->n; i++) {
    ph_csv_begin_row(row);
    node_cells(row, &grid->v[i]);
    end_surface_row(row, distance);
  }
}

static void located(const struct ph_csv_row *row,
                    const struct ph_located_list *list) {
  for (size_t i = 0; i < list->n; i++) {
    ph_csv_begin_row(row);
    ph_csv_number_cell(row, (double)list->v[i].index);
    node_cells(row, &list->v[i].at);
    ph_csv_end_row(row);
  }
}

/* A surface, or one at a distance of it. */
static void surface(const struct ph_csv_row *row, const struct ph_curve *c,
                    const struct ph_surface_samples *grid, double distance) {
  switch (row->shape->table) {
  case PH_TABLE_STRIPS:
    strips(row, c, distance);
    break;
  case PH_TABLE_DEVELOPMENT:
    development(row, c, distance);
    break;
  default:
    nodes(row, grid, distance);
  }
}

static void patchworks(const struct ph_csv_row *row,
                       const struct ph_result *result) {
  patch_samples(row, &result->places, 0);
  for (size_t i = 0; i < result->parallels_n; i++) {
    const struct ph_parallel *p = &result->parallels[i];
    ph_csv_end_curve(row);
    patch_samples(row, &p->places, p->distance);
  }
}

static void surfaces(const struct ph_csv_row *row,
                     const struct ph_result *result) {
  surface(row, &result->curve, &result->grid, 0);
  for (size_t i = 0; i < result->parallels_n; i++) {
    const struct ph_parallel *p = &result->parallels[i];
    ph_csv_end_curve(row);
    surface(row, &p->curve, &p->grid, p->distance);
  }
}

/* ---- the whole ----------------------------------------------------------- */

void ph_csv_result(struct ph_buf *buf, const struct ph_csv_shape *shape,
                   const struct ph_csv_heading *heading,
                   const struct ph_result *result) {
  const struct ph_csv_row row = ph_csv_row_of(buf, shape, heading);
  switch (shape->table) {
  case PH_TABLE_CONTROL_POINTS:
    control_points(&row, &result->curve);
    break;
  case PH_TABLE_LENGTHS:
    lengths(&row, &result->curve);
    break;
  case PH_TABLE_STRIPS:
  case PH_TABLE_DEVELOPMENT:
    surfaces(&row, result);
    break;
  case PH_TABLE_LOCATED:
    located(&row, &result->located);
    break;
  case PH_TABLE_PATCHES:
    patches(&row, &result->curve);
    break;
  case PH_TABLE_EDGES:
    edges(&row, &result->curve.surface.edges);
    break;
  case PH_TABLE_SAMPLES:
    if (shape->space == PH_SURFACE) {
      surfaces(&row, result);
      break;
    }
    if (shape->space == PH_PATCHWORK) {
      patchworks(&row, result);
      break;
    }
    samples(&row, &result->samples, NULL, (double)NAN);
    for (size_t i = 0; i < result->offsets_n; i++) {
      samples_beside(&row, &result->offsets[i]);
    }
    break;
  case PH_TABLE_OFFSETS:
    for (size_t i = 0; i < result->offsets_n; i++) {
      if (i > 0) {
        ph_csv_end_curve(&row);
      }
      offset(&row, &result->offsets[i]);
    }
    break;
  case PH_TABLE_N:
    break;
  }
  ph_csv_end_curve(&row);
  ph_csv_end_curve(&row);
}
