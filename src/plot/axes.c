/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Axes (see axes.h).  All lengths are in ems, so that they follow the size of
 * the letters. */
#include "plot/axes.h"

#include <math.h>
#include <string.h>

#define TICK 0.36
#define GAP 0.3
#define NUMBER 0.82 /* size of the numbers */
#define POWER 0.7   /* and of exponents */
#define NAME_LINE 1.35
#define LINE 0.055 /* width of lines */
#define RISE 0.33  /* of the letters' height: numbers are centred so */

double ph_axis_place(const struct ph_axis *axis, double value) {
  return (0.5 * value - 0.5 * axis->low) / (0.5 * axis->high - 0.5 * axis->low);
}

static double widest(const struct ph_ticks *ticks, struct ph_page *page,
                     double em) {
  double most = 0;
  for (size_t i = 0; i < ticks->n; i++) {
    most = fmax(most, ph_page_text_width(page, NUMBER * em, ticks->label[i]));
  }
  return most;
}

static size_t wanted_in(double length, double each) {
  double n = floor(length / each);
  return n >= PH_TICKS_MAX - 1 ? PH_TICKS_MAX - 1 : n >= 2 ? (size_t)n : 1;
}

/* Distance of ticks on the page; that of a single tick is all there is. */
static double spread(const struct ph_axis *axis, double length) {
  const struct ph_ticks *t = &axis->ticks;
  return t->n < 2 ? length
                  : length * (ph_axis_place(axis, t->at[1]) -
                              ph_axis_place(axis, t->at[0]));
}

/* At least three, where they do not touch. */
static void y_ticks(struct ph_axes *axes, double em) {
  const double h = axes->rect.h;
  size_t n = wanted_in(h, 3.2 * em), most = wanted_in(h, 1.2 * em);
  n = n < 4 ? wanted_in(fmin(h, 7.5 * em), 1.8 * em) : n;
  do {
    ph_ticks_make(axes->y.low, axes->y.high, n, &axes->y.ticks);
  } while (axes->y.ticks.n < 3 && n++ < most);
  if (spread(&axes->y, h) < em) {
    ph_ticks_make(axes->y.low, axes->y.high, 1, &axes->y.ticks);
  }
}

void ph_axes_ticks(struct ph_axes *axes, struct ph_page *page, double em) {
  size_t n = wanted_in(axes->rect.w, 3.4 * em);
  do {
    ph_ticks_make(axes->x.low, axes->x.high, n, &axes->x.ticks);
  } while (widest(&axes->x.ticks, page, em) + em >
               spread(&axes->x, axes->rect.w) &&
           n-- > 1);
  y_ticks(axes, em);
}

double ph_axes_left(const struct ph_axes *axes, struct ph_page *page,
                    double em) {
  return (TICK + GAP + NAME_LINE + 0.2) * em + widest(&axes->y.ticks, page, em);
}

double ph_axes_below(double em) {
  return (TICK + GAP + 0.85 + NAME_LINE) * em;
}

/* "x", or "(x - base) / 10", of which an exponent is to follow. */
static bool name_text(const struct ph_axis *axis, char text[128]) {
  const struct ph_ticks *t = &axis->ticks;
  bool base = t->base[0] != '\0', power = t->power != 0;
  size_t n = 0, size = 128;
  const char *parts[6] = {base && power ? "(" : "",
                          axis->name,
                          !base              ? ""
                          : t->base_negative ? " + "
                                             : " \xE2\x88\x92 ",
                          t->base,
                          base && power ? ")" : "",
                          power ? " / 10" : ""};
  for (size_t i = 0; i < 6; i++) {
    size_t more = strlen(parts[i]);
    if (n + more < size) {
      memcpy(text + n, parts[i], more);
      n += more;
    }
  }
  text[n] = '\0';
  return power;
}

