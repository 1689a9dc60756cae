/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * What is told of trimmed offsets that are not found, or not certified:
 * something is withheld from what looks at them, or changed.  Failures that a
 * curve leads to are in tests/cli/trim.t.
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

/* A ring of four lines, whose corners are round outside. */
static void ring(void) {
  unit_cubics_begin(&c, ph_cplx_of(0, 0));
  add_line(ph_cplx_of(3, 0));
  add_line(ph_cplx_of(0, 2));
  add_line(ph_cplx_of(-3, 0));
  add_line(ph_cplx_of(0, -2));
  c.curve.closed = true;
}

/* Ways in which a loop is not what it claims. */
static void open_it(struct ph_offset *o) {
  o->loops.v[0].pieces[1].control_points[0] += 1e-10;
}

static void move_it(struct ph_offset *o) {
  o->loops.v[0].pieces[0].control_points[3] += 1e-3;
}

static void lengthen(struct ph_offset *o) {
  o->loops.v[0].length += 1e-7;
  o->length += 1e-7;
}

static void widen(struct ph_offset *o) {
  o->loops.v[0].area += 1e-7;
  o->loops.area += 1e-7;
}

/* Round the ring twice. */
static void go_round(struct ph_offset *o) {
  struct ph_loop *loop = &o->loops.v[0];
  struct ph_loop_piece *twice =
      ph_arena_array(&unit_arena, 2 * loop->n, sizeof *twice);
  ck_assert_ptr_nonnull(twice);
  for (size_t i = 0; i < 2 * loop->n; i++) {
    twice[i] = loop->pieces[i % loop->n];
  }
  loop->pieces = twice;
  loop->n *= 2;
  loop->length *= 2;
  loop->area *= 2;
  o->length *= 2;
  o->loops.area *= 2;
}

PH_TEST(test_certificate) {
  static const struct {
    const char *what;
    void (*change)(struct ph_offset *o);
  } cases[] = {{"closure", open_it},
               {"distance", move_it},
               {"length", lengthen},
               {"area", widen},
               {"turn", go_round}};
  for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
    struct ph_offset offset = {.distance = -0.25, .dimension = 2};
    struct ph_arena scratch = {.chunks = NULL};
    char wanted[128];
    ring();
    ck_assert_int_eq(
        ph_loops_of(&c.curve, &trimmed, &unit_arena, &offset, &diag), PH_OK);
    ck_assert_int_eq(ph_certify_loops(&c.curve, &offset, 1, &scratch, &diag),
                     PH_OK);
    ck_assert(offset.loops.trimming.certified);
    cases[i].change(&offset);
    ck_assert_int_eq(ph_certify_loops(&c.curve, &offset, 1, &scratch, &diag),
                     PH_E_NO_CONVERGENCE);
    snprintf(wanted, sizeof wanted,
             "the trimmed offset at distance -0.25 is not certified: the error "
             "of %s of its loop 0 from ",
             cases[i].what);
    ck_assert_msg(strstr(diag.message, wanted), "%s", diag.message);
    ph_arena_free(&scratch);
  }
}
