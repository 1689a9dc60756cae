/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Strips of circular cones: their frames, arcs and development (see cone.h). */
#include "check/cone.h"

#include "check/certify.h"
#include "check/data.h"
#include "check/panorama.h"
#include "check/share.h"

#include <float.h>
#include <string.h>

/* Of unit vectors, and of points in the rounding of coordinates. */
static const double UNIT = 64 * DBL_EPSILON;
enum { ROUND = 16, ROUND_ARC = 4 };

/* Strips of a part of a long surface, which take 1 ms. */
enum { PART = 512 };

/* What a certificate allows: of frames, of the development and of lengths. */
static const double FRAME = 1e-10, FLAT = 1e-11, LENGTH = 1e-11;

/* Data with noise have frames that miss so many times what they were taken to
 * have. */
static const double NOISE = 10;

static struct ph_check_where strip_of(size_t i, const char *member) {
  return ph_check_of("strips", i, member);
}

static const struct ph_strip *strip_at(const struct ph_check_cone *cone,
                                       size_t i) {
  return &cone->curve->surface.strips[i];
}

static double scaled(const struct ph_check_cone *cone, double x) {
  return ph_check_scaled(cone->v, x);
}

/* ---- frames -------------------------------------------------------------- */

/* a turned about the unit vector w by an angle, of which these are cosine and
 * sine. */
static ph_vec3 turned(ph_vec3 a, ph_vec3 w, double cosine, double sine) {
  const ph_vec3 b =
      ph_vec3_along(ph_vec3_scale(cosine, a), sine, ph_vec3_cross(w, a));
  return ph_vec3_along(b, (1 - cosine) * ph_vec3_dot(w, a), w);
}

struct ph_check_frame ph_check_cone_frame(const struct ph_check_cone *cone,
                                          size_t i, double u) {
  const struct ph_strip *s = strip_at(cone, i);
  struct ph_check_frame f = {ph_check_vector(cone->v, s->frame.point, 3),
                             ph_vec3_get(s->frame.ruling, 3),
                             ph_vec3_get(s->frame.tangent, 3),
                             ph_vec3_get(s->frame.normal, 3)};
  const double part = u * scaled(cone, s->length);
  const double k = s->k * s->length, kn = s->kn * s->length;
  const double angle = u * hypot(k, kn), half = angle / 2;
  const bool turns = angle > 0;
  const ph_vec3 w =
      turns ? ph_vec3_unit(ph_vec3_along(ph_vec3_scale(kn, f.e), -k, f.n))
            : f.n;
  const double chord = turns ? part * sin(half) / half : part;
  f.c = ph_vec3_along(f.c, chord, turned(f.d, w, cos(half), sin(half)));
  f.e = turned(f.e, w, cos(angle), sin(angle));
  f.d = turned(f.d, w, cos(angle), sin(angle));
  f.n = turned(f.n, w, cos(angle), sin(angle));
  return f;
}

/* By how much directions differ. */
static double differ(const struct ph_check_frame *a,
                     const struct ph_check_frame *b) {
  const double e = ph_check_apart(a->e, b->e), d = ph_check_apart(a->d, b->d);
  return ph_check_larger(ph_check_larger(e, d), ph_check_apart(a->n, b->n));
}

/* The length of the pair of strip i; beside it also what it is beside of, and
 * the distance, over which frames lead there. */
static double pair_length(const struct ph_check_cone *cone, size_t i) {
  const double length = scaled(cone, strip_at(cone, i & ~(size_t)1)->length) +
                        scaled(cone, strip_at(cone, i | 1)->length);
  return cone->beside ? length + pair_length(cone->beside, i) +
                            scaled(cone, cone->distance)
                      : length;
}

static void miss_direction(struct ph_check_cone *cone, size_t i, double by) {
  ph_check_miss(cone->v, PH_CHECK_FRAME, strip_of(i, "frame"), by, 1,
                cone->frame + UNIT, "leads to another frame than the next one");
}

static void miss_point(struct ph_check_cone *cone, size_t i, double by,
                       const char *what) {
  const double unit = pair_length(cone, i);
  ph_check_miss(cone->v, PH_CHECK_FRAME, strip_of(i, "frame"), by, unit,
                cone->frame * unit + ROUND * cone->v->scale.rounding, what);
}

