/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Gaps of offsets: joints of the curve where its offset jumps, as the curve has
 * a corner there or, in space, its frame turns.  From one gap to the next the
 * offset is one connected part.
 */
#ifndef PH_CURVE_OFFSET_GAP_H
#define PH_CURVE_OFFSET_GAP_H

#include "base/diag.h"
#include "base/mem.h"
#include "curve/result.h"
#include "curve/segment/seg3.h"

/*
 * ph_gaps_of: the gaps of the offset of a PH or ATPH curve, or of cubics.  On a
 * sphere there are none, as curves there have one tangent at each joint.
 *
 * A joint is a gap where the offset jumps by more than 1e-9 of the size of the
 * curve and the distance together, or by what is not known.
 *
 * in   distance  signed, along the normal
 * in   normal    of a planar curve E2, which is to the left of travel
 * out  gaps      from the arena; the joint of a closed curve is that before
 *                segment 0
 * ret  PH_OK | PH_E_NO_MEMORY
 */
enum ph_status ph_gaps_of(const struct ph_curve *curve, double distance,
                          enum ph_normal normal, struct ph_arena *arena,
                          struct ph_gaps *gaps, struct ph_diag *diag);

/*
 * ph_gaps_pass: whether there is a gap before segment k that no call before has
 * passed.
 *
 * in    k     not less than in the call before
 * inout next  0 at first
 */
static inline bool ph_gaps_pass(const struct ph_gaps *gaps, size_t k,
                                size_t *next) {
  const size_t from = *next;
  while (*next < gaps->n && gaps->before[*next] <= k) {
    ++*next;
  }
  return *next > from;
}

/* ph_gaps_open: whether one is at the joint of a closed curve, whose offset is
 * not closed then. */
static inline bool ph_gaps_open(const struct ph_gaps *gaps) {
  return gaps->n > 0 && gaps->before[0] == 0;
}

#endif
