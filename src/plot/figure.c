/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Figures (see figure.h): drawings are put into panels, panels on the page. */
#include "plot/figure.h"

#include "plot/describe.h"
#include "plot/layout.h"
#include "plot/page.h"
#include "plot/panel.h"

#include <string.h>
#include <strings.h>

/* Letters of the title, in ems. */
#define HEADING 1.35

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

enum ph_status ph_figure_can(struct ph_diag *diag) {
  return ph_page_can(diag);
}

/* What goes on the page. */
struct figure {
  struct ph_panel panels[PH_FIGURE_PANELS_MAX];
  size_t n;
  char title[PH_PLOT_TEXT_MAX]; /* clean; "": none */
  struct ph_beside beside;
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
      figure->beside.note = true;
      break;
    }
    figure->beside.note = figure->beside.note || k > PH_FIGURE_SWEEP_MAX;
    status = ph_panel_make(drawings + i,
                           k < PH_FIGURE_SWEEP_MAX ? k : PH_FIGURE_SWEEP_MAX,
                           arena, &figure->panels[figure->n++], diag);
  }
  return status;
}

/* Titles; problems without one are numbered, where there are several. */
static void set_titles(struct figure *figure) {
  for (size_t i = 0; i < figure->n; i++) {
    struct ph_panel *panel = &figure->panels[i];
    if (panel->drawings[0]->title) {
      ph_plot_text(panel->drawings[0]->title, panel->title);
    } else if (figure->n > 1) {
      char number[PH_PLOT_TEXT_MAX];
      ph_plot_text_number(panel->drawings[0]->record, number);
      strcpy(panel->title, "record ");
      strcat(panel->title, number);
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
  if (layout->key.h > 0) {
    ph_key_draw(&figure->beside.key, page, &layout->key, layout->em);
  }
  if (figure->beside.title) {
    struct ph_spot at = {middle.x, layout->title};
    char text[PH_PLOT_TEXT_MAX];
    memcpy(text, figure->title, sizeof text);
    ph_plot_text_fit(page, HEADING * layout->em, layout->width - 2 * layout->em,
                     text);
    ph_page_text(page, at, HEADING * layout->em, 0.5, false, text);
  }
  if (figure->beside.note) {
    ph_page_text(page, below, layout->em, 0.5, false,
                 "not all curves are shown");
  }
}

/* What the file says of itself. */
static enum ph_status begin_page(const struct figure *figure,
                                 const struct ph_layout *layout,
                                 enum ph_figure_format format,
                                 struct ph_buf *out, struct ph_page **page,
                                 struct ph_diag *diag) {
  const char *title = figure->title[0] ? figure->title
                      : figure->n == 1 ? figure->panels[0].title
                                       : NULL;
  struct ph_page_head head = {format, layout->width, layout->height, title,
                              NULL};
  struct ph_buf words = {0};
  enum ph_status status;
  ph_describe(figure->panels, figure->n, &words);
  ph_buf_put(&words, "", 1);
  head.description = words.failed ? NULL : words.data;
  status = words.failed ? ph_fail_memory(diag)
                        : ph_page_begin(&head, out, page, diag);
  ph_buf_free(&words);
  return status;
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
  figure->title[0] = '\0';
  figure->beside = (struct ph_beside){.note = false};
  if (rules->title) {
    ph_plot_text(rules->title, figure->title);
    figure->beside.title = figure->title[0] != '\0';
  }
  status = fill(figure, drawings, n, &arena, diag);
  if (status == PH_OK) {
    set_titles(figure);
    for (size_t i = 0; i < figure->n; i++) {
      figure->panels[i].labels = rules->labels;
    }
    figure->beside.key = ph_key_of(figure->panels, figure->n);
    status = ph_layout_make(figure->panels, figure->n, rules, &figure->beside,
                            &arena, &layout, diag);
  }
  if (status == PH_OK) {
    status = begin_page(figure, &layout, rules->format, out, &page, diag);
  }
  if (status == PH_OK) {
    draw(figure, &layout, page);
    status = ph_page_end(page, diag);
  }
  ph_arena_free(&arena);
  return status;
}
