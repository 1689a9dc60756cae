/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The splitter's GeoJSON: what is a problem, what its text is, what is wrong
 * with others, and that portions make no difference.
 */
#include "split_unit.h"

static const struct ph_split_options geojson = {.format = PH_SPLIT_GEOJSON};

#define LINE "{\"type\":\"LineString\",\"coordinates\":[[0,1],[2,3]]}"
#define OUT "{\"points\":[[0,1],[2,3]]}"

PH_TEST(test_geometries) {
  gives("a.json", LINE, "1 1 " OUT "\nend");
  gives("a.json", "{\"type\":\"MultiPoint\",\"coordinates\":[[0,1]]}",
        "1 1 {\"points\":[[0,1]]}\nend");
  gives("a.json",
        "{\"type\":\"MultiLineString\",\n\"coordinates\":[[[0,1]],\n"
        "[[2,3],\n[4,5]]]}",
        "1 2 {\"points\":[[0,1]]}\n2 3 {\"points\":[[2,3],$[4,5]]}\nend");
  gives("a.json", "{\"type\":\"Polygon\",\"coordinates\":[[[0,1]],[[2,3]]]}",
        "1 1 {\"points\":[[0,1]],\"closed\":true}\n"
        "2 1 {\"points\":[[2,3]],\"closed\":true}\nend");
  gives("a.json",
        "{\"type\":\"MultiPolygon\",\"coordinates\":"
        "[[[[0,1]],[[2,3]]],[],[[[4,5]]]]}",
        "1 1 {\"points\":[[0,1]],\"closed\":true}\n"
        "2 1 {\"points\":[[2,3]],\"closed\":true}\n"
        "3 1 {\"points\":[[4,5]],\"closed\":true}\nend");
  gives("a.json",
        "{\"type\":\"GeometryCollection\",\"geometries\":[" LINE
        ",{\"type\":\"GeometryCollection\",\"geometries\":[" LINE "]}]}" LINE,
        "1 1 " OUT "\n2 1 " OUT "\n3 1 " OUT "\nend");
}

PH_TEST(test_features) {
  gives("a.json",
        "{\"type\":\"Feature\",\"id\":\"a\",\"properties\":{\"b\":1},"
        "\"geometry\":" LINE "}",
        "1 1 {\"id\":\"a\",\"points\":[[0,1],[2,3]],\"meta\":{\"b\":1}}\nend");
  gives("a.json",
        "{\"type\":\"Feature\",\"properties\":null,\"id\":5,\"geometry\":{"
        "\"type\":\"MultiLineString\",\"coordinates\":[[],[]]}}",
        "1 1 {\"id\":\"5/1\",\"points\":[]}\n"
        "2 1 {\"id\":\"5/2\",\"points\":[]}\nend");
  /* an elevation is no part of a curve in the plane */
  gives("a.json",
        "{\"type\":\"Feature\",\"properties\":{\"b\":1},\"geometry\":{\"type\":"
        "\"LineString\",\"coordinates\":[[0,1,\n7,8],[2,3],\n[4,5,9e0]]}}",
        "1 1 {\"points\":[[0,1]$,[2,3],$[4,5]],"
        "\"meta\":{\"b\":1,\"elevation\":[7,null,9e0]}}\nend");
  gives("a.json", "{\"type\":\"LineString\",\"coordinates\":[[0,1,7]]}",
        "1 1 {\"points\":[[0,1]],\"meta\":{\"elevation\":[7]}}\nend");
  gives("a.json",
        "{\"type\":\"Feature\",\"properties\":{\"elevation\":1},\"geometry\":"
        "{\"type\":\"LineString\",\"coordinates\":[[0,1,7]]}}",
        "1 1 {\"points\":[[0,1]],\"meta\":{\"elevation\":1}}\nend");
  gives_with(&geojson, &space,
             "{\"type\":\"LineString\",\"coordinates\":[[0,1,7]]}",
             "1 1 {\"points\":[[0,1,7]]}\nend");
  gives_with(&geojson, &sphere,
             "{\"type\":\"LineString\",\"coordinates\":[[0,1,7]]}",
             "1 1 {\"lonlat\":[[0,1]],\"meta\":{\"elevation\":[7]}}\nend");
}

#define FEATURE "{\"type\":\"Feature\",\"geometry\":" LINE "}"

