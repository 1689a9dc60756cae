/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Views: units, directions, what a sphere hides, and lines cut to a frame. */
#include "unit.h"

#include "drawing_unit.h"
#include "plot/globe.h"
#include "plot/view.h"

static ph_vec3 random_vec3(struct unit_random *r, double size) {
  double x = unit_random_in(r, -size, size), y = unit_random_in(r, -size, size);
  return ph_vec3_of(x, y, unit_random_in(r, -size, size));
}

/* ---- units --------------------------------------------------------------- */

static void check_unit(ph_vec3 low, ph_vec3 high) {
  struct ph_unit unit = ph_unit_of(low, high);
  ph_vec3 a = ph_unit_in(&unit, low), b = ph_unit_in(&unit, high);
  ck_assert(unit.size > 0 && isfinite(unit.size));
  ck_assert(fabs(a.x) <= 1.001 && fabs(a.y) <= 1.001 && fabs(a.z) <= 1.001);
  ck_assert(fabs(b.x) <= 1.001 && fabs(b.y) <= 1.001 && fabs(b.z) <= 1.001);
  ck_rel(ph_unit_out(unit.center.x, unit.size, b.x), high.x, 1e-12);
  ck_rel(ph_unit_out(unit.center.y, unit.size, a.y), low.y, 1e-12);
}

PH_TEST(units) {
  struct ph_unit unit;
  check_unit(ph_vec3_of(1, 2, 3), ph_vec3_of(2, 5, 3));
  check_unit(ph_vec3_of(-DBL_MAX, -1, 0), ph_vec3_of(DBL_MAX, 1, 0));
  check_unit(ph_vec3_of(-1e-310, -1e-311, 0), ph_vec3_of(1e-310, 0, 0));
  check_unit(ph_vec3_of(7, 7, 7), ph_vec3_of(7, 7, 7));
  check_unit(ph_vec3_of(0, 0, 0), ph_vec3_of(0, 0, 0));
  check_unit(ph_vec3_of(1e9, 1e9, 0), ph_vec3_of(nextafter(1e9, 2e9), 1e9, 0));
  unit = ph_unit_of(ph_vec3_of((double)NAN, 0, 0),
                    ph_vec3_of((double)INFINITY, 4, 0));
  ck_abs(unit.center.x, 0, 0);
  ck_abs(unit.center.y, 2, 0);
}

/* ---- directions ---------------------------------------------------------- */

static void check_view(const struct ph_view *v) {
  ph_vec3 cross = ph_vec3_cross(v->right, v->up);
  ck_abs(ph_vec3_abs(v->right), 1, 1e-14);
  ck_abs(ph_vec3_abs(v->up), 1, 1e-14);
  ck_abs(ph_vec3_dot(v->right, v->up), 0, 1e-14);
  ck_abs(ph_vec3_abs(ph_vec3_sub(cross, v->toward)), 0, 1e-14);
}

PH_TEST(directions) {
  struct unit_random random = unit_random_of(82);
  struct ph_view v = ph_view_axes(0, 2);
  struct ph_seen seen = ph_view_see(&v, ph_vec3_of(1, 2, 3));
  ck_abs(seen.u, 1, 0);
  ck_abs(seen.v, 3, 0);
  ck_abs(seen.depth, -2, 0); /* y goes away from the eye */
  v = ph_view_axes(1, 2);
  ck_abs(v.toward.x, 1, 0);
  v = ph_view_from(ph_vec3_of(0, 0, 5)); /* as a map */
  ck_abs(v.right.x, 1, 0);
  ck_abs(v.up.y, 1, 0);
  v = ph_view_from(ph_vec3_of(0, 0, -1));
  check_view(&v);
  for (int i = unit_count(1000); i-- > 0;) {
    v = ph_view_from(random_vec3(&random, 2));
    check_view(&v);
    ck_assert(v.up.z >= 0 || fabs(v.toward.z) > 0.99);
  }
}

PH_TEST(windows) {
  struct ph_window w = {{10, 20, 100, 50}, 1, 2, 8};
  struct ph_seen seen = {1, 2, 0};
  struct ph_spot spot = ph_window_spot(&w, seen);
  ck_abs(spot.x, 60, 0);
  ck_abs(spot.y, 45, 0);
  seen.u += 1;
  seen.v += 1;
  spot = ph_window_spot(&w, seen);
  ck_abs(spot.x, 68, 0);
  ck_abs(spot.y, 37, 0); /* up is up */
}

PH_TEST(hidden) {
  struct ph_seen front = {0.3, 0.1, 0.9}, behind = {0.3, 0.1, -0.9};
  struct ph_seen beside = {1.2, 0.1, -0.9}, near = {0.9, 0, 0.3};
  struct ph_seen far = {0.9, 0, -0.1};
  ck_assert(!ph_view_hidden(front));
  ck_assert(ph_view_hidden(behind));
  ck_assert(!ph_view_hidden(beside));
  ck_abs(ph_view_horizon(near, far), 0.75, 1e-15);
  ck_abs(ph_view_horizon(far, near), 0.25, 1e-15);
}

