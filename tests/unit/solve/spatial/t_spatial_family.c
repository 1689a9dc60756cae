/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The family of spatial Hermite interpolants: the identities of
 * spatial.h at random members, for PH quintics and ATPH curves, also
 * where the data are nearly singular; and angles about an axis against
 * [FAR15, (11)-(17)] written down again.
 */
#include "unit.h"
#include "spatial_unit.h"

#include "kernel/quad.h"

enum { DATA = 4000 };

static const double PI = 3.14159265358979323846;

static struct ph_spatial_member random_member(struct unit_random *r) {
  struct ph_spatial_member member = {unit_random_phase(r),
                                     unit_random_phase(r)};
  return member;
}

/* ---- identities ----------------------------------------------------- */

/* The axes (1), right-handed, and the tangents in them. */
static double frame_error(const struct ph_spatial_family *f,
                          const struct ph_spatial_data *data) {
  double error = fabs(f->c * f->c + f->s * f->s - 1);
  for (size_t i = 0; i < 3; i++) {
    for (size_t j = 0; j < 3; j++) {
      error = unit_larger(error,
                          fabs(ph_vec3_dot(f->axis[i], f->axis[j]) - (i == j)));
    }
  }
  error = unit_larger(
      error, unit_apart(ph_vec3_cross(f->axis[0], f->axis[1]), f->axis[2]));
  error = unit_larger(
      error,
      unit_apart(unit_spatial_world(f, ph_vec3_of(f->c, -f->s, 0)), data->ti));
  error = unit_larger(
      error,
      unit_apart(unit_spatial_world(f, ph_vec3_of(f->c, f->s, 0)), data->tf));
  return unit_larger(error, unit_apart(unit_spatial_world(f, f->dp), data->dp));
}

/* D of (4). */
static ph_quat d_of(const struct ph_spatial_family *f, const ph_quat a[3]) {
  return ph_quat_add(ph_quat_scale(f->m11, a[1]),
                     ph_quat_scale(f->m01, ph_quat_add(a[0], a[2])));
}

/* The largest error of (2), (3) and (4); every term is about 1. */
static double member_error(const struct ph_spatial_family *f,
                           struct ph_spatial_member member) {
  ph_cplx b = member.b;
  ph_vec3 e = ph_vec3_of(b.re, 0, -f->s * b.im), d = ph_spatial_d(f, b);
  ph_vec3 wanted;
  ph_quat a[3], big;
  double error;
  ph_spatial_preimage(f, member, a);
  error = unit_apart(ph_quat_i(a[0], a[0]),
                     ph_vec3_of(f->ni * f->c, -f->ni * f->s, 0));
  error =
      unit_larger(error, unit_apart(ph_quat_i(a[2], a[2]),
                                    ph_vec3_of(f->nf * f->c, f->nf * f->s, 0)));
  error = unit_larger(
      error, unit_apart(ph_quat_i(a[0], a[2]), ph_vec3_scale(f->m, e)));
  error =
      unit_larger(error, fabs(ph_quat_dot(a[0], a[2]) - f->m * f->c * b.re));
  wanted = ph_vec3_along(ph_vec3_scale(f->m11, f->dp),
                         f->m01 * f->m01 - f->m11 * f->m00, f->sum);
  wanted =
      ph_vec3_along(wanted, 2 * f->m * (f->m01 * f->m01 - f->m11 * f->m02), e);
  error = unit_larger(error, unit_apart(d, wanted));
  big = d_of(f, a);
  return unit_larger(error, unit_apart(ph_quat_i(big, big), d));
}

/* The legs and the integral of the hodograph against dp, and the length, all
 * relative to the size of the polygon. */
static double segment_error(const struct ph_spatial_family *f,
                            const struct ph_spatial_data *data,
                            struct ph_spatial_member member) {
  ph_vec3 leg[5], sum = {0, 0, 0}, integral = {0, 0, 0};
  double size = 0, error;
  ph_quat a[3];
  unit_spatial_preimage(f, member, a);
  unit_spatial_legs(&f->space, a, leg);
  for (size_t i = 0; i < 5; i++) {
    sum = ph_vec3_add(sum, leg[i]);
    size += ph_vec3_abs(leg[i]);
  }
  for (size_t i = 0; i < unit_quad(12)->n; i++) {
    struct ph_atph_table t =
        ph_atph_table_of(&f->space, unit_quad(12)->node[i]);
    ph_quat at = ph_quat_scale(t.b[0][0], a[0]);
    at = ph_quat_add(at, ph_quat_scale(t.b[0][1], a[1]));
    at = ph_quat_add(at, ph_quat_scale(t.b[0][2], a[2]));
    integral =
        ph_vec3_along(integral, unit_quad(12)->weight[i], ph_quat_i(at, at));
  }
  error =
      unit_larger(unit_apart(sum, data->dp), unit_apart(integral, data->dp));
  error = unit_larger(error, fabs(ph_spatial_length(f, member.b) -
                                  ph_seg3_length(&f->space, a)));
  return error / size;
}

