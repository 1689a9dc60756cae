/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Frames of samples (see frame.h). */
#include "check/frame.h"

#include "check/dips.h"
#include "check/kind.h"

/* Steps from one sample to the next, then twice as many and so on, until no
 * more than this changes; where a tangent turns by more than that in one of
 * them, what the normal does is not known. */
enum { STEPS = 4, STEPS_MAX = 2048 };
static const double ENOUGH = 1e-8, TURN = 0.5;

/* Changes fall by 16 where steps are twice as many.  As long as they do not, by
 * half of that at least or to rounding, steps are too long for what happens in
 * a short part, and a small change says nothing. */
static const double FALL = 8, ROUNDING = 16 * DBL_EPSILON;

/* What is carried along: a place and a normal. */
struct carried {
  ph_vec3 point, tangent, normal;
};

static ph_vec3 reflect(ph_vec3 v, ph_vec3 across) {
  double square = ph_vec3_dot(across, across);
  return square > 0
             ? ph_vec3_along(v, -2 * ph_vec3_dot(across, v) / square, across)
             : v;
}

/* Reflects in the plane between two points, then in that which takes the
 * tangent along.  Where both points are the same but for rounding, so that the
 * direction from one to the other is farther off than the tangents are apart,
 * it is the tangent: that turns the normal by the shortest way. */
static void step_to(struct carried *c, const struct ph_check_local *to) {
  ph_vec3 chord = ph_vec3_sub(to->point, c->point), normal, there;
  double turn = ph_check_apart(to->tangent, c->tangent);
  if (!(2 * to->point_error <= turn * ph_vec3_abs(chord))) {
    chord = c->tangent;
  }
  normal = reflect(c->normal, chord);
  there = reflect(c->tangent, chord);
  c->normal = reflect(normal, ph_vec3_sub(to->tangent, there));
  c->point = to->point;
  c->tangent = to->tangent;
}

/* From 0 to 1, slowly at both ends. */
static double graded(double x) {
  return x * x * x * (10 - x * (15 - 6 * x));
}

/* Carries the normal on to a place, in some steps; adds what the tangents may
 * be off by to the error. */
static void carry_on(struct carried *c, const struct ph_check_path *path,
                     double from, double to, size_t steps, double *error) {
  for (size_t i = 1; i <= steps; i++) {
    double part = graded((double)i / (double)steps);
    struct ph_check_local local =
        ph_check_local_at(path, from + part * (to - from));
    if (!(ph_check_apart(local.tangent, c->tangent) <= TURN)) {
      *error = HUGE_VAL;
    }
    *error += local.tangent_error;
    step_to(c, &local);
  }
}

/* The normal at `to`, from f->u and from dip to dip. */
static ph_vec3 carry(const struct ph_check_framing *f,
                     const struct ph_check_path *path,
                     const struct ph_check_dips *slow, double to, size_t steps,
                     double *error) {
  struct ph_check_local local = ph_check_local_at(path, f->u);
  struct carried c = {local.point, local.tangent, f->normal};
  double from = f->u;
  *error += local.tangent_error;
  for (size_t i = 0; i < slow->n; i++) {
    if (slow->x[i] > from && slow->x[i] < to) {
      carry_on(&c, path, from, slow->x[i], steps, error);
      from = slow->x[i];
    }
  }
  carry_on(&c, path, from, to, steps, error);
  return c.normal;
}

static ph_vec3 transport(const struct ph_check_framing *f,
                         const struct ph_check_path *path, double to,
                         double *error) {
  const struct ph_check_dips slow =
      ph_check_dips_of(ph_check_square_speed, path->s);
  double tangents = 0, last, apart = 0;
  ph_vec3 fine = carry(f, path, &slow, to, STEPS, &tangents), coarse, change;
  size_t steps = STEPS;
  bool found = false;
  do {
    coarse = fine;
    steps *= 2;
    tangents = 0;
    fine = carry(f, path, &slow, to, steps, &tangents);
    change = ph_vec3_sub(fine, coarse);
    last = apart;
    apart = ph_vec3_abs(change);
    found = apart <= ENOUGH + tangents &&
            (FALL * apart <= last || apart <= ROUNDING * (double)steps);
  } while (steps < STEPS_MAX && !found);
  *error = found ? f->error + apart + tangents : HUGE_VAL;
  return ph_vec3_unit(ph_vec3_along(fine, 1.0 / 15, change));
}

void ph_check_frame_leave(struct ph_check_framing *f,
                          const struct ph_check_path *path) {
  double error;
  if (f->begun) {
    f->normal = transport(f, path, 1, &error);
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
    return f->begun ? transport(f, path, u, error) : none;
  default:
    return none;
  }
}
