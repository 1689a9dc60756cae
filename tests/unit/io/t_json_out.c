/* SPDX-License-Identifier: GPL-3.0-or-later */
/* JSON records: byte by byte where that is readable, and read back by cJSON
 * where numbers are many. */
#include "unit.h"
#include "planar_unit.h"

#include "curve/offset/offset.h"
#include "io/json_out.h"

#include <cjson/cJSON.h>

static struct ph_buf buf;
static struct unit_solution u;
static const struct ph_offset_rules rules = {.tolerance = 1e-9};

static void finish(void) {
  ph_buf_free(&buf);
  unit_solution_free(&u);
}

static const struct ph_echo nothing = {0};

/* What was written, which ends in its only line break unless indented. */
static const char *written(void) {
  ph_buf_put(&buf, "", 1);
  ck_assert(!buf.failed);
  ck_assert_uint_eq(strlen(buf.data), buf.n - 1);
  ck_assert_int_eq(buf.data[buf.n - 2], '\n');
  return buf.data;
}

/* A result by hand: one segment, all numbers short. */
static double knots[] = {0, 1.5};
static double points[] = {0, 0, 1, 0, 2, 0.25, 3, -1e-7, 4, 1e21, 5, -0.0};
static double preimage[] = {1, 0, 0.5, 2, 3, -4};
static double lengths[] = {7.25};

static struct ph_result by_hand(void) {
  struct ph_result result = {.curve = {.kind = PH_CURVE_PH,
                                       .dimension = 2,
                                       .degree = 5,
                                       .n = 1,
                                       .knots = knots,
                                       .control_points = points,
                                       .preimage.n = 3,
                                       .preimage.dimension = 2,
                                       .preimage.v = preimage,
                                       .lengths = lengths,
                                       .length = 7.25},
                             .area = (double)NAN};
  ph_diagnostics_set(&result.diagnostics, PH_D_ITERATIONS, 3);
  ph_diagnostics_set(&result.diagnostics, PH_D_LENGTH_ERROR, 1.5e-16);
  return result;
}

#define SEGMENTS                                                         \
  "\"segments\":[{\"interval\":[0,1.5],\"control_points\":[[0,0],[1,0]," \
  "[2,0.25],[3,-1e-7],[4,1e21],[5,-0]],\"preimage\":[[1,0],[0.5,2],"     \
  "[3,-4]],\"length\":7.25}]"

PH_TEST(test_compact) {
  struct ph_result result = by_hand();
  const struct ph_heading heading = {&nothing, "planar", NULL, 0,   NULL,
                                     0,        NULL,     NULL, NULL};
  ph_json_result(&buf, &heading, &result, false);
  ck_assert_str_eq(written(),
                   "{\"command\":\"planar\",\"status\":\"ok\",\"curve\":\"ph\","
                   "\"dimension\":2,\"degree\":5,\"closed\":false," SEGMENTS
                   ",\"length\":7.25,\"diagnostics\":{\"iterations\":3,"
                   "\"length_error\":1.5e-16}}\n");
}

/* The order of members, and what is echoed as it came. */
PH_TEST(test_heading) {
  const struct ph_echo echo = {"\"a\\u00e4\"X", 9, "{\"k\": [1, 2]}X", 13};
  const struct ph_swept swept[] = {{"alpha", "0.5"}, {"knots[1]", "-1e300"}};
  const struct ph_swept set[] = {{"closed", "true"}, {"knots", "[0,1]"}};
  const struct ph_heading heading = {&echo, "planar", swept, 2,   set,
                                     2,     NULL,     NULL,  NULL};
  struct ph_result result = by_hand();
  result.curve.closed = true;
  ph_json_result(&buf, &heading, &result, false);
  ck_assert_str_eq(written(),
                   "{\"id\":\"a\\u00e4\",\"command\":\"planar\",\"status\":"
                   "\"ok\",\"meta\":{\"k\": [1, 2]},\"sweep\":{\"alpha\":0.5,"
                   "\"knots[1]\":-1e300},\"set\":{\"closed\":true,"
                   "\"knots\":[0,1]},\"curve\":\"ph\",\"dimension\":2,"
                   "\"degree\":5,\"closed\":true," SEGMENTS
                   ",\"length\":7.25,\"diagnostics\":{\"iterations\":3,"
                   "\"length_error\":1.5e-16}}\n");
}