/* The squared distance of D from A0 + A2, for the angle phi. */
static double distance(const struct ph_spatial_family *f, ph_cplx b,
                       double phi) {
  struct ph_spatial_member member = {b, ph_cplx_polar(phi)};
  ph_quat a[3], far;
  ph_spatial_preimage(f, member, a);
  far = ph_quat_sub(d_of(f, a), ph_quat_add(a[0], a[2]));
  return ph_quat_dot(far, far);
}

/* All are as near where the projection of A0 + A2 counts as none: 1e-13. */
static void ck_nearest(const struct ph_spatial_family *f, ph_cplx b) {
  double least = distance(f, b, 0);
  for (int i = 1; i < 16; i++) {
    ck_assert_double_le(least, distance(f, b, i * PI / 8) + 1e-12);
  }
  ck_abs(distance(f, b, 1e-3), distance(f, b, -1e-3), 1e-13);
}

static void ck_family(const struct ph_spatial_data *data,
                      const struct ph_atph *space, struct unit_random *r,
                      double tolerance) {
  struct ph_spatial_family f = ph_spatial_family_of(data, space);
  struct ph_spatial_member member = random_member(r);
  double frame = frame_error(&f, data), error = member_error(&f, member);
  double segment = segment_error(&f, data, member);
  ck_assert_msg(frame <= tolerance && error <= 2e-14 && segment <= tolerance,
                "seed %lu: psi %.3g, angle %.3g: frame %.3g, member %.3g, "
                "segment %.3g > %.3g",
                unit_seed(), atan2(f.s, f.c), space->angle, frame, error,
                segment, tolerance);
  ck_nearest(&f, member.b);
}

PH_TEST(test_identities) {
  struct unit_random r = unit_random_of(401);
  for (int i = 0; i < unit_count(DATA); i++) {
    struct ph_spatial_data data = unit_random_spatial(&r);
    struct ph_atph space = unit_random_space(&r);
    ck_family(&data, &space, &r, 1e-14);
  }
}

/* Another space is another family. */
PH_TEST(test_space) {
  struct unit_random r = unit_random_of(402);
  for (int i = 0; i < unit_count(200); i++) {
    struct ph_spatial_data data = unit_random_spatial(&r);
    struct ph_atph space[2] = {unit_random_space(&r), unit_random_space(&r)};
    struct ph_spatial_family f = ph_spatial_family_of(&data, &space[0]);
    struct ph_spatial_family g = ph_spatial_family_of(&data, &space[1]);
    struct ph_spatial_member member = random_member(&r);
    ph_vec3 p[2][6];
    ph_spatial_family_space(&f, &space[1]);
    unit_spatial_points(&f, member, p[0]);
    unit_spatial_points(&g, member, p[1]);
    ck_abs(unit_spatial_error(p[0], p[1]), 0, 0);
  }
}

/* ---- singular and nearly singular data ------------------------------ */

/* Tangents at an angle 2 psi, or nearly opposite, in a random position. */
static void set_tangents(struct ph_spatial_data *data, struct unit_random *r,
                         double psi, bool opposite) {
  ph_vec3 v;
  data->ti = unit_random_direction(r);
  v = ph_vec3_unit(ph_vec3_normal(unit_random_direction(r), data->ti));
  data->tf =
      ph_vec3_along(ph_vec3_scale(cos(2 * psi), data->ti), sin(2 * psi), v);
  data->tf = ph_vec3_scale(opposite ? -1 : 1, ph_vec3_unit(data->tf));
}

/* psi = 10^-3, ..., 10^-15 from parallel or opposite.  Below 1e-12 the tangents
 * count as parallel, and are moved by as much. */
PH_TEST(test_near) {
  struct unit_random r = unit_random_of(403);
  double psi = 1e-3;
  for (int k = 3; k <= 15; k++, psi /= 10) {
    for (int i = 0; i < unit_count(200); i++) {
      struct ph_spatial_data data = unit_random_spatial(&r);
      struct ph_atph space = unit_random_space(&r);
      set_tangents(&data, &r, psi, i & 1);
      ck_family(&data, &space, &r, k < 12 ? 1e-14 : 1e-14 + 2 * psi);
    }
  }
}

