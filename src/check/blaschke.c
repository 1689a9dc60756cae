/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Images on the Blaschke cylinder, against what they are: a point
 * (n, -<n, r>) for each place r of the curve with its left normal n.
 *
 * Both sides are compared at as many places as a difference of two such
 * quotients has coefficients; first n, then the third coordinate with the n
 * that is claimed, which is known better than that of rounded control points.
 */
#include "check/checks.h"

#include "kernel/bern.h"

enum { DEGREE = 5, PLACES = 2 * DEGREE + 1, ROUND = 16 };

/* A point of an image, and what rounding of its control points and weights may
 * make of the first two coordinates and the third. */
struct image {
  ph_vec3 at;
  double flat, height;
};

static struct ph_check_where in(const struct ph_blaschke *b) {
  return ph_check_in(b->segment, "blaschke");
}

static struct image image_at(const struct ph_check *v,
                             const struct ph_blaschke *b, double u) {
  struct image image = {{0, 0, 0}, 0, 0};
  double basis[DEGREE + 1], heaviest = 0, sum = 0, error;
  ph_bern_basis(DEGREE, u, basis);
  for (size_t k = 0; k <= DEGREE; k++) {
    const double *p = b->control_points[k];
    double z = ph_check_scaled(v, p[2]), weight = basis[k] * b->weights[k];
    image.at = ph_vec3_along(image.at, weight, ph_vec3_of(p[0], p[1], z));
    image.flat += basis[k] * (1 + fabs(p[0]) + fabs(p[1]));
    image.height += basis[k] * (v->scale.size + fabs(z));
    heaviest = ph_check_larger(heaviest, b->weights[k]);
    sum += weight;
  }
  error = ROUND * DBL_EPSILON * heaviest / sum;
  image.at = ph_vec3_scale(1 / sum, image.at);
  image.flat *= error;
  image.height *= error;
  return image;
}

static void check_place(struct ph_check *v, const struct ph_blaschke *b,
                        const struct ph_check_path *path, double u) {
  double t = b->interval[0] + (b->interval[1] - b->interval[0]) * u;
  struct ph_check_local local = ph_check_local_at(path, t);
  struct image image = image_at(v, b, u);
  ph_vec3 flat = ph_vec3_of(image.at.x, image.at.y, 0);
  ph_vec3 normal = ph_vec3_of(-local.tangent.y, local.tangent.x, 0);
  double reach = ph_vec3_abs(local.point);
  if (local.tangent_error < PH_CHECK_NO_DIRECTION) {
    ph_check_miss(v, PH_CHECK_BLASCHKE, in(b), ph_check_apart(flat, normal), 1,
                  local.tangent_error + image.flat, "is away from the normals");
    ph_check_miss(v, PH_CHECK_BLASCHKE, in(b),
                  fabs(image.at.z + ph_vec3_dot(flat, local.point)),
                  v->scale.size,
                  local.point_error + image.height + image.flat * reach +
                      ROUND * v->scale.rounding,
                  "is away from the tangent lines");
  }
}

static bool is_positive(const struct ph_blaschke *b) {
  bool positive = true;
  for (size_t k = 0; k <= DEGREE; k++) {
    const double *p = b->control_points[k];
    positive = positive && b->weights[k] > 0 && isfinite(b->weights[k]) &&
               isfinite(p[0]) && isfinite(p[1]) && isfinite(p[2]);
  }
  return positive;
}

static bool same(double a, double b) {
  return a <= b && a >= b;
}

/* Whether image i goes on where the one before ended; the last one is at the
 * end of all segments. */
static bool goes_on(const struct ph_curve *c, size_t i) {
  const struct ph_blaschke *b = &c->blaschke.v[i], *before = b - 1;
  bool whole = i == 0 || same(before->interval[1], 1);
  size_t segment = i == 0 ? 0 : before->segment + whole;
  return b->segment == segment && segment < c->n &&
         same(b->interval[0], whole ? 0 : before->interval[1]) &&
         b->interval[1] > b->interval[0] && b->interval[1] <= 1 &&
         (i + 1 < c->blaschke.n ||
          (segment + 1 == c->n && same(b->interval[1], 1)));
}

void ph_check_blaschke(struct ph_check *v) {
  const struct ph_curve *c = v->curve;
  struct ph_check_segment s;
  struct ph_check_path path = {.v = v, .s = &s};
  for (size_t i = 0; i < c->blaschke.n; i++) {
    const struct ph_blaschke *b = &c->blaschke.v[i];
    if (!goes_on(c, i)) {
      ph_check_wrong(v, PH_CHECK_BLASCHKE, in(b),
                     "is of no part of the curve that is next");
      return;
    }
    if (!is_positive(b)) {
      ph_check_wrong(v, PH_CHECK_BLASCHKE, in(b),
                     "has weights that are not positive");
      return;
    }
    ph_check_load(v, b->segment, &s);
    for (size_t j = 0; j < PLACES; j++) {
      check_place(v, b, &path, (double)j / (PLACES - 1));
    }
  }
}
