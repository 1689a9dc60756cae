/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Where results and figures go: standard output, or files that are replaced
 * only when everything was written.
 *
 * A file is written under a temporary name in its own directory and renamed
 * at the end; it reaches the disk before its name does, so that even a machine
 * that loses power has the old file or the whole new one.  SIGINT, SIGTERM and
 * the like remove temporary files and then end the program as they would have.
 * A name that exists and is not a regular file (a device, a pipe) is written to
 * directly, and so is a descriptor that the program was started with
 * (/dev/stdout, /dev/fd/3): nothing that stands there is replaced.
 */
#ifndef PH_CLI_OUTPUT_H
#define PH_CLI_OUTPUT_H

#include "base/diag.h"

#include <stdbool.h>
#include <stddef.h>

/* One that is open stays where it is: signals find it. */
struct ph_output {
  const char *name; /* for messages */
  int descriptor;
  bool sync;              /* wait for the disk */
  bool if_changed;        /* leave a file that has these bytes as it is */
  char *target;           /* NULL: no renaming */
  char *temporary;        /* exists as long as it is not NULL */
  struct ph_output *next; /* of those with a temporary file */
};

/* ph_output_prepare: to be called before any file is opened.  A standard
 * descriptor that is closed would be that of the next file, which would get
 * what is meant for the terminal; from now on its use fails. */
void ph_output_prepare(void);

/* ph_output_bytes: writes all n bytes; false, with errno, on failure. */
bool ph_output_bytes(int descriptor, const char *bytes, size_t n);

/* ph_output_open: opens standard output (file NULL or "-") or a file; `sync`:
 * a file that is replaced is to be on the disk when it is committed.
 * ret  PH_OK | PH_E_OUTPUT | PH_E_NO_MEMORY */
enum ph_status ph_output_open(struct ph_output *output, const char *file,
                              bool sync, struct ph_diag *diag);

/* ph_output_same: whether two names (NULL or "-": standard output) are of one
 * file, be it there or not. */
bool ph_output_same(const char *a, const char *b);

/* ph_output_unlike: refuses an input ("-": standard input) that is the very
 * file which is written to directly: what is read would be what was written
 * before, without end.
 * ret  PH_OK | PH_E_OUTPUT */
enum ph_status ph_output_unlike(const struct ph_output *output,
                                const char *input, struct ph_diag *diag);

/* ph_output_write: ret PH_OK | PH_E_OUTPUT */
enum ph_status ph_output_write(struct ph_output *output, const char *bytes,
                               size_t n, struct ph_diag *diag);

/* ph_output_rewrite: the first n bytes of a file that is not committed, once
 * more.  ret PH_OK | PH_E_OUTPUT */
enum ph_status ph_output_rewrite(struct ph_output *output, const char *bytes,
                                 size_t n, struct ph_diag *diag);

/* ph_output_commit: closes, and gives a file its name.  A file system that
 * cannot be waited for is no failure.
 * ret  PH_OK | PH_E_OUTPUT */
enum ph_status ph_output_commit(struct ph_output *output, struct ph_diag *diag);

/* ph_output_discard: closes; a file that was not committed leaves no trace.
 * Harmless after a commit. */
void ph_output_discard(struct ph_output *output);

#endif
