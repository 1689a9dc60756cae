/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The method `planar`: from the fields of a problem to a C2 PH quintic or ATPH
 * spline.
 *
 * The data are checked and brought to unit scale (planar.h), the C2
 * equations solved (c2.h), and the preimage mapped back.
 *
 * [GON18] gives the equations for knots that are sums of the angles alpha; PH
 * quintics may have any knots, chordal by default.
 */
#include "solve/method.h"

#include "curve/fair/energy.h"
#include "solve/common/fields.h"
#include "solve/planar/planar.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Directions within this of exactly opposite count as a reversal. */
static const double REVERSAL = 1e-12;

/* Two curves whose lengths agree to this are the same curve. */
static const double SAME_LENGTH = 1e-9;

/* E L below this is that of a straight line. */
static const double STRAIGHT = 1e-12;

/* On more segments the theorem would take as long as the solution. */
enum { KANTOROVICH_MAX = 100 };

/* A problem on its way. */
struct task {
  const struct ph_problem *problem;
  struct ph_arena *out, *scratch;
  struct ph_result *result;
  struct ph_diag *diag;
  struct ph_planar_data data;
  struct ph_arena equations;  /* of what only they need */
  struct ph_arena roots;      /* of what only they and preimages need */
  size_t reversals, reversal; /* how often the data turn back, where first */
  ph_cplx *b;                 /* [unknowns] a solution */
  size_t iterations;
  double residual;
  struct ph_planar_loops loops; /* of the curve */
};

static void warn_loops(const struct ph_planar_loops *loops,
                       struct ph_result *result) {
  if (loops->n && isnan(loops->angle)) {
    ph_warn(result, loops->first, PH_W_LOOP,
            "segment %zu stands still somewhere, or turns on the spot (with "
            "loops, such segments: %zu)",
            loops->first, loops->n);
  } else if (loops->n) {
    ph_warn(result, loops->first, PH_W_LOOP,
            "segment %zu turns by %.4g radians, more than half a turn (such "
            "segments: %zu)",
            loops->first, loops->angle, loops->n);
  }
}

static bool is_same_length(double a, double b) {
  return fabs(a - b) <= SAME_LENGTH * b;
}

/* Whether two values are the same, but for rounding. */
static bool is_same(double a, double b) {
  return fabs(a - b) <= SAME_LENGTH * fmax(fabs(a), fabs(b));
}

/* How many points the data turn back at, and the first. */
static size_t reversals(const struct ph_planar_data *d, size_t *first) {
  const ph_cplx *u = d->c2.direction;
  ph_cplx before = u[d->closed ? d->n - 1 : 0];
  size_t found = 0;
  for (size_t k = 0; k < d->n; k++) {
    if (ph_cplx_dot(before, u[k]) < 0 &&
        fabs(ph_cplx_cross(before, u[k])) <= REVERSAL && found++ == 0) {
      *first = k;
    }
    before = u[k];
  }
  return found;
}

static void warn_reversals(const struct task *t) {
  if (t->reversals > 0) {
    ph_warn(t->result, t->reversal, PH_W_REVERSAL,
            "the data turn back by 180 degrees at points[%zu] (such points: "
            "%zu): of two mirror images the left turn was taken",
            t->reversal, t->reversals);
  }
}

static bool is_chordal(const struct ph_value *value) {
  return value->kind == PH_ABSENT ||
         (value->kind == PH_WORD && strncmp(value->word, "chordal", 7) == 0);
}

/* Spacings unrelated to the chords are what makes data unsolvable. */
static enum ph_status advise(const struct ph_problem *problem,
                             struct ph_diag *diag) {
  const char *advice =
      !is_chordal(&problem->field[PH_F_KNOTS])   ? "; try \"knots\":\"chordal\""
      : !is_chordal(&problem->field[PH_F_ALPHA]) ? "; try \"alpha\":\"chordal\""
                                                 : "";
  strncat(diag->message, advice,
          sizeof diag->message - 1 - strlen(diag->message));
  return diag->status;
}

/* Tells of another curve that is about as fair; but for the mirror image where
 * the data turn back, of which it is told that the left turn was taken. */
static void warn_other(const struct task *t,
                       const struct ph_planar_choice *choice) {
  const struct ph_planar_data *d = &t->data;
  if (isnan(choice->other_ies) ||
      (is_same(choice->other_ies, choice->ies) && t->reversals > 0)) {
    return;
  }
  ph_warn(t->result, PH_NO_SEGMENT, PH_W_AMBIGUOUS,
          "another good curve exists, of length %.6g and an IES of %.4g; that "
          "of this one is %.4g%s",
          ldexp(choice->other_length, -d->exponent), choice->other_ies,
          choice->ies,
          d->n <= PH_PLANAR_ALL_MAX ? "; \"solutions\":\"all\" shows all" : "");
}

