/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The fairest members of a family (see spatial.h). */
#ifndef PH_SOLVE_SPATIAL_FAIREST_H
#define PH_SOLVE_SPATIAL_FAIREST_H

#include "base/mem.h"
#include "base/status.h"
#include "curve/fair/fair3.h"
#include "kernel/quad.h"
#include "solve/spatial/spatial.h"

#include <stdbool.h>
#include <stddef.h>

/* ---- fairness ------------------------------------------------------------ */

/*
 * F1, F2 and F3 of members of a family by a fixed quadrature, with gradients:
 * what a minimisation evaluates over and over.  curve/fair/fair3.h has the
 * functions, and the values that count.
 */

enum { PH_SPATIAL_FAIR_NODES = 16 };

/* The variables of a gradient. */
enum { PH_SPATIAL_B, PH_SPATIAL_PHI, PH_SPATIAL_ALPHA, PH_SPATIAL_VARIABLES };

struct ph_spatial_point {
  double b, phi; /* angles of the member */
  double alpha;  /* angle of the space */
};

/* What is minimised. */
struct ph_spatial_target {
  const struct ph_quad *rule;             /* of PH_SPATIAL_FAIR_NODES nodes */
  const struct ph_spatial_family *family; /* where it is scaled: at alpha = 1 */
  bool scaled;    /* |Di|, |Df| are proportional to alpha */
  int functional; /* 1, 2, 3: which F */
};

/* ph_spatial_fair_family: the family at alpha. */
struct ph_spatial_family
ph_spatial_fair_family(const struct ph_spatial_target *target, double alpha);

/* The members of one b and one alpha, of which phi is free. */
struct ph_spatial_section {
  struct ph_spatial_family family;
  ph_cplx b;
  ph_quat ends[2], sum, nearest; /* A0 and A2, their sum, D(0) */
  double scale;                  /* of the integrals */
};

/* ph_spatial_section_of: the section of some alpha and b. */
struct ph_spatial_section
ph_spatial_section_of(const struct ph_spatial_target *target, double alpha,
                      double b);

/* ph_spatial_section_fair: ph_spatial_fair of a member of a section. */
double ph_spatial_section_fair(const struct ph_spatial_target *target,
                               const struct ph_spatial_section *at,
                               size_t panels, double phi);

/*
 * ph_spatial_fair: the functional at a point.
 *
 * in   panels    parts of [0,1] with a rule each
 * out  gradient  [PH_SPATIAL_VARIABLES], NULL: not wanted; for alpha = 0 the
 *                last is not finite
 * ret  not finite where there is none
 */
double ph_spatial_fair(const struct ph_spatial_target *target, size_t panels,
                       const struct ph_spatial_point *at, double *gradient);

/* ---- least fairness ------------------------------------------------------ */

/*
 * The fairest members of a family of spatial Hermite interpolants: the angles
 * (b, phi), and the angle of the space unless it is given, that minimise F1, F2
 * or F3 of curve/fair/fair3.h [GON18, sec. 3.6].
 *
 * The functions have many local minima.  The global search evaluates them on a
 * grid and descends from the best of its local minima; it is deterministic, and
 * t_spatial_min.c and bench/spatial_min.c compare it with far denser grids.
 */

/* What is sought. */
struct ph_spatial_search {
  const struct ph_spatial_data *data;
  bool scaled; /* data->ni, nf are derivatives by t in [0,alpha]: those by u are
                  alpha times as long */
  double alpha_lower, alpha_upper; /* the same: alpha is given, 0 for PH */
  int functional;                  /* 1, 2, 3: F1, F2, F3 */
  bool plane; /* plane data: of the members in their plane alone */
};

/* The bounds of a free alpha. */
#define PH_SPATIAL_ALPHA_MIN 1e-3
#define PH_SPATIAL_ALPHA_MAX 2.0943951023931953 /* 2 pi / 3 */

/* A minimum as far as rough descents know it. */
struct ph_spatial_start {
  struct ph_spatial_point at;
  double value;
  bool plane; /* in the plane of plane data: b and phi stay */
};

enum { PH_SPATIAL_STARTS = 24 };

/* What was found. */
struct ph_spatial_minimum {
  struct ph_spatial_member member;
  double alpha;
  int functional; /* what is least: that of the search, or 1 in its place */
  double value;   /* of the functional, by ph_fair3_of */
  size_t evaluations, work; /* work: in those of the rough quadrature */
  bool at_bound; /* alpha is free and on a bound: the minimum moves with it */
  size_t starts; /* the least first, none in the plane of plane data */
  struct ph_spatial_start start[PH_SPATIAL_STARTS];
};

/*
 * ph_spatial_minimize: the global minimum; that of F1 where no member was found
 * whose F2 or F3 is finite.
 *
 * ret  PH_OK | PH_E_NO_MEMORY; the value is not finite where F1 is not either
 */
enum ph_status ph_spatial_minimize(const struct ph_spatial_search *search,
                                   const struct ph_fair3_rules *rules,
                                   struct ph_arena *scratch,
                                   struct ph_spatial_minimum *found);

/*
 * ph_spatial_descend: the least of the minima that those of data nearby lead
 * to.
 *
 * inout found  of the data nearby, with the same bounds of alpha; without
 *              starts any member, which leads to a local minimum
 */
enum ph_status ph_spatial_descend(const struct ph_spatial_search *search,
                                  const struct ph_fair3_rules *rules,
                                  struct ph_arena *scratch,
                                  struct ph_spatial_minimum *found);

#endif
