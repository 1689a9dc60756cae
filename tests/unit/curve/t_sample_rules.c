/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Where samples are taken, on curves where it is known; what is refused. */
#include "curve_unit.h"
#include "tc_curve_unit.h"

#include "curve/offset/cusp.h"
#include "kernel/pi.h"

static struct ph_diag diag;

static struct ph_samples spaced(const struct ph_curve *curve, double spacing) {
  const struct ph_sample_rules rules = {.how = PH_SAMPLE_SPACING,
                                        .spacing = spacing};
  return unit_samples(curve, rules);
}

static struct ph_samples chords(const struct ph_curve *curve, double error) {
  const struct ph_sample_rules rules = {.how = PH_SAMPLE_CHORD,
                                        .chord_error = error};
  return unit_samples(curve, rules);
}

/* A line along x, of length 4, in n <= 3 segments. */
static void line_of(size_t n, struct unit_segments *c) {
  const ph_cplx w[3] = {{2 / sqrt((double)n), 0},
                        {2 / sqrt((double)n), 0},
                        {2 / sqrt((double)n), 0}};
  struct ph_seg2 seg[3] = {unit_seg2(0, w)};
  for (size_t k = 0; k < n; k++) {
    seg[k] = seg[0];
    seg[k].start.re = 4 * (double)k / (double)n;
    seg[k].end.re = 4 * (double)(k + 1) / (double)n;
  }
  unit_seg2_curve(seg, n, c);
  for (size_t k = 0; k < n; k++) {
    c->lengths[k] = 4 / (double)n;
  }
  c->curve.length = 4;
}

/* A whole circle of three arcs. */
static void circle_of(double radius, struct unit_segments *c) {
  const double alpha = PH_PI / 3, rest = alpha / (2 * ph_atph_of(alpha).slope);
  const double root = sqrt(2 * radius) * sqrt(alpha);
  struct ph_seg2 seg[3];
  for (size_t k = 0; k < 3; k++) {
    const double turned = alpha * (double)k;
    const ph_cplx w[3] = {ph_cplx_scale(root, ph_cplx_polar(turned)),
                          ph_cplx_scale(root, ph_cplx_mul(ph_cplx_polar(turned),
                                                          ph_cplx_of(1, rest))),
                          ph_cplx_scale(root, ph_cplx_polar(turned + alpha))};
    seg[k] = unit_seg2(alpha, w);
    for (size_t i = 0; i < 2; i++) {
      double at = 2 * alpha * (double)(k + i);
      ph_cplx p = ph_cplx_of(radius * sin(at), radius * (1 - cos(at)));
      *(i ? &seg[k].end : &seg[k].start) = p;
    }
  }
  unit_seg2_curve(seg, 3, c);
  c->curve.closed = true;
  for (size_t k = 0; k < 3; k++) {
    c->lengths[k] = 2 * alpha * radius;
    c->curve.length += c->lengths[k];
  }
}

/* ---- equal spacing ------------------------------------------------------- */

/* Of a line, places are arc lengths: each i * spacing, and the end. */
static void ck_line(const struct ph_samples *s, double spacing, size_t n) {
  ck_assert_uint_eq(s->n, n);
  for (size_t i = 0; i < n; i++) {
    double at = i + 1 < n ? (double)i * spacing : 4;
    ck_abs(s->s[i], at, 0);
    ck_abs(s->point[2 * i], at, 1e-15);
    ck_abs(s->tangent[2 * i], 1, 0);
  }
}

PH_TEST(test_line_spacing) {
  static const struct {
    double spacing;
    size_t n;
  } cases[] = {
      {1, 5},
      {0.5, 9},
      {0.1, 41},
      {3, 3},
      {4.0 / 3, 4},
      {4, 2},
      {4 * (1 + 1e-12), 2},
      {5, 2},
      {1e300, 2},
      {1e-3, 4001},
      {4 / 7.0, 8},
      {4 * (1 - 1e-12), 2},
      {4 * (1 - 1e-6), 3},
  };
  for (size_t segments = 1; segments <= 3; segments++) {
    for (size_t i = 0; i < COUNT(cases); i++) {
      struct unit_segments c;
      struct ph_samples s;
      line_of(segments, &c);
      s = spaced(&c.curve, cases[i].spacing);
      ck_line(&s, cases[i].spacing, cases[i].n);
      ck_assert_uint_eq(s.segment[s.n - 1], segments - 1);
      ck_abs(s.t[s.n - 1], 1, 0);
      ph_arena_reset(&unit_arena);
    }
  }
}