/* A frame is one. */
static void check_frame(struct ph_check_cone *cone, size_t i,
                        const struct ph_check_frame *f) {
  const double length =
      ph_check_larger(fabs(ph_vec3_abs(f->e) - 1), fabs(ph_vec3_abs(f->d) - 1));
  const double normal = ph_check_apart(f->n, ph_vec3_cross(f->e, f->d));
  ph_check_miss(cone->v, PH_CHECK_FRAME, strip_of(i, "frame"),
                ph_check_larger(ph_check_larger(length, normal),
                                fabs(ph_vec3_dot(f->e, f->d))),
                1, UNIT, "is not orthonormal");
}

/* The weights of an arc of twice an angle. */
static void check_weights(struct ph_check_cone *cone, enum ph_check_id check,
                          struct ph_check_where where, const double weights[3],
                          double half) {
  const double ends =
      ph_check_larger(fabs(weights[0] - 1), fabs(weights[2] - 1));
  ph_check_miss(cone->v, check, where,
                ph_check_larger(fabs(weights[1] - cos(half)), ends), 1,
                cone->frame + UNIT, "has other weights than its angle");
}

/* The arc of the contact curve, as a rational one. */
static void check_arc(struct ph_check_cone *cone, size_t i,
                      const struct ph_check_frame *start,
                      const struct ph_check_frame *end) {
  const struct ph_strip *s = strip_at(cone, i);
  const double(*p)[3] = s->contact.control_points;
  const double weight = s->contact.weights[1];
  const ph_vec3 from = ph_check_vector(cone->v, p[0], 3);
  const ph_vec3 to = ph_check_vector(cone->v, p[2], 3);
  const ph_vec3 leg = ph_vec3_sub(ph_check_vector(cone->v, p[1], 3), from);
  const double half = ph_vec3_abs(ph_vec3_sub(end->c, start->c)) / 2;
  const double turn = hypot(s->k, s->kn) * s->length / 2;
  const ph_vec3 miss =
      ph_vec3_along(ph_vec3_scale(weight, leg), -half, start->d);
  check_weights(cone, PH_CHECK_FRAME, strip_of(i, "contact"),
                s->contact.weights, turn);
  miss_point(cone, i, ph_check_apart(from, start->c),
             "does not begin with its frame");
  miss_point(cone, i, ph_check_apart(to, end->c),
             "ends elsewhere than its arc");
  ph_check_miss(cone->v, PH_CHECK_FRAME, strip_of(i, "contact"),
                ph_vec3_abs(miss), half,
                (cone->frame + UNIT) * half + ROUND * cone->v->scale.rounding,
                "has another leg than its frame");
}

/* The frame where a strip ends against the next strip, or pair. */
static void check_joint(struct ph_check_cone *cone, size_t i, size_t next,
                        const struct ph_check_frame *end) {
  const struct ph_check_frame f = ph_check_cone_frame(cone, next, 0);
  const struct ph_strip *a = strip_at(cone, i), *b = strip_at(cone, next);
  const double by = scaled(cone, b->shift[0]) - scaled(cone, a->shift[1]);
  const ph_vec3 wanted = ph_vec3_along(end->c, by, end->e);
  /* what the ruling is turned by moves what is far along it */
  const double unit = pair_length(cone, i) + fabs(by);
  miss_direction(cone, i, differ(end, &f));
  ph_check_miss(cone->v, PH_CHECK_FRAME, strip_of(i, "frame"),
                ph_check_apart(wanted, f.c), unit,
                cone->frame * unit + UNIT * fabs(by) +
                    ROUND * cone->v->scale.rounding,
                "leads to another point than the next one");
  if (a->pair == b->pair) {
    miss_point(cone, i, fabs(by), "has another shift than the next one");
  }
}

/* ---- the development ----------------------------------------------------- */

/* An arc from its control points: length, and the angle by which it turns; and
 * by how much these change where points move by 1. */
struct arc {
  double chord, length, turn;
  double longer, turned;
};

/*
 * With a half the turn and c the chord the length is c a / sin a.  A point that
 * moves by 1 changes c by that, and a, between the leg and the chord, by the
 * inverses of both:
 *
 *   longer = a / sin a + (sin a - a cos a) / sin^2 a (1 + c / leg)
 *
 * which is 1 + a for a small angle, and without bound for arcs that go nearly
 * all around.
 */
