/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Fuzz target: any mesh in the OBJ format through the method bubble, and
 * samples of its surface.  The outcome is a failure of the record, or a surface
 * whose certificate passes or is such a failure.
 *
 * The bytes of an input:
 *   0      bits 0-1 continuity, 3: none is given, 2 exact, 3 indented JSON, 4 a
 *          boundary that is fixed, 5-6 steps of subdivision, 3: one with an
 *          offset
 *   1...   the text; no more than 1000 points or faces are solved
 */
#include "problem.h"

#include "curve/surface/places.h"
#include "io/record.h"
#include "io/value.h"

enum { BUBBLE_MOST = 1000, BUBBLE_STEPS = 3 };

/* Reads the mesh, and sets what the flags say. */
static enum ph_status bubble_read(const uint8_t *data, size_t n,
                                  struct ph_problem *problem,
                                  struct fuzz_run *run) {
  const struct ph_record record = {.text = (const char *)data + 1,
                                   .n = n - 1,
                                   .file = "-",
                                   .line = 1,
                                   .number = 1,
                                   .mesh = true};
  const struct ph_schema *schema = &ph_method_bubble.schema;
  struct ph_echo echo = {0};
  const int flags = data[0], steps = flags >> 5 & 3;
  enum ph_status status =
      ph_record_read(&record, schema, &run->out, problem, &echo, &run->diag);
  if (status == PH_OK) {
    status = ph_problem_check_required(problem, schema, &run->diag);
  }
  fuzz_set_number(problem, PH_F_CONTINUITY,
                  (flags & 3) == 3 ? (double)NAN : flags & 3);
  fuzz_set_word(problem, PH_F_DEGREE, flags & 4 ? "exact" : NULL);
  fuzz_set_number(problem, PH_F_SUBDIVIDE, steps == 3 ? 1 : steps);
  fuzz_set_word(problem, PH_F_BOUNDARY, flags & 16 ? "fixed" : NULL);
  return status;
}

static void bubble_check(struct fuzz_run *run, int flags) {
  struct ph_result *result = &run->result;
  const double area = result->curve.surface.area;
  const double distance = flags >> 5 == 3 ? sqrt(fabs(area)) / 16 : 0;
  size_t back = 0;
  struct ph_diag diag;
  enum ph_status status;
  /* 0 where it underflows */
  FUZZ_REQUIRE(area >= 0 && isfinite(area));
  status = ph_patch_grid_of(&result->curve, distance, BUBBLE_STEPS, SIZE_MAX,
                            &run->out, &result->places, &back, &diag);
  if (status == PH_OK) {
    const size_t each = (BUBBLE_STEPS + 1) * (BUBBLE_STEPS + 1);
    FUZZ_REQUIRE(result->places.n == each * result->curve.n);
    FUZZ_REQUIRE(back == PH_NO_SEGMENT || back < result->curve.n);
  } else {
    fuzz_check_failure(&diag, status);
    result->places.n = 0;
  }
  fuzz_check_diagnostics(&result->diagnostics);
  fuzz_check_output(result, "bubble", flags >> 3 & 1);
}

FUZZ_TARGET(bubble, data, n) {
  struct ph_problem problem = {0};
  struct fuzz_run run = {0};
  if (n == 0) {
    return 0;
  }
  run.status = bubble_read(data, n, &problem, &run);
  if (run.status == PH_OK &&
      (problem.field[PH_F_POINTS].n > BUBBLE_MOST ||
       problem.field[PH_F_FACES].sizes_n > BUBBLE_MOST)) {
    fuzz_end(&run);
    return 0;
  }
  if (run.status == PH_OK) {
    fuzz_solve(&run, &ph_method_bubble, &problem);
  }
  if (run.status == PH_OK) {
    fuzz_certify(&run, "bubble", &problem, NULL);
  }
  if (run.status == PH_OK) {
    bubble_check(&run, data[0]);
  }
  fuzz_end(&run);
  return 0;
}
