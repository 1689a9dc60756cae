/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The panorama of a run (--volume, --panorama): the volume, which is read
 * before all records, and the picture of the only result, which is written
 * behind it.
 */
#ifndef PH_CLI_PANORAMA_H
#define PH_CLI_PANORAMA_H

#include "cli/option.h"
#include "cli/output.h"

/* ph_panorama_check: whether --panorama and what belongs to it make sense.
 * ret  PH_OK | PH_E_USAGE */
enum ph_status ph_panorama_check(const struct ph_options *options,
                                 struct ph_diag *diag);

/* ph_panorama_write: writes a file, of a panorama that may be missing.
 * ret  PH_OK | PH_E_OUTPUT | PH_E_NO_MEMORY */
enum ph_status ph_panorama_write(const struct ph_options *options,
                                 const struct ph_panorama *panorama,
                                 struct ph_output *output,
                                 struct ph_diag *diag);

/* ph_panorama_copy: one that outlives the memory of its record; NULL: memory is
 * exhausted. */
struct ph_panorama *ph_panorama_copy(const struct ph_panorama *panorama);

#endif
