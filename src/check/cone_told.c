/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What records say of a surface beside its frames (see cone.h). */
#include "check/cone.h"

#include "check/data.h"

#include <float.h>

/* Beside rounding of coordinates. */
static const double UNIT = 64 * DBL_EPSILON;
enum { ROUND = 16 };

/* What is nothing beside the distance of the points where degenerate_tolerance
 * is less; and the most that may be. */
static const double DEGENERATE = 1e-8, DEGENERATE_MAX = 0.1;

/* How far outside a place may be, relative to coordinates. */
static const double NEAR = 2e-12;

/* ---- arrays -------------------------------------------------------------- */

/* Why a strip is none, or NULL. */
static const char *fault_of(const struct ph_strip *s, size_t i,
                            const char **member) {
  const double angles[] = {s->half_angle, s->sweep, s->development_angle};
  *member = "frame";
  if (!ph_are_finite(s->frame.point, 3) || !ph_are_finite(s->frame.ruling, 3) ||
      !ph_are_finite(s->frame.tangent, 3) ||
      !ph_are_finite(s->frame.normal, 3)) {
    return "holds what is not finite";
  }
  *member = "contact";
  if (!ph_are_finite(&s->contact.control_points[0][0], 9) ||
      !ph_are_finite(s->contact.weights, 3)) {
    return "holds what is not finite";
  }
  *member = "development";
  if (!ph_are_finite(&s->development.control_points[0][0], 6) ||
      !ph_are_finite(s->development.weights, 3) ||
      !ph_are_finite(&s->development.angle, 1)) {
    return "holds what is not finite";
  }
  *member = NULL;
  if (!isfinite(s->k) || !isfinite(s->kn) || !ph_are_finite(angles, 3) ||
      !ph_are_finite(s->shift, 2)) {
    return "holds what is not finite";
  }
  *member = "length";
  if (!(s->length > 0) || !isfinite(s->length)) {
    return "is not positive";
  }
  *member = "pair";
  return s->pair == i / 2 ? NULL : "is not that of two strips in a row";
}

bool ph_check_cone_is_finite(struct ph_check *v, const struct ph_curve *c) {
  if (v->error && !(isfinite(c->length) && isfinite(c->surface.area))) {
    v->status = ph_fail(v->diag, PH_E_TOO_LARGE, NULL,
                        "the length or the area of the surface overflows a "
                        "double");
    return false;
  }
  return true;
}

bool ph_check_cone_arrays(struct ph_check *v, const struct ph_curve *c) {
  for (size_t i = 0; i < c->n; i++) {
    const char *member;
    const char *fault = fault_of(&c->surface.strips[i], i, &member);
    if (fault && v->error) {
      v->status = ph_fail_at(v->diag, PH_E_TOO_LARGE, "strips", i, "%s", fault);
      return false;
    }
    if (fault) {
      ph_check_wrong(v, PH_CHECK_SHAPE, ph_check_of("strips", i, member),
                     fault);
      return false;
    }
  }
  if (!ph_check_cone_is_finite(v, c)) {
    return false;
  }
  if (c->n % 2 != 0 || c->surface.pairs_n != c->n / 2 || !isfinite(c->length) ||
      !isfinite(c->surface.area)) {
    ph_check_wrong(v, PH_CHECK_SHAPE, ph_check_of("strips", PH_CHECK_ONE, NULL),
                   "are not two for each pair, with a finite length and area");
    return false;
  }
  return true;
}

/* ---- numbers of strips --------------------------------------------------- */

static struct ph_check_where strip_of(size_t i, const char *member) {
  return ph_check_of("strips", i, member);
}

