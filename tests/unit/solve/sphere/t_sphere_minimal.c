/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The smallest tensions: against a plain search that knows nothing of linear
 * programs, on small data; that the shape is kept, whatever the blocks are;
 * what data that are moved, mirrored or read backwards have.
 */
#include "sphere_unit.h"
#include "unit.h"

#include "kernel/pi.h"

enum { MOST = 60, SMALL = 8 };

/* Against a search: the worst ratio, beside tensions that hardly do anything.
 */
static const double WORST = 1.2, WEAK = 0.2;

static const struct unit_raise_kind open_kind = {false, PH_SPHERE_NATURAL,
                                                 &ph_sphere_exact, 0.01, false};
static const struct unit_raise_kind closed_kind = {
    true, PH_SPHERE_NATURAL, &ph_sphere_exact, 0.01, false};
/* ---- a plain search ------------------------------------------------------ */
/* Whether the spline with these tensions has the shape; if not, it is as it
 * was. */
static bool try(struct unit_raise *t, const double *nu) {
  struct ph_sphere_spline *s = &t->u.spline;
  struct ph_sphere_range all = ph_sphere_all(&t->u.data);
  size_t n = t->u.data.n, from = 0, at;
  double kept[SMALL];
  ph_vec3 x[SMALL];
  memcpy(kept, s->nu, n * sizeof *kept);
  memcpy(x, s->x, n * sizeof *x);
  memcpy(s->nu, nu, n * sizeof *nu);
  if (ph_sphere_newton(s, all, &t->u.work) &&
      ph_sphere_violated(&t->raise, all, &from, &at) == PH_SPHERE_FINE) {
    return true;
  }
  memcpy(s->nu, kept, n * sizeof *kept);
  memcpy(s->x, x, n * sizeof *x);
  return false;
}

/* Each tension by itself, as far down as halving finds it to go. */
static void lower_each(struct unit_raise *t) {
  double *nu = t->u.spline.nu, next[SMALL];
  for (size_t i = 0; i < t->u.data.n; i++) {
    double good = nu[i], bad = 0;
    memcpy(next, nu, t->u.data.n * sizeof *next);
    next[i] = 0;
    if (good > 0 && !try(t, next)) {
      for (int step = 0; step < 10; step++) {
        next[i] = (good + bad) / 2;
        *(try(t, next) ? &good : &bad) = next[i];
      }
    }
  }
}

/* One tension lower, another one higher by less. */
static void trade(struct unit_raise *t, struct unit_random *r, double size) {
  size_t n = t->u.data.n;
  size_t i = unit_random_below(r, n), j = unit_random_below(r, n);
  double next[SMALL], fall;
  memcpy(next, t->u.spline.nu, n * sizeof *next);
  fall = unit_random_in(r, 0, size) * next[i];
  next[i] -= fall;
  fall *= next[j] > 0; /* only what was raised */
  next[j] += i == j ? 0 : unit_random_in(r, 0, 0.95) * fall;
  if (fall > 0) {
    try(t, next);
  }
}

static double search(struct unit_raise *t, struct unit_random *r) {
  for (int sweep = 0; sweep < 4; sweep++) {
    lower_each(t);
    for (int k = 0; k < 60; k++) {
      trade(t, r, sweep < 2 ? 0.5 : 0.05);
    }
  }
  return unit_raise_sum(t);
}

/* Small data of all kinds. */
static struct unit_raise_kind small(struct unit_random *r, int t, size_t *n,
                                    ph_vec3 *p) {
  struct unit_raise_kind kind = t % 4 == 3 ? closed_kind : open_kind;
  *n = 5 + unit_random_below(r, 4);
  if (t % 2 == 0) {
    unit_raise_corners(r, *n, p);
  } else {
    unit_sphere_path(r, *n, 0.2, 0.9, p);
  }
  return kind;
}

/* From the tensions as they are raised by the doubling rule, and from those
 * that are to be the smallest. */
