/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The method `spatial-hermite`: points in space, with tangents or without, to a
 * curve of independent PH quintic or ATPH segments.
 *
 * Each segment is a member of the family of its data (spatial.h), chosen
 * by a criterion; its tension is then reduced until it keeps the shape of the
 * data (spatial.h).  [FAR15; GON18, ch. 3]
 */
#include "solve/method.h"

#include "base/sum.h"
#include "base/team.h"
#include "curve/segment/seg3.h"
#include "solve/common/fields.h"
#include "solve/common/frame.h"
#include "solve/spatial/fairest.h"
#include "solve/spatial/spatial.h"

#include <math.h>
#include <string.h>

/* How well a factor on the tension can be told: of a minimum, half of the
 * digits of its value are known. */
static const double EXACT = 1e-13;
static const double MINIMUM = 1e-7;

/* The work of a segment, in evaluations of a functional, half a microsecond
 * each: beyond the first, which the last whole search may exceed by far, the
 * search at another tension begins with the minima of the last one; it has the
 * second for that.  50000 and 60000 make the slowest take 1.7 times as long. */
enum { WORK_WHOLE = 44000, WORK_NEAR = 30000 };

/* Segments that are held together, that a thread takes at once, and that are
 * worth another one: a segment takes a microsecond and more, a thread 20 to
 * begin. */
enum { BLOCK = 2048, CHUNK = 64, WORTH = 512 };

/* The same of segments whose angles are searched for, 100 microseconds and
 * more each. */
enum { WORTH_SEARCHES = 2 };

/* The criteria: those of FAR15 are functions of the family. */
static const struct criterion {
  const char *name;
  struct ph_spatial_member (*choose)(const struct ph_spatial_family *family);
  int functional; /* 1, 2, 3: minimise it; 0: do not */
} criteria[] = {{"cc", ph_spatial_cc, 0}, {"hc", ph_spatial_hc, 0},
                {"bv", ph_spatial_bv, 0}, {"zero", NULL, 0},
                {"F1", NULL, 1},          {"F2", NULL, 2},
                {"F3", NULL, 3}};

/* A problem on its way. */
struct task {
  struct ph_spatial_points points;
  struct ph_atph space; /* of alpha = 0 */
  struct ph_fair3_rules rules;
  struct ph_arena *scratch;
  const struct criterion *criterion;
  const double *angles; /* fixed: [n][2], or one pair for all */
  size_t angles_stride;
  enum ph_spatial_axis axis;
  bool shape;
  struct ph_result *result;
  size_t evaluations, reduced, unsatisfied, first_unsatisfied;
  const char *tried, *why;               /* of the first unsatisfied segment */
  size_t substituted, first_substituted; /* F1 in the place of F2 or F3 */
  size_t cut_short, first_cut_short;     /* curves found after WORK_WHOLE */
  double functional, residual;
  bool at_bound;
};

/* Whether the angles of a segment are looked for, by its criterion. */
static bool searches(const struct task *t) {
  return !t->angles && t->criterion->functional;
}

/* ---- reading -------------------------------------------------------- */

static enum ph_status set_criterion(const struct ph_problem *problem,
                                    struct task *t, struct ph_diag *diag) {
  const struct ph_value *value = &problem->field[PH_F_CRITERION];
  const char *name = value->kind == PH_WORD ? value->word
                     : t->points.atph       ? "F3"
                                            : "cc";
  size_t i = 0;
  while (strcmp(criteria[i].name, name) != 0) {
    i++;
  }
  t->criterion = &criteria[i];
  if (value->kind != PH_ABSENT && t->angles) {
    return ph_fail(diag, PH_E_BAD_VALUE, "criterion",
                   "excludes angles, which are given in its place");
  }
  if (t->points.atph && !t->points.alpha && !searches(t)) {
    return ph_fail(diag, PH_E_MISSING_FIELD, "alpha",
                   "is missing: only the criteria F1, F2 and F3 choose it");
  }
  return PH_OK;
}

