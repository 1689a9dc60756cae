/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Surfaces at a distance from general cones (see cone_general.h): r + D n,
 * whose derivative is r' + D n'.  With the second fundamental form, in which
 * rulings have nothing, n' is along d, by (r''.n) / (r'.d).
 */
#include "check/cone_general.h"

#include "check/data.h"

#include <float.h>

/* Of unit vectors and sums; what the rule on a part and on its halves may
 * differ by; and the shortest part. */
static const double UNIT = 64 * DBL_EPSILON, AGREE = 1e-13, SHORTEST = 1e-12;
enum { ROUND = 16, COARSE = 16, PARTS_MAX = 2048 };

/* What is summed up along a strip: the development in the frame of its start,
 * arc length, angle of the rulings, and area. */
enum { X, Y, S, PHI, AREA, SUMS };

/* A strip of the surface, and what there is between its parts. */
struct beside {
  struct ph_check_general *g;
  const struct ph_curve *curve;
  double distance, height[2];
  size_t n;
  double u[PARTS_MAX + 1], sum[PARTS_MAX + 1][SUMS];
  double moved[PARTS_MAX + 1]; /* by what normals are in doubt, up to there */
  double least; /* of 1 - kn D within the height, where it was seen */
};

/* ---- sums ---------------------------------------------------------------- */

/* The derivative of the contact curve along d and along e. */
static void rates(struct beside *b, double u, double rate[2], double *across) {
  const struct ph_check_general *g = b->g;
  const struct ph_check_general_seen at = ph_check_general_place_at(g, u);
  const double along = ph_vec3_dot(at.jet[0], at.f.d);
  const double turn = ph_vec3_dot(at.jet[1], at.f.n) / along;
  const double by = b->distance * turn;
  const double doubt =
      fabs(b->distance / along) * ph_vec3_abs(at.jet[1]) * at.doubt;
  rate[0] = along - by;
  rate[1] = ph_vec3_dot(at.jet[0], at.f.e);
  b->least = ph_check_smaller(b->least, (rate[0] + doubt) / along);
  *across = 0;
  for (size_t j = 0; j < 2; j++) {
    const double there = along * (1 + g->side * b->height[j] / at.rho);
    *across += (there - by) / 2;
    b->least = ph_check_smaller(b->least, (there - by + doubt) / there);
  }
  *across *= b->height[1] - b->height[0];
}

static double phi_from(const struct beside *b, double from, double to) {
  const struct ph_quad *rule = &b->g->v->fixed;
  double sum = 0;
  for (size_t i = 0; i < rule->n; i++) {
    const double u = from + (to - from) * rule->node[i];
    sum +=
        rule->weight[i] * (to - from) * ph_check_general_place_at(b->g, u).rate;
  }
  return sum;
}

/* What there is at `to', from what there is at `from'. */
static void advance(struct beside *b, double from, double to,
                    const double before[SUMS], double sum[SUMS]) {
  const struct ph_quad *rule = &b->g->v->fixed;
  for (size_t j = 0; j < SUMS; j++) {
    sum[j] = before[j];
  }
  for (size_t i = 0; i < rule->n; i++) {
    const double u = from + (to - from) * rule->node[i];
    const double weight = (to - from) * rule->weight[i];
    const double angle = -b->g->side * (before[PHI] + phi_from(b, from, u));
    double rate[2], across;
    rates(b, u, rate, &across);
    sum[X] += weight * (rate[0] * cos(angle) - rate[1] * sin(angle));
    sum[Y] += weight * (rate[0] * sin(angle) + rate[1] * cos(angle));
    sum[S] += weight * hypot(rate[0], rate[1]);
    sum[AREA] += weight * across;
  }
  sum[PHI] += phi_from(b, from, to);
}

/* By how much a place may be off where normals are: as the contact curve is
 * r + D n, what n is wrong by moves it by D times that, and what that changes
 * by makes it longer or shorter.  Normals are the less certain, the slower the
 * directrix is. */