PH_TEST(test_warnings) {
  const struct ph_heading heading = {&nothing, "planar", NULL, 0,   NULL,
                                     0,        NULL,     NULL, NULL};
  struct ph_result result = by_hand();
  ph_warn(&result, 3, PH_W_LOOP, "it turns");
  ph_warn(&result, PH_NO_SEGMENT, PH_W_REVERSAL, "so");
  ph_json_result(&buf, &heading, &result, false);
  ck_assert_ptr_nonnull(
      strstr(written(), "},\"warnings\":[{\"code\":\"loop\",\"segment\":3,"
                        "\"message\":\"it turns\"},{\"code\":\"reversal\","
                        "\"message\":\"so\"}]}\n"));
}

static void set_interval(struct ph_interval *interval, double length,
                         double natural_length, size_t first, size_t last) {
  *interval = PH_INTERVAL_NONE;
  interval->length = length;
  interval->natural_length = natural_length;
  interval->first = first;
  interval->last = last;
}

/* Intervals stand beside the segments they consist of; what is natural is told
 * where it is known, and in the certificate when it is known everywhere. */
PH_TEST(test_intervals) {
  const struct ph_heading heading = {&nothing, "arclength", NULL, 0,   NULL,
                                     0,        NULL,        NULL, NULL};
  struct ph_interval intervals[2];
  struct ph_result result = by_hand();
  set_interval(&intervals[0], 3, 2.5, 0, 1);
  set_interval(&intervals[1], 4.25, (double)NAN, 2, 2);
  result.intervals = intervals;
  result.intervals_n = 2;
  ph_json_result(&buf, &heading, &result, false);
  ck_assert_ptr_nonnull(strstr(written(), SEGMENTS
                               ",\"intervals\":[{\"length\":3,"
                               "\"natural_length\":2.5,\"segments\":[0,1]},"
                               "{\"length\":4.25,\"segments\":[2,2]}],"
                               "\"length\":7.25,\"diagnostics\":{"
                               "\"iterations\":3,\"length_error\":"
                               "1.5e-16}}\n"));
  ph_buf_free(&buf);
  intervals[1].natural_length = 4;
  ph_json_result(&buf, &heading, &result, false);
  ck_assert_ptr_nonnull(strstr(written(),
                               "{\"length\":4.25,\"natural_length\":4,"
                               "\"segments\":[2,2]}]"));
  ck_assert_ptr_nonnull(strstr(
      buf.data, "\"length_error\":1.5e-16,\"natural_lengths\":[2.5,4]}}\n"));
}

/* All starts, in the order they were tried, and which of them won. */
PH_TEST(test_starts) {
  const struct ph_heading heading = {&nothing, "arclength", NULL, 0,   NULL,
                                     0,        NULL,        NULL, NULL};
  struct ph_start starts[] = {
      {"init", PH_OUTCOME_NO_SOLUTION, (double)NAN, 200},
      {"chords", PH_OUTCOME_MINIMISER, 0.5, 7},
      {"mirror", PH_OUTCOME_SADDLE, 1e21, 0}};
  struct ph_result result = by_hand();
  result.starts = starts;
  result.starts_n = 3;
  result.start = 1;
  ph_json_result(&buf, &heading, &result, false);
  ck_assert_ptr_nonnull(strstr(
      written(), "\"diagnostics\":{\"iterations\":3,\"length_error\":1.5e-16,"
                 "\"start\":\"chords\",\"starts\":[{\"start\":\"init\","
                 "\"outcome\":\"no-convergence\",\"iterations\":200},"
                 "{\"start\":\"chords\",\"outcome\":\"minimiser\","
                 "\"F\":0.5,\"iterations\":7},{\"start\":\"mirror\","
                 "\"outcome\":\"saddle\",\"F\":1e21,"
                 "\"iterations\":0}]}}\n"));
}

