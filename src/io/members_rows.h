/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the rows of members.c are written with: short names, and the types. */
#ifndef PH_IO_MEMBERS_ROWS_H
#define PH_IO_MEMBERS_ROWS_H

#include "io/members.h"

#include <stdint.h>

#define MAY PH_MAY
#define TOLD PH_TOLD
#define MUST PH_MUST

#define ANY PH_OF_ANY
#define ATPH PH_OF_ATPH
#define SQUARE PH_OF_SQUARE
#define CUBIC PH_OF_CUBIC
#define SPHERE PH_OF_SPHERE
#define FLAT PH_OF_FLAT
#define SPACE PH_OF_SPACE
#define RATIONAL PH_OF_RATIONAL
#define QUOTIENT PH_OF_QUOTIENT
#define TENSION PH_OF_TENSION
#define INTERVALS PH_OF_INTERVALS
#define LENGTHS PH_OF_LENGTHS
#define SURFACE PH_OF_SURFACE
#define CIRCULAR PH_OF_CIRCULAR
#define GENERAL PH_OF_GENERAL
#define DIRECTRIX PH_OF_DIRECTRIX
#define LOOPS PH_OF_LOOPS
#define RAW PH_OF_RAW

#define AS(sizes, type) sizes #type, &as_##type
#define APART          \
  NULL, {              \
    PH_AT, 0, 0, false \
  }
#define AT(type, member) \
  { PH_AT, offsetof(struct type, member), 0, false }
#define EACH(type, member) \
  { PH_EACH, offsetof(struct type, member), 0, false }
#define JOINED(type, member) \
  { PH_EACH, offsetof(struct type, member), 0, true }
#define LIST(type, member, n) \
  { PH_AT, offsetof(struct type, member), 1 + offsetof(struct type, n), false }
#define SELF(type, n) \
  { PH_AT, 0, 1 + offsetof(struct type, n), false }
#define ROW(name, need, of, type, what) \
  { name, need, of, type, APART, what }
#define LAST \
  { NULL, MAY, ANY, NULL, APART, NULL }

/* Types; most: SIZE_MAX, the last segment. */
#define TYPE(type, name, form, size, least, most)                           \
  static const struct ph_type as_##type = {name, PH_AS_##form, size, least, \
                                           most}
TYPE(number, "number", DOUBLE, sizeof(double), 0, 0);
TYPE(positive, "positive", DOUBLE, sizeof(double), 0, 0);
TYPE(radius, "radius", RADIUS, sizeof(double), 0, 0);
TYPE(knots, "knots", KNOTS, sizeof(double), 0, 0);
TYPE(index, "index", SIZE, sizeof(size_t), 0, SIZE_MAX);
TYPE(whole, "whole", SIZE, sizeof(size_t), 0, INT32_MAX);
TYPE(D, "D", SIZE, sizeof(size_t), 2, 3);
TYPE(continuity, "continuity", SIZE, sizeof(size_t), 0, 2);
TYPE(bidegree, "bidegree", SIZE, sizeof(size_t), 1, PH_BIDEGREE_MAX);
TYPE(degree, "degree", SIZE, sizeof(size_t), 1, PH_CLAIM_DEGREE_MAX);
TYPE(offset_degree, "offset_degree", SIZE, sizeof(size_t), 1,
     PH_CLAIM_DEGREE_MAX);
TYPE(range, "range", RANGE, 2 * sizeof(size_t), 0, SIZE_MAX);
TYPE(sign, "sign", SIGN, 1, 0, 0);
TYPE(flag, "flag", FLAG, sizeof(bool), 0, 0);
TYPE(text, "text", TEXT, sizeof(char *), 0, 0);
TYPE(vector, "vector", VECTOR, sizeof(char *), 0, 0);
TYPE(curve, "kind", ENUM, sizeof(enum ph_curve_kind), 0, 0);
TYPE(root, "root", ENUM, sizeof(enum ph_root), 0, 0);
TYPE(frame, "frame", ENUM, sizeof(enum ph_frame), PH_FRAME_NONE + 1, 0);
TYPE(outcome, "outcome", ENUM, sizeof(enum ph_outcome), 0, 0);
TYPE(open, "open", OPEN, sizeof(double), 0, 0);
TYPE(strip_method, "strip_method", ENUM, sizeof(enum ph_strip_method), 0, 0);
TYPE(case, "case", ENUM, sizeof(enum ph_pair_case), 0, 0);
TYPE(segment, "segment", SEGMENTS, 0, 0, 0);
TYPE(image, "image", IMAGES, 0, 0, 0);
TYPE(piece, "piece", PIECES, 0, 0, 0);
TYPE(bezier, "bezier", BEZIERS, 0, 0, 0);
TYPE(chain, "chain", LIST, 0, 0, 0);
TYPE(sample, "sample", SAMPLES, 0, 0, 0);
TYPE(interval, "interval", LIST, 0, 0, 0);
TYPE(joint, "joint", LIST, 0, 0, 0);
TYPE(joint_kind, "joint_kind", ENUM, sizeof(enum ph_joint_kind), 0, 0);
TYPE(solution, "solution", LIST, 0, 0, 0);
TYPE(offset, "offset", LIST, 0, 0, 0);
TYPE(cusp, "cusp", LIST, 0, 0, 0);
TYPE(loop, "loop", LIST, 0, 0, 0);
TYPE(loop_piece, "loop_piece", LIST, 0, 0, 0);
TYPE(trimming, "trimming", OBJECT, sizeof(struct ph_trimming), 0, 0);
TYPE(among, "among", AMONG, sizeof(size_t), 0, INT32_MAX);
TYPE(start, "start", LIST, 0, 0, 0);
TYPE(bounds, "bounds", BOUNDS, 0, 0, 0);
TYPE(strip, "strip", LIST, 0, 0, 0);
TYPE(pair, "pair", LIST, 0, 0, 0);
TYPE(flat_sample, "flat_sample", LIST, 0, 0, 0);
TYPE(patch, "patch", LIST, 0, 0, 0);
TYPE(beside, "beside", LIST, 0, 0, 0);
TYPE(patch_sample, "patch_sample", LIST, 0, 0, 0);
TYPE(patch_vertex, "patch_vertex", LIST, 0, 0, 0);
TYPE(patch_edge, "patch_edge", LIST, 0, 0, 0);
TYPE(patch_strip, "patch_strip", OBJECT, sizeof(struct ph_patch_strip), 0, 0);
TYPE(parallel, "parallel", LIST, 0, 0, 0);
TYPE(node, "node", LIST, 0, 0, 0);
TYPE(panorama, "panorama", OBJECT, sizeof(struct ph_panorama), 0, 0);
TYPE(located, "located", LIST, 0, 0, 0);
TYPE(strip_frame, "strip_frame", OBJECT, sizeof(struct ph_strip_frame), 0, 0);
TYPE(arc3, "arc3", OBJECT, sizeof(struct ph_arc3), 0, 0);
TYPE(arc2, "arc2", OBJECT, sizeof(struct ph_arc2), 0, 0);
TYPE(certificate, "certificate", CERTIFICATE, 0, 0, 0);
TYPE(diagnostics, "diagnostics", DIAGNOSTIC_SET, 0, 0, 0);
TYPE(warning, "warning", WARNING_LIST, 0, 0, 0);

#endif
