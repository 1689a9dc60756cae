/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A method: one way to turn a problem into a curve, or a surface.
 *
 * Each solve/NAME/method.c defines one const struct ph_method; cli/command.c
 * lists them, each with its certificate.  A solver is a pure function: no I/O,
 * no globals, and nothing but its problem decides its result.
 */
#ifndef PH_SOLVE_METHOD_H
#define PH_SOLVE_METHOD_H

#include "base/diag.h"
#include "base/mem.h"
#include "curve/problem.h"
#include "curve/result.h"

#include <stdbool.h>

/*
 * What may help where a method found no curve: an option that a problem does
 * not have at that value.  Of those of a method the first that applies is
 * named.
 */
struct ph_advice {
  const char *about;      /* failures of this field only; NULL: all */
  enum ph_field_id with;  /* only where this one is given, or PH_FIELD_N */
  enum ph_field_id field; /* the option, or PH_FIELD_N: not one alone */
  const char *value;      /* it is not if the field is this word, or a number
                           * that is as large; NULL: if it is given */
  const char *text;
};

struct ph_method {
  struct ph_schema schema; /* name of the command, fields of its problems */
  char title[72];          /* one line for the help */
  size_t dimension;        /* of its curves */
  enum ph_curve_kind kind; /* that they may have */
  /*
   * solve: fills result->curve, the solver's own diagnostics (iterations,
   * residual) and warnings.
   *
   * out      memory of the result
   * scratch  memory given back before the return
   * ret      PH_OK, or the status set in diag; the result is then undefined
   */
  enum ph_status (*solve)(const struct ph_problem *problem,
                          struct ph_arena *out, struct ph_arena *scratch,
                          struct ph_result *result, struct ph_diag *diag);
  const struct ph_advice *advice; /* [advice_n] the likeliest to help first */
  size_t advice_n;
};

/* C2 interpolation of points in the plane by PH quintic and ATPH splines, open
 * or closed [GON18, ch. 2]. */
extern const struct ph_method ph_method_planar;

/* Local interpolation of points in space, with tangents or without, by PH
 * quintic and ATPH segments [FAR15; GON18, ch. 3]. */
extern const struct ph_method ph_method_spatial_hermite;

/* C2 spatial PH quintic splines with prescribed arc lengths [HUA14]. */
extern const struct ph_method ph_method_arclength;

/* Shape-preserving G2 curves on the sphere [IOR15]. */
extern const struct ph_method ph_method_sphere;

/* Plane data to curves of Tschirnhausen cubics, the PH cubics: one for each
 * interval, two, or as many as approximate a curve [BYR11]. */
extern const struct ph_method ph_method_tc;

/* Developable surfaces of cones through contact elements [GON18, ch. 4]. */
extern const struct ph_method ph_method_cone;

/* Smooth surfaces of patches over meshes of quadrilaterals [BYR11, ch. 6]. */
extern const struct ph_method ph_method_bubble;

#endif
