/* SPDX-License-Identifier: GPL-3.0-or-later */
/* CSV tables: header, rows, and quoting where it is needed. */
#include "unit.h"

#include "io/csv_out.h"

static struct ph_buf buf;

static void finish(void) {
  ph_buf_free(&buf);
}

static void ck_written(const char *expected) {
  ph_buf_put(&buf, "", 1);
  ck_assert(!buf.failed);
  ck_assert_str_eq(buf.data, expected);
  ph_buf_clear(&buf, buf.capacity);
}

static const struct ph_swept swept[] = {{"knots[1]", "0.5"},
                                        {"odd,name", "[0,1]"}};

static void header(struct ph_csv_shape shape, const struct ph_swept *names,
                   size_t n) {
  ph_csv_header(&buf, &shape, names, n);
}

/* Rows of CSV, in the plane. */
static void rows(enum ph_table table, const struct ph_csv_heading *heading,
                 const struct ph_result *result) {
  const struct ph_csv_shape shape = {.table = table, .space = PH_PLANE};
  ph_csv_result(&buf, &shape, heading, result);
}

PH_TEST(test_headers) {
  header((struct ph_csv_shape){.table = PH_TABLE_CONTROL_POINTS,
                               .space = PH_PLANE},
         NULL, 0);
  ck_written("id,segment,index,x,y\n");
  header((struct ph_csv_shape){.table = PH_TABLE_CONTROL_POINTS,
                               .space = PH_SPACE},
         NULL, 0);
  ck_written("id,segment,index,x,y,z\n");
  header((struct ph_csv_shape){.table = PH_TABLE_LENGTHS, .space = PH_PLANE},
         swept, 1);
  ck_written("id,segment,t0,t1,length,cumulative,knots[1]\n");
  header((struct ph_csv_shape){.table = PH_TABLE_OFFSETS, .space = PH_PLANE},
         swept, 2);
  ck_written("id,distance,segment,index,x,y,weight,knots[1],\"odd,name\"\n");
  header((struct ph_csv_shape){.table = PH_TABLE_LENGTHS, .space = PH_SPACE},
         NULL, 0);
  ck_written("id,segment,t0,t1,length,cumulative\n");
  header((struct ph_csv_shape){.table = PH_TABLE_OFFSETS, .space = PH_SPACE},
         swept, 1);
  ck_written("id,distance,segment,index,x,y,z,weight,vector,knots[1]\n");
  header((struct ph_csv_shape){.table = PH_TABLE_SAMPLES, .space = PH_PLANE},
         NULL, 0);
  ck_written("id,segment,t,s,x,y,tx,ty,curvature\n");
  header((struct ph_csv_shape){.table = PH_TABLE_SAMPLES, .space = PH_SPACE},
         NULL, 0);
  ck_written("id,segment,t,s,x,y,z,tx,ty,tz,curvature,torsion\n");
}

PH_TEST(test_headers_on_sphere) {
  header((struct ph_csv_shape){.table = PH_TABLE_CONTROL_POINTS,
                               .space = PH_SPHERE},
         NULL, 0);
  ck_written("id,segment,index,x,y,z\n");
  header((struct ph_csv_shape){.table = PH_TABLE_LENGTHS, .space = PH_SPHERE},
         NULL, 0);
  ck_written("id,segment,t0,t1,length,cumulative\n");
  header((struct ph_csv_shape){.table = PH_TABLE_SAMPLES, .space = PH_SPHERE},
         swept, 1);
  ck_written("id,segment,t,s,x,y,z,tx,ty,tz,curvature,lon,lat,knots[1]\n");
  header((struct ph_csv_shape){.table = PH_TABLE_OFFSETS, .space = PH_SPHERE},
         NULL, 0);
  ck_written("id,distance,segment,t,s,x,y,z,tx,ty,tz,curvature,lon,lat\n");
}

