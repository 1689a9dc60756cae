/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Gaps of offsets, on chains of cubics with corners that are known; and samples
 * from gap to gap, by every rule, against offsets worked out here: the polygon
 * of each part is as near as is said, and ends where the part does.
 */
#include "curve_unit.h"
#include "tc_curve_unit.h"

#include "curve/offset/cusp.h"
#include "curve/offset/gap.h"
#include "kernel/pi.h"

static struct ph_diag diag;
static struct unit_cubics c;

static struct ph_gaps gaps_of(const struct ph_curve *curve, double distance) {
  struct ph_gaps gaps;
  ck_assert_int_eq(
      ph_gaps_of(curve, distance, PH_E2, &unit_arena, &gaps, &diag), PH_OK);
  ck_assert((gaps.before != NULL) == (gaps.n > 0));
  return gaps;
}

/* A line in a direction, for so long. */
static void add_line(double angle, double length) {
  const ph_cplx w = ph_cplx_scale(sqrt(length), ph_cplx_polar(angle / 2));
  unit_cubics_add(&c, w, w);
}

/* ---- where they are ------------------------------------------------------ */

/* Two lines that turn by an angle. */
static void bent(double angle, double scale) {
  unit_cubics_begin(&c, ph_cplx_of(0, 0));
  add_line(0.3, scale);
  add_line(0.3 + angle, scale);
}

PH_TEST(test_corners) {
  static const double angles[] = {1e-6, 0.1, 1, 3, PH_PI, -PH_PI, -2};
  static const double scales[] = {1e-150, 1e-9, 1, 1e9, 1e150};
  for (size_t i = 0; i < COUNT(scales); i++) {
    const double scale = scales[i];
    struct ph_gaps gaps;
    for (size_t j = 0; j < COUNT(angles); j++) {
      bent(angles[j], scale);
      gaps = gaps_of(&c.curve, -0.3 * scale);
      ck_assert_uint_eq(gaps.n, 1);
      ck_assert_uint_eq(gaps.before[0], 1);
      ck_assert_uint_eq(gaps_of(&c.curve, 1e-12 * scale).n, 0);
      ck_assert_uint_eq(gaps_of(&c.curve, 0).n, 0);
    }
    bent(0, scale);
    ck_assert_uint_eq(gaps_of(&c.curve, scale).n, 0);
    ck_assert_uint_eq(gaps_of(&c.curve, 1e6 * scale).n, 0);
    ph_arena_reset(&unit_arena);
  }
}

/* It is the jump that counts, |d| times the angle, and the whole size: of lines
 * that turn by next to nothing, 1 + |d|. */
PH_TEST(test_threshold) {
  static const double distances[] = {1e-3, 1, 1e3, 1e6};
  for (size_t i = 0; i < COUNT(distances); i++) {
    const double d = distances[i], angle = 1e-9 * (1 + d) / d;
    bent(0.99 * angle, 1);
    ck_assert_uint_eq(gaps_of(&c.curve, d).n, 0);
    bent(1.01 * angle, 1);
    ck_assert_uint_eq(gaps_of(&c.curve, -d).n, 1);
  }
}

/* What is not known is a gap. */
PH_TEST(test_not_known) {
  bent(0, 1);
  c.preimage[5] = (double)NAN;
  ck_assert_uint_eq(gaps_of(&c.curve, 1).n, 1);
}

/* The preimage of a tangent has two signs. */
PH_TEST(test_signs) {
  bent(0, 1);
  for (size_t i = 4; i < 8; i++) {
    c.preimage[i] = -c.preimage[i];
  }
  ck_assert_uint_eq(gaps_of(&c.curve, 1).n, 0);
}

/* A triangle, whose last corner is at the closing joint. */
static void triangle(void) {
  unit_cubics_begin(&c, ph_cplx_of(0, 0));
  for (int i = 0; i < 3; i++) {
    add_line(2 * PH_PI / 3 * i, 2);
  }
  c.curve.closed = true;
}

