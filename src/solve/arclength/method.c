/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * C2 spatial PH quintic splines with prescribed arc lengths [HUA14].
 *
 * Data in a plane have their curve in it, where one is found, otherwise in
 * space; the number of segments in each interval, `refine`, decides how much
 * freedom there is: with one the lengths of dense data can only be had by
 * wiggling, with two they are as easily had as not.
 */
#include "solve/method.h"

#include "kernel/pi.h"
#include "solve/arclength/arclength.h"
#include "solve/common/fields.h"

#include <math.h>
#include <string.h>

enum { REFINE_MAX = 3, DIM_MAX = 4, STARTS_MAX = 1000 };

/* One interval whose length is its chord to this is straight. */
static const double STRAIGHT = 1e-12;

struct task {
  const struct ph_problem *problem;
  struct ph_arena *scratch;
  struct ph_diag *diag;
  struct ph_arc_data data;
  struct ph_arc_data exact; /* the same, but for what was measured */
  struct ph_arc_request request;
  struct ph_arc_search search;
  bool keep_plane;
  bool left_plane;    /* no curve was found there */
  size_t refine_last; /* the largest that is tried */
  /* Natural curves of searches that found nothing, by refine - 1 and dim: they
   * are most of what a search does, and other starts do not change them. */
  struct ph_arc_natural natural[REFINE_MAX][DIM_MAX + 1];
  struct ph_arena kept; /* holds them */
};

/* ---- what is asked for --------------------------------------------------- */

static bool is_soft(const struct task *t) {
  return t->data.sigma > 0;
}

static enum ph_status read_refine(struct task *t) {
  const struct ph_value *refine = &t->problem->field[PH_F_REFINE];
  t->request.refine = t->data.length ? 2 : 1;
  t->refine_last = REFINE_MAX;
  if (refine->kind == PH_NUMBER) {
    double r = refine->number;
    if (!(r >= 1 && r <= 3 && floor(r) >= r)) {
      return ph_fail(t->diag, PH_E_BAD_VALUE, "refine",
                     "must be 1, 2, 3 or auto, found %.17g", r);
    }
    t->request.refine = t->refine_last = (size_t)r;
  }
  if (t->data.closed && t->data.length && !is_soft(t) &&
      t->request.refine == 1) {
    return ph_fail(t->diag, PH_E_BAD_VALUE, "refine",
                   "must be 2 or 3 for a closed curve with exact lengths: "
                   "with 1 it has as many equations as unknowns");
  }
  return PH_OK;
}

static enum ph_status read_starts(struct task *t) {
  const struct ph_value *starts = &t->problem->field[PH_F_STARTS];
  double n = starts->kind == PH_NUMBER ? starts->number : 0;
  if (!(n >= 0 && n <= STARTS_MAX && floor(n) >= n)) {
    return ph_fail(t->diag, PH_E_BAD_VALUE, "starts",
                   "must be a whole number from 0 to %d, found %.17g",
                   STARTS_MAX, n);
  }
  t->request.random = (size_t)n;
  t->request.all = t->problem->field[PH_F_ALL_MINIMA].flag;
  return PH_OK;
}

static enum ph_status read_task(struct task *t) {
  enum ph_status status =
      ph_arc_data_read(t->problem, t->scratch, &t->data, t->diag);
  t->exact = t->data;
  if (t->data.tangent_sigma) {
    t->exact.sigma = 0;
  }
  t->request.data = &t->exact;
  t->keep_plane =
      t->data.plane && !ph_value_is(&t->problem->field[PH_F_PLANAR], "free");
  status = status == PH_OK ? read_refine(t) : status;
  return status == PH_OK ? read_starts(t) : status;
}

/* ---- one interval -------------------------------------------------------- */

/*
 * One interval between two points has a whole family of curves without bending
 * of w, F = 0.  The one taken is symmetric, in the plane: a constant and b
 * odd, with a^2 = (l + p) / 2 and b^2 = 3 (l - p) / 2 at the ends.
 */