/* Two segments of degree 1, which the table does not mind. */
static double knots[] = {0, 0.5, 2};
static double points[] = {0, 0, 1, -2.5, 1, -2.5, 1e21, 1e-7};
static double lengths[] = {0.1, 0.2};

static struct ph_result by_hand(void) {
  struct ph_result result = {.curve = {.dimension = 2,
                                       .degree = 1,
                                       .n = 2,
                                       .knots = knots,
                                       .control_points = points,
                                       .lengths = lengths,
                                       .length = 0.3}};
  return result;
}

PH_TEST(test_control_points) {
  const struct ph_csv_heading heading = {"r1", NULL, 0, NULL, 0};
  struct ph_result result = by_hand();
  rows(PH_TABLE_CONTROL_POINTS, &heading, &result);
  ck_written("r1,0,0,0,0\nr1,0,1,1,-2.5\nr1,1,0,1,-2.5\nr1,1,1,1e21,1e-7\n");
}

PH_TEST(test_lengths) {
  const struct ph_csv_heading heading = {"", swept, 2, NULL, 0};
  struct ph_result result = by_hand();
  rows(PH_TABLE_LENGTHS, &heading, &result);
  /* The sum is that of the two doubles, correctly rounded. */
  ck_written(",0,0,0.5,0.1,0.1,0.5,\"[0,1]\"\n"
             ",1,0.5,2,0.2,0.30000000000000004,0.5,\"[0,1]\"\n");
}

/* Pieces of one segment go on counting, the next segment begins anew, and so
 * does the next offset. */
PH_TEST(test_offsets) {
  const struct ph_csv_heading heading = {"7", NULL, 0, NULL, 0};
  size_t segment[] = {0, 0, 1};
  double p[] = {0, 1, 2, 3, 2, 3, 4, 5, 6, 7, 8, 9};
  double weight[] = {1, 2, 2, 3, 0.5, 0.25};
  struct ph_offset offsets[2];
  struct ph_result result = by_hand();
  for (int i = 0; i < 2; i++) {
    offsets[i] = (struct ph_offset){.distance = i ? -0.5 : 1,
                                    .degree = 1,
                                    .dimension = 2,
                                    .n = i ? 1 : 3,
                                    .segment = segment,
                                    .control_points = p,
                                    .weights = weight};
  }
  result.offsets = offsets;
  result.offsets_n = 2;
  rows(PH_TABLE_OFFSETS, &heading, &result);
  ck_written("7,1,0,0,0,1,1\n7,1,0,1,2,3,2\n7,1,0,2,2,3,2\n7,1,0,3,4,5,3\n"
             "7,1,1,0,6,7,0.5\n7,1,1,1,8,9,0.25\n"
             "7,-0.5,0,0,0,1,1\n7,-0.5,0,1,2,3,2\n");
}

PH_TEST(test_offsets_in_space) {
  const struct ph_csv_heading heading = {"7", swept, 1, NULL, 0};
  size_t segment = 0;
  double p[] = {1, 2, 3, 4, 5, 6}, weight[] = {1, 2};
  struct ph_offset offsets[2];
  struct ph_result result = by_hand();
  for (int i = 0; i < 2; i++) {
    offsets[i] = (struct ph_offset){.distance = 0.5,
                                    .vector = i ? "e3" : "e2",
                                    .degree = 1,
                                    .dimension = 3,
                                    .n = 1,
                                    .segment = &segment,
                                    .control_points = p,
                                    .weights = weight};
  }
  result.offsets = offsets;
  result.offsets_n = 2;
  rows(PH_TABLE_OFFSETS, &heading, &result);
  ck_written("7,0.5,0,0,1,2,3,1,e2,0.5\n7,0.5,0,1,4,5,6,2,e2,0.5\n"
             "7,0.5,0,0,1,2,3,1,e3,0.5\n7,0.5,0,1,4,5,6,2,e3,0.5\n");
}

