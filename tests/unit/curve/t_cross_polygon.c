/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Crossings of planar curves, side by side with those of fine polygons. */
#include "unit.h"
#include "cross_unit.h"

#include "curve/segment/seg2.h"

/* A polygon with vertices where the tangent has turned by some angle. */
struct polygon {
  ph_cplx *p;
  size_t *segment; /* of the edge from p[i] to p[i + 1] */
  size_t n, room;
};

static void polygon_add(struct polygon *polygon, ph_cplx p, size_t segment) {
  ck_assert(polygon->n < polygon->room);
  polygon->p[polygon->n] = p;
  polygon->segment[polygon->n++] = segment;
}

/* Vertices after u0, to u1. */
static void polygon_part(struct polygon *polygon, const struct ph_seg2 *seg,
                         size_t k, double u0, double u1, double turn) {
  ph_cplx w[3];
  for (size_t i = 0; i < 3; i++) {
    ph_atph_jet(&seg->space, seg->w, u0 + 0.5 * (double)i * (u1 - u0), &w[i],
                1);
  }
  if (u1 - u0 > 0x1p-24 &&
      (u1 - u0 > 0.2 ||
       !(fabs(ph_cplx_cross(w[0], w[1])) < turn * ph_cplx_dot(w[0], w[1])) ||
       !(fabs(ph_cplx_cross(w[1], w[2])) < turn * ph_cplx_dot(w[1], w[2])))) {
    polygon_part(polygon, seg, k, u0, 0.5 * (u0 + u1), turn);
    polygon_part(polygon, seg, k, 0.5 * (u0 + u1), u1, turn);
  } else {
    polygon_add(polygon, ph_seg2_point(seg, unit_quad(12), u1), k);
  }
}

static struct polygon polygon_of(const struct ph_curve *curve, double turn) {
  struct polygon polygon = {.room = curve->n * 1000};
  polygon.p = malloc(polygon.room * sizeof *polygon.p);
  polygon.segment = malloc(polygon.room * sizeof *polygon.segment);
  ck_assert(polygon.p && polygon.segment);
  for (size_t k = 0; k < curve->n; k++) {
    struct ph_seg2 seg = ph_seg2_of(curve, k);
    if (k == 0) {
      polygon_add(&polygon, seg.start, 0);
    }
    polygon.segment[polygon.n - 1] = k;
    polygon_part(&polygon, &seg, k, 0, 1, turn);
  }
  return polygon;
}

static void polygon_free(struct polygon *polygon) {
  free(polygon->p);
  free(polygon->segment);
}

static double left_of(ph_cplx a, ph_cplx b, ph_cplx p) {
  return ph_cplx_cross(ph_cplx_sub(b, a), ph_cplx_sub(p, a));
}

/* Whether edges i and j of a polygon cross. */
static bool edges_cross(const ph_cplx *p, size_t i, size_t j) {
  return left_of(p[i], p[i + 1], p[j]) * left_of(p[i], p[i + 1], p[j + 1]) <
             0 &&
         left_of(p[j], p[j + 1], p[i]) * left_of(p[j], p[j + 1], p[i + 1]) < 0;
}

/* Crossings, and segments that cross themselves. */
struct count {
  size_t crossings, loops;
};

static struct count polygon_count(const struct polygon *polygon) {
  struct count count = {0, 0};
  size_t last = SIZE_MAX;
  for (size_t i = 0; i + 1 < polygon->n; i++) {
    for (size_t j = i + 2; j + 1 < polygon->n; j++) {
      bool same = polygon->segment[i] == polygon->segment[j];
      if (edges_cross(polygon->p, i, j)) {
        count.crossings++;
        count.loops += same && last != polygon->segment[i] ? 1 : 0;
        last = same ? polygon->segment[i] : last;
      }
    }
  }
  return count;
}

/* Whether an end lies so near an edge that the curve may be on the other side
 * of it: the polygon may cross there although the curve does not. */
