/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Surfaces as plain structs (curve/result.h has them in its curves, whose kind
 * then says that it is a surface): of patches, or developable ones of strips.
 *
 * A circular strip is a piece of a cone, of a cylinder or of a plane: a frame
 * of a point c, a ruling e, a tangent d and a normal n = e x d moves along a
 * curve of the surface, the contact curve, by its arc length s, with constant
 * geodesic curvature k and normal curvature kn:
 *
 *   c' = d,  d' = k e + kn n,  e' = -k d,  n' = -kn d         [GON18, ch. 4]
 *   X(s, h) = c(s) + h e(s)
 *
 * so that the contact curve is an arc of a circle, the vertex is at h = 1/k,
 * and nothing is singular where k or kn is 0.  The development, in the plane,
 * has c' = d, d' = k e, e' = -k d with e to the left of d.
 *
 * A general strip is a piece of the cone of a vertex v over a contact curve r,
 * the directrix, which is a segment of an ATPH curve: the curve that the
 * surface is in has its control points and preimage.  With w = r - v and
 * rho = |w|, its frame is
 *
 *   e = +- w / rho,  d = the direction of r' - (r'.e) e,  n = e x d,
 *
 * its rulings turn about v by phi, phi' = |w x r'| / rho^2, and the contact
 * curve of the development is at v + rho (cos phi, sin phi).
 *
 * Two strips in a row, a pair, lead from one contact element of the data to the
 * next one.  The frame at the start of the first has the ruling of the element,
 * but its point is elsewhere on it: by `shift' along the ruling from the point
 * that is given.  Heights are those from the given points: the height H is at
 * h = H - shift(s), and shift(s) is linear in s between both elements.
 */
#ifndef PH_CURVE_SURFACE_SURFACE_H
#define PH_CURVE_SURFACE_SURFACE_H

#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* What a curve or surface consists of: X(SYMBOL, "members of records"). */
#define PH_PARTS(X)       \
  X(SEGMENTS, "segments") \
  X(STRIPS, "strips")     \
  X(PATCHES, "patches")

enum ph_parts {
#define X(symbol, name) PH_##symbol##_PARTS,
  PH_PARTS(X)
#undef X
      PH_PARTS_N
};

/* How a strip was found: X(SYMBOL, "name in records"). */
#define PH_STRIP_METHODS(X) \
  X(CIRCULAR, "circular")   \
  X(ATPH, "atph")

enum ph_strip_method {
#define X(symbol, name) PH_STRIP_##symbol,
  PH_STRIP_METHODS(X)
#undef X
      PH_STRIP_METHOD_N
};

/*
 * How two contact elements lie to one another: X(SYMBOL, "name in records").
 *
 *   sphere    one sphere touches both tangent planes on the rulings
 *   pencil    many do: both elements are on one cone or cylinder
 *   parallel  none does, and the axes of both cones are parallel
 *   apex      both rulings, and both tangent planes, meet in a point
 *   flat      the tangent planes are the same
 */
#define PH_PAIR_CASES(X)  \
  X(SPHERE, "sphere")     \
  X(PENCIL, "pencil")     \
  X(PARALLEL, "parallel") \
  X(APEX, "apex")         \
  X(FLAT, "flat")

enum ph_pair_case {
#define X(symbol, name) PH_PAIR_##symbol,
  PH_PAIR_CASES(X)
#undef X
      PH_PAIR_CASE_N
};

/* Unit vectors, and a point in the unit of the data. */
struct ph_strip_frame {
  double point[3], ruling[3], tangent[3], normal[3];
};

/* An arc as a rational quadratic Bezier curve; weights[1] is the cosine of half
 * its angle: not positive from 180 degrees on. */
struct ph_arc3 {
  double control_points[3][3];
  double weights[3];
};

/* A place of the development of a directrix, by its parameter. */
struct ph_flat_sample {
  double t;
  double point[2];
};

struct ph_arc2 {
  double control_points[3][2]; /* general: the first is the start */
  double weights[3];
  double angle;                   /* of its start, from the x axis */
  struct ph_flat_sample *samples; /* general: from the start to the end */
  size_t samples_n;
};

struct ph_directrix; /* curve/surface/general.h */

struct ph_strip {
  size_t pair;
  enum ph_strip_method method;
  struct ph_strip_frame frame; /* at its start */
  double k, kn;                /* geodesic and normal curvature, 1/unit */
  double length;               /* of the contact curve */
  double vertex[3];            /* NaN: there is none, k = 0 */
  double half_angle;           /* of the cone, atan2(|k|, |kn|) */
  double sweep;                /* about its axis, sqrt(k^2 + kn^2) length */
  double development_angle;    /* by which the development turns, k length;
                                  general: phi at the end */
  double shift[2];             /* at its start and at its end */
  struct ph_arc3 contact;
  struct ph_arc2 development;
  /* of general strips, where k, kn, half_angle, sweep and contact are NaN */
  double turn;            /* by which the tangents of the spherical image turn,
                             either way */
  double fairness[3];     /* F1, F2 and F3 of the directrix */
  double *alpha;          /* of the curve: [1], */
  double *control_points; /* [6][3], */
  double *preimage;       /* [3][4]; NULL: a circular strip */
  double *angles;         /* theta and beta, or NULL */
  const struct ph_directrix *directrix; /* NULL: it was read */
};

struct ph_pair {
  enum ph_pair_case which;
  double lambda[2];   /* legs of the first and the last arc; NaN: none */
  double interval[2]; /* lambda[0] in it has lambda[1] > 0; may be infinite */
  double center[3];   /* of the sphere; NaN: there is none */
  double radius;      /* positive on the side of the normals */
};

/* A sample: of strip number `strip', at (s, h) of it. */
struct ph_surface_sample {
  size_t strip;
  double s, h;
  double point[3], normal[3], flat[2];
};

