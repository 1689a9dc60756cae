/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Every solution of the C2 equations (c2.h), by a homotopy.
 *
 * The family.  Equation k is F[k] = mm b[k]^2 + R[k](b) - wanted, with R the
 * terms that have b[k-1] or b[k+1] (struct ph_planar_form).  Without R it
 * would be solved by b[k] = +- sqrt(wanted / mm).  [GON18, (2.23)-(2.25)] bring
 * in the R bit by bit; with a complex gamma (Sommese, Wampler 2005), because on
 * the way with gamma = 1 roots can meet, as those of points on a line may:
 *
 *   gamma (1 - t) (mm b[k]^2 - wanted) + t F[k] = 0,   t = 0 ... 1       (1)
 *
 * Divided by gamma (1 - t) + t this is, with x[k] = sqrt(mm) b[k],
 *
 *   H[k] = x[k]^2 + tau R[k](x) - wanted = 0,                            (2)
 *   tau = t / (gamma (1 - t) + t),
 *
 * in which tau runs from 0 to 1 on an arc of a circle.  The roots are analytic
 * in tau but for finitely many values, which a generic arc avoids.
 *
 * Following a root.  Predictor: the cubic that has the last two points and
 * their derivatives, of error O(dt^4).  Corrector: two steps of Newton, the
 * second at most a tenth of the first.  The size of the first is the error of
 * the predictor, by which the next step dt is chosen.
 *
 * The end.  Newton on the equations themselves, to rounding.  Two ends are the
 * same root if their balls of Kantorovich's theorem (c2.h)
 * meet.  As many different roots as Bezout's theorem allows are all roots, no
 * matter how they were found.  So a path that was lost, or that went astray
 * and met another's end, shows; then all are followed again with another gamma
 * and smaller steps.
 *
 * Multiple roots.  Beside a double root h is 1/2 or more, however near: the
 * theorem tells nothing apart there.  Ends without a ball that lie close
 * together are one curve, of as many solutions as paths arrived.  Their number
 * is then not proved but observed.  Newton still converges to them, linearly,
 * and the unknowns have half of the digits only, while the equations hold to
 * rounding.
 */
#include "solve/planar/c2.h"

#include <float.h>
#include <math.h>
#include <string.h>

enum { UNKNOWNS_MAX = PH_PLANAR_ALL_MAX + 2 };

/* What is tried, one after the other: the argument of gamma, and the error of
 * the predictor that is aimed at, relative to max |x|.  The first has been
 * enough for every set of data that was not made to break it. */
static const struct attempt {
  double angle, error;
} attempts[] = {{0.7, 1e-3}, {-1.1, 1e-4}, {1.5, 1e-5}, {-0.4, 1e-6}};

enum { ATTEMPTS = sizeof attempts / sizeof attempts[0] };

/* Of a path: the first step, the smallest, and how many. */
static const double STEP_FIRST = 0.02, STEP_SMALLEST = 1e-10;
enum { STEPS_MAX = 20000 };

/* The errors that are let pass, in units of those aimed at, and the ratio of
 * the corrector's two steps, unless the second is nothing. */
static const double ERROR_LIMIT = 10, CONTRACTION = 0.1, NOTHING = 1e-9;

/* Steps shrink for ever on the way into a multiple root.  From here on Newton
 * is left to find it. */
static const double NEARLY_THERE = 1e-6;

/* Newton's steps at the end.  One that is relatively as small as the first is
 * rounding; as the second, it is if it is not smaller than the one before. */
enum { POLISH_CAP = 60 };
static const double POLISHED = 4 * DBL_EPSILON, STAGNANT = 1e-10;

/* A root of a smaller h is simple; of a double root it is 1/2 and more. */
static const double SIMPLE = 0.25;
/* Distances, relative to max |b|, of ends that are the same: rounding, beside
 * the radii of Kantorovich; and of multiple roots. */
static const double SAME = 1e-12, SAME_MULTIPLE = 1e-5;

/* H of (2): the coefficients of R, and the unit of x[k]. */
struct term {
  double ll, lm, lr, mr, rr;
  double unit;
  ph_cplx wanted;
};

struct family {
  size_t n;
  struct term term[UNKNOWNS_MAX];
  const struct attempt *attempts; /* [ATTEMPTS] */
  ph_cplx gamma;                  /* of the present one */
  struct ph_tri tri;
  const struct ph_arena *arena; /* knows how much time there is */
};