/* Whether nothing but the curve is asked for: the theorem is not. */
static bool is_long(const struct task *t) {
  return t->data.n > KANTOROVICH_MAX;
}

/* Frees what the equations need, where nothing else does any more. */
static void forget_equations(struct task *t) {
  if (is_long(t)) {
    ph_arena_free(&t->equations);
    t->data.chord = t->data.c2.ratio = NULL;
    t->data.c2.direction = NULL;
  }
}

/* Frees what preimages were found from, likewise. */
static void forget_roots(struct task *t) {
  if (is_long(t)) {
    ph_arena_free(&t->roots);
    t->data.h = t->data.knots = t->data.c2.y = NULL;
    t->b = NULL;
  }
}

/* The good solution, and the curve. */
static enum ph_status solve_good(struct task *t) {
  struct ph_planar_choice choice;
  struct ph_planar_report report;
  struct ph_planar_second second;
  enum ph_status status =
      ph_planar_turns_sharply(&t->data.c2)
          ? ph_planar_c2_both(&t->data.c2, t->scratch, t->b, &report, &second,
                              t->diag)
          : ph_planar_c2_solve(&t->data.c2, t->scratch, t->b, &report, t->diag);
  if (status == PH_OK) {
    status = ph_planar_choose(&t->data, t->scratch, t->b, &report, &second,
                              &choice, t->diag);
  }
  if (status == PH_OK) {
    forget_equations(t);
    status =
        ph_planar_curve_alloc(&t->data, t->out, &t->result->curve, t->diag);
  }
  if (status != PH_OK) {
    return status;
  }
  ph_planar_curve_roots(&t->data, t->b, t->scratch, &t->result->curve,
                        &t->loops);
  forget_roots(t);
  ph_planar_curve_points(&t->data, t->scratch, &t->result->curve);
  t->iterations = report.iterations;
  t->residual = report.residual;
  warn_other(t, &choice);
  return PH_OK;
}

static void warn_cut(const struct ph_planar_min *report,
                     struct ph_result *result) {
  if (report->cut_short) {
    ph_warn(result, PH_NO_SEGMENT, PH_W_CUT_SHORT,
            "minimize ended at its limit of %zu steps: from %.6g it came to "
            "%.6g, and the last step still gained more than 1e-8 of that",
            report->steps_max, report->start, report->minimum);
  }
}

/* The solution of the fairest angles or knots, and the curve. */
static enum ph_status solve_fairest(struct task *t) {
  static const char *const names[] = {"E", "MV", "IES", "IMV"};
  const char *name = t->problem->field[PH_F_MINIMIZE].word;
  struct ph_diagnostics *diagnostics = &t->result->diagnostics;
  enum ph_planar_functional functional = PH_PLANAR_E;
  struct ph_planar_min report;
  enum ph_status status;
  while (functional < PH_PLANAR_IMV && strcmp(name, names[functional]) != 0) {
    functional++;
  }
  status = ph_planar_minimize(
      &t->data, functional, ph_value_is(&t->problem->field[PH_F_FREE], "scale"),
      PH_PLANAR_STEPS_MAX, t->scratch, t->b, &report, t->diag);
  if (status == PH_OK) {
    status =
        ph_planar_curve_alloc(&t->data, t->out, &t->result->curve, t->diag);
  }
  if (status != PH_OK) {
    return status;
  }
  ph_planar_curve_fill(&t->data, t->b, t->scratch, &t->result->curve,
                       &t->loops);
  ph_diagnostics_set_finite(diagnostics, PH_D_FUNCTIONAL, report.minimum);
  ph_diagnostics_set(diagnostics, PH_D_AT_BOUND, report.at_bound);
  ph_diagnostics_set_finite(diagnostics, PH_D_FUNCTIONAL_START, report.start);
  warn_cut(&report, t->result);
  t->iterations = report.evaluations;
  t->residual = sqrt(ph_planar_residual(&t->data.c2, t->b).max2);
  return PH_OK;
}

/* E, times a length that all have in common; or 0 where it is rounding. */
static double fairness_of(const struct ph_solution *solution) {
  double energy = solution->diagnostics.value[PH_D_ENERGY];
  return energy > STRAIGHT ? energy : 0;
}

/* Those that bend least first, and those that stand still, of which that is not
 * known, last; where they bend alike, the shorter, then the one
 * that is found alone, then the one that turns less: of straight lines, the one
 * that goes straight.  Mirror images are alike in all that; the one to the left
 * comes first.  None of that depends on rounding. */
