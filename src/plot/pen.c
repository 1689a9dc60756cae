/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A drawing while it is made (see pen.h). */
#include "plot/pen.h"

#include <math.h>
#include <string.h>

static bool is_finite(ph_vec3 p) {
  return isfinite(p.x) && isfinite(p.y) && isfinite(p.z);
}

static bool is_same(ph_vec3 a, ph_vec3 b) {
  return memcmp(&a, &b, sizeof a) == 0;
}

void ph_pen_box(struct ph_drawing *d, ph_vec3 p) {
  d->low =
      ph_vec3_of(fmin(d->low.x, p.x), fmin(d->low.y, p.y), fmin(d->low.z, p.z));
  d->high = ph_vec3_of(fmax(d->high.x, p.x), fmax(d->high.y, p.y),
                       fmax(d->high.z, p.z));
}

/* Another point, and the handles before it. */
static void append(struct ph_pen *pen, const ph_vec3 handles[2], ph_vec3 p) {
  ph_vec3 *points = ph_arena_grow(&pen->scratch, pen->points, pen->n, sizeof p,
                                  64, &pen->room);
  ph_vec3 *before = ph_arena_grow(&pen->scratch, pen->handles, pen->n,
                                  2 * sizeof p, 64, &pen->handles_room);
  if (!points || !before) {
    pen->failed = true;
    return;
  }
  pen->points = points;
  pen->handles = before;
  pen->handles[2 * pen->n] = handles[0];
  pen->handles[2 * pen->n + 1] = handles[1];
  pen->points[pen->n++] = p;
}

static ph_vec3 between(ph_vec3 a, ph_vec3 b, double t) {
  return ph_vec3_add(ph_vec3_scale(1 - t, a), ph_vec3_scale(t, b));
}

void ph_pen_to(struct ph_pen *pen, ph_vec3 p) {
  const ph_vec3 last = pen->n > 0 ? pen->points[pen->n - 1] : p;
  const ph_vec3 thirds[2] = {between(last, p, 1.0 / 3),
                             between(p, last, 1.0 / 3)};
  if (pen->failed || !is_finite(p) || (pen->n > 0 && is_same(last, p))) {
    return;
  }
  append(pen, thirds, p);
  if (pen->box && !pen->failed) {
    ph_pen_box(pen->drawing, p);
  }
}

/* ---- cubics -------------------------------------------------------------- */

static ph_vec3 cubic_at(const ph_vec3 c[4], double t) {
  const ph_vec3 left =
      between(between(c[0], c[1], t), between(c[1], c[2], t), t);
  const ph_vec3 right =
      between(between(c[1], c[2], t), between(c[2], c[3], t), t);
  return between(left, right, t);
}

/* A place of the curve. */
struct place {
  double u, speed; /* of the point, by u */
  ph_vec3 point, tangent;
};

static struct place place_at(const struct ph_sampler *sampler, double u) {
  const struct ph_sample sample = ph_sampler_at(sampler, u);
  struct place place = {u, 0, sample.point, {0, 0, 0}};
  double speed;
  ph_sampler_length(sampler, u, &speed);
  if (speed > 0 && isfinite(speed) && is_finite(sample.tangent)) {
    place.speed = speed;
    place.tangent = sample.tangent;
  }
  return place;
}

/* A cubic along the curve, and places of the curve that it is compared with. */
enum { CHECKS = 5 };
struct along {
  const struct ph_sampler *sampler;
  struct place ends[2];
  struct ph_sample at[CHECKS];
  double reach[2]; /* of the handles */
  ph_vec3 cubic[4];
};

static double check_at(int i) {
  return (i + 1.0) / (CHECKS + 1);
}

static void put_handles(struct along *a) {
  a->cubic[0] = a->ends[0].point;
  a->cubic[1] =
      ph_vec3_along(a->ends[0].point, a->reach[0], a->ends[0].tangent);
  a->cubic[2] =
      ph_vec3_along(a->ends[1].point, -a->reach[1], a->ends[1].tangent);
  a->cubic[3] = a->ends[1].point;
}

