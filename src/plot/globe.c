/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Spheres (see globe.h). */
#include "plot/globe.h"

#include "kernel/pi.h"
#include "plot/trace.h"

#include <math.h>
#include <string.h>

/* A curve within this of the middle is seen from nearer. */
#define NEAR 0.45
/* ... unless it is a point. */
#define POINT 1e-9

/* Hidden deeper than this, a curve needs a second view. */
#define DEEP 0.05

/* ---- views --------------------------------------------------------------- */

/* Sum over the curves of chords times their middles; of the hidden ones only,
 * if a view is given. */
static ph_vec3 sum_of(const struct ph_panel *panel,
                      const struct ph_view *hidden) {
  ph_vec3 sum = {0, 0, 0};
  for (size_t i = 0; i < panel->n; i++) {
    const struct ph_drawing *d = panel->drawings[i];
    for (size_t j = 0; j < d->strokes_n; j++) {
      const struct ph_stroke *s = &d->strokes[j];
      for (size_t k = 1; s->role == PH_STROKE_CURVE && k < s->n; k++) {
        ph_vec3 a = ph_unit_in(&panel->unit, s->points[k - 1]);
        ph_vec3 b = ph_unit_in(&panel->unit, s->points[k]);
        double chord = ph_vec3_abs(ph_vec3_sub(b, a));
        if (isfinite(chord) &&
            (!hidden || ph_view_see(hidden, a).depth < -DEEP)) {
          sum = ph_vec3_along(sum, 0.5 * chord, ph_vec3_add(a, b));
        }
      }
    }
  }
  return sum;
}

static double length_of(const struct ph_panel *panel) {
  double sum = 0;
  for (size_t i = 0; i < panel->n; i++) {
    sum += panel->drawings[i]->length / panel->unit.size;
  }
  return sum > 0 ? sum : 1;
}

/* To multiples of 5 degrees, which can be said in the figure. */
static ph_vec3 rounded(ph_vec3 d) {
  const double unit = 5 * PH_PI / 180;
  double lon = unit * round(atan2(d.y, d.x) / unit);
  double lat = unit * round(atan2(d.z, hypot(d.x, d.y)) / unit);
  return ph_vec3_of(cos(lat) * cos(lon), cos(lat) * sin(lon), sin(lat));
}

size_t ph_globe_views(const struct ph_panel *panel, struct ph_view views[2]) {
  ph_vec3 sum = sum_of(panel, NULL), behind;
  if (!(ph_vec3_abs(sum) > 0.1 * length_of(panel))) {
    sum = ph_vec3_of(0.75, 0.43, 0.5); /* all around, or a single point */
    if (panel->drawings[0]->data_n > 0 && panel->drawings[0]->length <= 0) {
      sum = ph_unit_in(&panel->unit, panel->drawings[0]->data[0]);
    }
  }
  if (!(ph_vec3_abs(sum) > 0 && isfinite(ph_vec3_abs(sum)))) {
    sum = ph_vec3_of(1, 0, 0);
  }
  views[0] = ph_view_from(rounded(sum));
  behind = sum_of(panel, &views[0]);
  if (!(ph_vec3_abs(behind) > 0)) {
    return 1;
  }
  views[1] = ph_view_from(ph_vec3_abs(behind) > 1e-3 * length_of(panel)
                              ? rounded(behind)
                              : views[0].right);
  return 2;
}

/* ---- reach --------------------------------------------------------------- */

static void extend(double low[2], double high[2], struct ph_seen seen) {
  if (isfinite(seen.u) && isfinite(seen.v)) {
    low[0] = fmin(low[0], seen.u);
    low[1] = fmin(low[1], seen.v);
    high[0] = fmax(high[0], seen.u);
    high[1] = fmax(high[1], seen.v);
  }
}

double ph_globe_reach(const struct ph_panel *panel, const struct ph_view *view,
                      struct ph_seen *middle) {
  double low[2] = {2, 2}, high[2] = {-2, -2}, reach;
  for (size_t i = 0; i < panel->n; i++) {
    const struct ph_drawing *d = panel->drawings[i];
    for (size_t j = 0; j < d->strokes_n; j++) {
      for (size_t k = 0; k < d->strokes[j].n; k++) {
        ph_vec3 p = ph_unit_in(&panel->unit, d->strokes[j].points[k]);
        extend(low, high, ph_view_see(view, p));
      }
    }
    for (size_t k = 0; k < d->data_n; k++) {
      ph_vec3 p = ph_unit_in(&panel->unit, d->data[k]);
      extend(low, high, ph_view_see(view, p));
    }
  }
  middle->u = 0.5 * (low[0] + high[0]);
  middle->v = 0.5 * (low[1] + high[1]);
  middle->depth = 0;
  reach = 0.5 * fmax(high[0] - low[0], high[1] - low[1]);
  if (!(reach > POINT && reach < NEAR && panel->views_n < 2)) {
    middle->u = middle->v = 0;
    return 1;
  }
  return 1.25 * reach;
}