/* Two samples, the second where the curve stands still. */
static size_t at[] = {0, 1};
static double t[] = {0, 0.5}, length[] = {0, 2};
static double place[] = {1, 2, 3, 4, 5, 6}, tangent[] = {1, 0, 0, 0, 1, 0};
static double curvature[] = {-3, (double)NAN};
static double torsion[] = {0.25, (double)NAN}, lonlat[] = {-180, 90, 7, 8};

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

PH_TEST(test_samples) {
  const struct ph_csv_heading heading = {"7", swept, 1, NULL, 0};
  struct ph_result result = by_hand();
  rows(PH_TABLE_SAMPLES, &heading, &result);
  ck_written("");
  result.samples = samples_of(2);
  rows(PH_TABLE_SAMPLES, &heading, &result);
  ck_written("7,0,0,0,1,2,1,0,-3,0.5\n7,1,0.5,2,3,4,0,0,,0.5\n");
  result.samples = samples_of(3);
  result.samples.torsion = torsion;
  rows(PH_TABLE_SAMPLES, &heading, &result);
  ck_written("7,0,0,0,1,2,3,1,0,0,-3,0.25,0.5\n"
             "7,1,0.5,2,4,5,6,0,1,0,,,0.5\n");
}

/* Of a curve on a sphere, and of its offset. */
PH_TEST(test_samples_on_sphere) {
  const struct ph_csv_heading heading = {"7", NULL, 0, NULL, 0};
  struct ph_csv_shape shape = {.table = PH_TABLE_SAMPLES, .space = PH_SPHERE};
  struct ph_offset offset = {.distance = -0.5};
  struct ph_result result = by_hand();
  result.samples = samples_of(3);
  result.samples.lonlat = lonlat;
  offset.samples = result.samples;
  ph_csv_result(&buf, &shape, &heading, &result);
  ck_written("7,0,0,0,1,2,3,1,0,0,-3,-180,90\n"
             "7,1,0.5,2,4,5,6,0,1,0,,7,8\n");
  result.offsets = &offset;
  result.offsets_n = 1;
  shape.offsets = true;
  ph_csv_result(&buf, &shape, &heading, &result);
  ck_written("7,0,0,0,1,2,3,1,0,0,-3,-180,90,0\n"
             "7,1,0.5,2,4,5,6,0,1,0,,7,8,0\n"
             "7,0,0,0,1,2,3,1,0,0,-3,-180,90,-0.5\n"
             "7,1,0.5,2,4,5,6,0,1,0,,7,8,-0.5\n");
  shape.table = PH_TABLE_OFFSETS;
  ph_csv_result(&buf, &shape, &heading, &result);
  ck_written("7,-0.5,0,0,0,1,2,3,1,0,0,-3,-180,90\n"
             "7,-0.5,1,0.5,2,4,5,6,0,1,0,,7,8\n");
}

/* Columns for gnuplot and awk, with all that samples may have. */
PH_TEST(test_text) {
  static double normal[] = {0, 1, 0, (double)NAN, (double)NAN, (double)NAN};
  static double binormal[] = {0, 0, 1, (double)NAN, (double)NAN, (double)NAN};
  const struct ph_swept word = {"knots", "\"uniform\""};
  const struct ph_csv_heading heading = {"no 7", &word, 1, NULL, 0};
  struct ph_csv_shape shape = {.table = PH_TABLE_SAMPLES,
                               .text = true,
                               .space = PH_SPACE,
                               .offsets = true,
                               .frame = true};
  struct ph_offset offset = {.distance = -0.5, .vector = "e2"};
  struct ph_result result = by_hand();
  result.samples = samples_of(3);
  result.samples.torsion = torsion;
  offset.samples = result.samples;
  offset.samples.n = 1;
  result.samples.normal = normal;
  result.samples.binormal = binormal;
  result.offsets = &offset;
  result.offsets_n = 1;
  header(shape, &word, 1);
  ck_written("# id segment t s x y z tx ty tz curvature torsion nx ny nz bx by "
             "bz distance vector knots\n");
  ph_csv_result(&buf, &shape, &heading, &result);
  ck_written("no_7 0 0 0 1 2 3 1 0 0 -3 0.25 0 1 0 0 0 1 0 - uniform\n"
             "no_7 1 0.5 2 4 5 6 0 1 0 NaN NaN NaN NaN NaN NaN NaN NaN 0 - "
             "uniform\n\n"
             "no_7 0 0 0 1 2 3 1 0 0 -3 0.25 NaN NaN NaN NaN NaN NaN -0.5 e2 "
             "uniform\n\n\n");
}

