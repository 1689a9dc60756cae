/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a surface looks like (see sheet.h). */
#include "plot/sheet.h"

#include "curve/surface/ruling.h"

/* Normals, and rulings laid flat, turn by so much from rib to rib. */
static const double TURN = 0.06;

/* A strip has so many steps, where there is room for them; of the rulings
 * between so many are drawn, of all strips up to the second number. */
enum { STEPS_MIN = 4, STEPS_MAX = 96, SHOWN = 6, SHOWN_ALL = 150, PROBES = 16 };

static ph_vec3 flat_point(const double flat[2]) {
  return ph_vec3_of(flat[0], flat[1], 0);
}

static void add_rib(const struct ph_surface *surface, size_t i, double u,
                    struct ph_rib *rib) {
  const struct ph_strip *strip = &surface->strips[i];
  const struct ph_ruling r = ph_ruling_at(strip, u);
  double flat[2];
  *rib = (struct ph_rib){.strip = i, .contact = r.at.c, .normal = r.at.n};
  for (size_t j = 0; j < 2; j++) {
    const double h = ph_strip_height(surface, strip, surface->height[j], u);
    rib->end[j] = ph_ruling_point(&r, h);
    ph_ruling_flat(&r, h, flat);
    rib->flat[j] = flat_point(flat);
  }
  rib->flat_contact = flat_point(r.flat.c);
}

/* By how much normals, flat rulings and the contact curve turn along a strip.
 */
static double turn_of(const struct ph_strip *strip) {
  struct ph_ruling last = ph_ruling_at(strip, 0);
  ph_vec3 along = {0, 0, 0};
  double turn = 0;
  for (int i = 1; i <= PROBES; i++) {
    const struct ph_ruling next = ph_ruling_at(strip, (double)i / PROBES);
    const ph_vec3 leg = ph_vec3_unit(ph_vec3_sub(next.at.c, last.at.c));
    turn += ph_vec3_abs(ph_vec3_sub(next.at.n, last.at.n)) +
            fabs(next.flat.angle - last.flat.angle) +
            (i > 1 ? ph_vec3_abs(ph_vec3_sub(leg, along)) : 0);
    last = next;
    along = leg;
  }
  return turn < HUGE_VAL ? turn : STEPS_MAX * TURN;
}

/* Steps of strip i of n, of which there may be so many. */
static size_t steps_of(const struct ph_strip *strip, size_t most) {
  const double wanted = ceil(turn_of(strip) / TURN);
  const size_t n = wanted < STEPS_MAX ? (size_t)wanted : STEPS_MAX;
  return n > most ? most : n > STEPS_MIN || most < STEPS_MIN ? n : STEPS_MIN;
}

/* All ribs, where there is an array for them.  ret how many */
static size_t add_ribs(const struct ph_curve *curve, struct ph_rib *to) {
  const size_t n = curve->n, step = ph_sheet_step(n);
  const size_t all = PH_SHEET_RIBS * step / n;
  const size_t most = all > 2 ? all - 1 : 1;
  const size_t few = SHOWN_ALL * step / n;
  const size_t shown = few < SHOWN ? few : SHOWN;
  size_t count = 0;
  for (size_t i = 0; i < n; i += step) {
    const size_t steps = steps_of(&curve->surface.strips[i], most);
    const size_t each = shown ? (steps + shown - 1) / shown : steps;
    for (size_t j = 0; j <= steps; j++, count++) {
      if (to) {
        add_rib(&curve->surface, i, (double)j / (double)steps, &to[count]);
        to[count].joint = j == 0 || j == steps;
        to[count].shown = j % each == 0;
        to[count].last = j == steps && (step == 1 || i + step >= n);
      }
    }
  }
  return count;
}

/* ---- contact elements ---------------------------------------------------- */

static void add_element(const struct ph_strip *strip, size_t end,
                        struct ph_element *to) {
  const struct ph_ruling r = ph_ruling_at(strip, (double)end);
  const double x = cos(r.flat.angle), y = sin(r.flat.angle);
  double flat[2];
  to->point = ph_ruling_point(&r, -strip->shift[end]);
  to->ruling = r.at.e;
  to->tangent = r.at.d;
  ph_ruling_flat(&r, -strip->shift[end], flat);
  to->flat = flat_point(flat);
  to->flat_tangent = ph_vec3_of(x, y, 0);
  to->flat_ruling = ph_vec3_of(-y, x, 0);
}

/* At the start of each pair, and at the end. */
static void add_elements(const struct ph_curve *curve, struct ph_sheet *sheet) {
  const struct ph_strip *strips = curve->surface.strips;
  for (size_t i = 0; i < curve->n; i++) {
    if (i == 0 || strips[i].pair != strips[i - 1].pair) {
      add_element(&strips[i], 0, &sheet->elements[sheet->elements_n++]);
    }
  }
  if (!curve->closed) {
    add_element(&strips[curve->n - 1], 1,
                &sheet->elements[sheet->elements_n++]);
  }
}

enum ph_status ph_sheet_make(const struct ph_curve *curve,
                             struct ph_arena *arena, struct ph_sheet *sheet,
                             struct ph_diag *diag) {
  *sheet = (struct ph_sheet){.bare = ph_surface_bare(curve->surface.height)};
  sheet->ribs =
      ph_arena_array(arena, add_ribs(curve, NULL), sizeof *sheet->ribs);
  if (!sheet->ribs) {
    return ph_fail_memory(diag);
  }
  sheet->ribs_n = add_ribs(curve, sheet->ribs);
  if (curve->n <= PH_SHEET_STRIPS) {
    sheet->elements =
        ph_arena_array(arena, curve->n + 1, sizeof *sheet->elements);
    if (!sheet->elements) {
      return ph_fail_memory(diag);
    }
    add_elements(curve, sheet);
  }
  return PH_OK;
}
