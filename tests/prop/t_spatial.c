/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Properties of spatial Hermite interpolants on random data, each solved and
 * certified: what must follow when the data are moved, turned, scaled,
 * mirrored, reversed, started elsewhere or changed far away.
 *
 * The seed is 1, or PH_SEED; PH_LONG=1 takes ten times as many data.  Control
 * points are compared relative to the length of their segment's control
 * polygon.
 */
#include "spatial_data.h"
#include "motion.h"
#include "unit.h"

static struct unit_solution one, other;
static struct spatial_data data, image;

static void finish(void) {
  unit_solution_free(&one);
  unit_solution_free(&other);
}

/* ---- motions --------------------------------------------------------- */

/* Where datum and segment k of the image are from: closed curves keep their
 * first point. */
static size_t datum_from(const struct motion *m, size_t k) {
  size_t n = data.n;
  return !m->reverse ? k : data.closed ? (n - k) % n : n - 1 - k;
}

static size_t segment_from(const struct motion *m, size_t k) {
  return m->reverse ? spatial_segments(&data) - 1 - k : k;
}

/* Backwards, tangents are negated, and theta is, about the chord as about the
 * bisector; mirrored, all angles are. */
static void move_data(const struct motion *m) {
  size_t segments = spatial_segments(&data);
  image = data;
  for (size_t k = 0; k < data.n; k++) {
    size_t from = datum_from(m, k);
    image.point[k] = moved(m, data.point[from]);
    image.vector[k] =
        turned(m, ph_vec3_scale(m->reverse ? -1 : 1, data.vector[from]));
  }
  for (size_t k = 0; k < segments; k++) {
    size_t from = segment_from(m, k);
    double sign = m->mirror ? -1 : 1;
    image.angles[2 * k] = (m->reverse ? -sign : sign) * data.angles[2 * from];
    image.angles[2 * k + 1] = sign * data.angles[2 * from + 1];
    image.alpha[k] = data.alpha[from];
    image.tension[k] = data.tension[from];
  }
  for (size_t k = 0; k <= segments; k++) {
    image.knots[k] =
        m->reverse ? -data.knots[segments - k] : m->scale * data.knots[k];
  }
}

/* Solves data and image; false if neither has a curve. */
static bool solve_both(size_t which) {
  bool a = spatial_answer(&data, which, &one),
       b = spatial_answer(&image, which, &other);
  ck_that(a == b, "%s %s", a ? other.diag.message : one.diag.message,
          a ? "the second time" : "the first time");
  return a;
}

/* By how much control points of segment j of `other` are not those of segment
 * k of `one`, moved; relative to their control polygon. */
static double segments_apart(const struct motion *m, size_t k, size_t j) {
  const struct ph_curve *a = &one.result.curve, *b = &other.result.curve;
  double away = 0;
  for (size_t i = 0; i < 6; i++) {
    ph_vec3 wanted = moved(m, spatial_point(a, k, i));
    size_t at = m->reverse ? 5 - i : i;
    away = unit_larger(away, unit_apart(wanted, spatial_point(b, j, at)));
  }
  return away / spatial_segment_size(b, j);
}

/* Segment j of `other` is segment k of `one`, moved. */
static void ck_segment(const struct motion *m, size_t k, size_t j, double tol) {
  const struct ph_curve *a = &one.result.curve, *b = &other.result.curve;
  double away = segments_apart(m, k, j);
  ck_that(away <= tol, "segment %zu is %.3g away", k, away);
  ck_that(unit_near_rel(a->lengths[k] * m->scale, b->lengths[j], tol),
          "segment %zu: lengths %.17g, %.17g", k, a->lengths[k], b->lengths[j]);
  ck_that(unit_near_rel(a->choice.tension[k], b->choice.tension[j], tol),
          "segment %zu: tension %.17g, %.17g", k, a->choice.tension[k],
          b->choice.tension[j]);
  ck_that(a->choice.shape_ok[k] == b->choice.shape_ok[j],
          "segment %zu: its shape is kept once", k);
}

/* ---- the criterion CC to 1e-14 --------------------------------------- */

/* One segment from the origin: a motion rounds the data only by themselves. */
static void one_segment(struct unit_random *r) {
  struct ph_spatial_data segment = unit_random_spatial(r);
  spatial_points(r, SPATIAL_RANDOM, 2, false, &data);
  data.point[0] = ph_vec3_of(0, 0, 0);
  data.point[1] = segment.dp;
  data.vector[0] = ph_vec3_scale(segment.ni, segment.ti);
  data.vector[1] = ph_vec3_scale(segment.nf, segment.tf);
  data.given = unit_random_below(r, 2) ? SPATIAL_TANGENTS : SPATIAL_DERIVATIVES;
  data.criterion = "cc";
  data.shape = "false";
  data.atph = unit_random_below(r, 3) == 0;
  data.alpha[0] = unit_random_in(r, 0.01, 2.5);
}

