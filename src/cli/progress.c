/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The progress line (see progress.h). */
#include "cli/progress.h"

#include "cli/output.h"

#include <math.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
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

double ph_progress_bytes(const char *const *files, size_t n) {
  double bytes = 0;
  for (size_t i = 0; i < n; i++) {
    struct stat info;
    const bool known =
        (strcmp(files[i], "-") == 0 ? fstat(STDIN_FILENO, &info)
                                    : stat(files[i], &info)) == 0;
    bytes +=
        known && S_ISREG(info.st_mode) ? (double)info.st_size : (double)NAN;
  }
  return bytes;
}

void ph_progress_init(struct ph_progress *progress, bool wanted, bool quiet) {
  progress->records = progress->failed = progress->read = 0;
  progress->total = (double)NAN;
  progress->all = false;
  progress->terminal = isatty(STDERR_FILENO);
  progress->enabled = wanted || (progress->terminal && !quiet);
  progress->visible = false;
  progress->next = progress->terminal ? TERMINAL_FIRST : ELSEWHERE_EVERY;
  clock_gettime(CLOCK_MONOTONIC, &progress->start);
}

/* A time as people say it. */
static int put_time(char *text, size_t size, double s) {
  return s < 100    ? snprintf(text, size, "%.1f s", s)
         : s < 6000 ? snprintf(text, size, "%.0f min", s / 60)
                    : snprintf(text, size, "%.1f h", s / 3600);
}

static void print_line(const struct ph_progress *progress, double elapsed,
                       const char *end) {
  const double done = (double)progress->records;
  const double total = progress->all ? (double)progress->read : progress->total;
  const bool more = total > done; /* and known */
  char line[256], time[32];
  size_t n =
      (size_t)snprintf(line, sizeof line, "phspline: %zu", progress->records);
  if (more) {
    n += (size_t)snprintf(line + n, sizeof line - n, " of %s%.0f",
                          progress->all ? "" : "about ", total);
  }
  put_time(time, sizeof time, elapsed);
  n += (size_t)snprintf(line + n, sizeof line - n, " records, %zu failed, %s",
                        progress->failed, time);
  if (done > 0 && elapsed > 0) {
    n += (size_t)snprintf(line + n, sizeof line - n, ", %.3g a second",
                          done / elapsed);
  }
  if (more && done > 0) {
    put_time(time, sizeof time, elapsed * (total / done - 1));
    n += (size_t)snprintf(line + n, sizeof line - n, ", %s left", time);
  }
  n += (size_t)snprintf(line + n, sizeof line - n, "%s", end);
  ph_output_bytes(STDERR_FILENO, line, n);
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
  progress->all = false; /* nothing is left */
  progress->total = (double)NAN;
  if (progress->enabled && !progress->terminal) {
    print_line(progress, seconds(progress), "\n");
  }
}