static void check_strip(struct ph_check *v, const struct ph_strip *s,
                        size_t i) {
  const double turn = hypot(s->k, s->kn) * s->length;
  double unit = 0;
  ph_check_number(v, PH_CHECK_DIAGNOSTIC, strip_of(i, "half_angle"),
                  s->half_angle, atan2(fabs(s->k), fabs(s->kn)), 1, UNIT);
  ph_check_number(v, PH_CHECK_DIAGNOSTIC, strip_of(i, "sweep"), s->sweep, turn,
                  1, UNIT);
  ph_check_number(v, PH_CHECK_DIAGNOSTIC, strip_of(i, "development_angle"),
                  s->development_angle, s->k * s->length, 1, UNIT);
  if (!(fabs(s->k) > 0)) {
    return;
  }
  for (size_t j = 0; j < 3; j++) {
    unit = ph_check_larger(
        unit, ph_check_larger(fabs(s->frame.point[j]), fabs(s->vertex[j])));
  }
  for (size_t j = 0; j < 3; j++) {
    const double found = s->frame.point[j] + s->frame.ruling[j] / s->k;
    if (isfinite(found) || !isnan(s->vertex[j])) { /* else it is too far away */
      ph_check_number(v, PH_CHECK_DIAGNOSTIC, strip_of(i, "vertex"),
                      s->vertex[j], found, unit, UNIT);
    }
  }
}

/* ---- the height ---------------------------------------------------------- */

/* 1 - k h at the corner of a height and of an end. */
static double factor_at(const struct ph_surface *surface,
                        const struct ph_strip *s, size_t edge, double u) {
  const double *height = surface->height;
  const bool bare = !(fabs(height[0]) > 0) && !(fabs(height[1]) > 0);
  const double h = height[edge] - s->shift[0] * (1 - u) - s->shift[1] * u;
  return 1 - (bare ? 0 : s->k * h);
}

/* The integral of |1 - k h| over the height, at u: a trapezium, or two
 * triangles. */
static double across(const struct ph_surface *surface, const struct ph_strip *s,
                     double u) {
  const double high = surface->height[1] - surface->height[0];
  const double a = factor_at(surface, s, 0, u), b = factor_at(surface, s, 1, u);
  return a * b >= 0 ? fabs(a + b) / 2 * high
                    : (a * a + b * b) / 2 / fabs(a - b) * high;
}

/* The area of a strip: between the places where an edge passes the vertex the
 * integrand is a parabola, which Simpson's rule has exactly. */
static double area_of(const struct ph_surface *surface,
                      const struct ph_strip *s) {
  double cut[4] = {0, 1, 1, 1}, sum = 0;
  size_t n = 1;
  for (size_t edge = 0; edge < 2; edge++) {
    const double a = factor_at(surface, s, edge, 0);
    const double b = factor_at(surface, s, edge, 1);
    if (a * b < 0) {
      cut[n++] = a / (a - b);
    }
  }
  if (n == 3 && cut[1] > cut[2]) {
    const double swap = cut[1];
    cut[1] = cut[2];
    cut[2] = swap;
  }
  cut[n] = 1;
  for (size_t i = 0; i < n; i++) {
    const double from = cut[i], step = (cut[i + 1] - cut[i]);
    sum += step / 6 *
           (across(surface, s, from) + 4 * across(surface, s, from + step / 2) +
            across(surface, s, from + step));
  }
  return sum * s->length;
}

/* What rounding may make of it: the shifts may be far larger than the height,
 * and heights nearly that of the vertex. */
static double rounding_of(const struct ph_surface *surface,
                          const struct ph_strip *s) {
  const double far = ph_check_larger(fabs(s->shift[0]), fabs(s->shift[1]));
  const double *height = surface->height;
  const double high = ph_check_larger(fabs(height[0]), fabs(height[1])) + far;
  return UNIT * (1 + fabs(s->k) * high) * s->length * (height[1] - height[0]);
}

static bool is_inside(const struct ph_surface *surface,
                      const struct ph_strip *s) {
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (size_t i = 0; i < 4; i++) {
    const double q = factor_at(surface, s, i & 1, (double)(i >> 1));
    low = q < low ? q : low;
    high = q > high ? q : high;
  }
  return low <= 0 && high >= 0;
}

static bool changes_sign(const struct ph_surface *surface,
                         const struct ph_strip *a, const struct ph_strip *b) {
  for (size_t edge = 0; edge < 2; edge++) {
    const double x = a->kn * factor_at(surface, a, edge, 1);
    const double y = b->kn * factor_at(surface, b, edge, 0);
    if ((x < 0 && y > 0) || (x > 0 && y < 0)) {
      return true;
    }
  }
  return false;
}

