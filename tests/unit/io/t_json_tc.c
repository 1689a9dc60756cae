/* SPDX-License-Identifier: GPL-3.0-or-later */
/* JSON records of Tschirnhausen cubics: what was found for the intervals, the
 * image on the Blaschke cylinder, and the choices among solutions. */
#include "unit.h"

#include "io/json_out.h"

#include <cjson/cJSON.h>

static struct ph_buf buf;
static const struct ph_echo nothing = {0};
static const struct ph_heading heading = {&nothing, "tc", NULL, 0,   NULL,
                                          0,        NULL, NULL, NULL};

static void finish(void) {
  ph_buf_free(&buf);
}

static const char *written(void) {
  ph_buf_put(&buf, "", 1);
  ck_assert(!buf.failed);
  return buf.data;
}

static void ck_has(const struct ph_result *result, const char *part) {
  ph_buf_clear(&buf, buf.capacity);
  ph_json_result(&buf, &heading, result, false);
  ck_assert_msg(strstr(written(), part) != NULL, "%s\nis not in\n%s", part,
                buf.data);
}

/* Two cubics by hand: all numbers short, the curve none. */
static double knots[] = {0, 1, 2};
static double points[] = {0, 0, 1, 0, 2, 1, 3, 1, 3, 1, 4, 1, 5, 0, 6, 0};
static double preimage[] = {1, 0, 2, 0.5, 2, 0.5, 1, 0};
static double lengths[] = {3.5, 4};

static struct ph_result by_hand(void) {
  struct ph_result result = {.curve = {.kind = PH_CURVE_TC,
                                       .dimension = 2,
                                       .degree = 3,
                                       .n = 2,
                                       .knots = knots,
                                       .control_points = points,
                                       .preimage.n = 2,
                                       .preimage.dimension = 2,
                                       .preimage.v = preimage,
                                       .lengths = lengths,
                                       .length = 7.5},
                             .area = (double)NAN};
  return result;
}

#define FIRST                                                         \
  "{\"interval\":[0,1],\"control_points\":[[0,0],[1,0],[2,1],[3,1]]," \
  "\"preimage\":[[1,0],[2,0.5]],\"length\":3.5"
#define SECOND                                                        \
  "{\"interval\":[1,2],\"control_points\":[[3,1],[4,1],[5,0],[6,0]]," \
  "\"preimage\":[[2,0.5],[1,0]],\"length\":4"
#define SEGMENTS "\"segments\":[" FIRST "}," SECOND "}]"

PH_TEST(test_curve) {
  struct ph_result result = by_hand();
  ck_has(&result,
         "\"curve\":\"tc\",\"dimension\":2,\"degree\":3,"
         "\"closed\":false," SEGMENTS ",\"length\":7.5,\"diagnostics\":{}}\n");
}

static struct ph_interval interval_of(double length, size_t first, size_t last,
                                      enum ph_root root) {
  struct ph_interval interval = PH_INTERVAL_NONE;
  interval.length = length;
  interval.first = first;
  interval.last = last;
  interval.root = root;
  return interval;
}

/* Of an interval there is only what was found; no lengths are natural. */
PH_TEST(test_intervals) {
  struct ph_result result = by_hand();
  struct ph_interval intervals[] = {
      interval_of(1, 0, 0, PH_ROOT_MINUS),
      interval_of(2, 1, 2, PH_ROOT_PLUS_MINUS),
      interval_of(3, 3, 4, PH_ROOT_ON_CHORD),
      interval_of(4, 5, 5, PH_ROOT_STRAIGHT),
      interval_of(5, 6, 6, PH_ROOT_N),
  };
  intervals[0].ratio = -1.5;
  intervals[1].lambda = 0.75;
  intervals[2].joint_angle = -0.25;
  intervals[2].joint_position = 0.5;
  result.intervals = intervals;
  result.intervals_n = 5;
  ck_has(&result,
         SEGMENTS ",\"intervals\":["
                  "{\"length\":1,\"segments\":[0,0],\"root\":\"-\",\"D\":-1.5},"
                  "{\"length\":2,\"segments\":[1,2],\"root\":\"+-\","
                  "\"lambda\":0.75},"
                  "{\"length\":3,\"segments\":[3,4],\"root\":\"chord\","
                  "\"joint_angle\":-0.25,\"joint_position\":0.5},"
                  "{\"length\":4,\"segments\":[5,5],\"root\":\"straight\"},"
                  "{\"length\":5,\"segments\":[6,6]}],"
                  "\"length\":7.5,\"diagnostics\":{}}\n");
}

