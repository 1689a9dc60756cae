/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Curvature-continuous splines in parts (see g2.h).
 *
 * Where chords of very different lengths meet large turns, or flat points are
 * beside sharp ones, the curvature must be large so that it can be the same on
 * both sides.  So energy times length is compared with that of the mode spline;
 * where it is larger by more than a tenth, the intervals to which this is due
 * get the pairs of that mode, and what is between them is solved again, between
 * the tangents of that mode.
 */
#include "solve/tc/g2.h"

#include "kernel/pi.h"

#include <math.h>
#include <string.h>

/* Energy times length may be larger by this than that of the mode spline. */
static const double WORSE = 1.1;

/* An interval gets a pair if its excess is this part of the largest. */
static const double EXCESS = 0.25;

/* Quantities that differ by less are the same but for rounding. */
static const double ALIKE = 1e-9;

/* Rounds of pairs: in the last all intervals get them. */
enum { ROUNDS_MAX = 12 };

/* ---- measures ------------------------------------------------------------ */

/* Energies and lengths at unit scale, of intervals or of all. */
struct bent {
  double energy, length;
};

static void add(struct bent *sum, struct bent by) {
  sum->energy += by.energy;
  sum->length += by.length;
}

/* Of the cubic with these angles on a chord of this length. */
static struct bent bent_of(double a, double b, double chord) {
  struct ph_tc tc = ph_g2_preimage(a, b);
  struct bent m = {ph_tc_energy(&tc) / chord, ph_tc_length(&tc) * chord};
  return m;
}

static struct bent span_bent(const struct ph_g2_part *part, size_t i) {
  const struct ph_g2_span *span = &part->chain.span[i];
  const double a = part->solution.a[i], b = part->solution.b[i];
  const double chord = span->length;
  struct bent m = {0, chord};
  if (span->form == PH_G2_ARC) {
    m = bent_of(a, b, chord);
  } else if (span->form == PH_G2_BEND) {
    struct ph_g2_bend bend = ph_g2_bend_of(a, b);
    double first = hypot(bend.joint.re, bend.joint.im);
    double last = hypot(1 - bend.joint.re, bend.joint.im);
    m = bent_of(bend.a[0], bend.b[0], first * chord);
    add(&m, bent_of(bend.a[1], bend.b[1], last * chord));
  }
  return m;
}

/* ---- the search ---------------------------------------------------------- */

struct search {
  const struct ph_tc_data *data;
  struct ph_tc_data spline; /* the same, of the mode spline */
  bool may_add;
  enum ph_g2_rule rule;
  struct ph_arena *arena;  /* of the parts, */
  struct ph_arena *chains; /* of their chains and angles, */
  struct ph_arena work;    /* of what is not needed after the search, */
  struct ph_arena round;   /* or while parts are solved */
  struct ph_diag *diag;
  struct bent *pair, *here; /* [n] of the pair of the mode spline; as it is */
  atomic_bool no_pair;      /* an interval has none */
  struct bent pairs;        /* the sum */
  unsigned char *mark;      /* [n] whether the interval gets its pair */
  size_t start;             /* of closed data the first that got one */
  unsigned char *line;      /* [points] whether a line begins or ends there */
  unsigned char *loose;     /* [points] of the chains */
  unsigned char *hard;      /* [n] of the chains */
};

static bool measure_some_pairs(void *context, size_t thread, size_t first,
                               size_t end) {
  struct search *s = context;
  struct ph_diag why;
  struct ph_tc_fit fit;
  (void)thread;
  for (size_t k = first; k < end; k++) {
    double chord = s->spline.chord[k];
    if (ph_tc_interval(&s->spline, k, &fit, &why) != PH_OK) {
      atomic_store(&s->no_pair, true);
      return false;
    }
    s->pair[k] = (struct bent){fit.energy / chord, fit.length * chord};
  }
  return true;
}

