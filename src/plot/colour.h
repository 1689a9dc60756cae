/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The colours of figures.  Each of them stands for one kind of thing, so that
 * what an SVG file shows can be counted by the colours of its strokes
 * (figure.h).
 */
#ifndef PH_PLOT_COLOUR_H
#define PH_PLOT_COLOUR_H

#include <stdbool.h>
#include <stddef.h>

/* Red, green, blue in [0,1]. */
struct ph_colour {
  double r, g, b;
};

/* X(SYMBOL, red, green, blue), in percent. */
#define PH_INKS(X)         \
  X(EVEN, 8, 39, 70)       \
  X(ODD, 90, 47, 8)        \
  X(LAST, 49, 32, 66)      \
  X(OFFSET, 5, 58, 44)     \
  X(TRIMMED, 38, 66, 57)   \
  X(POLYGON, 66, 66, 66)   \
  X(TANGENT, 36, 36, 36)   \
  X(POINT, 10, 10, 10)     \
  X(FRAME, 45, 45, 45)     \
  X(TICK, 44, 44, 44)      \
  X(TEXT, 15, 15, 15)      \
  X(ZERO, 80, 80, 80)      \
  X(JOINT, 85, 85, 85)     \
  X(GRATICULE, 87, 88, 90) \
  X(OUTLINE, 55, 56, 58)   \
  X(BOX, 83, 83, 83)       \
  X(EDGE, 22, 24, 28)      \
  X(RULING, 58, 60, 64)    \
  X(PAPER, 100, 100, 100)

enum ph_ink {
#define X(symbol, r, g, b) PH_INK_##symbol,
  PH_INKS(X)
#undef X
      PH_INK_N
};

struct ph_colour ph_ink(enum ph_ink ink);

/*
 * ph_colour_segment: two colours in turn, that joints are seen by; a third one
 * for the last segment of a closed curve with an odd number of them.
 */
struct ph_colour ph_colour_segment(size_t segment, size_t n, bool closed);

/*
 * ph_colour_ramp: number i of n in a ramp from dark violet to light green, with
 * even steps for the eye: viridis (S. van der Walt and N. Smith, 2015), but for
 * its end, which is too light on paper.
 */
struct ph_colour ph_colour_ramp(size_t i, size_t n);

/* Lengths of dashes and gaps in turn, from so far in the first dash on; n = 0:
 * a line without gaps. */
enum { PH_DASH_MAX = 6 };
struct ph_dash {
  size_t n;
  double length[PH_DASH_MAX], phase;
};

/* ph_colour_dash: dashes of number i of n curves, so that they are told apart
 * without colours; the first, and all of many, have none. */
struct ph_dash ph_colour_dash(size_t i, size_t n, double em);

/* ph_colour_thin: how much thinner the lines of n curves in one place are. */
double ph_colour_thin(size_t n);

#endif
