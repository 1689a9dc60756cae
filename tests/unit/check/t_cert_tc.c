/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The certificate of Tschirnhausen cubics that interpolate: it accepts what is
 * right, and whatever is changed in a curve or its problem, it notices and
 * names.  The curves are chains of preimages.
 */
#include "cert_tc_unit.h"
#include "unit.h"

/* By so much something is changed; the size of all curves here is some 1 to
 * 3. */
static const double MOVED = 1e-9;

/* ---- chains of preimages ------------------------------------------------ */

enum kind { SINGLES, PAIRS, MIXED, DERIVATIVES, KINDS };

/* How many cubics each interval has; 4 in all. */
static const size_t INTERVALS[KINDS][4] = {
    {1, 1, 1, 1}, {2, 2}, {1, 2, 1}, {2, 2}};
static const char *const MODES[KINDS] = {"g1", "g1-pair", "g1-auto", "c1"};
static const ph_cplx NODES[] = {
    {1, 0}, {.8, .5}, {.9, .9}, {.3, 1.1}, {-.4, 1}};
/* One tangent at every point, and one derivative within pairs and where
 * derivatives are given. */
static void chain(enum kind kind, double scale, double offset) {
  size_t point = 0, left = 0;
  double root = sqrt(scale);
  unit_cert_begin();
  unit_cubics_begin(&unit_tc.c, ph_cplx_of(offset, -offset));
  for (size_t k = 0; k < 4; k++) {
    double slower = left > 0 || kind == DERIVATIVES ? 1 : 0.8;
    ph_cplx w = ph_cplx_scale(root * slower, NODES[k]);
    if (left == 0) {
      unit_put(unit_tc.points + 2 * point, unit_tc.c.at);
      unit_put(unit_tc.vectors + 2 * point, ph_cplx_mul(w, w));
      left = INTERVALS[kind][point];
      point++;
    }
    unit_cubics_add(&unit_tc.c, w, ph_cplx_scale(root, NODES[k + 1]));
    left--;
  }
  unit_put(unit_tc.points + 2 * point, unit_tc.c.at);
  unit_put(unit_tc.vectors + 2 * point,
           ph_cplx_scale(scale, ph_cplx_mul(NODES[4], NODES[4])));
  unit_set_array(&unit_tc.problem, PH_F_POINTS, unit_tc.points, point + 1, 2);
  unit_set_array(&unit_tc.problem,
                 kind == DERIVATIVES ? PH_F_DERIVATIVES : PH_F_TANGENTS,
                 unit_tc.vectors, point + 1, 2);
  unit_set_word(&unit_tc.problem, PH_F_MODE, MODES[kind]);
}

/* Whether cubic k begins (end = 0) or ends at a point of the data. */
static bool at_point(enum kind kind, size_t k, size_t end) {
  size_t first = 0;
  for (size_t i = 0; i < 4; first += INTERVALS[kind][i], i++) {
    if (k + end == first) {
      return true;
    }
  }
  return k + end == 4;
}

PH_TEST_EACH(test_chains, KINDS) {
  static const double scales[] = {1e-9, 1, 1e9, 1e-290, 1e290};
  for (size_t i = 0; i < 5; i++) {
    for (int far = 0; far < 2; far++) {
      double tiny = far ? 3e-9 : 5e-15;
      chain((enum kind)_i, scales[i], far ? 1e6 * scales[i] : 0);
      ck_accepted();
      ck_abs(value_of(PH_D_INTERPOLATION_ERROR), 0, 0);
      ck_assert_double_le(value_of(PH_D_PYTHAGOREAN_ERROR), tiny);
      ck_assert_double_le(value_of(PH_D_CONTINUITY_ERROR), tiny);
      ck_assert_double_le(value_of(PH_D_LENGTH_ERROR), tiny);
      ck_assert_double_le(value_of(_i == DERIVATIVES ? PH_D_END_DERIVATIVE_ERROR
                                                     : PH_D_TANGENT_ERROR),
                          tiny);
      ck_assert(!is_known(_i == DERIVATIVES ? PH_D_TANGENT_ERROR
                                            : PH_D_END_DERIVATIVE_ERROR));
      ck_assert(!is_known(PH_D_DISTANCE));
      ck_abs(value_of(PH_D_REGULAR), 1, 0);
      ck_abs(value_of(PH_D_SIMPLE), 1, 0);
      ck_abs(value_of(PH_D_LOOPS), 0, 0);
    }
  }
}

