/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The figure of a run (see plot.h). */
#include "cli/plot.h"

#include "base/suggest.h"
#include "io/number.h"
#include "plot/figure.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* Figures are no smaller and no larger than this to a side; cairo's limit is
 * 32767. */
enum { SIDE_MIN = 100, SIDE_MAX = 20000 };

/* Places of all drawings together, and for how many the memory of one counts at
 * least: some 300 MB. */
enum { PLACES_MAX = 5000000, PLACES_MIN = 500 };

/* A whole number within bounds, and nothing after it. */
static bool read_side(const char *text, const char *end, size_t *side) {
  double x;
  if (ph_number_read_text(text, end, &x) != end || !(x >= SIDE_MIN) ||
      !(x <= SIDE_MAX) || floor(x) < x) {
    return false;
  }
  *side = (size_t)x;
  return true;
}

enum ph_status ph_plot_read_size(const char *text, struct ph_options *options,
                                 struct ph_diag *diag) {
  const char *cross = text + strcspn(text, "x"), *end = text + strlen(text);
  char excerpt[PH_EXCERPT_MAX];
  if (*cross && read_side(text, cross, &options->plot_width) &&
      read_side(cross + 1, end, &options->plot_height)) {
    return PH_OK;
  }
  return ph_fail(diag, PH_USAGE, NULL,
                 "--plot-size must be WIDTHxHEIGHT, whole numbers from %d to "
                 "%d, found '%s'",
                 SIDE_MIN, SIDE_MAX,
                 ph_excerpt(text, (size_t)(end - text), excerpt));
}

enum ph_status ph_plot_check(const struct ph_options *options,
                             struct ph_diag *diag) {
  const char *file = options->plot;
  char excerpt[PH_EXCERPT_MAX];
  if (!file) {
    return options->plot_width
               ? ph_fail(diag, PH_USAGE, NULL, "--plot-size needs --plot")
               : PH_OK;
  }
  if (ph_figure_format_of(file) == PH_FIGURE_FORMAT_N) {
    return ph_fail(diag, PH_USAGE, NULL,
                   "--plot must be the name of a .svg, .pdf or .png file, "
                   "found '%s'",
                   ph_excerpt(file, strlen(file), excerpt));
  }
  if (!ph_figure_can()) {
    return ph_fail(diag, PH_USAGE, NULL,
                   "--plot: this phspline was built without cairo: install "
                   "libcairo2-dev (Debian, Ubuntu), cairo-devel (Fedora) or "
                   "cairo (elsewhere) and build it again");
  }
  if (ph_output_same(options->output, file)) {
    return ph_fail(diag, PH_USAGE, NULL, "--plot and %s are the same file",
                   options->output ? "--output" : "standard output");
  }
  return PH_OK;
}

enum ph_status ph_plot_open(struct ph_plot *plot,
                            const struct ph_options *options,
                            struct ph_diag *diag) {
  *plot = (struct ph_plot){.options = options, .output = {.descriptor = -1}};
  return options->plot ? ph_output_open(&plot->output, options->plot,
                                        !options->no_sync, diag)
                       : PH_OK;
}

bool ph_plot_wants(const struct ph_plot *plot, size_t record) {
  return plot->options->plot && !plot->full &&
         (plot->n == 0 || record != plot->panel ||
          plot->inside < PH_FIGURE_SWEEP_MAX);
}

/* A swept value as one reads it: six digits, words without quotes. */
static void put_value(struct ph_buf *buf, const char *json) {
  size_t n = strlen(json);
  char excerpt[PH_EXCERPT_MAX];
  double x;
  if (ph_number_read(json, json + n, &x) == json + n) {
    snprintf(excerpt, sizeof excerpt, "%.6g", x);
    ph_buf_puts(buf, excerpt);
  } else if (*json == '"') {
    ph_buf_put(buf, json + 1, n - 2);
  } else {
    ph_buf_puts(buf, ph_excerpt(json, n, excerpt));
  }
}

