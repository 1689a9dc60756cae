/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Expands the list of outcomes (status.h) into its three tables. */
#include "base/status.h"

#ifdef __FAST_MATH__
#error "phspline relies on IEEE arithmetic: do not compile with -ffast-math"
#endif

static const char *const codes[] = {
#define X(symbol, code, class, meaning) code,
    PH_STATUS(X)
#undef X
};

static const char *const meanings[] = {
#define X(symbol, code, class, meaning) meaning,
    PH_STATUS(X)
#undef X
};

static const enum ph_class classes[] = {
#define X(symbol, code, class, meaning) PH_CLASS_##class,
    PH_STATUS(X)
#undef X
};

const char *ph_status_code(enum ph_status status) {
  return codes[status];
}

const char *ph_status_meaning(enum ph_status status) {
  return meanings[status];
}

bool ph_status_is_warning(enum ph_status status) {
  switch (status) {
#define X(symbol, code, class, meaning) case PH_##symbol:
    PH_WARNINGS(X)
#undef X
    return true;
  default:
    return false;
  }
}

enum ph_class ph_status_class(enum ph_status status) {
  return classes[status];
}
