/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Fuzz target: any contact elements through the method cone, and what is made
 * of its surfaces: samples, the places of their flat points, parallel surfaces,
 * and panoramas of a volume in any position.  The outcome is a failure of the
 * record, or a surface whose certificate passes or is such a failure, and whose
 * samples are found again.
 *
 * The bytes of an input:
 *   0      bits 0 closed, 1 general cones, 2-3 how vectors are coded,
 *          4 lambda or a contact point, 5 a translation, 6 indented JSON,
 *          7 no height
 *   1      signed: coordinates are scaled by 2 to eight times that
 *   2, 3   the distance of a parallel surface and lambda, small numbers
 *   4, 5   the height, signed bytes
 *   6-14   the volume: how its lattice lies, signed bytes
 *   15...  elements: point, ruling, and what the tangent is but for its part
 *          along the ruling; of general cones a byte, the vertex
 */
#include "problem.h"

#include "curve/surface/grid.h"
#include "curve/surface/locate.h"
#include "curve/surface/volume.h"
#include "kernel/vec3.h"

enum { CONE_ELEMENTS = 12, CONE_POINTS = 20000 };

struct cone_input {
  struct fuzz_bytes bytes;
  struct ph_problem problem;
  double p[CONE_ELEMENTS][3], e[CONE_ELEMENTS][3], d[CONE_ELEMENTS][3];
  double apex[CONE_ELEMENTS], height[2], by[3], distance, lambda, unit;
  struct ph_volume volume;
  size_t n;
};

static bool cone_take_element(struct cone_input *in, int coding, bool general) {
  const size_t i = in->n;
  int8_t apex = 1;
  ph_vec3 e, d;
  if (!fuzz_take_vector(&in->bytes, coding, 3, in->p[i]) ||
      !fuzz_take_vector(&in->bytes, coding, 3, in->e[i]) ||
      !fuzz_take_vector(&in->bytes, coding, 3, in->d[i]) ||
      (general && !fuzz_take(&in->bytes, &apex, 1)) ||
      !fuzz_is_finite(in->p[i], 3) || !fuzz_is_finite(in->e[i], 3) ||
      !fuzz_is_finite(in->d[i], 3)) {
    return false;
  }
  e = ph_vec3_unit(ph_vec3_get(in->e[i], 3));
  d = ph_vec3_normal(ph_vec3_get(in->d[i], 3), e);
  ph_vec3_put(d, 3, in->d[i]);
  for (size_t j = 0; j < 3; j++) {
    in->p[i][j] *= in->unit;
    in->d[i][j] = isfinite(in->d[i][j]) ? in->d[i][j] : 0;
  }
  in->apex[i] = apex * in->unit;
  in->n++;
  return fuzz_is_finite(in->p[i], 3);
}

/* A lattice with the values 0 to 7 at its corners. */
static bool cone_take_volume(struct cone_input *in) {
  static const unsigned char corner[] = {0, 1, 2, 3, 4, 5, 6, 7};
  struct ph_volume volume = {.type = PH_VOXEL_U8, .v = corner, .n = {2, 2, 2}};
  int8_t entry[9];
  if (!fuzz_take(&in->bytes, entry, sizeof entry)) {
    return false;
  }
  for (size_t i = 0; i < 9; i++) {
    volume.inverse[i / 3][i % 3] = entry[i] / 64.0 / in->unit;
  }
  in->volume = volume;
  return true;
}

/* Sets the problem; false when the bytes are none. */
static bool cone_set(struct cone_input *in) {
  struct ph_value *field = in->problem.field;
  uint8_t flags;
  int8_t exponent, height[2];
  if (!fuzz_take(&in->bytes, &flags, 1) ||
      !fuzz_take(&in->bytes, &exponent, 1) ||
      !fuzz_take_small(&in->bytes, true, &in->distance) ||
      !fuzz_take_small(&in->bytes, true, &in->lambda) ||
      !fuzz_take(&in->bytes, height, sizeof height)) {
    return false;
  }
  in->unit = ldexp(1, 8 * (exponent % 100));
  in->distance *= in->unit;
  if (!cone_take_volume(in)) {
    return false;
  }
  while (in->n < CONE_ELEMENTS &&
         cone_take_element(in, flags >> 2 & 3, flags & 2)) {
  }
  for (size_t j = 0; j < 2; j++) {
    in->height[j] = height[j] / 8.0 * in->unit;
  }
  field[PH_F_POINTS] = fuzz_array(in->p[0], in->n, 3);
  field[PH_F_RULINGS] = fuzz_array(in->e[0], in->n, 3);
  field[PH_F_TANGENTS] = fuzz_array(in->d[0], in->n, 3);
  fuzz_set_flag(&in->problem, PH_F_CLOSED, flags & 1);
  if (!(flags >> 7 & 1)) {
    field[PH_F_HEIGHT] = fuzz_array(in->height, 2, 1);
  }
  if (flags & 2) {
    field[PH_F_METHOD] = fuzz_word("atph");
    field[PH_F_APEXES] = fuzz_array(in->apex, in->n, 1);
  }
  if (flags >> 4 & 1) {
    field[flags & 2 ? PH_F_CONTACT_POINT : PH_F_LAMBDA] =
        fuzz_number(flags & 2 ? in->lambda / 16 : in->lambda * in->unit);
  }
  if (flags >> 5 & 1) {
    in->by[0] = 3 * in->unit;
    field[PH_F_TRANSLATE] = fuzz_array(in->by, 3, 1);
  }
  return true;
}

