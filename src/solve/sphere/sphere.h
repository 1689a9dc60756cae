/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Internal declarations of the method `sphere`. */
#ifndef PH_SOLVE_SPHERE_SPHERE_H
#define PH_SOLVE_SPHERE_SPHERE_H

#include "base/diag.h"
#include "base/mem.h"
#include "curve/problem.h"
#include "curve/result.h"
#include "curve/segment/spherical.h"
#include "kernel/block2.h"
#include "kernel/vec3.h"

#include <stdbool.h>

/* ---- data ---------------------------------------------------------------- */

/*
 * Data of the sphere problem: unit vectors and spacings, from the fields of a
 * problem.
 */

/* What the curve does at the ends of open data. */
enum ph_sphere_ends {
  PH_SPHERE_NATURAL, /* no covariant acceleration */
  PH_SPHERE_REST,    /* no velocity */
  PH_SPHERE_CLAMPED  /* given velocities */
};

struct ph_sphere_data {
  bool closed;
  enum ph_sphere_ends ends;
  size_t n;      /* nodes */
  size_t m;      /* segments: n - 1, or n if closed */
  ph_vec3 *p;    /* [n] unit vectors */
  ph_vec3 *e;    /* [n] unit tangents: with p x e, the frame at a node */
  double *theta; /* [m] angle from node k to the next, in (0, pi) */
  double *h;     /* [m] spacings of the knots; mean that of theta, for knots
                  * given by a word */
  double *nu;    /* [n] initial tensions; 0 at the ends of open data, which have
                  * no effect, if they are not given */
  ph_vec3 end[2]; /* clamped: velocities with respect to the knots */

  double *knots; /* [m + 1] of the record: the numbers given, or sums of h */
  double center[3];
  double radius;
  double moved; /* by how much the points were moved at most, / radius */
  size_t moved_at;
  bool tell_moved; /* by more than rounding: a warning is due */
  double rounding; /* error of the coordinates of p, from those given */
};

/*
 * ph_sphere_data_read: the data of a problem.
 *
 * out  data  arrays in the arena
 * ret  PH_OK | PH_E_MISSING_FIELD | PH_E_BAD_VALUE | PH_E_BAD_SHAPE |
 *      PH_E_TOO_FEW_POINTS | PH_E_COINCIDENT_POINTS (neighbours nearer than
 *      1e-10)
 * | PH_E_ANTIPODAL_POINTS (farther than pi - 1e-6) | PH_E_NOT_ON_SPHERE |
 *      PH_E_ZERO_TANGENT | PH_E_TOO_LARGE | PH_E_NO_MEMORY
 */
enum ph_status ph_sphere_data_read(const struct ph_problem *problem,
                                   struct ph_arena *arena,
                                   struct ph_sphere_data *data,
                                   struct ph_diag *diag);

/* ph_sphere_before: the segment that ends at node i; only where there is one.
 */
static inline size_t ph_sphere_before(const struct ph_sphere_data *d,
                                      size_t i) {
  return i > 0 ? i - 1 : d->m - 1;
}

/* ph_sphere_next: the node at the end of segment k. */
static inline size_t ph_sphere_next(const struct ph_sphere_data *d, size_t k) {
  return k + 1 < d->n ? k + 1 : 0;
}

/* ph_sphere_is_end: whether node i is an end of open data. */
static inline bool ph_sphere_is_end(const struct ph_sphere_data *d, size_t i) {
  return !d->closed && (i == 0 || i + 1 == d->n);
}

/* ph_sphere_left, ph_sphere_right: the spacing before and after node i; 0
 * beyond the ends. */
static inline double ph_sphere_left(const struct ph_sphere_data *d, size_t i) {
  return !d->closed && i == 0 ? 0 : d->h[ph_sphere_before(d, i)];
}

static inline double ph_sphere_right(const struct ph_sphere_data *d, size_t i) {
  return !d->closed && i + 1 == d->n ? 0 : d->h[i];
}

/* ph_sphere_stiffness: what the velocity at node i, which is no end, is
 * multiplied by in its equation in the plane, beside the tension:
 * 4/h_i + 4/h_{i+1}. */
static inline double ph_sphere_stiffness(const struct ph_sphere_data *d,
                                         size_t i) {
  return 4 / d->h[ph_sphere_before(d, i)] + 4 / d->h[i];
}