static bool solve_single(struct task *t) {
  const struct ph_arc_data *d = &t->data;
  struct ph_arc_search *search = &t->search;
  struct ph_arc_system *s = &search->system;
  double chord = d->chord[0], length = d->length ? d->length[0] : chord;
  double rest = length > chord * (1 + STRAIGHT) ? length - chord : 0;
  double a = sqrt((length + chord) / 2), b = sqrt(1.5 * rest);
  struct ph_arc_found *found;
  memset(search, 0, sizeof *search);
  search->all = t->request.all;
  found = ph_arena_array(t->scratch, 1, sizeof *found);
  search->starts = ph_arena_array(t->scratch, 1, sizeof *search->starts);
  search->natural.length = ph_arena_array(t->scratch, 1, sizeof(double));
  if (!found || !search->starts || !search->natural.length ||
      !ph_arc_system_of(d, t->request.refine, 2, true, t->scratch, s) ||
      !ph_arc_point_alloc(s, t->scratch, &found->point)) {
    return false;
  }
  found->weight = 0;
  /* length < chord: the nearest that there is */
  a = rest > 0 ? a : sqrt(chord);
  for (size_t j = 0; j < s->nodes; j++) { /* w is linear: its middle values */
    double r = (double)s->refine, u = ((double)j - 0.5) / r;
    found->point.x[2 * j] = a;
    found->point.x[2 * j + 1] = b * (2 * u - 1);
  }
  found->point.converged = found->point.minimiser = true;
  found->start = 0;
  search->starts[0] = (struct ph_start){"exact", PH_OUTCOME_MINIMISER, 0, 0};
  search->starts_n = search->found_n = 1;
  search->found = found;
  search->natural.known = true;
  search->natural.length[0] = chord;
  return true;
}

/* ---- plane and space ----------------------------------------------------- */

/* The row of an interval in space that is row k of it in the plane. */
static size_t row_in_space(const struct ph_arc_system *plane,
                           const struct ph_arc_system *space, size_t k) {
  size_t at = 0;
  while (space->form[at] != plane->form[k]) {
    at++;
  }
  return at;
}

/* The nodes and multipliers of a curve in the plane, or on a line, as of one in
 * space. */
static void put_in_space(const struct ph_arc_system *plane,
                         const struct ph_arc_system *space,
                         const struct ph_arc_point *from,
                         struct ph_arc_point *to) {
  size_t n = plane->data->n, knots = (n + 1) * plane->knot_rows;
  memset(to->x, 0, space->x_n * sizeof *to->x);
  memset(to->y, 0, space->y_n * sizeof *to->y);
  for (size_t j = 0; j < plane->nodes; j++) {
    for (size_t k = 0; k < plane->dim; k++) { /* a and b are real */
      to->x[4 * j + 2 * k] = from->x[plane->dim * j + k];
    }
  }
  if (space->turn && plane->sign < 0) {
    to->x[space->x_n - 1] = PH_PI;
  }
  for (size_t r = 0; r < n * plane->forms_n; r++) {
    size_t i = r / plane->forms_n, k = r % plane->forms_n;
    to->y[i * space->forms_n + row_in_space(plane, space, k)] = from->y[r];
  }
  for (size_t r = 0; r < knots; r++) {
    size_t j = r / plane->knot_rows, k = r % plane->knot_rows;
    to->y[n * space->forms_n + j * space->knot_rows + k] =
        from->y[n * plane->forms_n + r];
  }
}

/* Whether a minimum among the curves in the plane is one in space. */
static enum ph_status judge_in_space(struct task *t,
                                     const struct ph_arc_found *found,
                                     bool *minimum) {
  struct ph_mark mark = ph_arena_mark(t->scratch);
  struct ph_arc_system space;
  struct ph_arc_newton work;
  struct ph_arc_point point;
  bool ok = ph_arc_system_of(&t->data, t->request.refine, 4, true, t->scratch,
                             &space);
  space.compliance = t->search.system.compliance;
  space.knot_compliance = t->search.system.knot_compliance;
  if (ok && found->weight > 0) {
    ph_arc_weigh(&space, found->weight);
  }
  ok = ok && ph_arc_newton_alloc(&space, t->scratch, &work) &&
       ph_arc_point_alloc(&space, t->scratch, &point);
  if (ok) {
    put_in_space(&t->search.system, &space, &found->point, &point);
    *minimum = ph_arc_is_minimum(&space, &work, point.x, point.y);
  }
  ph_arena_release(t->scratch, mark);
  return ok ? PH_OK : ph_fail_memory(t->diag);
}

