/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Samples of a curve or of an offset: that they are where they say, and what
 * they say of the curve there.
 *
 * Normal and binormal are unit vectors that make a right-handed frame with the
 * tangent, the one that the record says it is.
 */
#include "check/checks.h"

#include "base/sum.h"
#include "kernel/degree.h"
#include "check/frame.h"
#include "check/local.h"

/* What is said of unit vectors and angles is rounded a few times. */
static const double ROUND_UNIT = 16 * DBL_EPSILON;

/* A torsion may be left out unless the plane of r' and r'' is known to this. */
static const double FLAT = 1e-9;

/* Samples that are looked at. */
struct walk {
  struct ph_check *v;
  const struct ph_samples *of;
  struct ph_check_path path;
  struct ph_check_segment segment;
  struct ph_check_dips slow; /* of an offset, and on a sphere */
  struct ph_check_framing framing;
  size_t k;    /* the segment, of which */
  double u, s; /* a place and the arc length from its start are known */
  struct ph_sum before; /* of the segments before */
  double error;         /* of all that */
  double each;          /* of a Bezier curve's length */
  double size; /* of the curve, or the distance of an offset that is farther:
                  points of it, and lengths between them, are rounded so */
};

static struct ph_check_where in(size_t i, const char *member) {
  return ph_check_of("samples", i, member);
}

/* ---- arc length --------------------------------------------------------- */

/* Goes to the next segment. */
static void next_segment(struct walk *w) {
  if (w->k < w->v->curve->n) {
    double rest = fabs(w->path.distance) > 0
                      ? w->s + ph_check_path_length(&w->path, &w->slow, w->u, 1,
                                                    &w->error)
                      : w->v->length[w->k];
    ph_sum_add(&w->before, rest);
    w->error += w->v->noise[w->k] + w->each;
    ph_check_frame_leave(&w->framing, &w->path);
    w->k++;
  } else {
    w->k = 0;
  }
  w->u = w->s = 0;
  if (w->k < w->v->curve->n) {
    ph_check_load(w->v, w->k, &w->segment);
    if (fabs(w->path.distance) > 0 || w->v->kind->sphere) {
      w->slow = ph_check_path_slow(&w->path);
    }
  }
}

/* The arc length at u of the segment, from the start of all. */
static double length_at(struct walk *w, double u) {
  w->s += ph_check_path_length(&w->path, &w->slow, w->u, u, &w->error);
  w->u = u;
  return ph_sum_value(&w->before) + w->s;
}

/* ---- what is said ------------------------------------------------------- */

static void check_unit(struct walk *w, const double *x, double to,
                       size_t dimension, struct ph_check_where where) {
  ph_vec3 a = ph_vec3_get(x, dimension);
  ph_check_miss(w->v, PH_CHECK_SAMPLE, where, fabs(ph_vec3_abs(a) - to), 1,
                ROUND_UNIT, "is no unit vector");
}

/* Whether there must be a curvature: not at a cusp or beside a point at rest.
 */
static bool has_curvature(const struct ph_check *v,
                          const struct ph_check_local *local) {
  return local->tangent_error < FLAT &&
         local->curvature_error <
             FLAT * ph_check_larger(fabs(local->curvature), 1 / v->scale.size);
}

/* At a cusp, the direction is that of either side. */
static void check_tangent(struct walk *w, size_t i,
                          const struct ph_check_local *local) {
  size_t d = w->of->dimension;
  const double *claimed = w->of->tangent + d * i;
  ph_vec3 tangent;
  if (isnan(claimed[0]) || !(local->tangent_error < PH_CHECK_NO_DIRECTION)) {
    /* left out, which a point alone may do */
    if (local->tangent_error < FLAT) {
      ph_check_wrong(w->v, PH_CHECK_SAMPLE, in(i, "tangent"), "is missing");
    }
    return;
  }
  check_unit(w, claimed, 1, d, in(i, "tangent"));
  tangent = ph_vec3_get(claimed, d);
  if (!has_curvature(w->v, local) && ph_vec3_dot(tangent, local->tangent) < 0) {
    tangent = ph_vec3_scale(-1, tangent);
  }
  ph_check_miss(w->v, PH_CHECK_SAMPLE, in(i, "tangent"),
                ph_check_apart(tangent, local->tangent), 1,
                ROUND_UNIT + 2 * local->tangent_error,
                "is not the direction of the curve");
}