/* What the mode is where the problem does not say. */
PH_TEST(test_modes) {
  chain(MIXED, 1, 0);
  unit_tc.problem.field[PH_F_MODE].kind = PH_ABSENT;
  ck_accepted();
  chain(MIXED, 1, 0);
  unit_set_word(&unit_tc.problem, PH_F_MODE, "g1-fair");
  ck_accepted();
  chain(DERIVATIVES, 1, 0);
  unit_tc.problem.field[PH_F_MODE].kind = PH_ABSENT;
  ck_accepted();
  for (size_t kind = SINGLES; kind <= PAIRS; kind++) {
    chain((enum kind)kind, 1, 0);
    unit_set_word(&unit_tc.problem, PH_F_MODE, "g1-auto");
    ck_accepted();
    unit_set_word(&unit_tc.problem, PH_F_MODE,
                  MODES[kind == PAIRS ? SINGLES : PAIRS]);
    ck_assert_int_eq(certify(), PH_E_INTERNAL);
    ck_assert_str_eq(checked.diag.field, "segments");
  }
}

/* The largest curvature and the energies, against those of the cubics. */
PH_TEST(test_shape) {
  double largest = 0;
  chain(MIXED, 100, 0);
  ck_accepted();
  for (size_t k = 0; k < 4; k++) {
    double slow = unit_cubic_slowest(&unit_tc.c, k);
    largest =
        unit_larger(largest, 2 * unit_cubic_bend(&unit_tc.c, k) / slow / slow);
  }
  ck_rel(value_of(PH_D_MAX_CURVATURE), largest, 1e-13);
  /* from 0 to twice the angle of the last node */
  ck_rel(value_of(PH_D_ROTATION_INDEX), 2 * atan2(1, -.4) / 6.283185307179586,
         1e-13);
  ck_rel(value_of(PH_D_ABSOLUTE_ROTATION_INDEX),
         2 * atan2(1, -.4) / 6.283185307179586, 1e-13);
  ck_assert_double_gt(value_of(PH_D_ENERGY), 0);
}

/* Each coordinate of each control point, one after the other. */
PH_TEST_EACH(test_control_points, KINDS) {
  enum kind kind = (enum kind)_i;
  chain(kind, 1, 0);
  for (size_t i = 0; i < 32; i++) {
    size_t k = i / 8, end = i % 8 >= 4;
    bool outer = i % 8 < 2 || i % 8 >= 6, at = at_point(kind, k, end);
    double *x = &unit_tc.c.control_points[i], keep = *x;
    *x += MOVED;
    if (outer && at) {
      ck_refused(PH_D_INTERPOLATION_ERROR, k);
    } else if (at && kind == DERIVATIVES) {
      ck_refused(PH_D_END_DERIVATIVE_ERROR, k);
    } else {
      ck_assert_int_eq(certify(), PH_E_NO_CONVERGENCE);
      ck_assert(strstr(checked.diag.message, "tangent_error") != NULL ||
                strstr(checked.diag.message, "pythagorean_error") != NULL);
    }
    *x = keep;
  }
  ck_accepted();
}

PH_TEST_EACH(test_preimage, KINDS) {
  chain((enum kind)_i, 1, 0);
  ck_each_moved(unit_tc.c.preimage, 16, 4, MOVED, PH_D_PYTHAGOREAN_ERROR);
  for (size_t i = 4; i < 8; i++) {
    unit_tc.c.preimage[i] *= -1; /* its sign has no meaning */
  }
  ck_accepted();
}

