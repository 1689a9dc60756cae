/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Problems of Tschirnhausen cubics for tests: their data, from lists of fields
 * or by angles, and what became of them. */
#ifndef PH_TESTS_TC_UNIT_H
#define PH_TESTS_TC_UNIT_H

#include "cert_tc_unit.h"
#include "fields_unit.h"
#include "planar_unit.h"
#include "unit.h"

#include "kernel/pi.h"
#include "solve/method.h"
#include "solve/tc/tc.h"

/* What becomes of a problem: its mode, then its data. */
static inline enum ph_status unit_tc_read(const struct given given[GIVEN_MAX],
                                          struct ph_tc_data *data,
                                          struct ph_diag *diag) {
  const struct ph_problem problem = unit_problem_of(given);
  enum ph_tc_mode mode;
  enum ph_status status = ph_tc_mode_of(&problem, &mode, diag);
  return status == PH_OK && mode != PH_TC_APPROXIMATE
             ? ph_tc_data_of(&problem, mode, &unit_arena, data, diag)
             : status;
}

/* Reads what must be right. */
static inline struct ph_tc_data
unit_tc_given(const struct given given[GIVEN_MAX]) {
  struct ph_tc_data data;
  struct ph_diag diag;
  enum ph_status status = unit_tc_read(given, &data, &diag);
  ck_assert_msg(status == PH_OK, "%s: %s", diag.field, diag.message);
  return data;
}

/* ---- Hermite data, and how well they are met ----------------------------- */

/* Tangents at the angles a and b to the chord, of the lengths from and to. */
static inline struct ph_tc_hermite unit_tc_data(double a, double from, double b,
                                                double to) {
  struct ph_tc_hermite h;
  h.t[0] = ph_tc_snap(ph_cplx_scale(from, ph_cplx_polar(a)));
  h.t[1] = ph_tc_snap(ph_cplx_scale(to, ph_cplx_polar(b)));
  return h;
}

/* How far a fit ends from 1, relative to its length. */
static inline double unit_tc_miss(const struct ph_tc_fit *fit) {
  ph_cplx end = {0, 0};
  double length = 0;
  for (size_t i = 0; i < fit->n; i++) {
    end = ph_cplx_add(end, ph_tc_leg(&fit->tc[i]));
    length += ph_tc_length(&fit->tc[i]);
  }
  return unit_distance(end, ph_cplx_of(1, 0)) / length;
}

/* The derivative at the start (0) or at the end (1). */
static inline ph_cplx unit_tc_end(const struct ph_tc_fit *fit, size_t end) {
  ph_cplx w = end == 0 ? fit->tc[0].w[0] : fit->tc[fit->n - 1].w[1];
  return ph_cplx_mul(w, w);
}

/* The same data seen from the other end, or in a mirror along the chord. */
static inline struct ph_tc_hermite unit_tc_reversed(struct ph_tc_hermite h) {
  struct ph_tc_hermite r = {{h.t[1], h.t[0]}};
  return r;
}

static inline struct ph_tc_hermite unit_tc_mirrored(struct ph_tc_hermite h) {
  struct ph_tc_hermite m = {
      {ph_tc_snap(ph_cplx_conj(h.t[0])), ph_tc_snap(ph_cplx_conj(h.t[1]))}};
  return m;
}

/* ... and the preimages of a fit of n cubics, from one end to the other. */
static inline ph_cplx unit_tc_preimage(const struct ph_tc_fit *fit, size_t i) {
  return i == 0 ? fit->tc[0].w[0] : fit->tc[i - 1].w[1];
}

/* The distance of preimages of x, seen like that, to those of y up to their
 * common sign, relative to the size of y. */
