/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * What an offset of a whole plane curve is put together of: strands, in the
 * order of travel, each the offset of a segment at unit scale, or a join at a
 * corner or around an end.
 *
 * With w of a segment, r' = w^2, and n = i w / conj(w), all are one formula,
 *
 *   O = r + d n,  O' = (sigma - 2 d K / sigma) w / conj(w),               (1)
 *   sigma = |w|^2,  K = Im(conj(w) w'),
 *
 * where a join round a corner P has r = P, sigma := 0 in O', and w linear from
 * the root of the tangent before to that of the one after.  Its length from
 * place to place, signed, is the difference of s - d theta, theta = 2 arg w.
 * A line to the tip of a miter has O linear, and a constant w.
 *
 * Both sides of a curve at once are one side of it and of its reverse, which
 * then follows it: r(1 - u), with i w(1 - u).
 */
#ifndef PH_CURVE_OFFSET_STRAND_H
#define PH_CURVE_OFFSET_STRAND_H

#include "base/diag.h"
#include "base/mem.h"
#include "curve/offset/offset.h"
#include "curve/segment/seg3_fast.h"
#include "kernel/cplx.h"

#define PH_NO_STRAND SIZE_MAX

enum ph_strand_kind { PH_STRAND_SEGMENT, PH_STRAND_ROUND, PH_STRAND_LINE };

struct ph_strand {
  enum ph_strand_kind kind;
  bool passive;    /* it bounds others, and is no part of the offset */
  size_t at;       /* segment of strands->curve, or the corner before such a one
                      of the given curve */
  size_t next;     /* strand that goes on where it ends, or none */
  ph_cplx point;   /* the corner */
  ph_cplx w[2];    /* unit: round, at both ends; line: of its direction */
  ph_cplx line[2]; /* ends of a line */
  double angle;    /* by which the whole join turns; line: 0 */
};

/* All of them, with lengths in 2^exponent of those of the data, and points from
 * the center of their box. */
struct ph_strands {
  struct ph_curve curve; /* the given one, then maybe its reverse */
  size_t n;              /* segments of the given one */
  double distance;
  double size; /* the larger side of the box, and |distance| */
  ph_cplx center;
  int exponent;
  struct ph_strand *v;
  size_t strands_n;
  bool both;       /* all of one side of the curve and its reverse */
  bool has_inside; /* the curve is closed and does not meet itself, and of one
                      side what is kept is asked for */
  size_t *effort;  /* of the rules */
  struct ph_arena *arena;
};

/*
 * ph_strands_of: the strands of an offset.
 *
 * A joint is a corner if the offset jumps there by more than 1e-9 of the size;
 * on its outer side there is a join.
 *
 * in   crosses  the curve meets itself: of an offset to one side that is to be
 *               trimmed, the other side bounds it
 * ret  PH_OK | PH_E_BAD_VALUE (the distance is nothing beside the size) |
 *      PH_E_TOO_LARGE (its square exceeds the range of a double) |
 *      PH_E_NO_MEMORY
 */
enum ph_status ph_strands_of(const struct ph_curve *curve, double distance,
                             const struct ph_offset_rules *rules, bool crosses,
                             struct ph_arena *arena, struct ph_strands *strands,
                             struct ph_diag *diag);

/* ph_strand_foot: the place of the given curve from which u of a strand is.
 * ret  the segment; of joins the one that follows */
size_t ph_strand_foot(const struct ph_strands *strands, size_t strand, double u,
                      double *foot);

/* A strand prepared for places. */
struct ph_strand_eval {
  const struct ph_strand *of;
  double distance;
  double whole; /* the arc length of the segment, as `fast` scales it */
  struct ph_fast3 fast;
};

struct ph_spot {
  ph_cplx r, o, w; /* the foot, the place, and w at a scale of its own */
  double s;        /* arc length of the curve, from u = 0 of the segment; of a
                      line, its own */
  double speed;    /* sigma */
  double bend;     /* theta' */
  double rate;     /* of O' along w / conj(w) */
};

/* ph_strand_enter: prepares a strand, unless it is prepared already. */
void ph_strand_enter(struct ph_strand_eval *eval,
                     const struct ph_strands *strands, size_t strand);

/* ph_strand_spot: the place at u in [0,1]. */
struct ph_spot ph_strand_spot(const struct ph_strand_eval *eval, double u);

/* ph_spot_turn: by how much the tangent turns between two places that are less
 * than a half turn apart. */
static inline double ph_spot_turn(const struct ph_spot *a,
                                  const struct ph_spot *b) {
  return 2 * ph_cplx_angle(a->w, b->w);
}

/* ph_spot_angle: the angle between the tangents of any two places: the root w
 * of a tangent has either sign. */
static inline double ph_spot_angle(const struct ph_spot *a,
                                   const struct ph_spot *b) {
  const double cross = ph_cplx_cross(a->w, b->w), dot = ph_cplx_dot(a->w, b->w);
  return 2 * (dot < 0 ? atan2(-cross, -dot) : atan2(cross, dot));
}

/* ph_spot_length: the signed length between these. */
static inline double ph_spot_length(double distance, const struct ph_spot *a,
                                    const struct ph_spot *b) {
  return b->s - a->s - distance * ph_spot_turn(a, b);
}

/* ph_spot_tangent: the unit tangent of the curve. */
static inline ph_cplx ph_spot_tangent(const struct ph_spot *a) {
  return ph_cplx_scale(1 / ph_cplx_norm2(a->w), ph_cplx_mul(a->w, a->w));
}

/* ph_spot_normal: the left one. */
static inline ph_cplx ph_spot_normal(const struct ph_spot *a) {
  const ph_cplx t = ph_spot_tangent(a);
  return ph_cplx_of(-t.im, t.re);
}

#endif
