/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The matrix of a curve under constraints (see kkt.h). */
#include "check/kkt.h"

#include <math.h>
#include <string.h>

/* The place of chi; the unknowns of a segment, and it. */
enum { CHI = 0, LOCAL_MAX = 13 };

/* No group of rows. */
#define NONE UINT32_MAX

/* ---- places ------------------------------------------------------------ */

/* Rows of an interval or of a knot, and the nodes that they are about. */
struct group {
  size_t row, rows;
  size_t node, nodes;
};

static size_t groups_of(const struct ph_spinor *s) {
  return s->rows.n + (s->rows.knot_rows > 0 ? s->rows.n + 1 : 0);
}

static struct group group_of(const struct ph_spinor *s, size_t i) {
  size_t n = s->rows.n, rows = ph_spinor_interval_rows(s), knot = i - n;
  struct group of_interval = {i * rows, rows, i * s->rows.refine,
                              s->rows.refine + 2};
  struct group of_knot = {n * rows + knot * s->rows.knot_rows,
                          s->rows.knot_rows, knot * s->rows.refine, 2};
  return i < n ? of_interval : of_knot;
}

/* When a node is placed. */
static size_t turn_of(const struct ph_kkt *kkt, size_t node) {
  size_t j = ph_kkt_stored(kkt, node), n = kkt->spline.stored;
  if (!ph_kkt_has_chi(kkt)) {
    return j;
  }
  return 2 * j < n ? 2 * j : 2 * (n - 1 - j) + 1;
}

/* The node that is placed then. */
static size_t node_at(const struct ph_kkt *kkt, size_t turn) {
  if (!ph_kkt_has_chi(kkt)) {
    return turn;
  }
  return turn % 2 == 0 ? turn / 2 : kkt->spline.stored - 1 - turn / 2;
}

/* All places: rows follow the last of their nodes, so that the leading parts of
 * the matrix are problems of their own. */
static void place_all(struct ph_kkt *kkt, uint32_t *first, uint32_t *next) {
  const struct ph_spinor *s = &kkt->spline;
  size_t groups = groups_of(s);
  for (size_t t = 0; t < s->stored; t++) {
    first[t] = NONE;
  }
  for (size_t i = 0; i < groups; i++) {
    struct group g = group_of(s, i);
    size_t last = 0;
    for (size_t a = 0; a < g.nodes; a++) {
      size_t turn = turn_of(kkt, g.node + a);
      last = turn > last ? turn : last;
    }
    next[i] = first[last];
    first[last] = (uint32_t)i;
  }
  kkt->n = ph_kkt_has_chi(kkt) ? CHI + 1 : 0;
  for (size_t t = 0; t < s->stored; t++) {
    kkt->node[node_at(kkt, t)] = (uint32_t)kkt->n;
    kkt->n += 4;
    for (size_t i = first[t]; i != NONE; i = next[i]) {
      struct group g = group_of(s, i);
      for (size_t k = 0; k < g.rows; k++) {
        kkt->is_row[kkt->n] = true;
        kkt->row[g.row + k] = (uint32_t)kkt->n++;
      }
    }
  }
}

static bool set_places(struct ph_kkt *kkt, struct ph_arena *arena) {
  const struct ph_spinor *s = &kkt->spline;
  size_t places = 4 * s->stored + kkt->rows + 1;
  uint32_t *first = ph_arena_array(arena, s->stored, sizeof *first);
  uint32_t *next = ph_arena_array(arena, groups_of(s), sizeof *next);
  kkt->node = ph_arena_array(arena, s->stored, sizeof *kkt->node);
  kkt->row = ph_arena_array(arena, kkt->rows, sizeof *kkt->row);
  kkt->is_row = ph_arena_array(arena, places, sizeof *kkt->is_row);
  if (!first || !next || !kkt->node || !kkt->row || !kkt->is_row) {
    return false;
  }
  memset(kkt->is_row, 0, places * sizeof *kkt->is_row);
  place_all(kkt, first, next);
  return true;
}

/* ---- elements ---------------------------------------------------------- */

/* The unknowns of an element: components of its nodes and, where some of these
 * are beyond the seam, chi; and how they move the nodes. */