PH_TEST(test_closed) {
  struct ph_gaps gaps;
  size_t next = 0;
  triangle();
  gaps = gaps_of(&c.curve, 0.5);
  ck_assert_uint_eq(gaps.n, 3);
  for (size_t k = 0; k < 3; k++) {
    ck_assert_uint_eq(gaps.before[k], k);
    ck_assert(ph_gaps_pass(&gaps, k, &next));
    ck_assert(!ph_gaps_pass(&gaps, k, &next));
  }
  ck_assert(ph_gaps_open(&gaps));
  c.curve.closed = false;
  gaps = gaps_of(&c.curve, 0.5);
  ck_assert_uint_eq(gaps.n, 2);
  ck_assert(!ph_gaps_open(&gaps));
  next = 0;
  ck_assert(!ph_gaps_pass(&gaps, 0, &next));
  ck_assert(ph_gaps_pass(&gaps, 2, &next)); /* both at once */
  ck_assert(!ph_gaps_pass(&gaps, 2, &next));
}

/* ---- samples of a known offset ------------------------------------------- */

struct row {
  size_t k;
  double t, s, x, y;
};

static struct ph_offset sampled(double distance, struct ph_sample_rules rules) {
  struct ph_offset o = {.distance = distance, .dimension = 2};
  o.gaps = gaps_of(&c.curve, distance);
  ck_assert_int_eq(ph_sample_offset(&c.curve, &rules, &unit_arena, &o, &diag),
                   PH_OK);
  return o;
}

static void ck_rows(const struct ph_samples *s, const struct row *rows,
                    size_t n) {
  ck_assert_uint_eq(s->n, n);
  for (size_t i = 0; i < n; i++) {
    ck_assert_uint_eq(s->segment[i], rows[i].k);
    ck_abs(s->t[i], rows[i].t, 1e-14);
    ck_abs(s->s[i], rows[i].s, 1e-13);
    ck_abs(s->point[2 * i], rows[i].x, 1e-13);
    ck_abs(s->point[2 * i + 1], rows[i].y, 1e-13);
  }
}

/* A right angle, offset to its outer side: (10,-3) and (13,0). */
PH_TEST(test_right_angle) {
  static const struct row ends[] = {{0, 0, 0, 0, -3},
                                    {0, 1, 10, 10, -3},
                                    {1, 0, 10, 13, 0},
                                    {1, 1, 20, 13, 10}};
  static const struct row spaced[] = {{0, 0, 0, 0, -3},    {0, 0.4, 4, 4, -3},
                                      {0, 0.8, 8, 8, -3},  {0, 1, 10, 10, -3},
                                      {1, 0, 10, 13, 0},   {1, 0.2, 12, 13, 2},
                                      {1, 0.6, 16, 13, 6}, {1, 1, 20, 13, 10}};
  /* what is all but there, or to rounding, is there */
  static const double at_gap[] = {10, 10 * (1 + 1e-15), 10 * (1 - 1e-15),
                                  10 * (1 + 1e-10), 10 * (1 - 1e-10)};
  struct ph_offset o;
  unit_cubics_begin(&c, ph_cplx_of(0, 0));
  add_line(0, 10);
  add_line(PH_PI / 2, 10);
  o = sampled(-3, (struct ph_sample_rules){.how = PH_SAMPLE_CHORD,
                                           .chord_error = 0.01});
  ck_rows(&o.samples, ends, 4);
  o = sampled(-3, (struct ph_sample_rules){.how = PH_SAMPLE_PARAMETER, .n = 1});
  ck_rows(&o.samples, ends, 4);
  o = sampled(-3,
              (struct ph_sample_rules){.how = PH_SAMPLE_SPACING, .spacing = 4});
  ck_rows(&o.samples, spaced, 8);
  for (size_t i = 0; i < COUNT(at_gap); i++) {
    o = sampled(-3, (struct ph_sample_rules){.how = PH_SAMPLE_SPACING,
                                             .spacing = at_gap[i]});
    ck_rows(&o.samples, ends, 4);
  }
  o = sampled(
      -3, (struct ph_sample_rules){.how = PH_SAMPLE_SPACING, .spacing = 1e300});
  ck_rows(&o.samples, ends, 4);
}

