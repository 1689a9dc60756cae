/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a view of a panel shows (see strokes.h). */
#include "plot/strokes.h"

#include "plot/lines.h"
#include "plot/trace.h"

#include <math.h>

/* In ems: dots; numbers, and what they take. */
#define DOT_MAX 0.22
#define DOT_MIN 0.09
#define LABEL 0.75
#define LABEL_RIGHT 0.3
#define LABEL_UP 0.35
#define LABEL_WIDE 1.2
#define LABEL_HIGH 0.75

/* A place of the data in the view. */
static struct ph_seen see(const struct ph_look *look, ph_vec3 place) {
  return ph_view_see(&look->view, ph_unit_in(&look->panel->unit, place));
}

static struct ph_spot spot_of(const struct ph_look *look, struct ph_seen seen) {
  return ph_window_spot(&look->window, seen);
}

/* ---- lines --------------------------------------------------------------- */

static bool shown(struct ph_seen seen, enum ph_side side) {
  return side == PH_SIDE_ALL ||
         ph_view_hidden(seen) == (side == PH_SIDE_HIDDEN);
}

static struct ph_seen between(struct ph_seen a, struct ph_seen b, double t) {
  struct ph_seen m = {a.u + t * (b.u - a.u), a.v + t * (b.v - a.v), 0};
  return m;
}

/* Goes from one place to the next; only the parts of a side are drawn. */
static void go(const struct ph_look *look, enum ph_side side,
               struct ph_trace *trace, const struct ph_seen *from,
               struct ph_seen to) {
  bool now = shown(to, side);
  if (from && shown(*from, side) != now) {
    double t = ph_view_horizon(*from, to);
    ph_trace_to(trace, spot_of(look, between(*from, to, t)));
    if (!now) {
      ph_trace_break(trace);
    }
  }
  if (now) {
    ph_trace_to(trace, spot_of(look, to));
  }
}

void ph_strokes_line(const struct ph_look *look, enum ph_side side,
                     const ph_vec3 *places, size_t n) {
  struct ph_trace trace;
  struct ph_seen last = {0, 0, 0};
  ph_trace_begin(&trace, look->page, &look->window.rect);
  for (size_t i = 0; i < n; i++) {
    struct ph_seen seen = ph_view_see(&look->view, places[i]);
    go(look, side, &trace, i > 0 ? &last : NULL, seen);
    last = seen;
  }
  ph_trace_end(&trace);
}

/* ---- cubics -------------------------------------------------------------- */

/* Of the cubic c the part before t, or behind it. */
static void cut(const struct ph_seen c[4], double t, bool behind,
                struct ph_seen part[4]) {
  struct ph_seen row[4] = {c[0], c[1], c[2], c[3]};
  part[behind ? 3 : 0] = row[behind ? 3 : 0];
  for (int n = 3; n > 0; n--) {
    for (int i = 0; i < n; i++) {
      const double depth = row[i].depth;
      const double to = row[i + 1].depth;
      row[i] = between(row[i], row[i + 1], t);
      row[i].depth = depth + t * (to - depth);
    }
    part[behind ? n - 1 : 4 - n] = row[behind ? n - 1 : 0];
  }
}

/* Where on the cubic, whose ends are on different sides, the side changes. */
static double horizon(const struct ph_seen c[4]) {
  const bool first = ph_view_hidden(c[0]);
  double low = 0, high = 1;
  for (int i = 0; i < 40; i++) {
    const double t = 0.5 * (low + high);
    struct ph_seen part[4];
    cut(c, t, false, part);
    if (ph_view_hidden(part[3]) == first) {
      low = t;
    } else {
      high = t;
    }
  }
  return low;
}

static void trace_cubic(const struct ph_look *look, struct ph_trace *trace,
                        const struct ph_seen c[4]) {
  const struct ph_spot spots[3] = {spot_of(look, c[1]), spot_of(look, c[2]),
                                   spot_of(look, c[3])};
  ph_trace_curve(trace, spots);
}

