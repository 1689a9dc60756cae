/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Samples: the arrays, and the walk along a whole curve (see sample.h). */
#include "curve/sample/sample.h"

#include "base/sum.h"
#include "base/team.h"
#include "curve/kind/kind.h"
#include "curve/offset/gap.h"
#include "curve/sample/chord.h"
#include "curve/sample/frame.h"
#include "curve/sample/inversion.h"

#include <float.h>
#include <string.h>

/* Places that are nearer to a joint than this of the length so far are at it:
 * whether they are before or after must not be left to rounding. */
static const double AT_JOINT = 4 * DBL_EPSILON;
/* Arrays grow to this times what is needed, at most. */
static const double GROWTH = 8;
/* A last interval is no shorter than this, of the spacing. */
static const double LAST = 1e-9;
/* So many samples are computed together. */
enum { GROUP = 16 };
/* So many segments a thread walks along at a time. */
enum { PART = 128 };

/* ---- the walk ------------------------------------------------------------ */

/* Along a curve, one segment after the other. */
struct walk {
  const struct ph_sample_rules *rules;
  struct ph_sampler sampler;
  struct ph_framing framing;
  struct ph_chords chords;
  size_t cusp, gap; /* the next ones of the offset */
  size_t first;     /* sample of the connected part */
  bool begins;      /* the segment begins it */
  size_t step;      /* the next place is at so many times the spacing, or the
                       one of this index */
  struct ph_samples *samples;
  double u[GROUP]; /* of samples that are to be computed */
  size_t waiting;  /* so many of them, all of the segment */
  size_t most, room;
  struct ph_sum start; /* length before the segment */
  bool shared; /* the arrays, which have room, with other parts of the walk */
  struct ph_diag *diag;
};

/* The offset that is walked along as a whole, with its cusps and gaps; or
 * NULL. */
static const struct ph_offset *whole_of(const struct walk *walk) {
  return walk->sampler.loop ? NULL : walk->sampler.offset;
}

static enum ph_status too_many(const struct walk *walk, double wanted) {
  const struct ph_sample_rules *rules = walk->rules;
  return rules->how == PH_SAMPLE_SPACING
             ? ph_fail(walk->diag, PH_E_LIMIT, NULL,
                       "samples %g apart would be %.6g or more, above the %zu "
                       "of --max-samples",
                       rules->spacing, wanted, walk->most)
             : ph_fail(walk->diag, PH_E_LIMIT, NULL,
                       "the samples would be %.6g, above the %zu of "
                       "--max-samples",
                       wanted, walk->most);
}

/* Room for more samples. */
struct growth {
  struct ph_arena *arena;
  size_t n, room;
  bool memory; /* is exhausted */
};

static void *grown(struct growth *growth, bool wanted, const void *column,
                   size_t size) {
  void *larger =
      wanted ? ph_arena_array(growth->arena, growth->room, size) : NULL;
  growth->memory |= wanted && !larger;
  if (larger && growth->n > 0) {
    memcpy(larger, column, growth->n * size);
  }
  return larger;
}

/* Arrays for so many samples; those that there are stay. */
static enum ph_status move_to(struct walk *walk, size_t room) {
  const struct ph_curve *curve = walk->sampler.curve;
  const size_t number = sizeof(double), vector = curve->dimension * number;
  const bool sphere = ph_kind_of(curve)->on_sphere;
  const bool frame = walk->framing.frame != PH_FRAME_NONE;
  struct ph_samples *s = walk->samples;
  struct growth g = {walk->sampler.arena, s->n, room, false};
  s->segment = grown(&g, true, s->segment, sizeof *s->segment);
  s->t = grown(&g, true, s->t, number);
  s->s = grown(&g, true, s->s, number);
  s->point = grown(&g, true, s->point, vector);
  s->tangent = grown(&g, true, s->tangent, vector);
  s->curvature = grown(&g, true, s->curvature, number);
  s->torsion = grown(&g, curve->dimension == 3 && !sphere, s->torsion, number);
  s->lonlat = grown(&g, sphere, s->lonlat, 2 * number);
  s->normal = grown(&g, frame, s->normal, 3 * number);
  s->binormal = grown(&g, frame, s->binormal, 3 * number);
  walk->room = room;
  return g.memory ? ph_fail_memory(walk->diag) : PH_OK;
}

