/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Loops of offsets (see loop.h). */
#include "check/loop.h"

#include "check/clear.h"
#include "check/data.h"
#include "kernel/bern.h"
#include "kernel/pi.h"

/* Points of a piece at most; nodes of the quadrature of one, that is cut into
 * so many parts; places of one where the distance from its segment, and from
 * the whole curve is looked at. */
enum { POINTS_MAX = 16, NODES = 16, PARTS = 2, PLACES = 8 };

/* Pieces up to which the curve is looked at from three places of each. */
enum { FEW = 256 };

/* What a certificate allows. */
static const double CLOSURE = 1e-12, ERROR = 1e-10, TURN = 1e-6;

/* Where parts touch, they meet at such an angle, to either side. */
static const double BEND = 1e-4;

/* A tangent that turns by no less than a half turn and that turns back, to
 * either side. */
static const double BACK = 1e-3;

/* Pieces that are no exact offsets, as they say by how much, may be further
 * from them between the places where that was found, and lengths and areas with
 * them.
 */
static const double SLACK = 8;

/* Which error it is. */
enum { OF_CLOSURE, OF_DISTANCE, OF_LENGTH, OF_AREA, OF_TURN };

struct context {
  struct ph_check *v;
  const struct ph_offset *o;
  struct ph_check_found *found;
  struct ph_check_tree tree;
  struct ph_check_segment segment;
  struct ph_check_path path;
  struct ph_quad rule;
  double distance, size; /* at unit scale */
  double slack; /* by which pieces of ATPH offsets miss these, relative */
  double side;  /* of the distance of pieces along the curve */
  size_t loop, places;
};

/* A place of a piece, and the derivative there. */
struct at {
  ph_vec3 o, d;
};

static void see(struct context *c, int what, double error) {
  struct ph_check_found *f = c->found;
  double *worst[] = {&f->closure, &f->distance, &f->length, &f->area, &f->turn};
  error -= what == OF_CLOSURE || what == OF_TURN ? 0 : c->slack;
  if (!(error <= *worst[what])) {
    *worst[what] = error < HUGE_VAL ? error : HUGE_VAL;
    f->at[what] = c->loop;
  }
}

static void broken(struct context *c) {
  if (!c->found->broken) {
    c->found->broken = true;
    c->found->at[OF_CLOSURE] = c->loop;
  }
}

/* ---- places ---------------------------------------------------------------
 */

static ph_vec3 point_of(const struct context *c,
                        const struct ph_loop_piece *piece, size_t i) {
  return ph_check_vector(c->v, piece->control_points + 2 * i, 2);
}

/* Numerator and weight from the first control point on. */
static struct at place_at(const struct context *c,
                          const struct ph_loop_piece *piece, double x) {
  const size_t n = c->o->degree;
  const ph_vec3 first = point_of(c, piece, 0);
  double b[POINTS_MAX], lower[POINTS_MAX], w = 0, dw = 0;
  ph_vec3 sum = {0, 0, 0}, rate = {0, 0, 0};
  struct at at;
  ph_bern_basis(n, x, b);
  ph_bern_basis(n - 1, x, lower);
  for (size_t i = 0; i <= n; i++) {
    const ph_vec3 from = ph_vec3_sub(point_of(c, piece, i), first);
    const double d =
        (double)n * ((i > 0 ? lower[i - 1] : 0) - (i < n ? lower[i] : 0));
    const double weight = piece->weights[i] / piece->weights[0];
    sum = ph_vec3_along(sum, b[i] * weight, from);
    rate = ph_vec3_along(rate, d * weight, from);
    w += b[i] * weight;
    dw += d * weight;
  }
  sum = ph_vec3_scale(1 / w, sum);
  at.o = ph_vec3_add(first, sum);
  at.d = ph_vec3_scale(1 / w, ph_vec3_along(rate, -dw, sum));
  return at;
}

static double turn_between(ph_vec3 a, ph_vec3 b) {
  return atan2(a.x * b.y - a.y * b.x, a.x * b.x + a.y * b.y);
}

/* ---- pieces ---------------------------------------------------------------
 */

