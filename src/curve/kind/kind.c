/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The table of curve kinds (see kind.h). */
#include "curve/kind/kind.h"

const struct ph_kind *const ph_kinds[PH_CURVE_N] = {
#define X(symbol, kind, name) &ph_kind_##kind,
    PH_CURVES(X)
#undef X
};
