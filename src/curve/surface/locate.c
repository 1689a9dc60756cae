/* SPDX-License-Identifier: GPL-3.0-or-later */
/* From the development to the surface (see locate.h). */
#include "curve/surface/locate.h"

#include "curve/surface/general.h"
#include "curve/surface/ruling.h"
#include "kernel/pi.h"

#include <math.h>
#include <string.h>

/* Of coordinates: the development of many strips is off by more than one
 * rounding. */
static const double NEAR = 1e-12;

/* Rulings of a strip by which its box is found; strips that share a box. */
enum { PROBES = 8, PROBES_GENERAL = 128, BLOCK = 32 };

/* ---- boxes --------------------------------------------------------------- */

static void extend(struct ph_flat_box *box, const double p[2], double by) {
  for (size_t j = 0; j < 2; j++) {
    box->low[j] = fmin(box->low[j], p[j] - by);
    box->high[j] = fmax(box->high[j], p[j] + by);
  }
}

/* Of a general strip: between two rulings a, b with the contact curve's length
 * L between them, the distance rho from the vertex is from (a + b - L) / 2 to
 * (a + b + L) / 2, and arcs about the vertex leave their chords by less than an
 * eighth of the square of the angle. */
static struct ph_flat_box general_box(const struct ph_surface *surface,
                                      const struct ph_strip *strip) {
  const struct ph_directrix *d = strip->directrix;
  struct ph_flat_box box = {{HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, -HUGE_VAL}};
  struct ph_ruling from = ph_general_ruling(strip, 0);
  for (int i = 1; i <= PROBES_GENERAL; i++) {
    const struct ph_ruling to =
        ph_general_ruling(strip, (double)i / PROBES_GENERAL);
    const double a = -1 / from.k, b = -1 / to.k; /* with the sign of `side' */
    const double length = d->side * (to.s - from.s);
    const double turn = to.flat.angle - from.flat.angle;
    for (size_t corner = 0; corner < 8; corner++) {
      const struct ph_ruling *at = corner & 1 ? &to : &from;
      const double rho = (a + b + (corner & 2 ? length : -length)) / 2;
      const double h = surface->height[corner >> 2];
      double p[2];
      ph_ruling_flat(at, rho - (corner & 1 ? b : a) + h, p);
      extend(&box, p, turn * turn / 8 * fabs(rho + h));
    }
    from = to;
  }
  return box;
}

/* An edge leaves its chord by less than it turns in between, times its length,
 * which is that of the chord but for what the turn makes of it. */
static struct ph_flat_box box_of(const struct ph_surface *surface,
                                 const struct ph_strip *strip) {
  struct ph_flat_box box = {{HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, -HUGE_VAL}};
  double from[2][2] = {{0, 0}, {0, 0}}, angle = 0;
  for (int i = 0; i <= PROBES; i++) {
    const double u = (double)i / PROBES;
    const struct ph_ruling r = ph_ruling_at(strip, u);
    for (size_t edge = 0; edge < 2; edge++) {
      double p[2], chord;
      ph_ruling_flat(
          &r, ph_strip_height(surface, strip, surface->height[edge], u), p);
      chord = i ? hypot(p[0] - from[edge][0], p[1] - from[edge][1]) : 0;
      extend(&box, p, fabs(r.flat.angle - angle) * 2 * chord);
      memcpy(from[edge], p, sizeof p);
    }
    angle = r.flat.angle;
  }
  return box;
}

struct ph_flat_box *ph_flat_boxes(const struct ph_curve *curve,
                                  struct ph_arena *arena, double *near) {
  struct ph_flat_box *box = ph_arena_array(arena, curve->n, sizeof *box);
  double size = 0;
  for (size_t i = 0; box && i < curve->n; i++) {
    const struct ph_strip *strip = &curve->surface.strips[i];
    box[i] = (strip->directrix ? general_box : box_of)(&curve->surface, strip);
    for (size_t j = 0; j < 2; j++) {
      size = fmax(size, fmax(-box[i].low[j], box[i].high[j]));
    }
  }
  *near = NEAR * size;
  for (size_t i = 0; box && i < curve->n; i++) {
    const struct ph_flat_box own = box[i];
    extend(&box[i], own.low, *near);
    extend(&box[i], own.high, *near);
  }
  return box;
}

/* ---- places -------------------------------------------------------------- */

/* Whether s and h, at the factor q = 1 - k h, are on a strip, to which s is
 * then moved. */
