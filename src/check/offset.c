/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Offsets: at places of every piece they are at the distance, to the side that
 * they say (local.h), and where they turn back there is a cusp.
 *
 * Rational and trigonometric pieces are compared with the offset at equal
 * parameters; polynomial ones may be as far from it as they claim, which was
 * measured at some places of each.
 */
#include "check/dips.h"
#include "check/loop.h"

#include "kernel/bern.h"

#include <string.h>

/* Places of a piece, more than a quotient of degree 9 has coefficients, and of
 * a segment, between which a cusp is missed. */
enum { PLACES = 20, DEGREE_MAX = 15, SEARCH = 32 };

/* A cusp is printed to rounding of its parameter; slower changes of 1 - d kappa
 * are found less exactly.  What changes its sign there is the product of two
 * speeds, of the curve and of the offset along it, and rounded a few times: the
 * slower the curve is, the faster may the offset be. */
static const double CUSP = 1e-9, ROUND_CUSP = 64 * DBL_EPSILON;

/* Turns of loops, radians: what is less, is rounding of short pieces. */
static const double TURN = 1e-6;

struct context {
  struct ph_check *v;
  const struct ph_offset *o;
  double distance; /* at unit scale; on a sphere the angle */
  struct ph_check_segment segment;
  struct ph_check_path path;
  size_t cusp; /* of those listed, the last one that was looked for */
};

static void enter(struct context *c, size_t k) {
  ph_check_load(c->v, k, &c->segment);
  c->path.v = c->v;
  c->path.s = &c->segment;
}

static bool wrong(struct context *c, const char *list, size_t i,
                  const char *member, const char *what) {
  ph_check_wrong(c->v, PH_CHECK_OFFSET, ph_check_of(list, i, member), what);
  return false;
}

/* ---- pieces ------------------------------------------------------------- */

/* The normalised B-basis of <1, sin t, cos t, sin 2t, cos 2t>. */
static void trigonometric(double angle, double u, double *b) {
  double series[2][PH_CHECK_JET], c = cos(angle / 2);
  const double factor[] = {1, 4 * c, 4 * c * c + 2, 4 * c, 1};
  double p, q;
  ph_check_basis(angle, u, 1, series);
  p = series[0][0];
  q = series[1][0];
  b[0] = p * p * p * p;
  b[1] = factor[1] * p * p * p * q;
  b[2] = factor[2] * p * p * q * q;
  b[3] = factor[3] * p * q * q * q;
  b[4] = q * q * q * q;
}

static ph_vec3 quotient(const double *b, size_t dimension, const double *top,
                        const double *bottom) {
  ph_vec3 sum = {0, 0, 0};
  double below = 0;
  for (size_t j = 0; j < 5; j++) {
    sum = ph_vec3_along(sum, b[j], ph_vec3_get(top + dimension * j, dimension));
    below += b[j] * bottom[j];
  }
  return ph_vec3_scale(1 / below, sum);
}

static ph_vec3 scaled(const struct ph_check *v, ph_vec3 a) {
  const double x[3] = {a.x, a.y, a.z};
  return ph_check_vector(v, x, 3);
}

/* Piece i at places of its interval. */
static void check_rational(struct context *c, size_t i) {
  struct ph_check *v = c->v;
  const struct ph_offset *o = c->o;
  const double *in = o->interval + 2 * i;
  size_t n = o->degree + 1;
  const double *p = o->control_points + n * o->dimension * i;
  const double *w = o->weights + n * i;
  for (size_t j = 0; j < n; j++) {
    if (!(w[j] > 0) || !isfinite(w[j])) {
      wrong(c, "segments", i, "weights", "are not all positive");
      return;
    }
  }
  for (size_t place = 0; place <= PLACES; place++) {
    double x = (double)place / PLACES, u = in[0] + x * (in[1] - in[0]);
    double b[DEGREE_MAX + 1];
    struct ph_check_local at;
    ph_vec3 found;
    ph_bern_basis(o->degree, x, b);
    found = scaled(v, ph_check_rational(b, n, o->dimension, p, w));
    at = ph_check_local_beside(&c->path, u, found);
    ph_check_miss(v, PH_CHECK_OFFSET, ph_check_in(i, "control_points"),
                  ph_check_apart(found, at.point), v->scale.size,
                  at.point_error + ph_check_reach(v, found),
                  "are not at the distance");
  }
}

