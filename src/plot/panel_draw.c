/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A panel on the page (see panel.h): where its parts go, and what is in them.
 */
#include "plot/box.h"
#include "plot/globe.h"
#include "plot/legend.h"
#include "plot/panel.h"

#include <math.h>
#include <string.h>

/* In ems: the title, the margins, a profile without its numbers. */
#define TITLE 1.25
#define TITLE_LINE 2.1
#define RIGHT 1.3
#define TOP 0.6
#define PROFILE 8.5
#define PROFILE_GAP 0.9
#define LEFT 5.5 /* of axes, before their numbers are known */
#define CAPTION 1.9
#define CAPTION_SIZE 0.82
#define LEGEND_GAP 1.2
#define VIEW_GAP 1.2

/* What is seen is so much smaller than its frame. */
#define MARGIN 1.1

/* ... and at least so much of its frame. */
#define LOOSE 1.7

/* A view is no flatter than this, whatever the curve. */
#define FLAT 0.18

/* The parts of a panel's place. */
struct place {
  const struct ph_panel *panel;
  struct ph_page *page;
  double em;
  double left;             /* room for numbers and names left of frames */
  struct ph_rect views;    /* frames of views without their numbers */
  struct ph_rect profiles; /* all of them, as the views */
};

/* ---- extents ------------------------------------------------------------- */

/* Widths of the box by axis, with a margin, none much less than the largest. */
static void extents(const struct ph_panel *panel, double extent[3]) {
  double most;
  extent[0] = panel->high.x - panel->low.x;
  extent[1] = panel->high.y - panel->low.y;
  extent[2] = panel->high.z - panel->low.z;
  most = fmax(fmax(extent[0], extent[1]), extent[2]);
  most = most > 0 ? most : 1; /* a point */
  for (int i = 0; i < 3; i++) {
    extent[i] = MARGIN * fmax(extent[i], FLAT * most);
  }
}

static double middle_of(const struct ph_panel *panel, int axis) {
  return axis == 0   ? 0.5 * (panel->low.x + panel->high.x)
         : axis == 1 ? 0.5 * (panel->low.y + panel->high.y)
                     : 0.5 * (panel->low.z + panel->high.z);
}

static double center_of(const struct ph_panel *panel, int axis) {
  return axis == 0   ? panel->unit.center.x
         : axis == 1 ? panel->unit.center.y
                     : panel->unit.center.z;
}

/* How high developments are, relative to their width. */
static double flat_aspect(const struct ph_panel *panel) {
  const ph_vec3 way = ph_vec3_sub(panel->flat_high, panel->flat_low);
  return fmax(way.y, FLAT * way.x) / fmax(way.x, FLAT * way.y);
}

static double views_height(const struct ph_panel *panel, double width,
                           double em) {
  double extent[3], inner = width - (LEFT + RIGHT) * em;
  extents(panel, extent);
  switch (panel->drawings[0]->space) {
  case PH_PLANE:
    return fmin(inner * extent[1] / extent[0], 1.1 * inner) + ph_axes_below(em);
  case PH_SPACE:
    inner *= (extent[1] + extent[2]) / (extent[0] + extent[1]);
    return fmin(inner, 1.25 * width) + ph_axes_below(em) + VIEW_GAP * em;
  case PH_SURFACE:
    return fmin(fmax(0.5 * inner * flat_aspect(panel), 0.36 * width),
                0.75 * width) +
           ph_axes_below(em);
  case PH_PATCHWORK:
    return (double)ph_quilt_rows(panel) * (0.34 * width + CAPTION * em);
  default:
    return panel->views_n == 2 ? 0.5 * width + CAPTION * em
                               : 0.8 * width + CAPTION * em;
  }
}

/* Of profiles with what is around them. */
static double profiles_height(const struct ph_panel *panel, double em) {
  return (PROFILE_GAP + PROFILE) * em * (double)panel->profiles_n +
         ph_axes_below(em);
}

