/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What is made of a surface (see grid.h). */
#include "curve/surface/grid.h"

#include "curve/surface/general.h"
#include "curve/surface/ruling.h"

#include <math.h>
#include <string.h>

/* ---- samples ------------------------------------------------------------- */

size_t ph_grid_across(const struct ph_curve *curve,
                      const struct ph_grid_rules *rules) {
  const double *height = curve->surface.height;
  return !(height[1] > height[0]) ? 0 : rules->across ? rules->across : 1;
}

/* The samples of one ruling. */
static struct ph_surface_sample *add_ruling(const struct ph_curve *curve,
                                            size_t i, double u, size_t across,
                                            struct ph_surface_sample *to) {
  const struct ph_surface *surface = &curve->surface;
  const struct ph_strip *strip = &surface->strips[i];
  const double *height = surface->height;
  const struct ph_ruling r = ph_ruling_at(strip, u);
  for (size_t j = 0; j <= across; j++, to++) {
    const double part = across ? (double)j / (double)across : 0;
    const double h = ph_strip_height(
        surface, strip, height[0] + part * (height[1] - height[0]), u);
    to->strip = i;
    to->s = r.s;
    to->h = h;
    ph_vec3_put(ph_ruling_point(&r, h), 3, to->point);
    ph_vec3_put(r.at.n, 3, to->normal);
    ph_ruling_flat(&r, h, to->flat);
  }
  return to;
}

enum ph_status ph_grid_of(const struct ph_curve *curve,
                          const struct ph_grid_rules *rules,
                          struct ph_arena *arena,
                          struct ph_surface_samples *grid,
                          struct ph_diag *diag) {
  const size_t across = ph_grid_across(curve, rules);
  const double wanted =
      (double)curve->n * ((double)rules->along + 1) * ((double)across + 1);
  struct ph_surface_sample *to;
  if (!(wanted <= (double)rules->most)) {
    return ph_fail(diag, PH_E_LIMIT, NULL,
                   "the surface would have %.0f samples, more than the %zu of "
                   "--max-samples",
                   wanted, rules->most);
  }
  grid->n = curve->n * (rules->along + 1) * (across + 1);
  grid->v = ph_arena_array(arena, grid->n, sizeof *grid->v);
  if (!grid->v) {
    return ph_fail_memory(diag);
  }
  to = grid->v;
  for (size_t i = 0; i < curve->n; i++) {
    for (size_t j = 0; j <= rules->along; j++) {
      to = add_ruling(curve, i, (double)j / (double)rules->along, across, to);
    }
  }
  return PH_OK;
}

/* ---- parallel surfaces --------------------------------------------------- */

static void move(const struct ph_strip *from, double distance, double factor,
                 struct ph_strip *to) {
  const struct ph_strip_place end = ph_strip_end(from);
  const double chord = from->length * ph_sinc(from->sweep / 2);
  double at[3];
  *to = *from;
  for (size_t i = 0; i < 3; i++) {
    to->frame.point[i] += distance * from->frame.normal[i];
  }
  to->k = from->k / factor;
  to->kn = from->kn / factor;
  to->length = from->length * factor;
  ph_vec3_put(ph_vec3_along(end.c, distance, end.n), 3, at);
  ph_strip_describe(to, at, chord * factor, from->contact.weights[1]);
}

enum ph_status ph_parallel_of(const struct ph_curve *curve, double distance,
                              struct ph_arena *arena,
                              struct ph_parallel *parallel,
                              struct ph_diag *diag) {
  struct ph_curve *c = &parallel->curve;
  memset(parallel, 0, sizeof *parallel);
  parallel->distance = distance;
  *c = *curve;
  c->surface.strips = ph_arena_array(arena, c->n, sizeof *c->surface.strips);
  c->lengths = ph_arena_array(arena, c->n, sizeof *c->lengths);
  if (!c->surface.strips || !c->lengths) {
    return ph_fail_memory(diag);
  }
  for (size_t i = 0; i < c->n; i++) {
    const struct ph_strip *strip = &curve->surface.strips[i];
    const double factor = 1 - strip->kn * distance;
    if (strip->directrix) {
      const enum ph_status status = ph_general_beside(
          curve, i, distance, arena, &c->surface.strips[i], diag);
      if (status != PH_OK) {
        return status;
      }
      continue;
    }
    if (!(factor > 0)) {
      return ph_fail_at(diag, PH_E_INFEASIBLE, "strips", i,
                        "has no parallel surface at the distance %g: its "
                        "radius of normal curvature is %g",
                        distance, 1 / strip->kn);
    }
    move(strip, distance, factor, &c->surface.strips[i]);
  }
  ph_develop(c);
  ph_surface_measure(c);
  return PH_OK;
}