/* Outcomes are words and flags truth values, of each solution, too. */
PH_TEST(test_outcomes) {
  const struct ph_heading heading = {&nothing, "arclength", NULL, 0,   NULL,
                                     0,        NULL,        NULL, NULL};
  struct ph_result result = by_hand();
  struct ph_solution solutions[2];
  for (size_t i = 0; i < 2; i++) {
    solutions[i] = (struct ph_solution){.curve = result.curve, .good = i == 0};
    ph_diagnostics_set(&solutions[i].diagnostics, PH_D_F, 0.25);
    ph_diagnostics_set(&solutions[i].diagnostics, PH_D_SECOND_ORDER,
                       (double)(i ? PH_OUTCOME_SADDLE : PH_OUTCOME_MINIMISER));
    ph_diagnostics_set(&solutions[i].diagnostics, PH_D_PLANAR, (double)i);
  }
  result.diagnostics = solutions[0].diagnostics;
  result.solutions = solutions;
  result.solutions_n = 2;
  ph_json_result(&buf, &heading, &result, false);
  ck_assert_ptr_nonnull(strstr(
      written(),
      "\"length\":7.25,\"diagnostics\":{\"F\":0.25,\"second_order\":"
      "\"minimiser\",\"planar\":false},\"solutions\":[{\"good\":true," SEGMENTS
      ",\"length\":7.25,\"diagnostics\":{\"F\":0.25,"
      "\"second_order\":\"minimiser\",\"planar\":false}},{\"good\":"
      "false," SEGMENTS ",\"length\":7.25,\"diagnostics\":{\"F\":0.25,"
      "\"second_order\":\"saddle\",\"planar\":true}}]}\n"));
}

/* Indented, a result has this part, and is the same value as on one line. */
static void ck_indented(const struct ph_result *result, const char *part) {
  const struct ph_heading heading = {&nothing, "planar", NULL, 0,   NULL,
                                     0,        NULL,     NULL, NULL};
  cJSON *indented, *compact;
  ph_json_result(&buf, &heading, result, true);
  indented = cJSON_Parse(written());
  ck_assert_ptr_nonnull(strstr(buf.data, part));
  ph_buf_free(&buf);
  ph_json_result(&buf, &heading, result, false);
  compact = cJSON_Parse(written());
  ck_assert(indented && compact);
  ck_assert(cJSON_Compare(indented, compact, true));
  cJSON_Delete(indented);
  cJSON_Delete(compact);
}

PH_TEST(test_pretty_intervals) {
  struct ph_interval intervals[2];
  struct ph_start start = {"init", PH_OUTCOME_MINIMISER, 0.5, 7};
  struct ph_result result = by_hand();
  set_interval(&intervals[0], 3, 2.5, 0, 1);
  set_interval(&intervals[1], 4.25, 4, 2, 2);
  result.intervals = intervals;
  result.intervals_n = 2;
  result.starts = &start;
  result.starts_n = 1;
  ck_indented(&result, "\n  \"intervals\": [\n    {\n      \"length\": 3,\n"
                       "      \"natural_length\": 2.5,\n"
                       "      \"segments\": [0,1]\n    },\n");
  ph_buf_free(&buf);
  ck_indented(&result, "\n    \"natural_lengths\": [2.5,4],\n"
                       "    \"start\": \"init\",\n    \"starts\": [\n");
}

PH_TEST(test_pretty) {
  const struct ph_heading heading = {&nothing, "planar", NULL, 0,   NULL,
                                     0,        NULL,     NULL, NULL};
  const struct ph_diag diag = {.status = PH_E_SYNTAX, .message = "no"};
  struct ph_result result = by_hand();
  ck_indented(&result, "\n  \"command\": \"planar\",\n");
  ph_buf_free(&buf);
  ck_indented(&result, "\n      \"interval\": [0,1.5],\n"
                       "      \"control_points\": [\n        [0,0],\n");
  ph_buf_free(&buf);
  ph_json_error(&buf, &heading, &diag, NULL, true);
  ck_assert_str_eq(written(),
                   "{\n  \"command\": \"planar\",\n  \"status\": \"error\",\n"
                   "  \"error\": {\n    \"code\": \"syntax\",\n    "
                   "\"message\": \"no\"\n  }\n}\n");
}