static struct arc arc_of(double along, double across, double chord,
                         double leg) {
  const double angle = atan2(across, along), a = fabs(angle);
  const double sine = fabs(across) / chord;
  const double by_angle =
      sine > a / 2 && a < 0.01 ? a / 3 : (sine - a * cos(a)) / (sine * sine);
  struct arc arc = {chord, chord, 2 * angle, 1, 2 / leg + 2 / chord};
  if (fabs(across) > 0) {
    arc.length = chord * chord / across * angle;
    arc.longer = a / sine + by_angle * (1 + chord / leg);
  }
  return arc;
}

/* The contact curve, whose turn has no sign. */
static struct arc space_arc(const struct ph_check_cone *cone, size_t i) {
  const struct ph_arc3 *arc = &strip_at(cone, i)->contact;
  const ph_vec3 a = ph_check_vector(cone->v, arc->control_points[0], 3);
  const ph_vec3 b = ph_check_vector(cone->v, arc->control_points[1], 3);
  const ph_vec3 c = ph_check_vector(cone->v, arc->control_points[2], 3);
  const double sign = arc->weights[1] < 0 ? -1 : 1;
  const ph_vec3 leg = ph_vec3_sub(b, a), v = ph_vec3_sub(c, a);
  const ph_vec3 t = ph_vec3_scale(sign, ph_vec3_unit(leg));
  return arc_of(ph_vec3_dot(t, v), ph_vec3_abs(ph_vec3_cross(t, v)),
                ph_vec3_abs(v), ph_vec3_abs(leg));
}

/* The development, positive to the left. */
static struct arc flat_arc(const struct ph_check_cone *cone, size_t i) {
  const struct ph_arc2 *arc = &strip_at(cone, i)->development;
  const double(*p)[2] = arc->control_points;
  const double sign = arc->weights[1] < 0 ? -1 : 1;
  double t[2], v[2], size;
  for (size_t j = 0; j < 2; j++) {
    t[j] = sign * (scaled(cone, p[1][j]) - scaled(cone, p[0][j]));
    v[j] = scaled(cone, p[2][j]) - scaled(cone, p[0][j]);
  }
  size = hypot(t[0], t[1]);
  return arc_of((t[0] * v[0] + t[1] * v[1]) / size,
                (t[0] * v[1] - t[1] * v[0]) / size, hypot(v[0], v[1]), size);
}

static void miss_flat(struct ph_check_cone *cone, size_t i, double by,
                      double unit, double allowed, const char *what) {
  const double own = cone->v->error ? FLAT * unit : 0;
  ph_check_miss(cone->v, PH_CHECK_ISOMETRY, strip_of(i, "development"), by,
                unit, allowed + own + UNIT * unit, what);
}

/* Where a development begins, from where the one before ended. */
static void check_flat_joint(struct ph_check_cone *cone, size_t i) {
  const struct ph_strip *a = strip_at(cone, i - 1), *b = strip_at(cone, i);
  const double *end = a->development.control_points[2];
  const double *start = b->development.control_points[0];
  const double by = scaled(cone, b->shift[0]) - scaled(cone, a->shift[1]);
  const double angle = b->development.angle;
  const double x = scaled(cone, start[0]) - scaled(cone, end[0]);
  const double y = scaled(cone, start[1]) - scaled(cone, end[1]);
  miss_flat(cone, i, hypot(x + by * sin(angle), y - by * cos(angle)),
            pair_length(cone, i),
            ROUND * cone->flat + fabs(by) * DBL_EPSILON * (4 + fabs(angle)),
            "begins elsewhere than the one before ends");
  miss_flat(cone, i, fabs(angle - a->development.angle - a->k * a->length), 1,
            4 * DBL_EPSILON * fabs(angle), "begins in another direction");
}

