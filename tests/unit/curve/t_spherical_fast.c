/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The fast jet of spherical Bezier segments, against digits and the slow one.
 */
#include "unit.h"
#include "spherical_known_unit.h"

#include "curve/segment/spherical_fast.h"
#include "kernel/degree.h"
#include "kernel/s2.h"

/* What an eps of control points becomes near antipodes of each other. */
static double rounding(const struct ph_spherical *s) {
  double cosine = 1;
  for (size_t i = 0; i < 3; i++) {
    ph_vec3 m = ph_vec3_scale(0.5, ph_vec3_add(s->p[i], s->p[i + 1]));
    cosine = fmin(cosine, ph_vec3_abs(m));
  }
  return 8 * DBL_EPSILON / (cosine * cosine);
}

PH_TEST_EACH(test_known, KNOWN) {
  struct ph_spherical_fast fast;
  struct ph_spherical s;
  ph_vec3 jet[3];
  double scale = 1;
  unit_case("%s", known[_i].name);
  for (size_t i = 0; i < 4; i++) {
    s.p[i] = ph_vec3_unit(ph_vec3_get(known[_i].p[i], 3));
  }
  ph_spherical_fast_of(&s, &fast);
  ph_spherical_fast_jet(&fast, known[_i].t, jet);
  for (size_t n = 0; n < 3; n++) {
    ph_vec3 wanted = ph_vec3_get(known[_i].jet[n], 3);
    scale += ph_vec3_abs(wanted);
    ck_vec3(jet[n], wanted, rounding(&s) * scale);
  }
}

static struct ph_spherical random_segment(struct unit_random *r, double angle) {
  struct ph_spherical s;
  ph_vec3 at = ph_degree_to_unit(unit_random_in(r, -180, 180),
                                 unit_random_in(r, -80, 80));
  for (size_t i = 0; i < 4; i++) {
    double by = angle * unit_random_in(r, 0.2, 1);
    ph_vec3 way = ph_degree_to_unit(unit_random_in(r, -180, 180),
                                    unit_random_in(r, -90, 90));
    s.p[i] = at;
    way = ph_vec3_unit(ph_vec3_normal(way, at));
    at = ph_vec3_unit(ph_s2_exp(at, ph_vec3_scale(by, way)));
  }
  return s;
}

/* As ph_spherical_jet, relative to the size of the segment: near and far, and
 * on either side of where one way of E takes over from the other. */
PH_TEST(test_random) {
  const double angles[] = {1e-9, 1e-5, 1e-3, 0.02, 0.06, 0.12, 0.25, 0.35,
                           0.5,  0.7,  0.73, 0.8,  1,    1.5,  2,    2.8};
  struct unit_random r = unit_random_of(1340);
  for (int i = 0; i < unit_count(1600); i++) {
    double angle = angles[(size_t)i % (COUNT(angles))];
    struct ph_spherical s = random_segment(&r, angle);
    struct ph_spherical_fast fast;
    double eps = 4 * rounding(&s);
    ph_spherical_fast_of(&s, &fast);
    for (size_t j = 0; j <= 16; j++) {
      double t = (double)j / 16;
      ph_vec3 jet[3], slow[4];
      ph_spherical_fast_jet(&fast, t, jet);
      ph_spherical_jet(&s, t, slow);
      ck_vec3(jet[0], slow[0], eps);
      ck_vec3(jet[1], slow[1], eps * (angle + ph_vec3_abs(slow[1])));
      ck_vec3(jet[2], slow[2], eps * (angle + ph_vec3_abs(slow[2])));
    }
  }
}

/* Several at once are as one after the other, to the last bit: on one side of
 * the middle and on both, near and far. */
PH_TEST(test_each) {
  enum { LANES = PH_SPHERICAL_FAST_LANES };
  struct unit_random r = unit_random_of(1342);
  for (int i = 0; i < unit_count(2000); i++) {
    double angle = pow(10, unit_random_in(&r, -6, 0.3)), t[LANES];
    struct ph_spherical s = random_segment(&r, angle);
    struct ph_spherical_fast fast;
    ph_vec3 each[LANES][3], one[LANES][3];
    ph_spherical_fast_of(&s, &fast);
    for (size_t k = 0; k < LANES; k++) {
      t[k] = unit_random_in(&r, 0, 1);
      ph_spherical_fast_jet(&fast, t[k], one[k]);
    }
    ph_spherical_fast_jets(&fast, t, each);
    ck_assert_mem_eq(each, one, sizeof one);
  }
}

/* Next to an end at rest S' is right relative to itself: S' = t S''(0) but for
 * terms of higher order, and exactly 0 there. */
PH_TEST(test_rest) {
  struct unit_random r = unit_random_of(1341);
  for (int i = 0; i < unit_count(100); i++) {
    double angle = pow(10, unit_random_in(&r, -6, 0.3));
    struct ph_spherical s = random_segment(&r, angle);
    struct ph_spherical_fast fast;
    ph_vec3 jet[3], end[3];
    double other = i % 2 ? 1 : 0, to = i % 2 ? -1 : 1;
    s.p[i % 2 ? 2 : 1] = s.p[i % 2 ? 3 : 0];
    ph_spherical_fast_of(&s, &fast);
    ph_spherical_fast_jet(&fast, other, end);
    ck_abs(ph_vec3_abs(end[1]), 0, 0);
    for (double t = 0x1p-20; t > 0x1p-50; t /= 2) {
      ph_vec3 slope = ph_vec3_scale(to * t, end[2]);
      ph_spherical_fast_jet(&fast, other + to * t, jet);
      ck_vec3(jet[1], slope, (100 * t + 64 * DBL_EPSILON) * angle * t);
    }
  }
}
