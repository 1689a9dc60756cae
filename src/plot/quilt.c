/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Surfaces of patches in views (see quilt.h), by the algorithm of the
 * painter. */
#include "plot/quilt.h"

#include "curve/surface/places.h"
#include "plot/panel.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { VIEWS = 3, CORNERS = 3, POLYGON_MAX = 8 };

/* Stripes from one side of the light to the other, bands of the range of the
 * mean curvature. */
enum { STRIPES = 20, BANDS = 24 };

/* In ems: what stands below a view. */
static const double CAPTION = 1.9, CAPTION_SIZE = 0.82;

/* Of mean curvatures, such a part at either end is beyond the range. */
static const double BEYOND = 0.01;

/* Mean curvatures that differ by less, over the size, are one. */
static const double FLAT = 1e-4;

/* ---- places -------------------------------------------------------------- */

static int by_size(const void *left, const void *right) {
  const double a = *(const double *)left, b = *(const double *)right;
  return (a > b) - (a < b);
}

static bool find_range(struct ph_quilt *q, size_t n, double size,
                       struct ph_arena *scratch) {
  double *mean = ph_arena_array(scratch, n, sizeof *mean);
  size_t known = 0;
  for (size_t i = 0; mean && i < n; i++) {
    if (isfinite(q->at[i].mean)) {
      mean[known++] = q->at[i].mean;
    }
  }
  q->range[0] = q->range[1] = 0;
  if (mean && known) {
    const size_t out = (size_t)(BEYOND * (double)known);
    qsort(mean, known, sizeof *mean, by_size);
    q->range[0] = mean[out];
    q->range[1] = mean[known - 1 - out];
  }
  if (!(q->range[1] - q->range[0] > FLAT / size)) {
    const double flat = 0.5 * (q->range[0] + q->range[1]);
    q->range[0] = q->range[1] = fabs(flat) > FLAT / size ? flat : 0;
  }
  return mean;
}

/* The tiles of a surface.  ret PH_OK | PH_E_NO_MEMORY */
static enum ph_status quilt_of(const struct ph_curve *curve,
                               struct ph_arena *arena, struct ph_quilt *q,
                               struct ph_diag *diag) {
  const double each = sqrt((double)PH_QUILT_TILES / (double)curve->n);
  struct ph_arena scratch = ph_arena_beside(arena);
  struct ph_patch_samples grid;
  size_t back, n;
  enum ph_status status;
  q->patches_n = curve->n;
  q->steps = each < 1                ? 1
             : each > PH_QUILT_STEPS ? PH_QUILT_STEPS
                                     : (size_t)each;
  n = curve->n * (q->steps + 1) * (q->steps + 1);
  q->at = ph_arena_array(arena, n, sizeof *q->at);
  status = q->at ? ph_patch_grid_of(curve, 0, q->steps, n, &scratch, &grid,
                                    &back, diag)
                 : ph_fail_memory(diag);
  for (size_t i = 0; status == PH_OK && i < n; i++) {
    q->at[i] = (struct ph_quilt_place){ph_vec3_get(grid.v[i].point, 3),
                                       ph_vec3_get(grid.v[i].normal, 3),
                                       grid.v[i].mean};
  }
  if (status == PH_OK &&
      !find_range(q, n, sqrt(curve->surface.area), &scratch)) {
    status = ph_fail_memory(diag);
  }
  ph_arena_free(&scratch);
  return status;
}

static void extend(struct ph_drawing *d, ph_vec3 p) {
  d->low =
      ph_vec3_of(fmin(d->low.x, p.x), fmin(d->low.y, p.y), fmin(d->low.z, p.z));
  d->high = ph_vec3_of(fmax(d->high.x, p.x), fmax(d->high.y, p.y),
                       fmax(d->high.z, p.z));
}

