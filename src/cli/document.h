/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The output as a whole: what the format has before, between and after the
 * records. */
#ifndef PH_CLI_DOCUMENT_H
#define PH_CLI_DOCUMENT_H

#include "cli/option.h"
#include "cli/output.h"

#include <stdbool.h>

struct ph_document {
  const struct ph_options *options;
  struct ph_output *output;
  size_t bytes;       /* of records */
  bool joined;        /* some record is written: the next one is joined to it */
  struct ph_buf kept; /* records of a format that is kept to its end */
  double box[4];      /* what they draw */
};

/* ph_document_begin: what stands before all records.
 * ret  PH_OK | PH_E_OUTPUT | PH_E_NO_MEMORY, as of the others */
enum ph_status ph_document_begin(struct ph_document *document,
                                 const struct ph_options *options,
                                 struct ph_output *output,
                                 struct ph_diag *diag);

/* ph_document_add: records, one or more, in order. */
enum ph_status ph_document_add(struct ph_document *document, const char *bytes,
                               size_t n, struct ph_diag *diag);

/* ph_document_end: what stands after all records. */
enum ph_status ph_document_end(struct ph_document *document,
                               struct ph_diag *diag);

/* ph_document_free: gives the memory back; harmless if it is {0}. */
void ph_document_free(struct ph_document *document);

#endif
