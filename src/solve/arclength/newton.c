/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Newton's method for the equations of arclength (see newton.h). */
#include "solve/arclength/arclength.h"

#include "kernel/band.h"
#include "kernel/inertia.h"
#include "solve/arclength/system.h"

#include <math.h>
#include <string.h>

/* Residuals of rows, relative to the mean length, are below this in the end. */
static const double RESIDUAL = 1e-12;
/* So is the Newton decrement, relative to F: a fixed bound for the gradient
 * would be below its rounding where F is small, as of many points. */
static const double DECREMENT = 1e-9;
/* Or it is rounding: so many times it did not fall by this in a step. */
static const double STAGNANT = 0.25;
enum { STAGNATIONS = 8 };
/* From here on plain Newton steps are taken: the proof that they led to a
 * minimum comes in the end. */
static const double NEAR = 1e-7;
static const double NEAR_DECREMENT = 1e-6; /* enough when steps are used up */
/* Residuals and gradients of a part. */
static const double PART = 1e-6;
/* Weights of J^T J in the test of A, each times 1 + |y|: with a fixed weight
 * large multipliers would give false alarms. */
static const double PENALTY[2] = {1e4, 1e7};
/* Where that fails the diagonal is raised by this part of the largest element
 * of the Hessian: soft modes of many points need small shifts, or none. */
static const double ALARM = 1e-10;
static const double SHIFT_FIRST = 1e-7, SHIFT_REFUSED = 1e-3, SHIFT_MAX = 1e10,
                    SHIFT_NONE = 1e-10;
/* Blocks have no larger shift than this times the size of the multipliers, of
 * which the Hessian is: they are stiff then, and more is rounding. */
static const double STIFFEST = 10;
static const double STEP_MIN = 1e-5;
static const double ARMIJO = 1e-4;
/* So many times blocks take shorter steps, before all do: with 4 free walks
 * of 1000 take a step of ten more in mean, and each costs a matrix. */
enum { SHORTER = 2 };
/* A step does not change a node by more than this times the largest one. */
static const double STEP_MAX = 2;
static const double STEP_SINGULAR = 1e6;

struct state {
  const struct ph_arc_system *s;
  struct ph_arc_newton *w;
  struct ph_arc_point *p;
  double shift;
  double hint;   /* the last that was not 0 */
  double limit;  /* of residuals and gradients near the end */
  double y_size; /* largest multiplier */
  bool near;     /* plain Newton steps */
  bool convex;   /* shifts grew since the matrix was */
  bool moved;    /* a step was taken, or is not needed: rows that yield hold
                  * from the beginning */
  double noise;  /* rounding of the merit function */
  double before; /* the decrement of the step before, if that was near */
  size_t stagnations;
  size_t steps; /* so far */
  size_t end;   /* of iterations, which those of places put off */
};

/* ---- memory -------------------------------------------------------------- */

bool ph_arc_newton_alloc(const struct ph_arc_system *s, struct ph_arena *arena,
                         struct ph_arc_newton *w) {
  size_t size = sizeof(double);
  w->arena = arena;
  w->starved = false;
  w->convex = 0;
  w->kkt = ph_arena_array(arena, s->kkt_n, ph_band_size(1, s->kkt_band) * size);
  w->pivot = ph_arena_array(arena, s->kkt_n, sizeof(uint32_t));
  w->penalised =
      ph_arena_array(arena, s->x_n, ph_sym_size(1, s->order_band) * size);
  w->minors = ph_arena_array(arena, ph_inertia_size(s->kkt_band), size);
  w->step = ph_arena_array(arena, s->kkt_n, size);
  w->dx = ph_arena_array(arena, s->x_n, size);
  w->dx2 = ph_arena_array(arena, s->x_n, size);
  w->x[0] = ph_arena_array(arena, s->x_n, size);
  w->x[1] = ph_arena_array(arena, s->x_n, size);
  w->y = ph_arena_array(arena, s->y_n, size);
  w->dy = ph_arena_array(arena, s->y_n, size);
  w->c = ph_arena_array(arena, s->y_n, size);
  w->nu = ph_arena_array(arena, s->y_n, size);
  w->gradient = ph_arena_array(arena, s->x_n, size);
  return ph_arc_linear_alloc(s, arena, &w->linear) && w->gradient &&
         ph_arc_blocks_alloc(s, arena, &w->blocks) && w->kkt && w->pivot &&
         w->penalised && w->minors && w->step && w->dx && w->dx2 && w->x[0] &&
         w->x[1] && w->y && w->dy && w->c && w->nu;
}

