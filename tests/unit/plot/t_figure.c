/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Figures: what an SVG has, by the colours of its strokes; sizes; that the same
 * drawings give the same bytes; and that nothing is too odd to be drawn.
 */
#include "unit.h"

#include "drawing_unit.h"
#include "plot/colour.h"
#include "plot/figure.h"

static struct ph_buf out;
static struct ph_diag diag;

/* A whole circle of four segments, and what else there may be. */
static struct unit_drawing of;

static void set_up(void) {
  of = (struct unit_drawing){.space = PH_PLANE,
                             .segments = 4,
                             .turn = 4.5,
                             .size = 1,
                             .place = {0, 0, 0}};
}

static enum ph_status write_all(struct ph_drawing *const *drawings, size_t n,
                                enum ph_figure_format format, double width,
                                double height) {
  const struct ph_figure_rules rules = {format, width, height, NULL, false};
  ph_buf_clear(&out, 1 << 20);
  return ph_figure_write((const struct ph_drawing *const *)drawings, n, &rules,
                         &out, &diag);
}

/* Writes and frees. */
static void write_free(struct ph_drawing **drawings, size_t n,
                       enum ph_figure_format format) {
  ck_assert_int_eq(write_all(drawings, n, format, 0, 0), PH_OK);
  ck_assert(!out.failed && out.n > 0);
  for (size_t i = 0; i < n; i++) {
    ph_drawing_free(drawings[i]);
  }
}

static void write_one(enum ph_figure_format format) {
  struct ph_drawing *d = unit_drawing(&of);
  write_free(&d, 1, format);
}

/* Next number of "rgb(8%,39%,70%)". */
static double percent(const char **at) {
  char *end;
  double x = strtod(*at, &end);
  *at = end + strspn(end, "%, ");
  return x / 100;
}

/* Elements of the SVG that are stroked, or filled, in an ink; but for its key.
 */
static size_t count(const char *what, enum ph_ink ink) {
  struct ph_colour want = ph_ink(ink);
  size_t n = 0, m = strlen(what);
  char *end;
  ck_assert_ptr_nonnull(ph_buf_reserve(&out, 1));
  out.data[out.n] = '\0';
  end = strstr(out.data, "<g class=\"key\">"); /* comes last */
  if (end) {
    *end = '\0';
  }
  for (const char *at = out.data; (at = strstr(at, what)) != NULL;) {
    at += m;
    at += strspn(at, ":=\"");
    if (strncmp(at, "rgb(", 4) == 0) {
      double r, g, b;
      at += 4;
      r = percent(&at);
      g = percent(&at);
      b = percent(&at);
      n += unit_near(r, want.r, 1e-5) && unit_near(g, want.g, 1e-5) &&
           unit_near(b, want.b, 1e-5);
    }
  }
  return n;
}

static size_t strokes(enum ph_ink ink) {
  return count("stroke", ink);
}

static size_t fills(enum ph_ink ink) {
  return count("fill", ink);
}

#define SKIP_WITHOUT_CAIRO()           \
  if (ph_figure_can(&diag) != PH_OK) { \
    return;                            \
  }

/* ---- what there is ------------------------------------------------------- */

PH_TEST(plane) {
  SKIP_WITHOUT_CAIRO();
  of.polygon = of.tangents = true;
  of.offsets = 3;
  write_one(PH_FIGURE_SVG);
  ck_assert_uint_eq(strokes(PH_INK_EVEN), 4); /* 2 in the view and profile */
  ck_assert_uint_eq(strokes(PH_INK_ODD), 4);
  ck_assert_uint_eq(strokes(PH_INK_LAST), 0);
  ck_assert_uint_eq(strokes(PH_INK_POLYGON), 4);
  ck_assert_uint_eq(strokes(PH_INK_OFFSET), 3);
  ck_assert_uint_eq(strokes(PH_INK_TANGENT), 5);
  ck_assert_uint_eq(fills(PH_INK_TANGENT), 5);
  ck_assert_uint_eq(fills(PH_INK_POINT), 5);
  ck_assert_uint_eq(strokes(PH_INK_JOINT), 3);
  ck_assert_uint_eq(strokes(PH_INK_FRAME), 2);
  ck_assert_uint_gt(strokes(PH_INK_TICK), 10);
}

