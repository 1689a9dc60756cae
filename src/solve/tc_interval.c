/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Solutions of one interval by the mode of the problem (see tc_interval.h). */
#include "solve/tc_interval.h"

#include "kernel/pi.h"
#include "solve/tc_g1.h"
#include "solve/tc_two.h"

#include <math.h>

static double angle_of(ph_cplx t) {
  return atan2(t.im, t.re);
}

/* ---- why there is none -------------------------------------------------- */

/* From this angle on at one end, the other must not be 0 [BYR11, table 4.1]. */
static const double NOT_ZERO = 2 * PH_PI / 3;

/* What to say of a range that reaches beyond the angles of directions. */
static const char *modulo(const double range[2]) {
  return range[0] < -PH_PI || range[1] > PH_PI ? " modulo 2 pi" : "";
}

static enum ph_status fail_g1(size_t k, const struct ph_tc_hermite *h, size_t n,
                              struct ph_diag *diag) {
  double a = angle_of(h->t[0]), b = angle_of(h->t[1]), range[2];
  if (n > 0) {
    return ph_fail_at(diag, PH_INFEASIBLE, "segments", k,
                      "a Tschirnhausen cubic with angles %.6g and %.6g to the "
                      "chord has a cusp; \"mode\":\"g1-pair\" has a curve of "
                      "two",
                      a, b);
  }
  ph_tc_g1_range(a, range);
  return ph_fail_at(
      diag, PH_INFEASIBLE, "segments", k,
      "no Tschirnhausen cubic has angles %.6g and %.6g to the chord: for the "
      "first, the second must be between %.6g and %.6g%s%s; "
      "\"mode\":\"g1-pair\" has a curve of two",
      a, b, range[0], range[1], modulo(range),
      fabs(a) >= NOT_ZERO ? ", and not 0" : "");
}

static enum ph_status fail_chord(const struct ph_tc_data *d, size_t k,
                                 const struct ph_tc_hermite *h,
                                 struct ph_diag *diag) {
  double range[2][2];
  for (size_t i = 0; i < 2; i++) {
    ph_tc_g1_range(angle_of(h->t[i]), range[i]);
  }
  return isnan(d->joint_angle)
             ? ph_fail_at(diag, PH_INFEASIBLE, "segments", k,
                          "no two cubics meet on the chord without a cusp; "
                          "\"joint\":\"free\" has a curve of two")
             : ph_fail_at(diag, PH_INFEASIBLE, "segments", k,
                          "no two cubics meet on the chord at the angle %.6g: "
                          "it must be between %.6g and %.6g%s and between "
                          "%.6g and %.6g%s, and not 0",
                          d->joint_angle, range[0][0], range[0][1],
                          modulo(range[0]), range[1][0], range[1][1],
                          modulo(range[1]));
}

static enum ph_status fail_pair(const struct ph_tc_data *d, size_t k,
                                struct ph_diag *diag) {
  return ph_fail_at(diag, PH_INFEASIBLE, "segments", k,
                    d->choice == PH_TC_STANDARD
                        ? "the standard pair has a cusp; \"solutions\":"
                          "\"best\" may have none"
                        : "all four pairs of cubics have a cusp with these "
                          "derivatives; other lengths of them do not");
}

/* ---- one ---------------------------------------------------------------- */

static enum ph_status g1(size_t k, const struct ph_tc_hermite *h,
                         struct ph_tc_fit *fit, struct ph_diag *diag) {
  struct ph_tc_fit fits[2];
  size_t n = ph_tc_g1(h, fits);
  if (n == 0 || !fits[0].regular) {
    return fail_g1(k, h, n, diag);
  }
  *fit = fits[0];
  return PH_OK;
}

/* Derivatives at both ends are given. */
static enum ph_status pair(const struct ph_tc_data *d, size_t k,
                           const struct ph_tc_hermite *h, struct ph_tc_fit *fit,
                           struct ph_diag *diag) {
  if (d->choice == PH_TC_STANDARD && ph_tc_pair_standard(h, fit)) {
    ph_tc_fit_measure(fit);
    fit->simple = ph_tc_pair_is_safe(h) || ph_tc_fit_test(fit);
    return fit->regular ? PH_OK : fail_pair(d, k, diag);
  }
  return ph_tc_pair_best(h, fit) ? PH_OK : fail_pair(d, k, diag);
}

/* Tangents alone are given. */
static enum ph_status two(const struct ph_tc_data *d, size_t k,
                          const struct ph_tc_hermite *h, struct ph_tc_fit *fit,
                          struct ph_diag *diag) {
  if (d->on_chord) {
    return ph_tc_two_chord(h, d->joint_angle, d->joint_position, fit)
               ? PH_OK
               : fail_chord(d, k, h, diag);
  }
  if (d->choice == PH_TC_STANDARD) {
    const struct ph_tc_hermite longer = ph_tc_hermite_scaled(h, PH_TC_LAMBDA);
    enum ph_status status = pair(d, k, &longer, fit, diag);
    fit->lambda = PH_TC_LAMBDA;
    return status;
  }
  return ph_tc_two_free(h, fit)
             ? PH_OK
             : ph_fail_at(diag, PH_NO_CONVERGENCE, "segments", k,
                          "no pair of cubics without a crossing was found");
}