static enum ph_status set_angles(const struct ph_problem *problem,
                                 struct task *t, struct ph_diag *diag) {
  const struct ph_value *angles = &problem->field[PH_F_ANGLES];
  const struct ph_value *axis = &problem->field[PH_F_AXIS];
  bool pair = angles->kind == PH_NUMBERS; /* [theta,beta] */
  t->axis = ph_value_is(axis, "x")          ? PH_SPATIAL_X
            : ph_value_is(axis, "bisector") ? PH_SPATIAL_BISECTOR
            : ph_value_is(axis, "chord")    ? PH_SPATIAL_CHORD
            : t->points.atph                ? PH_SPATIAL_X
                                            : PH_SPATIAL_CHORD;
  if (angles->kind == PH_ABSENT) {
    return PH_OK;
  }
  if (pair ? angles->n != 2 : angles->n != 1 && angles->n != t->points.n) {
    return ph_fail(diag, PH_E_BAD_SHAPE, "angles",
                   "must have %zu pairs, one for each segment, or one for all, "
                   "found %zu %s",
                   t->points.n, angles->n, pair ? "numbers" : "vectors");
  }
  t->angles = angles->v;
  t->angles_stride = pair || angles->n == 1 ? 0 : 2;
  return PH_OK;
}

static enum ph_status read_task(const struct ph_problem *problem,
                                struct ph_arena *out, struct ph_arena *scratch,
                                struct task *t, struct ph_diag *diag) {
  const struct ph_value *shape = &problem->field[PH_F_SHAPE];
  enum ph_status status =
      ph_spatial_points_of(problem, out, scratch, &t->points, diag);
  if (status == PH_OK) {
    status = set_angles(problem, t, diag);
  }
  if (status == PH_OK) {
    status = set_criterion(problem, t, diag);
  }
  /* Derivatives that are given are kept, unless their owner says otherwise. */
  t->shape = shape->kind == PH_BOOL ? shape->flag : !t->points.derivatives;
  return status;
}

/* ---- one segment ---------------------------------------------------- */

/* What the choice of a member depends on beside its family. */
struct choice {
  const struct task *task;
  size_t segment, evaluations;
  struct ph_spatial_data data; /* dp and directions */
  size_t work, near;           /* of whole searches, and of others */
  bool cut_short;
  struct ph_spatial_minimum last; /* found */
  struct ph_diag *diag;
};

static enum ph_status no_angles(const struct choice *c) {
  return ph_fail_at(c->diag, PH_E_INFEASIBLE, "segments", c->segment,
                    "has no angles about the axis \"%s\": a tangent or the "
                    "vector d is opposite to it; \"axis\":\"bisector\" always "
                    "has",
                    c->task->axis == PH_SPATIAL_X ? "x" : "chord");
}

/* The angles of segment k that no criterion chooses, or NULL. */
static const double *fixed_angles(const struct task *t, size_t k) {
  static const double zero[2] = {0, 0};
  bool chosen = t->criterion->choose || t->criterion->functional;
  return t->angles ? t->angles + k * t->angles_stride : chosen ? NULL : zero;
}

/* The member that a criterion chooses, of plane data from those in their plane.
 * Where it lies in the plane as the data do, it is that of any data. */
static void choose_of(const struct criterion *criterion,
                      const struct ph_spatial_family *family,
                      struct ph_spatial_member *member) {
  struct ph_spatial_family plane = *family;
  ph_quat a[3];
  *member = criterion->choose(family);
  if (family->has_plane && !family->planar) {
    ph_spatial_preimage(family, *member, a);
    if (!ph_spatial_is_plane(family, a)) {
      plane.planar = true;
      *member = criterion->choose(&plane);
    }
  }
}

/* A criterion that is a function of the family, or given angles. */
static enum ph_status choose_member(struct ph_spatial_fit *fit, void *context) {
  const struct choice *c = context;
  const struct task *t = c->task;
  const double *angles = fixed_angles(t, c->segment);
  if (!angles) {
    choose_of(t->criterion, &fit->family, &fit->member);
    return PH_OK;
  }
  return ph_spatial_member_of(&fit->family, angles, t->axis, &fit->member)
             ? PH_OK
             : no_angles(c);
}

/* The whole search, so that what is found at a tension does not depend on how
 * it was come to, while there is time for that. */
