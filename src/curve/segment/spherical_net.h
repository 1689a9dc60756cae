/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A spherical Bezier segment prepared for many evaluations: what does not
 * depend on the parameter (spherical.c, where m, d, E, phi, Q are explained).
 */
#ifndef PH_CURVE_SEGMENT_SPHERICAL_NET_H
#define PH_CURVE_SEGMENT_SPHERICAL_NET_H

#include "curve/segment/spherical.h"

/* Two neighbouring control points. */
struct ph_spherical_arc {
  ph_vec3 mu, m, d; /* m as a displacement from p[0], and in full */
  double e;
  double square;    /* theta^2 */
  double a, b;      /* theta tan(phi), theta / tan(phi) */
  double q, ic, ig; /* far: Q, 1 / cos(phi), 1 / f_0(Q) */
};

struct ph_spherical_net {
  ph_vec3 base; /* p[0] */
  double e;     /* the greatest of the arcs */
  size_t terms; /* of the power series in E that suffice; 0: far */
  struct ph_spherical_arc arc[3];
};

void ph_spherical_net_of(const struct ph_spherical *s,
                         struct ph_spherical_net *net);
void ph_spherical_net_of_legs(const struct ph_spherical_legs *s,
                              struct ph_spherical_net *net);

/* ph_spherical_net_numerator: K(t) as of ph_spherical_numerator; _numerators:
 * K'(t), too */
double ph_spherical_net_numerator(const struct ph_spherical_net *net, double t);
void ph_spherical_net_numerators(const struct ph_spherical_net *net, double t,
                                 double k[2]);

/* ph_spherical_net_velocity: S'(t) */
ph_vec3 ph_spherical_net_velocity(const struct ph_spherical_net *net, double t);

/* ph_spherical_net_speed: |S'(t)| */
double ph_spherical_net_speed(const struct ph_spherical_net *net, double t);

#endif