/* Room for n samples more; if more is taken, for so many in all. */
static enum ph_status reserve(struct walk *walk, double n, double all) {
  const double needed = (double)walk->samples->n + n;
  if (!(needed <= (double)walk->most)) {
    return too_many(walk, needed);
  }
  if (walk->shared && needed > (double)walk->room) {
    return ph_fail(walk->diag, PH_E_INTERNAL, "samples",
                   "are more than there was room for");
  }
  return needed <= (double)walk->room
             ? PH_OK
             : move_to(walk,
                       (size_t)fmin(fmax(all, needed), (double)walk->most));
}

/* The same; if more is taken, it is for all segments, as if those to come were
 * as those before, but for no more than GROWTH times what is needed or, of an
 * offset at equal spacing, than the curve itself would have; and for no less
 * than twice what there was. */
static enum ph_status reserve_more(struct walk *walk, double n) {
  const double needed = (double)walk->samples->n + n;
  const double segments = (double)walk->sampler.n;
  double all = segments / (double)(walk->sampler.k + 1) * needed;
  double most = GROWTH * needed;
  if (walk->rules->how == PH_SAMPLE_SPACING) {
    most = fmax(most, walk->sampler.curve->length / walk->rules->spacing);
  }
  all = fmax(fmin(all, most), 2 * (double)walk->room);
  return reserve(walk, n, all);
}

/* The place of the curve that belongs to one of what is sampled. */
static void place_of(const struct walk *walk, double u, size_t *segment,
                     double *t) {
  const struct ph_sampler *sampler = &walk->sampler;
  const struct ph_curve *curve = sampler->curve;
  *segment = sampler->k;
  if (sampler->loop) {
    const struct ph_loop_piece *piece = &sampler->loop->pieces[sampler->k];
    const bool join = piece->segment == PH_NO_SEGMENT;
    const bool end = join && piece->join == curve->n;
    *segment = !join ? piece->segment : end ? curve->n - 1 : piece->join;
    u = !join
            ? piece->interval[0] + u * (piece->interval[1] - piece->interval[0])
            : end;
  }
  *t = u * ph_curve_range(curve, *segment);
}

static void put_sample(struct walk *walk, size_t i, double u,
                       const struct ph_sample *sample) {
  struct ph_samples *to = walk->samples;
  const size_t dimension = to->dimension;
  ph_vec3 normal, binormal;
  ph_vec3_put(sample->point, dimension, to->point + dimension * i);
  ph_vec3_put(sample->tangent, dimension, to->tangent + dimension * i);
  to->curvature[i] = sample->curvature;
  if (to->torsion) {
    to->torsion[i] = sample->torsion;
  }
  if (to->lonlat) {
    to->lonlat[2 * i] = sample->lonlat[0];
    to->lonlat[2 * i + 1] = sample->lonlat[1];
  }
  if (to->normal) {
    ph_framing_at(&walk->framing, u, sample, &normal, &binormal);
    ph_vec3_put(normal, 3, to->normal + 3 * i);
    ph_vec3_put(binormal, 3, to->binormal + 3 * i);
  }
}

/* As ph_sampler_at, to the last bit, at n places; where some are
 * computed at once, in less time.  out  samples[n] */
static void at_each(const struct ph_sampler *sampler, const double *u, size_t n,
                    struct ph_sample *samples) {
  if (sampler->ops->at_each) {
    sampler->ops->at_each(sampler, u, n, samples);
    return;
  }
  for (size_t i = 0; i < n; i++) {
    samples[i] = ph_sampler_at(sampler, u[i]);
  }
}

