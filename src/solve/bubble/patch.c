/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Four sides and four corners into control points (see bubble.h). */
#include "kernel/bern.h"
#include "solve/bubble/bubble.h"

#include <math.h>
#include <string.h>

/* Of the angle that is allowed between the tangent planes on both sides of an
 * edge, what each of them may have at the nodes; between nodes it is more. */
static const double SHARE = 0.25;

/* ---- blending functions -------------------------------------------------- */

/* The sides at the nodes of a rule. */
static void evaluate(struct ph_bubble_patch *patch,
                     const struct ph_blends *blends, size_t rule) {
  for (size_t k = 0; k < 4; k++) {
    struct ph_blend_side *blend = &patch->blend[k];
    for (size_t i = 0; i < ph_blend_nodes(rule); i++) {
      struct ph_cross cross;
      ph_side_at(&patch->exact.side[k], patch->exact.continuity,
                 &blends->rows[rule][i], 0, &cross);
      for (size_t j = 1; j <= patch->exact.continuity; j++) {
        blend->at[j][i] = cross.h[j][0];
      }
      blend->tilt[i] = cross.tilt;
      blend->across[i] = cross.across;
    }
  }
}

/* The Taylor coefficients along side k, inwards from its ends, of derivative j
 * across. */
static void ends_of(const struct ph_bubble_patch *patch, size_t k, size_t j,
                    double ends[2][PH_CROSS_MAX]) {
  for (size_t end = 0; end < 2; end++) {
    const double(*jet)[PH_CROSS_MAX] = patch->exact.jet[ph_side_corner(k, end)];
    for (size_t i = 0; i <= patch->exact.continuity; i++) {
      const double a = k < 2 ? jet[i][j] : jet[j][i];
      ends[end][i] = end && i % 2 ? -a : a;
    }
  }
}

/* What is left of side k, in shares of the tolerance: of derivative j. */
static double left_of(const struct ph_bubble_patch *patch, size_t k, size_t j,
                      size_t nodes, const double *miss) {
  const struct ph_blend_side *blend = &patch->blend[k];
  const double edge = ph_vec3_abs(
      ph_vec3_sub(patch->exact.side[k].p[1], patch->exact.side[k].p[0]));
  double worst = 0;
  for (size_t i = 0; i < nodes; i++) {
    const double angle = fabs(miss[i]) * blend->tilt[i];
    const double share =
        j == 1 ? angle
               : 2 * angle / blend->across[i] * edge / PH_BUBBLE_CURVATURE;
    worst = share <= worst ? worst : share; /* NaN is worse */
  }
  return worst;
}

/* The blending functions of a degree.  ret what is left */
static double fit(struct ph_bubble_patch *patch, const struct ph_blend *blend) {
  const size_t n = patch->exact.continuity;
  const size_t nodes = ph_blend_nodes(ph_blend_rule(blend->degree));
  double worst = 0;
  for (size_t k = 0; k < 4; k++) {
    double miss[PH_BLEND_MORE], ends[2][PH_CROSS_MAX];
    for (size_t j = 1; j <= n; j++) {
      double left;
      ends_of(patch, k, j, ends);
      ph_blend_fit(blend, n, (const double(*)[PH_CROSS_MAX])ends,
                   patch->blend[k].at[j], patch->blend[k].c[j], miss);
      left = left_of(patch, k, j, nodes, miss);
      worst = left <= worst ? worst : left;
    }
  }
  return worst;
}

enum ph_status ph_bubble_patch_fit(struct ph_bubble_patch *patch,
                                   struct ph_blends *blends, double tolerance,
                                   size_t *degree, double *miss,
                                   struct ph_diag *diag) {
  const bool given = *degree > 0;
  size_t d = given ? *degree : PH_BLEND_FIRST, rule = 2;
  *miss = HUGE_VAL;
  for (; d <= PH_BLEND_MAX; d += 2) {
    const struct ph_blend *blend = ph_blend_of(blends, d);
    double left;
    if (!blend) {
      return ph_fail_memory(diag);
    }
    if (ph_blend_rule(d) != rule) {
      rule = ph_blend_rule(d);
      evaluate(patch, blends, rule);
    }
    left = fit(patch, blend);
    *miss = left < *miss ? left : *miss;
    if (given || left <= SHARE * tolerance) {
      break;
    }
  }
  *degree = d;
  return PH_OK;
}

