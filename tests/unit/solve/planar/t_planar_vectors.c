/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The problems of tests/vectors: every control point, every length. */
#include "unit.h"
#include "vectors_unit.h"

static struct unit_solution u;
static struct unit_vectors vectors;
static struct unit_vector vector;

static void finish(void) {
  unit_solution_free(&u);
  unit_vectors_close(&vectors, &vector);
}

static void ck_value(const char *what, size_t i, double found, double wanted,
                     double allowed) {
  ck_assert_msg(unit_near(found, wanted, allowed),
                "%s: %s[%zu] is %.17g, not %.17g: error %.3g > %.3g",
                vector.name, what, i, found, wanted, fabs(found - wanted),
                allowed);
}

static void ck_vector(void) {
  const struct ph_curve *curve = &u.result.curve;
  enum ph_status status;
  double allowed;
  u = unit_vector_problem(&vector);
  status = unit_planar_solve(&u);
  ck_assert_msg(status == PH_OK, "%s: %s %s", vector.name, u.diag.field,
                u.diag.message);
  ck_assert_uint_eq(curve->n, vector.lengths.n);
  allowed = vector.tolerance * unit_planar_size(&u);
  for (size_t i = 0; i < vector.control.n; i++) {
    ck_value("control", i, curve->control_points[i], vector.control.v[i],
             allowed);
  }
  for (size_t i = 0; i < vector.lengths.n; i++) {
    ck_value("lengths", i, curve->lengths[i], vector.lengths.v[i], allowed);
  }
  ck_value("length", 0, curve->length, vector.length.v[0], allowed);
  unit_solution_free(&u);
}

static void ck_file(const char *path, size_t expected) {
  size_t n = 0;
  vectors = unit_vectors_open(path);
  while (unit_vectors_next(&vectors, &vector)) {
    ck_vector();
    n++;
  }
  ck_assert_uint_eq(n, expected);
}

PH_TEST(test_gonzalez) {
  ck_file("tests/vectors/planar-gonzalez.phv", 13);
}

PH_TEST(test_shapes) {
  ck_file("tests/vectors/planar-shapes.phv", 38);
}

PH_FIXTURE(NULL, finish)
