/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What records say of surfaces of patches beside their control points (see
 * bubble.h): areas and volumes by two Gauss rules, whose difference says how
 * uncertain they are. */
#include "check/bubble_exact.h"

#include "base/sum.h"
#include "kernel/bern.h"

#include <float.h>

enum { RULES = 2, MOST = PH_CHECK_PATCH_MOST, NODES_MAX = 20 };
static const size_t NODES[RULES] = {16, NODES_MAX};

/* Of sums, beside what the rules tell of themselves. */
static const double SUM = 1e-12;

/* Points and derivatives of a net, by rows of the basis of degree n and of
 * that of n - 1. */
struct rows {
  double value[MOST], change[MOST];
};

static void set_rows(size_t degree, double u, struct rows *rows) {
  double low[MOST];
  ph_bern_basis(degree, u, rows->value);
  ph_bern_basis(degree - 1, u, low);
  for (size_t i = 0; i <= degree; i++) {
    rows->change[i] =
        (double)degree * ((i > 0 ? low[i - 1] : 0) - (i < degree ? low[i] : 0));
  }
}

/* ... and by how much the rounding of control points may change them. */
struct measure {
  double area, volume, area_noise, volume_noise;
};

/* A node at derivatives of these degrees, where points are known to rounding.
 */
static void add(struct measure *sum, double weight, ph_vec3 at, ph_vec3 u,
                ph_vec3 v, const size_t degrees[2], double round) {
  const ph_vec3 normal = ph_vec3_cross(u, v);
  const double area = weight * ph_vec3_abs(normal);
  const double noise = weight * round *
                       ((double)(degrees[0] + 1) * ph_vec3_abs(v) +
                        (double)(degrees[1] + 1) * ph_vec3_abs(u));
  sum->area += area;
  sum->volume += weight * ph_vec3_dot(at, normal) / 3;
  sum->area_noise += noise;
  sum->volume_noise += (noise * ph_vec3_abs(at) + area * round) / 3;
}

/* One rule on one patch that is a quotient. */
static struct measure measure_exact(const struct ph_check_quotient *patch,
                                    const struct ph_quad *rule, ph_vec3 from,
                                    double round) {
  static const size_t degrees[] = {PH_CHECK_LIKE / 2, PH_CHECK_LIKE / 2};
  struct ph_check_node node[NODES_MAX];
  struct ph_check_cross cross[2][NODES_MAX][2];
  struct measure sum = {0, 0, 0, 0};
  for (size_t i = 0; i < rule->n; i++) {
    ph_check_node_at(patch->continuity, rule->node[i], &node[i]);
    for (size_t k = 0; k < 4; k++) {
      ph_check_quotient_cross(patch, k, rule->node[i], &cross[k / 2][i][k % 2]);
    }
  }
  for (size_t j = 0; j < rule->n; j++) {
    for (size_t i = 0; i < rule->n; i++) {
      struct ph_check_place at;
      ph_check_quotient_at(patch, &node[i],
                           (const struct ph_check_cross *)cross[0][i], &node[j],
                           (const struct ph_check_cross *)cross[1][j], &at);
      add(&sum, rule->weight[i] * rule->weight[j],
          ph_vec3_sub(at.x[0][0], from), at.x[1][0], at.x[0][1], degrees,
          round);
    }
  }
  return sum;
}

/* One rule on one patch. */
static struct measure measure(const struct ph_check_patchwork *w,
                              const struct ph_patch *p,
                              const struct ph_quad *rule,
                              const struct rows *by_u, const struct rows *by_v,
                              ph_vec3 from) {
  const size_t width = p->bidegree[0] + 1, high = p->bidegree[1] + 1;
  const double round = 2 * w->v->scale.rounding;
  struct measure sum = {0, 0, 0, 0};
  for (size_t j = 0; j < rule->n; j++) {
    ph_vec3 line[MOST], across[MOST];
    for (size_t i = 0; i < width; i++) {
      line[i] = across[i] = ph_vec3_of(0, 0, 0);
      for (size_t k = 0; k < high; k++) {
        const ph_vec3 c = ph_vec3_sub(
            ph_check_vector(w->v, p->control_points + 3 * (width * k + i), 3),
            from);
        line[i] = ph_vec3_along(line[i], by_v[j].value[k], c);
        across[i] = ph_vec3_along(across[i], by_v[j].change[k], c);
      }
    }
    for (size_t i = 0; i < rule->n; i++) {
      ph_vec3 at = ph_vec3_of(0, 0, 0), u = at, v = at;
      for (size_t k = 0; k < width; k++) {
        at = ph_vec3_along(at, by_u[i].value[k], line[k]);
        u = ph_vec3_along(u, by_u[i].change[k], line[k]);
        v = ph_vec3_along(v, by_u[i].value[k], across[k]);
      }
      add(&sum, rule->weight[i] * rule->weight[j], at, u, v, p->bidegree,
          round);
    }
  }
  return sum;
}

/* Both rules. */
struct gauge {
  struct ph_quad rule[RULES];
  struct rows rows[RULES][2][NODES_MAX]; /* by u, v, of the last degrees */
  size_t degree[2];
  ph_vec3 from;
};

static void measure_patch(const struct ph_check_patchwork *w, size_t i,
                          struct gauge *g, struct measure m[RULES]) {
  const struct ph_patch *p = &w->curve->surface.patches[i];
  if (w->edges) {
    struct ph_check_quotient patch;
    ph_check_quotient_begin(w, i, &patch);
    for (size_t k = 0; k < RULES; k++) {
      m[k] =
          measure_exact(&patch, &g->rule[k], g->from, 2 * w->v->scale.rounding);
    }
    return;
  }
  for (size_t d = 0; d < 2; d++) {
    for (size_t k = 0; k < RULES && p->bidegree[d] != g->degree[d]; k++) {
      for (size_t j = 0; j < g->rule[k].n; j++) {
        set_rows(p->bidegree[d], g->rule[k].node[j], &g->rows[k][d][j]);
      }
    }
    g->degree[d] = p->bidegree[d];
  }
  for (size_t k = 0; k < RULES; k++) {
    m[k] = measure(w, p, &g->rule[k], g->rows[k][0], g->rows[k][1], g->from);
  }
}

