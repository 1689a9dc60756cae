/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The figure of a run (see plot.h). */
#define _DEFAULT_SOURCE /* MAP_ANONYMOUS */
#include "cli/plot.h"

#include "base/suggest.h"
#include "curve/kind/kind.h"
#include "io/number.h"
#include "plot/figure.h"

#include <errno.h>
#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif

/* Figures are no smaller and no larger than this to a side; cairo's limit is
 * 32767. */
enum { SIDE_MIN = 100, SIDE_MAX = 20000 };

/* Places of all drawings together, and for how many the memory of one counts at
 * least: some 300 MB. */
enum { PLACES_MAX = 5000000, PLACES_MIN = 500 };

/* Seconds after which drawing is taken to hang.  The largest figures take some
 * 20 of an idle processor. */
enum { DRAWING_MAX = 600 };

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
  return ph_fail(diag, PH_E_USAGE, NULL,
                 "--plot-size must be WIDTHxHEIGHT, whole numbers from %d to "
                 "%d, found '%s'",
                 SIDE_MIN, SIDE_MAX,
                 ph_excerpt(text, (size_t)(end - text), excerpt));
}

enum ph_status ph_plot_check(const struct ph_options *options,
                             struct ph_diag *diag) {
  const char *file = options->plot;
  char excerpt[PH_EXCERPT_MAX];
  struct ph_diag missing;
  if (!file) {
    const char *lone = options->plot_width ? "plot-size"
                       : options->title    ? "title"
                       : options->labels   ? "labels"
                                           : NULL;
    return lone ? ph_fail(diag, PH_E_USAGE, NULL, "--%s needs --plot", lone)
                : PH_OK;
  }
  if (ph_figure_format_of(file) == PH_FIGURE_FORMAT_N) {
    return ph_fail(diag, PH_E_USAGE, NULL,
                   "--plot must be the name of a .svg, .pdf or .png file, "
                   "found '%s'",
                   ph_excerpt(file, strlen(file), excerpt));
  }
  if (ph_figure_can(&missing) != PH_OK) {
    return ph_fail(diag, missing.status, NULL, "--plot: %s", missing.message);
  }
  if (ph_output_same(options->output, file)) {
    return ph_fail(diag, PH_E_USAGE, NULL, "--plot and %s are the same file",
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
  return ph_kind_of(&result->curve)->parts == PH_PATCHES_PARTS
             ? ph_quilt_drawing(result, &names, drawing, diag)
             : ph_drawing_make(problem, result, &names, drawing, diag);
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

/* Draws, and writes the bytes. */
static enum ph_status draw(struct ph_plot *plot, struct ph_diag *diag) {
  const struct ph_options *o = plot->options;
  const struct ph_figure_rules rules = {
      ph_figure_format_of(o->plot), (double)o->plot_width,
      (double)o->plot_height, o->title, o->labels};
  struct ph_buf bytes = {0};
  enum ph_status status =
      ph_figure_write((const struct ph_drawing *const *)plot->drawings, plot->n,
                      &rules, &bytes, diag);
  if (status == PH_OK && bytes.failed) {
    status = ph_fail_memory(diag);
  }
  if (status == PH_OK) {
    status = ph_output_write(&plot->output, bytes.data, bytes.n, diag);
  }
  ph_buf_free(&bytes);
  return status;
}

/* What the process that draws has to tell, in memory that it shares. */
struct outcome {
  bool told;
  enum ph_status status;
  struct ph_diag diag;
};

/* The process that draws: it ends with its parent, and when it hangs. */
static void draw_apart(struct ph_plot *plot, struct outcome *outcome) {
  sigset_t set;
#ifdef __linux__
  prctl(PR_SET_PDEATHSIG,
        SIGKILL); /* elsewhere it comes to its end by itself */
#endif
  sigemptyset(&set);
  sigaddset(&set, SIGALRM);
  sigprocmask(SIG_UNBLOCK, &set, NULL);
  signal(SIGALRM, SIG_DFL);
  alarm(DRAWING_MAX);
  outcome->status = draw(plot, &outcome->diag);
  outcome->told = true;
  _exit(0);
}

/* What has become of that process, which ended as waitpid says. */
static enum ph_status judge(const char *file, int end,
                            const struct outcome *outcome,
                            struct ph_diag *diag) {
  int number = WIFSIGNALED(end) ? WTERMSIG(end) : 0;
  if (outcome->told && WIFEXITED(end) && WEXITSTATUS(end) == 0) {
    *diag = outcome->diag;
    return outcome->status;
  }
  if (number == SIGPIPE) {
    raise(number); /* the reader of the figure has gone away: silently */
  }
  if (number == SIGALRM) {
    return ph_fail(diag, PH_E_INTERNAL, NULL,
                   "cannot draw %s: not done after %d s; the results are whole",
                   file, DRAWING_MAX);
  }
  if (number) {
    return ph_fail(diag, PH_E_INTERNAL, NULL,
                   "cannot draw %s: drawing was ended by signal %d (%s), as it "
                   "is when memory is exhausted; the results are whole",
                   file, number, strsignal(number));
  }
  return ph_fail(diag, PH_E_INTERNAL, NULL,
                 "cannot draw %s: drawing ended with status %d; the results "
                 "are whole",
                 file, WEXITSTATUS(end));
}

/* Draws in a process of its own: cairo, and what it calls, do not all survive
 * that memory is exhausted.  No other thread is left at this time. */
static enum ph_status draw_safely(struct ph_plot *plot, struct ph_diag *diag) {
  const char *file = plot->options->plot;
  struct outcome *outcome = mmap(NULL, sizeof *outcome, PROT_READ | PROT_WRITE,
                                 MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  enum ph_status status;
  pid_t child, ended;
  int end = 0;
  if (outcome == MAP_FAILED) {
    return ph_fail_memory(diag);
  }
  signal(SIGCHLD, SIG_DFL); /* where it is ignored, no end is told */
  child = fork();
  if (child == 0) {
    draw_apart(plot, outcome);
  }
  do {
    ended = child < 0 ? child : waitpid(child, &end, 0);
  } while (child > 0 && ended < 0 && errno == EINTR);
  status = ended < 0
               ? ph_fail(diag, PH_E_INTERNAL, NULL,
                         "cannot draw %s: no process for it: %s; the results "
                         "are whole",
                         file, strerror(errno))
               : judge(file, end, outcome, diag);
  munmap(outcome, sizeof *outcome);
  return status;
}

enum ph_status ph_plot_write(struct ph_plot *plot, struct ph_diag *diag) {
  enum ph_status status = plot->options->plot ? draw_safely(plot, diag) : PH_OK;
  return status == PH_OK && plot->options->plot
             ? ph_output_commit(&plot->output, diag)
             : status;
}

void ph_plot_free(struct ph_plot *plot) {
  for (size_t i = 0; i < plot->n; i++) {
    ph_drawing_free(plot->drawings[i]);
  }
  ph_free(plot->drawings);
  ph_output_discard(&plot->output);
}
