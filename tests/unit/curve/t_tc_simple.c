/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The fast simplicity test against a slow one that shares nothing with it, on
 * known curves, and under what must not change the answer.
 *
 * The slow test looks at all pairs of chords of a polyline between which the
 * tangent turns by a half turn or more.  A chord is within
 * h^2 max|r''|/8 <= h^2 max|w| |w1 - w0|/4 of its part of the curve: if all
 * chords are further apart than these bounds, nothing meets.  Where chords
 * cross, Newton's method on the cubics must find the crossing, or it is not
 * known whether there is one.
 */
#include "unit.h"
#include "cross_unit.h"

#include "curve/cross/tc_simple.h"
#include "kernel/pi.h"

enum { PAIRS = 2000, EVEN = 24, CHORDS = 2 * EVEN - 1, NEWTON = 20 };

struct chain {
  struct ph_tc tc[2];
};

/* ---- chains ------------------------------------------------------------- */

static ph_cplx random_preimage(struct unit_random *r) {
  double size = exp2(unit_random_in(r, -4, 1));
  return ph_cplx_scale(size, ph_cplx_polar(unit_random_in(r, -PH_PI, PH_PI)));
}

/* G1, not C1: at the joint the second has another speed, and sign. */
static struct chain random_chain(struct unit_random *r) {
  struct chain c;
  double speed = exp2(unit_random_in(r, -1, 1));
  c.tc[0].w[0] = random_preimage(r);
  c.tc[0].w[1] = random_preimage(r);
  speed = unit_random_below(r, 2) == 0 ? speed : -speed;
  c.tc[1].w[0] = ph_cplx_scale(speed, c.tc[0].w[1]);
  c.tc[1].w[1] = random_preimage(r);
  return c;
}

/* Both turn to the left, by 90 to 234 degrees each. */
static struct chain random_spiral(struct unit_random *r) {
  struct chain c = random_chain(r);
  double angle = unit_random_in(r, -PH_PI, PH_PI);
  for (size_t k = 0; k < 4; k++) {
    double size = ph_cplx_abs(c.tc[k / 2].w[k % 2]);
    angle += k % 2 == 0 ? 0 : unit_random_in(r, PH_PI / 4, 0.65 * PH_PI);
    c.tc[k / 2].w[k % 2] = ph_cplx_scale(size, ph_cplx_polar(angle));
  }
  return c;
}

/* r(t) of one cubic, from its start. */
static ph_cplx point(const struct ph_tc *tc, double t) {
  ph_cplx d = ph_cplx_sub(tc->w[1], tc->w[0]);
  ph_cplx sum = ph_cplx_scale(t / 3, ph_cplx_mul(d, d));
  sum = ph_cplx_add(sum, ph_cplx_mul(tc->w[0], d));
  sum = ph_cplx_add(ph_cplx_scale(t, sum), ph_cplx_mul(tc->w[0], tc->w[0]));
  return ph_cplx_scale(t, sum);
}

static ph_cplx preimage(const struct ph_tc *tc, double t) {
  ph_cplx d = ph_cplx_sub(tc->w[1], tc->w[0]);
  return ph_cplx_add(tc->w[0], ph_cplx_scale(t, d));
}

static ph_cplx chain_point(const struct chain *c, size_t k, double t) {
  ph_cplx p = point(&c->tc[k], t);
  return k == 0 ? p : ph_cplx_add(point(&c->tc[0], 1), p);
}

/* ---- the slow test ------------------------------------------------------ */

struct chord {
  size_t cubic;
  double t[2], theta[2]; /* parameters; angles of the tangent, not reduced */
  ph_cplx p[2];
  double slack; /* the curve is no further away */
};

static int by_value(const void *a, const void *b) {
  double x = *(const double *)a, y = *(const double *)b;
  return (x > y) - (x < y);
}