/* Computes the samples that wait, which are the last ones. */
static void settle(struct walk *walk) {
  const size_t n = walk->waiting, first = walk->samples->n - n;
  struct ph_sample sample[GROUP];
  at_each(&walk->sampler, walk->u, n, sample);
  for (size_t i = 0; i < n; i++) {
    put_sample(walk, first + i, walk->u[i], &sample[i]);
  }
  walk->waiting = 0;
}

/* Appends the sample at u of the segment, where there is room for it; it waits
 * for others of the segment. */
static void put(struct walk *walk, double u, double s) {
  struct ph_samples *to = walk->samples;
  const size_t i = to->n++;
  place_of(walk, u, &to->segment[i], &to->t[i]);
  to->s[i] = s;
  walk->u[walk->waiting++] = u;
  if (walk->waiting == GROUP) {
    settle(walk);
  }
}

/* The same, s being what is there. */
static void put_at(struct walk *walk, double u) {
  struct ph_sum s = walk->start;
  double speed;
  ph_sum_add(&s, ph_sampler_length(&walk->sampler, u, &speed));
  put(walk, u, ph_sum_value(&s));
}

/* ---- where --------------------------------------------------------------- */

static enum ph_status by_parameter(struct walk *walk) {
  const size_t n = walk->rules->n;
  for (size_t i = 0; i <= n; i++) {
    put_at(walk, (double)i / (double)n);
  }
  return PH_OK;
}

/* What is not before this is at a joint with so much before it. */
static double before_joint(double length) {
  return length - AT_JOINT * length;
}

/* At the start of a part, and at multiples of the spacing that are not all but
 * there. */
static enum ph_status by_spacing(struct walk *walk) {
  const struct ph_sampler *sampler = &walk->sampler;
  const double spacing = walk->rules->spacing;
  struct ph_sum after = walk->start;
  struct ph_inversion past = {.n = 0};
  enum ph_status status;
  double joint, s;
  ph_sum_add(&after, sampler->length);
  joint = AT_JOINT * ph_sum_value(&after);
  s = (double)walk->step * spacing;
  status = /* with both ends of a part */
      reserve_more(walk, fmax((ph_sum_value(&after) - s) / spacing, 0) + 3);
  if (status == PH_OK && walk->begins) {
    const double start = ph_sum_value(&walk->start);
    put(walk, 0, start);
    while (s <= start + fmax(LAST * spacing, joint)) {
      s = (double)++walk->step * spacing;
    }
  }
  while (status == PH_OK && s < before_joint(ph_sum_value(&after))) {
    double local = (s - walk->start.high) - walk->start.low;
    put(walk,
        ph_inversion_next(&past, sampler, local > joint ? local : 0, NULL), s);
    s = (double)++walk->step * spacing;
  }
  return status;
}

static enum ph_status by_chords(struct walk *walk) {
  const struct ph_offset *offset = whole_of(walk);
  const size_t n = offset ? offset->cusps.n : 0, first = walk->cusp;
  enum ph_status status;
  while (walk->cusp < n &&
         offset->cusps.at[walk->cusp].segment == walk->sampler.k) {
    walk->cusp++;
  }
  status =
      ph_chords_plan(&walk->chords, &walk->sampler, walk->rules->chord_error,
                     n ? offset->cusps.at + first : NULL, walk->cusp - first,
                     walk->most, walk->diag);
  if (status == PH_OK) {
    status = reserve_more(walk, (double)walk->chords.n + 1);
  }
  if (status == PH_OK && walk->begins) {
    put(walk, 0, ph_sum_value(&walk->start));
  }
  for (size_t i = 0; status == PH_OK && i < walk->chords.n; i++) {
    put_at(walk, walk->chords.u[i]);
  }
  return status;
}