static double search_both(const ph_vec3 *p, size_t n,
                          const struct unit_raise_kind *kind,
                          struct unit_raise *t, struct unit_random *r) {
  struct unit_raise other;
  double a, b;
  unit_raise_of(&other, n, p, kind);
  other.raise.increase = PH_SPHERE_TIMES;
  other.raise.by = 2;
  ck_assert_int_eq(unit_raise_go(&other), PH_OK);
  a = search(&other, r);
  unit_raise_free(&other);
  b = search(t, r);
  return a < b ? a : b;
}

/* Minima are local, and a block stops early where its boxes become small: most
 * sums are as small as those found, and the others not far above. */
PH_TEST(test_search) {
  struct unit_random r = {791};
  int raised = 0, small_enough = 0;
  for (int k = 0; k < unit_count(60); k++) {
    struct unit_raise t;
    ph_vec3 p[SMALL];
    size_t n;
    struct unit_raise_kind kind = small(&r, k, &n, p);
    unit_raise_of(&t, n, p, &kind);
    if (!unit_raise_holds(&t)) {
      double sum, found;
      ck_assert_int_eq(unit_raise_go(&t), PH_OK);
      ck_assert(unit_raise_holds(&t));
      sum = unit_raise_sum(&t);
      found = search_both(p, n, &kind, &t, &r);
      ck_assert_msg(sum <= WORST * found + WEAK, "data %d: %.8g, found %.8g", k,
                    sum, found);
      small_enough += sum <= 1.02 * found;
      raised++;
    }
    unit_raise_free(&t);
  }
  ck_assert_int_ge(raised, unit_count(20));
  ck_assert_msg(small_enough + 1 >= 0.85 * raised, "%d of %d", small_enough,
                raised);
}

/* ---- other data of the same shape ---------------------------------------- */

/* The points turned about an axis (and mirrored), begun elsewhere or read
 * backwards. */
enum motion { TURN, MIRROR, REVERSE, ROLL, MOTIONS };

static void move(enum motion motion, size_t n, const ph_vec3 *p, ph_vec3 *q) {
  for (size_t i = 0; i < n; i++) {
    size_t from = motion == REVERSE ? n - 1 - i
                  : motion == ROLL  ? (i + n / 3) % n
                                    : i;
    ph_vec3 v = p[from];
    if (motion == TURN) {
      v = ph_vec3_of(0.6 * v.x - 0.8 * v.y, 0.8 * v.x + 0.6 * v.y, v.z);
      v = ph_vec3_of(v.x, 0.28 * v.y - 0.96 * v.z, 0.96 * v.y + 0.28 * v.z);
    }
    q[i] = motion == MIRROR ? ph_vec3_of(v.x, v.y, -v.z) : v;
  }
}

static double minimum(const ph_vec3 *p, size_t n,
                      const struct unit_raise_kind *kind) {
  struct unit_raise t;
  double sum;
  unit_raise_of(&t, n, p, kind);
  ck_assert_int_eq(unit_raise_go(&t), PH_OK);
  ck_assert(unit_raise_holds(&t));
  ck_abs(unit_raise_missing(&t.u), 0, 1e-12);
  sum = unit_raise_sum(&t);
  unit_raise_free(&t);
  return sum;
}

static void ck_motions(const ph_vec3 *p, size_t n,
                       const struct unit_raise_kind *kind, int k) {
  double sum = minimum(p, n, kind);
  int motions = kind->closed ? MOTIONS : ROLL;
  for (int motion = 0; motion < motions; motion++) {
    ph_vec3 q[MOST];
    double other;
    move((enum motion)motion, n, p, q);
    other = minimum(q, n, kind);
    ck_assert_msg(unit_near_rel(sum, other, 1e-2),
                  "data %d, motion %d: %.8g, moved %.8g", k, motion, sum,
                  other);
  }
}

/* A block stops where a step gains less than 5e-4 of its sum, of which there
 * may be some before it: rounding decides where. */