/* The pairs of all intervals.  ret false: the mode spline has no curve */
static bool measure_pairs(struct search *s) {
  atomic_init(&s->no_pair, false);
  ph_g2_share(s->arena, s->data->n, measure_some_pairs, s);
  if (atomic_load(&s->no_pair)) {
    return false;
  }
  s->pairs = (struct bent){0, 0};
  for (size_t k = 0; k < s->data->n; k++) {
    add(&s->pairs, s->pair[k]);
  }
  return true;
}

/* Index k of closed data goes on at their start. */
static size_t around(const struct search *s, size_t k) {
  return s->data->closed && k >= s->data->n ? k - s->data->n : k;
}

/* The tangent of a part at datum k, or that of the data at an end. */
static ph_cplx tangent_at(const struct search *s, size_t k) {
  const struct ph_tc_data *d = s->data;
  ph_cplx v;
  if (!d->closed && (k == 0 || k == d->n)) {
    return d->vector[k];
  }
  v = s->spline.vector[around(s, k)];
  return ph_cplx_scale(1 / hypot(v.re, v.im), v);
}

/* A part that is not solved yet.  ret PH_OK | PH_E_NO_MEMORY, or a failure of
 * the only part */
static enum ph_status solve_part(struct search *s, struct ph_g2_part *part,
                                 bool only) {
  const struct ph_tc_data *d = s->data;
  struct ph_diag why = {.status = PH_OK}, *diag = only ? s->diag : &why;
  enum ph_status status;
  if (part->pair) {
    return ph_tc_interval(&s->spline, part->first, &part->fit, s->diag);
  }
  ph_cplx tangent[2] = {{(double)NAN, 0}, {(double)NAN, 0}};
  if (!d->closed || !only) {
    tangent[0] = tangent_at(s, part->first);
    tangent[1] = tangent_at(s, part->first + part->n);
  }
  part->chain =
      (struct ph_g2_chain){.data = d, .loose = s->loose, .hard = s->hard};
  status = ph_g2_find(part->first, part->n, d->closed && only ? NULL : tangent,
                      s->may_add, s->rule, s->chains, &part->chain,
                      &part->solution, diag);
  part->solved = status == PH_OK;
  if (status == PH_E_NO_CONVERGENCE && ph_arena_late(s->arena)) {
    return ph_fail_memory(s->diag);
  }
  if (status == PH_E_NO_MEMORY) {
    return ph_fail_memory(s->diag);
  }
  return only ? status : PH_OK;
}

/* Spans of a part that are measured. */
struct measured {
  const struct ph_g2_part *part;
  struct bent *span; /* [n] */
};

static bool measure_spans(void *context, size_t thread, size_t first,
                          size_t end) {
  const struct measured *m = context;
  (void)thread;
  for (size_t i = first; i < end; i++) {
    m->span[i] = span_bent(m->part, i);
  }
  return true;
}

/* Energies and lengths of the intervals of a part; spans of a long one are
 * measured before. */
static void add_spans(struct search *s, const struct ph_g2_part *part,
                      const struct bent *spans) {
  size_t at = part->first;
  if (part->pair) {
    s->here[at] = s->pair[at];
    return;
  }
  for (size_t i = 0; i < part->n; i++) {
    s->here[around(s, part->first + i)] = (struct bent){0, 0};
  }
  for (size_t i = 0; i < part->chain.n; i++) {
    size_t next = ph_g2_next(&part->chain, i);
    add(&s->here[at], spans ? spans[i] : span_bent(part, i));
    if (part->chain.span[i].form == PH_G2_LINE) {
      s->line[at] = s->line[around(s, at + 1)] = 1;
    }
    if (part->chain.node[next].datum != PH_G2_ADDED) {
      at = around(s, at + 1);
    }
  }
}

static void measure_part(struct search *s, const struct ph_g2_part *part) {
  const struct ph_mark mark = ph_arena_mark(&s->work);
  struct measured m = {.part = part};
  if (!part->pair && part->chain.n >= PH_G2_WORTH) {
    m.span = ph_arena_array(&s->work, part->chain.n, sizeof *m.span);
  }
  if (m.span) {
    ph_g2_share(s->arena, part->chain.n, measure_spans, &m);
  }
  add_spans(s, part, m.span);
  ph_arena_release(&s->work, mark);
}