PH_TEST(test_diagnostics) {
  struct ph_result result = by_hand();
  struct ph_diagnostics *d = &result.diagnostics;
  ph_diagnostics_set(d, PH_D_DISTANCE, 1e-7);
  ph_diagnostics_set(d, PH_D_REGULAR, 1);
  ph_diagnostics_set(d, PH_D_ROOT, PH_ROOT_PLUS_PLUS);
  ph_diagnostics_set(d, PH_D_RATIO, 0.5);
  ph_diagnostics_set(d, PH_D_LAMBDA, 2);
  ck_has(&result, "\"diagnostics\":{\"distance\":1e-7,\"regular\":true,"
                  "\"root\":\"++\",\"D\":0.5,\"lambda\":2}}\n");
}

/* A piece of which each coordinate tells where it is. */
static struct ph_blaschke piece_of(size_t segment, double from, double to,
                                   double sign) {
  struct ph_blaschke piece = {.segment = segment, .interval = {from, to}};
  for (size_t i = 0; i < 6; i++) {
    piece.weights[i] = (double)(i + 1);
    for (size_t j = 0; j < 3; j++) {
      piece.control_points[i][j] = sign * (double)(10 * i + j);
    }
  }
  return piece;
}

#define PIECE(interval, sign)                                                 \
  "{\"interval\":" interval ",\"control_points\":[[" sign "0," sign "1," sign \
  "2],[" sign "10," sign "11," sign "12],[" sign "20," sign "21," sign        \
  "22],[" sign "30," sign "31," sign "32],[" sign "40," sign "41," sign       \
  "42],[" sign "50," sign "51," sign "52]],"                                  \
  "\"weights\":[1,2,3,4,5,6]}"

#define CUT \
  ",\"blaschke\":[" PIECE("[0,0.25]", "") "," PIECE("[0.25,1]", "-") "]"
#define WHOLE ",\"blaschke\":[" PIECE("[0,1]", "") "]"

/* Pieces are with their segments: one, or two where it was cut. */
PH_TEST(test_blaschke) {
  struct ph_result result = by_hand();
  struct ph_blaschke pieces[] = {
      piece_of(0, 0, 0.25, 1), piece_of(0, 0.25, 1, -1), piece_of(1, 0, 1, 1)};
  result.curve.blaschke.v = pieces;
  result.curve.blaschke.n = 3;
  ck_has(&result,
         "\"segments\":[" FIRST CUT "}," SECOND WHOLE "}],\"length\":7.5");
}

/* Each solution has the choices that led to it, before its length. */
PH_TEST(test_solutions) {
  struct ph_result result = by_hand();
  struct ph_interval first = interval_of(7.5, 0, 1, PH_ROOT_PLUS_PLUS);
  struct ph_interval second = interval_of(7.5, 0, 1, PH_ROOT_MINUS_PLUS);
  struct ph_solution solutions[] = {
      {.curve = result.curve, .intervals = &first, .good = true},
      {.curve = result.curve, .intervals = &second},
      {.curve = result.curve}};
  result.intervals = &first;
  result.intervals_n = 1;
  result.solutions = solutions;
  result.solutions_n = 3;
  ck_has(&result,
         "\"solutions\":[{\"good\":true," SEGMENTS
         ",\"intervals\":[{\"length\":7.5,\"segments\":[0,1],\"root\":\"++\"}]"
         ",\"length\":7.5,\"diagnostics\":{}},{\"good\":false," SEGMENTS
         ",\"intervals\":[{\"length\":7.5,\"segments\":[0,1],\"root\":\"-+\"}]"
         ",\"length\":7.5,\"diagnostics\":{}},{\"good\":false," SEGMENTS
         ",\"length\":7.5,\"diagnostics\":{}}]}\n");
}

/* Indented it is the same value, as deep as it goes. */
PH_TEST(test_pretty) {
  struct ph_result result = by_hand();
  struct ph_interval interval = interval_of(7.5, 0, 1, PH_ROOT_PLUS_PLUS);
  struct ph_blaschke piece = piece_of(1, 0, 1, 1);
  struct ph_solution solution = {.intervals = &interval, .good = true};
  cJSON *indented, *compact;
  result.curve.blaschke.v = &piece;
  result.curve.blaschke.n = 1;
  solution.curve = result.curve;
  result.intervals = &interval;
  result.intervals_n = 1;
  result.solutions = &solution;
  result.solutions_n = 1;
  ck_has(&result, "\"blaschke\":[]");
  compact = cJSON_Parse(buf.data);
  ph_buf_clear(&buf, buf.capacity);
  ph_json_result(&buf, &heading, &result, true);
  indented = cJSON_Parse(written());
  ck_assert(indented && compact);
  ck_assert(cJSON_Compare(indented, compact, true));
  ck_assert_ptr_nonnull(strstr(buf.data, "\n        {\n          \"interval\": "
                                         "[0,1],\n          "
                                         "\"control_points\": [\n"
                                         "            [0,1,2],\n"));
  cJSON_Delete(indented);
  cJSON_Delete(compact);
}

PH_FIXTURE(NULL, finish)
