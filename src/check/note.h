/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * What the checks share: the curve that is looked at, its scale, what is known
 * of its segments, and the worst error of each check so far.
 */
#ifndef PH_CHECK_NOTE_H
#define PH_CHECK_NOTE_H

#include "base/mem.h"
#include "base/sum.h"
#include "kernel/quad.h"
#include "kernel/vec3.h"
#include "check/error.h"
#include "check/integral.h"
#include "check/scale.h"
#include "check/verify.h"

#include <float.h>
#include <math.h>
#include <stdbool.h>

/* No command makes curves of a larger degree (promise.c). */
enum { PH_CHECK_DEGREE_MAX = 5 };

/* Each derivative after the first may be off by 8 times as much as
 * PH_CHECK_ROUND_FIRST (scale.h). */
enum { PH_CHECK_ROUND_NEXT = 8 };

/* Of knots, whose difference counts. */
enum { PH_CHECK_ROUND_KNOT = 4 };

/* A direction that rounding may have turned by more than this is none. */
#define PH_CHECK_NO_DIRECTION 0.5

/* The room for prefixes of fields. */
enum { PH_CHECK_PREFIX = 48 };

struct ph_check_kind;
struct ph_check_data;
struct ph_check_space;

struct ph_check {
  struct ph_verdict *verdict;   /* of verification */
  struct ph_check_error *error; /* [PH_CHECK_N] of a certificate; or NULL */
  enum ph_status status;        /* of what cannot be, in a certificate; */
  int fault;       /* not 0: what else is wrong (promise.h), in the first */
  size_t fault_at; /* segment where something is */
  struct ph_arena *scratch;
  struct ph_diag *diag;             /* of what stops verification: no memory */
  const struct ph_promise *promise; /* of the command */
  const struct ph_tolerance *allow; /* beside rounding of control points */
  const struct ph_problem *problem;
  char prefix[PH_CHECK_PREFIX]; /* of fields: "solutions[1]." */

  /* what is looked at */
  const struct ph_result *claim;
  const struct ph_curve *curve;
  const struct ph_check_kind *kind; /* of the curve */
  const struct ph_diagnostics *diagnostics;
  const struct ph_interval *intervals;
  size_t intervals_n;

  /* its scale, by the control points, or the points of the problem where a
   * promise says so: size is half the diagonal of these */
  struct ph_check_scale scale;
  double mean; /* length of a segment, as claimed; 0 in certificates */
  double unit_square, unit_length; /* what errors of r' and of lengths are
                                      relative to; 0: themselves, or the mean */
  double interval;   /* mean length of an interval of the data, and */
  double mean_speed; /* of r' by the knots, where a certificate needs them */
  double knot;       /* rounding of the largest knot, with its margin */

  struct ph_check_data *data; /* of the problem (data.h), or NULL */

  /* what was found of its segments; NULL in certificates that need it once */
  double *length; /* [n] by quadrature; NaN where that failed */
  double *noise;  /* [n] by how much r' by u in [0,1] is uncertain */
  bool *rooted;   /* [n] whether the claimed preimage fits to rounding; not
                     looked for in certificates */

  struct ph_sum found; /* of the lengths so far, by quadrature, */
  double doubt;        /* and by how much that is uncertain */

  struct ph_check_rule rule;    /* of adaptive quadrature */
  struct ph_quad fixed;         /* for r' and |r'| of a hodograph */
  struct ph_check_space *space; /* of the last segment */
};

/* ---- the worst errors --------------------------------------------------- */

/* Where something was claimed: LIST[index].MEMBER, LIST.MEMBER if index is
 * PH_CHECK_ONE, LIST or MEMBER alone if the other is NULL. */
#define PH_CHECK_ONE SIZE_MAX
struct ph_check_where {
  const char *list;
  size_t index;
  const char *member;
};

static inline struct ph_check_where ph_check_of(const char *list, size_t index,
                                                const char *member) {
  struct ph_check_where where = {list, index, member};
  return where;
}

/* ph_check_segment_of: a member of segment k. */
static inline struct ph_check_where ph_check_in(size_t k, const char *member) {
  return ph_check_of("segments", k, member);
}

/* ph_check_excess: an error less what rounding explains, in some unit;
 * infinite where anything is NaN. */