/* The first leg longer, with or without its preimage: no square any more. */
PH_TEST(test_not_ph) {
  double *p = unit_tc.c.control_points, *w = unit_tc.c.preimage;
  chain(SINGLES, 1, 0);
  p[2] = p[0] + (1 + MOVED) * (p[2] - p[0]);
  p[3] = p[1] + (1 + MOVED) * (p[3] - p[1]);
  ck_refused(PH_D_PYTHAGOREAN_ERROR, 0);
  w[0] *= 1 + MOVED / 2;
  w[1] *= 1 + MOVED / 2;
  ck_refused(PH_D_PYTHAGOREAN_ERROR, 0);
}

PH_TEST_EACH(test_lengths, KINDS) {
  chain((enum kind)_i, 1, 0);
  ck_each_scaled(unit_tc.c.lengths, 4, MOVED, PH_D_LENGTH_ERROR);
  unit_tc.c.curve.length *= 1 + MOVED;
  ck_refused(PH_D_LENGTH_ERROR, 3);
  unit_tc.c.curve.length = 0;
  ck_assert_int_eq(certify(), PH_E_NO_CONVERGENCE);
}

/* The data: moved points, turned tangents, tangents that are swapped or point
 * backward, other derivatives. */
PH_TEST_EACH(test_data, KINDS) {
  enum kind kind = (enum kind)_i;
  size_t n;
  chain(kind, 1, 0);
  n = unit_tc.problem.field[PH_F_POINTS].n;
  for (size_t i = 0; i < 2 * n; i++) {
    double keep = unit_tc.points[i];
    unit_tc.points[i] += MOVED;
    ck_refused_somewhere(PH_D_INTERPOLATION_ERROR);
    unit_tc.points[i] = keep;
  }
  for (size_t i = 0; i < n; i++) {
    double *v = unit_tc.vectors + 2 * i;
    ph_cplx keep = unit_get(v);
    unit_put(v, ph_cplx_mul(keep, ph_cplx_polar(MOVED)));
    ck_assert_int_eq(certify(), PH_E_NO_CONVERGENCE);
    ck_assert_ptr_nonnull(
        strstr(checked.diag.message,
               kind == DERIVATIVES ? "end_derivative_error" : "tangent_error"));
    unit_put(v, ph_cplx_scale(-1, keep));
    ck_assert_int_eq(certify(), PH_E_NO_CONVERGENCE);
    unit_put(v, ph_cplx_scale(1 + MOVED, keep));
    ck_assert_int_eq(certify(),
                     kind == DERIVATIVES ? PH_E_NO_CONVERGENCE : PH_OK);
    unit_put(v, keep);
  }
  unit_put(unit_tc.vectors, unit_get(unit_tc.vectors + 2));
  ck_refused(
      kind == DERIVATIVES ? PH_D_END_DERIVATIVE_ERROR : PH_D_TANGENT_ERROR, 0);
}

/* Two pairs that are right by themselves, but for what they say where they or
 * their cubics meet. */
PH_TEST(test_joints) {
  for (int i = 0; i < 3; i++) {
    double by = i == 1 ? 1 + 1e-8 : 1;
    ph_cplx turn = ph_cplx_scale(by, ph_cplx_polar(i == 0 ? 1e-8 : 0));
    unit_cert_begin();
    unit_cubics_begin(&unit_tc.c, ph_cplx_of(0, 0));
    unit_cubics_add(&unit_tc.c, NODES[0], NODES[1]);
    unit_cubics_add(&unit_tc.c, ph_cplx_mul(turn, NODES[1]), NODES[2]);
    unit_put(unit_tc.points + 2, unit_tc.c.at);
    unit_put(unit_tc.vectors, ph_cplx_mul(NODES[0], NODES[0]));
    unit_put(unit_tc.vectors + 2, ph_cplx_mul(NODES[2], NODES[2]));
    unit_set_array(&unit_tc.problem, PH_F_POINTS, unit_tc.points, 2, 2);
    unit_set_array(&unit_tc.problem, PH_F_TANGENTS, unit_tc.vectors, 2, 2);
    if (i < 2) {
      ck_refused(PH_D_CONTINUITY_ERROR, 1);
    } else {
      ck_accepted();
      unit_tc.c.control_points[6] += MOVED;
      unit_tc.c.control_points[5] += MOVED;
      ck_assert_int_eq(certify(), PH_E_NO_CONVERGENCE);
    }
  }
}