PH_TEST(closed) {
  SKIP_WITHOUT_CAIRO();
  of.closed = true;
  of.turn = 2 * acos(-1);
  of.segments = 5;
  write_one(PH_FIGURE_SVG);
  ck_assert_uint_eq(strokes(PH_INK_EVEN), 4);
  ck_assert_uint_eq(strokes(PH_INK_ODD), 4);
  ck_assert_uint_eq(strokes(PH_INK_LAST), 2);
  ck_assert_uint_eq(fills(PH_INK_POINT), 5);
}

PH_TEST(space) {
  SKIP_WITHOUT_CAIRO();
  of.space = PH_SPACE;
  of.polygon = true;
  write_one(PH_FIGURE_SVG);
  ck_assert_uint_eq(strokes(PH_INK_EVEN), 2 * (4 + 2));
  ck_assert_uint_eq(strokes(PH_INK_ODD), 2 * (4 + 2));
  ck_assert_uint_eq(strokes(PH_INK_POLYGON), 4 * 4);
  ck_assert_uint_eq(fills(PH_INK_POINT), 4 * 5);
  ck_assert_uint_eq(strokes(PH_INK_JOINT), 2 * 3);
  ck_assert_uint_eq(strokes(PH_INK_FRAME), 3 + 2);
  ck_assert_uint_eq(strokes(PH_INK_BOX), 12);
}

/* A parallel is seen from its middle, all of it if it is short. */
PH_TEST(sphere) {
  SKIP_WITHOUT_CAIRO();
  of.space = PH_SPHERE;
  of.turn = 2;
  write_one(PH_FIGURE_SVG);
  ck_assert_uint_eq(strokes(PH_INK_OUTLINE), 1);
  ck_assert_uint_eq(strokes(PH_INK_EVEN), 2 * 2);
  ck_assert_uint_eq(fills(PH_INK_POINT), 5);
  ck_assert_uint_gt(strokes(PH_INK_GRATICULE), 10);
  of.turn = 4.5; /* three of four segments go over the horizon, or are behind */
  of.place = ph_vec3_of(3, -4, 5);
  of.size = 7;
  write_one(PH_FIGURE_SVG);
  ck_assert_uint_eq(strokes(PH_INK_OUTLINE), 2);
  ck_assert_uint_gt(strokes(PH_INK_EVEN) + strokes(PH_INK_ODD), 4 + 2 * 4);
  ck_assert_uint_gt(fills(PH_INK_OUTLINE), 0);
  ck_assert_uint_eq(fills(PH_INK_OUTLINE) + fills(PH_INK_POINT), 2 * 5);
}

/* Curves of a sweep share a panel, and what is the same is drawn once. */
PH_TEST(sweep) {
  struct ph_drawing *d[3];
  SKIP_WITHOUT_CAIRO();
  of.polygon = of.tangents = true;
  for (size_t i = 0; i < 3; i++) {
    d[i] = unit_drawing(&of);
    d[i]->record = 7;
    d[i]->label = "lengths[0] = 1.5";
  }
  write_free(d, 3, PH_FIGURE_SVG);
  ck_assert_uint_eq(strokes(PH_INK_EVEN) + strokes(PH_INK_ODD), 0);
  ck_assert_uint_eq(strokes(PH_INK_POLYGON), 0);
  ck_assert_uint_eq(strokes(PH_INK_TANGENT), 5);
  ck_assert_uint_eq(fills(PH_INK_POINT), 5);
  ck_assert_uint_eq(strokes(PH_INK_JOINT), 0);
  ck_assert_uint_eq(strokes(PH_INK_FRAME), 2);
}

PH_TEST(grid) {
  struct ph_drawing *d[12];
  SKIP_WITHOUT_CAIRO();
  for (size_t i = 0; i < 12; i++) {
    of.space = i % 3 == 0 ? PH_PLANE : i % 3 == 1 ? PH_SPACE : PH_SPHERE;
    of.turn = 1;
    d[i] = unit_drawing(&of);
    d[i]->record = i + 1;
  }
  write_free(d, 12, PH_FIGURE_SVG);
  ck_assert_uint_eq(strokes(PH_INK_EVEN), 4 * 2 * (2 + 6 + 2));
}

/* ---- files --------------------------------------------------------------- */