/* ---- splines and models -------------------------------------------------- */

/*
 * A spherical nu-spline at given tensions, and the two models of it: nodes
 * p[0], ..., p[n-1], one unknown x[i] with two coordinates at each, and the
 * legs r[k], l[k] of every segment, whose control
 * points are
 *   segment k:   p[k], p[k] + r[k], p[k+1] + l[k], p[k+1].
 *
 * A model says what a segment means for the equations at its two nodes
 * (struct ph_sphere_part), and what the equation of a node is.  The
 * equation of node i contains x[i-1], x[i] and x[i+1] only, so that part of a
 * spline can be solved while the rest stands still.
 */

struct ph_sphere_model;
struct ph_sphere_work; /* below */

/* Nodes first, first + 1, ..., count of them, modulo n if closed; none is an
 * end of open data. */
struct ph_sphere_range {
  size_t first, count;
};

struct ph_sphere_spline {
  const struct ph_sphere_data *data;
  const struct ph_sphere_model *model;
  double *nu; /* [n] tensions */
  ph_vec3 *x; /* [n] exact: velocities; nielson: the global control points, less
               * the nodes */
  ph_vec3 *r; /* [m] legs from each node to the control point after it, and */
  ph_vec3 *l; /* [m] from the next node to the one before it */
};

/* ph_sphere_segment: segment k. */
static inline struct ph_spherical
ph_sphere_segment(const struct ph_sphere_spline *s, size_t k) {
  const ph_vec3 *p = s->data->p;
  size_t next = ph_sphere_next(s->data, k);
  struct ph_spherical segment = {{p[k], ph_vec3_add(p[k], s->r[k]),
                                  ph_vec3_add(p[next], s->l[k]), p[next]}};
  return segment;
}

/* ph_sphere_middle: its middle leg. */
static inline ph_vec3 ph_sphere_middle(const struct ph_sphere_spline *s,
                                       size_t k) {
  const ph_vec3 *p = s->data->p;
  ph_vec3 across = ph_vec3_sub(p[ph_sphere_next(s->data, k)], p[k]);
  return ph_vec3_add(ph_vec3_sub(across, s->r[k]), s->l[k]);
}

/* ph_sphere_legs: the same by its legs, which are known to more digits than
 * the control points tell, where these are close to a node. */
static inline struct ph_spherical_legs
ph_sphere_legs(const struct ph_sphere_spline *s, size_t k) {
  struct ph_spherical_legs legs = {.s = ph_sphere_segment(s, k)};
  legs.leg[0] = s->r[k];
  legs.leg[1] = ph_sphere_middle(s, k);
  legs.leg[2] = ph_vec3_scale(-1, s->l[k]);
  return legs;
}

/*
 * What a segment contributes to the equations of its nodes: one vector to that
 * of the node it begins at, f[0], and one to that of the node it ends at, f[1],
 * with derivatives: d[e][w][c] is that of f[e] when x at the segment's begin
 * (w = 0) or end (w = 1) moves along the frame's vector c.
 */
struct ph_sphere_part {
  ph_vec3 f[2];
  ph_vec3 d[2][2][2];
};

struct ph_sphere_model {
  const char *name;
  /* segment: sets r[k] and l[k] from x, and the part, unless it is NULL; its
   * derivatives only if asked for */
  void (*segment)(struct ph_sphere_spline *s, size_t k, bool derivatives,
                  struct ph_sphere_part *part);
  /* node: the equation of node i, which is no end, between two parts: its
   * derivatives, if asked for, and what is missing, in the node's frame; scaled
   * so that 1 means as large as the data */
  void (*node)(const struct ph_sphere_spline *s, size_t i,
               const struct ph_sphere_part *left,
               const struct ph_sphere_part *right, bool derivatives,
               struct ph_block2_row *row);
  /* retension: a row that was made with the tension `from` and x[i] = x, with
   * the tension that node i has; or NULL: x does not answer linearly */
  void (*retension)(const struct ph_sphere_spline *s, size_t i, ph_vec3 x,
                    double from, struct ph_block2_row *row);
  /* move: x[i] when it moves by these coordinates in the frame */
  ph_vec3 (*move)(const struct ph_sphere_spline *s, size_t i,
                  const double step[2]);
  /* reach: how far control points go at most when x[i] moves by 1, in radians
   */
  double (*reach)(const struct ph_sphere_spline *s, size_t i);
  /* hug: x of a spline that is nearly at infinite tension, in a range; and of
   * the ends of open data, whatever it stays */
  void (*hug)(struct ph_sphere_spline *s, struct ph_sphere_range range);
  /* start: x to begin an iteration from; false when there is none of that
   * number, 0, 1, ... */
  bool (*start)(struct ph_sphere_spline *s, struct ph_sphere_range range,
                size_t which, struct ph_sphere_work *work);
  /* last_resort: another way to a solution, which is true if it is one; or
   * NULL */
  bool (*last_resort)(struct ph_sphere_spline *s, struct ph_sphere_range range,
                      struct ph_sphere_work *work);
  /* join: l and r of a solution beside node i, which is no end, as exactly in
   * one direction as their rounding allows; or NULL: they are */
  void (*join)(struct ph_sphere_spline *s, size_t i);
};

