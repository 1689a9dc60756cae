/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Parts of a curve for its cubics (see approx.h).
 *
 * A part that no one or two cubics are near enough to is cut at the inflection
 * next to its middle: cubics have none.  A part without inflections is halved
 * until it is near everywhere, which make_even then improves.
 *
 * All rules are the same for the curve backward.
 */
#include "solve/tc/approx.h"

#include "kernel/bern.h"
#include "kernel/bern_low.h"

#include <float.h>
#include <math.h>

/* So often is a part halved; and so many parts have room at first. */
enum { DEPTH = 48, PARTS = 64 };

/* Cuts beside a middle where the curve stands still, as a part of the part. */
static const double BESIDE = 0.0625;

/* ret  PH_OK | PH_E_NO_CONVERGENCE beyond the limit | PH_E_NO_MEMORY */
static enum ph_status plan_add(struct ph_tc_plan *plan,
                               const struct ph_tc_part *part,
                               struct ph_diag *diag) {
  if (plan->n == plan->limit) {
    return ph_fail(diag, PH_E_NO_CONVERGENCE, NULL,
                   "would need more than %zu cubics", plan->limit);
  }
  plan->part = ph_arena_grow(plan->arena, plan->part, plan->n,
                             sizeof *plan->part, PARTS, &plan->room);
  if (!plan->part) {
    return ph_fail_memory(diag);
  }
  plan->part[plan->n++] = *part;
  plan->cubics += part->n;
  return PH_OK;
}

/* ---- parts of equal distance --------------------------------------------- */

/*
 * Parts with even distances, and no more of them than needed (see
 * approx.h).
 *
 * The distance of one cubic grows like the fourth power of its part: a part at
 * the distance e counts (e/tolerance)^(1/4), and the sum of all is how many it
 * takes, about, whatever the parts are.  Knots move to where each part counts
 * the same (equidistribution); the distances there give new counts.
 *
 * Knots are rounded to few bits, so that rounding errors, which differ for the
 * curve backward or turned, do not show.
 */

/*
 * Sweeps for one number of parts, all sweeps, and those that only make an
 * accepted mesh more even.  A number of parts is given up when a sweep leaves
 * more than SHRINK of what is beyond the tolerance, or the counts promise more
 * than HOPELESS times as many.
 *
 * With 1000 random curves, twice as many sweeps save no cubic and half as many
 * cost one in 400; SHRINK from .5 to .9 and HOPELESS from 1 to 1.1 matter less.
 */
enum { TRIES = 12, SWEEPS = 36, POLISH = 2 };
static const double SHRINK = 0.7, HOPELESS = 1.02;

/* A knot is rounded to this fraction of the parts beside it, which changes
 * their distances by a percent at most. */
static const double GRAIN = 0x1p-10;

struct mesh {
  size_t n;
  double *u;             /* [n + 1] */
  double *e;             /* [n] distances */
  double *count;         /* [n] */
  unsigned char *cubics; /* [n] */
  double worst;          /* distance */
  double sum;            /* of counts */
  size_t total;          /* of cubics */
};

struct evener {
  const struct ph_arena *arena; /* knows how much time there is */
  const struct ph_tc_target *target;
  double tolerance;
  struct mesh best, tried, next;
  int sweeps; /* that are left */
};

static bool mesh_alloc(struct mesh *m, struct ph_arena *arena, size_t n) {
  m->u = ph_arena_array(arena, n + 1, sizeof *m->u);
  m->e = ph_arena_array(arena, n, sizeof *m->e);
  m->count = ph_arena_array(arena, n, sizeof *m->count);
  m->cubics = ph_arena_array(arena, n, sizeof *m->cubics);
  return m->u && m->e && m->count && m->cubics;
}

/* Counts; a part far beyond the tolerance counts as two. */
static void weigh(const struct evener *s, struct mesh *m) {
  double noise = s->target->noise;
  m->worst = m->sum = 0;
  m->total = 0;
  for (size_t i = 0; i < m->n; i++) {
    double ratio = (m->e[i] - noise) / (s->tolerance - noise);
    m->count[i] = ratio < PH_TC_FAR ? sqrt(sqrt(ratio)) : 2;
    m->sum += m->count[i];
    m->worst = m->e[i] > m->worst ? m->e[i] : m->worst;
    m->total += m->cubics[i];
  }
}