/* The quotient of an ATPH segment. */
static void check_quotient(struct context *c, size_t i) {
  struct ph_check *v = c->v;
  const struct ph_offset *o = c->o;
  const double *top = o->numerator + 5 * o->dimension * i;
  const double *bottom = o->denominator + 5 * i;
  for (size_t place = 0; place <= PLACES; place++) {
    double u = (double)place / PLACES, b[5];
    ph_vec3 point = ph_check_point(v, &c->segment, u), found;
    struct ph_check_local at;
    trigonometric(c->segment.angle, u, b);
    found =
        ph_vec3_add(point, scaled(v, quotient(b, o->dimension, top, bottom)));
    at = ph_check_local_beside(&c->path, u, found);
    ph_check_miss(v, PH_CHECK_OFFSET, ph_check_in(i, "numerator"),
                  ph_check_apart(found, at.point), v->scale.size,
                  at.point_error, "and denominator are not at the distance");
  }
}

/* Whether pieces follow each other along the segments, each of them covered. */
static bool are_whole(struct context *c, const char *list, size_t n,
                      const size_t *segment, const double *interval) {
  size_t k = 0;
  double from = 0;
  for (size_t i = 0; i < n; i++) {
    const double *in = interval + 2 * i;
    if (segment[i] != k || !(fabs(in[0] - from) <= 0) || !(in[1] > in[0]) ||
        !(in[1] <= 1)) {
      return wrong(c, list, i, "interval", "does not follow the one before");
    }
    from = in[1] < 1 ? in[1] : 0;
    k += !(in[1] < 1);
  }
  return k == c->v->curve->n ||
         wrong(c, list, PH_CHECK_ONE, NULL, "are not for the whole curve");
}

static void check_pieces(struct context *c) {
  const struct ph_offset *o = c->o;
  bool rational = o->control_points && o->weights;
  bool atph = o->numerator && o->denominator;
  if ((!rational && !atph) || o->degree > DEGREE_MAX ||
      o->dimension != c->v->curve->dimension || (atph && o->degree != 4) ||
      atph != c->v->kind->angles) {
    wrong(c, "segments", PH_CHECK_ONE, NULL, "are none of such an offset");
    return;
  }
  if (!are_whole(c, "segments", o->n, o->segment, o->interval)) {
    return;
  }
  for (size_t i = 0; i < o->n; i++) {
    if (i == 0 || o->segment[i] != o->segment[i - 1]) {
      enter(c, o->segment[i]);
    }
    if (atph) {
      check_quotient(c, i);
    } else {
      check_rational(c, i);
    }
  }
}

/* Places of a segment: where it is slowest, and on both sides of that where the
 * curve has turned by about a quarter. */
enum { SLOW = 3 * PH_CHECK_DIPS };

static size_t slow_places(const struct ph_check_segment *s, double u[SLOW]) {
  const struct ph_check_dips dips = ph_check_slow_of(s);
  size_t n = 0;
  for (size_t i = 0; i < dips.n; i++) {
    ph_vec3 jet[2];
    double width;
    ph_check_jet(s, dips.x[i], jet, 2);
    width = 2 * ph_vec3_abs(jet[0]) / ph_vec3_abs(jet[1]);
    for (int side = -1; side <= 1; side++) {
      u[n++] = dips.x[i] + side * width;
    }
  }
  return n;
}

/* Piece i at x in [0,1] of its interval. */
struct bezier {
  struct context *c;
  size_t i;
};

static double check_bezier_at(const void *context, double x) {
  const struct bezier *piece = context;
  struct context *c = piece->c;
  const struct ph_pieces *of = &c->o->pieces;
  const double *in = of->interval + 2 * piece->i;
  const size_t n = of->degree + 1, d = of->dimension;
  double b[DEGREE_MAX + 1], error;
  struct ph_check_local at;
  ph_vec3 found;
  ph_bern_basis(of->degree, x, b);
  found = scaled(
      c->v,
      ph_check_rational(b, n, d, of->control_points + n * d * piece->i, NULL));
  at = ph_check_local_beside(&c->path, in[0] + x * (in[1] - in[0]), found);
  error = ph_check_apart(found, at.point);
  ph_check_miss(
      c->v, PH_CHECK_OFFSET, ph_check_of("beziers", piece->i, "control_points"),
      error, c->v->scale.size,
      at.point_error + PH_CHECK_CLOSELY * ph_check_scaled(c->v, of->error),
      "are farther than they say");
  return error;
}

