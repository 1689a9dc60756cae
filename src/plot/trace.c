/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Lines and cubics on their way to the page (see trace.h). */
#include "plot/trace.h"

#include <math.h>

/* Shorter steps are joined into one: a tenth of the thinnest line. */
#define STEP_MIN 0.05
/* A cubic whose handles are so near its chord is a line. */
#define FLAT 0.0005
/* One that leaves the rectangle is halved so often. */
enum { HALVES_MAX = 10 };

void ph_trace_begin(struct ph_trace *trace, struct ph_page *page,
                    const struct ph_rect *rect) {
  *trace = (struct ph_trace){.page = page, .rect = *rect};
}

static void step(struct ph_trace *trace, struct ph_spot to) {
  struct ph_spot a = trace->last, b = to;
  trace->length += hypot(b.x - a.x, b.y - a.y);
  if (!ph_clip(&trace->rect, &a, &b)) {
    trace->down = false;
  } else {
    if (!trace->down || !ph_rect_has(&trace->rect, trace->last, 0)) {
      ph_page_move(trace->page, a);
    }
    ph_page_line(trace->page, b);
    trace->any = true;
    trace->down = ph_rect_has(&trace->rect, to, 0);
  }
  trace->last = to;
  trace->skips = false;
}

/* ---- cubics -------------------------------------------------------------- */

static struct ph_spot middle(struct ph_spot a, struct ph_spot b) {
  return (struct ph_spot){0.5 * a.x + 0.5 * b.x, 0.5 * a.y + 0.5 * b.y};
}

static double apart(struct ph_spot a, struct ph_spot b) {
  return hypot(a.x - b.x, a.y - b.y);
}

static double far(struct ph_spot p, struct ph_spot a, struct ph_spot b) {
  const double x = b.x - a.x, y = b.y - a.y, square = x * x + y * y;
  const double along = (p.x - a.x) * x + (p.y - a.y) * y;
  const double t = square > 0 ? fmax(0, fmin(1, along / square)) : 0;
  return hypot(p.x - a.x - t * x, p.y - a.y - t * y);
}

static bool is_flat(const struct ph_spot c[4]) {
  return far(c[1], c[0], c[3]) <= FLAT && far(c[2], c[0], c[3]) <= FLAT;
}

/* Whether all of it is in the rectangle, or none: beyond one of its sides. */
static bool is_inside(const struct ph_rect *r, const struct ph_spot c[4]) {
  return ph_rect_has(r, c[0], 0) && ph_rect_has(r, c[1], 0) &&
         ph_rect_has(r, c[2], 0) && ph_rect_has(r, c[3], 0);
}

static bool is_outside(const struct ph_rect *r, const struct ph_spot c[4]) {
  const double x = r->x + r->w, y = r->y + r->h;
  bool left = true, right = true, above = true, below = true;
  for (int i = 0; i < 4; i++) {
    left &= c[i].x < r->x;
    right &= c[i].x > x;
    above &= c[i].y < r->y;
    below &= c[i].y > y;
  }
  return left || right || above || below;
}

/* From c[0], where the trace is. */
static void curve(struct ph_trace *trace, const struct ph_spot c[4],
                  int halves) {
  const bool inside = is_inside(&trace->rect, c);
  if (is_flat(c) || (halves == 0 && !inside)) {
    step(trace, c[3]);
  } else if (inside || is_outside(&trace->rect, c)) {
    if (inside && !trace->down) {
      ph_page_move(trace->page, c[0]);
    }
    if (inside) {
      ph_page_curve(trace->page, c + 1);
    }
    trace->any |= inside;
    trace->down = inside;
    trace->last = c[3];
    /* of a cubic that turns little: the mean of chord and polygon */
    trace->length += 0.5 * (apart(c[0], c[3]) + apart(c[0], c[1]) +
                            apart(c[1], c[2]) + apart(c[2], c[3]));
  } else {
    const struct ph_spot a = middle(c[0], c[1]), b = middle(c[1], c[2]);
    const struct ph_spot d = middle(c[2], c[3]);
    const struct ph_spot ab = middle(a, b), bd = middle(b, d);
    const struct ph_spot at = middle(ab, bd);
    const struct ph_spot first[4] = {c[0], a, ab, at},
                         last[4] = {at, bd, d, c[3]};
    curve(trace, first, halves - 1);
    curve(trace, last, halves - 1);
  }
}

void ph_trace_curve(struct ph_trace *trace, const struct ph_spot spots[3]) {
  struct ph_spot c[4] = {trace->skips ? trace->skipped : trace->last};
  bool finite = true, small = true;
  for (int i = 0; i < 3; i++) {
    c[i + 1] = spots[i];
    finite &= isfinite(spots[i].x) && isfinite(spots[i].y);
    small &= apart(c[0], spots[i]) < STEP_MIN;
  }
  if (!finite || !trace->on || small) {
    ph_trace_to(trace, finite ? c[3] : (struct ph_spot){(double)NAN, 0});
    return;
  }
  if (trace->skips) {
    step(trace, trace->skipped);
  }
  curve(trace, c, HALVES_MAX);
}

/* ---- lines --------------------------------------------------------------- */

void ph_trace_break(struct ph_trace *trace) {
  if (trace->skips) {
    step(trace, trace->skipped);
  }
  trace->on = trace->down = false;
}

void ph_trace_to(struct ph_trace *trace, struct ph_spot spot) {
  if (!(isfinite(spot.x) && isfinite(spot.y))) {
    ph_trace_break(trace);
  } else if (!trace->on) {
    trace->on = true;
    trace->last = trace->skipped = spot;
  } else if (hypot(spot.x - trace->last.x, spot.y - trace->last.y) < STEP_MIN) {
    trace->skipped = spot;
    trace->skips = true;
  } else {
    step(trace, spot);
  }
}

void ph_trace_end(struct ph_trace *trace) {
  ph_trace_break(trace);
  if (trace->any) {
    ph_page_stroke(trace->page);
  }
}
