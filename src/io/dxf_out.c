/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * DXF (see dxf_out.h): pairs of a group code and a value, a line each.  What
 * programs ask of a file of this version, even when it is empty: tables with
 * the entries that others refer to, two blocks, a dictionary; each object has a
 * handle, in hexadecimal, that no other has.
 */
#include "io/dxf_out.h"

#include "curve/kind/kind.h"
#include "curve/surface/grid.h"
#include "io/number.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

/* Handles of the fixed objects are below; a result has room for 2^24. */
enum { RESULT_BITS = 24 };

/* Strings of extended data are shorter than 256 bytes. */
enum { TEXT_MAX = 250 };

/* Flags of SPLINE. */
enum { CLOSED = 1, RATIONAL = 4, PLANE = 8 };

static void pair(struct ph_buf *buf, int code, const char *value) {
  char text[16];
  snprintf(text, sizeof text, "%d\n", code);
  ph_buf_puts(buf, text);
  ph_buf_puts(buf, value);
  ph_buf_puts(buf, "\n");
}

static void pair_size(struct ph_buf *buf, int code, size_t n) {
  char text[32];
  snprintf(text, sizeof text, "%zu", n);
  pair(buf, code, text);
}

static void pair_handle(struct ph_buf *buf, int code, uint64_t handle) {
  char text[32];
  snprintf(text, sizeof text, "%" PRIX64, handle);
  pair(buf, code, text);
}

static void pair_number(struct ph_buf *buf, int code, double x) {
  char text[PH_NUMBER_MAX + 1];
  text[ph_number_write(text, x)] = '\0';
  pair(buf, code, text);
}

/* ---- what is around the entities ----------------------------------------- */

/* Pairs of the fixed objects, one after the other. */
#define TABLE(name, handle, n)                                                 \
  "0\nTABLE\n2\n" name "\n5\n" handle "\n330\n0\n100\nAcDbSymbolTable\n70\n" n \
  "\n"
#define ENTRY(type, handle, owner, class)             \
  "0\n" type "\n5\n" handle "\n330\n" owner "\n100\n" \
  "AcDbSymbolTableRecord\n100\n" class "\n"
#define END "0\nENDTAB\n"
#define LTYPE(handle, name)                              \
  ENTRY("LTYPE", handle, "2", "AcDbLinetypeTableRecord") \
  "2\n" name "\n70\n0\n3\n\n72\n65\n73\n0\n40\n0.0\n"
#define LAYER(handle, name, colour)                   \
  ENTRY("LAYER", handle, "3", "AcDbLayerTableRecord") \
  "2\n" name "\n70\n0\n62\n" colour "\n6\nContinuous\n370\n-3\n390\nF\n"
#define APPID(handle, name)                            \
  ENTRY("APPID", handle, "7", "AcDbRegAppTableRecord") \
  "2\n" name "\n70\n0\n"
#define RECORD(handle, name)                                 \
  ENTRY("BLOCK_RECORD", handle, "9", "AcDbBlockTableRecord") \
  "2\n" name "\n340\n0\n"
#define BLOCK(begin, end, owner, name)                                      \
  "0\nBLOCK\n5\n" begin "\n330\n" owner "\n100\nAcDbEntity\n8\n0\n100\n"    \
  "AcDbBlockBegin\n2\n" name "\n70\n0\n10\n0.0\n20\n0.0\n30\n0.0\n3\n" name \
  "\n1\n\n0\nENDBLK\n5\n" end "\n330\n" owner                               \
  "\n100\nAcDbEntity\n8\n0\n100\nAcDbBlockEnd\n"

static const char version[] = "0\nSECTION\n2\nHEADER\n9\n$ACADVER\n1\nAC1015\n";

