/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Figures (see figure.h): drawings are put into panels, panels on the page. */
#include "plot/figure.h"

#include "plot/layout.h"
#include "plot/page.h"
#include "plot/panel.h"

#include <string.h>
#include <strings.h>

static const char *const suffixes[] = {
#define X(symbol, suffix) suffix,
    PH_FIGURE_FORMATS(X)
#undef X
};

enum ph_figure_format ph_figure_format_of(const char *file) {
  size_t n = strlen(file);
  for (int i = 0; i < PH_FIGURE_FORMAT_N; i++) {
    size_t m = strlen(suffixes[i]);
    if (n > m && strcasecmp(file + n - m, suffixes[i]) == 0) {
      return (enum ph_figure_format)i;
    }
  }
  return PH_FIGURE_FORMAT_N;
}

bool ph_figure_can(void) {
  return ph_page_can();
}

/* What goes on the page. */
struct figure {
  struct ph_panel panels[PH_FIGURE_PANELS_MAX];
  size_t n;
  bool more; /* something is left out */
};

/* How many drawings, from the first on, are of one problem. */
static size_t group_of(const struct ph_drawing *const *drawings, size_t n) {
  size_t k = 1;
  while (k < n && drawings[k]->record == drawings[0]->record &&
         drawings[k]->space == drawings[0]->space) {
    k++;
  }
  return k;
}

static enum ph_status fill(struct figure *figure,
                           const struct ph_drawing *const *drawings, size_t n,
                           struct ph_arena *arena, struct ph_diag *diag) {
  enum ph_status status = PH_OK;
  size_t k;
  for (size_t i = 0; status == PH_OK && i < n; i += k) {
    k = group_of(drawings + i, n - i);
    if (figure->n == PH_FIGURE_PANELS_MAX) {
      figure->more = true;
      break;
    }
    figure->more = figure->more || k > PH_FIGURE_SWEEP_MAX;
    status = ph_panel_make(drawings + i,
                           k < PH_FIGURE_SWEEP_MAX ? k : PH_FIGURE_SWEEP_MAX,
                           arena, &figure->panels[figure->n++], diag);
  }
  return status;
}

/* "record 12" */
static void number_text(size_t record, char *text) {
  char digits[24];
  size_t n = sizeof digits - 1;
  digits[n] = '\0';
  do {
    digits[--n] = (char)('0' + record % 10);
    record /= 10;
  } while (record > 0);
  strcpy(text, "record ");
  strcat(text, digits + n);
}

/* Titles; problems without one are numbered, where there are several. */
static void set_titles(struct figure *figure) {
  for (size_t i = 0; i < figure->n; i++) {
    struct ph_panel *panel = &figure->panels[i];
    if (panel->drawings[0]->title) {
      ph_plot_text(panel->drawings[0]->title, panel->title);
    } else if (figure->n > 1) {
      number_text(panel->drawings[0]->record, panel->title);
    }
  }
}

static void draw(const struct figure *figure, const struct ph_layout *layout,
                 struct ph_page *page) {
  struct ph_spot middle = {0.5 * layout->width, 0.5 * layout->height};
  struct ph_spot below = {middle.x, layout->height - layout->em};
  for (size_t i = 0; i < figure->n; i++) {
    ph_panel_draw(&figure->panels[i], page, &layout->cells[i], layout->em);
  }
  if (figure->n == 0) {
    ph_page_text(page, middle, layout->em, 0.5, false, "no curves");
  }
  if (figure->more) {
    ph_page_text(page, below, layout->em, 0.5, false,
                 "not all curves are shown");
  }
}

enum ph_status ph_figure_write(const struct ph_drawing *const *drawings,
                               size_t n, const struct ph_figure_rules *rules,
                               struct ph_buf *out, struct ph_diag *diag) {
  struct ph_arena arena = {0};
  struct figure *figure = ph_arena_array(&arena, 1, sizeof *figure);
  struct ph_layout layout;
  struct ph_page *page = NULL;
  enum ph_status status;
  if (!figure) {
    return ph_fail_memory(diag);
  }
  figure->n = 0;
  figure->more = false;
  status = fill(figure, drawings, n, &arena, diag);
  if (status == PH_OK) {
    set_titles(figure);
    status = ph_layout_make(figure->panels, figure->n, rules, figure->more,
                            &arena, &layout, diag);
  }
  if (status == PH_OK) {
    status = ph_page_begin(rules->format, layout.width, layout.height, out,
                           &page, diag);
  }
  if (status == PH_OK) {
    draw(figure, &layout, page);
    status = ph_page_end(page, diag);
  }
  ph_arena_free(&arena);
  return status;
}