/* How much shorter the chord of interval i is than one beside it. */
static double shortness(const struct ph_tc_data *d, size_t i) {
  double most = 1;
  if (i > 0 || d->closed) {
    most = fmax(most, d->chord[i > 0 ? i - 1 : d->n - 1] / d->chord[i]);
  }
  if (i + 1 < d->n || d->closed) {
    most = fmax(most, d->chord[i + 1 < d->n ? i + 1 : 0] / d->chord[i]);
  }
  return most;
}

/* Marks the middle of a run, of two intervals the one that bends more; of all
 * closed data, which have no middle, those that bend most. */
static void mark_middle(struct search *s, const struct ph_g2_part *part,
                        size_t first, size_t run) {
  const size_t n = s->data->n;
  double most = 0;
  if (!part->chain.closed || run < n) {
    const size_t a = around(s, first + (run - 1) / 2);
    const size_t b = around(s, first + run / 2);
    s->mark[s->pair[b].energy > s->pair[a].energy ? b : a] = 1;
    return;
  }
  for (size_t i = 0; i < n; i++) {
    most = fmax(most, s->pair[i].energy);
  }
  for (size_t i = 0; i < n; i++) {
    s->mark[i] |= !(s->pair[i].energy < (1 - ALIKE) * most);
  }
}

/* Marks the intervals of a run that are short beside others, and the middle. */
static void mark_run(struct search *s, const struct ph_g2_part *part,
                     size_t first, size_t n) {
  double most = 1;
  for (size_t i = first; i < first + n; i++) {
    most = fmax(most, shortness(s->data, around(s, i)));
  }
  for (size_t i = first; i < first + n; i++) {
    if (most > 1 && shortness(s->data, around(s, i)) >= sqrt(most)) {
      s->mark[around(s, i)] = 1;
    }
  }
  mark_middle(s, part, first, n);
}

/* A part without a solution: marks intervals that are stuck, or some of each
 * run that is hard; of all, if it is not known where it is hard. */
static void mark_failed(struct search *s, const struct ph_g2_part *part) {
  const size_t end = part->first + part->n;
  size_t run = 0, runs = 0;
  bool stuck = false;
  for (size_t i = part->first; i < end; i++) {
    if (s->hard[around(s, i)] == PH_G2_STUCK) {
      s->mark[around(s, i)] = 1;
      stuck = true;
    }
  }
  for (size_t i = part->first; !stuck && i <= end; i++) {
    if (i < end && s->hard[around(s, i)]) {
      run++;
    } else if (run > 0) {
      mark_run(s, part, i - run, run);
      run = 0;
      runs++;
    }
  }
  if (!stuck && runs == 0) {
    mark_run(s, part, part->first, part->n);
  }
}

/* How much an interval makes the whole worse than with all pairs. */
static double excess(const struct search *s, size_t i) {
  return (s->here[i].energy - s->pair[i].energy) / s->pairs.energy +
         (s->here[i].length - s->pair[i].length) / s->pairs.length;
}

/* Lets the curve leave the lines beside an interval.  ret whether there are */
static bool loosen(struct search *s, size_t i) {
  const size_t end[2] = {i, around(s, i + 1)};
  bool any = false;
  for (size_t k = 0; k < 2; k++) {
    if (s->line[end[k]] && !s->loose[end[k]]) {
      s->loose[end[k]] = 1;
      any = true;
    }
  }
  return any;
}

/* Intervals to which it is due that the whole is worse: their marks, or the
 * lines beside them.  ret whether there are any */
static bool mark_worst(struct search *s, bool lines) {
  const size_t n = s->data->n;
  double most = 0;
  bool any = false;
  for (size_t i = 0; i < n; i++) {
    most = fmax(most, excess(s, i));
  }
  for (size_t i = 0; i < n; i++) {
    if (!(excess(s, i) < EXCESS * most)) {
      s->mark[i] |= !lines;
      any |= !lines || loosen(s, i);
    }
  }
  return any;
}