static double doubt_at(const struct beside *b, double u) {
  return fabs(b->distance) * ph_check_general_place_at(b->g, u).doubt;
}

/* The next part of the table, and its sums, up to u. */
static void add_part(struct beside *b, double u, const double sum[SUMS]) {
  const double before = doubt_at(b, b->u[b->n]);
  b->u[++b->n] = u;
  b->moved[b->n] = b->moved[b->n - 1] + fabs(doubt_at(b, u) - before);
  for (size_t j = 0; j < SUMS; j++) {
    b->sum[b->n][j] = sum[j];
  }
}

/* Parts as short as the rule needs them: near an end where the curve nearly
 * rests its direction, and the offset with it, turns within a part of some
 * millionths.  ret false: not so many suffice, or no time */
static bool settle(struct beside *b) {
  double step = 1.0 / COARSE;
  b->n = 0;
  b->least = 1;
  b->u[0] = 0;
  b->moved[0] = doubt_at(b, 0);
  for (size_t j = 0; j < SUMS; j++) {
    b->sum[0][j] = 0;
  }
  while (b->u[b->n] < 1) {
    const double from = b->u[b->n];
    const double to = from + step < 1 ? from + step : 1;
    const double middle = from + (to - from) / 2;
    double whole[SUMS], left[SUMS], right[SUMS], off = 0;
    if (b->n + 2 > PARTS_MAX || ph_arena_late(b->g->v->scratch)) {
      return false;
    }
    advance(b, from, to, b->sum[b->n], whole);
    advance(b, from, middle, b->sum[b->n], left);
    advance(b, middle, to, left, right);
    for (size_t j = X; j <= PHI; j++) {
      off = ph_check_larger(off, fabs(whole[j] - right[j]) -
                                     AGREE * (1 + fabs(right[j])));
    }
    if (off <= 0) {
      add_part(b, middle, left);
      add_part(b, to, right);
      step *= 2;
    } else {
      step = (to - from) / 2;
      if (!(step > SHORTEST)) {
        return false;
      }
    }
  }
  return true;
}

/* The part in which u is. */
static size_t part_at(const struct beside *b, double u) {
  size_t low = 0, high = b->n;
  while (high - low > 1) {
    const size_t middle = low + (high - low) / 2;
    *(b->u[middle] <= u ? &low : &high) = middle;
  }
  return low;
}

static void sums_at(struct beside *b, double u, double sum[SUMS]) {
  const size_t low = part_at(b, u);
  advance(b, b->u[low], u, b->sum[low], sum);
}

/* u where the arc length is s. */
static double parameter_of(struct beside *b, double s) {
  enum { STEPS = 60 };
  double low = 0, high = 1, u = s / b->sum[b->n][S];
  for (int i = 0; i < STEPS && high > low; i++) {
    double sum[SUMS], rate[2], across, next;
    u = u > low && u < high ? u : low + (high - low) / 2;
    sums_at(b, u, sum);
    rates(b, u, rate, &across);
    *(sum[S] > s ? &high : &low) = u;
    next = u - (sum[S] - s) / hypot(rate[0], rate[1]);
    if (fabs(next - u) <= DBL_EPSILON) {
      break;
    }
    u = next;
  }
  return ph_check_larger(0, ph_check_smaller(u, 1));
}

/* ---- places -------------------------------------------------------------- */

/* A place of the contact curve: its frame, and the same laid flat. */
struct place {
  struct ph_check_frame f;
  double x, y, angle;
  double doubt, moved; /* of directions; by what normals are in doubt */
  double far;          /* of what rounding moves */
};

