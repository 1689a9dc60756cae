/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Pages: where panels go, what texts and legends say, which colours there are.
 */
#include "unit.h"

#include "drawing_unit.h"
#include "plot/colour.h"
#include "plot/layout.h"
#include "plot/legend.h"
#include "plot/text.h"

/* ---- grids --------------------------------------------------------------- */

enum { PANELS = 100 };

static struct ph_panel panels[PANELS];
static struct ph_layout layout;

/* What else is on the page. */
static bool headed;
static struct ph_key key;

/* A grid of n panels of one drawing. */
static void lay_out(size_t n, double width, double height, bool note) {
  const struct unit_drawing of = {
      .space = PH_PLANE, .segments = 2, .turn = 3, .size = 1};
  static const struct ph_drawing *d;
  const struct ph_figure_rules rules = {PH_FIGURE_SVG, width, height, NULL,
                                        false};
  const struct ph_beside beside = {.note = note, .title = headed, .key = key};
  struct ph_diag diag;
  ph_arena_reset(&unit_arena);
  d = unit_drawing(&of);
  for (size_t i = 0; i < n; i++) {
    ck_assert_int_eq(ph_panel_make(&d, 1, &unit_arena, &panels[i], &diag),
                     PH_OK);
  }
  ck_assert_int_eq(
      ph_layout_make(panels, n, &rules, &beside, &unit_arena, &layout, &diag),
      PH_OK);
  ph_drawing_free((struct ph_drawing *)d);
}

/* All on the page, in rows, none over another. */
static void check_cells(size_t n) {
  ck_assert_uint_ge(layout.columns * layout.rows, n);
  ck_assert_uint_lt(layout.columns * (layout.rows - 1), n);
  for (size_t i = 0; i < n; i++) {
    const struct ph_rect *c = &layout.cells[i];
    ck_assert(c->x >= 0 && c->x + c->w <= layout.width);
    ck_assert(c->y >= 0 && c->y + c->h <= layout.height);
    ck_assert(c->w >= 1 && c->h >= 1);
    if (i % layout.columns > 0) {
      ck_assert(c->x >= c[-1].x + c[-1].w);
      ck_abs(c->y, c[-1].y, 1e-9);
    }
    if (i >= layout.columns) {
      const struct ph_rect *above = c - layout.columns;
      ck_assert(c->y >= above->y + above->h);
    }
  }
}

PH_TEST(grids) {
  double em = 100;
  for (size_t n = 1; n <= PANELS; n++) {
    lay_out(n, 0, 0, false);
    check_cells(n);
    ck_assert(layout.em <= em && layout.em >= 6);
    em = layout.em;
    ck_assert(layout.width / layout.height > 0.5 || n == 2);
    ck_assert(layout.width / layout.height < 2.6);
  }
  lay_out(4, 0, 0, false);
  ck_assert_uint_eq(layout.columns, 2);
}

PH_TEST(page_sizes) {
  double em, height;
  lay_out(1, 0, 0, false);
  ck_abs(layout.width, 640, 0);
  em = layout.em;
  height = layout.height;
  lay_out(1, 1280, 0, false); /* letters grow with the page */
  ck_abs(layout.width, 1280, 0);
  ck_abs(layout.height, 2 * height, 2);
  ck_abs(layout.em, 2 * em, 1e-9);
  lay_out(1, 100, 2000, false); /* and shrink, but stay legible */
  ck_abs(layout.width, 100, 0);
  ck_abs(layout.height, 2000, 0);
  ck_abs(layout.em, 0.75 * em, 1e-9);
  lay_out(12, 123, 45, true);
  ck_abs(layout.width, 123, 0);
  ck_abs(layout.height, 45, 0);
  lay_out(7, 0, 0, true);
  check_cells(7);
  ck_assert(layout.cells[6].y + layout.cells[6].h <
            layout.height - 2 * layout.em);
  lay_out(0, 0, 0, false);
  ck_abs(layout.width, 640, 0);
}