static inline double ph_check_excess(double miss, double unit,
                                     double allowance) {
  double rest = miss - allowance;
  return rest <= 0 ? 0 : rest / unit < HUGE_VAL ? rest / unit : HUGE_VAL;
}

/* ph_check_put: an error that is the worst so far; for those below. */
void ph_check_put(struct ph_check *v, enum ph_check_id check, double error,
                  struct ph_check_where where, const char *what, double claimed,
                  double found);

/*
 * ph_check_number: a number as it was claimed and as it was found, both in the
 * unit that the record has it in.
 *
 * in   unit       what the error is relative to
 * in   allowance  what rounding can make of the difference
 */
static inline void ph_check_number(struct ph_check *v, enum ph_check_id check,
                                   struct ph_check_where where, double claimed,
                                   double found, double unit,
                                   double allowance) {
  double error = ph_check_excess(fabs(claimed - found), unit, allowance);
  struct ph_check_finding *worst = &v->verdict->check[check];
  if (!worst->done || error > worst->error) {
    ph_check_put(v, check, error, where, NULL, claimed, found);
  }
}

/*
 * ph_check_miss: something that should be 0.  A certificate allows what its
 * promise does (promise.h), which is then part of the allowance.
 *
 * in   what  "leaves the sphere": a message, to which the error is added
 */
static inline void ph_check_miss(struct ph_check *v, enum ph_check_id check,
                                 struct ph_check_where where, double miss,
                                 double unit, double allowance,
                                 const char *what) {
  struct ph_check_finding *worst;
  double error;
  if (v->error) {
    ph_check_add(&v->error[check], where.index, miss, unit, allowance);
    return;
  }
  error = ph_check_excess(miss, unit, allowance);
  worst = &v->verdict->check[check];
  if (!worst->done || error > worst->error) {
    ph_check_put(v, check, error, where, what, error, 0);
  }
}

/* ph_check_wrong: something that cannot be: an infinite error. */
void ph_check_wrong(struct ph_check *v, enum ph_check_id check,
                    struct ph_check_where where, const char *what);

/* ph_check_done: a check that found nothing to complain of. */
void ph_check_done(struct ph_check *v, enum ph_check_id check);

/* ph_check_prefix: "LIST[index]." before the fields of what follows; NULL:
 * none. */
void ph_check_prefix(struct ph_check *v, const char *list, size_t index);

/* ph_check_unit: what an error is relative to: a unit that there is, or the
 * thing itself. */
static inline double ph_check_unit(double unit, double itself, double mean) {
  return unit > 0 ? unit : ph_check_larger(itself, mean);
}

/* ---- scale -------------------------------------------------------------- */

static inline double ph_check_scaled(const struct ph_check *v, double x) {
  return ph_pow2_apply(v->scale.to_unit, x);
}

static inline double ph_check_unscaled(const struct ph_check *v, double x) {
  return ph_pow2_apply(v->scale.from_unit, x);
}

/* ph_check_vector: of 2 or 3 coordinates, at unit scale. */
static inline ph_vec3 ph_check_vector(const struct ph_check *v, const double *x,
                                      size_t dimension) {
  ph_vec3 a = ph_vec3_get(x, dimension);
  return ph_vec3_of(ph_check_scaled(v, a.x), ph_check_scaled(v, a.y),
                    ph_check_scaled(v, a.z));
}

/* ph_check_apart: |a - b|, also where the squares leave the range of a double:
 * between points of far offsets. */
static inline double ph_check_apart(ph_vec3 a, ph_vec3 b) {
  ph_vec3 d = ph_vec3_sub(a, b);
  double apart = ph_vec3_abs(d);
  return apart <= DBL_MAX ? apart : hypot(hypot(d.x, d.y), d.z);
}

/* ph_check_reach: the rounding of a vector's coordinates. */
static inline double ph_check_reach(const struct ph_check *v, ph_vec3 a) {
  double x = ph_check_larger(fabs(a.x), fabs(a.y));
  return DBL_EPSILON * ph_check_larger(x, fabs(a.z)) + v->scale.spacing;
}

static inline bool ph_check_known(const struct ph_check *v,
                                  enum ph_diagnostic which) {
  return ph_diagnostics_known(v->diagnostics, which);
}

#endif
