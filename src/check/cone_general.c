/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Strips of general cones: their frames and developments (see cone_general.h).
 */
#include "check/cone_general.h"

#include "check/certify.h"
#include "check/data.h"
#include "kernel/pi.h"

#include <float.h>
#include <string.h>

/* Of unit vectors, and of points in the rounding of coordinates. */
static const double UNIT = 64 * DBL_EPSILON;
enum { ROUND = 16 };

/* What a certificate allows of frames, of angles and lengths, and of the turn;
 * and of integrals. */
static const double FRAME = 1e-10, FLAT = 1e-11, INTEGRAL = 1e-13;

/* The directrix in a certificate. */
static const struct ph_tolerance DIRECTRIX = {.of_size = 1e-12,
                                              .gap = 4,
                                              .square = 1e-12,
                                              .length = 1e-12,
                                              .joint = 1e-11,
                                              .given = 1e-11};

/* Tangents whose length is 1 to this are derivatives as they stand. */
static const double WRITTEN = 1e-3;

void ph_check_general_load(struct ph_check_general *g, size_t k) {
  const struct ph_strip *strip = ph_check_general_strip(g, k);
  ph_check_load(g->v, k, &g->s);
  g->k = k;
  g->vertex = ph_check_vector(g->v, strip->vertex, 3);
  g->side = ph_vec3_dot(ph_vec3_get(strip->frame.ruling, 3),
                        ph_vec3_sub(g->s.end[0], g->vertex)) < 0
                ? -1
                : 1;
  g->u = g->phi = 0;
}

/* ---- places -------------------------------------------------------------- */

struct ph_check_general_seen
ph_check_general_place_at(const struct ph_check_general *g, double u) {
  const struct ph_check_segment *s = &g->s;
  struct ph_check_general_seen at;
  ph_vec3 across;
  double size;
  ph_check_jet(s, u, at.jet, 2);
  at.f.c = ph_check_point(g->v, s, u);
  at.w = ph_vec3_sub(at.f.c, g->vertex);
  at.rho = ph_vec3_abs(at.w);
  across = ph_vec3_cross(at.w, at.jet[0]);
  size = ph_vec3_abs(across);
  at.f.e = ph_vec3_scale(g->side / at.rho, at.w);
  at.f.n = ph_vec3_scale(g->side / size, across);
  at.f.d = ph_vec3_cross(at.f.n, at.f.e);
  at.rate = size / (at.rho * at.rho);
  at.turn = ph_vec3_triple(at.w, at.jet[0], at.jet[1]) / size * at.rho / size;
  at.doubt = ROUND * (s->reach + DBL_EPSILON * ph_vec3_abs(g->vertex)) *
                 (1 / at.rho + ph_vec3_abs(at.jet[0]) / size) +
             s->noise * at.rho / size + UNIT;
  return at;
}

static void rate_at(const void *context, double u, double *value) {
  *value = ph_check_general_place_at(context, u).rate;
}

double ph_check_general_integral(const struct ph_check_general *g,
                                 ph_check_integrand *f, double tolerance,
                                 double from, double to) {
  const struct ph_check_integrands of = {f, g, 1, 0, tolerance, INTEGRAL};
  double sum = 0;
  if (from < to || from > to) {
    ph_check_integral(&g->v->rule, &of, from < to ? from : to,
                      from < to ? to : from, &sum);
  }
  return from > to ? -sum : sum;
}

/* Rulings turn by what they are known to turn by, and no better: far from the
 * origin, rounding of places is more than what is asked of integrals. */
double ph_check_general_phi(const struct ph_check_general *g, double from,
                            double to) {
  const struct ph_check_general_seen middle =
      ph_check_general_place_at(g, from + (to - from) / 2);
  return ph_check_general_integral(g, rate_at, middle.rate * middle.doubt, from,
                                   to);
}

/* phi at u: places are asked for in order, as a rule. */
static double phi_at(struct ph_check_general *g, double u) {
  g->phi += ph_check_general_phi(g, g->u, u);
  g->u = u;
  return g->phi;
}

