/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Two Tschirnhausen cubics for G1 data, with a free joint and on the chord. */
#include "unit.h"

#include "kernel/pi.h"
#include "solve/tc/tc.h"

static struct ph_tc_hermite data_of(double a, double b) {
  struct ph_tc_hermite h = {
      {ph_tc_snap(ph_cplx_polar(a)), ph_tc_snap(ph_cplx_polar(b))}};
  return h;
}

static double fairness(const struct ph_tc_fit *fit) {
  return fit->energy * fit->length;
}

static double uniform_angle(struct unit_random *r) {
  return unit_random_in(r, -PH_PI, PH_PI);
}

/* Two cubics from 0 to 1 along the given tangents. */
static void ck_fits(const struct ph_tc_hermite *h,
                    const struct ph_tc_fit *fit) {
  const struct ph_tc *tc = fit->tc;
  ph_cplx leg = ph_cplx_add(ph_tc_leg(&tc[0]), ph_tc_leg(&tc[1]));
  ck_assert_uint_eq(fit->n, 2);
  ck_assert(fit->regular);
  ck_abs(leg.re, 1, 1e-13 * fit->length);
  ck_abs(leg.im, 0, 1e-13 * fit->length);
  for (int i = 0; i < 2; i++) {
    ph_cplx t = ph_cplx_mul(tc[i].w[i], tc[i].w[i]);
    ck_abs(ph_cplx_cross(h->t[i], t), 0, 1e-13 * ph_cplx_abs(t));
    ck_assert_double_gt(ph_cplx_dot(h->t[i], t), 0);
  }
  ck_abs(ph_cplx_cross(tc[0].w[1], tc[1].w[0]), 0,
         1e-13 * ph_cplx_abs(tc[0].w[1]) * ph_cplx_abs(tc[1].w[0]));
  ck_rel(fit->length, ph_tc_length(&tc[0]) + ph_tc_length(&tc[1]), 1e-14);
  ck_rel(fit->energy, ph_tc_energy(&tc[0]) + ph_tc_energy(&tc[1]), 1e-14);
}

/* ---- joint anywhere ------------------------------------------------------ */

/*
 * F of the best pair for angles -pi + 2 pi frac(k s), s = 0.7548776662466927
 * at the start and 0.5698402909980532 at the end, k = 1, 2, ..., by another
 * program: numerical quadrature, intersections by subdivision, golden section.
 */
