/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Surfaces in a view (see solid.h). */
#include "plot/solid.h"

#include "plot/lines.h"
#include "plot/strokes.h"
#include "plot/trace.h"

#include <math.h>
#include <stdlib.h>

/* Cells of a panel, about; hidden lines are of surfaces with up to so many
 * strips, their rulings in so many pieces. */
enum { CELLS = 2500, HIDDEN_STRIPS = 100, PIECES = 32 };

/* In ems. */
#define SEAM 0.05
#define DOT 0.2

/* Pieces of lines around the surface are longer than they are, by this, and at
 * most by so much in the unit. */
#define LONGER 0.08
#define LONGER_MOST 4e-3

/* Vectors of elements, of the size of the surface; rulings of those without a
 * height, of these. */
#define ARROW 0.24
#define TICK 0.6

/* What is nearer than this to the surface is on it. */
#define ON 0.02

/* ---- where to look from -------------------------------------------------- */

/* How much of the sheets is seen. */
static double seen_of(const struct ph_panel *panel, ph_vec3 toward) {
  double sum = 0;
  for (size_t i = 0; i < panel->n; i++) {
    const struct ph_sheet *sheet = &panel->drawings[i]->sheets[0];
    for (size_t k = 0; k + 1 < sheet->ribs_n; k++) {
      const struct ph_rib *a = &sheet->ribs[k], *b = a + 1;
      const ph_vec3 across = ph_vec3_sub(ph_unit_in(&panel->unit, b->contact),
                                         ph_unit_in(&panel->unit, a->contact));
      sum += a->last
                 ? 0
                 : ph_vec3_abs(across) * fabs(ph_vec3_dot(a->normal, toward));
    }
  }
  return sum;
}

struct ph_view ph_solid_view(const struct ph_panel *panel) {
  ph_vec3 best = ph_vec3_unit(ph_vec3_of(0.5, -0.76, 0.42));
  double most = 1.1 * seen_of(panel, best);
  for (int i = 0; i < 16; i++) {
    const double angle = (i + 0.5) * acos(-1) / 8;
    const ph_vec3 toward =
        ph_vec3_of(0.9 * cos(angle), 0.9 * sin(angle), sqrt(0.19));
    const double seen = seen_of(panel, toward);
    if (seen > 1.02 * most) {
      most = seen;
      best = toward;
    }
  }
  return ph_view_from(best);
}

/* ---- cells --------------------------------------------------------------- */

/* Cells in the making. */
struct builder {
  const struct ph_panel *panel;
  const struct ph_unit *unit;
  ph_vec3 toward;
  bool flat;
  size_t across; /* cells over the height */
  struct ph_cells *cells;
};

/* The ends of a rib, and its place on the contact curve, in the unit. */
struct line {
  ph_vec3 end[2], contact;
};

static struct line line_of(const struct builder *b, const struct ph_rib *rib) {
  const ph_vec3 *end = b->flat ? rib->flat : rib->end;
  return (struct line){
      {ph_unit_in(b->unit, end[0]), ph_unit_in(b->unit, end[1])},
      ph_unit_in(b->unit, b->flat ? rib->flat_contact : rib->contact)};
}

static ph_vec3 part_of(const struct line *line, double t) {
  return ph_vec3_along(line->end[0], t,
                       ph_vec3_sub(line->end[1], line->end[0]));
}

/* Where on it the contact curve is: 0 .. 1 from end to end. */
static double contact_of(const struct line *line) {
  const ph_vec3 way = ph_vec3_sub(line->end[1], line->end[0]);
  const double n = ph_vec3_dot(way, way);
  return n > 0 ? ph_vec3_dot(way, ph_vec3_sub(line->contact, line->end[0])) / n
               : 0.5;
}

/* Paper with a light above the left shoulder; of a sweep, each in its colour.
 */
