/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Segments that were chosen, put into their curve (see spatial.h). */
#include "solve/spatial/spatial.h"

#include "curve/segment/seg3.h"
#include "solve/common/frame.h"

#include <math.h>
#include <string.h>

enum ph_status ph_spatial_curve_alloc(const struct ph_spatial_points *p,
                                      struct ph_arena *arena,
                                      struct ph_curve *curve,
                                      struct ph_diag *diag) {
  size_t n = p->n;
  enum ph_status status;
  *curve = (struct ph_curve){.kind = p->atph ? PH_CURVE_ATPH : PH_CURVE_PH,
                             .closed = p->closed,
                             .joined = true,
                             .dimension = 3,
                             .degree = 5,
                             .n = n,
                             .preimage.n = 3,
                             .preimage.dimension = 4,
                             .knots = p->knots};
  status = ph_curve_alloc(curve, arena, diag);
  if (status != PH_OK) {
    return status;
  }
  curve->choice.tension = ph_arena_array(arena, n, sizeof(double));
  curve->choice.angles = ph_arena_array(arena, n, 2 * sizeof(double));
  curve->choice.shape_ok = ph_arena_array(arena, n, sizeof(bool));
  if (!curve->choice.tension || !curve->choice.angles ||
      !curve->choice.shape_ok) {
    return ph_fail_memory(diag);
  }
  return PH_OK;
}

static ph_vec3 rotated(const ph_vec3 axis[3], ph_vec3 v) {
  ph_vec3 sum = ph_vec3_scale(v.x, axis[0]);
  sum = ph_vec3_along(sum, v.y, axis[1]);
  return ph_vec3_along(sum, v.z, axis[2]);
}

/* Control points from the legs in the frame of the data, turned one by one:
 * what is zero there for plane data stays so. */
static void put_control_points(const struct ph_spatial_points *p, size_t k,
                               const struct ph_spatial_chosen *chosen,
                               const ph_vec3 leg[6], double *out) {
  size_t to = k + 1 < p->points_n ? k + 1 : 0;
  const size_t d = p->dimension;
  const ph_vec3 start = ph_vec3_get(p->points + d * k, d);
  const ph_vec3 end = ph_vec3_get(p->points + d * to, d);
  double unit = 1 / chosen->root;
  ph_vec3_put(start, 3, out);
  ph_vec3_put(end, 3, out + 15);
  for (size_t i = 1; i < 5; i++) {
    const ph_vec3 base = i < 3 ? start : end;
    ph_vec3 v = rotated(chosen->fit->family.axis,
                        ph_vec3_scale(1 / chosen->twice, leg[i]));
    out[3 * i] = base.x + v.x * unit * unit;
    out[3 * i + 1] = base.y + v.y * unit * unit;
    out[3 * i + 2] = base.z + v.z * unit * unit;
  }
}

/* The preimage in space, with the frame of the segment before. */
static void put_preimage(const struct ph_spatial_points *p, size_t k,
                         const struct ph_spatial_chosen *chosen, ph_quat a[3],
                         ph_quat *end, double *out) {
  const struct ph_spatial_family *f = &chosen->fit->family;
  ph_quat r = ph_quat_of_frame(f->axis[0], f->axis[1], f->axis[2]);
  double root = 1 / (chosen->root * sqrt(chosen->twice));
  ph_cplx gauge;
  for (size_t i = 0; i < 3; i++) {
    a[i] = ph_quat_mul(r, a[i]);
  }
  gauge = k == 0 ? ph_frame_upright(a[0]) : ph_frame_follow(a[0], *end);
  root = p->atph ? root / sqrt(f->space.angle) : root;
  for (size_t i = 0; i < 3; i++) {
    a[i] = ph_quat_turn(a[i], gauge);
    out[4 * i] = root * a[i].u + 0.0; /* no -0 */
    out[4 * i + 1] = root * a[i].v + 0.0;
    out[4 * i + 2] = root * a[i].p + 0.0;
    out[4 * i + 3] = root * a[i].q + 0.0;
  }
  *end = a[2];
}

/* By how much the five legs miss dp. */
static double miss(const struct ph_spatial_family *f, const ph_quat a[3],
                   const ph_vec3 leg[6]) {
  ph_vec3 middle = ph_vec3_along(ph_vec3_scale(f->m11, ph_quat_i(a[1], a[1])),
                                 2 * f->m02, ph_quat_i(a[0], a[2]));
  ph_vec3 wanted = ph_vec3_add(f->dp, ph_vec3_sub(leg[3], leg[2]));
  double size = f->h + f->ni + f->nf;
  return ph_vec3_abs(ph_vec3_sub(middle, wanted)) / size;
}

double ph_spatial_put(const struct ph_spatial_points *p, size_t k,
                      const struct ph_spatial_chosen *chosen, ph_quat *end,
                      struct ph_curve *curve) {
  const struct ph_spatial_family *f = &chosen->fit->family;
  const ph_vec3 zero = {0, 0, 0};
  double unit = 1 / chosen->root, missed, length;
  ph_quat a[3];
  ph_vec3 leg[6]; /* from the start, from the end */
  memcpy(a, chosen->fit->a, sizeof a);
  ph_seg3_control_points(&f->space, a, zero, zero, leg);
  missed = miss(f, a, leg);
  put_control_points(p, k, chosen, leg,
                     curve->control_points + ph_curve_stride(curve) * k);
  length = ph_seg3_length(&f->space, a);
  /* not below the chord by rounding */
  length = (length > f->h ? length : f->h) / chosen->twice;
  curve->lengths[k] = length * unit * unit;
  put_preimage(p, k, chosen, a, end, curve->preimage.v + 12 * k);
  if (p->atph) {
    curve->preimage.alpha[k] = f->space.angle;
  }
  curve->choice.tension[k] = chosen->tension;
  curve->choice.shape_ok[k] = chosen->fit->violated == 0;
  memcpy(curve->choice.angles + 2 * k, chosen->angles, sizeof chosen->angles);
  return missed;
}