PH_TEST(test_error) {
  const struct ph_echo echo = {"7", 1, "null", 4};
  const struct ph_swept swept = {"closed", "true"};
  const struct ph_heading heading = {&echo, "planar", &swept, 1,   NULL,
                                     0,     NULL,     NULL,   NULL};
  struct ph_diag diag;
  ph_fail_at(&diag, PH_E_COINCIDENT_POINTS, "points", 3,
             "coincides with points[2]");
  diag.line = 12;
  diag.column = 5;
  ph_json_error(&buf, &heading, &diag, "a.json", false);
  ck_assert_str_eq(
      written(),
      "{\"id\":7,\"command\":\"planar\",\"status\":\"error\",\"meta\":null,"
      "\"sweep\":{\"closed\":true},\"error\":{\"code\":\"coincident-points\","
      "\"message\":\"points[3] coincides with points[2]\",\"field\":"
      "\"points[3]\",\"file\":\"a.json\",\"line\":12,\"column\":5}}\n");
}

/* All bytes but NUL, in a message and in a file name: what is special is
 * escaped, text beyond ASCII stays. */
PH_TEST(test_strings) {
  const struct ph_heading heading = {&nothing, "planar", NULL, 0,   NULL,
                                     0,        NULL,     NULL, NULL};
  struct ph_diag diag = {.status = PH_E_INPUT};
  char all[128];
  cJSON *record, *error;
  for (int c = 1; c < 128; c++) {
    all[c - 1] = (char)c;
  }
  all[127] = '\0';
  memcpy(diag.message, all, sizeof all);
  ph_json_error(&buf, &heading, &diag, "\xC3\xA4\xE2\x82\xAC\\\"\n", false);
  record = cJSON_Parse(written());
  ck_assert_ptr_nonnull(record);
  ck_assert_uint_eq(strcspn(buf.data, "\n"), buf.n - 2);
  for (size_t i = 0; i < buf.n - 2; i++) {
    ck_assert((unsigned char)buf.data[i] >= 0x20 && buf.data[i] != 0x7F);
  }
  error = cJSON_GetObjectItem(record, "error");
  ck_assert_str_eq(cJSON_GetObjectItem(error, "message")->valuestring, all);
  ck_assert_str_eq(cJSON_GetObjectItem(error, "file")->valuestring,
                   "\xC3\xA4\xE2\x82\xAC\\\"\n");
  ck_assert_ptr_nonnull(strstr(buf.data, "\"\xC3\xA4\xE2\x82\xAC\\\\\\\"\\u00"
                                         "0a\""));
  cJSON_Delete(record);
}

/* The n numbers of a JSON array, of arrays inside of it, to any depth. */
static const double *ck_numbers(const cJSON *array, const double *v) {
  const cJSON *item;
  ck_assert(cJSON_IsArray(array));
  cJSON_ArrayForEach(item, array) {
    if (cJSON_IsArray(item)) {
      v = ck_numbers(item, v);
    } else {
      ck_assert(cJSON_IsNumber(item));
      ck_abs(item->valuedouble, *v++, 0);
    }
  }
  return v;
}

static const cJSON *member(const cJSON *object, const char *name) {
  const cJSON *item = cJSON_GetObjectItemCaseSensitive(object, name);
  ck_assert_msg(item != NULL, "no member %s", name);
  return item;
}

static void ck_offset(const cJSON *item, const struct ph_offset *o) {
  const cJSON *piece;
  size_t i = 0;
  ck_abs(member(item, "distance")->valuedouble, o->distance, 0);
  ck_assert_int_eq(member(item, "degree")->valueint, 9);
  cJSON_ArrayForEach(piece, member(item, "segments")) {
    ck_abs(member(piece, "segment")->valuedouble, (double)o->segment[i], 0);
    ck_assert_ptr_eq(ck_numbers(member(piece, "interval"), o->interval + 2 * i),
                     o->interval + 2 * i + 2);
    ck_assert_ptr_eq(
        ck_numbers(member(piece, "control_points"), o->control_points + 20 * i),
        o->control_points + 20 * i + 20);
    ck_assert_ptr_eq(ck_numbers(member(piece, "weights"), o->weights + 10 * i),
                     o->weights + 10 * i + 10);
    i++;
  }
  ck_assert_uint_eq(i, o->n);
}

