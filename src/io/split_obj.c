/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Files of OBJ: one record each (see split.h). */
#include "io/split.h"

enum ph_split_state ph_split_obj(struct ph_split *split, bool may_wait,
                                 struct ph_record *record,
                                 struct ph_diag *diag) {
  const size_t most = split->options.most;
  enum ph_split_state state = PH_SPLIT_RECORD;
  size_t n;
  while (state == PH_SPLIT_RECORD) {
    if (most && split->fill - split->start > most && !split->over.on) {
      ph_split_over(split);
    }
    if (split->over.on) {
      ph_split_drop(split, split->fill - split->start);
    }
    state = ph_split_fill(split, may_wait, diag);
  }
  n = split->fill - split->start;
  if (state != PH_SPLIT_END || (n == 0 && !split->over.on)) {
    return state;
  }
  if (split->over.on) {
    ph_split_give_over(split, n, record, diag);
  } else {
    ph_split_give(split, n, n, record);
  }
  record->mesh = true;
  return PH_SPLIT_RECORD;
}
