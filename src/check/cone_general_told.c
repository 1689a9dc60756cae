/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What records say of strips of general cones beside their frames and their
 * developments (see cone_general.h). */
#include "check/cone_general.h"

#include "check/panorama.h"
#include "kernel/pi.h"

#include <float.h>

/* Of unit vectors; what turns, and what areas may be off by. */
static const double UNIT = 64 * DBL_EPSILON, TURN = 1e-6, AREA = 1e-11;

/* Where the turn is looked at, of each strip; less than this, relative to phi,
 * is none; and less than that of the largest may be another sign. */
enum { PLACES = 512, RULINGS = 128 };
static const double NONE = 1e-9, WEAK = 1e-2;

/* ---- the turn ------------------------------------------------------------ */

/* What a strip turns by: the whole, either way, and to one side. */
struct turning {
  double whole, low, high, changes;
  bool clear; /* how often it changes is beyond doubt */
};

static void turn_at(const void *context, double u, double *value) {
  *value = ph_check_general_place_at(context, u).turn;
}

/* Where the turn changes its sign. */
static double change_between(const struct ph_check_general *g, double from,
                             double to) {
  enum { STEPS = 50 };
  const bool up = ph_check_general_place_at(g, to).turn > 0;
  for (int i = 0; i < STEPS; i++) {
    const double middle = from + (to - from) / 2;
    *((ph_check_general_place_at(g, middle).turn > 0) == up ? &to : &from) =
        middle;
  }
  return to;
}

/* The turn of a part that does not change its sign. */
static void turn_by(const struct ph_check_general *g, struct turning *t,
                    double from, double to, double *at) {
  const double by =
      ph_check_general_integral(g, turn_at, TURN / PLACES, from, to);
  *at += by;
  t->whole += fabs(by);
  t->low = ph_check_smaller(t->low, *at);
  t->high = ph_check_larger(t->high, *at);
}

static struct turning turning_of(const struct ph_check_general *g) {
  double turn[PLACES + 1], most = 0, at = 0, from = 0;
  struct turning t = {0, 0, 0, 0, true};
  size_t last = 0;
  for (size_t i = 0; i <= PLACES; i++) {
    const struct ph_check_general_seen p =
        ph_check_general_place_at(g, (double)i / PLACES);
    turn[i] = fabs(p.turn) > NONE * p.rate ? p.turn : 0;
    most = ph_check_larger(most, fabs(turn[i]));
  }
  for (size_t i = 1; i <= PLACES; i++) {
    last = fabs(turn[i - 1]) > 0 ? i - 1 : last; /* where there was some */
    if (turn[last] * turn[i] < 0) {
      const double cut =
          change_between(g, (double)last / PLACES, (double)i / PLACES);
      turn_by(g, &t, from, cut, &at);
      t.changes++;
      from = cut;
    } else if (i < PLACES) { /* it may touch 0, or cross it twice */
      const double here = fabs(turn[i]);
      t.clear =
          t.clear && (here > WEAK * most || here > fabs(turn[i - 1]) ||
                      here > fabs(turn[i + 1]) || turn[i] * turn[i + 1] < 0);
    }
  }
  turn_by(g, &t, from, 1, &at);
  return t;
}

/* Turn, inflections, and that the strip is no loop. */
void ph_check_general_turn(struct ph_check_general *g,
                           struct ph_check_general_totals *totals) {
  const struct turning t = turning_of(g);
  const double turn = ph_check_general_strip(g, g->k)->turn;
  ph_check_miss(g->v, PH_CHECK_FRAME, ph_check_general_where(g->k, "turn"),
                ph_check_larger(0, t.high - t.low - PH_PI), 1, TURN,
                "is a loop");
  if (!g->v->error) {
    ph_check_number(
        g->v, PH_CHECK_DIAGNOSTIC, ph_check_general_where(g->k, "turn"), turn,
        t.whole, 1 + t.whole,
        TURN * (1 + t.whole) + 4 * (ph_check_general_place_at(g, 0).doubt +
                                    ph_check_general_place_at(g, 1).doubt));
  }
  totals->inflections += t.changes;
  totals->clear = totals->clear && t.clear;
}

