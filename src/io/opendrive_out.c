/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Roads of OpenDRIVE (see opendrive_out.h). */
#include "io/opendrive_out.h"

#include "base/sum.h"
#include "curve/segment/tc.h"
#include "io/number.h"

#include <float.h>
#include <math.h>
#include <stdio.h>

void ph_opendrive_header(struct ph_buf *buf) {
  ph_buf_puts(buf, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<OpenDRIVE>\n"
                   "<header revMajor=\"1\" revMinor=\"7\" "
                   "vendor=\"phspline\"/>\n");
}

void ph_opendrive_footer(struct ph_buf *buf) {
  ph_buf_puts(buf, "</OpenDRIVE>\n");
}

static void attribute(struct ph_buf *buf, const char *name, double x) {
  char value[PH_NUMBER_MAX + 1], text[PH_NUMBER_MAX + 16];
  value[ph_number_write(value, x)] = '\0';
  snprintf(text, sizeof text, " %s=\"%s\"", name, value);
  ph_buf_puts(buf, text);
}

/* Segment k, as it is where y points up. */
static struct ph_tc segment(const struct ph_curve *curve, size_t k,
                            bool downward) {
  const double *w = curve->preimage.v + 4 * k;
  const double up = downward ? -1 : 1;
  return (struct ph_tc){
      {ph_cplx_of(w[0], up * w[1]), ph_cplx_of(w[2], up * w[3])}};
}

/* Whether it leaves its chord by no more than rounding. */
static bool is_line(const struct ph_tc_form *f) {
  return f->r > 0 && fabs(f->k) <= 4 * DBL_EPSILON * (f->a + f->b);
}

static void geometry(struct ph_buf *buf, const struct ph_curve *curve, size_t k,
                     bool downward, double s) {
  const double *p = ph_curve_points(curve, k);
  const double up = downward ? -1 : 1;
  const struct ph_tc tc = segment(curve, k, downward);
  const struct ph_tc_form f = ph_tc_form_of(&tc);
  const ph_cplx c =
      ph_cplx_mul(ph_cplx_conj(tc.w[0]), ph_cplx_sub(tc.w[1], tc.w[0]));
  const ph_cplx d = ph_cplx_scale(1 / (3 * f.a), ph_cplx_mul(c, c));
  const bool line = is_line(&f);
  ph_buf_puts(buf, "<geometry");
  attribute(buf, "s", s);
  attribute(buf, "x", p[0]);
  attribute(buf, "y", 0 + up * p[1]);
  attribute(buf, "hdg",
            line ? atan2(up * (p[7] - p[1]), p[6] - p[0])
                 : 2 * atan2(tc.w[0].im, tc.w[0].re));
  attribute(buf, "length", curve->lengths[k]);
  ph_buf_puts(buf, line ? "><line/>" : "><paramPoly3 pRange=\"normalized\"");
  if (!line) {
    attribute(buf, "aU", 0);
    attribute(buf, "bU", f.a);
    attribute(buf, "cU", c.re);
    attribute(buf, "dU", d.re);
    attribute(buf, "aV", 0);
    attribute(buf, "bV", 0);
    attribute(buf, "cV", c.im);
    attribute(buf, "dV", d.im);
    ph_buf_puts(buf, "/>");
  }
  ph_buf_puts(buf, "</geometry>\n");
}

void ph_opendrive_out(struct ph_buf *buf, const struct ph_svg_name *name,
                      size_t number, bool downward,
                      const struct ph_curve *curve) {
  struct ph_sum s = {0, 0};
  char id[32];
  snprintf(id, sizeof id, "\" id=\"%zu\"", number);
  ph_buf_puts(buf, "<road name=\"");
  ph_svg_name_put(buf, name);
  ph_buf_puts(buf, id);
  attribute(buf, "length", curve->length);
  ph_buf_puts(buf, " junction=\"-1\">\n<planView>\n");
  for (size_t k = 0; k < curve->n; k++) {
    geometry(buf, curve, k, downward, ph_sum_value(&s));
    ph_sum_add(&s, curve->lengths[k]);
  }
  ph_buf_puts(buf, "</planView>\n<lanes><laneSection s=\"0\"><center>"
                   "<lane id=\"0\" type=\"none\" level=\"false\"/></center>"
                   "</laneSection></lanes>\n</road>\n");
}
