/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The shape that a curve claims to keep: nothing that the solver found to keep
 * it is refused, and what does not keep it is.
 */
#include "unit.h"
#include "check_unit.h"
#include "spatial_unit.h"
#include "segment_unit.h"

#include "check/shape_spatial.h"
#include "solve/spatial/spatial.h"

/* The certificate's own tolerance of a hodograph, and the rounding of a
 * coordinate of size 1. */
static const double RELATIVE = 1e-13;
static const double ROUNDING = 2.2204460492503131e-16;

static struct unit_hermite3 u;

static void set_mu(const struct ph_atph *space, double mu[5]) {
  const double *q = space->q;
  mu[0] = mu[4] = q[0];
  mu[1] = mu[3] = q[1] / (4 * space->c);
  mu[2] = q[3] / 2;
}

/* The shape of a member, in the frame of its data, from control points that
 * begin at `start`. */
static enum ph_check_shape shape_at(const struct ph_spatial_fit *fit,
                                    ph_vec3 start) {
  const struct ph_spatial_family *f = &fit->family;
  double mu[5], away = ph_vec3_abs(start);
  ph_vec3 p[6], leg[5];
  ph_seg3_control_points(&f->space, fit->a, start, ph_vec3_add(start, f->dp),
                         p);
  for (size_t i = 0; i < 5; i++) {
    leg[i] = ph_vec3_sub(p[i + 1], p[i]);
  }
  set_mu(&f->space, mu);
  return ph_check_shape_of(leg, mu, RELATIVE, ROUNDING * (1 + away), 0);
}

static enum ph_check_shape shape_of(const struct ph_spatial_fit *fit) {
  return shape_at(fit, ph_vec3_of(0, 0, 0));
}

static enum ph_status choose_cc(struct ph_spatial_fit *fit, void *context) {
  (void)context;
  fit->member = ph_spatial_cc(&fit->family);
  return PH_OK;
}

/* Random data; one in three nearly straight. */
static struct ph_spatial_data random_data(struct unit_random *r, int i) {
  struct ph_spatial_data data = unit_random_spatial(r);
  if (i % 3 == 0) {
    double e = pow(10, unit_random_in(r, -9, 0));
    data.ti = ph_vec3_unit(ph_vec3_along(data.dp, e, data.ti));
    data.tf = ph_vec3_unit(ph_vec3_along(data.dp, e, data.tf));
  }
  return data;
}

/* Tension is bisected until a constraint holds by the last digit: the
 * certificate is not stricter than that, wherever the curve is. */
PH_TEST(test_kept) {
  struct unit_random r = unit_random_of(910);
  int n = unit_count(3000), reduced = 0;
  for (int i = 0; i < n; i++) {
    struct ph_spatial_data data = random_data(&r, i);
    struct ph_atph space = unit_random_space(&r);
    struct ph_spatial_tension t;
    ck_assert_int_eq(
        ph_spatial_tension(&data, &space, choose_cc, NULL, 1e-13, &t), PH_OK);
    if (!t.fit.violated) {
      ck_assert_int_eq(shape_of(&t.fit), PH_CHECK_SHAPE_KEPT);
      ck_assert_int_eq(shape_at(&t.fit, ph_vec3_of(1e3, -2e3, 3e3)),
                       PH_CHECK_SHAPE_KEPT);
      reduced += t.factor < 1;
    }
  }
  ck_assert_int_ge(reduced, n / 10);
}

/* Points in a plane but for some units in the last place, a thousand away: what
 * counts as planar has no torsion to keep. */
PH_TEST(test_kept_in_plane) {
  struct unit_random r = unit_random_of(914);
  int n = unit_count(3000), planar = 0;
  for (int i = 0; i < n; i++) {
    struct ph_spatial_data data = unit_random_spatial(&r);
    struct ph_atph space = unit_random_space(&r);
    struct ph_spatial_tension t;
    data.noise = 1024 * 2.2204460492503131e-16;
    data.planarity = 0;
    data.dp.z = unit_random_in(&r, -20, 20) * data.noise;
    data.ni *= i % 2 ? 30 : 1;
    data.nf *= i % 2 ? 30 : 1;
    data.ti.z = data.tf.z = 0;
    data.ti = ph_vec3_unit(data.ti);
    data.tf = ph_vec3_unit(data.tf);
    ck_assert_int_eq(
        ph_spatial_tension(&data, &space, choose_cc, NULL, 1e-13, &t), PH_OK);
    if (!t.fit.violated) {
      ck_assert_int_eq(shape_at(&t.fit, ph_vec3_of(591, 591, 591)),
                       PH_CHECK_SHAPE_KEPT);
      planar += t.fit.family.planar;
    }
  }
  ck_assert_int_ge(planar, n / 10);
}

