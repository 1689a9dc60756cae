/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Cyclic tridiagonal elimination (method in tri.h): the steps in which a
 * corner entry takes part, the dense tail, and back substitution.
 */
#include "kernel/tri.h"

enum { TAIL = 4 };

/* Squared: entries below 1e-32 of a neighbouring diagonal entry are dropped.
 * 1e-32 is eps^2: even rows whose scales differ by 1e16 do not feel it. */
static const double NEGLIGIBLE = 1e-64;

bool ph_tri_alloc(struct ph_tri *t, struct ph_arena *arena, size_t n) {
  t->pivot = ph_arena_array(arena, n, sizeof *t->pivot);
  t->far = ph_arena_array(arena, n, 2 * sizeof *t->far);
  t->fill = ph_arena_array(arena, n, sizeof *t->fill);
  return t->pivot && t->far && t->fill;
}

void ph_tri_begin(struct ph_tri *t, size_t n, struct ph_tri_row first,
                  struct ph_tri_row last) {
  const ph_cplx zero = {0, 0};
  t->n = n;
  t->k = 0;
  t->stop = n > TAIL ? n - TAIL : 0;
  t->far_n = 0;
  t->fill_n = 0;
  t->tail_n = 0;
  t->near.c0 = first.di;
  t->near.c1 = first.up;
  t->near.e = zero;
  t->near.l = first.lo;
  t->near.f = first.f;
  t->last.c0 = last.up;
  t->last.c1 = zero;
  t->last.e = last.lo;
  t->last.l = last.di;
  t->last.f = last.f;
  t->near_far = ph_cplx_norm2(first.lo) > 0;
  t->last_far = ph_cplx_norm2(last.up) > 0;
}

/* Makes a row the pivot row k, divided by its entry c0; c2 is the entry in
 * column k+2, if any. */
static struct ph_tri_active
set_pivot(struct ph_tri *t, const struct ph_tri_active *a, ph_cplx *c2) {
  ph_cplx inverse = ph_cplx_inverse(a->c0);
  struct ph_tri_active p = {
      {1, 0},
      ph_cplx_mul(a->c1, inverse),
      ph_cplx_mul(a->e, inverse),
      ph_cplx_mul(a->l, inverse),
      ph_cplx_mul(a->f, inverse),
  };
  t->pivot[t->k].c1 = p.c1;
  t->pivot[t->k].f = p.f;
  if (t->last_far || t->near_far) {
    for (; t->far_n < t->k; t->far_n++) { /* alive again, as NaN is */
      t->far[2 * t->far_n] = t->far[2 * t->far_n + 1] = ph_cplx_of(0, 0);
    }
    t->far[2 * t->k] = p.e;
    t->far[2 * t->k + 1] = p.l;
    t->far_n = t->k + 1;
  }
  *c2 = ph_cplx_mul(*c2, inverse);
  if (ph_cplx_norm2(*c2) > 0) {
    t->fill[t->fill_n].k = t->k;
    t->fill[t->fill_n].c2 = *c2;
    t->fill_n++;
  }
  return p;
}

/*
 * Subtracts the multiple of the pivot row that clears column k, and moves the
 * window one column on.  a2 and p2 are the entries in column k+2.
 */
static struct ph_tri_active eliminate(const struct ph_tri_active *a, ph_cplx a2,
                                      const struct ph_tri_active *p,
                                      ph_cplx p2) {
  ph_cplx m = a->c0;
  struct ph_tri_active r;
  r.c0 = ph_cplx_sub(a->c1, ph_cplx_mul(m, p->c1));
  r.c1 = ph_cplx_sub(a2, ph_cplx_mul(m, p2));
  r.e = ph_cplx_sub(a->e, ph_cplx_mul(m, p->e));
  r.l = ph_cplx_sub(a->l, ph_cplx_mul(m, p->l));
  r.f = ph_cplx_sub(a->f, ph_cplx_mul(m, p->f));
  return r;
}

/* Drops what has decayed, so that later steps need not look at it. */
static void drop_negligible(struct ph_tri *t, double neighbour) {
  const ph_cplx zero = {0, 0};
  double floor = NEGLIGIBLE * neighbour;
  if (ph_cplx_norm2(t->last.c0) + ph_cplx_norm2(t->last.c1) <= floor) {
    t->last.c0 = t->last.c1 = zero;
    t->last_far = false;
  }
  if (ph_cplx_norm2(t->near.e) + ph_cplx_norm2(t->near.l) <= floor) {
    t->near.e = t->near.l = zero;
    t->near_far = false;
  } else {
    t->near_far = true;
  }
}

