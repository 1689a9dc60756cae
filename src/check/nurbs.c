/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * B-splines: knots that are those of Bezier pieces, at places of every piece
 * the curve or offset at equal parameters, or the piece of a loop, within their
 * error, which is looked for between these places, too.
 */
#include "check/checks.h"
#include "check/local.h"

#include "kernel/bern.h"
#include "kernel/golden.h"

/* Places of a piece, more than a rational curve of degree 9 has coefficients;
 * degrees. */
enum { PLACES = 20, DEGREE_MAX = 15 };

static bool wrong(struct ph_check *v, size_t i, const char *member,
                  const char *what) {
  ph_check_wrong(v, PH_CHECK_NURBS, ph_check_of("nurbs", i, member), what);
  return false;
}

/* Whether chain i has the arrays of Bezier pieces that meet. */
static bool is_whole(struct ph_check *v, const struct ph_spline *s, size_t i) {
  const size_t d = s->degree;
  if (d < 1 || d > DEGREE_MAX || s->n < d + 1 || (s->n - 1) % d != 0) {
    return wrong(v, i, "control_points", "are not as many as pieces have");
  }
  if (s->knots_n != s->n + d + 1) {
    return wrong(v, i, "knots", "are not as many as those of the points");
  }
  if (s->weights_n != 0 && s->weights_n != s->n) {
    return wrong(v, i, "weights", "are not as many as the points");
  }
  for (size_t j = 0; j < s->knots_n; j++) {
    const size_t joint = j == 0 ? 0 : (j - 1) / d;
    const size_t last = (s->n - 1) / d;
    const double *knots = s->knots,
                 x = knots[1 + d * (joint < last ? joint : last)];
    if (!(fabs(knots[j] - x) <= 0)) {
      return wrong(v, i, "knots", "are not degree times at each joint");
    }
  }
  for (size_t j = 0; j < s->weights_n; j++) {
    if (!(s->weights[j] > 0) || !isfinite(s->weights[j])) {
      return wrong(v, i, "weights", "are not all positive");
    }
  }
  return true;
}

ph_vec3 ph_check_rational(const double *b, size_t n, size_t dimension,
                          const double *p, const double *w) {
  const ph_vec3 first = ph_vec3_get(p, dimension);
  ph_vec3 sum = {0, 0, 0};
  double bottom = 0, largest = 0;
  for (size_t j = 0; w && j < n; j++) {
    largest = ph_check_larger(largest, fabs(w[j]));
  }
  for (size_t j = 0; j < n; j++) {
    double weight = w ? b[j] * (w[j] / largest) : b[j];
    ph_vec3 from_first =
        ph_vec3_sub(ph_vec3_get(p + dimension * j, dimension), first);
    sum = ph_vec3_along(sum, weight, from_first);
    bottom += weight;
  }
  return ph_vec3_along(first, 1 / bottom, sum);
}

/* The point of piece i of a chain at x in [0,1], at unit scale. */
static ph_vec3 point_of(const struct ph_check *v, const struct ph_spline *s,
                        size_t i, double x) {
  const size_t d = v->curve->dimension, at = s->degree * i;
  const double *w = s->weights_n ? s->weights + at : NULL;
  double b[DEGREE_MAX + 1], point[3] = {0, 0, 0};
  ph_bern_basis(s->degree, x, b);
  ph_vec3_put(
      ph_check_rational(b, s->degree + 1, d, s->control_points + d * at, w), d,
      point);
  return ph_check_vector(v, point, d);
}

static void compare(struct ph_check *v, size_t chain, ph_vec3 found,
                    ph_vec3 point, double allowance) {
  ph_check_miss(
      v, PH_CHECK_NURBS, ph_check_of("nurbs", chain, "control_points"),
      ph_check_apart(found, point), v->scale.size,
      allowance + ph_check_reach(v, found), "are away from the curve");
}

/* An approximation has an error; what is exact has none, and what is closed
 * ends where it begins. */
static bool is_honest(struct ph_check *v, const struct ph_spline *s, size_t i,
                      bool exact) {
  const size_t pieces = (s->n - 1) / s->degree;
  if (!(s->error >= 0) || (exact && s->error > 0)) {
    return wrong(v, i, "error",
                 exact ? "is not 0, as of such a curve" : "is below 0");
  }
  if (s->closed) {
    const ph_vec3 first = point_of(v, s, 0, 0);
    const ph_vec3 last = point_of(v, s, pieces - 1, 1);
    ph_check_miss(v, PH_CHECK_NURBS, ph_check_of("nurbs", i, "closed"),
                  ph_check_apart(first, last), v->scale.size,
                  2 * ph_check_reach(v, first),
                  "is said of one whose ends are apart");
  }
  return true;
}

struct walk {
  struct ph_check *v;
  struct ph_check_path path;
  struct ph_check_segment segment;
  size_t k; /* the segment */
};

/* Piece i of a chain, in the segment that is loaded. */
struct piece {
  const struct walk *walk;
  const struct ph_spline *s;
  size_t chain, i;
};