/* A number that is the inverse of a length; not finite: left out.  What leaves
 * the range of numbers may be, and is compared at unit scale, as 1/x is. */
static void check_curvature(struct walk *w, struct ph_check_where where,
                            double claimed, double found, double error,
                            bool certain) {
  struct ph_check *v = w->v;
  bool beyond = !isfinite(ph_check_scaled(v, 2 * (fabs(found) + error)));
  if (isnan(claimed)) {
    if (certain && !beyond) {
      ph_check_wrong(v, PH_CHECK_SAMPLE, where, "is missing");
    }
  } else if (isfinite(error)) {
    double unit = ph_check_larger(fabs(found), 1 / v->scale.size);
    if (beyond) {
      ph_check_number(v, PH_CHECK_SAMPLE, where, ph_check_unscaled(v, claimed),
                      found, unit, 2 * error);
    } else {
      ph_check_number(v, PH_CHECK_SAMPLE, where, claimed,
                      ph_check_scaled(v, found), ph_check_scaled(v, unit),
                      ph_check_scaled(v, 2 * error));
    }
  }
}

/* That the normal is that of the frame; goes on from there. */
static void check_kind(struct walk *w, size_t i, double u,
                       const struct ph_check_local *local) {
  struct ph_check_framing *f = &w->framing;
  ph_vec3 normal = ph_vec3_get(w->of->normal + 3 * i, 3);
  double error;
  ph_vec3 found = ph_check_frame_at(f, &w->path, local, u, &error);
  if (isfinite(error)) {
    ph_check_miss(w->v, PH_CHECK_SAMPLE, in(i, "normal"),
                  ph_check_apart(normal, found), 1, ROUND_UNIT + 2 * error,
                  "is not that of the frame");
  }
  f->begun = f->frame == PH_FRAME_RMF;
  f->u = u;
  f->tangent = local->tangent;
  f->normal = normal;
  f->error = 0;
}

static void check_frame(struct walk *w, size_t i, double u,
                        const struct ph_check_local *local) {
  const double *n = w->of->normal + 3 * i, *b = w->of->binormal + 3 * i;
  ph_vec3 tangent = ph_vec3_get(w->of->tangent + 3 * i, 3);
  ph_vec3 right = ph_vec3_cross(tangent, ph_vec3_get(n, 3));
  if (isnan(n[0]) && isnan(b[0])) {
    return; /* where there is none */
  }
  check_unit(w, n, 1, 3, in(i, "normal"));
  ph_check_miss(w->v, PH_CHECK_SAMPLE, in(i, "normal"),
                fabs(ph_vec3_dot(ph_vec3_get(n, 3), tangent)), 1, ROUND_UNIT,
                "is not across the tangent");
  ph_check_miss(w->v, PH_CHECK_SAMPLE, in(i, "binormal"),
                ph_check_apart(ph_vec3_get(b, 3), right), 1, ROUND_UNIT,
                "makes no right-handed frame");
  check_kind(w, i, u, local);
}

/* Longitude and latitude against the claimed point. */
static void check_degrees(struct walk *w, size_t i, ph_vec3 point) {
  const struct ph_check *v = w->v;
  const double *claimed = w->of->lonlat + 2 * i;
  ph_vec3 from = ph_vec3_sub(point, w->segment.center);
  ph_check_miss(w->v, PH_CHECK_SAMPLE, in(i, "lonlat"),
                ph_check_apart(ph_degree_to_unit(claimed[0], claimed[1]),
                               ph_vec3_unit(from)),
                1, ROUND_UNIT + 4 * v->scale.rounding / w->segment.radius,
                "are not those of the point");
}