bool ph_arc_point_alloc(const struct ph_arc_system *s, struct ph_arena *arena,
                        struct ph_arc_point *p) {
  *p =
      (struct ph_arc_point){.x = ph_arena_array(arena, s->x_n, sizeof(double)),
                            .y = ph_arena_array(arena, s->y_n, sizeof(double))};
  if (!p->x || !p->y) {
    return false;
  }
  memset(p->y, 0, s->y_n * sizeof *p->y);
  return true;
}

void ph_arc_point_copy(const struct ph_arc_system *s,
                       const struct ph_arc_point *from,
                       struct ph_arc_point *to) {
  double *x = to->x, *y = to->y;
  *to = *from;
  to->x = x;
  to->y = y;
  memcpy(x, from->x, s->x_n * sizeof *x);
  memcpy(y, from->y, s->y_n * sizeof *y);
}

/* ---- the linear system --------------------------------------------------- */

/* Whether all residuals are as small as asked for. */
static bool rows_hold(const struct ph_arc_system *s, const double *c,
                      const double *y) {
  bool hold = true;
  for (size_t r = 0; r < s->y_n; r++) {
    double soft = ph_arc_compliance(s, r);
    hold = hold && fabs(c[r] - soft * y[r]) <= RESIDUAL * (1 + soft);
  }
  return hold;
}

/* Solves for the right side (u, v) that is in the step already. */
static void solve(struct state *t, double *dx, double *dy) {
  const struct ph_arc_system *s = t->s;
  ph_band_solve(t->w->kkt, t->w->pivot, s->kkt_n, s->kkt_band, t->w->step);
  for (size_t k = 0; k < s->x_n; k++) {
    dx[k] = t->w->step[s->place_x[k]];
  }
  for (size_t r = 0; dy && r < s->y_n; r++) {
    dy[r] = t->w->step[s->place_y[r]];
  }
}

/* Of matrices that steps are taken with. */
static struct ph_arc_weights weights_of(struct state *t, double rounding) {
  struct ph_arc_weights weights = {.functional = 1,
                                   .shift = t->shift,
                                   .pin = PH_ARC_PIN,
                                   .rounding = rounding,
                                   .retracted = true};
  if (!t->near) {
    ph_arc_blocks_weights(t->s, &t->w->blocks, &weights);
  }
  return weights;
}

/* Whether the Hessian, shifted, is positive definite on the null space of J.
 * What rounding does to it is asked without a shift only: the next one is more.
 */
static bool is_convex(struct state *t, size_t from) {
  const struct ph_arc_blocks *b = &t->w->blocks;
  bool shifted = t->shift > 0;
  for (size_t k = 0; k < b->n && !shifted; k++) {
    shifted = b->shift[k] > 0 || b->hold[k] > 0;
  }
  for (size_t k = from, tries = shifted ? 2 : 4;
       k < tries && !ph_arena_late(t->w->arena); k++) {
    size_t at = from > 0 ? k : (k + t->w->convex) % tries;
    struct ph_arc_weights weights = weights_of(t, at < 2 ? 0 : ALARM);
    if (ph_arc_penalised_factor(t->s, t->p->x, t->p->y, &t->w->linear, &weights,
                                PENALTY[at % 2] * (1 + t->y_size),
                                t->w->penalised)) {
      t->w->convex = at;
      return true;
    }
  }
  return false;
}