static const double known[] = {
    14.012677886,  20.386660817,  7.9315071819,  28.585146627,  44.034109982,
    0.84698159366, 25.28202904,   29.634787215,  18.381526067,  8.2969195985,
    21.209649295,  27.008538177,  12.264668504,  36.74873276,   4.1467365029,
    50.604407621,  32.461353537,  7.3073440076,  12.384292951,  35.834106985,
    39.546018104,  2.7394509382,  37.658710715,  16.469807636,  16.824373361,
    24.735955048,  6.4851754098,  30.654787865,  26.957547456,  18.655020152,
    3.3442823315,  42.161413674,  43.355385079,  3.5737735336,  25.842757905,
    16.211564277,  33.150457901,  13.568625559,  15.455819088,  14.415641918,
    22.95564562,   33.808091022,  0.25406038602, 39.071689269,  30.094418912,
    10.82951569,   11.990616289,  20.579636647,  44.611383064,  9.3447818074,
    31.985413863,  7.2540699322,  31.388675878,  32.288481301,  3.7529022746,
    18.867088726,  40.079245901,  24.096341076,  3.3501972516,  31.161262574,
    23.289974037,  10.754460653,  31.024174728,  6.8036408198,  50.892420874,
    24.105239294,  13.292179895,  7.6699738991,  36.079905665,  51.501331682,
    1.167687067,   29.637773333,  19.30081953,   19.766817921,  15.402405829,
    12.367393051,  24.092789991,  20.172087651,  25.855387076,  1.6070509301,
    53.531257894,  39.284200581,  5.3701265136,  16.978976756,  22.308081013,
    41.673208405,  7.9303665032,  25.302328988,  12.237818092,  20.816449616,
    36.553318859,  1.9547710308,  29.672561707,  39.659046634,  15.3986321,
    5.9682740858,  28.879158588,  37.093598698,  6.723004396,   38.40428548,
    8.9261374449,  37.087990517,  23.0705918,    8.8239288782,  13.852947806,
    32.288583763,  31.842490524,  0.60286796545, 40.830668397,  22.744795124,
    11.790900444,  19.510325957,  11.517651944,  40.387241419,  17.345013875,
    21.429143772,  4.8718188969,  37.493463227,  45.64964539,   1.8159790649,
    22.139037329,  25.229311335,  24.902133014,  8.5098410959,  20.431263491,
    19.67456105,   16.018098077,  34.494270708,  2.2599353604,  48.605994656,
    37.915166794,  9.3257744672,  10.198044999,  30.188318945,  53.0993347,
    4.3539428987,  39.257430319,  12.503978366,  22.683872104,  24.898278111,
    5.9110061421,  22.638835415,  32.09741733,   21.025110628,  2.0840344302,
    39.07966977,   32.240814546,  6.2996221042,  25.195435701,  12.743331589,
    45.32021147,   15.712590632,  16.130156679,  10.134460084,  26.732442187,
    42.172837093,  0.15509857878, 30.617427937,  27.26004988,   14.93798416,
    11.212628513,  18.208415666,  32.576342128,  12.530306652,  32.143969889,
    4.4087965014,  42.645369059,  35.115812876,  4.8498488011,  15.723807852,
    33.724487331,  32.138425309,  3.7592049845,  31.294298619,  17.733071123,
    14.858719794,  29.99374336,   5.0106618608,  37.680462748,  28.801361506,
    15.084891361,  5.37390234,    39.420958447,  50.985597195,  2.84597106,
    29.99326464,   15.436103097,  27.237811276,  16.159720226,  12.033076419,
    17.59298213,   24.159674893,  28.211809876,  0.42023876737, 48.027809444,
    30.774519682,  8.2292927975,  15.641390217,  18.544199594,  53.729199734,
    10.204667808,  26.215986718,  8.3575878285,  27.136515604,  36.594427422,
    2.0405033471,  22.942908889,  36.805976339,  19.585301125,  5.2831832191,
    26.897628477,  27.162402746,  9.9269459861,  37.833329502,  6.1643504275,
    50.649013101,  26.20657258,   9.9720883297,  10.403651902,  35.36779972,
    41.839807883,  1.2110706722,  34.593058259,  18.932069421,  16.478297322,
    19.077345173,  9.9098758527,  29.529781615,  21.381503667,  22.418897476,
    2.609920907,   49.816063254,  44.579333695,  3.5620395004,  20.902622537,
    20.779659982,  34.069684106,  9.5731511194,  20.509183981,  14.403511336};
static double spread(size_t k, double s) {
  double x = (double)k * s;
  return PH_PI * (2 * (x - floor(x)) - 1);
}

PH_TEST(test_free_known) {
  for (size_t k = 0; k < COUNT(known); k++) {
    struct ph_tc_hermite h = data_of(spread(k + 1, 0.7548776662466927),
                                     spread(k + 1, 0.5698402909980532));
    struct ph_tc_fit fit;
    ck_assert(ph_tc_two_free(&h, &fit));
    ck_rel(fairness(&fit), known[k], 1e-9);
  }
}