static struct place place_at(struct beside *b, double u) {
  const struct ph_check_general *g = b->g;
  const struct ph_check *v = g->v;
  const struct ph_check_general_seen at = ph_check_general_place_at(g, u);
  const struct ph_arc2 *arc = &b->curve->surface.strips[g->k].development;
  const double *start = arc->samples[0].point;
  const double c = cos(arc->angle), s = sin(arc->angle);
  double sum[SUMS];
  struct place p = {at.f, 0, 0, 0, at.doubt, b->moved[part_at(b, u) + 1], 0};
  sums_at(b, u, sum);
  p.f.c = ph_vec3_along(p.f.c, b->distance, p.f.n);
  p.x = ph_check_scaled(v, start[0]) + c * sum[X] - s * sum[Y];
  p.y = ph_check_scaled(v, start[1]) + s * sum[X] + c * sum[Y];
  p.angle = arc->angle - g->side * sum[PHI];
  p.far = fabs(p.x) + fabs(p.y) + at.rho * (1 + fabs(p.angle));
  return p;
}

/* How far it may be off at h. */
static double allowed_at(const struct beside *b, const struct place *p,
                         double h) {
  const struct ph_check *v = b->g->v;
  return ROUND * (v->scale.rounding + DBL_EPSILON * (p->far + fabs(h))) +
         fabs(h) * p->doubt + p->moved + UNIT * b->sum[b->n][S];
}

static double flat_distance(const struct ph_check *v, const double point[2],
                            const struct place *p) {
  return hypot(ph_check_scaled(v, point[0]) - p->x,
               ph_check_scaled(v, point[1]) - p->y);
}

/* ---- strips -------------------------------------------------------------- */

static const struct ph_strip *strip_of(const struct beside *b) {
  return &b->curve->surface.strips[b->g->k];
}

static void check_frame(struct beside *b) {
  const struct ph_check_general *g = b->g;
  const struct place start = place_at(b, 0);
  const struct ph_strip_frame *f = &strip_of(b)->frame;
  ph_check_miss(g->v, PH_CHECK_OFFSET, ph_check_general_where(g->k, "frame"),
                ph_check_apart(ph_check_vector(g->v, f->point, 3), start.f.c),
                g->v->scale.size, allowed_at(b, &start, 0),
                "is not at the distance");
  ph_check_miss(g->v, PH_CHECK_OFFSET, ph_check_general_where(g->k, "frame"),
                ph_check_larger(
                    ph_check_apart(ph_vec3_get(f->ruling, 3), start.f.e),
                    ph_check_larger(
                        ph_check_apart(ph_vec3_get(f->tangent, 3), start.f.d),
                        ph_check_apart(ph_vec3_get(f->normal, 3), start.f.n))),
                1, 4 * start.doubt + UNIT, "is not parallel");
}

static void check_numbers(struct beside *b) {
  const struct ph_check_general *g = b->g;
  const struct ph_strip *s = strip_of(b);
  const struct ph_strip *from = ph_check_general_strip(g, g->k);
  const double length = ph_check_unscaled(g->v, b->sum[b->n][S]);
  ph_check_number(g->v, PH_CHECK_LENGTH, ph_check_general_where(g->k, "length"),
                  s->length, length, length,
                  UNIT * length +
                      ph_check_unscaled(g->v, ROUND * g->v->scale.rounding +
                                                  b->moved[b->n]));
  ph_check_number(g->v, PH_CHECK_ISOMETRY,
                  ph_check_general_where(g->k, "development_angle"),
                  s->development_angle, b->sum[b->n][PHI], b->sum[b->n][PHI],
                  UNIT + 1e-12 * b->sum[b->n][PHI]);
  ph_check_number(g->v, PH_CHECK_DIAGNOSTIC,
                  ph_check_general_where(g->k, "turn"), s->turn, from->turn, 1,
                  0);
  ph_check_miss(g->v, PH_CHECK_OFFSET, ph_check_general_where(g->k, NULL),
                b->least > 0 ? 0 : 1 - b->least, 1, 0,
                "has no such surface: 1 - kn D is not above 0");
}