static const char head[] =
    "9\n$HANDSEED\n5\nFFFFFFFFFFFFFF00\n0\nENDSEC\n"
    "0\nSECTION\n2\nCLASSES\n0\nENDSEC\n"
    "0\nSECTION\n2\nTABLES\n" TABLE("VPORT", "1", "0") END TABLE(
        "LTYPE", "2", "3") LTYPE("10", "ByBlock") LTYPE("11", "ByLayer")
        LTYPE("12", "Continuous") END TABLE("LAYER", "3", "4") LAYER(
            "13", "0", "7") LAYER("14", "curve", "7") LAYER("15", "offset", "1")
            LAYER("20", "ruling", "5") END TABLE("STYLE", "4", "1") ENTRY(
                "STYLE", "16", "4",
                "AcDbTextStyleTableRecord") "2\nStandard\n70\n0\n40\n0."
                                            "0\n41\n1.0\n50\n0.0\n71\n0\n42\n1."
                                            "0\n3\ntxt\n"
                                            "4\n\n" END TABLE(
                                                "VIEW", "5",
                                                "0") END TABLE("UCS", "6", "0")
                                                END TABLE("APPID", "7",
                                                          "2") APPID("17",
                                                                     "ACAD")
                                                    APPID("18", "PHSPLINE")
                                                        END TABLE(
                                                            "DIMSTYLE", "8",
                                                            "1") "100\nAcDbDimS"
                                                                 "tyleTable\n71"
                                                                 "\n1\n"
                                                                 "0\nDIMSTYLE\n"
                                                                 "105\n19\n330"
                                                                 "\n8\n100\nAcD"
                                                                 "bSymbolTableR"
                                                                 "ecord\n100\n"
                                                                 "AcDbDimStyleT"
                                                                 "ableRecord\n2"
                                                                 "\nStandard\n7"
                                                                 "0\n0\n340\n16"
                                                                 "\n" END TABLE(
                                                                     "BLOCK_"
                                                                     "RECORD",
                                                                     "9", "2")
                                                                     RECORD(
                                                                         "1A",
                                                                         "*Mode"
                                                                         "l_"
                                                                         "Spac"
                                                                         "e")
                                                                         RECORD(
                                                                             "1"
                                                                             "B",
                                                                             "*"
                                                                             "P"
                                                                             "a"
                                                                             "p"
                                                                             "e"
                                                                             "r"
                                                                             "_"
                                                                             "S"
                                                                             "p"
                                                                             "a"
                                                                             "c"
                                                                             "e")
                                                                             END
    "0\nENDSEC\n"
    "0\nSECTION\n2\nBLOCKS\n" BLOCK("1C", "1D", "1A", "*Model_Space")
        BLOCK("1E", "1F", "1B", "*Paper_Space") "0\nENDSEC\n"
                                                "0\nSECTION\n2\nENTITIES\n";

#define DICTIONARY(handle, owner)                                       \
  "0\nDICTIONARY\n5\n" handle "\n330\n" owner "\n100\nAcDbDictionary\n" \
  "281\n1\n"

static const char tail[] = "0\nENDSEC\n0\nSECTION\n2\nOBJECTS\n" DICTIONARY(
    "C", "0") "3\nACAD_GROUP\n350\nD\n3\nACAD_"
              "PLOTSTYLENAME\n350\nE\n" DICTIONARY(
                  "D", "C") "0\nACDBDICTIONARYWDFLT"
                            "\n5\nE\n330\nC\n100\nAc"
                            "DbDictionary\n281\n1\n"
                            "3\nNormal\n350\nF\n100"
                            "\nAcDbDictionaryWithDef"
                            "ault\n340\nF\n"
                            "0\nACDBPLACEHOLDER\n5\n"
                            "F\n330\nE\n0\nENDSEC\n0"
                            "\nEOF\n";

void ph_dxf_header(struct ph_buf *buf, const char *unit) {
  ph_buf_puts(buf, version);
  if (unit) {
    pair(buf, 9, "$INSUNITS");
    pair(buf, 70, unit);
  }
  ph_buf_puts(buf, head);
}

void ph_dxf_footer(struct ph_buf *buf) {
  ph_buf_puts(buf, tail);
}

/* ---- entities ------------------------------------------------------------ */

/* Where the entities of a result stand. */
struct context {
  struct ph_buf *buf;
  const char *id;
  uint64_t handle; /* the next one */
  size_t dimension;
  bool downward;
};

/* Lines end values: control characters are blanks.  A character is not cut. */
static void pair_text(struct ph_buf *buf, int code, const char *value) {
  char text[TEXT_MAX + 1];
  size_t n = strlen(value);
  n = n < TEXT_MAX ? n : TEXT_MAX;
  while (n == TEXT_MAX && n > 0 && (value[n] & 0xc0) == 0x80) {
    n--;
  }
  for (size_t i = 0; i < n; i++) {
    const unsigned char c = (unsigned char)value[i];
    text[i] = c < ' ' || c == 127 ? ' ' : value[i];
  }
  text[n] = '\0';
  pair(buf, code, text);
}

static void point(const struct context *c, int code, const double *p) {
  pair_number(c->buf, code, p[0]);
  pair_number(c->buf, code + 10, c->downward ? 0 - p[1] : p[1]);
  pair_number(c->buf, code + 20, c->dimension == 3 ? p[2] : 0);
}

static void begin(struct context *c, const char *type, const char *layer,
                  const char *class) {
  pair(c->buf, 0, type);
  pair_handle(c->buf, 5, c->handle++);
  pair(c->buf, 330, "1A");
  pair(c->buf, 100, "AcDbEntity");
  pair(c->buf, 8, layer);
  pair(c->buf, 100, class);
}