/* Of 25 lambdas no simple pair is better than the one found. */
static void ck_best(const struct ph_tc_hermite *h,
                    const struct ph_tc_fit *fit) {
  for (int k = 0; k < 25; k++) {
    double lambda = 0.15 * pow(1.4 / 0.15, k / 24.0);
    struct ph_tc_hermite s = {
        {ph_cplx_scale(lambda, h->t[0]), ph_cplx_scale(lambda, h->t[1])}};
    struct ph_tc_fit fits[PH_TC_PAIRS];
    ph_tc_pairs(&s, fits);
    for (size_t i = 0; i < PH_TC_PAIRS; i++) {
      ph_tc_fit_measure(&fits[i]);
      if (fits[i].regular && fairness(&fits[i]) < fairness(fit)) {
        bool near = fairness(&fits[i]) > fairness(fit) * (1 - 2e-9);
        ck_assert(near || !ph_tc_fit_test(&fits[i]));
      }
    }
  }
}

static void ck_free(const struct ph_tc_hermite *h, struct ph_tc_fit *fit) {
  ck_assert(ph_tc_two_free(h, fit));
  ck_fits(h, fit);
  ck_assert(fit->simple);
  ck_assert_uint_eq(fit->loops, 0);
  ck_assert_uint_ge(fit->root, PH_ROOT_PLUS_PLUS);
  ck_assert_uint_le(fit->root, PH_ROOT_MINUS_MINUS);
  ck_assert_double_ge(fit->lambda, 0.15);
  ck_assert_double_le(fit->lambda, 1.4);
  ck_assert(isnan(fit->ratio) && isnan(fit->joint_angle) &&
            isnan(fit->joint_position));
  for (int i = 0; i < 2; i++) {
    ck_rel(ph_cplx_norm2(fit->tc[i].w[i]), fit->lambda, 1e-14);
    ck_assert(ph_tc_is_regular(&fit->tc[i]));
  }
  ck_abs(unit_distance(fit->tc[0].w[1], fit->tc[1].w[0]), 0, 0);
  ck_best(h, fit);
}

PH_TEST(test_free_random) {
  static const double ranges[] = {PH_PI, 0.5 * PH_PI, 0.1, 1e-3};
  struct unit_random r = unit_random_of(3501);
  for (int i = 0; i < unit_count(800); i++) {
    double range = ranges[i % 4];
    double a = unit_random_in(&r, -range, range);
    struct ph_tc_hermite h = data_of(a, unit_random_in(&r, -range, range));
    struct ph_tc_fit fit;
    ck_free(&h, &fit);
  }
}

/* Tangents along the chord either way, or off it by little or a right angle. */
PH_TEST(test_free_special) {
  static const double angles[] = {0,         1e-9,         1e-3,         1,
                                  PH_PI / 2, PH_PI - 1e-3, PH_PI - 1e-9, PH_PI};
  enum { N = COUNT(angles) };
  for (size_t i = 0; i < N; i++) {
    for (size_t j = 0; j < 2 * (size_t)N; j++) {
      double b = j < N ? angles[j] : -angles[j - N];
      struct ph_tc_hermite h = data_of(angles[i], b);
      struct ph_tc_fit fit;
      ck_free(&h, &fit);
    }
  }
}

PH_TEST(test_free_straight) {
  struct ph_tc_hermite h = data_of(0, 0);
  struct ph_tc_fit fit;
  ck_free(&h, &fit);
  ck_abs(fit.lambda, 0.5, 0);
  ck_abs(fit.energy, 0, 0);
  ck_rel(fit.length, 1, 1e-15);
  ck_assert_uint_eq(fit.root, PH_ROOT_PLUS_PLUS);
}

PH_TEST(test_free_not_finite) {
  struct ph_tc_hermite h = data_of((double)NAN, 1);
  struct ph_tc_fit fit;
  ck_assert(!ph_tc_two_free(&h, &fit));
}

static struct ph_tc_hermite mirrored(const struct ph_tc_hermite *h) {
  struct ph_tc_hermite m = {{ph_cplx_conj(h->t[0]), ph_cplx_conj(h->t[1])}};
  return m;
}

static struct ph_tc_hermite reversed(const struct ph_tc_hermite *h) {
  struct ph_tc_hermite r = {{h->t[1], h->t[0]}};
  return r;
}