/* Goes along a cubic; only the parts of a side are drawn. */
static void go_along(const struct ph_look *look, enum ph_side side,
                     struct ph_trace *trace, const struct ph_seen c[4]) {
  const bool from = shown(c[0], side), to = shown(c[3], side);
  struct ph_seen part[4];
  if (from == to) {
    if (from) {
      trace_cubic(look, trace, c);
    }
    return;
  }
  cut(c, horizon(c), to, part);
  if (to) {
    ph_trace_to(trace, spot_of(look, part[0]));
  }
  trace_cubic(look, trace, part);
  if (!to) {
    ph_trace_break(trace);
  }
}

/* ret  the length of the line */
static double draw_line(const struct ph_look *look, enum ph_side side,
                        const struct ph_stroke *stroke) {
  struct ph_trace trace;
  struct ph_seen last = {0, 0, 0};
  ph_trace_begin(&trace, look->page, &look->window.rect);
  for (size_t i = 0; i < stroke->n; i++) {
    struct ph_seen seen = see(look, stroke->points[i]);
    if (i > 0 && stroke->handles) {
      const ph_vec3 *handles = stroke->handles + 2 * (i - 1);
      const struct ph_seen c[4] = {last, see(look, handles[0]),
                                   see(look, handles[1]), seen};
      go_along(look, side, &trace, c);
    } else {
      go(look, side, &trace, i > 0 ? &last : NULL, seen);
    }
    last = seen;
  }
  ph_trace_end(&trace);
  return trace.length;
}

/* ---- arrows -------------------------------------------------------------- */

/* The head of an arrow from somewhere towards (dx, dy) ahead of its neck. */
static void draw_head(const struct ph_look *look, struct ph_spot tip, double dx,
                      double dy) {
  struct ph_spot neck = {tip.x - 0.8 * dx, tip.y - 0.8 * dy};
  struct ph_spot left = {tip.x - dx - 0.3 * dy, tip.y - dy + 0.3 * dx};
  struct ph_spot right = {tip.x - dx + 0.3 * dy, tip.y - dy - 0.3 * dx};
  if (ph_rect_has(&look->window.rect, tip, 0) &&
      ph_rect_has(&look->window.rect, neck, 0)) {
    ph_page_move(look->page, tip);
    ph_page_line(look->page, left);
    ph_page_line(look->page, neck);
    ph_page_line(look->page, right);
    ph_page_close(look->page);
    ph_page_fill(look->page);
  }
}

/* A thin arrow; it is as visible as its root is. */
static void draw_arrow(const struct ph_look *look, enum ph_side side,
                       const struct ph_stroke *stroke) {
  struct ph_seen root = see(look, stroke->points[0]);
  struct ph_spot at = spot_of(look, root), from = at;
  struct ph_spot tip = spot_of(look, see(look, stroke->points[stroke->n - 1]));
  double head = hypot(tip.x - at.x, tip.y - at.y), far;
  struct ph_trace trace;
  head = fmin(PH_LINE_HEAD * look->em, 0.5 * head);
  if (!shown(root, side) || !(head > 0)) {
    return;
  }
  ph_trace_begin(&trace, look->page, &look->window.rect);
  for (size_t i = 0; i + 1 < stroke->n; i++) {
    at = spot_of(look, see(look, stroke->points[i]));
    if (hypot(tip.x - at.x, tip.y - at.y) >= head) {
      ph_trace_to(&trace, at);
      from = at;
    }
  }
  far = head / hypot(tip.x - from.x, tip.y - from.y);
  at.x = tip.x - 0.8 * far * (tip.x - from.x);
  at.y = tip.y - 0.8 * far * (tip.y - from.y);
  ph_trace_to(&trace, at);
  ph_trace_end(&trace);
  draw_head(look, tip, far * (tip.x - from.x), far * (tip.y - from.y));
}

void ph_strokes_arrow(const struct ph_look *look, const ph_vec3 ends[2]) {
  const struct ph_spot root = spot_of(look, ph_view_see(&look->view, ends[0]));
  const struct ph_spot tip = spot_of(look, ph_view_see(&look->view, ends[1]));
  const double way = hypot(tip.x - root.x, tip.y - root.y);
  const double part = fmin(PH_LINE_HEAD * look->em, 0.5 * way) / way;
  const double dx = part * (tip.x - root.x), dy = part * (tip.y - root.y);
  const ph_vec3 neck =
      ph_vec3_along(ends[0], 1 - 0.8 * part, ph_vec3_sub(ends[1], ends[0]));
  const ph_vec3 line[2] = {ends[0], neck};
  if (way > 0) {
    ph_strokes_line(look, PH_SIDE_ALL, line, 2);
    draw_head(look, tip, dx, dy);
  }
}

