/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The progress line (see progress.h). */
#include "cli/progress.h"

#include "cli/output.h"

#include <stdio.h>
#include <unistd.h>

/* Seconds until the first line, and between lines. */
static const double TERMINAL_FIRST = 1, TERMINAL_EVERY = 0.1;
static const double ELSEWHERE_EVERY = 60;

static double seconds(const struct ph_progress *progress) {
  struct timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  return (double)(now.tv_sec - progress->start.tv_sec) +
         1e-9 * (double)(now.tv_nsec - progress->start.tv_nsec);
}

void ph_progress_init(struct ph_progress *progress, bool wanted, bool quiet) {
  progress->records = progress->failed = 0;
  progress->terminal = isatty(STDERR_FILENO);
  progress->enabled = wanted || (progress->terminal && !quiet);
  progress->visible = false;
  progress->next = progress->terminal ? TERMINAL_FIRST : ELSEWHERE_EVERY;
  clock_gettime(CLOCK_MONOTONIC, &progress->start);
}

static void print_line(const struct ph_progress *progress, double elapsed,
                       const char *end) {
  char line[128];
  int n =
      snprintf(line, sizeof line, "phspline: %zu records, %zu failed, %.1f s%s",
               progress->records, progress->failed, elapsed, end);
  ph_output_bytes(STDERR_FILENO, line, (size_t)n);
}

void ph_progress_show(struct ph_progress *progress) {
  double elapsed;
  if (!progress->enabled) {
    return;
  }
  elapsed = seconds(progress);
  if (elapsed >= progress->next) {
    print_line(progress, elapsed, progress->terminal ? "\r" : "\n");
    progress->visible = progress->terminal;
    progress->next =
        elapsed + (progress->terminal ? TERMINAL_EVERY : ELSEWHERE_EVERY);
  }
}

void ph_progress_hide(struct ph_progress *progress) {
  static const char erase[] = "\033[K";
  if (progress->visible) {
    ph_output_bytes(STDERR_FILENO, erase, sizeof erase - 1);
    progress->visible = false;
  }
}

void ph_progress_finish(struct ph_progress *progress) {
  ph_progress_hide(progress);
  if (progress->enabled && !progress->terminal) {
    print_line(progress, seconds(progress), "\n");
  }
}
