/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Volumes on surfaces, laid flat (see panorama.h). */
#include "cli/panorama.h"

#include "base/suggest.h"
#include "io/nrrd.h"

#include <string.h>

static bool ends(const char *file, const char *suffix) {
  const size_t n = strlen(file), m = strlen(suffix);
  return n > m && strcmp(file + n - m, suffix) == 0;
}

enum ph_status ph_panorama_check(const struct ph_options *o,
                                 struct ph_diag *diag) {
  const char *file = o->panorama;
  char excerpt[PH_EXCERPT_MAX];
  if (!file && !o->volume_file && !(o->resolution > 0) && !o->fill_given) {
    return PH_OK;
  }
  if (!ph_nrrd_can()) {
    return ph_fail(diag, PH_E_USAGE, NULL,
                   "--panorama: this phspline was built without teem: install "
                   "libteem-dev (Debian, Ubuntu) or teem (elsewhere) and build "
                   "it again");
  }
  if (!file || !o->volume_file || !(o->resolution > 0)) {
    return ph_fail(diag, PH_E_USAGE, NULL,
                   "--volume, --panorama and --resolution go together");
  }
  if (!ends(file, ".png") && !ends(file, ".nrrd")) {
    return ph_fail(diag, PH_E_USAGE, NULL,
                   "--panorama must be the name of a .png or .nrrd file, found "
                   "'%s'",
                   ph_excerpt(file, strlen(file), excerpt));
  }
  if (o->sweeps_n) {
    return ph_fail(diag, PH_E_USAGE, NULL,
                   "--panorama is the picture of one result, --sweep gives "
                   "several");
  }
  if (ph_output_same(o->output, file) ||
      (o->plot && ph_output_same(o->plot, file)) ||
      ph_output_same(o->volume_file, file)) {
    return ph_fail(diag, PH_E_USAGE, NULL,
                   "--panorama must be a file of its own, '%s' is that of "
                   "another option, too",
                   ph_excerpt(file, strlen(file), excerpt));
  }
  return PH_OK;
}

enum ph_status ph_panorama_write(const struct ph_options *o,
                                 const struct ph_panorama *panorama,
                                 struct ph_output *output,
                                 struct ph_diag *diag) {
  struct ph_buf bytes = {0};
  enum ph_status status;
  if (!panorama) {
    return PH_OK;
  }
  status =
      ph_nrrd_write(panorama, o->fill, ends(o->panorama, ".png"), &bytes, diag);
  if (status == PH_OK) {
    status = ph_output_write(output, bytes.data, bytes.n, diag);
  }
  ph_buf_free(&bytes);
  return status == PH_OK ? ph_output_commit(output, diag) : status;
}

struct ph_panorama *ph_panorama_copy(const struct ph_panorama *panorama) {
  const size_t n = panorama->width * panorama->height * sizeof *panorama->v;
  struct ph_panorama *copy = ph_malloc(sizeof *copy + n);
  if (copy) {
    *copy = *panorama;
    copy->v = (double *)(void *)(copy + 1);
    memcpy(copy->v, panorama->v, n);
  }
  return copy;
}
