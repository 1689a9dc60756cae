/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What there is of volumes without teem (see nrrd.h): the news that there are
 * none. */
#include "io/nrrd.h"

#ifndef PH_TEEM

bool ph_nrrd_can(void) {
  return false;
}

static enum ph_status without(struct ph_diag *diag) {
  return ph_fail(diag, PH_E_INTERNAL, NULL,
                 "volumes need teem, which this program was built without");
}

enum ph_status ph_nrrd_read(const char *file, size_t most,
                            struct ph_volume *volume, struct ph_diag *diag) {
  (void)file, (void)most, (void)volume;
  return without(diag);
}

void ph_nrrd_free(struct ph_volume *volume) {
  (void)volume;
}

enum ph_status ph_nrrd_write(const struct ph_panorama *panorama, double fill,
                             bool png, struct ph_buf *to,
                             struct ph_diag *diag) {
  (void)panorama, (void)fill, (void)png, (void)to;
  return without(diag);
}

#endif