static void check_sample(struct walk *w, size_t i) {
  struct ph_check *v = w->v;
  const struct ph_samples *of = w->of;
  double u = of->t[i] / w->segment.unit, s;
  struct ph_check_local local;
  ph_vec3 point =
      ph_check_vector(v, of->point + of->dimension * i, of->dimension);
  if (!(u >= 0 && u <= 1 + 2 * DBL_EPSILON)) {
    ph_check_wrong(v, PH_CHECK_SAMPLE, in(i, "t"), "is not in the segment");
    return;
  }
  s = ph_check_unscaled(v, length_at(w, u));
  local = ph_check_local_beside(&w->path, u, point);
  ph_check_miss(v, PH_CHECK_SAMPLE, in(i, "point"),
                ph_check_apart(point, local.point), v->scale.size,
                local.point_error, "is away from the curve");
  if (isnan(local.tangent.x)) {
    return; /* a point at rest, where there is no direction */
  }
  if (!isnan(s)) { /* else beside a point at rest, where it is not found */
    ph_check_number(v, PH_CHECK_SAMPLE, in(i, "s"), of->s[i], s,
                    ph_check_larger(fabs(s), ph_check_unscaled(v, w->size)),
                    ph_check_unscaled(v, w->error + v->noise[w->k] + w->each));
  }
  check_tangent(w, i, &local);
  check_curvature(w, in(i, "curvature"), of->curvature[i], local.curvature,
                  local.curvature_error, has_curvature(v, &local));
  if (of->torsion) {
    check_curvature(w, in(i, "torsion"), of->torsion[i], local.torsion,
                    local.torsion_error, local.flat < FLAT);
  }
  if (of->normal && of->binormal) {
    check_frame(w, i, u, &local);
  }
  if (of->lonlat && w->v->kind->sphere) {
    check_degrees(w, i, point);
  }
}

/* ---- all of them -------------------------------------------------------- */

/* Samples are in the order of the parameter, and so of the length, which may
 * have been rounded: that of a far offset as its distance times an angle is. */
static void check_order(struct walk *w, size_t i) {
  const struct ph_samples *of = w->of;
  const double far = ph_check_larger(
      fabs(of->s[of->n - 1]), ph_check_unscaled(w->v, fabs(w->path.distance)));
  if (i > 0 && of->segment[i] == of->segment[i - 1] &&
      !(of->t[i] >= of->t[i - 1])) {
    ph_check_wrong(w->v, PH_CHECK_SAMPLE, in(i, "t"), "is before the last one");
  }
  if (i > 0 && !(of->s[i] >= of->s[i - 1] - ROUND_UNIT * far)) {
    ph_check_wrong(w->v, PH_CHECK_SAMPLE, in(i, "s"), "is before the last one");
  }
}

/* Whether there is what every sample must have. */
static bool is_whole(struct ph_check *v, const struct ph_samples *of) {
  bool whole = of->segment && of->t && of->s && of->point && of->tangent &&
               of->curvature && of->dimension == v->curve->dimension;
  if (!whole) {
    ph_check_wrong(v, PH_CHECK_SHAPE, in(0, NULL), "are not whole");
  }
  return whole;
}

void ph_check_samples(struct ph_check *v, const struct ph_samples *of,
                      const struct ph_check_path *beside, double *length,
                      double *error) {
  struct walk w = {.v = v, .of = of, .k = v->curve->n};
  w.path = beside ? *beside : (struct ph_check_path){.distance = 0};
  w.path.v = v;
  w.framing.frame = of->frame;
  w.path.s = &w.segment;
  w.each = ph_check_conversion(v);
  w.size = ph_check_larger(v->scale.size, fabs(w.path.distance));
  ph_check_done(v, PH_CHECK_SAMPLE);
  if (!is_whole(v, of)) {
    return;
  }
  next_segment(&w);
  for (size_t i = 0; i < of->n && !ph_arena_late(v->scratch); i++) {
    size_t k = of->segment[i];
    if (k >= v->curve->n || k < w.k) {
      ph_check_wrong(v, PH_CHECK_SAMPLE, in(i, "segment"),
                     k < w.k ? "is one before" : "is not there");
      return;
    }
    check_order(&w, i);
    while (w.k < k) {
      next_segment(&w);
    }
    check_sample(&w, i);
  }
  while (w.k < v->curve->n && !ph_arena_late(v->scratch)) {
    next_segment(&w);
  }
  *length = ph_sum_value(&w.before);
  *error = w.error;
}
