/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Meshes (see obj_out.h). */
#include "io/obj_out.h"

#include "io/number.h"

#include <math.h>

/* One object. */
struct mesh {
  struct ph_buf *buf;
  const struct ph_surface_samples *grid;
  size_t along, across; /* steps of each strip */
  size_t strips;
  bool closed;
  size_t before, before_flat; /* points of the objects before */
  bool first;
};

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

static size_t rulings(const struct mesh *m) {
  return m->strips * m->along + 1;
}

/* Rulings that are points of their own: the last one of a closed surface is the
 * first again, but not in the development. */
static size_t distinct(const struct mesh *m) {
  return rulings(m) - (m->closed ? 1 : 0);
}

/* The samples of a ruling: that which two strips share is the start of the
 * second, but at the end. */
static const struct ph_surface_sample *ruling(const struct mesh *m, size_t r) {
  const size_t strip = r / m->along < m->strips ? r / m->along : m->strips - 1;
  return m->grid->v +
         (strip * (m->along + 1) + r - strip * m->along) * (m->across + 1);
}

static void write_points(const struct mesh *m) {
  for (size_t r = 0; r < distinct(m); r++) {
    for (size_t j = 0; j <= m->across; j++) {
      line(m->buf, "v", ruling(m, r)[j].point, 3);
    }
  }
  for (size_t r = 0; r < rulings(m); r++) {
    for (size_t j = 0; j <= m->across; j++) {
      line(m->buf, "vt", ruling(m, r)[j].flat, 2);
    }
  }
  for (size_t r = 0; r < distinct(m); r++) {
    line(m->buf, "vn", ruling(m, r)->normal, 3);
  }
}

/* Number i of n, of which there are others before. */
static void index_of(const struct mesh *m, char before, size_t i, size_t n,
                     size_t others) {
  const double at = m->first ? (double)(others + i + 1) : (double)i - (double)n;
  char *to = ph_buf_reserve(m->buf, PH_NUMBER_MAX + 1);
  if (to) {
    *to = before;
    m->buf->n += 1 + ph_number_write(to + 1, at);
  }
}

static void corner(const struct mesh *m, size_t r, size_t j) {
  const size_t each = m->across + 1, own = r < distinct(m) ? r : 0;
  index_of(m, ' ', own * each + j, distinct(m) * each, m->before * each);
  index_of(m, '/', r * each + j, rulings(m) * each, m->before_flat * each);
  index_of(m, '/', own, distinct(m), m->before);
}

static void write_faces(const struct mesh *m) {
  for (size_t r = 0; r + 1 < rulings(m); r++) {
    for (size_t j = 0; j < m->across; j++) {
      ph_buf_puts(m->buf, "f");
      corner(m, r, j);
      corner(m, r, j + 1);
      corner(m, r + 1, j + 1);
      corner(m, r + 1, j);
      ph_buf_puts(m->buf, "\n");
    }
  }
}

/* The steps of a grid, which knows them no more. */
static void measure(struct mesh *m) {
  const struct ph_surface_sample *v = m->grid->v;
  size_t across = 0;
  while (across + 1 < m->grid->n && !(v[across + 1].s > v[across].s) &&
         v[across + 1].strip == v[0].strip) {
    across++;
  }
  m->across = across;
  m->along = m->grid->n / m->strips / (across + 1) - 1;
}

void ph_obj_out(struct ph_buf *buf, const char *id, bool first,
                const struct ph_result *result) {
  struct mesh m = {.buf = buf,
                   .strips = result->curve.n,
                   .closed = result->curve.closed,
                   .first = first};
  for (size_t i = 0; i <= result->parallels_n; i++) {
    const struct ph_parallel *p = i ? &result->parallels[i - 1] : NULL;
    m.grid = p ? &p->grid : &result->grid;
    measure(&m);
    ph_buf_puts(buf, "o ");
    name(buf, id);
    if (p) {
      char *to = ph_buf_reserve(buf, PH_NUMBER_MAX + 1);
      if (to) {
        *to = '@';
        buf->n += 1 + ph_number_write(to + 1, p->distance);
      }
    }
    ph_buf_puts(buf, "\n");
    write_points(&m);
    write_faces(&m);
    m.before += distinct(&m);
    m.before_flat += rulings(&m);
  }
}
