/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Frames of samples (see frame.h). */
#include "check/frame.h"

#include "check/dips.h"
#include "check/kind.h"

/* Integrals of the turn, relative and absolute. */
static const double TURN = 1e-11;

/* What rounding does to r', relative. */
static const double ROUNDING = 4 * DBL_EPSILON;

/* Places between two dips among which tangents are looked at. */
enum { PLACES = 8 };

/* ---- the turn ----------------------------------------------------------- */

/* Of a frame that goes with the tangent by the shortest rotation from a pole.
 */
struct turning {
  const struct ph_check_segment *s;
  ph_vec3 pole;
};

/* (1), and by how much it may be off: the area between the ways of two tangents
 * on the sphere. */
static void turn_at(const void *context, double u, double *value) {
  const struct turning *of = context;
  ph_vec3 jet[2], turn;
  double speed, error;
  ph_check_jet(of->s, u, jet, 2);
  speed = ph_vec3_abs(jet[0]);
  turn = ph_vec3_scale(1 / speed, ph_vec3_cross(jet[0], jet[1]));
  error = of->s->noise / speed + ROUNDING;
  value[0] =
      ph_vec3_dot(of->pole, turn) / (speed + ph_vec3_dot(of->pole, jet[0]));
  value[1] = error * ph_vec3_abs(turn) / speed;
}

/* From 0 to 1, slowly at both ends. */
static double graded(double x) {
  return x * x * x * (10 - x * (15 - 6 * x));
}

/* The cosine of the largest angle between tangents and a pole. */
static double nearness(const struct ph_check_segment *s, const double *cuts,
                       size_t n, ph_vec3 pole) {
  double least = 1;
  for (size_t i = 0; i + 1 < n; i++) {
    for (size_t j = 0; j <= PLACES; j++) {
      double part = graded((double)j / PLACES);
      ph_vec3 first;
      ph_check_jet(s, cuts[i] + part * (cuts[i + 1] - cuts[i]), &first, 1);
      least = ph_check_smaller(least, ph_vec3_dot(ph_vec3_unit(first), pole));
    }
  }
  return least;
}

/* An axis whose opposite is far from all tangents.  Where one passes nearby,
 * (1) has a peak; on the other side it is one turn more or less. */
static ph_vec3 pole_of(const struct ph_check_segment *s, const double *cuts,
                       size_t n) {
  ph_vec3 pole = {0, 0, 0};
  double best = -HUGE_VAL;
  for (int i = 0; i < 6; i++) {
    double sign = i < 3 ? 1 : -1;
    ph_vec3 axis = {i % 3 == 0 ? sign : 0, i % 3 == 1 ? sign : 0,
                    i % 3 == 2 ? sign : 0};
    double least = nearness(s, cuts, n, axis);
    if (least > best) {
      best = least;
      pole = axis;
    }
  }
  return pole;
}

/* The integral of (1) between two places, from dip to dip; adds to the error,
 * which has no bound where the curve rests at a place that was looked at. */
static double turn_between(const struct ph_check_path *path, double from,
                           double to, ph_vec3 *pole, double *error) {
  const struct ph_check_dips slow = ph_check_slow_of(path->s);
  struct turning turning = {.s = path->s};
  const struct ph_check_integrands of = {turn_at, &turning, 2, 1, TURN, TURN};
  double cuts[PH_CHECK_DIPS + 2] = {from}, turn = 0, sum[2];
  size_t n = 1;
  for (size_t i = 0; i < slow.n; i++) {
    if (slow.x[i] > from && slow.x[i] < to) {
      cuts[n++] = slow.x[i];
    }
  }
  cuts[n++] = to;
  *pole = turning.pole = pole_of(path->s, cuts, n);
  for (size_t i = 0; i + 1 < n; i++) {
    ph_check_integral(&path->v->rule, &of, cuts[i], cuts[i + 1], sum);
    turn += sum[0];
    *error += sum[1] + TURN;
  }
  if (!isfinite(turn)) {
    *error = (double)INFINITY;
  }
  return turn;
}

/* ---- the normal --------------------------------------------------------- */

/* The normal at `to`, by the shortest rotations from the tangent that it was
 * normal to, which is that of the segment before at a joint, to that at f->u,
 * to the pole and on. */
static ph_vec3 transport(const struct ph_check_framing *f,
                         const struct ph_check_path *path,
                         const struct ph_check_local *to, double u,
                         double *error) {
  const struct ph_check_local from = ph_check_local_at(path, f->u);
  const ph_vec3 middle = ph_vec3_add(f->tangent, from.tangent);
  ph_vec3 normal = ph_vec3_carried(f->normal, f->tangent, from.tangent), pole;
  double turn;
  *error = f->error + to->tangent_error +
           4 * from.tangent_error / ph_vec3_abs(middle);
  turn = turn_between(path, f->u, u, &pole, error);
  normal = ph_vec3_carried(normal, from.tangent, pole);
  normal = ph_vec3_along(ph_vec3_scale(cos(turn), normal), sin(turn),
                         ph_vec3_cross(pole, normal));
  return ph_vec3_carried(normal, pole, to->tangent);
}

void ph_check_frame_leave(struct ph_check_framing *f,
                          const struct ph_check_path *path) {
  if (f->begun) {
    const struct ph_check_local end = ph_check_local_at(path, 1);
    double error;
    f->normal = transport(f, path, &end, 1, &error);
    f->tangent = end.tangent;
    f->error = error;
    f->begun = error < 1;
  }
  f->k++;
  f->u = 0;
}

/* Of r'' across r'. */
static ph_vec3 principal(const struct ph_check_path *path, double u) {
  ph_vec3 jet[2];
  ph_check_jet(path->s, u, jet, 2);
  return ph_vec3_unit(ph_vec3_normal(jet[1], ph_vec3_unit(jet[0])));
}

ph_vec3 ph_check_frame_at(const struct ph_check_framing *f,
                          const struct ph_check_path *path,
                          const struct ph_check_local *local, double u,
                          double *error) {
  const bool sphere = path->s->kind->sphere;
  ph_vec3 none = {(double)NAN, (double)NAN, (double)NAN};
  *error = (double)INFINITY;
  switch (f->frame) {
  case PH_FRAME_FRENET:
    *error = local->tangent_error + local->flat;
    return principal(path, u);
  case PH_FRAME_ERF:
    *error = path->v->curve->preimage.v ? local->tangent_error : *error;
    return path->v->curve->preimage.v ? ph_check_across(path, u) : none;
  case PH_FRAME_RMF:
    if (sphere) {
      ph_vec3 out = ph_vec3_sub(local->point, path->s->center);
      *error = local->tangent_error + local->point_error / path->s->radius;
      return ph_vec3_cross(ph_vec3_unit(out), local->tangent);
    }
    return f->begun ? transport(f, path, local, u, error) : none;
  default:
    return none;
  }
}