/* Curves are told apart without colours, up to as many as have a line each in
 * the legend. */
PH_TEST(dashes) {
  const struct ph_dash none = ph_colour_dash(0, 5, 10);
  ck_assert_uint_eq(none.n, 0);
  ck_assert_uint_eq(ph_colour_dash(0, 1, 10).n, 0);
  ck_assert_uint_eq(ph_colour_dash(3, PH_LEGEND_MAX + 1, 10).n, 0);
  for (size_t i = 1; i < 5; i++) {
    const struct ph_dash dash = ph_colour_dash(i, PH_LEGEND_MAX, 10);
    const struct ph_dash twice = ph_colour_dash(i, PH_LEGEND_MAX, 20);
    const struct ph_dash next = ph_colour_dash(i % 4 + 1, PH_LEGEND_MAX, 10);
    ck_assert(dash.n > 0 && dash.n % 2 == 0 && dash.n <= PH_DASH_MAX);
    ck_assert(dash.n != next.n || dash.length[0] > next.length[0] ||
              dash.length[0] < next.length[0]);
    for (size_t k = 0; k < dash.n; k++) {
      ck_assert(dash.length[k] > 1);
      ck_abs(twice.length[k], 2 * dash.length[k], 1e-12);
    }
  }
}

PH_TEST(title_and_key) {
  double height;
  headed = false;
  key = (struct ph_key){{false}};
  lay_out(1, 0, 0, false);
  height = layout.height;
  ck_abs(layout.key.h, 0, 0);
  headed = true;
  key.has[PH_KEY_POINT] = key.has[PH_KEY_CURVE] = true;
  lay_out(1, 0, 0, false);
  check_cells(1);
  ck_abs(layout.key.h, 2.2 * layout.em, 1e-9); /* one row */
  ck_abs(layout.height, ceil(height + 4.8 * layout.em), 1);
  ck_assert(layout.title < layout.cells[0].y);
  ck_assert(layout.cells[0].y + layout.cells[0].h <= layout.key.y);
  ck_abs(layout.key.y + layout.key.h, layout.height, 1e-9);
  for (int i = 0; i < PH_KEY_N; i++) {
    key.has[i] = true;
  }
  ck_assert_uint_eq(ph_key_rows(&key, 1000), 1);
  ck_assert_uint_eq(ph_key_rows(&key, 1), PH_KEY_N);
  lay_out(4, 0, 0, true);
  check_cells(4);
  ck_assert(layout.key.y + layout.key.h < layout.height - layout.em);
  lay_out(1, 640, 100, false); /* no room for it */
  ck_abs(layout.key.h, 0, 0);
  headed = false;
  key = (struct ph_key){{false}};
}

/* ---- texts --------------------------------------------------------------- */

static char text[PH_PLOT_TEXT_MAX];

static const char *clean(const char *raw) {
  ph_plot_text(raw, text);
  return text;
}

PH_TEST(texts) {
  char longest[1000];
  ck_assert_str_eq(clean(""), "");
  ck_assert_str_eq(clean("a\xC3\xA4 \xE2\x82\xAC \xF0\x9F\x98\x80"),
                   "a\xC3\xA4 \xE2\x82\xAC \xF0\x9F\x98\x80");
  ck_assert_str_eq(clean("\xFF\xC3 \xE2\x82"), "?? ??");
  ck_assert_str_eq(clean("a\nb\tc\x7F\x1B[0m"), "a?b?c??[0m");
  ck_assert_str_eq(clean("\xC2\x85\xEF\xBF\xBF\xEF\xBF\xBD"), "??\xEF\xBF\xBD");
  ck_assert_str_eq(clean("a\xE2\x80\xAE\xE2\x81\xA6z"), "a??z");
  memset(longest, 'x', sizeof longest);
  longest[sizeof longest - 1] = '\0';
  clean(longest);
  ck_assert_uint_lt(strlen(text), PH_PLOT_TEXT_MAX);
  ck_assert_str_eq(text + strlen(text) - 4, "x...");
  for (size_t i = 0; i + 2 < sizeof longest; i += 2) {
    memcpy(longest + i, "\xC3\xA4", 2);
  }
  clean(longest);
  ck_assert_str_eq(text + strlen(text) - 5, "\xC3\xA4...");
}

