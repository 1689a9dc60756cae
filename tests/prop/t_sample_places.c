/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Where samples are: that no chord leaves the curve by more than it may, and
 * with how many chords; that samples are equally spaced; that neither depends
 * on the unit or on the direction of travel.  Of every kind of curve and its
 * offsets.
 */
#include "adapt_unit.h"
#include "curve_unit.h"
#include "places_data.h"

#include <float.h>

#include <stdint.h>

static struct places_data data;

static void finish(void) {
  places_free(&data);
}

static const struct ph_offset *offset_of_data(void) {
  return data.has_offset ? &data.offset : NULL;
}

/* The samples of the offset, if there is one, or else of the curve. */
static struct ph_samples samples_of(struct ph_sample_rules rules) {
  struct ph_diag diag;
  if (!data.has_offset) {
    return unit_samples(&data.curve, rules);
  }
  ck_assert_int_eq(
      ph_sample_offset(&data.curve, &rules, &unit_arena, &data.offset, &diag),
      PH_OK);
  return data.offset.samples;
}

/* A curve of this kind, every other one with an offset. */
static void next_curve(int i, enum places_kind kind, struct unit_random *r) {
  ph_arena_reset(&unit_arena);
  places_random(&data, kind, r);
  if (i % 2) {
    places_offset(&data, r);
  }
}

/* ---- chords -------------------------------------------------------------- */

/* The distance of p from the chord of a and b. */
static double from_chord(ph_vec3 p, ph_vec3 a, ph_vec3 b) {
  const ph_vec3 ab = ph_vec3_sub(b, a), ap = ph_vec3_sub(p, a);
  const double length2 = ph_vec3_dot(ab, ab);
  double t = length2 > 0 ? ph_vec3_dot(ap, ab) / length2 : 0;
  t = t < 0 ? 0 : t > 1 ? 1 : t;
  return ph_vec3_abs(ph_vec3_along(ap, -t, ab));
}

/* How far the chord and the curve between two places are from each other, at
 * many places of the curve and some of the chord. */
static double apart(const struct ph_sampler *sampler, double u0, double u1) {
  enum { LOOKS = 16, EVERY = 4 };
  ph_vec3 p[LOOKS + 1];
  double most = 0;
  for (size_t i = 0; i <= LOOKS; i++) {
    double part = (double)i / LOOKS;
    p[i] = ph_sampler_at(sampler, u0 + part * (u1 - u0)).point;
  }
  for (size_t i = 1; i < LOOKS; i++) {
    most = fmax(most, from_chord(p[i], p[0], p[LOOKS]));
  }
  for (size_t i = EVERY; i < LOOKS; i += EVERY) {
    ph_vec3 q =
        ph_vec3_along(p[0], (double)i / LOOKS, ph_vec3_sub(p[LOOKS], p[0]));
    double near = (double)INFINITY;
    for (size_t j = 0; j < LOOKS; j++) {
      near = fmin(near, from_chord(q, p[j], p[j + 1]));
    }
    most = fmax(most, near);
  }
  return most;
}

/* The parameter in [0,1] of sample i. */
static double u_of(const struct ph_samples *s, size_t i) {
  const struct ph_curve *curve = &data.curve;
  return curve->preimage.alpha ? s->t[i] / curve->preimage.alpha[s->segment[i]]
                               : s->t[i];
}

/* Every chord of a segment, of which the first sample may be the last one of
 * the segment before. */
static void ck_chords(const struct ph_samples *s, double error, int n) {
  size_t i = 0;
  for (size_t k = 0; k < data.curve.n; k++) {
    struct ph_sampler sampler = unit_sampler(&data.curve, offset_of_data(), k);
    double before = 0;
    i += k == 0;
    while (i < s->n && s->segment[i] == k) {
      double u = u_of(s, i), most = apart(&sampler, before, u);
      ck_assert_msg(u > before && most <= error * 1.002 + 1e-14,
                    "seed %lu, kind %d, curve %d, segment %zu, %.17g to "
                    "%.17g: %g away, not %g",
                    unit_seed(), (int)data.kind, n, k, before, u, most, error);
      before = u;
      i++;
    }
    ck_abs(before, 1, 0);
  }
  ck_assert_uint_eq(i, s->n);
}

PH_TEST_EACH(test_chords, PLACES_KINDS) {
  struct unit_random r = unit_random_of(1400 + (uint64_t)_i);
  for (int n = 0; n < unit_count(1000); n++) {
    struct ph_sample_rules rules = {
        .how = PH_SAMPLE_CHORD, .chord_error = exp(unit_random_in(&r, -7, 0))};
    struct ph_samples s;
    next_curve(n, (enum places_kind)_i, &r);
    s = samples_of(rules);
    ck_chords(&s, rules.chord_error, n);
  }
}

