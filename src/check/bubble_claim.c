/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Samples of a surface of patches, on it and beside it, and its edges, as a
 * record has them (see bubble.h).
 *
 * The side of normals is that of the samples: the control points do not know
 * which one is meant.
 */
#include "check/bubble_exact.h"
#include "kernel/bern.h"

#include <stdlib.h>

enum { MOST = PH_CHECK_PATCH_MOST };

/* Of unit vectors, and of what is computed from few numbers. */
static const double UNIT = 64 * DBL_EPSILON;

/* Derivatives that are known to less than this part say nothing. */
static const double VAGUE = 1e-3;

/* The basis at u, and derivatives: those of a polynomial of degree n are the
 * differences of its coefficients in the basis of degree n - 1. */
static void set_rows(size_t degree, double u, double rows[3][MOST]) {
  for (size_t j = 0; j < 3; j++) {
    double *row = rows[j], factor = 1;
    for (size_t i = 0; i <= degree; i++) {
      row[i] = 0;
    }
    if (j > degree) {
      continue;
    }
    ph_bern_basis(degree - j, u, row);
    for (size_t k = 0; k < j; k++) {
      const size_t n = degree - j + 1 + k; /* coefficients, and one more */
      factor *= (double)(degree - k);
      row[n] = 0;
      for (size_t i = n + 1; i-- > 0;) {
        row[i] = (i > 0 ? row[i - 1] : 0) - (i < n ? row[i] : 0);
      }
    }
    for (size_t i = 0; i <= degree; i++) {
      row[i] *= factor;
    }
  }
}

static void set_place(const struct ph_check *v, const struct ph_patch *p,
                      double at_u, double at_v, struct ph_check_place *place) {
  const size_t width = p->bidegree[0] + 1, high = p->bidegree[1] + 1;
  double by_u[3][MOST], by_v[3][MOST];
  set_rows(width - 1, at_u, by_u);
  set_rows(high - 1, at_v, by_v);
  for (size_t a = 0; a < 3; a++) {
    for (size_t b = 0; a + b < 3; b++) {
      ph_vec3 sum = ph_vec3_of(0, 0, 0);
      for (size_t k = 0; k < high; k++) {
        for (size_t i = 0; i < width; i++) {
          const double *c = p->control_points + 3 * (width * k + i);
          sum = ph_vec3_along(sum, by_u[a][i] * by_v[b][k],
                              ph_check_vector(v, c, 3));
        }
      }
      place->x[a][b] = sum;
    }
  }
}

/* The principal curvatures towards a normal. */
static void set_curvatures(const struct ph_check_place *at, ph_vec3 normal,
                           double k[2]) {
  const double x = ph_vec3_abs(at->x[1][0]);
  const ph_vec3 a = ph_vec3_scale(1 / x, at->x[1][0]);
  const ph_vec3 b = ph_vec3_cross(normal, a);
  const double y = ph_vec3_dot(at->x[0][1], a);
  const double z = ph_vec3_dot(at->x[0][1], b);
  const double l = ph_vec3_dot(at->x[2][0], normal) / x / x;
  const double m = (ph_vec3_dot(at->x[1][1], normal) / x - y * l) / z;
  const double n =
      (ph_vec3_dot(at->x[0][2], normal) - 2 * y * (m * z + y * l) + y * y * l) /
      z / z;
  const double half = hypot((l - n) / 2, m);
  k[0] = (l + n) / 2 + half;
  k[1] = (l + n) / 2 - half;
}

/* Curvatures as they are told, to what they are known; NaN where they are left
 * out. */
static void check_curvatures(struct ph_check *v, size_t i,
                             const struct ph_patch_sample *s,
                             const double found[2], double noise) {
  const double size =
      ph_check_larger(fabs(found[0]), fabs(found[1])) + 1 / v->scale.size;
  const double told[2] = {ph_check_unscaled(v, s->principal[0]),
                          ph_check_unscaled(v, s->principal[1])};
  const double mean = ph_check_unscaled(v, s->mean);
  const double gauss = ph_check_unscaled(v, ph_check_unscaled(v, s->gauss));
  const double most = ph_check_scaled(v, ph_check_scaled(v, size * size));
  /* of large surfaces curvatures may be subnormal, and their products */
  const double least = ph_check_unscaled(v, DBL_TRUE_MIN);
  if (!(noise <= VAGUE * size)) {
    return;
  }
  noise += least;
  for (size_t j = 0; j < 2; j++) {
    ph_check_miss(v, PH_CHECK_SAMPLE, ph_check_of("samples", i, "principal"),
                  fabs(told[j] - found[j]), size, noise + UNIT * size,
                  "are not the principal curvatures");
  }
  ph_check_miss(v, PH_CHECK_SAMPLE, ph_check_of("samples", i, "mean"),
                fabs(mean - (found[0] + found[1]) / 2), size,
                noise + UNIT * size, "is not the mean curvature");
  if (isnan(gauss) && !isfinite(most)) { /* of small ones beyond all numbers */
    return;
  }
  ph_check_miss(v, PH_CHECK_SAMPLE, ph_check_of("samples", i, "gauss"),
                fabs(gauss - found[0] * found[1]), size * size,
                2 * size * noise + UNIT * size * size +
                    ph_check_unscaled(v, least),
                "is not the Gauss curvature");
}

