/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Lines and cubics on their way to the page: cut to a rectangle, broken where
 * it is not finite, without steps that nobody can see.  One trace is one path.
 */
#ifndef PH_PLOT_TRACE_H
#define PH_PLOT_TRACE_H

#include "plot/page.h"

struct ph_trace {
  struct ph_page *page;
  struct ph_rect rect;
  struct ph_spot last, skipped; /* drawn up to, seen up to */
  bool on, skips, down;         /* there is a last, skipped; the pen is at it */
  bool any;
  double length; /* of what was drawn, hidden or not */
};

/* ph_trace_begin: the pen has been chosen (ph_page_pen). */
void ph_trace_begin(struct ph_trace *trace, struct ph_page *page,
                    const struct ph_rect *rect);

/* ph_trace_to: goes on to a spot; not finite: breaks off. */
void ph_trace_to(struct ph_trace *trace, struct ph_spot spot);

/* ph_trace_curve: goes on by a cubic, given by its other control points.  What
 * is straight to the digits of a file is a line. */
void ph_trace_curve(struct ph_trace *trace, const struct ph_spot spots[3]);

/* ph_trace_break: what follows is not connected. */
void ph_trace_break(struct ph_trace *trace);

/* ph_trace_end: strokes it, if any of it is in the rectangle. */
void ph_trace_end(struct ph_trace *trace);

#endif
