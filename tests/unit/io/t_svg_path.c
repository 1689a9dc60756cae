/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * SVG path data: what each command draws, arcs against the ellipse itself, and
 * what is no path.
 */
#include "unit.h"

#include "io/svg_path.h"

#include <math.h>

/* What path data draw, as "M x,y then the other points" of each piece. */
static void ck_draws(const char *data, const char *expected) {
  struct ph_trace t = {.arena = &unit_arena, .affine = PH_TRACE_AS_IS};
  struct ph_diag diag;
  char text[512];
  size_t n = 0, point = 0;
  ck_assert_int_eq(ph_svg_path_read(&t, data, strlen(data), "d", &diag), PH_OK);
  for (size_t i = 0, part = 0; i < t.pieces_n; i++) {
    if (part < t.parts_n && t.part[part].piece == i) {
      ck_assert_uint_eq(t.part[part].point, point);
      n += (size_t)snprintf(text + n, sizeof text - n, "%s",
                            t.part[part].closed ? "closed " : "open ");
      part++;
    }
    for (size_t k = 0; k < t.sizes[i]; k++, point++) {
      n +=
          (size_t)snprintf(text + n, sizeof text - n, "%g,%g%s", t.v[2 * point],
                           t.v[2 * point + 1], k + 1 < t.sizes[i] ? " " : "; ");
    }
  }
  ck_assert_uint_eq(point, t.n);
  text[n] = '\0';
  ck_assert_str_eq(text, expected);
  ph_arena_reset(&unit_arena);
}

PH_TEST(test_commands) {
  ck_draws("M1 2L3 4", "open 1,2 3,4; ");
  ck_draws("m1 2l3 4", "open 1,2 4,6; ");
  ck_draws(" M 1,2 3 , 4-5.5.5 ", "open 1,2 3,4; 3,4 -5.5,0.5; ");
  ck_draws("m1 2 3 4 5 6", "open 1,2 4,6; 4,6 9,12; ");
  ck_draws("M1 2H5V7h-1v-1", "open 1,2 5,2; 5,2 5,7; 5,7 4,7; 4,7 4,6; ");
  ck_draws("M0 0C1 2 3 4 5 6S7 8 9 9",
           "open 0,0 1,2 3,4 5,6; 5,6 7,8 7,8 9,9; ");
  ck_draws("M1 1c1 2 3 4 5 6s1 1 2 2",
           "open 1,1 2,3 4,5 6,7; 6,7 8,9 7,8 8,9; ");
  ck_draws("M1 1S3 4 5 6", "open 1,1 1,1 3,4 5,6; ");
  ck_draws("M0 0Q1 2 3 4T5 6 7 7",
           "open 0,0 1,2 3,4; 3,4 5,6 5,6; 5,6 5,6 7,7; ");
  ck_draws("M1 1q1 2 3 4t1 1", "open 1,1 2,3 4,5; 4,5 6,7 5,6; ");
  ck_draws("M1 1T3 4", "open 1,1 1,1 3,4; ");
  ck_draws("M0 0 4 0 4 3Z", "closed 0,0 4,0; 4,0 4,3; 4,3 0,0; ");
  ck_draws("M0 0 4 0 0 0z", "closed 0,0 4,0; 4,0 0,0; ");
  ck_draws("M1 1h2v2zl1 0", "closed 1,1 3,1; 3,1 3,3; 3,3 1,1; "
                            "open 1,1 2,1; ");
  ck_draws("m1 1h2zm5 5h1", "closed 1,1 3,1; 3,1 1,1; open 6,6 7,6; ");
  ck_draws("M1 1M2 2L3 3L3 3L4 4", "open 2,2 3,3; 3,3 4,4; ");
  ck_draws("M0 0A0 5 0 0 1 3 4", "open 0,0 3,4; ");
  ck_draws("M0 0A1 1 0 0 1 0 0", "");
  ck_draws("M1e1-2e-1L+.5-.5e1", "open 10,-0.2 0.5,-5; ");
  ck_draws("", "");
  ck_draws("M1 1", "");
}