static enum ph_status search_fairest(struct choice *c,
                                     const struct ph_spatial_search *search) {
  const struct task *t = c->task;
  enum ph_status status = PH_OK;
  c->last.work = c->last.evaluations = 0;
  c->cut_short = c->work >= WORK_WHOLE;
  if (!c->cut_short) {
    status = ph_spatial_minimize(search, &t->rules, t->scratch, &c->last);
    c->work += c->last.work;
  } else if (c->near < WORK_NEAR) {
    struct ph_spatial_search near = *search;
    near.functional = c->last.functional;
    status = ph_spatial_descend(&near, &t->rules, t->scratch, &c->last);
    c->near += c->last.work;
  } else {
    c->last.value = HUGE_VAL;
  }
  return status;
}

/* The fairest member, and alpha where it is free. */
static enum ph_status choose_fairest(struct ph_spatial_fit *fit,
                                     void *context) {
  struct choice *c = context;
  const struct task *t = c->task;
  bool free = t->points.atph && !t->points.alpha;
  double angle = fit->family.space.angle;
  struct ph_spatial_search search = {
      .data = &c->data,
      .scaled = free && t->points.derivatives,
      .alpha_lower = free ? PH_SPATIAL_ALPHA_MIN : angle,
      .alpha_upper = free ? PH_SPATIAL_ALPHA_MAX : angle,
      .functional = t->criterion->functional,
      .plane = t->shape};
  const struct ph_spatial_minimum *found = &c->last;
  c->data.ni = fit->family.ni;
  c->data.nf = fit->family.nf;
  if (search_fairest(c, &search) != PH_OK) {
    return ph_fail_memory(c->diag);
  }
  if (!isfinite(found->value)) {
    return ph_fail_at(c->diag, PH_E_NO_CONVERGENCE, "segments", c->segment,
                      "has no finite %s%s, as far as was found",
                      t->criterion->name,
                      t->criterion->functional > 1 ? ", and no finite F1" : "");
  }
  c->evaluations += found->evaluations;
  fit->cut_short = c->cut_short;
  fit->member = found->member;
  fit->functional = found->functional;
  if (free) {
    struct ph_atph space = ph_atph_of(found->alpha);
    c->data.ni *= search.scaled ? found->alpha : 1;
    c->data.nf *= search.scaled ? found->alpha : 1;
    fit->family = ph_spatial_family_of(&c->data, &space);
  }
  return PH_OK;
}

/* What is found of a segment alone. */
struct found {
  struct ph_spatial_data data;
  struct ph_spatial_tension best;
  struct ph_spatial_chosen chosen;
  size_t evaluations;
  bool cut_short; /* at some tension */
  enum ph_status status;
};

/* The segment at the tension that the criterion and the shape ask for. */
static enum ph_status fit_segment(const struct task *t, size_t k,
                                  struct found *found, struct ph_diag *diag) {
  struct ph_spatial_data *data = &found->data;
  struct ph_spatial_tension *best = &found->best;
  struct choice choice = {.task = t, .segment = k, .data = *data, .diag = diag};
  struct ph_atph space =
      t->points.alpha ? ph_atph_of(t->points.alpha[k]) : t->space;
  ph_spatial_choice *choose = searches(t) ? choose_fairest : choose_member;
  enum ph_status status;
  if (t->points.derivatives && t->points.alpha) {
    data->ni *= t->points.alpha[k];
    data->nf *= t->points.alpha[k];
  }
  if (t->shape) {
    status =
        ph_spatial_tension(data, &space, choose, &choice,
                           choose == choose_fairest ? MINIMUM : EXACT, best);
    found->cut_short = choice.cut_short;
  } else {
    best->factor = 1;
    best->without = 0;
    best->tried = 1;
    status = ph_spatial_fit_of(data, &space, choose, &choice, &best->fit);
    found->cut_short = false;
  }
  found->evaluations = choice.evaluations;
  return status;
}

static double functional_of(struct task *t, size_t k,
                            const struct ph_spatial_fit *fit) {
  const struct ph_atph *space = &fit->family.space;
  struct ph_fair3 fair;
  if (fit->functional != t->criterion->functional) {
    t->first_substituted = t->substituted++ ? t->first_substituted : k;
    return HUGE_VAL;
  }
  fair = ph_fair3_of(&t->rules, space, fit->a);
  return ph_fair3_functional(&fair, ph_seg3_length(space, fit->a),
                             t->criterion->functional);
}

