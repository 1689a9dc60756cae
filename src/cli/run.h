/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The pipeline: reads records, has them worked on, writes results in order.
 *
 * A ring of slots, each with a batch of items, their text and their output.
 * The main thread fills free slots and writes finished ones in the order in
 * which they were filled; workers take filled slots in between.  With one job
 * the main thread does the work too, by the same code and without threads.
 * Memory is bounded by the slots, not by the stream.
 */
#ifndef PH_CLI_RUN_H
#define PH_CLI_RUN_H

#include "cli/option.h"

/* ph_run: runs a command line; prints results and messages.
 * ret  the exit status, 0..5 */
int ph_run(const struct ph_options *options);

#endif