/* ---- globes -------------------------------------------------------------- */

static size_t views_of(const struct unit_drawing *of, struct ph_view views[2],
                       double *reach) {
  const struct ph_drawing *d = unit_drawing(of);
  struct ph_panel panel;
  struct ph_diag diag;
  struct ph_seen middle;
  size_t n;
  ck_assert_int_eq(ph_panel_make(&d, 1, &unit_arena, &panel, &diag), PH_OK);
  n = panel.views_n;
  for (size_t i = 0; i < n; i++) {
    views[i] = panel.views[i];
    check_view(&views[i]);
  }
  *reach = ph_globe_reach(&panel, &views[0], &middle);
  ph_drawing_free((struct ph_drawing *)d);
  return n;
}

PH_TEST(globes) {
  struct unit_drawing of = {.space = PH_SPHERE,
                            .segments = 2,
                            .turn = 2,
                            .size = 3,
                            .place = {1, 1, 1}};
  struct ph_view views[2];
  char text[PH_GLOBE_CAPTION_MAX];
  double reach;
  ck_assert_uint_eq(views_of(&of, views, &reach), 1);
  ck_abs(reach, 1, 0);
  ph_globe_caption(&views[0], text); /* 57.3 east, of the middle */
  ck_assert_str_eq(text, "from longitude 55\xC2\xB0, latitude 15\xC2\xB0");
  of.turn = 5;
  ck_assert_uint_eq(views_of(&of, views, &reach), 2);
  /* of a curve all around, what the first view hides is in the other half */
  ck_assert(ph_vec3_dot(views[0].toward, views[1].toward) < 0);
  ck_abs(reach, 1, 0);
  of.turn = 0.01; /* chord 0.0098 of the radius, seen from near */
  ck_assert_uint_eq(views_of(&of, views, &reach), 1);
  ck_abs(reach, 1.25 * 0.0049, 1e-4);
  ck_abs(ph_globe_step(1), 30, 0);
  ck_abs(ph_globe_step(reach), 0.2, 0);
  ck_assert(ph_globe_step(0.3) < 30);
}

/* ---- lines in a frame ---------------------------------------------------- */

static const struct ph_rect frame = {0, 0, 10, 5};

PH_TEST(clipped) {
  struct ph_spot a = {1, 1}, b = {9, 4};
  ck_assert(ph_clip(&frame, &a, &b));
  ck_assert(unit_same(a.x, 1) && unit_same(b.y, 4));
  a = (struct ph_spot){-10, 2};
  b = (struct ph_spot){20, 2};
  ck_assert(ph_clip(&frame, &a, &b));
  ck_abs(a.x, 0, 1e-14);
  ck_abs(b.x, 10, 1e-14);
  a = (struct ph_spot){-1, 3};
  b = (struct ph_spot){1, 8};
  ck_assert(!ph_clip(&frame, &a, &b)); /* past a corner */
  a = (struct ph_spot){5, -3};
  b = (struct ph_spot){5, -1};
  ck_assert(!ph_clip(&frame, &a, &b));
  a = (struct ph_spot){(double)NAN, 1};
  ck_assert(!ph_clip(&frame, &a, &b));
  a = (struct ph_spot){1, (double)INFINITY};
  ck_assert(!ph_clip(&frame, &a, &b));
}

/* What is left is in the frame and on the line. */
PH_TEST(clipped_any) {
  struct unit_random random = unit_random_of(83);
  int inside = 0;
  for (int i = unit_count(20000); i-- > 0;) {
    double size = pow(10, unit_random_in(&random, 0, 12));
    struct ph_spot a = {unit_random_in(&random, -size, size),
                        unit_random_in(&random, -size, size)};
    struct ph_spot b = {unit_random_in(&random, -20, 20),
                        unit_random_in(&random, -20, 20)};
    struct ph_spot p = a, q = b;
    if (ph_clip(&frame, &p, &q)) {
      double dx = b.x - a.x, dy = b.y - a.y, length = hypot(dx, dy);
      inside++;
      ck_assert(ph_rect_has(&frame, p, 1e-9 * size));
      ck_assert(ph_rect_has(&frame, q, 1e-9 * size));
      ck_abs(((p.x - b.x) * dy - (p.y - b.y) * dx) / length, 0, 1e-9 * size);
      ck_abs(((q.x - b.x) * dy - (q.y - b.y) * dx) / length, 0, 1e-9 * size);
    } else {
      ck_assert(!ph_rect_has(&frame, a, 0) && !ph_rect_has(&frame, b, 0));
    }
  }
  ck_assert_int_gt(inside, unit_count(1000));
}