enum ph_status ph_quilt_drawing(const struct ph_result *result,
                                const struct ph_drawing_names *names,
                                struct ph_drawing **drawing,
                                struct ph_diag *diag) {
  struct ph_drawing *d = ph_malloc(sizeof *d);
  struct ph_quilt *q;
  enum ph_status status;
  *drawing = NULL;
  if (!d) {
    return ph_fail_memory(diag);
  }
  *d = (struct ph_drawing){.record = names->record,
                           .space = PH_PATCHWORK,
                           .low = {HUGE_VAL, HUGE_VAL, HUGE_VAL},
                           .high = {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL}};
  d->quilt = q = ph_arena_array(&d->arena, 1, sizeof *q);
  status = q ? quilt_of(&result->curve, &d->arena, q, diag) : PH_E_NO_MEMORY;
  if (status == PH_OK) {
    d->places = q->patches_n * (q->steps + 1) * (q->steps + 1);
    for (size_t i = 0; i < d->places; i++) {
      extend(d, q->at[i].p);
    }
    d->title = names->title ? ph_arena_copy(&d->arena, names->title,
                                            strlen(names->title))
                            : NULL;
    d->label = names->label ? ph_arena_copy(&d->arena, names->label,
                                            strlen(names->label))
                            : NULL;
  }
  if (status != PH_OK || !d->title != !names->title ||
      !d->label != !names->label) {
    ph_drawing_free(d);
    return ph_fail_memory(diag);
  }
  *drawing = d;
  return PH_OK;
}

size_t ph_quilt_rows(const struct ph_panel *panel) {
  return panel->n < PH_QUILT_ROWS ? panel->n : PH_QUILT_ROWS;
}

/* ---- triangles ----------------------------------------------------------- */

/* A corner as it is seen, with what stripes and bands count. */
struct corner {
  struct ph_seen seen;
  double light, stripe, band;
};

struct triangle {
  struct corner c[CORNERS];
  bool border[CORNERS]; /* from a corner to the next: of the patch */
  double depth;
  size_t number;
};

static int by_depth(const void *left, const void *right) {
  const struct triangle *a = left, *b = right;
  return a->depth < b->depth ? -1
         : a->depth > b->depth
             ? 1
             : (a->number > b->number) - (a->number < b->number);
}

struct row {
  const struct ph_panel *panel;
  const struct ph_quilt *quilt;
  struct ph_page *page;
  struct ph_view view;
  ph_vec3 light;
  double low[2], high[2]; /* of what is seen */
};

static struct corner corner_of(const struct row *row,
                               const struct ph_quilt_place *at) {
  const struct ph_quilt *q = row->quilt;
  const double width = q->range[1] - q->range[0];
  const double band = width > 0 ? (at->mean - q->range[0]) / width : 0.5;
  struct corner c = {
      .seen = ph_view_see(&row->view, ph_unit_in(&row->panel->unit, at->p))};
  c.light = fabs(ph_vec3_dot(at->normal, row->view.toward));
  c.stripe = STRIPES / 2.0 *
             (1 + fmax(-1, fmin(1, ph_vec3_dot(at->normal, row->light))));
  c.band = BANDS * (band >= 0 && band <= 1 ? band : band > 1 ? 1 : 0);
  if (!(c.light <= 1)) {
    c.light = 1;
  }
  return c;
}

static void add_triangle(const struct row *row, size_t patch, const size_t *i,
                         const size_t *j, struct triangle *to) {
  const struct ph_quilt *q = row->quilt;
  const size_t each = q->steps + 1;
  double sum = 0;
  for (size_t k = 0; k < CORNERS; k++) {
    const size_t next = (k + 1) % CORNERS;
    to->c[k] = corner_of(row, &q->at[(patch * each + j[k]) * each + i[k]]);
    sum += to->c[k].seen.depth;
    to->border[k] = (i[k] == i[next] && i[k] % q->steps == 0) ||
                    (j[k] == j[next] && j[k] % q->steps == 0);
  }
  to->depth = sum;
}

