/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Unit tangents at points in space (see spatial.h). */
#include "solve/spatial/spatial.h"

#include "kernel/pow2.h"

/* The sum (1) has no direction below this, for chords of sum 1. */
static const double REVERSAL = 1e-10;

/* The square of a chord that is shorter may not be a number. */
static const double SHORT = 1e-140;

/* A chord leaves a line by more than this times its length, or lies on it. */
static const double ON_LINE = 1e-6;

struct polygon {
  const double *points;
  size_t dimension;
  size_t n;     /* points */
  size_t edges; /* n, or n - 1 if open */
  bool closed;
  int exponent;         /* unit scale is 2^exponent times theirs */
  struct ph_pow2 scale; /* to unit scale */
};

struct edge {
  ph_vec3 direction; /* unit */
  double length;
};

static struct polygon polygon_of(const double *points, size_t n,
                                 size_t dimension, bool closed) {
  struct polygon p = {.points = points,
                      .dimension = dimension,
                      .n = n,
                      .edges = closed ? n : n - 1,
                      .closed = closed,
                      .scale = {1, 1}};
  double largest = 0;
  for (size_t i = 0; i < dimension * n; i++) {
    largest = fabs(points[i]) > largest ? fabs(points[i]) : largest;
  }
  if (largest > 0) {
    p.exponent = -ph_pow2_exponent(largest);
    p.scale = ph_pow2_of(p.exponent);
  }
  return p;
}

static ph_vec3 given(const struct polygon *p, size_t j) {
  return ph_vec3_get(p->points + p->dimension * j, p->dimension);
}

static ph_vec3 point(const struct polygon *p, size_t j) {
  const ph_vec3 x = given(p, j);
  return ph_vec3_of(ph_pow2_apply(p->scale, x.x), ph_pow2_apply(p->scale, x.y),
                    ph_pow2_apply(p->scale, x.z));
}

/* An edge between points that are so near to each other that at unit scale they
 * may be the same: from their own digits. */
static struct edge short_edge(ph_vec3 from, ph_vec3 to, int exponent) {
  ph_vec3 d = ph_vec3_sub(to, from);
  double largest = fmax(fmax(fabs(d.x), fabs(d.y)), fabs(d.z)), length;
  int up = -ph_pow2_exponent(largest);
  d = ph_vec3_of(ldexp(d.x, up), ldexp(d.y, up), ldexp(d.z, up));
  length = ph_vec3_abs(d);
  return (struct edge){ph_vec3_scale(1 / length, d),
                       ldexp(length, exponent - up)};
}

/* The edge that starts in point k; k < 2 n if closed, so that one may count on
 * from the last. */
static struct edge edge_of(const struct polygon *p, size_t k) {
  size_t from = k < p->edges ? k : k - p->edges;
  size_t to = from + 1 < p->n ? from + 1 : 0;
  ph_vec3 d = ph_vec3_sub(point(p, to), point(p, from));
  double length = ph_vec3_abs(d);
  return length > SHORT ? (struct edge){ph_vec3_scale(1 / length, d), length}
                        : short_edge(given(p, from), given(p, to), p->exponent);
}

/* The edge on the other side of `edge` whose mirror image is `next`: before the
 * first one, or after the last one. */
static struct edge mirror(struct edge edge, struct edge next) {
  double along = 2 * ph_vec3_dot(next.direction, edge.direction);
  struct edge image = {
      ph_vec3_sub(ph_vec3_scale(along, edge.direction), next.direction),
      next.length};
  return image;
}

/* The edges that meet in point j, j < n. */
static void edges_at(const struct polygon *p, size_t j, struct edge *in,
                     struct edge *out) {
  if (p->closed) {
    *in = edge_of(p, j + p->n - 1);
    *out = edge_of(p, j);
  } else if (p->edges == 1) {
    *in = *out = edge_of(p, 0);
  } else if (j == 0) {
    *out = edge_of(p, 0);
    *in = mirror(*out, edge_of(p, 1));
  } else if (j == p->edges) {
    *in = edge_of(p, j - 1);
    *out = mirror(*in, edge_of(p, j - 2));
  } else {
    *in = edge_of(p, j - 1);
    *out = edge_of(p, j);
  }
}