/* ---- paths of the development -------------------------------------------- */

/* The end of a contact curve. */
static ph_vec3 end_of(const struct ph_strip *strip) {
  return strip->directrix ? ph_general_ruling(strip, 1).at.c
                          : ph_vec3_get(strip->contact.control_points[2], 3);
}

double ph_surface_size(const struct ph_curve *curve) {
  const struct ph_strip *strips = curve->surface.strips;
  double sum = 0, end[3];
  ph_vec3_put(end_of(&strips[curve->n - 1]), 3, end);
  for (size_t j = 0; j < 3; j++) {
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (size_t i = 0; i <= curve->n; i++) {
      const double x = i < curve->n ? strips[i].frame.point[j] : end[j];
      low = x < low ? x : low;
      high = x > high ? x : high;
    }
    sum = hypot(sum, high / 2 - low / 2);
  }
  return sum;
}

/* Steps of an edge of one strip: fewer than this are more than enough, but
 * where heights are millions of times as large as the rest. */
static const double STEPS_MAX = 1e4;

/* A path in the making. */
struct path {
  const struct ph_curve *curve;
  double tolerance;
  double *to; /* NULL: pieces are counted alone */
  size_t n;
};

/* A point of the development, and its derivative along an edge. */
struct knot {
  double at[2], by[2];
};

/* That of a circular strip, by the arc length. */
static struct knot circular_knot(const struct ph_surface *surface,
                                 const struct ph_strip *strip, size_t edge,
                                 double u) {
  const double height = surface->height[edge];
  const double h = ph_strip_height(surface, strip, height, u);
  const double slope = (ph_strip_height(surface, strip, height, 1) -
                        ph_strip_height(surface, strip, height, 0)) /
                       strip->length;
  const struct ph_flat_place start = ph_flat_start(strip);
  const struct ph_flat_place flat =
      ph_flat_at(&start, strip->k, u * strip->length);
  const double x = -sin(flat.angle), y = cos(flat.angle), q = 1 - strip->k * h;
  return (struct knot){{flat.c[0] + h * x, flat.c[1] + h * y},
                       {q * y + slope * x, -q * x + slope * y}};
}

/* A point of an edge; of a general strip by its parameter in [0,1]. */
static struct knot knot_at(const struct path *path,
                           const struct ph_strip *strip, size_t edge,
                           double u) {
  const struct ph_surface *surface = &path->curve->surface;
  if (strip->directrix) {
    struct knot knot = {{0, 0}, {0, 0}};
    ph_general_edge(strip, u, surface->height[edge], knot.at, knot.by);
    return knot;
  }
  return circular_knot(surface, strip, edge, u);
}

/* A piece by its ends and its derivatives, over a step; 0: a line. */
static void add_piece(struct path *path, const struct knot *from,
                      const struct knot *to, double step) {
  if (path->to) {
    double *p = path->to + 8 * path->n;
    for (size_t j = 0; j < 2; j++) {
      const double line = to->at[j] - from->at[j];
      const bool curved = fabs(step) > 0;
      p[j] = from->at[j];
      p[2 + j] = from->at[j] + (curved ? step * from->by[j] : line) / 3;
      p[4 + j] = to->at[j] - (curved ? step * to->by[j] : line) / 3;
      p[6 + j] = to->at[j];
    }
  }
  path->n++;
}

/* Whether n cubics leave the edge of a general strip by less than the
 * tolerance, in their middles. */
static bool are_near(const struct path *path, const struct ph_strip *strip,
                     size_t edge, double n) {
  struct knot from = knot_at(path, strip, edge, 0);
  for (double i = 1; i <= n; i++) {
    const struct knot to = knot_at(path, strip, edge, i / n);
    const struct knot middle = knot_at(path, strip, edge, (i - 0.5) / n);
    double off[2];
    for (size_t j = 0; j < 2; j++) {
      off[j] = (from.at[j] + to.at[j]) / 2 + (from.by[j] - to.by[j]) / (8 * n) -
               middle.at[j];
    }
    if (!(hypot(off[0], off[1]) <= path->tolerance)) {
      return false;
    }
    from = to;
  }
  return true;
}

