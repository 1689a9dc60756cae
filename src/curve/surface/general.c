/* SPDX-License-Identifier: GPL-3.0-or-later */
/* General strips (see general.h). */
#include "curve/surface/general.h"

#include <string.h>

enum { NODES = 12, COARSE = 8, PARTS_MAX = 2048 };

/* What the rule on a part and those on its halves may differ by: of phi,
 * relative to all of it, and of the turn. */
static const double AGREE_PHI = 1e-12, AGREE_TURN = 1e-9;

/* A geodesic curvature of less than this is none. */
static const double FLAT = 1e-9;

/* Parts are no shorter than this. */
static const double SHORTEST = 1e-9;

/* The sine between a ruling and the tangent is not less than this. */
static const double ALONG = 1e-8;

/* ---- places -------------------------------------------------------------- */

struct ph_general_place ph_general_at(const struct ph_directrix *d, double u) {
  const struct ph_fast3_place at = ph_fast3_at(&d->fast, u);
  const struct ph_pow2 shrink = d->fast.shrink;
  const ph_quat a = ph_fast3_preimage(&at), b = ph_fast3_first(&at);
  const ph_vec3 away = ph_vec3_sub(ph_fast3_point(&d->fast, &at), d->vertex);
  const ph_vec3 w =
      ph_vec3_of(ph_pow2_apply(shrink, away.x), ph_pow2_apply(shrink, away.y),
                 ph_pow2_apply(shrink, away.z));
  const ph_vec3 first = ph_quat_i(a, a);
  const ph_vec3 second = ph_vec3_scale(2, ph_quat_i(a, b));
  const ph_vec3 across = ph_vec3_cross(w, first);
  const double rho = ph_vec3_abs(w), size = ph_vec3_abs(across);
  return (struct ph_general_place){w, first, rho, size / rho / rho,
                                   ph_vec3_triple(w, first, second) / size *
                                       (rho / size)};
}

/* ---- phi ----------------------------------------------------------------- */

struct part {
  double phi, turn;
};

/* The integrals over [from,to]. */
static struct part part_of(const struct ph_directrix *d, double from,
                           double to) {
  const double step = to - from;
  struct part sum = {0, 0};
  for (size_t i = 0; i < d->rule->n; i++) {
    const struct ph_general_place at =
        ph_general_at(d, from + step * d->rule->node[i]);
    sum.phi += step * d->rule->weight[i] * at.rate;
    sum.turn += step * d->rule->weight[i] * at.bend;
  }
  return sum;
}

double ph_general_phi(const struct ph_directrix *d, double u) {
  size_t low = 0, high = d->n;
  while (high - low > 1) {
    const size_t middle = (low + high) / 2;
    *(d->u[middle] <= u ? &low : &high) = middle;
  }
  return d->phi[low] + part_of(d, d->u[low], u).phi;
}

/* ---- preparation --------------------------------------------------------- */

/* Parts in the making. */
struct parts {
  size_t n;
  double u[PARTS_MAX + 1], phi[PARTS_MAX + 1];
};

/* Parts, from 0 to 1, as short as the rule needs them. */
static bool divide(struct ph_directrix *d, struct parts *parts) {
  double total = 0, step = 1.0 / COARSE, u = 0;
  for (size_t i = 0; i < COARSE; i++) {
    total += part_of(d, (double)i / COARSE, ((double)i + 1) / COARSE).phi;
  }
  parts->n = 0;
  parts->u[0] = parts->phi[0] = 0;
  while (u < 1) {
    const double to = u + step < 1 - SHORTEST ? u + step : 1;
    const double middle = u + (to - u) / 2;
    const struct part whole = part_of(d, u, to);
    const struct part left = part_of(d, u, middle);
    const struct part right = part_of(d, middle, to);
    const double off = whole.phi - left.phi - right.phi;
    const double turned = whole.turn - left.turn - right.turn;
    if (fabs(off) <= AGREE_PHI * total && fabs(turned) <= AGREE_TURN) {
      double *phi = parts->phi + parts->n, *at = parts->u + parts->n;
      if (parts->n + 2 > PARTS_MAX) {
        return false;
      }
      at[1] = middle;
      at[2] = u = to;
      phi[1] = phi[0] + left.phi;
      phi[2] = phi[1] + right.phi;
      parts->n += 2;
      step *= 2;
    } else {
      step = (to - u) / 2;
      if (!(step > SHORTEST)) {
        return false;
      }
    }
  }
  return true;
}

