/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Parts of arcs between places where they meet others: cut, judged (part.c) and
 * linked (outline.c).
 */
#ifndef PH_CURVE_OFFSET_PART_H
#define PH_CURVE_OFFSET_PART_H

#include "curve/offset/crossing.h"
#include "curve/offset/outline.h"

struct ph_part {
  size_t arc;
  struct ph_span of;
  size_t next;     /* that begins where it ends, or none */
  bool cut, begun; /* there, and where it begins, other arcs meet it */
  bool kept;
  bool follows; /* one leads to it; of those that are kept, once it is known */
};

struct ph_part_list {
  struct ph_part *v;
  size_t n;
};

/* ph_parts_cut: the parts of all arcs that are not passive.
 * ret PH_OK | PH_E_NO_MEMORY */
enum ph_status ph_parts_cut(const struct ph_strands *strands,
                            const struct ph_arcs *arcs,
                            const struct ph_crossings *crossings,
                            struct ph_part_list *parts, struct ph_diag *diag);

/*
 * ph_parts_judge: which parts keep the distance; of parts that run on others,
 * which are kept.
 *
 * in   keep  those that run on others in the opposite direction are, once
 * ret  PH_OK | PH_E_NO_CONVERGENCE (places of a part disagree) |
 *      PH_E_NO_MEMORY
 */
enum ph_status ph_parts_judge(const struct ph_strands *strands,
                              const struct ph_arcs *arcs,
                              const struct ph_crossings *crossings, bool keep,
                              struct ph_part_list *parts, struct ph_diag *diag);

/* ph_strands_fail: a failure that names a place of the offset. */
enum ph_status ph_strands_fail(const struct ph_strands *strands, ph_cplx at,
                               const char *what, struct ph_diag *diag);

#endif