PH_TEST(test_collections) {
  gives("a.json", "{\"type\":\"FeatureCollection\",\"features\":[]}", "end");
  gives("a.json",
        "{\"type\":\"FeatureCollection\",\"name\":{\"features\":[1]},"
        "\n\"features\":[\n" FEATURE ",\n" FEATURE
        "],\"x\":[{\"y\":\"]}\"}]}" LINE,
        "1 3 " OUT "\n2 4 " OUT "\n3 4 " OUT "\nend");
  gives("a.json", "{\"features\" : [" FEATURE "], \"type\":\"FeatureCollec\"}",
        "1 1 " OUT "\nend");
  gives("a.txt", "[" FEATURE "," LINE "]", "1 1 " OUT "\n2 1 " OUT "\nend");
  gives("a.json", "{\"type\":\"FeatureCollection\",\"features\":[" LINE "}",
        "1 1 " OUT "\n2 1 syntax 1:90 expected ',' or ']', found '}'\nstopped");
  gives("a.json", "{\"type\":\"FeatureCollection\",\"features\":[",
        "1 1 syntax 1:41 the text ends inside an array\nstopped");
  gives("a.json", "{\"type\":\"FeatureCollection\",\"features\":[],\"a\" 1}",
        "1 1 syntax 1:47 expected ':', found '1'\nstopped");
  gives("a.json", "{\"type\":\"FeatureCollection\",\"features\":[]",
        "1 1 syntax 1:42 the text ends inside an object\nstopped");
  gives("a.json", "{\"type\":\"FeatureCollection\"",
        "1 1 syntax 1:28 the text ends inside an object\nstopped");
}

PH_TEST(test_sequences) {
  gives("a.txt", "\x1e" LINE "\n\x1e\x1e\n" LINE "\n",
        "1 1 " OUT "\n2 3 " OUT "\nend");
  gives("a.json", "\n\x1e{\"type\":\n\x1e" LINE "\x1e}\x1e\n" LINE,
        "1 2 syntax 3:1 expected a value, found '\\x1e'\n2 3 " OUT
        "\n3 3 syntax 3:52 expected a value, found '}'\n4 4 " OUT "\nend");
  gives("a.txt",
        "\x1e{\"type\":\"FeatureCollection\",\"features\":[" LINE "\x1e" LINE,
        "1 1 " OUT "\n2 1 syntax 1:91 expected ',' or ']', found '\\x1e'\n"
        "3 1 " OUT "\nend");
  /* one text a line */
  gives("a.txt", LINE "\n{\"type\":\"Line\n" LINE "\n",
        "1 1 " OUT "\n2 2 syntax 2:14 the text ends inside a string\n3 3 " OUT
        "\nend");
}

/* What is no line, and where that stands. */
PH_TEST(test_failures) {
  static const struct {
    const char *text, *expected;
  } cases[] = {
      {"1", "1 1 bad-type 1:1 GeoJSON must be an object, found a number"},
      {"{}", "1 1 missing-field 1:1 type: is missing in this object of "
             "GeoJSON"},
      {"{\"type\":1}",
       "1 1 bad-type 1:9 type: must be a string, found a number"},
      {"{\"type\":\"Linestring\"}",
       "1 1 bad-value 1:9 type: is \"Linestring\", which is no GeoJSON here; "
       "did you mean \"LineString\"?"},
      {"{\"type\":\"Point\",\"type\":\"Point\"}",
       "1 1 bad-value 1:24 type: occurs twice"},
      {"{\"type\":\"Point\",\"coordinates\":[1,2]}",
       "1 1 bad-value 1:9 type: is Point, and no curve goes through one point; "
       "read are LineString, Polygon, these with Multi, and MultiPoint"},
      {"{\"type\":\"LineString\"}",
       "1 1 missing-field 1:1 coordinates: is missing in this LineString"},
      {"{\"type\":\"Polygon\",\"coordinates\":{}}",
       "1 1 bad-type 1:33 coordinates: must be an array, found an object"},
      {"{\"type\":\"Polygon\",\"coordinates\":[\n3,[]]}",
       "1 2 bad-type 2:1 coordinates: must be an array, found a number\n"
       "2 2 {\"points\":[],\"closed\":true}"},
      {"{\"type\":\"Polygon\",\"coordinates\":[]}",
       "1 1 bad-value 1:1 there is no line in this geometry"},
      {"{\"type\":\"GeometryCollection\"}",
       "1 1 missing-field 1:1 geometries: is missing in this "
       "GeometryCollection"},
      {"{\"type\":\"GeometryCollection\",\"geometries\":[1]}",
       "1 1 bad-type 1:44 geometry: must be an object, found a number"},
      {"{\"type\":\"GeometryCollection\",\"geometries\":[{\"type\":"
       "\"Feature\"}]}",
       "1 1 bad-value 1:52 type: is \"Feature\", which is no geometry of "
       "GeoJSON"},
      {"{\"type\":\"Feature\"}",
       "1 1 missing-field 1:1 geometry: is missing in this Feature"},
      {"{\"type\":\"Feature\",\"id\":1,\n\"geometry\":null}",
       "1 2 bad-value 2:12 geometry: is null: the feature has no line"},
      {"{\"type\":\"FeatureCollection\"}",
       "1 1 missing-field 1:1 features: is missing in this FeatureCollection"},
      {"{\"type\":\"FeatureCollection\",\"features\":1}",
       "1 1 bad-type 1:40 features: must be an array"},
      {"{\"type\":\"FeatureCollection\",\"features\":[{\"type\":"
       "\"FeatureCollection\",\"features\":[]}]}",
       "1 1 bad-type 1:80 features: must stand in one FeatureCollection, not "
       "in one of others"},
  };
  for (size_t i = 0; i < COUNT(cases); i++) {
    char expected[512];
    snprintf(expected, sizeof expected, "%s\nend", cases[i].expected);
    gives_with(&geojson, &schema, cases[i].text, expected);
  }
}