/* The same of blocks, which are raised where it is not. */
static bool make_convex(struct state *t) {
  const struct ph_arc_system *s = t->s;
  struct ph_arc_newton *w = t->w;
  struct ph_arc_weights weights = weights_of(t, 0);
  enum ph_arc_shape shape;
  ph_arc_penalised(s, t->p->x, t->p->y, &w->linear, &weights,
                   PENALTY[0] * (1 + t->y_size), w->penalised);
  shape = ph_arc_blocks_convex(s, t->p->x, w->penalised, &w->blocks);
  if (shape == PH_ARC_CONVEX || is_convex(t, 1)) {
    return true;
  }
  if (shape == PH_ARC_BENT) {
    ph_arc_blocks_apply(&w->blocks);
  }
  return shape == PH_ARC_BENT;
}

/* The Newton step from a matrix that has the inertia of a minimum. */
static bool find_step(struct state *t) {
  const struct ph_arc_system *s = t->s;
  struct ph_arc_newton *w = t->w;
  const struct ph_arc_point *p = t->p;
  while (t->shift <= SHIFT_MAX && !ph_arena_late(w->arena)) {
    if (t->near || t->convex ||
        (w->blocks.n > 0 ? make_convex(t) : is_convex(t, 0))) {
      struct ph_arc_weights weights = weights_of(t, 0);
      if (ph_arc_kkt_factor(s, p->x, p->y, &w->linear, &weights, w->kkt,
                            w->pivot)) {
        for (size_t k = 0; k < s->x_n; k++) {
          w->step[s->place_x[k]] = -w->gradient[k];
        }
        for (size_t r = 0; r < s->y_n; r++) {
          w->step[s->place_y[r]] =
              ph_arc_compliance(s, r) * p->y[r] - w->linear.c[r];
        }
        solve(t, w->dx, w->dy);
        if (ph_arc_largest(s->x_n, w->dx) < STEP_SINGULAR &&
            isfinite(ph_arc_largest(s->y_n, w->dy))) {
          ph_arc_retract_rows(s, p->x, w->dx, 1, p->y, w->dy, w->y);
          return true;
        }
      }
    }
    t->near = t->convex = false;
    t->shift = t->shift > 0 ? 4 * t->shift : SHIFT_FIRST;
  }
  return false;
}

/* ---- the search ---------------------------------------------------------- */

/* F + nu |c|_1; soft rows by what they cost instead. */
static double merit(struct state *t, const double *x) {
  const struct ph_arc_system *s = t->s;
  double *c = t->w->c, f = ph_arc_functional(s, x), sum = 0;
  ph_arc_residual(s, x, c);
  for (size_t r = 0; r < s->y_n; r++) {
    double soft = ph_arc_compliance(s, r);
    if (soft > 0) {
      f += c[r] * c[r] / (2 * soft);
    } else {
      sum += t->w->nu[r] * fabs(c[r]);
    }
  }
  return f + sum;
}

/* The derivative of the merit function along the step, at most 0. */
static double merit_derivative(struct state *t) {
  const struct ph_arc_system *s = t->s;
  const struct ph_arc_linear *l = &t->w->linear;
  double sum = 0, hard = 0;
  for (size_t k = 0; k < s->x_n; k++) {
    sum += l->f_x[k] * t->w->dx[k];
  }
  if (s->compliance ||
      s->knot_compliance) { /* + c / compliance . J dx of the soft rows */
    ph_arc_rows_times(s, l, t->w->dx, t->w->c);
  }
  for (size_t r = 0; r < s->y_n; r++) {
    double soft = ph_arc_compliance(s, r);
    if (soft > 0) {
      sum += l->c[r] / soft * t->w->c[r];
    } else {
      hard += t->w->nu[r] * fabs(l->c[r]);
    }
  }
  sum -= hard;
  return sum < 0 ? sum : 0;
}

/* The largest multiplier of the hard ones of some rows. */
static double hard_size(const struct state *t, size_t from, size_t to) {
  double most = 0;
  for (size_t r = from; r < to; r++) {
    double size = ph_arc_compliance(t->s, r) > 0 ? 0 : fabs(t->w->y[r]);
    most = size > most ? size : most;
  }
  return most;
}

/* The weights of |c|_1 follow the multipliers of the hard rows, those of an
 * interval or a knot together: a sharp place weighs its own rows only. */
