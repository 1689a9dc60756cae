/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Distances at which offsets are regular (see range.h). */
#include "curve/offset/range.h"

#include "curve/offset/cusp.h"
#include "kernel/form.h"

#include <math.h>

/* Halvings until a part is a point; there its bound is taken. */
enum { HALVINGS_MAX = 50, N = PH_CUSP_DEGREE };

/* By which a bound may exceed what is attained. */
static const double NEAR = 1e-13;

/* The curvatures that are attained, at least 0 and at most 0; of `visit`, times
 * 2^exponent of the segment. */
struct bends {
  double most, least;
};

static void see(struct bends *b, double bend, double square) {
  const double kappa = bend / square;
  if (square > 0) {
    b->most = kappa > b->most ? kappa : b->most;
    b->least = kappa < b->least ? kappa : b->least;
  }
}

static struct bends bound_of(const struct ph_cusp_forms *f) {
  struct bends b = {-HUGE_VAL, HUGE_VAL};
  for (size_t k = 0; k <= N; k++) {
    if (!(f->square[k] > 0)) {
      return (struct bends){HUGE_VAL, -HUGE_VAL};
    }
    see(&b, f->bend[k], f->square[k]);
  }
  return b;
}

static void visit(struct bends *found, const struct ph_cusp_forms *f,
                  int depth) {
  const struct bends bound = bound_of(f);
  struct ph_cusp_forms half[2];
  see(found, f->bend[0], f->square[0]);
  see(found, f->bend[N], f->square[N]);
  if (bound.most <= found->most * (1 + NEAR) &&
      bound.least >= found->least * (1 + NEAR)) {
    return;
  }
  if (depth == HALVINGS_MAX) {
    found->most = fmax(found->most, bound.most);
    found->least = fmin(found->least, bound.least);
    return;
  }
  ph_form_halve(f->bend, N, half[0].bend, half[1].bend);
  ph_form_halve(f->square, N, half[0].square, half[1].square);
  visit(found, &half[0], depth + 1);
  visit(found, &half[1], depth + 1);
}

void ph_offset_range(const struct ph_curve *curve, double range[2]) {
  struct bends all = {0, 0};
  for (size_t k = 0; k < curve->n; k++) {
    const struct ph_seg3 seg = ph_seg3_of(curve, k);
    struct ph_cusp_forms f;
    struct bends here;
    ph_cusp_forms_of(&seg, PH_E2, &f);
    here.most = ldexp(all.most, f.exponent);
    here.least = ldexp(all.least, f.exponent);
    visit(&here, &f, 0);
    all.most = ldexp(here.most, -f.exponent);
    all.least = ldexp(here.least, -f.exponent);
  }
  range[0] = all.most > 0 ? 1 / (all.most * (1 + NEAR)) : (double)NAN;
  range[1] = all.least < 0 ? 1 / (all.least * (1 + NEAR)) : (double)NAN;
}
