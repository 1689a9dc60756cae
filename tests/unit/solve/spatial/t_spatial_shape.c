/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The shape of spatial segments: constraints against sampled torsion and
 * control polygons, tensions against published data and by their definition.
 */
#include "segment_unit.h"
#include "solve/spatial/spatial.h"

#include "curve/segment/seg3.h"
#include "unit.h"

enum { SEGMENTS = 300 };

static const ph_vec3 ORIGIN = {0, 0, 0};

static ph_vec3 random_unit_vec3(struct unit_random *r) {
  double z = unit_random_in(r, -1, 1), angle = unit_random_in(r, -4, 4);
  double s = sqrt(1 - z * z);
  return ph_vec3_of(s * cos(angle), s * sin(angle), z);
}

/* Tangents about as far from dp as `spread` is large. */
static struct ph_spatial_data random_data(struct unit_random *r,
                                          double spread) {
  struct ph_spatial_data data;
  ph_vec3 dp = random_unit_vec3(r);
  data.ti = ph_vec3_unit(ph_vec3_along(dp, spread, random_unit_vec3(r)));
  data.tf = ph_vec3_unit(ph_vec3_along(dp, spread, random_unit_vec3(r)));
  data.dp = ph_vec3_scale(unit_random_in(r, 0.7, 1.4), dp);
  data.ni = unit_random_in(r, 0.5, 1.5);
  data.nf = unit_random_in(r, 0.5, 1.5);
  data.noise = 0;
  data.planarity = 0;
  data.normal = ph_vec3_of(0, 0, 0);
  return data;
}

static struct ph_atph random_space(struct unit_random *r) {
  return ph_atph_of(unit_random_below(r, 2) ? unit_random_in(r, 1e-3, 2.5) : 0);
}

static struct ph_spatial_member random_member(struct unit_random *r) {
  struct ph_spatial_member member = {ph_cplx_polar(unit_random_in(r, -4, 4)),
                                     ph_cplx_polar(unit_random_in(r, -4, 4))};
  return member;
}

static enum ph_status choose_cc(struct ph_spatial_fit *fit, void *context) {
  (void)context;
  fit->member = ph_spatial_cc(&fit->family);
  return PH_OK;
}

/* context: two angles about the chord. */
static enum ph_status choose_angles(struct ph_spatial_fit *fit, void *context) {
  return ph_spatial_member_of(&fit->family, context, PH_SPATIAL_CHORD,
                              &fit->member)
             ? PH_OK
             : PH_E_BAD_VALUE;
}

static struct ph_spatial_tension tension_cc(const struct ph_spatial_data *data,
                                            const struct ph_atph *space) {
  struct ph_spatial_tension tension;
  ck_assert_int_eq(
      ph_spatial_tension(data, space, choose_cc, NULL, 1e-13, &tension), PH_OK);
  return tension;
}

/* ---- constraints ---------------------------------------------------- */

/* N of (3) is torsion sigma^2 |z|^2. */
PH_TEST(test_torsion_form) {
  struct unit_random r = unit_random_of(530);
  for (size_t n = 0; n < SEGMENTS; n++) {
    struct ph_seg3 seg = {.space = random_space(&r)};
    double form[7], sinc = seg.space.sinc;
    for (size_t i = 0; i < 3; i++) {
      seg.a[i] =
          ph_quat_of(unit_random_in(&r, -1, 1), unit_random_in(&r, -1, 1),
                     unit_random_in(&r, -1, 1), unit_random_in(&r, -1, 1));
    }
    ph_spatial_torsion_form(&seg.space, seg.a, form);
    for (size_t i = 0; i <= 20; i++) {
      double s[2], value = 0, size = 0, u = (double)i / 20;
      struct unit_bend3 bend = unit_seg3_bend(&seg, u);
      double scale = bend.speed * bend.speed * ph_cplx_norm2(bend.z);
      ph_atph_basis(&seg.space, u, s);
      for (size_t k = 0; k < 7; k++) {
        double term = form[k] * pow(s[0], 6 - (double)k) * pow(s[1], (double)k);
        value += term;
        size += fabs(term);
      }
      ck_abs(4 * value / (sinc * sinc * sinc), bend.torsion * scale,
             1e-12 * (1 + size + scale));
    }
  }
}