/* ---- the whole ----------------------------------------------------------- */

static void check_diagnostic(struct ph_check *v, enum ph_diagnostic which,
                             double found, double unit) {
  if (ph_check_known(v, which)) {
    ph_check_number(
        v, PH_CHECK_DIAGNOSTIC,
        ph_check_of("diagnostics", PH_CHECK_ONE, ph_diagnostic_name(which)),
        v->diagnostics->value[which], found, unit, UNIT * unit);
  }
}

/* Length and area, of which there may be none. */
static void check_measure(struct ph_check_cone *cone) {
  const struct ph_curve *c = cone->curve;
  double length = 0, area = 0, rounding = 0;
  for (size_t i = 0; i < c->n; i++) {
    length += c->surface.strips[i].length;
    area += area_of(&c->surface, &c->surface.strips[i]);
    rounding += rounding_of(&c->surface, &c->surface.strips[i]);
  }
  ph_check_number(cone->v, PH_CHECK_LENGTH,
                  ph_check_of(NULL, PH_CHECK_ONE, "length"), c->length, length,
                  length, UNIT * (double)c->n * length);
  if (area > 0 || c->surface.area > 0) {
    ph_check_number(cone->v, PH_CHECK_LENGTH,
                    ph_check_of(NULL, PH_CHECK_ONE, "area"), c->surface.area,
                    area, area, UNIT * (double)c->n * area + rounding);
  }
}

static void check_diagnostics(struct ph_check_cone *cone) {
  const struct ph_curve *c = cone->curve;
  const struct ph_surface *surface = &c->surface;
  double shift = 0, inside = 0, changes = 0, large = 0;
  for (size_t i = 0; i < c->n; i++) {
    const struct ph_strip *s = &surface->strips[i];
    const struct ph_strip *next = &surface->strips[i + 1 < c->n ? i + 1 : 0];
    shift = ph_check_larger(shift, fabs(s->shift[i & 1]));
    inside += is_inside(surface, s);
    large += s->contact.weights[1] < 0;
    changes += (i + 1 < c->n || c->closed) && changes_sign(surface, s, next);
  }
  check_diagnostic(cone->v, PH_D_SHIFT, shift, shift > 0 ? shift : 1);
  check_diagnostic(cone->v, PH_D_VERTICES_INSIDE, inside, 1);
  check_diagnostic(cone->v, PH_D_SIGN_CHANGES, changes, 1);
  check_diagnostic(cone->v, PH_D_LARGE_ARCS, large, 1);
  ph_check_cone_folds(cone->v, c, inside);
}

/* By how much directions of the arcs are uncertain: what both contact points
 * are apart is known to rounding of the centre. */
static double pair_rounding(const struct ph_check_cone *cone, size_t i) {
  const struct ph_check_frame a = ph_check_cone_frame(cone, 2 * i, 0);
  const struct ph_check_frame b = ph_check_cone_frame(cone, 2 * i + 1, 1);
  const double radius =
      ph_check_scaled(cone->v, cone->curve->surface.pairs[i].radius);
  return isfinite(radius) ? UNIT * fabs(radius) / ph_check_apart(a.c, b.c) : 0;
}

/* A leg of an arc; weight / leg is what there is also of half circles. */
static void check_leg(struct ph_check_cone *cone, size_t i, size_t j) {
  const struct ph_surface *surface = &cone->curve->surface;
  const struct ph_arc3 *arc = &surface->strips[2 * i + j].contact;
  const ph_vec3 v =
      ph_vec3_sub(ph_check_vector(cone->v, arc->control_points[2], 3),
                  ph_check_vector(cone->v, arc->control_points[0], 3));
  const double chord = ph_vec3_abs(v);
  const double leg = ph_check_scaled(cone->v, surface->pairs[i].lambda[j]);
  if (isfinite(leg)) {
    ph_check_number(cone->v, PH_CHECK_DIAGNOSTIC,
                    ph_check_of("pairs", i, "lambda"), chord / leg,
                    2 * arc->weights[1], 1,
                    UNIT + pair_rounding(cone, i) +
                        ROUND * cone->v->scale.rounding / chord);
  }
}