double ph_panel_height(const struct ph_panel *panel, double width, double em) {
  double title = panel->title[0] ? TITLE_LINE * em : 0;
  return title + TOP * em + views_height(panel, width, em) +
         profiles_height(panel, em);
}

/* ---- axes ---------------------------------------------------------------- */

/* The axis of a window in the unit of the data, which a window shows `half` of
 * on either side of `middle`. */
static struct ph_axis axis_of(const struct ph_panel *panel, int which,
                              double middle, double half) {
  static const char *const names[3] = {"x", "y", "z"};
  double center = center_of(panel, which);
  struct ph_axis axis = {
      .name = names[which],
      .low = ph_unit_out(center, panel->unit.size, middle - half),
      .high = ph_unit_out(center, panel->unit.size, middle + half)};
  return axis;
}

static struct ph_axes axes_of(const struct place *place,
                              const struct ph_window *window, int x, int y) {
  const struct ph_panel *panel = place->panel;
  struct ph_axes axes = {
      window->rect, place->left,
      axis_of(panel, x, window->u, 0.5 * window->rect.w / window->scale),
      axis_of(panel, y, window->v, 0.5 * window->rect.h / window->scale)};
  return axes;
}

/* A window on two axes of the box that shows `scale` points for a unit. */
static struct ph_window window_of(const struct ph_panel *panel,
                                  const struct ph_rect *rect, int x, int y,
                                  double scale) {
  struct ph_window window = {*rect, middle_of(panel, x), middle_of(panel, y),
                             scale};
  return window;
}

/* ---- views --------------------------------------------------------------- */

static void draw_view(const struct place *place, size_t view,
                      const struct ph_window *window) {
  struct ph_look look = {place->panel, place->panel->views[view], *window,
                         place->page, place->em};
  ph_strokes_draw(&look, PH_SIDE_ALL);
}

/* Frames are no more than so much larger than what they show: the middle of
 * the place for w times h points of it. */
static struct ph_rect trimmed(const struct ph_rect *place, double w, double h) {
  double wide = fmin(place->w, LOOSE * w), high = fmin(place->h, LOOSE * h);
  return (struct ph_rect){place->x + 0.5 * (place->w - wide),
                          place->y + 0.5 * (place->h - high), wide, high};
}

static struct ph_axes plane_axes(const struct place *place,
                                 struct ph_window *window) {
  double extent[3], scale;
  struct ph_rect frame;
  extents(place->panel, extent);
  scale = fmin(place->views.w / extent[0], place->views.h / extent[1]);
  frame = trimmed(&place->views, scale * extent[0], scale * extent[1]);
  *window = window_of(place->panel, &frame, 0, 1, scale);
  return axes_of(place, window, 0, 1);
}

static void draw_plane(const struct place *place) {
  struct ph_window window;
  struct ph_axes axes = plane_axes(place, &window);
  ph_axes_ticks(&axes, place->page, place->em);
  draw_view(place, 0, &window);
  ph_axes_draw(&axes, place->page, place->em);
}

/* Of space: x-y above x-z, y-z to the right of that; all to one scale. */
struct space {
  struct ph_window windows[3];
  struct ph_axes axes[3];
  struct ph_rect corner; /* for the fourth view */
  double scale;
};

static void space_layout(const struct place *place, struct space *space) {
  double extent[3], gap = VIEW_GAP * place->em, left, top, wide, high;
  struct ph_rect rects[3], r = place->views;
  extents(place->panel, extent);
  wide = extent[0] + extent[1];
  high = extent[1] + extent[2];
  r.w -= gap;
  r.h -= gap;
  space->scale = fmin(r.w / wide, r.h / high);
  r = trimmed(&r, space->scale * wide, space->scale * high);
  left = r.w * extent[0] / wide;
  top = r.h * extent[1] / high;
  rects[0] = (struct ph_rect){r.x, r.y, left, top};
  rects[1] = (struct ph_rect){r.x, r.y + top + gap, left, r.h - top};
  rects[2] =
      (struct ph_rect){r.x + left + gap, rects[1].y, r.w - left, r.h - top};
  space->corner = (struct ph_rect){rects[2].x, r.y, r.w - left, top};
  for (int i = 0; i < 3; i++) {
    int x = i == 2 ? 1 : 0, y = i == 0 ? 1 : 2;
    space->windows[i] = window_of(place->panel, &rects[i], x, y, space->scale);
    space->axes[i] = axes_of(place, &space->windows[i], x, y);
  }
  space->axes[0].x.bare = space->axes[2].y.bare = true;
}