static void weigh_rows(struct state *t) {
  const struct ph_arc_system *s = t->s;
  size_t knots = s->data->n * s->forms_n;
  for (size_t r = 0, next; r < s->y_n; r = next) {
    double most, nu = t->w->nu[r];
    next = r + (r < knots ? s->forms_n : s->knot_rows);
    most = hard_size(t, r, next);
    if (1.1 * most > nu) {
      nu = 1.5 * most;
    } else if (nu > 10 * most) {
      nu = 3 * most;
    }
    for (size_t k = r; k < next; k++) {
      t->w->nu[k] = nu;
    }
  }
}

/* The rows at x, after a step of this length, differ from what they would be if
 * they were linear, by their curvature: a second step with the same matrix
 * takes that back. */
static void correct(struct state *t, const double *x, double step) {
  const struct ph_arc_system *s = t->s;
  struct ph_arc_newton *w = t->w;
  size_t knots = s->data->n * s->forms_n;
  ph_arc_residual(s, x, w->c);
  memset(w->step, 0, s->kkt_n * sizeof *w->step);
  for (size_t r = 0; r < s->y_n; r++) {
    double soft = ph_arc_compliance(s, r), y = t->p->y[r];
    double linear = (1 - step) * (w->linear.c[r] - soft * y);
    if (!(soft > 0 && r >= knots)) { /* those yield, and turn with phases */
      w->step[s->place_y[r]] = linear + soft * (y + step * w->dy[r]) - w->c[r];
    }
  }
  solve(t, w->dx2, NULL);
  for (size_t k = 0; k < s->x_n; k++) {
    w->dx2[k] += step * w->dx[k];
  }
}

/* The largest change of a node by a step, relative to the largest node. */
static double change(struct state *t) {
  const double *x = t->p->x;
  double most = 0, size = ph_arc_largest(t->s->nodes * t->s->dim, x);
  ph_arc_retract(t->s, x, t->w->dx, 1, t->w->x[0]);
  for (size_t k = 0; k < t->s->x_n; k++) {
    double moved = fabs(t->w->x[0][k] - x[k]);
    most = moved > most ? moved : most;
  }
  return most / size;
}

/* Whether a step of this length, or that and a correction, takes the merit
 * function below a limit; the new x is in w->x[0]. */
static bool try_step(struct state *t, double step, double limit) {
  struct ph_arc_newton *w = t->w;
  double *swap = w->x[1];
  ph_arc_retract(t->s, t->p->x, w->dx, step, w->x[0]);
  if (merit(t, w->x[0]) <= limit) {
    return true;
  }
  correct(t, w->x[0], step);
  ph_arc_retract(t->s, t->p->x, w->dx2, 1, w->x[1]);
  if (merit(t, w->x[1]) <= limit) {
    w->x[1] = w->x[0];
    w->x[0] = swap;
    return true;
  }
  return false;
}

/* The step length; the new x is in w->x[0].  0: none was good enough. */
static double search(struct state *t) {
  double before = merit(t, t->p->x), down = merit_derivative(t),
         far = change(t), noise = t->noise + 1e-14 * before;
  double step = far < STEP_MAX ? 1 : STEP_MAX / far;
  while (step > STEP_MIN && !ph_arena_late(t->w->arena)) {
    if (try_step(t, step, before + ARMIJO * step * down + noise)) {
      return step;
    }
    step /= 2;
  }
  return 0;
}

/* The same, always corrected, which tells how much rows bend. */
static bool try_corrected(struct state *t, double step, double limit) {
  struct ph_arc_newton *w = t->w;
  double *swap = w->x[1], plain, corrected;
  ph_arc_retract(t->s, t->p->x, w->dx, step, w->x[0]);
  plain = merit(t, w->x[0]);
  correct(t, w->x[0], step);
  ph_arc_blocks_look(t->s, t->p->x, w->gradient, w->dx, step, w->dx2,
                     &w->blocks);
  ph_arc_retract(t->s, t->p->x, w->dx2, 1, w->x[1]);
  corrected = merit(t, w->x[1]);
  if (corrected <= plain || isnan(plain)) {
    w->x[1] = w->x[0];
    w->x[0] = swap;
    plain = corrected;
  }
  return plain <= limit;
}

