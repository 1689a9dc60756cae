/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Lengths, against quadrature of |r'|. */
#include "check/checks.h"

#include "base/sum.h"
#include "check/data.h"

/* A Bezier curve within e of the curve that it stands for, with its ends and
 * tangents there, may be longer or shorter by the angle that it turns by times
 * e, less than a whole turn. */
static const double TURN = 6.3;

/* How near Bezier curves are, of the size, unless they say it. */
static const double CONVERSION = 1e-9;

double ph_check_conversion(const struct ph_check *v) {
  const double *value = v->diagnostics->value;
  double error = ph_check_known(v, PH_D_CONVERSION_ERROR)
                     ? ph_check_scaled(v, value[PH_D_CONVERSION_ERROR])
                     : CONVERSION * v->scale.size;
  return v->kind->converted ? TURN * error : 0;
}

/* A length that is claimed, in the unit of the record. */
static void check(struct ph_check *v, struct ph_check_where where,
                  double claimed, double found, double allowance) {
  double unit = ph_check_unit(v->unit_length, found, v->mean);
  if (v->error) {
    ph_check_miss(v, PH_CHECK_LENGTH, where,
                  fabs(found - ph_check_scaled(v, claimed)), unit,
                  v->allow->length * found + allowance, NULL);
  } else {
    ph_check_number(v, PH_CHECK_LENGTH, where, claimed,
                    ph_check_unscaled(v, found), ph_check_unscaled(v, unit),
                    ph_check_unscaled(v, allowance));
  }
}

/* The segments `first' to `last', which are there. */
static void check_interval(struct ph_check *v, size_t i, double each) {
  const struct ph_interval *interval = &v->intervals[i];
  struct ph_sum sum = {0, 0};
  double allowance = 0;
  struct ph_check_where where = ph_check_of("intervals", i, "length");
  if (interval->first > interval->last || interval->last >= v->curve->n) {
    ph_check_wrong(v, PH_CHECK_SHAPE, ph_check_of("intervals", i, "segments"),
                   "are not there");
    return;
  }
  for (size_t k = interval->first; k <= interval->last; k++) {
    ph_sum_add(&sum, v->length[k]);
    allowance += v->noise[k] + each;
  }
  check(v, where, interval->length, ph_sum_value(&sum), allowance);
}

void ph_check_lengths(struct ph_check *v) {
  const struct ph_curve *c = v->curve;
  struct ph_sum sum = {0, 0};
  double allowance = 0, each = ph_check_conversion(v);
  double miss = v->allow->miss * v->interval;
  for (size_t k = 0; k < c->n; k++) {
    if (c->lengths) {
      check(v, ph_check_in(k, "length"), c->lengths[k], v->length[k],
            v->noise[k] + each + miss);
    }
    ph_sum_add(&sum, v->length[k]);
    allowance += v->noise[k] + each;
  }
  check(v,
        v->error ? ph_check_in(c->n - 1, NULL)
                 : ph_check_of("length", PH_CHECK_ONE, NULL),
        c->length, ph_sum_value(&sum),
        allowance + (v->data ? (double)v->data->n : 1) * miss);
  for (size_t i = 0; i < v->intervals_n; i++) {
    check_interval(v, i, each);
  }
}
