/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Images on the Blaschke cylinder (see blaschke.h).
 *
 * n = i w^2 / sigma and <n, r> are quotients over sigma.  Raised to degree 5,
 * with h the coefficients of i w^2 and p those of r, coefficient k of the
 * numerators is the sum over j + i = k of product(j, i) times h_j and
 * -<h_j, p_i>.  [BYR11, thm 18; the sums derived here]
 */
#include "curve/offset/blaschke.h"

#include "curve/offset/rational.h"

enum { POINTS = 6 };

/* What a walk over the pieces of a curve does with each. */
struct walk {
  struct ph_curve *curve; /* blaschke_n counts the pieces */
  bool fill;              /* false: only count */
};

/* <h, p> is taken relative to the first point, so that coordinates far from the
 * origin keep their digits. */
static void fill_piece(const struct ph_rational *piece,
                       struct ph_blaschke *image) {
  const size_t degree = piece->degree;
  ph_vec3 h[3], sum[POINTS] = {{0, 0, 0}};
  ph_rational_turned(PH_E2, piece->a, 2, 1, h);
  for (size_t j = 0; j < degree; j++) {
    ph_vec3 normal = ph_vec3_of(h[j].x / piece->unit, h[j].y / piece->unit, 0);
    for (size_t i = 0; i <= degree; i++) {
      ph_vec3 leg = ph_vec3_sub(piece->p[i], piece->p[0]);
      ph_vec3 term = ph_vec3_of(normal.x, normal.y, -ph_vec3_dot(normal, leg));
      sum[j + i] =
          ph_vec3_along(sum[j + i], piece->product[(degree + 1) * j + i], term);
    }
  }
  for (size_t k = 0; k < POINTS; k++) {
    double w = piece->weight[k];
    ph_vec3 at = ph_vec3_of(sum[k].x / w, sum[k].y / w, 0);
    at.z = sum[k].z / w - ph_vec3_dot(at, piece->p[0]);
    ph_vec3_put(at, 3, image->control_points[k]);
    image->weights[k] = w * piece->unit;
  }
  image->segment = piece->segment;
  image->interval[0] = piece->from;
  image->interval[1] = piece->to;
}

static void visit(void *context, const struct ph_rational *piece) {
  struct walk *walk = context;
  struct ph_curve *curve = walk->curve;
  if (walk->fill) {
    fill_piece(piece, &curve->blaschke.v[curve->blaschke.n]);
  }
  curve->blaschke.n++;
}

static bool is_finite(const struct ph_blaschke *image) {
  bool finite = true;
  for (size_t k = 0; k < POINTS; k++) {
    const double *p = image->control_points[k];
    finite = finite && isfinite(p[0]) && isfinite(p[1]) && isfinite(p[2]) &&
             isfinite(image->weights[k]);
  }
  return finite;
}

enum ph_status ph_blaschke_curve(struct ph_curve *curve, struct ph_arena *arena,
                                 struct ph_diag *diag) {
  static const char what[] = "image on the Blaschke cylinder";
  struct walk walk = {curve, false};
  enum ph_status status;
  curve->blaschke.n = 0;
  status = ph_rational_walk(curve, 0, curve->n, what, visit, &walk, diag);
  if (status != PH_OK) {
    return status;
  }
  curve->blaschke.v =
      ph_arena_array(arena, curve->blaschke.n, sizeof *curve->blaschke.v);
  if (!curve->blaschke.v) {
    return ph_fail_memory(diag);
  }
  curve->blaschke.n = 0;
  walk.fill = true;
  status = ph_rational_walk(curve, 0, curve->n, what, visit, &walk, diag);
  for (size_t i = 0; status == PH_OK && i < curve->blaschke.n; i++) {
    const struct ph_blaschke *image = &curve->blaschke.v[i];
    if (!is_finite(image)) {
      status = ph_fail_at(diag, PH_E_TOO_LARGE, "segments", image->segment,
                          "its %s exceeds the range of a double", what);
    }
  }
  return status;
}