/* ---- frames -------------------------------------------------------------- */

static double frame_allowed(const struct ph_check_general *g) {
  return g->v->error ? FRAME : 0;
}

/* Ruling and normal of a place against others. */
static void check_directions(struct ph_check_general *g,
                             const struct ph_check_general_seen *at, ph_vec3 e,
                             ph_vec3 n, double doubt, const char *what) {
  ph_check_miss(
      g->v, PH_CHECK_FRAME, ph_check_general_where(g->k, "frame"),
      ph_check_larger(ph_check_apart(at->f.e, e), ph_check_apart(at->f.n, n)),
      1, frame_allowed(g) + at->doubt + doubt, what);
}

static void check_start(struct ph_check_general *g,
                        const struct ph_check_general_seen *at) {
  const struct ph_strip_frame *f = &ph_check_general_strip(g, g->k)->frame;
  const ph_vec3 e = ph_vec3_get(f->ruling, 3), d = ph_vec3_get(f->tangent, 3);
  const ph_vec3 n = ph_vec3_get(f->normal, 3);
  ph_check_miss(g->v, PH_CHECK_FRAME, ph_check_general_where(g->k, "frame"),
                ph_check_apart(d, ph_vec3_cross(n, e)), 1, UNIT,
                "is not orthonormal");
  ph_check_miss(g->v, PH_CHECK_FRAME, ph_check_general_where(g->k, "frame"),
                ph_check_apart(ph_check_vector(g->v, f->point, 3), at->f.c),
                g->v->scale.size, ROUND * g->v->scale.rounding,
                "does not begin with its directrix");
  check_directions(g, at, e, n, UNIT, "is not that of the cone");
}

/* ---- the development ----------------------------------------------------- */

static void miss_flat(struct ph_check_general *g, const char *member, double by,
                      double unit, double allowed, const char *what) {
  ph_check_miss(g->v, PH_CHECK_ISOMETRY, ph_check_general_where(g->k, member),
                by, unit,
                allowed + (g->v->error ? FLAT * unit : 0) + UNIT * unit, what);
}

struct ph_check_general_flat
ph_check_general_flat_at(struct ph_check_general *g,
                         const struct ph_check_general_seen *at, double u) {
  const struct ph_arc2 *arc = &ph_check_general_strip(g, g->k)->development;
  const double *start =
      arc->samples_n ? arc->samples[0].point : arc->control_points[0];
  const double first =
      g->side * ph_vec3_abs(ph_vec3_sub(g->s.end[0], g->vertex));
  struct ph_check_general_flat flat;
  flat.turn = -g->side * phi_at(g, u);
  flat.angle = arc->angle + flat.turn;
  flat.x = ph_check_scaled(g->v, start[0]) + first * sin(arc->angle) -
           g->side * at->rho * sin(flat.angle);
  flat.y = ph_check_scaled(g->v, start[1]) - first * cos(arc->angle) +
           g->side * at->rho * cos(flat.angle);
  return flat;
}

/* The rounding of points of a development. */
double ph_check_general_flat_rounding(const struct ph_check_general *g,
                                      const struct ph_check_general_flat *flat,
                                      double rho) {
  return ROUND *
         (g->v->scale.rounding + DBL_EPSILON * (fabs(flat->x) + fabs(flat->y) +
                                                rho * (1 + fabs(flat->angle))));
}

double
ph_check_general_flat_distance(const struct ph_check_general *g,
                               const double *point,
                               const struct ph_check_general_flat *flat) {
  return hypot(ph_check_scaled(g->v, point[0]) - flat->x,
               ph_check_scaled(g->v, point[1]) - flat->y);
}