/* Bezier pieces against the offset, within their error. */
static void check_beziers(struct context *c) {
  struct ph_check *v = c->v;
  const struct ph_pieces *of = &c->o->pieces;
  double slow[SLOW];
  size_t slow_n = 0;
  if (of->degree > DEGREE_MAX || of->dimension != v->curve->dimension ||
      !are_whole(c, "beziers", of->n, of->segment, of->interval)) {
    return;
  }
  for (size_t i = 0; i < of->n && !ph_arena_late(v->scratch); i++) {
    const struct bezier piece = {c, i};
    const double *in = of->interval + 2 * i;
    if (i == 0 || of->segment[i] != of->segment[i - 1]) {
      enter(c, of->segment[i]);
      slow_n = slow_places(&c->segment, slow);
    }
    ph_check_closely(check_bezier_at, &piece, ph_check_scaled(v, of->error));
    for (size_t place = 0; place < slow_n; place++) {
      if (slow[place] > in[0] && slow[place] < in[1]) {
        check_bezier_at(&piece, (slow[place] - in[0]) / (in[1] - in[0]));
      }
    }
  }
}

/* ---- cusps -------------------------------------------------------------- */

/* A place along the curve, and which way the offset moves there, 0: it is not
 * certain. */
struct turn {
  size_t k;
  double u, along;
};

static struct turn turn_at(struct context *c, size_t k, double u) {
  struct ph_check_local at = ph_check_local_at(&c->path, u);
  struct turn turn = {k, u, at.along};
  if (!(fabs(at.along) > 4 * at.along_error)) {
    turn.along = 0;
  }
  return turn;
}

/* Whether a place is before another one along the curve. */
static bool is_before(size_t k, double u, size_t l, double w) {
  return k < l || (k == l && u < w);
}

/* Whether a cusp is listed from one place to the other; round the joint of a
 * closed curve if the latter is the first. */
static bool has_cusp(struct context *c, const struct turn *from,
                     const struct turn *to) {
  const struct ph_cusps *cusps = &c->o->cusps;
  const double *alpha = c->v->curve->preimage.alpha;
  bool round = is_before(to->k, to->u, from->k, from->u);
  /* in their order, in which they are looked for */
  for (size_t j = 0; j < cusps->n; j++) {
    size_t i = (c->cusp + j) % cusps->n, k = cusps->at[i].segment;
    double t = cusps->at[i].t, u;
    bool begun, over;
    u = alpha && k < c->v->curve->n ? t / alpha[k] : t;
    begun = !is_before(k, u, from->k, from->u);
    over = is_before(to->k, to->u, k, u);
    if (round ? begun || !over : begun && !over) {
      c->cusp = i;
      return true;
    }
  }
  return false;
}

static void check_turn(struct context *c, const struct turn *from,
                       const struct turn *to) {
  if (from->along * to->along < 0 && !has_cusp(c, from, to)) {
    ph_check_wrong(c->v, PH_CHECK_OFFSET,
                   ph_check_of("cusps", PH_CHECK_ONE, NULL),
                   "do not list one where the offset turns back");
  }
}

/* Changes of direction between places where it is certain.  In space frames
 * need not be those of the segment before, nor need offsets meet. */
static void search(struct context *c) {
  const struct turn none = {0, 0, 0};
  struct turn first = none, before = none;
  bool space = c->o->vector != NULL;
  for (size_t k = 0; k < c->v->curve->n && !ph_arena_late(c->v->scratch); k++) {
    enter(c, k);
    before = space ? none : before;
    for (size_t i = 0; i <= SEARCH; i++) {
      struct turn now = turn_at(c, k, (double)i / SEARCH);
      check_turn(c, &before, &now);
      before = fabs(now.along) > 0 ? now : before;
      first = fabs(first.along) > 0 ? first : now;
    }
  }
  if (c->v->curve->closed && !space) {
    check_turn(c, &before, &first);
  }
}

/* Whether the offset turns back at a joint, seen from one side, where the
 * curvature jumps; or may do so, as the other side is not certain. */
static bool turns_at_joint(struct context *c, size_t k, double u,
                           double along) {
  const struct ph_curve *curve = c->v->curve;
  bool back = u <= 0;
  size_t n = curve->n, beside = back ? (k + n - 1) % n : (k + 1) % n;
  if ((u > 0 && u < 1) || (beside == (back ? n - 1 : 0) && !curve->closed)) {
    return false;
  }
  enter(c, beside);
  return turn_at(c, beside, back ? 1 : 0).along * along <= 0;
}

/* A listed cusp: how far the offset is from turning back there. */
static void check_cusp(struct context *c, size_t i) {
  struct ph_check *v = c->v;
  const struct ph_place *at = &c->o->cusps.at[i];
  struct ph_check_local local;
  ph_vec3 first;
  double u, speed, slow;
  if (at->segment >= v->curve->n) {
    wrong(c, "cusps", i, "segment", "is not there");
    return;
  }
  enter(c, at->segment);
  u = at->t / c->segment.unit;
  if (!(u >= 0 && u <= 1)) {
    wrong(c, "cusps", i, "t", "is not in the segment");
    return;
  }
  local = ph_check_local_at(&c->path, u);
  speed = ph_check_larger(c->segment.speed, local.speed);
  ph_check_jet(&c->segment, u, &first, 1);
  slow = ph_vec3_abs(first) / c->segment.speed;
  if (isfinite(local.along) &&
      !turns_at_joint(c, at->segment, u, local.along)) {
    ph_check_miss(v, PH_CHECK_OFFSET, ph_check_of("cusps", i, "t"),
                  fabs(local.along), speed,
                  (CUSP + ROUND_CUSP / slow) * speed + local.along_error,
                  "is where the offset moves on");
  }
}

