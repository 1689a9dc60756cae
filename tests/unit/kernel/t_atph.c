/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Spaces of preimages: against quadrature, direct formulas, differences. */
#include "unit.h"
#include "segment_unit.h"

#include "kernel/atph.h"

static const double ANGLES[] = {0,   1e-9, 1e-4, 1e-3, 0.01, 0.1,
                                0.5, 1,    1.5,  2.09, 2.8,  3.1};

enum { ANGLES_N = COUNT(ANGLES) };

/* 1/5, 1/20, 1/30 for PH quintics; positive integrands, no digit is lost. */
PH_TEST(test_integrals) {
  struct ph_atph ph = ph_atph_of(0);
  ck_rel(ph.q[0], 1 / 5.0, 1e-15);
  ck_rel(ph.q[1], 4 / 20.0, 1e-15);
  ck_rel(ph.q[2], 4 / 30.0, 1e-15);
  ck_rel(ph.q[3], 2 / 30.0, 1e-15);
  for (size_t n = 0; n < ANGLES_N; n++) {
    struct ph_atph space = ph_atph_of(ANGLES[n]);
    double mu[3] = {0, 0, 0}, c = cos(ANGLES[n] / 2);
    for (size_t i = 0; i < unit_quad(20)->n; i++) {
      double s[2];
      ph_atph_basis(&space, unit_quad(20)->node[i], s);
      for (size_t j = 0; j < 3; j++) {
        mu[j] += unit_quad(20)->weight[i] * pow(s[0], 4 - (double)j) *
                 pow(s[1], (double)j);
      }
    }
    ck_rel(space.q[0], mu[0], 4e-15);
    ck_rel(space.q[1], 4 * c * mu[1], 4e-15);
    ck_rel(space.q[2], 4 * c * c * mu[2], 4e-15);
    ck_rel(space.q[3], 2 * mu[2], 4e-15);
  }
}

PH_TEST(test_constants) {
  struct ph_atph ph = ph_atph_of(0);
  ck_rel(ph.c, 1, 0);
  ck_rel(ph.sinc, 1, 0);
  ck_rel(ph.slope, 1, 0);
  for (size_t n = 1; n < ANGLES_N; n++) {
    const double half = ANGLES[n] / 2;
    struct ph_atph space = ph_atph_of(ANGLES[n]);
    ck_rel(space.angle, ANGLES[n], 0);
    ck_rel(space.c, cos(half), 1e-15);
    ck_rel(space.sinc, sin(half) / half, 1e-15);
    ck_rel(space.slope, half / tan(half), 2e-15);
  }
}

PH_TEST(test_basis) {
  for (size_t n = 0; n < ANGLES_N; n++) {
    const double a = ANGLES[n];
    struct ph_atph space = ph_atph_of(a);
    for (size_t i = 0; i <= 16; i++) {
      const double u = (double)i / 16;
      double s[2];
      ph_atph_basis(&space, u, s);
      ck_rel(s[0], a > 0 ? sin(a * (1 - u) / 2) / sin(a / 2) : 1 - u, 1e-15);
      ck_rel(s[1], a > 0 ? sin(a * u / 2) / sin(a / 2) : u, 1e-15);
      ck_abs(s[0] * s[0] + 2 * space.c * s[0] * s[1] + s[1] * s[1], 1, 4e-15);
    }
  }
}

/* w from its definition, and each derivative from differences of the one
 * before it. */
PH_TEST(test_jet) {
  struct unit_random r = unit_random_of(530);
  const double step = 1e-4;
  for (size_t n = 0; n < 200; n++) {
    struct ph_seg2 seg = unit_seg2_random(&r);
    double u = unit_random_in(&r, 0.01, 0.99);
    ph_cplx jet[4], left[4], right[4], one[1];
    ph_atph_jet(&seg.space, seg.w, u, jet, 4);
    ph_atph_jet(&seg.space, seg.w, u - step, left, 4);
    ph_atph_jet(&seg.space, seg.w, u + step, right, 4);
    ph_atph_jet(&seg.space, seg.w, u, one, 1);
    ck_cplx(jet[0], unit_seg2_w(&seg, u), 2e-13);
    ck_cplx(one[0], jet[0], 0);
    for (size_t k = 1; k < 4; k++) {
      ck_cplx(
          jet[k],
          ph_cplx_scale(1 / (2 * step), ph_cplx_sub(right[k - 1], left[k - 1])),
          1e-5);
    }
  }
}