/* ti = tf and ti = -tf, exactly. */
PH_TEST(test_parallel) {
  struct unit_random r = unit_random_of(404);
  for (int i = 0; i < unit_count(500); i++) {
    struct ph_spatial_data data = unit_random_spatial(&r);
    struct ph_atph space = unit_random_space(&r);
    struct ph_spatial_family f;
    data.tf = ph_vec3_scale(i & 1 ? -1 : 1, data.ti);
    ck_family(&data, &space, &r, 1e-14);
    f = ph_spatial_family_of(&data, &space);
    ck_abs(f.s, i & 1, 0);
    ck_abs(f.c, !(i & 1), 0);
    ck_abs(f.dp.z, 0, 4 * DBL_EPSILON); /* dp in the plane of g+ and g- */
    ck_assert(f.planar);
  }
}

/* ti = tf or -tf, and dp at a small angle of them. */
PH_TEST(test_parallel_near) {
  struct unit_random r = unit_random_of(410);
  for (int i = 0; i < unit_count(800); i++) {
    struct ph_spatial_data data = unit_random_spatial(&r);
    struct ph_atph space = unit_random_space(&r);
    double angle = pow(10, -unit_random_in(&r, 1, 16));
    data.tf = ph_vec3_scale(i & 1 ? -1 : 1, data.ti);
    data.dp = ph_vec3_unit(ph_vec3_along(data.ti, angle, data.dp));
    data.dp = ph_vec3_scale(i & 2 ? -1 : 1, data.dp);
    ck_family(&data, &space, &r, 1e-14);
  }
}

/* Tangents along the chord, to either side.  Only where both agree with it is
 * there no need to leave the line. */
PH_TEST(test_straight) {
  struct unit_random r = unit_random_of(405);
  for (int i = 0; i < unit_count(400); i++) {
    struct ph_spatial_data data = unit_random_spatial(&r);
    struct ph_atph space = unit_random_space(&r);
    struct ph_spatial_family f;
    ph_vec3 p[6];
    data.ti = ph_vec3_scale(i & 1 ? -1 : 1, data.dp);
    data.tf = ph_vec3_scale(i & 2 ? -1 : 1, data.dp);
    ck_family(&data, &space, &r, 1e-14);
    f = ph_spatial_family_of(&data, &space);
    unit_spatial_points(&f, ph_spatial_cc(&f), p);
    for (size_t k = 1; k < 5 && i % 4 == 0; k++) {
      ck_abs(ph_vec3_abs(ph_vec3_normal(p[k], data.dp)), 0, 1e-14);
    }
  }
}

/* A random unit vector of the plane of two others. */
static ph_vec3 random_in_plane(struct unit_random *r, const ph_vec3 e[2]) {
  ph_cplx at = unit_random_phase(r);
  return ph_vec3_along(ph_vec3_scale(at.re, e[0]), at.im, e[1]);
}

/* Plane data: the members b = 0 and pi, phi = 0 are plane. */
PH_TEST(test_plane) {
  struct unit_random r = unit_random_of(406);
  for (int i = 0; i < unit_count(DATA); i++) {
    struct ph_spatial_data data = unit_random_spatial(&r);
    struct ph_atph space = unit_random_space(&r);
    struct ph_spatial_member member = {{i & 1 ? -1 : 1, 0}, {1, 0}};
    struct ph_spatial_family f;
    ph_vec3 normal = unit_random_direction(&r), e[2], p[6];
    e[0] = ph_vec3_any_normal(normal);
    e[1] = ph_vec3_cross(normal, e[0]);
    data.dp = random_in_plane(&r, e);
    data.ti = random_in_plane(&r, e);
    data.tf = random_in_plane(&r, e);
    f = ph_spatial_family_of(&data, &space);
    ck_assert(f.planar || f.c < 1e-3);
    unit_spatial_points(&f, member, p);
    for (size_t k = 1; k < 5; k++) {
      /* the plane of two tangents is as certain as c */
      ck_abs(ph_vec3_dot(p[k], normal), 0, 1e-10 + 1e-15 / f.c);
    }
  }
}

