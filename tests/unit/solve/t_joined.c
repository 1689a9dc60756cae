/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Curves whose joints are in memory once: the same in all that is made of them
 * as with joints that stand apart. */
#include "problem_unit.h"
#include "unit.h"

#include "check/certify.h"
#include "curve/bezier/cubics.h"
#include "curve/bezier/nurbs.h"
#include "curve/cross/cross.h"

enum { N = 40 };

static const struct {
  const struct ph_method *method;
  size_t dimension;
  const char *basis, *mode;
  bool closed;
} CASES[] = {{&ph_method_planar, 2, "ph", NULL, true},
             {&ph_method_planar, 2, "atph", NULL, false},
             {&ph_method_spatial_hermite, 3, "ph", NULL, true},
             {&ph_method_spatial_hermite, 2, "ph", NULL, false},
             {&ph_method_tc, 2, NULL, "g2", true},
             {&ph_method_tc, 2, NULL, "spline", false}};

/* An oval with waves. */
static void begin(struct unit_solution *s, size_t i) {
  const size_t d = CASES[i].dimension;
  double v[3 * N];
  for (size_t k = 0; k < N; k++) {
    const double a = 0.13 * (double)k, r = 3 + 0.2 * sin(5 * a);
    v[d * k] = r * cos(a);
    v[d * k + 1] = 2 * r * sin(a);
    if (d == 3) {
      v[d * k + 2] = 0.3 * sin(2 * a);
    }
  }
  *s = (struct unit_solution){.refused = false};
  unit_set_copy(s, PH_F_POINTS, v, N, d);
  unit_set_flag(&s->problem, PH_F_CLOSED, CASES[i].closed);
  unit_set_word(&s->problem, PH_F_BASIS, CASES[i].basis);
  unit_set_word(&s->problem, PH_F_MODE, CASES[i].mode);
  ck_assert_int_eq(CASES[i].method->solve(&s->problem, &s->arena, &s->scratch,
                                          &s->result, &s->diag),
                   PH_OK);
}

static void ck_points(const struct ph_curve *a, const struct ph_curve *b) {
  const size_t size = (b->degree + 1) * b->dimension * sizeof(double);
  ck_assert(a->joined && !b->joined);
  ck_assert_uint_eq(ph_curve_points_n(a), a->degree * a->n + 1);
  ck_assert_uint_eq(ph_curve_points_n(b), (a->degree + 1) * a->n);
  for (size_t k = 0; k < a->n; k++) {
    ck_assert_mem_eq(ph_curve_points(a, k), ph_curve_points(b, k), size);
  }
  if (a->closed) {
    ck_assert_mem_eq(ph_curve_points(a, a->n), a->control_points,
                     a->dimension * sizeof(double));
  }
  ck_abs(ph_curve_size(a), ph_curve_size(b), 0);
  ck_abs(ph_curve_rounding(a), ph_curve_rounding(b), 0);
}

static void ck_certificates(const struct unit_solution *s, size_t i,
                            const struct ph_curve *joined,
                            struct ph_arena *arena) {
  const struct ph_curve *curves[] = {joined, &s->result.curve};
  struct ph_diagnostics d[2] = {s->result.diagnostics, s->result.diagnostics};
  struct ph_diag diag;
  for (size_t j = 0; j < 2; j++) {
    ck_assert_int_eq(ph_certify(CASES[i].method->schema.command, &s->problem,
                                curves[j], arena, &d[j], &diag),
                     PH_OK);
  }
  ck_assert_mem_eq(&d[0], &d[1], sizeof d[0]);
}

static void ck_splines(const struct ph_curve *a, const struct ph_curve *b,
                       struct ph_arena *arena) {
  struct ph_splines of[2];
  struct ph_pieces cubics[2];
  struct ph_cross cross[2];
  struct ph_diag diag;
  const struct ph_curve *curves[] = {a, b};
  for (size_t j = 0; j < 2; j++) {
    ck_assert_int_eq(ph_nurbs_of(curves[j], NULL, 1e-6, arena, &of[j], &diag),
                     PH_OK);
    if (a->dimension == 2) {
      ck_assert_int_eq(
          ph_cubics_of(curves[j], NULL, 1e-6, arena, &cubics[j], &diag), PH_OK);
      ck_assert_int_eq(ph_cross_planar(curves[j], arena, &cross[j], &diag),
                       PH_OK);
    }
  }
  ck_assert_uint_eq(of[0].n, 1);
  ck_assert_uint_eq(of[0].v[0].n, of[1].v[0].n);
  ck_assert_mem_eq(of[0].v[0].control_points, of[1].v[0].control_points,
                   of[0].v[0].n * a->dimension * sizeof(double));
  if (a->dimension == 2) {
    ck_assert_uint_eq(cubics[0].n, cubics[1].n);
    ck_assert_mem_eq(cubics[0].control_points, cubics[1].control_points,
                     8 * cubics[0].n * sizeof(double));
    ck_assert_int_eq(cross[0].simple, cross[1].simple);
  }
}

PH_TEST_EACH(test_joined, sizeof CASES / sizeof *CASES) {
  struct unit_solution s;
  struct ph_curve joined;
  begin(&s, (size_t)_i);
  joined = s.result.curve;
  unit_put_apart(&s);
  ck_points(&joined, &s.result.curve);
  ck_splines(&joined, &s.result.curve, &s.scratch);
  ck_certificates(&s, (size_t)_i, &joined, &s.scratch);
  unit_solution_free(&s);
}