PH_TEST(test_motions) {
  struct unit_random r = {792};
  for (int k = 0; k < unit_count(40); k++) {
    ph_vec3 p[MOST];
    size_t n = 12 + unit_random_below(&r, 14);
    struct unit_raise_kind kind = k % 4 == 2 ? closed_kind : open_kind;
    if (k % 4 == 0) {
      unit_raise_corners(&r, n, p);
    } else if (k % 4 == 1) {
      unit_sphere_path(&r, n, 0.2, 0.9, p);
    } else {
      unit_raise_ring(&r, n, 0.06, kind.closed, p);
    }
    ck_motions(p, n, &kind, k);
  }
}

/* ---- long runs ----------------------------------------------------------- */

/* The most raised nodes of which each is within 9 places of the next. */
static size_t longest_run(const struct unit_raise *t) {
  size_t longest = 0, run = 0, last = 0;
  for (size_t i = 0; i < t->u.data.n; i++) {
    if (t->u.spline.nu[i] > 0) {
      run = i - last <= 9 ? run + 1 : 1;
      last = i;
      longest = run > longest ? run : longest;
    }
  }
  return longest;
}

/* Runs of raised nodes, of which blocks are cut: most are longer than one of
 * 12 in the end, too, and so all the more at first. */
PH_TEST(test_blocks) {
  struct unit_random r = {793};
  int longer = 0;
  for (int k = 0; k < unit_count(10); k++) {
    struct unit_raise t, grown;
    ph_vec3 p[MOST];
    unit_raise_corners(&r, MOST, p);
    unit_raise_of(&t, MOST, p, &open_kind);
    unit_raise_of(&grown, MOST, p, &open_kind);
    grown.raise.increase = PH_SPHERE_TIMES;
    grown.raise.by = 2;
    ck_assert_int_eq(unit_raise_go(&t), PH_OK);
    ck_assert_int_eq(unit_raise_go(&grown), PH_OK);
    ck_assert(unit_raise_holds(&t));
    ck_abs(unit_raise_missing(&t.u), 0, 1e-12);
    ck_assert(unit_raise_sum(&t) < 0.8 * unit_raise_sum(&grown));
    longer += longest_run(&t) > 12;
    unit_raise_free(&t);
    unit_raise_free(&grown);
  }
  ck_assert_int_gt(2 * longer, unit_count(10)); /* 9 of 10 */
}

/* Of these data the blocks are judged to have the shape, and the whole does not
 * have it: most of the way back has to be gone. */
PH_TEST(test_back) {
  enum { NODES = 40, WHICH = 38 };
  struct unit_random r = {862};
  struct unit_raise t;
  ph_vec3 p[NODES];
  for (int k = 0; k <= WHICH; k++) {
    unit_raise_corners(&r, NODES, p);
  }
  unit_raise_of(&t, NODES, p, &open_kind);
  ck_assert_int_eq(unit_raise_go(&t), PH_OK);
  ck_assert(unit_raise_holds(&t));
  unit_raise_free(&t);
}

/* Tensions that are given are not lowered, and those of others do not matter.
 */
PH_TEST(test_given) {
  struct unit_random r = {794};
  size_t kept = 0, above = 0;
  for (int k = 0; k < unit_count(20); k++) {
    struct unit_raise t;
    ph_vec3 p[12];
    unit_raise_corners(&r, 12, p);
    unit_raise_of(&t, 12, p, &open_kind);
    for (size_t i = 0; i < 12; i++) {
      t.u.data.nu[i] = t.u.spline.nu[i] = unit_random_in(&r, 0, 300);
    }
    ck_assert(ph_sphere_solve(&t.u.spline, &t.u.work));
    ck_assert_int_eq(unit_raise_go(&t), PH_OK);
    ck_assert(unit_raise_holds(&t));
    for (size_t i = 0; i < 12; i++) {
      double given = t.u.data.nu[i];
      ck_assert(t.u.spline.nu[i] >= given);
      *(t.u.spline.nu[i] > given ? &above : &kept) += 1;
    }
    unit_raise_free(&t);
  }
  ck_assert_uint_ge(kept, 1);
  ck_assert_uint_ge(above, 1);
}