/* The samples, of which a certificate has none yet. */
static void check_polygon(struct ph_check_general *g) {
  const struct ph_arc2 *arc = &ph_check_general_strip(g, g->k)->development;
  const double alpha = *ph_check_general_strip(g, g->k)->alpha;
  for (size_t i = 0; i < arc->samples_n; i++) {
    const double u = arc->samples[i].t / alpha;
    const bool last = i + 1 == arc->samples_n;
    const bool order = i == 0 ? !(fabs(u) > 0) : u > g->u;
    struct ph_check_general_seen at;
    struct ph_check_general_flat flat;
    if (!order || !(u <= 1) || (last && u < 1)) {
      ph_check_wrong(g->v, PH_CHECK_SHAPE,
                     ph_check_general_where(g->k, "development"),
                     "does not lead from 0 to alpha, in order");
      return;
    }
    at = ph_check_general_place_at(g, u);
    flat = ph_check_general_flat_at(g, &at, u);
    miss_flat(g, "development",
              ph_check_general_flat_distance(g, arc->samples[i].point, &flat),
              g->v->scale.size,
              ph_check_general_flat_rounding(g, &flat, at.rho),
              "is off the contact curve laid flat");
  }
}

/* Where the next development begins, and in which direction. */
static void check_flat(struct ph_check_general *g,
                       const struct ph_check_general_seen *end) {
  const struct ph_strip *s = ph_check_general_strip(g, g->k);
  const bool more = g->k + 1 < g->curve->n;
  struct ph_check_general_flat flat;
  g->u = g->phi = 0;
  check_polygon(g);
  flat = ph_check_general_flat_at(g, end, 1);
  miss_flat(g, "development_angle",
            fabs(s->development_angle - fabs(flat.turn)), fabs(flat.turn), 0,
            "is not the angle of the rulings");
  if (more) {
    const struct ph_arc2 *next =
        &ph_check_general_strip(g, g->k + 1)->development;
    const double *start =
        next->samples_n ? next->samples[0].point : next->control_points[0];
    miss_flat(g, "development", ph_check_general_flat_distance(g, start, &flat),
              g->v->scale.size,
              ph_check_general_flat_rounding(g, &flat, end->rho),
              "ends elsewhere than the next one begins");
    miss_flat(g, "development", fabs(next->angle - flat.angle), 1,
              4 * DBL_EPSILON * fabs(flat.angle),
              "ends in another direction than the next one begins");
  }
}

/* ---- the problem --------------------------------------------------------- */

/* The derivative at an element, as it is taken. */
static ph_vec3 derivative_of(const struct ph_check *v, size_t j, bool unit) {
  const struct ph_value *field = v->problem->field;
  const double *x = field[PH_F_TANGENTS].v + 3 * j;
  const ph_vec3 given = ph_vec3_get(x, 3), d = ph_check_direction(x, 3);
  const ph_vec3 e = ph_check_direction(field[PH_F_RULINGS].v + 3 * j, 3);
  return !unit ? ph_vec3_unit(ph_vec3_normal(d, e))
         : fabs(ph_vec3_abs(given) - 1) <= WRITTEN ? given
                                                   : d;
}

/* An end of a strip: the derivative there, by t. */
static void check_derivative(struct ph_check_general *g, size_t end,
                             ph_vec3 wanted, bool unit) {
  const double alpha = *ph_check_general_strip(g, g->k)->alpha;
  const ph_vec3 first = ph_vec3_scale(1 / alpha, g->s.first[end]);
  const double size =
      unit ? ph_check_scaled(g->v, 1)
           : ph_check_apart(g->s.end[0], g->s.end[1]) / ph_vec3_abs(wanted);
  const ph_vec3 by = ph_vec3_scale(size, wanted);
  ph_check_miss(g->v, PH_CHECK_TANGENT,
                ph_check_general_where(g->k, "control_points"),
                ph_check_apart(first, by), ph_vec3_abs(by),
                (g->v->error ? DIRECTRIX.given : 0) * ph_vec3_abs(by) +
                    UNIT * ph_vec3_abs(by) + g->s.noise / alpha,
                "have another derivative at an end than is given");
}