static void exponent_text(int power, char text[16]) {
  int n = 0, unit = 1, k = power < 0 ? -power : power;
  if (power < 0) {
    memcpy(text, "\xE2\x88\x92", 3);
    n = 3;
  }
  while (k / unit >= 10) {
    unit *= 10;
  }
  for (; unit > 0; unit /= 10) {
    text[n++] = (char)('0' + k / unit % 10);
  }
  text[n] = '\0';
}

void ph_axis_name(const struct ph_axis *axis, struct ph_page *page, double em,
                  double room, struct ph_spot at, bool up) {
  char text[128], exponent[16] = "";
  double w, e;
  if (name_text(axis, text)) {
    exponent_text(axis->ticks.power, exponent);
  }
  w = ph_page_text_width(page, em, text);
  e = ph_page_text_width(page, POWER * em, exponent);
  if (w + e > room && room > 0) {
    em *= room / (w + e);
    e *= room / (w + e);
    w = room - e;
  }
  if (up) {
    at.y += 0.5 * (w + e);
  } else {
    at.x -= 0.5 * (w + e);
  }
  ph_page_text(page, at, em, 0, up, text);
  if (exponent[0]) {
    at.x += up ? -0.4 * em : w;
    at.y -= up ? w : 0.4 * em;
    ph_page_text(page, at, POWER * em, 0, up, exponent);
  }
}

static void x_axis(const struct ph_axes *axes, struct ph_page *page,
                   double em) {
  const struct ph_axis *axis = &axes->x;
  double bottom = axes->rect.y + axes->rect.h;
  for (size_t i = 0; i < axis->ticks.n; i++) {
    double x =
        axes->rect.x + axes->rect.w * ph_axis_place(axis, axis->ticks.at[i]);
    struct ph_spot from = {x, bottom}, to = {x, bottom + TICK * em};
    struct ph_spot text = {x, to.y + (GAP + 2 * RISE) * em};
    ph_page_pen(page, ph_ink(PH_INK_TICK), LINE * em, 0);
    ph_page_move(page, from);
    ph_page_line(page, to);
    ph_page_stroke(page);
    if (!axis->bare) {
      ph_page_text(page, text, NUMBER * em, 0.5, false, axis->ticks.label[i]);
    }
  }
  if (!axis->bare) {
    struct ph_spot at = {axes->rect.x + 0.5 * axes->rect.w,
                         bottom + (TICK + GAP + 0.65 + NAME_LINE) * em};
    ph_axis_name(axis, page, em, axes->rect.w, at, false);
  }
}

static void y_axis(const struct ph_axes *axes, struct ph_page *page,
                   double em) {
  const struct ph_axis *axis = &axes->y;
  double left = axes->rect.x;
  for (size_t i = 0; i < axis->ticks.n; i++) {
    double y = axes->rect.y + axes->rect.h -
               axes->rect.h * ph_axis_place(axis, axis->ticks.at[i]);
    struct ph_spot from = {left, y}, to = {left - TICK * em, y};
    struct ph_spot text = {to.x - GAP * em, y + RISE * NUMBER * em};
    ph_page_pen(page, ph_ink(PH_INK_TICK), LINE * em, 0);
    ph_page_move(page, from);
    ph_page_line(page, to);
    ph_page_stroke(page);
    if (!axis->bare) {
      ph_page_text(page, text, NUMBER * em, 1, false, axis->ticks.label[i]);
    }
  }
  if (!axis->bare) {
    double room = axes->left > 0 ? axes->left : ph_axes_left(axes, page, em);
    struct ph_spot at = {left - room + em, axes->rect.y + 0.5 * axes->rect.h};
    ph_axis_name(axis, page, em, axes->rect.h, at, true);
  }
}

void ph_axes_draw(const struct ph_axes *axes, struct ph_page *page, double em) {
  x_axis(axes, page, em);
  y_axis(axes, page, em);
  ph_page_pen(page, ph_ink(PH_INK_FRAME), LINE * em, 0);
  ph_page_rect(page, &axes->rect);
  ph_page_stroke(page);
}
