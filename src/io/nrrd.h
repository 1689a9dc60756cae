/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Volumes from NRRD files, and panoramas as NRRD or PNG files.  teem, which
 * does it, may be missing when the program is built, or when it runs; it is
 * asked by one thread only.
 */
#ifndef PH_IO_NRRD_H
#define PH_IO_NRRD_H

#include "base/buf.h"
#include "base/diag.h"
#include "curve/surface/volume.h"

/* ph_nrrd_can: whether the program was built with teem. */
bool ph_nrrd_can(void);

/*
 * ph_nrrd_read: reads a volume of at most so many bytes.
 *
 * inout volume  zeroed; to be given back with ph_nrrd_free
 * ret   PH_OK | PH_E_INPUT, also where teem cannot be loaded
 */
enum ph_status ph_nrrd_read(const char *file, size_t most,
                            struct ph_volume *volume, struct ph_diag *diag);

void ph_nrrd_free(struct ph_volume *volume);

/*
 * ph_nrrd_write: appends a panorama as a file: PNG with 16 bits, where the
 * range is from black to white, or NRRD with the values themselves.
 *
 * in   fill  what the points have that have none
 * ret  PH_OK | PH_E_INPUT | PH_E_OUTPUT | PH_E_NO_MEMORY
 */
enum ph_status ph_nrrd_write(const struct ph_panorama *panorama, double fill,
                             bool png, struct ph_buf *to, struct ph_diag *diag);

#endif
