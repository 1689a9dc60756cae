/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Volumes by teem (see nrrd.h), which is loaded when it is needed where
 * PH_TEEM_NAME says what the shared library is called. */
#include "io/nrrd.h"

#include "base/library.h"

#ifdef PH_TEEM

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <teem/nrrd.h>

/* A matrix of columns this near to one another has no inverse, relative. */
static const double SINGULAR = 1e-9;

enum { WHITE = 65535 };

/* ---- the library --------------------------------------------------------- */

/* What is used of it. */
#define TEEM(X)             \
  X(biffGetDone)            \
  X(nrrdAxisInfoSet_va)     \
  X(nrrdBiffKey)            \
  X(nrrdEncodingRaw)        \
  X(nrrdFormatNRRD)         \
  X(nrrdFormatPNG)          \
  X(nrrdIoStateEncodingSet) \
  X(nrrdIoStateFormatSet)   \
  X(nrrdIoStateNew)         \
  X(nrrdIoStateNix)         \
  X(nrrdIoStateSet)         \
  X(nrrdLoad)               \
  X(nrrdNew)                \
  X(nrrdNix)                \
  X(nrrdNuke)               \
  X(nrrdSpaceDimensionSet)  \
  X(nrrdSpaceOriginSet)     \
  X(nrrdTypeSize)           \
  X(nrrdWrap_va)            \
  X(nrrdWrite)

/* Where each of them is. */
struct teem {
  TEEM(PH_LIBRARY_MEMBER)
};

#ifdef PH_TEEM_NAME

static enum ph_status load_teem(struct teem *teem, struct ph_diag *diag) {
#define SYMBOL(name) {#name, offsetof(struct teem, name)},
  static const struct ph_library_symbol symbols[] = {TEEM(SYMBOL)};
#undef SYMBOL
  const char *why;
  return ph_library_load(PH_TEEM_NAME, symbols,
                         sizeof symbols / sizeof symbols[0], teem, &why)
             ? PH_OK
             : ph_fail(diag, PH_E_INPUT, NULL,
                       "volumes need the library teem: %s", why);
}

#else

static enum ph_status load_teem(struct teem *teem, struct ph_diag *diag) {
  (void)diag;
#define ADDRESS(name) teem->name = &(name);
  TEEM(ADDRESS)
#undef ADDRESS
  return PH_OK;
}

#endif

bool ph_nrrd_can(void) {
  return true;
}

/* What teem says, the last of its lines. */
static enum ph_status failed(const struct teem *teem, const char *what,
                             enum ph_status status, struct ph_diag *diag) {
  char *said = teem->biffGetDone(*teem->nrrdBiffKey), *line, *sign;
  size_t n = said ? strlen(said) : 0;
  while (n > 0 && said[n - 1] == '\n') {
    said[--n] = '\0';
  }
  line = n ? strrchr(said, '\n') : NULL;
  line = line ? line + 1 : n ? said : NULL;
  sign = line ? strstr(line, ": ") : NULL;
  ph_fail(diag, status, NULL, "%s: %.200s", what,
          sign   ? sign + 2
          : line ? line
                 : "teem does not say why");
  free(said);
  return status;
}

/* ---- reading ------------------------------------------------------------- */

static const struct {
  int type;
  enum ph_voxel voxel;
} types[] = {{nrrdTypeChar, PH_VOXEL_I8},   {nrrdTypeUChar, PH_VOXEL_U8},
             {nrrdTypeShort, PH_VOXEL_I16}, {nrrdTypeUShort, PH_VOXEL_U16},
             {nrrdTypeInt, PH_VOXEL_I32},   {nrrdTypeUInt, PH_VOXEL_U32},
             {nrrdTypeFloat, PH_VOXEL_F32}, {nrrdTypeDouble, PH_VOXEL_F64}};

static bool set_type(const Nrrd *nrrd, struct ph_volume *volume) {
  for (size_t i = 0; i < sizeof types / sizeof types[0]; i++) {
    if (types[i].type == nrrd->type) {
      volume->type = types[i].voxel;
      return true;
    }
  }
  return false;
}

/* Steps along the axes as columns, by space directions or by spacings, and
 * where the first point is: not where the first cell begins. */
