/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The family of spatial Hermite interpolants (see spatial.h). */
#include "solve/spatial/spatial.h"

#include "kernel/pi.h"

#include <float.h>
#include <limits.h>

/* Tangents nearer than this to parallel or opposite count as such. */
static const double PARALLEL = 1e-13;

/* s |dp.gh| below this part of |dp|, or so many times its noise: the data are
 * those of a plane curve. */
static const double PLANAR = 1e-13;
static const double PLANAR_NOISE = 8;

/* Sines of angles between data on a line, beyond their flatness. */
static const double NO_NORMAL = 1e-12;

/* ... and where their plane is theirs: its normal is up to ten times as
 * uncertain as they are. */
static const double SPREAD = 0.1;

/* How far plane curves may leave their plane, relative, and in units of what
 * the data do. */
static const double NOT_PLANE = 1e-11;
static const double AWAY = 16;

/* exp(i b) of members in the plane is so near to real. */
static const double NOT_REAL = 1e-12;

/* Of a vector whose direction is rounding, relative. */
static const double NO_DIRECTION = 1e-12;

/* Of a phase that is not determined, relative. */
static const double NO_PHASE = 2e-13;

/* Twice a projection that is shorter than this must be corrected, relative. */
static const double SHORT = 0.1;

/* A vector d is 0 where it is so many times the rounding of its terms: its root
 * would be rounding of half the digits. */
static const double VANISHES = 4 * DBL_EPSILON;

/* Binary digits of rounded invariants: an error of 1e-11, beside 1e-8 that a
 * minimum is known to; of components, which others cancel in, not so many after
 * the point.  Where one falls on the boundary of two, 1 of 10^5 times, rounding
 * shows. */
enum { BITS = 36, PLACE = 44 };

/* A vector this near to opposite to the axis has no angle. */
static const double OPPOSITE = 1e-7;

/* The unit part of v normal to the unit vector u, or any normal.  A short part
 * has the rounding errors of v; made normal again, it loses them. */
static ph_vec3 unit_normal(ph_vec3 v, ph_vec3 u, double size) {
  ph_vec3 normal = ph_vec3_normal(v, u);
  if (!(ph_vec3_abs(normal) > NO_DIRECTION * size)) {
    return ph_vec3_any_normal(u);
  }
  return ph_vec3_unit(ph_vec3_normal(ph_vec3_unit(normal), u));
}

/* The axes (1): the longer of ti + tf and tf - ti first, the other one made
 * normal to it. */
static void set_frame(struct ph_spatial_family *f,
                      const struct ph_spatial_data *data) {
  ph_vec3 sum = ph_vec3_add(data->ti, data->tf);
  ph_vec3 difference = ph_vec3_sub(data->tf, data->ti);
  double c = 0.5 * ph_vec3_abs(sum), s = 0.5 * ph_vec3_abs(difference);
  if (c >= s) {
    bool parallel = s <= PARALLEL;
    f->axis[0] = ph_vec3_scale(0.5 / c, sum);
    f->axis[1] = parallel
                     ? unit_normal(data->dp, f->axis[0], f->h)
                     : ph_vec3_unit(ph_vec3_normal(difference, f->axis[0]));
    f->c = parallel ? 1 : c;
    f->s = parallel ? 0 : s;
  } else {
    bool opposite = c <= PARALLEL;
    f->axis[1] = ph_vec3_scale(0.5 / s, difference);
    f->axis[0] = opposite ? unit_normal(data->dp, f->axis[1], f->h)
                          : ph_vec3_unit(ph_vec3_normal(sum, f->axis[1]));
    f->c = opposite ? 0 : c;
    f->s = opposite ? 1 : s;
  }
  f->axis[2] = ph_vec3_cross(f->axis[0], f->axis[1]);
}

/* exp(i b) of members in the plane: E(b) of (3) is, as A0 and A2 are.  Where
 * the tangents are nearly opposite, the direction of g+ may be rounding. */