static ph_vec3 across(ph_vec3 v, ph_vec3 tangent) {
  return ph_vec3_along(v, -ph_vec3_dot(v, tangent), tangent);
}

/* How far a place of the curve is from a point beside it: a little that lies
 * along the curve counts as far as that bends away. */
static double beside(const struct along *a, const struct ph_sample *at,
                     ph_vec3 point) {
  const double radius = a->sampler->curve->sphere.radius;
  const ph_vec3 apart = ph_vec3_sub(point, at->point);
  const double along = fabs(ph_vec3_dot(apart, at->tangent));
  const double bend = hypot(at->curvature, radius > 0 ? 1 / radius : 0);
  const double d =
      ph_vec3_abs(across(apart, at->tangent)) + 0.5 * bend * along * along;
  return along * bend <= 0.05 && along <= 0.1 * (a->reach[0] + a->reach[1])
             ? d
             : ph_vec3_abs(apart);
}

/* How far the curve is from the cubic, at the places. */
static double error_of(const struct along *a) {
  double far =
      is_finite(a->cubic[1]) && is_finite(a->cubic[2]) ? 0 : (double)INFINITY;
  for (int i = 0; i < CHECKS; i++) {
    const double d = beside(a, &a->at[i], cubic_at(a->cubic, check_at(i)));
    far = d <= far ? far : isfinite(d) ? d : (double)INFINITY;
  }
  return far;
}

/* Lengths of the handles that bring the cubic nearer to the curve: a step of
 * Gauss and Newton for what is across the curve at the places. */
static void adjust(struct along *a) {
  double n00 = 0, n01 = 0, n11 = 0, r0 = 0, r1 = 0, det, to[2];
  for (int i = 0; i < CHECKS; i++) {
    const double t = check_at(i);
    const ph_vec3 tangent = a->at[i].tangent;
    const ph_vec3 apart = ph_vec3_sub(cubic_at(a->cubic, t), a->at[i].point);
    const ph_vec3 by0 = across(
        ph_vec3_scale(3 * t * (1 - t) * (1 - t), a->ends[0].tangent), tangent);
    const ph_vec3 by1 = across(
        ph_vec3_scale(-3 * t * t * (1 - t), a->ends[1].tangent), tangent);
    n00 += ph_vec3_dot(by0, by0);
    n01 += ph_vec3_dot(by0, by1);
    n11 += ph_vec3_dot(by1, by1);
    r0 += ph_vec3_dot(by0, apart);
    r1 += ph_vec3_dot(by1, apart);
  }
  det = n00 * n11 - n01 * n01;
  to[0] = a->reach[0] - (n11 * r0 - n01 * r1) / det;
  to[1] = a->reach[1] - (n00 * r1 - n01 * r0) / det;
  for (int k = 0; k < 2; k++) {
    if (!(to[k] > 0.5 * a->reach[k] && to[k] < 2 * a->reach[k])) {
      return;
    }
  }
  a->reach[0] = to[0];
  a->reach[1] = to[1];
  put_handles(a);
}

/* The cubic with the derivatives of the curve, or one that is nearer if that is
 * not near enough.
 * ret  how far it is */
static double fit(struct along *a, double near) {
  const double h = a->ends[1].u - a->ends[0].u;
  struct along other;
  double far, nearer;
  for (int i = 0; i < CHECKS; i++) {
    a->at[i] = ph_sampler_at(a->sampler, a->ends[0].u + check_at(i) * h);
  }
  a->reach[0] = h / 3 * a->ends[0].speed;
  a->reach[1] = h / 3 * a->ends[1].speed;
  put_handles(a);
  far = error_of(a);
  if (far <= near) {
    return far;
  }
  other = *a;
  adjust(&other);
  adjust(&other);
  nearer = error_of(&other);
  if (nearer < far) {
    *a = other;
  }
  return fmin(nearer, far);
}

