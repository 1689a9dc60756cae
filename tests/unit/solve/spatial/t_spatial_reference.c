/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The segments of tests/vectors/spatial-segments.phv, through the functions
 * that the method of splines is made of: the family, a member by a criterion or
 * by angles, its preimage, and the segment's points and invariants.
 */
#include "segment_unit.h"
#include "unit.h"
#include "spatial_unit.h"
#include "vectors_unit.h"

#include "curve/fair/fair3.h"
#include "curve/segment/seg3.h"
#include "solve/spatial/spatial.h"

enum how { CC, HC, BV, CHORD, X, HOWS };
static const char *const HOW[HOWS] = {"cc", "hc", "bv", "chord", "x"};

enum field {
  POINTS,
  DERIVATIVES,
  ALPHA,
  TOLERANCE,
  GAP,
  FUNCTIONALS,
  LENGTH,
  CONTROL,
  MIDDLE,
  CURVATURE,
  TORSION, /* the last one of a segment */
  FIELDS
};
static const struct {
  const char *name;
  size_t n;
  bool needed;
} FIELD[FIELDS] = {
    {"points", 6, true},    {"derivatives", 6, true}, {"alpha", 1, false},
    {"tolerance", 2, true}, {"gap", 1, false},        {"functionals", 4, false},
    {"length", 1, true},    {"control", 18, true},    {"middle", 3, true},
    {"curvature", 3, true}, {"torsion", 3, true},
};

/* A segment of the file. */
struct reference {
  char name[64];
  enum how how;
  struct unit_numbers angles, field[FIELDS];
};

static struct ph_quad rule;
static struct ph_fair3_rules fair_rules;
static int functionals; /* segments that have them */
static struct unit_vectors vectors;
static struct reference reference;

static void begin(void) {
  ck_assert(ph_quad_gauss(&rule, 12));
  ck_assert(ph_fair3_begin(&fair_rules));
  vectors = unit_vectors_open("tests/vectors/spatial-segments.phv");
}

static void finish(void) {
  for (size_t i = 0; i < FIELDS; i++) {
    free(reference.field[i].v);
  }
  free(reference.angles.v);
  free(vectors.text);
}

/* ---- reading -------------------------------------------------------- */

static void read_field(const char *word) {
  for (size_t i = 0; i < FIELDS; i++) {
    if (strcmp(word, FIELD[i].name) == 0) {
      unit_vectors_numbers(&vectors, &reference.field[i]);
      return;
    }
  }
  for (size_t i = 0; i < HOWS; i++) {
    if (strcmp(word, HOW[i]) == 0) {
      reference.how = (enum how)i;
      unit_vectors_numbers(&vectors, &reference.angles);
      return;
    }
  }
  ck_abort_msg("%s: what is '%s'?", reference.name, word);
}

static bool read_segment(void) {
  const char *word = unit_vectors_word(&vectors);
  if (!word) {
    return false;
  }
  ck_assert_str_eq(word, "segment");
  word = unit_vectors_word(&vectors);
  ck_assert(word && strlen(word) < sizeof reference.name);
  memcpy(reference.name, word, strlen(word) + 1);
  reference.how = HOWS;
  reference.angles.n = 0;
  for (size_t i = 0; i < FIELDS; i++) {
    reference.field[i].n = 0;
  }
  while (reference.field[TORSION].n == 0) {
    word = unit_vectors_word(&vectors);
    ck_assert_msg(word != NULL, "%s is cut off", reference.name);
    read_field(word);
  }
  for (size_t i = 0; i < FIELDS; i++) {
    size_t n = reference.field[i].n;
    ck_assert_msg(n == FIELD[i].n || (n == 0 && !FIELD[i].needed),
                  "%s: %s: %zu numbers", reference.name, FIELD[i].name, n);
  }
  ck_assert_uint_eq(reference.angles.n, reference.how >= CHORD ? 2 : 0);
  return true;
}

static ph_vec3 triple(enum field field, size_t i) {
  const double *v = reference.field[field].v + 3 * i;
  return ph_vec3_of(v[0], v[1], v[2]);
}

/* ---- checking ------------------------------------------------------- */

static struct ph_spatial_family family_of(void) {
  double alpha = reference.field[ALPHA].n ? reference.field[ALPHA].v[0] : 0;
  double interval = alpha > 0 ? alpha : 1;
  struct ph_atph space = ph_atph_of(alpha);
  ph_vec3 di = triple(DERIVATIVES, 0), df = triple(DERIVATIVES, 1);
  struct ph_spatial_data data;
  data.dp = ph_vec3_sub(triple(POINTS, 1), triple(POINTS, 0));
  data.ti = ph_vec3_unit(di);
  data.tf = ph_vec3_unit(df);
  data.ni = interval * ph_vec3_abs(di);
  data.nf = interval * ph_vec3_abs(df);
  data.noise = 0;
  data.planarity = 0;
  data.normal = ph_vec3_of(0, 0, 0);
  return ph_spatial_family_of(&data, &space);
}