/* CC jumps where ti = tf, and where D is opposite to A0 + A2 in its plane; the
 * direction of its angle b, and d, may be of vectors that vanish.  As near to
 * that as this, errors of the data grow more than tenfold. */
static const double NEAR = 0.1;

/* Whether the segment of one_segment is far from where CC jumps. */
static bool is_steady(void) {
  const struct ph_curve *curve = &one.result.curve;
  ph_vec3 ti = ph_vec3_unit(data.vector[0]), tf = ph_vec3_unit(data.vector[1]);
  ph_vec3 dp = data.point[1], plus = ph_vec3_add(ti, tf), di, df, w;
  double c = 0.5 * ph_vec3_abs(plus), s = 0.5 * unit_apart(ti, tf), x, y;
  struct ph_atph space = ph_atph_of(data.atph ? data.alpha[0] : 0);
  double per_u = data.atph ? data.alpha[0] : 1, size;
  ph_quat a[3], q, d;
  for (size_t i = 0; i < 3; i++) {
    const double *v = curve->preimage.v + 4 * i;
    a[i] = ph_quat_scale(sqrt(per_u), ph_quat_of(v[0], v[1], v[2], v[3]));
  }
  di = ph_quat_i(a[0], a[0]);
  df = ph_quat_i(a[2], a[2]);
  w = ph_vec3_sub(ph_vec3_scale(3, dp), ph_vec3_add(di, df));
  x = s * ph_vec3_dot(w, plus) / (2 * c);
  y = 3 * ph_vec3_triple(ti, dp, tf) / (2 * c * s);
  size = 3 + ph_vec3_abs(di) + ph_vec3_abs(df);
  q = ph_quat_add(a[0], a[2]);
  d = ph_quat_add(ph_quat_scale(space.q[2], a[1]),
                  ph_quat_scale(0.5 * space.q[1], q));
  return c > NEAR && s > NEAR && hypot(x, y) > NEAR * size &&
         ph_quat_dot(d, q) > NEAR * ph_quat_abs(d) * ph_quat_abs(q) &&
         ph_quat_abs(d) > NEAR * space.q[2] * ph_quat_abs(q);
}

static void scale(struct unit_random *r, struct motion *m) {
  m->scale = pow(10, unit_random_in(r, -9, 9));
}

static void power_of_ten(struct unit_random *r, struct motion *m) {
  m->scale = pow(10, (double)unit_random_below(r, 19) - 9);
}

static void power_of_four(struct unit_random *r, struct motion *m) {
  m->scale = ldexp(1, 2 * ((int)unit_random_below(r, 401) - 200));
}

static void reverse(struct unit_random *r, struct motion *m) {
  (void)r;
  m->reverse = true;
}

static const struct {
  const char *name;
  void (*choose)(struct unit_random *, struct motion *);
} steady[] = {{"turned", turn},
              {"scaled", scale},
              {"mirrored", mirror},
              {"reversed", reverse}};

/* Data and image of many segments. */
PH_TEST_EACH(test_cc, COUNT(steady)) {
  struct unit_random r = unit_random_of(3 + (uint64_t)_i);
  size_t compared = 0, n = unit_cases(4000);
  for (size_t i = 0; i < n; i++) {
    struct motion m = REST;
    one_segment(&r);
    steady[_i].choose(&r, &m);
    move_data(&m);
    if (solve_both(i) && is_steady()) {
      compared++;
      ck_segment(&m, 0, 0, 1e-14);
    }
  }
  ck_assert_msg((double)compared >= 0.9 * (double)n,
                "PH_SEED=%lu, %s: only %zu segments were compared", unit_seed(),
                steady[_i].name, compared);
}

/* ---- any problem ----------------------------------------------------- */

/* Families without parallel tangents, with points as good as their chords. */
static const enum spatial_family regular[] = {
    SPATIAL_RANDOM, SPATIAL_WALK, SPATIAL_HELIX, SPATIAL_FAST, SPATIAL_SLOW};
enum { REGULAR_N = COUNT(regular) };
/* A regular family, its fields, and a criterion that is invariant there: the
 * axis x is not turned; BV chooses a side by itself where a plane curve is not
 * the best, and loses digits where derivatives are far longer than chords.  End
 * segments of points alone and those of a triangle are symmetrical, and may
 * have two solutions that are mirror images of each other.  The tension where a
 * shape begins to be kept is one that rounding may miss, and find another:
 * where the sign of a torsion changes by touching 0. */