static void place(const Nrrd *nrrd, struct ph_volume *volume,
                  double step[3][3]) {
  for (size_t a = 0; a < 3; a++) {
    const NrrdAxisInfo *axis = &nrrd->axis[a];
    const double spacing = isnan(axis->spacing) ? 1 : axis->spacing;
    if (nrrd->spaceDim) {
      for (size_t j = 0; j < 3; j++) {
        step[j][a] = axis->spaceDirection[j];
      }
      volume->origin[a] =
          isnan(nrrd->spaceOrigin[a]) ? 0 : nrrd->spaceOrigin[a];
    } else {
      const double half = axis->center == nrrdCenterCell ? spacing / 2 : 0;
      step[a][a] = spacing;
      volume->origin[a] = isnan(axis->min) ? 0 : axis->min + half;
    }
  }
}

/* The inverse by cross products of the columns. */
static bool invert(const double m[3][3], double inverse[3][3]) {
  double det = 0, size = 1;
  for (size_t a = 0; a < 3; a++) {
    const size_t b = (a + 1) % 3, c = (a + 2) % 3;
    for (size_t j = 0; j < 3; j++) {
      const size_t k = (j + 1) % 3, l = (j + 2) % 3;
      inverse[a][j] = m[k][b] * m[l][c] - m[l][b] * m[k][c];
    }
    size *= hypot(hypot(m[0][a], m[1][a]), m[2][a]);
  }
  for (size_t j = 0; j < 3; j++) {
    det += m[j][0] * inverse[0][j];
  }
  for (size_t i = 0; i < 9; i++) {
    inverse[i / 3][i % 3] /= det;
  }
  return fabs(det) > SINGULAR * size && isfinite(size);
}

/* Why a file is no volume, or NULL. */
static const char *fault_of(const Nrrd *nrrd, struct ph_volume *volume) {
  double step[3][3] = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
  if (nrrd->dim != 3) {
    return "must have 3 axes, of numbers, not of vectors or colours";
  }
  if (nrrd->spaceDim != 0 && nrrd->spaceDim != 3) {
    return "must have a space of 3 dimensions, or none";
  }
  if (!set_type(nrrd, volume)) {
    return "must be of integers of up to 32 bits, float or double";
  }
  for (size_t a = 0; a < 3; a++) {
    volume->n[a] = nrrd->axis[a].size;
    if (volume->n[a] < 2) {
      return "must have 2 or more points along each axis";
    }
  }
  place(nrrd, volume, step);
  return invert(step, volume->inverse)
             ? NULL
             : "must have spacings or space directions of which none depends "
               "on the others";
}

static enum ph_status load(const struct teem *teem, const char *file,
                           Nrrd *nrrd, NrrdIoState *state, size_t most,
                           struct ph_volume *volume, struct ph_diag *diag) {
  const char *fault;
  double bytes;
  char what[300];
  snprintf(what, sizeof what, "cannot read the volume %.200s", file);
  teem->nrrdIoStateSet(state, nrrdIoStateSkipData, AIR_TRUE);
  if (teem->nrrdLoad(nrrd, file, state)) {
    return failed(teem, what, PH_E_INPUT, diag);
  }
  fault = fault_of(nrrd, volume);
  if (fault) {
    return ph_fail(diag, PH_E_INPUT, NULL, "%s: it %s", what, fault);
  }
  bytes = (double)volume->n[0] * (double)volume->n[1] * (double)volume->n[2] *
          (double)(*teem->nrrdTypeSize)[nrrd->type];
  if (!(bytes <= (double)most)) {
    return ph_fail(diag, PH_E_INPUT, NULL,
                   "%s: it takes %.0f bytes, more than the %zu of --max-memory",
                   what, bytes, most);
  }
  teem->nrrdIoStateSet(state, nrrdIoStateSkipData, AIR_FALSE);
  return teem->nrrdLoad(nrrd, file, NULL) ? failed(teem, what, PH_E_INPUT, diag)
                                          : PH_OK;
}

static enum ph_status read_by(const struct teem *teem, const char *file,
                              size_t most, struct ph_volume *volume,
                              struct ph_diag *diag) {
  Nrrd *nrrd = teem->nrrdNew();
  NrrdIoState *state = teem->nrrdIoStateNew();
  enum ph_status status = load(teem, file, nrrd, state, most, volume, diag);
  if (status == PH_OK) {
    volume->v = nrrd->data;
    teem->nrrdNix(nrrd);
  } else {
    teem->nrrdNuke(nrrd);
  }
  teem->nrrdIoStateNix(state);
  return status;
}