/* A length that is all but at a joint is there. */
static enum ph_status by_lengths(struct walk *walk) {
  const struct ph_sampler *sampler = &walk->sampler;
  const struct ph_sample_rules *rules = walk->rules;
  const bool last = sampler->k + 1 == sampler->n;
  struct ph_sum after = walk->start;
  struct ph_inversion past = {.n = 0};
  double before;
  ph_sum_add(&after, sampler->length);
  before = before_joint(ph_sum_value(&after));
  for (; walk->step < rules->n && (last || rules->lengths[walk->step] < before);
       walk->step++) {
    const double s = rules->lengths[walk->step];
    const double local = (s - walk->start.high) - walk->start.low;
    put(walk,
        s < before
            ? ph_inversion_next(&past, sampler, local > 0 ? local : 0, NULL)
            : 1,
        s);
  }
  return PH_OK;
}

static enum ph_status by_places(struct walk *walk) {
  const struct ph_sample_rules *rules = walk->rules;
  while (walk->step < rules->n &&
         rules->places[walk->step].segment == walk->sampler.k) {
    put_at(walk, rules->places[walk->step++].u);
  }
  return PH_OK;
}

/* The end of a part, instead of places that are all but there. */
static void end(struct walk *walk) {
  const double spacing = walk->rules->spacing;
  const double length = ph_sum_value(&walk->start);
  struct ph_samples *s = walk->samples;
  while (s->n > walk->first + 1 && s->s[s->n - 1] > length - LAST * spacing) {
    s->n--;
  }
  put(walk, 1, length);
  settle(walk);
}

static enum ph_status enter(struct walk *walk, size_t k) {
  const struct ph_offset *offset = whole_of(walk);
  enum ph_status status;
  if (k > 0) {
    ph_framing_leave(&walk->framing);
  }
  status = ph_sampler_enter(&walk->sampler, k, walk->diag);
  walk->begins =
      (offset && ph_gaps_pass(&offset->gaps, k, &walk->gap)) || k == 0;
  walk->first = walk->begins ? walk->samples->n : walk->first;
  if (status == PH_OK && !isfinite(walk->sampler.length)) {
    status = ph_fail_at(walk->diag, PH_E_NO_CONVERGENCE, "segments", k,
                        "%s a length that was not found",
                        walk->sampler.offset ? "has an offset with" : "has");
  }
  return status == PH_OK ? ph_framing_enter(&walk->framing, walk->diag)
                         : status;
}

/* Whether the segment ends a part. */
static bool ends(const struct walk *walk) {
  const struct ph_offset *offset = whole_of(walk);
  size_t next = walk->gap;
  return walk->sampler.k + 1 == walk->sampler.n ||
         (offset && ph_gaps_pass(&offset->gaps, walk->sampler.k + 1, &next));
}

static enum ph_status (*const places[])(struct walk *) = {
    [PH_SAMPLE_PARAMETER] = by_parameter, [PH_SAMPLE_SPACING] = by_spacing,
    [PH_SAMPLE_CHORD] = by_chords,        [PH_SAMPLE_LENGTHS] = by_lengths,
    [PH_SAMPLE_PLACES] = by_places,
};

/* Along segments first to end - 1. */
static enum ph_status go(struct walk *walk, size_t first, size_t n) {
  enum ph_status status = PH_OK;
  for (size_t k = first; status == PH_OK && k < n; k++) {
    status = ph_arena_late(walk->sampler.arena) ? ph_fail_memory(walk->diag)
                                                : enter(walk, k);
    if (status == PH_OK) {
      status = places[walk->rules->how](walk);
      settle(walk);
      ph_sum_add(&walk->start, walk->sampler.length);
    }
    if (status == PH_OK && walk->rules->how == PH_SAMPLE_SPACING &&
        !walk->shared && ends(walk)) {
      end(walk);
    }
  }
  return status;
}