static bool end_near(const struct polygon *polygon) {
  const ph_cplx *p = polygon->p;
  for (size_t i = 0; i + 1 < polygon->n; i++) {
    ph_cplx edge = ph_cplx_sub(p[i + 1], p[i]);
    double length = ph_cplx_abs(edge);
    for (int j = 0; j < 2; j++) {
      ph_cplx end = p[j ? polygon->n - 1 : 0];
      double along = ph_cplx_dot(ph_cplx_sub(end, p[i]), edge) / length;
      double aside = fabs(left_of(p[i], p[i + 1], end)) / length;
      if (i != (j ? polygon->n - 2 : 0) && aside <= 0.05 * length &&
          along >= -0.05 * length && along <= 1.05 * length) {
        return true;
      }
    }
  }
  return false;
}

/* Counts crossings at two resolutions; false where they differ. */
static bool clear_cut(const struct ph_curve *curve, struct count *count) {
  struct polygon coarse = polygon_of(curve, 0.05);
  struct polygon fine = polygon_of(curve, 0.01);
  struct count other = polygon_count(&coarse);
  bool clear = curve->closed || !end_near(&fine);
  *count = polygon_count(&fine);
  polygon_free(&coarse);
  polygon_free(&fine);
  return clear && count->crossings == other.crossings &&
         count->loops == other.loops;
}

/* How curves came out beside their polygons. */
struct tally {
  size_t simple, loops, unclear;
};

static void ck_polygons(const struct ph_curve *curve, double size, int i,
                        struct tally *tally) {
  struct ph_cross cross = unit_cross(curve, size);
  struct count count;
  if (clear_cut(curve, &count)) {
    ck_assert_msg(cross.simple == (count.crossings == 0) &&
                      cross.loops == count.loops,
                  "seed %lu, curve %d: %zu crossings, %zu loops, found %zu",
                  unit_seed(), i, count.crossings, count.loops, cross.loops);
  } else {
    tally->unclear++;
  }
  tally->simple += cross.simple ? 1 : 0;
  tally->loops += cross.loops ? 1 : 0;
}

PH_TEST(test_polygons) {
  const int splines = unit_count(200);
  struct unit_random r = unit_random_of(1);
  struct tally tally = {0, 0, 0};
  for (int i = 0; i < splines; i++) {
    struct unit_solution u = unit_planar_random(&r, i);
    ck_polygons(&u.result.curve, unit_planar_size(&u), i, &tally);
    unit_solution_free(&u);
  }
  ck_assert_uint_le(tally.unclear, splines / 20);
  ck_assert_uint_ge(tally.simple, splines / 5);
}

PH_TEST(test_polygons_of_loops) {
  const int chains = unit_count(300);
  struct unit_random r = unit_random_of(5);
  struct tally tally = {0, 0, 0};
  for (int i = 0; i < chains; i++) {
    struct unit_chain chain;
    unit_chain_random(&chain, &r, 2 + unit_random_below(&r, 3));
    ck_polygons(&chain.curve, 10, i, &tally);
  }
  ck_assert_uint_le(tally.unclear, chains / 20);
  ck_assert_uint_ge(tally.simple, chains / 10);
  ck_assert_uint_ge(tally.loops, chains / 10);
}

PH_TEST(test_all_loops) {
  /* They are all counted, wherever the first crossing is. */
  struct unit_random r = unit_random_of(6);
  struct tally tally = {0, 0, 0};
  struct unit_chain chain;
  struct ph_cross cross;
  unit_chain_random(&chain, &r, UNIT_PIECES);
  cross = unit_cross(&chain.curve, 100);
  ck_assert(!cross.simple);
  for (size_t k = 0; k < UNIT_PIECES; k++) {
    struct ph_curve one = chain.curve;
    one.n = 1;
    one.control_points += 12 * k;
    one.preimage.v += 6 * k;
    ck_polygons(&one, 10, (int)k, &tally);
  }
  ck_assert_uint_eq(cross.loops, tally.loops);
  ck_assert_uint_ge(cross.loops, UNIT_PIECES / 20);
  ck_assert_uint_le(tally.unclear, UNIT_PIECES / 20);
}