/* The models: velocities, truly G2 [derived in exact.c], and global
 * control points [IOR15, sec. 3.2]. */
extern const struct ph_sphere_model ph_sphere_exact;
extern const struct ph_sphere_model ph_sphere_nielson;

/* ---- Newton's iteration -------------------------------------------------- */

/*
 * Newton's iteration for a spherical nu-spline at given tensions, of either
 * model, on all of its nodes or on a range of them while the rest stands still;
 * and relaxation, which comes nearer from where Newton's iteration fails.
 */

/* ph_sphere_node: node j of a range. */
static inline size_t ph_sphere_node(const struct ph_sphere_data *d,
                                    struct ph_sphere_range range, size_t j) {
  size_t i = range.first + j;
  return i < d->n ? i : i - d->n;
}

/* ph_sphere_all: all nodes that have an equation. */
struct ph_sphere_range ph_sphere_all(const struct ph_sphere_data *data);

/* ph_sphere_widen: count nodes from first on with `by` more on either side, at
 * most all; first may be an end of open data. */
struct ph_sphere_range ph_sphere_widen(const struct ph_sphere_data *data,
                                       size_t first, size_t count, size_t by);

struct ph_sphere_work {
  const struct ph_arena *arena; /* of all this; knows how much time there is */
  struct ph_block2 system;
  double (*step)[2];
  ph_vec3 *before;   /* x at the begin of an iteration, and */
  ph_vec3 *kept;     /* of a whole solution */
  double *tension;   /* tensions that are aimed at */
  double *held;      /* [n] what more of them a solution needs: solve.c; */
  double *aim;       /* [n] those of blocks, and */
  double *given;     /* [n] those of the whole */
  size_t iterations; /* in all */
  double residual;   /* of the last solution: root mean square */
};

/* ph_sphere_work_alloc: for up to n nodes; false when memory is exhausted. */
bool ph_sphere_work_alloc(struct ph_sphere_work *work, struct ph_arena *arena,
                          size_t n);

/* ph_sphere_spline_alloc: arrays of a spline, its tensions those of the data;
 * false when memory is exhausted. */
bool ph_sphere_spline_alloc(struct ph_sphere_spline *s,
                            const struct ph_sphere_data *data,
                            const struct ph_sphere_model *model,
                            struct ph_arena *arena);

/*
 * ph_sphere_newton: from x as it is to a solution, if there is one nearby.
 *
 * The step is halved until the residual falls; the iteration ends where all
 * equations hold to rounding, or where they no longer come nearer and hold
 * nearly.
 *
 * inout s  x; r and l of the segments at the range's nodes
 * ret   whether a solution was found; if not, x is as before
 */
bool ph_sphere_newton(struct ph_sphere_spline *s, struct ph_sphere_range range,
                      struct ph_sphere_work *work);

/* ph_sphere_step: one step of the iteration, at most of such a length as the
 * iteration takes, for derivatives. */
void ph_sphere_step(struct ph_sphere_spline *s, struct ph_sphere_range range,
                    struct ph_sphere_work *work);

/*
 * ph_sphere_relax: relaxation and Newton's iteration after it, from farther
 * away.
 *
 * in    tau  what is added to the diagonal in the first step, where it is about
 *            1: small tau means long steps
 * inout s    x, which is anything afterwards if no solution was found
 */
