/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Sweeps: the values that --sweep names, and their combinations. */
#include "unit.h"

#include "cli/sweep.h"

static const struct ph_field rows[] = {
    {PH_F_POINTS, PH_VECTORS, 1u << 2, true, NULL, NULL, ""},
    {PH_F_CLOSED, PH_BOOL, 0, false, NULL, "false", ""},
    {PH_F_BASIS, PH_NUMBER, 0, false, NULL, "", ""}, /* as alpha will be */
    {PH_F_KNOTS, PH_WORD | PH_NUMBERS, 0, false, "chordal|uniform", "", ""},
    {PH_F_CURVE, PH_VECTORS | PH_POLYLINE, 1u << 2, false, NULL, "", ""},
};
static const struct ph_schema schema = {"planar", rows, 5};

static struct ph_diag diag;

static struct ph_sweep read_sweep(const char *text) {
  struct ph_sweep sweep;
  enum ph_status status =
      ph_sweep_read(text, &schema, &unit_arena, &sweep, &diag);
  ck_assert_msg(status == PH_OK, "%s: %s", text, diag.message);
  return sweep;
}

/* Value i of a sweep, set in an empty problem. */
static struct ph_value value_at(const struct ph_sweep *sweep, size_t i) {
  struct ph_problem problem = {0};
  ck_assert_int_eq(ph_sweep_apply(sweep, 1, i, &unit_arena, &problem, &diag),
                   PH_OK);
  return problem.field[sweep->field->id];
}

static void ck_texts(const char *text, size_t n, const char *const *expected) {
  struct ph_sweep sweep = read_sweep(text);
  ck_assert_uint_eq(sweep.n, n);
  for (size_t i = 0; i < n; i++) {
    struct ph_swept swept;
    ck_assert_int_eq(ph_sweep_name(&sweep, 1, i, &unit_arena, &swept, &diag),
                     PH_OK);
    ck_assert_str_eq(swept.name, sweep.name);
    ck_assert_str_eq(swept.value, expected[i]);
  }
}

PH_TEST(test_range) {
  const char *const five[] = {"0", "0.25", "0.5", "0.75", "1"};
  const char *const down[] = {"3", "1", "-1"};
  const char *const one[] = {"7"};
  const char *const two[] = {"-0.1", "0.3"};
  ck_texts("basis=0:1:5", 5, five);
  ck_texts("basis=3:-1:3", 3, down);
  ck_texts("basis=7:9:1", 1, one);
  ck_texts("basis=-.1:+.3:2", 2, two);
}

/* Both ends are exact, and no value is beyond them. */
PH_TEST(test_range_ends) {
  struct ph_sweep sweep = read_sweep("basis=0.1:0.7:1001");
  ck_assert_uint_eq(sweep.n, 1001);
  ck_abs(value_at(&sweep, 0).number, 0.1, 0);
  ck_abs(value_at(&sweep, 1000).number, 0.7, 0);
  for (size_t i = 1; i < 1001; i++) {
    double x = value_at(&sweep, i).number;
    ck_assert(x > value_at(&sweep, i - 1).number);
    ck_assert_int_eq(value_at(&sweep, i).kind, PH_NUMBER);
    ck_abs(x, 0.1 + 0.0006 * (double)i, 1e-15);
  }
}

/* The width of a range may overflow, its values may not. */
PH_TEST(test_range_wide) {
  struct ph_sweep sweep = read_sweep("basis=-1.5e308:1.5e308:5");
  ck_rel(value_at(&sweep, 1).number, -7.5e307, 1e-15);
  ck_abs(value_at(&sweep, 2).number, 0, 0);
  ck_rel(value_at(&sweep, 3).number, 7.5e307, 1e-15);
}

/* A long range takes no memory for its values. */
PH_TEST(test_range_long) {
  struct ph_sweep sweep = read_sweep("basis=0:1:1e9");
  ck_assert_uint_eq(sweep.n, 1000000000);
  ck_abs(value_at(&sweep, 999999999).number, 1, 0);
  ck_rel(value_at(&sweep, 500000000).number, 0.5, 1e-8);
}

PH_TEST(test_list) {
  const char *const numbers[] = {"1", "-2.5", "100"};
  const char *const words[] = {"\"uniform\"", "\"chordal\""};
  ck_texts("basis=1,-2.5,1e2", 3, numbers);
  ck_texts("knots=uniform,chordal", 2, words);
  struct ph_sweep sweep = read_sweep("knots=uniform");
  ck_assert_str_eq(value_at(&sweep, 0).word, "uniform");
}

