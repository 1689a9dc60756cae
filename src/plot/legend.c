/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The legend of a sweep (see legend.h). */
#include "plot/legend.h"

#include "plot/text.h"

#include <math.h>
#include <string.h>

/* In ems. */
#define LETTERS 0.85
#define LINE 1.35
#define SAMPLE 2.3
#define BAR 0.9
#define GAP 0.5

/* Of a bar: so many numbers, and strips. */
enum { BAR_LABELS = 6, BAR_STRIPS = 64 };

static const char equals[] = " = ";

size_t ph_legend_common(const struct ph_panel *panel) {
  const char *first = panel->drawings[0]->label;
  const char *end = first ? strstr(first, equals) : NULL;
  size_t n;
  if (!end || strstr(end + 1, equals)) {
    return 0;
  }
  n = (size_t)(end - first) + sizeof equals - 1;
  for (size_t i = 1; i < panel->n; i++) {
    const char *label = panel->drawings[i]->label;
    if (!label || strncmp(label, first, n) != 0) {
      return 0;
    }
  }
  return n;
}

/* The text of a value, without what all have in common. */
static void value_text(const struct ph_panel *panel, size_t i, size_t common,
                       char text[PH_PLOT_TEXT_MAX]) {
  const char *label = panel->drawings[i]->label;
  ph_plot_text(label ? label + common : "", text);
  ph_plot_text_round(text);
}

/* The name that all have in common; empty without one. */
static void head_text(const struct ph_panel *panel, size_t common,
                      char text[PH_PLOT_TEXT_MAX]) {
  text[0] = '\0';
  if (common > 0) {
    char *end;
    ph_plot_text(panel->drawings[0]->label, text);
    end = strstr(text, equals);
    if (end) {
      *end = '\0';
    }
  }
}

static bool is_bar(const struct ph_panel *panel) {
  return panel->n > PH_LEGEND_MAX;
}

/* Labels are shown of these drawings. */
static size_t shown_n(const struct ph_panel *panel) {
  return is_bar(panel) ? BAR_LABELS : panel->n;
}

static size_t shown(const struct ph_panel *panel, size_t i) {
  return is_bar(panel)
             ? (i * (panel->n - 1) + (BAR_LABELS - 1) / 2) / (BAR_LABELS - 1)
             : i;
}

double ph_legend_width(const struct ph_panel *panel, struct ph_page *page,
                       double em, double most) {
  size_t common = ph_legend_common(panel);
  char text[PH_PLOT_TEXT_MAX];
  double width = 0, head;
  bool any = false;
  if (panel->n < 2) {
    return 0;
  }
  for (size_t i = 0; i < shown_n(panel); i++) {
    value_text(panel, shown(panel, i), common, text);
    any = any || text[0] != '\0';
    width = fmax(width, ph_page_text_width(page, LETTERS * em, text));
  }
  width += ((is_bar(panel) ? BAR : SAMPLE) + GAP + 0.1) * em;
  head_text(panel, common, text);
  head = ph_page_text_width(page, LETTERS * em, text);
  return any ? fmin(fmax(width, head), most) : 0;
}

static void put(struct ph_page *page, double x, double y, double em,
                double width, char text[PH_PLOT_TEXT_MAX]) {
  struct ph_spot at = {x, y + 0.3 * em};
  ph_plot_text_fit(page, LETTERS * em, width, text);
  ph_page_text(page, at, LETTERS * em, 0, false, text);
}

static void draw_lines(const struct ph_panel *panel, struct ph_page *page,
                       const struct ph_rect *place, double em, size_t common) {
  char text[PH_PLOT_TEXT_MAX];
  for (size_t i = 0; i < panel->n; i++) {
    double y = place->y + (0.5 + (double)i) * LINE * em;
    struct ph_spot from = {place->x, y}, to = {place->x + SAMPLE * em, y};
    const struct ph_dash dash = ph_colour_dash(i, panel->n, em);
    ph_page_pen(page, ph_colour_ramp(i, panel->n), 0.14 * em, 0);
    ph_page_dash(page, &dash);
    ph_page_move(page, from);
    ph_page_line(page, to);
    ph_page_stroke(page);
    value_text(panel, i, common, text);
    put(page, to.x + GAP * em, y, em, place->w - (SAMPLE + GAP) * em, text);
  }
}

static void draw_bar(const struct ph_panel *panel, struct ph_page *page,
                     const struct ph_rect *place, double em, size_t common) {
  char text[PH_PLOT_TEXT_MAX];
  double top = place->y + 0.5 * LINE * em;
  double h = fmin(place->h - LINE * em, 16 * em);
  for (size_t i = 0; i < BAR_STRIPS; i++) { /* each over the rest of the bar */
    double from = h * (double)i / BAR_STRIPS;
    struct ph_rect strip = {place->x, top + from, BAR * em, h - from};
    ph_page_pen(page, ph_colour_ramp(i, BAR_STRIPS), 1, 0);
    ph_page_rect(page, &strip);
    ph_page_fill(page);
  }
  for (size_t i = 0; i < BAR_LABELS; i++) {
    size_t k = shown(panel, i);
    double y = top + h * (double)k / (double)(panel->n - 1);
    value_text(panel, k, common, text);
    put(page, place->x + (BAR + GAP) * em, y, em, place->w - (BAR + GAP) * em,
        text);
  }
}

void ph_legend_draw(const struct ph_panel *panel, struct ph_page *page,
                    const struct ph_rect *place, double em) {
  size_t common = ph_legend_common(panel);
  struct ph_rect rest = *place;
  char text[PH_PLOT_TEXT_MAX];
  head_text(panel, common, text);
  if (text[0] != '\0') {
    put(page, rest.x, rest.y + 0.5 * LINE * em, em, rest.w, text);
    rest.y += LINE * em;
    rest.h -= LINE * em;
  }
  if (is_bar(panel)) {
    draw_bar(panel, page, &rest, em, common);
  } else {
    draw_lines(panel, page, &rest, em, common);
  }
}