/* A point of a path, with its derivative. */
struct point {
  double t;
  ph_cplx x[UNKNOWNS_MAX], slope[UNKNOWNS_MAX];
};

/* Where the paths end. */
struct ends {
  size_t n;         /* arrived */
  ph_cplx *b;       /* [n][unknowns] */
  double *key;      /* [n] near for ends that are near, for b and -b the same */
  double *apart;    /* [n] nearer than this is the same */
  bool *is_simple;  /* [n] */
  size_t *copies;   /* [n] that are the same as this one; 0: as one before */
  double key_apart; /* keys further apart than this are different */
};

static double size_of(const ph_cplx *x, size_t n) {
  double max2 = 0;
  for (size_t i = 0; i < n; i++) {
    double x2 = ph_cplx_norm2(x[i]);
    max2 = x2 > max2 || isnan(x2) ? x2 : max2;
  }
  return sqrt(max2);
}

static void family_init(struct family *s, const struct ph_planar_c2 *c2) {
  size_t n = s->n;
  for (size_t i = 0; i < n; i++) {
    s->term[i].unit = 1 / sqrt(ph_planar_form(c2, i).mm);
  }
  for (size_t i = 0; i < n; i++) {
    struct ph_planar_form f = ph_planar_form(c2, i);
    struct term *e = &s->term[i];
    double l = s->term[i > 0 ? i - 1 : n - 1].unit;
    double r = s->term[i + 1 < n ? i + 1 : 0].unit;
    l *= c2->closed && i == 0 ? c2->twist.re : 1;
    r *= c2->closed && i + 1 == n ? c2->twist.re : 1;
    e->ll = f.ll * l * l;
    e->lm = f.lm * l * e->unit;
    e->lr = f.lr * l * r;
    e->mr = f.mr * e->unit * r;
    e->rr = f.rr * r * r;
    e->wanted = f.wanted;
  }
}

/* tau of (2), and its derivative with respect to t. */
static ph_cplx tau_of(ph_cplx gamma, double t, ph_cplx *slope) {
  ph_cplx inverse =
      ph_cplx_inverse(ph_cplx_of(gamma.re * (1 - t) + t, gamma.im * (1 - t)));
  *slope = ph_cplx_mul(gamma, ph_cplx_mul(inverse, inverse));
  return ph_cplx_scale(t, inverse);
}

/* a p + b q */
static inline ph_cplx sum2(double a, ph_cplx p, double b, ph_cplx q) {
  return ph_cplx_of(a * p.re + b * q.re, a * p.im + b * q.im);
}

/* a p + b q + c r */
static inline ph_cplx sum3(double a, ph_cplx p, double b, ph_cplx q, double c,
                           ph_cplx r) {
  return ph_cplx_of(a * p.re + b * q.re + c * r.re,
                    a * p.im + b * q.im + c * r.im);
}

/* Solves H'(x) y = H, or, for the derivative of the path, H'(x) y = -dH/dt. */
static void solve(struct family *s, const ph_cplx *x, double t, bool derivative,
                  ph_cplx *y) {
  size_t n = s->n;
  struct ph_tri_row row[UNKNOWNS_MAX];
  ph_cplx tau_slope, tau = tau_of(s->gamma, t, &tau_slope);
  for (size_t i = 0; i < n; i++) {
    const struct term *e = &s->term[i];
    ph_cplx l = x[i > 0 ? i - 1 : n - 1], m = x[i];
    ph_cplx r = x[i + 1 < n ? i + 1 : 0];
    /* the derivatives of R, and R, half their sum times l, m, r */
    ph_cplx by_l = sum3(2 * e->ll, l, e->lm, m, e->lr, r);
    ph_cplx by_m = sum2(e->lm, l, e->mr, r);
    ph_cplx by_r = sum3(e->lr, l, e->mr, m, 2 * e->rr, r);
    ph_cplx rest = ph_cplx_add(ph_cplx_mul(by_l, l), ph_cplx_mul(by_m, m));
    rest = ph_cplx_scale(0.5, ph_cplx_add(rest, ph_cplx_mul(by_r, r)));
    row[i].lo = ph_cplx_mul(tau, by_l);
    row[i].di = ph_cplx_add(ph_cplx_scale(2, m), ph_cplx_mul(tau, by_m));
    row[i].up = ph_cplx_mul(tau, by_r);
    if (derivative) {
      row[i].f = ph_cplx_scale(-1, ph_cplx_mul(tau_slope, rest));
    } else {
      rest = ph_cplx_add(ph_cplx_mul(m, m), ph_cplx_mul(tau, rest));
      row[i].f = ph_cplx_sub(rest, e->wanted);
    }
  }
  ph_tri_begin(&s->tri, n, row[0], row[n - 1]);
  for (size_t i = 1; i + 1 < n; i++) {
    ph_tri_push(&s->tri, &row[i]);
  }
  ph_tri_finish(&s->tri, y);
}