static ph_cplx plane_b(const struct ph_spatial_family *f) {
  double re = f->s * f->normal.z, im = f->normal.x, size = hypot(re, im);
  return f->s > f->c ? ph_cplx_scale(copysign(1 / size, re), ph_cplx_of(re, im))
                     : ph_cplx_of(1, 0);
}

/* The plane of the data: the one of two of their three directions that the
 * third one leaves; or that of all data, if these have one, where the three are
 * near to a line. */
static void set_plane(struct ph_spatial_family *f,
                      const struct ph_spatial_data *data) {
  const ph_vec3 ti = {f->c, -f->s, 0}, tf = {f->c, f->s, 0};
  double flatness = f->flatness / f->h, largest = 0;
  bool given = ph_vec3_dot(data->normal, data->normal) > 0, straight;
  ph_vec3 v[3] = {ti, ph_vec3_scale(1 / f->h, f->dp), tf};
  f->normal = ph_vec3_of(0, 0, 1);
  f->plane_b = ph_cplx_of(1, 0);
  f->away = HUGE_VAL;
  f->flat = f->has_plane = false;
  if (ph_spatial_is_twisted(f)) {
    return; /* none is near enough */
  }
  for (size_t i = 0; i < 3; i++) {
    ph_vec3 n = ph_vec3_cross(v[i], v[(i + 1) % 3]);
    double size = ph_vec3_abs(n);
    if (size > largest) {
      largest = size;
      f->normal = n;
    }
  }
  given = given && largest < SPREAD;
  straight = !given && !(largest > NO_NORMAL + flatness);
  if (given) {
    f->normal = ph_vec3_of(ph_vec3_dot(data->normal, f->axis[0]),
                           ph_vec3_dot(data->normal, f->axis[1]),
                           ph_vec3_dot(data->normal, f->axis[2]));
  } else {
    f->normal =
        straight ? ph_vec3_of(0, 0, 1) : ph_vec3_scale(1 / largest, f->normal);
  }
  f->away = 0;
  for (size_t i = 0; i < 3; i++) {
    f->away = fmax(f->away, fabs(ph_vec3_dot(v[i], f->normal)));
  }
  f->has_plane = !straight && f->away <= flatness;
  f->flat = f->planar || f->has_plane || straight;
  if (given || !f->planar) {
    f->plane_b = plane_b(f);
  }
}

void ph_spatial_family_space(struct ph_spatial_family *f,
                             const struct ph_atph *space) {
  double k1;
  f->space = *space;
  f->m00 = space->q[0];
  f->m01 = 0.5 * space->q[1];
  f->m02 = 0.5 * space->q[3];
  f->m11 = space->q[2];
  f->k = f->m01 * f->m01 - f->m02 * f->m11;
  k1 = f->m01 * f->m01 - f->m00 * f->m11;
  f->vanishing = VANISHES * (f->m11 * f->h + f->m00 * f->m11 * (f->ni + f->nf));
  f->d0 = ph_vec3_along(ph_vec3_scale(f->m11, f->dp), k1, f->sum);
}

/* What is no direction of dp, beyond doubt. */
static double noise_of(const struct ph_spatial_data *data) {
  return PLANAR * ph_vec3_abs(data->dp) + PLANAR_NOISE * data->noise;
}

double ph_spatial_flatness(const struct ph_spatial_data *data) {
  return noise_of(data) + data->planarity * ph_vec3_abs(data->dp);
}

/* What depends on |Di| and |Df|, and on psi. */
static void set_speeds(struct ph_spatial_family *f, double ni, double nf) {
  f->half[0] = sqrt(0.5 * (1 + f->c));
  f->half[1] = 0.5 * f->s / f->half[0];
  f->ni = ni;
  f->nf = nf;
  f->root[0] = sqrt(ni);
  f->root[1] = sqrt(nf);
  f->m = f->root[0] * f->root[1];
  f->sum = ph_vec3_of(f->c * (ni + nf), f->s * (nf - ni), 0);
}

