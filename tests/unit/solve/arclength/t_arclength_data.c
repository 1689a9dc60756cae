/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The pose of arc-length data: data that were turned, moved, mirrored, reversed
 * or scaled are the same to the solver, and what it finds comes back as the
 * image of what it finds for the data as they were.
 */
#include "unit.h"

#include "spatial_unit.h"

#include "solve/arclength/arclength.h"

enum { N = 6, X_MAX = 4 * (2 * N + 2) };

struct setting {
  struct ph_problem problem;
  struct ph_arc_data data;
  double vectors[3 * (N + 1)], lengths[N];
  struct ph_diag diag;
};

/* A motion, mirrored perhaps, of vectors and points. */
struct motion {
  ph_quat turn;
  bool mirror, reverse;
  double scale;
  ph_vec3 shift; /* of points */
};

static struct motion random_motion(struct unit_random *r, int which) {
  struct motion m = {unit_random_turn(r), (which & 1) != 0, (which & 2) != 0,
                     pow(10, unit_random_in(r, -9, 9)),
                     unit_random_direction(r)};
  return m;
}

static ph_vec3 moved(const struct motion *m, ph_vec3 v) {
  ph_quat q = ph_quat_pure(m->mirror ? ph_vec3_of(v.x, v.y, -v.z) : v);
  q = ph_quat_mul(ph_quat_mul(m->turn, q), ph_quat_conj(m->turn));
  return ph_vec3_scale(m->scale, ph_quat_vector(q));
}

/* The problem of vectors v[n] and lengths, moved. */
static enum ph_status set_up(struct setting *t, enum ph_field_id what,
                             const ph_vec3 *v, const double *length,
                             const struct motion *m) {
  bool points = what == PH_F_POINTS;
  memset(t, 0, sizeof *t);
  for (size_t i = 0; i <= N; i++) {
    size_t from = m->reverse ? N - i : i;
    ph_vec3 w = moved(m, v[from]);
    if (points) {
      w = ph_vec3_along(w, m->scale, m->shift);
    } else if (m->reverse) {
      w = ph_vec3_scale(-1, w);
    }
    ph_vec3_put(w, 3, t->vectors + 3 * i);
  }
  for (size_t i = 0; i < N; i++) {
    t->lengths[i] = m->scale * length[m->reverse ? N - 1 - i : i];
  }
  t->problem.field[what] = (struct ph_value){
      .kind = PH_VECTORS, .v = t->vectors, .n = N + 1, .dimension = 3};
  t->problem.field[PH_F_LENGTHS] = (struct ph_value){
      .kind = PH_NUMBERS, .v = t->lengths, .n = N, .dimension = 1};
  return ph_arc_data_read(&t->problem, &unit_arena, &t->data, &t->diag);
}

static const struct motion still = {{1, 0, 0, 0}, false, false, 1, {0, 0, 0}};

static void random_data(struct unit_random *r, ph_vec3 v[N + 1],
                        double length[N]) {
  for (size_t i = 0; i <= N; i++) {
    v[i] = ph_vec3_scale(unit_random_in(r, 0.5, 2), unit_random_direction(r));
  }
  for (size_t i = 0; i < N; i++) {
    double chord = ph_vec3_abs(ph_vec3_sub(v[i + 1], v[i]));
    length[i] = chord * unit_random_in(r, 1.1, 1.5);
  }
}

static void check_same(const struct ph_arc_data *a,
                       const struct ph_arc_data *b) {
  for (size_t i = 0; i < N; i++) {
    ck_rel(a->length[i], b->length[i], 1e-13);
    ck_rel(a->h[i], b->h[i], 1e-13);
  }
  for (size_t i = 0; i < (a->step ? N : N + 1); i++) {
    ph_vec3 v = a->step ? a->step[i] : a->given[i];
    ph_vec3 w = b->step ? b->step[i] : b->given[i];
    ck_abs(ph_vec3_abs(ph_vec3_sub(v, w)), 0, 1e-12);
  }
}

/* All poses of one problem are one. */
PH_TEST_EACH(test_pose, 8) {
  static const enum ph_field_id what[] = {PH_F_POINTS, PH_F_DERIVATIVES,
                                          PH_F_TANGENTS};
  struct unit_random r = unit_random_of(1200 + (uint64_t)_i);
  ph_vec3 v[N + 1];
  double length[N];
  random_data(&r, v, length);
  for (size_t k = 0; k < 3; k++) {
    struct motion m = random_motion(&r, _i);
    struct setting a, b;
    ck_assert_int_eq(set_up(&a, what[k], v, length, &still), PH_OK);
    ck_assert_int_eq(set_up(&b, what[k], v, length, &m), PH_OK);
    check_same(&a.data, &b.data);
    ck_rel(b.data.root * b.data.root, a.data.root * a.data.root * m.scale,
           1e-13);
    ck_assert_int_eq(b.data.reversed ^ a.data.reversed, m.reverse);
    ck_assert_int_eq(b.data.mirrored ^ a.data.mirrored, m.mirror);
  }
}

