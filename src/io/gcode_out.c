/* SPDX-License-Identifier: GPL-3.0-or-later */
/* G-code (see gcode_out.h). */
#include "io/gcode_out.h"

#include "curve/offset/gap.h"
#include "curve/sample/sample.h"
#include "io/number.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* Numbers are within this of the size of the curve; six of so many characters
 * make a line. */
static const double RESOLUTION = 1e-12;
enum { CHARACTERS_MAX = 36, COMMENT_MAX = 100 };

/* Where the moves of a result stand. */
struct machine {
  struct ph_buf *buf;
  int decimals;
  double up; /* -1: y turns round */
  double at[2];
};

void ph_gcode_header(struct ph_buf *buf, double feed) {
  char text[PH_NUMBER_MAX + 1];
  text[ph_number_write(text, feed)] = '\0';
  ph_buf_puts(buf, "G21 G17 G90\nF");
  ph_buf_puts(buf, text);
  ph_buf_puts(buf, "\n");
}

void ph_gcode_footer(struct ph_buf *buf) {
  ph_buf_puts(buf, "M2\n");
}

/* ---- numbers --------------------------------------------------------------
 */

static int decimals_of(const struct ph_result *r) {
  const double size = ph_curve_size(&r->curve);
  const double n = ceil(-log10(RESOLUTION * size));
  return n > 0 ? (int)fmin(n, 999) : 0;
}

enum ph_status ph_gcode_fits(const struct ph_result *result,
                             struct ph_diag *diag) {
  const double size = ph_curve_size(&result->curve);
  const double *start = result->curve.control_points;
  double most = fmax(fabs(start[0]), fabs(start[1])) + size;
  for (size_t i = 0; i < result->offsets_n; i++) {
    most = fmax(most, fabs(result->offsets[i].distance));
  }
  /* six numbers of a letter, a sign, a point, digits */
  if (!(decimals_of(result) + fmax(log10(most), 0) + 4 <= CHARACTERS_MAX)) {
    return ph_fail(diag, PH_E_TOO_LARGE, NULL,
                   "the curve has a size of %.3g and coordinates up to %.3g, "
                   "which G-code, of plain decimals, has no room for",
                   size, most);
  }
  return PH_OK;
}

static void word(const struct machine *m, char letter, double x) {
  char text[64] = {' ', letter};
  int n = snprintf(text + 2, sizeof text - 2, "%.*f", m->decimals, x) + 2;
  while (m->decimals > 0 && text[n - 1] == '0') {
    n--;
  }
  n -= text[n - 1] == '.';
  if (strncmp(text + 2, "-0", (size_t)n - 2) == 0) {
    text[2] = '0';
    n = 3;
  }
  ph_buf_put(m->buf, text, (size_t)n);
}

/* ---- moves ----------------------------------------------------------------
 */

/* To a point, straight: at a feed, or as fast as it goes. */
static void go(struct machine *m, const char *how, const double *p) {
  ph_buf_puts(m->buf, how);
  word(m, 'X', p[0]);
  word(m, 'Y', m->up * p[1]);
  memcpy(m->at, p, sizeof m->at);
}

static void line(struct machine *m, const char *how, const double *p) {
  go(m, how, p);
  ph_buf_puts(m->buf, "\n");
}

/* From one point to another, as two words. */
static void leg(const struct machine *m, const char *letters,
                const double *from, const double *to) {
  word(m, letters[0], to[0] - from[0]);
  word(m, letters[1], m->up * (to[1] - from[1]));
}

/* Whether two points are the same to the last bit. */
static bool same(const double *a, const double *b) {
  return !(a[0] < b[0]) && !(a[0] > b[0]) && !(a[1] < b[1]) && !(a[1] > b[1]);
}

/* What follows is about: a control character, or one that ends it, is _. */
static void comment(const struct machine *m, const char *id,
                    const struct ph_offset *offset) {
  char text[COMMENT_MAX + PH_NUMBER_MAX + 32], number[PH_NUMBER_MAX + 1];
  if (offset) {
    number[ph_number_write(number, offset->distance)] = '\0';
    snprintf(text, sizeof text, "(offset %s of %.*s", number, COMMENT_MAX, id);
  } else {
    snprintf(text, sizeof text, "(curve %.*s", COMMENT_MAX, id);
  }
  for (char *c = text + 1; *c; c++) {
    *c = *c < ' ' || *c > '~' || *c == '(' || *c == ')' ? '_' : *c;
  }
  ph_buf_puts(m->buf, text);
  ph_buf_puts(m->buf, ")\n");
}

