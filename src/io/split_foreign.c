/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Files that are no tables (see split.h): what they are, and what makes of them
 * what is read.
 */
#include "io/split.h"

#include <string.h>

#define WKT "WKT: ogr2ogr -f GeoJSON converts it"
/* What a file that begins with these bytes is, and what makes CSV of it. */
static const struct {
  const char *bytes;
  size_t n;
  const char *what;
} foreign[] = {
    {"\x1f\x8b", 2, "compressed by gzip: gunzip unpacks it"},
    {"\xff\xfe", 2, "UTF-16: iconv -f UTF-16 -t UTF-8 converts it"},
    {"\xfe\xff", 2, "UTF-16: iconv -f UTF-16 -t UTF-8 converts it"},
    {"PK\x03\x04", 4,
     "a spreadsheet or other zip archive: spreadsheets can be saved as CSV"},
    {"\x93NUMPY", 6, "an array of NumPy: numpy.savetxt writes it as text"},
    {"<", 1, "XML or HTML: --input-format=svg and gpx read SVG and GPX"},
    {"{", 1, "JSON: --input-format=json and geojson read it"},
    {"LINESTRING", 10, WKT},
    {"POLYGON", 7, WKT},
    {"MULTI", 5, WKT},
    {"POINT", 5, WKT},
};

bool ph_split_is_foreign(const char *p, const char *end, struct ph_diag *diag) {
  for (size_t i = 0; i < sizeof foreign / sizeof *foreign; i++) {
    const char *after = p + foreign[i].n;
    bool wkt = foreign[i].n >= 5; /* a word, then its coordinates */
    if ((size_t)(end - p) > foreign[i].n &&
        memcmp(p, foreign[i].bytes, foreign[i].n) == 0 &&
        (!wkt || memchr(after, '(', (size_t)(end - after)))) {
      ph_fail(diag, PH_E_SYNTAX, NULL, "the input is %s", foreign[i].what);
      return true;
    }
  }
  return false;
}