PH_TEST(formats) {
  ck_assert_int_eq(ph_figure_format_of("a.svg"), PH_FIGURE_SVG);
  ck_assert_int_eq(ph_figure_format_of("a.b/c.pdf"), PH_FIGURE_PDF);
  ck_assert_int_eq(ph_figure_format_of("a.svg.png"), PH_FIGURE_PNG);
  ck_assert_int_eq(ph_figure_format_of(".png"), PH_FIGURE_FORMAT_N);
  ck_assert_int_eq(ph_figure_format_of("svg"), PH_FIGURE_FORMAT_N);
  ck_assert_int_eq(ph_figure_format_of(""), PH_FIGURE_FORMAT_N);
  ck_assert_int_eq(ph_figure_format_of("a.jpg"), PH_FIGURE_FORMAT_N);
}

PH_TEST(same_bytes) {
  SKIP_WITHOUT_CAIRO();
  of.tangents = true;
  of.space = PH_SPACE;
  for (int f = 0; f < PH_FIGURE_FORMAT_N; f++) {
    struct ph_buf first;
    write_one((enum ph_figure_format)f);
    first = out;
    out = (struct ph_buf){0};
    write_one((enum ph_figure_format)f);
    ck_assert_uint_eq(first.n, out.n);
    ck_assert_int_eq(memcmp(first.data, out.data, out.n), 0);
    ph_buf_free(&first);
  }
}

static unsigned long big_endian(const char *bytes) {
  const unsigned char *b = (const unsigned char *)bytes;
  return (unsigned long)b[0] << 24 | (unsigned long)b[1] << 16 |
         (unsigned long)b[2] << 8 | b[3];
}

static bool has(const char *text) {
  ck_assert_ptr_nonnull(ph_buf_reserve(&out, 1));
  out.data[out.n] = '\0';
  return strstr(out.data, text) != NULL;
}

PH_TEST(sizes) {
  struct ph_drawing *d = unit_drawing(&of);
  SKIP_WITHOUT_CAIRO();
  ck_assert_int_eq(write_all(&d, 1, PH_FIGURE_PNG, 321, 654), PH_OK);
  ck_assert_int_eq(memcmp(out.data, "\x89PNG\r\n\x1a\n", 8), 0);
  ck_assert_uint_eq(big_endian(out.data + 16), 321);
  ck_assert_uint_eq(big_endian(out.data + 20), 654);
  ck_assert_int_eq(write_all(&d, 1, PH_FIGURE_SVG, 300, 200), PH_OK);
  ck_assert(has("width=\"300pt\" height=\"200pt\" viewBox=\"0 0 300 200\""));
  ck_assert_int_eq(write_all(&d, 1, PH_FIGURE_PDF, 300, 200), PH_OK);
  ck_assert_int_eq(memcmp(out.data, "%PDF-", 5), 0);
  ck_assert_int_eq(write_all(&d, 1, PH_FIGURE_PNG, 1, 1), PH_OK);
  ck_assert_uint_eq(big_endian(out.data + 16), 1);
  ck_assert_int_eq(write_all(&d, 1, PH_FIGURE_PNG, 0, 0), PH_OK);
  ck_assert_uint_eq(big_endian(out.data + 16), 640);
  ph_drawing_free(d);
}

/* What is appended to is kept. */
PH_TEST(appended) {
  struct ph_drawing *d = unit_drawing(&of);
  const struct ph_figure_rules rules = {PH_FIGURE_SVG, 0, 0, NULL, false};
  const struct ph_drawing *const one = d;
  SKIP_WITHOUT_CAIRO();
  ph_buf_clear(&out, 0);
  ph_buf_puts(&out, "before");
  ck_assert_int_eq(ph_figure_write(&one, 1, &rules, &out, &diag), PH_OK);
  ck_assert_int_eq(memcmp(out.data, "before<?xml", 11), 0);
  ph_drawing_free(d);
}

/* ---- what may go wrong --------------------------------------------------- */

PH_TEST(empty) {
  SKIP_WITHOUT_CAIRO();
  ck_assert_int_eq(write_all(NULL, 0, PH_FIGURE_PNG, 0, 0), PH_OK);
  ck_assert_uint_eq(big_endian(out.data + 16), 640);
}