/*
 * What the equations of a centre m lack of it, by m - c - r n at both ends,
 *
 *   (m - c1) . d1 = 0,  (m - c2) . d2 = 0,  (m - c1) . n1 = (m - c2) . n2,
 *
 * written as half the sum of the first two, their difference, and the third,
 * the last two, less what rounding of directions makes of them, over the
 * lengths of what they multiply m by: the larger of the two that are the least
 * dependent on one another.
 */
static double lack_of(const ph_vec3 miss[2], const struct ph_check_frame f[2],
                      double rounding) {
  const ph_vec3 by = ph_vec3_sub(f[1].d, f[0].d);
  const ph_vec3 up = ph_vec3_sub(f[0].n, f[1].n);
  const ph_vec3 row[] = {ph_vec3_scale(0.5, ph_vec3_add(f[0].d, f[1].d)),
                         ph_vec3_unit(by), ph_vec3_unit(up)};
  const double a = ph_vec3_dot(miss[0], f[0].d);
  const double b = ph_vec3_dot(miss[1], f[1].d);
  const double c = ph_vec3_dot(miss[0], f[0].n) - ph_vec3_dot(miss[1], f[1].n);
  const double left[] = {
      fabs(a + b) / 2,
      ph_check_larger(0, fabs(b - a) - rounding) / ph_vec3_abs(by),
      ph_check_larger(0, fabs(c) - rounding) / ph_vec3_abs(up)};
  double most = 0, found = 0;
  for (size_t i = 0; i < 3; i++) {
    const size_t j = (i + 1) % 3, k = (i + 2) % 3;
    const double area = ph_vec3_abs(ph_vec3_cross(row[j], row[k]));
    if (area > most) {
      most = area;
      found = ph_check_larger(left[j], left[k]);
    }
  }
  return found;
}

/* By how much the third equation of a pencil may miss, of the distance of the
 * points: the tolerance of the problem, or any that there may be. */
static double pencil_allowed(const struct ph_check_cone *cone) {
  const struct ph_problem *problem = cone->v->problem;
  const double said =
      problem ? problem->field[PH_F_DEGENERATE].number : DEGENERATE_MAX;
  return ph_check_larger(said, DEGENERATE);
}

/* The sphere: its centre is at the radius along both normals.  Of many that
 * touch at two lines, a pencil, one equation depends on the others, and may be
 * off by the tolerance that made it one. */
static void check_center(struct ph_check_cone *cone, size_t i) {
  const struct ph_pair *pair = &cone->curve->surface.pairs[i];
  const struct ph_check_frame f[] = {ph_check_cone_frame(cone, 2 * i, 0),
                                     ph_check_cone_frame(cone, 2 * i + 1, 1)};
  const double radius = ph_check_scaled(cone->v, pair->radius);
  const ph_vec3 center = ph_check_vector(cone->v, pair->center, 3);
  const double size = cone->v->scale.size + fabs(radius);
  const bool pencil = pair->which == PH_PAIR_PENCIL;
  const double allowed =
      (cone->frame + DEGENERATE) * size + ROUND * cone->v->scale.rounding;
  ph_vec3 miss[2];
  double off = 0;
  if (!isfinite(pair->radius)) {
    return;
  }
  for (size_t j = 0; j < 2; j++) {
    miss[j] = ph_vec3_sub(center, ph_vec3_along(f[j].c, radius, f[j].n));
    off = ph_check_larger(off, ph_vec3_abs(miss[j]));
  }
  if (pencil) {
    off -= pencil_allowed(cone) * ph_check_apart(f[0].c, f[1].c);
    off = ph_check_larger(off, fabs(ph_vec3_dot(miss[0], f[0].n)));
    off = ph_check_larger(off, fabs(ph_vec3_dot(miss[0], f[0].e)));
    off = ph_check_larger(off, fabs(ph_vec3_dot(miss[1], f[1].e)));
  }
  ph_check_number(cone->v, PH_CHECK_DIAGNOSTIC,
                  ph_check_of("pairs", i, "center"), off, 0, size, allowed);
  if (pencil) {
    ph_check_number(cone->v, PH_CHECK_DIAGNOSTIC,
                    ph_check_of("pairs", i, "center"),
                    lack_of(miss, f, UNIT * size), 0, size, allowed);
  }
}