/* ---- what a record says besides ------------------------------------------ */

/* u where the arc length is a part of the whole. */
static double parameter_of(const struct ph_check_general *g, double part) {
  enum { STEPS = 50, NODES = PH_CHECK_NODES_ATPH };
  const struct ph_check *v = g->v;
  const double wanted = part * v->length[g->k];
  double u = part < 1 ? part : 1, low = 0, high = 1;
  for (int i = 0; i < STEPS; i++) {
    double sum = 0, next;
    ph_vec3 first;
    for (size_t j = 0; j < NODES; j++) {
      ph_check_jet(&g->s, u * v->fixed.node[j], &first, 1);
      sum += u * v->fixed.weight[j] * ph_vec3_abs(first);
    }
    *(sum > wanted ? &high : &low) = u;
    ph_check_jet(&g->s, u, &first, 1);
    next = u - (sum - wanted) / ph_vec3_abs(first);
    if (fabs(next - u) <= DBL_EPSILON) {
      break;
    }
    u = next > low && next < high ? next : low + (high - low) / 2;
  }
  return u;
}

static void check_diagnostic(struct ph_check *v, enum ph_diagnostic which,
                             double found) {
  if (ph_check_known(v, which)) {
    ph_check_number(
        v, PH_CHECK_DIAGNOSTIC,
        ph_check_of("diagnostics", PH_CHECK_ONE, ph_diagnostic_name(which)),
        v->diagnostics->value[which], found, 1, 0);
  }
}

/* |side rho + h| integrated over the height, times phi'. */
static void area_at(const void *context, double u, double *value) {
  const struct ph_check_general *g = context;
  const struct ph_check_general_seen at = ph_check_general_place_at(g, u);
  const double *height = g->curve->surface.height;
  const double a = g->side * at.rho + ph_check_scaled(g->v, height[0]);
  const double b = g->side * at.rho + ph_check_scaled(g->v, height[1]);
  *value =
      at.rate * (a * b >= 0 ? fabs(a + b) / 2 * (b - a) : (a * a + b * b) / 2);
}

/* What a height is from the vertex, at u. */
static double from_vertex(const struct ph_check_general *g, size_t edge,
                          double u) {
  return g->side * ph_check_general_place_at(g, u).rho +
         ph_check_scaled(g->v, g->curve->surface.height[edge]);
}

/* Where a height passes the vertex, between two places on both sides. */
static double passing(const struct ph_check_general *g, size_t edge,
                      double from, double to) {
  enum { STEPS = 50 };
  const bool up = from_vertex(g, edge, to) > 0;
  for (int i = 0; i < STEPS; i++) {
    const double middle = from + (to - from) / 2;
    *((from_vertex(g, edge, middle) > 0) == up ? &to : &from) = middle;
  }
  return to;
}

/* By how much the area of a strip may be off: a small part of it. */
static double area_tolerance(const struct ph_check_general *g) {
  enum { SOME = 16 };
  double sum = 0, value;
  for (size_t i = 0; i < SOME; i++) {
    area_at(g, ((double)i + 0.5) / SOME, &value);
    sum += value / SOME;
  }
  return AREA / 16 * sum;
}

/* Area and vertices within the height, of strip k, which is loaded: the area by
 * parts, which begin where a height passes the vertex. */
