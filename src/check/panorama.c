/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Pictures of volumes on surfaces (see panorama.h). */
#include "check/panorama.h"

#include "check/data.h"

#include <string.h>

/* What is nearer than this to an edge, relative to coordinates, or to a side of
 * the volume, in spacings, may be on either side of it. */
static const double NEAR = 1e-9;

/* Of sums of values. */
static const double SUM = 1e-12;

/* What cannot be said without the volume. */
static const char *const VALUES[] = {"panorama.outside", "panorama.range",
                                     "panorama.mean", NULL};

enum { STEPS_MAX = 256 };

/* A point of the picture: nothing, or on the surface, in the volume or not;
 * what may not be there; and what may be this or something else. */
enum { NOTHING, VALUE, OUTSIDE, DOUBT = 4, EITHER = 8 };

struct picture {
  struct ph_check *v;
  const struct ph_check_sheet *sheet;
  const struct ph_panorama *p;
  const struct ph_surface *surface;
  double origin[2], step, near;
  unsigned char *seen; /* [height][width] */
  double *value;
  double low, high; /* of values that are in doubt */
  /* the strip that is looked at */
  size_t i, n;
  struct ph_check_ruling probe[STEPS_MAX + 1];
  double box[2][2];
};

/* ---- the volume ---------------------------------------------------------- */

static double voxel(const struct ph_volume *volume, const size_t at[3]) {
  return ph_volume_voxel(volume,
                         at[0] + volume->n[0] * (at[1] + volume->n[1] * at[2]));
}

/* By one axis after the other. */
static double between(const struct ph_volume *volume, const double x[3],
                      size_t axis, size_t at[3]) {
  const double last = (double)volume->n[axis] - 1;
  const double in = x[axis] < 0 ? 0 : x[axis] < last ? x[axis] : last;
  const size_t cell = in < last ? (size_t)in : volume->n[axis] - 2;
  double value[2];
  for (size_t j = 0; j < 2; j++) {
    at[axis] = cell + j;
    value[j] = axis ? between(volume, x, axis - 1, at) : voxel(volume, at);
  }
  return value[0] + (in - (double)cell) * (value[1] - value[0]);
}

/* What there is at a place of a ruling.  ret VALUE or OUTSIDE, and DOUBT */
static unsigned look(const struct picture *p, const struct ph_check_ruling *r,
                     double h, double *value) {
  const struct ph_volume *volume = p->p->volume;
  const ph_vec3 at = ph_vec3_along(r->c, h, r->e);
  const double point[] = {ph_check_unscaled(p->v, at.x),
                          ph_check_unscaled(p->v, at.y),
                          ph_check_unscaled(p->v, at.z)};
  unsigned found = VALUE;
  double x[3];
  size_t index[3];
  for (size_t a = 0; volume && a < 3; a++) {
    const double last = (double)volume->n[a] - 1;
    double out;
    x[a] = 0;
    for (size_t j = 0; j < 3; j++) {
      x[a] += volume->inverse[a][j] * (point[j] - volume->origin[j]);
    }
    out = ph_check_larger(-x[a], x[a] - last);
    found = !(out <= NEAR)      ? OUTSIDE | (found & DOUBT)
            : fabs(out) <= NEAR ? found | DOUBT
                                : found;
  }
  *value = volume && (found & VALUE) ? between(volume, x, 2, index) : 0;
  return found;
}

/* ---- a strip ------------------------------------------------------------- */

/* How far a point is ahead of a ruling, and where it is along it. */
static double ahead(const struct ph_check_ruling *r, const double at[2]) {
  return (at[0] - r->x) * cos(r->angle) + (at[1] - r->y) * sin(r->angle);
}

static double along(const struct ph_check_ruling *r, const double at[2]) {
  return (at[1] - r->y) * cos(r->angle) - (at[0] - r->x) * sin(r->angle);
}

