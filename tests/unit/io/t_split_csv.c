/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The splitter on CSV: records, comments, headers, and --columns. */
#include "split_unit.h"

static const struct ph_field plane_rows[] = {
    {PH_F_POINTS, PH_VECTORS, PLANE, false, "", "", ""},
    {PH_F_TANGENTS, PH_VECTORS, PLANE, false, "", "", ""},
    {PH_F_DERIVATIVES, PH_VECTORS, PLANE, false, "", "", ""},
    {PH_F_CURVE, PH_VECTORS | PH_POLYLINE, PLANE, false, "", "", ""}};
static const struct ph_schema plane = {"tc", plane_rows, 4};
/* ---- CSV ------------------------------------------------------------ */
PH_TEST(test_csv_records) {
  gives("a.csv", "", "end");
  gives("a.csv", "x,y\n", "end");
  gives("a.csv", "x,y\n0,1\n2,3\n", "1 2 0,1$2,3$\nend");
  gives("a.csv", "x,y\r\n0,1\r\n2,3", "1 2 0,1\r$2,3\nend");
  gives("a.csv", "x,y\n0,1\n\n\n \n2,3\n\n", "1 2 0,1$\n2 6 2,3$\nend");
  gives("a.csv", "\n\nx,y\n\n0,1\n", "1 5 0,1$\nend");
  gives("a.csv", "x,y\n0,1\n,\n2,3\n", "1 2 0,1$,$2,3$\nend");
  gives("a.csv", "id,x,y\na,0,1\na,2,3\nb,4,5\na,6,7\n",
        "1 2 a,0,1$a,2,3$\n2 4 b,4,5$\n3 5 a,6,7$\nend");
  gives("a.csv", "x,y,id\n0,1,a\n2,3,\"a\"\n4,5, a \n6,7,a b\n8,9,\"a b\"\n",
        "1 2 0,1,a$2,3,\"a\"$4,5, a $\n2 5 6,7,a b$8,9,\"a b\"$\nend");
  gives("a.csv", "id,x,y\n\"a\"\"\",0,1\n\"a\"\"\",0,1\n\"a\"\"b\",0,1\n",
        "1 2 \"a\"\"\",0,1$\"a\"\"\",0,1$\n2 4 \"a\"\"b\",0,1$\nend");
  gives("a.csv", "id,x,y\na,0,1\n\na,2,3\n", "1 2 a,0,1$\n2 4 a,2,3$\nend");
  gives("a.csv", "x,y,id\n0,1,a\n0\n0,1,a\n",
        "1 2 0,1,a$\n2 3 0$\n3 4 0,1,a$\nend");
  gives("a.csv", "id,x,y\n\"a\nb\",0,1\n\"a\nb\",2,3\nc,4,5",
        "1 2 \"a$b\",0,1$\"a$b\",2,3$\n2 6 c,4,5\nend");
}

PH_TEST(test_csv_comments) {
  gives("a.csv", "# a\nx,y\n# b\n0,1\n# c\n2,3\n#d\n\n# e\n4,5\n# f",
        "1 4 0,1$# c$2,3$#d$\n2 10 4,5$# f\nend");
  gives("a.csv", "# X_m, y_m\n0,1\n", "1 2 0,1$\nend");
  gives("a.csv", "#id,x,y\n0,1,2\n", "1 2 0,1,2$\nend");
  /* Names that are not all known make a comment. */
  gives("a.csv", "# x,y,speed\n0,1\n", "1 2 0,1$\nend");
  gives("a.csv", "# the x, the y\nx,y\n0,1\n", "1 3 0,1$\nend");
  gives("a.csv", "#\n0,1\n", "1 2 0,1$\nend");
  /* Only the first line can be one. */
  gives("a.csv", "\n# y,x,id\n0,1\n", "1 3 0,1$\nend");
  gives("a.csv", "# x,x\n0,1\n",
        "1 1 bad-value 1:5 columns 1 and 2 (\"x\") are the same "
        "(--columns can skip it)\nstopped");
}

PH_TEST(test_csv_headers) {
  gives("a.csv", "0,1\n2,3\n", "1 1 0,1$2,3$\nend");
  gives("a.csv", "\xEF\xBB\xBF X ,\"Y\"\n0,1\n", "1 2 0,1$\nend");
  gives("a.csv", "y,KNOT,x\n0,1,2\n", "1 2 0,1,2$\nend");
  gives("a.tsv", "x\ty\n0\t1\n", "1 2 0\t1$\nend");
  gives_with(&csv, &space, "0,1,2\n", "1 1 0,1,2$\nend");
  gives_with(&csv, &space, "x_m,y_m,z_m\n0,1,2\n", "1 2 0,1,2$\nend");
}