static void check_cusps(struct context *c) {
  for (size_t i = 0; i < c->o->cusps.n && !ph_arena_late(c->v->scratch); i++) {
    check_cusp(c, i);
  }
  search(c);
}

/* ---- all ---------------------------------------------------------------- */

/* Its distance and its side. */
static bool begin(struct context *c) {
  struct ph_check *v = c->v;
  const struct ph_curve *curve = v->curve;
  const char *vector = c->o->vector;
  bool space = curve->dimension == 3 && !v->kind->sphere;
  if (!isfinite(c->o->distance)) {
    return wrong(c, NULL, PH_CHECK_ONE, "distance", "is not finite");
  }
  if (!space && vector) {
    return wrong(c, NULL, PH_CHECK_ONE, "vector", "is of curves in space");
  }
  if (space &&
      !(vector && (strcmp(vector, "e2") == 0 || strcmp(vector, "e3") == 0))) {
    return wrong(c, NULL, PH_CHECK_ONE, "vector", "is neither e2 nor e3");
  }
  c->path.binormal = space && vector[1] == '3';
  c->path.cusps = &c->o->cusps;
  c->path.distance = v->kind->sphere ? c->o->distance / curve->sphere.radius
                                     : ph_check_scaled(v, c->o->distance);
  return true;
}

/* Loops, in place of all that. */
static void check_loops(struct ph_check *v, const struct ph_offset *o) {
  struct ph_check_found f;
  if (ph_check_loops(v, o, &f) != PH_OK) {
    return;
  }
  if (f.broken) {
    ph_check_wrong(v, PH_CHECK_OFFSET, ph_check_of("loops", f.at[0], "pieces"),
                   "are none of such an offset");
    return;
  }
  ph_check_miss(v, PH_CHECK_OFFSET, ph_check_of("loops", f.at[0], "pieces"),
                f.closure, 1, 0, "do not begin where the one before ends");
  ph_check_miss(v, PH_CHECK_OFFSET, ph_check_of("loops", f.at[1], "pieces"),
                f.distance, 1, 0, "are not at the distance from the curve");
  ph_check_miss(v, PH_CHECK_OFFSET, ph_check_of("loops", f.at[2], "length"),
                f.length, 1, 0, "is not that of its pieces");
  ph_check_miss(v, PH_CHECK_OFFSET, ph_check_of("loops", f.at[3], "area"),
                f.area, 1, 0, "is not what its pieces are around");
  ph_check_miss(v, PH_CHECK_OFFSET, ph_check_of("loops", f.at[4], "pieces"),
                f.turn < TURN ? 0 : f.turn, 1, 0,
                "do not turn once to one side");
}

void ph_check_offset(struct ph_check *v, const struct ph_offset *o) {
  struct context c = {.v = v, .o = o};
  double length = (double)NAN, error = 0,
         unit = ph_check_unscaled(v, v->scale.size);
  ph_check_done(v, PH_CHECK_OFFSET);
  if (v->kind->converted || !begin(&c)) {
    return; /* of the curve before it was converted */
  }
  if (o->loops.mode) {
    check_loops(v, o);
    for (size_t i = 0; i < o->loops.n; i++) {
      if (o->loops.v[i].nurbs.n > 0) {
        ph_check_nurbs_loop(v, &o->loops.v[i], o->degree);
      }
    }
    return;
  }
  if (o->n > 0 || !v->kind->sphere) {
    check_pieces(&c);
  }
  if (o->pieces.n > 0) {
    check_beziers(&c);
  }
  check_cusps(&c);
  ph_check_gaps(v, o, &c.path, &c.segment);
  if (o->nurbs.n > 0) {
    ph_check_nurbs(v, &o->nurbs, &c.path);
  }
  if (o->samples.n > 0) {
    ph_check_samples(v, &o->samples, &c.path, &length, &error);
    if (!isnan(length)) { /* else beside a point at rest */
      ph_check_number(v, PH_CHECK_OFFSET,
                      ph_check_of(NULL, PH_CHECK_ONE, "length"), o->length,
                      ph_check_unscaled(v, length), unit,
                      ph_check_unscaled(v, error));
    }
  }
}