PH_TEST(cannot) {
  struct ph_drawing *d = unit_drawing(&of);
  if (ph_figure_can(&diag) == PH_OK) { /* beyond what cairo can */
    ck_assert_int_eq(write_all(&d, 1, PH_FIGURE_PNG, 40000, 40000),
                     PH_E_INTERNAL);
  } else {
    ck_assert_int_eq(write_all(&d, 1, PH_FIGURE_PNG, 0, 0), PH_E_USAGE);
  }
  ck_assert_ptr_nonnull(strstr(diag.message, "cairo"));
  ph_drawing_free(d);
}

/* Numbers of any size: the figure has all its parts. */
PH_TEST(any_size) {
  static const double all[] = {1e300, 1e-300, 1e-9, 4e-320, 1};
  static const double places[] = {0, 0, 0, 0, 4e6};
  SKIP_WITHOUT_CAIRO();
  of.polygon = true;
  for (size_t i = 0; i < COUNT(all); i++) {
    of.size = all[i];
    of.place = ph_vec3_of(places[i], -places[i], 0);
    for (int in = PH_PLANE; in <= PH_SPACE; in++) {
      size_t views = in == PH_PLANE ? 1 : 4;
      of.space = (enum ph_space)in;
      write_one(PH_FIGURE_SVG);
      ck_assert_uint_eq(fills(PH_INK_POINT), 5 * views);
      ck_assert_uint_ge(strokes(PH_INK_EVEN), 2 * views);
      ck_assert_uint_ge(strokes(PH_INK_ODD), 2 * views);
    }
  }
}

/* A point, a curve of no length, and numbers that are none. */
PH_TEST(degenerate) {
  struct ph_drawing *d;
  SKIP_WITHOUT_CAIRO();
  for (int in = PH_PLANE; in <= PH_SPHERE; in++) {
    const double odd[] = {0, (double)NAN, (double)INFINITY, -1e308};
    of.space = (enum ph_space)in;
    for (size_t i = 0; i < COUNT(odd); i++) {
      d = unit_drawing(&of);
      d->length = odd[i];
      for (size_t k = 0; k < d->strokes_n; k++) {
        d->strokes[k].points[k % 5].x = odd[i];
        d->strokes[k].points[k % 7].y = -odd[i];
      }
      for (size_t k = 0; k < d->segments_n; k++) {
        d->profiles[k].curvature[k] = odd[i];
        d->profiles[k].s[2 * k] = odd[i];
      }
      d->data[1].x = odd[i];
      d->low.x = -odd[i];
      d->high.y = odd[i];
      write_free(&d, 1, PH_FIGURE_SVG);
    }
    d = unit_drawing(&of);
    d->strokes_n = d->segments_n = 0;
    d->data_n = 1;
    d->length = 0;
    d->low = d->high = d->data[0];
    write_free(&d, 1, PH_FIGURE_SVG);
    ck_assert_uint_ge(fills(PH_INK_POINT), 1);
  }
}

/* Titles and labels are bytes. */
PH_TEST(any_text) {
  static const char *const texts[] = {"",
                                      "plain",
                                      "a\xFF\xFE b",
                                      "\x01\x02\n\t",
                                      "\xE2\x88",
                                      "<&>\"'",
                                      "\xF0\x9F\x98\x80 \xED\xA0\x80",
                                      "\xEF\xBF\xBF"};
  static char longest[100001];
  SKIP_WITHOUT_CAIRO();
  memset(longest, 'm', sizeof longest - 1);
  for (size_t i = 0; i <= COUNT(texts); i++) {
    const char *text = i < COUNT(texts) ? texts[i] : longest;
    struct ph_drawing *d[2] = {unit_drawing(&of), unit_drawing(&of)};
    d[0]->title = d[0]->label = d[1]->label = text;
    write_free(d, 2, PH_FIGURE_SVG);
    ck_assert_uint_eq(strokes(PH_INK_FRAME), 2);
  }
}

PH_TEST(too_many) {
  enum { MANY = PH_FIGURE_PANELS_MAX + 20 };
  struct ph_drawing *d[MANY];
  SKIP_WITHOUT_CAIRO();
  of.segments = 1;
  of.turn = 1;
  for (size_t i = 0; i < MANY; i++) {
    d[i] = unit_drawing(&of);
    d[i]->record = i;
  }
  write_free(d, MANY, PH_FIGURE_SVG);
  ck_assert_uint_eq(strokes(PH_INK_EVEN), 2 * PH_FIGURE_PANELS_MAX);
}

PH_FIXTURE(set_up, NULL)
