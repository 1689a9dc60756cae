/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Texts made fit for a page (see text.h). */
#include "plot/text.h"

#include "base/suggest.h"
#include "plot/page.h"

#include <string.h>

static const char more[] = "...";

enum { MORE = sizeof more - 1 };

void ph_plot_text(const char *text, char clean[PH_PLOT_TEXT_MAX]) {
  const char *end = text + strlen(text);
  size_t n = 0;
  while (text < end) {
    int c = ph_utf8_length(text, end);
    bool bad = ph_shown_length(text, end) == 0;
    size_t step = c <= 0 ? 1 : (size_t)c;
    if (n + step + MORE >= PH_PLOT_TEXT_MAX) {
      memcpy(clean + n, more, MORE);
      n += MORE;
      break;
    }
    if (bad) {
      clean[n++] = '?';
    } else {
      memcpy(clean + n, text, step);
      n += step;
    }
    text += step;
  }
  clean[n] = '\0';
}

/* ---- numbers ------------------------------------------------------------- */

enum { DIGITS_KEPT = 6 };

static bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

void ph_plot_text_number(size_t number, char text[PH_PLOT_TEXT_MAX]) {
  size_t at = PH_PLOT_TEXT_MAX - 1;
  text[at] = '\0';
  do {
    text[--at] = (char)('0' + number % 10);
    number /= 10;
  } while (number > 0);
  memmove(text, text + at, PH_PLOT_TEXT_MAX - at);
}

/* Adds one to the last digit of a number.  False: all were 9, and now are 0. */
static bool add_one(char *first, char *last) {
  for (char *p = last; p >= first; p--) {
    if (*p != '.' && ++*p <= '9') {
      return true;
    }
    *p = *p == '.' ? '.' : '0';
  }
  return false;
}

/* Takes away what follows the last digit that is kept, up to `rest`. */
static void cut_digits(char *first, char *last, char *point, const char *rest) {
  bool up = last[1] == '.' ? last[2] >= '5' : last[1] >= '5';
  bool carried = up && !add_one(first, last);
  while (last > point && *last == '0') {
    last--;
  }
  last -= last == point;
  memmove(last + 1, rest, strlen(rest) + 1);
  if (carried) {
    memmove(first + 1, first, strlen(first) + 1);
    *first = '1';
  }
}

void ph_plot_text_round(char text[PH_PLOT_TEXT_MAX]) {
  char *first = text + (text[0] == '-'), *p = first, *point = NULL, *end;
  char *last = NULL; /* the last digit that is kept */
  size_t digits = 0;
  for (; is_digit(*p) || (*p == '.' && !point); p++) {
    point = *p == '.' ? p : point;
    digits += is_digit(*p) && (digits > 0 || *p > '0');
    last = digits <= DIGITS_KEPT && is_digit(*p) ? p : last;
  }
  end = p;
  if (*end == 'e' || *end == 'E') {
    end += 1 + (end[1] == '-' || end[1] == '+');
    end += strspn(end, "0123456789");
  }
  if (*end || !point || point == first || !is_digit(p[-1]) ||
      digits <= DIGITS_KEPT) {
    return;
  }
  cut_digits(first, last < point ? point - 1 : last, point, p);
}

/* ---- widths -------------------------------------------------------------- */

void ph_plot_text_fit(struct ph_page *page, double size, double width,
                      char clean[PH_PLOT_TEXT_MAX]) {
  size_t n = strlen(clean);
  if (n >= MORE && strcmp(clean + n - MORE, more) == 0) {
    n -= MORE;
  }
  while (n > 0 && ph_page_text_width(page, size, clean) > width) {
    do {
      n--;
    } while (n > 0 && ((unsigned char)clean[n] >> 6) == 2);
    strcpy(clean + n, n + MORE < PH_PLOT_TEXT_MAX ? more : "");
  }
}