/* A search, from the natural curve of one before if there was one. */
static bool search_now(struct task *t) {
  const struct ph_arc_search *search = &t->search;
  struct ph_arc_natural *natural =
      &t->natural[t->request.refine - 1][t->request.dim];
  t->request.natural = natural->length ? natural : NULL;
  if (!ph_arc_search_run(&t->request, t->scratch, &t->search)) {
    return false;
  }
  if (search->found_n == 0 && search->natural.length && !natural->length) {
    /* without memory for it, it is found again */
    ph_arc_natural_copy(&search->natural, t->data.n, search->system.x_n,
                        &t->kept, natural);
  }
  return true;
}

/* Measured tangents are fitted from where exact ones begin, if they are many: a
 * curve that keeps these winds, the more the longer it is.  Where that leads
 * nowhere, and of few, they are fitted from where the exact ones led. */
static bool fit_in(struct task *t) {
  const bool rescue = t->request.rescue, waves = t->request.waves;
  const bool all = t->request.all || t->request.random > 0 || !rescue;
  struct ph_mark mark = ph_arena_mark(t->scratch);
  t->request.rescue = t->request.waves = false;
  for (size_t k = t->data.n >= PH_ARC_MANY ? 0 : 1; !all && k < 2; k++) {
    t->request.stay = k == 0;
    if (!search_now(t) || !ph_arc_fit(&t->data, t->scratch, &t->search)) {
      return false;
    }
    if (t->search.found_n > 0) {
      return true;
    }
    ph_arena_release(t->scratch, mark);
  }
  t->request.stay = false;
  t->request.rescue = rescue;
  t->request.waves = waves;
  return search_now(t) && ph_arc_fit(&t->data, t->scratch, &t->search);
}

static bool search_in(struct task *t, size_t dim) {
  t->request.dim = dim;
  return t->data.tangent_sigma ? fit_in(t) : search_now(t);
}

/* Whether the minima in the plane are minima in space. */
static enum ph_status judge_all(struct task *t) {
  enum ph_status status = PH_OK;
  for (size_t i = 0; status == PH_OK && i < t->search.found_n; i++) {
    struct ph_arc_found *found = &t->search.found[i];
    bool minimum = false;
    status = judge_in_space(t, found, &minimum);
    found->point.minimiser = minimum;
    for (size_t k = 0; !minimum && k < t->search.starts_n; k++) {
      struct ph_start *start = &t->search.starts[k];
      if (ph_arc_is_same(start->f, found->point.f)) {
        start->outcome = PH_OUTCOME_SADDLE;
      }
    }
  }
  return status;
}

/* Vectors in a plane have spinors of both signs, of which the search in the
 * plane tries one: where it ends in a saddle, a minimum in space that is in the
 * plane after all is better.  There is none where many points have lengths: of
 * random ones 45 % of those with 2 intervals have one, 10 % with 8, 1 % with
 * 20, and none of 75 with 20 to 40. */
static enum ph_status look_around(struct task *t) {
  struct ph_arc_search plane = t->search;
  if (t->data.mode == PH_ARC_POINTS && t->data.length &&
      t->data.n >= PH_ARC_MANY) {
    return PH_OK;
  }
  if (!search_in(t, 4)) {
    return ph_fail_memory(t->diag);
  }
  if (t->search.found_n == 0 ||
      !ph_arc_is_flat(&t->search.system, t->search.found[0].point.x)) {
    t->search = plane;
  }
  return PH_OK;
}

static enum ph_status find_in_plane(struct task *t) {
  enum ph_status status = PH_OK;
  if (!search_in(t, 2)) {
    return ph_fail_memory(t->diag);
  }
  if (t->search.found_n == 0) {
    t->left_plane = true;
    return search_in(t, 4) ? PH_OK : ph_fail_memory(t->diag);
  }
  status = judge_all(t);
  return status == PH_OK && !t->search.found[0].point.minimiser ? look_around(t)
                                                                : status;
}