static int compare_solutions(const void *a, const void *b) {
  const struct ph_solution *x = a, *y = b;
  double turns[2] = {x->diagnostics.value[PH_D_ABSOLUTE_ROTATION_INDEX],
                     y->diagnostics.value[PH_D_ABSOLUTE_ROTATION_INDEX]};
  if (!is_same(fairness_of(x), fairness_of(y))) {
    return ph_fields_order(fairness_of(x), fairness_of(y));
  }
  if (!is_same_length(x->curve.length, y->curve.length)) {
    return ph_fields_order(x->curve.length, y->curve.length);
  }
  if (x->good != y->good) {
    return x->good ? -1 : 1;
  }
  if (fabs(turns[0] - turns[1]) > SAME_LENGTH) {
    return ph_fields_order(turns[0], turns[1]);
  }
  return ph_planar_compare_sides(&x->curve, &y->curve);
}

static enum ph_status fill_solution(struct task *t, const ph_cplx *b,
                                    struct ph_solution *solution) {
  const struct ph_curve *good = &t->result->curve;
  struct ph_planar_loops loops;
  struct ph_energy energy;
  enum ph_status status;
  *solution = (struct ph_solution){.good = false};
  status = ph_planar_curve_alloc(&t->data, t->out, &solution->curve, t->diag);
  if (status != PH_OK) {
    return status;
  }
  ph_planar_curve_fill(&t->data, b, t->scratch, &solution->curve, &loops);
  if (!ph_energy_planar(&solution->curve, &energy)) {
    return ph_fail_memory(t->diag);
  }
  /* for comparing; the certificate says what is known */
  solution->diagnostics.value[PH_D_ENERGY] =
      fmin(energy.ies * (good->length / solution->curve.length), DBL_MAX);
  solution->diagnostics.value[PH_D_ABSOLUTE_ROTATION_INDEX] =
      isfinite(energy.ies) ? energy.absolute_rotation : HUGE_VAL;
  solution->good = is_same_length(solution->curve.length, good->length) &&
                   ph_planar_compare_sides(good, &solution->curve) == 0;
  return PH_OK;
}

/* Makes the best of all solutions the curve, and sorts the others after it: of
 * three energies that are nearly the same, the first and the last may not be,
 * and sorting might have another first. */
static void choose_best(struct task *t, const struct ph_planar_all *all) {
  struct ph_planar_data *d = &t->data;
  struct ph_solution *solutions = t->result->solutions, first;
  size_t best = 0;
  for (size_t i = 1; i < all->n; i++) {
    if (compare_solutions(&solutions[i], &solutions[best]) < 0) {
      best = i;
    }
  }
  t->b = all->b + best * ph_planar_unknowns(&d->c2);
  d->c2.twist = ph_cplx_of(all->twist[best], 0);
  ph_planar_curve_fill(d, t->b, t->scratch, &t->result->curve, &t->loops);
  t->residual = sqrt(ph_planar_residual(&d->c2, t->b).max2);
  first = solutions[best];
  solutions[best] = solutions[0];
  solutions[0] = first;
  qsort(solutions + 1, all->n - 1, sizeof *solutions, compare_solutions);
  t->result->solutions_n = all->n;
  for (size_t i = 0, good = 0; i < all->n; i++) { /* one of equal length */
    solutions[i].good = solutions[i].good && good++ == 0;
  }
}

/* Adds every solution to the good one. */
static enum ph_status add_solutions(struct task *t) {
  struct ph_planar_data *d = &t->data;
  struct ph_planar_all all;
  enum ph_status status =
      ph_planar_all(&d->c2, t->out, t->scratch, &all, t->diag);
  if (status != PH_OK) {
    return status;
  }
  t->result->solutions =
      ph_arena_array(t->out, all.n, sizeof *t->result->solutions);
  if (!t->result->solutions) {
    return ph_fail_memory(t->diag);
  }
  for (size_t i = 0; i < all.n; i++) {
    d->c2.twist = ph_cplx_of(all.twist[i], 0);
    status = fill_solution(t, all.b + i * ph_planar_unknowns(&d->c2),
                           &t->result->solutions[i]);
    if (status != PH_OK) {
      return status;
    }
  }
  choose_best(t, &all);
  return PH_OK;
}

/* What is said of a solution, and of the equations there. */
static enum ph_status report(struct task *t) {
  struct ph_result *result = t->result;
  ph_diagnostics_set(&result->diagnostics, PH_D_ITERATIONS,
                     (double)t->iterations);
  ph_diagnostics_set(&result->diagnostics, PH_D_RESIDUAL, t->residual);
  result->has_kantorovich =
      t->data.n <= KANTOROVICH_MAX &&
      ph_diagnostics_asked(&result->diagnostics, PH_BIT(PH_DIAGNOSTIC_N));
  if (result->has_kantorovich &&
      !ph_planar_kantorovich(&t->data.c2, t->b, t->scratch,
                             &result->kantorovich)) {
    return ph_fail_memory(t->diag);
  }
  ph_warn_alpha(&result->curve, result);
  warn_reversals(t);
  warn_loops(&t->loops, result);
  return PH_OK;
}