static struct triangle *triangles_of(const struct row *row, size_t *n,
                                     struct ph_arena *arena) {
  static const size_t half[2][CORNERS][2] = {{{0, 0}, {1, 0}, {1, 1}},
                                             {{0, 0}, {1, 1}, {0, 1}}};
  const size_t steps = row->quilt->steps;
  struct triangle *v;
  *n = 2 * row->quilt->patches_n * steps * steps;
  v = ph_arena_array(arena, *n, sizeof *v);
  for (size_t t = 0; v && t < *n; t++) {
    const size_t tile = t / 2 % (steps * steps);
    size_t i[CORNERS], j[CORNERS];
    for (size_t k = 0; k < CORNERS; k++) {
      i[k] = tile % steps + half[t % 2][k][0];
      j[k] = tile / steps + half[t % 2][k][1];
    }
    add_triangle(row, t / 2 / (steps * steps), i, j, &v[t]);
    v[t].number = t;
  }
  if (v) {
    qsort(v, *n, sizeof *v, by_depth);
  }
  return v;
}

/* ---- views --------------------------------------------------------------- */

static struct ph_colour shaded(struct ph_colour c, double light) {
  const double x = 0.35 + 0.65 * light;
  return (struct ph_colour){c.r * x, c.g * x, c.b * x};
}

static void path(struct ph_page *page, const struct ph_window *window,
                 const struct corner *c, size_t n) {
  for (size_t k = 0; k < n; k++) {
    const struct ph_spot at = ph_window_spot(window, c[k].seen);
    (k ? ph_page_line : ph_page_move)(page, at);
  }
  ph_page_close(page);
}

/* What is counted in a view: stripes, or bands. */
static double count_of(const struct corner *c, size_t which) {
  return which == 1 ? c->stripe : c->band;
}

/* Cuts off what is below a level, or above it; how many corners are left. */
static size_t cut(struct corner *c, size_t n, size_t which, double level,
                  double sign) {
  struct corner kept[POLYGON_MAX];
  size_t m = 0;
  for (size_t k = 0; k < n && m + 2 < POLYGON_MAX; k++) {
    const struct corner *a = &c[k], *b = &c[(k + 1) % n];
    const double x = sign * (count_of(a, which) - level);
    const double y = sign * (count_of(b, which) - level);
    if (x >= 0) {
      kept[m++] = *a;
    }
    if ((x >= 0) != (y >= 0)) {
      const double t = x / (x - y);
      struct corner *to = &kept[m++];
      *to = *a;
      to->seen.u += t * (b->seen.u - a->seen.u);
      to->seen.v += t * (b->seen.v - a->seen.v);
      to->stripe += t * (b->stripe - a->stripe);
      to->band += t * (b->band - a->band);
    }
  }
  for (size_t k = 0; k < m; k++) {
    c[k] = kept[k];
  }
  return m;
}

static struct ph_colour colour_of(size_t which, double level) {
  static const struct ph_colour dark = {0.13, 0.16, 0.22};
  static const struct ph_colour bright = {0.96, 0.96, 0.94};
  const double band = fmax(0, fmin(BANDS - 1, level));
  return which == 2           ? ph_colour_ramp((size_t)band, BANDS)
         : fmod(level, 2) < 1 ? dark
                              : bright;
}

static void draw_levels(struct ph_page *page, const struct ph_window *window,
                        const struct triangle *t, size_t which) {
  const double a = count_of(&t->c[0], which), b = count_of(&t->c[1], which);
  const double c = count_of(&t->c[2], which);
  const double last = floor(fmax(a, fmax(b, c)));
  const double light = (t->c[0].light + t->c[1].light + t->c[2].light) / 3;
  for (double level = floor(fmin(a, fmin(b, c))); level <= last; level++) {
    struct corner corner[POLYGON_MAX];
    size_t n = CORNERS;
    memcpy(corner, t->c, sizeof t->c);
    n = cut(corner, n, which, level, 1);
    n = n ? cut(corner, n, which, level + 1, -1) : 0;
    if (n >= CORNERS) {
      ph_page_pen(page, shaded(colour_of(which, level), 0.6 + 0.4 * light), 0.4,
                  0);
      path(page, window, corner, n);
      ph_page_paint(page);
    }
  }
}