/* The tangent (1), up to its length; false where it vanishes. */
static bool circle_tangent(struct edge in, struct edge out, ph_vec3 *tangent) {
  ph_vec3 t = ph_vec3_along(ph_vec3_scale(out.length, in.direction), in.length,
                            out.direction);
  double size = ph_vec3_abs(t);
  *tangent = ph_vec3_scale(1 / size, t);
  return size > REVERSAL * (in.length + out.length);
}

/* ---- where the polygon turns back ----------------------------------- */

static bool turns_back(const struct polygon *p, size_t j) {
  struct edge in, out;
  ph_vec3 tangent;
  edges_at(p, j, &in, &out);
  return !circle_tangent(in, out, &tangent);
}

/* v, or 0 where it has no direction beside vectors of length 1. */
static ph_vec3 unit_or_zero(ph_vec3 v) {
  return ph_vec3_abs(v) > ON_LINE ? ph_vec3_unit(v) : ph_vec3_of(0, 0, 0);
}

static bool is_zero(ph_vec3 v) {
  return !(ph_vec3_dot(v, v) > 0);
}

/* The side of the line through edge k to which edge `other` points, or the one
 * known so far where that stays on the line. */
static ph_vec3 side_of(const struct polygon *p, size_t k, size_t other,
                       ph_vec3 so_far) {
  ph_vec3 u = edge_of(p, k).direction, v = edge_of(p, other).direction;
  ph_vec3 side = unit_or_zero(ph_vec3_normal(v, u));
  return is_zero(side) ? so_far : side;
}

/* The side to which a polygon goes on after it turned back at point j, as
 * tangents[j]; 0 where it stays on the line.  A closed one is gone round twice:
 * the first time finds the side with which the second one starts. */
static void set_sides_after(const struct polygon *p, ph_vec3 *tangents) {
  ph_vec3 side = {0, 0, 0};
  for (int turn = p->closed ? 2 : 1; turn > 0; turn--) {
    for (size_t j = p->n; j-- > 0;) {
      if (p->closed || j + 1 < p->edges) {
        side = side_of(p, j, j + 1, side);
      }
      if (turns_back(p, j)) {
        tangents[j] = side;
      }
    }
  }
}

/* The tangent at point j, from the sides before and after; 0 is none. */
static ph_vec3 sideways(const struct polygon *p, size_t j, ph_vec3 before,
                        ph_vec3 after) {
  ph_vec3 middle = unit_or_zero(ph_vec3_add(before, after));
  struct edge in, out;
  edges_at(p, j, &in, &out);
  return !is_zero(middle)   ? middle
         : !is_zero(before) ? before
                            : ph_vec3_any_normal(out.direction);
}

/* The tangents where the polygon turns back. */
static void set_sideways(const struct polygon *p, ph_vec3 *tangents) {
  ph_vec3 side = {0, 0, 0};
  set_sides_after(p, tangents);
  for (int turn = p->closed ? 2 : 1; turn > 0; turn--) {
    for (size_t j = 0; j < p->n; j++) {
      if (p->closed) {
        side = side_of(p, j + p->n - 1, (j + 2 * p->n - 2) % p->n, side);
      } else if (j >= 2) {
        side = side_of(p, j - 1, j - 2, side);
      }
      if (turn == 1 && turns_back(p, j)) {
        tangents[j] = sideways(p, j, side, tangents[j]);
      }
    }
  }
}

void ph_spatial_tangents(const double *points, size_t n, size_t dimension,
                         bool closed, ph_vec3 *tangents) {
  struct polygon p = polygon_of(points, n, dimension, closed);
  bool back = false;
  for (size_t j = 0; j < n; j++) {
    struct edge in, out;
    edges_at(&p, j, &in, &out);
    back |= !circle_tangent(in, out, &tangents[j]);
  }
  if (back) {
    set_sideways(&p, tangents);
  }
}
