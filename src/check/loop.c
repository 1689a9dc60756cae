/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Loops of offsets (see loop.h). */
#include "check/loop.h"

#include "check/clear.h"
#include "check/data.h"
#include "check/loop_piece.h"
#include "kernel/cplx.h"
#include "kernel/pi.h"

enum { N = PH_CHECK_SPOTS };

/* Where the nodes of pieces are not enough: nodes of the quadrature of one,
 * that is cut into so many parts, and places of one where its distance is
 * looked at. */
enum { NODES = 16, PARTS = 2, PLACES = 8 };

/* Pieces up to which the curve is looked at from three places of each. */
enum { FEW = 256 };

/* What a certificate allows. */
static const double CLOSURE = 1e-12, ERROR = 1e-10, TURN = 1e-6;

/* Above that, numbers are found again with more care: by halves, so many times
 * at most, that change them by no more than RATIO of it. */
static const double FINE = 1e-12, RATIO = 0.1;
/* Of a piece, one in another and in all: beside one place it is about one of
 * two each time.  What is no number agrees with nothing. */
enum { HALVINGS = 30, HALVINGS_ALL = 8 * HALVINGS };

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
  bool trimmed;
  struct ph_check_tree tree;
  struct ph_check_nodes nodes, many[PH_CHECK_MANY];
  struct ph_check_segment segment;
  struct ph_check_path path;
  double distance, size; /* at unit scale */
  double slack; /* by which pieces of ATPH offsets miss these, relative */
  double side;  /* of the distance of pieces along the curve */
  size_t loop, places;
};

struct sums {
  double length, area; /* the latter seen from the first point of the piece */
};