/* A part that is shorter than what is left out has two ends none the less. */
PH_TEST(test_short_part) {
  static const struct row rows[] = {{0, 0, 0, 0, 1}, {0, 1, 1, 1, 1},
                                    {1, 0, 1, 0, 0}, {1, 1, 1, 0, 0},
                                    {2, 0, 1, 1, 1}, {2, 1, 2, 2, 1}};
  struct ph_offset o;
  unit_cubics_begin(&c, ph_cplx_of(0, 0));
  add_line(0, 1);
  add_line(PH_PI / 2, 1e-14);
  add_line(0, 1);
  o = sampled(1,
              (struct ph_sample_rules){.how = PH_SAMPLE_SPACING, .spacing = 1});
  ck_rows(&o.samples, rows, 6);
}

PH_TEST(test_triangle) {
  for (int how = PH_SAMPLE_PARAMETER; how <= PH_SAMPLE_CHORD; how++) {
    const struct ph_sample_rules rules = {
        .how = (enum ph_sampling)how, .n = 1, .spacing = 2, .chord_error = 0.1};
    struct ph_offset o;
    triangle();
    o = sampled(-0.5, rules);
    ck_assert_uint_eq(o.samples.n, 6);
    for (size_t i = 0; i < 6; i++) {
      ck_assert_uint_eq(o.samples.segment[i], i / 2);
      ck_abs(o.samples.t[i], (double)(i % 2), 0);
      ck_abs(o.samples.s[i], 2 * (double)((i + 1) / 2), 1e-15);
    }
  }
}

/* ---- random chains ------------------------------------------------------- */

/* The offset of cubic k at u. */
static ph_cplx offset_at(size_t k, double u, double distance) {
  const double *w = c.preimage + 4 * k, *p = c.control_points + 8 * k;
  const struct ph_tc tc = {{{w[0], w[1]}, {w[2], w[3]}}};
  const ph_cplx leg = unit_tc_at(&tc, u);
  const ph_cplx at =
      ph_cplx_of(w[0] + u * (w[2] - w[0]), w[1] + u * (w[3] - w[1]));
  const ph_cplx square = ph_cplx_mul(at, at);
  const double per = distance / ph_cplx_norm2(at);
  return ph_cplx_of(p[0] + leg.re - per * square.im,
                    p[1] + leg.im + per * square.re);
}

/* How far p is from the line from a to b. */
static double from_chord(ph_cplx p, ph_cplx a, ph_cplx b) {
  const ph_cplx along = ph_cplx_sub(b, a), to = ph_cplx_sub(p, a);
  const double part = ph_cplx_dot(along, to) / ph_cplx_norm2(along);
  const double within = part > 0 ? part < 1 ? part : 1 : 0;
  return unit_distance(p, ph_cplx_between(a, b, within));
}

/* Cubics of the size `scale`, with corners here and there; their number. */
static size_t random_chain(struct unit_random *r, double scale, bool corner[]) {
  enum { CUBICS = 12 };
  double direction = unit_random_in(r, -3, 3);
  size_t n = 0;
  unit_cubics_begin(&c, ph_cplx_of(100 * scale, -30 * scale));
  for (size_t k = 0; k < CUBICS; k++) {
    const double first = unit_random_in(r, 0.3, 1.5);
    const double last = unit_random_in(r, 0.3, 1.5);
    const double sign = unit_random_below(r, 2) ? 1 : -1;
    ph_cplx w[2];
    corner[k] = k > 0 && unit_random_below(r, 2);
    if (corner[k]) {
      direction += sign * unit_random_in(r, 0.01, PH_PI / 2);
      n++;
    }
    w[0] = ph_cplx_scale(sign * first * sqrt(scale), ph_cplx_polar(direction));
    direction += unit_random_in(r, -1.2, 1.2);
    w[1] = ph_cplx_scale(sign * last * sqrt(scale), ph_cplx_polar(direction));
    unit_cubics_add(&c, w[0], w[1]);
  }
  return n;
}

static ph_cplx sample_at(const struct ph_samples *s, size_t i) {
  return ph_cplx_of(s->point[2 * i], s->point[2 * i + 1]);
}