/* ---- what curves of a sweep share ---------------------------------------- */

/* The same to the eye. */
static bool same_place(const struct ph_look *look, ph_vec3 a, ph_vec3 b) {
  const struct ph_unit *unit = &look->panel->unit;
  ph_vec3 d = ph_vec3_sub(ph_unit_in(unit, a), ph_unit_in(unit, b));
  return fabs(d.x) <= 1e-6 && fabs(d.y) <= 1e-6 && fabs(d.z) <= 1e-6;
}

/* Whether the first (last) drawing has the same tangent there. */
static bool has_tangent(const struct ph_look *look, const struct ph_drawing *d,
                        size_t i, const struct ph_stroke *stroke) {
  const struct ph_stroke *s = i < d->strokes_n ? &d->strokes[i] : NULL;
  return s && s->role == PH_STROKE_TANGENT && s->n > 0 &&
         same_place(look, s->points[0], stroke->points[0]) &&
         same_place(look, s->points[s->n - 1], stroke->points[stroke->n - 1]);
}

static bool has_point(const struct ph_look *look, const struct ph_drawing *d,
                      size_t i, ph_vec3 point) {
  return i < d->data_n && same_place(look, d->data[i], point);
}

/* ---- strokes ------------------------------------------------------------- */

static void choose_pen(const struct ph_look *look, enum ph_side side,
                       size_t which, const struct ph_stroke *stroke,
                       size_t segment, bool moves) {
  const struct ph_panel *panel = look->panel;
  const struct ph_drawing *d = panel->drawings[which];
  double em = look->em, dash = side == PH_SIDE_HIDDEN ? PH_LINE_DASH * em : 0;
  bool many = panel->n > 1;
  double thin = ph_colour_thin(panel->n);
  struct ph_colour ramp = ph_colour_ramp(which, panel->n);
  switch (stroke->role) {
  case PH_STROKE_CURVE:
    ph_page_pen(look->page,
                many ? ramp
                     : ph_colour_segment(segment, d->segments_n, d->closed),
                (dash > 0 ? 0.7 : 1) * PH_LINE_CURVE * thin * em, dash);
    break;
  case PH_STROKE_POLYGON:
    ph_page_pen(look->page, ph_ink(PH_INK_POLYGON), PH_LINE_POLYGON * em, dash);
    break;
  case PH_STROKE_OFFSET:
    ph_page_pen(look->page, many ? ramp : ph_ink(PH_INK_OFFSET),
                PH_LINE_OFFSET * thin * em, dash);
    break;
  case PH_STROKE_TRIMMED:
    ph_page_pen(look->page, ph_ink(PH_INK_TRIMMED), PH_LINE_TRIMMED * em,
                PH_LINE_DASH * em);
    break;
  case PH_STROKE_TANGENT:
    ph_page_pen(look->page, moves ? ramp : ph_ink(PH_INK_TANGENT),
                PH_LINE_ARROW * em, dash);
    break;
  case PH_STROKE_N:
    break;
  }
}

/* Curves of a sweep have no details. */
static bool is_detail(enum ph_stroke_role role) {
  return role == PH_STROKE_POLYGON || role == PH_STROKE_TRIMMED;
}

static void draw_strokes(const struct ph_look *look, enum ph_side side,
                         size_t which) {
  const struct ph_panel *panel = look->panel;
  const struct ph_drawing *d = panel->drawings[which];
  struct ph_dash dash = ph_colour_dash(which, panel->n, look->em);
  size_t segment = 0;
  for (size_t i = 0; i < d->strokes_n; i++) {
    const struct ph_stroke *s = &d->strokes[i];
    bool tangent = s->role == PH_STROKE_TANGENT, moves;
    if (s->n == 0 || (is_detail(s->role) && panel->n > 1) ||
        (tangent && which > 0 && has_tangent(look, panel->drawings[0], i, s))) {
      continue;
    }
    moves =
        tangent && panel->n > 1 &&
        (which > 0 || !has_tangent(look, panel->drawings[panel->n - 1], i, s));
    choose_pen(look, side, which, s, segment, moves);
    segment += s->role == PH_STROKE_CURVE;
    if (tangent) {
      draw_arrow(look, side, s);
      continue;
    }
    if (panel->n > 1 && side != PH_SIDE_HIDDEN) {
      ph_page_dash(look->page, &dash);
    }
    dash.phase += draw_line(look, side, s); /* goes on in the next segment */
  }
}