/* A curve with everything: each number reads back as it was. */
PH_TEST(test_read_back) {
  const struct ph_heading heading = {&nothing, "planar", NULL, 0,   NULL,
                                     0,        NULL,     NULL, NULL};
  struct unit_random r = unit_random_of(1);
  struct ph_offset offsets[2];
  const struct ph_curve *c = &u.result.curve;
  double v[40];
  cJSON *record;
  const cJSON *item;
  size_t i = 0;
  for (size_t k = 0; k < 40; k++) {
    v[k] = unit_random_in(&r, -1, 1) * 1e-3;
  }
  u = unit_planar_of(v, 20, true);
  ck_assert_int_eq(unit_planar_solve(&u), PH_OK);
  for (int k = 0; k < 2; k++) {
    ck_assert_int_eq(
        ph_offset(c, k ? -1e-4 : 2e-5, &rules, &u.arena, &offsets[k], &u.diag),
        PH_OK);
  }
  u.result.offsets = offsets;
  u.result.offsets_n = 2;
  ph_json_result(&buf, &heading, &u.result, false);
  record = cJSON_Parse(written());
  ck_assert_ptr_nonnull(record);
  cJSON_ArrayForEach(item, member(record, "segments")) {
    const double *p = c->control_points + 12 * i, *w = c->preimage.v + 6 * i;
    ck_assert_ptr_eq(ck_numbers(member(item, "interval"), c->knots + i),
                     c->knots + i + 2);
    ck_assert_ptr_eq(ck_numbers(member(item, "control_points"), p), p + 12);
    ck_assert_ptr_eq(ck_numbers(member(item, "preimage"), w), w + 6);
    ck_abs(member(item, "length")->valuedouble, c->lengths[i++], 0);
  }
  ck_assert_uint_eq(i, c->n);
  ck_abs(member(record, "length")->valuedouble, c->length, 0);
  i = 0;
  cJSON_ArrayForEach(item, member(record, "offsets")) {
    ck_offset(item, &offsets[i++]);
  }
  ck_assert_uint_eq(i, 2);
  cJSON_Delete(record);
}

/* The vector follows the distance. */
PH_TEST(test_offset_in_space) {
  const struct ph_heading heading = {
      &nothing, "spatial-hermite", NULL, 0, NULL, 0, NULL, NULL, NULL};
  size_t segment = 0, gaps[] = {0, 3};
  double interval[] = {0, 0.5}, p[] = {1, 2, 3, 4, 5, 6}, weights[] = {4, 7};
  struct ph_place cusp = {0, 0.5, 0.75};
  struct ph_offset offset = {.distance = -0.5,
                             .length = (double)NAN,
                             .cusps = {1, &cusp},
                             .gaps = {2, gaps},
                             .vector = "e3",
                             .degree = 1,
                             .dimension = 3,
                             .n = 1,
                             .segment = &segment,
                             .interval = interval,
                             .control_points = p,
                             .weights = weights};
  struct ph_result result = by_hand();
  result.offsets = &offset;
  result.offsets_n = 1;
  ph_json_result(&buf, &heading, &result, false);
  ck_assert_ptr_nonnull(
      strstr(written(),
             "\"offsets\":[{\"distance\":-0.5,\"vector\":\"e3\",\"degree\":1,"
             "\"segments\":[{\"segment\":0,\"interval\":[0,0.5],"
             "\"control_points\":[[1,2,3],[4,5,6]],"
             "\"weights\":[4,7]}],\"cusps\":["
             "{\"segment\":0,\"t\":0.75}],\"gaps\":[0,3]}]"));
}

static size_t at[] = {0, 0};
static double t[] = {0, 0.5}, length[] = {0, 2};
static double place[] = {1, 2, 3, 4, 5, 6}, tangent[] = {1, 0, 0, 0, 1, 0};
static double curvature[] = {-3, 0.5};
static double torsion[] = {0.25, -1}, lonlat[] = {-180, 90, 7, 8};

static struct ph_samples samples_of(size_t dimension) {
  return (struct ph_samples){.n = 2,
                             .dimension = dimension,
                             .segment = at,
                             .t = t,
                             .s = length,
                             .point = place,
                             .tangent = tangent,
                             .curvature = curvature};
}

