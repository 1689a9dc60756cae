/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The certificate of splines of Tschirnhausen cubics, and of pairs with their
 * joint on the chord: what lambda, the rules for tangents and ends, and the
 * joint promise.
 */
#include "cert_tc_unit.h"
#include "unit.h"

/* By so much something is changed; the size of all curves here is some 1 to
 * 3. */
static const double MOVED = 1e-9;

/* ---- splines ------------------------------------------------------------ */

static const double SOME[2 * UNIT_TC_POINTS] = {0, 0, 2, 1, 3, 0, 5, 2, 4, 4};

static ph_cplx chord(size_t k, size_t n) {
  return ph_cplx_sub(unit_get(unit_tc.points + 2 * ((k + 1) % n)),
                     unit_get(unit_tc.points + 2 * k));
}

/* The derivatives of a spline with lambda, ends along the chords. */
static void set_derivatives(bool closed, double lambda) {
  for (size_t k = 0; k < UNIT_TC_POINTS; k++) {
    ph_cplx before = chord(k > 0 ? k - 1 : UNIT_TC_POINTS - 1, UNIT_TC_POINTS);
    ph_cplx after = chord(k, UNIT_TC_POINTS);
    double a, b;
    if (!closed && k == 0) {
      before = after;
    }
    if (!closed && k + 1 == UNIT_TC_POINTS) {
      after = before;
    }
    a = ph_cplx_abs(before);
    b = ph_cplx_abs(after);
    unit_put(unit_tc.vectors + 2 * k,
             ph_cplx_scale(
                 lambda * (a < b ? a : b),
                 unit_unit(ph_cplx_add(unit_unit(before), unit_unit(after)))));
  }
}

static void add_pairs(bool closed) {
  size_t n = closed ? UNIT_TC_POINTS : UNIT_TC_POINTS - 1;
  unit_cubics_begin(&unit_tc.c, unit_get(unit_tc.points));
  unit_tc.c.curve.closed = closed;
  for (size_t k = 0; k < n; k++) {
    size_t to = (k + 1) % UNIT_TC_POINTS;
    unit_add_pair(unit_get(unit_tc.vectors + 2 * k),
                  unit_get(unit_tc.vectors + 2 * to), chord(k, UNIT_TC_POINTS),
                  unit_tc.points + 2 * to);
  }
}

static void spline(bool closed, double lambda, double scale, double offset) {
  unit_cert_begin();
  for (size_t i = 0; i < 2 * UNIT_TC_POINTS; i++) {
    unit_tc.points[i] = offset + scale * SOME[i];
  }
  unit_set_array(&unit_tc.problem, PH_F_POINTS, unit_tc.points, UNIT_TC_POINTS,
                 2);
  unit_tc.problem.field[PH_F_CLOSED] =
      (struct ph_value){.kind = PH_BOOL, .flag = closed};
  unit_set_word(&unit_tc.problem, PH_F_MODE, "spline");
  set_derivatives(closed, lambda);
  add_pairs(closed);
}

PH_TEST_EACH(test_splines, 2) {
  static const double scales[] = {1e-9, 1, 1e9};
  for (size_t i = 0; i < 3; i++) {
    for (int far = 0; far < 2; far++) {
      spline(_i, 0.5, scales[i], far ? 1e6 * scales[i] : 0);
      ck_accepted();
      ck_abs(value_of(PH_D_INTERPOLATION_ERROR), 0, 0);
      for (int d = PH_D_END_DERIVATIVE_ERROR; d <= PH_D_LENGTH_ERROR; d++) {
        ck_assert_double_le(value_of((enum ph_diagnostic)d),
                            far ? 3e-8 : 1e-14);
      }
    }
  }
}

/* A closed one whose first point is given again. */
PH_TEST(test_repeated) {
  double again[2 * UNIT_TC_POINTS + 2];
  spline(true, 0.5, 1, 0);
  memcpy(again, unit_tc.points, sizeof unit_tc.points);
  memcpy(again + 2 * UNIT_TC_POINTS, unit_tc.points, 2 * sizeof(double));
  unit_set_array(&unit_tc.problem, PH_F_POINTS, again, UNIT_TC_POINTS + 1, 2);
  ck_accepted();
  again[2 * UNIT_TC_POINTS] += 1e-6;
  ck_assert_int_eq(certify(), PH_E_INTERNAL);
}