/* As many pieces as cubics by Hermite data need: a step s leaves the edge by
 * less than s^4/384 of its fourth derivative; of general strips, as are seen to
 * be enough. */
static double general_steps(const struct path *path,
                            const struct ph_strip *strip, size_t edge) {
  double n = 4;
  while (n < STEPS_MAX && !are_near(path, strip, edge, n)) {
    n *= 2;
  }
  return n;
}

static double steps_of(const struct path *path, const struct ph_strip *strip) {
  const double k = fabs(strip->k), l = strip->length;
  double h[2][2], far = 0, fourth;
  ph_strip_corners(&path->curve->surface, strip, h);
  for (size_t i = 0; i < 4; i++) {
    far = fmax(far, fabs(h[i >> 1][i & 1]));
  }
  fourth = k * l * (k * l) * (k * l) *
           (l * (1 + k * far) + 4 * fabs(strip->shift[1] - strip->shift[0]));
  fourth = sqrt(sqrt(fourth / 384 / path->tolerance));
  return fourth < STEPS_MAX ? ceil(fmax(1, fourth)) : STEPS_MAX;
}

/* An edge of a strip, forward or backward. */
static void add_edge(struct path *path, const struct ph_strip *strip,
                     size_t edge, bool backward) {
  const bool general = strip->directrix;
  const double n =
      general ? general_steps(path, strip, edge) : steps_of(path, strip);
  const double step = (backward ? -1 : 1) * (general ? 1 : strip->length) / n;
  struct knot from = knot_at(path, strip, edge, backward ? 1 : 0);
  for (double i = 1; i <= n; i++) {
    const struct knot to =
        knot_at(path, strip, edge, backward ? (n - i) / n : i / n);
    add_piece(path, &from, &to, step);
    from = to;
  }
}

static void add_line(struct path *path, const struct ph_strip *strip, double u,
                     size_t edge) {
  const struct knot from = knot_at(path, strip, edge, u);
  const struct knot to = knot_at(path, strip, 1 - edge, u);
  add_piece(path, &from, &to, 0);
}

static bool has_outline(const struct ph_curve *curve) {
  return curve->surface.height[1] > curve->surface.height[0];
}

size_t ph_flat_rulings(const struct ph_curve *curve) {
  return has_outline(curve) ? curve->n - 1 : 0;
}

static void add_all(struct path *path) {
  const struct ph_curve *c = path->curve;
  const struct ph_strip *strips = c->surface.strips;
  for (size_t i = 0; i < c->n; i++) {
    add_edge(path, &strips[i], 0, false);
  }
  if (!has_outline(c)) {
    return;
  }
  add_line(path, &strips[c->n - 1], 1, 0);
  for (size_t i = c->n; i-- > 0;) {
    add_edge(path, &strips[i], 1, true);
  }
  add_line(path, &strips[0], 0, 1);
  for (size_t i = 1; i < c->n; i++) {
    add_line(path, &strips[i], 0, 0);
  }
}

/* Where pieces follow one another, but for rounding, to the last bit. */
static void join(double *p, size_t n, double near) {
  for (size_t i = 1; i < n; i++) {
    double *end = p + 8 * i - 2, *start = p + 8 * i;
    if (hypot(start[0] - end[0], start[1] - end[1]) <= near) {
      memcpy(start, end, 2 * sizeof *p);
    }
  }
}

enum ph_status ph_flat_paths(const struct ph_curve *curve, double tolerance,
                             struct ph_arena *arena, struct ph_pieces *out,
                             struct ph_diag *diag) {
  struct path path = {curve, tolerance, NULL, 0};
  add_all(&path);
  *out = (struct ph_pieces){.degree = 3, .dimension = 2, .n = path.n};
  out->control_points =
      ph_arena_array(arena, path.n, 8 * sizeof *out->control_points);
  if (!out->control_points) {
    return ph_fail_memory(diag);
  }
  path.to = out->control_points;
  path.n = 0;
  add_all(&path);
  join(out->control_points, out->n, tolerance);
  return PH_OK;
}