/* Both ends of the part that sample i begins, and of the one before. */
static void ck_ends(const struct ph_samples *s, size_t i) {
  ck_abs(s->t[i], 0, 0);
  if (i > 0) {
    ck_assert_uint_eq(s->segment[i - 1] + 1, s->segment[i]);
    ck_abs(s->t[i - 1], 1, 0);
    ck_abs(s->s[i - 1], s->s[i], 0);
  }
}

/* From sample i - 1 to sample i of one part, by its own sight. */
static void ck_chord(const struct ph_offset *o, size_t i, double error,
                     double rounding) {
  const struct ph_samples *s = &o->samples;
  const size_t k = s->segment[i];
  const double from = s->segment[i - 1] == k ? s->t[i - 1] : 0;
  for (int j = 0; j <= 16; j++) {
    const double u = from + (s->t[i] - from) * j / 16;
    const ph_cplx p = offset_at(k, u, o->distance);
    ck_abs(fmax(from_chord(p, sample_at(s, i - 1), sample_at(s, i)) - error, 0),
           0, rounding);
  }
}

/* Within a part, places are multiples of the spacing, and none is left out. */
static void ck_spacing(const struct ph_samples *s, size_t i, double spacing,
                       bool ends) {
  const double slack = 1e-8 * spacing;
  ck_assert(s->s[i] - s->s[i - 1] <= spacing + slack);
  if (!ends) {
    ck_abs(remainder(s->s[i], spacing), 0, slack);
  }
}

static void ck_chain(const struct ph_offset *o, const bool corner[],
                     const struct ph_sample_rules *rules, double scale) {
  const struct ph_samples *s = &o->samples;
  size_t parts = 1;
  ck_ends(s, 0);
  ck_abs(s->t[s->n - 1], 1, 0);
  ck_assert_uint_eq(s->segment[s->n - 1], c.curve.n - 1);
  for (size_t i = 0; i < s->n; i++) {
    const size_t k = s->segment[i];
    const ph_cplx found = offset_at(k, s->t[i], o->distance);
    ck_abs(unit_distance(found, sample_at(s, i)), 0, 1e-12 * scale);
    if (i > 0 && k > s->segment[i - 1] && corner[k]) {
      ck_ends(s, i);
      parts++;
    } else if (i > 0 && rules->how == PH_SAMPLE_CHORD) {
      ck_chord(o, i, rules->chord_error, 1e-12 * scale);
    } else if (i > 0 && rules->how == PH_SAMPLE_SPACING) {
      ck_spacing(s, i, rules->spacing,
                 i + 1 == s->n ||
                     (s->segment[i + 1] > k && corner[s->segment[i + 1]]));
    }
  }
  ck_assert_uint_eq(parts, o->gaps.n + 1);
}

PH_TEST_EACH(test_chains, PH_SAMPLE_CHORD) {
  struct unit_random r = unit_random_of(1701 + (uint64_t)_i);
  for (int n = 0; n < unit_count(200); n++) {
    const double scale = pow(10, unit_random_in(&r, -9, 9));
    const struct ph_sample_rules rules = {
        .how = (enum ph_sampling)(PH_SAMPLE_PARAMETER + _i),
        .n = 1 + unit_random_below(&r, 4),
        .spacing = scale * pow(10, unit_random_in(&r, -2, 1)),
        .chord_error = scale * pow(10, unit_random_in(&r, -4, 1))};
    bool corner[UNIT_CUBICS];
    const size_t corners = random_chain(&r, scale, corner);
    const double distance = scale * unit_random_in(&r, -2, 2);
    struct ph_offset o = {.distance = distance, .dimension = 2};
    ck_assert_int_eq(
        ph_cusps_of(&c.curve, distance, PH_E2, &unit_arena, &o.cusps, &diag),
        PH_OK);
    o.gaps = gaps_of(&c.curve, distance);
    ck_assert_uint_eq(o.gaps.n, corners);
    for (size_t i = 0; i < o.gaps.n; i++) {
      ck_assert(corner[o.gaps.before[i]]);
    }
    ck_assert_int_eq(ph_sample_offset(&c.curve, &rules, &unit_arena, &o, &diag),
                     PH_OK);
    ck_chain(&o, corner, &rules, scale);
    ph_arena_reset(&unit_arena);
  }
}