void ph_check_general_height(struct ph_check_general *g,
                             struct ph_check_general_totals *totals) {
  const double *height = g->curve->surface.height;
  double low = HUGE_VAL, high = -HUGE_VAL, from = 0, last[2] = {0, 0};
  const double tolerance = area_tolerance(g);
  if (!(fabs(height[0]) > 0) && !(fabs(height[1]) > 0)) {
    return;
  }
  for (size_t i = 0; i <= PLACES; i++) {
    const double u = (double)i / PLACES;
    double cut[2] = {1, 1};
    for (size_t j = 0; j < 2; j++) {
      const double h = from_vertex(g, j, u);
      if (h * last[j] < 0) {
        cut[j] = passing(g, j, u - 1.0 / PLACES, u);
      }
      last[j] = h;
      low = ph_check_smaller(low, h);
      high = ph_check_larger(high, h);
    }
    for (size_t j = cut[1] < cut[0], n = 0; n < 2; n++, j = !j) {
      if (cut[j] < 1) {
        totals->area +=
            ph_check_general_integral(g, area_at, tolerance, from, cut[j]);
        from = cut[j];
      }
    }
  }
  totals->inside += low <= 0 && high >= 0;
  totals->area += ph_check_general_integral(g, area_at, tolerance, from, 1);
}

static void check_sample(struct ph_check_general *g, const char *list, size_t i,
                         const struct ph_surface_sample *sample) {
  struct ph_check *v = g->v;
  const double part = ph_check_scaled(v, sample->s) / v->length[g->k];
  const double u = parameter_of(g, part), h = ph_check_scaled(v, sample->h);
  const struct ph_check_general_seen at = ph_check_general_place_at(g, u);
  struct ph_check_general_flat flat = ph_check_general_flat_at(g, &at, u);
  const double round =
      ph_check_general_flat_rounding(g, &flat, at.rho + fabs(h));
  const double arc = UNIT * v->length[g->k];
  const double moved = arc + fabs(h) * at.doubt;
  /* by how much u is uncertain: where the curve nearly stands still, more */
  const double off = ph_check_smaller(arc / ph_vec3_abs(at.jet[0]),
                                      sqrt(arc / ph_vec3_abs(at.jet[1])));
  flat.x -= h * sin(flat.angle);
  flat.y += h * cos(flat.angle);
  ph_check_miss(v, PH_CHECK_SAMPLE, ph_check_of(list, i, "point"),
                ph_check_apart(ph_check_vector(v, sample->point, 3),
                               ph_vec3_along(at.f.c, h, at.f.e)),
                v->scale.size, round + moved, "is off the surface");
  ph_check_miss(v, PH_CHECK_SAMPLE, ph_check_of(list, i, "normal"),
                ph_check_apart(ph_vec3_get(sample->normal, 3), at.f.n), 1,
                at.doubt + UNIT + (UNIT + off) * fabs(at.turn),
                "is not the normal");
  ph_check_miss(v, PH_CHECK_SAMPLE, ph_check_of(list, i, "flat"),
                ph_check_general_flat_distance(g, sample->flat, &flat),
                v->scale.size, round + moved,
                "is not the place in the development");
}

static void check_samples(struct ph_check_general *g,
                          const struct ph_surface_samples *grid) {
  for (size_t i = 0; i < grid->n && !ph_arena_late(g->v->scratch); i++) {
    if (grid->v[i].strip >= g->curve->n) {
      ph_check_wrong(g->v, PH_CHECK_SAMPLE, ph_check_of("samples", i, "strip"),
                     "is none");
      return;
    }
    if (i == 0 || grid->v[i].strip != g->k) {
      ph_check_general_load(g, grid->v[i].strip);
    }
    check_sample(g, "samples", i, &grid->v[i]);
  }
}

/* Points of the development, anywhere on the strips. */
static void check_located(struct ph_check_general *g,
                          const struct ph_located_list *list) {
  const struct ph_check_cone cone = {.v = g->v, .curve = g->curve};
  for (size_t i = 0; i < list->n && !ph_arena_late(g->v->scratch); i++) {
    if (!ph_check_cone_located(&cone, list, i)) {
      return;
    }
    ph_check_general_load(g, list->v[i].at.strip);
    check_sample(g, "located", i, &list->v[i].at);
  }
}