/* A bound from 0 to infinity as a number from 0 to 1. */
static double part_of(double bound, double chord) {
  return bound <= DBL_MAX ? bound / (bound + chord) : 1;
}

/* Between which legs of the first arc the second has one, above 0: up to where
 * that is 0, and from where it is infinite. */
static void check_interval(struct ph_check_cone *cone, size_t i) {
  const struct ph_pair *pair = &cone->curve->surface.pairs[i];
  const struct ph_check_frame a = ph_check_cone_frame(cone, 2 * i, 0);
  const struct ph_check_frame b = ph_check_cone_frame(cone, 2 * i + 1, 1);
  const ph_vec3 v = ph_vec3_sub(b.c, a.c), by = ph_vec3_sub(b.d, a.d);
  const double chord = ph_vec3_abs(v), turn = ph_vec3_dot(by, by) / 2;
  const double ahead = ph_vec3_dot(v, a.d), back = -ph_vec3_dot(v, b.d);
  const double high = ahead > 0 ? chord * chord / 2 / ahead : HUGE_VAL;
  const double low = !(back > 0) ? 0 : turn > 0 ? back / turn : HUGE_VAL;
  const double found[] = {low < high ? low : high, low < high ? high : low};
  const double rounding =
      (UNIT + cone->frame) / (ph_vec3_abs(by) + DBL_EPSILON) +
      ROUND * cone->v->scale.rounding / chord;
  for (size_t j = 0; j < 2; j++) {
    ph_check_number(cone->v, PH_CHECK_DIAGNOSTIC,
                    ph_check_of("diagnostics.lambda_interval", i, NULL),
                    part_of(ph_check_scaled(cone->v, pair->interval[j]), chord),
                    part_of(found[j], chord), 1, rounding);
  }
}

static void check_pairs(struct ph_check_cone *cone) {
  for (size_t i = 0; i < cone->curve->surface.pairs_n; i++) {
    check_leg(cone, i, 0);
    check_leg(cone, i, 1);
    check_center(cone, i);
    check_interval(cone, i);
  }
}

/* ---- samples ------------------------------------------------------------- */

static void check_sample(struct ph_check_cone *cone, const char *list,
                         const struct ph_surface_sample *sample, size_t i) {
  struct ph_check *v = cone->v;
  const struct ph_strip *s = &cone->curve->surface.strips[sample->strip];
  const double u = sample->s / s->length, h = ph_check_scaled(v, sample->h);
  const struct ph_check_frame f = ph_check_cone_frame(cone, sample->strip, u);
  const struct ph_arc2 *arc = &s->development;
  const double turn = s->k * sample->s, angle = arc->angle + turn;
  const double part = ph_check_scaled(v, sample->s);
  const double chord =
      fabs(turn) > 0 ? part * sin(turn / 2) / (turn / 2) : part;
  const double middle = arc->angle + turn / 2;
  const double x = ph_check_scaled(v, arc->control_points[0][0]) +
                   chord * cos(middle) - h * sin(angle);
  const double y = ph_check_scaled(v, arc->control_points[0][1]) +
                   chord * sin(middle) + h * cos(angle);
  const double round =
      ROUND * (v->scale.rounding + DBL_EPSILON * fabs(h) + cone->flat);
  ph_check_miss(v, PH_CHECK_SAMPLE, ph_check_of(list, i, "point"),
                ph_check_apart(ph_check_vector(v, sample->point, 3),
                               ph_vec3_along(f.c, h, f.e)),
                v->scale.size, round, "is off the surface");
  ph_check_miss(v, PH_CHECK_SAMPLE, ph_check_of(list, i, "normal"),
                ph_check_apart(ph_vec3_get(sample->normal, 3), f.n), 1, UNIT,
                "is not the normal");
  ph_check_miss(v, PH_CHECK_SAMPLE, ph_check_of(list, i, "flat"),
                hypot(ph_check_scaled(v, sample->flat[0]) - x,
                      ph_check_scaled(v, sample->flat[1]) - y),
                v->scale.size, round + 4 * DBL_EPSILON * fabs(angle) * fabs(h),
                "is not the place in the development");
}