/* The same of blocks: where a whole step is not good enough, those whose rows
 * bend take shorter ones, and all others need not. */
static double search_blocks(struct state *t) {
  for (size_t k = 0; k < SHORTER; k++) {
    double before = merit(t, t->p->x), down = merit_derivative(t),
           far = change(t), noise = t->noise + 1e-14 * before;
    double step = far < STEP_MAX ? 1 : STEP_MAX / far;
    if (try_corrected(t, step, before + ARMIJO * step * down + noise) &&
        !(step < 1)) {
      ph_arc_blocks_settle(&t->w->blocks);
      return 1;
    }
    if (!ph_arc_blocks_raise(&t->w->blocks)) {
      break;
    }
    t->convex = true;
    if (!find_step(t)) {
      return 0;
    }
    t->convex = false;
    weigh_rows(t);
  }
  return search(t);
}

/* ---- the iteration ------------------------------------------------------- */

static double decrement(const struct state *t) {
  double sum = 0;
  for (size_t k = 0; k < t->s->x_n; k++) {
    sum += t->w->gradient[k] * t->w->dx[k];
  }
  return fabs(sum);
}

/* Everything at x and y. */
static void look(struct state *t) {
  const struct ph_arc_system *s = t->s;
  struct ph_arc_point *p = t->p;
  ph_arc_yield(s, p->x, p->y);
  ph_arc_linearise(s, p->x, p->y, &t->w->linear);
  memcpy(t->w->gradient, t->w->linear.l_x, s->x_n * sizeof *p->x);
  ph_arc_ends_gradient(s, p->x, t->w->gradient);
  t->y_size = ph_arc_largest(s->y_n, p->y);
  t->w->blocks.most = STIFFEST * (1 + t->y_size);
  p->f = t->w->linear.f;
  p->kkt = ph_arc_largest(s->x_n, t->w->gradient) / (1 + t->y_size);
  p->residual = 0;
  for (size_t r = 0; r < s->y_n && !isnan(p->residual); r++) {
    double soft = ph_arc_compliance(s, r);
    double c = fabs(t->w->linear.c[r] - soft * p->y[r]) / (1 + soft);
    p->residual = c <= p->residual || isnan(p->residual) ? p->residual : c;
  }
  t->near = p->residual < t->limit && p->kkt < t->limit;
  t->shift = t->near ? 0 : t->shift;
  t->noise = 1e-10 * p->f;
  for (size_t r = 0; r < s->y_n; r++) {
    t->noise += 1e-15 * t->w->nu[r];
  }
}

/* The last step is taken if it keeps the rows. */
static void finish(struct state *t) {
  const struct ph_arc_system *s = t->s;
  struct ph_arc_newton *w = t->w;
  ph_arc_retract(s, t->p->x, w->dx, 1, w->x[0]);
  ph_arc_residual(s, w->x[0], w->c);
  ph_arc_yield(s, w->x[0], w->y);
  if (rows_hold(s, w->c, w->y)) {
    memcpy(t->p->x, w->x[0], s->x_n * sizeof *w->x[0]);
    memcpy(t->p->y, w->y, s->y_n * sizeof *w->y);
  }
  t->p->converged = true;
  t->p->iterations++;
  look(t);
}

/* Whether the decrement is as small as it is asked to be or can be. */
static bool is_settled(struct state *t) {
  double now = decrement(t), before = t->before;
  t->before = t->near ? now : (double)INFINITY;
  t->stagnations += t->near && now >= STAGNANT * before;
  return now <= DECREMENT * t->p->f || t->stagnations >= STAGNATIONS;
}

