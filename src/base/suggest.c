/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Words of the input in messages (see suggest.h).
 *
 * The distance of two words is that of Damerau (1964) in its restricted form,
 * "optimal string alignment": the least number of insertions, deletions,
 * replacements and swaps of neighbours, no letter touched twice.  It is
 * computed row by row,
 *
 *   d(i,j) = min( d(i-1,j) + 1, d(i,j-1) + 1, d(i-1,j-1) + [a_i != b_j],
 *                 d(i-2,j-2) + 1  if a_i = b_(j-1) and a_(i-1) = b_j ),
 *
 * with upper and lower case taken for the same letter, as a wrong case is the
 * commonest mistake of all.
 */
#include "base/suggest.h"

#include <stdint.h>
#include <string.h>

enum {
  LONGEST = 32, /* no name of the program is longer */
  SHORTEST = 3, /* beginning of a name that stands for it */
  NEAR = 2      /* wrong letters that still make a typing mistake */
};

int ph_utf8_length(const char *p, const char *end) {
  const unsigned char *u = (const unsigned char *)p;
  size_t have = (size_t)(end - p);
  unsigned char low = 0x80; /* bounds of the second byte */
  unsigned char high = 0xBF;
  int n;
  if (u[0] < 0x80) {
    return 1;
  }
  if (u[0] < 0xC2 || u[0] > 0xF4) {
    return 0;
  }
  n = u[0] < 0xE0 ? 2 : u[0] < 0xF0 ? 3 : 4;
  /* RFC 3629, sec. 4: what would be overlong, a surrogate or too large. */
  if (u[0] == 0xE0) {
    low = 0xA0;
  } else if (u[0] == 0xED) {
    high = 0x9F;
  } else if (u[0] == 0xF0) {
    low = 0x90;
  } else if (u[0] == 0xF4) {
    high = 0x8F;
  }
  for (int i = 1; i < n; i++) {
    if ((size_t)i == have) {
      return -1;
    }
    if (u[i] < low || u[i] > high) {
      return 0;
    }
    low = 0x80;
    high = 0xBF;
  }
  return n;
}

/* What is not shown: first and last. */
static const uint32_t unseen[][2] = {
    {0x00, 0x1F},     {0x7F, 0x9F},     {0x61C, 0x61C},
    {0x200B, 0x200F}, {0x2028, 0x202E}, {0x2060, 0x206F},
    {0xFEFF, 0xFEFF}, {0xFFFE, 0xFFFF}, {0xE0000, 0xE007F}};

size_t ph_shown_length(const char *p, const char *end) {
  static const unsigned char lead[] = {0, 0x7F, 0x1F, 0x0F, 0x07};
  const unsigned char *u = (const unsigned char *)p;
  int length = ph_utf8_length(p, end);
  uint32_t c;
  if (length <= 0) {
    return 0;
  }
  c = u[0] & lead[length];
  for (int i = 1; i < length; i++) {
    c = c << 6 | (u[i] & 0x3F);
  }
  for (size_t i = 0; i < sizeof unseen / sizeof unseen[0]; i++) {
    if (c >= unseen[i][0] && c <= unseen[i][1]) {
      return 0;
    }
  }
  return (size_t)length;
}

const char *ph_show(const char *text, size_t n, char *shown, size_t size) {
  static const char digits[] = "0123456789abcdef", more[] = "...";
  const char *end = text + n;
  size_t used = 0, room = size - sizeof more;
  while (text < end) {
    int length = ph_utf8_length(text, end);
    size_t step = length > 0 ? (size_t)length : 1;
    bool plain = ph_shown_length(text, end) > 0;
    if (used + (plain ? step : 4 * step) > room) {
      memcpy(shown + used, more, sizeof more);
      return shown;
    }
    for (size_t i = 0; i < step; i++) {
      unsigned char c = (unsigned char)text[i];
      if (plain) {
        shown[used++] = text[i];
      } else {
        shown[used++] = '\\';
        shown[used++] = 'x';
        shown[used++] = digits[c >> 4];
        shown[used++] = digits[c & 15];
      }
    }
    text += step;
  }
  shown[used] = '\0';
  return shown;
}

const char *ph_excerpt(const char *text, size_t n,
                       char excerpt[PH_EXCERPT_MAX]) {
  return ph_show(text, n, excerpt, PH_EXCERPT_MAX);
}

static char lower(char c) {
  return c >= 'A' && c <= 'Z' ? (char)(c - 'A' + 'a') : c;
}

bool ph_word_is(const char *word, size_t n, const char *name) {
  for (size_t i = 0; i < n; i++) {
    if (name[i] == '\0' || lower(word[i]) != lower(name[i])) {
      return false;
    }
  }
  return name[n] == '\0';
}

static size_t smaller(size_t a, size_t b) {
  return a < b ? a : b;
}

/* The distance of two words of at most LONGEST letters. */
static size_t distance(const char *a, size_t a_n, const char *b, size_t b_n) {
  size_t rows[3][LONGEST + 1] = {{0}};
  size_t *older = rows[0];
  size_t *old = rows[1];
  size_t *row = rows[2];
  for (size_t j = 0; j <= b_n; j++) {
    old[j] = j;
  }
  for (size_t i = 1; i <= a_n; i++) {
    size_t *spare = older;
    row[0] = i;
    for (size_t j = 1; j <= b_n; j++) {
      char x = lower(a[i - 1]);
      char y = lower(b[j - 1]);
      row[j] = smaller(smaller(old[j], row[j - 1]) + 1, old[j - 1] + (x != y));
      if (i > 1 && j > 1 && x == lower(b[j - 2]) && lower(a[i - 2]) == y) {
        row[j] = smaller(row[j], older[j - 2] + 1);
      }
    }
    older = old;
    old = row;
    row = spare;
  }
  return old[b_n];
}

void ph_suggest_init(struct ph_suggest *suggest, const char *word, size_t n) {
  *suggest = (struct ph_suggest){.word = word, .n = n};
}

/* Whether a name begins with the word. */
static bool begins_with(const char *name, size_t n,
                        const struct ph_suggest *suggest) {
  size_t i = 0;
  while (i < n && i < suggest->n && lower(name[i]) == lower(suggest->word[i])) {
    i++;
  }
  return i == suggest->n && i >= SHORTEST;
}

void ph_suggest_try(struct ph_suggest *suggest, const char *name, size_t n) {
  size_t d;
  if (suggest->n > LONGEST || n > LONGEST) {
    return;
  }
  d = begins_with(name, n, suggest)
          ? 0
          : distance(suggest->word, suggest->n, name, n);
  if (d <= NEAR && d < suggest->n && d <= n &&
      (!suggest->best || d < suggest->distance)) {
    suggest->best = name;
    suggest->best_n = n;
    suggest->distance = d;
  }
}

void ph_suggest_list(struct ph_suggest *suggest, const char *names) {
  while (*names) {
    size_t n = strcspn(names, "|");
    ph_suggest_try(suggest, names, n);
    names += n + (names[n] == '|');
  }
}

bool ph_did_you_mean(const struct ph_suggest *suggest,
                     char clause[PH_DID_YOU_MEAN_MAX]) {
  static const char before[] = "; did you mean \"";
  size_t n = sizeof before - 1;
  clause[0] = '\0';
  if (!suggest->best) {
    return false;
  }
  memcpy(clause, before, n);
  memcpy(clause + n, suggest->best, suggest->best_n);
  memcpy(clause + n + suggest->best_n, "\"?", sizeof "\"?");
  return true;
}