/* The curve at x of a piece, or what is at the distance from it there. */
static struct ph_check_local local_of(const struct piece *piece, double x,
                                      ph_vec3 found) {
  const double *of = piece->walk->v->curve->knots + piece->walk->k;
  const double *knot = piece->s->knots + 1 + piece->s->degree * piece->i;
  const double width = of[1] - of[0], from = (knot[0] - of[0]) / width;
  const double to = (knot[piece->s->degree] - of[0]) / width;
  const double u = from + x * (to - from), at = u < 0 ? 0 : u > 1 ? 1 : u;
  return ph_check_local_beside(&piece->walk->path, at, found);
}

static double check_at(const void *context, double x) {
  const struct piece *piece = context;
  struct ph_check *v = piece->walk->v;
  const double *of = v->curve->knots + piece->walk->k;
  const ph_vec3 found = point_of(v, piece->s, piece->i, x);
  const struct ph_check_local at = local_of(piece, x, found);
  const double speed = isnan(at.speed) ? 0 : at.speed; /* at rest */
  compare(v, piece->chain, found, at.point,
          at.point_error + speed * v->knot / (of[1] - of[0]) +
              PH_CHECK_CLOSELY * ph_check_scaled(v, piece->s->error));
  return ph_check_apart(found, at.point);
}

void ph_check_closely(double (*check)(const void *piece, double x),
                      const void *piece, double error) {
  if (error > 0) {
    ph_golden_greatest(check, piece, PLACES, error);
    return;
  }
  for (size_t i = 0; i <= PLACES; i++) {
    check(piece, (double)i / PLACES);
  }
}

/* The pieces of a chain, from one segment to the next. */
static void check_chain(struct walk *walk, const struct ph_spline *s,
                        size_t chain) {
  const size_t n = walk->v->curve->n;
  for (size_t i = 0; i < (s->n - 1) / s->degree; i++) {
    const double *knot = s->knots + 1 + s->degree * i;
    const double middle = 0.5 * (knot[0] + knot[s->degree]);
    if (!(knot[s->degree] > knot[0])) {
      wrong(walk->v, chain, "knots", "do not increase");
      return;
    }
    while (walk->k + 1 < n && !(middle < walk->v->curve->knots[walk->k + 1])) {
      ph_check_load(walk->v, ++walk->k, &walk->segment);
    }
    ph_check_closely(check_at, &(struct piece){walk, s, chain, i},
                     ph_check_scaled(walk->v, s->error));
  }
}

void ph_check_nurbs(struct ph_check *v, const struct ph_splines *of,
                    const struct ph_check_path *beside) {
  const double *knots = v->curve->knots;
  const bool exact = !v->kind->angles && !v->kind->sphere;
  struct walk walk = {.v = v};
  double from = knots[0];
  if (beside) {
    walk.path = *beside;
  }
  walk.path.v = v;
  walk.path.s = &walk.segment;
  ph_check_done(v, PH_CHECK_NURBS);
  ph_check_load(v, 0, &walk.segment);
  for (size_t i = 0; i < of->n && !ph_arena_late(v->scratch); i++) {
    const struct ph_spline *s = &of->v[i];
    if (!is_whole(v, s, i) || !is_honest(v, s, i, exact)) {
      return;
    }
    if (!(fabs(s->knots[0] - from) <= 0)) {
      wrong(v, i, "knots", "do not follow those of the chain before");
      return;
    }
    check_chain(&walk, s, i);
    from = s->knots[s->knots_n - 1];
  }
  if (!(fabs(from - knots[v->curve->n]) <= 0)) {
    wrong(v, of->n - 1, "knots", "are not those of the whole curve");
  }
}

/* A piece of a chain against one of the loop. */
static void check_loop_piece(struct ph_check *v, const struct ph_loop_piece *p,
                             const struct ph_spline *s, size_t chain,
                             size_t i) {
  for (size_t place = 0; place <= PLACES; place++) {
    const double x = (double)place / PLACES;
    double b[DEGREE_MAX + 1], point[3] = {0, 0, 0};
    ph_bern_basis(s->degree, x, b);
    ph_vec3_put(
        ph_check_rational(b, s->degree + 1, 2, p->control_points, p->weights),
        2, point);
    compare(v, chain, point_of(v, s, i, x), ph_check_vector(v, point, 2), 0);
  }
}

void ph_check_nurbs_loop(struct ph_check *v, const struct ph_loop *loop,
                         size_t degree) {
  size_t done = 0;
  ph_check_done(v, PH_CHECK_NURBS);
  for (size_t i = 0; i < loop->nurbs.n && !ph_arena_late(v->scratch); i++) {
    const struct ph_spline *s = &loop->nurbs.v[i];
    const size_t n = s->degree > 0 && s->n > 0 ? (s->n - 1) / s->degree : 0;
    if (!is_whole(v, s, i) || !is_honest(v, s, i, !v->kind->angles)) {
      return;
    }
    if (s->degree != degree || n > loop->n - done) {
      wrong(v, i, "control_points", "are not those of the pieces");
      return;
    }
    for (size_t j = 0; j < n; j++) {
      check_loop_piece(v, &loop->pieces[done++], s, i, j);
    }
  }
  if (done < loop->n) {
    wrong(v, loop->nurbs.n - 1, "knots", "are not those of the whole loop");
  }
}