/* Parameters at equal steps of the parameter, and of the angle of w. */
static void parameters(const struct ph_tc *tc, double t[CHORDS + 1]) {
  double a = ph_cplx_abs(tc->w[0]), b = ph_cplx_abs(tc->w[1]);
  double sweep = fabs(ph_tc_turning(tc)) / 2;
  for (int i = 0; i < EVEN; i++) {
    double x = (i + 0.5) / EVEN * sweep;
    double near = a * sin(x), far = b * sin(sweep - x);
    t[i] = (double)i / (EVEN - 1);
    t[EVEN + i] = near / (near + far);
  }
  qsort(t, CHORDS + 1, sizeof t[0], by_value);
}

static void chords_of(const struct chain *c, struct chord chord[2 * CHORDS]) {
  double theta = 0;
  for (size_t k = 0; k < 2; k++) {
    const struct ph_tc *tc = &c->tc[k];
    double d = ph_cplx_abs(ph_cplx_sub(tc->w[1], tc->w[0])), t[CHORDS + 1];
    parameters(tc, t);
    for (int i = 0; i < CHORDS; i++) {
      struct chord *at = &chord[k * CHORDS + (size_t)i];
      ph_cplx w[2] = {preimage(tc, t[i]), preimage(tc, t[i + 1])};
      double h = t[i + 1] - t[i];
      double fast = fmax(ph_cplx_abs(w[0]), ph_cplx_abs(w[1]));
      *at = (struct chord){.cubic = k, .t = {t[i], t[i + 1]}};
      at->p[0] = chain_point(c, k, t[i]);
      at->p[1] = chain_point(c, k, t[i + 1]);
      at->slack = h * h * fast * d / 4;
      at->theta[0] = theta;
      theta += 2 * atan2(ph_cplx_cross(w[0], w[1]), ph_cplx_dot(w[0], w[1]));
      at->theta[1] = theta;
    }
  }
}

static double to_chord(ph_cplx p, const struct chord *c) {
  ph_cplx v = ph_cplx_sub(c->p[1], c->p[0]), way = ph_cplx_sub(p, c->p[0]);
  double s = ph_cplx_dot(way, v) / ph_cplx_norm2(v);
  s = s > 0 ? fmin(s, 1) : 0;
  return unit_distance(p, ph_cplx_add(c->p[0], ph_cplx_scale(s, v)));
}

static double side(const struct chord *c, ph_cplx p) {
  return ph_cplx_cross(ph_cplx_sub(c->p[1], c->p[0]), ph_cplx_sub(p, c->p[0]));
}

/* How far two chords are apart: 0 if they cross. */
static double gap(const struct chord *a, const struct chord *b) {
  double start = fmin(to_chord(a->p[0], b), to_chord(b->p[0], a));
  double end = fmin(to_chord(a->p[1], b), to_chord(b->p[1], a));
  bool cross = side(a, b->p[0]) * side(a, b->p[1]) <= 0 &&
               side(b, a->p[0]) * side(b, a->p[1]) <= 0;
  return cross ? 0 : fmin(start, end);
}

/* Whether the curves of two chords cross near by, past a turn of a half turn:
 * not at the point that they may have in common. */
static bool curves_cross(const struct chain *c, const struct chord *a,
                         const struct chord *b) {
  const struct chord *chord[2] = {a, b};
  double t[2] = {(a->t[0] + a->t[1]) / 2, (b->t[0] + b->t[1]) / 2}, det;
  ph_cplx d = {1, 1}, v[2];
  for (int i = 0; i < NEWTON; i++) {
    d = ph_cplx_sub(chain_point(c, a->cubic, t[0]),
                    chain_point(c, b->cubic, t[1]));
    for (size_t k = 0; k < 2; k++) {
      ph_cplx w = preimage(&c->tc[chord[k]->cubic], t[k]);
      v[k] = ph_cplx_mul(w, w);
    }
    det = ph_cplx_cross(v[0], v[1]);
    t[0] -= ph_cplx_cross(d, v[1]) / det;
    t[1] -= ph_cplx_cross(d, v[0]) / det;
    if (!(t[0] >= 0 && t[0] <= 1 && t[1] >= 0 && t[1] <= 1)) {
      return false;
    }
  }
  /* a crossing must be no further than the chords reach */
  for (size_t k = 0; k < 2; k++) {
    double h = chord[k]->t[1] - chord[k]->t[0];
    if (!(t[k] >= chord[k]->t[0] - h && t[k] <= chord[k]->t[1] + h)) {
      return false;
    }
  }
  return ph_cplx_abs(d) <= 1e-13;
}

