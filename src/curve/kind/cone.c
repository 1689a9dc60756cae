/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Surfaces of cones: what can be asked of them is in curve/surface. */
#include "curve/kind/kind.h"

const struct ph_kind ph_kind_cone = {.parts = PH_STRIPS_PARTS};