struct local {
  struct ph_spinor_element e;
  size_t n;
  size_t place[LOCAL_MAX];
  ph_quat by[LOCAL_MAX]; /* of a component: its node */
  ph_quat turned[3];     /* of chi: each node, w i beyond the seam, else 0 */
  bool wraps[3];
};

static ph_quat turned_of(ph_quat a) {
  return ph_quat_turn(a, ph_cplx_of(0, 1));
}

static void local_of(const struct ph_kkt *kkt, size_t element,
                     struct local *l) {
  static const ph_quat unit[4] = {
      {1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}};
  const struct ph_spinor *s = &kkt->spline;
  bool wraps = false;
  l->e = ph_spinor_element_of(s, element);
  l->n = 4 * l->e.nodes;
  for (size_t a = 0; a < l->e.nodes; a++) {
    size_t node = l->e.first + a;
    l->wraps[a] = node >= s->stored;
    l->turned[a] = l->wraps[a] ? turned_of(s->w[node]) : ph_quat_of(0, 0, 0, 0);
    wraps = wraps || l->wraps[a];
    for (size_t i = 0; i < 4; i++) {
      l->place[4 * a + i] = kkt->node[ph_kkt_stored(kkt, node)] + i;
      l->by[4 * a + i] = l->wraps[a] ? ph_quat_turn(unit[i], s->seam) : unit[i];
    }
  }
  if (wraps) {
    l->place[l->n++] = CHI;
  }
}

/* The derivative by unknown q, from those by the nodes. */
static double along(const struct local *l, size_t q,
                    const ph_quat gradient[3]) {
  double sum = 0;
  if (q < 4 * l->e.nodes) {
    return ph_quat_dot(gradient[q / 4], l->by[q]);
  }
  for (size_t a = 0; a < l->e.nodes; a++) {
    sum += ph_quat_dot(gradient[a], l->turned[a]);
  }
  return sum;
}

/* The sum of the forms of an element, times their y. */
static struct ph_spinor_form weighted(const struct ph_kkt *kkt,
                                      const struct ph_spinor_element *e) {
  struct ph_spinor_form sum = {0, {0, 0, 0}};
  for (size_t i = 0; i < e->rows; i++) {
    double y = kkt->y[kkt->row[e->row + i]];
    sum.s += y * e->form[i].s;
    sum.v = ph_vec3_along(sum.v, y, e->form[i].v);
  }
  return sum;
}

/* Gradients of F by the nodes. */
static void gradient_of_f(const struct ph_spinor *s,
                          const struct ph_spinor_element *e,
                          ph_quat gradient[3]) {
  ph_quat second = ph_spinor_second(s, e);
  for (size_t a = 0; a < e->nodes; a++) {
    gradient[a] = ph_quat_scale(2 * e->second[a], second);
  }
}

/* Gradients of a form by the nodes. */
static void gradient_of_form(const struct ph_spinor *s,
                             const struct ph_spinor_element *e,
                             struct ph_spinor_form form, ph_quat gradient[3]) {
  for (size_t a = 0; a < e->nodes; a++) {
    gradient[a] =
        ph_quat_scale(2, ph_spinor_gradient(form, ph_spinor_product(s, e, a)));
  }
}

/* ---- the matrix -------------------------------------------------------- */

static void widen(struct ph_kkt *kkt, size_t i, size_t j) {
  size_t apart = i < j ? j - i : i - j;
  kkt->band = apart > kkt->band ? apart : kkt->band;
}

static void set_band(struct ph_kkt *kkt) {
  kkt->band = 0;
  for (size_t k = 0; k < ph_spinor_elements(&kkt->spline); k++) {
    struct local l;
    local_of(kkt, k, &l);
    for (size_t q = 0; q < l.n; q++) {
      for (size_t p = 0; p < q; p++) {
        widen(kkt, l.place[p], l.place[q]);
      }
      for (size_t i = 0; i < l.e.rows; i++) {
        widen(kkt, kkt->row[l.e.row + i], l.place[q]);
      }
    }
  }
}