/* A height as h of the strip, at u. */
static double height_at(const struct picture *p, size_t edge, double u) {
  const double *shift = p->surface->strips[p->i].shift;
  return ph_check_scaled(p->v, p->surface->height[edge] - shift[0] -
                                   u * (shift[1] - shift[0]));
}

static void load(struct picture *p, size_t i) {
  p->i = i;
  p->n = p->sheet->load(p->sheet->context, i);
  for (size_t j = 0; j < 2; j++) {
    p->box[0][j] = HUGE_VAL;
    p->box[1][j] = -HUGE_VAL;
  }
  for (size_t k = 0; k <= p->n; k++) {
    const double u = (double)k / (double)p->n;
    struct ph_check_ruling *r = &p->probe[k];
    *r = p->sheet->at(p->sheet->context, u);
    for (size_t edge = 0; edge < 2; edge++) {
      const double h = height_at(p, edge, u);
      const double at[] = {r->x - h * sin(r->angle), r->y + h * cos(r->angle)};
      for (size_t j = 0; j < 2; j++) {
        p->box[0][j] = ph_check_smaller(p->box[0][j], at[j]);
        p->box[1][j] = ph_check_larger(p->box[1][j], at[j]);
      }
    }
  }
}

/* By how much the strip may be beyond its box: an edge from probe to probe
 * leaves its chord by less than its length. */
static double margin(const struct picture *p) {
  const double x = p->box[1][0] - p->box[0][0], y = p->box[1][1] - p->box[0][1];
  return p->near + 8 * hypot(x, y) / (double)p->n;
}

/* Where the ruling goes through a point, between two of which one is ahead and
 * one is behind: false position, with the weight of an end that stays halved.
 */
static double meet(const struct picture *p, const double at[2], double from,
                   double to, double before, double after) {
  enum { STEPS = 100 };
  double u = from;
  int stays = 0;
  for (int i = 0; i < STEPS && to - from > DBL_EPSILON; i++) {
    struct ph_check_ruling r;
    double f;
    u = from + (to - from) * (before / (before - after));
    r = p->sheet->at(p->sheet->context, u);
    f = ahead(&r, at);
    if (!(fabs(f) > 4 * DBL_EPSILON * (fabs(at[0]) + fabs(at[1])))) {
      break;
    }
    if ((f > 0) == (before > 0)) {
      from = u;
      before = f;
      after *= stays > 0 ? 0.5 : 1;
      stays = 1;
    } else {
      to = u;
      after = f;
      before *= stays < 0 ? 0.5 : 1;
      stays = -1;
    }
  }
  return u;
}

/* What was found at a point of the picture: it counts if it is the first. */
static void put(struct picture *p, size_t pixel, unsigned found, double value) {
  unsigned char *seen = &p->seen[pixel];
  const double size = fabs(value) + fabs(p->value[pixel]);
  const unsigned either = found & DOUBT ? EITHER : 0;
  if (*seen == NOTHING) {
    *seen = (unsigned char)(found | either);
    p->value[pixel] = value;
  } else if (((*seen ^ found) & (VALUE | OUTSIDE)) ||
             !(fabs(value - p->value[pixel]) <= NEAR * size)) {
    *seen |= DOUBT | EITHER;
  } else {
    *seen |= (unsigned char)(DOUBT | either);
  }
  if ((*seen & DOUBT) && (found & VALUE)) {
    p->low = ph_check_smaller(p->low, value);
    p->high = ph_check_larger(p->high, value);
  }
}

/* A place on the strip, or next to an end of it. */
static void note(struct picture *p, size_t pixel, const double at[2], double u,
                 bool end) {
  const struct ph_check_ruling r = p->sheet->at(p->sheet->context, u);
  const double h = along(&r, at);
  const double low = h - height_at(p, 0, u), high = height_at(p, 1, u) - h;
  double value;
  unsigned found;
  if (!(low >= -p->near && high >= -p->near)) {
    return;
  }
  found = look(p, &r, h, &value);
  put(p, pixel, found, value);
  if (end || low <= p->near || high <= p->near) {
    p->seen[pixel] |= DOUBT;
  }
}

