/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The progress line on standard error: on a terminal one line that is
 * rewritten, from the second second on; elsewhere, if asked for, a line a
 * minute.  It has the records that are done, how many there are where that can
 * be told, how many failed, the time, the rate and the time that is left.
 */
#ifndef PH_CLI_PROGRESS_H
#define PH_CLI_PROGRESS_H

#include <stdbool.h>
#include <stddef.h>
#include <time.h>

struct ph_progress {
  size_t records, failed; /* so far; kept by the pipeline */
  size_t read;            /* records that were read, and how many there are */
  double total;           /* by the bytes that were; NaN: not known */
  bool all;               /* that is all of them */
  bool enabled, terminal, visible;
  struct timespec start;
  double next; /* seconds after the start at which to show the line again */
};

/* ph_progress_bytes: those of all files; NaN: not all are files. */
double ph_progress_bytes(const char *const *files, size_t n);

/* ph_progress_init: wanted: asked for; quiet: not by itself either. */
void ph_progress_init(struct ph_progress *progress, bool wanted, bool quiet);

/* ph_progress_show: shows the line if it is time to. */
void ph_progress_show(struct ph_progress *progress);

/* ph_progress_hide: removes the line from a terminal, before other output. */
void ph_progress_hide(struct ph_progress *progress);

/* ph_progress_finish: the last word: elsewhere than on a terminal, a line with
 * the totals if any was asked for. */
void ph_progress_finish(struct ph_progress *progress);

#endif