static void end(const struct context *c, const double *distance) {
  pair(c->buf, 1001, "PHSPLINE");
  pair_text(c->buf, 1000, c->id);
  if (distance) {
    pair_number(c->buf, 1040, *distance);
  }
}

/* A spline, but for its knots and points. */
static void begin_spline(struct context *c, const struct ph_spline *s,
                         const char *layer) {
  struct ph_buf *buf = c->buf;
  begin(c, "SPLINE", layer, "AcDbSpline");
  if (c->dimension == 2) {
    ph_buf_puts(buf, "210\n0.0\n220\n0.0\n230\n1.0\n");
  }
  pair_size(buf, 70,
            (size_t)(s->closed ? CLOSED : 0) + (s->weights_n ? RATIONAL : 0) +
                (c->dimension == 2 ? PLANE : 0));
  pair_size(buf, 71, s->degree);
  pair_size(buf, 72, s->knots_n);
  pair_size(buf, 73, s->n);
  pair_size(buf, 74, 0);
}

static void spline(struct context *c, const struct ph_spline *s,
                   const char *layer, const double *distance) {
  begin_spline(c, s, layer);
  for (size_t i = 0; i < s->knots_n; i++) {
    pair_number(c->buf, 40, s->knots[i]);
  }
  for (size_t i = 0; i < s->n; i++) {
    if (s->weights_n) {
      pair_number(c->buf, 41, s->weights[i]);
    }
    point(c, 10, s->control_points + c->dimension * i);
  }
  end(c, distance);
}

static void splines(struct context *c, const struct ph_splines *of,
                    const char *layer, const double *distance) {
  for (size_t i = 0; i < of->n; i++) {
    spline(c, &of->v[i], layer, distance);
  }
}

/* Whether cubic i of a path begins where the one before ends, to the last bit.
 */
static bool goes_on(const double *p, size_t i) {
  return i > 0 && memcmp(p + 8 * i, p + 8 * i - 2, 2 * sizeof *p) == 0;
}

/* Cubics one after the other, n of them, as a spline whose knots count them. */
static void cubics(struct context *c, const double *p, size_t n,
                   const char *layer, const double *distance) {
  const struct ph_spline s = {.degree = 3,
                              .closed =
                                  memcmp(p, p + 8 * n - 2, 2 * sizeof *p) == 0,
                              .n = 3 * n + 1,
                              .knots_n = 3 * n + 5};
  begin_spline(c, &s, layer);
  for (size_t i = 0; i < s.knots_n; i++) {
    pair_size(c->buf, 40, i == 0 ? 0 : i + 1 == s.knots_n ? n : (i - 1) / 3);
  }
  point(c, 10, p);
  for (size_t i = 0; i < n; i++) {
    for (size_t j = 1; j <= 3; j++) {
      point(c, 10, p + 8 * i + 2 * j);
    }
  }
  end(c, distance);
}

/* A flat pattern: the chains of its outline, and the rulings between strips. */
static void pattern(struct context *c, const struct ph_curve *curve,
                    const struct ph_pieces *path, const double *distance) {
  const double *p = path->control_points;
  const size_t outline = path->n - ph_flat_rulings(curve);
  for (size_t i = 0, next; i < outline; i = next) {
    for (next = i + 1; next < outline && goes_on(p, next); next++) {
    }
    cubics(c, p + 8 * i, next - i, distance ? "offset" : "curve", distance);
  }
  for (size_t i = outline; i < path->n; i++) {
    begin(c, "LINE", "ruling", "AcDbLine");
    point(c, 10, p + 8 * i);
    point(c, 11, p + 8 * i + 6);
    end(c, distance);
  }
}

void ph_dxf_out(struct ph_buf *buf, const char *id, size_t number,
                bool downward, const struct ph_result *result,
                const struct ph_pieces *paths) {
  struct context c = {buf, id, (uint64_t)number << RESULT_BITS,
                      result->curve.dimension, downward};
  if (ph_kind_of(&result->curve)->parts == PH_STRIPS_PARTS) {
    c.dimension = 2;
    pattern(&c, &result->curve, &paths[0], NULL);
    for (size_t i = 0; i < result->parallels_n; i++) {
      const struct ph_parallel *beside = &result->parallels[i];
      pattern(&c, &beside->curve, &paths[i + 1], &beside->distance);
    }
    return;
  }
  splines(&c, &result->nurbs, "curve", NULL);
  for (size_t i = 0; i < result->offsets_n; i++) {
    const struct ph_offset *o = &result->offsets[i];
    splines(&c, &o->nurbs, "offset", &o->distance);
    for (size_t j = 0; j < o->loops.n; j++) {
      splines(&c, &o->loops.v[j].nurbs, "offset", &o->distance);
    }
  }
}
