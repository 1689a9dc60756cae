/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The colours of figures (see colour.h). */
#include "plot/colour.h"

#include <math.h>

struct ph_colour ph_ink(enum ph_ink ink) {
  static const struct ph_colour inks[PH_INK_N] = {
#define X(symbol, r, g, b) {r / 100.0, g / 100.0, b / 100.0},
      PH_INKS(X)
#undef X
  };
  return inks[ink];
}

struct ph_colour ph_colour_segment(size_t segment, size_t n, bool closed) {
  if (closed && n > 1 && n % 2 == 1 && segment + 1 == n) {
    return ph_ink(PH_INK_LAST);
  }
  return ph_ink(segment % 2 == 0 ? PH_INK_EVEN : PH_INK_ODD);
}

/* Every 16th entry of the table of 256, in 1/255. */
static const unsigned char ramp[][3] = {
    {68, 1, 84},    {72, 26, 108},  {71, 47, 125},  {65, 68, 135},
    {57, 86, 140},  {49, 104, 142}, {42, 120, 142}, {35, 136, 142},
    {31, 152, 139}, {34, 168, 132}, {53, 183, 121}, {84, 197, 104},
    {122, 209, 81}, {165, 219, 54}, {210, 226, 27}};

static double mix(double a, double b, double t) {
  return (a + t * (b - a)) / 255;
}

struct ph_colour ph_colour_ramp(size_t i, size_t n) {
  const double end = 12; /* the last entry that is dark enough */
  double at = n > 1 ? end * (double)i / (double)(n - 1) : 4;
  size_t k = at < end - 1 ? (size_t)at : (size_t)end - 1;
  double t = at - (double)k;
  struct ph_colour c = {mix(ramp[k][0], ramp[k + 1][0], t),
                        mix(ramp[k][1], ramp[k + 1][1], t),
                        mix(ramp[k][2], ramp[k + 1][2], t)};
  return c;
}

/* More curves than these are told apart by how light they are, in a bar. */
enum { DASHED_MAX = 10 };

struct ph_dash ph_colour_dash(size_t i, size_t n, double em) {
  static const struct ph_dash dashes[] = {
      {0, {0}, 0},
      {2, {0.95, 0.4}, 0},
      {4, {0.95, 0.3, 0.2, 0.3}, 0},
      {2, {0.25, 0.3}, 0},
      {6, {0.95, 0.3, 0.2, 0.3, 0.2, 0.3}, 0}};
  struct ph_dash dash = {0, {0}, 0};
  if (n > 1 && n <= DASHED_MAX) {
    dash = dashes[i % (sizeof dashes / sizeof dashes[0])];
  }
  for (size_t k = 0; k < dash.n; k++) {
    dash.length[k] *= em;
  }
  return dash;
}

double ph_colour_thin(size_t n) {
  return n > 1 ? fmax(0.35, fmin(0.8, sqrt(8 / (double)n))) : 1;
}