static struct ph_colour colour_of(const struct builder *b, size_t drawing,
                                  ph_vec3 normal) {
  static const struct ph_colour front = {0.99, 0.89, 0.74},
                                back = {0.77, 0.87, 0.97};
  const struct ph_view *view = &b->panel->views[0];
  const ph_vec3 light = ph_vec3_unit(ph_vec3_along(
      ph_vec3_along(b->toward, 0.55, view->up), -0.5, view->right));
  const bool away = b->flat || ph_vec3_dot(normal, b->toward) < 0;
  const double shade =
      b->flat ? 1 : 0.78 + 0.22 * fabs(ph_vec3_dot(normal, light));
  struct ph_colour c = away ? back : front;
  if (b->panel->n > 1) {
    const double white = away ? 0.6 : 0.72;
    c = ph_colour_ramp(drawing, b->panel->n);
    c = (struct ph_colour){white + (1 - white) * c.r, white + (1 - white) * c.g,
                           white + (1 - white) * c.b};
  }
  return (struct ph_colour){shade * c.r, shade * c.g, shade * c.b};
}

static enum ph_cell_line line_at(const struct ph_rib *rib, bool outline) {
  return rib->joint               ? PH_CELL_EDGE
         : !outline && rib->shown ? PH_CELL_RULING
                                  : PH_CELL_NONE;
}

/* What all cells between two ribs have in common. */
static struct ph_cell common(const struct builder *b, size_t drawing,
                             const struct ph_rib *rib, bool outline) {
  const struct ph_drawing *d = b->panel->drawings[drawing];
  const bool many = b->panel->n > 1;
  const struct ph_colour ramp = ph_colour_ramp(drawing, b->panel->n);
  struct ph_cell cell = {.filled = !outline && !d->sheets[0].bare};
  cell.ink = outline ? ph_ink(PH_INK_OFFSET) : ph_ink(PH_INK_EDGE);
  cell.contact_ink =
      many ? ramp
           : ph_colour_segment(rib->strip / ph_sheet_step(d->segments_n),
                               d->segments_n, d->closed);
  if (cell.filled) {
    cell.fill = colour_of(b, drawing, rib->normal);
  }
  return cell;
}

/* The cells between two ribs. */
static void add_cells(struct builder *b, size_t drawing,
                      const struct ph_rib *rib, bool outline) {
  const struct line from = line_of(b, rib), to = line_of(b, rib + 1);
  const double p = contact_of(&from), q = contact_of(&to),
               n = (double)b->across;
  const double at = floor(n * (p + q) / 2);
  const bool bare = b->panel->drawings[drawing]->sheets[0].bare;
  for (size_t j = 0; j < b->across; j++) {
    struct ph_cell cell = common(b, drawing, rib, outline);
    const double t0 = (double)j / n, t1 = (double)(j + 1) / n;
    ph_vec3 middle = {0, 0, 0};
    cell.corner[0] = part_of(&from, t0);
    cell.corner[1] = part_of(&from, t1);
    cell.corner[2] = part_of(&to, t1);
    cell.corner[3] = part_of(&to, t0);
    cell.line[0] = line_at(rib, outline);
    cell.line[1] = j + 1 == b->across ? PH_CELL_EDGE : PH_CELL_NONE;
    cell.line[2] = line_at(rib + 1, outline);
    cell.line[3] = j == 0 ? PH_CELL_EDGE : PH_CELL_NONE;
    cell.has_contact = !outline && fabs(at - (double)j) < 1.5;
    cell.contact[0] = from.contact;
    cell.contact[1] = to.contact;
    for (int i = 0; i < 4; i++) {
      middle = ph_vec3_along(middle, 0.25, cell.corner[i]);
    }
    for (int i = 0; bare && i < 4; i++) {
      cell.line[i] = PH_CELL_NONE;
    }
    cell.depth = b->flat ? 0 : ph_vec3_dot(middle, b->toward);
    cell.number = b->cells->n;
    b->cells->v[b->cells->n++] = cell;
  }
}

static int nearer(const void *a, const void *b) {
  const struct ph_cell *p = a, *q = b;
  return p->depth < q->depth ? -1
         : p->depth > q->depth
             ? 1
             : (p->number > q->number) - (p->number < q->number);
}

/* The ribs of all sheets; how much longer they are than the steps between them.
 */
