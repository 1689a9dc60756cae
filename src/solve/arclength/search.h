/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The search for minima of F under the rows: from several starts, in a fixed
 * order, until one leads to a minimum.  A minimum that was found is a local
 * one; of several the lowest is taken.
 */
#ifndef PH_SOLVE_ARCLENGTH_SEARCH_H
#define PH_SOLVE_ARCLENGTH_SEARCH_H

#include "curve/result.h"
#include "solve/arclength/newton.h"

/* What is asked for. */
struct ph_arc_request {
  const struct ph_arc_data *data;
  size_t refine;
  size_t dim;
  size_t random; /* extra starts */
  bool all;      /* try every start, keep every minimum */
};

/* The curve whose lengths are free. */
struct ph_arc_natural {
  bool known;
  double f;
  double *length; /* [n] */
  double *x;      /* [x_n] */
};

/* A minimum. */
struct ph_arc_found {
  struct ph_arc_point point;
  size_t start; /* that led to it */
};

struct ph_arc_search {
  struct ph_arc_system system; /* of the request */
  bool all;                    /* of the request */
  struct ph_arc_natural natural;
  struct ph_start *starts; /* as tried; f in our unit */
  size_t starts_n;
  struct ph_arc_found *found; /* different ones, lowest first */
  size_t found_n;
  bool stood_still;            /* a curve was found and refused: it has speed
                                * 0 where it is to have a direction */
  struct ph_arc_point nearest; /* if none was found: the iterate whose rows
                                * hold best */
};

/* ph_arc_is_same: whether two values of F, of ours, are of one minimum. */
bool ph_arc_is_same(double f, double g);

/*
 * ph_arc_search_run: carries out a request.
 *
 * inout arena   of the search, and of what it works in: the caller gives both
 *               back
 * out   search  found_n is 0 when every start failed
 * ret   false when memory is exhausted
 */
bool ph_arc_search_run(const struct ph_arc_request *request,
                       struct ph_arena *arena, struct ph_arc_search *search);

#endif