static const char *rounded(const char *raw) {
  ph_plot_text(raw, text);
  ph_plot_text_round(text);
  return text;
}

PH_TEST(numbers) {
  ck_assert_str_eq(rounded("5.342857142857143"), "5.34286");
  ck_assert_str_eq(rounded("-0.00123456789"), "-0.00123457");
  ck_assert_str_eq(rounded("0.1000000000001"), "0.1");
  ck_assert_str_eq(rounded("1.9999999999"), "2");
  ck_assert_str_eq(rounded("-9.9999999999"), "-10");
  ck_assert_str_eq(rounded("1.23456789e-20"), "1.23457e-20");
  ck_assert_str_eq(rounded("12345678.5"), "12345679");
  ck_assert_str_eq(rounded("12345678.25"), "12345678");
  ck_assert_str_eq(rounded("1.5"), "1.5");
  ck_assert_str_eq(rounded("123456789"), "123456789");
  ck_assert_str_eq(rounded("1.2345678x"), "1.2345678x");
  ck_assert_str_eq(rounded("[1.2345678]"), "[1.2345678]");
  ck_assert_str_eq(rounded("1.23.45678"), "1.23.45678");
  ck_assert_str_eq(rounded("cc"), "cc");
  ck_assert_str_eq(rounded(""), "");
}

PH_TEST(legends) {
  struct ph_drawing d[2] = {{.label = "lengths[1] = 2.5"},
                            {.label = "lengths[1] = 3"}};
  const struct ph_drawing *const both[2] = {&d[0], &d[1]};
  struct ph_panel panel = {.drawings = both, .n = 2};
  ck_assert_uint_eq(ph_legend_common(&panel), strlen("lengths[1] = "));
  d[1].label = "lengths[2] = 3";
  ck_assert_uint_eq(ph_legend_common(&panel), 0);
  d[0].label = d[1].label = "a = 1, b = 2";
  ck_assert_uint_eq(ph_legend_common(&panel), 0);
  d[1].label = NULL;
  ck_assert_uint_eq(ph_legend_common(&panel), 0);
  d[0].label = NULL;
  ck_assert_uint_eq(ph_legend_common(&panel), 0);
}

/* ---- colours ------------------------------------------------------------- */

static bool same(struct ph_colour a, struct ph_colour b) {
  return unit_same(a.r, b.r) && unit_same(a.g, b.g) && unit_same(a.b, b.b);
}

/* Tests tell things by them. */
PH_TEST(inks) {
  for (int i = 0; i < PH_INK_N; i++) {
    for (int k = 0; k < i; k++) {
      ck_assert(!same(ph_ink((enum ph_ink)i), ph_ink((enum ph_ink)k)));
    }
  }
}

/* No segment has the colour of the one after it. */
PH_TEST(segments) {
  for (size_t n = 2; n < 12; n++) {
    for (size_t k = 0; k < n; k++) {
      ck_assert(k + 1 == n || !same(ph_colour_segment(k, n, false),
                                    ph_colour_segment(k + 1, n, false)));
      ck_assert(!same(ph_colour_segment(k, n, true),
                      ph_colour_segment((k + 1) % n, n, true)));
    }
  }
}

/* Lighter from step to step, and never too light. */
PH_TEST(ramp) {
  double last = 0;
  for (size_t i = 0; i < 100; i++) {
    struct ph_colour c = ph_colour_ramp(i, 100);
    double light = 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b;
    ck_assert(light > last && light < 0.8);
    last = light;
  }
  ck_assert(same(ph_colour_ramp(0, 1), ph_colour_ramp(0, 1)));
  ck_assert(ph_colour_thin(1) > ph_colour_thin(2));
  ck_assert(ph_colour_thin(1000) > 0);
}