static void find(struct picture *p, size_t pixel, const double at[2]) {
  const double n = (double)p->n;
  double before = ahead(&p->probe[0], at);
  if (fabs(before) <= p->near) {
    note(p, pixel, at, 0, true);
  }
  for (size_t k = 1; k <= p->n; k++) {
    const double after = ahead(&p->probe[k], at);
    if ((before > 0) != (after > 0)) {
      const double u =
          meet(p, at, ((double)k - 1) / n, (double)k / n, before, after);
      note(p, pixel, at, u,
           (k == 1 && fabs(ahead(&p->probe[0], at)) <= p->near) ||
               (k == p->n && fabs(after) <= p->near));
    }
    before = after;
  }
  if (fabs(before) <= p->near) {
    note(p, pixel, at, 1, true);
  }
}

static void look_at_strip(struct picture *p) {
  const double by = margin(p);
  for (size_t row = 0; row < p->p->height; row++) {
    const double y = p->origin[1] - (double)row * p->step;
    if (!(y >= p->box[0][1] - by && y <= p->box[1][1] + by)) {
      continue;
    }
    for (size_t column = 0; column < p->p->width; column++) {
      const double at[] = {p->origin[0] + (double)column * p->step, y};
      const size_t pixel = row * p->p->width + column;
      if (!(p->seen[pixel] & (VALUE | OUTSIDE)) && at[0] >= p->box[0][0] - by &&
          at[0] <= p->box[1][0] + by) {
        find(p, pixel, at);
      }
    }
  }
}

/* ---- the whole ----------------------------------------------------------- */

static struct ph_check_where in(const char *member) {
  return ph_check_of("panorama", PH_CHECK_ONE, member);
}

/* The development is in the picture, which is not much larger. */
static bool check_frame(struct picture *p) {
  const double right = p->origin[0] + (double)p->p->width * p->step;
  const double down = p->origin[1] - (double)p->p->height * p->step;
  double low[] = {HUGE_VAL, HUGE_VAL}, high[] = {-HUGE_VAL, -HUGE_VAL}, beyond;
  for (size_t i = 0; i < p->v->curve->n; i++) {
    load(p, i);
    for (size_t j = 0; j < 2; j++) {
      low[j] = ph_check_smaller(low[j], p->box[0][j]);
      high[j] = ph_check_larger(high[j], p->box[1][j]);
    }
  }
  beyond =
      ph_check_larger(ph_check_larger(p->origin[0] - low[0], high[0] - right),
                      ph_check_larger(high[1] - p->origin[1], down - low[1]));
  ph_check_miss(p->v, PH_CHECK_PANORAMA, in("origin"),
                ph_check_larger(beyond, 0), p->v->scale.size, p->near,
                "does not have the development in the picture");
  if (!(right - p->origin[0] <= 4 * (high[0] - low[0]) + 2 * p->step &&
        p->origin[1] - down <= 4 * (high[1] - low[1]) + 2 * p->step)) {
    ph_check_wrong(p->v, PH_CHECK_PANORAMA, in("width"),
                   "and height are much larger than the development");
    return false;
  }
  return true;
}

/* A number, and between which it is. */
static void check_between(struct picture *p, const char *member, double claimed,
                          double low, double high, double unit) {
  const double found = claimed < low ? low : claimed > high ? high : claimed;
  ph_check_number(p->v, PH_CHECK_PANORAMA, in(member), claimed, found, unit,
                  SUM * unit);
}

/* How many points there are, and of all values, of those beyond doubt. */
struct count {
  double values, outside, doubts, either; /* the first two beyond doubt */
  double sum, most, low, high;
};

static void add(struct count *count, const struct picture *p, size_t i) {
  const double value = p->value[i];
  count->values += (p->seen[i] & VALUE) != 0;
  count->outside += (p->seen[i] & OUTSIDE) != 0;
  if (p->seen[i] & VALUE) {
    count->sum += value;
    count->low = ph_check_smaller(count->low, value);
    count->high = ph_check_larger(count->high, value);
  }
}

