/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Splines that keep the shape of their data (see raise_unit.h). */
#include "raise_unit.h"
#include "unit.h"

#include "kernel/pi.h"

void unit_raise_of(struct unit_raise *t, size_t n, const ph_vec3 *p,
                   const struct unit_raise_kind *kind) {
  unit_sphere_of(&t->u, n, p, kind->closed, kind->ends, kind->model);
  ck_assert(ph_sphere_shape_of(&t->u.data, kind->epsilon, kind->legacy,
                               &t->u.arena, &t->shape));
  t->raise = (struct ph_sphere_raise){.shape = &t->shape,
                                      .increase = PH_SPHERE_MINIMAL,
                                      .spline = &t->u.spline,
                                      .work = &t->u.work};
  t->raise.ignored = ph_arena_array(&t->u.arena, n, 1);
  ck_assert_ptr_nonnull(t->raise.ignored);
  memset(t->raise.ignored, 0, n);
  ck_assert(ph_sphere_solve(&t->u.spline, &t->u.work));
}

void unit_raise_free(struct unit_raise *t) {
  unit_sphere_free(&t->u);
}

enum ph_status unit_raise_go(struct unit_raise *t) {
  return ph_sphere_keep_shape(&t->raise, &t->u.arena);
}

bool unit_raise_holds(const struct unit_raise *t) {
  const struct ph_sphere_data *d = &t->u.data;
  for (size_t i = 0; i < d->n; i++) {
    if (ph_sphere_node_fails(&t->shape, &t->u.spline, i) != PH_SPHERE_FINE) {
      return false;
    }
  }
  for (size_t k = 0; k < d->m; k++) {
    if (ph_sphere_segment_fails(&t->shape, &t->u.spline, k) != PH_SPHERE_FINE) {
      return false;
    }
  }
  return true;
}

double unit_raise_sum(const struct unit_raise *t) {
  double sum = 0;
  for (size_t i = 0; i < t->u.data.n; i++) {
    sum += t->u.spline.nu[i];
  }
  return sum;
}

double unit_raise_missing(struct unit_sphere *u) {
  const struct ph_sphere_model *model = u->spline.model;
  struct ph_sphere_range all = ph_sphere_all(&u->data);
  double worst = 0;
  for (size_t j = 0; j < all.count; j++) {
    size_t i = ph_sphere_node(&u->data, all, j);
    struct ph_sphere_part left, right;
    struct ph_block2_row row;
    model->segment(&u->spline, ph_sphere_before(&u->data, i), false, &left);
    model->segment(&u->spline, i, false, &right);
    model->node(&u->spline, i, &left, &right, false, &row);
    worst = unit_larger(worst, unit_larger(fabs(row.f[0]), fabs(row.f[1])));
  }
  return worst;
}

/* ---- data ---------------------------------------------------------------- */

void unit_raise_corners(struct unit_random *r, size_t n, ph_vec3 *p) {
  static const double turns[] = {0, 0, 0.8, -0.8, 0.3}, steps[] = {0.1, 0.3};
  ph_vec3 on = {0, 1, 0};
  p[0] = ph_vec3_of(1, 0, 0);
  for (size_t i = 1; i < n; i++) {
    ph_vec3 at = p[i - 1];
    double turn = turns[unit_random_below(r, 5)];
    double step = steps[unit_random_below(r, 2)];
    on = ph_vec3_along(ph_vec3_scale(cos(turn), on), sin(turn),
                       ph_vec3_cross(at, on));
    p[i] = ph_vec3_unit(
        ph_vec3_along(ph_vec3_scale(cos(step), at), sin(step), on));
    on = ph_vec3_along(ph_vec3_scale(cos(step), on), -sin(step), at);
    on = ph_vec3_unit(ph_vec3_normal(on, p[i]));
  }
}

void unit_raise_ring(struct unit_random *r, size_t n, double size, bool closed,
                     ph_vec3 *p) {
  double step = closed ? 2 * PH_PI / (double)n : 5 / (double)n;
  for (size_t i = 0; i < n; i++) {
    double lon = step * (double)i;
    p[i] = ph_vec3_unit(
        ph_vec3_of(cos(lon), sin(lon), unit_random_in(r, -size, size)));
  }
}