static enum ph_status begin(struct walk *walk, const struct ph_curve *curve,
                            const struct ph_offset *offset,
                            const struct ph_loop *loop,
                            struct ph_arena *arena) {
  const enum ph_frame frame = walk->samples->frame;
  enum ph_status status =
      loop ? ph_sampler_begin_loop(&walk->sampler, curve, offset, loop, arena,
                                   walk->diag)
           : ph_sampler_begin(&walk->sampler, curve, offset, arena, walk->diag);
  walk->chords.arena = arena;
  walk->sampler.framed = frame != PH_FRAME_NONE;
  return status == PH_OK ? ph_framing_begin(&walk->framing, &walk->sampler,
                                            frame, walk->diag)
                         : status;
}

/* Room for the samples, where their number is known. */
static enum ph_status begin_room(struct walk *walk) {
  const struct ph_sample_rules *rules = walk->rules;
  const struct ph_sampler *sampler = &walk->sampler;
  return rules->how == PH_SAMPLE_PARAMETER
             ? reserve(walk, (double)sampler->n * ((double)rules->n + 1), 0)
         : rules->how == PH_SAMPLE_LENGTHS || rules->how == PH_SAMPLE_PLACES
             ? reserve(walk, (double)rules->n, 0)
         : rules->how == PH_SAMPLE_SPACING && !sampler->offset
             ? reserve(walk, sampler->curve->length / rules->spacing + 4, 0)
             : PH_OK;
}

/* ---- by several threads -------------------------------------------------- */

/* A part of a long curve. */
struct part {
  struct ph_sum start;
  size_t step; /* places before it, */
  size_t n;    /* samples before it; when it is done, up to its end */
  struct ph_account account;
  enum ph_status status;
  struct ph_diag diag;
};

struct parts {
  const struct walk *walk; /* along the whole curve */
  struct part *part;
};

/* Whether it is known where a segment begins, and which samples it has, without
 * those before it. */
static bool is_shared(const struct walk *walk) {
  return !walk->sampler.offset && walk->rules->how != PH_SAMPLE_CHORD &&
         !ph_framing_goes_on(&walk->framing) && walk->sampler.n >= 2 * PART;
}

/* Whether a place comes before segment k, where so much is behind. */
static bool is_before(const struct ph_sample_rules *rules, size_t place,
                      size_t k, double start) {
  switch (rules->how) {
  case PH_SAMPLE_SPACING:
    return (double)place * rules->spacing < before_joint(start);
  case PH_SAMPLE_LENGTHS:
    return place < rules->n && rules->lengths[place] < before_joint(start);
  case PH_SAMPLE_PLACES:
    return place < rules->n && rules->places[place].segment < k;
  default:
    return place < k * (rules->n + 1);
  }
}

static void begin_parts(struct walk *walk, struct part *part) {
  const struct ph_sampler *sampler = &walk->sampler;
  for (size_t k = 0; k < sampler->n; k++) {
    if (k % PART == 0) {
      const double start = ph_sum_value(&walk->start);
      while (k > 0 && is_before(walk->rules, walk->step, k, start)) {
        walk->step++;
      }
      *part = (struct part){
          .start = walk->start, .step = walk->step, .n = walk->step};
      ph_account_begin(&part++->account, sampler->arena);
    }
    ph_sum_add(&walk->start, sampler->curve->lengths[k]);
  }
}

static bool go_part(void *context, size_t thread, size_t first, size_t n) {
  const struct parts *parts = context;
  struct part *part = &parts->part[first / PART];
  struct walk walk = *parts->walk;
  struct ph_samples samples = *walk.samples;
  (void)thread;
  samples.n = part->n;
  walk.samples = &samples;
  walk.start = part->start;
  walk.step = part->step;
  walk.shared = true;
  walk.diag = &part->diag;
  part->status =
      begin(&walk, walk.sampler.curve, NULL, NULL, &part->account.arena);
  if (part->status == PH_OK) {
    part->status = go(&walk, first, n);
  }
  part->n = samples.n;
  return ph_account_done(&part->account) && part->status == PH_OK;
}

/* What the last segment has besides; the first failure is that of the first
 * part that has one. */
