/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Certificates in parts (see share.h). */
#include "check/share.h"

#include "base/team.h"

/* What is found in a part. */
struct part {
  struct ph_check_error error[PH_CHECK_N];
  enum ph_status status;
  struct ph_diag diag;
  int fault; /* as in struct ph_check */
  size_t fault_at;
  struct ph_sum found; /* ... */
  double doubt;
};

struct share {
  const struct ph_check *v;
  size_t size; /* of a part */
  void (*check)(const void *, struct ph_check *, size_t, size_t);
  const void *context;
  struct part *part;
};

static bool check_part(void *context, size_t thread, size_t first, size_t end) {
  const struct share *share = context;
  struct part *part = &share->part[first / share->size];
  struct ph_check v = *share->v;
  (void)thread;
  *part = (struct part){.status = PH_OK};
  v.error = part->error;
  v.diag = &part->diag;
  v.status = PH_OK;
  v.fault = 0;
  v.found = (struct ph_sum){0, 0};
  v.doubt = 0;
  share->check(share->context, &v, first, end);
  part->status = v.status;
  part->fault = v.fault;
  part->fault_at = v.fault_at;
  part->found = v.found;
  part->doubt = v.doubt;
  return !ph_arena_late(v.scratch);
}

static void join(struct ph_check *v, const struct part *part) {
  for (size_t k = 0; k < PH_CHECK_N; k++) {
    ph_check_join(&v->error[k], &part->error[k]);
  }
  ph_sum_join(&v->found, &part->found);
  v->doubt += part->doubt;
  if (part->status != PH_OK) {
    v->status = part->status;
    *v->diag = part->diag;
  }
  if (!v->fault) {
    v->fault = part->fault;
    v->fault_at = part->fault_at;
  }
}

void ph_check_share(struct ph_check *v, size_t n, size_t part,
                    void (*check)(const void *context, struct ph_check *v,
                                  size_t first, size_t end),
                    const void *context) {
  const size_t parts_n = (n + part - 1) / part;
  struct share share = {v, part, check, context, NULL};
  struct ph_mark mark = ph_arena_mark(v->scratch);
  if (!v->error || parts_n < 2) {
    check(context, v, 0, n);
    return;
  }
  share.part = ph_arena_array(v->scratch, parts_n, sizeof *share.part);
  if (!share.part) {
    v->status = ph_fail_memory(v->diag);
    return;
  }
  ph_team_share(v->scratch, n, 2 * part, part, check_part, &share);
  for (size_t i = 0; i < parts_n && !ph_arena_late(v->scratch); i++) {
    join(v, &share.part[i]);
  }
  ph_arena_release(v->scratch, mark);
}
