/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A figure in words (see describe.h). */
#include "plot/describe.h"

#include "plot/legend.h"

static void put_count(struct ph_buf *out, size_t n, const char *what) {
  char digits[PH_PLOT_TEXT_MAX];
  ph_plot_text_number(n, digits);
  ph_buf_puts(out, digits);
  ph_buf_puts(out, " ");
  ph_buf_puts(out, what);
  ph_buf_puts(out, n == 1 ? "" : "s");
}

/* How many offsets a drawing has: their strokes have their numbers. */
static size_t offsets_of(const struct ph_drawing *d) {
  size_t n = 0;
  for (size_t i = 0; i < d->strokes_n; i++) {
    const struct ph_stroke *s = &d->strokes[i];
    n = s->role == PH_STROKE_OFFSET && s->index >= n ? s->index + 1 : n;
  }
  return n;
}

static const char *kind_of(const struct ph_drawing *d) {
  switch (d->space) {
  case PH_PLANE:
    return d->closed ? "closed curve in the plane" : "curve in the plane";
  case PH_SPACE:
    return d->closed ? "closed curve in space" : "curve in space";
  case PH_SPHERE:
    return d->closed ? "closed curve on a sphere" : "curve on a sphere";
  case PH_SURFACE:
    return "developable surface and its flat pattern";
  case PH_PATCHWORK:
    return "surface of patches, shaded, with isophotes and mean curvature";
  }
  return "curve";
}

static void put_details(const struct ph_panel *panel, struct ph_buf *out) {
  const struct ph_drawing *d = panel->drawings[0];
  const size_t offsets = offsets_of(d);
  if (d->data_n > 0) {
    ph_buf_puts(out, " through ");
    put_count(out, d->data_n, "point");
  }
  if (offsets > 0) {
    ph_buf_puts(out, ", with ");
    put_count(out, offsets, "offset");
  }
  if (panel->n > 1) {
    ph_buf_puts(out, "; ");
    put_count(out, panel->n, "result");
    ph_buf_puts(out, " of a sweep");
  }
  if (d->label && panel->n > 1) {
    const char *last = panel->drawings[panel->n - 1]->label;
    ph_buf_puts(out, " from ");
    ph_buf_puts(out, d->label);
    ph_buf_puts(out, " to ");
    ph_buf_puts(out, last ? last + ph_legend_common(panel) : "the last");
  }
  if (panel->profiles_n > 0) {
    ph_buf_puts(out, panel->profiles_n > 1
                         ? "; below, its profiles of curvature"
                         : "; below, its curvature");
    ph_buf_puts(out, " over the arc length");
  }
}

void ph_describe(const struct ph_panel *panels, size_t n, struct ph_buf *out) {
  for (size_t i = 0; i < n && i < PH_DESCRIBE_PANELS; i++) {
    if (panels[i].title[0]) {
      ph_buf_puts(out, panels[i].title);
      ph_buf_puts(out, ": ");
    }
    ph_buf_puts(out, kind_of(panels[i].drawings[0]));
    put_details(&panels[i], out);
    ph_buf_puts(out, ".\n");
  }
  if (n > PH_DESCRIBE_PANELS) {
    put_count(out, n - PH_DESCRIBE_PANELS, "more panel");
    ph_buf_puts(out, ".\n");
  }
}
