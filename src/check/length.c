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

/* Half the integral of r x r', with r from the first point; of the curve that
 * was found, also where Bezier curves stand for it. */
static void check_area(struct ph_check *v, double length) {
  const struct ph_check_where where = ph_check_of("area", PH_CHECK_ONE, NULL);
  const double size = v->scale.size;
  /* the square may be subnormal */
  const double least = ph_check_scaled(v, v->scale.spacing);
  double sum = 0, claimed = v->claim->area;
  struct ph_check_segment s;
  ph_vec3 origin;
  if (isnan(claimed)) {
    return;
  }
  if (!v->curve->closed || v->curve->dimension != 2) {
    ph_check_wrong(v, PH_CHECK_LENGTH, where, "is of closed plane curves");
    return;
  }
  ph_check_load(v, 0, &s);
  origin = s.p[0];
  for (size_t k = 0; k < v->curve->n; k++) {
    ph_check_load(v, k, &s);
    for (size_t i = 0; i < v->fixed.n; i++) {
      const double u = v->fixed.node[i];
      ph_vec3 first, r = ph_vec3_sub(ph_check_point(v, &s, u), origin);
      ph_check_jet(&s, u, &first, 1);
      sum += v->fixed.weight[i] / 2 * (r.x * first.y - r.y * first.x);
    }
  }
  claimed = ph_check_scaled(v, ph_check_scaled(v, claimed));
  ph_check_number(v, PH_CHECK_LENGTH, where, claimed, sum, size * size,
                  (v->scale.rounding + ph_check_conversion(v)) * length +
                      least);
}

void ph_check_length(struct ph_check *v, size_t k, double found, double noise) {
  const struct ph_curve *c = v->curve;
  const double doubt = noise + ph_check_conversion(v);
  if (c->lengths) {
    check(v, ph_check_in(k, "length"), c->lengths[k], found,
          doubt + v->allow->miss * v->interval);
  }
  ph_sum_add(&v->found, found);
  v->doubt += doubt;
}

void ph_check_lengths(struct ph_check *v) {
  const struct ph_curve *c = v->curve;
  const double miss = v->allow->miss * v->interval;
  for (size_t k = 0; v->length && k < c->n; k++) {
    ph_check_length(v, k, v->length[k], v->noise[k]);
  }
  check(v,
        v->error ? ph_check_in(c->n - 1, NULL)
                 : ph_check_of("length", PH_CHECK_ONE, NULL),
        c->length, ph_sum_value(&v->found),
        v->doubt + (v->data ? (double)v->data->n : 1) * miss);
  for (size_t i = 0; i < v->intervals_n; i++) {
    check_interval(v, i, ph_check_conversion(v));
  }
  if (!v->error && v->curve == &v->claim->curve) {
    check_area(v, ph_sum_value(&v->found));
  }
}
