/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Where the arc length of a segment is s (see inversion.h).
 *
 * With f(u) = length(u) - s, f' the speed, Newton's method is kept in a bracket
 * of the root, which is halved where a step leaves it, or where two of them did
 * not halve |f|: the speed may vanish, at cusps and at ends at rest.
 *
 * After a step d from u, |f| <= max|f''| d^2 / 2.  If four times that, with
 * f'' from the speeds at u and at the place before, or 8 lengths if that is
 * more, is less than what is asked for, the step is taken without another look.
 */
#include "curve/sample/inversion.h"

enum { STEPS_MAX = 200 };

/* Of the length of the segment: half of what is promised. */
static const double NEAR = 5e-15;
static const double CURVED = 8;

/* A place where the length and the speed were computed. */
struct look {
  double u, speed;
};

struct search {
  const struct ph_sampler *sampler;
  double s;
  double low, high; /* the root is between */
  size_t steps;
};

/* What is left after a step d, if little is known but the speeds at two places;
 * `before` may be the same place. */
static double left_after(const struct search *search, struct look before,
                         struct look now, double d) {
  double apart = fabs(now.u - before.u), curved = CURVED;
  curved *= search->sampler->length;
  if (fabs(d) <= apart / 4) {
    curved = fmax(curved, fabs(now.speed - before.speed) / apart);
    return 2 * curved * d * d;
  }
  return (double)INFINITY;
}

/* From u, which is in (low, high); `before` is a place near by, or u itself. */
static struct look find(struct search *search, struct look before, double u) {
  const double near = NEAR * search->sampler->length;
  double last[2] = {(double)INFINITY, (double)INFINITY};
  struct look now = {u, 0};
  while (search->steps < STEPS_MAX) {
    double f, d, next;
    f = ph_sampler_length(search->sampler, now.u, &now.speed) - search->s;
    search->steps++;
    d = -f / now.speed;
    next = now.u + d;
    if (fabs(f) <= near) {
      now.u = next > search->low && next < search->high ? next : now.u;
      break;
    }
    *(f > 0 ? &search->high : &search->low) = now.u;
    if (next > search->low && next < search->high && fabs(f) <= last[1] / 2) {
      if (left_after(search, before, now, d) <= near) {
        now.speed += (now.speed - before.speed) / (now.u - before.u) * d;
        now.u = next;
        break;
      }
    } else {
      next = 0.5 * (search->low + search->high);
    }
    if (!(next > search->low && next < search->high)) {
      break; /* there is no double between */
    }
    last[1] = last[0];
    last[0] = fabs(f);
    before = now;
    now.u = next;
  }
  return now;
}

/* The place at s between two, where the length is s_low and that of the
 * segment, as if the speed were the same. */
static double between(const struct search *search, double s_low) {
  double part = (search->s - s_low) / (search->sampler->length - s_low);
  double u = search->low + (search->high - search->low) * part;
  return u > search->low && u < search->high
             ? u
             : 0.5 * (search->low + search->high);
}

/* ---- one after the other ------------------------------------------------- */

/* The guess for s: by Hermite's cubic through two places and du/ds there, or by
 * du/ds of one; any number where a speed is 0. */
static double guess(const struct ph_inversion *past, double s) {
  const double first = past->u[0] + (s - past->s[0]) / past->speed[0];
  const double step = past->s[0] - past->s[1];
  double t, m0, m1;
  if (past->n < 2) {
    return first;
  }
  t = 1 + (s - past->s[0]) / step; /* 0 at the older, 1 at the newer */
  m0 = step / past->speed[0];
  m1 = step / past->speed[1];
  return past->u[0] +
         (t - 1) *
             (t * t * m0 +
              (t - 1) * (t * m1 - (2 * t + 1) * (past->u[0] - past->u[1])));
}

/* The place found is the newest. */
static void remember(struct ph_inversion *past, double s, struct look at) {
  past->s[1] = past->s[0];
  past->u[1] = past->u[0];
  past->speed[1] = past->speed[0];
  past->s[0] = s;
  past->u[0] = at.u;
  past->speed[0] = at.speed;
  past->n = past->n ? 2 : 1;
}

double ph_inversion_next(struct ph_inversion *past,
                         const struct ph_sampler *sampler, double s,
                         size_t *steps) {
  struct search search = {sampler, s, 0, 1, 0};
  struct look before = {0, 0}, at = {s > 0 ? 1 : 0, 0};
  if (s > 0 && s < sampler->length) {
    if (past->n) {
      before.u = search.low = past->u[0];
      before.speed = past->speed[0];
      at.u = guess(past, s);
    }
    if (!past->n || !(at.u > search.low && at.u < 1)) {
      at.u = between(&search, past->n ? past->s[0] : 0);
    }
    at = find(&search, past->n ? before : at, at.u);
    remember(past, s, at);
  }
  if (steps) {
    *steps = search.steps;
  }
  return at.u;
}