/* What `sign` times the torsion is at least, of many u, and at most. */
static void torsion_range(const struct ph_spatial_family *f, const ph_quat a[3],
                          double sign, double range[2]) {
  enum { STEPS = 400 };
  struct ph_seg3 seg = {f->space, {a[0], a[1], a[2]}, ORIGIN, f->dp};
  range[0] = HUGE_VAL;
  range[1] = -HUGE_VAL;
  for (size_t i = 0; i <= STEPS; i++) {
    double torsion = sign * unit_seg3_bend(&seg, (double)i / STEPS).torsion;
    range[0] = fmin(range[0], torsion);
    range[1] = fmax(range[1], torsion);
  }
}

/* (1) by the control polygon, normalised: of the start, of the end. */
static void convexities(const struct ph_spatial_data *data,
                        const struct ph_spatial_family *f, const ph_quat a[3],
                        double convexity[2]) {
  ph_vec3 p[6], leg[5], ni = ph_vec3_cross(data->ti, data->dp);
  ph_vec3 nf = ph_vec3_cross(data->dp, data->tf);
  ph_seg3_control_points(&f->space, a, ORIGIN, f->dp, p);
  for (size_t k = 0; k < 5; k++) {
    ph_vec3 in_frame = ph_vec3_sub(p[k + 1], p[k]);
    leg[k] = ph_vec3_scale(in_frame.x, f->axis[0]);
    leg[k] = ph_vec3_along(leg[k], in_frame.y, f->axis[1]);
    leg[k] = ph_vec3_unit(ph_vec3_along(leg[k], in_frame.z, f->axis[2]));
  }
  convexity[0] = ph_vec3_triple(leg[0], leg[1], ni) / ph_vec3_abs(ni);
  convexity[1] = ph_vec3_triple(leg[3], leg[4], nf) / ph_vec3_abs(nf);
}

/* Violations of random members agree with what is seen in space, where that
 * leaves no doubt. */
PH_TEST(test_violations) {
  struct unit_random r = unit_random_of(531);
  int members = unit_count(SEGMENTS);
  size_t seen[3][2] = {{0}};
  for (int n = 0; n < members; n++) {
    struct ph_spatial_data data = random_data(&r, unit_random_in(&r, 0.3, 2));
    struct ph_atph space = random_space(&r);
    struct ph_spatial_family f = ph_spatial_family_of(&data, &space);
    double sign = ph_vec3_triple(data.ti, data.dp, data.tf) > 0 ? 1 : -1;
    double convexity[2], range[2];
    ph_quat a[3];
    unsigned violated;
    ph_spatial_preimage(&f, n % 3 ? ph_spatial_cc(&f) : random_member(&r), a);
    violated = ph_spatial_violations(&f, a);
    ck_assert_uint_eq(ph_spatial_constraints(&f),
                      PH_SHAPE_START | PH_SHAPE_END | PH_SHAPE_TORSION);
    convexities(&data, &f, a, convexity);
    for (size_t i = 0; i < 2; i++) {
      bool broken = violated & (i ? PH_SHAPE_END : PH_SHAPE_START);
      if (fabs(convexity[i]) > 1e-10) {
        ck_assert_int_eq(broken, convexity[i] < 0);
      }
      seen[i][broken]++;
    }
    torsion_range(&f, a, sign, range);
    if (range[0] < 0 || range[0] > 1e-3) {
      ck_assert_int_eq((violated & PH_SHAPE_TORSION) != 0, range[0] < 0);
    }
    seen[2][(violated & PH_SHAPE_TORSION) != 0]++;
  }
  for (size_t i = 0; i < 3; i++) {
    ck_assert_uint_ge(seen[i][0], (size_t)members / 10);
    ck_assert_uint_ge(seen[i][1], (size_t)members / 30);
  }
}

static struct ph_spatial_data data_of(ph_vec3 dp, ph_vec3 ti, ph_vec3 tf) {
  struct ph_spatial_data data = {
      dp, ph_vec3_unit(ti), ph_vec3_unit(tf), 1, 1, 0, 0, {0, 0, 0}};
  return data;
}

static unsigned constraints_of(ph_vec3 dp, ph_vec3 ti, ph_vec3 tf) {
  struct ph_spatial_data data = data_of(dp, ti, tf);
  struct ph_atph space = ph_atph_of(0);
  struct ph_spatial_family f = ph_spatial_family_of(&data, &space);
  return ph_spatial_constraints(&f);
}