PH_TEST(test_csv_bad_headers) {
  gives("a.csv", "x,yy\n",
        "1 1 unknown-field 1:3 column \"yy\" is unknown to planar; "
        "did you mean \"y\"? (--ignore-columns skips it)\nstopped");
  gives("a.csv", "\n# c\nx,y,\"w\x1b\"\n0,1,2\n",
        "1 3 unknown-field 3:5 column \"w\\x1b\" is unknown to planar "
        "(--ignore-columns skips it)\nstopped");
  gives("a.csv", "x,y,z\n",
        "1 1 unknown-field 1:5 column \"z\" is unknown to planar "
        "(--ignore-columns skips it)\nstopped");
  gives("a.csv", "x,y,\n",
        "1 1 unknown-field 1:5 column 3 has no name "
        "(--ignore-columns skips it)\nstopped");
  gives("a.csv", "x,y,-\n",
        "1 1 unknown-field 1:5 column \"-\" is unknown to planar "
        "(--ignore-columns skips it)\nstopped");
  gives("a.csv", "x,y,x_m\n",
        "1 1 bad-value 1:5 columns 1 and 3 (\"x_m\") are the same "
        "(--columns can skip it)\nstopped");
  gives("a.csv", "x,knot\n",
        "1 1 missing-field 1:1 column \"y\" is missing: planar needs it for "
        "points\nstopped");
  gives("a.csv", "y,id\n",
        "1 1 missing-field 1:1 column \"x\" is missing: planar needs it for "
        "points\nstopped");
  gives("a.csv", "1,2,3,4\n",
        "1 1 syntax 1:1 the file has no header row: --columns must name its 4 "
        "columns\nstopped");
  gives("a.csv", "1\n",
        "1 1 syntax 1:1 the file has no header row: --columns must name its 1 "
        "column\nstopped");
  gives("a.csv", "a,1,2\n",
        "1 1 syntax 1:1 the file has no header row: --columns must name its 3 "
        "columns\nstopped");
  gives("a.csv", "1,2,3\n",
        "1 1 unknown-field 1:1 the file has no header row and 3 columns, and "
        "planar takes x and y (--columns=x,y,- skips the third)\nstopped");
  gives_with(&csv, &space, "1,2\n",
             "1 1 missing-field 1:1 column \"z\" is missing: spatial needs it "
             "for points\nstopped");
  gives_with(&csv, &space, "x,y,z,knot\n",
             "1 1 unknown-field 1:7 column \"knot\" is unknown to spatial "
             "(--ignore-columns skips it)\nstopped");
}

/* Vectors of the plane have no third column. */
PH_TEST(test_csv_plane) {
  struct ph_split_options named = {.format = PH_SPLIT_CSV,
                                   .columns = "x,y,tx,ty"};
  gives_with(&csv, &plane, "0,1\n2,3\n", "1 1 0,1$2,3$\nend");
  gives_with(&csv, &plane, "x,y,tx,ty\n0,1,2,3\n", "1 2 0,1,2,3$\nend");
  gives_with(&csv, &plane, "# dy,dx,y_m,x_m\n0,1,2,3\n", "1 2 0,1,2,3$\nend");
  gives_with(&named, &plane, "0,1,2,3\n", "1 1 0,1,2,3$\nend");
  gives_with(&csv, &plane, "x,y,tx,ty,tz\n",
             "1 1 unknown-field 1:11 column \"tz\" is unknown to tc; did you "
             "mean \"tx\"? (--ignore-columns skips it)\nstopped");
  gives_with(&csv, &plane, "dx,dy,dz\n",
             "1 1 unknown-field 1:7 column \"dz\" is unknown to tc; did you "
             "mean \"dx\"? (--ignore-columns skips it)\nstopped");
  gives_with(
      &csv, &plane, "0,1,2\n",
      "1 1 unknown-field 1:1 the file has no header row and 3 columns, and "
      "tc takes x and y (--columns=x,y,- skips the third)\nstopped");
  gives_with(&csv, &plane, "0,1,2,3\n",
             "1 1 syntax 1:1 the file has no header row: --columns must name "
             "its 4 columns\nstopped");
  gives_with(&csv, &plane, "x,y,tx\n",
             "1 1 missing-field 1:1 column \"ty\" is missing: tc needs it for "
             "tangents\nstopped");
}