/* The development: its places, and where the next one begins. */
static void check_flat(struct beside *b) {
  const struct ph_check_general *g = b->g;
  const struct ph_arc2 *arc = &strip_of(b)->development;
  const double alpha = *strip_of(b)->alpha;
  struct place p;
  for (size_t i = 0; i < arc->samples_n; i++) {
    const double u = arc->samples[i].t / alpha;
    const double before = i ? arc->samples[i - 1].t / alpha : -1;
    if (!(u > before && u <= 1) || (i == 0 && u > 0) ||
        (i + 1 == arc->samples_n && u < 1)) {
      ph_check_wrong(g->v, PH_CHECK_SHAPE,
                     ph_check_general_where(g->k, "development"),
                     "does not lead from 0 to alpha, in order");
      return;
    }
    p = place_at(b, u);
    ph_check_miss(
        g->v, PH_CHECK_ISOMETRY, ph_check_general_where(g->k, "development"),
        flat_distance(g->v, arc->samples[i].point, &p), g->v->scale.size,
        allowed_at(b, &p, 0), "is off the contact curve laid flat");
  }
  p = place_at(b, 1);
  if (g->k + 1 < b->curve->n) {
    const struct ph_arc2 *next = &strip_of(b)[1].development;
    ph_check_miss(
        g->v, PH_CHECK_ISOMETRY, ph_check_general_where(g->k, "development"),
        flat_distance(g->v, next->samples[0].point, &p), g->v->scale.size,
        allowed_at(b, &p, 0), "ends elsewhere than the next one begins");
    ph_check_miss(g->v, PH_CHECK_ISOMETRY,
                  ph_check_general_where(g->k, "development"),
                  fabs(next->angle - p.angle), 1, UNIT * (1 + fabs(p.angle)),
                  "ends in another direction than the next one begins");
  }
}

/* ---- samples ------------------------------------------------------------- */

static void check_sample(struct beside *b,
                         const struct ph_surface_sample *sample, size_t i,
                         const struct place *on) {
  struct ph_check *v = b->g->v;
  const double h = ph_check_scaled(v, sample->h);
  const double allowed = allowed_at(b, on, h);
  struct place p = *on;
  p.x -= h * sin(p.angle);
  p.y += h * cos(p.angle);
  ph_check_miss(v, PH_CHECK_SAMPLE, ph_check_of("samples", i, "point"),
                ph_check_apart(ph_check_vector(v, sample->point, 3),
                               ph_vec3_along(p.f.c, h, p.f.e)),
                v->scale.size, allowed, "is off the surface");
  ph_check_miss(v, PH_CHECK_SAMPLE, ph_check_of("samples", i, "normal"),
                ph_check_apart(ph_vec3_get(sample->normal, 3), p.f.n), 1,
                4 * p.doubt + UNIT * (1 + b->sum[b->n][S]),
                "is not the normal");
  ph_check_miss(v, PH_CHECK_SAMPLE, ph_check_of("samples", i, "flat"),
                flat_distance(v, sample->flat, &p), v->scale.size, allowed,
                "is not the place in the development");
}

/* The samples of strip k, from number i on.  ret the number behind them */
static size_t check_samples(struct beside *b,
                            const struct ph_surface_samples *grid, size_t i) {
  struct place p = {.x = 0};
  for (size_t first = i; i < grid->n && grid->v[i].strip == b->g->k; i++) {
    if (ph_arena_late(b->g->v->scratch)) {
      break;
    }
    if (i == first || grid->v[i].s > grid->v[i - 1].s ||
        grid->v[i].s < grid->v[i - 1].s) {
      p = place_at(b, parameter_of(b, ph_check_scaled(b->g->v, grid->v[i].s)));
    }
    check_sample(b, &grid->v[i], i, &p);
  }
  return i;
}

/* ---- the whole ----------------------------------------------------------- */

/* Why a strip is none, or NULL. */
static const char *fault_of(const struct ph_strip *s,
                            const struct ph_strip *from) {
  const double numbers[] = {s->length, s->development_angle, s->turn,
                            s->development.angle};
  if (s->method != from->method || !s->alpha || s->control_points ||
      s->pair != from->pair || fabs(*s->alpha - *from->alpha) > 0) {
    return "is not one beside that of the surface";
  }
  for (size_t i = 0; i < s->development.samples_n; i++) {
    if (!ph_are_finite(&s->development.samples[i].t, 1) ||
        !ph_are_finite(s->development.samples[i].point, 2)) {
      return "holds what is not finite";
    }
  }
  return s->development.samples_n && ph_are_finite(numbers, 4) &&
                 ph_are_finite(s->frame.point, 3) &&
                 ph_are_finite(s->frame.ruling, 3) &&
                 ph_are_finite(s->frame.tangent, 3) &&
                 ph_are_finite(s->frame.normal, 3)
             ? NULL
             : "holds what is not finite";
}