struct ph_spatial_family
ph_spatial_family_of(const struct ph_spatial_data *data,
                     const struct ph_atph *space) {
  struct ph_spatial_family f;
  f.h = ph_vec3_abs(data->dp);
  set_frame(&f, data);
  f.dp = ph_vec3_of(ph_vec3_dot(data->dp, f.axis[0]),
                    ph_vec3_dot(data->dp, f.axis[1]),
                    ph_vec3_dot(data->dp, f.axis[2]));
  set_speeds(&f, data->ni, data->nf);
  f.noise = noise_of(data);
  f.flatness = ph_spatial_flatness(data);
  f.planar = f.s * fabs(f.dp.z) <= f.noise;
  set_plane(&f, data);
  ph_spatial_family_space(&f, space);
  return f;
}

/* x in BITS binary digits, but to no more than `place' of them after the
 * point. */
static double rounded(double x, int place) {
  int exponent;
  double digits = frexp(x, &exponent);
  int after = BITS - exponent < place ? BITS - exponent : place;
  return ldexp(nearbyint(ldexp(digits, exponent + after)), -after);
}

void ph_spatial_family_round(struct ph_spatial_family *f) {
  struct ph_atph space = f->space;
  const double unit = 1 / f->h;
  if (f->flat) {
    return;
  }
  f->dp =
      ph_vec3_of(rounded(unit * f->dp.x, PLACE), rounded(unit * f->dp.y, PLACE),
                 rounded(unit * f->dp.z, PLACE));
  f->h = ph_vec3_abs(f->dp);
  f->noise *= unit;
  f->flatness *= unit;
  if (f->c > f->s) {
    f->s = rounded(f->s, PLACE);
    f->c = sqrt((1 - f->s) * (1 + f->s));
  } else {
    f->c = rounded(f->c, PLACE);
    f->s = sqrt((1 - f->c) * (1 + f->c));
  }
  set_speeds(f, rounded(unit * f->ni, INT_MAX), rounded(unit * f->nf, INT_MAX));
  ph_spatial_family_space(f, &space);
}

double ph_spatial_length(const struct ph_spatial_family *f, ph_cplx b) {
  /* The integral of |A|^2, with A1 = (D - m01 (A0 + A2)) / m11. */
  double around = (f->m00 * f->m11 - f->m01 * f->m01) * (f->ni + f->nf);
  return (ph_vec3_abs(ph_spatial_d(f, b)) + around -
          2 * f->k * f->m * f->c * b.re) /
         f->m11;
}

/* exp(i b/2) from exp(i b), with a real part that is not negative. */
static inline ph_cplx half_of(ph_cplx b) {
  double large = sqrt(0.5 * (1 + fabs(b.re)));
  double small = 0.5 * fabs(b.im) / large;
  return b.re >= 0 ? ph_cplx_of(large, copysign(small, b.im))
                   : ph_cplx_of(small, copysign(large, b.im));
}

/* A0 and A2 of (2), in the frame of the data. */
static inline void ends_of(const struct ph_spatial_family *f, ph_cplx b,
                           ph_quat *a0, ph_quat *a2) {
  ph_cplx e = half_of(b);
  double c = f->half[0], s = f->half[1];
  *a0 = ph_quat_scale(f->root[0],
                      ph_quat_of(c * e.im, c * e.re, -s * e.re, -s * e.im));
  *a2 = ph_quat_scale(f->root[1],
                      ph_quat_of(-c * e.im, c * e.re, s * e.re, -s * e.im));
}

/* 2 |d| times the projection of Q on the plane of the circle D i D* = d, which
 * is P = (|d| Q - d Q i) / (2 |d|). */
static inline ph_quat project(ph_quat q, ph_vec3 d, double size) {
  ph_quat p = ph_quat_turn(ph_quat_mul(ph_quat_pure(d), q), ph_cplx_of(0, 1));
  return ph_quat_sub(ph_quat_scale(size, q), p);
}

/* The point of that circle nearest to Q: the projection, scaled to sqrt|d|.
 * Q is made of quaternions whose squares sum up to `whole2`; false where the
 * projection is rounding of these.  One that is short has the rounding errors
 * of Q, which are projected away. */