/* Commas inside of brackets belong to the value, which is written on one line
 * whatever blanks it had. */
PH_TEST(test_list_of_arrays) {
  const char *const arrays[] = {"[0,1,2]", "[0,2.5,3]", "\"uniform\""};
  const char *const vectors[] = {"[[0,1],[2,3]]", "[[4,5],[6,7]]"};
  const char *const curves[] = {"[[[0,1],[2,3]],[[2,3]]]", "[[4,5],[6,7]]",
                                "[]"};
  struct ph_sweep sweep = read_sweep("knots=[0,1, 2],[0,\n25e-1,3],uniform");
  ck_texts("knots=[0,1, 2],[0,\n25e-1,3],uniform", 3, arrays);
  ck_texts("points=[[0, 1], [2,3]],[[4,5],[6,7]]", 2, vectors);
  ck_texts("curve=[[[0 ,1], [2,3]],[[2,3] ]],[[4,5],[6,7]],[ ]", 3, curves);
  ck_assert_int_eq(value_at(&sweep, 1).kind, PH_NUMBERS);
  ck_assert_uint_eq(value_at(&sweep, 1).n, 3);
  ck_abs(value_at(&sweep, 1).v[1], 2.5, 0);
}

PH_TEST(test_truth_values) {
  const char *const both[] = {"true", "false"};
  struct ph_sweep sweep = read_sweep("closed=true,false");
  ck_texts("closed=true,false", 2, both);
  ck_assert(value_at(&sweep, 0).flag);
  ck_assert(!value_at(&sweep, 1).flag);
}

PH_TEST(test_same) {
  const char *const texts[] = {"knots=uniform",  "knots[1]=1",
                               "knots[2]=1",     "points[1][2]=1",
                               "points[1][3]=1", "basis=0:1:2"};
  struct ph_sweep sweeps[6], again;
  for (size_t i = 0; i < 6; i++) {
    sweeps[i] = read_sweep(texts[i]);
  }
  again = read_sweep("points[01][2]=5:6:7");
  for (size_t i = 0; i < 6; i++) {
    for (size_t j = 0; j < 6; j++) {
      ck_assert(ph_sweep_same(&sweeps[i], &sweeps[j]) == (i == j));
    }
    ck_assert(ph_sweep_same(&sweeps[i], &again) == (i == 3));
  }
}

PH_TEST(test_element) {
  struct ph_sweep sweep = read_sweep("knots[2]=0.5,1");
  ck_assert_str_eq(sweep.name, "knots[2]");
  ck_assert_ptr_eq(sweep.field, &rows[3]);
  ck_assert_uint_eq(sweep.index_n, 1);
  ck_assert_uint_eq(sweep.index[0], 2);
  sweep = read_sweep("points[10][1]=0:1:2");
  ck_assert_uint_eq(sweep.index_n, 2);
  ck_assert_uint_eq(sweep.index[0], 10);
  ck_assert_uint_eq(sweep.index[1], 1);
}

static void ck_refused(const char *text, const char *message) {
  struct ph_sweep sweep;
  ck_assert_int_eq(ph_sweep_read(text, &schema, &unit_arena, &sweep, &diag),
                   PH_E_USAGE);
  ck_assert_str_eq(diag.field, "");
  ck_assert_str_eq(diag.message, message);
}

#define FORM "' is not FIELD=START:STOP:COUNT or FIELD=V1,V2,..."
#define RANGE \
  "' is not START:STOP:COUNT[:log] with a COUNT from 1 to 1000000000"
#define ELEMENT "' is not a field or an element like knots[2] or points[0][1]"

PH_TEST(test_refused_form) {
  ck_refused("", "--sweep: '" FORM);
  ck_refused("knots", "--sweep: 'knots" FORM);
  ck_refused("=1", "--sweep: '=1" FORM);
  ck_refused("knot=1", "--sweep: planar has no field 'knot'; did you mean "
                       "\"knots\"?");
  ck_refused("[0]=1", "--sweep: planar has no field ''");
  ck_refused("knots[=1", "--sweep: 'knots[" ELEMENT);
  ck_refused("knots[]=1", "--sweep: 'knots[]" ELEMENT);
  ck_refused("knots[1=1", "--sweep: 'knots[1" ELEMENT);
  ck_refused("knots[-1]=1", "--sweep: 'knots[-1]" ELEMENT);
  ck_refused("knots[1]x=1", "--sweep: 'knots[1]x" ELEMENT);
  ck_refused("knots[1][2][3]=1", "--sweep: 'knots[1][2][3]" ELEMENT);
  ck_refused("points[1][2][3]=1", "--sweep: 'points[1][2][3]" ELEMENT);
  ck_refused("curve[1][2][3][4]=1", "--sweep: 'curve[1][2][3][4]" ELEMENT);
  ck_refused("knots[12345678901234567890]=1",
             "--sweep: 'knots[12345678901234567890]" ELEMENT);
}

