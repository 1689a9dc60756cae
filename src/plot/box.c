/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The box of what is seen from an angle (see box.h). */
#include "plot/box.h"

#include "plot/axes.h"

#include <math.h>

/* In ems: what numbers and names take of a window's width and height; a tick,
 * the middle of a number and of a name outside of it. */
#define WIDE 5.5
#define HIGH 4.5
#define TICK 0.32
#define NUMBER 0.95
#define NUMBER_SIZE 0.72
#define NAME 2.0
#define NAME_SIZE 0.82

/* Numbers are no nearer to each other than this. */
#define NUMBER_WIDE 1.5
#define NUMBER_HIGH 0.8

/* Ticks are so far from each other. */
#define EACH 2.6

/* The box of the curves in the fourth view, the middle of it in the middle. */
static void draw_edges(struct ph_look *look) {
  const struct ph_panel *panel = look->panel;
  double low[2] = {9, 9}, high[2] = {-9, -9};
  ph_vec3 corners[8];
  static const int edges[12][2] = {{0, 1}, {2, 3}, {4, 5}, {6, 7},
                                   {0, 2}, {1, 3}, {4, 6}, {5, 7},
                                   {0, 4}, {1, 5}, {2, 6}, {3, 7}};
  for (int i = 0; i < 8; i++) {
    struct ph_seen seen;
    corners[i] = ph_vec3_of(i & 1 ? panel->high.x : panel->low.x,
                            i & 2 ? panel->high.y : panel->low.y,
                            i & 4 ? panel->high.z : panel->low.z);
    seen = ph_view_see(&look->view, corners[i]);
    low[0] = fmin(low[0], seen.u);
    low[1] = fmin(low[1], seen.v);
    high[0] = fmax(high[0], seen.u);
    high[1] = fmax(high[1], seen.v);
  }
  look->window.u = 0.5 * (low[0] + high[0]);
  look->window.v = 0.5 * (low[1] + high[1]);
  look->window.scale =
      fmin(look->window.scale, fmin((look->window.rect.w - WIDE * look->em) /
                                        fmax(high[0] - low[0], 1e-3),
                                    (look->window.rect.h - HIGH * look->em) /
                                        fmax(high[1] - low[1], 1e-3)));
  ph_page_pen(look->page, ph_ink(PH_INK_BOX), 0.055 * look->em, 0);
  for (int i = 0; i < 12; i++) {
    ph_vec3 edge[2] = {corners[edges[i][0]], corners[edges[i][1]]};
    ph_strokes_line(look, PH_SIDE_ALL, edge, 2);
  }
}

/* An edge of the box that an axis is drawn at. */
struct edge {
  ph_vec3 end[2];
  struct ph_spot spot[2];
  double out[2]; /* unit vector on the page, away from the box */
};

/* Edges in front: of x and y the lowest, of z the leftmost. */
static struct edge edge_of(const struct ph_look *look, int axis) {
  const struct ph_panel *panel = look->panel;
  const double low[3] = {panel->low.x, panel->low.y, panel->low.z};
  const double high[3] = {panel->high.x, panel->high.y, panel->high.z};
  struct edge edge = {.out = {0, 0}};
  double best = HUGE_VAL, along[2], way;
  for (int k = 0; k < 4; k++) {
    double p[2][3];
    struct ph_seen seen[2];
    for (int e = 0; e < 2; e++) {
      p[e][axis] = e ? high[axis] : low[axis];
      p[e][(axis + 1) % 3] = (k & 1 ? high : low)[(axis + 1) % 3];
      p[e][(axis + 2) % 3] = (k & 2 ? high : low)[(axis + 2) % 3];
      seen[e] = ph_view_see(&look->view, ph_vec3_get(p[e], 3));
    }
    if ((axis < 2 ? seen[0].v + seen[1].v : seen[0].u + seen[1].u) < best) {
      best = axis < 2 ? seen[0].v + seen[1].v : seen[0].u + seen[1].u;
      for (int e = 0; e < 2; e++) {
        edge.end[e] = ph_vec3_get(p[e], 3);
        edge.spot[e] = ph_window_spot(&look->window, seen[e]);
      }
    }
  }
  along[0] = edge.spot[1].x - edge.spot[0].x;
  along[1] = edge.spot[1].y - edge.spot[0].y;
  way = hypot(along[0], along[1]);
  edge.out[0] = way > 0 ? -along[1] / way : 0;
  edge.out[1] = way > 0 ? along[0] / way : 1;
  if (axis < 2 ? edge.out[1] < 0 : edge.out[0] > 0) {
    edge.out[0] = -edge.out[0];
    edge.out[1] = -edge.out[1];
  }
  return edge;
}