/* The point of a Bezier curve, by de Casteljau's algorithm. */
static void point_of(const double *p, size_t n, double u, double x[2]) {
  double b[32];
  memcpy(b, p, 2 * n * sizeof *b);
  for (size_t m = n - 1; m > 0; m--) {
    for (size_t i = 0; i < 2 * m; i++) {
      b[i] += u * (b[i + 2] - b[i]);
    }
  }
  memcpy(x, b, 2 * sizeof *x);
}

/* The ellipse of an arc: the image of a circle, brought back to that. */
struct round {
  double rx, ry, c, s; /* radii as given, cosine and sine of the rotation */
  double center[2], scale;
};

static void back(const struct round *e, const double *x, double q[2]) {
  q[0] = (e->c * x[0] + e->s * x[1]) / e->rx - e->center[0];
  q[1] = (e->c * x[1] - e->s * x[0]) / e->ry - e->center[1];
}

/* The circle through three places of the arc. */
static void find_circle(const struct ph_trace *t, struct round *e) {
  double q[3][2], d[2][3], x[2], det;
  e->center[0] = e->center[1] = 0;
  for (size_t k = 0; k < 3; k++) {
    const size_t piece = k == 2 ? t->pieces_n - 1 : 0;
    point_of(t->v + 32 * piece, 16, k == 0 ? 0 : k == 1 ? 0.5 : 1, x);
    back(e, x, q[k]);
  }
  for (size_t k = 0; k < 2; k++) {
    d[k][0] = 2 * (q[k + 1][0] - q[0][0]);
    d[k][1] = 2 * (q[k + 1][1] - q[0][1]);
    d[k][2] = q[k + 1][0] * q[k + 1][0] + q[k + 1][1] * q[k + 1][1] -
              q[0][0] * q[0][0] - q[0][1] * q[0][1];
  }
  det = d[0][0] * d[1][1] - d[1][0] * d[0][1];
  e->center[0] = (d[0][2] * d[1][1] - d[1][2] * d[0][1]) / det;
  e->center[1] = (d[0][0] * d[1][2] - d[1][0] * d[0][2]) / det;
  e->scale = hypot(q[0][0] - e->center[0], q[0][1] - e->center[1]);
}

/* The pieces lie on the ellipse and turn to one side.  ret  by how much */
static double ck_round(const struct ph_trace *t, const struct round *e,
                       bool sweep) {
  double swept = 0, last, x[2], q[2];
  back(e, t->v, q);
  last = atan2(q[1], q[0]);
  for (size_t k = 0; k < t->pieces_n; k++) {
    ck_assert_uint_eq(t->sizes[k], 16);
    for (int step = 1; step <= 16; step++) {
      double angle;
      point_of(t->v + 32 * k, 16, step / 16.0, x);
      back(e, x, q);
      ck_assert_double_eq_tol(hypot(q[0], q[1]), e->scale, 2e-13 * e->scale);
      angle = remainder(atan2(q[1], q[0]) - last, 2 * acos(-1));
      ck_assert(sweep ? angle > 0 : angle < 0);
      swept += fabs(angle);
      last += angle;
    }
  }
  return swept;
}

/* Pieces go on where others end, without a corner. */
static void ck_smooth(const struct ph_trace *t, double size) {
  for (size_t k = 1; k < t->pieces_n; k++) {
    const double *p = t->v + 32 * k;
    ck_assert_mem_eq(p - 2, p, 2 * sizeof *p);
    for (size_t c = 0; c < 2; c++) {
      ck_assert_double_eq_tol(p[c - 2] - p[c - 4], p[c + 2] - p[c],
                              1e-14 * size);
    }
  }
}

