/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SVG paths (see svg_out.h). */
#include "io/svg_out.h"

#include "io/number.h"

/* x,y after what separates it from what comes before. */
static void point(struct ph_buf *buf, char before, const double *p) {
  char *to = ph_buf_reserve(buf, 2 * PH_NUMBER_MAX + 2);
  if (to) {
    char *at = to;
    *at++ = before;
    at += ph_number_write(at, p[0]);
    *at++ = ',';
    at += ph_number_write(at, p[1]);
    buf->n += (size_t)(at - to);
  }
}

/* Whether two points are the same to the last bit. */
static bool same(const double *a, const double *b) {
  return !(a[0] < b[0]) && !(a[0] > b[0]) && !(a[1] < b[1]) && !(a[1] > b[1]);
}

void ph_svg_path(struct ph_buf *buf, const struct ph_pieces *cubics,
                 bool closed) {
  const double *p = cubics->control_points, *first = p;
  for (size_t i = 0; i < cubics->n; i++, p += 8) {
    if (i == 0 || !same(p - 2, p)) {
      first = p;
      point(buf, 'M', p);
    }
    point(buf, 'C', p + 2);
    point(buf, ' ', p + 4);
    point(buf, ' ', p + 6);
    if (closed && same(p + 6, first) &&
        (i + 1 == cubics->n || !same(p + 6, p + 8))) {
      ph_buf_put(buf, "Z", 1);
    }
  }
}