static struct ph_spot outside(const struct edge *edge, double t, double far) {
  return (struct ph_spot){
      edge->spot[0].x + t * (edge->spot[1].x - edge->spot[0].x) +
          far * edge->out[0],
      edge->spot[0].y + t * (edge->spot[1].y - edge->spot[0].y) +
          far * edge->out[1]};
}

/* Where numbers are: those of two axes may meet at a corner. */
struct taken {
  struct ph_spot at[3 * PH_TICKS_MAX];
  size_t n;
};

static bool take(struct taken *taken, struct ph_spot at, double em) {
  for (size_t i = 0; i < taken->n; i++) {
    if (fabs(taken->at[i].x - at.x) < NUMBER_WIDE * em &&
        fabs(taken->at[i].y - at.y) < NUMBER_HIGH * em) {
      return false;
    }
  }
  taken->at[taken->n++] = at;
  return true;
}

/* Where the name of an upright axis is: between two numbers, which may be as
 * wide as they like, near the middle. */
static double between_numbers(const struct ph_axis *axis) {
  double best = 0.5, off = HUGE_VAL;
  for (size_t i = 0; i + 1 < axis->ticks.n; i++) {
    const double t = (ph_axis_place(axis, axis->ticks.at[i]) +
                      ph_axis_place(axis, axis->ticks.at[i + 1])) /
                     2;
    if (fabs(t - 0.5) < off) {
      off = fabs(t - 0.5);
      best = t;
    }
  }
  return best;
}

static void draw_axis(const struct ph_look *look, int which,
                      struct taken *taken) {
  static const char *const names[3] = {"x", "y", "z"};
  const struct ph_unit *unit = &look->panel->unit;
  const struct edge edge = edge_of(look, which);
  const double center[3] = {unit->center.x, unit->center.y, unit->center.z};
  const double from[3] = {edge.end[0].x, edge.end[0].y, edge.end[0].z};
  const double to[3] = {edge.end[1].x, edge.end[1].y, edge.end[1].z};
  const double em = look->em;
  const double way =
      hypot(edge.spot[1].x - edge.spot[0].x, edge.spot[1].y - edge.spot[0].y);
  struct ph_axis axis = {
      .name = names[which],
      .low = ph_unit_out(center[which], unit->size, from[which]),
      .high = ph_unit_out(center[which], unit->size, to[which])};
  const double wanted = fmin(floor(way / (EACH * em)), PH_TICKS_MAX - 1);
  struct ph_spot at;
  ph_ticks_make(axis.low, axis.high, wanted >= 1 ? (size_t)wanted : 1,
                &axis.ticks);
  for (size_t i = 0; i < axis.ticks.n; i++) {
    const double t = ph_axis_place(&axis, axis.ticks.at[i]);
    ph_page_pen(look->page, ph_ink(PH_INK_TICK), 0.055 * em, 0);
    ph_page_move(look->page, outside(&edge, t, 0));
    ph_page_line(look->page, outside(&edge, t, TICK * em));
    ph_page_stroke(look->page);
    at = outside(&edge, t, NUMBER * em);
    at.y += 0.33 * NUMBER_SIZE * em;
    if (!take(taken, at, em)) {
      continue;
    }
    ph_page_text(look->page, at, NUMBER_SIZE * em, which < 2 ? 0.5 : 0.75,
                 false, axis.ticks.label[i]);
  }
  at = outside(&edge, which < 2 ? 0.5 : between_numbers(&axis), NAME * em);
  at.y += 0.33 * NAME_SIZE * em;
  ph_axis_name(&axis, look->page, NAME_SIZE * em, 0, at, false);
}

void ph_box_draw(struct ph_look *look) {
  struct taken taken = {.n = 0};
  draw_edges(look);
  for (int i = 0; i < 3; i++) {
    draw_axis(look, i, &taken);
  }
}