static bool is_sound(const struct context *c,
                     const struct ph_loop_piece *piece) {
  const size_t n = c->v->curve->n;
  const bool join = piece->segment == PH_NO_SEGMENT;
  const double *in = piece->interval;
  bool sound = join ? piece->join <= n && isfinite(piece->angle)
                    : piece->segment < n && in[0] >= 0 && in[0] <= 1 &&
                          in[1] >= 0 && in[1] <= 1;
  sound = sound && piece->control_points && piece->weights;
  for (size_t i = 0; sound && i <= c->o->degree; i++) {
    sound = piece->weights[i] > 0 && isfinite(piece->weights[i]);
  }
  return sound;
}

/* The distance from a corner, or from the segment along its normal. */
static void check_distance(struct context *c,
                           const struct ph_loop_piece *piece) {
  const double *in = piece->interval;
  const size_t n = c->v->curve->n;
  ph_vec3 corner = {0, 0, 0};
  if (piece->segment != PH_NO_SEGMENT) {
    ph_check_load(c->v, piece->segment, &c->segment);
    c->path.distance = in[1] < in[0] ? -c->side : c->side;
  } else {
    const bool end = piece->join == n;
    ph_check_load(c->v, end ? n - 1 : piece->join, &c->segment);
    corner = c->segment.end[end];
  }
  for (size_t i = 0; i <= PLACES; i++) {
    const double x = (double)i / PLACES;
    const struct at at = place_at(c, piece, x);
    double miss;
    if (piece->segment != PH_NO_SEGMENT) {
      const struct ph_check_local local =
          ph_check_local_at(&c->path, in[0] + x * (in[1] - in[0]));
      miss = ph_check_apart(at.o, local.point) - local.point_error;
    } else {
      miss = c->distance - ph_check_apart(at.o, corner);
      miss = fabs(piece->angle) > 0 ? fabs(miss) : miss;
    }
    see(c, OF_DISTANCE, (miss - ph_check_reach(c->v, at.o)) / c->size);
  }
}

/* That no point of the curve is nearer. */
static void check_clear(struct context *c, const struct ph_loop_piece *piece) {
  for (size_t i = 1; i <= c->places; i++) {
    const struct at at =
        place_at(c, piece, (double)i / (double)(c->places + 1));
    see(c, OF_DISTANCE,
        ph_check_nearer(&c->tree, at.o, c->distance, ERROR * c->size / 2) /
            c->size);
  }
}

/* Its length, and what it adds to the area, seen from a place. */
static double measure(struct context *c, const struct ph_loop_piece *piece,
                      ph_vec3 from, double *length) {
  double area = 0;
  *length = 0;
  for (size_t part = 0; part < PARTS; part++) {
    for (size_t i = 0; i < c->rule.n; i++) {
      const double x = ((double)part + c->rule.node[i]) / PARTS;
      const struct at at = place_at(c, piece, x);
      const ph_vec3 r = ph_vec3_sub(at.o, from);
      const double w = c->rule.weight[i] / PARTS;
      *length += w * ph_vec3_abs(at.d);
      area += 0.5 * w * (r.x * at.d.y - r.y * at.d.x);
    }
  }
  return area;
}

/* By how much the tangent turns along a piece. */
static double turn_along(const struct context *c,
                         const struct ph_loop_piece *piece) {
  double turn = 0;
  ph_vec3 before = place_at(c, piece, 0).d;
  for (size_t i = 1; i <= PLACES; i++) {
    const ph_vec3 now = place_at(c, piece, (double)i / PLACES).d;
    turn += turn_between(before, now);
    before = now;
  }
  return turn;
}

/* ---- loops ----------------------------------------------------------------
 */

