/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Certificates and their verdicts (see check_unit.h). */
#include "check_unit.h"
#include "unit.h"

#include "cli/command.h"

struct unit_checked checked;

enum ph_status certify(void) {
  const struct ph_command *command = ph_command_find(checked.command);
  enum ph_status status;
  checked.diagnostics = checked.claims;
  memset(&checked.diag, 0, sizeof checked.diag);
  status = ph_certify(checked.command, checked.problem, checked.curve,
                      &unit_arena, &checked.diagnostics, &checked.diag);
  return status == PH_OK && command->describe
             ? command->describe(checked.curve, &unit_arena,
                                 &checked.diagnostics, &checked.diag)
             : status;
}

bool is_known(enum ph_diagnostic what) {
  return checked.diagnostics.known >> what & 1;
}

double value_of(enum ph_diagnostic what) {
  ck_assert_msg(is_known(what), "%s is unknown", ph_diagnostic_name(what));
  return checked.diagnostics.value[what];
}

void ck_accepted(void) {
  enum ph_status status = certify();
  ck_assert_msg(status == PH_OK, "%s %s", checked.diag.field,
                checked.diag.message);
}

void ck_refused_somewhere(enum ph_diagnostic what) {
  char text[PH_DIAG_MESSAGE_MAX];
  ck_assert_int_eq(certify(), PH_E_NO_CONVERGENCE);
  snprintf(text, sizeof text, "is refused by its certificate: %s is ",
           ph_diagnostic_name(what));
  ck_assert_msg(strncmp(checked.diag.message, text, strlen(text)) == 0,
                "%s %s, not %s", checked.diag.field, checked.diag.message,
                ph_diagnostic_name(what));
}

void ck_refused_in(enum ph_diagnostic what, size_t a, size_t b) {
  char name[2][32];
  ck_refused_somewhere(what);
  snprintf(name[0], sizeof name[0], "segments[%zu]", a);
  snprintf(name[1], sizeof name[1], "segments[%zu]", b);
  ck_assert_msg(strcmp(checked.diag.field, name[0]) == 0 ||
                    strcmp(checked.diag.field, name[1]) == 0,
                "%s, not %s or %s", checked.diag.field, name[0], name[1]);
}

void ck_refused(enum ph_diagnostic what, size_t segment) {
  ck_refused_in(what, segment, segment);
}

void ck_each_moved(double *x, size_t n, size_t per, double by,
                   enum ph_diagnostic what) {
  for (size_t i = 0; i < n; i++) {
    double keep = x[i];
    x[i] += by;
    ck_refused(what, i / per);
    x[i] = keep;
  }
  ck_accepted();
}

void ck_each_scaled(double *x, size_t n, double by, enum ph_diagnostic what) {
  for (size_t i = 0; i < n; i++) {
    double keep = x[i];
    x[i] *= 1 + by;
    ck_refused(what, i);
    x[i] = keep;
  }
  ck_accepted();
}

void ck_refused_for(const char *words) {
  ck_assert_int_eq(certify(), PH_E_NO_CONVERGENCE);
  ck_assert_msg(strstr(checked.diag.message, words) != NULL, "%s",
                checked.diag.message);
}

void ck_not_finite(double *x, size_t n) {
  const double bad[] = {(double)NAN, HUGE_VAL, -HUGE_VAL};
  for (size_t i = 0; i < COUNT(bad) * n; i++) {
    double keep = x[i / COUNT(bad)];
    x[i / COUNT(bad)] = bad[i % COUNT(bad)];
    ck_assert_int_eq(certify(), PH_E_TOO_LARGE);
    ck_assert_str_eq(checked.diag.message,
                     "the curve exceeds the range of a double");
    ck_assert_str_eq(checked.diag.field, "");
    x[i / COUNT(bad)] = keep;
  }
}