static size_t count_ribs(const struct ph_panel *panel, double *ratio) {
  double high = 0, wide = 0;
  size_t n = 0;
  for (size_t i = 0; i < panel->n; i++) {
    const struct ph_drawing *d = panel->drawings[i];
    for (size_t j = 0; j < d->sheets_n; j++) {
      const struct ph_rib *ribs = d->sheets[j].ribs;
      n += d->sheets[j].ribs_n;
      for (size_t k = 0; k + 1 < d->sheets[j].ribs_n; k++) {
        const struct ph_unit *unit = &panel->unit;
        high += ph_vec3_abs(ph_vec3_sub(ph_unit_in(unit, ribs[k].end[1]),
                                        ph_unit_in(unit, ribs[k].end[0])));
        wide += ph_vec3_abs(ph_vec3_sub(ph_unit_in(unit, ribs[k + 1].contact),
                                        ph_unit_in(unit, ribs[k].contact)));
      }
    }
  }
  *ratio = wide > 0 && isfinite(high / wide) ? high / wide : 1;
  return n;
}

static enum ph_status build(struct builder *b, size_t ribs,
                            struct ph_arena *arena, struct ph_diag *diag) {
  *b->cells = (struct ph_cells){NULL, 0};
  b->cells->v = ph_arena_array(arena, ribs * b->across, sizeof *b->cells->v);
  if (!b->cells->v) {
    return ph_fail_memory(diag);
  }
  for (size_t i = 0; i < b->panel->n; i++) {
    const struct ph_drawing *d = b->panel->drawings[i];
    for (size_t j = 0; j < (b->flat ? 1 : d->sheets_n); j++) {
      for (size_t k = 0; k + 1 < d->sheets[j].ribs_n; k++) {
        if (!d->sheets[j].ribs[k].last) {
          add_cells(b, i, &d->sheets[j].ribs[k], j > 0);
        }
      }
    }
  }
  qsort(b->cells->v, b->cells->n, sizeof *b->cells->v, nearer);
  return PH_OK;
}

enum ph_status ph_solid_make(const struct ph_panel *panel,
                             struct ph_arena *arena, struct ph_cells *solid,
                             struct ph_cells *flat, struct ph_diag *diag) {
  double ratio;
  const size_t ribs = count_ribs(panel, &ratio);
  const double most = fmax(1, (double)CELLS / (double)ribs);
  struct builder b = {.panel = panel,
                      .unit = &panel->unit,
                      .toward = panel->views[0].toward,
                      .across = (size_t)fmin(fmax(1, ceil(ratio)), most),
                      .cells = solid};
  enum ph_status status = build(&b, ribs, arena, diag);
  b.unit = &panel->flat_unit;
  b.flat = true;
  b.across = 1;
  b.cells = flat;
  return status == PH_OK ? build(&b, ribs, arena, diag) : status;
}

/* ---- drawing ------------------------------------------------------------- */

static struct ph_spot spot_at(const struct ph_look *look, ph_vec3 place) {
  return ph_window_spot(&look->window, ph_view_see(&look->view, place));
}

static void draw_line(const struct ph_look *look, ph_vec3 from, ph_vec3 to) {
  const ph_vec3 ends[2] = {from, to};
  ph_strokes_line(look, PH_SIDE_ALL, ends, 2);
}

/* The same, a little longer, so that no neighbour's paint cuts it. */
static void draw_on(const struct ph_look *look, ph_vec3 from, ph_vec3 to) {
  const ph_vec3 by = ph_vec3_sub(to, from);
  const double size = ph_vec3_abs(by);
  const double part = size > 0 ? fmin(LONGER, LONGER_MOST / size) : 0;
  const ph_vec3 way = ph_vec3_scale(part, by);
  draw_line(look, ph_vec3_sub(from, way), ph_vec3_add(to, way));
}

static void draw_cell(const struct ph_look *look, const struct ph_cell *cell) {
  const double em = look->em;
  struct ph_page *page = look->page;
  if (cell->filled) {
    ph_page_pen(page, cell->fill, SEAM * em, 0);
    for (int i = 0; i < 4; i++) {
      (i ? ph_page_line : ph_page_move)(page, spot_at(look, cell->corner[i]));
    }
    ph_page_close(page);
    ph_page_paint(page);
  }
  for (int i = 0; i < 4; i++) {
    const bool edge = cell->line[i] == PH_CELL_EDGE;
    if (cell->line[i]) {
      ph_page_pen(page, edge ? cell->ink : ph_ink(PH_INK_RULING),
                  (edge ? PH_LINE_EDGE : PH_LINE_RULING) * em, 0);
      draw_on(look, cell->corner[i], cell->corner[(i + 1) % 4]);
    }
  }
  if (cell->has_contact) {
    ph_page_pen(page, cell->contact_ink, PH_LINE_CONTACT * em, 0);
    draw_on(look, cell->contact[0], cell->contact[1]);
  }
}