/* The same data with other rounding errors. */
static struct ph_tc_hermite turned(const struct ph_tc_hermite *h) {
  ph_cplx u = ph_cplx_polar(1), back = ph_cplx_polar(-1);
  struct ph_tc_hermite t = {{ph_cplx_mul(ph_cplx_mul(h->t[0], u), back),
                             ph_cplx_mul(ph_cplx_mul(h->t[1], u), back)}};
  return t;
}

/* Reversal takes w2 = -sqrt t1 to w0 = -sqrt t1: after a change of all signs
 * the other root of z is the same curve. */
static enum ph_root root_reversed(enum ph_root root) {
  return root == PH_ROOT_MINUS_PLUS    ? PH_ROOT_MINUS_MINUS
         : root == PH_ROOT_MINUS_MINUS ? PH_ROOT_MINUS_PLUS
                                       : root;
}

PH_TEST(test_free_invariant) {
  struct unit_random r = unit_random_of(3502);
  for (int i = 0; i < unit_count(400); i++) {
    double a = uniform_angle(&r);
    struct ph_tc_hermite h = data_of(a, uniform_angle(&r)), other[3];
    struct ph_tc_fit fit, same;
    other[0] = mirrored(&h);
    other[1] = reversed(&h);
    other[2] = turned(&h);
    ck_assert(ph_tc_two_free(&h, &fit));
    for (int k = 0; k < 3; k++) {
      ck_assert(ph_tc_two_free(&other[k], &same));
      ck_assert_uint_eq(same.root, k == 1 ? root_reversed(fit.root) : fit.root);
      ck_rel(same.lambda, fit.lambda, 1e-10);
      ck_rel(same.length, fit.length, 1e-10);
      ck_rel(same.energy, fit.energy, 1e-10);
    }
  }
}

/* ---- joint on the chord -------------------------------------------------- */

/* Example 4 of [BYR11], with its bounds corrected: angles of the data, on which
 * side of the chord, up to which angle; angles that do and do not. */
struct interval {
  double a, b, side, sup, inside, outside;
};

static const struct interval intervals[] = {
    {-11 * PH_PI / 12, 0.6 * PH_PI, 1, 0.19699995528827347, PH_PI / 16,
     0.19758444362199956},
    {-11 * PH_PI / 12, 0.6 * PH_PI, 1, 0.19699995528827347, PH_PI / 19, PH_PI},
    {-11 * PH_PI / 12, 0.6 * PH_PI, -1, PH_PI / 4, PH_PI / 7,
     0.7873665798470659},
    {-0.7 * PH_PI, -2 * PH_PI / 15, 1, 1.9896753472735358, PH_PI / 7,
     2.000147322785502},
    {-0.7 * PH_PI, -2 * PH_PI / 15, -1, 0.03051937990731603,
     0.030207621669132628, 0.03079992797637052},
    {-0.7 * PH_PI, -2 * PH_PI / 15, -1, 0.03051937990731603, PH_PI / 110,
     PH_PI / 85}};
PH_TEST(test_chord_intervals) {
  for (size_t i = 0; i < COUNT(intervals); i++) {
    struct interval v = intervals[i];
    struct ph_tc_hermite h = data_of(v.a, v.b);
    struct ph_tc_fit fit;
    double r[2], s[2];
    ph_tc_g1_range(v.a, r);
    ph_tc_g1_range(v.b, s);
    ck_rel(v.side > 0 ? fmin(r[1], s[1]) : -fmax(r[0], s[0]), v.sup, 1e-12);
    ck_assert(ph_tc_two_chord(&h, v.side * v.inside, (double)NAN, &fit));
    ck_fits(&h, &fit);
    ck_abs(fit.joint_angle, v.side * v.inside, 0);
    ck_assert(!ph_tc_two_chord(&h, v.side * v.outside, (double)NAN, &fit));
    ck_assert(!ph_tc_two_chord(&h, 0, (double)NAN, &fit));
  }
}

/* Curves of Example 4 by another program, see above. */
struct curve {
  double a, b, angle, position; /* given */
  double joint_position, energy, length;
  unsigned loops;
  bool simple;
};