PH_TEST(test_refused_range) {
  ck_refused("basis=0:1:0", "--sweep: '0:1:0" RANGE);
  ck_refused("basis=0:1:-1", "--sweep: '0:1:-1" RANGE);
  ck_refused("basis=0:1:2.5", "--sweep: '0:1:2.5" RANGE);
  ck_refused("basis=0:1:", "--sweep: '0:1:" RANGE);
  ck_refused("basis=:1:2", "--sweep: ':1:2" RANGE);
  ck_refused("basis=0:x:2", "--sweep: '0:x:2" RANGE);
  ck_refused("basis=0:1:2:3", "--sweep: '0:1:2:3" RANGE);
  ck_refused("basis=0:1e999:2", "--sweep: '0:1e999:2" RANGE);
  ck_refused("basis=0:1:1e10", "--sweep: '0:1:1e10" RANGE);
  ck_refused("basis=0:1:nan", "--sweep: '0:1:nan" RANGE);
  ck_refused("basis=1:2:3:lin", "--sweep: '1:2:3:lin" RANGE);
  ck_refused("basis=1:2:3:log:", "--sweep: '1:2:3:log:" RANGE);
  ck_refused("basis=0:2:3:log", "--sweep: '0:2:3:log' has no logarithms: START "
                                "and STOP must be greater than 0");
  ck_refused("basis=1:-2:3:log", "--sweep: '1:-2:3:log' has no logarithms: "
                                 "START and STOP must be greater than 0");
}

PH_TEST(test_refused_value) {
  ck_refused("knots[0]=a", "--sweep: knots[0] takes numbers, found 'a'");
  ck_refused("knots[0]=1,,2", "--sweep: knots[0] takes numbers, found ''");
  ck_refused("knots[0]=", "--sweep: knots[0] takes numbers, found ''");
  ck_refused("closed=", "--sweep: closed takes values, found ''");
  ck_refused("closed=true,", "--sweep: closed takes values, found ''");
  ck_refused("knots=0:1:5", "--sweep: knots must be \"chordal\", \"uniform\" "
                            "or an array of numbers, found a number");
  ck_refused("knots[0]=1e999", "--sweep: knots[0] takes numbers, found "
                               "'1e999'");
  ck_assert_int_eq(ph_sweep_read("knots=unifrom", &schema, &unit_arena,
                                 &(struct ph_sweep){0}, &diag),
                   PH_E_USAGE);
  ck_assert_ptr_nonnull(strstr(diag.message, "did you mean \"uniform\"?"));
  ck_assert_int_eq(strncmp(diag.message, "--sweep: knots ", 15), 0);
}

PH_TEST(test_count) {
  struct ph_sweep sweeps[] = {{.n = 3}, {.n = 4}, {.n = 5}};
  ck_assert_uint_eq(ph_sweep_count(sweeps, 3), 60);
  ck_assert_uint_eq(ph_sweep_count(sweeps, 0), 1);
  sweeps[1].n = SIZE_MAX / 4;
  ck_assert_uint_eq(ph_sweep_count(sweeps, 1), 3);
  ck_assert_uint_eq(ph_sweep_count(sweeps, 3), 0);
  sweeps[1].n = SIZE_MAX / 3;
  ck_assert_uint_eq(ph_sweep_count(sweeps, 2), SIZE_MAX / 3 * 3);
}

/* The last sweep varies fastest. */
PH_TEST(test_order) {
  struct ph_sweep sweeps[] = {read_sweep("closed=true,false"),
                              read_sweep("basis=1,2,3")};
  for (size_t i = 0; i < 6; i++) {
    struct ph_problem problem = {0};
    struct ph_swept swept[2];
    ck_assert_int_eq(ph_sweep_apply(sweeps, 2, i, &unit_arena, &problem, &diag),
                     PH_OK);
    ck_assert_int_eq(ph_sweep_name(sweeps, 2, i, &unit_arena, swept, &diag),
                     PH_OK);
    ck_assert(problem.field[PH_F_CLOSED].flag == (i < 3));
    ck_abs(problem.field[PH_F_BASIS].number, 1.0 + (double)(i % 3), 0);
    ck_assert_str_eq(swept[0].name, "closed");
    ck_assert_str_eq(swept[0].value, i < 3 ? "true" : "false");
    ck_assert_str_eq(swept[1].name, "basis");
    ck_assert_int_eq(swept[1].value[0], '1' + (int)(i % 3));
  }
}