/* Whether a cell is before a place. */
static bool covers(const struct ph_look *look, const struct ph_cell *cell,
                   struct ph_seen p) {
  struct ph_seen c[4];
  for (int i = 0; i < 4; i++) {
    c[i] = ph_view_see(&look->view, cell->corner[i]);
  }
  if (fmin(fmin(c[0].u, c[1].u), fmin(c[2].u, c[3].u)) > p.u ||
      fmax(fmax(c[0].u, c[1].u), fmax(c[2].u, c[3].u)) < p.u ||
      fmin(fmin(c[0].v, c[1].v), fmin(c[2].v, c[3].v)) > p.v ||
      fmax(fmax(c[0].v, c[1].v), fmax(c[2].v, c[3].v)) < p.v) {
    return false;
  }
  for (int half = 0; half < 2; half++) {
    const struct ph_seen a = c[0], b = c[half ? 2 : 1], d = c[half ? 3 : 2];
    const double all = (b.u - a.u) * (d.v - a.v) - (d.u - a.u) * (b.v - a.v);
    const double s =
        ((p.u - a.u) * (d.v - a.v) - (d.u - a.u) * (p.v - a.v)) / all;
    const double t =
        ((b.u - a.u) * (p.v - a.v) - (p.u - a.u) * (b.v - a.v)) / all;
    if (s >= 0 && t >= 0 && s + t <= 1 &&
        a.depth + s * (b.depth - a.depth) + t * (d.depth - a.depth) >
            p.depth + ON) {
      return true;
    }
  }
  return false;
}

static bool is_hidden(const struct ph_look *look, const struct ph_cells *cells,
                      ph_vec3 place) {
  const struct ph_seen p = ph_view_see(&look->view, place);
  for (size_t i = 0; cells && i < cells->n; i++) {
    if (cells->v[i].filled && covers(look, &cells->v[i], p)) {
      return true;
    }
  }
  return false;
}

/* Goes on along a line that is drawn where it is hidden. */
static void go_hidden(const struct ph_look *look, struct ph_trace *trace,
                      ph_vec3 place) {
  if (is_hidden(look, &look->panel->solid, place)) {
    ph_trace_to(trace, spot_at(look, place));
  } else {
    ph_trace_break(trace);
  }
}

/* What is hidden of edges and of rulings between strips, dashed. */
static void draw_hidden(const struct ph_look *look,
                        const struct ph_sheet *sheet) {
  const struct ph_unit *unit = &look->panel->unit;
  struct ph_trace trace;
  ph_page_pen(look->page, ph_ink(PH_INK_EDGE), PH_LINE_HIDDEN * look->em,
              PH_LINE_DASH * look->em);
  ph_trace_begin(&trace, look->page, &look->window.rect);
  for (int edge = 0; edge < 2; edge++) {
    for (size_t i = 0; i < sheet->ribs_n; i++) {
      go_hidden(look, &trace, ph_unit_in(unit, sheet->ribs[i].end[edge]));
    }
    ph_trace_break(&trace);
  }
  for (size_t i = 0; i < sheet->ribs_n; i++) {
    const struct ph_rib *rib = &sheet->ribs[i];
    const ph_vec3 from = ph_unit_in(unit, rib->end[0]);
    const ph_vec3 way = ph_vec3_sub(ph_unit_in(unit, rib->end[1]), from);
    for (int j = 0; rib->joint && j <= PIECES; j++) {
      go_hidden(look, &trace, ph_vec3_along(from, (double)j / PIECES, way));
    }
    ph_trace_break(&trace);
  }
  ph_trace_end(&trace);
}