enum ph_status ph_nrrd_read(const char *file, size_t most,
                            struct ph_volume *volume, struct ph_diag *diag) {
  struct teem teem;
  enum ph_status status = load_teem(&teem, diag);
  return status == PH_OK ? read_by(&teem, file, most, volume, diag) : status;
}

void ph_nrrd_free(struct ph_volume *volume) {
  free((void *)(uintptr_t)volume->v);
  volume->v = NULL;
}

/* ---- writing ------------------------------------------------------------- */

/* From black to white, rounded. */
static unsigned short grey(const double range[2], double x) {
  const double part = (x - range[0]) / (range[1] - range[0]);
  return part > 0 ? (unsigned short)floor(fmin(part, 1) * WHITE + 0.5) : 0;
}

static void *values(const struct ph_panorama *p, double fill, bool png) {
  const size_t n = p->width * p->height;
  unsigned short *greys = png ? malloc(n * sizeof *greys) : NULL;
  double *all = png ? NULL : malloc(n * sizeof *all);
  for (size_t i = 0; (greys || all) && i < n; i++) {
    const double x = isnan(p->v[i]) ? fill : p->v[i];
    if (greys) {
      greys[i] = grey(p->range, x);
    } else {
      all[i] = x;
    }
  }
  return png ? (void *)greys : (void *)all;
}

/* Where the points of the panorama are in the plane. */
static bool describe(const struct teem *teem, const struct ph_panorama *p,
                     Nrrd *nrrd) {
  const double step = 1 / p->resolution;
  const double right[NRRD_SPACE_DIM_MAX] = {step, 0};
  const double down[NRRD_SPACE_DIM_MAX] = {0, -step};
  double origin[NRRD_SPACE_DIM_MAX] = {p->origin[0], p->origin[1]};
  if (teem->nrrdSpaceDimensionSet(nrrd, 2) ||
      teem->nrrdSpaceOriginSet(nrrd, origin)) {
    return false;
  }
  teem->nrrdAxisInfoSet_va(nrrd, nrrdAxisInfoSpaceDirection, right, down);
  return true;
}

static bool encode(const struct teem *teem, Nrrd *nrrd,
                   const struct ph_panorama *p, void *data, bool png,
                   FILE *file) {
  NrrdIoState *state = teem->nrrdIoStateNew();
  bool ok =
      !teem->nrrdWrap_va(nrrd, data, png ? nrrdTypeUShort : nrrdTypeDouble, 2,
                         p->width, p->height) &&
      (png || describe(teem, p, nrrd)) &&
      !teem->nrrdIoStateFormatSet(state, png ? *teem->nrrdFormatPNG
                                             : *teem->nrrdFormatNRRD) &&
      !teem->nrrdIoStateEncodingSet(state, *teem->nrrdEncodingRaw) &&
      !teem->nrrdWrite(file, nrrd, state);
  teem->nrrdIoStateNix(state);
  return ok;
}

static enum ph_status write_by(const struct teem *teem,
                               const struct ph_panorama *panorama, double fill,
                               bool png, struct ph_buf *to,
                               struct ph_diag *diag) {
  void *data = values(panorama, fill, png);
  char *bytes = NULL;
  size_t n = 0;
  FILE *file = open_memstream(&bytes, &n);
  Nrrd *nrrd = teem->nrrdNew();
  enum ph_status status = PH_OK;
  if (!data || !file) {
    status = ph_fail_memory(diag);
  } else if (!encode(teem, nrrd, panorama, data, png, file)) {
    status = failed(teem, "cannot write the panorama", PH_E_OUTPUT, diag);
  }
  if (file && fclose(file) != 0 && status == PH_OK) {
    status = ph_fail_memory(diag);
  }
  if (status == PH_OK) {
    ph_buf_put(to, bytes, n);
  }
  teem->nrrdNix(nrrd);
  free(bytes);
  free(data);
  return status == PH_OK && to->failed ? ph_fail_memory(diag) : status;
}

enum ph_status ph_nrrd_write(const struct ph_panorama *panorama, double fill,
                             bool png, struct ph_buf *to,
                             struct ph_diag *diag) {
  struct teem teem;
  enum ph_status status = load_teem(&teem, diag);
  return status == PH_OK ? write_by(&teem, panorama, fill, png, to, diag)
                         : status;
}

#endif
