/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Gaps of an offset: at every joint the places on either side are compared, by
 * what the control points say.  Samples that are to be joined by lines must
 * have both ends of each gap, at the same arc length.
 */
#include "check/checks.h"

/* A jump is a gap if it is more than this of the size of the curve, which is
 * that of its joints, and the distance together, which both sides of the claim
 * may see by a factor of 2. */
static const double LEAST = 1e-9;

/* Arc lengths on both sides of a gap, of the whole. */
static const double ROUND_LENGTH = 64 * DBL_EPSILON;

/* Places that are so near to an end of [0,1] are there. */
static const double ROUND_END = 4 * DBL_EPSILON;

struct context {
  struct ph_check *v;
  const struct ph_offset *o;
  struct ph_check_path *path;
  struct ph_check_segment *segment;
  double size;   /* of joints and the distance together */
  size_t gap;    /* of those listed, the next one */
  size_t sample; /* the first one on the segment or later */
};

static void wrong(const struct context *c, enum ph_check_id check,
                  const char *list, size_t i, const char *what) {
  ph_check_wrong(c->v, check, ph_check_of(list, i, NULL), what);
}

/* ---- the list ----------------------------------------------------------- */

/* Whether the list is one of joints, in order. */
static bool is_list(const struct context *c) {
  const struct ph_gaps *gaps = &c->o->gaps;
  for (size_t i = 0; i < gaps->n; i++) {
    if (gaps->before[i] >= c->v->curve->n ||
        (gaps->before[i] == 0 && !c->v->curve->closed) ||
        (i > 0 && gaps->before[i] <= gaps->before[i - 1])) {
      wrong(c, PH_CHECK_OFFSET, "gaps", i, "is no joint after the last one");
      return false;
    }
  }
  return true;
}

static struct ph_check_local at_end(struct context *c, size_t k, double u) {
  ph_check_load(c->v, k, c->segment);
  return ph_check_local_at(c->path, u);
}

/* The jump before segment k against whether it is listed; whether it is.  At
 * rest there may be no direction, and so no place beside it. */
static bool check_jump(struct context *c, size_t k) {
  struct ph_check *v = c->v;
  const size_t n = v->curve->n;
  const double size = c->size;
  const struct ph_check_local a = at_end(c, (k + n - 1) % n, 1);
  const struct ph_check_local b = at_end(c, k, 0);
  const double jump = ph_check_apart(a.point, b.point);
  const double error = a.point_error + b.point_error;
  const bool listed = c->gap < c->o->gaps.n && c->o->gaps.before[c->gap] == k;
  if (!isfinite(jump + error)) {
    return listed;
  }
  if (!listed) {
    ph_check_miss(v, PH_CHECK_OFFSET, ph_check_of("gaps", PH_CHECK_ONE, NULL),
                  jump, size, 2 * LEAST * size + error,
                  "do not list a jump of the offset");
  } else if (!(jump + error >= 0.5 * LEAST * size)) {
    wrong(c, PH_CHECK_OFFSET, "gaps", c->gap, "is where the offset goes on");
  }
  return listed;
}

/* ---- samples ------------------------------------------------------------ */

/* Whether sample i is at an end of segment k. */
static bool is_at(const struct context *c, size_t i, size_t k, double u) {
  const struct ph_samples *s = &c->o->samples;
  const double *alpha = c->v->curve->preimage.alpha;
  return i < s->n && s->segment[i] == k &&
         fabs(s->t[i] / (alpha ? alpha[k] : 1) - u) <= ROUND_END;
}

/* Both ends of the gap before segment k; that of a closed curve has them at the
 * ends of all. */
static void check_ends(struct context *c, size_t k) {
  const struct ph_samples *s = &c->o->samples;
  const size_t n = c->v->curve->n, last = s->n - 1;
  size_t i;
  while (c->sample < s->n && s->segment[c->sample] < k) {
    c->sample++;
  }
  i = c->sample;
  if (!is_at(c, i, k, 0) ||
      !is_at(c, k > 0 ? i - 1 : last, (k + n - 1) % n, 1)) {
    wrong(c, PH_CHECK_SAMPLE, "samples", i < s->n ? i : last,
          "does not begin where the offset does after a gap, or the one before "
          "does not end there");
  } else if (k > 0 && !(fabs(s->s[i] - s->s[i - 1]) <=
                        ROUND_LENGTH * fabs(s->s[last]))) {
    wrong(c, PH_CHECK_SAMPLE, "samples", i,
          "has not the arc length of the other side of a gap");
  }
}

void ph_check_gaps(struct ph_check *v, const struct ph_offset *offset,
                   struct ph_check_path *path,
                   struct ph_check_segment *segment) {
  struct context c = {.v = v, .o = offset, .path = path, .segment = segment};
  c.size = ph_check_scaled(v, ph_curve_size(v->curve)) +
           fabs(ph_check_scaled(v, offset->distance));
  path->v = v;
  path->s = segment;
  if (!is_list(&c)) {
    return;
  }
  for (size_t k = v->curve->closed ? 0 : 1;
       k < v->curve->n && !ph_arena_late(v->scratch); k++) {
    if (check_jump(&c, k)) {
      c.gap++;
      if (offset->samples.n > 0) {
        check_ends(&c, k);
      }
    }
  }
}