/* A contact element: its point, its tangent, without a height its ruling. */
struct mark {
  ph_vec3 point, ruling, tangent; /* in the unit; vectors as long as shown */
  bool bare, hidden;
  double dot; /* radius */
};

static void draw_mark(const struct ph_look *look, const struct mark *m) {
  const struct ph_colour ink =
      ph_ink(m->hidden ? PH_INK_OUTLINE : PH_INK_POINT);
  const ph_vec3 arrow[2] = {m->point, ph_vec3_add(m->point, m->tangent)};
  if (m->bare) {
    ph_page_pen(look->page, ph_ink(PH_INK_EDGE), PH_LINE_EDGE * look->em, 0);
    draw_line(look, ph_vec3_along(m->point, -TICK, m->ruling),
              ph_vec3_along(m->point, TICK, m->ruling));
  }
  ph_page_pen(look->page, m->hidden ? ink : ph_ink(PH_INK_TANGENT),
              PH_LINE_ARROW * look->em, 0);
  ph_strokes_arrow(look, arrow);
  ph_page_pen(look->page, ink, 1, 0);
  ph_page_circle(look->page, spot_at(look, m->point), m->dot);
  ph_page_fill(look->page);
}

double ph_solid_arrow(const struct ph_panel *panel,
                      const struct ph_drawing *d) {
  const double each = d->length / (double)d->sheets[0].elements_n;
  return fmin(ARROW * panel->unit.size, 0.5 * each);
}

static void draw_elements(const struct ph_look *look,
                          const struct ph_drawing *d,
                          const struct ph_cells *cells, bool flat) {
  const struct ph_sheet *sheet = &d->sheets[0];
  const struct ph_unit *unit = &look->panel->unit;
  const double size = ph_solid_arrow(look->panel, d) / unit->size;
  const double small = fmax(0.5, fmin(1, sqrt(size / ARROW)));
  for (size_t i = 0; i < sheet->elements_n; i++) {
    const struct ph_element *e = &sheet->elements[i];
    struct mark m = {ph_unit_in(unit, flat ? e->flat : e->point),
                     ph_vec3_scale(size, flat ? e->flat_ruling : e->ruling),
                     ph_vec3_scale(size, flat ? e->flat_tangent : e->tangent),
                     sheet->bare,
                     false,
                     small * DOT * look->em};
    m.hidden = is_hidden(look, cells, m.point);
    draw_mark(look, &m);
  }
}

/* The numbers of the points that can be seen. */
static void draw_labels(const struct ph_look *look,
                        const struct ph_cells *cells, bool flat) {
  const struct ph_drawing *d = look->panel->drawings[0];
  const struct ph_sheet *sheet = &d->sheets[0];
  struct ph_labels labels;
  labels.n = 0;
  for (size_t i = 0; look->panel->labels && i < sheet->elements_n; i++) {
    const struct ph_element *e = &sheet->elements[i];
    const ph_vec3 point =
        ph_unit_in(&look->panel->unit, flat ? e->flat : e->point);
    if (!is_hidden(look, cells, point)) {
      ph_strokes_label(look, &labels, spot_at(look, point),
                       d->numbers ? d->numbers[i] : i);
    }
  }
}

void ph_solid_draw(const struct ph_look *look) {
  const struct ph_panel *panel = look->panel;
  for (size_t i = 0; i < panel->solid.n; i++) {
    draw_cell(look, &panel->solid.v[i]);
  }
  for (size_t i = 0; i < panel->n; i++) {
    if (!panel->drawings[i]->sheets[0].bare &&
        panel->drawings[i]->segments_n <= HIDDEN_STRIPS) {
      draw_hidden(look, &panel->drawings[i]->sheets[0]);
    }
    draw_elements(look, panel->drawings[i], &panel->solid, false);
  }
  draw_labels(look, &panel->solid, false);
}

void ph_solid_flat(const struct ph_look *look) {
  const struct ph_panel *panel = look->panel;
  for (size_t i = 0; i < panel->flat.n; i++) {
    draw_cell(look, &panel->flat.v[i]);
  }
  for (size_t i = 0; i < panel->n; i++) {
    draw_elements(look, panel->drawings[i], NULL, true);
  }
  draw_labels(look, NULL, true);
}
