/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Lengths, against quadrature of |r'|. */
#include "verify/check.h"

#include "base/sum.h"

/* A Bezier curve within e of the curve that it stands for, with its ends and
 * tangents there, may be longer or shorter by the angle that it turns by times
 * e, less than a whole turn. */
static const double TURN = 6.3;

/* How near Bezier curves are, of the size, unless they say it. */
static const double CONVERSION = 1e-9;

double ph_verify_conversion(const struct ph_verify *v) {
  const double *value = v->diagnostics->value;
  double error = ph_verify_known(v, PH_D_CONVERSION_ERROR)
                     ? ph_verify_scaled(v, value[PH_D_CONVERSION_ERROR])
                     : CONVERSION * v->size;
  return v->curve->kind == PH_CURVE_BEZIER ? TURN * error : 0;
}

/* A length that is claimed, in the unit of the record. */
static void check(struct ph_verify *v, struct ph_verify_where where,
                  double claimed, double found, double allowance) {
  double length = ph_verify_unscaled(v, found);
  double unit = ph_verify_unscaled(v, ph_verify_larger(found, v->mean));
  ph_verify_number(v, PH_V_LENGTH, where, claimed, length, unit,
                   ph_verify_unscaled(v, allowance));
}

/* The segments `first' to `last', which are there. */
static void check_interval(struct ph_verify *v, size_t i, double each) {
  const struct ph_interval *interval = &v->intervals[i];
  struct ph_sum sum = {0, 0};
  double allowance = 0;
  struct ph_verify_where where = ph_verify_of("intervals", i, "length");
  if (interval->first > interval->last || interval->last >= v->curve->n) {
    ph_verify_wrong(v, PH_V_SHAPE, ph_verify_of("intervals", i, "segments"),
                    "are not there");
    return;
  }
  for (size_t k = interval->first; k <= interval->last; k++) {
    ph_sum_add(&sum, v->length[k]);
    allowance += v->noise[k] + each;
  }
  check(v, where, interval->length, ph_sum_value(&sum), allowance);
}

void ph_verify_lengths(struct ph_verify *v) {
  const struct ph_curve *c = v->curve;
  struct ph_sum sum = {0, 0};
  double allowance = 0, each = ph_verify_conversion(v);
  for (size_t k = 0; k < c->n; k++) {
    if (c->lengths) {
      check(v, ph_verify_in(k, "length"), c->lengths[k], v->length[k],
            v->noise[k] + each);
    }
    ph_sum_add(&sum, v->length[k]);
    allowance += v->noise[k] + each;
  }
  check(v, ph_verify_of("length", PH_VERIFY_ONE, NULL), c->length,
        ph_sum_value(&sum), allowance);
  for (size_t i = 0; i < v->intervals_n; i++) {
    check_interval(v, i, each);
  }
}
