/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Tests of the certificate of Tschirnhausen cubics (see cert_tc_unit.h). */
#include "cert_tc_unit.h"
#include "unit.h"

#include <stdio.h>
#include <string.h>

struct unit_cert_tc unit_tc;

void unit_cert_begin(void) {
  unit_cert_finish();
  memset(&unit_tc, 0, sizeof unit_tc);
}

void unit_cert_finish(void) {
  ph_arena_free(&unit_tc.scratch);
}

struct ph_value unit_word(const char *word) {
  return (struct ph_value){.kind = PH_WORD, .word = word};
}

struct ph_value unit_number(double x) {
  return (struct ph_value){.kind = PH_NUMBER, .number = x};
}

struct ph_value unit_vectors(double *v, size_t n) {
  return (struct ph_value){.kind = PH_VECTORS, .v = v, .n = n, .dimension = 2};
}

enum ph_status unit_certify(void) {
  unit_tc.diagnostics = unit_tc.claims;
  memset(&unit_tc.diag, 0, sizeof unit_tc.diag);
  return ph_certify_tc(&unit_tc.problem, &unit_tc.c.curve, &unit_tc.scratch,
                       &unit_tc.diagnostics, &unit_tc.diag);
}

double unit_said(enum ph_diagnostic what) {
  ck_assert_msg(unit_is_known(what), "%s is unknown", ph_diagnostic_name(what));
  return unit_tc.diagnostics.value[what];
}

bool unit_is_known(enum ph_diagnostic what) {
  return unit_tc.diagnostics.known >> what & 1;
}

void ck_accepted(void) {
  enum ph_status status = unit_certify();
  ck_assert_msg(status == PH_OK, "%s %s", unit_tc.diag.field,
                unit_tc.diag.message);
}

void ck_refused_somewhere(enum ph_diagnostic what) {
  char text[PH_DIAG_MESSAGE_MAX];
  ck_assert_int_eq(unit_certify(), PH_NO_CONVERGENCE);
  snprintf(text, sizeof text, "is refused by its certificate: %s is ",
           ph_diagnostic_name(what));
  ck_assert_msg(strncmp(unit_tc.diag.message, text, strlen(text)) == 0,
                "%s instead of %s", unit_tc.diag.message,
                ph_diagnostic_name(what));
}

void ck_refused(enum ph_diagnostic what, size_t segment) {
  char name[32];
  ck_refused_somewhere(what);
  snprintf(name, sizeof name, "segments[%zu]", segment);
  ck_assert_str_eq(unit_tc.diag.field, name);
}

void unit_add_pair(ph_cplx a, ph_cplx b, ph_cplx along, const double *end) {
  ph_cplx root = ph_cplx_sqrt(along);
  ph_cplx w0 = ph_cplx_sqrt(ph_cplx_mul(a, ph_cplx_inverse(along)));
  ph_cplx w2 = ph_cplx_sqrt(ph_cplx_mul(b, ph_cplx_inverse(along)));
  ph_cplx sum = ph_cplx_add(w0, w2), z;
  ph_cplx squares = ph_cplx_add(ph_cplx_mul(w0, w0), ph_cplx_mul(w2, w2));
  z = ph_cplx_sub(ph_cplx_mul(sum, sum),
                  ph_cplx_scale(8, ph_cplx_sub(squares, ph_cplx_of(3, 0))));
  z = ph_cplx_scale(0.25, ph_cplx_sub(ph_cplx_sqrt(z), sum));
  w0 = ph_cplx_mul(root, w0);
  w2 = ph_cplx_mul(root, w2);
  z = ph_cplx_mul(root, z);
  unit_cubics_add(&unit_tc.c, w0, z);
  unit_cubics_add(&unit_tc.c, z, w2);
  memcpy(unit_tc.c.control_points + 8 * unit_tc.c.curve.n - 2, end,
         2 * sizeof(double));
  unit_tc.c.at = unit_get(end);
}