/* What may be why, after a word about the segment. */
static const char *why_unsatisfied(const struct ph_spatial_data *data,
                                   unsigned violated) {
  return violated & PH_SHAPE_PLANE ? "it leaves their plane"
         : !ph_spatial_is_forward(data)
             ? "(ti + tf).dp is not positive, the condition for it fails"
         : !ph_spatial_is_acute(data)
             ? "ti.tf is not positive, the condition for it fails"
             : "(ti + tf).dp and ti.tf are positive, and yet none was found";
}

static void count_segment(struct task *t, size_t k, const struct found *found) {
  const struct ph_spatial_tension *best = &found->best;
  double angle = best->fit.family.space.angle;
  t->evaluations += found->evaluations;
  if (best->fit.cut_short) {
    t->first_cut_short = t->cut_short++ ? t->first_cut_short : k;
  }
  t->reduced += best->factor < 1;
  if (t->shape && best->fit.violated && t->unsatisfied++ == 0) {
    t->first_unsatisfied = k;
    t->tried = found->cut_short ? " that was tried" : "";
    t->why = why_unsatisfied(&found->data, best->fit.violated);
  }
  if (!searches(t)) {
    t->evaluations += best->tried;
  } else {
    t->functional += functional_of(t, k, &best->fit);
    t->at_bound = t->at_bound || angle <= PH_SPATIAL_ALPHA_MIN ||
                  angle >= PH_SPATIAL_ALPHA_MAX;
  }
}

/* The angles of segment k for its record: those given as they were. */
static void set_angles_of(const struct task *t, size_t k,
                          const struct ph_spatial_fit *fit, double angles[2]) {
  const double *fixed = fixed_angles(t, k);
  if (fixed) {
    memcpy(angles, fixed, 2 * sizeof *angles);
  } else if (!ph_spatial_angles(&fit->family, fit->member, t->axis, angles)) {
    angles[0] = angles[1] = (double)NAN;
  }
}

static void find_segment(const struct task *t, size_t k, struct found *found,
                         struct ph_diag *diag) {
  const double tension = ph_spatial_tension_of(&t->points, k);
  struct ph_spatial_chosen *chosen = &found->chosen;
  chosen->root = ph_spatial_segment(&t->points, k, tension, &found->data);
  chosen->twice = searches(t) ? ph_spatial_double(&found->data) : 1;
  found->status = fit_segment(t, k, found, diag);
  if (found->status == PH_OK) {
    chosen->fit = &found->best.fit;
    chosen->tension = tension * found->best.factor;
    set_angles_of(t, k, chosen->fit, chosen->angles);
  }
}

/* Segments that are looked for together. */
struct block {
  const struct task *task;
  size_t first;               /* of them */
  struct found *found;        /* by segment */
  struct ph_account *account; /* of the memory of each; NULL: it takes none */
  atomic_bool late;
};

/* The same where memory is taken for it, which is free again. */
static bool search_segment(const struct block *b, size_t i,
                           struct ph_diag *why) {
  struct ph_account *account = &b->account[i];
  struct task own = *b->task;
  bool late;
  ph_account_begin(account, b->task->scratch);
  own.scratch = &account->arena;
  late = ph_arena_late(own.scratch);
  if (!late) {
    find_segment(&own, b->first + i, &b->found[i], why);
  }
  ph_arena_free(own.scratch);
  return !late;
}

static bool find_some(void *context, size_t thread, size_t first, size_t end) {
  struct block *b = context;
  struct ph_diag why;
  for (size_t i = first; i < end; i++) {
    bool in_time = true;
    if (b->account) {
      in_time = search_segment(b, i, &why);
    } else if (!thread && ph_arena_late(b->task->scratch)) {
      in_time = false; /* it is for one to ask */
    } else {
      find_segment(b->task, b->first + i, &b->found[i], &why);
    }
    if (!in_time) {
      atomic_store(&b->late, true);
      return false;
    }
    if (b->found[i].status != PH_OK) {
      return false;
    }
  }
  return true;
}