/* Start `signs` of a path: bit i is the sign of x[i]; b and -b are the same. */
static void start(struct family *s, size_t signs, struct point *p) {
  p->t = 0;
  for (size_t i = 0; i < s->n; i++) {
    p->x[i] =
        ph_cplx_scale(signs >> i & 1 ? -1 : 1, ph_cplx_sqrt(s->term[i].wanted));
  }
  solve(s, p->x, 0, true, p->slope);
}

/* The Hermite cubic through a and b, or without a the tangent at b, at t. */
static void predict(size_t n, const struct point *a, const struct point *b,
                    double t, ph_cplx *x) {
  double h, u, from_a, from_b, slope_a, slope_b;
  if (!a) {
    for (size_t i = 0; i < n; i++) {
      x[i] = sum2(1, b->x[i], t - b->t, b->slope[i]);
    }
    return;
  }
  h = b->t - a->t;
  u = (t - a->t) / h;
  from_b = u * u * (3 - 2 * u);
  from_a = 1 - from_b;
  slope_a = h * u * (u - 1) * (u - 1);
  slope_b = h * u * u * (u - 1);
  for (size_t i = 0; i < n; i++) {
    x[i] = ph_cplx_add(sum2(from_a, a->x[i], from_b, b->x[i]),
                       sum2(slope_a, a->slope[i], slope_b, b->slope[i]));
  }
}

static void newton_step(struct family *s, ph_cplx *x, double t, double *size) {
  ph_cplx step[UNKNOWNS_MAX];
  solve(s, x, t, false, step);
  *size = size_of(step, s->n);
  for (size_t i = 0; i < s->n; i++) {
    x[i] = ph_cplx_sub(x[i], step[i]);
  }
}

/*
 * Corrects a predicted point.
 *
 * out  error  of the predictor, relative to max |x|
 * ret  whether that was little enough and the corrector converges
 */
static bool correct(struct family *s, struct point *p, double limit,
                    double *error) {
  double first, second, size;
  newton_step(s, p->x, p->t, &first);
  size = size_of(p->x, s->n);
  *error = first / size;
  if (!(*error <= limit)) {
    return false;
  }
  newton_step(s, p->x, p->t, &second);
  return second <= CONTRACTION * first || second <= NOTHING * size;
}

/* Between low and high; low if x is NaN. */
static double clamp(double x, double low, double high) {
  return !(x > low) ? low : x > high ? high : x;
}

/* Follows one path.  ret  whether it arrived, at x */
static bool follow(struct family *s, size_t signs, double wanted, ph_cplx *x) {
  struct point room[3], *before = NULL, *here = &room[0], *next = &room[1];
  double dt = STEP_FIRST;
  start(s, signs, here);
  for (int i = 0; i < STEPS_MAX && !ph_arena_late(s->arena); i++) {
    double error, factor;
    bool good;
    next->t = here->t + dt < 1 ? here->t + dt : 1;
    predict(s->n, before, here, next->t, next->x);
    good = correct(s, next, ERROR_LIMIT * wanted, &error);
    factor = 0.9 * sqrt(wanted / error);
    factor = before ? sqrt(factor) : factor; /* of order 4, at first 2 */
    if (!good) {
      dt *= clamp(factor, 0.1, 0.5);
      if (!(dt > STEP_SMALLEST)) {
        memcpy(x, here->x, s->n * sizeof *x);
        return 1 - here->t < NEARLY_THERE;
      }
      continue;
    }
    if (next->t >= 1) {
      memcpy(x, next->x, s->n * sizeof *x);
      return true;
    }
    solve(s, next->x, next->t, true, next->slope);
    dt *= clamp(factor, 0.5, 2);
    {
      struct point *oldest = before ? before : &room[2];
      before = here;
      here = next;
      next = oldest;
    }
  }
  return false;
}

/*
 * Newton on the equations themselves, until its steps are rounding, or get no
 * smaller while the equations hold as well as the solver asks.
 */
