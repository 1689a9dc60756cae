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

/* Surfaces have their development beside them. */
#define WIDE 1.35

#define PADDING 0.8 /* around a panel, in ems */
#define NOTE 2.5    /* height of a line below the panels, in ems */
#define HEADING 2.6 /* of the title above them, and where it stands */
#define HEADING_LINE 1.9
#define KEY_GAP 0.7  /* below the key */
#define KEY_MOST 0.2 /* of the height of the page */

/* Letters shrink by no more than this. */
#define SHRINK_MAX 0.75

/* How bad a grid is: how far from the aspect, and how many cells are empty. */
static double badness(size_t n, size_t columns, double width, double height) {
  size_t rows = (n + columns - 1) / columns;
  double aspect = (double)columns * width / ((double)rows * height);
  return fabs(log(aspect / ASPECT)) +
         2 * (double)(rows * columns - n) / (double)n;
}

static size_t columns_for(size_t n, double width, double height) {
  size_t best = 1;
  for (size_t c = 2; c <= n; c++) {
    if (badness(n, c, width, height) < badness(n, best, width, height)) {
      best = c;
    }
  }
  return best;
}

/* Natural heights of the rows, into rows[]; their sum. */
static double row_heights(const double *heights, size_t n, size_t columns,
                          double *rows) {
  double sum = 0;
  for (size_t i = 0; i < n; i++) {
    rows[i / columns] =
        i % columns == 0 ? heights[i] : fmax(rows[i / columns], heights[i]);
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

/* Cells are as high as their panels want to be, by the scale of all rows. */
static void set_cells(struct ph_layout *layout, size_t n, const double *heights,
                      const double *rows, double scale, double top) {
  double w = layout->width / (double)layout->columns;
  double pad = PADDING * layout->em, y = top;
  for (size_t i = 0; i < n; i++) {
    size_t row = i / layout->columns, column = i % layout->columns;
    layout->cells[i] = (struct ph_rect){w * (double)column + pad, y + pad,
                                        fmax(w - 2 * pad, 1),
                                        fmax(scale * heights[i] - 2 * pad, 1)};
    y += column + 1 == layout->columns ? scale * rows[row] : 0;
  }
}

/* In ems. */
static double key_height(const struct ph_beside *beside, double width) {
  const size_t rows = ph_key_rows(&beside->key, width - 2 * PADDING);
  return rows > 0 ? PH_KEY_ROW * (double)rows + KEY_GAP : 0;
}

/* A small page has no key. */
static void place_beside(struct ph_layout *layout,
                         const struct ph_beside *beside) {
  const double em = layout->em, pad = PADDING * em;
  const double wanted = key_height(beside, layout->width / em) * em;
  const double high = wanted < KEY_MOST * layout->height ? wanted : 0;
  layout->title = HEADING_LINE * em;
  layout->key = (struct ph_rect){
      pad, layout->height - high - (beside->note ? NOTE * em : 0),
      layout->width - 2 * pad, high};
}

enum ph_status ph_layout_make(const struct ph_panel *panels, size_t n,
                              const struct ph_figure_rules *rules,
                              const struct ph_beside *beside,
                              struct ph_arena *arena, struct ph_layout *layout,
                              struct ph_diag *diag) {
  double *rows = ph_arena_array(arena, n, sizeof *rows);
  double *heights = ph_arena_array(arena, n, sizeof *heights);
  double width, sum = 0, em, above = beside->title ? HEADING : 0, below;
  size_t i = 0;
  while (sizes[i].n < n) {
    i++;
  }
  em = sizes[i].em;
  width = sizes[i].width;
  for (size_t k = 0; k < n; k++) {
    if (panels[k].drawings[0]->space >= PH_SURFACE) {
      width = sizes[i].width * WIDE;
    }
  }
  *layout = (struct ph_layout){.em = em, .columns = 1};
  layout->cells = ph_arena_array(arena, n, sizeof *layout->cells);
  if (!rows || !heights || !layout->cells) {
    return ph_fail_memory(diag);
  }
  for (i = 0; i < n; i++) {
    heights[i] = ph_panel_height(&panels[i], width - 2 * PADDING * em, em) +
                 2 * PADDING * em;
    sum += heights[i];
  }
  if (n > 0) {
    layout->columns = columns_for(n, width, sum / (double)n);
    sum = row_heights(heights, n, layout->columns, rows);
  } else {
    sum = 0.75 * width;
  }
  layout->rows = (n + layout->columns - 1) / layout->columns;
  width *= (double)layout->columns;
  below = key_height(beside, width / em) + (beside->note ? NOTE : 0);
  page_size(rules, width, sum + (above + below) * em, layout);
  place_beside(layout, beside);
  set_cells(layout, n, heights, rows,
            (layout->height - above * layout->em - layout->key.h -
             (beside->note ? NOTE * layout->em : 0)) /
                sum,
            above * layout->em);
  return PH_OK;
}
