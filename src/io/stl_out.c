/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Binary STL (see stl_out.h). */
#include "io/stl_out.h"

#include <float.h>
#include <math.h>
#include <stdint.h>
#include <string.h>

static const char title[80] = "phspline: triangles of a surface";

static void put32(struct ph_buf *buf, uint32_t x) {
  const char bytes[] = {(char)(x & 255), (char)(x >> 8 & 255),
                        (char)(x >> 16 & 255), (char)(x >> 24 & 255)};
  ph_buf_put(buf, bytes, sizeof bytes);
}

static void put_vector(struct ph_buf *buf, const float *v) {
  for (size_t j = 0; j < 3; j++) {
    uint32_t bits;
    memcpy(&bits, &v[j], sizeof bits);
    put32(buf, bits);
  }
}

/* The normal of a triangle as it is written; 0 where it has none. */
static void set_normal(const float p[3][3], float *normal) {
  double a[3], b[3], c[3], size = 0, most = 0;
  for (size_t j = 0; j < 3; j++) {
    a[j] = (double)p[1][j] - (double)p[0][j];
    b[j] = (double)p[2][j] - (double)p[0][j];
    most = fmax(most, fmax(fabs(a[j]), fabs(b[j])));
  }
  for (size_t j = 0; j < 3; j++) { /* floats squared may be too small */
    a[j] /= most;
    b[j] /= most;
  }
  for (size_t j = 0; j < 3; j++) {
    const size_t k = (j + 1) % 3, l = (j + 2) % 3;
    c[j] = a[k] * b[l] - a[l] * b[k];
    size = hypot(size, c[j]);
  }
  for (size_t j = 0; j < 3; j++) {
    normal[j] = size > 0 ? (float)(c[j] / size) : 0;
  }
}

static void triangle(struct ph_buf *buf, const struct ph_tiling *t,
                     const struct ph_tile_corner *tile, size_t a, size_t b,
                     size_t c) {
  const size_t corner[] = {tile[a].point, tile[b].point, tile[c].point};
  const char attribute[2] = {0, 0};
  float p[3][3], normal[3];
  for (size_t i = 0; i < 3; i++) {
    for (size_t j = 0; j < 3; j++) {
      p[i][j] = (float)t->points[corner[i]][j];
    }
  }
  set_normal((const float(*)[3])p, normal);
  put_vector(buf, normal);
  for (size_t i = 0; i < 3; i++) {
    put_vector(buf, p[i]);
  }
  ph_buf_put(buf, attribute, sizeof attribute);
}

static double distance(const double *a, const double *b) {
  return hypot(hypot(a[0] - b[0], a[1] - b[1]), a[2] - b[2]);
}

static size_t triangles_of(const struct ph_tiling *tilings, size_t n) {
  size_t sum = 0;
  for (size_t i = 0; i < n; i++) {
    sum += 2 * tilings[i].tiles_n;
  }
  return sum;
}

bool ph_stl_fits(const struct ph_tiling *tilings, size_t n) {
  bool fits = triangles_of(tilings, n) <= UINT32_MAX;
  for (const struct ph_tiling *t = tilings; t < tilings + n; t++) {
    for (size_t i = 0; i < 3 * t->points_n; i++) {
      fits = fits && fabs(t->points[i / 3][i % 3]) <= (double)FLT_MAX;
    }
  }
  return fits;
}

void ph_stl_out(struct ph_buf *buf, const struct ph_tiling *tilings, size_t n) {
  ph_buf_put(buf, title, sizeof title);
  put32(buf, (uint32_t)triangles_of(tilings, n));
  for (const struct ph_tiling *t = tilings; t < tilings + n; t++) {
    for (size_t i = 0; i < t->tiles_n; i++) {
      const struct ph_tile_corner *c = t->tiles[i];
      const size_t cut =
          distance(t->points[c[0].point], t->points[c[2].point]) <=
                  distance(t->points[c[1].point], t->points[c[3].point])
              ? 0
              : 1;
      triangle(buf, t, c, cut, cut + 1, cut + 2);
      triangle(buf, t, c, cut, cut + 2, (cut + 3) % 4);
    }
  }
}