/* n segments, by all threads that there are. */
static void find_block(struct block *b, size_t n) {
  const bool takes = b->account;
  ph_team_share(b->task->scratch, n, takes ? WORTH_SEARCHES : WORTH,
                takes ? 1 : CHUNK, find_some, b);
}

/* Where the curve goes on: the frame at its end, and its length. */
struct end {
  ph_quat frame;
  struct ph_sum length;
};

static void put_segment(struct task *t, size_t k, const struct found *found,
                        struct end *end) {
  struct ph_curve *curve = &t->result->curve;
  double missed;
  count_segment(t, k, found);
  missed = ph_spatial_put(&t->points, k, &found->chosen, &end->frame, curve);
  t->residual = missed > t->residual ? missed : t->residual;
  ph_sum_add(&end->length, curve->lengths[k]);
}

/* Why a segment was not found. */
static enum ph_status tell(const struct task *t, size_t k, struct found *found,
                           struct ph_diag *diag) {
  if (found->status == PH_E_NO_MEMORY) {
    return ph_fail_memory(diag);
  }
  find_segment(t, k, found, diag);
  return found->status;
}

static enum ph_status solve_segments(struct task *t, struct ph_diag *diag) {
  struct ph_curve *curve = &t->result->curve;
  struct end end = {{1, 0, 0, 0}, {0, 0}};
  const size_t n = t->points.n, most = n < BLOCK ? n : BLOCK;
  struct block block = {.task = t};
  block.found = ph_arena_array(t->scratch, most, sizeof *block.found);
  if (searches(t)) {
    block.account = ph_arena_array(t->scratch, most, sizeof *block.account);
  }
  if (!block.found || (searches(t) && !block.account)) {
    return ph_fail_memory(diag);
  }
  atomic_init(&block.late, false);
  for (; block.first < n; block.first += most) {
    const size_t here = n - block.first < most ? n - block.first : most;
    find_block(&block, here);
    if (atomic_load(&block.late)) {
      return ph_fail_memory(diag);
    }
    for (size_t i = 0; i < here; i++) {
      if (block.account && !ph_account_end(&block.account[i])) {
        return ph_fail_memory(diag);
      }
      if (block.found[i].status != PH_OK) {
        return tell(t, block.first + i, &block.found[i], diag);
      }
      put_segment(t, block.first + i, &block.found[i], &end);
    }
  }
  curve->length = ph_sum_value(&end.length);
  if (curve->closed) {
    ph_diagnostics_set(&t->result->diagnostics, PH_D_FRAME_TURN,
                       ph_frame_turn(curve, end.frame));
  }
  return PH_OK;
}

/* ---- the whole ------------------------------------------------------ */

static void report(const struct task *t) {
  struct ph_diagnostics *d = &t->result->diagnostics;
  ph_diagnostics_set(d, PH_D_ITERATIONS, (double)t->evaluations);
  ph_diagnostics_set(d, PH_D_RESIDUAL, t->residual);
  ph_diagnostics_set(d, PH_D_REDUCED, (double)t->reduced);
  if (searches(t)) {
    ph_diagnostics_set_finite(d, PH_D_FUNCTIONAL, t->functional);
    if (t->points.atph && !t->points.alpha) {
      ph_diagnostics_set(d, PH_D_AT_BOUND, t->at_bound);
    }
  }
  ph_warn_alpha(&t->result->curve, t->result);
  if (t->substituted) {
    ph_warn(
        t->result, t->first_substituted, PH_W_INFINITE_FUNCTIONAL,
        "segment %zu has no finite %s, as far as was found, and the least F1 "
        "in its place (such segments: %zu)",
        t->first_substituted, t->criterion->name, t->substituted);
  }
  if (t->cut_short) {
    ph_warn(t->result, t->first_cut_short, PH_W_CUT_SHORT,
            "segment %zu took %d evaluations of %s, and began with the last "
            "curves at its tension: others may be fairer, or need less of it "
            "(such segments: %zu)",
            t->first_cut_short, WORK_WHOLE, t->criterion->name, t->cut_short);
  }
  if (t->unsatisfied) {
    ph_warn(t->result, t->first_unsatisfied, PH_W_SHAPE_UNSATISFIABLE,
            "segment %zu does not keep the shape of its data at any "
            "tension%s: %s (such segments: %zu)",
            t->first_unsatisfied, t->tried, t->why, t->unsatisfied);
  }
  if (t->points.estimated) {
    ph_spatial_warn_reversals(&t->points, t->result);
  }
}