void ph_check_general_told(struct ph_check_general *g,
                           const struct ph_check_general_totals *totals) {
  struct ph_check *v = g->v;
  const double area = ph_check_unscaled(v, ph_check_unscaled(v, totals->area));
  static const enum ph_diagnostic f[] = {PH_D_F1, PH_D_F2, PH_D_F3};
  double shift = 0, sum[3] = {0, 0, 0};
  for (size_t k = 0; k < g->curve->n; k++) {
    const struct ph_strip *s = ph_check_general_strip(g, k);
    for (size_t j = 0; j < 3; j++) {
      sum[j] += s->fairness[j];
    }
    shift = ph_check_larger(
        shift, ph_check_larger(fabs(s->shift[0]), fabs(s->shift[1])));
  }
  for (size_t j = 0; j < 3; j++) {
    if (ph_check_known(v, f[j]) && isfinite(sum[j])) {
      ph_check_number(
          v, PH_CHECK_DIAGNOSTIC,
          ph_check_of("strips", PH_CHECK_ONE, ph_diagnostic_name(f[j])), sum[j],
          v->diagnostics->value[f[j]], sum[j], AREA * sum[j]);
    }
  }
  ph_check_number(v, PH_CHECK_DIAGNOSTIC, ph_check_of("strips", 0, "shift"),
                  shift, 0, 1, 0);
  if (area > 0 || g->curve->surface.area > 0) {
    ph_check_number(v, PH_CHECK_LENGTH, ph_check_of(NULL, PH_CHECK_ONE, "area"),
                    g->curve->surface.area, area, area,
                    (UNIT + AREA) * (double)g->curve->n * area);
  }
  if (totals->clear) {
    check_diagnostic(v, PH_D_INFLECTIONS, totals->inflections);
  }
  check_diagnostic(v, PH_D_SHIFT, 0);
  check_diagnostic(v, PH_D_VERTICES_INSIDE, totals->inside);
  ph_check_cone_folds(v, g->curve, totals->inside);
  ph_check_fairness(v);
  check_samples(g, &v->claim->grid);
  check_located(g, &v->claim->located);
  ph_check_general_beside(g);
}

/* ---- panoramas ----------------------------------------------------------- */

/* A strip that is looked at, and how its rulings have turned at equal steps. */
struct sheet {
  struct ph_check_general *g;
  double phi[RULINGS + 1];
};

static size_t load(void *context, size_t i) {
  struct sheet *sheet = context;
  ph_check_general_load(sheet->g, i);
  for (size_t j = 0; j <= RULINGS; j++) {
    const double u = (double)j / RULINGS, before = u - 1.0 / RULINGS;
    sheet->phi[j] =
        j ? sheet->phi[j - 1] + ph_check_general_phi(sheet->g, before, u) : 0;
  }
  return RULINGS;
}

static struct ph_check_ruling ruling_at(void *context, double u) {
  const struct sheet *sheet = context;
  struct ph_check_general *g = sheet->g;
  const size_t low = u < 1 ? (size_t)(u * RULINGS) : RULINGS - 1;
  const struct ph_quad *rule = &g->v->fixed;
  const struct ph_check_general_seen at = ph_check_general_place_at(g, u);
  struct ph_check_general_flat flat;
  g->u = (double)low / RULINGS;
  g->phi = sheet->phi[low];
  for (size_t i = 0; i < rule->n; i++) {
    const double step = u - (double)low / RULINGS;
    g->phi += step * rule->weight[i] *
              ph_check_general_place_at(g, (double)low / RULINGS +
                                               step * rule->node[i])
                  .rate;
  }
  g->u = u;
  flat = ph_check_general_flat_at(g, &at, u);
  return (struct ph_check_ruling){flat.x, flat.y, flat.angle, at.f.c, at.f.e};
}

enum ph_status ph_check_general_panorama(struct ph_check_general *g) {
  struct sheet context = {.g = g};
  const struct ph_check_sheet sheet = {&context, load, ruling_at};
  return ph_check_panorama(g->v, &sheet);
}