static enum ph_status g1_pair(const struct ph_tc_data *d, size_t k,
                              const struct ph_tc_hermite *h,
                              struct ph_tc_fit *fit, struct ph_diag *diag) {
  return d->c1 ? pair(d, k, h, fit, diag) : two(d, k, h, fit, diag);
}

/* The data as unit tangents. */
static struct ph_tc_hermite tangents_of(const struct ph_tc_hermite *h) {
  struct ph_tc_hermite unit;
  for (size_t i = 0; i < 2; i++) {
    unit.t[i] = ph_cplx_scale(1 / ph_cplx_abs(h->t[i]), h->t[i]);
  }
  return unit;
}

/* Whether an interval of a mode that has the choice gets one cubic. */
static bool takes_one(const struct ph_tc_data *d, size_t k,
                      const struct ph_tc_hermite *h, struct ph_tc_fit *one) {
  const struct ph_tc_hermite unit = tangents_of(h);
  struct ph_tc_fit fits[2], other;
  struct ph_diag none;
  if (ph_tc_g1(&unit, fits) == 0 || !fits[0].regular || fits[0].loops > 0) {
    return false;
  }
  *one = fits[0];
  return d->mode == PH_TC_G1_AUTO || g1_pair(d, k, h, &other, &none) != PH_OK ||
         one->energy * one->length <= other.energy * other.length;
}

enum ph_status ph_tc_interval(const struct ph_tc_data *d, size_t k,
                              struct ph_tc_fit *fit, struct ph_diag *diag) {
  const struct ph_tc_hermite h = ph_tc_hermite_of(d, k);
  switch (d->mode) {
  case PH_TC_G1:
    return g1(k, &h, fit, diag);
  case PH_TC_G1_AUTO:
  case PH_TC_G1_FAIR:
    return takes_one(d, k, &h, fit) ? PH_OK : g1_pair(d, k, &h, fit, diag);
  case PH_TC_G1_PAIR:
    return g1_pair(d, k, &h, fit, diag);
  default:
    return pair(d, k, &h, fit, diag);
  }
}

/* ---- all ---------------------------------------------------------------- */

static enum ph_status all_g1(size_t k, const struct ph_tc_hermite *h,
                             struct ph_tc_fit fits[PH_TC_FITS_MAX], size_t *n,
                             struct ph_diag *diag) {
  *n = ph_tc_g1(h, fits);
  return *n > 0 && fits[0].regular ? PH_OK : fail_g1(k, h, *n, diag);
}

static enum ph_status all_pairs(const struct ph_tc_data *d, size_t k,
                                const struct ph_tc_hermite *h, double lambda,
                                struct ph_tc_fit fits[PH_TC_FITS_MAX],
                                size_t *n, struct ph_diag *diag) {
  ph_tc_pairs(h, fits);
  for (size_t i = 0; i < PH_TC_PAIRS; i++) {
    ph_tc_fit_measure(&fits[i]);
    fits[i].lambda = lambda;
  }
  ph_tc_fit_order(fits, PH_TC_PAIRS);
  *n = PH_TC_PAIRS;
  return fits[0].regular ? PH_OK : fail_pair(d, k, diag);
}

enum ph_status ph_tc_interval_all(const struct ph_tc_data *d, size_t k,
                                  struct ph_tc_fit fits[PH_TC_FITS_MAX],
                                  size_t *n, struct ph_diag *diag) {
  const struct ph_tc_hermite h = ph_tc_hermite_of(d, k);
  bool g1 = d->mode <= PH_TC_G1_FAIR;
  enum ph_status status;
  if (d->mode == PH_TC_G1) {
    return all_g1(k, &h, fits, n, diag);
  }
  if (g1 && d->mode != PH_TC_G1_PAIR && takes_one(d, k, &h, fits)) {
    const struct ph_tc_hermite unit = tangents_of(&h);
    return all_g1(k, &unit, fits, n, diag);
  }
  if (d->c1) {
    return all_pairs(d, k, &h, (double)NAN, fits, n, diag);
  }
  *n = 1;
  status = two(d, k, &h, fits, diag);
  if (status == PH_OK && !d->on_chord) {
    double lambda = fits[0].lambda;
    const struct ph_tc_hermite longer = ph_tc_hermite_scaled(&h, lambda);
    return all_pairs(d, k, &longer, lambda, fits, n, diag);
  }
  return status;
}