/* Energy times length of all parts; NaN if one has no solution. */
static double measure(struct search *s, const struct ph_g2_parts *parts) {
  struct bent sum = {0, 0};
  bool solved = true;
  memset(s->line, 0, s->data->points_n);
  for (size_t i = 0; i < parts->n; i++) {
    solved &= parts->part[i].solved;
    if (parts->part[i].solved) {
      measure_part(s, &parts->part[i]);
    }
  }
  for (size_t i = 0; i < s->data->n; i++) {
    add(&sum, s->here[i]);
  }
  return solved ? sum.energy * sum.length : (double)NAN;
}

/* Whether that is too large. */
static bool is_worse(const struct search *s, double product) {
  return !(product <= WORSE * s->pairs.energy * s->pairs.length);
}

/* What gets pairs after this round.  ret whether anything does */
static bool mark(struct search *s, const struct ph_g2_parts *parts) {
  const double product = measure(s, parts);
  for (size_t i = 0; isnan(product) && i < parts->n; i++) {
    if (!parts->part[i].solved) {
      mark_failed(s, &parts->part[i]);
    }
  }
  if (isnan(product)) {
    return true;
  }
  return is_worse(s, product) && mark_worst(s, false);
}

/* How far an interval is behind the one that parts begin with. */
static size_t behind(const struct search *s, size_t i) {
  return i >= s->start ? i - s->start : i + s->data->n - s->start;
}

/* How many parts there are by the marks. */
static size_t count_parts(const struct search *s) {
  const size_t n = s->data->n;
  size_t parts = 0;
  for (size_t i = 0; i < n; i++) {
    const size_t k = around(s, s->start + i);
    parts += i == 0 || s->mark[k] || s->mark[around(s, s->start + i - 1)];
  }
  return parts;
}

/* Parts by the marks; those that were there are taken over.  Those of closed
 * data begin with a pair, as the data may begin anywhere. */
static enum ph_status cut(struct search *s, struct ph_g2_parts *parts) {
  const size_t n = s->data->n;
  struct ph_g2_parts next = {.n = 0};
  size_t old = 0;
  while (s->data->closed && !s->mark[s->start]) {
    s->start++; /* one is marked */
  }
  next.part = ph_arena_array(s->arena, count_parts(s), sizeof *next.part);
  if (!next.part) {
    return ph_fail_memory(s->diag);
  }
  for (size_t i = 0; i < n;) {
    const size_t first = around(s, s->start + i);
    const bool pair = s->mark[first];
    size_t end = i + 1;
    struct ph_g2_part *part = &next.part[next.n++];
    while (!pair && end < n && !s->mark[around(s, s->start + end)]) {
      end++;
    }
    for (; old < parts->n && behind(s, parts->part[old].first) < i; old++) {
    }
    *part = (struct ph_g2_part){
        .first = first, .n = end - i, .pair = pair, .solved = pair};
    if (old < parts->n && parts->part[old].first == first &&
        parts->part[old].n == part->n && parts->part[old].pair == part->pair) {
      *part = parts->part[old];
    } else if (solve_part(s, part, false) != PH_OK) {
      return s->diag->status;
    }
    i = end;
  }
  *parts = next;
  return PH_OK;
}

/* All as one part, which may leave lines where it is worse beside them, if that
 * is enough.  ret PH_OK | PH_E_NO_MEMORY */
static enum ph_status leave_lines(struct search *s, struct ph_g2_parts *parts) {
  const struct ph_g2_part strict = parts->part[0];
  double product = measure(s, parts), before = HUGE_VAL;
  enum ph_status status = PH_OK;
  for (size_t round = 0;
       round < ROUNDS_MAX && status == PH_OK && is_worse(s, product) &&
       product < before && mark_worst(s, true);
       round++) {
    before = product;
    status = solve_part(s, &parts->part[0], true);
    product = measure(s, parts);
  }
  if (is_worse(s, product)) {
    parts->part[0] = strict;
    memset(s->loose, 0, s->data->points_n);
  }
  return status == PH_E_NO_MEMORY ? status : PH_OK;
}