enum verdict { APART, CROSSING, UNKNOWN };

static enum verdict slow_test(const struct chain *c) {
  static struct chord chord[2 * CHORDS];
  enum verdict verdict = APART;
  chords_of(c, chord);
  for (size_t i = 0; i < 2 * CHORDS; i++) {
    const struct chord *a = &chord[i];
    double low = fmin(a->theta[0], a->theta[1]);
    double high = fmax(a->theta[0], a->theta[1]);
    for (size_t j = i + 1; j < 2 * CHORDS; j++) {
      const struct chord *b = &chord[j];
      double apart;
      low = fmin(low, b->theta[1]);
      high = fmax(high, b->theta[1]);
      if (high - low < PH_PI - 1e-9) {
        continue;
      }
      apart = gap(a, b);
      if (!(apart > 0) && curves_cross(c, a, b)) {
        return CROSSING;
      }
      verdict = apart > a->slack + b->slack ? verdict : UNKNOWN;
    }
  }
  return verdict;
}

/* Half of the chains turn to one side, by so much that the ends come near the
 * joint; a few in a thousand come nearer than 94 chords can tell. */
PH_TEST(test_slow) {
  struct unit_random r = unit_random_of(1);
  int n = unit_count(PAIRS), count[3] = {0, 0, 0};
  for (int i = 0; i < n; i++) {
    struct chain c = i % 2 == 0 ? random_chain(&r) : random_spiral(&r);
    enum verdict slow = slow_test(&c);
    bool fast = ph_tc_is_simple(c.tc, 2);
    count[slow]++;
    if (slow != UNKNOWN) {
      ck_assert_msg(fast == (slow == APART), "seed %lu, chain %d: %d",
                    unit_seed(), i, fast);
    }
  }
  ck_assert_int_gt(count[APART], n / 4);
  ck_assert_int_gt(count[CROSSING], n / 4);
  ck_assert_int_lt(count[UNKNOWN], 4 + n / 100);
}

/* Whole splines are looked at by cross.h: it must not say otherwise. */
PH_TEST(test_cross) {
  struct unit_random r = unit_random_of(5);
  int n = unit_count(PAIRS);
  for (int i = 0; i < n; i++) {
    struct chain c = i % 2 == 0 ? random_chain(&r) : random_spiral(&r);
    ph_cplx from = {0, 0}, joint = chain_point(&c, 1, 0);
    ph_cplx to = chain_point(&c, 1, 1), p[8], w[4];
    double points[16], preimage[8], knots[3] = {0, 1, 2};
    struct ph_curve curve = {.kind = PH_CURVE_TC, .dimension = 2, .degree = 3};
    curve.n = 2;
    curve.knots = knots;
    curve.control_points = points;
    curve.preimage.v = preimage;
    curve.preimage.n = 2;
    curve.preimage.dimension = 2;
    ph_tc_control_points(&c.tc[0], from, joint, p);
    ph_tc_control_points(&c.tc[1], joint, to, p + 4);
    for (size_t k = 0; k < 8; k++) {
      points[2 * k] = p[k].re;
      points[2 * k + 1] = p[k].im;
    }
    for (size_t k = 0; k < 4; k++) {
      w[k] = c.tc[k / 2].w[k % 2];
      preimage[2 * k] = w[k].re;
      preimage[2 * k + 1] = w[k].im;
    }
    ck_assert_msg(unit_cross(&curve, 1).simple == ph_tc_is_simple(c.tc, 2),
                  "seed %lu, chain %d", unit_seed(), i);
  }
}

