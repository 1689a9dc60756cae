/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The method `bubble': from the fields of a problem to a surface of patches
 * (bubble.h): O(n). */
#include "solve/method.h"

#include "solve/bubble/bubble.h"

static enum ph_status solve(const struct ph_problem *problem,
                            struct ph_arena *out, struct ph_arena *scratch,
                            struct ph_result *result, struct ph_diag *diag) {
  struct ph_mark mark = ph_arena_mark(scratch);
  struct ph_bubble_data data;
  enum ph_status status = ph_bubble_data_of(problem, out, &data, diag);
  if (status == PH_OK) {
    status = ph_bubble_build(&data, out, scratch, result, diag);
  }
  ph_arena_release(scratch, mark);
  return status;
}

static const struct ph_field fields[] = {
    {PH_F_POINTS, PH_VECTORS, 1u << 3, true, NULL, NULL,
     "the points of the mesh, each at a corner of some face"},
    {PH_F_FACES, PH_LISTS, 0, true, NULL, NULL,
     "the faces: 4 numbers of points each, counted from 0, all around"},
    {PH_F_NORMALS, PH_VECTORS, 1u << 3, false, NULL, "from the faces",
     "normals of the surface at the points, of any length"},
    {PH_F_CONTINUITY, PH_NUMBER, 0, false, NULL, "1",
     "of the surface: 0 of points, 1 of normals, 2 of curvatures, too"},
    {PH_F_DEGREE, PH_WORD | PH_NUMBER, 0, false, "auto|exact", "auto",
     "of blending functions: as high as the tolerance needs it, or a number; "
     "exact: the quotients, which have no control points"},
    {PH_F_TOLERANCE, PH_NUMBER, 0, false, NULL, PH_TEXT(PH_BUBBLE_TOLERANCE),
     "the largest jump of normals that degree auto allows, in radians"},
    {PH_F_SUBDIVIDE, PH_NUMBER, 0, false, NULL, "0",
     "steps of Catmull and Clark before; with one or more, faces may have any "
     "number of points"},
    {PH_F_BOUNDARY, PH_WORD, 0, false, "smooth|fixed", "smooth",
     "of these steps: smooth moves points at boundaries, too"},
};

static const struct ph_advice advice[] = {
    {"faces", PH_F_POINTS, PH_F_TOLERANCE, "1",
     "try a larger tolerance, a number for degree, or finer faces"},
};

const struct ph_method ph_method_bubble = {
    .schema = {"bubble", fields, sizeof fields / sizeof fields[0]},
    .title = "smooth surfaces of patches over meshes of quadrilaterals",
    .dimension = 3,
    .kind = PH_CURVE_BUBBLE,
    .solve = solve,
    .advice = advice,
    .advice_n = sizeof advice / sizeof advice[0],
};
