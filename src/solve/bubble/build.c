/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * All patches into a surface (see bubble.h), its area and volume by a Gauss
 * rule on each patch, and what is told of them.
 */
#include "base/sum.h"
#include "base/team.h"
#include "curve/surface/places.h"
#include "kernel/quad.h"
#include "solve/bubble/bubble.h"

#include <math.h>
#include <pthread.h>
#include <string.h>

/* Patches or edges that a thread takes at once, and as many as are worth a
 * thread. */
enum { CHUNK = 64, WORTH = 256 };

/* Places of an edge where its ribbon is looked at. */
enum { PLACES = 33 };

/* |p'| over the length of the edge, and the cosine of gradient and normal, must
 * be more. */
static const double SPEED = 1e-3, COSINE = 0.05;

/* Nodes of a patch by each parameter: those of a Gauss rule, and both ends. */
enum { GAUSS = 16, NODES = GAUSS + 2 };

struct nodes {
  struct ph_patch_rows rows[NODES];
};

/* The same of exact patches, and the sides of one of them there. */
struct exact_nodes {
  struct ph_exact_rows rows[NODES];
  struct ph_cross by_u[NODES][2], by_v[NODES][2];
};

/* What a patch adds. */
struct measure {
  double area, volume; /* from the first point of the mesh */
  double turn;         /* positive: its normal mostly is that of the points */
  bool out, in;        /* whether its normal is that of the points somewhere,
                          or the opposite */
  double miss;         /* of its blending functions, */
  size_t degree;       /* which have this one */
};

struct builder {
  const struct ph_bubble_data *data;
  struct ph_pow2 from_unit;
  struct ph_arena *arena, *scratch;
  struct ph_diag *diag;
  struct ph_patchwork *work;
  struct ph_ribbon *ribbons;
  struct ph_blends *blends; /* shared, as are nodes, of all threads */
  struct ph_bubble_patch *patch;
  struct ph_patch_line *line;
  double *net, *points; /* at unit scale */
  struct ph_quad rule;
  struct nodes **nodes;      /* [PH_PATCH_DEGREE_MAX + 1] or NULL */
  struct exact_nodes *exact; /* NULL: it is polynomial */
  struct ph_curve *curve;
  struct measure *measures; /* [curve.n] */
  signed char *sign;        /* [curve.n] of faces, as ph_mesh_orient has them */
  bool two_sided;           /* it is closed, and has them */
  struct team *team;
};

/* What threads share that change it. */
struct team {
  pthread_mutex_t lock; /* of the arena */
  struct builder *builders;
  size_t failed; /* the first patch that failed; SIZE_MAX: none */
  enum ph_status status;
  struct ph_diag diag;
};

/* ---- ribbons ------------------------------------------------------------- */

/* Why an edge has no good ribbon, or NULL. */
static const char *fault_of(const struct ph_bubble_data *data,
                            const struct ph_mesh_edge *edge,
                            const struct ph_ribbon *ribbon,
                            const struct ph_ribbon_rows *rows) {
  const struct ph_quadric *a = &data->at[edge->point[0]];
  const struct ph_quadric *b = &data->at[edge->point[1]];
  const double length = ph_vec3_abs(ph_vec3_sub(b->p, a->p));
  struct ph_side side = {.p = {a->p, b->p}, .g = {a->g, b->g}};
  bool moves = true, fits = true;
  side.ribbon = *ribbon;
  for (size_t i = 0; i < PLACES; i++) {
    struct ph_cross cross;
    ph_side_at(&side, data->continuity, &rows[i], 0, &cross);
    moves = moves && cross.speed >= SPEED * length;
    fits = fits && cross.cosine > COSINE;
  }
  return !moves ? "is parallel to a normal at one of its ends"
         : fits ? NULL
                : "has normals at its ends that are too far apart, or on "
                  "opposite sides of the surface";
}

/* Ribbons on their way. */
struct weaver {
  const struct builder *b;
  struct ph_ribbon_rows *rows; /* [PLACES] */
  atomic_size_t fault;         /* the first edge that has one; SIZE_MAX: none */
};

static bool weave(void *context, size_t thread, size_t first, size_t end) {
  struct weaver *w = context;
  const struct ph_bubble_data *d = w->b->data;
  for (size_t e = first; e < end; e++) {
    const struct ph_mesh_edge *edge = &d->mesh.edge[e];
    size_t before = atomic_load(&w->fault);
    ph_ribbon_of(&d->at[edge->point[0]], &d->at[edge->point[1]], d->continuity,
                 &w->b->ribbons[e]);
    if (fault_of(d, edge, &w->b->ribbons[e], w->rows)) {
      while (e < before &&
             !atomic_compare_exchange_weak(&w->fault, &before, e)) {
      }
      return false;
    }
  }
  return thread || !ph_arena_late(w->b->scratch); /* it is for one to ask */
}

