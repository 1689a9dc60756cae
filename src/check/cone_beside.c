/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Surfaces at a distance from general cones (see cone_general.h): r + D n,
 * whose derivative is r' + D n'.  With the second fundamental form, in which
 * rulings have nothing, n' is along d, by (r''.n) / (r'.d).
 */
#include "check/cone_general.h"

#include "check/data.h"

#include <float.h>

/* Of unit vectors and sums; what two tables may differ by, and the most places
 * of one. */
static const double UNIT = 64 * DBL_EPSILON, AGREE = 1e-13;
enum { ROUND = 16, PLACES_MIN = 32, PLACES_MAX = 1024 };

/* What is summed up along a strip: the development in the frame of its start,
 * arc length, angle of the rulings, and area. */
enum { X, Y, S, PHI, AREA, SUMS };

/* A strip of the surface, and what there is at equal distances of u. */
struct beside {
  struct ph_check_general *g;
  const struct ph_curve *curve;
  double distance, height[2];
  size_t n;
  double sum[PLACES_MAX + 1][SUMS];
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

/* A table of n steps. */
static void tabulate(struct beside *b, size_t n) {
  b->n = n;
  b->least = 1;
  for (size_t j = 0; j < SUMS; j++) {
    b->sum[0][j] = 0;
  }
  for (size_t i = 0; i < n; i++) {
    advance(b, (double)i / (double)n, ((double)i + 1) / (double)n, b->sum[i],
            b->sum[i + 1]);
  }
}

/* Tables until two agree. */
static void settle(struct beside *b) {
  double off = HUGE_VAL;
  tabulate(b, PLACES_MIN);
  while (!(off <= AGREE) && b->n < PLACES_MAX &&
         !ph_arena_late(b->g->v->scratch)) {
    double before[SUMS];
    for (size_t j = 0; j < SUMS; j++) {
      before[j] = b->sum[b->n][j];
    }
    tabulate(b, 2 * b->n);
    off = 0;
    for (size_t j = X; j <= S; j++) {
      off = ph_check_larger(off, fabs(b->sum[b->n][j] - before[j]));
    }
  }
}

static void sums_at(struct beside *b, double u, double sum[SUMS]) {
  const double n = (double)b->n;
  const size_t low = u < 1 ? (size_t)(u * n) : b->n - 1;
  advance(b, (double)low / n, u, b->sum[low], sum);
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
  double doubt, far; /* of directions; of what rounding moves */
};

static struct place place_at(struct beside *b, double u) {
  const struct ph_check_general *g = b->g;
  const struct ph_check *v = g->v;
  const struct ph_check_general_seen at = ph_check_general_place_at(g, u);
  const struct ph_arc2 *arc = &b->curve->surface.strips[g->k].development;
  const double *start = arc->samples[0].point;
  const double c = cos(arc->angle), s = sin(arc->angle);
  double sum[SUMS];
  struct place p = {at.f, 0, 0, 0, at.doubt, 0};
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
         (fabs(h) + fabs(b->distance)) * p->doubt + UNIT * b->sum[b->n][S];
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
                      ROUND * ph_check_unscaled(g->v, g->v->scale.rounding));
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

static void check_measure(struct beside *b, double length, double area) {
  struct ph_check *v = b->g->v;
  const struct ph_curve *c = b->curve;
  const double many = UNIT * (double)c->n;
  length = ph_check_unscaled(v, length);
  area = ph_check_unscaled(v, ph_check_unscaled(v, area));
  ph_check_number(v, PH_CHECK_LENGTH, ph_check_of(NULL, PH_CHECK_ONE, "length"),
                  c->length, length, length, many * length);
  if (area > 0 || c->surface.area > 0) {
    ph_check_number(v, PH_CHECK_LENGTH, ph_check_of(NULL, PH_CHECK_ONE, "area"),
                    c->surface.area, area, area, 1e-11 * area + many * area);
  }
}

static void check_parallel(struct beside *b, const struct ph_parallel *p) {
  struct ph_check_general *g = b->g;
  double length = 0, area = 0;
  size_t next = 0;
  b->curve = &p->curve;
  b->distance = ph_check_scaled(g->v, p->distance);
  for (size_t k = 0; k < p->curve.n && !ph_arena_late(g->v->scratch); k++) {
    ph_check_general_load(g, k);
    settle(b);
    check_frame(b);
    check_numbers(b);
    check_flat(b);
    next = check_samples(b, &p->grid, next);
    length += b->sum[b->n][S];
    area += b->sum[b->n][AREA];
  }
  if (next < p->grid.n && !ph_arena_late(g->v->scratch)) {
    ph_check_wrong(g->v, PH_CHECK_SAMPLE, ph_check_of("samples", next, "strip"),
                   "is none, or out of order");
  }
  check_measure(b, length, area);
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