static void draw_space(const struct place *place) {
  struct space space;
  struct ph_look look = {.panel = place->panel,
                         .view = place->panel->views[3],
                         .page = place->page,
                         .em = place->em};
  space_layout(place, &space);
  for (int i = 0; i < 3; i++) {
    ph_axes_ticks(&space.axes[i], place->page, place->em);
  }
  space.axes[0].x.ticks = space.axes[1].x.ticks;
  space.axes[2].y.ticks = space.axes[1].y.ticks;
  for (size_t i = 0; i < 3; i++) {
    draw_view(place, i, &space.windows[i]);
    ph_axes_draw(&space.axes[i], place->page, place->em);
  }
  look.window = (struct ph_window){space.corner, 0, 0, space.scale};
  ph_box_draw(&look);
  ph_strokes_draw(&look, PH_SIDE_ALL);
}

/* ---- surfaces ------------------------------------------------------------ */

/* The axes of the development: u and v to one scale. */
static struct ph_axes flat_axes(const struct ph_panel *panel,
                                const struct ph_rect *rect,
                                struct ph_window *window) {
  const struct ph_unit *unit = &panel->flat_unit;
  const ph_vec3 low = panel->flat_low, high = panel->flat_high;
  const double most = fmax(high.x - low.x, high.y - low.y);
  const double w = MARGIN * fmax(high.x - low.x, FLAT * most);
  const double h = MARGIN * fmax(high.y - low.y, FLAT * most);
  const double scale = fmin(rect->w / w, rect->h / h);
  const struct ph_rect frame = trimmed(rect, scale * w, scale * h);
  const double x = 0.5 * frame.w / scale, y = 0.5 * frame.h / scale;
  *window = (struct ph_window){frame, 0.5 * (low.x + high.x),
                               0.5 * (low.y + high.y), scale};
  return (struct ph_axes){
      frame,
      0,
      {.name = "u",
       .low = ph_unit_out(unit->center.x, unit->size, window->u - x),
       .high = ph_unit_out(unit->center.x, unit->size, window->u + x)},
      {.name = "v",
       .low = ph_unit_out(unit->center.y, unit->size, window->v - y),
       .high = ph_unit_out(unit->center.y, unit->size, window->v + y)}};
}

/* The surface in its box, and to the right of it the development. */
static void draw_surface(const struct place *place) {
  const struct ph_rect *r = &place->views;
  const double em = place->em, left = LEFT * em;
  const double half = 0.5 * (r->w + place->left);
  struct ph_panel flat = *place->panel;
  struct ph_look look = {.panel = place->panel,
                         .view = place->panel->views[0],
                         .page = place->page,
                         .em = em};
  const struct ph_rect right = {r->x - place->left + half + left, r->y,
                                half - left, r->h};
  struct ph_axes axes;
  look.window = (struct ph_window){
      {r->x - place->left, r->y, half, r->h + ph_axes_below(em)}, 0, 0, 1e9};
  ph_box_draw(&look);
  ph_solid_draw(&look);
  flat.unit = flat.flat_unit;
  look.panel = &flat;
  look.view = ph_view_axes(0, 1);
  axes = flat_axes(place->panel, &right, &look.window);
  ph_axes_ticks(&axes, place->page, em);
  ph_solid_flat(&look);
  ph_axes_draw(&axes, place->page, em);
}

/* ---- the sphere ---------------------------------------------------------- */

