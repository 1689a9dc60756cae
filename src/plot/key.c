/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The key of a figure (see key.h). */
#include "plot/key.h"

#include "plot/lines.h"

#include <math.h>
#include <string.h>

/* In ems: letters, samples of lines, gaps, and about the width of a letter. */
#define LETTERS 0.85
#define SAMPLE 1.8
#define GAP 0.45
#define BETWEEN 1.3
#define LETTER 0.47
#define DOT 0.2

static const char *const names[PH_KEY_N] = {
#define X(symbol, name) name,
    PH_KEYS(X)
#undef X
};

/* ---- what there is ------------------------------------------------------- */

static void mark(struct ph_key *key, enum ph_key_entry entry, bool shown) {
  key->has[entry] = key->has[entry] || shown;
}

static void look_at(const struct ph_panel *panel, struct ph_key *key) {
  const struct ph_drawing *d = panel->drawings[0];
  static const enum ph_key_entry of[] = {[PH_STROKE_CURVE] = PH_KEY_CURVE,
                                         [PH_STROKE_POLYGON] = PH_KEY_POLYGON,
                                         [PH_STROKE_TRIMMED] = PH_KEY_TRIMMED,
                                         [PH_STROKE_OFFSET] = PH_KEY_OFFSET,
                                         [PH_STROKE_TANGENT] = PH_KEY_TANGENT};
  _Static_assert(sizeof of / sizeof of[0] == PH_STROKE_N,
                 "every stroke has an entry");
  const bool sweep = panel->n > 1;
  mark(key, PH_KEY_POINT, d->data_n > 0);
  for (size_t i = 0; i < d->strokes_n; i++) {
    const enum ph_stroke_role role = d->strokes[i].role;
    mark(key, of[role], !sweep || role == PH_STROKE_TANGENT);
  }
  mark(key, PH_KEY_HIDDEN, d->space == PH_SPHERE && panel->views_n > 1);
  for (size_t i = 0; i < d->sheets_n && i < 1; i++) {
    const struct ph_sheet *sheet = &d->sheets[i];
    mark(key, PH_KEY_POINT, sheet->elements_n > 0);
    mark(key, PH_KEY_TANGENT, sheet->elements_n > 0);
    mark(key, PH_KEY_CONTACT, !sweep);
    mark(key, PH_KEY_EDGE, !sheet->bare && !sweep);
    mark(key, PH_KEY_RULING, !sheet->bare && !sweep);
    mark(key, PH_KEY_HIDDEN, !sheet->bare && !sweep);
    mark(key, PH_KEY_OFFSET, !sweep && d->sheets_n > 1);
  }
}

struct ph_key ph_key_of(const struct ph_panel *panels, size_t n) {
  struct ph_key key = {{false}};
  size_t count = 0;
  for (size_t i = 0; i < n; i++) {
    look_at(&panels[i], &key);
  }
  for (int k = 0; k < PH_KEY_N; k++) {
    count += key.has[k];
  }
  return count > 1 ? key : (struct ph_key){{false}};
}

/* ---- where it goes ------------------------------------------------------- */

static double width_of(int entry) {
  return SAMPLE + GAP + LETTER * (double)strlen(names[entry]);
}

/* The entries of the row that begins with one.  out width  in ems */
static int row_end(const struct ph_key *key, int from, double most,
                   double *width) {
  int k = from;
  *width = 0;
  for (; k < PH_KEY_N; k++) {
    if (key->has[k]) {
      const double more = (*width > 0 ? BETWEEN : 0) + width_of(k);
      if (*width > 0 && *width + more > most) {
        break;
      }
      *width += more;
    }
  }
  return k;
}

size_t ph_key_rows(const struct ph_key *key, double width) {
  double row;
  size_t rows = 0;
  for (int k = 0; k < PH_KEY_N;) {
    k = row_end(key, k, width, &row);
    rows += row > 0;
  }
  return rows;
}

/* ---- samples ------------------------------------------------------------- */

