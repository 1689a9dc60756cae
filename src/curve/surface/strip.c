/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Strips, one after the other (see strip.h). */
#include "curve/surface/strip.h"

#include "base/sum.h"
#include "curve/surface/area.h"
#include "curve/surface/general.h"

/* Heights that are those of the vertex but for this, relative, fold nothing. */
static const double AT_VERTEX = 1e-6;

struct ph_ruling ph_ruling_at(const struct ph_strip *strip, double u) {
  const double s = u * strip->length;
  const struct ph_flat_place start = ph_flat_start(strip);
  struct ph_ruling r;
  if (strip->directrix) {
    r = ph_general_ruling(strip, ph_general_parameter(strip, u));
    if (!strip->directrix->moved) { /* as it was asked for */
      r.s = s;
    }
    return r;
  }
  r.at = ph_strip_at(ph_strip_start(strip), strip->k, strip->kn, s);
  r.flat = ph_flat_at(&start, strip->k, s);
  r.k = strip->k;
  r.kn = strip->kn;
  r.s = s;
  return r;
}

/* 1 - k h, where 1 / k is how far the vertex is along the ruling of a frame. */
static double factor_on(const struct ph_strip *s,
                        const struct ph_strip_frame *frame, double h) {
  double away = 0;
  if (!s->directrix) {
    return 1 - s->k * h;
  }
  for (size_t i = 0; i < 3; i++) {
    away += (s->vertex[i] - frame->point[i]) * frame->ruling[i];
  }
  return 1 - h / away;
}

static bool folds(const struct ph_surface *surface,
                  const struct ph_strip *strip, const struct ph_strip *next) {
  for (size_t i = 0; i < 2; i++) {
    const double height = surface->height[i];
    const double a = factor_on(strip, &next->frame,
                               ph_strip_height(surface, strip, height, 1));
    const double b = factor_on(next, &next->frame,
                               ph_strip_height(surface, next, height, 0));
    if (fmin(a, b) < -AT_VERTEX && fmax(a, b) > AT_VERTEX) {
      return true;
    }
  }
  return false;
}

size_t ph_surface_folds(const struct ph_curve *curve, size_t *first) {
  const struct ph_strip *s = curve->surface.strips;
  size_t n = 0;
  for (size_t i = curve->n; i-- > 0;) {
    if ((i + 1 < curve->n || curve->closed) &&
        folds(&curve->surface, &s[i], &s[i + 1 < curve->n ? i + 1 : 0])) {
      *first = i;
      n++;
    }
  }
  return n;
}

void ph_strip_describe(struct ph_strip *strip, const double end[3],
                       double chord, double weight) {
  const double leg = chord / 2 / weight;
  strip->half_angle = atan2(fabs(strip->k), fabs(strip->kn));
  strip->sweep = strip->length * hypot(strip->k, strip->kn);
  strip->development_angle = strip->length * strip->k;
  for (size_t i = 0; i < 3; i++) {
    const double from = strip->frame.point[i];
    strip->vertex[i] = fabs(strip->k) > 0
                           ? from + strip->frame.ruling[i] / strip->k
                           : (double)NAN;
    strip->contact.control_points[0][i] = from;
    strip->contact.control_points[1][i] = from + leg * strip->frame.tangent[i];
    strip->contact.control_points[2][i] = end[i];
    strip->contact.weights[i] = i == 1 ? weight : 1;
  }
}

/* The development of a strip that begins at a place. */
static void set_arc(const struct ph_strip *strip,
                    const struct ph_flat_place *start,
                    const struct ph_flat_place *end, struct ph_arc2 *arc) {
  const double half = strip->k * strip->length / 2;
  const double leg = strip->length * ph_sinc(half) / 2 / cos(half);
  const double tangent[] = {cos(start->angle), sin(start->angle)};
  for (size_t i = 0; i < 2; i++) {
    arc->control_points[0][i] = start->c[i];
    arc->control_points[1][i] = start->c[i] + leg * tangent[i];
    arc->control_points[2][i] = end->c[i];
  }
  arc->weights[0] = arc->weights[2] = 1;
  arc->weights[1] = cos(half);
  arc->angle = start->angle;
}

/* Where the development of a strip that begins at the origin, at an angle,
 * ends; and by how much it turns. */
static struct ph_flat_place develop(struct ph_strip *strip,
                                    const struct ph_flat_place *start,
                                    double *turn) {
  struct ph_arc2 *flat = &strip->development;
  *turn = strip->k * strip->length;
  if (!strip->directrix) {
    return ph_flat_at(start, strip->k, strip->length);
  }
  flat->control_points[0][0] = start->c[0];
  flat->control_points[0][1] = start->c[1];
  flat->angle = start->angle;
  *turn = -strip->directrix->side * strip->development_angle;
  return ph_general_ruling(strip, 1).flat;
}

void ph_develop(struct ph_curve *curve) {
  struct ph_sum x = {0, 0}, y = {0, 0}, angle = {0, 0};
  double shift = curve->surface.strips[0].shift[0];
  for (size_t i = 0; i < curve->n; i++) {
    struct ph_strip *strip = &curve->surface.strips[i];
    struct ph_flat_place start = {{0, 0}, ph_sum_value(&angle)}, end;
    double turn;
    ph_sum_add(&x, (shift - strip->shift[0]) * sin(start.angle));
    ph_sum_add(&y, (strip->shift[0] - shift) * cos(start.angle));
    end = develop(strip, &start, &turn);
    start.c[0] = ph_sum_value(&x);
    start.c[1] = ph_sum_value(&y);
    ph_sum_add(&x, end.c[0]);
    ph_sum_add(&y, end.c[1]);
    ph_sum_add(&angle, turn);
    end.c[0] = ph_sum_value(&x);
    end.c[1] = ph_sum_value(&y);
    set_arc(strip, &start, &end, &strip->development);
    shift = strip->shift[1];
  }
}

void ph_surface_measure(struct ph_curve *curve) {
  struct ph_sum length = {0, 0}, area = {0, 0};
  const struct ph_surface *surface = &curve->surface;
  for (size_t i = 0; i < curve->n; i++) {
    const struct ph_strip *strip = &surface->strips[i];
    double h[2][2];
    ph_strip_corners(surface, strip, h);
    curve->lengths[i] = strip->length;
    ph_sum_add(&length, strip->length);
    ph_sum_add(&area, strip->directrix ? ph_general_area(strip, surface->height)
                                       : ph_area_of(strip->k, strip->length, h,
                                                    surface->height[1] -
                                                        surface->height[0]));
  }
  curve->length = ph_sum_value(&length);
  curve->surface.area = ph_sum_value(&area);
}