PH_TEST_EACH(test_lambda, 2) {
  spline(_i, 0.5, 1, 0);
  unit_set_number(&unit_tc.problem, PH_F_LAMBDA, 0.5);
  ck_accepted();
  unit_set_number(&unit_tc.problem, PH_F_LAMBDA, 0.5 * (1 + MOVED));
  ck_refused_somewhere(PH_D_END_DERIVATIVE_ERROR);
  spline(_i, 0.8, 1, 0);
  ck_refused_somewhere(PH_D_END_DERIVATIVE_ERROR);
  unit_set_number(&unit_tc.problem, PH_F_LAMBDA, 0.8);
  ck_accepted();
}

/* The same curve as pairs with tangents, whose lengths are by lambda if that is
 * given. */
PH_TEST_EACH(test_tangents_with_lambda, 2) {
  spline(_i, 0.7, 1, 0);
  unit_set_array(&unit_tc.problem, PH_F_TANGENTS, unit_tc.vectors,
                 UNIT_TC_POINTS, 2);
  unit_set_word(&unit_tc.problem, PH_F_MODE, "g1-pair");
  ck_accepted();
  ck_assert(!is_known(PH_D_END_DERIVATIVE_ERROR));
  unit_set_number(&unit_tc.problem, PH_F_LAMBDA, 0.7);
  ck_accepted();
  ck_assert_double_le(value_of(PH_D_END_DERIVATIVE_ERROR), 1e-14);
  unit_set_number(&unit_tc.problem, PH_F_LAMBDA, 0.7 * (1 + MOVED));
  ck_refused_somewhere(PH_D_END_DERIVATIVE_ERROR);
}

/* Each tangent of a spline in turn is another: directions are those of
 * [BYR11, (5.24)]. */
PH_TEST_EACH(test_bisectors, 2) {
  for (size_t k = 0; k < UNIT_TC_POINTS; k++) {
    spline(_i, 0.5, 1, 0);
    unit_put(
        unit_tc.vectors + 2 * k,
        ph_cplx_mul(unit_get(unit_tc.vectors + 2 * k), ph_cplx_polar(MOVED)));
    add_pairs(_i);
    ck_refused_somewhere(PH_D_TANGENT_ERROR);
  }
}

/* An open curve that comes back to its start is not closed for that. */
PH_TEST(test_not_closed) {
  spline(true, 0.5, 1, 0);
  unit_tc.c.curve.closed = false;
  ck_assert_int_eq(certify(), PH_E_INTERNAL);
  unit_tc.problem.field[PH_F_CLOSED].flag = false;
  ck_assert_int_eq(certify(), PH_E_INTERNAL);
}

enum { CHORD, CIRCLE, END_TANGENTS, END_DERIVATIVES, END_RULES };

/* The ends of an open spline by each rule; `chord` is that of set_derivatives.
 */
static void set_ends(int rule) {
  static const ph_cplx some[2] = {{1, -2}, {-3, 0.25}};
  for (size_t end = 0; end < 2; end++) {
    double *v = unit_tc.vectors + (end ? 2 * UNIT_TC_POINTS - 2 : 0);
    ph_cplx along = chord(end ? UNIT_TC_POINTS - 2 : 0, UNIT_TC_POINTS);
    unit_put(unit_tc.ends + 2 * end, some[end]);
    if (rule == CIRCLE) {
      /* the angle from the chord to one end is minus that to the other */
      ph_cplx inner =
          unit_get(unit_tc.vectors + (end ? 2 * UNIT_TC_POINTS - 4 : 2));
      ph_cplx angle = ph_cplx_mul(inner, ph_cplx_conj(along));
      unit_put(
          v, ph_cplx_scale(0.5 * ph_cplx_abs(along),
                           unit_unit(ph_cplx_mul(ph_cplx_conj(angle), along))));
    } else if (rule == END_TANGENTS) {
      unit_put(v,
               ph_cplx_scale(0.5 * ph_cplx_abs(along), unit_unit(some[end])));
    } else if (rule == END_DERIVATIVES) {
      unit_put(v, some[end]);
    }
  }
  add_pairs(false);
}

