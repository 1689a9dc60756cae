/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Curve kinds: what is asked of each, and what each can do.
 *
 * A kind is a file here that exports one const struct ph_kind, and a row in
 * PH_CURVES (curve/result.h).  Nobody else asks a curve which kind it is: what
 * depends on the kind is a question in this struct.  A new kind supplies
 *
 *   what it is     parts, on_sphere, bernstein, angles, erf: see below
 *   curve          its sampler: places, tangents, curvatures, arc lengths and
 *                  bounds of chords.  Samples of every choice, cubics, figures
 *                  and tables come of it.
 *   beside         the same of its offsets
 *   reference, turn, principal
 *                  what frames in space are made of; none of a kind that is in
 *                  the plane only
 *   offset         its offsets, with cusps, gaps, samples; offsets_n, how many
 *   bezier         itself as polynomial Bezier curves
 *
 * and, of numbers that only it has, a struct in struct ph_curve, written and
 * read as members of records by their rows in io/members.c.
 */
#ifndef PH_CURVE_KIND_KIND_H
#define PH_CURVE_KIND_KIND_H

#include "curve/bezier/convert.h"
#include "curve/offset/offset.h"
#include "curve/sample/sample.h"

/* A sampler of curves, or of offsets (sample.h, whose functions of the same
 * names say what these do). */
struct ph_sampler_ops {
  /* begin: allocates sampler->state. */
  enum ph_status (*begin)(struct ph_sampler *sampler, struct ph_diag *diag);
  /* enter: sampler->k is set; fills the state and sampler->length. */
  enum ph_status (*enter)(struct ph_sampler *sampler, struct ph_diag *diag);
  struct ph_sample (*at)(const struct ph_sampler *sampler, double u);
  double (*length)(const struct ph_sampler *sampler, double u, double *speed);
  double (*chord_bound)(const struct ph_sampler *sampler, double u0, double u1);
  /* at_each: the same, to the last bit, at n places, in less time; NULL: by
   * `at', one after the other. */
  void (*at_each)(const struct ph_sampler *sampler, const double *u, size_t n,
                  struct ph_sample *samples);
};

struct ph_kind {
  enum ph_parts parts; /* but segments: a surface, and nothing below */
  bool on_sphere;      /* curve->sphere says which; offsets are samples alone */
  bool bernstein;      /* control points are those of Bezier curves */
  bool cubic;          /* they are four points of the plane, with preimages of
                          degree 1 (curve/segment/tc.h) */
  bool angles;         /* the preimages have angles: alpha */
  bool erf;            /* the reference is the Euler-Rodrigues frame */
  const char *no_erf;  /* else: why there is none, as a message says it */
  const char *cusp;    /* where its offsets have cusps, as a warning says it */

  struct ph_sampler_ops curve, beside;

  /* reference: a frame that is smooth in a segment; e[0] is the tangent. */
  void (*reference)(const struct ph_sampler *sampler, double u, ph_vec3 e[3]);
  /* turn: e2' . e3 of it, and 1, of a const struct ph_sampler; NULL: the
   * reference is rotation-minimising. */
  double (*turn)(const void *sampler, double u);
  /* principal: the principal normal at a sample; NaN where there is none. */
  ph_vec3 (*principal)(const struct ph_sampler *sampler, double u,
                       const struct ph_sample *sample);

  size_t offsets_n[2]; /* offsets at one distance, in the plane and in space */
  /* offset: these, as ph_offset; NULL: there are none. */
  ph_offset_fn *offset;
  /* bezier: as ph_bezier_curve; NULL: it has no such form. */
  ph_bezier_fn *bezier;
};

#define X(symbol, kind, name) extern const struct ph_kind ph_kind_##kind;
PH_CURVES(X)
#undef X

/* The kinds by enum ph_curve_kind. */
extern const struct ph_kind *const ph_kinds[PH_CURVE_N];

static inline const struct ph_kind *ph_kind_of(const struct ph_curve *curve) {
  return ph_kinds[curve->kind];
}

/* ph_kind_space: where curves of a kind lie that have so many coordinates. */
static inline enum ph_space ph_kind_space(const struct ph_kind *kind,
                                          size_t dimension) {
  return kind->parts == PH_STRIPS_PARTS    ? PH_SURFACE
         : kind->parts == PH_PATCHES_PARTS ? PH_PATCHWORK
         : kind->on_sphere                 ? PH_SPHERE
         : dimension == 3                  ? PH_SPACE
                                           : PH_PLANE;
}

/* ph_kind_offsets: how many offsets such a curve has at one distance. */
static inline size_t ph_kind_offsets(const struct ph_kind *kind,
                                     size_t dimension) {
  return kind->offsets_n[dimension - 2];
}

#endif
