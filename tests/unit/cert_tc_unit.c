/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Tests of the certificate of Tschirnhausen cubics (see cert_tc_unit.h). */
#include "cert_tc_unit.h"
#include "unit.h"

struct unit_cert_tc unit_tc;

void unit_cert_begin(void) {
  memset(&unit_tc, 0, sizeof unit_tc);
  memset(&checked, 0, sizeof checked);
  checked.command = "tc";
  checked.problem = &unit_tc.problem;
  checked.curve = &unit_tc.c.curve;
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
