/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Profiles of curvature and torsion (see profile.h). */
#include "plot/profile.h"

#include "plot/trace.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

/* Values on so much of the length at either end do not count ... */
#define TAIL 0.08
/* ... if they are farther out than so many times the range of the others. */
#define REACH 3

/* Curvature times length below this is that of a straight line, and relative
 * changes below CONSTANT are none: rounding, to eyes. */
#define STRAIGHT 1e-7
#define CONSTANT 1e-4

/* A value, and how much of the arc length has it. */
struct weighed {
  double value, weight;
};

struct weights {
  struct weighed *all;
  size_t n;
  double total;
};

static const double *values_of(const struct ph_profile *profile,
                               enum ph_profile_of of) {
  return of == PH_PROFILE_CURVATURE ? profile->curvature : profile->torsion;
}

static int by_value(const void *a, const void *b) {
  double x = ((const struct weighed *)a)->value;
  double y = ((const struct weighed *)b)->value;
  return (x > y) - (x < y);
}

/* Half the way to the neighbours, of the whole length. */
static double weight_of(const struct ph_profile *p, size_t i, double length) {
  double before = p->s[i > 0 ? i - 1 : i];
  double after = p->s[i + 1 < p->n ? i + 1 : i];
  double w = (0.5 * after - 0.5 * before) / length;
  return w > 0 ? w : 0;
}

static void gather(const struct ph_drawing *drawing, enum ph_profile_of of,
                   double length, struct weights *weights) {
  for (size_t k = 0; k < drawing->segments_n; k++) {
    const struct ph_profile *p = &drawing->profiles[k];
    const double *values = values_of(p, of);
    for (size_t i = 0; values && i < p->n; i++) {
      if (isfinite(values[i])) {
        struct weighed *w = &weights->all[weights->n++];
        w->value = values[i];
        w->weight = weight_of(p, i, length);
        weights->total += w->weight;
      }
    }
  }
}

/* The value that so much of the weight is below. */
static double quantile(const struct weights *weights, double part) {
  double sum = 0;
  for (size_t i = 0; i < weights->n; i++) {
    sum += weights->all[i].weight;
    if (sum >= part * weights->total) {
      return weights->all[i].value;
    }
  }
  return weights->all[weights->n - 1].value;
}

static double at_most(double x) {
  return fmin(fmax(x, -0.1 * DBL_MAX), 0.1 * DBL_MAX);
}

/* Leaves out what is far out; no value does the range alone. */
static void robust(const struct weights *weights, double *low, double *high) {
  double q0 = at_most(quantile(weights, TAIL));
  double q1 = at_most(quantile(weights, 1 - TAIL));
  double span = q1 - q0;
  *low = at_most(weights->all[0].value);
  *high = at_most(weights->all[weights->n - 1].value);
  if (span > CONSTANT * fmax(fabs(q0), fabs(q1))) {
    *low = fmax(*low, at_most(q0 - REACH * span));
    *high = fmin(*high, at_most(q1 + REACH * span));
  }
}

/* A range that can be drawn, with a margin. */
static void widen(double length, double *low, double *high) {
  double most = fmax(fabs(*low), fabs(*high)), margin;
  if (!(most * length > STRAIGHT)) {
    most = at_most(1 / length);
    *low = -most;
    *high = most;
  } else if (!(*high - *low > CONSTANT * most)) {
    *high = *low > 0 ? at_most(1.5 * most) : 0;
    *low = *low > 0 ? 0 : at_most(-1.5 * most);
  } else if (*low > 0 && *low < 0.5 * *high) {
    *low = 0;
  } else if (*high < 0 && *high > 0.5 * *low) {
    *high = 0;
  }
  margin = 0.07 * (*high - *low);
  *low -= margin;
  *high += margin;
}

enum ph_status ph_profile_range(const struct ph_drawing *const *drawings,
                                size_t n, enum ph_profile_of of, double length,
                                struct ph_arena *scratch,
                                struct ph_range *range, struct ph_diag *diag) {
  struct ph_mark mark = ph_arena_mark(scratch);
  struct weights weights = {0};
  size_t count = 0;
  *range = (struct ph_range){0, 0, false};
  for (size_t i = 0; i < n; i++) {
    for (size_t k = 0; k < drawings[i]->segments_n; k++) {
      count += drawings[i]->profiles[k].n;
    }
  }
  weights.all = ph_arena_array(scratch, count, sizeof *weights.all);
  if (!weights.all) {
    return ph_fail_memory(diag);
  }
  for (size_t i = 0; i < n; i++) {
    gather(drawings[i], of, length, &weights);
  }
  if (weights.n > 0) {
    range->any = true;
    qsort(weights.all, weights.n, sizeof *weights.all, by_value);
    robust(&weights, &range->low, &range->high);
  }
  widen(length, &range->low, &range->high);
  ph_arena_release(scratch, mark);
  return PH_OK;
}

static struct ph_spot spot_of(const struct ph_axes *axes, double s, double v) {
  double y = isinf(v) ? (v > 0 ? 1e6 : -1e6) : ph_axis_place(&axes->y, v);
  struct ph_spot spot = {
      axes->rect.x + axes->rect.w * ph_axis_place(&axes->x, s),
      axes->rect.y + axes->rect.h * (1 - fmin(fmax(y, -1e6), 1e6))};
  return spot;
}