/* ---- known chains ------------------------------------------------------- */

/*
 * A drop: a cubic from the joint at the bottom, to the left of a horizontal
 * tangent, up to a height where it is x off the vertical line through the
 * joint, and before it its mirror image.  With w from 1 to e^(i a) s, x is
 * (1 + s cos a + s^2 cos 2a)/3.
 */
static struct chain drop(double x) {
  const double angle = 1.4, c = cos(angle), c2 = cos(2 * angle);
  double size = (-c - sqrt(c * c - 4 * c2 * (1 - 3 * x))) / (2 * c2);
  ph_cplx tip = ph_cplx_scale(size, ph_cplx_polar(angle));
  struct chain chain = {{{{ph_cplx_conj(tip), {1, 0}}}, {{{1, 0}, tip}}}};
  return chain;
}

PH_TEST(test_drop) {
  const struct {
    double x;
    bool simple;
  } cases[] = {
      {0.1, true},     {1e-3, true},   {1e-6, true},   {1e-9, true},
      {1e-10, true},   {1e-12, false}, {1e-14, false}, {-1e-14, false},
      {-1e-12, false}, {-1e-9, false}, {-1e-6, false}, {-1e-3, false},
      {-0.1, false},
  };
  for (size_t i = 0; i < COUNT(cases); i++) {
    struct chain c = drop(cases[i].x);
    ck_abs(ph_tc_leg(&c.tc[1]).re, cases[i].x, 1e-15);
    ck_assert_msg(ph_tc_is_simple(c.tc, 2) == cases[i].simple, "x = %g",
                  cases[i].x);
  }
}

/* Ends that meet, wherever they come from. */
PH_TEST(test_closed) {
  struct unit_random r = unit_random_of(2);
  int n = unit_count(PAIRS);
  for (int i = 0; i < n; i++) {
    struct chain c = random_chain(&r);
    /* s^2 + s z + z^2 + 3 leg = 0 */
    ph_cplx z = c.tc[1].w[0], leg = ph_tc_leg(&c.tc[0]);
    ph_cplx square = ph_cplx_mul(z, z), root;
    root = ph_cplx_add(ph_cplx_scale(3, square), ph_cplx_scale(12, leg));
    root = ph_cplx_sqrt(ph_cplx_scale(-1, root));
    c.tc[1].w[1] = ph_cplx_scale(0.5, ph_cplx_sub(root, z));
    ck_abs(unit_distance(ph_tc_leg(&c.tc[1]), ph_cplx_scale(-1, leg)), 0,
           1e-14);
    ck_assert(!ph_tc_is_simple(c.tc, 2));
  }
}

PH_TEST(test_known) {
  const struct ph_tc line = {{{1, 0}, {1, 0}}}, cusp = {{{1, 0}, {-1, 0}}};
  const struct ph_tc loop = {{{1, 0}, {-1, 0.5}}}, none = {{{1, 0}, {0, 0}}};
  const struct ph_tc broken = {{{1, 0}, {(double)NAN, 0}}};
  /* turns by 204 degrees without a loop */
  const struct ph_tc round = {{{1, 0}, {-0.4, 1.9}}};
  const struct ph_tc *all[] = {&line, &cusp, &loop, &none, &broken, &round};
  const bool simple[] = {true, false, false, false, false, true};
  for (size_t i = 0; i < COUNT(all); i++) {
    /* with a straight line that it goes on from */
    struct ph_tc pair[2] = {line, *all[i]};
    ck_assert_msg(ph_tc_is_simple(all[i], 1) == simple[i], "%zu", i);
    ck_assert_msg(ph_tc_is_simple(pair, 2) == simple[i], "%zu", i);
  }
}

/* [BYR11, ex. 5]: of the four pairs one has two loops and one a loop; one has
 * none but crosses itself, and one is simple. */
