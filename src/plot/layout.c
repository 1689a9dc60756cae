/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Where panels go on a page (see layout.h). */
#include "plot/layout.h"

#include <math.h>

/* Grids are about so much wider than high. */
#define ASPECT 1.3

/* Width of a panel and size of its letters, for up to so many panels. */
static const struct {
  size_t n;
  double width, em;
} sizes[] = {{1, 640, 12},   {2, 480, 10.5}, {6, 400, 9.5},
             {12, 330, 8.5}, {30, 270, 7.5}, {SIZE_MAX, 230, 6.5}};

#define PADDING 0.8 /* around a panel, in ems */
#define NOTE 2.5    /* height of a line below the panels, in ems */

/* Letters shrink by no more than this. */
#define SHRINK_MAX 0.75

static size_t columns_for(size_t n, double width, double height) {
  double c = ceil(sqrt((double)n * ASPECT * height / width) - 0.25);
  return c < 1 ? 1 : c > (double)n ? n : (size_t)c;
}

/* Natural heights of the rows, into rows[]; their sum. */
static double row_heights(const struct ph_panel *panels, size_t n,
                          size_t columns, double width, double em,
                          double *rows) {
  double sum = 0;
  for (size_t i = 0; i < n; i++) {
    double h = ph_panel_height(&panels[i], width - 2 * PADDING * em, em) +
               2 * PADDING * em;
    rows[i / columns] = i % columns == 0 ? h : fmax(rows[i / columns], h);
  }
  for (size_t i = 0; i * columns < n; i++) {
    sum += rows[i];
  }
  return sum;
}

/* The page's size, as asked for or, in proportion, as natural. */
static void page_size(const struct ph_figure_rules *rules, double width,
                      double height, struct ph_layout *layout) {
  double sx = rules->width / width, sy = rules->height / height;
  double scale = sx > 0 && sy > 0 ? fmin(sx, sy) : sx > 0 ? sx : sy;
  scale = scale > 0 ? scale : 1;
  layout->width = rules->width > 0 ? rules->width : ceil(scale * width);
  layout->height = rules->height > 0 ? rules->height : ceil(scale * height);
  layout->em *= fmax(scale, SHRINK_MAX);
}

static void set_cells(struct ph_layout *layout, size_t n, const double *rows,
                      double sum, double note) {
  double w = layout->width / (double)layout->columns,
         pad = PADDING * layout->em;
  double h = layout->height - note * layout->em, y = 0;
  for (size_t i = 0; i < n; i++) {
    size_t row = i / layout->columns, column = i % layout->columns;
    double high = h * rows[row] / sum;
    layout->cells[i] =
        (struct ph_rect){w * (double)column + pad, y + pad,
                         fmax(w - 2 * pad, 1), fmax(high - 2 * pad, 1)};
    y += column + 1 == layout->columns ? high : 0;
  }
}

enum ph_status ph_layout_make(const struct ph_panel *panels, size_t n,
                              const struct ph_figure_rules *rules, bool note,
                              struct ph_arena *arena, struct ph_layout *layout,
                              struct ph_diag *diag) {
  double *rows = ph_arena_array(arena, n, sizeof *rows), sum = 0, width, high;
  size_t i = 0;
  while (sizes[i].n < n) {
    i++;
  }
  *layout = (struct ph_layout){.em = sizes[i].em, .columns = 1};
  layout->cells = ph_arena_array(arena, n, sizeof *layout->cells);
  if (!rows || !layout->cells) {
    return ph_fail_memory(diag);
  }
  width = sizes[i].width;
  high = 0.75 * width;
  if (n > 0) {
    high = row_heights(panels, n, n, width, layout->em, rows);
    layout->columns = columns_for(n, width, high);
    sum = row_heights(panels, n, layout->columns, width, layout->em, rows);
    high = sum;
  }
  layout->rows = (n + layout->columns - 1) / layout->columns;
  high += note ? NOTE * layout->em : 0;
  page_size(rules, width * (double)layout->columns, high, layout);
  set_cells(layout, n, rows, sum, note ? NOTE : 0);
  return PH_OK;
}