static inline double unit_tc_apart(const struct ph_tc_fit *x, bool reversed,
                                   bool mirrored, const struct ph_tc_fit *y) {
  double plus = 0, minus = 0, size = 0;
  for (size_t i = 0; i <= y->n; i++) {
    ph_cplx u = unit_tc_preimage(x, reversed ? x->n - i : i);
    ph_cplx v = unit_tc_preimage(y, i);
    u = mirrored ? ph_cplx_conj(u) : u;
    plus = unit_larger(plus, unit_distance(u, v));
    minus = unit_larger(minus, unit_distance(ph_cplx_scale(-1, u), v));
    size = unit_larger(size, ph_cplx_abs(v));
  }
  return (plus < minus ? plus : minus) / size;
}

/* How many cubics there are for two angles. */
struct unit_tc_count {
  unsigned without_loop, with_loop;
};

static inline struct unit_tc_count unit_tc_count_of(unsigned without_loop,
                                                    unsigned with_loop) {
  return (struct unit_tc_count){without_loop, with_loop};
}

/* d < p, d < pi/3: both turn by 2 pi - 2 d, or there is none. */
static inline struct unit_tc_count unit_tc_count_large(double p, double d) {
  double m, closes;
  if (p >= PH_PI / 2 || PH_SQRT3 * sin(p) > 2 * sin(d)) {
    return unit_tc_count_of(0, 0);
  }
  if (d <= PH_PI / 6) {
    return unit_tc_count_of(0, 2);
  }
  /* the p at which the loop of the cubic with |D| = m begins at its end */
  m = 2 * sin(d - PH_PI / 6);
  closes = atan2((1 / m - m) * sin(d), (1 / m + m) * cos(d) - 1);
  if (p <= closes) {
    return unit_tc_count_of(1, 1);
  }
  return 2 * tan(d) < PH_SQRT3 ? unit_tc_count_of(0, 2)
                               : unit_tc_count_of(2, 0);
}

/*
 * The number of solutions of ph_tc_g1 from the angles alone, in closed form:
 * what borders the regions of existence [BYR11, fig. 4.5, table 4.1].  Of
 * angles on a border to rounding either side may be answered.
 *
 * in   a, b  angles from the chord to the tangents, in [-pi, pi]
 */
static inline struct unit_tc_count unit_tc_count_by_angles(double a, double b) {
  double from = fabs(a) <= PH_TC_COLLINEAR ? 0 : a,
         to = fabs(b) <= PH_TC_COLLINEAR ? 0 : b;
  double p = fabs(from + to) / 2, d = fabs(to - from) / 2;
  if (d > PH_PI / 2) { /* the same tangents with b a turn further */
    d = PH_PI - d;
    p = PH_PI - p;
  }
  if (d > PH_PI / 3) {
    return p < d || p > d ? unit_tc_count_of(1, 0) : unit_tc_count_of(0, 0);
  }
  if (p < d) {
    return unit_tc_count_of(1, 1);
  }
  if (p > d) {
    return unit_tc_count_large(p, d);
  }
  return d > 0 ? unit_tc_count_of(0, 1)
               : unit_tc_count_of(1, 0); /* the straight line */
}

/* ---- solutions ----------------------------------------------------------- */

/* unit_tc_field: the value of a field, to be set. */
static inline struct ph_value *unit_tc_field(struct unit_solution *s,
                                             enum ph_field_id id) {
  return &s->problem.field[id];
}

static inline void unit_tc_flag(struct unit_solution *s, enum ph_field_id id) {
  unit_set_flag(&s->problem, id, true);
}

static inline enum ph_status unit_tc_solve(struct unit_solution *s) {
  return unit_solve(&ph_method_tc, s);
}

static inline void unit_tc_solve_ok(struct unit_solution *s) {
  enum ph_status status = unit_tc_solve(s);
  ck_assert_msg(status == PH_OK, "%s: %s", s->diag.field, s->diag.message);
}

/* unit_tc_refused: a failure, its field, and a part of its message. */
static inline void unit_tc_refused(struct unit_solution *s,
                                   enum ph_status status, const char *field,
                                   const char *part) {
  ck_assert_int_eq(unit_tc_solve(s), status);
  ck_assert_str_eq(s->diag.field, field);
  ck_assert_msg(strstr(s->diag.message, part) != NULL, "%s", s->diag.message);
}

#endif