/* On a line.  Where the points have their chords as lengths there is no other
 * curve, and nothing to judge. */
static enum ph_status find_on_line(struct task *t) {
  if (!search_in(t, 1)) {
    return ph_fail_memory(t->diag);
  }
  return t->data.mode == PH_ARC_POINTS && t->data.length ? PH_OK : judge_all(t);
}

/* Finds curves: on a line, in the plane, in space. */
static enum ph_status find(struct task *t) {
  const struct ph_arc_data *d = &t->data;
  if (d->mode == PH_ARC_POINTS && d->n == 1) {
    return solve_single(t) ? PH_OK : ph_fail_memory(t->diag);
  }
  if (d->straight && d->mode != PH_ARC_DERIVATIVES &&
      !(d->chord && is_soft(t)) && (t->keep_plane || (d->chord && d->length))) {
    return find_on_line(t);
  }
  if (t->keep_plane) {
    return find_in_plane(t);
  }
  return search_in(t, 4) ? PH_OK : ph_fail_memory(t->diag);
}

/* A curve that is stationary, in place of a minimum. */
struct saddle {
  struct ph_arc_search search;
  bool left_plane;
};

static void settle_for(struct task *t, const struct saddle *saddle) {
  t->search = saddle->search;
  t->search.found[0] = saddle->search.saddle;
  t->search.found_n = 1;
  t->left_plane = saddle->left_plane;
}

/* Finds curves with as few segments in an interval as it takes: more of them
 * promise more than random waves.  Where no minimum is found, a curve that is
 * stationary is an answer, too; of measured lengths, which always have one,
 * everything is tried with the fewest segments first. */
static enum ph_status find_refined(struct task *t) {
  bool soft = is_soft(t) && !t->data.tangent_sigma;
  size_t first = t->request.refine;
  size_t passes = soft || first == t->refine_last ? 1 : 2;
  struct saddle saddle = {.left_plane = false};
  struct ph_mark mark = ph_arena_mark(t->scratch);
  enum ph_status status = PH_OK;
  for (size_t pass = 0; pass < passes; pass++) {
    t->request.rescue = pass == 0;
    t->request.waves = pass + 1 == passes;
    for (size_t r = first; r <= t->refine_last; r++) {
      t->request.saddles = soft && !saddle.search.has_saddle;
      t->request.refine = r;
      t->left_plane = false;
      ph_arena_release(t->scratch, mark);
      status = find(t);
      if (status != PH_OK || t->search.found_n > 0) {
        return status;
      }
      if (t->search.has_saddle && !saddle.search.has_saddle) {
        saddle = (struct saddle){t->search, t->left_plane};
        mark = ph_arena_mark(t->scratch); /* it stays */
      }
    }
  }
  if (saddle.search.has_saddle) {
    settle_for(t, &saddle);
  }
  return status;
}

/* ---- the whole ----------------------------------------------------------- */

static enum ph_status solve(const struct ph_problem *problem,
                            struct ph_arena *out, struct ph_arena *scratch,
                            struct ph_result *result, struct ph_diag *diag) {
  struct ph_mark mark = ph_arena_mark(scratch);
  struct task t = {.problem = problem,
                   .scratch = scratch,
                   .diag = diag,
                   .kept = ph_arena_beside(scratch)};
  enum ph_status status = read_task(&t);
  status = status == PH_OK ? find_refined(&t) : status;
  if (status == PH_OK && t.search.found_n == 0) {
    status = ph_arc_report_failure(&t.search, scratch, diag);
  } else if (status == PH_OK) {
    status = ph_arc_report(&t.search, t.left_plane, scratch, out, result, diag);
  }
  ph_arena_release(scratch, mark);
  ph_arena_free(&t.kept);
  return status;
}