static void draw_sphere(const struct place *place) {
  for (size_t i = 0; i < place->panel->views_n; i++) {
    const struct ph_rect *r = &place->views;
    double w = r->w / (double)place->panel->views_n, reach;
    double h = r->h - CAPTION * place->em, side = fmin(w - place->em, h);
    struct ph_look look = {.panel = place->panel,
                           .view = place->panel->views[i],
                           .page = place->page,
                           .em = place->em};
    struct ph_seen middle;
    struct ph_spot at;
    char text[PH_GLOBE_CAPTION_MAX];
    reach = ph_globe_reach(place->panel, &look.view, &middle);
    look.window.rect = (struct ph_rect){r->x + w * (double)i + 0.5 * (w - side),
                                        r->y + 0.5 * (h - side), side, side};
    look.window.u = middle.u;
    look.window.v = middle.v;
    look.window.scale = 0.5 * side / (reach < 1 ? reach : 1.04);
    ph_globe_draw(&look, reach);
    ph_strokes_draw(&look, PH_SIDE_HIDDEN);
    ph_strokes_draw(&look, PH_SIDE_VISIBLE);
    ph_globe_caption(&look.view, text);
    at.x = look.window.rect.x + 0.5 * side;
    at.y = look.window.rect.y + side + 0.7 * CAPTION * place->em;
    ph_page_text(place->page, at, CAPTION_SIZE * place->em, 0.5, false, text);
    if (reach < 1) {
      ph_page_pen(place->page, ph_ink(PH_INK_FRAME), 0.055 * place->em, 0);
      ph_page_rect(place->page, &look.window.rect);
      ph_page_stroke(place->page);
    }
  }
}

/* ---- profiles ------------------------------------------------------------ */

static const char *profile_name(const struct ph_panel *panel, size_t which) {
  static const char *const names[PH_SPACES][PH_PANEL_PROFILES_MAX] = {
      [PH_PLANE] = {"curvature", "torsion"},
      [PH_SPACE] = {"curvature", "torsion"},
      [PH_SPHERE] = {"geodesic curvature", "torsion"},
      [PH_SURFACE] = {"normal curvature", "geodesic curvature"}};
  return names[panel->drawings[0]->space][which];
}

static struct ph_axes profile_axes(const struct place *place, size_t which) {
  const struct ph_panel *panel = place->panel;
  const struct ph_range *range = &panel->ranges[which];
  double n = (double)panel->profiles_n, gap = PROFILE_GAP * place->em;
  double h = (place->profiles.h - (n - 1) * gap) / n;
  struct ph_axes axes = {{place->profiles.x,
                          place->profiles.y + (double)which * (h + gap),
                          place->profiles.w, h},
                         place->left,
                         {.name = "arc length",
                          .low = 0,
                          .high = panel->length,
                          .bare = which + 1 < panel->profiles_n},
                         {.name = profile_name(panel, which),
                          .low = range->low,
                          .high = range->high}};
  return axes;
}

static void draw_profiles(const struct place *place) {
  const struct ph_panel *panel = place->panel;
  for (size_t i = 0; i < panel->profiles_n; i++) {
    struct ph_axes axes = profile_axes(place, i);
    ph_axes_ticks(&axes, place->page, place->em);
    ph_profile_draw(panel->drawings, panel->n, (enum ph_profile_of)i, &axes,
                    place->page, place->em);
    ph_axes_draw(&axes, place->page, place->em);
    if (!panel->ranges[i].any) { /* as the torsion of a straight line */
      struct ph_spot middle = {axes.rect.x + 0.5 * axes.rect.w,
                               axes.rect.y + 0.35 * axes.rect.h};
      ph_page_text(place->page, middle, CAPTION_SIZE * place->em, 0.5, false,
                   "not defined");
    }
  }
}

/* ---- the panel ----------------------------------------------------------- */