/* The least of the torsion's sign times that of the data, per its largest. */
static double least_torsion(const struct ph_spatial_fit *fit) {
  const struct ph_spatial_family *f = &fit->family;
  struct ph_seg3 seg = {
      f->space, {fit->a[0], fit->a[1], fit->a[2]}, {0, 0, 0}, {0, 0, 0}};
  double least = HUGE_VAL, largest = 0;
  enum { STEPS = 100 };
  for (int k = 0; k <= STEPS; k++) {
    struct unit_bend3 bend = unit_seg3_bend(&seg, (double)k / STEPS);
    /* [r', r'', r'''] = torsion |r' x r''|^2, |r' x r''| = curvature speed^3 */
    double value = bend.torsion * pow(bend.curvature * pow(bend.speed, 3), 2);
    value *= f->dp.z > 0 ? -1 : 1;
    least = fmin(least, value);
    largest = fmax(largest, fabs(value));
  }
  return least / largest;
}

/* Members that wind the wrong way somewhere, and not by a hair: the torsion is
 * that of the preimage, by another formula. */
PH_TEST(test_torsion) {
  struct unit_random r = unit_random_of(911);
  int n = unit_count(3000), caught = 0, kept = 0;
  for (int i = 0; i < n; i++) {
    struct ph_spatial_data data = unit_random_spatial(&r);
    struct ph_atph space = unit_random_space(&r);
    struct ph_spatial_fit fit;
    double least;
    enum ph_check_shape shape;
    ck_assert_int_eq(ph_spatial_fit_of(&data, &space, choose_cc, NULL, &fit),
                     PH_OK);
    if (i % 2) {
      fit.member.phi = unit_random_phase(&r);
      ph_spatial_preimage(&fit.family, fit.member, fit.a);
    }
    least = least_torsion(&fit);
    shape = shape_of(&fit);
    if (least < -1e-3) {
      ck_assert_int_ne(shape, PH_CHECK_SHAPE_KEPT);
      caught += shape == PH_CHECK_SHAPE_TORSION;
    } else if (least > 1e-9) {
      ck_assert_int_ne(shape, PH_CHECK_SHAPE_TORSION);
      kept += shape == PH_CHECK_SHAPE_KEPT;
    }
  }
  ck_assert_int_ge(caught, n / 20);
  ck_assert_int_ge(kept, n / 20);
}

/* Where only an end is wrong, that is said; the mirror image says the same, the
 * reversed curve that of the other end. */
PH_TEST(test_ends) {
  struct unit_random r = unit_random_of(912);
  int n = unit_count(3000), caught = 0;
  for (int i = 0; i < n; i++) {
    struct ph_spatial_data data = unit_random_spatial(&r);
    struct ph_atph space = unit_random_space(&r);
    struct ph_spatial_fit fit;
    ph_vec3 p[6], leg[5], back[5], mirror[5];
    double mu[5];
    enum ph_check_shape shape, other;
    ck_assert_int_eq(ph_spatial_fit_of(&data, &space, choose_cc, NULL, &fit),
                     PH_OK);
    unit_spatial_points(&fit.family, fit.member, p);
    set_mu(&space, mu);
    for (size_t k = 0; k < 5; k++) {
      leg[k] = ph_vec3_sub(p[k + 1], p[k]);
      back[4 - k] = ph_vec3_scale(-1, leg[k]);
      mirror[k] = ph_vec3_of(leg[k].x, -leg[k].y, leg[k].z);
    }
    shape = ph_check_shape_of(leg, mu, RELATIVE, ROUNDING, 0);
    other = ph_check_shape_of(back, mu, RELATIVE, ROUNDING, 0);
    ck_assert_int_eq(ph_check_shape_of(mirror, mu, RELATIVE, ROUNDING, 0),
                     shape);
    if (fit.violated == PH_SHAPE_START) {
      ck_assert_int_eq(shape, PH_CHECK_SHAPE_START);
      ck_assert_int_eq(other, PH_CHECK_SHAPE_END);
      caught++;
    } else if (fit.violated == PH_SHAPE_END) {
      ck_assert_int_eq(shape, PH_CHECK_SHAPE_END);
      ck_assert_int_eq(other, PH_CHECK_SHAPE_START);
      caught++;
    }
  }
  ck_assert_int_ge(caught, n / 50);
}

/* (1) of shape.c for quintics that need not be PH: the determinant straight
 * from the differences of control points. */
