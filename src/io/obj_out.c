/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Meshes (see obj_out.h). */
#include "io/obj_out.h"

#include "io/number.h"

static void line(struct ph_buf *buf, const char *what, const double *v,
                 size_t n) {
  ph_buf_puts(buf, what);
  for (size_t i = 0; i < n; i++) {
    char *to = ph_buf_reserve(buf, PH_NUMBER_MAX + 1);
    if (to) {
      *to = ' ';
      buf->n += 1 + ph_number_write(to + 1, v[i]);
    }
  }
  ph_buf_puts(buf, "\n");
}

/* Blanks would end a name. */
static void name(struct ph_buf *buf, const char *id) {
  for (; *id; id++) {
    ph_buf_put(buf, (unsigned char)*id <= ' ' ? "_" : id, 1);
  }
}

/* How many numbers the meshes before have. */
struct before {
  bool first;
  size_t points, flats, normals;
};

static void number(struct ph_buf *buf, const char *before, double x) {
  char *to;
  ph_buf_puts(buf, before);
  to = ph_buf_reserve(buf, PH_NUMBER_MAX);
  if (to) {
    buf->n += ph_number_write(to, x);
  }
}

/* Number i of n, of which there are others before. */
static void index_of(struct ph_buf *buf, const char *between, size_t i,
                     size_t n, bool first, size_t others) {
  number(buf, between,
         first ? (double)(others + i + 1) : (double)i - (double)n);
}

static void write_faces(struct ph_buf *buf, const struct ph_tiling *t,
                        const struct before *before) {
  const bool first = before->first;
  for (size_t i = 0; i < t->tiles_n; i++) {
    ph_buf_puts(buf, "f");
    for (size_t k = 0; k < 4; k++) {
      const struct ph_tile_corner *c = &t->tiles[i][k];
      index_of(buf, " ", c->point, t->points_n, first, before->points);
      if (t->flats_n) {
        index_of(buf, "/", c->flat, t->flats_n, first, before->flats);
      }
      index_of(buf, t->flats_n ? "/" : "//", c->normal, t->normals_n, first,
               before->normals);
    }
    ph_buf_puts(buf, "\n");
  }
}

void ph_obj_out(struct ph_buf *buf, const char *id, bool first,
                const struct ph_tiling *tilings, size_t n) {
  struct before before = {.first = first};
  for (const struct ph_tiling *t = tilings; t < tilings + n; t++) {
    ph_buf_puts(buf, "o ");
    name(buf, id);
    if (t > tilings) {
      number(buf, "@", t->distance);
    }
    ph_buf_puts(buf, "\n");
    for (size_t i = 0; i < t->points_n; i++) {
      line(buf, "v", t->points[i], 3);
    }
    for (size_t i = 0; i < t->flats_n; i++) {
      line(buf, "vt", t->flats[i], 2);
    }
    for (size_t i = 0; i < t->normals_n; i++) {
      line(buf, "vn", t->normals[i], 3);
    }
    write_faces(buf, t, &before);
    before.points += t->points_n;
    before.flats += t->flats_n;
    before.normals += t->normals_n;
  }
}