/* n + 1 knots where each part counts the same by the mesh `old`. */
static void place(const struct mesh *old, struct mesh *m, size_t n) {
  size_t i = 0;
  double before = 0;
  m->n = n;
  m->u[0] = old->u[0];
  m->u[n] = old->u[old->n];
  for (size_t j = 1; j < n; j++) {
    double goal = old->sum * ((double)j / (double)n), v;
    while (i + 1 < old->n && before + old->count[i] < goal) {
      before += old->count[i++];
    }
    v = (goal - before) / old->count[i];
    v = v < 1 ? v : 1;
    m->u[j] = old->u[i] + v * (old->u[i + 1] - old->u[i]);
  }
}

static void round_knots(struct mesh *m) {
  double left = m->u[0];
  for (size_t j = 1; j < m->n; j++) {
    double here = m->u[j], a = here - left, b = m->u[j + 1] - here;
    double gap = a < b ? a : b;
    /* 4/3: even parts of a power of two are not at a step of ilogb */
    double grain = gap > 0 ? ldexp(GRAIN, ilogb(gap * 4 / 3)) : 0;
    left = here;
    m->u[j] = grain > 0 ? grain * round(here / grain) : here;
  }
}

static void swap(struct mesh *a, struct mesh *b) {
  struct mesh m = *a;
  *a = *b;
  *b = m;
}

/* One sweep: n parts by the counts of `old`, to s->tried. */
static void sweep(struct evener *s, const struct mesh *old, size_t n) {
  const struct ph_tc_patch none = {.n = 1, .distance = (double)INFINITY};
  struct mesh *m = &s->next;
  struct ph_tc_knot from;
  place(old, m, n);
  round_knots(m);
  from = ph_tc_knot_at(s->target, m->u[0]);
  for (size_t i = 0; i < n; i++) {
    struct ph_tc_knot to = ph_tc_knot_at(s->target, m->u[i + 1]);
    struct ph_tc_patch patch =
        ph_arena_late(s->arena)
            ? none
            : ph_tc_patch_of(s->target, &from, &to, PH_TC_ONE, s->tolerance);
    m->e[i] = patch.distance;
    m->cubics[i] = (unsigned char)patch.n;
    from = to;
  }
  weigh(s, m);
  swap(m, &s->tried);
  s->sweeps--;
}

/* Whether n parts were found; they are the best then.  What is beyond the
 * tolerance must shrink from sweep to sweep. */
static bool try_count(struct evener *s, size_t n) {
  double beyond = (double)INFINITY;
  for (int i = 0; i < TRIES && s->sweeps > 0; i++) {
    double before = beyond;
    sweep(s, i > 0 ? &s->tried : &s->best, n);
    beyond = s->tried.worst - s->tolerance;
    if (beyond <= 0 && s->tried.total <= s->best.total) {
      swap(&s->best, &s->tried);
      return true;
    }
    if (i > 0 &&
        (!(beyond < SHRINK * before) || s->tried.sum > HOPELESS * (double)n)) {
      return false;
    }
  }
  return false;
}

/* What the counts promise, but more than `failed` and less than the best. */
static size_t promise(const struct evener *s, size_t failed) {
  double sum = ceil(s->best.sum);
  size_t n = sum < (double)s->best.n ? (size_t)sum : s->best.n;
  return n > failed ? n : failed + 1;
}

static void even(struct evener *s) {
  size_t failed = 0;
  for (size_t n; n = promise(s, failed), n < s->best.n && s->sweeps > 0;) {
    failed = try_count(s, n) ? failed : n;
  }
  s->sweeps = POLISH;
  while (s->sweeps > 0 && s->best.n > 1) {
    sweep(s, &s->best, s->best.n);
    if (s->tried.worst < s->best.worst && s->tried.total <= s->best.total) {
      swap(&s->best, &s->tried);
    }
  }
}

/* The mesh of the parts from `first` on, to s->best. */
static void read_plan(struct evener *s, const struct ph_tc_plan *plan,
                      size_t first) {
  struct mesh *m = &s->best;
  m->n = plan->n - first;
  m->u[0] = plan->part[first].from;
  for (size_t i = 0; i < m->n; i++) {
    const struct ph_tc_part *part = &plan->part[first + i];
    m->u[i + 1] = part->to;
    m->e[i] = part->distance;
    m->cubics[i] = (unsigned char)part->n;
  }
  weigh(s, m);
}

/* Replaces the parts from `first` on, all of one cubic or without choice, by
 * fewer of them with distances that are even, where it finds them. */