PH_TEST(test_any_quintic) {
  static const double mu[5] = {1. / 5, 1. / 20, 1. / 30, 1. / 20, 1. / 5};
  struct unit_random r = unit_random_of(913);
  int n = unit_count(3000), caught = 0, kept = 0;
  for (int i = 0; i < n; i++) {
    ph_vec3 leg[5], dp = {0, 0, 0};
    double least = HUGE_VAL, largest = 0, sign;
    enum ph_check_shape shape;
    /* Near a helix: many of these wind one way. */
    for (size_t k = 0; k < 5; k++) {
      ph_vec3 along = {cos(0.5 * (double)k), sin(0.5 * (double)k), 0.5};
      leg[k] = ph_vec3_along(along, 1, unit_random_vec3(&r, 0.2));
      dp = ph_vec3_add(dp, leg[k]);
    }
    sign = copysign(1, ph_vec3_triple(leg[0], dp, leg[4]));
    for (int j = 0; j <= 64; j++) {
      ph_vec3 d[5];
      double t = (double)j / 64, value;
      memcpy(d, leg, sizeof d);
      for (size_t m = 4; m > 2; m--) {
        for (size_t k = 0; k < m; k++) {
          d[k] = ph_vec3_add(ph_vec3_scale(1 - t, d[k]),
                             ph_vec3_scale(t, d[k + 1]));
        }
      }
      /* now the quadratic whose points determine r', r'', r''' at t */
      value = sign * ph_vec3_triple(d[0], d[1], d[2]);
      least = fmin(least, value);
      largest = fmax(largest, fabs(value));
    }
    shape = ph_check_shape_of(leg, mu, RELATIVE, ROUNDING, 0);
    if (least < -1e-3 * largest) {
      ck_assert_int_ne(shape, PH_CHECK_SHAPE_KEPT);
      caught += shape == PH_CHECK_SHAPE_TORSION;
    } else if (least > 1e-9 * largest) {
      ck_assert_int_ne(shape, PH_CHECK_SHAPE_TORSION);
      kept += shape == PH_CHECK_SHAPE_KEPT;
    }
  }
  ck_assert_int_ge(caught, n / 20);
  ck_assert_int_ge(kept, n / 20);
}

/* Plane data have no torsion to keep, straight ones no side to bend to. */
PH_TEST(test_void) {
  static const double mu[5] = {1. / 5, 1. / 20, 1. / 30, 1. / 20, 1. / 5};
  ph_vec3 leg[5], none[5];
  for (size_t k = 0; k < 5; k++) {
    double x = 0.3 * (double)k;
    /* rounding makes up some torsion */
    leg[k] = ph_vec3_of(cos(x), sin(x), k % 2 ? 1e-16 : -1e-16);
    none[k] = ph_vec3_of(1 + 0.1 * x, k % 2 ? 1e-16 : -1e-16, 0);
  }
  ck_assert_int_eq(ph_check_shape_of(leg, mu, RELATIVE, ROUNDING, 0),
                   PH_CHECK_SHAPE_KEPT);
  ck_assert_int_eq(ph_check_shape_of(none, mu, RELATIVE, ROUNDING, 0),
                   PH_CHECK_SHAPE_KEPT);
  leg[1].y = -0.3;
  ck_assert_int_eq(ph_check_shape_of(leg, mu, RELATIVE, ROUNDING, 0),
                   PH_CHECK_SHAPE_START);
  leg[1].y = nan("");
  ck_assert_int_ne(ph_check_shape_of(leg, mu, RELATIVE, ROUNDING, 0),
                   PH_CHECK_SHAPE_KEPT);
}

/* ---- as part of the certificate ------------------------------------- */

enum { POINTS = 6 };

/* A helix with its derivatives by its angle, times the step. */
static void helix(double step, double alpha) {
  double points[3 * POINTS], vectors[3 * POINTS];
  for (size_t k = 0; k < POINTS; k++) {
    double x = step * (double)k, *p = points + 3 * k, *v = vectors + 3 * k;
    p[0] = cos(x);
    p[1] = sin(x);
    p[2] = 0.5 * x;
    v[0] = -step * sin(x);
    v[1] = step * cos(x);
    v[2] = 0.5 * step;
    for (size_t i = 0; i < 3; i++) {
      v[i] /= alpha > 0 ? alpha : 1;
    }
  }
  unit_hermite3_of(&u, points, PH_F_DERIVATIVES, vectors, POINTS, 3, false,
                   alpha);
}

static void claim(bool shape_ok) {
  for (size_t k = 0; k < u.curve.n; k++) {
    u.shape_ok[k] = shape_ok;
  }
}