void ph_tri_push_any(struct ph_tri *t, const struct ph_tri_row *row) {
  const ph_cplx zero = {0, 0};
  struct ph_tri_active fresh = {row->lo, row->di, zero, zero, row->f};
  struct ph_tri_active near = t->near, last = t->last, p;
  ph_cplx c2 = zero;
  double near2 = ph_cplx_norm2(near.c0);
  double last2 = ph_cplx_norm2(last.c0);
  double row2 = ph_cplx_norm2(row->lo);
  if (t->k == t->stop) {
    t->tail[t->tail_n++] = *row;
    return;
  }
  if (near2 >= row2 && near2 >= last2) {
    p = set_pivot(t, &near, &c2);
    t->near = eliminate(&fresh, row->up, &p, c2);
    t->last = eliminate(&last, zero, &p, c2);
  } else if (row2 >= last2) {
    c2 = row->up;
    p = set_pivot(t, &fresh, &c2);
    t->near = eliminate(&near, zero, &p, c2);
    t->last = eliminate(&last, zero, &p, c2);
  } else {
    p = set_pivot(t, &last, &c2);
    t->near = eliminate(&fresh, row->up, &p, c2);
    t->last = eliminate(&near, zero, &p, c2);
  }
  t->k++;
  drop_negligible(t, ph_cplx_norm2(row->di));
}

/* Rows of the dense tail; a[r][m] is the right-hand side. */
static void gather_tail(const struct ph_tri *t, ph_cplx a[TAIL][TAIL + 1]) {
  size_t m = t->n - t->stop;
  const struct ph_tri_active *active[2] = {&t->near, &t->last};
  for (size_t r = 0; r < m; r++) {
    for (size_t c = 0; c <= m; c++) {
      a[r][c] = ph_cplx_of(0, 0);
    }
  }
  for (size_t r = 0; r < 2; r++) {
    a[r][0] = active[r]->c0;
    a[r][1] = active[r]->c1;
    a[r][m - 2] = ph_cplx_add(a[r][m - 2], active[r]->e);
    a[r][m - 1] = ph_cplx_add(a[r][m - 1], active[r]->l);
    a[r][m] = active[r]->f;
  }
  for (size_t r = 2; r < m; r++) {
    a[r][r - 2] = t->tail[r - 2].lo;
    a[r][r - 1] = t->tail[r - 2].di;
    a[r][r] = t->tail[r - 2].up;
    a[r][m] = t->tail[r - 2].f;
  }
}

static void swap_rows(ph_cplx *a, ph_cplx *b, size_t n) {
  for (size_t c = 0; c < n; c++) {
    ph_cplx keep = a[c];
    a[c] = b[c];
    b[c] = keep;
  }
}

static void solve_tail(ph_cplx a[TAIL][TAIL + 1], size_t m, ph_cplx *x) {
  for (size_t k = 0; k < m; k++) {
    size_t best = k;
    ph_cplx inverse;
    for (size_t r = k + 1; r < m; r++) {
      if (ph_cplx_norm2(a[r][k]) > ph_cplx_norm2(a[best][k])) {
        best = r;
      }
    }
    swap_rows(a[k], a[best], m + 1);
    inverse = ph_cplx_inverse(a[k][k]);
    for (size_t r = k + 1; r < m; r++) {
      ph_cplx factor = ph_cplx_mul(a[r][k], inverse);
      for (size_t c = k + 1; c <= m; c++) {
        a[r][c] = ph_cplx_sub(a[r][c], ph_cplx_mul(factor, a[k][c]));
      }
    }
  }
  for (size_t k = m; k-- > 0;) {
    ph_cplx sum = a[k][m];
    for (size_t c = k + 1; c < m; c++) {
      sum = ph_cplx_sub(sum, ph_cplx_mul(a[k][c], x[c]));
    }
    x[k] = ph_cplx_mul(sum, ph_cplx_inverse(a[k][k]));
  }
}

/* Where x[k] stands. */
static inline ph_cplx *place(struct ph_tri *t, ph_cplx *x, size_t k) {
  return x ? &x[k] : &t->pivot[k].f;
}

static inline void finish(struct ph_tri *t, ph_cplx *x) {
  ph_cplx a[TAIL][TAIL + 1], tail[TAIL];
  ph_cplx e, l, next;
  const size_t tail_n = t->n - t->stop;
  size_t fill_n = t->fill_n;
  gather_tail(t, a);
  solve_tail(a, tail_n, tail);
  for (size_t k = 0; k < tail_n; k++) {
    *place(t, x, t->stop + k) = tail[k];
  }
  e = tail[tail_n - 2];
  l = tail[tail_n - 1];
  next = tail[0];
  for (size_t k = t->stop; k-- > 0;) {
    const struct ph_tri_pivot *p = &t->pivot[k];
    ph_cplx sum = p->f;
    if (k < t->far_n) {
      sum = ph_cplx_sub(sum, ph_cplx_mul(t->far[2 * k], e));
      sum = ph_cplx_sub(sum, ph_cplx_mul(t->far[2 * k + 1], l));
    }
    if (fill_n > 0 && t->fill[fill_n - 1].k == k) {
      sum = ph_cplx_sub(sum,
                        ph_cplx_mul(t->fill[--fill_n].c2, *place(t, x, k + 2)));
    }
    next = ph_cplx_sub(sum, ph_cplx_mul(p->c1, next));
    *place(t, x, k) = next;
  }
}

void ph_tri_finish(struct ph_tri *t, ph_cplx *x) {
  finish(t, x);
}

void ph_tri_finish_here(struct ph_tri *t) {
  finish(t, NULL);
}