PH_TEST_EACH(test_knots, KINDS) {
  chain((enum kind)_i, 1, 0);
  for (size_t k = 0; k <= 4; k++) {
    double keep = unit_tc.c.knots[k];
    unit_tc.c.knots[k] += 1e-15;
    if (k > 0) {
      unit_tc.c.knots[k] *= 1.5;
    }
    ck_assert_int_eq(certify(), PH_E_INTERNAL);
    ck_assert_int_eq(strncmp(checked.diag.field, "knots[", 6), 0);
    unit_tc.c.knots[k] = keep;
  }
  ck_accepted();
}

/* Too few or too many cubics, or none of this kind. */
PH_TEST_EACH(test_number, KINDS) {
  chain((enum kind)_i, 1, 0);
  unit_tc.c.curve.n = 1;
  ck_assert_int_eq(certify(), PH_E_INTERNAL);
  ck_assert_str_eq(checked.diag.field, "segments");
  unit_tc.c.curve.n = 3;
  ck_assert_int_ne(certify(), PH_OK);
  unit_tc.c.curve.n = 4;
  unit_tc.problem.field[PH_F_POINTS].n--;
  unit_tc.problem.field[_i == DERIVATIVES ? PH_F_DERIVATIVES : PH_F_TANGENTS]
      .n--;
  ck_assert_int_ne(certify(), PH_OK);
  unit_tc.problem.field[PH_F_POINTS].n++;
  ck_assert_int_eq(certify(), PH_E_INTERNAL);
  ck_assert_str_eq(checked.diag.field, "points");
  chain((enum kind)_i, 1, 0);
  unit_tc.c.curve.degree = 5;
  ck_assert_int_eq(certify(), PH_E_INTERNAL);
  unit_tc.c.curve.degree = 3;
  unit_tc.c.curve.kind = PH_CURVE_PH;
  ck_assert_int_eq(certify(), PH_E_INTERNAL);
}

static void ck_claim(enum ph_diagnostic what, double value) {
  checked.claims = (struct ph_diagnostics){.known = 0};
  ph_diagnostics_set(&checked.claims, what, value);
  ck_accepted();
  ph_diagnostics_set(&checked.claims, what, value * (1 + 1e-6));
  ck_assert_int_eq(certify(), PH_E_INTERNAL);
  ck_assert_str_eq(checked.diag.field, "diagnostics");
}

/* D and lambda of the only interval are those of its legs. */
PH_TEST_EACH(test_claims, 2) {
  const ph_cplx w0 = {1.1, -0.2}, w1 = {0.7, 0.6};
  unit_cert_begin();
  unit_cubics_begin(&unit_tc.c, ph_cplx_of(1, 2));
  unit_put(unit_tc.points, unit_tc.c.at);
  unit_put(unit_tc.vectors, ph_cplx_mul(w0, w0));
  unit_put(unit_tc.vectors + 2, ph_cplx_mul(w1, w1));
  if (_i == 1) {
    unit_cubics_add(&unit_tc.c, w0, ph_cplx_of(0.8, 0.1));
    unit_cubics_add(&unit_tc.c, ph_cplx_of(0.8, 0.1), w1);
  } else {
    unit_cubics_add(&unit_tc.c, w0, w1);
  }
  unit_put(unit_tc.points + 2, unit_tc.c.at);
  unit_set_array(&unit_tc.problem, PH_F_POINTS, unit_tc.points, 2, 2);
  unit_set_array(&unit_tc.problem, PH_F_TANGENTS, unit_tc.vectors, 2, 2);
  unit_set_word(&unit_tc.problem, PH_F_MODE, "g1-auto");
  if (_i == 1) {
    ph_cplx chord = ph_cplx_sub(unit_tc.c.at, ph_cplx_of(1, 2));
    ck_claim(PH_D_LAMBDA, ph_cplx_norm2(w0) / ph_cplx_abs(chord));
  } else {
    ck_claim(PH_D_RATIO, ph_cplx_abs(w1) / ph_cplx_abs(w0));
  }
}

