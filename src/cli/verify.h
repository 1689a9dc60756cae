/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The command verify: results in, verdicts out. */
#ifndef PH_CLI_VERIFY_H
#define PH_CLI_VERIFY_H

#include "cli/work.h"

/* ph_verify_schema: its name; its records are results, which have no fields. */
extern const struct ph_schema ph_verify_schema;

/* ph_verify_work: appends the verdict on one result to `out` and its messages
 * to `err`, and sets item->status, as ph_work does for a problem. */
void ph_verify_work(const struct ph_options *options, struct ph_worker *worker,
                    struct ph_item *item, struct ph_buf *out,
                    struct ph_buf *err);

#endif