/* Data that give no sign void a constraint. */
PH_TEST(test_void) {
  const ph_vec3 x = {1, 0, 0}, up = {1, 1, 0}, down = {1, -1, 0};
  const ph_vec3 out = {1, 0, 1}, back = {-1, 0, 0};
  const unsigned ends = PH_SHAPE_START | PH_SHAPE_END;
  ck_assert_uint_eq(constraints_of(x, up, down), ends | PH_SHAPE_PLANE);
  ck_assert_uint_eq(constraints_of(x, up, up), ends | PH_SHAPE_PLANE);
  ck_assert_uint_eq(constraints_of(x, up, out), ends | PH_SHAPE_TORSION);
  ck_assert_uint_eq(constraints_of(x, x, out), PH_SHAPE_END | PH_SHAPE_PLANE);
  ck_assert_uint_eq(constraints_of(x, out, x), PH_SHAPE_START | PH_SHAPE_PLANE);
  ck_assert_uint_eq(constraints_of(x, out, back),
                    PH_SHAPE_START | PH_SHAPE_PLANE);
  ck_assert_uint_eq(constraints_of(x, x, x), 0);
  ck_assert_uint_eq(constraints_of(x, x, back), 0);
}

/* CC keeps the convexity of plane arcs and s-shapes; straight data have nothing
 * to break; the loop of the same arc to the other side breaks an end. */
PH_TEST(test_planar) {
  struct unit_random r = unit_random_of(532);
  struct ph_atph space = ph_atph_of(0);
  for (size_t n = 0; n < SEGMENTS; n++) {
    double ai = unit_random_in(&r, 0.3, 0.6), af = unit_random_in(&r, 0.3, 0.6);
    ph_vec3 u = random_unit_vec3(&r), v = ph_vec3_any_normal(u);
    struct ph_spatial_data data = data_of(
        u, ph_vec3_along(u, ai, v), ph_vec3_along(u, n % 2 ? af : -af, v));
    struct ph_spatial_family f = ph_spatial_family_of(&data, &space);
    struct ph_spatial_member far = {{-1, 0}, {1, 0}};
    ph_quat a[3];
    ck_assert_uint_eq(ph_spatial_constraints(&f),
                      PH_SHAPE_START | PH_SHAPE_END | PH_SHAPE_PLANE);
    ph_spatial_preimage(&f, ph_spatial_cc(&f), a);
    ck_assert_uint_eq(ph_spatial_violations(&f, a), 0);
    if (n % 2 == 0) {
      ph_spatial_preimage(&f, far, a);
      ck_assert_uint_ne(ph_spatial_violations(&f, a), 0);
    }
    data = data_of(u, u, n % 2 ? u : ph_vec3_scale(-1, u));
    f = ph_spatial_family_of(&data, &space);
    ph_spatial_preimage(&f, random_member(&r), a);
    ck_assert_uint_eq(ph_spatial_violations(&f, a), 0);
  }
}

PH_TEST(test_predicates) {
  const ph_vec3 x = {1, 0, 0}, y = {0, 1, 0}, up = {1, 2, 0}, left = {-1, 1, 0};
  struct ph_spatial_data data = data_of(x, up, up);
  ck_assert(ph_spatial_is_forward(&data) && ph_spatial_is_acute(&data));
  data = data_of(y, x, left);
  ck_assert(ph_spatial_is_forward(&data) && !ph_spatial_is_acute(&data));
  data = data_of(x, left, left);
  ck_assert(!ph_spatial_is_forward(&data) && ph_spatial_is_acute(&data));
  data = data_of(x, y, y);
  ck_assert(!ph_spatial_is_forward(&data));
  data = data_of(x, x, y);
  ck_assert(!ph_spatial_is_acute(&data));
}

/* ---- tension -------------------------------------------------------- */

/* Example 3 of [FAR15, (62)]: Di and Df as long as the chord. */
static struct ph_spatial_data example3(double size) {
  struct ph_spatial_data data = {
      {1, 1, 1},
      {0.20385887657505022, -0.7644707871564382, -0.6115766297251506},
      {-2.0 / 3, -1.0 / 3, -2.0 / 3},
      size,
      size,
      0,
      0,
      {0, 0, 0}};
  return data;
}

/* CC breaks the torsion at the end, and is cured; alpha = beta = 0 is not.  The
 * largest tension and the lengths come from a computation with numpy, not from
 * the paper, which says that 5/6 will do. */
