/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The key of a figure: what its lines and marks are, in rows below all
 * panels.  Curves of a sweep are told apart by the legends of their panels. */
#ifndef PH_PLOT_KEY_H
#define PH_PLOT_KEY_H

#include "plot/panel.h"

/* What a figure may show: X(SYMBOL, "name"). */
#define PH_KEYS(X)               \
  X(POINT, "data")               \
  X(CURVE, "curve, by segments") \
  X(CONTACT, "contact curve")    \
  X(POLYGON, "control polygon")  \
  X(OFFSET, "offset")            \
  X(TRIMMED, "trimmed off")      \
  X(TANGENT, "tangent")          \
  X(EDGE, "edge of a strip")     \
  X(RULING, "ruling")            \
  X(HIDDEN, "hidden")

enum ph_key_entry {
#define X(symbol, name) PH_KEY_##symbol,
  PH_KEYS(X)
#undef X
      PH_KEY_N
};

struct ph_key {
  bool has[PH_KEY_N];
};

/* ph_key_of: what the panels show; of a single kind of thing nothing. */
struct ph_key ph_key_of(const struct ph_panel *panels, size_t n);

/* ph_key_rows: how many rows it takes; width in ems. */
size_t ph_key_rows(const struct ph_key *key, double width);

/* ph_key_draw: rows of PH_KEY_ROW ems from the top of the place on. */
#define PH_KEY_ROW 1.5
void ph_key_draw(const struct ph_key *key, struct ph_page *page,
                 const struct ph_rect *place, double em);

#endif