/* Any nodes whatsoever, as curves of both problems. */
PH_TEST_EACH(test_curve_moves_along, 8) {
  struct unit_random r = unit_random_of(1240 + (uint64_t)_i);
  struct motion m = random_motion(&r, _i);
  struct setting t[2];
  struct ph_curve curve[2];
  ph_vec3 v[N + 1], from;
  double length[N], x[X_MAX], turn;
  random_data(&r, v, length);
  for (size_t k = 0; k < X_MAX; k++) {
    x[k] = unit_random_in(&r, -1, 1);
  }
  for (size_t k = 0; k < 2; k++) {
    struct ph_arc_system s;
    ck_assert_int_eq(
        set_up(&t[k], PH_F_DERIVATIVES, v, length, k == 0 ? &still : &m),
        PH_OK);
    ck_assert(ph_arc_system_of(&t[k].data, 2, 4, true, &unit_arena, &s));
    ck_assert_int_eq(
        ph_arc_curve(&s, x, &unit_arena, &curve[k], &turn, &t[k].diag), PH_OK);
  }
  ck_rel(curve[1].length, m.scale * curve[0].length, 1e-13);
  from = ph_vec3_get(curve[1].control_points, 3);
  if (m.reverse) { /* it begins where the other ends */
    from = ph_vec3_get(curve[1].control_points + 18 * curve[1].n - 3, 3);
  }
  for (size_t i = 0; i < 6 * curve[0].n; i++) {
    size_t other = m.reverse ? 6 * curve[0].n - 1 - i : i;
    ph_vec3 p = ph_vec3_get(curve[0].control_points + 3 * i, 3);
    ph_vec3 q = ph_vec3_get(curve[1].control_points + 3 * other, 3);
    ph_vec3 want = moved(&m, p), got = ph_vec3_sub(q, from);
    ck_abs(ph_vec3_abs(ph_vec3_sub(got, want)), 0,
           1e-13 * m.scale * curve[0].length);
  }
}

/* Our vectors turned back are the user's, also of data that hardly leave a
 * line, whose second axis is a difference of nearly equal vectors. */
PH_TEST_EACH(test_turn_of_slender_data, 14) {
  struct unit_random r = unit_random_of(1300 + (uint64_t)_i);
  double bulge = pow(10, -_i), length[N];
  struct setting t;
  ph_vec3 v[N + 1];
  for (size_t i = 0; i <= N; i++) {
    ph_vec3 off = ph_vec3_scale(bulge, unit_random_direction(&r));
    v[i] =
        ph_vec3_add(ph_vec3_of(3 * (double)i, 4 * (double)i, (double)i), off);
    length[i < N ? i : 0] = 10;
  }
  ck_assert_int_eq(set_up(&t, PH_F_POINTS, v, length, &still), PH_OK);
  for (size_t i = 0; i < N; i++) {
    size_t from = ph_arc_data_user(&t.data, i);
    ph_vec3 step = t.data.step[i], want = ph_vec3_sub(v[from + 1], v[from]);
    ph_quat q;
    step.z = t.data.mirrored ? -step.z : step.z;
    step = ph_vec3_scale(t.data.reversed ? -1 : 1, step);
    q = ph_quat_mul(ph_quat_mul(t.data.turn, ph_quat_pure(step)),
                    ph_quat_conj(t.data.turn));
    step = ph_vec3_scale(t.data.root * t.data.root, ph_quat_vector(q));
    ck_abs(ph_vec3_abs(ph_vec3_sub(step, want)), 0, 1e-14 * 30);
  }
}

/* Data in a plane and on a line are known as such, also in a tilted one. */
PH_TEST_EACH(test_plane_and_line, 4) {
  struct unit_random r = unit_random_of(1280 + (uint64_t)_i);
  struct motion m = random_motion(&r, _i);
  struct setting t;
  ph_vec3 v[N + 1];
  double length[N];
  m.scale = 1;
  random_data(&r, v, length);
  ck_assert_int_eq(set_up(&t, PH_F_POINTS, v, length, &m), PH_OK);
  ck_assert(!t.data.plane && !t.data.line && !t.data.straight);
  for (size_t i = 0; i <= N; i++) {
    v[i].z = 0;
  }
  ck_assert_int_eq(set_up(&t, PH_F_POINTS, v, length, &m), PH_OK);
  ck_assert(t.data.plane && !t.data.line && !t.data.straight);
  for (size_t i = 0; i < N; i++) {
    ck_abs(t.data.step[i].z, 0, 0);
  }
  for (size_t i = 0; i <= N; i++) {
    v[i] = ph_vec3_of((double)i, 0, 0);
    length[i < N ? i : 0] = 1;
  }
  ck_assert_int_eq(set_up(&t, PH_F_POINTS, v, length, &m), PH_OK);
  ck_assert(t.data.plane && t.data.line && t.data.straight);
}