static enum ph_status set_ribbons(struct builder *b) {
  const struct ph_bubble_data *d = b->data;
  struct weaver w = {.b = b};
  size_t e;
  b->ribbons = ph_arena_array(b->arena, d->mesh.edges_n, sizeof *b->ribbons);
  w.rows = ph_arena_array(b->scratch, PLACES, sizeof *w.rows);
  if (!b->ribbons || !w.rows) {
    return ph_fail_memory(b->diag);
  }
  for (size_t i = 0; i < PLACES; i++) {
    ph_ribbon_rows_at(d->continuity, (double)i / (PLACES - 1), 0, &w.rows[i]);
  }
  atomic_init(&w.fault, SIZE_MAX);
  ph_team_share(b->arena, d->mesh.edges_n, WORTH, CHUNK, weave, &w);
  e = atomic_load(&w.fault);
  if (e < SIZE_MAX) {
    const struct ph_mesh_edge *edge = &d->mesh.edge[e];
    return ph_fail_at(b->diag, PH_E_BAD_VALUE, "faces", edge->face[0],
                      "cannot be smooth: its edge between points[%zu] and "
                      "points[%zu] %s; look at these normals, or take "
                      "continuity 0",
                      edge->point[0], edge->point[1],
                      fault_of(d, edge, &b->ribbons[e], w.rows));
  }
  return ph_arena_late(b->scratch) ? ph_fail_memory(b->diag) : PH_OK;
}

/* ---- measures ------------------------------------------------------------ */

static double node(const struct builder *b, size_t i) {
  return i < GAUSS ? b->rule.node[i] : i == GAUSS ? 0 : 1;
}

static const struct nodes *nodes_of(struct builder *b, size_t degree) {
  struct nodes *nodes = b->nodes[degree];
  if (!nodes) {
    nodes = ph_arena_array(b->scratch, 1, sizeof *nodes);
    for (size_t i = 0; nodes && i < NODES; i++) {
      ph_patch_rows_at(degree, node(b, i), &nodes->rows[i]);
    }
    b->nodes[degree] = nodes;
  }
  return nodes;
}

static void measure_at(const struct builder *b, const struct ph_patch_jet *jet,
                       double u, double v, double weight, struct measure *m) {
  const struct ph_quadric *c = b->patch->exact.corner;
  const ph_vec3 normal = ph_vec3_cross(jet->u, jet->v);
  const ph_vec3 from = ph_vec3_sub(jet->p, b->data->at[0].p);
  const double along = (1 - v) * ((1 - u) * ph_vec3_dot(normal, c[0].g) +
                                  u * ph_vec3_dot(normal, c[1].g)) +
                       v * ((1 - u) * ph_vec3_dot(normal, c[2].g) +
                            u * ph_vec3_dot(normal, c[3].g));
  m->area += weight * ph_vec3_abs(normal);
  m->volume += weight * ph_vec3_dot(normal, from) / 3;
  m->turn += weight * along;
  m->out |= along > 0;
  m->in |= along < 0;
}

/* The sides of an exact patch at all nodes. */
static void set_sides(struct builder *b) {
  for (size_t i = 0; i < NODES; i++) {
    const struct ph_exact_rows *rows = &b->exact->rows[i];
    ph_exact_cross(&b->patch->exact, 0, rows, b->exact->by_u[i]);
    ph_exact_cross(&b->patch->exact, 1, rows, b->exact->by_v[i]);
  }
}

static void jet_at(const struct builder *b, const struct nodes *nodes,
                   size_t degree, size_t i, size_t j,
                   struct ph_patch_jet *jet) {
  const struct exact_nodes *x = b->exact;
  if (x) {
    ph_exact_jet_at(&b->patch->exact, &x->rows[i],
                    (const struct ph_cross *)x->by_u[i], &x->rows[j],
                    (const struct ph_cross *)x->by_v[j], jet);
  } else {
    ph_patch_jet_at(b->line, degree, &nodes->rows[i], 1, jet);
  }
}