static void check_samples(struct ph_check_cone *cone,
                          const struct ph_surface_samples *grid) {
  for (size_t i = 0; i < grid->n && !ph_arena_late(cone->v->scratch); i++) {
    const struct ph_surface_sample *sample = &grid->v[i];
    if (sample->strip >= cone->curve->n) {
      ph_check_wrong(cone->v, PH_CHECK_SAMPLE,
                     ph_check_of("samples", i, "strip"), "is none");
      return;
    }
    check_sample(cone, "samples", sample, i);
  }
}

/* A place is on its strip, within the height. */
static void check_inside(const struct ph_check_cone *cone,
                         const struct ph_surface_sample *at, size_t i) {
  struct ph_check *v = cone->v;
  const struct ph_surface *surface = &cone->curve->surface;
  const struct ph_strip *s = &surface->strips[at->strip];
  const double u = at->s / s->length;
  const bool bare =
      !(fabs(surface->height[0]) > 0) && !(fabs(surface->height[1]) > 0);
  const double shift = bare ? 0 : s->shift[0] * (1 - u) + s->shift[1] * u;
  const double h = ph_check_scaled(v, at->h + shift);
  const double low = ph_check_scaled(v, surface->height[0]);
  const double high = ph_check_scaled(v, surface->height[1]);
  const double off = ph_check_larger(low - h, h - high);
  const double along = ph_check_larger(-u, u - 1);
  const double unit = v->scale.size + fabs(h);
  ph_check_miss(v, PH_CHECK_SAMPLE, ph_check_of("located", i, "h"),
                ph_check_larger(off, 0), unit,
                NEAR * unit + ROUND * cone->flat / DBL_EPSILON * NEAR,
                "is not within the height");
  ph_check_miss(v, PH_CHECK_SAMPLE, ph_check_of("located", i, "s"),
                ph_check_larger(along, 0), 1, UNIT, "is not on the strip");
}

/* Whether a place is of a point that was asked for. */
static bool is_asked(const struct ph_check_cone *cone,
                     const struct ph_located *at, size_t least) {
  const struct ph_value *flat = &cone->v->problem->field[PH_F_FLAT];
  const double *p;
  if (at->index < least || at->index >= flat->n || flat->dimension != 2) {
    return false;
  }
  p = flat->v + 2 * at->index;
  return !(fabs(p[0] - at->at.flat[0]) > 0) &&
         !(fabs(p[1] - at->at.flat[1]) > 0);
}

bool ph_check_cone_located(const struct ph_check_cone *cone,
                           const struct ph_located_list *list, size_t i) {
  const struct ph_located *l = &list->v[i];
  if (l->at.strip >= cone->curve->n) {
    ph_check_wrong(cone->v, PH_CHECK_SAMPLE, ph_check_of("located", i, "strip"),
                   "is none");
    return false;
  }
  if (cone->v->problem && !is_asked(cone, l, i ? l[-1].index + 1 : 0)) {
    ph_check_wrong(cone->v, PH_CHECK_SAMPLE, ph_check_of("located", i, "flat"),
                   "is not the point of flat with this index");
  }
  check_inside(cone, &l->at, i);
  return true;
}

static void check_located(struct ph_check_cone *cone,
                          const struct ph_located_list *list) {
  for (size_t i = 0; i < list->n && !ph_arena_late(cone->v->scratch) &&
                     ph_check_cone_located(cone, list, i);
       i++) {
    check_sample(cone, "located", &list->v[i].at, i);
  }
}

/* ---- parallel surfaces --------------------------------------------------- */

