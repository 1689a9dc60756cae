/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The method `cone`: from the fields of a problem to a developable surface
 * (cone.h): O(n), and nothing is allocated for a pair. */
#include "solve/method.h"

#include "curve/surface/locate.h"
#include "solve/common/fields.h"
#include "solve/cone/cone.h"

/* Points of the development, and what is told of those that are beside it. */
static enum ph_status locate(const struct ph_value *flat, struct ph_arena *out,
                             struct ph_result *result, struct ph_diag *diag) {
  const struct ph_located_list *list = &result->located;
  enum ph_status status =
      ph_surface_locate(&result->curve, (const double(*)[2])(void *)flat->v,
                        flat->n, out, &result->located, diag);
  size_t first = 0;
  if (status != PH_OK || list->n == flat->n) {
    return status;
  }
  while (first < list->n && list->v[first].index == first) {
    first++;
  }
  ph_warn(result, PH_NO_SEGMENT, PH_W_OUTSIDE,
          "%zu of %zu points are outside of the flat pattern, the first is "
          "flat[%zu]",
          flat->n - list->n, flat->n, first);
  return PH_OK;
}

static enum ph_status solve(const struct ph_problem *problem,
                            struct ph_arena *out, struct ph_arena *scratch,
                            struct ph_result *result, struct ph_diag *diag) {
  struct ph_mark mark = ph_arena_mark(scratch);
  struct ph_cone_data data;
  enum ph_status status = ph_cone_data_of(problem, scratch, &data, diag);
  if (status == PH_OK) {
    status = ph_cone_build(&data, out, result, diag);
  }
  if (status == PH_OK && ph_fields_given(problem, PH_F_FLAT)) {
    status = locate(&problem->field[PH_F_FLAT], out, result, diag);
  }
  ph_arena_release(scratch, mark);
  return status;
}

static const struct ph_field fields[] = {
    {PH_F_POINTS, PH_VECTORS | PH_DATUM, 1u << 3, true, NULL, NULL,
     "a point on each ruling, 2 or more, 3 or more if closed"},
    {PH_F_RULINGS, PH_VECTORS | PH_DATUM, 1u << 3, true, NULL, NULL,
     "directions of the rulings, one for each point"},
    {PH_F_TANGENTS, PH_VECTORS | PH_DATUM, 1u << 3, true, NULL, NULL,
     "directions across the rulings in the tangent planes, onward, orthogonal "
     "to the rulings"},
    {PH_F_NORMALS, PH_VECTORS | PH_DATUM, 1u << 3, false, NULL, "none",
     "normals of the tangent planes, of either sign, to be compared only"},
    {PH_F_CLOSED, PH_BOOL, 0, false, NULL, "false",
     "join the last contact element to the first, a repeated last one is "
     "dropped"},
    {PH_F_METHOD, PH_WORD, 0, false, "circular", "circular",
     "what strips are: pieces of circular cones, two between neighbours"},
    {PH_F_LAMBDA, PH_WORD | PH_NUMBER | PH_NUMBERS | PH_SEGMENTS, 0, false,
     "equal", "equal",
     "leg of the first arc of each pair, or equal to that of the second"},
    {PH_F_DEGENERATE, PH_NUMBER, 0, false, NULL, PH_TEXT(PH_CONE_DEGENERATE),
     "when two contact elements count as lying on one cone, as of parallel "
     "axes, or as of rulings that meet"},
    {PH_F_HEIGHT, PH_NUMBERS, 0, false, NULL, "0 to 0, the contact curve",
     "the part of the rulings that is meant, from where to where, from the "
     "given points"},
    {PH_F_FLAT, PH_VECTORS, 1u << 2, false, NULL, "none",
     "points [u,v] of the flat pattern, to be located on the surface"},
    PH_FIELD_MERGE,
};

const struct ph_method ph_method_cone = {
    .schema = {"cone", fields, sizeof fields / sizeof fields[0]},
    .title = "developable surfaces of cones through contact elements",
    .dimension = 3,
    .kind = PH_CURVE_CONE,
    .solve = solve,
};
