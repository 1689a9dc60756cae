/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The quick way to the solution of many smooth data finds what Newton's method
 * finds from the chords, in few steps, and leaves alone what is not smooth.
 */
#include "solve/planar/planar.h"

#include "segment_unit.h"
#include "unit.h"

enum { N_MAX = 400, CURVES = 60 };

static const double PI = 3.14159265358979323846, SOLVED = 1e-13;

static struct ph_diag diag;

struct system {
  struct ph_planar_c2 c2;
  ph_cplx direction[N_MAX];
  double ratio[N_MAX], y[N_MAX + 1], h[N_MAX];
};

/* A kind of data: circles with waves and noise, and knots that are chordal, or
 * by turns longer and shorter by so much. */
struct kind {
  const char *name;
  double per_wave, noise, uneven;
  enum ph_planar_quick least, most; /* what the quick way makes of them; open
                                       ends may be rougher than all else */
  size_t steps;                     /* of the solver, at most */
};

static const struct kind kinds[] = {
    {"smooth", 0, 0, 0, PH_PLANAR_QUICK_SOLVED, PH_PLANAR_QUICK_SOLVED, 5},
    {"uneven", 0, 0, 0.3, PH_PLANAR_QUICK_NONE, PH_PLANAR_QUICK_SOLVED, 6},
    {"40 a wave", 40, 0, 0, PH_PLANAR_QUICK_SOLVED, PH_PLANAR_QUICK_SOLVED, 5},
    {"10 a wave", 10, 0, 0, PH_PLANAR_QUICK_SOLVED, PH_PLANAR_QUICK_SOLVED, 3},
    {"little noise", 0, 1e-4, 0, PH_PLANAR_QUICK_NEAR, PH_PLANAR_QUICK_SOLVED,
     8},
    {"noise", 0, 0.3, 0, PH_PLANAR_QUICK_NONE, PH_PLANAR_QUICK_SOLVED, 25},
    {"zigzag", 0, 2, 0, PH_PLANAR_QUICK_NONE, PH_PLANAR_QUICK_NONE, 60},
};

static ph_cplx point_of(const struct kind *kind, struct unit_random *r,
                        double turn, double waves, double chord) {
  double size = 1 + 0.1 * cos(3 * turn), noise = kind->noise * chord;
  size += waves > 0 ? 0.2 / waves * cos(waves * turn) : 0;
  return ph_cplx_add(ph_cplx_scale(size, ph_cplx_polar(turn)),
                     ph_cplx_of(noise * unit_random_in(r, -1, 1),
                                noise * unit_random_in(r, -1, 1)));
}

static void set_system(const struct kind *kind, struct unit_random *r,
                       bool closed, struct system *s) {
  const size_t n = 101 + unit_random_below(r, N_MAX - 101);
  const double chord = 2 * PI / (double)n;
  const double waves = kind->per_wave > 0 ? (double)n / kind->per_wave : 0;
  double length[N_MAX];
  ph_cplx first = point_of(kind, r, 0, floor(waves), chord), from = first;
  s->c2 = (struct ph_planar_c2){.n = n,
                                .closed = closed,
                                .direction = s->direction,
                                .space = &ph_quintic,
                                .ratio = s->ratio,
                                .y = s->y};
  for (size_t k = 0; k < n; k++) {
    ph_cplx to =
        closed && k + 1 == n
            ? first
            : point_of(kind, r, chord * (double)(k + 1), floor(waves), chord);
    ph_cplx c = ph_cplx_scale(1 / chord, ph_cplx_sub(to, from));
    length[k] = ph_cplx_abs(c);
    s->h[k] = length[k] * (1 + (k % 2 ? kind->uneven : -kind->uneven) * 0.5);
    s->direction[k] = ph_cplx_scale(1 / length[k], c);
    s->ratio[k] = s->h[k] / length[k];
    from = to;
  }
  for (size_t k = 0; k <= n; k++) {
    double before = s->h[k > 0 ? k - 1 : n - 1], here = s->h[k < n ? k : 0];
    s->y[k] = !closed && (k == 0 || k == n) ? 0.5 : here / (before + here);
  }
  for (size_t side = 0; side < 2; side++) {
    size_t k = side ? n - 1 : 0, next = side ? n - 2 : 1;
    ph_cplx v =
        ph_cplx_sub(ph_cplx_scale(1.5 / s->ratio[k], s->direction[k]),
                    ph_cplx_scale(0.5 / s->ratio[next], s->direction[next]));
    s->c2.end_size[side] = ph_cplx_abs(v);
    s->c2.end[side] = ph_cplx_scale(1 / ph_cplx_abs(v), v);
  }
}

static void check_kind(const struct kind *kind, struct system *s) {
  const size_t unknowns = ph_planar_unknowns(&s->c2);
  ph_cplx b[N_MAX + 2], other[N_MAX + 2], work[N_MAX], up[N_MAX];
  double inverse[N_MAX], size = 0, apart[2] = {0, 0};
  bool turned[N_MAX + 2] = {false};
  struct ph_planar_measure m;
  struct ph_planar_report report, chords;
  enum ph_planar_quick found;
  size_t steps = 0;
  found = ph_planar_c2_quick(&s->c2, &unit_arena, SOLVED, b, work, inverse, up,
                             &steps, &m);
  ck_assert_int_ge((int)found, (int)kind->least - !s->c2.closed);
  ck_assert_int_le((int)found, (int)kind->most);
  if (found == PH_PLANAR_QUICK_SOLVED) {
    ck_assert_double_le(sqrt(ph_planar_residual(&s->c2, b).max2), SOLVED);
  }
  ck_assert_int_eq(
      (int)ph_planar_c2_solve(&s->c2, &unit_arena, b, &report, &diag),
      (int)PH_OK);
  ck_assert_double_le(report.residual, SOLVED);
  ck_assert_uint_le(report.iterations, kind->steps);
  if (ph_planar_c2_turned(&s->c2, turned, &unit_arena, other, &chords, &diag) !=
      PH_OK) {
    ck_assert_int_eq((int)found, (int)PH_PLANAR_QUICK_NONE);
    return;
  }
  for (size_t i = 0; i < unknowns; i++) {
    apart[0] = fmax(apart[0], ph_cplx_abs(ph_cplx_sub(b[i], other[i])));
    apart[1] = fmax(apart[1], ph_cplx_abs(ph_cplx_add(b[i], other[i])));
    size = fmax(size, ph_cplx_abs(b[i]));
  }
  ck_assert_double_le(fmin(apart[0], apart[1]), 1e-10 * size);
}

PH_TEST_EACH(test_kinds, sizeof kinds / sizeof kinds[0]) {
  static struct system s;
  struct unit_random r = unit_random_of(7100 + (unsigned)_i);
  unit_case("%s", kinds[_i].name);
  for (int i = 0; i < unit_count(CURVES); i++) {
    set_system(&kinds[_i], &r, i % 2, &s);
    check_kind(&kinds[_i], &s);
    ph_arena_reset(&unit_arena);
  }
}