/* An element is set in a copy: the problem is solved for other values, too. */
PH_TEST(test_set_element) {
  double knots[] = {0, 1, 2}, points[] = {0, 1, 2, 3, 4, 5};
  struct ph_sweep sweeps[] = {read_sweep("knots[1]=0.5,1.5"),
                              read_sweep("points[2][0]=9")};
  const struct ph_value knots_value = {
      .kind = PH_NUMBERS, .v = knots, .n = 3, .dimension = 1};
  const struct ph_value points_value = {
      .kind = PH_VECTORS, .v = points, .n = 3, .dimension = 2};
  for (size_t i = 0; i < 2; i++) {
    struct ph_problem problem = {0};
    const struct ph_value *k = &problem.field[PH_F_KNOTS];
    const struct ph_value *p = &problem.field[PH_F_POINTS];
    problem.field[PH_F_KNOTS] = knots_value;
    problem.field[PH_F_POINTS] = points_value;
    ck_assert_int_eq(ph_sweep_apply(sweeps, 2, i, &unit_arena, &problem, &diag),
                     PH_OK);
    ck_abs(k->v[0], 0, 0);
    ck_abs(k->v[1], 0.5 + (double)i, 0);
    ck_abs(k->v[2], 2, 0);
    ck_abs(p->v[4], 9, 0);
    ck_abs(p->v[3], 3, 0);
    ck_abs(p->v[5], 5, 0);
  }
  ck_abs(knots[1], 1, 0);
  ck_abs(points[4], 4, 0);
}

/* One curve, or several: elements of each. */
PH_TEST(test_set_polyline) {
  double v[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11};
  size_t sizes[] = {2, 1, 3};
  struct ph_sweep of_one = read_sweep("curve[0][1]=-1,-2");
  struct ph_sweep of_three[] = {read_sweep("curve[0][1][0]=-1,-2"),
                                read_sweep("curve[2][2][1]=-3")};
  struct ph_value value = {.kind = PH_VECTORS, .v = v, .n = 6, .dimension = 2};
  for (size_t i = 0; i < 2; i++) {
    struct ph_problem problem = {0};
    const struct ph_value *c = &problem.field[PH_F_CURVE];
    double first = i ? -2 : -1;
    problem.field[PH_F_CURVE] = value;
    ck_assert_int_eq(
        ph_sweep_apply(&of_one, 1, i, &unit_arena, &problem, &diag), PH_OK);
    for (size_t k = 0; k < 12; k++) {
      ck_abs(c->v[k], k == 1 ? first : (double)k, 0);
    }
    problem.field[PH_F_CURVE] = value;
    problem.field[PH_F_CURVE].kind = PH_POLYLINE;
    problem.field[PH_F_CURVE].sizes = sizes;
    problem.field[PH_F_CURVE].sizes_n = 3;
    ck_assert_int_eq(
        ph_sweep_apply(of_three, 2, i, &unit_arena, &problem, &diag), PH_OK);
    for (size_t k = 0; k < 12; k++) {
      ck_abs(c->v[k], k == 2 ? first : k == 11 ? -3 : (double)k, 0);
    }
    ck_assert_uint_eq(c->sizes_n, 3);
  }
  ck_abs(v[1], 1, 0);
  ck_abs(v[2], 2, 0);
}

static void ck_no_element(const char *text, struct ph_value value) {
  struct ph_sweep sweep = read_sweep(text);
  struct ph_problem problem = {0};
  char message[96];
  problem.field[sweep.field->id] = value;
  ck_assert_int_eq(ph_sweep_apply(&sweep, 1, 0, &unit_arena, &problem, &diag),
                   PH_E_BAD_SHAPE);
  ck_assert_str_eq(diag.field, ph_field_name(sweep.field->id));
  snprintf(message, sizeof message, "has no element %s for --sweep to set",
           sweep.name);
  ck_assert_str_eq(diag.message, message);
}