PH_TEST(test_not_finite) {
  chain(MIXED, 1, 0);
  ck_not_finite(unit_tc.c.control_points, 32);
  ck_not_finite(unit_tc.c.preimage, 16);
  ck_not_finite(unit_tc.c.lengths, 4);
  ck_not_finite(unit_tc.c.knots, 4);
  ck_not_finite(&unit_tc.c.curve.length, 1);
  ck_accepted();
}

/* ---- curves that stand still -------------------------------------------- */

/* The sum of the derivatives is three chords: w is 0 at the joint. */
static void cusp(double w) {
  const ph_cplx w0 = {0.8, 0.6}, w2 = {1.2, -0.4};
  unit_cert_begin();
  unit_cubics_begin(&unit_tc.c, ph_cplx_of(0, 0));
  unit_cubics_add(&unit_tc.c, w0, ph_cplx_of(w, 0));
  unit_cubics_add(&unit_tc.c, ph_cplx_of(w, 0), w2);
  unit_put(unit_tc.points + 2, unit_tc.c.at);
  unit_put(unit_tc.vectors, ph_cplx_mul(w0, w0));
  unit_put(unit_tc.vectors + 2, ph_cplx_mul(w2, w2));
  unit_set_array(&unit_tc.problem, PH_F_POINTS, unit_tc.points, 2, 2);
  unit_set_array(&unit_tc.problem, PH_F_DERIVATIVES, unit_tc.vectors, 2, 2);
}

PH_TEST(test_irregular) {
  cusp(0);
  ck_refused(PH_D_REGULAR, 0);
  ck_abs(value_of(PH_D_REGULAR), 0, 0);
  unit_set_word(&unit_tc.problem, PH_F_SOLUTIONS, "all");
  ck_accepted();
  ck_abs(value_of(PH_D_REGULAR), 0, 0);
  ck_abs(value_of(PH_D_SIMPLE), 0, 0);
  ck_assert(!is_known(PH_D_ENERGY));
  ck_assert(!is_known(PH_D_MAX_CURVATURE));
  cusp(1e-11);
  ck_accepted();
  ck_abs(value_of(PH_D_REGULAR), 1, 0);
}

/* The preimage passes through 0 inside a cubic, or close by. */
PH_TEST(test_turns_back) {
  for (int i = 0; i < 2; i++) {
    unit_cert_begin();
    unit_cubics_begin(&unit_tc.c, ph_cplx_of(0, 0));
    unit_cubics_add(&unit_tc.c, ph_cplx_of(1, i ? 1e-6 : 0), ph_cplx_of(-2, 0));
    unit_put(unit_tc.points + 2, unit_tc.c.at);
    unit_put(unit_tc.vectors, ph_cplx_of(1, i ? 2e-6 : 0));
    unit_put(unit_tc.vectors + 2, ph_cplx_of(1, 0));
    unit_tc.vectors[0] -= i ? 1e-12 : 0;
    unit_set_array(&unit_tc.problem, PH_F_POINTS, unit_tc.points, 2, 2);
    unit_set_array(&unit_tc.problem, PH_F_TANGENTS, unit_tc.vectors, 2, 2);
    unit_set_word(&unit_tc.problem, PH_F_MODE, "g1");
    if (i) {
      ck_accepted();
      ck_abs(value_of(PH_D_REGULAR), 1, 0);
      ck_abs(value_of(PH_D_LOOPS), 1, 0);
    } else {
      ck_refused(PH_D_REGULAR, 0);
    }
  }
}
