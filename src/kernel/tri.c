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
  return t->pivot && t->far;
}

void ph_tri_begin(struct ph_tri *t, size_t n, struct ph_tri_row first,
                  struct ph_tri_row last) {
  const ph_cplx zero = {0, 0};
  t->n = n;
  t->k = 0;
  t->stop = n > TAIL ? n - TAIL : 0;
  t->far_n = 0;
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

/* A row of three columns in the shape of an active one; c2 is apart. */
static struct ph_tri_active active_of(const struct ph_tri_row *row) {
  struct ph_tri_active a = {row->lo, row->di, {0, 0}, {0, 0}, row->f};
  return a;
}

/*
 * Subtracts the multiple of the pivot row that clears column k, and moves the
 * window one column on.  c2 is the entry of `a` in column k+2, if any.
 */
static struct ph_tri_active eliminate(const struct ph_tri_active *a, ph_cplx c2,
                                      const struct ph_tri_pivot *p,
                                      const ph_cplx *far) {
  ph_cplx m = ph_cplx_mul(a->c0, p->inverse);
  struct ph_tri_active r;
  r.c0 = ph_cplx_sub(a->c1, ph_cplx_mul(m, p->c1));
  r.c1 = ph_cplx_sub(c2, ph_cplx_mul(m, p->c2));
  r.e = ph_cplx_sub(a->e, ph_cplx_mul(m, far[0]));
  r.l = ph_cplx_sub(a->l, ph_cplx_mul(m, far[1]));
  r.f = ph_cplx_sub(a->f, ph_cplx_mul(m, p->f));
  return r;
}

static void set_pivot(struct ph_tri *t, const struct ph_tri_active *a,
                      ph_cplx c2) {
  struct ph_tri_pivot *p = &t->pivot[t->k];
  p->inverse = ph_cplx_inverse(a->c0);
  p->c1 = a->c1;
  p->c2 = c2;
  p->f = a->f;
  t->far[2 * t->k] = a->e;
  t->far[2 * t->k + 1] = a->l;
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

void ph_tri_push_far(struct ph_tri *t, const struct ph_tri_row *row) {
  const ph_cplx zero = {0, 0};
  struct ph_tri_active fresh = active_of(row);
  const struct ph_tri_pivot *p = &t->pivot[t->k];
  const ph_cplx *far = &t->far[2 * t->k];
  double near2 = ph_cplx_norm2(t->near.c0);
  double last2 = ph_cplx_norm2(t->last.c0);
  double row2 = ph_cplx_norm2(row->lo);
  if (near2 >= row2 && near2 >= last2) {
    set_pivot(t, &t->near, zero);
    t->near = eliminate(&fresh, row->up, p, far);
    t->last = eliminate(&t->last, zero, p, far);
  } else if (row2 >= last2) {
    set_pivot(t, &fresh, row->up);
    t->near = eliminate(&t->near, zero, p, far);
    t->last = eliminate(&t->last, zero, p, far);
  } else {
    struct ph_tri_active near = t->near;
    set_pivot(t, &t->last, zero);
    t->near = eliminate(&fresh, row->up, p, far);
    t->last = eliminate(&near, zero, p, far);
  }
  t->k++;
  t->far_n = t->k;
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

void ph_tri_finish(struct ph_tri *t, ph_cplx *x) {
  ph_cplx a[TAIL][TAIL + 1];
  ph_cplx e, l;
  gather_tail(t, a);
  solve_tail(a, t->n - t->stop, x + t->stop);
  e = x[t->n - 2];
  l = x[t->n - 1];
  for (size_t k = t->stop; k-- > 0;) {
    const struct ph_tri_pivot *p = &t->pivot[k];
    ph_cplx sum = ph_cplx_sub(p->f, ph_cplx_mul(p->c2, x[k + 2]));
    if (k < t->far_n) {
      sum = ph_cplx_sub(sum, ph_cplx_mul(t->far[2 * k], e));
      sum = ph_cplx_sub(sum, ph_cplx_mul(t->far[2 * k + 1], l));
    }
    sum = ph_cplx_sub(sum, ph_cplx_mul(p->c1, x[k + 1]));
    x[k] = ph_cplx_mul(sum, p->inverse);
  }
}
