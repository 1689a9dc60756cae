/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * What is told of trimmed offsets that are not found: no curve is known that
 * leads there, so that something is withheld from what looks at them.  The one
 * failure that a curve leads to is in tests/cli/trim.t.
 */
#include "curve_unit.h"
#include "tc_curve_unit.h"

#include "check/loop.h"
#include "curve/offset/loop.h"
#include "curve/offset/part.h"

static struct ph_diag diag;
static struct unit_cubics c;
static const struct ph_offset_rules trimmed = {.mode = PH_OFFSET_TRIMMED};

static void add_line(ph_cplx along) {
  const double length = ph_cplx_abs(along);
  const ph_cplx w = ph_cplx_scale(
      sqrt(length), ph_cplx_polar(0.5 * atan2(along.im, along.re)));
  unit_cubics_add(&c, w, w);
}

/* A line of length 3, up by 1, back by 1.5, and down by 2 across the first. */
static struct ph_strands hook(void) {
  struct ph_strands strands;
  unit_cubics_begin(&c, ph_cplx_of(0, 0));
  add_line(ph_cplx_of(3, 0));
  add_line(ph_cplx_of(0, 1));
  add_line(ph_cplx_of(-1.5, 0));
  add_line(ph_cplx_of(0, -2));
  ck_assert_int_eq(ph_strands_of(&c.curve, 0.25, &trimmed, true, &unit_arena,
                                 &strands, &diag),
                   PH_OK);
  return strands;
}

/* Without its meetings a part is in part nearer to others than the distance. */
PH_TEST(test_disagree) {
  const struct ph_strands strands = hook();
  const struct ph_crossings none = {.breaks = NULL};
  enum ph_status status;
  struct ph_arcs arcs;
  struct ph_part_list parts;
  ck_assert_int_eq(ph_arcs_of(&strands, true, &arcs, &diag), PH_OK);
  ck_assert_int_eq(ph_parts_cut(&strands, &arcs, &none, &parts, &diag), PH_OK);
  for (size_t k = 0; k < parts.n; k++) { /* that of the line is a run */
    parts.v[k].cut = parts.v[k].begun = true;
  }
  status = ph_parts_judge(&strands, &arcs, &none, false, &parts, &diag);
  ck_assert_int_eq(status, PH_E_NO_CONVERGENCE);
  ck_assert_msg(strstr(diag.message, "the trimmed offset at distance 0.25 was "
                                     "not found: near (0, 0.25) places of a "
                                     "part disagree"),
                "%s", diag.message);
}

/* That of an open curve, if loops alone are allowed. */
PH_TEST(test_open) {
  const struct ph_strands strands = hook();
  struct ph_outline outline;
  ck_assert_int_eq(ph_outline_of(&strands, &trimmed, true, &outline, &diag),
                   PH_OK);
  ck_assert_uint_gt(outline.chains_n, 0);
  ck_assert(!outline.chains[0].closed);
  ck_assert_int_eq(ph_outline_of(&strands, &trimmed, false, &outline, &diag),
                   PH_E_NO_CONVERGENCE);
  ck_assert_str_eq(diag.message,
                   "the trimmed offset at distance 0.25 was not found: near "
                   "(0, 0.25) it does not close");
}

/* A loop that is not what it claims. */
PH_TEST(test_certificate) {
  struct ph_offset offset = {.distance = 0.25, .dimension = 2};
  struct ph_arena scratch = {.chunks = NULL};
  hook();
  ck_assert_int_eq(ph_loops_of(&c.curve, &trimmed, &unit_arena, &offset, &diag),
                   PH_OK);
  ck_assert_int_eq(ph_certify_loops(&c.curve, &offset, 1, &scratch, &diag),
                   PH_OK);
  ck_assert(offset.loops.trimming.certified);
  offset.loops.v[0].pieces[0].control_points[1] += 1e-3;
  ck_assert_int_eq(ph_certify_loops(&c.curve, &offset, 1, &scratch, &diag),
                   PH_E_NO_CONVERGENCE);
  ck_assert_msg(strstr(diag.message, "the trimmed offset at distance 0.25 is "
                                     "not certified: the error of distance of "
                                     "its loop 0 from "),
                "%s", diag.message);
  ph_arena_free(&scratch);
}
