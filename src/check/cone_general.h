/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * What the checks of strips of general cones share (cone.h): all follows from
 * the control points of the directrix and the vertex.  With w = r - v, the
 * frame has the ruling e = +-w / |w|, and the tangent plane of w and r';
 * rulings turn about v by
 *
 *   phi' = |w x r'| / |w|^2, and on the unit sphere the tangents of w / |w| by
 *   turn' = |[w, r', r'']| |w| / |w x r'|^2.
 */
#ifndef PH_CHECK_CONE_GENERAL_H
#define PH_CHECK_CONE_GENERAL_H

#include "check/cone.h"

/* A surface, and the strip of it that is looked at. */
struct ph_check_general {
  struct ph_check *v;
  const struct ph_curve *curve; /* with the control points of its strips */
  struct ph_check_segment s;    /* of strip k: */
  size_t k;
  ph_vec3 vertex;
  double side;   /* 1: rulings point away from the vertex */
  double u, phi; /* the last place that was asked for */
};

/* A place of its directrix. */
struct ph_check_general_seen {
  struct ph_check_frame f;
  ph_vec3 w, jet[2];
  double rho, rate, turn; /* |w|, phi' and the turn, with its sign */
  double doubt;           /* of the directions, by rounding */
};

/* The contact point at a place in the development. */
struct ph_check_general_flat {
  double x, y, angle, turn; /* of the tangent, and since the start */
};

/* Of all strips. */
struct ph_check_general_totals {
  double inflections, area, inside;
  bool clear;
};

/* ph_check_general_strip: strip k, as it is told. */
static inline const struct ph_strip *
ph_check_general_strip(const struct ph_check_general *g, size_t k) {
  return &g->curve->surface.strips[k];
}

static inline struct ph_check_where ph_check_general_where(size_t i,
                                                           const char *member) {
  return ph_check_of("strips", i, member);
}

/* ph_check_general_load: strip k is looked at from now on. */
void ph_check_general_load(struct ph_check_general *g, size_t k);

/* ph_check_general_place_at: the place u in [0,1]. */
struct ph_check_general_seen
ph_check_general_place_at(const struct ph_check_general *g, double u);

/* ph_check_general_integral: of a function of u, whose context is g, over
 * [from,to], to 1e-13 of it.  tolerance: what may be missed besides, for each 1
 * of u: of areas a part of theirs; of the angle of rulings what rounding makes
 * of it; of the turn, which is held against pi, a part of the radian. */
double ph_check_general_integral(const struct ph_check_general *g,
                                 ph_check_integrand *f, double tolerance,
                                 double from, double to);

/* ph_check_general_phi: the angle by which rulings turn over [from,to]. */
double ph_check_general_phi(const struct ph_check_general *g, double from,
                            double to);

/* ph_check_general_flat_at: a place laid flat; places are asked for in order,
 * as a rule. */
struct ph_check_general_flat
ph_check_general_flat_at(struct ph_check_general *g,
                         const struct ph_check_general_seen *at, double u);

/* ph_check_general_flat_rounding: the rounding of points of a development at
 * the distance rho from the vertex. */
double ph_check_general_flat_rounding(const struct ph_check_general *g,
                                      const struct ph_check_general_flat *flat,
                                      double rho);

/* ph_check_general_flat_distance: of a point in the unit of the record from a
 * place. */
double ph_check_general_flat_distance(const struct ph_check_general *g,
                                      const double *point,
                                      const struct ph_check_general_flat *flat);

/* ph_check_general_turn: the turn of the strip, its inflections, and that it is
 * no loop.
 */
void ph_check_general_turn(struct ph_check_general *g,
                           struct ph_check_general_totals *totals);

/* ph_check_general_height: area, and vertices within the height. */
void ph_check_general_height(struct ph_check_general *g,
                             struct ph_check_general_totals *totals);

/* ph_check_general_beside: surfaces at a distance. */
void ph_check_general_beside(struct ph_check_general *g);

/* ph_check_general_panorama: the panorama.
 * ret  PH_OK | PH_E_NO_MEMORY */
enum ph_status ph_check_general_panorama(struct ph_check_general *g);

/* ph_check_general_told: what a record says besides. */
void ph_check_general_told(struct ph_check_general *g,
                           const struct ph_check_general_totals *totals);

#endif