/* dp such that d(b) = 0 but for rounding, and d = 0 exactly. */
PH_TEST(test_no_d) {
  struct unit_random r = unit_random_of(407);
  for (int i = 0; i < unit_count(1000); i++) {
    struct ph_spatial_data data = unit_random_spatial(&r);
    struct ph_atph space = unit_random_space(&r);
    struct ph_spatial_member member = random_member(&r);
    struct ph_spatial_family f = ph_spatial_family_of(&data, &space);
    double k = 2 * f.k * f.m;
    ph_vec3 wanted = ph_vec3_of(-k * member.b.re, 0, k * f.s * member.b.im);
    ph_quat a[3];
    wanted = ph_vec3_along(wanted, f.m00 * f.m11 - f.m01 * f.m01, f.sum);
    data.dp = unit_spatial_world(&f, ph_vec3_scale(1 / f.m11, wanted));
    f = ph_spatial_family_of(&data, &space);
    ck_assert_double_le(ph_vec3_abs(ph_spatial_d(&f, member.b)), 2e-15);
    ck_assert_double_le(member_error(&f, member), 2e-14);
    ck_assert_double_le(segment_error(&f, &data, member), 1e-14);
    f.d0 = ph_vec3_of(-k * member.b.re, 0, k * f.s * member.b.im);
    ck_abs(ph_vec3_abs(ph_spatial_d(&f, member.b)), 0, 0);
    ph_spatial_preimage(&f, member, a);
    ck_abs(ph_quat_abs(d_of(&f, a)), 0, 4 * DBL_EPSILON);
    ck_assert(isfinite(ph_quat_abs(a[1])));
  }
}

/* ---- angles --------------------------------------------------------- */

static ph_vec3 axis_of(const struct ph_spatial_data *data,
                       enum ph_spatial_axis axis) {
  return axis == PH_SPATIAL_X ? ph_vec3_of(1, 0, 0) : ph_vec3_unit(data->dp);
}

/* vect(a u b*) */
static ph_vec3 sandwich(ph_quat a, ph_vec3 u, ph_quat b) {
  return ph_quat_vector(
      ph_quat_mul(ph_quat_mul(a, ph_quat_pure(u)), ph_quat_conj(b)));
}

/* size n exp(angle u), n the bisector of u and t. */
static ph_quat by_angle(ph_vec3 u, ph_vec3 t, double size, double angle) {
  ph_vec3 n = ph_vec3_unit(ph_vec3_add(u, t));
  ph_quat e = ph_quat_pure(ph_vec3_scale(sin(angle), u));
  e.u = cos(angle);
  return ph_quat_scale(size, ph_quat_mul(ph_quat_pure(n), e));
}

/* [FAR15, (11)-(17)] for the integrals of any space; legs as in (6). */
static void defined(const struct ph_spatial_data *data,
                    const struct ph_atph *space, ph_vec3 u,
                    const double angles[2], ph_vec3 p[6]) {
  const double *q = space->q, m01 = 0.5 * q[1], m02 = 0.5 * q[3];
  double theta = angles[0], beta = angles[1], size;
  ph_quat a0 = by_angle(u, data->ti, sqrt(data->ni), theta - 0.5 * beta);
  ph_quat a2 = by_angle(u, data->tf, sqrt(data->nf), theta + 0.5 * beta), a1;
  ph_vec3 d = ph_vec3_scale(q[2], data->dp), middle;
  d = ph_vec3_along(
      d, m01 * m01 - q[2] * q[0],
      ph_vec3_along(ph_vec3_scale(data->ni, data->ti), data->nf, data->tf));
  d = ph_vec3_along(d, 2 * (m01 * m01 - q[2] * m02), sandwich(a0, u, a2));
  size = ph_vec3_abs(d);
  a1 = by_angle(u, ph_vec3_scale(1 / size, d), sqrt(size), 0);
  a1 = ph_quat_sub(a1, ph_quat_scale(m01, ph_quat_add(a0, a2)));
  a1 = ph_quat_scale(1 / q[2], a1);
  p[0] = ph_vec3_of(0, 0, 0);
  p[1] = ph_vec3_scale(q[0], sandwich(a0, u, a0));
  p[2] = ph_vec3_along(p[1], q[1], sandwich(a0, u, a1));
  middle = ph_vec3_along(ph_vec3_scale(q[2], sandwich(a1, u, a1)), q[3],
                         sandwich(a0, u, a2));
  p[3] = ph_vec3_add(p[2], middle);
  p[4] = ph_vec3_along(p[3], q[1], sandwich(a1, u, a2));
  p[5] = ph_vec3_along(p[4], q[0], sandwich(a2, u, a2));
}

/* How far the angle a - b is from a multiple of 2 pi. */
static double angle_apart(double a, double b) {
  return fabs(remainder(a - b, 2 * PI));
}

/* Angles that are chosen give the curve defined by them, and come back.  Both
 * lose digits where a vector is nearly opposite to the axis. */