/* The degree is 0 of an exact patch. */
static bool measure(struct builder *b, size_t degree, struct measure *m) {
  const struct nodes *nodes = b->exact ? NULL : nodes_of(b, degree);
  const double *weight = b->rule.weight;
  *m = (struct measure){.area = 0};
  if (b->exact) {
    set_sides(b);
  } else if (!nodes) {
    return false;
  }
  for (size_t j = 0; j < NODES; j++) {
    if (nodes) {
      ph_patch_line_at(b->points, degree, &nodes->rows[j], 1, b->line);
    }
    for (size_t i = 0; i < NODES; i++) {
      struct ph_patch_jet jet;
      jet_at(b, nodes, degree, i, j, &jet);
      measure_at(b, &jet, node(b, i), node(b, j),
                 i < GAUSS && j < GAUSS ? weight[i] * weight[j] : 0, m);
    }
  }
  return true;
}

/* ---- patches ------------------------------------------------------------- */

static void *take(struct builder *b, size_t n, size_t size) {
  void *memory;
  pthread_mutex_lock(&b->team->lock);
  memory = ph_arena_late(b->scratch) ? NULL : ph_arena_array(b->arena, n, size);
  pthread_mutex_unlock(&b->team->lock);
  return memory;
}

static enum ph_status add_patch(struct builder *b, size_t i, size_t degree,
                                struct measure *m) {
  struct ph_patch *to = &b->curve->surface.patches[i];
  const size_t n = b->exact ? 0 : (degree + 1) * (degree + 1);
  *to = (struct ph_patch){.face = i, .bidegree = {degree, degree}};
  memcpy(to->vertices, b->data->mesh.face[i], sizeof to->vertices);
  to->points_n = n;
  to->control_points = take(b, n, 3 * sizeof(double));
  if (!to->control_points || !measure(b, degree, m)) {
    return ph_fail_memory(b->diag);
  }
  for (size_t k = 0; k < 3 * n; k++) {
    to->control_points[k] = ph_pow2_apply(b->from_unit, b->points[k]);
  }
  if (b->exact) {
    to->bidegree[0] = to->bidegree[1] = PH_NO_SEGMENT;
  }
  to->side = m->turn < 0 ? -1 : 1;
  return PH_OK;
}

static enum ph_status make_patch(struct builder *b, size_t i) {
  const struct ph_bubble_data *d = b->data;
  const struct ph_blend *blend = NULL;
  struct measure *m = &b->measures[i];
  size_t degree = d->degree;
  double miss = 0;
  enum ph_status status;
  ph_exact_begin(b->work, i, &b->patch->exact);
  if (b->exact) {
    return add_patch(b, i, 0, m);
  }
  if (d->continuity > 0) {
    status = ph_bubble_patch_fit(b->patch, b->blends, d->tolerance, &degree,
                                 &miss, b->diag);
    if (status != PH_OK) {
      return status;
    }
    if (degree > PH_BLEND_MAX) {
      return ph_fail_at(b->diag, PH_E_NO_CONVERGENCE, "faces", i,
                        "needs blending functions of a higher degree than %d: "
                        "normals miss by %.3g",
                        PH_BLEND_MAX, miss);
    }
    blend = ph_blend_of(b->blends, degree);
  }
  ph_bubble_patch_points(b->patch, blend, b->net, b->points);
  status = add_patch(b, i, blend ? degree + 1 : 1, m);
  m->miss = miss;
  m->degree = blend ? degree : 0;
  return status;
}

/* ---- threads ------------------------------------------------------------- */

/* What a thread has of its own. */
static bool set_own(struct builder *b) {
  const size_t points = (PH_BLEND_MAX + 2) * (PH_BLEND_MAX + 2);
  b->patch = ph_arena_array(b->scratch, 1, sizeof *b->patch);
  b->line = ph_arena_array(b->scratch, 1, sizeof *b->line);
  b->net = ph_arena_array(b->scratch, points, sizeof *b->net);
  b->points = ph_arena_array(b->scratch, points, 3 * sizeof *b->points);
  if (b->data->exact) {
    b->exact = ph_arena_array(b->scratch, 1, sizeof *b->exact);
    for (size_t i = 0; b->exact && i < NODES; i++) {
      ph_exact_rows_at(b->data->continuity, node(b, i), &b->exact->rows[i]);
    }
  }
  return b->patch && b->line && b->net && b->points &&
         (b->exact || !b->data->exact);
}

/* All that threads would make when they need it, before there are some. */
static bool set_shared(struct builder *b) {
  const size_t first = b->data->degree ? b->data->degree : PH_BLEND_FIRST;
  const size_t last = b->data->degree ? b->data->degree : PH_BLEND_MAX;
  bool good = b->data->continuity > 0 || nodes_of(b, 1);
  for (size_t d = first; good && d <= last && b->data->continuity > 0; d += 2) {
    good = ph_blend_of(b->blends, d) && nodes_of(b, d + 1);
  }
  return good;
}