/* One iteration; false when there is no way on. */
static bool iterate(struct state *t) {
  const struct ph_arc_system *s = t->s;
  struct ph_arc_newton *w = t->w;
  struct ph_arc_point *p = t->p;
  double step;
  if (!find_step(t)) {
    return false;
  }
  if (t->moved && rows_hold(s, w->linear.c, p->y) && is_settled(t)) {
    finish(t);
    return false;
  }
  weigh_rows(t);
  step = w->blocks.n > 0 && !t->near ? search_blocks(t) : search(t);
  p->iterations++;
  if (!(step > 0) && t->near) {
    ph_arc_retract(s, p->x, w->dx, 1, w->x[0]);
    step = 1;
  } else if (!(step > 0)) {
    t->shift = t->shift > SHIFT_REFUSED / 10 ? 10 * t->shift : SHIFT_REFUSED;
    return t->shift <= SHIFT_MAX;
  }
  ph_arc_retract_rows(s, p->x, w->dx, step, p->y, w->dy, p->y);
  memcpy(p->x, w->x[0], s->x_n * sizeof *p->x);
  t->moved = true;
  if (t->near && step < 0.2) { /* not so near */
    t->limit = fmax(p->residual, p->kkt) / 10;
  }
  t->hint = t->shift > 0 ? t->shift : t->hint;
  t->shift = !(step < 1)                     ? t->shift / 10
             : step > 0.2 || w->blocks.n > 0 ? t->shift
             : t->shift > 0                  ? 4 * t->shift
             : t->hint > 0                   ? 10 * t->hint
                                             : SHIFT_REFUSED;
  t->shift = t->shift < SHIFT_NONE ? 0 : t->shift;
  t->steps++;
  if (w->blocks.n > 0 && !t->near && !s->part) {
    size_t before = p->iterations;
    w->starved = !ph_arc_places(s, w, step, t->steps, p);
    t->end += p->iterations - before;
  }
  return !w->starved;
}

/* A part is solved when it is near: what is beside it is not. */
static bool is_done(const struct state *t) {
  return t->s->part && t->p->residual <= PART && t->p->kkt <= PART;
}

bool ph_arc_newton_solve(const struct ph_arc_system *s,
                         struct ph_arc_newton *work, size_t limit,
                         struct ph_arc_point *p) {
  struct state t = {
      .s = s, .w = work, .p = p, .limit = NEAR, .before = (double)INFINITY};
  bool go = true;
  t.end = p->iterations + limit;
  work->times = 0;
  p->converged = p->minimiser = false;
  t.moved = !s->knot_compliance;
  memset(work->nu, 0, s->y_n * sizeof *work->nu);
  look(&t);
  while (p->iterations < t.end && go && isfinite(p->f) && !is_done(&t)) {
    go = iterate(&t) && !ph_arena_late(work->arena);
    if (go) {
      look(&t);
    }
  }
  if (s->part) {
    p->converged = p->converged || is_done(&t);
    return p->converged;
  }
  if (go && rows_hold(s, work->linear.c, p->y) &&
      decrement(&t) <= NEAR_DECREMENT * p->f) {
    p->converged = true;
  }
  p->minimiser = p->converged && ph_arc_is_minimum(s, work, p->x, p->y);
  return p->converged;
}

bool ph_arc_newton_plain(const struct ph_arc_system *s,
                         struct ph_arc_newton *work, size_t limit,
                         struct ph_arc_point *p) {
  struct state t = {.s = s, .w = work, .p = p, .before = (double)INFINITY};
  p->converged = p->minimiser = false;
  memset(work->nu, 0, s->y_n * sizeof *work->nu);
  for (size_t i = 0; i < limit && !ph_arena_late(work->arena); i++) {
    look(&t);
    t.near = true;
    if (!isfinite(p->f) || !find_step(&t) || !t.near) {
      return false;
    }
    if (rows_hold(s, work->linear.c, p->y) && is_settled(&t)) {
      finish(&t);
      break;
    }
    ph_arc_retract(s, p->x, work->dx, 1, work->x[0]);
    memcpy(p->x, work->x[0], s->x_n * sizeof *p->x);
    memcpy(p->y, work->y, s->y_n * sizeof *p->y);
    p->iterations++;
  }
  p->minimiser = p->converged && ph_arc_is_minimum(s, work, p->x, p->y);
  return p->converged;
}