/* Where the directrix of a pair meets the common ruling. */
static void check_contact(struct ph_check_general *g, ph_vec3 middle,
                          ph_vec3 last) {
  const struct ph_value *value = &g->v->problem->field[PH_F_CONTACT_POINT];
  const ph_vec3 way = ph_vec3_sub(last, g->vertex);
  const double along = ph_vec3_dot(ph_vec3_sub(middle, g->vertex), way);
  const double part = value->kind == PH_NUMBER ? value->number
                      : ph_check_is_word(g->v, PH_F_CONTACT_POINT, "midpoint")
                          ? 0.5
                          : along / ph_vec3_dot(way, way);
  const double size = ph_vec3_abs(way) + g->v->scale.size;
  ph_check_miss(
      g->v, PH_CHECK_INTERPOLATION,
      ph_check_general_where(g->k, "control_points"),
      ph_check_apart(ph_vec3_along(g->vertex, part, way), g->s.end[1]),
      g->v->scale.size,
      (g->v->error ? DIRECTRIX.of_size : 0) * size +
          ROUND * (g->v->scale.rounding + DBL_EPSILON * size),
      "do not end at the contact point");
}

/* Element j at the start or the end of strip k, which is loaded. */
static void check_element(struct ph_check_general *g, size_t j, size_t end,
                          const struct ph_check_general_seen *at) {
  const struct ph_value *field = g->v->problem->field;
  const ph_vec3 p = ph_check_cone_point(g->v, j);
  const ph_vec3 e = ph_check_direction(field[PH_F_RULINGS].v + 3 * j, 3);
  const ph_vec3 d = ph_check_direction(field[PH_F_TANGENTS].v + 3 * j, 3);
  const double apex = ph_check_scaled(g->v, field[PH_F_APEXES].v[j]);
  ph_check_miss(g->v, PH_CHECK_INTERPOLATION,
                ph_check_general_where(g->k, "control_points"),
                ph_check_apart(g->s.end[end], p), g->v->scale.size,
                ROUND * g->v->scale.rounding, "are off a given point");
  ph_check_miss(
      g->v, PH_CHECK_INTERPOLATION, ph_check_general_where(g->k, "vertex"),
      ph_check_apart(ph_vec3_along(p, apex, e), g->vertex), g->v->scale.size,
      ROUND * (g->v->scale.rounding + DBL_EPSILON * fabs(apex)),
      "is off its place on the ruling");
  check_directions(g, at, e, ph_vec3_unit(ph_vec3_cross(e, d)), UNIT,
                   "is not that of the contact element");
}

static void check_problem(struct ph_check_general *g,
                          const struct ph_check_general_seen *start,
                          const struct ph_check_general_seen *end) {
  const struct ph_check *v = g->v;
  const bool unit = ph_check_is_word(v, PH_F_TANGENT_SCALE, "unit");
  const size_t pairs = g->curve->n / 2, i = g->k / 2;
  const size_t j = i + 1 < pairs || !g->curve->closed ? i + 1 : 0;
  const ph_vec3 a = derivative_of(v, i, unit), b = derivative_of(v, j, unit);
  const ph_vec3 mean = ph_vec3_scale(0.5, ph_vec3_add(a, b));
  if (g->k % 2) {
    check_element(g, j, 1, end);
    check_derivative(g, 0, mean, unit);
    check_derivative(g, 1, b, unit);
  } else {
    const ph_vec3 middle = ph_vec3_scale(
        0.5, ph_vec3_add(ph_check_cone_point(v, i), ph_check_cone_point(v, j)));
    check_element(g, i, 0, start);
    check_derivative(g, 0, a, unit);
    check_derivative(g, 1, mean, unit);
    check_contact(
        g, middle,
        ph_check_vector(v, ph_check_general_strip(g, g->k + 1)->vertex, 3));
  }
}

/* ---- all strips ---------------------------------------------------------- */