PH_TEST(test_example3) {
  struct ph_spatial_data data = example3(sqrt(3));
  struct ph_atph space = ph_atph_of(0);
  struct ph_spatial_tension tension = tension_cc(&data, &space);
  double zero[2] = {0, 0};
  const struct ph_spatial_fit *fit = &tension.fit;
  ck_assert_uint_eq(tension.without, PH_SHAPE_TORSION);
  ck_assert_uint_eq(fit->violated, 0);
  ck_abs(tension.factor, 0.9222810742768435, 1e-12);
  ck_rel(ph_spatial_length(&fit->family, fit->member.b), 2.6249875247094505,
         1e-12);
  ck_assert_int_eq(
      ph_spatial_tension(&data, &space, choose_angles, zero, 1e-13, &tension),
      PH_OK);
  ck_assert_uint_eq(tension.without, PH_SHAPE_TORSION);
  ck_assert_uint_eq(fit->violated, PH_SHAPE_TORSION);
  ck_rel(tension.factor, 1, 0);
  ck_rel(ph_spatial_length(&fit->family, fit->member.b), 2.68722511982886,
         1e-12);
  ck_assert(!ph_spatial_is_forward(&data));
  data = example3(1);
  tension = tension_cc(&data, &space);
  ck_assert_uint_eq(tension.without, 0);
  ck_rel(tension.factor, 1, 0);
  ck_assert_uint_eq(tension.tried, 1);
  ck_rel(ph_spatial_length(&fit->family, fit->member.b), 2.3361457326710435,
         1e-12);
}

/* An arc of a helix that is too long for alpha = beta = 0 (example 1 of
 * [FAR15]): of 3.016 rad. */
PH_TEST(test_example1) {
  struct ph_spatial_data data = {
      {-1.9921147013144777, 0.12533323356430454, 1.5079644737231006},
      {0, 0.8944271909999159, 0.4472135954999579},
      {-0.11210145203585728, -0.8873743654464288, 0.4472135954999579},
      3.3719110708995483,
      3.3719110708995483,
      0,
      0,
      {0, 0, 0}};
  struct ph_atph space = ph_atph_of(0);
  struct ph_spatial_tension tension;
  double zero[2] = {0, 0};
  ck_assert_int_eq(
      ph_spatial_tension(&data, &space, choose_angles, zero, 1e-13, &tension),
      PH_OK);
  ck_assert_uint_eq(tension.without, PH_SHAPE_TORSION);
  ck_assert_uint_eq(tension.fit.violated, PH_SHAPE_TORSION);
  ck_rel(ph_spatial_length(&tension.fit.family, tension.fit.member.b),
         3.234236277569787, 1e-12);
  tension = tension_cc(&data, &space);
  ck_assert_uint_eq(tension.without, 0);
}

/* What CC violates at a factor. */
static unsigned violated_at(const struct ph_spatial_data *data,
                            const struct ph_atph *space, double factor) {
  struct ph_spatial_data at = *data;
  struct ph_spatial_fit fit;
  at.ni *= factor * factor;
  at.nf *= factor * factor;
  ck_assert_int_eq(ph_spatial_fit_of(&at, space, choose_cc, NULL, &fit), PH_OK);
  return fit.violated;
}

/* Results are what their definition says; (52) and (59) are sufficient. */
PH_TEST(test_definition) {
  struct unit_random r = unit_random_of(533);
  int segments = unit_count(10 * SEGMENTS);
  size_t reduced = 0, hopeless = 0;
  for (int n = 0; n < segments; n++) {
    struct ph_spatial_data data = random_data(&r, unit_random_in(&r, 0.3, 3));
    struct ph_atph space = random_space(&r);
    struct ph_spatial_tension tension = tension_cc(&data, &space);
    double factor = tension.factor;
    const struct ph_spatial_fit *fit = &tension.fit;
    ck_assert_uint_eq(tension.without, violated_at(&data, &space, 1));
    ck_assert_uint_eq(fit->violated,
                      ph_spatial_violations(&fit->family, fit->a));
    ck_rel(fit->family.ni, factor * factor * data.ni, 1e-15);
    ck_rel(fit->family.nf, factor * factor * data.nf, 1e-15);
    ck_assert_uint_le(tension.tried, 1 + 81 + 40);
    if (!tension.without) {
      ck_rel(factor, 1, 0);
      ck_assert_uint_eq(tension.tried, 1);
    } else if (fit->violated) {
      hopeless++;
      ck_rel(factor, 1, 0);
      ck_assert_uint_eq(fit->violated, tension.without);
      ck_assert_uint_eq(tension.tried, 1 + 81);
      ck_assert(!(ph_spatial_is_forward(&data) && ph_spatial_is_acute(&data)));
    } else {
      reduced++;
      ck_assert(factor < 1 && factor > 1.0 / 64);
      ck_assert_uint_eq(violated_at(&data, &space, factor), 0);
      ck_assert_uint_ne(violated_at(&data, &space, factor + 3e-13), 0);
      for (double at = 1; at > factor; at *= 0.95) {
        ck_assert_uint_ne(violated_at(&data, &space, at), 0);
      }
    }
  }
  ck_assert_uint_ge(reduced, (size_t)segments / 20);
  ck_assert_uint_ge(hopeless, (size_t)segments / 300);
}