/* What is taken for GeoJSON, and what for problems. */
PH_TEST(test_told) {
  struct ph_split_options json = {.format = PH_SPLIT_JSON};
  gives("a.txt", "{\"geometry\":null,\"type\":\"Feature\"}",
        "1 1 bad-value 1:13 geometry: is null: the feature has no line\nend");
  gives("a.txt", "{\"type\":\"line\"}", "1 1 {\"type\":\"line\"}\nend");
  gives("a.txt", "{\"points\":[],\"type\":\"LineString\"}",
        "1 1 {\"points\":[],\"type\":\"LineString\"}\nend");
  gives("a.txt", "{\"type\"",
        "1 1 syntax 1:8 the text ends inside an object\n"
        "stopped");
  gives_with(&json, &schema, LINE, "1 1 " LINE "\nend");
}

/* Features that are too long, one by one. */
PH_TEST(test_over) {
  struct ph_split_options most = {.most = 90};
  gives_with(
      &most, &schema,
      "{\"type\":\"FeatureCollection\",\"features\":[" FEATURE
      ",{\"type\":\"Feature\",\"id\":7,\"geometry\":{\"type\":\"LineString\","
      "\"coordinates\":[[0,1],[2,3],[4,5]]}}," FEATURE "]}",
      "1 1 " OUT "\n2 1 limit 1:0 the record is longer than the 90 bytes of "
      "--max-record-bytes {\"id\":7}\n3 1 " OUT "\nend");
}

PH_TEST(test_portions) {
  static const char *const texts[] = {
      "{\"type\":\"FeatureCollection\",\"features\":[" FEATURE "," FEATURE
      "],\"a\":[1,{}]} " LINE,
      " \n\x1e" LINE "\n\x1e{\"type\":\n\x1e{\"type\":\"FeatureCollection\","
      "\"features\":[" LINE "\x1e" LINE "\x1e[" LINE "]",
      "{\"type\":\"MultiLineString\",\"coordinates\":[[[0,1,2]],3,[[4,5]]]}",
      "{\"type\":\"FeatureCollection\",\"features\":[" LINE "],}" LINE,
      LINE "\n{\"type\":\"Line\n" LINE "\n",
  };
  static const size_t most[] = {0, 30, 60};
  for (size_t i = 0; i < COUNT(texts); i++) {
    for (size_t k = 0; k < COUNT(most); k++) {
      struct ph_split_options options = {.most = most[k]};
      ck_portions(&options, texts[i], strlen(texts[i]));
    }
  }
}

/* Memory is that of a feature, and of its problem, however many there are. */
PH_TEST(test_memory) {
  const size_t n = (size_t)unit_count(200000);
  const char *name = "a.json";
  struct ph_split split;
  struct ph_record record;
  struct ph_diag diag;
  FILE *file = fopen(name, "w");
  ck_assert_ptr_nonnull(file);
  fputs("{\"type\":\"FeatureCollection\",\"features\":[" FEATURE, file);
  for (size_t i = 1; i < n; i++) {
    fputs(",\n" FEATURE, file);
  }
  fputs("]}", file);
  fclose(file);
  begin(&split, &name, 1, &automatic, &schema);
  for (size_t i = 0; i < n; i++) {
    ck_assert_int_eq(ph_split_next(&split, true, &record, &diag),
                     PH_SPLIT_RECORD);
    ck_assert_uint_eq(record.line, i + 1);
    ck_assert_uint_eq(record.number, i + 1);
    ck_assert_uint_le(split.capacity, 1 << 17);
  }
  ck_assert_int_eq(ph_split_next(&split, true, &record, &diag), PH_SPLIT_END);
  ph_split_free(&split);
}

PH_FIXTURE(setup, finish)
