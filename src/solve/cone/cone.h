/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Cone splines: developable surfaces through contact elements [GON18, ch. 4].
 *
 * A contact element is a point p on a ruling, the direction e of the ruling, a
 * direction d across in the tangent plane, and the normal n = e x d.  Between
 * two elements lies a pair of strips of circular cones that touch one another
 * along a common ruling.  Pairs are independent of one another.  Or both strips
 * are of general cones, whose vertices are on the given rulings.
 *
 *   data.c    the elements of a problem
 *   pair.c    two elements to two strips: numbers alone
 *   build.c   pairs into a surface, its development, what is told of it
 *   atph.c    the same of general cones over ATPH curves
 *   method.c  the fields
 *
 * All lengths are at unit scale: those of the data times 2^exponent.
 */
#ifndef PH_SOLVE_CONE_CONE_H
#define PH_SOLVE_CONE_CONE_H

#include "base/diag.h"
#include "base/mem.h"
#include "curve/problem.h"
#include "curve/result.h"
#include "kernel/pow2.h"
#include "kernel/vec3.h"

/* ---- data ---------------------------------------------------------------- */

struct ph_contact_element {
  ph_vec3 p, e, d, n;
};

struct ph_cone_data {
  size_t n;          /* pairs */
  size_t elements_n; /* n if closed, else n + 1 */
  bool closed;
  struct ph_contact_element *element;
  const double *lambda; /* [n] at unit scale; NULL: equal legs */
  double degenerate;    /* the field degenerate_tolerance */
  double height[2];     /* at unit scale */
  int exponent;
  bool general; /* the method is "atph" */
};

/* What the fields are where they are absent. */
#define PH_CONE_DEGENERATE 1e-9

/*
 * ph_cone_data_of: checks the fields of a problem.  Tangents are made
 * orthogonal to the rulings, if they are so to 1e-3.
 *
 * ret  PH_OK | PH_E_TOO_FEW_POINTS | PH_E_BAD_SHAPE | PH_E_BAD_VALUE |
 *      PH_E_ZERO_TANGENT | PH_E_COINCIDENT_POINTS | PH_E_NO_MEMORY
 */
enum ph_status ph_cone_data_of(const struct ph_problem *problem,
                               struct ph_arena *arena,
                               struct ph_cone_data *data, struct ph_diag *diag);

/* ph_cone_element: element k; after the last of closed ones the first again. */
static inline const struct ph_contact_element *
ph_cone_element(const struct ph_cone_data *data, size_t k) {
  return &data->element[k < data->elements_n ? k : 0];
}

/* ---- pairs --------------------------------------------------------------- */

/* A strip of a pair, with its frame: origin and directions. */
struct ph_cone_strip {
  ph_vec3 c, e, d, n; /* c from the middle of both given points */
  double k, kn, length;
  double chord;  /* of the contact curve */
  double weight; /* cosine of half its angle */
};

struct ph_cone_pair {
  enum ph_pair_case which;
  double shift[2];    /* of the contact points, along the rulings */
  double lambda[2];   /* NaN: none, the second arc is a half circle */
  double interval[2]; /* of lambda[0] with lambda[1] > 0 */
  double chord;       /* between the contact points */
  ph_vec3 center;     /* from the middle; NaN: there is no sphere */
  double radius;
  struct ph_cone_strip strip[2];
  double residual; /* of the frame at its end: directions, and point / chord */
};

/* Why there is no pair. */
enum ph_cone_reason {
  PH_CONE_OK,
  PH_CONE_REVERSED, /* one element is the other, turned by 180 degrees */
  PH_CONE_PLANES,   /* tangent planes are parallel, and not the same */
  PH_CONE_SADDLE,   /* the sphere is at infinity: rulings of a saddle */
  PH_CONE_CONTACT,  /* the contact points coincide */
  PH_CONE_LAMBDA, /* no second leg for the first one, or none that are equal */
  PH_CONE_ARC     /* an arc of no length, or one of 360 degrees */
};

/*
 * ph_cone_pair: two strips of circular cones between two elements.
 *
 * in   lambda      the first leg; NaN: both are equal
 * in   degenerate  up to which distance from the others, relative, a row of the
 *                  equations of the sphere counts as dependent on them
 * ret  PH_CONE_OK, or why there is none
 */
enum ph_cone_reason ph_cone_pair(const struct ph_contact_element *first,
                                 const struct ph_contact_element *last,
                                 double lambda, double degenerate,
                                 struct ph_cone_pair *pair);

/* ph_cone_reason_text: the same in words, "has ...", of the pair. */
const char *ph_cone_reason_text(enum ph_cone_reason reason);

/* ---- surfaces ------------------------------------------------------------ */

/*
 * ph_cone_build: all pairs as the surface of a result, with its development,
 * length and area, diagnostics of the solver, and warnings.
 *
 * ret  PH_OK | PH_E_INFEASIBLE | PH_E_NO_MEMORY
 */
enum ph_status ph_cone_build(const struct ph_cone_data *data,
                             struct ph_arena *arena, struct ph_result *result,
                             struct ph_diag *diag);

/* ph_cone_see_folds: where strips fold, told in diagnostics and a warning, and
 * with that whether the surface is regular.  inside: a vertex is within the
 * height. */
void ph_cone_see_folds(bool inside, struct ph_result *result);

/*
 * ph_cone_general: the same of general cones [GON18, sec. 4.4]: two strips in
 * each pair, whose vertices v1 and v2 are at the apexes along the rulings of
 * its elements, and whose common ruling is the line between these.  The contact
 * curves of all strips are one curve of ATPH segments through the given points
 * and the points on the common rulings, which the method spatial-hermite finds:
 * its criteria are those of the fields.
 *
 * ret  PH_OK | PH_E_INFEASIBLE (a pair has no common ruling, or one on the
 *      wrong side) | PH_E_NO_CONVERGENCE (a strip is not regular, or a loop) |
 *      what spatial-hermite returns | PH_E_BAD_SHAPE | PH_E_BAD_VALUE |
 *      PH_E_MISSING_FIELD | PH_E_NO_MEMORY
 */
enum ph_status ph_cone_general(const struct ph_problem *problem,
                               const struct ph_cone_data *data,
                               struct ph_arena *out, struct ph_arena *scratch,
                               struct ph_result *result, struct ph_diag *diag);

#endif
