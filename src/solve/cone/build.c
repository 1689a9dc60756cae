/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Pairs into a surface (see cone.h): the record's strips, their development one
 * after the other, length and area, and what is told of them.
 */
#include "base/team.h"
#include "curve/surface/area.h"
#include "curve/surface/strip.h"
#include "solve/cone/cone.h"

#include <math.h>

/* A contact point so many times the distance of both away is told. */
static const double FAR = 3;

/* Pairs that a thread takes at a time, in 0.5 ms. */
enum { PART = 256 };

/* What is counted for a warning, and the first place where it is. */
struct count {
  size_t n, first;
};

static void count_at(struct count *count, size_t at) {
  if (count->n++ == 0) {
    count->first = at;
  }
}

struct builder {
  const struct ph_cone_data *data;
  struct ph_pow2 from_unit, to_curvature;
  struct ph_curve *curve;
  double residual, farthest;
  struct count far, inside, changes, large;
};

static double back(const struct builder *b, double x) {
  return ph_pow2_apply(b->from_unit, x);
}

static void put(const struct builder *b, double *to, ph_vec3 v) {
  ph_vec3_put(ph_vec3_of(back(b, v.x), back(b, v.y), back(b, v.z)), 3, to);
}

/* ---- strips -------------------------------------------------------------- */

static void set_strip(struct builder *b, size_t i, ph_vec3 middle,
                      const struct ph_cone_strip *s, ph_vec3 end,
                      const double shift[2]) {
  struct ph_strip *strip = &b->curve->surface.strips[i];
  double to[3];
  *strip = (struct ph_strip){.pair = i / 2,
                             .method = PH_STRIP_CIRCULAR,
                             .k = ph_pow2_apply(b->to_curvature, s->k),
                             .kn = ph_pow2_apply(b->to_curvature, s->kn),
                             .length = back(b, s->length),
                             .shift = {back(b, shift[0]), back(b, shift[1])}};
  put(b, strip->frame.point, ph_vec3_add(middle, s->c));
  ph_vec3_put(s->e, 3, strip->frame.ruling);
  ph_vec3_put(s->d, 3, strip->frame.tangent);
  ph_vec3_put(s->n, 3, strip->frame.normal);
  put(b, to, ph_vec3_add(middle, end));
  ph_strip_describe(strip, to, back(b, s->chord), s->weight);
}

/* ---- pairs --------------------------------------------------------------- */

static void set_pair(struct builder *b, size_t i, ph_vec3 middle,
                     const struct ph_cone_pair *p) {
  struct ph_pair *pair = &b->curve->surface.pairs[i];
  *pair = (struct ph_pair){
      .which = p->which,
      .lambda = {back(b, p->lambda[0]), back(b, p->lambda[1])},
      .interval = {back(b, p->interval[0]), back(b, p->interval[1])},
      .radius = back(b, p->radius)};
  put(b, pair->center, ph_vec3_add(middle, p->center));
}

static void see_pair(struct builder *b, size_t i,
                     const struct ph_cone_pair *p) {
  const double shift = fmax(fabs(p->shift[0]), fabs(p->shift[1]));
  b->residual = fmax(b->residual, p->residual);
  b->farthest = fmax(b->farthest, shift);
  if (shift > FAR * p->chord) {
    count_at(&b->far, i);
  }
}

static void add_pair(struct builder *b, size_t i,
                     const struct ph_cone_pair *p) {
  const struct ph_contact_element *first = ph_cone_element(b->data, i);
  const struct ph_contact_element *last = ph_cone_element(b->data, i + 1);
  const ph_vec3 middle = ph_vec3_scale(0.5, ph_vec3_add(first->p, last->p));
  const struct ph_cone_strip *s = p->strip;
  const ph_vec3 end =
      ph_vec3_along(ph_vec3_sub(last->p, middle), p->shift[1], last->e);
  const double part = s[0].length / (s[0].length + s[1].length);
  const double joint = p->shift[0] + part * (p->shift[1] - p->shift[0]);
  const double shift[] = {p->shift[0], joint, p->shift[1]};
  set_pair(b, i, middle, p);
  see_pair(b, i, p);
  set_strip(b, 2 * i, middle, &s[0], s[1].c, shift);
  set_strip(b, 2 * i + 1, middle, &s[1], end, shift + 1);
}

