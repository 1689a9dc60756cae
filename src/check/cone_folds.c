/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Strips that fold: of two that have a ruling in common, one has the vertex of
 * its cone between the contact curve and an edge of the surface, the other has
 * not.
 */
#include "check/cone.h"

/* An edge that runs through the vertex but for this part of its distance from
 * the contact curve folds nothing. */
static const double AT_VERTEX = 1e-6;

/* Where an edge meets the first ruling of the strip `at', from the vertex of a
 * strip on, over the distance of its contact curve from there.  All are places
 * on that ruling, from the given point on.  u: 0 or 1, the end of the strip. */
static double beyond(const struct ph_surface *surface, const struct ph_strip *s,
                     size_t u, const struct ph_strip *at, size_t edge) {
  const double *height = surface->height;
  const bool bare = !(fabs(height[0]) > 0) && !(fabs(height[1]) > 0);
  double vertex = at->shift[0];
  for (size_t i = 0; i < 3; i++) {
    vertex += at->frame.ruling[i] * (s->vertex[i] - at->frame.point[i]);
  }
  return bare || !isfinite(vertex)
             ? 1
             : (vertex - height[edge]) / (vertex - s->shift[u]);
}

static bool fold(const struct ph_surface *surface, const struct ph_strip *a,
                 const struct ph_strip *b) {
  bool found = false;
  for (size_t edge = 0; edge < 2; edge++) {
    const double x = beyond(surface, a, 1, b, edge);
    const double y = beyond(surface, b, 0, b, edge);
    found = found || (x < -AT_VERTEX && y > AT_VERTEX) ||
            (x > AT_VERTEX && y < -AT_VERTEX);
  }
  return found;
}

static void check(struct ph_check *v, enum ph_diagnostic which, double found) {
  if (ph_check_known(v, which)) {
    ph_check_number(
        v, PH_CHECK_DIAGNOSTIC,
        ph_check_of("diagnostics", PH_CHECK_ONE, ph_diagnostic_name(which)),
        v->diagnostics->value[which], found, 1, 0);
  }
}

void ph_check_cone_folds(struct ph_check *v, const struct ph_curve *curve,
                         double inside) {
  const struct ph_strip *strips = curve->surface.strips;
  double folded = 0;
  for (size_t i = 0; i < curve->n; i++) {
    const size_t next = i + 1 < curve->n ? i + 1 : 0;
    folded += (next > 0 || curve->closed) &&
              fold(&curve->surface, &strips[i], &strips[next]);
  }
  check(v, PH_D_FOLDED, folded);
  check(v, PH_D_REGULAR, inside > 0 || folded > 0 ? 0 : 1);
}