static const struct curve curves[] = {
    {-11 * PH_PI / 12, 0.6 * PH_PI, PH_PI / 19, (double)NAN, 0.705021369783,
     455.246411084, 1.2610229615, 0, true},
    {-11 * PH_PI / 12, 0.6 * PH_PI, -PH_PI / 7, (double)NAN, 0.592447325151,
     73.9652803996, 1.37309879802, 0, true},
    {-0.7 * PH_PI, -2 * PH_PI / 15, PH_PI / 7, (double)NAN, 0.828056572085,
     24.7570113141, 1.15588205014, 0, true},
    {-0.7 * PH_PI, -2 * PH_PI / 15, PH_PI / 7, 0.3, 0.3, 57.6300480204,
     1.07742605657, 0, true},
    {-0.7 * PH_PI, -2 * PH_PI / 15, -PH_PI / 110, (double)NAN, 0.674095882046,
     129026.467566, 1.00434478311, 1, false}};
PH_TEST(test_chord_known) {
  for (size_t i = 0; i < COUNT(curves); i++) {
    const struct curve *v = &curves[i];
    struct ph_tc_hermite h = data_of(v->a, v->b);
    struct ph_tc_fit fit;
    ck_assert(ph_tc_two_chord(&h, v->angle, v->position, &fit));
    ck_rel(fit.joint_position, v->joint_position, 1e-10);
    ck_rel(fit.energy, v->energy, 1e-10);
    ck_rel(fit.length, v->length, 1e-10);
    ck_assert_uint_eq(fit.loops, v->loops);
    ck_assert(fit.simple == v->simple);
  }
}

/* The joint is where it is said to be, with its tangent. */
static void ck_joint(const struct ph_tc_fit *fit) {
  ph_cplx joint = ph_tc_leg(&fit->tc[0]), w = fit->tc[0].w[1];
  ph_cplx u = ph_cplx_polar(fit->joint_angle), t = ph_cplx_mul(w, w);
  ck_assert_uint_eq(fit->root, PH_ROOT_ON_CHORD);
  ck_assert(isnan(fit->ratio) && isnan(fit->lambda));
  ck_abs(joint.re, fit->joint_position, 1e-13 * fit->length);
  ck_abs(joint.im, 0, 1e-13 * fit->length);
  ck_abs(ph_cplx_cross(u, t), 0, 1e-13 * ph_cplx_abs(t));
  ck_assert_double_gt(ph_cplx_dot(u, t), 0);
}

/* 0 of a simple curve, also if cubics go on by 1 % at both ends; 1 of a simple
 * one; else two more than loops. */
static unsigned rank_of(struct ph_tc_fit *fit) {
  unsigned near = 0;
  for (size_t i = 0; i < fit->n; i++) {
    struct ph_tc longer = ph_tc_part(&fit->tc[i], -0.01, 1.01);
    near |= ph_tc_has_loop(&longer);
  }
  return ph_tc_fit_test(fit) ? near : 2 + fit->loops;
}

/* The chosen position is that of the least energy.  Whether the chosen angle is
 * that of the best rank and the least F: one in a narrow range may be missed.
 */
static bool is_chosen(const struct ph_tc_hermite *h, struct ph_tc_fit *fit) {
  struct ph_tc_fit other;
  for (int k = 1; k < 20; k++) {
    ck_assert(ph_tc_two_chord(h, fit->joint_angle, k / 20.0, &other));
    ck_abs(other.joint_position, k / 20.0, 0);
    ck_joint(&other);
    ck_assert_double_ge(other.energy, fit->energy * (1 - 1e-12));
  }
  for (int k = -100; k <= 100; k++) {
    if (ph_tc_two_chord(h, k * PH_PI / 101, (double)NAN, &other)) {
      unsigned rank = rank_of(fit), than = rank_of(&other);
      if (than < rank ||
          (than == rank && !(fairness(&other) > fairness(fit) * (1 - 1e-9)))) {
        return false;
      }
    }
  }
  return true;
}