static enum ph_status solve_task(struct task *t) {
  const struct ph_value *field = t->problem->field;
  enum ph_status status = ph_planar_data_of(t->problem, t->scratch, &t->roots,
                                            &t->equations, &t->data, t->diag);
  if (status != PH_OK) {
    return status;
  }
  t->reversals = reversals(&t->data, &t->reversal);
  t->b =
      ph_arena_array(&t->roots, ph_planar_unknowns(&t->data.c2), sizeof *t->b);
  if (!t->b) {
    return ph_fail_memory(t->diag);
  }
  status =
      field[PH_F_MINIMIZE].kind == PH_WORD ? solve_fairest(t) : solve_good(t);
  if (status == PH_E_NO_CONVERGENCE) {
    return advise(t->problem, t->diag);
  }
  if (status == PH_OK && ph_value_is(&field[PH_F_SOLUTIONS], "all")) {
    status = add_solutions(t);
  }
  return status == PH_OK ? report(t) : status;
}

static enum ph_status solve(const struct ph_problem *problem,
                            struct ph_arena *out, struct ph_arena *scratch,
                            struct ph_result *result, struct ph_diag *diag) {
  struct ph_mark mark = ph_arena_mark(scratch);
  struct task t = {.problem = problem,
                   .out = out,
                   .scratch = scratch,
                   .equations = ph_arena_beside(scratch),
                   .roots = ph_arena_beside(scratch),
                   .result = result,
                   .diag = diag};
  enum ph_status status = solve_task(&t);
  ph_arena_free(&t.equations);
  ph_arena_free(&t.roots);
  ph_arena_release(scratch, mark);
  return status;
}

static const struct ph_field fields[] = {
    {PH_F_POINTS, PH_VECTORS | PH_DATUM, 1u << 2, true, NULL, NULL,
     "the points to interpolate, 2 or more, 3 or more if closed"},
    {PH_F_CLOSED, PH_BOOL, 0, false, NULL, "false",
     "close the curve, a repeated last point is dropped"},
    PH_FIELD_MERGE,
    PH_FIELD_AT,
    {PH_F_BASIS, PH_WORD, 0, false, "ph|atph", "ph",
     "PH quintic segments, polynomial, or algebraic-trigonometric ones"},
    {PH_F_KNOTS, PH_WORD | PH_NUMBERS | PH_DATUM, 0, false,
     "chordal|centripetal|uniform", "chordal, of atph the sums of alpha",
     "spacing of the knots, or the knots themselves, increasing"},
    {PH_F_ALPHA, PH_NUMBER | PH_NUMBERS | PH_WORD | PH_SEGMENTS, 0, false,
     "chordal|chordal:V", "chordal, the largest pi/2",
     "angles of atph segments below pi, one for all or one each"},
    {PH_F_END_DERIVATIVES, PH_VECTORS, 1u << 2, false, NULL,
     "those of a parabola through three points",
     "the two end derivatives of an open curve, per unit of the knots"},
    {PH_F_SOLUTIONS, PH_WORD, 0, false, "good|all", "good",
     "the good curve, or every curve that satisfies the equations, those that "
     "bend least first; at most 12 segments"},
    {PH_F_MINIMIZE, PH_WORD, 0, false, "E|MV|IES|IMV", "nothing",
     "functional of the curvature to minimise, over alpha, or the knots of ph"},
    {PH_F_FREE, PH_WORD, 0, false, "each|scale", "each",
     "what minimize varies, each alpha or knot, or one factor on all alpha"},
};

static const struct ph_advice advice[] = {
    {"minimize", PH_FIELD_N, PH_F_FREE, "scale",
     "--free=scale varies one number instead of all"},
    {NULL, PH_F_SOLUTIONS, PH_F_SOLUTIONS, "good",
     "--solutions=good looks for one curve only"},
    {"segments", PH_F_END_DERIVATIVES, PH_FIELD_N, NULL,
     "--end_derivatives nearer to the steps of the data, or none, may help"},
    {NULL, PH_FIELD_N, PH_F_KNOTS, "centripetal",
     "--knots=centripetal may bend less"},
};

const struct ph_method ph_method_planar = {
    .schema = {"planar", fields, sizeof fields / sizeof fields[0]},
    .title = "C2 PH splines through points in the plane",
    .dimension = 2,
    .solve = solve,
    .advice = advice,
    .advice_n = sizeof advice / sizeof advice[0],
};