/* Why a strip is none, or NULL. */
static const char *fault_of(const struct ph_strip *s, const char **member) {
  *member = "method";
  if (s->method != PH_STRIP_ATPH) {
    return "is not that of the first strip";
  }
  *member = "control_points";
  if (!s->control_points || !s->preimage || !s->alpha ||
      !ph_are_finite(s->control_points, 18) ||
      !ph_are_finite(s->preimage, 12)) {
    return "are missing, or hold what is not finite";
  }
  *member = "alpha";
  if (!(*s->alpha > 0 && *s->alpha < PH_PI)) {
    return "is not between 0 and pi";
  }
  *member = "vertex";
  if (!ph_are_finite(s->vertex, 3)) {
    return "holds what is not finite";
  }
  *member = "development";
  for (size_t i = 0; i < s->development.samples_n; i++) {
    if (!ph_are_finite(&s->development.samples[i].t, 1) ||
        !ph_are_finite(s->development.samples[i].point, 2)) {
      return "holds what is not finite";
    }
  }
  return isfinite(s->development_angle) && isfinite(s->development.angle)
             ? NULL
             : "holds what is not finite";
}

static bool check_arrays(struct ph_check *v, const struct ph_curve *c) {
  for (size_t k = 0; k < c->n; k++) {
    const char *member;
    const char *fault = fault_of(&c->surface.strips[k], &member);
    if (fault && v->error) {
      v->status = ph_fail_at(v->diag, PH_E_TOO_LARGE, "strips", k, "%s", fault);
      return false;
    }
    if (fault) {
      ph_check_wrong(v, PH_CHECK_SHAPE, ph_check_general_where(k, member),
                     fault);
      return false;
    }
  }
  return ph_check_cone_is_finite(v, c);
}

/* The contact curves of all strips as one curve of ATPH segments. */
static bool gather(struct ph_check *v, struct ph_curve *c) {
  const size_t n = c->n;
  c->degree = 5;
  c->dimension = 3;
  c->joined = false;
  c->preimage.n = 3;
  c->preimage.dimension = 4;
  c->knots = ph_arena_array(v->scratch, n + 1, sizeof *c->knots);
  c->lengths = ph_arena_array(v->scratch, n, sizeof *c->lengths);
  c->control_points =
      ph_arena_array(v->scratch, n, 18 * sizeof *c->control_points);
  c->preimage.v = ph_arena_array(v->scratch, n, 12 * sizeof *c->preimage.v);
  c->preimage.alpha = ph_arena_array(v->scratch, n, sizeof(double));
  v->length = ph_arena_array(v->scratch, n, sizeof *v->length);
  v->noise = ph_arena_array(v->scratch, n, sizeof *v->noise);
  v->rooted = ph_arena_array(v->scratch, n, sizeof *v->rooted);
  if (!c->knots || !c->lengths || !c->control_points || !c->preimage.v ||
      !c->preimage.alpha || !v->length || !v->noise || !v->rooted) {
    return false;
  }
  for (size_t k = 0; k < n; k++) {
    const struct ph_strip *s = &c->surface.strips[k];
    c->knots[k] = (double)k;
    c->lengths[k] = s->length;
    c->preimage.alpha[k] = *s->alpha;
    memcpy(c->control_points + 18 * k, s->control_points, 18 * sizeof(double));
    memcpy(c->preimage.v + 12 * k, s->preimage, 12 * sizeof(double));
    v->noise[k] = 0;
    v->rooted[k] = false;
  }
  c->knots[n] = (double)n;
  return true;
}

