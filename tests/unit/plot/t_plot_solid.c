/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Surfaces in figures: ribs lie on them, in space and laid flat; what is nearer
 * is drawn later; and what there is too much of is bounded.  A cylinder all
 * around shows its near half outside, and hides the far one in part.
 */
#include "unit.h"

#include "curve/surface/strip.h"
#include "kernel/pi.h"
#include "plot/panel.h"
#include "plot/solid.h"
#include "plot/strokes.h"

enum { STRIPS = 7001 };

static struct ph_strip strips[STRIPS];
static double lengths[STRIPS];
static struct ph_result result;
static struct ph_drawing *drawing;
static struct ph_panel panel;
static struct ph_arena arena;
static struct ph_diag diag;

/* A cylinder of radius 1 about z, in n strips from (1, 0), with a height, its
 * normals inwards. */
static void make(size_t n, double low, double high) {
  static const struct ph_problem nothing;
  static const struct ph_drawing_names names = {NULL, NULL, 1};
  struct ph_strip_place at = {{1, 0, 0}, {0, 0, 1}, {0, 1, 0}, {-1, 0, 0}};
  const struct ph_drawing *drawings[1];
  ph_drawing_free(drawing);
  for (size_t i = 0; i < n; i++) {
    const struct ph_strip_frame frame = {{at.c.x, at.c.y, at.c.z},
                                         {at.e.x, at.e.y, at.e.z},
                                         {at.d.x, at.d.y, at.d.z},
                                         {at.n.x, at.n.y, at.n.z}};
    strips[i] = (struct ph_strip){.pair = i / 2,
                                  .frame = frame,
                                  .kn = 1,
                                  .length = 2 * PH_PI / (double)n,
                                  .shift = {0.25, 0.25}};
    at = ph_strip_end(&strips[i]);
  }
  result.curve = (struct ph_curve){.kind = PH_CURVE_CONE,
                                   .closed = true,
                                   .dimension = 3,
                                   .n = n,
                                   .lengths = lengths};
  result.curve.surface =
      (struct ph_surface){.strips = strips, .height = {low, high}};
  ph_develop(&result.curve);
  ph_surface_measure(&result.curve);
  ck_assert_int_eq(ph_drawing_make(&nothing, &result, &names, &drawing, &diag),
                   PH_OK);
  drawings[0] = drawing;
  ck_assert_int_eq(ph_panel_make(drawings, 1, &arena, &panel, &diag), PH_OK);
}

static void finish(void) {
  ph_drawing_free(drawing);
  drawing = NULL;
  ph_arena_free(&arena);
}

PH_TEST(ribs_on_the_surface) {
  const struct ph_sheet *sheet;
  double last = 0;
  make(6, -1, 2);
  sheet = &drawing->sheets[0];
  ck_assert_uint_eq(drawing->sheets_n, 1);
  ck_assert_uint_eq(sheet->elements_n, 3);
  for (size_t i = 0; i < sheet->ribs_n; i++) {
    const struct ph_rib *rib = &sheet->ribs[i];
    ck_abs(hypot(rib->end[0].x, rib->end[0].y), 1, 1e-14);
    /* heights are from the given points, a quarter below the contact curve */
    ck_abs(rib->end[0].z, -1.25, 1e-14);
    ck_abs(rib->end[1].z, 1.75, 1e-14);
    ck_abs(rib->flat[1].y - rib->flat[0].y, 3, 1e-14);
    ck_abs(rib->flat[0].x, rib->flat[1].x, 1e-14);
    ck_assert(rib->flat[0].x >= last - 1e-14);
    ck_assert(rib->flat[0].x - last <= 0.1);
    last = rib->flat[0].x;
  }
  ck_abs(last, 2 * PH_PI, 1e-13);
  for (size_t i = 0; i < 3; i++) {
    ck_abs(sheet->elements[i].point.z, -0.25, 1e-14);
    ck_abs(sheet->elements[i].flat.y, -0.25, 1e-14);
  }
}

/* Corners and middle of a cell in the view. */
static bool overlap(const struct ph_cell *a, const struct ph_cell *b) {
  double low[2][2] = {{9, 9}, {9, 9}}, high[2][2] = {{-9, -9}, {-9, -9}};
  for (int i = 0; i < 4; i++) {
    const struct ph_seen s[2] = {ph_view_see(&panel.views[0], a->corner[i]),
                                 ph_view_see(&panel.views[0], b->corner[i])};
    for (int j = 0; j < 2; j++) {
      low[j][0] = fmin(low[j][0], s[j].u);
      low[j][1] = fmin(low[j][1], s[j].v);
      high[j][0] = fmax(high[j][0], s[j].u);
      high[j][1] = fmax(high[j][1], s[j].v);
    }
  }
  return low[0][0] < high[1][0] && low[1][0] < high[0][0] &&
         low[0][1] < high[1][1] && low[1][1] < high[0][1];
}

/* How far it is to the near side, of the middle: 0 at the silhouette. */
static double nearness(const struct ph_cell *cell) {
  const ph_vec3 m = ph_vec3_add(cell->corner[0], cell->corner[2]);
  return m.x * panel.views[0].toward.x + m.y * panel.views[0].toward.y;
}

static bool is_near(const struct ph_cell *cell) {
  return nearness(cell) > 0;
}

PH_TEST(nearer_is_later) {
  size_t hidden = 0;
  make(6, -1, 1);
  ck_assert_uint_gt(panel.solid.n, 200);
  for (size_t i = 0; i < panel.solid.n; i += 7) {
    for (size_t j = 0; j < i; j += 5) {
      const struct ph_cell *late = &panel.solid.v[i],
                           *early = &panel.solid.v[j];
      const bool over = overlap(late, early);
      hidden += over && is_near(late) && !is_near(early);
      ck_assert(!over || is_near(late) || !is_near(early));
    }
  }
  ck_assert_uint_gt(hidden, 50);
}

/* The far half shows its inside, the near one its outside: two papers. */
PH_TEST(two_sides) {
  size_t warm = 0, cold = 0;
  make(6, -1, 1);
  for (size_t i = 0; i < panel.solid.n; i++) {
    const struct ph_cell *cell = &panel.solid.v[i];
    ck_assert(cell->filled);
    warm += cell->fill.r > cell->fill.b;
    cold += cell->fill.r < cell->fill.b;
    if (fabs(nearness(cell)) > 0.1) {
      ck_assert(is_near(cell) == (cell->fill.r < cell->fill.b));
    }
  }
  ck_assert_uint_gt(warm, panel.solid.n / 3);
  ck_assert_uint_gt(cold, panel.solid.n / 3);
}

PH_TEST(bounded) {
  make(STRIPS, -1, 1);
  ck_assert_uint_le(drawing->sheets[0].ribs_n, 2 * PH_SHEET_RIBS);
  ck_assert_uint_eq(drawing->sheets[0].elements_n, 0);
  ck_assert_uint_le(drawing->segments_n, PH_SHEET_STRIPS);
  ck_assert_uint_le(panel.solid.n, 12000);
  make(2, 0, 0);
  ck_assert(drawing->sheets[0].bare);
  for (size_t i = 0; i < panel.solid.n; i++) {
    ck_assert(!panel.solid.v[i].filled);
    ck_assert(panel.solid.v[i].has_contact);
  }
}

PH_FIXTURE(NULL, finish)