static inline bool nearest_point(ph_quat q, double whole2, ph_vec3 d,
                                 double size, ph_quat *nearest) {
  ph_quat p = project(q, d, size);
  double length2 = ph_quat_dot(p, p);
  whole2 *= size * size;
  if (!(length2 > SHORT * SHORT * whole2)) {
    if (!(length2 > NO_PHASE * NO_PHASE * whole2)) {
      return false;
    }
    p = project(ph_quat_scale(1 / sqrt(length2), p), d, size);
    length2 = ph_quat_dot(p, p);
  }
  *nearest = ph_quat_scale(sqrt(size / length2), p);
  return true;
}

/* Whether exp(i b) is that of a member in the plane, or its opposite. */
static inline bool is_plane_b(const struct ph_spatial_family *f, ph_cplx b) {
  return f->flat && fabs(ph_cplx_cross(f->plane_b, b)) <= NOT_REAL;
}

/*
 * D(0) in the plane of the data, up to a few times what these leave it, where
 * A0 and A2 are.
 *
 * D and -D are A0 turned about the normal n of the plane, by angles in which
 * d is in the direction of ti turned twice.  They are nearest to A0 or n A0, or
 * to their opposites, and one of them is nearest to A0 + A2, or where this does
 * not tell, to A0, to A2: the direction of A0 + A2 may be rounding of the data.
 * Directions uncertain by e turn A0, A2 and D, so that the product of D with
 * one of them changes by e times that with what is at right angles to it, and
 * by squares.
 */
static ph_quat plane_d(const struct ph_spatial_family *f, ph_cplx b, ph_quat a0,
                       ph_quat a2) {
  ph_vec3 d = ph_spatial_d(f, b);
  double size = ph_vec3_abs(d), turned = f->flatness / f->h, unclear;
  const ph_quat n = ph_quat_pure(f->normal);
  bool ahead = d.x * f->c - d.y * f->s >= 0;
  ph_quat to[3] = {ph_quat_add(a0, a2), a0, a2}, nearest = {0, 0, 0, 0};
  if (!(size > f->vanishing) || !nearest_point(ahead ? a0 : ph_quat_mul(n, a0),
                                               f->ni, d, size, &nearest)) {
    return nearest;
  }
  unclear = (NO_PHASE + turned * turned) * (f->root[0] + f->root[1]);
  unclear += turned * sqrt(ph_quat_dot(to[0], to[0]));
  unclear *= sqrt(size);
  unclear += turned * (fabs(ph_quat_dot(nearest, ph_quat_mul(n, a0))) +
                       fabs(ph_quat_dot(nearest, ph_quat_mul(n, a2))));
  for (size_t i = 0; i < 3; i++) {
    double side = ph_quat_dot(nearest, to[i]);
    if (fabs(side) > unclear) {
      return side > 0 ? nearest : ph_quat_scale(-1, nearest);
    }
  }
  return nearest;
}

/* D(0) of (4).  Where the phase is not determined, those of A0 and A2 do as
 * well; and where d is opposite to both tangents, k A0 or k A2. */
static inline ph_quat nearest_d(const struct ph_spatial_family *f, ph_cplx b,
                                ph_quat a0, ph_quat a2) {
  const ph_quat k = ph_quat_of(0, 0, 0, 1);
  ph_vec3 d = ph_spatial_d(f, b);
  double size = ph_vec3_abs(d), whole2 = f->ni + f->nf;
  ph_quat nearest = {0, 0, 0, 0};
  if (is_plane_b(f, b)) {
    return plane_d(f, b, a0, a2);
  }
  if (size > f->vanishing &&
      !nearest_point(ph_quat_add(a0, a2), whole2, d, size, &nearest) &&
      !nearest_point(a0, whole2, d, size, &nearest) &&
      !nearest_point(a2, whole2, d, size, &nearest)) {
    nearest_point(ph_quat_mul(k, f->ni >= f->nf ? a0 : a2), whole2, d, size,
                  &nearest);
  }
  return nearest;
}