static struct ph_spatial_member
member_of(const struct ph_spatial_family *family) {
  struct ph_spatial_member member = {{1, 0}, {1, 0}};
  enum ph_spatial_axis axis =
      reference.how == X ? PH_SPATIAL_X : PH_SPATIAL_CHORD;
  if (reference.how == CC) {
    return ph_spatial_cc(family);
  }
  if (reference.how == HC) {
    return ph_spatial_hc(family);
  }
  if (reference.how == BV) {
    return ph_spatial_bv(family);
  }
  ck_assert(ph_spatial_member_of(family, reference.angles.v, axis, &member));
  return member;
}

static void ck_value(const char *what, size_t i, double found, double wanted,
                     double allowed) {
  ck_assert_msg(unit_near(found, wanted, allowed),
                "%s: %s[%zu] is %.17g, not %.17g: error %.3g > %.3g",
                reference.name, what, i, found, wanted, fabs(found - wanted),
                allowed);
}

static void ck_point(const char *what, size_t i, ph_vec3 found, ph_vec3 wanted,
                     double allowed) {
  double error = ph_vec3_abs(ph_vec3_sub(found, wanted));
  ck_assert_msg(error <= allowed, "%s: %s[%zu]: error %.3g > %.3g",
                reference.name, what, i, error, allowed);
}

static void ck_bends(const struct ph_seg3 *seg, double tolerance) {
  const double *curvature = reference.field[CURVATURE].v;
  const double *torsion = reference.field[TORSION].v;
  double most_curved = 0, most_twisted = 0;
  for (size_t i = 0; i < 3; i++) {
    most_curved = unit_larger(curvature[i], most_curved);
    most_twisted =
        isnan(torsion[i]) ? most_twisted : fmax(fabs(torsion[i]), most_twisted);
  }
  for (size_t i = 0; i < 3; i++) {
    struct unit_bend3 bend = unit_seg3_bend(seg, 0.5 * (double)i);
    ck_value("curvature", i, bend.curvature, curvature[i],
             tolerance * most_curved);
    if (!isnan(torsion[i])) { /* where there is curvature */
      ck_value("torsion", i, bend.torsion, torsion[i],
               tolerance * most_twisted);
    }
  }
}

static void ck_gap(const ph_quat a[3], double tolerance) {
  ph_quat gap = ph_quat_scale(4, a[1]);
  gap = ph_quat_sub(gap, ph_quat_scale(2, ph_quat_add(a[0], a[2])));
  ck_rel(ph_quat_dot(gap, gap), reference.field[GAP].v[0], tolerance);
}

static void ck_functionals(const struct ph_seg3 *seg) {
  const double *wanted = reference.field[FUNCTIONALS].v;
  struct ph_fair3 fair = ph_fair3_of(&fair_rules, &seg->space, seg->a);
  double length = ph_seg3_length(&seg->space, seg->a);
  for (int k = 1; k <= 3; k++) {
    ck_value("functional", (size_t)k, ph_fair3_functional(&fair, length, k),
             wanted[k], wanted[0] * wanted[k]);
  }
}

static void ck_segment(void) {
  struct ph_spatial_family family = family_of();
  struct ph_spatial_member member = member_of(&family);
  const double *tolerance = reference.field[TOLERANCE].v;
  const double length = reference.field[LENGTH].v[0];
  struct ph_seg3 seg = {.space = family.space,
                        .start = triple(POINTS, 0),
                        .end = triple(POINTS, 1)};
  ph_vec3 p[6], wanted[6];
  double allowed;
  unit_spatial_preimage(&family, member, seg.a);
  ph_seg3_control_points(&seg.space, seg.a, seg.start, seg.end, p);
  for (size_t i = 0; i < 6; i++) {
    wanted[i] = triple(CONTROL, i);
  }
  allowed = tolerance[0] * unit_spatial_size(wanted);
  for (size_t i = 0; i < 6; i++) {
    ck_point("control", i, p[i], wanted[i], allowed);
  }
  ck_point("middle", 0, ph_seg3_point(&seg, &rule, 0.5), triple(MIDDLE, 0),
           allowed);
  ck_value("length", 0, ph_spatial_length(&family, member.b), length,
           tolerance[1] * length);
  ck_value("length", 1, ph_seg3_length(&seg.space, seg.a), length,
           tolerance[1] * length);
  ck_bends(&seg, tolerance[0]);
  if (reference.field[GAP].n) {
    ck_gap(seg.a, tolerance[0]);
  }
  if (reference.field[FUNCTIONALS].n == 4) {
    ck_functionals(&seg);
    functionals++;
  }
}

PH_TEST(test_segments) {
  int seen[HOWS] = {0};
  while (read_segment()) {
    ck_segment();
    seen[reference.how]++;
  }
  ck_assert_int_eq(seen[CC], 9);
  ck_assert_int_eq(seen[HC], 2);
  ck_assert_int_eq(seen[BV], 2);
  ck_assert_int_eq(seen[CHORD], 2);
  ck_assert_int_eq(seen[X], 18);
  ck_assert_int_eq(functionals, 19);
}

PH_FIXTURE(begin, finish)