PH_TEST(test_csv_lonlat) {
  gives_with(&csv, &sphere, "lat,LON\n0,1\n", "1 2 0,1$\nend");
  gives_with(&csv, &sphere, "Longitude,latitude\n0,1\n", "1 2 0,1$\nend");
  gives_with(&csv, &sphere, "# lon, lat\n0,1\n", "1 2 0,1$\nend");
  gives_with(&csv, &sphere, "0,1,2\n", "1 1 0,1,2$\nend");
  gives_with(&csv, &sphere, "lon,latitude,longitude\n0,1,2\n",
             "1 1 bad-value 1:14 columns 1 and 3 (\"longitude\") are the same "
             "(--columns can skip it)\nstopped");
  gives_with(&csv, &sphere, "lat\n0\n",
             "1 1 missing-field 1:1 column \"lon\" is missing: sphere needs it "
             "for lonlat\nstopped");
  gives_with(&csv, &sphere, "x,y\n0,1\n",
             "1 1 missing-field 1:1 column \"z\" is missing: sphere needs it "
             "for points\nstopped");
  gives("a.csv", "lon,lat\n0,1\n",
        "1 1 unknown-field 1:1 column \"lon\" is unknown to planar, "
        "but not to sphere\nstopped");
  /* Many files have the latitude first. */
  gives_with(&csv, &sphere, "0,1\n",
             "1 1 syntax 1:1 the file has no header row: --columns=lon,lat or "
             "--columns=lat,lon must say which of its 2 columns is which\n"
             "stopped");
}

PH_TEST(test_csv_broken) {
  gives("a.csv", "x,y\n0,1\n2,\"3\n4,5\n",
        "1 2 syntax 3:3 the quote that begins this cell is never closed\n"
        "stopped");
  gives("a.csv", "id,x,y\na,0,1\n\nb,\"1\"2,3\n",
        "1 2 a,0,1$\n2 4 syntax 4:6 expected ',' or the end of the row after a "
        "quoted cell, found '2'\nstopped");
  gives("a.csv", "\"x",
        "1 1 syntax 1:1 the quote that begins this cell is "
        "never closed\nstopped");
}

PH_TEST(test_csv_options) {
  struct ph_split_options options = {.format = PH_SPLIT_AUTO,
                                     .columns = "x,y,-,-"};
  gives_with(&options, &schema, "0,1,2,3\n", "1 1 0,1,2,3$\nend");
  /* A header is skipped when it is one. */
  gives_with(&options, &schema, "a,b,c,d\n0,1,2,3\n", "1 2 0,1,2,3$\nend");
  gives_with(&options, &schema, "a,b,0,0\n0,1,2,3\n", "1 2 0,1,2,3$\nend");
  gives_with(&options, &schema, "0,b,c,d\n0,1,2,3\n",
             "1 1 0,b,c,d$0,1,2,3$\nend");
  gives_with(&options, &schema, ",,a,b\n0,1,2,3\n", "1 1 ,,a,b$0,1,2,3$\nend");
  gives_with(&options, &schema, "nan,inf,a,b\n", "1 1 nan,inf,a,b$\nend");
  /* Its names are those of --columns, whatever it says. */
  gives_with(&options, &schema, "# y,x\ny,x\n0,1\n", "1 3 0,1$\nend");
  gives_with(&options, &schema, "0,1,2,3,4\n",
             "1 1 bad-shape 1:1 the row has 5 cells, but --columns names 4 "
             "(- skips a column)\nstopped");
  gives_with(&options, &schema, "a,b,c,d,e\n",
             "1 1 bad-shape 1:1 the row has 5 cells, but --columns names 4 "
             "(- skips a column)\nstopped");
  options.columns = " ID , X,Y";
  gives_with(&options, &schema, "a,0,1\na,1,2\nb,0,1\n",
             "1 1 a,0,1$a,1,2$\n2 3 b,0,1$\nend");
  options.delimiter = ';';
  gives_with(&options, &schema, "\"a;b\";0;1\n\"a;b\";1;2\n",
             "1 1 \"a;b\";0;1$\"a;b\";1;2$\nend");
}

static void ck_usage(const struct ph_split_options *options, const char *field,
                     const char *message) {
  struct ph_split split;
  struct ph_diag diag;
  ck_assert_int_eq(ph_split_init(&split, NULL, 0, options, &schema, &diag),
                   PH_E_USAGE);
  ck_assert_str_eq(diag.field, field);
  ck_assert_str_eq(diag.message, message);
  ck_assert_int_eq(diag.status, PH_E_USAGE);
  ck_assert_uint_eq(diag.line + diag.column, 0);
  ph_split_free(&split);
}

PH_TEST(test_usage) {
  struct ph_split_options options = {.format = PH_SPLIT_AUTO,
                                     .columns = "x,yy"};
  ck_usage(&options, "--columns",
           "column \"yy\" is unknown to planar; did you mean \"y\"?");
  options.columns = "x,y,x";
  ck_usage(&options, "--columns", "columns 1 and 3 (\"x\") are the same");
  options.columns = "x,-";
  ck_usage(&options, "--columns",
           "column \"y\" is missing: planar needs it for points");
  options.columns = "";
  ck_usage(&options, "--columns", "column 1 has no name");
  options.columns = NULL;
  options.delimiter = '"';
  ck_usage(&options, "--delimiter", "must be neither a quote nor a line break");
}

PH_FIXTURE(setup, finish)