PH_TEST_EACH(test_claimed, 2) {
  helix(0.8, _i ? 0.8 : 0);
  claim(true);
  ck_assert_int_eq(certify(), PH_OK);
  ck_abs(checked.diagnostics.value[PH_D_SHAPE_OK], 1, 0);
  u.shape_ok[2] = false;
  ck_assert_int_eq(certify(), PH_OK);
  ck_abs(checked.diagnostics.value[PH_D_SHAPE_OK], 0, 0);
}

/* Another member of the family has the same ends, and the wrong shape. */
PH_TEST_EACH(test_wrongly_claimed, 2) {
  helix(0.8, _i ? 0.8 : 0);
  unit_hermite3_build(&u, 2);
  ck_assert_int_eq(certify(), PH_OK);
  for (size_t k = 0; k < u.curve.n; k++) {
    char wanted[32] = "segments[0]";
    wanted[9] = (char)('0' + (int)k);
    claim(false);
    u.shape_ok[k] = true;
    ck_assert_int_eq(certify(), PH_E_NO_CONVERGENCE);
    ck_assert_str_eq(checked.diag.field, wanted);
    ck_assert_ptr_nonnull(
        strstr(checked.diag.message, "shape_ok is claimed, but"));
  }
  claim(false);
  ck_assert_int_eq(certify(), PH_OK);
}

/* ---- fairness ------------------------------------------------------- */

/* A helix (cos x, sin x, x) as an ATPH curve has curvature and torsion 1/2. */
PH_TEST(test_fairness) {
  const double step = 1.2, length = sqrt(2) * step, n = POINTS - 1;
  double points[3 * POINTS], vectors[3 * POINTS];
  for (int e = -400; e <= 400; e += 200) {
    double scale = ldexp(1, e);
    for (size_t k = 0; k < POINTS; k++) {
      double x = step * (double)k, *p = points + 3 * k, *v = vectors + 3 * k;
      p[0] = scale * cos(x);
      p[1] = scale * sin(x);
      p[2] = scale * x;
      v[0] = -2 * scale * sin(x);
      v[1] = 2 * scale * cos(x);
      v[2] = 2 * scale;
    }
    unit_hermite3_of(&u, points, PH_F_DERIVATIVES, vectors, POINTS, 3, false,
                     step / 2);
    ck_assert_int_eq(certify(), PH_OK);
    ck_rel(u.curve.length, scale * n * length, 1e-5);
    ck_rel(value_of(PH_D_ENERGY) * scale, 0.25 * n * length, 1e-4);
    ck_rel(value_of(PH_D_F1), 0.25 * n * length * length, 1e-4);
    ck_assert_double_le(value_of(PH_D_F2), value_of(PH_D_F3));
    ck_assert_double_le(value_of(PH_D_F3), 0.2);
  }
}

/* A segment whose z (curve/segment/seg3.h) vanishes at u = 1/2, out of a plane:
 * the torsion is finite on either side. */
PH_TEST(test_inflection) {
  const ph_quat a[3] = {{1, 0, 0, 0}, {-1, 0, 0.2, 0.9}, {1, 0, 0.7, -0.4}};
  struct ph_seg3 seg = unit_seg3(0, a, ph_vec3_of(0, 0, 0));
  const double points[] = {0, 0, 0, seg.end.x, seg.end.y, seg.end.z};
  const double any[] = {1, 0, 0, 1, 0, 0};
  ph_vec3 p[6];
  ck_abs(unit_seg3_bend(&seg, 0.5).curvature, 0, 1e-15);
  unit_hermite3_of(&u, points, PH_F_TANGENTS, any, 2, 3, false, 0);
  u.problem.field[PH_F_TANGENTS].kind = PH_ABSENT;
  ph_seg3_control_points(&seg.space, a, seg.start, seg.end, p);
  memcpy(u.control_points, p, sizeof p);
  memcpy(u.preimage, a, sizeof a);
  u.curve.length = u.lengths[0] = ph_seg3_length(&seg.space, a);
  ck_assert_int_eq(certify(), PH_OK);
  ck_assert_double_ge(value_of(PH_D_F1), 1);
  ck_assert_double_ge(value_of(PH_D_F2), 1);
  ck_assert_double_gt(value_of(PH_D_F3), value_of(PH_D_F2));
}

/* A curve that is refused is not described. */
PH_TEST(test_no_fairness) {
  helix(0.8, 0);
  u.curve.lengths[1] *= 1.1;
  ck_assert_int_eq(certify(), PH_E_NO_CONVERGENCE);
  ck_assert(!(checked.diagnostics.known >> PH_D_ENERGY & 1));
  ck_assert(!(checked.diagnostics.known >> PH_D_F1 & 1));
}

static void start(void) {
  checked.command = "spatial-hermite";
  checked.problem = &u.problem;
  checked.curve = &u.curve;
}

PH_FIXTURE(start, NULL)