/* A place between two of which kg has different signs, where it changes it. */
static double change_between(const struct ph_directrix *d, double from,
                             double to, bool rises) {
  enum { STEPS = 52 };
  for (int i = 0; i < STEPS; i++) {
    const double middle = from + (to - from) / 2;
    *((ph_general_at(d, middle).bend > 0) == rises ? &to : &from) = middle;
  }
  return from;
}

/* How the tangents of the spherical image turn on the way. */
struct turning {
  double at, low, high; /* by so much, so far */
  double last;          /* the sign of kg, if it has been other than 0 */
};

static void turn_by(struct ph_directrix *d, struct turning *turning,
                    double from, double to) {
  const double by = part_of(d, from, to).turn;
  turning->at += by;
  turning->low = fmin(turning->low, turning->at);
  turning->high = fmax(turning->high, turning->at);
  d->turn += fabs(by);
}

static void follow_turns(struct ph_directrix *d) {
  struct turning turning = {0, 0, 0, 0};
  for (size_t i = 0; i < d->n; i++) {
    const double step = d->u[i + 1] - d->u[i];
    double from = d->u[i], before = from;
    for (size_t j = 0; j <= d->rule->n; j++) {
      const double u =
          j < d->rule->n ? d->u[i] + step * d->rule->node[j] : d->u[i + 1];
      const struct ph_general_place at = ph_general_at(d, u);
      const double bend = fabs(at.bend) > FLAT * at.rate ? at.bend : 0;
      d->near = fmin(d->near, at.rho);
      d->far = fmax(d->far, at.rho);
      if (bend * turning.last < 0) {
        const double cut = change_between(d, before, u, bend > 0);
        turn_by(d, &turning, from, cut);
        from = cut;
        d->bends++;
      }
      turning.last = bend > 0 || bend < 0 ? bend : turning.last;
      before = u;
    }
    turn_by(d, &turning, from, d->u[i + 1]);
  }
  d->range = turning.high - turning.low;
}

/* Whether the tangent is along the ruling, or as good as that, at an end of a
 * part, where the curve is looked at. */
static bool is_along(const struct ph_directrix *d) {
  for (size_t i = 0; i <= d->n; i++) {
    const struct ph_general_place at = ph_general_at(d, d->u[i]);
    if (!(at.rate * at.rho > ALONG * ph_vec3_abs(at.first))) {
      return true;
    }
  }
  return false;
}

static enum ph_status prepare(struct ph_curve *curve, size_t k,
                              struct ph_directrix *d, struct parts *parts,
                              struct ph_arena *arena, struct ph_diag *diag) {
  const struct ph_strip *strip = &curve->surface.strips[k];
  ph_vec3 ruling = ph_vec3_get(strip->frame.ruling, 3);
  ph_fast3_of(curve, k, &d->fast);
  d->vertex = ph_vec3_get(strip->vertex, 3);
  d->near = HUGE_VAL;
  d->far = 0;
  d->turn = d->range = 0;
  d->bends = 0;
  d->length = strip->length;
  d->distance = 0;
  d->moved = NULL;
  d->side = ph_vec3_dot(ruling, ph_general_at(d, 0).w) < 0 ? -1 : 1;
  if (!divide(d, parts)) {
    return ph_fail_at(diag, PH_E_NO_CONVERGENCE, "strips", k,
                      "cannot be laid flat: a tangent of its directrix is, or "
                      "is nearly, along the ruling; look at apexes, "
                      "contact_point and tangent_scale");
  }
  d->n = parts->n;
  d->u = ph_arena_array(arena, d->n + 1, sizeof *d->u);
  d->phi = ph_arena_array(arena, d->n + 1, sizeof *d->phi);
  if (!d->u || !d->phi) {
    return ph_fail_memory(diag);
  }
  memcpy(d->u, parts->u, (d->n + 1) * sizeof *d->u);
  memcpy(d->phi, parts->phi, (d->n + 1) * sizeof *d->phi);
  follow_turns(d);
  return is_along(d)
             ? ph_fail_at(diag, PH_E_NO_CONVERGENCE, "strips", k,
                          "is not regular: a tangent of its directrix is along "
                          "the ruling; look at apexes, contact_point and "
                          "tangent_scale")
             : PH_OK;
}