bool ph_sphere_relax(struct ph_sphere_spline *s, struct ph_sphere_range range,
                     double tau, struct ph_sphere_work *work);

/* ph_sphere_fold: the node of a range that a step of Newton's iteration moves
 * most from x, which solved larger tensions: beside a fold that is where it
 * is. */
size_t ph_sphere_fold(struct ph_sphere_spline *s, struct ph_sphere_range range,
                      struct ph_sphere_work *work);

/* ---- linear response ----------------------------------------------------- */

/* The equations of a range at a spline, to tell what other tensions make of
 * it, of a model with retension. */
struct ph_sphere_response {
  struct ph_sphere_range range;
  struct ph_block2_row *row; /* [range.count] */
  double *nu;                /* and tensions, */
  ph_vec3 *x;                /* and unknowns there */
};

/* ph_sphere_response_alloc: for up to n nodes; false when memory is exhausted.
 */
bool ph_sphere_response_alloc(struct ph_sphere_response *response,
                              struct ph_arena *arena, size_t n);

/* ph_sphere_response_of: at the spline as it is. */
void ph_sphere_response_of(struct ph_sphere_spline *s,
                           struct ph_sphere_range range,
                           struct ph_sphere_response *response);

/* ph_sphere_respond: sets x of nodes first, first + 1, ... of the response's
 * range, count of them, to what the tensions of s make of it, to first order,
 * while the rest stands still; and the legs there. */
void ph_sphere_respond(struct ph_sphere_spline *s,
                       const struct ph_sphere_response *response, size_t first,
                       size_t count, struct ph_sphere_work *work);

/*
 * ph_sphere_respond_well: the same of the whole range with what is neglected,
 * by further steps with the same matrix: x to 1e-6 of the speed.
 *
 * ret  false: they do not lead there; x, r and l are anything
 */
bool ph_sphere_respond_well(struct ph_sphere_spline *s,
                            const struct ph_sphere_response *response,
                            struct ph_sphere_work *work);

/* ---- from nothing -------------------------------------------------------- */

/* A spherical nu-spline at given tensions, from nothing. */

/*
 * ph_sphere_solve: the whole spline, from the start of its model.  Where
 * Newton's iteration fails, from large tensions, at which the spline hugs the
 * data, down to those asked for: block by block (ph_sphere_settle), then all at
 * once; then by relaxation from other starts, and at last in a way of the
 * model's own.
 *
 * out  s    x, r, l
 * ret  whether a solution was found
 */
bool ph_sphere_solve(struct ph_sphere_spline *s, struct ph_sphere_work *work);

/*
 * ph_sphere_solve_tense: the same; where there is none, a spline with larger
 * tensions at the nodes that it needs them at: steps of more than a right angle
 * have folds, below which there is none.
 *
 * inout s    nu
 * out   s    x, r, l
 * ret   whether a solution was found
 */
bool ph_sphere_solve_tense(struct ph_sphere_spline *s,
                           struct ph_sphere_work *work);

/*
 * ph_sphere_settle: from a spline that solves its tensions to one at others,
 * block by block: the nodes of a block get theirs, and move with some on either
 * side of them while the rest stands still.  One block that is hard costs no
 * more than itself.
 *
 * inout s    x, nu: a solution in and beside the range
 * inout aim  [n] the other tensions; if they may be larger, those that are
 *            found
 * in    tense  whether they may
 * ret   whether a solution was found; if not, x and nu are anything
 */
bool ph_sphere_settle(struct ph_sphere_spline *s, struct ph_sphere_range range,
                      double *aim, bool tense, struct ph_sphere_work *work);

/* ---- shape --------------------------------------------------------------- */

/*
 * The shape that data on the sphere suggest, and whether a spline has it
 * [IOR15, sec. 3.3, with the corrections stated in criteria.c].
 *
 * At node i the data turn by the angle tau_i; its sign is the indicator Q_i, 0
 * where three nodes are on a great circle.
 *   co-circularity  Q_i = 0, and the data go on in their direction:
 *                   |kappa_g| < epsilon on both sides of the node
 *   nodal           Q_i != 0: kappa_g Q_i >= 0 on both sides
 *   segment         Q_i Q_{i+1} > 0: kappa_g Q_i > 0 on the whole segment
 */