static void ck_angles(struct unit_random *r, enum ph_spatial_axis axis) {
  struct ph_spatial_data data = unit_random_spatial(r);
  struct ph_atph space = unit_random_space(r);
  struct ph_spatial_family f = ph_spatial_family_of(&data, &space);
  struct ph_spatial_member member;
  const double angles[2] = {unit_random_in(r, -PI, PI),
                            unit_random_in(r, -PI, PI)};
  ph_vec3 u = axis_of(&data, axis), found[6], wanted[6], d;
  double back[2], gap;
  ck_assert(ph_spatial_member_of(&f, angles, axis, &member));
  d = ph_vec3_unit(unit_spatial_world(&f, ph_spatial_d(&f, member.b)));
  gap = fmin(ph_vec3_abs(ph_vec3_add(u, data.ti)),
             ph_vec3_abs(ph_vec3_add(u, data.tf)));
  gap = fmin(gap, ph_vec3_abs(ph_vec3_add(u, d)));
  gap = fmin(gap, ph_vec3_abs(ph_spatial_d(&f, member.b)));
  unit_spatial_points(&f, member, found);
  defined(&data, &space, u, angles, wanted);
  ck_abs(unit_spatial_error(found, wanted), 0, 1e-14 / gap);
  ck_assert(ph_spatial_angles(&f, member, axis, back));
  ck_assert_double_le(fabs(back[0]), PI);
  ck_assert_double_le(fabs(back[1]), PI);
  ck_abs(angle_apart(back[1], angles[1]), 0, 1e-14 / gap);
  /* (theta + pi, beta + 2 pi) is the same curve. */
  ck_abs(angle_apart(back[0], angles[0]), 0, 1e-14 / gap);
}

PH_TEST(test_angles) {
  struct unit_random r = unit_random_of(408);
  for (int i = 0; i < unit_count(DATA); i++) {
    ck_angles(&r, PH_SPATIAL_CHORD);
    ck_angles(&r, PH_SPATIAL_X);
  }
}

/* Of any member, for any axis, and back. */
PH_TEST(test_round_trip) {
  static const enum ph_spatial_axis all[] = {PH_SPATIAL_CHORD, PH_SPATIAL_X,
                                             PH_SPATIAL_BISECTOR};
  struct unit_random r = unit_random_of(409);
  for (int i = 0; i < unit_count(DATA); i++) {
    struct ph_spatial_data data = unit_random_spatial(&r);
    struct ph_atph space = unit_random_space(&r);
    struct ph_spatial_family f = ph_spatial_family_of(&data, &space);
    struct ph_spatial_member member = random_member(&r), back;
    for (size_t k = 0; k < 3; k++) {
      double angles[2];
      ck_assert(ph_spatial_angles(&f, member, all[k], angles));
      ck_assert(ph_spatial_member_of(&f, angles, all[k], &back));
      ck_abs(unit_distance(back.b, member.b), 0, 1e-14);
      ck_abs(unit_distance(back.phi, member.phi), 0, 1e-12);
    }
  }
}

/* Angles about the first axis of the member b = 1, phi = 1, and a member of
 * angles. */
static void ck_refused(const struct ph_spatial_data *data, bool angles_refused,
                       bool member_refused) {
  struct ph_atph space = ph_atph_of(0);
  struct ph_spatial_family f = ph_spatial_family_of(data, &space);
  struct ph_spatial_member member = {{1, 0}, {1, 0}};
  const double given[2] = {0.25, 0.5};
  double angles[2];
  ck_assert(ph_spatial_angles(&f, member, PH_SPATIAL_BISECTOR, angles));
  ck_assert(ph_spatial_angles(&f, member, PH_SPATIAL_X, angles) ==
            !angles_refused);
  ck_assert(ph_spatial_member_of(&f, given, PH_SPATIAL_X, &member) ==
            !member_refused);
}

/* A tangent opposite to the axis, or nearer to that than to be useful, has no
 * angle; d neither. */
PH_TEST(test_refused) {
  struct ph_spatial_data data = {{0, 1, 0}, {-1, 0, 0}, {0, 1, 0}, 1,
                                 1,         0,          0,         {0, 0, 0}};
  const ph_vec3 y = {0, 1, 0}, z = {0, 0, 1}, minus = {-1, 0, 0};
  ck_refused(&data, true, true);
  data.ti = ph_vec3_of(-1, 1e-8, 0);
  ck_refused(&data, true, true);
  data.ti = ph_vec3_of(-1, 1e-6, 0);
  ck_refused(&data, false, false);
  data.ti = y;
  data.tf = minus;
  ck_refused(&data, true, true);
  /* 900 d = 120 dp - 15 (y - y) + 10 E(b), with E(0) along dp. */
  data.tf = ph_vec3_scale(-1, y);
  data.dp = minus;
  ck_refused(&data, true, false);
  data.dp = z;
  ck_refused(&data, false, false);
}