/* The first that fails is the same, whoever has it. */
static bool work(void *context, size_t thread, size_t first, size_t end) {
  struct team *team = context;
  struct builder *b = &team->builders[thread];
  for (size_t i = first; i < end; i++) {
    if (make_patch(b, i) != PH_OK) {
      pthread_mutex_lock(&team->lock);
      if (i < team->failed) {
        team->failed = i;
        team->status = b->diag->status;
        team->diag = *b->diag;
      }
      pthread_mutex_unlock(&team->lock);
      return false;
    }
  }
  return true;
}

static enum ph_status make_patches(struct builder *b) {
  atomic_int *spare = b->arena->budget ? b->arena->budget->spare : NULL;
  const size_t threads = ph_team_take(spare, b->curve->n / WORTH);
  struct team team = {.failed = SIZE_MAX};
  struct ph_diag *diags = ph_arena_array(b->scratch, threads, sizeof *diags);
  bool good = diags;
  b->team = &team;
  team.builders = ph_arena_array(b->scratch, threads, sizeof *team.builders);
  good = good && team.builders &&
         (threads == 1 || b->data->exact || set_shared(b));
  for (size_t i = 0; good && i < threads; i++) {
    team.builders[i] = *b;
    team.builders[i].diag = &diags[i];
    good = set_own(&team.builders[i]);
  }
  if (!good || pthread_mutex_init(&team.lock, NULL) != 0) {
    for (size_t i = 1; i < threads; i++) {
      ph_team_leave(spare);
    }
    return ph_fail_memory(b->diag);
  }
  ph_team_spread(spare, threads, b->curve->n, CHUNK, work, &team);
  pthread_mutex_destroy(&team.lock);
  b->exact = team.builders[0].exact;
  if (team.failed < SIZE_MAX) {
    *b->diag = team.diag;
    return team.status;
  }
  return PH_OK;
}

/* ---- the whole ----------------------------------------------------------- */

/* A volume is inside of what is closed and has two sides. */
static enum ph_status orient(struct builder *b) {
  const struct ph_mesh *mesh = &b->data->mesh;
  struct ph_diag diag = {.status = PH_OK};
  enum ph_status status = PH_OK;
  b->sign = ph_arena_array(b->scratch, mesh->faces_n, sizeof *b->sign);
  if (!b->sign) {
    return ph_fail_memory(b->diag);
  }
  memset(b->sign, 0, mesh->faces_n);
  if (b->curve->closed) {
    status = ph_mesh_orient(mesh, b->scratch, b->sign, &diag);
  }
  b->two_sided = b->curve->closed && status == PH_OK;
  return status == PH_E_NO_MEMORY ? ph_fail_memory(b->diag) : PH_OK;
}

static enum ph_status begin(struct builder *b) {
  const size_t faces = b->data->mesh.faces_n;
  struct ph_curve *c = b->curve;
  *c = (struct ph_curve){.kind = PH_CURVE_BUBBLE,
                         .closed = ph_mesh_is_closed(&b->data->mesh),
                         .dimension = 3,
                         .n = faces};
  c->surface.continuity = b->data->continuity;
  c->surface.patches =
      ph_arena_array(b->arena, faces, sizeof *c->surface.patches);
  c->surface.exact = b->data->exact;
  b->work = ph_arena_array(b->arena, 1, sizeof *b->work);
  b->blends = ph_arena_array(b->scratch, 1, sizeof *b->blends);
  b->measures = ph_arena_array(b->scratch, faces, sizeof *b->measures);
  b->nodes = ph_arena_array(b->scratch, PH_PATCH_DEGREE_MAX + 1,
                            sizeof(struct nodes *));
  if (!c->surface.patches || !b->work || !b->blends || !b->measures ||
      !b->nodes || !ph_quad_gauss(&b->rule, GAUSS)) {
    return ph_fail_memory(b->diag);
  }
  memset(b->measures, 0, faces * sizeof *b->measures);
  memset(b->nodes, 0, (PH_PATCH_DEGREE_MAX + 1) * sizeof(struct nodes *));
  return orient(b);
}

/* What patches are made of, from now on. */
static void set_work(struct builder *b) {
  *b->work = (struct ph_patchwork){.mesh = b->data->mesh,
                                   .at = b->data->at,
                                   .ribbons = b->ribbons,
                                   .continuity = b->data->continuity,
                                   .exponent = b->data->exponent};
  b->curve->surface.base = b->work;
}