static void say_ends(int rule) {
  struct ph_value *field = unit_tc.problem.field;
  field[PH_F_ENDS].kind = PH_ABSENT;
  field[PH_F_END_TANGENTS].kind = field[PH_F_END_DERIVATIVES].kind = PH_ABSENT;
  if (rule == CIRCLE) {
    unit_set_word(&unit_tc.problem, PH_F_ENDS, "circle");
  } else if (rule == END_TANGENTS) {
    unit_set_array(&unit_tc.problem, PH_F_END_TANGENTS, unit_tc.ends, 2, 2);
  } else if (rule == END_DERIVATIVES) {
    unit_set_array(&unit_tc.problem, PH_F_END_DERIVATIVES, unit_tc.ends, 2, 2);
  }
}

/* A curve with the ends of one rule is refused by every other one. */
PH_TEST_EACH(test_ends, END_RULES) {
  for (int rule = 0; rule < END_RULES; rule++) {
    spline(false, 0.5, 1, 0);
    set_ends(_i);
    say_ends(rule);
    if (rule == _i) {
      ck_accepted();
    } else {
      ck_assert_int_eq(certify(), PH_E_NO_CONVERGENCE);
      ck_assert(strstr(checked.diag.message, "tangent_error") != NULL ||
                strstr(checked.diag.message, "end_derivative_error") != NULL);
    }
  }
}

/* ---- joints on the chord ------------------------------------------------ */

/* A wave: two arcs that are symmetric by themselves, at the angle f to the
 * chord from 0 to length * e^(i turn), the first one a third of it. */
static void wave(double f, double turn) {
  double size = sqrt(3 / (1 + 2 * cos(f)));
  ph_cplx root = ph_cplx_polar(turn / 2);
  ph_cplx back = ph_cplx_mul(root, ph_cplx_polar(-f / 2));
  ph_cplx on = ph_cplx_mul(root, ph_cplx_polar(f / 2));
  unit_cert_begin();
  unit_cubics_begin(&unit_tc.c, ph_cplx_of(0, 0));
  unit_cubics_add(&unit_tc.c, ph_cplx_scale(size, back),
                  ph_cplx_scale(size, on));
  size *= sqrt(2);
  unit_cubics_add(&unit_tc.c, ph_cplx_scale(size, on),
                  ph_cplx_scale(size, back));
  unit_put(unit_tc.points + 2, unit_tc.c.at);
  unit_put(unit_tc.vectors, ph_cplx_mul(back, back));
  unit_put(unit_tc.vectors + 2, ph_cplx_mul(back, back));
  unit_set_array(&unit_tc.problem, PH_F_POINTS, unit_tc.points, 2, 2);
  unit_set_array(&unit_tc.problem, PH_F_TANGENTS, unit_tc.vectors, 2, 2);
  unit_set_word(&unit_tc.problem, PH_F_MODE, "g1-pair");
  unit_set_word(&unit_tc.problem, PH_F_JOINT, "chord");
}

PH_TEST(test_chord) {
  wave(0.5, 0.3);
  ck_accepted();
  unit_set_number(&unit_tc.problem, PH_F_JOINT_ANGLE, 0.5);
  unit_set_number(&unit_tc.problem, PH_F_JOINT_POSITION, 1.0 / 3);
  ck_accepted();
  unit_set_number(&unit_tc.problem, PH_F_JOINT_POSITION, 1.0 / 3 + MOVED);
  ck_refused(PH_D_INTERPOLATION_ERROR, 0);
  unit_tc.problem.field[PH_F_JOINT_POSITION].kind = PH_ABSENT;
  unit_set_number(&unit_tc.problem, PH_F_JOINT_ANGLE, 0.5 + MOVED);
  ck_refused(PH_D_TANGENT_ERROR, 0);
  unit_set_number(&unit_tc.problem, PH_F_JOINT_ANGLE, -0.5);
  ck_refused(PH_D_TANGENT_ERROR, 0);
  unit_tc.problem.field[PH_F_JOINT_ANGLE].kind = PH_ABSENT;
  unit_set_word(&unit_tc.problem, PH_F_JOINT,
                "free"); /* where it is a C1 pair */
  ck_refused(PH_D_CONTINUITY_ERROR, 1);
  spline(false, 0.5, 1, 0);
  unit_set_array(&unit_tc.problem, PH_F_TANGENTS, unit_tc.vectors,
                 UNIT_TC_POINTS, 2);
  unit_set_word(&unit_tc.problem, PH_F_MODE, "g1-pair");
  unit_set_word(&unit_tc.problem, PH_F_JOINT, "chord");
  ck_refused_somewhere(PH_D_INTERPOLATION_ERROR);
}