/* ---- curves ---------------------------------------------------------------
 */

/* Whether the inner control points are on the chord, and between its ends. */
static bool is_straight(const double *p) {
  const double x = p[6] - p[0], y = p[7] - p[1];
  const double length = x * x + y * y;
  bool straight = true;
  for (size_t i = 2; i <= 4; i += 2) {
    const double u = p[i] - p[0], v = p[i + 1] - p[1];
    const double along = u * x + v * y;
    straight &= fabs(x * v - y * u) <= RESOLUTION * length && along >= 0 &&
                along <= length;
  }
  return straight;
}

static void cubics(struct machine *m, const struct ph_curve *curve) {
  for (size_t k = 0; k < curve->n; k++) {
    const double *p = ph_curve_points(curve, k);
    if (k == 0 || !same(p, m->at)) {
      line(m, "G0", p);
    }
    if (is_straight(p)) {
      line(m, "G1", p + 6);
    } else {
      go(m, "G5", p + 6);
      leg(m, "IJ", p, p + 2);
      leg(m, "PQ", p + 6, p + 4);
      ph_buf_puts(m->buf, "\n");
    }
  }
}

/* Chords, from gap to gap. */
static void chords(struct machine *m, const struct ph_samples *s,
                   const struct ph_gaps *gaps) {
  size_t gap = 0;
  for (size_t i = 0; i < s->n; i++) {
    const double *p = s->point + 2 * i;
    const bool cut = gaps && ph_gaps_pass(gaps, s->segment[i], &gap);
    if (i == 0 || cut) {
      line(m, "G0", p);
    } else if (!same(p, m->at)) {
      line(m, "G1", p);
    }
  }
}

/* The corner that a join is around. */
static const double *corner_of(const struct ph_curve *curve, size_t join) {
  return join < curve->n
             ? ph_curve_points(curve, join)
             : ph_curve_points(curve, curve->n - 1) + 2 * curve->degree;
}

static void arc(struct machine *m, const struct ph_curve *curve,
                const struct ph_loop_piece *piece, const double *end) {
  double start[2];
  memcpy(start, m->at, sizeof start);
  go(m, piece->angle * m->up > 0 ? "G3" : "G2", end);
  leg(m, "IJ", start, corner_of(curve, piece->join));
  ph_buf_puts(m->buf, "\n");
}

/* Samples are at both ends of every piece. */
static void loop(struct machine *m, const struct ph_curve *curve,
                 const struct ph_loop *l, size_t degree) {
  const struct ph_samples *s = &l->samples;
  size_t i = 0;
  if (s->n == 0) {
    return;
  }
  line(m, "G0", s->point);
  for (size_t k = 0; k < l->n && i + 1 < s->n; k++) {
    const struct ph_loop_piece *piece = &l->pieces[k];
    const double *end = piece->control_points + 2 * degree;
    const size_t first = i;
    do {
      i++;
    } while (i + 1 < s->n && !same(s->point + 2 * i, end));
    if (piece->join != PH_NO_SEGMENT && fabs(piece->angle) > 0 &&
        i > first + 1) {
      arc(m, curve, piece, s->point + 2 * i);
      continue;
    }
    for (size_t j = first + 1; j <= i; j++) {
      if (!same(s->point + 2 * j, m->at)) {
        line(m, "G1", s->point + 2 * j);
      }
    }
  }
}

static bool is_cubic(const struct ph_curve *curve) {
  return curve->preimage.n == 2 && curve->degree == 3;
}

void ph_gcode_out(struct ph_buf *buf, const char *id, bool downward,
                  const struct ph_result *result) {
  struct machine m = {buf, decimals_of(result), downward ? -1 : 1, {0, 0}};
  comment(&m, id, NULL);
  if (is_cubic(&result->curve)) {
    cubics(&m, &result->curve);
  } else {
    chords(&m, &result->samples, NULL);
  }
  for (size_t i = 0; i < result->offsets_n; i++) {
    const struct ph_offset *o = &result->offsets[i];
    comment(&m, id, o);
    for (size_t j = 0; j < o->loops.n; j++) {
      loop(&m, &result->curve, &o->loops.v[j], o->degree);
    }
    if (!o->loops.mode) {
      chords(&m, &o->samples, &o->gaps);
    }
  }
}