/* w'(0) = 2 slope (w1 - w0), w'(1) = 2 slope (w2 - w1). */
PH_TEST(test_ends) {
  struct unit_random r = unit_random_of(531);
  for (size_t n = 0; n < 200; n++) {
    struct ph_seg2 seg = unit_seg2_random(&r);
    const double slope = 2 * seg.space.slope;
    const ph_cplx *w = seg.w;
    ph_cplx jet[2];
    ph_atph_jet(&seg.space, w, 0, jet, 2);
    ck_cplx(jet[0], w[0], 1e-15);
    ck_cplx(jet[1], ph_cplx_scale(slope, ph_cplx_sub(w[1], w[0])), 1e-13);
    ph_atph_jet(&seg.space, w, 1, jet, 2);
    ck_cplx(jet[0], w[2], 1e-15);
    ck_cplx(jet[1], ph_cplx_scale(slope, ph_cplx_sub(w[2], w[1])), 1e-13);
  }
}

/* Sums of the table are the jet; its changes are differences by log a. */
PH_TEST(test_table) {
  struct unit_random r = unit_random_of(532);
  const double step = 1e-4;
  for (size_t n = 0; n < 200; n++) {
    struct ph_seg2 seg = unit_seg2_random(&r);
    const double a = seg.space.angle, u = unit_random_in(&r, 0, 1);
    struct ph_atph less = ph_atph_of(a * exp(-step));
    struct ph_atph more = ph_atph_of(a * exp(step));
    struct ph_atph_table table = ph_atph_table_of(&seg.space, u);
    struct ph_atph_table left = ph_atph_table_of(&less, u);
    struct ph_atph_table right = ph_atph_table_of(&more, u);
    double change, q_change[4];
    ph_cplx jet[3];
    ph_atph_jet(&seg.space, seg.w, u, jet, 3);
    for (size_t k = 0; k < 3; k++) {
      ph_cplx sum = {0, 0};
      for (size_t i = 0; i < 3; i++) {
        sum = ph_cplx_add(sum, ph_cplx_scale(table.b[k][i], seg.w[i]));
        ck_abs(table.change[k][i], (right.b[k][i] - left.b[k][i]) / (2 * step),
               1e-5 * (1 + fabs(table.change[k][i])));
      }
      ck_cplx(sum, jet[k], 1e-12);
    }
    change = ph_atph_slope_change(&seg.space);
    ck_abs(change, a > 0 ? log(more.slope / less.slope) / (2 * step) : 0,
           1e-5 * (1 + fabs(change)));
    ph_atph_q_change(&seg.space, q_change);
    for (size_t i = 0; i < 4; i++) {
      ck_abs(q_change[i], (more.q[i] - less.q[i]) / (2 * step),
             1e-7 * (1 + fabs(q_change[i])));
    }
  }
}

/* A part has the values of the whole. */
PH_TEST(test_part) {
  struct unit_random r = unit_random_of(533);
  for (size_t n = 0; n < 200; n++) {
    struct ph_seg2 seg = unit_seg2_random(&r), part;
    double u0 = unit_random_in(&r, 0, 0.5), u1 = unit_random_in(&r, 0.5, 1);
    ph_atph_part(&seg.space, seg.w, u0, u1, &part.space, part.w);
    ck_rel(part.space.angle, seg.space.angle * (u1 - u0), 1e-15);
    for (size_t i = 0; i <= 8; i++) {
      double x = (double)i / 8;
      ck_cplx(unit_seg2_w(&part, x), unit_seg2_w(&seg, u0 + x * (u1 - u0)),
              2e-13);
    }
    ph_atph_part(&seg.space, seg.w, 0, 1, &part.space, part.w);
    for (size_t i = 0; i < 3; i++) {
      ck_cplx(part.w[i], seg.w[i], 1e-12);
    }
  }
}