/* A place at a joint is the start of what follows, rounding or not. */
PH_TEST(test_joint_spacing) {
  struct unit_segments c;
  struct ph_samples s;
  line_of(2, &c);
  s = spaced(&c.curve, 0.1); /* 20 * 0.1 = 2 */
  ck_assert_uint_eq(s.segment[19], 0);
  ck_assert_uint_eq(s.segment[20], 1);
  ck_abs(s.t[20], 0, 0);
  ck_abs(s.t[19], 0.95, 1e-15);
  circle_of(1, &c);
  s = spaced(&c.curve, c.curve.length / 12);
  ck_assert_uint_eq(s.n, 13);
  for (size_t i = 0; i < 12; i++) {
    ck_assert_uint_eq(s.segment[i], i / 4);
    ck_assert(i % 4 || unit_same(s.t[i], 0));
  }
}

/* Around a circle; the start is there again as the end. */
PH_TEST(test_circle_spacing) {
  const double radii[] = {1, 1e-9, 1e9};
  for (size_t k = 0; k < COUNT(radii); k++) {
    const double radius = radii[k], step = radius / 7;
    struct unit_segments c;
    struct ph_samples s;
    circle_of(radius, &c);
    s = spaced(&c.curve, step);
    ck_assert_uint_eq(s.n, 45); /* 14 pi = 43.98 */
    ck_assert(!unit_same(s.s[44], 44 * step));
    for (size_t i = 0; i < s.n; i++) {
      double at = i < 44 ? (double)i / 7 : 2 * PH_PI;
      ck_rel(s.s[i], radius * at, 2e-15);
      ck_abs(s.point[2 * i] / radius, sin(at), 1e-14);
      ck_abs(s.point[2 * i + 1] / radius, 1 - cos(at), 1e-14);
    }
  }
}

/* As long as a cusp, where the speed is 0: s - s_0 goes as (u - u_0)^3. */
PH_TEST(test_cusp_spacing) {
  struct unit_cubics c;
  struct ph_samples s;
  unit_cubics_begin(&c, ph_cplx_of(0, 0));
  unit_cubics_add(&c, ph_cplx_of(-1, 0), ph_cplx_of(1, 0));
  s = spaced(&c.curve, c.curve.length / 64);
  ck_assert_uint_eq(s.n, 65);
  for (size_t i = 0; i < s.n; i++) {
    double w = cbrt((double)i / 32 - 1);
    ck_abs(s.t[i], 0.5 + w / 2, i == 32 ? 3e-5 : 1e-13);
  }
}

/* ---- chords -------------------------------------------------------------- */

PH_TEST(test_line_chords) {
  const double errors[] = {1e-12, 1e-9, 1, 1e300};
  for (size_t segments = 1; segments <= 3; segments++) {
    for (size_t i = 0; i < COUNT(errors); i++) {
      struct unit_segments c;
      struct ph_samples s;
      line_of(segments, &c);
      s = chords(&c.curve, errors[i]);
      ck_assert_uint_eq(s.n, segments + 1);
      for (size_t k = 0; k < s.n; k++) {
        ck_abs(s.point[2 * k], 4 * (double)k / (double)segments, 1e-15);
        ck_assert_uint_eq(s.segment[k], k ? k - 1 : 0);
        ck_abs(s.t[k], k ? 1 : 0, 0);
      }
    }
  }
}

/* Chords of a circle are equal, and nearly the longest ones that may be. */
PH_TEST(test_circle_chords) {
  struct unit_segments c;
  circle_of(2, &c);
  for (double error = 1e-2; error > 1e-9; error /= 3) {
    struct ph_samples s = chords(&c.curve, error);
    const double angle = 2 * acos(1 - error / 2);
    const double least = 3 * ceil(2 * PH_PI / 3 / angle);
    const double step = c.curve.length / (double)(s.n - 1);
    ck_assert((double)(s.n - 1) >= least);
    ck_assert((double)(s.n - 1) <= 1.1 * least + 3);
    for (size_t i = 0; i < s.n; i++) {
      ck_abs(s.s[i], (double)i * step, 1e-9 * c.curve.length);
    }
    ph_arena_reset(&unit_arena);
  }
}

/* All of a short curve is as near to its ends as may be. */
PH_TEST(test_short) {
  struct unit_segments c;
  circle_of(1, &c);
  ck_assert_uint_eq(chords(&c.curve, 1.1).n, 4);
}

/* ---- offsets ------------------------------------------------------------- */