/* A plane curve stays exactly in the plane z = 0 of its data. */
PH_TEST_EACH(test_plane_is_kept, 4) {
  struct unit_random r = unit_random_of(1320 + (uint64_t)_i);
  struct setting t;
  struct ph_arc_system s;
  struct ph_curve curve;
  ph_vec3 v[N + 1];
  double length[N], x[X_MAX], turn;
  random_data(&r, v, length);
  for (size_t i = 0; i <= N; i++) {
    v[i].z = 0;
  }
  for (size_t k = 0; k < X_MAX; k++) {
    x[k] = unit_random_in(&r, -1, 1);
  }
  ck_assert_int_eq(set_up(&t, PH_F_DERIVATIVES, v, length, &still), PH_OK);
  ck_assert(ph_arc_system_of(&t.data, 2, 2, true, &unit_arena, &s));
  ck_assert_int_eq(ph_arc_curve(&s, x, &unit_arena, &curve, &turn, &t.diag),
                   PH_OK);
  for (size_t i = 0; i < 6 * curve.n; i++) {
    ck_abs(curve.control_points[3 * i + 2], 0, 0);
  }
}

/* ---- closed data --------------------------------------------------------- */

/* Closed points from point `from` on, perhaps backwards. */
static void set_up_closed(struct setting *t, const ph_vec3 *v, size_t from,
                          bool backwards) {
  memset(t, 0, sizeof *t);
  for (size_t i = 0; i < N; i++) {
    size_t k = backwards ? from + N - i : from + i;
    ph_vec3_put(v[k % N], 3, t->vectors + 3 * i);
  }
  t->problem.field[PH_F_POINTS] = (struct ph_value){
      .kind = PH_VECTORS, .v = t->vectors, .n = N, .dimension = 3};
  t->problem.field[PH_F_CLOSED] =
      (struct ph_value){.kind = PH_BOOL, .flag = true};
  ck_assert_int_eq(
      ph_arc_data_read(&t->problem, &unit_arena, &t->data, &t->diag), PH_OK);
}

/* Wherever they begin and whichever way they go, they are the same. */
PH_TEST_EACH(test_closed_pose, 2 * N) {
  struct unit_random r = unit_random_of(1360);
  ph_vec3 v[N + 1];
  double length[N];
  struct setting a, b;
  random_data(&r, v, length);
  set_up_closed(&a, v, 0, false);
  set_up_closed(&b, v, (size_t)_i / 2, _i % 2 == 1);
  for (size_t i = 0; i < N; i++) {
    ck_rel(a.data.h[i], b.data.h[i], 1e-13);
    ck_rel(a.data.chord[i], b.data.chord[i], 1e-13);
    ck_abs(ph_vec3_abs(ph_vec3_sub(a.data.step[i], b.data.step[i])), 0, 1e-13);
    ck_assert_uint_eq(ph_arc_data_ours(&b.data, ph_arc_data_user(&b.data, i)),
                      i);
  }
}

/* Any nodes and any chi: the preimage is continuous from segment to segment,
 * also where ours begin, and an interval is as long as in ours. */
PH_TEST_EACH(test_closed_curve, 2 * N) {
  struct unit_random r = unit_random_of(1400 + (uint64_t)_i);
  struct setting t;
  struct ph_arc_system s;
  struct ph_curve curve;
  ph_vec3 v[N + 1];
  double length[N], x[X_MAX], turn;
  random_data(&r, v, length);
  for (size_t k = 0; k < X_MAX; k++) {
    x[k] = unit_random_in(&r, -1, 1);
  }
  set_up_closed(&t, v, (size_t)_i / 2, _i % 2 == 1);
  ck_assert(ph_arc_system_of(&t.data, 2, 4, true, &unit_arena, &s));
  ck_assert_int_eq(ph_arc_curve(&s, x, &unit_arena, &curve, &turn, &t.diag),
                   PH_OK);
  ph_arc_lengths(&s, x, length);
  for (size_t i = 0; i < N; i++) {
    double unit = t.data.root * t.data.root;
    ck_rel(curve.lengths[2 * i] + curve.lengths[2 * i + 1],
           unit * length[ph_arc_data_ours(&t.data, i)], 1e-13);
  }
  for (size_t q = 0; q + 1 < curve.n; q++) {
    double before = curve.knots[q + 1] - curve.knots[q];
    double after = curve.knots[q + 2] - curve.knots[q + 1];
    const double *a = curve.preimage.v + 12 * q + 8, *b = a + 4;
    for (size_t k = 0; k < 4; k++) {
      ck_abs(a[k] / sqrt(before), b[k] / sqrt(after), 1e-13);
    }
  }
}