static bool polish(const struct ph_planar_c2 *c2, struct ph_tri *tri,
                   ph_cplx *b) {
  size_t n = ph_planar_unknowns(c2);
  double before = HUGE_VAL;
  for (int i = 0; i < POLISH_CAP; i++) {
    ph_cplx step[UNKNOWNS_MAX];
    struct ph_planar_measure m = ph_planar_newton_step(c2, b, tri, step);
    double size = size_of(step, n) / size_of(b, n);
    if (size <= POLISHED ||
        (!(size <= 0.9 * before) &&
         (size <= STAGNANT || ph_planar_is_solved(c2, b, &m)))) {
      return true;
    }
    if (!isfinite(size)) {
      return false;
    }
    for (size_t j = 0; j < n; j++) {
      b[j] = ph_cplx_sub(b[j], step[j]);
    }
    before = size;
  }
  return false;
}

/* Adds an end, b, which is in its place already. */
static bool ends_add(struct ends *ends, const struct ph_planar_c2 *c2,
                     struct ph_arena *scratch) {
  size_t n = ph_planar_unknowns(c2), at = ends->n++;
  const ph_cplx *b = ends->b + at * n;
  struct ph_kantorovich k;
  double size = size_of(b, n), apart, key = 0;
  if (!ph_planar_kantorovich(c2, b, scratch, &k)) {
    return false;
  }
  ends->is_simple[at] = k.h <= SIMPLE;
  apart = ends->is_simple[at] ? k.radius + SAME * size : SAME_MULTIPLE * size;
  for (size_t i = 0; i < n; i++) {
    key += (double)(i + 1) * (b[i].re * b[i].re - b[i].im * b[i].im);
  }
  ends->key[at] = key;
  ends->apart[at] = apart;
  ends->copies[at] = 1;
  /* |x^2 - y^2| <= |x - y| (2 |x| + |x - y|), and the parts sum to n^2 */
  apart *= 2 * (double)(n * n) * (2 * size + 2 * apart);
  ends->key_apart = apart > ends->key_apart ? apart : ends->key_apart;
  return true;
}

/* Whether a and b, or a and -b, are at most `apart` apart. */
static bool is_near(const ph_cplx *a, const ph_cplx *b, size_t n,
                    double apart) {
  bool same = true, opposite = true;
  double apart2 = apart * apart;
  for (size_t i = 0; i < n && (same || opposite); i++) {
    same = same && ph_cplx_norm2(ph_cplx_sub(a[i], b[i])) <= apart2;
    opposite = opposite && ph_cplx_norm2(ph_cplx_add(a[i], b[i])) <= apart2;
  }
  return same || opposite;
}

/*
 * Finds the ends that are the same.
 *
 * in   arena  knows how much time there is
 * ret  solutions: ends, and a simple root but once; fewer without time
 */
static size_t ends_compare(struct ends *ends, size_t n,
                           const struct ph_arena *arena) {
  size_t solutions = 0;
  for (size_t i = 0; i < ends->n && !ph_arena_late(arena); i++) {
    bool counts = true;
    for (size_t j = 0; j < i; j++) {
      if (fabs(ends->key[i] - ends->key[j]) <= ends->key_apart &&
          ends->copies[j] > 0 &&
          is_near(ends->b + i * n, ends->b + j * n, n,
                  ends->apart[i] + ends->apart[j])) {
        ends->copies[j]++;
        ends->copies[i] = 0;
        counts = !(ends->is_simple[i] && ends->is_simple[j]);
        break;
      }
    }
    solutions += counts;
  }
  return solutions;
}

/* Follows all paths for one twist.  ret  PH_OK | PH_E_NO_MEMORY */
static enum ph_status follow_all(const struct ph_planar_c2 *c2,
                                 struct family *family,
                                 const struct attempt *attempt,
                                 struct ph_arena *scratch, struct ends *ends,
                                 struct ph_diag *diag) {
  size_t n = family->n, paths = (size_t)1 << (n - 1);
  family->gamma = ph_cplx_polar(attempt->angle);
  ends->n = 0;
  ends->key_apart = 0;
  for (size_t i = 0; i < paths; i++) {
    ph_cplx *b = ends->b + ends->n * n;
    bool arrived = follow(family, i, attempt->error, b);
    for (size_t j = 0; j < n && arrived; j++) {
      b[j] = ph_cplx_scale(family->term[j].unit, b[j]);
    }
    if (ph_arena_late(scratch) || (arrived && polish(c2, &family->tri, b) &&
                                   !ends_add(ends, c2, scratch))) {
      return ph_fail_memory(diag);
    }
  }
  return PH_OK;
}