enum ph_status ph_general_of(struct ph_curve *curve, struct ph_arena *arena,
                             struct ph_diag *diag) {
  struct ph_quad *rule = ph_arena_array(arena, 1, sizeof *rule);
  struct ph_directrix *d = ph_arena_array(arena, curve->n, sizeof *d);
  enum ph_status status = PH_OK;
  struct parts parts;
  if (!rule || !d || !ph_quad_gauss(rule, NODES)) {
    return ph_fail_memory(diag);
  }
  for (size_t k = 0; status == PH_OK && k < curve->n; k++) {
    d[k].rule = rule;
    status = ph_arena_late(arena)
                 ? ph_fail_memory(diag)
                 : prepare(curve, k, &d[k], &parts, arena, diag);
    curve->surface.strips[k].directrix = &d[k];
  }
  return status;
}

/* ---- rulings ------------------------------------------------------------- */

/* The contact point of the development, and the angle of the tangent there. */
static struct ph_flat_place flat_at(const struct ph_strip *strip, double u,
                                    double rho) {
  const struct ph_directrix *d = strip->directrix;
  const struct ph_pow2 grow = d->fast.grow;
  const struct ph_flat_place start = ph_flat_start(strip);
  const double first = d->side * ph_general_at(d, 0).rho;
  struct ph_flat_place at;
  at.angle = start.angle - d->side * ph_general_phi(d, u);
  at.c[0] = start.c[0] + ph_pow2_apply(grow, first * sin(start.angle) -
                                                 d->side * rho * sin(at.angle));
  at.c[1] = start.c[1] + ph_pow2_apply(grow, d->side * rho * cos(at.angle) -
                                                 first * cos(start.angle));
  if (d->moved) {
    const double x = cos(start.angle), y = sin(start.angle);
    double by[3];
    ph_general_moved(d, u, by);
    at.c[0] += ph_pow2_apply(grow, x * by[0] - y * by[1]);
    at.c[1] += ph_pow2_apply(grow, y * by[0] + x * by[1]);
  }
  return at;
}

/* The arc length from the start. */
static double arc_length(const struct ph_strip *strip,
                         const struct ph_fast3_place *at, double u) {
  const struct ph_directrix *d = strip->directrix;
  const struct ph_fast3 *fast = &d->fast;
  double by[3];
  if (d->moved) {
    ph_general_moved(d, u, by);
    return ph_pow2_apply(fast->grow, by[2]);
  }
  return ph_pow2_apply(fast->grow, ph_fast3_integral(at, at->end->s)) +
         (at->end == &fast->end[1] ? d->length : 0);
}

struct ph_ruling ph_general_ruling(const struct ph_strip *strip, double u) {
  const struct ph_directrix *d = strip->directrix;
  const struct ph_fast3_place place = ph_fast3_at(&d->fast, u);
  const struct ph_general_place at = ph_general_at(d, u);
  const double rho = ph_pow2_apply(d->fast.grow, at.rho);
  const double off = ph_pow2_apply(d->fast.grow, d->distance);
  const double kn = d->side * at.bend / at.rate / rho, f = 1 - kn * off;
  struct ph_ruling ruling;
  ruling.at.e = ph_vec3_scale(d->side / at.rho, at.w);
  ruling.at.d = ph_vec3_unit(ph_vec3_normal(at.first, ruling.at.e));
  ruling.at.n = ph_vec3_cross(ruling.at.e, ruling.at.d);
  ruling.at.c =
      ph_vec3_along(ph_fast3_point(&d->fast, &place), off, ruling.at.n);
  ruling.flat = flat_at(strip, u, at.rho);
  ruling.s = arc_length(strip, &place, u);
  ruling.k = -d->side / rho / f;
  ruling.kn = kn / f;
  return ruling;
}

