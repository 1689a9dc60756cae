/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How far inside of a curve there is anything (see loop.h). */
#include "curve/offset/loop.h"

#include <math.h>

/* Of the depth; halvings until that is reached, at most. */
static const double NEAR = 1e-7;
enum { HALVINGS_MAX = 80 };

/* Decisions on pairs of arcs, and segments, of all halvings: a few tenths of a
 * second.  Next to the depth of what is round all arcs are near to each other.
 */
enum { EFFORT = 200000 };

/* Whether anything is left at a distance; an offset that is not found is none.
 */
static bool is_left(const struct ph_curve *curve,
                    const struct ph_offset_rules *rules, double distance,
                    struct ph_arena *arena) {
  struct ph_arena scratch = ph_arena_beside(arena);
  struct ph_offset offset = {.distance = distance, .dimension = 2};
  struct ph_diag diag;
  const bool left =
      ph_loops_of(curve, rules, &scratch, &offset, &diag) == PH_OK &&
      offset.loops.n > 0;
  ph_arena_free(&scratch);
  return left;
}

double ph_loops_depth(const struct ph_curve *curve,
                      const struct ph_offset_rules *rules, double distance,
                      struct ph_arena *arena) {
  struct ph_offset_rules plain = *rules;
  const double most = ph_curve_size(curve), side = distance > 0 ? 1 : -1;
  double low = 0, high = fmin(fabs(distance), most);
  size_t effort = EFFORT;
  plain.samples = (struct ph_sample_rules){.how = PH_SAMPLE_NONE};
  plain.effort = &effort;
  if (!curve->closed || rules->crosses || rules->both) {
    return (double)NAN; /* larger distances may leave more */
  }
  for (int i = 0; i < HALVINGS_MAX && high - low > NEAR * low; i++) {
    const double middle = 0.5 * (low + high);
    bool left;
    if (ph_arena_late(arena) || effort <= curve->n) {
      return (double)NAN;
    }
    effort -= curve->n;
    left = is_left(curve, &plain, side * middle, arena);
    low = left ? middle : low;
    high = left ? high : middle;
  }
  return low > 0 ? side * low : (double)NAN;
}
