/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The method `cone`: from the fields of a problem to a developable surface
 * (cone.h): O(n), and of circular cones nothing is allocated for a pair. */
#include "solve/method.h"

#include "curve/surface/locate.h"
#include "solve/common/fields.h"
#include "solve/cone/cone.h"

#include <math.h>

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

/* The points of a problem, moved by the vector that it has. */
static enum ph_status translate(struct ph_problem *problem,
                                struct ph_arena *scratch,
                                struct ph_diag *diag) {
  const struct ph_value *by = &problem->field[PH_F_TRANSLATE];
  struct ph_value *points = &problem->field[PH_F_POINTS];
  double *p = ph_arena_array(scratch, 3 * points->n, sizeof *p);
  if (by->n != 3) {
    return ph_fail(diag, PH_E_BAD_SHAPE, "translate",
                   "must have 3 numbers, found %zu", by->n);
  }
  if (!p) {
    return ph_fail_memory(diag);
  }
  for (size_t i = 0; i < 3 * points->n; i++) {
    p[i] = points->v[i] + by->v[i % 3];
    if (!isfinite(p[i])) {
      return ph_fail(diag, PH_E_TOO_LARGE, "translate",
                     "moves points[%zu] beyond all numbers", i / 3);
    }
  }
  points->v = p;
  return PH_OK;
}

static enum ph_status solve(const struct ph_problem *given,
                            struct ph_arena *out, struct ph_arena *scratch,
                            struct ph_result *result, struct ph_diag *diag) {
  struct ph_mark mark = ph_arena_mark(scratch);
  struct ph_problem moved = *given;
  const struct ph_problem *problem = &moved;
  struct ph_cone_data data;
  enum ph_status status = ph_fields_given(given, PH_F_TRANSLATE)
                              ? translate(&moved, scratch, diag)
                              : PH_OK;
  if (status == PH_OK) {
    status = ph_cone_data_of(problem, scratch, &data, diag);
  }
  if (status == PH_OK) {
    status = data.general
                 ? ph_cone_general(problem, &data, out, scratch, result, diag)
                 : ph_cone_build(&data, out, result, diag);
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
    {PH_F_METHOD, PH_WORD, 0, false, "circular|atph", "circular",
     "what strips are pieces of, two between neighbours: circular cones, or "
     "general ones along ATPH curves"},
    {PH_F_LAMBDA, PH_WORD | PH_NUMBER | PH_NUMBERS | PH_SEGMENTS, 0, false,
     "equal", "equal",
     "circular: leg of the first arc of each pair, or equal to that of the "
     "second"},
    {PH_F_DEGENERATE, PH_NUMBER, 0, false, NULL, PH_TEXT(PH_CONE_DEGENERATE),
     "circular: when two contact elements count as lying on one cone, as of "
     "parallel "
     "axes, or as of rulings that meet"},
    {PH_F_APEXES, PH_NUMBERS | PH_DATUM, 0, false, NULL, "none",
     "atph: where the vertex on each ruling is, from the given point"},
    {PH_F_CONTACT_POINT, PH_WORD | PH_NUMBER, 0, false, "nearest|midpoint",
     "nearest",
     "atph: the point on the common ruling, nearest to the given ones, in the "
     "middle of both vertices, or a part of the way between these"},
    {PH_F_TANGENT_SCALE, PH_WORD, 0, false, "chord|unit", "chord",
     "atph: how long the derivatives of the directrices are at their ends"},
    {PH_F_CRITERION, PH_WORD, 0, false, "F1|F2|F3", "F1",
     "atph: which functional of the directrices is least"},
    {PH_F_ANGLES, PH_VECTORS | PH_NUMBERS, 1u << 2, false, NULL,
     "by the criterion",
     "atph: pairs [theta,beta], one for each strip or for all"},
    {PH_F_ALPHA, PH_NUMBER | PH_NUMBERS, 0, false, NULL, "by the criterion",
     "atph: angles of the directrices below pi, one for all or one each"},
    {PH_F_HEIGHT, PH_NUMBERS, 0, false, NULL, "0 to 0, the contact curve",
     "the part of the rulings that is meant, from where to where, from the "
     "given points"},
    {PH_F_FLAT, PH_VECTORS, 1u << 2, false, NULL, "none",
     "points [u,v] of the flat pattern, to be located on the surface"},
    {PH_F_TRANSLATE, PH_NUMBERS, 0, false, NULL, "0, 0, 0",
     "a vector [x,y,z] by which the surface is moved"},
    PH_FIELD_MERGE,
};

const struct ph_method ph_method_cone = {
    .schema = {"cone", fields, sizeof fields / sizeof fields[0]},
    .title = "developable surfaces of cones through contact elements",
    .dimension = 3,
    .kind = PH_CURVE_CONE,
    .solve = solve,
};