/* Where a coordinate of a cubic turns, the box holds it. */
static void box_cubic(struct ph_drawing *d, const ph_vec3 c[4]) {
  double v[3][3];
  for (int i = 0; i < 3; i++) {
    ph_vec3_put(ph_vec3_sub(c[i + 1], c[i]), 3, v[i]);
  }
  for (int i = 0; i < 3; i++) {
    const double p = v[0][i], q = v[1][i], r = v[2][i];
    /* p (1-t)^2 + 2 q t (1-t) + r t^2 = 0 */
    const double root = sqrt(fmax(q * q - p * r, 0));
    const double sum = p - q + (p > q ? root : -root);
    const double turns[2] = {sum / (p - 2 * q + r), p / sum};
    for (int k = 0; k < 2; k++) {
      if (turns[k] > 0 && turns[k] < 1) {
        ph_pen_box(d, cubic_at(c, turns[k]));
      }
    }
  }
}

static void draw_cubic(struct ph_pen *pen, const ph_vec3 c[4]) {
  if (pen->failed ||
      (is_same(c[0], c[1]) && is_same(c[1], c[2]) && is_same(c[2], c[3]))) {
    return;
  }
  ph_pen_to(pen, c[0]);
  append(pen, c + 1, c[3]);
  pen->curved = true;
  if (pen->box && !pen->failed) {
    ph_pen_box(pen->drawing, c[3]);
    box_cubic(pen->drawing, c);
  }
}

static void draw_places(struct ph_pen *pen, const struct ph_sampler *sampler,
                        const struct place *from, const struct place *to,
                        int depth) {
  const double half = 0.5 * pen->near;
  struct along a = {.sampler = sampler, .ends = {*from, *to}};
  const double far = fit(&a, half);
  if (depth > 0 && !(far <= half)) {
    const struct place middle = place_at(sampler, (from->u + to->u) / 2);
    draw_places(pen, sampler, from, &middle, depth - 1);
    draw_places(pen, sampler, &middle, to, depth - 1);
  } else if (far <= pen->tolerance && is_finite(from->point) &&
             is_finite(to->point)) {
    draw_cubic(pen, a.cubic);
  } else {
    ph_pen_to(pen, to->point);
  }
}

void ph_pen_along(struct ph_pen *pen, const struct ph_sampler *sampler,
                  double u0, double u1, int depth) {
  const struct place from = place_at(sampler, u0), to = place_at(sampler, u1);
  draw_places(pen, sampler, &from, &to, depth);
}

/* ---- strokes ------------------------------------------------------------- */

static void stroke_handles(struct ph_pen *pen, struct ph_stroke *stroke) {
  struct ph_drawing *d = pen->drawing;
  const size_t n = 2 * (stroke->n - 1);
  stroke->handles = ph_arena_array(&d->arena, n, sizeof *stroke->handles);
  if (!stroke->handles) {
    pen->failed = true;
    return;
  }
  memcpy(stroke->handles, pen->handles + 2, n * sizeof *stroke->handles);
  d->places += n;
}

void ph_pen_lift(struct ph_pen *pen, enum ph_stroke_role role, size_t index) {
  struct ph_drawing *d = pen->drawing;
  size_t n = pen->n < 2 ? 2 : pen->n;
  struct ph_stroke stroke = {role, index, n, NULL, NULL};
  if (pen->failed || pen->n == 0) {
    return;
  }
  stroke.points = ph_arena_array(&d->arena, n, sizeof *stroke.points);
  if (!stroke.points) {
    pen->failed = true;
    return;
  }
  stroke.points[1] = pen->points[0];
  memcpy(stroke.points, pen->points, pen->n * sizeof *stroke.points);
  d->strokes[d->strokes_n++] = stroke;
  d->places += n;
  if (pen->curved && n == pen->n) {
    stroke_handles(pen, &d->strokes[d->strokes_n - 1]);
  }
  pen->n = 0;
  pen->curved = false;
}