/* If all that is in doubt is among the points that are claimed, it is no more,
 * if it is one thing. */
static struct count count_of(const struct picture *p) {
  const size_t n = p->p->width * p->p->height;
  struct count count = {.low = HUGE_VAL, .high = -HUGE_VAL};
  for (size_t i = 0; i < n; i++) {
    count.doubts += (p->seen[i] & DOUBT) != 0;
    count.either += (p->seen[i] & EITHER) != 0;
    if (p->seen[i] & VALUE) {
      count.most = ph_check_larger(count.most, fabs(p->value[i]));
    }
    if (!(p->seen[i] & DOUBT)) {
      add(&count, p, i);
    }
  }
  if (!(count.either > 0) &&
      p->p->points == (size_t)(count.values + count.outside + count.doubts)) {
    count.doubts = 0;
    for (size_t i = 0; i < n; i++) {
      if (p->seen[i] & DOUBT) {
        add(&count, p, i);
      }
    }
  }
  return count;
}

static void conclude(struct picture *p) {
  const struct count c = count_of(p);
  const double points = c.values + c.outside;
  const double low = c.doubts > 0 ? ph_check_smaller(c.low, p->low) : c.low;
  const double high = c.doubts > 0 ? ph_check_larger(c.high, p->high) : c.high;
  const double mean = c.sum / c.values, off = c.doubts * c.most / c.values;
  check_between(p, "points", (double)p->p->points, points, points + c.doubts,
                1);
  if (!p->p->volume) { /* then all are values, as it were */
    p->v->verdict->unchecked = VALUES;
    return;
  }
  check_between(p, "outside", (double)p->p->outside, c.outside,
                c.outside + c.doubts, 1);
  if (!(c.values > 0)) {
    return; /* nothing, or doubts alone */
  }
  check_between(p, "range", p->p->range[0], low, c.low, c.most);
  check_between(p, "range", p->p->range[1], c.high, high, c.most);
  check_between(p, "mean", p->p->mean, mean - off, mean + off, c.most);
}

enum ph_status ph_check_panorama(struct ph_check *v,
                                 const struct ph_check_sheet *sheet) {
  const struct ph_panorama *claim = &v->claim->panorama;
  struct picture p = {.v = v,
                      .sheet = sheet,
                      .p = claim,
                      .surface = &v->curve->surface,
                      .low = HUGE_VAL,
                      .high = -HUGE_VAL};
  size_t n;
  if (!claim->width || !claim->height || !ph_are_finite(claim->origin, 2) ||
      !(claim->resolution > 0) || claim->outside > claim->points) {
    if (claim->width || claim->height) {
      ph_check_wrong(v, PH_CHECK_PANORAMA, in(NULL), "is none");
    }
    return PH_OK;
  }
  p.step = ph_check_scaled(v, 1 / claim->resolution);
  for (size_t j = 0; j < 2; j++) {
    p.origin[j] = ph_check_scaled(v, claim->origin[j]);
  }
  p.near = NEAR * (v->scale.size + fabs(p.origin[0]) + fabs(p.origin[1]));
  if (!check_frame(&p)) {
    return PH_OK;
  }
  n = claim->width * claim->height;
  p.seen = ph_arena_array(v->scratch, n, sizeof *p.seen);
  p.value = ph_arena_array(v->scratch, n, sizeof *p.value);
  if (!p.seen || !p.value) {
    return ph_fail_memory(v->diag);
  }
  memset(p.seen, 0, n);
  for (size_t i = 0; i < v->curve->n && !ph_arena_late(v->scratch); i++) {
    load(&p, i);
    look_at_strip(&p);
  }
  if (ph_arena_late(v->scratch)) {
    return ph_fail_memory(v->diag);
  }
  conclude(&p);
  return PH_OK;
}