static void check_strip(struct ph_check_general *g, size_t k,
                        struct ph_check_general_seen *before) {
  const struct ph_curve *c = g->curve;
  struct ph_check_general_seen start, end;
  ph_check_general_load(g, k);
  start = ph_check_general_place_at(g, 0);
  end = ph_check_general_place_at(g, 1);
  check_start(g, &start);
  if (k > 0) {
    check_directions(g, &start, before->f.e, before->f.n, before->doubt,
                     "is not that in which the one before ends");
  }
  if (c->closed && k + 1 == c->n) {
    const struct ph_strip_frame *f = &ph_check_general_strip(g, 0)->frame;
    check_directions(g, &end, ph_vec3_get(f->ruling, 3),
                     ph_vec3_get(f->normal, 3), UNIT,
                     "does not lead to that of the first strip");
  }
  if (g->v->problem) {
    check_problem(g, &start, &end);
  }
  check_flat(g, &end);
  *before = end;
}

/* Whether the problem is one that such a surface may be of. */
static bool fits(const struct ph_check_general *g) {
  const struct ph_problem *p = g->v->problem;
  const struct ph_curve *c = g->curve;
  const size_t n = c->n / 2 + (c->closed ? 0 : 1);
  static const enum ph_field_id fields[] = {PH_F_POINTS, PH_F_RULINGS,
                                            PH_F_TANGENTS, PH_F_APEXES};
  bool same = c->closed == p->field[PH_F_CLOSED].flag &&
              ph_check_is_word(g->v, PH_F_METHOD, "atph");
  for (size_t i = 0; i < 4; i++) {
    const struct ph_value *value = &p->field[fields[i]];
    same = same && (value->n == n || (c->closed && value->n == n + 1)) &&
           value->dimension == (i < 3 ? 3 : 1);
  }
  if (!same) {
    ph_check_wrong(g->v, PH_CHECK_SHAPE,
                   ph_check_of("strips", PH_CHECK_ONE, NULL),
                   "are not two for each pair of contact elements of the "
                   "problem, of its method");
  }
  return same;
}

static enum ph_status check_all(struct ph_check_general *g) {
  struct ph_check *v = g->v;
  struct ph_check_general_totals totals = {0, 0, 0, true};
  struct ph_check_general_seen before = {.rho = 0};
  const bool with_problem = v->problem && fits(g);
  const struct ph_problem *problem = v->problem;
  enum ph_status status = PH_OK;
  v->problem = with_problem ? problem : NULL;
  ph_check_segments(v);
  ph_check_lengths(v);
  for (size_t k = 0; k < g->curve->n && !ph_arena_late(v->scratch); k++) {
    check_strip(g, k, &before);
    ph_check_general_turn(g, &totals);
    if (!v->error) {
      ph_check_general_height(g, &totals);
    }
  }
  if (!v->error) {
    ph_check_general_told(g, &totals);
    status = ph_check_general_panorama(g);
  }
  v->problem = problem;
  return ph_arena_late(v->scratch) ? ph_fail_memory(v->diag) : status;
}

/* What is known of the space of the directrices. */
static void use_space(struct ph_check *v, struct ph_check_space *space) {
  *space = ph_check_space_of(&v->fixed, 4, 0);
  v->space = space;
}

enum ph_status ph_check_cone_general(struct ph_check *v) {
  struct ph_curve contact = *v->curve;
  const struct ph_curve *surface = v->curve;
  struct ph_check_space space;
  struct ph_check_general g = {.v = v, .curve = &contact};
  enum ph_status status;
  if (!check_arrays(v, surface)) {
    return PH_OK;
  }
  if (!gather(v, &contact) || !ph_quad_gauss(&v->fixed, PH_CHECK_NODES_ATPH) ||
      !ph_check_rule_of(&v->rule, v->scratch)) {
    return ph_fail_memory(v->diag);
  }
  if (!ph_check_scale_of(contact.control_points, 6 * contact.n, 3, &v->scale)) {
    ph_check_wrong(v, PH_CHECK_SHAPE, ph_check_of("strips", PH_CHECK_ONE, NULL),
                   "have no extent");
    return PH_OK;
  }
  use_space(v, &space);
  v->curve = &contact;
  v->allow = v->error ? &DIRECTRIX : v->allow;
  status = check_all(&g);
  v->space = NULL;
  v->curve = surface;
  return status;
}