/* Appends the ends, each once, to the solutions. */
static void keep(const struct ends *ends, size_t n, double twist,
                 struct ph_planar_all *all) {
  for (size_t i = 0; i < ends->n; i++) {
    if (ends->copies[i] > 0) {
      memcpy(all->b + all->n * n, ends->b + i * n, n * sizeof *all->b);
      all->twist[all->n] = twist;
      all->multiplicity[all->n] = ends->copies[i];
      all->n++;
    }
  }
}

/*
 * All solutions of one twist, appended to `all`.
 *
 * inout most  solutions found, of all twists, at the best attempt
 */
static enum ph_status solve_twist(const struct ph_planar_c2 *c2,
                                  struct family *family,
                                  struct ph_arena *scratch, struct ends *ends,
                                  struct ph_planar_all *all, size_t *most,
                                  struct ph_diag *diag) {
  size_t paths = (size_t)1 << (family->n - 1), best = 0;
  family_init(family, c2);
  for (size_t i = 0; i < ATTEMPTS; i++) {
    size_t solutions;
    enum ph_status status =
        follow_all(c2, family, &family->attempts[i], scratch, ends, diag);
    if (status != PH_OK) {
      return status;
    }
    solutions = ends_compare(ends, family->n, scratch);
    all->paths += paths;
    best = solutions > best ? solutions : best;
    if (solutions == paths) {
      keep(ends, family->n, c2->twist.re, all);
      break;
    }
    all->lost += paths;
  }
  *most += best;
  return PH_OK;
}

static bool allocate(size_t unknowns, size_t paths, size_t curves,
                     struct ph_arena *out, struct ph_arena *scratch,
                     struct family *family, struct ends *ends,
                     struct ph_planar_all *all) {
  family->arena = scratch;
  ends->b = ph_arena_array(scratch, paths * unknowns, sizeof *ends->b);
  ends->key = ph_arena_array(scratch, paths, sizeof *ends->key);
  ends->apart = ph_arena_array(scratch, paths, sizeof *ends->apart);
  ends->is_simple = ph_arena_array(scratch, paths, sizeof *ends->is_simple);
  ends->copies = ph_arena_array(scratch, paths, sizeof *ends->copies);
  all->b = ph_arena_array(out, curves * unknowns, sizeof *all->b);
  all->twist = ph_arena_array(out, curves, sizeof *all->twist);
  all->multiplicity = ph_arena_array(out, curves, sizeof *all->multiplicity);
  return ends->b && ends->key && ends->apart && ends->is_simple &&
         ends->copies && all->b && all->twist && all->multiplicity &&
         ph_tri_alloc(&family->tri, scratch, unknowns);
}

enum ph_status ph_planar_all(struct ph_planar_c2 *c2, struct ph_arena *out,
                             struct ph_arena *scratch,
                             struct ph_planar_all *all, struct ph_diag *diag) {
  struct ph_mark mark = ph_arena_mark(scratch);
  size_t unknowns = ph_planar_unknowns(c2), paths, curves, most = 0;
  ph_cplx twist = c2->twist;
  enum ph_status status = PH_OK;
  struct family family;
  struct ends ends;
  memset(all, 0, sizeof *all);
  if (c2->n > PH_PLANAR_ALL_MAX) {
    return ph_fail(diag, PH_E_BAD_VALUE, "solutions",
                   "must be \"good\" for more than %d segments, found %zu",
                   PH_PLANAR_ALL_MAX, c2->n);
  }
  paths = (size_t)1 << (unknowns - 1);
  curves = c2->closed ? 2 * paths : paths;
  family.n = unknowns;
  family.attempts = attempts;
  if (!allocate(unknowns, paths, curves, out, scratch, &family, &ends, all)) {
    status = ph_fail_memory(diag);
  }
  for (int i = 0; i < (c2->closed ? 2 : 1) && status == PH_OK; i++) {
    c2->twist = ph_cplx_of(i ? -1 : 1, 0);
    status = solve_twist(c2, &family, scratch, &ends, all, &most, diag);
  }
  c2->twist = twist;
  ph_arena_release(scratch, mark);
  if (status == PH_OK && most < curves) {
    status = ph_fail(diag, PH_E_NO_CONVERGENCE, NULL,
                     "of %zu solutions only %zu were found", curves, most);
  }
  all->n = status == PH_OK ? all->n : 0;
  return status;
}