/* Memory for what intervals are; while parts are solved there is none. */
static enum ph_status begin_round(struct search *s) {
  const size_t n = s->data->n;
  s->here = ph_arena_array(&s->round, n, sizeof *s->here);
  if (!s->here) {
    return ph_fail_memory(s->diag);
  }
  memset(s->here, 0, n * sizeof *s->here);
  return PH_OK;
}

/* With pairs where they are needed. */
static enum ph_status improve(struct search *s, struct ph_g2_parts *parts) {
  const size_t n = s->data->n;
  enum ph_status status;
  s->pair = ph_arena_array(&s->work, n, sizeof *s->pair);
  s->mark = ph_arena_array(&s->work, n, 1);
  s->line = ph_arena_array(&s->work, s->data->points_n, 1);
  if (!s->pair || !s->mark || !s->line) {
    return ph_fail_memory(s->diag);
  }
  memset(s->mark, 0, n);
  if (!measure_pairs(s)) {
    return parts->part[0].solved ? PH_OK : s->diag->status;
  }
  status = begin_round(s);
  if (status == PH_OK && parts->part[0].solved) {
    status = leave_lines(s, parts);
  }
  for (size_t round = 0; status == PH_OK && mark(s, parts); round++) {
    if (round == ROUNDS_MAX) {
      memset(s->mark, 1, n);
    }
    ph_arena_free(&s->round);
    status = cut(s, parts);
    if (status == PH_OK) {
      status = begin_round(s);
    }
  }
  return status;
}

/* The parts; the first as if there were no other, before what the others
 * need is in memory. */
static enum ph_status find_parts(struct search *s,
                                 const struct ph_problem *problem,
                                 struct ph_g2_parts *parts) {
  const struct ph_tc_data *d = s->data;
  enum ph_status status = solve_part(s, &parts->part[0], true);
  struct ph_diag why;
  if (status != PH_OK && status != PH_E_NO_CONVERGENCE &&
      !memchr(s->hard, PH_G2_STUCK, d->n)) {
    return status;
  }
  if (ph_tc_data_of(problem, PH_TC_SPLINE, &s->work, &s->spline, &why) ==
      PH_OK) {
    status = improve(s, parts);
  } else if (why.status == PH_E_NO_MEMORY) { /* not that there is none */
    status = ph_fail_memory(s->diag);
  }
  return status;
}

enum ph_status ph_g2_parts_of(const struct ph_problem *problem,
                              const struct ph_tc_data *data,
                              struct ph_arena *arena, struct ph_arena *chains,
                              struct ph_g2_parts *parts, struct ph_diag *diag) {
  struct search s = {
      .data = data,
      .may_add = !ph_value_is(&problem->field[PH_F_AUXILIARY], "never"),
      .rule = ph_value_is(&problem->field[PH_F_ENDS], "smooth") ? PH_G2_SMOOTH
                                                                : PH_G2_CIRCLE,
      .arena = arena,
      .chains = chains,
      .work = ph_arena_beside(arena),
      .round = ph_arena_beside(arena),
      .diag = diag};
  enum ph_status status;
  parts->n = 1;
  parts->part = ph_arena_array(arena, 1, sizeof *parts->part);
  s.loose = ph_arena_array(arena, data->points_n, 1);
  s.hard = ph_arena_array(arena, data->n, 1);
  if (!parts->part || !s.loose || !s.hard) {
    return ph_fail_memory(diag);
  }
  memset(s.loose, 0, data->points_n);
  memset(s.hard, 0, data->n);
  parts->part[0] = (struct ph_g2_part){.n = data->n};
  status = find_parts(&s, problem, parts);
  ph_arena_free(&s.work);
  ph_arena_free(&s.round);
  return status;
}