static void add_gradients(struct ph_kkt *kkt) {
  for (size_t k = 0; k < ph_spinor_elements(&kkt->spline); k++) {
    struct local l;
    ph_quat gradient[3];
    local_of(kkt, k, &l);
    gradient_of_f(&kkt->spline, &l.e, gradient);
    for (size_t q = 0; q < l.n; q++) {
      kkt->g[l.place[q]] += along(&l, q, gradient);
    }
    for (size_t i = 0; i < l.e.rows; i++) {
      size_t row = kkt->row[l.e.row + i];
      gradient_of_form(&kkt->spline, &l.e, l.e.form[i], gradient);
      for (size_t q = 0; q < l.n; q++) {
        *ph_kkt_at(kkt, row, l.place[q]) += along(&l, q, gradient);
      }
    }
  }
}

static double *zeros(struct ph_arena *arena, size_t n) {
  double *v = ph_arena_array(arena, n, sizeof *v);
  if (v) {
    memset(v, 0, n * sizeof *v);
  }
  return v;
}

bool ph_kkt_of(struct ph_kkt *kkt, struct ph_arena *arena) {
  kkt->rows = ph_spinor_rows_n(&kkt->spline);
  if (!set_places(kkt, arena)) {
    return false;
  }
  set_band(kkt);
  kkt->matrix = zeros(arena, ph_sym_size(kkt->n, kkt->band));
  kkt->g = zeros(arena, kkt->n);
  kkt->y = zeros(arena, kkt->n);
  if (!kkt->matrix || !kkt->g || !kkt->y) {
    return false;
  }
  add_gradients(kkt);
  return true;
}

/* The block of the Hessian by nodes a and b, applied to a change of b. */
static ph_quat block(const struct ph_spinor_element *e,
                     struct ph_spinor_form form, size_t a, size_t b,
                     ph_quat change) {
  return ph_quat_add(
      ph_quat_scale(2 * e->gram[a][b], ph_spinor_gradient(form, change)),
      ph_quat_scale(2 * e->second[a] * e->second[b], change));
}

/* The Hessian by chi and everything else of an element.  Nodes beyond the seam
 * turn with chi: d^2 w = v i dv dchi - w dchi^2, so that gradients count. */
static void add_chi(struct ph_kkt *kkt, const struct local *l,
                    struct ph_spinor_form form) {
  ph_quat by_f[3], by_form[3];
  double own = 0;
  gradient_of_f(&kkt->spline, &l->e, by_f);
  gradient_of_form(&kkt->spline, &l->e, form, by_form);
  for (size_t a = 0; a < l->e.nodes; a++) {
    ph_quat gradient = ph_quat_add(by_f[a], by_form[a]);
    ph_quat column = {0, 0, 0, 0};
    for (size_t b = 0; b < l->e.nodes; b++) {
      column = ph_quat_add(column, block(&l->e, form, a, b, l->turned[b]));
    }
    own += ph_quat_dot(column, l->turned[a]);
    if (l->wraps[a]) {
      /* <v i, gradient> = -<v, gradient i> */
      column = ph_quat_sub(column, turned_of(gradient));
      own -= ph_quat_dot(kkt->spline.w[l->e.first + a], gradient);
    }
    for (size_t i = 0; i < 4; i++) {
      *ph_kkt_at(kkt, CHI, l->place[4 * a + i]) +=
          ph_quat_dot(column, l->by[4 * a + i]);
    }
  }
  *ph_kkt_at(kkt, CHI, CHI) += own;
}

void ph_kkt_add_hessian(struct ph_kkt *kkt) {
  for (size_t k = 0; k < ph_spinor_elements(&kkt->spline); k++) {
    struct local l;
    struct ph_spinor_form form;
    local_of(kkt, k, &l);
    form = weighted(kkt, &l.e);
    for (size_t q = 0; q < 4 * l.e.nodes; q++) {
      for (size_t a = 0; a <= q / 4; a++) {
        ph_quat column = block(&l.e, form, a, q / 4, l.by[q]);
        for (size_t p = 4 * a; p < 4 * a + 4 && p <= q; p++) {
          *ph_kkt_at(kkt, l.place[p], l.place[q]) +=
              ph_quat_dot(column, l.by[p]);
        }
      }
    }
    if (l.n > 4 * l.e.nodes) {
      add_chi(kkt, &l, form);
    }
  }
}