static void line(struct ph_page *page, struct ph_spot from, double length,
                 enum ph_ink ink, double width, double dash) {
  const struct ph_spot to = {from.x + length, from.y};
  ph_page_pen(page, ph_ink(ink), width, dash);
  ph_page_move(page, from);
  ph_page_line(page, to);
  ph_page_stroke(page);
}

static void arrow(struct ph_page *page, struct ph_spot at, double em) {
  const double tip = at.x + SAMPLE * em, h = PH_LINE_HEAD * em;
  line(page, at, SAMPLE * em - h, PH_INK_TANGENT, PH_LINE_ARROW * em, 0);
  ph_page_move(page, (struct ph_spot){tip, at.y});
  ph_page_line(page, (struct ph_spot){tip - h, at.y - 0.3 * h});
  ph_page_line(page, (struct ph_spot){tip - 0.8 * h, at.y});
  ph_page_line(page, (struct ph_spot){tip - h, at.y + 0.3 * h});
  ph_page_close(page);
  ph_page_fill(page);
}

/* Lines of two inks are of segments in turn. */
static const struct {
  enum ph_ink ink, next;
  double width, dash;
} lines[] = {
    [PH_KEY_CURVE] = {PH_INK_EVEN, PH_INK_ODD, PH_LINE_CURVE, 0},
    [PH_KEY_CONTACT] = {PH_INK_EVEN, PH_INK_ODD, PH_LINE_CONTACT, 0},
    [PH_KEY_POLYGON] = {PH_INK_POLYGON, PH_INK_POLYGON, PH_LINE_POLYGON, 0},
    [PH_KEY_OFFSET] = {PH_INK_OFFSET, PH_INK_OFFSET, PH_LINE_OFFSET, 0},
    [PH_KEY_TRIMMED] = {PH_INK_TRIMMED, PH_INK_TRIMMED, PH_LINE_TRIMMED,
                        PH_LINE_DASH},
    [PH_KEY_EDGE] = {PH_INK_EDGE, PH_INK_EDGE, PH_LINE_EDGE, 0},
    [PH_KEY_RULING] = {PH_INK_RULING, PH_INK_RULING, PH_LINE_RULING, 0},
    [PH_KEY_HIDDEN] = {PH_INK_EDGE, PH_INK_EDGE, PH_LINE_HIDDEN, PH_LINE_DASH}};
_Static_assert(sizeof lines / sizeof lines[0] == PH_KEY_N,
               "every entry has a sample");

static void sample(struct ph_page *page, int entry, struct ph_spot at,
                   double em) {
  const double w = SAMPLE * em;
  const struct ph_spot half = {at.x + 0.5 * w, at.y};
  const double width = lines[entry].width * em, dash = lines[entry].dash * em;
  if (entry == PH_KEY_POINT) {
    ph_page_pen(page, ph_ink(PH_INK_POINT), 1, 0);
    ph_page_circle(page, half, DOT * em);
    ph_page_fill(page);
  } else if (entry == PH_KEY_TANGENT) {
    arrow(page, at, em);
  } else if (lines[entry].next != lines[entry].ink) {
    line(page, at, 0.5 * w, lines[entry].ink, width, dash);
    line(page, half, 0.5 * w, lines[entry].next, width, dash);
  } else {
    line(page, at, w, lines[entry].ink, width, dash);
  }
}

void ph_key_draw(const struct ph_key *key, struct ph_page *page,
                 const struct ph_rect *place, double em) {
  double y = place->y + 0.5 * PH_KEY_ROW * em, width;
  ph_page_group(page, "key");
  for (int k = 0; k < PH_KEY_N; y += PH_KEY_ROW * em) {
    const int end = row_end(key, k, place->w / em, &width);
    double x = place->x + 0.5 * fmax(place->w - width * em, 0);
    for (; k < end; k++) {
      if (key->has[k]) {
        const struct ph_spot at = {x, y};
        const struct ph_spot text = {x + (SAMPLE + GAP) * em, y + 0.3 * em};
        sample(page, k, at, em);
        ph_page_text(page, text, LETTERS * em, 0, false, names[k]);
        x += (width_of(k) + BETWEEN) * em;
      }
    }
  }
  ph_page_group(page, NULL);
}