/* Parts of an offset, each after a blank line but the first: also where a curve
 * that is closed has its joint. */
PH_TEST(test_parts) {
  size_t before[] = {0, 1}, segment[] = {0, 1};
  double weights[] = {1, 1};
  const struct ph_csv_heading heading = {"7", NULL, 0, NULL, 0};
  struct ph_csv_shape shape = {.table = PH_TABLE_SAMPLES,
                               .text = true,
                               .space = PH_PLANE,
                               .offsets = true};
  struct ph_offset offset = {
      .distance = 2, .dimension = 2, .gaps = {2, before}};
  struct ph_result result = by_hand();
  result.samples = samples_of(2);
  offset.samples = result.samples;
  result.offsets = &offset;
  result.offsets_n = 1;
  ph_csv_result(&buf, &shape, &heading, &result);
  ck_written("7 0 0 0 1 2 1 0 -3 0\n7 1 0.5 2 3 4 0 0 NaN 0\n\n"
             "7 0 0 0 1 2 1 0 -3 2\n\n7 1 0.5 2 3 4 0 0 NaN 2\n\n\n");
  shape.table = PH_TABLE_OFFSETS;
  offset.n = 2;
  offset.segment = segment;
  offset.control_points = result.samples.point;
  offset.weights = weights;
  ph_csv_result(&buf, &shape, &heading, &result);
  ck_written("7 2 0 0 1 2 1\n\n7 2 1 0 3 4 1\n\n\n");
  shape.text = false;
  ph_csv_result(&buf, &shape, &heading, &result);
  ck_written("7,2,0,0,1,2,1\n7,2,1,0,3,4,1\n");
}

PH_TEST(test_no_offsets) {
  const struct ph_csv_heading heading = {"7", NULL, 0, NULL, 0};
  struct ph_result result = by_hand();
  rows(PH_TABLE_OFFSETS, &heading, &result);
  ck_written("");
}

/* RFC 4180: a comma, a quote or a line break puts quotes around the cell. */
PH_TEST(test_quoting) {
  const char *const ids[][2] = {{"plain id", "plain id"},
                                {"a,b", "\"a,b\""},
                                {"say \"so\"", "\"say \"\"so\"\"\""},
                                {"\"", "\"\"\"\""},
                                {"two\nlines", "\"two\nlines\""},
                                {"cr\rhere", "\"cr\rhere\""},
                                {"\xC3\xA4;'", "\xC3\xA4;'"}};
  struct ph_result result = by_hand();
  result.curve.n = 1;
  for (size_t i = 0; i < COUNT(ids); i++) {
    const struct ph_csv_heading heading = {ids[i][0], NULL, 0, NULL, 0};
    char expected[64] = "";
    strcat(strcat(expected, ids[i][1]), ",0,0,0.5,0.1,0.1\n");
    rows(PH_TABLE_LENGTHS, &heading, &result);
    ck_written(expected);
  }
}

PH_TEST(test_failed_buffer) {
  const struct ph_csv_heading heading = {"a,b", swept, 2, NULL, 0};
  struct ph_result result = by_hand();
  ck_assert_ptr_null(ph_buf_reserve(&buf, (size_t)-1 - 10));
  header((struct ph_csv_shape){.table = PH_TABLE_LENGTHS, .space = PH_PLANE},
         swept, 2);
  rows(PH_TABLE_LENGTHS, &heading, &result);
  ck_assert(buf.failed);
  ck_assert_uint_eq(buf.n, 0);
}

PH_FIXTURE(NULL, finish)