static bool is_within(const struct ph_surface *surface,
                      const struct ph_strip *strip, double q, double near,
                      double *s, double h) {
  const double to = fmin(fmax(*s, 0), strip->length);
  const double u = to / strip->length;
  const bool within = fabs(q * (*s - to)) <= near;
  *s = to;
  return within &&
         h >= ph_strip_height(surface, strip, surface->height[0], u) - near &&
         h <= ph_strip_height(surface, strip, surface->height[1], u) + near;
}

/*
 * With x along the tangent at the start and y along the ruling,
 *
 *   k x = q sin(k s),  1 - k y = q cos(k s),  q = 1 - k h
 *
 * where q may be of either sign, on the two sides of the vertex, and k s up to
 * a whole turn.
 */
static bool locate(const struct ph_surface *surface,
                   const struct ph_strip *strip, const double flat[2],
                   double near, double *s, double *h) {
  const struct ph_flat_place start = ph_flat_start(strip);
  const double dx = flat[0] - start.c[0], dy = flat[1] - start.c[1];
  const double c = cos(start.angle), sine = sin(start.angle), k = strip->k;
  const double x = c * dx + sine * dy, y = c * dy - sine * dx;
  const double r = hypot(k * x, 1 - k * y);
  if (!(fabs(k) > 0)) {
    *s = x;
    *h = y;
    return is_within(surface, strip, 1, near, s, *h);
  }
  for (int side = 1; side >= -1; side -= 2) {
    const double angle = atan2(side * k * x, side * (1 - k * y));
    *h = side > 0 ? (2 * y - (k * x * x + k * y * y)) / (1 + r) : (1 + r) / k;
    for (int turn = -1; turn <= 1; turn++) {
      *s = (angle + 2 * PH_PI * turn) / k;
      if (is_within(surface, strip, r, near, s, *h)) {
        return true;
      }
    }
  }
  return false;
}

bool ph_strip_locate(const struct ph_curve *curve, size_t i,
                     const double flat[2], double near,
                     struct ph_surface_sample *at) {
  const struct ph_strip *strip = &curve->surface.strips[i];
  struct ph_ruling r;
  double u;
  if (strip->directrix) {
    if (!ph_general_locate(strip, curve->surface.height, flat, near, &u,
                           &at->h)) {
      return false;
    }
    r = ph_general_ruling(strip, u);
    at->s = r.s;
  } else if (locate(&curve->surface, strip, flat, near, &at->s, &at->h)) {
    r = ph_ruling_at(strip, at->s / strip->length);
  } else {
    return false;
  }
  at->strip = i;
  ph_vec3_put(ph_ruling_point(&r, at->h), 3, at->point);
  ph_vec3_put(r.at.n, 3, at->normal);
  memcpy(at->flat, flat, sizeof at->flat);
  return true;
}

/* ---- all points ---------------------------------------------------------- */

/* The boxes of strips, and of blocks of these. */
struct finder {
  const struct ph_curve *curve;
  const struct ph_flat_box *box;
  struct ph_flat_box *block;
  double near;
};

static bool find(const struct finder *f, const double flat[2],
                 struct ph_surface_sample *at) {
  for (size_t i = 0; i < f->curve->n; i++) {
    if (i % BLOCK == 0 && !ph_flat_has(&f->block[i / BLOCK], flat)) {
      i += BLOCK - 1;
    } else if (ph_flat_has(&f->box[i], flat) &&
               ph_strip_locate(f->curve, i, flat, f->near, at)) {
      return true;
    }
  }
  return false;
}

enum ph_status ph_surface_locate(const struct ph_curve *curve,
                                 const double (*flat)[2], size_t n,
                                 struct ph_arena *arena,
                                 struct ph_located_list *list,
                                 struct ph_diag *diag) {
  struct finder f = {.curve = curve};
  f.box = ph_flat_boxes(curve, arena, &f.near);
  f.block = ph_arena_array(arena, curve->n / BLOCK + 1, sizeof *f.block);
  list->v = ph_arena_array(arena, n, sizeof *list->v);
  list->n = 0;
  if (!f.box || !f.block || !list->v) {
    return ph_fail_memory(diag);
  }
  for (size_t i = 0; i < curve->n; i++) {
    if (i % BLOCK == 0) {
      f.block[i / BLOCK] = f.box[i];
    }
    extend(&f.block[i / BLOCK], f.box[i].low, 0);
    extend(&f.block[i / BLOCK], f.box[i].high, 0);
  }
  for (size_t i = 0; i < n; i++) {
    if (ph_arena_late(arena)) {
      return ph_fail_memory(diag);
    }
    if (find(&f, flat[i], &list->v[list->n].at)) {
      list->v[list->n++].index = i;
    }
  }
  return PH_OK;
}
