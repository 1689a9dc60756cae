/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Samples of a curve, as plain arrays (sample.h takes them). */
#ifndef PH_CURVE_SAMPLE_SAMPLES_H
#define PH_CURVE_SAMPLE_SAMPLES_H

#include <stddef.h>

/* Frames: X(SYMBOL, "name"), FIRST of the first. */
#define PH_FRAMES(FIRST, X) \
  FIRST(FRENET, "frenet")   \
  X(ERF, "erf")             \
  X(RMF, "rmf")

enum ph_frame {
  PH_FRAME_NONE,
#define X(symbol, name) PH_FRAME_##symbol,
  PH_FRAMES(X, X)
#undef X
      PH_FRAME_N
};

/*
 * Samples of a curve, or of a curve beside it, in the order of the parameter.
 *
 * segment[n], t[n]      the curve segment, and its local parameter: in [0,1],
 *                       atph: [0, alpha]
 * s[n]                  arc length from the start of what is sampled
 * point[n][dimension]   in the unit of the data
 * tangent[n][dimension] unit vectors
 * curvature[n]          signed in the plane, geodesic on the sphere; 1/unit
 * torsion[n]            in space; NULL in the plane and on the sphere
 * normal[n][3], binormal[n][3]  of the frame, if one was asked for; else NULL
 * lonlat[n][2]          degrees, seen from the center; NULL if on no sphere
 */
struct ph_samples {
  enum ph_frame frame;
  size_t n;
  size_t dimension;
  size_t *segment;
  double *t;
  double *s;
  double *point;
  double *tangent;
  double *curvature;
  double *torsion;
  double *normal;
  double *binormal;
  double *lonlat;
};

#endif