/* "lengths[1] = 2.5, alpha = 1"; NULL when memory is exhausted. */
static const char *label_of(const struct ph_plot_subject *subject,
                            struct ph_arena *arena) {
  struct ph_buf buf = {0};
  const char *label;
  for (size_t i = 0; i < subject->swept_n; i++) {
    const struct ph_swept *swept = &subject->swept[i];
    ph_buf_puts(&buf, i ? ", " : "");
    ph_buf_puts(&buf, swept->name);
    ph_buf_puts(&buf, " = ");
    put_value(&buf, swept->value);
  }
  label = buf.failed ? NULL : ph_arena_copy(arena, buf.data, buf.n);
  ph_buf_free(&buf);
  return label;
}

enum ph_status ph_plot_draw(const struct ph_plot_subject *subject,
                            const struct ph_problem *problem,
                            const struct ph_result *result,
                            struct ph_arena *scratch,
                            struct ph_drawing **drawing, struct ph_diag *diag) {
  const char *id = subject->id;
  char title[PH_EXCERPT_MAX];
  struct ph_drawing_names names = {NULL, NULL, subject->record};
  *drawing = NULL;
  if (id) {
    names.title = ph_excerpt(id, strlen(id), title);
  }
  if (subject->swept_n) {
    names.label = label_of(subject, scratch);
    if (!names.label) {
      return ph_fail_memory(diag);
    }
  }
  return ph_drawing_make(problem, result, &names, drawing, diag);
}

/* Whether there is room for one more; counts it if so. */
static bool take(struct ph_plot *plot, const struct ph_drawing *drawing) {
  bool fresh = plot->n == 0 || drawing->record != plot->panel;
  size_t places = drawing->places > PLACES_MIN ? drawing->places : PLACES_MIN;
  if (plot->full || (!fresh && plot->inside == PH_FIGURE_SWEEP_MAX)) {
    return false;
  }
  if ((fresh && plot->panels == PH_FIGURE_PANELS_MAX) ||
      plot->places + places > PLACES_MAX) {
    plot->full = true;
    return false;
  }
  plot->panels += fresh;
  plot->panel = drawing->record;
  plot->inside = fresh ? 1 : plot->inside + 1;
  plot->places += places;
  return true;
}

enum ph_status ph_plot_add(struct ph_plot *plot, struct ph_drawing *drawing,
                           struct ph_diag *diag) {
  plot->solved++;
  if (!drawing || !take(plot, drawing)) {
    ph_drawing_free(drawing);
    return PH_OK;
  }
  if (plot->n == plot->room) {
    size_t room = plot->room ? 2 * plot->room : 16;
    struct ph_drawing **grown =
        ph_realloc(plot->drawings, room * sizeof(struct ph_drawing *));
    if (!grown) {
      ph_drawing_free(drawing);
      return ph_fail_memory(diag);
    }
    plot->drawings = grown;
    plot->room = room;
  }
  plot->drawings[plot->n++] = drawing;
  return PH_OK;
}

enum ph_status ph_plot_write(struct ph_plot *plot, struct ph_diag *diag) {
  const struct ph_options *o = plot->options;
  struct ph_figure_rules rules;
  struct ph_buf bytes = {0};
  enum ph_status status;
  if (!o->plot) {
    return PH_OK;
  }
  rules =
      (struct ph_figure_rules){ph_figure_format_of(o->plot),
                               (double)o->plot_width, (double)o->plot_height};
  status = ph_figure_write((const struct ph_drawing *const *)plot->drawings,
                           plot->n, &rules, &bytes, diag);
  if (status == PH_OK && bytes.failed) {
    status = ph_fail_memory(diag);
  }
  if (status == PH_OK) {
    status = ph_output_write(&plot->output, bytes.data, bytes.n, diag);
  }
  if (status == PH_OK) {
    status = ph_output_commit(&plot->output, diag);
  }
  ph_buf_free(&bytes);
  return status;
}

void ph_plot_free(struct ph_plot *plot) {
  for (size_t i = 0; i < plot->n; i++) {
    ph_drawing_free(plot->drawings[i]);
  }
  ph_free(plot->drawings);
  ph_output_discard(&plot->output);
}