static const struct ph_field fields[] = {
    {PH_F_POINTS, PH_VECTORS | PH_DATUM, 1u << 2 | 1u << 3, false, NULL, "none",
     "the points to interpolate, 2 or more, 3 or more if closed"},
    {PH_F_DERIVATIVES, PH_VECTORS | PH_DATUM, 1u << 2 | 1u << 3, false, NULL,
     "none",
     "in place of points: the derivatives at the knots, by the parameter"},
    {PH_F_TANGENTS, PH_VECTORS | PH_DATUM, 1u << 2 | 1u << 3, false, NULL,
     "none", "in place of points: the directions at the knots"},
    {PH_F_CLOSED, PH_BOOL, 0, false, NULL, "false",
     "close the curve through points, a repeated last one is dropped"},
    PH_FIELD_MERGE,
    PH_FIELD_AT,
    {PH_F_LENGTHS, PH_NUMBER | PH_NUMBERS | PH_SEGMENTS, 0, false, NULL,
     "free, of points",
     "arc lengths from datum to datum, one for all or one each"},
    {PH_F_LENGTH_SIGMA, PH_NUMBER, 0, false, NULL, "lengths are exact",
     "relative standard deviation of the lengths, which are then fitted"},
    {PH_F_TANGENT_SIGMA, PH_NUMBER | PH_NUMBERS | PH_DATUM, 0, false, NULL,
     "tangents are exact",
     "standard deviation of the tangents in radians, one for all or one each, "
     "which are then fitted"},
    {PH_F_KNOTS, PH_WORD | PH_NUMBERS | PH_DATUM, 0, false,
     "lengths|chordal|uniform", "lengths, without them chordal",
     "spacing of the knots, mean 1, or the knots themselves, increasing"},
    {PH_F_REFINE, PH_NUMBER | PH_WORD, 0, false, "auto", "auto",
     "segments from datum to datum: 1, 2 or 3, of their own accord 2 where "
     "lengths are given, else 1, and more where these do not do"},
    {PH_F_MAGNITUDES, PH_WORD, 0, false, "free|mean", "free",
     "size of derivatives with tangents: unknown, or the mean length"},
    {PH_F_PLANAR, PH_WORD, 0, false, "keep|free", "keep",
     "whether data in a plane have their curve in it"},
    {PH_F_STARTS, PH_NUMBER, 0, false, NULL, "0",
     "extra random starts of the iteration, 1000 at most"},
    {PH_F_ALL_MINIMA, PH_BOOL, 0, false, NULL, "false",
     "try all starts and give every minimum that was found"},
    {PH_F_START, PH_NUMBERS, 0, false, NULL, "[0,0,0]",
     "the first point where only derivatives or tangents are given"},
};

/* More segments first, where their number was given: they find a curve for
 * lengths that are meant to be met. */
static const struct ph_advice advice[] = {
    {"lengths", PH_F_LENGTH_SIGMA, PH_F_LENGTH_SIGMA, "0.0001",
     "--override=length_sigma=0.0001 lets them differ by more"},
    {"tangents", PH_F_TANGENTS, PH_F_MAGNITUDES, "mean",
     "--magnitudes=mean gives each derivative a length"},
    {"lengths", PH_F_REFINE, PH_F_REFINE, "3",
     "--refine=3 gives the curve more room"},
    {"lengths", PH_F_TANGENTS, PH_F_TANGENT_SIGMA, NULL,
     "--tangent_sigma=0.01 allows for tangents that were measured"},
    {"lengths", PH_F_POINTS, PH_F_LENGTH_SIGMA, NULL,
     "--length_sigma=0.001 allows for lengths that were measured"},
    {"lengths", PH_F_DERIVATIVES, PH_F_LENGTH_SIGMA, NULL,
     "--length_sigma=0.001 allows for lengths that were measured"},
    {NULL, PH_F_REFINE, PH_F_REFINE, "2",
     "--refine=2 gives the curve more room"},
    {NULL, PH_F_REFINE, PH_F_REFINE, "3",
     "--refine=3 gives the curve more room"},
    {NULL, PH_FIELD_N, PH_F_STARTS, "20", "--starts=20 begins anew 20 times"},
};

const struct ph_method ph_method_arclength = {
    .schema = {"arclength", fields, sizeof fields / sizeof fields[0]},
    .title = "C2 PH splines in space with prescribed arc lengths",
    .dimension = 3,
    .solve = solve,
    .advice = advice,
    .advice_n = sizeof advice / sizeof advice[0],
};