enum ph_sphere_criterion {
  PH_SPHERE_FINE, /* none is violated */
  PH_SPHERE_COCIRCULARITY,
  PH_SPHERE_NODAL,
  PH_SPHERE_SEGMENT
};

/* What the shape of the data asks for. */
struct ph_sphere_shape {
  const struct ph_sphere_data *data;
  double epsilon; /* bound of |kappa_g| at co-circular nodes */
  bool legacy;    /* the measures of the thesis's code: one side of a node, and
                   * theta(P_0,P_1)^2 |K| in place of |kappa_g|, K by the
                   * knots */
  signed char *q; /* [n] indicators; 0 at the ends of open data */
  double *turn;   /* [n] |sine| of the turn from chord to chord */
  bool *inorder;  /* [n] Q_i = 0, and co-circularity is asked */
  size_t *before; /* [n] of nodes in order: the last node before their run of */
  size_t *after;  /* [n] such nodes, and the first one after it; SIZE_MAX: the
                   * run is all of closed data */
};

/*
 * ph_sphere_shape_of: the indicators of data.
 *
 * out  shape  arrays in the arena
 * ret  false when memory is exhausted
 */
bool ph_sphere_shape_of(const struct ph_sphere_data *data, double epsilon,
                        bool legacy, struct ph_arena *arena,
                        struct ph_sphere_shape *shape);

/* ph_sphere_node_fails: the criterion of node i that a spline violates, or
 * FINE.  Reads r and l of the two segments at the node. */
enum ph_sphere_criterion
ph_sphere_node_fails(const struct ph_sphere_shape *shape,
                     const struct ph_sphere_spline *s, size_t i);

/* ph_sphere_segment_fails: SEGMENT where the criterion is asked of segment k,
 * and the sign of K cannot be certified on all of it; else FINE. */
enum ph_sphere_criterion
ph_sphere_segment_fails(const struct ph_sphere_shape *shape,
                        const struct ph_sphere_spline *s, size_t k);

/*
 * ph_sphere_touched: the nodes whose tension is raised for a violated
 * criterion.  Only in legacy the ends of open data are among them, whose
 * tension has no effect, and nodes in order, whose curvature grows with it: in
 * their place stands the node beyond their run.
 *
 * in   at       the node, or the segment
 * out  node[4]  at most 4 of them, in the order of the curve
 * ret  how many
 */
size_t ph_sphere_touched(const struct ph_sphere_shape *shape,
                         enum ph_sphere_criterion criterion, size_t at,
                         size_t node[4]);

/* ph_sphere_criterion_name: "co-circularity", "nodal convexity", "segment
 * convexity". */
const char *ph_sphere_criterion_name(enum ph_sphere_criterion criterion);

/* ---- the curve ----------------------------------------------------------- */

/* From a solved spherical nu-spline to the curve of a result. */

/*
 * ph_sphere_curve: control points on the user's sphere, lengths in his unit.
 *
 * in   waived  [n] not 0 where the shape is not kept; or NULL
 * ret  PH_OK | PH_E_NO_CONVERGENCE (a length; names the segment) |
 *      PH_E_NO_MEMORY
 */
enum ph_status ph_sphere_curve(const struct ph_sphere_spline *s,
                               const struct ph_sphere_shape *shape,
                               const unsigned char *waived,
                               struct ph_arena *arena, struct ph_curve *curve,
                               struct ph_diag *diag);

/* ---- measures of shape --------------------------------------------------- */

/*
 * By how much a spline meets the criteria of shape: numbers that are >= 0 where
 * they hold with a margin, smooth in the tensions, for linear programs. Whether
 * a criterion does hold is for sphere.h to say: on a segment these are
 * samples.
 */

/* Samples of a segment; the most numbers of a segment or node. */
enum { PH_SPHERE_SAMPLES = 9, PH_SPHERE_MEASURES = PH_SPHERE_SAMPLES };

/* ph_sphere_measure_node, ph_sphere_measure_segment: the numbers of what is
 * asked of node i, or of segment k.
 * ret  how many, 0 if nothing is asked; out  g[PH_SPHERE_MEASURES] */
size_t ph_sphere_measure_node(const struct ph_sphere_shape *shape,
                              const struct ph_sphere_spline *s, size_t i,
                              double *g);