void ph_spatial_preimage(const struct ph_spatial_family *f,
                         struct ph_spatial_member member, ph_quat a[3]) {
  ph_quat d;
  ends_of(f, member.b, &a[0], &a[2]);
  d = ph_quat_turn(nearest_d(f, member.b, a[0], a[2]), member.phi);
  a[1] = ph_quat_scale(
      1 / f->m11,
      ph_quat_sub(d, ph_quat_scale(f->m01, ph_quat_add(a[0], a[2]))));
}

bool ph_spatial_in_plane(const struct ph_spatial_family *f, ph_cplx b,
                         double *angle) {
  ph_cplx e = f->plane_b;
  bool plane = is_plane_b(f, b);
  if (plane) {
    b = ph_cplx_dot(e, b) > 0 ? e : ph_cplx_scale(-1, e);
  }
  *angle = atan2(b.im + 0.0, b.re);
  return plane;
}

bool ph_spatial_is_plane(const struct ph_spatial_family *f,
                         const ph_quat a[3]) {
  /* As dp is, three legs of five say it. */
  ph_vec3 second = ph_quat_i(a[0], a[1]), fourth = ph_quat_i(a[1], a[2]);
  double size = f->h + ph_vec3_abs(second) + ph_vec3_abs(fourth);
  double away = (NOT_PLANE + AWAY * (f->away + f->noise / f->h)) * size;
  return fabs(ph_vec3_dot(second, f->normal)) <= away &&
         fabs(ph_vec3_dot(fourth, f->normal)) <= away;
}

/* ---- angles about another axis -------------------------------------- */

/* The unit bisector of the axis and the direction of v. */
static bool bisector(ph_vec3 axis, ph_vec3 v, ph_quat *n) {
  double size = ph_vec3_abs(v);
  ph_vec3 sum = ph_vec3_along(axis, 1 / size, v);
  double length = ph_vec3_abs(sum);
  *n = ph_quat_pure(ph_vec3_scale(1 / length, sum));
  return length > OPPOSITE;
}

/* The axis in the frame of the data. */
static ph_vec3 axis_of(const struct ph_spatial_family *f,
                       enum ph_spatial_axis axis) {
  return axis == PH_SPATIAL_X
             ? ph_vec3_of(f->axis[0].x, f->axis[1].x, f->axis[2].x)
             : ph_vec3_scale(1 / f->h, f->dp);
}

/* A unit quaternion q that turns i into the axis: A -> A q changes from the
 * axis to i. */
static ph_quat turn_to(ph_vec3 axis) {
  ph_vec3 v = ph_vec3_any_normal(axis);
  return ph_quat_of_frame(axis, v, ph_vec3_cross(axis, v));
}

/* exp(i x) of a = n q exp(x i) |a|, with the unit vector n, and q as above. */
static ph_cplx phase_of(ph_quat a, ph_quat n, ph_quat q) {
  ph_quat e = ph_quat_between(ph_quat_mul(n, q), a);
  return ph_cplx_scale(1 / hypot(e.u, e.v), ph_cplx_of(e.u, e.v));
}

static double angle_of(ph_cplx e) {
  return atan2(e.im, e.re);
}

static ph_vec3 tangent(const struct ph_spatial_family *f, double side) {
  return ph_vec3_of(f->c, side * f->s, 0);
}

/* In (-pi, pi]. */
static double wrapped(double angle) {
  double x = angle - 2 * PH_PI * ceil((angle - PH_PI) / (2 * PH_PI));
  return fabs(x) >= PH_PI ? PH_PI : x; /* which rounding may have left */
}