static void check_sample(const struct ph_check_patchwork *w, size_t i,
                         const struct ph_patch_sample *s,
                         const struct ph_check_quotient *quotient,
                         double distance) {
  struct ph_check *v = w->v;
  const struct ph_patch *p = &w->curve->surface.patches[s->patch];
  const double far = ph_check_scaled(v, distance);
  const double degree =
      quotient ? PH_CHECK_LIKE : (double)(p->bidegree[0] + p->bidegree[1]);
  const double round = 64 * v->scale.rounding;
  const ph_vec3 told = ph_vec3_get(s->normal, 3);
  struct ph_check_place at;
  ph_vec3 normal;
  double area, across, doubt, k[2], least = 1;
  if (quotient) {
    ph_check_quotient_place(quotient, s->u, s->v, &at);
  } else {
    set_place(v, p, s->u, s->v, &at);
  }
  normal = ph_vec3_cross(at.x[1][0], at.x[0][1]);
  area = ph_vec3_abs(normal);
  across = ph_check_smaller(area / ph_vec3_abs(at.x[1][0]),
                            area / ph_vec3_abs(at.x[0][1]));
  doubt = 2 * degree * round / across;
  if (!(doubt <= VAGUE)) { /* what is told of it, is a limit */
    return;
  }
  normal =
      ph_vec3_scale((ph_vec3_dot(normal, told) < 0 ? -1 : 1) / area, normal);
  set_curvatures(&at, normal, k);
  for (size_t j = 0; j < 2; j++) {
    const double factor = 1 - far * k[j];
    k[j] /= factor;
    least = ph_check_smaller(least, fabs(factor));
  }
  if (k[0] < k[1]) {
    const double larger = k[1];
    k[1] = k[0];
    k[0] = larger;
  }
  ph_check_miss(v, PH_CHECK_SAMPLE, ph_check_of("samples", i, "point"),
                ph_check_apart(ph_check_vector(v, s->point, 3),
                               ph_vec3_along(at.x[0][0], far, normal)),
                v->scale.size, round + fabs(far) * (doubt + UNIT),
                "is off the surface");
  ph_check_miss(v, PH_CHECK_SAMPLE, ph_check_of("samples", i, "normal"),
                ph_check_apart(told, normal), 1, doubt + UNIT,
                "is not the normal");
  if (isfinite(s->mean)) {
    check_curvatures(v, i, s, k,
                     (4 * degree * degree * round / (across * across) +
                      8 * doubt * ph_check_larger(fabs(k[0]), fabs(k[1]))) /
                         (least * least));
  }
}

static void check_samples(const struct ph_check_patchwork *w,
                          const struct ph_patch_samples *grid,
                          double distance) {
  struct ph_check_quotient quotient;
  size_t patch = PH_NO_SEGMENT; /* that it is of */
  for (size_t i = 0; i < grid->n && !ph_arena_late(w->v->scratch); i++) {
    const struct ph_patch_sample *s = &grid->v[i];
    if (s->patch >= w->curve->n || !(s->u >= 0 && s->u <= 1) ||
        !(s->v >= 0 && s->v <= 1)) {
      ph_check_wrong(w->v, PH_CHECK_SAMPLE, ph_check_of("samples", i, "patch"),
                     "has no such place");
      return;
    }
    if (w->edges && s->patch != patch) {
      patch = s->patch;
      ph_check_quotient_begin(w, patch, &quotient);
    }
    check_sample(w, i, s, w->edges ? &quotient : NULL, distance);
  }
}

/* ---- edges --------------------------------------------------------------- */

static int by_points(const void *left, const void *right) {
  const struct ph_check_seam *a = left, *b = right;
  return a->low != b->low ? (a->low > b->low) - (a->low < b->low)
                          : (a->high > b->high) - (a->high < b->high);
}

static void check_edges(const struct ph_check_patchwork *w,
                        const struct ph_patch_edges *edges) {
  static const char *const names[] = {"normal_jump", "curvature_jump"};
  for (size_t i = 0; i < edges->n; i++) {
    const struct ph_patch_edge *e = &edges->v[i];
    const struct ph_check_seam key = {.low = e->vertices[0],
                                      .high = e->vertices[1]};
    const struct ph_check_seam *seam =
        bsearch(&key, w->seams, w->seams_n, sizeof key, by_points);
    const double told[] = {e->normal_jump, e->curvature_jump};
    if (!seam != (e->faces_n != 2)) {
      ph_check_wrong(w->v, PH_CHECK_DIAGNOSTIC, ph_check_of("edges", i, NULL),
                     "is not such an edge");
      return;
    }
    for (size_t j = 0; seam && j < 2; j++) {
      ph_check_number(
          w->v, PH_CHECK_DIAGNOSTIC, ph_check_of("edges", i, names[j]), told[j],
          seam->value[j], 1 + seam->value[j], 2 * seam->noise[j] + UNIT);
    }
  }
}

void ph_check_patch_claim(struct ph_check_patchwork *w) {
  const struct ph_result *claim = w->v->claim;
  check_samples(w, &claim->places, 0);
  check_edges(w, &w->curve->surface.edges);
  for (size_t i = 0; i < claim->parallels_n; i++) {
    ph_check_prefix(w->v, "offsets", i);
    check_samples(w, &claim->parallels[i].places, claim->parallels[i].distance);
  }
  ph_check_prefix(w->v, NULL, 0);
}
