/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * What the commands promise of their curves: a result does not say it, so its
 * command does.  Adding a command is adding a row (promise.c).
 */
#ifndef PH_CHECK_PROMISE_H
#define PH_CHECK_PROMISE_H

#include "base/diag.h"
#include "base/mem.h"
#include "curve/problem.h"
#include "curve/result.h"

/* How segments join, but of Bezier curves in place of others, which share the
 * unit tangent. */
enum ph_join {
  PH_JOIN_TANGENT, /* the unit tangent */
  PH_JOIN_FIRST,   /* r' by the knots */
  PH_JOIN_SECOND   /* r' and r'' by the knots */
};

/* By which parameter derivatives are given. */
enum ph_given {
  PH_GIVEN_NONE,
  PH_GIVEN_KNOTS,   /* that of the knots */
  PH_GIVEN_TENSION, /* the local one, times the square of the tension */
  PH_GIVEN_CUBIC    /* that of each cubic, in [0,1], of two in an interval */
};

/*
 * What a check allows beside the rounding of control points.  A certificate
 * allows what its solver leaves; `phspline verify' allows nothing, and compares
 * what is left with its --tolerance.
 */
struct ph_tolerance {
  double point;   /* of points, in their rounding, */
  double of_size; /* and relative to the size */
  double gap;     /* between segments, in their rounding; 0: both ends are at
                     points of the data */
  double square;  /* of r', relative to the speed of the segment, */
  double square_of_size; /* but no more than this, relative to the size; or 0 */
  double length;         /* relative */
  double joint;          /* of derivatives and tangents between segments, */
  double given;          /* and of those that are given; relative */
  double miss; /* of every equation, relative to the mean length of an interval
                  of the data */
};

/* What a certificate's errors of r' and of lengths are relative to. */
enum ph_unit {
  PH_UNIT_ITSELF,  /* the speed, the length of the segment */
  PH_UNIT_DATA,    /* the size of the data, the length of the curve */
  PH_UNIT_INTERVAL /* the mean length of an interval of the data */
};

struct ph_check;
struct ph_check_segment;

/* PH_OK, or why the curve must not be printed (certify.h). */
typedef enum ph_status ph_promise_fn(struct ph_check *v,
                                     struct ph_diagnostics *diagnostics);

struct ph_promise {
  const char *command;
  unsigned kinds; /* of curves: PH_KIND(symbol) | ... */
  size_t dimension, degree;
  enum ph_join join;
  enum ph_given given;
  bool ends;           /* end derivatives or tangents that are given are kept */
  bool lengths;        /* and lengths from datum to datum */
  bool tension;        /* segments have one, but those of Bezier curves */
  bool intervals;      /* the record has them */
  enum ph_parts parts; /* but segments: the curve is a surface */
  const struct ph_tolerance *allow; /* of its certificate; NULL: this one has
                                       rules of its own for all */
  enum ph_unit unit;
  /* what else must hold before a curve is printed; or NULL: of a segment, whose
   * fault is noted for the second, and of the whole */
  void (*segment)(struct ph_check *v, const struct ph_check_segment *s);
  ph_promise_fn *certify;
  bool approximate; /* there are approximations, which may have corners and
                       miss points, by the distance in their diagnostics */
};

#define PH_KIND(symbol) (1u << PH_CURVE_##symbol)

/* ph_promises: the rows, [ph_promises_n]. */
extern const struct ph_promise ph_promises[];
extern const size_t ph_promises_n;

/*
 * ph_promise_breach: what is wrong with a curve, "is of no kind that the
 * command makes", or NULL where it has segments, and its kind, dimension and
 * degree are those of the command.
 *
 * out  member  "curve": where, if so
 */
const char *ph_promise_breach(const struct ph_promise *promise,
                              const struct ph_curve *curve,
                              const char **member);

/* ph_promise_of: the row of a command, or NULL. */
const struct ph_promise *ph_promise_of(const char *command);

#endif