static void draw_shaded(struct ph_page *page, const struct ph_window *window,
                        const struct triangle *t) {
  static const struct ph_colour base = {0.60, 0.76, 0.90};
  const double light = (t->c[0].light + t->c[1].light + t->c[2].light) / 3;
  ph_page_pen(page, shaded(base, light), 0.4, 0);
  path(page, window, t->c, CORNERS);
  ph_page_paint(page);
  for (size_t k = 0; k < CORNERS; k++) {
    if (t->border[k]) {
      ph_page_pen(page, ph_ink(PH_INK_EDGE), 1, 0);
      ph_page_move(page, ph_window_spot(window, t->c[k].seen));
      ph_page_line(page, ph_window_spot(window, t->c[(k + 1) % CORNERS].seen));
      ph_page_stroke(page);
    }
  }
}

static void measure(struct row *row, const struct triangle *v, size_t n) {
  row->low[0] = row->low[1] = HUGE_VAL;
  row->high[0] = row->high[1] = -HUGE_VAL;
  for (size_t i = 0; i < CORNERS * n; i++) {
    const struct ph_seen seen = v[i / CORNERS].c[i % CORNERS].seen;
    row->low[0] = fmin(row->low[0], seen.u);
    row->low[1] = fmin(row->low[1], seen.v);
    row->high[0] = fmax(row->high[0], seen.u);
    row->high[1] = fmax(row->high[1], seen.v);
  }
}

static void draw_caption(const struct row *row, const char *label, size_t which,
                         const struct ph_rect *rect, double em) {
  const struct ph_quilt *q = row->quilt;
  const struct ph_spot at = {rect->x + 0.5 * rect->w, rect->y + rect->h + em};
  const bool flat = !(q->range[1] > q->range[0]);
  char text[PH_PLOT_TEXT_MAX];
  struct ph_diag range; /* it formats numbers */
  ph_fail(&range, PH_E_INTERNAL, NULL,
          flat ? "mean curvature %.3g" : "mean curvature, %.3g to %.3g",
          q->range[0], q->range[1]);
  ph_plot_text(which == 2   ? range.message
               : which == 1 ? "isophotes"
               : label      ? label
                            : "patches",
               text);
  ph_plot_text_fit(row->page, CAPTION_SIZE * em, rect->w, text);
  ph_page_text(row->page, at, CAPTION_SIZE * em, 0.5, false, text);
}

static void draw_row(struct row *row, const char *label,
                     const struct ph_rect *rect, double em) {
  struct ph_arena arena = {0};
  size_t n;
  const struct triangle *v = triangles_of(row, &n, &arena);
  for (size_t which = 0; v && which < VIEWS; which++) {
    const double w = rect->w / VIEWS;
    const struct ph_rect frame = {rect->x + (double)which * w + 0.5 * em,
                                  rect->y, w - em, rect->h - CAPTION * em};
    struct ph_window window = {.rect = frame};
    measure(row, v, n);
    window.u = 0.5 * (row->low[0] + row->high[0]);
    window.v = 0.5 * (row->low[1] + row->high[1]);
    window.scale =
        0.96 * fmin(frame.w / fmax(row->high[0] - row->low[0], 1e-9),
                    frame.h / fmax(row->high[1] - row->low[1], 1e-9));
    for (size_t i = 0; i < n; i++) {
      if (which == 0) {
        draw_shaded(row->page, &window, &v[i]);
      } else {
        draw_levels(row->page, &window, &v[i], which);
      }
    }
    draw_caption(row, label, which, &frame, em);
  }
  ph_arena_free(&arena);
}

void ph_quilt_draw(const struct ph_panel *panel, struct ph_page *page,
                   const struct ph_rect *rect, double em) {
  const size_t rows = ph_quilt_rows(panel);
  for (size_t i = 0; i < rows; i++) {
    const double h = rect->h / (double)rows;
    const struct ph_rect place = {rect->x, rect->y + (double)i * h, rect->w, h};
    struct row row = {.panel = panel,
                      .quilt = panel->drawings[i]->quilt,
                      .page = page,
                      .view = ph_view_from(ph_vec3_of(0.5, -0.76, 0.55))};
    row.light = ph_vec3_add(
        ph_vec3_scale(0.35, row.view.toward),
        ph_vec3_along(ph_vec3_scale(0.5, row.view.right), 0.79, row.view.up));
    row.light = ph_vec3_scale(1 / ph_vec3_abs(row.light), row.light);
    draw_row(&row, panel->drawings[i]->label, &place, em);
  }
}