/* A piece, and its places. */
struct piece {
  struct ph_check_piece p;
  struct ph_check_spots at;
  struct sums sums;
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

/* ---- pieces ---------------------------------------------------------------
 */

static double turn_between(double ax, double ay, double bx, double by) {
  return ph_cplx_angle(ph_cplx_of(ax, ay), ph_cplx_of(bx, by));
}

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

/* Whether it is beside a segment, in its direction or against it. */
static bool is_beside(const struct piece *piece) {
  return piece->p.of->segment != PH_NO_SEGMENT;
}

static double side_beside(const struct context *c, const struct piece *piece) {
  const double *in = piece->p.of->interval;
  return in[1] < in[0] ? -c->side : c->side;
}

/* Places at the distance from a corner; of lines to a tip, no less. */
static void check_join(struct context *c, const struct piece *piece) {
  const struct ph_curve *curve = c->v->curve;
  const struct ph_loop_piece *of = piece->p.of;
  const bool end = of->join == curve->n;
  const double *p = ph_curve_points(curve, end ? curve->n - 1 : of->join);
  const ph_vec3 corner =
      ph_check_vector(c->v, p + (end ? 2 * curve->degree : 0), 2);
  for (size_t i = 0; i < N; i++) {
    const ph_vec3 at = {piece->at.x[i], piece->at.y[i], 0};
    const ph_vec3 o = ph_vec3_add(piece->p.first, at);
    double miss = c->distance - ph_check_apart(o, corner);
    miss = fabs(of->angle) > 0 ? fabs(miss) : miss;
    see(c, OF_DISTANCE, (miss - ph_check_reach(c->v, o)) / c->size);
  }
}

/* Of polynomials: the worst miss at the nodes. */
static double miss_of(const struct context *c, const struct piece *piece) {
  const struct ph_loop_piece *of = piece->p.of;
  const double side = side_beside(c, piece);
  struct ph_check_spots on;
  double worst = 0;
  if (c->v->curve->preimage.alpha) {
    return HUGE_VAL;
  }
  ph_check_segment_spots(c->v, &c->nodes, of->segment, of->interval,
                         piece->p.first, &on);
  for (size_t i = 0; i < N; i++) {
    const double over = side / sqrt(on.dx[i] * on.dx[i] + on.dy[i] * on.dy[i]);
    const double x = piece->at.x[i] - on.x[i] + over * on.dy[i];
    const double y = piece->at.y[i] - on.y[i] - over * on.dx[i];
    const double miss = x * x + y * y;
    worst = miss <= worst ? worst : miss;
  }
  return sqrt(worst);
}

/* Places at the distance from a segment along its normal. */
static void check_beside(struct context *c, const struct piece *piece) {
  const double *in = piece->p.of->interval;
  const double quick = miss_of(c, piece) / c->size;
  if (quick <= FINE) {
    see(c, OF_DISTANCE, quick);
    return;
  }
  ph_check_load(c->v, piece->p.of->segment, &c->segment);
  c->path.distance = side_beside(c, piece);
  for (size_t i = 0; i <= PLACES; i++) {
    const double x = (double)i / PLACES;
    const ph_vec3 o = ph_check_piece_at(&piece->p, x).o;
    const struct ph_check_local local =
        ph_check_local_at(&c->path, in[0] + x * (in[1] - in[0]));
    const double miss = ph_check_apart(o, local.point) - local.point_error;
    see(c, OF_DISTANCE, (miss - ph_check_reach(c->v, o)) / c->size);
  }
}

/* That no point of the curve is nearer: to all of the piece, or where some
 * might be, to places of it. */
static void check_clear(struct context *c, const struct piece *piece) {
  const size_t k = is_beside(piece) ? piece->p.of->segment : 0;
  const struct ph_check_company *company = NULL;
  if (is_beside(piece)) {
    company = &c->tree.company[side_beside(c, piece) < 0][k];
    if (ph_check_is_clear(&c->tree, &piece->p.box, k, company)) {
      return;
    }
  }
  for (size_t i = 1; i <= c->places; i++) {
    const double x = (double)i / (double)(c->places + 1);
    const ph_vec3 o = ph_check_piece_at(&piece->p, x).o;
    see(c, OF_DISTANCE, ph_check_nearer(&c->tree, o, k, company) / c->size);
  }
}

/* What places add to sums. */
static void add_places(const struct ph_check_nodes *nodes,
                       const struct ph_check_spots *at, struct sums *sums) {
  for (size_t i = 0; i < N; i++) {
    const double w = nodes->weight[i];
    sums->length += w * sqrt(at->dx[i] * at->dx[i] + at->dy[i] * at->dy[i]);
    sums->area += 0.5 * w * (at->x[i] * at->dy[i] - at->y[i] * at->dx[i]);
  }
}

static struct sums sums_of(const struct context *c,
                           const struct ph_check_piece *piece) {
  struct sums sums = {0, 0};
  struct ph_check_spots at;
  ph_check_piece_spots(&c->nodes, piece, &at);
  add_places(&c->nodes, &at, &sums);
  return sums;
}

/* The same by halves until they agree: near a place where the curve nearly
 * stops there may be many. */
static struct sums sums_by_halves(const struct context *c,
                                  const struct ph_check_piece *piece,
                                  struct sums whole, int depth, int *left) {
  const double most = RATIO * FINE * c->size;
  struct ph_check_piece half[2];
  struct sums part[2];
  ph_check_piece_halve(piece, half);
  for (size_t i = 0; i < 2; i++) {
    part[i] = sums_of(c, &half[i]);
  }
  if (depth > 0 && --*left > 0 &&
      !(fabs(part[0].length + part[1].length - whole.length) <= most &&
        fabs(part[0].area + part[1].area - whole.area) <= most * c->size)) {
    for (size_t i = 0; i < 2; i++) {
      part[i] = sums_by_halves(c, &half[i], part[i], depth - 1, left);
    }
  }
  return (struct sums){part[0].length + part[1].length,
                       part[0].area + part[1].area};
}

static struct sums sums_of_halves(const struct context *c,
                                  const struct ph_check_piece *piece) {
  int left = HALVINGS_ALL;
  return sums_by_halves(c, piece, sums_of(c, piece), HALVINGS, &left);
}

/* By the few nodes, where these give the length that is claimed, and so near
 * that the areas of all pieces add up, too; else by many, then by as many as it
 * takes. */
static struct sums measure(const struct context *c,
                           const struct ph_check_piece *piece,
                           const struct ph_check_spots *at, double claimed) {
  const double most = FINE * c->size;
  struct sums sums = {0, 0};
  add_places(&c->nodes, at, &sums);
  if (fabs(sums.length - claimed) <= RATIO * most) {
    return sums;
  }
  sums = (struct sums){0, 0};
  for (size_t i = 0; i < PH_CHECK_MANY; i++) {
    struct ph_check_spots more;
    ph_check_piece_spots(&c->many[i], piece, &more);
    add_places(&c->many[i], &more, &sums);
  }
  return fabs(sums.length - claimed) <= most ? sums : sums_of_halves(c, piece);
}

/* By how much the tangent turns along a piece: between any two nodes by less
 * than a half turn. */
static double turn_along(const struct piece *piece) {
  const double *x = piece->at.dx, *y = piece->at.dy;
  double turn = 0;
  bool ahead = true;
  for (size_t i = 1; i < N; i++) {
    ahead = ahead && x[0] * x[i] + y[0] * y[i] > 0;
  }
  if (ahead) {
    return turn_between(x[0], y[0], x[N - 1], y[N - 1]);
  }
  for (size_t i = 1; i < N; i++) {
    turn += turn_between(x[i - 1], y[i - 1], x[i], y[i]);
  }
  return turn;
}

static void load(const struct context *c, const struct ph_loop_piece *of,
                 struct piece *piece) {
  ph_check_piece_of(c->v, of, c->o->degree, &piece->p);
  ph_check_piece_spots(&c->nodes, &piece->p, &piece->at);
  piece->sums =
      measure(c, &piece->p, &piece->at, ph_check_scaled(c->v, of->length));
}

/* ---- loops ----------------------------------------------------------------
 */

/* By how much rounding of a piece's control points may turn it at an end: its
 * leg there may be as short as that. */
static double loose_at(const struct context *c, const struct ph_check_piece *p,
                       size_t end) {
  const size_t n = p->degree;
  const double w = end ? p->w[n - 1] / p->w[n] : p->w[1];
  const double leg = ph_vec3_abs(p->end[end]) / ((double)n * w);
  return 2 * ph_check_reach(c->v, end ? p->last : p->first) / leg;
}

/* Where one piece leads to another. */
static double check_joint(struct context *c, const struct ph_check_piece *a,
                          const struct ph_check_piece *b) {
  const double gap = ph_check_apart(a->last, b->first);
  const double turn =
      turn_between(a->end[1].x, a->end[1].y, b->end[0].x, b->end[0].y);
  const bool tip = a->of->segment == PH_NO_SEGMENT &&
                   a->of->join == b->of->join &&
                   b->of->segment == PH_NO_SEGMENT;
  see(c, OF_CLOSURE, gap / c->size);
  if (c->trimmed && fabs(turn) > PH_PI - BACK) { /* where parts touch */
    return turn * c->side < 0 ? turn + copysign(2 * PH_PI, c->side) : turn;
  }
  if (c->trimmed && !tip && turn * c->side < 0 &&
      fabs(turn) > BEND + loose_at(c, a, 1) + loose_at(c, b, 0)) {
    see(c, OF_TURN, fabs(turn));
  }
  return turn;
}

/* What a piece adds to the area, seen from a place. */
static double area_from(const struct piece *piece, ph_vec3 from) {
  const ph_vec3 to = ph_vec3_sub(piece->p.first, from);
  const ph_vec3 along = ph_vec3_sub(piece->p.last, piece->p.first);
  return piece->sums.area + 0.5 * (to.x * along.y - to.y * along.x);
}

/* The area of a loop, by as many nodes as it takes. */
static double area_of(const struct context *c, const struct ph_loop *loop,
                      ph_vec3 from) {
  struct piece piece;
  double area = 0;
  for (size_t i = 0; i < loop->n; i++) {
    ph_check_piece_of(c->v, &loop->pieces[i], c->o->degree, &piece.p);
    piece.sums = sums_of_halves(c, &piece.p);
    area += area_from(&piece, from);
  }
  return area;
}

/* The sums of a closed loop that are claimed. */
static void check_closed(struct context *c, const struct ph_loop *loop,
                         ph_vec3 from, double area, double turn) {
  const double claimed =
      ph_check_scaled(c->v, ph_check_scaled(c->v, loop->area));
  const double square = c->size * c->size;
  if (!(fabs(area - claimed) <= FINE * square)) {
    area = area_of(c, loop, from);
  }
  see(c, OF_AREA, fabs(area - claimed) / square);
  if (c->trimmed) {
    see(c, OF_TURN, fabs(fabs(turn) - 2 * PH_PI));
  }
}

static bool is_loop_sound(const struct context *c, const struct ph_loop *loop) {
  for (size_t i = 0; i < loop->n; i++) {
    if (!is_sound(c, &loop->pieces[i])) {
      return false;
    }
  }
  return loop->n > 0;
}

static void check_loop(struct context *c, const struct ph_loop *loop) {
  double length = 0, area = 0, turn = 0;
  struct piece piece[2];
  struct ph_check_piece first;
  if (!is_loop_sound(c, loop)) {
    broken(c);
    return;
  }
  load(c, &loop->pieces[0], &piece[0]);
  first = piece[0].p;
  for (size_t i = 0; i < loop->n; i++) {
    const struct piece *now = &piece[i % 2];
    struct piece *next = &piece[(i + 1) % 2];
    const double claimed = ph_check_scaled(c->v, now->p.of->length);
    see(c, OF_LENGTH, fabs(now->sums.length - claimed) / c->size);
    length += now->p.of->length;
    area += area_from(now, first.first);
    turn += turn_along(now);
    if (is_beside(now)) {
      check_beside(c, now);
    } else {
      check_join(c, now);
    }
    if (c->trimmed) {
      check_clear(c, now);
    }
    if (i + 1 < loop->n) {
      load(c, &loop->pieces[i + 1], next);
      turn += check_joint(c, &now->p, &next->p);
    } else if (loop->closed) {
      turn += check_joint(c, &now->p, &first);
    }
  }
  see(c, OF_LENGTH,
      fabs(ph_check_scaled(c->v, length - loop->length)) / c->size);
  if (loop->closed) {
    check_closed(c, loop, first.first, area, turn);
  }
}

/* To which side a piece is; 0: it does not say, or is nearer than rounding. */
static double side_of_piece(struct context *c,
                            const struct ph_loop_piece *piece) {
  const double *in = piece->interval;
  struct ph_check_local local;
  ph_vec3 at;
  double left;
  if (!is_sound(c, piece) || piece->segment == PH_NO_SEGMENT) {
    return piece->angle > 0 ? -c->distance : piece->angle < 0 ? c->distance : 0;
  }
  ph_check_load(c->v, piece->segment, &c->segment);
  c->path.distance = 0;
  local = ph_check_local_at(&c->path, in[0]);
  at = ph_check_vector(c->v, piece->control_points, 2);
  left = ph_vec3_cross(local.tangent, ph_vec3_sub(at, local.point)).z;
  return fabs(left) > local.point_error + ph_check_reach(c->v, at)
             ? copysign(c->distance, (in[1] - in[0]) * left)
             : 0;
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
  c.trimmed = loops->mode && *loops->mode == 't';
  if (o->degree + 1 > PH_CHECK_POINTS_MAX || o->degree < 1) {
    broken(&c);
    return PH_OK;
  }
  if (!ph_check_nodes_of(o->degree, &c.nodes, c.many)) {
    return ph_fail_memory(v->diag);
  }
  c.side = side_of(&c);
  for (size_t i = 0; i < loops->n; i++) {
    pieces += loops->v[i].n;
  }
  c.places = pieces <= FEW ? 3 : 1;
  if (c.trimmed && loops->n > 0) {
    status = ph_check_tree_of(v, c.distance, ERROR * c.size / 2, &c.tree);
  }
  for (size_t i = 0; status == PH_OK && i < loops->n; i++) {
    c.loop = i;
    check_loop(&c, &loops->v[i]);
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
      !ph_check_scale_of(curve->control_points, ph_curve_points_n(curve), 2,
                         &v.scale)) {
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