/* Where one piece leads to another. */
static double check_joint(struct context *c, const struct ph_loop_piece *a,
                          const struct ph_loop_piece *b, bool trimmed) {
  const size_t last = c->o->degree;
  const double gap = ph_check_apart(point_of(c, a, last), point_of(c, b, 0));
  double turn = turn_between(place_at(c, a, 1).d, place_at(c, b, 0).d);
  const bool tip = a->segment == PH_NO_SEGMENT && a->join == b->join &&
                   b->segment == PH_NO_SEGMENT;
  see(c, OF_CLOSURE, gap / c->size);
  if (trimmed && fabs(turn) > PH_PI - BACK) { /* where parts touch */
    return turn * c->side < 0 ? turn + copysign(2 * PH_PI, c->side) : turn;
  }
  if (trimmed && !tip && turn * c->side < 0 && fabs(turn) > BEND) {
    see(c, OF_TURN, fabs(turn));
  }
  return turn;
}

static void check_loop(struct context *c, const struct ph_loop *loop,
                       bool trimmed) {
  double length = 0, area = 0, turn = 0;
  ph_vec3 from;
  if (loop->n == 0) {
    broken(c);
    return;
  }
  for (size_t i = 0; i < loop->n; i++) {
    if (!is_sound(c, &loop->pieces[i])) {
      broken(c);
      return;
    }
  }
  from = point_of(c, &loop->pieces[0], 0);
  for (size_t i = 0; i < loop->n; i++) {
    const struct ph_loop_piece *piece = &loop->pieces[i];
    double found;
    area += measure(c, piece, from, &found);
    see(c, OF_LENGTH,
        fabs(found - ph_check_scaled(c->v, piece->length)) / c->size);
    length += piece->length;
    check_distance(c, piece);
    turn += turn_along(c, piece);
    if (i + 1 < loop->n || loop->closed) {
      turn += check_joint(c, piece, &loop->pieces[(i + 1) % loop->n], trimmed);
    }
    if (trimmed) {
      check_clear(c, piece);
    }
  }
  see(c, OF_LENGTH,
      fabs(ph_check_scaled(c->v, length - loop->length)) / c->size);
  if (loop->closed) {
    const double claimed =
        ph_check_scaled(c->v, ph_check_scaled(c->v, loop->area));
    see(c, OF_AREA, fabs(area - claimed) / (c->size * c->size));
    if (trimmed) {
      see(c, OF_TURN, fabs(fabs(turn) - 2 * PH_PI));
    }
  }
}

/* To which side a piece is; 0: it does not say. */
static double side_of_piece(struct context *c,
                            const struct ph_loop_piece *piece) {
  const double *in = piece->interval;
  struct ph_check_local local;
  ph_vec3 from;
  if (!is_sound(c, piece) || piece->segment == PH_NO_SEGMENT) {
    return piece->angle > 0 ? -c->distance : piece->angle < 0 ? c->distance : 0;
  }
  ph_check_load(c->v, piece->segment, &c->segment);
  c->path.distance = 0;
  local = ph_check_local_at(&c->path, in[0]);
  from = ph_vec3_sub(point_of(c, piece, 0), local.point);
  return copysign(c->distance,
                  (in[1] - in[0]) * ph_vec3_cross(local.tangent, from).z);
}

/* To which side pieces along the curve are: that of the distance, or where both
 * sides are asked for, as pieces against it, or the first one, say. */
static double side_of(struct context *c) {
  const struct ph_loops *loops = &c->o->loops;
  const double given = copysign(c->distance, c->o->distance);
  double side = 0;
  if (loops->sides) {
    return copysign(c->distance, loops->sides[0].distance);
  }
  for (size_t i = 0; i < loops->n; i++) {
    for (size_t k = 0; k < loops->v[i].n; k++) {
      const struct ph_loop_piece *piece = &loops->v[i].pieces[k];
      if (piece->interval[1] < piece->interval[0]) {
        return -c->distance;
      }
      side = fabs(side) > 0 ? side : side_of_piece(c, piece);
    }
  }
  return fabs(side) > 0 ? side : given;
}