struct ph_surface_samples {
  struct ph_surface_sample *v;
  size_t n;
};

/* A point of the development, and where it is on the surface. */
struct ph_located {
  size_t index; /* of the point, among those that were asked for */
  struct ph_surface_sample at;
};

struct ph_located_list {
  struct ph_located *v;
  size_t n;
};

/* The types of numbers: X(SYMBOL, type). */
#define PH_VOXELS(X)   \
  X(I8, signed char)   \
  X(U8, unsigned char) \
  X(I16, int16_t)      \
  X(U16, uint16_t)     \
  X(I32, int32_t)      \
  X(U32, uint32_t)     \
  X(F32, float)        \
  X(F64, double)

enum ph_voxel {
#define X(symbol, type) PH_VOXEL_##symbol,
  PH_VOXELS(X)
#undef X
      PH_VOXEL_N
};

/* The lattice point i, j, k, from 0 to n - 1 each, has the number v[i + n[0] (j
 * + n[1] k)] and is at the origin, plus i, j and k times the columns of a
 * matrix, of which this is the inverse. */
struct ph_volume {
  enum ph_voxel type;
  const void *v;
  size_t n[3]; /* 2 or more */
  double origin[3], inverse[3][3];
};

/* ph_volume_voxel: value i of a volume, x fastest; NaN: it has no type. */
static inline double ph_volume_voxel(const struct ph_volume *volume, size_t i) {
  switch (volume->type) {
#define X(symbol, type)   \
  case PH_VOXEL_##symbol: \
    return (double)((const type *)volume->v)[i];
    PH_VOXELS(X)
#undef X
  case PH_VOXEL_N:
    break;
  }
  return (double)NAN;
}

/* What a surface meets of a volume, laid flat (volume.h). */
struct ph_panorama {
  double resolution;    /* points over the unit */
  size_t width, height; /* points in a row; rows.  0: there is none */
  double origin[2];     /* of the first point, on the left of the upper row */
  size_t points;        /* on the development */
  size_t outside;       /* of these, outside of the volume */
  double range[2];      /* of all values; NaN: there are none */
  double mean;          /* of these */
  double *v;            /* [height][width], NaN where there is none */
  const struct ph_volume *volume; /* of one that was read: NULL, or that which
                                     it is checked against */
};

/*
 * A patch of a bubble surface (ribbon.h), over one face of a mesh: a tensor
 * product Bezier patch, u from vertex 0 to 1 and v from vertex 0 to 3 of the
 * face.
 *
 * control_points[points_n][3]  rows of constant v, u fastest; points_n is
 *                              (bidegree[0] + 1) (bidegree[1] + 1)
 */
struct ph_patch {
  size_t face;
  size_t vertices[4]; /* in cyclic order */
  size_t bidegree[2]; /* by u and by v */
  double *control_points;
  size_t points_n;
  signed char side; /* 1: b_u x b_v is on the side of the normals, or -1 */
};

/* A sample of a patch: its curvatures are positive towards the normal, which
 * is that of the mesh; NaN where they are not defined. */
struct ph_patch_sample {
  size_t patch;
  double u, v;
  double point[3], normal[3];
  double gauss, mean;
  double principal[2]; /* the larger one first */
};

struct ph_patch_samples {
  struct ph_patch_sample *v;
  size_t n;
};

/* A ribbon (ribbon.h) as Bernstein coefficients, in the unit of the data. */
struct ph_patch_strip {
  double *height;   /* [height_n] */
  double *gradient; /* [gradient_n][3] */
  double *hessian;  /* [hessian_n][6] xx, yy, zz, xy, xz, yz */
  size_t height_n, gradient_n, hessian_n; /* 0: there is none */
};

/* An edge of a surface of patches: between two points, of one face or two; NaN
 * where there is one. */
struct ph_patch_edge {
  size_t vertices[2];
  size_t *faces; /* [faces_n] */
  size_t faces_n;
  double normal_jump, curvature_jump, gap;
  struct ph_patch_strip strip;
};

struct ph_patch_edges {
  struct ph_patch_edge *v;
  size_t n;
};

/* A point of the mesh of exact patches, with the unit normal there. */
struct ph_patch_vertex {
  double point[3], normal[3];
};

struct ph_patchwork; /* curve/surface/exact.h */

/* What a surface has beside the rest of its struct ph_curve, whose segments are
 * its strips or patches: n, lengths, length and closed are there. */
struct ph_surface {
  struct ph_patch *patches;         /* [curve.n], or NULL */
  size_t continuity;                /* of patches: 0, 1 or 2 */
  const struct ph_patchwork *base;  /* of these; NULL: the record was read */
  bool exact;                       /* they are quotients: no control points, */
  struct ph_patch_vertex *vertices; /* but these, and edges */
  size_t vertices_n;
  struct ph_patch_edges edges; /* n = 0: they were not asked for */
  double volume;           /* inside of closed patches; NaN: they are open */
  struct ph_strip *strips; /* [curve.n], or NULL */
  struct ph_pair *pairs;
  size_t pairs_n;
  double height[2]; /* the part that is meant */
  double area;      /* of it */
};

#endif