void ph_general_edge(const struct ph_strip *strip, double u, double h,
                     double at[2], double by[2]) {
  const struct ph_directrix *d = strip->directrix;
  const struct ph_general_place place = ph_general_at(d, u);
  const struct ph_flat_place flat = flat_at(strip, u, place.rho);
  const double along = ph_pow2_apply(
      d->fast.grow, d->side * ph_vec3_dot(place.w, place.first) / place.rho);
  const double across =
      place.rate * (ph_pow2_apply(d->fast.grow, place.rho) + d->side * h) -
      d->side * place.bend * ph_pow2_apply(d->fast.grow, d->distance);
  const double x = cos(flat.angle), y = sin(flat.angle);
  at[0] = flat.c[0] - h * y;
  at[1] = flat.c[1] + h * x;
  by[0] = across * x - along * y;
  by[1] = across * y + along * x;
}

double ph_general_parameter(const struct ph_strip *strip, double part) {
  enum { STEPS = 60 };
  const struct ph_fast3 *fast = &strip->directrix->fast;
  const double whole = ph_pow2_apply(fast->shrink, strip->directrix->length);
  const double wanted = part * whole;
  double low = 0, high = 1, u = part;
  for (int i = 0; i < STEPS && high > low; i++) {
    const struct ph_fast3_place at = ph_fast3_at(fast, u);
    const ph_quat a = ph_fast3_preimage(&at);
    const double off = ph_fast3_integral(&at, at.end->s) +
                       (at.end == &fast->end[1] ? whole : 0) - wanted;
    const double next = u - off / ph_quat_dot(a, a);
    if (fabs(off) <= 4 * DBL_EPSILON * whole) {
      break;
    }
    *(off > 0 ? &high : &low) = u;
    u = next > low && next < high ? next : low + (high - low) / 2;
  }
  return u;
}

/* ---- area ---------------------------------------------------------------- */

/* The integral of |x| from a to b. */
static double band(double a, double b) {
  return a * b >= 0 ? fabs(a + b) / 2 * (b - a) : (a * a + b * b) / 2;
}

/* A strip between two heights. */
struct between {
  const struct ph_directrix *d;
  const double *height;
};

/* What a height is from the vertex, at u. */
static double from_vertex(const struct between *b, double u, size_t edge,
                          double *rate) {
  const struct ph_directrix *d = b->d;
  const struct ph_general_place at = ph_general_at(d, u);
  *rate = at.rate;
  return ph_pow2_apply(d->fast.grow,
                       d->side * at.rho - d->distance * at.bend / at.rate) +
         b->height[edge];
}

/* The integral over [from,to]; where a height passes the vertex it has a kink,
 * and halves are taken. */
static double area_of(const struct between *b, double from, double to,
                      int halvings) {
  const struct ph_quad *rule = b->d->rule;
  double sum = 0, rate;
  for (size_t edge = 0; edge < 2 && halvings > 0; edge++) {
    if (from_vertex(b, from, edge, &rate) * from_vertex(b, to, edge, &rate) <
        0) {
      const double middle = from + (to - from) / 2;
      return area_of(b, from, middle, halvings - 1) +
             area_of(b, middle, to, halvings - 1);
    }
  }
  for (size_t j = 0; j < rule->n; j++) {
    const double u = from + (to - from) * rule->node[j];
    const double low = from_vertex(b, u, 0, &rate);
    sum += (to - from) * rule->weight[j] * rate *
           band(low, low + (b->height[1] - b->height[0]));
  }
  return sum;
}