enum ph_status ph_check_loops(struct ph_check *v, const struct ph_offset *o,
                              struct ph_check_found *found) {
  const struct ph_loops *loops = &o->loops;
  const bool trimmed = loops->mode && *loops->mode == 't';
  struct context c = {.v = v, .o = o, .found = found};
  double length = 0, area = 0;
  size_t pieces = 0;
  enum ph_status status = PH_OK;
  *found = (struct ph_check_found){.broken = false};
  c.distance = fabs(ph_check_scaled(v, o->distance));
  c.size = 2 * v->scale.size + c.distance;
  c.path = (struct ph_check_path){.v = v, .s = &c.segment};
  if (loops->trimming.approximation > 0) {
    c.slack =
        SLACK * ph_check_scaled(v, loops->trimming.approximation) / c.size;
  }
  if (!ph_quad_gauss(&c.rule, NODES)) {
    return ph_fail_memory(v->diag);
  }
  if (o->degree + 1 > POINTS_MAX || o->degree < 1) {
    broken(&c);
    return PH_OK;
  }
  c.side = side_of(&c);
  for (size_t i = 0; i < loops->n; i++) {
    pieces += loops->v[i].n;
  }
  c.places = pieces <= FEW ? 3 : 1;
  if (trimmed) {
    status = ph_check_tree_of(v, &c.tree);
  }
  for (size_t i = 0; status == PH_OK && i < loops->n; i++) {
    c.loop = i;
    check_loop(&c, &loops->v[i], trimmed);
    length += loops->v[i].length;
    area += loops->v[i].area;
  }
  see(&c, OF_LENGTH, fabs(ph_check_scaled(v, length - o->length)) / c.size);
  if (!isnan(area)) {
    see(&c, OF_AREA,
        fabs(ph_check_scaled(v, ph_check_scaled(v, area - loops->area))) /
            (c.size * c.size));
  }
  return status;
}

/* ---- certificates ---------------------------------------------------------
 */

static enum ph_status conclude(struct ph_offset *o,
                               const struct ph_check_found *f,
                               struct ph_diag *diag) {
  const struct {
    const char *what;
    double error, most;
  } rows[] = {{"closure", f->closure, CLOSURE},
              {"distance", f->distance, ERROR},
              {"length", f->length, ERROR},
              {"area", f->area, ERROR},
              {"turn", f->turn, TURN}};
  for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
    if (f->broken || !(rows[i].error <= rows[i].most)) {
      const struct ph_loop *loop = &o->loops.v[f->at[i]];
      const double *p = loop->n ? loop->pieces[0].control_points : NULL;
      return ph_fail(diag, PH_E_NO_CONVERGENCE, NULL,
                     "the %s offset at distance %g is not certified: the "
                     "error of %s of its loop %zu from (%.6g, %.6g) is %.3g, "
                     "above %g",
                     o->loops.mode, o->distance, rows[i].what, f->at[i],
                     p ? p[0] : 0, p ? p[1] : 0, rows[i].error, rows[i].most);
    }
  }
  o->loops.trimming.distance_error = f->distance;
  o->loops.trimming.area_error = f->area;
  o->loops.trimming.certified = true;
  return PH_OK;
}

enum ph_status ph_certify_loops(const struct ph_curve *curve,
                                struct ph_offset *offsets, size_t n,
                                struct ph_arena *scratch,
                                struct ph_diag *diag) {
  struct ph_mark mark = ph_arena_mark(scratch);
  struct ph_check v = {.scratch = scratch,
                       .diag = diag,
                       .curve = curve,
                       .kind = &ph_check_kinds[curve->kind]};
  struct ph_check_space space;
  struct ph_check_data data;
  enum ph_status status;
  if (n == 0 || !offsets[0].loops.mode) {
    return PH_OK;
  }
  status = ph_check_begin(&v, &data, &space);
  if (status == PH_OK &&
      !ph_check_scale_of(curve->control_points, curve->n * (curve->degree + 1),
                         2, &v.scale)) {
    status = ph_fail(diag, PH_E_INTERNAL, "segments", "have no extent");
  }
  for (size_t i = 0; status == PH_OK && i < n; i++) {
    struct ph_check_found found;
    status = ph_check_loops(&v, &offsets[i], &found);
    status = status == PH_OK ? conclude(&offsets[i], &found, diag) : status;
  }
  ph_arena_release(scratch, mark);
  return status;
}