static bool is_one(struct ph_check_general *g, const struct ph_parallel *p) {
  const struct ph_curve *c = &p->curve;
  if (c->n != g->curve->n || !c->surface.strips || !isfinite(c->length) ||
      !isfinite(c->surface.area)) {
    ph_check_wrong(g->v, PH_CHECK_OFFSET,
                   ph_check_of("strips", PH_CHECK_ONE, NULL),
                   "are not as many as those of the surface");
    return false;
  }
  for (size_t k = 0; k < c->n; k++) {
    const char *fault =
        fault_of(&c->surface.strips[k], ph_check_general_strip(g, k));
    if (fault) {
      ph_check_wrong(g->v, PH_CHECK_SHAPE, ph_check_general_where(k, NULL),
                     fault);
      return false;
    }
  }
  return true;
}

/* The whole: the sum of lengths that were checked strip by strip; and the area,
 * of which so much is in doubt. */
static void check_measure(struct beside *b, double length, double area,
                          double moved) {
  struct ph_check *v = b->g->v;
  const struct ph_curve *c = b->curve;
  const double many = UNIT * (double)c->n;
  const double wide = fabs(b->height[1] - b->height[0]);
  moved = ph_check_unscaled(v, ph_check_unscaled(v, wide * moved));
  area = ph_check_unscaled(v, ph_check_unscaled(v, area));
  ph_check_number(v, PH_CHECK_LENGTH, ph_check_of(NULL, PH_CHECK_ONE, "length"),
                  c->length, length, length, many * length);
  if (area > 0 || c->surface.area > 0) {
    ph_check_number(v, PH_CHECK_LENGTH, ph_check_of(NULL, PH_CHECK_ONE, "area"),
                    c->surface.area, area, area,
                    1e-11 * area + many * area + moved);
  }
}

static void check_parallel(struct beside *b, const struct ph_parallel *p) {
  struct ph_check_general *g = b->g;
  double length = 0, area = 0, moved = 0;
  size_t next = 0;
  b->curve = &p->curve;
  b->distance = ph_check_scaled(g->v, p->distance);
  for (size_t k = 0; k < p->curve.n && !ph_arena_late(g->v->scratch); k++) {
    ph_check_general_load(g, k);
    if (!settle(b)) {
      ph_check_wrong(g->v, PH_CHECK_OFFSET, ph_check_general_where(k, NULL),
                     "bends too sharply to be measured");
      return;
    }
    check_frame(b);
    check_numbers(b);
    check_flat(b);
    next = check_samples(b, &p->grid, next);
    length += strip_of(b)->length;
    moved += b->moved[b->n];
    area += b->sum[b->n][AREA];
  }
  if (next < p->grid.n && !ph_arena_late(g->v->scratch)) {
    ph_check_wrong(g->v, PH_CHECK_SAMPLE, ph_check_of("samples", next, "strip"),
                   "is none, or out of order");
  }
  check_measure(b, length, area, moved);
}

void ph_check_general_beside(struct ph_check_general *g) {
  struct ph_check *v = g->v;
  const struct ph_result *claim = v->claim;
  const double *height = g->curve->surface.height;
  struct beside b;
  b.g = g;
  b.height[0] = ph_check_scaled(v, height[0]);
  b.height[1] = ph_check_scaled(v, height[1]);
  for (size_t i = 0; i < claim->parallels_n; i++) {
    ph_check_prefix(v, "offsets", i);
    if (is_one(g, &claim->parallels[i])) {
      check_parallel(&b, &claim->parallels[i]);
    }
  }
  ph_check_prefix(v, NULL, 0);
}