static enum ph_status make_even(const struct ph_tc_target *target, size_t first,
                                double tolerance, struct ph_tc_plan *plan,
                                struct ph_diag *diag) {
  struct ph_arena scratch = ph_arena_beside(plan->arena);
  struct evener s = {.arena = &scratch,
                     .target = target,
                     .tolerance = tolerance,
                     .sweeps = SWEEPS};
  size_t n = plan->n - first;
  enum ph_status status = PH_OK;
  if (n < 2) {
    return PH_OK;
  }
  if (!mesh_alloc(&s.best, &scratch, n) || !mesh_alloc(&s.tried, &scratch, n) ||
      !mesh_alloc(&s.next, &scratch, n)) {
    ph_arena_free(&scratch);
    return ph_fail_memory(diag);
  }
  read_plan(&s, plan, first);
  plan->cubics -= s.best.total;
  plan->n = first;
  even(&s);
  for (size_t i = 0; status == PH_OK && i < s.best.n; i++) {
    struct ph_tc_part part = {.from = s.best.u[i],
                              .to = s.best.u[i + 1],
                              .distance = s.best.e[i],
                              .kind = PH_TC_ONE,
                              .n = s.best.cubics[i]};
    status = plan_add(plan, &part, diag);
  }
  ph_arena_free(&scratch);
  return status;
}

/* ---- parts near enough -------------------------------------------------- */

struct cover {
  const struct ph_tc_target *target;
  const double *u; /* inflections */
  double tolerance;
  struct ph_tc_plan *plan;
  struct ph_diag *diag;
};

/* Adds the part if its cubics are near enough. */
static enum ph_status add_if_near(struct cover *c,
                                  const struct ph_tc_knot *from,
                                  const struct ph_tc_knot *to,
                                  enum ph_tc_kind kind, bool *near,
                                  double *distance) {
  struct ph_tc_patch patch =
      ph_tc_patch_of(c->target, from, to, kind, c->tolerance);
  struct ph_tc_part part = {.from = from->u,
                            .to = to->u,
                            .distance = patch.distance,
                            .kind = kind,
                            .n = (unsigned)patch.n};
  if (ph_arena_late(c->plan->arena)) {
    return ph_fail_memory(c->diag);
  }
  *near = patch.distance <= c->tolerance;
  *distance = patch.distance;
  return *near ? plan_add(c->plan, &part, c->diag) : PH_OK;
}

static enum ph_status bisect(struct cover *c, const struct ph_tc_knot *from,
                             const struct ph_tc_knot *to, int depth) {
  const struct ph_tc_target *t = c->target;
  double middle = (from->u + to->u) / 2, distance;
  double beside = BESIDE * (to->u - from->u);
  struct ph_tc_knot knot = ph_tc_knot_at(t, middle), other;
  bool near;
  enum ph_status status = add_if_near(c, from, to, PH_TC_ONE, &near, &distance);
  if (status != PH_OK || near) {
    return status;
  }
  if (depth == DEPTH) {
    return ph_fail(c->diag, PH_E_NO_CONVERGENCE, NULL,
                   "has no cubics within the tolerance near its parameter "
                   "%.6g",
                   middle);
  }
  if (ph_cplx_norm2(knot.tangent) > 0) {
    status = bisect(c, from, &knot, depth + 1);
    return status == PH_OK ? bisect(c, &knot, to, depth + 1) : status;
  }
  /* A curve that stands still in the middle is cut on both sides; not so if
   * both are at the same place. */
  knot = ph_tc_knot_at(t, middle - beside);
  other = ph_tc_knot_at(t, middle + beside);
  status = bisect(c, from, &knot, depth + 1);
  if (ph_cplx_abs(ph_cplx_sub(knot.p, other.p)) >
      ph_tc_shortest(t, c->tolerance)) {
    status = status == PH_OK ? bisect(c, &knot, &other, depth + 1) : status;
    knot = other;
  }
  return status == PH_OK ? bisect(c, &knot, to, depth + 1) : status;
}

/* The inflection of u[n] next to the middle of a part, or the middle if two are
 * equally near. */
static double cut_of(const double *u, size_t n, double from, double to) {
  double middle = (from + to) / 2, best = (double)INFINITY, at = middle;
  for (size_t i = 0; i < n; i++) {
    double d = fabs(u[i] - middle);
    if (d < best) {
      at = fabs(d - best) <= 0x1p-29 ? middle : u[i];
      best = d;
    } else if (d - best <= 0x1p-29) {
      at = middle;
    }
  }
  return at;
}

