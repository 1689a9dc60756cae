/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Curves of every kind, and offsets of them, by chance, to be sampled. */
#ifndef PH_TESTS_PLACES_DATA_H
#define PH_TESTS_PLACES_DATA_H

#include "curve_unit.h"
#include "spherical_unit.h"
#include "tc_curve_unit.h"

enum places_kind {
  PLACES_PH2,
  PLACES_ATPH2,
  PLACES_TC,
  PLACES_PH3,
  PLACES_ATPH3,
  PLACES_SPHERE,
  PLACES_BEZIER,
  PLACES_KINDS
};

/* A curve, and perhaps an offset of it. */
struct places_data {
  enum places_kind kind;
  struct ph_curve curve;
  bool has_offset;
  struct ph_offset offset; /* distance and vector, and cusps */
  struct unit_curve3 space;
  struct unit_cubics cubics;
  struct unit_spherical sphere;
  double points[12 * UNIT_CURVE3_MAX], preimage[6 * UNIT_CURVE3_MAX];
  struct ph_arena arena;
};

/* places_random: a curve of this kind of a few segments, of about unit size. */
void places_random(struct places_data *data, enum places_kind kind,
                   struct unit_random *r);

/* places_offset: an offset of it, too, but of a Bezier curve. */
void places_offset(struct places_data *data, struct unit_random *r);

/* places_reverse: the same curve, run through from its end. */
void places_reverse(struct places_data *data);

/* places_scale: the same curve, larger by 2^exponent. */
void places_scale(struct places_data *data, int exponent);

/* places_free: gives back its memory; NULL-safe after zeroing. */
void places_free(struct places_data *data);

#endif