size_t ph_sphere_measure_segment(const struct ph_sphere_shape *shape,
                                 const struct ph_sphere_spline *s, size_t k,
                                 double *g);

/* ---- tensions ------------------------------------------------------------ */

/*
 * Tensions that make a spherical nu-spline keep the shape of its data
 * [IOR15, sec. 4.2].
 *
 * Where a criterion is violated, the tensions of the nodes around are raised
 * and the spline is solved again, until all criteria hold.  A tension has an
 * effect on its neighbourhood only, which falls by a factor of about 3.7 from
 * node to node: only there the spline is solved, and judged, again.
 */

enum ph_sphere_increase {
  PH_SPHERE_MINIMAL, /* in the end the smallest that were found sufficient */
  PH_SPHERE_PLUS,    /* nu + by */
  PH_SPHERE_TIMES,   /* nu * by; by itself where nu is 0 */
  PH_SPHERE_REPAIR   /* a little; not for the caller */
};

/* How often tensions are raised at most. */
enum { PH_SPHERE_ROUNDS_MAX = 10000 };

/* Bits of criteria that are gone on without, at a node and of the segment after
 * it; and, of these, that hold at no tension, not in the limit either. */
enum {
  PH_SPHERE_IGNORE_NODE = 1,
  PH_SPHERE_IGNORE_SEGMENT = 2,
  PH_SPHERE_NEVER = 2 /* to shift those bits by */
};

/* How tensions are raised, and where. */
struct ph_sphere_raise {
  const struct ph_sphere_shape *shape;
  enum ph_sphere_increase increase;
  double by;
  bool strict; /* fail if a criterion is violated in the end */
  struct ph_sphere_spline *spline;
  struct ph_sphere_work *work;
  size_t rounds; /* out: how often tensions were raised */
  size_t waived; /* out: criteria that are violated by the spline, of these */
  size_t never;  /* out: such that hold at no tension, and */
  bool beyond;   /* out: the first may hold beyond the largest tensions that
                  * are tried */
  size_t at;     /* out: its node or segment */
  enum ph_sphere_criterion criterion; /* which that is */
  unsigned char *ignored; /* out: [n] bits of those that are violated */
  /* Of the work: */
  bool waive; /* go on without criteria that no tension satisfies, as far as
               * they are tried */
  double *kept_nu;                /* [n] */
  ph_vec3 *kept_x;                /* [n] */
  double *solved;                 /* [n] tensions of the last solution */
  size_t *touched;                /* [n] nodes of this round */
  unsigned char *planned;         /* [n] and what it does to them */
  struct ph_sphere_range *ranges; /* [n] where to look, in order and apart */
  size_t ranges_n;
};

/*
 * ph_sphere_keep_shape: raises the tensions of a solution.
 *
 * inout raise  the first six members are given
 * ret  PH_OK | PH_E_NO_CONVERGENCE (no spline) | PH_E_NO_MEMORY; and if strict
 *      where a criterion is violated, PH_E_INFEASIBLE (the first is at all
 *      tensions that were tried, and in the limit) | PH_E_NO_CONVERGENCE (too
 *      many rounds, or tensions beyond precision)
 */
enum ph_status ph_sphere_keep_shape(struct ph_sphere_raise *raise,
                                    struct ph_arena *scratch);

/* ph_sphere_violated: the first criterion in a range that the spline violates,
 * FINE if none; at: its node or segment, from `from` places into the range,
 * which is increased past it. */
enum ph_sphere_criterion ph_sphere_violated(const struct ph_sphere_raise *raise,
                                            struct ph_sphere_range range,
                                            size_t *from, size_t *at);

/* ---- the smallest tensions ----------------------------------------------- */

/* The smallest tensions that keep the shape of data, starting from some that
 * do. */

/*
 * ph_sphere_minimise: lowers the sum of the tensions to a local minimum,
 * nearly, while all criteria that the spline satisfies go on to hold.
 *
 * Blocks of tensions are solved and judged with their neighbourhood only: the
 * caller solves and judges the whole once more.
 *
 * inout raise  after its rounds
 * ret  false when memory is exhausted
 */
bool ph_sphere_minimise(struct ph_sphere_raise *raise,
                        struct ph_arena *scratch);

#endif