static void check_flat(struct ph_check_cone *cone, size_t i) {
  const struct ph_strip *s = strip_at(cone, i);
  const double(*p)[2] = s->development.control_points;
  const double length = scaled(cone, s->length), turn = s->k * s->length;
  const double angle = s->development.angle;
  const double sign = s->development.weights[1] < 0 ? -1 : 1;
  const double x = sign * (scaled(cone, p[1][0]) - scaled(cone, p[0][0]));
  const double y = sign * (scaled(cone, p[1][1]) - scaled(cone, p[0][1]));
  const struct arc flat = flat_arc(cone, i), space = space_arc(cone, i);
  const double rounding = cone->v->scale.rounding;
  const double longer =
      ROUND_ARC * (cone->flat * flat.longer + rounding * space.longer);
  ph_check_miss(cone->v, PH_CHECK_LENGTH, strip_of(i, "length"),
                fabs(space.length - length), length,
                (cone->v->error ? LENGTH * length : 0) + UNIT * length +
                    ROUND_ARC * rounding * space.longer,
                "is not the length of the arc");
  miss_flat(cone, i, fabs(flat.length - space.length), length, longer,
            "is longer or shorter than the contact curve");
  miss_flat(cone, i, fabs(flat.turn - turn), 1,
            ROUND_ARC * cone->flat * flat.turned,
            "turns by another angle than the contact curve");
  miss_flat(cone, i, fabs(y * cos(angle) - x * sin(angle)) / hypot(x, y), 1,
            ROUND * cone->flat / length + 4 * DBL_EPSILON * fabs(angle),
            "does not begin along its angle");
  miss_flat(
      cone, i,
      fabs(hypot(x, y) * fabs(s->development.weights[1]) - flat.chord / 2),
      length, ROUND * (cone->flat + rounding),
      "has another leg than its angle");
  check_weights(cone, PH_CHECK_ISOMETRY, strip_of(i, "development"),
                s->development.weights, turn / 2);
}

/* ---- all strips ---------------------------------------------------------- */

static void check_strips(const void *context, struct ph_check *v, size_t first,
                         size_t n) {
  struct ph_check_cone cone = *(const struct ph_check_cone *)context;
  const struct ph_curve *c = cone.curve;
  cone.v = v;
  for (size_t i = first; i < n && !ph_arena_late(v->scratch); i++) {
    const struct ph_check_frame start = ph_check_cone_frame(&cone, i, 0);
    const struct ph_check_frame end = ph_check_cone_frame(&cone, i, 1);
    check_frame(&cone, i, &start);
    check_arc(&cone, i, &start, &end);
    if (i + 1 < c->n || c->closed) {
      check_joint(&cone, i, i + 1 < c->n ? i + 1 : 0, &end);
    }
    check_flat(&cone, i);
    if (i > 0) {
      check_flat_joint(&cone, i);
    }
  }
}

void ph_check_cone_strips(struct ph_check_cone *cone) {
  const struct ph_curve *c = cone->curve;
  cone->flat = 0;
  for (size_t i = 0; i < c->n; i++) {
    for (size_t j = 0; j < 6; j++) {
      const double x =
          strip_at(cone, i)->development.control_points[j / 2][j % 2];
      cone->flat = j == 2 || j == 3 /* the leg of a half circle is far */
                       ? cone->flat
                       : ph_check_larger(cone->flat, fabs(scaled(cone, x)));
    }
  }
  cone->flat *= DBL_EPSILON;
  ph_check_share(cone->v, c->n, PART, check_strips, cone);
}

/* ---- the problem --------------------------------------------------------- */

ph_vec3 ph_check_cone_point(const struct ph_check *v, size_t j) {
  const struct ph_value *by = &v->problem->field[PH_F_TRANSLATE];
  const double *p = v->problem->field[PH_F_POINTS].v + 3 * j;
  double moved[3];
  for (size_t i = 0; i < 3; i++) {
    moved[i] = p[i] + (by->n == 3 ? by->v[i] : 0);
  }
  return ph_check_vector(v, moved, 3);
}

/* The frame of contact element j, its point the given one. */
static struct ph_check_frame element(const struct ph_check_cone *cone,
                                     size_t j) {
  const struct ph_problem *p = cone->v->problem;
  struct ph_check_frame f;
  f.c = ph_check_cone_point(cone->v, j);
  f.e = ph_check_direction(p->field[PH_F_RULINGS].v + 3 * j, 3);
  f.d = ph_check_direction(p->field[PH_F_TANGENTS].v + 3 * j, 3);
  f.d = ph_vec3_unit(ph_vec3_normal(f.d, f.e));
  f.n = ph_vec3_cross(f.e, f.d);
  return f;
}