/* ---- points -------------------------------------------------------------- */

/* Dots are smaller where they would touch. */
static double dot_radius(const struct ph_look *look,
                         const struct ph_drawing *d) {
  double sum = 0;
  struct ph_spot last = {0, 0};
  for (size_t i = 0; i < d->data_n; i++) {
    struct ph_spot spot = spot_of(look, see(look, d->data[i]));
    double step = hypot(spot.x - last.x, spot.y - last.y);
    sum += i > 0 && isfinite(step) ? step : 0;
    last = spot;
  }
  sum = sum > 0 ? sum / ((double)d->data_n - 1) : 2 * look->em;
  return fmin(fmax(0.13 * sum, DOT_MIN * look->em), DOT_MAX * look->em);
}

/* Points of all curves of a sweep are black, and others of its colour. */
static void draw_points(const struct ph_look *look, enum ph_side side,
                        size_t which) {
  const struct ph_panel *panel = look->panel;
  const struct ph_drawing *d = panel->drawings[which];
  double r = dot_radius(look, d) * (side == PH_SIDE_HIDDEN ? 0.8 : 1);
  enum ph_ink ink = side == PH_SIDE_HIDDEN ? PH_INK_OUTLINE : PH_INK_POINT;
  for (size_t i = 0; i < d->data_n; i++) {
    struct ph_seen seen = see(look, d->data[i]);
    struct ph_spot spot = spot_of(look, seen);
    bool stays = panel->n == 1 ||
                 has_point(look, panel->drawings[panel->n - 1], i, d->data[i]);
    if (shown(seen, side) && ph_rect_has(&look->window.rect, spot, 0) &&
        (which == 0 || !has_point(look, panel->drawings[0], i, d->data[i]))) {
      ph_page_pen(look->page,
                  stays && which == 0 ? ph_ink(ink)
                                      : ph_colour_ramp(which, panel->n),
                  1, 0);
      ph_page_circle(look->page, spot, stays && which == 0 ? r : 0.7 * r);
      ph_page_fill(look->page);
    }
  }
}

/* ---- numbers of points --------------------------------------------------- */

void ph_strokes_label(const struct ph_look *look, struct ph_labels *labels,
                      struct ph_spot spot, size_t number) {
  const double em = look->em;
  const struct ph_spot at = {spot.x + LABEL_RIGHT * em, spot.y - LABEL_UP * em};
  char text[PH_PLOT_TEXT_MAX];
  if (labels->n > PH_DRAWING_SEGMENTS ||
      !ph_rect_has(&look->window.rect, at, 0)) {
    return;
  }
  for (size_t k = 0; k < labels->n; k++) {
    if (!(fabs(at.x - labels->at[k].x) > LABEL_WIDE * em ||
          fabs(at.y - labels->at[k].y) > LABEL_HIGH * em)) {
      return;
    }
  }
  labels->at[labels->n++] = at;
  ph_plot_text_number(number, text);
  ph_page_text(look->page, at, LABEL * em, 0, false, text);
}

/* Of the points that can be seen. */
static void draw_labels(const struct ph_look *look, enum ph_side side) {
  const struct ph_drawing *d = look->panel->drawings[0];
  struct ph_labels labels;
  labels.n = 0;
  for (size_t i = 0; i < d->data_n; i++) {
    const struct ph_seen seen = see(look, d->data[i]);
    if (shown(seen, side)) {
      ph_strokes_label(look, &labels, spot_of(look, seen),
                       d->numbers ? d->numbers[i] : i);
    }
  }
}

void ph_strokes_draw(const struct ph_look *look, enum ph_side side) {
  for (size_t i = 0; i < look->panel->n; i++) {
    draw_strokes(look, side, i);
  }
  for (size_t i = 0; i < look->panel->n; i++) {
    draw_points(look, side, i);
  }
  if (look->panel->labels && side != PH_SIDE_HIDDEN) {
    draw_labels(look, side);
  }
}