/* How much room the widest numbers at the left take. */
static double left_of(const struct place *place) {
  double most = 0;
  for (size_t i = 0; i < place->panel->profiles_n; i++) {
    struct ph_axes axes = profile_axes(place, i);
    ph_axes_ticks(&axes, place->page, place->em);
    most = fmax(most, ph_axes_left(&axes, place->page, place->em));
  }
  if (place->panel->drawings[0]->space == PH_PLANE) {
    struct ph_window window;
    struct ph_axes axes = plane_axes(place, &window);
    ph_axes_ticks(&axes, place->page, place->em);
    most = fmax(most, ph_axes_left(&axes, place->page, place->em));
  } else if (place->panel->drawings[0]->space == PH_SPACE) {
    struct space space;
    space_layout(place, &space);
    for (int i = 0; i < 2; i++) {
      ph_axes_ticks(&space.axes[i], place->page, place->em);
      most = fmax(most, ph_axes_left(&space.axes[i], place->page, place->em));
    }
  }
  return most;
}

/* Divides the cell below the title, left of the legend. */
static struct place place_in(const struct ph_panel *panel, struct ph_page *page,
                             const struct ph_rect *body, double em) {
  struct place place = {.panel = panel, .page = page, .em = em};
  bool sphere = panel->drawings[0]->space == PH_SPHERE;
  double below = ph_axes_below(em), left = LEFT * em;
  double profiles = fmin(profiles_height(panel, em), 0.45 * body->h);
  for (int pass = 0; pass < 2; pass++) {
    double x = body->x + left, w = fmax(body->w - left - RIGHT * em, em);
    place.views =
        (struct ph_rect){x, body->y + TOP * em, w,
                         fmax(body->h - profiles - below - TOP * em, em)};
    place.profiles =
        (struct ph_rect){x, body->y + body->h - profiles + PROFILE_GAP * em, w,
                         fmax(profiles - below - PROFILE_GAP * em, em)};
    left = left_of(&place);
  }
  place.left = left;
  if (sphere) {
    place.views.x = body->x;
    place.views.w = body->w;
    place.views.h += below;
  }
  return place;
}

static void draw_title(const struct ph_panel *panel, struct ph_page *page,
                       struct ph_rect *cell, double em) {
  char text[PH_PLOT_TEXT_MAX];
  struct ph_spot at = {cell->x + 0.5 * cell->w, cell->y + 1.3 * em};
  if (panel->title[0]) {
    memcpy(text, panel->title, sizeof text);
    ph_plot_text_fit(page, TITLE * em, cell->w - 2 * em, text);
    ph_page_text(page, at, TITLE * em, 0.5, false, text);
    cell->y += TITLE_LINE * em;
    cell->h -= TITLE_LINE * em;
  }
}

void ph_panel_draw(const struct ph_panel *panel, struct ph_page *page,
                   const struct ph_rect *cell, double em) {
  struct ph_rect body = *cell;
  struct place place;
  const bool patches = panel->drawings[0]->space == PH_PATCHWORK;
  double legend = patches ? 0 : ph_legend_width(panel, page, em, 0.3 * cell->w);
  draw_title(panel, page, &body, em);
  if (legend > 0) {
    struct ph_rect at = {body.x + body.w - legend - 0.5 * em, body.y + TOP * em,
                         legend, 0.6 * body.h};
    ph_legend_draw(panel, page, &at, em);
    body.w -= legend + (LEGEND_GAP - RIGHT + 0.5) * em;
  }
  if (patches) {
    body.y += TOP * em;
    body.h -= TOP * em;
    ph_quilt_draw(panel, page, &body, em);
    return;
  }
  place = place_in(panel, page, &body, em);
  switch (panel->drawings[0]->space) {
  case PH_PLANE:
    draw_plane(&place);
    break;
  case PH_SPACE:
    draw_space(&place);
    break;
  case PH_SPHERE:
    draw_sphere(&place);
    break;
  case PH_SURFACE:
    draw_surface(&place);
    break;
  case PH_PATCHWORK:
    break;
  }
  draw_profiles(&place);
}