static void invariant(struct unit_random *r, struct spatial_data *d) {
  spatial_of(r, regular[unit_random_below(r, REGULAR_N)], 6, d);
  d->axis = unit_random_below(r, 2) ? "chord" : "bisector";
  if (d->given == SPATIAL_POINTS && (!d->closed || d->n == 3)) {
    d->given = SPATIAL_TANGENTS;
  }
  if (spatial_is_chosen(d, "bv") &&
      (d->given == SPATIAL_POINTS || d->family == SPATIAL_FAST)) {
    d->criterion = "cc";
  }
  if (!spatial_is_chosen(d, "cc") || d->family == SPATIAL_FAST) {
    d->shape = "false";
  }
}

/* What two solutions of one problem may differ by, for whatever criterion:
 * 6e-13 in 100000 problems. */
#define SAME 1e-10

/* Every segment of `other` is that of `one`, moved. */
static void ck_moved(const struct motion *m, double tol) {
  size_t n = one.result.curve.n;
  for (size_t k = 0; k < n; k++) {
    ck_segment(m, segment_from(m, k), k, tol);
  }
}

static const struct {
  const char *name;
  void (*choose)(struct unit_random *, struct motion *);
  uint64_t stream;
  double tol;
} changes[] = {
    /* a power of four has a root: not a digit differs, of no family */
    {"scaled by a power of four", power_of_four, 7, 0},
    {"scaled by a power of ten", power_of_ten, 8, SAME},
    {"turned", turn, 9, SAME},
    {"mirrored", mirror, 10, SAME},
    {"reversed", reverse, 12, SAME}};

PH_TEST_EACH(test_motion, COUNT(changes)) {
  struct unit_random r = unit_random_of(changes[_i].stream);
  for (size_t i = 0; i < unit_cases(600); i++) {
    struct motion m = REST;
    if (changes[_i].tol > 0) {
      invariant(&r, &data);
    } else {
      spatial_any(&r, 6, &data);
    }
    changes[_i].choose(&r, &m);
    move_data(&m);
    if (solve_both(i)) {
      ck_moved(&m, changes[_i].tol);
    }
  }
}

/* ---- the fairest ------------------------------------------------------ */

/* A problem whose members are looked for, for some time. */
static void fairest(struct unit_random *r, enum spatial_family family) {
  static const char *const criteria[] = {"F1", "F2", "F3"};
  spatial_of(r, family, 4, &data);
  data.criterion = criteria[unit_random_below(r, COUNT(criteria))];
  data.has_angles = false;
  data.shape = "true";
}

/* Scaled by any power of two, not a digit differs, of no family and however
 * long the search was. */
PH_TEST(test_fairest_power_of_two) {
  struct unit_random r = unit_random_of(15);
  for (size_t i = 0; i < unit_cases(40); i++) {
    struct motion m = REST;
    fairest(&r, (enum spatial_family)unit_random_below(&r, SPATIAL_FAMILY_N));
    m.scale = ldexp(1, (int)unit_random_below(&r, 61) - 30);
    move_data(&m);
    if (solve_both(i)) {
      ck_moved(&m, 0);
    }
  }
}

/* By another number, the search goes the same way nearly always: what it does
 * depends on few digits of the data.  With derivatives, a torsion at an end
 * that decides may be rounding for many tensions. */
PH_TEST(test_fairest_scaled) {
  struct unit_random r = unit_random_of(16);
  size_t n = 0, differ = 0;
  for (size_t i = 0; i < unit_cases(40); i++) {
    struct motion m = REST;
    do {
      fairest(&r, regular[unit_random_below(&r, REGULAR_N)]);
    } while (data.given == SPATIAL_DERIVATIVES);
    scale(&r, &m);
    move_data(&m);
    if (!solve_both(i)) {
      continue;
    }
    for (size_t k = 0; k < one.result.curve.n; k++) {
      n++;
      differ += !(segments_apart(&m, k, k) <= SAME);
    }
  }
  ck_assert_msg(50 * differ <= n, "PH_SEED=%lu: %zu of %zu segments differ",
                unit_seed(), differ, n);
}

/* Points of 20 binary digits after the point, moved by as many before it: the
 * chords do not change, and so do lengths and tensions; control points are
 * rounded elsewhere. */