PH_TEST(test_circle_offset) {
  const double distances[] = {0.5, -3, 2.5};
  for (size_t i = 0; i < COUNT(distances); i++) {
    const double d = distances[i], radius = fabs(2 - d);
    struct ph_sample_rules rules = {.how = PH_SAMPLE_SPACING, .spacing = 0.01};
    struct ph_offset o = {.distance = d, .dimension = 2};
    struct unit_segments c;
    circle_of(2, &c);
    ck_assert_int_eq(ph_sample_offset(&c.curve, &rules, &unit_arena, &o, &diag),
                     PH_OK);
    ck_rel(o.length, 2 * PH_PI * radius, 1e-14);
    ck_assert_uint_eq(o.samples.n, (size_t)ceil(o.length / 0.01) + 1);
    rules.how = PH_SAMPLE_CHORD;
    rules.chord_error = 1e-4;
    ck_assert_int_eq(ph_sample_offset(&c.curve, &rules, &unit_arena, &o, &diag),
                     PH_OK);
    for (size_t k = 0; k < o.samples.n; k++) {
      const double *p = o.samples.point + 2 * k;
      ck_abs(hypot(p[0], p[1] - 2), radius, 1e-14);
    }
  }
}

/* Cusps of an offset are among its chords. */
PH_TEST(test_offset_cusps) {
  struct unit_random r = unit_random_of(1460);
  size_t some = 0;
  for (int n = 0; n < unit_count(50); n++) {
    const struct ph_sample_rules rules = {.how = PH_SAMPLE_CHORD,
                                          .chord_error = 0.05};
    struct ph_offset o = {.distance = unit_random_in(&r, -1, 1),
                          .dimension = 2};
    struct unit_cubics c;
    size_t found = 0;
    unit_cubics_random(&c, &r, 4, 1, ph_cplx_of(0, 0));
    ck_assert_int_eq(
        ph_cusps_of(&c.curve, o.distance, PH_E2, &unit_arena, &o.cusps, &diag),
        PH_OK);
    ck_assert_int_eq(ph_sample_offset(&c.curve, &rules, &unit_arena, &o, &diag),
                     PH_OK);
    for (size_t i = 0; i < o.samples.n && found < o.cusps.n; i++) {
      const struct ph_place *at = &o.cusps.at[found]; /* a joint is an end */
      found += unit_same((double)o.samples.segment[i] + o.samples.t[i],
                         (double)at->segment + at->u);
    }
    ck_assert_uint_eq(found, o.cusps.n);
    some += found;
  }
  ck_assert_uint_ge(some, 10);
}

/* ---- refusals ------------------------------------------------------------ */

PH_TEST(test_too_many) {
  const struct ph_sample_rules refused[] = {
      {.how = PH_SAMPLE_SPACING, .spacing = 1e-9},
      {.how = PH_SAMPLE_SPACING, .spacing = 1e-300},
      {.how = PH_SAMPLE_SPACING, .spacing = 1e-323},
      {.how = PH_SAMPLE_CHORD, .chord_error = 1e-20},
      {.how = PH_SAMPLE_CHORD, .chord_error = 1e-300},
      {.how = PH_SAMPLE_PARAMETER, .n = PH_SAMPLES_MAX / 3},
  };
  static const char *const messages[] = {
      "samples 1e-09 apart would be 6.28319e+09 or more, above the 10000000 "
      "of --max-samples",
      "samples 1e-300 apart would be 6.28319e+300 or more, above the 10000000 "
      "of --max-samples",
      "samples 9.88131e-324 apart would be inf or more, above the 10000000 "
      "of --max-samples",
      "chords within 1e-20 of the curve take more samples than the "
      "10000000 of --max-samples",
      "chords within 1e-300 of the curve take more samples than the "
      "10000000 of --max-samples",
      "the samples would be 1e+07, above the 10000000 of --max-samples",
  };
  for (size_t i = 0; i < COUNT(refused); i++) {
    struct ph_offset o = {.distance = 0.5, .dimension = 2};
    struct ph_samples s;
    struct unit_segments c;
    circle_of(1, &c);
    ck_assert_int_eq(
        ph_sample_curve(&c.curve, &refused[i], &unit_arena, &s, &diag),
        PH_E_LIMIT);
    ck_assert_str_eq(diag.message, messages[i]);
    ck_assert_int_eq(
        ph_sample_offset(&c.curve, &refused[i], &unit_arena, &o, &diag),
        PH_E_LIMIT);
  }
}

/* A length that is not known. */
PH_TEST(test_no_length) {
  const struct ph_sample_rules rules = {.how = PH_SAMPLE_SPACING, .spacing = 1};
  struct ph_samples s;
  struct unit_segments c;
  circle_of(1, &c);
  c.lengths[1] = (double)NAN;
  ck_assert_int_eq(ph_sample_curve(&c.curve, &rules, &unit_arena, &s, &diag),
                   PH_E_NO_CONVERGENCE);
  ck_assert_str_eq(diag.field, "segments[1]");
}