static bool cone_check_status(enum ph_status status,
                              const struct ph_diag *diag) {
  if (status != PH_OK) {
    fuzz_check_failure(diag, status);
  }
  return status == PH_OK;
}

/* The places of the flat points of samples, but for those at an edge that
 * rounding puts beside it, are where these are. */
static void cone_check_located(struct ph_result *result,
                               struct ph_arena *arena) {
  static double flat[CONE_ELEMENTS * 2 * 5 * 3][2];
  const struct ph_surface_samples *grid = &result->grid;
  struct ph_diag diag;
  for (size_t i = 0; i < grid->n; i++) {
    memcpy(flat[i], grid->v[i].flat, sizeof flat[i]);
  }
  if (fuzz_is_finite(flat[0], 2 * grid->n)) {
    cone_check_status(ph_surface_locate(&result->curve,
                                        (const double(*)[2])flat, grid->n,
                                        arena, &result->located, &diag),
                      &diag);
    FUZZ_REQUIRE(result->located.n <= grid->n);
    for (size_t i = 0; i < result->located.n; i++) {
      const struct ph_located *l = &result->located.v[i];
      const double *given = flat[l->index], *found = l->at.flat;
      FUZZ_REQUIRE(hypot(found[0] - given[0], found[1] - given[1]) <=
                   1e-9 * ph_surface_size(&result->curve) +
                       1e-12 * hypot(given[0], given[1]));
    }
  }
}

static void cone_check_result(struct cone_input *in, struct ph_result *result,
                              struct ph_arena *arena) {
  const struct ph_grid_rules rules = {4, 2, SIZE_MAX};
  const double length = result->curve.length;
  static struct ph_parallel parallel;
  struct ph_diag diag;
  FUZZ_REQUIRE(length > 0 && isfinite(length));
  if (cone_check_status(
          ph_grid_of(&result->curve, &rules, arena, &result->grid, &diag),
          &diag)) {
    cone_check_located(result, arena);
  }
  if (cone_check_status(
          ph_parallel_of(&result->curve, in->distance, arena, &parallel, &diag),
          &diag)) {
    FUZZ_REQUIRE(parallel.curve.length > 0);
    cone_check_status(
        ph_grid_of(&parallel.curve, &rules, arena, &parallel.grid, &diag),
        &diag);
  }
  if (cone_check_status(ph_panorama_of(&result->curve, &in->volume, 64 / length,
                                       CONE_POINTS, arena, &result->panorama,
                                       &diag),
                        &diag)) {
    const struct ph_panorama *p = &result->panorama;
    FUZZ_REQUIRE(p->outside <= p->points);
    FUZZ_REQUIRE(p->points == p->outside ||
                 (p->range[0] >= -1e-9 && p->range[1] <= 7 + 1e-9));
  }
  fuzz_check_diagnostics(&result->diagnostics);
  fuzz_check_output(result, "cone", in->bytes.data[0] >> 6 & 1);
}

FUZZ_TARGET(cone, data, n) {
  struct cone_input in = {.bytes = {data, n, 0}};
  struct fuzz_run run = {0};
  if (!cone_set(&in)) {
    return 0;
  }
  fuzz_solve(&run, &ph_method_cone, &in.problem);
  if (run.status == PH_OK) {
    fuzz_certify(&run, "cone", &in.problem, NULL);
  }
  if (run.status == PH_OK) {
    cone_check_result(&in, &run.result, &run.out);
  }
  fuzz_end(&run);
  return 0;
}