bool ph_spatial_angles(const struct ph_spatial_family *f,
                       struct ph_spatial_member member,
                       enum ph_spatial_axis axis, double angles[2]) {
  ph_vec3 u = axis_of(f, axis), d = ph_spatial_d(f, member.b);
  double size = ph_vec3_abs(d), x0, x2, middle;
  ph_quat a0, a2, n0, n2, nd, q = turn_to(u);
  if (axis == PH_SPATIAL_BISECTOR) {
    angles[0] = atan2(member.phi.im, member.phi.re);
    angles[1] = atan2(member.b.im, member.b.re);
    return true;
  }
  if (!bisector(u, tangent(f, -1), &n0) || !bisector(u, tangent(f, 1), &n2)) {
    return false;
  }
  ends_of(f, member.b, &a0, &a2);
  x0 = angle_of(phase_of(a0, n0, q));
  x2 = angle_of(phase_of(a2, n2, q));
  angles[1] = wrapped(x2 - x0);
  middle = x0 + 0.5 * angles[1];
  angles[0] = 0;
  if (size > f->vanishing) {
    ph_quat at = ph_quat_turn(nearest_d(f, member.b, a0, a2), member.phi);
    if (!bisector(u, d, &nd)) {
      return false;
    }
    angles[0] = wrapped(middle - angle_of(phase_of(at, nd, q)));
  }
  return true;
}

bool ph_spatial_member_of(const struct ph_spatial_family *f,
                          const double angles[2], enum ph_spatial_axis axis,
                          struct ph_spatial_member *member) {
  ph_vec3 u = axis_of(f, axis), d;
  double size;
  ph_quat a0, a2, n0, n2, nd, q = turn_to(u);
  ph_quat n = ph_quat_of(0, f->half[0], -f->half[1], 0);
  ph_cplx e0, e2, gauge;
  const ph_quat one = ph_quat_of(1, 0, 0, 0);
  if (axis == PH_SPATIAL_BISECTOR) {
    member->phi = ph_cplx_polar(angles[0]);
    member->b = ph_cplx_polar(angles[1]);
    return true;
  }
  if (!bisector(u, tangent(f, -1), &n0) || !bisector(u, tangent(f, 1), &n2)) {
    return false;
  }
  a0 = ph_quat_turn(ph_quat_mul(n0, q),
                    ph_cplx_polar(angles[0] - 0.5 * angles[1]));
  a2 = ph_quat_turn(ph_quat_mul(n2, q),
                    ph_cplx_polar(angles[0] + 0.5 * angles[1]));
  e0 = phase_of(a0, n, one);
  e2 = phase_of(a2, ph_quat_of(0, f->half[0], f->half[1], 0), one);
  member->b = ph_cplx_mul(e2, ph_cplx_conj(e0));
  member->phi = ph_cplx_of(1, 0);
  gauge = ph_cplx_mul(e0, half_of(member->b));
  d = ph_spatial_d(f, member->b);
  size = ph_vec3_abs(d);
  if (size > f->vanishing) {
    if (!bisector(u, d, &nd)) {
      return false;
    }
    ends_of(f, member->b, &a0, &a2);
    nd = ph_quat_turn(ph_quat_mul(nd, q), ph_cplx_conj(gauge));
    member->phi = phase_of(nd, nearest_d(f, member->b, a0, a2), one);
  }
  return true;
}

/* ---- the criterion CC ----------------------------------------------- */

struct ph_spatial_member ph_spatial_cc(const struct ph_spatial_family *f) {
  /* w = 3 dp - (Di + Df) is m E(b) of a cubic: exp(i b) is the direction of
   * (s w.g+, -3 dp.gh). */
  struct ph_spatial_member member = {{1, 0}, {1, 0}};
  double x = 3 * f->dp.x - f->sum.x;
  double re = f->s * x, im = -3 * f->dp.z;
  double size = sqrt(re * re + im * im), per_size = 1 / size;
  if (f->planar || size <= 1e-14 * (3 * f->h + f->ni + f->nf)) {
    double along = x * f->plane_b.re - 3 * f->s * f->dp.z * f->plane_b.im;
    member.b = ph_cplx_scale(along >= 0 ? 1 : -1, f->plane_b);
  } else {
    member.b = ph_cplx_of(re * per_size, im * per_size);
  }
  return member;
}
