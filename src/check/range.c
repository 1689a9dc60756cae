/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The distances at which offsets are regular, against the curvature of control
 * points: the largest at many places of each segment to either side, and
 * between those beside each place that is larger than both, by golden sections.
 */
#include "check/checks.h"

/* Places of a segment, and sections: the curvature is flat where it is largest.
 */
enum { PLACES = 32, SECTIONS = 48 };

static const double GOLDEN = 0.6180339887498949;

/* Places whose curvature is less, of what is claimed, are not looked around. */
static const double LITTLE = 0.25;

/* Where the curve stands still no distance is: there it bends by no less, over
 * the inverse of its size. */
static const double STOP = 1e6;

/* Over the inverse of the size: what bends by less is straight to rounding. */
static const double NONE = 1e-9;

struct bends {
  const struct ph_check *v;
  struct ph_check_path path;
  double side;        /* 1: to the left */
  double most, error; /* the largest, and by how much it may be off */
  double wanted;      /* that is claimed */
};

static double bend_at(struct bends *b, double u) {
  const struct ph_check_local at = ph_check_local_at(&b->path, u);
  const double bend = b->side * at.curvature;
  if (bend > b->most) {
    b->most = bend;
    b->error = at.curvature_error;
  }
  return bend;
}

/* Looks for the largest between two parameters. */
static void look(struct bends *b, double low, double high) {
  double u[2] = {high - GOLDEN * (high - low), low + GOLDEN * (high - low)};
  double bend[2] = {bend_at(b, u[0]), bend_at(b, u[1])};
  for (int i = 0; i < SECTIONS; i++) {
    if (bend[0] > bend[1]) {
      high = u[1];
      u[1] = u[0];
      bend[1] = bend[0];
      u[0] = high - GOLDEN * (high - low);
      bend[0] = bend_at(b, u[0]);
    } else {
      low = u[0];
      u[0] = u[1];
      bend[0] = bend[1];
      u[1] = low + GOLDEN * (high - low);
      bend[1] = bend_at(b, u[1]);
    }
  }
}

static void see_segment(struct bends *b) {
  double bend[PLACES + 1];
  for (size_t i = 0; i <= PLACES; i++) {
    bend[i] = bend_at(b, (double)i / PLACES);
  }
  for (size_t i = 0; i <= PLACES; i++) {
    const size_t before = i > 0 ? i - 1 : i, after = i < PLACES ? i + 1 : i;
    if (bend[i] >= bend[before] && bend[i] >= bend[after] &&
        bend[i] > LITTLE * b->wanted) {
      look(b, (double)before / PLACES, (double)after / PLACES);
    }
  }
}

static void check_side(struct ph_check *v, size_t side) {
  const double size = v->scale.size, claimed = v->claim->offset_range[side];
  const double sign = side ? -1 : 1, unit = ph_check_scaled(v, claimed);
  const bool any = !isfinite(claimed);
  const struct ph_check_where where = ph_check_of("offset_range", side, NULL);
  struct ph_check_segment s;
  struct bends b = {.v = v,
                    .path = {.v = v, .s = &s},
                    .side = sign,
                    .wanted = any ? 0 : sign / unit};
  if (!any && !(sign * claimed >= 0)) {
    ph_check_wrong(v, PH_CHECK_OFFSET, where, "is to the other side");
    return;
  }
  for (size_t k = 0; k < v->curve->n; k++) {
    ph_check_load(v, k, &s);
    see_segment(&b);
  }
  if (any || (b.wanted * size <= NONE && b.most * size <= NONE)) {
    ph_check_miss(v, PH_CHECK_OFFSET, where, b.most, 1 / size,
                  b.error + NONE / size, "is none, and the curve bends");
  } else if (!(fabs(claimed) > 0)) {
    ph_check_miss(v, PH_CHECK_OFFSET, where, STOP, b.most * size, 0,
                  "is 0, and the curve stands still nowhere");
  } else { /* errors are those of curvatures, of these or 1 over the size */
    const double part = fabs(claimed) / b.most;
    ph_check_number(v, PH_CHECK_OFFSET, where, claimed,
                    claimed * (b.wanted / b.most),
                    part * ph_check_larger(b.most, 1 / size), part * b.error);
  }
}

void ph_check_range(struct ph_check *v) {
  if (v->curve->dimension != 2) {
    ph_check_wrong(v, PH_CHECK_OFFSET,
                   ph_check_of("offset_range", PH_CHECK_ONE, NULL),
                   "is of curves in the plane");
    return;
  }
  check_side(v, 0);
  check_side(v, 1);
}