/* Sums over all patches, and how uncertain these are. */
static enum ph_status measure_all(const struct ph_check_patchwork *w,
                                  struct measure *found,
                                  struct measure *uncertain) {
  struct ph_arena *arena = w->v->scratch;
  struct ph_sum area[RULES] = {{0, 0}}, volume[RULES] = {{0, 0}};
  struct gauge *gauge = ph_arena_array(arena, 1, sizeof *gauge);
  *uncertain = (struct measure){0, 0, 0, 0};
  if (!gauge || !ph_quad_gauss(&gauge->rule[0], NODES[0]) ||
      !ph_quad_gauss(&gauge->rule[1], NODES[1])) {
    return ph_fail_memory(w->v->diag);
  }
  gauge->degree[0] = gauge->degree[1] = 0;
  gauge->from = ph_check_vector(w->v, ph_check_patch_point(w->curve, 0, 0), 3);
  for (size_t i = 0; i < w->curve->n; i++) {
    struct measure m[RULES];
    measure_patch(w, i, gauge, m);
    for (size_t k = 0; k < RULES; k++) {
      ph_sum_add(&area[k], m[k].area);
      ph_sum_add(&volume[k], m[k].volume);
    }
    uncertain->area += fabs(m[1].area - m[0].area) + m[1].area_noise;
    uncertain->volume += fabs(m[1].volume - m[0].volume) + m[1].volume_noise;
    if (ph_arena_late(arena)) {
      return ph_fail_memory(w->v->diag);
    }
  }
  found->area = ph_sum_value(&area[1]);
  found->volume = ph_sum_value(&volume[1]);
  return PH_OK;
}

static void check_measures(struct ph_check_patchwork *w,
                           const struct measure *found,
                           const struct measure *uncertain) {
  struct ph_check *v = w->v;
  const struct ph_surface *s = &w->curve->surface;
  const double area = ph_check_scaled(v, ph_check_scaled(v, s->area));
  const double size = found->area * v->scale.size;
  /* squares and cubes may be subnormal */
  const double square = ph_check_scaled(v, v->scale.spacing);
  ph_check_number(v, PH_CHECK_DIAGNOSTIC,
                  ph_check_of(NULL, PH_CHECK_ONE, "area"), area, found->area,
                  found->area,
                  2 * uncertain->area + SUM * found->area + square);
  if (isnan(s->volume) || !w->oriented) {
    return;
  }
  ph_check_number(
      v, PH_CHECK_DIAGNOSTIC, ph_check_of(NULL, PH_CHECK_ONE, "volume"),
      ph_check_scaled(v, ph_check_scaled(v, ph_check_scaled(v, s->volume))),
      found->volume, size,
      2 * uncertain->volume + SUM * size + ph_check_scaled(v, square));
}

/* A diagnostic against what was found. */
static void check_told(struct ph_check_patchwork *w, enum ph_diagnostic which,
                       double found, double unit, double allowance) {
  struct ph_check *v = w->v;
  if (ph_check_known(v, which)) {
    ph_check_number(
        v, PH_CHECK_DIAGNOSTIC,
        ph_check_of("diagnostics", PH_CHECK_ONE, ph_diagnostic_name(which)),
        v->diagnostics->value[which], found, unit, allowance);
  }
}

enum ph_status ph_check_patch_told(struct ph_check_patchwork *w) {
  struct ph_check *v = w->v;
  const struct ph_surface *s = &w->curve->surface;
  struct measure found = {0, 0, 0, 0}, uncertain;
  enum ph_status status = measure_all(w, &found, &uncertain);
  size_t degree = 0;
  if (status != PH_OK) {
    return status;
  }
  for (size_t i = 0; i < w->curve->n && !w->edges; i++) {
    for (size_t k = 0; k < 2; k++) {
      const size_t d = s->patches[i].bidegree[k];
      degree = d > degree ? d : degree;
    }
  }
  if (w->closed != w->curve->closed ||
      (w->closed ? w->oriented && isnan(s->volume) : !isnan(s->volume))) {
    ph_check_wrong(v, PH_CHECK_SHAPE, ph_check_of(NULL, PH_CHECK_ONE, "closed"),
                   "is not what the edges say");
  }
  check_measures(w, &found, &uncertain);
  check_told(w, PH_D_AREA, s->area, s->area, 0);
  check_told(w, PH_D_DEGREE, degree && s->continuity ? (double)degree - 1 : 0,
             1, 0);
  check_told(w, PH_D_NORMAL_JUMP, w->jump.reported, 1, SUM);
  check_told(w, PH_D_CURVATURE_JUMP, w->bend.reported, 1, SUM);
  ph_check_patch_claim(w);
  if (w->normal.done) {
    const bool wrong = w->normal.excess > 1;
    ph_check_miss(v, PH_CHECK_NORMAL, ph_check_patch_where(w, w->normal.where),
                  wrong ? w->normal.value : 0, 1, w->normal.allowed,
                  "turn from a normal that is given");
  }
  if (w->jump.excess > 1) {
    ph_check_miss(v, PH_CHECK_NORMAL, ph_check_patch_where(w, w->jump.where),
                  w->jump.value, 1, w->jump.allowed,
                  "turn more at an edge than the tolerance");
  }
  return PH_OK;
}
