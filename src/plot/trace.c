/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A polyline on its way to the page (see trace.h). */
#include "plot/trace.h"

#include <math.h>

/* Shorter steps are joined into one: a tenth of the thinnest line. */
#define STEP_MIN 0.05

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