/* What exact patches are known by in place of control points. */
static enum ph_status describe(const struct builder *b) {
  const struct ph_bubble_data *d = b->data;
  struct ph_surface *s = &b->curve->surface;
  s->vertices_n = d->mesh.points_n;
  s->vertices = ph_arena_array(b->arena, s->vertices_n, sizeof *s->vertices);
  if (!s->vertices) {
    return ph_fail_memory(b->diag);
  }
  for (size_t i = 0; i < s->vertices_n; i++) {
    ph_vec3_put(d->at[i].p, 3, s->vertices[i].point);
    ph_vec3_put(d->at[i].g, 3, s->vertices[i].normal);
    for (size_t k = 0; k < 3; k++) {
      s->vertices[i].point[k] =
          ph_pow2_apply(b->from_unit, s->vertices[i].point[k]);
    }
  }
  return ph_patch_edges_of(b->curve, b->arena, &s->edges, b->diag);
}

/* What all patches are together, in their order. */
struct total {
  struct ph_sum area, volume;
  double residual;
  size_t degree; /* the largest */
  size_t folded, first_folded;
  size_t backward; /* faces that run around to the other side */
};

static struct total total_of(const struct builder *b) {
  struct total t = {.residual = 0};
  for (size_t i = 0; i < b->curve->n; i++) {
    const struct measure *m = &b->measures[i];
    ph_sum_add(&t.area, m->area);
    ph_sum_add(&t.volume, b->sign[i] < 0 ? -m->volume : m->volume);
    t.backward += b->sign[i] < 0;
    t.residual = m->miss <= t.residual ? t.residual : m->miss;
    t.degree = m->degree > t.degree ? m->degree : t.degree;
    if (m->in && m->out && t.folded++ == 0) {
      t.first_folded = i;
    }
  }
  return t;
}

/* The number of the data, of a length to that power. */
static double told(const struct builder *b, double x, int power) {
  while (power-- > 0) {
    x = ph_pow2_apply(b->from_unit, x);
  }
  return x;
}

/* The volume of a closed surface of two sides is that of most of its faces. */
static enum ph_status finish(const struct builder *b,
                             struct ph_result *result) {
  struct ph_diagnostics *diagnostics = &result->diagnostics;
  struct ph_curve *c = b->curve;
  const struct total t = total_of(b);
  const double volume = ph_sum_value(&t.volume);
  c->degree = t.degree + 1;
  c->surface.area = told(b, ph_sum_value(&t.area), 2);
  c->surface.volume = b->two_sided
                          ? told(b, 2 * t.backward > c->n ? -volume : volume, 3)
                          : (double)NAN;
  if (!isfinite(c->surface.area) || isinf(c->surface.volume)) {
    return ph_fail(b->diag, PH_E_TOO_LARGE, NULL,
                   "the area or the volume of the surface overflows a double");
  }
  ph_diagnostics_set(diagnostics, PH_D_ITERATIONS, 0);
  ph_diagnostics_set(diagnostics, PH_D_RESIDUAL, t.residual);
  if (!b->exact) {
    ph_diagnostics_set(diagnostics, PH_D_DEGREE, (double)t.degree);
  }
  ph_diagnostics_set(diagnostics, PH_D_FOLDED, (double)t.folded);
  ph_diagnostics_set(diagnostics, PH_D_AREA, c->surface.area);
  if (t.folded) {
    ph_warn(result, t.first_folded, PH_W_FOLDED,
            "the patch of faces[%zu] is folded: its normal turns to the other "
            "side (such patches: %zu)",
            t.first_folded, t.folded);
  }
  return PH_OK;
}

enum ph_status ph_bubble_build(struct ph_bubble_data *data,
                               struct ph_arena *arena, struct ph_arena *scratch,
                               struct ph_result *result, struct ph_diag *diag) {
  struct builder b = {.data = data,
                      .from_unit = ph_pow2_of(-data->exponent),
                      .arena = arena,
                      .scratch = scratch,
                      .diag = diag,
                      .curve = &result->curve};
  enum ph_status status = begin(&b);
  if (status == PH_OK && data->continuity > 0) {
    status = ph_bubble_fit(data, scratch, diag);
    if (status == PH_OK) {
      status = set_ribbons(&b);
    }
    if (status == PH_OK) {
      status = ph_blends_begin(b.blends, data->continuity, scratch, diag);
    }
  }
  if (status == PH_OK) {
    set_work(&b);
  }
  if (status == PH_OK) {
    status = make_patches(&b);
  }
  if (status == PH_OK) {
    status = finish(&b, result);
  }
  return status == PH_OK && b.exact ? describe(&b) : status;
}