static enum ph_status end_parts(struct walk *walk, struct part *part,
                                size_t parts_n) {
  const size_t last = walk->sampler.n - 1;
  enum ph_status status = PH_OK;
  for (size_t i = 0; i < parts_n; i++) {
    if (!ph_account_end(&part[i].account) && status == PH_OK) {
      status = ph_fail_memory(walk->diag);
    } else if (status == PH_OK && part[i].status != PH_OK) {
      status = part[i].status;
      *walk->diag = part[i].diag;
    }
    ph_arena_free(&part[i].account.arena);
  }
  walk->samples->n = part[parts_n - 1].n;
  if (status == PH_OK && walk->rules->how == PH_SAMPLE_SPACING) {
    status = ph_sampler_enter(&walk->sampler, last, walk->diag);
    if (status == PH_OK) {
      end(walk);
    }
  }
  return status;
}

static enum ph_status go_shared(struct walk *walk) {
  const size_t n = walk->sampler.n, parts_n = (n + PART - 1) / PART;
  struct parts parts = {
      walk, ph_arena_array(walk->sampler.arena, parts_n, sizeof *parts.part)};
  if (!parts.part) {
    return ph_fail_memory(walk->diag);
  }
  begin_parts(walk, parts.part);
  ph_team_share(walk->sampler.arena, n, 2 * PART, PART, go_part, &parts);
  return end_parts(walk, parts.part, parts_n);
}

/* ---- the interface ------------------------------------------------------- */

/* out  length  of what is sampled */
static enum ph_status
sample(const struct ph_curve *curve, const struct ph_offset *offset,
       const struct ph_loop *loop, const struct ph_sample_rules *rules,
       enum ph_frame frame, struct ph_arena *arena, struct ph_samples *samples,
       double *length, struct ph_diag *diag) {
  struct walk walk = {.rules = rules,
                      .samples = samples,
                      .most = rules->most ? rules->most : PH_SAMPLES_MAX,
                      .diag = diag};
  enum ph_status status;
  *samples = (struct ph_samples){.frame = frame, .dimension = curve->dimension};
  status = begin(&walk, curve, offset, loop, arena);
  if (status == PH_OK) {
    status = begin_room(&walk);
  }
  if (status == PH_OK) {
    status = is_shared(&walk) ? go_shared(&walk) : go(&walk, 0, walk.sampler.n);
  }
  *length = ph_sum_value(&walk.start);
  if (status == PH_OK &&
      !(isfinite(*length) &&
        ph_are_finite(samples->point, samples->n * samples->dimension))) {
    status = offset ? ph_fail(diag, PH_E_TOO_LARGE, NULL,
                              "the offset at distance %g exceeds the range of "
                              "a double",
                              offset->distance)
                    : ph_fail(diag, PH_E_TOO_LARGE, NULL,
                              "samples exceed the range of a double");
  }
  return status;
}

enum ph_status ph_sample_curve(const struct ph_curve *curve,
                               const struct ph_sample_rules *rules,
                               struct ph_arena *arena,
                               struct ph_samples *samples,
                               struct ph_diag *diag) {
  double length;
  return sample(curve, NULL, NULL, rules, rules->frame, arena, samples, &length,
                diag);
}

enum ph_status ph_sample_offset(const struct ph_curve *curve,
                                const struct ph_sample_rules *rules,
                                struct ph_arena *arena,
                                struct ph_offset *offset,
                                struct ph_diag *diag) {
  return sample(curve, offset, NULL, rules, PH_FRAME_NONE, arena,
                &offset->samples, &offset->length, diag);
}

enum ph_status ph_sample_loop(const struct ph_curve *curve,
                              const struct ph_sample_rules *rules,
                              const struct ph_offset *offset,
                              struct ph_loop *loop, struct ph_arena *arena,
                              struct ph_diag *diag) {
  double length;
  return sample(curve, offset, loop, rules, PH_FRAME_NONE, arena,
                &loop->samples, &length, diag);
}