double ph_globe_step(double reach) {
  static const double steps[] = {30, 10, 5, 2, 1, 0.5, 0.2, 0.1, 0.05, 0.02};
  size_t i = 0;
  while (i + 1 < sizeof steps / sizeof steps[0] && reach < 1 &&
         steps[i] * PH_PI / 180 > 0.6 * reach) {
    i++;
  }
  return steps[i];
}

/* ---- caption ------------------------------------------------------------- */

static size_t put(char *text, size_t n, const char *more) {
  size_t m = strlen(more);
  memcpy(text + n, more, m + 1);
  return n + m;
}

/* Whole degrees: at most three digits. */
static size_t put_degrees(char *text, size_t n, double angle) {
  int k = (int)lround(fabs(angle) * 180 / PH_PI);
  char digits[4] = {(char)('0' + k / 100), (char)('0' + k / 10 % 10),
                    (char)('0' + k % 10), '\0'};
  if (angle < 0 && k > 0) {
    n = put(text, n, "\xE2\x88\x92");
  }
  n = put(text, n, digits + (k < 100) + (k < 10));
  return put(text, n, "\xC2\xB0");
}

void ph_globe_caption(const struct ph_view *view,
                      char text[PH_GLOBE_CAPTION_MAX]) {
  const ph_vec3 d = view->toward;
  size_t n = put(text, 0, "from longitude ");
  bool pole = hypot(d.x, d.y) < 1e-9;
  n = put_degrees(text, n, pole ? 0 : atan2(d.y, d.x));
  n = put(text, n, ", latitude ");
  put_degrees(text, n, atan2(d.z, hypot(d.x, d.y)));
}

/* ---- drawing ------------------------------------------------------------- */

enum { LINE_POINTS = 121 };

static ph_vec3 place(double lon, double lat) {
  const double degree = PH_PI / 180;
  return ph_vec3_of(cos(lat * degree) * cos(lon * degree),
                    cos(lat * degree) * sin(lon * degree), sin(lat * degree));
}

/* From one place to another along the grid, the shorter lines the finer. */
static void grid_line(const struct ph_look *look, double lon0, double lat0,
                      double lon1, double lat1) {
  ph_vec3 line[LINE_POINTS];
  for (int i = 0; i < LINE_POINTS; i++) {
    double t = i / (double)(LINE_POINTS - 1);
    line[i] = place(lon0 + t * (lon1 - lon0), lat0 + t * (lat1 - lat0));
  }
  ph_strokes_line(look, PH_SIDE_VISIBLE, line, LINE_POINTS);
}

/* A multiple of the step, so that there are not too many lines. */
static double coarser(double step, double range) {
  for (int i = 0; i < 12 && range > 40 * step; i++) {
    step *= 2;
  }
  return fmin(step, 30);
}

/* The grid of a window on part of the sphere, or of all of it. */
static void graticule(const struct ph_look *look, double reach) {
  const double degree = PH_PI / 180;
  double step = ph_globe_step(reach), u = look->window.u, v = look->window.v;
  double depth = sqrt(fmax(0, 1 - u * u - v * v));
  ph_vec3 m =
      ph_vec3_along(ph_vec3_scale(u, look->view.right), v, look->view.up);
  double lon, lat, more = asin(fmin(1, 1.5 * reach)) / degree, wide, low, high;
  m = ph_vec3_along(m, depth, look->view.toward);
  lon = atan2(m.y, m.x) / degree;
  lat = atan2(m.z, hypot(m.x, m.y)) / degree;
  low = reach < 1 ? fmax(-90, lat - 2 * more) : -90;
  high = reach < 1 ? fmin(90, lat + 2 * more) : 90;
  wide = cos(fmin(90, fabs(lat) + more) * degree);
  wide = reach < 1 && wide > 0.05 ? fmin(180, 2 * more / wide) : 180;
  if (step < 0.6 * reach / degree || reach >= 1) {
    double each = coarser(step, 2 * wide);
    double first = each * ceil((lon - wide) / each);
    for (int i = 0; i < 40 && first + i * each < lon + wide; i++) {
      grid_line(look, first + i * each, low, first + i * each, high);
    }
    first = step * ceil(low / step);
    for (int i = 0; i < 40 && first + i * step <= high; i++) {
      if (fabs(first + i * step) < 90 - 0.5 * step) {
        grid_line(look, lon - wide, first + i * step, lon + wide,
                  first + i * step);
      }
    }
  }
}

void ph_globe_draw(const struct ph_look *look, double reach) {
  struct ph_trace trace;
  ph_page_pen(look->page, ph_ink(PH_INK_GRATICULE), 0.05 * look->em, 0);
  graticule(look, reach);
  ph_page_pen(look->page, ph_ink(PH_INK_OUTLINE), 0.07 * look->em, 0);
  ph_trace_begin(&trace, look->page, &look->window.rect);
  for (int i = 0; i <= 360; i++) {
    struct ph_seen seen = {cos(i * PH_PI / 180), sin(i * PH_PI / 180), 0};
    ph_trace_to(&trace, ph_window_spot(&look->window, seen));
  }
  ph_trace_end(&trace);
}
