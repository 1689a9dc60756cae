/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Numbers on surfaces (see volume.h). */
#include "curve/surface/volume.h"

#include "base/sum.h"
#include "curve/surface/locate.h"

#include <math.h>

/* Indices this far outside of the lattice are rounding. */
static const double OUT = 1e-9;

/* A row that is missed by this part of the distance of rows is there. */
static const double LAST = 1e-6;

/* ---- lattices ------------------------------------------------------------ */

/* The number at a point, by trilinear interpolation between the eight lattice
 * points around it.  ret  whether the point is in the lattice */
static bool number_at(const struct ph_volume *volume, const double point[3],
                      double *value) {
  double part[3], sum = 0;
  size_t cell[3];
  for (size_t a = 0; a < 3; a++) {
    const double last = (double)volume->n[a] - 1;
    double x = 0;
    for (size_t j = 0; j < 3; j++) {
      x += volume->inverse[a][j] * (point[j] - volume->origin[j]);
    }
    if (!(x >= -OUT && x <= last + OUT)) {
      return false;
    }
    x = fmin(fmax(x, 0), last);
    cell[a] = (size_t)fmin(floor(x), last - 1);
    part[a] = x - (double)cell[a];
  }
  for (size_t corner = 0; corner < 8; corner++) {
    double weight = 1;
    size_t at = 0;
    for (size_t a = 3; a-- > 0;) {
      const size_t up = corner >> a & 1;
      weight *= up ? part[a] : 1 - part[a];
      at = at * volume->n[a] + cell[a] + up;
    }
    sum += weight > 0 ? weight * ph_volume_voxel(volume, at) : 0;
  }
  *value = sum;
  return true;
}

/* ---- panoramas ----------------------------------------------------------- */

static enum ph_status begin(struct ph_panorama *p,
                            const struct ph_flat_box *box, double near,
                            size_t n, size_t most, struct ph_arena *arena,
                            struct ph_diag *diag) {
  double low[2] = {HUGE_VAL, HUGE_VAL}, high[2] = {-HUGE_VAL, -HUGE_VAL};
  double size[2];
  for (size_t i = 0; i < 2 * n; i++) {
    low[i & 1] = fmin(low[i & 1], box[i / 2].low[i & 1] + near);
    high[i & 1] = fmax(high[i & 1], box[i / 2].high[i & 1] - near);
  }
  for (size_t j = 0; j < 2; j++) {
    size[j] = floor((high[j] - low[j]) * p->resolution + LAST) + 1;
  }
  if (!(size[0] * size[1] <= (double)most)) {
    return ph_fail(diag, PH_E_LIMIT, NULL,
                   "the panorama would have %.0f x %.0f points, more than the "
                   "%zu of --max-samples",
                   size[0], size[1], most);
  }
  p->width = (size_t)size[0];
  p->height = (size_t)size[1];
  p->origin[0] = low[0];
  p->origin[1] = high[1];
  p->v = ph_arena_array(arena, p->width * p->height, sizeof *p->v);
  for (size_t i = 0; p->v && i < p->width * p->height; i++) {
    p->v[i] = (double)NAN;
  }
  return p->v ? PH_OK : ph_fail_memory(diag);
}

/* The first row or column at or behind a coordinate, within what there are. */
static size_t first_at(double x, size_t most) {
  return x > 0 ? (x < (double)most ? (size_t)ceil(x) : most) : 0;
}

static void add_point(struct ph_panorama *p, const struct ph_volume *volume,
                      const struct ph_surface_sample *at, double *v) {
  p->points++;
  if (!number_at(volume, at->point, v)) {
    p->outside++;
    *v = (double)INFINITY; /* not to be looked for on another strip */
  }
}

/* All points that are on a strip, and on none before. */
static void add_strip(struct ph_panorama *p, const struct ph_curve *curve,
                      size_t i, const struct ph_flat_box *box, double near,
                      const struct ph_volume *volume) {
  const double r = p->resolution, *o = p->origin;
  const size_t right = first_at((box->high[0] - o[0]) * r + 1, p->width);
  const size_t down = first_at((o[1] - box->low[1]) * r + 1, p->height);
  for (size_t row = first_at((o[1] - box->high[1]) * r, p->height); row < down;
       row++) {
    for (size_t column = first_at((box->low[0] - o[0]) * r, p->width);
         column < right; column++) {
      double *v = &p->v[row * p->width + column];
      const double flat[] = {o[0] + (double)column / r, o[1] - (double)row / r};
      struct ph_surface_sample at;
      if (isnan(*v) && ph_strip_locate(curve, i, flat, near, &at)) {
        add_point(p, volume, &at, v);
      }
    }
  }
}

/* What is told of all points. */
static void finish(struct ph_panorama *p) {
  struct ph_sum sum = {0, 0};
  p->range[0] = p->range[1] = (double)NAN;
  for (size_t i = 0; i < p->width * p->height; i++) {
    if (isfinite(p->v[i])) {
      p->range[0] = fmin(p->range[0], p->v[i]);
      p->range[1] = fmax(p->range[1], p->v[i]);
      ph_sum_add(&sum, p->v[i]);
    } else {
      p->v[i] = (double)NAN;
    }
  }
  p->mean = p->points > p->outside
                ? ph_sum_value(&sum) / (double)(p->points - p->outside)
                : (double)NAN;
}

enum ph_status ph_panorama_of(const struct ph_curve *curve,
                              const struct ph_volume *volume, double resolution,
                              size_t most, struct ph_arena *arena,
                              struct ph_panorama *panorama,
                              struct ph_diag *diag) {
  double near;
  struct ph_flat_box *box = ph_flat_boxes(curve, arena, &near);
  enum ph_status status;
  if (!box) {
    return ph_fail_memory(diag);
  }
  *panorama = (struct ph_panorama){.resolution = resolution};
  status = begin(panorama, box, near, curve->n, most, arena, diag);
  for (size_t i = 0; status == PH_OK && i < curve->n; i++) {
    if (ph_arena_late(arena)) {
      return ph_fail_memory(diag);
    }
    add_strip(panorama, curve, i, &box[i], near, volume);
  }
  if (status == PH_OK) {
    finish(panorama);
  }
  return status;
}