double ph_general_area(const struct ph_strip *strip, const double height[2]) {
  enum { HALVINGS = 12 };
  const struct between b = {strip->directrix, height};
  double sum = 0;
  for (size_t i = 0; i < b.d->n; i++) {
    sum += area_of(&b, b.d->u[i], b.d->u[i + 1], HALVINGS);
  }
  return sum;
}

/* ---- the development as a polygon ---------------------------------------- */

enum { FLAT_MAX = 1 << 20, FLAT_DEPTH = 30 };

/* A polygon in the making: of a strip, within a tolerance. */
struct polygon {
  struct ph_strip *strip;
  double tolerance;
  struct ph_arena *arena;
  size_t room;
};

/* A sample, and its parameter in [0,1]. */
struct corner {
  double u, point[2];
};

static struct corner corner_at(const struct polygon *polygon, double u) {
  const struct ph_directrix *d = polygon->strip->directrix;
  const struct ph_flat_place at =
      flat_at(polygon->strip, u, ph_general_at(d, u).rho);
  return (struct corner){u, {at.c[0], at.c[1]}};
}

static bool add_corner(const struct corner *corner, struct polygon *polygon) {
  struct ph_arc2 *flat = &polygon->strip->development;
  flat->samples = ph_arena_grow(polygon->arena, flat->samples, flat->samples_n,
                                sizeof *flat->samples, 64, &polygon->room);
  if (!flat->samples) {
    return false;
  }
  flat->samples[flat->samples_n++] = (struct ph_flat_sample){
      corner->u * *polygon->strip->alpha, {corner->point[0], corner->point[1]}};
  return true;
}

/* By how much a place leaves the chord of two others. */
static double leaves(const struct corner *a, const struct corner *b,
                     const struct corner *at) {
  const double x = b->point[0] - a->point[0], y = b->point[1] - a->point[1];
  const double size = hypot(x, y);
  return size > 0 ? fabs(x * (at->point[1] - a->point[1]) -
                         y * (at->point[0] - a->point[0])) /
                        size
                  : HUGE_VAL;
}

/* Whether a chord is near enough, in its middle and in that of both halves. */
static bool is_near(const struct polygon *polygon, const struct corner *a,
                    const struct corner *middle, const struct corner *b) {
  const double step = (b->u - a->u) / 4;
  const struct corner first = corner_at(polygon, a->u + step);
  const struct corner last = corner_at(polygon, b->u - step);
  return leaves(a, b, middle) <= polygon->tolerance &&
         leaves(a, b, &first) <= polygon->tolerance &&
         leaves(a, b, &last) <= polygon->tolerance;
}

enum ph_status ph_general_flat(struct ph_strip *strip, double tolerance,
                               struct ph_arena *arena, struct ph_diag *diag) {
  struct polygon polygon = {strip, tolerance, arena, 0};
  struct corner stack[FLAT_DEPTH], from = corner_at(&polygon, 0);
  size_t depth = 1;
  strip->development.samples = NULL;
  strip->development.samples_n = 0;
  stack[0] = corner_at(&polygon, 1);
  if (!add_corner(&from, &polygon)) {
    return ph_fail_memory(diag);
  }
  while (depth > 0) {
    const struct corner to = stack[depth - 1];
    const struct corner middle =
        corner_at(&polygon, from.u + (to.u - from.u) / 2);
    if (depth == FLAT_DEPTH || is_near(&polygon, &from, &middle, &to)) {
      if (strip->development.samples_n >= FLAT_MAX) {
        return ph_fail(diag, PH_E_LIMIT, NULL,
                       "the development needs more samples than %d for one "
                       "strip; --tolerance may be greater",
                       (int)FLAT_MAX);
      }
      if (!add_corner(&to, &polygon)) {
        return ph_fail_memory(diag);
      }
      from = to;
      depth--;
    } else {
      stack[depth++] = middle;
    }
  }
  return PH_OK;
}