/* ---- control points ------------------------------------------------------ */

/* A row of the height's net: w a blending function, as Bernstein coefficients,
 * of derivative j across side k; 0: the height itself. */
static void set_height(const struct ph_bubble_patch *patch,
                       const struct ph_blend *blend, size_t k, double *w) {
  const size_t n = 4 * patch->exact.continuity + 2;
  for (size_t i = 0; i <= blend->degree; i++) {
    w[i] = 0;
    for (size_t j = 0; j < n; j++) {
      w[i] += blend->elevate[n * i + j] * patch->exact.side[k].ribbon.height[j];
    }
  }
}

/* Coefficient i of Hermite polynomial j at an end, by the direction of the
 * patch. */
static double hermite(const struct ph_blend *blend, size_t end, size_t j,
                      size_t i) {
  const double *row = blend->hermite + j * (blend->degree + 1);
  return !end ? row[i] : (j % 2 ? -1 : 1) * row[blend->degree - i];
}

/* What both pairs of sides have in common: the corners, taken off derivative j
 * of the sides 0 and 1. */
static void take_corners(const struct ph_bubble_patch *patch,
                         const struct ph_blend *blend, size_t k, size_t j,
                         double *w) {
  for (size_t end = 0; end < 2; end++) {
    for (size_t m = 0; m <= patch->exact.continuity; m++) {
      const double a = patch->exact.jet[ph_side_corner(k, end)][m][j];
      for (size_t i = 0; i <= blend->degree; i++) {
        w[i] -= a * hermite(blend, end, m, i);
      }
    }
  }
}

/* The net of the height: a Coons patch. */
static void set_net(const struct ph_bubble_patch *patch,
                    const struct ph_blend *blend, double *net) {
  const size_t n = blend->degree + 1;
  double w[PH_BLEND_MAX + 1], across[PH_BLEND_MAX + 1];
  memset(net, 0, n * n * sizeof *net);
  for (size_t k = 0; k < 4; k++) {
    for (size_t j = 0; j <= patch->exact.continuity; j++) {
      if (j == 0) {
        set_height(patch, blend, k, w);
      } else {
        memcpy(w, patch->blend[k].c[j], n * sizeof *w);
      }
      if (k < 2) {
        take_corners(patch, blend, k, j, w);
      }
      for (size_t i = 0; i < n; i++) {
        across[i] = hermite(blend, k & 1, j, i);
      }
      for (size_t row = 0; row < n; row++) {
        const double *by = k < 2 ? w : across;
        const double factor = k < 2 ? across[row] : w[row];
        for (size_t i = 0; i < n; i++) {
          net[n * row + i] += factor * by[i];
        }
      }
    }
  }
}

/* The bilinear interpolant of corners. */
static ph_vec3 bilinear(const struct ph_bubble_patch *patch, double u,
                        double v) {
  const struct ph_quadric *c = patch->exact.corner;
  ph_vec3 x = ph_vec3_scale((1 - u) * (1 - v), c[0].p);
  x = ph_vec3_along(x, u * (1 - v), c[1].p);
  x = ph_vec3_along(x, (1 - u) * v, c[2].p);
  return ph_vec3_along(x, u * v, c[3].p);
}

void ph_bubble_patch_points(const struct ph_bubble_patch *patch,
                            const struct ph_blend *blend, double *net,
                            double *points) {
  const size_t n = blend ? blend->degree + 1 : 0;
  const size_t m = blend ? n : 1;
  if (blend) {
    set_net(patch, blend, net);
  }
  for (size_t row = 0; row <= m; row++) {
    const double v = (double)row / (double)m;
    for (size_t i = 0; i <= m; i++, points += 3) {
      const double u = (double)i / (double)m;
      ph_vec3 x = bilinear(patch, u, v);
      for (size_t k = 0; k < 4; k++) { /* the products with n's corners */
        const size_t a = k & 1, b = k >> 1;
        if (a <= i && b <= row && i - a < n && row - b < n) {
          x = ph_vec3_along(
              x, (a ? u : 1 - u) * (b ? v : 1 - v) * net[n * (row - b) + i - a],
              patch->exact.corner[k].g);
        }
      }
      ph_vec3_put(x, 3, points);
    }
  }
}