PH_TEST(test_example_5) {
  const ph_cplx w0 = {1.20354814503777, 0.49852596464362514};
  const ph_cplx w2 = {1.1273066988401768, 0.266121012417165};
  const ph_cplx back = ph_cplx_scale(-1, w2);
  const struct chain pairs[4] = {
      {{{{w0, {0.28613298450635427, -0.5808823156467595}}},
        {{{0.28613298450635427, -0.5808823156467595}, w2}}}},
      {{{{w0, {-1.4515604064453276, 0.1985588271163644}}},
        {{{-1.4515604064453276, 0.1985588271163644}, w2}}}},
      {{{{w0, {0.7691716723378779, -0.6275941666583581}}},
        {{{0.7691716723378779, -0.6275941666583581}, back}}}},
      {{{{w0, {-0.8072923954366746, 0.511391690545128}}},
        {{{-0.8072923954366746, 0.511391690545128}, back}}}},
  };
  const int loops[4] = {0, 2, 1, 0};
  for (size_t i = 0; i < 4; i++) {
    int found = ph_tc_has_loop(&pairs[i].tc[0]);
    found += ph_tc_has_loop(&pairs[i].tc[1]);
    ck_assert_int_eq(found, loops[i]);
    ck_assert_int_eq(ph_tc_is_simple(pairs[i].tc, 2), i == 0);
  }
}

/* ---- the same in other places ------------------------------------------- */

static struct chain reversed(const struct chain *c) {
  const ph_cplx i = {0, 1};
  struct chain back;
  for (size_t k = 0; k < 2; k++) {
    back.tc[k].w[0] = ph_cplx_mul(i, c->tc[1 - k].w[1]);
    back.tc[k].w[1] = ph_cplx_mul(i, c->tc[1 - k].w[0]);
  }
  return back;
}

static struct chain mirrored(const struct chain *c) {
  struct chain image;
  for (size_t k = 0; k < 4; k++) {
    image.tc[k / 2].w[k % 2] = ph_cplx_conj(c->tc[k / 2].w[k % 2]);
  }
  return image;
}

static struct chain turned(const struct chain *c, ph_cplx by) {
  struct chain image;
  for (size_t k = 0; k < 4; k++) {
    image.tc[k / 2].w[k % 2] = ph_cplx_mul(by, c->tc[k / 2].w[k % 2]);
  }
  return image;
}

PH_TEST(test_same) {
  struct unit_random r = unit_random_of(3);
  int n = unit_count(10 * PAIRS);
  for (int i = 0; i < n; i++) {
    struct chain c = i % 2 == 0 ? random_chain(&r) : random_spiral(&r);
    double size = exp2(unit_random_in(&r, -10, 10));
    ph_cplx turn = ph_cplx_polar(unit_random_in(&r, -PH_PI, PH_PI));
    struct chain image[] = {reversed(&c), mirrored(&c), turned(&c, turn),
                            turned(&c, ph_cplx_scale(size, turn))};
    bool simple = ph_tc_is_simple(c.tc, 2);
    for (size_t k = 0; k < COUNT(image); k++) {
      ck_assert_msg(ph_tc_is_simple(image[k].tc, 2) == simple,
                    "seed %lu, chain %d, image %zu", unit_seed(), i, k);
    }
  }
}

/* A cubic cut in two is as simple as it is whole. */
PH_TEST(test_cut) {
  struct unit_random r = unit_random_of(4);
  int n = unit_count(10 * PAIRS), looped = 0;
  for (int i = 0; i < n; i++) {
    struct ph_tc tc = random_chain(&r).tc[0];
    double t = unit_random_in(&r, 0.05, 0.95);
    struct ph_tc part[2] = {ph_tc_part(&tc, 0, t), ph_tc_part(&tc, t, 1)};
    looped += ph_tc_has_loop(&tc);
    ck_assert_int_eq(ph_tc_is_simple(part, 2), !ph_tc_has_loop(&tc));
  }
  ck_assert_int_gt(looped, n / 50);
}