/* An end of a pair against its element. */
static void check_element(struct ph_check_cone *cone, size_t i, size_t j,
                          size_t end) {
  const struct ph_check_frame f = element(cone, j);
  const struct ph_check_frame found = ph_check_cone_frame(cone, i, (double)end);
  const double shift = scaled(cone, strip_at(cone, i)->shift[end]);
  const ph_vec3 wanted = ph_vec3_along(f.c, shift, f.e);
  const double apart = ph_check_apart(wanted, found.c);
  const double rounding =
      ROUND * (cone->v->scale.rounding + DBL_EPSILON * fabs(shift));
  const double unit = pair_length(cone, i);
  const double allowed = cone->frame * unit + rounding;
  miss_direction(cone, i, differ(&f, &found));
  ph_check_miss(cone->v, PH_CHECK_FRAME, strip_of(i, "frame"), apart, unit,
                allowed, "is off the ruling that is given");
  ph_check_miss(cone->v, PH_CHECK_INTERPOLATION, strip_of(i, "frame"), apart,
                cone->v->scale.size, allowed,
                "is off the point that is given, by more than the shift");
}

/* How many elements there are, for so many pairs. */
static size_t elements_of(const struct ph_curve *c) {
  return c->n / 2 + !c->closed;
}

static void check_pairs(const void *context, struct ph_check *v, size_t first,
                        size_t n) {
  struct ph_check_cone cone = *(const struct ph_check_cone *)context;
  const size_t elements = elements_of(cone.curve);
  cone.v = v;
  for (size_t i = first; i < n && !ph_arena_late(v->scratch); i++) {
    check_element(&cone, 2 * i, i, 0);
    check_element(&cone, 2 * i + 1, i + 1 < elements ? i + 1 : 0, 1);
  }
}

/* interpolation_error, and frames, of the problem. */
static void check_elements(struct ph_check_cone *cone) {
  const struct ph_problem *p = cone->v->problem;
  const struct ph_curve *c = cone->curve;
  const size_t elements = elements_of(c);
  const struct ph_value *rulings = &p->field[PH_F_RULINGS];
  const struct ph_value *tangents = &p->field[PH_F_TANGENTS];
  const struct ph_value *points = &p->field[PH_F_POINTS];
  if (c->closed != p->field[PH_F_CLOSED].flag ||
      (points->n != elements && !(c->closed && points->n == elements + 1)) ||
      rulings->n < elements || tangents->n < elements ||
      points->dimension != 3 || rulings->dimension != 3 ||
      tangents->dimension != 3) {
    ph_check_wrong(cone->v, PH_CHECK_SHAPE,
                   ph_check_of("strips", PH_CHECK_ONE, NULL),
                   "are not two for each pair of contact elements of the "
                   "problem");
    return;
  }
  ph_check_share(cone->v, c->n / 2, PART, check_pairs, cone);
}

/* ---- certificate --------------------------------------------------------- */

/* What frames may miss by: data with noise are taken as they are meant. */
static double allowed_of(const struct ph_check *v) {
  const struct ph_value *noise =
      v->problem ? &v->problem->field[PH_F_DEGENERATE] : NULL;
  const double own = v->error ? FRAME : 0;
  return noise && noise->kind != PH_ABSENT
             ? ph_check_larger(NOISE * noise->number, own)
             : own;
}

bool ph_check_cone_scale(struct ph_check_cone *cone, enum ph_status *status) {
  struct ph_check *v = cone->v;
  const struct ph_curve *c = cone->curve;
  double *p = ph_arena_array(v->scratch, 6 * c->n, sizeof *p);
  if (!p) {
    *status = ph_fail_memory(v->diag);
    return false;
  }
  for (size_t i = 0; i < c->n; i++) {
    const struct ph_arc3 *arc = &c->surface.strips[i].contact;
    memcpy(p + 6 * i, arc->control_points[0], 3 * sizeof *p);
    memcpy(p + 6 * i + 3, arc->control_points[2], 3 * sizeof *p);
  }
  if (!ph_check_scale_of(p, 2 * c->n, 3, &v->scale)) {
    ph_check_wrong(v, PH_CHECK_SHAPE, ph_check_of("strips", PH_CHECK_ONE, NULL),
                   "have no extent");
    return false;
  }
  return true;
}