PH_TEST(test_no_element) {
  double v[] = {0, 1, 2, 3};
  struct ph_value numbers = {
      .kind = PH_NUMBERS, .v = v, .n = 4, .dimension = 1};
  struct ph_value vectors = {
      .kind = PH_VECTORS, .v = v, .n = 2, .dimension = 2};
  struct ph_value word = {.kind = PH_WORD, .word = "uniform"};
  ck_no_element("knots[4]=1", numbers);
  ck_no_element("knots[0][0]=1", numbers);
  ck_no_element("knots[0]=1", word);
  ck_no_element("knots[0]=1", (struct ph_value){0});
  ck_no_element("points[2][0]=1", vectors);
  ck_no_element("points[0][2]=1", vectors);
  ck_no_element("points[0]=1", vectors);
  struct ph_value polyline = vectors;
  size_t sizes[] = {1, 1};
  polyline.kind = PH_POLYLINE;
  polyline.sizes = sizes;
  polyline.sizes_n = 2;
  ck_no_element("curve[2][0][0]=1", polyline);
  ck_no_element("curve[0][1][0]=1", polyline);
  ck_no_element("curve[1][0][2]=1", polyline);
  ck_no_element("curve[1][0]=1", polyline);
  ck_no_element("curve[1]=1", polyline);
  ck_no_element("curve[1][0][1]=1", vectors);
}

/* Each value is the same multiple of the one before. */
PH_TEST(test_range_log) {
  struct ph_sweep sweep = read_sweep("basis=2:2.08120802:5:log");
  struct ph_sweep down = read_sweep("basis=1e300:1e-300:3:log");
  double x = 2;
  for (size_t i = 0; i < 5; i++, x *= 1.01) {
    ck_rel(value_at(&sweep, i).number, x, 1e-14);
  }
  ck_abs(value_at(&sweep, 0).number, 2, 0);
  ck_abs(value_at(&sweep, 4).number, 2.08120802, 0);
  ck_rel(value_at(&down, 1).number, 1, 1e-12);
}

/* What a problem has, times the values of the sweep. */
PH_TEST(test_factors) {
  const char *const texts[] = {"0.5", "2"};
  double knots[] = {1, 2, 4};
  struct ph_sweep all = read_sweep("knots*=0.5,2");
  struct ph_sweep both[] = {read_sweep("knots*=3"), read_sweep("knots[1]*=5")};
  struct ph_sweep number = read_sweep("basis*=1:4:2");
  const struct ph_value value = {
      .kind = PH_NUMBERS, .v = knots, .n = 3, .dimension = 1};
  struct ph_problem problem = {0};
  const double *v;
  ck_texts("knots*=0.5,2", 2, texts);
  ck_assert_str_eq(all.name, "knots*");
  ck_assert(!ph_sweep_same(&both[0], &both[1]));
  ck_assert(ph_sweep_same(&all, &both[0]));
  for (size_t i = 0; i < 2; i++) {
    problem.field[PH_F_KNOTS] = value;
    ck_assert_int_eq(ph_sweep_apply(&all, 1, i, &unit_arena, &problem, &diag),
                     PH_OK);
    v = problem.field[PH_F_KNOTS].v;
    for (size_t k = 0; k < 3; k++) {
      ck_abs(v[k], (i ? 2 : 0.5) * knots[k], 0);
    }
  }
  problem.field[PH_F_KNOTS] = value;
  ck_assert_int_eq(ph_sweep_apply(both, 2, 0, &unit_arena, &problem, &diag),
                   PH_OK);
  v = problem.field[PH_F_KNOTS].v;
  ck_abs(v[0], 3, 0);
  ck_abs(v[1], 30, 0);
  ck_abs(knots[1], 2, 0);
  problem.field[PH_F_BASIS] = (struct ph_value){.kind = PH_NUMBER, .number = 7};
  ck_assert_int_eq(ph_sweep_apply(&number, 1, 1, &unit_arena, &problem, &diag),
                   PH_OK);
  ck_abs(problem.field[PH_F_BASIS].number, 28, 0);
}

PH_TEST(test_no_factor) {
  struct ph_sweep sweep = read_sweep("knots*=2");
  struct ph_problem problem = {0};
  ck_assert_int_eq(ph_sweep_apply(&sweep, 1, 0, &unit_arena, &problem, &diag),
                   PH_E_BAD_SHAPE);
  ck_assert_str_eq(diag.field, "knots");
  ck_assert_str_eq(diag.message, "has no numbers for --sweep to multiply");
  ck_refused("knots*=a", "--sweep: knots* takes numbers, found 'a'");
  ck_refused("*=1", "--sweep: planar has no field ''");
}