/* A strip against that at a distance. */
static void check_moved(struct ph_check_cone *cone, const struct ph_strip *from,
                        const struct ph_strip *to, double distance, size_t i) {
  struct ph_check *v = cone->v;
  const double factor = 1 - from->kn * distance;
  const double turn = hypot(from->k, from->kn) * from->length;
  const ph_vec3 n = ph_vec3_get(from->frame.normal, 3);
  const ph_vec3 wanted = ph_vec3_along(ph_check_vector(v, from->frame.point, 3),
                                       ph_check_scaled(v, distance), n);
  const double round =
      ROUND *
      (v->scale.rounding + DBL_EPSILON * fabs(ph_check_scaled(v, distance)));
  ph_check_miss(v, PH_CHECK_OFFSET, strip_of(i, "frame"),
                ph_check_apart(ph_check_vector(v, to->frame.point, 3), wanted),
                v->scale.size, round, "is not at the distance");
  ph_check_miss(v, PH_CHECK_OFFSET, strip_of(i, "frame"),
                ph_check_apart(ph_vec3_get(to->frame.normal, 3), n) +
                    ph_check_apart(ph_vec3_get(to->frame.ruling, 3),
                                   ph_vec3_get(from->frame.ruling, 3)),
                1, UNIT, "is not parallel");
  ph_check_number(v, PH_CHECK_OFFSET, strip_of(i, "length"), to->length,
                  factor * from->length, to->length, UNIT);
  ph_check_number(v, PH_CHECK_OFFSET, strip_of(i, "normal_curvature"),
                  to->kn * to->length, from->kn * from->length, 1,
                  UNIT + turn * UNIT);
  ph_check_number(v, PH_CHECK_OFFSET, strip_of(i, "geodesic_curvature"),
                  to->k * to->length, from->k * from->length, 1,
                  UNIT + turn * UNIT);
}

static enum ph_status check_parallel(struct ph_check_cone *cone,
                                     const struct ph_parallel *p) {
  struct ph_curve c = p->curve;
  struct ph_check_cone other = {cone->v, &c,   cone->frame,
                                0,       cone, fabs(p->distance)};
  const struct ph_curve *from = cone->curve;
  const struct ph_check_scale scale = cone->v->scale;
  enum ph_status status = PH_OK;
  c.closed = from->closed;
  c.surface.pairs_n = from->surface.pairs_n;
  c.surface.height[0] = from->surface.height[0];
  c.surface.height[1] = from->surface.height[1];
  if (c.n != from->n || !c.surface.strips) {
    ph_check_wrong(cone->v, PH_CHECK_OFFSET,
                   ph_check_of("strips", PH_CHECK_ONE, NULL),
                   "are not as many as those of the surface");
    return PH_OK;
  }
  if (!ph_check_cone_arrays(cone->v, &c)) {
    return PH_OK;
  }
  if (!ph_check_cone_scale(&other, &status)) {
    cone->v->scale = scale;
    return status;
  }
  ph_check_cone_strips(&other);
  check_samples(&other, &p->grid);
  cone->v->scale = scale;
  for (size_t i = 0; i < c.n; i++) {
    check_moved(cone, &from->surface.strips[i], &c.surface.strips[i],
                p->distance, i);
    check_strip(cone->v, &c.surface.strips[i], i);
  }
  check_measure(&other);
  return PH_OK;
}

enum ph_status ph_check_cone_told(struct ph_check_cone *cone) {
  enum ph_status status = PH_OK;
  struct ph_check *v = cone->v;
  const struct ph_result *claim = v->claim;
  for (size_t i = 0; i < cone->curve->n; i++) {
    check_strip(v, &cone->curve->surface.strips[i], i);
  }
  check_measure(cone);
  check_diagnostics(cone);
  check_pairs(cone);
  check_samples(cone, &claim->grid);
  check_located(cone, &claim->located);
  for (size_t i = 0; status == PH_OK && i < claim->parallels_n; i++) {
    ph_check_prefix(v, "offsets", i);
    status = check_parallel(cone, &claim->parallels[i]);
  }
  ph_check_prefix(v, NULL, 0);
  return status;
}