/* ---- warnings ------------------------------------------------------------ */

/* The sign of the normal curvature at (s, h). */
static int sign_at(const struct ph_strip *s, double h) {
  const double sign = s->kn * (1 - s->k * h);
  return (sign > 0) - (sign < 0);
}

static void see_strips(struct builder *b) {
  const struct ph_curve *c = b->curve;
  for (size_t i = 0; i < c->n; i++) {
    const struct ph_strip *s = &c->surface.strips[i];
    const struct ph_strip *next = &c->surface.strips[i + 1 < c->n ? i + 1 : 0];
    double h[2][2], to[2][2];
    ph_strip_corners(&c->surface, s, h);
    ph_strip_corners(&c->surface, next, to);
    if (ph_area_folds(s->k, h)) {
      count_at(&b->inside, i);
    }
    if (s->contact.weights[1] < 0) {
      count_at(&b->large, i);
    }
    if ((i + 1 < c->n || c->closed) &&
        (sign_at(s, h[0][1]) * sign_at(next, to[0][0]) < 0 ||
         sign_at(s, h[1][1]) * sign_at(next, to[1][0]) < 0)) {
      count_at(&b->changes, i);
    }
  }
}

static void warn(const struct builder *b, struct ph_result *result) {
  if (b->far.n) {
    ph_warn(result, 2 * b->far.first, PH_W_FAR_CONTACT,
            "the contact points of pair %zu are more than %g times their "
            "distance away from the given points (such pairs: %zu); "
            "degenerate_tolerance takes data with noise as they are meant",
            b->far.first, FAR, b->far.n);
  }
  if (b->inside.n) {
    ph_warn(result, b->inside.first, PH_W_VERTEX_INSIDE,
            "the vertex of strip %zu is within the height (such strips: %zu)",
            b->inside.first, b->inside.n);
  }
  if (b->changes.n) {
    ph_warn(result, b->changes.first, PH_W_SIGN_CHANGE,
            "the normal curvature changes its sign at the end of strip %zu "
            "(such rulings: %zu)",
            b->changes.first, b->changes.n);
  }
  if (b->large.n) {
    ph_warn(result, b->large.first, PH_W_LARGE_ARC,
            "strip %zu turns by more than 180 degrees about its axis (such "
            "strips: %zu)",
            b->large.first, b->large.n);
  }
}

void ph_cone_see_folds(bool inside, struct ph_result *result) {
  size_t first = 0;
  const size_t n = ph_surface_folds(&result->curve, &first);
  ph_diagnostics_set(&result->diagnostics, PH_D_REGULAR, !inside && !n);
  ph_diagnostics_set(&result->diagnostics, PH_D_FOLDED, (double)n);
  if (n) {
    ph_warn(result, first, PH_W_FOLDED,
            "the surface turns back on itself at the end of strip %zu, as one "
            "strip there is beyond its vertex (such rulings: %zu)",
            first, n);
  }
}

/* ---- the whole ----------------------------------------------------------- */

static enum ph_status begin(struct builder *b, struct ph_arena *arena,
                            struct ph_diag *diag) {
  const struct ph_cone_data *d = b->data;
  struct ph_curve *c = b->curve;
  *c = (struct ph_curve){.kind = PH_CURVE_CONE,
                         .closed = d->closed,
                         .dimension = 3,
                         .n = 2 * d->n};
  c->lengths = ph_arena_array(arena, c->n, sizeof *c->lengths);
  c->surface.strips = ph_arena_array(arena, c->n, sizeof *c->surface.strips);
  c->surface.pairs = ph_arena_array(arena, d->n, sizeof *c->surface.pairs);
  c->surface.pairs_n = d->n;
  c->surface.height[0] = back(b, d->height[0]);
  c->surface.height[1] = back(b, d->height[1]);
  return c->lengths && c->surface.strips && c->surface.pairs
             ? PH_OK
             : ph_fail_memory(diag);
}

