/* SPDX-License-Identifier: GPL-3.0-or-later */
/* C1 Hermite interpolation by a pair of Tschirnhausen cubics [BYR11, thm 17],
 * see tc_pair.h. */
#include "solve/tc/pair.h"

/* The preimages of both derivatives, and w0^2 + w2^2 - 3. */
struct ends {
  ph_cplx w0, w2, c;
};

static struct ends ends_of(const struct ph_tc_hermite *h) {
  struct ends e = {
      ph_cplx_sqrt(h->t[0]), ph_cplx_sqrt(h->t[1]),
      ph_cplx_of(h->t[0].re + h->t[1].re - 3, h->t[0].im + h->t[1].im)};
  return e;
}

/*
 * The joints z[0] of +rho and z[1] of -rho.  The larger does not cancel; the
 * other follows from z[0] z[1] = c/2.
 */
static void joints_of(const struct ends *e, ph_cplx z[2]) {
  ph_cplx s = ph_cplx_add(e->w0, e->w2);
  ph_cplx rho =
      ph_cplx_sqrt(ph_cplx_sub(ph_cplx_mul(s, s), ph_cplx_scale(8, e->c)));
  double sign = ph_cplx_dot(s, rho) >= 0 ? 1 : -1;
  ph_cplx large =
      ph_cplx_scale(-0.25, ph_cplx_add(s, ph_cplx_scale(sign, rho)));
  double norm2 = ph_cplx_norm2(large);
  ph_cplx small = ph_cplx_scale(norm2 > 0 ? 0.5 / norm2 : 0,
                                ph_cplx_mul(e->c, ph_cplx_conj(large)));
  z[0] = sign > 0 ? small : large;
  z[1] = sign > 0 ? large : small;
}

static void set_pair(const struct ends *e, ph_cplx z, enum ph_root root,
                     struct ph_tc_fit *fit) {
  *fit = ph_tc_fit_of(2, root);
  fit->tc[0] = (struct ph_tc){{e->w0, z}};
  fit->tc[1] = (struct ph_tc){{z, e->w2}};
}

void ph_tc_pairs(const struct ph_tc_hermite *h,
                 struct ph_tc_fit fits[PH_TC_PAIRS]) {
  struct ends e = ends_of(h);
  ph_cplx z[2];
  joints_of(&e, z);
  set_pair(&e, z[0], PH_ROOT_PLUS_PLUS, &fits[0]);
  set_pair(&e, z[1], PH_ROOT_PLUS_MINUS, &fits[1]);
  e.w2 = ph_cplx_scale(-1, e.w2);
  joints_of(&e, z);
  set_pair(&e, z[0], PH_ROOT_MINUS_PLUS, &fits[2]);
  set_pair(&e, z[1], PH_ROOT_MINUS_MINUS, &fits[3]);
}

bool ph_tc_pair_is_safe(const struct ph_tc_hermite *h) {
  const double low = PH_TC_PAIR_SHORTEST, high = PH_TC_PAIR_LONGEST;
  for (size_t i = 0; i < 2; i++) {
    double norm2 = ph_cplx_norm2(h->t[i]);
    if (!(h->t[i].re >= 0 && norm2 >= low * low && norm2 <= high * high)) {
      return false;
    }
  }
  return true;
}

bool ph_tc_pair_standard(const struct ph_tc_hermite *h, struct ph_tc_fit *fit) {
  struct ends e;
  ph_cplx z[2];
  if (ph_tc_is_backward(h->t[0]) || ph_tc_is_backward(h->t[1])) {
    return false;
  }
  e = ends_of(h);
  joints_of(&e, z);
  set_pair(&e, z[0], PH_ROOT_PLUS_PLUS, fit);
  return true;
}

bool ph_tc_pair_best(const struct ph_tc_hermite *h, struct ph_tc_fit *fit) {
  struct ph_tc_fit fits[PH_TC_PAIRS], *best;
  if (ph_tc_pair_is_safe(h) && ph_tc_pair_standard(h, fit)) {
    ph_tc_fit_measure(fit);
    fit->simple = fit->regular && fit->loops == 0;
    if (fit->simple) {
      return true;
    }
  }
  ph_tc_pairs(h, fits);
  for (size_t i = 0; i < PH_TC_PAIRS; i++) {
    ph_tc_fit_measure(&fits[i]);
  }
  best = ph_tc_fit_best(fits, PH_TC_PAIRS);
  if (best == NULL) {
    return false;
  }
  *fit = *best;
  return true;
}
