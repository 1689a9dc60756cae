/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Curves that cross themselves or not (see cross_unit.h). */
#include "cross_unit.h"
#include "segment_unit.h"
#include "unit.h"

#include "curve/segment/seg2.h"

struct ph_cross unit_cross(const struct ph_curve *curve, double size) {
  struct ph_quad rule;
  struct ph_mark mark, after;
  struct ph_cross cross;
  struct ph_diag diag;
  ck_assert(ph_quad_gauss(&rule, 12));
  ck_assert_ptr_nonnull(ph_arena_array(&unit_arena, 1, 1));
  mark = ph_arena_mark(&unit_arena);
  ck_assert_int_eq(ph_cross_planar(curve, &unit_arena, &cross, &diag), PH_OK);
  after = ph_arena_mark(&unit_arena);
  ck_assert_ptr_eq(after.chunk, mark.chunk);
  ck_assert_uint_eq(after.used, mark.used);
  ck_assert(cross.loops == 0 || !cross.simple);
  if (!cross.simple) {
    ph_cplx at[2];
    for (int i = 0; i < 2; i++) {
      struct ph_seg2 seg;
      ck_assert_uint_lt(cross.segment[i], curve->n);
      seg = ph_seg2_of(curve, cross.segment[i]);
      ck_assert(cross.u[i] >= 0 && cross.u[i] <= 1);
      at[i] = ph_seg2_point(&seg, &rule, cross.u[i]);
      ck_abs(unit_distance(at[i], cross.point), 0, 4 * PH_CROSS_NEAR * size);
    }
    ck_assert(
        cross.segment[0] < cross.segment[1] ||
        (cross.segment[0] == cross.segment[1] && cross.u[0] <= cross.u[1]));
  }
  return cross;
}

void unit_chain_begin(struct unit_chain *chain, bool closed) {
  chain->curve = (struct ph_curve){.kind = PH_CURVE_PH,
                                   .closed = closed,
                                   .dimension = 2,
                                   .degree = 5,
                                   .control_points = chain->p,
                                   .preimage.n = 3,
                                   .preimage.dimension = 2,
                                   .preimage.v = chain->w};
}

void unit_chain_add(struct unit_chain *chain, const ph_cplx w[3]) {
  size_t n = chain->curve.n++;
  struct ph_atph space = ph_atph_of(0);
  ph_cplx hodograph[5], from = {0, 0}, to, p[6];
  ck_assert_uint_lt(n, UNIT_PIECES);
  if (n > 0) {
    from = ph_cplx_of(chain->p[12 * n - 2], chain->p[12 * n - 1]);
  }
  ph_hodograph(w, hodograph);
  to = from;
  for (int i = 0; i < 5; i++) {
    to = ph_cplx_add(to, ph_cplx_scale(0.2, hodograph[i]));
  }
  ph_seg2_control_points(&space, w, from, to, p);
  memcpy(chain->p + 12 * n, p, sizeof p);
  memcpy(chain->w + 6 * n, w, 3 * sizeof *w);
}

void unit_chain_random(struct unit_chain *chain, struct unit_random *r,
                       size_t n) {
  double direction = 0;
  ph_cplx w[3] = {{1, 0}, {0, 0}, {0, 0}};
  unit_chain_begin(chain, false);
  for (size_t k = 0; k < n; k++) {
    for (int i = 1; i < 3; i++) {
      direction += unit_random_in(r, -1, 2.2);
      w[i] =
          ph_cplx_scale(unit_random_in(r, 0.1, 1.5), ph_cplx_polar(direction));
    }
    unit_chain_add(chain, w);
    w[0] = w[2];
  }
}

/* Points on a walk that turns by up to `turn` a step. */
static size_t random_walk(struct unit_random *r, double turn, double *v) {
  size_t n = 5 + unit_random_below(r, 16);
  double direction = 0;
  ph_cplx at = unit_random_cplx(r, 10);
  for (size_t i = 0; i < n; i++) {
    v[2 * i] = at.re;
    v[2 * i + 1] = at.im;
    direction += unit_random_in(r, -turn, turn);
    at = ph_cplx_add(at, ph_cplx_scale(unit_random_in(r, 0.3, 1.5),
                                       ph_cplx_polar(direction)));
  }
  return n;
}

struct unit_solution unit_planar_random(struct unit_random *r, int i) {
  const double turns[] = {0.8, 1.3, 2, 3.1};
  double v[2 * 20];
  size_t n = random_walk(r, turns[i % 4], v);
  struct unit_solution u = unit_planar_of(v, n, i / 4 % 2 != 0);
  u.problem.field[PH_F_BASIS] =
      (struct ph_value){.kind = PH_WORD, .word = i % 3 ? "ph" : "atph"};
  ck_assert_int_eq(unit_planar_solve(&u), PH_OK);
  return u;
}