static void finish(struct builder *b, struct ph_result *result) {
  struct ph_diagnostics *diagnostics = &result->diagnostics;
  ph_develop(b->curve);
  ph_surface_measure(b->curve);
  see_strips(b);
  ph_diagnostics_set(diagnostics, PH_D_ITERATIONS, 0);
  ph_diagnostics_set(diagnostics, PH_D_RESIDUAL, b->residual);
  ph_diagnostics_set(diagnostics, PH_D_SHIFT, back(b, b->farthest));
  ph_diagnostics_set(diagnostics, PH_D_VERTICES_INSIDE, (double)b->inside.n);
  ph_diagnostics_set(diagnostics, PH_D_SIGN_CHANGES, (double)b->changes.n);
  ph_diagnostics_set(diagnostics, PH_D_LARGE_ARCS, (double)b->large.n);
  warn(b, result);
  ph_cone_see_folds(b->inside.n > 0, result);
}

/* A part of the pairs: what is seen of them, and the first that has no cones.
 */
struct part {
  struct builder b;
  enum ph_cone_reason reason;
  size_t failed;
};

struct parts {
  const struct builder *b;
  const struct ph_arena *arena;
  struct part *part;
};

static bool add_part(void *context, size_t thread, size_t first, size_t end) {
  const struct parts *parts = context;
  const struct ph_cone_data *data = parts->b->data;
  struct part *part = &parts->part[first / PART];
  (void)thread;
  *part = (struct part){.b = *parts->b, .reason = PH_CONE_OK};
  for (size_t i = first; i < end && !ph_arena_late(parts->arena); i++) {
    const double lambda = data->lambda ? data->lambda[i] : (double)NAN;
    struct ph_cone_pair pair;
    part->reason =
        ph_cone_pair(ph_cone_element(data, i), ph_cone_element(data, i + 1),
                     lambda, data->degenerate, &pair);
    if (part->reason != PH_CONE_OK) {
      part->failed = i;
      return false;
    }
    add_pair(&part->b, i, &pair);
  }
  return true;
}

static enum ph_status add_pairs(struct builder *b, struct ph_arena *arena,
                                struct ph_diag *diag) {
  const size_t n = b->data->n, parts_n = (n + PART - 1) / PART;
  struct parts parts = {b, arena,
                        ph_arena_array(arena, parts_n, sizeof *parts.part)};
  if (!parts.part) {
    return ph_fail_memory(diag);
  }
  ph_team_share(arena, n, 2 * PART, PART, add_part, &parts);
  if (ph_arena_late(arena)) {
    return ph_fail_memory(diag);
  }
  for (size_t i = 0; i < parts_n; i++) {
    const struct part *part = &parts.part[i];
    if (part->reason != PH_CONE_OK) {
      return ph_fail_at(diag, PH_E_INFEASIBLE, "pairs", part->failed, "%s",
                        ph_cone_reason_text(part->reason));
    }
    b->residual = fmax(b->residual, part->b.residual);
    b->farthest = fmax(b->farthest, part->b.farthest);
    b->far.first = b->far.n ? b->far.first : part->b.far.first;
    b->far.n += part->b.far.n;
  }
  return PH_OK;
}

enum ph_status ph_cone_build(const struct ph_cone_data *data,
                             struct ph_arena *arena, struct ph_result *result,
                             struct ph_diag *diag) {
  struct builder b = {.data = data,
                      .from_unit = ph_pow2_of(-data->exponent),
                      .to_curvature = ph_pow2_of(data->exponent),
                      .curve = &result->curve};
  enum ph_status status = begin(&b, arena, diag);
  if (status == PH_OK) {
    status = add_pairs(&b, arena, diag);
  }
  if (status == PH_OK) {
    finish(&b, result);
  }
  return status;
}