/* What is not finite is left out. */
PH_TEST(test_samples) {
  const struct ph_heading heading = {&nothing, "planar", NULL, 0,   NULL,
                                     0,        NULL,     NULL, NULL};
  struct ph_result result = by_hand();
  double none[] = {-3, (double)NAN};
  double no_tangent[] = {1, 0, (double)NAN, (double)NAN};
  result.samples = samples_of(2);
  ph_json_result(&buf, &heading, &result, false);
  ck_assert_ptr_nonnull(strstr(
      written(),
      "\"length\":7.25,\"samples\":[{\"segment\":0,\"t\":0,\"s\":0,\"point\":"
      "[1,2],\"tangent\":[1,0],\"curvature\":-3},{\"segment\":0,\"t\":0.5,"
      "\"s\":2,\"point\":[3,4],\"tangent\":[0,0],\"curvature\":0.5}],"
      "\"diagnostics\""));
  ph_buf_clear(&buf, buf.capacity);
  result.samples.curvature = none;
  result.samples.tangent = no_tangent;
  ph_json_result(&buf, &heading, &result, false);
  ck_assert_ptr_nonnull(
      strstr(written(), "\"curvature\":-3},{\"segment\":0,\"t\":0.5,\"s\":2,"
                        "\"point\":[3,4]}]"));
  ph_buf_clear(&buf, buf.capacity);
  result.samples = samples_of(3);
  result.samples.torsion = torsion;
  ph_json_result(&buf, &heading, &result, false);
  ck_assert_ptr_nonnull(strstr(written(),
                               "\"point\":[4,5,6],\"tangent\":[0,1,0],"
                               "\"curvature\":0.5,\"torsion\":-1}]"));
}

/* What only a curve on a sphere has, and its offsets. */
PH_TEST(test_on_sphere) {
  const struct ph_heading heading = {&nothing, "sphere", NULL, 0,   NULL,
                                     0,        NULL,     NULL, NULL};
  struct ph_result result = by_hand();
  double tensions[] = {0, 12.5};
  signed char indicators[] = {0, -1};
  struct ph_place cusps[] = {{0, 0.5, 0.25}, {0, 1, 1}};
  struct ph_offset offsets[] = {
      {.distance = -0.5, .length = 9, .cusps = {2, cusps}},
      {.distance = 0.5, .length = 8}};
  offsets[0].samples = offsets[1].samples = samples_of(3);
  offsets[0].samples.n = 1;
  offsets[0].samples.lonlat = offsets[1].samples.lonlat = lonlat;
  result.curve.kind = PH_CURVE_SPHERICAL_NU;
  result.curve.sphere.radius = 2;
  result.curve.sphere.center[1] = 1;
  result.curve.sphere.tensions = tensions;
  result.curve.sphere.indicators = indicators;
  result.offsets = offsets;
  result.offsets_n = 2;
  ph_json_result(&buf, &heading, &result, false);
  ck_assert_ptr_nonnull(strstr(
      written(),
      "\"length\":7.25}],\"center\":[0,1,0],\"radius\":2,"
      "\"tensions\":[0,12.5],\"indicators\":[0,-1],\"length\":7.25,"
      "\"offsets\":[{\"distance\":-0.5,\"length\":9,\"cusps\":["
      "{\"segment\":0,\"t\":0.25},{\"segment\":0,\"t\":1}],\"gaps\":[],"
      "\"samples\":[{\"segment\":0,\"t\":0,\"s\":0,\"point\":[1,2,3],"
      "\"tangent\":[1,0,0],\"curvature\":-3,\"lonlat\":[-180,90]}]},"
      "{\"distance\":0.5,\"length\":8,\"cusps\":[],\"gaps\":[],\"samples\":["));
  /* A closed curve has as many nodes as segments. */
  ph_buf_clear(&buf, buf.capacity);
  result.curve.closed = true;
  ph_json_result(&buf, &heading, &result, false);
  ck_assert_ptr_nonnull(
      strstr(written(), "\"tensions\":[0],\"indicators\":[0],"));
}

/* When memory runs out the writer goes on without harm, and the buffer says
 * so in the end. */
PH_TEST(test_failed_buffer) {
  const struct ph_heading heading = {&nothing, "planar", NULL, 0,   NULL,
                                     0,        NULL,     NULL, NULL};
  struct ph_result result = by_hand();
  ck_assert_ptr_null(ph_buf_reserve(&buf, SIZE_MAX - 10));
  ph_json_result(&buf, &heading, &result, true);
  ck_assert(buf.failed);
  ck_assert_uint_eq(buf.n, 0);
}

PH_FIXTURE(NULL, finish)