/* The fewest chords of a segment between places of a grid. */
static size_t fewest(const struct ph_sampler *sampler, double error) {
  enum { GRID = 1000 };
  static ph_vec3 p[GRID + 1];
  size_t from = 0, chords = 0;
  for (size_t i = 0; i <= GRID; i++) {
    p[i] = ph_sampler_at(sampler, (double)i / GRID).point;
  }
  while (from < GRID) {
    size_t to = from + 1;
    bool near = true;
    while (near && to < GRID) {
      for (size_t i = from + 1; near && i <= to; i++) {
        near = from_chord(p[i], p[from], p[to + 1]) <= error;
      }
      to += near;
    }
    from = to;
    chords++;
  }
  return chords;
}

PH_TEST_EACH(test_counts, PLACES_KINDS) {
  struct unit_random r = unit_random_of(1410 + (uint64_t)_i);
  size_t all = 0, least = 0;
  for (int n = 0; n < unit_count(30); n++) {
    struct ph_sample_rules rules = {
        .how = PH_SAMPLE_CHORD, .chord_error = exp(unit_random_in(&r, -9, -4))};
    struct ph_samples s;
    size_t sum = 0;
    next_curve(n, (enum places_kind)_i, &r);
    s = samples_of(rules);
    for (size_t k = 0; k < data.curve.n; k++) {
      struct ph_sampler sampler =
          unit_sampler(&data.curve, offset_of_data(), k);
      sum += fewest(&sampler, rules.chord_error);
    }
    all += s.n - 1;
    least += sum;
    /* a few chords in all, and it is their rounding up that counts */
    ck_assert_uint_le(s.n - 1, 2 * sum + 6 * data.curve.n);
  }
  /* 1.09 to 1.32, by kind and seed */
  ck_assert_msg((double)all <= 1.4 * (double)least, "%zu, not %zu", all, least);
}

/* ---- spacing ------------------------------------------------------------- */

static double speed_at(const void *sampler, double u) {
  double speed;
  ph_sampler_length(sampler, u, &speed);
  return speed;
}

/* The integral of the speed between two places of a segment, which is smooth
 * between cusps. */
static double length_between(const struct ph_sampler *sampler,
                             const struct ph_quad *rule, double from,
                             double to) {
  const struct ph_cusps *cusps = &data.offset.cusps;
  double stops[16], sum = 0;
  size_t n = 0;
  stops[n++] = from;
  for (size_t i = 0; data.has_offset && i < cusps->n; i++) {
    double u = cusps->at[i].u;
    if (cusps->at[i].segment == sampler->k && u > from && u < to) {
      ck_assert_uint_lt(n, 15);
      stops[n++] = u;
    }
  }
  stops[n] = to;
  for (size_t i = 0; i < n; i++) {
    double width = stops[i + 1] - stops[i];
    sum += unit_adapt(rule, speed_at, sampler, stops[i], stops[i + 1],
                      1e-14 * sampler->length / width, 0);
  }
  return sum;
}

/* The same along the curve. */
static double travelled(const struct ph_samples *s, size_t i,
                        const struct ph_quad *rule) {
  double sum = 0;
  for (size_t k = s->segment[i - 1]; k <= s->segment[i]; k++) {
    struct ph_sampler sampler = unit_sampler(&data.curve, offset_of_data(), k);
    double from = k == s->segment[i - 1] ? u_of(s, i - 1) : 0;
    double to = k == s->segment[i] ? u_of(s, i) : 1;
    sum += length_between(&sampler, rule, from, to);
  }
  return sum;
}

static double length_of_data(void) {
  double sum = 0;
  for (size_t k = 0; k < data.curve.n; k++) {
    sum += unit_sampler(&data.curve, offset_of_data(), k).length;
  }
  return sum;
}

PH_TEST_EACH(test_spacing, PLACES_KINDS) {
  struct unit_random r = unit_random_of(1420 + (uint64_t)_i);
  struct ph_quad rule;
  ck_assert(ph_quad_gauss(&rule, 20));
  for (int n = 0; n < unit_count(50); n++) {
    struct ph_sample_rules rules = {.how = PH_SAMPLE_SPACING};
    struct ph_samples s;
    double length;
    size_t last;
    next_curve(n, (enum places_kind)_i, &r);
    length = length_of_data();
    rules.spacing = length * unit_random_in(&r, 0.01, 0.02);
    s = samples_of(rules);
    last = s.n - 1;
    ck_assert_uint_eq(s.n, (size_t)ceil(length / rules.spacing - 1e-9) + 1);
    ck_rel(s.s[last], length, 1e-15);
    ck_abs(u_of(&s, last), 1, 0);
    for (size_t i = 1; i <= last; i++) {
      double step = i < last ? rules.spacing : length - s.s[i - 1];
      ck_assert(i == last || unit_same(s.s[i], (double)i * rules.spacing));
      ck_assert_msg(unit_near(travelled(&s, i, &rule), step, 1e-13 * length),
                    "seed %lu, kind %d, curve %d, sample %zu: %.17g, not %.17g",
                    unit_seed(), _i, n, i, travelled(&s, i, &rule), step);
    }
  }
}