static enum ph_status solve(const struct ph_problem *problem,
                            struct ph_arena *out, struct ph_arena *scratch,
                            struct ph_result *result, struct ph_diag *diag) {
  struct ph_mark mark = ph_arena_mark(scratch);
  struct task t = {
      .result = result, .space = ph_atph_of(0), .scratch = scratch};
  enum ph_status status = read_task(problem, out, scratch, &t, diag);
  if (status == PH_OK) {
    status = ph_spatial_curve_alloc(&t.points, out, &result->curve, diag);
  }
  if (status == PH_OK && !ph_fair3_begin(&t.rules)) {
    status = ph_fail_memory(diag);
  }
  if (status == PH_OK) {
    status = solve_segments(&t, diag);
  }
  if (status == PH_OK) {
    report(&t);
  }
  ph_arena_release(scratch, mark);
  return status;
}

static const struct ph_field fields[] = {
    {PH_F_POINTS, PH_VECTORS | PH_DATUM, 1u << 2 | 1u << 3, true, NULL, NULL,
     "the points to interpolate, 2 or more, 3 or more if closed"},
    {PH_F_CLOSED, PH_BOOL, 0, false, NULL, "false",
     "close the curve, a repeated last point is dropped"},
    PH_FIELD_MERGE,
    PH_FIELD_AT,
    {PH_F_TANGENTS, PH_VECTORS | PH_DATUM, 1u << 2 | 1u << 3, false, NULL,
     "from the points", "a direction for each point"},
    {PH_F_DERIVATIVES, PH_VECTORS | PH_DATUM, 1u << 2 | 1u << 3, false, NULL,
     "none", "a derivative for each point, by the parameter of a segment"},
    {PH_F_BASIS, PH_WORD, 0, false, "ph|atph", "ph",
     "PH quintic segments, polynomial, or algebraic-trigonometric ones"},
    {PH_F_CRITERION, PH_WORD, 0, false, "cc|hc|bv|zero|F1|F2|F3",
     "cc, of atph F3", "what chooses the two angles of a segment"},
    {PH_F_ANGLES, PH_VECTORS | PH_NUMBERS | PH_SEGMENTS, 1u << 2, false, NULL,
     "by the criterion", "pairs [theta,beta], one for each segment or for all"},
    {PH_F_AXIS, PH_WORD, 0, false, "chord|x|bisector", "chord, of atph x",
     "the axis that angles are about"},
    {PH_F_ALPHA, PH_NUMBER | PH_NUMBERS | PH_SEGMENTS, 0, false, NULL,
     "chosen by F1, F2 or F3",
     "angles of atph segments below pi, one for all or one each"},
    {PH_F_KNOTS, PH_WORD | PH_NUMBERS | PH_DATUM, 0, false, "chordal",
     "chordal",
     "the knots, increasing: where tangents have no length, their differences "
     "are it"},
    {PH_F_TENSION, PH_NUMBER | PH_NUMBERS | PH_SEGMENTS, 0, false, NULL, "1",
     "scales end derivatives by its square, one for all or one each"},
    {PH_F_SHAPE, PH_BOOL, 0, false, NULL, "true, with derivatives false",
     "reduce the tension until segments keep the shape of the data"},
    {PH_F_PLANARITY, PH_NUMBER, 0, false, NULL, PH_TEXT(PH_PLANARITY),
     "data that leave a plane by no more of their chord are plane data"},
};

static const struct ph_advice advice[] = {
    {"segments", PH_FIELD_N, PH_F_CRITERION, "cc",
     "--criterion=cc minimises nothing"},
};

const struct ph_method ph_method_spatial_hermite = {
    .schema = {"spatial-hermite", fields, sizeof fields / sizeof fields[0]},
    .title = "G1 PH curves through points in space",
    .dimension = 3,
    .solve = solve,
    .advice = advice,
    .advice_n = sizeof advice / sizeof advice[0],
};
