/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Places of Bezier patches (see patch.h). */
#include "curve/surface/patch.h"

#include "kernel/bern.h"

#include <string.h>

void ph_patch_rows_at(size_t degree, double at, struct ph_patch_rows *rows) {
  double dense[3 * PH_PATCH_ROW];
  const size_t order = degree < 2 ? degree : 2;
  ph_bern_taylor(degree, at, order, dense);
  memset(rows, 0, sizeof *rows);
  for (size_t j = 0; j <= order; j++) {
    for (size_t i = 0; i <= degree; i++) { /* derivatives, not Taylor's */
      rows->w[j][i] = (j == 2 ? 2 : 1) * dense[j * (degree + 1) + i];
    }
  }
}

void ph_patch_line_at(const double *points, size_t degree,
                      const struct ph_patch_rows *rows, size_t order,
                      struct ph_patch_line *line) {
  for (size_t j = 0; j <= order; j++) {
    const double *p = points;
    memset(line->c[j], 0, (degree + 1) * sizeof line->c[j][0]);
    for (size_t row = 0; row <= degree; row++) {
      const double w = rows->w[j][row];
      for (size_t i = 0; i <= degree; i++, p += 3) {
        ph_vec3 *to = &line->c[j][i];
        to->x += w * p[0];
        to->y += w * p[1];
        to->z += w * p[2];
      }
    }
  }
}

static inline ph_vec3 along(const ph_vec3 *c, const double *w, size_t degree) {
  ph_vec3 x = ph_vec3_of(0, 0, 0);
  for (size_t i = 0; i <= degree; i++) {
    x.x += w[i] * c[i].x;
    x.y += w[i] * c[i].y;
    x.z += w[i] * c[i].z;
  }
  return x;
}

void ph_patch_jet_at(const struct ph_patch_line *line, size_t degree,
                     const struct ph_patch_rows *rows, size_t order,
                     struct ph_patch_jet *jet) {
  jet->p = along(line->c[0], rows->w[0], degree);
  if (order > 0) {
    jet->u = along(line->c[0], rows->w[1], degree);
    jet->v = along(line->c[1], rows->w[0], degree);
  }
  if (order > 1) {
    jet->uu = along(line->c[0], rows->w[2], degree);
    jet->uv = along(line->c[1], rows->w[1], degree);
    jet->vv = along(line->c[2], rows->w[0], degree);
  }
}