PH_TEST(test_translate) {
  struct unit_random r = unit_random_of(11);
  for (size_t i = 0; i < unit_cases(600); i++) {
    struct motion m = REST;
    const double unit = 0x1p-20, far = 0x1p20;
    spatial_of(&r, SPATIAL_RANDOM, 6, &data);
    for (size_t k = 0; k < data.n; k++) {
      ph_vec3 p = ph_vec3_scale(1 / unit, data.point[k]);
      p = ph_vec3_of(round(p.x), round(p.y), round(p.z));
      data.point[k] = ph_vec3_scale(unit, p);
    }
    data.has_knots = false;
    m.shift = ph_vec3_of(round(unit_random_in(&r, -far, far)),
                         round(unit_random_in(&r, -far, far)),
                         round(unit_random_in(&r, -far, far)));
    move_data(&m);
    for (size_t k = 0; solve_both(i) && k < one.result.curve.n; k++) {
      const struct ph_curve *a = &one.result.curve, *b = &other.result.curve;
      double away = segments_apart(&m, k, k) *
                    spatial_segment_size(&other.result.curve, k);
      ck_that(away <= 2 * spatial_rounding(b, k), "segment %zu is %.3g away", k,
              away);
      ck_that(unit_same(a->lengths[k], b->lengths[k]) &&
                  unit_same(a->choice.tension[k], b->choice.tension[k]),
              "segment %zu: lengths %.17g, %.17g", k, a->lengths[k],
              b->lengths[k]);
    }
  }
}

/* A closed curve that begins at another of its points: not a digit differs. */
PH_TEST(test_other_start) {
  struct unit_random r = unit_random_of(13);
  for (size_t i = 0; i < unit_cases(600); i++) {
    size_t first;
    do {
      spatial_any(&r, 8, &data);
    } while (!data.closed || data.family == SPATIAL_REVERSED);
    data.has_knots = false;
    image = data;
    first = 1 + unit_random_below(&r, data.n - 1);
    for (size_t k = 0; k < data.n; k++) {
      size_t from = (first + k) % data.n;
      image.point[k] = data.point[from];
      image.vector[k] = data.vector[from];
      image.alpha[k] = data.alpha[from];
      image.tension[k] = data.tension[from];
      image.angles[2 * k] = data.angles[2 * from];
      image.angles[2 * k + 1] = data.angles[2 * from + 1];
    }
    if (solve_both(i)) {
      for (size_t k = 0; k < data.n; k++) {
        ck_segment(&REST, (first + k) % data.n, k, 0);
      }
    }
  }
}

/* Whether segment k has point j, or a tangent that was found from it. */
static bool depends_on(const struct spatial_data *d, size_t k, size_t j) {
  size_t reach = d->given == SPATIAL_POINTS ? 1 : 0;
  size_t from = (j + d->n - 1 - reach) % d->n;
  size_t after = (k + d->n - from) % d->n;
  return after <= 1 + 2 * reach;
}

/* Whether segment k may depend on all data: plane ones, near to a line where
 * its own directions do not tell the plane. */
static bool is_near_line(const struct ph_curve *c, size_t k) {
  ph_vec3 from = spatial_point(c, k, 0), to = spatial_point(c, k, 5);
  ph_vec3 chord = ph_vec3_unit(ph_vec3_sub(to, from));
  ph_vec3 ti = ph_vec3_unit(ph_vec3_sub(spatial_point(c, k, 1), from));
  ph_vec3 tf = ph_vec3_unit(ph_vec3_sub(to, spatial_point(c, k, 4)));
  return (data.family == SPATIAL_FLAT || data.family == SPATIAL_TILTED ||
          data.family == SPATIAL_STRAIGHT || data.n < 4) &&
         ph_vec3_abs(ph_vec3_cross(ti, chord)) < 0.1 &&
         ph_vec3_abs(ph_vec3_cross(chord, tf)) < 0.1 &&
         ph_vec3_abs(ph_vec3_cross(ti, tf)) < 0.1;
}

/* Where a point and its vector change, the curve changes nearby: of all other
 * segments not a digit. */
PH_TEST(test_neighbours) {
  struct unit_random r = unit_random_of(14);
  size_t compared = 0;
  for (size_t i = 0; i < unit_cases(600); i++) {
    size_t j;
    do {
      spatial_any(&r, 12, &data);
    } while (data.family == SPATIAL_REVERSED);
    image = data;
    j = unit_random_below(&r, data.n);
    image.point[j] = ph_vec3_add(data.point[j], unit_random_direction(&r));
    image.vector[j] =
        ph_vec3_scale(ph_vec3_abs(data.vector[j]), unit_random_direction(&r));
    if (spatial_solve(&data, i, &one) != PH_OK ||
        spatial_solve(&image, i, &other) != PH_OK) {
      continue;
    }
    for (size_t k = 0; k < one.result.curve.n; k++) {
      if (!depends_on(&data, k, j) && !is_near_line(&one.result.curve, k)) {
        compared++;
        ck_segment(&REST, k, k, 0);
      }
    }
  }
  ck_assert_uint_ge(compared, unit_cases(600));
}

PH_FIXTURE(NULL, finish)