PH_TEST(test_chord_random) {
  struct unit_random r = unit_random_of(3503);
  int missed = 0, n = unit_count(100);
  for (int i = 0; i < n; i++) {
    double a = uniform_angle(&r), position = unit_random_in(&r, 0.1, 0.9);
    struct ph_tc_hermite h = data_of(a, uniform_angle(&r));
    struct ph_tc_fit fit;
    ck_assert(ph_tc_two_chord(&h, (double)NAN, (double)NAN, &fit));
    ck_fits(&h, &fit);
    ck_joint(&fit);
    missed += !is_chosen(&h, &fit);
    ck_assert(ph_tc_two_chord(&h, (double)NAN, position, &fit));
    ck_abs(fit.joint_position, position, 0);
    ck_joint(&fit);
  }
  ck_assert_int_le(missed, 1 + n / 50);
}

PH_TEST(test_chord_invariant) {
  struct unit_random r = unit_random_of(3504);
  for (int i = 0; i < unit_count(200); i++) {
    double a = uniform_angle(&r);
    struct ph_tc_hermite h = data_of(a, uniform_angle(&r)), other[3];
    struct ph_tc_fit fit, same;
    other[0] = mirrored(&h);
    other[1] = reversed(&h);
    other[2] = turned(&h);
    ck_assert(ph_tc_two_chord(&h, (double)NAN, (double)NAN, &fit));
    for (int k = 0; k < 3; k++) {
      ck_assert(ph_tc_two_chord(&other[k], (double)NAN, (double)NAN, &same));
      ck_rel(same.joint_angle, k == 0 ? -fit.joint_angle : fit.joint_angle,
             1e-9);
      ck_rel(same.joint_position,
             k == 1 ? 1 - fit.joint_position : fit.joint_position, 1e-9);
      ck_rel(fairness(&same), fairness(&fit), 1e-9);
      ck_assert_uint_eq(same.loops, fit.loops);
    }
  }
}

PH_TEST(test_chord_straight) {
  struct ph_tc_hermite h = data_of(0, 0);
  struct ph_tc_fit fit;
  ck_assert(ph_tc_two_chord(&h, (double)NAN, (double)NAN, &fit));
  ck_fits(&h, &fit);
  ck_joint(&fit);
  ck_assert(fit.simple);
  ck_abs(fit.joint_angle, 0, 0);
  ck_abs(fit.joint_position, 0.5, 0);
  ck_abs(fit.energy, 0, 0);
  ck_assert(ph_tc_two_chord(&h, (double)NAN, 0.25, &fit));
  ck_joint(&fit);
  ck_abs(fit.joint_position, 0.25, 0);
  ck_assert(ph_tc_two_chord(&h, 0.5, (double)NAN, &fit));
  ck_fits(&h, &fit);
  ck_assert_uint_eq(fit.loops, 2);
  ck_assert(!fit.simple);
}

/* Along the chord, backward: there is always a curve. */
PH_TEST(test_chord_special) {
  static const double angles[] = {0, 1, PH_PI / 2, PH_PI, -PH_PI / 2, -1};
  for (size_t i = 0; i < 6; i++) {
    for (size_t j = 0; j < 6; j++) {
      struct ph_tc_hermite h = data_of(angles[i], angles[j]);
      struct ph_tc_fit fit;
      ck_assert(ph_tc_two_chord(&h, (double)NAN, (double)NAN, &fit));
      ck_fits(&h, &fit);
      ck_joint(&fit);
    }
  }
}

PH_TEST(test_chord_not_finite) {
  struct ph_tc_hermite h = data_of((double)NAN, 1);
  struct ph_tc_fit fit;
  ck_assert(!ph_tc_two_chord(&h, (double)NAN, (double)NAN, &fit));
  ck_assert(!ph_tc_two_chord(&h, 1, 0.5, &fit));
}