/* Arcs of all kinds; they end to the last bit where they must. */
PH_TEST(test_arcs) {
  static const struct {
    double rx, ry, rotation, to[2];
  } cases[] = {{1, 1, 0, {1, 1}},          {5, 3, 30, {2, 4}},
               {2, 2, 0, {4, 0}},          {4, 1, -45, {0, -2}},
               {7, 9, 200, {3, 1e-6}},     {1, 2, 0, {10, 0}},
               {1e-3, 2e-3, 77, {1e-3, 0}}};
  for (size_t i = 0; i < 4 * COUNT(cases); i++) {
    const bool large = i & 1, sweep = i & 2;
    const double *to = cases[i / 4].to, half = acos(-1);
    const double a = cases[i / 4].rotation * half / 180;
    struct round e = {cases[i / 4].rx, cases[i / 4].ry, cos(a), sin(a), {0}, 0};
    struct ph_trace t = {.arena = &unit_arena, .affine = PH_TRACE_AS_IS};
    double swept;
    ph_trace_arc(&t, (double[]){e.rx, e.ry}, cases[i / 4].rotation, large,
                 sweep, to[0], to[1]);
    ck_assert(!t.failed);
    ck_assert_mem_eq(t.v + 2 * (t.n - 1), to, 2 * sizeof *to);
    find_circle(&t, &e);
    ck_assert_double_ge(e.scale, 1 - 1e-9); /* no smaller than asked for */
    ck_smooth(&t, e.scale * fmax(e.rx, e.ry));
    swept = ck_round(&t, &e, sweep);
    if (e.scale < 1 + 1e-9) {
      ck_assert(large ? swept >= half - 1e-7 : swept <= half + 1e-7);
    }
    ph_arena_reset(&unit_arena);
  }
}

PH_TEST(test_transformed) {
  struct ph_trace t = {.arena = &unit_arena, .affine = {0, 2, -1, 0, 5, 6}};
  static const double expected[] = {3, 8, 1, 12};
  struct ph_diag diag;
  ck_assert_int_eq(ph_svg_path_read(&t, "M1 2L3 4", 8, "d", &diag), PH_OK);
  ck_assert_mem_eq(t.v, expected, sizeof expected);
}

PH_TEST(test_failures) {
  static const struct {
    const char *data, *message;
    enum ph_status status;
  } cases[] = {
      {"L1 2",
       "has \"L1 2\" at character 1, where the command M is due in the "
       "path",
       PH_E_SYNTAX},
      {"1 2",
       "has \"1 2\" at character 1, where the command M is due in the "
       "path",
       PH_E_SYNTAX},
      {"M1 2 B", "has \"B\" at character 6, where a command is due in the path",
       PH_E_SYNTAX},
      {"M1", "ends where a number is due in the path", PH_E_SYNTAX},
      {"M1 2A1 1 0 2 1 3 3",
       "has \"2 1 3 3\" at character 12, where 0 or 1 is due in the path",
       PH_E_SYNTAX},
      {"M1 2L1e999 0", "has a number at character 6 that overflows a double",
       PH_E_NOT_FINITE},
      {"M1e308 0l1e308 0", "goes beyond what a double can have",
       PH_E_NOT_FINITE},
      {"M1 2", "draws nothing (0 subpaths)", PH_E_BAD_VALUE},
      {"M1 2h1M3 3h1",
       "has 2 subpaths: a problem has one, an SVG file may have any number",
       PH_E_BAD_VALUE},
  };
  for (size_t i = 0; i < COUNT(cases); i++) {
    struct ph_value value;
    struct ph_diag diag;
    enum ph_status status =
        ph_svg_path_value(cases[i].data, strlen(cases[i].data), "path",
                          &unit_arena, &value, &diag);
    ck_assert_int_eq(status, cases[i].status);
    ck_assert_str_eq(diag.message, cases[i].message);
    ck_assert_str_eq(diag.field, "path");
  }
}