/* The length up to u is s, as well as u can tell: a step of it is some length
 * where the speed is great. */
static void ck_place(const struct ph_sampler *sampler, double u, double s) {
  double speed, length = ph_sampler_length(sampler, u, &speed);
  ck_abs(length, s, 1e-14 * sampler->length + DBL_EPSILON * speed);
}

/* Where the length is s, with how many steps: one after another, and each by
 * itself. */
PH_TEST_EACH(test_places, PLACES_KINDS) {
  enum { TRIES = 20 };
  struct unit_random r = unit_random_of(1430 + (uint64_t)_i);
  size_t all = 0, calls = 0;
  for (int n = 0; n < unit_count(500); n++) {
    struct ph_sampler sampler;
    struct ph_inversion past = {.n = 0};
    next_curve(n, (enum places_kind)_i, &r);
    sampler = unit_sampler(&data.curve, offset_of_data(), 1);
    for (int i = 1; i <= TRIES; i++) {
      double s = (i - 0.5) / TRIES * sampler.length;
      struct ph_inversion none = {.n = 0};
      size_t steps;
      double u = ph_inversion_next(&past, &sampler, s, &steps);
      ck_place(&sampler, u, s);
      calls += steps;
      all++;
      u = ph_inversion_next(&none, &sampler, s, &steps);
      ck_place(&sampler, u, s);
      ck_assert_uint_le(steps, 60);
    }
    ck_abs(unit_parameter(&sampler, 0), 0, 0);
    ck_abs(unit_parameter(&sampler, sampler.length), 1, 0);
  }
  ck_assert_uint_le(2 * calls, 9 * all);
}

/* ---- unit and direction -------------------------------------------------- */

/* Two rules that give a curve of this length some hundred samples. */
static struct ph_sample_rules rules_for(int which, double length) {
  struct ph_sample_rules rules = {.how = PH_SAMPLE_SPACING,
                                  .spacing = length / 101};
  if (which) {
    rules.how = PH_SAMPLE_CHORD;
    rules.chord_error = 1e-4 * length;
  }
  return rules;
}

/* In a unit that is a power of 2 every number is the same. */
PH_TEST_EACH(test_units, PLACES_KINDS) {
  static const int exponents[] = {-30, 30, -200, 200};
  struct unit_random r = unit_random_of(1440 + (uint64_t)_i);
  for (int n = 0; n < unit_count(100); n++) {
    const int exponent = exponents[n / 2 % 4];
    struct ph_sample_rules rules;
    struct ph_samples s, t;
    next_curve(n, (enum places_kind)_i, &r);
    rules = rules_for(n / 8 % 2, length_of_data());
    s = samples_of(rules);
    places_scale(&data, exponent);
    rules.spacing = ldexp(rules.spacing, exponent);
    rules.chord_error = ldexp(rules.chord_error, exponent);
    t = samples_of(rules);
    ck_assert_uint_eq(t.n, s.n);
    for (size_t i = 0; i < s.n; i++) {
      ck_assert_msg(t.segment[i] == s.segment[i] && unit_same(t.t[i], s.t[i]) &&
                        unit_same(t.s[i], ldexp(s.s[i], exponent)),
                    "seed %lu, kind %d, curve %d, sample %zu", unit_seed(), _i,
                    n, i);
    }
  }
}

/* From the end of a curve to its start the places are the same. */
PH_TEST_EACH(test_reversal, PLACES_KINDS) {
  struct unit_random r = unit_random_of(1450 + (uint64_t)_i);
  for (int n = 0; n < unit_count(100); n++) {
    struct ph_sample_rules rules;
    struct ph_samples s, t;
    double length;
    ph_arena_reset(&unit_arena);
    places_random(&data, (enum places_kind)_i, &r);
    length = length_of_data();
    rules = rules_for(n % 2, length);
    s = samples_of(rules);
    places_reverse(&data);
    t = samples_of(rules);
    ck_assert_uint_eq(t.n, s.n);
    for (size_t i = 0; i < s.n; i++) {
      const size_t j = s.n - 1 - i, dimension = s.dimension;
      ph_vec3 p = ph_vec3_get(s.point + dimension * i, dimension);
      ph_vec3 q = ph_vec3_get(t.point + dimension * j, dimension);
      ck_abs(t.s[j], length - s.s[i], 1e-11 * length);
      ck_abs(ph_vec3_abs(ph_vec3_sub(p, q)), 0, 1e-11 * length);
    }
  }
}

PH_FIXTURE(NULL, finish)