/* ---- marks of what is out of range --------------------------------------- */

/* The last mark at either edge, so that they do not pile up. */
struct marks {
  struct ph_page *page;
  const struct ph_axes *axes;
  double em;
  double last[2];
};

static void put_mark(struct marks *marks, double x, bool top) {
  const double w = 0.3 * marks->em, h = 0.5 * marks->em;
  const struct ph_rect *r = &marks->axes->rect;
  double tip = top ? r->y + 0.05 * marks->em : r->y + r->h - 0.05 * marks->em;
  struct ph_spot at = {x, tip}, left = {x - w, top ? tip + h : tip - h};
  struct ph_spot right = {x + w, left.y};
  if (x - marks->last[top] > 0.8 * marks->em) {
    ph_page_move(marks->page, at);
    ph_page_line(marks->page, left);
    ph_page_line(marks->page, right);
    ph_page_close(marks->page);
    ph_page_fill(marks->page);
    marks->last[top] = x;
  }
}

/* A mark in the middle of every run of values above, or below, the range. */
static void put_marks(struct marks *marks, const struct ph_profile *p,
                      const double *values, bool top) {
  const struct ph_axis *y = &marks->axes->y;
  size_t first = 0, count = 0;
  for (size_t i = 0; i <= p->n; i++) {
    if (i < p->n && (top ? values[i] > y->high : values[i] < y->low)) {
      first = count++ > 0 ? first : i;
    } else if (count > 0) {
      double s = 0.5 * p->s[first] + 0.5 * p->s[first + count - 1];
      put_mark(marks, spot_of(marks->axes, s, 0).x, top);
      count = 0;
    }
  }
}

/* ---- drawing ------------------------------------------------------------- */

static void draw_one(const struct ph_profile *p, const double *values,
                     struct marks *marks, struct ph_colour colour, double width,
                     struct ph_dash *dash) {
  struct ph_trace trace;
  ph_page_pen(marks->page, colour, width, 0);
  ph_page_dash(marks->page, dash);
  ph_trace_begin(&trace, marks->page, &marks->axes->rect);
  for (size_t i = 0; i < p->n; i++) {
    struct ph_spot spot = spot_of(marks->axes, p->s[i], values[i]);
    if (isnan(values[i])) {
      ph_trace_break(&trace);
    } else {
      ph_trace_to(&trace, spot);
    }
  }
  ph_trace_end(&trace);
  dash->phase += trace.length; /* goes on in the next segment */
  put_marks(marks, p, values, false);
  put_marks(marks, p, values, true);
}

static void line(struct ph_page *page, double x0, double y0, double x1,
                 double y1) {
  struct ph_spot a = {x0, y0}, b = {x1, y1};
  ph_page_move(page, a);
  ph_page_line(page, b);
  ph_page_stroke(page);
}

/* Joints, unless they are so many that the lines would be a carpet. */
static void draw_joints(const struct ph_drawing *drawing,
                        const struct ph_axes *axes, struct ph_page *page,
                        double em) {
  const struct ph_rect *r = &axes->rect;
  if ((double)drawing->segments_n * 0.5 * em > r->w) {
    return;
  }
  ph_page_pen(page, ph_ink(PH_INK_JOINT), 0.055 * em, 0);
  for (size_t k = 1; k < drawing->segments_n; k++) {
    const struct ph_profile *p = &drawing->profiles[k];
    double x = p->n ? spot_of(axes, p->s[0], 0).x : (double)NAN;
    if (x > r->x && x < r->x + r->w) {
      line(page, x, r->y, x, r->y + r->h);
    }
  }
}

void ph_profile_draw(const struct ph_drawing *const *drawings, size_t n,
                     enum ph_profile_of of, const struct ph_axes *axes,
                     struct ph_page *page, double em) {
  const struct ph_rect *r = &axes->rect;
  struct marks marks = {page, axes, em, {-1e9, -1e9}};
  if (axes->y.low < 0 && axes->y.high > 0) {
    double y = spot_of(axes, 0, 0).y;
    ph_page_pen(page, ph_ink(PH_INK_ZERO), 0.055 * em, 0);
    line(page, r->x, y, r->x + r->w, y);
  }
  if (n == 1) {
    draw_joints(drawings[0], axes, page, em);
  }
  for (size_t i = 0; i < n; i++) {
    const struct ph_drawing *d = drawings[i];
    struct ph_dash dash = ph_colour_dash(i, n, em);
    marks.last[0] = marks.last[1] = -1e9;
    for (size_t k = 0; k < d->segments_n; k++) {
      const double *values = values_of(&d->profiles[k], of);
      if (values && d->profiles[k].n > 0) {
        draw_one(&d->profiles[k], values, &marks,
                 n == 1 ? ph_colour_segment(k, d->segments_n, d->closed)
                        : ph_colour_ramp(i, n),
                 0.11 * em * ph_colour_thin(n), &dash);
      }
    }
  }
}
