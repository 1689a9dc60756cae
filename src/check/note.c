/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The worst error of each check (see note.h). */
#include "check/note.h"

#include <string.h>

const char *ph_check_name(enum ph_check_id check) {
  static const char *const names[] = {
#define X(symbol, name) [PH_CHECK_##symbol] = name,
      PH_CHECKS(X)
#undef X
  };
  return names[check];
}

/* The path of a field, made as a message is, which is where text is made. */
static void set_field(const struct ph_check *v, struct ph_check_where where,
                      struct ph_diag *diag) {
  struct ph_diag path;
  const bool strips =
      v->promise->parts && where.list && strcmp(where.list, "segments") == 0;
  const char *list = strips ? "strips" : where.list ? where.list : "";
  const char *member = where.member ? where.member : "";
  const char *dot = where.list && where.member ? "." : "";
  if (where.list && where.index != PH_CHECK_ONE) {
    ph_fail(&path, PH_OK, NULL, "%s%s[%zu]%s%s", v->prefix, list, where.index,
            dot, member);
  } else {
    ph_fail(&path, PH_OK, NULL, "%s%s%s%s", v->prefix, list, dot, member);
  }
  path.message[PH_DIAG_FIELD_MAX - 1] = '\0';
  memcpy(diag->field, path.message, PH_DIAG_FIELD_MAX);
}

void ph_check_put(struct ph_check *v, enum ph_check_id check, double error,
                  struct ph_check_where where, const char *what, double claimed,
                  double found) {
  struct ph_check_finding *worst = &v->verdict->check[check];
  if (what) {
    ph_fail(&worst->where, PH_OK, NULL, "%s by %.3g", what, error);
  } else {
    ph_fail(&worst->where, PH_OK, NULL, "is %.17g, found %.17g", claimed,
            found);
  }
  set_field(v, where, &worst->where);
  worst->done = true;
  worst->error = error;
}

void ph_check_wrong(struct ph_check *v, enum ph_check_id check,
                    struct ph_check_where where, const char *what) {
  struct ph_check_finding *worst;
  if (v->error) {
    v->status = ph_fail(v->diag, PH_E_INTERNAL, where.list, "%s", what);
    return;
  }
  worst = &v->verdict->check[check];
  if (!worst->done || worst->error < HUGE_VAL) {
    ph_fail(&worst->where, PH_OK, NULL, "%s", what);
    set_field(v, where, &worst->where);
    worst->done = true;
    worst->error = HUGE_VAL;
  }
}

void ph_check_done(struct ph_check *v, enum ph_check_id check) {
  *(v->error ? &v->error[check].done : &v->verdict->check[check].done) = true;
}

void ph_check_prefix(struct ph_check *v, const char *list, size_t index) {
  struct ph_diag path;
  path.message[0] = '\0';
  if (list) {
    ph_fail(&path, PH_OK, NULL, "%s[%zu].", list, index);
  }
  path.message[PH_CHECK_PREFIX - 1] = '\0';
  memcpy(v->prefix, path.message, PH_CHECK_PREFIX);
}
