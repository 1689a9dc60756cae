/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Drawings made by hand (see drawing_unit.h). */
#include "drawing_unit.h"

#include "unit.h"

enum { STEPS = 20 };

static void *array(struct ph_drawing *d, size_t n, size_t size) {
  void *memory = ph_arena_array(&d->arena, n, size);
  ck_assert_ptr_nonnull(memory);
  return memory;
}

/* Angle a of the arc, of a circle so much larger. */
static ph_vec3 place(const struct unit_drawing *of, double a, double larger) {
  double r = of->size * larger, z = 0;
  if (of->space == PH_SPHERE) {
    z = 0.2 * of->size;
    r *= sqrt(0.96);
  } else if (of->space == PH_SPACE) {
    z = 0.2 * a * of->size;
  }
  return ph_vec3_add(of->place, ph_vec3_of(r * cos(a), r * sin(a), z));
}

static void stroke(struct ph_drawing *d, const struct unit_drawing *of,
                   enum ph_stroke_role role, size_t index, double from,
                   double to, double larger) {
  struct ph_stroke *s = &d->strokes[d->strokes_n++];
  size_t steps = role == PH_STROKE_POLYGON ? 3 : STEPS;
  *s = (struct ph_stroke){role, index, steps + 1, NULL, NULL};
  s->points = array(d, steps + 1, sizeof *s->points);
  for (size_t i = 0; i <= steps; i++) {
    double t = (double)i / (double)steps;
    s->points[i] = place(of, from + t * (to - from), larger);
  }
}

static void tangent(struct ph_drawing *d, const struct unit_drawing *of,
                    size_t index, double a) {
  struct ph_stroke *s = &d->strokes[d->strokes_n++];
  ph_vec3 along =
      ph_vec3_of(-0.1 * of->size * sin(a), 0.1 * of->size * cos(a), 0);
  *s = (struct ph_stroke){PH_STROKE_TANGENT, index, 2, NULL, NULL};
  s->points = array(d, 2, sizeof *s->points);
  s->points[0] = place(of, a, 1);
  s->points[1] = ph_vec3_add(s->points[0], along);
}

static void profile(struct ph_drawing *d, const struct unit_drawing *of,
                    size_t k) {
  struct ph_profile *p = &d->profiles[k];
  double each = d->length / (double)of->segments;
  bool space = of->space == PH_SPACE;
  p->n = STEPS;
  p->s = array(d, STEPS, sizeof *p->s);
  p->curvature = array(d, STEPS, sizeof *p->curvature);
  p->torsion = space ? array(d, STEPS, sizeof *p->torsion) : NULL;
  for (size_t i = 0; i < STEPS; i++) {
    p->s[i] = each * ((double)k + (double)i / (STEPS - 1));
    p->curvature[i] = (1 + 0.1 * (double)i) / of->size;
    if (space) {
      p->torsion[i] = -0.2 / of->size;
    }
  }
}

static void box(struct ph_drawing *d) {
  const double far = (double)INFINITY;
  d->low = ph_vec3_of(far, far, far);
  d->high = ph_vec3_of(-far, -far, -far);
  for (size_t i = 0; i < d->strokes_n; i++) {
    for (size_t k = 0; k < d->strokes[i].n; k++) {
      ph_vec3 p = d->strokes[i].points[k];
      d->low = ph_vec3_of(fmin(d->low.x, p.x), fmin(d->low.y, p.y),
                          fmin(d->low.z, p.z));
      d->high = ph_vec3_of(fmax(d->high.x, p.x), fmax(d->high.y, p.y),
                           fmax(d->high.z, p.z));
    }
  }
}

struct ph_drawing *unit_drawing(const struct unit_drawing *of) {
  struct ph_drawing *d = ph_malloc(sizeof *d);
  double each = of->turn / (double)of->segments;
  ck_assert_ptr_nonnull(d);
  memset(d, 0, sizeof *d);
  d->space = of->space;
  d->closed = of->closed;
  ph_vec3_put(of->place, 3, d->center);
  d->radius = of->space == PH_SPHERE ? of->size : 0;
  d->segments_n = of->segments;
  d->length = of->turn * of->size;
  d->data_n = of->segments + !of->closed;
  d->data = array(d, d->data_n, sizeof *d->data);
  d->strokes = array(d, 3 * of->segments + 1 + of->offsets, sizeof *d->strokes);
  d->profiles = array(d, of->segments, sizeof *d->profiles);
  for (size_t i = 0; i < d->data_n; i++) {
    d->data[i] = place(of, each * (double)i, 1);
    if (of->tangents) {
      tangent(d, of, i, each * (double)i);
    }
  }
  for (size_t i = 0; i < of->offsets; i++) {
    stroke(d, of, PH_STROKE_OFFSET, i, 0, of->turn, 1 + 0.1 * ((double)i + 1));
  }
  for (size_t k = 0; k < of->segments; k++) {
    double from = each * (double)k;
    if (of->polygon) {
      stroke(d, of, PH_STROKE_POLYGON, k, from, from + each, 1);
    }
    stroke(d, of, PH_STROKE_CURVE, k, from, from + each, 1);
    profile(d, of, k);
  }
  box(d);
  return d;
}