static enum ph_status cover(struct cover *c, const struct ph_tc_knot *from,
                            const struct ph_tc_knot *to, size_t low,
                            size_t high) {
  size_t first = c->plan->n, left = low, right;
  struct ph_tc_knot cut;
  double distance;
  bool near;
  enum ph_status status =
      add_if_near(c, from, to, PH_TC_ONE_OR_PAIR, &near, &distance);
  if (status != PH_OK || near) {
    return status;
  }
  cut =
      ph_tc_knot_at(c->target, cut_of(c->u + low, high - low, from->u, to->u));
  if (low == high || !(ph_cplx_norm2(cut.tangent) > 0)) {
    status = bisect(c, from, to, 0);
    return status == PH_OK
               ? make_even(c->target, first, c->tolerance, c->plan, c->diag)
               : status;
  }
  while (left < high && c->u[left] < cut.u) {
    left++;
  }
  right = left < high && c->u[left] <= cut.u ? left + 1 : left;
  status = cover(c, from, &cut, low, left);
  return status == PH_OK ? cover(c, &cut, to, right, high) : status;
}

enum ph_status ph_tc_plan_curve(const struct ph_tc_target *target,
                                const double *u, size_t n, double tolerance,
                                struct ph_tc_plan *plan, struct ph_diag *diag) {
  struct cover c = {.target = target,
                    .u = u,
                    .tolerance = tolerance,
                    .plan = plan,
                    .diag = diag};
  struct ph_tc_knot from = ph_tc_knot_at(target, 0);
  struct ph_tc_knot to = ph_tc_knot_at(target, 1);
  if (!(tolerance > target->noise)) {
    return ph_fail(diag, PH_E_NO_CONVERGENCE, NULL,
                   "is not known to the tolerance: rounding alone may be up "
                   "to %.2g of its coordinates",
                   target->noise / target->size);
  }
  return cover(&c, &from, &to, 0, n);
}

/* ---- inflections --------------------------------------------------------- */

/*
 * Inflections of a Bezier curve: the sign changes of C' x C'', a polynomial of
 * degree 2 degree - 3, by halving its Bernstein form, which has no more roots
 * than sign changes of its coefficients.
 */

/* Dyadic intervals of width 2^-LEVELS, and as many intervals as are looked at:
 * enough for every simple root; double ones need not be found. */
enum { LEVELS = 31, VISITS = 100 };

/* Of what degree a part is one of a middle degree, where it can be: to find
 * that takes as long as some cuts of less. */
enum { SMOOTHED = 256 };

struct search {
  const struct ph_arena *arena; /* knows how much time there is */
  size_t degree;
  double noise;  /* coefficients up to this size have no sign */
  ph_cplx *pool; /* [2 LEVELS + 4][degree + 1]: all, room, and halves */
  double *u;
  size_t n, room;
  size_t visits;
};

/* binomial(n, i), i <= n, all positive; n is so small that they are finite. */
static void binomials(size_t n, double *b) {
  b[0] = 1;
  for (size_t i = 1; i <= n; i++) {
    b[i] = b[i - 1] * (double)(n - i + 1) / (double)i;
  }
}

/* The coefficients of C' x C'' over some positive number. */
static void curvature_form(const struct ph_tc_bezier *curve, double *binomial,
                           struct search *s) {
  size_t n = curve->degree;
  double *b1 = binomial, *b2 = b1 + n, *b = b2 + n, size = 0;
  const ph_cplx *p = curve->p;
  binomials(n - 1, b1);
  binomials(n - 2, b2);
  binomials(2 * n - 3, b);
  for (size_t k = 0; k <= 2 * n - 3; k++) {
    s->pool[k] = ph_cplx_of(0, 0);
  }
  for (size_t i = 0; i < n; i++) {
    ph_cplx d = ph_cplx_sub(p[i + 1], p[i]);
    double length = ph_cplx_abs(d);
    size = length > size ? length : size;
    for (size_t j = 0; j + 1 < n; j++) {
      ph_cplx dd = ph_cplx_add(ph_cplx_sub(p[j + 2], p[j + 1]),
                               ph_cplx_sub(p[j], p[j + 1]));
      s->pool[i + j].re += b1[i] / b[i + j] * b2[j] * ph_cplx_cross(d, dd);
    }
  }
  s->degree = 2 * n - 3;
  s->noise = 64 * (double)n * DBL_EPSILON * size * size;
}