static bool is_general(const struct ph_curve *curve) {
  return curve->surface.strips[0].method != PH_STRIP_CIRCULAR;
}

enum ph_status ph_check_cone(struct ph_check *v,
                             struct ph_diagnostics *diagnostics) {
  static const struct {
    enum ph_check_id check;
    enum ph_diagnostic what;
  } told[] = {{PH_CHECK_INTERPOLATION, PH_D_INTERPOLATION_ERROR},
              {PH_CHECK_TANGENT, PH_D_TANGENT_ERROR},
              {PH_CHECK_PYTHAGOREAN, PH_D_PYTHAGOREAN_ERROR},
              {PH_CHECK_CONTINUITY, PH_D_CONTINUITY_ERROR},
              {PH_CHECK_FRAME, PH_D_FRAME_ERROR},
              {PH_CHECK_ISOMETRY, PH_D_ISOMETRY_ERROR},
              {PH_CHECK_LENGTH, PH_D_LENGTH_ERROR}};
  enum { TOLD = sizeof told / sizeof told[0] };
  struct ph_check_error error[PH_CHECK_N] = {{.done = false}};
  const struct ph_check_error *list[TOLD];
  struct ph_check_cone cone = {.v = v, .curve = v->curve};
  enum ph_status status = PH_OK;
  v->error = error;
  if (is_general(v->curve)) {
    status = ph_check_cone_general(v);
  } else if (ph_check_cone_arrays(v, v->curve) &&
             ph_check_cone_scale(&cone, &status)) {
    cone.frame = allowed_of(v);
    ph_check_cone_strips(&cone);
    check_elements(&cone);
  }
  if (status != PH_OK) {
    return status;
  }
  for (size_t i = 0; i < TOLD; i++) {
    error[told[i].check].what = told[i].what;
    error[told[i].check].list = "strips";
    list[i] = error[told[i].check].done ? &error[told[i].check] : NULL;
  }
  return v->status == PH_OK
             ? ph_check_conclude(list, TOLD, diagnostics, v->diag)
             : v->status;
}

/* ---- panoramas ----------------------------------------------------------- */

/* A strip that is looked at. */
struct sheet {
  const struct ph_check_cone *cone;
  size_t i;
};

static size_t load(void *context, size_t i) {
  enum { STEPS = 48 };
  ((struct sheet *)context)->i = i;
  return STEPS;
}

static struct ph_check_ruling ruling_at(void *context, double u) {
  const struct sheet *sheet = context;
  const struct ph_strip *s = strip_at(sheet->cone, sheet->i);
  const struct ph_check_frame f = ph_check_cone_frame(sheet->cone, sheet->i, u);
  const struct ph_arc2 *arc = &s->development;
  const double turn = s->k * s->length * u, half = turn / 2;
  const double part = u * scaled(sheet->cone, s->length);
  const double chord = fabs(turn) > 0 ? part * sin(half) / half : part;
  const double *start = arc->control_points[0];
  return (struct ph_check_ruling){
      scaled(sheet->cone, start[0]) + chord * cos(arc->angle + half),
      scaled(sheet->cone, start[1]) + chord * sin(arc->angle + half),
      arc->angle + turn, f.c, f.e};
}

static enum ph_status check_panorama(const struct ph_check_cone *cone) {
  struct sheet context = {cone, 0};
  const struct ph_check_sheet sheet = {&context, load, ruling_at};
  return ph_check_panorama(cone->v, &sheet);
}

/* ---- verification -------------------------------------------------------- */

enum ph_status ph_check_surface(struct ph_check *v) {
  struct ph_check_cone cone = {.v = v, .curve = v->curve};
  enum ph_status status = PH_OK;
  if (!ph_check_is_promised(v)) {
    return PH_OK;
  }
  if (is_general(v->curve)) {
    return ph_check_cone_general(v);
  }
  if (!ph_check_cone_arrays(v, v->curve) ||
      !ph_check_cone_scale(&cone, &status)) {
    return status;
  }
  cone.frame = allowed_of(v);
  ph_check_cone_strips(&cone);
  if (v->problem) {
    check_elements(&cone);
  }
  status = ph_check_cone_told(&cone);
  if (status == PH_OK) {
    status = check_panorama(&cone);
  }
  return ph_arena_late(v->scratch) ? ph_fail_memory(v->diag) : status;
}