static struct ph_spatial_data turned(const struct ph_spatial_data *data,
                                     ph_quat q) {
  struct ph_spatial_data image = *data;
  ph_vec3 *v[3] = {&image.dp, &image.ti, &image.tf};
  for (size_t i = 0; i < 3; i++) {
    ph_quat x = ph_quat_mul(q, ph_quat_pure(*v[i]));
    *v[i] = ph_quat_vector(ph_quat_mul(x, ph_quat_conj(q)));
  }
  return image;
}

static struct ph_spatial_data mirrored(const struct ph_spatial_data *data) {
  struct ph_spatial_data image = *data;
  image.dp.x = -image.dp.x;
  image.ti.x = -image.ti.x;
  image.tf.x = -image.tf.x;
  return image;
}

static struct ph_spatial_data reversed(const struct ph_spatial_data *data) {
  struct ph_spatial_data image = {ph_vec3_scale(-1, data->dp),
                                  ph_vec3_scale(-1, data->tf),
                                  ph_vec3_scale(-1, data->ti),
                                  data->nf,
                                  data->ni,
                                  data->noise,
                                  data->planarity,
                                  data->normal};
  return image;
}

static unsigned exchanged(unsigned set) {
  return (set & PH_SHAPE_TORSION) | (set & PH_SHAPE_START ? PH_SHAPE_END : 0u) |
         (set & PH_SHAPE_END ? PH_SHAPE_START : 0u);
}

/* Tensions do not depend on where and how the data are looked at. */
PH_TEST(test_invariance) {
  struct unit_random r = unit_random_of(534);
  int segments = unit_count(SEGMENTS);
  size_t reduced = 0;
  for (int n = 0; n < segments; n++) {
    struct ph_spatial_data data = random_data(&r, unit_random_in(&r, 0.3, 3));
    struct ph_atph space = random_space(&r);
    struct ph_spatial_tension tension = tension_cc(&data, &space);
    ph_vec3 u = random_unit_vec3(&r), v = ph_vec3_any_normal(u);
    struct ph_spatial_data image[3];
    image[0] = turned(&data, ph_quat_of_frame(u, v, ph_vec3_cross(u, v)));
    image[1] = mirrored(&data);
    image[2] = reversed(&data);
    for (size_t i = 0; i < 3; i++) {
      struct ph_spatial_tension other = tension_cc(&image[i], &space);
      ck_abs(other.factor, tension.factor, 1e-11);
      ck_assert_uint_eq(i == 2 ? exchanged(other.without) : other.without,
                        tension.without);
      ck_assert_uint_eq(other.fit.violated != 0, tension.fit.violated != 0);
    }
    reduced += tension.factor < 1;
  }
  ck_assert_uint_ge(reduced, (size_t)segments / 30);
}

/* CC in a space that shrinks with the derivatives; fails when `left` is 0. */
struct shrinking {
  size_t left;
};

static enum ph_status choose_shrinking(struct ph_spatial_fit *fit,
                                       void *context) {
  struct shrinking *shrinking = context;
  struct ph_atph space = ph_atph_of(fit->family.ni / sqrt(3));
  if (shrinking->left-- == 0) {
    return PH_E_NO_MEMORY;
  }
  ph_spatial_family_space(&fit->family, &space);
  fit->member = ph_spatial_cc(&fit->family);
  return PH_OK;
}

/* A choice may change the space, and may fail, at any time. */
PH_TEST(test_choice) {
  struct ph_spatial_data data = example3(sqrt(3));
  struct ph_atph space = ph_atph_of(0);
  struct shrinking shrinking = {1000};
  struct ph_spatial_tension tension, again;
  ck_assert_int_eq(ph_spatial_tension(&data, &space, choose_shrinking,
                                      &shrinking, 1e-13, &tension),
                   PH_OK);
  ck_assert_uint_eq(tension.without, PH_SHAPE_TORSION);
  ck_assert_uint_eq(tension.fit.violated, 0);
  ck_rel(tension.fit.family.space.angle, tension.factor * tension.factor,
         1e-14);
  ck_assert_uint_eq(1000 - shrinking.left, tension.tried);
  for (size_t n = 0; n < tension.tried; n++) {
    shrinking.left = n;
    ck_assert_int_eq(ph_spatial_tension(&data, &space, choose_shrinking,
                                        &shrinking, 1e-13, &again),
                     PH_E_NO_MEMORY);
    ck_assert_uint_eq(again.tried, n + 1);
  }
}