static int sign_of(const struct search *s, ph_cplx c) {
  return c.re > s->noise ? 1 : c.re < -s->noise ? -1 : 0;
}

/* A part of the polynomial: coefficients in re. */
struct form {
  const ph_cplx *c; /* [degree + 1] */
  size_t degree;
};

/* The sign of the first or last coefficient that has one. */
static int end_sign(const struct search *s, const struct form *f, bool last) {
  for (size_t k = 0; k <= f->degree; k++) {
    int sign = sign_of(s, f->c[last ? f->degree - k : k]);
    if (sign != 0) {
      return sign;
    }
  }
  return 0;
}

static size_t changes_of(const struct search *s, const struct form *f) {
  int sign = end_sign(s, f, false);
  size_t n = 0;
  for (size_t k = 0; k <= f->degree; k++) {
    if (sign * sign_of(s, f->c[k]) < 0) {
      sign = -sign;
      n++;
    }
  }
  return n;
}

static void found(struct search *s, double u) {
  if (s->n < s->room && (s->n == 0 || u > s->u[s->n - 1])) {
    s->u[s->n++] = u;
  }
}

/* The only root of an interval, by halving it as the search does: the middle of
 * the last one, or of the first whose middle is 0 to rounding. */
static double root_of(const struct search *s, int before, double from,
                      double to, int depth) {
  for (; depth < LEVELS; depth++) {
    double middle = (from + to) / 2;
    int sign = sign_of(s, ph_bern_value(s->pool, s->degree, middle));
    if (sign == 0) {
      return middle;
    }
    *(sign == before ? &from : &to) = middle;
  }
  return (from + to) / 2;
}

static void look(struct search *s, struct form f, double from, double to,
                 int depth) {
  ph_cplx near[PH_BERN_NEAR + 1], *room = s->pool + (s->degree + 1);
  ph_cplx *left = room + (2 * (size_t)depth + 1) * (s->degree + 1);
  ph_cplx *right = left + (s->degree + 1);
  struct form low, high;
  double middle = (from + to) / 2, away;
  size_t changes = changes_of(s, &f), degree;
  if (changes == 0 || s->visits == 0 || ph_arena_late(s->arena)) {
    return;
  }
  s->visits--;
  if (depth == LEVELS) {
    if (end_sign(s, &f, false) != end_sign(s, &f, true)) {
      found(s, middle);
    }
    return;
  }
  if (changes == 1 && s->degree >= PH_BERN_HIGH) {
    found(s, root_of(s, end_sign(s, &f, false), from, to, depth));
    return;
  }
  degree =
      f.degree < SMOOTHED ? 0 : ph_bern_near(f.c, f.degree, room, near, &away);
  if (degree > 0 && away <= s->noise) {
    f = (struct form){near, degree};
  }
  ph_bern_cut(f.c, f.degree, 0.5, left, right);
  low = (struct form){left, f.degree};
  high = (struct form){right, f.degree};
  look(s, low, from, middle, depth + 1);
  if (sign_of(s, right[0]) == 0 &&
      end_sign(s, &low, true) * end_sign(s, &high, false) < 0) {
    found(s, middle);
  }
  look(s, high, middle, to, depth + 1);
}

enum ph_status ph_tc_inflections(const struct ph_tc_bezier *curve,
                                 struct ph_arena *arena, double *u, size_t *n,
                                 struct ph_diag *diag) {
  size_t m = curve->degree;
  struct search s = {
      .arena = arena, .u = u, .room = 2 * m, .visits = VISITS * m};
  struct ph_mark mark = ph_arena_mark(arena);
  double *binomial;
  *n = 0;
  if (m < 3) {
    return PH_OK; /* a parabola has none */
  }
  s.pool =
      ph_arena_array(arena, (2 * LEVELS + 4) * (2 * m - 2), sizeof *s.pool);
  binomial = ph_arena_array(arena, 4 * m, sizeof *binomial);
  if (s.pool && binomial) {
    curvature_form(curve, binomial, &s);
    look(&s, (struct form){s.pool, s.degree}, 0, 1, 0);
    *n = s.n;
  }
  ph_arena_release(arena, mark);
  return s.pool && binomial ? PH_OK : ph_fail_memory(diag);
}
